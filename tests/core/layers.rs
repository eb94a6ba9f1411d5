//! The promise of the house: imports point one way, widgets stay in their rooms, and no file knows
//! on whose computer it was written.

use super::root::root;
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

/// The rooms of `src`, and which others each may use.
const ROOMS: [(&str, &[&str]); 18] = [
    ("languages", &[]),
    ("spectrum", &["languages"]),
    ("preset", &["spectrum", "languages"]),
    ("color", &["preset", "spectrum", "languages"]),
    ("rivals", &["spectrum", "languages"]),
    ("study", &["rivals", "color", "spectrum", "languages"]),
    (
        "design",
        &["study", "color", "preset", "spectrum", "languages"],
    ),
    (
        "lamps",
        &[
            "study",
            "rivals",
            "color",
            "preset",
            "spectrum",
            "languages",
        ],
    ),
    ("optics", &["study", "color", "spectrum", "languages"]),
    (
        "measurements",
        &["color", "preset", "spectrum", "languages"],
    ),
    ("photographs", &["color", "preset", "spectrum", "languages"]),
    ("io", &["spectrum", "languages"]),
    ("streams", &["io", "spectrum", "languages"]),
    (
        "live",
        &["streams", "measurements", "color", "spectrum", "languages"],
    ),
    (
        "pictures",
        &["io", "study", "color", "preset", "spectrum", "languages"],
    ),
    (
        "app",
        &[
            "design",
            "lamps",
            "optics",
            "measurements",
            "photographs",
            "live",
            "streams",
            "pictures",
            "study",
            "rivals",
            "color",
            "preset",
            "spectrum",
            "io",
            "languages",
        ],
    ),
    (
        "cli",
        &[
            "app",
            "design",
            "lamps",
            "optics",
            "measurements",
            "photographs",
            "live",
            "streams",
            "pictures",
            "study",
            "rivals",
            "color",
            "preset",
            "spectrum",
            "io",
            "languages",
        ],
    ),
    (
        "ui",
        &[
            "app",
            "design",
            "lamps",
            "optics",
            "measurements",
            "photographs",
            "live",
            "streams",
            "pictures",
            "study",
            "rivals",
            "color",
            "preset",
            "spectrum",
            "io",
            "languages",
        ],
    ),
];

/// What only the window and the start of the program may name.
const WIDGETS: [&str; 7] = [
    "egui",
    "eframe",
    "egui_plot",
    "rfd",
    "epaint",
    "emath",
    "winit",
];

/// Every file below a folder; none when the folder is not there.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("a folder that can be listed").path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// A source file with its path below `src`, split: `["ui", "window.rs"]`.
struct Source {
    place: Vec<String>,
    code: String,
    /// The same without what is compiled for tests only.
    untested: String,
    /// How many lines that is, comments among them.
    lines: usize,
}

impl Source {
    /// The room that the file stands in; `None` for `main.rs` and `lib.rs`.
    fn room(&self) -> Option<&str> {
        (self.place.len() > 1).then(|| self.place[0].as_str())
    }

    fn name(&self) -> String {
        format!("src/{}", self.place.join("/"))
    }
}

fn sources() -> Vec<Source> {
    let src = root().join("src");
    let sources: Vec<Source> = files_below(&src)
        .into_iter()
        .filter(|path| path.extension().is_some_and(|e| e == "rs"))
        .map(|path| {
            let text = fs::read_to_string(&path).expect("a source file is UTF-8");
            let below = path.strip_prefix(&src).expect("found below src");
            let untested = without_tests(&text);
            Source {
                untested: code_of(&untested),
                lines: untested.lines().count(),
                place: below
                    .iter()
                    .map(|part| part.to_string_lossy().into_owned())
                    .collect(),
                code: code_of(&text),
            }
        })
        .collect();
    assert!(sources.len() > 50, "found only {} files", sources.len());
    sources
}

