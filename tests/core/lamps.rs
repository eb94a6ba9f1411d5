//! What the encoder promises of any light.

use std::sync::Arc;

use proptest::prelude::*;
use spectral_explorer::{
    color::{Observer, PatchSet},
    lamps::{
        Ask, Count, Encoder, EncodingError, Entrant, LeaveOut, Makeup, Panel, Spike, Standing,
        add_spikes, encode_json, from_words, judged, known_lamps, race, race_json, read_encoding,
        table,
    },
    preset::{Group, SHIPPED, Shelf},
    rivals::PrincipalBasis,
    spectrum::{Band, Basis, BasisTable, Kind, Outside, Sampled, SpikeSettings},
    study::{
        Measures, Progress,
        race::{Course, Lamp},
        training::{Teacher, Training},
    },
};

const BAND: Band = Band::VISIBLE;

fn encoder() -> &'static Encoder {
    static ENCODER: std::sync::LazyLock<Encoder> = std::sync::LazyLock::new(|| {
        Encoder::new(BAND, Observer::Cie1931, SpikeSettings::default()).expect("the visible")
    });
    &ENCODER
}

fn shipped(group: &str, name: &str) -> Vec<f64> {
    table(group, name)
        .expect("a shipped lamp")
        .on_band(BAND, Outside::Zero)
}

/// The shipped lamps of four classes.
fn lamps() -> Vec<Lamp> {
    let groups = SHIPPED
        .iter()
        .filter_map(|text| Group::from_json(text).ok());
    let mut lamps = Vec::new();
    for preset in groups.flat_map(|group| group.items) {
        let class = match preset.shelf {
            Shelf::Standard | Shelf::Sun => "smooth",
            Shelf::Led => "LED",
            Shelf::Fluorescent => "fluorescent",
            Shelf::Discharge => "discharge",
            _ => continue,
        };
        if let Some(spectrum) = preset.spectrum().filter(|s| s.kind == Kind::Light) {
            lamps.push(Lamp {
                name: spectrum.name.clone(),
                class: class.to_owned(),
                values: spectrum.samples.on_band(BAND, Outside::Zero),
            });
        }
    }
    lamps
}

/// Lines alone, spikes on nothing, steps, what no table knows.
fn hostile() -> Vec<(&'static str, Vec<f64>)> {
    let dark = || vec![0.0; BAND.points()];
    let with = |lines: &[(f64, f64, f64)]| {
        let mut values = dark();
        for (at_nm, weight, width_nm) in lines {
            add_spikes(
                BAND,
                &[Spike {
                    at_nm: *at_nm,
                    weight: *weight,
                    width_nm: *width_nm,
                }],
                &mut values,
            );
        }
        values
    };
    let mercury = [404.7, 435.8, 546.1, 577.0, 579.1, 690.7].map(|nm| (nm, 1.0, 0.0));
    let comb: Vec<(f64, f64, f64)> = (0..15)
        .map(|i| (390.0 + 25.7 * f64::from(i), 1.0 + f64::from(i % 4), 2.5))
        .collect();
    let mut step = dark();
    step[180..].iter_mut().for_each(|v| *v = 1.0);
    let noisy: Vec<f64> = (0..401_u64)
        .map(|i| 1.0 + (i.wrapping_mul(2_654_435_761) % 1000) as f64 * 4e-4)
        .collect();
    vec![
        ("delta", with(&[(546.0, 1.0, 0.0)])),
        ("delta between", with(&[(589.3, 1.0, 0.0)])),
        ("laser in the red", with(&[(650.0, 1.0, 0.0)])),
        ("six mercury lines", with(&mercury)),
        ("fifteen lines", with(&comb)),
        ("step", step),
        ("deep red LED", with(&[(740.0, 1.0, 20.0)])),
        ("noise", noisy),
        (
            "at the ends",
            with(&[(380.0, 1.0, 0.0), (555.0, 1e-3, 0.0), (780.0, 1.0, 5.0)]),
        ),
    ]
}

