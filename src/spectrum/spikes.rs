//! Finding spikes: prominence proposes, energy decides.
//!
//! A line is worth two numbers when it carries a visible share of the light's power, so the only
//! threshold a person sees is a share of power; the smallest height worth looking at follows
//! from it and the widest line allowed. Candidates are local maxima judged by their prominence
//! (how far one must come down before climbing higher); neighbours that no valley parts are one
//! group; what stands above the lower convex hull of a group's window is its energy. That energy
//! is taken out of the spectrum and put into the spike, so `S = smooth + sum of residues` holds
//! to rounding and nothing is lost or counted twice.

use super::{
    band::Band,
    composite::{GAUSSIAN_AREA, Spike},
    noise::Noise,
};

/// What the detector is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpikeSettings {
    /// Least share of the total power that a spike must carry, 0-1 (0.005 is the default 0.5 %).
    pub threshold: f64,
    /// Widest line, full width at half maximum in nm.
    pub max_width_nm: f64,
    /// Also look for absorption lines, which become negative spikes.
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
    pub spike: Spike,
    /// Full width at half maximum of a Gaussian of that energy and height, nm.
    pub width_nm: f64,
    /// Number of local maxima that no valley parted (the 577/579 nm mercury pair is one spike).
    pub peaks: usize,
    /// First and last wavelength of the window it was taken from, nm.
    pub window_nm: [f64; 2],
}

/// What a line takes out of a spectrum when it becomes a spike.
#[derive(Clone, Debug, PartialEq)]
pub struct LineShape {
    /// The spike that stands for it.
    pub spike: Spike,
    /// Index of the first grid point it takes something from.
    pub first: usize,
    /// What it takes from that grid point and those after it; negative for an absorption line.
    pub residue: Vec<f64>,
}

impl LineShape {
    /// Gives its energy back to the smooth part.
    pub fn give_back_to(&self, smooth: &mut [f64]) {
        for (v, r) in smooth[self.first..].iter_mut().zip(&self.residue) {
            *v += r;
        }
    }
}

/// What a person's edits ask of a detector.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wishes<'a> {
    /// Places (nm) whose line stays in the smooth part.
    pub leave: &'a [f64],
    /// The power that shares refer to, when lines were taken out beforehand; the values' own
    /// otherwise.
    pub power: Option<f64>,
}

/// A spectrum taken apart on its grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Decomposition {
    /// What is left for the smooth part, one value per grid point.
    pub smooth: Vec<f64>,
    /// The lines, by rising wavelength.
    pub spikes: Vec<FoundSpike>,
    /// Integral of the absolute value over the band, the power that shares refer to.
    pub power: f64,
}

impl Decomposition {
    /// Nothing taken out.
    pub fn untouched(band: Band, values: &[f64]) -> Self {
        Self {
            smooth: values.to_vec(),
            spikes: Vec::new(),
            power: absolute_power(band, values),
        }
    }
}

/// Integral of `|S|` over the band, in value x nm.
pub fn absolute_power(band: Band, values: &[f64]) -> f64 {
    let last = values.len() - 1;
    let sum: f64 = values.iter().map(|v| v.abs()).sum();
    debug_assert_eq!(values.len(), band.points());
    sum - 0.5 * (values[0].abs() + values[last].abs())
}

