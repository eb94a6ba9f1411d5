//! What readers that are no tables found, put beside what a person decided.
//!
//! Tables hear of decisions while they are read. Formats that know what their numbers are need
//! not: here kind and scale of what they read are turned round afterwards, and how each spectrum
//! and image was understood is written down for the person who looks.

use super::reading::{AxisTold, Guess, Guessed, Reading, Told, Understood};
use super::{Choices, Counted, choices::OfOne, meaning};
use crate::spectrum::{Kind, NamedSpectrum, SpectralImage};

/// What is said of a decision that a person took.
pub const BY_HAND: &str = "chosen by hand";

/// What is noted where a person said what the values are.
const CHOSEN_KIND: &str = "the kind was chosen by hand";

/// Spectra of one file of which it is kept how they were understood; of the others the guesses
/// tell enough.
pub const MOST_UNDERSTOOD: usize = 64;

/// How many pixels are looked at where the size of an image's values must tell their scale.
const PIXELS_LOOKED_AT: usize = 400;

/// Carries out what a person decided and writes down how everything was understood;
/// `large_numbers` says that factors may be stored as whole numbers to 10,000.
pub fn settle(large_numbers: bool, choices: &Choices, reading: &mut Reading) {
    if let Some(kind) = choices.kind {
        let models = reading.composites.iter_mut();
        models.for_each(|model| model.kind = kind);
        if reading.spectra.is_empty() {
            reading.guesses.retain(|guess| guess.what != Guessed::Kind);
        }
    }
    settle_images(choices, large_numbers, reading);
    // Tables wrote it down themselves, from the first spectrum on.
    if reading.understood.is_empty() {
        settle_spectra(choices, large_numbers, reading);
    }
    agree(reading);
}

/// Kind and scale of something on their way through a person's decisions.
struct Meant<'a> {
    kind: &'a mut Kind,
    unit: &'a mut String,
    scale: &'a mut f64,
    notes: &'a mut Vec<String>,
}

/// What was guessed of one spectrum or image, by what.
#[derive(Clone, Default)]
struct Guesses {
    kind: Option<Guess>,
    counted: Option<Guess>,
}

fn settle_images(choices: &Choices, large_numbers: bool, reading: &mut Reading) {
    let guesses = std::mem::take(&mut reading.image_guesses);
    for (index, image) in reading.images.iter_mut().enumerate() {
        let own = choices.each_image.get(&index).copied().unwrap_or_default();
        let chosen = OfOne {
            kind: own.kind.or(choices.kind),
            counted: own.counted.or(choices.counted),
        };
        let of_it = |what| {
            let mut all = guesses.iter();
            all.find(|g| g.spectrum == index && g.what == what).cloned()
        };
        let mut found = Guesses {
            kind: of_it(Guessed::Kind),
            counted: of_it(Guessed::Percent),
        };
        let SpectralImage {
            name: _,
            kind,
            unit,
            scale,
            cube,
            notes,
            source: _,
        } = image;
        let values = || {
            let pixels = cube.width() * cube.height();
            (0..pixels)
                .step_by(pixels.div_ceil(PIXELS_LOOKED_AT).max(1))
                .flat_map(|i| cube.values_at(i % cube.width(), i / cube.width()))
                .collect()
        };
        let meant = Meant {
            kind,
            unit,
            scale,
            notes,
        };
        let was = format!(", {},", meant.kind.word());
        decide(meant, chosen, &mut found, large_numbers, index, values);
        if let Some(line) = notes.first_mut() {
            *line = line.replacen(&was, &format!(", {},", kind.word()), 1);
            if index == 0 {
                reading.notes.clone_from(notes);
            }
        }
        reading.images_understood.push(understood(
            (*kind, *scale),
            chosen,
            &found,
            reading.axis.as_ref(),
        ));
    }
}

fn settle_spectra(choices: &Choices, large_numbers: bool, reading: &mut Reading) {
    let mut of_each = vec![Guesses::default(); reading.spectra.len()];
    let mut others = Vec::new();
    for guess in std::mem::take(&mut reading.guesses) {
        match (of_each.get_mut(guess.spectrum), guess.what) {
            (Some(found), Guessed::Kind) => found.kind = Some(guess),
            (Some(found), Guessed::Percent) => found.counted = Some(guess),
            _ => others.push(guess),
        }
    }
    // The pixels of an image are counted as the image is.
    let of_image = reading.images_understood.first().and_then(|image| {
        let counted = image.counted.as_ref()?;
        let by_hand = choices.kind.is_some() || choices.counted.is_some();
        by_hand.then_some(counted.is)
    });
    for (index, spectrum) in reading.spectra.iter_mut().enumerate() {
        let chosen = OfOne {
            kind: choices.kind_of(index),
            counted: choices.counted_of(index).or(of_image),
        };
        let found = &mut of_each[index];
        let before = spectrum.scale;
        let said = meaning_in_words(spectrum);
        let NamedSpectrum {
            name: _,
            kind,
            unit,
            scale,
            samples,
            notes,
            source: _,
        } = spectrum;
        let meant = Meant {
            kind,
            unit,
            scale,
            notes,
        };
        let values = || samples.values().iter().map(|v| v / before).collect();
        decide(meant, chosen, found, large_numbers, index, values);
        if *scale != before {
            *samples = samples.scaled(*scale / before);
        }
        let says = meaning_in_words(spectrum);
        if says != said {
            restate(spectrum.notes.first_mut(), &said, &says);
            if index == 0 {
                restate(reading.notes.first_mut(), &said, &says);
            }
        }
        let NamedSpectrum { kind, scale, .. } = spectrum;
        if index < MOST_UNDERSTOOD {
            let told = understood((*kind, *scale), chosen, found, reading.axis.as_ref());
            reading.understood.push(told);
        }
    }
    let kept = of_each.into_iter().flat_map(|g| [g.kind, g.counted]);
    reading.guesses = kept.flatten().chain(others).collect();
}

