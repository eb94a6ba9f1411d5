//! Spectral OpenEXR out: a picture of reflectances, one channel a band.

use crate::told::read;
use spectral_explorer::io::reflectance_exr;

#[test]
fn a_picture_reads_back_as_its_bands() {
    let bands = [400.0, 455.5, 700.0];
    let planes: Vec<Vec<f32>> = (0..3).map(|b| vec![0.25 * b as f32; 6]).collect();
    let facts = [("light", "CIE D65".to_owned())];
    let file = reflectance_exr([3, 2], &bands, planes, &facts).unwrap();
    let reading = read("a.exr", file);
    let image = &reading.images[0];
    assert!(image.kind.is_factor());
    assert_eq!([image.cube.width(), image.cube.height()], [3, 2]);
    let pixel = image.pixel(2, 1).unwrap();
    assert_eq!(pixel.samples.nm(), bands);
    assert_eq!(pixel.samples.values(), [0.0, 0.25, 0.5]);
    let wrong = reflectance_exr([3, 2], &bands, vec![vec![0.0; 6]; 2], &[]);
    assert!(wrong.is_err());
}
