//! The spike detectors on every shipped lamp, on lamps made up for the purpose, and on nonsense.
//!
//! The figures stand beside those of the study that the default detector was designed with,
//! printed with `cargo test --lib core_tests::detector:: -- --nocapture`.

use std::{f64::consts::LN_2, sync::Arc};

use super::plain::{plain, plain_about};
use super::{
    common::{on_band, values},
    lights,
};
use approx::assert_abs_diff_eq;
use proptest::prelude::*;
use spectral_explorer::{
    app::{App, Command, Detector, Entry, Library, Settings, SpikeAct},
    color::blackbody,
    preset::Shelf,
    spectrum::{
        Band, Constraints, Decomposition, Factor, FoundSpike, GAUSSIAN_AREA, Kind, NamedSpectrum,
        Outside, Sampled, SpikeSettings, detect,
        gradient::{self, DEFAULT_GRADIENT},
    },
};

const BAND: Band = Band::VISIBLE;

fn lamps() -> Vec<(String, Vec<f64>)> {
    let presets = Library::bundled().presets();
    let lamps = presets.filter(|preset| lights::COUNTED_GROUPS.contains(&preset.group.as_str()));
    let tables = lamps.filter_map(|lamp| Some((lamp.id(), values(lamp.spectrum()?, BAND))));
    let tables: Vec<_> = tables.collect();
    assert_eq!(tables.len(), 137);
    tables
}

fn by_default(values: &[f64]) -> Decomposition {
    detect(BAND, values, SpikeSettings::default())
}

/// Places and shares of power, in percent.
fn found_in(name: &str) -> Vec<(f64, f64)> {
    let parts = by_default(&on_band(name, BAND));
    let spikes = parts.spikes.iter();
    spikes
        .map(|s| (s.spike.at_nm, 100.0 * s.spike.weight / parts.power))
        .collect()
}

/// The mercury lines that every fluorescent lamp shows; 578.0 is the middle of a pair.
const MERCURY_NM: [f64; 4] = [404.7, 435.8, 546.1, 578.0];

fn mercury_lines_found(group: &str) -> (usize, Vec<usize>) {
    let mut hits = 0;
    let counts = (1..=12)
        .map(|lamp| {
            let found = found_in(&format!("{group}/FL{lamp}"));
            let near = |line: &f64| found.iter().any(|(nm, _)| (nm - line).abs() <= 3.0);
            hits += MERCURY_NM.iter().filter(|line| near(line)).count();
            found.len()
        })
        .collect();
    (hits, counts)
}

#[test]
fn every_mercury_line_of_the_1_nm_fluorescent_lamps_is_found() {
    let (hits, counts) = mercury_lines_found("cie_fluorescent_1nm");
    println!("FL1-FL12 at 1 nm: {hits} of 48 mercury lines, study 48; spikes each {counts:?}");
    assert_eq!(hits, 48);
    assert_eq!(counts[..9], [4; 9], "the lamps without narrow phosphors");
    for lamp in 1..=9 {
        let (at_nm, _) = found_in(&format!("cie_fluorescent_1nm/FL{lamp}"))[3];
        // The pair at 577.0 and 579.1 as one spike; the table gives 0.1 nm of play.
        assert!((at_nm - 578.0).abs() < 0.15, "FL{lamp}: {at_nm}");
    }
}

#[test]
fn most_mercury_lines_of_the_5_nm_fluorescent_lamps_are_found() {
    let (hits, counts) = mercury_lines_found("cie_fluorescent_5nm");
    println!("FL1-FL12 at 5 nm: {hits} of 48 mercury lines, study 39; spikes each {counts:?}");
    assert_eq!(hits, 39);
}

#[test]
fn fl2_has_the_shares_of_the_study() {
    let study = [(404.9, 2.39), (435.8, 5.94), (546.1, 2.87), (578.0, 0.98)];
    let found = found_in("cie_fluorescent_1nm/FL2");
    println!("FL2: {found:.3?}, study {study:?}");
    assert_eq!(found.len(), study.len());
    for ((at_nm, percent), (study_nm, study_percent)) in found.iter().zip(study) {
        // Half of the last digit that the study states.
        assert!((at_nm - study_nm).abs() <= 0.05 && (percent - study_percent).abs() <= 0.005);
    }
}

/// How many of some spectra show a spike, and which.
fn with_spikes<'a>(spectra: impl Iterator<Item = &'a NamedSpectrum>) -> (usize, Vec<String>) {
    let mut total = 0;
    let mut guilty = Vec::new();
    for spectrum in spectra {
        total += 1;
        let found = by_default(&values(spectrum, BAND)).spikes;
        if !found.is_empty() {
            guilty.push(format!("{}: {found:.2?}", spectrum.name));
        }
    }
    (total, guilty)
}

#[test]
fn smooth_lights_show_no_spike() {
    let lights = lights::smooth();
    for name in [
        "CIE A", "CIE C", "CIE D50", "CIE D55", "CIE D65", "CIE D75", "CIE E", "CIE ID50",
        "CIE ID65",
    ] {
        assert!(lights.iter().any(|light| light.name == name), "{name}");
    }
    let (total, guilty) = with_spikes(lights.iter());
    println!("smooth lights with spikes: {guilty:?} of {total}, study 0 of 35");
    assert!(guilty.is_empty());
    for kelvin in (2000..=20000).step_by(250) {
        let kelvin = f64::from(kelvin);
        let values: Vec<f64> = BAND
            .grid()
            .map(|nm| blackbody::radiance(nm, kelvin))
            .collect();
        assert!(by_default(&values).spikes.is_empty(), "{kelvin} K");
    }
}

