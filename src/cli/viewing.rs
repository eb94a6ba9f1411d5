//! The light that a colour is seen under, for commands that make spectra from colours.

use std::ffi::OsStr;

use super::{
    inputs::Inputs,
    refusal::Refusal,
    subject::{self, USUAL_LIGHT},
};
use crate::{app::Entry, color::Observer, design::recover::Viewing};

/// The observer that colours are meant for.
pub(super) const OBSERVER: Observer = Observer::CIE_1931;

/// A light that colours are recovered under.
///
/// # Errors
/// [`Refusal::File`] for what cannot be read and for a light that shows too few colours.
pub(super) fn light(
    name: Option<&OsStr>,
    what: &str,
    inputs: &mut Inputs,
) -> Result<(Entry, Viewing), Refusal> {
    let entry = subject::light(what, name.unwrap_or(USUAL_LIGHT.as_ref()), inputs)?;
    let viewing = Viewing::new(&entry.spectrum.samples, OBSERVER)
        .map_err(|why| Refusal::File(format!("{what}: {}: {why}", entry.name())))?;
    Ok((entry, viewing))
}
