//! The project's documents, and what stands in their tables.

use std::fs;

use super::root::root;

/// The text of a document, by its path in the project.
pub(crate) fn document(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|why| panic!("{path}: {why}"))
}

/// What stands under a heading (`## Limits`), up to the next one that is as high.
pub(crate) fn section<'t>(text: &'t str, heading: &str) -> &'t str {
    let level = |line: &str| line.chars().take_while(|c| *c == '#').count();
    let (_, rest) = text
        .split_once(&format!("\n{heading}\n"))
        .unwrap_or_else(|| panic!("no heading {heading}"));
    let mut end = 0;
    for line in rest.split_inclusive('\n') {
        if (1..=level(heading)).contains(&level(line)) {
            break;
        }
        end += line.len();
    }
    &rest[..end]
}

/// The rows of all tables in a text, each as its cells; the titles are rows too.
pub(crate) fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines()
        .filter(|line| line.starts_with("| "))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect()
}

/// The words of a text that stand between backticks.
pub(crate) fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}
