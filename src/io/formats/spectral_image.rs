//! Output of readers of images: the picture, and its pixels where they are a list of patches rather
//! than a picture. Kind and scale are one decision for all pixels, made of the same parts as a
//! spectrum's.

use crate::spectrum::cube::Cube;
use crate::spectrum::{Kind, SpectralImage};

use crate::io::choices::{Counted, OfOne};
use crate::io::interpret::factor_scale::{by_size, decide_scale, or_large};
use crate::io::interpret::kind_as_chosen;
use crate::io::interpret::raw::Known;
use crate::io::reading::decision::{AxisDecision, Decision, Decisions};
use crate::io::reading::facts::Facts;
use crate::io::reading::provenance;
use crate::io::reading::remark::Remark;
use crate::io::{Choices, Reading, budget};
use crate::languages::{fixed, said};

/// Images of at most so many pixels are patches: each becomes a spectrum.
pub(crate) const MOST_PATCHES: usize = 64;

/// The number of pixels sampled to infer the scale of an image's values from their size.
const PIXELS_LOOKED_AT: usize = 400;

/// An image as its reader found it.
pub(crate) struct RawImage {
    pub name: String,
    pub source: String,
    /// The median width of its bands, nm, if given in the file.
    pub bandwidth_nm: Option<f64>,
    /// Its pixels in the file's own numbers.
    pub cube: Cube,
    /// Notes of its reader, a sentence each.
    pub notes: Vec<String>,
    /// The properties of the values known from the format.
    pub known: Known,
    /// The decision on its wavelengths, and a different unit named for them in the file.
    pub axis: Option<AxisDecision>,
    pub against: Option<String>,
}

/// The meaning of an image's values: kind, scale and unit.
pub(crate) struct Meant {
    /// The kind of the values.
    pub kind: Decision<Kind>,
    /// The unit in which factors are counted; `None` if the values are not factors.
    pub counted: Option<Decision<Counted>>,
    /// Factor from the file's numbers to the unit.
    pub scale: f64,
    /// Their unit, the scale applied.
    pub unit: String,
    /// The remark on a file that contradicts the chosen kind.
    against_choice: Option<Remark>,
}

impl Meant {
    /// Decides by the format and the user's choices, else by the values of some pixels.
    pub(crate) fn of(known: Known, chosen: OfOne, sample: impl FnOnce() -> Vec<f64>) -> Self {
        let Known {
            kind: own,
            unit,
            scale,
            may_be_large,
        } = known;
        let own = own.unwrap_or_else(|| Decision::of_format(Kind::Light));
        let was = own.value;
        let (kind, against_choice) = kind_as_chosen(own, chosen.kind);
        let (counted, scale) = decide_scale((kind.value, was), &scale, chosen.counted, || {
            let values = sample();
            or_large(by_size(&values), may_be_large, &values)
        });
        let unit = if kind.value.is_factor() {
            "fraction".to_owned()
        } else if was.is_factor() || kind.value == Kind::Absorbance {
            String::new()
        } else {
            unit.unwrap_or_default()
        };
        Self {
            kind,
            counted,
            scale,
            unit,
            against_choice,
        }
    }

    /// True if the kind is a guess, given neither by the file nor by the user.
    pub(crate) fn is_kind_guessed(&self) -> bool {
        self.kind.is_guess()
    }

    /// The guesses about the values, or contradictions to the file, a sentence each.
    pub(crate) fn notes(&self) -> Vec<String> {
        let decisions = Decisions {
            axis: None,
            kind: self.kind.clone(),
            counted: self.counted.clone(),
        };
        let of_kind = self.against_choice.clone().unwrap_or(Remark::Kind);
        guesses_in_words(&decisions, of_kind)
    }
}

/// The values of some pixels all over an image.
pub(crate) fn sample(cube: &Cube) -> Vec<f64> {
    let pixels = cube.width() * cube.height();
    (0..pixels)
        .step_by(pixels.div_ceil(PIXELS_LOOKED_AT).max(1))
        .flat_map(|i| cube.values_at(i % cube.width(), i / cube.width()))
        .collect()
}

/// Decides the properties of an image left open by its file and adds it to a reading.
pub(crate) fn add(raw: RawImage, choices: &Choices, reading: &mut Reading) {
    let index = reading.images.len();
    let of_it = choices.each_image.get(&index).copied().unwrap_or_default();
    let chosen = OfOne {
        kind: of_it.kind.or(choices.kind),
        counted: of_it.counted.or(choices.counted),
    };
    let (cube, against) = (raw.cube, raw.against);
    let meant = Meant::of(raw.known, chosen, || sample(&cube));
    let mut notes = vec![line_of(&cube, meant.kind.value)];
    notes.extend(raw.notes);
    notes.extend(meant.notes());
    reading.notes.extend(notes.iter().cloned());
    let image = SpectralImage {
        name: raw.name,
        kind: meant.kind.value,
        unit: meant.unit,
        scale: meant.scale,
        bandwidth_nm: raw.bandwidth_nm,
        cube,
        notes,
        source: raw.source,
    };
    let decisions = Decisions {
        axis: raw.axis,
        kind: meant.kind,
        counted: meant.counted,
    };
    add_patches(&image, &decisions, against.as_ref(), reading);
    reading.images_understood.push(decisions);
    reading.images.push(image);
}

/// The guesses about all pixels or spectra of a file, or another remark on their kind, in words.
pub(crate) fn guesses_in_words(decisions: &Decisions, of_kind: Remark) -> Vec<String> {
    let counted = decisions.counted.as_ref();
    let counted = counted.filter(|counted| counted.is_guess());
    let remarks = [Some(of_kind), counted.map(|_| Remark::Counted)];
    let words = |remark: Remark| remark.words(decisions);
    remarks.into_iter().flatten().filter_map(words).collect()
}

/// One line about an image.
fn line_of(cube: &Cube, kind: Kind) -> String {
    let nm = cube.nm();
    tr!(
        "image of {width} x {height} pixels, {n} bands, {from}-{to} nm, {kind}, {size} of memory"
            | "image of {width} x {height} pixels, {n} bands, {from}-{to} nm, {kind}, {size} of \
               memory"
                % nm.len(),
        width = cube.width(),
        height = cube.height(),
        from = fixed(nm[0], 1),
        to = fixed(nm[nm.len() - 1], 1),
        kind = said(kind.word()),
        size = budget::in_words(cube.memory())
    )
}

/// Adds the pixels of an image of patches.
fn add_patches(
    image: &SpectralImage,
    decisions: &Decisions,
    against: Option<&String>,
    reading: &mut Reading,
) {
    let (width, height) = (image.cube.width(), image.cube.height());
    if width.saturating_mul(height) > MOST_PATCHES {
        return;
    }
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    for (x, y) in places {
        let Some(mut spectrum) = image.pixel(x, y) else {
            continue;
        };
        if (width, height) == (1, 1) {
            spectrum.name.clone_from(&image.name);
        }
        spectrum.notes[0] = provenance(&spectrum, &[]);
        reading.spectra.push(spectrum);
        reading.facts.push(Facts {
            decisions: decisions.clone(),
            against: against.cloned(),
            how: Vec::new(),
            tells_scale: false,
            remarks: Vec::new(),
        });
    }
}
