//! The curves of a file that was just read, for the look at how it was read.

use crate::{
    app::{
        chart::Inks,
        plot_svg::{Chart, Dash, Series, Theme},
        ticks::extent,
    },
    spectrum::NamedSpectrum,
};

/// Most curves drawn.
pub const MOST_CURVES: usize = 8;

/// Points of a curve beyond which some are left out: the chart is small.
const MOST_POINTS: usize = 2000;

/// The curves of a file, as they were understood.
pub fn curves(file: &str, spectra: &[NamedSpectrum], theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let [a, b, c, _] = inks.overlays;
    let colours = [
        inks.measured,
        inks.smooth,
        inks.spikes,
        inks.residual,
        inks.product,
        a,
        b,
        c,
    ];
    let dashes = [Dash::Solid, Dash::Dashed, Dash::Dotted];
    let shown = &spectra[..spectra.len().min(MOST_CURVES)];
    let series = shown
        .iter()
        .zip(colours)
        .enumerate()
        .map(|(i, (spectrum, colour))| {
            let name = short_name(&spectrum.name);
            Series::line(name, colour, points(spectrum)).dashed(dashes[i % dashes.len()])
        });
    let ends = shown
        .iter()
        .flat_map(|s| [s.samples.first_nm(), s.samples.last_nm()]);
    let y_label = shown.first().map_or_else(String::new, |s| {
        if s.unit.is_empty() || s.unit == s.kind.word() {
            s.kind.word().to_owned()
        } else {
            format!("{} ({})", s.kind.word(), s.unit)
        }
    });
    let title = match spectra.len() {
        0 | 1 => format!("Curve of {file}"),
        n if n > MOST_CURVES => format!("The first {MOST_CURVES} of {n} curves of {file}"),
        n => format!("{n} curves of {file}"),
    };
    Chart {
        title,
        x_label: "Wavelength (nm)".to_owned(),
        y_label,
        x_range: extent(ends).unwrap_or([380.0, 780.0]),
        series: series.collect(),
        theme,
        ..Chart::default()
    }
}

fn short_name(name: &str) -> String {
    match name.char_indices().nth(28) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_owned(),
    }
}

/// Every point, or of a long curve every n-th with the largest among those left out.
fn points(spectrum: &NamedSpectrum) -> Vec<[f64; 2]> {
    let (nm, values) = (spectrum.samples.nm(), spectrum.samples.values());
    let step = nm.len().div_ceil(MOST_POINTS).max(1);
    nm.chunks(step)
        .zip(values.chunks(step))
        .filter_map(|(nm, values)| {
            let pairs = nm.iter().zip(values);
            let (nm, value) = pairs.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
            Some([*nm, *value])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{Kind, Sampled};

    fn spectrum(points: usize) -> NamedSpectrum {
        let mut values = vec![0.0; points];
        values[points / 2] = 7.0;
        NamedSpectrum {
            name: "a".to_owned(),
            kind: Kind::Light,
            unit: String::new(),
            scale: 1.0,
            samples: Sampled::even(300.0, 0.01, values).expect("finite"),
            notes: Vec::new(),
            source: String::new(),
        }
    }

    #[test]
    fn a_long_curve_is_thinned_and_keeps_its_peak() {
        let chart = curves("a.csv", &[spectrum(50_000)], Theme::Dark);
        let points = chart.series[0].marks.points();
        assert!(points.len() <= MOST_POINTS);
        assert!(points.iter().any(|p| p[1] == 7.0));
    }

    #[test]
    fn of_many_curves_the_first_are_drawn_and_it_is_said() {
        let spectra = vec![spectrum(5); 20];
        let chart = curves("a.csv", &spectra, Theme::Light);
        assert_eq!(chart.series.len(), MOST_CURVES);
        assert_eq!(chart.title, "The first 8 of 20 curves of a.csv");
        assert_eq!(curves("a", &[], Theme::Light).series, []);
    }
}