/// Peaks closer than this are always one line: no spectrometer in ordinary use parts them.
const ALWAYS_TOGETHER_NM: f64 = 4.0;
/// Two peaks closer than the widest line are one when the valley between keeps this share of the
/// lower one's height.
const SHALLOW_VALLEY: f64 = 0.6;
/// Prominence is looked for within this many line widths, so that a far background cannot decide.
const PROMINENCE_WINDOW_WIDTHS: f64 = 6.0;
/// The local ground of a pair is the lowest value within this many line widths outside it.
const GROUND_WIDTHS: f64 = 2.0;
/// A line's window reaches this many of its widths beyond its peak: a Gaussian has 0.04 % left.
const WINDOW_WIDTHS: f64 = 1.5;
/// One more nm on each side, so that a line of one sample still has a foot.
const WINDOW_MARGIN_NM: f64 = 1.0;
/// Narrowest width used for a window: a line between two samples looks this wide.
const NARROWEST_NM: f64 = 2.0;
/// A line may measure this much wider than asked for: its hull baseline is not exact.
const WIDTH_TOLERANCE: f64 = 1.05;
/// How far from a wished place a line may stand.
const WISH_REACH_NM: f64 = 3.0;
/// A line taken by wish may be this wide even when the detector looks for narrower ones.
const WIDEST_WISHED_NM: f64 = 20.0;
/// Where dips are looked for, a line must carry this share of the power, whatever the threshold:
/// between two weak dips the spectrum stands up like a weak line, and would be taken for one
/// before the dips are looked at.
const LEAST_BESIDE_DIPS: f64 = 0.005;
/// The same for its width: between two wide bands of absorption the spectrum stands up widely.
const WIDEST_BESIDE_DIPS_NM: f64 = 10.0;
/// A line must be this many standard deviations of the noise prominent. The highest of 400 noisy
/// values stands 6 above the lowest about it, and the noise is known to a fifth.
const ABOVE_NOISE: f64 = 8.0;
/// Where an end of the range stands this share of a line's height above its other foot, it cuts
/// the line's flank.
const CUT_FLANK: f64 = 0.1;
/// A second look finds lines that stood on the flank of stronger ones.
const PASSES: usize = 2;

/// The default detector on values on a band's grid.
///
/// Every spike found carries at least `threshold` of the power and measures at most 1.05 of the
/// widest line. A spectrum without power has no spikes.
pub fn detect(band: Band, values: &[f64], settings: SpikeSettings) -> Decomposition {
    detect_with(band, values, settings, Wishes::default())
}

/// The default detector with places whose lines are left in whatever the thresholds say.
pub fn detect_with(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
    wishes: Wishes<'_>,
) -> Decomposition {
    detect_telling(band, values, settings, wishes, &mut |_, _| {})
}

/// The default detector with what each line takes out of the spectrum, the heaviest line first,
/// so that some of the lines can be given back without looking again.
pub fn detect_shapes(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
) -> (Decomposition, Vec<LineShape>) {
    let mut shapes = Vec::new();
    let parts = detect_telling(
        band,
        values,
        settings,
        Wishes::default(),
        &mut |line, sign| {
            shapes.push(LineShape {
                spike: line.found(band, 1, sign).spike,
                first: line.first,
                residue: line.residue.iter().map(|r| sign * r).collect(),
            });
        },
    );
    shapes.sort_by(|a, b| b.spike.weight.abs().total_cmp(&a.spike.weight.abs()));
    (parts, shapes)
}

/// The detector; `tell` hears of every line taken, with the sign of its weight.
fn detect_telling(
    band: Band,
    values: &[f64],
    settings: SpikeSettings,
    wishes: Wishes<'_>,
    tell: &mut dyn FnMut(&Line, f64),
) -> Decomposition {
    let mut parts = Decomposition::untouched(band, values);
    if let Some(power) = wishes.power {
        parts.power = power;
    }
    let power = parts.power;
    if !(power > 0.0 && power.is_finite()) {
        return parts;
    }
    let beside_dips = SpikeSettings {
        threshold: settings.threshold.max(LEAST_BESIDE_DIPS),
        max_width_nm: settings.max_width_nm.min(WIDEST_BESIDE_DIPS_NM),
        ..settings
    };
    let for_lines = if settings.dips { beside_dips } else { settings };
    let noise = Noise::of(values);
    take_lines(
        band,
        &mut parts,
        for_lines,
        wishes,
        (1.0, Some(&noise)),
        tell,
    );
    if settings.dips {
        parts.smooth.iter_mut().for_each(|v| *v = -*v);
        // Fraunhofer's lines stand so dense that they look like noise, and who asks for dips knows
        // where to look.
        take_lines(band, &mut parts, settings, wishes, (-1.0, None), tell);
        parts.smooth.iter_mut().for_each(|v| *v = -*v);
    }
    parts
        .spikes
        .sort_by(|a, b| a.spike.at_nm.total_cmp(&b.spike.at_nm));
    parts
}

