//! The response of an instrument, learnt from a picture of a light that is known.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::{
    Photograph, Tones,
    along::{Along, of_strip},
};
use crate::{
    color::{blackbody::relative, quality::daylight},
    photographs::{
        Profile,
        hue::Hues,
        response::{Corrected, Response, STEP_NM},
    },
    spectrum::{Outside, Sampled},
};

/// A light whose shape is known.
#[derive(Clone, Debug, PartialEq)]
pub enum Known {
    /// A bulb of so many K.
    Blackbody(f64),
    /// Daylight of so many K.
    Daylight(f64),
    /// A spectrum, and what it is called.
    Spectrum(String, Sampled),
}

impl Known {
    /// The light in words.
    pub fn words(&self) -> String {
        match self {
            Self::Blackbody(kelvin) => format!("blackbody:{kelvin}"),
            Self::Daylight(kelvin) => format!("daylight:{kelvin}"),
            Self::Spectrum(name, _) => name.clone(),
        }
    }

    /// Its power at a wavelength, up to a factor.
    fn power(&self) -> Box<dyn Fn(f64) -> f64 + '_> {
        match self {
            Self::Blackbody(kelvin) => Box::new(|nm| relative(nm, *kelvin)),
            Self::Daylight(kelvin) => {
                let table = daylight(*kelvin);
                Box::new(move |nm| {
                    let place = (nm - 360.0).round();
                    if place < 0.0 {
                        0.0
                    } else {
                        table.get(place as usize).copied().unwrap_or(0.0)
                    }
                })
            }
            Self::Spectrum(_, samples) => Box::new(|nm| samples.at(nm, Outside::Zero).max(0.0)),
        }
    }
}

/// A response as the file of an instrument has it.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Kept {
    first_nm: f64,
    step_nm: f64,
    r: Vec<f64>,
    g: Vec<f64>,
    b: Vec<f64>,
    /// The light that it was learnt from.
    pub known_as: String,
    /// How far a bulb's temperature is doubted, K.
    doubt_k: Option<f64>,
    /// The power by which tones were straightened: 1 for none.
    pub(super) tone_p: f64,
    /// The power of the light that the camera's values go with, as several exposures told.
    #[serde(default = "proportional")]
    light_power: f64,
    disagreement: f64,
    /// The hues of that picture's columns, until they are kept with the instrument.
    #[serde(skip)]
    pub(super) hues: Option<Hues>,
}

fn proportional() -> f64 {
    1.0
}

/// A picture read through a response.
#[derive(Clone, Debug, PartialEq)]
pub struct Through {
    /// The light that the response was learnt from.
    pub known_as: String,
    /// The temperature of the bulb that this was, and its doubt, K.
    pub bulb: Option<(f64, f64)>,
    /// The power by which tones were straightened: 1 for none.
    pub tone_p: f64,
    /// The power of the light that the camera's values go with.
    pub light_power: f64,
    /// How far the channels of a straight camera disagree at most.
    pub most_disagreement: f64,
    /// The light.
    pub corrected: Corrected,
    /// How far the channels disagree, of both pictures the more.
    pub disagreement: f64,
}

/// Columns from one kept hue to the next.
pub(super) const HUE_STEP: usize = 2;
/// A bulb is no surer than this, K.
const DOUBT_K: f64 = 100.0;
/// The wavelengths that must not be over-exposed, nm.
pub(super) const NEEDED_NM: (f64, f64) = (420.0, 680.0);
/// Channels of a straight camera disagree by less: about smooth light, and about lines.
const MOST_DISAGREEMENT: (f64, f64) = (0.02, 0.05);
/// Tones are looked at from this share of that on, and are bent if straight ones disagree by no more
/// than this share of what they did.
const TRIED: f64 = 0.75;
const FALLS_TO: f64 = 0.7;
/// Powers of tones that are tried.
const TONES: [f64; 11] = [0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8];

/// How far the channels of a straight camera disagree about a picture.
fn most_disagreement(of: &Photograph) -> f64 {
    if of.is_of_lines() {
        MOST_DISAGREEMENT.1
    } else {
        MOST_DISAGREEMENT.0
    }
}

impl Kept {
    /// The temperature of the bulb that it was learnt from, and its doubt, K.
    fn bulb(&self) -> Option<(f64, f64)> {
        let kelvin = self.known_as.strip_prefix("blackbody:")?.parse().ok()?;
        Some((kelvin, self.doubt_k?))
    }

    /// The camera's tones, which are to be undone.
    pub(super) fn tones(&self) -> Tones {
        Tones {
            s_power: self.tone_p,
            light_power: self.light_power,
        }
    }

