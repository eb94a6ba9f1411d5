//! One number a line: wavelengths and values by turns, as Macam radiometers write them.

use spectral_explorer::io::read_bytes;

#[test]
fn wavelengths_and_values_by_turns_are_read() {
    let text = "@19/5/1997\n#No Title\n 2.5E+02\n 0.0\n 2.51E+02\n 0.5\n 2.52E+02\n 1.0\n 2.53E+02\n 0.5\n 2.54E+02\n 0.25\n";
    let reading = read_bytes("a.DTA", text.as_bytes()).unwrap();
    let samples = &reading.spectra[0].samples;
    assert_eq!(samples.nm()[4], 254.0);
    assert_eq!(samples.values(), [0.0, 0.5, 1.0, 0.5, 0.25]);
}

#[test]
fn a_list_of_wavelengths_alone_is_refused() {
    let rising: String = (0..20).map(|i| format!("{}\n", 380 + 10 * i)).collect();
    let refusal = read_bytes("a.txt", rising.as_bytes()).unwrap_err();
    assert_eq!(refusal.found, "20 lines of one number each");
    let falling: String = (0..21).map(|i| format!("{}\n", 780 - 10 * i)).collect();
    assert!(read_bytes("a.txt", falling.as_bytes()).is_err());
}

#[test]
fn values_without_wavelengths_are_refused_in_words() {
    let text = "Record 1\n".to_owned() + &"0.5\n0.6\n0.4\n".repeat(5);
    let refusal = read_bytes("a.txt", text.as_bytes()).unwrap_err();
    let said = "found 15 lines of one number each, expected a wavelength beside each value";
    assert_eq!(refusal.to_string(), format!("a.txt, line 2: {said}"));
}
