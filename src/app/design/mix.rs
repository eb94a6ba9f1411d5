//! The mixing desk: channels with their faders, part of the document, so that undo reaches it.

use serde::{Deserialize, Serialize};

use crate::{
    app::{
        products::THICKNESSES,
        recipe::{Gel, NameOf},
        ticks::short,
    },
    design::mixture::Source,
    languages::fixed,
};

/// A fader that is all the way up, per cent of a channel's full power.
pub const FULL: f64 = 100.0;

/// Most channels of a desk: more hide one another.
pub const MOST_CHANNELS: usize = 24;

/// Most gels before it.
pub const MOST_GELS: usize = 8;

/// Groups that channels can be in, from 1.
pub const GROUPS: u8 = 3;

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
    /// The group whose fader moves it too, 1 to [`GROUPS`]; 0 for none.
    #[serde(default)]
    pub group: u8,
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
            group: 0,
        }
    }

    /// What it is, in words.
    pub fn title(&self, name_of: NameOf<'_>) -> String {
        title(&self.source, name_of)
    }
}

/// What a channel is made of, in words; of a light of the library its name.
pub fn title(source: &Source, name_of: NameOf<'_>) -> String {
    match source {
        Source::Line { at_nm } => tr!("line {place} nm", place = short(*at_nm)),
        Source::Gauss { centre_nm, .. } => tr!("LED {place} nm", place = short(*centre_nm)),
        Source::Blackbody { kelvin } => tr!("blackbody {kelvin} K", kelvin = fixed(kelvin, 0)),
        Source::Daylight { kelvin } => tr!("daylight {kelvin} K", kelvin = fixed(kelvin, 0)),
        Source::Named(key) => name_of(key),
    }
}

