//! The spectrum plot: the window draws it and files hold it.

mod whiskers;

use super::{combined::doubted, units::subject_label};
use crate::{
    app::{
        chart::{self, Chart, Dash, Ink, OVERLAY_INKS, Panel, Scale, Series, stroke},
        document::Height,
        entry::Entry,
        laid::Laid,
        line_names::LineName,
        readings::is_counts,
        state::App,
        ticks::short,
    },
    color::srgb_of_fill,
    io::many::numbers,
    languages::fixed,
    spectrum::{Band, Basis, Line, NamedSpectrum, Sampled},
};

/// A basis within a title.
pub(super) fn basis_words(basis: Basis) -> &'static str {
    match basis {
        Basis::Fourier => said!("fourier"),
        Basis::Cosine => said!("cosine"),
    }
}

/// Spectra laid over that are named where they stand; more names would hide the curves.
const MOST_TAGGED: usize = 6;

/// A logarithmic axis shows this much below the largest value.
const LOG_FLOOR: f64 = 1e-5;

/// The spectrum plot of the present document.
pub fn spectrum_chart(app: &App) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let (view, band) = (document.view, derived.band);
    let subject = document.subject_entry();
    let has_subject = app.is_measured_in_range();
    let (name, model) = (subject.name(), &derived.model);
    let title = match view.model {
        true => tr!(
            "{name}: {numbers} ({basis} order {order}, {n} line)"
                | "{name}: {numbers} ({basis} order {order}, {n} lines)" % model.lines().len(),
            name,
            numbers = numbers(derived.numbers()),
            basis = basis_words(model.smooth().basis),
            order = model.smooth().order()
        ),
        false => name.to_owned(),
    };
    let mut chart = Chart {
        title,
        y_label: subject_label(app),
        y_scale: scale(app),
        series: spectrum_series(app),
        colours: colours(app),
        residual: (view.residual && has_subject).then(|| residual(app)),
        notes: provenance(app),
        blank: if has_subject {
            String::new()
        } else {
            nothing_here(app)
        },
        ..over(band)
    };
    let [low, high] = chart.y_limits();
    chart.y_range = Some(match chart.y_scale {
        Scale::Linear | Scale::Root => [low.min(0.0), high.max(0.0)],
        Scale::Log10 => [low.max(LOG_FLOOR * app.top()), high],
    });
    chart
}

/// Lines that tower over the glow this many times are drawn over an axis of roots at first.
const TOWERS: f64 = 4.0;

/// How heights are drawn.
pub fn scale(app: &App) -> Scale {
    match app.document().view.height {
        Height::Even => Scale::Linear,
        Height::Root => Scale::Root,
        Height::Log => Scale::Log10,
        Height::Automatic => {
            let derived = app.derived();
            let most = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
            let glow = most(&derived.smooth);
            let second = app.document().second.as_ref();
            let second = second.and_then(|second| laid_points(app, second));
            let sizes = second.iter().flatten().map(|at| at[1] / app.scale_factor());
            let top = sizes.fold(most(&derived.measured), f64::max);
            match top > TOWERS * glow && glow > 0.0 {
                true => Scale::Root,
                false => Scale::Linear,
            }
        }
    }
}

/// Values on the model's grid as points on the scale in force.
fn curve(app: &App, values: &[f64]) -> Vec<[f64; 2]> {
    on_grid(app.derived().band, values, app.scale_factor())
}

/// Values on a band's grid as points, each times a factor.
pub(in crate::app) fn on_grid(band: Band, values: &[f64], factor: f64) -> Vec<[f64; 2]> {
    chart::curve(band.grid(), values.iter().map(|value| value * factor))
}

/// An empty chart over the wavelengths of a band.
pub(in crate::app) fn over(band: Band) -> Chart {
    Chart::over_nm([band.min_nm(), band.max_nm()])
}

