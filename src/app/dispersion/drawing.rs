//! The bench drawn from above: the prism, one exact ray for each line, the smooth part between its
//! neighbours.

use super::{strip::smooth_is_seen, words::Line};
use crate::{
    app::{chart::Rgb, pages::Handle},
    color::{Observer, Srgb, Swatch, srgb_from_wavelength},
    optics::{Bench, BenchSettings, Light, SEEN_NM},
};

/// In the drawing a screen 500 mm away stands this often the chief ray's distance from the apex
/// away, so that the prism is not lost, and others by the root of their distance; angles stay exact.
const DRAWN_SCREEN: f64 = 4.6;
/// That distance, mm.
const USUAL_SCREEN_MM: f64 = 500.0;

/// How far along the way to the prism the slit stands, and how far beside its edge its handle is,
/// of the chief ray's distance from the apex.
const SLIT_AT: f64 = 0.45;
const BESIDE_EDGE: f64 = 0.2;

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
    /// The same of the rays through both edges of the slit, the one nearer to the apex first.
    pub edges: Option<[[[f64; 2]; 3]; 2]>,
}

/// A handle in the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Grip {
    /// What it moves.
    pub handle: Handle,
    /// Where it is.
    pub at: [f64; 2],
    /// What it is set to, in words.
    pub words: String,
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
    /// Both jaws of the slit: from its edge to the jaw's other end.
    pub jaws: [[[f64; 2]; 2]; 2],
    /// What a hand can take hold of.
    pub grips: Vec<Grip>,
    /// How wide the slit is, mm.
    pub slit_mm: f64,
    /// Across the way of the light, away from the apex.
    across: [f64; 2],
    /// The way to the screen, and how far away that is drawn.
    ahead: [f64; 2],
    drawn_mm: f64,
    entry_mm: f64,
}

