//! Readers against files that others wrote, and against rubbish.
//!
//! The real files lie outside the project under licences of their own; where their folder is not
//! there, these stories say so and pass.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::own_time::own_seconds;
use crate::root::root;
use proptest::prelude::*;
use serde_json::Value;
use spectral_explorer::io::{Guessed, Reading, read_bytes, read_path};
use spectral_explorer::spectrum::{Kind, NamedSpectrum, SpectralImage};

/// Files that must read to the reference reading.
const MUST_MATCH: &[&str] = &[
    "library_berlin.hdr",
    "optimized.sli.hdr",
    "cubus_gamsberg_subset.hdr",
    "uv.jdx",
    "OceanOptics_period.jdx",
    "TM27_Sample_Spectral_Data.spdx",
    "cie.stdillum.F11.spd",
    "macbeth-1.spd",
    "Au.eta.spd",
    "ESPD2021_0104_231446.xls",
    "licor-li1800-q-irrad.PRN",
    "Osram.HQIT.400W.PRN",
    "macam-e-irrad.DTA",
    "ZERO-1.DTA",
    "optronics-OL731.txt",
    "Bentham_01_and_12.csv",
    "OOusb4000.txt",
    "OO_comma.txt",
    "OceanView_nonEN.txt",
    "LEDWhitesPlusCanaryYellow.txt",
    "J_MUR_MARS_17_0001.ttt",
    "avasoft8.txt",
    "CRAIC_export.txt",
    "UQG-UG1-2mm.CSV",
    "Cherry_3C01_GT.csv",
    "Yellow_101.csv",
    "solux-4700K-stoft.csv",
    "aster-Rpc-drygrass.txt",
    "a.spectrum.txt",
    "bkr1mm074ws.txt",
    "ribb00001.asd.txt",
    "asd-e-irrad-sky.csv2",
    "gr070214_003.sig",
    "CIE_illum_FLs.csv",
    "F8.sp",
    "Office.sp",
    "example.sp",
    "argyll_refl_leather.sp",
    "argyll_amb_copybox.sp",
    "DELL_UP2516D_i1Pro2.ccss",
    "CIE-TCS.sp",
    "RANDOM_001_02._3262K.csv",
];

/// Files that must read, with the number of spectra and of points in the first.
const MUST_READ: &[(&str, usize, usize)] = &[
    ("Cu.k.spd", 1, 56),
    ("mitsuba_Au.eta.spd", 1, 56),
    ("mitsuba_Ag.k.spd", 1, 56),
    ("cie_d65_5nm.spdx", 1, 95),
    ("library_berlin.sli", 75, 177),
    ("optimized.sli", 313, 180),
    ("cubus_gamsberg_subset", 0, 0),
    ("D65.exr", 1, 97),
    ("Ohta1997.exr", 24, 16),
    ("BiSpectral.exr", 0, 0),
    ("FBH450-10.xlsx", 2, 0),
    ("FBH660-10.xlsx", 2, 0),
    ("HELIFURC_BR_278_282.jdx", 3, 3648),
    ("Johnson.yml", 3, 49),
    ("psi-spectrapen-SP.csv", 12, 256),
    ("CIE_a-opic_action_spectra.csv", 5, 226),
    ("linss2_10e_5.csv", 3, 89),
    ("colorchecker_n_ohta_transposed.csv", 24, 81),
    ("test.csv", 1, 16),
    ("Clear_115um.txt", 1, 911),
    ("Betula_leaf_yellow_2010_1006_1_LICOR.csv", 4, 0),
    ("Quercus_leaf_sun_2010_0802_1_LICOR.csv", 4, 0),
    ("BW-007-Clear-MRC-nano-1.2mm-46mm-ABS.CSV", 1, 911),
    ("jazspec.jaz", 1, 2048),
    ("FMNH6834.00000001.Master.Transmission", 1, 3648),
    ("avantes_export2.trt", 1, 0),
    ("feather_1.TXT", 1, 0),
    ("cvars_grape_leaf1_lc_rg_01236.sed", 1, 2151),
    ("iso7589_stutung_380_780_5.json", 1, 81),
    ("licor-li180-irrad.txt", 1, 0),
    ("flu1.txt", 1, 181),
    ("X-Rite_Digital_Colour_Checker.txt", 10, 36),
    (
        "splib07a_Brick_GDS355_Paving_Dk_Gry_ASDFRa_AREF.txt",
        1,
        2151,
    ),
    ("wasatch-enlighten-scope.json", 1, 1024),
    ("NeonSNQ043_iR785_OP01.txt", 1, 1006),
    ("qtuv-default.txt", 4, 140),
];

