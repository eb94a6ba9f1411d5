//! ENVI: a header and its data beside it, by pairs of files of our own.

use std::fs;
use std::path::PathBuf;

use crate::own_time::own_seconds;
use crate::told::{self, has};
use spectral_explorer::io::{Choices, Counted, Guessed, Reading, envi, read_path, read_path_as};
use spectral_explorer::spectrum::Kind;

/// A folder with the files given.
fn folder(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).expect("a file");
    }
    folder
}

fn refusal(path: PathBuf) -> String {
    read_path(&path).map(|r| r.notes).unwrap_err().to_string()
}

const LIBRARY: &str = "ENVI\n; a comment\nsamples = 4\nlines = 2\nbands = 1\nheader offset = 2\n\
    file type = ENVI Spectral Library\ndata type = 2\ninterleave = bsq\nbyte order = 1\n\
    wavelength units = Micrometers\nreflectance scale factor = 1000\nbbl = {1, 1, 0, 1}\n\
    spectra names = {\n red brick, blue\n tile}\nwavelength = {0.4, 0.5,\n 0.6, 0.7}\n";

fn library_data() -> Vec<u8> {
    let values = [100_i16, 200, -9, 400, 500, 600, -9, 800];
    [0, 0]
        .into_iter()
        .chain(values.into_iter().flat_map(i16::to_be_bytes))
        .collect()
}

fn cube_header(interleave: &str) -> String {
    format!(
        "ENVI\nsamples = 20\nlines = 10\nbands = 3\ndata type = 4\ninterleave = {interleave}\n\
         byte order = 0\ndata ignore value = -1e34\nwavelength = {{700, 600, 500}}\n"
    )
}

/// 20 x 10 pixels of 3 bands, pixel by pixel: (x + y + band) / 100, one of them missing.
fn cube_data() -> Vec<u8> {
    let mut bytes = Vec::new();
    for y in 0..10_u8 {
        for x in 0..20_u8 {
            for band in 0..3_u8 {
                let missing = (x, y, band) == (5, 5, 1);
                let value = if missing {
                    -1e34
                } else {
                    f32::from(x + y + band) / 100.0
                };
                bytes.extend(value.to_le_bytes());
            }
        }
    }
    bytes
}

#[test]
fn either_file_of_a_library_opens_it_and_every_spectrum_has_its_name() {
    let data = library_data();
    for (header, data_name) in [("a.hdr", "a.sli"), ("a.sli.hdr", "a.sli"), ("a.hdr", "a")] {
        let folder = folder(&[(header, LIBRARY.as_bytes()), (data_name, &data)]);
        for name in [header, data_name] {
            let reading = read_path(&folder.path().join(name)).expect(name);
            let names: Vec<_> = reading.spectra.iter().map(|s| &*s.name).collect();
            assert_eq!(names, ["red brick", "blue  tile"]);
            let first = &reading.spectra[0];
            assert_eq!(first.samples.nm(), [400.0, 500.0, 700.0]);
            for (value, file) in first.samples.values().iter().zip([100.0, 200.0, 400.0]) {
                assert!((value / first.scale - file).abs() < 1e-9);
            }
            assert_eq!((first.kind, first.scale), (Kind::Reflectance, 1e-3));
            assert!(reading.guesses.is_empty(), "{:?}", reading.guesses);
            assert!(has(&reading.notes, "1 bad band dropped"));
        }
    }
}

#[test]
fn a_cube_is_an_image_whose_pixels_and_regions_are_spectra() {
    let (header, data) = (cube_header("bip"), cube_data());
    let folder = folder(&[("b.img.hdr", header.as_bytes()), ("b.img", &data)]);
    let reading = read_path(&folder.path().join("b.img")).expect("a cube");
    assert!(reading.spectra.is_empty());
    let image = &reading.images[0];
    assert_eq!((image.cube.width(), image.cube.height()), (20, 10));
    let pixel = image.pixel(2, 3).expect("a pixel");
    assert_eq!(pixel.samples.nm(), [500.0, 600.0, 700.0]);
    assert_eq!(pixel.samples.values()[0], f64::from(0.07_f32));
    assert_eq!(image.pixel(5, 5).expect("two bands").samples.len(), 2);
    assert_eq!(image.mean().expect("a mean").samples.len(), 3);
    assert_eq!((image.kind, image.scale), (Kind::Reflectance, 1.0));
    assert!(reading.notes[0].starts_with("image of 20 x 10 pixels, 3 bands"));
    assert!(has(&reading.notes, "taken as nm"));
}

#[test]
fn needs_are_told_from_the_header_alone() {
    let folder = folder(&[("c.hdr", cube_header("bsq").as_bytes()), ("c", b"")]);
    for name in ["c", "c.hdr"] {
        let needs = envi::needs(&folder.path().join(name)).expect("a header");
        assert_eq!((needs.width, needs.channels), (20, 3));
        assert_eq!(needs.bytes(), Some(2400));
    }
    assert!(envi::needs(&folder.path().join("none")).is_err());
}

#[test]
fn an_unknown_unit_is_a_guess() {
    let header = LIBRARY.replace("wavelength units = Micrometers\n", "");
    let folder = folder(&[("a.hdr", header.as_bytes()), ("a.sli", &library_data())]);
    let reading = read_path(&folder.path().join("a.hdr")).expect("a library");
    assert_eq!(reading.spectra[1].samples.first_nm(), 400.0);
    assert_eq!(reading.guesses[0].what, Guessed::WavelengthUnit);
    assert_eq!(reading.guesses[1].spectrum, 1);
}

