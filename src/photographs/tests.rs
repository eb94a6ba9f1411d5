//! Golden profiles: synthetic ones whose axis is known, and ones of openly licensed photographs.

use serde::Deserialize;

use super::{
    Lamp, Profile,
    axis::{Answer, Curve, Pin, State, Wanted, find},
    peaks::{Peaks, bright, dark},
};

const SYNTHETIC: &str = include_str!("../../tests/golden/photographs/profiles.json");
const REAL: &str = include_str!("../../tests/golden/photographs/real_profiles.json");

#[derive(Deserialize)]
struct File {
    profiles: Vec<Golden>,
}

#[derive(Deserialize)]
struct Golden {
    #[serde(default)]
    id: String,
    #[serde(default)]
    name: String,
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
    lamp: String,
    score: f64,
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
        let axis = self.true_axis.as_ref().expect("a synthetic profile");
        Curve::new(self.r.len(), axis.c)
    }
}

fn golden(file: &str) -> Vec<Golden> {
    serde_json::from_str::<File>(file)
        .expect("golden profiles")
        .profiles
}

fn axis_of(profile: &Profile, wanted: &Wanted) -> (Answer, Peaks, Option<Peaks>) {
    let bright = bright(profile);
    let dark = dark(profile, &bright);
    let answer = find(profile.columns(), &bright, dark.as_ref(), wanted);
    (answer, bright, dark)
}

/// Root mean square and worst of an axis over the part that it is meant for.
fn off(answer: &Answer, truth: &Curve) -> (f64, f64) {
    let best = answer.best.as_ref().expect("an axis");
    let (low, high) = best.span_nm();
    let (low, high) = ((low - 15.0).max(400.0), (high + 15.0).min(700.0));
    let columns = (0..truth.scale_px as usize).map(|i| i as f64);
    let inside = columns.filter(|px| (low..=high).contains(&truth.nm(*px)));
    let off: Vec<f64> = inside
        .map(|px| (best.curve.nm(px) - truth.nm(px)).abs())
        .collect();
    let rms = (off.iter().map(|o| o * o).sum::<f64>() / off.len().max(1) as f64).sqrt();
    (rms, off.iter().copied().fold(0.0, f64::max))
}

fn line(answer: &Answer) -> String {
    let tell = |s: &super::axis::Solution| {
        let nm: Vec<String> = s.lines_nm().map(|nm| format!("{nm:.1}")).collect();
        let (rms, loo) = (s.rms_nm(), s.left_out_rms_nm());
        format!(
            "{:11} {:6.2} rms {rms:.2} loo {loo:.2} [{}]",
            s.lamp.name(),
            s.score,
            nm.join(" ")
        )
    };
    let best = answer.best.as_ref().map(tell).unwrap_or_default();
    let other = answer.runner_up.as_ref().map(tell).unwrap_or_default();
    let why = answer.why.clone().unwrap_or_default();
    format!(
        "{:?} margin {:.1} {best}\n      other {other}\n      {why}",
        answer.state, answer.margin
    )
}

#[test]
fn peaks_stand_where_those_of_the_golden_profiles_do() {
    for golden in golden(SYNTHETIC) {
        let profile = golden.profile();
        let bright = bright(&profile);
        let dark = dark(&profile, &bright);
        let is_dark = golden.lamp.as_deref() == Some("daylight");
        let peaks = if is_dark {
            dark.expect("dark lines")
        } else {
            bright
        };
        for [px, height, fwhm] in &golden.peaks {
            let near = peaks.peaks.iter().filter(|p| !p.is_clipped && *fwhm > 2.5);
            let away = near.map(|p| (p.px - px).abs()).fold(f64::MAX, f64::min);
            let is_clipped =
                (golden.clipped.iter()).any(|c| (*c as f64 - px).abs() < 0.5 * fwhm + 1.0);
            if *fwhm > 2.5 && !is_clipped && away >= 0.15 {
                println!("PEAK {} {px} {height} {fwhm}: off by {away:.2}", golden.id);
            }
        }
    }
}