#[test]
fn a_light_is_decoded_from_its_words_with_its_own_colour() {
    let judge = Panel::judging(BAND, Observer::Cie1931);
    for (group, name) in [
        ("cie_fluorescent_1nm", "FL2"),
        ("cie_led_1nm", "LED-B3"),
        ("lamps_nist_traditional", "HPS"),
        ("cie_illuminants", "CIE D65"),
    ] {
        let values = shipped(group, name);
        for ask in [
            Ask::numbers(20),
            Ask::numbers(20).portable(),
            Ask::numbers(11).in_comparison(),
        ] {
            let chosen = encoder().encode(&values, ask).expect("a light");
            assert!(chosen.encoding.numbers() <= ask.numbers);
            let encoded =
                judged(encoder(), &judge, &values, &chosen.encoding).expect("small numbers");
            assert_eq!(encoded.words.len(), encoded.encoding.numbers());
            assert_eq!(
                from_words(&encoded.words, BAND).expect("our own words"),
                encoded.encoding
            );
            // The last three of the numbers to be rounded are left with their own rounding.
            assert!(encoded.own < 1e-6, "{name} {ask:?}: {}", encoded.own);
            let json = encode_json(&encoded);
            let (back, words) = read_encoding(&json.to_string(), BAND).expect("our own JSON");
            assert_eq!((back, words), (encoded.encoding, encoded.words));
            assert!(ask.known_lamps || json["atoms"].as_array().is_some_and(Vec::is_empty));
        }
    }
}

#[test]
fn the_json_has_the_keys_of_the_command() {
    let values = shipped("cie_fluorescent_1nm", "FL11");
    let chosen = encoder()
        .encode(&values, Ask::numbers(20).in_comparison())
        .expect("a light");
    let judge = Panel::judging(BAND, Observer::Cie1931);
    let json =
        encode_json(&judged(encoder(), &judge, &values, &chosen.encoding).expect("small numbers"));
    let keys = |value: &serde_json::Value| -> Vec<String> {
        let mut keys: Vec<String> = value
            .as_object()
            .expect("an object")
            .keys()
            .cloned()
            .collect();
        keys.sort();
        keys
    };
    assert_eq!(
        keys(&json),
        ["atoms", "cosine", "error", "lines", "numbers", "words"]
    );
    assert_eq!(
        keys(&json["error"]),
        [
            "delta_e_own",
            "filters",
            "patches_check",
            "relative_rms_10nm"
        ]
    );
    assert_eq!(keys(&json["atoms"][0]), ["name", "weight"]);
    assert_eq!(keys(&json["lines"][0]), ["at_nm", "fwhm_nm", "weight"]);
    assert_eq!(
        json["words"].as_array().map(Vec::len),
        json["numbers"].as_u64().map(|n| n as usize)
    );
}

#[test]
fn a_shipped_lamp_is_itself_and_nothing_else() {
    let values = shipped("lamps_nist_philips", "F32T8/TL841 (Triphosphor)");
    let chosen = encoder()
        .encode(&values, Ask::numbers(11))
        .expect("a light");
    let makeup = Makeup::of(&chosen.encoding);
    let part = makeup
        .parts
        .iter()
        .find(|p| p.title.contains("TL841"))
        .expect("the lamp itself");
    // All of its power but what rounding leaves to the others.
    assert!(
        (part.share.expect("a power") - 1.0).abs() < 1e-3,
        "{}",
        makeup.in_words()
    );
}