fn of_kind(kind: Kind) -> impl Iterator<Item = &'static NamedSpectrum> {
    let spectra = Library::bundled().spectra();
    spectra.filter(move |spectrum| spectrum.kind == kind)
}

#[test]
fn reflectances_show_no_spike() {
    let (total, guilty) = with_spikes(of_kind(Kind::Reflectance));
    println!("reflectances with spikes: {guilty:?} of {total}, study 0 of 455");
    assert!(guilty.is_empty());
    assert!(total >= 430, "{total}");
}

#[test]
fn a_filter_shows_a_spike_only_where_the_range_cuts_its_steep_edge() {
    let (total, guilty) = with_spikes(of_kind(Kind::Transmittance));
    println!("filters with spikes: {guilty:?} of {total}, not in the study");
    // Two ultraviolet filters end at 388 nm: the 8 nm that the range leaves of their pass band
    // cannot be told from a line that the range cuts.
    assert!(guilty.len() <= 2);
    for filter in of_kind(Kind::Transmittance) {
        for found in by_default(&values(filter, BAND)).spikes {
            assert_eq!(found.window_nm[0], BAND.min_nm(), "{}", filter.name);
        }
    }
}

#[test]
fn led_lights_show_no_spike() {
    let (total, guilty) = with_spikes(lights::on_shelf(Shelf::Led).into_iter());
    println!("LED lights with spikes: {guilty:?} of {total}, study 1 of 221");
    assert!(guilty.is_empty());
    assert!(total >= 34);
}

// ------------------------------------------------------------------------------ made-up lamps

/// A row of numbers that look random and are the same every time (SplitMix64).
struct Chance(u64);

impl Chance {
    /// 0 to 1, evenly.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// Normal, mean 0, standard deviation 1 (Box and Muller).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.share()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.share()).cos()
    }
}

fn bell(at_nm: f64, centre_nm: f64, width_nm: f64) -> f64 {
    (-4.0 * LN_2 * ((at_nm - centre_nm) / width_nm).powi(2)).exp()
}

struct MadeUpLine {
    at_nm: f64,
    width_nm: f64,
    power: f64,
}

struct MadeUpLamp {
    lines: Vec<MadeUpLine>,
    background_power: f64,
    /// What a spectrometer would tell, each nm averaged, with 2 % noise of each value.
    measured: Vec<f64>,
}

impl MadeUpLamp {
    fn new(chance: &mut Chance, background: Vec<f64>) -> Self {
        let background_power = BAND.integral(&background);
        let mut lines: Vec<MadeUpLine> = Vec::new();
        let wanted = 1 + (8.0 * chance.share()) as usize;
        while lines.len() < wanted {
            let line = MadeUpLine {
                at_nm: chance.within(390.0, 770.0),
                width_nm: chance.within(1.0, 6.0),
                power: background_power * chance.within(0.003_f64.ln(), 0.12_f64.ln()).exp(),
            };
            if lines.iter().all(|l| (l.at_nm - line.at_nm).abs() > 8.0) {
                lines.push(line);
            }
        }
        // Ten places a nm: an average over the nm, since a line of 1 nm is not straight within it.
        let about = |nm: f64, line: &MadeUpLine| -> f64 {
            let height = line.power / (GAUSSIAN_AREA * line.width_nm);
            let places = (0..10).map(|i| nm - 0.45 + 0.1 * f64::from(i));
            let bells = places.map(|place| bell(place, line.at_nm, line.width_nm));
            height * bells.sum::<f64>() / 10.0
        };
        let measured = BAND
            .grid()
            .zip(&background)
            .map(|(nm, smooth)| smooth + lines.iter().map(|line| about(nm, line)).sum::<f64>())
            .map(|value| value * (1.0 + 0.02 * chance.normal()))
            .collect();
        Self {
            lines,
            background_power,
            measured,
        }
    }

    /// The same measurement as a 5 nm table: averages of five neighbours, read back linearly.
    fn as_5_nm_data(&self) -> Vec<f64> {
        let coarse = (0..81_usize)
            .map(|i| {
                let middle = 5 * i;
                let about = &self.measured[middle.saturating_sub(2)..(middle + 3).min(401)];
                about.iter().sum::<f64>() / about.len() as f64
            })
            .collect();
        let table = Sampled::even(380.0, 5.0, coarse).expect("a rising grid of finite values");
        table.on_band(BAND, Outside::Zero)
    }
}

/// 150 lamps, a third each on a blackbody, on daylight and on three broad bells.
fn made_up_lamps(seed: u64) -> Vec<MadeUpLamp> {
    let [s0, s1, s2] = ["S0", "S1", "S2"].map(|part| {
        on_band(
            &format!("cie_illuminants/CIE daylight component {part}"),
            BAND,
        )
    });
    let mut chance = Chance(seed);
    (0..150)
        .map(|i| {
            let background = match i % 3 {
                0 => {
                    let kelvin = chance.within(2000.0, 10000.0);
                    let relative = |nm| 100.0 * blackbody::relative(nm, kelvin);
                    BAND.grid().map(relative).collect()
                }
                1 => {
                    // The factors of daylight between about 5000 and 10000 K.
                    let (m1, m2) = (chance.within(-1.2, 1.0), chance.within(-0.6, 0.6));
                    let day = s0.iter().zip(&s1).zip(&s2);
                    day.map(|((s0, s1), s2)| s0 + m1 * s1 + m2 * s2).collect()
                }
                _ => {
                    let bells: [[f64; 3]; 3] = std::array::from_fn(|_| {
                        let (centre, width) =
                            (chance.within(430.0, 700.0), chance.within(40.0, 150.0));
                        [centre, width, chance.within(20.0, 100.0)]
                    });
                    let sum = |nm| bells.iter().map(|[c, w, h]| h * bell(nm, *c, *w)).sum();
                    BAND.grid().map(sum).collect()
                }
            };
            MadeUpLamp::new(&mut chance, background)
        })
        .collect()
}

