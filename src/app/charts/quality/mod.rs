//! The figures of a light as charts: its place among colours, what it does to colours, and what a
//! few numbers do to both.

mod diagram;
mod vectors;

use serde::{Deserialize, Serialize};

use crate::{
    app::chart::{Chart, Dash, Ink, Series, Shape, stroke},
    color::{
        Adaptation, Srgb, Swatch,
        quality::{Fidelity, HUE_NAMES, HueBin, RENDERING_NAMES, Rendering},
        srgb::linear_from_xyz,
    },
    languages::{fixed, said},
    study::quality::{Chosen, OrderFigures},
};

pub use diagram::{DiagramShows, PlacedLight, diagram};
pub use vectors::{hue_at, vector_graphic};

/// Ink on a coloured ground, whatever the theme.
const BLACK: Ink = Ink::Own([15; 3]);
const WHITE: Ink = Ink::Own([255; 3]);

/// The first light and the second one on a coloured ground, and what sets each off from it.
const ON_GROUND: [[Ink; 2]; 2] = [[BLACK, WHITE], [Ink::Own([190, 0, 130]), WHITE]];

/// The colour of a hue bin: that of its samples under the reference, as an eye used to it sees them.
fn of_bin(fidelity: &Fidelity, bin: &HueBin) -> [u8; 3] {
    let white = fidelity.reference_white;
    let seen = Swatch::of_patch(bin.reference_xyz, white, Adaptation::ToLight);
    seen.rgb8.0
}

/// A chart of what a light does to colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OfColours {
    /// The vector graphic of TM-30.
    #[default]
    Vectors,
    /// The fidelity of each hue.
    Fidelity,
    /// The change of chroma of each hue.
    Chroma,
    /// The turn of each hue.
    Hue,
    /// CRI.
    Samples,
    /// The fidelity of each sample.
    Surfaces,
}

impl OfColours {
    pub const ALL: [Self; 6] = [
        Self::Vectors,
        Self::Fidelity,
        Self::Chroma,
        Self::Hue,
        Self::Samples,
        Self::Surfaces,
    ];

    /// A word or two, for a button.
    pub fn word(self) -> &'static str {
        match self {
            Self::Vectors => said!("Vectors"),
            Self::Fidelity => said!("Fidelity"),
            Self::Chroma => said!("Chroma"),
            Self::Hue => said!("Hue"),
            Self::Samples => "CRI",
            Self::Surfaces => said!("99 surfaces"),
        }
    }
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

/// Of two lights' bars the place of each beside the middle, and how wide one is.
fn places(lights: usize) -> (&'static [f64], f64) {
    match lights {
        1 => (&[0.0], 0.8),
        _ => (&[-0.2, 0.2], 0.36),
    }
}

/// The 16 hues as bars, of two lights side by side, the second one's under a cap in its ink.
pub fn bin_bars(lights: &[(&str, &Fidelity)], what: OfBins) -> Chart {
    let (mut series, mut second) = (Vec::new(), Vec::new());
    let (places, width) = places(lights.len());
    for (k, ((name, fidelity), place)) in lights.iter().zip(places).enumerate() {
        for (i, (bin, hue)) in fidelity.bins.iter().zip(HUE_NAMES).enumerate() {
            let Some(bin) = bin else { continue };
            let value = match what {
                OfBins::Fidelity => bin.rf,
                OfBins::Chroma => 100.0 * bin.rcs,
                OfBins::Hue => bin.rhs,
            };
            let at = i as f64 + 1.0 + place;
            let colour = of_bin(fidelity, bin);
            let bar = Series::bars("", colour, width, vec![[at, value]]);
            series.push(bar.with_notes(vec![tr!("{hue} under {name}", hue = said(hue), name)]));
            second.extend((k == 1).then_some([at, value]));
        }
    }
    series.extend(caps(&second, width));
    let (title, unit, range) = match what {
        OfBins::Fidelity => (said!("Fidelity of each hue"), "Rf,h", [0.0, 100.0]),
        OfBins::Chroma => (said!("Chroma shift of each hue"), "%", [-40.0, 40.0]),
        OfBins::Hue => (
            said!("Hue shift of each hue"),
            said!("radians"),
            [-0.5, 0.5],
        ),
    };
    Chart {
        title: beside(title, lights.iter().map(|(name, _)| *name)),
        y_label: unit.to_owned(),
        x_range: [0.4, 16.6],
        x_names: HUE_NAMES
            .iter()
            .enumerate()
            .map(|(i, hue)| (i as f64 + 1.0, said(hue).to_owned()))
            .collect(),
        y_range: Some(range),
        series,
        ..Chart::default()
    }
}

/// A title, and which of two lights stands where.
fn beside<'n>(title: &str, names: impl Iterator<Item = &'n str>) -> String {
    let names: Vec<&str> = names.collect();
    match &names[..] {
        [first, second] => tr!(
            "{title}: left {first}, right {second}",
            title,
            first,
            second
        ),
        _ => title.to_owned(),
    }
}

/// A line over each bar of the second light.
fn caps(tops: &[[f64; 2]], width: f64) -> impl Iterator<Item = Series> {
    let cap = move |[at, value]: &[f64; 2]| {
        let ends = [-0.5, 0.5].map(|side| [at + side * width, *value]);
        stroke("", Ink::Second, ends.to_vec(), 3.0, Dash::Solid)
    };
    tops.iter().map(cap)
}

