//! What a file that was read is asked by many tests.

use spectral_explorer::io::{Reading, read_bytes};
use spectral_explorer::spectrum::NamedSpectrum;

/// What a file holds.
#[track_caller]
pub(crate) fn read(name: &str, content: impl AsRef<[u8]>) -> Reading {
    read_bytes(name, content.as_ref()).unwrap_or_else(|why| panic!("{why}"))
}

/// Its first spectrum.
#[track_caller]
pub(crate) fn first(name: &str, content: impl AsRef<[u8]>) -> NamedSpectrum {
    read(name, content).spectra.remove(0)
}

/// Why it is refused.
#[track_caller]
pub(crate) fn refusal(name: &str, content: impl AsRef<[u8]>) -> String {
    match read_bytes(name, content.as_ref()) {
        Ok(reading) => panic!("{name} was read: {:?}", reading.notes),
        Err(why) => why.to_string(),
    }
}

/// What its spectra are called.
pub(crate) fn names(reading: &Reading) -> Vec<&str> {
    reading.spectra.iter().map(|s| s.name.as_str()).collect()
}

/// Whether one of some notes has these words in it.
pub(crate) fn has(notes: &[String], words: &str) -> bool {
    notes.iter().any(|note| note.contains(words))
}

/// That these words are in one of some notes.
#[track_caller]
pub(crate) fn assert_told(notes: &[String], words: &str) {
    assert!(has(notes, words), "{words} is not in {notes:?}");
}

/// A zip archive of members by their names.
pub(crate) fn zipped(members: &[(&str, &[u8])]) -> Vec<u8> {
    use std::io::Write;
    use zip::write::{SimpleFileOptions, ZipWriter};
    let mut zip = ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, content) in members {
        let options =
            SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
        zip.start_file(*name, options).expect("a member");
        zip.write_all(content).expect("its content");
    }
    zip.finish().expect("an archive").into_inner()
}
