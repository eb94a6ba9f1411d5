//! Charts of the part "chain" of the page "Products": the stages of a chain.

use crate::{
    app::{
        chart::Inks,
        chart::{Chart, Marks, Rgb, Series, Theme},
        products::KnownLines,
        ticks::short,
    },
    color::{Srgb, srgb_from_wavelength_over},
    spectrum::{Band, Spike},
};

/// The light behind a stage, as it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct StageDrawn<'a> {
    /// What stands over the chart.
    pub title: &'a str,
    /// The grid.
    pub band: Band,
    /// The exact light on the grid.
    pub exact: &'a [f64],
    /// The model's smooth part on the grid.
    pub smooth: &'a [f64],
    /// The model's spikes.
    pub spikes: &'a [Spike],
    /// What they are called.
    pub known: &'a KnownLines,
    /// Full width with which a spike is drawn, nm.
    pub width_nm: f64,
    /// Factor from the light's own numbers to the scale in force.
    pub factor: f64,
    /// The unit of that scale; empty for none.
    pub unit: &'a str,
    /// Where the numbers come from.
    pub notes: &'a [String],
}

/// The light behind a stage: exact curve, smooth part, spikes as stems.
pub fn stage_chart(stage: StageDrawn<'_>, theme: Theme) -> Chart {
    let (inks, band, factor) = (Inks::of(theme), stage.band, stage.factor);
    let curve = |values: &[f64]| -> Vec<[f64; 2]> {
        let scaled = values.iter().map(|v| v * factor);
        band.grid().zip(scaled).map(|(nm, v)| [nm, v]).collect()
    };
    let mut series = vec![
        Series::line("exact", inks.measured, curve(stage.exact)),
        Series::line("smooth part", inks.smooth, curve(stage.smooth)),
    ];
    let (up, down): (Vec<Spike>, Vec<Spike>) = stage.spikes.iter().partition(|s| s.weight >= 0.0);
    for (name, ink, spikes) in [
        ("spikes", inks.spikes, up),
        ("negative spikes", inks.product, down),
    ] {
        if !spikes.is_empty() {
            series.push(stems(name, ink, &spikes, stage));
        }
    }
    Chart {
        title: stage.title.to_owned(),
        x_label: "Wavelength (nm)".to_owned(),
        y_label: if stage.unit.is_empty() {
            "value".to_owned()
        } else {
            stage.unit.to_owned()
        },
        x_range: [band.min_nm(), band.max_nm()],
        series,
        strip: strip(band, theme),
        notes: stage.notes.to_vec(),
        theme,
        ..Chart::default()
    }
}

fn stems(name: &str, ink: Rgb, spikes: &[Spike], stage: StageDrawn<'_>) -> Series {
    let base: Vec<f64> = spikes
        .iter()
        .map(|s| stage.factor * stage.band.interpolate(stage.smooth, s.at_nm))
        .collect();
    let points = spikes
        .iter()
        .zip(&base)
        .map(|(s, b)| [s.at_nm, b + stage.factor * s.stem_height(stage.width_nm)])
        .collect();
    let label = |s: &Spike| match stage.known.safe(s.at_nm) {
        Some(name) => name.to_owned(),
        None => format!("{:.1}", s.at_nm),
    };
    let labels: Vec<String> = spikes.iter().map(label).collect();
    let notes = spikes
        .iter()
        .zip(&labels)
        .map(|(s, label)| format!("{label}: weight {}", short(stage.factor * s.weight)))
        .collect();
    Series::new(
        name,
        ink,
        Marks::Stems {
            points,
            base,
            labels,
        },
    )
    .with_notes(notes)
}

/// The colours of the wavelengths along the axis, where there are any.
pub fn strip(band: Band, theme: Theme) -> Option<Vec<Rgb>> {
    let ground = match theme {
        Theme::Dark => Srgb([27, 27, 27]),
        Theme::Light => Srgb([255, 255, 255]),
    };
    let has_colour = band.min_nm() < 830.0 && band.max_nm() > 360.0;
    has_colour.then(|| {
        let colours = band.grid();
        colours
            .map(|nm| srgb_from_wavelength_over(nm, ground).0)
            .collect()
    })
}
