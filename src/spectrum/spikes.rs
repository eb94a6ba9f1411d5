//! Finding spikes: prominence proposes, energy decides.
//!
//! A line is worth two numbers when it carries a visible share of the light's power, so the only
//! threshold a person sees is a share of power; the smallest height worth looking at follows
//! from it and the widest line allowed. Candidates are local maxima judged by their prominence
//! (how far one must come down before climbing higher); neighbours that no valley parts are one
//! group; what stands above the lower convex hull of a group's window is its energy. That energy
//! is taken out of the spectrum and put into the spike, so `S = smooth + sum of residues` holds
//! to rounding and nothing is lost or counted twice.

mod line;
mod peaks;

use self::{
    line::{Taken, lower_hull, weigh, weigh_window, window_of},
    peaks::{Peak, borders, candidates, group, measured_part},
};
use super::{
    band::Band,
    line::{GAUSSIAN_AREA, Line},
    noise::Noise,
};

/// Settings of the detector.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SpikeSettings {
    /// Least share of the total power that a spike must carry, 0-1 (0.005 is the default 0.5 %).
    pub threshold: f64,
    /// Widest line, full width at half maximum in nm.
    pub max_width_nm: f64,
    /// Also look for absorption lines, which become negative spikes. What stands up is found first
    /// and as without them.
    pub dips: bool,
}

impl Default for SpikeSettings {
    fn default() -> Self {
        Self {
            threshold: 0.005,
            max_width_nm: 10.0,
            dips: false,
        }
    }
}

/// A line taken out of the spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundSpike {
    /// Centroid and energy of what was taken out.
    pub spike: Line,
    /// Full width at half maximum of a Gaussian of that energy and height, nm.
    pub width_nm: f64,
    /// Number of local maxima that no valley parted (the 577/579 nm mercury pair is one spike).
    pub peaks: usize,
    /// First and last wavelength of the window it was taken from, nm.
    pub window_nm: [f64; 2],
}

/// The part of a spectrum that a line removes when it becomes a spike.
#[derive(Clone, Debug, PartialEq)]
pub struct LineShape {
    /// The spike that stands for it.
    pub spike: Line,
    /// Index of the first grid point it takes something from.
    pub first: usize,
    /// Values removed from that grid point and those after it; negative for an absorption line.
    pub residue: Vec<f64>,
}

impl LineShape {
    /// Takes its energy out of the smooth part.
    pub(crate) fn take_from(&self, smooth: &mut [f64]) {
        for (v, r) in smooth[self.first..].iter_mut().zip(&self.residue) {
            *v -= r;
        }
    }

    /// Gives its energy back to the smooth part.
    pub(crate) fn give_back_to(&self, smooth: &mut [f64]) {
        for (v, r) in smooth[self.first..].iter_mut().zip(&self.residue) {
            *v += r;
        }
    }
}

/// Constraints that manual edits place on a detector.
#[derive(Clone, Copy, Debug, Default)]
pub struct Constraints<'a> {
    /// Places (nm) whose line stays in the smooth part.
    pub leave: &'a [f64],
    /// The power that shares refer to, when lines were taken out beforehand; the values' own
    /// otherwise.
    pub power: Option<f64>,
}

/// A spectrum taken apart on its grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Decomposition {
    /// Values left for the smooth part, one per grid point.
    pub smooth: Vec<f64>,
    /// The lines, by rising wavelength.
    pub spikes: Vec<FoundSpike>,
    /// Integral of the absolute value over the band, the power that shares refer to.
    pub power: f64,
}

impl Decomposition {
    /// Nothing taken out.
    pub(crate) fn untouched(band: Band, values: &[f64]) -> Self {
        Self {
            smooth: values.to_vec(),
            spikes: Vec::new(),
            power: absolute_power(band, values),
        }
    }
}

/// Integral of `|S|` over the band, in value x nm.
pub(crate) fn absolute_power(band: Band, values: &[f64]) -> f64 {
    let last = values.len() - 1;
    let sum: f64 = values.iter().map(|v| v.abs()).sum();
    debug_assert_eq!(values.len(), band.points());
    sum - 0.5 * (values[0].abs() + values[last].abs())
}

/// A line may measure this much wider than asked for: its hull baseline is not exact.
const WIDTH_TOLERANCE: f64 = 1.05;
/// Greatest distance of a line from a requested place, nm.
const WISH_REACH_NM: f64 = 3.0;
/// A line taken by wish may be this wide even when the detector looks for narrower ones.
const WIDEST_WISHED_NM: f64 = 20.0;
/// A line must be this many standard deviations of the noise prominent. The highest of 400 noisy
/// values stands 6 above the lowest about it, and the noise is known to a fifth.
const ABOVE_NOISE: f64 = 8.0;
/// A second look finds lines that stood on the flank of stronger ones.
const PASSES: usize = 2;

