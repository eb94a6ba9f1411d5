//! The lessons that ship with the program, and a person's own files.

use std::{
    path::Path,
    sync::{Arc, LazyLock, OnceLock},
};

use super::{
    format::{Fault, Lesson},
    proof::is_sound,
};
use crate::{
    io::{decode_text, is_binary, save_atomically, shown, stream::bytes_of_file},
    languages::{Language, spoken},
};

/// Files of the shipped lessons by their names, in the order of the list: path after path.
pub const FILES: [(&str, &str); 21] = [
    ("prism", include_str!("../../../lessons/prism.json")),
    ("light", include_str!("../../../lessons/light.json")),
    ("missing", include_str!("../../../lessons/missing.json")),
    ("gas", include_str!("../../../lessons/gas.json")),
    ("hotter", include_str!("../../../lessons/hotter.json")),
    ("phone", include_str!("../../../lessons/phone.json")),
    ("room", include_str!("../../../lessons/room.json")),
    ("metamers", include_str!("../../../lessons/metamers.json")),
    ("filters", include_str!("../../../lessons/filters.json")),
    ("quality", include_str!("../../../lessons/quality.json")),
    ("white", include_str!("../../../lessons/white.json")),
    ("tint", include_str!("../../../lessons/tint.json")),
    ("which", include_str!("../../../lessons/which.json")),
    ("waves", include_str!("../../../lessons/waves.json")),
    ("colour", include_str!("../../../lessons/colour.json")),
    ("samples", include_str!("../../../lessons/samples.json")),
    ("spend", include_str!("../../../lessons/spend.json")),
    ("recover", include_str!("../../../lessons/recover.json")),
    (
        "instrument",
        include_str!("../../../lessons/instrument.json"),
    ),
    ("noise", include_str!("../../../lessons/noise.json")),
    ("three", include_str!("../../../lessons/three.json")),
];

/// The paths through the shipped lessons: a title each, and how many of [`FILES`] follow it.
pub const PATHS: [(&str, usize); 3] = [
    (later!("School"), 9),
    (later!("Lighting"), 4),
    (later!("University and graphics"), 8),
];

/// The lesson that follows a shipped one in the list; none after the last, and for others.
pub fn after(name: &str) -> Option<&'static str> {
    let place = FILES.iter().position(|(own, _)| *own == name)?;
    FILES.get(place + 1).map(|(next, _)| *next)
}

/// The shipped lessons; one that cannot be read is left out, and a test finds it.
pub fn shipped() -> &'static [Arc<Lesson>] {
    static SHIPPED: LazyLock<Vec<Arc<Lesson>>> = LazyLock::new(|| {
        let read = FILES.iter().map(|(name, text)| Lesson::read(name, text));
        read.filter_map(Result::ok).map(Arc::new).collect()
    });
    &SHIPPED
}

/// The same in the language spoken.
pub fn as_spoken() -> &'static [Arc<Lesson>] {
    static OTHERS: [OnceLock<Vec<Arc<Lesson>>>; Language::ALL.len()] =
        [const { OnceLock::new() }; Language::ALL.len()];
    let language = spoken();
    if language == Language::English {
        return shipped();
    }
    OTHERS[language as usize].get_or_init(|| {
        let in_it = |lesson: &Arc<Lesson>| Arc::new(lesson.in_language(language.code()));
        shipped().iter().map(in_it).collect()
    })
}

/// A longer file is no lesson, bytes: the longest shipped one has 9000.
pub const MOST_BYTES: u64 = 256 << 10;

/// Whether a file claims to be a lesson: JSON in any encoding of text that has the format's name, and
/// no longer than lessons are.
pub fn is_lesson(path: &Path) -> bool {
    let is_json = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("json"));
    is_json
        && std::fs::metadata(path).is_ok_and(|meta| {
            // A pipe would be waited for.
            meta.is_file() && meta.len() <= MOST_BYTES
        })
        && bytes_of_file(path, MOST_BYTES)
            .is_ok_and(|bytes| !is_binary(&bytes) && Lesson::is_one(&decode_text(&bytes).text))
}

/// A lesson of a file.
///
/// # Errors
/// [`Fault`]: the file, what was found and what was expected.
pub fn read_file(path: &Path) -> Result<Lesson, Fault> {
    read_whole(path).map_err(|mut faults| faults.swap_remove(0))
}