/// Files that hold no spectrum, or one of a format refused by its name, and words of the refusal.
const MUST_REFUSE: &[(&str, &str)] = &[
    ("Invalid.spdx", "expected <IESTM2714>"),
    ("argyll_output_read1.txt", "what Argyll's spotread printed"),
    ("bad-input-test.txt", "expected"),
    ("sekonic_c-700_5392K.csv", "a Sekonic summary"),
    ("FReDflowerID_157.dx", "web page"),
    ("OceanOptics.spc", "Galactic"),
    ("difdup_example.jdx", "MILLISECONDS"),
    ("default.ti3", "175 sets with no spectral columns"),
];

fn folder() -> Option<PathBuf> {
    let folder = root().join("../shared/data/real_files");
    if folder.is_dir() {
        Some(folder)
    } else {
        eprintln!("skipped: {} is not there", folder.display());
        None
    }
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

/// Files of single precision whose reference was summed in single precision: right to 1e-7 only.
const SUMMED_IN_SINGLE: [&str; 2] = ["optimized.sli.hdr", "cubus_gamsberg_subset.hdr"];

/// Whether a spectrum is the reference's: points, ends with their values, the largest value and
/// where it is, and the sum, all in the file's own numbers.
fn matches(spectrum: &NamedSpectrum, series: &Value, sum_tolerance: f64) -> bool {
    let number = |key: &str| series[key].as_f64().unwrap_or(f64::NAN);
    let samples = &spectrum.samples;
    let own: Vec<f64> = samples
        .values()
        .iter()
        .map(|v| v / spectrum.scale)
        .collect();
    let sum: f64 = own.iter().sum();
    let max = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // Equal largest values may stand at several wavelengths.
    let is_max =
        |(nm, value): (&f64, &f64)| close(*nm, number("wl_at_max")) && close(*value, number("max"));
    samples.len() as f64 == number("n")
        && close(samples.first_nm(), number("first_wl"))
        && close(samples.last_nm(), number("last_wl"))
        && close(own[0], number("first_value"))
        && close(own[own.len() - 1], number("last_value"))
        && close(max, number("max"))
        && samples.nm().iter().zip(&own).any(is_max)
        && (sum - number("sum_values")).abs() <= sum_tolerance * sum.abs()
}

/// "matches", "expected otherwise" or "no reference".
fn verdict(name: &str, reading: &Reading, expected: &Value) -> &'static str {
    let single = SUMMED_IN_SINGLE.contains(&name);
    let sum_tolerance = if single { 1e-7 } else { 1e-9 };
    match expected["series"].as_array() {
        None => "no reference",
        Some(series) => {
            let probes: Vec<_> = reading
                .images
                .iter()
                .flat_map(SpectralImage::probes)
                .collect();
            let all = || reading.spectra.iter().chain(&probes);
            let found = |one| all().any(|s| matches(s, one, sum_tolerance));
            if !series.is_empty() && series.iter().all(found) {
                "matches"
            } else {
                "expected otherwise"
            }
        }
    }
}

