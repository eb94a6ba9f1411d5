//! The representations that the composite model is raced against, at an equal count of numbers.
//!
//! ```text
//! samples    equally spaced points, straight lines between them
//! bins       averages over equal boxes
//! legendre   least-squares polynomial
//! principal  projection on the principal components of a training set (needs its table)
//! moments    trigonometric moments, maximum-entropy reconstruction
//! wavelet    the largest coefficients of a CDF 9/7 transform, place and value each
//! ```
//!
//! Each is fitted to values on the 1 nm grid of a [`Band`] and is asked the same few things:
//! `at` a wavelength, `on_band`, `integrate` with a weight, and its `points`, where a product of
//! two spectra is one multiplication a point.

mod bins;
mod bounded_moments;
#[cfg(test)]
mod example_spectra;
mod fit_tables;
mod legendre;
mod levinson;
mod moments;
mod phases;
mod principal;
mod samples;
mod wavelet;

pub(crate) use bins::Bins;
pub(crate) use fit_tables::FitTables;
pub use legendre::Legendre;
pub(crate) use moments::Moments;
pub(crate) use principal::{Principal, PrincipalBasis};
pub(crate) use samples::Samples;
pub(crate) use wavelet::Wavelet;

use std::{fmt::Debug, ops::Deref};

use crate::spectrum::{Band, Kind};

/// A family of representations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum Family {
    /// Equally spaced samples, straight lines between them.
    Samples,
    /// Averages over equal boxes.
    Bins,
    /// Least-squares polynomial.
    Legendre,
    /// Projection on the principal components of a training set.
    Principal,
    /// Trigonometric moments, read by maximum entropy.
    Moments,
    /// The largest wavelet coefficients.
    Wavelet,
}

impl Family {
    /// Every family, in the order in which tables list them.
    pub(crate) const ALL: [Self; 6] = [
        Self::Samples,
        Self::Bins,
        Self::Legendre,
        Self::Principal,
        Self::Moments,
        Self::Wavelet,
    ];

    /// Its names and meaning.
    pub(crate) fn about(self) -> About {
        match self {
            Self::Samples => About {
                word: "samples",
                title: later!("Point samples, linear"),
                short: later!("Samples"),
                in_a_sentence: later!("point samples"),
                meaning: later!("Equally spaced values with straight lines between them."),
            },
            Self::Bins => About {
                word: "bins",
                title: later!("Box bins"),
                short: later!("Bins"),
                in_a_sentence: later!("box bins"),
                meaning: later!("Averages over equal boxes."),
            },
            Self::Legendre => About {
                word: "legendre",
                title: later!("Legendre polynomial"),
                short: later!("Legendre"),
                in_a_sentence: later!("the Legendre polynomial"),
                meaning: later!("A polynomial, least squares."),
            },
            Self::Principal => About {
                word: "principal",
                title: later!("Principal components"),
                short: later!("Principal"),
                in_a_sentence: later!("principal components"),
                meaning: later!(
                    "Components of the shipped lights, trained without the light at hand and \
                          its likes. Its tables are not counted among its numbers."
                ),
            },
            Self::Moments => About {
                word: "moments",
                title: later!("Maximum-entropy moments"),
                short: later!("Moments"),
                in_a_sentence: later!("maximum-entropy moments"),
                meaning: later!(
                    "Trigonometric moments, read by maximum entropy; never negative. \
                          Reflectances are bounded by 1."
                ),
            },
            Self::Wavelet => About {
                word: "wavelet",
                title: later!("Wavelet, largest coefficients"),
                short: later!("Wavelet"),
                in_a_sentence: later!("wavelets"),
                meaning: later!(
                    "The largest coefficients of a CDF 9/7 transform; each costs two numbers, \
                          place and value."
                ),
            },
        }
    }

    /// True if a fit with fewer numbers is a prefix of one with more (the paper's criterion 5,
    /// flexibility: one fit, truncated at will).
    pub(crate) fn is_prefix(self) -> bool {
        match self {
            Self::Samples | Self::Bins => false,
            Self::Legendre | Self::Principal | Self::Moments | Self::Wavelet => true,
        }
    }

