//! A drop of water in section: a fan of rays, and where it meets the drop at one place a ray of each
//! line.

use super::{
    strip::smooth_is_seen,
    words::{Line, nm},
};
use crate::{
    app::{chart::Rgb, pages::RainbowMemory},
    color::{Observer, Srgb, srgb_from_wavelength},
    languages::fixed,
    optics::{DropRay as Refracted, Light, Material, from_antisolar},
};

/// Wavelength of the fan, nm: where the eye is most sensitive.
const FAN_NM: f64 = 555.0;

/// Steps of the fan, radii.
const FAN_STEP: f64 = 0.07;

/// How long a ray is drawn outside the drop, radii.
const OUTSIDE: f64 = 2.2;

/// Step of the smooth part's rays, nm.
const SMOOTH_STEP_NM: f64 = 10.0;

/// A ray of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct DropRay {
    /// Its colour.
    pub rgb: Rgb,
    /// How strong it is drawn, 0-1.
    pub strength: f64,
    /// Its way, from outside the drop to outside; radii, y upwards.
    pub way: Vec<[f64; 2]>,
}

/// A drop of radius 1 about the origin; the light comes from the left.
#[derive(Clone, Debug, PartialEq)]
pub struct DropDrawing {
    /// Rays of one wavelength all over the drop.
    pub fan: Vec<DropRay>,
    /// Rays of the smooth part where the lines' rays meet the drop.
    pub smooth: Vec<DropRay>,
    /// A ray of each line.
    pub lines: Vec<DropRay>,
    /// Where these meet the drop, radii off its middle.
    pub impact: f64,
    /// What is seen, a sentence.
    pub words: String,
}

impl DropDrawing {
    /// Of drops of a material.
    pub fn of(material: &Material, light: &Light, lines: &[Line], memory: &RainbowMemory) -> Self {
        let reflections = if memory.twice { 2 } else { 1 };
        let impact = memory.impact;
        let ray = |at_nm: f64, impact: f64, strength: f64| {
            let n = material.index(at_nm).ok()?;
            let Srgb(rgb) = srgb_from_wavelength(at_nm);
            let way = way(&Refracted::new(impact, n), reflections);
            Some(DropRay { rgb, strength, way })
        };
        let count = (1.0 / FAN_STEP) as usize;
        let fan = (0..=count).filter_map(|i| ray(FAN_NM, FAN_STEP * i as f64, 0.25));
        let places = || (0..=40).map(|i| 380.0 + SMOOTH_STEP_NM * f64::from(i));
        let most = places().map(|nm| light.smooth_at(nm)).fold(0.0, f64::max);
        let is_seen = smooth_is_seen(light, Observer::default());
        let smooth = places().filter(|_| is_seen).filter_map(|nm| {
            let share = (light.smooth_at(nm) / most).max(0.0);
            (share > 0.0).then(|| ray(nm, impact, 0.4 * share.sqrt()))?
        });
        Self {
            fan: fan.collect(),
            smooth: smooth.collect(),
            lines: lines
                .iter()
                .filter_map(|line| ray(line.at_nm, impact, 1.0))
                .collect(),
            impact,
            words: words(material, lines, impact, reflections),
        }
    }
}

/// Where the rays leave to, a sentence.
fn words(material: &Material, lines: &[Line], impact: f64, reflections: u32) -> String {
    let leaves = |at_nm: f64| {
        let n = material.index(at_nm).ok()?;
        let ray = Refracted::new(impact, n);
        let left: f64 = 0.5 * ray.weights_s_p(reflections).iter().sum::<f64>();
        Some((from_antisolar(ray.deviation_deg(reflections)), left))
    };
    let ends = match (lines.first(), lines.last()) {
        (Some(first), Some(last)) => [first.at_nm, last.at_nm],
        _ => [450.0, 650.0],
    };
    let told = |at_nm: f64| {
        let (angle, _) = leaves(at_nm)?;
        Some(tr!(
            "{place} at {angle}\u{b0}",
            place = nm(at_nm),
            angle = fixed(angle, 1)
        ))
    };
    let mut places: Vec<String> = ends.iter().filter_map(|at_nm| told(*at_nm)).collect();
    places.dedup();
    let share = leaves(ends[0]).map_or(0.0, |(_, left)| 100.0 * left);
    let (impact, share) = (fixed(impact, 2), fixed(share, 1));
    let places = places.join(", ");
    match reflections {
        1 => tr!(
            "Met at {impact} of its radius, after one reflection inside: {places} from the point \
             opposite the sun, {share} % of what fell there.",
            impact,
            places,
            share
        ),
        _ => tr!(
            "Met at {impact} of its radius, after two reflections inside: {places} from the point \
             opposite the sun, {share} % of what fell there.",
            impact,
            places,
            share
        ),
    }
}

