//! LI-COR LI-1800 `.PRN`: quoted header lines, then wavelengths in nm and values.

use crate::told::{first, read, refusal};
use spectral_explorer::spectrum::Kind;

const SMALL: &str = "\"FILE:FL2\"\n\"REM: TLD 36W       (QNTM)\"\n\"LIMS: 300- 302NM\"\n\"INT:  1NM\"\n\"MAX:  301NM  7.5E-01\"\n 300  1.5E-04\n 301  7.5E-01\n 302 -1E-04\n";

#[test]
fn photons_name_and_peak_are_read() {
    let reading = read("a.PRN", SMALL);
    let spectrum = &reading.spectra[0];
    assert_eq!(reading.format, "LI-COR LI-1800");
    assert_eq!(spectrum.name, "TLD 36W");
    assert_eq!(spectrum.unit, "µmol m-2 s-1 nm-1");
    assert_eq!(spectrum.samples.values(), [1.5e-4, 0.75, -1e-4]);
    assert_eq!(reading.results[0].value, 301.0);
    let watt = SMALL.replace("QNTM", "WATT").replace('\n', "\r\n");
    assert_eq!(first("a.PRN", watt).unit, "W m-2 nm-1");
}

#[test]
fn a_remark_without_a_unit_may_name_a_reflectance() {
    let leaf = SMALL.replace("TLD 36W       (QNTM)", "REFL OAK AD 1 ");
    let spectrum = first("a.PRN", leaf);
    assert_eq!(spectrum.kind, Kind::Reflectance);
    assert_eq!((spectrum.unit.as_str(), spectrum.scale), ("fraction", 1.0));
    let lamp = SMALL.replace("TLD", "REFLECTOR TLD");
    assert_eq!(first("a.PRN", lamp).kind, Kind::Light);
}

#[test]
fn a_broken_row_is_refused_with_its_line() {
    assert_eq!(
        refusal("a.PRN", SMALL.replace("7.5E-01\n 302", "x\n 302")),
        "a.PRN, line 7: found \"x\", expected a wavelength in nm and a value"
    );
}
