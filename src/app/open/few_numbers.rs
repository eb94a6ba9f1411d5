//! Pictures in few numbers, opened again: every pixel's numbers become bands, and the image is one
//! as any other.

use std::{path::Path, sync::Arc};

use super::{Loaded, kept_path};
use crate::{
    app::opened::Opened,
    io::{Choices, ReadError, Reading, disk},
    pictures::{CompactFile, Errors, Picture, PictureError, read_full},
    spectrum::{
        Cube, SpectralImage,
        cube::{Interleave, Layout, Number},
    },
    study::Progress,
};

/// The bytes that PNG and OpenEXR begin with.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
const EXR: &[u8] = b"\x76\x2f\x31\x01";
/// What only such a picture holds: a chunk of the one, an attribute of the other.
const CHUNK: &[u8] = b"csPH";
const ATTRIBUTE: &[u8] = b"compositePicture";
/// The attribute stands before the pixels.
const HEAD: usize = 1 << 16;
/// Most bytes of such a file, and most bytes that its bands may take.
const MOST_FILE: u64 = 1 << 30;
const MOST_BANDS: usize = 2 << 30;

fn holds(bytes: &[u8], word: &[u8]) -> bool {
    bytes.windows(word.len()).any(|some| some == word)
}

/// Whether bytes are such a picture, by what they hold.
fn is_picture(bytes: &[u8]) -> bool {
    if bytes.starts_with(EXR) {
        return holds(&bytes[..bytes.len().min(HEAD)], ATTRIBUTE);
    }
    bytes.starts_with(PNG) && holds(bytes, CHUNK)
}

/// Whether a file is a picture in few numbers, by what it holds.
pub(crate) fn is_few_numbers(path: &Path) -> bool {
    bytes_at(path).is_some_and(|bytes| is_picture(&bytes))
}

/// The bytes of a file that may be such a picture.
fn bytes_at(path: &Path) -> Option<Vec<u8>> {
    let head = disk::head(path, HEAD as u64);
    let may_be = head.starts_with(PNG) || is_picture(&head);
    if !may_be || disk::len(path).ok()? > MOST_FILE {
        return None;
    }
    disk::read(path).ok()
}

/// What the picture in few numbers at a path holds, as of any other file; `None` where there is
/// none.
pub fn reading_at(path: &Path) -> Option<Result<Reading, ReadError>> {
    let name = path.file_name()?.to_string_lossy().into_owned();
    reading_in(&name, &bytes_at(path)?)
}

/// What a picture in few numbers in memory holds, as of any other file; `None` where it is none.
pub fn reading_in(name: &str, bytes: &[u8]) -> Option<Result<Reading, ReadError>> {
    let (format, image) = decoded(name, bytes)?;
    Some(match image {
        Ok(image) => Ok(Reading {
            file: name.to_owned(),
            format,
            notes: image.notes.clone(),
            images: vec![image],
            ..Reading::default()
        }),
        Err(PictureError::Broken { found, expected }) => Err(ReadError::new(name, found, expected)),
        Err(why) => {
            let found = format!("a picture in few numbers ({why})");
            Err(ReadError::new(name, found, "one that can be decoded"))
        }
    })
}

/// The picture in few numbers that a file is, if it is one.
pub(super) fn at(path: &Path, choices: &Choices) -> Option<Loaded> {
    let bytes = bytes_at(path)?;
    let name = path.file_name()?.to_string_lossy().into_owned();
    let loaded = within(&name, &bytes, choices)?;
    Some(match loaded {
        Loaded::File(opened) => Loaded::File(Box::new(Opened {
            path: kept_path(path),
            bytes: None,
            ..*opened
        })),
        other => other,
    })
}

/// The picture in few numbers that a file in memory is, if it is one.
pub(super) fn within(name: &str, bytes: &[u8], choices: &Choices) -> Option<Loaded> {
    let (format, image) = decoded(name, bytes)?;
    Some(match image {
        Ok(image) => Loaded::File(Box::new(Opened {
            bytes: Some(Arc::from(bytes)),
            file: name.to_owned(),
            format,
            how: format!("{name}: {format}, {}", image.notes[0]),
            images: vec![Arc::new(image)],
            choices: choices.clone(),
            ..Opened::default()
        })),
        Err(why) => Loaded::Refused(format!("{name}: {why}")),
    })
}

