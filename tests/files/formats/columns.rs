//! Plain columns: CSV, TSV and whatever else writes wavelengths and values as text.

use crate::told::{assert_told, first, names, read, refusal};
use spectral_explorer::io::{Guessed, OpenQuestion};
use spectral_explorer::spectrum::Kind;

#[test]
fn the_r_of_rgb_is_no_reflectance() {
    let text = "nm,R,G,B\n400,0.1,0.2,0.3\n410,0.2,0.3,0.4\n420,0.3,0.4,0.5\n";
    let spectra = read("a.csv", text).spectra;
    assert!(spectra.iter().all(|s| s.kind == Kind::Light), "{spectra:?}");
    assert_eq!(spectra[0].name, "R");
    let leaf = first("a.csv", "nm,R\n400,0.1\n410,0.2\n420,0.3\n");
    assert_eq!(leaf.kind, Kind::Reflectance);
}

#[test]
fn columns_of_one_title_are_named_by_the_line_above() {
    for text in [
        "WP,first,second\nWavelength,Processed,Processed\n400,1,2\n410,3,4\n420,5,6\n",
        "first,,second,,\nWavelength (nm),%T,Wavelength (nm),%T,\n400,1,400,2,\n410,3,410,4,\n420,5,420,6,\n",
    ] {
        assert_eq!(names(&read("a.csv", text)), ["first", "second"], "{text}");
    }
}

#[test]
fn pairs_side_by_side_have_wavelengths_of_their_own() {
    let text = "nm,%T,nm,%T\n400,1,402,5\n410,2,412,6\n420,3,422,7\n,,432,8\n";
    let reading = read("a.csv", text);
    let samples: Vec<_> = reading.spectra.iter().map(|s| &s.samples).collect();
    assert_eq!(samples[0].nm(), [400.0, 410.0, 420.0]);
    assert_eq!(samples[1].nm(), [402.0, 412.0, 422.0, 432.0]);
    let said = "holds the wavelengths of the columns behind it";
    assert_told(&reading.notes, said);
    let text = "Wavelength (nm),A,Wavelength (nm),B\n380,0,1000,100\n390,1,1010,101\n\
                400,2,,\n";
    let reading = read("a.csv", text);
    assert_eq!(names(&reading), ["A", "B"]);
    assert_eq!(reading.spectra[0].samples.nm(), [380.0, 390.0, 400.0]);
    assert_eq!(reading.spectra[1].samples.nm(), [1000.0, 1010.0]);
    assert_eq!(reading.spectra[1].samples.values(), [100.0, 101.0]);
    let missing = |note: &String| note.contains("missing");
    assert!(!reading.spectra[1].notes.iter().any(missing));
}

#[test]
fn the_other_end_of_a_band_is_no_axis_of_its_own() {
    let text = "wl_min,wl_max,E,F\n400,401,1,5\n401,402,2,6\n402,403,3,7\n";
    let spectra = read("a.csv", text).spectra;
    let from_400 = spectra.iter().all(|s| s.samples.first_nm() == 400.0);
    assert!(from_400, "{spectra:?}");
}

/// Rows of two columns that rise by 1 nm from a wavelength on.
fn rows(from: usize, count: usize) -> String {
    let row = |i| format!("{},0.{}\n", from + i, i % 10);
    (0..count).map(row).collect()
}

#[test]
fn a_second_table_is_read_however_short() {
    let (a, b) = (rows(380, 401), rows(400, 41));
    let reading = read("a.csv", format!("nm,lamp A\n{a}\nnm,lamp B\n{b}"));
    assert_eq!(names(&reading), ["a, table 1", "a, table 2"]);
    assert_eq!(reading.spectra[1].samples.len(), 41);
}

