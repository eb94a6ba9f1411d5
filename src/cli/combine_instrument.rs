//! The instrument and the known light that words of `combine instrument` mean.

use std::{
    ffi::{OsStr, OsString},
    path::Path,
};

use super::{
    arguments::{Combine, Stated},
    combine_inputs::read as read_light,
    inputs::Inputs,
    refusal::Refusal,
};
use crate::{
    app::{
        combining::{Act, Found, Part, known_of_words, learnt as learnt_of, measurements},
        instruments,
    },
    io::shown,
    measurements::{Known, Quantity},
};

/// The correction by the instrument in a file.
///
/// # Errors
/// [`Refusal`] for a file that is none.
pub(super) fn read(word: &OsString, inputs: &mut Inputs) -> Result<Act, Refusal> {
    let path = Path::new(word);
    let refused = |why: String| Refusal::File(format!("INSTRUMENT: {why}"));
    let text = inputs.text(path).map_err(refused)?;
    let named = |why: String| refused(format!("{}: {why}", shown(path)));
    let instrument = instruments::json_of(&text).map_err(named)?;
    Ok(Act::Corrected { instrument })
}

/// The light that words mean: a black body, daylight, or a table.
fn known(words: &OsStr, inputs: &mut Inputs) -> Result<Known, Refusal> {
    if let Some(known) = known_of_words(&words.to_string_lossy()) {
        return Ok(known);
    }
    let mut found = read_light(words, false, Stated::default(), inputs)?;
    let light = found.remove(0).of;
    match light.quantity {
        Quantity::Light => Ok(Known::Table(Box::new(light))),
        quantity => Err(Refusal::File(format!(
            "--known: found {quantity}, expected a light, \"black body 2856 K\" or \"daylight 6500 K\""
        ))),
    }
}

/// Learns an instrument from a reading of the known light.
///
/// # Errors
/// [`Refusal`] where the reading is too dark or the light is not known.
pub(super) fn learnt(
    parts: &[Part],
    options: &Combine,
    inputs: &mut Inputs,
) -> Result<Found, Refusal> {
    let words = options.known.clone().unwrap_or_default();
    let known = known(&words, inputs)?;
    let doubt = options.known_doubt.unwrap_or(0.0);
    let stem = options.out.as_deref().and_then(Path::file_stem);
    let name = stem.map(|stem| stem.to_string_lossy().into_owned());
    learnt_of(
        &measurements(parts),
        &known,
        &words.to_string_lossy(),
        doubt,
        name,
    )
    .map_err(Refusal::File)
}
