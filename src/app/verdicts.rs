//! Words that judge figures, in one table: every page takes its verdicts from here.
//!
//! | figure | borders | source |
//! |---|---|---|
//! | ΔE₀₀ | 1, 2, 5 | this program's, beside published ones: half of the observers see 0.8 and take 1.8 for no match any more (Paravina et al. 2015, ISO/TR 28642:2016, for teeth); CIEDE2000 is meant for differences up to 5 (ISO/CIE 11664-6) |
//! | rms behind a slit of 10 nm | 2, 5, 10 % | this program's: the doubt of good array spectroradiometers is some 2 %, of simple ones some 5 % |
//! | Rf | 95, 85, 70, 50 | this program's: mean differences of 0.7, 2.2, 4.5 and 7.4 in CAM02-UCS by the formula of TM-30 |
//! | Ra | 80; 95, 90, 60, 20 | EN 12464-1 for work indoors; the others this program's |
//! | Rg, Rcs,h | 98 and 102; 1 % | this program's: no change of vividness is told within them |
//! | Ri | 90, 75, 50 | this program's |
//! | SSI | 90, 70, 50 | this program's: SMPTE ST 2122 sets none, and promises nothing of low values |
//! | CCT | 3300, 5300 K | EN 12464-1: warm, neutral, cool |
//! | Duv | 0.006 about a curve | ANSI C78.377 (`tint`) |
//! | wavelength | 430 ... 617 nm | names of lights after Kelly (1943) |
//!
//! Ra and Rf are means: their words speak of the mean, and the worst sample stands beside them.

use crate::{languages::said, spectrum::Kind, study::products::MATCH_DELTA_E};

/// How large a difference is: of colours to the eye, of spectra to an instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Seen {
    /// CIEDE2000 below [`HARD_TO_SEE`]; rms behind the slit below 2 %.
    Hardly,
    /// From there: where the two colours touch.
    SideBySide,
    /// From 2; from 5 %.
    Visible,
    /// From 5, beyond what CIEDE2000 was made for; from 10 %.
    Large,
}

/// CIEDE2000 below which a difference is hard to see: what two surfaces match within, too.
pub const HARD_TO_SEE: f64 = MATCH_DELTA_E;

/// What is said of a difference: on a badge, of a model ("Model and light ..."), behind a figure of
/// colour, and what it means to the eye and to an instrument.
struct SeenWords {
    word: &'static str,
    verdict: &'static str,
    seen: &'static str,
    meaning: &'static str,
    behind_slit: &'static str,
}

