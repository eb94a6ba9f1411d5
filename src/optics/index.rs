//! Refractive index over wavelength.
//!
//! Every index is relative to the air around and every wavelength is that in air, as lines of
//! lamps are tabulated. With `l` the wavelength in micrometres a material is
//!
//! ```text
//! Sellmeier    n^2 = 1 + sum B l^2 / (l^2 - C)
//! absolute     the same with the wavelength in vacuum, against vacuum: n(l) = n_abs(l n_air) / n_air
//! Cauchy       n = A + B / l^2, from two numbers n_d and V_d
//! a formula    any of refractiveindex.info's nine, as its file has it
//! a table      n at wavelengths, a monotone cubic between them
//! ```
//!
//! The formula of a material of the program goes on outside the range it was published for
//! ([`Material::is_extrapolated`]) as long as the wavelength is 5 % above the nearest ultraviolet
//! resonance and n^2 > 1; that of a file ends with its range.
//!
//! Wavelengths where n is 1 or less, or k above `MOST_EXTINCTION`, have no index: rays end in
//! metals and dyes, and angles behind them are no longer Snell's.

use crate::spectrum::{Formula, Outside, Sampled, index_of_air, slope_of_air};

use super::index_error::{IndexError, MOST_EXTINCTION};
use super::light::{Light, SEEN_NM};
use super::lines::{
    LINE_B_NM, LINE_C_NM, LINE_C_PRIME_NM, LINE_D_NM, LINE_E_NM, LINE_F_NM, LINE_F_PRIME_NM,
    LINE_G_NM,
};
use super::monotone::Monotone;

/// One term of a Sellmeier formula: strength B and squared resonance C, um^2.
pub(crate) type Term = [f64; 2];

/// A wavelength must exceed the nearest ultraviolet resonance by this factor.
const ABOVE_RESONANCE: f64 = 1.05;

/// Squared resonances below this are ultraviolet, above infrared (um^2); no transparent solid
/// or liquid has one near 1 um.
const ULTRAVIOLET_UM2: f64 = 1.0;

/// Model that n is computed from.
#[derive(Clone, Debug, PartialEq)]
enum Dispersion {
    Formula {
        formula: Formula,
        /// True if n and wavelengths are relative to vacuum.
        absolute: bool,
        /// True if it ends with the range for which it was published.
        ends: bool,
    },
    Table {
        curve: Monotone,
        absolute: bool,
    },
}

/// A transparent material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its common name.
    pub name: String,
    /// Source of its numbers.
    pub source: String,
    /// Wavelengths that the numbers were published for, nm; `None` for two numbers by hand.
    pub published_nm: Option<[f64; 2]>,
    dispersion: Dispersion,
    /// Extinction coefficient k; none where nobody measured it.
    extinction: Option<Sampled>,
}

/// Figures by which glass makers and the gem trade name a dispersion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AbbeFigures {
    /// Index at the yellow helium line d.
    pub n_d: f64,
    /// (n_d - 1) / (n_F - n_C).
    pub v_d: f64,
    /// (n_e - 1) / (n_F' - n_C').
    pub v_e: f64,
    /// "Fire": n at 430.8 nm (G) less n at 686.7 nm (B).
    pub fire: f64,
}

impl Material {
    /// A material by terms of a Sellmeier formula whose n is relative to air.
    pub(crate) fn sellmeier(
        name: &str,
        source: &str,
        published_nm: [f64; 2],
        terms: &[Term],
    ) -> Self {
        Self::of_terms(name, source, published_nm, terms, false)
    }

    /// A material by terms of a Sellmeier formula against vacuum.
    pub fn absolute(name: &str, source: &str, published_nm: [f64; 2], terms: &[Term]) -> Self {
        Self::of_terms(name, source, published_nm, terms, true)
    }

    fn of_terms(
        name: &str,
        source: &str,
        published_nm: [f64; 2],
        terms: &[Term],
        absolute: bool,
    ) -> Self {
        let coefficients = std::iter::once(0.0).chain(terms.iter().flatten().copied());
        let formula = Formula::new(2, coefficients.collect(), published_nm);
        let dispersion = Dispersion::Formula {
            formula: formula.expect("finite terms and a range that rises"),
            absolute,
            ends: false,
        };
        Self::of(name, source, Some(published_nm), dispersion)
    }

