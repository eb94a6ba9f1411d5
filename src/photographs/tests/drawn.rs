//! Lamps, cameras and gratings drawn by seeds: how many axes are found, and that none is wrong.

use std::collections::BTreeMap;

use super::{
    super::{
        Lamp, Profile,
        axis::{Answer, State, Wanted},
        peaks::{Peak, bright},
    },
    axis_of, off_at, pins_by_hand, strip_of,
};
use crate::core_tests::photographs::{
    Dice, Kind, Light, NOTHINGS, Setup, drawn_profile, no_spectrum, picture,
};

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
    /// found 97 of 100 are right within 1 nm, and none is wrong.
    fn reach(&self, all: f64, fluorescent: f64) {
        println!("{self:#?}");
        assert!(self.wrong.is_empty(), "{:?}", self.wrong);
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

fn rates_of_profiles(seeds: impl IntoIterator<Item = u64>) -> Rates {
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
            other_lamp: None,
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
    rates_of_profiles(7001..7201).reach(0.65, 0.8);
}

/// Seeds by which an outermost line was once taken for another.
const MISTAKEN: [u64; 12] = [
    20_269, 20_463, 40_253, 40_481, 50_161, 106_427, 106_502, 108_169, 108_320, 109_409, 110_347,
    113_273,
];

#[test]
fn an_axis_whose_outermost_lines_may_be_others_is_right_or_not_found() {
    let rates = rates_of_profiles(MISTAKEN);
    assert!(rates.wrong.is_empty(), "{:?}", rates.wrong);
    assert!(rates.found >= 4, "{rates:?}");
}

#[test]
fn the_blue_line_of_a_fluorescent_lamp_is_kept_where_the_others_foretell_it_badly() {
    for seed in [100_061, 100_142, 100_180] {
        let mut dice = Dice::new(seed);
        let (profile, _) = drawn_profile(&Light::of(kind_of(seed), &mut dice), &mut dice);
        let (answer, _) = axis_of(&profile, &Wanted::default());
        let best = answer.best.as_ref().expect("an axis");
        let has_blue = best.lines_nm().any(|nm| (nm - 435.8).abs() < 0.5);
        assert!(answer.state == State::Found && has_blue, "{seed}: {best:?}");
    }
}

#[test]
fn a_line_that_is_much_narrower_than_the_others_is_drawn_and_no_light() {
    let mut dice = Dice::new(4);
    let drawn = (0..200).map(|_| drawn_profile(&Light::of(Kind::Cfl, &mut dice), &mut dice).0);
    let wide = drawn.into_iter().find(|drawn| bright(drawn).width_px > 8.0);
    let mut profile = wide.expect("a profile of wide lines");
    let plain = bright(&profile);
    let at = profile.columns() / 2;
    for channel in &mut profile.channels {
        let top = channel.iter().copied().fold(0.0, f64::max);
        channel[at] += 0.3 * top;
        channel[at + 1] += 0.3 * top;
    }
    let drawn = bright(&profile);
    let is_new = |p: &Peak| (p.px - at as f64 - 0.5).abs() < 1.0 && p.fwhm_px < 4.0;
    assert!(!drawn.peaks.iter().any(is_new), "{:?}", drawn.peaks);
    assert!(drawn.hairlines > plain.hairlines);
}

#[test]
fn half_of_the_lamps_in_drawn_pictures_are_found_and_none_is_wrong() {
    rates_of_pictures(7001..7061).reach(0.4, 0.65);
}

#[test]
#[ignore = "takes minutes: the large sets of drawn profiles and pictures"]
fn large_sets_are_found_as_often_as_was_asked_for() {
    let (strange, ..) = rates_of_strange(1..=3000);
    println!("of 3000 strange lamps: {strange:#?}");
    assert!(strange.is_empty(), "{strange:?}");
    let profiles = (20_000..70_001)
        .step_by(10_000)
        .map(|first| rates_of_profiles(first..first + 1000));
    let profiles = profiles.fold(Rates::default(), Rates::with);
    profiles.reach(0.7, 0.9);
    rates_of_pictures(20_000..20_600).reach(0.45, 0.75);
}

#[test]
#[ignore = "takes minutes: the large set of drawn profiles, whose lamps are named"]
fn lamps_of_drawn_profiles_that_are_named_or_pinned_are_found_more_often() {
    let [mut lamps, mut told, mut right, mut far] = [0; 4];
    let [mut pinned, mut on_pins] = [0; 2];
    let seeds = (20_000..70_001).step_by(10_000);
    for seed in seeds.flat_map(|first| first..first + 1000) {
        let mut dice = Dice::new(seed);
        let kind = kind_of(seed);
        let (profile, nm) = drawn_profile(&Light::of(kind, &mut dice), &mut dice);
        let Some(lamp) = kind.lamp().and_then(Lamp::named) else {
            continue;
        };
        let truth: Vec<[f64; 2]> = nm
            .iter()
            .zip(0..)
            .map(|(nm, i)| [*nm, f64::from(i)])
            .collect();
        let mut wanted = Wanted {
            lamp: Some(lamp),
            ..Wanted::default()
        };
        let (answer, _) = axis_of(&profile, &wanted);
        lamps += 1;
        if let (State::Found, Some(best)) = (answer.state, &answer.best) {
            let (rms, worst) = off_at(best, &truth);
            told += 1;
            right += usize::from(rms < 1.0);
            far += usize::from(worst > 5.0);
        }
        let nm_at = |px: f64| nm[(px.round().max(0.0) as usize).min(nm.len() - 1)];
        // A hand is off by 1.5 pixels.
        let Some(pins) = pins_by_hand(&profile, lamp, nm_at, || 1.5 * dice.normal()) else {
            continue;
        };
        wanted.pins = pins;
        let (answer, _) = axis_of(&profile, &wanted);
        pinned += 1;
        let best = answer.best.as_ref();
        on_pins += usize::from(best.is_some_and(|best| off_at(best, &truth).0 < 1.0));
    }
    println!("named: {told} of {lamps}, {right} right, {far} far; pinned: {on_pins} of {pinned}");
    assert!(right as f64 >= 0.78 * lamps as f64 && far as f64 <= 0.01 * told as f64);
    assert!(pinned > 4000 && on_pins as f64 >= 0.92 * pinned as f64);
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
