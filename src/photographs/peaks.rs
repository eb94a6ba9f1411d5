//! Lines in a profile: where they stand, how wide, how sure, and of which colour.

use super::{
    colours::Hue,
    profile::Profile,
    smooth::{gaussian, largest, percentile},
};

/// A line of light, or a dark one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Its place in columns, the middle of the first at 0.
    pub px: f64,
    /// Standard deviation of the place.
    pub error_px: f64,
    /// Prominence over the brightest column; of a dark line over the light around it.
    pub height: f64,
    /// Full width at half prominence.
    pub fwhm_px: f64,
    /// Over-exposed: its height is not known.
    pub is_clipped: bool,
    /// Wider than a line of this picture is.
    pub is_band: bool,
    /// Its colour, where it has one.
    pub hue: Option<Hue>,
}

/// The lines of a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Peaks {
    /// In the order of their places.
    pub peaks: Vec<Peak>,
    /// The least height that is seen.
    pub limit: f64,
    /// The width of a line that is no band.
    pub width_px: f64,
    /// Narrower than light through the lens and the slit can be: drawn lines, which were ignored.
    pub hairlines: usize,
}

impl Peaks {
    /// The three strongest hold most of the light.
    pub fn stand_out(&self) -> bool {
        let mut heights: Vec<f64> = self.peaks.iter().map(|p| p.height).collect();
        heights.sort_by(|a, b| b.total_cmp(a));
        heights.iter().take(3).sum::<f64>() >= BRIGHT
    }
}

/// Search parameters.
struct Search {
    /// Least prominence.
    least: f64,
    /// Unit of prominence.
    top: f64,
    /// Window of prominence, as a share of the columns.
    window: f64,
    /// Widest line, as a share of the columns.
    widest: f64,
}

/// A line of light is wider than this in any picture, columns.
const NARROWEST: f64 = 1.75;
/// Nor is one narrower than this share of the width of the picture's lines: the slit is the same.
const NARROW: f64 = 0.45;
/// Most lines that are kept.
const MOST: usize = 22;
/// Smoothing before lines are looked for, and what it leaves of the noise.
const SMOOTHING: (f64, f64) = (0.7, 0.75);
/// Three lines that add to more than this share of the brightest column are bright lines.
const BRIGHT: f64 = 0.6;

/// Rise above the surroundings, before it is judged.
struct Bump {
    at: usize,
    prominence: f64,
    /// Edges at half its prominence.
    from: f64,
    to: f64,
}

impl Bump {
    fn fwhm(&self) -> f64 {
        self.to - self.from
    }
}

/// The lines of light in a profile, the `MOST` most prominent.
pub fn bright(profile: &Profile) -> Peaks {
    let light = gaussian(&profile.sum(), SMOOTHING.0);
    let top = largest(&light);
    let noise = profile.sum_sigma() * SMOOTHING.1;
    let search = Search {
        least: (0.004 * top).max(5.0 * noise),
        top,
        window: 0.16,
        widest: 0.06,
    };
    let mut found = find(&light, profile, &search, noise);
    for peak in &mut found.peaks {
        peak.hue = hue_of_line(profile, peak);
    }
    found
}

/// The dark lines of a profile: none where lines of light stand out.
pub fn dark(profile: &Profile, bright: &Peaks) -> Option<Peaks> {
    if bright.stand_out() {
        return None;
    }
    let light = gaussian(&profile.sum(), SMOOTHING.0);
    let around = gaussian(&light, profile.columns() as f64 / 25.0);
    let top = largest(&around);
    if top <= 0.0 {
        return None;
    }
    let seen = |env: f64| env >= 0.12 * top;
    let depth: Vec<f64> = (light.iter().zip(&around))
        .map(|(y, env)| {
            if seen(*env) {
                ((env - y) / env).min(0.5)
            } else {
                0.0
            }
        })
        .collect();
    let lit: Vec<f64> = around.iter().copied().filter(|env| seen(*env)).collect();
    let noise = profile.sum_sigma() / percentile(&lit, 0.5).max(f64::MIN_POSITIVE);
    let search = Search {
        least: (4.0 * noise).max(0.02),
        top: 1.0,
        window: 0.08,
        widest: 0.025,
    };
    let mut found = find(&depth, profile, &search, noise);
    for peak in &mut found.peaks {
        let at = (peak.px.round() as usize).min(profile.columns() - 1);
        let light = profile.channels.each_ref().map(|c| c[at]);
        peak.hue = (!profile.is_grey)
            .then(|| Hue::of(light, profile.sigma, peak.is_clipped))
            .flatten();
    }
    Some(found)
}

