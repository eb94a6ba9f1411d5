//! The paper's mathematics on the document: its harmonics, and its claims measured again.
//!
//! Claims are measured in the basis, range and order in force. Products (Eq. 16 and 17) need a
//! light and a factor: for a light the factor is the chosen patch, or one that is worth looking
//! at; for a reflectance the factor is the subject, and the light is taken apart with the same
//! knobs.

use std::fmt::Write as _;

use crate::{
    app::{
        cells::{line, words},
        export::provenance,
        state::App,
        tables::Viewing,
        ticks::short,
    },
    color::{Observer, Xyz, xy_from_xyz},
    io::write::one_line,
    spectrum::{
        Band, Basis, Composite, Sampling, Series, basis::numbers_of_order, spikes::detect_shapes,
    },
    study::{
        harmonics::{Harmonics, Question},
        truth::{
            self, Eq17, FivePercent, Match, Resampling, ResamplingWay, STATED_LINE_NM,
            STATED_ORDER, STATED_SHARE, SamplesAgainstNumbers, StraightLine, Table2,
        },
    },
};

/// X, Y and Z in words.
pub const CHANNELS: [&str; 3] = ["X", "Y", "Z"];

/// The subject's coefficients beside those of what weighs it, to the highest order in the tables.
///
/// They are those of the plain fit: a colour-exact model corrects the lowest ones a little.
pub fn harmonics_of(app: &App) -> Harmonics {
    let (document, derived, tables) = (app.document(), app.derived(), app.tables());
    let numbers = tables.basis.numbers();
    Harmonics::of(Question {
        table: &tables.basis,
        coefficients: &tables.basis.project(&derived.parts.smooth, numbers),
        spikes: &derived.model.spikes,
        measured: &derived.measured,
        weights: &tables.viewing.weights,
        plain_colour_matching: document.is_about_light()
            && document.settings.observer == Observer::Cie1931,
    })
}

/// All that the claims come to on a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Claims {
    /// Name of the spectrum that was measured.
    pub subject: String,
    /// Name of the light in products and of Table 2.
    pub light: String,
    /// Whether that light is zero over the whole range.
    pub light_is_dark: bool,
    /// Name of the factor in products; `None` without one.
    pub factor: Option<String>,
    /// Range.
    pub band: Band,
    /// Functions of the smooth part.
    pub basis: Basis,
    /// Order in force.
    pub order: usize,
    /// Whose colour-matching functions.
    pub observer: Observer,
    /// Coefficients and sums.
    pub harmonics: Harmonics,
    /// Terms beyond N.
    pub five_percent: FivePercent,
    /// Samples against numbers; `None` for an all-zero spectrum.
    pub samples: Option<SamplesAgainstNumbers>,
    /// The factor at the light's spikes; `None` without a factor.
    pub eq_17: Option<Eq17>,
    /// The paper's own range and order with the green mercury line.
    pub worked: Option<StraightLine>,
    /// Table 2 under the light.
    pub table_2: Table2,
    /// Products on few points; `None` without a factor.
    pub resampling: Option<Resampling>,
    /// Eq. 7 as printed and corrected; `None` for the cosine basis, or where there is no colour.
    pub eq_7: Option<Eq7>,
}

/// Chromaticity x, y of the model at the order in force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eq7 {
    /// Of the spectrum itself.
    pub exact: [f64; 2],
    /// By Eq. 7 with `a0 A0 / 2`.
    pub corrected: [f64; 2],
    /// By Eq. 7 with `a0 A0 / 4`, as printed; `None` where that is no colour.
    pub printed: Option<[f64; 2]>,
    /// The lowest of X, Y and Z as printed, as a share of the exact Y: negative is no colour.
    pub lowest_printed: f64,
}

