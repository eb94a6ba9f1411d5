//! `follow`: streams on the command line.

use std::{
    ffi::OsString,
    fs,
    io::{self, Write},
    net::{SocketAddr, TcpStream},
    path::Path,
    sync::mpsc::{Sender, channel},
    thread,
};

use serde_json::Value;
use spectral_explorer::{
    cli::{self, Outcome},
    preset,
    spectrum::Sampled,
};

fn words(args: &[&str]) -> Vec<OsString> {
    let words = [cli::PROGRAM, "follow"];
    words.iter().chain(args).map(OsString::from).collect()
}

/// What the command did: exit code, what it printed and what it said beside.
fn tell(args: &[&str]) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(words(args), None, &mut out, &mut err);
    let Outcome::Done(code) = outcome else {
        panic!("{outcome:?}");
    };
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (code, text(out), text(err))
}

#[track_caller]
fn said(args: &[&str]) -> (String, String) {
    let (code, out, err) = tell(args);
    assert_eq!(code, 0, "{err}");
    (out, err)
}

fn objects(out: &str) -> Vec<Value> {
    let lines = out.lines();
    lines
        .map(|line| serde_json::from_str(line).expect("an object a line"))
        .collect()
}

#[track_caller]
fn refused(code: u8, args: &[&str]) -> String {
    let (found, out, err) = tell(args);
    assert_eq!((found, out.as_str()), (code, ""), "{err}");
    err
}

fn lamp() -> &'static Sampled {
    preset::table("cie_fluorescent_1nm", "FL2").expect("a shipped lamp")
}

/// An object of the lamp, so many times as bright.
fn object(factor: f64, rest: &str) -> String {
    let values: Vec<f64> = lamp().values().iter().map(|v| v * factor).collect();
    let nm = lamp().nm();
    format!("{{\"wavelength_nm\":{nm:?},\"values\":{values:?}{rest}}}\n")
}

fn put(folder: &Path, name: &str, content: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    fs::write(&path, content).expect(name);
    path.to_str().expect("UTF-8").to_owned()
}

/// A recording of three frames, a second apart.
fn recording(folder: &Path) -> String {
    let frame = |i: u32| object(f64::from(i), &format!(",\"time_ms\":{}", 1000 * i));
    let frames: String = (1..=3).map(frame).collect();
    put(folder, "run.jsonl", frames)
}

#[test]
fn a_recording_is_stepped_and_its_figures_are_those_of_the_light() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = recording(folder.path());
    let args = [&run, "--replay", "step", "--json"];
    let (out, _) = said(
        &[
            &args[..],
            &["--figures", "cct,Y,x,y,ra,r9,rf,melanopic_der"],
        ]
        .concat(),
    );
    let frames = objects(&out);
    assert_eq!(frames.len(), 3);
    let mut of_light = Vec::new();
    let words = [cli::PROGRAM, "light", "FL2", "--json"].map(OsString::from);
    cli::run(words, None, &mut of_light, &mut Vec::new());
    let light: Value = serde_json::from_slice(&of_light).expect("JSON");
    for (index, frame) in frames.iter().enumerate() {
        assert_eq!(frame["frame"], index + 1);
        assert_eq!(frame["time_ms"], 1000.0 * (index + 1) as f64);
        let value = |key: &str| frame[key].as_f64().expect("a number");
        for key in ["cct", "ra", "rf", "melanopic_der"] {
            let exact = light[key].as_f64().expect("a number");
            // The same sums of values that are twice and three times as large.
            assert!((value(key) / exact - 1.0).abs() < 1e-12, "{key}");
        }
        for (key, place) in [("x", 0), ("y", 1)] {
            let exact = light["xy"][place].as_f64().expect("a number");
            assert!((value(key) - exact).abs() < 1e-12, "{key}");
        }
        assert!((value("r9") - light["r"][8].as_f64().expect("R9")).abs() < 1e-9);
        let first = frames[0]["Y"].as_f64().expect("a number");
        assert!((value("Y") / first - (index + 1) as f64).abs() < 1e-12);
    }
    let (out, _) = said(&[&run, "--replay", "1000000"]);
    let lines: Vec<&str> = out.lines().collect();
    assert!(lines[0].starts_with("0:00:01.0  CCT 4"), "{out}");
    assert_eq!(lines.len(), 3, "{out}");
}

