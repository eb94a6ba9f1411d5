//! Macam spectroradiometers `.DTA`: date and time behind `@`, then one number a line.

use crate::told::{read, refusal};

#[test]
fn unit_and_title_are_known() {
    let text = "@1/5/1997\n@17:44\n#Lamp 3\n 2.5E+02\n 0.0\n 2.51E+02\n 0.5\n 2.52E+02\n 1.0\n 2.53E+02\n 0.5\n 2.54E+02\n 0.25\n";
    for text in [
        text.to_owned(),
        text.replace('\n', "\r\n"),
        text.replace('.', ","),
    ] {
        let reading = read("a.DTA", text);
        let spectrum = &reading.spectra[0];
        assert_eq!((reading.format, &*spectrum.name), ("Macam", "Lamp 3"));
        assert_eq!(spectrum.unit, "W m-2 nm-1");
        assert_eq!(spectrum.samples.len(), 5);
    }
    let why = refusal("a.DTA", "@1/5/1997\n@17:44\n#x\n");
    assert!(why.contains("line 3: found no wavelengths"), "{why}");
}
