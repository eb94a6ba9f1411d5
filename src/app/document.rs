//! What a person is working on: plain data that every step of undo keeps a copy of.

use std::{collections::BTreeMap, sync::Arc};

use serde::{Deserialize, Serialize};

use super::{
    entry::{Entry, bundled_entries},
    library::Library,
    opened::ImageEntry,
    origin::Before,
    pages::PageStates,
    products::Products,
    scale::Scale,
    settings::Settings,
};
use crate::{
    color::Adaptation,
    preset::Preset,
    spectrum::{Composite, SpikeEdits},
};

/// Which of the two selected spectra the model is of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Subject {
    #[default]
    Light,
    /// The selected reflectance or transmittance, looked at under the light.
    Factor,
}

/// The patches that a light is judged by at first: the 24 of the ColorChecker.
pub const FIRST_PATCH_SET: &str = "colorchecker_ohta";

/// The light shown at first: a fluorescent tube, four lines on a glow.
pub const FIRST_LIGHT: &str = "cie_fluorescent_1nm/FL2";

/// What a light is seen beside where no other was chosen, and what that is seen beside.
pub(super) const USUAL_SECOND: [&str; 2] = ["cie_illuminants/CIE A", "cie_illuminants/CIE D65"];

/// The light of a fresh document among the shipped spectra.
///
/// # Panics
/// Never in a sound build: there are shipped spectra, and the first light is one of them (a test).
pub fn first_light(bundled: &[Arc<Entry>]) -> Arc<Entry> {
    let first = bundled.iter().find(|entry| entry.key == FIRST_LIGHT);
    first.unwrap_or(&bundled[0]).clone()
}

/// What the spectrum plot shows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct View {
    /// The measured curve.
    pub measured: bool,
    /// The model's smooth part as an outline.
    pub model: bool,
    /// The smooth part alone.
    pub smooth: bool,
    /// The spikes' stems.
    pub spikes: bool,
    /// The residual below.
    pub residual: bool,
    pub overlays: bool,
    /// The measured curve of a light is filled with the wavelengths' own colours.
    pub strip: bool,
    /// How heights are drawn.
    pub height: Height,
    /// Bring the patches to the screen's white.
    pub adapt_patches: bool,
}

/// How heights of the plot are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Height {
    /// By roots where lines tower over the glow, else evenly.
    #[default]
    Automatic,
    /// Evenly.
    Even,
    /// By their square roots.
    Root,
    /// By their logarithms.
    Log,
}

impl View {
    /// What the eye that looks at patches and pictures is used to.
    pub fn adaptation(&self) -> Adaptation {
        if self.adapt_patches {
            Adaptation::ToLight
        } else {
            Adaptation::None
        }
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            measured: true,
            model: true,
            smooth: false,
            spikes: true,
            residual: false,
            overlays: true,
            strip: true,
            height: Height::Automatic,
            adapt_patches: true,
        }
    }
}

/// Everything that undo brings back and a project keeps. Two versions are compared at every move of a
/// slider: spectra that both share are not read through.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    pub light: Arc<Entry>,
    /// The light that it is compared with.
    pub second: Option<Arc<Entry>>,
    /// The selected reflectance or transmittance.
    pub factor: Option<Arc<Entry>>,
    /// What the model is of.
    pub subject: Subject,
    /// Further spectra drawn for comparison.
    pub overlays: Vec<Arc<Entry>>,
    /// The user's own spectra.
    pub own: Vec<Arc<Entry>>,
    /// Spectral images.
    pub images: Vec<Arc<ImageEntry>>,
    /// The number that the next own spectrum or image gets.
    pub next_own: u64,
    /// The knobs.
    pub settings: Settings,
    /// While a composite is shown as it is: the knobs that were in force before.
    pub given: Option<Settings>,
    /// Hand edits of spikes, by the entry's key.
    pub edits: BTreeMap<String, SpikeEdits>,
    /// The group whose reflectances are the patches.
    pub patch_set: String,
    /// Keys of the user's own surfaces that stand behind them.
    pub own_patches: Vec<String>,
    /// The patch whose product is drawn.
    pub patch: Option<usize>,
    /// The scale switch.
    pub scale: Scale,
    /// What the weights of the paper's Table 4 are multiplied by to become unit x nm, nm.
    pub weight_factor: f64,
    /// What the plot shows.
    pub view: View,
    /// What the page `Products` multiplies.
    pub products: Products,
    /// What pages keep.
    pub pages: PageStates,
}