/// What the view shows, the last on top.
fn spectrum_series(app: &App) -> Vec<Series> {
    let (document, derived) = (app.document(), app.derived());
    let view = document.view;
    let mut series = Vec::new();
    let overlays = document.overlays.iter().enumerate();
    let overlays = overlays.filter(|_| view.overlays);
    let overlays = overlays.filter_map(|(i, entry)| overlay(app, entry, i));
    // Where nothing was measured there is nothing to draw, not a line of zeros.
    if !app.is_measured_in_range() {
        return overlays.flatten().collect();
    }
    if view.measured {
        let points = app.measured_points();
        let points: Vec<[f64; 2]> = points.map(|(nm, v)| [nm, v * app.scale_factor()]).collect();
        if view.strip && !is_counts(document.subject_entry()) {
            let area = Series::area(said!("measured"), Ink::Measured, points, Vec::new());
            series.push(area.coloured());
            if document.is_about_light() {
                series.extend(line_bars(app));
            }
        } else {
            series.push(Series::line(said!("measured"), Ink::Measured, points));
        }
        if let Some(of) = document.subject_entry().measured.as_deref() {
            series.extend(doubted(
                of,
                said!("95 % of the measured"),
                app.scale_factor(),
            ));
        }
    }
    // Over the fill, which would hide them where they are lower.
    series.extend(overlays.flatten());
    series.extend(second(app).into_iter().flatten());
    if let Some(product) = app.product() {
        let (exact, model) = (curve(app, &product.exact), curve(app, &product.smooth));
        let name = app.document().patch_called(&product.name);
        let name = tr!("off {product}", product = name);
        series.push(Series::line(&name, Ink::Product, exact));
        let name = tr!("{name}, by the model", name);
        series.push(stroke(&name, Ink::Product, model, 1.8, Dash::Dashed));
        let (spikes, smooth) = (&product.spikes, &product.smooth);
        series.push(stems(app, (&name, Ink::Product), spikes, smooth));
    }
    if view.model {
        // The edge keeps the outline apart from whatever it runs over.
        let points = curve(app, &derived.outline());
        let edge = Ink::Ground;
        series.push(stroke("", edge, points.clone(), 4.0, Dash::Solid));
        series.push(stroke(said!("model"), Ink::Model, points, 2.0, Dash::Solid));
    }
    if view.smooth {
        let line = curve(app, &derived.smooth);
        series.push(stroke(
            said!("smooth part"),
            Ink::Smooth,
            line,
            2.34,
            Dash::Solid,
        ));
    }
    if view.spikes {
        series.extend(bells(app));
        let spikes = derived.model.lines();
        let stems = stems(app, (said!("lines"), Ink::Spikes), spikes, &derived.smooth);
        series.push(stems.labelled(labels(app, spikes)));
        series.extend(whiskers::whiskers(app));
    }
    series
}

/// The second light over the first, with an edge that keeps it apart from what it runs over.
fn second(app: &App) -> Option<[Series; 2]> {
    let document = app.document();
    let entry = document.second.as_ref();
    let entry = entry.filter(|_| document.is_about_light())?;
    let points = laid_points(app, entry)?;
    let edge = stroke("", Ink::Ground, points.clone(), 5.0, Dash::Solid);
    let mut line = stroke(entry.name(), Ink::Second, points, 2.4, Dash::Solid);
    line.is_tagged = true;
    Some([edge, line])
}

/// A line is never drawn narrower than this share of the range: thinner ones could not be seen.
const LINE_SHARE: f64 = 1.0 / 110.0;

/// The measured lines, each as high as it is and wide enough to be seen, in its own colour.
fn line_bars(app: &App) -> Vec<Series> {
    let derived = app.derived();
    let band = derived.band;
    let half = 0.5 * LINE_SHARE * (band.max_nm() - band.min_nm());
    let factor = app.scale_factor();
    let smooth = |nm: f64| factor * band.interpolate(&derived.smooth, nm);
    let lines = derived.parts.spikes.iter().filter(|s| s.spike.weight > 0.0);
    lines
        .filter_map(|line| {
            let at_nm = line.spike.at_nm;
            let near = band.grid().zip(&derived.measured);
            let near = near.filter(|(nm, _)| (nm - at_nm).abs() <= half.max(1.0));
            let height = factor * near.map(|(_, v)| *v).fold(0.0, f64::max);
            let sides =
                [at_nm - half, at_nm + half].map(|nm| nm.clamp(band.min_nm(), band.max_nm()));
            let base = sides.map(smooth).to_vec();
            let points = sides.map(|nm| [nm, height]).to_vec();
            // A line that hardly leaves the glow needs no bar.
            let towers = base.iter().all(|base| height > 1.05 * base);
            towers.then(|| Series::area("", [128; 3], points, base).coloured())
        })
        .collect()
}