fn plus(a: [f64; 2], b: [f64; 2], times: f64) -> [f64; 2] {
    [a[0] + times * b[0], a[1] + times * b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl BenchDrawing {
    /// Of a bench with its screen moved near; `None` where no light leaves.
    pub fn of(bench: &Bench, light: &Light, lines: &[Line], observer: Observer) -> Option<Self> {
        let far = bench.settings();
        let (entry_mm, slit_mm) = (far.entry_mm, far.slit_mm);
        let drawn_mm = DRAWN_SCREEN * entry_mm * (far.screen_mm / USUAL_SCREEN_MM).sqrt();
        let near = BenchSettings {
            screen_mm: drawn_mm,
            ..far.clone()
        };
        let near = Bench::new(near, bench.material().clone()).ok()?;
        let path = near.ray(near.reference_nm(), 0.0)?;
        let smooth = match smooth_is_seen(light, observer) {
            true => smooth_rays(&near, light),
            false => Vec::new(),
        };
        let lines = line_rays(&near, lines);
        let half = (0.5 * near.prism().apex_deg()).to_radians();
        let reach = |ray: &DrawnRay| ray.at[1][0].hypot(ray.at[1][1]);
        let all = || smooth.iter().chain(&lines);
        let farthest = all().map(reach).fold(entry_mm, f64::max);
        // A grazing ray may leave far out: the prism is drawn no longer than the page bears.
        let side = (1.2 * farthest).clamp(2.0 * entry_mm, 4.0 * entry_mm);
        let prism = [
            [0.0, 0.0],
            [-side * half.sin(), -side * half.cos()],
            [side * half.sin(), -side * half.cos()],
        ];
        let along = path.incoming;
        // The face runs away from the apex, and so does this.
        let across = [along[1], -along[0]];
        let slit_at = plus(path.entry, along, -(1.0 - SLIT_AT) * IN_FRONT * entry_mm);
        let jaw = |way: f64| {
            let edge = plus(slit_at, across, 0.5 * way * slit_mm);
            [edge, plus(edge, across, way * BESIDE_EDGE * entry_mm)]
        };
        let jaws = [jaw(-1.0), jaw(1.0)];
        let ahead = [0, 1].map(|k| (path.screen[k] - path.exit[k]) / drawn_mm);
        let ends = screen(
            [path.exit, path.screen],
            all().map(|ray| ray.at[2]),
            entry_mm,
        );
        let grip = |handle, at, words| Grip { handle, at, words };
        Some(Self {
            prism,
            incoming: [plus(path.entry, along, -IN_FRONT * entry_mm), path.entry],
            rgb: Swatch::of_light(light.white(observer)).rgb8.0,
            grips: vec![
                grip(
                    Handle::Apex,
                    prism[2],
                    format!("{:.1}\u{b0}", near.prism().apex_deg()),
                ),
                grip(Handle::Slit, jaws[1][1], format!("{slit_mm:.2} mm")),
                grip(Handle::Screen, ends[0], format!("{:.0} mm", far.screen_mm)),
            ],
            screen: ends,
            smooth,
            lines,
            jaws,
            slit_mm,
            across,
            ahead,
            drawn_mm,
            entry_mm,
        })
    }

    fn grip(&self, handle: Handle) -> Option<&Grip> {
        self.grips.iter().find(|grip| grip.handle == handle)
    }

    /// What a handle is to be set to so that it lies at a place: degrees of the apex, mm of the
    /// slit and of the screen's distance.
    pub fn dragged(&self, handle: Handle, to: [f64; 2]) -> f64 {
        let from = self.grip(handle).map_or(to, |grip| grip.at);
        let moved = plus(to, from, -1.0);
        match handle {
            Handle::Apex => 2.0 * to[0].abs().atan2(-to[1]).to_degrees(),
            Handle::Slit => self.slit_mm + 2.0 * dot(moved, self.across),
            Handle::Screen => {
                let drawn = (self.drawn_mm + dot(moved, self.ahead)).max(0.0);
                USUAL_SCREEN_MM * (drawn / (DRAWN_SCREEN * self.entry_mm)).powi(2)
            }
        }
    }
}

/// A ray of a wavelength; `None` where it does not leave.
fn ray(bench: &Bench, at_nm: f64, strength: f64) -> Option<DrawnRay> {
    let Srgb(rgb) = srgb_from_wavelength(at_nm);
    let path = bench.ray(at_nm, 0.0)?;
    // What would pass beside the apex does not meet the prism.
    let cos = bench.prism().incidence_deg().to_radians().cos();
    let settings = bench.settings();
    let least = -(2.0 * settings.entry_mm * cos / settings.slit_mm).min(1.0);
    let edge = |edge: f64| {
        let path = bench.ray(at_nm, edge)?;
        Some([path.entry, path.exit, path.screen])
    };
    Some(DrawnRay {
        rgb,
        strength: if strength.is_finite() {
            strength.clamp(0.0, 1.0)
        } else {
            0.0
        },
        at: [path.entry, path.exit, path.screen],
        edges: edge(least).zip(edge(1.0)).map(|(a, b)| [a, b]),
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
    let ahead = plus(at, exit, -1.0);
    let length = ahead[0].hypot(ahead[1]);
    let across = [ahead[1] / length, -ahead[0] / length];
    let along = |p: [f64; 2]| dot(plus(p, at, -1.0), across);
    let [low, high] = others.map(along).fold([-4.0, 4.0], |[low, high], way| {
        [f64::min(low, way), f64::max(high, way)]
    });
    [low - 3.0, high + 3.0].map(|way| {
        let way = way.clamp(-3.0 * entry_mm, 3.0 * entry_mm);
        plus(at, across, way)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::dispersion::words::first_lines,
        optics::BuiltinMaterial,
        spectrum::{self, Band},
    };

    fn drawn(settings: BenchSettings) -> BenchDrawing {
        let (light, lines) = first_lines();
        let bench = Bench::new(settings, BuiltinMaterial::NSf11.material()).expect("a bench");
        BenchDrawing::of(&bench, &light, &lines, Observer::default()).expect("light leaves")
    }

    #[test]
    fn the_fan_of_a_line_lamp_has_no_rays_between_its_lines() {
        let band = Band::VISIBLE;
        let lines: Vec<Line> = [435.833, 546.075, 578.0]
            .map(|at_nm| Line {
                at_nm,
                weight: 100.0,
                name: String::new(),
            })
            .to_vec();
        let drawn = |glow: f64| {
            let spike = |line: &Line| spectrum::Line::ideal(line.at_nm, line.weight);
            let smooth = vec![glow; band.points()];
            let light = Light::new("tube", band, smooth, lines.iter().map(spike).collect());
            let bench = Bench::new(BenchSettings::default(), BuiltinMaterial::NSf11.material());
            let (bench, light) = (bench.expect("a bench"), light.expect("it shines"));
            BenchDrawing::of(&bench, &light, &lines, Observer::default()).expect("light leaves")
        };
        // 400 nm of .003 are .4 % of the power of the lines, as in a mercury tube.
        let tube = drawn(0.003);
        assert_eq!((tube.smooth.len(), tube.lines.len()), (0, 3));
        assert!(!drawn(0.3).smooth.is_empty());
    }

    #[test]
    fn a_handle_that_lies_where_it_is_keeps_its_value() {
        let settings = BenchSettings {
            apex_deg: 50.0,
            slit_mm: 3.0,
            screen_mm: 800.0,
            ..BenchSettings::default()
        };
        let drawing = drawn(settings);
        for (grip, value) in drawing.grips.iter().zip([50.0, 3.0, 800.0]) {
            let found = drawing.dragged(grip.handle, grip.at);
            assert!((found - value).abs() < 1e-9, "{:?}: {found}", grip.handle);
        }
    }

    #[test]
    fn handles_that_are_pulled_outwards_grow_what_they_hold() {
        let settings = BenchSettings::default();
        let drawing = drawn(settings.clone());
        let at = |handle: Handle| drawing.grip(handle).expect("a handle").at;
        let [x, y] = at(Handle::Apex);
        assert!(drawing.dragged(Handle::Apex, [x + 5.0, y]) > 60.0);
        let wider = plus(at(Handle::Slit), drawing.across, 2.0);
        let found = drawing.dragged(Handle::Slit, wider);
        assert!((found - settings.slit_mm - 4.0).abs() < 1e-9, "{found}");
        let further = plus(at(Handle::Screen), drawing.ahead, 30.0);
        assert!(drawing.dragged(Handle::Screen, further) > 500.0);
    }

    #[test]
    fn the_slits_edges_are_as_far_apart_as_the_slit() {
        let settings = BenchSettings {
            slit_mm: 6.0,
            ..BenchSettings::default()
        };
        let drawing = drawn(settings);
        for ray in &drawing.lines {
            let [a, b] = ray.edges.expect("both edges meet the prism");
            let between = dot(plus(b[0], a[0], -1.0), drawing.across);
            assert!((between - 6.0).abs() < 1e-9, "{between}");
        }
    }
}
