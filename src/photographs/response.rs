//! Instrument response, one for each channel: learnt from a picture of a known light, and used to
//! read other pictures.

use nalgebra::{DMatrix, DVector};

use super::{axis::Curve, profile::Profile, smooth::median};

/// Steps of the grid.
pub const STEP_NM: f64 = 2.0;

/// Response of red, green and blue on a grid of [`STEP_NM`].
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// The first wavelength.
    pub first_nm: f64,
    /// Red, green and blue; none of them below 0.
    pub channels: [Vec<f64>; 3],
    /// Disagreement between the channels about their own light: 0 where they agree.
    pub disagreement: f64,
}

/// A spectrum that was read through a response.
#[derive(Clone, Debug, PartialEq)]
pub struct Corrected {
    /// Wavelengths, on the response's grid.
    pub nm: Vec<f64>,
    /// Light; where it is not defined, none.
    pub value: Vec<Option<f64>>,
    /// Its doubt, one standard deviation.
    pub sigma: Vec<Option<f64>>,
    /// Disagreement between the channels about this light.
    pub disagreement: f64,
}

/// Penalty on the second difference of a response.
const PENALTY: f64 = 0.1;
/// A channel counts above this share of its own largest response,
const CHANNEL: f64 = 0.05;
/// and a wavelength where the best channel is above this share of the best of all.
const DEFINED: f64 = 0.04;
/// Uncertainties of the channels: black level, response, place in nm.
const DOUBTS: (f64, f64, f64) = (0.004, 0.03, 0.5);
/// Channels are compared above these shares of their response and of their light.
const COMPARED: (f64, f64) = (0.12, 0.03);

/// A profile on a grid of whole steps: light for 1 nm and its noise; none of clipped columns.
struct Grid {
    first_nm: f64,
    channels: [Vec<Option<f64>>; 3],
    sigma: [Vec<f64>; 3],
}

fn grid(profile: &Profile, curve: &Curve, (from, to): (f64, f64)) -> Grid {
    let first_nm = (from / STEP_NM).ceil() * STEP_NM;
    let count = (((to - first_nm) / STEP_NM).floor().max(-1.0) + 1.0) as usize;
    let last = profile.columns() as f64 - 1.0;
    let mut grid = Grid {
        first_nm,
        channels: [(); 3].map(|()| vec![None; count]),
        sigma: [(); 3].map(|()| vec![0.0; count]),
    };
    for i in 0..count {
        let nm = first_nm + STEP_NM * i as f64;
        let ends = [-0.5, 0.5].map(|half| curve.px(nm + half * STEP_NM, 0.0, last));
        let [Some(a), Some(b)] = ends else { continue };
        let (a, b) = (a.min(b), a.max(b));
        let columns =
            (a + 0.5).floor() as usize..=((b + 0.5).floor() as usize).min(profile.columns() - 1);
        if columns.clone().any(|c| profile.clipped[c]) {
            continue;
        }
        for k in 0..3 {
            let (mut sum, mut variance) = (0.0, 0.0);
            for column in columns.clone() {
                let middle = column as f64;
                let share = ((middle + 0.5).min(b) - (middle - 0.5).max(a)).max(0.0);
                sum += share * profile.channels[k][column];
                variance += (share * profile.sigma[k]).powi(2);
            }
            grid.channels[k][i] = Some(sum / STEP_NM);
            grid.sigma[k][i] = variance.sqrt() / STEP_NM;
        }
    }
    grid
}

/// A list that follows weighted values with little bend.
fn smoothed(values: &[Option<f64>], weights: &[f64]) -> Vec<f64> {
    let count = values.len();
    let mean = weights.iter().sum::<f64>() / count.max(1) as f64;
    if count < 4 || mean <= 0.0 {
        return vec![0.0; count];
    }
    let mut normal = DMatrix::<f64>::zeros(count, count);
    let mut right = DVector::<f64>::zeros(count);
    for (i, (value, weight)) in values.iter().zip(weights).enumerate() {
        if let Some(value) = value {
            normal[(i, i)] += weight / mean;
            right[i] += weight / mean * value;
        }
        normal[(i, i)] += 1e-9;
    }
    for i in 0..count - 2 {
        let bend = [1.0, -2.0, 1.0];
        for (j, p) in bend.iter().enumerate() {
            for (k, q) in bend.iter().enumerate() {
                normal[(i + j, i + k)] += PENALTY * p * q;
            }
        }
    }
    match normal.cholesky() {
        Some(solved) => solved.solve(&right).iter().map(|v| v.max(0.0)).collect(),
        None => vec![0.0; count],
    }
}

