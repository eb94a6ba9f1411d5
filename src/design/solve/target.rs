//! The colour that a mixture is to have.

use std::fmt;

use crate::{
    color::{Xyz, uv_1960_from_kelvin, uv_1976_from_xyz, xy_from_xyz, xyz_from_xy},
    design::{mixture::MixError, scales::basic_sums, small::digits, whole_nm},
    languages::with_sign,
    spectrum::Sampled,
};

/// Temperatures that a target may have, K.
const KELVIN: [f64; 2] = [1000.0, 100_000.0];

/// A colour to be met, Y = 100.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Target {
    xyz: Xyz,
}

impl Target {
    /// A chromaticity.
    ///
    /// # Errors
    /// [`MixError::Target`] for numbers that are no chromaticity of X, Y, Z of 0 or more.
    pub(crate) fn of_xy(xy: [f64; 2]) -> Result<Self, MixError> {
        let refused = || MixError::Target {
            found: xy.map(digits).join(","),
            expected: said!("x,y with y above 0 and x + y of 1 at most").to_owned(),
        };
        let xyz = xyz_from_xy(xy, 100.0).ok_or_else(refused)?;
        let fits = xyz.x >= 0.0 && xyz.z >= -1e-9;
        fits.then_some(Self { xyz }).ok_or_else(refused)
    }

    /// A blackbody's chromaticity, `duv` off its locus (CIE 1960, positive towards green).
    ///
    /// # Errors
    /// [`MixError::Target`] for a temperature beyond 1000-100 000 K or a distance beyond 0.05.
    pub fn of_kelvin(kelvin: f64, duv: f64) -> Result<Self, MixError> {
        let refused = || MixError::Target {
            found: tr!(
                "{kelvin} K, Duv {duv}",
                kelvin = with_sign(digits(kelvin)),
                duv = with_sign(digits(duv))
            ),
            expected: tr!(
                "{least} to {most} K and a Duv of -0.05 to 0.05",
                least = KELVIN[0],
                most = KELVIN[1]
            ),
        };
        let fits = (KELVIN[0]..=KELVIN[1]).contains(&kelvin) && duv.abs() <= 0.05;
        let at = |kelvin| uv_1960_from_kelvin(kelvin);
        // Square to the locus, whose direction is that between two near temperatures.
        let step = kelvin * 1e-4;
        let (here, warm, cold) = match (at(kelvin), at(kelvin - step), at(kelvin + step)) {
            (Some(here), Some(warm), Some(cold)) if fits => (here, warm, cold),
            _ => return Err(refused()),
        };
        let along = [warm[0] - cold[0], warm[1] - cold[1]];
        let length = along[0].hypot(along[1]);
        // Towards warm lights u grows; green lies on the left of that way.
        let [u, v] = [
            here[0] - duv * along[1] / length,
            here[1] + duv * along[0] / length,
        ];
        let below = 2.0 * u - 8.0 * v + 4.0;
        Self::of_xy([3.0 * u / below, 2.0 * v / below])
    }

    /// The chromaticity of a light.
    ///
    /// # Errors
    /// [`MixError::Target`] for a light that shows no colour.
    pub fn of_light(light: &Sampled) -> Result<Self, MixError> {
        let sums = basic_sums(&whole_nm::table(light));
        let xyz = Xyz::new(sums[0], sums[1], sums[2]).with_y(100.0);
        xyz.map(|xyz| Self { xyz }).ok_or_else(|| MixError::Target {
            found: said!("a light without visible power").to_owned(),
            expected: said!("a light with a colour").to_owned(),
        })
    }

    /// XYZ, Y = 100.
    pub fn xyz(self) -> Xyz {
        self.xyz
    }

    /// CIE xy.
    pub fn xy(self) -> [f64; 2] {
        xy_from_xyz(self.xyz).unwrap_or_default()
    }

    /// CIE 1976 u'v'.
    pub(crate) fn uv(self) -> [f64; 2] {
        uv_1976_from_xyz(self.xyz).unwrap_or_default()
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.xy();
        write!(f, "{x:.4},{y:.4}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::cct_from_xyz;

    #[test]
    fn a_temperature_and_distance_come_back_from_the_colour() {
        for (kelvin, duv) in [
            (2700.0, 0.0),
            (6500.0, 0.0032),
            (4000.0, -0.01),
            (3000.0, 0.02),
        ] {
            let found = cct_from_xyz(Target::of_kelvin(kelvin, duv).unwrap().xyz()).unwrap();
            // Ohno's method: 0.1 K and 1e-6 near the locus, more where its parabola is far off.
            assert!((found.kelvin - kelvin).abs() < 0.3, "{found:?}");
            assert!((found.duv - duv).abs() < 1e-5, "{found:?}");
        }
    }

    #[test]
    fn what_is_no_colour_is_refused() {
        assert!(Target::of_xy([0.3, 0.0]).is_err());
        assert!(Target::of_xy([0.8, 0.4]).is_err());
        assert!(Target::of_xy([f64::NAN, 0.3]).is_err());
        assert!(Target::of_kelvin(500.0, 0.0).is_err());
        assert!(Target::of_kelvin(3000.0, 0.2).is_err());
    }
}
