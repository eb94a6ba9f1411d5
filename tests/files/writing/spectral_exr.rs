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

#[test]
fn the_same_picture_is_the_same_file_each_time() {
    let facts: Vec<(String, String)> = (0..12)
        .map(|i| (format!("fact {i}"), i.to_string()))
        .collect();
    let facts: Vec<(&str, String)> = facts.iter().map(|(k, v)| (&**k, v.clone())).collect();
    let file = || reflectance_exr([3, 2], &[400.0, 500.0], vec![vec![0.5; 6]; 2], &facts).unwrap();
    // Twelve attributes in a map of random order come twice in the same by chance once in 12!.
    let first = file();
    assert_eq!(first, file());
    let place = |name: &str| {
        first
            .windows(name.len())
            .position(|some| some == name.as_bytes())
    };
    assert!(place("made.fact 0") < place("made.fact 5"));
}
