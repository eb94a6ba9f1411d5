//! USGS spectral library 7 (splib07): one number a line, the wavelengths in a file of their own.

use crate::told::{first, refusal};
use spectral_explorer::io::read_path;
use spectral_explorer::spectrum::Kind;

fn file(title: &str, values: &[&str]) -> String {
    let values = values.join("\r\n ");
    format!(" splib07a Record=7: {title}\r\n {values}\r\n")
}

#[test]
fn the_wavelengths_beside_are_taken_in_micrometres() {
    let folder = tempfile::tempdir().unwrap();
    let (asd, beck) = (
        "Wavelengths ASD 0.4-0.6 microns",
        "Wavelengths BECK 0.4-0.6 microns",
    );
    for (name, title, values) in [
        (
            "splib07a_Wavelengths_ASD_3_ch.txt",
            asd,
            ["0.9", "1.0", "1.1"],
        ),
        (
            "splib07a_Wavelengths_BECK_3_ch.txt",
            beck,
            ["0.4", "0.5", "0.6"],
        ),
        (
            "splib07a_Alunite_BECKa_AREF.txt",
            "Alunite X   BECKa AREF",
            ["0.1", "-1.23e34", "0.3"],
        ),
    ] {
        std::fs::write(folder.path().join(name), file(title, &values)).unwrap();
    }
    let reading = read_path(&folder.path().join("splib07a_Alunite_BECKa_AREF.txt")).unwrap();
    let spectrum = &reading.spectra[0];
    assert_eq!(reading.format, "USGS splib07");
    assert_eq!(spectrum.name, "Alunite X BECKa");
    assert_eq!(spectrum.kind, Kind::Reflectance);
    assert_eq!(spectrum.samples.nm(), [400.0, 600.0], "-1.23e34 is a gap");
}

#[test]
fn a_library_of_any_name_keeps_its_wavelengths_in_the_folder_above() {
    let library = tempfile::tempdir().unwrap();
    let chapter = library.path().join("ChapterM");
    std::fs::create_dir(&chapter).unwrap();
    let wavelengths = " ours Record=1: Wavelengths AVIRIS um\n 0.4\n 0.5\n 0.6\n";
    let beside = library.path().join("ours_Wavelengths_AVIRIS.txt");
    std::fs::write(beside, wavelengths).unwrap();
    let file = chapter.join("ours_Glass_AVIRISb_TRAN.txt");
    let glass = " ours Record=2: Glass AVIRISb TRAN\n 0.8\n 0.9\n 0.7\n";
    std::fs::write(&file, glass).unwrap();
    let spectrum = &read_path(&file).unwrap().spectra[0];
    assert_eq!(spectrum.kind, Kind::Transmittance);
    assert_eq!(spectrum.samples.nm(), [400.0, 500.0, 600.0]);
}

#[test]
fn an_asd_needs_no_file_beside_and_others_are_told_which() {
    let values = vec!["0.5"; 2151];
    let samples = first("a.txt", file("Brick ASDFRa AREF", &values)).samples;
    assert_eq!((samples.first_nm(), samples.last_nm()), (350.0, 2500.0));
    assert_eq!(
        refusal("a.txt", file("Alunite BECKa AREF", &["0.1", "0.2"])),
        "a.txt: found 2 lines of one number each and no wavelengths beside, expected the library's file of wavelengths of BECK in the same folder (splib07a_Wavelengths_BECK..._2_ch.txt)"
    );
    let own = refusal("a.txt", file("Wavelengths ASD microns", &["0.1"]));
    assert!(own.contains("a list of the library's wavelengths"));
}
