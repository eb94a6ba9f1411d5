//! TM-30's colour vector graphic: the reference a circle on the hues, each light around it.

use std::f64::consts::TAU;

use super::{BLACK, ON_GROUND, WHITE, of_bin};
use crate::{
    app::chart::{Chart, Dash, Ink, Marks, Piece, Rgb, Series, Shape, stroke},
    color::quality::{Fidelity, HUE_NAMES},
    languages::{fixed, said},
};

/// How far the hues reach; 1 is the reference.
const RIM: f64 = 1.45;
/// Where the names of hues stand, and how far the picture reaches.
const NAMES: f64 = 1.6;
const REACH: f64 = 2.15;
/// Half the width of a letter where the picture is as high as a page has room for it.
const HALF_A_LETTER: f64 = 0.022;
/// Pieces of the ground around and from the middle out.
const AROUND: usize = 96;
const OUTWARD: usize = 8;

/// The graphic of a light, or of two; hues other than the one that is pointed at stand back.
pub fn vector_graphic(lights: &[(&str, &Fidelity)], pointed: Option<usize>) -> Chart {
    let mut series = vec![ground(pointed)];
    for radius in [0.8, 0.9, 1.1, 1.2] {
        series.push(stroke("", [120; 3], circle(radius), 0.7, Dash::Solid));
    }
    let bins = HUE_NAMES.len();
    for bin in 0..bins {
        let turn = TAU * bin as f64 / bins as f64;
        let ends = vec![[0.0; 2], along(turn, RIM)];
        series.push(stroke("", [120; 3], ends, 0.7, Dash::Dashed));
    }
    series.push(stroke("", WHITE, circle(1.0), 3.4, Dash::Solid));
    let name = if lights.len() == 1 {
        said!("reference")
    } else {
        said!("references")
    };
    series.push(stroke(name, [70; 3], circle(1.0), 1.8, Dash::Solid));
    for ((name, fidelity), inks) in lights.iter().zip(ON_GROUND) {
        light(&mut series, name, fidelity, inks, lights.len() == 1);
    }
    series.push(names());
    let figures = lights.iter().map(|(name, found)| {
        let said = format!("Rf {}, Rg {}", fixed(found.rf, 0), fixed(found.rg, 0));
        if lights.len() == 1 {
            said
        } else {
            format!("{name} {said}")
        }
    });
    let figures: Vec<String> = figures.collect();
    Chart {
        title: tr!("Colour vectors: {figures}", figures = figures.join("; ")),
        x_label: said!("a′ over the reference's chroma").to_owned(),
        y_label: "b′".to_owned(),
        x_range: [-REACH, REACH],
        y_range: Some([-1.75, 1.75]),
        even: true,
        is_bare: true,
        series,
        ..Chart::default()
    }
}

/// The hue bin at a place of the graphic; `None` beside the hues.
pub fn hue_at([a, b]: [f64; 2]) -> Option<usize> {
    let bins = HUE_NAMES.len();
    let share = b.atan2(a).rem_euclid(TAU) / TAU;
    // A turn a rounding below the whole may come out as the whole itself.
    (a.hypot(b) <= RIM).then(|| ((share * bins as f64) as usize).min(bins - 1))
}

fn along(turn: f64, radius: f64) -> [f64; 2] {
    [radius * turn.cos(), radius * turn.sin()]
}

fn circle(radius: f64) -> Vec<[f64; 2]> {
    let turns = (0..=90).map(|i| f64::from(i) * TAU / 90.0);
    turns.map(|turn| along(turn, radius)).collect()
}

/// The hues, paler towards the middle.
fn ground(pointed: Option<usize>) -> Series {
    let mut pieces = Vec::with_capacity(AROUND * OUTWARD);
    for step in 0..AROUND {
        let turns = [step, step + 1].map(|i| TAU * i as f64 / AROUND as f64);
        let bin = step * HUE_NAMES.len() / AROUND;
        let stands_back = pointed.is_some_and(|pointed| pointed != bin);
        for ring in 0..OUTWARD {
            let [inner, outer] = [ring, ring + 1].map(|i| RIM * i as f64 / OUTWARD as f64);
            let at = [
                (turns[0], inner),
                (turns[1], inner),
                (turns[1], outer),
                (turns[0], outer),
            ];
            pieces.push(Piece {
                corners: at.map(|(turn, radius)| along(turn, radius)),
                colours: at.map(|(turn, radius)| shade(turn, radius, stands_back)),
            });
        }
    }
    Series::new("", [128; 3], Marks::Ground { pieces })
}

/// The ground's colour at a place.
fn shade(turn: f64, radius: f64, stands_back: bool) -> Rgb {
    const PALE: f64 = 205.0;
    let share = (radius / RIM).powf(0.8);
    let share = if stands_back { 0.22 * share } else { share };
    of_hue(turn).map(|part| (PALE + (f64::from(part) - PALE) * share).round() as u8)
}