#[test]
fn hostile_lights_have_an_encoding_with_their_own_colour() {
    for (name, values) in hostile() {
        for numbers in [3, 4, 7, 11, 20, 31, 41, 64] {
            let chosen = encoder()
                .encode(&values, Ask::numbers(numbers))
                .unwrap_or_else(|e| panic!("{name}: {e}"));
            assert!(chosen.encoding.numbers() <= numbers, "{name} {numbers}");
            let errors = chosen.errors.to_array();
            assert!(
                errors.iter().all(|e| e.is_finite()),
                "{name} {numbers} {errors:?}"
            );
            let is_exact = chosen.encoding.way.is_none_or(|way| way.colour_exact);
            // Reds without Z make b* of rounding: a share of 1e-16 of the light over 1e-5 of Z.
            assert!(
                !is_exact || chosen.own < 1e-7,
                "{name} {numbers} {}",
                chosen.own
            );
        }
    }
}

#[test]
fn numbers_have_the_scale_of_the_light() {
    let values = shipped("cie_fluorescent_1nm", "FL4");
    let (one, many) = (encoder().encode(&values, Ask::numbers(20)), {
        let scaled: Vec<f64> = values.iter().map(|v| v * 1024.0).collect();
        encoder().encode(&scaled, Ask::numbers(20))
    });
    // A power of two changes no digit of anything.
    assert_eq!(
        one.expect("a light").encoding.scaled(1024.0),
        many.expect("a light").encoding
    );
}

#[test]
fn what_cannot_be_encoded_is_refused_in_words() {
    let said = |values: &[f64], numbers: usize| {
        encoder()
            .encode(values, Ask::numbers(numbers))
            .expect_err("nothing to encode")
            .to_string()
    };
    let flat = vec![1.0; 401];
    assert_eq!(said(&flat, 2), "numbers: expected 3 to 64, found 2");
    assert_eq!(said(&flat, 65), "numbers: expected 3 to 64, found 65");
    assert_eq!(
        said(&flat[1..], 20),
        "expected 401 values, one a nm, found 400"
    );
    assert_eq!(
        said(&vec![0.0; 401], 20),
        "expected light that the eye sees within 380-780 nm, found none"
    );
    let mut odd = flat.clone();
    odd[6] = f64::NAN;
    assert_eq!(said(&odd, 20), "value 7: expected a finite number");
    let infrared = Band::new(900.0, 1000.0).expect("100 nm");
    let refused = Encoder::new(infrared, Observer::Cie1931, SpikeSettings::default());
    assert_eq!(
        refused.err(),
        Some(EncodingError::Unseen { band: infrared })
    );
}

#[test]
fn another_range_and_another_observer_are_encoded_too() {
    let band = Band::new(400.0, 700.0).expect("300 nm");
    let encoder =
        Encoder::new(band, Observer::Cie1964, SpikeSettings::default()).expect("the visible");
    let values = table("lamps_nist_philips", "F32T8/TL841 (Triphosphor)")
        .expect("shipped")
        .on_band(band, Outside::Zero);
    let chosen = encoder
        .encode(&values, Ask::numbers(20).in_comparison())
        .expect("a light");
    assert!(
        chosen.own < 1e-9 && chosen.errors.blurred < 0.05,
        "{chosen:?}"
    );
    assert!(chosen.encoding.lines.iter().all(|l| band.contains(l.at_nm)));
}

#[test]
fn the_same_light_has_the_same_bits_on_any_thread() {
    let values = shipped("cie_fluorescent_1nm", "FL8");
    let encode = || {
        encoder()
            .encode(&values, Ask::numbers(20).in_comparison())
            .expect("a light")
    };
    let first = encode();
    std::thread::scope(|scope| {
        let both = [scope.spawn(encode), scope.spawn(encode)];
        for other in both {
            assert_eq!(other.join().expect("no panic"), first);
        }
    });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_light_with_a_colour_keeps_it(seed in prop::collection::vec(0.0_f64..1.0, 12), numbers in 3_usize..50) {
        let values: Vec<f64> = BAND.grid().map(|nm| {
            let x = (nm - 380.0) / 400.0 * 11.0;
            let i = (x as usize).min(10);
            seed[i] + (seed[i + 1] - seed[i]) * (x - i as f64) + 0.01
        }).collect();
        let chosen = encoder().encode(&values, Ask::numbers(numbers).in_comparison()).expect("a light");
        prop_assert!(chosen.encoding.numbers() <= numbers);
        let is_exact = chosen.encoding.way.is_none_or(|way| way.colour_exact);
        prop_assert!(!is_exact || chosen.own < 1e-9);
    }
}

