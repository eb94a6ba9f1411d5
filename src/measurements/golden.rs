//! The measurements' golden figures (tests/golden/measurements.json), and the identities that hold
//! whatever the lights are.

use std::sync::LazyLock;

use serde_json::Value;

use super::{
    Figure, Formula, Kernel, Measurement, Options, Quantity, Repeats, Slit, Verdict, changed,
    combine, doubts, draws::normal, repeats::mean_of, resampled, splice, student_95,
};
use crate::{
    color::{Observer, delta_e_of_xyz, xyz::xyz_from_nm_values, xyz_from_xy},
    preset,
    spectrum::{Outside, Sampled},
};

static GOLDEN: LazyLock<Value> = LazyLock::new(|| {
    let text = include_str!("../../tests/golden/measurements.json");
    serde_json::from_str(text).expect("JSON")
});

pub(super) fn cases(of: &str) -> &'static [Value] {
    GOLDEN[of]["cases"].as_array().expect("cases")
}

pub(super) fn numbers(value: &Value) -> Vec<f64> {
    let all = value.as_array().expect("a list").iter();
    all.map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
}

pub(super) fn light(nm: Vec<f64>, values: Vec<f64>) -> Measurement {
    let samples = Sampled::new(nm, values).expect("a table");
    Measurement::new("light", Quantity::Light, "", samples)
}

/// `[first, last, step]` as wavelengths.
pub(super) fn grid(value: &Value) -> Vec<f64> {
    let [first, last, step] = numbers(value)[..] else {
        panic!("three numbers");
    };
    let points = ((last - first) / step).round() as usize + 1;
    (0..points).map(|i| first + step * i as f64).collect()
}

fn of(formula: &str, inputs: &[Measurement], options: Options) -> Measurement {
    let formula = Formula::parse(formula).expect(formula);
    combine(&formula, inputs, options)
        .expect("it means something")
        .result
}

fn close(found: f64, expected: f64, relative: f64, size: f64, what: &str) {
    assert!(
        (found - expected).abs() <= relative * size.max(expected.abs()),
        "{what}: {found} {expected}"
    );
}

fn close_to(found: f64, expected: f64, within: f64, what: &str) {
    assert!(
        (found - expected).abs() <= within,
        "{what}: {found} {expected} {within}"
    );
}

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0_f64, |top, v| top.max(v.abs()))
}

#[test]
fn sums_are_exact_on_the_union_of_both_grids() {
    for case in cases("arithmetic") {
        let side = |key: &str| light(numbers(&case[key]["nm"]), numbers(&case[key]["values"]));
        let inputs = [side("a"), side("b")];
        let k = case["k"].as_f64().expect("a factor");
        for (formula, key) in [
            ("A + B".to_owned(), "sum"),
            (format!("A - {k}*B"), "difference"),
            ("0.5*A + 0.5*B".to_owned(), "mean"),
        ] {
            let found = of(&formula, &inputs, Options::default());
            assert_eq!(found.samples.len(), numbers(&case["union_nm"]).len());
            let expected = numbers(&case[key]);
            let top = peak(&numbers(&case["sum"]));
            for (found, expected) in found.samples.values().iter().zip(&expected) {
                close(*found, *expected, 1e-6, top, key);
            }
            for (found, expected) in found.samples.nm().iter().zip(numbers(&case["union_nm"])) {
                close(*found, expected, 1e-9, 0.0, "nm");
            }
        }
    }
}

#[test]
fn a_quotient_with_a_shared_dark_has_the_golden_mask_sigma_and_absorbance() {
    for case in cases("quotient") {
        let nm = grid(&case["nm"]);
        let counts = |key: &str| {
            let samples = Sampled::new(nm.clone(), numbers(&case[key])).expect("a table");
            let mut counts = Measurement::new(key, Quantity::Counts, "counts", samples);
            counts.sigma = Some(numbers(&case["sigma"][key]));
            counts
        };
        let inputs = [counts("sample"), counts("reference"), counts("dark")];
        let found = of("(A - C) / (B - C)", &inputs, Options::default());
        assert_eq!(found.quantity, Quantity::Transmittance);
        let own: Vec<usize> = (0..nm.len()).map(|i| 4 * i).collect();
        let (t, u) = (
            found.samples.values(),
            found.sigma.as_ref().expect("they had one"),
        );
        let kept = numbers(&case["kept"]);
        let (expected, sigma) = (
            numbers(&case["transmittance"]),
            numbers(&case["sigma_of_it"]),
        );
        for (i, at) in own.iter().enumerate() {
            assert_eq!(found.samples.nm()[*at], nm[i]);
            assert_eq!(found.is_kept(*at), kept[i] == 1.0, "{}", nm[i]);
            if found.is_kept(*at) {
                close(t[*at], expected[i], 1e-6, 0.0, "transmittance");
                close(u[*at], sigma[i], 1e-6, 0.0, "sigma");
            }
        }
        let absorbance = of("-log10((A - C) / (B - C))", &inputs, Options::default());
        assert_eq!(absorbance.quantity, Quantity::Absorbance);
        let expected = numbers(&case["absorbance"]);
        for (i, at) in own.iter().enumerate() {
            assert_eq!(absorbance.is_kept(*at), !expected[i].is_nan(), "{}", nm[i]);
            if absorbance.is_kept(*at) {
                close(
                    absorbance.samples.values()[*at],
                    expected[i],
                    1e-6,
                    1.0,
                    "absorbance",
                );
            }
        }
    }
}

