//! The weights of an image's bands for X, Y and Z: a pixel's colour as a sum of its numbers.
//!
//! A spectrum between two bands is a straight line, as everywhere in this program, and its XYZ
//! are sums over whole nm of 360-830. All of that is linear in the numbers, so each band has three
//! weights, and a picture is three weighted sums of its bands.

use crate::{
    color::{
        Observer, Xyz, adapted,
        srgb::WHITE,
        xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values},
    },
    spectrum::{NamedSpectrum, Outside, Sampled, SpectralImage},
};

/// The weights of an image's bands for X, Y and Z.
#[derive(Clone, Debug, PartialEq)]
pub struct BandWeights {
    weights: Vec<[f64; 3]>,
    outside: Outside,
    observer: Observer,
    /// The light on whole nm and one over its Y.
    under: Option<(Vec<f64>, f64)>,
    /// The light's colour, where it is to become the screen's white.
    white: Option<Xyz>,
    scale: f64,
}

impl BandWeights {
    /// The weights of an image. `under` is the light on a reflectance or transmittance:
    /// then Y = 1 is the light's; `to_light` brings that light to the screen's white.
    ///
    /// `None` when that light does not shine.
    pub fn of(
        image: &SpectralImage,
        observer: Observer,
        under: Option<&NamedSpectrum>,
        to_light: bool,
    ) -> Option<Self> {
        let light = |light: &NamedSpectrum| {
            light
                .samples
                .on_whole_nm(FIRST_NM, LAST_NM, light.kind.outside())
        };
        let mut found = Self {
            weights: Vec::new(),
            outside: image.kind.outside(),
            observer,
            under: None,
            white: None,
            scale: image.scale,
        };
        if let Some(under) = under {
            let light = light(under);
            let white = xyz_from_nm_values(&light, observer);
            if !(white.y > 0.0 && white.is_finite()) {
                return None;
            }
            // A light too narrow to adapt to is shown as it is.
            found.white =
                Some(white).filter(|white| to_light && adapted(*white, *white, WHITE).is_some());
            found.under = Some((light, 1.0 / white.y));
        }
        found.weights = found.weights_on(image.cube.nm());
        Some(found)
    }

    fn weights_on(&self, nm: &[f64]) -> Vec<[f64; 3]> {
        let Ok(axis) = Sampled::new(nm.to_vec(), vec![0.0; nm.len()]) else {
            return vec![[0.0; 3]; nm.len()];
        };
        let weight = |band: usize| {
            let mut values = vec![0.0; nm.len()];
            values[band] = self.scale;
            let alone = axis.sharing(values).ok();
            alone.map_or([0.0; 3], |alone| self.xyz(&alone).to_array())
        };
        (0..nm.len()).map(weight).collect()
    }

    /// XYZ of a spectrum whose values are in the image's unit; the light on it has Y = 1.
    pub fn xyz(&self, spectrum: &Sampled) -> Xyz {
        let mut values = spectrum.on_whole_nm(FIRST_NM, LAST_NM, self.outside);
        let mut factor = 1.0;
        if let Some((light, over_y)) = &self.under {
            values.iter_mut().zip(light).for_each(|(v, l)| *v *= l);
            factor = *over_y;
        }
        let seen = xyz_from_nm_values(&values, self.observer) * factor;
        match self.white {
            Some(white) => adapted(seen, white, WHITE).unwrap_or(seen),
            None => seen,
        }
    }

    /// XYZ of a pixel, counted from 0; `None` where it was not measured.
    pub fn pixel(&self, image: &SpectralImage, x: usize, y: usize) -> Option<Xyz> {
        let spectrum = image.cube.spectrum_at(x, y)?;
        Some(self.xyz(&spectrum.scaled(image.scale))).filter(|xyz| xyz.is_finite())
    }

    /// The three weights of each band, for the file's own numbers.
    pub fn weights(&self) -> &[[f64; 3]] {
        &self.weights
    }

    /// Whether any band is seen at all.
    pub fn sees(&self) -> bool {
        self.weights.iter().any(|weight| weight[1] > 0.0)
    }
}
