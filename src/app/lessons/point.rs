//! What a step points at: a control by its name, a place in the plot, or a patch.

use serde::Deserialize;
use serde_json::{Map, Value};

use crate::{
    app::{App, pages::Page},
    languages::with_colon,
};

/// Place of a ring, under its key in the file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename = "control, at_nm or patch", rename_all = "snake_case")]
pub enum Around {
    /// A control by the name that screen readers call it, or by the beginning of that name.
    Control(String),
    /// A wavelength in the plot of the page `look`, nm.
    AtNm(f64),
    /// A surface below that plot, by its number from 1.
    Patch(usize),
}

/// A ring, and what stands beside it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Point {
    #[serde(flatten)]
    pub around: Around,
    pub label: String,
    #[serde(flatten)]
    rest: Map<String, Value>,
}

/// Where a ring is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Aim {
    /// Around what is called this, or begins so.
    Named(String),
    /// Around a wavelength in the plot, nm.
    Nm(f64),
}

impl Point {
    /// Where its ring is drawn, as things stand.
    ///
    /// # Errors
    /// What was found and what was expected: a page without that plot, a wavelength or a surface
    /// that is not in it.
    pub fn aim(&self, app: &App, page: Page) -> Result<Aim, String> {
        if self.label.trim().is_empty() {
            return Err("found an empty label in point, expected words".to_owned());
        }
        if let Some(key) = self.rest.keys().next() {
            return Err(format!(
                "found the field `{key}` in point, expected one of control, at_nm and patch, and label"
            ));
        }
        if let Around::Control(control) = &self.around {
            return match control.trim() {
                "" => Err("found an empty control in point, expected its name".to_owned()),
                name => Ok(Aim::Named(name.to_owned())),
            };
        }
        if page != Page::Spectrum {
            return Err(format!(
                "found a point in the plot on the page {}, expected the page {}",
                page.word(),
                Page::Spectrum.word()
            ));
        }
        let number = match &self.around {
            Around::AtNm(nm) => {
                let band = app.derived().band;
                let range = band.min_nm()..=band.max_nm();
                return match range.contains(nm) {
                    true => Ok(Aim::Nm(*nm)),
                    false => Err(format!(
                        "found a point at {nm} nm, expected {} to {} nm",
                        range.start(),
                        range.end()
                    )),
                };
            }
            Around::Patch(number) => *number,
            Around::Control(_) => 0,
        };
        let patches = app.derived().patches.iter().flat_map(|p| &p.items);
        let patch = number.checked_sub(1).and_then(|i| patches.clone().nth(i));
        patch
            .map(|patch| Aim::Named(with_colon(app.document().patch_called(&patch.name), "")))
            .ok_or_else(|| {
                format!(
                    "found the patch {number} in point, expected 1 to {}",
                    patches.count()
                )
            })
    }

    /// The control that it points at.
    pub fn control(&self) -> Option<&str> {
        match &self.around {
            Around::Control(name) => Some(name),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::assert_says,
        languages::{Language, in_language},
    };

    #[test]
    fn a_point_is_at_one_thing_that_is_there() {
        let (app, page) = (App::new(), Page::Spectrum);
        let read = |json: Value| super::super::parsed::parsed::<Point>(json);
        let of = |json: Value| read(json).expect("a point");
        let control = of(serde_json::json!({"control": "Reset", "label": "Here"}));
        let line = of(serde_json::json!({"at_nm": 546.1, "label": "Here"}));
        let patch = of(serde_json::json!({"patch": 15, "label": "Here"}));
        assert_eq!(control.aim(&app, page), Ok(Aim::Named("Reset".to_owned())));
        assert_eq!(line.aim(&app, page), Ok(Aim::Nm(546.1)));
        assert_eq!(patch.aim(&app, page), Ok(Aim::Named("red: ".to_owned())));
        let french = in_language(Language::French, || patch.aim(&app, page));
        assert_eq!(french, Ok(Aim::Named("rouge\u{a0}: ".to_owned())));
        for (wrong, words) in [
            (
                serde_json::json!({"label": "Here"}),
                "found none of control, at_nm or patch, expected one",
            ),
            (
                serde_json::json!({"control": "Reset"}),
                "found no `label`, expected it",
            ),
            (
                serde_json::json!({"control": 5, "label": "Here"}),
                "found integer `5`, expected a string",
            ),
            (
                serde_json::json!({"control": "Reset", "patch": 1, "label": "Here"}),
                "found the field `patch` in point, expected one of",
            ),
            (
                serde_json::json!({"control": "Reset", "label": " "}),
                "found an empty label",
            ),
            (
                serde_json::json!({"at_nm": 100.0, "label": "Here"}),
                "found a point at 100 nm, expected 380 to 780 nm",
            ),
            (
                serde_json::json!({"patch": 25, "label": "Here"}),
                "found the patch 25 in point, expected 1 to 24",
            ),
        ] {
            let aimed = read(wrong).and_then(|point| point.aim(&app, page));
            assert_says(&aimed.expect_err("no such place"), words);
        }
        let page = Page::Quality;
        assert!(control.aim(&app, page).is_ok());
        assert!(line.aim(&app, page).is_err() && patch.aim(&app, page).is_err());
    }
}