#[test]
fn a_table_seen_through_a_slit_is_the_golden_integral() {
    for case in cases("slit_forward") {
        let table = light(numbers(&case["nm"]), numbers(&case["values"]));
        let shape = Kernel::from_word(case["shape"].as_str().expect("a word")).expect("a shape");
        let slit = Slit {
            shape,
            fwhm_nm: case["fwhm"].as_f64().expect("a width"),
        };
        let expected = numbers(&case["smoothed"]);
        for (at, expected_value) in numbers(&case["at_nm"]).iter().zip(&expected) {
            let (first, weights) = slit.weights(table.samples.nm(), *at);
            let values = &table.samples.values()[first..];
            let found: f64 = weights.iter().zip(values).map(|(w, v)| w * v).sum();
            close(found, *expected_value, 1e-5, peak(&expected), "seen");
        }
    }
}

fn scans(nm: &[f64], values: &Value) -> Vec<Measurement> {
    let rows = values.as_array().expect("scans").iter();
    rows.map(|row| light(nm.to_vec(), numbers(row))).collect()
}

#[test]
fn repeats_tell_the_golden_level_axis_noise_and_doubt() {
    for case in cases("repeats") {
        let name = case["name"].as_str().expect("a name");
        let nm = grid(&case["nm"]);
        let found = Repeats::of(&scans(&nm, &case["scans"])).expect("five scans");
        let number = |key: &str| case[key].as_f64().expect(key);
        close(found.level_sd, number("level_sd"), 0.02, 0.0, name);
        close(found.axis_sd_nm, number("axis_sd_nm"), 0.02, 1e-4, name);
        for (i, expected) in numbers(&case["white_sigma_every_20_nm"])
            .into_iter()
            .enumerate()
        {
            close(found.sigma[20 * i], expected, 0.03, 0.0, name);
        }
        assert_eq!(found.mean.memory.len() + 1, numbers(&case["memory"]).len());
        for doubted in doubts(&found.mean) {
            let key = doubted.figure.key();
            let what = format!("{name} {key}");
            let expected = &case["figures"][key];
            let expected = |part: &str| expected[part].as_f64().expect(&what);
            let doubt = doubted.doubt.expect(&what);
            let u = expected("u");
            close(doubt.u, u, 0.05, 0.0, &format!("{what} u"));
            close(
                doubt.half_width_95,
                expected("half_width_95"),
                0.06,
                0.0,
                &what,
            );
            // The figures themselves: the study's tables of test colours are of 5 nm, straight
            // lines between them, where CIE 13.3 has Sprague's curve.
            let of_the_mean = expected("of_the_mean");
            let tables = match doubted.figure {
                Figure::Ra => 0.1,
                Figure::R9 => 0.7,
                Figure::Rf => 0.02,
                Figure::Cct => 0.1,
                _ => 0.0,
            };
            close_to(doubt.of_the_table, of_the_mean, 0.02 * u + tables, &what);
            close_to(
                doubt.bias,
                expected("bias"),
                0.05 * u.max(expected("bias").abs()),
                &what,
            );
        }
    }
}