#[test]
fn synthetic() {
    let start = std::time::Instant::now();
    let mut told = Vec::new();
    for golden in golden(SYNTHETIC) {
        let profile = golden.profile();
        let begun = std::time::Instant::now();
        let (answer, bright, dark) = axis_of(&profile, &Wanted::default());
        let took = begun.elapsed().as_millis();
        let (rms, worst) = if answer.best.is_some() {
            off(&answer, &golden.truth())
        } else {
            (9.9, 9.9)
        };
        let study = golden.found.as_ref().map_or(String::new(), |f| {
            format!("{} {:.1} {:.2}", f.lamp, f.score, f.axis_rms_nm)
        });
        println!(
            "{} {:?} study {} {study}: peaks {} dark {:?} rms {rms:.2} worst {worst:.1} {took} ms\n   {}",
            golden.id,
            golden.lamp,
            golden.state.as_deref().unwrap_or_default(),
            bright.peaks.len(),
            dark.map(|d| d.peaks.len()),
            line(&answer),
        );
        if let Some(lamp) = golden.lamp.as_deref().and_then(Lamp::named) {
            let truth = golden.truth();
            let wanted = Wanted {
                lamp: Some(lamp),
                ..Wanted::default()
            };
            let (answer, ..) = axis_of(&profile, &wanted);
            let (rms, worst) = if answer.best.is_some() {
                off(&answer, &truth)
            } else {
                (9.9, 9.9)
            };
            println!(
                "   TOLD {:?} rms {rms:.2} worst {worst:.1} score {:.1} margin {:.1}",
                answer.state,
                answer.best.as_ref().map_or(0.0, |b| b.score),
                answer.margin
            );
            let columns = golden.r.len() as f64;
            let seen: Vec<f64> = bright.peaks.iter().map(|p| p.px).collect();
            if seen.len() > 2 {
                let pin = |px: f64| Pin {
                    px,
                    nm: truth.nm(px),
                };
                let pins = vec![pin(seen[0]), pin(seen[seen.len() - 1])];
                let wanted = Wanted {
                    lamp: Some(lamp),
                    pins,
                };
                let (answer, ..) = axis_of(&profile, &wanted);
                let (rms, worst) = if answer.best.is_some() {
                    off(&answer, &truth)
                } else {
                    (9.9, 9.9)
                };
                println!(
                    "   PINS {:?} rms {rms:.2} worst {worst:.1} of {columns}",
                    answer.state
                );
            }
        }
        told.push((answer.state, golden.lamp.is_some(), rms));
    }
    let count =
        |state: State, lamp: bool| told.iter().filter(|t| t.0 == state && t.1 == lamp).count();
    println!(
        "SUM found {} suggested {} none {}; no lamp: found {} suggested {}; {:?}",
        count(State::Found, true),
        count(State::Suggested, true),
        count(State::Nothing, true),
        count(State::Found, false),
        count(State::Suggested, false),
        start.elapsed()
    );
}

#[test]
fn real() {
    for golden in golden(REAL) {
        let profile = golden.profile();
        let (answer, bright, dark) = axis_of(&profile, &Wanted::default());
        println!(
            "{} {}: peaks {} dark {:?} width {:.1}\n   {}",
            golden.name,
            golden.expect,
            bright.peaks.len(),
            dark.map(|d| d.peaks.len()),
            bright.width_px,
            line(&answer)
        );
        if let Some(lines) = &golden.lines {
            let off: Vec<String> = lines
                .iter()
                .map(|[px, nm]| {
                    answer
                        .best
                        .as_ref()
                        .map_or(String::new(), |b| format!("{:.1}", b.curve.nm(*px) - nm))
                })
                .collect();
            println!("   off {}", off.join(" "));
        }
        if let Some(lamp) = Lamp::named(&golden.expect) {
            let (answer, ..) = axis_of(
                &profile,
                &Wanted {
                    lamp: Some(lamp),
                    ..Wanted::default()
                },
            );
            let off: Vec<String> = golden
                .lines
                .iter()
                .flatten()
                .map(|[px, nm]| {
                    answer
                        .best
                        .as_ref()
                        .map_or(String::new(), |b| format!("{:.1}", b.curve.nm(*px) - nm))
                })
                .collect();
            println!("   TOLD {}\n   off {}", line(&answer), off.join(" "));
        }
    }
}
