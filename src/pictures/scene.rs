//! The made scene: a wall of paints, formed on demand, so that everything about spectral pictures
//! can be seen and measured without a picture of one's own.
//!
//! 16 x 16 tiles, each a slow mixture of two of 214 measured paints, under a shade that runs across
//! the wall, half of the tiles with a gloss in their middle, seen by a camera with noise. Every
//! number follows from the pixel's place by an integer hash, so the scene is the same everywhere.

use std::f64::consts::PI;

use crate::preset;
use crate::spectrum::{Kind, Outside, Sampled};

use super::pixels::Pixels;
use super::{Bands, Illuminant, PictureError};

/// The groups whose reflectances are the paints, in this order.
const PAINTS: [&str; 2] = ["colorchecker_ohta", "aces_training_190"];

/// Tiles across and down.
const TILES: f64 = 16.0;

/// Offset of the camera noise in the hash.
const NOISE_START: u32 = 0x9E37_79B9;

/// Columns and rows of the wall that everybody has at hand.
const AT_HAND: [usize; 2] = [256, 192];

/// A 32-bit hash of an integer: every bit of the answer depends on every bit of the question.
pub(crate) fn hash(seed: u32) -> u32 {
    let mut i = seed;
    i ^= i >> 16;
    i = i.wrapping_mul(0x7feb_352d);
    i ^= i >> 15;
    i = i.wrapping_mul(0x846c_a68b);
    i ^ (i >> 16)
}

fn uniform(seed: u32) -> f64 {
    f64::from(hash(seed)) / 4_294_967_296.0
}

/// The wall, of any size, on any bands, under any light.
#[derive(Clone, Debug)]
pub struct Scene {
    width: usize,
    height: usize,
    bands: Bands,
    paints: Vec<Vec<f64>>,
    lights: Vec<Vec<f64>>,
    has_noise: bool,
    name: String,
}

impl Scene {
    /// The wall that everybody has at hand: 256 x 192 pixels of 81 bands, as reflectances or as a
    /// light shows it.
    ///
    /// # Errors
    /// As [`Scene::lit`].
    pub(crate) fn at_hand(light: Option<&Illuminant>) -> Result<Self, PictureError> {
        let nm = (0..81).map(|i| 380.0 + 5.0 * f64::from(i)).collect();
        let [width, height] = AT_HAND;
        match light {
            Some(light) => Self::lit(width, height, nm, std::slice::from_ref(light)),
            None => Self::reflectance(width, height, nm),
        }
    }

    /// The wall's own reflectances, seen in even light.
    ///
    /// # Errors
    /// [`PictureError`] when there is no pixel, or the wavelengths (nm) are no bands.
    pub fn reflectance(width: usize, height: usize, nm: Vec<f64>) -> Result<Self, PictureError> {
        let bands = Bands::new(nm, Kind::Reflectance)?;
        Self::new(width, height, bands, Vec::new(), said!("a wall of paints"))
    }

    /// The wall under one light, or under two that share it out across the wall.
    ///
    /// # Errors
    /// As [`Scene::reflectance`], and where a light does not fall on the bands.
    pub fn lit(
        width: usize,
        height: usize,
        nm: Vec<f64>,
        lights: &[Illuminant],
    ) -> Result<Self, PictureError> {
        let bands = Bands::new(nm, Kind::Light)?;
        let lights = lights.iter().take(2);
        let names: Vec<&str> = lights.clone().map(Illuminant::name).collect();
        let name = tr!(
            "a wall of paints under {lights}",
            lights = names.join(said!(" and "))
        );
        let on_bands: Result<Vec<_>, _> = lights.map(|light| light.on_bands(&bands)).collect();
        Self::new(width, height, bands, on_bands?, &name)
    }

