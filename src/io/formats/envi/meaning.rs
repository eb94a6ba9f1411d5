//! Interpretation of an ENVI file: wavelengths of the channels, kind and scale of the values.

use crate::spectrum::Kind;

use super::Header;
use crate::io::ReadError;
use crate::io::error::quoted;
use crate::io::formats::extent;
use crate::io::interpret::axis::{self, Axis};
use crate::io::interpret::factor_scale::{KnownScale, by_size, largest, or_large};
use crate::io::interpret::kinds;
use crate::io::interpret::raw::Known;
use crate::io::reading::decision::{AxisDecision, Decision, Origin};
use crate::io::reading::remark::{taken_as, unit_words};
use crate::io::text::units::WavelengthUnit;
use crate::languages::with_sign;

/// The channels to read and notes on their selection.
#[derive(Debug)]
pub struct Chosen {
    /// Wavelength (nm, strictly rising) and channel (from 0).
    pub bands: Vec<(f64, usize)>,
    /// The unit of the wavelengths, and a different unit named in the header.
    pub axis: AxisDecision,
    pub against: Option<String>,
    /// Notes on the selection, a sentence each.
    pub notes: Vec<String>,
}

/// The channels of a file without the bad ones; `chosen` is the unit chosen by the user.
///
/// # Errors
/// [`ReadError`] when the header gives no wavelengths for them.
pub fn channels(header: &Header, chosen: Option<WavelengthUnit>) -> Result<Chosen, ReadError> {
    let stored = header.channels;
    let axis = header.numbers("wavelength")?;
    if axis.len() != stored {
        let found =
            match axis.len() {
                0 => tr!("{n} channels without wavelengths"
                    | "{n} channels without wavelengths" % stored),
                count => tr!(
                    "{n} wavelengths for {channels} channels"
                        | "{n} wavelengths for {channels} channels" % count,
                    channels = stored
                ),
            };
        let expected = said!("\"wavelength = {...}\", one a channel");
        return Err(header.error("wavelength", found, expected));
    }
    let mut notes = Vec::new();
    let title = header.text("wavelength units").unwrap_or("");
    let word = title.to_lowercase();
    if chosen.is_none() && ["hz", "index"].iter().any(|other| word.contains(other)) {
        let expected = said!("nanometers, micrometers, angstroms or wavenumber");
        return Err(header.error("wavelength units", quoted(title), expected));
    }
    let (mut found, against) = match chosen {
        Some(unit) => (Decision::chosen(unit), None),
        None => axis::unit(&Axis {
            title,
            header: &[],
            says_nm: false,
            is_dpt: false,
            range: extent(&axis),
            unevenness: &|_| None,
        }),
    };
    let unit = found.value;
    if found.is_guess() {
        let words = unit_words(unit, against.as_deref());
        notes.push(taken_as(&words, &found.reason));
    } else if unit != WavelengthUnit::Nanometre {
        notes.push(tr!("wavelengths converted from {unit}", unit = unit.word()));
    }
    if found.origin == Origin::Stated {
        found.reason = format!("wavelength units = {title}");
    }
    let mut bands: Vec<(f64, usize)> = axis
        .iter()
        .enumerate()
        .map(|(channel, x)| (unit.to_nm(*x), channel))
        .collect();
    drop_bad(header, &mut bands, &mut notes)?;
    put_in_order(&mut bands, &mut notes);
    if bands.len() < 2 {
        let found = tr!("{n} good channels" | "{n} good channels" % bands.len());
        let expected = said!("at least 2 at different wavelengths above 0");
        return Err(header.error("wavelength", found, expected));
    }
    Ok(Chosen {
        bands,
        axis: AxisDecision::Unit(found),
        against,
        notes,
    })
}

/// Drops the channels that the bad bands list marks with 0.
fn drop_bad(
    header: &Header,
    bands: &mut Vec<(f64, usize)>,
    notes: &mut Vec<String>,
) -> Result<(), ReadError> {
    let good = header.numbers("bbl")?;
    if good.is_empty() {
        return Ok(());
    }
    if good.len() != bands.len() {
        let (entries, channels) = (good.len(), bands.len());
        notes.push(tr!(
            "the bad bands list has {n} entries for {channels} channels: passed over"
                | "the bad bands list has {n} entries for {channels} channels: passed over"
                    % entries,
            channels
        ));
        return Ok(());
    }
    let before = bands.len();
    bands.retain(|(_, channel)| good[*channel] != 0.0);
    let dropped = before - bands.len();
    if dropped > 0 {
        notes.push(tr!(
            "{n} bad band dropped" | "{n} bad bands dropped" % dropped
        ));
    }
    Ok(())
}

fn put_in_order(bands: &mut Vec<(f64, usize)>, notes: &mut Vec<String>) {
    let before = bands.len();
    bands.retain(|(nm, _)| nm.is_finite() && *nm > 0.0);
    if !bands.is_sorted_by(|a, b| a.0 <= b.0) {
        bands.sort_by(|a, b| a.0.total_cmp(&b.0));
        notes.push(said!("channels put in order of rising wavelength").to_owned());
    }
    bands.dedup_by(|later, earlier| later.0 == earlier.0);
    let dropped = before - bands.len();
    if dropped > 0 {
        let note = tr!("{n} channels of no or of a doubled wavelength dropped"
            | "{n} channels of no or of a doubled wavelength dropped" % dropped);
        notes.push(note);
    }
}

