//! What comes out of a file beside its numbers: names apart, holes, and what makers computed.

use spectral_explorer::io::{MakersResult, Quantity, Reading};
use spectral_explorer::spectrum::{Kind, NamedSpectrum, Sampled};

fn spectrum(name: &str) -> NamedSpectrum {
    NamedSpectrum {
        name: name.to_owned(),
        kind: Kind::Light,
        unit: "W m-2 nm-1".to_owned(),
        scale: 1.0,
        samples: Sampled::even(380.0, 5.0, vec![1.0, -0.5, 2.0]).unwrap(),
        notes: Vec::new(),
        source: String::new(),
    }
}

#[test]
fn a_hole_is_told_with_its_share_of_the_range_and_once() {
    let nm: Vec<f64> = (380..=420).chain(680..=780).map(f64::from).collect();
    let values = vec![1.0; nm.len()];
    let mut holed = spectrum("a");
    holed.samples = Sampled::new(nm, values).unwrap();
    let mut reading = Reading {
        spectra: vec![holed],
        ..Reading::default()
    };
    reading.tell_holes();
    reading.tell_holes();
    assert_eq!(
        reading.spectra[0].notes,
        ["nothing measured between 420 and 680 nm, 65 % of the range"]
    );
}

#[test]
fn spectra_of_one_name_are_told_apart_and_a_name_that_ends_in_a_count_is_kept_for_its_own() {
    for (names, apart) in [
        (&["a", "b", "a"][..], &["a", "b", "a (2)"][..]),
        (
            &["a", "a (2)", "a", "a (2)"],
            &["a", "a (2)", "a (3)", "a (2) (2)"],
        ),
    ] {
        let mut reading = Reading {
            spectra: names.iter().map(|name| spectrum(name)).collect(),
            ..Reading::default()
        };
        reading.name_apart();
        let found: Vec<&str> = reading.spectra.iter().map(|s| &*s.name).collect();
        assert_eq!(found, apart);
    }
}

#[test]
fn keys_of_several_makers_name_the_same_quantities() {
    for (key, quantity, unit) in [
        ("CCT", Quantity::Cct, "K"),
        ("Tcp [K]", Quantity::Cct, "K"),
        ("CCT(K)", Quantity::Cct, "K"),
        ("⊿uv", Quantity::Duv, ""),
        ("Duv", Quantity::Duv, ""),
        ("CRI", Quantity::Ra, ""),
        ("CRI Ra", Quantity::Ra, ""),
        ("CRI R9", Quantity::R(9), ""),
        ("R15", Quantity::R(15), ""),
        ("TM-30 Rf", Quantity::Rf, ""),
        ("Rg", Quantity::Rg, ""),
        ("LUX", Quantity::Illuminance, "lx"),
        ("Illuminance [lx]", Quantity::Illuminance, "lx"),
        ("PPFD [umolm⁻²s⁻¹]", Quantity::Ppfd, "umolm⁻²s⁻¹"),
        ("X", Quantity::TristimulusX, ""),
        ("x", Quantity::ChromaticityX, ""),
        ("Tristimulus Value Z", Quantity::TristimulusZ, ""),
        ("CIE1931 y", Quantity::ChromaticityY, ""),
        ("CIE1976 u'", Quantity::UPrime, ""),
        ("LambdaP", Quantity::PeakNm, "nm"),
        ("Peak Wavelength [nm]", Quantity::PeakNm, "nm"),
        ("R:B", Quantity::Other("R:B".to_owned()), ""),
        ("fc", Quantity::Other("Illuminance".to_owned()), "fc"),
        (
            "Custom1(655~665nm)",
            Quantity::Other("Custom1(655~665nm)".to_owned()),
            "",
        ),
        (
            "Ratio1(Custom1:Custom2)",
            Quantity::Other("Ratio1(Custom1:Custom2)".to_owned()),
            "",
        ),
        ("R16", Quantity::Other("R16".to_owned()), ""),
    ] {
        assert_eq!(Quantity::of_key(key), (quantity, unit.to_owned()), "{key}");
    }
}

#[test]
fn a_value_may_carry_its_unit_and_a_word_is_no_result() {
    let cct = MakersResult::of(Some(0), "CCT", "5528K", false).unwrap();
    assert_eq!((cct.value, cct.unit.as_str()), (5528.0, "K"));
    let ra = MakersResult::of(None, "CRI", "92,5", true).unwrap();
    assert_eq!((ra.quantity, ra.value), (Quantity::Ra, 92.5));
    assert_eq!(MakersResult::of(None, "SSI1", "---", false), None);
    assert_eq!(MakersResult::of(None, "Time", "2021/01/04", false), None);
    let candles = MakersResult::of(None, "Illuminance [fc]", "2.79", false).unwrap();
    assert_eq!(candles.quantity, Quantity::Other("Illuminance".to_owned()));
}
