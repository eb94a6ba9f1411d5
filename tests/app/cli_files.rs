//! The files of the command line, by the program itself: what it reads, whatever that is called and
//! wherever it comes from, and what it writes without losing anything.

use std::{
    ffi::{OsStr, OsString},
    fs,
    io::{BufRead, BufReader, Write},
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    sync::mpsc::channel,
    time::Duration,
};

use serde_json::Value;
use tempfile::TempDir;

/// A folder that the program is started in.
struct Desk(TempDir);

/// What the program did.
struct Told {
    code: i32,
    out: String,
    err: String,
}

impl Desk {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: impl AsRef<Path>, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).expect("a file");
    }

    fn get(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("a text")
    }

    fn program(&self, args: &[impl AsRef<OsStr>]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_spectral-explorer"));
        command.args(args).current_dir(&self.0).stdin(Stdio::null());
        command
    }

    fn run(&self, args: &[impl AsRef<OsStr>]) -> Told {
        told(&self.program(args).output().expect("it starts"))
    }

    /// With a file as standard input.
    fn run_on(&self, input: &str, args: &[&str]) -> Told {
        let file = fs::File::open(self.path(input)).expect("a file");
        let mut command = self.program(args);
        told(&command.stdin(file).output().expect("it starts"))
    }

    /// What a command that works prints on both ways out.
    #[track_caller]
    fn done(&self, args: &[impl AsRef<OsStr>]) -> Told {
        let told = self.run(args);
        assert_eq!(told.code, 0, "{}", told.err);
        told
    }

    /// The line with which a command is refused.
    #[track_caller]
    fn refused(&self, args: &[impl AsRef<OsStr>]) -> String {
        line(self.run(args))
    }
}

fn told(output: &Output) -> Told {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("UTF-8");
    Told {
        code: output.status.code().expect("it ends by itself"),
        out: text(&output.stdout),
        err: text(&output.stderr),
    }
}

#[track_caller]
fn line(told: Told) -> String {
    assert!([1, 2].contains(&told.code), "{} {}", told.code, told.out);
    assert_eq!(told.out, "");
    assert_eq!(told.err.lines().count(), 1, "{}", told.err);
    assert!(told.err.contains("expected"), "{}", told.err);
    told.err
}

fn rows(value: impl Fn(f64) -> f64) -> String {
    let row = |i| 380.0 + 5.0 * f64::from(i);
    let rows = (0..=80).map(row).map(|nm| format!("{nm},{}\n", value(nm)));
    rows.collect()
}

/// A light that says so.
fn lamp() -> String {
    format!("nm,irradiance (W/m2/nm)\n{}", rows(|nm| nm / 500.0))
}

fn three_spectra() -> String {
    let row = |i| format!("{},1,2,3\n", 380 + 5 * i);
    format!("nm,a,b,c\n{}", (0..=80).map(row).collect::<String>())
}

/// An ENVI cube of 2 x 2 pixels.
fn put_cube(desk: &Desk) {
    desk.put(
        "scene.hdr",
        "ENVI\nsamples = 2\nlines = 2\nbands = 2\nheader offset = 0\ndata type = 1\n\
         interleave = bip\nbyte order = 0\nwavelength units = Nanometers\nwavelength = {500, 600}\n",
    );
    desk.put("scene.img", [1, 2, 3, 4, 5, 6, 7, 8]);
}

#[cfg(unix)]
#[test]
fn nothing_is_written_onto_what_is_read_by_whatever_link() {
    let desk = Desk::new();
    desk.put("lamp.csv", lamp());
    fs::create_dir(desk.path("more")).expect("a folder");
    std::os::unix::fs::symlink(desk.path("lamp.csv"), desk.path("soft.csv")).expect("a link");
    fs::hard_link(desk.path("lamp.csv"), desk.path("hard.csv")).expect("a link");
    for out in ["lamp.csv", "soft.csv", "hard.csv", "more/../lamp.csv"] {
        for force in [&["--force"][..], &[]] {
            let line = desk.refused(&[&["convert", "lamp.csv", out], force].concat());
            assert!(line.contains("OUT: found"), "{line}");
            assert!(line.contains("which is what is read"), "{line}");
        }
    }
    let through = desk.refused(&["convert", "soft.csv", "lamp.csv", "--force"]);
    assert!(through.contains("which is what is read"), "{through}");
    let piped = line(desk.run_on("lamp.csv", &["convert", "-", "lamp.csv", "--force"]));
    assert!(piped.contains("which is what is read"), "{piped}");
    // A table may be called as a picture is.
    for name in ["lamp.svg", "lamp.png"] {
        fs::hard_link(desk.path("lamp.csv"), desk.path(name)).expect("a link");
    }
    for (read, out) in [
        (&["plot", "lamp.csv"][..], "lamp.svg"),
        (&["plot", "red", "--light", "lamp.csv"], "lamp.svg"),
        #[cfg(feature = "window")]
        (&["render", "lamp.csv"], "lamp.png"),
        #[cfg(feature = "window")]
        (&["render", "red", "--light", "lamp.csv"], "lamp.png"),
    ] {
        let line = desk.refused(&[read, &["--out", out, "--force"]].concat());
        assert!(line.contains("which is what is read"), "{line}");
    }
    assert_eq!(desk.get("lamp.csv"), lamp());
}

