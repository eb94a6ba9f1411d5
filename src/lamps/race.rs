//! Known lamps and wide lines in the race.
//!
//! No table holds the light at hand: principal components are those trained without it, its
//! namesakes and its likes. Known lamps are left out by the same rule ([`LeaveOut::Likes`] and
//! namesakes), or only those that are the light itself ([`LeaveOut::Itself`]), which keeps the 5 nm
//! table of a lamp raced at 1 nm.

use std::sync::Arc;

use super::{
    ask::{Ask, Count, LeaveOut, NUMBERS},
    encoder::Encoder,
    encoding::Encoding,
    known::namesakes,
};
use crate::study::race::{Encode, Encoded, Lamp};

/// An encoder with the rules of a race.
#[derive(Clone, Debug)]
pub(crate) struct Racing {
    /// The encoder.
    pub encoder: Arc<Encoder>,
    /// Counting rule for numbers.
    pub count: Count,
    /// Rule for leaving known lamps out.
    pub leave_out: LeaveOut,
}

impl Encode for Racing {
    fn encoded(&self, lamp: &Lamp, numbers: usize, known_lamps: bool) -> Option<Box<dyn Encoded>> {
        let band = self.encoder.panel().band();
        let ask = Ask {
            numbers: numbers.min(NUMBERS[1]).min(band.points() / 2),
            count: self.count,
            known_lamps,
            leave_out: self.leave_out,
        };
        let left_out = match self.leave_out {
            LeaveOut::None | LeaveOut::Itself => Vec::new(),
            LeaveOut::Likes => namesakes(&lamp.name),
        };
        let chosen = self
            .encoder
            .encode_without(&lamp.values, ask, &left_out)
            .ok()?;
        Some(Box::new(Stored {
            encoder: self.encoder.clone(),
            numbers: match self.count {
                Count::Words => chosen.encoding.numbers(),
                Count::Strict => chosen.encoding.strict_numbers(),
            },
            encoding: chosen.encoding,
        }))
    }
}

struct Stored {
    encoder: Arc<Encoder>,
    encoding: Encoding,
    numbers: usize,
}

impl Encoded for Stored {
    fn numbers(&self) -> usize {
        self.numbers
    }

    fn lines(&self) -> usize {
        self.encoding.lines.len()
    }

    fn bytes(&self) -> usize {
        self.encoding.numbers() * size_of::<u32>()
    }

    fn on_band(&self) -> Vec<f64> {
        let decoder = self.encoder.decoder();
        // The encoder has what it used itself.
        decoder.decode(&self.encoding).unwrap_or_default()
    }

    fn at(&self, nm: f64) -> f64 {
        self.encoder.decoder().at(&self.encoding, nm)
    }
}
