//! The mixing desk: channels with their faders, part of the document, so that undo reaches it.

use serde::{Deserialize, Serialize};

use crate::{app::ticks::short, design::mixture::Source};

/// A fader that is all the way up, per cent of a channel's full power.
pub const FULL: f64 = 100.0;

/// Most channels of a desk: more hide one another.
pub const MOST_CHANNELS: usize = 24;

/// A channel of the desk.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MixChannel {
    /// What it is made of; a light of the library by its key.
    pub source: Source,
    /// Its fader, per cent of its full power, which is the same for every channel.
    pub level: f64,
    /// It is silent.
    #[serde(default)]
    pub mute: bool,
    /// It is heard alone, with others that are so.
    #[serde(default)]
    pub solo: bool,
    /// Solving leaves its fader where it is.
    #[serde(default)]
    pub lock: bool,
}

impl MixChannel {
    /// A channel at half power.
    pub fn new(source: Source) -> Self {
        Self {
            source,
            level: 0.5 * FULL,
            mute: false,
            solo: false,
            lock: false,
        }
    }

    /// What it is, in words.
    pub fn title(&self) -> String {
        title(&self.source)
    }
}

/// What a channel is made of, in words; of a light of the library the last part of its key.
pub fn title(source: &Source) -> String {
    match source {
        Source::Line { at_nm } => format!("line {} nm", short(*at_nm)),
        Source::Gauss { centre_nm, .. } => format!("LED {} nm", short(*centre_nm)),
        Source::Blackbody { kelvin } => format!("blackbody {kelvin:.0} K"),
        Source::Daylight { kelvin } => format!("daylight {kelvin:.0} K"),
        Source::Named(key) => key.rsplit('/').next().unwrap_or(key).to_owned(),
    }
}

/// The desk.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Mix {
    /// Its channels, from the top down.
    pub channels: Vec<MixChannel>,
}

impl Mix {
    /// What a fresh document starts with: four coloured LEDs at a warm white.
    pub fn first() -> Self {
        let leds = [
            (455.0, 20.0, 24.0),
            (530.0, 34.0, 75.0),
            (595.0, 18.0, 40.0),
            (632.0, 18.0, 100.0),
        ];
        let channel = |(centre_nm, fwhm_nm, level): (f64, f64, f64)| MixChannel {
            level,
            ..MixChannel::new(Source::Gauss { centre_nm, fwhm_nm })
        };
        Self {
            channels: leds.into_iter().map(channel).collect(),
        }
    }

    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        let clamped = |channel: MixChannel| MixChannel {
            source: channel.source.clamped(),
            level: match channel.level.is_nan() {
                true => 0.0,
                false => channel.level.clamp(0.0, FULL),
            },
            ..channel
        };
        let channels = self.channels.into_iter().take(MOST_CHANNELS);
        Self {
            channels: channels.map(clamped).collect(),
        }
    }

    /// Whether a channel is heard.
    pub fn is_heard(&self, channel: &MixChannel) -> bool {
        let is_alone = self.channels.iter().any(|c| c.solo);
        !channel.mute && (channel.solo || !is_alone)
    }

    /// The power of each channel that is heard, else 0.
    pub fn powers(&self) -> Vec<f64> {
        let power = |c: &MixChannel| if self.is_heard(c) { c.level } else { 0.0 };
        self.channels.iter().map(power).collect()
    }

    /// The channels that shine, with their powers.
    pub fn shining(&self) -> Vec<(Source, f64)> {
        let channels = self.channels.iter().zip(self.powers());
        channels
            .filter(|(_, power)| *power > 0.0)
            .map(|(channel, power)| (channel.source.clone(), power))
            .collect()
    }

    /// The highest fader of those that are heard.
    pub fn highest(&self) -> f64 {
        self.powers().into_iter().fold(0.0, f64::max)
    }

    /// All faders that are heard moved together until the highest is there: dimmed at constant
    /// colour.
    #[must_use]
    pub fn dimmed(mut self, highest: f64) -> Self {
        let factor = highest.clamp(0.0, FULL) / self.highest();
        if factor.is_finite() {
            let heard: Vec<bool> = self.channels.iter().map(|c| self.is_heard(c)).collect();
            let channels = self.channels.iter_mut().zip(heard);
            let heard = channels.filter(|(_, heard)| *heard);
            heard.for_each(|(channel, _)| channel.level *= factor);
        }
        self
    }

    /// The faders of those that are heard at these powers (one a channel of the desk). Without
    /// locks the highest goes all the way up; with locks all go down together where one would go
    /// beyond.
    #[must_use]
    pub fn at_powers(mut self, powers: &[f64]) -> Self {
        let highest = powers.iter().copied().fold(0.0, f64::max);
        let is_locked = self.channels.iter().any(|c| c.lock && self.is_heard(c));
        let factor = match is_locked && highest <= FULL {
            true => 1.0,
            false => FULL / highest,
        };
        if factor.is_finite() {
            let heard: Vec<bool> = self.channels.iter().map(|c| self.is_heard(c)).collect();
            for ((channel, heard), power) in self.channels.iter_mut().zip(heard).zip(powers) {
                if heard {
                    channel.level = factor * power;
                }
            }
        }
        self
    }

    /// Lets go of a light that left the library.
    pub fn forget(&mut self, key: &str) {
        let is_it = |c: &MixChannel| matches!(&c.source, Source::Named(name) if name == key);
        self.channels.retain(|channel| !is_it(channel));
    }

    /// What changed, in words; `None` for nothing.
    pub fn changed_since(&self, before: &Self) -> Option<String> {
        if self == before {
            return None;
        }
        let (is, was) = (&self.channels, &before.channels);
        if is.len() != was.len() {
            let more = if is.len() > was.len() {
                "more"
            } else {
                "fewer"
            };
            return Some(format!("{more} channels to mix"));
        }
        let changed: Vec<_> = is.iter().zip(was).filter(|(a, b)| a != b).collect();
        let [(now, then)] = changed[..] else {
            return Some("faders of the mixture".to_owned());
        };
        let name = now.title();
        Some(if now.source != then.source {
            format!("{} to {name}", then.title())
        } else if now.level != then.level {
            format!("fader of {name} to {:.0} %", now.level)
        } else {
            format!("a switch of {name}")
        })
    }
}

