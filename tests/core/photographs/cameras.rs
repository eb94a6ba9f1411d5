//! Gratings and cameras as they are drawn: which wavelength falls where, and what is made of it.

use super::{dice::Dice, lights::GRID};

/// A grating before a lens: wavelengths against columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grating {
    /// The wavelength of the middle.
    pub centre_nm: f64,
    /// Distance of its lines, nm.
    pitch_nm: f64,
    /// Sine of the angle of the middle.
    sine: f64,
    /// Focal length in columns, negative where wavelengths fall.
    focal: f64,
    /// The lens's distortion at `half` columns, and the column of its middle.
    bend: f64,
    lens: f64,
    half: f64,
}

impl Grating {
    /// One whose middle has so many nm a column, over so many columns.
    pub(crate) fn of(columns: f64, nm_a_column: f64, dice: &mut Dice) -> Self {
        let pitch_nm = 1e6 / dice.between(300.0, 1350.0);
        let sine = dice.between(-33.0, 33.0_f64).to_radians().sin();
        let cosine = (1.0 - sine * sine).sqrt();
        Self {
            centre_nm: dice.between(490.0, 580.0),
            pitch_nm,
            sine,
            focal: pitch_nm * cosine / nm_a_column,
            bend: 0.045 * dice.normal(),
            lens: 0.12 * columns * dice.normal(),
            half: 0.5 * columns,
        }
    }

    /// The wavelength so many columns to the right of the middle.
    pub(crate) fn nm(&self, u: f64) -> f64 {
        let bent = |u: f64| u * (1.0 + self.bend * (u / self.half).powi(2));
        let seen = bent(u - self.lens) - bent(-self.lens);
        let angle = self.sine.asin() + (seen / self.focal).atan();
        self.centre_nm + self.pitch_nm * (angle.sin() - self.sine)
    }
}

/// Sensitivities of red, green and blue, and the colour matrix behind them.
#[derive(Clone, Debug)]
pub(crate) struct Camera {
    curves: [Vec<f64>; 3],
    /// Share of the other channels that is taken off each.
    matrix: [[f64; 3]; 3],
    is_grey: bool,
}

impl Camera {
    pub(crate) fn of(dice: &mut Dice, is_grey: bool) -> Self {
        let (first, step, count) = GRID;
        let mut humps: Vec<Vec<[f64; 3]>> = [(602.0, 36.0), (536.0, 38.0), (458.0, 33.0)]
            .map(|(nm, wide)| {
                let nm = nm + dice.between(-9.0, 9.0);
                vec![[nm, dice.between(0.6, 1.0), wide * dice.factor(0.08)]]
            })
            .to_vec();
        // Dyes leak: red a little in the violet, all into each other.
        humps[0].push([432.0, dice.between(0.0, 0.08), 22.0]);
        humps[0].push([535.0, dice.between(0.02, 0.2), 40.0]);
        humps[1].push([615.0, dice.between(0.02, 0.15), 35.0]);
        humps[1].push([460.0, dice.between(0.02, 0.2), 30.0]);
        humps[2].push([535.0, dice.between(0.02, 0.15), 32.0]);
        let (uv, ir) = (dice.between(398.0, 412.0), dice.between(660.0, 710.0));
        let curve = |of: &Vec<[f64; 3]>| -> Vec<f64> {
            (0..count)
                .map(|i| first + step * i as f64)
                .map(|nm| {
                    let hump = |[at, height, wide]: &[f64; 3]| {
                        height * (-0.5 * ((nm - at) / wide).powi(2)).exp()
                    };
                    let edges = (1.0 + ((uv - nm) / 5.0).exp()) * (1.0 + ((nm - ir) / 7.0).exp());
                    of.iter().map(hump).sum::<f64>() / edges
                })
                .collect()
        };
        let curves = [curve(&humps[0]), curve(&humps[1]), curve(&humps[2])];
        let strength = dice.between(0.0, 1.0);
        let mut matrix = [[0.0; 3]; 3];
        for (i, row) in matrix.iter_mut().enumerate() {
            let off = [0, 1, 2].map(|j| {
                let most = if i.abs_diff(j) == 1 { 0.55 } else { 0.12 };
                if i == j {
                    0.0
                } else {
                    strength * dice.between(0.2, most)
                }
            });
            *row = off.map(|o| -o);
            row[i] = 1.0 + off.iter().sum::<f64>();
        }
        Self {
            curves,
            matrix,
            is_grey,
        }
    }

    /// Red, green and blue of light on the grid, seen at one wavelength, and of white.
    pub(crate) fn sees(&self, power: &[f64]) -> [Vec<f64>; 3] {
        if self.is_grey {
            let all = |i: usize| power[i] * self.curves.iter().map(|c| c[i]).sum::<f64>() / 3.0;
            let all: Vec<f64> = (0..power.len()).map(all).collect();
            return [all.clone(), all.clone(), all];
        }
        let raw = |k: usize, i: usize| power[i] * self.curves[k][i];
        self.matrix.map(|row| {
            let mixed = |i: usize| (0..3).map(|k| row[k] * raw(k, i)).sum::<f64>();
            (0..power.len()).map(mixed).map(|v| v.max(0.0)).collect()
        })
    }
}

/// A list on the grid at a wavelength; none beside it.
pub(crate) fn at(list: &[f64], nm: f64) -> f64 {
    let (first, step, count) = GRID;
    let place = (nm - first) / step;
    if place < 0.0 || place >= (count - 1) as f64 {
        return 0.0;
    }
    let left = place as usize;
    let part = place - left as f64;
    list[left] + (list[left + 1] - list[left]) * part
}

/// Running sums of a list on the grid, by which its mean between two wavelengths is found.
pub(crate) struct Sums(Vec<f64>);

impl Sums {
    pub(crate) fn of(list: &[f64]) -> Self {
        let mut sums = vec![0.0];
        let mut sum = 0.0;
        for two in list.windows(2) {
            sum += 0.5 * (two[0] + two[1]) * GRID.1;
            sums.push(sum);
        }
        Self(sums)
    }

    /// The mean from one wavelength to another.
    pub(crate) fn mean(&self, from: f64, to: f64) -> f64 {
        let last = GRID.0 + GRID.1 * (GRID.2 - 1) as f64;
        let up_to = |nm: f64| {
            if nm >= last {
                self.0[GRID.2 - 1]
            } else {
                at(&self.0, nm)
            }
        };
        let (low, high) = (from.min(to), from.max(to));
        (up_to(high) - up_to(low)) / (high - low).max(1e-9)
    }
}