#[test]
fn frames_are_recorded_as_they_came_and_the_recording_plays_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = recording(folder.path());
    let copy = folder.path().join("copy.jsonl");
    let copy = copy.to_str().expect("UTF-8");
    let tracks = folder.path().join("tracks.csv");
    let play = ["--replay", "step", "--json", "--average", "2"];
    let written = [
        "--record",
        copy,
        "--tracks",
        tracks.to_str().expect("UTF-8"),
    ];
    let (first, _) = said(&[&[&*run][..], &play, &written].concat());
    let (second, _) = said(&[&[copy][..], &play].concat());
    // The name is the file's.
    let strip = |out: &str| -> Vec<Value> {
        let mut frames = objects(out);
        for frame in &mut frames {
            frame["name"] = Value::Null;
        }
        frames
    };
    assert_eq!(strip(&first), strip(&second));
    let averaged: Vec<Value> = objects(&first)
        .iter()
        .map(|frame| frame["averaged"].clone())
        .collect();
    assert_eq!(averaged, [1, 2, 2]);
    // Mercury's lines stand in the lamp, and grow with it.
    let tracks = fs::read_to_string(tracks).expect("written");
    let head = tracks.lines().next().expect("a head");
    assert!(head.starts_with("time_s,y,cct,glow,line_"), "{head}");
    assert_eq!(tracks.lines().count(), 4);
    // Neither is replaced unasked, and never by itself.
    assert!(refused(1, &[&run, "--replay", "step", "--record", copy]).contains("--force"));
    let itself = refused(1, &[copy, "--replay", "step", "--record", copy, "--force"]);
    assert!(itself.contains("what is read"), "{itself}");
}

#[test]
fn the_moment_at_which_a_light_jumps_is_told_with_its_tracks() {
    let folder = tempfile::tempdir().expect("a folder");
    let frame = |i: u32| {
        // Half as bright again from 40 s on.
        let level = if i < 40 { 1.0 } else { 1.5 };
        let flicker = 1.0 + 0.002 * f64::from(i * 7 % 5);
        object(level * flicker, &format!(",\"time_ms\":{}", 1000 * i))
    };
    let text: String = (0..80).map(frame).collect();
    let run = put(folder.path(), "run.jsonl", text);
    let tracks = folder.path().join("tracks.csv");
    let tracks = tracks.to_str().expect("UTF-8");
    let (_, err) = said(&[&run, "--replay", "step", "--tracks", tracks]);
    let jumps: Vec<&str> = err
        .lines()
        .filter(|line| line.contains("a jump at"))
        .collect();
    assert_eq!(jumps.len(), 1, "{err}");
    // Half as bright again, less what the flicker takes of it.
    assert!(jumps[0].contains("0:00:40.0: level +49"), "{err}");
    let (_, err) = said(&[&run, "--replay", "step"]);
    assert!(!err.contains("a jump"), "{err}");
}

#[test]
fn dark_and_reference_come_first_and_end_with_the_exposure() {
    let folder = tempfile::tempdir().expect("a folder");
    let counts = |factor: f64, ms: u32| {
        object(
            factor,
            &format!(",\"integration_ms\":{ms},\"unit\":\"counts\""),
        )
    };
    // Two dark ones, two of the light, a sample of a quarter, another exposure.
    let frames = [
        (1.0, 10),
        (1.0, 10),
        (5.0, 10),
        (5.0, 10),
        (2.0, 10),
        (2.0, 20),
    ];
    let text: String = frames.map(|(factor, ms)| counts(factor, ms)).concat();
    let run = put(folder.path(), "run.jsonl", text);
    let args = [
        "--replay",
        "step",
        "--dark",
        "2",
        "--reference",
        "2",
        "--json",
    ];
    let (out, err) = said(&[&[&*run][..], &args].concat());
    let frames = objects(&out);
    assert_eq!(frames.len(), 2, "{err}");
    assert_eq!(frames[0]["quantity"], "transmittance");
    assert_eq!(frames[0]["cct"], Value::Null);
    assert_eq!(frames[1]["quantity"], "counts");
    assert!(
        frames[1]["notes"][0]
            .as_str()
            .expect("why")
            .contains("Counts, not light")
    );
    assert!(
        err.contains("Dark and reference dropped: the integration time changed"),
        "{err}"
    );
    let as_light = ["--replay", "step", "--as-light", "--count", "1", "--json"];
    let (out, _) = said(&[&[&*run][..], &as_light].concat());
    assert!(objects(&out)[0]["cct"].as_f64().is_some());
}

#[test]
fn an_instrument_gives_wavelengths_and_response_to_lines_that_have_none() {
    let folder = tempfile::tempdir().expect("a folder");
    // A spectrometer that sees half of every value.
    let rows: String = lamp()
        .nm()
        .iter()
        .zip(lamp().values())
        .map(|(nm, value)| format!("{nm},{}\n", 500.0 * value))
        .collect();
    let seen = put(folder.path(), "seen.csv", format!("nm,counts\n{rows}"));
    let instrument = folder.path().join("own.json");
    let instrument = instrument.to_str().expect("UTF-8");
    let learn = [
        "instrument",
        "learn",
        &seen,
        "--known",
        "FL2",
        "--out",
        instrument,
    ];
    let learn = [cli::PROGRAM, "combine"].into_iter().chain(learn);
    let learnt = cli::run(
        learn.map(OsString::from),
        None,
        &mut Vec::new(),
        &mut Vec::new(),
    );
    assert_eq!(learnt, Outcome::Done(0));
    let values: Vec<String> = lamp()
        .values()
        .iter()
        .map(|v| format!("{}", 1000.0 * v))
        .collect();
    let run = put(folder.path(), "run.txt", values.join(" ") + "\n");
    let alone = refused(1, &[&run, "--replay", "step"]);
    assert!(alone.contains("without wavelengths"), "{alone}");
    let args = [
        &run,
        "--replay",
        "step",
        "--instrument",
        instrument,
        "--json",
    ];
    let (out, err) = said(&args);
    let frame = &objects(&out)[0];
    assert_eq!(frame["quantity"], "radiant", "{err}");
    let cct = frame["cct"].as_f64().expect("a number");
    // What FL2 has, but for what is masked where it is dark.
    assert!((cct - 4225.0).abs() < 40.0, "{cct}");
}

