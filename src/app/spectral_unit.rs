//! What a unit of a light's values says: power or photons, per area, per nm, per steradian.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    /// Power.
    Watts,
    /// Photons.
    Micromoles,
}

/// A unit taken apart: `mW m-2 nm-1`, `µW/cm²/nm`, `µmol m-2 s-1`, ...
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralUnit {
    /// Power (of photons: their number a second).
    pub counted: Counted,
    /// What turns a number in this unit into W (µmol s-1), per m2, nm and sr where it is.
    pub factor: f64,
    pub per_area: bool,
    /// Per wavelength.
    pub per_nm: bool,
    pub per_steradian: bool,
}

/// What a sign counts, in units of W, µmol, m, nm, s, sr.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Watt,
    Micromole,
    Metre,
    Nanometre,
    Second,
    Steradian,
}

/// Micromoles that a photon is: one over Avogadro's number, exact in the SI of 2019.
const PHOTON: f64 = 1e6 / 6.022_140_76e23;

/// Signs, longer ones before what they begin with; all lower case but where it would mislead.
const SIGNS: [(&str, Of, f64); 38] = [
    ("watts", Of::Watt, 1.0),
    ("watt", Of::Watt, 1.0),
    (MEGAWATT, Of::Watt, 1e6),
    ("photons", Of::Micromole, PHOTON),
    ("photon", Of::Micromole, PHOTON),
    ("quanta", Of::Micromole, PHOTON),
    ("micromoles", Of::Micromole, 1.0),
    ("micromole", Of::Micromole, 1.0),
    ("micromol", Of::Micromole, 1.0),
    ("µeinsteins", Of::Micromole, 1.0),
    ("µeinstein", Of::Micromole, 1.0),
    ("einsteins", Of::Micromole, 1e6),
    ("einstein", Of::Micromole, 1e6),
    ("moles", Of::Micromole, 1e6),
    ("µmol", Of::Micromole, 1.0),
    ("umol", Of::Micromole, 1.0),
    ("mmol", Of::Micromole, 1e3),
    ("nmol", Of::Micromole, 1e-3),
    ("mol", Of::Micromole, 1e6),
    ("µe", Of::Micromole, 1.0),
    ("ue", Of::Micromole, 1.0),
    ("kw", Of::Watt, 1e3),
    ("mw", Of::Watt, 1e-3),
    ("µw", Of::Watt, 1e-6),
    ("uw", Of::Watt, 1e-6),
    ("nw", Of::Watt, 1e-9),
    ("w", Of::Watt, 1.0),
    ("nm", Of::Nanometre, 1.0),
    ("µm", Of::Nanometre, 1e3),
    ("um", Of::Nanometre, 1e3),
    ("cm", Of::Metre, 1e-2),
    ("mm", Of::Metre, 1e-3),
    ("m", Of::Metre, 1.0),
    ("sr", Of::Steradian, 1.0),
    ("sec", Of::Second, 1.0),
    ("s", Of::Second, 1.0),
    ("å", Of::Nanometre, 0.1),
    ("angstrom", Of::Nanometre, 0.1),
];

/// Megawatts in small letters, in which they would be thousandths of a watt.
const MEGAWATT: &str = "megawatt";

impl SpectralUnit {
    /// Takes a unit apart; `None` for what is no power or photon flux.
    pub fn of(text: &str) -> Option<Self> {
        let (times, text) = times(text.trim());
        let has_small = text.chars().any(char::is_lowercase);
        let plain = match text.strip_prefix("MW") {
            Some(rest) if has_small => MEGAWATT.to_owned() + rest,
            Some(_) => return None,
            None => text.to_owned(),
        };
        let plain = plain
            .to_lowercase()
            .replace('μ', "µ")
            .replace("per ", "/")
            .replace(['²'], "2")
            .replace('³', "3")
            .replace('¹', "1")
            .replace(['⁻', '−', '–'], "-");
        let mut rest = plain.trim();
        let mut below = false;
        let mut powers = [0i32; 6];
        let mut factor = times;
        while let Some(first) = rest.chars().next() {
            if first == '/' {
                below = true;
            }
            if "/ .·*()[]_".contains(first) {
                rest = &rest[first.len_utf8()..];
                continue;
            }
            let (sign, of, size) = SIGNS.iter().find(|(sign, _, _)| rest.starts_with(sign))?;
            rest = &rest[sign.len()..];
            // "µmol photons": the second word says of what the moles are.
            if *of == Of::Micromole && powers[*of as usize] == 1 {
                continue;
            }
            let (power, after) = power(rest)?;
            rest = after;
            // After a stroke all is below it, but what says so itself.
            let power = if below && power > 0 { -power } else { power };
            powers[*of as usize] += power;
            factor *= size.powi(power);
        }
        let [watts, moles, metres, nm, seconds, steradians] = powers;
        let counted = match (watts, moles, seconds) {
            (1, 0, 0) => Counted::Watts,
            (0, 1, -1) => Counted::Micromoles,
            _ => return None,
        };
        let per = |power: i32, one: i32| match power {
            0 => Some(false),
            p if p == one => Some(true),
            _ => None,
        };
        Some(Self {
            counted,
            factor,
            per_area: per(metres, -2)?,
            per_nm: per(nm, -1)?,
            per_steradian: per(steradians, -1)?,
        })
    }

