//! The strip of sky with both rainbows in it, in true colours.
//!
//! Rays fall evenly over a drop, so evenly in b^2. What two neighbours enclose goes to the angles
//! between theirs, spread over cells of the sky with exact overlap, and over each cell's solid
//! angle. Then the sun's disc blurs it. A spike gives a bow of its own.

use std::f64::consts::{PI, TAU};

use super::{
    fresnel::reflectances,
    index::Material,
    light::{Light, SEEN_NM},
    rainbow::bow,
};
use crate::{
    color::{Observer, Xyz},
    spectrum::Line,
};

/// Apparent diameter of the sun, degrees.
pub(crate) const SUN_DEG: f64 = 0.533;

/// The strip that is shown, degrees from the antisolar point.
pub(crate) const SKY_DEG: [f64; 2] = [35.0, 60.0];

/// Most columns of the strip.
const MOST_COLUMNS: usize = 8192;

/// Bundles of rays over a drop's radius squared.
const BUNDLES: usize = 1024;

/// Wavelengths of the smooth part, whole nm.
const WAVELENGTHS: usize = (SEEN_NM[1] - SEEN_NM[0]) as usize + 1;

/// Light that a drop of a material sends to each column of the sky, at every whole nm: computed
/// once, after which every light is a sum.
#[derive(Clone, Debug)]
pub struct Sky {
    material: Material,
    columns: usize,
    /// Columns beside the strip on each side, so that the blur has something to blur in.
    margin: usize,
    /// Angles of incidence of the rays, radians, shared by all wavelengths.
    incidences: Vec<[f64; 3]>,
    /// Wavelength after wavelength, a value a column, margins included.
    response: Vec<f32>,
    /// The sun's disc over neighbouring columns.
    disc: Vec<f64>,
}

/// The strip for a light.
#[derive(Clone, Debug, PartialEq)]
pub struct SkyStrip {
    /// Ends of the strip, degrees from the antisolar point.
    pub ends_deg: [f64; 2],
    /// X, Y, Z of the radiance of each column, for light of radiance x solid angle 1; value x nm /
    /// sr.
    pub xyz: Vec<Xyz>,
    /// The same of the spikes alone.
    pub lines: Vec<Xyz>,
}

impl Sky {
    /// Traces a drop of a material at every whole nm of 380-780. What has no index is dark.
    pub fn new(material: Material, columns: usize) -> Self {
        let columns = columns.clamp(1, MOST_COLUMNS);
        let cell = (SKY_DEG[1] - SKY_DEG[0]) / columns as f64;
        let disc = disc(cell);
        let margin = disc.len() / 2;
        let ray = |i: usize| {
            let squared = i as f64 / BUNDLES as f64;
            let b = squared.sqrt();
            let cos = (1.0 - squared).max(0.0).sqrt();
            [b, cos, b.atan2(cos)]
        };
        let mut sky = Self {
            material,
            columns,
            margin,
            incidences: (0..=BUNDLES).map(ray).collect(),
            response: Vec::new(),
            disc,
        };
        let width = columns + 2 * margin;
        let mut response = Vec::with_capacity(WAVELENGTHS * width);
        let mut cells = vec![0.0; width];
        for step in 0..WAVELENGTHS {
            cells.fill(0.0);
            sky.trace(SEEN_NM[0] + step as f64, &mut cells);
            response.extend(cells.iter().map(|v| *v as f32));
        }
        sky.response = response;
        sky
    }

    /// The material of the drops.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// Adds what a drop sends to each column at a wavelength, per sr.
    fn trace(&self, at_nm: f64, cells: &mut [f64]) {
        let Ok(n) = self.material.index(at_nm) else {
            return;
        };
        let cell = (SKY_DEG[1] - SKY_DEG[0]).to_radians() / self.columns as f64;
        let first = SKY_DEG[0].to_radians() - self.margin as f64 * cell;
        let end = first + cells.len() as f64 * cell;
        let mut before: Option<[f64; 4]> = None;
        // Up to the primary bow's ray the one angle rises and the other falls: the first rays miss
        // the strip by both, and are passed over.
        let to_bow = bow(n, 1).map_or(0.0, |bow| bow.ray.impact);
        let misses = |[b, _, i]: &[f64; 3]| {
            let r = (b / n).asin();
            *b < to_bow && 4.0 * r - 2.0 * i < first && PI + 2.0 * i - 6.0 * r > end
        };
        let start = self.incidences.partition_point(misses).saturating_sub(1);
        for [b, cos_i, i] in &self.incidences[start..] {
            let sin_r = b / n;
            let cos_r = (1.0 - sin_r * sin_r).sqrt();
            let r = sin_r.atan2(cos_r);
            let shares = reflectances(1.0, *cos_i, n, cos_r);
            let after = |k: i32| {
                let of = |r: f64| (1.0 - r) * (1.0 - r) * r.powi(k);
                0.5 * (of(shares[0]) + of(shares[1]))
            };
            // Angles from the antisolar point of what was reflected once and twice inside.
            let now = [
                4.0 * r - 2.0 * i,
                PI + 2.0 * i - 6.0 * r,
                after(1),
                after(2),
            ];
            if let Some(last) = before {
                for k in 0..2 {
                    let ends = [last[k].min(now[k]), last[k].max(now[k])];
                    if ends[1] > first && ends[0] < end {
                        let energy = 0.5 * (last[2 + k] + now[2 + k]) / BUNDLES as f64;
                        overlap(ends.map(|x| (x - first) / cell), energy, cells);
                    }
                }
            }
            before = Some(now);
        }
        let mut near = first.cos();
        for (index, value) in cells.iter_mut().enumerate() {
            let far = (first + (index + 1) as f64 * cell).cos();
            *value /= TAU * (near - far);
            near = far;
        }
    }

