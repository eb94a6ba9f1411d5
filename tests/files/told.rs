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
