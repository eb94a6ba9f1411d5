//! Units of the wavelength axis: told by a header, else guessed from the range.

use serde::{Deserialize, Serialize};

use super::words::{holds_one, without_brackets};

/// The unit of a file's wavelength axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WavelengthUnit {
    /// Nanometres.
    Nanometre,
    /// Micrometres (microns).
    Micrometre,
    /// Ångström, a tenth of a nanometre.
    Angstrom,
    /// Wave numbers, one over centimetres.
    PerCentimetre,
    /// Photon energy, electronvolts.
    Electronvolt,
    /// Picometres.
    Picometre,
    /// Photon energy, thousandths of an electronvolt.
    Millielectronvolt,
    /// Frequency, 1e12 Hz.
    Terahertz,
    /// Frequency, 1e9 Hz.
    Gigahertz,
    /// Metres, as programs write that count in SI throughout.
    Metre,
}

/// Planck's constant times the speed of light in eV nm: 6.62607015e-34 x 299792458 /
/// 1.602176634e-19 x 1e9, all three exact in the SI of 2019.
const EV_NM: f64 = 6.626_070_15e-34 * 299_792_458.0 / 1.602_176_634e-19 * 1e9;

/// Speed of light in THz nm, exact in the SI.
const THZ_NM: f64 = 299_792.458;

impl WavelengthUnit {
    /// Every unit, the likeliest first.
    pub const ALL: [Self; 10] = [
        Self::Nanometre,
        Self::Micrometre,
        Self::Angstrom,
        Self::PerCentimetre,
        Self::Electronvolt,
        Self::Picometre,
        Self::Millielectronvolt,
        Self::Terahertz,
        Self::Gigahertz,
        Self::Metre,
    ];

    /// The unit's sign: `nm`, `um`, `Å`, `1/cm`, `eV`, `pm`, `meV`, `THz`, `GHz`, `m`.
    pub fn word(self) -> &'static str {
        let known = UNITS.iter().find(|(unit, ..)| *unit == self);
        known.map_or("", |(_, sign, _)| sign)
    }

    /// Wavelength in nm of a number in this unit.
    pub fn to_nm(self, x: f64) -> f64 {
        match self {
            Self::Nanometre => x,
            Self::Micrometre => x * 1000.0,
            Self::Angstrom => x / 10.0,
            Self::PerCentimetre => 1e7 / x,
            Self::Electronvolt => EV_NM / x,
            Self::Picometre => x / 1000.0,
            Self::Millielectronvolt => 1000.0 * EV_NM / x,
            Self::Terahertz => THZ_NM / x,
            Self::Gigahertz => 1000.0 * THZ_NM / x,
            Self::Metre => x * 1e9,
        }
    }

    /// The number in this unit of a wavelength in nm: what a file said before it was converted.
    pub fn of_nm(self, nm: f64) -> f64 {
        match self {
            Self::Nanometre => nm,
            Self::Micrometre => nm / 1000.0,
            Self::Angstrom => nm * 10.0,
            Self::Picometre => nm * 1000.0,
            Self::Metre => nm / 1e9,
            // One over the other either way.
            _ => self.to_nm(nm),
        }
    }

    /// True if the unit is one of length, not of a quantity that falls as wavelengths rise.
    pub fn is_length(self) -> bool {
        use WavelengthUnit::{Angstrom, Metre, Micrometre, Nanometre, Picometre};
        matches!(self, Nanometre | Micrometre | Angstrom | Picometre | Metre)
    }

    /// The unit that a title of the wavelength column names (`Wavelength (nm)`, `[um]`, `Å`), by
    /// whole words: an `å` in "våglängd" is none.
    pub(crate) fn of_title(title: &str) -> Option<Self> {
        let title = title.to_lowercase();
        let named = UNITS.iter().find(|(.., words)| holds_one(&title, words));
        named.map(|(unit, ..)| *unit)
    }

    /// The unit that a range of positive numbers suggests; `None` where no unit fits.
    ///
    /// 0.2-3 is micrometres and 200-3000 nanometres; libraries of minerals go on to 50 um and
    /// filters to 20 um, so the upper bounds are wider. All above 3000 is wave numbers.
    pub(crate) fn of_range(min: f64, max: f64) -> Option<Self> {
        if min >= 100.0 && (min <= 3000.0 && max <= 20_000.0) {
            Some(Self::Nanometre)
        } else if min > 3000.0 && max <= 100_000.0 {
            Some(Self::PerCentimetre)
        } else if min >= 0.1 && max <= 50.0 {
            Some(Self::Micrometre)
        } else {
            None
        }
    }
}

/// Wavelengths in metres that are plausible: 100 nm to 50 um.
const METRES: std::ops::RangeInclusive<f64> = 1e-7..=5e-5;

/// True if a range of numbers looks like wavelengths in metres. Hardly any other column of a table
/// does, but values of a faint light may: it counts for less than a match of
/// [`WavelengthUnit::of_range`].
pub(crate) fn looks_like_metres(min: f64, max: f64) -> bool {
    METRES.contains(&min) && METRES.contains(&max)
}

