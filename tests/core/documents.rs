//! The documents tell the truth: the map, the formats, the places of the window, the tests that
//! they name, and their links. `tests/app/command_line.rs` holds docs/command_line.md to the
//! program.

use std::{collections::BTreeSet, fs, path::Path};

use super::{
    docs::{document, quoted, rows, section},
    root::root,
};
use spectral_explorer::{
    app::{
        open::{batch, folders},
        pages::{Page, Place},
    },
    io::{FORMATS, MOST_BYTES, MOST_BYTES_OF_A_FORMAT, MOST_CELLS, MOST_COLUMNS, WRITABLE, budget},
};

/// Every folder of `src` and every file of Rust in them, by their paths in the project.
fn source_tree() -> (BTreeSet<String>, Vec<String>) {
    let (mut folders, mut files) = (BTreeSet::new(), Vec::new());
    let mut next = vec!["src/".to_owned()];
    while let Some(folder) = next.pop() {
        for entry in fs::read_dir(root().join(&folder)).expect("a folder of src") {
            let entry = entry.expect("an entry");
            let path = format!("{folder}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                next.push(format!("{path}/"));
            } else if path.ends_with(".rs") {
                files.push(path);
            }
        }
        folders.insert(folder);
    }
    (folders, files)
}

/// The folders of `src` that have a row on the map, from above.
fn folders_on(map: &str) -> Vec<&str> {
    let rows = rows(map);
    let names = rows.iter().flat_map(|row| quoted(row[0]));
    names.filter(|name| name.starts_with("src/")).collect()
}

#[test]
fn the_map_has_one_line_for_each_folder_of_src_and_no_other() {
    let map = document("docs/map.md");
    let told = folders_on(&map);
    let (there, _) = source_tree();
    for folder in &there {
        let lines = told.iter().filter(|name| *name == folder).count();
        assert_eq!(lines, 1, "lines of docs/map.md that tell of {folder}");
    }
    for folder in told {
        assert!(there.contains(folder), "docs/map.md: {folder} is gone");
    }
    for row in rows(&map).iter().filter(|row| row[0].starts_with("`src/")) {
        assert_eq!(row.len(), 4, "folder, what it is, in, out: {row:?}");
        assert!(row.iter().all(|cell| !cell.is_empty()), "{row:?}");
    }
}

#[test]
fn the_crates_own_map_lists_the_same_rooms_and_the_same_way_of_imports() {
    let (map, lib) = (document("docs/map.md"), document("src/lib.rs"));
    let rooms_of_lib: Vec<&str> = lib
        .lines()
        .skip_while(|line| *line != "//! ```text")
        .skip(1)
        .take_while(|line| *line != "//! ```")
        .filter_map(|line| line.trim_start_matches("//!").split_whitespace().next())
        .collect();
    let rooms_on_map: Vec<&str> = folders_on(&map)
        .into_iter()
        .filter_map(|folder| folder.strip_prefix("src/")?.strip_suffix('/'))
        .filter(|room| !room.contains('/'))
        .collect();
    assert_eq!(rooms_of_lib, rooms_on_map);
    assert_eq!(way_of_imports(&lib), way_of_imports(&map));
}

/// From `main -> ` to the end of the quotation, in one line.
fn way_of_imports(text: &str) -> String {
    let text = text.replace("//!", " ");
    let words: Vec<&str> = text.split_whitespace().collect();
    let line = words.join(" ");
    let start = line.find("main -> ").expect("the way of imports");
    line[start..]
        .split('`')
        .next()
        .unwrap_or_default()
        .to_owned()
}

#[test]
fn every_source_file_begins_with_what_it_is() {
    let (_, files) = source_tree();
    assert!(files.len() > 50, "found only {} files", files.len());
    for file in files {
        assert!(document(&file).starts_with("//! "), "{file}");
    }
}

#[test]
fn the_formats_are_told_by_the_names_and_extensions_that_the_program_knows() {
    let formats = document("docs/formats.md");
    let rows = rows(section(&formats, "## What is read"));
    let told: Vec<(&str, Vec<String>)> = rows
        .iter()
        .filter(|row| row[0].starts_with('`'))
        .map(|row| {
            let extensions: Vec<String> = quoted(row[1]).into_iter().map(str::to_owned).collect();
            (row[0].trim_matches('`'), extensions)
        })
        .collect();
    let known: Vec<(&str, Vec<String>)> = FORMATS
        .iter()
        .map(|format| {
            let extensions: Vec<String> =
                format.extensions.iter().map(|e| format!(".{e}")).collect();
            (format.name, extensions)
        })
        .collect();
    assert_eq!(told, known);
}

