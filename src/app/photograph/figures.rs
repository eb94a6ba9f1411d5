//! Colour figures of a photograph that was read through a response: estimates, each with its band.

use super::{Photograph, response::NEEDED_NM};
use crate::{
    color::{
        Observer,
        blackbody::relative,
        quality::{FewFigures, Light, POINTS},
        xy_from_xyz,
        xyz::xyz_from_nm_values,
    },
    languages::fixed,
    photographs::response::STEP_NM,
};

/// A figure: low, best and high.
pub type Estimate = [f64; 3];

/// Figures of a light whose shape is known with some doubt; none where it does not reach.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourFigures {
    /// Correlated colour temperature, K.
    pub cct: Option<Estimate>,
    pub duv: Option<Estimate>,
    /// CIE 1931 x.
    pub x: Option<Estimate>,
    /// CIE 1931 y.
    pub y: Option<Estimate>,
    /// CRI.
    pub ra: Option<Estimate>,
    /// TM-30.
    pub rf: Option<Estimate>,
}

/// Lights that are drawn within the doubt.
const DRAWS: u64 = 200;
/// The band holds all but this share of them at each end.
const ENDS: f64 = 0.05;
/// Standard deviations in the bounds that a doubt is told by.
const BOUNDS: f64 = 1.645;
/// Errors of the shape keep their sign over some nm.
const TOGETHER_NM: f64 = 10.0;
/// Wavelengths that a temperature needs, nm.
const COLOUR_NM: (f64, f64) = (430.0, 660.0);
/// Ra and Rf with a wider band say nothing.
const WIDEST: f64 = 10.0;
/// A wider gap is none of the light's, nm.
const GAP_NM: f64 = 10.0;
const FIRST_NM: f64 = 360.0;

/// Numbers that look random, the same for the same draw.
struct Draw(u64);

