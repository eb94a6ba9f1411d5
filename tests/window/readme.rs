//! The README tells the truth: its pictures.

use std::{ffi::OsString, fs};

use crate::root::root;
use spectral_explorer::{
    app::{App, chart::Theme, charts::spectrum::spectrum_chart, workspace::Preferences},
    cli::{self, Outcome, Pictures},
    ui::picture,
};

/// Draws as the program does.
struct Painted;

impl Pictures for Painted {
    fn window(&self, app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8> {
        picture::window_png(app, preferences, size)
    }

    fn plot(&self, app: &App, theme: Theme, size: [u32; 2]) -> Vec<u8> {
        picture::chart_png(&spectrum_chart(app), size, theme)
    }
}

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

/// Where the README says its pictures are.
const PICTURES: &str = "tests/pictures/";

#[test]
fn every_picture_is_what_its_command_draws() {
    let readme = fs::read_to_string(root().join("README.md")).expect("a README");
    let folder = tempfile::tempdir().expect("a folder");
    let is_render = |line: &&str| line.starts_with("spectral-explorer render ");
    let mut pictures = 0;
    for command in readme.lines().filter(is_render) {
        let Some((words, name)) = command.split_once(PICTURES) else {
            continue;
        };
        pictures += 1;
        let path = folder.path().join(name);
        let words = words.split_whitespace().map(OsString::from);
        let words = words.chain([path.clone().into_os_string()]);
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let outcome = cli::run(words, Some(&Painted), &mut out, &mut err);
        let err = String::from_utf8_lossy(&err);
        assert_eq!(outcome, Outcome::Done(0), "{command}: {err}");

        let shown = fs::read(root().join(PICTURES).join(name)).expect("the README's picture");
        let (size, shown) = pixels(&shown);
        let (drawn_size, drawn) = pixels(&fs::read(&path).expect("a picture"));
        assert_eq!((size, shown.len()), (drawn_size, drawn.len()), "{name}");
        let different = shown
            .iter()
            .zip(&drawn)
            .filter(|(a, b)| a.abs_diff(**b) > 8)
            .count();
        // The painter is deterministic; a font rasteriser may round differently on another CPU.
        assert!(
            different * 1000 < shown.len(),
            "{different} of {} samples differ: draw it anew with `{command}`",
            shown.len()
        );
    }
    assert_eq!(pictures, 5);
}
