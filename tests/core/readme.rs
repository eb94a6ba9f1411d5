//! The README tells the truth: its commands, its map.

use std::{collections::BTreeSet, fs};

use crate::root::root;

fn readme() -> String {
    fs::read_to_string(root().join("README.md")).expect("a README")
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

/// The commands that run tests, in backticks or as a line of a script.
fn test_commands(text: &str) -> impl Iterator<Item = &str> {
    text.split(['`', '\n'])
        .map(str::trim)
        .filter(|command| command.starts_with("cargo test"))
}

#[test]
fn every_test_that_is_named_by_a_command_is_there() {
    let mut named = 0;
    for file in ["README.md", "fuzz/README.md", ".ci/run"] {
        let text = fs::read_to_string(root().join(file)).expect(file);
        for command in test_commands(&text) {
            let words: Vec<&str> = command.split([' ', '#']).collect();
            let programs = words.windows(2).filter(|pair| pair[0] == "--test");
            for program in programs.map(|pair| pair[1]) {
                named += 1;
                let folder = root().join("tests").join(program);
                let is_there =
                    folder.join("main.rs").is_file() || folder.with_extension("rs").is_file();
                assert!(is_there, "{file}: no {program}: {command}");
                for subject in words.iter().filter_map(|word| word.strip_suffix("::")) {
                    let subject = folder.join(subject).with_extension("rs");
                    assert!(subject.is_file(), "{file}: {subject:?}: {command}");
                }
            }
        }
    }
    assert!(named > 15, "only {named} commands were found");
}
