//! Every format that is written, by a spectrum that is hard to write.

use std::path::Path;

use spectral_explorer::{
    io::{Columns, Provenance, WRITABLE, read_path, write_as},
    spectrum::{Kind, NamedSpectrum, Sampled},
};

/// A spectrum with numbers and a name that are hard to write.
pub(crate) fn awkward_spectrum(kind: Kind) -> NamedSpectrum {
    let nm = vec![360.0, 380.1, 404.656, 1e3 / 3.0 + 100.0, 780.0, 2500.25];
    let values = vec![0.1 + 0.2, -0.0, 5e-324, 1.0 / 3.0, -1e-300, 1.25];
    NamedSpectrum {
        name: "Lampe <b> & \"no. 1\", käse; µ".to_owned(),
        kind,
        unit: match kind.is_factor() {
            true => "fraction".to_owned(),
            false => "W m-2 nm-1".to_owned(),
        },
        scale: 1.0,
        samples: Sampled::new(nm, values).unwrap(),
        notes: Vec::new(),
        source: "Own measurement".to_owned(),
    }
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

#[test]
fn every_writer_is_read_back_to_the_same_bits() {
    let provenance = Provenance {
        program: "spectral-explorer 0.0.0".to_owned(),
        source: String::new(),
        scale_words: "as measured".to_owned(),
        settings: "cosine, N = 7\n".to_owned(),
    };
    let folder = tempfile::tempdir().unwrap();
    for (extension, _) in WRITABLE {
        for kind in Kind::ALL {
            let spectrum = awkward_spectrum(kind);
            let columns = Columns::measured(&spectrum);
            let path = folder.path().join(format!("x.{extension}"));
            write_as(&path, &spectrum, &columns, &provenance).unwrap();
            if *extension == *"sp" {
                // Even steps only; tests/files/writers.rs has those.
                continue;
            }
            let back = read_path(&path).unwrap().spectra.remove(0);
            let (is, was) = (&back.samples, &spectrum.samples);
            assert_eq!(bits(is.nm()), bits(was.nm()), "{extension}");
            assert_eq!(bits(is.values()), bits(was.values()), "{extension}");
            assert_eq!(back.scale, 1.0);
            if kind.is_factor() || kind == Kind::Light {
                let (is, was) = ((back.kind, &back.unit), (kind, &spectrum.unit));
                assert_eq!(is, was, "{extension}");
            }
            if extension == "spd" {
                assert_eq!(back.name, spectrum.name);
                assert!(kind != Kind::Weighting || back.kind == kind);
            }
        }
    }
}

/// A spectrum of three points on which there are notes, and what an export says of the program.
fn noted(notes: &[&str]) -> (NamedSpectrum, Provenance) {
    let spectrum = NamedSpectrum {
        samples: Sampled::even(380.0, 5.0, vec![1.0, 0.5, 0.25]).unwrap(),
        notes: notes.iter().map(|note| (*note).to_owned()).collect(),
        ..awkward_spectrum(Kind::Light)
    };
    let provenance = Provenance {
        program: "Spectral Explorer 0.0.0".to_owned(),
        ..Provenance::default()
    };
    (spectrum, provenance)
}

#[test]
fn how_a_spectrum_was_read_goes_out_and_comes_back_and_does_not_grow() {
    let folder = tempfile::tempdir().unwrap();
    let notes = [
        "5 nm steps, 3 points, 380-390 nm, light, W m-2 nm-1, decimal comma",
        "divided by NORM 100; unit: odd",
        "2 missing values dropped",
    ];
    for (extension, _) in WRITABLE {
        let (mut spectrum, provenance) = noted(&notes);
        let path = folder.path().join(format!("x.{extension}"));
        let mut texts = Vec::new();
        for _ in 0..3 {
            write_as(&path, &spectrum, &Columns::measured(&spectrum), &provenance).unwrap();
            texts.push(std::fs::read_to_string(&path).unwrap());
            spectrum = read_path(&path).unwrap().spectra.remove(0);
            for note in notes {
                let is_told = spectrum.notes.iter().any(|n| n == note);
                assert!(is_told, "{extension}: {note} not in {:?}", spectrum.notes);
            }
        }
        assert_eq!(texts[1].len(), texts[2].len(), "{extension}: {}", texts[2]);
    }
}

#[test]
fn what_was_read_back_says_once_how_it_was_read() {
    let folder = tempfile::tempdir().unwrap();
    let line = "5 nm steps, 3 points, 380-390 nm, light, W m-2 nm-1";
    let (spectrum, provenance) = noted(&[line, "2 missing values dropped"]);
    for (extension, _) in WRITABLE {
        let path = folder.path().join(format!("x.{extension}"));
        let columns = Columns::measured(&spectrum);
        write_as(&path, &spectrum, &columns, &provenance).unwrap();
        let back = read_path(&path).unwrap().spectra.remove(0).notes;
        let told = |what: &str| back.iter().filter(|note| **note == *what).count();
        assert_eq!(told(line), 1, "{extension}: {back:?}");
        assert_eq!(told(&spectrum.notes[1]), 1, "{extension}: {back:?}");
    }
}

#[test]
fn an_extension_that_cannot_be_written_lists_those_that_can() {
    let spectrum = awkward_spectrum(Kind::Light);
    let (columns, path) = (Columns::measured(&spectrum), Path::new("a.xyz"));
    let error = write_as(path, &spectrum, &columns, &Provenance::default());
    assert_eq!(
        error.unwrap_err().to_string(),
        "a.xyz: found extension .xyz, expected one of .csv, .json, .sp, .spd, .spdx"
    );
}
