//! Principal components trained without the spectrum at hand.
//!
//! The training set is dealt into five folds; a spectrum is fitted with the components of the
//! other four. Tables of the same name, and tables that are all but proportional, are dealt into
//! one fold, so that a lamp's 5 nm table does not teach its 1 nm table. A spectrum that is in no
//! fold is fitted with the components of all.
//!
//! Components of smooth lights say nothing of line lamps, and those of all together suit nobody.
//! So every class has tables of its own beside the common ones, and a spectrum is fitted with
//! those that catch most of it: the rival at its best. Neither tables nor choice are counted.

use std::sync::Arc;

use crate::{rivals::PrincipalBasis, spectrum::Band};

/// Folds that the training set is dealt into.
pub(super) const FOLDS: usize = 5;

/// Spectra whose normalised inner product exceeds this are the same but for scale.
const SAME: f64 = 0.9995;

/// Bases for every spectrum, each trained without it.
#[derive(Clone, Debug)]
pub struct Training {
    band: Band,
    members: Vec<Member>,
    /// For every class, and for all together, the tables of that class.
    schools: Vec<School>,
}

/// Components learned from some of the spectra.
#[derive(Clone, Debug)]
struct School {
    /// One basis a fold, trained on the other folds.
    without: Vec<Arc<PrincipalBasis>>,
    all: Arc<PrincipalBasis>,
}

/// A light that races or teaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamp {
    /// Its name.
    pub name: String,
    /// The class it is counted in.
    pub class: String,
    /// Its values on the band's grid.
    pub values: Vec<f64>,
}

impl Lamp {
    /// True if any of its values is above zero: negative ones illuminate nothing.
    pub fn shines(&self) -> bool {
        self.values.iter().any(|value| *value > 0.0)
    }
}

#[derive(Clone, Debug)]
struct Member {
    name: String,
    class: String,
    unit: Vec<f64>,
    fold: usize,
}

impl Training {
    /// Deals spectra into folds and trains up to `most` components for each; all-zero spectra
    /// are left out.
    pub(crate) fn new(band: Band, spectra: &[Lamp], most: usize) -> Self {
        let mut members: Vec<Member> = Vec::new();
        let mut next_fold = 0;
        for Lamp {
            name,
            class,
            values,
        } in spectra
        {
            let Some(unit) = normalised(band, values) else {
                continue;
            };
            let fold = fold_of(band, &members, name, &unit).unwrap_or_else(|| {
                next_fold = (next_fold + 1) % FOLDS;
                next_fold
            });
            members.push(Member {
                name: name.clone(),
                class: class.clone(),
                unit,
                fold,
            });
        }
        let school = |class: Option<&str>| {
            let trained = |leave: Option<usize>| {
                let taught: Vec<Vec<f64>> = members
                    .iter()
                    .filter(|m| Some(m.fold) != leave && class.is_none_or(|c| c == m.class))
                    .map(|m| m.unit.clone())
                    .collect();
                Arc::new(PrincipalBasis::train(band, &taught, most))
            };
            School {
                without: (0..FOLDS).map(|fold| trained(Some(fold))).collect(),
                all: trained(None),
            }
        };
        let mut classes: Vec<&str> = members.iter().map(|m| m.class.as_str()).collect();
        classes.sort_unstable();
        classes.dedup();
        let mut schools = vec![school(None)];
        if classes.len() > 1 {
            schools.extend(classes.into_iter().map(|class| school(Some(class))));
        }
        Self {
            band,
            schools,
            members,
        }
    }

    /// The `numbers` components that catch most of a spectrum, trained without it and its likes.
    pub(crate) fn basis_for(
        &self,
        name: &str,
        values: &[f64],
        numbers: usize,
    ) -> &Arc<PrincipalBasis> {
        let Some(unit) = normalised(self.band, values) else {
            return &self.schools[0].all;
        };
        let fold = fold_of(self.band, &self.members, name, &unit);
        let tables = self
            .schools
            .iter()
            .map(|school| fold.map_or(&school.all, |fold| &school.without[fold]));
        let caught = |basis: &PrincipalBasis| -> f64 {
            let rows = basis.rows().iter().take(numbers);
            rows.map(|row| self.band.inner(row, &unit).powi(2)).sum()
        };
        tables
            .max_by(|a, b| caught(a).total_cmp(&caught(b)))
            .unwrap_or(&self.schools[0].all)
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
    let scaled = super::reference::scaled_to_one(values)?;
    let norm = band.inner(&scaled, &scaled).sqrt();
    (norm > 0.0).then(|| scaled.iter().map(|v| v / norm).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    fn bells() -> Vec<Lamp> {
        (0..20)
            .map(|i| {
                let at = 400.0 + 18.0 * f64::from(i);
                let values = BAND
                    .grid()
                    .map(|nm| (-((nm - at) / 25.0).powi(2)).exp())
                    .collect();
                Lamp {
                    name: format!("bell {i}"),
                    class: "bells".to_owned(),
                    values,
                }
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
        let Lamp {
            name,
            class,
            values,
        } = spectra[7].clone();
        let basis = training.basis_for(&name, &values, 41);
        assert!(error(basis, &values) > 1e-6, "it was left out");
        assert!(
            error(&training.schools[0].all, &values) < 1e-9,
            "all have seen it"
        );
        let double: Vec<f64> = values.iter().map(|v| 3.0 * v).collect();
        assert!(Arc::ptr_eq(
            basis,
            training.basis_for("a file", &double, 41)
        ));
        assert!(Arc::ptr_eq(
            basis,
            training.basis_for("Bell 7", &spectra[3].values, 41)
        ));
        // The double joins the fold of the first.
        spectra.push(Lamp {
            name: "double".to_owned(),
            class,
            values: double,
        });
        let again = Training::new(BAND, &spectra, 41);
        assert_eq!(again.members.len(), 21);
        assert!(error(again.basis_for(&name, &values, 41), &values) > 1e-6);
    }

    #[test]
    fn a_spectrum_is_taught_by_the_class_that_knows_it_best() {
        let mut spectra = bells();
        spectra.extend((0..20).map(|i| {
            Lamp {
                name: format!("wave {i}"),
                class: "waves".to_owned(),
                values: BAND
                    .grid()
                    .map(|nm| 1.0 + ((nm - 380.0) * f64::from(i) / 130.0).cos())
                    .collect(),
            }
        }));
        let training = Training::new(BAND, &spectra, 41);
        // Between two waves, so it lies in the span of all twenty.
        let pair = spectra[23].values.iter().zip(&spectra[26].values);
        let wave: Vec<f64> = pair.map(|(a, b)| a + b).collect();
        let chosen = training.basis_for("unheard of", &wave, 20);
        let waves = &training.schools[2].all;
        assert!(Arc::ptr_eq(chosen, waves));
    }

    #[test]
    fn a_stranger_is_taught_by_all_and_darkness_by_nobody() {
        let training = Training::new(BAND, &bells(), 41);
        let ramp: Vec<f64> = BAND.grid().collect();
        assert!(Arc::ptr_eq(
            &training.schools[0].all,
            training.basis_for("ramp", &ramp, 41)
        ));
        let dark = vec![0.0; BAND.points()];
        assert!(Arc::ptr_eq(
            &training.schools[0].all,
            training.basis_for("dark", &dark, 41)
        ));
    }
}
