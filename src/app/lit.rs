//! Surfaces under two lights as a screen shows them, each half as an eye used to its light sees it.

use super::{
    cells::{line, number, words},
    document::Document,
    entry::Entry,
    studies::Patches,
};
use crate::{
    color::{Adaptation, Observer, Swatch, quality::hue_of},
    spectrum::Band,
    study::products::{TwoLights, two_lights},
};

/// A surface under two lights.
#[derive(Clone, Debug, PartialEq)]
pub struct Lit {
    /// What it is called.
    pub name: String,
    /// Its colours under the first and under the second light.
    pub swatches: [Swatch; 2],
    /// CIEDE2000 between the two, each beside its own white.
    pub delta_e_2000: f64,
    /// The hue bin of TM-30 that it has under the second light, 0-15; `None` for a grey.
    pub hue: Option<usize>,
}

/// Named reflectances on a band's grid.
pub(super) type Surfaces = (Vec<String>, Vec<Vec<f64>>);

/// How surfaces are looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Eye {
    pub band: Band,
    pub observer: Observer,
    pub adaptation: Adaptation,
}

impl Eye {
    /// Surfaces under two lights on the band's grid; `None` where one of the lights is not seen.
    pub(super) fn under(
        self,
        (names, surfaces): &Surfaces,
        lights: [&[f64]; 2],
    ) -> Option<Vec<Lit>> {
        let seen = self.observer.table().on_band(self.band);
        let both = two_lights(self.band, surfaces, lights, &seen)?;
        let colours = swatches(&both, self.adaptation);
        let all = names.iter().zip(&both.patches).zip(colours);
        let lit = all.map(|((name, patch), swatches)| Lit {
            name: name.clone(),
            swatches,
            delta_e_2000: patch.delta_e_2000,
            hue: hue_of(patch.xyz[1], both.whites[1]),
        });
        Some(lit.collect())
    }
}

impl Lit {
    /// The surfaces of a document under its light and another one, in the set's order; `None` where
    /// one of the lights is not seen.
    pub fn beside(document: &Document, other: &Entry) -> Option<Vec<Self>> {
        let settings = document.settings;
        let eye = Eye {
            band: settings.band,
            observer: settings.observer,
            adaptation: document.view.adaptation(),
        };
        let lights = [document.light.on_band(eye.band), other.on_band(eye.band)];
        let surfaces = Patches::of(document).reflectances(eye.band);
        eye.under(&surfaces, lights.each_ref().map(Vec::as_slice))
    }

    /// Surfaces under two lights as a table.
    pub fn csv([first, second]: [&str; 2], all: &[Self]) -> String {
        let mut out = format!(
            "# {first} and {second}: CIEDE2000 of the colour shift, each light its own white\n"
        );
        out += &line(["surface", "shift"]);
        for lit in all {
            out += &line([words(&lit.name), number(lit.delta_e_2000)]);
        }
        out
    }
}

/// Every surface in colours of the screen, under each of the lights.
pub(super) fn swatches(both: &TwoLights, adaptation: Adaptation) -> Vec<[Swatch; 2]> {
    let of = |i: usize, xyz| Swatch::of_patch(xyz, both.whites[i], adaptation);
    let patches = both.patches.iter();
    patches
        .map(|p| [of(0, p.xyz[0]), of(1, p.xyz[1])])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, Command, showing};

    #[test]
    fn surfaces_beside_the_light_itself_do_not_move_and_beside_a_bulb_they_do() {
        let app = App::new();
        let document = app.document();
        let same = Lit::beside(document, &document.light).expect("a light");
        let moved = Lit::beside(document, &document.light_beside()).expect("two lights");
        assert_eq!((same.len(), moved.len()), (24, 24));
        for lit in &same {
            assert!(lit.delta_e_2000 < 1e-12, "{}", lit.name);
            assert_eq!(lit.swatches[0], lit.swatches[1]);
        }
        assert!(moved.iter().any(|lit| lit.delta_e_2000 > 5.0));
        // The left halves are those that Look shows as measured.
        let shown = app.derived().patches.as_ref().expect("a light");
        for (lit, patch) in moved.iter().zip(&shown.items) {
            assert_eq!(
                lit.swatches[0].rgb8, patch.exact_swatch.rgb8,
                "{}",
                lit.name
            );
        }
    }

    #[test]
    fn hues_have_their_places_and_greys_have_none() {
        let app = showing("cie_illuminants/CIE D65");
        let all = Lit::beside(app.document(), &app.document().light).expect("a light");
        let hue = |name: &str| {
            let found = all.iter().find(|lit| lit.name.starts_with(name));
            found.expect(name).hue
        };
        assert_eq!(hue("red"), Some(0));
        assert_eq!(hue("orange yellow"), Some(3));
        for grey in ["white", "neutral 5", "black"] {
            assert_eq!(hue(grey), None, "{grey}");
        }
    }

    #[test]
    fn own_surfaces_stand_behind_the_set_and_a_dark_light_shows_none() {
        let mut app = App::new();
        let red = app.entry("colorchecker_ohta/red").expect("shipped");
        app.apply(Command::Adopt(vec![red.spectrum.clone()]));
        let key = app.document().own[0].key.clone();
        app.apply(Command::ToggleOwnPatch { key });
        let document = app.document();
        let lit = Lit::beside(document, &document.light_beside()).expect("two lights");
        assert_eq!(lit.len(), 25);
        let dark = app.entry("paper/Mercury").expect("shipped");
        let mut far = document.clone();
        far.settings.band = Band::new(2000.0, 2400.0).expect("a range");
        assert_eq!(Lit::beside(&far, &dark), None);
    }
}
