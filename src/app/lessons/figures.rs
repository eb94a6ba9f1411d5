//! Every figure that a lesson may name, by its key: the figures of models and of light quality,
//! and a few of the document.

use super::{
    names::{find, light},
    of_document::OF_DOCUMENT,
    scene::Scene,
};
use crate::{
    app::{
        figures::Unit,
        numbers::{DASH, figure as figure_words, or_dash, two_digits},
        quality::QualityShown,
        quality_report::{Row, light_of, rows},
    },
    color::quality::{Figures, Light, POINTS},
    languages::fixed,
    study::Measure,
};

/// A figure with its words.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// What it is called.
    pub title: &'static str,
    /// The value as files have it; `None` where it does not exist.
    pub value: Option<f64>,
    /// The value with its unit and digits, a dash where there is none.
    pub words: String,
    /// What the value is multiplied by in words, and what stands behind it there.
    pub unit: (f64, String),
}

impl Told {
    /// A bound of the figure, as the figure itself is told.
    pub fn bound(&self, value: f64) -> String {
        let (factor, tail) = &self.unit;
        format!("{}{tail}", figure_words(value * factor))
    }
}

/// Every key, with what it counts where that is not told elsewhere.
pub fn keys() -> Vec<(&'static str, &'static str)> {
    let of_document = OF_DOCUMENT.map(|one| (one.key, one.meaning));
    let of_models = Measure::ALL.map(|m| (m.figure().key, m.figure().title));
    // Those of a light whose unit says nothing.
    let dark = Figures::of(&Light::of_nm_values(&[0.0; POINTS]), None);
    let of_quality = rows(&dark).into_iter();
    let of_quality = of_quality.map(|row| (row.figure.key, "of light quality"));
    let all = of_document.into_iter().chain(of_models).chain(of_quality);
    all.collect()
}

/// Whether a key is one of a figure.
///
/// # Errors
/// What was found and what was expected.
fn is_known(key: &str) -> Result<(), String> {
    static KEYS: std::sync::LazyLock<Vec<&'static str>> =
        std::sync::LazyLock::new(|| keys().into_iter().map(|(key, _)| key).collect());
    if KEYS.contains(&key) {
        return Ok(());
    }
    Err(format!(
        "found the figure {key}, expected one of {}",
        KEYS.join(", ")
    ))
}

/// Whether a key is one of a figure, and of something there is: of what is shown, of its `model`,
/// or of a light of the library or among those that a lesson makes.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn is_known_of(key: &str, of: Option<&str>, made: &[&str]) -> Result<(), String> {
    is_known(key)?;
    match of {
        None | Some("model") => Ok(()),
        Some(name) => find(name, made),
    }
}

/// A figure of what is shown, of its `model`, or of a light by its name.
///
/// # Errors
/// What was found and what was expected: an unknown key or light.
pub fn figure(scene: &Scene<'_>, key: &str, of: Option<&str>) -> Result<Told, String> {
    let app = scene.app;
    if let Some(one) = OF_DOCUMENT.iter().find(|one| one.key == key) {
        return Ok(told(one.meaning, (one.of)(scene), one.unit));
    }
    if let Some(measure) = Measure::ALL.into_iter().find(|m| m.figure().key == key) {
        let value = app.derived().figures[measure];
        let unit = measure.figure().unit;
        return Ok(Told {
            title: measure.figure().title,
            value,
            words: match unit == Unit::DELTA_E {
                true => told("", value, unit).words,
                false => measure.figure().brief(value),
            },
            unit: (unit.factor, unit.tail.to_owned()),
        });
    }
    is_known(key)?;
    let rows = match of {
        Some("model") => rows(&QualityShown::of(app).sheet.model),
        of => {
            let light = match of {
                Some(name) => light(app, name)?,
                None => app.document().light.clone(),
            };
            let (light, measured) = light_of(&light.spectrum);
            rows(&Figures::of(&light, measured))
        }
    };
    let row = rows.iter().find(|row| row.figure.key == key);
    // Absolute figures are counted in the light's own unit.
    let none = Told {
        title: "",
        value: None,
        words: DASH.to_owned(),
        unit: (1.0, String::new()),
    };
    Ok(row.map_or(none, |row| Told {
        title: row.figure.title,
        value: row.value.clone().ok(),
        words: match row.figure.key {
            // As titles have it.
            "cct" => or_dash(row.value.clone().ok(), |k| format!("{} K", figure_words(k))),
            _ => Row::shown(row),
        },
        unit: (1.0, row.figure.unit.tail.to_owned()),
    }))
}

fn told(title: &'static str, value: Option<f64>, unit: Unit) -> Told {
    let words = match value {
        None => DASH.to_owned(),
        Some(value) if value.fract() == 0.0 && unit == Unit::NONE => format!("{value}"),
        // More digits would be of what nobody sees.
        Some(value) if unit == Unit::DELTA_E && value < 0.01 => {
            tr!("less than {value}", value = fixed(0.01, 2))
        }
        Some(value) if unit == Unit::DELTA_E => two_digits(value),
        Some(value) => format!("{}{}", figure_words(value * unit.factor), unit.tail),
    };
    Told {
        title,
        value,
        words,
        unit: (unit.factor, unit.tail.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::{super::names::entry, *};
    use crate::app::{App, Command, pages::Page};

    #[test]
    fn every_key_is_there_once_and_is_a_number_on_the_first_light() {
        let (app, page) = (App::new(), Page::Spectrum);
        let scene = Scene { app: &app, page };
        let keys = keys();
        let mut sorted: Vec<&str> = keys.iter().map(|(key, _)| *key).collect();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), keys.len());
        let without = [
            "delta_e_overlay",
            "delta_e_filters",
            "fwhm_nm",
            "tlci",
            "lux",
            "melanopic_edi",
            "photo_left_out_nm",
            "ppfd",
        ];
        for (key, _) in keys {
            let told = figure(&scene, key, None).expect("known");
            let is_there = told.value.is_some_and(f64::is_finite);
            assert_eq!(is_there, !without.contains(&key), "{key}");
        }
        assert!(figure(&scene, "colour", None).is_err());
        assert!(figure(&scene, "ra", Some("no such light")).is_err());
    }

    #[test]
    fn a_spectrum_laid_over_itself_has_its_colour_and_another_light_has_not() {
        let mut app = App::new();
        let page = Page::Spectrum;
        let value = |app: &App, key: &str, of: Option<&str>| {
            let scene = Scene { app, page };
            figure(&scene, key, of).expect("known").value
        };
        let light = app.document().light.clone();
        app.apply(Command::ToggleOverlay(light.clone()));
        assert!(value(&app, "delta_e_overlay", None).is_some_and(|e| e < 1e-9));
        app.apply(Command::Show(entry(&app, "CIE A").expect("shipped")));
        assert!(value(&app, "delta_e_overlay", None).is_some_and(|e| e > 10.0));
        let ra = value(&app, "ra", Some("FL2")).expect("a white");
        assert!(value(&app, "ra", None).is_some_and(|of_a| of_a > ra + 20.0));
    }
}
