//! The page "Products" as charts, one part a file.

pub mod absorption;
pub mod bounces;
pub mod chain;
pub mod narrow;
pub mod resampling;
pub mod same_surface;
pub mod two_lights;

use crate::{
    app::chart::{Chart, Theme},
    spectrum::Band,
};

/// Values on a band's grid as points, each times a factor.
fn curve(band: Band, values: &[f64], factor: f64) -> Vec<[f64; 2]> {
    let scaled = values.iter().map(|value| value * factor);
    band.grid().zip(scaled).map(|(nm, v)| [nm, v]).collect()
}

/// An empty chart over the wavelengths of a band.
fn over(band: Band, theme: Theme) -> Chart {
    Chart {
        x_label: "Wavelength (nm)".to_owned(),
        x_range: [band.min_nm(), band.max_nm()],
        theme,
        ..Chart::default()
    }
}
