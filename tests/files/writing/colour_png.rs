//! Pictures of colours.

use crate::root::root;
use spectral_explorer::io::{ColourPixels, ColourPng};
use std::path::Path;

#[test]
fn a_pixel_has_the_same_colour_in_one_byte_and_in_two() {
    let bytes: Vec<u8> = (0..18).map(|i| i * 14).collect();
    let words = bytes.iter().map(|b| u16::from(*b) * 257).collect();
    let of = |pixels| ColourPng {
        size: [3, 2],
        pixels,
    };
    let (small, large) = (
        of(ColourPixels::Eight(bytes)),
        of(ColourPixels::Sixteen(words)),
    );
    assert_eq!(small.pixel(1, 1), Some([168, 182, 196]));
    for (x, y) in [(0, 0), (2, 1), (3, 0), (0, 2)] {
        assert_eq!(small.pixel(x, y), large.pixel(x, y));
    }
    assert_eq!(small.pixel(3, 0), None);
}

#[test]
fn what_is_no_picture_is_refused_in_words() {
    let missing = ColourPng::read(Path::new("/nowhere/at/all.png"), 100);
    assert!(missing.is_err_and(|why| why.contains("expected a file")));
    let text = root().join("Cargo.toml");
    let text = ColourPng::read(&text, 100);
    assert!(text.is_err_and(|why| why.contains("expected a PNG picture")));
    let large = root().join("tests/pictures/readme.png");
    let large = ColourPng::read(&large, 100);
    assert!(large.is_err_and(|why| why.contains("at most 100 pixels")));
}
