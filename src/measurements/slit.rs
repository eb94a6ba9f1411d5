//! A table seen through a slit, and on a coarser grid by area.
//!
//! Exact for a table that is straight lines between its samples: over each of them the kernel's
//! zeroth and first running integrals give the weights of its two ends. At the ends of the table
//! the kernel is cut and divided by the part inside.

use super::{
    error::MeasurementError,
    kernel::{Kernel, Slit},
    measurement::Measurement,
};
use crate::{languages::with_sign, spectrum::Sampled};

/// Resamples a measurement at some wavelengths by weighted sums.
fn weighed(
    of: &Measurement,
    nm: Vec<f64>,
    weights: impl Fn(f64) -> (usize, Vec<f64>),
) -> Result<Measurement, MeasurementError> {
    let own = of.samples.values();
    let mut values = Vec::with_capacity(nm.len());
    let mut sigma = of.sigma.as_ref().map(|_| Vec::with_capacity(nm.len()));
    let mut mask = Vec::with_capacity(nm.len());
    for at in &nm {
        let (first, weights) = weights(*at);
        let pairs = weights.iter().zip(&own[first..]);
        let is_kept = !weights.is_empty()
            && (0..weights.len()).all(|k| weights[k] == 0.0 || of.is_kept(first + k));
        values.push(if is_kept {
            pairs.map(|(w, v)| w * v).sum()
        } else {
            0.0
        });
        mask.push(!is_kept);
        if let (Some(sigma), Some(own)) = (&mut sigma, &of.sigma) {
            sigma.push(shared_noise(&weights, &own[first..], &of.memory));
        }
    }
    let samples = Sampled::new(nm, values)?;
    if !mask.contains(&true) {
        mask.clear();
    }
    Ok(Measurement {
        samples,
        sigma,
        mask,
        memory: Vec::new(),
        ..of.clone()
    })
}

/// Deviation of a weighted sum of samples whose noise has a memory.
fn shared_noise(weights: &[f64], sigma: &[f64], memory: &[f64]) -> f64 {
    let parts: Vec<f64> = weights.iter().zip(sigma).map(|(w, s)| w * s).collect();
    let at = |lag: usize| -> f64 {
        parts
            .iter()
            .zip(&parts[lag.min(parts.len())..])
            .map(|(a, b)| a * b)
            .sum()
    };
    let shared: f64 = (1..=memory.len())
        .map(|lag| 2.0 * memory[lag - 1] * at(lag))
        .sum();
    (at(0) + shared).max(0.0).sqrt()
}

/// Memory of noise that was averaged with the same weights at every place: the weights'
/// correlation with themselves, with the memory from before, as far as it exceeds a hundredth.
fn memory_behind(weights: &[f64], memory: &[f64]) -> Vec<f64> {
    let before = |lag: usize| {
        if lag == 0 {
            1.0
        } else {
            memory.get(lag - 1).copied().unwrap_or(0.0)
        }
    };
    let shared = |lag: usize| -> f64 {
        let mut sum = 0.0;
        for (i, a) in weights.iter().enumerate() {
            for (j, b) in weights.iter().enumerate() {
                sum += a * b * before((j + lag).abs_diff(i));
            }
        }
        sum
    };
    let own = shared(0);
    let lags = 1..weights.len() + memory.len();
    lags.map(|lag| shared(lag) / own)
        .take_while(|rho| *rho > 0.01)
        .collect()
}

