//! One product formed in every way: curves, what each is off by, and the figures as tables.

use crate::{
    app::{
        App, Entry,
        cells::{Columns, Table, cell, column},
        chart::{Chart, Dash, Ink, Panel, Series, Shape, stroke},
        charts::spectrum::{before_provenance, on_grid, over, spike_stems, table_head},
        derived::less,
        numbers::{decimals, delta_e, hundredths, nanoseconds, or_dash},
        products::ModelledLight,
        ticks::extent,
    },
    languages::{fixed, said},
    spectrum::{Band, Line, Sampling},
    study::{
        products::{Formed, ProductTime, Resampled, Sizes, SpikeCosts, resampled, spike_costs},
        truth::SpikeReading,
    },
};

/// A way of forming products, in a word or two.
pub fn way_name(sampling: Sampling) -> &'static str {
    match sampling {
        Sampling::Paper => said!("paper's points"),
        Sampling::ThreeN => said!("3N+1 points"),
        Sampling::FourN => said!("4N+1 points"),
        Sampling::Double => said!("twice the numbers"),
        Sampling::Convolution => said!("cut convolution"),
        Sampling::Exact => said!("1 nm, as measured"),
    }
}

/// What a way does, a sentence.
pub fn way_meaning(sampling: Sampling) -> &'static str {
    match sampling {
        Sampling::Paper => {
            said!(
                "As many points as there are numbers (2N+1), as in the paper: waves above N fold \
                 back."
            )
        }
        Sampling::ThreeN => {
            said!(
                "3N+1 points, or the next odd count: in the Fourier basis waves up to N are exact."
            )
        }
        Sampling::FourN => {
            said!("4N+1 points: in the Fourier basis every wave of one product is exact.")
        }
        Sampling::Double => {
            said!("Twice as many points as there are numbers, the default for chains.")
        }
        Sampling::Convolution => {
            said!(
                "Coefficients convolved and cut back to as many as there were: nothing folds, and \
                 all above is lost."
            )
        }
        Sampling::Exact => {
            said!(
                "No resampling: the model of the light times the filter or surface as measured, \
                 at every nm."
            )
        }
    }
}

/// How a way is drawn: ink, dash and form.
pub fn way_looks(sampling: Sampling) -> (Ink, Dash, Shape) {
    match sampling {
        Sampling::Paper => (Ink::Spikes, Dash::Solid, Shape::Dot),
        Sampling::ThreeN => (Ink::Smooth, Dash::Dashed, Shape::Square),
        Sampling::FourN => (Ink::Residual, Dash::Dotted, Shape::Triangle),
        Sampling::Double => (Ink::Product, Dash::Dashed, Shape::Ring),
        Sampling::Convolution => (Ink::Overlay(2), Dash::Solid, Shape::Diamond),
        Sampling::Exact => (Ink::Measured, Dash::Dotted, Shape::Cross),
    }
}

/// The document's light times its surface, formed in every way.
#[derive(Clone, Debug)]
pub struct Bench {
    /// The light's name.
    pub light: String,
    /// The factor's name.
    pub factor: String,
    /// The grid.
    pub band: Band,
    /// What came out.
    pub resampled: Resampled,
    /// Eq. 17 at the light's spikes.
    pub spikes: SpikeCosts,
    /// What the time of a product depends on.
    pub sizes: Sizes,
    /// The width that each spike behind the factor is drawn with, nm.
    widths_nm: Vec<f64>,
}

impl Bench {
    /// Forms the product of the document's light and a factor.
    pub fn of(app: &App, factor: &Entry) -> Self {
        let lit = ModelledLight::of(app);
        let (band, product) = (lit.band(), lit.product());
        let own = lit.factor(factor.on_band(band));
        let table = &lit.tables.basis;
        let smooth = product.model.smooth();
        let resampled = resampled(product, &own, table);
        // What a factor adds may stand before the light's own lines.
        let spikes = resampled.ways.first().map(|way| &way.step.spikes[..]);
        let width_nm = |spike: &Line| lit.derived.stem_width_at(spike.at_nm);
        let widths_nm = spikes.unwrap_or_default().iter().map(width_nm).collect();
        Self {
            light: app.document().light.name().to_owned(),
            factor: factor.name().to_owned(),
            band,
            resampled,
            spikes: spike_costs(product, &own, table),
            sizes: Sizes {
                band,
                basis: smooth.basis,
                numbers: smooth.coefficients.len(),
                spikes: product.model.lines().len(),
            },
            widths_nm,
        }
    }

