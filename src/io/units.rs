//! Units of the wavelength axis: told by a header, else guessed from the range.

use serde::{Deserialize, Serialize};

/// What a file counts its wavelength axis in.
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
}

/// Planck's constant times the speed of light in eV nm: 6.62607015e-34 x 299792458 /
/// 1.602176634e-19 x 1e9, all three exact in the SI of 2019.
const EV_NM: f64 = 6.626_070_15e-34 * 299_792_458.0 / 1.602_176_634e-19 * 1e9;

impl WavelengthUnit {
    /// Every unit, the likeliest first.
    pub const ALL: [Self; 5] = [
        Self::Nanometre,
        Self::Micrometre,
        Self::Angstrom,
        Self::PerCentimetre,
        Self::Electronvolt,
    ];

    /// The unit's sign: `nm`, `um`, `Å`, `1/cm`, `eV`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Nanometre => "nm",
            Self::Micrometre => "um",
            Self::Angstrom => "Å",
            Self::PerCentimetre => "1/cm",
            Self::Electronvolt => "eV",
        }
    }

    /// Wavelength in nm of a number in this unit.
    pub fn to_nm(self, x: f64) -> f64 {
        match self {
            Self::Nanometre => x,
            Self::Micrometre => x * 1000.0,
            Self::Angstrom => x / 10.0,
            Self::PerCentimetre => 1e7 / x,
            Self::Electronvolt => EV_NM / x,
        }
    }

    /// The number in this unit of a wavelength in nm: what a file said before it was converted.
    pub fn of_nm(self, nm: f64) -> f64 {
        match self {
            Self::Nanometre => nm,
            Self::Micrometre => nm / 1000.0,
            Self::Angstrom => nm * 10.0,
            Self::PerCentimetre => 1e7 / nm,
            Self::Electronvolt => EV_NM / nm,
        }
    }

    /// The unit that a title of the wavelength column names (`Wavelength (nm)`, `[um]`, `Å`).
    pub fn of_title(title: &str) -> Option<Self> {
        let title = title.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|w| title.contains(w));
        let tokens = || title.split(|c: char| !c.is_alphanumeric() && c != 'µ' && c != 'μ');
        if has(&[
            "wavenumber",
            "wave number",
            "cm-1",
            "cm^-1",
            "cm⁻¹",
            "1/cm",
            "kayser",
        ]) {
            Some(Self::PerCentimetre)
        } else if has(&["nanomet"]) || tokens().any(|t| t == "nm") {
            Some(Self::Nanometre)
        } else if has(&["micromet", "micron", "µm", "μm"]) || tokens().any(|t| t == "um") {
            Some(Self::Micrometre)
        } else if has(&["angstr", "ångstr", "å", "\u{212b}"]) {
            Some(Self::Angstrom)
        } else if tokens().any(|t| t == "ev") {
            Some(Self::Electronvolt)
        } else {
            None
        }
    }

    /// The unit that a range of positive numbers suggests; `None` where no unit fits.
    ///
    /// 0.2-3 is micrometres and 200-3000 nanometres; libraries of minerals go on to 50 um and
    /// filters to 20 um, so the upper bounds are wider. All above 3000 is wave numbers.
    pub fn of_range(min: f64, max: f64) -> Option<Self> {
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

/// Whether a column's title says that it is the wavelength axis.
pub fn names_wavelength(title: &str) -> bool {
    let title = title
        .trim()
        .trim_matches(['"', '#', '[', ']', '(', ')'])
        .to_lowercase();
    // A quantity over the wavelength, "E(lambda)" or "S(λ) [W]", is none.
    if let Some((quantity, behind)) = title.split_once('(')
        && !quantity.trim().is_empty()
        && ["lambda)", "λ)", "wavelength)"]
            .iter()
            .any(|l| behind.trim_start().starts_with(l))
    {
        return false;
    }
    if matches!(
        title.trim(),
        "x" | "wl" | "nm" | "um" | "µm" | "w.length" | "λ" | "lam" | "cm-1" | "wn" | "ev"
    ) {
        return true;
    }
    const STARTS: [&str; 10] = [
        "wave",
        "wvl",
        "lambda",
        "longitud",
        "longueur",
        "wellen",
        "lunghezza",
        "λ",
        "wl_",
        "wl ",
    ];
    STARTS.iter().any(|word| title.starts_with(word))
        || ["wvl", "wavelength", "wavenumber", "lambda"]
            .iter()
            .any(|word| title.contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_name_their_unit() {
        use WavelengthUnit::*;
        for (title, unit) in [
            ("Wavelength (nm)", Some(Nanometre)),
            ("[nm]", Some(Nanometre)),
            ("wavelength_nm", Some(Nanometre)),
            ("Wavelength(micron)", Some(Micrometre)),
            ("X Units: Wavelength (micrometers)", Some(Micrometre)),
            ("λ [µm]", Some(Micrometre)),
            ("Lambda / Å", Some(Angstrom)),
            ("Wavenumber", Some(PerCentimetre)),
            ("Energy (eV)", Some(Electronvolt)),
            ("wavelength", None),
            ("[W/m2/nmx]", None),
        ] {
            assert_eq!(WavelengthUnit::of_title(title), unit, "{title}");
        }
    }

    #[test]
    fn ranges_suggest_a_unit() {
        use WavelengthUnit::*;
        assert_eq!(WavelengthUnit::of_range(0.35, 2.5), Some(Micrometre));
        assert_eq!(WavelengthUnit::of_range(380.0, 780.0), Some(Nanometre));
        assert_eq!(
            WavelengthUnit::of_range(4000.0, 25_000.0),
            Some(PerCentimetre)
        );
        assert_eq!(WavelengthUnit::of_range(0.0, 400.0), None);
    }

    #[test]
    fn every_unit_goes_there_and_back() {
        for unit in WavelengthUnit::ALL {
            let nm = unit.to_nm(unit.of_nm(546.1));
            assert!((nm - 546.1).abs() < 1e-9, "{}", unit.word());
        }
        assert!((WavelengthUnit::Electronvolt.to_nm(2.0) - 619.92).abs() < 0.01);
    }

    #[test]
    fn the_wavelength_column_is_known_by_its_title() {
        for title in [
            "wl",
            "w.length",
            "Wave",
            "[nm]",
            "Wvl",
            "LOWER WVL",
            "\"Wavelength\"",
            "nm",
        ] {
            assert!(names_wavelength(title), "{title}");
        }
        for title in [
            "R(adaxial)",
            "white",
            "Transmittance(%)",
            "watt",
            "E(lambda) [W/m2]",
        ] {
            assert!(!names_wavelength(title), "{title}");
        }
    }
}
