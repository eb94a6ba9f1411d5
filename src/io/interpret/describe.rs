//! Everything that was found and decided in words: the line of provenance, the notes, and what a
//! person may be asked. Nothing is decided here, and no sentence is changed afterwards.

use crate::io::choices::Counted;
use crate::io::reading::decision::AxisDecision;
use crate::io::reading::facts::Facts;
use crate::io::reading::remark::{Remark, unit_words};
use crate::io::reading::{Guessed, OpenQuestion, provenance};
use crate::io::{Choices, Reading};
use crate::languages::{said, with_sign};
use crate::spectrum::NamedSpectrum;

/// Spectra of one file of which it is kept how they were understood; of the others the guesses
/// tell enough.
pub(crate) const MOST_UNDERSTOOD: usize = 64;

/// Ends a reading: all is put in words.
pub(crate) fn finish(choices: &Choices, reading: &mut Reading) {
    if let Some(kind) = choices.kind {
        let models = reading.composites.iter_mut();
        models.for_each(|model| model.kind = kind);
        if reading.spectra.is_empty() {
            reading.guesses.retain(|guess| guess.what != Guessed::Kind);
        }
    }
    let mut guesses = Vec::new();
    for (index, facts) in std::mem::take(&mut reading.facts).into_iter().enumerate() {
        let Some(spectrum) = reading.spectra.get_mut(index) else {
            break;
        };
        guesses.extend(guesses_of(&facts, index));
        let decisions = facts.decisions.clone();
        let line = tell(spectrum, facts);
        if index == 0 && reading.images.is_empty() {
            reading.notes.insert(0, reading.in_front.clone() + &line);
        }
        if index < MOST_UNDERSTOOD {
            reading.understood.push(decisions);
        }
    }
    guesses.append(&mut reading.guesses);
    reading.guesses = guesses;
}

/// Writes the notes of a spectrum, those of its reader last; gives its line of provenance.
fn tell(spectrum: &mut NamedSpectrum, facts: Facts) -> String {
    let Facts {
        decisions,
        against: _,
        how,
        tells_scale,
        remarks,
    } = facts;
    let scale = match decisions.counted.as_ref().map(|counted| counted.value) {
        Some(Counted::Percent) if tells_scale => said!("from per cent"),
        Some(Counted::TenThousandths) if tells_scale => said!("from ten thousandths"),
        Some(Counted::SixteenBits) if tells_scale => said!("from 16-bit numbers"),
        Some(Counted::EightBits) if tells_scale => said!("from 8-bit numbers"),
        _ => "",
    };
    let mut words = vec![scale];
    words.extend(how.iter().map(String::as_str));
    let line = provenance(spectrum, &words);
    let of_reader = std::mem::take(&mut spectrum.notes);
    for remark in remarks {
        let note = match remark {
            Remark::Line => Some(line.clone()),
            Remark::Before(note) if line.starts_with(&note) => None,
            other => other.words(&decisions),
        };
        spectrum.notes.extend(note);
    }
    spectrum.notes.extend(of_reader);
    line
}

/// The guesses made about a spectrum.
fn guesses_of(facts: &Facts, spectrum: usize) -> impl Iterator<Item = OpenQuestion> {
    let guess = |what, chosen: String, reason: &str, plain| OpenQuestion {
        spectrum,
        what,
        chosen,
        because: reason.to_owned(),
        plain,
    };
    let decisions = &facts.decisions;
    let axis = match &decisions.axis {
        Some(AxisDecision::Unit(unit)) if unit.is_guess() => {
            let words = unit_words(unit.value, facts.against.as_deref());
            Some(guess(Guessed::WavelengthUnit, words, &unit.reason, false))
        }
        Some(AxisDecision::Laser(laser)) => {
            let words = tr!(
                "Raman shift from {laser} nm",
                laser = with_sign(laser.value.to_string())
            );
            Some(guess(Guessed::WavelengthUnit, words, &laser.reason, true))
        }
        _ => None,
    };
    let kind = decisions.kind.is_guess().then(|| {
        let kind = &decisions.kind;
        let word = said(kind.value.word()).to_owned();
        guess(Guessed::Kind, word, &kind.reason, !kind.is_doubtful())
    });
    let counted = decisions.counted.as_ref();
    let counted = counted.filter(|counted| counted.is_guess()).map(|counted| {
        let word = said(counted.value.word()).to_owned();
        let plain = !counted.is_doubtful();
        guess(Guessed::Percent, word, &counted.reason, plain)
    });
    [axis, kind, counted].into_iter().flatten()
}