    fn of(
        name: &str,
        source: &str,
        published_nm: Option<[f64; 2]>,
        dispersion: Dispersion,
    ) -> Self {
        Self {
            name: name.to_owned(),
            source: source.to_owned(),
            published_nm,
            dispersion,
            extinction: None,
        }
    }

    /// A material by the formula of a file, which ends with its range.
    pub(crate) fn from_formula(name: &str, source: &str, formula: Formula) -> Self {
        let range_nm = Some(formula.range_nm());
        let dispersion = Dispersion::Formula {
            formula,
            absolute: false,
            ends: true,
        };
        Self::of(name, source, range_nm, dispersion)
    }

    /// A material by two numbers: Cauchy's formula through n_d and V_d.
    ///
    /// # Errors
    /// When n_d is below 1.0001 or above 10, or V_d is not positive.
    pub(crate) fn from_two_numbers(n_d: f64, v_d: f64) -> Result<Self, IndexError> {
        if !(1.0001..=10.0).contains(&n_d) {
            return Err(IndexError::TooThin { found: n_d });
        }
        if !(v_d > 0.0 && v_d.is_finite()) {
            return Err(IndexError::BadAbbe { found: v_d });
        }
        let over_square = |nm: f64| 1e6 / (nm * nm);
        let b = (n_d - 1.0) / v_d / (over_square(LINE_F_NM) - over_square(LINE_C_NM));
        let a = n_d - b * over_square(LINE_D_NM);
        let cauchy = Formula::new(5, vec![a, b, -2.0], [LINE_F_NM, LINE_C_NM]);
        let dispersion = Dispersion::Formula {
            formula: cauchy.ok_or(IndexError::BadAbbe { found: v_d })?,
            absolute: false,
            ends: false,
        };
        let source = later!("two numbers, Cauchy's formula through both");
        let name = format!("n_d {n_d}, V_d {v_d}");
        Ok(Self::of(&name, source, None, dispersion))
    }

    /// A material by a table of n, such as a file of refractiveindex.info holds. `absolute` says
    /// that n and wavelengths are against vacuum.
    ///
    /// # Errors
    /// When a value is no index.
    pub(crate) fn from_table(
        name: &str,
        source: &str,
        n: &Sampled,
        absolute: bool,
    ) -> Result<Self, IndexError> {
        let mut rows = n.nm().iter().zip(n.values());
        if let Some((at_nm, found)) = rows.find(|(_, v)| !(**v > 0.0 && **v < 100.0)) {
            let (found, at_nm) = (*found, *at_nm);
            return Err(IndexError::BadTable { found, at_nm });
        }
        let curve = Monotone::new(n.nm(), n.values());
        let range_nm = Some([n.first_nm(), n.last_nm()]);
        let dispersion = Dispersion::Table { curve, absolute };
        Ok(Self::of(name, source, range_nm, dispersion))
    }

    /// The same material with an extinction coefficient: where it is above `MOST_EXTINCTION`
    /// there is no index. Beyond its table nobody knows, and nothing is refused.
    #[must_use]
    pub(crate) fn with_extinction(self, k: Sampled) -> Self {
        Self {
            extinction: Some(k),
            ..self
        }
    }

    /// Index of refraction relative to air at a wavelength in air, nm.
    ///
    /// # Errors
    /// [`IndexError`] where the material is not known or not transparent.
    pub fn index(&self, at_nm: f64) -> Result<f64, IndexError> {
        self.index_and_slope(at_nm).map(|[n, _]| n)
    }

    /// Change of the index with wavelength, 1/nm, by the formula's derivative or that of the curve
    /// through a table.
    ///
    /// # Errors
    /// As [`Material::index`].
    pub(crate) fn d_index_d_nm(&self, at_nm: f64) -> Result<f64, IndexError> {
        self.index_and_slope(at_nm).map(|[_, slope]| slope)
    }

    /// The first wavelength at which a light has power and the material is not transparent; what
    /// lies outside its table is passed over.
    pub(crate) fn not_transparent_for(&self, light: &Light) -> Option<IndexError> {
        let mut errors = light.lit_nm().filter_map(|nm| self.index(nm).err());
        errors.find(IndexError::is_opaque)
    }

