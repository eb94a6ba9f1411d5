//! `report`: the model of a spectrum, its error and its colour, in words or as JSON.

use std::io::Write;

use super::{
    arguments::Report,
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    repeats::{Scans, without_figures},
    subject,
};
use crate::app::{
    open::{Wanted, named::Several},
    readings::Reading,
    report,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read.
pub(super) fn run(
    options: &Report,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Report {
        input,
        scans,
        repeats,
        stated,
        pick,
        model,
        json,
    } = options;
    if *repeats {
        let words = std::iter::once(input).chain(scans);
        let scans = Scans::of(words, *stated, inputs)?;
        let app = subject::about_light(scans.entry.clone(), *model);
        return match json {
            true => print_json(out, &scans.json(report::json(&app))),
            false if scans.found.reading.has_no_figures() => {
                print(out, &format!("{}\n{}", scans.entry.name(), scans.words()))
            }
            false => print(out, &(report::text(&app) + &scans.words())),
        };
    }
    let wanted = Wanted {
        several: Several::FirstAsNoted,
        ..pick.wanted()
    };
    let app = subject::app_of(input, pick, &wanted, *model, inputs)?;
    // Only a light has patches.
    if !app.document().is_about_light() {
        inputs.note_sampling(*model);
    }
    let reading = Reading::of(&app.document().subject_entry().spectrum, stated.as_light);
    if *json {
        return print_json(out, &without_figures(report::json(&app), &reading));
    }
    let said = reading.sentences().into_iter();
    let said: String = said.map(|line| format!("Note      {line}\n")).collect();
    match reading.has_no_figures() {
        true => print(
            out,
            &format!("{}\n{said}", app.document().subject_entry().name()),
        ),
        false => print(out, &(report::text(&app) + &said)),
    }
}
