//! What a unit of a light's values says: power or photons, per area, per nm, per steradian.

/// What is counted.
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
    /// Per area.
    pub per_area: bool,
    /// Per wavelength.
    pub per_nm: bool,
    /// Per steradian.
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

/// Signs, longer ones before what they begin with; all lower case but where it would mislead.
const SIGNS: [(&str, Of, f64); 26] = [
    ("watts", Of::Watt, 1.0),
    ("watt", Of::Watt, 1.0),
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

impl SpectralUnit {
    /// Takes a unit apart; `None` for what is no power or photon flux.
    pub fn of(text: &str) -> Option<Self> {
        let plain = text
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
        let mut factor = 1.0;
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
