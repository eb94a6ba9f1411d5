//! The peaks of one light, and what each has been told to be so far.

use super::{
    ElementLine,
    peaks::{Peak, Points},
};

/// What a peak is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Told {
    /// Symbol of the element that made it a witness.
    pub symbol: &'static str,
    pub words: String,
    /// The name where there is little room.
    pub label: String,
    /// A pair that is dark in the middle.
    pub is_reversed: bool,
}

impl Told {
    /// A name that is short as it is.
    pub(super) fn plain(symbol: &'static str, words: String) -> Self {
        Self {
            symbol,
            label: words.clone(),
            words,
            is_reversed: false,
        }
    }
}

/// A band of a phosphor that is there: several peaks may be one band, and a spike may stand for all.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BandTold {
    /// The number in its name, nm.
    pub about_nm: f64,
    /// Where its peaks stand, nm.
    pub within_nm: [f64; 2],
    pub told: Told,
}

/// A peak may stand this far from its line, nm: the least for the best data, the most for 5 nm
/// data, where a line's centroid is drawn to the samples.
const REACH_NM: [f64; 2] = [1.2, 3.0];
/// The most for gases with many lines.
const GAS_REACH_NM: f64 = 2.2;
/// Data with narrower peaks can tell gases with many lines.
const FINE_NM: f64 = 2.5;
/// Peaks below this share of the top say nothing about how narrow lines are.
const TELLING: f64 = 0.02;
/// A line of a lamp measures no more, nm; sodium's and thallium's are broadened.
const WIDEST_LINE_NM: f64 = 14.0;

/// The peaks and what is known of them.
#[derive(Debug)]
pub(super) struct Scene<'a> {
    pub points: Points,
    pub peaks: Vec<Peak>,
    pub told: Vec<Option<Told>>,
    /// Bands of phosphors that are there.
    pub bands: Vec<BandTold>,
    /// How far a peak may stand from its line, nm.
    pub reach_nm: f64,
    /// The same for gases with many lines.
    pub gas_reach_nm: f64,
    /// Whether the data can tell gases with many lines.
    pub is_fine: bool,
    lines: &'a [ElementLine],
}

impl<'a> Scene<'a> {
    pub(super) fn of(points: Points, lines: &'a [ElementLine]) -> Self {
        let peaks = points.peaks();
        let telling = TELLING * points.top();
        let strong = peaks.iter().filter(|p| p.height > telling);
        let mut widths: Vec<f64> = strong.map(Peak::width_nm).collect();
        widths.sort_by(f64::total_cmp);
        let narrowest = widths.first().copied().unwrap_or(points.step_nm);
        let middle = widths.get(widths.len() / 2).copied();
        let resolution = narrowest.max(points.step_nm);
        let reach = |width: f64, most: f64| (0.7 + 0.5 * width).clamp(REACH_NM[0], most);
        Self {
            told: vec![None; peaks.len()],
            bands: Vec::new(),
            reach_nm: reach(resolution, REACH_NM[1]),
            gas_reach_nm: reach(middle.unwrap_or(resolution), GAS_REACH_NM),
            is_fine: resolution <= FINE_NM,
            points,
            peaks,
            lines,
        }
    }

    /// The highest peak without a name within reach of a line.
    pub(super) fn near(&self, at_nm: f64) -> Option<usize> {
        self.within(at_nm, self.reach_nm)
    }

    /// The highest line-like peak without a name at most so far away.
    pub(super) fn within(&self, at_nm: f64, reach_nm: f64) -> Option<usize> {
        self.highest(|peak| (peak.at_nm - at_nm).abs() <= reach_nm && is_line(peak))
    }

    /// The highest peak without a name between two wavelengths, be it a line or a band.
    pub(super) fn between(&self, [from_nm, to_nm]: [f64; 2]) -> Option<usize> {
        self.highest(|peak| (from_nm..=to_nm).contains(&peak.at_nm))
    }

    /// The highest peak without a name of which something is true.
    pub(super) fn highest(&self, is_it: impl Fn(&Peak) -> bool) -> Option<usize> {
        let free = (0..self.peaks.len()).filter(|i| self.told[*i].is_none());
        free.filter(|i| is_it(&self.peaks[*i]))
            .max_by(|a, b| self.peaks[*a].height.total_cmp(&self.peaks[*b].height))
    }

    /// The peak's height; 0 for none.
    pub(super) fn height(&self, peak: Option<usize>) -> f64 {
        peak.map_or(0.0, |i| self.peaks[i].height)
    }

