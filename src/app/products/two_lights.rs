//! The part `Two lights` as figures: patches under two lights, and a metamer made for one of them.

use std::sync::Arc;

use super::ModelledLight;
use crate::{
    app::{
        cells::{Columns, Table, cell},
        derived::Derived,
        document::{Document, Subject},
        entry::Entry,
        state::{App, derive},
        studies::{Pairs, reflectances},
        ticks::short,
    },
    color::{Adaptation, Observer, Swatch, Weights, delta_e_2000},
    spectrum::{Band, Composite, Kind, NamedSpectrum, Sampled},
    study::products::{
        Black, MetamericPair, TwoLights, metameric_black, two_lights, two_modelled_lights,
    },
};

/// The document's patches under its light and another one.
#[derive(Clone, Debug)]
pub struct TwoLightsSheet {
    /// The grid.
    pub band: Band,
    /// Names of the lights.
    pub lights: [String; 2],
    /// Both lights on the grid, as measured.
    pub values: [Vec<f64>; 2],
    /// Names of the patches.
    pub names: Vec<String>,
    /// Their reflectances on the grid.
    pub surfaces: Vec<Vec<f64>>,
    /// Their colours under the measured lights; `None` when one of them is not seen.
    pub exact: Option<TwoLights>,
    /// Their colours under the lights' models, against the same whites.
    pub model: Option<TwoLights>,
    /// Colour-matching functions on the grid.
    pub seen: Weights,
}

/// A light that is not the document's own, as its settings model it.
pub fn modelled(app: &App, lit: &ModelledLight, light: &Arc<Entry>) -> Derived {
    let document = Document {
        light: light.clone(),
        subject: Subject::Light,
        ..app.document().clone()
    };
    derive(&document, &lit.tables)
}

impl TwoLightsSheet {
    /// The sheet of a state; `None` without a second light.
    pub fn of(app: &App) -> Option<Self> {
        let document = app.document();
        let other = document.products.other_light.as_ref()?;
        let lit = ModelledLight::of(app);
        let both = [document.light.clone(), other.clone()];
        let observer = document.settings.observer;
        let sheet = Self::measured(lit.band(), observer, both, &document.patch_set);
        let second = modelled(app, &lit, other);
        let models = [&lit.derived.model, &second.model].map(Composite::idealised);
        let values = sheet.values.each_ref().map(Vec::as_slice);
        let model = two_modelled_lights(
            sheet.band,
            &sheet.surfaces,
            models.each_ref(),
            values,
            &sheet.seen,
        );
        Some(Self { model, ..sheet })
    }

    /// Patches under two lights as measured, without models.
    pub fn measured(
        band: Band,
        observer: Observer,
        lights: [Arc<Entry>; 2],
        patch_set: &str,
    ) -> Self {
        let values = lights.each_ref().map(|light| light.on_band(band));
        let (names, surfaces) = reflectances(patch_set, band);
        let seen = observer.table().on_band(band);
        let on_grid = values.each_ref().map(Vec::as_slice);
        Self {
            band,
            lights: lights.map(|light| light.name().to_owned()),
            exact: two_lights(band, &surfaces, on_grid, &seen),
            model: None,
            values,
            names,
            surfaces,
            seen,
        }
    }

    /// Both lights in the scale in which Y is 100; `None` for one that is not seen.
    pub fn scaled(&self) -> [Option<Vec<f64>>; 2] {
        [0, 1].map(|i| {
            let y = self.band.inner(&self.values[i], &self.seen[1]);
            let factor = 100.0 / y;
            (y > 0.0 && factor.is_finite())
                .then(|| self.values[i].iter().map(|v| v * factor).collect())
        })
    }

    /// Mean difference, in size, between the shift by the models and by the measured lights, and
    /// the patch where it is largest with that difference.
    pub fn shift_error(&self) -> Option<(f64, usize, f64)> {
        let (exact, model) = (self.exact.as_ref()?, self.model.as_ref()?);
        let both = exact.patches.iter().zip(&model.patches);
        let off: Vec<f64> = both
            .map(|(e, m)| (m.delta_e_2000 - e.delta_e_2000).abs())
            .collect();
        let most = off.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1))?;
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        Some((mean, most.0, *most.1))
    }

    /// The patches as a table.
    pub fn table(&self) -> Table {
        let comments = format!(
            "# {} and {}: CIEDE2000 of the colour shift, each light its own white\n",
            self.lights[0], self.lights[1]
        );
        let columns = Columns::<(&String, [f64; 2])>::default()
            .with("patch", |(name, _)| cell(name.as_str()))
            .with("shift measured", |(_, shifts)| cell(shifts[0]))
            .with("shift by the models", |(_, shifts)| cell(shifts[1]));
        let both = self.exact.as_ref().zip(self.model.as_ref());
        let rows = both.into_iter().flat_map(|(exact, model)| {
            let rows = self
                .names
                .iter()
                .zip(exact.patches.iter().zip(&model.patches));
            rows.map(|(name, (e, m))| (name, [e.delta_e_2000, m.delta_e_2000]))
        });
        Table::new(comments, columns, rows)
    }
}