/// The desk.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Mix {
    /// Its channels, from the top down.
    pub channels: Vec<MixChannel>,
    /// What stands before all of them.
    pub gels: Vec<Gel>,
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
            gels: Vec::new(),
        }
    }

    /// Moves every value to the nearest one that is allowed.
    pub fn settle(&mut self) {
        self.channels.truncate(MOST_CHANNELS);
        for channel in &mut self.channels {
            channel.source = channel.source.clone().clamped();
            channel.level = sound(channel.level);
            channel.group = channel.group.min(GROUPS);
        }
        self.gels.truncate(MOST_GELS);
        let (least, most) = (*THICKNESSES.start(), *THICKNESSES.end());
        for gel in &mut self.gels {
            gel.thickness = gel.thickness.max(least).min(most);
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

    /// The highest fader of those that are heard.
    pub fn highest(&self) -> f64 {
        self.powers().into_iter().fold(0.0, f64::max)
    }

    /// All faders that are heard moved together until the highest is there: dimmed at constant
    /// colour.
    #[must_use]
    pub fn dimmed(self, highest: f64) -> Self {
        let heard: Vec<bool> = self.channels.iter().map(|c| self.is_heard(c)).collect();
        self.together(&heard, highest)
    }

    /// The highest fader of a group; `None` for a group of no channel.
    pub fn group_highest(&self, group: u8) -> Option<f64> {
        let levels = self.channels.iter().filter(|c| c.group == group);
        levels.map(|c| c.level).reduce(f64::max)
    }

    /// The faders of a group moved together until its highest is there.
    #[must_use]
    pub fn group_dimmed(self, group: u8, highest: f64) -> Self {
        let members: Vec<bool> = self.channels.iter().map(|c| c.group == group).collect();
        self.together(&members, highest)
    }

    /// Some faders moved together until the highest of them is there: their shares stay.
    fn together(mut self, moved: &[bool], highest: f64) -> Self {
        let mut moved: Vec<&mut MixChannel> = self
            .channels
            .iter_mut()
            .zip(moved)
            .filter_map(|(channel, moved)| moved.then_some(channel))
            .collect();
        let now = moved.iter().map(|c| c.level).fold(0.0, f64::max);
        let factor = sound(highest) / now;
        if factor.is_finite() {
            moved.iter_mut().for_each(|c| c.level *= factor);
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

    /// Lets go of a light or a gel that left the library.
    pub fn forget(&mut self, key: &str) {
        let is_it = |c: &MixChannel| matches!(&c.source, Source::Named(name) if name == key);
        self.channels.retain(|channel| !is_it(channel));
        self.gels.retain(|gel| gel.key != key);
    }

    /// What changed, in words; `None` for nothing.
    pub fn changed_since(&self, before: &Self, name_of: NameOf<'_>) -> Option<String> {
        if self == before {
            return None;
        }
        let (is, was) = (&self.channels, &before.channels);
        if self.gels != before.gels {
            return Some(self.changed_gel(before, name_of));
        }
        if is.len() != was.len() {
            let words = if is.len() > was.len() {
                said!("more channels to mix")
            } else {
                said!("fewer channels to mix")
            };
            return Some(words.to_owned());
        }
        let changed: Vec<_> = is.iter().zip(was).filter(|(a, b)| a != b).collect();
        let [(now, then)] = changed[..] else {
            let group = changed.first().map_or(0, |(now, _)| now.group);
            let is_group = group > 0 && changed.iter().all(|(now, _)| now.group == group);
            return Some(match is_group {
                true => tr!("fader of group {group}", group),
                false => said!("faders of the mixture").to_owned(),
            });
        };
        let name = now.title(name_of);
        Some(if now.source != then.source {
            tr!(
                "{before} to {after}",
                before = then.title(name_of),
                after = name
            )
        } else if now.level != then.level {
            tr!(
                "fader of {name} to {level} %",
                name,
                level = fixed(now.level, 0)
            )
        } else if now.group != then.group {
            match now.group {
                0 => tr!("{name} in no group", name),
                group => tr!("{name} in group {group}", name, group),
            }
        } else {
            tr!("a switch of {name}", name)
        })
    }

    /// What changed of the gels, in words.
    fn changed_gel(&self, before: &Self, name_of: NameOf<'_>) -> String {
        let (is, was) = (&self.gels, &before.gels);
        let new = is.iter().find(|gel| !was.iter().any(|b| b.key == gel.key));
        let gone = was.iter().find(|gel| !is.iter().any(|b| b.key == gel.key));
        let other = is.iter().zip(was).find(|(a, b)| a != b);
        match (new, gone, other) {
            (Some(gel), _, _) => tr!("gel {gel} put on", gel = gel.words(name_of)),
            (None, Some(gel), _) => tr!("gel {gel} taken off", gel = gel.words(name_of)),
            (None, None, Some((gel, _))) => tr!("gel {gel}", gel = gel.words(name_of)),
            (None, None, None) => said!("gels of the mixture").to_owned(),
        }
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

/// A fader's place within its reach; at the bottom where it has none.
fn sound(level: f64) -> f64 {
    if level.is_nan() {
        return 0.0;
    }
    level.clamp(0.0, FULL)
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
    fn a_group_moves_together_and_leaves_the_others() {
        let mut mix = Mix::first();
        mix.channels[0].group = 1;
        mix.channels[1].group = 1;
        assert_eq!(
            (mix.group_highest(1), mix.group_highest(2)),
            (Some(75.0), None)
        );
        let moved = mix.clone().group_dimmed(1, 37.5);
        let levels: Vec<f64> = moved.channels.iter().map(|c| c.level).collect();
        assert_eq!(levels, [12.0, 37.5, 40.0, 100.0]);
        let words = moved.changed_since(&mix, &str::to_owned);
        assert_eq!(words.as_deref(), Some("fader of group 1"));
        // A group that is all the way down stays there: its shares are lost.
        mix.channels[0].level = 0.0;
        mix.channels[1].level = 0.0;
        assert_eq!(mix.clone().group_dimmed(1, 50.0), mix);
    }

    #[test]
    fn what_happens_to_gels_is_told_and_a_gel_that_is_gone_is_let_go_of() {
        let bare = Mix::first();
        let gel = |thickness: f64| Gel {
            key: "own/7".to_owned(),
            thickness,
        };
        let with = |gels: &[Gel]| Mix {
            gels: gels.to_vec(),
            ..Mix::first()
        };
        let (one, thick) = (with(&[gel(1.0)]), with(&[gel(2.0)]));
        let told = |now: &Mix, before: &Mix| {
            let name_of = |key: &str| format!("steel blue of {key}");
            now.changed_since(before, &name_of).unwrap_or_default()
        };
        assert_eq!(told(&one, &bare), "gel steel blue of own/7 put on");
        assert_eq!(told(&thick, &one), "gel steel blue of own/7 \u{d7} 2.00");
        assert_eq!(
            told(&bare, &thick),
            "gel steel blue of own/7 \u{d7} 2.00 taken off"
        );
        let twice = with(&[gel(1.0), gel(1.0)]);
        assert_eq!(told(&twice, &one), "gels of the mixture");
        let mut mix = one.clone();
        mix.forget("own/7");
        assert_eq!(mix, bare);
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
        mix.channels[2].group = 9;
        mix.gels = vec![
            Gel {
                key: String::new(),
                thickness: f64::NAN
            };
            20
        ];
        mix.settle();
        let sound = mix;
        assert_eq!(sound.channels[0].level, 0.0);
        assert_eq!(sound.channels[1].source, Source::Line { at_nm: 830.0 });
        assert_eq!(
            (sound.channels[2].level, sound.channels[2].group),
            (FULL, GROUPS)
        );
        assert_eq!(
            (sound.gels.len(), sound.gels[0].thickness),
            (MOST_GELS, 0.0)
        );
    }
}
