//! A photograph read: its strip, its lines, its axis.

use std::path::Path;

use super::{
    Exposed, Exposure, LampChoice, Photograph, Said, Tones,
    along::{Along, picture_of},
    exposures::joined,
};
use crate::{
    io::{Exif, Photo, read_photo},
    photographs::{
        Lamp,
        axis::{Wanted, find, snapped, through_pins},
        hue::Hues,
        peaks::{Peaks, bright, dark},
        picture::Picture,
        strip::{self, ByHand, Found},
    },
};

/// Reads a photograph and finds its strip and its axis.
///
/// # Errors
/// What was found and what was expected, after the file's name.
pub fn read(path: &Path, said: &Said) -> Result<Photograph, String> {
    let photo = read_photo(path).map_err(|why| why.to_string())?;
    let name = crate::io::shown(path);
    let about = About::of(&photo, Some(path));
    picture_of(photo, said.is_linear)
        .and_then(|mut picture| of_picture(&name, &mut picture, about, said))
        .and_then(|found| found.pins_refused.clone().map_or(Ok(found), Err))
        .map_err(|why| format!("{name}: {why}"))
}

/// The same of a photograph that was read.
///
/// # Errors
/// What was found and what was expected.
pub fn of_photo(name: &str, photo: Photo, said: &Said) -> Result<Photograph, String> {
    let about = About::of(&photo, None);
    of_picture(name, &mut picture_of(photo, said.is_linear)?, about, said)
}

/// What is known of a picture beside its pixels.
pub(super) struct About<'p> {
    exif: Exif,
    notes: Vec<&'static str>,
    path: Option<&'p Path>,
}

impl<'p> About<'p> {
    pub(super) fn of(photo: &Photo, path: Option<&'p Path>) -> Self {
        Self {
            exif: photo.exif.clone(),
            notes: photo.notes.clone(),
            path,
        }
    }

    /// The time that it was exposed for, of those that are told.
    fn seconds(&self, exposures: &[Exposure]) -> Option<f64> {
        let path = self.path?;
        let whole = |path: &Path| path.canonicalize().ok();
        let is_it = |e: &&Exposure| e.path == path || whole(&e.path) == whole(path);
        exposures.iter().find(is_it).map(|e| e.seconds)
    }
}

/// The tones of the camera, as an instrument or several exposures tell them; columns that are
/// over-exposed are taken from a darker one.
fn exposed(
    picture: &mut Picture,
    found: &mut Found,
    about: &About<'_>,
    said: &Said,
    tones: Tones,
) -> Result<Option<Exposed>, String> {
    if said.exposures.is_empty() {
        return Ok(None);
    }
    let mut along = Along {
        size: picture.size(),
        strip: &found.strip.clone(),
        is_linear: said.is_linear,
        tones,
    };
    let is_learnt = said
        .instrument
        .as_ref()
        .is_some_and(|i| i.response.is_some());
    let (light_power, is_uneven) = if is_learnt {
        (tones.light_power, false)
    } else {
        Exposed::power(&said.exposures, along)?
    };
    along.tones.light_power = light_power;
    picture.straighten_tones(along.tones);
    found.profile = strip::again(picture, found);
    let joined = match about.seconds(&said.exposures) {
        Some(seconds) => joined(&mut found.profile, seconds, &said.exposures, along)?,
        None => Vec::new(),
    };
    Ok(Some(Exposed {
        light_power,
        joined,
        is_uneven,
    }))
}

pub(super) fn of_picture(
    name: &str,
    picture: &mut Picture,
    about: About<'_>,
    said: &Said,
) -> Result<Photograph, String> {
    let size = picture.size();
    let kept = said
        .instrument
        .as_ref()
        .map(|i| i.strip(size, said.yes))
        .transpose()?;
    let response = said.instrument.as_ref().and_then(|i| i.response.as_ref());
    let mut tones = response.map_or(Tones::STRAIGHT, |response| response.tones());
    picture.straighten_tones(tones);
    let mut found = match kept {
        Some(strip) => strip::read_at(picture, &strip),
        None => strip::find(picture, &said.strip).map_err(|why| why.to_string())?,
    };
    found.blue_is_right = said.falls.or(found.blue_is_right);
    let exposed = exposed(picture, &mut found, &about, said, tones)?;
    if let Some(exposed) = &exposed {
        tones.light_power = exposed.light_power;
    }
    let bright = bright(&found.profile);
    let dark = dark(&found.profile, &bright);
    let columns = found.profile.columns();
    let by_pins = !said.pins.is_empty() && !matches!(said.lamp, LampChoice::Is(_));
    let pinned = by_pins.then(|| through_pins(&said.pins, columns, &bright));
    let (pinned, mut pins_refused) = match pinned {
        Some(Err(why)) => (None, Some(why.to_string())),
        pinned => (pinned.and_then(Result::ok), None),
    };
    let wanted = match pinned {
        Some(_) => None,
        // Pins that make no axis leave it to the lines.
        None => wanted(said, columns, (&bright, dark.as_ref()), &mut pins_refused),
    };
    let answer = wanted.map(|wanted| find(columns, &bright, dark.as_ref(), &wanted));
    let instrument = said.instrument.as_ref().map(|instrument| {
        let hues = Hues::of(&found.profile, 1);
        instrument.applied(size, hues.as_ref(), answer.as_ref(), &bright)
    });
    Ok(Photograph {
        file: name.to_owned(),
        size,
        exif: about.exif,
        notes: about.notes,
        by_hand: said.strip != ByHand::default() || said.falls.is_some(),
        is_linear: said.is_linear,
        found,
        bright,
        dark,
        answer,
        pinned,
        pins: if pins_refused.is_none() {
            said.pins.clone()
        } else {
            Vec::new()
        },
        pins_refused,
        yes: said.yes,
        instrument,
        tones,
        exposed,
        through: None,
        figures: None,
    })
}

/// What is asked of the lines; `None` where nothing is.
fn wanted(
    said: &Said,
    columns: usize,
    (bright, dark): (&Peaks, Option<&Peaks>),
    refused: &mut Option<String>,
) -> Option<Wanted> {
    let lamp = match said.lamp {
        LampChoice::Nothing => return None,
        LampChoice::Auto => None,
        LampChoice::Is(lamp) => Some(lamp),
    };
    let peaks = dark
        .filter(|_| lamp.is_some_and(Lamp::is_dark))
        .unwrap_or(bright);
    let mut pins = Vec::new();
    if refused.is_none() {
        match snapped(&said.pins, columns, peaks) {
            Ok(snapped) => pins = snapped,
            Err(why) => *refused = Some(why.to_string()),
        }
    }
    Some(Wanted {
        lamp,
        pins,
        falls: said.falls,
    })
}
