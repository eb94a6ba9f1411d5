//! Results computed by the instrument and written beside its spectrum: CCT, Ra, lux, PPFD, ...
//!
//! The program computes the same numbers from the spectrum; both can be shown side by side. A key
//! is known in the spellings of UPRtek, Sekonic, LI-COR, Argyll and their like: upper or lower
//! case where it does not matter (`X` and `x` differ), with or without a unit in brackets.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::io::text::number::{self, Cell};

pub(crate) const MOST_RESULTS: usize = 1000;

/// The number of further results allowed for a file that has given so many.
pub(crate) fn room_for(given: usize) -> usize {
    MOST_RESULTS.saturating_sub(given)
}

/// A number that the maker's software computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MakersResult {
    /// Index into [`Reading::spectra`](crate::io::Reading::spectra); `None` when the file has no
    /// spectrum that it belongs to.
    pub spectrum: Option<usize>,
    /// The computed quantity.
    pub quantity: Quantity,
    /// Its value, in `unit`.
    pub value: f64,
    /// Its unit as the file states it, else as the maker's manual does; empty for pure numbers.
    pub unit: String,
    /// Key and value as the file writes them: `Tcp [K] 3262`.
    pub as_written: String,
}

/// A quantity computed by an instrument.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Correlated colour temperature, K.
    Cct,
    /// Distance from the Planckian locus in CIE 1960 uv.
    Duv,
    /// General colour rendering index of CIE 13.3.
    Ra,
    /// Special colour rendering index `R1` to `R15`.
    R(u8),
    /// Colour fidelity of TM-30.
    Rf,
    /// Colour gamut of TM-30.
    Rg,
    /// Illuminance, lx.
    Illuminance,
    /// Luminance, cd m-2.
    Luminance,
    /// Irradiance, W m-2.
    Irradiance,
    /// Photosynthetic photon flux density, 400-700 nm, µmol m-2 s-1.
    Ppfd,
    /// Photon flux density over the whole range, µmol m-2 s-1.
    Pfd,
    /// Tristimulus value.
    TristimulusX,
    /// Tristimulus value.
    TristimulusY,
    /// Tristimulus value.
    TristimulusZ,
    /// Chromaticity x of CIE 1931.
    ChromaticityX,
    /// Chromaticity y of CIE 1931.
    ChromaticityY,
    /// Chromaticity u' of CIE 1976.
    UPrime,
    /// Chromaticity v' of CIE 1976.
    VPrime,
    /// Wavelength of the largest value, nm.
    PeakNm,
    /// Dominant wavelength, nm.
    DominantNm,
    /// Excitation purity, per cent.
    Purity,
    /// Anything else, in the maker's words.
    Other(String),
}

/// A quantity, its name, the unit in which makers give it when they state none, and its keys as
/// [`known`] has them, separated by blanks.
type Known = (Quantity, &'static str, &'static str, &'static str);

/// The quantities that have one name each.
static KNOWN: [Known; 20] = [
    (
        Quantity::Cct,
        "CCT",
        "K",
        "cct tcp colortemperature colourtemperature correlatedcolortemperature",
    ),
    (Quantity::Duv, "Duv", "", "duv dduv deltauv"),
    (Quantity::Ra, "Ra", "", "ra cri"),
    (Quantity::Rf, "Rf", "", "rf"),
    (Quantity::Rg, "Rg", "", "rg"),
    (
        Quantity::Illuminance,
        later!("illuminance"),
        "lx",
        "lux illuminance lx",
    ),
    (
        Quantity::Luminance,
        later!("luminance"),
        "cd m-2",
        "luminance lv",
    ),
    (
        Quantity::Irradiance,
        later!("irradiance"),
        "W m-2",
        "irr irradiance ee",
    ),
    (Quantity::Ppfd, "PPFD", "µmol m-2 s-1", "ppfd"),
    (Quantity::Pfd, "PFD", "µmol m-2 s-1", "pfd"),
    // One letter tells tristimulus values from chromaticities by its case alone.
    (Quantity::TristimulusX, "X", "", ""),
    (Quantity::TristimulusY, "Y", "", ""),
    (Quantity::TristimulusZ, "Z", "", ""),
    (Quantity::ChromaticityX, "x", "", "x"),
    (Quantity::ChromaticityY, "y", "", "y"),
    (Quantity::UPrime, "u'", "", "u'"),
    (Quantity::VPrime, "v'", "", "v'"),
    (
        Quantity::PeakNm,
        later!("peak wavelength"),
        "nm",
        "lambdap λp lp peakwavelength peak",
    ),
    (
        Quantity::DominantNm,
        later!("dominant wavelength"),
        "nm",
        "lambdad λd ld dominantwavelength dominant",
    ),
    (Quantity::Purity, later!("purity"), "%", "purity"),
];

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::R(number) => write!(f, "R{number}"),
            Self::Other(words) => f.write_str(words),
            known => f.write_str(known.known().map_or("", |known| known.1)),
        }
    }
}

