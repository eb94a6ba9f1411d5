//! A measurement brought to a scale: by peak, area, the value at a wavelength, Y.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::{error::MeasurementError, measurement::Measurement};
use crate::{
    color::{
        Observer,
        xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values},
    },
    languages::with_sign,
    spectrum::{Outside, Sampled},
};

/// The sum with V of CIE 1931 over whole nm.
fn y_of(samples: &Sampled) -> f64 {
    let values = samples.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero);
    xyz_from_nm_values(&values, Observer::CIE_1931).y
}

/// Feature that sets the scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Normalise {
    /// The largest value.
    Peak,
    /// The area, value x nm.
    Area,
    /// The value at a wavelength, nm.
    At(f64),
    /// The sum with V of CIE 1931, at 100.
    Y,
}

impl fmt::Display for Normalise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Peak => f.write_str(said!("peak")),
            Self::Area => f.write_str(said!("area")),
            Self::At(nm) => f.write_str(&tr!("value at {nm} nm", nm = with_sign(nm.to_string()))),
            Self::Y => f.write_str("Y"),
        }
    }
}

/// That there is nothing to divide by.
fn indivisible(by: Normalise, found: f64) -> String {
    let found = with_sign(found.to_string());
    match by {
        Normalise::Peak => tr!(
            "found a largest value of {found}, expected one above 0 to divide by",
            found
        ),
        Normalise::Area => tr!(
            "found an area of {found}, expected one above 0 to divide by",
            found
        ),
        Normalise::At(nm) => tr!(
            "found a value at {nm} nm of {found}, expected one above 0 to divide by",
            nm = with_sign(nm.to_string()),
            found
        ),
        Normalise::Y => tr!(
            "found a Y of {found}, expected one above 0 to divide by",
            found
        ),
    }
}

/// A measurement divided by what is made one. Sigma goes along; the level is gone, and for a single
/// wavelength the noise of that one sample becomes a level.
///
/// # Errors
/// A sentence where there is nothing positive to divide by.
pub fn normalised(of: &Measurement, by: Normalise) -> Result<Measurement, MeasurementError> {
    let samples = &of.samples;
    let pairs = || samples.nm().windows(2).zip(samples.values().windows(2));
    let divisor = match by {
        Normalise::Peak => {
            let values = samples.values().iter().copied();
            values.fold(f64::NEG_INFINITY, f64::max)
        }
        Normalise::Area => {
            let areas = pairs().map(|(nm, v)| 0.5 * (nm[1] - nm[0]) * (v[0] + v[1]));
            areas.sum::<f64>()
        }
        Normalise::At(nm) => {
            if !(samples.first_nm()..=samples.last_nm()).contains(&nm) {
                return Err(MeasurementError::Apart(tr!(
                    "found {nm} nm, expected a wavelength within {first}-{last} nm",
                    nm = with_sign(nm.to_string()),
                    first = with_sign(samples.first_nm().to_string()),
                    last = with_sign(samples.last_nm().to_string())
                )));
            }
            samples.at(nm, Outside::Zero)
        }
        Normalise::Y => y_of(samples) / 100.0,
    };
    if !divisor.is_finite() || divisor <= 0.0 {
        return Err(MeasurementError::Meaningless(indivisible(by, divisor)));
    }
    let level = match by {
        Normalise::At(at) => {
            let nm = samples.nm();
            let right = nm.partition_point(|nm| *nm < at).clamp(1, nm.len() - 1);
            let share = (at - nm[right - 1]) / (nm[right] - nm[right - 1]);
            of.sigma_at(right - 1, share) / divisor
        }
        _ => 0.0,
    };
    Ok(Measurement {
        samples: samples.scaled(1.0 / divisor),
        sigma: of
            .sigma
            .as_ref()
            .map(|s| s.iter().map(|s| s / divisor).collect()),
        unit: "relative".to_owned(),
        level,
        ..of.clone()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurements::Quantity;

    #[test]
    fn each_scale_makes_its_own_figure_one_and_the_level_goes() {
        let samples = Sampled::new(vec![400.0, 500.0, 700.0], vec![2.0, 8.0, 2.0]).expect("rising");
        let mut light = Measurement::new("light", Quantity::Light, "W m-2 nm-1", samples);
        light.sigma = Some(vec![0.1, 0.2, 0.1]);
        light.level = 0.02;
        let peak = normalised(&light, Normalise::Peak).expect("positive");
        assert_eq!(peak.samples.values(), [0.25, 1.0, 0.25]);
        assert_eq!(peak.sigma, Some(vec![0.1 / 8.0, 0.2 / 8.0, 0.1 / 8.0]));
        assert_eq!(peak.level, 0.0);
        // 100 x 5 + 200 x 5 = 1500.
        let area = normalised(&light, Normalise::Area).expect("positive");
        assert!((area.samples.values()[1] - 8.0 / 1500.0).abs() < 1e-15);
        let at = normalised(&light, Normalise::At(500.0)).expect("inside");
        assert!((at.level - 0.2 / 8.0).abs() < 1e-15);
        let y = normalised(&light, Normalise::Y).expect("positive");
        assert!((y_of(&y.samples) - 100.0).abs() < 1e-9);
        let why = normalised(&light, Normalise::At(800.0))
            .expect_err("outside")
            .to_string();
        assert_eq!(why, "found 800 nm, expected a wavelength within 400-700 nm");
        let dark = light.samples.scaled(0.0);
        let dark = Measurement {
            samples: dark,
            ..light
        };
        assert!(normalised(&dark, Normalise::Peak).is_err());
    }
}
