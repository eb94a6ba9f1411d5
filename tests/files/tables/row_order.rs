//! Rows that do not stand where their wavelengths belong.

use spectral_explorer::io::{Reading, read_bytes};

fn rows() -> Vec<String> {
    (0..81)
        .map(|i| format!("{},{}", 380 + 5 * i, 0.5 + 0.01 * f64::from(i)))
        .collect()
}

fn read(rows: &[String]) -> Reading {
    read_bytes("a.csv", ("nm,v\n".to_owned() + &rows.join("\n")).as_bytes()).expect("a table")
}

#[test]
fn a_stray_row_is_left_out_wherever_it_stands_and_said_with_line_and_value() {
    let (mut end, mut start, mut middle, mut mistyped) = (rows(), rows(), rows(), rows());
    end.push("550,100".to_owned());
    start.insert(0, "550,100".to_owned());
    middle.insert(40, "400,3".to_owned());
    mistyped[34] = "5500,0.84".to_owned();
    for (rows, said, points) in [
        (end, "line 83: wavelength 550 (value 100)", 81),
        (start, "line 2: wavelength 550 (value 100)", 81),
        (middle, "line 42: wavelength 400 (value 3)", 81),
        (mistyped, "line 36: wavelength 5500 (value 0.84)", 80),
    ] {
        let reading = read(&rows);
        let said = format!("{said} is out of order: the row was left out");
        assert!(reading.notes.contains(&said), "{said}: {:?}", reading.notes);
        assert_eq!(reading.spectra.len(), 1);
        let samples = &reading.spectra[0].samples;
        assert_eq!((samples.len(), samples.last_nm()), (points, 780.0));
    }
}

#[test]
fn rows_in_random_order_are_sorted_and_said_with_and_without_titles() {
    let sorted = rows();
    // 37 and 81 have no divisor in common: every row once.
    let shuffled: Vec<String> = (0..81).map(|i| sorted[37 * i % 81].clone()).collect();
    for titles in ["nm,v\n", ""] {
        let text = titles.to_owned() + &shuffled.join("\n");
        let reading = read_bytes("a.csv", text.as_bytes()).expect("a table");
        let said = "rows in no order of wavelengths: put in rising order".to_owned();
        assert!(reading.notes.contains(&said), "{:?}", reading.notes);
        assert_eq!(reading.spectra.len(), 1);
        assert_eq!(reading.spectra[0].samples, read(&sorted).spectra[0].samples);
    }
}

#[test]
fn rows_behind_an_empty_line_that_carry_on_the_wavelengths_are_kept() {
    for (behind, points, last) in [
        (&["900,1", "1000,1.1", "1100,1.2"][..], 84, 1100.0),
        (&["900,1"], 82, 900.0),
        (&["5800,82"], 81, 780.0),
        (&["100.3,0.5"], 81, 780.0),
    ] {
        let mut rows = rows();
        rows.push(String::new());
        rows.extend(behind.iter().map(|row| (*row).to_owned()));
        let reading = read(&rows);
        let samples = &reading.spectra[0].samples;
        assert_eq!((samples.len(), samples.last_nm()), (points, last));
    }
}

#[test]
fn detectors_that_overlap_and_ranges_that_are_listed_twice_stay_what_they_are() {
    let mut overlap = rows();
    overlap.extend((0..40).map(|i| format!("{},1", 765 + 5 * i)));
    let reading = read(&overlap);
    assert_eq!(reading.spectra[0].samples.last_nm(), 960.0);
    let twice = read(&[rows(), rows()].concat());
    let lengths = twice.spectra.iter().map(|s| s.samples.len());
    assert_eq!(lengths.collect::<Vec<_>>(), [81, 81]);
}

#[test]
fn a_row_of_zeros_at_the_end_is_no_point() {
    let mut rows = rows();
    rows.push("0,0".to_owned());
    let reading = read(&rows);
    assert_eq!(reading.spectra[0].samples.len(), 81);
    let said = "1 point at a wavelength of 0 dropped".to_owned();
    assert!(reading.spectra[0].notes.contains(&said));
}

#[test]
fn a_word_in_one_of_many_rows_is_left_out_and_said() {
    for (width, text) in [(1, "500,abc"), (2, "500,abc,7")] {
        let mut rows = rows();
        let beside = ",7".repeat(width - 1);
        rows.iter_mut().for_each(|row| row.push_str(&beside));
        rows[24] = text.to_owned();
        let reading = read_bytes("a.csv", rows.join("\n").as_bytes()).expect("a table");
        let said = |note: &String| note.starts_with("line 25: found \"abc\" in column 2");
        assert!(reading.notes.iter().any(said), "{:?}", reading.notes);
        assert_eq!(reading.spectra[0].samples.len(), 80);
    }
    let mut several = rows();
    for row in [10, 20, 30, 40, 50] {
        several[row] = format!("{},abc", 380 + 5 * row);
    }
    let refusal = read_bytes("a.csv", several.join("\n").as_bytes()).expect_err("words");
    let said = refusal.to_string();
    assert!(said.contains("line 11: found \"abc\""), "{said}");
}

#[test]
fn falling_wavelengths_gaps_and_readings_that_were_repeated_are_said() {
    let falling = read(&["500,1".to_owned(), "400,2".to_owned()]);
    let spectrum = &falling.spectra[0];
    assert_eq!(
        (spectrum.samples.nm().to_vec(), spectrum.samples.values()),
        (vec![400.0, 500.0], &[2.0, 1.0][..])
    );
    let twice = ["400,1", "400,3", "410,2", "410,4", "420,", "430,5", "430,5"].map(str::to_owned);
    let twice = read(&twice);
    assert_eq!(twice.spectra[0].samples.values(), [2.0, 3.0, 5.0]);
    let notes = twice.spectra[0].notes.join("; ");
    assert!(
        notes.contains("1 missing value dropped; 3 doubled wavelengths averaged"),
        "{notes}"
    );
}
