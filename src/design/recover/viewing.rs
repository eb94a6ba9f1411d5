//! A light and an observer: what a reflectance's colour is, as sums over its nodes.
//!
//! A recovered reflectance is given at nodes 5 nm apart on 380-780 nm, a straight line in between
//! and its end values beyond: the reading that the program has of every measured reflectance. So
//! `XYZ = sum_j r_j c_j` with one column a node holds exactly for the full colour of METRICS.md
//! (360-830 nm, plain sums), and a colour that is met here is met everywhere in the program.

use super::error::RecoverError;
use crate::{
    color::{Observer, Xyz, xyz},
    design::small::combined,
    spectrum::{Band, Basis, Outside, Sampled, WORST_CONDITION, condition_number},
};

/// Band of recovered reflectances.
pub(crate) const BAND: Band = Band::VISIBLE;

/// Distance between nodes, nm.
pub(crate) const STEP_NM: usize = 5;

/// Number of nodes: 380, 385, ... 780 nm.
pub const NODES: usize = 81;

/// One value a node.
pub(crate) type Nodes = [f64; NODES];

/// Functions of the paper's series that are weighed: those of six coefficients.
pub(super) const FOURIER: usize = 6;

/// A light seen by an observer.
#[derive(Clone, Debug)]
pub struct Viewing {
    observer: Observer,
    white: Xyz,
    /// XYZ (white: Y = 1) of a reflectance that is 1 at a node and 0 at the others.
    pub(super) columns: Box<[[f64; 3]; NODES]>,
    /// The same of the first functions of the Fourier basis.
    pub(super) fourier: [[f64; 3]; FOURIER],
    condition: f64,
}

/// Wavelength of a node, nm.
pub(crate) fn node_nm(node: usize) -> f64 {
    BAND.min_nm() + (node * STEP_NM) as f64
}

/// Nodes as a spectrum.
///
/// # Panics
/// Never: the nodes rise, and the callers' values are finite.
pub(crate) fn sampled_nodes(values: &Nodes) -> Sampled {
    Sampled::even(BAND.min_nm(), STEP_NM as f64, values.to_vec())
        .expect("rising places and finite values")
}

impl Viewing {
    /// A light (zero outside its table) seen by an observer.
    ///
    /// # Errors
    /// [`RecoverError::NoLight`] without a positive Y, [`RecoverError::FewColours`] for a light
    /// of one or two lines, under which three numbers do not tell three things.
    pub fn new(light: &Sampled, observer: Observer) -> Result<Self, RecoverError> {
        let values = light.on_whole_nm(xyz::FIRST_NM, xyz::LAST_NM, Outside::Zero);
        Self::of_nm_values(&values, observer)
    }

    /// The same for a light given on whole nm 360-830; a line is split over its two neighbours.
    ///
    /// # Errors
    /// As [`Viewing::new`]; [`RecoverError::NoLight`] also for another number of values than 471.
    pub(crate) fn of_nm_values(light: &[f64], observer: Observer) -> Result<Self, RecoverError> {
        let viewing = Self::unchecked(light, observer)?;
        if viewing.condition < WORST_CONDITION {
            Ok(viewing)
        } else {
            let condition = viewing.condition;
            Err(RecoverError::FewColours { condition })
        }
    }

    /// A light under which nothing is recovered, only looked at: two lines will do.
    ///
    /// # Errors
    /// [`RecoverError::NoLight`] without a positive Y.
    pub fn to_look(light: &Sampled, observer: Observer) -> Result<Self, RecoverError> {
        let values = light.on_whole_nm(xyz::FIRST_NM, xyz::LAST_NM, Outside::Zero);
        Self::unchecked(&values, observer)
    }

    /// True if a surface has the same colour under both: twice the same light, for one observer.
    pub(crate) fn is_alike(&self, other: &Self) -> bool {
        self.columns == other.columns
    }

