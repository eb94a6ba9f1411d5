//! What a person decided where a file leaves it open, or was misread: a file is read again with
//! these.

use super::{Dialect, Guessed, Reading, units::WavelengthUnit};
use crate::spectrum::{Kind, NamedSpectrum};

/// Decisions about one file; what is `None` the reader decides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Choices {
    /// What stands between cells and marks decimals, in plain columns.
    pub dialect: Option<Dialect>,
    /// The column of wavelengths, from 0, in plain columns.
    pub axis_column: Option<usize>,
    /// What the wavelength axis counts.
    pub wavelengths: Option<WavelengthUnit>,
    /// What the values stand for.
    pub kind: Option<Kind>,
    /// Whether values of a factor are per cent.
    pub percent: Option<bool>,
    /// Whether a light's photon counts stay what they are. Readers never touch them; where this is
    /// not set, what opens a file for its light turns them into power.
    pub keep_photons: bool,
}

impl Choices {
    /// Puts the chosen kind on spectra whose format would not hear of it; tables have it already.
    pub(super) fn impose(&self, reading: &mut Reading) {
        let Some(kind) = self.kind else { return };
        let impose = |spectrum: &mut NamedSpectrum| {
            if spectrum.kind != kind {
                spectrum.kind = kind;
                // The values are fractions now, whatever they were before.
                if kind.is_factor() {
                    "fraction".clone_into(&mut spectrum.unit);
                }
                spectrum.notes.push(CHOSEN_KIND.to_owned());
            }
        };
        reading.spectra.iter_mut().for_each(impose);
        reading
            .composites
            .iter_mut()
            .for_each(|model| model.kind = kind);
        reading.guesses.retain(|guess| guess.what != Guessed::Kind);
    }
}

/// What is noted where a person said what the values are.
const CHOSEN_KIND: &str = "the kind was chosen by hand";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{dialect::Delimiter, read_bytes, read_bytes_as};

    fn read(text: &str, choices: Choices) -> NamedSpectrum {
        let reading = read_bytes_as("a.csv", text.as_bytes(), &choices);
        reading.expect("a table").spectra.remove(0)
    }

    #[test]
    fn every_decision_of_the_reader_can_be_turned_round() {
        let text = "0.38,50,7\n0.39,60,8\n0.40,70,9\n";
        let plain = read(text, Choices::default());
        assert_eq!(plain.samples.nm(), [380.0, 390.0, 400.0]);
        let angstrom = Choices {
            wavelengths: Some(WavelengthUnit::Nanometre),
            ..Choices::default()
        };
        assert_eq!(read(text, angstrom).samples.nm(), [0.38, 0.39, 0.40]);
        let percent = |percent| Choices {
            kind: Some(Kind::Reflectance),
            percent: Some(percent),
            ..Choices::default()
        };
        let (hundredths, whole) = (read(text, percent(true)), read(text, percent(false)));
        assert_eq!(
            (hundredths.kind, hundredths.scale),
            (Kind::Reflectance, 0.01)
        );
        assert_eq!(whole.samples.values(), [50.0, 60.0, 70.0]);
        let other_axis = Choices {
            axis_column: Some(1),
            ..Choices::default()
        };
        let turned = read(text, other_axis);
        assert_eq!(turned.samples.nm(), [50.0, 60.0, 70.0]);
        assert_eq!(turned.samples.values(), [0.38, 0.39, 0.40]);
    }

    #[test]
    fn a_decimal_comma_can_be_told() {
        // Three columns of whole numbers, or two with decimals: only a person knows.
        let text = "380,5 1\n381,5 2\n382,5 3\n";
        let comma = Choices {
            dialect: Some(Dialect {
                delimiter: Delimiter::Space,
                decimal_comma: true,
            }),
            ..Choices::default()
        };
        assert_eq!(read(text, comma).samples.nm(), [380.5, 381.5, 382.5]);
    }

    #[test]
    fn what_was_chosen_is_no_guess_any_more() {
        let text = b"380,0.5\n385,0.6\n390,0.7\n";
        let guessed = read_bytes("a.csv", text).expect("a table");
        assert!(guessed.guesses.iter().any(|g| g.what == Guessed::Kind));
        let choices = Choices {
            kind: Some(Kind::Transmittance),
            wavelengths: Some(WavelengthUnit::Nanometre),
            percent: Some(false),
            ..Choices::default()
        };
        let chosen = read_bytes_as("a.csv", text, &choices).expect("a table");
        assert_eq!(chosen.guesses, []);
        assert_eq!(chosen.spectra[0].kind, Kind::Transmittance);
    }

    #[test]
    fn a_column_that_is_not_there_is_refused_in_words() {
        let choices = Choices {
            axis_column: Some(7),
            ..Choices::default()
        };
        let refusal = read_bytes_as("a.csv", b"380,1\n390,2\n", &choices).expect_err("two columns");
        assert!(refusal.to_string().contains("2 columns"), "{refusal}");
    }
}