/// `[precision, recall]`: how many spikes stand for a line, and how many lines above 0.75 % of
/// the power have a spike. A spike stands for a line when it is at most `reach_nm` away.
fn precision_and_recall(
    lamps: &[MadeUpLamp],
    data: impl Fn(&MadeUpLamp) -> Vec<f64>,
    reach_nm: f64,
) -> [f64; 2] {
    let (mut found, mut right, mut strong, mut hit) = (0, 0, 0, 0);
    for lamp in lamps {
        let spikes = by_default(&data(lamp)).spikes;
        let near = |line: &MadeUpLine, nm: f64| (line.at_nm - nm).abs() <= reach_nm;
        let stands_for_line = |nm: f64| lamp.lines.iter().any(|line| near(line, nm));
        found += spikes.len();
        right += spikes
            .iter()
            .filter(|s| stands_for_line(s.spike.at_nm))
            .count();
        let power = lamp.background_power + lamp.lines.iter().map(|l| l.power).sum::<f64>();
        for line in lamp.lines.iter().filter(|l| l.power >= 0.0075 * power) {
            strong += 1;
            hit += usize::from(spikes.iter().any(|s| near(line, s.spike.at_nm)));
        }
    }
    println!("{right} of {found} spikes are lines, {hit} of {strong} lines have a spike");
    [right as f64 / found as f64, hit as f64 / strong as f64]
}

#[test]
fn lines_on_made_up_backgrounds_are_found_and_hardly_anything_else() {
    let lamps = made_up_lamps(2000);
    // 3 nm is the reach that mercury lines are counted with; 4 nm leaves a 5 nm table its grain.
    let fine = precision_and_recall(&lamps, |lamp| lamp.measured.clone(), 3.0);
    println!("150 made-up lamps, 1 nm: precision, recall {fine:.3?}, study at least 0.99, 0.98");
    let coarse = precision_and_recall(&lamps, MadeUpLamp::as_5_nm_data, 4.0);
    println!("the same as 5 nm data: precision, recall {coarse:.3?}, study at least 0.97, 0.93");
    assert!(fine[0] >= 0.99 && fine[1] >= 0.98);
    assert!(coarse[0] >= 0.97 && coarse[1] >= 0.93);
}

#[test]
fn lamps_that_the_detector_was_not_made_with_show_the_same() {
    for seed in [1, 31_337] {
        let lamps = made_up_lamps(seed);
        let fine = precision_and_recall(&lamps, |lamp| lamp.measured.clone(), 3.0);
        let coarse = precision_and_recall(&lamps, MadeUpLamp::as_5_nm_data, 4.0);
        println!("seed {seed}: 1 nm {fine:.3?}, 5 nm {coarse:.3?}");
        assert!(fine[0] >= 0.99 && fine[1] >= 0.98);
        assert!(coarse[0] >= 0.97 && coarse[1] >= 0.93);
    }
}

// --------------------------------------------------------------------------------- invariants

/// Checks what holds for every spectrum.
fn check_promises(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
) -> Result<(), TestCaseError> {
    let SpikeSettings {
        threshold,
        max_width_nm,
        dips,
    } = settings;
    let parts = detect(band, values, settings);
    let power = parts.power;
    if !(power > 0.0 && power.is_finite()) {
        prop_assert!(parts.spikes.is_empty() && parts.smooth == values);
        return Ok(());
    }
    let top = values.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
    // Power times wavelength overflows beyond; there the only promise is not to panic.
    if top > 1e302 {
        return Ok(());
    }
    for found in &parts.spikes {
        let weight = found.spike.weight;
        prop_assert!(weight.abs() >= threshold * power, "{found:?}");
        prop_assert!(found.width_nm <= 1.05 * max_width_nm, "{found:?}");
        prop_assert!(weight > 0.0 || dips, "{found:?}");
        prop_assert!(
            band.contains(found.spike.at_nm),
            "{found:?} outside the band"
        );
        prop_assert!(
            (found.window_nm[0]..=found.window_nm[1]).contains(&found.spike.at_nm),
            "{found:?}"
        );
    }
    prop_assert!(
        parts
            .spikes
            .is_sorted_by(|a, b| a.spike.at_nm <= b.spike.at_nm)
    );
    // S = smooth + sum of residues: outside all windows nothing changed, inside it only fell
    // (or rose, for dips), and what is missing is the spikes' weight to rounding.
    for (i, (before, after)) in values.iter().zip(&parts.smooth).enumerate() {
        prop_assert!(after.is_finite());
        let nm = band.nm(i);
        let covered = |w: [f64; 2]| (w[0]..=w[1]).contains(&nm);
        if parts.spikes.iter().any(|s| covered(s.window_nm)) {
            prop_assert!(dips || *after <= *before);
        } else {
            prop_assert_eq!(before, after);
        }
    }
    let missing: Vec<f64> = values
        .iter()
        .zip(&parts.smooth)
        .map(|(a, b)| a - b)
        .collect();
    let weights: f64 = parts.spikes.iter().map(|s| s.spike.weight).sum();
    let lost = (band.integral(&missing) - weights).abs();
    // Each of at most 130 points is rounded a few times in its largest value.
    prop_assert!(lost <= 1e-12 * top * band.length_nm(), "{lost:e} lost");
    Ok(())
}