/// A race of some of the shipped lamps.
fn standing(rule: (Count, LeaveOut), every: usize) -> Standing {
    let all = lamps();
    let teachers: Vec<Teacher> = all
        .iter()
        .map(|l| Teacher {
            name: l.name.clone(),
            class: l.class.clone(),
            values: l.values.clone(),
        })
        .collect();
    let groups: Vec<Group> = SHIPPED
        .iter()
        .filter_map(|text| Group::from_json(text).ok())
        .collect();
    let taught: Vec<Vec<f64>> = groups
        .iter()
        .filter(|g| g.id == "aces_training_190" || g.id == "pmc_chart")
        .flat_map(|g| &g.items)
        .filter_map(|p| p.spectrum())
        .map(|s| s.samples.on_band(BAND, Outside::Hold))
        .collect();
    let white = vec![1.0; BAND.points()];
    let patches = PatchSet::new(
        std::slice::from_ref(&white),
        vec![String::new()],
        BAND,
        Observer::Cie1931,
    );
    let course = Course {
        measures: Arc::new(Measures::new(patches)),
        patches: Vec::new(),
        check: Vec::new(),
        lights: Arc::new(Training::new(BAND, &teachers, 41)),
        reflectances: Arc::new(PrincipalBasis::train(BAND, &taught, 41)),
        spikes: SpikeSettings::default(),
        budgets: vec![11, 20],
    };
    let some: Vec<Lamp> = all.into_iter().step_by(every).collect();
    race(&course, &some, encoder(), rule, &Progress::default())
        .expect("counts in range")
        .expect("not cancelled")
}

fn told(standing: &Standing) {
    for peer in Entrant::ALL.into_iter().skip(2) {
        for ours in [Entrant::KnownLamps, Entrant::WideLines] {
            let wins = standing.wins(ours, peer);
            println!(
                "{:?} {} against {}: {} of {}",
                standing.leave_out,
                ours.word(),
                peer.word(),
                wins.won(),
                wins.of
            );
            for cell in wins.behind.iter().filter(|_| ours == Entrant::KnownLamps) {
                println!("   {cell:?}");
            }
        }
    }
}

#[test]
fn in_the_race_known_lamps_win_nearly_every_cell() {
    // A fifth of the shipped lamps. LINES.md found all cells on lamps that are not shipped; here every
    // table is trained on the lamps that race, each without the one at hand.
    for (leave_out, least) in [(LeaveOut::Itself, 95.0), (LeaveOut::Likes, 90.0)] {
        let standing = standing((Count::Words, leave_out), 5);
        told(&standing);
        for family in ["samples", "bins", "moments", "principal"] {
            let peer = Entrant::ALL
                .into_iter()
                .find(|e| e.word() == family)
                .expect("a peer");
            let per_cent = standing
                .wins(Entrant::KnownLamps, peer)
                .per_cent()
                .expect("cells");
            assert!(per_cent >= least, "{leave_out:?} {family}: {per_cent}");
        }
    }
}

#[test]
fn the_race_in_json_has_a_row_for_each_way() {
    let standing = standing((Count::Strict, LeaveOut::Likes), 25);
    let json = race_json(&standing);
    let words: Vec<&str> = json["rows"]
        .as_array()
        .expect("rows")
        .iter()
        .filter_map(|r| r["representation"].as_str())
        .collect();
    assert!(words.contains(&"known-lamps") && words.contains(&"wide-lines"));
}

