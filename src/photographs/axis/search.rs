//! Axes that two peaks and two landmarks suggest, and a quick score of how well the rest fits.

use super::{super::landmarks::Lamp, super::landmarks::Landmark, Scene};

/// An axis: `nm = a + b (x + rho x^2 / 2)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hypothesis {
    pub lamp: Lamp,
    pub a: f64,
    pub b: f64,
    pub rho: f64,
    pub quick: f64,
}

const CURVATURES: [f64; 7] = [-0.55, -0.35, -0.18, 0.0, 0.18, 0.35, 0.55];
/// Peaks and landmarks that pairs are made of.
const PAIRED: usize = 9;
/// Pairs of landmarks are farther apart than this, nm, and each more often seen than that.
const LEAST_APART_NM: f64 = 25.0;
const LEAST_CHANCE: f64 = 0.55;
/// Colours that cost more rule a pair out.
const MOST_COLOUR: f64 = 3.5;
/// Least and greatest span of all columns, nm.
const SPAN_NM: (f64, f64) = (150.0, 2200.0);
/// Largest ratio between the width of lines and the slit of a table.
const SLIT: f64 = 1.25;
/// The narrowest and widest lines that the outermost tables are used for, nm.
const WIDTHS_NM: (f64, f64) = (0.2, 12.5);
/// Kept of each table, and of each lamp.
const OF_A_TABLE: usize = 12;
const OF_A_LAMP: usize = 14;

impl Hypothesis {
    fn nm(&self, x: f64) -> f64 {
        self.a + self.b * (x + 0.5 * self.rho * x * x)
    }

    /// True if two axes agree within the change that refining makes.
    fn is_near(&self, other: &Self) -> bool {
        [-0.4, 0.0, 0.4]
            .iter()
            .all(|x| (self.nm(*x) - other.nm(*x)).abs() < 2.0)
    }
}

/// The axes of a lamp that are worth refining, the best first.
pub(super) fn of_lamp(scene: &Scene, lamp: Lamp) -> Vec<Hypothesis> {
    let tables = lamp.tables();
    let mut best = Vec::new();
    for (index, table) in tables.iter().enumerate() {
        let low = if index == 0 {
            WIDTHS_NM.0
        } else {
            table.slit_nm / SLIT
        };
        let high = if index + 1 == tables.len() {
            WIDTHS_NM.1
        } else {
            table.slit_nm * SLIT
        };
        let block = of_table(scene, lamp, &table.landmarks, (low, high));
        best.extend(best_of(block, OF_A_TABLE));
    }
    best_of(best, OF_A_LAMP)
}

/// The best that are no twins of better ones.
fn best_of(mut all: Vec<Hypothesis>, most: usize) -> Vec<Hypothesis> {
    all.sort_by(|p, q| q.quick.total_cmp(&p.quick));
    let mut kept: Vec<Hypothesis> = Vec::new();
    for one in all {
        if kept.len() == most {
            break;
        }
        if !kept.iter().any(|k| k.is_near(&one)) {
            kept.push(one);
        }
    }
    kept
}

/// The places of the strongest, by their own measure.
fn strongest<T>(all: &[T], strength: impl Fn(&T) -> Option<f64>) -> Vec<usize> {
    let mut ranked: Vec<(usize, f64)> = (all.iter().enumerate())
        .filter_map(|(i, one)| Some((i, strength(one)?)))
        .collect();
    ranked.sort_by(|p, q| q.1.total_cmp(&p.1));
    let mut kept: Vec<usize> = ranked.iter().take(PAIRED).map(|(i, _)| *i).collect();
    kept.sort_unstable();
    kept
}

