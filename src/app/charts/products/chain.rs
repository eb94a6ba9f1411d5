//! A light through its chain as the part "Chain" shows it: every stage, its words and its chart.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Series, stroke},
        charts::{
            spectrum::{before_provenance, on_grid, over, spike_stems},
            units::value_label,
        },
        product_report::{Told, second_passage},
        products::ModelledLight,
        state::App,
        ticks::short,
    },
    languages::fixed,
    spectrum::{Band, Line},
    study::products::{Colours, Passage},
};

/// A place of the chain: the light before it, or behind a factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The light that comes in.
    Light,
    /// Behind a factor, 0 the first.
    Stage(usize),
}

impl Place {
    /// 0 for the light, then the stages from 1 on.
    pub fn index(self) -> usize {
        match self {
            Self::Light => 0,
            Self::Stage(index) => index + 1,
        }
    }
}

/// A chain that the light of the state went through.
pub struct ChainSheet {
    /// The light and its model.
    pub light: ModelledLight,
    /// Every stage, with the names of factors and lines.
    pub told: Told,
    /// What must be said about each stage, a sentence each.
    pub notes: Vec<Vec<String>>,
    /// The second light behind every stage.
    pub second: Option<Passage>,
}

impl ChainSheet {
    /// The chain of a state.
    pub fn of(app: &App) -> Self {
        let light = ModelledLight::of(app);
        let chain = &app.document().products.chain;
        let told = Told::of(app, &light, chain);
        Self {
            second: second_passage(app, &light, chain),
            notes: told.stage_notes(&light),
            light,
            told,
        }
    }

    /// How many factors there are.
    pub fn stages(&self) -> usize {
        self.told.passage.steps.len()
    }

    /// The second light's colours at a place, with its passage.
    pub fn second_at(&self, place: Place) -> Option<(&Passage, Colours)> {
        let passage = self.second.as_ref()?;
        let colours = match place {
            Place::Light => passage.light,
            Place::Stage(index) => passage.steps.get(index)?.colours,
        };
        Some((passage, colours))
    }

    /// The second light's curve at a place, the lights brought to one luminance before the chain.
    fn second_curve(&self, app: &App, place: Place) -> Option<Series> {
        let entry = app.document().second.as_ref()?;
        let passage = self.second.as_ref()?;
        let equal = Some(self.told.passage.white.y / passage.white.y);
        let equal = equal.filter(|ratio| ratio.is_finite())?;
        let band = self.light.band();
        let values = match place {
            Place::Light => &entry.on_band(band),
            Place::Stage(index) => &passage.steps.get(index)?.exact,
        };
        let name = tr!("{light}, equally bright before", light = entry.name());
        let points = on_grid(band, values, equal * self.factor(app));
        Some(stroke(&name, Ink::Second, points, 2.4, Dash::Solid))
    }

    fn factor(&self, app: &App) -> f64 {
        let document = app.document();
        let factor = document.scale.factor(&document.light.spectrum);
        factor.unwrap_or(1.0)
    }

    /// The model's spikes at a place.
    pub fn spikes(&self, place: Place) -> &[Line] {
        match place {
            Place::Light => self.light.derived.model.lines(),
            Place::Stage(index) => &self.told.passage.steps[index].spikes,
        }
    }

    /// The light at a place: exact curve, smooth part, spikes as stems.
    pub fn chart(&self, app: &App, place: Place) -> Chart {
        let document = app.document();
        let light = &document.light;
        let (steps, derived) = (&self.told.passage.steps, &self.light.derived);
        let (title, exact, smooth) = match place {
            Place::Light => (
                tr!("The light: {light}", light = light.name()),
                &derived.measured,
                &derived.smooth,
            ),
            Place::Stage(index) => (
                tr!(
                    "Behind step {number}: {name}",
                    number = index + 1,
                    name = self.told.names[index]
                ),
                &steps[index].exact,
                &steps[index].smooth,
            ),
        };
        let mut notes = vec![tr!("Light: {light}", light = light.name())];
        let names = self.told.names.iter().enumerate();
        notes.extend(names.map(|(i, name)| format!("{}. {name}", i + 1)));
        let band = derived.band;
        let factor = self.factor(app);
        let curve = |values: &[f64]| on_grid(band, values, factor);
        let mut series = vec![
            Series::line(said!("exact"), Ink::Measured, curve(exact)),
            Series::line(said!("smooth part"), Ink::Smooth, curve(smooth)),
        ];
        series.extend(self.second_curve(app, place));
        let (up, down): (Vec<Line>, Vec<Line>) =
            self.spikes(place).iter().partition(|s| s.weight >= 0.0);
        for (name, ink, spikes) in [
            (said!("lines"), Ink::Spikes, up),
            (said!("dark lines"), Ink::Product, down),
        ] {
            if !spikes.is_empty() {
                series.push(self.stems((name, ink), &spikes, smooth, factor));
            }
        }
        Chart {
            title,
            y_label: value_label(&document.scale.unit(&light.spectrum)),
            series,
            colours: strip(band),
            strip: true,
            notes: before_provenance(notes, app),
            ..over(band)
        }
    }

    /// Stems on the smooth part, with what is told of each.
    fn stems(&self, looks: (&str, Ink), spikes: &[Line], smooth: &[f64], factor: f64) -> Series {
        let label = |s: &Line| match self.told.known.safe(s.at_nm) {
            Some(name) => name.to_owned(),
            None => fixed(s.at_nm, 1),
        };
        let labels: Vec<String> = spikes.iter().map(label).collect();
        let notes = spikes
            .iter()
            .zip(&labels)
            .map(|(s, label)| {
                tr!(
                    "{label}: weight {weight}",
                    label,
                    weight = short(factor * s.weight)
                )
            })
            .collect();
        let derived = &self.light.derived;
        let width_nm = |i: usize| derived.stem_width_at(spikes[i].at_nm);
        spike_stems(looks, spikes, (derived.band, smooth, factor), width_nm)
            .labelled(labels)
            .with_notes(notes)
    }
}

/// The colours of the wavelengths along the axis; none where the range shows none.
pub fn strip(band: Band) -> Vec<Ink> {
    if band.min_nm() >= 830.0 || band.max_nm() <= 360.0 {
        return Vec::new();
    }
    band.grid().map(Ink::Wavelength).collect()
}