    fn unchecked(light: &[f64], observer: Observer) -> Result<Self, RecoverError> {
        if light.len() != xyz::POINTS {
            return Err(RecoverError::NoLight);
        }
        let table = observer.table();
        let sum = xyz::xyz_from_nm_values(light, observer);
        let white = sum.with_y(100.0).ok_or(RecoverError::NoLight)?;
        let mut columns = Box::new([[0.0; 3]; NODES]);
        let mut fourier = [[0.0; 3]; FOURIER];
        for (index, power) in light.iter().enumerate() {
            let at_nm = f64::from(xyz::FIRST_NM) + index as f64;
            let seen = table.at(at_nm).map(|v| v * power / sum.y);
            let held_nm = at_nm.clamp(BAND.min_nm(), BAND.max_nm());
            let place = (held_nm - BAND.min_nm()) / STEP_NM as f64;
            let left = (place as usize).min(NODES - 2);
            let share = place - left as f64;
            for k in 0..3 {
                columns[left][k] += seen[k] * (1.0 - share);
                columns[left + 1][k] += seen[k] * share;
            }
            for (n, row) in fourier.iter_mut().enumerate() {
                let value = Basis::Fourier.function(n, BAND, held_nm);
                (0..3).for_each(|k| row[k] += seen[k] * value);
            }
        }
        let finite = columns.as_flattened().iter().all(|v| v.is_finite());
        let condition = condition_number(&columns[..].iter().map(|c| &c[..]).collect::<Vec<_>>());
        let viewing = Self {
            observer,
            white,
            columns,
            fourier,
            condition,
        };
        finite.then_some(viewing).ok_or(RecoverError::NoLight)
    }

    /// The observer.
    pub fn observer(&self) -> Observer {
        self.observer
    }

    /// XYZ of the light, Y = 100.
    pub fn white(&self) -> Xyz {
        self.white
    }

    /// XYZ of a reflectance, Y = 100 for the light.
    pub fn xyz(&self, reflectance: &Nodes) -> Xyz {
        Xyz::from_array(combined(&*self.columns, reflectance)) * 100.0
    }

    /// XYZ of a Fourier series (at most six coefficients in prefix order: a0 a1 b1 a2 b2 a3), held
    /// at its end values beyond 380-780 nm; Y = 100 for the light.
    pub(crate) fn xyz_of_series(&self, coefficients: &[f64]) -> Xyz {
        Xyz::from_array(combined(&self.fourier, coefficients)) * 100.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::xyz_from_reflectance;

    fn lamp() -> Sampled {
        let nm: Vec<f64> = (0..40).map(|i| 390.0 + 9.7 * f64::from(i)).collect();
        let values = nm.iter().map(|nm| 1.0 + (nm / 31.0).sin()).collect();
        Sampled::new(nm, values).unwrap()
    }

    #[test]
    fn the_sum_over_nodes_is_the_colour_that_the_program_gives_the_same_table() {
        let nodes: Nodes = std::array::from_fn(|j| 0.5 + 0.4 * (j as f64 / 7.0).cos());
        for observer in Observer::CIE {
            let viewing = Viewing::new(&lamp(), observer).unwrap();
            let full = xyz_from_reflectance(&sampled_nodes(&nodes), &lamp(), observer).unwrap();
            let found = viewing.xyz(&nodes);
            // The same products in another order; values near 100.
            for (a, b) in full.to_array().into_iter().zip(found.to_array()) {
                assert!((a - b).abs() < 1e-11, "{observer:?}");
            }
        }
    }

    #[test]
    fn a_light_of_one_line_shows_too_few_colours_and_no_light_none() {
        let line = Sampled::new(vec![545.0, 546.0, 547.0], vec![0.0, 1.0, 0.0]).unwrap();
        assert!(matches!(
            Viewing::new(&line, Observer::CIE_1931),
            Err(RecoverError::FewColours { .. })
        ));
        assert!(Viewing::to_look(&line, Observer::CIE_1931).is_ok());
        let dark = lamp().scaled(0.0);
        assert_eq!(
            Viewing::new(&dark, Observer::CIE_1931).unwrap_err(),
            RecoverError::NoLight
        );
    }
}
