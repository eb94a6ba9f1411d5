//! What a person wants to know of a model at first sight, in words and few figures: can one see
//! the difference, how few numbers are they, from which order on is it hard to see.

use super::{
    document::FIRST_PATCH_SET,
    line_names::LineName,
    readings::{COUNTS, is_counts},
    settings::{Detector, Settings},
    state::App,
    ticks::short,
    tint,
    verdicts::{HARD_TO_SEE, Seen},
};
use crate::{
    color::{xyz_of_lines, xyz_of_one, xyz_of_parts},
    languages::{fixed, signed},
    spectrum::{Basis, Line, detect},
    study::{Measure, Sweep, SweepPoint, Verdict},
};

/// The largest difference of those that the verdict is about: of the patches where there are, else
/// of the spectrum's own colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// CIEDE2000.
    pub delta_e_2000: f64,
    /// The patch; `None` for the spectrum itself.
    pub patch: Option<String>,
}

impl Worst {
    /// Of the present model; `None` where there is no colour.
    pub fn of(app: &App) -> Option<Self> {
        let derived = app.derived();
        let patches = derived.patches.as_ref();
        let patch = patches.and_then(|patches| patches.items.get(patches.worst));
        let of_patch = patch.map(|patch| patch.delta_e_2000);
        Some(Self {
            delta_e_2000: of_patch.or(derived.colour.delta_e_2000)?,
            patch: patch.map(|patch| app.document().patch_called(&patch.name).to_owned()),
        })
    }
}

/// What colours are judged by, or why none are: counts have no colour, and without visible light
/// there is none.
pub fn judged(app: &App) -> Result<Worst, &'static str> {
    let document = app.document();
    if is_counts(document.subject_entry()) || is_counts(&document.light) {
        return Err(COUNTS);
    }
    Worst::of(app).ok_or(later!(
        "No visible light in this range: there is no colour to compare."
    ))
}

/// The verdict on the model, with its subject: "Model and light look alike".
pub fn verdict_alone(app: &App, seen: Seen) -> String {
    seen.verdict(app.document().subject_entry().kind())
}

/// The same with what it was judged on: "Model and light look alike, judged on 24 shipped surfaces".
pub fn verdict(app: &App, seen: Seen) -> String {
    tr!(
        "{verdict}, judged {judged_on}",
        verdict = verdict_alone(app, seen),
        judged_on = judged_on(app)
    )
}

/// What the verdict was judged on: "on 24 shipped surfaces", "on 26 surfaces, 2 of them your own".
/// A set other than the first is named.
pub fn judged_on(app: &App) -> String {
    let (document, derived) = (app.document(), app.derived());
    let Some(patches) = &derived.patches else {
        return said!("on its own colour alone").to_owned();
    };
    let set = document.patch_set.as_str();
    let count = patches.items.len();
    match (document.patches_of_own().count(), set == FIRST_PATCH_SET) {
        (0, true) => tr!("on {n} shipped surface" | "on {n} shipped surfaces" % count),
        (0, false) => tr!(
            "on {n} shipped surface ({set})" | "on {n} shipped surfaces ({set})" % count,
            set = set_title(set)
        ),
        (own, true) => tr!(
            "on {n} surface, {own} of them your own"
                | "on {n} surfaces, {own} of them your own" % count,
            own
        ),
        (own, false) => tr!(
            "on {n} surface ({set}), {own} of them your own"
                | "on {n} surfaces ({set}), {own} of them your own" % count,
            set = set_title(set),
            own
        ),
    }
}

/// The same behind "at worst": "of 24", nothing where there are no patches.
pub fn of_how_many(app: &App) -> String {
    let patches = app.derived().patches.as_ref();
    patches.map_or_else(String::new, |patches| {
        tr!(" of {count}", count = patches.items.len())
    })
}

/// A patch set's short title, for menus and behind a verdict.
pub fn set_title(id: &str) -> String {
    let known = match id {
        FIRST_PATCH_SET => said!("24 surfaces"),
        "tm30_ces99_5nm" => said!("TM-30, 99 samples"),
        "cri_tcs" => said!("CRI test colours"),
        "nist_cqs_vs" => said!("NIST CQS samples"),
        "pmc_chart" => said!("Memory colours"),
        "aces_training_190" => "AMPAS 190",
        "metals_refractiveindex" => said!("Metals"),
        "usgs_splib07" => said!("USGS materials"),
        "filters_glass_cc0" => said!("Filter glasses"),
        other => other,
    };
    known.to_owned()
}

