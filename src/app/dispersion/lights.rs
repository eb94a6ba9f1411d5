//! The lights of the pages: always models, a smooth part and spikes of their own.

use std::sync::Arc;

use super::memory::Beside;
use crate::{
    app::{
        document::{Document, Subject},
        entry::Entry,
        products::ModelledLight,
        state::{App, derived_of},
    },
    color::blackbody,
    optics::Light,
    spectrum::{Band, Kind},
};

/// The model of the document's light.
///
/// # Errors
/// A sentence where nothing of it is seen.
pub fn document_light(app: &App) -> Result<Light, String> {
    let modelled = ModelledLight::of(app);
    of_model(app.document().light.name(), &modelled.derived.model)
}

/// The model of another light, by the document's knobs.
///
/// # Errors
/// A sentence where nothing of it is seen.
pub fn modelled(app: &App, entry: &Arc<Entry>) -> Result<Light, String> {
    let document = Document {
        light: entry.clone(),
        subject: Subject::Light,
        ..app.document().clone()
    };
    of_model(entry.name(), &derived_of(&document).0.model)
}

fn of_model(name: &str, model: &crate::spectrum::Composite) -> Result<Light, String> {
    Light::of_composite(name, model).map_err(|why| format!("{why}."))
}

impl Beside {
    /// The light; `None` where there is to be none.
    pub fn light(self, app: &App) -> Option<Result<Light, String>> {
        let black = |name: &str, kelvin: f64| {
            let band = Band::VISIBLE;
            let at = |i: usize| blackbody::relative(band.min_nm() + i as f64, kelvin);
            let smooth = (0..band.points()).map(at).collect();
            Light::new(name, band, smooth, Vec::new()).map_err(|why| format!("{why}."))
        };
        match self {
            Self::Nothing => None,
            Self::Bulb => Some(black("A bulb, 2856 K", 2856.0)),
            Self::Sun => Some(black("The sun, 5772 K", 5772.0)),
            Self::Overlaid => {
                let mut overlays = app.document().overlays.iter();
                let light = overlays.find(|entry| entry.kind() == Kind::Light);
                Some(light.map_or_else(
                    || Err("No light is laid over this one: + Compare does so.".to_owned()),
                    |entry| modelled(app, entry),
                ))
            }
        }
    }
}
