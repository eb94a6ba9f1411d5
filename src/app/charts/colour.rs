//! All spectra that have a colour, drawn together.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Panel, Series, curve, stroke},
        charts::{
            products::chain::strip,
            spectrum::{on_grid, over},
        },
        design::{colour::ColourSheet, method_name},
    },
    color::srgb_from_wavelength,
    design::recover::{BAND, LineLight, Method, Recovered, node_nm},
    languages::said,
    spectrum::Outside,
};

/// A slit of this width sees a line as high as it is drawn, nm.
pub(super) const SLIT_NM: f64 = 5.0;

/// What the surfaces are called that only show how different those of one colour can be.
const EXAMPLES: &str = later!("other surfaces that match");

/// The surfaces of a colour over the reach of all that match it, and below a light of lines.
pub fn colour_chart(sheet: &ColourSheet) -> Chart {
    let mut series = Vec::new();
    if let Some(band) = &sheet.band {
        let edge = |values: &[f64]| {
            let points = values.iter().enumerate();
            points.map(|(i, value)| [node_nm(i), *value]).collect()
        };
        for values in [&band.greatest, &band.least] {
            let name = said!("reach of all surfaces that match");
            let line = Series::line(name, Ink::Residual, edge(&values[..]));
            series.push(line.dashed(Dash::Dotted));
        }
        for example in &sheet.examples {
            let points = edge(example);
            let name = said(EXAMPLES);
            series.push(stroke(name, Ink::Faint, points, 1.0, Dash::Solid));
        }
    }
    let of = |found: &Recovered| {
        let table = found.reflectance.sampled();
        curve(table.nm().iter().copied(), table.values().iter().copied())
    };
    if let Some(surface) = &sheet.surface {
        let values = surface.spectrum.samples.on_band(BAND, Outside::Hold);
        let points = curve(BAND.grid(), values);
        series.push(Series::line(surface.name(), Ink::Measured, points));
    }
    let mut ends = [0.0, 1.0];
    if let Ok(found) = &sheet.fourier {
        let line = Series::line(method_name(found.method), Ink::Spikes, of(found));
        series.push(line.dashed(Dash::Dashed));
        let [low, high] = found.reflectance.extent();
        ends = [low.min(ends[0]), high.max(ends[1])];
    }
    let smoothest = of(&sheet.smoothest);
    series.push(Series::line(
        method_name(Method::Smoothest),
        Ink::Smooth,
        smoothest,
    ));
    if ends != [0.0, 1.0] {
        for level in [0.0, 1.0] {
            let points = vec![[BAND.min_nm(), level], [BAND.max_nm(), level]];
            let edge = Series::line("", Ink::Axis, points);
            series.push(edge.dashed(Dash::Dotted));
        }
    }
    Chart {
        title: said!("Surfaces that have the colour").to_owned(),
        y_label: said!("Reflectance").to_owned(),
        y_range: Some(ends),
        colours: strip(BAND),
        strip: true,
        residual: sheet.lines.as_ref().ok().map(lines_panel),
        series,
        ..over(BAND)
    }
}

/// A light of lines over its background.
fn lines_panel(light: &LineLight) -> Panel {
    let background = on_grid(BAND, &light.background, 1.0);
    let area = Series::area("", Ink::Measured, background, Vec::new());
    let mut series = vec![area.coloured()];
    for line in light.lines.iter().filter(|line| line.weight > 0.0) {
        let top = vec![[line.at_nm, line.weight / SLIT_NM]];
        let colour = srgb_from_wavelength(line.at_nm).0;
        series.push(Series::stems("", colour, top, Vec::new()));
    }
    Panel {
        y_label: said!("Light of lines, power per nm").to_owned(),
        y_range: None,
        series,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, design::colour::FromColour, recipe::Given};

    #[test]
    fn all_that_has_the_colour_is_drawn_together() {
        let from = FromColour {
            given: Given::Of("colorchecker_ohta/red".to_owned()),
            ..FromColour::default()
        };
        let sheet = ColourSheet::of(&from, App::new().document()).expect("a colour");
        let chart = colour_chart(&sheet);
        let names: Vec<&str> = chart.series.iter().map(|s| s.name.as_str()).collect();
        for name in [
            "reach of all surfaces that match",
            "red",
            "Smoothest surface",
        ] {
            assert!(names.contains(&name), "{names:?}");
        }
        assert!(chart.residual.is_some());
        let examples = chart.series.iter().filter(|s| s.name == EXAMPLES);
        assert_eq!(examples.count(), 8);
    }
}
