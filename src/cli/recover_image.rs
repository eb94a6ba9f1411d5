//! `recover --image`: a spectral picture of a picture of colours.

use std::{io::Write, path::Path};

use super::{
    arguments::Recover,
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    target::{Replaces, Target},
    viewing::light,
};
use crate::{
    design::recover::{ColourPicture, Encoded, PictureCount, spectral_rows, usual_bands},
    io::{ColourPixels, ColourPng, many::many, reflectance_exr, shown},
    study::Progress,
};

/// Most numbers of a spectral picture: a GiB of single precision.
const MOST_NUMBERS: usize = 1 << 28;

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a picture or a light that cannot be read, and a file that cannot be written.
pub(super) fn run(
    options: &Recover,
    image: &Path,
    path: &Path,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let read = [Some(image.as_os_str()), options.light.as_deref()];
    let target = Target::out(path, Replaces::Nothing, options.force, &read);
    target.path()?;
    let (light, viewing) = light(options.light.as_deref(), "--light", inputs)?;
    let bands = usual_bands();
    let most = MOST_NUMBERS / bands.len();
    let ColourPng { size, pixels } = ColourPng::read(image, most)
        .map_err(|why| Refusal::File(format!("--image: {}: {why}", shown(image))))?;
    let [width, height] = size;
    let picture = ColourPicture {
        width,
        height,
        pixels: match &pixels {
            ColourPixels::Eight(bytes) => Encoded::U8(bytes),
            ColourPixels::Sixteen(words) => Encoded::U16(words),
        },
    };
    let mut planes = vec![Vec::with_capacity(width * height); bands.len()];
    let row = |_, values: &[f32]| {
        for pixel in values.chunks_exact(bands.len()) {
            for (plane, value) in planes.iter_mut().zip(pixel) {
                plane.push(*value);
            }
        }
    };
    let found = spectral_rows(picture, &viewing, &bands, &Progress::default(), row);
    let count = found.map_err(Refusal::usage)?;
    let PictureCount { pixels, impossible } = count.unwrap_or_default();
    let about = [("light", light.name().to_owned())];
    let file = reflectance_exr(size, &bands, planes, &about);
    let file = file.map_err(|why| Refusal::File(format!("{}: {why}", shown(path))))?;
    target.save(&file)?;
    if impossible > 0 {
        inputs.note(format!(
            "{} no surface has under {}: nearby ones were taken",
            many(
                impossible,
                "pixel has a colour that",
                "pixels have colours that"
            ),
            light.name()
        ));
    }
    if options.json {
        let json = serde_json::json!({
            "width": width,
            "height": height,
            "bands": bands.len(),
            "light": light.name(),
            "pixels": pixels,
            "impossible": impossible,
        });
        return print_json(out, &json);
    }
    print(
        out,
        &format!(
            "Wrote {}, {width} x {height} px, {} bands.\n",
            shown(path),
            bands.len()
        ),
    )
}
