//! The lights of the pages: lines as exact rays, and the rest as it was measured or as the model
//! has it.

use std::sync::Arc;

use super::sent::Sent;
use crate::{
    app::{
        derived::Derived,
        document::{Document, Subject},
        entry::Entry,
        pages::Beside,
        products::ModelledLight,
        state::{App, derived_of},
    },
    color::blackbody,
    optics::{Light, LightError},
    spectrum::{Band, Kind},
};

impl Sent {
    /// The light of a result. As measured its power is the measured one: what a line took is in
    /// the line.
    ///
    /// # Errors
    /// [`LightError`] where nothing of it is seen.
    pub fn light(self, name: &str, derived: &Derived) -> Result<Light, LightError> {
        let Derived {
            band, parts, model, ..
        } = derived;
        match self {
            Self::Measured => Light::new(name, *band, parts.smooth.clone(), model.lines().to_vec()),
            Self::Model => Light::of_composite(name, model),
        }
    }
}

/// The document's light.
///
/// # Errors
/// A sentence where nothing of it is seen.
pub fn document_light(app: &App, sent: Sent) -> Result<Light, String> {
    let modelled = ModelledLight::of(app);
    let light = sent.light(app.document().light.name(), &modelled.derived);
    light.map_err(|why| format!("{why}."))
}

/// Another light, its lines found by the document's knobs.
///
/// # Errors
/// A sentence where nothing of it is seen.
pub fn another_light(app: &App, entry: &Arc<Entry>, sent: Sent) -> Result<Light, String> {
    let document = Document {
        light: entry.clone(),
        subject: Subject::Light,
        ..app.document().clone()
    };
    let light = sent.light(entry.name(), &derived_of(&document).0);
    light.map_err(|why| format!("{why}."))
}

impl Beside {
    /// The light; `None` where there is to be none.
    pub fn light(self, app: &App, sent: Sent) -> Option<Result<Light, String>> {
        let black = |name: &str, kelvin: f64| {
            let band = Band::VISIBLE;
            let at = |i: usize| blackbody::relative(band.min_nm() + i as f64, kelvin);
            let smooth = (0..band.points()).map(at).collect();
            Light::new(name, band, smooth, Vec::new()).map_err(|why| format!("{why}."))
        };
        match self {
            Self::Nothing => None,
            Self::Bulb => Some(black(said!("A bulb, 2856 K"), 2856.0)),
            Self::Sun => Some(black(said!("The sun, 5772 K"), 5772.0)),
            Self::Overlaid => {
                let document = app.document();
                let mut beside = document.second.iter().chain(&document.overlays);
                let light = beside.find(|entry| entry.kind() == Kind::Light);
                Some(light.map_or_else(
                    || {
                        Err(
                            said!("There is no second light yet: choose one with + Compare.")
                                .to_owned(),
                        )
                    },
                    |entry| another_light(app, entry, sent),
                ))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::Observer,
        spectrum::{Outside, Sampled},
    };

    #[test]
    fn a_measured_light_keeps_its_power_and_its_curve_beside_the_lines() {
        let app = App::new();
        let measured = document_light(&app, Sent::Measured).expect("FL2 shines");
        let model = document_light(&app, Sent::Model).expect("FL2 shines");
        assert_eq!(measured.spikes(), model.spikes());
        let table: &Sampled = &app.document().light.spectrum.samples;
        // Far from every line the light is the table.
        for nm in [470.0, 510.0, 620.0, 660.0] {
            assert_eq!(measured.smooth_at(nm), table.at(nm, Outside::Zero), "{nm}");
        }
        // The series of the model is off there: both are not one curve.
        assert!((model.smooth_at(470.0) / measured.smooth_at(470.0) - 1.0).abs() > 1e-4);
        let band = measured.band();
        let power = |light: &Light| {
            let smooth: f64 = (0..band.points())
                .map(|i| band.weight(i) * light.smooth()[i])
                .sum();
            smooth + light.spikes().iter().map(|s| s.weight).sum::<f64>()
        };
        let whole = table.integrate(band, Outside::Zero, |_| 1.0);
        // Sums of 401 numbers.
        assert!((power(&measured) / whole - 1.0).abs() < 1e-12);
        assert!(measured.white(Observer::CIE_1931).y > 0.0);
    }
}
