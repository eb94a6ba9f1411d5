//! Surfaces under two lights as measured, and a metamer made for one of them.

use std::sync::Arc;

use crate::{
    app::{
        cells::{Columns, Table, cell},
        entry::Entry,
        state::App,
        studies::{Pairs, reflectances},
        ticks::short,
    },
    color::{Observer, Weights, delta_e_2000},
    languages::fixed,
    spectrum::{Band, Kind, NamedSpectrum, Sampled},
    study::products::{Black, MetamericPair, TwoLights, metameric_black, two_lights},
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
    /// Colour-matching functions on the grid.
    pub seen: Weights,
}

impl TwoLightsSheet {
    /// The sheet of a state: under its light and the second one, or what stands in for that.
    pub fn of(app: &App) -> Self {
        let document = app.document();
        let lights = [document.light.clone(), document.light_beside()];
        let settings = document.settings;
        Self::measured(
            settings.band,
            settings.observer,
            lights,
            &document.patch_set,
        )
    }

    /// Patches under two lights as measured.
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
            values,
            names,
            surfaces,
            seen,
        }
    }
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
            Self::NoPatch => said!("The set has no surface to make a metamer of."),
            Self::Unseen => {
                said!(
                    "One of the lights is not seen on this range, so every surface matches every \
                     other."
                )
            }
            Self::NoRoom => {
                said!(
                    "There is no room: the surface touches 0 or 1 where a black would take it \
                     beyond, or the light has too little colour on this range to have a black."
                )
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
            name: tr!(
                "{surface}, metamer under {light}",
                surface = patch,
                light = sheet.lights[0]
            ),
            kind: Kind::Reflectance,
            unit: "fraction".to_owned(),
            scale: 1.0,
            samples: Sampled::even(band.min_nm(), 1.0, self.values.clone()).ok()?,
            notes: vec![
                tr!(
                    "Made: {surface} plus the metameric black of {light} on {min}-{max} nm (the \
                     one sum of the first four half-range cosines that this light shows as \
                     nothing), {share} % of the room within 0 to 1.",
                    surface = patch,
                    light = sheet.lights[0],
                    min = short(band.min_nm()),
                    max = short(band.max_nm()),
                    share = percent
                ),
                tr!(
                    "CIEDE2000 to {surface}: {first_difference} under {first_light}, \
                     {second_difference} under {second_light}.",
                    surface = patch,
                    first_difference = fixed(self.delta_e_2000[0], 2),
                    first_light = sheet.lights[0],
                    second_difference = fixed(self.delta_e_2000[1], 2),
                    second_light = sheet.lights[1]
                ),
            ],
            source: format!("made from {patch}"),
        })
    }
}
