//! What the encoder promises of any light.

use proptest::prelude::*;
use spectral_explorer::{
    color::Observer,
    io::read_path,
    lamps::{
        Ask, Count, Encoder, EncodingError, EvaluationSet, Ingredients, encode_json, from_words,
        judged, known_lamps, read_encoding,
    },
    preset,
    spectrum::{Band, Basis, BasisTable, Kind, Line, Outside, Sampled, SpikeSettings, add_lines},
    study::{FitBasis, ProjectedSpectrum},
};

const BAND: Band = Band::VISIBLE;

fn encoder() -> &'static Encoder {
    static ENCODER: std::sync::LazyLock<Encoder> = std::sync::LazyLock::new(|| {
        Encoder::new(BAND, Observer::CIE_1931, SpikeSettings::default()).expect("the visible")
    });
    &ENCODER
}

fn shipped(group: &str, name: &str) -> Vec<f64> {
    preset::table(group, name)
        .expect("a shipped lamp")
        .on_band(BAND, Outside::Zero)
}

/// Lines alone, spikes on nothing, steps, what no table knows.
fn hostile() -> Vec<(&'static str, Vec<f64>)> {
    let dark = || vec![0.0; BAND.points()];
    let with = |lines: &[(f64, f64, f64)]| {
        let mut values = dark();
        for (at_nm, weight, width_nm) in lines {
            add_lines(
                BAND,
                &[Line {
                    at_nm: *at_nm,
                    weight: *weight,
                    fwhm_nm: *width_nm,
                }],
                &mut values,
            );
        }
        values
    };
    // Lines at places and of weights that nobody chose.
    let random = |count: u64, seed: u64| {
        let mut state = seed;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as f64 / (1_u64 << 31) as f64
        };
        let line = |_| (400.0 + 300.0 * next(), 0.05 + next(), 0.0);
        let lines: Vec<(f64, f64, f64)> = (0..count).map(line).collect();
        with(&lines)
    };
    let bulb = |nm: f64| (560.0 / nm).powi(5) / ((1.4388e7 / (2850.0 * nm)).exp_m1());
    let neodymium = BAND.grid().map(|nm| {
        let notch = |at: f64, width: f64, depth: f64| {
            1.0 - depth * (-4.0 * std::f64::consts::LN_2 * ((nm - at) / width).powi(2)).exp()
        };
        1e9 * bulb(nm) * notch(584.0, 16.0, 0.95) * notch(527.0, 14.0, 0.5)
    });
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
        ("3 random lines", random(3, 1)),
        ("7 random lines", random(7, 2)),
        ("11 random lines", random(11, 3)),
        ("15 random lines", random(15, 4)),
        (
            "three lasers",
            with(&[(445.0, 1.0, 0.0), (532.0, 1.2, 0.0), (638.0, 1.5, 0.0)]),
        ),
        (
            "three bands",
            with(&[(450.0, 1.0, 25.0), (540.0, 1.3, 30.0), (610.0, 1.4, 25.0)]),
        ),
        ("neodymium glass", neodymium.collect()),
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
    let judge = EvaluationSet::judging(BAND, Observer::CIE_1931);
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
            let encoded = judged(encoder(), &judge, &values, (&chosen.encoding, ask.numbers))
                .expect("small numbers");
            assert_eq!(encoded.words.len(), encoded.encoding.numbers());
            assert_eq!(
                from_words(&encoded.words, BAND).expect("our own words"),
                encoded.encoding
            );
            // The last three of the numbers to be rounded are left with their own rounding.
            assert!(encoded.own < 1e-6, "{name} {ask:?}: {}", encoded.own);
            let json = encode_json(&encoded);
            let (back, words) = read_encoding(&json.to_string(), Some(BAND)).expect("our own JSON");
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
    let judge = EvaluationSet::judging(BAND, Observer::CIE_1931);
    let encoded = judged(encoder(), &judge, &values, (&chosen.encoding, 20));
    let json = encode_json(&encoded.expect("small numbers"));
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
        [
            "atoms",
            "cosine",
            "error",
            "lines",
            "numbers",
            "range_nm",
            "strict_numbers",
            "words"
        ]
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
fn a_range_without_the_centre_of_a_filter_is_encoded_and_no_filter_is_off() {
    let lamp = preset::table("cie_fluorescent_1nm", "FL2").expect("a shipped lamp");
    for last_nm in [415.0, 419.0, 424.0] {
        let band = Band::new(380.0, last_nm).expect("a band");
        let encoder = Encoder::new(band, Observer::CIE_1931, SpikeSettings::default());
        let encoder = encoder.expect("its end tells X, Y and Z apart");
        let values = lamp.on_band(band, Outside::Zero);
        let encoded = encoder.encode(&values, Ask::numbers(11)).expect("a light");
        assert!(encoded.errors.filters.is_finite(), "{last_nm}");
    }
}

