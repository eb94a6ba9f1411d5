//! Golden profiles: generated ones whose axis is known, and ones of openly licensed photographs.

use serde::Deserialize;

use super::{
    super::{
        Profile,
        axis::{Answer, Curve, State, Wanted},
        landmarks::Lamp,
        peaks::bright,
    },
    axis_of, pins_by_hand,
};

const SYNTHETIC: &str = include_str!("../../../tests/golden/photographs/profiles.json");
const REAL: &str = include_str!("../../../tests/golden/photographs/real_profiles.json");

#[derive(Deserialize)]
struct File {
    profiles: Vec<Golden>,
}

#[derive(Deserialize)]
struct Golden {
    #[serde(alias = "name")]
    id: String,
    lamp: Option<String>,
    #[serde(default)]
    expect: String,
    #[serde(default)]
    mono: bool,
    r: Vec<f64>,
    g: Vec<f64>,
    b: Vec<f64>,
    sigma: [f64; 3],
    clipped: Vec<usize>,
    true_axis: Option<TrueAxis>,
    state: Option<String>,
    found: Option<Found>,
    #[serde(default)]
    peaks: Vec<[f64; 3]>,
    lines: Option<Vec<[f64; 2]>>,
}

#[derive(Deserialize)]
struct TrueAxis {
    c: [f64; 4],
}

#[derive(Deserialize)]
struct Found {
    axis_rms_nm: f64,
}

impl Golden {
    fn profile(&self) -> Profile {
        let mut clipped = vec![false; self.r.len()];
        self.clipped.iter().for_each(|i| clipped[*i] = true);
        Profile {
            channels: [self.r.clone(), self.g.clone(), self.b.clone()],
            sigma: self.sigma,
            clipped,
            is_grey: self.mono || self.r == self.g && self.g == self.b,
            black_seen: true,
            rows: 40,
        }
    }

    fn truth(&self) -> Curve {
        let axis = self.true_axis.as_ref().expect("a generated profile");
        Curve::new(self.r.len(), axis.c)
    }

    fn lamp(&self) -> Option<Lamp> {
        self.lamp.as_deref().and_then(Lamp::named)
    }
}

fn golden(file: &str) -> Vec<Golden> {
    let file: File = serde_json::from_str(file).expect("golden profiles");
    assert!(file.profiles.len() > 10);
    file.profiles
}

/// Root mean square and worst of an axis in 400-700 nm, within 15 nm of its lines; the worst also
/// within the lines alone.
fn off(answer: &Answer, truth: &Curve) -> (f64, f64) {
    let best = answer.best.as_ref().expect("an axis");
    let (low, high) = best.span_nm();
    let columns = (0..truth.scale_px as usize).map(|i| i as f64);
    let off = |from: f64, to: f64| -> Vec<f64> {
        let inside = columns
            .clone()
            .filter(|px| (from..=to).contains(&truth.nm(*px)));
        inside
            .map(|px| (best.curve.nm(px) - truth.nm(px)).abs())
            .collect()
    };
    let near = off((low - 15.0).max(400.0), (high + 15.0).min(700.0));
    let rms = (near.iter().map(|o| o * o).sum::<f64>() / near.len().max(1) as f64).sqrt();
    (rms, off(low, high).into_iter().fold(0.0, f64::max))
}

