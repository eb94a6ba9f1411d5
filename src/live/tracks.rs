//! A stream over time: every frame as a composite, its CCT and Y, in little memory.
//!
//! A line is looked for once a second in the newest frame and then followed at its place: what stands
//! above the chord of its window. What is left is the glow, kept as a cosine series. Blocks of
//! frames hold their columns as steps of 1/65,534 of what each spans, so that 16 lines and 15 numbers
//! of the glow take 70 bytes a frame: 2.5 MB for an hour at 10 frames a second.

use std::fmt::Write as _;

use serde::{Deserialize, Serialize};

use crate::{
    color::xyz::{FIRST_NM, LAST_NM},
    color::{Observer, Xyz, cct_from_xyz, xyz::xyz_from_nm_values},
    spectrum::{
        Band, Basis, BasisTable, Composite, Line, Outside, Sampled, Series, SpikeSettings, detect,
    },
};

/// Lines that are followed, the first that were found.
pub const MOST_LINES: usize = 16;

/// Numbers of the glow.
const NUMBERS: usize = 15;

/// Columns of a frame: time, Y, CCT, the glow's numbers, the lines' weights.
const COLUMNS: usize = 3 + NUMBERS + MOST_LINES;
const Y: usize = 1;
const CCT: usize = 2;
const GLOW: usize = 3;
const LINES: usize = GLOW + NUMBERS;

/// Frames of a block.
const ROWS: usize = 256;

/// The code of no value, and the highest of one.
const NONE: u16 = u16::MAX;
const HIGHEST: f32 = 65_534.0;

/// Between two looks for lines, ms.
const LOOK_MS: f64 = 1000.0;

/// A line that is followed.
#[derive(Clone, Copy, Debug)]
struct Followed {
    at_nm: f64,
    /// First and last grid point of its window.
    from: usize,
    to: usize,
}

/// The columns of some frames, each in steps of what it spans.
#[derive(Debug)]
struct Block {
    begins_ms: f64,
    lowest: [f32; COLUMNS],
    step: [f32; COLUMNS],
    codes: Box<[u16]>,
}

/// One of the quantities over time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Track {
    /// The sum with the luminosity function.
    #[default]
    Y,
    /// The correlated colour temperature.
    Cct,
    /// The share of the power that is no line.
    Glow,
    /// The weights of the lines.
    Lines,
}

/// A frame as it is kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub time_ms: f64,
    /// Sum with the luminosity function, in the unit of the values x nm.
    pub y: f64,
    /// Correlated colour temperature, K, where there is one.
    pub cct: Option<f64>,
    /// Glow and lines.
    pub composite: Composite,
    /// Weights of all lines that are followed; `None` before a line was found.
    pub weights: Vec<Option<f64>>,
}

impl Point {
    /// The share of the power that is no line, in 0-1; `None` in the dark.
    pub fn glow(&self) -> Option<f64> {
        let lines: f64 = self.weights.iter().flatten().sum();
        let smooth = self.composite.smooth();
        let glow = smooth.band.integral(&smooth.on_band());
        (glow + lines > 0.0).then(|| glow / (glow + lines))
    }
}

/// A stream over time.
#[derive(Debug)]
pub struct Tracks {
    table: BasisTable,
    lines: Vec<Followed>,
    looked_ms: Option<f64>,
    blocks: Vec<Block>,
    /// The newest frames; their times count from `begins_ms`.
    open: Vec<[f32; COLUMNS]>,
    begins_ms: f64,
}

impl Default for Tracks {
    fn default() -> Self {
        Self {
            table: BasisTable::new(Band::VISIBLE, Basis::Cosine, NUMBERS),
            lines: Vec::new(),
            looked_ms: None,
            blocks: Vec::new(),
            open: Vec::with_capacity(ROWS),
            begins_ms: 0.0,
        }
    }
}

/// X, Y and Z of a light in the unit of its values x nm, not normalised.
pub fn sums(light: &Sampled) -> Xyz {
    let values = light.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero);
    xyz_from_nm_values(&values, Observer::CIE_1931)
}