#[test]
fn a_few_rows_that_are_no_table_leave_the_long_one_alone_and_are_said() {
    let lamp = rows(380, 401);
    let few = "pixel,gain\n1,400\n2,500\n3,600\n\nnm,lamp\n";
    let reading = read("a.csv", few.to_owned() + &lamp);
    assert_eq!(names(&reading), ["a"]);
    let is_said = |note: &String| note.starts_with("lines 2 to 4 left out");
    assert!(reading.notes.iter().any(is_said), "{:?}", reading.notes);
    let reading = read(
        "a.csv",
        "gains\n1,7\n2,3\n1,4\nnm,lamp\n".to_owned() + &lamp,
    );
    assert_eq!(reading.spectra.len(), 1);
    let said = "lines 2 to 4 left out".to_owned();
    assert!(reading.notes.contains(&said), "{:?}", reading.notes);
    // Nor do they stand for a long block without wavelengths.
    let text = "7,1\n3,9\n".repeat(50) + "nm,b\n" + &rows(380, 5);
    let why = refusal("a.csv", text);
    let found = "found numbers with no wavelengths among them, expected";
    assert!(why.contains(found), "{why}");
}

#[test]
fn a_column_of_names_does_not_hide_the_table() {
    for text in [
        "sample,nm,value\nleaf,380,0.10\nleaf,390,0.20\nleaf,400,0.15\n",
        "380,leaf,0.10\n390,leaf,0.20\n400,leaf,0.15\n",
        "sample;nm;value\nleaf a;380;0,10\nleaf a;390;0,20\nleaf a;400;0,15\n",
    ] {
        let samples = first("a.csv", text).samples;
        assert_eq!(samples.nm(), [380.0, 390.0, 400.0], "{text}");
        assert_eq!(samples.values(), [0.1, 0.2, 0.15]);
    }
}

#[test]
fn fewer_titles_than_cells_are_doubtful() {
    let reading = read("a.csv", "nm,lamp (W/m2/nm)\n380,0,10\n390,0,20\n400,0,15\n");
    assert!(reading.is_doubtful());
    let columns = |guess: &OpenQuestion| guess.what == Guessed::Columns;
    assert!(reading.guesses.iter().any(columns), "{:?}", reading.guesses);
    let whole = read("a.csv", "nm,a (W/m2/nm),b\n380,0,10\n390,0,20\n400,0,15\n");
    assert!(!whole.guesses.iter().any(columns));
}

#[test]
fn a_humidity_in_per_cent_does_not_scale_the_values() {
    let text = "Measurement humidity: 45 %\nWavelength (nm);Reflectance\n\
                380;0.2\n390;0.4\n400;0.5\n";
    let spectrum = first("a.csv", text);
    assert_eq!((spectrum.scale, spectrum.samples.values()[2]), (1.0, 0.5));
}

#[test]
fn a_long_name_of_a_wavelength_column_is_no_unit() {
    let spectrum = first("a.csv", "Våglängd;Reflektans\n380;0.2\n580;0.4\n780;0.5\n");
    assert_eq!(spectrum.samples.nm(), [380.0, 580.0, 780.0]);
}

/// Rows of wavelengths from 400 nm on and what a function makes of each.
fn rows_of(count: u32, row: impl Fn(f64) -> String) -> String {
    (0..count).map(|i| row(f64::from(i)) + "\n").collect()
}

#[test]
fn wavelengths_that_are_numbered_stand_under_their_number() {
    let rows = rows_of(30, |i| {
        let (one, other) = (400.0 + 5.0 * i, 500.0 + 10.0 * i);
        format!("{one}\t{}\t{other}\t{}", 20.0 + i, 60.0 + i)
    });
    let text = "w.length.1\ttransmittance.1\tw.length.2\ttransmittance.2\n".to_owned() + &rows;
    let reading = read("gel.txt", text);
    assert_eq!(names(&reading), ["transmittance.1", "transmittance.2"]);
    assert_eq!(reading.spectra[1].samples.last_nm(), 790.0);
}

#[test]
fn of_several_titled_columns_each_is_what_its_own_title_says() {
    let rows = rows_of(30, |i| {
        format!("{i};{};900;65535;{};50.5;0.3", 540.0 + i, 900.0 + 60.0 * i)
    });
    let text = "laser_wavelength;532\n\
                Pixel;Wavelength;Dark;Reference;Dark Subtracted #1;%TR #1;Absorbance #1\n"
        .to_owned()
        + &rows;
    let reading = read("bw.txt", text);
    let kinds: Vec<Kind> = reading.spectra.iter().map(|s| s.kind).collect();
    assert_eq!(kinds, [Kind::Light, Kind::Transmittance, Kind::Absorbance]);
    assert_told(&reading.spectra[1].notes, "may be a reflectance");
}