#[test]
fn a_cancelled_race_has_no_result() {
    let progress = Progress::default();
    progress.cancel();
    let values = shipped("cie_fluorescent_1nm", "FL2");
    let lamp = Lamp {
        name: "FL2".to_owned(),
        class: "fluorescent".to_owned(),
        values,
    };
    let white = vec![1.0; BAND.points()];
    let patches = PatchSet::new(
        std::slice::from_ref(&white),
        vec![String::new()],
        BAND,
        Observer::Cie1931,
    );
    let course = Course {
        measures: Arc::new(Measures::new(patches)),
        patches: Vec::new(),
        check: Vec::new(),
        lights: Arc::new(Training::new(BAND, &[], 11)),
        reflectances: Arc::new(PrincipalBasis::train(BAND, &[white], 11)),
        spikes: SpikeSettings::default(),
        budgets: vec![11],
    };
    assert_eq!(
        race(
            &course,
            &[lamp],
            encoder(),
            (Count::Words, LeaveOut::Likes),
            &progress
        ),
        Ok(None)
    );
}

/// Lamps that somebody measured and that are not shipped.
fn measured(text: &str) -> Vec<(String, Vec<f64>)> {
    let file: serde_json::Value = serde_json::from_str(text).expect("a file of lamps");
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        value
            .as_array()
            .expect("a list")
            .iter()
            .filter_map(serde_json::Value::as_f64)
            .collect()
    };
    let lamps = file["lamps"].as_array().expect("lamps");
    lamps
        .iter()
        .map(|lamp| {
            let sampled =
                Sampled::new(numbers(&lamp["nm"]), numbers(&lamp["values"])).expect("a table");
            (
                lamp["name"].as_str().expect("a name").to_owned(),
                sampled.on_band(BAND, Outside::Zero),
            )
        })
        .collect()
}

#[test]
fn measured_lamps_that_are_not_shipped_are_encoded_better_than_by_a_cosine_series() {
    let judge = Panel::judging(BAND, Observer::Cie1931);
    // The errors taken together as the choice takes them: patches ^ .5 filters ^ 1.25 blurred ^ 1.25.
    let together = |e: [f64; 3]| e[0].sqrt() * (e[1] * e[2]).powf(1.25);
    for (name, values) in measured(include_str!("../golden/measured_lamps.json")) {
        let exact = judge.exact(&values).expect("a light");
        for numbers in [11, 20, 31] {
            let errors_of = |ask: Ask| {
                let chosen = encoder().encode(&values, ask).expect("a light");
                let decoded = encoder()
                    .decoder()
                    .decode(&chosen.encoding)
                    .expect("a spectrum");
                judge
                    .errors(&exact, &decoded, &judge.patches_as_cosines(numbers))
                    .to_array()
            };
            let (known, wide) = (
                errors_of(Ask::numbers(numbers)),
                errors_of(Ask::numbers(numbers).portable()),
            );
            let basis = BasisTable::new(BAND, Basis::Cosine, numbers);
            let plain = basis.evaluate(&basis.project(&values, numbers));
            let plain = judge
                .errors(&exact, &plain, &judge.patches_as_cosines(numbers))
                .to_array();
            for ours in [known, wide] {
                assert!(
                    together(ours) < together(plain),
                    "{name} {numbers}: {ours:?} {plain:?}"
                );
            }
            // With a lamp that resembles it, it is not worse in anything.
            assert!(
                known.iter().zip(plain).all(|(a, b)| *a < b),
                "{name} {numbers}: {known:?} {plain:?}"
            );
        }
    }
}

#[test]
fn strictly_counted_an_encoding_has_room_for_its_indices_and_widths() {
    let values = shipped("cie_fluorescent_1nm", "FL2");
    let ask = Ask {
        count: Count::Strict,
        ..Ask::numbers(20).in_comparison()
    };
    let encoding = encoder().encode(&values, ask).expect("a light").encoding;
    assert!(
        encoding.strict_numbers() <= 20,
        "{}",
        encoding.strict_numbers()
    );
    assert!(known_lamps().len() > 100);
}