    fn response(&self) -> Option<Response> {
        let count = self.r.len();
        let is_whole = count > 3
            && [&self.g, &self.b].iter().all(|c| c.len() == count)
            && self.step_nm == STEP_NM
            && self.first_nm.is_finite()
            && (TONES[0]..=TONES[TONES.len() - 1]).contains(&self.tone_p)
            && (0.2..=5.0).contains(&self.light_power)
            && [&self.r, &self.g, &self.b]
                .into_iter()
                .flatten()
                .all(|v| *v >= 0.0 && v.is_finite());
        is_whole.then(|| Response {
            first_nm: self.first_nm,
            channels: [self.r.clone(), self.g.clone(), self.b.clone()],
            disagreement: self.disagreement,
        })
    }

    /// Learns it from a picture of the instrument that another picture was taken with; where the
    /// camera bends its tones, the other picture is read again from `own` with straight ones.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn learn(
        path: &Path,
        known: &Known,
        of: &mut Photograph,
        own: Option<&Path>,
    ) -> Result<Self, String> {
        let name = crate::io::shown(path);
        Self::learnt(path, known, of, own).map_err(|why| format!("{name}: {why}"))
    }

    fn learnt(
        path: &Path,
        known: &Known,
        of: &mut Photograph,
        own: Option<&Path>,
    ) -> Result<Self, String> {
        let no_axis = said!("found no axis, expected one to learn a response on");
        let curve = of.used_curve().ok_or(no_axis)?;
        let reach = of.reach_nm().ok_or(no_axis)?;
        let along = Along {
            size: of.size,
            strip: &of.found.strip.clone(),
            is_linear: of.is_linear,
            tones: of.tones,
        };
        let (found, _) = of_strip(path, along, &[])?;
        let hues = Hues::of(&found.profile, HUE_STEP);
        let moved = Hues::of(&of.found.profile, HUE_STEP)
            .zip(hues.clone())
            .and_then(|(mine, theirs)| mine.shift(&theirs));
        let step = curve.slope(curve.centre_px).abs();
        let seen = match moved {
            Some(shift) if shift.px.abs() * step >= 0.5 => curve.moved(shift.px),
            _ => curve,
        };
        let inside = |column: usize| (NEEDED_NM.0..=NEEDED_NM.1).contains(&seen.nm(column as f64));
        if (0..found.profile.columns()).any(|c| found.profile.clipped[c] && inside(c)) {
            return Err(said!("over-exposed: take it again, darker").to_owned());
        }
        let range = (reach.0.max(380.0), reach.1.min(780.0));
        let learn = |profile: &Profile| Response::learn(profile, &seen, range, known.power());
        let mut response = learn(&found.profile).ok_or(said!(
            "the known light and this picture have no nm in common"
        ))?;
        let mut tone_p = of.tones.s_power;
        let plain = response.disagreement_of(&of.found.profile, &curve);
        let limit = most_disagreement(of);
        if let Some(own) = own.filter(|_| plain > TRIED * limit) {
            let tones = TONES.map(|s_power| Tones {
                s_power,
                ..of.tones
            });
            let (_, theirs) = of_strip(path, along, &tones)?;
            let (_, mine) = of_strip(own, along, &tones)?;
            let tried = (TONES.iter().zip(theirs).zip(mine)).filter_map(|((power, known), own)| {
                let response = learn(&known)?;
                let off = response.disagreement_of(&own, &curve);
                Some((off.hypot(response.disagreement), *power, response, own))
            });
            let best = tried.min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((off, power, straight, own)) = best
                && off < limit
                && off < FALLS_TO * plain
            {
                (tone_p, response, of.found.profile) = (power, straight, own);
                of.exposed.iter_mut().for_each(|e| e.joined.clear());
            }
        }
        let [r, g, b] = response.channels;
        Ok(Self {
            first_nm: response.first_nm,
            step_nm: STEP_NM,
            r,
            g,
            b,
            known_as: known.words(),
            doubt_k: matches!(known, Known::Blackbody(_)).then_some(DOUBT_K),
            tone_p,
            light_power: of.tones.light_power,
            disagreement: response.disagreement,
            hues: if moved.is_none_or(|shift| shift.px == 0.0) {
                hues
            } else {
                None
            },
        })
    }

    /// A picture read through it; `None` without an axis that is used.
    pub(super) fn through(&self, photograph: &Photograph) -> Option<Through> {
        let corrected = self
            .response()?
            .apply(&photograph.found.profile, &photograph.used_curve()?);
        Some(Through {
            known_as: self.known_as.clone(),
            bulb: self.bulb(),
            tone_p: self.tone_p,
            light_power: self.light_power,
            most_disagreement: most_disagreement(photograph),
            disagreement: corrected.disagreement.max(self.disagreement),
            corrected,
        })
    }
}

impl Through {
    /// The wavelengths where nothing is known between the first and the last.
    pub fn undefined_nm(&self) -> Vec<[f64; 2]> {
        let mut gaps: Vec<[f64; 2]> = Vec::new();
        for (nm, value) in self.corrected.nm.iter().zip(&self.corrected.value) {
            match gaps.last_mut() {
                _ if value.is_some() => {}
                Some(gap) if gap[1] + STEP_NM >= *nm => gap[1] = *nm,
                _ => gaps.push([*nm, *nm]),
            }
        }
        gaps
    }
}