#[test]
fn a_value_with_its_unit_and_a_wavelength_with_a_colon_are_read() {
    let rows = rows_of(9, |i| format!("{} nm,{} W/m2", 400.0 + i, 0.5 + i));
    let spectrum = first("a.csv", rows);
    assert_eq!((&*spectrum.unit, spectrum.samples.len()), ("W/m2", 9));
    let rows = rows_of(9, |i| format!("{}: {}", 400.0 + i, 0.5 + i));
    assert_eq!(first("a.csv", rows).samples.len(), 9);
    let lists = "wavelengths: [400, 410, 420, 430, 440]\nvalues: [1, 2, 3, 4, 5]\n";
    let spectrum = first("a.csv", lists);
    assert_eq!((&*spectrum.name, spectrum.samples.len()), ("values", 5));
}

#[test]
fn a_line_of_key_and_value_names_no_spectrum() {
    let text = "Name: Dry grass\nY Units: Reflectance (percent)\n\
                Additional Information:  None.\n\n380 14.2\n390 14.5\n400 14.9\n";
    assert_eq!(names(&read("a.txt", text)), ["Dry grass"]);
}

/// The rows 380 to 475 in steps of 5 nm, some of them as they are given.
fn rows_but(other: &[(usize, &str)]) -> String {
    let row = |nm: usize| match other.iter().find(|(at, _)| *at == nm) {
        Some((_, row)) => format!("{row}\n"),
        None => format!("{nm},1{}\n", nm % 7),
    };
    "nm,W\n".to_owned() + &(380..480).step_by(5).map(row).collect::<String>()
}

#[test]
fn rows_that_do_not_fit_are_left_out_and_said() {
    // A cell too many makes no decimal of the one before.
    let too_many = rows_but(&[(410, "410,13,3"), (420, "420,16,3")]);
    let mut at: Vec<f64> = (380..480).step_by(5).map(f64::from).collect();
    at.retain(|nm| *nm != 410.0 && *nm != 420.0);
    // Rows behind the last break are read.
    let behind = "nm,W\n380,1\n390,2\n400,3,9\n410,4\n420,5,6,7\nend of data\n";
    for (text, at, lines) in [
        (&*too_many, at, [8, 10]),
        (behind, vec![380.0, 390.0, 410.0], [4, 6]),
    ] {
        let reading = read("a.csv", text);
        assert_eq!(reading.spectra[0].samples.nm(), at);
        for line in lines {
            let said = format!("line {line} is no row of the table and was left out");
            assert!(reading.notes.contains(&said), "{:?}", reading.notes);
        }
    }
}

#[test]
fn a_wavelength_alone_in_its_line_is_a_row_without_a_value() {
    let alone: Vec<(usize, String)> = (400..480)
        .step_by(10)
        .map(|nm| (nm, nm.to_string()))
        .collect();
    let alone: Vec<(usize, &str)> = alone.iter().map(|(nm, row)| (*nm, &**row)).collect();
    let spectrum = first("a.csv", rows_but(&alone));
    assert_eq!(spectrum.samples.len(), 12);
    assert_told(&spectrum.notes, "8 missing values");
}

#[test]
fn a_row_between_two_with_words_is_kept() {
    let few = rows_but(&[(410, "410,1,2,3"), (415, "415,7"), (420, "420,a,3")]);
    assert!(first("a.csv", few).samples.nm().contains(&415.0));
    let row = |nm: usize| match nm {
        500 | 510 => format!("{nm},x\n"),
        _ => format!("{nm},2\n"),
    };
    let text = rows_but(&[]) + &(480..1480).step_by(5).map(row).collect::<String>();
    let spectrum = first("a.csv", text);
    assert!(spectrum.samples.nm().contains(&505.0));
    assert!(!spectrum.samples.nm().contains(&510.0));
}
