//! Why a path cannot be opened, in words: what was found there and what was expected.

use std::io::{Error, ErrorKind};
use std::path::Path;

use crate::io::error::shown;

/// The obstacle at a path that cannot be opened, and the content expected instead.
pub(crate) fn words(path: &Path, error: &Error) -> (String, &'static str) {
    let one_that_exists = said!("a file that exists");
    let (found, expected) = match error.kind() {
        ErrorKind::NotFound if path.is_symlink() => (
            said!("a link to something that is not there"),
            one_that_exists,
        ),
        ErrorKind::NotFound => return (missing(path), one_that_exists),
        ErrorKind::PermissionDenied => (
            said!("no permission to read it"),
            said!("a file you may read"),
        ),
        ErrorKind::NotADirectory => return (in_the_way(path), said!("a folder there")),
        // Most likely round in a circle, which has no name of its own yet.
        _ if path.is_symlink() => (said!("a link that leads nowhere"), one_that_exists),
        _ => return (error.to_string(), said!("a file that can be read")),
    };
    (found.to_owned(), expected)
}

/// The description of a missing file, with the folder where it was expected.
fn missing(path: &Path) -> String {
    let folder = path.parent();
    match folder.filter(|folder| !folder.as_os_str().is_empty()) {
        None => said!("no such file").to_owned(),
        Some(folder) if folder.is_dir() => tr!("no such file in {folder}", folder = shown(folder)),
        Some(folder) => tr!("no folder {folder}", folder = shown(folder)),
    }
}

/// The file that stands where a path goes on.
fn in_the_way(path: &Path) -> String {
    // A slash at the end is no part of a name.
    let path = path.components().as_path();
    let file = path.ancestors().find(|part| part.exists());
    match file {
        Some(file) => tr!("{file}, which is no folder", file = shown(file)),
        None => said!("a file on the way").to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(path: &Path) -> String {
        let error = std::fs::metadata(path).expect_err("nothing to open");
        words(path, &error).0
    }

    #[test]
    fn what_stands_in_the_way_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("x.csv");
        std::fs::write(&file, "380,1\n").unwrap();
        let no_folder = format!("{}, which is no folder", file.display());
        assert_eq!(said(&file.join("y.csv")), no_folder);
        assert!(said(&folder.path().join("a/b.csv")).starts_with("no folder "));
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_nothing_is_told_from_one_that_leads_round() {
        let folder = tempfile::tempdir().unwrap();
        let [gone, round] = ["gone", "round"].map(|name| folder.path().join(name));
        std::os::unix::fs::symlink(folder.path().join("none"), &gone).unwrap();
        std::os::unix::fs::symlink(&round, &round).unwrap();
        assert_eq!(said(&gone), "a link to something that is not there");
        assert_eq!(said(&round), "a link that leads nowhere");
    }
}
