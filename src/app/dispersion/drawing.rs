//! The bench drawn above its screen: the ray that is bent most leaves the prism straight down, the
//! others to its right. One exact ray for each line, the smooth part between its neighbours; what
//! is totally reflected on its way through the glass.

use super::{strip::smooth_is_seen, words::Line};
use crate::{
    app::{chart::Rgb, pages::Handle},
    color::{Observer, Srgb, Swatch, srgb_from_wavelength},
    languages::fixed,
    optics::{Bench, BenchSettings, Incidence, Light, Material, SEEN_NM},
};

/// How far before the prism the slit stands, and how far beside its edge its handle is, of the
/// chief ray's distance from the apex.
const SLIT_BEFORE: f64 = 1.7;
const BESIDE_EDGE: f64 = 0.2;

/// Step of the smooth part's rays in the drawing, nm.
const DRAWN_STEP_NM: f64 = 4.0;

/// Most faces that a ray in the glass meets in the drawing.
const MOST_FACES: usize = 6;

/// How light meets a prism without least deviation in the drawing, degrees.
const GRAZING_DEG: f64 = 80.0;

/// Step of the apex by which the turning of the drawing is found, degrees.
const STEP_DEG: f64 = 0.1;

/// Where a ray goes behind the glass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Leaves {
    /// To a place on the screen, mm.
    To(f64),
    /// Away from it, in a direction: it was totally reflected.
    Away([f64; 2]),
}

/// A ray of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnRay {
    /// Its colour.
    pub rgb: Rgb,
    /// How strong it is, 0-1.
    pub strength: f64,
    /// Where it enters the glass, where it is reflected and where it leaves, mm, y upwards.
    pub way: Vec<[f64; 2]>,
    /// Where it goes then.
    pub leaves: Leaves,
    /// Entry, exit and place on the screen of the rays through both edges of the slit, the one
    /// nearer to the apex first.
    pub edges: Option<[([[f64; 2]; 2], f64); 2]>,
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

/// The bench over its screen; mm, y upwards, the apex at (0, 0).
#[derive(Clone, Debug, PartialEq)]
pub struct BenchDrawing {
    /// Corners of the prism, the apex first.
    pub prism: [[f64; 2]; 3],
    /// Where the light enters, and the direction that it comes from.
    pub enters: [[f64; 2]; 2],
    /// Its colour.
    pub rgb: Rgb,
    /// Rays of the smooth part, neighbours by wavelength.
    pub smooth: Vec<DrawnRay>,
    /// One exact ray for each line.
    pub lines: Vec<DrawnRay>,
    /// The ray that is bent most; `None` where no light reaches the screen.
    pub most_bent: Option<MostBent>,
    /// Both jaws of the slit: from its edge to the jaw's other end.
    pub jaws: [[[f64; 2]; 2]; 2],
    /// What a hand can take hold of.
    pub grips: Vec<Grip>,
    /// How wide the slit is, mm.
    pub slit_mm: f64,
    apex_deg: f64,
    /// By how much the drawing turns for a degree of the apex angle.
    turning: f64,
    /// Across the way of the light, away from the apex.
    across: [f64; 2],
}

/// The ray that is bent most, which leaves straight down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MostBent {
    /// Where it leaves the glass.
    pub exit: [f64; 2],
    /// Where it lands, mm.
    pub x_mm: f64,
    /// By how much it is bent more than the ray that is bent least, degrees.
    pub spread_deg: f64,
}

