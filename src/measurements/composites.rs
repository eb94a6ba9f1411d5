//! Sums and differences of composites, on their coefficients and weights.
//!
//! A lamp less itself moved by a tenth of a nm leaves 2 % of its power as samples; as composites
//! whose lines are matched .1 %.

use crate::spectrum::{Band, BasisTable, Composite, Line, Series};

/// Lines of one name that are so near are one, nm.
const SAME_NM: f64 = 0.5;

/// The same in standard uncertainties of their distance.
const SAME_IN_U: f64 = 3.0;

/// A composite as it is summed.
pub struct Summand<'a> {
    /// What it is multiplied by.
    pub by: f64,
    pub of: &'a Composite,
    /// What each of its lines is called, where anything explains it.
    pub names: Vec<Option<String>>,
    /// Standard uncertainty of their places, nm.
    pub u_at_nm: f64,
}

/// A line of a sum with what tells it from others.
struct Known {
    line: Line,
    name: Option<String>,
    u_at_nm: f64,
    /// False once a line of the present summand was added.
    is_free: bool,
}

/// A weighted sum of composites and whether a series was brought to another basis, through the 1 nm
/// grid; `None` where their ranges differ or there is none.
pub fn sum_of_composites(parts: &[Summand<'_>]) -> Option<(Composite, bool)> {
    let band = parts.first()?.of.band();
    if parts.iter().any(|part| part.of.band() != band) {
        return None;
    }
    // The longer series decides the basis too.
    let numbers = |part: &&Summand<'_>| part.of.smooth().coefficients.len();
    let most = parts.iter().map(|part| numbers(&part)).max()?;
    let longest = parts.iter().find(|part| numbers(part) == most)?;
    let basis = longest.of.smooth().basis;
    let mut smooth = Series::new(band, basis, vec![0.0; most]);
    let mut lines: Vec<Known> = Vec::new();
    let mut is_brought = false;
    for part in parts {
        let own = part.of.smooth();
        let brought = (own.basis != basis).then(|| in_basis(band, own, &smooth));
        is_brought |= brought.is_some();
        let coefficients = brought.as_ref().unwrap_or(&own.coefficients);
        for (sum, c) in smooth.coefficients.iter_mut().zip(coefficients) {
            *sum += part.by * c;
        }
        joined(&mut lines, part);
    }
    let lines = lines.into_iter().map(|known| known.line).collect();
    Some((Composite::of_lines_inside(smooth, lines), is_brought))
}

/// Adds lines: each to the nearest that is the same, once; what has none stands beside.
fn joined(lines: &mut Vec<Known>, part: &Summand<'_>) {
    lines.iter_mut().for_each(|known| known.is_free = true);
    for (index, other) in part.of.lines().iter().enumerate() {
        let other = Known {
            line: Line::new(other.at_nm, part.by * other.weight, other.fwhm_nm),
            name: part.names.get(index).cloned().flatten(),
            u_at_nm: part.u_at_nm,
            is_free: false,
        };
        let away = |known: &Known| (known.line.at_nm - other.line.at_nm).abs();
        let same = lines.iter_mut().filter(|known| {
            let u = known.u_at_nm.hypot(other.u_at_nm);
            known.is_free && known.name == other.name && away(known) <= SAME_NM.max(SAME_IN_U * u)
        });
        match same.min_by(|a, b| away(a).total_cmp(&away(b))) {
            Some(known) => known.take(&other),
            None => lines.push(other),
        }
    }
}

impl Known {
    /// Takes a line that is the same: the sum of the weights at the weighted place.
    fn take(&mut self, other: &Self) {
        let (a, b) = (self.line.weight.abs(), other.line.weight.abs());
        let between = |x: f64, y: f64| match a + b > 0.0 {
            true => (a * x + b * y) / (a + b),
            false => x,
        };
        self.line = Line::new(
            between(self.line.at_nm, other.line.at_nm),
            self.line.weight + other.line.weight,
            between(self.line.fwhm_nm, other.line.fwhm_nm),
        );
        self.u_at_nm = self.u_at_nm.max(other.u_at_nm);
        self.is_free = false;
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

    fn part<'a>(by: f64, of: &'a Composite, names: &[&str]) -> Summand<'a> {
        let name = |name: &&str| Some((*name).to_owned()).filter(|name| !name.is_empty());
        Summand {
            by,
            of,
            names: names.iter().map(name).collect(),
            u_at_nm: 0.0,
        }
    }

    fn told(sum: &Composite) -> Vec<(f64, f64)> {
        sum.lines().iter().map(|l| (l.at_nm, l.weight)).collect()
    }

    #[test]
    fn lines_of_one_lamp_moved_a_little_leave_nothing_and_others_stay_negative() {
        let a = composite(Basis::Cosine, &[2.0, 0.5], &[(435.8, 3.0), (546.1, 1.0)]);
        let b = composite(
            Basis::Cosine,
            &[2.0, 0.5, 0.1],
            &[(435.9, 3.0), (611.0, 2.0)],
        );
        let names = ["Hg 435.8", ""];
        let (found, is_brought) =
            sum_of_composites(&[part(1.0, &a, &names), part(-1.0, &b, &names)]).expect("one range");
        assert!(!is_brought);
        assert_eq!(found.smooth().coefficients, [0.0, 0.0, -0.1]);
        let lines = told(&found);
        assert_eq!(lines.len(), 3);
        assert_eq!(lines[0].1, 0.0);
        assert_eq!(&lines[1..], [(546.1, 1.0), (611.0, -2.0)]);
    }

    #[test]
    fn near_lines_of_different_names_are_two_and_what_their_places_leave_open_is_one() {
        let a = composite(Basis::Cosine, &[1.0], &[(587.6, 1.0)]);
        let b = composite(Basis::Cosine, &[1.0], &[(587.9, 1.0)]);
        let sum = |names: [&str; 2], u_at_nm: f64, of: &Composite| {
            let parts = [part(1.0, &a, &names[..1]), part(1.0, of, &names[1..])];
            let parts = parts.map(|part| Summand { u_at_nm, ..part });
            told(&sum_of_composites(&parts).expect("one range").0)
        };
        let two = [(587.6, 1.0), (587.9, 1.0)];
        assert_eq!(sum(["He 587.6", "Hg 587.9"], 0.0, &b), two);
        assert_eq!(sum(["He 587.6", ""], 0.0, &b), two);
        assert_eq!(sum(["He 587.6", "He 587.6"], 0.0, &b), [(587.75, 2.0)]);
        assert_eq!(sum(["", ""], 0.0, &b), [(587.75, 2.0)]);
        // 0.8 nm apart: three times .2 nm of each is .85 nm.
        let far = composite(Basis::Cosine, &[1.0], &[(588.4, 1.0)]);
        assert_eq!(sum(["", ""], 0.18, &far).len(), 2);
        assert_eq!(sum(["", ""], 0.2, &far).len(), 1);
    }

    #[test]
    fn a_sum_of_two_bases_goes_through_the_grid_and_two_ranges_have_none() {
        let a = composite(Basis::Cosine, &[1.0, 0.2], &[]);
        let b = composite(Basis::Fourier, &[2.0], &[]);
        let sum = sum_of_composites(&[part(0.5, &b, &[]), part(0.5, &a, &[])]);
        let (found, is_brought) = sum.expect("one range");
        // The longer series decides the basis.
        assert!(is_brought && found.smooth().basis == Basis::Cosine);
        // a_0 / 2 = 1 of the Fourier series.
        let expected = [1.0, 0.1];
        for (found, expected) in found.smooth().coefficients.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        let other = Series::new(Band::PAPER, Basis::Cosine, vec![1.0]);
        let other = Composite::new(other, Vec::new()).expect("inside");
        assert!(sum_of_composites(&[part(1.0, &a, &[]), part(1.0, &other, &[])]).is_none());
    }
}
