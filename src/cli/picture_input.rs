//! What `picture` reads beside pixels: lights, and words of an error about the picture.

use std::{ffi::OsStr, path::Path};

use super::{inputs::Inputs, refusal::Refusal, subject};
use crate::{
    io::shown,
    pictures::{Illuminant, PictureError},
};

/// The word for the wall of paints, which needs no file.
pub(super) const WALL: &str = "wall";

/// Whether an input is the wall of paints and no file of that name.
pub(super) fn is_wall(path: &Path) -> bool {
    path == Path::new(WALL) && !path.exists()
}

/// A light by its name on the command line.
///
/// # Errors
/// [`Refusal::File`] for what cannot be read or is no light.
pub(super) fn light_of(
    what: &str,
    word: &OsStr,
    inputs: &mut Inputs,
) -> Result<Illuminant, Refusal> {
    let entry = subject::light(what, word, inputs)?;
    Ok(Illuminant::new(entry.name(), &entry.spectrum.samples))
}

/// Words of an error about an input; what was not saved names its own file.
pub(super) fn about(path: &Path) -> impl Fn(PictureError) -> Refusal + '_ {
    move |why| match why {
        PictureError::Unsaved(words) => Refusal::File(words),
        why => Refusal::File(format!("{}: {why}", shown(path))),
    }
}
