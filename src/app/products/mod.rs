//! What the page `Products` multiplies: part of the document, so that undo reaches it.

mod known_lines;
mod link_words;
mod modelled_light;
pub mod two_lights;

use std::sync::Arc;

use super::{entry::Entry, library::Library, recipe::Times};
use crate::spectrum::{Band, bounces, glass};

pub use known_lines::KnownLines;
pub use modelled_light::ModelledLight;

/// Most factors in one chain.
pub const MOST_LINKS: usize = 16;
/// Thicknesses of a glass that may be asked for, as multiples of the measured one.
pub const THICKNESSES: std::ops::RangeInclusive<f64> = 0.0..=20.0;
/// Most factors of one chain, each bounce counted.
pub const MOST_FACTORS: u32 = 64;
/// Bounces off one surface, or passes through one filter.
pub const BOUNCES: std::ops::RangeInclusive<u32> = 1..=16;

/// One factor of the chain: a filter, a glass or a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Its spectrum of shares.
    pub entry: Arc<Entry>,
    /// Thickness as a multiple of the measured one (Beer-Lambert); 1 is as measured.
    pub thickness: f64,
    /// How many times in a row it is met.
    pub bounces: u32,
}

impl Link {
    /// A factor as measured, met once.
    pub fn once(entry: Arc<Entry>) -> Self {
        Self::new(entry, Times::default())
    }

    /// A factor as it is met.
    pub fn new(entry: Arc<Entry>, times: Times) -> Self {
        let Times { thickness, bounces } = times;
        Self {
            entry,
            thickness,
            bounces,
        }
    }

    /// How it is met.
    pub fn times(&self) -> Times {
        Times {
            thickness: self.thickness,
            bounces: self.bounces,
        }
    }

    /// Its shares on a band's grid when it is met once, thickness applied.
    pub fn once_on_band(&self, band: Band) -> Vec<f64> {
        let values = self.entry.on_band(band);
        if self.thickness == 1.0 {
            return values;
        }
        glass(&values, self.thickness)
    }

    /// Its shares on a band's grid, thickness and bounces applied: what it is as measured. A model
    /// meets it once after the other.
    pub fn on_band(&self, band: Band) -> Vec<f64> {
        let once = self.once_on_band(band);
        if self.bounces == 1 {
            return once;
        }
        bounces(&once, self.bounces)
    }

    fn clamped(self) -> Self {
        // Only what light passes through has one.
        let thickness = match self.thickness {
            ratio if self.has_thickness() && !ratio.is_nan() => ratio,
            _ => 1.0,
        };
        Self {
            thickness: thickness.clamp(*THICKNESSES.start(), *THICKNESSES.end()),
            bounces: self.bounces.clamp(*BOUNCES.start(), *BOUNCES.end()),
            ..self
        }
    }
}

/// Everything that the page `Products` has chosen from the library.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Products {
    /// What the light passes or falls on, in its order.
    pub chain: Vec<Link>,
    /// The surface of the reflection check, and of the bounces.
    pub surface: Option<Arc<Entry>>,
    /// The spectrum that may have come from it.
    pub outgoing: Option<Arc<Entry>>,
}

/// The chain that a fresh document shows, as something to change.
const FIRST_CHAIN: [&str; 2] = [
    "filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm",
    "colorchecker_ohta/light skin",
];
/// The surface looked at first.
const FIRST_SURFACE: &str = "colorchecker_ohta/red";

impl Products {
    /// What a fresh document starts with.
    pub fn first() -> Self {
        let find = |key: &str| {
            let preset = Library::bundled().find(key).ok()?;
            Entry::of_preset(preset).map(Arc::new)
        };
        Self {
            chain: FIRST_CHAIN
                .iter()
                .filter_map(|key| find(key).map(Link::once))
                .collect(),
            surface: find(FIRST_SURFACE),
            outgoing: None,
        }
    }

    /// Every value moved to the nearest one that is allowed, and only what can be multiplied.
    #[must_use]
    pub fn clamped(self) -> Self {
        let is_factor = |entry: &Arc<Entry>| entry.kind().is_factor();
        let is_light = |entry: &Arc<Entry>| entry.kind() == crate::spectrum::Kind::Light;
        let links = self.chain.into_iter().filter(|link| is_factor(&link.entry));
        let mut left = MOST_FACTORS;
        let within = |link: Link| {
            let link = link.clamped();
            let bounces = link.bounces.min(left.max(1));
            left = left.saturating_sub(bounces);
            Link { bounces, ..link }
        };
        Self {
            chain: links.take(MOST_LINKS).map(within).collect(),
            surface: self.surface.filter(is_factor),
            outgoing: self.outgoing.filter(is_light),
        }
    }

    /// Every entry that is held, to change it.
    pub fn entries_mut(&mut self) -> impl Iterator<Item = &mut Arc<Entry>> {
        let Self {
            chain,
            surface,
            outgoing,
        } = self;
        let links = chain.iter_mut().map(|link| &mut link.entry);
        links.chain(surface).chain(outgoing)
    }

    /// Lets go of an entry that left the library.
    pub fn forget(&mut self, key: &str) {
        let Self {
            chain,
            surface,
            outgoing,
        } = self;
        chain.retain(|link| link.entry.key != key);
        for held in [surface, outgoing] {
            held.take_if(|entry| entry.key == key);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fresh_document_has_something_to_multiply() {
        let first = Products::first();
        assert_eq!(first.chain.len(), FIRST_CHAIN.len());
        assert!(first.surface.is_some());
        assert_eq!(first, first.clone().clamped());
    }

    #[test]
    fn twice_the_glass_is_two_of_it_and_two_bounces_are_twice_one() {
        let mut link = Products::first().chain[0].clone();
        let band = Band::VISIBLE;
        let once = link.on_band(band);
        link.thickness = 2.0;
        let thick = link.on_band(band);
        link.thickness = 1.0;
        link.bounces = 2;
        for ((o, t), b) in once.iter().zip(&thick).zip(link.on_band(band)) {
            // Internal transmittances are not negative here, so both are the square.
            approx::assert_relative_eq!(o * o, *t, max_relative = 1e-12, epsilon = 1e-300);
            approx::assert_relative_eq!(o * o, b, max_relative = 1e-12, epsilon = 1e-300);
        }
    }

    #[test]
    fn nonsense_in_a_chain_becomes_something_allowed() {
        let mut products = Products::first();
        products.chain[0].thickness = f64::NAN;
        products.chain[1].bounces = 0;
        products.outgoing = products.surface.clone();
        let sound = products.clamped();
        assert_eq!((sound.chain[0].thickness, sound.chain[1].bounces), (1.0, 1));
        assert!(sound.outgoing.is_none());
    }
}
