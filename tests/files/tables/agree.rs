//! Per cent or fraction is one answer for all spectra of a kind in a file.

use crate::told::read;

#[test]
fn a_dark_patch_beside_a_bright_one_is_counted_alike() {
    let text = "nm,Reflectance black,Reflectance white\n400,0.6,91\n410,0.7,92\n420,0.7,91.5\n";
    let reading = read("patches.csv", text);
    let [black, white] = &reading.spectra[..] else {
        panic!("{reading:?}");
    };
    assert_eq!((black.scale, white.scale), (0.01, 0.01));
    assert!((black.samples.values()[1] - 0.007).abs() < 1e-12);
    assert!(black.notes[0].contains("fraction, from per cent"));
    let others = |note: &String| note.ends_with("others in the file reach 92.000");
    assert!(black.notes.iter().any(others));
    assert!(!reading.is_doubtful(), "{:?}", reading.guesses);
}

#[test]
fn fractions_alone_and_what_a_title_states_stay() {
    let text = "nm,Reflectance a,Reflectance b (%)\n400,0.6,91\n410,0.7,92\n420,0.7,91.5\n";
    assert_eq!(read("patches.csv", text).spectra[0].scale, 1.0);
    let alone = "nm,Reflectance a,Reflectance b\n400,0.6,0.1\n410,0.7,0.1\n";
    let spectra = read("patches.csv", alone).spectra;
    assert!(spectra.iter().all(|s| s.scale == 1.0));
}
