//! Golden profiles: generated ones whose axis is known, and ones of openly licensed photographs.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::{
    Lamp, Profile,
    axis::{Answer, Curve, Pin, Solution, State, Wanted, find},
    peaks::{Peaks, bright, dark},
    picture::{Codes, Picture},
    strip::{self, ByHand},
};
use crate::core_tests::photographs::{
    Dice, Kind, Light, NOTHINGS, Setup, drawn_profile, jpeg_of, no_spectrum, picture,
};

const SYNTHETIC: &str = include_str!("../../tests/golden/photographs/profiles.json");
const REAL: &str = include_str!("../../tests/golden/photographs/real_profiles.json");

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

fn axis_of(profile: &Profile, wanted: &Wanted) -> (Answer, Peaks) {
    let bright = bright(profile);
    let dark = dark(profile, &bright);
    let answer = find(profile.columns(), &bright, dark.as_ref(), wanted);
    (answer, bright)
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
    let (mut told, mut pinned, mut lamps) = (0, 0, 0);
    for golden in golden(SYNTHETIC) {
        let (Some(lamp), profile, truth) = (golden.lamp(), golden.profile(), golden.truth()) else {
            continue;
        };
        lamps += 1;
        let mut wanted = Wanted {
            lamp: Some(lamp),
            ..Wanted::default()
        };
        let (answer, peaks) = axis_of(&profile, &wanted);
        if answer.state == State::Found {
            let (rms, worst) = off(&answer, &truth);
            told += usize::from(rms < 1.0);
            assert!(worst < 5.0, "{}: {worst:.1} nm", golden.id);
        }
        let [first, .., last] = &peaks.peaks[..] else {
            continue;
        };
        let pin = |px: f64| Pin::near(px, truth.nm(px));
        wanted.pins = vec![pin(first.px), pin(last.px)];
        let (answer, _) = axis_of(&profile, &wanted);
        pinned += usize::from(answer.best.is_some() && off(&answer, &truth).0 < 1.0);
    }
    assert!(told as f64 >= 0.78 * lamps as f64, "{told} of {lamps}");
    assert!(pinned as f64 >= 0.85 * lamps as f64, "{pinned} of {lamps}");
}

