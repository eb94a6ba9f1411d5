//! Several samples below one another in one table.

use spectral_explorer::io::{Reading, read_bytes};

fn read(text: &str) -> Reading {
    read_bytes("long.csv", text.as_bytes()).expect("a table")
}

fn names(reading: &Reading) -> Vec<&str> {
    reading.spectra.iter().map(|s| s.name.as_str()).collect()
}

#[test]
fn a_column_of_words_names_the_spectra_below_one_another() {
    let one = read(
        "sample,wavelength,reflectance\nleaf,400,0.1\nleaf,410,0.2\nleaf,420,0.3\nsoil,400,0.4\n\
         soil,410,0.5\nsoil,420,0.6\n",
    );
    assert_eq!(names(&one), ["leaf", "soil"]);
    assert_eq!(one.spectra[1].samples.values(), [0.4, 0.5, 0.6]);
    let said = "column 1 (sample) tells the spectra apart".to_owned();
    assert!(one.notes.contains(&said), "{:?}", one.notes);
}

#[test]
fn samples_that_alternate_are_told_apart_and_never_averaged() {
    let two = read(
        "wavelength;R;T;leaf\n400;10;1;\"oak\"\n400;20;2;\"elm\"\n410;30;3;\"oak\"\n410;40;4;\"elm\"\n\
         420;50;5;\"oak\"\n420;60;6;\"elm\"\n",
    );
    assert_eq!(names(&two), ["oak R", "oak T", "elm R", "elm T"]);
    assert_eq!(two.spectra[2].samples.values(), [0.2, 0.4, 0.6]);
}

#[test]
fn whole_numbers_tell_samples_apart_and_are_no_spectrum() {
    let mut text = "plot,wavelength,reflectance\n".to_owned();
    for nm in (400..460).step_by(10) {
        for plot in [7, 8] {
            text += &format!("{plot},{nm},0.{plot}{nm}\n");
        }
    }
    let two = read(&text);
    assert_eq!(names(&two), ["plot 7", "plot 8"]);
    assert_eq!(two.spectra[1].samples.len(), 6);
    assert_eq!(two.spectra[1].samples.values()[0], 0.84);
}

#[test]
fn words_beside_wavelengths_that_run_through_once_divide_nothing() {
    let one = read("region,nm,power\nUV,380,1\nUV,390,2\nVIS,400,3\nVIS,410,4\n");
    assert_eq!(one.spectra.len(), 1);
    assert_eq!(one.spectra[0].samples.len(), 4);
}
