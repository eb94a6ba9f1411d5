//! The pixels of photographs, and the light of other pictures along a strip that is known.

use std::path::Path;

use super::Tones;
use crate::{
    io::{ColourPixels, Photo, read_photo},
    photographs::{
        Profile,
        picture::{Codes, Picture},
        strip::{self, Found, Strip},
    },
};

/// A photograph as the search for strips takes it.
pub(super) fn picture_of(photo: Photo, is_linear: bool) -> Result<Picture, String> {
    let codes = match photo.pixels {
        ColourPixels::Eight(codes) => Codes::Eight(codes),
        ColourPixels::Sixteen(codes) => Codes::Sixteen(codes),
    };
    let picture = Picture::new(photo.size, codes, photo.is_linear || is_linear);
    picture.ok_or_else(|| {
        said!("found too few pixels, expected those of the whole picture").to_owned()
    })
}

/// Where the light of another picture of the same size is read, and how.
#[derive(Clone, Copy)]
pub(super) struct Along<'s> {
    pub size: [usize; 2],
    pub strip: &'s Strip,
    pub is_linear: bool,
    pub tones: Tones,
}

/// The light along a strip of another picture, and the same with each of some other tones.
pub(super) fn of_strip(
    path: &Path,
    along: Along<'_>,
    others: &[Tones],
) -> Result<(Found, Vec<Profile>), String> {
    let photo = read_photo(path).map_err(|why| {
        tr!(
            "found {found}, expected {expected}",
            found = why.found,
            expected = why.expected
        )
    })?;
    let size = along.size;
    if photo.size != size {
        return Err(tr!(
            "found {width} x {height} px, expected {other_width} x {other_height}, as the other \
             picture has",
            width = photo.size[0],
            height = photo.size[1],
            other_width = size[0],
            other_height = size[1]
        ));
    }
    let mut picture = picture_of(photo, along.is_linear)?;
    picture.straighten_tones(along.tones);
    let found = strip::read_at(&picture, along.strip);
    let profiles = (others.iter())
        .map(|tones| {
            picture.straighten_tones(*tones);
            strip::again(&picture, &found)
        })
        .collect();
    Ok((found, profiles))
}
