//! What a person decides where a file leaves it open, or was misread.

use spectral_explorer::{
    io::{
        Choices, Counted, Delimiter, Dialect, Guessed, WavelengthUnit, read_bytes, read_bytes_as,
    },
    spectrum::{Kind, NamedSpectrum},
};

fn read(text: &str, choices: Choices) -> NamedSpectrum {
    let reading = read_bytes_as("a.csv", text.as_bytes(), &choices);
    reading.expect("a table").spectra.remove(0)
}

#[test]
fn every_decision_of_the_reader_can_be_turned_round() {
    let text = "0.38,50,7\n0.39,60,8\n0.40,70,9\n";
    let plain = read(text, Choices::default());
    assert_eq!(plain.samples.nm(), [380.0, 390.0, 400.0]);
    let nanometre = Choices {
        wavelengths: Some(WavelengthUnit::Nanometre),
        ..Choices::default()
    };
    assert_eq!(read(text, nanometre).samples.nm(), [0.38, 0.39, 0.40]);
    let percent = |percent| Choices {
        kind: Some(Kind::Reflectance),
        counted: Some(Counted::percent(percent)),
        ..Choices::default()
    };
    let (hundredths, whole) = (read(text, percent(true)), read(text, percent(false)));
    assert_eq!(hundredths.kind, Kind::Reflectance);
    assert_eq!(hundredths.scale, 0.01);
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
        counted: Some(Counted::Fraction),
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
