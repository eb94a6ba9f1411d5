//! The curves of a file that was just read, for the look at how it was read.

use super::spectrum::broken_at_holes;
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Series},
        ticks::{extent, short},
    },
    spectrum::{Kind, NamedSpectrum},
};

/// Most curves drawn.
pub const MOST_CURVES: usize = 12;

/// Points of a curve beyond which some are left out: the chart is small.
const MOST_POINTS: usize = 2000;

/// The curves of a file, as they were understood.
pub fn curves(file: &str, spectra: &[NamedSpectrum]) -> Chart {
    let [a, b, c] = [0, 1, 2].map(Ink::Overlay);
    let colours = [
        Ink::Measured,
        Ink::Smooth,
        Ink::Spikes,
        Ink::Residual,
        Ink::Product,
        a,
        b,
        c,
    ];
    let dashes = [Dash::Solid, Dash::Dashed, Dash::Dotted];
    let shown = &spectra[..spectra.len().min(MOST_CURVES)];
    let kinds_differ = shown.windows(2).any(|pair| pair[0].kind != pair[1].kind);
    let cut = height(shown);
    let series = shown
        .iter()
        .zip(colours.into_iter().cycle())
        .enumerate()
        .map(|(i, (spectrum, colour))| {
            let name = named(spectrum, kinds_differ);
            Series::line(name, colour, points(spectrum)).dashed(dashes[i % dashes.len()])
        });
    let ends = shown
        .iter()
        .flat_map(|s| [s.samples.first_nm(), s.samples.last_nm()]);
    let y_label = shown.first().map_or_else(String::new, |s| {
        if kinds_differ {
            said!("value").to_owned()
        } else if s.unit.is_empty() || s.unit == s.kind.word() {
            kind_words(s.kind).to_owned()
        } else {
            format!("{} ({})", kind_words(s.kind), s.unit)
        }
    });
    let title = match spectra.len() {
        0 | 1 => tr!("Curve of {file}", file),
        n if n > MOST_CURVES => tr!(
            "The first {shown} of {n} curves of {file} (+ {more} more)",
            shown = MOST_CURVES,
            n,
            file,
            more = n - MOST_CURVES
        ),
        n => tr!("{n} curves of {file}", n, file),
    };
    let title = match cut {
        Some((_, share)) => {
            let [low, high] = [share, 1.0 - share].map(|share| short(100.0 * share));
            tr!(
                "{title}; height: {low}–{high} % of values",
                title,
                low,
                high
            )
        }
        None => title,
    };
    Chart {
        title,
        y_label,
        y_range: cut.map(|(range, _)| range),
        series: series.collect(),
        ..Chart::over_nm(extent(ends).unwrap_or([380.0, 780.0]))
    }
}

/// Letters of a name that are shown from its beginning and from its end: doubles differ there.
const NAME_LETTERS: [usize; 2] = [18, 10];

/// What a kind is called in a sentence.
fn kind_words(kind: Kind) -> &'static str {
    match kind {
        Kind::Light => said!("light"),
        Kind::Reflectance => said!("reflectance"),
        Kind::Transmittance => said!("transmittance"),
        Kind::Absorbance => said!("absorbance"),
        Kind::Weighting => said!("weighting"),
        Kind::Lines => said!("lines"),
        Kind::Other => said!("other"),
    }
}

fn named(spectrum: &NamedSpectrum, with_kind: bool) -> String {
    let name = short_name(&spectrum.name);
    if with_kind {
        format!("{name} ({})", kind_words(spectrum.kind))
    } else {
        name
    }
}

fn short_name(name: &str) -> String {
    let [first, last] = NAME_LETTERS;
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= first + last + 1 {
        return name.to_owned();
    }
    let start: String = letters[..first].iter().collect();
    let end: String = letters[letters.len() - last..].iter().collect();
    format!("{start}…{end}")
}

/// Shares of the values at either end that may lie outside the picture, the least that helps.
const EXTREMES: [f64; 3] = [0.005, 0.01, 0.03];

/// How much farther than the middle nine tenths of the values extremes must lie to be left out.
const FAR: f64 = 3.0;

/// The range of values that shows the curves where a few noisy extremes would flatten them, and
/// the share of the values left out at either end. Noise goes down as far as up: the lines of a
/// lamp, which only go up, are never cut.
fn height(spectra: &[NamedSpectrum]) -> Option<([f64; 2], f64)> {
    let mut all: Vec<f64> = spectra
        .iter()
        .flat_map(|s| s.samples.values().iter().copied())
        .collect();
    if all.len() < 200 {
        return None;
    }
    all.sort_by(f64::total_cmp);
    let last = all.len() - 1;
    let at = |share: f64| all[(share * last as f64).round() as usize];
    let middle = at(0.95) - at(0.05);
    if middle <= 0.0 || at(0.05) - all[0] <= FAR * middle {
        return None;
    }
    let between = |share: f64| [at(share), at(1.0 - share)];
    let fits = |share: &&f64| {
        let [low, high] = between(**share);
        high - low <= FAR * middle
    };
    let share = EXTREMES.iter().find(fits).unwrap_or(&EXTREMES[2]);
    let [low, high] = between(*share);
    let room = 0.08 * (high - low);
    Some(([low - room, high + room], *share))
}

/// Every point, or of a long curve every n-th with the largest among those left out.
fn points(spectrum: &NamedSpectrum) -> Vec<[f64; 2]> {
    let (nm, values) = (spectrum.samples.nm(), spectrum.samples.values());
    let step = nm.len().div_ceil(MOST_POINTS).max(1);
    let points = nm
        .chunks(step)
        .zip(values.chunks(step))
        .filter_map(|(nm, values)| {
            let pairs = nm.iter().zip(values);
            let (nm, value) = pairs.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
            Some([*nm, *value])
        });
    broken_at_holes(points.collect(), &spectrum.samples)
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
    fn a_hole_in_the_measurement_breaks_the_curve() {
        let nm: Vec<f64> = (380..=420).chain(680..=780).map(f64::from).collect();
        let values = vec![1.0; nm.len()];
        let mut holed = spectrum(2);
        holed.samples = Sampled::new(nm, values).expect("rising");
        let chart = curves("a.csv", &[holed]);
        let points = chart.series[0].marks.points();
        let broken: Vec<f64> = points
            .iter()
            .filter(|p| p[1].is_nan())
            .map(|p| p[0])
            .collect();
        assert_eq!(broken, [550.0]);
        assert_eq!(points.len(), 143);
    }

    #[test]
    fn a_long_curve_is_thinned_and_keeps_its_peak() {
        let chart = curves("a.csv", &[spectrum(50_000)]);
        let points = chart.series[0].marks.points();
        assert!(points.len() <= MOST_POINTS);
        assert!(points.iter().any(|p| p[1] == 7.0));
    }

    #[test]
    fn of_many_curves_the_first_are_drawn_and_it_is_said() {
        let spectra = vec![spectrum(5); 20];
        let chart = curves("a.csv", &spectra);
        assert_eq!(chart.series.len(), MOST_CURVES);
        assert_eq!(chart.title, "The first 12 of 20 curves of a.csv (+ 8 more)");
        assert_eq!(curves("a", &[]).series, []);
    }
}
