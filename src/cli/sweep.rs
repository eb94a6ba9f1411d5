//! `sweep`: error against numbers, every order of all ways, as CSV or JSON.

use std::io::Write;

use super::{
    arguments::Sweep, inputs::Inputs, options::ModelOptions, print, refusal::Refusal, subject,
};
use crate::{
    app::{App, CURVE_ORDER, studies::SweepAsk, study_report},
    study::Progress,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or has nothing to measure.
pub(super) fn run(
    options: &Sweep,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Sweep {
        input,
        pick,
        model,
        json,
    } = options;
    let app = subject::app(input, pick, *model, inputs)?;
    say_unused(*model, &[], inputs);
    // A higher one makes the sweep go on.
    if let Some(order) = model.order.filter(|order| *order <= CURVE_ORDER) {
        inputs.note(format!(
            "--order {order} is not used: every order up to {CURVE_ORDER} is swept"
        ));
    }
    let ask = SweepAsk::of(app.document());
    let sweep = ask
        .answer(&Progress::default())
        .ok_or_else(|| all_zero(&app))?;
    if *json {
        let json = study_report::sweep_json(&app, &ask, &sweep);
        print(out, &format!("{json:#}\n"))
    } else {
        print(out, &study_report::sweep_csv(&app, &ask, &sweep))
    }
}

/// Says which of the given options change nothing here.
pub(super) fn say_unused(model: ModelOptions, more: &[(&str, bool)], inputs: &mut Inputs) {
    let more = more
        .iter()
        .filter(|(_, given)| *given)
        .map(|(word, _)| *word);
    for option in model.unused_in_studies().into_iter().chain(more) {
        inputs.note(format!("{option} is not used: it changes nothing here"));
    }
}

/// A spectrum that has nothing in the model's range.
pub(super) fn all_zero(app: &App) -> Refusal {
    let band = app.document().settings.band;
    Refusal::File(format!(
        "{}: found nothing but zeros from {} to {} nm, expected a spectrum to measure",
        app.document().subject_entry().name(),
        band.min_nm(),
        band.max_nm(),
    ))
}