/// The same with all that is wrong with it.
///
/// # Errors
/// [`Fault`]s, at least one.
pub fn read_whole(path: &Path) -> Result<Lesson, Vec<Fault>> {
    let (file, text) = text_of(path).map_err(|why| vec![why])?;
    Lesson::read_whole(&file, &text)
}

/// What a file is called, and its text.
fn text_of(path: &Path) -> Result<(String, String), Fault> {
    let file = shown(path);
    let fault = |what: String| Fault {
        file: file.clone(),
        step: None,
        what,
    };
    let bytes = bytes_of_file(path, MOST_BYTES).map_err(|(found, expected)| {
        fault(tr!("found {found}, expected {expected}", found, expected))
    })?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(fault(tr!(
            "found more than {count} bytes, expected at most so many",
            count = MOST_BYTES
        )));
    }
    if is_binary(&bytes) {
        return Err(fault(said!("found no text, expected a lesson").to_owned()));
    }
    Ok((file, decode_text(&bytes).text.into_owned()))
}

/// The lessons of a folder in the order of their files' names, and what is wrong with the others.
pub fn of_folder(folder: &Path) -> (Vec<Lesson>, Vec<Fault>) {
    let files = std::fs::read_dir(folder).into_iter().flatten();
    let mut paths: Vec<_> = files.filter_map(|file| Some(file.ok()?.path())).collect();
    paths.retain(|path| {
        path.extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("json"))
    });
    paths.sort();
    let (mut lessons, mut faults) = (Vec::new(), Vec::new());
    for path in paths {
        // What can be seen without playing it: a class must not wait for a folder.
        let read = read_file(&path).and_then(|lesson| is_sound(&lesson, &[]).map(|()| lesson));
        match read {
            Ok(lesson) => lessons.push(lesson),
            Err(why) => faults.push(why),
        }
    }
    (lessons, faults)
}

/// Keeps a lesson in a folder, under its name.
///
/// # Errors
/// Why it cannot be written, a sentence.
pub fn keep(folder: &Path, lesson: &Lesson) -> Result<(), String> {
    let not_kept = |why: String| tr!("{title} is not kept: {why}.", title = lesson.title, why);
    std::fs::create_dir_all(folder).map_err(|why| not_kept(why.to_string()))?;
    let path = folder.join(format!("{}.json", lesson.name));
    save_atomically(&path, lesson.text.as_bytes()).map_err(|why| not_kept(why.to_string()))
}

/// Takes a lesson out of a folder: its file stays there under another ending, which is given.
///
/// # Errors
/// Why it cannot be renamed, a sentence.
pub fn put_away(folder: &Path, lesson: &Lesson) -> Result<String, String> {
    let path = folder.join(format!("{}.json", lesson.name));
    let away = folder.join(format!("{}.json.removed", lesson.name));
    match std::fs::rename(&path, &away) {
        Ok(()) => Ok(shown(&away)),
        Err(why) => Err(tr!(
            "{title} is not removed: {why}.",
            title = lesson.title,
            why
        )),
    }
}

/// A shipped lesson by its name, or one of a file.
///
/// # Errors
/// [`Fault`], also when there is neither.
pub fn named(word: &str) -> Result<Arc<Lesson>, Fault> {
    read_named(word).map_err(|mut faults| faults.swap_remove(0))
}

