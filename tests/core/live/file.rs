//! A file that grows or is rewritten, looked at on a clock of the test's own.

use super::*;

const POINTS: usize = 81;

fn values(version: u64) -> Vec<f64> {
    let value = |i: usize| 0.5 + ((i as u64 * 7 + version * 13) % 101) as f64 / 128.0;
    (0..POINTS).map(value).collect()
}

fn csv(version: u64) -> String {
    let rows = values(version).into_iter().enumerate();
    let rows = rows.map(|(i, value)| format!("{},{value}\n", 380 + 5 * i));
    "nm,relative\n".to_owned() + &rows.collect::<String>()
}

fn object(version: u64) -> String {
    let nm: Vec<usize> = (0..POINTS).map(|i| 380 + 5 * i).collect();
    format!(
        "{{\"wavelength_nm\":{nm:?},\"values\":{:?}}}",
        values(version)
    )
}

/// Writes as if it were so many ms after the beginning.
fn put(path: &Path, text: &str, at_ms: u64) {
    fs::write(path, text).expect("written");
    let file = File::options().write(true).open(path).expect("there");
    let time = SystemTime::UNIX_EPOCH + Duration::from_millis(at_ms);
    file.set_modified(time).expect("set");
}

fn frames(source: &mut FileSource) -> Vec<Vec<f64>> {
    let mut found = Vec::new();
    while let Some(event) = source.pop() {
        if let Event::Frame(frame) = event {
            found.push(frame.samples.values().to_vec());
        }
    }
    found
}

/// Whole numbers below a bound, from a linear congruence.
fn numbers() -> impl FnMut(u64) -> u64 {
    let mut state = 1_u64;
    move |below| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    }
}

/// Rewrites a file at random moments, empty, half or whole, and looks at it every 100 ms.
fn rewritten(name: &str, text: fn(u64) -> String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    let mut source = FileSource::new(&path, &Choices::default());
    let mut random = numbers();
    put(&path, &text(0), 0);
    let (mut now_ms, mut shown) = (0, Vec::new());
    for version in 1..=1000_u64 {
        let until_ms = now_ms + random(1500);
        while now_ms < until_ms {
            source.look(1e-3 * now_ms as f64);
            shown.extend(
                frames(&mut source)
                    .into_iter()
                    .map(|found| (version, found)),
            );
            now_ms += 100;
        }
        let whole = text(version);
        let written = match random(4) {
            0 => "",
            1 => &whole[..random(whole.len() as u64) as usize],
            _ => &whole,
        };
        put(&path, written, now_ms);
    }
    put(&path, &text(1001), now_ms);
    for step in 1..=3 {
        source.look(1e-3 * (now_ms + 100 * step) as f64);
    }
    let last = frames(&mut source).pop();
    assert_eq!(last, Some(values(1001)), "{name}");
    // Half of them are whole, and most of these rest for long enough.
    assert!(shown.len() > 300, "{name}: {}", shown.len());
    for (version, found) in shown {
        // The last whole one: it was written in one of the steps before.
        assert!(
            (0..version).rev().take(20).any(|v| values(v) == found),
            "{name} {version}"
        );
    }
    assert_eq!(source.broken().count, 0, "{name}");
}

#[test]
fn a_file_that_is_rewritten_a_thousand_times_never_shows_a_wrong_spectrum() {
    rewritten("meter.csv", csv);
}

#[test]
fn neither_does_one_of_objects_in_a_line() {
    rewritten("meter.json", object);
}

#[test]
fn a_file_that_grows_tells_each_line_once_and_in_its_order() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("log.jsonl");
    let lines: Vec<String> = (0..40).map(|version| object(version) + "\n").collect();
    let text = lines.concat();
    let mut source = FileSource::new(&path, &Choices::default());
    let (mut random, mut at, mut shown) = (numbers(), 0, Vec::new());
    let mut step = 0;
    while at < text.len() {
        at = (at + random(3000) as usize).min(text.len());
        put(&path, &text[..at], 100 * step);
        source.look(0.1 * step as f64);
        source.look(0.1 * step as f64 + 0.15);
        shown.extend(frames(&mut source));
        step += 2;
    }
    source.look(0.1 * step as f64 + 1.0);
    shown.extend(frames(&mut source));
    let all: Vec<Vec<f64>> = (0..40).map(values).collect();
    assert_eq!(shown, all);
    assert_eq!(source.broken().count, 0);
}

#[test]
fn rows_that_join_a_table_are_frames_and_the_choices_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wide.csv");
    let row = |cells: &[f64]| {
        let cells: Vec<String> = cells.iter().map(f64::to_string).collect();
        cells.join(";") + "\n"
    };
    let columns = |versions: std::ops::Range<u64>| {
        let all: Vec<Vec<f64>> = versions.clone().map(values).collect();
        let head: Vec<String> = versions.map(|v| format!("scan {v}")).collect();
        let rows = (0..POINTS).map(|i| {
            let own = all.iter().map(|values| values[i]);
            let cells: Vec<f64> = std::iter::once((380 + 5 * i) as f64).chain(own).collect();
            row(&cells)
        });
        format!("nm;{}\n{}", head.join(";"), rows.collect::<String>())
    };
    let mut source = FileSource::new(&path, &Choices::default());
    put(&path, &columns(0..2), 0);
    source.look(0.0);
    assert_eq!(frames(&mut source), [values(1)]);
    put(&path, &columns(0..4), 1000);
    source.look(1.0);
    source.look(1.2);
    assert_eq!(frames(&mut source), [values(2), values(3)]);
    // Nothing more is said of a file that rests.
    source.look(9.0);
    assert_eq!(source.pop(), None);
    // The wavelengths counted in another unit, as a person has decided, at each reading.
    let choices = Choices {
        wavelengths: Some(crate::io::WavelengthUnit::PerCentimetre),
        ..Choices::default()
    };
    let mut source = FileSource::new(&path, &choices);
    for step in 0..2 {
        put(&path, &columns(0..1), 1000 * step);
        source.look(step as f64);
        source.look(step as f64 + 0.2);
        let Some(Event::Frame(frame)) = source.pop() else {
            panic!("no frame");
        };
        assert!((frame.samples.last_nm() / (1e7 / 380.0) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_file_that_goes_away_is_told_once_and_its_spectrum_stays() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("meter.csv");
    let mut source = FileSource::new(&path, &Choices::default());
    put(&path, &csv(1), 0);
    source.look(0.0);
    assert_eq!(frames(&mut source), [values(1)]);
    fs::remove_file(&path).expect("gone");
    source.look(0.1);
    source.look(0.2);
    let Some(Event::Said(words)) = source.pop() else {
        panic!("nothing said");
    };
    assert!(
        words.contains("waiting") && words.contains("stays"),
        "{words}"
    );
    assert_eq!(source.pop(), None);
}