/// Hands on what is written, as it comes.
struct Told(Sender<String>);

impl Write for Told {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let text = String::from_utf8_lossy(bytes).into_owned();
        let sent = self.0.send(text);
        sent.map_or(Err(io::ErrorKind::BrokenPipe.into()), |()| Ok(bytes.len()))
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn lines_come_over_tcp_and_a_producer_that_is_killed_ends_nothing() {
    let (heard, errors) = channel();
    let command = thread::spawn(move || {
        let args = ["--listen", "0", "--json", "--count", "2"];
        let mut out = Vec::new();
        let outcome = cli::run(words(&args), None, &mut out, &mut Told(heard));
        (outcome, String::from_utf8(out).expect("UTF-8"))
    });
    let mut said = String::new();
    let address: SocketAddr = loop {
        said += &errors.recv().expect("an address");
        let told = said.split_once("listening at ").map(|(_, rest)| rest);
        if let Some(address) = told.and_then(|rest| rest.split_once('\n')) {
            break address.0.parse().expect("an address");
        }
    };
    assert!(address.ip().is_loopback(), "{address}");
    for factor in [1.0, 2.0] {
        let mut producer = TcpStream::connect(address).expect("connected");
        let whole = object(factor, "");
        let half = &whole[..whole.len() / 2];
        producer
            .write_all(format!("{whole}no numbers\n{half}").as_bytes())
            .expect("sent");
    }
    let (outcome, out) = command.join().expect("no panic");
    assert_eq!(outcome, Outcome::Done(0));
    let frames = objects(&out);
    assert_eq!(frames.len(), 2);
    let y = |frame: &Value| frame["Y"].as_f64().expect("a number");
    assert!((y(&frames[1]) / y(&frames[0]) - 2.0).abs() < 1e-12);
    // The line without numbers, half a line of the one that is gone, and perhaps the next line.
    let broken = frames[1]["broken"].as_u64();
    assert!(matches!(broken, Some(2 | 3)), "{broken:?}");
    said.extend(errors);
    assert!(said.contains("the last spectrum stays"), "{said}");
    assert!(said.contains("2 broken lines were skipped") || said.contains("3 broken lines"));
}

#[test]
fn a_file_that_is_rewritten_is_told_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let meter = put(folder.path(), "meter.json", object(1.0, ""));
    let (heard, lines) = channel();
    let path = meter.clone();
    let command = thread::spawn(move || {
        let args = [&path, "--json", "--count", "2"];
        cli::run(words(&args), None, &mut Told(heard), &mut Vec::new())
    });
    let first = lines.recv().expect("a line");
    fs::write(&meter, object(2.0, "")).expect("written");
    let second = lines.recv().expect("a line");
    assert_eq!(command.join().expect("no panic"), Outcome::Done(0));
    let y = |line: &str| objects(line)[0]["Y"].as_f64().expect("a number");
    assert!((y(&second) / y(&first) - 2.0).abs() < 1e-12);
}

#[test]
fn what_cannot_be_followed_is_refused_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let missing = folder.path().join("none.csv");
    let missing = missing.to_str().expect("UTF-8");
    assert!(refused(1, &[missing]).contains("no such file"));
    assert!(refused(2, &[]).contains("SOURCE"));
    let everywhere = refused(2, &["--listen", "0.0.0.0:0"]);
    assert!(everywhere.contains("--listen-all"), "{everywhere}");
    assert!(refused(2, &["--listen", "anywhere"]).contains("a port"));
    assert!(refused(2, &[missing, "--listen-all"]).contains("--listen"));
    assert!(refused(2, &[missing, "--average", "65"]).contains("from 1 to 64"));
    let figure = refused(2, &[missing, "--figures", "cct,beauty"]);
    assert!(
        figure.contains("beauty") && figure.contains("melanopic_der"),
        "{figure}"
    );
    let broken = put(folder.path(), "broken.txt", "1,2,x\n".repeat(3));
    let (code, out, err) = tell(&[&broken, "--replay", "step"]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("3 broken lines were skipped"), "{err}");
    assert!(refused(2, &[missing, "--replay", "0"]).contains("step"));
}
