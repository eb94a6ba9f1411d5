//! The bench drawn from above: the prism, one exact ray for each line, the smooth part between its
//! neighbours.

use super::words::Line;
use crate::{
    app::chart::Rgb,
    color::{Observer, Srgb, Swatch, srgb_from_wavelength},
    optics::{Bench, BenchSettings, Light, SEEN_NM},
};

/// In the drawing the screen stands this often the chief ray's distance from the apex away, so
/// that the prism is not lost; angles stay exact.
const DRAWN_SCREEN: f64 = 4.6;

/// Step of the smooth part's rays in the drawing, nm.
const DRAWN_STEP_NM: f64 = 4.0;

/// How much of the way to the prism is drawn, of the chief ray's distance from the apex.
const IN_FRONT: f64 = 3.2;

/// A ray of the drawing: where it enters, leaves and ends, mm, y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnRay {
    /// Its colour.
    pub rgb: Rgb,
    /// How strong it is, 0-1.
    pub strength: f64,
    /// The places.
    pub at: [[f64; 2]; 3],
}

/// The bench from above; mm, y upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchDrawing {
    /// Corners of the prism, the apex first.
    pub prism: [[f64; 2]; 3],
    /// The light on its way in: from, to.
    pub incoming: [[f64; 2]; 2],
    /// Its colour.
    pub rgb: Rgb,
    /// Rays of the smooth part, neighbours by wavelength.
    pub smooth: Vec<DrawnRay>,
    /// One exact ray for each line.
    pub lines: Vec<DrawnRay>,
    /// Ends of the screen.
    pub screen: [[f64; 2]; 2],
}

impl BenchDrawing {
    /// Of a bench with its screen moved near; `None` where no light leaves.
    pub fn of(bench: &Bench, light: &Light, lines: &[Line], observer: Observer) -> Option<Self> {
        let far = bench.settings();
        let entry_mm = far.entry_mm;
        let near = BenchSettings {
            screen_mm: DRAWN_SCREEN * entry_mm,
            ..far.clone()
        };
        let bench = Bench::new(near, bench.material().clone()).ok()?;
        let path = bench.ray(bench.reference_nm(), 0.0)?;
        let (smooth, lines) = (smooth_rays(&bench, light), line_rays(&bench, lines));
        let half = (0.5 * bench.prism().apex_deg()).to_radians();
        let reach = |ray: &DrawnRay| ray.at[1][0].hypot(ray.at[1][1]);
        let all = || smooth.iter().chain(&lines);
        let farthest = all().map(reach).fold(entry_mm, f64::max);
        // A grazing ray may leave far out: the prism is drawn no longer than the page bears.
        let side = (1.2 * farthest).clamp(2.0 * entry_mm, 4.0 * entry_mm);
        let [x, y] = path.entry;
        let [ahead, up] = path.incoming.map(|v| IN_FRONT * entry_mm * v);
        Some(Self {
            prism: [
                [0.0, 0.0],
                [-side * half.sin(), -side * half.cos()],
                [side * half.sin(), -side * half.cos()],
            ],
            incoming: [[x - ahead, y - up], path.entry],
            rgb: Swatch::of_light(light.white(observer)).rgb8.0,
            screen: screen(
                [path.exit, path.screen],
                all().map(|ray| ray.at[2]),
                entry_mm,
            ),
            smooth,
            lines,
        })
    }
}

/// A ray of a wavelength; `None` where it does not leave.
fn ray(bench: &Bench, at_nm: f64, strength: f64) -> Option<DrawnRay> {
    let Srgb(rgb) = srgb_from_wavelength(at_nm);
    let path = bench.ray(at_nm, 0.0)?;
    Some(DrawnRay {
        rgb,
        strength: if strength.is_finite() {
            strength.clamp(0.0, 1.0)
        } else {
            0.0
        },
        at: [path.entry, path.exit, path.screen],
    })
}

/// Rays of the smooth part, as strong as the root of its power, so that what is weak is seen.
fn smooth_rays(bench: &Bench, light: &Light) -> Vec<DrawnRay> {
    let [from, to] = SEEN_NM;
    let count = ((to - from) / DRAWN_STEP_NM) as usize;
    let places = || (0..=count).map(|i| from + DRAWN_STEP_NM * i as f64);
    let most = places().map(|nm| light.smooth_at(nm)).fold(0.0, f64::max);
    let drawn = |nm: f64| ray(bench, nm, (light.smooth_at(nm) / most).max(0.0).sqrt());
    places().filter_map(drawn).collect()
}

/// One ray for each line; the weakest is still seen.
fn line_rays(bench: &Bench, lines: &[Line]) -> Vec<DrawnRay> {
    let weights = lines.iter().map(|line| line.weight.abs());
    let heaviest = weights.fold(0.0, f64::max);
    let strength = |line: &Line| 0.4 + 0.6 * (line.weight.abs() / heaviest).sqrt();
    let drawn = |line: &Line| ray(bench, line.at_nm, strength(line));
    lines.iter().filter_map(drawn).collect()
}

/// Ends of a screen across the reference ray, from where it leaves to where it lands, that catches
/// other rays, but for those that graze it far out.
fn screen(
    [exit, at]: [[f64; 2]; 2],
    others: impl Iterator<Item = [f64; 2]>,
    entry_mm: f64,
) -> [[f64; 2]; 2] {
    let ahead = [at[0] - exit[0], at[1] - exit[1]];
    let length = ahead[0].hypot(ahead[1]);
    let across = [ahead[1] / length, -ahead[0] / length];
    let along = |p: [f64; 2]| (p[0] - at[0]) * across[0] + (p[1] - at[1]) * across[1];
    let [low, high] = others.map(along).fold([-4.0, 4.0], |[low, high], way| {
        [f64::min(low, way), f64::max(high, way)]
    });
    [low - 3.0, high + 3.0].map(|way| {
        let way = way.clamp(-3.0 * entry_mm, 3.0 * entry_mm);
        [at[0] + way * across[0], at[1] + way * across[1]]
    })
}
