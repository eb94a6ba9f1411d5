//! The chromaticity diagram: lights, whites, screens and what surfaces look like under a light.

use serde::{Deserialize, Serialize};

use super::{BLACK, ON_GROUND};
use crate::{
    app::chart::{Chart, Dash, Ink, Marks, Piece, Rgb, Series, Shape, stroke},
    color::{
        Observer, Srgb, Xyz,
        quality::{
            Figures,
            diagram::{
                ELLIPSES, GAMUTS, Plane, QUADRANGLES, TICKS_K, daylight_locus, planckian_locus,
                spectral_locus, tick,
            },
        },
        srgb::linear_from_xyz,
        xy_from_xyz,
    },
};

/// What the diagram shows beside the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct DiagramShows {
    /// CIE 1976 u'v', else CIE 1931 xy.
    pub uniform: bool,
    /// sRGB, P3 and Rec. 2020.
    pub gamuts: bool,
    /// The nominal whites of ANSI C78.377.
    pub whites: bool,
    /// MacAdam's ellipses, ten times enlarged.
    pub ellipses: bool,
    /// The neighbourhood of the light alone.
    pub near: bool,
    /// The corners of surfaces' colours under the light.
    pub surfaces: bool,
}

impl Default for DiagramShows {
    fn default() -> Self {
        Self {
            uniform: true,
            gamuts: false,
            whites: true,
            ellipses: false,
            near: false,
            surfaces: true,
        }
    }
}

impl DiagramShows {
    fn plane(self) -> Plane {
        if self.uniform {
            Plane::Uv1976
        } else {
            Plane::Xy
        }
    }
}

/// Pieces of colour along the axes of the diagram.
const PIECES: [usize; 2] = [48, 96];

/// How far the neighbourhood of a light reaches to either side.
const NEAR: f64 = 0.03;

/// A colour of a chromaticity: what a screen cannot show is whitened until it can.
fn shown(xy: [f64; 2]) -> Option<Rgb> {
    let [x, y] = xy;
    if y <= 0.0 {
        return None;
    }
    let linear = linear_from_xyz(Xyz::new(x / y, 1.0, (1.0 - x - y) / y));
    let least = linear.into_iter().fold(0.0, f64::min);
    let linear = linear.map(|v| v - least);
    let most = linear.into_iter().fold(0.0, f64::max);
    (most > 0.0).then(|| Srgb::from_linear(linear.map(|v| v / most)).0)
}

/// Where a level line enters and leaves a closed line, from left to right.
fn crossings(closed: &[[f64; 2]], y: f64) -> Vec<f64> {
    let next = closed.iter().cycle().skip(1);
    let sides = closed.iter().zip(next);
    let mut found: Vec<f64> = sides
        .filter(|([_, ay], [_, by])| (*ay > y) != (*by > y))
        .map(|([ax, ay], [bx, by])| (bx - ax) * (y - ay) / (by - ay) + ax)
        .collect();
    found.sort_by(f64::total_cmp);
    found
}

/// A light in the diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLight {
    /// Stands beside it.
    pub name: String,
    /// Its place, x and y; `None` for one that has no colour.
    pub xy: Option<[f64; 2]>,
    /// The corners of the colours that test surfaces have under it, x and y.
    pub gamut: Vec<[f64; 2]>,
}

impl PlacedLight {
    /// A light by its figures: its gamut is that of the eight test colours of Ra.
    pub fn of(name: &str, figures: &Figures) -> Self {
        let samples = figures.rendering.as_ref().map(|found| &found.samples[..8]);
        let colours = samples.unwrap_or_default().iter();
        Self {
            name: name.to_owned(),
            xy: figures.xy[0].clone().ok(),
            gamut: colours
                .filter_map(|found| xy_from_xyz(found.test))
                .collect(),
        }
    }
}

