//! Lines as wide as they are: each is given the width that fits best what the detector took out,
//! and leaves its Gaussian out of the smooth part.

use super::less;
use crate::{
    lamps::{Composite, Spike as WideSpike, add_spikes, as_wide_as_it_is},
    spectrum::{Band, Decomposed, LineShape, Spike},
};

/// The lines of a model by their widths; without a width everywhere where all are ideal.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Widths {
    /// Full width at half maximum of each line, nm; 0 is ideal. Empty where none was asked for.
    pub nm: Vec<f64>,
    /// Those that have a width, on the grid; empty where there are none.
    pub bells: Vec<f64>,
}

impl Widths {
    /// The widths of what a spectrum was taken apart to. The smooth part is changed with them: it
    /// keeps what a Gaussian cannot say of a line.
    pub(super) fn of(
        band: Band,
        measured: &[f64],
        parts: &mut Decomposed,
        max_width_nm: f64,
    ) -> Self {
        let taken = less(measured, &parts.smooth);
        let mut lines = Vec::with_capacity(parts.spikes.len());
        for found in &mut parts.spikes {
            let mut line = WideSpike::ideal(found.spike.at_nm, found.spike.weight);
            // A spike that was set where no line is has no width.
            if let Some(window) = found.window_nm {
                let shape = shape_in(band, window, &taken);
                // One that was moved is as wide as the line that it stands for, and leaves that.
                let own = as_wide_as_it_is(band, &shape, max_width_nm);
                if !own.is_ideal() {
                    line.width_nm = own.width_nm;
                    found.width_nm = Some(own.width_nm);
                    shape.give_back_to(&mut parts.smooth);
                    own.shape(band).add_to(-own.weight, &mut parts.smooth);
                }
            }
            lines.push(line);
        }
        Self::of_lines(band, &lines)
    }

    /// A composite as it is, which `measured` on its band's grid is the table of, and its widths where
    /// they are `wanted`.
    pub(super) fn of_composite(
        given: &Composite,
        measured: &[f64],
        wanted: bool,
    ) -> (Decomposed, Self) {
        let band = given.band();
        let mut parts = Decomposed::of_composite(&given.idealised(), measured);
        let inside = given.spikes.iter().filter(|line| band.contains(line.at_nm));
        let mut lines: Vec<WideSpike> = inside.copied().collect();
        lines.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        if !wanted || lines.iter().all(|line| line.is_ideal()) {
            return (parts, Self::default());
        }
        for (found, line) in parts.spikes.iter_mut().zip(&lines) {
            if !line.is_ideal() {
                found.width_nm = Some(line.width_nm);
            }
        }
        (parts, Self::of_lines(band, &lines))
    }

    fn of_lines(band: Band, lines: &[WideSpike]) -> Self {
        let wide: Vec<WideSpike> = lines.iter().copied().filter(|l| !l.is_ideal()).collect();
        let mut bells = Vec::new();
        if !wide.is_empty() {
            bells = vec![0.0; band.points()];
            add_spikes(band, &wide, &mut bells);
        }
        Self {
            nm: lines.iter().map(|line| line.width_nm).collect(),
            bells,
        }
    }

    /// Whether any line has a width.
    pub fn is_wide(&self) -> bool {
        !self.bells.is_empty()
    }

    /// The widths as files have them: none where all lines are ideal.
    pub fn written(&self) -> Vec<f64> {
        if self.is_wide() {
            self.nm.clone()
        } else {
            Vec::new()
        }
    }

    /// The lines of no width among these.
    pub fn ideal(&self, spikes: &[Spike]) -> Vec<Spike> {
        if !self.is_wide() {
            return spikes.to_vec();
        }
        let with_widths = spikes.iter().zip(&self.nm);
        let ideal = with_widths.filter(|(_, width)| **width == 0.0);
        ideal.map(|(spike, _)| *spike).collect()
    }

    /// Values on the grid with the lines that have a width.
    pub fn with_bells(&self, mut values: Vec<f64>) -> Vec<f64> {
        for (value, bell) in values.iter_mut().zip(&self.bells) {
            *value += bell;
        }
        values
    }
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
        spike: Spike {
            at_nm: at_nm.unwrap_or(middle),
            weight,
        },
        first,
        residue,
    }
}

#[cfg(test)]
mod tests {
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
        assert_eq!(derived.widths.nm.len(), expected.spikes.len());
        assert!(derived.widths.is_wide());
        for (width, line) in derived.widths.nm.iter().zip(&expected.spikes) {
            // The same stored width but for the rounding of a difference.
            assert!((width - line.width_nm).abs() < 0.05 * line.width_nm.max(2.0));
        }
        let mut whole = derived.widths.with_bells(derived.parts.smooth.clone());
        let ideal = derived.widths.ideal(&derived.model.spikes);
        crate::spectrum::add_spikes(derived.band, &ideal, &mut whole);
        // A line of one sample is ideal: it has its power, not its form.
        let [power, of_table] = [&whole, &derived.measured].map(|v| derived.band.integral(v));
        assert!((power - of_table).abs() < 1e-10 * of_table);
        let bells = derived.widths.bells.iter().filter(|v| **v > 0.0).count();
        assert!(bells > 20, "{bells} points under a line");
    }

    #[test]
    fn wide_lines_cost_a_label_and_bring_the_spectrum_nearer() {
        let mut app = App::new();
        app.apply(Command::Show(
            app.entry("cie_fluorescent_1nm/FL11").expect("shipped"),
        ));
        let before = app.derived().clone();
        assert!(!before.widths.is_wide() && before.widths.nm.is_empty());
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