#[test]
fn every_extension_that_can_be_written_is_told() {
    let formats = document("docs/formats.md");
    let told: BTreeSet<String> = rows(section(&formats, "## What is written"))
        .iter()
        .flat_map(|row| quoted(row[0]))
        .map(str::to_owned)
        .collect();
    // A composite in one line, and pictures, are no spectra and have writers of their own.
    let others = [".txt", ".svg", ".png"].map(str::to_owned);
    let known: BTreeSet<String> = WRITABLE
        .iter()
        .map(|(extension, _)| format!(".{extension}"))
        .chain(others)
        .collect();
    assert_eq!(told, known);
}

/// "512 MiB" as a number.
fn amount(words: &str) -> u64 {
    let (number, unit) = words.split_once(' ').unwrap_or((words, ""));
    let number: u64 = number.replace(',', "").parse().expect(words);
    number
        * match unit {
            "GiB" => 1 << 30,
            "MiB" => 1 << 20,
            "million" => 1_000_000,
            _ => 1,
        }
}

#[test]
fn the_limits_are_those_of_the_program() {
    let formats = document("docs/formats.md");
    let rows = rows(section(&formats, "## Limits"));
    let told: Vec<u64> = rows.iter().skip(1).map(|row| amount(row[0])).collect();
    let known = [
        MOST_BYTES,
        MOST_BYTES_OF_A_FORMAT as u64,
        budget::of(0) as u64,
        budget::of_text(0) as u64,
        // Members of an archive, a limit that its reader keeps to itself.
        10_000,
        MOST_CELLS as u64,
        MOST_COLUMNS as u64,
        // Spectra of one file, a limit that the reader of tables keeps to itself.
        100_000,
        folders::MOST_DEPTH as u64,
        folders::MOST_FILES as u64,
        batch::MOST_KEPT,
    ];
    assert_eq!(told, known);
}

#[test]
fn every_page_of_the_window_and_every_part_of_products_has_its_place() {
    let window = document("docs/window.md");
    let headings: Vec<&str> = window
        .lines()
        .filter_map(|line| line.strip_prefix("## "))
        .filter(|heading| *heading != "Around the pages")
        .collect();
    assert_eq!(headings, Place::ALL.map(Place::title));
    for place in Place::ALL {
        let pages: Vec<&str> = section(&window, &format!("## {}", place.title()))
            .lines()
            .filter_map(|line| line.strip_prefix("- **")?.split_once("**"))
            .map(|(title, _)| title)
            .collect();
        let there = Page::all().filter(|page| page.place() == place);
        assert_eq!(pages, there.map(Page::title).collect::<Vec<_>>());
    }
}

/// The README and every document, by their paths in the project.
fn documents() -> Vec<String> {
    let mut all = vec!["README.md".to_owned()];
    for entry in fs::read_dir(root().join("docs")).expect("docs") {
        let name = entry.expect("an entry").file_name();
        all.push(format!("docs/{}", name.to_string_lossy()));
    }
    all
}

#[test]
fn every_link_leads_to_a_file() {
    let mut links = 0;
    for path in documents() {
        let text = document(&path);
        let targets = text
            .split("](")
            .skip(1)
            .filter_map(|rest| rest.split_once(')'))
            .map(|(target, _)| target)
            .filter(|target| !target.starts_with("http"));
        let folder = root().join(Path::new(&path).parent().unwrap_or(Path::new("")));
        for target in targets {
            links += 1;
            assert!(folder.join(target).exists(), "{path}: {target}");
        }
    }
    assert!(links > 10, "only {links} links were found");
}

/// The commands that run tests, in backticks or as a line of a script.
fn test_commands(text: &str) -> impl Iterator<Item = &str> {
    text.split(['`', '\n'])
        .map(str::trim)
        .filter(|command| command.starts_with("cargo test"))
}

#[test]
fn every_test_that_is_named_by_a_command_is_there() {
    let mut named = 0;
    let others = ["fuzz/README.md", ".ci/run"].map(str::to_owned);
    for file in documents().into_iter().chain(others) {
        let text = document(&file);
        for command in test_commands(&text) {
            let words: Vec<&str> = command.split([' ', '#']).collect();
            let programs = words.windows(2).filter(|pair| pair[0] == "--test");
            let subjects = words.iter().filter_map(|word| word.strip_suffix("::"));
            let of_core: Vec<&str> = subjects
                .clone()
                .filter_map(|word| word.strip_prefix("core_tests::"))
                .collect();
            named += of_core.len();
            for subject in of_core {
                let subject = root().join("tests/core").join(subject).with_extension("rs");
                assert!(subject.is_file(), "{file}: {subject:?}: {command}");
            }
            for program in programs.map(|pair| pair[1]) {
                named += 1;
                let folder = root().join("tests").join(program);
                let is_there =
                    folder.join("main.rs").is_file() || folder.with_extension("rs").is_file();
                assert!(is_there, "{file}: no {program}: {command}");
                for subject in subjects.clone() {
                    let subject = folder.join(subject).with_extension("rs");
                    assert!(subject.is_file(), "{file}: {subject:?}: {command}");
                }
            }
        }
    }
    assert!(named > 15, "only {named} commands were found");
}
