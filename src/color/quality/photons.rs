//! Photons for plants: photosynthetic photon flux density, 400-700 nm, and its extension to 750 nm.
//!
//! `sum(E l) / (h c N)` over whole nm with both ends in, the constant from the SI's exact values:
//! 8.3593e-3 µmol/(m² s) per W/m² and nm. ePPFD: Zhen, van Iersel and Bugbee 2021.

use std::sync::LazyLock;

use super::{
    light::Light,
    no_figure::NoFigure,
    photometry::{LUMENS_PER_WATT, luminous_sum},
    weight::Weight,
};

/// Planck's constant x speed of light x Avogadro's number, J nm per µmol of photons: what turns
/// a photon flux at a wavelength in nm into power (all three exact in the SI of 2019).
pub(crate) const JOULE_NM_PER_MICROMOLE: f64 =
    6.626_070_15e-34 * 299_792_458.0 * 1e9 * 6.022_140_76e23 * 1e-6;

/// µmol of photons in a joule at 1 nm.
const MICROMOLES_PER_JOULE_NM: f64 = 1.0 / JOULE_NM_PER_MICROMOLE;

const FIRST_NM: u32 = 400;
const LAST_NM: u32 = 700;
const EXTENDED_LAST_NM: u32 = 750;

/// Photons that come with 100 lx, µmol m-2 s-1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotonsPer100Lx {
    /// PPFD, 400-700 nm.
    pub ppfd: f64,
    /// ePPFD, 400-750 nm.
    pub eppfd: f64,
}

/// Photons that come with 100 lx of a light.
///
/// # Errors
/// [`NoFigure`] when there is no light or nothing of it is seen.
pub(crate) fn photons_per_100_lx(light: &Light) -> Result<PhotonsPer100Lx, NoFigure> {
    let unit = 100.0 / (LUMENS_PER_WATT * luminous_sum(light.lit()?)?);
    let [ppfd, eppfd] = photon_sums(light).map(|sum| sum * unit);
    Ok(PhotonsPer100Lx { ppfd, eppfd })
}

/// µmol a second in 400-700 and 400-750 nm for values in W per nm.
pub(super) fn photon_sums(light: &Light) -> [f64; 2] {
    [&*PPFD, &*EPPFD].map(|weight| weight.sum(light))
}

fn photons(last_nm: u32) -> Weight {
    let nm = (FIRST_NM..=last_nm).map(f64::from);
    Weight::new(
        FIRST_NM,
        nm.map(|nm| nm * MICROMOLES_PER_JOULE_NM).collect(),
    )
}

static PPFD: LazyLock<Weight> = LazyLock::new(|| photons(LAST_NM));

static EPPFD: LazyLock<Weight> = LazyLock::new(|| photons(EXTENDED_LAST_NM));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Line;

    #[test]
    fn a_line_counts_its_photons_up_to_both_ends() {
        // 8.3593e-3 is the constant to five figures.
        assert!((MICROMOLES_PER_JOULE_NM - 8.3593e-3).abs() < 5e-8);
        for (at_nm, counts) in [
            (399.9, [false, false]),
            (400.0, [true, true]),
            (700.0, [true, true]),
            (700.1, [false, true]),
            (750.0, [false, true]),
            (750.1, [false, false]),
        ] {
            let sums = photon_sums(&Light::of_line(Line::ideal(at_nm, 1.0)));
            for (sum, counts) in sums.into_iter().zip(counts) {
                let expected = if counts {
                    at_nm * MICROMOLES_PER_JOULE_NM
                } else {
                    0.0
                };
                // Two products of interpolation.
                assert!((sum - expected).abs() < 1e-14, "{at_nm}");
            }
        }
    }
}
