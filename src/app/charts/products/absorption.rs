//! Charts of the part "absorption" of the page "Products": absorption lines.

use crate::{
    app::{
        absorption_names::{Curve, dark_lines},
        cells::{Columns, Table, cell},
        chart::{Chart, Dash, Ink, Series, stroke},
        charts::{
            spectrum::{of_subject, on_grid, over},
            units::subject_label,
        },
        export,
        numbers::{DASH, fixed, or_dash},
        product_report::Told,
        products::ModelledLight,
        settings::{Detector, Settings},
        state::App,
        ticks::short,
    },
    spectrum::{Line, below_zero},
    study::products::depths,
};

pub use crate::app::absorption_names::DarkLine;

use super::chain::strip;

/// A dip of the subject as it is told.
#[derive(Clone, Debug, PartialEq)]
pub struct DipRow {
    /// The dip: place in nm, weight in the subject's own unit x nm.
    pub spike: Line,
    /// Share of the background that is missing at its deepest, 0-1.
    pub depth: Option<f64>,
    /// A name that is safe.
    pub name: Option<String>,
    /// Whether the model's total is below zero there.
    pub below_zero: bool,
}

/// What was found in the subject of a state.
pub struct AbsorptionSheet {
    pub dips: Vec<DipRow>,
    /// Known lines that are seen in the curve, too weak or too wide here to be a dip of the model.
    pub known: Vec<DarkLine>,
    /// The curve with its dips.
    pub chart: Chart,
    /// The dips as a table.
    pub table: Table,
    /// Lines of the light that stand on dips of the chain, a sentence each.
    pub met: Vec<String>,
}

impl AbsorptionSheet {
    /// The dips of a state.
    pub fn of(app: &App) -> Self {
        let dips = dip_rows(app);
        let known = known_lines(app, &dips);
        Self {
            chart: absorption_chart(app, (&dips, &known)),
            table: table(app, &dips),
            met: met(app),
            dips,
            known,
        }
    }
}

/// Whether dips are looked for: only one of the detectors can.
pub fn looks(settings: Settings) -> bool {
    settings.dips && settings.spikes && settings.detector == Detector::Energy
}

/// The subject's dips, by rising wavelength.
pub fn dip_rows(app: &App) -> Vec<DipRow> {
    let derived = app.derived();
    let spikes = derived.model.lines();
    let depths = depths(
        derived.band,
        &derived.measured,
        &derived.parts.smooth,
        spikes,
    );
    let width = app.document().settings.max_width_nm;
    let below = below_zero(derived.band, &derived.smooth, spikes, width);
    spikes
        .iter()
        .zip(depths)
        .zip(app.spike_names())
        .filter(|((spike, _), _)| spike.weight < 0.0)
        .map(|((spike, depth), name)| DipRow {
            spike: *spike,
            depth,
            name: name.safe.clone(),
            below_zero: below.contains(&spike.at_nm),
        })
        .collect()
}

/// Known dark lines that the subject's own curve shows where no dip is named after them.
fn known_lines(app: &App, dips: &[DipRow]) -> Vec<DarkLine> {
    if !looks(app.document().settings) {
        return Vec::new();
    }
    let derived = app.derived();
    let entry = app.document().subject_entry();
    let families = dark_lines(Curve::of(entry, derived.band, &derived.measured));
    let lines = families.into_iter().flat_map(|family| family.lines);
    let is_a_dip = |name: &str| dips.iter().any(|dip| dip.name.as_deref() == Some(name));
    lines
        .filter(|line| line.is_seen && !is_a_dip(line.name))
        .collect()
}

/// Lines of the light that stand on dips of the chain, with their weights before and after.
fn met(app: &App) -> Vec<String> {
    let document = app.document();
    if !looks(document.settings) || document.products.chain.is_empty() {
        return Vec::new();
    }
    let lit = ModelledLight::of(app);
    let told = Told::of(app, &lit, &document.products.chain);
    let factor = document.scale.factor(&document.light.spectrum);
    let factor = factor.unwrap_or(1.0);
    let mut before = lit.derived.model.lines();
    let mut all = Vec::new();
    for (name, step) in told.names.iter().zip(&told.passage.steps) {
        let weight = |spikes: &[Line], nm: f64| {
            let found = spikes.iter().find(|s| s.at_nm == nm);
            found.map_or_else(|| "–".to_owned(), |s| short(factor * s.weight))
        };
        let called = |nm: f64| match told.known.safe(nm) {
            Some(name) => format!("{} nm ({name})", fixed(nm, 1)),
            None => format!("{} nm", fixed(nm, 1)),
        };
        for met in &step.met {
            all.push(tr!(
                "{light} in {name}: the line at {line} stands on a dark line at {dark_line}, \
                 {depth} % deep. Its weight goes from {before} to {after}.",
                light = document.light.name(),
                name,
                line = called(met.line_nm),
                dark_line = called(met.dip_nm),
                depth = fixed(100.0 * met.depth, 0),
                before = weight(before, met.line_nm),
                after = weight(&step.spikes, met.line_nm)
            ));
        }
        before = &step.spikes;
    }
    all
}

