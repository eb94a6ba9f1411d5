//! The light behind a narrow band-pass: its spectrum with the filter over it, and what three
//! representations of equal size are off by for every place of the band-pass.

mod filters;

use std::sync::Arc;

use super::{chain::strip, resampling::thin};
use crate::{
    app::{
        App, Entry,
        chart::{Chart, Dash, Ink, Scale, Series, Shape},
        charts::{
            spectrum::{before_provenance, on_grid, over, spike_stems},
            units::value_label,
        },
        products::ModelledLight,
        ticks::extent,
    },
    color::{Adaptation, Swatch, Xyz, srgb::linear_from_xyz},
    io::many::numbers,
    languages::{fixed, said},
    spectrum::{Band, gaussian},
    study::products::{Colours, Narrow, NarrowPoint},
};

pub use filters::FilterRow;

/// The three representations, in the order of every table.
pub const WAYS: [&str; 3] = [
    later!("waves and lines"),
    later!("waves alone"),
    later!("plain samples"),
];

/// What each of them is.
pub const WAY_MEANINGS: [&str; 3] = [
    later!("The model: waves for the smooth part, and a place and a weight for each line."),
    later!("The same basis with all numbers spent on waves, none on lines."),
    later!("Plain point samples joined by straight lines."),
];

/// Most band-passes that a curve has: wide ranges are walked in steps of several nm.
const MOST_CENTRES: usize = 801;

/// How a representation is drawn: ink and dash.
fn looks(way: usize) -> (Ink, Dash) {
    match way {
        0 => (Ink::Spikes, Dash::Solid),
        1 => (Ink::Smooth, Dash::Dashed),
        _ => (Ink::Product, Dash::Dotted),
    }
}

/// What stands over the light.
#[derive(Clone, Debug)]
pub enum Filter {
    /// A Gaussian of a centre and a full width at half its maximum, nm.
    Gaussian {
        /// Centre, nm.
        centre_nm: f64,
        /// Full width, nm.
        width_nm: f64,
    },
    /// A measured one.
    Real(Arc<Entry>),
}

impl Filter {
    /// Its share at each point of the grid.
    pub fn on_band(&self, band: Band) -> Vec<f64> {
        match self {
            Self::Gaussian {
                centre_nm,
                width_nm,
            } => band
                .grid()
                .map(|nm| gaussian((nm - centre_nm) / width_nm))
                .collect(),
            Self::Real(entry) => entry.on_band(band),
        }
    }

    /// Where it can be taken hold of, with its share there: the top moves it, the flanks widen it.
    fn handles(&self) -> Vec<[f64; 2]> {
        match *self {
            Self::Gaussian {
                centre_nm,
                width_nm,
            } => vec![
                [centre_nm - 0.5 * width_nm, 0.5],
                [centre_nm, 1.0],
                [centre_nm + 0.5 * width_nm, 0.5],
            ],
            Self::Real(_) => Vec::new(),
        }
    }
}

/// The light as measured and in three representations of equal size.
#[derive(Clone, Debug)]
pub struct Behind {
    /// The light's name.
    pub light: String,
    /// The grid.
    pub band: Band,
    lit: ModelledLight,
    narrow: Narrow,
    /// The second light, its values on the grid and its colour.
    second: Option<(String, Vec<f64>, Xyz)>,
}

/// The second light behind a filter.
#[derive(Clone, Debug, PartialEq)]
pub struct SecondBehind {
    pub name: String,
    /// `Y` behind the filter over that of the light; `None` without light.
    pub luminance: Option<f64>,
    /// Both lights brought to one luminance before the filter, then as bright as colours are
    /// compared.
    pub swatch: Swatch,
}

/// What one filter leaves of the light.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    /// The three representations.
    pub ways: [Colours; 3],
    /// `Y` behind the filter over that of the light; `None` without light.
    pub luminance: Option<f64>,
}

impl Behind {
    /// The document's light.
    pub fn of(app: &App) -> Self {
        let lit = ModelledLight::of(app);
        let settings = app.document().settings;
        let derived = &lit.derived;
        let (values, ideal) = (derived.outline(), derived.ideal_spikes());
        let narrow = Narrow::of_parts(
            &derived.measured,
            derived.model.smooth(),
            (&values, &ideal, derived.numbers()),
            settings.colour_exact,
            &lit.tables.viewing.weights,
        );
        let band = lit.band();
        let second = app.document().second.as_ref().map(|entry| {
            let values = entry.on_band(band);
            let white = lit.xyz(&values);
            (entry.name().to_owned(), values, white)
        });
        Self {
            light: app.document().light.name().to_owned(),
            band,
            narrow,
            second,
            lit,
        }
    }