/// Takes lines that stand up out of `parts.smooth` and above the noise, if any; `sign` is what their
/// weights are multiplied by (the caller turns the spectrum over for dips).
fn take_lines(
    band: Band,
    parts: &mut Decomposition,
    settings: SpikeSettings,
    wishes: Wishes<'_>,
    (sign, noise): (f64, Option<&Noise>),
    tell: &mut dyn FnMut(&Line, f64),
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
            let unwanted = wishes.leave.iter().any(|nm| found.covers(*nm));
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
pub fn window_near(
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
pub fn take_window(
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

/// A local maximum: its index, its width at half prominence, and that prominence: how far one
/// must come down before climbing higher.
#[derive(Clone, Copy, Debug)]
struct Peak {
    at: usize,
    width: f64,
    prominence: f64,
}

/// First index and one past the last of what was measured: a table that ends inside the range
/// goes on as zeros. It ends where the values drop from their height at once; where they come
/// down first, the zeros are the dark ground on which a lamp's lines stand.
fn measured_part(values: &[f64], width: f64) -> (usize, usize) {
    let near = width.ceil() as usize;
    let is_end = |inwards: &mut dyn Iterator<Item = &f64>| {
        let beside: Vec<f64> = inwards.take(near.max(3)).copied().collect();
        let highest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        // A table that begins between two grid points fills the first of them in part.
        let edge = highest(&beside[..beside.len().min(2)]);
        // A line near the end may tower over the rest.
        let mut usual = beside.clone();
        usual.sort_by(f64::total_cmp);
        let usual = usual.get(usual.len() / 2).copied().unwrap_or(0.0);
        beside.iter().all(|v| *v != 0.0) && edge > 0.5 * usual
    };
    let lit = |v: &f64| *v != 0.0;
    let start = values.iter().position(lit).unwrap_or(0);
    let end = values.iter().rposition(lit).map_or(0, |last| last + 1);
    (
        if is_end(&mut values[start..].iter()) {
            start
        } else {
            0
        },
        if is_end(&mut values[..end].iter().rev()) {
            end
        } else {
            values.len()
        },
    )
}

/// Local maxima that are prominent and narrow enough. The ends stand beside a floor of
/// `min(min S, 0)`, so that what rises towards them parts the lines beside it.
fn candidates(values: &[f64], least_height: f64, max_width: f64) -> Vec<Peak> {
    let floor = values.iter().copied().fold(0.0, f64::min);
    let reach = (PROMINENCE_WINDOW_WIDTHS * max_width).ceil() as usize / 2;
    let n = values.len();
    let mut peaks = Vec::new();
    let mut i = 0;
    while i < n {
        let before = if i == 0 { floor } else { values[i - 1] };
        if values[i] <= before {
            i += 1;
            continue;
        }
        // A flat top is one maximum, at its middle; one that touches an end is at the end.
        let mut end = i;
        while end + 1 < n && values[end + 1] == values[i] {
            end += 1;
        }
        let after = if end + 1 == n { floor } else { values[end + 1] };
        let at = match (i, end + 1) {
            (0, _) => 0,
            (_, past) if past == n => end,
            _ => usize::midpoint(i, end),
        };
        if after < values[i]
            && let Some(peak) = prominent(values, at, floor, reach, least_height)
            && peak.width <= max_width
        {
            peaks.push(peak);
        }
        i = end + 1;
    }
    peaks
}

/// The maximum at `at`, or `None` when it is not prominent enough.
fn prominent(
    values: &[f64],
    at: usize,
    floor: f64,
    reach: usize,
    least_height: f64,
) -> Option<Peak> {
    let top = values[at];
    // Indices are signed: -1 and n are the floor beside the range.
    let n = values.len() as isize;
    let (index, at) = (at, at as isize);
    let value = |i: isize| {
        if i < 0 || i >= n {
            floor
        } else {
            values[i as usize]
        }
    };
    let (first, last) = ((at - reach as isize).max(-1), (at + reach as isize).min(n));
    let lowest_towards = |step: isize| {
        let (mut i, mut base, mut lowest) = (at, at, top);
        while i >= first && i <= last && value(i) <= top {
            if value(i) < lowest {
                lowest = value(i);
                base = i;
            }
            i += step;
        }
        (base, lowest)
    };
    let (left_base, left) = lowest_towards(-1);
    let (right_base, right) = lowest_towards(1);
    let prominence = top - left.max(right);
    if prominence < least_height {
        return None;
    }
    let half = top - 0.5 * prominence;
    let crossing = |step: isize, base: isize| {
        let mut i = at;
        while i != base && value(i) > half {
            i += step;
        }
        let x = i as f64;
        if value(i) < half {
            x - step as f64 * (half - value(i)) / (value(i - step) - value(i))
        } else {
            x
        }
    };
    Some(Peak {
        at: index,
        width: crossing(1, right_base) - crossing(-1, left_base),
        prominence,
    })
}

/// Neighbouring candidates joined into groups.
fn group(values: &[f64], peaks: &[Peak], width: f64) -> Vec<Vec<Peak>> {
    let mut groups: Vec<Vec<Peak>> = Vec::new();
    for peak in peaks {
        let joins = groups
            .last()
            .and_then(|g| g.last())
            .is_some_and(|before| together(values, before.at, peak.at, width));
        match groups.last_mut() {
            Some(last) if joins => last.push(*peak),
            _ => groups.push(vec![*peak]),
        }
    }
    groups
}

fn together(values: &[f64], left: usize, right: usize, width: f64) -> bool {
    let distance = (right - left) as f64;
    if distance < ALWAYS_TOGETHER_NM {
        return true;
    }
    if distance >= width {
        return false;
    }
    let reach = (GROUND_WIDTHS * width).round() as usize;
    let (from, to) = (
        left.saturating_sub(reach),
        (right + reach).min(values.len() - 1),
    );
    let lowest = |range: &[f64]| range.iter().copied().fold(f64::INFINITY, f64::min);
    let ground = lowest(&values[from..=left]).min(lowest(&values[right..=to]));
    let valley = lowest(&values[left..=right]);
    let lower = values[left].min(values[right]);
    valley - ground > SHALLOW_VALLEY * (lower - ground)
}

/// First and last index that each group may use: the lowest points between neighbours, and the
/// ends of what was measured.
fn borders(
    values: &[f64],
    groups: &[Vec<Peak>],
    (first, last): (usize, usize),
) -> Vec<(usize, usize)> {
    let mut borders = Vec::with_capacity(groups.len());
    let mut from = first;
    for (g, members) in groups.iter().enumerate() {
        let to = match groups.get(g + 1) {
            Some(next) => {
                let (a, b) = (members[members.len() - 1].at, next[0].at);
                (a..=b)
                    .min_by(|i, j| values[*i].total_cmp(&values[*j]))
                    .unwrap_or(a)
            }
            None => last,
        };
        borders.push((from, to));
        from = to;
    }
    borders
}

/// What one group would take out.
struct Line {
    first: usize,
    residue: Vec<f64>,
    energy: f64,
    at_nm: f64,
    width_nm: f64,
}

impl Line {
    fn take_from(&self, values: &mut [f64]) {
        for (v, r) in values[self.first..].iter_mut().zip(&self.residue) {
            *v -= r;
        }
    }

    fn found(&self, band: Band, peaks: usize, sign: f64) -> FoundSpike {
        FoundSpike {
            spike: Spike {
                at_nm: self.at_nm,
                weight: sign * self.energy,
            },
            width_nm: self.width_nm,
            peaks,
            window_nm: [
                band.nm(self.first),
                band.nm(self.first + self.residue.len() - 1),
            ],
        }
    }
}

impl FoundSpike {
    /// Whether a place belongs to this line: within reach of its centroid and inside its window.
    pub fn covers(&self, at_nm: f64) -> bool {
        (self.spike.at_nm - at_nm).abs() <= WISH_REACH_NM
            && (self.window_nm[0]..=self.window_nm[1]).contains(&at_nm)
    }
}

/// What a group would take out; `ends` are the first index of what was measured and one past its
/// last.
fn weigh(
    band: Band,
    values: &[f64],
    members: &[Peak],
    limits: (usize, usize),
    ends: (usize, usize),
) -> Option<Line> {
    let (first, last) = window_of(members, limits)?;
    let mut ground = values[first..=last].to_vec();
    // A flank that an end cuts has no foot on that side: the other foot is the ground there.
    let (head, tail) = (ground[0], ground[last - first]);
    let is_flank = |values: &mut dyn Iterator<Item = &f64>, foot: f64| {
        let falling: Vec<f64> = values.copied().collect();
        let (top, end) = (falling[0], falling[falling.len() - 1]);
        falling.is_sorted_by(|a, b| a >= b) && end - foot > CUT_FLANK * (top - foot)
    };
    if first == ends.0 && is_flank(&mut values[first..=members.first()?.at].iter().rev(), tail) {
        ground[0] = tail;
    }
    if last + 1 == ends.1 && is_flank(&mut values[members.last()?.at..=last].iter(), head) {
        ground[last - first] = head;
    }
    weigh_window(band, values, (first, last), &lower_hull(&ground))
}

/// First and last index of a group's window, within its limits.
fn window_of(members: &[Peak], limits: (usize, usize)) -> Option<(usize, usize)> {
    let (head, tail) = (members.first()?, members.last()?);
    // The widest member decides: a shoulder's own width says nothing about the line it sits on.
    let widest = members.iter().map(|p| p.width).fold(NARROWEST_NM, f64::max);
    let reach = WINDOW_WIDTHS * widest + WINDOW_MARGIN_NM;
    let first = ((head.at as f64 - reach).floor().max(0.0) as usize).max(limits.0);
    let last = ((tail.at as f64 + reach).ceil() as usize).min(limits.1);
    (last > first).then_some((first, last))
}

/// What stands above a baseline in a window.
fn weigh_window(
    band: Band,
    values: &[f64],
    (first, last): (usize, usize),
    baseline: &[f64],
) -> Option<Line> {
    let window = &values[first..=last];
    let residue: Vec<f64> = window
        .iter()
        .zip(baseline)
        .map(|(v, b)| (v - b).max(0.0))
        .collect();
    // Heights as shares of the highest: no sum overflows, and nothing tiny is lost.
    let top = residue.iter().copied().fold(0.0, f64::max);
    let (mut area, mut moment) = (0.0, 0.0);
    for (i, r) in residue.iter().enumerate() {
        let share = band.weight(first + i) * (r / top);
        area += share;
        moment += share * band.nm(first + i);
    }
    (top > 0.0).then(|| Line {
        first,
        energy: area * top,
        // Rounding must not carry a line at the end of the range out of it.
        at_nm: (moment / area).clamp(band.nm(first), band.nm(last)),
        width_nm: area / GAUSSIAN_AREA,
        residue,
    })
}

/// The lower convex hull of equally spaced values, read off at every point (Andrew's scan).
fn lower_hull(values: &[f64]) -> Vec<f64> {
    let mut corners: Vec<usize> = Vec::with_capacity(values.len());
    for i in 0..values.len() {
        while let [.., a, b] = corners[..] {
            let rise_ab = (values[b] - values[a]) * (i - a) as f64;
            let rise_ai = (values[i] - values[a]) * (b - a) as f64;
            if rise_ab >= rise_ai {
                corners.pop();
            } else {
                break;
            }
        }
        corners.push(i);
    }
    let mut hull = Vec::with_capacity(values.len());
    for pair in corners.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let slope = (values[b] - values[a]) / (b - a) as f64;
        hull.extend((a..b).map(|i| values[a] + slope * (i - a) as f64));
    }
    hull.push(values[values.len() - 1]);
    hull
}