/// Scale factors that make sense; others are passed over.
const SENSIBLE_FACTORS: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// The median width of a band, nm: "fwhm" in the unit of the wavelengths, where these are so many
/// times nm; wave numbers are not.
pub(crate) fn bandwidth_nm(header: &Header, nm: &[f64], stored: &[usize]) -> Option<f64> {
    let written = header.numbers("wavelength").ok()?;
    let mut widths = header.numbers("fwhm").ok()?;
    let times = |at: usize| Some(nm.get(at)? / written.get(*stored.get(at)?)?);
    let (first, last) = (times(0)?, times(nm.len().checked_sub(1)?)?);
    if widths.is_empty() || (first / last - 1.0).abs() > 1e-6 {
        return None;
    }
    let middle = widths.len() / 2;
    Some(first * *widths.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// The kind, unit and scale of the values by the header, else by a sample of them, and notes on
/// them.
///
/// # Errors
/// [`ReadError`] if the scale factor is not a number.
pub fn values(
    header: &Header,
    data_name: &str,
    sample: &[f64],
) -> Result<(Known, Vec<String>), ReadError> {
    // The first title is the x axis's.
    let title = header.list("z plot titles");
    let title = title.get(1).copied().unwrap_or("");
    let stated = header.number("reflectance scale factor")?;
    let factor = stated.filter(|factor| SENSIBLE_FACTORS.contains(factor));
    let kind = kind_of_values(header, title, factor.is_some(), data_name, sample);
    let mut notes = Vec::new();
    if let (Some(odd), None) = (stated, factor) {
        let (least, most) = (SENSIBLE_FACTORS.start(), SENSIBLE_FACTORS.end());
        notes.push(tr!(
            "the header's reflectance scale factor of {factor} is not used: expected {least} to \
             {most}",
            factor = with_sign(odd.to_string()),
            least = with_sign(least.to_string()),
            most = with_sign(most.to_string())
        ));
    }
    let mut scale = KnownScale::Stated(1.0);
    if kind.value.is_factor() {
        scale = match factor.or_else(|| stated_factor(title)) {
            Some(factor) => {
                if factor != 1.0 {
                    notes.push(tr!(
                        "values divided by {factor}, as the header says",
                        factor = with_sign(factor.to_string())
                    ));
                }
                KnownScale::Stated(1.0 / factor)
            }
            None => KnownScale::Told(or_large(by_size(sample), true, sample)),
        };
    }
    if header.text("data gain values").is_some() || header.text("data offset values").is_some() {
        notes.push(said!("gains and offsets of the header are not applied").to_owned());
    }
    let known = Known {
        kind: Some(kind),
        unit: Some(header.text("data units").unwrap_or("").to_owned()),
        scale,
        may_be_large: true,
    };
    Ok((known, notes))
}

/// A note on data that extend beyond the size given by the header.
pub(crate) fn left_over(header: &Header, data_bytes: u64) -> Option<String> {
    let beyond = data_bytes.checked_sub(header.bytes()? as u64)?;
    (beyond > 0).then(|| {
        tr!(
            "the data are {n} bytes longer than the header says, which are left out"
                | "the data are {n} bytes longer than the header says, which are left out" % beyond
        )
    })
}

/// The kind of the values, by their title, the key that scales factors, the words of the header,
/// else by default.
fn kind_of_values(
    header: &Header,
    title: &str,
    has_factor: bool,
    data_name: &str,
    sample: &[f64],
) -> Decision<Kind> {
    if let Some(kind) = kinds::kind_of_title(title) {
        return Decision::of_format(kind);
    }
    let words: Vec<String> = ["data units", "description", "data values", "sensor type"]
        .iter()
        .filter_map(|key| header.text(key).map(str::to_lowercase))
        .collect();
    let lines: Vec<(usize, &str)> = words.iter().map(|w| (1, w.as_str())).collect();
    let found = kinds::kind(title, &kinds::FromHeader::of(&lines), data_name, sample);
    // Transmittances are scaled by the same key.
    if !found.is_guess() && (found.value.is_factor() || !has_factor) {
        return Decision::of_format(found.value);
    }
    if has_factor {
        return Decision::of_format(Kind::Reflectance);
    }
    // Radiances come as counts beyond 20 000 or with their unit; reflectances mostly as fractions or
    // times 10 000.
    if largest(sample) <= 20_000.0 {
        let because = said!("nothing states it; ENVI files mostly hold reflectances");
        return Decision::guessed(Kind::Reflectance, false, because);
    }
    Decision::guessed(found.value, false, said!("nothing states it"))
}

/// The divisor of the values in a title such as `reflectance [*10000]` or `reflectance (%)`.
fn stated_factor(title: &str) -> Option<f64> {
    if title.contains('%') {
        return Some(100.0);
    }
    let start = title.find(['*', '×']).or_else(|| title.find(" x "))?;
    let digits: String = title[start..]
        .chars()
        .skip_while(|c| !c.is_ascii_digit())
        .take_while(char::is_ascii_digit)
        .collect();
    let factor = digits.parse().ok();
    factor.filter(|factor| SENSIBLE_FACTORS.contains(factor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_may_stand_in_the_title() {
        assert_eq!(stated_factor("reflectance [*10000]"), Some(10_000.0));
        assert_eq!(stated_factor("Reflectance (%)"), Some(100.0));
        assert_eq!(stated_factor("Reflectance x 1000"), Some(1000.0));
        assert_eq!(stated_factor("Reflectance"), None);
    }
}
