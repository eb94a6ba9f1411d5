//! The document's light with its model, also while the window looks at a reflectance.

use std::sync::Arc;

use super::super::{
    derived::Derived,
    document::{Document, Subject},
    entry::Entry,
    line_names::LineName,
    settings::Settings,
    spike_names::names_of,
    state::{App, derive, derived_of},
    tables::Tables,
};
use crate::{
    color::{Xyz, xyz_of_parts},
    spectrum::{Band, Composite, Factor, Line},
    study::products::Product,
};

/// The light, its model as the settings have it, and what it is looked at with.
#[derive(Clone, Debug)]
pub struct ModelledLight {
    /// Model and colours of the light.
    pub derived: Arc<Derived>,
    /// Colour-matching functions and bases.
    pub tables: Arc<Tables>,
    /// The model with the widths of the lines that its spikes stand for; 0 where none is known.
    model: Composite,
    settings: Settings,
}

impl ModelledLight {
    /// The light of the state; nothing is computed anew when the state's model is of the light.
    pub fn of(app: &App) -> Self {
        let document = app.document();
        let settings = document.settings;
        let (derived, tables) = if document.is_about_light() {
            (app.derived().clone(), app.tables().clone())
        } else {
            let (derived, tables) = derived_of(&Document {
                subject: Subject::Light,
                ..document.clone()
            });
            (Arc::new(derived), Arc::new(tables))
        };
        Self::with(derived, tables, settings)
    }

    fn with(derived: Arc<Derived>, tables: Arc<Tables>, settings: Settings) -> Self {
        let lines = derived.parts.spikes.iter().map(|found| Line {
            fwhm_nm: found.width_nm.unwrap_or_default(),
            ..found.spike
        });
        let smooth = derived.model.smooth().clone();
        Self {
            model: Composite::of_lines_inside(smooth, lines.collect()),
            derived,
            tables,
            settings,
        }
    }

    /// A light that is not the document's own, as its settings model it.
    pub fn another(&self, app: &App, light: &Arc<Entry>) -> Derived {
        let document = Document {
            light: light.clone(),
            subject: Subject::Light,
            ..app.document().clone()
        };
        derive(&document, &self.tables, None)
    }

    /// The second light of the state, as the settings model it.
    pub fn of_second(&self, app: &App) -> Option<Self> {
        let derived = self.another(app, app.document().second.as_ref()?);
        let tables = self.tables.clone();
        Some(Self::with(Arc::new(derived), tables, self.settings))
    }

    /// The grid.
    pub fn band(&self) -> Band {
        self.derived.band
    }

    /// What the light's spikes are called, in their order.
    pub fn spike_names(&self, app: &App) -> Vec<LineName> {
        if app.document().is_about_light() {
            return app.spike_names().to_vec();
        }
        names_of(&app.document().light, &self.derived, app.element_lines())
    }

    /// The colour of values on the grid, value x nm.
    pub fn xyz(&self, values: &[f64]) -> Xyz {
        xyz_of_parts(self.band(), values, &[], &self.tables.viewing.weights)
    }

    /// Ready to be multiplied as the settings say.
    pub fn product(&self) -> Product<'_> {
        Product {
            measured: &self.derived.measured,
            model: &self.model,
            sampling: self.settings.sampling,
            seen: &self.tables.viewing.weights,
            width_nm: self.settings.max_width_nm,
        }
    }

    /// A curve of shares on the grid as a factor; its dips are kept as spikes when the settings
    /// ask for dips.
    pub fn factor(&self, values: Vec<f64>) -> Factor {
        if self.settings.dips && self.settings.spikes {
            Factor::keeping_dips(self.band(), values, self.settings.spike_settings())
        } else {
            Factor::new(values)
        }
    }
}