/// Rust as it is formatted here, without the items that are compiled for tests only.
fn without_tests(text: &str) -> String {
    let mut kept = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line == "#[cfg(test)]" {
            // An item ends with its bracket at the margin, or in its one line.
            lines.find(|line| {
                line.starts_with('}') || !line.starts_with(' ') && line.ends_with(';')
            });
        } else {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

/// Rust without comments and without what stands inside string and character literals.
fn code_of(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let at = |i: usize| letters.get(i).copied().unwrap_or('\0');
    let mut code = String::new();
    let mut i = 0;
    while i < letters.len() {
        match at(i) {
            '/' if at(i + 1) == '/' => {
                while i < letters.len() && at(i) != '\n' {
                    i += 1;
                }
            }
            '/' if at(i + 1) == '*' => {
                let mut depth = 0;
                loop {
                    match (at(i), at(i + 1)) {
                        ('/', '*') => (depth, i) = (depth + 1, i + 2),
                        ('*', '/') => (depth, i) = (depth - 1, i + 2),
                        _ => i += 1,
                    }
                    if depth == 0 || i >= letters.len() {
                        break;
                    }
                }
            }
            'r' if raw_hashes(&letters, i).is_some() && !is_word(i.checked_sub(1).map(at)) => {
                let hashes = raw_hashes(&letters, i).unwrap_or_default();
                i += hashes + 2;
                let end = |i: usize| at(i) == '"' && (1..=hashes).all(|h| at(i + h) == '#');
                while i < letters.len() && !end(i) {
                    i += 1;
                }
                i += hashes + 1;
            }
            '"' => {
                i += 1;
                while i < letters.len() && at(i) != '"' {
                    i += if at(i) == '\\' { 2 } else { 1 };
                }
                i += 1;
            }
            // A character, not a lifetime: 'x' or '\n'.
            '\'' if at(i + 1) == '\\' || at(i + 2) == '\'' => {
                i += if at(i + 1) == '\\' { 3 } else { 2 };
                while i < letters.len() && at(i) != '\'' {
                    i += 1;
                }
                i += 1;
            }
            letter => {
                code.push(letter);
                i += 1;
            }
        }
    }
    code
}

/// The count of `#` of a raw string that starts here.
fn raw_hashes(letters: &[char], start: usize) -> Option<usize> {
    let hashes = letters[start + 1..].iter().take_while(|c| **c == '#');
    let hashes = hashes.count();
    (letters.get(start + 1 + hashes) == Some(&'"')).then_some(hashes)
}

fn is_word(letter: Option<char>) -> bool {
    letter.is_some_and(|c| c.is_alphanumeric() || c == '_')
}

/// The identifiers of some code.
fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !is_word(Some(c)))
        .filter(|word| !word.is_empty())
}

/// The names that follow a path's beginning: `crate::a::b` gives `a`, `crate::{a::b, c}` gives
/// `a` and `c`.
fn named_after(code: &str, beginning: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (start, _) in code.match_indices(beginning) {
        if is_word(code[..start].chars().next_back()) {
            continue;
        }
        let rest = code[start + beginning.len()..].trim_start();
        match rest.strip_prefix('{') {
            None => names.extend(words(rest).next().map(str::to_owned)),
            Some(group) => {
                let (mut depth, mut element) = (0, String::new());
                for letter in group.chars() {
                    match letter {
                        '{' => depth += 1,
                        '}' if depth == 0 => break,
                        '}' => depth -= 1,
                        ',' if depth == 0 => {
                            names.extend(words(&element).next().map(str::to_owned));
                            element.clear();
                        }
                        _ if depth == 0 => element.push(letter),
                        _ => {}
                    }
                }
                names.extend(words(&element).next().map(str::to_owned));
            }
        }
    }
    names
}

/// The other rooms that a file uses, by `crate::` or by climbing up with `super::`.
fn rooms_used(source: &Source) -> BTreeSet<String> {
    let own = source.room().unwrap_or_default();
    let mut used = named_after(&source.code, "crate::");
    // From a file in a room `super` is the room and `super::super` the crate; inside the file's
    // own test module there is one step more. Whatever a climb reaches must not be a room.
    let mut climb = "super::super::".to_owned();
    for _ in 0..3 {
        used.extend(named_after(&source.code, &climb));
        climb.push_str("super::");
    }
    used.retain(|name| name != own && ROOMS.iter().any(|(room, _)| room == name));
    used
}

/// The module that a file is: `["ui", "window"]`, the folder's for a `mod.rs`.
fn module_of(place: &[String]) -> Vec<String> {
    let (file, folders) = place.split_last().expect("a file has a name");
    let name = file.trim_end_matches(".rs");
    let own = (name != "mod").then(|| name.to_owned());
    folders.iter().cloned().chain(own).collect()
}

