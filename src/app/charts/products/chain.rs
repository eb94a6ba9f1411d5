//! A light through its chain as the part "Chain" shows it: every stage, its words and its chart.

use crate::{
    app::{
        chart::{Chart, Ink, Series},
        charts::{
            spectrum::{before_provenance, on_grid, over, spike_stems},
            units::value_label,
        },
        product_report::Told,
        products::ModelledLight,
        state::App,
        ticks::short,
    },
    spectrum::{Band, Line},
};

/// Points that a small spectrum is drawn with at most.
const SMALL_POINTS: usize = 120;

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
    /// Exact curve and smooth part at each [`Place`], heights 0-1 over the exact peak.
    pub small_curves: Vec<[Vec<f32>; 2]>,
}

impl ChainSheet {
    /// The chain of a state.
    pub fn of(app: &App) -> Self {
        let light = ModelledLight::of(app);
        let told = Told::of(app, &light, &app.document().products.chain);
        let first = small_curves(&light.derived.measured, &light.derived.smooth);
        let steps = told.passage.steps.iter();
        let behind = steps.map(|step| small_curves(&step.exact, &step.smooth));
        Self {
            small_curves: std::iter::once(first).chain(behind).collect(),
            notes: told.stage_notes(&light),
            light,
            told,
        }
    }

    /// How many factors there are.
    pub fn stages(&self) -> usize {
        self.told.passage.steps.len()
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
                format!("The light: {}", light.name()),
                &derived.measured,
                &derived.smooth,
            ),
            Place::Stage(index) => (
                format!("Behind step {}: {}", index + 1, self.told.names[index]),
                &steps[index].exact,
                &steps[index].smooth,
            ),
        };
        let mut notes = vec![format!("Light: {}", light.name())];
        let names = self.told.names.iter().enumerate();
        notes.extend(names.map(|(i, name)| format!("{}. {name}", i + 1)));
        let band = derived.band;
        let factor = document.scale.factor(&light.spectrum).unwrap_or(1.0);
        let curve = |values: &[f64]| on_grid(band, values, factor);
        let mut series = vec![
            Series::line("exact", Ink::Measured, curve(exact)),
            Series::line("smooth part", Ink::Smooth, curve(smooth)),
        ];
        let (up, down): (Vec<Line>, Vec<Line>) =
            self.spikes(place).iter().partition(|s| s.weight >= 0.0);
        for (name, ink, spikes) in [
            ("lines", Ink::Spikes, up),
            ("dark lines", Ink::Product, down),
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
            None => format!("{:.1}", s.at_nm),
        };
        let labels: Vec<String> = spikes.iter().map(label).collect();
        let notes = spikes
            .iter()
            .zip(&labels)
            .map(|(s, label)| format!("{label}: weight {}", short(factor * s.weight)))
            .collect();
        let derived = &self.light.derived;
        let width_nm = |i: usize| derived.stem_width_at(spikes[i].at_nm);
        spike_stems(looks, spikes, (derived.band, smooth, factor), width_nm)
            .labelled(labels)
            .with_notes(notes)
    }
}

/// Two curves over the peak of the first, heights 0-1.
fn small_curves(exact: &[f64], smooth: &[f64]) -> [Vec<f32>; 2] {
    let top = exact.iter().copied().fold(0.0, f64::max);
    // A line of 1 nm must not fall between the points that are drawn.
    let chunk = exact.len().div_ceil(SMALL_POINTS).max(1);
    let heights = |values: &[f64]| {
        let highest = |part: &[f64]| part.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let height = |v: f64| {
            let share = Some(v / top).filter(|share| share.is_finite());
            share.map_or(0.0, |share| share.clamp(0.0, 1.0) as f32)
        };
        values.chunks(chunk).map(|c| height(highest(c))).collect()
    };
    [heights(exact), heights(smooth)]
}

/// The colours of the wavelengths along the axis; none where the range shows none.
pub fn strip(band: Band) -> Vec<Ink> {
    if band.min_nm() >= 830.0 || band.max_nm() <= 360.0 {
        return Vec::new();
    }
    band.grid().map(Ink::Wavelength).collect()
}
