//! The figures of a mixture.

use crate::{
    color::{Cct, Xyz, cct_from_xyz, uv_1976_from_xyz, xy_from_xyz},
    design::scales::{Against, SampleTables, Scales, Sums},
};

/// The figures of a mixture; `None` for those that do not exist.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct MixFigures {
    /// CIE 1931, Y = 100.
    pub xyz: Option<Xyz>,
    /// CIE xy.
    pub xy: Option<[f64; 2]>,
    /// CIE 1976 u'v'.
    pub uv: Option<[f64; 2]>,
    /// Correlated colour temperature and Duv.
    pub cct: Option<Cct>,
    /// General colour rendering index.
    pub ra: Option<f64>,
    /// Fidelity index.
    pub rf: Option<f64>,
    /// Gamut index.
    pub rg: Option<f64>,
    /// Luminous efficacy of radiation, lm/W.
    pub ler: f64,
    /// Melanopic daylight efficacy ratio.
    pub melanopic_der: f64,
}

impl MixFigures {
    /// From the sums of a light.
    pub fn new(sums: &Sums, tables: &SampleTables) -> Self {
        let xyz = sums.xyz().with_y(100.0);
        let scales = xyz.and_then(|xyz| Scales::new(xyz, tables));
        Self {
            xyz,
            xy: xyz.and_then(xy_from_xyz),
            uv: xyz.and_then(uv_1976_from_xyz),
            cct: xyz.and_then(|xyz| cct_from_xyz(xyz).ok()),
            ra: scales.as_ref().and_then(|s| s.figure(Against::Ra, sums)),
            rf: scales.as_ref().and_then(|s| s.figure(Against::Rf, sums)),
            rg: scales.as_ref().and_then(|s| s.rg(sums)),
            ler: sums.efficacy(),
            melanopic_der: sums.melanopic_der(),
        }
    }
}