    /// What a filter leaves of the second light; `None` where none was chosen.
    pub fn second(&self, figures: &Figures, filter: &Filter) -> Option<SecondBehind> {
        let (name, values, white) = self.second.as_ref()?;
        let through = values.iter().zip(filter.on_band(self.band));
        let xyz = self
            .lit
            .xyz(&through.map(|(v, share)| v * share).collect::<Vec<_>>());
        let share = Some(xyz.y / white.y).filter(|share| share.is_finite());
        let scale = 100.0 / white.y;
        let gain = self.narrow.gain(figures.ways[0].exact);
        let swatch = match share {
            Some(_) => Swatch::of_patch(xyz * (gain * scale), *white * scale, Adaptation::None),
            None => Swatch::of_light(Xyz::ZERO),
        };
        Some(SecondBehind {
            name: name.clone(),
            luminance: share,
            swatch,
        })
    }

    /// Numbers that each representation takes.
    pub fn numbers(&self) -> usize {
        self.narrow.numbers()
    }

    /// Whether there is any visible light.
    pub fn has_colour(&self) -> bool {
        let white = self.narrow.white();
        white.y > 0.0 && white.is_finite()
    }

    /// What a filter leaves.
    pub fn figures(&self, filter: &Filter) -> Figures {
        let ways = match filter {
            Filter::Gaussian {
                centre_nm,
                width_nm,
            } => {
                let point = self.narrow.behind(*centre_nm, *width_nm);
                [point.composite, point.series, point.samples]
            }
            Filter::Real(entry) => {
                let values = entry.on_band(self.band);
                self.narrow.through(|nm| self.band.interpolate(&values, nm))
            }
        };
        let share = ways[0].exact.y / self.narrow.white().y;
        Figures {
            luminance: Some(share).filter(|share| self.has_colour() && share.is_finite()),
            ways,
        }
    }

    /// The exact light and the three representations behind a filter, as bright as they are
    /// compared, or as a screen can show the exact one in its hue: exact first. And what they are
    /// brightened by.
    pub fn swatches(&self, figures: &Figures) -> ([Swatch; 4], f64) {
        let white = self.narrow.white();
        let exact = figures.ways[0].exact;
        let gain = self.narrow.gain(exact);
        // Of violet, red and blue cut at the same brightness would be fuchsia.
        let brightest = linear_from_xyz(exact * (gain / white.y));
        let gain = gain / brightest.into_iter().fold(1.0, f64::max);
        let scale = 100.0 / white.y;
        let light = white * scale;
        let seen = |xyz: Xyz| Swatch::of_patch(xyz * (gain * scale), light, Adaptation::None);
        let [a, b, c] = figures.ways.map(|way| seen(way.model));
        ([seen(exact), a, b, c], gain)
    }

    /// The band-pass at every place of the band.
    pub fn curve(&self, width_nm: f64) -> Vec<NarrowPoint> {
        let step = self.band.points().div_ceil(MOST_CENTRES);
        self.narrow.curve(width_nm, step)
    }

    /// The light, its model and the filter over them.
    pub fn light_chart(&self, app: &App, filter: &Filter) -> Chart {
        let (band, derived) = (self.band, &self.lit.derived);
        let curve = |values: &[f64]| on_grid(band, values, 1.0);
        let smooth = derived.model.smooth().on_band();
        let spikes = derived.model.lines();
        let looks = (said!("lines"), Ink::Spikes);
        let stems = spike_stems(looks, spikes, (band, &smooth, 1.0), |i| {
            derived.parts.stem_width_nm(i)
        });
        let highest = derived
            .measured
            .iter()
            .copied()
            .chain(stems.marks.points().iter().map(|top| top[1]))
            .filter(|v| v.is_finite())
            .fold(0.0, f64::max);
        let unit = if highest > 0.0 { highest } else { 1.0 };
        let through = on_grid(band, &filter.on_band(band), unit);
        let handles = filter.handles().into_iter();
        let handles = handles
            .filter(|[nm, _]| band.contains(*nm))
            .map(|[nm, share]| [nm, unit * share])
            .collect();
        let mut series = vec![
            Series::area(
                said!("filter, 1 at the top"),
                Ink::Residual,
                through.clone(),
                Vec::new(),
            ),
            thin("", Ink::Residual, through, Dash::Solid),
            Series::points("", Ink::Residual, Shape::Square, handles),
            thin(
                said!("measured"),
                Ink::Measured,
                curve(&derived.measured),
                Dash::Solid,
            ),
            thin(
                said!("smooth part"),
                Ink::Smooth,
                curve(&smooth),
                Dash::Dashed,
            ),
        ];
        if let Some((name, values, white)) = &self.second
            && let equal = self.narrow.white().y / white.y
            && equal.is_finite()
        {
            let name = tr!("{name}, equally bright before", name);
            let points = on_grid(band, values, equal);
            series.push(thin(&name, Ink::Second, points, Dash::Solid));
        }
        if !spikes.is_empty() {
            series.push(stems);
        }
        Chart {
            title: said!("The light and the filter over it").to_owned(),
            y_label: value_label(&app.document().light.spectrum.unit),
            series,
            colours: strip(band),
            strip: true,
            notes: self.notes(app),
            ..over(band)
        }
    }

