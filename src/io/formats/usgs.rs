//! USGS spectral library 7 (splib07): one number a line, the wavelengths in a file of their own.
//!
//! ```text
//!  splib07a Record=18377: Brick GDS355 Paving Dk Gry   ASDFRa AREF
//!  6.5847017e-002                 AREF absolute, RREF relative reflectance; -1.23e34 not measured
//! ```
//!
//! The wavelengths, in micrometres, lie in `splib07a_Wavelengths_ASD_0.35-2.5_microns_2151_ch.txt`
//! and its like: a file beside with "Wavelengths" and as many numbers is taken, by the
//! spectrometer's name where several do. Without one, 2151 channels of an ASD are 350 to 2500 nm
//! every nanometre; other counts are refused by the name of the file that is needed.

use std::path::Path;

use super::rows::{Rows, filled};
use super::{Confidence, Format, extent};
use crate::io::interpret::{RawSpectrum, alone};
use crate::io::text;
use crate::io::text::number::{self, Cell};
use crate::io::{Decision, Input, ReadError, Reading, WavelengthUnit, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new("USGS splib07", &["txt"], sniff, read);

/// Channels of an ASD, 350-2500 nm every nanometre.
const ASD_CHANNELS: usize = 2151;

/// Largest file beside that is examined, in bytes: wavelengths of a library take some 60 KB.
const LARGEST_BESIDE: u64 = 4 << 20;

/// Most files of a folder that are searched.
const MOST_BESIDE: usize = 20_000;

fn sniff(input: &Input) -> Confidence {
    let first = input.first_line().to_lowercase();
    let second = input.head().lines().nth(1).unwrap_or("").trim();
    let one_number = matches!(number::parse(second, false), Cell::Number(_) | Cell::Gap);
    // "splib07a Record=18377: ...", and libraries of other names made alike.
    Confidence::certain_if(first.contains(" record=") && first.contains(':') && one_number)
}

/// A title and the numbers below it, one a line.
fn list<'a>(name: &str, text: &'a str) -> Result<(&'a str, Rows), ReadError> {
    let mut content = filled(text);
    let title = content.next().map_or("", |(_, title)| title);
    let mut rows = Rows::default();
    for (line, content) in content {
        let value = number::parse(content, false).plain_value();
        let bad = || ReadError::new(name, quoted(content), said!("one number")).at_line(line);
        rows.add(line, &[value.ok_or_else(bad)?]);
    }
    Ok((title, rows))
}

/// Words for spectrometers in titles and file names: ASDFRa and ASDHRb are ASD.
const SPECTROMETERS: &str =
    "ASD BECK NIC4 AVIRIS HYMAP HYPERION VIMS CRISM ASTER LANDSAT SENTINEL WORLDVIEW";

/// The spectrometer's word in a title or file name, upper case.
fn spectrometer(title: &str) -> Option<&'static str> {
    let title = title.to_uppercase();
    let mut words = SPECTROMETERS.split(' ');
    words.find(|word| title.contains(word))
}

/// Wavelengths in nm of as many channels from a file beside, or in the folder above as the library
/// keeps them, and the file's name.
fn beside(path: &Path, channels: usize, title: &str) -> Option<(String, Vec<f64>)> {
    let mut folders = path.ancestors().skip(1).take(2);
    folders.find_map(|folder| in_folder(folder, channels, title))
}

fn in_folder(folder: &Path, channels: usize, title: &str) -> Option<(String, Vec<f64>)> {
    let wanted = spectrometer(title);
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .ok()?
        .take(MOST_BESIDE)
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.to_lowercase().contains("wavelength"))
        .collect();
    // The same spectrometer first, then by name.
    names.sort_by_key(|name| (spectrometer(name) != wanted, name.clone()));
    names.into_iter().take(100).find_map(|name| {
        let file = folder.join(&name);
        let about = std::fs::metadata(&file).ok()?;
        if !about.is_file() || about.len() > LARGEST_BESIDE {
            return None;
        }
        let bytes = std::fs::read(&file).ok()?;
        let text = text::decode(&bytes);
        let (title, mut rows) = list(&name, &text.text).ok()?;
        let numbers = rows.take(0);
        let (min, max) = extent(&numbers);
        let unit = WavelengthUnit::of_title(title)
            .or_else(|| WavelengthUnit::of_range(min, max))
            .unwrap_or(WavelengthUnit::Micrometre);
        let nm = || numbers.iter().map(|x| unit.to_nm(*x)).collect();
        (numbers.len() == channels).then(|| (name, nm()))
    })
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (whole, mut rows) = list(&input.name, text)?;
    let values = rows.take(0);
    let channels = values.len();
    // "splib07a Record=18377: Brick GDS355 ... ASDFRa AREF"
    let title = whole.split_once(':').map_or(whole, |t| t.1).trim();
    let lower = title.to_lowercase();
    let first = lower.split_whitespace().next().unwrap_or("");
    let of_axis = ["wavelength", "bandpass", "wavenumber"];
    if of_axis.iter().any(|word| first.starts_with(word)) {
        let found = tr!("a list of the library's {what}", what = first);
        let expected = said!("the spectrum that it belongs to; it is read from beside");
        return Err(input.error(found, expected));
    }
    let path = input.path.as_deref();
    let found = path.and_then(|path| beside(path, channels, title));
    let asd = spectrometer(title).is_none_or(|word| word == "ASD");
    let (nm, note) = match found {
        Some((file, nm)) => (nm, tr!("wavelengths from {file}", file)),
        None if channels == ASD_CHANNELS && asd => (
            (0..channels).map(|i| 350.0 + i as f64).collect(),
            tr!(
                "no wavelengths beside; {n} channels of an ASD are 350 to 2500 nm every nanometre"
                    | "no wavelengths beside; {n} channels of an ASD are 350 to 2500 nm every \
                       nanometre"
                        % channels
            ),
        ),
        None => {
            let found = tr!("{n} lines of one number each and no wavelengths beside"
                | "{n} lines of one number each and no wavelengths beside" % channels);
            let word = spectrometer(title);
            let file = format!(
                "splib07a_Wavelengths_{}..._{channels}_ch.txt",
                word.unwrap_or("")
            );
            let expected = match word {
                Some(instrument) => tr!(
                    "the library's file of wavelengths of {instrument} in the same folder ({file})",
                    instrument,
                    file
                ),
                None => tr!(
                    "the library's file of wavelengths of the spectrometer in the same folder \
                     ({file})",
                    file
                ),
            };
            return Err(input.error(found, expected));
        }
    };
    let mut words: Vec<&str> = title.split_whitespace().collect();
    let kind = match words[..] {
        [.., "TRAN"] => Decision::of_format(Kind::Transmittance),
        ["SRF", ..] => Decision::of_format(Kind::Weighting),
        [.., last] if last.ends_with("REF") => Decision::of_format(Kind::Reflectance),
        _ => {
            let because = said!("the library mostly holds reflectances");
            Decision::guessed(Kind::Reflectance, false, because)
        }
    };
    words.retain(|word| !word.ends_with("REF"));
    let name = words.join(" ");
    let mut spectrum = RawSpectrum::known(input.named(&name), &nm, values, kind, "");
    spectrum.lines = &rows.lines;
    spectrum.notes = vec![note.clone(), whole.to_owned()];
    let mut reading = alone(spectrum, input)?;
    reading.notes.push(note);
    Ok(reading)
}