    fn new(
        width: usize,
        height: usize,
        bands: Bands,
        lights: Vec<Vec<f64>>,
        name: &str,
    ) -> Result<Self, PictureError> {
        if width == 0 || height == 0 {
            return Err(PictureError::NothingMeasured);
        }
        let groups = PAINTS.into_iter().filter_map(preset::group);
        let tables: Vec<Sampled> = groups
            .flat_map(|group| &group.items)
            .filter_map(|item| Some(item.spectrum()?.samples.clone()))
            .collect();
        // Read off, as the scene is defined: the paints are smooth, in steps of 5 nm.
        let on_bands = |table: &Sampled| {
            let nm = bands.nm().iter();
            nm.map(|nm| table.at(*nm, Outside::Hold)).collect()
        };
        Ok(Self {
            width,
            height,
            paints: tables.iter().map(on_bands).collect(),
            bands,
            lights,
            has_noise: true,
            name: name.to_owned(),
        })
    }

    /// The same wall without the camera's noise.
    #[cfg(test)]
    pub(crate) fn without_noise(mut self) -> Self {
        self.has_noise = false;
        self
    }

    /// Name in lists.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Number of paints.
    #[cfg(test)]
    pub(crate) fn paints(&self) -> usize {
        self.paints.len()
    }

    /// One pixel, a value a band.
    pub fn pixel(&self, x: usize, y: usize) -> Vec<f64> {
        let mut out = vec![0.0; self.bands.len()];
        self.pixel_into(x, y, &mut out);
        out
    }

    fn pixel_into(&self, x: usize, y: usize, out: &mut [f64]) {
        let (u, v) = (x as f64 / self.width as f64, y as f64 / self.height as f64);
        let (tx, ty) = ((TILES * u).floor(), (TILES * v).floor());
        let (fx, fy) = (TILES * u - tx, TILES * v - ty);
        let tile = (TILES * ty + tx) as u32;
        let paint = |seed: u32| &self.paints[hash(seed) as usize % self.paints.len()];
        let (a, b) = (paint(tile), paint(tile + 1000));
        let mix = 0.5 + 0.4 * (2.0 * PI * (3.0 * fx + 2.0 * fy)).sin();
        let place = (y * self.width + x) as u32;
        let shade = (0.12 + 0.88 * (0.5 + 0.5 * (2.0 * PI * (1.5 * u + v)).cos()))
            * (1.0 + 0.08 * (2.0 * uniform(place) - 1.0));
        let far = (fx - 0.5).powi(2) + (fy - 0.5).powi(2);
        let has_gloss = tile.is_multiple_of(2);
        let gloss = if has_gloss {
            0.15 * (-far / 0.01).exp()
        } else {
            0.0
        };
        let share = 0.5 + 0.5 * (2.0 * PI * (u + 0.7 * v)).sin();
        for (j, value) in out.iter_mut().enumerate() {
            let factor = shade * ((1.0 - mix) * a[j] + mix * b[j]) + gloss;
            let light = match &self.lights[..] {
                [] => 1.0,
                [one] => one[j],
                [one, two, ..] => share * one[j] + (1.0 - share) * two[j],
            };
            let exact = factor * light;
            let noise = if self.has_noise {
                let bands = self.bands.len() as u32;
                let n = place
                    .wrapping_mul(bands)
                    .wrapping_add(j as u32)
                    .wrapping_mul(4)
                    .wrapping_add(NOISE_START);
                let sum: f64 = (0..4).map(|k| uniform(n.wrapping_add(k))).sum();
                (0.0005 + 0.004 * exact.max(0.0).sqrt()) * 3_f64.sqrt() * (sum - 2.0)
            } else {
                0.0
            };
            *value = exact + noise;
        }
    }
}

impl Pixels for Scene {
    fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    fn bands(&self) -> &Bands {
        &self.bands
    }

    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError> {
        let pixels = count * self.width;
        let mut pixel = vec![0.0; self.bands.len()];
        for i in 0..pixels {
            self.pixel_into(i % self.width, first + i / self.width, &mut pixel);
            for (j, value) in pixel.iter().enumerate() {
                into[j * pixels + i] = *value as f32;
            }
        }
        Ok(())
    }
}