/// R1 to R15 as bars, of one light split into the sample's colour under the reference and under the
/// light, of two one bar each.
pub fn sample_bars(lights: &[(&str, &Rendering)]) -> Chart {
    const HALF: f64 = 0.4;
    let (mut series, mut second) = (Vec::new(), Vec::new());
    let mut lowest = 0.0_f64;
    for (k, (name, rendering)) in lights.iter().enumerate() {
        for (i, sample) in rendering.samples.iter().enumerate() {
            let at = i as f64 + 1.0;
            lowest = lowest.min(sample.index);
            let under = [
                (-1.0, sample.reference, said!("under the reference")),
                (1.0, sample.test, said!("under this light")),
            ];
            for (side, xyz, whose) in under {
                // Of two lights each has the side of its place.
                if lights.len() > 1 && side != [-1.0, 1.0][k] {
                    continue;
                }
                let xyz = if lights.len() > 1 { sample.test } else { xyz };
                let whose = if lights.len() > 1 { *name } else { whose };
                let linear = linear_from_xyz(xyz.scaled(0.01));
                let colour = Srgb::from_linear(linear.map(|v| v.clamp(0.0, 1.0))).0;
                let place = at + side * HALF / 2.0;
                second.extend((k == 1).then_some([place, sample.index]));
                let bar = Series::bars("", colour, HALF, vec![[place, sample.index]]);
                series.push(bar.with_notes(vec![format!(
                    "R{}, {}, {whose}: {:.0}",
                    i + 1,
                    said(RENDERING_NAMES[i]),
                    sample.index
                )]));
            }
        }
    }
    series.extend(caps(&second, HALF));
    let names = (1..=RENDERING_NAMES.len()).map(|i| (i as f64, format!("R{i}")));
    let title = match lights {
        [(_, rendering)] => tr!(
            "CRI: Ra {ra}, the mean of R1 to R8",
            ra = fixed(rendering.ra, 0)
        ),
        _ => beside("CRI", lights.iter().map(|(name, _)| *name)),
    };
    Chart {
        title,
        x_label: said!("Test colour").to_owned(),
        y_label: "Ri".to_owned(),
        x_range: [0.4, 15.6],
        x_names: names.collect(),
        y_range: Some([(lowest / 20.0).floor() * 20.0, 100.0]),
        series,
        ..Chart::default()
    }
}

/// The fidelity of each of the 99 samples as bars, of two lights the second one's as points.
pub fn fidelity_bars(lights: &[(&str, &Fidelity)]) -> Chart {
    let lowest = lights.iter().map(|(name, fidelity)| {
        let lowest = fidelity.samples.iter().copied().fold(100.0, f64::min);
        match lights.len() {
            1 => tr!("Rf {lowest} at worst", lowest = fixed(lowest, 0)),
            _ => tr!("{name} {lowest} at worst", name, lowest = fixed(lowest, 0)),
        }
    });
    let lowest: Vec<String> = lowest.collect();
    let series = lights.iter().enumerate().map(|(k, (name, fidelity))| {
        let values = fidelity.samples.iter().enumerate();
        let points = values.map(|(i, rf)| [i as f64 + 1.0, *rf]).collect();
        let name = if lights.len() == 1 { "" } else { name };
        match k {
            0 => Series::bars(name, Ink::Smooth, 0.8, points),
            _ => Series::points(name, Ink::Second, Shape::Dot, points).sized(2.4),
        }
    });
    Chart {
        title: tr!("99 surfaces: {lowest}", lowest = lowest.join(", ")),
        x_label: said!("Sample CES").to_owned(),
        y_label: "Rf".to_owned(),
        x_range: [0.0, 100.0],
        y_range: Some([0.0, 100.0]),
        series: series.collect(),
        ..Chart::default()
    }
}

/// At least twice so many waves are drawn.
const LEAST_NEEDED: usize = 5;

/// One figure against the waves of the model, the exact value a line.
pub fn against_order(found: &OrderFigures, chosen: Chosen) -> Chart {
    let points: Vec<[f64; 2]> = found
        .points
        .iter()
        .filter_map(|point| Some([point.order as f64, chosen.of(&point.figures)?]))
        .collect();
    let last = found.points.last().map_or(1.0, |point| point.order as f64);
    // Nothing happens beyond twice what all figures need.
    let settled = Chosen::ALL.map(|chosen| found.settled_from(chosen));
    let needed = settled.into_iter().flatten().max();
    let shown = needed.map_or(last, |order| (2 * order.max(LEAST_NEEDED)) as f64);
    let mut series = Vec::new();
    if let Some(exact) = chosen.of(&found.exact) {
        let near = chosen.near_enough(exact);
        let upper = vec![[0.0, exact + near], [last, exact + near]];
        let lower = vec![exact - near; 2];
        series.push(Series::area(
            said!("near enough"),
            Ink::Residual,
            upper,
            lower,
        ));
        let level = vec![[0.0, exact], [last, exact]];
        series.push(Series::line(said!("measured"), Ink::Measured, level).dashed(Dash::Dashed));
    }
    series.push(Series::line(said!("model"), Ink::Spikes, points.clone()));
    series.push(Series::points("", Ink::Spikes, Shape::Dot, points));
    Chart {
        title: tr!("{figure} against waves", figure = said(chosen.title())),
        x_label: said!("Waves").to_owned(),
        y_label: match chosen {
            Chosen::Cct => "CCT (K)".to_owned(),
            other => said(other.title()).to_owned(),
        },
        x_range: [0.0, shown.min(last)],
        series,
        ..Chart::default()
    }
}
