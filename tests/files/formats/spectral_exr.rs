//! Spectral OpenEXR: an image with one channel a wavelength.

use crate::open_exr;
use crate::told::{has, read, refusal};
use exr::prelude::Encoding;
use spectral_explorer::spectrum::Kind;

fn exr(size: (usize, usize), names: &[&str]) -> Vec<u8> {
    open_exr::exr(size, names, Encoding::FAST_LOSSLESS)
}

#[test]
fn patches_become_spectra_and_a_picture_an_image() {
    let names = ["B", "T.500,0nm", "T.400,0nm", "T.400,0nm.500,0nm"];
    let reading = read("p.exr", exr((3, 2), &names));
    assert_eq!(reading.spectra.len(), 6);
    assert_eq!(reading.spectra[4].name, "p, row 1 column 1");
    assert_eq!(reading.spectra[4].samples.values(), [42.0, 41.0]);
    assert_eq!(reading.spectra[0].kind, Kind::Reflectance);
    assert!(has(&reading.notes, "1 channels of fluorescence"));
    let picture = read("q.exr", exr((30, 20), &["S0.400,0nm", "S0.500,0nm"]));
    assert_eq!((picture.spectra.len(), picture.images.len()), (0, 1));
    assert_eq!(picture.images[0].kind, Kind::Light);
    assert_eq!(picture.images[0].cube.value(29, 19, 1), 5991.0);
}

#[test]
fn a_picture_without_spectra_is_refused_by_its_channels() {
    assert_eq!(
        refusal("a.exr", exr((4, 4), &["B", "G", "R"])),
        "a.exr: found an OpenEXR image of the channels \"B G R\", expected two or more \
         spectral channels such as \"S0.380,0nm\" or \"T.380,0nm\""
    );
}
