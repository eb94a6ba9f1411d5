//! The paper's mathematics on the document: its harmonics, and its claims measured again.
//!
//! Claims are measured in the basis, range and order in force. Products (Eq. 16 and 17) need a
//! light and a factor: for a light the factor is the chosen patch, or one that is worth looking
//! at; for a reflectance the factor is the subject, and the light is taken apart with the same
//! knobs.

mod row;
mod rows;
mod table;

pub use row::{Row, Verdict, off_percent, three};
pub use table::{copied_table, truth_table};

use crate::{
    app::{state::App, tables::Viewing, ticks::extent},
    color::{Adaptation, Observer, Swatch, Weights, Xyz, xy_from_xyz, xyz_of_one, xyz_of_parts},
    spectrum::{Band, Basis, Composite, Sampling, Series, detect_shapes, numbers_of_order},
    study::{
        harmonics::{Harmonics, Question},
        truth::{
            self, Eq17, FivePercent, Resampling, ResamplingWay, STATED_LINE_NM, STATED_ORDER,
            SamplesAgainstNumbers, StraightLine, Table2,
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
        spikes: derived.model.lines(),
        measured: &derived.measured,
        weights: &tables.viewing.weights,
        plain_colour_matching: document.is_about_light()
            && document.settings.observer == Observer::CIE_1931,
    })
}

/// The colour as measured and as far as the orders up to `order` have come, equally bright where
/// it is a light's; `None` where there is none.
pub fn colours_summed(app: &App, harmonics: &Harmonics, order: usize) -> Option<[Swatch; 2]> {
    let running = harmonics.orders.get(order)?.running;
    let whole = app.derived().colour.exact?;
    let share = |k: usize| running[k] / harmonics.exact[k];
    let Xyz { x, y, z } = whole.xyz;
    let summed = Xyz::new(x * share(0), y * share(1), z * share(2));
    let swatch = match app.document().is_about_light() {
        true => Swatch::of_light(summed),
        // A white of any brightness is the light of the surfaces; their Y counts against its 100.
        false => Swatch::of_patch(summed, Xyz::new(0.0, 100.0, 0.0), Adaptation::None),
    };
    summed.is_finite().then_some([whole.swatch, swatch])
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
        let order = derived.model.smooth().order();
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
    if app.document().is_about_light() {
        xyz_of_parts(derived.band, &derived.measured, &[], weights)
    } else {
        // The weights are the light's already: a perfect reflector is their own integral.
        xyz_of_one(derived.band, weights)
    }
}

/// A light and a factor to multiply.
struct Product {
    name: String,
    light: Composite,
    factor: Vec<f64>,
    weights: Weights,
    white: Xyz,
}

impl Product {
    fn of(app: &App) -> Option<Self> {
        let (document, derived) = (app.document(), app.derived());
        let (band, observer) = (derived.band, document.settings.observer);
        let weights = Viewing::of_light(band, observer).weights;
        let values = document.light.on_band(band);
        let white = xyz_of_parts(band, &values, &[], &weights);
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
    Composite::of_lines_inside(
        Series {
            band,
            basis: settings.basis,
            coefficients: table.project(&smooth, numbers_of_order(settings.effective_order())),
        },
        spikes,
    )
}

/// The chosen patch, else the one called orange (steep in the middle of the visible), else the
/// one that varies most.
fn patch_of(app: &App) -> Option<(String, Vec<f64>)> {
    let patches = app.tables().patches.as_ref()?;
    let names = patches.set.names();
    let variation = |values: &Vec<f64>| {
        let range = extent(values.iter().copied());
        range.map_or(0.0, |[low, high]| high - low)
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
