//! Predicted colours of a recovered reflectance under other lights, and its error against a real
//! surface.

use super::{recovered::Recovered, recovered::Reflectance, viewing::BAND, viewing::Viewing};
use crate::{
    color::{Adaptation, Swatch, Xyz, delta_e_of_xyz, xyz_from_reflectance},
    spectrum::{Outside, Sampled},
};

/// A surface under a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// The light's name.
    pub light: String,
    /// XYZ, Y = 100 for the light.
    pub xyz: Xyz,
    /// Its colour on a screen.
    pub swatch: Swatch,
}

/// A reflectance under each of some named lights.
pub fn predictions(
    reflectance: &Reflectance,
    lights: &[(String, Viewing)],
    adaptation: Adaptation,
) -> Vec<Prediction> {
    let one = |(light, viewing): &(String, Viewing)| {
        let xyz = reflectance.xyz(viewing);
        Prediction {
            light: light.clone(),
            xyz,
            swatch: Swatch::of_patch(xyz, viewing.white(), adaptation),
        }
    };
    lights.iter().map(one).collect()
}

/// Error of a recovered reflectance against the real one whose colour it was made from.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// Root of the mean squared difference over the whole nm of 380-780.
    pub rms: f64,
    /// CIEDE2000 under each light of the list; `None` without light.
    pub delta_e: Vec<Option<f64>>,
}

/// Compares a recovered reflectance with a measured one, as numbers and under other lights.
pub fn deviation(
    recovered: &Recovered,
    measured: &Sampled,
    lights: &[(&Sampled, &Viewing)],
) -> Deviation {
    let table = recovered.reflectance.sampled();
    let made = table.on_band(BAND, Outside::Hold);
    let real = measured.on_band(BAND, Outside::Hold);
    let squares: f64 = made.iter().zip(&real).map(|(a, b)| (a - b).powi(2)).sum();
    let delta_e = lights
        .iter()
        .map(|(light, viewing)| {
            let real = xyz_from_reflectance(measured, light, viewing.observer())?;
            delta_e_of_xyz(real, recovered.reflectance.xyz(viewing), viewing.white())
        })
        .collect();
    Deviation {
        rms: (squares / BAND.points() as f64).sqrt(),
        delta_e,
    }
}
