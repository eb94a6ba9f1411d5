//! Weights of a spectrum for X, Y and Z: colour-matching functions, alone or times one factor.

use std::ops::Deref;

use crate::spectrum::{Band, Line};

/// X, Y and Z weights on the 1 nm grid of a band, and exactly between its points.
///
/// On the grid they are three plain rows of [`Band::points`] values. Behind a factor (a filter
/// before a light, a light on a surface) a line is weighed by the factor times the colour-matching
/// functions, each read off at the line's own wavelength: the product of two straight lines, which
/// is not the straight line between two products. In the cell of the grid where the table of the
/// functions itself begins or ends, the functions rise from zero at the grid point before.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    band: Band,
    rows: [Vec<f64>; 3],
    /// In each cell of the grid, the rise of the functions times that of the factor: how far the
    /// product of the two straight lines hangs below the straight line between products. Without a
    /// factor there is none.
    bends: Option<[Vec<f64>; 3]>,
}

impl Weights {
    /// Functions without a factor, straight between grid points.
    ///
    /// # Panics
    /// When a row does not have [`Band::points`] values.
    pub(crate) fn new(band: Band, rows: [Vec<f64>; 3]) -> Self {
        assert!(
            rows.iter().all(|row| row.len() == band.points()),
            "one value per grid point"
        );
        Self {
            band,
            rows,
            bends: None,
        }
    }

    /// The same functions behind a factor on the band's grid. Factors that stand behind one
    /// another are multiplied before.
    ///
    /// # Panics
    /// When the factor does not have [`Band::points`] values, or there is a factor already.
    pub(crate) fn behind(&self, factor: &[f64]) -> Self {
        assert_eq!(factor.len(), self.band.points(), "one value per grid point");
        assert!(self.bends.is_none(), "one factor");
        let rises = |row: &[f64]| -> Vec<f64> { row.windows(2).map(|w| w[1] - w[0]).collect() };
        let by_factor = rises(factor);
        let times = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect();
        Self {
            band: self.band,
            rows: self.rows.each_ref().map(|row| times(row, factor)),
            bends: Some(
                self.rows
                    .each_ref()
                    .map(|row| times(&rises(row), &by_factor)),
            ),
        }
    }

    /// X, Y and Z of a line of weight 1 at a wavelength in nm; zero outside the band.
    pub(crate) fn at(&self, at_nm: f64) -> [f64; 3] {
        if !self.band.contains(at_nm) {
            return [0.0; 3];
        }
        let x = at_nm - self.band.min_nm();
        let cell = (x as usize).min(self.band.steps() - 1);
        let t = x - cell as f64;
        std::array::from_fn(|k| {
            let row = &self.rows[k];
            let bend = self.bends.as_ref().map_or(0.0, |bends| bends[k][cell]);
            row[cell] * (1.0 - t) + row[cell + 1] * t - t * (1.0 - t) * bend
        })
    }

    /// X, Y and Z of a line, in value x nm: an ideal one where it stands, a wide one over its
    /// Gaussian on the grid.
    pub(crate) fn of_line(&self, line: &Line) -> [f64; 3] {
        if line.is_ideal() {
            return self.at(line.at_nm).map(|v| v * line.weight);
        }
        self.rows
            .each_ref()
            .map(|row| line.integrate(self.band, row))
    }
}

/// The rows on the grid.
impl Deref for Weights {
    type Target = [Vec<f64>; 3];

    fn deref(&self) -> &Self::Target {
        &self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Observer, PatchSet};

    #[test]
    fn a_line_behind_a_factor_is_weighed_by_both_where_it_stands() {
        let band = Band::VISIBLE;
        let filter = |nm: f64| (-((nm - 540.5) / 6.0).powi(2)).exp();
        let factor: Vec<f64> = band.grid().map(filter).collect();
        for observer in Observer::CIE {
            let weights = observer.table().on_band(band).behind(&factor);
            let patches = PatchSet::new(
                std::slice::from_ref(&factor),
                vec!["filter".into()],
                band,
                observer,
            );
            for at_nm in [435.5_f64, 546.5, 589.25, 611.5, 779.75, 780.0] {
                // The straight line through the factor's grid points, by hand.
                let left = at_nm.floor().min(779.0);
                let t = at_nm - left;
                let read_off = filter(left) * (1.0 - t) + filter(left + 1.0) * t;
                let expected = observer.table().at(at_nm).map(|v| v * read_off);
                let mut patch = patches.buffer();
                patches.add_line(at_nm, 1.0, &mut patch);
                for ((found, hand), patch) in
                    weights.at(at_nm).into_iter().zip(expected).zip(patch[0])
                {
                    // Rounding: the same sum, bracketed in another way.
                    assert!((found - hand).abs() < 1e-15, "{at_nm} nm: {found}, {hand}");
                    assert!(
                        (found - patch).abs() < 1e-15,
                        "{at_nm} nm: {found}, {patch}"
                    );
                }
            }
            assert_eq!(weights.at(379.9), [0.0; 3]);
            assert_eq!(weights.at(780.1), [0.0; 3]);
        }
    }
}
