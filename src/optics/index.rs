//! Refractive index over wavelength.
//!
//! Every index is relative to the air around and every wavelength is that in air, as lines of
//! lamps are tabulated. With `l` the wavelength in micrometres a material is
//!
//! ```text
//! Sellmeier    n^2 = 1 + sum B l^2 / (l^2 - C)
//! absolute     the same with the wavelength in vacuum, against vacuum: n(l) = n_abs(l n_air) / n_air
//! Cauchy       n = A + B / l^2, from two numbers n_d and V_d
//! a table      n at wavelengths, a monotone cubic between them
//! ```
//!
//! A formula goes on outside the range it was published for ([`Material::is_extrapolated`]) as long
//! as the wavelength is 5 % above the nearest ultraviolet resonance and n^2 > 1.

use std::fmt;

use crate::spectrum::Sampled;

use super::lines::{
    LINE_B_NM, LINE_C_NM, LINE_C_PRIME_NM, LINE_D_NM, LINE_E_NM, LINE_F_NM, LINE_F_PRIME_NM,
    LINE_G_NM,
};
use super::monotone::Monotone;

/// One term of a Sellmeier formula: strength B and squared resonance C, um^2.
pub type Term = [f64; 2];

/// A wavelength must exceed the nearest ultraviolet resonance by this factor.
const ABOVE_RESONANCE: f64 = 1.05;

/// Squared resonances below this are ultraviolet, above infrared (um^2); no transparent solid
/// or liquid has one near 1 um.
const ULTRAVIOLET_UM2: f64 = 1.0;

/// Half the step of a numerical derivative, nm.
const HALF_STEP_NM: f64 = 0.01;

/// What n is computed from.
#[derive(Clone, Debug, PartialEq)]
enum Dispersion {
    Sellmeier(Vec<Term>),
    Absolute(Vec<Term>),
    Cauchy { a: f64, b: f64 },
    Table { curve: Monotone, absolute: bool },
}

/// A transparent material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// What people call it.
    pub name: String,
    /// Where its numbers come from.
    pub source: String,
    /// Wavelengths that the numbers were published for, nm; `None` for two numbers by hand.
    pub published_nm: Option<[f64; 2]>,
    dispersion: Dispersion,
}

/// Why there is no index.
#[derive(Clone, Debug, PartialEq)]
pub enum IndexError {
    /// A wavelength that is not a positive number.
    NotAWavelength { found_nm: f64 },
    /// Too near to a resonance in the ultraviolet or beyond one in the infrared.
    Resonance {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// The formula gives an index that no transparent body has.
    NotTransparent { material: String, found_nm: f64 },
    /// A table knows nothing there.
    OutsideTable {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// An n_d of two numbers that is no denser than air.
    TooThin { found: f64 },
    /// A V_d of two numbers that is not positive.
    BadAbbe { found: f64 },
    /// A table whose values are no indices.
    BadTable { found: f64, at_nm: f64 },
}

impl fmt::Display for IndexError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAWavelength { found_nm } => {
                write!(f, "expected a wavelength above 0 nm, found {found_nm} nm")
            }
            Self::Resonance {
                material,
                found_nm,
                from_nm,
                to_nm,
            } => write!(
                f,
                "{material}: expected a wavelength between its resonances, {from_nm:.1} to \
                 {to_nm:.0} nm, found {found_nm} nm"
            ),
            Self::NotTransparent { material, found_nm } => write!(
                f,
                "{material}: expected an index above 1, found none at {found_nm} nm"
            ),
            Self::OutsideTable {
                material,
                found_nm,
                from_nm,
                to_nm,
            } => write!(
                f,
                "{material}: expected a wavelength in its table, {from_nm} to {to_nm} nm, found \
                 {found_nm} nm"
            ),
            Self::TooThin { found } => {
                write!(f, "n_d: expected a number from 1.0001 to 10, found {found}")
            }
            Self::BadAbbe { found } => write!(f, "V_d: expected a number above 0, found {found}"),
            Self::BadTable { found, at_nm } => write!(
                f,
                "expected indices of refraction above 0, found {found} at {at_nm} nm"
            ),
        }
    }
}