#[test]
fn axes_of_real_photographs_are_right_where_they_are_found() {
    let mut found = 0;
    for golden in golden(REAL) {
        let (answer, _) = axis_of(&golden.profile(), &Wanted::default());
        if answer.state != State::Found {
            continue;
        }
        found += 1;
        let best = answer.best.as_ref().expect("an axis");
        assert_eq!(best.lamp.name(), golden.expect, "{}", golden.id);
        for [px, nm] in golden.lines.iter().flatten() {
            let off = best.curve.nm(*px) - nm;
            assert!(off.abs() < 1.5, "{} at {nm}: {off:.2} nm", golden.id);
        }
    }
    assert!(found >= 5, "{found}");
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

/// Numbers from 0 to 1 that look random: the same for the same seed.
struct Rolls(u64);

impl Rolls {
    fn roll(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A lamp that is none: lines anywhere, before a camera.
fn strange(seed: u64) -> Profile {
    let mut rolls = Rolls(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    for _ in 0..20 {
        rolls.roll();
    }
    let lines: Vec<(f64, f64)> = (0..5 + (rolls.roll() * 10.0) as usize)
        .map(|_| (390.0 + 320.0 * rolls.roll(), (-4.0 * rolls.roll()).exp()))
        .collect();
    let width = 2.0 + 3.0 * rolls.roll();
    let light = |nm: f64| -> f64 {
        let of_line =
            |(at, height): &(f64, f64)| height * (-2.77 * ((nm - at) / width).powi(2)).exp();
        0.01 + lines.iter().map(of_line).sum::<f64>()
    };
    let camera = [(605.0, 38.0), (535.0, 38.0), (455.0, 33.0)];
    let nm = |column: usize| 380.0 + 0.68 * column as f64;
    let mut channel = |(centre, wide): (f64, f64)| -> Vec<f64> {
        (0..500)
            .map(|c| light(nm(c)) * (-0.5 * ((nm(c) - centre) / wide).powi(2)).exp())
            .map(|v| v + 0.002 * (rolls.roll() + rolls.roll() - 1.0))
            .collect()
    };
    let channels = camera.map(&mut channel);
    Profile {
        channels,
        sigma: [0.0009; 3],
        clipped: vec![false; 500],
        is_grey: false,
        black_seen: true,
        rows: 40,
    }
}

/// Of strange lamps: how many are found, how many suggested, and how many lines they have.
fn rates_of_strange(seeds: std::ops::RangeInclusive<u64>) -> (Vec<String>, usize, usize) {
    let (mut wrong, mut suggested, mut seen) = (Vec::new(), 0, 0);
    for seed in seeds {
        let (answer, peaks) = axis_of(&strange(seed), &Wanted::default());
        seen += peaks.peaks.len();
        suggested += usize::from(answer.state == State::Suggested);
        if let (State::Found, Some(best)) = (answer.state, &answer.best) {
            let (lamp, lines) = (best.lamp, best.matches.len());
            let (score, margin) = (best.score, answer.margin);
            let of = peaks.peaks.len();
            wrong.push(format!(
                "{seed}: {lamp:?}, score {score:.1}, margin {margin:.1}, {lines} of {of} lines"
            ));
        }
    }
    (wrong, suggested, seen)
}

#[test]
fn lamps_of_lines_that_nobody_knows_are_never_found() {
    let (wrong, suggested, seen) = rates_of_strange(1..=400);
    assert!(seen > 1000, "{seen} lines");
    assert!(
        wrong.is_empty() && suggested <= 50,
        "{wrong:?}, {suggested} suggested"
    );
}

/// What an axis is off by at places whose wavelengths are known: root mean square within 15 nm of
/// its lines in 400-700 nm, and the worst among them.
fn off_at(best: &Solution, truth: &[[f64; 2]]) -> (f64, f64) {
    let (low, high) = best.span_nm();
    let inside = |from: f64, to: f64| {
        let counts = move |at: &&[f64; 2]| (from.max(400.0)..=to.min(700.0)).contains(&at[0]);
        let places = truth.iter().filter(counts);
        places
            .map(|[nm, px]| (best.curve.nm(*px) - nm).abs())
            .collect::<Vec<f64>>()
    };
    let near = inside(low - 15.0, high + 15.0);
    let rms = (near.iter().map(|o| o * o).sum::<f64>() / near.len().max(1) as f64).sqrt();
    (rms, inside(low, high).into_iter().fold(0.0, f64::max))
}

/// How many answers were of which kind.
#[derive(Debug, Default)]
struct Rates {
    lamps: usize,
    found: usize,
    right: usize,
    fluorescent: [usize; 2],
    others: usize,
    others_suggested: usize,
    wrong: Vec<String>,
    /// Why lamps were missed, of fluorescent ones apart, each with whether the best axis was right.
    missed: BTreeMap<String, usize>,
}

impl Rates {
    fn count(&mut self, name: String, kind: Kind, answer: &Answer, truth: &[[f64; 2]]) {
        let is_found = answer.state == State::Found;
        let best = answer.best.as_ref();
        let Some(lamp) = kind.lamp() else {
            self.others += 1;
            self.others_suggested += usize::from(answer.state == State::Suggested);
            if is_found {
                self.wrong.push(format!("{name}: {kind:?} is found"));
            }
            return;
        };
        self.lamps += 1;
        if kind == Kind::Cfl {
            self.fluorescent[0] += usize::from(is_found);
            self.fluorescent[1] += 1;
        }
        if !is_found {
            let is_right =
                best.is_some_and(|best| best.lamp.name() == lamp && off_at(best, truth).0 < 1.0);
            let why = answer.why.clone().unwrap_or_else(|| "no strip".to_owned());
            let of = if kind == Kind::Cfl {
                "fluorescent"
            } else {
                "others"
            };
            let why: String = why
                .chars()
                .filter(|c| !c.is_ascii_digit())
                .take(40)
                .collect();
            let right = if is_right { "right" } else { "wrong" };
            *self
                .missed
                .entry(format!("{of}, best {right}: {why}"))
                .or_default() += 1;
        }
        if let Some(best) = best.filter(|_| is_found) {
            self.found += 1;
            let (rms, worst) = off_at(best, truth);
            self.right += usize::from(rms < 1.0);
            if best.lamp.name() != lamp || worst > 5.0 {
                let found = best.lamp.name();
                let lines: Vec<String> = best.lines_nm().map(|nm| format!("{nm:.0}")).collect();
                self.wrong.push(format!(
                    "{name}: {kind:?} is {found}, off by {worst:.1} nm, lines {}, score {:.1}, \
                     margin {:.1}",
                    lines.join(" "),
                    best.score,
                    answer.margin
                ));
            }
        }
    }

    /// Both taken together.
    fn with(mut self, other: Self) -> Self {
        self.lamps += other.lamps;
        self.found += other.found;
        self.right += other.right;
        for (own, more) in self.fluorescent.iter_mut().zip(other.fluorescent) {
            *own += more;
        }
        self.others += other.others;
        self.others_suggested += other.others_suggested;
        self.wrong.extend(other.wrong);
        for (why, count) in other.missed {
            *self.missed.entry(why).or_default() += count;
        }
        self
    }

    /// The shares that were found, of all lamps and of fluorescent ones, are these at least; of those
    /// found 97 of 100 are right within 1 nm, and so small a share is wrong.
    fn reach(&self, all: f64, fluorescent: f64, most_wrong: f64) {
        println!("{self:#?}");
        let wrong = self.wrong.len() as f64;
        assert!(wrong <= most_wrong * self.found as f64, "{:?}", self.wrong);
        assert!(self.found as f64 >= all * self.lamps as f64, "{self:?}");
        let [found, of] = self.fluorescent.map(|n| n as f64);
        assert!(found >= fluorescent * of, "{self:?}");
        assert!(self.right as f64 >= 0.97 * self.found as f64, "{self:?}");
        assert!(
            self.others_suggested as f64 <= 0.03 * self.others as f64,
            "{self:?}"
        );
    }
}

fn kind_of(seed: u64) -> Kind {
    let mut kinds = Kind::LAMPS.iter().chain(&Kind::OTHERS);
    let number = seed as usize % (Kind::LAMPS.len() + Kind::OTHERS.len());
    *kinds.nth(number).unwrap_or(&Kind::Cfl)
}

fn rates_of_profiles(seeds: std::ops::Range<u64>) -> Rates {
    let mut rates = Rates::default();
    for seed in seeds {
        let mut dice = Dice::new(seed);
        let kind = kind_of(seed);
        let (profile, nm) = drawn_profile(&Light::of(kind, &mut dice), &mut dice);
        let truth: Vec<[f64; 2]> = nm
            .iter()
            .zip(0..)
            .map(|(nm, i)| [*nm, f64::from(i)])
            .collect();
        let (answer, _) = axis_of(&profile, &Wanted::default());
        rates.count(format!("profile {seed}"), kind, &answer, &truth);
    }
    rates
}

fn strip_of(size: [usize; 2], codes: Vec<u8>) -> Option<strip::Found> {
    let picture = Picture::new(size, Codes::Eight(codes), false).expect("a picture");
    strip::find(&picture, &ByHand::default()).ok()
}

fn rates_of_pictures(seeds: std::ops::Range<u64>) -> Rates {
    let mut rates = Rates::default();
    for seed in seeds {
        let mut dice = Dice::new(1_000_000 + seed);
        let kind = kind_of(seed);
        let light = Light::of(kind, &mut dice);
        let setup = Setup::any(&mut dice);
        let exposure = 0.25 * 8_f64.powf(dice.roll());
        let drawn = picture(&setup, &light, exposure, 0.0, &mut dice);
        let nothing = Answer {
            state: State::Nothing,
            best: None,
            runner_up: None,
            margin: 0.0,
            why: None,
        };
        let found = strip_of(drawn.size, drawn.codes);
        let place = |[nm, x, y]: &[f64; 3]| {
            let column = found.as_ref().map_or(0.0, |f| f.strip.column_of(*x, *y).0);
            [*nm, column]
        };
        let truth: Vec<[f64; 2]> = drawn.points.iter().map(place).collect();
        let answer = found.as_ref().map_or(nothing, |found| {
            axis_of(&found.profile, &Wanted::default()).0
        });
        rates.count(format!("picture {seed}"), kind, &answer, &truth);
    }
    rates
}

// Gratings are steeper and lenses bend more here than in the set that the bars of the definition
// were measured on; of 40 fluorescent lamps a standard deviation is 5 %.
#[test]
fn most_lamps_of_drawn_profiles_are_found_and_none_is_wrong() {
    rates_of_profiles(7001..7201).reach(0.65, 0.8, 0.0);
}

#[test]
fn half_of_the_lamps_in_drawn_pictures_are_found_and_none_is_wrong() {
    rates_of_pictures(7001..7061).reach(0.4, 0.65, 0.0);
}

#[test]
#[ignore = "takes minutes: the large sets of drawn profiles and pictures"]
fn large_sets_are_found_as_often_as_was_asked_for() {
    let (strange, ..) = rates_of_strange(1..=3000);
    println!("of 3000 strange lamps: {strange:#?}");
    assert!(strange.len() <= 1, "{strange:?}");
    let profiles = (20_000..70_001)
        .step_by(10_000)
        .map(|first| rates_of_profiles(first..first + 1000));
    let profiles = profiles.fold(Rates::default(), Rates::with);
    // Five of a thousand that are found may be wrong.
    profiles.reach(0.65, 0.9, 0.005);
    rates_of_pictures(20_000..20_600).reach(0.45, 0.75, 0.005);
}

#[test]
#[ignore = "takes minutes: the large set of drawn profiles, whose lamps are named"]
fn lamps_of_drawn_profiles_that_are_named_or_pinned_are_found_more_often() {
    let [mut lamps, mut told, mut right, mut far] = [0; 4];
    let [mut pinned, mut on_pins] = [0; 2];
    for seed in 20_000..21_000 {
        let mut dice = Dice::new(seed);
        let kind = kind_of(seed);
        let (profile, nm) = drawn_profile(&Light::of(kind, &mut dice), &mut dice);
        let Some(lamp) = kind.lamp() else { continue };
        let truth: Vec<[f64; 2]> = nm
            .iter()
            .zip(0..)
            .map(|(nm, i)| [*nm, f64::from(i)])
            .collect();
        let mut wanted = Wanted {
            lamp: Lamp::ALL.into_iter().find(|one| one.name() == lamp),
            ..Wanted::default()
        };
        let (answer, peaks) = axis_of(&profile, &wanted);
        lamps += 1;
        if let (State::Found, Some(best)) = (answer.state, &answer.best) {
            let (rms, worst) = off_at(best, &truth);
            told += 1;
            right += usize::from(rms < 1.0);
            far += usize::from(worst > 5.0);
        }
        // As a hand sets them, 1.5 pixels off, on the outermost of what stands out.
        let [first, .., last] = &peaks.peaks[..] else {
            continue;
        };
        let mut pin = |px: f64| {
            let at = (px.max(0.0) as usize).min(nm.len() - 1);
            Pin::near(px + 1.5 * dice.normal(), nm[at])
        };
        wanted.pins = vec![pin(first.px), pin(last.px)];
        let (answer, _) = axis_of(&profile, &wanted);
        pinned += 1;
        let best = answer.best.as_ref();
        on_pins += usize::from(best.is_some_and(|best| off_at(best, &truth).0 < 1.0));
    }
    println!("named: {told} of {lamps}, {right} right, {far} far; pinned: {on_pins} of {pinned}");
    // 77.7 and 87.3 of 100, where the definition's own set, of gentler gratings, has 83 and 94.
    assert!(right as f64 >= 0.76 * lamps as f64 && far as f64 <= 0.01 * told as f64);
    assert!(on_pins as f64 >= 0.85 * pinned as f64);
}

#[test]
fn pictures_of_no_spectrum_are_never_found() {
    for (seed, kind) in (0..).zip(NOTHINGS.iter().cycle().take(30)) {
        let (size, codes) = no_spectrum(kind, &mut Dice::new(2_000_000 + seed));
        let Some(found) = strip_of(size, codes) else {
            continue;
        };
        let (answer, _) = axis_of(&found.profile, &Wanted::default());
        assert_eq!(
            answer.state,
            State::Nothing,
            "{kind}, seed {seed}: {:?}",
            answer.best
        );
    }
}

/// A picture of a fluorescent lamp, without loss.
fn plain_picture(seed: u64) -> ([usize; 2], Vec<u8>, Vec<[f64; 3]>) {
    let mut dice = Dice::new(seed);
    let light = Light::of(Kind::Cfl, &mut dice);
    let mut setup = Setup::of([640, 360], &mut dice);
    setup.quality = None;
    setup.slit_nm = 2.0;
    let drawn = picture(&setup, &light, 0.9, 0.0, &mut dice);
    (drawn.size, drawn.codes, drawn.points)
}

/// The wavelengths of the axis of a picture at some of its pixels, and how many lines made it.
fn nm_at(size: [usize; 2], codes: Vec<u8>, pixels: &[[f64; 2]]) -> (Vec<f64>, usize) {
    let found = strip_of(size, codes).expect("a strip");
    let (answer, _) = axis_of(&found.profile, &Wanted::default());
    assert_eq!(answer.state, State::Found, "{:?}", answer.why);
    let best = answer.best.expect("an axis");
    let nm = |[x, y]: &[f64; 2]| best.curve.nm(found.strip.column_of(*x, *y).0);
    (pixels.iter().map(nm).collect(), best.matches.len())
}

#[test]
fn a_doubled_picture_and_a_jpeg_of_quality_100_have_the_same_axis() {
    let mut compared = 0;
    for seed in 5..=9 {
        let ([width, height], codes, points) = plain_picture(seed);
        let inside = |p: &&[f64; 3]| (440.0..=620.0).contains(&p[0]);
        let points = points.iter().filter(inside);
        let pixels: Vec<[f64; 2]> = points.map(|[_, x, y]| [*x, *y]).collect();
        let (plain, lines) = nm_at([width, height], codes.clone(), &pixels);
        let most = |other: &[f64]| {
            let off = plain.iter().zip(other).map(|(a, b)| (a - b).abs());
            off.fold(0.0, f64::max)
        };
        // A faint line that the loss hides is no other place of those that stay.
        let jpeg = jpeg_of(&codes, [width, height], 100);
        let (jpeg, same) = nm_at([width, height], jpeg, &pixels);
        if lines == same {
            compared += 1;
            assert!(most(&jpeg) < 0.1, "{seed}: {} nm as JPEG", most(&jpeg));
        }
        if seed > 6 {
            continue;
        }
        let pixel = |x: usize, y: usize| {
            let at = 3 * (y * width + x);
            [codes[at], codes[at + 1], codes[at + 2]]
        };
        let places = 0..4 * width * height;
        let doubled = places.flat_map(|i| pixel(i % (2 * width) / 2, i / (4 * width)));
        let large: Vec<[f64; 2]> = pixels.iter().map(|p| p.map(|v| 2.0 * v + 0.5)).collect();
        let (large, _) = nm_at([2 * width, 2 * height], doubled.collect(), &large);
        assert!(most(&large) < 0.3, "{seed}: {} nm doubled", most(&large));
    }
    assert!(compared >= 3, "{compared}");
}

#[test]
fn three_lines_without_colours_are_never_found() {
    for seed in 0..40 {
        let mut dice = Dice::new(8_000_000 + seed);
        let lines = (0..3)
            .map(|_| [dice.between(400.0, 690.0), 1.0, 0.1])
            .collect();
        let (mut profile, _) = drawn_profile(&Light::made(lines, Vec::new()), &mut dice);
        let grey = profile.sum();
        profile.channels = [grey.clone(), grey.clone(), grey];
        profile.is_grey = true;
        let (answer, _) = axis_of(&profile, &Wanted::default());
        assert_ne!(answer.state, State::Found, "{seed}: {:?}", answer.best);
    }
}