    /// The greatest height of several peaks; 0 for none.
    pub(super) fn highest_of(&self, peaks: impl IntoIterator<Item = Option<usize>>) -> f64 {
        let heights = peaks.into_iter().map(|peak| self.height(peak));
        heights.fold(0.0, f64::max)
    }

    /// Whether at most two peaks are higher.
    pub(super) fn is_of_the_three_highest(&self, peak: usize) -> bool {
        let height = self.peaks[peak].height;
        self.peaks.iter().filter(|p| p.height > height).count() < 3
    }

    /// Whether a wavelength lies within the data with some room beside it.
    pub(super) fn covers(&self, at_nm: f64) -> bool {
        const ROOM_NM: f64 = 2.0;
        let (first, last) = (self.points.nm.first(), self.points.nm.last());
        first.is_some_and(|nm| at_nm > nm + ROOM_NM) && last.is_some_and(|nm| at_nm < nm - ROOM_NM)
    }

    /// Gives peaks a name.
    pub(super) fn tell(&mut self, peaks: impl IntoIterator<Item = usize>, told: &Told) {
        for peak in peaks {
            self.told[peak] = Some(told.clone());
        }
    }

    /// Names the peak that stands where a line or a pair seen as one does, if there is one.
    pub(super) fn name_near(&mut self, symbol: &'static str, lines_nm: &[f64]) {
        self.name_peak(self.near(middle(lines_nm)), symbol, lines_nm);
    }

    /// Names a peak, if there is one, after a line or a pair seen as one.
    pub(super) fn name_peak(
        &mut self,
        peak: impl IntoIterator<Item = usize>,
        symbol: &'static str,
        lines_nm: &[f64],
    ) {
        let told = self.name_of(symbol, lines_nm);
        self.tell(peak, &told);
    }

    /// Takes an element's names back.
    pub(super) fn forget(&mut self, symbol: &str) {
        for told in &mut self.told {
            if told.as_ref().is_some_and(|t| t.symbol == symbol) {
                *told = None;
            }
        }
        self.bands.retain(|band| band.told.symbol != symbol);
    }

    /// Takes all names back.
    pub(super) fn forget_all(&mut self) {
        self.told.fill(None);
        self.bands.clear();
    }

    /// Whether a peak carries an element's name.
    pub(super) fn has(&self, symbol: &str) -> bool {
        self.told.iter().flatten().any(|told| told.symbol == symbol)
    }

    /// The name of a line or of a pair seen as one: "Hg 435.8", "Na 568.5", "Hg 577/579".
    pub(super) fn name_of(&self, symbol: &'static str, lines_nm: &[f64]) -> Told {
        Told::plain(
            symbol,
            format!("{symbol} {}", self.number_of(symbol, lines_nm)),
        )
    }

    /// The number in that name, from the places of the table.
    pub(super) fn number_of(&self, symbol: &str, lines_nm: &[f64]) -> String {
        let exact: Vec<f64> = lines_nm.iter().map(|nm| self.exact(symbol, *nm)).collect();
        let (first, last) = (exact[0], exact[exact.len() - 1]);
        if last - first < 1.0 {
            // What no lamp parts.
            format!("{:.1}", 0.5 * (first + last))
        } else {
            format!("{first:.0}/{last:.0}")
        }
    }

    /// Place and strength of all tabulated lines of an element.
    pub(super) fn lines_of(&self, symbol: &str) -> Vec<(f64, f64)> {
        let lines = self.lines.iter().filter(|line| line.element == symbol);
        lines.map(|line| (line.at_nm, line.strength)).collect()
    }

    /// The table's place of a line that is written to a tenth of a nanometre.
    fn exact(&self, symbol: &str, at_nm: f64) -> f64 {
        const SAME_LINE_NM: f64 = 0.06;
        let of_element = self.lines.iter().filter(|l| l.element == symbol);
        of_element
            .map(|line| line.at_nm)
            .find(|nm| (nm - at_nm).abs() <= SAME_LINE_NM)
            .unwrap_or(at_nm)
    }
}

/// Whether a peak is as narrow as a line of a lamp.
pub(super) fn is_line(peak: &Peak) -> bool {
    peak.width_nm() <= WIDEST_LINE_NM
}

/// The middle of lines.
pub(super) fn middle(lines_nm: &[f64]) -> f64 {
    lines_nm.iter().sum::<f64>() / lines_nm.len() as f64
}
