//! Tables as people keep them, each with what a careful person would read. They lie outside the
//! project; where their folder is not there, the story says so and passes.

use std::fs;

use crate::root::root;
use serde_json::Value;
use spectral_explorer::io::{Reading, read_bytes};
use spectral_explorer::spectrum::NamedSpectrum;

/// What is wrong with a reading; nothing where it is right.
fn wrong(expected: &Value, reading: Result<Reading, String>) -> Result<(), String> {
    if expected["expected"] == "refuse" {
        return reading.map_or(Ok(()), |_| Err("read, and should be refused".to_owned()));
    }
    let may_be_refused = expected["may_be_refused"] == true;
    let reading = match reading {
        Ok(reading) => reading,
        Err(_) if may_be_refused => return Ok(()),
        Err(why) => return Err(format!("refused: {why}")),
    };
    let tolerance = expected["tolerance_of_peak"].as_f64().expect("a number");
    let all = expected["expected"].as_array().expect("a list of spectra");
    let optional = all.iter().filter(|one| one.is_null()).count();
    let mut left: Vec<&NamedSpectrum> = reading.spectra.iter().collect();
    for one in all.iter().filter(|one| !one.is_null()) {
        let fits: Vec<Result<(), String>> = left.iter().map(|s| is_as(one, s, tolerance)).collect();
        let Some(at) = fits.iter().position(Result::is_ok) else {
            return Err(format!("{fits:?}"));
        };
        left.remove(at);
    }
    if left.len() > optional && expected["other_columns_allowed"] != true {
        let names: Vec<&String> = left.iter().map(|s| &s.name).collect();
        return Err(format!("more than expected: {names:?}"));
    }
    Ok(())
}

/// Whether a spectrum has this kind and these values, every 20 nm from 380 nm on.
fn is_as(expected: &Value, found: &NamedSpectrum, tolerance: f64) -> Result<(), String> {
    let kinds = expected["kind"].as_str().expect("kinds");
    if !kinds.split('|').any(|kind| kind == found.kind.word()) {
        return Err(format!("{}, not {kinds}", found.kind));
    }
    let (nm, values) = (found.samples.nm().to_vec(), found.samples.values());
    let ends = (nm[0], nm[nm.len() - 1]);
    if ends.0 < 379.0 || ends.1 > 781.0 {
        return Err(format!("{ends:?} nm"));
    }
    let expected = expected["values"].as_array().expect("values");
    let numbers = || expected.iter().filter_map(Value::as_f64);
    let peak = numbers().fold(0.0, |peak: f64, value| peak.max(value.abs()));
    for (at, value) in (380..).step_by(20).map(f64::from).zip(expected) {
        let inside = at >= ends.0 - 1.0 && at <= ends.1 + 1.0;
        let Some(value) = value.as_f64().filter(|_| inside) else {
            continue;
        };
        let behind = nm.partition_point(|nm| *nm < at).clamp(1, nm.len() - 1);
        let [(a, y), (b, z)] = [behind - 1, behind].map(|i| (nm[i], values[i]));
        let here = y + (z - y) * ((at - a) / (b - a)).clamp(0.0, 1.0);
        if (here - value).abs() > tolerance * peak {
            return Err(format!("{here} at {at} nm, not {value}"));
        }
    }
    Ok(())
}

#[test]
fn plausible() {
    let folder = root().join("../shared/data/tables");
    let folder = match folder.is_dir() {
        true => folder,
        false => root().join("../../shared/data/tables"),
    };
    let Ok(index) = fs::read_to_string(folder.join("INDEX.json")) else {
        println!("skipped: {} is not there", folder.display());
        return;
    };
    let index: Value = serde_json::from_str(&index).expect("INDEX.json is JSON");
    let tables = index["tables"].as_array().expect("a list of tables");
    let told = |table: &Value| {
        let name = table["file"].as_str().expect("a file's name");
        let bytes = fs::read(folder.join(name)).expect("a table that INDEX.json names");
        let reading = read_bytes(name, &bytes).map_err(|why| why.to_string());
        wrong(table, reading)
            .err()
            .map(|why| format!("{name}: {why}"))
    };
    let wrong: Vec<String> = tables.iter().filter_map(told).collect();
    let count = wrong.len();
    assert!(
        wrong.is_empty(),
        "{count} of {}:\n{}",
        tables.len(),
        wrong.join("\n")
    );
}