#[test]
fn every_real_file_is_read_or_refused_in_one_line_that_names_it() {
    let Some(folder) = folder() else { return };
    let expected = json(&folder.join("expected_open.json"));
    let index = json(&folder.join("INDEX.json"));
    let mut failures = Vec::new();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    println!(
        "{:52} {:18} spectra x how they were read [format]",
        "file", "verdict"
    );
    for entry in index.as_array().unwrap() {
        let name = entry["file"].as_str().unwrap();
        let expected = &expected["files"][name];
        match read_path(&folder.join(name)) {
            Ok(reading) => {
                let verdict = verdict(name, &reading, expected);
                *counts.entry(verdict).or_default() += 1;
                println!(
                    "{name:52.52} {verdict:18} {} x {:60.60} [{}]",
                    reading.spectra.len(),
                    reading.notes[0],
                    reading.format
                );
                if MUST_MATCH.contains(&name) && verdict != "matches" {
                    failures.push(format!("{name}: {verdict}"));
                }
            }
            Err(refusal) => {
                let line = refusal.to_string();
                *counts.entry("refused").or_default() += 1;
                println!("{name:52.52} refused            {line}");
                if line.lines().count() != 1
                    || !line.starts_with(name)
                    || !line.contains("expected")
                {
                    failures.push(format!(
                        "{name}: not one line with file and expectation: {line}"
                    ));
                }
                if MUST_MATCH.contains(&name) {
                    failures.push(line);
                }
            }
        }
    }
    let total: usize = counts.values().sum();
    println!("{total} files: {counts:?}");
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn plain_tables_of_many_makers_are_read() {
    let Some(folder) = folder() else { return };
    for &(name, spectra, points) in MUST_READ {
        let reading = read_path(&folder.join(name)).unwrap();
        assert_eq!(
            reading.spectra.len(),
            spectra,
            "{name}: {:?}",
            reading.notes
        );
        if points > 0 {
            assert_eq!(reading.spectra[0].samples.len(), points, "{name}");
        }
    }
}

#[test]
fn what_holds_no_spectrum_is_refused_by_what_it_is() {
    let Some(folder) = folder() else { return };
    for &(name, words) in MUST_REFUSE {
        let refusal = read_path(&folder.join(name)).unwrap_err().to_string();
        assert!(refusal.contains(words), "{refusal}");
    }
}

/// The reference reader knows no counts of two digits in packed JCAMP-DX: it finds 500 of the 881
/// points that the file announces, and its own checks fail. Ours all hold; the sum is that of an
/// independent unpacking.
#[test]
fn the_packed_file_reads_to_every_point_that_it_announces() {
    let Some(folder) = folder() else { return };
    let reading = read_path(&folder.join("uv_ACD.jdx")).unwrap();
    let spectrum = &reading.spectra[0];
    let samples = &spectrum.samples;
    assert_eq!(
        (samples.len(), samples.first_nm(), samples.last_nm()),
        (881, 210.0, 650.0)
    );
    assert!(close(samples.values().iter().sum(), 124.413_000_3));
    assert!(
        !spectrum
            .notes
            .iter()
            .any(|n| n.contains("checks") || n.contains("NPOINTS"))
    );
}

#[test]
fn kinds_and_scales_of_real_files_are_told_by_their_words() {
    let Some(folder) = folder() else { return };
    for (name, kind, scale) in [
        ("aster-Rpc-drygrass.txt", Kind::Reflectance, 0.01),
        ("bkr1mm074ws.txt", Kind::Reflectance, 1.0),
        ("UQG-UG1-2mm.CSV", Kind::Transmittance, 0.01),
        ("Cherry_3C01_GT.csv", Kind::Transmittance, 0.01),
        ("J_MUR_MARS_17_0001.ttt", Kind::Transmittance, 0.01),
        ("CRAIC_export.txt", Kind::Reflectance, 0.01),
        (
            "Betula_leaf_yellow_2010_1006_1_LICOR.csv",
            Kind::Reflectance,
            1.0,
        ),
        ("cvars_grape_leaf1_lc_rg_01236.sed", Kind::Reflectance, 1.0),
        ("LEDWhitesPlusCanaryYellow.txt", Kind::Light, 1.0),
        ("optronics-OL731.txt", Kind::Light, 1.0),
        ("psi-spectrapen-SP.csv", Kind::Light, 1.0),
        ("TM27_Sample_Spectral_Data.spdx", Kind::Light, 1.0),
        ("CIE_a-opic_action_spectra.csv", Kind::Weighting, 1.0),
        ("linss2_10e_5.csv", Kind::Weighting, 1.0),
        ("Au.eta.spd", Kind::Other, 1.0),
        ("mitsuba_Ag.k.spd", Kind::Other, 1.0),
        ("macbeth-1.spd", Kind::Reflectance, 1.0),
        ("F8.sp", Kind::Light, 1.0 / 30.0),
        ("example.sp", Kind::Light, 0.01),
        ("argyll_refl_leather.sp", Kind::Reflectance, 0.01),
        ("argyll_amb_copybox.sp", Kind::Light, 1.0),
        ("DELL_UP2516D_i1Pro2.ccss", Kind::Light, 1.0),
        ("CIE-TCS.sp", Kind::Reflectance, 1.0),
        ("X-Rite_Digital_Colour_Checker.txt", Kind::Reflectance, 1.0),
        ("gr070214_003.sig", Kind::Reflectance, 0.01),
        ("ribb00001.asd.txt", Kind::Reflectance, 1.0),
        ("asd-e-irrad-sky.csv2", Kind::Light, 1.0),
    ] {
        let reading = read_path(&folder.join(name)).unwrap();
        let first = &reading.spectra[0];
        assert_eq!(
            (first.kind, first.scale),
            (kind, scale),
            "{name}: {:?}",
            first.notes
        );
    }
}

#[test]
fn what_was_guessed_can_be_flipped_and_what_is_stated_is_not_guessed() {
    let guessed = |text: &str| {
        let reading = read_bytes("a.csv", text.as_bytes()).unwrap();
        reading.guesses.iter().map(|g| g.what).collect::<Vec<_>>()
    };
    assert_eq!(
        guessed("380,0.5\n385,0.6\n"),
        [Guessed::WavelengthUnit, Guessed::Kind]
    );
    assert_eq!(
        guessed("wavelength (nm),irradiance\n380,0.5\n385,0.6\n"),
        []
    );
    assert_eq!(
        guessed("wavelength (nm),reflectance\n380,50\n385,60\n"),
        [Guessed::Percent]
    );
}

#[test]
fn a_large_table_is_read_in_time_that_grows_with_its_length_only() {
    // A quadratic reader takes minutes over these; the limit is wide for slow machines.
    let rows = 200_000;
    let text: String = (0..rows)
        .map(|i| format!("{},{}\n", 300.0 + 0.001 * f64::from(i), i % 97))
        .collect();
    let (reading, took) = own_seconds(|| read_bytes("large.csv", text.as_bytes()).unwrap());
    assert_eq!(reading.spectra[0].samples.len(), rows as usize);
    assert!(took < 20.0, "{took} s");
}

/// Names that lead to each reader.
fn names() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "a.csv",
        "a.spd",
        "a.spdx",
        "a.json",
        "a.txt",
        "a",
        "a.dpt",
        "a.spc",
        "iR785.txt",
        "a.csv",
        "a.spd",
        "a.spdx",
        "a.json",
        "a.txt",
        "a",
        "a.dpt",
        "a.spc",
        "a.hdr",
        "a.jdx",
        "a.yml",
        "a.cxf",
    ])
}

