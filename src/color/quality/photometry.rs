//! Photometry: luminous efficacy and the S/P ratio.

use std::sync::LazyLock;

use super::{
    light::{Light, positive},
    no_figure::NoFigure,
    single::Single,
    weight::Weight,
};

/// Maximum luminous efficacy, lm/W: 683 lm/W at 540 THz (SI, 2019), which for air wavelengths and
/// the CIE table's peak at 555 nm reads 683.002.
pub(crate) const LUMENS_PER_WATT: f64 = 683.002;

/// Rounded constant used by convention for luminous efficacy of radiation, lm/W.
pub(crate) const LUMENS_PER_WATT_ROUNDED: f64 = 683.0;

/// The largest efficacy of scotopic vision, lm/W.
const SCOTOPIC_LUMENS_PER_WATT: f64 = 1700.06;

/// Luminous efficacy of radiation.
pub(crate) const EFFICACY: Single = Single {
    key: "ler",
    title: later!("Luminous efficacy of radiation"),
    unit: "lm/W",
    digits: 1,
    method: "683 sum(P V) / sum(P), 360-830 nm",
    of: luminous_efficacy,
};

/// Scotopic over photopic.
pub(crate) const SP_RATIO: Single = Single {
    key: "sp_ratio",
    title: later!("S/P ratio"),
    unit: "",
    digits: 2,
    method: "1700.06 sum(P V') / 683.002 sum(P V)",
    of: sp_ratio,
};

const SUM_WITH_V: &str = later!("sum with V(λ)");

/// Luminous efficacy of radiation over 360-830 nm, lm/W: `683 sum(P V) / sum(P)`.
///
/// # Errors
/// [`NoFigure`] when there is no light or a sum is not positive.
pub(crate) fn luminous_efficacy(light: &Light) -> Result<f64, NoFigure> {
    let power = positive(light.lit()?.power(), later!("sum of the values"))?;
    Ok(LUMENS_PER_WATT_ROUNDED * luminous_sum(light)? / power)
}

/// Scotopic over photopic: `1700.06 sum(P V') / (683.002 sum(P V))`.
///
/// # Errors
/// [`NoFigure`] when there is no light or nothing of it is seen by day.
fn sp_ratio(light: &Light) -> Result<f64, NoFigure> {
    let photopic = luminous_sum(light.lit()?)?;
    Ok(SCOTOPIC_LUMENS_PER_WATT * SCOTOPIC.sum(light) / (LUMENS_PER_WATT * photopic))
}

/// `sum(P V)`, positive.
pub(super) fn luminous_sum(light: &Light) -> Result<f64, NoFigure> {
    positive(photopic_sum(light), SUM_WITH_V)
}

/// `sum(P V)`.
pub(super) fn photopic_sum(light: &Light) -> f64 {
    PHOTOPIC.sum(light)
}

static PHOTOPIC: LazyLock<Weight> = LazyLock::new(|| Weight::named("V(lambda) photopic"));

static SCOTOPIC: LazyLock<Weight> = LazyLock::new(|| Weight::named("V'(lambda) scotopic"));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Line;

    fn line(at_nm: f64) -> Light {
        Light::of_line(Line::ideal(at_nm, 0.25))
    }

    #[test]
    fn a_line_at_555_nm_has_the_largest_efficacy() {
        // One division by itself.
        assert!((luminous_efficacy(&line(555.0)).unwrap() - 683.0).abs() < 1e-12);
        assert!(luminous_efficacy(&line(556.0)).unwrap() < 683.0);
    }
}