    /// The strip under a light, blurred by the sun's disc or for a point of a sun.
    pub fn strip(&self, light: &Light, observer: Observer, sun: bool) -> SkyStrip {
        let light = &*light.in_reach();
        let width = self.columns + 2 * self.margin;
        let table = observer.table();
        // X, Y and Z apart, so that each is a plain sum of rows.
        let mut smooth = [0; 3].map(|_| vec![0.0_f32; width]);
        for (step, row) in self.response.chunks_exact(width).enumerate() {
            let at_nm = SEEN_NM[0] + step as f64;
            let half = step == 0 || step == WAVELENGTHS - 1;
            let value = light.smooth_at(at_nm) * if half { 0.5 } else { 1.0 };
            let weights = table.at(at_nm).map(|v| (v * value) as f32);
            if value != 0.0 {
                for (sums, weight) in smooth.iter_mut().zip(weights) {
                    for (sum, response) in sums.iter_mut().zip(row) {
                        *sum += weight * response;
                    }
                }
            }
        }
        let mut lines = vec![[0.0_f64; 3]; width];
        let mut cells = vec![0.0; width];
        for Line { at_nm, weight, .. } in light.seen_spikes() {
            cells.fill(0.0);
            self.trace(at_nm, &mut cells);
            let weights = table.at(at_nm).map(|v| v * weight);
            for (sum, response) in lines.iter_mut().zip(&cells) {
                for (sum, weight) in sum.iter_mut().zip(weights) {
                    *sum += weight * response;
                }
            }
        }
        let both = |(i, line): (usize, &[f64; 3])| -> [f64; 3] {
            std::array::from_fn(|k| f64::from(smooth[k][i]) + line[k])
        };
        let all: Vec<[f64; 3]> = lines.iter().enumerate().map(both).collect();
        SkyStrip {
            ends_deg: SKY_DEG,
            xyz: self.blurred(&all, sun),
            lines: self.blurred(&lines, sun),
        }
    }

    fn blurred(&self, cells: &[[f64; 3]], sun: bool) -> Vec<Xyz> {
        let column = |index: usize| {
            if !sun {
                return Xyz::from_array(cells[index + self.margin]);
            }
            let around = &cells[index..][..self.disc.len()];
            let mut sum = [0.0; 3];
            for (weight, cell) in self.disc.iter().zip(around) {
                for (sum, value) in sum.iter_mut().zip(cell) {
                    *sum += weight * value;
                }
            }
            Xyz::from_array(sum)
        };
        (0..self.columns).map(column).collect()
    }
}

/// The share of the sun's disc over each of the columns about its middle; an odd number of them.
fn disc(cell_deg: f64) -> Vec<f64> {
    let radius = 0.5 * SUN_DEG / cell_deg;
    let reach = (radius + 0.5).ceil() as i32;
    // Area of a disc of radius 1 to the left of a chord, over pi.
    let left = |x: f64| {
        let u = (x / radius).clamp(-1.0, 1.0);
        0.5 + (u * (1.0 - u * u).sqrt() + u.asin()) / PI
    };
    (-reach..=reach)
        .map(|i| left(f64::from(i) + 0.5) - left(f64::from(i) - 0.5))
        .collect()
}

/// Spreads an energy evenly between two places, in cells.
fn overlap([from, to]: [f64; 2], energy: f64, cells: &mut [f64]) {
    let count = cells.len();
    let first = from.max(0.0) as usize;
    let last = (to.max(0.0) as usize).min(count.saturating_sub(1));
    if first >= count {
        return;
    }
    if to - from < 1e-12 {
        if from >= 0.0 {
            cells[first] += energy;
        }
        return;
    }
    let density = energy / (to - from);
    for (index, value) in cells.iter_mut().enumerate().take(last + 1).skip(first) {
        let (left, right) = (index as f64, (index + 1) as f64);
        *value += density * (to.min(right) - from.max(left)).max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sun_takes_no_energy() {
        let weights = disc(0.025);
        // A sum of 23 parts of 1.
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-13);
        assert_eq!(weights.len() % 2, 1);
    }
}
