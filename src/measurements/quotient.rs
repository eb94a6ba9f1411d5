//! Quotients near nothing: intervals that hold where straight propagation does not, and lines that
//! sample and reference share.

use super::statistics::OF_95;
use super::{guards::weight_of, measurement::Measurement, on_nm::OnWholeNm};
use crate::spectrum::{Band, FoundSpike, Outside, SpikeSettings, detect};

/// A line of the sample is that of the reference up to this distance, nm.
const SAME_NM: f64 = 1.5;

/// A quotient at a line that both have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePoint {
    /// Place in the reference, nm.
    pub at_nm: f64,
    /// Quotient of the weights.
    pub value: f64,
    /// Its standard uncertainty; of the place that of the reference's line, nm.
    pub u: f64,
}

/// The interval that holds `s / r` 95 times of 100, by Fieller: all `t` for which `s - t r` may be
/// nothing. Variances of s and r, and their covariance, by noise that both share; `None` where it
/// has no end.
pub fn fieller([s, r]: [f64; 2], [of_s, of_both, of_r]: [f64; 3]) -> Option<[f64; 2]> {
    let k = OF_95 * OF_95;
    let (a, b, c) = (r * r - k * of_r, s * r - k * of_both, s * s - k * of_s);
    let root = (b * b - a * c).max(0.0).sqrt();
    (a > 0.0).then(|| [(b - root) / a, (b + root) / a])
}

/// The quotient of the weights of every line that a sample and its reference share.
pub fn line_points(sample: &Measurement, reference: &Measurement) -> Vec<LinePoint> {
    let from = sample.samples.first_nm().max(reference.samples.first_nm());
    let to = sample.samples.last_nm().min(reference.samples.last_nm());
    let Ok(band) = Band::new(from.ceil(), to.floor()) else {
        return Vec::new();
    };
    let lines = |of: &Measurement| -> (OnWholeNm, Vec<FoundSpike>) {
        let on_nm = OnWholeNm::of(of, band.min_nm() as u32, band.max_nm() as u32);
        let values = of.samples.on_band(band, Outside::Hold);
        (
            on_nm,
            detect(band, &values, SpikeSettings::default()).spikes,
        )
    };
    let ((on_sample, own), (on_reference, others)) = (lines(sample), lines(reference));
    let point = |line: &FoundSpike| {
        let away = |s: &&FoundSpike| (s.spike.at_nm - line.spike.at_nm).abs();
        let near = own.iter().filter(|s| away(s) <= SAME_NM);
        let same = near.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        let share = |on_nm: &OnWholeNm, line: &FoundSpike| {
            weight_of(on_nm, line.spike.at_nm, line.width_nm).1 / line.spike.weight
        };
        let value = same.spike.weight / line.spike.weight;
        Some(LinePoint {
            at_nm: line.spike.at_nm,
            value,
            u: value * share(&on_sample, same).hypot(share(&on_reference, line)),
        })
    };
    others.iter().filter_map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurements::draws::normal;

    #[test]
    fn fiellers_interval_holds_the_quotient_where_the_reference_is_three_sigmas() {
        for (t, r) in [(0.05, 3.0), (0.5, 3.0), (0.95, 5.0), (0.5, 20.0)] {
            let mut draws = normal(7);
            let mut next = || draws.next().expect("endless");
            let (mut held, mut all) = (0, 0);
            for _ in 0..4000 {
                let found = [t * r + next(), r + next()];
                all += 1;
                held += i32::from(match fieller(found, [1.0, 0.0, 1.0]) {
                    Some([low, high]) => (low..=high).contains(&t),
                    // No end: the quotient may be anything.
                    None => true,
                });
            }
            let share = f64::from(held) / f64::from(all);
            // 4000 draws of .95: .0034 is one deviation.
            assert!((0.935..=0.985).contains(&share), "{t} {r}: {share}");
        }
        assert_eq!(fieller([1.0, 2.0], [1.0, 0.0, 4.0]), None);
    }
}