/// A colour for a hue of the graphic, plain and of middle lightness.
fn of_hue(turn: f64) -> Rgb {
    let part = |shift: f64| 0.5 + 0.5 * (turn - shift).cos();
    let third = TAU / 3.0;
    [0.35, 0.35 + third, 0.35 + 2.0 * third].map(|shift| (60.0 + 170.0 * part(shift)) as u8)
}

/// A light's shape, and where it is alone the way of each hue from the reference.
fn light(
    series: &mut Vec<Series>,
    name: &str,
    fidelity: &Fidelity,
    [ink, edge]: [Ink; 2],
    has_arrows: bool,
) {
    let bins = fidelity.bins.iter().zip(HUE_NAMES);
    let bins: Vec<_> = bins
        .filter_map(|(bin, hue)| Some((bin.as_ref()?, hue)))
        .collect();
    let mut around: Vec<[f64; 2]> = bins.iter().map(|(bin, _)| bin.test_ab).collect();
    around.extend(around.first().copied());
    series.push(stroke("", edge, around.clone(), 4.6, Dash::Solid));
    series.push(stroke(name, ink, around, 2.4, Dash::Solid));
    for (bin, hue) in bins {
        if has_arrows {
            let ends = vec![bin.reference_ab, bin.test_ab];
            series.push(stroke("", BLACK, ends, 1.6, Dash::Solid));
        }
        let dot = |ink: Ink, radius: f64| {
            Series::points("", ink, Shape::Dot, vec![bin.test_ab]).sized(radius)
        };
        series.push(dot(edge, 4.6));
        let note = tr!(
            "{hue} under {name}: Rf {rf}",
            hue = said(hue),
            name,
            rf = fixed(bin.rf, 0)
        );
        let colour = Ink::Own(of_bin(fidelity, bin));
        series.push(dot(colour, 3.6).with_notes(vec![note]));
    }
}

/// The names of the hues around the rim.
fn names() -> Series {
    let bins = HUE_NAMES.len() as f64;
    // The plain ones first: where there is little room the mixed ones are left out.
    let mixed = |name: &str| usize::from(name.contains(' ')) + usize::from(name.contains("ish"));
    let mut words: Vec<(f64, &'static str)> = HUE_NAMES
        .iter()
        .enumerate()
        .map(|(i, name)| (TAU * (i as f64 + 0.5) / bins, *name))
        .collect();
    words.sort_by_key(|(_, name)| mixed(name));
    let words = words.into_iter().map(|(turn, name)| {
        let name = said(name);
        // Words stand about their middle: the longer, the further out at the sides.
        let [x, y] = along(turn, NAMES);
        let aside = HALF_A_LETTER * name.chars().count() as f64 * turn.cos();
        ([x + aside, y], name.to_owned())
    });
    Series::new(
        "",
        Ink::Text,
        Marks::Words {
            words: words.collect(),
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{comparison::Side, open};

    fn fidelity(name: &str) -> Fidelity {
        let entry = open::resolve(name, None, None).expect("a preset");
        let side = Side::of(name.to_owned(), &entry.spectrum);
        side.figures.fidelity.expect("a white")
    }

    #[test]
    fn each_light_has_a_shape_through_its_own_points() {
        let both = [("FL2", &fidelity("FL2")), ("CIE A", &fidelity("CIE A"))];
        let chart = vector_graphic(&both, None);
        for (name, fidelity) in both {
            let shape = chart.series.iter().find(|series| series.name == name);
            let points = shape.expect(name).marks.points();
            let bins = fidelity.bins.iter().flatten().map(|bin| bin.test_ab);
            assert!(points[..16].iter().copied().eq(bins), "{name}");
            assert_eq!(points.first(), points.last());
        }
        assert!(chart.title.contains("FL2 Rf ") && chart.title.contains("CIE A Rf 100"));
    }

    #[test]
    fn a_place_on_the_graphic_has_the_hue_of_the_samples_there() {
        let found = fidelity("FL2");
        for (i, bin) in found.bins.iter().enumerate() {
            let bin = bin.as_ref().expect("every hue");
            assert_eq!(hue_at(bin.reference_ab), Some(i));
        }
        assert_eq!(hue_at([RIM, RIM]), None);
        assert_eq!(hue_at([1.0, -1e-18]), Some(15));
    }

    #[test]
    fn what_is_not_pointed_at_stands_back() {
        let spread = |colour: Rgb| {
            colour
                .iter()
                .max()
                .zip(colour.iter().min())
                .map(|(a, b)| a - b)
        };
        let Marks::Ground { pieces } = ground(Some(3)).marks else {
            panic!("a ground");
        };
        let rim = |step: usize| spread(pieces[step * OUTWARD + OUTWARD - 1].colours[2]);
        assert!(rim(3 * 6) > rim(4 * 6), "6 steps a hue");
    }
}