const fn seen_words([word, verdict, seen, meaning, behind_slit]: [&'static str; 5]) -> SeenWords {
    SeenWords {
        word,
        verdict,
        seen,
        meaning,
        behind_slit,
    }
}

/// In the order of [`Seen::ALL`].
const SEEN: [SeenWords; 4] = [
    seen_words([
        later!("Hard to tell"),
        later!("look alike"),
        later!("hard to see"),
        later!(
            "CIEDE2000 below 1: hard to see, not invisible. Half of the observers see 0.8, \
             practised ones less (Paravina et al. 2015, ISO/TR 28642)."
        ),
        later!("Below 2 %: within the uncertainty of good spectroradiometers."),
    ]),
    seen_words([
        later!("Slight"),
        later!("differ only side by side"),
        later!("seen side by side"),
        later!(
            "CIEDE2000 from 1 to 2: seen where both colours touch. To half of the observers 1.8 \
             is no match any more (ISO/TR 28642)."
        ),
        later!("From 2 to 5 %: a good spectroradiometer can tell, a simple one hardly."),
    ]),
    seen_words([
        later!("Clear"),
        later!("visibly differ"),
        later!("visible"),
        later!("CIEDE2000 from 2 to 5: seen if you look for it."),
        later!("From 5 to 10 %: a simple spectroradiometer can tell."),
    ]),
    seen_words([
        later!("Large"),
        later!("give different colours"),
        later!("large"),
        later!("CIEDE2000 above 5: a large difference, more than the formula is meant for."),
        later!("Above 10 %: to an instrument it is another spectrum."),
    ]),
];

impl Seen {
    /// From the least difference to the largest.
    pub const ALL: [Self; 4] = [Self::Hardly, Self::SideBySide, Self::Visible, Self::Large];

    /// How a CIEDE2000 is seen.
    pub fn of(delta_e_2000: f64) -> Self {
        match delta_e_2000 {
            d if d < HARD_TO_SEE => Self::Hardly,
            d if d < 2.0 => Self::SideBySide,
            d if d <= 5.0 => Self::Visible,
            _ => Self::Large,
        }
    }

    /// How large a difference behind a slit of 10 nm is, as a share of the spectrum (rms).
    pub fn of_slit(share: f64) -> Self {
        match share {
            s if s < 0.02 => Self::Hardly,
            s if s < 0.05 => Self::SideBySide,
            s if s <= 0.1 => Self::Visible,
            _ => Self::Large,
        }
    }

    fn words(self) -> &'static SeenWords {
        &SEEN[self as usize]
    }

    /// In a word or two, for a badge.
    pub fn word(self) -> &'static str {
        said(self.words().word)
    }

    /// Behind a figure, in small letters.
    pub fn seen(self) -> &'static str {
        said(self.words().seen)
    }

    /// Behind two things that are seen.
    pub fn of_two(self) -> &'static str {
        said(self.words().verdict)
    }

    /// As a verdict on the model of a light, a surface or a filter.
    pub fn verdict(self, of: Kind) -> String {
        let verdict = self.of_two();
        match of {
            Kind::Reflectance => tr!("Model and surface {verdict}", verdict),
            Kind::Transmittance => tr!("Model and filter {verdict}", verdict),
            _ => tr!("Model and light {verdict}", verdict),
        }
    }

    /// What it means to the eye, a sentence or two.
    pub fn meaning(self) -> &'static str {
        said(self.words().meaning)
    }

    /// What it means to an instrument, a sentence.
    pub fn meaning_behind_slit(self) -> &'static str {
        said(self.words().behind_slit)
    }
}

/// Words of a figure from a border on, the highest border first.
type Borders = &'static [(f64, &'static str)];

/// The words of the first border that a figure reaches; those of the lowest for no number.
fn reached(borders: Borders, figure: f64) -> &'static str {
    let found = borders.iter().find(|(border, _)| figure >= *border);
    found
        .or(borders.last())
        .map_or("", |(_, words)| said(words))
}

const OF_RF: Borders = &[
    (95.0, later!("shifts colours very little")),
    (85.0, later!("shifts colours a little")),
    (70.0, later!("shifts colours visibly")),
    (50.0, later!("shifts colours strongly")),
    (f64::NEG_INFINITY, later!("distorts colours")),
];

/// Behind a light's name: what it does to colours on average, by Rf.
pub fn of_rf(rf: f64) -> &'static str {
    reached(OF_RF, rf)
}

/// The same with the light's name, a clause.
pub fn shifts_on_average(name: &str, rf: f64) -> String {
    match rf {
        rf if rf >= 95.0 => tr!("{name} shifts colours very little on average", name),
        rf if rf >= 85.0 => tr!("{name} shifts colours a little on average", name),
        rf if rf >= 70.0 => tr!("{name} shifts colours visibly on average", name),
        rf if rf >= 50.0 => tr!("{name} shifts colours strongly on average", name),
        _ => tr!("{name} distorts colours on average", name),
    }
}

const OF_RA: Borders = &[
    (95.0, later!("test colours hardly shift on average")),
    (90.0, later!("test colours shift a little on average")),
    (80.0, later!("enough for most work indoors (EN 12464-1)")),
    (60.0, later!("test colours shift visibly on average")),
    (20.0, later!("test colours shift strongly on average")),
    (
        f64::NEG_INFINITY,
        later!("test colours shift very strongly on average"),
    ),
];

/// What Ra tells of the mean of its eight test colours.
pub fn of_ra(ra: f64) -> &'static str {
    reached(OF_RA, ra)
}

