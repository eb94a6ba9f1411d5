//! The README tells the truth: its picture.

use std::fs;

use crate::root::root;
use spectral_explorer::{
    app::{App, workspace::Preferences},
    ui::picture,
};

/// Width, height and samples of a PNG file's bytes.
fn pixels(bytes: &[u8]) -> ([u32; 2], Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .expect("a PNG file");
    let mut samples = vec![0; reader.output_buffer_size().expect("a size that fits")];
    let info = reader.next_frame(&mut samples).expect("a whole picture");
    samples.truncate(info.buffer_size());
    ([info.width, info.height], samples)
}

#[test]
fn the_picture_is_what_render_draws() {
    let shown = fs::read(root().join("tests/pictures/readme.png")).expect("the README's picture");
    let (size, shown) = pixels(&shown);
    let drawn = picture::window_png(&App::new(), &Preferences::default(), size);
    let (_, drawn) = pixels(&drawn);
    assert_eq!(shown.len(), drawn.len());
    let different = shown
        .iter()
        .zip(&drawn)
        .filter(|(a, b)| a.abs_diff(**b) > 8)
        .count();
    // The painter is deterministic; a font rasteriser may round differently on another CPU.
    assert!(
        different * 1000 < shown.len(),
        "{different} of {} samples differ: draw it anew with `spectral-explorer render FL11 --out \
         tests/pictures/readme.png`",
        shown.len()
    );
}
