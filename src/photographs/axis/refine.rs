//! An axis made as good as its lines allow: which peak is which landmark, the curve through them,
//! and how likely that is beside chance.

use super::{
    super::landmarks::{Lamp, Landmark, Table},
    Scene,
    curve::{Curve, Degree, LeftOut, Point},
    search::Hypothesis,
};

/// A peak that is a landmark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Match {
    /// Index of the peak, in the order of places.
    pub peak: usize,
    pub landmark: Landmark,
    /// Deviation of the curve from the landmark there.
    pub error_nm: f64,
    /// The same of a curve that was fitted without this line.
    pub left_out: LeftOut,
    /// The doubt of both places.
    pub sigma_nm: f64,
}

/// An axis with what speaks for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Whose lines these are.
    pub lamp: Lamp,
    /// Log-likelihood beside chance.
    pub score: f64,
    /// Wavelength against columns.
    pub curve: Curve,
    /// The lines, in the order of their columns.
    pub matches: Vec<Match>,
}

/// Doubt of places in nm, round after round; the last is what any axis is off by.
const TOLERANCES_NM: [f64; 6] = [1.5, 1.2, 0.9, 0.7, 0.5, 0.35];
const LAST_NM: f64 = 0.2;
/// Standard deviations by which the other lines may miss the place of an outermost one.
const SIGMAS: f64 = 2.5;
/// Cost of an axis relative to no axis at all.
const COST: f64 = 5.4;
/// Standard deviation squared of curvatures, as the score has it.
const CURVATURE2: f64 = 0.09;
/// Landmarks closer than this share of a line's width are one peak.
const UNPARTED: f64 = 0.4;
/// A pin of this landmark, nm: other tables have it a little elsewhere.
const SAME_NM: f64 = 0.5;
/// Range in which peaks that are no landmark count against an axis, nm: beyond the violet, where
/// cameras are all but blind, a peak is one in the wrong place.
const STRANGERS_NM: (f64, f64) = (300.0, 700.0);

impl Solution {
    /// The nm of the lines, in the order of their columns.
    pub fn lines_nm(&self) -> impl Iterator<Item = f64> + '_ {
        self.matches.iter().map(|m| m.landmark.nm)
    }

    /// From the shortest to the longest line.
    pub fn span_nm(&self) -> (f64, f64) {
        let low = self.lines_nm().fold(f64::MAX, f64::min);
        let high = self.lines_nm().fold(f64::MIN, f64::max);
        (low, high)
    }

    /// Root mean square of what the lines are off by, weighted by their doubt.
    pub fn rms_nm(&self) -> f64 {
        weighted(self.matches.iter().map(|m| (m.error_nm, m.sigma_nm)))
    }

    /// The same with each line left out of the fit: the doubt is then also the curve's.
    pub fn left_out_rms_nm(&self) -> f64 {
        let left_out = self.matches.iter().map(|m| m.left_out);
        weighted(left_out.map(|l| (l.error_nm, l.sigma_nm)))
    }
}

/// Root mean square of errors, weighted by their doubt.
fn weighted(errors: impl Iterator<Item = (f64, f64)>) -> f64 {
    let sums = errors.fold((0.0, 0.0), |(sum, weights), (error, sigma)| {
        let weight = sigma.powi(-2);
        (sum + weight * error.powi(2), weights + weight)
    });
    (sums.0 / sums.1.max(f64::MIN_POSITIVE)).sqrt()
}

/// A lamp's table for lines of a width.
pub(super) fn table_for(lamp: Lamp, width_nm: f64) -> &'static Table {
    let off = |t: &&Table| (t.slit_nm / width_nm.max(0.1)).ln().abs();
    let tables = lamp.tables().iter();
    tables
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .expect("every lamp has tables")
}

/// Refines an axis; `None` where too few lines are left.
pub(super) fn refine(scene: &Scene, start: &Hypothesis) -> Option<Solution> {
    let slope = start.b;
    let mut curve = Curve::new(
        scene.columns,
        [start.a, slope, 0.5 * slope * start.rho, 0.0],
    );
    let lamp = start.lamp;
    let table = |curve: &Curve| table_for(lamp, scene.width_nm(curve));
    let mut marks = table(&curve);
    for (round, tolerance) in TOLERANCES_NM.into_iter().enumerate() {
        if round == 3 {
            marks = table(&curve);
        }
        curve = nearer(scene, &curve, &marks.landmarks, tolerance)?;
    }
    settle(scene, lamp, curve, &marks.landmarks)
}

/// Refines an axis that is near to the truth already, with the landmarks of some slit.
pub(super) fn again(
    scene: &Scene,
    lamp: Lamp,
    mut curve: Curve,
    landmarks: &[Landmark],
) -> Option<Solution> {
    for tolerance in &TOLERANCES_NM[3..] {
        curve = nearer(scene, &curve, landmarks, *tolerance)?;
    }
    settle(scene, lamp, curve, landmarks)
}

