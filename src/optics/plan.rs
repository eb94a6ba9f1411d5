//! The number of rays for each plane of a film.
//!
//! Rays are shared in proportion to c^.75, with c = |weight| (x + y + z) of a spike and three times
//! the integral of |S| (x + y + z) of the smooth part; strata likewise by theirs. Each spike gets
//! one ray at least, each stratum one in 64. With fewer rays than strata a pixel takes some of the
//! strata, by systematic sampling with an offset of its own, each as often as planned on average:
//! its contribution over the planned count is unbiased.

/// Exponent of a part's importance.
const EXPONENT: f64 = 0.75;

/// So many rays give each stratum one.
const RAYS_A_STRATUM: f64 = 64.0;

/// Least share of an even distribution that a stratum gets when there are fewer rays than strata:
/// another light may need it.
const LEAST_SHARE: f64 = 0.25;

/// Importance of the planes for a light.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Importance {
    /// Of each spike.
    pub(super) lines: Vec<f64>,
    /// Of each stratum.
    pub(super) strata: Vec<f64>,
}

/// Planned counts, rays a pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Plan {
    /// For each spike.
    pub(super) lines: Vec<f64>,
    /// For each stratum.
    pub(super) strata: Vec<f64>,
}

impl Plan {
    /// Shares rays out.
    pub(super) fn new(importance: &Importance, rays: u32) -> Self {
        let rays = f64::from(rays.max(1));
        let powers = |of: &[f64]| -> Vec<f64> { of.iter().map(|c| c.powf(EXPONENT)).collect() };
        let lines = powers(&importance.lines);
        let smooth: f64 = importance.strata.iter().sum();
        if smooth <= 0.0 {
            return Self {
                lines: counts(&lines, rays),
                strata: vec![0.0; importance.strata.len()],
            };
        }
        let strata_count = importance.strata.len() as f64;
        let all_lines: f64 = lines.iter().sum();
        let share = all_lines / (all_lines + (3.0 * smooth).powf(EXPONENT));
        let least_strata = (strata_count * (rays / RAYS_A_STRATUM).floor()).max(1.0);
        let most = (rays - least_strata).max(0.0);
        let wanted = (rays * share).round().max(lines.len() as f64);
        let has_lines = !lines.is_empty();
        let for_lines = if has_lines { wanted.min(most) } else { 0.0 };
        let mut strata = powers(&importance.strata);
        let least = LEAST_SHARE * strata.iter().sum::<f64>() / strata_count;
        strata.iter_mut().for_each(|c| *c = c.max(least));
        Self {
            lines: counts(&lines, for_lines),
            strata: counts(&strata, rays - for_lines),
        }
    }

    /// Rays a pixel in all, on average.
    #[cfg(test)]
    fn rays(&self) -> f64 {
        self.lines.iter().chain(&self.strata).sum()
    }
}

/// Rays shared among parts: whole numbers, at least one each, when there are enough, otherwise
/// numbers below 1 in proportion.
fn counts(parts: &[f64], rays: f64) -> Vec<f64> {
    let count = parts.len() as f64;
    // Parts without any importance share evenly.
    let sum: f64 = parts.iter().sum();
    let share = |c: f64| if sum > 0.0 { c / sum } else { 1.0 / count };
    if rays < count {
        return below_one(parts, rays, share);
    }
    // One each, and the rest by what is missing most.
    let wish = |c: f64| (rays * share(c)).max(1.0);
    let mut found: Vec<f64> = parts.iter().map(|c| wish(*c).floor()).collect();
    let mut left = rays - found.iter().sum::<f64>();
    while !(0.0..1.0).contains(&left) {
        let step = left.signum();
        // Those that have more than one give back where it is missed least.
        let may = |n: f64| step > 0.0 || n > 1.0;
        let want = |at: &usize| match may(found[*at]) {
            true => step * (rays * share(parts[*at]) - found[*at]),
            false => f64::MIN,
        };
        // The first of equals.
        let places = (0..parts.len()).rev();
        let Some(place) = places.max_by(|a, b| want(a).total_cmp(&want(b))) else {
            break;
        };
        found[place] += step;
        left -= step;
    }
    found
}

/// Numbers up to 1 in proportion to parts, with a sum.
fn below_one(parts: &[f64], rays: f64, share: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut scale = rays;
    let mut found = Vec::new();
    // What is cut at 1 goes to the others; a few rounds settle it.
    for _ in 0..32 {
        found = parts.iter().map(|c| (scale * share(*c)).min(1.0)).collect();
        let sum: f64 = found.iter().sum();
        if sum <= 0.0 || (sum / rays - 1.0).abs() < 1e-12 {
            break;
        }
        scale *= rays / sum;
    }
    // A part of no importance is met a little all the same.
    found
        .iter_mut()
        .for_each(|n: &mut f64| *n = n.max(1e-3 * rays / parts.len() as f64));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn importance(lines: &[f64], strata: usize) -> Importance {
        Importance {
            lines: lines.to_vec(),
            strata: vec![1.0; strata],
        }
    }

    #[test]
    fn each_spike_gets_a_ray_and_each_stratum_one_in_64() {
        let plan = Plan::new(&importance(&[50.0, 1e-3, 20.0], 40), 64);
        assert!(plan.lines.iter().all(|n| *n >= 1.0), "{plan:?}");
        assert!(plan.strata.iter().all(|n| *n == 1.0), "{plan:?}");
        assert_eq!(plan.rays(), 64.0);
        assert!(plan.lines[0] > plan.lines[2]);
    }

    #[test]
    fn with_few_rays_strata_are_met_in_part() {
        let plan = Plan::new(&importance(&[50.0, 1.0], 40), 12);
        assert!((plan.rays() - 12.0).abs() < 1e-6, "{plan:?}");
        assert!(plan.strata.iter().all(|n| *n > 0.0 && *n < 1.0));
        let one = Plan::new(&importance(&[50.0, 1.0], 40), 1);
        assert!((one.rays() - 1.0).abs() < 1e-2, "{one:?}");
    }

    #[test]
    fn a_light_of_one_part_gives_it_all() {
        let spikes = Importance {
            lines: vec![1.0, 2.0],
            strata: vec![0.0; 40],
        };
        let plan = Plan::new(&spikes, 10);
        assert_eq!((plan.lines.iter().sum::<f64>(), plan.rays()), (10.0, 10.0));
        let smooth = Plan::new(&importance(&[], 40), 100);
        assert_eq!((smooth.rays(), smooth.strata.len()), (100.0, 40));
        let many = Plan::new(&importance(&[1.0; 64], 40), 8);
        assert!((many.rays() - 8.0).abs() < 0.1, "{many:?}");
    }
}
