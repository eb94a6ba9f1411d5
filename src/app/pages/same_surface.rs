//! The page "Same surface?": is this spectrum the light off that surface?

mod ranked;

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::{Page, Place, Row, row, states::PageState};
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Panel, Series, stroke},
        charts::{
            products::chain::strip,
            spectrum::{before_provenance, on_grid, over},
        },
        derived::{Derived, less},
        document::Document,
        entry::Entry,
        memo::ByAddress,
        products::ModelledLight,
        recipe::{Recipe, Times},
        report::settings_json,
        state::App,
        ticks::short,
    },
    languages::fixed,
    spectrum::{Band, Composite},
    study::{
        Measure,
        products::{Checker, Compared, SAME_RESIDUAL, Sameness, measured_check},
    },
};

pub use ranked::{RESIDUAL_MEANS, RankAsk, Ranked, ranking};

pub(super) const ROW: Row = row(
    Page::SameSurface,
    Place::Through,
    (later!("Same surface?"), "same-surface"),
    "filters",
    later!(
        "Is a spectrum the light off a surface? The first spectrum times the surface must be the \
         second."
    ),
)
.once(&["check"]);

/// What the check remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SameSurfaceMemory {
    /// The best surface is looked for among all shipped reflectances, not the patches alone.
    pub everywhere: bool,
    /// The example's light meets its surface twice.
    pub twice: bool,
}

impl Default for SameSurfaceMemory {
    fn default() -> Self {
        Self {
            everywhere: true,
            twice: false,
        }
    }
}

impl PageState for SameSurfaceMemory {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("everywhere", later!("where surfaces are looked for")),
        (
            "twice",
            later!("how often the example's light meets its surface"),
        ),
    ];
}

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

    /// Whether the spectrum can be the light off the surface, in a sentence.
    pub fn headline(&self) -> String {
        let [light, surface, outgoing] = &self.names;
        match self.verdict() {
            Sameness::Holds => match *outgoing == format!("{light} off {surface}") {
                true => tr!(
                    "Yes: {light} off {surface} gives this spectrum.",
                    light,
                    surface
                ),
                false => tr!(
                    "Yes: {outgoing} can be {light} off {surface}.",
                    outgoing,
                    light,
                    surface
                ),
            },
            Sameness::DoesNotHold => tr!(
                "No: {outgoing} is not {light} off {surface}.",
                outgoing,
                light,
                surface
            ),
            Sameness::Unknown if self.model.is_none() => {
                said!("One of the spectra is dark on this range.").to_owned()
            }
            Sameness::Unknown => tr!(
                "The models are too short to tell: behind 10 nm they leave out {first} % of S1 and \
                 {last} % of S3 themselves. More numbers may decide.",
                first = fixed(100.0 * self.left_out[0], 1),
                last = fixed(100.0 * self.left_out[1], 1)
            ),
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

/// The check as a sum is written: the light, times the surface, is the spectrum that was found,
/// with what was expected of it.
pub fn as_product(app: &App, sheet: &SameSurfaceSheet) -> [Chart; 3] {
    let band = sheet.band;
    let [light, surface, outgoing] = &sheet.names;
    let filled = |title: String, values: &[f64]| {
        let points = on_grid(band, values, 1.0);
        let area = Series::area("", Ink::Measured, points.clone(), Vec::new());
        // At the ends of the visible range the fill is hardly seen.
        let edge = stroke("", Ink::Faint, points, 1.0, Dash::Solid);
        Chart {
            title,
            series: vec![area.coloured(), edge],
            colours: strip(band),
            ..over(band)
        }
    };
    let document = app.document();
    let factor = document.products.surface.as_ref();
    let reflected = factor.map_or(Vec::new(), |entry| entry.on_band(band));
    let compared = sheet.measured.as_ref();
    let found = compared.map_or(&[][..], |compared| &compared.found);
    let mut last = filled(tr!("The spectrum: {outgoing}", outgoing), found);
    if let Some(compared) = compared {
        let expected = on_grid(band, &compared.expected, 1.0);
        let line = Series::line(said!("the product"), Ink::Spikes, expected);
        last.series.push(line.dashed(Dash::Dashed));
    }
    last.y_label = said!("Behind a slit of 10 nm, scaled").to_owned();
    let lit = ModelledLight::of(app);
    [
        Chart {
            y_label: said!("Relative power").to_owned(),
            ..filled(tr!("The light: {light}", light), &lit.derived.measured)
        },
        Chart {
            y_label: said!("Reflectance").to_owned(),
            y_range: Some([0.0, 1.0]),
            ..filled(tr!("The surface: {surface}", surface), &reflected)
        },
        last,
    ]
}

/// One of the two checks; `what` says whose numbers were compared.
pub fn same_surface_chart(
    app: &App,
    sheet: &SameSurfaceSheet,
    compared: &Compared,
    what: &str,
) -> Chart {
    let curve = |values: &[f64]| on_grid(sheet.band, values, 1.0);
    let Compared {
        reflection,
        expected,
        found,
    } = compared;
    let rest = less(found, expected);
    let [light, surface, outgoing] = &sheet.names;
    let told = tr!(
        "S1 {light}, S2 {surface}, S3 {outgoing}. Expected is S1 S2 times {factor}; residual \
         {residual}.",
        light,
        surface,
        outgoing,
        factor = fixed(reflection.factor, 4),
        residual = fixed(reflection.residual, 4)
    );
    Chart {
        title: what.to_owned(),
        y_label: said!("share of the largest value, behind 10 nm").to_owned(),
        series: vec![
            Series::line(said!("found: S3"), Ink::Measured, curve(found)),
            Series::line(said!("expected: S1 S2"), Ink::Spikes, curve(expected))
                .dashed(Dash::Dashed),
        ],
        residual: Some(Panel {
            y_label: said!("found - expected").to_owned(),
            series: vec![Series::line(
                said!("difference"),
                Ink::Residual,
                curve(&rest),
            )],
            ..Panel::default()
        }),
        notes: before_provenance(vec![told], app),
        ..over(sheet.band)
    }
}