/// The format and the image of a picture in few numbers; `None` for other bytes.
fn decoded(
    name: &str,
    bytes: &[u8],
) -> Option<(&'static str, Result<SpectralImage, PictureError>)> {
    if !is_picture(bytes) {
        return None;
    }
    let (format, picture) = if bytes.starts_with(PNG) {
        let file = CompactFile::open(bytes.to_vec());
        let picture = file.and_then(|file| file.picture(&Progress::default()));
        ("composite picture (PNG)", picture)
    } else {
        ("composite picture (OpenEXR)", read_full(bytes))
    };
    Some((format, picture.and_then(|picture| image(name, &picture))))
}

/// A picture with all of its bands.
fn image(name: &str, picture: &Picture) -> Result<SpectralImage, PictureError> {
    let header = &picture.header;
    let operator = header.operator()?;
    let (pixels, bands) = (picture.pixels(), header.bands_nm.len());
    let needs = pixels.saturating_mul(bands).saturating_mul(4);
    if needs > MOST_BANDS {
        return Err(PictureError::Memory {
            needs,
            most: MOST_BANDS,
        });
    }
    let mut values = vec![0.0; pixels * bands];
    operator
        .decoder()
        .apply(&picture.planes, pixels, &mut values);
    let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Bands,
        stored_bands: bands,
        missing: None,
    };
    let nm: Vec<(f64, usize)> = header.bands_nm.iter().copied().zip(0..).collect();
    let cube = Cube::new(header.width, header.height, &nm, layout, Arc::new(bytes));
    let cube = cube.map_err(|why| PictureError::Trouble(why.to_string()))?;
    let Errors {
        own, relative_rms, ..
    } = &header.error;
    Ok(SpectralImage {
        name: name
            .trim_end_matches(".png")
            .trim_end_matches(".cspx")
            .trim_end_matches(".exr")
            .to_owned(),
        kind: header.kind,
        unit: header.unit.clone(),
        scale: 1.0,
        bandwidth_nm: None,
        cube,
        notes: vec![format!(
            "{} numbers a pixel stand for {bands} bands; when it was written its own colours were \
             off by ΔE₀₀ {:.2} in 95 % of the pixels, its spectra by {:.1} % (rms).",
            header.numbers,
            own.p95,
            100.0 * relative_rms
        )],
        source: header.source.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::open::load_bytes,
        pictures::{
            About, Coder, Operator, Plan, Scene, Survey, compact_plan, white_y_of, write_compact,
        },
    };

    #[test]
    fn a_compact_picture_opens_as_an_image_with_all_of_its_bands() {
        let nm: Vec<f64> = (0..16).map(|i| 400.0 + 20.0 * f64::from(i)).collect();
        let wall = Scene::reflectance(24, 16, nm.clone()).expect("bands");
        let bands = crate::pictures::Pixels::bands(&wall);
        let progress = Progress::default();
        let survey = Survey::of(&wall, &progress).expect("pixels");
        let operator = Operator::new(bands, &Plan::new(bands, 8)).expect("solved");
        let white_y = white_y_of(&operator, &survey.sample);
        let plan = compact_plan(&wall, &operator, &survey.sample, 0.5, white_y, &progress);
        let plan = plan.expect("measured");
        let mut file = Vec::new();
        let about = About::default();
        write_compact(
            &mut file,
            &wall,
            &operator,
            &plan,
            &about,
            Coder::Fitted,
            &progress,
        )
        .expect("written");
        let Loaded::File(opened) = load_bytes("wall.cspx.png", &file) else {
            panic!("it is an image");
        };
        let image = &opened.images[0];
        assert_eq!((image.name.as_str(), image.cube.nm()), ("wall", &nm[..]));
        let (exact, back) = (wall.pixel(5, 7), image.cube.values_at(5, 7));
        let off = exact.iter().zip(&back).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) < 0.1, "{exact:?} {back:?}");
        // An editor that dropped the numbers leaves a picture of no spectra.
        let cut = file.windows(4).position(|some| some == CHUNK);
        let cut = cut.expect("the header's chunk") - 4;
        let Loaded::Refused(why) = load_bytes("wall.png", &file[..cut]) else {
            panic!("it is a picture alone");
        };
        assert!(why.contains("PNG"), "{why}");
    }
}
