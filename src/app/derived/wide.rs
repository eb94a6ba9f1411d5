//! Lines as wide as they are: each is given the width that fits best what the detector took out,
//! and leaves its Gaussian out of the smooth part.

use super::less;
use crate::{
    lamps::as_wide_as_it_is,
    spectrum::{Band, Composite, Decomposed, Line, LineShape, add_lines},
};

/// The lines of what a spectrum was taken apart to, as wide as they are. The smooth part is changed
/// with them: it keeps what a Gaussian cannot say of a line.
pub(super) fn widened(
    band: Band,
    measured: &[f64],
    parts: &mut Decomposed,
    max_width_nm: f64,
) -> Vec<Line> {
    let taken = less(measured, &parts.smooth);
    let mut lines = parts.plain_spikes();
    for (found, line) in parts.spikes.iter_mut().zip(&mut lines) {
        // A spike that was set where no line is has no width.
        let Some(window) = found.window_nm else {
            continue;
        };
        let shape = shape_in(band, window, &taken);
        // One that was moved is as wide as the line that it stands for, and leaves that.
        let own = as_wide_as_it_is(band, &shape, max_width_nm);
        if !own.is_ideal() {
            line.fwhm_nm = own.fwhm_nm;
            found.width_nm = Some(own.fwhm_nm);
            shape.give_back_to(&mut parts.smooth);
            own.profile(band).add_to(-own.weight, &mut parts.smooth);
        }
    }
    lines
}

/// A composite as it is, which `measured` on its band's grid is the table of, and its lines, with
/// their widths where they are `wanted`.
pub(super) fn of_composite(
    given: &Composite,
    measured: &[f64],
    wanted: bool,
) -> (Decomposed, Vec<Line>) {
    let mut parts = Decomposed::of_composite(&given.idealised(), measured);
    if !wanted || given.lines().iter().all(|line| line.is_ideal()) {
        let lines = parts.plain_spikes();
        return (parts, lines);
    }
    for (found, line) in parts.spikes.iter_mut().zip(given.lines()) {
        if !line.is_ideal() {
            found.width_nm = Some(line.fwhm_nm);
        }
    }
    (parts, given.lines().to_vec())
}

/// The lines that have a width, on the grid; empty where none has.
pub(super) fn bells(band: Band, lines: &[Line]) -> Vec<f64> {
    let wide: Vec<Line> = lines.iter().copied().filter(|l| !l.is_ideal()).collect();
    if wide.is_empty() {
        return Vec::new();
    }
    let mut bells = vec![0.0; band.points()];
    add_lines(band, &wide, &mut bells);
    bells
}

/// Values on the grid with the lines that have a width.
pub(super) fn with_bells(mut values: Vec<f64>, bells: &[f64]) -> Vec<f64> {
    for (value, bell) in values.iter_mut().zip(bells) {
        *value += bell;
    }
    values
}

/// What was taken out in a window, with its place and its energy.
fn shape_in(band: Band, window_nm: [f64; 2], taken: &[f64]) -> LineShape {
    let index = |nm: f64| (nm - band.min_nm()).round().clamp(0.0, band.steps() as f64) as usize;
    let [first, last] = window_nm.map(index);
    let residue = taken[first..=last.max(first)].to_vec();
    let weighed = residue.iter().zip(first..);
    let parts = weighed.map(|(r, i)| (band.nm(i), band.weight(i) * r));
    let (weight, moment) = parts.fold((0.0, 0.0), |(e, m), (nm, w)| (e + w, m + w * nm));
    let middle = 0.5 * (band.nm(first) + band.nm(last.max(first)));
    let at_nm = Some(moment / weight).filter(|nm| band.contains(*nm));
    LineShape {
        spike: Line::ideal(at_nm.unwrap_or(middle), weight),
        first,
        residue,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{Basis, Series};
    use crate::{
        app::{App, Command, Settings},
        lamps::decompose,
        study::Measure,
    };

    fn wide(app: &mut App, wide_lines: bool) {
        app.apply(Command::Edit(Settings {
            wide_lines,
            ..app.document().settings
        }));
    }

    #[test]
    fn widths_are_those_of_the_encoder_and_nothing_is_lost() {
        let mut app = App::new();
        app.apply(Command::Show(
            app.entry("cie_fluorescent_1nm/FL11").expect("shipped"),
        ));
        wide(&mut app, true);
        let derived = app.derived();
        let settings = app.document().settings.spike_settings();
        let expected = decompose(derived.band, &derived.measured, settings);
        let lines = derived.model.lines();
        assert_eq!(lines.len(), expected.spikes.len());
        assert!(derived.model.has_widths());
        for (line, expected) in lines.iter().zip(&expected.spikes) {
            // The same stored width but for the rounding of a difference.
            let off = (line.fwhm_nm - expected.fwhm_nm).abs();
            assert!(off < 0.05 * expected.fwhm_nm.max(2.0));
        }
        let mut whole = derived.parts.smooth.clone();
        crate::spectrum::add_lines(derived.band, lines, &mut whole);
        // A line of one sample is ideal: it has its power, not its form.
        let [power, of_table] = [&whole, &derived.measured].map(|v| derived.band.integral(v));
        assert!((power - of_table).abs() < 1e-10 * of_table);
        let bells = derived.bells.iter().filter(|v| **v > 0.0).count();
        assert!(bells > 20, "{bells} points under a line");
    }

    #[test]
    fn a_composite_shown_as_it_is_has_ideal_lines_unless_widths_are_wanted() {
        let smooth = Series {
            band: Band::VISIBLE,
            basis: Basis::Cosine,
            coefficients: vec![1.0, 0.5, -0.25],
        };
        let line = Line {
            at_nm: 546.1,
            weight: 30.0,
            fwhm_nm: 8.0,
        };
        let given = Composite::new(smooth, vec![line]).expect("a composite");
        let measured = given.on_band();
        let lines = |wanted| of_composite(&given, &measured, wanted).1;
        assert_eq!(lines(true), [line]);
        assert_eq!(lines(false), [Line::ideal(546.1, 30.0)]);
    }

    #[test]
    fn wide_lines_cost_a_label_and_bring_the_spectrum_nearer() {
        let mut app = App::new();
        app.apply(Command::Show(
            app.entry("cie_fluorescent_1nm/FL11").expect("shipped"),
        ));
        let before = app.derived().clone();
        assert!(!before.model.has_widths() && before.bells.is_empty());
        wide(&mut app, true);
        let after = app.derived().clone();
        assert_eq!(after.numbers(), before.numbers() + 1);
        for measure in [Measure::Rms, Measure::RmsBlurred] {
            let [is, was] = [&after, &before].map(|d| d.figures[measure].expect("a light"));
            assert!(is < was, "{measure:?}: {is} {was}");
        }
        let own = after.figures[Measure::Own].expect("a colour");
        assert!(own < 1e-6, "colour-exact with widths too: {own}");
        let last = after.curve.iter().find(|p| p.order == 7).expect("in reach");
        assert_eq!(last.numbers, after.numbers());
        for measure in [Measure::Patches, Measure::Rms, Measure::RmsBlurred] {
            let [curve, page] = [last.figures[measure], after.figures[measure]];
            let [curve, page] = [curve, page].map(|v| v.expect("a light"));
            assert!((curve - page).abs() < 1e-9 * page.max(1.0), "{measure:?}");
        }
        wide(&mut app, false);
        assert_eq!(**app.derived(), *before);
    }
}