/// Text of the pieces that tables are made of.
fn table_like() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "380",
        "385",
        "390.5",
        "0,5",
        "-1.23e34",
        "NaN",
        "abc",
        "nm",
        "%",
        "#",
        ";",
        ",",
        "\t",
        " ",
        "\n",
        "\n",
        "\r\n",
        "\"",
        "wavelength",
        "{",
        "}",
        "[",
        "]",
        ":",
        "<IESTM2714>",
        "<CxF>",
        "##TITLE=",
        "##XYDATA=(X++(Y..Y))",
        "##XUNITS=NM",
        "DATA:",
        "type: tabulated nk",
        "cs1;",
        "cosine;",
        "SPECT\n",
        "SPECTRAL_BANDS 3\nSPECTRAL_START_NM 380\nSPECTRAL_END_NM 390\n",
        "BEGIN_DATA_FORMAT\n",
        "SPEC_380 SPEC_385 SPEC_390\n",
        "SPECTRAL_NM SPECTRAL_PCT ",
        "END_DATA_FORMAT\n",
        "BEGIN_DATA\n",
        "END_DATA\n",
        "Model Name\tCV600\nI-Time\t1\n",
        "380nm\t",
        "381nm\t",
        "Measuring Mode,Flash\nTcp [K],1\nCRI Ra,2\n",
        "Spectral Data 380[nm],",
        "\"LIMS: 1\"\n\"REM: (QNTM)\"\n",
        "/*** Spectra Vista SIG Data ***/\ndata=\n",
        " splib07a Record=1: x ASDFRa AREF\n",
        "PE FL SPECTRUM ASCII\n#GR\nNM\n%T\n#DATA\n",
        "LOWER WVL  UPPER WVL  A  TOTAL\n",
        "@1/1/1\n#x\n",
        "Spectrum from 380.0 to 730.0 nm in 3 steps\n",
        "Result is XYZ: 1 2 3\n",
        "Laser 785 nm\nRaman shift\n",
        "1e308",
        "-0",
        "µ",
        "\u{feff}",
        "\0",
        "0",
        "1",
        "2",
        "3",
    ]);
    prop::collection::vec(piece, 0..200).prop_map(|pieces| pieces.concat())
}