impl Tracks {
    /// Takes the spectrum of a time.
    pub fn push(&mut self, time_ms: f64, light: &Sampled) {
        let band = self.table.band();
        let mut values = light.on_band(band, Outside::Zero);
        let is_due = self
            .looked_ms
            .is_none_or(|looked| !(0.0..LOOK_MS).contains(&(time_ms - looked)));
        if is_due {
            self.looked_ms = Some(time_ms);
            self.look(band, &values);
        }
        if self.open.is_empty() {
            self.begins_ms = time_ms;
        }
        let mut row = [f32::NAN; COLUMNS];
        row[0] = (time_ms - self.begins_ms) as f32;
        let xyz = sums(light);
        row[Y] = xyz.y as f32;
        if let Ok(cct) = cct_from_xyz(xyz) {
            row[CCT] = cct.kelvin as f32;
        }
        for (line, cell) in self.lines.iter().zip(&mut row[LINES..]) {
            *cell = line.taken_from(&mut values) as f32;
        }
        let numbers = self.table.project(&values, NUMBERS);
        let glow = row[GLOW..LINES].iter_mut().zip(numbers);
        glow.for_each(|(cell, number)| *cell = number as f32);
        self.open.push(row);
        if self.open.len() == ROWS {
            self.blocks.push(Block::of(self.begins_ms, &self.open));
            self.open.clear();
        }
    }

    /// Looks for lines that are not followed yet.
    fn look(&mut self, band: Band, values: &[f64]) {
        let found = detect(band, values, SpikeSettings::default());
        for spike in found.spikes {
            let place = |nm: f64| (nm - band.min_nm()).round().max(0.0) as usize;
            let [from, to] = spike.window_nm.map(place);
            let to = to.min(values.len() - 1);
            let is_apart = |line: &Followed| to <= line.from || line.to <= from;
            if self.lines.len() < MOST_LINES && from + 1 < to && self.lines.iter().all(is_apart) {
                self.lines.push(Followed {
                    at_nm: spike.spike.at_nm,
                    from,
                    to,
                });
            }
        }
    }

