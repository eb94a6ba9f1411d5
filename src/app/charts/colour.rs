//! All spectra that have a colour, drawn together.

use crate::{
    app::{
        chart::{Chart, Dash, Inks, Marks, Palette, Panel, Series, Theme},
        charts::products::chain::strip,
        design::{colour::ColourSheet, method_name},
    },
    color::srgb_from_wavelength,
    design::recover::{BAND, LineLight, Method, Recovered, node_nm},
    spectrum::Outside,
};

/// A slit of this width sees a line as high as it is drawn, nm.
const SLIT_NM: f64 = 5.0;

/// The surfaces of a colour over the band of all that look the same, and below a light of lines.
pub fn colour_chart(sheet: &ColourSheet, theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let mut series = Vec::new();
    if let Some(band) = &sheet.band {
        let points = band.greatest.iter().enumerate();
        let area = Marks::Area {
            points: points.map(|(i, value)| [node_nm(i), *value]).collect(),
            base: band.least.to_vec(),
            is_coloured: false,
        };
        series.push(Series::new("all that look the same", inks.residual, area));
    }
    let curve = |found: &Recovered| -> Vec<[f64; 2]> {
        let table = found.reflectance.sampled();
        let pairs = table.nm().iter().zip(table.values());
        pairs.map(|(nm, value)| [*nm, *value]).collect()
    };
    if let Some(surface) = &sheet.surface {
        let values = surface.spectrum.samples.on_band(BAND, Outside::Hold);
        let points = BAND.grid().zip(values).map(|(nm, v)| [nm, v]).collect();
        series.push(Series::line(surface.name(), inks.measured, points));
    }
    let mut ends = [0.0, 1.0];
    if let Ok(found) = &sheet.fourier {
        let line = Series::line(method_name(found.method), inks.spikes, curve(found));
        series.push(line.dashed(Dash::Dashed));
        let [low, high] = found.reflectance.extent();
        ends = [low.min(ends[0]), high.max(ends[1])];
    }
    let line = Series::line(
        method_name(Method::Smoothest),
        inks.smooth,
        curve(&sheet.smoothest),
    );
    series.push(line);
    if ends != [0.0, 1.0] {
        for level in [0.0, 1.0] {
            let points = vec![[BAND.min_nm(), level], [BAND.max_nm(), level]];
            let edge = Series::line("", Palette::of(theme).axis, points);
            series.push(edge.dashed(Dash::Dotted));
        }
    }
    Chart {
        title: "Surfaces that have the colour".to_owned(),
        x_label: "Wavelength (nm)".to_owned(),
        y_label: "Reflectance".to_owned(),
        x_range: [BAND.min_nm(), BAND.max_nm()],
        y_range: Some(ends),
        colours: strip(BAND, theme).unwrap_or_default(),
        strip: true,
        residual: sheet
            .lines
            .as_ref()
            .ok()
            .map(|light| lines_panel(light, theme)),
        series,
        theme,
        ..Chart::default()
    }
}

/// A light of lines over its background.
fn lines_panel(light: &LineLight, theme: Theme) -> Panel {
    let points = BAND.grid().zip(&light.background);
    let area = Marks::Area {
        points: points.map(|(nm, value)| [nm, *value]).collect(),
        base: Vec::new(),
        is_coloured: true,
    };
    let mut series = vec![Series::new("", Inks::of(theme).measured, area)];
    for line in light.lines.iter().filter(|line| line.weight > 0.0) {
        let stem = Marks::Stems {
            points: vec![[line.at_nm, line.weight / SLIT_NM]],
            base: Vec::new(),
            labels: Vec::new(),
        };
        let colour = srgb_from_wavelength(line.at_nm).0;
        series.push(Series::new("", colour, stem));
    }
    Panel {
        y_label: "Light of lines, power a nm".to_owned(),
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
        let chart = colour_chart(&sheet, Theme::Dark);
        let names: Vec<&str> = chart.series.iter().map(|s| s.name.as_str()).collect();
        for name in ["all that look the same", "red", "Smoothest surface"] {
            assert!(names.contains(&name), "{names:?}");
        }
        assert!(chart.residual.is_some());
    }
}
