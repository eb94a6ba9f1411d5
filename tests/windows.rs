//! Several windows on one workspace: nothing that was opened in any of them is lost, however they
//! end and whichever saved last. Each window here is a process of its own.

use std::{
    fs,
    io::{BufRead, BufReader, Write},
    path::{Path, PathBuf},
    process::{Child, ChildStdin, ChildStdout, Command as Process, Stdio},
};

use spectral_explorer::{
    app::{App, Command, Settings, workspace::Preferences},
    io::read_bytes,
    ui::{saver::Saver, shell},
};

/// The workspace that a child is a window over.
const WORKSPACE: &str = "SPECTRAL_EXPLORER_TEST_SHARED_WORKSPACE";
/// The file that it opens; empty for none.
const OPENS: &str = "SPECTRAL_EXPLORER_TEST_OPENS";
/// How a line begins that is meant for the parent.
const SAYS: &str = "child says:";

/// The child: a window without a display. Does nothing unless it is told where its workspace is.
#[test]
fn child_window() {
    let Some(path) = std::env::var_os(WORKSPACE).map(PathBuf::from) else {
        return;
    };
    let opens = std::env::var(OPENS).unwrap_or_default();
    let shell::Restart {
        mut app,
        preferences,
        images,
        place,
        ..
    } = shell::restore(Some(&path));
    let place = place.expect("a workspace of its own");
    let keep = |app: &App, preferences: &Preferences| {
        let saver = Saver::new(place.path().to_owned());
        saver.keep_with(app.document(), preferences, &images);
        // It waits until all is on disk.
        drop(saver);
    };
    let words: Vec<String> = app.messages().iter().map(|m| m.text.clone()).collect();
    let say = |what: &str| println!("\n{SAYS}{what}");
    say(&words.join(" | "));
    if !opens.is_empty() {
        let reading = read_bytes(&opens, b"400,1\n500,2\n600,3\n700,2\n").expect("a table");
        app.apply(Command::Adopt(reading.spectra));
        keep(&app, &preferences);
    }
    let own: Vec<&str> = app
        .document()
        .own
        .iter()
        .map(|e| e.spectrum.source.as_str())
        .collect();
    say(&own.join(","));
    for line in std::io::stdin().lines() {
        match line.as_deref() {
            Ok("move") => {
                let settings = app.document().settings;
                let order = settings.order + 1;
                app.apply(Command::Edit(Settings { order, ..settings }));
                app.end_gesture();
                keep(&app, &preferences);
                say("moved");
            }
            // As a window does when it closes.
            Ok("close") => {
                keep(&app, &preferences);
                return;
            }
            // The parent is gone.
            _ => return,
        }
    }
}

/// A window as its parent sees it.
struct Window {
    process: Child,
    into: ChildStdin,
    out: BufReader<ChildStdout>,
    words: String,
    /// The files that its own spectra came from.
    own: Vec<String>,
}

impl Window {
    fn spawned(path: &Path, opens: &str) -> Child {
        Process::new(std::env::current_exe().expect("this test's own program"))
            .args(["--exact", "child_window", "--nocapture"])
            .env(WORKSPACE, path)
            .env(OPENS, opens)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("a child")
    }

    fn of(mut process: Child) -> Self {
        let into = process.stdin.take().expect("a pipe");
        let out = BufReader::new(process.stdout.take().expect("a pipe"));
        let mut window = Self {
            process,
            into,
            out,
            words: String::new(),
            own: Vec::new(),
        };
        window.words = window.hear();
        let own = window.hear();
        let own = own.split(',').filter(|name| !name.is_empty());
        window.own = own.map(str::to_owned).collect();
        window
    }

    fn open(path: &Path, opens: &str) -> Self {
        Self::of(Self::spawned(path, opens))
    }

    fn hear(&mut self) -> String {
        loop {
            let mut line = String::new();
            let read = self.out.read_line(&mut line).expect("a pipe");
            assert!(read > 0, "the child has ended");
            if let Some(words) = line.trim_end().strip_prefix(SAYS) {
                return words.to_owned();
            }
        }
    }

    fn moves(&mut self) {
        writeln!(self.into, "move").expect("a pipe");
        assert_eq!(self.hear(), "moved");
    }

    fn end(mut self, how: End) {
        match how {
            End::Killed => self.process.kill().expect("a child that is alive"),
            End::Closed => writeln!(self.into, "close").expect("a pipe"),
        }
        self.process.wait().expect("a child that ends");
    }

