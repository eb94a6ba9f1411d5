//! Spikes set by hand, over what the detector finds.
//!
//! A hand-set spike remembers the line it came from. That line is taken out of the smooth part
//! whatever the thresholds say, so moving a spike or changing its weight shows the error this
//! makes instead of hiding it in the smooth part; deleting a spike gives its energy back.

use serde::{Deserialize, Serialize};

use super::{
    band::Band,
    composite::Composite,
    line::{GAUSSIAN_AREA, Line},
    spikes::{self, Constraints, Decomposition, SpikeSettings},
};

/// A spike that a person set or locked.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HandSpike {
    /// Current wavelength of the spike, nm.
    pub at_nm: f64,
    /// Its weight, in the spectrum's unit x nm.
    pub weight: f64,
    /// Wavelength at which its line was found, nm; `None` for a spike set where no line is.
    pub line_nm: Option<f64>,
    /// The window that line was taken from, nm; `None` when it is still to be looked for.
    #[serde(default)]
    pub window_nm: Option<[f64; 2]>,
    /// True if that line is a dip (absorption); the spike's own weight may be reversed in sign.
    #[serde(default)]
    pub is_dip: bool,
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
    /// True if there are no edits.
    pub fn is_empty(&self) -> bool {
        self.hand.is_empty() && self.deleted_nm.is_empty()
    }
}

/// A spike of the model with where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelSpike {
    /// Place and weight as the model uses them.
    pub spike: Line,
    /// Full width at half maximum of the line it stands for, nm; `None` where no line is.
    pub width_nm: Option<f64>,
    /// The window that line was taken from, nm.
    pub window_nm: Option<[f64; 2]>,
    /// Local maxima that were joined into this spike.
    pub peaks: usize,
    /// Index into [`SpikeEdits::hand`] when it was set or locked by hand.
    pub hand: Option<usize>,
}

/// The smooth part's target and the model's spikes.
#[derive(Clone, Debug, PartialEq)]
pub struct Decomposed {
    /// Values left for the smooth part, on the grid.
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
                    window_nm: Some(found.window_nm),
                    peaks: found.peaks,
                    hand: None,
                })
                .collect(),
        }
    }

    /// A composite as it is, which `values` on its band's grid are the table of: each line as wide
    /// as it stands there, over its two neighbouring nm.
    pub fn of_composite(composite: &Composite, values: &[f64]) -> Self {
        let band = composite.band();
        let spikes = composite.lines().iter().filter(|s| band.contains(s.at_nm));
        let mut spikes: Vec<ModelSpike> = spikes
            .map(|&spike| {
                let beyond = spike.at_nm.fract();
                ModelSpike {
                    spike,
                    width_nm: Some(1.0 / (GAUSSIAN_AREA * beyond.max(1.0 - beyond))),
                    window_nm: None,
                    peaks: 1,
                    hand: None,
                }
            })
            .collect();
        spikes.sort_by(|a, b| a.spike.at_nm.total_cmp(&b.spike.at_nm));
        Self {
            smooth: composite.smooth().on_band(),
            spikes,
            power: spikes::absolute_power(band, values),
        }
    }

    /// A weight as a share of the total power; `None` in the dark.
    pub fn share(&self, weight: f64) -> Option<f64> {
        let share = weight / self.power;
        (self.power > 0.0 && share.is_finite()).then_some(share)
    }

    /// The width that a spike's stem is drawn with, nm: full width at half maximum of the line that
    /// it stands for, so that stem and line are equally high; for a spike without a line the median
    /// of the others', or that of lines in tables of 5 nm.
    pub fn stem_width_nm(&self, index: usize) -> f64 {
        const OF_TABLES: f64 = 5.0;
        if let Some(width) = self.spikes.get(index).and_then(|spike| spike.width_nm) {
            return width;
        }
        let mut widths: Vec<f64> = self.spikes.iter().filter_map(|s| s.width_nm).collect();
        widths.sort_by(f64::total_cmp);
        widths.get(widths.len() / 2).copied().unwrap_or(OF_TABLES)
    }

    /// Place and weight of all spikes.
    pub(crate) fn plain_spikes(&self) -> Vec<Line> {
        self.spikes.iter().map(|s| s.spike).collect()
    }
}