/// A measurement as an instrument with this slit would see it. Blur adds: what was seen through a
/// slit already is widened by what is missing.
///
/// # Errors
/// A sentence where the slit is no width, or narrower than the one it was seen through.
pub fn smoothed(of: &Measurement, slit: Slit) -> Result<Measurement, MeasurementError> {
    let have = of.slit.map_or(0.0, |slit| slit.fwhm_nm);
    if !slit.fwhm_nm.is_finite() || slit.fwhm_nm <= 0.0 {
        return Err(MeasurementError::Meaningless(tr!(
            "found a slit of {width} nm, expected a width above 0",
            width = with_sign(slit.fwhm_nm.to_string())
        )));
    }
    if have >= slit.fwhm_nm {
        return Err(MeasurementError::Meaningless(tr!(
            "This light was seen through {have} nm: it cannot be shown as a {wanted} nm \
             instrument would see it.",
            have = with_sign(have.to_string()),
            wanted = with_sign(slit.fwhm_nm.to_string())
        )));
    }
    let missing = Slit {
        fwhm_nm: (slit.fwhm_nm.powi(2) - have.powi(2)).sqrt(),
        ..slit
    };
    let nm = of.samples.nm().to_vec();
    let middle = nm[nm.len() / 2];
    let memory = match of.sigma {
        Some(_) => memory_behind(&missing.weights(&nm, middle).1, &of.memory),
        None => Vec::new(),
    };
    let found = weighed(of, nm.clone(), |at| missing.weights(&nm, at))?;
    Ok(Measurement {
        slit: Some(slit),
        memory,
        ..found
    })
}

/// A measurement on other wavelengths: by straight lines where its own samples are as coarse, by
/// the triangle whose FWHM is the new step, which keeps areas, where they are finer.
///
/// # Errors
/// A sentence where the new grid has fewer than two points inside the table.
pub fn resampled(
    of: &Measurement,
    target_nm: &[f64],
    own_step_nm: f64,
) -> Result<Measurement, MeasurementError> {
    let (first, last) = (of.samples.first_nm(), of.samples.last_nm());
    let inside = target_nm.iter().copied();
    let inside: Vec<f64> = inside.filter(|nm| (first..=last).contains(nm)).collect();
    if inside.len() < 2 {
        return Err(MeasurementError::Apart(tr!(
            "found {points} points of the grid within {first}-{last} nm, expected at least 2",
            points = inside.len(),
            first = with_sign(first.to_string()),
            last = with_sign(last.to_string())
        )));
    }
    let mut steps: Vec<f64> = inside.windows(2).map(|w| w[1] - w[0]).collect();
    steps.sort_by(f64::total_cmp);
    let step = steps[steps.len() / 2];
    let nm = of.samples.nm().to_vec();
    // The same step but for rounding is no coarser one.
    if step <= 1.01 * own_step_nm {
        return weighed(of, inside, |at| between(&nm, at));
    }
    let triangle = Slit {
        shape: Kernel::Triangle,
        fwhm_nm: step,
    };
    weighed(of, inside, |at| triangle.weights(&nm, at))
}

