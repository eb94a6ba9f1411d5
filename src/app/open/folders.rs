//! What a person means by a folder: the files in it.
//!
//! Files come in the order of their names, subfolders in their place among them. Hidden ones are
//! left out, and folders behind links, which may lead round in a circle. Of an ENVI pair the
//! header stands for both files.

use std::{
    collections::{HashMap, HashSet},
    path::{Path, PathBuf},
};

use crate::{app::natural::natural, io::envi};

/// How many folders deep a folder is looked through, itself counted as none.
pub const MOST_DEPTH: usize = 8;

/// Most files that are taken from folders in one go.
pub const MOST_FILES: usize = 10_000;

/// One file of those that are to be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listed {
    /// What lists call it: its path below the folder that was opened, else its name.
    pub label: String,
    /// Where it is.
    pub path: PathBuf,
    /// It was found in a folder and not named itself.
    pub in_folder: bool,
    /// Why it is not to be read, in one line.
    pub refused: Option<String>,
}

impl Listed {
    /// One that was named itself.
    pub(super) fn named(label: String, path: &Path) -> Self {
        Self {
            label,
            path: path.to_owned(),
            in_folder: false,
            refused: None,
        }
    }
}

/// What is in the paths: files as they stand, folders as the files in them, none twice. `stop` is
/// asked again and again; what was found until then is returned.
pub fn listed(paths: &[PathBuf], stop: &dyn Fn() -> bool) -> Vec<Listed> {
    let mut found = found_in(paths, stop);
    join_pairs(&mut found);
    found
}

/// The same with both files of an ENVI pair, for a listing by file.
pub fn every_file(paths: &[PathBuf]) -> Vec<Listed> {
    found_in(paths, &|| false)
}

fn found_in(paths: &[PathBuf], stop: &dyn Fn() -> bool) -> Vec<Listed> {
    let mut walk = Walk {
        found: Vec::new(),
        known: HashSet::new(),
        taken: 0,
        seen: 0,
        stop,
    };
    for path in paths {
        if path.is_dir() {
            walk.folder(path);
        } else if walk.known.insert(path.clone()) {
            walk.found.push(Listed::named(name_of(path), path));
        }
    }
    walk.found
}

struct Walk<'a> {
    found: Vec<Listed>,
    known: HashSet<PathBuf>,
    /// Files taken from folders.
    taken: usize,
    /// Files seen in folders, taken before or not.
    seen: usize,
    stop: &'a dyn Fn() -> bool,
}

impl Walk<'_> {
    fn folder(&mut self, folder: &Path) {
        let before = (self.found.len(), self.seen);
        self.below(folder, folder, 0);
        if (self.found.len(), self.seen) == before && !(self.stop)() {
            let name = name_of(folder);
            let words = tr!(
                "{name}: found no file in it, expected a folder with files",
                name
            );
            self.add(folder, name, Some(words));
        }
    }

    fn add(&mut self, path: &Path, label: String, refused: Option<String>) {
        self.found.push(Listed {
            in_folder: true,
            refused,
            ..Listed::named(label, path)
        });
    }

    fn below(&mut self, top: &Path, folder: &Path, depth: usize) {
        let label = label_of(top, folder);
        let items: Result<Vec<_>, _> = std::fs::read_dir(folder).and_then(|items| items.collect());
        let mut items = match items {
            Ok(items) => items,
            Err(why) => {
                let words = tr!(
                    "{label}: found {fault}, expected a folder to read",
                    label,
                    fault = why.kind()
                );
                return self.add(folder, label, Some(words));
            }
        };
        items.sort_by_cached_key(|item| natural(&item.file_name().to_string_lossy()));
        for item in items {
            if (self.stop)() {
                return;
            }
            let path = item.path();
            let hidden = item.file_name().to_string_lossy().starts_with('.');
            let is_folder = item.file_type().is_ok_and(|kind| kind.is_dir());
            if hidden {
                continue;
            }
            if is_folder && depth == MOST_DEPTH {
                let label = label_of(top, &path);
                let words = tr!(
                    "{label}: found a folder more than {depth} deep, expected it to be opened by \
                     itself",
                    label,
                    depth = MOST_DEPTH
                );
                self.add(&path, label, Some(words));
            } else if is_folder {
                self.below(top, &path, depth + 1);
            } else if path.is_file() {
                // A pipe in the folder would be waited for without end.
                self.seen += 1;
                if self.taken == MOST_FILES {
                    let label = label_of(top, &path);
                    let words = tr!(
                        "{label}: found more than {count} files, expected at most so many in one \
                         go; this one and those behind it were left out",
                        label,
                        count = MOST_FILES
                    );
                    self.taken += 1;
                    return self.add(&path, label, Some(words));
                } else if self.taken > MOST_FILES {
                    return;
                } else if self.known.insert(path.clone()) {
                    self.taken += 1;
                    self.add(&path, label_of(top, &path), None);
                }
            }
        }
    }
}