    /// True if the numbers are meaningless without a table that is not counted among them.
    pub(crate) fn needs_table(self) -> bool {
        self == Self::Principal
    }
}

/// The names of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct About {
    /// The word used in files.
    pub word: &'static str,
    /// The name that people read.
    pub title: &'static str,
    /// The same in a few letters.
    pub short: &'static str,
    /// The same in the middle of a sentence.
    pub in_a_sentence: &'static str,
    /// Description in a sentence or two.
    pub meaning: &'static str,
}

/// Bounds on the values of a spectrum; used only by the moments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Bounds {
    /// Bounded by 0 only.
    Light,
    /// Bounded by 0 and 1: a reflectance or a transmittance.
    Reflectance,
}

impl From<Kind> for Bounds {
    fn from(kind: Kind) -> Self {
        if kind.is_factor() {
            Self::Reflectance
        } else {
            Self::Light
        }
    }
}

/// The few verbs that every representation has.
pub(crate) trait Representation: Debug {
    /// The band that was fitted.
    fn band(&self) -> Band;

    /// The stored numbers, in order (wavelet: place, value, place, value, ...); values are in the
    /// spectrum's own unit.
    fn stored(&self) -> Vec<f64>;

    /// Multiplies what is stored by a positive factor, where it has a scale.
    fn scale(&mut self, factor: f64);

    /// Value at a wavelength inside the band.
    fn inside(&self, at_nm: f64) -> f64;

    /// Values on the band's 1 nm grid.
    ///
    /// They are those at the grid points, except for bins, which give the average over the nm
    /// around each grid point so that no energy is lost on the grid.
    fn on_band(&self) -> Vec<f64>;

    /// Memory taken by the numbers: 8 bytes each, but 2 for a wavelet's place.
    ///
    /// Not counted are the band, tables shared by all fits (principal components), and what is
    /// only worked out from the numbers once (the polynomial of the moments).
    fn bytes(&self) -> usize {
        self.stored().len() * size_of::<f64>()
    }

    /// Wavelengths of [`Representation::points`], nm, rising; the 1 nm grid by default.
    fn places_nm(&self) -> Vec<f64> {
        self.band().grid().collect()
    }

    /// Values where a product of two spectra is formed, from the stored numbers; those on the 1 nm
    /// grid unless said otherwise.
    ///
    /// Samples and bins multiply themselves, polynomial and moments on the midpoints of twice as
    /// many intervals as they have numbers, principal components and wavelets on the 1 nm grid.
    fn points(&self) -> Vec<f64> {
        self.on_band()
    }
}

/// One fitted representation.
#[derive(Debug)]
pub(crate) struct Rival(Box<dyn Representation>);

impl Rival {
    /// Count of its numbers; two for each wavelet coefficient kept.
    pub(crate) fn numbers(&self) -> usize {
        self.stored().len()
    }

    /// Value at a wavelength; zero outside the band.
    pub(crate) fn at(&self, at_nm: f64) -> f64 {
        if self.band().contains(at_nm) {
            self.inside(at_nm)
        } else {
            0.0
        }
    }
}

