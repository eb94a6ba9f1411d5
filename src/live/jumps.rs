//! Moments at which a stream jumps, and the band that its noise leaves of a quantity over time.
//!
//! Compared is what two sets of scans are compared by: each line's share of the power, that of the
//! glow and the glow's shape, tested together, and the level by itself.

use super::tracks::{Point, Track, Tracks};
use crate::measurements::OF_95;
use crate::measurements::{COSINES, Feature, Moment, Part, Shift, jumps, scatter};

/// Most groups of frames in which jumps are looked for.
const MOST_GROUPS: usize = 2048;

/// Less than this share of the brightest is dark.
const DARK: f64 = 1e-3;

/// A moment at which the light jumped.
#[derive(Clone, Debug, PartialEq)]
pub struct Jump {
    pub time_ms: f64,
    /// What jumped, the surest first, the level at the end.
    pub parts: Vec<Part>,
}

/// A quantity over time with its noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Times, ms, and the means of the frames from each on.
    pub points: Vec<[f64; 2]>,
    /// Half width of the band that holds each mean 95 times of 100.
    pub half: f64,
}

impl Tracks {
    /// The moments at which the light jumped, the oldest first.
    pub fn jumps(&self) -> Vec<Jump> {
        let all = self.means(MOST_GROUPS);
        let power: Vec<f64> = all.iter().map(|point| point.composite.power()).collect();
        let most = power.iter().copied().fold(0.0, f64::max);
        if most <= 0.0 {
            return Vec::new();
        }
        let features = self.features(&all, &power, DARK * most);
        let series: Vec<Vec<f64>> = features.iter().map(|(_, series)| series.clone()).collect();
        let level = power.iter().map(|power| power.max(DARK * most).ln());
        let parts = |Moment { at, shifts }: Moment| {
            let parts = shifts.iter().map(|shift| part(&features, at, shift));
            (at, parts.collect())
        };
        let mut found: Vec<(usize, Vec<Part>)> = jumps(&series).into_iter().map(parts).collect();
        for Moment { at, shifts } in jumps(&[level.collect()]) {
            let level = shifts.iter().map(|shift| Part {
                feature: Feature::Level,
                change: shift.change.exp_m1(),
                u: shift.u * shift.change.exp(),
                p: shift.p,
                is_different: true,
            });
            match found.iter_mut().find(|(own, _)| own.abs_diff(at) <= 1) {
                Some((_, parts)) => parts.extend(level),
                None => found.push((at, level.collect())),
            }
        }
        found.sort_by_key(|(at, _)| *at);
        let jump = |(at, parts): (usize, Vec<Part>)| Jump {
            time_ms: all[at].time_ms,
            parts,
        };
        found.into_iter().map(jump).collect()
    }

    /// What is compared, each over time; without value in the dark.
    fn features(&self, all: &[Point], power: &[f64], dark: f64) -> Vec<(Feature, Vec<f64>)> {
        let of = |value: &dyn Fn(&Point, f64) -> f64| -> Vec<f64> {
            let pairs = all.iter().zip(power);
            let each = pairs.map(|(point, power)| match *power > dark {
                true => value(point, *power),
                false => f64::NAN,
            });
            each.collect()
        };
        let weight = |point: &Point, line: usize| {
            let weight = point.weights.get(line).copied().flatten();
            weight.unwrap_or(f64::NAN)
        };
        let mut found = Vec::new();
        for (line, at_nm) in self.lines_nm().into_iter().enumerate() {
            let share = of(&|point, power| weight(point, line) / power);
            found.push((Feature::Line(at_nm), share));
        }
        if !found.is_empty() {
            let glow = of(&|point, power| point.composite.smooth().integral() / power);
            found.push((Feature::Glow, glow));
        }
        for k in 1..=COSINES {
            let shape = of(&|point, _| {
                let numbers = &point.composite.smooth().coefficients;
                0.5 * numbers[k] / numbers[0]
            });
            found.push((Feature::Shape(k), shape));
        }
        found
    }

