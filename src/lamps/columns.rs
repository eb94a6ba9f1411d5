//! The building blocks of an encoding, prepared once for all lights of a band: cosines, known
//! lamps, a pool of lines.
//!
//! The light's own X, Y, Z are to be exact. The first three cosines carry that: a column `a` is
//! replaced by `a - (c0 c1 c2) gamma` with the three numbers `gamma` that make its X, Y, Z vanish.
//! A fit with such columns is free of constraints, and the span is that of elimination by any other
//! particular solution.

use nalgebra::{Matrix3, Vector3};

use super::{
    encoding::MOST_LABELLED, error::EncodingError, judge::EvaluationSet, known::Atom,
    operators::Operators,
};
use crate::spectrum::{Band, Basis, BasisTable, Line, WORST_CONDITION, dot, gaussian};

/// Cosines that carry the light's own colour.
pub(super) const LEADING: usize = 3;

/// Widths of the pool's lines, nm.
const POOL_WIDTHS_NM: [f64; 8] = [0.0, 5.0, 8.0, 12.0, 18.0, 26.0, 38.0, 55.0];

/// Distance of the pool's places, nm.
const POOL_STEP_NM: usize = 2;

/// In the search a line ends where it is below this share of its height: 1.8 widths from its centre.
/// All that the search knows of a line is of the line so cut; rounding alone parts its figures.
const POOL_NEGLIGIBLE: f64 = 1e-4;

/// A column: what takes its own colour away, and the goals' rows of what is left.
#[derive(Clone, Debug)]
pub(super) struct Column {
    /// Numbers of the leading cosines that have its X, Y, Z.
    pub gamma: [f64; 3],
    /// Rows without them.
    pub rows: Vec<f64>,
}

/// A line of the pool: a piece of the kernel of its width, times a factor.
#[derive(Clone, Debug)]
pub(super) struct PoolLine {
    /// Place and width.
    pub line: Line,
    /// First grid point.
    pub first: usize,
    /// Index of the kernel, and the piece of it.
    kernel: usize,
    piece: std::ops::Range<usize>,
    /// Factor that makes its area 1.
    factor: f64,
    /// As [`Column::gamma`].
    pub gamma: [f64; 3],
}

/// All columns of a band.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    /// The goals' rows.
    pub operators: Operators,
    /// The cosines after the leading ones.
    pub cosines: Vec<Column>,
    /// Known lamps, in the order of the atoms given.
    pub atoms: Vec<Column>,
    /// The pool.
    pub lines: Vec<PoolLine>,
    /// One a width, of height 1, cut where it is negligible: small enough to stay near the
    /// processor while all lines are summed.
    kernels: Vec<Vec<f64>>,
    /// Of the pool's lines, row by row: three rows a colour, then none of the blurred spectrum.
    pub line_colours: Vec<Vec<f64>>,
    /// Of the pool's lines, the sum of squares of the blurred rows.
    pub line_blurs: Vec<f64>,
    leading: [Vec<f64>; LEADING],
    leading_rows: [Vec<f64>; LEADING],
    inverse: Matrix3<f64>,
}

impl Columns {
    /// Columns for a panel that chooses, with these known lamps.
    ///
    /// # Errors
    /// [`EncodingError::Unseen`] when the leading cosines cannot carry a colour on this band.
    pub(super) fn new(panel: &EvaluationSet, atoms: &[Atom]) -> Result<Self, EncodingError> {
        let band = panel.band();
        let operators = Operators::new(panel);
        let table = BasisTable::new(band, Basis::Cosine, MOST_LABELLED + 1);
        if table.numbers() <= LEADING {
            return Err(EncodingError::Unseen { band });
        }
        let leading = [0, 1, 2].map(|n| table.row(n).to_vec());
        let colours = leading.each_ref().map(|row| operators.xyz(0, row));
        let matrix = Matrix3::from_fn(|i, j| colours[j][i]);
        let spread = matrix.singular_values();
        let is_told_apart = spread[2] * WORST_CONDITION > spread[0];
        if !is_told_apart {
            return Err(EncodingError::Unseen { band });
        }
        let inverse = matrix.try_inverse().ok_or(EncodingError::Unseen { band })?;
        let mut columns = Self {
            leading_rows: leading.each_ref().map(|row| operators.rows_of(0, row)),
            operators,
            cosines: Vec::new(),
            atoms: Vec::new(),
            lines: Vec::new(),
            kernels: POOL_WIDTHS_NM.iter().map(|width| kernel(*width)).collect(),
            line_colours: Vec::new(),
            line_blurs: Vec::new(),
            leading,
            inverse,
        };
        let rest = LEADING..table.numbers();
        columns.cosines = rest.map(|n| columns.column(0, table.row(n))).collect();
        columns.atoms = atoms.iter().map(|a| columns.column(0, &a.values)).collect();
        columns.fill_pool();
        Ok(columns)
    }

    /// The band.
    pub(super) fn band(&self) -> Band {
        self.operators.band()
    }

    /// Values that begin at grid point `first` as a column.
    pub(super) fn column(&self, first: usize, values: &[f64]) -> Column {
        let gamma = self.gamma(first, values);
        let mut rows = self.operators.rows_of(first, values);
        for (g, leading) in gamma.iter().zip(&self.leading_rows) {
            for (row, l) in rows.iter_mut().zip(leading) {
                *row -= g * l;
            }
        }
        Column { gamma, rows }
    }