/// Takes a spectrum apart with the default detector and a person's edits.
pub(crate) fn decompose(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
    edits: &SpikeEdits,
) -> Decomposed {
    decompose_by(
        band,
        values,
        settings.max_width_nm,
        edits,
        |values, constraints| spikes::detect_with(band, values, settings, constraints),
    )
}

/// Takes a spectrum apart with any detector and a person's edits.
///
/// As long as the detector still finds every line that a hand-set spike stands for, that spike
/// takes its line's place and nothing else changes. Once it does not (the threshold was moved),
/// the hand-set lines are taken out first, each from its own window, and the detector looks at
/// the rest: no energy is counted twice.
pub(crate) fn decompose_by(
    band: Band,
    values: &[f64],
    max_width_nm: f64,
    edits: &SpikeEdits,
    detect: impl Fn(&[f64], Constraints<'_>) -> Decomposition,
) -> Decomposed {
    let leave = &edits.deleted_nm[..];
    let found = Decomposed::of(detect(values, Constraints { leave, power: None }));
    if edits.hand.is_empty() {
        return found;
    }
    let all_inside = edits.hand.iter().all(|h| band.contains(h.at_nm));
    let mut parts = match in_their_places(&found, &edits.hand) {
        Some(parts) if all_inside => parts,
        _ => {
            let mut rest = values.to_vec();
            let hand: Vec<ModelSpike> = edits
                .hand
                .iter()
                .enumerate()
                // A spike outside the range leaves its line alone: nothing would carry the energy.
                .filter(|(_, hand)| band.contains(hand.at_nm))
                .map(|(index, hand)| taken(band, &mut rest, max_width_nm, index, hand))
                .collect();
            let constraints = Constraints {
                leave,
                power: Some(found.power),
            };
            let mut parts = Decomposed::of(detect(&rest, constraints));
            parts.spikes.extend(hand);
            parts
        }
    };
    parts
        .spikes
        .sort_by(|a, b| a.spike.at_nm.total_cmp(&b.spike.at_nm));
    parts
}

/// A line found this near to where a hand-set spike's line was is the same line, unchanged.
const UNCHANGED_NM: f64 = 0.01;

/// The hand-set spikes in the places of the very lines they stand for; `None` when one of those
/// lines was not found as it was.
fn in_their_places(found: &Decomposed, hand: &[HandSpike]) -> Option<Decomposed> {
    let mut parts = found.clone();
    for (index, hand) in hand.iter().enumerate() {
        let spike = Line::ideal(hand.at_nm, hand.weight);
        let Some(line_nm) = hand.line_nm else {
            parts.spikes.push(ModelSpike {
                spike,
                width_nm: None,
                window_nm: None,
                peaks: 0,
                hand: Some(index),
            });
            continue;
        };
        let line = parts.spikes.iter_mut().find(|s| {
            s.hand.is_none()
                && (s.spike.at_nm - line_nm).abs() <= UNCHANGED_NM
                && s.window_nm == hand.window_nm
        })?;
        line.spike = spike;
        line.hand = Some(index);
    }
    Some(parts)
}

/// Takes the line that a hand-set spike stands for out of `rest`, if there is one.
fn taken(
    band: Band,
    rest: &mut [f64],
    max_width_nm: f64,
    index: usize,
    hand: &HandSpike,
) -> ModelSpike {
    let sign = if hand.is_dip { -1.0 } else { 1.0 };
    let line = hand.line_nm.and_then(|line_nm| {
        let window = hand
            .window_nm
            .or_else(|| spikes::window_near(band, rest, line_nm, max_width_nm, sign))?;
        spikes::take_window(band, rest, window, sign)
    });
    ModelSpike {
        spike: Line::ideal(hand.at_nm, hand.weight),
        width_nm: line.map(|l| l.width_nm),
        window_nm: line.map(|l| l.window_nm),
        peaks: usize::from(line.is_some()),
        hand: Some(index),
    }
}
