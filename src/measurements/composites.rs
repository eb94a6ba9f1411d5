//! Sums and differences of composites, on their coefficients and weights.
//!
//! A lamp less itself moved by a tenth of a nm leaves 2 % of its power as samples; as composites
//! whose lines are matched .1 %.

use crate::spectrum::{Band, BasisTable, Composite, Line, Series};

/// Lines of two composites that are so near are one, nm.
const SAME_NM: f64 = 0.5;

/// A weighted sum of composites and whether a series was brought to another basis, through the 1 nm
/// grid; `None` where their ranges differ or there is none.
pub fn sum_of_composites(parts: &[(f64, &Composite)]) -> Option<(Composite, bool)> {
    let ((by, first), others) = parts.split_first()?;
    let band = first.band();
    let mut smooth = first.smooth().clone();
    smooth.coefficients.iter_mut().for_each(|c| *c *= by);
    let mut lines: Vec<Line> = first
        .lines()
        .iter()
        .map(|line| weighed(line, *by))
        .collect();
    let mut is_brought = false;
    for (by, part) in others {
        if part.band() != band {
            return None;
        }
        let own = part.smooth();
        let brought = (own.basis != smooth.basis).then(|| in_basis(band, own, &smooth));
        is_brought |= brought.is_some();
        let coefficients = brought.as_ref().unwrap_or(&own.coefficients);
        if coefficients.len() > smooth.coefficients.len() {
            smooth.coefficients.resize(coefficients.len(), 0.0);
        }
        for (sum, c) in smooth.coefficients.iter_mut().zip(coefficients) {
            *sum += by * c;
        }
        joined(&mut lines, part.lines(), *by);
    }
    Some((Composite::of_lines_inside(smooth, lines), is_brought))
}

fn weighed(line: &Line, by: f64) -> Line {
    Line::new(line.at_nm, by * line.weight, line.fwhm_nm)
}

/// Adds lines: each to the nearest that is the same, once; what has none stands beside.
fn joined(lines: &mut Vec<Line>, others: &[Line], by: f64) {
    let mut is_taken = vec![false; lines.len()];
    for other in others {
        let away = |i: &usize| (lines[*i].at_nm - other.at_nm).abs();
        let nearest = (0..is_taken.len())
            .filter(|i| !is_taken[*i] && away(i) <= SAME_NM)
            .min_by(|a, b| away(a).total_cmp(&away(b)));
        let Some(nearest) = nearest else {
            lines.push(weighed(other, by));
            continue;
        };
        is_taken[nearest] = true;
        let own = lines[nearest];
        let (a, b) = (own.weight.abs(), (by * other.weight).abs());
        let between = |x: f64, y: f64| match a + b > 0.0 {
            true => (a * x + b * y) / (a + b),
            false => x,
        };
        lines[nearest] = Line::new(
            between(own.at_nm, other.at_nm),
            own.weight + by * other.weight,
            between(own.fwhm_nm, other.fwhm_nm),
        );
    }
}

/// Coefficients of a series in another's basis.
fn in_basis(band: Band, series: &Series, like: &Series) -> Vec<f64> {
    let numbers = series.coefficients.len().max(like.coefficients.len());
    let table = BasisTable::new(band, like.basis, numbers);
    table.project(&series.on_band(), numbers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Basis;

    fn composite(basis: Basis, coefficients: &[f64], lines: &[(f64, f64)]) -> Composite {
        let series = Series::new(Band::VISIBLE, basis, coefficients.to_vec());
        let lines = lines.iter().map(|(at, w)| Line::ideal(*at, *w)).collect();
        Composite::new(series, lines).expect("inside")
    }

    #[test]
    fn lines_of_one_lamp_moved_a_little_leave_nothing_and_others_stay_negative() {
        let a = composite(Basis::Cosine, &[2.0, 0.5], &[(435.8, 3.0), (546.1, 1.0)]);
        let b = composite(
            Basis::Cosine,
            &[2.0, 0.5, 0.1],
            &[(435.9, 3.0), (611.0, 2.0)],
        );
        let (found, is_brought) = sum_of_composites(&[(1.0, &a), (-1.0, &b)]).expect("one range");
        assert!(!is_brought);
        assert_eq!(found.smooth().coefficients, [0.0, 0.0, -0.1]);
        let lines: Vec<(f64, f64)> = found.lines().iter().map(|l| (l.at_nm, l.weight)).collect();
        assert_eq!(lines.len(), 3);
        assert_eq!(lines[0].1, 0.0);
        assert_eq!(&lines[1..], [(546.1, 1.0), (611.0, -2.0)]);
    }

    #[test]
    fn a_sum_of_two_bases_goes_through_the_grid_and_two_ranges_have_none() {
        let a = composite(Basis::Cosine, &[1.0, 0.2], &[]);
        let b = composite(Basis::Fourier, &[2.0], &[]);
        let (found, is_brought) = sum_of_composites(&[(0.5, &a), (0.5, &b)]).expect("one range");
        assert!(is_brought);
        // a_0 / 2 = 1 of the Fourier series.
        let expected = [1.0, 0.1];
        for (found, expected) in found.smooth().coefficients.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        let other = Series::new(Band::PAPER, Basis::Cosine, vec![1.0]);
        let other = Composite::new(other, Vec::new()).expect("inside");
        assert_eq!(sum_of_composites(&[(1.0, &a), (1.0, &other)]), None);
    }
}
