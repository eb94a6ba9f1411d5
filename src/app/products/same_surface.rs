//! The part `Same surface?` as figures: is this spectrum the light off that surface?

use std::sync::Arc;

use serde_json::{Value, json};

use super::ModelledLight;
use crate::{
    app::{
        cells::{Columns, Table, cell, column},
        derived::Derived,
        document::Document,
        entry::Entry,
        memo::ByAddress,
        numbers::four_digits,
        recipe::{Recipe, Times},
        report::settings_json,
        state::App,
        studies::{RankAsk, Ranked},
        ticks::short,
    },
    spectrum::{Band, Composite},
    study::{
        Measure,
        products::{Checker, Compared, SAME_RESIDUAL, Sameness, measured_check},
    },
};

/// A light, a surface and an outgoing spectrum compared.
#[derive(Clone, Debug)]
pub struct SameSurfaceSheet {
    /// The grid.
    pub band: Band,
    /// Names of light, surface and outgoing spectrum.
    pub names: [String; 3],
    /// Light and outgoing spectrum in the model's numbers.
    pub models: Arc<[Composite; 2]>,
    /// Numbers of the two models.
    pub numbers: [usize; 2],
    /// What the two models leave out themselves: relative RMS behind a 10 nm blur.
    pub left_out: [f64; 2],
    /// The check in the model's numbers; `None` when one of the spectra is dark.
    pub model: Option<Compared>,
    /// The check on measured curves.
    pub measured: Option<Compared>,
}

impl SameSurfaceSheet {
    /// The check of a state; `None` without a surface or an outgoing spectrum.
    pub fn of(app: &App) -> Option<Self> {
        let document = app.document();
        let surface = document.products.surface.as_ref()?;
        let outgoing = document.products.outgoing.as_ref()?;
        let mut sheet = Self::against(app, &surface.on_band(document.settings.band), outgoing);
        sheet.names[1] = surface.name().to_owned();
        Some(sheet)
    }

    /// The check of the state's light off any surface (on the band's grid).
    pub fn against(app: &App, surface: &[f64], outgoing: &Arc<Entry>) -> Self {
        let lit = ModelledLight::of(app);
        let band = lit.band();
        let found = lit.another(app, outgoing);
        let light = &lit.derived;
        let models = [&light.model, &found.model].map(Composite::idealised);
        let left_out = |of: &Derived| of.figures[Measure::RmsBlurred].unwrap_or(0.0);
        let light_name = app.document().light.name().to_owned();
        Self {
            band,
            names: [light_name, String::new(), outgoing.name().to_owned()],
            model: Checker::new(&models[0], &models[1]).against(surface),
            measured: measured_check(band, &light.measured, surface, &found.measured),
            numbers: models.each_ref().map(Composite::numbers),
            left_out: [left_out(light), left_out(&found)],
            models: Arc::new(models),
        }
    }

    /// The verdict in the model's numbers.
    pub fn verdict(&self) -> Sameness {
        Sameness::of(
            self.model.as_ref().map(|c| c.reflection),
            self.left_out.iter().sum(),
        )
    }

    /// The verdict on measured curves.
    pub fn measured_verdict(&self) -> Sameness {
        Sameness::of(self.measured.as_ref().map(|c| c.reflection), 0.0)
    }

    /// What a search for the best surface would ask.
    pub fn ranking(&self, document: &Document, everywhere: bool) -> Option<RankAsk> {
        let outgoing = document.products.outgoing.clone()?;
        Some(RankAsk {
            measured: [ByAddress(document.light.clone()), ByAddress(outgoing)],
            models: self.models.clone(),
            left_out: self.left_out.iter().sum(),
            band: self.band,
            observer: document.settings.observer,
            group: (!everywhere).then(|| document.patch_set.clone()),
        })
    }
}