impl Draw {
    /// Of mean 0 and standard deviation 1.
    fn normal(&mut self) -> f64 {
        let [a, b] = [self.roll(), self.roll()];
        (-2.0 * a.max(1e-300).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }

    fn roll(&mut self) -> f64 {
        // SplitMix64 (Steele, Lea, Flood 2014).
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The light where it is known, by rising wavelengths: nm, value, sigma of the value, of the nm.
type Known = Vec<[f64; 4]>;

impl ColourFigures {
    /// The figures of a photograph.
    ///
    /// # Errors
    /// Why there are none, in words.
    pub fn of(photograph: &Photograph) -> Result<Self, String> {
        let curve = (photograph.used_curve()).ok_or(said!("no axis: no colour figures"))?;
        let through = photograph.through.as_ref();
        let through = through.ok_or(said!("the instrument has no response: no colour figures"))?;
        if through.disagreement > through.most_disagreement {
            return Err(said!(
                "the camera's values are not proportional to light: colour figures would be wrong \
                 by 10 % and more"
            )
            .to_owned());
        }
        let profile = &photograph.found.profile;
        let needed = |c: &usize| (NEEDED_NM.0..=NEEDED_NM.1).contains(&curve.nm(*c as f64));
        if (0..profile.columns())
            .filter(needed)
            .any(|c| profile.clipped[c])
        {
            return Err(said!("over-exposed: take it again, darker").to_owned());
        }
        let last = profile.columns() as f64 - 1.0;
        let valid = photograph
            .reach_nm()
            .ok_or(said!("no axis: no colour figures"))?;
        let corrected = &through.corrected;
        let values = corrected
            .nm
            .iter()
            .zip(&corrected.value)
            .zip(&corrected.sigma);
        let known: Known = values
            .filter(|((nm, _), _)| (valid.0..=valid.1).contains(*nm))
            .filter_map(|((nm, value), sigma)| {
                let px = curve.px(*nm, 0.0, last)?;
                Some([*nm, (*value)?, (*sigma)?, curve.sigma(px)])
            })
            .collect();
        if !reaches(&known, COLOUR_NM) {
            return Err(tr!(
                "the light is not known from {from} to {to} nm: no colour figures",
                from = fixed(COLOUR_NM.0, 0),
                to = fixed(COLOUR_NM.1, 0)
            ));
        }
        Ok(Self::drawn(&known, through.bulb))
    }

    fn drawn(known: &Known, bulb: Option<(f64, f64)>) -> Self {
        let is_whole = reaches(known, NEEDED_NM);
        let of = |light: &[f64]| -> [Option<f64>; 6] {
            let few = FewFigures::of(&Light::of_nm_values(light));
            let xy = xy_from_xyz(xyz_from_nm_values(light, Observer::CIE_1931));
            let cct = few.cct.ok();
            let rendering = |of: Option<f64>| of.filter(|_| is_whole);
            [
                cct.as_ref().map(|c| c.kelvin),
                cct.as_ref().map(|c| c.duv),
                xy.map(|[x, _]| x),
                xy.map(|[_, y]| y),
                rendering(few.ra.ok()),
                rendering(few.rf.ok()),
            ]
        };
        let best = of(&on_nm(known));
        let mut drawn = [(); 6].map(|()| Vec::new());
        for number in 0..DRAWS {
            let light = on_nm(&moved(known, bulb, &mut Draw(number)));
            for (all, one) in drawn.iter_mut().zip(of(&light)) {
                all.extend(one);
            }
        }
        let [cct, duv, x, y, ra, rf] = std::array::from_fn(|k| {
            // A figure that some lights within the doubt have not is none.
            best[k]
                .filter(|_| drawn[k].len() == DRAWS as usize)
                .map(|best| {
                    drawn[k].sort_by(f64::total_cmp);
                    let ends = [ENDS, 1.0 - ENDS]
                        .map(|share| drawn[k][(share * (DRAWS - 1) as f64).round() as usize]);
                    [ends[0].min(best), best, ends[1].max(best)]
                })
        });
        let narrow = |of: &Estimate| of[2] - of[0] < WIDEST;
        Self {
            cct,
            duv,
            x,
            y,
            ra: ra.filter(narrow),
            rf: rf.filter(narrow),
        }
    }
}

/// A light is known throughout a range.
fn reaches(known: &Known, (from, to): (f64, f64)) -> bool {
    let ends =
        known.first().is_some_and(|k| k[0] <= from) && known.last().is_some_and(|k| k[0] >= to);
    ends && known.windows(2).all(|two| two[1][0] - two[0][0] <= GAP_NM)
}

/// One of the lights that the known one may be: its places, its bulb and its values moved.
fn moved(known: &Known, bulb: Option<(f64, f64)>, draw: &mut Draw) -> Known {
    let along = draw.normal();
    let warmer = draw.normal() / BOUNDS;
    let knots: Vec<f64> = (0..64).map(|_| draw.normal()).collect();
    (known.iter())
        .map(|[nm, value, sigma, sigma_nm]| {
            let place = (nm - known[0][0]) / TOGETHER_NM;
            let (left, part) = (place as usize, place.fract());
            let right = knots[(left + 1) % knots.len()];
            let left = knots[left % knots.len()];
            // The variance of what lies between two knots is less than theirs.
            let between = (left * (1.0 - part) + right * part)
                / (part * part + (1.0 - part) * (1.0 - part)).sqrt();
            let bulb = bulb.map_or(1.0, |(kelvin, doubt)| {
                relative(*nm, kelvin + warmer * doubt) / relative(*nm, kelvin)
            });
            [
                nm + along * sigma_nm,
                (value * bulb + sigma * between).max(0.0),
                *sigma,
                *sigma_nm,
            ]
        })
        .collect()
}

/// The light on whole nm from 360 on, as at its ends beyond them.
fn on_nm(known: &Known) -> Vec<f64> {
    let mut next = 0;
    (0..POINTS)
        .map(|i| FIRST_NM + i as f64)
        .map(|nm| {
            while next < known.len() && known[next][0] < nm {
                next += 1;
            }
            match (next.checked_sub(1).map(|i| known[i]), known.get(next)) {
                (Some(left), Some(right)) => {
                    let part = (nm - left[0]) / (right[0] - left[0]).max(STEP_NM * 0.01);
                    left[1] + (right[1] - left[1]) * part
                }
                (Some(end), None) => end[1],
                (None, Some(end)) => end[1],
                (None, None) => 0.0,
            }
        })
        .collect()
}