    fn index_and_slope(&self, at_nm: f64) -> Result<[f64; 2], IndexError> {
        if !(at_nm > 0.0 && at_nm.is_finite()) {
            return Err(IndexError::NotAWavelength { found_nm: at_nm });
        }
        let [n, slope] = match &self.dispersion {
            Dispersion::Formula {
                formula,
                absolute,
                ends,
            } => {
                self.holds(formula, *ends, at_nm, *absolute)?;
                in_medium(at_nm, *absolute, |nm| {
                    let [n, slope] = formula.index_and_slope(nm / 1000.0);
                    Some([n, slope / 1000.0])
                })
            }
            Dispersion::Table { curve, absolute } => {
                in_medium(at_nm, *absolute, |nm| curve.value_and_slope(nm))
            }
        }
        .ok_or_else(|| self.outside_table(at_nm))?;
        let k = self
            .extinction
            .as_ref()
            .map_or(0.0, |k| k.at(at_nm, Outside::Zero));
        if n > 1.0 && n.is_finite() && k <= MOST_EXTINCTION {
            Ok([n, slope])
        } else {
            Err(IndexError::NotTransparent {
                material: self.name.clone(),
                found_nm: at_nm,
                n,
                k,
            })
        }
    }

    /// Nothing is known there.
    fn outside_table(&self, found_nm: f64) -> IndexError {
        let [from_nm, to_nm] = self.published_nm.unwrap_or(SEEN_NM);
        IndexError::OutsideTable {
            material: self.name.clone(),
            found_nm,
            from_nm,
            to_nm,
        }
    }

    /// Refuses a wavelength at which a formula does not hold.
    fn holds(
        &self,
        formula: &Formula,
        ends: bool,
        at_nm: f64,
        absolute: bool,
    ) -> Result<(), IndexError> {
        let [from, to] = formula.range_nm();
        if ends {
            let known = (from..=to).contains(&at_nm);
            return known.then_some(()).ok_or_else(|| self.outside_table(at_nm));
        }
        let air = if absolute { index_of_air(at_nm) } else { 1.0 };
        let um = 1e-3 * at_nm * air;
        let (from, to) = resonances(&formula.resonances_um2());
        if um * um > from && um * um < to {
            return Ok(());
        }
        Err(IndexError::Resonance {
            material: self.name.clone(),
            found_nm: at_nm,
            from_nm: 1000.0 * from.sqrt(),
            to_nm: 1000.0 * to.sqrt(),
        })
    }

    /// True if an index there rests on a formula outside the wavelengths it was published for.
    pub(crate) fn is_extrapolated(&self, at_nm: f64) -> bool {
        self.published_nm
            .is_none_or(|[from, to]| !(from..=to).contains(&at_nm))
    }

    /// The figures of the trade; `None` where the material is not known at their lines.
    pub(crate) fn abbe(&self) -> Option<AbbeFigures> {
        let n = |nm: f64| self.index(nm).ok();
        let n_d = n(LINE_D_NM)?;
        let figures = AbbeFigures {
            n_d,
            v_d: (n_d - 1.0) / (n(LINE_F_NM)? - n(LINE_C_NM)?),
            v_e: (n(LINE_E_NM)? - 1.0) / (n(LINE_F_PRIME_NM)? - n(LINE_C_PRIME_NM)?),
            fire: n(LINE_G_NM)? - n(LINE_B_NM)?,
        };
        (figures.v_d.is_finite() && figures.v_e.is_finite()).then_some(figures)
    }
}

/// An index and its slope (1/nm) in air, of what is tabulated in air or against vacuum: then n is
/// `n_abs(l a) / a` with l the wavelength and a the index of air, both as the light has them in air.
/// (The index of air belongs to the wavelength in vacuum; the two differ by 1e-8 of n at most.)
fn in_medium(
    at_nm: f64,
    absolute: bool,
    index_and_slope: impl Fn(f64) -> Option<[f64; 2]>,
) -> Option<[f64; 2]> {
    if !absolute {
        return index_and_slope(at_nm);
    }
    let (air, d_air) = (index_of_air(at_nm), slope_of_air(at_nm));
    let [n, slope] = index_and_slope(at_nm * air)?;
    let by_air = air + at_nm * d_air;
    Some([n / air, (slope * by_air - n / air * d_air) / air])
}