/// Signs of units, and words that name them, lower case, the surest first. A lone "pm" may be the
/// time of day, so it must stand where units stand.
static UNITS: [(WavelengthUnit, &str, &str); 10] = [
    (
        WavelengthUnit::PerCentimetre,
        "1/cm",
        "wavenumber;wave number;cm-1;cm^-1;cm⁻¹;|1/cm|;kayser",
    ),
    (
        WavelengthUnit::Nanometre,
        "nm",
        "nanomet;|nm|;|нм|;纳米;奈米;ナノメ",
    ),
    (
        WavelengthUnit::Micrometre,
        "um",
        "micromet;|micron|;|microns|;|µm|;|μm|;|um|;|мкм|",
    ),
    (
        WavelengthUnit::Angstrom,
        "Å",
        "|angstrom|;|angstroms|;|angstroem|;|ångstrom|;|ångström|;|ångströms|;|å|;(a);[a];(aa);\
         [aa];wavelength_a|;wavelength_aa|;lambda_a|",
    ),
    (WavelengthUnit::Millielectronvolt, "meV", "|mev|"),
    (WavelengthUnit::Electronvolt, "eV", "|ev|;electronvolt"),
    (
        WavelengthUnit::Picometre,
        "pm",
        "picomet;(pm);[pm];/ pm|;/pm|;_pm|",
    ),
    (WavelengthUnit::Terahertz, "THz", "|thz|;terahertz"),
    (WavelengthUnit::Gigahertz, "GHz", "|ghz|;gigahertz"),
    (WavelengthUnit::Metre, "m", "(m);[m];/ m|;|metres|;|meters|"),
];

/// True if a title names wavelengths, not energies or wave numbers.
pub(crate) fn is_of_lengths(title: &str) -> bool {
    const STARTS: &str =
        "wavelen;波长;波長;파장;длина волн;wvl;lambda;λ;wellenl;longueur;longitud;lunghezza";
    let title = title.trim_matches(['"', '#', '[', '(', ' ']).to_lowercase();
    STARTS.split(';').any(|word| title.starts_with(word))
}

/// Quantities that are axes where they are counted in a unit of theirs only: "Energy" alone is
/// mostly what a lamp emits.
const QUANTITIES: [&str; 3] = ["frequency", "energy", "photon energy"];

/// True if a column's title names the wavelength axis: by its first word or its last, but not by a
/// word in brackets after another (`S(lambda)`).
pub(crate) fn names_wavelength(title: &str) -> bool {
    const WHOLE: &str = "^x$;^wl$;^nm$;^um$;^µm$;^w.length$;^λ$;^lam$;^cm-1$;^wn$;^ev$;^mev$;^thz$;\
         ^ghz$";
    const STARTS: &str = "^wave;^波长;^波長;^파장;^длина волн;^w.length;^wvl;^lambda;^longitud;^longueur;\
         ^wellen;^lunghezza;^λ;^wl_;^wl ";
    const ENDS: &str = "|wvl$;|wavelength$;|wavenumber$";
    let title = title.trim().trim_matches(['"', '#', '[', ']', '(', ')']);
    let title = title.to_lowercase();
    holds_one(title.trim(), WHOLE)
        || holds_one(&title, STARTS)
        || holds_one(without_brackets(&title), ENDS)
        || QUANTITIES.iter().any(|word| title.starts_with(word))
            && WavelengthUnit::of_title(&title).is_some_and(|unit| !unit.is_length())
}

/// Words for what is noted beside wavelengths and values: neither of them, whatever the numbers.
pub(crate) const BESIDE: &str = "|time|;|hour|;|hours|;|minute|;|minutes|;|date|;|day|;|timestamp|;|temperature|;|temp|;\
     |humidity|;|pressure|;|distance|;|latitude|;|longitude|";

/// True if a title names a quantity other than wavelength.
pub(crate) fn names_another_quantity(title: &str) -> bool {
    const VALUES: &str = "|second|;|seconds|;|current|;|voltage|;|angle|;|depth|";
    let title = title.to_lowercase();
    holds_one(&title, BESIDE) || holds_one(&title, VALUES)
}

/// The unit in a title of a wavelength axis, if it is unknown here: the word in brackets or after a
/// slash (`Frequency (PHz)`), or a quantity without its unit.
pub(crate) fn unknown_unit(title: &str) -> Option<String> {
    if WavelengthUnit::of_title(title).is_some() {
        return None;
    }
    // Where a wavelength was measured, and what else is no unit.
    const HARMLESS: [&str; 7] = ["air", "vacuum", "vac", "vac.", "x", "lambda", "λ"];
    let title = title.trim();
    let name = without_brackets(title).to_lowercase();
    if QUANTITIES.contains(&name.as_str()) && name.len() == title.len() {
        return Some(format!("a {name}"));
    }
    let is_axis = names_wavelength(&name) || QUANTITIES.iter().any(|word| name.starts_with(word));
    let unit = match title.find(['(', '[']) {
        Some(open) => title[open + 1..].split([')', ']']).next(),
        None => title.split_once(" / ").map(|(_, unit)| unit),
    };
    let is_harmless = |unit: &str| HARMLESS.contains(&unit.to_lowercase().as_str());
    unit.map(str::trim)
        .filter(|unit| is_axis && unit.chars().any(char::is_alphabetic))
        .filter(|unit| unit.chars().count() <= 12 && !is_harmless(unit))
        .map(str::to_owned)
}