    /// The unit of factor 1 in words: "W m-2 nm-1".
    pub fn words(&self) -> String {
        let Self {
            counted,
            factor: _,
            per_area,
            per_nm,
            per_steradian,
        } = *self;
        let (what, per_second) = match counted {
            Counted::Watts => ("W", false),
            Counted::Micromoles => ("µmol", true),
        };
        let parts = [
            (per_area, " m-2"),
            (per_second, " s-1"),
            (per_steradian, " sr-1"),
            (per_nm, " nm-1"),
        ];
        let said = parts.iter().filter(|(is, _)| *is).map(|(_, part)| *part);
        std::iter::once(what).chain(said).collect()
    }
}

/// The number that a unit begins with and what is behind it: "1e15 photons", "10^15 photons".
fn times(text: &str) -> (f64, &str) {
    let body = text.trim_start_matches(['x', '×', '*', ' ']);
    let end = body.find(|c: char| !"0123456789.+-eE^⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c));
    // "1e15 einsteins": the last letter may be the unit's.
    let number = body[..end.unwrap_or(body.len())].trim_end_matches(['e', 'E']);
    let raised = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|other| other == c);
    let value = if let Some(power) = number.strip_prefix("10^") {
        power.parse().ok().map(|power| 10f64.powi(power))
    } else if let Some(power) = number
        .strip_prefix("10")
        .filter(|rest| rest.starts_with(|c| raised(c).is_some()))
    {
        let mut digits = power.chars().map(|c| raised(c).map(|digit| digit as i32));
        let power = digits.try_fold(0_i32, |sum, digit| sum.checked_mul(10)?.checked_add(digit?));
        power
            .filter(|power| *power < 40)
            .map(|power| 10f64.powi(power))
    } else {
        number.parse().ok()
    };
    match value.filter(|value: &f64| value.is_finite() && *value > 0.0) {
        Some(value) => (
            value,
            body[number.len()..].trim_start_matches(['x', '×', '*', ' ']),
        ),
        None => (1.0, text),
    }
}

/// The exponent at the beginning of a text, 1 where there is none, and what follows.
fn power(text: &str) -> Option<(i32, &str)> {
    let text = text.strip_prefix('^').unwrap_or(text);
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text),
    };
    let end = digits
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(digits.len());
    match (&digits[..end], sign) {
        ("", 1) => Some((1, text)),
        ("", _) => None,
        (number, sign) => Some((sign * number.parse::<i32>().ok()?, &digits[end..])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_in_many_spellings() {
        for (text, factor) in [
            ("W m-2 nm-1", 1.0),
            ("W/m2/nm", 1.0),
            ("W/m^2nm", 1.0),
            ("W/(m² nm)", 1.0),
            ("W·m⁻²·nm⁻¹", 1.0),
            ("Wm-2nm-1", 1.0),
            ("mW m-2 nm-1", 1e-3),
            ("uW/cm2/nm", 1e-2),
            ("μW cm^-2 nm^-1", 1e-2),
            ("W/m2/µm", 1e-3),
            ("Watts/m^2/nm", 1.0),
        ] {
            let unit = SpectralUnit::of(text).unwrap_or_else(|| panic!("{text}"));
            assert!((unit.factor / factor - 1.0).abs() < 1e-12, "{text}");
            assert!(
                unit.per_area && unit.per_nm && !unit.per_steradian,
                "{text}"
            );
            assert_eq!(unit.counted, Counted::Watts, "{text}");
        }
        for text in ["µmol m-2 s-1", "umolm⁻²s⁻¹", "μmol/m²/s"] {
            let unit = SpectralUnit::of(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((unit.counted, unit.factor), (Counted::Micromoles, 1.0));
            assert!(unit.per_area && !unit.per_nm);
        }
        for (text, factor) in [
            ("photons/s/cm2/nm", 1e4 / 6.022_140_76e17),
            ("1e15 photons/s/cm2/nm", 1e19 / 6.022_140_76e17),
            ("10^15 photons s-1 m-2 nm-1", 1e15 / 6.022_140_76e17),
            ("10¹⁵ photons s⁻¹ m⁻² nm⁻¹", 1e15 / 6.022_140_76e17),
            ("quanta/cm2/s/nm", 1e4 / 6.022_140_76e17),
            ("mol m-2 s-1 nm-1", 1e6),
            ("nmol/m2/s/nm", 1e-3),
            ("µmol photons m⁻² s⁻¹ nm⁻¹", 1.0),
            ("µE/m2/s/nm", 1.0),
        ] {
            let unit = SpectralUnit::of(text).unwrap_or_else(|| panic!("{text}"));
            assert!((unit.factor / factor - 1.0).abs() < 1e-12, "{text}");
            assert_eq!(unit.counted, Counted::Micromoles, "{text}");
            assert!(unit.per_area && unit.per_nm, "{text}");
        }
        let mega = SpectralUnit::of("MW/m2/nm").map(|unit| unit.factor);
        assert_eq!(mega, Some(1e6));
        assert!(SpectralUnit::of("W m-2 sr-1 nm-1").is_some_and(|u| u.per_steradian));
        for words in ["W m-2 nm-1", "W m-2 sr-1 nm-1", "µmol m-2 s-1 nm-1", "W"] {
            assert_eq!(
                SpectralUnit::of(words).map(|u| u.words()).as_deref(),
                Some(words)
            );
        }
    }

    #[test]
    fn what_is_no_flux_is_not_taken_for_one() {
        for text in [
            "",
            "counts",
            "W s m-2 nm-1",
            "fraction",
            "lx",
            "K",
            "W/m",
            "W m-",
            "%",
            "a.u.",
        ] {
            assert_eq!(SpectralUnit::of(text), None, "{text}");
        }
    }
}