    /// A quantity over time, each point the mean of some frames, in at most so many points a curve:
    /// the curves of lines in their order, else one. None where too few frames tell the noise.
    pub fn courses(&self, track: Track, most: usize) -> Vec<Option<Course>> {
        let all = self.means(most);
        let course = |value: &dyn Fn(&Point) -> Option<f64>| {
            let points = all.iter().filter_map(|p| Some([p.time_ms, value(p)?]));
            let points: Vec<[f64; 2]> = points.filter(|at| at[1].is_finite()).collect();
            let values: Vec<f64> = points.iter().map(|at| at[1]).collect();
            let half = OF_95 * scatter(&values)?;
            Some(Course { points, half })
        };
        match track {
            Track::Y => vec![course(&|point| Some(point.y))],
            Track::Cct => vec![course(&|point| point.cct)],
            Track::Glow => vec![course(&Point::glow)],
            Track::Lines => (0..self.lines_nm().len())
                .map(|line| course(&|point| point.weights.get(line).copied().flatten()))
                .collect(),
        }
    }
}

/// A jump of a feature in its unit: of a line or the glow a share of what it is about the moment, of
/// the glow's shape a share of the glow.
fn part(features: &[(Feature, Vec<f64>)], at: usize, shift: &Shift) -> Part {
    let (feature, series) = &features[shift.series];
    let unit = match feature {
        Feature::Shape(_) => 1.0,
        _ => 0.5 * (series[at - 1] + series[at]).abs(),
    };
    let unit = if unit > 0.0 { unit } else { 1.0 };
    Part {
        feature: *feature,
        change: shift.change / unit,
        u: shift.u / unit,
        p: shift.p,
        is_different: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{measurements::normal, spectrum::Sampled};

    /// Some frames of a lamp with mercury's green line on a glow, each of 1 % noise in level and a
    /// thousandth in each sample; `line` and `level` by the frame.
    fn tracks(count: usize, line: impl Fn(usize) -> f64, level: impl Fn(usize) -> f64) -> Tracks {
        let mut tracks = Tracks::default();
        let mut draws = normal(11);
        for frame in 0..count {
            let mut next = || draws.next().unwrap_or(0.0);
            let by = level(frame) * (1.0 + 0.01 * next());
            let value = |nm: i32| {
                let away = (f64::from(nm) - 546.1) / 1.5;
                let light = 0.3 + line(frame) * (-away * away).exp();
                by * light + 1e-3 * next()
            };
            let values = (380..=780).map(value).collect();
            let light = Sampled::even(380.0, 1.0, values).expect("finite");
            tracks.push(1000.0 * frame as f64, &light);
        }
        tracks
    }

    #[test]
    fn a_line_that_jumps_is_told_with_its_moment_while_the_level_drifts() {
        let drift = |frame: usize| 1.0 + 0.002 * frame as f64;
        let still = tracks(200, |_| 1.0, drift);
        assert_eq!(still.jumps(), []);
        let found = tracks(200, |frame| if frame < 120 { 1.0 } else { 1.12 }, drift).jumps();
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].time_ms, 120_000.0);
        let line = found[0].parts.iter();
        let line = line
            .clone()
            .find(|part| matches!(part.feature, Feature::Line(_)));
        let line = line.expect("the line");
        // Its share rises from 2.17 to 2.42 % of the power, of their mean by 11 %.
        assert!((line.change - 0.11).abs() < 4.0 * line.u, "{line:?}");
        assert!(
            found[0]
                .parts
                .iter()
                .all(|part| part.feature != Feature::Level)
        );
    }

    #[test]
    fn a_light_that_is_dimmed_jumps_in_its_level_alone() {
        let found = tracks(200, |_| 1.0, |frame| if frame < 50 { 1.0 } else { 0.5 }).jumps();
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].time_ms, 50_000.0);
        let level = found[0].parts[0];
        assert_eq!((found[0].parts.len(), level.feature), (1, Feature::Level));
        assert!((level.change + 0.5).abs() < 4.0 * level.u, "{level:?}");
    }

    #[test]
    fn the_band_of_a_course_is_the_noise_of_its_points() {
        let tracks = tracks(400, |_| 1.0, |_| 1.0);
        for (most, frames) in [(400, 1.0), (100, 4.0_f64)] {
            let courses = tracks.courses(Track::Y, most);
            let course = courses[0].as_ref().expect("enough");
            assert_eq!(course.points.len(), most);
            let mean = course.points.iter().map(|at| at[1]).sum::<f64>() / most as f64;
            // 1 % of the level; of a hundred points the band is known to a tenth.
            let exact = 1.96 * 0.01 * mean / frames.sqrt();
            assert!(
                (course.half / exact - 1.0).abs() < 0.3,
                "{} {exact}",
                course.half
            );
        }
        assert_eq!(tracks.courses(Track::Lines, 20), [None]);
    }
}
