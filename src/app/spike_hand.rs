//! Editing spikes by hand: each act turns the present spikes into new hand edits.

use crate::spectrum::{Decomposed, HandSpike, ModelSpike, SpikeEdits};

/// What a person does to one spike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpikeAct {
    /// Puts it elsewhere or gives it another weight; it is locked from then on.
    Set {
        /// Index into the model's spikes.
        index: usize,
        /// New place, nm.
        at_nm: f64,
        /// New weight, in the spectrum's unit x nm.
        weight: f64,
    },
    /// Keeps it against re-detection.
    Lock {
        /// Index into the model's spikes.
        index: usize,
    },
    /// Gives it back to the detector.
    Unlock {
        /// Index into the model's spikes.
        index: usize,
    },
    /// Takes it away; its energy goes back to the smooth part.
    Delete {
        /// Index into the model's spikes.
        index: usize,
    },
    /// Adds one. A line that stands there is taken out of the smooth part.
    Add {
        /// Place, nm.
        at_nm: f64,
        /// Weight, in the spectrum's unit x nm.
        weight: f64,
    },
    /// Forgets all hand edits.
    Reset,
}

/// The hand edits after an act; unchanged when the act names a spike that is not there.
pub(super) fn after(act: SpikeAct, edits: &SpikeEdits, parts: &Decomposed) -> SpikeEdits {
    let mut edits = edits.clone();
    match act {
        SpikeAct::Set {
            index,
            at_nm,
            weight,
        } => {
            if let Some(spike) = parts.spikes.get(index)
                && at_nm.is_finite()
                && weight.is_finite()
            {
                let hand = &mut edits.hand[..];
                match spike.hand.and_then(|h| hand.get_mut(h)) {
                    Some(hand) => (hand.at_nm, hand.weight) = (at_nm, weight),
                    None => edits.hand.push(HandSpike {
                        at_nm,
                        weight,
                        ..locked(spike)
                    }),
                }
            }
        }
        SpikeAct::Lock { index } => {
            if let Some(spike) = parts.spikes.get(index)
                && spike.hand.is_none()
            {
                edits.hand.push(locked(spike));
            }
        }
        SpikeAct::Unlock { index } => {
            if let Some(hand) = parts.spikes.get(index).and_then(|s| s.hand)
                && hand < edits.hand.len()
            {
                edits.hand.remove(hand);
            }
        }
        SpikeAct::Delete { index } => {
            if let Some(spike) = parts.spikes.get(index) {
                match spike.hand {
                    Some(hand) if hand < edits.hand.len() => {
                        let removed = edits.hand.remove(hand);
                        // Where no line stands, nothing is to be kept from coming back.
                        let line_nm = removed.line_nm.filter(|_| spike.width_nm.is_some());
                        edits.deleted_nm.extend(line_nm);
                    }
                    _ => edits.deleted_nm.push(spike.spike.at_nm),
                }
            }
        }
        SpikeAct::Add { at_nm, weight } => {
            if at_nm.is_finite() && weight.is_finite() {
                edits.deleted_nm.retain(|nm| (nm - at_nm).abs() > SAME_NM);
                edits.hand.push(HandSpike {
                    at_nm,
                    weight,
                    line_nm: Some(at_nm),
                    window_nm: None,
                    is_dip: weight < 0.0,
                });
            }
        }
        SpikeAct::Reset => edits = SpikeEdits::default(),
    }
    edits
}

/// A spike added this near to a deleted one brings its line back.
const SAME_NM: f64 = 3.0;

fn locked(spike: &ModelSpike) -> HandSpike {
    HandSpike {
        at_nm: spike.spike.at_nm,
        weight: spike.spike.weight,
        line_nm: spike.width_nm.map(|_| spike.spike.at_nm),
        window_nm: spike.window_nm,
        is_dip: spike.spike.weight < 0.0,
    }
}