/// Words and marks of some code: `::`, or one letter each.
fn tokens(code: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = code.trim_start();
    while let Some(letter) = rest.chars().next() {
        let end = if is_word(Some(letter)) {
            let end = rest.find(|c: char| !is_word(Some(c)));
            end.unwrap_or(rest.len())
        } else if rest.starts_with("::") {
            2
        } else {
            letter.len_utf8()
        };
        tokens.push(&rest[..end]);
        rest = rest[end..].trim_start();
    }
    tokens
}

/// Every path of two words and more, trees of `use` spread out: `a::{b, c::d}` is `a::b` and
/// `a::c::d`.
fn paths(code: &str) -> Vec<Vec<&str>> {
    let tokens = tokens(code);
    let (mut paths, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        if is_word(tokens[at].chars().next()) && tokens.get(at + 1) == Some(&"::") {
            at = spread(&tokens, at, &[], &mut paths);
        } else {
            at += 1;
        }
    }
    paths
}

/// Adds the paths that begin at a word, behind those already gone through; says where they end.
fn spread<'c>(
    tokens: &[&'c str],
    mut at: usize,
    before: &[&'c str],
    paths: &mut Vec<Vec<&'c str>>,
) -> usize {
    let mut path = before.to_vec();
    loop {
        match tokens.get(at) {
            Some(&"{") => {
                at += 1;
                while at < tokens.len() && tokens[at] != "}" {
                    at = match tokens[at] {
                        "," => at + 1,
                        _ => spread(tokens, at, &path, paths),
                    };
                }
                return at + 1;
            }
            Some(word) => path.push(word),
            None => return at,
        }
        if tokens.get(at + 1) != Some(&"::") {
            break;
        }
        at += 2;
    }
    paths.push(path);
    // `name as other`, of which the first counts.
    let renamed = tokens.get(at + 1) == Some(&"as");
    at + if renamed { 3 } else { 1 }
}

/// Modules by their paths, each with the names that it offers of the modules in it.
type Modules = BTreeMap<Vec<String>, BTreeMap<String, Vec<String>>>;

/// As far as there are files for it, the module that words lead to, and the next word.
fn walked<'w>(
    mut place: Vec<String>,
    words: &[&'w str],
    modules: &Modules,
) -> (Vec<String>, Option<&'w str>) {
    for word in words {
        place.push((*word).to_owned());
        if !modules.contains_key(&place) {
            place.pop();
            return (place, Some(word));
        }
    }
    (place, None)
}

/// The module that a path leads to from another; a name that a folder's module offers of a file
/// leads to the file.
fn led_to(path: &[&str], from: &[String], modules: &Modules) -> Option<Vec<String>> {
    let ups = path.iter().take_while(|word| **word == "super").count();
    let (start, words) = match path[0] {
        "crate" => (&[][..], &path[1..]),
        "self" => (from, &path[1..]),
        "super" => (&from[..from.len().checked_sub(ups)?], &path[ups..]),
        _ => return None,
    };
    let (place, name) = walked(start.to_vec(), words, modules);
    let offered = name.and_then(|name| modules.get(&place)?.get(name).cloned());
    Some(offered.unwrap_or(place))
}

/// The names that a module offers of those in it: `pub use x::{X, Y}`.
fn offered(module: &[String], code: &str, modules: &Modules) -> BTreeMap<String, Vec<String>> {
    let mut names = BTreeMap::new();
    for statement in code.split(';') {
        let Some((before, used)) = statement.rsplit_once("use ") else {
            continue;
        };
        if !before.trim_end().ends_with("pub") && !before.trim_end().ends_with(')') {
            continue;
        }
        for path in paths(used) {
            let words = path.strip_prefix(&["self"]).unwrap_or(&path);
            let (place, name) = walked(module.to_vec(), words, modules);
            if let Some(name) = name.filter(|_| place != module) {
                names.insert(name.to_owned(), place);
            }
        }
    }
    names
}

/// The files of the rooms by their modules, and the names that each offers of those in it.
struct Imports<'s> {
    files: BTreeMap<Vec<String>, &'s Source>,
    modules: Modules,
}

