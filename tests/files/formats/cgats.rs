//! CGATS text: Argyll `.sp`, `.ccss`, `.ti3`, CGATS.17 and IT8.7 with spectral columns.

use crate::told::{self, has};
use spectral_explorer::{io::Reading, spectrum::Kind};

fn sp(header: &str, fields: &str, data: &str) -> String {
    format!(
        "SPECT   \n\nORIGINATOR \"Argyll CMS\"\n{header}\nBEGIN_DATA_FORMAT\n{fields}\nEND_DATA_FORMAT\n\nBEGIN_DATA\n{data}\nEND_DATA\n"
    )
}

fn reading(text: &str) -> Reading {
    told::read("x.sp", text)
}

fn refusal(text: &str) -> String {
    told::refusal("x.sp", text)
}

/// The labels of three bands.
const THREE: &str = "SPEC_380 SPEC_390 SPEC_400";

const GRID: &str = "SPECTRAL_BANDS \"3\"\nSPECTRAL_START_NM \"380.0\"\nSPECTRAL_END_NM \"400.0\"";

#[test]
fn a_norm_is_the_scale_and_the_type_is_the_kind() {
    let text = sp(
        &format!("MEAS_TYPE \"REFLECTIVE\"\nSPECTRAL_NORM \"100.0\"\n{GRID}"),
        THREE,
        "3.5 4.5 5.5",
    );
    let found = reading(&text);
    let spectrum = &found.spectra[0];
    assert_eq!((spectrum.kind, spectrum.scale), (Kind::Reflectance, 0.01));
    assert_eq!(spectrum.samples.nm(), [380.0, 390.0, 400.0]);
    assert!(found.guesses.is_empty());
    for text in [
        text.replace('\n', "\r\n"),
        text.replace('"', ""),
        text.replace(' ', "\t"),
        text.replace("3.5 4.5 5.5", "3,5 4,5 5,5"),
        text.replace("3.5 4.5 5.5", "3.5\n4.5 5.5"),
        format!("\u{feff}{text}"),
        text.replace("SPEC_", "nm"),
        text.replace("SPEC_", "SPECTRAL_NM"),
        text.replace("SPEC_", "SPECTRAL_NM_"),
        text.replace("SPEC_", "SPECTRAL_"),
        text.replace("SPECT   ", "CGATS.17"),
    ] {
        let samples = &reading(&text).spectra[0].samples;
        assert_eq!(*samples, spectrum.samples, "{text}");
    }
}

#[test]
fn light_has_argylls_unit() {
    for (kind, unit) in [("EMISSION", "mW m-2 sr-1 nm-1"), ("AMBIENT", "mW m-2 nm-1")] {
        let header = format!("MEAS_TYPE \"{kind}\"\nSPECTRAL_NORM \"1.0\"");
        let found = reading(&sp(&header, THREE, "3 4 5"));
        assert_eq!(found.spectra[0].unit, unit);
    }
}

#[test]
fn rounded_labels_yield_to_the_header_and_a_wrong_header_to_the_labels() {
    let header = "SPECTRAL_BANDS \"4\"\nSPECTRAL_START_NM \"370.0\"\nSPECTRAL_END_NM \"380.0\"";
    let third = 10.0 / 3.0;
    for (labels, data, nm, note) in [
        (
            "SPEC_370 SPEC_373 SPEC_377 SPEC_380",
            "1 2 3 4",
            &[370.0, 370.0 + third, 370.0 + 2.0 * third, 380.0][..],
            "the header's SPECTRAL_BANDS 4 from 370 to 380 nm is believed",
        ),
        (
            "SPEC_355 SPEC_360 SPEC_365 SPEC_370",
            "1 2 3 4",
            &[355.0, 360.0, 365.0, 370.0],
            "labels are believed",
        ),
        (
            "SPEC_370 SPEC_375 SPEC_380",
            "1 2 3",
            &[370.0, 375.0, 380.0],
            "columns are believed",
        ),
    ] {
        let found = reading(&sp(header, labels, data));
        assert_eq!(found.spectra[0].samples.nm(), nm);
        assert!(has(&found.notes, note), "{:?}", found.notes);
    }
}