impl Response {
    /// Disagreement of the channels about a picture that is read through it.
    pub fn disagreement_of(&self, profile: &Profile, curve: &Curve) -> f64 {
        self.disagreement(&grid(profile, curve, (self.first_nm, self.last_nm())))
    }

    /// Learns the response from a picture of a known light; `None` where they have too few nm in
    /// common.
    pub fn learn(
        profile: &Profile,
        curve: &Curve,
        range_nm: (f64, f64),
        known: impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let grid = grid(profile, curve, range_nm);
        let count = grid.channels[0].len();
        let light: Vec<f64> = (0..count)
            .map(|i| known(grid.first_nm + STEP_NM * i as f64))
            .collect();
        if light.iter().filter(|l| **l > 0.0).count() < 20 {
            return None;
        }
        let top = light.iter().copied().fold(0.0, f64::max);
        let channels = [0, 1, 2].map(|k| {
            let ratio = |i: usize| {
                grid.channels[k][i]
                    .filter(|_| light[i] > 0.0)
                    .map(|y| y * top / light[i])
            };
            let ratios: Vec<Option<f64>> = (0..count).map(ratio).collect();
            let weight = |i: usize| {
                let sigma = grid.sigma[k][i].max(1e-9) * top / light[i].max(1e-9);
                if ratios[i].is_some() {
                    sigma.powi(-2)
                } else {
                    0.0
                }
            };
            smoothed(&ratios, &(0..count).map(weight).collect::<Vec<f64>>())
        });
        let mut response = Self {
            first_nm: grid.first_nm,
            channels,
            disagreement: 0.0,
        };
        response.disagreement = response.disagreement(&grid);
        response.peak().gt(&0.0).then_some(response)
    }