impl Claims {
    /// Measures every claim.
    pub fn of(app: &App) -> Self {
        let (document, derived, tables) = (app.document(), app.derived(), app.tables());
        let (settings, band) = (document.settings, derived.band);
        let harmonics = harmonics_of(app);
        let product = Product::of(app);
        let order = derived.model.smooth.order();
        let lines = detect_shapes(band, &derived.measured, settings.spike_settings()).1;
        let light = document.light.on_band(band);
        Self {
            subject: document.subject_entry().name().to_owned(),
            light: document.light.name().to_owned(),
            light_is_dark: light.iter().all(|v| *v == 0.0),
            factor: product.as_ref().map(|p| p.name.clone()),
            band,
            basis: settings.basis,
            order,
            observer: settings.observer,
            five_percent: truth::five_percent(&harmonics),
            samples: truth::samples(truth::Question {
                table: &tables.basis,
                blur: &tables.blur,
                measured: &derived.measured,
                lines: &lines,
                weights: &tables.viewing.weights,
                white: white(app),
            }),
            eq_17: product
                .as_ref()
                .map(|p| truth::eq_17(&p.light, &p.factor, &tables.basis, &p.weights, p.white)),
            worked: truth::straight_line(
                Band::PAPER,
                STATED_ORDER.figure as usize,
                STATED_LINE_NM.figure,
            ),
            table_2: truth::table_2(band, settings.observer, &light),
            resampling: product.as_ref().map(|p| {
                truth::resampling(&p.light, &p.factor, &tables.basis, &p.weights, p.white)
            }),
            eq_7: Eq7::of(&harmonics, order),
            harmonics,
        }
    }

    /// The way of a resampling, where it was measured.
    pub fn way(&self, sampling: Sampling) -> Option<ResamplingWay> {
        let ways = &self.resampling.as_ref()?.ways;
        ways.iter().copied().find(|way| way.sampling == sampling)
    }
}

impl Eq7 {
    /// The sums to an order in both readings; spikes are weighed where they stand in both.
    fn of(harmonics: &Harmonics, order: usize) -> Option<Self> {
        if harmonics.basis != Basis::Fourier {
            return None;
        }
        let (first, at) = (harmonics.orders.first()?, harmonics.orders.get(order)?);
        // The corrected term of order 0 is L/2 a0 A0/2; the printed one is half of that.
        let printed: [f64; 3] =
            std::array::from_fn(|k| at.running[k] - 0.5 * first.contribution[k]);
        let xy = |xyz: [f64; 3]| xy_from_xyz(Xyz::from_array(xyz));
        let lowest = printed.iter().copied().fold(f64::INFINITY, f64::min);
        Some(Self {
            exact: xy(harmonics.exact)?,
            corrected: xy(at.running)?,
            printed: xy(printed),
            lowest_printed: lowest / harmonics.exact[1],
        })
    }
}

/// XYZ of the exact light by the weights in force: the white.
fn white(app: &App) -> Xyz {
    let (derived, weights) = (app.derived(), &app.tables().viewing.weights);
    Xyz::from_array(std::array::from_fn(|k| {
        if app.document().is_about_light() {
            derived.band.inner(&derived.measured, &weights[k])
        } else {
            // The weights are the light's already: a perfect reflector is their own integral.
            derived.band.integral(&weights[k])
        }
    }))
}

/// A light and a factor to multiply.
struct Product {
    name: String,
    light: Composite,
    factor: Vec<f64>,
    weights: [Vec<f64>; 3],
    white: Xyz,
}

impl Product {
    fn of(app: &App) -> Option<Self> {
        let (document, derived) = (app.document(), app.derived());
        let (band, observer) = (derived.band, document.settings.observer);
        let weights = Viewing::of_light(band, observer).weights;
        let values = document.light.on_band(band);
        let white = Xyz::from_array(std::array::from_fn(|k| band.inner(&values, &weights[k])));
        let (name, light, factor) = if document.is_about_light() {
            let (name, factor) = patch_of(app)?;
            (name, derived.model.clone(), factor)
        } else {
            let name = document.subject_entry().name().to_owned();
            (name, model_of(app, &values), derived.measured.clone())
        };
        Some(Self {
            name,
            light,
            factor,
            weights,
            white,
        })
    }
}

