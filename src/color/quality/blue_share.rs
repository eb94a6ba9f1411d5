//! The share of a light's power that is blue.

use super::{
    light::{Light, positive},
    no_figure::NoFigure,
    single::Single,
    weight::Weight,
};

/// Power of 415-455 nm over that of 360-830 nm.
pub(crate) const BLUE_SHARE: Single = Single {
    key: "blue_share",
    title: "Blue share",
    unit: "",
    digits: 3,
    method: "sum(P, 415-455 nm) / sum(P, 360-830 nm)",
    of: blue_share,
};

/// # Errors
/// [`NoFigure`] when there is no light.
fn blue_share(light: &Light) -> Result<f64, NoFigure> {
    let lit = light.lit()?;
    let power = positive(lit.power(), "sum of the values")?;
    Ok(Weight::new(415, vec![1.0; 41]).sum(lit) / power)
}