#[test]
fn the_other_file_of_a_pair_is_read_too() {
    let desk = Desk::new();
    put_cube(&desk);
    fs::hard_link(desk.path("scene.img"), desk.path("scene.csv")).expect("a link");
    let line = desk.refused(&["convert", "scene.hdr", "scene.csv", "--force"]);
    assert!(line.contains("which is what is read"), "{line}");
    assert_eq!(fs::read(desk.path("scene.img")).expect("there").len(), 8);
}

#[test]
fn data_replace_another_file_only_with_force() {
    let desk = Desk::new();
    for name in ["notes.csv", "notes.txt", "notes.composite.json"] {
        desk.put(name, "kept");
        let line = desk.refused(&["convert", "FL2", name]);
        assert!(line.contains("which exists already"), "{line}");
        assert!(line.contains("--force"), "{line}");
        assert_eq!(desk.get(name), "kept");
        desk.done(&["convert", "FL2", name, "--force"]);
        assert_ne!(desk.get(name), "kept");
    }
    desk.put("three.csv", three_spectra());
    desk.put("all.csv", "kept");
    desk.refused(&["convert", "three.csv", "all.csv", "--all"]);
    assert_eq!(desk.get("all.csv"), "kept");
}

#[cfg(target_os = "linux")]
#[test]
fn devices_are_written_into_without_force() {
    let desk = Desk::new();
    std::os::unix::fs::symlink("/dev/stdout", desk.path("o.csv")).expect("a link");
    let told = desk.done(&["convert", "FL2", "o.csv"]);
    assert!(told.out.contains("380,"), "{}", told.out);
}

/// Without the window there are pictures of vectors only, and the refusals.
#[test]
fn a_picture_replaces_a_picture_and_nothing_else() {
    let desk = Desk::new();
    let window = cfg!(feature = "window");
    for out in ["p.svg", "p.png"].into_iter().take(1 + usize::from(window)) {
        desk.done(&["plot", "FL2", "--out", out, "--size", "320x240"]);
        let first = fs::read(desk.path(out)).expect("a picture");
        desk.done(&["plot", "FL11", "--out", out, "--size", "320x240"]);
        assert_ne!(fs::read(desk.path(out)).expect("a picture"), first);
    }
    desk.put("notes.png", lamp());
    if !window {
        return the_window_is_missing(&desk);
    }
    desk.done(&["render", "FL2", "--out", "p.png", "--size", "320x240"]);
    for command in ["plot", "render"] {
        let args = [command, "FL2", "--out", "notes.png", "--size", "320x240"];
        let line = desk.refused(&args);
        assert!(line.contains("is no picture"), "{line}");
        assert_eq!(desk.get("notes.png"), lamp());
    }
    desk.done(&["plot", "FL2", "--out", "notes.png", "--force"]);
    let drawn = fs::read(desk.path("notes.png")).expect("a picture");
    assert!(drawn.starts_with(b"\x89PNG"));
}

fn the_window_is_missing(desk: &Desk) {
    for command in ["plot", "render"] {
        let line = desk.refused(&[command, "FL2", "--out", "notes.png"]);
        assert!(line.contains("without the window"), "{line}");
        assert_eq!(desk.get("notes.png"), lamp());
    }
}

#[cfg(all(target_os = "linux", feature = "window"))]
#[test]
fn the_picture_of_a_missing_window_replaces_nothing_not_even_a_link() {
    let desk = Desk::new();
    let link = desk.path("spectral-explorer.png");
    std::os::unix::fs::symlink("gone.png", &link).expect("a link");
    let mut command = desk.program(&["FL2"]);
    for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(name);
    }
    command.env("SPECTRAL_EXPLORER_WORKSPACE", "");
    let told = told(&command.output().expect("it starts"));
    assert!(told.out.contains("spectral-explorer-2.png"), "{}", told.out);
    assert!(link.is_symlink());
}

#[test]
fn of_several_spectra_one_is_named_or_all_are_written() {
    let desk = Desk::new();
    desk.put("three.csv", three_spectra());
    for out in [
        "o.csv",
        "o.spd",
        "o.sp",
        "o.json",
        "o.txt",
        "o.composite.json",
    ] {
        let line = desk.refused(&["convert", "three.csv", out]);
        assert!(line.contains("found 3 spectra"), "{out}: {line}");
        assert!(
            line.contains("--spectrum") && line.contains("--all"),
            "{line}"
        );
        assert!(!desk.path(out).exists(), "{out}");
    }
    desk.done(&["convert", "three.csv", "b.csv", "--spectrum", "b"]);
    desk.done(&["convert", "three.csv", "b.txt", "--spectrum", "2"]);
    let all = desk.done(&["convert", "three.csv", "all.csv", "--all"]);
    assert!(all.out.contains("3 spectra"), "{}", all.out);
    // An image is one thing, and its mean is what is meant.
    put_cube(&desk);
    desk.done(&["convert", "scene.hdr", "mean.csv"]);
}

