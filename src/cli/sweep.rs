//! `sweep`: error against numbers, every order of all ways, as CSV or JSON.

use std::io::Write;

use super::{
    arguments::Sweep,
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    subject::{self, no_power, with_power},
};
use crate::{
    app::{
        CURVE_ORDER,
        studies::{Question, SweepAsk},
        study_report,
    },
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
    with_power(&app)?;
    // A higher one makes the sweep go on.
    if let Some(order) = model.order.filter(|order| *order <= CURVE_ORDER) {
        inputs.note(format!(
            "--order {order} is not used: every order up to {CURVE_ORDER} is swept"
        ));
    }
    let ask = SweepAsk::of(app.document());
    let sweep = ask
        .answer(&Progress::default())
        .ok_or_else(|| no_power(&app))?;
    if *json {
        print_json(out, &study_report::sweep_json(&app, &ask, &sweep))
    } else {
        print(out, &study_report::sweep_table(&app, &ask, &sweep).csv())
    }
}