    /// Frames so far.
    pub fn len(&self) -> usize {
        self.blocks.len() * ROWS + self.open.len()
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Places of the lines that are followed, nm, in the order in which they were found.
    pub fn lines_nm(&self) -> Vec<f64> {
        self.lines.iter().map(|line| line.at_nm).collect()
    }

    /// Memory that the frames take.
    pub fn bytes(&self) -> usize {
        let block = size_of::<Block>() + 2 * ROWS * COLUMNS;
        self.blocks.len() * block + self.open.capacity() * size_of::<[f32; COLUMNS]>()
    }

    /// The time of a frame from 0, ms, where its block begins, and its row.
    fn row(&self, index: usize) -> Option<(f64, [f32; COLUMNS])> {
        match self.blocks.get(index / ROWS) {
            Some(block) => Some((block.begins_ms, block.row(index % ROWS))),
            None => {
                let open = index.checked_sub(self.blocks.len() * ROWS)?;
                Some((self.begins_ms, *self.open.get(open)?))
            }
        }
    }

    /// A quantity over time, ms, in at most `2 * spans` points a curve: of each span of time its
    /// least and its largest value, so that a flash is not lost. Curves of lines, in their order;
    /// else one.
    pub fn curves(&self, track: Track, spans: usize) -> Vec<Vec<[f64; 2]>> {
        let columns: Vec<usize> = match track {
            Track::Y => vec![Y],
            Track::Cct => vec![CCT],
            Track::Glow => vec![GLOW],
            Track::Lines => (LINES..LINES + self.lines.len()).collect(),
        };
        let each = self.len().div_ceil(spans.max(1)).max(1);
        let mut curves = vec![Vec::new(); columns.len()];
        let mut ends: Vec<Option<[[f64; 2]; 2]>> = vec![None; columns.len()];
        for index in 0..self.len() {
            let Some((begins_ms, row)) = self.row(index) else {
                break;
            };
            let time_ms = begins_ms + f64::from(row[0]);
            for (column, ends) in columns.iter().zip(&mut ends) {
                // The share of the glow takes a whole series: the first of each span.
                let value = match track {
                    Track::Glow if index % each > 0 => None,
                    Track::Glow => self.point(index).and_then(|point| point.glow()),
                    _ => Some(f64::from(row[*column])),
                };
                let value = value.filter(|value| value.is_finite());
                if let Some(at) = value.map(|value| [time_ms, value]) {
                    let [least, most] = ends.get_or_insert([at, at]);
                    if at[1] < least[1] {
                        *least = at;
                    }
                    if at[1] > most[1] {
                        *most = at;
                    }
                }
            }
            if (index + 1) % each == 0 || index + 1 == self.len() {
                for (curve, ends) in curves.iter_mut().zip(&mut ends) {
                    let Some([least, most]) = ends.take() else {
                        continue;
                    };
                    let (first, last) = match least[0] <= most[0] {
                        true => (least, most),
                        false => (most, least),
                    };
                    curve.push(first);
                    curve.extend((last != first).then_some(last));
                }
            }
        }
        curves
    }

    /// The frame of a place, from 0.
    pub fn point(&self, index: usize) -> Option<Point> {
        let (begins_ms, row) = self.row(index)?;
        Some(self.told(begins_ms, &row))
    }

    /// The means of frames that follow each other, in at most so many groups of one size, each at the
    /// time of its first; what was not followed in all of a group has no value in it.
    pub(super) fn means(&self, most: usize) -> Vec<Point> {
        let each = self.len().div_ceil(most.max(1)).max(1);
        let mean = |first: usize| {
            let (begins_ms, mut sum) = self.row(first)?;
            let time = sum[0];
            for index in first + 1..(first + each).min(self.len()) {
                let (_, row) = self.row(index)?;
                sum.iter_mut().zip(row).for_each(|(sum, v)| *sum += v);
            }
            let count = each.min(self.len() - first) as f32;
            sum.iter_mut().for_each(|sum| *sum /= count);
            sum[0] = time;
            Some(self.told(begins_ms, &sum))
        };
        (0..self.len()).step_by(each).filter_map(mean).collect()
    }

    fn told(&self, begins_ms: f64, row: &[f32; COLUMNS]) -> Point {
        let number = |cell: f32| Some(f64::from(cell)).filter(|number| number.is_finite());
        let weights: Vec<Option<f64>> = row[LINES..][..self.lines.len()]
            .iter()
            .map(|cell| number(*cell))
            .collect();
        let coefficients = row[GLOW..LINES].iter().map(|cell| f64::from(*cell));
        let smooth = Series::new(
            self.table.band(),
            self.table.basis(),
            coefficients.collect(),
        );
        let lines = self.lines.iter().zip(&weights);
        let lines = lines.filter_map(|(line, weight)| Some(Line::ideal(line.at_nm, (*weight)?)));
        Point {
            time_ms: begins_ms + f64::from(row[0]),
            y: f64::from(row[Y]),
            cct: number(row[CCT]),
            composite: Composite::of_lines_inside(smooth, lines.collect()),
            weights,
        }
    }

    /// All frames, the oldest first.
    pub fn points(&self) -> impl Iterator<Item = Point> {
        (0..self.len()).filter_map(|index| self.point(index))
    }

    /// The tracks as CSV, a line a frame; a cell is empty where there is no value.
    pub fn csv(&self) -> String {
        let mut out = "time_s,y,cct,glow".to_owned();
        for at_nm in self.lines_nm() {
            // Writing to a string cannot fail.
            let _ = write!(out, ",line_{at_nm:.1}_nm");
        }
        out.push('\n');
        for point in self.points() {
            let glow = point.glow();
            // The digits that a column of 16 bit holds.
            let cell = |value: Option<f64>| {
                let value = value.filter(|value| value.is_finite());
                value.map_or(String::new(), |value| format!("{}", value as f32))
            };
            let _ = write!(out, "{:.3},{}", 1e-3 * point.time_ms, cell(Some(point.y)));
            for value in [point.cct, glow].into_iter().chain(point.weights) {
                let _ = write!(out, ",{}", cell(value));
            }
            out.push('\n');
        }
        out
    }
}

impl Followed {
    /// Takes what stands above the chord of the line's window out of values: its weight, in the unit
    /// of the values x nm.
    fn taken_from(&self, values: &mut [f64]) -> f64 {
        let (first, last) = (values[self.from], values[self.to]);
        let length = (self.to - self.from) as f64;
        let mut weight = 0.0;
        for (i, value) in values.iter_mut().enumerate().take(self.to).skip(self.from) {
            let share = (i - self.from) as f64 / length;
            let chord = first * (1.0 - share) + last * share;
            weight += *value - chord;
            *value = chord;
        }
        weight
    }
}

impl Block {
    fn of(begins_ms: f64, rows: &[[f32; COLUMNS]]) -> Self {
        let (mut lowest, mut step) = ([0.0; COLUMNS], [0.0; COLUMNS]);
        for column in 0..COLUMNS {
            let cells = || rows.iter().map(|row| row[column]).filter(|v| v.is_finite());
            let low = cells().fold(f32::INFINITY, f32::min);
            let high = cells().fold(f32::NEG_INFINITY, f32::max);
            if low <= high {
                // Halves, since the whole may be more than a number holds.
                (lowest[column], step[column]) = (low, (0.5 * high - 0.5 * low) / (0.5 * HIGHEST));
            }
        }
        let code = |(column, cell): (usize, &f32)| match (cell.is_finite(), step[column]) {
            (false, _) => NONE,
            (true, 0.0) => 0,
            (true, step) => ((cell - lowest[column]) / step).round().clamp(0.0, HIGHEST) as u16,
        };
        let codes = rows.iter().flat_map(|row| row.iter().enumerate().map(code));
        Self {
            begins_ms,
            lowest,
            step,
            codes: codes.collect(),
        }
    }