fn is_refused_well(name: &str, bytes: &[u8]) -> Result<(), TestCaseError> {
    match read_bytes(name, bytes) {
        Ok(reading) => {
            prop_assert!(!reading.notes.is_empty());
            let holds_some = !reading.spectra.is_empty()
                || !reading.composites.is_empty()
                || !reading.images.is_empty();
            prop_assert!(holds_some);
        }
        Err(refusal) => {
            let line = refusal.to_string();
            prop_assert_eq!(line.lines().count(), 1);
            prop_assert!(line.starts_with(name) && line.contains(", expected "));
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn random_bytes_never_panic(name in names(), bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        is_refused_well(name, &bytes)?;
    }

    #[test]
    fn random_text_never_panics(name in names(), text in "\\PC*") {
        is_refused_well(name, text.as_bytes())?;
    }

    #[test]
    fn text_like_tables_never_panics(name in names(), text in table_like()) {
        is_refused_well(name, text.as_bytes())?;
    }

    #[test]
    fn a_table_in_any_dialect_reads_to_the_same_numbers(
        values in prop::collection::vec(-1e6..1e6f64, 5..40),
        delimiter in prop::sample::select(vec![";", "\t", "  ", ","]),
        comma in any::<bool>(),
        falling in any::<bool>(),
        end in prop::sample::select(vec!["\n", "\r\n", "\r"]),
    ) {
        let comma = comma && delimiter != ",";
        let mut rows: Vec<String> = values
            .iter()
            .enumerate()
            .map(|(i, v)| {
                let row = format!("{}{delimiter}{v:?}", 380.5 + i as f64);
                if comma { row.replace('.', ",") } else { row }
            })
            .collect();
        if falling {
            rows.reverse();
        }
        let text = format!("A header{end}{end}{}{end}", rows.join(end));
        let reading = read_bytes("a.txt", text.as_bytes()).unwrap();
        prop_assert_eq!(reading.spectra[0].samples.values(), &values[..]);
        prop_assert_eq!(reading.spectra[0].samples.first_nm(), 380.5);
    }
}

/// What a file of our own says when it is refused.
#[track_caller]
fn refused(name: &str, text: &str) -> String {
    match read_bytes(name, text.as_bytes()) {
        Ok(reading) => panic!("{name} was read: {:?}", reading.notes),
        Err(why) => why.to_string(),
    }
}

#[test]
fn a_word_in_a_table_of_whole_numbers_is_never_read_by_turns() {
    let rows = |count: u32| -> String {
        let value = |nm| if nm == 400 { "abc" } else { "1" };
        let nm = (0..count).map(|step| 380 + 5 * step);
        "nm,v\n".to_owned()
            + &nm
                .map(|nm| format!("{nm},{}\n", value(nm)))
                .collect::<String>()
    };
    // Too few rows to tell that the others agree.
    assert_eq!(
        refused("short.csv", &rows(15)),
        "short.csv, line 6: found \"abc\", expected a number in column 2"
    );
    let reading = read_bytes("long.csv", rows(81).as_bytes()).expect("a table");
    assert_eq!(reading.spectra[0].samples.len(), 80);
    let said = "line 6: found \"abc\" in column 2: the row was left out".to_owned();
    assert!(reading.notes.contains(&said), "{:?}", reading.notes);
}

#[test]
fn watts_beside_nanometres_are_values() {
    for text in ["nm,W\n380,1\n390,2\n400,3\n", "nm;W\n380;1\n390;2\n400;3\n"] {
        let reading = read_bytes("lamp.csv", text.as_bytes()).expect("a table");
        assert_eq!(reading.spectra[0].samples.values(), [1.0, 2.0, 3.0]);
    }
}

#[test]
fn a_percent_sign_beside_r_is_a_reflectance_in_percent() {
    let text = "nm,R%\n380,10\n390,20\n400,78\n";
    let reading = read_bytes("paint.csv", text.as_bytes()).expect("a table");
    let spectrum = &reading.spectra[0];
    assert_eq!(spectrum.kind, Kind::Reflectance);
    // Hundredths of the file's numbers, to rounding.
    assert!((spectrum.samples.values()[2] - 0.78).abs() < 1e-12);
}

#[test]
fn text_that_speaks_of_the_xml_format_is_not_taken_for_it() {
    let why = refused("about.json", "{\"note\": \"see IESTM2714\"}");
    assert!(!why.contains("XML"), "{why}");
}

#[test]
fn the_makers_own_results_are_kept() {
    use spectral_explorer::io::Quantity;
    let Some(folder) = folder() else { return };
    for (name, quantity, value) in [
        ("ESPD2021_0104_231446.xls", Quantity::Cct, 5198.0),
        ("ESPD2021_0104_231446.xls", Quantity::Ra, 92.956993),
        ("ESPD2021_0104_231446.xls", Quantity::Rf, 87.234917),
        ("RANDOM_001_02._3262K.csv", Quantity::Cct, 3262.0),
        ("RANDOM_001_02._3262K.csv", Quantity::R(9), 31.2),
        ("RANDOM_001_02._3262K.csv", Quantity::Ppfd, 0.4),
        ("licor-li180-irrad.txt", Quantity::Ppfd, 129.87944),
        ("licor-li180-irrad.txt", Quantity::Cct, 5465.0),
        ("licor-li1800-q-irrad.PRN", Quantity::PeakNm, 546.0),
    ] {
        let reading = read_path(&folder.join(name)).unwrap();
        let found = reading.results.iter().find(|r| r.quantity == quantity);
        assert_eq!(found.map(|r| r.value), Some(value), "{name}: {quantity}");
    }
}

#[test]
fn units_of_instruments_are_known() {
    let Some(folder) = folder() else { return };
    for (name, index, unit) in [
        ("ESPD2021_0104_231446.xls", 0, "mW m-2 nm-1"),
        ("licor-li180-irrad.txt", 0, "mW m-2 nm-1"),
        ("RANDOM_001_02._3262K.csv", 0, "W m-2 nm-1"),
        ("licor-li1800-q-irrad.PRN", 0, "µmol m-2 s-1 nm-1"),
        ("Osram.HQIT.400W.PRN", 0, "µmol m-2 s-1 nm-1"),
        ("macam-e-irrad.DTA", 0, "W m-2 nm-1"),
        ("argyll_amb_copybox.sp", 0, "mW m-2 nm-1"),
        ("psi-spectrapen-SP.csv", 0, "µW/cm2/nm"),
        ("psi-spectrapen-SP.csv", 6, "µE/m2/s/nm"),
        ("qtuv-default.txt", 0, "W m-2 nm-1"),
        ("wasatch-enlighten-scope.json", 0, "counts"),
    ] {
        let reading = read_path(&folder.join(name)).unwrap();
        assert_eq!(
            reading.spectra[index].unit, unit,
            "{name}: {:?}",
            reading.spectra[index].notes
        );
    }
}

#[test]
fn huge_and_hostile_instrument_files_end_soon() {
    let columns: String = (0..300_000).map(|i| format!("a{i}380 ")).collect();
    let bands: String = (100..300_000).map(|i| format!("nm{i} ")).collect();
    let ones = "1 ".repeat(300_000);
    let points = format!("380nm{}\n", "\t1".repeat(100_000));
    let table = |fields: &str, data: &str| {
        format!(
            "SPECT\nBEGIN_DATA_FORMAT\n{fields}\nEND_DATA_FORMAT\nBEGIN_DATA\n{data}\nEND_DATA\n"
        )
    };
    let settings: String = (0..5000).map(|i| format!("k{i}\t1\n")).collect();
    for text in [
        table(&columns, &ones),
        table(&bands, &ones),
        table("nm380 nm390 nm400", &"1 1e308 NaN\n".repeat(100_000)),
        table("nm380 nm390 nm400", &ones),
        format!("Model Name\tX\n{points}{points}{settings}"),
        format!(
            "Measuring Mode,Flash\nTcp [K],1\nTitle,x\n{}",
            "Spectral Data 380[nm],1\n".repeat(200_000)
        ),
        format!("/*** Spectra Vista SIG Data ***/\ndata=\n{ones}"),
        format!("splib07a Record=1: x BECK AREF\n1\n{ones}"),
        format!("@1\n#x\n{}", "1\n".repeat(500_000)),
        format!("Spectrum from 380.0 to 730.0 nm in 99999 steps\n{ones}"),
        format!("Laser 785\nRaman shift\n{ones}"),
        format!("PE FL ASCII\n#DATA\n{ones}"),
        format!("LOWER WVL  UPPER WVL\n{ones}"),
    ] {
        let (_, took) = own_seconds(|| read_bytes("a.txt", text.as_bytes()));
        assert!(took < 10.0, "{took} s: {}", &text[..60]);
    }
}
