//! The choice of an encoding, step by step.
//!
//! 1. the goals are linearised at the exact light;
//! 2. a plain cosine series gives the weights of the goals;
//! 3. for every count of known lamps and lines that the numbers allow, a greedy search;
//! 4. the ten best, and the plain series, are stored, fitted again and measured by their true
//!    errors;
//! 5. the lines of the best three are moved and widened;
//! 6. today's ways are measured too, and the least true error wins.

use std::cmp::Ordering;

use super::{
    ask::{Ask, NUMBERS},
    encoder::Encoder,
    encoding::Encoding,
    error::EncodingError,
    judge::Errors,
    work::EncodeJob,
};
use crate::{
    spectrum::dot,
    study::{Measure, scaled_to_one},
};

/// An encoding that was chosen, with what chose it.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The encoding, in the unit of the values given.
    pub encoding: Encoding,
    /// Its errors on the panel that chooses.
    pub errors: Errors,
    /// CIEDE2000 of its own colour.
    pub own: f64,
}

impl Encoder {
    /// Encodes a light given on the band's grid.
    ///
    /// The result never has larger true errors, taken together as the choice takes them, than the
    /// best of today's ways with as many numbers.
    ///
    /// # Errors
    /// [`EncodingError`] for a count out of [`NUMBERS`], values of another length, values that are
    /// not finite, and a light without colour on the band.
    pub fn encode(&self, values: &[f64], ask: Ask) -> Result<Chosen, EncodingError> {
        self.encode_without(values, ask, &[])
    }

    /// [`Encoder::encode`] without the known lamps of these indices.
    ///
    /// # Errors
    /// As [`Encoder::encode`].
    pub(crate) fn encode_without(
        &self,
        values: &[f64],
        ask: Ask,
        left_out: &[u8],
    ) -> Result<Chosen, EncodingError> {
        let band = self.panel.band();
        let most = NUMBERS[1].min(band.points() / 2);
        if !(NUMBERS[0]..=most).contains(&ask.numbers) {
            return Err(EncodingError::Numbers {
                found: ask.numbers,
                expected: [NUMBERS[0], most],
            });
        }
        if values.len() != band.points() {
            return Err(EncodingError::Points {
                found: values.len(),
                expected: band.points(),
            });
        }
        if let Some(index) = values.iter().position(|v| !v.is_finite()) {
            return Err(EncodingError::NotFinite { index });
        }
        let unit = scaled_to_one(values).ok_or(EncodingError::NoColour { band })?;
        let height = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let exact = self
            .panel
            .exact(&unit)
            .ok_or(EncodingError::NoColour { band })?;
        let work = EncodeJob::new(self, exact, ask.numbers);
        let mut usable = self.usable(&unit, ask);
        for (usable, atom) in usable.iter_mut().zip(self.decoder.atoms()) {
            *usable &= !left_out.contains(&atom.index);
        }
        let best = work.best(&usable, ask);
        let own_values = self.decoder.decode(&best.encoding)?;
        let own = work.exact.figure(Measure::Own, &own_values, &[]);
        Ok(Chosen {
            own: own.unwrap_or(f64::INFINITY),
            errors: best.errors,
            encoding: best.encoding.scaled(height),
        })
    }

    /// Mask of the known lamps that may be used.
    fn usable(&self, light: &[f64], ask: Ask) -> Vec<bool> {
        let atoms = self.decoder.atoms();
        if !ask.known_lamps {
            return vec![false; atoms.len()];
        }
        let norm = |values: &[f64]| dot(values, values).sqrt();
        let own = norm(light);
        let cosine = |atom: &[f64]| dot(atom, light) / (norm(atom) * own);
        let most = ask.leave_out.most();
        // An atom with no cosine to speak of stays.
        let is_other = |atom: &[f64]| cosine(atom).partial_cmp(&most) != Some(Ordering::Greater);
        atoms.iter().map(|a| is_other(&a.values)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::Observer,
        spectrum::{Band, SpikeSettings},
    };
    use crate::{
        lamps::{
            LeaveOut,
            fit::{FIRST_WEIGHTS, score},
        },
        preset::table,
        spectrum::{Line, Outside},
    };

    #[test]
    fn no_way_of_today_is_better_on_what_chooses() {
        let band = Band::VISIBLE;
        let encoder =
            Encoder::new(band, Observer::CIE_1931, SpikeSettings::default()).expect("the visible");
        let lines = [404.7, 435.8, 546.1, 577.0, 579.1, 690.7].map(|at_nm| Line::ideal(at_nm, 1.0));
        let mut mercury = vec![0.0; band.points()];
        crate::spectrum::add_lines(band, &lines, &mut mercury);
        let fl2 = table("cie_fluorescent_1nm", "FL2")
            .expect("shipped")
            .on_band(band, Outside::Zero);
        for light in [mercury, fl2] {
            let unit = scaled_to_one(&light).expect("light");
            for numbers in [11, 15, 20] {
                let ask = Ask::numbers(numbers).in_comparison();
                let chosen = encoder.encode(&light, ask).expect("a light");
                let exact = encoder.panel.exact(&unit).expect("a colour");
                let work = EncodeJob::new(&encoder, exact, numbers);
                let own = score(chosen.errors.to_array(), work.small);
                for way in work.today() {
                    let theirs = work
                        .measured(way, FIRST_WEIGHTS, Vec::new())
                        .expect("numbers");
                    assert!(own <= theirs.score, "{numbers}: {own} {}", theirs.score);
                }
            }
        }
    }

    #[test]
    fn a_stricter_rule_leaves_out_more_lamps() {
        let encoder = Encoder::new(Band::VISIBLE, Observer::CIE_1931, SpikeSettings::default())
            .expect("the visible");
        let light = table("cie_fluorescent_1nm", "FL3.15")
            .expect("shipped")
            .on_band(Band::VISIBLE, Outside::Zero);
        let left = |leave_out| {
            let ask = Ask {
                leave_out,
                ..Ask::numbers(20)
            };
            encoder
                .usable(&light, ask)
                .iter()
                .filter(|usable| **usable)
                .count()
        };
        let [all, itself, likes] = [LeaveOut::None, LeaveOut::Itself, LeaveOut::Likes].map(left);
        assert!(
            all > itself && itself >= likes && likes > 0,
            "{all} {itself} {likes}"
        );
    }
}