/// What stands over the stems: the line's name, else its wavelength, and its share of the power.
fn labels(app: &App, spikes: &[Line]) -> Vec<String> {
    let parts = &app.derived().parts;
    // Counts have places of lines, and no powers.
    let has_power = !is_counts(app.document().subject_entry());
    let share = |spike: &Line| {
        let share = parts.share(spike.weight).filter(|_| has_power);
        share.map(|share| 100.0 * share)
    };
    let sizes = spikes.iter().map(|spike| share(spike).unwrap_or(0.0).abs());
    let largest = sizes.fold(0.0, f64::max);
    let label = |(spike, name): (&Line, &LineName)| {
        let name = match &name.label {
            Some(name) => name.clone(),
            // Dark lines stand close: their numbers would lie over the curve.
            None if spike.weight < 0.0 => return String::new(),
            None => fixed(spike.at_nm, 1),
        };
        match share(spike) {
            Some(share) if share.abs() >= largest => {
                tr!(
                    "{name}\n{share} % of the power",
                    name,
                    share = fixed(share, 1)
                )
            }
            Some(share) => format!("{name}\n{} %", fixed(share, 1)),
            None => name,
        }
    };
    spikes.iter().zip(app.spike_names()).map(label).collect()
}

/// A curve of samples, interrupted where nothing was measured.
pub(super) fn broken_at_holes(mut points: Vec<[f64; 2]>, samples: &Sampled) -> Vec<[f64; 2]> {
    for [from, to] in samples.holes() {
        let behind = points.partition_point(|[nm, _]| *nm <= from);
        points.insert(behind, [0.5 * (from + to), f64::NAN]);
    }
    points
}

/// The curve of a spectrum that is laid over the subject, on its axis.
fn laid_points(app: &App, entry: &Entry) -> Option<Vec<[f64; 2]>> {
    let samples = &entry.spectrum.samples;
    let (_, laid) = app.laid().find(|(over, _)| std::ptr::eq(&***over, entry))?;
    let factor = match laid {
        Laid::Alike(factor) | Laid::EquallyBright(factor) | Laid::AsHigh(factor) => factor,
        Laid::Apart => return None,
    };
    let values = samples.values().iter().map(|v| v * factor);
    let points = chart::curve(samples.nm().iter().copied(), values);
    Some(broken_at_holes(points, samples))
}

/// A spectrum laid over the subject.
fn overlay(app: &App, entry: &Entry, index: usize) -> Option<Vec<Series>> {
    let points = laid_points(app, entry)?;
    let edge = stroke("", Ink::Ground, points.clone(), 3.6, Dash::Solid);
    // The second round of inks is thinner: dashes of many curves cost a third of a frame.
    let width = (1.8 / (1 + index / OVERLAY_INKS) as f64).max(0.7);
    let mut series = stroke(
        entry.name(),
        Ink::Overlay(index),
        points,
        width,
        Dash::Solid,
    );
    series.is_tagged = index < MOST_TAGGED;
    // Of many curves the edges would hide one another.
    let edge = series.is_tagged.then_some(edge);
    Some(edge.into_iter().chain([series]).collect())
}

/// Spikes of the model as stems on a smooth curve.
fn stems(app: &App, looks: (&str, Ink), spikes: &[Line], smooth: &[f64]) -> Series {
    let derived = app.derived();
    let smooth = (derived.band, smooth, app.scale_factor());
    spike_stems(looks, spikes, smooth, |i| {
        derived.stem_width_at(spikes[i].at_nm)
    })
}