#[test]
fn peaks_stand_where_those_of_the_golden_profiles_do() {
    let mut compared = 0;
    for golden in golden(SYNTHETIC) {
        // Of daylight the file's places are of dark lines, whose surroundings are a matter of taste.
        if golden.lamp() == Some(Lamp::Daylight) {
            continue;
        }
        let peaks = bright(&golden.profile());
        for [px, _, fwhm] in &golden.peaks {
            let is_clipped =
                (golden.clipped.iter()).any(|c| (*c as f64 - px).abs() < 0.5 * fwhm + 1.0);
            if *fwhm <= 2.5 || is_clipped {
                continue;
            }
            let away = peaks.peaks.iter().map(|p| (p.px - px).abs());
            let away = away.fold(f64::MAX, f64::min);
            assert!(away < 0.15, "{} at {px}: off by {away:.2}", golden.id);
            compared += 1;
        }
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn axes_of_generated_lamps_are_found_and_none_that_is_found_is_wrong() {
    let (mut found, mut fluorescent, mut lamps) = (0, [0, 0], 0);
    for golden in golden(SYNTHETIC) {
        let (answer, _) = axis_of(&golden.profile(), &Wanted::default());
        let is_found = answer.state == State::Found;
        let Some(lamp) = golden.lamp() else {
            assert_eq!(answer.state, State::Nothing, "{}", golden.id);
            continue;
        };
        lamps += 1;
        found += usize::from(is_found);
        if lamp == Lamp::Fluorescent {
            fluorescent[0] += usize::from(is_found);
            fluorescent[1] += 1;
        }
        if is_found {
            let (rms, worst) = off(&answer, &golden.truth());
            let best = answer.best.as_ref().expect("an axis");
            assert_eq!(best.lamp, lamp, "{}", golden.id);
            assert!(
                rms < 1.0 && worst < 5.0,
                "{}: {rms:.2}, {worst:.1} nm",
                golden.id
            );
        }
        if let (Some("yes"), Some(study)) = (golden.state.as_deref(), &golden.found) {
            let (rms, _) = off(&answer, &golden.truth());
            let most = study.axis_rms_nm + 0.3;
            assert!(
                rms <= most,
                "{}: {rms:.2} nm, expected {most:.2}",
                golden.id
            );
        }
    }
    let share = |of: usize, all: usize| of as f64 / all as f64;
    assert!(share(found, lamps) >= 0.65, "{found} of {lamps}");
    assert!(
        share(fluorescent[0], fluorescent[1]) >= 0.9,
        "{fluorescent:?}"
    );
}

#[test]
fn lamps_that_are_named_and_pins_make_more_axes_right() {
    let [mut told, mut lamps, mut pinned, mut lamps_pinned] = [0; 4];
    for golden in golden(SYNTHETIC) {
        let (Some(lamp), profile, truth) = (golden.lamp(), golden.profile(), golden.truth()) else {
            continue;
        };
        lamps += 1;
        let mut wanted = Wanted {
            lamp: Some(lamp),
            ..Wanted::default()
        };
        let (answer, _) = axis_of(&profile, &wanted);
        if answer.state == State::Found {
            let (rms, worst) = off(&answer, &truth);
            told += usize::from(rms < 1.0);
            assert!(worst < 5.0, "{}: {worst:.1} nm", golden.id);
        }
        let Some(pins) = pins_by_hand(&profile, lamp, |px| truth.nm(px), || 0.0) else {
            continue;
        };
        lamps_pinned += 1;
        wanted.pins = pins;
        let (answer, _) = axis_of(&profile, &wanted);
        pinned += usize::from(answer.best.is_some() && off(&answer, &truth).0 < 1.0);
    }
    assert!(told as f64 >= 0.78 * lamps as f64, "{told} of {lamps}");
    assert!(
        lamps_pinned > 30 && pinned as f64 >= 0.92 * lamps_pinned as f64,
        "{pinned} of {lamps_pinned}"
    );
}

#[test]
fn axes_of_real_photographs_are_right_where_they_are_found() {
    let (mut found, mut compared) = (0, 0);
    for golden in golden(REAL) {
        let (answer, _) = axis_of(&golden.profile(), &Wanted::default());
        if answer.state != State::Found {
            continue;
        }
        found += 1;
        let best = answer.best.as_ref().expect("an axis");
        assert_eq!(best.lamp.name(), golden.expect, "{}", golden.id);
        for [px, nm] in golden.lines.iter().flatten() {
            compared += 1;
            let off = best.curve.nm(*px) - nm;
            assert!(off.abs() < 1.5, "{} at {nm}: {off:.2} nm", golden.id);
        }
    }
    assert!(found >= 5 && compared >= 45, "{found}, {compared}");
}

#[test]
fn a_mirrored_profile_has_the_mirrored_axis() {
    for golden in golden(SYNTHETIC).into_iter().step_by(5) {
        let profile = golden.profile();
        let mut mirrored = profile.clone();
        mirrored.channels.iter_mut().for_each(|c| c.reverse());
        mirrored.clipped.reverse();
        let (one, _) = axis_of(&profile, &Wanted::default());
        let (other, _) = axis_of(&mirrored, &Wanted::default());
        assert_eq!(one.state, other.state, "{}", golden.id);
        let (Some(a), Some(b)) = (&one.best, &other.best) else {
            continue;
        };
        if one.state == State::Found {
            let last = golden.r.len() as f64 - 1.0;
            let (low, high) = a.span_nm();
            for column in 0..golden.r.len() {
                let px = column as f64;
                let nm = a.curve.nm(px);
                let off = nm - b.curve.nm(last - px);
                let counts = (low..=high).contains(&nm);
                assert!(
                    !counts || off.abs() < 0.2,
                    "{} at {nm:.0}: {off:.2}",
                    golden.id
                );
            }
        }
    }
}