    /// Whether there is any colour to be off by.
    pub fn has_colour(&self) -> bool {
        let mut ways = self.resampled.ways.iter();
        ways.any(|way| way.step.added.is_some())
    }

    /// The exact product and the ways that are drawn, and below what each is off by against the
    /// exact product of the same two series.
    pub fn chart(&self, app: &App, hidden: &[Sampling]) -> Chart {
        let curve = |values: &[f64]| on_grid(self.band, values, 1.0);
        let mut series = vec![Series::line(
            said!("measured × measured"),
            Ink::Measured,
            curve(&self.resampled.exact),
        )];
        let mut off = Vec::new();
        for way in self.drawn(hidden) {
            let (ink, dash, _) = way_looks(way.sampling);
            let name = way_name(way.sampling);
            series.push(thin(name, ink, curve(&way.step.smooth), dash));
            let differences = less(&way.step.smooth, &self.resampled.series_product);
            off.push(thin(name, ink, curve(&differences), dash));
        }
        series.extend(self.stems());
        let y_range = without_tall_lines(&series);
        let notes = vec![
            tr!(
                "Light: {light}. Filter or surface: {factor}.",
                light = self.light,
                factor = self.factor
            ),
            said!("Below: way minus the product of the same two series with every wave kept.")
                .to_owned(),
        ];
        Chart {
            title: said!("The product by every way").to_owned(),
            y_label: if y_range.is_some() {
                said!("light × surface (measured lines leave the picture)").to_owned()
            } else {
                said!("light × surface").to_owned()
            },
            y_range,
            series,
            residual: (!off.is_empty()).then(|| Panel {
                y_label: said!("what folds or is cut").to_owned(),
                y_range: None,
                series: off,
            }),
            notes: before_provenance(notes, app),
            ..over(self.band)
        }
    }

    /// The ways with curves of their own: at 1 nm nothing is formed from series.
    fn drawn<'a>(&'a self, hidden: &'a [Sampling]) -> impl Iterator<Item = &'a Formed> {
        let ways = self.resampled.ways.iter();
        ways.filter(|way| way.sampling != Sampling::Exact && !hidden.contains(&way.sampling))
    }

    /// The light's spikes behind the factor, the same in all ways with points.
    fn stems(&self) -> Option<Series> {
        let way = self.resampled.ways.first()?;
        let spikes = &way.step.spikes;
        if spikes.is_empty() {
            return None;
        }
        let smooth = (self.band, &self.resampled.series_product[..], 1.0);
        let looks = (said!("lines × surface"), Ink::Overlay(1));
        Some(spike_stems(looks, spikes, smooth, |i| self.widths_nm[i]))
    }

    /// The figures as a table; times where they were measured.
    pub fn table(&self, app: &App, times: Option<&[ProductTime]>) -> Table {
        let time = |way: &Formed| time_of(times, way.sampling).map(|time| time.ns);
        let columns = Columns::<&Formed>::default()
            .with("way", |way| cell(way_name(way.sampling)))
            .titled(
                said!("way"),
                said!("Way of forming the product. Click a row to form all products so."),
            )
            .with("points", |way| cell(way.points))
            .figures(
                said!("points"),
                said!("Independent points, one multiplication each."),
            )
            .with("delta_e_2000_total", |way| {
                let total = way.step.colours.delta_e_2000;
                cell(total).shown(delta_e(total))
            })
            .figures(
                said!("ΔE₀₀ total"),
                said!(
                    "CIEDE2000 of the model's product against measured light times measured \
                     surface; the white is the light."
                ),
            )
            .with("delta_e_2000_added", |way| {
                cell(way.step.added).shown(added_words(way.step.added))
            })
            .figures(
                said!("added"),
                said!(
                    "CIEDE2000 against the exact product of the very same series: the part that \
                     forming it adds."
                ),
            )
            .with("folded_share", |way| {
                cell(way.step.folded_share).shown(share_words(way.step.folded_share))
            })
            .figures(
                said!("folded"),
                said!(
                    "Alias meter: share of the product's power in waves that the points fold \
                     back, or that the convolution cuts off. The bar is logarithmic, from 0.0001 \
                     % to 100 %."
                ),
            )
            .with("multiplications", |way| cell(way.step.multiplications))
            .figures(
                said!("mult."),
                said!(
                    "Multiplications of one product: one a point, or one a pair of numbers, and \
                     one a line."
                ),
            )
            .with("ns", |way| {
                cell(time(way)).shown(or_dash(time(way), nanoseconds))
            })
            .figures(
                "ns",
                said!("Nanoseconds of one product, measured here and now: the median batch."),
            );
        Table::new(self.head(app), columns, &self.resampled.ways)
    }