    /// What the three are off by for every centre of the band-pass; `marked` is the present one.
    /// Without visible light there is nothing to be off by, and no range.
    pub fn error_chart(
        &self,
        app: &App,
        curve: &[NarrowPoint],
        luminance: bool,
        width_nm: f64,
        marked: Option<f64>,
    ) -> Chart {
        let error = |colours: &Colours| {
            if luminance {
                Some(100.0 * colours.luminance_error?)
            } else {
                Some(colours.delta_e_2000?.max(SMALLEST))
            }
        };
        let mut series = Vec::new();
        // The composite is drawn last, on top.
        for way in [2, 1, 0] {
            let (ink, dash) = looks(way);
            let points = curve
                .iter()
                .map(|point| [point.centre_nm, error(&of(point, way)).unwrap_or(f64::NAN)])
                .collect();
            series.push(thin(said(WAYS[way]), ink, points, dash));
        }
        let [low, high] = range(&series, luminance);
        if let Some(centre_nm) = marked {
            let foot_to_top = vec![[centre_nm, low], [centre_nm, high]];
            series.push(thin("", Ink::Residual, foot_to_top, Dash::Solid));
        }
        series.reverse();
        Chart {
            title: if luminance {
                tr!(
                    "Luminance error behind {width_nm} nm",
                    width_nm = fixed(width_nm, 1)
                )
            } else {
                tr!(
                    "Colour error behind {width_nm} nm",
                    width_nm = fixed(width_nm, 1)
                )
            },
            x_label: said!("Centre of the band-pass (nm)").to_owned(),
            y_label: if luminance {
                said!("luminance error (%)").to_owned()
            } else {
                "ΔE₀₀".to_owned()
            },
            y_range: self.has_colour().then_some([low, high]),
            y_scale: if luminance {
                Scale::Linear
            } else {
                Scale::Log10
            },
            series,
            notes: self.notes(app),
            ..over(self.band)
        }
    }

    fn notes(&self, app: &App) -> Vec<String> {
        let notes = vec![tr!(
            "Light: {light}. Three representations of {numbers} each; the filter is exact.",
            light = self.light,
            numbers = numbers(self.numbers())
        )];
        before_provenance(notes, app)
    }
}

/// Luminance errors beyond this many percent leave the picture: behind a filter where a light has
/// next to nothing, a share of it means little.
const LUMINANCE_SHOWN: f64 = 100.0;

/// Errors of colour below this are drawn at it: the axis is logarithmic.
const SMALLEST: f64 = 0.1;

/// What the vertical axis shows.
fn range(series: &[Series], luminance: bool) -> [f64; 2] {
    let points = series.iter().flat_map(|s| s.marks.points());
    let [low, high] = extent(points.map(|p| p[1])).unwrap_or([0.0; 2]);
    if !luminance {
        return [SMALLEST, (1.2 * high).max(10.0 * SMALLEST)];
    }
    [
        low.clamp(-LUMINANCE_SHOWN, -1.0),
        high.clamp(1.0, LUMINANCE_SHOWN),
    ]
}

/// One of the three, by its place in [`WAYS`].
pub fn of(point: &NarrowPoint, way: usize) -> Colours {
    [point.composite, point.series, point.samples][way]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_behind_a_violet_filter_is_shown_violet_and_no_fuchsia() {
        let app = crate::app::showing("cie_fluorescent_1nm/FL2");
        let behind = Behind::of(&app);
        let filter = Filter::Gaussian {
            centre_nm: 437.0,
            width_nm: 10.0,
        };
        let (swatches, gain) = behind.swatches(&behind.figures(&filter));
        let [red, green, blue] = swatches[0].rgb8.0;
        // Blue is full, and red less than half of it in light (186 of 255 encoded).
        assert!(
            blue >= 254 && green == 0 && red < 186,
            "{red} {green} {blue}"
        );
        assert!(gain > 1.0);
    }
}
