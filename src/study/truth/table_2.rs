//! Table 2: the colour-matching functions as four Gaussian bells.

use crate::{
    color::{
        ColourMatching, Observer, Weights, Xyz, delta_e_of_xyz, gaussian_cmf, uv_1976_from_xyz,
        xyz_of_parts,
    },
    spectrum::Band,
};

/// Accuracy of Table 2 against the colour-matching functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table2 {
    /// The largest deviation of x-bar, y-bar and z-bar on the range.
    pub worst: [Deviation; 3],
    /// The light's XYZ by the table, in value x nm over the range.
    pub by_table: Xyz,
    /// The light's XYZ by the fit, in the same unit.
    pub by_fit: Xyz,
    /// Distance in CIE 1976 u'v' between the two.
    pub delta_uv: Option<f64>,
    /// CIEDE2000 between the two; the white is the light by the table.
    pub delta_e_2000: Option<f64>,
}

/// The largest deviation of a fitted function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Where, in nm.
    pub at_nm: f64,
    /// The function there.
    pub table: f64,
    /// The fit there.
    pub fit: f64,
}

impl Deviation {
    /// Fit minus function.
    pub fn off(self) -> f64 {
        self.fit - self.table
    }
}

/// Sets Table 2 against an observer's functions (it was made for CIE 1931), and a light's own
/// colour by the one against that by the other.
///
/// # Panics
/// When `light` does not have one value per grid point of the band.
pub(crate) fn table_2(band: Band, observer: Observer, light: &[f64]) -> Table2 {
    let table = observer.table();
    let mut fit: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(band.points()));
    for nm in band.grid() {
        for (row, value) in fit.iter_mut().zip(gaussian_cmf::fitted_at(nm)) {
            row.push(value);
        }
    }
    let by_table = xyz_of_parts(band, light, &[], &table.on_band(band));
    let by_fit = xyz_of_parts(band, light, &[], &Weights::new(band, fit));
    let uv = uv_1976_from_xyz(by_table).zip(uv_1976_from_xyz(by_fit));
    Table2 {
        worst: std::array::from_fn(|k| worst_deviation(band, table, k)),
        by_table,
        by_fit,
        delta_uv: uv.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])),
        delta_e_2000: delta_e_of_xyz(by_table, by_fit, by_table),
    }
}

pub(super) fn worst_deviation(band: Band, table: &ColourMatching, k: usize) -> Deviation {
    let at = |at_nm| Deviation {
        at_nm,
        table: table.at(at_nm)[k],
        fit: gaussian_cmf::fitted_at(at_nm)[k],
    };
    band.grid().map(at).fold(at(band.min_nm()), |worst, found| {
        if found.off().abs() > worst.off().abs() {
            found
        } else {
            worst
        }
    })
}
