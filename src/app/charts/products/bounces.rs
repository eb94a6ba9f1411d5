//! Error against the number of bounces, for every way of forming products.

use super::resampling::{thin, way_looks, way_name};
use crate::{
    app::{
        App, Entry,
        cells::{Columns, Table, cell},
        chart::{Chart, Dash, Ink, Scale, Series},
        charts::spectrum::{before_provenance, table_head},
        products::ModelledLight,
        verdicts::HARD_TO_SEE,
    },
    spectrum::Sampling,
    study::products::{BounceErrors, MOST_BOUNCES, bounce_errors},
};

/// Errors below this are drawn at it on a logarithmic axis.
const SMALLEST: f64 = 1e-3;

/// Bounces that the table tells.
pub const TOLD: [usize; 5] = [1, 2, 4, 8, 16];

/// Errors of a way behind bounces: in total, and added by forming the products.
struct BounceRow {
    sampling: Sampling,
    bounces: usize,
    errors: [Option<f64>; 2],
}

/// Every way of forming products over bounces off one surface.
#[derive(Clone, Debug)]
pub struct Bounced {
    /// The light's name.
    pub light: String,
    /// The surface's name.
    pub surface: String,
    pub ways: Vec<BounceErrors>,
}

impl Bounced {
    /// Follows the document's light off a surface.
    pub fn of(app: &App, surface: &Entry) -> Self {
        Self::lit(
            &ModelledLight::of(app),
            app.document().light.name(),
            surface,
        )
    }

    /// The same for a light that was taken out of the document, with its name.
    pub fn lit(lit: &ModelledLight, light: &str, surface: &Entry) -> Self {
        let factor = lit.factor(surface.on_band(lit.band()));
        Self {
            light: light.to_owned(),
            surface: surface.name().to_owned(),
            ways: bounce_errors(lit.product(), &factor),
        }
    }

    /// Whether there is any colour to be off by.
    pub fn has_colour(&self) -> bool {
        let mut all = self.ways.iter().flat_map(|way| &way.total);
        all.any(Option::is_some)
    }

    /// The chart: total errors, or what forming the products adds.
    pub fn chart(&self, app: &App, added: bool, log: bool) -> Chart {
        let last = MOST_BOUNCES as f64;
        let mut series = vec![thin(
            "ΔE₀₀ = 1",
            Ink::Measured,
            vec![[1.0, HARD_TO_SEE], [last, HARD_TO_SEE]],
            Dash::Dashed,
        )];
        for way in &self.ways {
            let (ink, dash, shape) = way_looks(way.sampling);
            let points: Vec<[f64; 2]> = errors(way, added)
                .iter()
                .enumerate()
                .filter_map(|(i, error)| {
                    let error = (*error)?;
                    let shown = if log { error.max(SMALLEST) } else { error };
                    Some([(i + 1) as f64, shown])
                })
                .collect();
            let name = way_name(way.sampling);
            series.push(thin("", ink, points.clone(), dash));
            series.push(Series::points(name, ink, shape, points));
        }
        let notes = vec![tr!(
            "Light: {light}. Surface: {surface}. Both sides brightened to half the light's Y.",
            light = self.light,
            surface = self.surface
        )];
        Chart {
            title: said!("Error against bounces").to_owned(),
            x_label: said!("Bounces K").to_owned(),
            y_label: if added {
                said!("ΔE₀₀ added by forming the products").to_owned()
            } else {
                said!("ΔE₀₀ against the exact product").to_owned()
            },
            x_range: [1.0, last],
            y_scale: if log { Scale::Log10 } else { Scale::Linear },
            series,
            notes: before_provenance(notes, app),
            ..Chart::default()
        }
    }

    /// Up to which bounce each way stays below a ΔE₀₀ of 1, and for which there is a colour.
    pub fn stays(&self, added: bool) -> Vec<(usize, usize)> {
        let told = |way: &BounceErrors| {
            let errors = errors(way, added);
            let seen = errors.iter().take_while(|e| e.is_some()).count();
            let below = |e: &&Option<f64>| e.is_some_and(|e| e < HARD_TO_SEE);
            (errors.iter().take_while(below).count(), seen)
        };
        self.ways.iter().map(told).collect()
    }

    /// Which way stays below a ΔE₀₀ of 1 for how long.
    pub fn sentence(&self, added: bool) -> String {
        if !self.has_colour() {
            return said!("There is no visible light to be off by.").to_owned();
        }
        let stays = self.stays(added);
        let ways = || self.ways.iter().map(|w| way_name(w.sampling)).zip(&stays);
        let most = stays.iter().map(|(below, _)| *below).max().unwrap_or(0);
        let names = |wanted: usize| -> Vec<&str> {
            let found = ways().filter(|(_, (below, _))| *below == wanted);
            found.map(|(name, _)| name).collect()
        };
        if most == 0 {
            return match added {
                true => said!("No way stays below added ΔE₀₀ 1, not for one bounce."),
                false => said!("No way stays below ΔE₀₀ 1, not for one bounce."),
            }
            .to_owned();
        }
        let mut lengths: Vec<usize> = stays.iter().map(|(below, _)| *below).collect();
        lengths.sort_unstable();
        lengths.dedup();
        let told: Vec<String> = lengths
            .iter()
            .rev()
            .map(|length| {
                let whole = stays.iter().all(|(_, seen)| seen == length);
                let length_words = match (length, whole) {
                    (0, _) => said!("not for one bounce").to_owned(),
                    (length, true) => tr!("through all {length} bounces", length),
                    (1, false) => said!("for 1 bounce").to_owned(),
                    (length, false) => tr!("up to {length} bounces", length),
                };
                crate::languages::with_colon(length_words, names(*length).join(", "))
            })
            .collect();
        let lengths = told.join("; ");
        match added {
            true => tr!("Below added ΔE₀₀ 1 {lengths}.", lengths),
            false => tr!("Below ΔE₀₀ 1 {lengths}.", lengths),
        }
    }

    /// All errors as a table.
    pub fn table(&self, app: &App) -> Table {
        let head = format!("# light: {}\n# surface: {}\n", self.light, self.surface);
        let columns = Columns::<BounceRow>::default()
            .with("way", |row| cell(way_name(row.sampling)))
            .with("bounces", |row| cell(row.bounces))
            .with("delta_e_2000_total", |row| cell(row.errors[0]))
            .with("delta_e_2000_added", |row| cell(row.errors[1]));
        let rows = self.ways.iter().flat_map(|way| {
            let errors = way.total.iter().zip(&way.added).enumerate();
            errors.map(|(i, (total, added))| BounceRow {
                sampling: way.sampling,
                bounces: i + 1,
                errors: [*total, *added],
            })
        });
        Table::new(table_head(head, app), columns, rows)
    }
}

/// The errors of a way, K = 1 first.
pub fn errors(way: &BounceErrors, added: bool) -> &[Option<f64>] {
    if added { &way.added } else { &way.total }
}