const OF_RG: Borders = &[
    (
        102.0,
        later!("colours more vivid than under the reference on average"),
    ),
    (
        98.0,
        later!("colours as vivid as under the reference on average"),
    ),
    (
        80.0,
        later!("colours duller than under the reference on average"),
    ),
    (
        f64::NEG_INFINITY,
        later!("colours much duller than under the reference on average"),
    ),
];

/// How vivid colours are, by Rg.
pub fn of_rg(rg: f64) -> String {
    reached(OF_RG, rg).to_owned()
}

const VIVIDNESS: Borders = &[
    (102.0, later!("more vivid than the reference")),
    (98.0, later!("as vivid as the reference")),
    (80.0, later!("duller than the reference")),
    (f64::NEG_INFINITY, later!("much duller than the reference")),
];

/// The same beside a figure.
pub fn vividness(rg: f64) -> String {
    reached(VIVIDNESS, rg).to_owned()
}

/// How a test colour looks, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Looks {
    /// From 90.
    Right,
    /// From 75.
    LittleOff,
    /// From 50.
    Off,
    /// Below.
    Wrong,
}

impl Looks {
    /// How a test colour of an index looks.
    pub fn of(index: f64) -> Self {
        match index {
            i if i >= 90.0 => Self::Right,
            i if i >= 75.0 => Self::LittleOff,
            i if i >= 50.0 => Self::Off,
            _ => Self::Wrong,
        }
    }
}

const OF_SAMPLE: Borders = &[
    (90.0, later!("looks right")),
    (75.0, later!("looks a little off")),
    (50.0, later!("looks off")),
    (f64::NEG_INFINITY, later!("looks wrong")),
];

/// How a test colour looks, by its index.
pub fn of_sample(index: f64) -> &'static str {
    reached(OF_SAMPLE, index)
}

/// Share of the chroma that a hue must gain or lose before it is said, Rcs,h.
const TOLD_CHROMA: f64 = 0.01;

/// Which way vividness went where all of the hue bins say the same: "duller" or "more vivid".
pub fn of_chroma(rcs: &[f64]) -> Option<&'static str> {
    let all = |is: fn(f64) -> bool| !rcs.is_empty() && rcs.iter().all(|r| is(*r));
    if all(|r| r > TOLD_CHROMA) {
        Some(said!("more vivid"))
    } else {
        all(|r| r < -TOLD_CHROMA).then_some(said!("duller"))
    }
}

/// Which way a hue goes most, by its local shifts of chroma (a share of it) and of hue (radians): a
/// small turn moves a colour as far as a gain of that share of its chroma.
pub fn of_shift(rcs: f64, rhs: f64) -> &'static str {
    match of_chroma(&[rcs]) {
        Some(way) if rcs.abs() >= rhs.abs() => way,
        _ if rhs.abs() > TOLD_CHROMA => said!("turned in hue"),
        _ => said!("neither in vividness nor in hue on average"),
    }
}

/// How like a reference a spectrum is, and what that tells of cameras.
pub fn of_ssi(index: f64, reference: &str) -> String {
    match index {
        i if i >= 90.0 => tr!("very like {reference}: cameras should match", reference),
        i if i >= 70.0 => tr!("like {reference}: cameras should nearly match", reference),
        i if i >= 50.0 => tr!(
            "in part unlike {reference}: cameras may or may not match",
            reference
        ),
        _ => tr!(
            "unlike {reference}: cameras may or may not match",
            reference
        ),
    }
}

const OF_CAMERAS: Borders = &[
    (90.0, later!("should match")),
    (70.0, later!("should nearly match")),
    (f64::NEG_INFINITY, later!("may or may not match")),
];

/// What an SSI tells of cameras, behind their name.
pub fn of_cameras(index: f64) -> &'static str {
    reached(OF_CAMERAS, index)
}