/// The curve through the lines that are within a tolerance.
fn nearer(
    scene: &Scene,
    curve: &Curve,
    landmarks: &[Landmark],
    tolerance_nm: f64,
) -> Option<Curve> {
    let (pairs, _) = assign(scene, curve, landmarks, tolerance_nm, &[]);
    let points = points(scene, curve, landmarks, &pairs);
    let (better, _) = Curve::fit(&points, scene.columns, curve.c[1], Degree::Quadratic)?;
    better.is_monotone().then_some(better)
}

/// The final curve and its score: end lines that nothing else speaks for are taken off.
fn settle(scene: &Scene, lamp: Lamp, mut curve: Curve, landmarks: &[Landmark]) -> Option<Solution> {
    let mut banned: Vec<(usize, usize)> = Vec::new();
    let mut best = None;
    for _ in 0..8 {
        let (pairs, _) = assign(scene, &curve, landmarks, LAST_NM, &banned);
        let points = points(scene, &curve, landmarks, &pairs);
        let slope = curve.c[1];
        let fitted = Curve::fit(&points, scene.columns, slope, Degree::Cubic)
            .filter(|(cubic, _)| points.len() > 3 && cubic.is_monotone())
            .or_else(|| Curve::fit(&points, scene.columns, slope, Degree::Quadratic))
            .filter(|(fitted, _)| fitted.is_monotone());
        let (fitted, left_out) = fitted?;
        curve = fitted;
        let lonely = lonely_end(scene, &curve, &points, &left_out, &pairs);
        if let Some(pair) = lonely {
            banned.push(pair);
            continue;
        }
        let matches: Vec<Match> = (pairs.iter().zip(&points).zip(&left_out))
            .map(|((pair, point), left_out)| Match {
                peak: pair.0,
                landmark: landmarks[pair.1],
                error_nm: curve.nm(point.px) - point.nm,
                left_out: *left_out,
                sigma_nm: point.sigma_nm,
            })
            .collect();
        let is_settled = best.as_ref().is_some_and(|(old, _)| *old == pairs);
        best = Some((pairs, matches));
        if is_settled {
            break;
        }
    }
    let (_, matches) = best?;
    let (_, gain) = assign(scene, &curve, landmarks, LAST_NM, &banned);
    let rho = curve.curvature();
    Some(Solution {
        lamp,
        score: gain - rho * rho / (2.0 * CURVATURE2) - COST + lamp.prior(),
        curve,
        matches,
    })
}

/// An outermost line that is far off when it is left out, beyond the doubt of that: it has all the
/// leverage.
fn lonely_end(
    scene: &Scene,
    curve: &Curve,
    points: &[Point],
    left_out: &[LeftOut],
    pairs: &[(usize, usize)],
) -> Option<(usize, usize)> {
    if points.len() < 5 {
        return None;
    }
    let last = points.len() - 1;
    let excess = |i: usize| {
        let fwhm = scene.peaks.peaks[pairs[i].0].fwhm_px * curve.slope(points[i].px).abs();
        left_out[i].error_nm.abs() / (1.2 + 0.25 * fwhm).max(SIGMAS * left_out[i].sigma_nm)
    };
    let worst = if excess(0) > excess(last) { 0 } else { last };
    (excess(worst) > 1.0).then(|| pairs[worst])
}

/// The doubt of a pair's place, nm.
fn doubt_nm(scene: &Scene, curve: &Curve, peak: usize, landmark: &Landmark) -> f64 {
    let peak = &scene.peaks.peaks[peak];
    let by_peak = peak.error_px * curve.slope(peak.px).abs();
    landmark.scatter_nm.hypot(by_peak)
}

fn points(
    scene: &Scene,
    curve: &Curve,
    landmarks: &[Landmark],
    pairs: &[(usize, usize)],
) -> Vec<Point> {
    let by_hand = |nm: f64| {
        let mut exact = scene.pins.iter().filter(|(pin, _)| pin.is_exact);
        exact
            .find(|(pin, _)| (pin.nm - nm).abs() < SAME_NM)
            .map(|(pin, _)| pin.px)
    };
    let point = |&(peak, mark): &(usize, usize)| Point {
        px: by_hand(landmarks[mark].nm).unwrap_or(scene.peaks.peaks[peak].px),
        nm: landmarks[mark].nm,
        sigma_nm: doubt_nm(scene, curve, peak, &landmarks[mark]),
    };
    pairs.iter().map(point).collect()
}

/// Cost of a peak that is no landmark, by its height.
fn stranger(height: f64) -> f64 {
    const STEPS: [(f64, f64); 4] = [(0.005, 0.3), (0.03, 1.0), (0.16, 2.5), (0.5, 4.0)];
    let after = STEPS.iter().position(|(h, _)| height < *h);
    match after {
        Some(0) => STEPS[0].1,
        None => STEPS[3].1,
        Some(i) => {
            let ((h0, c0), (h1, c1)) = (STEPS[i - 1], STEPS[i]);
            c0 + (c1 - c0) * (height / h0).ln() / (h1 / h0).ln()
        }
    }
}

