//! Instruments that are kept: a strip and an axis for the next pictures, with a check that it still
//! fits.

mod file;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::{
    Photograph,
    response::{HUE_STEP, Kept},
};
use crate::{
    app::today,
    languages::fixed,
    photographs::{
        axis::{Answer, Curve, State},
        hue::{Hues, MOST_ALIKE},
        peaks::Peaks,
        strip::Strip,
    },
};

pub(super) const FORMAT: &str = "spectral-explorer-instrument";
const VERSION: u64 = 1;

/// An instrument as its file has it; unknown keys are kept.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Instrument {
    format: String,
    version: u64,
    /// What it is called.
    pub name: String,
    made: String,
    picture: Picture,
    strip: Place,
    axis: Axis,
    slit: Slit,
    #[serde(default)]
    hue: Option<Hue>,
    /// What it makes of light, where that was learnt.
    #[serde(default)]
    pub response: Option<Kept>,
    #[serde(flatten)]
    others: Map<String, Value>,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct Picture {
    width: usize,
    height: usize,
    orientation: u8,
    #[serde(flatten)]
    others: Map<String, Value>,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct Place {
    vertical: bool,
    flip: bool,
    centre_y: f64,
    half: f64,
    turn_deg: f64,
    shear: f64,
    smile: f64,
    x0: f64,
    columns: usize,
    #[serde(flatten)]
    others: Map<String, Value>,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct Axis {
    centre_px: f64,
    scale_px: f64,
    c: [f64; 4],
    covariance: [[f64; 4]; 4],
    valid_nm: [f64; 2],
    lamp: Option<String>,
    lines: Vec<Line>,
    rms_nm: Option<f64>,
    loo_nm: Option<f64>,
    score: Option<f64>,
    margin: Option<f64>,
    confirmed_by_hand: bool,
    #[serde(flatten)]
    others: Map<String, Value>,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct Line {
    nm: f64,
    px: f64,
    error_nm: f64,
    clipped: bool,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct Slit {
    fwhm_nm: Vec<[f64; 2]>,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct Hue {
    first_px: usize,
    step_px: usize,
    ln_g_b: Vec<Option<f64>>,
    ln_r_g: Vec<Option<f64>>,
}

impl Hue {
    fn of(hues: Hues) -> Self {
        Self {
            first_px: 0,
            step_px: hues.step_px,
            ln_g_b: hues.ln_g_b,
            ln_r_g: hues.ln_r_g,
        }
    }
}

/// Whether an instrument still fits a picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Fit {
    AsItIs,
    /// Moved since by so many columns.
    Moved(f64),
    /// Nothing in the picture tells.
    Unchecked,
    /// It is another one.
    No(String),
}

/// An instrument applied to a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Applied {
    /// What it is called.
    pub name: String,
    /// Its axis, moved along.
    pub curve: Curve,
    /// Where that holds, nm.
    pub valid_nm: (f64, f64),
    /// By how much the picture has moved, where that is known.
    pub shift_px: Option<f64>,
    /// The same in nm.
    pub shift_nm: Option<f64>,
    /// The difference of hues that is left.
    pub hue_difference: Option<f64>,
    /// Whether it still fits.
    pub fit: Fit,
}

/// Sides of one shape differ by no more than this share.
const MOST_SHAPE: f64 = 0.005;
/// What tells that an instrument is another one: columns, nm between tests.
const MOST_SHIFT_PX: f64 = 25.0;
const MOST_APART_NM: f64 = 1.0;
/// A smaller shift is none, nm.
const LEAST_SHIFT_NM: f64 = 0.5;

impl Instrument {
    /// The instrument that a picture with an axis makes; `None` without an axis that is used.
    pub fn of(photograph: &Photograph, name: &str, mut response: Option<Kept>) -> Option<Self> {
        let curve = photograph.used_curve()?;
        let (low, high) = photograph.valid_nm()?;
        let strip = photograph.found.strip;
        let answer = photograph.answer.as_ref();
        let best = answer
            .filter(|_| photograph.is_by_lines())
            .and_then(|a| a.best.as_ref());
        let peaks = photograph.peaks();
        let line = |m: &crate::photographs::axis::Match| Line {
            nm: m.landmark.nm,
            px: peaks.peaks[m.peak].px,
            error_nm: m.error_nm,
            clipped: peaks.peaks[m.peak].is_clipped,
        };
        let sharp = peaks.peaks.iter().filter(|p| !p.is_clipped && !p.is_band);
        // Of the smoothest picture at hand: that of the known light.
        let smooth = response.as_mut().and_then(|kept| kept.hues.take());
        let hues = smooth.or_else(|| Hues::of(&photograph.found.profile, HUE_STEP));
        let hue = hues.map(Hue::of);
        Some(Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            name: name.to_owned(),
            made: today(),
            picture: Picture {
                width: photograph.size[0],
                height: photograph.size[1],
                orientation: photograph.exif.orientation,
                others: Map::new(),
            },
            strip: Place {
                vertical: strip.is_vertical,
                flip: curve.c[1] < 0.0,
                centre_y: strip.centre_y,
                half: strip.half,
                turn_deg: strip.turn_deg,
                shear: strip.shear,
                smile: strip.smile,
                x0: strip.x0,
                columns: strip.columns,
                others: Map::new(),
            },
            axis: Axis {
                centre_px: curve.centre_px,
                scale_px: curve.scale_px,
                c: curve.c,
                covariance: curve.covariance,
                valid_nm: [low, high],
                lamp: best.map(|b| b.lamp.name().to_owned()),
                lines: best
                    .map(|b| b.matches.iter().map(line).collect())
                    .unwrap_or_default(),
                rms_nm: best.map(|b| b.rms_nm()),
                loo_nm: best.map(|b| b.left_out_rms_nm()),
                score: best.map(|b| b.score),
                margin: best.and(answer).map(|a| a.margin),
                confirmed_by_hand: photograph.yes,
                others: Map::new(),
            },
            slit: Slit {
                fwhm_nm: sharp
                    .map(|p| [curve.nm(p.px), p.fwhm_px * curve.slope(p.px).abs()])
                    .collect(),
            },
            hue,
            response,
            others: Map::new(),
        })
    }

    /// A name for its file.
    pub fn stem(&self) -> String {
        let name = self
            .name
            .rsplit_once('.')
            .map_or(&*self.name, |(stem, _)| stem);
        format!("{name}-instrument")
    }

    /// The instrument with what it makes of light; hues of that picture's smooth light are better
    /// than a lamp's.
    #[must_use]
    pub fn with_response(mut self, mut kept: Kept) -> Self {
        if let Some(hues) = kept.hues.take() {
            self.hue = Some(Hue::of(hues));
        }
        self.response = Some(kept);
        self
    }

    /// Its file.
    pub fn text(&self) -> String {
        // Numbers, words and lists of them always have a JSON.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// The wavelengths of its strip's columns, nm.
    pub fn wavelengths(&self) -> Vec<f64> {
        let curve = self.curve();
        (0..self.strip.columns)
            .map(|px| curve.nm(px as f64))
            .collect()
    }

    fn curve(&self) -> Curve {
        Curve {
            centre_px: self.axis.centre_px,
            scale_px: self.axis.scale_px,
            c: self.axis.c,
            covariance: self.axis.covariance,
        }
    }

    /// By how much a picture is larger than those that it was made with.
    fn scale(&self, [width, height]: [usize; 2]) -> f64 {
        let area = (width * height) as f64 / (self.picture.width * self.picture.height) as f64;
        area.sqrt()
    }

    /// Its strip in a picture of some size; of another one only if `yes` says that it is the whole
    /// picture at another scale.
    ///
    /// # Errors
    /// What was found and what was expected, for a picture of another size or shape.
    pub fn strip(&self, size: [usize; 2], yes: bool) -> Result<Strip, String> {
        let [width, height] = size;
        let own = [self.picture.width, self.picture.height];
        let shape = |[w, h]: [usize; 2]| w as f64 / h as f64;
        let is_alike = (shape(size) / shape(own) - 1.0).abs() <= MOST_SHAPE;
        if own != size && !(is_alike && yes) {
            let asked = if is_alike {
                said!("is it the whole picture at another scale? (--yes)")
            } else if shape([height, width]) == shape(own) {
                said!("it is turned: turn it back")
            } else {
                said!("another shape is another picture")
            };
            return Err(tr!(
                "found {width} x {height} px, expected {own_width} x {own_height}: this \
                 instrument was made with pictures of that size, {remark}",
                width,
                height,
                own_width = own[0],
                own_height = own[1],
                remark = asked
            ));
        }
        let along = if self.strip.vertical { height } else { width };
        let scale = self.scale(size);
        // The edges of a picture are half a pixel beyond its outermost centres.
        let place = |at: f64| (at + 0.5) * scale - 0.5;
        Ok(Strip {
            is_vertical: self.strip.vertical,
            turn_deg: self.strip.turn_deg,
            shear: self.strip.shear,
            smile: self.strip.smile / scale,
            xm: 0.5 * (along as f64 - 1.0),
            centre_y: place(self.strip.centre_y),
            half: self.strip.half * scale,
            x0: place(self.strip.x0),
            columns: (self.strip.columns as f64 * scale).round() as usize,
        })
    }

    /// Its axis for a picture, by the hues of its columns and by what its own lines say.
    pub(super) fn applied(
        &self,
        size: [usize; 2],
        hues: Option<&Hues>,
        answer: Option<&Answer>,
        peaks: &Peaks,
    ) -> Applied {
        let mut curve = self.curve();
        let scale = self.scale(size);
        if scale != 1.0 {
            curve.centre_px = (curve.centre_px + 0.5) * scale - 0.5;
            curve.scale_px *= scale;
        }
        let step = curve.slope(curve.centre_px).abs();
        // Hues are kept by column: those of another scale are others.
        let hue = self.hue.as_ref().filter(|_| scale == 1.0);
        let by_hue = hue.zip(hues).and_then(|(kept, hues)| {
            let kept = Hues {
                step_px: kept.step_px.max(1),
                ln_g_b: kept.ln_g_b.clone(),
                ln_r_g: kept.ln_r_g.clone(),
            };
            kept.shift(hues)
        });
        let by_lines = answer.and_then(|answer| shift_by_lines(&curve, answer, peaks));
        let shift_px = by_lines.or(by_hue.map(|h| h.px));
        let hue_difference = by_hue.map(|h| h.difference);
        let advice = said!("this is not the same instrument, or it was moved: calibrate anew");
        let apart = by_hue
            .zip(by_lines)
            .map(|(hue, lines)| (hue.px - lines).abs() * step);
        let fit = match shift_px {
            _ if hue_difference.is_some_and(|d| d > MOST_ALIKE) => {
                Fit::No(tr!("the colours of its columns differ: {advice}", advice))
            }
            _ if apart.is_some_and(|nm| nm > MOST_APART_NM) => Fit::No(tr!(
                "its lines and its colours moved differently: {advice}",
                advice
            )),
            Some(px) if px.abs() > MOST_SHIFT_PX => {
                Fit::No(tr!("moved by {px} px: {advice}", px = fixed(px, 1), advice))
            }
            Some(px) if px.abs() * step < LEAST_SHIFT_NM => Fit::AsItIs,
            Some(px) => Fit::Moved(px),
            None => Fit::Unchecked,
        };
        let by = match fit {
            Fit::Moved(px) => px,
            _ => 0.0,
        };
        let [low, high] = self.axis.valid_nm;
        Applied {
            name: self.name.clone(),
            curve: curve.moved(by),
            valid_nm: (low, high),
            shift_px,
            shift_nm: shift_px.map(|px| px * step),
            hue_difference,
            fit,
        }
    }
}

/// By how many columns lines that are surely known lie to the right of where the axis has them.
fn shift_by_lines(curve: &Curve, answer: &Answer, peaks: &Peaks) -> Option<f64> {
    let best = answer
        .best
        .as_ref()
        .filter(|_| answer.state == State::Found)?;
    // Daylight has dark lines, which are not these.
    if best.lamp.is_dark() {
        return None;
    }
    let (from, to) = (-0.5 * curve.scale_px, 1.5 * curve.scale_px);
    let mut off: Vec<f64> = (best.matches.iter())
        .filter_map(|m| Some(peaks.peaks[m.peak].px - curve.px(m.landmark.nm, from, to)?))
        .collect();
    off.sort_by(f64::total_cmp);
    off.get(off.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_instrument_is_refused_in_words() {
        let refused = |text: &str| Instrument::read(text).expect_err("no instrument");
        assert!(refused("nm,value").contains("no JSON"));
        assert!(refused("{}").contains("another format"));
        let newer = format!("{{\"format\":\"{FORMAT}\",\"version\":2}}");
        assert!(refused(&newer).contains("version 2"));
        let empty = format!("{{\"format\":\"{FORMAT}\",\"version\":1}}");
        assert!(refused(&empty).contains("damaged"));
    }
}
