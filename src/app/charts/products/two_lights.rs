//! Two lights as charts: their spectra, and pairs of reflectances.

use std::sync::Arc;

use super::{curve, over};
use crate::{
    app::{
        chart::{Chart, Dash, Inks, Series, Theme},
        charts::spectrum::provenance,
        products::two_lights::{Made, NoMetamer, TwoLightsSheet, swatches},
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
        theme: Theme,
    ) -> Result<Self, NoMetamer> {
        let made = Made::of(sheet, patch, room_percent)?;
        Ok(Self {
            chart: made_chart(app, sheet, &made, theme),
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
        (adaptation, theme): (Adaptation, Theme),
    ) -> Self {
        let pair = pairs.metamers.pairs.get(chosen);
        Self {
            chosen,
            swatches: swatches(&pairs.both, adaptation),
            lights: [0, 1].map(|i| ask.lights[i].0.name().to_owned()),
            chart: pair.map(|pair| {
                let pair = pair.pair.map(|i| &pairs.surfaces[i]);
                pair_chart(app, ask.band, pair, theme)
            }),
            pairs: pairs.clone(),
        }
    }
}

/// Both lights, each scaled to Y = 100; what is not seen is left out.
pub fn two_lights_chart(app: &App, sheet: &TwoLightsSheet, theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let [first, second] = sheet.scaled();
    let mut series = Vec::new();
    if let Some(values) = first {
        let points = curve(sheet.band, &values, 1.0);
        series.push(Series::line(&sheet.lights[0], inks.measured, points));
    }
    if let Some(values) = second {
        let points = curve(sheet.band, &values, 1.0);
        let line = Series::line(&sheet.lights[1], inks.spikes, points);
        series.push(line.dashed(Dash::Dashed));
    }
    Chart {
        title: "The two lights".to_owned(),
        y_label: "value, scaled to Y = 100".to_owned(),
        ..over_wavelength(app, sheet.band, series, theme)
    }
}

/// The two reflectances of a pair that was found.
fn pair_chart(app: &App, band: Band, pair: [&Surface; 2], theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let line = |i: usize, ink| Series::line(&pair[i].key, ink, curve(band, &pair[i].values, 1.0));
    let series = vec![
        line(0, inks.smooth),
        line(1, inks.spikes).dashed(Dash::Dashed),
    ];
    Chart {
        title: "The chosen pair".to_owned(),
        y_label: "share of light".to_owned(),
        ..over_wavelength(app, band, series, theme)
    }
}

/// A patch and the metamer made for it.
pub fn made_chart(app: &App, sheet: &TwoLightsSheet, made: &Made, theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let series = vec![
        Series::line(
            &sheet.names[made.patch],
            inks.smooth,
            curve(sheet.band, &made.original, 1.0),
        ),
        Series::line("made", inks.spikes, curve(sheet.band, &made.values, 1.0))
            .dashed(Dash::Dashed),
    ];
    Chart {
        title: "A patch and its metamer".to_owned(),
        y_label: "share of light".to_owned(),
        y_range: Some([0.0, 1.0]),
        ..over_wavelength(app, sheet.band, series, theme)
    }
}

fn over_wavelength(app: &App, band: Band, series: Vec<Series>, theme: Theme) -> Chart {
    let document = app.document();
    let mut notes = vec![format!("Light: {}", document.light.name())];
    if let Some(other) = &document.products.other_light {
        notes.push(format!("Second light: {}", other.name()));
    }
    notes.push(format!(
        "Range {}-{} nm.",
        short(band.min_nm()),
        short(band.max_nm())
    ));
    notes.extend(provenance(app));
    Chart {
        series,
        notes,
        ..over(band, theme)
    }
}
