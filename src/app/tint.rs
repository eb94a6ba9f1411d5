//! One scale of words for the white of a light: its temperature, and which way it leaves the
//! blackbodies.
//!
//! White is what stands within 0.006 of the blackbodies or of the curve of ANSI C78.377, which leaves
//! them towards daylight as it grows cooler. Farther than 0.02 a temperature says little of a colour.

use super::verdicts;
use crate::color::{
    Cct,
    quality::diagram::{WHITE_HALF_WIDTH_DUV, white_middle_duv},
};

/// Below this no tint is told, Duv.
const FAINT_DUV: f64 = 0.001;

/// Farther from the blackbodies than this a light is coloured, Duv: this program's border.
const COLOURED_DUV: f64 = 0.02;

/// How far a light stands from the whites.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whiteness {
    /// Beside the blackbodies or the curve of ANSI C78.377.
    White,
    /// Beside them.
    Tinted,
    /// Far from them.
    Coloured,
}

/// How far a light stands from the whites.
pub fn whiteness(cct: Cct) -> Whiteness {
    let off = cct.duv - white_middle_duv(cct.kelvin);
    if cct.duv.abs().min(off.abs()) <= WHITE_HALF_WIDTH_DUV {
        Whiteness::White
    } else if cct.duv.abs() <= COLOURED_DUV {
        Whiteness::Tinted
    } else {
        Whiteness::Coloured
    }
}

/// The tint of a light: "slightly green" of a white, "greenish" of what is none; empty on the line of
/// blackbodies.
pub fn tint(cct: Cct) -> &'static str {
    let is_white = whiteness(cct) == Whiteness::White;
    match cct.duv {
        d if d > FAINT_DUV && is_white => said!("slightly green"),
        d if d > FAINT_DUV => said!("greenish"),
        d if d < -FAINT_DUV && is_white => said!("slightly pink"),
        d if d < -FAINT_DUV => said!("pinkish"),
        _ => "",
    }
}

/// A temperature in the three figures that titles have: "4220 K".
pub fn kelvin_words(kelvin: f64) -> String {
    let step = if kelvin < 9995.0 { 10.0 } else { 100.0 };
    format!("{:.0} K", step * (kelvin / step).round())
}

/// A temperature and its tint for a title: "4220 K, slightly green".
pub fn title_words(cct: Cct) -> String {
    let kelvin = kelvin_words(cct.kelvin);
    match (whiteness(cct), tint(cct)) {
        (Whiteness::Coloured, _) => tr!("none: coloured, nearest {kelvin}", kelvin),
        (_, "") => kelvin,
        (_, tint) => format!("{kelvin}, {tint}"),
    }
}

/// The name of a white: "neutral white", or that it is none.
pub fn name(cct: Cct) -> String {
    match whiteness(cct) {
        Whiteness::White => verdicts::of_cct(cct.kelvin).to_owned(),
        Whiteness::Tinted if cct.duv > 0.0 => said!("greenish, beside the whites").to_owned(),
        Whiteness::Tinted => said!("pinkish, beside the whites").to_owned(),
        Whiteness::Coloured => said!("a coloured light, no white").to_owned(),
    }
}

/// What Duv tells.
pub fn duv_words(cct: Cct) -> String {
    let is_above = cct.duv > 0.0;
    let words = match (whiteness(cct), tint(cct)) {
        (Whiteness::White, "") => said!("within 0.001 of the line of blackbodies"),
        (Whiteness::White, tint) => tint,
        (Whiteness::Tinted, _) if is_above => {
            said!("greenish: beside the whites of ANSI C78.377")
        }
        (Whiteness::Tinted, _) => said!("pinkish: beside the whites of ANSI C78.377"),
        (Whiteness::Coloured, _) if is_above => {
            said!("far above the line of blackbodies: no white")
        }
        (Whiteness::Coloured, _) => said!("far below the line of blackbodies: no white"),
    };
    words.to_owned()
}

/// A light with its article, for the beginning of a sentence: "A greenish light".
pub fn light_words(cct: Cct) -> String {
    match whiteness(cct) {
        Whiteness::White => said!("A white light").to_owned(),
        Whiteness::Tinted if cct.duv > 0.0 => said!("A greenish light").to_owned(),
        Whiteness::Tinted => said!("A pinkish light").to_owned(),
        Whiteness::Coloured => said!("A coloured light").to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cct(kelvin: f64, duv: f64) -> Cct {
        Cct { kelvin, duv }
    }

    #[test]
    fn a_white_is_near_the_curve_of_the_standard_and_nothing_else_is() {
        // ANSI C78.377: at 6500 K the middle lies at 0.0030, at 2700 K at 0.
        for (kelvin, duv, expected) in [
            (6500.0, 0.0090, Whiteness::White),
            (6500.0, 0.0092, Whiteness::Tinted),
            (6500.0, -0.0061, Whiteness::Tinted),
            (50_000.0, 0.0, Whiteness::White),
            (2700.0, 0.0059, Whiteness::White),
            (2700.0, 0.0061, Whiteness::Tinted),
            (4000.0, 0.036, Whiteness::Coloured),
        ] {
            assert_eq!(whiteness(cct(kelvin, duv)), expected, "{kelvin} {duv}");
        }
        assert_eq!(name(cct(4224.0, 0.0019)), "neutral white");
        assert_eq!(name(cct(3757.0, 0.04)), "a coloured light, no white");
    }

    #[test]
    fn a_title_has_three_figures_and_the_tint() {
        assert_eq!(title_words(cct(4224.6, 0.0019)), "4220 K, slightly green");
        assert_eq!(title_words(cct(2855.6, 0.0)), "2860 K");
        assert_eq!(title_words(cct(3000.0, -0.0074)), "3000 K, pinkish");
        assert_eq!(kelvin_words(9996.0), "10000 K");
        assert_eq!(kelvin_words(12_345.0), "12300 K");
        // A white of the standard is not called greenish where its name is a white.
        let cool = cct(6500.0, 0.0085);
        assert_eq!(title_words(cool), "6500 K, slightly green");
        assert_eq!(duv_words(cool), "slightly green");
        assert_eq!(name(cool), "cool white");
        let none = title_words(cct(4000.0, 0.036));
        assert_eq!(none, "none: coloured, nearest 4000 K");
    }
}