/// Values of every awkward sort: noise about zero, bells, mostly zeros, constants, single
/// samples, and any finite number at all; then scaled to the edge of what a double can hold.
fn awkward_values(points: usize) -> impl Strategy<Value = Vec<f64>> {
    let noise = prop::collection::vec(-1.0..1.0_f64, points);
    let bright = prop::collection::vec(0.0..1.0_f64, points);
    let sparse = prop::collection::vec(prop_oneof![9 => Just(0.0), 1 => -0.2..1.0_f64], points);
    let steps = prop::collection::vec(prop::sample::select(vec![0.0, 1.0, 2.0, -1.0]), points);
    let constant = (-1.0..1.0_f64).prop_map(move |v| vec![v; points]);
    let single = (0..points, -1.0..1.0_f64).prop_map(move |(at, v)| {
        let mut values = vec![0.0; points];
        values[at] = v;
        values
    });
    let lines = prop::collection::vec((0.0..1.0_f64, 1.0..9.0_f64, 0.0..5.0_f64), 0..5).prop_map(
        move |lines| {
            let line =
                |i: usize, (c, w, h): &(f64, f64, f64)| h * bell(i as f64, c * points as f64, *w);
            let at = |i| lines.iter().map(|l| line(i, l)).sum::<f64>();
            (0..points).map(|i| 1.0 + at(i)).collect()
        },
    );
    let shape = prop_oneof![noise, bright, sparse, steps, constant, single, lines];
    let scale = prop::sample::select(vec![1.0, 1e-300, 1e300, 1e-9, 1e9, 0.0]);
    let scaled = (shape, scale)
        .prop_map(|(values, scale)| values.into_iter().map(|v| v * scale).collect::<Vec<f64>>());
    let any_finite = {
        use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
        prop::collection::vec(POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, points)
    };
    prop_oneof![6 => scaled, 1 => any_finite]
}

fn awkward_questions() -> impl Strategy<Value = (Band, Vec<f64>, SpikeSettings)> {
    let settings = (0.0001..0.5_f64, 1.0..50.0_f64, any::<bool>()).prop_map(
        |(threshold, max_width_nm, dips)| SpikeSettings {
            threshold,
            max_width_nm,
            dips,
        },
    );
    (300..500_u32, 20..130_u32).prop_flat_map(move |(from, length)| {
        let band = Band::new(f64::from(from), f64::from(from + length)).expect("long enough");
        (Just(band), awkward_values(band.points()), settings.clone())
    })
}