#[test]
fn what_is_wrong_with_a_pair_is_said_by_file_and_line() {
    let alone = told::refusal("a.hdr", LIBRARY);
    assert!(alone.contains("an ENVI header by itself"), "{alone}");
    let data = library_data();
    let said = |header: &str, data: &[u8]| {
        let folder = folder(&[("a.hdr", header.as_bytes()), ("a.sli", data)]);
        refusal(folder.path().join("a.hdr"))
    };
    assert_eq!(
        said(LIBRARY, &data[..10]),
        "a.sli: found 10 bytes, expected 4 x 2 x 1 numbers of 2 bytes after 2 bytes, as a.hdr says"
    );
    let wrong = |from: &str, to: &str| said(&LIBRARY.replace(from, to), &data);
    assert!(wrong("type = 2", "type = 6").contains("line 8: found complex numbers"));
    assert!(wrong("lines = 2", "lines = x").contains("line 4: found \"x\", expected a whole"));
    assert!(wrong("0.7}", "}").contains("found 3 wavelengths for 4 channels"));
    assert!(wrong("0.7}", "").contains("no closing brace"));
    assert!(wrong("lines = 2", "lines = 99999999999").contains("at most 512 MiB"));
    assert!(wrong("bsq", "abc").contains("expected bsq, bil or bip"));
    assert!(wrong("Micrometers", "GHz").contains("\"GHz\""));
    let folder = folder(&[("a.hdr", LIBRARY.as_bytes())]);
    assert!(refusal(folder.path().join("a.hdr")).contains("its data beside it"));
}

#[test]
fn a_library_of_countless_tiny_spectra_is_refused_before_it_fills_memory() {
    let header = "ENVI\nsamples = 2\nlines = 4000000\nbands = 1\ndata type = 1\n\
        file type = ENVI Spectral Library\nwavelength = {500, 600}\n";
    let folder = folder(&[("a.hdr", header.as_bytes()), ("a.sli", &vec![7; 8_000_000])]);
    let said = refusal(folder.path().join("a.sli"));
    assert!(said.contains("4000000 spectra, which take"), "{said}");
}

#[test]
fn a_cube_of_half_a_thousand_pixels_square_opens_at_once() {
    let nm: String = (0..31).map(|i| format!("{},", 400 + 10 * i)).collect();
    let header = format!(
        "ENVI\nsamples = 512\nlines = 512\nbands = 31\ndata type = 12\ninterleave = bil\n\
         wavelength units = Nanometers\nwavelength = {{{nm}}}\n"
    );
    let data = vec![1; 512 * 512 * 31 * 2];
    let folder = folder(&[("big.hdr", header.as_bytes()), ("big.bil", &data)]);
    let path = folder.path().join("big.hdr");
    let (reading, took) = own_seconds(|| read_path(&path).expect("a cube"));
    assert_eq!(reading.images[0].cube.plane(3)[0], 257.0);
    // Typically 30 ms; the limit is for slow machines.
    assert!(took < 1.0, "{took} s");
}

/// A library of three channels in single precision.
fn small_library(more: &str, values: &[f32]) -> Reading {
    let header = format!(
        "ENVI\nsamples = 3\nlines = {}\nbands = 1\ndata type = 4\nbyte order = 0\n\
         file type = ENVI Spectral Library\nwavelength units = nm\nwavelength = {{400, 500, 600}}\n\
         {more}\n",
        values.len() / 3
    );
    let data: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    let folder = folder(&[("a.hdr", header.as_bytes()), ("a.sli", &data)]);
    read_path(&folder.path().join("a.sli")).expect("a library")
}

#[test]
fn keys_of_a_header_tell_of_its_values() {
    // A scale factor goes for transmittances too.
    let words = "z plot titles = {Wavelength, Transmittance}\nreflectance scale factor = 100";
    let glass = &small_library(words, &[50.0, 60.0, 70.0]).spectra[0];
    assert_eq!((glass.kind, glass.scale), (Kind::Transmittance, 0.01));
    // The number for nothing measured is that of single precision.
    let values = [0.1, -1.1, 0.3, 0.2, 0.3, 0.4];
    let reading = small_library("data ignore value = -1.1", &values);
    assert_eq!(reading.spectra[0].samples.nm(), [400.0, 600.0]);
}

#[test]
fn names_in_quotes_keep_their_commas() {
    let words = "spectra names = {\"brick, red\", 'tile'}";
    let reading = small_library(words, &[0.1, 0.2, 0.3, 0.2, 0.3, 0.4]);
    let names: Vec<&str> = reading.spectra.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["brick, red", "tile"]);
}

#[test]
fn what_a_person_says_of_an_image_and_of_one_spectrum_is_heard() {
    let (header, data) = (cube_header("bip"), cube_data());
    let folder = folder(&[("a.hdr", header.as_bytes()), ("a.img", &data)]);
    let path = folder.path().join("a.hdr");
    let guessed = read_path(&path).expect("a cube");
    assert!(guessed.is_doubtful(), "nothing states what it is");
    let choices = Choices {
        kind: Some(Kind::Transmittance),
        counted: Some(Counted::Percent),
        ..Choices::default()
    };
    let said = read_path_as(&path, &choices).expect("a cube");
    let image = &said.images[0];
    assert_eq!((image.kind, image.scale), (Kind::Transmittance, 0.01));
    assert!(!said.is_doubtful(), "{:?}", said.images_understood);
    assert!(said.notes[0].contains("transmittance"), "{:?}", said.notes);
    assert!(!has(&said.notes, "nothing states it"));
}
