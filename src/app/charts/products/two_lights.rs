//! Metamers as charts: two reflectances that are one colour under a light.

use std::sync::Arc;

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Series},
        charts::spectrum::{before_provenance, on_grid, over},
        lit::swatches,
        products::two_lights::{Made, NoMetamer, TwoLightsSheet},
        state::App,
        studies::{Pairs, PairsAsk, Surface},
        ticks::short,
    },
    color::{Adaptation, Swatch},
    spectrum::Band,
};

/// A metamer that was made, with its colours and its chart.
pub struct MadeShown {
    /// The metamer.
    pub made: Made,
    /// It and its patch.
    pub chart: Chart,
    /// Patch, then metamer, under both lights.
    pub swatches: Vec<[Swatch; 2]>,
}

impl MadeShown {
    /// Made for a patch with a part of the room, percent.
    ///
    /// # Errors
    /// When there is no such patch or no room.
    pub fn of(
        app: &App,
        sheet: &TwoLightsSheet,
        (patch, room_percent): (usize, i32),
        adaptation: Adaptation,
    ) -> Result<Self, NoMetamer> {
        let made = Made::of(sheet, patch, room_percent)?;
        Ok(Self {
            chart: made_chart(app, sheet, &made),
            swatches: swatches(&made.both, adaptation),
            made,
        })
    }
}

/// Pairs that were found, with their colours and the chart of one.
pub struct Found {
    /// The pairs and what they were found among.
    pub pairs: Arc<Pairs>,
    /// Names of the lights that they were found under.
    pub lights: [String; 2],
    /// The pair that is drawn.
    pub chosen: usize,
    /// Each surface under both lights.
    pub swatches: Vec<[Swatch; 2]>,
    /// The chosen pair; none where nothing was found.
    pub chart: Option<Chart>,
}

impl Found {
    /// The pairs that answer a question.
    pub fn of(
        app: &App,
        ask: &PairsAsk,
        pairs: &Arc<Pairs>,
        chosen: usize,
        adaptation: Adaptation,
    ) -> Self {
        let pair = pairs.metamers.pairs.get(chosen);
        Self {
            chosen,
            swatches: swatches(&pairs.both, adaptation),
            lights: [0, 1].map(|i| ask.lights[i].0.name().to_owned()),
            chart: pair.map(|pair| {
                let pair = pair.pair.map(|i| &pairs.surfaces[i]);
                pair_chart(app, ask.band, pair)
            }),
            pairs: pairs.clone(),
        }
    }
}

/// The two reflectances of a pair that was found.
fn pair_chart(app: &App, band: Band, pair: [&Surface; 2]) -> Chart {
    let names = pair.map(Surface::words);
    let curves = [0, 1].map(|i| (&names[i][..], &pair[i].values[..]));
    two_curves(app, said!("The chosen pair"), band, curves)
}

/// A patch and the metamer made for it.
pub fn made_chart(app: &App, sheet: &TwoLightsSheet, made: &Made) -> Chart {
    let patch = (&sheet.names[made.patch][..], &made.original[..]);
    let curves = [patch, (said!("made"), &made.values[..])];
    Chart {
        y_range: Some([0.0, 1.0]),
        ..two_curves(app, said!("A surface and its metamer"), sheet.band, curves)
    }
}

/// Two reflectances with their names.
fn two_curves(
    app: &App,
    title: &str,
    band: Band,
    [(first, values), (second, others)]: [(&str, &[f64]); 2],
) -> Chart {
    let series = vec![
        Series::line(first, Ink::Smooth, on_grid(band, values, 1.0)),
        Series::line(second, Ink::Spikes, on_grid(band, others, 1.0)).dashed(Dash::Dashed),
    ];
    Chart {
        title: title.to_owned(),
        y_label: said!("Reflectance").to_owned(),
        ..over_wavelength(app, band, series)
    }
}

fn over_wavelength(app: &App, band: Band, series: Vec<Series>) -> Chart {
    let document = app.document();
    let notes = vec![
        tr!("Light: {light}", light = document.light.name()),
        tr!(
            "Second light: {light}",
            light = document.light_beside().name()
        ),
        tr!(
            "Range {from}-{to} nm.",
            from = short(band.min_nm()),
            to = short(band.max_nm())
        ),
    ];
    Chart {
        series,
        notes: before_provenance(notes, app),
        ..over(band)
    }
}