impl std::error::Error for IndexError {}

/// Figures by which glass makers and the gem trade name a dispersion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AbbeFigures {
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
    pub fn sellmeier(name: &str, source: &str, published_nm: [f64; 2], terms: &[Term]) -> Self {
        Self {
            name: name.to_owned(),
            source: source.to_owned(),
            published_nm: Some(published_nm),
            dispersion: Dispersion::Sellmeier(terms.to_vec()),
        }
    }

    /// A material by terms of a Sellmeier formula against vacuum.
    pub fn absolute(name: &str, source: &str, published_nm: [f64; 2], terms: &[Term]) -> Self {
        Self {
            name: name.to_owned(),
            source: source.to_owned(),
            published_nm: Some(published_nm),
            dispersion: Dispersion::Absolute(terms.to_vec()),
        }
    }

    /// A material by two numbers: Cauchy's formula through n_d and V_d.
    ///
    /// # Errors
    /// When n_d is below 1.0001 or above 10, or V_d is not positive.
    pub fn from_two_numbers(n_d: f64, v_d: f64) -> Result<Self, IndexError> {
        if !(1.0001..=10.0).contains(&n_d) {
            return Err(IndexError::TooThin { found: n_d });
        }
        if !(v_d > 0.0 && v_d.is_finite()) {
            return Err(IndexError::BadAbbe { found: v_d });
        }
        let over_square = |nm: f64| 1e6 / (nm * nm);
        let b = (n_d - 1.0) / v_d / (over_square(LINE_F_NM) - over_square(LINE_C_NM));
        Ok(Self {
            name: format!("n_d {n_d}, V_d {v_d}"),
            source: "two numbers, Cauchy's formula through both".to_owned(),
            published_nm: None,
            dispersion: Dispersion::Cauchy {
                a: n_d - b * over_square(LINE_D_NM),
                b,
            },
        })
    }

    /// A material by a table of n, such as a file of refractiveindex.info holds. `absolute` says
    /// that n and wavelengths are against vacuum.
    ///
    /// # Errors
    /// When a value is no index.
    pub fn from_table(
        name: &str,
        source: &str,
        n: &Sampled,
        absolute: bool,
    ) -> Result<Self, IndexError> {
        let bad = n.values().iter().position(|v| !(*v > 0.0 && *v < 100.0));
        if let Some(index) = bad {
            return Err(IndexError::BadTable {
                found: n.values()[index],
                at_nm: n.nm()[index],
            });
        }
        Ok(Self {
            name: name.to_owned(),
            source: source.to_owned(),
            published_nm: Some([n.first_nm(), n.last_nm()]),
            dispersion: Dispersion::Table {
                curve: Monotone::new(n.nm(), n.values()),
                absolute,
            },
        })
    }

    /// Index of refraction relative to air at a wavelength in air, nm.
    ///
    /// # Errors
    /// [`IndexError`] where the material is not known or not transparent.
    pub fn index(&self, at_nm: f64) -> Result<f64, IndexError> {
        if !(at_nm > 0.0 && at_nm.is_finite()) {
            return Err(IndexError::NotAWavelength { found_nm: at_nm });
        }
        let n = match &self.dispersion {
            Dispersion::Sellmeier(terms) => self.by_terms(terms, at_nm, 1.0)?,
            Dispersion::Absolute(terms) => {
                let air = n_air(at_nm);
                self.by_terms(terms, at_nm, air)? / air
            }
            Dispersion::Cauchy { a, b } => a + b * 1e6 / (at_nm * at_nm),
            Dispersion::Table { curve, absolute } => {
                let air = if *absolute { n_air(at_nm) } else { 1.0 };
                let n = curve.at(at_nm * air).map(|n| n / air);
                let [from_nm, to_nm] = curve.ends();
                n.ok_or_else(|| IndexError::OutsideTable {
                    material: self.name.clone(),
                    found_nm: at_nm,
                    from_nm,
                    to_nm,
                })?
            }
        };
        if n > 1.0 && n.is_finite() {
            Ok(n)
        } else {
            Err(IndexError::NotTransparent {
                material: self.name.clone(),
                found_nm: at_nm,
            })
        }
    }

    /// The formula at a wavelength that is `air` times as long in what the terms count in.
    fn by_terms(&self, terms: &[Term], at_nm: f64, air: f64) -> Result<f64, IndexError> {
        let um = at_nm * air / 1000.0;
        let square = um * um;
        let (from, to) = resonances(terms);
        if square <= from || square >= to {
            return Err(IndexError::Resonance {
                material: self.name.clone(),
                found_nm: at_nm,
                from_nm: 1000.0 * from.sqrt(),
                to_nm: 1000.0 * to.sqrt(),
            });
        }
        let sum: f64 = terms.iter().map(|[b, c]| b * square / (square - c)).sum();
        // Below zero there is no index: NaN, which the caller refuses.
        Ok((1.0 + sum).sqrt())
    }

    /// Change of the index with wavelength, 1/nm: analytic for a Sellmeier and Cauchy formula, a
    /// central difference of .01 nm otherwise.
    ///
    /// # Errors
    /// As [`Material::index`].
    pub fn d_index_d_nm(&self, at_nm: f64) -> Result<f64, IndexError> {
        let n = self.index(at_nm)?;
        match &self.dispersion {
            Dispersion::Sellmeier(terms) => {
                let um = at_nm / 1000.0;
                let term = |[b, c]: &Term| {
                    let off = um * um - c;
                    -b * um * c / (off * off)
                };
                Ok(terms.iter().map(term).sum::<f64>() / n / 1000.0)
            }
            Dispersion::Cauchy { b, .. } => Ok(-2.0 * b * 1e6 / (at_nm * at_nm * at_nm)),
            Dispersion::Absolute(_) | Dispersion::Table { .. } => {
                // One-sided at the end of a table.
                let low = at_nm - HALF_STEP_NM;
                let high = at_nm + HALF_STEP_NM;
                let (low, n_low) = self.index(low).map_or((at_nm, n), |n| (low, n));
                let (high, n_high) = self.index(high).map_or((at_nm, n), |n| (high, n));
                if high > low {
                    Ok((n_high - n_low) / (high - low))
                } else {
                    Ok(0.0)
                }
            }
        }
    }

    /// Whether an index there rests on a formula outside the wavelengths it was published for.
    pub fn is_extrapolated(&self, at_nm: f64) -> bool {
        self.published_nm
            .is_none_or(|[from, to]| !(from..=to).contains(&at_nm))
    }

    /// The figures of the trade; `None` where the material is not known at their lines.
    pub fn abbe(&self) -> Option<AbbeFigures> {
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

/// Between which squared wavelengths (um^2) a formula holds: 5 % above its ultraviolet resonances,
/// below its infrared ones.
fn resonances(terms: &[Term]) -> (f64, f64) {
    let mut held = (0.0_f64, f64::INFINITY);
    for [_, c] in terms {
        if *c < ULTRAVIOLET_UM2 {
            held.0 = held.0.max(c * ABOVE_RESONANCE * ABOVE_RESONANCE);
        } else {
            held.1 = held.1.min(*c);
        }
    }
    held
}

/// Index of standard air (15 C, 101325 Pa, 450 ppm CO2) at a wavelength, nm.
///
/// Source: Ciddor, Applied Optics 35 (1996) 1566-1573, Eq. 1.
pub fn n_air(at_nm: f64) -> f64 {
    let over = 1000.0 / at_nm;
    let s = over * over;
    1.0 + 0.057_921_05 / (238.018_5 - s) + 0.001_679_17 / (57.362 - s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::Stuff;

    #[test]
    fn the_analytic_slope_is_the_slope() {
        for stuff in Stuff::ALL {
            let material = stuff.material();
            for at_nm in [400.0, 587.5618, 760.0] {
                let n = |nm: f64| material.index(nm).unwrap();
                let slope = (n(at_nm + 0.05) - n(at_nm - 0.05)) / 0.1;
                let found = material.d_index_d_nm(at_nm).unwrap();
                // The central difference of .1 nm is off by its third derivative, about 1e-10 of
                // 1e-4, and rounding of 1e-15 over 0.1.
                assert!((found / slope - 1.0).abs() < 1e-6, "{stuff:?} {at_nm}");
            }
        }
    }

    #[test]
    fn two_numbers_come_back() {
        let glass = Material::from_two_numbers(1.62, 36.3).unwrap();
        let figures = glass.abbe().unwrap();
        assert!((figures.n_d - 1.62).abs() < 1e-14);
        assert!((figures.v_d - 36.3).abs() < 1e-10);
        assert!(
            glass.is_extrapolated(500.0),
            "two numbers are no measurement"
        );
    }

    #[test]
    fn two_numbers_that_are_no_glass_are_refused_in_words() {
        let said = |n: f64, v: f64| Material::from_two_numbers(n, v).unwrap_err().to_string();
        assert_eq!(
            said(1.0, 50.0),
            "n_d: expected a number from 1.0001 to 10, found 1"
        );
        assert_eq!(
            said(f64::NAN, 50.0),
            "n_d: expected a number from 1.0001 to 10, found NaN"
        );
        assert_eq!(said(1.5, 0.0), "V_d: expected a number above 0, found 0");
        assert_eq!(said(1.5, -3.0), "V_d: expected a number above 0, found -3");
    }

    #[test]
    fn a_formula_ends_at_its_resonances() {
        let zirconia = Stuff::Zirconia.material();
        assert!(zirconia.index(361.0).is_ok() && !zirconia.is_extrapolated(361.0));
        // Its resonance is at 166.739 nm; 5 % above is 175.08.
        assert!(zirconia.index(175.2).is_ok() && zirconia.is_extrapolated(175.2));
        assert!(zirconia.index(175.0).is_err());
        let silica = Stuff::Silica.material();
        // Beyond the infrared resonance the formula would give an index again.
        assert!(silica.index(12_000.0).is_err());
        for nothing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(silica.index(nothing).is_err());
            assert!(silica.d_index_d_nm(nothing).is_err());
        }
    }

    #[test]
    fn a_table_gives_the_formula_it_was_made_of() {
        let diamond = Stuff::Diamond.material();
        let nm: Vec<f64> = (380..=780).map(f64::from).collect();
        let n: Vec<f64> = nm.iter().map(|nm| diamond.index(*nm).unwrap()).collect();
        let table = Sampled::new(nm, n).unwrap();
        let tabled = Material::from_table("t", "", &table, false).unwrap();
        for at_nm in [380.0, 404.656, 546.074, 779.9] {
            let exact = diamond.index(at_nm).unwrap();
            // Between whole nm the third derivative of n, 4e-8 a nm^3, is left.
            assert!((tabled.index(at_nm).unwrap() - exact).abs() < 1e-7);
        }
        let slope = tabled.d_index_d_nm(600.0).unwrap();
        assert!((slope / diamond.d_index_d_nm(600.0).unwrap() - 1.0).abs() < 1e-3);
        assert_eq!(
            tabled.index(800.0).unwrap_err().to_string(),
            "t: expected a wavelength in its table, 380 to 780 nm, found 800 nm"
        );
        let not = Sampled::new(vec![1.0, 2.0], vec![1.5, -1.0]).unwrap();
        assert!(Material::from_table("t", "", &not, false).is_err());
    }

    #[test]
    fn an_absolute_table_is_turned_to_air() {
        // Water against vacuum by its own formula, as a file would hold it.
        let water = Stuff::Water.material();
        let Dispersion::Absolute(terms) = &water.dispersion else {
            panic!("water is given against vacuum");
        };
        let nm: Vec<f64> = (380..=800).map(f64::from).collect();
        let n: Vec<f64> = nm
            .iter()
            .map(|nm| water.by_terms(terms, *nm, 1.0).unwrap())
            .collect();
        let table = Sampled::new(nm, n).unwrap();
        let tabled = Material::from_table("water", "", &table, true).unwrap();
        let (a, b) = (
            tabled.index(589.294).unwrap(),
            water.index(589.294).unwrap(),
        );
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
}