#[test]
fn a_cut_light_is_spliced_to_half_a_delta_e_and_its_factor_to_two_of_its_doubts() {
    for case in cases("splice") {
        let name = case["name"].as_str().expect("a name");
        let part = |key: &str| light(grid(&case[key]["nm"]), numbers(&case[key]["values"]));
        let found = splice(&part("first"), &part("second"), false).expect(name);
        let gain = case["gain_of_second"].as_f64().expect("a gain");
        let off = found.factor * gain - 1.0;
        assert!(
            off.abs() <= 2.0 * found.u + 1e-9,
            "{name}: off by {off}, u {}",
            found.u
        );
        let xyz = |samples: &Sampled| {
            let values = samples.on_whole_nm(360, 830, Outside::Zero);
            let xyz = xyz_from_nm_values(&values, Observer::CIE_1931);
            xyz.with_y(100.0).expect("it shines")
        };
        let [x, y] = numbers(&case["true_xy"])[..] else {
            panic!("x and y");
        };
        let expected = xyz_from_xy([x, y], 100.0).expect("a colour");
        let difference =
            delta_e_of_xyz(xyz(&found.result.samples), expected, expected).expect("a light");
        assert!(difference <= 0.5, "{name}: {difference}");
    }
}

#[test]
fn two_sets_of_one_light_are_the_same_and_a_tilt_of_6_percent_is_found() {
    for case in cases("pairs") {
        let name = case["name"].as_str().expect("a name");
        let nm = grid(&case["nm"]);
        let (a, b) = (scans(&nm, &case["a"]), scans(&nm, &case["b"]));
        let found = changed(&a, &b).expect(name);
        let expected = match case["what"].as_str() {
            Some("nothing") => Verdict::Same,
            _ => Verdict::Different,
        };
        assert_eq!(found.verdict, expected, "{name}: {:?}", found.parts);
        assert!(found.least_seen_percent > 0.0);
    }
}

/// A lamp with lines on 380-780 nm, and the noise of a scan of it.
fn noisy(name: &str, seed: u64, share: f64) -> Measurement {
    let lamp = preset::table("cie_fluorescent_1nm", name).expect("a shipped lamp");
    let sigma = share * peak(lamp.values());
    let values = lamp
        .values()
        .iter()
        .zip(normal(seed))
        .map(|(v, e)| v + sigma * e);
    let mut found = light(lamp.nm().to_vec(), values.collect());
    found.sigma = Some(vec![sigma; found.samples.len()]);
    found
}

#[test]
fn a_less_a_is_nothing_and_its_doubt_is_nothing() {
    let a = noisy("FL2", 1, 1e-3);
    let found = of("A - A", std::slice::from_ref(&a), Options::default());
    assert!(found.samples.values().iter().all(|v| *v == 0.0));
    assert!(found.sigma.expect("it had one").iter().all(|s| *s == 0.0));
    // Two files of it are two scans.
    let found = of("A - B", &[a.clone(), a], Options::default());
    assert!(found.sigma.expect("they had one").iter().all(|s| *s > 0.0));
}

#[test]
fn a_over_b_times_b_is_a_where_b_is_above_its_noise() {
    let (a, b) = (noisy("FL2", 1, 1e-3), noisy("FL3.9", 2, 1e-3));
    let found = of("A / B * B", &[a.clone(), b.clone()], Options::default());
    let kept = found.kept_values();
    let at = found.samples.nm().iter().zip(&kept);
    let top = peak(a.samples.values());
    let mut seen = 0;
    for (nm, value) in at {
        if let Some(value) = value {
            seen += 1;
            close(*value, a.samples.at(*nm, Outside::Zero), 1e-12, top, "a");
        }
    }
    assert!(
        seen > kept.len() / 2 && seen < kept.len(),
        "{seen} of {}",
        kept.len()
    );
    // Nothing masked is told where it is asked to keep all.
    let all = Options {
        keep_all: true,
        ..Options::default()
    };
    assert!(of("A / B", &[a, b], all).mask.is_empty());
}

#[test]
fn the_mean_of_one_is_itself_and_one_scan_has_no_spread() {
    let one = noisy("FL2", 1, 1e-3);
    assert_eq!(mean_of(std::slice::from_ref(&one)), Ok(one.clone()));
    let why = Repeats::of(&[one]).expect_err("one scan").to_string();
    assert_eq!(
        why,
        "One scan has no spread. Add two more, or state the instrument's noise."
    );
}

#[test]
fn a_cut_spectrum_is_spliced_to_itself() {
    let whole = noisy("FL2", 1, 0.0).samples;
    let cut = |from: usize, to: usize, by: f64| {
        let values = whole.values()[from..to].iter().map(|v| by * v).collect();
        light(whole.nm()[from..to].to_vec(), values)
    };
    let found = splice(&cut(0, 241, 1.0), &cut(200, 401, 2.0), false).expect("40 nm");
    close(found.factor, 0.5, 1e-9, 0.0, "factor");
    for (found, expected) in found.result.samples.values().iter().zip(whole.values()) {
        close(*found, *expected, 1e-6, peak(whole.values()), "value");
    }
    let why = splice(&cut(0, 201, 1.0), &cut(193, 401, 1.0), false).expect_err("8 nm");
    assert_eq!(
        why.to_string(),
        "A ends at 580 nm and B begins at 573 nm: they share 7 nm; 20 are needed."
    );
    let apart = splice(&cut(0, 201, 1.0), &cut(220, 401, 1.0), false).expect_err("apart");
    assert_eq!(
        apart.to_string(),
        "A ends at 580 nm and B begins at 600 nm: they share no wavelengths."
    );
}