#[test]
fn sets_are_spectra_named_by_their_fields() {
    let text = sp(
        "DESCRIPTOR \"Test Color Samples\"",
        "SAMPLE_ID\tSAMPLE_NAME\tRGB_R\tnm380\tnm390\tnm400",
        "1\tDark skin\t5\t0.1\t0.2\t0.3\n2\t\"Light skin\"\t5\t0.2\t0.3\t0.4\n3\tNone\t5\t\t0.3\t0.4",
    );
    let found = reading(&text);
    let names: Vec<_> = found.spectra.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["Dark skin", "Light skin", "None"]);
    assert_eq!(found.spectra[2].samples.len(), 2, "the empty cell is a gap");
    assert_eq!(found.spectra[0].kind, Kind::Reflectance);
}

#[test]
fn several_tables_and_several_spectra_a_set_are_read() {
    let one = sp("", &format!("SAMPLE_ID {THREE}"), "A1 0.1 0.2 0.3");
    let two = sp(
        "",
        "SAMPLE_ID SPEC_380_M0 SPEC_390_M0 SPEC_400_M0 SPEC_380_M1 SPEC_390_M1 SPEC_400_M1",
        "B1 1 2 3 4 5 6",
    );
    let found = reading(&(one + &two));
    let names: Vec<&str> = found.spectra.iter().map(|s| &*s.name).collect();
    assert_eq!(names, ["A1", "B1, SPEC_M0", "B1, SPEC_M1"]);
}

#[test]
fn wavelengths_among_the_data_are_read() {
    let text = sp(
        "",
        "SAMPLE_ID SPECTRAL_NM SPECTRAL_PCT SPECTRAL_NM SPECTRAL_PCT",
        "A 380 10 390 20\nB 380 30 390 40",
    );
    let found = reading(&text);
    assert_eq!(found.spectra.len(), 2);
    assert_eq!(found.spectra[1].scale, 0.01);
    assert_eq!(found.spectra[1].samples.nm(), [380.0, 390.0]);
    let text = sp("", "SPECTRAL_NM SPECTRAL_DEC", "380 0.1\n390 0.2\n400 0.3");
    assert_eq!(reading(&text).spectra[0].samples.values(), [0.1, 0.2, 0.3]);
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    assert_eq!(
        refusal(&sp("", "SAMPLE_ID RGB_R RGB_G", "1 2 3")),
        "x.sp, line 5: found a CGATS table of 1 sets with no spectral columns (SAMPLE_ID RGB_R RGB_G), expected columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380"
    );
    assert_eq!(
        refusal(&sp("", THREE, "1 2 3\n1 abc 3")),
        "x.sp, line 11: found \"abc\", expected a number for SPEC_390"
    );
    assert_eq!(
        refusal(&sp("", THREE, "1 2 3\n1 2\n1 2 3")),
        "x.sp, line 11: found 2 cells, expected 3, one for each field"
    );
    assert_eq!(
        refusal("SPECT\nDESCRIPTOR \"x\"\n"),
        "x.sp: found a CGATS header without a table and no spectral columns, expected columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380"
    );
    assert!(refusal("CGATS.17\nBEGIN_DATA\n1 2 3\nEND_DATA\n").contains("BEGIN_DATA_FORMAT"));
}

#[test]
fn a_file_cut_off_behind_a_whole_row_is_read_and_it_is_said() {
    let text = sp("NUMBER_OF_SETS 3", THREE, "1 2 3\n4 5 6");
    let found = reading(text.trim_end().strip_suffix("END_DATA").unwrap());
    assert_eq!(found.spectra.len(), 2);
    assert!(has(&found.notes, "END_DATA"));
    assert!(has(&found.notes, "NUMBER_OF_SETS says 3"));
}