/// A light taken apart and fitted as the document's knobs say, without hand edits.
fn model_of(app: &App, values: &[f64]) -> Composite {
    let (settings, band) = (app.document().settings, app.derived().band);
    let table = &app.tables().basis;
    let (smooth, spikes) = if settings.spikes {
        let (parts, lines) = detect_shapes(band, values, settings.spike_settings());
        let mut spikes: Vec<_> = lines.iter().map(|line| line.spike).collect();
        spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        (parts.smooth, spikes)
    } else {
        (values.to_vec(), Vec::new())
    };
    Composite {
        smooth: Series {
            band,
            basis: settings.basis,
            coefficients: table.project(&smooth, numbers_of_order(settings.effective_order())),
        },
        spikes,
    }
}

/// The chosen patch, else the one called orange (steep in the middle of the visible), else the
/// one that varies most.
fn patch_of(app: &App) -> Option<(String, Vec<f64>)> {
    let patches = app.tables().patches.as_ref()?;
    let names = patches.set.names();
    let variation = |values: &Vec<f64>| {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
    };
    let most_varied = || {
        let all = patches.reflectances.iter().enumerate();
        all.max_by(|(_, a), (_, b)| variation(a).total_cmp(&variation(b)))
            .map(|(index, _)| index)
    };
    let index = app
        .document()
        .patch
        .or_else(|| {
            names
                .iter()
                .position(|name| name.eq_ignore_ascii_case("orange"))
        })
        .or_else(most_varied)?;
    let (name, values) = (names.get(index)?, patches.reflectances.get(index)?);
    Some((name.clone(), values.clone()))
}

// ------------------------------------------------------------------------------ the table

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is so here.
    Holds,
    /// It is so here under a condition that the paper does not name.
    OnlyIf,
    /// It is not so here.
    Fails,
    /// There is nothing to measure here.
    Open,
}

impl Verdict {
    /// The verdict in words; a condition follows `OnlyIf` and `Open`.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::OnlyIf => "holds only",
            Self::Fails => "does not hold",
            Self::Open => "nothing to measure",
        }
    }

    /// A sign of its own, so that colour never says it alone.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Holds => "✔",
            Self::OnlyIf => "◐",
            Self::Fails => "✘",
            Self::Open => "○",
        }
    }
}

/// A claim, what the paper says, what is measured here, and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The claim in a few words.
    pub claim: &'static str,
    /// Where the paper makes it.
    pub place: &'static str,
    /// What the paper says.
    pub paper: String,
    /// What is measured on this spectrum and range, a sentence or more.
    pub measured: String,
    /// What became of it.
    pub verdict: Verdict,
    /// Under which condition, or why; may be empty.
    pub condition: String,
}

impl Row {
    /// The verdict with its condition.
    pub fn verdict_words(&self) -> String {
        match (self.verdict, self.condition.is_empty()) {
            (verdict, true) => verdict.words().to_owned(),
            (Verdict::OnlyIf, false) => format!("holds only {}", self.condition),
            (verdict, false) => format!("{}: {}", verdict.words(), self.condition),
        }
    }
}

/// Every claim as a row, in the paper's order.
pub fn truth_table(claims: &Claims) -> Vec<Row> {
    vec![
        eq_7_row(claims),
        five_percent_row(claims),
        table_2_row(claims),
        resampling_row(claims),
        eq_17_row(claims),
        samples_row(claims),
    ]
}

/// The table as CSV: comment lines that say where it comes from, then
/// `claim,paper,measured,verdict`.
pub fn truth_csv(app: &App, claims: &Claims) -> String {
    let mut out = String::new();
    for (key, value) in provenance(app).of(&app.document().subject_entry().spectrum) {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "# {key}: {value}");
    }
    if let Some(factor) = &claims.factor {
        let _ = writeln!(
            out,
            "# products: {} x {}",
            one_line(&claims.light),
            one_line(factor)
        );
    }
    out.push_str("claim,paper,measured,verdict\n");
    for row in truth_table(claims) {
        let paper = format!("{} ({})", row.paper, row.place);
        let cells = [row.claim, &paper, &row.measured, &row.verdict_words()].map(words);
        out.push_str(&line(cells));
    }
    out
}

