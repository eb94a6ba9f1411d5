//! `read`: what files hold and how they were read.

use std::io::Write;

use serde_json::Value;

use super::{arguments::Read, inputs::Inputs, print, print_json, refusal::Refusal};
use crate::{
    app::{
        open::folders::{self, Listed},
        read_report,
    },
    io::{Choices, shown},
};

/// Carries the command out. A file that is refused does not stop the others.
///
/// # Errors
/// [`Refusal`], after everything was printed, when one of the files was refused or a folder could
/// not be listed.
pub(super) fn run(options: &Read, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let mut refused = Vec::new();
    let mut values = Vec::new();
    for Listed {
        label,
        path,
        refused: why,
        ..
    } in folders::every_file(&options.inputs)
    {
        // A folder that holds nothing or cannot be listed has no reading.
        if let Some(why) = why {
            let without_name = why.strip_prefix(&label);
            refused.push(without_name.map_or(why.clone(), |rest| shown(&path) + rest));
            continue;
        }
        let reading = inputs.reading(&path, &Choices::default());
        if let Err(refusal) = &reading {
            refused.push(refusal.to_string());
        }
        if options.json {
            values.push(read_report::json(&path, &reading));
        } else if reading.is_ok() {
            print(out, &read_report::text(&path, &reading))?;
        }
    }
    if options.json {
        print_json(out, &Value::Array(values))?;
    }
    inputs.tell_refused(refused)
}