impl<'s> Imports<'s> {
    fn of(sources: &'s [Source]) -> Self {
        let files: BTreeMap<Vec<String>, &Source> = sources
            .iter()
            .filter(|s| s.room().is_some() && s.place.last().is_some_and(|f| f != "tests.rs"))
            .map(|source| (module_of(&source.place), source))
            .collect();
        let mut modules: Modules = files.keys().map(|m| (m.clone(), BTreeMap::new())).collect();
        let names: Vec<_> = files
            .iter()
            .map(|(module, file)| offered(module, &file.untested, &modules))
            .collect();
        for (of, names) in modules.values_mut().zip(names) {
            *of = names;
        }
        Self { files, modules }
    }

    /// The other files of its room that a file names, those within it and around it left out: a
    /// folder's own module lists what the folder offers.
    fn needed(&self, module: &[String]) -> Vec<Vec<String>> {
        paths(&self.files[module].untested)
            .iter()
            .filter_map(|path| led_to(path, module, &self.modules))
            .filter(|other| self.modules.contains_key(other) && other[0] == module[0])
            .filter(|other| !other.starts_with(module) && !module.starts_with(other))
            .collect()
    }
}

/// Files that need each other round a circle, each circle as its files in order; a folder's own
/// module takes part in none with what lies in the folder.
fn circles(sources: &[Source]) -> BTreeSet<Vec<String>> {
    let imports = Imports::of(sources);
    let files = &imports.files;
    let needed: BTreeMap<&Vec<String>, Vec<Vec<String>>> =
        files.keys().map(|m| (m, imports.needed(m))).collect();
    let reached = |from: &Vec<String>| -> BTreeSet<Vec<String>> {
        let (mut reached, mut next) = (BTreeSet::new(), needed[from].clone());
        while let Some(module) = next.pop() {
            if reached.insert(module.clone()) {
                next.extend(needed[&module].iter().cloned());
            }
        }
        reached
    };
    let reach: BTreeMap<&Vec<String>, BTreeSet<Vec<String>>> =
        files.keys().map(|m| (m, reached(m))).collect();
    let in_circle = |m: &&Vec<String>| reach[*m].contains(*m);
    files
        .keys()
        .filter(in_circle)
        .map(|m| {
            let back = |other: &&Vec<String>| reach[*other].contains(m);
            let circle = reach[m].iter().filter(back);
            circle.map(|member| files[member].name()).collect()
        })
        .collect()
}

#[test]
fn no_files_of_a_room_need_each_other_in_a_circle() {
    let found = circles(&sources());
    let told: Vec<String> = found.iter().map(|circle| circle.join(", ")).collect();
    assert!(told.is_empty(), "circles: {}", told.join("; "));
}

/// A file that is made up.
fn source(place: &[&str], code: &str) -> Source {
    Source {
        place: place.iter().map(|part| (*part).to_owned()).collect(),
        code: String::new(),
        untested: code_of(&without_tests(code)),
        lines: 0,
    }
}

#[test]
fn the_search_for_circles_finds_one() {
    let files = [
        source(&["color", "mod.rs"], "mod a; mod b; pub use a::{A, B};"),
        source(&["color", "a.rs"], "use super::{b::{C as D, E}, Hub};"),
        source(&["color", "b.rs"], "fn f() { crate::color::c::G::new() }"),
        source(&["color", "c.rs"], "use super::super::color::A;"),
        source(
            &["color", "d.rs"],
            "use super::a::A;\n#[cfg(test)]\nmod tests {\n    use super::super::e::E;\n}\n",
        ),
        source(&["color", "e.rs"], "use super::d::D;"),
        source(&["study", "f.rs"], "use crate::color::a::A;"),
    ];
    let circle = ["a", "b", "c"].map(|file| format!("src/color/{file}.rs"));
    assert_eq!(circles(&files), BTreeSet::from([circle.to_vec()]));
}

/// The folders of `src/io`, and which others each may use; "" are the files beside them, which
/// hold what is said of a file: its bytes, what a person decided, where it is from, refusals.
const ROOMS_OF_IO: [(&str, &[&str]); 9] = [
    ("text", &[]),
    ("", &["text"]),
    ("write", &["", "text"]),
    ("decode", &["", "text"]),
    ("photo", &["write", "decode", "", "text"]),
    ("reading", &["", "text"]),
    ("interpret", &["reading", "", "text"]),
    ("table", &["interpret", "reading", "", "text"]),
    (
        "formats",
        &[
            "table",
            "interpret",
            "reading",
            "decode",
            "write",
            "",
            "text",
        ],
    ),
];

