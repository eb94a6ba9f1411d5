//! `recover --image`: a spectral picture of a picture of colours.

use std::{fs::File, io::BufReader, io::Write, path::Path};

use super::{
    arguments::Recover,
    inputs::Inputs,
    print,
    refusal::Refusal,
    target::{Replaces, Target},
    viewing::light,
};
use crate::{
    design::recover::{ColourPicture, Encoded, PictureCount, spectral_rows, usual_bands},
    io::{atomic::save_atomically, error::shown, many::many, spectral_exr_write::reflectance_exr},
    study::Progress,
};

/// Most numbers of a spectral picture: a GiB of single precision.
const MOST_NUMBERS: usize = 1 << 28;

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a picture or a light that cannot be read, and a file that cannot be written.
pub fn run(
    options: &Recover,
    image: &Path,
    path: &Path,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let target = Target {
        what: "--out",
        path,
        replaces: Replaces::Nothing,
        force: options.force,
        read: Vec::new(),
    };
    let target = target.beside(&[Some(image.as_os_str()), options.light.as_deref()]);
    target.path()?;
    let (light, viewing) = light(options.light.as_deref(), "--light", inputs)?;
    let (size, pixels) =
        decoded(image).map_err(|why| Refusal::File(format!("--image: {}: {why}", shown(image))))?;
    let bands = usual_bands();
    let [width, height] = size;
    let picture = ColourPicture {
        width,
        height,
        pixels: match &pixels {
            Pixels::Eight(bytes) => Encoded::U8(bytes),
            Pixels::Sixteen(words) => Encoded::U16(words),
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
    let count = found.map_err(|why| Refusal::Usage(why.to_string()))?;
    let PictureCount { pixels, impossible } = count.unwrap_or_default();
    let about = [("light", light.name().to_owned())];
    let file = reflectance_exr(size, &bands, planes, &about);
    let file = file.map_err(|why| Refusal::File(format!("{}: {why}", shown(path))))?;
    save_atomically(target.path()?, &file).map_err(|why| Refusal::File(why.to_string()))?;
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
        return print(out, &format!("{json:#}\n"));
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

enum Pixels {
    Eight(Vec<u8>),
    Sixteen(Vec<u16>),
}

/// Width and height of a PNG and its colours; what shines through is dropped.
fn decoded(path: &Path) -> Result<([usize; 2], Pixels), String> {
    let file = File::open(path).map_err(|why| format!("found {}, expected a file", why.kind()))?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let refused = |why: png::DecodingError| format!("found {why}, expected a PNG picture");
    let mut reader = decoder.read_info().map_err(refused)?;
    let info = reader.info();
    let size = [info.width as usize, info.height as usize];
    let numbers = size[0].saturating_mul(size[1]);
    let numbers = numbers.saturating_mul(usual_bands().len());
    if numbers > MOST_NUMBERS {
        return Err(format!(
            "found {} x {} px, expected at most {} pixels",
            size[0],
            size[1],
            MOST_NUMBERS / usual_bands().len()
        ));
    }
    let bytes = reader.output_buffer_size();
    let bytes = bytes.ok_or("found a picture too large for memory, expected a smaller one")?;
    let mut data = vec![0; bytes];
    let frame = reader.next_frame(&mut data).map_err(refused)?;
    data.truncate(frame.buffer_size());
    let channels = frame.color_type.samples();
    let pixels = match frame.bit_depth {
        png::BitDepth::Sixteen => {
            let words = data
                .chunks_exact(2)
                .map(|two| u16::from_be_bytes([two[0], two[1]]));
            Pixels::Sixteen(coloured(&words.collect::<Vec<u16>>(), channels))
        }
        _ => Pixels::Eight(coloured(&data, channels)),
    };
    Ok((size, pixels))
}

/// Red, green and blue of pixels that have one, two, three or four channels.
fn coloured<T: Copy>(data: &[T], channels: usize) -> Vec<T> {
    let pixels = data.chunks_exact(channels.max(1));
    match channels {
        3 | 4 => pixels.flat_map(|p| [p[0], p[1], p[2]]).collect(),
        _ => pixels.flat_map(|p| [p[0]; 3]).collect(),
    }
}
