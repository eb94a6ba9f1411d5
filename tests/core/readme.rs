//! The README is a short front door, and what it shows is there: commands, pictures, places, data.

use std::{collections::BTreeSet, fs};

use super::{
    docs::{document, quoted, rows},
    root::root,
};
use spectral_explorer::{
    app::{Library, pages::Place},
    spectrum::Kind,
};

/// Most lines of a front door.
const MOST_LINES: usize = 200;

fn readme() -> String {
    document("README.md")
}

/// The names of the files in a folder of the project.
fn files_in(folder: &str) -> BTreeSet<String> {
    fs::read_dir(root().join(folder))
        .expect(folder)
        .map(|entry| entry.expect("an entry").file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .collect()
}

#[test]
fn it_is_short_and_has_the_two_commands() {
    let readme = readme();
    let lines = readme.lines().count();
    assert!(lines <= MOST_LINES, "{lines} lines: the rest goes to docs/");
    for words in ["cargo run --release", "cargo test --release"] {
        let is_command = |line: &str| line.starts_with(words);
        assert!(readme.lines().any(is_command), "{words}");
    }
}

#[test]
fn it_shows_every_picture_and_tells_the_command_that_draws_it() {
    let readme = readme();
    let shown: BTreeSet<String> = readme
        .split("](tests/pictures/")
        .skip(1)
        .filter_map(|rest| rest.split_once(')'))
        .map(|(name, _)| name.to_owned())
        .collect();
    assert_eq!(shown, files_in("tests/pictures"));
    assert_eq!(shown.len(), 5);
    for name in shown {
        let end = format!(" --out tests/pictures/{name}");
        let draws =
            |line: &str| line.starts_with("spectral-explorer render ") && line.ends_with(&end);
        assert!(readme.lines().any(draws), "no command draws {name}");
    }
}

#[test]
fn it_names_every_page_of_the_window_and_every_document() {
    let readme = readme();
    for page in Place::ALL {
        let start = format!("- **{}**: ", page.title());
        let is_its = |line: &str| line.starts_with(&start);
        assert!(readme.lines().any(is_its), "{} is missing", page.title());
    }
    for name in files_in("docs") {
        assert!(
            readme.contains(&format!("(docs/{name})")),
            "docs/{name} is missing"
        );
    }
}

#[test]
fn the_shipped_spectra_are_counted_right() {
    let presets = Library::bundled().presets();
    let count = presets.filter(|p| p.line_list().is_none()).count();
    for path in ["README.md", "docs/window.md"] {
        let words = format!("{count} shipped spectra");
        assert!(document(path).contains(&words), "{path}: not {words}");
    }
    // What `list` does not print unasked, as it is no light and no share of light.
    let beside = Library::bundled()
        .presets()
        .filter(|p| p.line_list().is_none());
    let beside = beside.filter(|p| p.kind != Kind::Light && !p.kind.is_factor());
    assert_eq!(
        beside.count(),
        25 + 3,
        "curves of the eye, components of daylight"
    );
}

#[test]
fn every_preset_file_has_its_row_in_the_table_of_data() {
    let readme = readme();
    let rows = rows(&readme);
    let named: Vec<&str> = rows.iter().flat_map(|row| quoted(row[0])).collect();
    for file in files_in("presets") {
        let Some(group) = file.strip_suffix(".json") else {
            continue;
        };
        let is_its = |pattern: &&str| {
            *pattern == group
                || pattern
                    .strip_suffix('*')
                    .is_some_and(|start| !start.is_empty() && group.starts_with(start))
        };
        assert!(
            named.iter().any(is_its),
            "{group} has no row in the table of data"
        );
    }
}
