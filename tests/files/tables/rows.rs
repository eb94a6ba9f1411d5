//! Tables with their wavelengths along a row: one spectrum in each further row.

use spectral_explorer::io::read_bytes;
use spectral_explorer::spectrum::Kind;

#[test]
fn the_corner_of_a_table_along_rows_tells_what_is_measured() {
    let text =
        "Reflectance,400,410,420,430,440\nleaf,0.1,0.2,0.3,0.4,0.5\nsoil,0.2,0.2,0.3,0.3,0.3\n";
    let spectra = read_bytes("a.csv", text.as_bytes()).unwrap().spectra;
    assert!(spectra.iter().all(|s| s.kind == Kind::Reflectance));
    let text = "wavelength,400,410,420,430,440\nRefl %,10,20,30,40,50\n";
    let leaf = &read_bytes("a.csv", text.as_bytes()).unwrap().spectra[0];
    assert_eq!((leaf.kind, leaf.scale), (Kind::Reflectance, 0.01));
}

#[test]
fn a_row_is_named_by_its_words_and_its_kind_by_a_cell_of_its_own() {
    let text = "id,mode,lux,400,410,420,430,440\n1,Reflectance,3.5,10,20,30,40,50\n2,Transmittance,4.5,1,2,3,4,5\n";
    let spectra = read_bytes("leaf.csv", text.as_bytes()).unwrap().spectra;
    assert_eq!(spectra[0].name, "Reflectance");
    let kinds: Vec<Kind> = spectra.iter().map(|s| s.kind).collect();
    assert_eq!(kinds, [Kind::Reflectance, Kind::Transmittance]);
    assert_eq!(spectra[0].scale, 0.01);
    let numbered = "id,400,410,420,430,440\n7,1,2,3,4,5\n";
    let spectra = read_bytes("a.csv", numbered.as_bytes()).unwrap().spectra;
    assert_eq!(spectra[0].name, "a, row 7");
}
