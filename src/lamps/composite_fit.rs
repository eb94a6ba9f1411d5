//! The verb of the model: a composite fitted to a measured spectrum.

use crate::{
    color::{Observer, xyz_of_lines, xyz_of_parts},
    spectrum::{
        Band, Basis, BasisTable, Composite, Exactness, InnerProducts, Line, Outside, Sampled,
        Series, SpikeSettings, detect, numbers_of_order,
    },
    study::error::{height, times},
};

use super::detector::decompose;

/// Options of a composite fit; the defaults are those the window starts with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    band: Band,
    basis: Basis,
    numbers: usize,
    lines: Option<SpikeSettings>,
    has_widths: bool,
    colour_of: Option<Observer>,
    outside: Outside,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            band: Band::VISIBLE,
            basis: Basis::Cosine,
            numbers: numbers_of_order(7),
            lines: Some(SpikeSettings::default()),
            has_widths: false,
            colour_of: Some(Observer::CIE_1931),
            outside: Outside::Zero,
        }
    }
}

impl FitOptions {
    /// For a reflectance or transmittance: no lines, no colour of its own to keep, and its end
    /// values beyond its table.
    pub fn of_a_factor() -> Self {
        Self {
            lines: None,
            colour_of: None,
            outside: Outside::Hold,
            ..Self::default()
        }
    }

    /// Fits on this band.
    pub fn on(self, band: Band) -> Self {
        Self { band, ..self }
    }

    /// Fits with these functions.
    pub fn basis(self, basis: Basis) -> Self {
        Self { basis, ..self }
    }

    /// Fits a series of this order N: 2N+1 coefficients, or as many as the grid carries.
    pub fn order(self, order: usize) -> Self {
        Self {
            numbers: numbers_of_order(order),
            ..self
        }
    }

    /// Takes lines out as these settings say; `None` takes out none.
    pub fn lines(self, lines: Option<SpikeSettings>) -> Self {
        Self { lines, ..self }
    }

    /// Gives each line the width that fits it best; else lines are ideal.
    pub fn with_widths(self) -> Self {
        Self {
            has_widths: true,
            ..self
        }
    }

    /// Keeps the colour that this observer sees exactly; `None` is plain least squares.
    pub fn colour_of(self, observer: Option<Observer>) -> Self {
        Self {
            colour_of: observer,
            ..self
        }
    }
}

/// A fitted composite and how well it fits.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The model.
    pub composite: Composite,
    /// Exactness of its colour against the spectrum's, or the reason for its lack; `None` where
    /// that was not asked for.
    pub exactness: Option<Exactness>,
    /// Model minus measured, one value each nm of the band, in the spectrum's unit; an ideal line
    /// is split over its two neighbouring nm.
    pub residual: Vec<f64>,
    /// Root of the mean squared residual over that of the spectrum; `None` for a dark one.
    pub rms: Option<f64>,
}