    fn row(&self, index: usize) -> [f32; COLUMNS] {
        std::array::from_fn(|column| match self.codes[index * COLUMNS + column] {
            NONE => f32::NAN,
            code => self.lowest[column] + f32::from(code) * self.step[column],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A glow that tilts and mercury's green line that grows, on whole nm.
    fn lamp(share: f64, has_line: bool) -> Sampled {
        let value = |nm: f64| {
            let line = (-((nm - 546.1) / 1.5).powi(2)).exp();
            let line = if has_line { (1.0 + share) * line } else { 0.0 };
            0.3 + 0.2 * share * ((nm - 580.0) / 200.0) + line
        };
        let values = (380..=780).map(|nm| value(f64::from(nm))).collect();
        Sampled::even(380.0, 1.0, values).expect("finite")
    }

    #[test]
    fn an_hour_at_ten_frames_a_second_takes_less_than_three_megabytes_and_keeps_the_light() {
        let mut tracks = Tracks::default();
        let count = 36_000_u32;
        let share = |index: u32| f64::from(index) / f64::from(count);
        for index in 0..count {
            tracks.push(100.0 * f64::from(index), &lamp(share(index), true));
        }
        assert_eq!(tracks.len(), count as usize);
        assert!(tracks.bytes() < 3_000_000, "{}", tracks.bytes());
        // The line's area is 1.5 sqrt(pi) of its height, of which a chord at the foot of its window
        // leaves some out, always the same share.
        let area = 1.5 * std::f64::consts::PI.sqrt();
        let first = tracks.point(0).and_then(|point| point.weights[0]);
        let kept = first.expect("followed") / area;
        assert!((0.9..1.01).contains(&kept), "{kept}");
        for index in [0, 255, 256, 20_000, 35_999] {
            let point = tracks.point(index as usize).expect("a frame");
            assert!((point.time_ms - 100.0 * f64::from(index)).abs() < 1.0);
            let exact = kept * area * (1.0 + share(index));
            let weight = point.weights[0].expect("followed");
            // The digits of an f32 over a chord.
            assert!(
                (weight / exact - 1.0).abs() < 1e-5,
                "{index}: {weight} {exact}"
            );
            let exact = sums(&lamp(share(index), true)).y;
            // 16 bit of what a block spans, and the digits of an f32.
            assert!((point.y / exact - 1.0).abs() < 1e-6, "{} {exact}", point.y);
            assert!(point.cct.is_some());
            let of_composite = point.composite.xyz(Observer::CIE_1931).y;
            // What a composite is off by on a line of 2.5 nm, seen at its centre alone.
            assert!(
                (of_composite / exact - 1.0).abs() < 0.01,
                "{of_composite} {exact}"
            );
        }
    }

    #[test]
    fn a_line_that_appears_is_followed_from_then_on_and_the_dark_has_no_cct() {
        let mut tracks = Tracks::default();
        let dark = Sampled::even(380.0, 1.0, vec![0.0; 401]).expect("finite");
        tracks.push(0.0, &dark);
        tracks.push(1000.0, &lamp(0.0, false));
        tracks.push(2000.0, &lamp(0.0, true));
        let points: Vec<Point> = tracks.points().collect();
        assert_eq!((points[0].cct, points[0].glow()), (None, None));
        assert_eq!(points[1].glow(), Some(1.0));
        assert_eq!(points[1].weights, [None]);
        assert!((tracks.lines_nm()[0] - 546.1).abs() < 0.2);
        let glow = points[2].glow().expect("light");
        let line = 1.5 * std::f64::consts::PI.sqrt();
        let exact = 0.3 * 400.0 / (0.3 * 400.0 + line);
        // A tenth of the line at most stays in the glow.
        assert!((glow - exact).abs() < 0.1 * line / 120.0, "{glow} {exact}");
        let csv = tracks.csv();
        let rows: Vec<&str> = csv.lines().collect();
        assert_eq!(rows[0], "time_s,y,cct,glow,line_546.1_nm");
        assert_eq!(rows[1], "0.000,0,,,");
        assert!(rows[2].ends_with(",1,"), "{}", rows[2]);
        assert_eq!(rows.len(), 4);
    }
}