/// Many cases, the same ones each time, so that a failure seen once is seen again.
fn cases(count: u32) -> ProptestConfig {
    ProptestConfig {
        cases: count,
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(405),
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn every_spike_is_strong_and_narrow_and_no_energy_is_lost(
        (band, values, settings) in awkward_questions(),
    ) {
        check_promises(band, &values, settings)?;
    }

    #[test]
    fn the_gradient_detector_loses_no_energy_either(
        (band, values, settings) in awkward_questions(),
        steep in 0.001..0.5_f64,
    ) {
        let width = settings.max_width_nm;
        let parts = gradient::detect(band, &values, steep, width, Constraints::default());
        let top = values.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
        // Beyond this the sums themselves overflow; there the only promise is not to panic.
        if top < 1e302 {
            let missing = band.integral(&values) - band.integral(&parts.smooth);
            let weights: f64 = parts.spikes.iter().map(|s| s.spike.weight).sum();
            // Its sums are plain ones, not trapezoids: a line's feet have nothing left of it.
            prop_assert!((missing - weights).abs() <= 1e-12 * top * band.length_nm());
            for found in &parts.spikes {
                prop_assert!(found.width_nm <= width && band.contains(found.spike.at_nm));
            }
        }
    }
}

#[test]
fn what_stands_at_an_end_of_the_range_is_no_line_and_stays_in_the_smooth_part() {
    let mut chance = Chance(546);
    for _ in 0..1000 {
        for end in [0, BAND.steps()] {
            let mut values = vec![0.0; BAND.points()];
            values[end] = chance.within(0.1, 10.0);
            let parts = by_default(&values);
            assert!(parts.spikes.is_empty(), "{:?}", parts.spikes);
            assert_eq!(parts.smooth, values);
        }
    }
}

#[test]
fn a_line_whose_flank_the_range_cuts_is_one_line_with_nearly_all_its_power() {
    for (at_nm, width_nm, least) in [(381.3, 2.0, 0.9), (383.0, 3.0, 0.9), (778.0, 2.5, 0.9)] {
        let values: Vec<f64> = BAND
            .grid()
            .map(|nm| 0.01 + bell(nm, at_nm, width_nm))
            .collect();
        let parts = by_default(&values);
        let [found] = parts.spikes[..] else {
            panic!("{at_nm}: {:?}", parts.spikes);
        };
        assert!(
            (found.spike.at_nm - at_nm).abs() < 0.2,
            "{at_nm}: {found:?}"
        );
        let share = found.spike.weight / (GAUSSIAN_AREA * width_nm);
        assert!((least..=1.0).contains(&share), "{at_nm}: {share}");
    }
}

#[test]
fn light_whose_peak_lies_outside_the_range_has_no_line_at_its_border() {
    // LEDs of the ultraviolet and infrared, and a filter's edge.
    for (at_nm, width_nm) in [
        (365.0, 10.0),
        (365.0, 20.0),
        (375.0, 8.0),
        (310.0, 15.0),
        (790.0, 30.0),
        (850.0, 40.0),
        (850.0, 25.0),
        (940.0, 50.0),
    ] {
        for step_nm in [0.5, 1.0, 5.0] {
            let points = (850.0 / step_nm) as usize;
            let values = (0..points).map(|i| bell(250.0 + step_nm * i as f64, at_nm, width_nm));
            let led = Sampled::even(250.0, step_nm, values.collect()).expect("a rising grid");
            let found = by_default(&led.on_band(BAND, Outside::Zero)).spikes;
            assert!(
                found.is_empty(),
                "{at_nm}/{width_nm} in {step_nm} nm: {found:?}"
            );
        }
    }
    let cut = Sampled::even(
        400.0,
        0.5,
        (0..500).map(|i| 1.0 + 0.002 * f64::from(i)).collect(),
    );
    let cut = cut.expect("a rising grid");
    assert!(
        by_default(&cut.on_band(BAND, Outside::Zero))
            .spikes
            .is_empty()
    );
    // A rise towards the table's end with a notch in it (read off a printed curve).
    let notched = [
        1.68, 1.64, 1.83, 1.94, 2.07, 2.13, 2.21, 2.37, 2.13, 2.29, 2.67, 2.67,
    ];
    let rise = (0..239).map(|i| 0.7 + 0.004 * f64::from(i)).chain(notched);
    let rise = Sampled::even(400.0, 1.0, rise.collect()).expect("a rising grid");
    let found = by_default(&rise.on_band(BAND, Outside::Zero)).spikes;
    assert!(found.is_empty(), "{found:?}");
    let below = Band::new(300.0, 380.0).expect("80 nm");
    let fl2 = on_band("cie_fluorescent_1nm/FL2", below);
    assert!(
        detect(below, &fl2, SpikeSettings::default())
            .spikes
            .is_empty()
    );
}

// ------------------------------------------------------------------------------------- noise

fn white_led(nm: f64) -> f64 {
    bell(nm, 450.0, 22.0) + 0.6 * bell(nm, 570.0, 120.0)
}

fn noisy(step_nm: f64, sigma: f64, seed: u64, value: impl Fn(f64) -> f64) -> Sampled {
    let mut chance = Chance(seed);
    let points = (400.0 / step_nm).round() as usize + 1;
    let values = (0..points).map(|i| value(380.0 + step_nm * i as f64) + sigma * chance.normal());
    Sampled::even(380.0, step_nm, values.collect()).expect("a rising grid")
}

#[test]
fn noise_is_no_line() {
    for step_nm in [0.2, 0.38, 1.0, 2.0] {
        for percent in [1.0, 3.0, 5.0, 10.0, 20.0] {
            let counts: Vec<usize> = (0..40)
                .map(|seed| {
                    let led = noisy(step_nm, percent / 100.0, 1000 + seed, white_led);
                    by_default(&led.on_band(BAND, Outside::Zero)).spikes.len()
                })
                .collect();
            let false_ones: usize = counts.iter().sum();
            println!(
                "{percent} % noise in {step_nm} nm steps: {false_ones} false spikes in 40 LEDs"
            );
            assert!(counts.iter().all(|count| *count <= 1), "{counts:?}");
            if percent <= 5.0 {
                assert_eq!(false_ones, 0, "{percent} % in {step_nm} nm steps");
            }
        }
    }
}

#[test]
fn mercury_is_found_in_noise_and_nothing_else() {
    let lines = [
        (404.656, 0.3),
        (435.833, 0.7),
        (546.074, 1.0),
        (576.96, 0.2),
        (579.066, 0.2),
    ];
    for width_nm in [0.8, 1.5, 3.0] {
        let lamp = |nm: f64| {
            let lines = lines.map(|(at, height)| height * bell(nm, at, width_nm));
            0.02 + lines.iter().sum::<f64>()
        };
        for seed in 0..20 {
            let fine = noisy(0.38, 0.01, 77 + seed, lamp);
            let found = by_default(&fine.on_band(BAND, Outside::Zero)).spikes;
            let places: Vec<f64> = found.iter().map(|f| f.spike.at_nm).collect();
            assert_eq!(
                places.len(),
                4,
                "{width_nm} nm wide, seed {seed}: {places:?}"
            );
            for (at_nm, line_nm) in places.iter().zip([404.656, 435.833, 546.074, 578.013]) {
                // A noisy foot of a few nm pulls the centroid of a weak line a little.
                assert!((at_nm - line_nm).abs() < 0.5, "{places:?}");
            }
        }
    }
}

#[test]
fn lines_finer_than_a_nm_keep_their_places() {
    for (at_nm, width_nm, step_nm) in [
        (632.8, 0.05, 0.01),
        (632.8, 0.5, 0.1),
        (404.656, 0.1, 0.05),
        (435.833, 0.1, 0.05),
        (546.074, 0.3, 0.25),
        (589.3, 1.5, 0.38),
    ] {
        let line = noisy(step_nm, 0.0, 1, |nm| 0.01 + bell(nm, at_nm, width_nm));
        let found = by_default(&line.on_band(BAND, Outside::Zero)).spikes;
        assert_eq!(found.len(), 1, "{at_nm}");
        let off = (found[0].spike.at_nm - at_nm).abs();
        assert!(off < 0.05, "{at_nm}: {off}");
    }
    // The sodium doublet is one spike at the centroid of its lines.
    let pair = |nm: f64| 0.01 + bell(nm, 588.995, 0.1) + 0.5 * bell(nm, 589.592, 0.1);
    let found = by_default(&noisy(0.02, 0.0, 1, pair).on_band(BAND, Outside::Zero)).spikes;
    assert_eq!(found.len(), 1);
    let centroid = (588.995 + 0.5 * 589.592) / 1.5;
    assert!((found[0].spike.at_nm - centroid).abs() < 0.05, "{found:?}");
}

#[test]
fn all_lamps_keep_the_promises_at_every_threshold_and_width() {
    for (name, values) in lamps() {
        for threshold in [0.001, 0.005, 0.02, 0.05] {
            for max_width_nm in [2.0, 5.0, 10.0, 20.0] {
                for dips in [false, true] {
                    let settings = SpikeSettings {
                        threshold,
                        max_width_nm,
                        dips,
                    };
                    check_promises(BAND, &values, settings)
                        .unwrap_or_else(|e| panic!("{name} {settings:?}: {e}"));
                }
            }
        }
    }
}

#[test]
fn a_higher_threshold_hardly_ever_finds_more_spikes() {
    let at = |step: u32| 0.001 * 50_f64.powf(f64::from(step) / 100.0);
    let broken: Vec<String> = lamps()
        .iter()
        .filter_map(|(name, values)| {
            let counts = (0..=100).map(|step| {
                let settings = SpikeSettings {
                    threshold: at(step),
                    ..SpikeSettings::default()
                };
                detect(BAND, values, settings).spikes.len()
            });
            let counts: Vec<usize> = counts.collect();
            let rise = counts.windows(2).map(|w| w[1].saturating_sub(w[0])).max()?;
            // Regrouping sets one line free, not many.
            assert!(rise <= 1, "{name}: {counts:?}");
            (rise > 0).then(|| name.clone())
        })
        .collect();
    println!(
        "lamps where some threshold finds one more than a lower one: {} of 137, study 6: {broken:?}",
        broken.len()
    );
    // The study's grid of thresholds is not stated; a finer one meets a few more such places.
    assert!(broken.len() <= 9);
}

// ------------------------------------------------------------------- dips, gradient, hand edits

#[test]
fn absorption_lines_are_left_alone_unless_asked_for() {
    assert!(!SpikeSettings::default().dips && !Settings::default().dips);
    let asked = |threshold, dips| SpikeSettings {
        threshold,
        dips,
        ..SpikeSettings::default()
    };
    // Sunlight's oxygen band at 760-765 nm is a line to the default threshold.
    let sun = on_band(
        "solar_astm_g173/ASTM G173-03 direct+circumsolar AM1.5D",
        BAND,
    );
    let without = detect(BAND, &sun, asked(0.005, false)).spikes;
    let with = detect(BAND, &sun, asked(0.005, true)).spikes;
    let (dips, lines): (Vec<FoundSpike>, Vec<FoundSpike>) =
        with.into_iter().partition(|found| found.spike.weight < 0.0);
    assert_eq!(lines, without);
    assert!(
        dips.len() == 1 && (dips[0].spike.at_nm - 762.8).abs() < 1.0,
        "{dips:?}"
    );
    // Holmium's narrow bands in this powder carry a tenth of that. In a factor what stands up
    // between two dips is no line, and is not looked for.
    let holmium = "usgs_splib07/Holmium oxide powder (USGS splib07a Record 18789)";
    let powder = Factor::keeping_dips(BAND, on_band(holmium, BAND), asked(0.0005, false));
    let places: Vec<f64> = powder.dips().iter().map(|dip| dip.at_nm).collect();
    let known = [464.6, 489.4, 550.5, 637.4, 668.0];
    assert_eq!(places.len(), known.len(), "{places:?}");
    for (found, expected) in places.iter().zip(known) {
        // A nm is less than half the width of any of them.
        assert!((found - expected).abs() < 1.0, "{found}");
    }
    let with_dips = of_kind(Kind::Reflectance).filter(|reflectance| {
        let parts = detect(BAND, &values(reflectance, BAND), asked(0.005, true));
        !parts.spikes.is_empty()
    });
    println!(
        "reflectances that would show dips: {} of {}, study 81 of 455",
        with_dips.count(),
        of_kind(Kind::Reflectance).count()
    );
}

#[test]
fn asking_for_dips_leaves_the_lines_of_every_lamp_as_they_are() {
    for (name, values) in lamps() {
        for (threshold, max_width_nm) in [(0.001, 10.0), (0.002, 10.0), (0.002, 20.0)] {
            let [without, with] = [false, true].map(|dips| {
                let settings = SpikeSettings {
                    threshold,
                    max_width_nm,
                    dips,
                };
                let spikes = detect(BAND, &values, settings).spikes;
                let lines = spikes.into_iter().filter(|found| found.spike.weight > 0.0);
                lines.collect::<Vec<_>>()
            });
            assert_eq!(with, without, "{name} at {threshold}, {max_width_nm} nm");
        }
    }
}

#[test]
fn a_dip_weighs_what_is_missing() {
    let depth = |nm: f64| 0.6 * bell(nm, 450.0, 4.0) + 0.3 * bell(nm, 600.0, 7.0);
    let values: Vec<f64> = BAND.grid().map(|nm| 1.0 - depth(nm)).collect();
    let settings = SpikeSettings {
        threshold: 0.001,
        dips: true,
        ..SpikeSettings::default()
    };
    let parts = detect(BAND, &values, settings);
    let expected = [(450.0, -0.6 * 4.0), (600.0, -0.3 * 7.0)];
    assert_eq!(parts.spikes.len(), expected.len());
    for (found, (at_nm, weight)) in parts.spikes.iter().zip(expected) {
        // The window ends where a bell has 0.04 % of its height left.
        assert!((found.spike.weight / (GAUSSIAN_AREA * weight) - 1.0).abs() < 0.003);
        assert!((found.spike.at_nm - at_nm).abs() < 1e-6, "symmetric");
    }
    // Filled up, the spectrum is flat but for those ends.
    assert!(parts.smooth.iter().all(|v| (v - 1.0).abs() < 0.001));
}

#[test]
fn the_papers_gradient_detector_finds_the_strong_lines_of_fl2() {
    let fl2 = on_band("cie_fluorescent_1nm/FL2", BAND);
    let parts = gradient::detect(BAND, &fl2, DEFAULT_GRADIENT, 10.0, Constraints::default());
    let places: Vec<f64> = parts.spikes.iter().map(|s| s.spike.at_nm).collect();
    println!("FL2 by the gradient: {places:.1?}");
    for line_nm in [404.7, 435.8, 546.1] {
        let near = |nm: &&f64| (**nm - line_nm).abs() < 1.5;
        assert!(places.iter().find(near).is_some(), "{line_nm}: {places:?}");
    }
    for name in ["CIE A", "CIE C", "CIE E"] {
        let smooth = on_band(name, BAND);
        let parts = gradient::detect(
            BAND,
            &smooth,
            DEFAULT_GRADIENT,
            10.0,
            Constraints::default(),
        );
        assert!(parts.spikes.is_empty(), "{name}");
    }
}

fn app_with_fl2() -> App {
    let mut app = plain();
    let fl2 = app.entry("cie_fluorescent_1nm/FL2").expect("shipped");
    app.apply(Command::Show(fl2));
    assert_eq!(app.derived().parts.spikes.len(), 4);
    app
}

fn with_threshold(app: &mut App, threshold_percent: f64) {
    app.apply(Command::Edit(Settings {
        threshold_percent,
        ..app.document().settings
    }));
}

#[test]
fn the_detector_is_chosen_in_the_settings() {
    let mut app = app_with_fl2();
    app.apply(Command::Edit(Settings {
        detector: Detector::Gradient,
        ..app.document().settings
    }));
    let fl2 = on_band("cie_fluorescent_1nm/FL2", BAND);
    let parts = gradient::detect(BAND, &fl2, DEFAULT_GRADIENT, 10.0, Constraints::default());
    assert_eq!(app.derived().parts.smooth, parts.smooth);
}

#[test]
fn a_locked_spike_stays_when_the_threshold_rises_and_changes_nothing_else() {
    let mut app = app_with_fl2();
    let before = Arc::clone(app.derived());
    let index = 3;
    app.act_on_spikes(SpikeAct::Lock { index });
    assert_eq!(app.derived().model, before.model);
    assert_eq!(app.derived().parts.smooth, before.parts.smooth);
    assert_eq!(app.derived().parts.spikes[index].hand, Some(0));

    with_threshold(&mut app, 10.0);
    let kept = app.derived().parts.plain_spikes();
    assert_eq!(kept, [before.model.lines()[index]]);
    app.act_on_spikes(SpikeAct::Unlock { index: 0 });
    assert!(app.derived().parts.spikes.is_empty());
    with_threshold(&mut app, 0.5);
    assert_eq!(app.derived().model, before.model);
}

#[test]
fn a_deleted_spike_gives_its_energy_back() {
    for index in 0..4 {
        let mut app = app_with_fl2();
        let before = Arc::clone(app.derived());
        let gone = before.parts.spikes[index].spike;
        app.act_on_spikes(SpikeAct::Delete { index });
        let after = app.derived();
        assert_eq!(after.parts.spikes.len(), 3);
        let gain = BAND.integral(&after.parts.smooth) - BAND.integral(&before.parts.smooth);
        // Integrals near 2000 in the table's unit, summed over 401 points.
        assert!(
            (gain - gone.weight).abs() < 1e-9,
            "{gain} for {}",
            gone.weight
        );
        // Where the line stands the measured curve is the target again.
        for (i, measured) in after.measured.iter().enumerate() {
            if (BAND.nm(i) - gone.at_nm).abs() < 3.0 {
                assert_eq!(after.parts.smooth[i], *measured);
            }
        }
        // Another threshold does not bring it back; forgetting the edits does.
        with_threshold(&mut app, 0.4);
        let near = |nm: f64| (nm - gone.at_nm).abs() < 3.0;
        assert!(!app.derived().model.lines().iter().any(|s| near(s.at_nm)));
        with_threshold(&mut app, 0.5);
        app.act_on_spikes(SpikeAct::Reset);
        assert_eq!(app.derived().model, before.model);
    }
}

#[test]
fn an_added_spike_takes_its_line_out_of_the_smooth_part() {
    let mut app = app_with_fl2();
    let all = Arc::clone(app.derived());
    let line = all.parts.spikes[0].spike;
    with_threshold(&mut app, 2.5);
    let without = Arc::clone(app.derived());
    assert_eq!(without.parts.spikes.len(), 2, "436 and 546 are above 2.5 %");
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 404.7,
        weight: 30.0,
    });
    let with = app.derived();
    assert_eq!(
        with.parts.spikes.len(),
        3,
        "the line is not found once more"
    );
    let added = with.parts.spikes[0];
    assert_eq!((added.spike.at_nm, added.spike.weight), (404.7, 30.0));
    let taken = BAND.integral(&without.parts.smooth) - BAND.integral(&with.parts.smooth);
    // What is taken out is the line as the detector weighs it, whatever weight was typed. The
    // group's borders differ a little when weaker neighbours count as peaks too.
    assert!(
        (taken / line.weight - 1.0).abs() < 0.03,
        "{taken} {}",
        line.weight
    );

    // Where no line stands there is nothing to take: the spike comes on top.
    let before = Arc::clone(app.derived());
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 650.0,
        weight: 12.0,
    });
    let after = app.derived();
    assert_eq!(after.parts.smooth, before.parts.smooth);
    assert_eq!(after.model.lines().len(), before.model.lines().len() + 1);
    assert_eq!(
        after.parts.spikes.last().expect("just added").width_nm,
        None
    );
}