impl Composite {
    /// Fits a smooth series and lines to a measured spectrum, as the window does.
    ///
    /// ```
    /// use spectral_explorer::{
    ///     lamps::FitOptions,
    ///     preset,
    ///     spectrum::{Composite, Exactness},
    /// };
    ///
    /// let lamp = preset::table("cie_fluorescent_1nm", "FL2").expect("shipped");
    /// let fit = Composite::fit(lamp, &FitOptions::default().order(7));
    /// assert_eq!(fit.composite.numbers(), 15 + 2 * 4);
    /// assert!(matches!(fit.exactness, Some(Exactness::Exact { .. })));
    /// ```
    pub fn fit(measured: &Sampled, options: &FitOptions) -> Fit {
        let FitOptions {
            band,
            basis,
            numbers,
            lines,
            has_widths,
            colour_of,
            outside,
        } = *options;
        let values = measured.on_band(band, outside);
        let (target, lines) = match lines {
            None => (values.clone(), Vec::new()),
            Some(settings) if has_widths => {
                let parts = decompose(band, &values, settings);
                (parts.smooth, parts.spikes)
            }
            Some(settings) => {
                let parts = detect(band, &values, settings);
                let lines: Vec<Line> = parts.spikes.iter().map(|found| found.spike).collect();
                (parts.smooth, lines)
            }
        };
        let table = BasisTable::new(band, basis, numbers);
        let mut coefficients = table.project(&target, table.numbers());
        let exactness = colour_of.map(|observer| {
            let weights = observer.table().on_band(band);
            let whole = xyz_of_parts(band, &values, &[], &weights);
            let smooth = (whole - xyz_of_lines(&lines, &weights)).to_array();
            InnerProducts::new(&table, &weights).make_exact(&mut coefficients, smooth)
        });
        let smooth = Series {
            band,
            basis,
            coefficients,
        };
        let composite = Composite::of_lines_inside(smooth, lines);
        let modelled = composite.on_band();
        let residual: Vec<f64> = modelled.iter().zip(&values).map(|(m, v)| m - v).collect();
        Fit {
            rms: share_of(band, &residual, &values),
            composite,
            exactness,
            residual,
        }
    }
}

/// Root of the ratio of two summed squares, both as shares of the spectrum so that none overflows.
fn share_of(band: Band, residual: &[f64], values: &[f64]) -> Option<f64> {
    let unit = height(values)?;
    let [rest, whole] = [residual, values].map(|v| times(v, unit));
    let share = band.inner(&rest, &rest) / band.inner(&whole, &whole);
    Some(share.sqrt()).filter(|share| share.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(composite: &Composite) -> Sampled {
        Sampled::even(composite.band().min_nm(), 1.0, composite.on_band()).expect("finite")
    }

    #[test]
    fn a_smooth_composites_own_values_give_it_back() {
        for basis in Basis::ALL {
            let smooth = Series {
                band: Band::VISIBLE,
                basis,
                coefficients: vec![3.0, -0.4, 0.2, 0.1, -0.05],
            };
            let own = Composite::new(smooth, Vec::new()).expect("a composite");
            for colour_of in [None, Some(Observer::CIE_1931)] {
                let options = FitOptions::default().basis(basis).order(2);
                let fit = Composite::fit(&sampled(&own), &options.colour_of(colour_of));
                assert!(fit.composite.lines().is_empty());
                let pairs = fit.composite.smooth().coefficients.iter();
                for (found, own) in pairs.zip(&own.smooth().coefficients) {
                    // 401 products of numbers of size one, and a system of three equations.
                    assert!((found - own).abs() < 1e-11, "{basis:?} {found} {own}");
                }
                assert!(fit.rms.expect("light") < 1e-12);
            }
        }
    }

    #[test]
    fn lines_on_a_smooth_part_are_found_where_they_are() {
        let smooth = Series {
            band: Band::VISIBLE,
            basis: Basis::Cosine,
            coefficients: vec![2.0, -0.4, 0.2],
        };
        let lines = [(435.833, 40.0), (546.074, 60.0), (611.3, 30.0)];
        let lines = lines
            .map(|(at_nm, weight)| Line::ideal(at_nm, weight))
            .to_vec();
        let own = Composite::new(smooth, lines).expect("a composite");
        let fit = Composite::fit(&sampled(&own), &FitOptions::default().order(1));
        assert_eq!(fit.composite.lines().len(), 3);
        for (found, own) in fit.composite.lines().iter().zip(own.lines()) {
            // The hull's straight ground leaves out what the smooth part bends within 6 nm.
            assert!((found.at_nm - own.at_nm).abs() < 1e-3, "{found:?}");
            assert!((found.weight / own.weight - 1.0).abs() < 1e-3, "{found:?}");
        }
        let smooth = own.smooth().coefficients.iter();
        for (found, own) in fit.composite.smooth().coefficients.iter().zip(smooth) {
            assert!((found - own).abs() < 1e-3, "{found} {own}");
        }
    }
}