impl Deref for Rival {
    type Target = dyn Representation;

    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

/// Middles of `count` equal intervals of a band, nm.
fn midpoints_nm(band: Band, count: usize) -> Vec<f64> {
    let step_nm = band.length_nm() / count as f64;
    (0..count)
        .map(|i| band.min_nm() + (i as f64 + 0.5) * step_nm)
        .collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use example_spectra::{fluorescent, leaf, thermal};

    /// A basis of a few thermal and line spectra, enough rows for the counts used here.
    fn trained(band: Band) -> Arc<PrincipalBasis> {
        let spectra: Vec<Vec<f64>> = (0..40)
            .map(|i| {
                let line = fluorescent(band).into_iter().enumerate();
                line.map(|(k, v)| v + (0.003 * f64::from(i) * k as f64).sin())
                    .collect()
            })
            .collect();
        Arc::new(PrincipalBasis::train(band, &spectra, 31))
    }

    fn every_rival(
        band: Band,
        values: &[f64],
        numbers: usize,
        bounds: Bounds,
    ) -> Vec<(Family, Rival)> {
        let (tables, basis) = (FitTables::new(band, numbers), trained(band));
        Family::ALL
            .into_iter()
            .map(|family| (family, tables.fit(family, values, numbers, bounds, &basis)))
            .collect()
    }

    #[test]
    fn no_family_is_left_out_of_the_list_of_all() {
        let (_, source) = include_str!("mod.rs")
            .split_once("pub enum Family {")
            .expect("the families");
        let (variants, _) = source.split_once('}').expect("an end");
        let lines = variants.lines().map(str::trim);
        let variants = lines.filter(|line| !line.starts_with("//") && line.ends_with(','));
        let named: Vec<String> = variants.map(|line| line.replace(',', "")).collect();
        assert_eq!(named, Family::ALL.map(|family| format!("{family:?}")));
    }

    #[test]
    fn every_family_has_names_of_its_own_and_its_place() {
        for (place, family) in Family::ALL.into_iter().enumerate() {
            assert_eq!(family as usize, place);
            let names = |f: Family| {
                let about = f.about();
                [
                    about.word,
                    about.title,
                    about.short,
                    about.in_a_sentence,
                    about.meaning,
                ]
            };
            for other in Family::ALL.into_iter().filter(|other| *other != family) {
                let pairs = names(family).into_iter().zip(names(other));
                assert!(
                    pairs.into_iter().all(|(a, b)| a != b),
                    "{family:?}, {other:?}"
                );
            }
        }
    }

    #[test]
    fn what_is_fitted_says_which_band_it_is_on() {
        let values = thermal(Band::PAPER, 5000.0);
        for (family, rival) in every_rival(Band::PAPER, &values, 11, Bounds::Light) {
            assert_eq!(rival.band(), Band::PAPER, "{family:?}");
        }
    }

    #[test]
    fn a_fit_takes_the_numbers_it_was_given() {
        let values = fluorescent(Band::VISIBLE);
        for (family, rival) in every_rival(Band::VISIBLE, &values, 11, Bounds::Light) {
            let (numbers, bytes) = match family {
                Family::Wavelet => (10, 50),
                _ => (11, 88),
            };
            assert_eq!((rival.numbers(), rival.bytes()), (numbers, bytes));
        }
    }

    #[test]
    fn a_count_that_cannot_be_had_is_brought_to_the_nearest_that_can() {
        let values = fluorescent(Band::VISIBLE);
        for (family, rival) in every_rival(Band::VISIBLE, &values, 0, Bounds::Light) {
            let least = 1 + usize::from(family == Family::Wavelet);
            assert_eq!(rival.numbers(), least);
        }
        for (_, rival) in every_rival(Band::VISIBLE, &values, 5000, Bounds::Light) {
            assert!(rival.numbers() <= 2 * Band::VISIBLE.points());
        }
    }

    #[test]
    fn fewer_numbers_are_a_prefix_of_more_exactly_where_a_family_says_so() {
        let band = Band::VISIBLE;
        let (tables, basis) = (FitTables::new(band, 31), trained(band));
        let values = fluorescent(band);
        for family in Family::ALL {
            let fit = |numbers| tables.fit(family, &values, numbers, Bounds::Light, &basis);
            let most = fit(31).stored();
            let prefix = (2..31).all(|numbers| {
                let fewer = fit(numbers).stored();
                most[..fewer.len()] == fewer
            });
            assert_eq!(prefix, family.is_prefix(), "{}", family.about().word);
        }
    }

    #[test]
    fn a_family_needs_a_table_exactly_when_another_table_changes_what_is_stored() {
        let band = Band::VISIBLE;
        let tables = FitTables::new(band, 11);
        let other = Arc::new(PrincipalBasis::train(band, &[leaf(band)], 11));
        let values = fluorescent(band);
        for family in Family::ALL {
            let stored = |basis| {
                let rival = tables.fit(family, &values, 11, Bounds::Light, basis);
                rival.stored()
            };
            let differs = stored(&trained(band)) != stored(&other);
            assert_eq!(differs, family.needs_table(), "{}", family.about().word);
        }
    }

    #[test]
    fn a_light_k_times_as_strong_has_a_fit_k_times_as_strong() {
        let band = Band::VISIBLE;
        let values = fluorescent(band);
        let stronger: Vec<f64> = values.iter().map(|v| 370.0 * v).collect();
        let top = values.iter().fold(0.0_f64, |m, v| m.max(*v));
        let once = every_rival(band, &values, 20, Bounds::Light);
        let often = every_rival(band, &stronger, 20, Bounds::Light);
        for ((_, once), (_, often)) in once.iter().zip(&often) {
            for (a, b) in once.on_band().iter().zip(often.on_band()) {
                // Rounding; the moments' recursion makes some thousand roundings of one.
                assert!((370.0 * a - b).abs() < 1e-10 * 370.0 * top);
            }
        }
    }

    #[test]
    fn a_value_at_a_grid_point_is_the_value_on_the_grid() {
        let band = Band::VISIBLE;
        let light = every_rival(band, &fluorescent(band), 20, Bounds::Light);
        let leaf = every_rival(band, &leaf(band), 20, Bounds::Reflectance);
        // Bins give cell averages on the grid, which differ where a box begins.
        let pointwise = |(family, _): &&(Family, Rival)| *family != Family::Bins;
        for (family, rival) in light.iter().chain(&leaf).filter(pointwise) {
            let on_band = rival.on_band();
            let top = on_band.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for (nm, v) in band.grid().zip(&on_band) {
                // Two orders of summation, some hundred roundings of the polynomials' terms.
                let difference = (rival.at(nm) - v).abs();
                assert!(difference < 1e-10 * top, "{family:?} {nm}");
            }
        }
    }

    #[test]
    fn there_is_nothing_outside_the_band() {
        for (_, rival) in every_rival(Band::VISIBLE, &[1.0; 401], 11, Bounds::Light) {
            assert_eq!(rival.at(379.9), 0.0);
            assert_eq!(rival.at(780.1), 0.0);
            assert_eq!(rival.at(f64::NAN), 0.0);
        }
    }

    #[test]
    fn points_are_values_at_their_places() {
        let band = Band::VISIBLE;
        for (family, rival) in every_rival(band, &leaf(band), 20, Bounds::Reflectance) {
            let (points, places) = (rival.points(), rival.places_nm());
            assert_eq!(points.len(), places.len());
            let expected = match family {
                Family::Samples | Family::Bins => 20,
                Family::Legendre | Family::Moments => 40,
                Family::Principal | Family::Wavelet => 401,
            };
            assert_eq!(points.len(), expected);
            for (v, nm) in points.iter().zip(places) {
                // As between `at` and the grid above.
                assert!((v - rival.at(nm)).abs() < 1e-10);
            }
        }
    }

    #[test]
    fn nothing_finite_makes_a_number_that_is_not_finite() {
        let band = Band::new(400.0, 421.0).unwrap();
        let (tables, basis) = (FitTables::new(band, 40), trained(band));
        let patterns: [fn(usize) -> f64; 5] = [
            |_| 1.0,
            |_| -1.0,
            |i| f64::from(u8::from(i == 7)),
            |i| (i % 2) as f64,
            |i| if i < 11 { -1.0 } else { 1.0 },
        ];
        for (pattern, height) in patterns
            .iter()
            .flat_map(|p| [0.0, 5e-324, 1e-300, 0.3, 1.0, 1e300].map(|h| (p, h)))
        {
            let values: Vec<f64> = (0..band.points()).map(|i| height * pattern(i)).collect();
            for family in Family::ALL {
                for bounds in [Bounds::Light, Bounds::Reflectance] {
                    for numbers in [0, 1, 2, 3, 8, 21, 22, 44, 1000] {
                        let rival = tables.fit(family, &values, numbers, bounds, &basis);
                        let finite = |values: Vec<f64>| values.iter().all(|v| v.is_finite());
                        let all = finite(rival.stored())
                            && finite(rival.on_band())
                            && finite(rival.points())
                            && rival.at(410.3).is_finite();
                        assert!(all, "{family:?} {bounds:?} {numbers} {height} {values:?}");
                    }
                }
            }
        }
    }
}