/// Scans of a lamp with level 1 %, axis 0.1 nm and white or remembered noise.
fn simulated(kernel: &[f64], snr: f64, count: usize, seed: u64) -> Vec<Measurement> {
    let lamp = preset::table("cie_led_1nm", "LED-B3").expect("a shipped lamp");
    let inside: Vec<f64> = (380..=780).map(f64::from).collect();
    let top = peak(lamp.values());
    let mut noise = normal(seed);
    let size = kernel.iter().map(|k| k * k).sum::<f64>().sqrt();
    let scan = |_| {
        let (g, d) = (
            0.01 * noise.next().unwrap_or(0.0),
            0.1 * noise.next().unwrap_or(0.0),
        );
        let raw: Vec<f64> = noise
            .by_ref()
            .take(inside.len() + kernel.len() - 1)
            .collect();
        let values = inside.iter().enumerate().map(|(i, nm)| {
            let e: f64 = kernel.iter().zip(&raw[i..]).map(|(k, e)| k * e).sum();
            (1.0 + g) * lamp.at(nm - d, Outside::Hold) + e * top / snr / size
        });
        light(inside.clone(), values.collect())
    };
    (0..count).map(scan).collect()
}

#[test]
fn nineteen_of_twenty_intervals_hold_the_true_figure_with_white_noise_and_with_memory() {
    let lamp = preset::table("cie_led_1nm", "LED-B3").expect("a shipped lamp");
    let inside: Vec<f64> = (380..=780).map(f64::from).collect();
    let values = inside
        .iter()
        .map(|nm| lamp.at(*nm, Outside::Hold))
        .collect();
    let truth = doubts(&light(inside, values));
    for kernel in [&[1.0][..], &[0.5, 0.8, 1.0, 0.8, 0.5]] {
        let mut held = 0;
        let mut all = 0;
        for seed in 0..40 {
            let repeats = Repeats::of(&simulated(kernel, 100.0, 5, 100 + seed)).expect("five");
            assert_eq!(kernel.len() == 1, repeats.mean.memory.len() < 2, "{seed}");
            for (found, truth) in doubts(&repeats.mean).iter().zip(&truth) {
                let (Some(doubt), Some(truth)) = (found.doubt, truth.doubt) else {
                    panic!("{:?}", found.figure);
                };
                all += 1;
                held +=
                    usize::from((doubt.value - truth.of_the_table).abs() <= doubt.half_width_95);
            }
        }
        let share = held as f64 / f64::from(all);
        // 320 intervals that hold .95 each, in 40 independent sets: .90 to .99.
        assert!(
            (0.90..=0.995).contains(&share),
            "{} lags: {share}",
            kernel.len()
        );
    }
}

#[test]
fn a_quotient_brought_back_to_whole_nm_keeps_the_doubt_of_its_sums() {
    let a = noisy("FL2", 1, 1e-3);
    let mut glass = a.clone();
    glass.quantity = Quantity::Transmittance;
    glass.samples = a
        .samples
        .sharing(vec![0.5; a.samples.len()])
        .expect("as many");
    glass.sigma = None;
    let seen = of("A * B", &[a.clone(), glass], Options::default());
    assert_eq!(seen.quantity, Quantity::Light);
    assert!(seen.samples.len() > 4 * (a.samples.len() - 1));
    let back = resampled(&seen, a.samples.nm(), 1.0).expect("inside");
    close(
        back.samples.values()[200],
        0.5 * a.samples.values()[200],
        1e-12,
        0.0,
        "half",
    );
    let (of_a, of_seen) = (doubts(&a), doubts(&seen));
    for (a, seen) in of_a.iter().zip(&of_seen) {
        let (Some(a), Some(b)) = (a.doubt, seen.doubt) else {
            panic!("{:?}", seen.figure);
        };
        let half = if seen.figure == Figure::Y { 0.5 } else { 1.0 };
        // Points between samples are interpolated noise, which is a little less.
        close(b.u, half * a.u, 0.2, 0.0, seen.figure.key());
    }
    assert!(student_95(4.0) > 2.7);
}
