//! Golden pictures: generated ones whose wavelengths are known.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::{LampChoice, Photograph, Said, Source, json, of_photo, read};
use crate::{io::photo_of, photographs::Lamp};

#[derive(Deserialize)]
struct File {
    pictures: Vec<Golden>,
}

#[derive(Deserialize)]
struct Golden {
    file: String,
    kind: String,
    lamp: Option<String>,
    #[serde(default)]
    points: Vec<[f64; 3]>,
    #[serde(default)]
    vertical: bool,
    #[serde(default)]
    tilt_deg: f64,
    #[serde(default)]
    shear: f64,
    #[serde(default)]
    smile: f64,
}

fn folder() -> PathBuf {
    match std::env::var("PHOTOGRAPHS") {
        Ok(folder) => folder.into(),
        _ => Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/photographs"),
    }
}

fn golden() -> Vec<Golden> {
    let text = std::fs::read_to_string(folder().join("pictures.json")).expect("golden pictures");
    serde_json::from_str::<File>(&text)
        .expect("golden pictures")
        .pictures
}

fn off(golden: &Golden, photograph: &Photograph) -> Vec<(f64, f64)> {
    let Some(curve) = photograph.curve() else {
        return Vec::new();
    };
    let points = golden.points.iter();
    points
        .map(|[nm, x, y]| {
            (
                *nm,
                curve.nm(photograph.found.strip.column_of(*x, *y).0) - nm,
            )
        })
        .collect()
}

#[test]
fn pictures() {
    let mut sums = [0; 3];
    for golden in golden() {
        let path = folder().join(&golden.file);
        let begun = std::time::Instant::now();
        let read = match read(&path, &Said::default()) {
            Ok(read) => read,
            Err(why) => {
                println!("{} {}: {why}", golden.file, golden.kind);
                continue;
            }
        };
        let took = begun.elapsed().as_millis();
        let strip = read.found.strip;
        let valid = read.valid_nm().unwrap_or((0.0, 0.0));
        let all = off(&golden, &read);
        let inside: Vec<f64> = all
            .iter()
            .filter(|(nm, _)| (valid.0..=valid.1).contains(nm))
            .map(|o| o.1)
            .collect();
        let rms = (inside.iter().map(|o| o * o).sum::<f64>() / inside.len().max(1) as f64).sqrt();
        let worst = inside.iter().fold(0.0_f64, |w, o| w.max(o.abs()));
        println!(
            "{} {} {:?}: {} rms {rms:.2} worst {worst:.2} size {:?} vertical {} ({}) turn {:.2} ({:.2}) shear {:.4} ({:.4}) smile {:.6} ({:.6}) yc {:.0} half {:.0} x0 {:.0} n {} strips {} grey {} clip {} peaks {} width {:.1} sigma {:.5} black {} {took} ms",
            golden.file,
            golden.kind,
            golden.lamp,
            read.source().word(),
            read.size,
            strip.is_vertical,
            golden.vertical,
            strip.turn_deg,
            golden.tilt_deg,
            strip.shear,
            golden.shear,
            strip.smile,
            golden.smile,
            strip.centre_y,
            strip.half,
            strip.x0,
            strip.columns,
            read.found.strips,
            read.found.profile.is_grey,
            read.found.profile.clipped_columns(),
            read.bright.peaks.len(),
            read.bright.width_px,
            read.found.profile.sum_sigma(),
            read.found.profile.black_seen,
        );
        if let Some([_, x, y]) = golden.points.get(golden.points.len() / 2) {
            let (column, v) = strip.column_of(*x, *y);
            println!("   middle point at column {column:.0}, v {v:.1}");
        }
        println!("   {}", super::sentence(&read));
        if let Some(answer) = &read.answer {
            let best = answer
                .best
                .as_ref()
                .map(|b| (b.lamp.name(), b.score, answer.margin, b.matches.len()));
            println!(
                "   {best:?} other {:?} why {:?}",
                answer.runner_up.as_ref().map(|b| (b.lamp.name(), b.score)),
                answer.why
            );
        }
        sums[match read.source() {
            Source::Found => 0,
            Source::Suggested => 1,
            _ => 2,
        }] += 1;
        if let Some(lamp) = golden.lamp.as_deref().and_then(Lamp::named) {
            let said = Said {
                lamp: LampChoice::Is(lamp),
                ..Said::default()
            };
            if let Ok(told) = super::read(&path, &said) {
                let worst = off(&golden, &told)
                    .iter()
                    .filter(|(nm, _)| (420.0..=650.0).contains(nm))
                    .fold(0.0_f64, |w, o| w.max(o.1.abs()));
                println!(
                    "   TOLD {} worst {worst:.2} (420-650)",
                    told.source().word()
                );
            }
        }
        let _ = json(&read, &[]);
    }
    println!("SUM {sums:?}");
    let _ = (of_photo, photo_of);
}
