//! Known lamps and lines of their own width: the encoder, and one light encoded as a job.

use std::sync::{Arc, Mutex};

use super::Question;
use crate::{
    app::{document::Document, entry::Entry, memo::ByAddress},
    color::Observer,
    lamps::{
        Ask, Count, Encoded, Encoder, EncodingError, EvaluationSet, Ingredients, LeaveOut, NUMBERS,
        judged, namesakes,
    },
    spectrum::{Band, SpikeSettings},
    study::Progress,
};

/// What an encoder is made for.
type Maker = (Band, Observer, SpikeSettings);

/// The encoder of a range; the last one made is kept, since making one takes some tenths of a
/// second.
///
/// # Errors
/// [`EncodingError::Unseen`] when the range misses the visible, [`EncodingError::TooLong`] when it is
/// too long.
pub(super) fn encoder(maker: Maker) -> Result<Arc<Encoder>, EncodingError> {
    static LAST: Mutex<Option<(Maker, Arc<Encoder>)>> = Mutex::new(None);
    // Whoever panicked left the last encoder whole.
    let mut last = LAST.lock().unwrap_or_else(|e| e.into_inner());
    if let Some((_, encoder)) = last.as_ref().filter(|(known, _)| *known == maker) {
        return Ok(encoder.clone());
    }
    let (band, observer, spikes) = maker;
    let made = Arc::new(Encoder::new(band, observer, spikes)?);
    *last = Some((maker, made.clone()));
    Ok(made)
}

/// Most numbers of an encoding on a range.
pub fn most_numbers(band: Band) -> usize {
    NUMBERS[1].min(band.points() / 2).max(NUMBERS[0])
}

/// What is asked of a light in few words.
#[derive(Clone, Debug, PartialEq)]
pub struct EncodeAsk {
    pub light: ByAddress<Entry>,
    /// What the encoder is made for.
    pub maker: Maker,
    /// Most numbers.
    pub numbers: usize,
    /// Whether known lamps may be used.
    pub known_lamps: bool,
    /// Whether the light itself and its likes may be among them.
    pub itself: bool,
}

/// A light in few words.
#[derive(Clone, Debug, PartialEq)]
pub struct EncodedLight {
    /// The words, what they decode to and what that is off by.
    pub encoded: Encoded,
    /// What it is made of.
    pub makeup: Ingredients,
    /// The measured light on the grid.
    pub measured: Vec<f64>,
    /// What the words decode to.
    pub decoded: Vec<f64>,
    /// Of each known lamp its name and its part of the light.
    pub parts: Vec<(String, Vec<f64>)>,
}

impl EncodeAsk {
    /// The light of a document in so many numbers, as many as its range allows.
    pub fn of(document: &Document, numbers: usize, known_lamps: bool, itself: bool) -> Self {
        let settings = document.settings;
        Self {
            light: ByAddress(document.light.clone()),
            maker: (settings.band, settings.observer, settings.spike_settings()),
            numbers: numbers.clamp(NUMBERS[0], most_numbers(settings.band)),
            known_lamps,
            itself,
        }
    }

    fn encoded(&self) -> Result<EncodedLight, EncodingError> {
        let encoder = encoder(self.maker)?;
        let (band, observer, _) = self.maker;
        let spectrum = &self.light.0.spectrum;
        let measured = spectrum.samples.on_band(band, spectrum.kind.outside());
        let (leave_out, left_out) = match self.itself {
            true => (LeaveOut::None, Vec::new()),
            false => (LeaveOut::Likes, namesakes(&spectrum.name)),
        };
        let ask = Ask {
            numbers: self.numbers,
            count: Count::Words,
            known_lamps: self.known_lamps,
            leave_out,
        };
        let chosen = encoder.encode_without(&measured, ask, &left_out)?;
        let judge = EvaluationSet::judging(band, observer);
        let encoded = judged(
            &encoder,
            &judge,
            &measured,
            (&chosen.encoding, self.numbers),
        )?;
        let decoder = encoder.decoder();
        let decoded = decoder.decode(&encoded.encoding)?;
        let makeup = Ingredients::of(&encoded.encoding);
        let part = |part: &crate::lamps::Part| {
            let atom = decoder.atom(part.index)?;
            Some((part.shown(), atom.iter().map(|v| part.weight * v).collect()))
        };
        Ok(EncodedLight {
            parts: makeup.parts.iter().filter_map(part).collect(),
            encoded,
            makeup,
            measured,
            decoded,
        })
    }
}

impl Question for EncodeAsk {
    type Answer = Result<EncodedLight, String>;

    /// The answer, or a sentence that says why there is none; nothing when it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Result<EncodedLight, String>> {
        let found = self.encoded().map_err(|why| {
            tr!(
                "{light} cannot be encoded on this range: {why}.",
                light = self.light.0.name(),
                why
            )
        });
        (!progress.is_cancelled()).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, Command};

    fn asked(app: &App, known_lamps: bool, itself: bool) -> EncodedLight {
        EncodeAsk::of(app.document(), 20, known_lamps, itself)
            .answer(&Progress::default())
            .expect("not cancelled")
            .expect("a light")
    }

    #[test]
    fn a_lamp_is_itself_unless_it_is_left_out_and_of_no_lamps_when_portable() {
        let mut app = App::new();
        let fl2 = app.entry("cie_fluorescent_1nm/FL2").expect("shipped");
        app.apply(Command::Show(fl2));
        let is_fl2 = |found: &EncodedLight| found.parts.iter().any(|(t, _)| t.contains("FL2 "));
        let named = |found: &EncodedLight| {
            let parts = found.parts.iter();
            parts.map(|(title, _)| title.clone()).collect::<Vec<_>>()
        };
        let itself = asked(&app, true, true);
        let others = asked(&app, true, false);
        let portable = asked(&app, false, false);
        assert!(named(&itself).iter().any(|t| t.starts_with("FL2")));
        assert!(!named(&others).contains(&"FL2".to_owned()) && !is_fl2(&others));
        assert!(!others.parts.is_empty() && portable.parts.is_empty());
        for found in [&itself, &others, &portable] {
            assert_eq!(found.encoded.words.len(), found.encoded.encoding.numbers());
            assert!(found.encoded.words.len() <= 20);
        }
        assert!(itself.encoded.errors.filters < others.encoded.errors.filters);
    }

    #[test]
    fn a_range_that_nobody_sees_gets_a_sentence() {
        let mut app = App::new();
        let band = Band::new(800.0, 900.0).expect("a range");
        app.apply(Command::Edit(crate::app::Settings {
            band,
            ..app.document().settings
        }));
        let found = EncodeAsk::of(app.document(), 20, true, true).answer(&Progress::default());
        let words = found.expect("not cancelled").expect_err("nothing is seen");
        assert!(words.ends_with('.') && !words.contains("NaN"), "{words}");
    }
}