/// Between which squared wavelengths (um^2) a formula holds: 5 % above its ultraviolet resonances,
/// below its infrared ones.
fn resonances(squared: &[f64]) -> (f64, f64) {
    let mut held = (0.0_f64, f64::INFINITY);
    for c in squared {
        if *c < ULTRAVIOLET_UM2 {
            held.0 = held.0.max(c * ABOVE_RESONANCE * ABOVE_RESONANCE);
        } else {
            held.1 = held.1.min(*c);
        }
    }
    held
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::BuiltinMaterial;

    #[test]
    fn an_absolute_table_is_turned_to_air() {
        // Water against vacuum by its own formula, as a file would hold it.
        let water = BuiltinMaterial::Water.material();
        let Dispersion::Formula { formula, .. } = &water.dispersion else {
            panic!("water is given by a formula");
        };
        let nm: Vec<f64> = (380..=800).map(f64::from).collect();
        let n: Vec<f64> = nm.iter().map(|nm| formula.index(nm / 1000.0)).collect();
        let table = Sampled::new(nm, n).unwrap();
        let tabled = Material::from_table("water", "", &table, true).unwrap();
        let (a, b) = (
            tabled.index(589.294).unwrap(),
            water.index(589.294).unwrap(),
        );
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }

    #[test]
    fn metals_and_dyes_have_no_index_where_they_let_no_light_through() {
        // Gold by Johnson and Christy 1972, three of its rows.
        let nm = vec![450.9, 548.6, 652.6];
        let table = Sampled::new(nm.clone(), vec![1.38, 0.43, 0.17]).unwrap();
        let k = Sampled::new(nm, vec![1.914, 2.455, 3.15]).unwrap();
        let gold = Material::from_table("gold", "", &table, false).unwrap();
        let light = Light::of_line(548.6).unwrap();
        // Without k it is told by n alone, where that is 1 or less.
        assert!(gold.index(450.9).is_ok() && gold.index(548.6).is_err());
        let gold = gold.with_extinction(k);
        assert!(gold.index(450.9).is_err());
        assert_eq!(
            gold.not_transparent_for(&light).unwrap().to_string(),
            "gold: expected a transparent material (n above 1, k at most 0.0001), found n 0.4300, \
             k 2.4550 at 548.6 nm"
        );
        // A glass that is opaque below 400 nm alone takes light of other wavelengths.
        let nm = vec![380.0, 400.0, 780.0];
        let table = Sampled::new(nm.clone(), vec![1.8, 1.7, 1.6]).unwrap();
        let k = Sampled::new(nm, vec![0.01, 1e-6, 1e-6]).unwrap();
        let glass = Material::from_table("glass", "", &table, false).unwrap();
        let glass = glass.with_extinction(k);
        assert_eq!(glass.not_transparent_for(&light), None);
        assert!(
            glass
                .not_transparent_for(&Light::of_line(385.0).unwrap())
                .is_some()
        );
    }

    #[test]
    fn the_formula_of_a_file_keeps_its_digits_and_ends_with_its_range() {
        let coefficients = vec![
            0.0,
            1.039_612_12,
            0.006_000_698_67,
            0.231_792_344,
            0.020_017_914_4,
            1.010_469_45,
            103.560_653,
        ];
        let formula = Formula::new(2, coefficients, [300.0, 2500.0]).unwrap();
        let glass = Material::from_formula("n-bk7", "", formula);
        // By mpmath with 50 digits, at .5876 um, the slope a nm.
        let (n, slope) = (1.516_798_437_905_008_7, -4.179_195_425_607_8e-5);
        assert!((glass.index(587.6).unwrap() - n).abs() < 1e-14);
        let group = |n: f64, slope: f64| n - 587.6 * slope;
        let found = group(
            glass.index(587.6).unwrap(),
            glass.d_index_d_nm(587.6).unwrap(),
        );
        assert!((found - group(n, slope)).abs() < 1e-13, "{found}");
        let (figures, own) = (
            glass.abbe().unwrap(),
            BuiltinMaterial::NBk7.material().abbe().unwrap(),
        );
        assert!((figures.v_d - own.v_d).abs() < 1e-9 && (figures.v_e - own.v_e).abs() < 1e-9);
        assert!(glass.index(299.0).is_err() && glass.index(2501.0).is_err());
    }
}
