//! Colour against independent references: published tables and other libraries' results.
//!
//! The reference numbers are in `tests/data`, each file with its source and conventions.

use std::{collections::BTreeMap, fs};

use super::root::root;
use serde::{Deserialize, de::DeserializeOwned};
use spectral_explorer::{
    color::{
        Lab, Mapping, Observer, Swatch, Xyz, cct_from_xyz, delta_e_2000, gaussian_cmf,
        lab_from_xyz, srgb, uv_1976_from_xyz, xy_from_xyz, xyz_from_light, xyz_from_reflectance,
    },
    spectrum::{Band, Outside, Sampled},
};

fn read<T: DeserializeOwned>(path: &str) -> T {
    let full = root().join(path);
    let text = fs::read_to_string(&full).unwrap_or_else(|e| panic!("{path}: {e}"));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The largest deviation seen, and where.
#[derive(Default)]
struct Worst {
    size: f64,
    place: String,
}

impl Worst {
    fn see(&mut self, found: f64, expected: f64, place: &str) {
        let size = (found - expected).abs();
        assert!(!size.is_nan(), "{place}: not a number");
        if size > self.size {
            (self.size, self.place) = (size, place.to_owned());
        }
    }

    fn see_all(&mut self, found: &[f64], expected: &[f64], place: &str) {
        assert_eq!(found.len(), expected.len());
        for (f, e) in found.iter().zip(expected) {
            self.see(*f, *e, place);
        }
    }

    #[track_caller]
    fn within(&self, tolerance: f64, what: &str) {
        println!("{what}: {:.3e} at {}", self.size, self.place);
        assert!(
            self.size <= tolerance,
            "{what}: off by {:e} at {}, allowed {tolerance:e}",
            self.size,
            self.place
        );
    }
}

// ---------------------------------------------------------------- presets, read as plain JSON

#[derive(Deserialize)]
struct PresetFile {
    group: String,
    items: Vec<Preset>,
}

#[derive(Deserialize)]
struct Preset {
    name: String,
    wavelengths: Wavelengths,
    values: Vec<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Wavelengths {
    Even { first_nm: f64, step_nm: f64 },
    List { list_nm: Vec<f64> },
}

fn presets(group: &str) -> BTreeMap<String, Sampled> {
    let file: PresetFile = read(&format!("presets/{group}.json"));
    assert_eq!(file.group, group);
    file.items
        .into_iter()
        .map(|item| {
            let table = match item.wavelengths {
                Wavelengths::Even { first_nm, step_nm } => {
                    Sampled::even(first_nm, step_nm, item.values)
                }
                Wavelengths::List { list_nm } => Sampled::new(list_nm, item.values),
            };
            (item.name, table.unwrap())
        })
        .collect()
}

// ---------------------------------------------------------------- lamps

#[derive(Deserialize)]
struct LampColours {
    lamps: Vec<LampColour>,
}

#[derive(Deserialize)]
struct LampColour {
    group: String,
    name: String,
    xyz_1931: [f64; 3],
    xyz_1964: [f64; 3],
    xy_1931: [f64; 2],
    xy_1964: [f64; 2],
    uv_1976: [f64; 2],
    cct_meaningful: bool,
    cct: f64,
    duv: f64,
    cct_exact: f64,
    duv_exact: f64,
    srgb_linear: [f64; 3],
    srgb_encoded: [f64; 3],
    srgb_8bit: [u8; 3],
}

fn lamps() -> Vec<(LampColour, Sampled)> {
    let golden: LampColours = read("tests/data/lamp_colours.json");
    let mut groups = BTreeMap::new();
    golden
        .lamps
        .into_iter()
        .map(|lamp| {
            let group = groups
                .entry(lamp.group.clone())
                .or_insert_with_key(|group| presets(group));
            let light = group
                .get(&lamp.name)
                .unwrap_or_else(|| panic!("{}: no {:?}", lamp.group, lamp.name))
                .clone();
            (lamp, light)
        })
        .collect()
}

fn light_xyz(light: &Sampled, observer: Observer) -> Xyz {
    xyz_from_light(light, Outside::Zero, observer).unwrap()
}

#[test]
fn all_lamps_have_the_tristimulus_values_and_chromaticities_of_the_reference() {
    let (mut xyz, mut xy, mut uv) = (Worst::default(), Worst::default(), Worst::default());
    let mut fine = Worst::default();
    let lamps = lamps();
    assert_eq!(lamps.len(), 119);
    for (lamp, light) in &lamps {
        let of_1931 = light_xyz(light, Observer::CIE_1931);
        // The sun's tables step by 0.5 nm up to 400 nm: the reference picks every second sample,
        // here all of them count.
        if light
            .nm()
            .windows(2)
            .any(|w| w[1] < 400.0 && w[1] - w[0] < 1.0)
        {
            fine.see_all(&of_1931.to_array(), &lamp.xyz_1931, &lamp.name);
            continue;
        }
        let of_1964 = light_xyz(light, Observer::CIE_1964);
        xyz.see_all(&of_1931.to_array(), &lamp.xyz_1931, &lamp.name);
        xyz.see_all(&of_1964.to_array(), &lamp.xyz_1964, &lamp.name);
        xy.see_all(&xy_from_xyz(of_1931).unwrap(), &lamp.xy_1931, &lamp.name);
        xy.see_all(&xy_from_xyz(of_1964).unwrap(), &lamp.xy_1964, &lamp.name);
        uv.see_all(
            &uv_1976_from_xyz(of_1931).unwrap(),
            &lamp.uv_1976,
            &lamp.name,
        );
    }
    // What half the samples of 20 nm at the end of the visible do to 100.
    fine.within(2e-3, "XYZ of the sun");
    // Two libraries agree to 3e-13; the reference is stored with ten digits of numbers near 100.
    xyz.within(1e-6, "XYZ");
    // Stored with eight decimals.
    xy.within(1e-8, "xy");
    uv.within(1e-8, "u'v'");
}

#[test]
fn all_lamps_have_the_colour_temperature_and_duv_of_the_reference() {
    let (mut cct, mut duv) = (Worst::default(), Worst::default());
    let (mut cct_exact, mut duv_exact) = (Worst::default(), Worst::default());
    for (lamp, light) in lamps() {
        let found = cct_from_xyz(light_xyz(&light, Observer::CIE_1931));
        if !lamp.cct_meaningful {
            assert!(found.is_err(), "{}", lamp.name);
            continue;
        }
        let found = found.unwrap();
        cct.see(found.kelvin, lamp.cct, &lamp.name);
        duv.see(found.duv, lamp.duv, &lamp.name);
        cct_exact.see(found.kelvin, lamp.cct_exact, &lamp.name);
        duv_exact.see(found.duv, lamp.duv_exact, &lamp.name);
    }
    // The same method with the table's entries elsewhere; libraries differ by up to 0.04 K.
    cct.within(0.1, "CCT");
    duv.within(1e-6, "Duv");
    // Against a search for the nearest point itself: the chord of 0.1 % steps.
    cct_exact.within(0.1, "CCT by exact distance");
    duv_exact.within(1e-6, "Duv by exact distance");
}

#[test]
fn all_lamps_have_the_screen_colour_of_the_reference() {
    let (mut linear, mut encoded) = (Worst::default(), Worst::default());
    for (lamp, light) in lamps() {
        let xyz = light_xyz(&light, Observer::CIE_1931);
        let found = srgb::linear_from_xyz(xyz * 0.01);
        linear.see_all(&found, &lamp.srgb_linear, &lamp.name);
        let swatch = Swatch::of_light(xyz);
        encoded.see_all(&swatch.encoded, &lamp.srgb_encoded, &lamp.name);
        assert_eq!(swatch.mapping, Mapping::ScaledToMaximum);
        let negative = lamp.srgb_linear.iter().any(|v| *v < 0.0);
        assert_eq!(swatch.in_gamut, !negative, "{}", lamp.name);
        for (found, expected) in swatch.rgb8.0.into_iter().zip(lamp.srgb_8bit) {
            // 5e-4 of 255 is 0.13, which may turn one rounding.
            assert!(found.abs_diff(expected) <= 1, "{}", lamp.name);
        }
    }
    // The reference used the matrix that the standard prints rounded to four digits.
    linear.within(5e-4, "linear sRGB");
    encoded.within(5e-4, "encoded sRGB");
}

// ---------------------------------------------------------------- patches

#[derive(Deserialize)]
struct PatchColours {
    patches: Vec<PatchColour>,
}

#[derive(Deserialize)]
struct PatchColour {
    patch: String,
    light: String,
    xyz_1931: [f64; 3],
    lab_1931: [f64; 3],
    xyz_1964: [f64; 3],
    lab_1964: [f64; 3],
}

#[test]
fn the_colour_chart_has_the_lab_values_of_the_reference_under_seven_lights() {
    let golden: PatchColours = read("tests/data/colorchecker_colours.json");
    assert_eq!(golden.patches.len(), 7 * 24);
    let reflectances = presets("colorchecker_ohta");
    let lights: BTreeMap<String, Sampled> = [
        "cie_illuminants",
        "cie_fluorescent_5nm",
        "cie_hp_5nm",
        "cie_led_5nm",
    ]
    .into_iter()
    .flat_map(presets)
    .collect();
    let (mut xyz, mut lab) = (Worst::default(), Worst::default());
    for row in golden.patches {
        let place = format!("{} under {}", row.patch, row.light);
        let (reflectance, light) = (&reflectances[&row.patch], &lights[&row.light]);
        for (observer, golden_xyz, golden_lab) in [
            (Observer::CIE_1931, row.xyz_1931, row.lab_1931),
            (Observer::CIE_1964, row.xyz_1964, row.lab_1964),
        ] {
            let seen = xyz_from_reflectance(reflectance, light, observer).unwrap();
            xyz.see_all(&seen.to_array(), &golden_xyz, &place);
            let Lab { l, a, b } = lab_from_xyz(seen, light_xyz(light, observer));
            lab.see_all(&[l, a, b], &golden_lab, &place);
        }
    }
    // Libraries agree to 3e-13 and 1e-12; the reference is stored with seven decimals of Lab.
    xyz.within(1e-6, "XYZ of patches");
    lab.within(1e-6, "Lab of patches");
}

// ---------------------------------------------------------------- colour difference

#[derive(Deserialize)]
struct Sharma {
    pairs: Vec<SharmaPair>,
}

#[derive(Deserialize)]
struct SharmaPair {
    lab_1: [f64; 3],
    lab_2: [f64; 3],
    delta_e_published: f64,
    delta_e_computed: f64,
}

#[test]
fn the_34_pairs_of_sharma_wu_and_dalal_have_their_published_differences() {
    let golden: Sharma = read("tests/data/ciede2000_sharma.json");
    assert_eq!(golden.pairs.len(), 34);
    let (mut published, mut computed) = (Worst::default(), Worst::default());
    for (index, pair) in golden.pairs.iter().enumerate() {
        let place = format!("pair {}", index + 1);
        let [one, other] = [pair.lab_1, pair.lab_2].map(|[l, a, b]| Lab::new(l, a, b));
        let found = delta_e_2000(one, other);
        assert_eq!(found, delta_e_2000(other, one), "{place}");
        published.see(found, pair.delta_e_published, &place);
        computed.see(found, pair.delta_e_computed, &place);
    }
    // Published with four decimals.
    published.within(5e-5, "CIEDE2000, published");
    // Stored with ten digits of numbers up to 100.
    computed.within(1e-8, "CIEDE2000, computed");
}

// ---------------------------------------------------------------- the paper's Gaussian fit

#[derive(Deserialize)]
struct PaperFourier {
    functions: Vec<PaperFunction>,
}

#[derive(Deserialize)]
struct PaperFunction {
    min_nm: f64,
    max_nm: f64,
    function: String,
    a: Vec<f64>,
    b: Vec<f64>,
}

#[test]
fn the_gaussian_fit_has_the_fourier_coefficients_of_the_corrected_equation_10() {
    let golden: PaperFourier = read("tests/data/paper_gaussian_fourier.json");
    assert_eq!(golden.functions.len(), 6);
    let mut worst = Worst::default();
    for row in golden.functions {
        let band = Band::new(row.min_nm, row.max_nm).unwrap();
        let k = ["xbar", "ybar", "zbar"]
            .iter()
            .position(|name| *name == row.function)
            .unwrap();
        for order in 0..=10 {
            let found = gaussian_cmf::fitted_fourier(order, band)[k];
            worst.see_all(&found, &[row.a[order], row.b[order]], &row.function);
        }
    }
    // The same closed form; phases of up to 60 radians carry some 1e-14.
    worst.within(1e-13, "Eq. 10");
}