/// The folder of `src/io` that a module stands in: "" where in none, `None` for the room's own
/// module, which lists what the room offers.
fn folder_of_io(module: &[String]) -> Option<&str> {
    let name = module.get(1)?;
    let is_folder = ROOMS_OF_IO.iter().any(|(folder, _)| folder == name);
    Some(if is_folder { name } else { "" })
}

/// What files of io use of folders that they must not.
fn against_the_plan_of_io(sources: &[Source]) -> Vec<String> {
    let imports = Imports::of(sources);
    let mut wrong = Vec::new();
    for module in imports.files.keys().filter(|module| module[0] == "io") {
        let Some(folder) = folder_of_io(module) else {
            continue;
        };
        let plan = ROOMS_OF_IO.iter().find(|(name, _)| *name == folder);
        let allowed = plan.map_or(&[][..], |(_, allowed)| allowed);
        for other in imports.needed(module) {
            let used = folder_of_io(&other).unwrap_or("");
            if used != folder && !allowed.contains(&used) {
                wrong.push(format!("{} uses {}", module.join("/"), other.join("/")));
            }
        }
    }
    wrong
}

#[test]
fn the_folders_of_io_point_one_way() {
    for (index, (folder, allowed)) in ROOMS_OF_IO.iter().enumerate() {
        for below in *allowed {
            let place = ROOMS_OF_IO.iter().position(|(name, _)| name == below);
            assert!(place.is_some_and(|p| p < index), "{folder} -> {below}");
        }
        let path = root().join("src/io").join(folder);
        assert!(path.is_dir(), "{folder} is gone");
    }
    let sources = sources();
    for place in sources.iter().map(|s| &s.place) {
        let is_planned = place[0] != "io"
            || place.len() < 3
            || ROOMS_OF_IO.iter().any(|(folder, _)| *folder == place[1]);
        assert!(is_planned, "{} is not on the plan", place.join("/"));
    }
    let wrong = against_the_plan_of_io(&sources);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_search_for_ways_back_up_in_io_finds_them() {
    let files = [
        source(&["io", "mod.rs"], "mod table; pub use table::Grid;"),
        source(&["io", "error.rs"], "use super::table::scan::scan;"),
        source(&["io", "table", "mod.rs"], "mod scan; pub struct Grid;"),
        source(&["io", "table", "scan.rs"], "use crate::io::error::E;"),
        source(&["io", "write", "csv.rs"], "use crate::io::Grid;"),
        source(&["io", "formats", "svc.rs"], "use crate::io::table::scan;"),
    ];
    assert_eq!(
        against_the_plan_of_io(&files),
        ["io/error uses io/table/scan", "io/write/csv uses io/table"]
    );
}

/// Most lines of a file without its tests.
const MOST_LINES: usize = 450;

/// Tables of words and figures, which may be as long as they are.
const TABLES: [&str; 1] = ["src/app/glossary/words.rs"];

/// Files that are longer still. The list may only become shorter.
const LONG: [&str; 0] = [];

#[test]
fn no_file_is_longer_than_450_lines_without_its_tests() {
    for source in sources() {
        let name = source.name();
        if TABLES.contains(&&*name) || name.ends_with("/tests.rs") {
            continue;
        }
        let (is_long, is_known) = (source.lines > MOST_LINES, LONG.contains(&&*name));
        assert!(is_known || !is_long, "{name}: {} lines", source.lines);
        assert!(
            is_long || !is_known,
            "{name}: {} lines, take it from the list",
            source.lines
        );
    }
    for name in TABLES.iter().chain(&LONG) {
        assert!(root().join(name).is_file(), "{name} is gone");
    }
}

/// Most lines of the readers and writers, tests among them: 20 000 before their sentences could be
/// translated, whose figures stand in lines of their own since.
const MOST_LINES_OF_IO: usize = 21_000;

/// What the readers had under many names before there was one raw spectrum.
const ONE_RAW_TYPE: [&str; 9] = [
    "Draft",
    "Measured",
    "Found",
    "Meaning",
    "Values",
    "Channels",
    "Told",
    "Understood",
    "Guess",
];

/// The lines of what stands in some rooms, each with its file's name.
fn lines_of(rooms: &[&str]) -> Vec<(String, String)> {
    let src = root().join("src");
    let files = rooms.iter().flat_map(|room| files_below(&src.join(room)));
    let mut lines = Vec::new();
    for path in files {
        let place = path.strip_prefix(&src).expect("found below src");
        let name = place.to_string_lossy().replace('\\', "/");
        let text = fs::read_to_string(&path).expect("a source file is UTF-8");
        lines.extend(text.lines().map(|line| (name.clone(), line.to_owned())));
    }
    lines
}

#[test]
fn readers_stay_small_have_one_raw_type_and_one_open_door() {
    let lines = lines_of(&["io"]);
    assert!(
        lines.len() <= MOST_LINES_OF_IO,
        "src/io: {} lines",
        lines.len()
    );
    let is_raw = |line: &str| {
        let name = line.split_once("struct ").map_or("", |(_, name)| name);
        let end = name.find(|c: char| !c.is_alphanumeric());
        ONE_RAW_TYPE.contains(&&name[..end.unwrap_or(name.len())])
    };
    let raw: Vec<_> = lines.iter().filter(|(_, line)| is_raw(line)).collect();
    assert!(raw.is_empty(), "{raw:?}");
    let open =
        |(name, line): &&(String, String)| name == "io/mod.rs" && line.starts_with("pub mod");
    assert_eq!(lines.iter().filter(open).count(), 1);
}

#[test]
fn choices_are_kept_in_one_file_and_no_note_is_rewritten() {
    let lines = lines_of(&["io", "app"]);
    let by_hand: BTreeSet<&String> = lines
        .iter()
        .filter_map(|(name, line)| line.contains("BY_HAND").then_some(name))
        .collect();
    assert_eq!(by_hand.len(), 1, "{by_hand:?}");
    let rewrites = |line: &str| {
        let replaced = line
            .split_once("replacen(")
            .map_or("", |(_, behind)| behind);
        let said = ["said", "fraction", "kind"];
        // Empty notes may go: that reads none.
        said.iter().any(|word| replaced.contains(word))
            || line.contains("notes.retain") && !line.contains("!note.is_empty()")
    };
    let rewritten: Vec<_> = lines.iter().filter(|(_, line)| rewrites(line)).collect();
    assert!(rewritten.is_empty(), "{rewritten:?}");
}

#[test]
fn every_room_of_the_house_is_on_the_plan() {
    let found: BTreeSet<String> = sources()
        .iter()
        .filter_map(|s| s.room().map(str::to_owned))
        .collect();
    let planned: BTreeSet<String> = ROOMS.iter().map(|(room, _)| (*room).to_owned()).collect();
    assert_eq!(found, planned);
}

#[test]
fn imports_point_downward_only() {
    let mut wrong = Vec::new();
    for source in sources() {
        let Some(room) = source.room() else { continue };
        let allowed = ROOMS
            .iter()
            .find(|(name, _)| *name == room)
            .map_or(&[][..], |(_, allowed)| allowed);
        for used in rooms_used(&source) {
            if !allowed.contains(&used.as_str()) {
                wrong.push(format!("{} uses {used}", source.name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_plan_itself_has_no_way_back_up() {
    // A room may only use rooms that stand before it in the list of rooms, io being a floor of
    // its own beside color and study.
    for (index, (room, allowed)) in ROOMS.iter().enumerate() {
        for below in *allowed {
            let place = ROOMS.iter().position(|(name, _)| name == below);
            assert!(place.is_some_and(|p| p < index), "{room} -> {below}");
        }
    }
}

#[test]
fn nobody_outside_the_crate_is_asked_for_the_crates_own_rooms() {
    // The library does not import itself by its public name, which would go round the rule.
    for source in sources() {
        if source.room().is_some() {
            assert!(
                !words(&source.code).any(|word| word == "spectral_explorer"),
                "{} names the crate from outside",
                source.name()
            );
        }
    }
}

#[test]
fn widgets_are_named_in_the_window_and_at_the_start_only() {
    let mut wrong = Vec::new();
    let mut in_window = 0;
    for source in sources() {
        let widgets: BTreeSet<&str> = words(&source.code)
            .filter(|word| WIDGETS.contains(word))
            .collect();
        if source.room() == Some("ui") {
            in_window += usize::from(!widgets.is_empty());
        } else if source.place != ["main.rs"] {
            wrong.extend(widgets.iter().map(|w| format!("{}: {w}", source.name())));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(
        in_window > 5,
        "the test sees egui in {in_window} files only"
    );
}

#[test]
fn the_reader_of_this_test_sees_what_it_should() {
    let code = code_of(
        r##"
        use crate::{app::{App, ui}, io, spectrum::Band};
        // crate::cli in a comment
        /* crate::ui /* nested */ crate::ui */
        let text = "crate::ui \" crate::cli";
        let raw = r#"crate::ui " crate::cli"#;
        let letters = ['"', '\'', 'a'];
        fn f<'a>(x: &'a str) -> &'a str { crate::color::Xyz::of(x) }
        my_crate::study::x();
        super::super::study::error();
        "##,
    );
    let names = named_after(&code, "crate::");
    assert_eq!(
        names.iter().map(String::as_str).collect::<Vec<_>>(),
        ["app", "color", "io", "spectrum"]
    );
    let source = Source {
        place: vec!["color".to_owned(), "x.rs".to_owned()],
        code,
        untested: String::new(),
        lines: 0,
    };
    assert_eq!(
        rooms_used(&source).into_iter().collect::<Vec<_>>(),
        ["app", "io", "spectrum", "study"]
    );
}

/// Beginnings of paths that lead to a person's own folder, made of parts so that this file does
/// not hold them.
fn private_folders() -> Vec<String> {
    ["home", "root", "tmp", "Users", "var/folders"]
        .map(|folder| format!("/{folder}/"))
        .into_iter()
        .chain([format!("{}:\\Users\\", 'C')])
        .collect()
}

/// Where a text names a private folder with something in it: `/folder/x`, not a lone `/folder/`.
fn private_path<'t>(text: &'t str, folders: &[String]) -> Option<&'t str> {
    for folder in folders {
        for (start, _) in text.match_indices(folder.as_str()) {
            let before = text[..start].chars().next_back();
            let after = text[start + folder.len()..].chars().next();
            // Part of a web address or of a longer path is something else.
            let is_start = !is_word(before) && !matches!(before, Some('.' | '-' | '~' | ')' | '}'));
            if is_start && is_word(after) {
                let end = text[start..]
                    .find(|c: char| c.is_whitespace() || c == '"')
                    .unwrap_or(text.len() - start);
                return Some(&text[start..start + end]);
            }
        }
    }
    None
}

#[test]
fn no_file_knows_on_whose_computer_it_was_written() {
    let root = root();
    let mut files: Vec<PathBuf> = [
        "src", "tests", "presets", "benches", "LICENSES", ".ci", "fuzz", "docs",
    ]
    .iter()
    .flat_map(|folder| files_below(&root.join(folder)))
    .collect();
    files.extend(
        ["Cargo.toml", "README.md", ".gitignore"]
            .iter()
            .map(|f| root.join(f)),
    );
    let folders = private_folders();
    // A copy that lies at `/src` or the like proves nothing: such words stand in many texts.
    let here = (root.components().count() > 2).then(|| root.display().to_string());
    let is_here = |text: &str| here.as_ref().is_some_and(|here| text.contains(here));
    let (mut read, mut wrong) = (0, Vec::new());
    for path in files {
        // Fonts and pictures are no text; what is missing holds nothing.
        let Ok(text) = fs::read_to_string(&path) else {
            continue;
        };
        read += 1;
        let found = private_path(&text, &folders)
            .or_else(|| is_here(&text).then_some("the folder of this copy"));
        if let Some(found) = found {
            let name = path.strip_prefix(&root).unwrap_or(&path);
            wrong.push(format!("{}: {found}", name.display()));
        }
    }
    assert!(read > 80, "only {read} files were read");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_search_for_private_folders_finds_one() {
    let folders = private_folders();
    for folder in &folders {
        let text = format!("let lamp = \"{folder}anna\";");
        assert!(private_path(&text, &folders).is_some(), "{text}");
        let listed = format!("{folder:?}, and");
        assert!(private_path(&listed, &folders).is_none(), "{listed}");
    }
    assert_eq!(
        private_path("https://example.org/home/anna", &folders),
        None
    );
}