impl Quantity {
    fn known(&self) -> Option<&'static Known> {
        KNOWN.iter().find(|known| known.0 == *self)
    }

    /// The unit in which makers give it when they do not say.
    pub(crate) fn usual_unit(&self) -> &'static str {
        self.known().map_or("", |known| known.2)
    }

    /// The quantity that a key names, and the unit in its brackets.
    pub fn of_key(key: &str) -> (Self, String) {
        let key = key.trim().trim_end_matches([':', '=']).trim();
        let (name, unit) = split_unit(key);
        // UPRtek writes the foot-candles of Sekonic's "Illuminance [fc]" so.
        if name == "fc" {
            return (Self::Other("Illuminance".to_owned()), "fc".to_owned());
        }
        // "Custom1(655~665nm)" and "Ratio1(Custom1:Custom2)" say what, not in which unit.
        let (name, unit) = match unit.contains(['~', ':']) {
            true => (key, ""),
            false => (name, unit),
        };
        let quantity = known(name).unwrap_or_else(|| Self::Other(name.to_owned()));
        let unit = match unit {
            "" => quantity.usual_unit(),
            unit => unit,
        };
        (quantity, unit.to_owned())
    }
}

/// `Tcp [K]` into `Tcp` and `K`; brackets at the end only.
fn split_unit(key: &str) -> (&str, &str) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some(body) = key.strip_suffix(close)
            && let Some(at) = body.rfind(open)
            && at > 0
        {
            return (key[..at].trim_end(), body[at + open.len_utf8()..].trim());
        }
    }
    (key, "")
}

fn known(name: &str) -> Option<Quantity> {
    let letter = name.strip_prefix("Tristimulus Value ").unwrap_or(name);
    if ["X", "Y", "Z"].contains(&letter) {
        let known = KNOWN.iter().find(|known| known.1 == letter);
        return known.map(|known| known.0.clone());
    }
    let plain: String = name
        .to_lowercase()
        .replace(['′', '’', '`', '´'], "'")
        .replace(['⊿', 'δ', '△', '∆'], "d")
        .split([' ', '_', '-', '.'])
        .collect();
    let standards = ["cie1931", "cie1976", "tm3015", "tm3018", "tm3020", "tm30"];
    let behind = standards.iter().find_map(|name| plain.strip_prefix(name));
    let behind_cri = || plain.strip_prefix("cri").filter(|rest| !rest.is_empty());
    let plain = behind.or_else(behind_cri).unwrap_or(&plain);
    let is_key = |known: &&Known| known.3.split_ascii_whitespace().any(|key| key == plain);
    if let Some(known) = KNOWN.iter().find(is_key) {
        return Some(known.0.clone());
    }
    let number = plain.strip_prefix('r')?.parse().ok()?;
    (1..=15).contains(&number).then_some(Quantity::R(number))
}

impl MakersResult {
    /// The result that a key and a value state, if the value is a number.
    ///
    /// A foot-candle is no lux: `Illuminance [fc]` stays in the maker's words.
    pub fn of(
        spectrum: Option<usize>,
        key: &str,
        value: &str,
        decimal_comma: bool,
    ) -> Option<Self> {
        let key = key.trim();
        let text = value.trim().trim_matches('"').trim();
        let (number, unit_behind) = number_and_unit(text, decimal_comma)?;
        let (mut quantity, mut unit) = Quantity::of_key(key);
        if !unit_behind.is_empty() {
            unit_behind.clone_into(&mut unit);
        }
        let is_lux = unit.eq_ignore_ascii_case("lx") || unit.eq_ignore_ascii_case("lux");
        if quantity == Quantity::Illuminance && !is_lux {
            quantity = Quantity::Other(split_unit(key).0.to_owned());
        }
        Some(Self {
            spectrum,
            quantity,
            value: number,
            unit,
            as_written: shortened(&format!("{key} {text}")),
        })
    }
}

/// A number with commas between its thousands: `1,234`, `12,345,678.9`.
fn with_commas(text: &str) -> Option<f64> {
    let (whole, _) = text.split_once('.').unwrap_or((text, ""));
    let fits = whole.contains(',') && number::is_grouped(whole, ',');
    fits.then(|| number::number(&text.replace(',', ""), false))?
}

/// `5528K`, `95.4`, `44632.4 Lux`: a number and what stands behind it.
fn number_and_unit(text: &str, decimal_comma: bool) -> Option<(f64, &str)> {
    match number::parse(text, decimal_comma) {
        Cell::Number(value) | Cell::Nanometres(value) => return Some((value, "")),
        Cell::Percent(value) => return Some((value, "%")),
        Cell::Empty | Cell::Gap => return None,
        Cell::Text | Cell::WithUnit(_) | Cell::Limit(_) => {}
    }
    if !decimal_comma && let Some(value) = with_commas(text) {
        return Some((value, ""));
    }
    let end = text.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+')))?;
    let value = number::number(&text[..end], decimal_comma).filter(|v| v.abs() < 1e30)?;
    let unit = text[end..].trim();
    (unit.chars().count() <= 16 && !unit.contains(|c: char| c.is_ascii_digit() || c == ':'))
        .then_some((value, unit))
}

fn shortened(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(80).collect()
}