/// Files that are sure to be no light, by what they state or by a name that leaves no doubt.
fn no_lights(desk: &Desk) -> [(&'static str, &'static str); 3] {
    desk.put("glass.csv", format!("nm,absorbance\n{}", rows(|_| 0.5)));
    desk.put("leaf.csv", format!("nm,reflectance %\n{}", rows(|_| 50.0)));
    desk.put("macbeth-1.csv", rows(|_| 0.3));
    [
        ("glass.csv", "absorbance"),
        ("leaf.csv", "reflectance"),
        ("macbeth-1.csv", "reflectance"),
    ]
}

#[test]
fn a_file_that_is_sure_to_be_something_else_is_no_light() {
    let desk = Desk::new();
    for (file, kind) in no_lights(&desk) {
        for args in [
            &["product", file, "red"][..],
            &["product", "FL2", "red", "--check", file],
            &["report", "red", "--light", file],
            &["sweep", "red", "--light", file],
            &["plot", "red", "--light", file, "--out", "p.svg"],
        ] {
            let line = desk.refused(args);
            let words = format!("{file}: found {kind} values, expected a light");
            assert!(line.contains(&words), "{args:?}: {line}");
        }
    }
    // What the remedy says works.
    desk.done(&["convert", "macbeth-1.csv", "lamp.csv", "--kind", "light"]);
    let told = desk.done(&["product", "lamp.csv", "red"]);
    assert_eq!(told.err, "");
}

#[test]
fn a_file_that_says_nothing_is_taken_as_a_light_with_a_word() {
    let desk = Desk::new();
    desk.put("bare.csv", rows(|nm| nm / 500.0));
    // A name that might mean two kinds.
    desk.put("lamp behind a filter.csv", rows(|nm| nm / 5.0));
    for file in ["bare.csv", "lamp behind a filter.csv"] {
        for args in [
            &["product", file, "red"][..],
            &["product", "FL2", "red", "--check", file],
            &["report", "red", "--light", file],
        ] {
            let told = desk.done(args);
            assert_eq!(told.err.lines().count(), 1, "{}", told.err);
            let words = "found nothing that says what its values are, taken as a light";
            assert!(told.err.contains(words), "{args:?}: {}", told.err);
        }
    }
    let told = desk.done(&["product", "FL2", "lamp behind a filter.csv"]);
    assert!(told.err.contains("taken as transmittance"), "{}", told.err);
    desk.put("lamp.csv", lamp());
    assert_eq!(desk.done(&["product", "lamp.csv", "red"]).err, "");
}

#[test]
fn absorbance_is_a_factor_only_where_it_is_said_and_with_a_word() {
    let desk = Desk::new();
    desk.put("glass.csv", format!("nm,absorbance\n{}", rows(|_| 0.5)));
    let line = desk.refused(&["product", "FL2", "glass.csv"]);
    assert!(
        line.contains("glass.csv: found absorbance values"),
        "{line}"
    );
    let told = desk.done(&["product", "FL2", "glass.csv", "--kind", "transmittance"]);
    let words = "found absorbance values, taken as transmittance as --kind says";
    assert!(told.err.contains(words), "{}", told.err);
    let told = desk.done(&["report", "glass.csv", "--kind", "transmittance"]);
    assert!(
        told.out.contains("chosen by hand as transmittance"),
        "{}",
        told.out
    );
    // A shipped factor knows what it is.
    let told = desk.done(&["product", "FL2", "red", "--kind", "transmittance"]);
    assert!(told.err.contains("--kind is not used"), "{}", told.err);
}

#[cfg(unix)]
#[test]
fn a_word_that_leads_to_no_file_says_what_stands_there() {
    let desk = Desk::new();
    fs::create_dir(desk.path("lamps")).expect("a folder");
    desk.put("x.csv", lamp());
    std::os::unix::fs::symlink("round", desk.path("round")).expect("a link");
    for command in ["report", "sweep"] {
        let of = |word: &str| desk.refused(&[command, word]);
        assert!(of("lamps").contains("lamps: found a folder"));
        assert!(of("x.csv/y").contains("x.csv/y: found x.csv, which is no folder"));
        assert!(of("round").contains("round: found a link that leads nowhere"));
    }
    let told = desk.run(&["report", "no lamp"]);
    assert!(told.err.contains("no shipped spectrum"), "{}", told.err);
    let line = desk.refused(&["product", "FL2", "lamps"]);
    assert!(line.contains("FACTOR: lamps: found a folder"), "{line}");
    assert!(
        desk.refused(&["read", "x.csv/y"])
            .contains("which is no folder")
    );
}