/// The best reading of Table 4's weights: contributions to the mean over the paper's 300 nm.
pub(super) const PAPER_WEIGHT_FACTOR: f64 = 300.0;

/// Factors that may be asked for, nm.
pub const WEIGHT_FACTORS: std::ops::RangeInclusive<f64> = 1.0..=1000.0;

/// Most of the user's own surfaces behind the patches.
pub(super) const MOST_OWN_PATCHES: usize = 12;

/// Most spectra laid over the subject: more curves hide one another and make every frame slow.
pub const MOST_OVERLAYS: usize = 100;

impl Document {
    /// What the entry of a key is called; a shipped one's name is the last part of its key.
    pub fn name_of(&self, key: &str) -> String {
        let own = self.own.iter().find(|entry| entry.key == key);
        let last = || key.rsplit('/').next().unwrap_or(key);
        own.map_or_else(last, |entry| entry.name()).to_owned()
    }

    /// What is said of overlays beyond the most there may be.
    pub fn overlays_left_out(count: usize) -> String {
        tr!(
            "{most} overlays are the most: {n} more is left out."
                | "{most} overlays are the most: {n} more are left out." % count,
            most = MOST_OVERLAYS
        )
    }

    /// Takes away the overlays beyond the most there may be, the newest first; tells how many.
    pub fn bound_overlays(&mut self) -> usize {
        let too_many = self.overlays.len().saturating_sub(MOST_OVERLAYS);
        self.overlays.truncate(MOST_OVERLAYS);
        too_many
    }

    /// Lets go of a patch that is not there: a light's patches are those of its set, a
    /// reflectance has none.
    pub fn bound_patch(&mut self) {
        let Some(patch) = self.patch else { return };
        let items = Library::bundled()
            .group(&self.patch_set)
            .map(|g| &g.items[..]);
        let is_patch = |item: &&Preset| item.kind.is_factor() && item.spectrum().is_some();
        let shipped = items.unwrap_or_default().iter().filter(is_patch).count();
        let count = shipped + self.patches_of_own().count();
        if !self.is_about_light() || patch >= count {
            self.patch = None;
        }
    }

    /// The user's own surfaces that stand behind the patches.
    pub fn patches_of_own(&self) -> impl Iterator<Item = &Arc<Entry>> {
        let found = |key: &String| self.own.iter().find(|entry| entry.key == *key);
        let all = self.own_patches.iter().filter_map(found);
        all.filter(|entry| entry.kind().is_factor())
    }

