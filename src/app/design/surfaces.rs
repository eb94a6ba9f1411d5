//! Surfaces under the mixture, beside the same ones under its reference or under a second light.

use serde::{Deserialize, Serialize};

use super::desk::Desk;
use crate::{
    app::{document::Document, library::Library, made::EVERYDAY_SET},
    color::{
        Adaptation, Observer, Swatch, Xyz, delta_e_2000, lab_from_xyz,
        quality::{RENDERING_NAMES, Rendering},
        xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values},
    },
    languages::{fixed, said},
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
            Self::Test => said!("Test colours"),
            Self::Everyday => said!("Everyday surfaces"),
            Self::Patches => said!("Surfaces of Look"),
        }
    }

    /// What it is, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Test => said!("The fifteen test colours of the colour rendering index."),
            Self::Everyday => said!("Surfaces from every day, by the names that people use."),
            Self::Patches => {
                said!("The set of surfaces that is chosen on the page Spectrum: at first 24.")
            }
        }
    }
}

/// A surface under the mixture, and under a light of the same temperature or the second one.
#[derive(Clone, Debug, PartialEq)]
pub struct Beside {
    /// Under the mixture, as an eye sees it that is adapted to it.
    pub test: Swatch,
    /// Under the other light, as an eye sees it that is adapted to that.
    pub other: Swatch,
    /// Its name and how far the two are apart.
    pub words: String,
}

/// The surfaces of a choice under the mixture and under the second light, without one under the
/// mixture's reference: a blackbody, from 5000 K on daylight, of the same temperature. None under a
/// light without a colour temperature.
pub fn beside(
    desk: &Desk,
    second: Option<&Desk>,
    surfaces: DeskSurfaces,
    document: &Document,
) -> Vec<Beside> {
    let (Some(rendering), second) = (&desk.rendering, second.map(|s| (s, s.rendering.as_ref())))
    else {
        return Vec::new();
    };
    let (white, values) = match second {
        None => (rendering.reference_white, rendering.reference.on_nm()),
        Some((second, Some(of_second))) => (of_second.test_white, second.values.clone()),
        Some((_, None)) => return Vec::new(),
    };
    let whites = [rendering.test_white, white];
    let group = match surfaces {
        DeskSurfaces::Test => {
            let second = second.and_then(|(_, of_second)| of_second);
            return test_colours(rendering, second, whites);
        }
        DeskSurfaces::Everyday => EVERYDAY_SET,
        DeskSurfaces::Patches => &document.patch_set,
    };
    let lights = [desk.values.clone(), values];
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
        let [test, other] = [0, 1].map(|k| under(&lights[k], &shares));
        Some(one(&spectrum.name, [test?, other?], whites, None))
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

fn test_colours(found: &Rendering, second: Option<&Rendering>, whites: [Xyz; 2]) -> Vec<Beside> {
    let samples = found.samples.iter().zip(RENDERING_NAMES).enumerate();
    samples
        .map(|(i, (sample, name))| {
            let index = format!("R{} {:.0}", i + 1, sample.index);
            let other = second.map_or(sample.reference, |second| second.samples[i].test);
            one(said(name), [sample.test, other], whites, Some(index))
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
        other: seen(1),
        words: format!("{index}{name}, ΔE₀₀ {}", fixed(apart, 1)),
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
        let surfaces = beside(&desk, None, DeskSurfaces::Test, app.document());
        assert_eq!(surfaces.len(), 15);
        assert!(surfaces.iter().any(|s| s.test.rgb8 != s.other.rgb8));
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
            let found = beside(&desk, None, surfaces, app.document());
            assert!(found.len() >= count, "{surfaces:?}: {}", found.len());
            for one in &found {
                assert_eq!(one.test.rgb8, one.other.rgb8, "{}", one.words);
                assert!(one.words.ends_with("ΔE₀₀ 0.0"), "{}", one.words);
            }
        }
    }

    #[test]
    fn with_a_second_light_surfaces_stand_beside_what_they_are_under_that() {
        let mut app = of_one(Source::Blackbody { kelvin: 3000.0 });
        let lamp = app.entry("cie_illuminants/CIE A").expect("shipped");
        app.apply(crate::app::Command::Compare(Some(lamp)));
        let desk = Desk::of(app.document());
        let second = Desk::of_second(app.document()).expect("a second light");
        // The desk's figures of it are those of the light.
        let kelvin = second
            .figures
            .as_ref()
            .and_then(|f| f.cct)
            .map(|cct| cct.kelvin);
        assert!(
            kelvin.is_some_and(|kelvin| (kelvin - 2856.0).abs() < 2.0),
            "{kelvin:?}"
        );
        for surfaces in DeskSurfaces::ALL {
            let found = beside(&desk, Some(&second), surfaces, app.document());
            let itself = beside(&second, Some(&second), surfaces, app.document());
            assert_eq!(found.len(), itself.len());
            for (one, of_second) in found.iter().zip(&itself) {
                assert_eq!(one.other, of_second.test, "{}", one.words);
                assert_eq!(of_second.test, of_second.other, "{}", of_second.words);
            }
            assert!(found.iter().any(|one| one.test.rgb8 != one.other.rgb8));
        }
    }

    #[test]
    fn without_a_colour_temperature_there_is_nothing_to_stand_beside() {
        let app = of_one(Source::Line { at_nm: 530.0 });
        let desk = Desk::of(app.document());
        for surfaces in DeskSurfaces::ALL {
            assert!(beside(&desk, None, surfaces, app.document()).is_empty());
        }
    }
}
