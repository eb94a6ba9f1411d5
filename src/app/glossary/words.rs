//! The words of the glossary, each with its forms in running text.

use super::Word;

/// All words, by the alphabet.
pub const WORDS: &[Word] = &[
    word(
        later!("Absorption line"),
        &[later!("absorption line"), later!("dark line")],
        later!(
            "A narrow gap in a spectrum where something between the light and the eye took its share away. The model keeps it as a line of negative weight."
        ),
    ),
    word(
        later!("Adaptation"),
        &[later!("adapts"), later!("adaptation"), later!("adapted")],
        later!(
            "The eye gets used to the colour of the light within a minute, so that white paper looks white under a bulb too. Surfaces can be shown as that eye sees them."
        ),
    ),
    word(
        later!("Aliasing"),
        &[later!("aliasing")],
        later!(
            "A false coarse pattern that samples show in place of a fine one, since they stand too far apart for it."
        ),
    ),
    word(
        later!("Band"),
        &[],
        later!("A stretch of wavelengths, wider than a line. Phosphors shine in bands."),
    ),
    word(
        later!("Basis"),
        &[],
        later!(
            "The family of waves that a smooth part is added up from, such as the paper's periodic ones (Fourier) or half-range cosines, which do not have to end as they began."
        ),
    ),
    word(
        later!("Beer-Lambert law"),
        &[
            later!("law of Beer and Lambert"),
            later!("Beer-Lambert law"),
        ],
        later!(
            "Each equal layer of a filter lets the same share of a wavelength through, so twice the thickness squares the share. Reflections at the surfaces are left out."
        ),
    ),
    word(
        later!("Black body"),
        &[later!("black body"), later!("black bodies")],
        later!(
            "A body that absorbs all light, so that what it sends out is the glow of its heat alone. A bulb's wire is nearly one; its temperature decides its colour."
        ),
    ),
    word(
        later!("CCT"),
        &[
            later!("CCT"),
            later!("correlated colour temperature"),
            later!("colour temperature"),
        ],
        later!(
            "Correlated colour temperature: the temperature of the black body whose colour comes nearest, in kelvin. Low is warm, high is cool."
        ),
    ),
    word(
        later!("Chromaticity"),
        &[later!("chromaticity"), later!("chromaticity diagram")],
        later!("Colour without brightness: two numbers, x and y, or u' and v'."),
    ),
    word(
        later!("CIE"),
        &[],
        later!(
            "The International Commission on Illumination, which defines the observers, the standard lights and the measures of colour difference used here."
        ),
    ),
    word(later!("CIEDE2000"), &[], later!("See Delta E (ΔE₀₀).")),
    word(
        later!("Colour-exact"),
        &[],
        later!(
            "The model's smooth part is adjusted so that its X, Y and Z are exactly those of the spectrum. It costs no numbers."
        ),
    ),
    word(
        later!("Colour-matching functions"),
        &[later!("colour-matching function")],
        later!(
            "Three curves that say how strongly each wavelength acts on the standard observer's X, Y and Z."
        ),
    ),
    word(
        later!("Composite model"),
        &[later!("composite")],
        later!(
            "A spectrum as a smooth part, which few waves describe, and a few lines, each a place and a weight."
        ),
    ),
    word(
        later!("Cone"),
        &[later!("cone")],
        later!(
            "A cell of the retina that colour is seen with by day. There are three kinds; each adds up the light that it catches under one broad curve."
        ),
    ),
    word(
        later!("Cosine basis"),
        &[],
        later!(
            "Cosines of half the range: the same count of numbers as the Fourier series, without its ringing at the ends."
        ),
    ),
    word(
        later!("D65"),
        &[later!("D65"), later!("CIE D65")],
        later!("The CIE's standard daylight, about 6500 kelvin."),
    ),
    word(
        later!("Delta E (ΔE₀₀)"),
        &[later!("ΔE₀₀"), later!("colour difference")],
        later!(
            "CIEDE2000, the difference between two colours. Below about 1 hardly anyone sees it, up to 2 only side by side, above 5 it is large. Half of the observers see 0.8 (Paravina et al. 2015, ISO/TR 28642)."
        ),
    ),
    word(
        later!("Dispersion"),
        &[later!("dispersion")],
        later!(
            "Glass, water and diamond bend short wavelengths more than long ones: light fans out into its colours."
        ),
    ),
    word(
        later!("Duv"),
        &[later!("Duv")],
        later!(
            "Distance of a white from the line of black bodies: above it (positive) greenish, below it pinkish."
        ),
    ),
    word(
        later!("Efficacy"),
        &[later!("efficacy")],
        later!(
            "Lumens per watt. The efficacy of radiation counts the watts of the light alone, that of a lamp the watts from the socket, and is lower."
        ),
    ),
    word(
        later!("Emission line"),
        &[later!("emission line"), later!("bright line")],
        later!(
            "Light of (nearly) one wavelength, given off by the atoms of a gas. The model keeps it as a place and a weight."
        ),
    ),
    word(
        later!("Energy level"),
        &[later!("energy level")],
        later!(
            "One of the energies that an electron in an atom can have. A fall from one to a lower one sends out light of one wavelength."
        ),
    ),
    word(
        later!("Error against waves"),
        &[],
        later!(
            "How far the model is off with every number of waves: where the curve falls below 1, the difference is hard to see on those surfaces."
        ),
    ),
    word(later!("Fidelity"), &[later!("fidelity")], later!("See Rf.")),
    word(
        later!("Filter"),
        &[later!("filter")],
        later!("Glass or a gel that lets some wavelengths through and holds others back."),
    ),
    word(
        later!("Fluorescent lamp"),
        &[later!("fluorescent tube"), later!("fluorescent lamp")],
        later!(
            "Mercury vapour shines in a few lines, mostly ultraviolet; a phosphor on the glass turns that into visible bands. What leaves is lines on a glow."
        ),
    ),
    word(
        later!("Fourier series"),
        &[later!("Fourier series")],
        later!(
            "A sum of waves that repeat over the range, each with twice, three times ... the frequency of the first."
        ),
    ),
    word(
        later!("FWHM"),
        &[later!("FWHM")],
        later!(
            "Full width at half maximum: how wide a line or band is at half its height, in nanometres."
        ),
    ),
    word(
        later!("Gamut"),
        &[later!("gamut")],
        later!("The colours that a screen can show. A corner mark tells of one outside."),
    ),
    word(
        later!("Gibbs phenomenon"),
        &[later!("Gibbs phenomenon")],
        later!("See Ringing."),
    ),
    word(
        later!("Grating"),
        &[later!("grating")],
        later!(
            "Many fine parallel lines that send each wavelength into a direction of its own. The tracks of a CD are one."
        ),
    ),
    word(
        later!("Illuminant"),
        &[later!("illuminant")],
        later!(
            "A standard light, defined by a table of its spectrum, such as A, D65 or the fluorescent FL series."
        ),
    ),
    word(
        later!("Infrared"),
        &[later!("infrared")],
        later!(
            "Radiation of longer wavelengths than red, from about 780 nm on. The eye does not see it; warm bodies send it out."
        ),
    ),
    word(
        later!("Kelvin"),
        &[later!("kelvin")],
        later!(
            "The unit of temperature, counted from absolute zero: 0 °C is 273.15 K. Whites are named by the temperature of the black body that comes nearest."
        ),
    ),
    word(
        later!("LED"),
        &[later!("LED")],
        later!(
            "A light-emitting diode. White ones are mostly a blue diode with a yellow phosphor."
        ),
    ),
    word(
        later!("Line"),
        &[],
        later!("See emission line and absorption line."),
    ),
    word(
        later!("Lumen"),
        &[later!("lumen"), later!("lm/W")],
        later!(
            "The unit of light as the eye weighs it: one watt at 555 nm is 683 lumens, at 450 nm only about 26."
        ),
    ),
    word(
        later!("Luminance"),
        &[later!("luminance")],
        later!("Brightness of light to the eye: the Y of X, Y, Z."),
    ),
    word(
        later!("Melanopic"),
        &[later!("melanopic"), later!("melanopic ratio")],
        later!(
            "Weighed as the cells that set the body's clock weigh light, most near 490 nm. The melanopic ratio (DER) compares a light with daylight D65 of the same illuminance."
        ),
    ),
    word(
        later!("Metamers"),
        &[later!("metamer")],
        later!("Two spectra of the same colour: equal under one light, perhaps not under another."),
    ),
    word(
        later!("Monochromator"),
        &[later!("monochromator")],
        later!(
            "An instrument that lets one narrow band of wavelengths through its slit at a time."
        ),
    ),
    word(
        later!("Nanometre"),
        &[later!("nanometre")],
        later!(
            "A millionth of a millimetre, nm. Visible light has wavelengths from about 380 to 780 nm."
        ),
    ),
    word(
        later!("Noise"),
        &[later!("noise")],
        later!(
            "Random differences between readings of the same light. The mean of many readings has less of it."
        ),
    ),
    word(
        later!("Numbers"),
        &[],
        later!(
            "The size of a model: 2N + 1 for N waves, and two for each line. A table from 380 to 780 nm takes 401."
        ),
    ),
    word(
        later!("Nyquist's rule"),
        &[later!("Nyquist's rule")],
        later!(
            "Samples show only waves that are at least twice as long as the samples are apart; of shorter ones they make false long ones."
        ),
    ),
    word(
        later!("Observer"),
        &[later!("standard observer")],
        later!(
            "The CIE's standard eye: of 1931 for what is 2 degrees wide, of 1964 for what is 10 degrees wide, of 2015 from the cones themselves."
        ),
    ),
    word(
        later!("Overlay"),
        &[],
        later!(
            "A spectrum that is drawn over the first one: lights of relative units equally bright (of equal luminance), surfaces as they are."
        ),
    ),
    word(
        later!("Phosphor"),
        &[later!("phosphor")],
        later!("A powder that turns short wavelengths into longer ones, in bands of its own."),
    ),
    word(
        later!("Photon"),
        &[later!("photon")],
        later!(
            "The smallest portion of light. Its energy is Planck's constant times the speed of light over the wavelength: a violet one has more than a red one."
        ),
    ),
    word(
        later!("Planck's law"),
        &[later!("Planck's law")],
        later!(
            "The spectrum of a black body at each temperature. The hotter it is, the more it glows at every wavelength."
        ),
    ),
    word(
        later!("R13"),
        &[later!("R13")],
        later!("Score of a light skin in the colour rendering index. It is not part of Ra."),
    ),
    word(
        later!("R9"),
        &[later!("R9")],
        later!(
            "Score of a strong red in the colour rendering index. It is not part of Ra, and can fall below 0."
        ),
    ),
    word(
        later!("Ra"),
        &[later!("Ra")],
        later!(
            "General colour rendering index: the mean score of eight pale test colours. 100 means that they look as under the reference light."
        ),
    ),
    word(
        later!("Reference light"),
        &[later!("reference light")],
        later!(
            "The light that colour rendering is compared with, of the same colour temperature: a black body where the light is warm, daylight where it is cool."
        ),
    ),
    word(
        later!("Reflectance"),
        &[later!("reflectance")],
        later!("The share of each wavelength that a surface sends back, 0 to 1."),
    ),
    word(
        later!("Refraction"),
        &[later!("refraction")],
        later!(
            "Light changes its direction where it enters glass or water, because it travels slower there. Violet is slowed more than red."
        ),
    ),
    word(
        later!("Residual"),
        &[later!("residual")],
        later!("Model minus measured: the part of a spectrum that the model does not have."),
    ),
    word(
        later!("Rf"),
        &[later!("Rf")],
        later!(
            "Fidelity index of TM-30, 0 to 100: the smaller the changes of 99 surfaces against the reference light, the higher."
        ),
    ),
    word(
        later!("Rg"),
        &[later!("Rg")],
        later!(
            "Gamut index of TM-30: above 100 colours are more vivid on average than under the reference light, below 100 duller."
        ),
    ),
    word(
        later!("Ringing"),
        &[later!("ringing")],
        later!(
            "Waves beside a jump or a narrow line: a series that stops early overshoots on both sides. Also called the Gibbs phenomenon."
        ),
    ),
    word(
        later!("rms"),
        &[later!("rms")],
        later!(
            "Root mean square: the size of an error over a whole curve, given here as a share of the spectrum."
        ),
    ),
    word(
        later!("Sampling"),
        &[later!("sampling"), later!("sample")],
        later!(
            "A curve kept as its values at chosen places. Anything narrow between two of them is lost."
        ),
    ),
    word(
        later!("Slit"),
        &[later!("slit")],
        later!(
            "The opening of an instrument, which decides how wide a band it takes in at once. A wide one blurs lines and keeps their power."
        ),
    ),
    word(
        later!("Smooth part"),
        &[later!("smooth part")],
        later!("The rest of a spectrum without its lines: few waves describe it."),
    ),
    word(
        later!("Spectral power distribution"),
        &[],
        later!("How much light there is at each wavelength: the spectrum itself."),
    ),
    word(
        later!("Spectrometer"),
        &[later!("spectrometer"), later!("spectroscope")],
        later!("An instrument that records the power of light at each wavelength."),
    ),
    word(
        later!("Spike"),
        &[later!("spike")],
        later!(
            "A line in the model: a place in nanometres and a weight, the power in it. In the paper it has no width; \"As wide as they are\" gives it one."
        ),
    ),
    word(
        later!("sRGB"),
        &[later!("sRGB")],
        later!(
            "The colours of ordinary screens. Of a colour outside, what the screen cannot show is cut off: a corner marks it, and what is shown is not the nearest colour."
        ),
    ),
    word(
        later!("Surface"),
        &[],
        later!(
            "Something of known reflectance, shown as it looks under the measured light and under the model."
        ),
    ),
    word(
        later!("Threshold"),
        &[later!("threshold")],
        later!("The least share of the power that a line must hold to be kept as a line."),
    ),
    word(later!("Tint"), &[later!("tint")], later!("See Duv.")),
    word(
        later!("TM-30"),
        &[later!("TM-30")],
        later!(
            "The method of ANSI/IES for colour rendition: 99 surfaces in 16 hues, with Rf, Rg and a drawing of how each hue shifts."
        ),
    ),
    word(
        later!("Transmittance"),
        &[later!("transmittance")],
        later!("The share of each wavelength that a filter lets through, 0 to 1."),
    ),
    word(
        later!("Triphosphor lamp"),
        &[later!("three-band tube"), later!("triphosphor")],
        later!(
            "A fluorescent lamp whose phosphors shine in a blue, a green (terbium) and a red (europium) band."
        ),
    ),
    word(
        later!("Ultraviolet"),
        &[later!("ultraviolet")],
        later!(
            "Radiation of shorter wavelengths than violet, below about 380 nm. It is not seen; it makes phosphors glow and harms eyes and skin."
        ),
    ),
    word(
        later!("Wavelength"),
        &[later!("wavelength")],
        later!(
            "The length of a wave of light, which decides its pure colour, in nanometres: 450 blue, 550 green, 650 red."
        ),
    ),
    word(
        later!("Waves"),
        &[],
        later!(
            "The waves that draw the smooth part, N of them: the shortest fits N times into the range. None is a level line. They are not waves of light."
        ),
    ),
    word(
        later!("Weight"),
        &[],
        later!(
            "The power of a line, in the spectrum's unit times nanometres; on screen its share of the power is told."
        ),
    ),
    word(
        later!("Wien's law"),
        &[later!("Wien's law")],
        later!(
            "The wavelength at which a black body is strongest is 2.898 million nm K divided by its temperature."
        ),
    ),
    word(
        later!("XYZ"),
        &[later!("X, Y and Z")],
        later!(
            "Three numbers that decide a colour: the spectrum weighed by the three colour-matching functions. Y is the brightness."
        ),
    ),
];

const fn word(word: &'static str, forms: &'static [&'static str], means: &'static str) -> Word {
    Word { word, forms, means }
}
