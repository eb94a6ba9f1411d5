//! The lessons that ship with the program, and a person's own files.

use std::{
    path::Path,
    sync::{Arc, LazyLock},
};

use super::format::{Fault, Lesson};

/// Files of the shipped lessons by their names, in the order of the list.
pub const FILES: [(&str, &str); 12] = [
    ("light", include_str!("../../../lessons/light.json")),
    ("waves", include_str!("../../../lessons/waves.json")),
    ("colour", include_str!("../../../lessons/colour.json")),
    ("spend", include_str!("../../../lessons/spend.json")),
    ("metamers", include_str!("../../../lessons/metamers.json")),
    ("filters", include_str!("../../../lessons/filters.json")),
    ("samples", include_str!("../../../lessons/samples.json")),
    ("missing", include_str!("../../../lessons/missing.json")),
    ("prism", include_str!("../../../lessons/prism.json")),
    ("quality", include_str!("../../../lessons/quality.json")),
    ("white", include_str!("../../../lessons/white.json")),
    ("recover", include_str!("../../../lessons/recover.json")),
];

/// The shipped lessons; one that cannot be read is left out, and a test finds it.
pub fn shipped() -> &'static [Arc<Lesson>] {
    static SHIPPED: LazyLock<Vec<Arc<Lesson>>> = LazyLock::new(|| {
        let read = FILES.iter().map(|(name, text)| Lesson::read(name, text));
        read.filter_map(Result::ok).map(Arc::new).collect()
    });
    &SHIPPED
}

/// The text of a shipped lesson's file.
pub fn text_of(name: &str) -> Option<&'static str> {
    let found = FILES.iter().find(|(known, _)| *known == name);
    found.map(|(_, text)| *text)
}

/// A lesson of a file; longer ones than a few books are none.
///
/// # Errors
/// [`Fault`]: the file, what was found and what was expected.
pub fn read_file(path: &Path) -> Result<Lesson, Fault> {
    const MOST_BYTES: u64 = 4 << 20;
    let file = path.display().to_string();
    let fault = |what: String| Fault {
        file: file.clone(),
        step: None,
        what,
    };
    let bytes = std::fs::metadata(path).map_or(0, |meta| meta.len());
    if bytes > MOST_BYTES {
        return Err(fault(format!(
            "found {bytes} bytes, expected at most {MOST_BYTES}"
        )));
    }
    let text = std::fs::read_to_string(path)
        .map_err(|why| fault(format!("found a file that cannot be read ({why})")))?;
    Lesson::read(&file, &text)
}

/// A shipped lesson by its name, or one of a file.
///
/// # Errors
/// [`Fault`], also when there is neither.
pub fn named(word: &str) -> Result<Arc<Lesson>, Fault> {
    if let Some(lesson) = shipped().iter().find(|lesson| lesson.name == word) {
        return Ok(lesson.clone());
    }
    let path = Path::new(word);
    if path.exists() {
        return read_file(path).map(Arc::new);
    }
    let names: Vec<&str> = FILES.iter().map(|(name, _)| *name).collect();
    Err(Fault {
        file: word.to_owned(),
        step: None,
        what: format!(
            "found no such lesson or file, expected one of {}",
            names.join(", ")
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_file_is_a_lesson_with_a_title_of_its_own() {
        let mut titles: Vec<&str> = Vec::new();
        for (name, text) in FILES {
            let lesson = Lesson::read(name, text).unwrap_or_else(|why| panic!("{why}"));
            assert_eq!(lesson.name, name);
            let lesson = named(name).expect("shipped");
            assert!(!titles.contains(&lesson.title.as_str()));
            let known = shipped().iter().find(|one| one.name == name);
            titles.push(&known.expect("shipped").title);
        }
        assert!(named("no such lesson").is_err());
    }
}
