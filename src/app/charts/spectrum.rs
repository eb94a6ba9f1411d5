//! The spectrum plot and the error against the order: the window draws them and files hold them.

use crate::{
    app::{
        chart::{Chart, Dash, Inks, Marks, Palette, Panel, Rgb, Scale, Series, Shape, Theme},
        derived::OrderPoint,
        entry::Entry,
        line_names::LineName,
        state::App,
        ticks::{extent, short},
        workspace::CurveQuantity,
    },
    color::{Srgb, srgb_from_wavelength_over},
    io::many::{many, numbers},
    spectrum::Spike,
};

/// Spectra laid over that are named where they stand; more names would hide the curves.
const MOST_TAGGED: usize = 6;

/// A logarithmic axis shows this much below the largest value.
const LOG_FLOOR: f64 = 1e-5;

/// The name of the series of the model's spikes: a point of it is a spike of the model.
pub const SPIKES: &str = "spikes";

/// The spectrum plot of the present document.
pub fn spectrum_chart(app: &App, theme: Theme) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let (view, band) = (document.view, derived.band);
    let subject = document.subject_entry();
    let unit = app.unit();
    let has_subject = app.is_measured_in_range();
    let mut chart = Chart {
        title: format!(
            "{}: {} ({} order {}, {})",
            subject.name(),
            numbers(derived.numbers()),
            derived.model.smooth.basis.word(),
            derived.model.smooth.order(),
            many(derived.model.spikes.len(), "spike", "spikes"),
        ),
        x_label: "Wavelength (nm)".to_owned(),
        y_label: if unit.is_empty() {
            "value".to_owned()
        } else {
            unit.to_owned()
        },
        x_range: [band.min_nm(), band.max_nm()],
        y_scale: if view.log_axis {
            Scale::Log10
        } else {
            Scale::Linear
        },
        series: spectrum_series(app, Inks::of(theme)),
        strip: strip(app, theme),
        residual: (view.residual && has_subject).then(|| residual(app, theme)),
        notes: provenance(app),
        blank: if has_subject {
            String::new()
        } else {
            nothing_here(app)
        },
        theme,
        ..Chart::default()
    };
    let [low, high] = chart.y_limits();
    chart.y_range = Some(match chart.y_scale {
        Scale::Linear => [low.min(0.0), high.max(0.0)],
        Scale::Log10 => [low.max(LOG_FLOOR * top(app)), high],
    });
    chart
}

/// The largest measured size on the scale in force.
fn top(app: &App) -> f64 {
    let sizes = app.derived().measured.iter().map(|v| v.abs());
    app.scale_factor() * sizes.fold(0.0, f64::max)
}

/// Values on the model's grid as points on the scale in force.
fn curve(app: &App, values: &[f64]) -> Vec<[f64; 2]> {
    let grid = app.derived().band.grid().zip(values);
    grid.map(|(nm, v)| [nm, v * app.scale_factor()]).collect()
}

fn line(name: &str, colour: Rgb, points: Vec<[f64; 2]>, width: f64, dash: Dash) -> Series {
    let marks = Marks::Line {
        points,
        width,
        dash,
    };
    Series::new(name, colour, marks)
}

/// What the view shows, the last on top.
fn spectrum_series(app: &App, inks: Inks) -> Vec<Series> {
    let (document, derived) = (app.document(), app.derived());
    let view = document.view;
    let mut series = Vec::new();
    if view.overlays {
        let overlays = document.overlays.iter().enumerate();
        series.extend(overlays.map(|(i, entry)| overlay(app, entry, i, inks)));
    }
    // Where nothing was measured there is nothing to draw, not a line of zeros.
    if !app.is_measured_in_range() {
        return series;
    }
    if view.measured {
        let points = app.measured_points();
        let points = points.map(|(nm, v)| [nm, v * app.scale_factor()]);
        series.push(Series::line("measured", inks.measured, points.collect()));
    }
    if let Some(product) = app.product() {
        let (exact, model) = (curve(app, &product.exact), curve(app, &product.smooth));
        let name = format!("through {}", product.name);
        series.push(Series::line(&name, inks.product, exact));
        let name = format!("{name}, by the model");
        series.push(line(&name, inks.product, model, 1.8, Dash::Dashed));
        let labels = Vec::new();
        series.push(stems(
            app,
            (&name, inks.product),
            &product.spikes,
            &product.smooth,
            labels,
        ));
    }
    if view.model {
        let points = curve(app, &derived.model_values());
        series.push(line("model", inks.spikes, points, 1.44, Dash::Solid));
    }
    if view.smooth {
        let points = curve(app, &derived.smooth);
        series.push(line("smooth part", inks.smooth, points, 2.34, Dash::Solid));
    }
    if view.spikes {
        let spikes = &derived.model.spikes;
        let label = |(spike, name): (&Spike, &LineName)| match &name.label {
            Some(name) => name.clone(),
            None => format!("{:.1}", spike.at_nm),
        };
        let labels = spikes.iter().zip(app.spike_names()).map(label).collect();
        series.push(stems(
            app,
            (SPIKES, inks.spikes),
            spikes,
            &derived.smooth,
            labels,
        ));
    }
    series
}