#[test]
fn two_files_of_one_name_are_told_apart() {
    let desk = Desk::new();
    for folder in ["a", "b", "empty"] {
        fs::create_dir_all(desk.path(folder).join("empty")).expect("a folder");
        desk.put(format!("{folder}/x.csv"), "no spectrum");
    }
    let told = desk.run(&["read", "a/x.csv", "b/x.csv", "a/empty", "b/empty"]);
    assert_eq!(told.code, 1);
    for (said, name) in told
        .err
        .lines()
        .zip(["a/x.csv", "b/x.csv", "a/empty", "b/empty"])
    {
        assert!(said.contains(&format!(": {name}")), "{said}");
    }
    let all: Value = {
        let told = desk.run(&["read", "a/x.csv", "--json"]);
        serde_json::from_str(&told.out).expect("JSON")
    };
    assert!(
        all[0]["error"]
            .as_str()
            .expect("why")
            .starts_with("a/x.csv, line 1: ")
    );
    let line = desk.refused(&["product", "FL2", "b/x.csv"]);
    assert!(line.contains("b/x.csv, line 1: "), "{line}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_files_name_never_reaches_the_terminal_raw() {
    let desk = Desk::new();
    let name = "od\u{1b}[31md\n.csv";
    desk.put(name, lamp());
    desk.put("bad\u{1b}[31m.csv", "no spectrum");
    let read = desk.run(&["read", name, "bad\u{1b}[31m.csv"]);
    assert!(
        read.out.starts_with("od\\u{1b}[31md\\n.csv: "),
        "{}",
        read.out
    );
    let written = desk.done(&["convert", name, "o\u{7}.csv"]);
    for text in [read.out, read.err, written.out, written.err] {
        assert!(!text.contains(['\u{1b}', '\u{7}']), "{text:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_files_name_need_not_be_unicode() {
    use std::os::unix::ffi::OsStringExt;
    let desk = Desk::new();
    let name = OsString::from_vec(b"gr\xfcn.csv".to_vec());
    desk.put(&name, lamp());
    let folder = OsString::from_vec(b"l\xe4mps".to_vec());
    fs::create_dir(desk.path(&folder)).expect("a folder");
    desk.put(Path::new(&folder).join("a.csv"), lamp());
    let mut second = name.clone();
    second.push("#1*2");
    let words = |args: &[&str]| -> Vec<OsString> { args.iter().map(OsString::from).collect() };
    for (before, file, behind) in [
        (&["read"][..], &name, &[][..]),
        (&["report"], &name, &[]),
        (&["report", "red", "--light"], &name, &[]),
        (&["sweep"], &name, &[]),
        (&["auction"], &name, &["--goal", "own", "--numbers", "3"]),
        (&["race"], &name, &["--numbers", "3"]),
        (&["race", "--numbers", "3", "--set"], &folder, &[]),
        (&["product"], &name, &["red"]),
        (&["product", "FL2"], &second, &["--kind", "reflectance"]),
        (&["product", "FL2", "red", "--check"], &name, &[]),
        (&["plot"], &name, &["--out", "p.svg"]),
        (&["convert"], &name, &["o.json"]),
        #[cfg(feature = "window")]
        (&["render"], &name, &["--out", "p.png", "--size", "320x240"]),
    ] {
        let args = [words(before), vec![file.clone()], words(behind)].concat();
        let told = desk.run(&args);
        assert_eq!(told.code, 0, "{before:?}: {}", told.err);
    }
}

#[test]
fn a_hyphen_is_standard_input_wherever_a_file_is_read() {
    let desk = Desk::new();
    desk.put("lamp.csv", lamp());
    desk.put("half.csv", format!("nm,reflectance\n{}", rows(|_| 0.5)));
    for (input, args, words) in [
        (
            "lamp.csv",
            &["report", "-"][..],
            "standard input (light, 81 points",
        ),
        ("lamp.csv", &["read", "-"], "-: plain columns"),
        ("lamp.csv", &["sweep", "-"], "standard input"),
        (
            "lamp.csv",
            &["race", "-", "--numbers", "3"],
            "standard input",
        ),
        (
            "lamp.csv",
            &["product", "-", "red"],
            "Light     standard input",
        ),
        ("half.csv", &["product", "FL2", "-"], "passes  50.00 %"),
        (
            "lamp.csv",
            &["report", "red", "--light", "-"],
            "under standard input",
        ),
        ("lamp.csv", &["convert", "-", "o.json"], "Wrote o.json"),
        // The stream is read once, however often it is asked for.
        (
            "lamp.csv",
            &["convert", "-", "o.composite.json"],
            "Wrote o.composite.json",
        ),
    ] {
        let told = desk.run_on(input, args);
        assert_eq!(told.code, 0, "{args:?}: {}", told.err);
        assert!(told.out.contains(words), "{args:?}: {}", told.out);
    }
    // A model stays one.
    let told = desk.run_on(
        "o.composite.json",
        &["convert", "-", "again.composite.json"],
    );
    assert_eq!(told.code, 0, "{}", told.err);
    assert_eq!(
        desk.get("again.composite.json"),
        desk.get("o.composite.json")
    );
    let empty = line(desk.run(&["report", "-"]));
    assert!(
        empty.contains("standard input: found an empty file"),
        "{empty}"
    );
    assert!(desk.refused(&["-"]).contains("found standard input"));
}

#[cfg(unix)]
#[test]
fn a_pipe_that_nobody_writes_into_is_waited_for_with_a_word() {
    let desk = Desk::new();
    let pipe = desk.path("pipe");
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.is_ok_and(|status| status.success()));
    let mut command = desk.program(&["read", "pipe"]);
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("it starts");
    let mut said = BufReader::new(child.stderr.take().expect("piped"));
    let (sender, first_line) = channel();
    std::thread::spawn(move || {
        let mut line = String::new();
        // Whoever waits for it may have given up.
        let _ = said.read_line(&mut line).map(|_| sender.send(line));
    });
    // Without a word it would wait for ever: so long that no machine is as slow.
    let word = first_line.recv_timeout(Duration::from_secs(120));
    if word.is_err() {
        child.kill().expect("it runs");
    }
    let word = word.expect("a word");
    assert!(
        word.contains("pipe: waiting for something to write"),
        "{word}"
    );
    let mut end = fs::OpenOptions::new()
        .write(true)
        .open(&pipe)
        .expect("the other end");
    end.write_all(lamp().as_bytes()).expect("written");
    drop(end);
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success());
    assert!(told(&output).out.starts_with("pipe: plain columns"));
}

#[test]
fn options_that_do_nothing_are_told() {
    let desk = Desk::new();
    for (args, words) in [
        (
            &["sweep", "FL2", "--order", "3"][..],
            "--order 3 is not used",
        ),
        (&["--licences", "FL2"], "FL2 is not used"),
        (
            &[
                "product",
                "FL2",
                "red",
                "--check",
                "FL2",
                "--sampling",
                "3n",
            ],
            "--sampling is not",
        ),
        (&["report", "red", "--sampling", "3n"], "--sampling is not"),
        (
            &["convert", "FL2", "m.txt", "--sampling", "3n"],
            "--sampling is not",
        ),
    ] {
        let told = desk.done(args);
        assert_eq!(told.err.lines().count(), 1, "{args:?}: {}", told.err);
        assert!(told.err.contains(words), "{args:?}: {}", told.err);
    }
    // Beyond the usual end of the sweep it does something.
    assert_eq!(desk.done(&["sweep", "FL2", "--order", "42"]).err, "");
    let line = desk.refused(&["auction", "FL2"]);
    assert!(
        line.contains("found no --goal GOAL and no --numbers P, expected both"),
        "{line}"
    );
}

#[test]
fn one_number_is_no_numbers() {
    let desk = Desk::new();
    let one = ["--order", "0", "--no-spikes"];
    for args in [&["report", "FL2"][..], &["product", "FL2", "red"]] {
        let told = desk.done(&[args, &one].concat());
        assert!(told.out.contains(": 1 number\n"), "{}", told.out);
    }
    let told = desk.done(&[&["convert", "FL2", "m.txt"][..], &one].concat());
    assert!(told.out.contains(", 1 number\n"), "{}", told.out);
    let told = desk.done(&["read", "m.txt"]);
    assert!(
        told.out.contains("a composite of 1 number on"),
        "{}",
        told.out
    );
}

#[test]
fn the_colour_of_the_whole_is_known_where_the_models_range_is_dark() {
    let desk = Desk::new();
    for input in ["FL2", "colorchecker_ohta/red"] {
        let of = |range: &str| -> Value {
            let told = desk.done(&["report", input, "--json", "--range", range]);
            let report: Value = serde_json::from_str(&told.out).expect("JSON");
            report["colour"].clone()
        };
        let (dark, visible) = (of("900:1100"), of("380:780"));
        assert!(dark["exact"]["xyz"].is_null());
        assert!(dark["full"]["xyz"].is_array(), "{input}");
        assert_eq!(dark["full"], visible["full"], "{input}");
    }
}

#[test]
fn help_says_which_figures_are_fractions() {
    let desk = Desk::new();
    for command in ["report", "sweep", "auction", "race", "product"] {
        let help = desk.done(&[command, "--help"]).out;
        let help: Vec<&str> = help.split_whitespace().collect();
        assert!(help.join(" ").contains("fractions of 1"), "{command}");
    }
}

#[test]
fn a_spectrum_of_our_own_says_once_how_it_was_read() {
    let desk = Desk::new();
    desk.put("lamp.csv", lamp());
    for out in ["o.csv", "o.sp", "o.spd"] {
        desk.done(&["convert", "lamp.csv", out]);
        let told = desk.done(&["report", out]);
        let line = "Note      5 nm steps, 81 points, 380-780 nm, light, W/m2/nm";
        let count = told.out.lines().filter(|said| *said == line).count();
        assert_eq!(count, 1, "{out}: {}", told.out);
    }
}

#[test]
fn tables_are_read_as_the_command_line_says() {
    let desk = Desk::new();
    let rows = |from: u32, step: u32| -> String {
        (0..81)
            .map(|i| format!("{},{}\n", from + step * i, 1 + i))
            .collect()
    };
    desk.put("angstrom.csv", rows(3800, 50));
    let plain = desk.run(&["read", "angstrom.csv"]);
    assert!(
        plain
            .out
            .contains("taken as Å: the range 3800 to 7800 at even steps"),
        "{}",
        plain.out
    );
    let told = desk.run(&["read", "angstrom.csv", "--wavelength-unit", "A"]);
    assert!(told.out.contains("380-780 nm"), "{}", told.out);
    assert!(told.out.contains("chosen by hand"), "{}", told.out);
    let report = desk.run(&["report", "angstrom.csv", "--wavelength-unit", "A"]);
    assert_eq!(report.code, 0, "{}", report.err);

    let two: String = (0..81)
        .map(|i| format!("{},{}\n", 900 - i, 380 + 5 * i))
        .collect();
    desk.put("two.csv", two);
    let second = desk.run(&["read", "two.csv", "--column", "2"]);
    assert!(
        second.out.contains("5 nm steps, 81 points, 380-780 nm"),
        "{}",
        second.out
    );
    let none = desk.run(&["read", "two.csv", "--column", "3"]);
    assert_eq!(none.code, 1);
    assert!(none.err.contains("a table of 2 columns"), "{}", none.err);
    assert_eq!(desk.run(&["read", "two.csv", "--column", "0"]).code, 2);

    desk.put("commas.csv", "380,5 1,5\n385,5 2,5\n390,5 3,5\n395,5 4,5\n");
    let blanks = desk.run(&["read", "commas.csv", "--delimiter", "space"]);
    assert!(
        blanks
            .out
            .contains("cells separated by blanks, decimal comma"),
        "{}",
        blanks.out
    );
    let word = desk.run(&["read", "two.csv", "--delimiter", "dots"]);
    assert_eq!(word.code, 2);

    desk.put(
        "own.json",
        r#"{"format":"spectral-explorer-spectrum","version":1,"kind":"light",
        "wavelengths_nm":[380,480,580],"values":[1,2,3]}"#,
    );
    let fixed = desk.run(&[
        "read",
        "own.json",
        "--wavelength-unit",
        "um",
        "--column",
        "2",
    ]);
    assert!(
        fixed.out.contains("the format has its own"),
        "{}",
        fixed.out
    );
    assert!(fixed.out.contains("no plain table"), "{}", fixed.out);
}