    /// Eq. 17 as a table.
    pub fn spikes_table(&self, app: &App) -> Table {
        type Row<'a> = &'a (SpikeReading, [Option<f64>; 3]);
        let read = |key: &'static str, of: fn(&SpikeReading) -> f64| {
            column(key, move |(reading, _): &Row<'_>| {
                cell(of(reading)).shown(decimals(of(reading), 4))
            })
        };
        let cost = |way: usize, name: &'static str| {
            column(
                format!("{name}_delta_e_2000"),
                move |(_, costs): &Row<'_>| cell(costs[way]).shown(delta_e(costs[way])),
            )
            .figures(format!("{} ΔE₀₀", said(name)), said(EQ_17_COST))
        };
        let columns = Columns::<Row<'_>>::default()
            .with("at_nm", |(reading, _): &Row<'_>| {
                cell(reading.spike.at_nm).shown(fixed(reading.spike.at_nm, 1))
            })
            .figures(said!("at nm"), said!("The line's wavelength, nm."))
            .and(read("weight", |reading| reading.spike.weight))
            .and(read("measured", |reading| reading.measured))
            .figures(said!("measured"), said!("The surface as measured there."))
            .and(read("series", |reading| reading.series))
            .figures(
                said!("series"),
                said!("The surface's series evaluated exactly at the line, as this program does."),
            )
            .and(read("corrected", |reading| reading.linear))
            .figures(
                said!("corrected"),
                said!(
                    "Eq. 17 with its two weights exchanged: the straight line between two of the \
                     paper's points."
                ),
            )
            .and(read("printed", |reading| reading.printed))
            .figures(
                said!("as printed"),
                said!("Eq. 17 with its weights as printed."),
            )
            .and(cost(0, later!("series")))
            .and(cost(1, later!("corrected")))
            .and(cost(2, later!("printed")));
        Table::new(self.head(app), columns, &self.spikes.each)
    }

    fn head(&self, app: &App) -> String {
        let head = format!("# light: {}\n# factor: {}\n", self.light, self.factor);
        table_head(head, app)
    }
}

/// The cost of a reading of Eq. 17.
pub const EQ_17_COST: &str = later!(
    "CIEDE2000 against the same product with this line weighed by the surface as measured there."
);

/// What forming a product adds; an exact zero is told as such.
fn added_words(added: Option<f64>) -> String {
    match added {
        Some(0.0) => "0".to_owned(),
        added => delta_e(added),
    }
}

/// Shares below this are rounding, or nothing to speak of.
pub const LEAST_SHARE: f64 = 1e-6;

fn share_words(share: f64) -> String {
    or_dash(share, |share| match share {
        share if share <= 0.0 => "0 %".to_owned(),
        share => format!("{} %", hundredths(100.0 * share)),
    })
}

/// Lines of the measured curve this many times as high as all else are cut off: the ways would
/// lie flat on the axis.
const TALL: f64 = 1.5;

/// The range of everything but the measured curve, which comes first, where that is far higher.
fn without_tall_lines(series: &[Series]) -> Option<[f64; 2]> {
    let range = |series: &[Series]| {
        let points = series.iter().flat_map(|s| s.marks.points());
        extent(points.map(|point| point[1]))
    };
    let (measured, rest) = (range(&series[..1])?, range(&series[1..])?);
    (rest[1] > 0.0 && measured[1] > TALL * rest[1])
        .then(|| [rest[0].min(measured[0]).min(0.0), 1.15 * rest[1]])
}

/// The measured time of a way.
pub fn time_of(times: Option<&[ProductTime]>, sampling: Sampling) -> Option<&ProductTime> {
    times?.iter().find(|time| time.sampling == sampling)
}

/// A line of a thickness that leaves room for others.
pub fn thin(name: &str, ink: Ink, points: Vec<[f64; 2]>, dash: Dash) -> Series {
    stroke(name, ink, points, 1.5, dash)
}