    /// What a surface behind the patches is called on screen: one's own as its file has it.
    pub fn patch_called<'n>(&self, name: &'n str) -> &'n str {
        match self.patches_of_own().any(|own| own.name() == name) {
            true => name,
            false => crate::languages::translated(name),
        }
    }

    /// A fresh document about a light.
    pub fn about(light: Arc<Entry>) -> Self {
        Self {
            light,
            second: None,
            factor: None,
            subject: Subject::Light,
            overlays: Vec::new(),
            own: Vec::new(),
            images: Vec::new(),
            next_own: 1,
            settings: Settings::default(),
            given: None,
            edits: BTreeMap::new(),
            patch_set: FIRST_PATCH_SET.to_owned(),
            own_patches: Vec::new(),
            patch: None,
            scale: Scale::default(),
            weight_factor: PAPER_WEIGHT_FACTOR,
            view: View::default(),
            products: Products::first(),
            pages: PageStates::default(),
        }
    }

    /// The spectrum that the model is of.
    pub fn subject_entry(&self) -> &Arc<Entry> {
        match (&self.subject, &self.factor) {
            (Subject::Factor, Some(factor)) => factor,
            _ => &self.light,
        }
    }

    /// The second light, or one to begin with where two are needed and none was chosen: a bulb, and
    /// daylight beside a bulb.
    pub fn light_beside(&self) -> Arc<Entry> {
        self.second.clone().unwrap_or_else(|| {
            let key = USUAL_SECOND[usize::from(self.light.key == USUAL_SECOND[0])];
            let found = bundled_entries().iter().find(|entry| entry.key == key);
            found.unwrap_or(&self.light).clone()
        })
    }

    /// Everything that is drawn over the subject: the second light over a light, then the overlays.
    pub fn laid_over(&self) -> impl Iterator<Item = &Arc<Entry>> {
        let second = self.second.iter().filter(|_| self.is_about_light());
        second.chain(&self.overlays)
    }

    /// Whether the subject is the light.
    pub fn is_about_light(&self) -> bool {
        self.subject == Subject::Light || self.factor.is_none()
    }

    /// Gives the paper's lamps in the document the weight factor in force.
    pub fn weigh_the_papers_lamps(&mut self) {
        let factor = self.weight_factor;
        let lights = [&mut self.light].into_iter().chain(&mut self.second);
        let all = lights.chain(&mut self.overlays);
        for entry in all.filter(|e| e.is_of_the_paper()) {
            let weighed = Library::bundled()
                .find(&entry.key)
                .ok()
                .and_then(|preset| Entry::of_preset_weighing(preset, Some(factor)));
            if let Some(weighed) = weighed.filter(|w| *w != **entry) {
                *entry = Arc::new(weighed);
            }
        }
    }

    /// Model, layers, patches and the subject's hand edits as a fresh document has them.
    pub fn reset(&mut self) {
        let key = self.subject_entry().key.clone();
        self.edits.remove(&key);
        self.settings = Settings::default();
        self.given = None;
        self.show_as_given();
        self.view = View::default();
        FIRST_PATCH_SET.clone_into(&mut self.patch_set);
        self.own_patches.clear();
        self.patch = None;
    }

    /// The composite that the subject is, while it is shown as it is.
    pub fn as_given(&self) -> Option<&Arc<Composite>> {
        self.given?;
        self.subject_entry().composite.as_ref()
    }

    /// Shows a subject that is a composite as it is, with its own range, series and lines, unless
    /// its lines were changed by hand; any other with the knobs that were in force before one was.
    pub fn show_as_given(&mut self) {
        self.analyse();
        let entry = self.subject_entry();
        let Some(composite) = &entry.composite else {
            return;
        };
        if !self.edits.contains_key(&entry.key) {
            let before = self.settings;
            self.settings = before.of_composite(composite);
            self.given = Some(before);
        }
    }

    /// After what is shown was taken away: a composite that is shown no more leaves its knobs.
    pub fn show_again(&mut self) {
        if self.given.is_some() && self.as_given().is_none() {
            self.show_as_given();
        }
    }

    /// Has a composite taken apart like any other spectrum, with the knobs of before.
    pub fn analyse(&mut self) {
        if let Some(before) = self.given.take() {
            self.settings = self.settings.with_model_of(before);
        }
    }

    /// What is on screen.
    pub fn looks(&self) -> Before {
        Before {
            light: self.light.key.clone(),
            factor: self.factor.as_ref().map(|factor| factor.key.clone()),
            about_factor: self.subject == Subject::Factor,
        }
    }

    /// The hand edits of the subject's spikes.
    pub fn subject_edits(&self) -> SpikeEdits {
        self.edits
            .get(&self.subject_entry().key)
            .cloned()
            .unwrap_or_default()
    }
}
