//! The figures of a light as charts: its place among colours, what it does to colours, and what a
//! few numbers do to both.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Marks, Rgb, Series, Shape, stroke},
        pages::DiagramShows,
    },
    color::{
        Observer, Srgb, Xyz,
        quality::{
            Fidelity, HUE_NAMES, RENDERING_NAMES, Rendering,
            diagram::{
                ELLIPSES, GAMUTS, Plane, QUADRANGLES, TICKS_K, daylight_locus, planckian_locus,
                spectral_locus, tick,
            },
        },
        srgb::linear_from_xyz,
    },
    study::quality::{Chosen, OrderFigures},
};

impl DiagramShows {
    fn plane(self) -> Plane {
        if self.uniform {
            Plane::Uv1976
        } else {
            Plane::Xy
        }
    }
}

/// Boxes of colour along the axes of the diagram.
const BOXES: [usize; 2] = [90, 220];

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

/// Ink on the coloured ground, whatever the theme.
const BLACK: Ink = Ink::Own([15; 3]);

/// The chromaticity diagram with a light as measured and by its model, both xy.
pub fn diagram(measured: Option<[f64; 2]>, model: Option<[f64; 2]>, shows: DiagramShows) -> Chart {
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
    let [x_range, y_range] = match measured.filter(|_| shows.near) {
        Some(xy) => plane.of_xy(xy).map(|at| [at - NEAR, at + NEAR]),
        None => whole,
    };
    let mut series = vec![colours(&locus, plane, [x_range, y_range])];
    series.push(stroke("", Ink::Text, closed(locus), 1.4, Dash::Solid));
    areas(&mut series, shows, Ink::Text);
    blackbodies(&mut series, shows);
    let point = |name: &str, colour: Ink, shape: Shape, radius: f64, xy: [f64; 2]| {
        Series::points(name, colour, shape, vec![plane.of_xy(xy)]).sized(radius)
    };
    if let Some(xy) = measured {
        series.push(point("", BLACK, Shape::Dot, 6.0, xy));
        series.push(point("measured", Ink::Measured, Shape::Dot, 4.5, xy));
    }
    if let Some(xy) = model {
        series.push(point("model", Ink::Spikes, Shape::Ring, 7.0, xy));
    }
    let [x_label, y_label] = if shows.uniform {
        ["u′", "v′"]
    } else {
        ["x", "y"]
    };
    Chart {
        title: "Chromaticity".to_owned(),
        x_label: x_label.to_owned(),
        y_label: y_label.to_owned(),
        x_range,
        y_range: Some(y_range),
        series,
        ..Chart::default()
    }
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
            // A little beyond the tick's end.
            let beyond = [0, 1].map(|k| low[k] + 0.5 * (low[k] - high[k]));
            words.push((beyond, format!("{:.0} K", mark.kelvin)));
        }
    }
    series.push(Series::new("", black, Marks::Words { words }));
}

/// The colours inside the locus, as far as a screen shows them.
fn colours(locus: &[[f64; 2]], plane: Plane, [x_range, y_range]: [[f64; 2]; 2]) -> Series {
    let step = |[low, high]: [f64; 2], boxes: usize| (high - low) / boxes as f64;
    let (dx, dy) = (step(x_range, BOXES[0]), step(y_range, BOXES[1]));
    let mut fields = Vec::new();
    for row in 0..BOXES[1] {
        let low = y_range[0] + dy * row as f64;
        let y = low + dy / 2.0;
        for inside in crossings(locus, y).chunks_exact(2) {
            for column in 0..BOXES[0] {
                let left = x_range[0] + dx * column as f64;
                // A little over the next, so that no ground shows between.
                let right = (left + 1.05 * dx).min(inside[1]);
                let left = left.max(inside[0]);
                if left >= right {
                    continue;
                }
                if let Some(colour) = shown(plane.to_xy([(left + right) / 2.0, y])) {
                    fields.push(([[left, right], [low, low + 1.05 * dy]], colour));
                }
            }
        }
    }
    Series::new("", [128; 3], Marks::Fields { fields })
}

/// TM-30's colour vector graphic: the reference a circle, the light around it.
pub fn vector_graphic(fidelity: &Fidelity) -> Chart {
    let circle = |radius: f64| -> Vec<[f64; 2]> {
        let turns = (0..=90).map(|i| f64::from(i) * std::f64::consts::TAU / 90.0);
        turns
            .map(|turn| [radius * turn.cos(), radius * turn.sin()])
            .collect()
    };
    let mut series: Vec<Series> = [0.8, 0.9, 1.1, 1.2]
        .map(|radius| stroke("", Ink::Grid, circle(radius), 1.0, Dash::Solid))
        .to_vec();
    let unit = circle(1.0);
    series.push(stroke("reference", Ink::Axis, unit, 1.6, Dash::Solid));
    let bins: Vec<_> = fidelity.bins.iter().flatten().collect();
    let around = closed(bins.iter().map(|bin| bin.test_ab).collect());
    for bin in &bins {
        let ends = vec![bin.reference_ab, bin.test_ab];
        let colour = of_hue(bin.reference_ab);
        series.push(stroke("", colour, ends, 2.2, Dash::Solid));
        let dot = Series::points("", colour, Shape::Dot, vec![bin.test_ab]);
        series.push(dot.sized(3.2));
    }
    series.push(stroke("this light", Ink::Spikes, around, 2.0, Dash::Solid));
    Chart {
        title: format!(
            "Colour vectors: Rf {:.0}, Rg {:.0}",
            fidelity.rf, fidelity.rg
        ),
        x_label: "a′ over the reference's chroma".to_owned(),
        y_label: "b′".to_owned(),
        x_range: [-1.5, 1.5],
        y_range: Some([-1.5, 1.5]),
        even: true,
        series,
        ..Chart::default()
    }
}