/// The chromaticity diagram with lights.
pub fn diagram(lights: &[PlacedLight], shows: DiagramShows) -> Chart {
    let plane = shows.plane();
    let locus: Vec<[f64; 2]> = spectral_locus(Observer::CIE_1931, plane)
        .into_iter()
        .filter(|point| (380..=700).contains(&point.nm))
        .map(|point| point.at)
        .collect();
    let whole = if shows.uniform {
        [[0.0, 0.64], [0.0, 0.6]]
    } else {
        [[0.0, 0.76], [0.0, 0.86]]
    };
    let near = shows.near.then(|| around(lights, plane)).flatten();
    let [x_range, y_range] = near.unwrap_or(whole);
    let mut series = vec![colours(&locus, plane, [x_range, y_range])];
    series.push(stroke("", Ink::Text, closed(locus), 1.4, Dash::Solid));
    areas(&mut series, shows, Ink::Text);
    blackbodies(&mut series, shows);
    for (light, inks) in lights.iter().zip(ON_GROUND) {
        placed(&mut series, light, inks, shows);
    }
    let [x_label, y_label] = if shows.uniform {
        ["u′", "v′"]
    } else {
        ["x", "y"]
    };
    Chart {
        title: if shows.near {
            said!("Near the light")
        } else {
            said!("Chromaticity")
        }
        .to_owned(),
        x_label: x_label.to_owned(),
        y_label: y_label.to_owned(),
        x_range,
        y_range: Some(y_range),
        even: true,
        series,
        ..Chart::default()
    }
}

/// The neighbourhood of all lights; `None` where none has a colour.
fn around(lights: &[PlacedLight], plane: Plane) -> Option<[[f64; 2]; 2]> {
    let places = lights
        .iter()
        .filter_map(|light| Some(plane.of_xy(light.xy?)));
    let places: Vec<[f64; 2]> = places.collect();
    let ends = |k: usize| {
        let low = places.iter().map(|at| at[k]).fold(f64::INFINITY, f64::min);
        let high = places
            .iter()
            .map(|at| at[k])
            .fold(f64::NEG_INFINITY, f64::max);
        [low - NEAR, high + NEAR]
    };
    (!places.is_empty()).then(|| [ends(0), ends(1)])
}

/// A light, and the colours of surfaces under it.
fn placed(
    series: &mut Vec<Series>,
    light: &PlacedLight,
    [ink, edge]: [Ink; 2],
    shows: DiagramShows,
) {
    let plane = shows.plane();
    if shows.surfaces && light.gamut.len() > 2 {
        let corners = light.gamut.iter().map(|xy| plane.of_xy(*xy));
        let corners = closed(corners.collect());
        series.push(stroke("", edge, corners.clone(), 3.6, Dash::Solid));
        series.push(stroke("", ink, corners, 1.8, Dash::Solid));
    }
    let Some(xy) = light.xy else { return };
    let at = plane.of_xy(xy);
    let dot = |name: &str, ink: Ink, radius: f64| {
        Series::points(name, ink, Shape::Dot, vec![at]).sized(radius)
    };
    series.push(dot("", edge, 7.5));
    let notes = vec![light.name.clone()];
    series.push(dot(&light.name, ink, 6.0).with_notes(notes));
}

/// An outline that ends where it begins.
fn closed(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.extend(points.first().copied());
    points
}

/// What screens reach, what looks alike, and whites that lamps are sold by, where asked for.
fn areas(series: &mut Vec<Series>, shows: DiagramShows, edge: Ink) {
    let plane = shows.plane();
    if shows.gamuts {
        for gamut in GAMUTS.iter().filter(|gamut| gamut.name != "DCI-P3") {
            let corners = gamut.primaries.map(|xy| plane.of_xy(xy)).to_vec();
            series.push(stroke(gamut.name, edge, closed(corners), 1.0, Dash::Dashed));
        }
    }
    if shows.ellipses {
        for ellipse in &ELLIPSES {
            let outline = ellipse.outline(10.0, 48).into_iter();
            let points = outline.map(|xy| plane.of_xy(xy)).collect();
            series.push(stroke("", [70; 3], closed(points), 0.9, Dash::Solid));
        }
    }
    if shows.whites {
        for white in QUADRANGLES.iter() {
            let corners = white.corners.map(|xy| plane.of_xy(xy)).to_vec();
            series.push(stroke("", [40; 3], closed(corners), 0.9, Dash::Solid));
        }
    }
}