    /// Numbers of the leading cosines that have the X, Y, Z of values.
    pub(super) fn gamma(&self, first: usize, values: &[f64]) -> [f64; 3] {
        let xyz = Vector3::from(self.operators.xyz(first, values));
        let gamma = self.inverse * xyz;
        // Once more on what rounding left, so that own colours are exact to the last digits.
        let left = xyz - self.forward(gamma);
        let mended: Vector3<f64> = gamma + self.inverse * left;
        mended.into()
    }

    fn forward(&self, gamma: Vector3<f64>) -> Vector3<f64> {
        let mut sum = Vector3::zeros();
        for (g, leading) in gamma.iter().zip(&self.leading) {
            sum += Vector3::from(self.operators.xyz(0, leading)) * *g;
        }
        sum
    }

    fn fill_pool(&mut self) {
        let band = self.band();
        let colours: usize = self.operators.colours().iter().sum();
        self.line_colours = vec![Vec::new(); 3 * colours];
        for (kernel, width_nm) in POOL_WIDTHS_NM.into_iter().enumerate() {
            let reach = self.kernels[kernel].len() / 2;
            for i in (0..band.points()).step_by(POOL_STEP_NM) {
                let (first, last) = (i.saturating_sub(reach), (i + reach).min(band.steps()));
                let piece = first + reach - i..last + reach - i + 1;
                let heights = self.kernels[kernel][piece.clone()].iter().enumerate();
                let area: f64 = heights.map(|(k, v)| band.weight(first + k) * v).sum();
                let mut line = PoolLine {
                    line: Line {
                        at_nm: band.nm(i),
                        weight: 1.0,
                        fwhm_nm: width_nm,
                    },
                    first,
                    kernel,
                    piece,
                    factor: 1.0 / area,
                    gamma: [0.0; 3],
                };
                let Column { gamma, rows } = self.column(first, &self.values_of(&line));
                line.gamma = gamma;
                let (colour, blur) = rows.split_at(3 * colours);
                for (all, row) in self.line_colours.iter_mut().zip(colour) {
                    all.push(*row);
                }
                self.line_blurs.push(dot(blur, blur));
                self.lines.push(line);
            }
        }
    }

    /// A pool line's values from its first grid point on.
    pub(super) fn values_of(&self, line: &PoolLine) -> Vec<f64> {
        let heights = &self.kernels[line.kernel][line.piece.clone()];
        heights.iter().map(|v| v * line.factor).collect()
    }

    /// Sums of every pool line, its own colour taken away, with a function on the grid.
    pub(super) fn line_sums(&self, h: &[f64]) -> Vec<f64> {
        let leading = self.leading.each_ref().map(|row| dot(row, h));
        let sum = |line: &PoolLine| {
            let heights = &self.kernels[line.kernel][line.piece.clone()];
            let own = line.factor * dot(&h[line.first..line.first + heights.len()], heights);
            let taken: f64 = line.gamma.iter().zip(leading).map(|(g, l)| g * l).sum();
            own - taken
        };
        self.lines.iter().map(sum).collect()
    }
}

/// A Gaussian of height 1 around its middle value, without its negligible feet; one value for an
/// ideal line.
fn kernel(width_nm: f64) -> Vec<f64> {
    if width_nm == 0.0 {
        return vec![1.0];
    }
    let falling = (0..).map(|d| gaussian(f64::from(d) / width_nm));
    let half: Vec<f64> = falling.take_while(|v| *v >= POOL_NEGLIGIBLE).collect();
    half[1..].iter().rev().chain(&half).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{color::Observer, lamps::known::atoms_on};

    #[test]
    fn a_column_has_no_colour_left() {
        let panel = EvaluationSet::choosing(Band::VISIBLE, Observer::CIE_1931);
        let columns = Columns::new(&panel, &[]).expect("the visible");
        let shape = crate::spectrum::LineProfile::new(Band::VISIBLE, 611.0, 5.0);
        let gamma = columns.gamma(shape.first, &shape.values);
        let mut rest = vec![0.0; 401];
        shape.add_to(1.0, &mut rest);
        for (g, row) in gamma.iter().zip(&columns.leading) {
            for (r, l) in rest.iter_mut().zip(row) {
                *r -= g * l;
            }
        }
        for left in columns.operators.xyz(0, &rest) {
            // Sums of 401 products near 1 that cancel.
            assert!(left.abs() < 1e-12, "{left}");
        }
    }

    #[test]
    fn the_pool_has_every_second_nm_in_eight_widths() {
        let panel = EvaluationSet::choosing(Band::VISIBLE, Observer::CIE_1931);
        let atoms = atoms_on(Band::VISIBLE);
        let columns = Columns::new(&panel, &atoms).expect("the visible");
        assert_eq!(columns.lines.len(), 1608);
        assert_eq!(columns.atoms.len(), atoms.len());
        assert!(columns.line_colours.iter().all(|row| row.len() == 1608));
    }

    #[test]
    fn a_range_without_the_visible_is_refused() {
        let infrared = Band::new(900.0, 1000.0).expect("100 nm");
        let panel = EvaluationSet::choosing(infrared, Observer::CIE_1931);
        assert_eq!(
            Columns::new(&panel, &[]).err(),
            Some(EncodingError::Unseen { band: infrared })
        );
    }
}
