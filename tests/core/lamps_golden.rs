//! The reference encodings and the known lamps, as computed independently.

use serde_json::Value;
use spectral_explorer::{
    color::Observer,
    lamps::{Ask, AtomWeight, Decoder, Encoder, Encoding, EvaluationSet, atoms_on},
    preset,
    spectrum::{Band, Basis, Line, Outside, Series, SpikeSettings},
};

const BAND: Band = Band::VISIBLE;

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("a golden file")
}

fn items() -> Vec<Value> {
    let file = json(include_str!("../golden/reference_encodings.json"));
    file["items"].as_array().expect("items").clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .expect("a list")
        .iter()
        .map(number)
        .collect()
}

/// The stored width that a width of five decimals stands for.
fn stored_width(width_nm: f64) -> f64 {
    if width_nm == 0.0 {
        return 0.0;
    }
    let step = (254.0 * (width_nm / 2.0).ln() / 45.0_f64.ln()).round();
    2.0 * 45.0_f64.powf(step / 254.0)
}

/// The reference's encoding of an item.
fn encoding(item: &Value) -> Encoding {
    let list = |key: &str| item[key].as_array().expect("a list").clone();
    Encoding {
        atoms: list("atoms")
            .iter()
            .map(|a| AtomWeight {
                index: number(&a[0]) as u8,
                weight: number(&a[1]),
            })
            .collect(),
        smooth: Series {
            band: BAND,
            basis: Basis::Cosine,
            coefficients: numbers(&item["cosine"]),
        },
        lines: list("lines")
            .iter()
            .map(|l| Line {
                at_nm: number(&l[0]),
                fwhm_nm: stored_width(number(&l[1])),
                weight: number(&l[2]),
            })
            .collect(),
        way: None,
    }
}

/// The item's lamp with Y = 1.
fn lamp(item: &Value) -> Vec<f64> {
    let word = |key: &str| item[key].as_str().expect("a word");
    let table = preset::table(word("group"), word("name")).expect("a shipped lamp");
    let values = table.on_band(BAND, Outside::Zero);
    let seen = Observer::CIE_1931.table().on_band(BAND);
    let y = BAND.inner(&values, &seen[1]);
    values.iter().map(|v| v / y).collect()
}

#[test]
fn every_known_lamp_has_the_values_of_the_reference() {
    let file = json(include_str!("../golden/known_lamps_check.json"));
    let checks = file["check"].as_array().expect("a list");
    let atoms = atoms_on(BAND);
    assert_eq!(atoms.len(), checks.len());
    for (atom, check) in atoms.iter().zip(checks) {
        for (at, expected) in [20, 56, 166, 230, 320].into_iter().zip(numbers(check)) {
            let found = atom.values[at];
            // The reference has nine decimals.
            assert!(
                (found - expected).abs() < 6e-10,
                "{} at {at}: {found} {expected}",
                atom.index
            );
        }
    }
}

#[test]
fn the_reference_encodings_decode_to_their_errors() {
    let (panel, decoder) = (
        EvaluationSet::judging(BAND, Observer::CIE_1931),
        Decoder::new(BAND),
    );
    for item in items() {
        let count = number(&item["P"]) as usize;
        let encoding = encoding(&item);
        assert_eq!(encoding.numbers(), count);
        let exact = panel.exact(&lamp(&item)).expect("a light");
        let values = decoder.decode(&encoding).expect("a spectrum");
        let errors = panel.errors(&exact, &values, &panel.patches_as_cosines(count));
        let name = item["name"].as_str().expect("a name");
        let expected = &item["error"];
        let plain = plain_sum_blurred(&values, &lamp(&item));
        // Nine digits of the numbers and the printed digits of the errors: 0.4 % and half a digit,
        // as the reference says of itself. It blurs with plain sums and takes negative X, Y, Z as
        // none; with the trapezoid rule of the house the ends show by up to 3 %, and where a lamp is
        // dark (low-pressure sodium) negative X, Y, Z count here.
        for (found, key, share, digit) in [
            (errors.patches, "patches_ces99", 0.004, 1e-5),
            (
                clipped_filters(&values, &lamp(&item)),
                "filters_425_675",
                0.004,
                1e-5,
            ),
            (plain, "relative_rms_10nm", 0.004, 1e-6),
            (errors.blurred, "relative_rms_10nm", 0.03, 1e-6),
        ] {
            let expected = number(&expected[key]);
            let allowed = share * expected + 0.6 * digit;
            assert!(
                (found - expected).abs() <= allowed,
                "{name} {count} {key}: {found} {expected}"
            );
        }
    }
}

