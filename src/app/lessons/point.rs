//! What a step points at: a control by its name, a place in the plot, or a patch.

use serde::Deserialize;

use crate::app::{App, pages::Page};

/// What has a ring around it. Exactly one of `control`, `at_nm` and `patch`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Point {
    /// A control by the name that screen readers call it, or by the beginning of that name.
    pub control: Option<String>,
    /// A wavelength in the plot of the page `look`, nm.
    pub at_nm: Option<f64>,
    /// A surface below that plot, by its number from 1.
    pub patch: Option<usize>,
    /// What stands beside the ring.
    pub label: String,
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
        let given = [
            self.control.is_some(),
            self.at_nm.is_some(),
            self.patch.is_some(),
        ];
        let count = given.into_iter().filter(|is| *is).count();
        if count != 1 || self.label.trim().is_empty() {
            return Err(format!(
                "found {count} of control, at_nm and patch and the label \"{}\" in point, expected \
                 one of them and a label",
                self.label
            ));
        }
        if let Some(control) = &self.control {
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
        if let Some(nm) = self.at_nm {
            let band = app.derived().band;
            let range = band.min_nm()..=band.max_nm();
            return match range.contains(&nm) {
                true => Ok(Aim::Nm(nm)),
                false => Err(format!(
                    "found a point at {nm} nm, expected {} to {} nm",
                    range.start(),
                    range.end()
                )),
            };
        }
        let patches = app.derived().patches.iter().flat_map(|p| &p.items);
        let number = self.patch.unwrap_or_default();
        let patch = number.checked_sub(1).and_then(|i| patches.clone().nth(i));
        patch
            .map(|patch| Aim::Named(format!("{}: ΔE₀₀", patch.name)))
            .ok_or_else(|| {
                format!(
                    "found the patch {number} in point, expected 1 to {}",
                    patches.count()
                )
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_at_one_thing_that_is_there() {
        let (app, page) = (App::new(), Page::Spectrum);
        let of = |json: serde_json::Value| -> Point {
            super::super::parsed::parsed(json).expect("a point")
        };
        let control = of(serde_json::json!({"control": "Reset", "label": "Here"}));
        let line = of(serde_json::json!({"at_nm": 546.1, "label": "Here"}));
        let patch = of(serde_json::json!({"patch": 15, "label": "Here"}));
        assert_eq!(control.aim(&app, page), Ok(Aim::Named("Reset".to_owned())));
        assert_eq!(line.aim(&app, page), Ok(Aim::Nm(546.1)));
        assert_eq!(
            patch.aim(&app, page),
            Ok(Aim::Named("red: ΔE₀₀".to_owned()))
        );
        for wrong in [
            serde_json::json!({"label": "Here"}),
            serde_json::json!({"control": "Reset"}),
            serde_json::json!({"control": "Reset", "patch": 1, "label": "Here"}),
            serde_json::json!({"at_nm": 100.0, "label": "Here"}),
            serde_json::json!({"patch": 25, "label": "Here"}),
        ] {
            let why = of(wrong).aim(&app, page).expect_err("no such place");
            assert!(why.contains("expected"), "{why}");
        }
        let page = Page::Quality;
        assert!(control.aim(&app, page).is_ok());
        assert!(line.aim(&app, page).is_err() && patch.aim(&app, page).is_err());
    }
}