/// A spectrum laid over the subject, on its axis.
fn overlay(app: &App, entry: &Entry, index: usize, inks: Inks) -> Series {
    let samples = &entry.spectrum.samples;
    let factor = if entry.kind() == app.document().subject_entry().kind() {
        app.document().scale.factor(&entry.spectrum).unwrap_or(1.0)
    } else {
        // Watts and fractions have no common axis: another kind is drawn to the same height.
        let own = samples.values().iter().copied().fold(0.0, f64::max);
        if own > 0.0 { top(app) / own } else { 1.0 }
    };
    let points = samples.nm().iter().zip(samples.values());
    let points = points.map(|(nm, v)| [*nm, v * factor]).collect();
    let colours = inks.overlays;
    // The second round of inks is thinner: dashes of many curves cost a third of a frame.
    let width = (1.8 / (1 + index / colours.len()) as f64).max(0.7);
    let colour = colours[index % colours.len()];
    let mut series = line(entry.name(), colour, points, width, Dash::Solid);
    series.is_tagged = index < MOST_TAGGED;
    series
}

/// Spikes as stems on a smooth curve.
fn stems(
    app: &App,
    (name, colour): (&str, Rgb),
    spikes: &[Spike],
    smooth: &[f64],
    labels: Vec<String>,
) -> Series {
    let (factor, band) = (app.scale_factor(), app.derived().band);
    let width = app.document().settings.max_width_nm;
    let base: Vec<f64> = spikes
        .iter()
        .map(|s| factor * band.interpolate(smooth, s.at_nm))
        .collect();
    let tips = spikes.iter().zip(&base);
    let points = tips
        .map(|(s, base)| [s.at_nm, base + factor * s.stem_height(width)])
        .collect();
    let marks = Marks::Stems {
        points,
        base,
        labels,
    };
    Series::new(name, colour, marks)
}

/// The colours of the wavelengths, where there are any.
fn strip(app: &App, theme: Theme) -> Option<Vec<Rgb>> {
    let band = app.derived().band;
    let is_visible = band.min_nm() < 830.0 && band.max_nm() > 360.0;
    (app.document().view.strip && is_visible).then(|| {
        let ground = Srgb(Palette::of(theme).ground);
        let colours = band
            .grid()
            .map(|nm| srgb_from_wavelength_over(nm, ground).0);
        colours.collect()
    })
}

/// Model minus measured.
fn residual(app: &App, theme: Theme) -> Panel {
    let points = curve(app, &app.derived().residual);
    let mut panel = Panel {
        y_label: "model − measured".to_owned(),
        y_range: None,
        series: vec![Series::line("residual", Inks::of(theme).residual, points)],
    };
    // Rounding is not worth an axis of its own.
    let least = 1e-6 * top(app);
    let [low, high] = panel.y_limits();
    panel.y_range = Some([low.min(-least), high.max(least)]);
    panel
}

/// Why the plot is empty.
fn nothing_here(app: &App) -> String {
    let band = app.derived().band;
    let samples = &app.document().subject_entry().spectrum.samples;
    format!(
        "Nothing was measured from {} to {} nm. The table covers {} to {} nm.",
        band.min_nm(),
        band.max_nm(),
        short(samples.first_nm()),
        short(samples.last_nm()),
    )
}

/// Errors below this are drawn at it: the axis is logarithmic.
const SMALLEST_ERROR: f64 = 1e-4;

/// A just noticeable colour difference, about; the line drawn for orientation.
const NOTICEABLE: f64 = 1.0;

/// Whether a quantity is told in percent instead of CIEDE2000.
fn is_percent(quantity: CurveQuantity) -> bool {
    matches!(quantity, CurveQuantity::Rms | CurveQuantity::RmsBlurred)
}