/// The check as JSON; the keys are stable, a number that does not exist is `null`.
pub fn check_json(app: &App, factors: &[String], sheet: &SameSurfaceSheet) -> Value {
    let of = |compared: &Option<Compared>, verdict: Sameness| {
        let found = compared.as_ref().map(|c| c.reflection);
        json!({
            "residual": found.map(|f| f.residual),
            "threshold": SAME_RESIDUAL,
            "verdict": verdict.words(),
            "factor": found.map(|f| f.factor),
        })
    };
    let mut value = of(&sheet.model, sheet.verdict());
    let measured = of(&sheet.measured, sheet.measured_verdict());
    if let Value::Object(all) = &mut value {
        let light = &app.document().light.spectrum;
        all.insert("left_out".to_owned(), json!(sheet.left_out));
        all.insert("measured".to_owned(), measured);
        all.insert(
            "light".to_owned(),
            json!({ "name": light.name, "source": light.source }),
        );
        all.insert("factors".to_owned(), json!(factors));
        all.insert("outgoing".to_owned(), json!({ "name": sheet.names[2] }));
        all.insert("numbers".to_owned(), json!(sheet.numbers));
        all.insert("settings".to_owned(), settings_json(app));
    }
    value
}

/// The check for people.
pub fn check_text(sheet: &SameSurfaceSheet) -> String {
    let [light, surface, outgoing] = &sheet.names;
    let line = |what: &str, compared: &Option<Compared>, verdict: Sameness| {
        let found = compared.as_ref().map(|c| c.reflection);
        let figure =
            |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| format!("{v:.4}"));
        format!(
            "{what:<9} {}: residual {} (holds up to {}), factor {}\n",
            verdict.words(),
            figure(found.map(|f| f.residual)),
            short(SAME_RESIDUAL),
            figure(found.map(|f| f.factor)),
        )
    };
    format!(
        "Check     is {outgoing} = {light} x {surface}?\n{}{}",
        line("Model", &sheet.model, sheet.verdict()),
        line("Measured", &sheet.measured, sheet.measured_verdict())
    )
}

/// The ranking as a table.
pub fn ranking(names: &[String; 3], ranked: &[Ranked]) -> Table {
    type Row<'a> = &'a Ranked;
    let found = |key: &'static str, of: fn(&Ranked) -> Option<f64>| {
        column(key, move |r: &Row<'_>| {
            cell(of(r)).shown(four_digits(of(r)))
        })
    };
    let columns = Columns::<Row<'_>>::default()
        .with("surface", |r: &Row<'_>| {
            cell(r.key.as_str()).shown(r.name.as_str())
        })
        .titled("surface", "Click a row to take it as the surface S2.")
        .and(found("residual model", |r| Some(r.model?.residual)))
        .titled(
            "residual",
            format!("In the model's numbers. {RESIDUAL_MEANS}"),
        )
        .and(found("factor model", |r| Some(r.model?.factor)))
        .with("verdict", |r| cell(r.verdict.words()))
        .and(found("residual measured", |r| Some(r.measured?.residual)))
        .titled(
            "measured",
            format!("Of the measured curves. {RESIDUAL_MEANS}"),
        )
        .and(found("factor measured", |r| Some(r.measured?.factor)))
        .with("", |r| {
            cell(format!("{} {}", r.verdict.sign(), r.verdict.words()))
        })
        .titled("verdict", "The model's verdict.");
    let comments = format!("# {} as {} off each surface\n", names[2], names[0]);
    Table::new(comments, columns, ranked)
}

/// The meaning of a residual.
pub const RESIDUAL_MEANS: &str = "Root mean square of what the best factor leaves, over that of \
                                  the outgoing spectrum, both behind a 10 nm blur; 0 is a perfect \
                                  match.";

/// The state's light off a surface, once or twice.
pub fn example(app: &App, surface: &Entry, twice: bool) -> Recipe {
    let times = Times {
        bounces: if twice { 2 } else { 1 },
        ..Times::default()
    };
    Recipe::Through {
        light: app.document().light.key.clone(),
        chain: vec![(surface.key.clone(), times)],
    }
}