    fn sorted(&self) -> Vec<&str> {
        let mut own: Vec<&str> = self.own.iter().map(String::as_str).collect();
        own.sort_unstable();
        own
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    Killed,
    Closed,
}

const ENDS: [End; 2] = [End::Killed, End::Closed];

#[test]
fn what_two_windows_opened_is_in_the_next_one_however_they_end_and_whoever_saved_last() {
    for first_saves_last in [false, true] {
        for first_ends_first in [false, true] {
            for ends in ENDS.into_iter().flat_map(|a| ENDS.map(|b| [a, b])) {
                let folder = tempfile::tempdir().expect("a folder");
                let path = folder.path().join("workspace.json");
                let mut a = Window::open(&path, "a.csv");
                let mut b = Window::open(&path, "b.csv");
                assert!(!a.words.contains("Another window"), "{}", a.words);
                assert!(
                    b.words.contains("Another window uses this workspace")
                        && b.words.contains("workspace.window-2.json"),
                    "{}",
                    b.words
                );
                assert_eq!((a.sorted(), b.sorted()), (vec!["a.csv"], vec!["b.csv"]));
                if first_saves_last {
                    b.moves();
                    a.moves();
                } else {
                    a.moves();
                    b.moves();
                }
                let [first, second] = if first_ends_first { [a, b] } else { [b, a] };
                first.end(ends[0]);
                second.end(ends[1]);
                let case = format!("{first_saves_last} {first_ends_first} {ends:?}");
                let next = Window::open(&path, "");
                assert_eq!(next.sorted(), ["a.csv", "b.csv"], "{case}");
                assert!(
                    next.words
                        .contains("Brought here from another window: 1 spectrum.")
                        && next.words.contains("workspace.window-2.brought.json"),
                    "{case}: {}",
                    next.words
                );
                next.end(ends[0]);
                let last = Window::open(&path, "");
                assert_eq!(last.sorted(), ["a.csv", "b.csv"], "{case}, once more");
                assert!(!last.words.contains("Brought"), "{}", last.words);
                last.end(End::Closed);
            }
        }
    }
}

#[test]
fn windows_started_at_once_each_have_a_workspace_and_all_comes_together() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let started = ["a.csv", "b.csv", "c.csv"].map(|name| Window::spawned(&path, name));
    let windows = started.map(Window::of);
    for (window, name) in windows.iter().zip(["a.csv", "b.csv", "c.csv"]) {
        assert_eq!(window.own, [name]);
    }
    let beside = |w: &&Window| w.words.contains("Another window");
    assert_eq!(windows.iter().filter(beside).count(), 2);
    for window in windows {
        window.end(End::Killed);
    }
    let next = Window::open(&path, "");
    assert_eq!(next.sorted(), ["a.csv", "b.csv", "c.csv"]);
    next.end(End::Killed);
}

#[test]
fn the_place_of_a_window_that_is_gone_is_taken_with_all_that_it_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let a = Window::open(&path, "a.csv");
    let b = Window::open(&path, "b.csv");
    // The other one lives: the next window is the one that was killed, as it was left.
    b.end(End::Killed);
    let b = Window::open(&path, "c.csv");
    assert_eq!(b.sorted(), ["b.csv", "c.csv"]);
    a.end(End::Killed);
    let a = Window::open(&path, "d.csv");
    assert_eq!(a.sorted(), ["a.csv", "d.csv"]);
    a.end(End::Closed);
    b.end(End::Closed);
    let next = Window::open(&path, "");
    assert_eq!(next.sorted(), ["a.csv", "b.csv", "c.csv", "d.csv"]);
    next.end(End::Closed);
}

#[test]
fn what_was_brought_in_is_not_brought_twice_when_the_program_dies_in_between() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let a = Window::open(&path, "a.csv");
    Window::open(&path, "b.csv").end(End::Killed);
    a.end(End::Killed);
    let second = folder.path().join("workspace.window-2.json");
    let left = fs::read(&second).expect("the second window's");
    Window::open(&path, "").end(End::Killed);
    assert!(!second.exists());
    // Saved already, and killed before the other file was out of the way.
    fs::write(&second, left).expect("a file");
    let next = Window::open(&path, "");
    assert_eq!(next.sorted(), ["a.csv", "b.csv"]);
    next.end(End::Closed);
}
