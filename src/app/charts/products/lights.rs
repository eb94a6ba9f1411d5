//! Two lights as charts: their spectra, and pairs of reflectances.

use crate::app::{
    chart::Inks,
    chart::{Chart, Dash, Series, Theme},
    charts::spectrum::provenance,
    products::two_lights::{LightsSheet, Made},
    state::App,
    studies::surfaces::Surface,
    ticks::short,
};
use crate::spectrum::Band;

/// Both lights, each scaled to Y = 100; what is not seen is left out.
pub fn lights_chart(app: &App, sheet: &LightsSheet, theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let [first, second] = sheet.scaled();
    let mut series = Vec::new();
    if let Some(values) = first {
        let points = points(sheet.band, &values);
        series.push(Series::line(&sheet.lights[0], inks.measured, points));
    }
    if let Some(values) = second {
        let points = points(sheet.band, &values);
        let line = Series::line(&sheet.lights[1], inks.spikes, points);
        series.push(line.dashed(Dash::Dashed));
    }
    Chart {
        title: "The two lights".to_owned(),
        y_label: "value, scaled to Y = 100".to_owned(),
        ..over_wavelength(app, sheet.band, series, theme)
    }
}

/// The two reflectances of a pair that was found.
pub fn pair_chart(app: &App, band: Band, pair: [&Surface; 2], theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let curve = |i: usize, ink| Series::line(&pair[i].key, ink, points(band, &pair[i].values));
    let series = vec![
        curve(0, inks.smooth),
        curve(1, inks.spikes).dashed(Dash::Dashed),
    ];
    Chart {
        title: "The chosen pair".to_owned(),
        y_label: "share of light".to_owned(),
        ..over_wavelength(app, band, series, theme)
    }
}

/// A patch and the metamer made for it.
pub fn made_chart(app: &App, sheet: &LightsSheet, made: &Made, theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let series = vec![
        Series::line(
            &sheet.names[made.patch],
            inks.smooth,
            points(sheet.band, &made.original),
        ),
        Series::line("made", inks.spikes, points(sheet.band, &made.values)).dashed(Dash::Dashed),
    ];
    Chart {
        title: "A patch and its metamer".to_owned(),
        y_label: "share of light".to_owned(),
        y_range: Some([0.0, 1.0]),
        ..over_wavelength(app, sheet.band, series, theme)
    }
}

fn over_wavelength(app: &App, band: Band, series: Vec<Series>, theme: Theme) -> Chart {
    let document = app.document();
    let mut notes = vec![format!("Light: {}", document.light.name())];
    if let Some(other) = &document.products.other_light {
        notes.push(format!("Second light: {}", other.name()));
    }
    notes.push(format!(
        "Range {}-{} nm.",
        short(band.min_nm()),
        short(band.max_nm())
    ));
    notes.extend(provenance(app));
    Chart {
        x_label: "Wavelength (nm)".to_owned(),
        x_range: [band.min_nm(), band.max_nm()],
        series,
        notes,
        theme,
        ..Chart::default()
    }
}

fn points(band: Band, values: &[f64]) -> Vec<[f64; 2]> {
    band.grid().zip(values).map(|(nm, v)| [nm, *v]).collect()
}