fn plus(a: [f64; 2], b: [f64; 2], times: f64) -> [f64; 2] {
    [a[0] + times * b[0], a[1] + times * b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// A direction, degrees above x.
fn towards(deg: f64) -> [f64; 2] {
    let (sin, cos) = deg.to_radians().sin_cos();
    [cos, sin]
}

/// A prism met by light, before the drawing is turned: the frame of [`Bench`].
struct Stand<'a> {
    apex_deg: f64,
    incidence_deg: f64,
    entry_mm: f64,
    corners: [[f64; 2]; 3],
    material: &'a Material,
    bench: Option<&'a Bench>,
}

impl Stand<'_> {
    /// A ray of a wavelength.
    fn ray(&self, at_nm: f64, strength: f64) -> Option<DrawnRay> {
        let Srgb(rgb) = srgb_from_wavelength(at_nm);
        let strength = match strength.is_finite() {
            true => strength.clamp(0.0, 1.0),
            false => 0.0,
        };
        let ray = |way, leaves, edges| DrawnRay {
            rgb,
            strength,
            way,
            leaves,
            edges,
        };
        if let Some((way, x_mm)) = self.passes(at_nm, 0.0) {
            // What would pass beside the apex does not meet the prism.
            let slit_mm = self.bench?.settings().slit_mm;
            let cos = self.incidence_deg.to_radians().cos();
            let least = -(2.0 * self.entry_mm * cos / slit_mm).min(1.0);
            let edges = self.passes(at_nm, least).zip(self.passes(at_nm, 1.0));
            let edges = edges.map(|(a, b)| [a, b]);
            return Some(ray(way.to_vec(), Leaves::To(x_mm), edges));
        }
        let n = self.material.index(at_nm).ok()?;
        let (way, direction) = self.reflected(n)?;
        Some(ray(way, Leaves::Away(direction), None))
    }

    /// Entry, exit and place on the screen of a ray through the slit, 0 in its middle, -1 and 1 at
    /// its edges.
    fn passes(&self, at_nm: f64, edge: f64) -> Option<([[f64; 2]; 2], f64)> {
        let bench = self.bench?;
        let reference = bench.ray(bench.reference_nm(), 0.0)?;
        let path = bench.ray(at_nm, edge)?;
        let ahead = plus(reference.screen, reference.exit, -1.0);
        let off = plus(path.screen, reference.screen, -1.0);
        let x_mm = (off[0] * ahead[1] - off[1] * ahead[0]) / ahead[0].hypot(ahead[1]);
        Some(([path.entry, path.exit], x_mm))
    }

    /// Angle at which light of an index meets the second face from within, degrees.
    fn meets_second_deg(&self, n: f64) -> f64 {
        let sine = self.incidence_deg.to_radians().sin() / n;
        self.apex_deg - sine.asin().to_degrees()
    }

    /// The way of light of an index in the glass, by Snell's law at each face, and its direction
    /// behind it.
    fn reflected(&self, n: f64) -> Option<(Vec<[f64; 2]>, [f64; 2])> {
        let half = 0.5 * self.apex_deg;
        let refracted = (self.incidence_deg.to_radians().sin() / n).asin();
        let mut direction = towards(refracted.to_degrees() - half);
        let [apex, left, right] = self.corners;
        let faces = [[apex, left], [apex, right], [left, right]];
        let mut way = vec![[
            -self.entry_mm * half.to_radians().sin(),
            -self.entry_mm * half.to_radians().cos(),
        ]];
        let mut from = 0;
        for _ in 0..MOST_FACES {
            let at = *way.last()?;
            let met = (0..3).filter(|face| *face != from).filter_map(|face| {
                let [a, b] = faces[face];
                let along = plus(b, a, -1.0);
                // Away from the third corner.
                let third = [right, left, apex][face];
                let normal = [along[1], -along[0]];
                let size = normal[0].hypot(normal[1]) * dot(normal, plus(a, third, -1.0)).signum();
                let normal = normal.map(|v| v / size);
                let way = dot(plus(a, at, -1.0), normal) / dot(direction, normal);
                (way > 1e-9).then_some((face, way, normal))
            });
            let (face, length, normal) = met.min_by(|a, b| a.1.total_cmp(&b.1))?;
            way.push(plus(at, direction, length));
            let cos = dot(direction, normal);
            let beside = plus(direction, normal, -cos).map(|v| n * v);
            let left = 1.0 - dot(beside, beside);
            if left > 0.0 {
                return Some((way, plus(beside, normal, left.sqrt())));
            }
            direction = plus(direction, normal, -2.0 * cos);
            from = face;
        }
        Some((way, direction))
    }
}