const HUES: Borders = &[
    (617.0, later!("red")),
    (597.0, later!("reddish orange")),
    (586.0, later!("orange")),
    (580.0, later!("yellowish orange")),
    (575.0, later!("yellow")),
    (571.0, later!("greenish yellow")),
    (558.0, later!("yellow green")),
    (530.0, later!("yellowish green")),
    (498.0, later!("green")),
    (493.0, later!("bluish green")),
    (487.0, later!("blue green")),
    (482.0, later!("greenish blue")),
    (465.0, later!("blue")),
    (430.0, later!("purplish blue")),
    (f64::NEG_INFINITY, later!("violet")),
];

/// The name of a wavelength's light.
pub fn of_wavelength(nm: f64) -> &'static str {
    reached(HUES, nm)
}

const OF_CCT: Borders = &[
    (8000.0, later!("bluish white")),
    (5300.0, later!("cool white")),
    (3300.0, later!("neutral white")),
    (2000.0, later!("warm white")),
    (f64::NEG_INFINITY, later!("amber")),
];

/// The name of a white by its temperature, K; only for what is near the blackbodies.
pub fn of_cct(kelvin: f64) -> &'static str {
    reached(OF_CCT, kelvin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_difference_has_words_that_claim_no_more_than_its_figure() {
        for (delta, seen) in [
            (0.0, Seen::Hardly),
            (0.999, Seen::Hardly),
            (1.0, Seen::SideBySide),
            (2.0, Seen::Visible),
            (5.0, Seen::Visible),
            (5.001, Seen::Large),
            (f64::NAN, Seen::Large),
        ] {
            assert_eq!(Seen::of(delta), seen, "{delta}");
        }
        for (share, step) in [
            (0.0199, Seen::Hardly),
            (0.02, Seen::SideBySide),
            (0.05, Seen::Visible),
            (0.1, Seen::Visible),
            (0.101, Seen::Large),
            (f64::NAN, Seen::Large),
        ] {
            assert_eq!(Seen::of_slit(share), step, "{share}");
        }
        let said = Seen::Hardly.verdict(Kind::Light);
        assert_eq!(said, "Model and light look alike");
        assert!(Seen::Hardly.meaning().contains("ISO/TR 28642"));
        for seen in Seen::ALL {
            assert!(seen.meaning().ends_with('.') && seen.meaning_behind_slit().ends_with('.'));
            let both = [seen.meaning(), seen.meaning_behind_slit()].join(" ");
            let all = [seen.word(), seen.seen(), &both].join(" ");
            for word in ["nobody", "cannot", "wrong"] {
                assert!(!all.to_lowercase().contains(word), "{all}");
            }
        }
    }

    #[test]
    fn borders_fall_and_every_figure_has_words() {
        for borders in [OF_RF, OF_RA, OF_RG, OF_SAMPLE, HUES, OF_CCT] {
            assert!(borders.windows(2).all(|pair| pair[0].0 > pair[1].0));
            for figure in [-1e300, -1.0, 50.0, 575.0, 1e300, f64::NAN] {
                assert!(!reached(borders, figure).is_empty());
            }
        }
        // Kelly's yellow is narrow: 560-570 nm are yellow green.
        assert_eq!(of_wavelength(565.0), "yellow green");
        assert_eq!(of_wavelength(578.0), "yellow");
    }

    #[test]
    fn a_hue_is_said_to_turn_only_where_it_turns_more_than_it_gains_or_loses() {
        assert_eq!(of_shift(0.02, 0.0), "more vivid");
        assert_eq!(of_shift(-0.04, 0.03), "duller");
        assert_eq!(of_shift(-0.04, -0.05), "turned in hue");
        assert_eq!(of_shift(0.0, 0.02), "turned in hue");
        assert!(of_shift(0.005, 0.005).starts_with("neither"));
    }

    #[test]
    fn vividness_is_told_only_where_all_hues_say_the_same() {
        assert_eq!(of_chroma(&[0.3]), Some("more vivid"));
        assert_eq!(of_chroma(&[-0.3, -0.02]), Some("duller"));
        for silent in [&[][..], &[0.005], &[-0.3, 0.2], &[f64::NAN]] {
            assert_eq!(of_chroma(silent), None, "{silent:?}");
        }
    }
}