/// Spikes as stems on a smooth curve, each as high as a line of the width that it is drawn with;
/// all times a factor.
pub(super) fn spike_stems(
    (name, colour): (&str, Ink),
    spikes: &[Line],
    (band, smooth, factor): (Band, &[f64], f64),
    width_nm: impl Fn(usize) -> f64,
) -> Series {
    let stem = |(i, spike): (usize, &Line)| {
        let base = factor * band.interpolate(smooth, spike.at_nm);
        let tip = base + factor * spike.stem_height(width_nm(i));
        ([spike.at_nm, tip], base)
    };
    let (points, base) = spikes.iter().enumerate().map(stem).unzip();
    Series::stems(name, colour, points, base)
}

/// Lines that have a width, each as it stands on the smooth curve.
fn bells(app: &App) -> Option<Series> {
    let derived = app.derived();
    derived.model.has_widths().then(|| {
        let points = curve(app, &derived.outline());
        let base = curve(app, &derived.smooth).iter().map(|p| p[1]).collect();
        Series::area(
            said!("lines as wide as they are"),
            Ink::Spikes,
            points,
            base,
        )
    })
}

/// The colours of the wavelengths; none where the range shows none.
fn colours(app: &App) -> Vec<Ink> {
    let band = app.derived().band;
    if band.min_nm() >= 830.0 || band.max_nm() <= 360.0 {
        return Vec::new();
    }
    let colours = band.grid().map(|nm| Ink::Own(srgb_of_fill(nm).0));
    colours.collect()
}

/// Model minus measured.
fn residual(app: &App) -> Panel {
    // Lines are as wide as they are measured: ideal ones would dwarf all that is left over.
    let points = curve(app, &app.derived().widened_residual());
    let mut panel = Panel {
        y_label: said!("model − measured").to_owned(),
        y_range: None,
        series: vec![Series::line(said!("residual"), Ink::Residual, points)],
    };
    // Rounding is not worth an axis of its own.
    let least = 1e-6 * app.top();
    let [low, high] = panel.y_limits();
    panel.y_range = Some([low.min(-least), high.max(least)]);
    panel
}

/// Why the plot is empty.
fn nothing_here(app: &App) -> String {
    let band = app.derived().band;
    let samples = &app.document().subject_entry().spectrum.samples;
    tr!(
        "Nothing was measured from {from} to {to} nm. The table covers {first} to {last} nm.",
        from = short(band.min_nm()),
        to = short(band.max_nm()),
        first = short(samples.first_nm()),
        last = short(samples.last_nm())
    )
}

/// Where the numbers of an export come from: source, scale, program.
pub fn provenance(app: &App) -> Vec<String> {
    let document = app.document();
    let mut notes = source_of(&document.subject_entry().spectrum);
    notes.push(by_program(&tr!(
        "Scale: {scale}.",
        scale = document.scale.words()
    )));
    notes
}

/// The same under notes of a chart's own.
pub(in crate::app) fn before_provenance(mut notes: Vec<String>, app: &App) -> Vec<String> {
    notes.extend(provenance(app));
    notes
}

/// The same under the name of the subject.
pub(super) fn of_subject(app: &App) -> Vec<String> {
    let name = app.document().subject_entry().name();
    before_provenance(vec![tr!("Spectrum: {name}", name)], app)
}

/// The same as comments of a table, under comments of its own.
pub(super) fn table_head(mut out: String, app: &App) -> String {
    for note in provenance(app) {
        out += &format!("# {note}\n");
    }
    out
}

/// Where a spectrum comes from; nothing where it is not said.
pub(super) fn source_of(spectrum: &NamedSpectrum) -> Vec<String> {
    let source = &spectrum.source;
    let is_said = !source.is_empty();
    is_said
        .then(|| tr!("Source: {source}", source))
        .into_iter()
        .collect()
}

/// A sentence, and what program says so.
pub(super) fn by_program(sentence: &str) -> String {
    format!(
        "{sentence} Spectral Explorer {}.",
        env!("CARGO_PKG_VERSION")
    )
}