fn of_table(
    scene: &Scene,
    lamp: Lamp,
    landmarks: &[Landmark],
    widths_nm: (f64, f64),
) -> Vec<Hypothesis> {
    let peaks = &scene.peaks.peaks;
    let strong = strongest(peaks, |p| Some(p.height));
    let known = strongest(landmarks, |l| {
        (!l.is_clipped && l.chance > LEAST_CHANCE).then(|| l.chance * l.strength.sqrt())
    });
    let mut found = Vec::new();
    let mut scorer = Scorer::new(scene, landmarks);
    let pairs = strong
        .iter()
        .flat_map(|i| strong.iter().map(move |j| (*i, *j)));
    for (i, j) in pairs.filter(|(i, j)| i != j) {
        for (at, first) in known.iter().enumerate() {
            for second in &known[at + 1..] {
                let nm = [landmarks[*first].nm, landmarks[*second].nm];
                let apart = nm[1] - nm[0];
                if apart <= LEAST_APART_NM {
                    continue;
                }
                if scene.colour_cost(i, nm[0]) + scene.colour_cost(j, nm[1]) >= MOST_COLOUR {
                    continue;
                }
                for rho in CURVATURES {
                    let u = |x: f64| x + 0.5 * rho * x * x;
                    let (ui, uj) = (u(scene.x(i)), u(scene.x(j)));
                    let b = apart / (uj - ui);
                    let width = scene.peaks.width_px * b.abs() / scene.columns as f64;
                    let is_meant = (SPAN_NM.0..=SPAN_NM.1).contains(&b.abs())
                        && scene.falls.is_none_or(|falls| falls == (b < 0.0))
                        && (widths_nm.0..=widths_nm.1).contains(&width);
                    if !is_meant {
                        continue;
                    }
                    let mut one = Hypothesis {
                        lamp,
                        a: nm[0] - b * ui,
                        b,
                        rho,
                        quick: 0.0,
                    };
                    if scene.is_kept(|px| one.nm(scene.x_of(px))) {
                        one.quick = scorer.score(&one);
                        found.push(one);
                    }
                }
            }
        }
    }
    found
}

/// Data of the picture and of a table for repeated scoring.
struct Scorer<'s> {
    scene: &'s Scene<'s>,
    landmarks: Vec<(f64, f64)>,
    peak_weights: Vec<f64>,
    nm: Vec<f64>,
    seen: Vec<f64>,
}

/// Range in which missed peaks and landmarks count, nm.
const MISSED_NM: (f64, f64) = (400.0, 695.0);

impl<'s> Scorer<'s> {
    fn new(scene: &'s Scene<'s>, landmarks: &[Landmark]) -> Self {
        let weight = |chance: f64, height: f64| chance * height.min(0.5).sqrt();
        let open = landmarks.iter().filter(|l| !l.is_clipped);
        let landmarks: Vec<(f64, f64)> =
            open.map(|l| (l.nm, weight(l.chance, l.strength))).collect();
        Self {
            peak_weights: (scene.peaks.peaks.iter())
                .map(|p| weight(1.0, p.height))
                .collect(),
            seen: vec![0.0; landmarks.len()],
            nm: Vec::new(),
            landmarks,
            scene,
        }
    }

    fn score(&mut self, one: &Hypothesis) -> f64 {
        let scene = self.scene;
        let columns = scene.columns as f64;
        let fwhm = scene.peaks.width_px * one.b.abs() / columns;
        let tolerance = (0.35 * fwhm).hypot(1.2);
        self.nm.clear();
        self.nm
            .extend((0..self.peak_weights.len()).map(|i| one.nm(scene.x(i))));
        self.seen.fill(0.0);
        let (mut sum, mut missed) = (0.0, 0.0);
        for (i, nm) in self.nm.iter().enumerate() {
            let from = self
                .landmarks
                .partition_point(|l| l.0 < nm - 3.0 * tolerance);
            let near = self.landmarks[from..].iter().zip(from..);
            let mut best = 0.0_f64;
            let mut colour = None;
            for ((at, _), place) in near.take_while(|(l, _)| l.0 < nm + 3.0 * tolerance) {
                let away = (at - nm) / tolerance;
                let cost = *colour.get_or_insert_with(|| scene.colour_cost(i, *nm));
                let q = (-0.5 * away * away - cost).exp();
                best = best.max(q);
                self.seen[place] = self.seen[place].max(q);
            }
            sum += best * self.peak_weights[i];
            if (MISSED_NM.0..=MISSED_NM.1).contains(nm) {
                missed += (1.0 - best) * self.peak_weights[i];
            }
        }
        let ends = [one.nm(-0.5), one.nm(0.5)];
        let low = ends[0].min(ends[1]).max(MISSED_NM.0);
        let high = ends[0].max(ends[1]).min(MISSED_NM.1);
        for ((nm, weight), q) in self.landmarks.iter().zip(&self.seen) {
            sum += q * weight;
            if (low..=high).contains(nm) {
                missed += (1.0 - q) * weight;
            }
        }
        sum - 0.7 * missed - 1.2 * one.rho * one.rho
    }
}