#[test]
fn moving_or_weighing_a_spike_does_not_change_the_smooth_target() {
    let mut app = app_with_fl2();
    let before = Arc::clone(app.derived());
    for (at_nm, weight) in [(546.1, 80.0), (549.0, 100.0), (560.0, 5.0), (500.0, -20.0)] {
        let found = app.derived().parts.spikes.iter();
        let index = found
            .enumerate()
            .find(|(_, s)| s.hand.is_some() || (s.spike.at_nm - 546.1).abs() < 1.0)
            .map(|(index, _)| index)
            .expect("the line at 546 nm");
        app.act_on_spikes(SpikeAct::Set {
            index,
            at_nm,
            weight,
        });
        let after = app.derived();
        assert_eq!(after.parts.smooth, before.parts.smooth, "at {at_nm}");
        assert_eq!(after.model.smooth(), before.model.smooth());
        let moved = after.model.lines().iter().filter(|s| s.at_nm == at_nm);
        assert_eq!(
            moved.map(|s| s.weight).collect::<Vec<_>>(),
            [weight],
            "one spike where it was put"
        );
        assert_eq!(after.model.lines().len(), 4);
    }
}

/// A smooth ground with one line, as an own light.
fn light_with(line: impl Fn(f64) -> f64) -> Arc<Entry> {
    let values = (380..=780)
        .map(|nm| 1.0 + line(f64::from(nm)))
        .collect::<Vec<_>>();
    let samples = Sampled::even(380.0, 1.0, values).expect("a table");
    let spectrum = NamedSpectrum {
        name: "one line".to_owned(),
        kind: Kind::Light,
        unit: String::new(),
        scale: 1.0,
        samples,
        notes: Vec::new(),
        source: String::new(),
    };
    Arc::new(Entry::own(1, spectrum))
}