/// Three lights, the second much redder than the first.
fn three_lamps() -> String {
    let row = |i: i32| {
        let nm = 380 + 5 * i;
        format!("{nm},{},{},{}\n", 100 + i, 1 + i * i, 200 - i)
    };
    let titles = ["a", "b", "c"].map(|name| format!("{name} (W/m2/nm)"));
    let rows: String = (0..=80).map(row).collect();
    format!("nm,{}\n{rows}", titles.join(","))
}

#[test]
fn the_first_of_several_is_told_and_another_is_named_wherever_one_is_taken() {
    let desk = Desk::new();
    desk.put("lamps.csv", three_lamps());
    let row = |i| format!("{},{},{}\n", 380 + 5 * i, 50, 10 + i % 80);
    let rows: String = (0..=80).map(row).collect();
    desk.put(
        "glass.csv",
        format!("nm,transmittance a (%),transmittance b (%)\n{rows}"),
    );
    let gem = ["gem", "--size", "16", "--rays", "1", "--json"];
    let gem = |more: &[&'static str]| [&gem[..], more].concat();
    for args in [
        vec!["encode", "lamps.csv"],
        vec!["prism", "lamps.csv", "--at", "500"],
        vec!["rainbow", "lamps.csv", "--at", "500"],
        vec!["sweep", "lamps.csv"],
        vec!["product", "lamps.csv", "red"],
        vec!["product", "FL2", "glass.csv"],
        vec!["mix", "--channel", "lamps.csv"],
        vec![
            "mix",
            "--channel",
            "line:450",
            "--channel",
            "line:540",
            "--channel",
            "line:610",
            "--target",
            "lamps.csv",
        ],
        vec!["recover", "--colour", "#c08040", "--light", "lamps.csv"],
        vec!["plot", "lamps.csv", "--sheet", "--out", "sheet.svg"],
        vec!["plot", "red", "--light", "lamps.csv", "--out", "plot.svg"],
        gem(&["--light", "lamps.csv"]),
        gem(&["--filter", "glass.csv", "--thickness", "1"]),
    ] {
        let file = args.iter().find(|word| word.ends_with(".csv"));
        let file = *file.expect("a file");
        let told = desk.done(&args);
        let first = format!(
            "{file}: found {} spectra",
            if file == "lamps.csv" { 3 } else { 2 }
        );
        assert!(told.err.contains(&first), "{args:?}: {}", told.err);
        assert!(
            told.err.contains(&format!("({file}#2 is the second)")),
            "{}",
            told.err
        );
        let second = args.iter().map(|word| match *word == file {
            true => format!("{file}#2"),
            false => (*word).to_owned(),
        });
        let named = desk.done(&second.collect::<Vec<_>>());
        assert!(
            !named.err.contains("none of them named"),
            "{args:?}: {}",
            named.err
        );
        if args[0] != "plot" {
            assert_ne!(named.out, told.out, "{args:?}");
        }
    }
    // A report tells it among its notes.
    let report = desk.done(&["report", "lamps.csv"]);
    assert_eq!(report.err, "");
    assert!(report.out.contains("Spectrum 1 of 3"), "{}", report.out);
    let report = desk.done(&["report", "lamps.csv#lamps, column 4"]);
    assert!(report.out.contains("Spectrum 3 of 3"), "{}", report.out);
    // What is named so is read too, and never written onto.
    let line = desk.refused(&["convert", "lamps.csv#2", "lamps.csv", "--force"]);
    assert!(line.contains("which is what is read"), "{line}");
    desk.done(&["convert", "lamps.csv#2", "second.csv"]);
    assert!(
        desk.get("second.csv").contains("\n385,2\n"),
        "{}",
        desk.get("second.csv")
    );
}

#[test]
fn a_fit_of_a_folder_is_written_onto_none_of_its_files() {
    let desk = Desk::new();
    fs::create_dir(desk.path("d")).expect("a folder");
    desk.put("d/a.csv", lamp());
    desk.put("d/b.csv", lamp());
    for out in ["d/a.csv", "d/../d/b.csv"] {
        let line = desk.refused(&["fit", "d", "--out", out, "--force"]);
        assert!(line.contains("which is what is read"), "{line}");
    }
    assert_eq!([desk.get("d/a.csv"), desk.get("d/b.csv")], [lamp(), lamp()]);
    desk.done(&["fit", "d", "--out", "numbers.csv"]);
}

#[test]
fn spectral_pictures_and_documents_of_others_are_no_pictures_to_replace() {
    let desk = Desk::new();
    desk.done(&[
        "picture",
        "wall",
        "--numbers",
        "8",
        "--out",
        "scene.cspx.png",
    ]);
    let scene = fs::read(desk.path("scene.cspx.png")).expect("a picture");
    let thesis = format!("%PDF-1.4\n{}%%EOF\n", "my thesis\n".repeat(900));
    desk.put("thesis.pdf", &thesis);
    desk.put("drawn.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
    for args in [
        #[cfg(feature = "window")]
        &["plot", "FL2", "--out", "scene.cspx.png"][..],
        &[
            "gem",
            "--size",
            "16",
            "--rays",
            "1",
            "--out",
            "scene.cspx.png",
        ][..],
        &["plot", "FL2", "--sheet", "--out", "thesis.pdf"],
        &["plot", "FL2", "--out", "drawn.svg"],
    ] {
        let line = desk.refused(args);
        assert!(
            line.contains("is no picture that this program drew"),
            "{line}"
        );
    }
    assert_eq!(
        fs::read(desk.path("scene.cspx.png")).expect("a picture"),
        scene
    );
    assert_eq!(desk.get("thesis.pdf"), thesis);
    // Its own sheets and pictures are drawn anew.
    for _ in 0..2 {
        desk.done(&["plot", "FL2", "--sheet", "--out", "own.pdf"]);
        desk.done(&["plot", "FL2", "--sheet", "--out", "own.svg"]);
        desk.done(&["gem", "--size", "16", "--rays", "1", "--out", "own.png"]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_nothing_is_not_replaced_by_a_file() {
    let desk = Desk::new();
    std::os::unix::fs::symlink("gone.csv", desk.path("l.csv")).expect("a link");
    let line = desk.refused(&["convert", "FL2", "l.csv", "--force"]);
    assert!(
        line.contains("a link to something that is not there"),
        "{line}"
    );
    assert!(desk.path("l.csv").is_symlink());
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_pipes_are_no_pictures_and_no_lessons() {
    let desk = Desk::new();
    for args in [
        &["picture", "/dev/zero", "--relight", "FL2", "--out", "x.png"][..],
        &["lessons", "check", "/dev/zero"],
        &["lessons", "handout", "/dev/zero", "--out", "x.md"],
    ] {
        let line = desk.refused(args);
        assert!(
            line.contains("found a device or a pipe, expected a file"),
            "{line}"
        );
    }
}

#[test]
fn a_sheet_of_a_lesson_is_written_with_all_of_its_pictures_or_not_at_all() {
    let desk = Desk::new();
    // Nothing can be written where a folder stands.
    for name in ["s-1.svg", "s-1.png"] {
        fs::create_dir(desk.path(name)).expect("a folder");
    }
    desk.refused(&["lessons", "handout", "light", "--out", "s.md"]);
    let left = fs::read_dir(desk.path(".")).expect("a folder").count();
    assert_eq!(left, 2, "the folders alone");
}

#[test]
fn no_title_of_a_table_is_a_formula_and_each_comes_back() {
    let desk = Desk::new();
    let titles = ["=cmd|' /C calc'!A0", "@sum", "+lamp", "-lamp"];
    let rows = rows(|_| 1.0).replace(",1\n", ",1,2,3,4\n");
    desk.put("odd.csv", format!("nm,{}\n{rows}", titles.join(",")));
    desk.done(&["convert", "odd.csv", "all.csv", "--all", "--kind", "light"]);
    let text = desk.get("all.csv");
    let head = text.lines().find(|line| line.starts_with("wavelength_nm"));
    for cell in head.expect("a head").split(',') {
        assert!(
            !cell
                .trim_start_matches('"')
                .starts_with(['=', '+', '-', '@']),
            "{text}"
        );
    }
    let again = desk.done(&["read", "all.csv", "--json"]);
    let again: Value = serde_json::from_str(&again.out).expect("JSON");
    for (spectrum, title) in again[0]["spectra"]
        .as_array()
        .expect("spectra")
        .iter()
        .zip(titles)
    {
        assert_eq!(spectrum["name"], title);
    }
}

#[test]
fn refusals_say_what_was_meant_to_be_given() {
    let desk = Desk::new();
    let long = format!("nm,W\n380,{0}\n400,{0}\n", "1".repeat(309));
    desk.put("long.csv", long);
    for (args, said) in [
        (
            &["recover", "--lab", "nan,0,0"][..],
            "expected L,A,B: three numbers",
        ),
        (
            &["recover", "--xyz", "1,2"],
            "expected X,Y,Z: three numbers",
        ),
        (
            &["plot", "FL2", "--out", "p.jpg"],
            "expected a file that ends in .svg or .png, with --sheet in .svg or .pdf",
        ),
        (&["light", "FL2", "--csv", "--full"], "--full"),
        (
            &["fit", "-", "--reference", "mean"],
            "--reference: found mean, which needs all spectra",
        ),
    ] {
        let line = desk.refused(args);
        assert!(line.contains(said), "{line}");
    }
    let deep = "[".repeat(100_000);
    desk.put("deep.json", deep);
    let line = desk.refused(&["read", "deep.json"]);
    assert!(
        line.contains("JSON of more than 127 lists in one another"),
        "{line}"
    );
    for (args, option) in [
        (
            &["recover", "--colour", "#c08040", "--force"][..],
            "--force",
        ),
        (
            &[
                "plot",
                "FL2",
                "--out",
                "p.svg",
                "--plain",
                "--observer",
                "1964",
            ],
            "--observer",
        ),
    ] {
        let told = desk.done(args);
        assert!(
            told.err.contains(&format!("{option} is not used: ")),
            "{}",
            told.err
        );
    }
}

#[test]
fn a_line_of_json_of_an_unknown_kind_or_unit_is_answered_by_why_and_an_empty_one_by_an_empty_one() {
    let desk = Desk::new();
    let nm: Vec<f64> = (0..=40).map(|i| 400.0 + 10.0 * f64::from(i)).collect();
    let um: Vec<f64> = nm.iter().map(|nm| nm / 1000.0).collect();
    let line = |nm: &[f64], more: &str| {
        format!(
            "{{\"nm\":{nm:?},\"values\":{:?}{more}}}\n",
            vec![1.0; nm.len()]
        )
    };
    let all = [
        line(&nm, ""),
        line(&nm, ",\"kind\":\"banana\""),
        "\n".to_owned(),
        line(&um, ""),
        line(&nm, ",\"kind\":\"light\""),
    ];
    desk.put("lines.jsonl", all.concat());
    let told = desk.run_on("lines.jsonl", &["fit", "-", "--numbers", "9"]);
    assert_eq!(told.code, 0, "{}", told.err);
    let lines: Vec<&str> = told.out.lines().collect();
    assert_eq!((lines.len(), lines[2]), (5, ""));
    assert!(lines[1].contains("expected light, reflectance or transmittance, found the kind"));
    assert!(
        lines[3].contains("expected some in nm (1 um is 1000 nm), found wavelengths up to 0.8")
    );
    assert_eq!(lines[0], lines[4]);
}