/// What white the light is: of all that its table has in 360-830 nm, as the pages of Quality tell it,
/// whatever the model's range leaves out. `None` for what is none, or no light.
pub fn white_words(app: &App) -> Option<String> {
    let colour = &app.derived().colour;
    let cct = colour.full.or(colour.exact)?.cct?.ok()?;
    Some(tint::title_words(cct))
}

/// The least order from which on a difference is hard to see on every patch; `None` where there is
/// none.
pub fn hard_to_see_from(app: &App) -> Option<usize> {
    let curve = &app.derived().curve;
    let seen = |point: &&crate::app::derived::OrderPoint| {
        let worst = point.figures[Measure::PatchesWorst].or(point.figures[Measure::Own]);
        worst.is_none_or(|error| error >= HARD_TO_SEE)
    };
    match curve.iter().rfind(seen) {
        None => curve.first().map(|point| point.order),
        Some(last) => {
            let mut higher = curve.iter().map(|point| point.order);
            higher.find(|order| *order > last.order)
        }
    }
}

/// A spike of the model as it is read out while it is pointed at or dragged: where it stands, after
/// what it is named, its weight, its share of the power, and what it adds to the light's Y of 100.
pub fn spike_words(app: &App, spike: Line, name: &LineName) -> String {
    let derived = app.derived();
    let name = name.safe.as_deref();
    let name = name.map_or_else(String::new, |name| format!(" ({name})"));
    let weight = short(three(app.scale_factor() * spike.weight));
    let unit = match app.unit() {
        "" => "nm".to_owned(),
        unit => format!("{unit} x nm"),
    };
    let mut words = tr!(
        "line {at_nm} nm{name}   {weight} {unit}",
        at_nm = fixed(spike.at_nm, 1),
        name,
        weight,
        unit
    );
    if let Some(share) = derived.parts.share(spike.weight) {
        words += &tr!("   {share} % of the power", share = fixed(100.0 * share, 1));
    }
    let weights = &app.tables().viewing.weights;
    let white = if app.document().is_about_light() {
        xyz_of_parts(derived.band, &derived.measured, &[], weights).y
    } else {
        xyz_of_one(derived.band, weights).y
    };
    let adds = 100.0 * xyz_of_lines(&[spike], weights).y / white;
    if adds.is_finite() {
        words += &tr!("   adds {adds} % of the brightness", adds = signed(adds, 1));
    }
    words
}

/// A value in three digits.
fn three(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let step = 10_f64.powf(value.abs().log10().floor() - 2.0);
    (value / step).round() * step
}

/// Thresholds that the slider of lines reaches, per cent of the power.
pub const LINE_THRESHOLDS: [f64; 2] = [0.1, 20.0];

/// Shares of the power of every line that the slider can let in, per cent, largest first.
pub fn line_shares(app: &App) -> Vec<f64> {
    let settings = app.document().settings;
    if settings.detector != Detector::Energy {
        return Vec::new();
    }
    let lowest = Settings {
        threshold_percent: LINE_THRESHOLDS[0],
        ..settings
    };
    let derived = app.derived();
    let found = detect(derived.band, &derived.measured, lowest.spike_settings());
    let share = |weight: f64| 100.0 * weight.abs() / found.power;
    let shares = found.spikes.iter().map(|found| share(found.spike.weight));
    let mut shares: Vec<f64> = shares.filter(|share| share.is_finite()).collect();
    shares.sort_by(|a, b| b.total_cmp(a));
    shares
}

/// The threshold above which as many of the lines stay as were asked for, or as nearly as many as
/// there is a threshold for, per cent: moving it can part or join lines.
pub fn threshold_for(app: &App, shares: &[f64], count: usize) -> f64 {
    let (settings, derived) = (app.document().settings, app.derived());
    let off = |threshold_percent: f64| {
        let settings = Settings {
            threshold_percent,
            ..settings
        };
        let found = detect(derived.band, &derived.measured, settings.spike_settings());
        found.spikes.len().abs_diff(count)
    };
    let asked = between(shares, count);
    let others = (0..=shares.len()).map(|count| between(shares, count));
    // Of equals the one that was asked for.
    let nearest = std::iter::once(asked).chain(others).min_by_key(|t| off(*t));
    nearest.unwrap_or(asked)
}

/// A threshold between the shares of so many lines and of the others, per cent.
fn between(shares: &[f64], count: usize) -> f64 {
    let [lowest, highest] = LINE_THRESHOLDS;
    let least_in = count.checked_sub(1).and_then(|i| shares.get(i));
    let most_out = shares.get(count);
    match (least_in, most_out) {
        (Some(inside), Some(outside)) => (inside * outside).sqrt(),
        (Some(inside), None) => (0.8 * inside).min(0.5),
        (None, Some(outside)) => 1.2 * outside,
        (None, None) => 0.5,
    }
    .clamp(lowest, highest)
}

