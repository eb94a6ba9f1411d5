//! `light`: every figure of lights and of their models, in words, as JSON or as CSV.
//!
//! One light is told in words or as an object, several and a folder as a table or a list. Two
//! lights are compared in `against`.

use std::{
    io::Write,
    sync::{
        Arc,
        mpsc::{RecvTimeoutError, channel},
    },
    thread,
};

use serde_json::Value;

use super::{
    against,
    arguments::Light,
    asked_lights::{Asked, AskedLight, TOLD_EVERY},
    inputs::Inputs,
    options::ModelOptions,
    print,
    refusal::Refusal,
    repeats::{Scans, without_figures},
};
use crate::{
    app::{
        quality_report::{Modeller, Sheet, full_json, json, light_row, lights_table, text},
        readings::Reading,
    },
    study::{Progress, in_parallel, processors},
};

/// Carries the command out. An INPUT that is refused does not stop the others.
///
/// # Errors
/// [`Refusal`], after everything else was printed, when one of the INPUTs was refused.
pub(super) fn run(
    options: &Light,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Light {
        lights: words,
        files: _,
        model,
        json: as_json,
        csv,
        full,
        against,
        repeats,
        stated,
    } = options;
    if *repeats {
        return of_scans(options, out, inputs);
    }
    if let Some(other) = against {
        return against::run(options, other, out, inputs);
    }
    let asked = Asked::of("INPUT", words, *model, inputs);
    let is_one = words.len() == 1 && asked.lights.len() == 1 && !asked.has_folder;
    if !asked.lights.is_empty() {
        for asked in &asked.lights {
            asked.note_coarse(inputs);
        }
        let sheets = sheets(&asked.lights, *model, is_one, inputs);
        let readings: Vec<Reading> = asked
            .lights
            .iter()
            .map(|asked| Reading::of(&asked.of.light().spectrum, stated.as_light))
            .collect();
        let told_of: Vec<(&Sheet, &Reading)> = sheets.iter().zip(&readings).collect();
        let of_json = |(sheet, reading): &(&Sheet, &Reading)| {
            without_figures(sheet_json(sheet, *full), reading)
        };
        let told = match &told_of[..] {
            [one] if is_one && *as_json => format!("{:#}\n", of_json(one)),
            all if *as_json => {
                let list: Vec<Value> = all.iter().map(of_json).collect();
                format!("{:#}\n", Value::Array(list))
            }
            [(sheet, reading)] if is_one && !csv => {
                let said = reading.sentences().into_iter();
                let said: String = said.map(|line| format!("Note      {line}\n")).collect();
                match reading.has_no_figures() {
                    true => format!("{}\n{said}", sheet.name),
                    false => said + &text(sheet, &asked.lights[0].of.light().spectrum),
                }
            }
            all => {
                let rows = all
                    .iter()
                    .map(|(s, reading)| match reading.has_no_figures() {
                        true => (s.name.as_str(), Err(reading.sentences().join(" "))),
                        false => light_row(s),
                    });
                lights_table(rows).csv()
            }
        };
        print(out, &told)?;
    }
    if !asked.lights.is_empty() && !asked.refused.is_empty() {
        inputs.tell_notes();
    }
    inputs.tell_refused(asked.refused)
}

fn sheet_json(sheet: &Sheet, full: bool) -> Value {
    let of = if full { full_json } else { json };
    of(&sheet.name, &sheet.measured, Some(&sheet.model))
}

/// The figures of the mean of scans, each with its doubt.
fn of_scans(options: &Light, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let scans = Scans::of(options.lights.iter(), options.stated, inputs)?;
    let light = Arc::new(scans.entry.clone());
    let modeller = Modeller::new(light.clone(), options.model.settings());
    let sheet = modeller.sheet(light.name().to_owned(), &modeller.document(light.clone()));
    if options.json {
        let told = scans.json(sheet_json(&sheet, options.full));
        return print(out, &format!("{told:#}\n"));
    }
    let own = match scans.found.reading.has_no_figures() {
        true => format!("{}\n", sheet.name),
        false => text(&sheet, &light.spectrum),
    };
    print(out, &(own + &scans.words()))
}

/// The figures of all, those of several on all processors.
fn sheets(
    lights: &[AskedLight],
    model: ModelOptions,
    is_one: bool,
    inputs: &mut Inputs,
) -> Vec<Sheet> {
    let Some(first) = lights.first() else {
        return Vec::new();
    };
    let settings = model.settings();
    let modeller = Modeller::new(first.of.light().clone(), settings);
    let make = |asked: &AskedLight| {
        let [alone, among_others] = asked.names.clone();
        let name = if is_one { alone } else { among_others };
        asked.sheet(name, &modeller)
    };
    if is_one {
        return vec![make(first)];
    }
    let progress = Progress::default();
    progress.expect(lights.len());
    let told = || format!("{:.0} % of the figures", 100.0 * progress.share());
    let work = || in_parallel(lights, processors(), &progress, make);
    // Nobody cancels it.
    watched(told, inputs, work).unwrap_or_default()
}

/// Does some work and tells how far it is meanwhile.
fn watched<R: Send>(
    told: impl Fn() -> String,
    inputs: &mut Inputs,
    work: impl FnOnce() -> R + Send,
) -> R {
    // A page of a browser has no second thread.
    if cfg!(target_arch = "wasm32") {
        return work();
    }
    let (sender, done) = channel::<()>();
    thread::scope(|scope| {
        let job = scope.spawn(move || {
            // Gone with the work, however that ends.
            let _sender = sender;
            work()
        });
        while done.recv_timeout(TOLD_EVERY) == Err(RecvTimeoutError::Timeout) {
            inputs.remark(&told());
        }
        job.join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}
