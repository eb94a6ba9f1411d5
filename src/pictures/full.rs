//! The full form `NAME.exr`: OpenEXR with `R`, `G`, `B` for every viewer and the numbers as
//! channels `CS.000`, `CS.001`, ..., the header as the text attribute `compositePicture`.

use std::io::{Seek, Write};

use crate::color::Xyz;
use crate::io::{EXR_BLOCK_ROWS, ExrImage, ExrLayer, Precision, budget, write_exr_rows};
use crate::study::Progress;

use super::header::{About, Header};
use super::kernel::Kernel;
use super::measure::{Errors, Storage};
use super::preview::to_linear;
use super::survey::percentile;
use super::{Operator, Picture, PictureError, Pixels};

/// The attribute that holds the header.
const ATTRIBUTE: &str = "compositePicture";
/// Largest half.
const MOST_HALF: f64 = 65504.0;

/// Numbers kept as 16-bit floating point, divided by a scale before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half {
    /// Factor by which stored numbers are multiplied.
    pub scale: f64,
}

impl Half {
    /// The scale that brings a sample's numbers into range: 1 unless one would overflow, else the
    /// 99th percentile of the first number.
    pub fn of(sample: &[Vec<f64>]) -> Self {
        let largest = sample.iter().flatten().fold(0.0_f64, |m, z| m.max(z.abs()));
        // Pixels beside the sample may be ten times as strong.
        if 10.0 * largest < MOST_HALF || !largest.is_finite() {
            return Self { scale: 1.0 };
        }
        let mut firsts: Vec<f64> = sample.iter().map(|z| z[0].abs()).collect();
        let high = percentile(&mut firsts, 0.99);
        Self {
            scale: if high > 0.0 { high } else { largest },
        }
    }

    /// The number that is stored, before it is rounded to 16 bits.
    fn stored(self, number: f32) -> f32 {
        (f64::from(number) / self.scale).clamp(-MOST_HALF, MOST_HALF) as f32
    }

    fn back(scale: f64, stored: f32) -> f32 {
        (f64::from(stored) * scale) as f32
    }
}

impl Storage for Half {
    fn kept(&self, numbers: &mut [f32], _: usize) {
        for number in numbers {
            *number = Self::back(self.scale, Precision::Half.kept(self.stored(*number)));
        }
    }
}

/// Text with what is beyond ASCII written as JSON escapes: the format knows no other letters.
fn ascii(json: &str) -> String {
    let escaped = |unit: &u16| match u8::try_from(*unit) {
        Ok(letter) if letter.is_ascii() => char::from(letter).to_string(),
        _ => format!("\\u{unit:04x}"),
    };
    json.encode_utf16().map(|unit| escaped(&unit)).collect()
}

/// Names of the channels in their order, the numbers at `precision` and a preview beside them.
fn channels(numbers: usize, precision: Precision) -> Vec<(String, Precision)> {
    let colour = |name: &str| (name.to_owned(), Precision::Half);
    let number = |n| (format!("CS.{n:03}"), precision);
    let numbers = (0..numbers).map(number);
    let numbers = [colour("B")].into_iter().chain(numbers);
    numbers.chain([colour("G"), colour("R")]).collect()
}

/// Weights of the numbers for linear red, green and blue of the own colour, white = 1.
fn rgb_rows(operator: &Operator) -> [Vec<f64>; 3] {
    let own = operator.own_colour();
    let linear = to_linear(&own);
    let columns: Vec<[f64; 3]> = (0..operator.numbers())
        .map(|n| linear(Xyz::new(own.rows[0][n], own.rows[1][n], own.rows[2][n])))
        .collect();
    std::array::from_fn(|k| columns.iter().map(|c| c[k]).collect())
}