/// The best model of a sweep with at most so many numbers, up to the last order of each basis that
/// draws no noise, and the error that it is best by; `None` where nothing fits.
pub fn best_of(
    sweep: &Sweep,
    numbers: usize,
    last_order: impl Fn(Basis) -> Option<usize>,
) -> Option<(&SweepPoint, Measure)> {
    let is_light = |point: &&SweepPoint| {
        let last = last_order(point.way.basis);
        last.is_none_or(|last| point.order <= last)
    };
    let affordable = || {
        let within = sweep.points.iter().filter(|point| point.numbers <= numbers);
        within.filter(is_light)
    };
    let measures = [Measure::Patches, Measure::Own, Measure::RmsBlurred];
    measures.into_iter().find_map(|measure| {
        let known = affordable().filter_map(|point| Some((point, point.verdict[measure]?)));
        // Equal colours: the one whose spectrum is nearer.
        let best = known.min_by(|(a, one), (b, other)| {
            let near = |v: &Verdict| v[Measure::RmsBlurred].unwrap_or(f64::MAX);
            let equal = (one - other).abs() < 1e-6;
            match equal {
                true => near(&a.verdict).total_cmp(&near(&b.verdict)),
                false => one.total_cmp(other),
            }
        });
        Some((best?.0, measure))
    })
}

/// The knobs of a model of a sweep.
pub fn knobs_of(settings: Settings, point: &SweepPoint) -> Settings {
    Settings {
        basis: point.way.basis,
        colour_exact: point.way.colour_exact,
        spikes: point.way.spikes,
        // The count was that of ideal lines.
        wide_lines: false,
        order: point.order,
        ..settings
    }
}

/// The knobs of the paper: plain Fourier series on 400 to 700 nm where the table reaches.
pub fn as_in_the_paper(app: &App) -> Settings {
    let settings = app.document().settings;
    let samples = &app.document().subject_entry().spectrum.samples;
    let reaches = samples.first_nm() <= 400.0 && samples.last_nm() >= 700.0;
    let band = crate::spectrum::Band::new(400.0, 700.0).ok();
    Settings {
        wide_lines: false,
        detector: Detector::Gradient,
        gradient_percent: Settings::default().gradient_percent,
        sampling: crate::spectrum::Sampling::Paper,
        band: band.filter(|_| reaches).unwrap_or(settings.band),
        ..settings.as_in_paper()
    }
}

/// "4 lines, above 0.5 %".
pub fn lines_words(app: &App) -> String {
    let settings = app.document().settings;
    if !settings.spikes {
        return said!("off").to_owned();
    }
    if app.document().as_given().is_some() {
        return said!("as given, without a search").to_owned();
    }
    match settings.detector {
        Detector::Energy => tr!(
            "above {share} % of the power",
            share = short(settings.threshold_percent)
        ),
        Detector::Gradient => tr!(
            "steeper than {share} % per nm",
            share = short(settings.gradient_percent)
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{Command, showing};

    #[test]
    fn the_white_beside_the_verdict_is_that_of_the_page_quality_on_any_range() {
        let mut app = App::new();
        for [first, last] in [[380, 780], [430, 640]] {
            let settings = Settings {
                band: crate::spectrum::Band::new(f64::from(first), f64::from(last))
                    .expect("a range"),
                ..app.document().settings
            };
            app.apply(Command::Edit(settings));
            let white = white_words(&app).expect("a white");
            let place = crate::app::QualityShown::of(&app).place;
            assert!(
                place.starts_with(&format!("FL2: {white} (")),
                "{place}, {white}"
            );
        }
    }

    #[test]
    fn a_verdict_says_which_surfaces_it_was_judged_on_and_how_many() {
        let mut app = App::new();
        let said = verdict(&app, Seen::Hardly);
        assert_eq!(
            said,
            "Model and light look alike, judged on 24 shipped surfaces"
        );
        assert_eq!(of_how_many(&app), " of 24");
        app.apply(Command::PatchSet("cri_tcs".to_owned()));
        let count = app.derived().patches.as_ref().expect("a light").items.len();
        let expected = format!("on {count} shipped surfaces (CRI test colours)");
        assert_eq!(judged_on(&app), expected);
        let of_surface = showing("colorchecker_ohta/red");
        assert_eq!(judged_on(&of_surface), "on its own colour alone");
        assert_eq!(of_how_many(&of_surface), "");
        // The menu's words are those of the set, whose count they name.
        let first = crate::app::Library::bundled().group(FIRST_PATCH_SET);
        let first = first.expect("shipped").items.len();
        assert_eq!(set_title(FIRST_PATCH_SET), format!("{first} surfaces"));
    }
}