/// A figure in three digits, or a dash.
pub fn figure(value: impl Into<Option<f64>>) -> String {
    let sound = value.into().filter(|v| v.is_finite());
    sound.map_or_else(|| "–".to_owned(), |v| short(three_digits(v)))
}

/// A share in percent, or a dash; what is left of rounding is told as a bound.
pub fn percent(share: impl Into<Option<f64>>) -> String {
    match share.into().filter(|s| s.is_finite()) {
        Some(share) if share.abs() < ROUNDING => "0".to_owned(),
        Some(share) => figure(100.0 * share),
        None => "–".to_owned(),
    }
}

/// Shares below this are the rounding of sums, not of a model.
const ROUNDING: f64 = 1e-10;

/// A colour difference: what is below any meaning is told as a bound.
pub fn delta_e(value: impl Into<Option<f64>>) -> String {
    match value.into().filter(|v| v.is_finite()) {
        Some(small) if small < 0.0005 => "below 0.001".to_owned(),
        other => figure(other),
    }
}

fn three_digits(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// What is missing of a total as how far a sum is off it: in percent, with a sign.
pub fn off_percent(missing: f64) -> String {
    let words = percent(-missing);
    if missing < -ROUNDING {
        format!("+{words}")
    } else {
        words
    }
}

/// Three figures in a row: `0.1, 0.2 and 0.3`.
pub fn three(words: [String; 3]) -> String {
    let [x, y, z] = words;
    format!("{x}, {y} and {z}")
}

fn range(band: Band) -> String {
    format!("{}-{} nm", short(band.min_nm()), short(band.max_nm()))
}

// ---------------------------------------------------------------------------- claim by claim

fn five_percent_row(claims: &Claims) -> Row {
    let stated = STATED_ORDER.figure as usize;
    let channels = claims.five_percent.channels;
    let row = |measured: String, verdict, condition: &str| Row {
        claim: "Eleven numbers are enough",
        place: STATED_ORDER.place,
        paper: format!(
            "On 400-700 nm, with N = {stated}, the first term left out is below {} % and the \
             following vanish rapidly.",
            percent(STATED_SHARE.figure)
        ),
        measured,
        verdict,
        condition: condition.to_owned(),
    };
    if is_all_in_spikes(claims) {
        return row(String::new(), Verdict::Open, ALL_IN_SPIKES);
    }
    let Some(left_out) = all(channels.map(|c| c.at_stated_order)) else {
        return row(String::new(), Verdict::Open, &no_colour_or_short(claims));
    };
    let mut measured = format!(
        "Summed to N = {stated}, X, Y and Z are off by {} %; the largest single terms left out are \
         {} %.",
        three(left_out.map(|l| off_percent(l.tail))),
        three(left_out.map(|l| percent(l.largest_term))),
    );
    if claims.harmonics.orders.iter().any(|o| o.bound.is_some()) {
        let _ = write!(
            measured,
            " On {} the corrected Eq. 12 promises terms below 5 % from n = {} on (as printed \
             {}).",
            range(claims.band),
            three(channels.map(|c| c.promised.to_string())),
            three(channels.map(|c| c.promised_as_printed.to_string())),
        );
    } else if claims.basis == Basis::Fourier {
        measured.push_str(" Eq. 12 is about the CIE 1931 functions alone: no bound here.");
    } else {
        measured.push_str(" Eq. 12 is about the Fourier basis; for cosines there is no bound.");
    }
    let limit = STATED_SHARE.figure;
    let small = |l: &truth::Neglected| l.tail.abs() < limit && l.largest_term < limit;
    let premise = claims.harmonics.slowest_fall;
    if left_out.iter().all(small) {
        let condition = match premise.filter(|p| !p.meets_eq_11()) {
            Some(slow) => format!(
                "by measurement, not by Eq. 12, as the light does not fall like 1/n (at n = {} it \
                 is {} times |a0|/n)",
                slow.order,
                figure(slow.fall)
            ),
            None => String::new(),
        };
        return row(measured, Verdict::Holds, &condition);
    }
    match all(channels.map(|c| c.sufficient_order)) {
        Some(orders) => {
            let order = orders.into_iter().max().unwrap_or(stated).max(stated);
            let condition = if order > stated {
                format!("from N = {order} on ({} numbers)", numbers_of_order(order))
            } else {
                "for the sum: a single term left out is larger".to_owned()
            };
            row(measured, Verdict::OnlyIf, &condition)
        }
        None => row(
            measured,
            Verdict::Fails,
            &format!(
                "no order up to {} is enough",
                claims.five_percent.highest_order
            ),
        ),
    }
}

fn no_colour_or_short(claims: &Claims) -> String {
    if claims.harmonics.exact.iter().any(|v| *v <= 0.0) {
        NO_COLOUR.to_owned()
    } else {
        format!(
            "this range carries orders up to {} only",
            claims.five_percent.highest_order
        )
    }
}

/// Why a spectrum has no X, Y, Z to add up to.
const NO_COLOUR: &str = "X, Y and Z are not all positive in this range";

/// Why a claim about the smooth part says nothing.
const ALL_IN_SPIKES: &str = "the smooth part is zero: all of it is in the spikes";

/// Whether nothing is left for the smooth part.
fn is_all_in_spikes(claims: &Claims) -> bool {
    claims.harmonics.numbers.iter().all(|n| n.light == 0.0)
}

fn all<T: Copy>(three: [Option<T>; 3]) -> Option<[T; 3]> {
    let [x, y, z] = three;
    Some([x?, y?, z?])
}

fn samples_row(claims: &Claims) -> Row {
    let row = |measured: String, verdict, condition: String| Row {
        claim: "20 numbers instead of 400 samples",
        place: truth::STATED_SAMPLES.place,
        paper: format!(
            "From 380 to 780 nm at least {} samples to avoid missing any spikes, or about {} \
             numbers: {} for the background and {} for the spikes.",
            truth::STATED_SAMPLES.figure,
            truth::STATED_NUMBERS.figure,
            truth::STATED_BACKGROUND.figure,
            truth::STATED_SPIKE_NUMBERS.figure,
        ),
        measured,
        verdict,
        condition,
    };
    let Some(found) = &claims.samples else {
        let why = "the spectrum is zero over the whole range".to_owned();
        return row(String::new(), Verdict::Open, why);
    };
    let numbers = found.numbers();
    let both = |m: Match| {
        let (surely, best) = (m.surely.samples, m.at_best.samples);
        if surely == best {
            surely.to_string()
        } else {
            format!("{surely} ({best} where they happen to fall well)")
        }
    };
    let errors = found.composite;
    let needed = &found.needed;
    let of_colour = errors.own.map_or_else(String::new, |own| {
        format!(" an own colour off by ΔE00 {},", delta_e(own))
    });
    let for_colour = needed
        .own
        .map_or_else(String::new, |own| format!(" own colour {},", both(own)));
    let measured = format!(
        "{numbers} numbers ({} for the background, {} for {}) leave{of_colour} rms {} % at 1 nm \
         (where a line of some width counts as missed by its spike) and {} % behind 10 nm. \
         Samples joined by straight lines that do as well:{for_colour} rms {}, behind 10 nm {}.",
        found.background,
        2 * found.spikes,
        count(found.spikes, "spike"),
        percent(errors.relative_rms),
        percent(errors.relative_rms_10nm),
        both(needed.relative_rms),
        both(needed.relative_rms_10nm),
    );
    let judged = [
        ("own colour", needed.own),
        ("the spectrum at 1 nm", Some(needed.relative_rms)),
        ("the spectrum behind 10 nm", Some(needed.relative_rms_10nm)),
    ];
    let judged: Vec<(&str, bool)> = judged
        .into_iter()
        // A count that does as well where the samples happen to fall well is no proof.
        .filter_map(|(what, m)| Some((what, m?.at_best.samples > numbers)))
        .collect();
    let good: Vec<&str> = judged.iter().filter(|j| j.1).map(|j| j.0).collect();
    let (verdict, condition) = if good.len() == judged.len() {
        (
            Verdict::Holds,
            format!("more than {numbers} samples are needed for the same"),
        )
    } else if good.is_empty() {
        (
            Verdict::Fails,
            format!("{numbers} samples or fewer do as well here"),
        )
    } else {
        (Verdict::OnlyIf, format!("for {}", good.join(" and ")))
    };
    row(measured, verdict, condition)
}

/// `1 spike`, `2 spikes`.
pub fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn eq_17_row(claims: &Claims) -> Row {
    let mut measured = String::new();
    if let Some(worked) = claims.worked {
        let _ = write!(
            measured,
            "On 400-700 nm with N = 5 a straight line read at {} nm gives {:.1} nm as printed and \
             {:.1} nm corrected.",
            worked.at_nm, worked.printed_nm, worked.corrected_nm
        );
    }
    let mut condition = "with its two weights exchanged".to_owned();
    if let (Some(found), Some(factor)) = (&claims.eq_17, &claims.factor) {
        if found.readings.is_empty() {
            let _ = write!(measured, " {} has no spikes to read it at.", claims.light);
        } else if let (Some(printed), Some(linear)) = (found.printed_cost, found.linear_cost) {
            let _ = write!(
                measured,
                " At the {} of {} on {factor} it costs ΔE00 {} as printed and {} corrected, \
                 against the series read exactly.",
                count(found.readings.len(), "spike"),
                claims.light,
                delta_e(printed),
                delta_e(linear),
            );
            if linear > NOTICEABLE_COST {
                condition.push_str(", and the straight line itself still costs colour here");
            }
        }
    }
    Row {
        claim: "The factor at a spike, by a straight line",
        place: "Eq. 17",
        paper: "The factor at a spike is read by linear interpolation between the two points \
                around it."
            .to_owned(),
        measured: measured.trim_start().to_owned(),
        verdict: Verdict::OnlyIf,
        condition,
    }
}

/// Three decimals with a sign, and no minus before zero.
fn thousandths(value: f64) -> String {
    let rounded = (1000.0 * value).round() / 1000.0;
    if rounded == 0.0 {
        "0.000".to_owned()
    } else {
        format!("{rounded:+.3}")
    }
}

/// Colour differences from here on are worth a word.
const NOTICEABLE_COST: f64 = 1.0;

fn table_2_row(claims: &Claims) -> Row {
    let found = claims.table_2;
    let off = three(
        found
            .worst
            .map(|d| format!("{} at {} nm", thousandths(d.off()), short(d.at_nm))),
    );
    let mut measured = format!("The largest deviations of x-bar, y-bar and z-bar are {off}.");
    if claims.observer != Observer::Cie1931 {
        let _ = write!(
            measured,
            " The fit was made for CIE 1931; the observer in force is {}.",
            claims.observer.title()
        );
    }
    let (verdict, condition) = match found.delta_uv.zip(found.delta_e_2000) {
        Some((uv, colour)) => {
            let _ = write!(
                measured,
                " Used for colour it would move {} by Δu'v' {} (ΔE00 {}).",
                claims.light,
                figure(uv),
                delta_e(colour)
            );
            if colour < NOTICEABLE_COST {
                (Verdict::Holds, String::new())
            } else {
                let why = "for the shape of the functions, not for colour".to_owned();
                (Verdict::OnlyIf, why)
            }
        }
        None => (
            Verdict::Open,
            "there is no visible light in this range".to_owned(),
        ),
    };
    Row {
        claim: "Bells for the colour-matching functions",
        place: "Eq. 9, Table 2, Figure 2",
        paper: "Four Gaussian bells show a good correspondence with the CIE colour-matching \
                functions."
            .to_owned(),
        measured,
        verdict,
        condition,
    }
}

fn resampling_row(claims: &Claims) -> Row {
    let order = claims.order;
    let row = |measured: String, verdict, condition: String| Row {
        claim: "A product on 2N+2 points",
        place: "Eq. 15, 16",
        paper: format!(
            "2N + 2 sample points avoid information loss, so a product of two smooth spectra \
             takes {} multiplications.",
            truth::stated_multiplications(order).figure
        ),
        measured,
        verdict,
        condition,
    };
    let (Some(factor), Some(paper)) = (&claims.factor, claims.way(Sampling::Paper)) else {
        let why = "there is no factor to multiply with".to_owned();
        return row(String::new(), Verdict::Open, why);
    };
    let mut measured = format!(
        "{} x {factor}, both cut to N = {order}: {} independent points fold {} % of the product's \
         power into lower orders and cost ΔE00 {}.",
        claims.light,
        paper.points,
        percent(paper.folded_share),
        delta_e(paper.delta_e_2000),
    );
    let others = claims.resampling.iter().flat_map(|r| r.ways.iter().skip(1));
    let others: Vec<String> = others
        .map(|way| format!("{} points ΔE00 {}", way.points, delta_e(way.delta_e_2000)))
        .collect();
    if !others.is_empty() {
        let _ = write!(measured, " {}.", others.join(", "));
    }
    if is_all_in_spikes(claims) {
        return row(String::new(), Verdict::Open, ALL_IN_SPIKES.to_owned());
    }
    if claims.light_is_dark {
        let why = "the light is zero over the whole range".to_owned();
        return row(String::new(), Verdict::Open, why);
    }
    if paper.folded_share.is_nan() || paper.folded_share < ROUNDING {
        return row(measured, Verdict::Holds, String::new());
    }
    let condition = match paper.delta_e_2000 {
        Some(cost) => format!(
            "roughly: the product has order 2N, and here that costs ΔE00 {}",
            delta_e(cost)
        ),
        None => "roughly: the product has order 2N".to_owned(),
    };
    row(measured, Verdict::OnlyIf, condition)
}

fn eq_7_row(claims: &Claims) -> Row {
    let row = |measured: String, verdict, condition: &str| Row {
        claim: "X, Y, Z from the coefficients",
        place: "Eq. 7",
        paper: "The sum of the products of the coefficients, that of order 0 divided by 4."
            .to_owned(),
        measured,
        verdict,
        condition: condition.to_owned(),
    };
    let Some(found) = claims.eq_7 else {
        let why = if claims.basis == Basis::Fourier {
            NO_COLOUR
        } else {
            "Eq. 7 is written for the Fourier basis"
        };
        return row(String::new(), Verdict::Open, why);
    };
    let pair = |[x, y]: [f64; 2]| format!("({x:.3}, {y:.3})");
    let mut measured = format!(
        "At N = {} it puts {} at xy {} as printed, and at {} with order 0 divided by 2; measured \
         {}.",
        claims.order,
        claims.subject,
        found
            .printed
            .map_or_else(|| "where there is no colour".to_owned(), pair),
        pair(found.corrected),
        pair(found.exact),
    );
    if found.lowest_printed < 0.0 {
        measured.push_str(" As printed one of X, Y and Z is negative.");
    }
    if found.printed == Some(found.corrected) {
        // Everything is in the spikes: order 0 is zero.
        return row(measured, Verdict::Open, "order 0 adds nothing here");
    }
    row(
        measured,
        Verdict::OnlyIf,
        "with order 0 divided by 2, not by 4",
    )
}