impl BenchDrawing {
    /// Of a bench; `None` where its light lands nowhere.
    pub fn of(bench: &Bench, light: &Light, lines: &[Line], observer: Observer) -> Option<Self> {
        let settings = bench.settings();
        let exit_of = |bench: &Bench, nm: f64| {
            let n = bench.material().index(nm).ok()?;
            Some(bench.prism().passage(n)?.exit_deg)
        };
        let whole = || (380..=780).map(f64::from);
        let exits = whole().filter_map(|nm| Some((nm, exit_of(bench, nm)?)));
        let (at_nm, exit_deg) = exits.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let exits = whole().filter_map(|nm| exit_of(bench, nm));
        let spread_deg = exit_deg - exits.fold(exit_deg, f64::min);
        let wider = BenchSettings {
            apex_deg: settings.apex_deg + STEP_DEG,
            ..settings.clone()
        };
        let wider = Bench::new(wider, bench.material().clone()).ok();
        let turned = wider.and_then(|wider| Some(exit_of(&wider, at_nm)? - exit_deg));
        let stand = Stand {
            apex_deg: settings.apex_deg,
            incidence_deg: bench.prism().incidence_deg(),
            entry_mm: settings.entry_mm,
            corners: [[0.0; 2]; 3],
            material: bench.material(),
            bench: Some(bench),
        };
        let turning = turned.map_or(1.0, |turned| (turned / STEP_DEG).abs());
        let most_bent = stand.passes(at_nm, 0.0).map(|(way, x_mm)| MostBent {
            exit: way[1],
            x_mm,
            spread_deg,
        });
        stand.drawing(
            settings,
            (light, lines, observer),
            (exit_deg, most_bent),
            turning,
        )
    }

    /// Of a prism that lets no light out through its second face.
    pub fn dark(
        settings: &BenchSettings,
        material: &Material,
        seen: (&Light, &[Line], Observer),
    ) -> Option<Self> {
        let n = material.index(settings.reference_nm).ok()?;
        let stand = Stand {
            apex_deg: settings.apex_deg,
            incidence_deg: match settings.incidence {
                Incidence::Degrees(degrees) => degrees,
                Incidence::MinimumFor(_) => GRAZING_DEG,
            },
            entry_mm: settings.entry_mm,
            corners: [[0.0; 2]; 3],
            material,
            bench: None,
        };
        // As far beyond the face as the light is beyond the critical angle.
        let beyond = stand.meets_second_deg(n) - (1.0 / n).min(1.0).asin().to_degrees();
        stand.drawing(settings, seen, (90.0 + beyond.max(0.0), None), 1.0)
    }

    /// How long a face of the prism is drawn, mm.
    pub fn side_mm(&self) -> f64 {
        let [x, y] = self.prism[2];
        x.hypot(y)
    }

    fn grip(&self, handle: Handle) -> Option<&Grip> {
        self.grips.iter().find(|grip| grip.handle == handle)
    }

    /// What a handle is to be set to so that it lies at a place: degrees of the apex, mm of the
    /// slit.
    pub fn dragged(&self, handle: Handle, to: [f64; 2]) -> f64 {
        let from = self.grip(handle).map_or(to, |grip| grip.at);
        match handle {
            Handle::Apex => {
                // About the apex, against the clock.
                let cross = from[0] * to[1] - from[1] * to[0];
                let turned = cross.atan2(dot(from, to)).to_degrees();
                self.apex_deg + turned / self.turning.max(0.5)
            }
            Handle::Slit => self.slit_mm + 2.0 * dot(plus(to, from, -1.0), self.across),
        }
    }
}

