//! IES TM-27-14 `.spdx`: XML with a header, a spectral quantity and irregular samples.

use crate::told::{first, read};
use spectral_explorer::{io::Guessed, spectrum::Kind};

fn file(quantity: &str, data: &str) -> String {
    format!(
        "<?xml version=\"1\"?>\n<x:IESTM2714 xmlns:x=\"http://www.ies.org/iestm2714\">\n<x:Header>\
         <x:Description>A &amp; B</x:Description><x:ReportDate>Unknown</x:ReportDate></x:Header>\n\
         <x:SpectralDistribution><x:SpectralQuantity>{quantity}</x:SpectralQuantity>\
         <x:BandwidthFWHM>Unknown</x:BandwidthFWHM>\n{data}\n\
         </x:SpectralDistribution></x:IESTM2714>"
    )
}

fn refusal(text: &str) -> String {
    crate::told::refusal("a.spdx", text)
}

const DATA: &str = "<x:SpectralData wavelength=\"400.5\">0.47</x:SpectralData>\n\
                    <x:SpectralData wavelength=\"410\"> 0.51 </x:SpectralData>";

#[test]
fn any_namespace_and_unknown_fields_are_read() {
    let reading = read("a.spdx", file("irradiance", DATA));
    let spectrum = &reading.spectra[0];
    assert_eq!(spectrum.samples.nm(), [400.5, 410.0]);
    assert_eq!(spectrum.samples.values(), [0.47, 0.51]);
    assert_eq!((&*spectrum.name, &*spectrum.unit), ("A & B", "W m-2 nm-1"));
    assert!(reading.guesses.is_empty());
}

#[test]
fn a_quantity_that_is_none_is_a_guess() {
    let reading = read("a.spdx", file("W/nm", DATA));
    assert_eq!(reading.spectra[0].unit, "W/nm");
    assert_eq!(reading.guesses[0].what, Guessed::Kind);
}

#[test]
fn every_quantity_has_a_kind() {
    for (word, kind) in [
        ("flux", Kind::Light),
        ("absorptance", Kind::Other),
        ("transmittance", Kind::Transmittance),
        ("reflectance", Kind::Reflectance),
        ("intensity", Kind::Light),
        ("irradiance", Kind::Light),
        ("radiance", Kind::Light),
        ("exitance", Kind::Light),
        ("R-Values", Kind::Reflectance),
        ("T-Values", Kind::Transmittance),
        ("R-Factor", Kind::Reflectance),
        ("T-Factor", Kind::Transmittance),
        ("relative", Kind::Light),
        ("other", Kind::Other),
    ] {
        assert_eq!(first("a.spdx", file(word, DATA)).kind, kind, "{word}");
    }
}

#[test]
fn what_is_no_tm_27_is_refused_in_words() {
    assert_eq!(
        refusal("<?xml version=\"1.0\"?>\n<item></item>\n"),
        "a.spdx, line 2: found <item> as the outermost element, expected <IESTM2714>"
    );
    assert!(refusal("400 0.5\n").contains("text that is no XML"));
    assert!(refusal("<IESTM2714><a></IESTM2714>").contains("line 1: found broken XML"));
    assert!(refusal("<IESTM2714></IESTM2714>").contains("no <SpectralDistribution>"));
    let bad = DATA.replace("0.47", "abc");
    assert!(refusal(&file("flux", &bad)).contains("line 5: found \"abc\", expected a number"));
}

#[test]
fn a_bomb_of_entities_is_refused() {
    let bomb = "<!DOCTYPE a [<!ENTITY b \"bbbbbbbb\"><!ENTITY c \"&b;&b;&b;\">]><IESTM2714>&c;</IESTM2714>";
    assert!(refusal(bomb).contains("with a DTD"));
    let deep = "<IESTM2714>".to_owned() + &"<a>".repeat(100_000);
    assert!(refusal(&deep).contains("broken XML"));
}
