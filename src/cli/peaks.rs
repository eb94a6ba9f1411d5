//! `peaks`: the lines of a spectrum's model, a line each.

use std::io::Write;

use super::{
    arguments::Peaks,
    inputs::Inputs,
    options::{ModelOptions, PickOptions},
    print,
    refusal::Refusal,
    subject,
};

/// # Errors
/// [`Refusal`] for an input that cannot be read.
pub(super) fn run(
    options: &Peaks,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let pick = PickOptions::default();
    let model = ModelOptions::default();
    let app = subject::app_of(&options.input, &pick, &pick.wanted(), model, inputs)?;
    let lines = app.derived().model.lines().iter();
    let rows = lines.map(|line| format!("{:.1} nm\n", line.at_nm));
    print(out, &rows.collect::<String>())
}