/// The dips as a table, weights in files in the subject's own unit x nm.
fn table(app: &App, dips: &[DipRow]) -> Table {
    let factor = app.scale_factor();
    let columns = Columns::<&DipRow>::default()
        .with("place nm", |dip| {
            cell(dip.spike.at_nm).shown(fixed(dip.spike.at_nm, 1))
        })
        .figures("nm", said!("Centroid of the dark line, nm."))
        .with("weight", |dip| {
            cell(dip.spike.weight).shown(short(factor * dip.spike.weight))
        })
        .figures(
            said!("weight"),
            said!("Power that is missing, in the plot's unit × nm."),
        )
        .with("depth", |dip| {
            let depth = or_dash(dip.depth, |depth| format!("{} %", fixed(100.0 * depth, 1)));
            cell(dip.depth).shown(depth)
        })
        .figures(
            said!("depth"),
            said!("Share of the background that is missing at its deepest, percent."),
        )
        .with("name", |dip| {
            let mark = if dip.below_zero { "▲ " } else { "" };
            let name = dip.name.as_deref();
            cell(name.unwrap_or_default()).shown(format!("{mark}{}", name.unwrap_or(DASH)))
        })
        .titled(
            said!("line"),
            said!(
                "Named only where it is safe. A known line without a weight is seen in the curve, \
                 but the search did not take it: it is no number of the model."
            ),
        )
        .with("below zero", |dip| {
            cell(if dip.below_zero { "yes" } else { "no" })
        });
    Table::new(export::table_head(app), columns, dips)
}

/// The measured curve filled with its colours, what it would be without dips, and the gaps between
/// both: those that the model keeps and known lines. What has a name has it written above.
pub fn absorption_chart(app: &App, (dips, known): (&[DipRow], &[DarkLine])) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let (band, factor) = (derived.band, app.scale_factor());
    let curve = |values: &[f64]| on_grid(band, values, factor);
    let [measured, filled] = [&derived.measured, &derived.parts.smooth];
    let area = Series::area(
        said!("measured"),
        Ink::Measured,
        curve(measured),
        Vec::new(),
    );
    let filled_up = stroke(
        said!("without dark lines"),
        Ink::Residual,
        curve(filled),
        1.3,
        Dash::Dashed,
    );
    // At the ends of the visible range the fill is hardly seen.
    let edge = stroke("", Ink::Faint, curve(measured), 1.0, Dash::Solid);
    let mut series = vec![area.coloured(), edge, filled_up];
    // From the curve up to what it would be: a name stands above, where nothing else is.
    let gaps = |name: &str, ink: Ink, gaps: Vec<(f64, String, Option<f64>)>| {
        let height = |values: &[f64], nm: f64| factor * band.interpolate(values, nm);
        let ends = gaps
            .iter()
            .map(|(nm, ..)| ([*nm, height(filled, *nm)], height(measured, *nm)));
        let (tops, base) = ends.unzip();
        let note = |(nm, label, depth): &(f64, String, Option<f64>)| {
            let at = match label.is_empty() {
                true => format!("{} nm", fixed(nm, 1)),
                false => label.clone(),
            };
            match depth {
                Some(depth) => tr!("{at}: {depth} % deep", at, depth = fixed(100.0 * depth, 0)),
                None => at,
            }
        };
        let notes = gaps.iter().map(note).collect();
        let labels = gaps.into_iter().map(|(_, label, _)| label).collect();
        let stems = Series::stems(name, ink, tops, base);
        stems.labelled(labels).with_notes(notes)
    };
    if !known.is_empty() {
        let known = known.iter();
        let known = known.map(|line| (line.at_nm(), line.name.to_owned(), Some(line.depth)));
        let name = said!("known, not in the model");
        series.push(gaps(name, Ink::Residual, known.collect()));
    }
    if !dips.is_empty() {
        let name = |dip: &DipRow| dip.name.clone().unwrap_or_default();
        let dips = dips
            .iter()
            .map(|dip| (dip.spike.at_nm, name(dip), dip.depth));
        series.push(gaps(said!("dark lines"), Ink::Product, dips.collect()));
    }
    Chart {
        title: tr!(
            "Missing in {subject}",
            subject = document.subject_entry().name()
        ),
        y_label: subject_label(app),
        series,
        colours: strip(band),
        notes: of_subject(app),
        ..over(band)
    }
}
