//! The five alpha-opic quantities of CIE S 026:2018.
//!
//! Efficacy ratio `ELR = sum(P s) / (683.002 sum(P V))`, sums of `s` over 380-780 nm; daylight
//! efficacy ratio `DER = ELR / ELR of D65`; the equivalent daylight illuminance is DER x lx.

use std::sync::LazyLock;

use super::{
    light::Light,
    no_figure::NoFigure,
    photometry::{LUMENS_PER_WATT, luminous_sum},
    weight::{Weight, shipped},
};

/// Index of the melanopic one.
const MELANOPIC: usize = 4;

/// The alpha-opic ratios of a light: S-cone, M-cone, L-cone, rhodopic, melanopic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlphaOpic {
    /// Alpha-opic efficacy of luminous radiation, mW/lm.
    pub elr: [f64; 5],
    /// Alpha-opic daylight (D65) efficacy ratio.
    pub der: [f64; 5],
}

impl AlphaOpic {
    /// Melanopic daylight efficacy ratio.
    pub(crate) fn melanopic_der(&self) -> f64 {
        self.der[MELANOPIC]
    }

    /// Melanopic equivalent daylight illuminance, lx, at an illuminance in lx.
    pub(crate) fn melanopic_edi(&self, lux: f64) -> f64 {
        self.melanopic_der() * lux
    }
}

/// The alpha-opic ratios of a light.
///
/// # Errors
/// [`NoFigure`] when there is no light or nothing of it is seen.
pub(crate) fn alpha_opic(light: &Light) -> Result<AlphaOpic, NoFigure> {
    let elr = efficacies(light)?;
    Ok(AlphaOpic {
        elr,
        der: std::array::from_fn(|k| elr[k] / OF_D65[k]),
    })
}

fn efficacies(light: &Light) -> Result<[f64; 5], NoFigure> {
    let lumens = LUMENS_PER_WATT * luminous_sum(light.lit()?)?;
    Ok(std::array::from_fn(|k| {
        1e3 * SPECTRA[k].sum(light) / lumens
    }))
}

static SPECTRA: LazyLock<[Weight; 5]> = LazyLock::new(|| {
    [
        "S026 s_sc (S-cone-opic)",
        "S026 s_mc (M-cone-opic)",
        "S026 s_lc (L-cone-opic)",
        "S026 s_rh (rhodopic)",
        "S026 s_mel (melanopic)",
    ]
    .map(Weight::named)
});

/// Efficacy ratios of the table of D65.
static OF_D65: LazyLock<[f64; 5]> = LazyLock::new(|| {
    let d65 = Light::of_sampled(shipped("cie_illuminants", "CIE D65"));
    efficacies(&d65).expect("daylight is seen")
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ratios_of_d65_are_those_of_the_standard() {
        // As CIE S 026 states them, to four decimals.
        for (found, stated) in OF_D65.iter().zip([0.8173, 1.4558, 1.6289, 1.4497, 1.3262]) {
            assert!((found - stated).abs() < 5e-5, "{found} {stated}");
        }
        let d65 = Light::of_sampled(shipped("cie_illuminants", "CIE D65"));
        assert_eq!(alpha_opic(&d65).unwrap().der, [1.0; 5]);
        assert_eq!(alpha_opic(&d65).unwrap().melanopic_edi(250.0), 250.0);
    }
}