/// The weights of a straight line between two samples.
fn between(nm: &[f64], at_nm: f64) -> (usize, Vec<f64>) {
    let right = nm.partition_point(|nm| *nm < at_nm).clamp(1, nm.len() - 1);
    let share = (at_nm - nm[right - 1]) / (nm[right] - nm[right - 1]);
    (right - 1, vec![1.0 - share, share])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurements::Quantity;

    fn light(nm: Vec<f64>, values: Vec<f64>) -> Measurement {
        let samples = Sampled::new(nm, values).expect("rising");
        Measurement::new("light", Quantity::Light, "", samples)
    }

    /// Steps from .3 to 1.5 nm that follow no rule.
    fn uneven() -> Vec<f64> {
        let steps = (0..300).map(|i: u32| 0.3 + f64::from((i * i * 31 + i * 7) % 13) / 10.0);
        let sum = steps.scan(400.0, |at, step| {
            *at += step;
            Some(*at)
        });
        sum.collect()
    }

    #[test]
    fn a_ramp_stays_a_ramp_on_an_uneven_grid_and_a_line_keeps_its_place() {
        let nm = uneven();
        let ramp = light(nm.clone(), nm.iter().map(|nm| 2.0 * nm - 700.0).collect());
        let mut line = light(nm.clone(), vec![0.0; nm.len()]);
        let mut values = vec![0.0; nm.len()];
        values[150] = 1.0;
        line.samples = line.samples.sharing(values).expect("as many");
        for shape in [Kernel::Triangle, Kernel::Gauss] {
            let slit = Slit {
                shape,
                fwhm_nm: 5.0,
            };
            let seen = smoothed(&ramp, slit).expect("a width");
            for i in 60..240 {
                let off = seen.samples.values()[i] - ramp.samples.values()[i];
                assert!(off.abs() < 1e-9, "{shape:?} {off}");
            }
            assert_eq!(seen.slit, Some(slit));
            // Area and centroid by the straight lines between the samples, on a fine even grid.
            let fine: Vec<f64> = (0..8000).map(|i| nm[100] + f64::from(i) * 0.0125).collect();
            let moments = |of: &dyn Fn(f64) -> f64| {
                let area: f64 = fine.iter().map(|at| of(*at)).sum();
                let first: f64 = fine.iter().map(|at| at * of(*at)).sum();
                (area, first / area)
            };
            let before = line.samples.clone();
            let (area, place) = moments(&|at| before.at(at, crate::spectrum::Outside::Zero));
            let (seen_area, seen_place) = moments(&|at| {
                let (first, weights) = slit.weights(&nm, at);
                weights
                    .iter()
                    .zip(&before.values()[first..])
                    .map(|(w, v)| w * v)
                    .sum()
            });
            assert!((seen_area / area - 1.0).abs() < 1e-3, "{shape:?}");
            assert!(
                (seen_place - place).abs() < 1e-3,
                "{shape:?} {seen_place} {place}"
            );
        }
    }

    #[test]
    fn blur_adds_and_nothing_is_shown_narrower_than_it_was_seen() {
        let nm: Vec<f64> = (0..400).map(|i| 400.0 + 0.5 * f64::from(i)).collect();
        let mut values = vec![0.0; 400];
        values[200] = 1.0;
        let line = light(nm, values);
        let slit = |fwhm_nm| Slit {
            shape: Kernel::Gauss,
            fwhm_nm,
        };
        let once = smoothed(&line, slit(10.0)).expect("wider");
        let twice =
            smoothed(&smoothed(&line, slit(6.0)).expect("wider"), slit(10.0)).expect("wider");
        let top = once.samples.values()[200];
        for (a, b) in once.samples.values().iter().zip(twice.samples.values()) {
            // Half a nm between samples widens the first blur by its own triangle.
            assert!((a - b).abs() < 2e-3 * top, "{a} {b}");
        }
        let why = smoothed(&once, slit(5.0))
            .expect_err("narrower")
            .to_string();
        assert_eq!(
            why,
            "This light was seen through 10 nm: it cannot be shown as a 5 nm instrument would see it."
        );
        assert!(smoothed(&line, slit(0.0)).is_err());
    }

    #[test]
    fn a_coarser_grid_keeps_the_area_of_lines_that_stand_between_its_points() {
        let nm: Vec<f64> = (0..=400).map(|i| 380.0 + f64::from(i)).collect();
        let target: Vec<f64> = (0..=80).map(|i| 380.0 + 5.0 * f64::from(i)).collect();
        for at in 100..105 {
            let mut values = vec![0.0; nm.len()];
            values[at] = 1.0;
            let line = light(nm.clone(), values);
            let coarse = resampled(&line, &target, 1.0).expect("inside");
            let area: f64 = 5.0 * coarse.samples.values().iter().sum::<f64>();
            assert!((area - 1.0).abs() < 1e-12, "{at}: {area}");
        }
        // White noise of 1 in weights of a triangle on its own step.
        let mut noisy = light(nm.clone(), vec![1.0; nm.len()]);
        noisy.sigma = Some(vec![1.0; nm.len()]);
        let coarse = resampled(&noisy, &target, 1.0).expect("inside");
        let sigma = coarse.sigma.expect("it had one");
        let weights: Vec<f64> = (-4..=4)
            .map(|k: i32| (1.0 - f64::from(k.abs()) / 5.0) / 5.0)
            .collect();
        let expected = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
        // The straight lines between samples widen the weights by a hair.
        assert!(
            (sigma[40] / expected - 1.0).abs() < 0.05,
            "{} {expected}",
            sigma[40]
        );
    }
}