/// The part of a line of provenance that tells kind, unit and scale.
fn meaning_in_words(spectrum: &NamedSpectrum) -> [String; 2] {
    let mut words = format!(", {}", spectrum.kind.word());
    if !spectrum.unit.is_empty() && spectrum.unit != spectrum.kind.word() {
        words += ", ";
        words += &spectrum.unit;
    }
    let is_percent = spectrum.kind.is_factor() && spectrum.scale == 0.01;
    let percent = if is_percent { ", from per cent" } else { "" };
    [words, percent.to_owned()]
}

/// Puts what was chosen into a line of provenance.
fn restate(line: Option<&mut String>, said: &[String; 2], says: &[String; 2]) {
    if let Some(line) = line
        && line.contains(&said[0])
    {
        if !said[1].is_empty() {
            *line = line.replacen(&said[1], "", 1);
        }
        *line = line.replacen(&said[0], &says.concat(), 1);
    }
}

/// Takes back what was said of a guess.
fn unsay(notes: &mut Vec<String>, guess: Option<Guess>) {
    if let Some(Guess {
        chosen, because, ..
    }) = guess
    {
        let said = format!("taken as {chosen}: {because}");
        notes.retain(|note| *note != said);
    }
}

/// Turns kind and scale round as a person decided; `values` are the file's own numbers.
fn decide(
    meant: Meant,
    chosen: OfOne,
    found: &mut Guesses,
    large_numbers: bool,
    index: usize,
    values: impl Fn() -> Vec<f64>,
) {
    let was = *meant.kind;
    if let Some(kind) = chosen.kind {
        unsay(meant.notes, found.kind.take());
        if kind != was {
            *meant.kind = kind;
            meant.notes.push(CHOSEN_KIND.to_owned());
        }
    }
    let kind = *meant.kind;
    // A scale that nothing states was that of a factor.
    let scale_is_open = found.counted.is_some() || !was.is_factor() && *meant.scale == 1.0;
    if !kind.is_factor() {
        if let Some(guess) = found.counted.take() {
            unsay(meant.notes, Some(guess));
            *meant.scale = 1.0;
        }
        if was.is_factor() || kind == Kind::Absorbance && kind != was {
            meant.unit.clear();
        }
        return;
    }
    if !was.is_factor() {
        "fraction".clone_into(meant.unit);
    }
    if let Some(scale) = chosen.counted.and_then(Counted::scale) {
        unsay(meant.notes, found.counted.take());
        *meant.scale = scale;
    } else if kind != was && !was.is_factor() && scale_is_open {
        let values = values();
        let size = meaning::percent("", &[], false, &values);
        let mut counted = Counted::percent(size.percent);
        if large_numbers && meaning::largest(&values) > meaning::MOST_PERCENT {
            counted = Counted::TenThousandths;
        }
        *meant.scale = counted.scale().unwrap_or(1.0);
        let note = format!("taken as {}: {}", counted.word(), size.because);
        meant.notes.push(note);
        found.counted = Some(Guess {
            spectrum: index,
            what: Guessed::Percent,
            chosen: counted.word().to_owned(),
            because: size.because,
            plain: size.plain,
        });
    }
}

fn understood(
    (kind, scale): (Kind, f64),
    chosen: OfOne,
    found: &Guesses,
    axis: Option<&AxisTold>,
) -> Understood {
    Understood {
        axis: axis.cloned(),
        kind: told(kind, chosen.kind.is_some(), found.kind.as_ref()),
        counted: kind.is_factor().then(|| {
            let counted = Counted::of_scale(scale);
            told(counted, chosen.counted.is_some(), found.counted.as_ref())
        }),
    }
}

/// A decision: by hand, guessed, or the format's.
fn told<T>(is: T, by_hand: bool, guess: Option<&Guess>) -> Told<T> {
    let (because, stated) = match guess {
        _ if by_hand => (BY_HAND, true),
        Some(guess) => (guess.because.as_str(), false),
        None => ("its format", true),
    };
    Told {
        is,
        because: because.to_owned(),
        stated,
        plain: stated || guess.is_some_and(|guess| guess.plain),
    }
}

/// Spectra of one file are counted alike: what is plain of one is plain of the others, so that
/// nothing is asked about the black patch of a chart.
fn agree(reading: &mut Reading) {
    let is_counted = |guess: &&mut Guess| guess.what == Guessed::Percent;
    let plain: Vec<String> = {
        let all = reading.guesses.iter();
        let mut plain: Vec<String> = all
            .filter(|guess| guess.what == Guessed::Percent && guess.plain)
            .map(|guess| guess.chosen.clone())
            .collect();
        plain.sort_unstable();
        plain.dedup();
        plain
    };
    for guess in reading.guesses.iter_mut().filter(is_counted) {
        guess.plain |= plain.contains(&guess.chosen);
    }
    for told in reading.understood.iter_mut().flat_map(|u| &mut u.counted) {
        told.plain |= plain.iter().any(|word| *word == told.is.word());
    }
}
