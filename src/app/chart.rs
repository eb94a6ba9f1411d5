//! The spectrum plot as a chart for files: the same curves that the window draws.

use super::{
    derived::OrderPoint,
    plot_svg::{self, Chart, Marks, Panel, Rgb, Series, Theme},
    state::App,
};
use crate::{
    color::{Srgb, srgb_from_wavelength_over},
    io::many::{many, numbers},
};

/// Line colours that colour-blind eyes tell apart, after Okabe and Ito (2008), tuned for a ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inks {
    /// The measured curve: neutral.
    pub measured: Rgb,
    /// The smooth part: blue.
    pub smooth: Rgb,
    /// Spikes and model: orange.
    pub spikes: Rgb,
    /// The residual: bluish green.
    pub residual: Rgb,
    /// The product with a patch: reddish purple.
    pub product: Rgb,
    /// Overlays, one after the other.
    pub overlays: [Rgb; 4],
}

impl Inks {
    /// Inks on near-black.
    pub const DARK: Self = Self {
        measured: [222, 222, 222],
        smooth: [86, 180, 233],
        spikes: [240, 165, 30],
        residual: [64, 190, 150],
        product: [214, 140, 185],
        overlays: [
            [240, 228, 66],
            [213, 94, 0],
            [150, 150, 220],
            [160, 200, 120],
        ],
    };

    /// Inks on white.
    pub const LIGHT: Self = Self {
        measured: [40, 40, 40],
        smooth: [0, 114, 178],
        spikes: [200, 90, 0],
        residual: [0, 128, 96],
        product: [165, 70, 130],
        overlays: [[150, 130, 0], [160, 60, 0], [90, 80, 170], [70, 120, 40]],
    };

    /// The inks of a theme.
    pub fn of(theme: Theme) -> Self {
        match theme {
            Theme::Dark => Self::DARK,
            Theme::Light => Self::LIGHT,
        }
    }
}

/// The spectrum plot of the present document.
pub fn spectrum_chart(app: &App, theme: Theme) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let (view, band, inks) = (document.view, derived.band, Inks::of(theme));
    let factor = app.scale_factor();
    let curve = |values: &[f64]| -> Vec<[f64; 2]> {
        band.grid()
            .zip(values)
            .map(|(nm, v)| [nm, v * factor])
            .collect()
    };
    let mut series = Vec::new();
    if view.overlays {
        for (i, overlay) in document.overlays.iter().enumerate() {
            let factor = document.scale.factor(&overlay.spectrum).unwrap_or(1.0);
            let samples = &overlay.spectrum.samples;
            let points = samples
                .nm()
                .iter()
                .zip(samples.values())
                .map(|(nm, v)| [*nm, v * factor])
                .collect();
            series.push(Series::line(
                overlay.name(),
                inks.overlays[i % inks.overlays.len()],
                points,
            ));
        }
    }
    let has_subject = app.is_measured_in_range();
    if view.measured && has_subject {
        let points = app.measured_points();
        series.push(Series::line(
            "measured",
            inks.measured,
            points.map(|(nm, v)| [nm, v * factor]).collect(),
        ));
    }
    if view.model && has_subject {
        series.push(Series::line(
            "model",
            inks.spikes,
            curve(&derived.model_values()),
        ));
    }
    if view.smooth && has_subject {
        series.push(Series::line(
            "smooth part",
            inks.smooth,
            curve(&derived.smooth),
        ));
    }
    if view.spikes {
        series.push(stems(app, inks, factor));
    }
    if let Some(product) = app.product() {
        series.push(Series::line(
            format!("through {}", product.name),
            inks.product,
            curve(&product.exact),
        ));
    }
    let strip = (band.min_nm() < 830.0 && band.max_nm() > 360.0).then(|| {
        let ground = match theme {
            Theme::Dark => Srgb([27, 27, 27]),
            Theme::Light => Srgb([255, 255, 255]),
        };
        band.grid()
            .map(|nm| srgb_from_wavelength_over(nm, ground).0)
            .collect()
    });
    let subject = document.subject_entry();
    let unit = app.unit();
    Chart {
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
        y_range: None,
        y_scale: if view.log_axis {
            plot_svg::Scale::Log10
        } else {
            plot_svg::Scale::Linear
        },
        series,
        strip: strip.filter(|_| view.strip),
        residual: (view.residual && has_subject).then(|| Panel {
            y_label: "model - measured".to_owned(),
            y_range: None,
            series: vec![Series::line(
                "residual",
                inks.residual,
                curve(&derived.residual),
            )],
        }),
        notes: provenance(app),
        theme,
        ..Chart::default()
    }
}

/// Errors below this are drawn at it: the axis is logarithmic.
const SMALLEST_ERROR: f64 = 1e-4;

/// The errors against the order as a chart: colour differences, and relative errors in percent.
pub fn curve_chart(app: &App, theme: Theme) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let inks = Inks::of(theme);
    let line = |name: &str, ink: Rgb, of: &dyn Fn(&OrderPoint) -> Option<f64>| {
        let points = derived
            .curve
            .iter()
            .filter_map(|p| Some([p.order as f64, of(p)?.max(SMALLEST_ERROR)]))
            .collect();
        Series::line(name, ink, points)
    };
    let percent = |share: Option<f64>| share.map(|s| 100.0 * s);
    let series = [
        line("own colour, dE00", inks.measured, &|p| p.own),
        line("patches' mean, dE00", inks.smooth, &|p| p.patches_mean),
        line("worst patch, dE00", inks.product, &|p| p.patches_max),
        line("rms at 1 nm, %", inks.spikes, &|p| percent(p.relative_rms)),
        line("rms behind 10 nm, %", inks.residual, &|p| {
            percent(p.relative_rms_10nm)
        }),
    ];
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
        y_scale: plot_svg::Scale::Log10,
        series: series
            .into_iter()
            .filter(|s| !s.marks.points().is_empty())
            .collect(),
        notes: provenance(app),
        theme,
        ..Chart::default()
    }
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

fn stems(app: &App, inks: Inks, factor: f64) -> Series {
    let (derived, settings) = (app.derived(), app.document().settings);
    let spikes = &derived.model.spikes;
    let base: Vec<f64> = spikes
        .iter()
        .map(|s| factor * derived.band.interpolate(&derived.smooth, s.at_nm))
        .collect();
    Series::new(
        "spikes",
        inks.spikes,
        Marks::Stems {
            points: spikes
                .iter()
                .zip(&base)
                .map(|(s, b)| [s.at_nm, b + factor * s.stem_height(settings.max_width_nm)])
                .collect(),
            base,
            labels: spikes
                .iter()
                .zip(app.spike_names())
                .map(|(s, name)| match &name.label {
                    Some(name) => name.clone(),
                    None => format!("{:.1}", s.at_nm),
                })
                .collect(),
        },
    )
}