/// The default detector on values on a band's grid.
///
/// Every spike found carries at least `threshold` of the power and measures at most 1.05 of the
/// widest line. A spectrum without power has no spikes.
pub fn detect(band: Band, values: &[f64], settings: SpikeSettings) -> Decomposition {
    detect_with(band, values, settings, Constraints::default())
}

/// The default detector with places whose lines are left in whatever the thresholds say.
pub(super) fn detect_with(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
    constraints: Constraints<'_>,
) -> Decomposition {
    detect_telling(band, values, settings, constraints, &mut |_, _| {})
}

/// The default detector with what each line takes out of the spectrum, the heaviest line first,
/// so that some of the lines can be given back without looking again.
pub fn detect_shapes(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
) -> (Decomposition, Vec<LineShape>) {
    let mut shapes = Vec::new();
    let mut tell = |line: &Taken, sign: f64| shapes.push(line.shape(band, sign));
    let parts = detect_telling(band, values, settings, Constraints::default(), &mut tell);
    shapes.sort_by(|a, b| b.spike.weight.abs().total_cmp(&a.spike.weight.abs()));
    (parts, shapes)
}

/// The narrow dips of values on a band's grid: places (nm) and depths below the lower of the two
/// shoulders, no wider than `max_width_nm`. Where lines were taken out, noise makes as many of them
/// as it made lines.
pub fn narrow_dips(band: Band, values: &[f64], max_width_nm: f64) -> Vec<(f64, f64)> {
    let upright: Vec<f64> = values.iter().map(|v| -v).collect();
    let inside = 1..values.len().saturating_sub(1);
    candidates(&upright, f64::MIN_POSITIVE, max_width_nm)
        .into_iter()
        .filter(|peak| inside.contains(&peak.at))
        .map(|peak| (band.nm(peak.at), peak.prominence))
        .collect()
}

/// The parts that a factor's dips remove from it, in the order found: a factor has no emission
/// lines, and a peak between two dips is not one.
pub(super) fn dip_shapes(band: Band, values: &[f64], settings: SpikeSettings) -> Vec<LineShape> {
    let mut parts = Decomposition::untouched(band, values);
    let mut shapes = Vec::new();
    if parts.power > 0.0 && parts.power.is_finite() {
        let mut tell = |line: &Taken, sign: f64| shapes.push(line.shape(band, sign));
        take_dips(
            band,
            &mut parts,
            settings,
            Constraints::default(),
            &mut tell,
        );
    }
    shapes
}

/// The detector; `tell` hears of every line taken, with the sign of its weight.
fn detect_telling(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
    constraints: Constraints<'_>,
    tell: &mut dyn FnMut(&Taken, f64),
) -> Decomposition {
    let mut parts = Decomposition::untouched(band, values);
    if let Some(power) = constraints.power {
        parts.power = power;
    }
    let power = parts.power;
    if !(power > 0.0 && power.is_finite()) {
        return parts;
    }
    let noise = Noise::of(values);
    let above = (1.0, Some(&noise));
    take_lines(band, &mut parts, settings, constraints, above, tell);
    if settings.dips {
        take_dips(band, &mut parts, settings, constraints, tell);
    }
    parts
        .spikes
        .sort_by(|a, b| a.spike.at_nm.total_cmp(&b.spike.at_nm));
    parts
}

/// Takes dips out of `parts.smooth`. Fraunhofer's lines stand so dense that they look like noise, so
/// that noise is not asked.
fn take_dips(
    band: Band,
    parts: &mut Decomposition,
    settings: SpikeSettings,
    constraints: Constraints<'_>,
    tell: &mut dyn FnMut(&Taken, f64),
) {
    parts.smooth.iter_mut().for_each(|v| *v = -*v);
    take_lines(band, parts, settings, constraints, (-1.0, None), tell);
    parts.smooth.iter_mut().for_each(|v| *v = -*v);
}

