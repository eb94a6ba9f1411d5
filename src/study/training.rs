//! Principal components trained without the spectrum at hand.
//!
//! The training set is dealt into five folds; a spectrum is fitted with the components of the
//! other four. Tables of the same name, and tables that are all but proportional, are dealt into
//! one fold, so that a lamp's 5 nm table does not teach its 1 nm table. A spectrum that is in no
//! fold is fitted with the components of all.

use std::sync::Arc;

use crate::{rivals::PrincipalBasis, spectrum::Band};

/// Folds that the training set is dealt into.
pub const FOLDS: usize = 5;

/// Spectra whose normalised inner product exceeds this are the same but for scale.
const SAME: f64 = 0.9995;

/// Bases for every spectrum, each trained without it.
#[derive(Clone, Debug)]
pub struct Training {
    band: Band,
    members: Vec<Member>,
    /// One basis a fold, trained on the other folds.
    without: Vec<Arc<PrincipalBasis>>,
    all: Arc<PrincipalBasis>,
}

#[derive(Clone, Debug)]
struct Member {
    name: String,
    unit: Vec<f64>,
    fold: usize,
}

impl Training {
    /// Deals named spectra (values on the band's grid) into folds and trains up to `most`
    /// components for each; all-zero spectra are left out.
    pub fn new(band: Band, spectra: &[(String, Vec<f64>)], most: usize) -> Self {
        let mut members: Vec<Member> = Vec::new();
        let mut next_fold = 0;
        for (name, values) in spectra {
            let Some(unit) = normalised(band, values) else {
                continue;
            };
            let fold = fold_of(band, &members, name, &unit).unwrap_or_else(|| {
                next_fold = (next_fold + 1) % FOLDS;
                next_fold
            });
            members.push(Member {
                name: name.clone(),
                unit,
                fold,
            });
        }
        let trained = |leave: Option<usize>| {
            let taught: Vec<Vec<f64>> = members
                .iter()
                .filter(|m| Some(m.fold) != leave)
                .map(|m| m.unit.clone())
                .collect();
            Arc::new(PrincipalBasis::train(band, &taught, most))
        };
        Self {
            band,
            without: (0..FOLDS).map(|fold| trained(Some(fold))).collect(),
            all: trained(None),
            members,
        }
    }

    /// Spectra that teach.
    pub fn spectra(&self) -> usize {
        self.members.len()
    }

    /// The components for a spectrum, trained without it and its likes.
    pub fn basis_for(&self, name: &str, values: &[f64]) -> &Arc<PrincipalBasis> {
        normalised(self.band, values)
            .and_then(|unit| fold_of(self.band, &self.members, name, &unit))
            .map_or(&self.all, |fold| &self.without[fold])
    }
}

/// The fold of the spectrum of that name or, failing that, of one like it.
fn fold_of(band: Band, members: &[Member], name: &str, unit: &[f64]) -> Option<usize> {
    let named = members.iter().find(|m| m.name.eq_ignore_ascii_case(name));
    let alike = || {
        members
            .iter()
            .find(|m| band.inner(&m.unit, unit).abs() > SAME)
    };
    named.or_else(alike).map(|m| m.fold)
}

fn normalised(band: Band, values: &[f64]) -> Option<Vec<f64>> {
    let scaled = super::judge::scaled_to_one(values)?;
    let norm = band.inner(&scaled, &scaled).sqrt();
    (norm > 0.0).then(|| scaled.iter().map(|v| v / norm).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    fn bells() -> Vec<(String, Vec<f64>)> {
        (0..20)
            .map(|i| {
                let at = 400.0 + 18.0 * f64::from(i);
                let values = BAND
                    .grid()
                    .map(|nm| (-((nm - at) / 25.0).powi(2)).exp())
                    .collect();
                (format!("bell {i}"), values)
            })
            .collect()
    }

    fn error(basis: &PrincipalBasis, values: &[f64]) -> f64 {
        let unit = normalised(BAND, values).expect("it shines");
        let caught: f64 = basis
            .rows()
            .iter()
            .map(|row| BAND.inner(row, &unit).powi(2))
            .sum();
        1.0 - caught
    }

    #[test]
    fn no_spectrum_teaches_itself_its_double_or_its_namesake() {
        let mut spectra = bells();
        let training = Training::new(BAND, &spectra, 41);
        let (name, values) = spectra[7].clone();
        let basis = training.basis_for(&name, &values);
        assert!(error(basis, &values) > 1e-6, "it was left out");
        assert!(error(&training.all, &values) < 1e-9, "all have seen it");
        let double: Vec<f64> = values.iter().map(|v| 3.0 * v).collect();
        assert!(Arc::ptr_eq(basis, training.basis_for("a file", &double)));
        assert!(Arc::ptr_eq(
            basis,
            training.basis_for("Bell 7", &spectra[3].1)
        ));
        // The double joins the fold of the first.
        spectra.push(("double".to_owned(), double.clone()));
        let again = Training::new(BAND, &spectra, 41);
        assert_eq!(again.spectra(), 21);
        assert!(error(again.basis_for(&name, &values), &values) > 1e-6);
    }

    #[test]
    fn a_stranger_is_taught_by_all_and_darkness_by_nobody() {
        let training = Training::new(BAND, &bells(), 41);
        let ramp: Vec<f64> = BAND.grid().collect();
        assert!(Arc::ptr_eq(
            &training.all,
            training.basis_for("ramp", &ramp)
        ));
        let dark = vec![0.0; BAND.points()];
        assert!(Arc::ptr_eq(
            &training.all,
            training.basis_for("dark", &dark)
        ));
    }
}