/// A quantity of every order: CIEDE2000, or percent.
fn errors(app: &App, quantity: CurveQuantity) -> Vec<[f64; 2]> {
    let factor = if is_percent(quantity) { 100.0 } else { 1.0 };
    let of = |p: &OrderPoint| match quantity {
        CurveQuantity::Own => p.own,
        CurveQuantity::Patches => p.patches_mean,
        CurveQuantity::PatchesWorst => p.patches_max,
        CurveQuantity::Rms => p.relative_rms,
        CurveQuantity::RmsBlurred => p.relative_rms_10nm,
    };
    let point = |p: &OrderPoint| Some([p.order as f64, (factor * of(p)?).max(SMALLEST_ERROR)]);
    app.derived().curve.iter().filter_map(point).collect()
}

/// The errors against the order as a chart: colour differences, and relative errors in percent.
pub fn curve_chart(app: &App, theme: Theme) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let inks = Inks::of(theme);
    let series = [
        ("own colour, dE00", inks.measured, CurveQuantity::Own),
        ("patches' mean, dE00", inks.smooth, CurveQuantity::Patches),
        (
            "worst patch, dE00",
            inks.product,
            CurveQuantity::PatchesWorst,
        ),
        ("rms at 1 nm, %", inks.spikes, CurveQuantity::Rms),
        (
            "rms behind 10 nm, %",
            inks.residual,
            CurveQuantity::RmsBlurred,
        ),
    ]
    .map(|(name, ink, quantity)| Series::line(name, ink, errors(app, quantity)));
    Chart {
        title: format!(
            "{}: error against order ({}, {})",
            document.subject_entry().name(),
            derived.model.smooth.basis.word(),
            many(derived.model.spikes.len(), "spike", "spikes")
        ),
        x_label: "Order N".to_owned(),
        y_label: "Error (CIEDE2000, or percent)".to_owned(),
        x_range: [
            0.0,
            derived.curve.last().map_or(1.0, |p| p.order.max(1) as f64),
        ],
        y_scale: Scale::Log10,
        series: series
            .into_iter()
            .filter(|s| !s.marks.points().is_empty())
            .collect(),
        notes: provenance(app),
        theme,
        ..Chart::default()
    }
}

/// One of the errors against the order with the order in force marked; `None` where there is none.
pub fn order_chart(app: &App, quantity: CurveQuantity, theme: Theme) -> Option<Chart> {
    let inks = Inks::of(theme);
    let points = errors(app, quantity);
    let [lowest, highest] = extent(points.iter().map(|p| p[1].log10()))?;
    let decades = [
        (lowest - 0.1).floor().max(SMALLEST_ERROR.log10()),
        highest.ceil(),
    ];
    let air = 0.08 * (decades[1] - decades[0]);
    let y_range = [decades[0] - air, decades[1] + air].map(|log| 10_f64.powf(log));
    let last = points.last().map_or(1.0, |p| p[0].max(1.0));
    let x_range = [-0.02 * last, 1.02 * last];
    let order = app.derived().model.smooth.order() as f64;
    let faint = Palette::of(theme).axis;
    let thin = |ends: [[f64; 2]; 2]| line("", faint, ends.to_vec(), 1.1, Dash::Solid);
    let dots = |colour: Rgb, radius: f64, points: Vec<[f64; 2]>| {
        let marks = Marks::Points {
            points,
            radius,
            shape: Shape::Dot,
        };
        Series::new("", colour, marks)
    };
    let now = points.iter().copied().filter(|p| p[0] == order).collect();
    let mut series = vec![thin(y_range.map(|y| [order, y]))];
    if !is_percent(quantity) {
        series.push(thin(x_range.map(|x| [x, NOTICEABLE])));
    }
    series.push(Series::line("", inks.smooth, points.clone()));
    series.push(dots(inks.smooth, 1.8, points));
    series.push(dots(inks.spikes, 4.5, now));
    Some(Chart {
        x_range,
        y_range: Some(y_range),
        y_scale: Scale::Log10,
        y_unit: if is_percent(quantity) { " %" } else { "" }.to_owned(),
        series,
        theme,
        ..Chart::default()
    })
}

/// Where the numbers of an export come from: source, scale, program.
pub fn provenance(app: &App) -> Vec<String> {
    let document = app.document();
    let spectrum = &document.subject_entry().spectrum;
    let mut notes = Vec::new();
    if !spectrum.source.is_empty() {
        notes.push(format!("Source: {}", spectrum.source));
    }
    notes.push(format!(
        "Scale: {}. Spectral Explorer {}.",
        document.scale.words(),
        env!("CARGO_PKG_VERSION")
    ));
    notes
}