#[test]
fn a_shipped_lamp_is_itself_and_nothing_else() {
    let values = shipped("lamps_nist_philips", "F32T8/TL841 (Triphosphor)");
    let chosen = encoder()
        .encode(&values, Ask::numbers(11))
        .expect("a light");
    let makeup = Ingredients::of(&chosen.encoding);
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

/// The errors of an encoding and of a colour-exact cosine series of as many numbers.
fn beside_a_cosine_series(
    judge: &EvaluationSet,
    values: &[f64],
    ask: Ask,
) -> Option<[[f64; 3]; 2]> {
    let exact = judge.exact(values)?;
    let chosen = encoder().encode(values, ask).expect("a light");
    let decoder = encoder().decoder();
    let decoded = decoder.decode(&chosen.encoding).expect("a spectrum");
    let fit = FitBasis::new(BAND, Basis::Cosine, ask.numbers, &judge.measures().seen);
    let projected = ProjectedSpectrum::new(&fit, values, &[], &judge.measures().seen);
    let series = projected.smooth(&projected.model(ask.numbers, &[], true).0);
    let patches = judge.patches_as_cosines(ask.numbers);
    let errors = |values: &[f64]| judge.errors(&exact, values, &patches).to_array();
    Some([errors(&decoded), errors(&series)])
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[test]
fn hostile_lights_are_nearer_than_by_a_cosine_series_but_not_all_of_them() {
    let judge = EvaluationSet::judging(BAND, Observer::CIE_1931);
    let ask = Ask::numbers(20).in_comparison();
    let all: Vec<[[f64; 3]; 2]> = hostile()
        .iter()
        .filter_map(|(name, values)| {
            let found = beside_a_cosine_series(&judge, values, ask)?;
            println!("{name}: {:.3?} against {:.3?}", found[0], found[1]);
            Some(found)
        })
        .collect();
    assert_eq!(all.len(), hostile().len());
    for error in 0..3 {
        let of = |who: usize| median(all.iter().map(|found| found[who][error]).collect());
        let [ours, series] = [of(0), of(1)];
        println!("median {ours:.3} against {series:.3}");
        // The reference found, on 26 such lights, .087, .67, .033 against .12, 14, .38.
        assert!(
            ours < series && (error == 0 || ours < 0.3 * series),
            "{ours} {series}"
        );
    }
}

fn unit(values: &[f64]) -> Vec<f64> {
    let norm = values.iter().map(|v| v * v).sum::<f64>().sqrt();
    values.iter().map(|v| v / norm).collect()
}

/// The greatest cosine of a light with any known lamp.
pub(crate) fn likeness_to_known(values: &[f64]) -> f64 {
    let atoms = encoder().decoder().atoms().iter();
    let cosines = atoms.map(|atom| cosine(&unit(&atom.values), &unit(values)));
    cosines.fold(0.0, f64::max)
}

fn cosine(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Lights in the files of others, where they are at hand: none that is shipped or like one.
pub(crate) fn files_of_others() -> Vec<(String, Vec<f64>)> {
    let folder = super::root::root().join("../shared/data/real_files");
    let Ok(listed) = std::fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut paths: Vec<_> = listed.filter_map(|item| Some(item.ok()?.path())).collect();
    paths.sort();
    let mut found: Vec<(String, Vec<f64>)> = Vec::new();
    for path in paths.iter().filter(|path| path.is_file()) {
        let Ok(reading) = read_path(path) else {
            continue;
        };
        for spectrum in reading.spectra.iter().filter(|s| s.kind == Kind::Light) {
            let table = &spectrum.samples;
            let is_fine = table.len() > 80 && table.values().iter().all(|v| v.is_finite());
            if !is_fine || table.first_nm() > 380.0 || table.last_nm() < 780.0 {
                continue;
            }
            let values = unit(&table.on_band(BAND, Outside::Zero));
            let mut others = found.iter().map(|(_, values)| values);
            let is_new = others.all(|other| cosine(other, &values) < 0.9999)
                && likeness_to_known(&values) < 0.9999;
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if is_new && encoder().panel().exact(&values).is_some() {
                found.push((format!("{name}#{}", spectrum.name), values));
            }
        }
    }
    found
}

#[test]
fn measured_lamps_of_others_are_nearer_than_by_a_cosine_series() {
    let judge = EvaluationSet::judging(BAND, Observer::CIE_1931);
    let lamps = files_of_others();
    for numbers in [11, 20, 31].into_iter().filter(|_| !lamps.is_empty()) {
        let ask = Ask::numbers(numbers).in_comparison();
        let mut all = Vec::new();
        for (name, values) in &lamps {
            let found = beside_a_cosine_series(&judge, values, ask).expect("a light");
            println!(
                "{numbers} {name}: {:.4?} against {:.4?}",
                found[0], found[1]
            );
            if name.starts_with("Osram.HQIT") && numbers == 20 {
                // The reference's figures of this lamp, in photons as its file has it. Ours are
                // .092, 1.05 and .055: in all a third more.
                let ratio = found[0].iter().product::<f64>() / (0.093 * 0.94 * 0.046);
                println!("{ratio:.2} times the reference's product");
                assert!(ratio <= 1.5, "{:?}", found[0]);
            }
            all.push(found);
        }
        for error in 0..3 {
            let of = |who: usize| median(all.iter().map(|found| found[who][error]).collect());
            let [ours, series] = [of(0), of(1)];
            println!(
                "{numbers}: {} lamps, median {ours:.4} against {series:.4}",
                lamps.len()
            );
            assert!(ours < series, "{numbers}: {ours} {series}");
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
    let refused = Encoder::new(infrared, Observer::CIE_1931, SpikeSettings::default());
    assert_eq!(
        refused.err(),
        Some(EncodingError::Unseen { band: infrared })
    );
}

#[test]
fn another_range_and_another_observer_are_encoded_too() {
    let band = Band::new(400.0, 700.0).expect("300 nm");
    let encoder =
        Encoder::new(band, Observer::CIE_1964, SpikeSettings::default()).expect("the visible");
    let values = preset::table("lamps_nist_philips", "F32T8/TL841 (Triphosphor)")
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

/// Lamps that somebody measured and that are not shipped.
pub(crate) fn measured_lamps() -> Vec<(String, Vec<f64>)> {
    let text = include_str!("../golden/measured_lamps.json");
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
    let judge = EvaluationSet::judging(BAND, Observer::CIE_1931);
    // The errors taken together as the choice takes them: patches ^ .5 filters ^ 1.25 blurred ^ 1.25.
    let together = |e: [f64; 3]| e[0].sqrt() * (e[1] * e[2]).powf(1.25);
    for (name, values) in measured_lamps() {
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
