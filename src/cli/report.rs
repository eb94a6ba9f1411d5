//! `report`: the model of a spectrum, its error and its colour, in words or as JSON.

use std::io::Write;

use super::{arguments::Report, inputs::Inputs, print, print_json, refusal::Refusal, subject};
use crate::app::{
    open::{Wanted, named::Several},
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
        pick,
        model,
        json,
    } = options;
    let wanted = Wanted {
        several: Several::FirstAsNoted,
        ..pick.wanted()
    };
    let app = subject::app_of(input, pick, &wanted, *model, inputs)?;
    // Only a light has patches.
    if !app.document().is_about_light() {
        inputs.note_sampling(*model);
    }
    if *json {
        print_json(out, &report::json(&app))
    } else {
        print(out, &report::text(&app))
    }
}