/// Takes the data files of ENVI pairs out of the list: reading the header reads both.
fn join_pairs(found: &mut Vec<Listed>) {
    let places: HashMap<PathBuf, usize> = found
        .iter()
        .enumerate()
        .map(|(index, listed)| (listed.path.clone(), index))
        .collect();
    let mut read_with_header = HashSet::new();
    for listed in found.iter_mut() {
        let may_be_header = listed
            .path
            .extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("hdr"));
        if may_be_header
            && let Some(data) = envi::data_beside(&listed.path)
            && let Some(place) = places.get(&data)
            && read_with_header.insert(*place)
        {
            listed.label = format!("{} + {}", listed.label, name_of(&data));
        }
    }
    let mut index = 0;
    found.retain(|_| {
        index += 1;
        !read_with_header.contains(&(index - 1))
    });
}

/// The path below the folder that was opened, that folder's name in front.
fn label_of(top: &Path, path: &Path) -> String {
    let below = path.strip_prefix(top).unwrap_or(path);
    let label = PathBuf::from(name_of(top)).join(below);
    let label = label.to_string_lossy();
    label.trim_end_matches('/').to_owned()
}

fn name_of(path: &Path) -> String {
    match path.file_name() {
        Some(name) => name.to_string_lossy().into_owned(),
        None => path.display().to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn labels(paths: &[PathBuf]) -> Vec<String> {
        let found = listed(paths, &|| false);
        found.into_iter().map(|listed| listed.label).collect()
    }

    #[test]
    fn a_folder_is_its_files_in_order_without_hidden_ones() {
        let folder = tempfile::tempdir().unwrap();
        let top = folder.path().join("lamps");
        fs::create_dir_all(top.join("b sub/.git")).unwrap();
        for name in [
            "c.csv",
            "a.csv",
            ".hidden.csv",
            "b sub/x.csv",
            "b sub/.git/x",
        ] {
            fs::write(top.join(name), "400 1\n500 2\n").unwrap();
        }
        let expected = ["lamps/a.csv", "lamps/b sub/x.csv", "lamps/c.csv"];
        assert_eq!(labels(std::slice::from_ref(&top)), expected);
        // A file that is named too is read once.
        let twice = [top.join("c.csv"), top.clone(), top.clone()];
        assert_eq!(labels(&twice), ["c.csv", expected[0], expected[1]]);
    }

    #[test]
    fn an_empty_folder_and_one_too_deep_are_told() {
        let folder = tempfile::tempdir().unwrap();
        let empty = listed(&[folder.path().to_owned()], &|| false);
        let words = empty[0].refused.clone().unwrap();
        assert!(words.contains("found no file in it"), "{words}");
        let deep = (0..=MOST_DEPTH).fold(folder.path().to_owned(), |path, _| path.join("d"));
        fs::create_dir_all(&deep).unwrap();
        fs::write(deep.join("x.csv"), "400 1\n500 2\n").unwrap();
        let found = listed(&[folder.path().to_owned()], &|| false);
        assert_eq!(found.len(), 1);
        let words = found[0].refused.clone().unwrap();
        assert!(words.contains("more than 8 deep"), "{words}");
    }

    #[test]
    fn looking_through_folders_can_be_stopped() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.csv", "b.csv", "c.csv"] {
            fs::write(folder.path().join(name), "400 1\n500 2\n").unwrap();
        }
        let asked = std::cell::Cell::new(0);
        let stop = || {
            asked.set(asked.get() + 1);
            asked.get() > 2
        };
        assert_eq!(listed(&[folder.path().to_owned()], &stop).len(), 2);
    }
}
