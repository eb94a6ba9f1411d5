//! The README tells the truth: its picture, its commands, its map.

#[path = "common/root.rs"]
mod root;

use std::{collections::BTreeSet, fs};

use root::root;
use spectral_explorer::{
    app::{App, workspace::Preferences},
    ui::picture,
};

fn readme() -> String {
    fs::read_to_string(root().join("README.md")).expect("a README")
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

#[test]
fn the_two_commands_and_the_picture_are_there() {
    let readme = readme();
    for words in [
        "cargo run --release",
        "cargo test",
        "tests/pictures/readme.png",
    ] {
        assert!(readme.contains(words), "{words}");
    }
}

#[test]
fn the_map_names_every_folder_of_src_and_every_preset_file_has_its_row() {
    let readme = readme();
    let mut folders = vec![root().join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of src") {
            let entry = entry.expect("an entry");
            let name = entry.file_name().to_string_lossy().into_owned();
            let is_module = name != "mod.rs" && name.ends_with(".rs");
            if entry.path().is_dir() && name != "fonts" {
                assert!(
                    readme.contains(&format!("{name}/")),
                    "{name}/ is not on the map"
                );
                folders.push(entry.path());
            } else if is_module && entry.path().ends_with(format!("src/cli/{name}")) {
                let word = name.trim_end_matches(".rs");
                assert!(
                    readme.contains(word),
                    "the command {word} is not on the map"
                );
            }
        }
    }
    let table: BTreeSet<&str> = readme
        .lines()
        .filter(|line| line.starts_with("| `"))
        .flat_map(|line| line.split('|').nth(1).unwrap_or_default().split('`'))
        .collect();
    for entry in fs::read_dir(root().join("presets")).expect("presets") {
        let name = entry.expect("an entry").file_name();
        let name = name.to_string_lossy();
        let Some(group) = name.strip_suffix(".json") else {
            continue;
        };
        let named = table.iter().any(|pattern| {
            *pattern == group
                || pattern
                    .strip_suffix('*')
                    .is_some_and(|start| !start.is_empty() && group.starts_with(start))
        });
        assert!(named, "{group} has no row in the table of data");
    }
}