/// Relative RMS behind a 10 nm blur with plain sums over the grid, as the reference sums it.
fn plain_sum_blurred(model: &[f64], lamp: &[f64]) -> f64 {
    let sigma = 10.0 / 2.354_820_045;
    let tap = |d: f64| (-0.5 * (d / sigma).powi(2)).exp();
    let square = |values: &[f64]| -> f64 {
        let at = |i: usize| -> f64 {
            let terms = values.iter().enumerate();
            terms.map(|(j, v)| v * tap(i as f64 - j as f64)).sum()
        };
        (0..values.len()).map(|i| at(i).powi(2)).sum()
    };
    let rest: Vec<f64> = model.iter().zip(lamp).map(|(a, b)| a - b).collect();
    (square(&rest) / square(lamp)).sqrt()
}

#[test]
fn the_encoder_reaches_the_references_errors() {
    let encoder =
        Encoder::new(BAND, Observer::CIE_1931, SpikeSettings::default()).expect("the visible");
    let panel = EvaluationSet::judging(BAND, Observer::CIE_1931);
    let mut log_sum = 0.0;
    for item in items() {
        let count = number(&item["P"]) as usize;
        let light = lamp(&item);
        let ask = Ask::numbers(count).in_comparison();
        let chosen = encoder.encode(&light, ask).expect("a light");
        let exact = panel.exact(&light).expect("a light");
        let values = encoder
            .decoder()
            .decode(&chosen.encoding)
            .expect("a spectrum");
        let errors = panel.errors(&exact, &values, &panel.patches_as_cosines(count));
        let expected = &item["error"];
        let theirs = [
            ("patches_ces99", 1e-5),
            ("filters_425_675", 1e-5),
            ("relative_rms_10nm", 1e-6),
        ]
        .map(|(key, digit)| number(&expected[key]).max(digit));
        let ours = [
            errors.patches.max(1e-5),
            errors.filters.max(1e-5),
            errors.blurred.max(1e-6),
        ];
        let ratio: f64 = ours.iter().product::<f64>() / theirs.iter().product::<f64>();
        // The reference's words: an encoder is right when the product of its three errors is at most
        // 1.3 times these. Errors below its last printed digit count as that digit.
        let name = item["name"].as_str().expect("a name");
        assert!(ratio <= 1.3, "{name} {count}: {ours:?} against {theirs:?}");
        // Three sums of 401 products, the largest of them cancelled by up to 1e4 (sodium).
        assert!(
            chosen.own < 1e-9,
            "{name} {count}: own colour off by {}",
            chosen.own
        );
        assert!(chosen.encoding.numbers() <= count);
        log_sum += ratio.ln();
    }
    // Taken together it is not worse than the reference at all.
    assert!(log_sum <= 0.0, "{log_sum}");
}

/// Mean CIEDE2000 behind the judging band-passes, negative X, Y, Z taken as none.
fn clipped_filters(model: &[f64], lamp: &[f64]) -> f64 {
    use spectral_explorer::color::{Xyz, delta_e_2000, lab_from_xyz};
    let seen = Observer::CIE_1931.table().on_band(BAND);
    let xyz = |v: &[f64]| Xyz::from_array(seen.each_ref().map(|row| BAND.inner(v, row)));
    let white = xyz(lamp);
    let mut sum = 0.0;
    for i in 0..26 {
        let c = 425.0 + 10.0 * f64::from(i);
        let behind = |v: &[f64]| -> Vec<f64> {
            v.iter()
                .enumerate()
                .map(|(k, v)| {
                    v * (-4.0 * std::f64::consts::LN_2 * ((BAND.nm(k) - c) / 10.0).powi(2)).exp()
                })
                .collect()
        };
        let a = xyz(&behind(lamp));
        let gain = (0.5 * white.y / a.y.max(0.0)).min(50.0);
        let clip = |x: Xyz| Xyz::new(x.x.max(0.0), x.y.max(0.0), x.z.max(0.0));
        sum += delta_e_2000(
            lab_from_xyz(a * gain, white),
            lab_from_xyz(clip(xyz(&behind(model)) * gain), white),
        );
    }
    sum / 26.0
}
