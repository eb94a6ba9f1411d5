//! `auction`: what to buy with the next numbers, as CSV or JSON.

use std::io::Write;

use super::{
    arguments::Auction,
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    subject::{self, no_power, with_power},
};
use crate::{
    app::{
        App,
        studies::{AuctionAsk, Question},
        study_report,
    },
    study::{Goal, Progress},
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or has nothing to measure, and for a goal that it
/// does not have.
pub(super) fn run(
    options: &Auction,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Auction {
        input,
        goal,
        numbers,
        pick,
        model,
        json,
    } = options;
    let app = subject::app(input, pick, *model, inputs)?;
    with_power(&app)?;
    for_lights_only(&app, *goal)?;
    let ask = AuctionAsk::of(app.document(), *goal, *numbers);
    let auction = ask
        .answer(&Progress::default())
        .ok_or_else(|| nothing_to_measure(&app, &ask))?;
    if *json {
        print_json(out, &study_report::auction_json(&app, &ask, &auction))
    } else {
        print(
            out,
            &study_report::auction_table(&app, &ask, &auction).csv(),
        )
    }
}

/// A reflectance has no patches and no filters of its own.
fn for_lights_only(app: &App, goal: Goal) -> Result<(), Refusal> {
    let Goal {
        own: _,
        patches,
        spectrum: _,
        filters,
    } = goal;
    let asked = match (patches > 0.0, filters > 0.0) {
        (true, true) => "patches and filters",
        (true, false) => "patches",
        (false, true) => "filters",
        (false, false) => return Ok(()),
    };
    if app.document().is_about_light() {
        return Ok(());
    }
    let subject = app.document().subject_entry();
    Err(Refusal::Usage(format!(
        "--goal: found {asked} for the {} {}, expected own or spectrum (only a light has patches \
         and filters)",
        subject.kind(),
        subject.name(),
    )))
}

fn nothing_to_measure(app: &App, ask: &AuctionAsk) -> Refusal {
    let values = ask.about.subject.0.on_band(ask.about.band);
    if values.iter().all(|v| *v == 0.0) {
        return no_power(app);
    }
    let band = ask.about.band;
    Refusal::File(format!(
        "{}: found no colour from {} to {} nm, expected visible light for the goal {} (or --goal \
         spectrum)",
        app.document().subject_entry().name(),
        band.min_nm(),
        band.max_nm(),
        ask.terms.goal.words(),
    ))
}