impl Stand<'_> {
    fn drawing(
        mut self,
        settings: &BenchSettings,
        (light, lines, observer): (&Light, &[Line], Observer),
        (exit_deg, most_bent): (f64, Option<MostBent>),
        turning: f64,
    ) -> Option<BenchDrawing> {
        let (entry_mm, slit_mm) = (self.entry_mm, settings.slit_mm);
        let half = 0.5 * self.apex_deg;
        let (sin, cos) = half.to_radians().sin_cos();
        // A grazing ray may leave far out: the prism is drawn no longer than the page bears.
        let reach = |nm: f64| {
            let (way, _) = self.passes(nm, 0.0)?;
            Some(way[1][0].hypot(way[1][1]))
        };
        let [violet, red] = SEEN_NM;
        let farthest = [violet, red].into_iter().filter_map(reach);
        let farthest = farthest.fold(entry_mm, f64::max);
        let side = (1.2 * farthest).clamp(2.0 * entry_mm, 4.0 * entry_mm);
        self.corners = [
            [0.0, 0.0],
            [-side * sin, -side * cos],
            [side * sin, -side * cos],
        ];
        // A ray leaves at half the apex less its angle of leaving above x.
        let ahead = towards(half - exit_deg);
        let turn = |v: [f64; 2]| [v[1] * ahead[0] - v[0] * ahead[1], -dot(v, ahead)];
        let turned = |ray: DrawnRay| DrawnRay {
            way: ray.way.into_iter().map(turn).collect(),
            leaves: match ray.leaves {
                Leaves::To(x_mm) => Leaves::To(x_mm),
                Leaves::Away(direction) => Leaves::Away(turn(direction)),
            },
            edges: ray
                .edges
                .map(|edges| edges.map(|(way, x_mm)| (way.map(turn), x_mm))),
            ..ray
        };
        let smooth = match smooth_is_seen(light, observer) {
            true => smooth_rays(&self, light).map(turned).collect(),
            false => Vec::new(),
        };
        let along = turn(towards(self.incidence_deg - half));
        let entry = turn([-entry_mm * sin, -entry_mm * cos]);
        // The face runs away from the apex, and so does this.
        let across = [along[1], -along[0]];
        let slit_at = plus(entry, along, -SLIT_BEFORE * entry_mm);
        let jaw = |way: f64| {
            let edge = plus(slit_at, across, 0.5 * way * slit_mm);
            [edge, plus(edge, across, way * BESIDE_EDGE * entry_mm)]
        };
        let jaws = [jaw(-1.0), jaw(1.0)];
        let prism = self.corners.map(turn);
        let grip = |handle, at, words| Grip { handle, at, words };
        let apex_deg = self.apex_deg;
        Some(BenchDrawing {
            prism,
            enters: [entry, along],
            rgb: Swatch::of_light(light.white(observer)).rgb8.0,
            grips: vec![
                grip(
                    Handle::Apex,
                    prism[2],
                    format!("{}\u{b0}", fixed(apex_deg, 1)),
                ),
                grip(
                    Handle::Slit,
                    jaws[1][1],
                    format!("{} mm", fixed(slit_mm, 2)),
                ),
            ],
            smooth,
            lines: line_rays(&self, lines).map(turned).collect(),
            most_bent: most_bent.map(|ray| MostBent {
                exit: turn(ray.exit),
                ..ray
            }),
            jaws,
            slit_mm,
            apex_deg,
            turning,
            across,
        })
    }
}

/// Rays of the smooth part, as strong as the root of its power, so that what is weak is seen.
fn smooth_rays<'a>(stand: &'a Stand<'_>, light: &'a Light) -> impl Iterator<Item = DrawnRay> + 'a {
    let [from, to] = SEEN_NM;
    let count = ((to - from) / DRAWN_STEP_NM) as usize;
    let places = move || (0..=count).map(move |i| from + DRAWN_STEP_NM * i as f64);
    let most = places().map(|nm| light.smooth_at(nm)).fold(0.0, f64::max);
    places().filter_map(move |nm| {
        let strength = (light.smooth_at(nm) / most).max(0.0).sqrt();
        stand.ray(nm, strength)
    })
}