/// Writes the full form, a block of rows at a time.
///
/// # Errors
/// Those of the source and of the writer, and [`PictureError::Cancelled`].
pub fn write_full<W: Write + Seek>(
    out: W,
    pixels: &dyn Pixels,
    operator: &Operator,
    (precision, half): (Precision, Half),
    (about, error): (&About, Errors),
    progress: &Progress,
) -> Result<(), PictureError> {
    let (width, height) = pixels.size();
    let mut header = Header::of(operator, (width, height), about, error);
    if precision == Precision::Half {
        header.scale = half.scale;
    }
    let (encode, rgb) = (operator.encoder(), rgb_rows(operator));
    let rgb = Kernel::of_rows(&[&rgb[2], &rgb[1], &rgb[0]]);
    progress.expect(height.div_ceil(EXR_BLOCK_ROWS));
    write_exr_rows(
        out,
        [width, height],
        &channels(operator.numbers(), precision),
        Some((ATTRIBUTE, ascii(&header.to_json()))),
        |top, rows| {
            if progress.is_cancelled() {
                return Err(PictureError::Cancelled);
            }
            let count = width * rows;
            let mut values = vec![0.0; count * pixels.bands().len()];
            pixels.rows(top, rows, &mut values)?;
            let mut numbers = vec![0.0; encode.rows() * count];
            encode.apply(&values, count, &mut numbers);
            let mut colours = vec![0.0; 3 * count];
            rgb.apply(&numbers, count, &mut colours);
            for colour in &mut colours {
                *colour = colour.clamp(-MOST_HALF as f32, MOST_HALF as f32);
            }
            if precision == Precision::Half {
                numbers.iter_mut().for_each(|z| *z = half.stored(*z));
            }
            let (blue, others) = colours.split_at(count);
            progress.step();
            Ok([blue, &numbers, others].concat())
        },
    )
}

/// Opens the full form.
///
/// # Errors
/// [`PictureError::Broken`] with what is wrong, and [`PictureError::Memory`] for more than a file
/// of its size may take.
pub fn read_full(bytes: &[u8]) -> Result<Picture, PictureError> {
    let broken = |_| {
        PictureError::broken(
            said!("a broken OpenEXR image"),
            said!("one that can be decoded"),
        )
    };
    let image = ExrImage::open(bytes).map_err(broken)?;
    let [layer] = &image.layers[..] else {
        return Err(PictureError::broken(
            tr!("{layers} layers", layers = image.layers.len()),
            said!("one layer"),
        ));
    };
    let header = checked(layer)?;
    let pixels = header.width.saturating_mul(header.height);
    let needs = pixels
        .saturating_mul(layer.channels.len())
        .saturating_mul(8);
    let most = budget::of(bytes.len());
    if needs > most {
        return Err(PictureError::Memory { needs, most });
    }
    let number_of = |name: &str| name.strip_prefix("CS.")?.parse::<usize>().ok();
    let names = layer.channels.iter().map(|channel| &*channel.name);
    let number_of: Vec<Option<usize>> = names.map(number_of).collect();
    let mut planes = vec![0.0; pixels * header.numbers];
    let keep = |[_, channel]: [usize; 2], [x, y]: [usize; 2], numbers: &[f32]| {
        let at = number_of[channel].unwrap_or(0) * pixels + y * header.width + x;
        for (plane, number) in planes[at..].iter_mut().zip(numbers) {
            *plane = Half::back(header.scale, *number);
        }
    };
    let is_number = |_, channel: usize| number_of[channel].is_some();
    image.decode(is_number, keep).map_err(broken)?;
    // A single infinite number is no number; the pixel was not measured.
    for i in 0..pixels {
        if (0..header.numbers).any(|n| !planes[n * pixels + i].is_finite()) {
            (0..header.numbers).for_each(|n| planes[n * pixels + i] = f32::NAN);
        }
    }
    Picture::new(header, planes)
}

/// The composite picture's header, if the layer is as it says.
fn checked(layer: &ExrLayer) -> Result<Header, PictureError> {
    let text = layer.text(ATTRIBUTE).ok_or_else(|| {
        PictureError::broken(
            said!("an OpenEXR image without the attribute compositePicture"),
            said!("a composite picture"),
        )
    })?;
    let header = Header::from_json(text)?;
    if layer.is_deep || layer.size != (header.width, header.height) {
        let found = tr!(
            "{width} x {height} pixels",
            width = layer.size.0,
            height = layer.size.1
        );
        let expected = tr!(
            "the header's {width} x {height}",
            width = header.width,
            height = header.height
        );
        return Err(PictureError::broken(found, expected));
    }
    let mut names: Vec<&str> = layer.channels.iter().map(|c| &*c.name).collect();
    names.sort_unstable();
    let expected = channels(header.numbers, Precision::Half);
    if !expected.iter().map(|(name, _)| name).eq(names)
        || layer.channels.iter().any(|channel| !channel.is_full)
    {
        let found = tr!("{channels} channels", channels = layer.channels.len());
        let expected = format!("B, G, R and CS.000 to CS.{:03}", header.numbers - 1);
        return Err(PictureError::broken(found, expected));
    }
    let of_planes = |name: &str| name.starts_with("CS.");
    if (layer.channels.iter()).any(|channel| channel.is_whole && of_planes(&channel.name)) {
        return Err(PictureError::broken(
            said!("a channel of other numbers"),
            said!("half or float"),
        ));
    }
    Ok(header)
}