/// A ray's way through a drop: it comes from the left above the middle and goes round clockwise.
fn way(ray: &Refracted, reflections: u32) -> Vec<[f64; 2]> {
    let (i, r) = (
        ray.incidence_deg.to_radians(),
        ray.refraction_deg.to_radians(),
    );
    let entry = std::f64::consts::PI - i;
    let turned = std::f64::consts::PI - 2.0 * r;
    let on_drop = (0..=reflections + 1).map(|hit| {
        let angle = entry - f64::from(hit) * turned;
        [angle.cos(), angle.sin()]
    });
    let mut way = vec![[-OUTSIDE, ray.impact]];
    way.extend(on_drop);
    let leaves = -ray.deviation_deg(reflections).to_radians();
    let [x, y] = way[way.len() - 1];
    way.push([x + OUTSIDE * leaves.cos(), y + OUTSIDE * leaves.sin()]);
    way
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{assert_says, dispersion::words::first_lines},
        optics::BuiltinMaterial,
    };

    fn drawn(memory: &RainbowMemory) -> DropDrawing {
        let (light, lines) = first_lines();
        DropDrawing::of(&BuiltinMaterial::Water.material(), &light, &lines, memory)
    }

    #[test]
    fn rays_bend_at_the_drop_as_snell_and_the_mirror_have_it() {
        for twice in [false, true] {
            let memory = RainbowMemory {
                twice,
                impact: 0.8,
                ..RainbowMemory::default()
            };
            let drawing = drawn(&memory);
            assert_eq!(drawing.lines.len(), 4, "one ray for each line of FL2");
            for ray in drawing.lines.iter().chain(&drawing.fan) {
                assert_eq!(ray.way.len(), if twice { 6 } else { 5 });
                let inside = &ray.way[1..ray.way.len() - 1];
                let off = |[x, y]: &[f64; 2]| (x.hypot(*y) - 1.0).abs();
                assert!(inside.iter().all(|place| off(place) < 1e-12));
                // Each way between two places of the drop is as long as the first.
                let long =
                    |pair: &[[f64; 2]]| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
                let ways: Vec<f64> = inside.windows(2).map(long).collect();
                assert!(ways.iter().all(|way| (way - ways[0]).abs() < 1e-12));
                // The first is met by the ray that comes in level.
                assert!((ray.way[0][1] - ray.way[1][1]).abs() < 1e-12);
                // Out of the drop at the angle at which it came in.
                let [.., before, out, end] = ray.way[..] else {
                    panic!("a way out");
                };
                let cos = |from: [f64; 2], to: [f64; 2]| {
                    let way = [to[0] - from[0], to[1] - from[1]];
                    let size = way[0].hypot(way[1]);
                    (way[0] * out[0] + way[1] * out[1]) / size
                };
                let incidence = ray.way[1][1].asin().cos();
                assert!((cos(out, end) - incidence).abs() < 1e-9);
                // Bent away from the normal.
                assert!(cos(before, out) >= incidence - 1e-9);
            }
        }
    }

    #[test]
    fn the_drop_tells_where_its_rays_go() {
        let mut memory = RainbowMemory::default();
        let words = drawn(&memory).words;
        // Hg 404.7 and 578 of FL2 by the figures of their bows, near which this ray passes.
        assert_says(&words, "404.9 nm at 40.7\u{b0}");
        assert_says(&words, "578.0 nm at 42.0\u{b0}");
        memory.look_at(true);
        let words = drawn(&memory).words;
        assert_says(&words, "two reflections");
        assert_says(&words, "nm at 5");
    }
}
