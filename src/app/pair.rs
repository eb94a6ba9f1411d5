//! Surfaces under lights: the one that is looked at beside the first that is compared with it, and
//! under the favourite lights.

use super::{document::Document, search::favourites, state::App};
use crate::{
    color::{Adaptation, Swatch, Xyz, xyz_from_light, xyz_from_reflectance},
    languages::said,
    spectrum::Kind,
};

/// Two surfaces side by side under a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// What they are called: the one looked at, then the one laid over it.
    pub names: [String; 2],
    /// What the light is called.
    pub light: String,
    /// What the screen shows of them, in the same order.
    pub swatches: [Swatch; 2],
}

impl Pair {
    /// The pair of a document; `None` where no surface lies over a surface, and in the dark.
    pub fn of(document: &Document) -> Option<Self> {
        let factors = document.overlays.iter().filter(|o| o.kind().is_factor());
        let own = document
            .factor
            .as_ref()
            .filter(|_| !document.is_about_light())?;
        let over = factors.into_iter().next()?;
        let observer = document.settings.observer;
        let light = &document.light.spectrum.samples;
        let white = xyz_from_light(light, Kind::Light.outside(), observer)?;
        let adaptation = match document.view.adapt_patches {
            true => Adaptation::ToLight,
            false => Adaptation::None,
        };
        let seen = |xyz: Xyz| Swatch::of_patch(xyz, white, adaptation);
        let [own_xyz, over_xyz] =
            [own, over].map(|entry| xyz_from_reflectance(&entry.spectrum.samples, light, observer));
        Some(Self {
            names: [own, over].map(|entry| entry.name().to_owned()),
            light: document.light.name().to_owned(),
            swatches: [seen(own_xyz?), seen(over_xyz?)],
        })
    }
}

/// Lights that a surface is shown under.
const LIGHTS: usize = 6;

/// The surface that is looked at under the favourite lights, each as the document sees patches:
/// what the light is called, and the colour. Empty where a light is looked at.
pub fn under_favourites(app: &App) -> Vec<(&'static str, Swatch)> {
    let document = app.document();
    let surface = document.factor.as_ref();
    let Some(surface) = surface.filter(|_| !document.is_about_light()) else {
        return Vec::new();
    };
    let (observer, adaptation) = (document.settings.observer, document.view.adaptation());
    let of = favourites(app.bundled()).into_iter();
    let lights = of.filter(|light| light.entry.kind() == Kind::Light);
    lights
        .filter_map(|light| {
            let samples = &light.entry.spectrum.samples;
            let white = xyz_from_light(samples, Kind::Light.outside(), observer)?;
            let xyz = xyz_from_reflectance(&surface.spectrum.samples, samples, observer)?;
            Some((said(light.label), Swatch::of_patch(xyz, white, adaptation)))
        })
        .take(LIGHTS)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::Command, app::Subject, color::Srgb};

    #[test]
    fn a_surface_is_shown_under_six_lights_and_is_not_the_same_under_all() {
        let mut app = App::new();
        assert!(under_favourites(&app).is_empty());
        let red = app.entry("colorchecker_ohta/red").expect("shipped");
        app.apply(Command::Show(red));
        let shown = under_favourites(&app);
        assert_eq!(shown.len(), LIGHTS);
        assert!(shown.iter().any(|(_, swatch)| *swatch != shown[0].1));
    }

    #[test]
    fn a_surface_and_one_laid_over_it_are_a_pair_under_the_light() {
        let mut app = App::new();
        let entry = |app: &App, key: &str| app.entry(key).expect("shipped");
        app.apply(Command::Show(entry(&app, "cie_illuminants/CIE D65")));
        let red = entry(&app, "colorchecker_ohta/red");
        app.apply(Command::Show(red.clone()));
        assert_eq!(Pair::of(app.document()), None);
        app.apply(Command::ToggleOverlay(red));
        let pair = Pair::of(app.document()).expect("a pair");
        assert_eq!(pair.swatches[0], pair.swatches[1]);
        assert_eq!(pair.names, ["red", "red"]);
        // The chart's red: more than twice as much red as green and blue.
        let Srgb([r, g, b]) = pair.swatches[0].rgb8;
        assert!(r > 2 * g && r > 2 * b, "{r} {g} {b}");
        app.apply(Command::About(Subject::Light));
        assert_eq!(Pair::of(app.document()), None);
    }
}