    fn peak(&self) -> f64 {
        self.channels.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// The last wavelength.
    pub fn last_nm(&self) -> f64 {
        self.first_nm + STEP_NM * (self.channels[0].len() as f64 - 1.0)
    }

    /// Median over the grid of how far apart the channels' own estimates are.
    fn disagreement(&self, grid: &Grid) -> f64 {
        let peaks = self
            .channels
            .each_ref()
            .map(|c| c.iter().copied().fold(0.0, f64::max));
        let offset = ((grid.first_nm - self.first_nm) / STEP_NM).round() as isize;
        let top = |k: usize| {
            grid.channels[k]
                .iter()
                .flatten()
                .copied()
                .fold(0.0, f64::max)
        };
        let tops = [0, 1, 2].map(top);
        let mut apart = Vec::new();
        for i in 0..grid.channels[0].len() {
            let place = usize::try_from(i as isize + offset).ok();
            let Some(place) = place.filter(|p| *p < self.channels[0].len()) else {
                continue;
            };
            let estimates: Vec<f64> = (0..3)
                .filter_map(|k| {
                    let (r, y) = (self.channels[k][place], grid.channels[k][i]?);
                    let counts = r > COMPARED.0 * peaks[k] && y > COMPARED.1 * tops[k];
                    counts.then(|| y / r)
                })
                .collect();
            if estimates.len() > 1 {
                let low = estimates.iter().copied().fold(f64::MAX, f64::min);
                let high = estimates.iter().copied().fold(f64::MIN, f64::max);
                apart.push((high - low) / (estimates.iter().sum::<f64>() / estimates.len() as f64));
            }
        }
        median(&apart)
    }

    /// A picture of the same instrument read through the response.
    pub fn apply(&self, profile: &Profile, curve: &Curve) -> Corrected {
        let grid = grid(profile, curve, (self.first_nm, self.last_nm()));
        let peaks = self
            .channels
            .each_ref()
            .map(|c| c.iter().copied().fold(0.0, f64::max));
        let brightest = [0, 1, 2].map(|k| {
            grid.channels[k]
                .iter()
                .flatten()
                .copied()
                .fold(0.0, f64::max)
        });
        let best = self.peak();
        let count = grid.channels[0].len();
        let mut corrected = Corrected {
            nm: (0..count)
                .map(|i| grid.first_nm + STEP_NM * i as f64)
                .collect(),
            value: vec![None; count],
            sigma: vec![None; count],
            disagreement: self.disagreement(&grid),
        };
        for i in 0..count {
            let (mut weights, mut sum, mut parts) = (0.0, 0.0, Vec::new());
            let largest = self.channels.iter().map(|c| c[i]).fold(0.0, f64::max);
            if largest < DEFINED * best {
                continue;
            }
            for k in 0..3 {
                let (r, y) = (self.channels[k][i], grid.channels[k][i]);
                let Some(y) = y.filter(|_| r > CHANNEL * peaks[k]) else {
                    continue;
                };
                let near = |at: usize| self.channels[k][at.min(count - 1)];
                let slope = (near(i + 1) - near(i.saturating_sub(1))) / (2.0 * STEP_NM);
                let noise = grid.sigma[k][i].hypot(DOUBTS.0 * brightest[k]) / r;
                let of_response = y / r * DOUBTS.1.hypot(DOUBTS.2 * slope / r);
                let weight = 1.0 / (noise.powi(2) + of_response.powi(2)).max(1e-30);
                weights += weight;
                sum += weight * y / r;
                parts.push((y / r, weight));
            }
            if weights > 0.0 {
                let value = sum / weights;
                let chi2: f64 = parts.iter().map(|(v, w)| w * (v - value).powi(2)).sum();
                let scatter = (chi2 / (parts.len() as f64 - 1.0).max(1.0)).max(1.0);
                corrected.value[i] = Some(value);
                corrected.sigma[i] = Some((scatter / weights).sqrt());
            }
        }
        corrected
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: [(f64, f64); 3] = [(600.0, 40.0), (540.0, 40.0), (460.0, 35.0)];

    fn camera(light: impl Fn(f64) -> f64) -> (Profile, Curve) {
        let curve = Curve::new(600, [550.0, 400.0, 20.0, 0.0]);
        let channel = |(centre, width): (f64, f64)| -> Vec<f64> {
            (0..600)
                .map(|i| (curve.nm(f64::from(i)), curve.slope(f64::from(i))))
                .map(|(nm, step)| step * light(nm) * (-0.5 * ((nm - centre) / width).powi(2)).exp())
                .collect()
        };
        let profile = Profile {
            channels: CAMERA.map(channel),
            sigma: [1e-4; 3],
            clipped: vec![false; 600],
            is_grey: false,
            black_seen: true,
            rows: 40,
        };
        (profile, curve)
    }

    #[test]
    fn another_light_has_its_own_shape_behind_the_response_of_a_bulb() {
        let bulb = |nm: f64| (nm / 600.0).powi(4);
        let (profile, curve) = camera(bulb);
        let response = Response::learn(&profile, &curve, (400.0, 700.0), bulb).expect("a response");
        assert!(response.disagreement < 0.01, "{}", response.disagreement);
        let sky = |nm: f64| 1.5 - nm / 700.0 + 0.2 * (nm / 17.0).sin();
        let (profile, curve) = camera(sky);
        let corrected = response.apply(&profile, &curve);
        let defined: Vec<(f64, f64)> = (corrected.nm.iter().zip(&corrected.value))
            .filter_map(|(nm, v)| Some((*nm, (*v)?)))
            .filter(|(nm, _)| (420.0..660.0).contains(nm))
            .collect();
        assert!(defined.len() > 110);
        let scale = defined.iter().map(|d| d.1).sum::<f64>()
            / defined.iter().map(|d| sky(d.0)).sum::<f64>();
        for (nm, value) in defined {
            assert!(
                (value / scale / sky(nm) - 1.0).abs() < 0.03,
                "{nm}: {value}"
            );
        }
        assert!(corrected.disagreement < 0.02);
    }

    #[test]
    fn a_camera_that_bends_its_tones_disagrees_with_itself() {
        let bulb = |nm: f64| (nm / 600.0).powi(4);
        let (profile, curve) = camera(bulb);
        let response = Response::learn(&profile, &curve, (400.0, 700.0), bulb).expect("a response");
        let (mut bent, curve) = camera(|_| 0.5);
        for channel in &mut bent.channels {
            channel.iter_mut().for_each(|v| *v = *v * *v / (0.05 + *v));
        }
        assert!(response.apply(&bent, &curve).disagreement > 0.05);
    }

    #[test]
    fn lights_without_a_wavelength_in_common_teach_nothing() {
        let (profile, curve) = camera(|_| 1.0);
        assert_eq!(
            Response::learn(&profile, &curve, (400.0, 700.0), |_| 0.0),
            None
        );
        assert_eq!(
            Response::learn(&profile, &curve, (900.0, 950.0), |_| 1.0),
            None
        );
    }
}
