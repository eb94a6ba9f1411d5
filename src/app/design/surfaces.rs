//! Surfaces under the mixture, beside the same ones under its reference.

use serde::{Deserialize, Serialize};

use super::desk::Desk;
use crate::{
    app::{document::Document, library::Library, made::EVERYDAY_SET},
    color::{
        Adaptation, Observer, Swatch, Xyz, delta_e_2000, lab_from_xyz,
        quality::{RENDERING_NAMES, Rendering},
        xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values},
    },
    preset::Preset,
};

/// Which surfaces stand below the faders.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DeskSurfaces {
    /// The fifteen test colours of Ra.
    Test,
    /// Skin, leaves, bread and the like.
    Everyday,
    /// The patches of the document.
    #[default]
    Patches,
}

impl DeskSurfaces {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::Test, Self::Everyday, Self::Patches];

    /// Its name on the page.
    pub fn title(self) -> &'static str {
        match self {
            Self::Test => "Test colours",
            Self::Everyday => "Everyday surfaces",
            Self::Patches => "Surfaces of Look",
        }
    }

    /// What it is, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Test => "The fifteen test colours of the colour rendering index.",
            Self::Everyday => "Surfaces from every day, by the names that people use.",
            Self::Patches => {
                "The set of surfaces that is chosen on the page Spectrum: at first 24."
            }
        }
    }
}

/// A surface under the mixture and under a light of the same temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Beside {
    /// Under the mixture, as an eye sees it that is adapted to it.
    pub test: Swatch,
    /// Under the reference, as an eye sees it that is adapted to that.
    pub reference: Swatch,
    /// Its name and how far the two are apart.
    pub words: String,
}

/// The surfaces of a choice under the mixture and under its reference: a blackbody, from 5000 K on
/// daylight, of the same temperature. None without a colour temperature.
pub fn beside(desk: &Desk, surfaces: DeskSurfaces, document: &Document) -> Vec<Beside> {
    let Some(rendering) = &desk.rendering else {
        return Vec::new();
    };
    let group = match surfaces {
        DeskSurfaces::Test => return test_colours(rendering),
        DeskSurfaces::Everyday => EVERYDAY_SET,
        DeskSurfaces::Patches => &document.patch_set,
    };
    let whites = [rendering.test_white, rendering.reference_white];
    let lights = [desk.values.clone(), rendering.reference.on_nm()];
    let items = Library::bundled().group(group).map(|g| &g.items[..]);
    let shipped = items
        .unwrap_or_default()
        .iter()
        .filter_map(Preset::spectrum);
    let own = document.patches_of_own().map(|entry| &entry.spectrum);
    let own = own.filter(|_| surfaces == DeskSurfaces::Patches);
    let factors = shipped.chain(own).filter(|s| s.kind.is_factor());
    let found = factors.filter_map(|spectrum| {
        let outside = spectrum.kind.outside();
        let shares = spectrum.samples.on_whole_nm(FIRST_NM, LAST_NM, outside);
        let [test, reference] = [0, 1].map(|k| under(&lights[k], &shares));
        Some(one(&spectrum.name, [test?, reference?], whites, None))
    });
    found.collect()
}

/// XYZ of a surface, Y = 100 for the light.
fn under(light: &[f64], shares: &[f64]) -> Option<Xyz> {
    let seen: Vec<f64> = light.iter().zip(shares).map(|(s, r)| s * r).collect();
    let whole = xyz_from_nm_values(light, Observer::CIE_1931).y;
    let xyz = xyz_from_nm_values(&seen, Observer::CIE_1931) * (100.0 / whole);
    xyz.is_finite().then_some(xyz)
}

fn test_colours(found: &Rendering) -> Vec<Beside> {
    let whites = [found.test_white, found.reference_white];
    let samples = found.samples.iter().zip(RENDERING_NAMES).enumerate();
    samples
        .map(|(i, (sample, name))| {
            let index = format!("R{} {:.0}", i + 1, sample.index);
            one(name, [sample.test, sample.reference], whites, Some(index))
        })
        .collect()
}

fn one(name: &str, xyz: [Xyz; 2], whites: [Xyz; 2], index: Option<String>) -> Beside {
    let seen = |k: usize| Swatch::of_patch(xyz[k], whites[k], Adaptation::ToLight);
    let lab = |k: usize| lab_from_xyz(xyz[k], whites[k]);
    let apart = delta_e_2000(lab(0), lab(1));
    let index = index.map_or_else(String::new, |index| format!("{index}: "));
    Beside {
        test: seen(0),
        reference: seen(1),
        words: format!("{index}{name}, ΔE₀₀ {apart:.1}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            App,
            design::{
                desk::put_on_desk,
                mix::{Mix, MixChannel},
            },
        },
        design::mixture::Source,
    };

    /// One channel alone on the desk.
    fn of_one(source: Source) -> App {
        let mut app = App::new();
        let channels = vec![MixChannel::new(source)];
        let gels = Vec::new();
        put_on_desk(&mut app, Mix { channels, gels });
        app
    }

    #[test]
    fn the_test_colours_stand_beside_those_of_the_reference() {
        let app = App::new();
        let desk = Desk::of(app.document());
        let surfaces = beside(&desk, DeskSurfaces::Test, app.document());
        assert_eq!(surfaces.len(), 15);
        assert!(surfaces.iter().any(|s| s.test.rgb8 != s.reference.rgb8));
        let words = &surfaces[8].words;
        assert!(words.starts_with("R9 "), "{words}");
    }

    #[test]
    fn under_a_blackbody_every_surface_is_what_it_is_under_its_reference() {
        let app = of_one(Source::Blackbody { kelvin: 3000.0 });
        let desk = Desk::of(app.document());
        for (surfaces, count) in [
            (DeskSurfaces::Everyday, 8),
            (DeskSurfaces::Patches, 24),
            (DeskSurfaces::Test, 15),
        ] {
            let found = beside(&desk, surfaces, app.document());
            assert!(found.len() >= count, "{surfaces:?}: {}", found.len());
            for one in &found {
                assert_eq!(one.test.rgb8, one.reference.rgb8, "{}", one.words);
                assert!(one.words.ends_with("ΔE₀₀ 0.0"), "{}", one.words);
            }
        }
    }

    #[test]
    fn without_a_colour_temperature_there_is_nothing_to_stand_beside() {
        let app = of_one(Source::Line { at_nm: 530.0 });
        let desk = Desk::of(app.document());
        for surfaces in DeskSurfaces::ALL {
            assert!(beside(&desk, surfaces, app.document()).is_empty());
        }
    }
}