/// Cost of a landmark that is not seen.
fn unseen(scene: &Scene, curve: &Curve, landmark: &Landmark) -> f64 {
    if landmark.is_clipped {
        return 0.0;
    }
    let (low, high) = scene.range_nm(curve);
    if !(low..=high).contains(&landmark.nm) {
        return 0.0;
    }
    // Within a wide or an over-exposed peak nothing else is seen.
    let hides = |p: &super::super::peaks::Peak| {
        (p.is_clipped || p.is_band)
            && (curve.nm(p.px) - landmark.nm).abs() < p.fwhm_px * curve.slope(p.px).abs()
    };
    if scene.peaks.peaks.iter().any(hides) {
        return 0.0;
    }
    let limit = scene.visible();
    let visible = 1.0 / (1.0 + (-(landmark.strength / (2.0 * limit)).ln() / 0.6).exp());
    -(1.0 - (landmark.chance * visible).min(0.92)).ln()
}

/// Log-likelihood gain of a peak as a landmark; `None` where they are too far apart.
fn gain(
    scene: &Scene,
    curve: &Curve,
    peak: usize,
    landmark: &Landmark,
    tolerance_nm: f64,
) -> Option<f64> {
    let one = &scene.peaks.peaks[peak];
    if landmark.is_clipped && !one.is_clipped {
        return None;
    }
    let nm = curve.nm(one.px);
    let sigma = doubt_nm(scene, curve, peak, landmark).hypot(tolerance_nm);
    let away = (nm - landmark.nm) / sigma;
    if away.abs() > 3.5 {
        return None;
    }
    let ratio = (one.height / landmark.strength).log10() / 0.55;
    let (low, high) = scene.range_nm(curve);
    let density = scene.peaks.peaks.len() as f64 / (high - low);
    let normal = (sigma * (2.0 * std::f64::consts::PI).sqrt()).ln();
    Some(
        landmark.chance.ln()
            - 0.5 * away * away
            - normal
            - density.ln()
            - scene.colour_cost(peak, landmark.nm)
            - (0.5 * ratio * ratio).min(2.0),
    )
}

/// The most likely way of naming peaks, in the order of wavelengths, and its log-likelihood.
fn assign(
    scene: &Scene,
    curve: &Curve,
    landmarks: &[Landmark],
    tolerance_nm: f64,
    banned: &[(usize, usize)],
) -> (Vec<(usize, usize)>, f64) {
    let count = scene.peaks.peaks.len();
    let falls = curve.c[1] < 0.0;
    let order: Vec<usize> = if falls {
        (0..count).rev().collect()
    } else {
        (0..count).collect()
    };
    let skip_peak: Vec<f64> = (order.iter())
        .map(|&i| {
            let peak = &scene.peaks.peaks[i];
            let nm = curve.nm(peak.px);
            let counts = (STRANGERS_NM.0..=STRANGERS_NM.1).contains(&nm);
            if counts { stranger(peak.height) } else { 0.0 }
        })
        .collect();
    let skip_mark: Vec<f64> = landmarks.iter().map(|l| unseen(scene, curve, l)).collect();
    // Two peaks are no landmarks that a slit does not part: how many stand well before each.
    let least_nm = UNPARTED * scene.width_nm(curve);
    let before = |l: &Landmark| landmarks.partition_point(|o| o.nm < l.nm - least_nm);
    let apart: Vec<usize> = landmarks.iter().map(before).collect();
    // Rows are peaks, columns landmarks; a cell is the best of all before both.
    let width = landmarks.len() + 1;
    let mut best = vec![0.0; (count + 1) * width];
    let mut step = vec![0_u8; (count + 1) * width];
    for i in 0..=count {
        for j in 0..width {
            let cell = i * width + j;
            let mut value = if cell == 0 { 0.0 } else { f64::MIN };
            if i > 0 {
                (value, step[cell]) = (best[cell - width] - skip_peak[i - 1], 1);
            }
            if j > 0 && best[cell - 1] - skip_mark[j - 1] > value {
                (value, step[cell]) = (best[cell - 1] - skip_mark[j - 1], 2);
            }
            if i > 0 && j > 0 && !banned.contains(&(order[i - 1], j - 1)) {
                let pair = gain(scene, curve, order[i - 1], &landmarks[j - 1], tolerance_nm);
                let before = best[cell - width - j + apart[j - 1]];
                if let Some(pair) = pair.map(|g| g + before)
                    && pair > value
                {
                    (value, step[cell]) = (pair, 3);
                }
            }
            best[cell] = value;
        }
    }
    let (mut i, mut j) = (count, width - 1);
    let mut pairs = Vec::new();
    while i > 0 || j > 0 {
        match step[i * width + j] {
            1 => i -= 1,
            2 => j -= 1,
            _ => {
                pairs.push((order[i - 1], j - 1));
                (i, j) = (i - 1, apart[j - 1]);
            }
        }
    }
    pairs.sort_unstable();
    (pairs, best[best.len() - 1])
}
