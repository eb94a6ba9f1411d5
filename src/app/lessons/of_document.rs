//! The figures that only a document has, or a page: of its model, overlays, chain, desk, photograph.

use std::sync::{Mutex, PoisonError};

use super::scene::Scene;
use crate::{
    app::{
        App, Document,
        answers::hard_to_see_from,
        charts::products::narrow::{Behind, Filter},
        design::Desk,
        figures::Unit,
        make::behind,
        products::ModelledLight,
        studies::{AuctionAsk, Question as _},
    },
    color::{
        Observer, Xyz, delta_e_of_xyz,
        xyz::{xyz_from_light, xyz_from_reflectance},
    },
    design::solve::MixFigures,
    photographs::axis::Solution,
    spectrum::Kind,
    study::{Goal, Progress},
};

/// A figure of the document.
pub(super) struct OfDocument {
    pub key: &'static str,
    pub meaning: &'static str,
    pub unit: Unit,
    pub of: fn(&Scene<'_>) -> Option<f64>,
}

const NM: Unit = Unit {
    tail: " nm",
    ..Unit::NONE
};
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
pub(super) const OF_DOCUMENT: [OfDocument; 26] = [
    row(
        "order",
        later!("order N of the smooth part"),
        Unit::NONE,
        |s| Some(s.app.document().settings.effective_order() as f64),
    ),
    row(
        "numbers",
        later!("numbers that the model takes"),
        Unit::NONE,
        |s| Some(s.app.derived().numbers() as f64),
    ),
    row(
        "points",
        later!("points of the table within the range"),
        Unit::NONE,
        |s| Some(s.app.table_points() as f64),
    ),
    row(
        "spike_count",
        later!("bright lines that the model keeps"),
        Unit::NONE,
        |s| Some(spikes(s.app, 1.0)),
    ),
    row(
        "dip_count",
        later!("dark lines that the model keeps"),
        Unit::NONE,
        |s| Some(spikes(s.app, -1.0)),
    ),
    row(
        "spike_share",
        later!("the lines' share of the power"),
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
        later!("least share of a line, per cent"),
        Unit::NONE,
        |s| Some(s.app.document().settings.threshold_percent),
    ),
    row(
        "order_unseen",
        later!("least order from which on a difference is hard to see"),
        Unit::NONE,
        |s| hard_to_see_from(s.app).map(|order| order as f64),
    ),
    row(
        "overlay_count",
        later!("spectra compared with it"),
        Unit::NONE,
        |s| Some(s.app.document().laid_over().count() as f64),
    ),
    row(
        "delta_e_overlay",
        later!("colour difference to the first spectrum compared with it"),
        Unit::DELTA_E,
        |s| beside_overlay(s.app.document()),
    ),
    row(
        "chain_count",
        later!("things that the light meets"),
        Unit::NONE,
        |s| Some(s.app.document().products.chain.len() as f64),
    ),
    row(
        "chain_thickness",
        later!("thickness of the first of them"),
        Unit::NONE,
        |s| Some(s.app.document().products.chain.first()?.thickness),
    ),
    row(
        "chain_luminance",
        later!("share of the luminance that the chain leaves"),
        Unit::PERCENT,
        |s| chain_luminance(s.app),
    ),
    row(
        "chain_delta_e",
        later!("colour difference of the model behind the chain"),
        Unit::DELTA_E,
        |s| chain_delta_e(s.app),
    ),
    row(
        "filter_centre_nm",
        later!("where the narrow filter stands, nm"),
        Unit::NONE,
        |s| Some(s.app.document().pages.narrow.centre_nm),
    ),
    row(
        "desk_delta_e",
        later!("colour difference of the desk's mixture to its aim, equally bright"),
        Unit::DELTA_E,
        off_aim,
    ),
    row(
        "desk_rf",
        later!("Rf of the desk's mixture"),
        Unit::NONE,
        |s| desk(s)?.rf,
    ),
    row(
        "desk_ler",
        later!("efficacy of radiation of the desk's mixture"),
        LM_PER_WATT,
        |s| Some(desk(s)?.ler),
    ),
    row(
        "auction_lines",
        later!("lines that the auction keeps for its goal"),
        Unit::NONE,
        |s| lines_bought(s, s.app.document().pages.auction.goal),
    ),
    row(
        "auction_lines_for_colours",
        later!("lines that it keeps for the colours of surfaces"),
        Unit::NONE,
        |s| lines_bought(s, Goal::PATCHES),
    ),
    row(
        "filter_delta_e_model",
        later!("error of the model behind the narrow filter"),
        Unit::DELTA_E,
        |s| behind_filter(s, 0),
    ),
    row(
        "filter_delta_e_series",
        later!("error of the series alone behind it"),
        Unit::DELTA_E,
        |s| behind_filter(s, 1),
    ),
    row(
        "filter_delta_e_samples",
        later!("error of plain samples behind it"),
        Unit::DELTA_E,
        |s| behind_filter(s, 2),
    ),
    row(
        "photo_lines",
        later!("known lines that give the photograph its wavelengths"),
        Unit::NONE,
        |s| Some(lines_of(s.app).map_or(0, |best| best.matches.len()) as f64),
    ),
    row(
        "photo_left_out_nm",
        later!("error of a line of the photograph that the others foretell"),
        NM,
        |s| Some(lines_of(s.app)?.left_out_rms_nm()),
    ),
    row(
        "photo_clipped",
        later!("over-exposed lines of the photograph"),
        Unit::NONE,
        |s| {
            let peaks = s.app.photograph().map(|found| &found.peaks().peaks);
            let clipped = peaks.into_iter().flatten().filter(|peak| peak.is_clipped);
            Some(clipped.count() as f64)
        },
    ),
];

/// The lines that the photograph's axis goes by, where it is used.
fn lines_of(app: &App) -> Option<&Solution> {
    let found = app.photograph().filter(|found| found.is_by_lines())?;
    found.used_curve()?;
    found.answer.as_ref()?.best.as_ref()
}

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