fn find(light: &[f64], profile: &Profile, search: &Search, noise: f64) -> Peaks {
    let columns = light.len() as f64;
    let mut hairlines = 0;
    let mut bumps = Vec::new();
    for bump in bumps_of(light, (search.window * columns) as usize) {
        if bump.prominence < search.least || bump.fwhm() >= search.widest * columns {
            continue;
        }
        if bump.fwhm() <= NARROWEST {
            hairlines += 1;
        } else {
            bumps.push(bump);
        }
    }
    bumps.sort_by(|a, b| b.prominence.total_cmp(&a.prominence));
    let widths: Vec<f64> = bumps.iter().take(8).map(Bump::fwhm).collect();
    let width_px = percentile(&widths, 0.3).max(NARROWEST);
    let before = bumps.len();
    bumps.retain(|bump| bump.fwhm() >= NARROW * width_px);
    hairlines += before - bumps.len();
    bumps.truncate(MOST);
    let mut peaks: Vec<Peak> = (bumps.iter())
        .map(|bump| peak_of(bump, light, profile, noise, width_px))
        .map(|peak| Peak {
            height: peak.height / search.top,
            ..peak
        })
        .collect();
    peaks.sort_by(|a, b| a.px.total_cmp(&b.px));
    Peaks {
        peaks,
        limit: search.least / search.top.max(f64::MIN_POSITIVE),
        width_px,
        hairlines,
    }
}

/// Every local maximum with its prominence within a window.
fn bumps_of(light: &[f64], window: usize) -> impl Iterator<Item = Bump> + '_ {
    let tops = (1..light.len().saturating_sub(1))
        .filter(|&i| light[i] > light[i - 1] && light[i] >= light[i + 1]);
    tops.map(move |at| {
        let reach = window / 2;
        let lowest = |run: &mut dyn Iterator<Item = usize>| {
            run.map(|i| light[i])
                .take_while(|y| *y <= light[at])
                .fold(light[at], f64::min)
        };
        let left = lowest(&mut (at.saturating_sub(reach)..=at).rev());
        let right = lowest(&mut (at..=(at + reach).min(light.len() - 1)));
        let prominence = light[at] - left.max(right);
        let (from, to) = feet(light, at, light[at] - 0.5 * prominence);
        Bump {
            at,
            prominence,
            from,
            to,
        }
    })
}

/// Positions on both sides of a place where a list falls below a level, between the columns.
fn feet(light: &[f64], at: usize, level: f64) -> (f64, f64) {
    let below = |i: &usize| light[*i] <= level;
    let from = match (0..at).rev().find(below) {
        Some(i) => i as f64 + part(level - light[i], light[i + 1] - light[i]),
        None => 0.0,
    };
    let to = match (at + 1..light.len()).find(below) {
        Some(i) => i as f64 - part(level - light[i], light[i - 1] - light[i]),
        None => light.len() as f64 - 1.0,
    };
    (from, to)
}

fn part(of: f64, whole: f64) -> f64 {
    if whole > 0.0 { of / whole } else { 0.0 }
}

fn peak_of(bump: &Bump, light: &[f64], profile: &Profile, noise: f64, width_px: f64) -> Peak {
    let level = light[bump.at] - 0.5 * bump.prominence;
    let inside = bump.from.ceil() as usize..=(bump.to.floor() as usize).min(light.len() - 1);
    let is_clipped = inside.clone().any(|i| profile.clipped[i]);
    let weights = inside.map(|i| (i as f64, (light[i] - level).max(0.0)));
    let (moment, sum) = weights.fold((0.0, 0.0), |(m, s), (i, w)| (m + i * w, s + w));
    let px = if is_clipped || sum <= 0.0 {
        0.5 * (bump.from + bump.to)
    } else {
        moment / sum
    };
    let fwhm = bump.fwhm();
    let share = if is_clipped { 0.15 } else { 0.03 };
    let by_noise = 0.5 * noise * fwhm.sqrt() / bump.prominence;
    let is_band = fwhm > 1.5 * width_px;
    let of_a_band = if is_band {
        0.22 * (fwhm - width_px)
    } else {
        0.0
    };
    Peak {
        px,
        error_px: (by_noise.max(0.08) + share * fwhm).hypot(of_a_band),
        height: bump.prominence,
        fwhm_px: fwhm,
        is_clipped,
        is_band,
        hue: None,
    }
}

/// The colour of what a line adds to the light beside it.
fn hue_of_line(profile: &Profile, peak: &Peak) -> Option<Hue> {
    if profile.is_grey {
        return None;
    }
    let last = profile.columns() - 1;
    let at = (peak.px.round().max(0.0) as usize).min(last);
    let away = (1.6 * peak.fwhm_px).ceil() as usize;
    let (left, right) = (at.saturating_sub(away), (at + away).min(last));
    let mean = |channel: &[f64], at: usize| {
        let near = &channel[at.saturating_sub(1)..=(at + 1).min(last)];
        near.iter().sum::<f64>() / near.len() as f64
    };
    let light =
        (profile.channels.each_ref()).map(|c| mean(c, at) - mean(c, left).min(mean(c, right)));
    Hue::of(light, profile.sigma, peak.is_clipped)
}