/// Black bodies with their temperatures, and daylight.
fn blackbodies(series: &mut Vec<Series>, shows: DiagramShows) {
    let (plane, black) = (shows.plane(), BLACK);
    let locus = planckian_locus(plane);
    series.push(stroke("", black, locus, 1.8, Dash::Solid));
    let daylight = daylight_locus(plane);
    series.push(stroke("", [60; 3], daylight, 1.2, Dash::Dotted));
    // Far from the light only some temperatures have room for their words.
    let told: &[f64] = match shows.near {
        true => &TICKS_K,
        false => &[2000.0, 3000.0, 4000.0, 6500.0, 10_000.0],
    };
    let mut words = Vec::new();
    for mark in TICKS_K
        .into_iter()
        .filter_map(|kelvin| tick(kelvin, 0.01, plane))
    {
        let [low, high] = [mark.below, mark.above];
        series.push(stroke("", black, vec![low, high], 1.0, Dash::Solid));
        if told.contains(&mark.kelvin) {
            // Beyond the tick's end by as much as the words are wide: that is less of it near by.
            let share = if shows.near { 0.2 } else { 1.1 };
            let beyond = [0, 1].map(|k| low[k] + share * (low[k] - high[k]));
            words.push((beyond, format!("{:.0} K", mark.kelvin)));
        }
    }
    series.push(Series::new("", black, Marks::Words { words }));
}

/// The colours inside the locus, as far as a screen shows them.
fn colours(locus: &[[f64; 2]], plane: Plane, [x_range, y_range]: [[f64; 2]; 2]) -> Series {
    let heights = locus.iter().map(|at| at[1]);
    let lowest = heights.clone().fold(f64::INFINITY, f64::min);
    let highest = heights.fold(f64::NEG_INFINITY, f64::max);
    let (low, high) = (lowest.max(y_range[0]), highest.min(y_range[1]));
    let [across, up] = PIECES;
    // The ends themselves are crossed by no level line.
    let level = |row: usize| low + (high - low) * (row as f64 / up as f64).clamp(1e-6, 1.0 - 1e-6);
    let ends = |y: f64| match crossings(locus, y)[..] {
        [left, .., right] => Some([left, right].map(|x| x.clamp(x_range[0], x_range[1]))),
        _ => None,
    };
    let corner = |[left, right]: [f64; 2], y: f64, column: usize| {
        [left + (right - left) * column as f64 / across as f64, y]
    };
    let mut pieces = Vec::new();
    for row in 0..up {
        let [y, next] = [level(row), level(row + 1)];
        let (Some(below), Some(above)) = (ends(y), ends(next)) else {
            continue;
        };
        for column in 0..across {
            let corners = [
                corner(below, y, column),
                corner(below, y, column + 1),
                corner(above, next, column + 1),
                corner(above, next, column),
            ];
            let found = corners.map(|at| shown(plane.to_xy(at)));
            if let [Some(a), Some(b), Some(c), Some(d)] = found {
                let colours = [a, b, c, d];
                pieces.push(Piece { corners, colours });
            }
        }
    }
    Series::new("", [128; 3], Marks::Ground { pieces })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{comparison::Side, open};

    #[test]
    fn the_ground_fills_the_locus_without_gaps() {
        let chart = diagram(&[], DiagramShows::default());
        let Marks::Ground { pieces } = &chart.series[0].marks else {
            panic!("a ground");
        };
        let area = |corners: &[[f64; 2]]| {
            let next = corners.iter().cycle().skip(1);
            let twice = corners
                .iter()
                .zip(next)
                .map(|(a, b)| a[0] * b[1] - b[0] * a[1]);
            0.5 * twice.sum::<f64>().abs()
        };
        let filled: f64 = pieces.iter().map(|piece| area(&piece.corners)).sum();
        let locus = chart.series[1].marks.points();
        // Rows of a 96th of the height leave slivers at the curved side.
        assert!((filled / area(locus) - 1.0).abs() < 0.01);
    }

    #[test]
    fn two_lights_have_their_points_and_their_surfaces() {
        let placed = ["FL2", "CIE A"].map(|name| {
            let entry = open::resolve(name, None, None).expect("a preset");
            let side = Side::of(name.to_owned(), &entry.spectrum);
            PlacedLight::of(name, &side.figures)
        });
        for light in &placed {
            assert_eq!(light.gamut.len(), 8, "{}", light.name);
        }
        let shows = DiagramShows {
            near: true,
            ..DiagramShows::default()
        };
        let chart = diagram(&placed, shows);
        for light in &placed {
            let named = chart.series.iter().find(|series| series.name == light.name);
            let at = named.expect("a point").marks.points()[0];
            assert_eq!(at, Plane::Uv1976.of_xy(light.xy.expect("a colour")));
            let [y_low, y_high] = chart.y_range.expect("a range");
            assert!(chart.x_range[0] < at[0] && at[0] < chart.x_range[1]);
            assert!(y_low < at[1] && at[1] < y_high);
        }
    }
}
