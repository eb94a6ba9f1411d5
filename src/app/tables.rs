//! What many recomputations share: basis functions, patches and blur for one band.
//!
//! A slider move only does what depends on the slider. Everything here depends on the band, the
//! basis, the observer, the patch set and, for a reflectance, the light it is looked at under.

use std::sync::OnceLock;

use super::measured_surfaces::measured_surfaces;
use crate::{
    color::{
        Observer, Weights,
        patches::{PatchMatrix, PatchSet},
    },
    spectrum::{Band, Basis, BasisTable, InnerProducts, numbers_of_order},
    study::error::{BLUR_NM, Blur},
};

/// The largest order of the error-against-order curve.
pub const CURVE_ORDER: usize = 40;

/// How the subject's colour comes about.
#[derive(Clone, Debug)]
pub struct Viewing {
    /// What weighs the subject on the grid: the colour-matching functions of a light, those
    /// times the light for a reflectance.
    pub weights: Weights,
    /// The same for the CIE 1931 observer, which correlated colour temperature is defined for.
    pub weights_1931: Weights,
}

impl Viewing {
    /// A light looks like itself.
    pub fn of_light(band: Band, observer: Observer) -> Self {
        Self {
            weights: observer.table().on_band(band),
            weights_1931: Observer::CIE_1931.table().on_band(band),
        }
    }

    /// A reflectance is looked at under a light, given on the band's grid.
    pub fn under(light: &[f64], band: Band, observer: Observer) -> Self {
        let own = Self::of_light(band, observer);
        Self {
            weights: own.weights.behind(light),
            weights_1931: own.weights_1931.behind(light),
        }
    }
}

/// The patches that a light is judged by.
#[derive(Clone, Debug)]
pub struct PatchTables {
    /// Exact reflectances under any light of the band.
    pub set: PatchSet,
    /// The same under the basis functions.
    pub matrix: PatchMatrix,
    /// Each patch's reflectance on the grid.
    pub reflectances: Vec<Vec<f64>>,
    /// Each patch's reflectance as coefficients of the basis, in prefix order.
    pub coefficients: Vec<Vec<f64>>,
}

/// Shared tables for one band, basis, observer, patch set and viewing.
#[derive(Clone, Debug)]
pub struct Tables {
    /// The basis functions up to the largest order in use.
    pub basis: BasisTable,
    /// The same functions blurred by 10 nm, row by row.
    pub blurred: Vec<Vec<f64>>,
    /// The blur itself.
    pub blur: Blur,
    /// How the subject is looked at.
    pub viewing: Viewing,
    /// Inner products of the viewing's weights with the basis functions.
    pub colour: InnerProducts,
    /// The same for CIE 1931.
    pub colour_1931: InnerProducts,
    /// The patches; `None` when the subject is not a light.
    pub patches: Option<PatchTables>,
    /// All measured surfaces for the observer, made when they are asked for.
    surfaces: OnceLock<PatchSet>,
    observer: Observer,
}

impl Tables {
    /// Tables up to `order` (at least the order curve's), with patches given as names and
    /// reflectances on the band's grid.
    pub fn new(
        band: Band,
        basis: Basis,
        order: usize,
        observer: Observer,
        viewing: Viewing,
        patches: Option<(Vec<String>, Vec<Vec<f64>>)>,
    ) -> Self {
        let table = BasisTable::new(band, basis, numbers_of_order(order.max(CURVE_ORDER)));
        let blur = Blur::new(band, BLUR_NM);
        let patches = patches.map(|(names, reflectances)| {
            let set = PatchSet::new(&reflectances, names, band, observer);
            PatchTables {
                matrix: set.contract((0..table.numbers()).map(|k| table.row(k))),
                coefficients: reflectances
                    .iter()
                    .map(|r| table.project(r, table.numbers()))
                    .collect(),
                set,
                reflectances,
            }
        });
        Self {
            blurred: (0..table.numbers())
                .map(|k| blur.values(table.row(k)))
                .collect(),
            blur,
            colour: InnerProducts::new(&table, &viewing.weights),
            colour_1931: InnerProducts::new(&table, &viewing.weights_1931),
            viewing,
            patches,
            surfaces: OnceLock::new(),
            observer,
            basis: table,
        }
    }

    /// All measured surfaces that ship, made at the first call (5 ms).
    pub fn surfaces(&self) -> &PatchSet {
        let make = || measured_surfaces(self.band(), self.observer);
        self.surfaces.get_or_init(make)
    }

    /// The band of all tables.
    pub fn band(&self) -> Band {
        self.basis.band()
    }
}