/// Swatches of every patch of a set under both lights.
pub fn swatches(both: &TwoLights, adaptation: Adaptation) -> Vec<[Swatch; 2]> {
    let of = |i: usize, xyz| Swatch::of_patch(xyz, both.whites[i], adaptation);
    let patches = both.patches.iter();
    patches
        .map(|p| [of(0, p.xyz[0]), of(1, p.xyz[1])])
        .collect()
}

/// Pairs that were found as a table.
pub fn pairs_table(lights: &[String; 2], pairs: &Pairs) -> Table {
    let key = |pair: &&MetamericPair, at: usize| cell(pairs.surfaces[pair.pair[at]].key.as_str());
    let columns = Columns::<&MetamericPair>::default()
        .with("one", |pair| key(pair, 0))
        .with("other", |pair| key(pair, 1))
        .with("delta E first", |pair| cell(pair.delta_e_2000[0]))
        .with("delta E second", |pair| cell(pair.delta_e_2000[1]))
        .with("rms", |pair| cell(pair.rms));
    let comments = format!("# match under {}, part under {}\n", lights[0], lights[1]);
    Table::new(comments, columns, &pairs.metamers.pairs)
}

/// Why a metamer cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoMetamer {
    /// There is no such patch.
    NoPatch,
    /// One of the lights is not seen on this range.
    Unseen,
    /// The patch touches 0 or 1 where the black would leave.
    NoRoom,
}

impl NoMetamer {
    /// A sentence for people.
    pub fn words(self) -> &'static str {
        match self {
            Self::NoPatch => "The patch set has no patch to make a metamer of.",
            Self::Unseen => {
                "One of the lights is not seen on this range, so every surface matches every other."
            }
            Self::NoRoom => {
                "There is no room: the patch touches 0 or 1 where a black would take it beyond, or \
                 the light has too little colour on this range to have a black."
            }
        }
    }
}

/// A metamer made for a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    pub patch: usize,
    /// The black and its room.
    pub black: Black,
    /// Part of the room that is used, percent.
    pub room_percent: i32,
    /// The patch.
    pub original: Vec<f64>,
    /// The sum.
    pub values: Vec<f64>,
    /// Patch and sum under both lights.
    pub both: TwoLights,
    /// CIEDE2000 between the two under each light.
    pub delta_e_2000: [f64; 2],
}

impl Made {
    /// Adds the part of the room to a patch of the sheet.
    ///
    /// # Errors
    /// [`NoMetamer`] when there is none.
    pub fn of(sheet: &TwoLightsSheet, patch: usize, room_percent: i32) -> Result<Self, NoMetamer> {
        let original = sheet.surfaces.get(patch).ok_or(NoMetamer::NoPatch)?;
        if sheet.exact.is_none() {
            return Err(NoMetamer::Unseen);
        }
        let (band, seen) = (sheet.band, &sheet.seen);
        let black =
            metameric_black(band, original, &sheet.values[0], seen).ok_or(NoMetamer::NoRoom)?;
        let values = black.added(original, f64::from(room_percent) / 100.0);
        let lights = [&sheet.values[0][..], &sheet.values[1][..]];
        let surfaces = [original.clone(), values.clone()];
        let both = two_lights(band, &surfaces, lights, seen).ok_or(NoMetamer::Unseen)?;
        let [one, two] = [&both.patches[0], &both.patches[1]];
        Ok(Self {
            patch,
            delta_e_2000: [0, 1].map(|i| delta_e_2000(one.labs[i], two.labs[i])),
            black,
            room_percent,
            original: original.clone(),
            values,
            both,
        })
    }

    /// The sum as a spectrum of its own.
    pub fn spectrum(&self, sheet: &TwoLightsSheet) -> Option<NamedSpectrum> {
        let band = sheet.band;
        let (patch, percent) = (&sheet.names[self.patch], self.room_percent);
        Some(NamedSpectrum {
            name: format!("{patch}, metamer under {}", sheet.lights[0]),
            kind: Kind::Reflectance,
            unit: "fraction".to_owned(),
            scale: 1.0,
            samples: Sampled::even(band.min_nm(), 1.0, self.values.clone()).ok()?,
            notes: vec![
                format!(
                    "Made: {patch} plus the metameric black of {} on {}-{} nm (the one sum of the \
                     first four half-range cosines that this light shows as nothing), {percent} % \
                     of the room within 0 to 1.",
                    sheet.lights[0],
                    short(band.min_nm()),
                    short(band.max_nm()),
                ),
                format!(
                    "CIEDE2000 to {patch}: {:.2} under {}, {:.2} under {}.",
                    self.delta_e_2000[0], sheet.lights[0], self.delta_e_2000[1], sheet.lights[1]
                ),
            ],
            source: format!("made from {patch}"),
        })
    }
}
