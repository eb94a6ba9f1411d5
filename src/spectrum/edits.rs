//! Spikes set by hand, over what the detector finds.
//!
//! A hand-set spike remembers the line it came from. That line is taken out of the smooth part
//! whatever the thresholds say, so moving a spike or changing its weight shows the error this
//! makes instead of hiding it in the smooth part; deleting a spike gives its energy back.

use serde::{Deserialize, Serialize};

use super::{
    band::Band,
    composite::Spike,
    spikes::{self, Decomposition, SpikeSettings, Wishes},
};

/// A spike that a person set or locked.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HandSpike {
    /// Where the spike stands now, nm.
    pub at_nm: f64,
    /// Its weight, in the spectrum's unit x nm.
    pub weight: f64,
    /// Where the line it stands for was found, nm; `None` for a spike set where no line is.
    pub line_nm: Option<f64>,
}

/// All hand edits of one spectrum's spikes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SpikeEdits {
    /// Spikes kept against re-detection.
    pub hand: Vec<HandSpike>,
    /// Places (nm) of found lines that were deleted.
    pub deleted_nm: Vec<f64>,
}

impl SpikeEdits {
    /// Whether nothing was edited.
    pub fn is_empty(&self) -> bool {
        self.hand.is_empty() && self.deleted_nm.is_empty()
    }
}

/// A spike of the model with where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelSpike {
    /// Place and weight as the model uses them.
    pub spike: Spike,
    /// Full width at half maximum of the line it stands for, nm; `None` where no line is.
    pub width_nm: Option<f64>,
    /// Local maxima that were joined into this spike.
    pub peaks: usize,
    /// Index into [`SpikeEdits::hand`] when it was set or locked by hand.
    pub hand: Option<usize>,
}

/// The smooth part's target and the model's spikes.
#[derive(Clone, Debug, PartialEq)]
pub struct Decomposed {
    /// What is left for the smooth part on the grid.
    pub smooth: Vec<f64>,
    /// The spikes by rising wavelength.
    pub spikes: Vec<ModelSpike>,
    /// Integral of `|S|` over the band.
    pub power: f64,
}

impl Decomposed {
    /// A decomposition nobody edited.
    pub fn of(parts: Decomposition) -> Self {
        Self {
            smooth: parts.smooth,
            power: parts.power,
            spikes: parts
                .spikes
                .into_iter()
                .map(|found| ModelSpike {
                    spike: found.spike,
                    width_nm: Some(found.width_nm),
                    peaks: found.peaks,
                    hand: None,
                })
                .collect(),
        }
    }

    /// Place and weight of all spikes.
    pub fn plain_spikes(&self) -> Vec<Spike> {
        self.spikes.iter().map(|s| s.spike).collect()
    }
}

/// Takes a spectrum apart with the default detector and a person's edits.
pub fn decompose(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
    edits: &SpikeEdits,
) -> Decomposed {
    decompose_by(band, edits, |wishes| {
        spikes::detect_with(band, values, settings, wishes)
    })
}

/// Takes a spectrum apart with any detector and a person's edits.
pub fn decompose_by(
    band: Band,
    edits: &SpikeEdits,
    detect: impl Fn(Wishes<'_>) -> Decomposition,
) -> Decomposed {
    let take: Vec<f64> = edits.hand.iter().filter_map(|h| h.line_nm).collect();
    let mut parts = Decomposed::of(detect(Wishes {
        take: &take,
        leave: &edits.deleted_nm,
    }));
    for (index, hand) in edits.hand.iter().enumerate() {
        if !band.contains(hand.at_nm) {
            continue;
        }
        let spike = Spike {
            at_nm: hand.at_nm,
            weight: hand.weight,
        };
        let nearest = hand.line_nm.and_then(|nm| {
            parts
                .spikes
                .iter_mut()
                .filter(|s| s.hand.is_none())
                .map(|s| ((s.spike.at_nm - nm).abs(), s))
                .filter(|(distance, _)| *distance <= 3.0)
                .min_by(|a, b| a.0.total_cmp(&b.0))
        });
        match nearest {
            Some((_, line)) => {
                line.spike = spike;
                line.hand = Some(index);
            }
            None => parts.spikes.push(ModelSpike {
                spike,
                width_nm: None,
                peaks: 0,
                hand: Some(index),
            }),
        }
    }
    parts
        .spikes
        .sort_by(|a, b| a.spike.at_nm.total_cmp(&b.spike.at_nm));
    parts
}