/// Takes lines that stand up out of `parts.smooth` and above the noise, if any; `sign` is what their
/// weights are multiplied by (the caller turns the spectrum over for dips).
fn take_lines(
    band: Band,
    parts: &mut Decomposition,
    settings: SpikeSettings,
    constraints: Constraints<'_>,
    (sign, noise): (f64, Option<&Noise>),
    tell: &mut dyn FnMut(&Taken, f64),
) {
    let width = settings.max_width_nm;
    let least_energy = settings.threshold * parts.power;
    let least_height = least_energy / (GAUSSIAN_AREA * width);
    let (start, end) = measured_part(&parts.smooth, width);
    for _ in 0..PASSES {
        let mut peaks = candidates(&parts.smooth[start..end], least_height, width);
        peaks.iter_mut().for_each(|peak| peak.at += start);
        if let Some(noise) = noise {
            peaks.retain(|peak| noise.is_below(peak.at, peak.prominence, ABOVE_NOISE));
        }
        let groups = group(&parts.smooth, &peaks, width);
        let borders = borders(&parts.smooth, &groups, (start, end - 1));
        let mut found_one = false;
        for (members, limits) in groups.iter().zip(borders) {
            // Of what only rises towards an end nobody knows whether it is a line.
            if members
                .iter()
                .any(|peak| peak.at == start || peak.at + 1 == end)
            {
                continue;
            }
            let Some(line) = weigh(band, &parts.smooth, members, limits, (start, end)) else {
                continue;
            };
            let strong_and_narrow =
                line.energy >= least_energy && line.width_nm <= WIDTH_TOLERANCE * width;
            let found = line.found(band, members.len(), sign);
            let unwanted = constraints.leave.iter().any(|nm| found.covers(*nm));
            if unwanted || !strong_and_narrow {
                continue;
            }
            line.take_from(&mut parts.smooth);
            tell(&line, sign);
            parts.spikes.push(found);
            found_one = true;
        }
        if !found_one {
            break;
        }
    }
}

/// The window of the single line nearest to a place (nm), whatever its strength; `None` when no
/// local maximum (with `sign` -1: no minimum) stands near. Neighbours are not joined to it.
pub(crate) fn window_near(
    band: Band,
    values: &[f64],
    at_nm: f64,
    max_width_nm: f64,
    sign: f64,
) -> Option<[f64; 2]> {
    let upright: Vec<f64> = values.iter().map(|v| sign * v).collect();
    let values = &upright[..];
    let widest = max_width_nm.max(WIDEST_WISHED_NM);
    let lines: Vec<Vec<Peak>> = candidates(values, f64::MIN_POSITIVE, widest)
        .into_iter()
        .map(|peak| vec![peak])
        .collect();
    let distance = |peak: &Peak| (band.nm(peak.at) - at_nm).abs();
    lines
        .iter()
        .zip(borders(values, &lines, (0, values.len() - 1)))
        .filter(|(line, _)| distance(&line[0]) <= WISH_REACH_NM)
        .min_by(|a, b| distance(&a.0[0]).total_cmp(&distance(&b.0[0])))
        .and_then(|(line, limits)| window_of(line, limits))
        .map(|(first, last)| [band.nm(first), band.nm(last)])
}

/// Takes what stands above the lower hull of a window out of values on a band's grid; `None`
/// (and nothing taken) when nothing does. `sign` -1 takes what hangs below the upper hull.
pub(super) fn take_window(
    band: Band,
    values: &mut [f64],
    window_nm: [f64; 2],
    sign: f64,
) -> Option<FoundSpike> {
    let index = |nm: f64| (nm - band.min_nm()).round().clamp(0.0, band.steps() as f64) as usize;
    let (first, last) = (index(window_nm[0]), index(window_nm[1]));
    if last <= first {
        return None;
    }
    let mut upright: Vec<f64> = values.iter().map(|v| sign * v).collect();
    let highest = (first..=last).max_by(|i, j| upright[*i].total_cmp(&upright[*j]))?;
    let window = &upright[first..=last];
    // A line that an end of the range cuts in its middle has one foot.
    let baseline = if highest == 0 {
        vec![window[last - first]; window.len()]
    } else if highest == upright.len() - 1 {
        vec![window[0]; window.len()]
    } else {
        lower_hull(window)
    };
    let line = weigh_window(band, &upright, (first, last), &baseline)?;
    let found = line.found(band, 1, sign);
    line.take_from(&mut upright);
    for (v, u) in values.iter_mut().zip(&upright) {
        *v = sign * u;
    }
    Some(found)
}

impl FoundSpike {
    /// True if a place belongs to this line: within reach of its centroid and inside its window.
    pub(crate) fn covers(&self, at_nm: f64) -> bool {
        (self.spike.at_nm - at_nm).abs() <= WISH_REACH_NM
            && (self.window_nm[0]..=self.window_nm[1]).contains(&at_nm)
    }
}