/// The same with all that is wrong with it.
///
/// # Errors
/// [`Fault`]s, at least one.
pub fn read_named(word: &str) -> Result<Arc<Lesson>, Vec<Fault>> {
    if let Some(lesson) = shipped().iter().find(|lesson| lesson.name == word) {
        return Ok(lesson.clone());
    }
    let path = Path::new(word);
    if path.exists() {
        return read_whole(path).map(Arc::new);
    }
    let names: Vec<&str> = FILES.iter().map(|(name, _)| *name).collect();
    Err(vec![Fault {
        file: word.to_owned(),
        step: None,
        what: tr!(
            "found no such lesson or file, expected one of {names}",
            names = names.join(", ")
        ),
    }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_lesson_is_on_one_path() {
        let on_paths: usize = PATHS.iter().map(|(_, count)| count).sum();
        assert_eq!(on_paths, FILES.len());
    }

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
        let mut order = vec![FILES[0].0];
        order.extend(std::iter::successors(after(FILES[0].0), |name| after(name)));
        assert!(order.iter().eq(FILES.iter().map(|(name, _)| name)));
        assert_eq!(after("my lesson"), None);
    }

    #[test]
    fn minutes_fit_the_steps_and_how_a_class_votes_is_said_to_be_a_guess() {
        for lesson in shipped() {
            let (name, steps) = (&lesson.name, lesson.steps.len() as u32);
            // Reading, predicting, doing and talking take two to four minutes a step.
            assert!(
                (2 * steps..=4 * steps).contains(&lesson.minutes),
                "{name}: {} minutes for {steps} steps",
                lesson.minutes
            );
            let notes = &lesson.notes_for_teachers;
            let votes = notes.contains("votes");
            assert_eq!(
                votes,
                notes.contains("A guess, not counted in a class: "),
                "{name}"
            );
            assert!(!notes.contains("Expect "), "{name}: {notes}");
            let published = notes.contains("Published: ");
            let cited = lesson.sources.iter().any(|one| one.contains("Educ. Res."));
            assert_eq!(published, cited, "{name}");
        }
    }

    #[test]
    fn a_folder_gives_back_what_it_was_to_keep_and_says_what_is_no_lesson() {
        let folder = tempfile::tempdir().expect("a folder");
        let own = folder.path().join("lessons");
        assert_eq!(of_folder(&own), (Vec::new(), Vec::new()));
        let mut lessons: Vec<&Lesson> = shipped().iter().take(2).map(|l| &**l).collect();
        // A folder lists its files by name.
        lessons.sort_by_key(|lesson| &lesson.name);
        for lesson in &lessons {
            keep(&own, lesson).expect("kept");
        }
        std::fs::write(own.join("wrong.json"), "{}").expect("a file");
        std::fs::write(own.join("notes.txt"), "no lesson").expect("a file");
        let (found, faults) = of_folder(&own);
        assert_eq!(found.iter().collect::<Vec<_>>(), lessons);
        let words: Vec<String> = faults.iter().map(Fault::to_string).collect();
        assert!(
            words.len() == 1 && words[0].contains("found no format"),
            "{words:?}"
        );
        assert!(keep(&own.join("notes.txt"), lessons[0]).is_err());
        // A name that nothing has is seen without playing the lesson; so is a book.
        let text = &lessons[0].text;
        let unknown = text.replacen("{cct}", "{foo}", 1);
        let long = format!("{text}{}", " ".repeat(300 << 10));
        for (name, text, words) in [
            ("unknown.json", unknown, "found the figure foo"),
            ("long.json", long, "found more than 262144 bytes"),
        ] {
            std::fs::write(own.join(name), text).expect("a file");
            let (_, faults) = of_folder(&own);
            let said = faults.iter().any(|why| why.to_string().contains(words));
            assert!(said, "{faults:?}");
            std::fs::remove_file(own.join(name)).expect("it is there");
        }
    }

    #[test]
    fn a_lesson_may_be_of_any_encoding_of_text() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("wide.json");
        let text = format!("\u{feff}{}", FILES[0].1);
        let bytes: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        std::fs::write(&path, bytes).expect("a file");
        // Dropped on the window it is taken for one, too.
        assert!(is_lesson(&path));
        let lesson = read_file(&path).expect("a lesson");
        assert_eq!(lesson.steps, shipped()[0].steps);
        let other = folder.path().join("other.json");
        std::fs::write(&other, "{}").expect("a file");
        assert!(!is_lesson(&other) && !is_lesson(folder.path()));
    }

    /// It would be waited for without end, and a device gives bytes without end.
    #[cfg(unix)]
    #[test]
    fn a_pipe_or_a_device_among_the_lessons_is_no_lesson() {
        let folder = tempfile::tempdir().expect("a folder");
        let pipe = folder.path().join("x.json");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.is_ok_and(|status| status.success()));
        let zero = folder.path().join("zero.json");
        std::os::unix::fs::symlink("/dev/zero", &zero).expect("a link");
        let (lessons, faults) = of_folder(folder.path());
        assert!(lessons.is_empty());
        for fault in &faults {
            assert_eq!(fault.what, "found a device or a pipe, expected a file");
        }
        assert_eq!(faults.len(), 2);
    }
}
