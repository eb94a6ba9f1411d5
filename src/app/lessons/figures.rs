//! Every figure that a lesson may name, by its key: the figures of models and of light quality,
//! and a few of the document.

use std::sync::{Mutex, PoisonError};

use super::names::{find, light};
use crate::{
    app::{
        App, Document,
        answers::hard_to_see_from,
        charts::products::narrow::{Behind, Filter},
        design::Desk,
        figures::{Unit, brief},
        make::behind,
        numbers::{DASH, figure as figure_words, or_dash},
        pages::Page,
        products::ModelledLight,
        quality::QualityShown,
        quality_report::{Row, light_of, rows},
        studies::{AuctionAsk, Question as _},
    },
    color::{
        Observer, Xyz, delta_e_of_xyz,
        quality::{Figures, Light, POINTS},
        xyz::{xyz_from_light, xyz_from_reflectance},
    },
    design::solve::MixFigures,
    spectrum::Kind,
    study::{Goal, Measure, Progress},
};

/// What figures are taken of: the program's state and what its pages remember.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The program.
    pub app: &'a App,
    /// What the pages remember.
    pub page: Page,
}

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

/// A figure of the document.
struct OfDocument {
    key: &'static str,
    meaning: &'static str,
    unit: Unit,
    of: fn(&Scene<'_>) -> Option<f64>,
}

const LM_PER_WATT: Unit = Unit {
    tail: " lm/W",
    ..Unit::NONE
};

const fn row(
    key: &'static str,
    meaning: &'static str,
    unit: Unit,
    of: fn(&Scene<'_>) -> Option<f64>,
) -> OfDocument {
    OfDocument {
        key,
        meaning,
        unit,
        of,
    }
}

/// The figures that only a document has.
const OF_DOCUMENT: [OfDocument; 23] = [
    row("order", "order N of the smooth part", Unit::NONE, |s| {
        Some(s.app.document().settings.effective_order() as f64)
    }),
    row("numbers", "numbers that the model takes", Unit::NONE, |s| {
        Some(s.app.derived().numbers() as f64)
    }),
    row(
        "points",
        "points of the table within the range",
        Unit::NONE,
        |s| Some(s.app.table_points() as f64),
    ),
    row(
        "spike_count",
        "bright lines that the model keeps",
        Unit::NONE,
        |s| Some(spikes(s.app, 1.0)),
    ),
    row(
        "dip_count",
        "dark lines that the model keeps",
        Unit::NONE,
        |s| Some(spikes(s.app, -1.0)),
    ),
    row(
        "spike_share",
        "the lines' share of the power",
        Unit::PERCENT,
        |s| {
            let derived = s.app.derived();
            let shares = derived.model.lines().iter();
            Some(
                shares
                    .filter_map(|spike| derived.parts.share(spike.weight))
                    .sum(),
            )
        },
    ),
    row(
        "threshold_percent",
        "least share of a line, per cent",
        Unit::NONE,
        |s| Some(s.app.document().settings.threshold_percent),
    ),
    row(
        "order_unseen",
        "least order from which on a difference is hard to see",
        Unit::NONE,
        |s| hard_to_see_from(s.app).map(|order| order as f64),
    ),
    row(
        "overlay_count",
        "spectra compared with it",
        Unit::NONE,
        |s| Some(s.app.document().laid_over().count() as f64),
    ),
    row(
        "delta_e_overlay",
        "colour difference to the first spectrum compared with it",
        Unit::DELTA_E,
        |s| beside_overlay(s.app.document()),
    ),
    row(
        "chain_count",
        "things that the light meets",
        Unit::NONE,
        |s| Some(s.app.document().products.chain.len() as f64),
    ),
    row(
        "chain_thickness",
        "thickness of the first of them",
        Unit::NONE,
        |s| Some(s.app.document().products.chain.first()?.thickness),
    ),
    row(
        "chain_luminance",
        "share of the luminance that the chain leaves",
        Unit::PERCENT,
        |s| chain_luminance(s.app),
    ),
    row(
        "chain_delta_e",
        "colour difference of the model behind the chain",
        Unit::DELTA_E,
        |s| chain_delta_e(s.app),
    ),
    row(
        "filter_centre_nm",
        "where the narrow filter stands, nm",
        Unit::NONE,
        |s| Some(s.app.document().pages.narrow.centre_nm),
    ),
    row(
        "desk_delta_e",
        "colour difference of the desk's mixture to its aim, equally bright",
        Unit::DELTA_E,
        off_aim,
    ),
    row("desk_rf", "Rf of the desk's mixture", Unit::NONE, |s| {
        desk(s)?.rf
    }),
    row(
        "desk_ler",
        "efficacy of radiation of the desk's mixture",
        LM_PER_WATT,
        |s| Some(desk(s)?.ler),
    ),
    row(
        "auction_lines",
        "lines that the auction keeps for its goal",
        Unit::NONE,
        |s| lines_bought(s, s.app.document().pages.auction.goal),
    ),
    row(
        "auction_lines_for_colours",
        "lines that it keeps for the colours of surfaces",
        Unit::NONE,
        |s| lines_bought(s, Goal::PATCHES),
    ),
    row(
        "filter_delta_e_model",
        "error of the model behind the narrow filter",
        Unit::DELTA_E,
        |s| behind_filter(s, 0),
    ),
    row(
        "filter_delta_e_series",
        "error of the series alone behind it",
        Unit::DELTA_E,
        |s| behind_filter(s, 1),
    ),
    row(
        "filter_delta_e_samples",
        "error of plain samples behind it",
        Unit::DELTA_E,
        |s| behind_filter(s, 2),
    ),
];

fn spikes(app: &App, sign: f64) -> f64 {
    let spikes = app.derived().model.lines().iter();
    spikes.filter(|spike| sign * spike.weight > 0.0).count() as f64
}

/// Lines of the model that the auction of the page ends with for a goal.
fn lines_bought(scene: &Scene<'_>, goal: Goal) -> Option<f64> {
    /// What was asked last: a sentence asks the same as the claim behind it.
    static LAST: Mutex<Vec<(AuctionAsk, Option<usize>)>> = Mutex::new(Vec::new());
    const KEPT: usize = 4;
    let ask = AuctionAsk::of(
        scene.app.document(),
        goal,
        scene.app.document().pages.auction.numbers,
    );
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    let known = last
        .iter()
        .find(|(one, _)| *one == ask)
        .map(|(_, count)| *count);
    let count = known.unwrap_or_else(|| {
        let auction = ask.answer(&Progress::default());
        let count = auction.map(|auction| auction.last().lines.len());
        last.truncate(KEPT - 1);
        last.insert(0, (ask, count));
        count
    });
    count.map(|count| count as f64)
}

/// Lights equally bright, or surfaces under the light.
fn beside_overlay(document: &Document) -> Option<f64> {
    let overlay = document.laid_over().next()?;
    let own = match overlay.kind() {
        Kind::Light => &document.light,
        _ => document.factor.as_ref()?,
    };
    let observer = document.settings.observer;
    let light = &document.light.spectrum.samples;
    let seen = |entry: &crate::app::Entry| -> Option<Xyz> {
        let samples = &entry.spectrum.samples;
        match entry.kind() {
            Kind::Light => xyz_from_light(samples, Kind::Light.outside(), observer),
            kind if kind.is_factor() => xyz_from_reflectance(samples, light, observer),
            _ => None,
        }
    };
    let white = xyz_from_light(light, Kind::Light.outside(), observer)?;
    delta_e_of_xyz(seen(own)?, seen(overlay)?, white)
}

fn desk(scene: &Scene<'_>) -> Option<MixFigures> {
    Desk::of(scene.app.document()).figures
}

/// How far the mixture's white is from the one that is aimed at, both of Y = 100, seen by an eye
/// that has adapted to the aim.
fn off_aim(scene: &Scene<'_>) -> Option<f64> {
    let aim = scene
        .app
        .document()
        .pages
        .solve
        .target(scene.app.document())
        .ok()?;
    let [x, y] = aim.xy();
    let white = Xyz::from_array([100.0 * x / y, 100.0, 100.0 * (1.0 - x - y) / y]);
    delta_e_of_xyz(desk(scene)?.xyz?, white, white)
}

fn chain_luminance(app: &App) -> Option<f64> {
    let document = app.document();
    let band = document.settings.band;
    let light = document.light.on_band(band);
    let bright = &Observer::CIE_1931.table().on_band(band)[1];
    let behind = behind(&document.products.chain, light.clone(), band);
    let whole = band.inner(&light, bright);
    (whole > 0.0).then(|| band.inner(&behind, bright) / whole)
}

fn chain_delta_e(app: &App) -> Option<f64> {
    let chain = &app.document().products.chain;
    let lit = ModelledLight::of(app);
    let band = lit.band();
    let exact = behind(chain, lit.derived.measured.clone(), band);
    let model = behind(chain, lit.derived.model_values(), band);
    let seen = |values: &[f64]| {
        let weights = &lit.tables.viewing.weights;
        Xyz::from_array(weights.each_ref().map(|w| band.inner(values, w)))
    };
    delta_e_of_xyz(seen(&exact), seen(&model), seen(&lit.derived.measured))
}

fn behind_filter(scene: &Scene<'_>, way: usize) -> Option<f64> {
    let narrow = &scene.app.document().pages.narrow;
    let behind = Behind::of(scene.app);
    let filter = Filter::Gaussian {
        centre_nm: narrow
            .centre_nm
            .clamp(behind.band.min_nm(), behind.band.max_nm()),
        width_nm: narrow.width_nm,
    };
    behind.figures(&filter).ways[way].delta_e_2000
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
            words: measure.figure().brief(value),
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
        Some(value) if unit == Unit::DELTA_E && value < 0.01 => "less than 0.01".to_owned(),
        Some(value) if unit == Unit::DELTA_E => brief(value, unit),
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
    use crate::app::Command;

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
