//! Two surfaces under the light: the one that is looked at and the first that is laid over it.

use super::document::Document;
use crate::{
    color::{Adaptation, Swatch, Xyz, xyz_from_light, xyz_from_reflectance},
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::App, app::Command, app::Subject, color::Srgb};

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