fn bump(at_nm: f64, height: f64) -> impl Fn(f64) -> f64 {
    move |nm| height * (-((nm - at_nm) / 1.5).powi(2)).exp()
}

fn energy(app: &App) -> f64 {
    let derived = app.derived();
    let spikes: f64 = derived.parts.spikes.iter().map(|s| s.spike.weight).sum();
    derived.band.integral(&derived.parts.smooth) + spikes
}

#[test]
fn a_locked_line_is_taken_out_by_its_own_sign_whatever_weight_it_was_given() {
    let mut app = plain_about(light_with(bump(430.0, 20.0)));
    let smooth = app.derived().parts.smooth.clone();
    app.act_on_spikes(SpikeAct::Set {
        index: 0,
        at_nm: 430.0,
        weight: -1.0,
    });
    assert_eq!(app.derived().parts.smooth, smooth);
    with_threshold(&mut app, 50.0);
    let after = &app.derived().parts;
    assert_eq!(after.spikes.len(), 1);
    // The same window's hull: nothing but rounding differs.
    for (a, b) in after.smooth.iter().zip(&smooth) {
        assert_abs_diff_eq!(*a, *b, epsilon = 1e-9);
    }
}

#[test]
fn an_absorption_line_added_by_hand_is_taken_out_of_the_smooth_part() {
    let mut app = plain_about(light_with(bump(500.0, -0.8)));
    assert!(app.derived().parts.spikes.is_empty(), "dips are off");
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 500.0,
        weight: -2.0,
    });
    let at = (500.0 - 380.0) as usize;
    // The ground is 1; at the ends of its window, 5 nm off, 2e-5 of the dip is left.
    assert_abs_diff_eq!(app.derived().parts.smooth[at], 1.0, epsilon = 1e-4);
}

#[test]
fn a_range_that_leaves_a_locked_spike_out_loses_no_energy() {
    let mut app = plain_about(light_with(bump(436.0, 20.0)));
    app.act_on_spikes(SpikeAct::Lock { index: 0 });
    let band = Band::new(437.0, 780.0).expect("a range");
    app.apply(Command::Edit(Settings {
        band,
        ..app.document().settings
    }));
    let measured = band.integral(&app.derived().measured);
    // Sums of 344 numbers of order 1 to 20.
    assert_abs_diff_eq!(energy(&app), measured, epsilon = 1e-9);
}

#[test]
fn deleting_a_spike_that_stood_on_no_line_keeps_no_line_away() {
    let mut app = plain_about(light_with(bump(430.0, 20.0)));
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 650.0,
        weight: 5.0,
    });
    let added = app.derived().parts.spikes.len() - 1;
    app.act_on_spikes(SpikeAct::Delete { index: added });
    assert!(app.document().subject_edits().is_empty());
}
