//! The words of the window, explained: plain, short, and right.

/// A word and what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// As it stands on screen.
    pub word: &'static str,
    /// What it means, one to three sentences.
    pub means: &'static str,
}

/// All words, by the alphabet.
pub const WORDS: &[Word] = &[
    word(
        "Absorption line",
        "A narrow gap in a spectrum where something between the light and the eye took its share away. The model keeps it as a line of negative weight.",
    ),
    word(
        "Adaptation",
        "The eye gets used to the colour of the light within a minute, so that white paper looks \
         white under a bulb too. Surfaces can be shown as that eye sees them.",
    ),
    word(
        "Band",
        "A stretch of wavelengths, wider than a line. Phosphors shine in bands.",
    ),
    word(
        "Basis",
        "The family of waves that a smooth part is added up from, such as the paper's periodic ones (Fourier) or half-range cosines, which do not have to end as they began.",
    ),
    word(
        "Blackbody",
        "A body that only glows by its heat. A bulb is nearly one; its temperature decides its colour.",
    ),
    word(
        "CCT",
        "Correlated colour temperature: the temperature of the blackbody whose colour comes nearest, in kelvin. Low is warm, high is cool.",
    ),
    word(
        "Chromaticity",
        "Colour without brightness: two numbers, x and y, or u' and v'.",
    ),
    word(
        "CIE",
        "The International Commission on Illumination, which defines the observers, the standard lights and the measures of colour difference used here.",
    ),
    word("CIEDE2000", "See Delta E (ΔE₀₀)."),
    word(
        "Colour-exact",
        "The model's smooth part is adjusted so that its X, Y and Z are exactly those of the spectrum. It costs no numbers.",
    ),
    word(
        "Colour-matching functions",
        "Three curves that say how strongly each wavelength acts on the standard observer's X, Y and Z.",
    ),
    word(
        "Composite model",
        "A spectrum as a smooth part, which few waves describe, and a few lines, each a place and a weight.",
    ),
    word(
        "Cosine basis",
        "Cosines of half the range: the same count of numbers as the Fourier series, without its ringing at the ends.",
    ),
    word("D65", "The CIE's standard daylight, 6504 kelvin."),
    word(
        "Delta E (ΔE₀₀)",
        "CIEDE2000, how different two colours look. Below 1 it is hard to see, to 2 it is seen where both touch, above 5 it is large. Half of the observers see 0.8 (Paravina et al. 2015, ISO/TR 28642).",
    ),
    word(
        "Dispersion",
        "Glass, water and diamond bend short wavelengths more than long ones: light fans out into its colours.",
    ),
    word(
        "Duv",
        "How far a white is from the line of blackbodies: above it (positive) greenish, below it pinkish.",
    ),
    word(
        "Emission line",
        "Light at one wavelength, or nearly, as atoms of a gas give it off. The model keeps it as a place and a weight.",
    ),
    word(
        "Error against waves",
        "How far the model is off with every number of waves: where the curve falls below 1, the difference is hard to see on those surfaces.",
    ),
    word(
        "Filter",
        "Glass or a gel that lets some wavelengths through and holds others back.",
    ),
    word(
        "Fluorescent lamp",
        "Mercury vapour shines in a few lines, mostly ultraviolet; a phosphor on the glass turns that into visible bands. What leaves is lines on a glow.",
    ),
    word(
        "Fourier series",
        "A sum of waves that repeat over the range, each with twice, three times ... the frequency of the first.",
    ),
    word(
        "FWHM",
        "Full width at half maximum: how wide a line or band is at half its height, in nanometres.",
    ),
    word(
        "Gamut",
        "The colours that a screen can show. A corner mark tells of one outside.",
    ),
    word(
        "Illuminant",
        "A light given by its spectrum alone, as the CIE defines A, D65 or the fluorescent FL series.",
    ),
    word(
        "LED",
        "A light-emitting diode. White ones are mostly a blue diode with a yellow phosphor.",
    ),
    word("Line", "See emission line and absorption line."),
    word(
        "Luminance",
        "How bright light is to the eye: the Y of X, Y, Z.",
    ),
    word(
        "Metamers",
        "Two spectra of the same colour: equal under one light, perhaps not under another.",
    ),
    word(
        "Monochromator",
        "An instrument that lets one narrow band of wavelengths through its slit at a time.",
    ),
    word(
        "Nanometre",
        "A millionth of a millimetre, nm. Visible light has wavelengths from about 380 to 780 nm.",
    ),
    word(
        "Numbers",
        "The size of a model: 2N + 1 for N waves, and two for each line. A table from 380 to 780 \
         nm takes 401.",
    ),
    word(
        "Observer",
        "The CIE's standard eye: of 1931 for what is 2 degrees wide, of 1964 for what is 10 \
         degrees wide, of 2015 from the cones themselves.",
    ),
    word(
        "Overlay",
        "A spectrum that is compared: drawn over the first: lights of relative units equally bright (of equal luminance), surfaces as they are.",
    ),
    word(
        "Phosphor",
        "A powder that turns short wavelengths into longer ones, in bands of its own.",
    ),
    word(
        "Reflectance",
        "The share of each wavelength that a surface sends back, 0 to 1.",
    ),
    word("Residual", "The rest: model minus measured."),
    word(
        "Ringing",
        "Waves beside a jump: a short Fourier series overshoots where the two ends of the range differ.",
    ),
    word(
        "rms",
        "Root mean square: the size of an error over a whole curve, given here as a share of the spectrum.",
    ),
    word(
        "Smooth part",
        "A spectrum without its lines: few waves describe it.",
    ),
    word(
        "Spectral power distribution",
        "How much light there is at each wavelength: the spectrum itself.",
    ),
    word(
        "Spike",
        "The paper's word for a line in the model: a place in nanometres and a weight, the power in it. It has no width.",
    ),
    word(
        "sRGB",
        "The colours of ordinary screens. Of a colour outside, what the screen cannot show is cut off: a corner marks it, and what is shown is not the nearest colour.",
    ),
    word(
        "Surface",
        "A known reflectance, shown as it looks under the measured light and under the model.",
    ),
    word(
        "Threshold",
        "The least share of the power that a line must hold to be kept as a line.",
    ),
    word("Tint", "See Duv."),
    word(
        "Transmittance",
        "The share of each wavelength that a filter lets through, 0 to 1.",
    ),
    word(
        "Triphosphor lamp",
        "A fluorescent lamp whose phosphors shine in a blue, a green (terbium) and a red (europium) band.",
    ),
    word(
        "Wavelength",
        "The length of a wave of light in nanometres, which tells one pure colour from another: \
         450 blue, 550 green, 650 red.",
    ),
    word(
        "Waves",
        "The count of waves that draw the smooth part: the order N of its series. None is a level \
         line.",
    ),
    word(
        "Weight",
        "The power of a line, in the spectrum's unit times nanometres; on screen its share of the power is told.",
    ),
    word(
        "XYZ",
        "Three numbers that decide a colour: the spectrum weighed by the three colour-matching functions. Y is the brightness.",
    ),
];

const fn word(word: &'static str, means: &'static str) -> Word {
    Word { word, means }
}

/// What a word means, if it is one of them.
pub fn meaning(word: &str) -> Option<&'static str> {
    let found = WORDS.iter().find(|one| one.word.eq_ignore_ascii_case(word));
    found.map(|one| one.means)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_forty_words_or_more_by_the_alphabet_each_once_with_whole_sentences() {
        assert!(WORDS.len() >= 40);
        let names: Vec<String> = WORDS.iter().map(|w| w.word.to_lowercase()).collect();
        assert!(names.windows(2).all(|pair| pair[0] < pair[1]), "{names:?}");
        assert!(WORDS.iter().all(|w| w.means.ends_with('.')));
    }

    #[test]
    fn a_word_that_refers_to_another_refers_to_one_that_is_there() {
        for one in WORDS {
            let Some(others) = one.means.strip_prefix("See ") else {
                continue;
            };
            for other in others.trim_end_matches('.').split(" and ") {
                assert!(meaning(other).is_some(), "{}: {other}", one.word);
            }
        }
    }
}
