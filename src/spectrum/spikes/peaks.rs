//! Local maxima, how far they stand out, and which of them are one line.

/// Peaks closer than this are always one line: no spectrometer in ordinary use parts them.
const ALWAYS_TOGETHER_NM: f64 = 4.0;
/// Two peaks closer than the widest line are one when the valley between keeps this share of the
/// lower one's height.
const SHALLOW_VALLEY: f64 = 0.6;
/// Prominence is looked for within this many line widths, so that a far background cannot decide.
const PROMINENCE_WINDOW_WIDTHS: f64 = 6.0;
/// The local ground of a pair is the lowest value within this many line widths outside it.
const GROUND_WIDTHS: f64 = 2.0;

/// A local maximum: its index, its width at half prominence, and that prominence: how far one
/// must come down before climbing higher.
#[derive(Clone, Copy, Debug)]
pub(super) struct Peak {
    pub(super) at: usize,
    pub(super) width: f64,
    pub(super) prominence: f64,
}

/// First index and one past the last of what was measured: a table that ends inside the range
/// goes on as zeros. It ends where the values drop from their height at once; where they come
/// down first, the zeros are the dark ground on which a lamp's lines stand.
pub(super) fn measured_part(values: &[f64], width: f64) -> (usize, usize) {
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
pub(super) fn candidates(values: &[f64], least_height: f64, max_width: f64) -> Vec<Peak> {
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
pub(super) fn group(values: &[f64], peaks: &[Peak], width: f64) -> Vec<Vec<Peak>> {
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
pub(super) fn borders(
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