/// One ray for each line; the weakest is still seen.
fn line_rays<'a>(stand: &'a Stand<'_>, lines: &'a [Line]) -> impl Iterator<Item = DrawnRay> + 'a {
    let weights = lines.iter().map(|line| line.weight.abs());
    let heaviest = weights.fold(0.0, f64::max);
    lines.iter().filter_map(move |line| {
        let strength = 0.4 + 0.6 * (line.weight.abs() / heaviest).sqrt();
        stand.ray(line.at_nm, strength)
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
        for (grip, value) in drawing.grips.iter().zip([50.0, 3.0]) {
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
        // Against the clock about the apex, by a degree.
        let (sin, cos) = 1.0_f64.to_radians().sin_cos();
        let turned = [x * cos - y * sin, x * sin + y * cos];
        let apex_deg = drawing.dragged(Handle::Apex, turned);
        assert!(apex_deg > 60.0, "{apex_deg}");
        // The handle of the prism that is drawn then lies there: by a first-order step of less
        // than a degree to a few thousandths of the prism's side.
        let then = drawn(BenchSettings {
            apex_deg,
            ..settings.clone()
        });
        let there = then.grip(Handle::Apex).expect("a handle").at;
        let bearing = |[x, y]: [f64; 2]| y.atan2(x).to_degrees();
        let off = bearing(there) - bearing(turned);
        assert!(off.abs() < 0.05, "{off}");
        let wider = plus(at(Handle::Slit), drawing.across, 2.0);
        let found = drawing.dragged(Handle::Slit, wider);
        assert!((found - settings.slit_mm - 4.0).abs() < 1e-9, "{found}");
    }

    #[test]
    fn rays_land_where_the_bench_has_them_and_violet_at_the_left_of_red() {
        let settings = BenchSettings::default();
        let material = BuiltinMaterial::NSf11.material();
        let bench = Bench::new(settings.clone(), material).expect("a bench");
        let (light, lines) = first_lines();
        let drawing = drawn(settings);
        let most_bent = drawing.most_bent.expect("light leaves");
        // All that lands is bent less than it, at the right of it; by how much is Snell's law.
        let ends = [380.0, 780.0].map(|nm| bench.landing(nm).expect("an index").expect("it lands"));
        assert!((most_bent.x_mm - ends[0].x_mm).abs() < 1e-9);
        let spread_deg = ends[0].deviation_deg - ends[1].deviation_deg;
        assert!((most_bent.spread_deg - spread_deg).abs() < 1e-9);
        assert_eq!(drawing.lines.len(), lines.len());
        for (ray, line) in drawing.lines.iter().zip(&lines) {
            let landing = bench
                .landing(line.at_nm)
                .expect("an index")
                .expect("it lands");
            let Leaves::To(x_mm) = ray.leaves else {
                panic!("{} is reflected", line.at_nm);
            };
            assert!((x_mm - landing.x_mm).abs() < 1e-9, "{x_mm}");
        }
        assert!(light.white(Observer::default()).y > 0.0);
    }

    #[test]
    fn light_beyond_the_critical_angle_leaves_through_the_base() {
        let (light, lines) = first_lines();
        let settings = BenchSettings {
            apex_deg: 75.0,
            ..BenchSettings::default()
        };
        let material = BuiltinMaterial::NSf11.material();
        assert!(Bench::new(settings.clone(), material.clone()).is_err());
        let seen = (&light, &lines[..], Observer::default());
        let drawing = BenchDrawing::dark(&settings, &material, seen).expect("a drawing");
        assert!(drawing.most_bent.is_none());
        assert_eq!(drawing.grips.len(), 2, "the handles stay");
        let [apex, left, right] = drawing.prism;
        let beside = |at: [f64; 2], [a, b]: [[f64; 2]; 2]| {
            let along = plus(b, a, -1.0);
            let off = plus(at, a, -1.0);
            ((along[0] * off[1] - along[1] * off[0]) / along[0].hypot(along[1])).abs()
        };
        for ray in &drawing.lines {
            let [entry, reflected, leaves] = ray.way[..] else {
                panic!("{:?}", ray.way);
            };
            for (at, face) in [
                (entry, [apex, left]),
                (reflected, [apex, right]),
                (leaves, [left, right]),
            ] {
                assert!(beside(at, face) < 1e-9, "{at:?}");
            }
            assert!(matches!(ray.leaves, Leaves::Away(_)));
        }
    }

    #[test]
    fn the_slits_edges_are_as_far_apart_as_the_slit() {
        let settings = BenchSettings {
            slit_mm: 6.0,
            ..BenchSettings::default()
        };
        let drawing = drawn(settings);
        for ray in &drawing.lines {
            let [(a, _), (b, _)] = ray.edges.expect("both edges meet the prism");
            let between = dot(plus(b[0], a[0], -1.0), drawing.across);
            assert!((between - 6.0).abs() < 1e-9, "{between}");
        }
    }
}