/// A colour for a hue of the graphic, plain and of middle lightness.
fn of_hue([a, b]: [f64; 2]) -> Rgb {
    let turn = b.atan2(a);
    let part = |shift: f64| 0.5 + 0.5 * (turn - shift).cos();
    let third = std::f64::consts::TAU / 3.0;
    [0.35, 0.35 + third, 0.35 + 2.0 * third].map(|shift| (60.0 + 170.0 * part(shift)) as u8)
}

/// What of the hue bins bars tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfBins {
    /// Local fidelity.
    Fidelity,
    /// Local chroma shift, per cent.
    Chroma,
    /// Local hue shift, radians.
    Hue,
}

/// The 16 hue bins as bars.
pub fn bin_bars(fidelity: &Fidelity, what: OfBins) -> Chart {
    let mut series = Vec::new();
    for (i, bin) in fidelity.bins.iter().enumerate() {
        let Some(bin) = bin else { continue };
        let value = match what {
            OfBins::Fidelity => bin.rf,
            OfBins::Chroma => 100.0 * bin.rcs,
            OfBins::Hue => bin.rhs,
        };
        let at = i as f64 + 1.0;
        let colour = of_hue(bin.reference_ab);
        let bar = Series::bars("", colour, 0.8, vec![[at, value]]);
        series.push(bar.with_notes(vec![HUE_NAMES[i].to_owned()]));
    }
    let (title, unit, range) = match what {
        OfBins::Fidelity => ("Fidelity of each hue", "Rf,h", [0.0, 100.0]),
        OfBins::Chroma => ("Chroma shift of each hue", "%", [-40.0, 40.0]),
        OfBins::Hue => ("Hue shift of each hue", "radians", [-0.5, 0.5]),
    };
    Chart {
        title: title.to_owned(),
        x_label: "Hue bin".to_owned(),
        y_label: unit.to_owned(),
        x_range: [0.4, 16.6],
        y_range: Some(range),
        series,
        ..Chart::default()
    }
}

/// R1 to R15 as bars, each split into the sample's colour under the reference and under the light.
pub fn sample_bars(rendering: &Rendering) -> Chart {
    const HALF: f64 = 0.4;
    let mut series = Vec::new();
    let mut names = Vec::new();
    for (i, sample) in rendering.samples.iter().enumerate() {
        let at = i as f64 + 1.0;
        for (side, xyz, whose) in [
            (-1.0, sample.reference, "under the reference"),
            (1.0, sample.test, "under this light"),
        ] {
            let linear = linear_from_xyz(xyz.scaled(0.01));
            let colour = Srgb::from_linear(linear.map(|v| v.clamp(0.0, 1.0))).0;
            let place = at + side * HALF / 2.0;
            let bar = Series::bars("", colour, HALF, vec![[place, sample.index]]);
            series.push(bar.with_notes(vec![format!(
                "R{}, {}, {whose}: {:.0}",
                i + 1,
                RENDERING_NAMES[i],
                sample.index
            )]));
        }
        names.push((at, format!("R{}", i + 1)));
    }
    let indices = rendering.indices();
    let lowest = indices.into_iter().fold(0.0, f64::min);
    Chart {
        title: format!("CRI: Ra {:.0}, the mean of R1 to R8", rendering.ra),
        x_label: "Test colour".to_owned(),
        y_label: "Ri".to_owned(),
        x_range: [0.4, 15.6],
        x_names: names,
        y_range: Some([(lowest / 20.0).floor() * 20.0, 100.0]),
        series,
        ..Chart::default()
    }
}

/// The fidelity of each of the 99 samples as bars.
pub fn fidelity_bars(fidelity: &Fidelity) -> Chart {
    let values = fidelity.samples.iter().enumerate();
    let points: Vec<[f64; 2]> = values.map(|(i, rf)| [i as f64 + 1.0, *rf]).collect();
    let lowest = fidelity.samples.iter().copied().fold(100.0, f64::min);
    Chart {
        title: format!("99 surfaces: Rf {lowest:.0} at worst"),
        x_label: "Sample CES".to_owned(),
        y_label: "Rf".to_owned(),
        x_range: [0.0, 100.0],
        y_range: Some([0.0, 100.0]),
        series: vec![Series::bars("", Ink::Smooth, 0.8, points)],
        ..Chart::default()
    }
}

/// One figure against the order of the model, the exact value a line.
pub fn against_order(found: &OrderFigures, chosen: Chosen) -> Chart {
    let points: Vec<[f64; 2]> = found
        .points
        .iter()
        .filter_map(|point| Some([point.order as f64, chosen.of(&point.figures)?]))
        .collect();
    let last = found.points.last().map_or(1.0, |point| point.order as f64);
    let mut series = Vec::new();
    if let Some(exact) = chosen.of(&found.exact) {
        let near = chosen.near_enough(exact);
        let upper = vec![[0.0, exact + near], [last, exact + near]];
        let lower = vec![exact - near; 2];
        series.push(Series::area("near enough", Ink::Residual, upper, lower));
        let level = vec![[0.0, exact], [last, exact]];
        series.push(Series::line("measured", Ink::Measured, level).dashed(Dash::Dashed));
    }
    series.push(Series::line("model", Ink::Spikes, points.clone()));
    series.push(Series::points("", Ink::Spikes, Shape::Dot, points));
    Chart {
        title: format!("{} against the order", chosen.title()),
        x_label: "Order N".to_owned(),
        y_label: chosen.title().to_owned(),
        x_range: [0.0, last],
        series,
        ..Chart::default()
    }
}
