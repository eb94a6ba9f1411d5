//! A light with its model, and the figures of either.

use std::sync::Arc;

use super::measured::light_of;
use crate::{
    app::{
        Derived, Document, Entry, Settings,
        state::{derive, derived_of},
        tables::{Tables, Viewing},
    },
    color::quality::{Figures, Light},
    spectrum::Composite,
};

/// The figures of a light as measured and of its model.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// What the light is called.
    pub name: String,
    /// Of the measured light, all of its table.
    pub measured: Figures,
    /// Of the model, on its range.
    pub model: Figures,
    /// The model.
    pub composite: Composite,
}

impl Sheet {
    /// The figures of a document's light and of its model.
    pub fn of(name: String, document: &Document, derived: &Derived) -> Self {
        let (light, measured) = light_of(&document.light.spectrum);
        Self {
            name,
            measured: Figures::of(&light, measured),
            model: Figures::of(
                &Light::of_parts(derived.band, &derived.outline(), &derived.ideal_spikes()),
                measured,
            ),
            composite: derived.model.clone(),
        }
    }
}

/// Makes models of many lights by the same settings: what they share is made once.
#[derive(Clone, Debug)]
pub struct Modeller {
    about: Document,
    tables: Tables,
}

impl Modeller {
    /// Makes ready for models by these settings. Any light will do for `first`.
    pub fn new(first: Arc<Entry>, settings: Settings) -> Self {
        let settings = settings.clamped();
        let tables = Tables::new(
            settings.band,
            settings.basis,
            settings.effective_order(),
            settings.observer,
            Viewing::of_light(settings.band, settings.observer),
            // No figure of a light is of the patches under it.
            None,
        );
        Self {
            about: Document {
                settings,
                ..Document::about(first)
            },
            tables,
        }
    }

    /// A document about a light, with these settings.
    pub fn document(&self, light: Arc<Entry>) -> Document {
        Document {
            light,
            ..self.about.clone()
        }
    }

    /// The sheet of a document, whose settings may be its own.
    pub fn sheet(&self, name: String, document: &Document) -> Sheet {
        let is_shared = document.settings == self.about.settings && document.is_about_light();
        let derived = if is_shared {
            derive(document, &self.tables, None)
        } else {
            derived_of(document).0
        };
        Sheet::of(name, document, &derived)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::open;

    #[test]
    fn a_sheet_is_of_the_model_that_the_window_shows() {
        let entry = |name: &str| Arc::new(open::resolve(name, None, None).expect("a preset"));
        let settings = Settings {
            order: 9,
            colour_exact: true,
            ..Settings::default()
        };
        let modeller = Modeller::new(entry("CIE A"), settings);
        let document = modeller.document(entry("FL2"));
        let sheet = modeller.sheet("FL2".to_owned(), &document);
        let (derived, _) = derived_of(&document);
        assert_eq!(sheet, Sheet::of("FL2".to_owned(), &document, &derived));
        assert_eq!(sheet.composite.smooth().order(), 9);
        // Other settings are the document's own.
        let plain = Document {
            settings: Settings::default(),
            ..document
        };
        let sheet = modeller.sheet("FL2".to_owned(), &plain);
        assert_eq!(sheet.composite.smooth().order(), Settings::default().order);
    }
}