/// A desk that was kept, with the sentence about it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// The desk.
    pub mix: Mix,
    /// What it was worth.
    pub words: String,
}

impl Snapshot {
    /// Every value of the desk moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        Self {
            mix: self.mix.clamped(),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_soloed_channel_is_heard_alone_and_a_muted_one_never() {
        let mut mix = Mix::first();
        mix.channels[1].solo = true;
        let powers = mix.powers();
        assert_eq!(powers.iter().filter(|p| **p > 0.0).count(), 1);
        mix.channels[1].mute = true;
        assert_eq!(mix.highest(), 0.0);
        assert!(mix.shining().is_empty());
    }

    #[test]
    fn dimming_keeps_the_shares_of_power() {
        let mix = Mix::first();
        let dimmed = mix.clone().dimmed(30.0);
        assert_eq!(dimmed.highest(), 30.0);
        for (a, b) in mix.channels.iter().zip(&dimmed.channels) {
            approx::assert_relative_eq!(b.level, 0.3 * a.level, max_relative = 1e-12);
        }
        // Nothing shines: nothing to dim, and no number that is none.
        let dark = Mix::default().dimmed(30.0);
        assert_eq!(dark, Mix::default());
    }

    #[test]
    fn solved_powers_stay_on_the_faders() {
        let mix = Mix::first().at_powers(&[10.0, 400.0, 0.0, 200.0]);
        assert_eq!(mix.highest(), FULL);
        assert_eq!(mix.channels[3].level, 50.0);
        let mut locked = Mix::first();
        locked.channels[0].lock = true;
        let low = locked.clone().at_powers(&[17.0, 40.0, 0.0, 20.0]);
        assert_eq!(low.channels[1].level, 40.0, "a lock keeps its power");
        let high = locked.at_powers(&[17.0, 200.0, 0.0, 20.0]);
        assert_eq!((high.channels[0].level, high.highest()), (8.5, FULL));
    }

    #[test]
    fn nonsense_on_the_desk_becomes_something_allowed() {
        let mut mix = Mix::first();
        mix.channels[0].level = f64::NAN;
        mix.channels[1].source = Source::Line { at_nm: 5000.0 };
        mix.channels[2].level = 1e9;
        let sound = mix.clamped();
        assert_eq!(sound.channels[0].level, 0.0);
        assert_eq!(sound.channels[1].source, Source::Line { at_nm: 830.0 });
        assert_eq!(sound.channels[2].level, FULL);
    }
}
