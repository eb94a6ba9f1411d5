//! pbrt and Mitsuba `.spd`: one wavelength in nm and one value a line, `#` comments, nothing else.

use crate::told::{assert_told, first, read, refusal};
use spectral_explorer::spectrum::Kind;

#[test]
fn pairs_and_comments_are_read() {
    let reading = read("lamp.spd", "# a lamp\n400 0.5 # first\n\n500\t1.5\n");
    assert_eq!(reading.format, "pbrt .spd");
    assert_eq!(reading.spectra[0].samples.values(), [0.5, 1.5]);
    assert_eq!(reading.spectra[0].kind, Kind::Light);
}

#[test]
fn optical_constants_are_neither_light_nor_reflectance() {
    for name in ["Au.eta.spd", "Cu.k.spd"] {
        let spectrum = first(name, "400 0.5\n500 0.7\n");
        assert_eq!(spectrum.kind, Kind::Other);
        assert_told(&spectrum.notes, "file's name");
    }
}

#[test]
fn anything_but_pairs_is_refused_with_its_line() {
    for (row, found, expected) in [
        ("500 abc", "\"abc\"", "a wavelength in nm and a value"),
        ("500 1 2", "3 numbers", "a wavelength in nm and one value"),
        ("500", "\"500\"", "a value after the wavelength"),
    ] {
        let said = format!("a.spd, line 2: found {found}, expected {expected}");
        assert_eq!(refusal("a.spd", format!("400 1\n{row}\n")), said);
    }
}
