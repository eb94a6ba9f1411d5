//! The program's state: one document, its history, and what is derived from it.

mod deriving;
mod followed;
mod messages;
mod own;
mod photographed;
mod second;
mod steps;

use std::sync::{Arc, OnceLock};

use super::{
    beside::Beside,
    command::{Command, Gesture},
    derived::Derived,
    document::{Document, Subject, WEIGHT_FACTORS, first_light},
    entry::{Entry, bundled_entries},
    history::History,
    laid::Laid,
    library::{Library, now_called},
    line_names::{ElementLine, LineName},
    photograph::OnPage,
    product_view::ProductView,
    spike_hand::{self, SpikeAct},
    spike_names::{Told, names_in},
    surfaces::Surfaces,
    tables::Tables,
};
use crate::{
    languages::said,
    spectrum::{Kind, SpikeEdits},
};

pub use deriving::derive;
pub(super) use deriving::derived_of;
pub use messages::{Message, Tone};

use deriving::{Kept, TablesFor, make_tables, tables_for};

/// The program without a window.
#[derive(Clone, Debug)]
pub struct App {
    document: Document,
    history: History,
    /// The present gesture; `None` between gestures.
    gesture: Option<Gesture>,
    tables: Arc<Tables>,
    tables_for: TablesFor,
    derived: Arc<Derived>,
    names: Vec<LineName>,
    told: Option<Arc<Told>>,
    product: Option<ProductView>,
    surfaces: OnceLock<Option<Surfaces>>,
    laid: OnceLock<Vec<Laid>>,
    beside: Option<Beside>,
    /// The key of the light that is followed.
    live: Option<String>,
    scale_factor: f64,
    unit: String,
    messages: Vec<Message>,
    on_page: OnPage,
    /// Steps taken that can be undone, ever.
    steps: u64,
    revision: u64,
    changes: u64,
}

impl Default for App {
    fn default() -> Self {
        Self::new()
    }
}

impl App {
    /// The program as it starts the first time: a lamp worth looking at.
    ///
    /// # Panics
    /// Never in a sound build: the first light is one of the bundled presets (a test).
    pub fn new() -> Self {
        Self::about(Document::about(first_light(bundled_entries())))
    }

    /// The program with a document that was made elsewhere.
    pub fn with_document(mut document: Document) -> Self {
        // What is shown is the very one in the library: to show it again is no step.
        let factor = document.factor.iter_mut();
        let lights = [&mut document.light]
            .into_iter()
            .chain(&mut document.second);
        let shown = lights.chain(factor);
        for entry in shown.chain(&mut document.overlays) {
            let same = bundled_entries().iter().find(|b| **b == *entry);
            if let Some(same) = same {
                *entry = same.clone();
            }
        }
        Self::about(document)
    }

    fn about(mut document: Document) -> Self {
        document.bound_patch();
        let tables_for = tables_for(&document);
        let tables = Arc::new(make_tables(&tables_for));
        let derived = Arc::new(derive(&document, &tables, None));
        let mut app = Self {
            document,
            history: History::default(),
            gesture: None,
            tables,
            tables_for,
            derived,
            names: Vec::new(),
            told: None,
            product: None,
            surfaces: OnceLock::new(),
            laid: OnceLock::new(),
            beside: None,
            live: None,
            scale_factor: 1.0,
            unit: String::new(),
            messages: Vec::new(),
            on_page: OnPage::default(),
            steps: 0,
            revision: 0,
            changes: 0,
        };
        app.name_spikes();
        app.recompute(Kept::Model);
        app
    }

    pub fn document(&self) -> &Document {
        &self.document
    }

    pub fn derived(&self) -> &Arc<Derived> {
        &self.derived
    }

    /// Whether the subject's table reaches into the model's range.
    pub fn is_measured_in_range(&self) -> bool {
        let samples = &self.document.subject_entry().spectrum.samples;
        let band = self.derived.band;
        samples.first_nm() <= band.max_nm() && samples.last_nm() >= band.min_nm()
    }

    /// The subject on the model's grid, nm and values as measured, within its table: the model
    /// takes what lies outside for dark, and nobody measured that.
    pub fn measured_points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let samples = &self.document.subject_entry().spectrum.samples;
        let table = samples.first_nm().floor()..=samples.last_nm().ceil();
        let holes = samples.holes();
        let points = self.derived.band.grid().zip(&self.derived.measured);
        points
            .filter(move |(nm, _)| table.contains(nm))
            .map(move |(nm, value)| {
                let is_missing = holes.iter().any(|[from, to]| (*from < nm) && (nm < *to));
                (nm, if is_missing { f64::NAN } else { *value })
            })
    }

    /// The shared tables, for benches and studies.
    pub fn tables(&self) -> &Arc<Tables> {
        &self.tables
    }

    /// The shipped spectra.
    pub fn bundled(&self) -> &'static [Arc<Entry>] {
        bundled_entries()
    }

    /// Names of the model's spikes, in their order.
    pub fn spike_names(&self) -> &[LineName] {
        &self.names
    }

    /// What the spectrum shown is, in words.
    pub fn told(&self) -> Option<&Told> {
        self.told.as_deref()
    }

    /// How many of all measured surfaces tell the model from its light, computed at the first call
    /// after a change (1 ms); `None` where there are no patches to see.
    pub fn surfaces(&self) -> Option<&Surfaces> {
        self.surfaces
            .get_or_init(|| Surfaces::of(&self.derived, &self.tables))
            .as_ref()
    }

    /// All atomic lines, for hover.
    pub fn element_lines(&self) -> &'static [ElementLine] {
        Library::bundled().lines()
    }

    /// Grows with every change of the document but those of what pages keep.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Grows with every change of the document, and of the photograph on its page.
    pub fn changes(&self) -> u64 {
        self.changes
    }

    /// The entry of that key, shipped or the user's own.
    pub fn entry(&self, key: &str) -> Option<Arc<Entry>> {
        let all = || self.document.own.iter().chain(self.bundled());
        let found = |key: &str| all().find(|e| e.key == key).cloned();
        found(key).or_else(|| found(now_called(key)?))
    }

    /// A gesture ends when the pointer is let go: the next change is a step of its own.
    pub fn end_gesture(&mut self) {
        self.gesture = None;
    }

    /// The only place that changes the document.
    pub fn apply(&mut self, command: Command) {
        let before = self.document.clone();
        let gesture = command.gesture();
        match command {
            Command::Undo => {
                let words = self.undo_words();
                let words = words.map(|words| tr!("Undone: {words}.", words));
                return self.step(History::undo, words, said!("Nothing to undo."));
            }
            Command::Redo => {
                let words = self.redo_words();
                let words = words.map(|words| tr!("Redone: {words}.", words));
                return self.step(History::redo, words, said!("Nothing to redo."));
            }
            Command::ImageIsBack(image) => return self.image_is_back(&image),
            Command::Edit(settings) => self.document.settings = settings.clamped(),
            Command::Show(entry) => {
                self.show(entry);
                self.document.weigh_the_papers_lamps();
            }
            Command::ShowWith { entry, settings } => {
                self.show(entry);
                self.document.given = None;
                self.document.settings = settings.clamped();
                self.document.weigh_the_papers_lamps();
            }
            Command::Compare(second) => self.compare(second),
            Command::ToggleOverlay(entry) => {
                let overlays = &mut self.document.overlays;
                match overlays.iter().position(|o| o.key == entry.key) {
                    Some(index) => drop(overlays.remove(index)),
                    None => overlays.push(entry),
                }
                self.document.weigh_the_papers_lamps();
            }
            Command::ClearOverlays => self.document.overlays.clear(),
            Command::About(subject) => {
                self.document.subject = subject;
                self.document.show_as_given();
            }
            Command::EditSpikes(edits) => self.set_edits(edits),
            Command::TakeModel { settings, edits } => {
                self.document.settings = settings.clamped();
                self.set_edits(edits);
            }
            Command::Analyse => self.document.analyse(),
            Command::Reset => self.document.reset(),
            Command::PatchSet(group) => {
                self.document.patch_set = group;
                self.document.patch = None;
            }
            Command::Patch(patch) => self.document.patch = patch,
            Command::ToggleOwnPatch { key } => self.toggle_own_patch(&key),
            Command::Scale(scale) => self.document.scale = scale,
            Command::WeightFactor(factor) => self.weigh_lamps_by(factor),
            Command::View(view) => self.document.view = view,
            Command::Products(products) => self.document.products = products.clamped(),
            Command::Page(pages) => self.document.pages = pages.in_reach(),
            Command::Adopt(all) => self.adopt(all.into_iter().map(|s| Entry::own(0, s)), &[]),
            Command::Capture(entry) => drop(self.join(*entry)),
            Command::Open(files) => self.take_in(files),
            Command::Make { recipe, place } => self.make(recipe, place),
            Command::MakeOtherwise { key, recipe } => self.make_otherwise(&key, recipe),
            Command::Freeze { key } => self.freeze(&key),
            Command::Reread { key, opened } => self.reread(&key, &opened),
            Command::RemoveImage { key } => {
                self.document.images.retain(|i| i.key != key);
                self.freeze_what_stands_on(&key);
            }
            Command::Rename { key, name } => self.rename(&key, &name),
            Command::SetKind { key, kind } => {
                self.freeze(&key);
                self.change_entry(&key, |entry| entry.spectrum.kind = kind);
            }
            Command::Remove { key } => self.remove(&key),
            Command::Replace(document) => self.document = *document,
        }
        self.settle(before, gesture);
    }

    /// Brings the document in order after a command, remembers what was before, and derives anew.
    fn settle(&mut self, before: Document, gesture: Option<Gesture>) {
        self.analyse_what_was_changed(&before);
        self.document.bound_patch();
        self.make_again(&before);
        let too_many = self.document.bound_overlays();
        if too_many > 0 {
            self.say(Tone::Problem, Document::overlays_left_out(too_many));
        }
        if self.document == before {
            return;
        }
        let kept = Kept::of(&before, &self.document);
        if gesture.is_none() || gesture != self.gesture {
            self.history.remember(before);
            self.steps += 1;
        }
        self.gesture = gesture;
        self.recompute(kept);
    }

    /// Carries out an act on the subject's spikes.
    pub fn act_on_spikes(&mut self, act: SpikeAct) {
        let edits = spike_hand::after(act, &self.document.subject_edits(), &self.derived.parts);
        self.apply(Command::EditSpikes(edits));
    }

    /// The product with the selected patch; `None` when there is none.
    pub fn product(&self) -> Option<&ProductView> {
        self.product.as_ref()
    }

    /// Factor from the subject's own numbers to the scale in force.
    pub fn scale_factor(&self) -> f64 {
        self.scale_factor
    }

    /// Points of the subject's table within the model's range.
    pub fn table_points(&self) -> usize {
        let samples = &self.document.subject_entry().spectrum.samples;
        let band = self.derived.band;
        samples.nm().iter().filter(|nm| band.contains(**nm)).count()
    }

    /// The unit of the values on screen.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// A composite is shown as it is until its lines, its range or its series are changed.
    fn analyse_what_was_changed(&mut self, before: &Document) {
        let (now, then) = (&self.document, before);
        let same_subject = now.subject_entry().key == then.subject_entry().key;
        let changed = !now.settings.takes_apart_as(then.settings) || now.edits != then.edits;
        if same_subject && then.given == now.given && changed {
            // What was not moved just now is as it was before the composite was shown.
            let (moved, was) = (now.settings, then.settings);
            self.document.analyse();
            self.document.settings = self.document.settings.with_moves(was, moved);
        }
    }

    fn weigh_lamps_by(&mut self, factor: f64) {
        if factor.is_finite() {
            let (least, most) = (*WEIGHT_FACTORS.start(), *WEIGHT_FACTORS.end());
            self.document.weight_factor = factor.clamp(least, most);
            self.document.weigh_the_papers_lamps();
        }
    }

    fn set_edits(&mut self, edits: SpikeEdits) {
        let key = self.document.subject_entry().key.clone();
        if edits.is_empty() {
            self.document.edits.remove(&key);
        } else {
            self.document.edits.insert(key, edits);
        }
    }

    fn show(&mut self, entry: Arc<Entry>) {
        match entry.kind() {
            Kind::Light => {
                self.document.light = entry;
                self.document.subject = Subject::Light;
                self.document.show_as_given();
            }
            Kind::Reflectance | Kind::Transmittance => {
                self.document.factor = Some(entry);
                self.document.subject = Subject::Factor;
                self.document.show_as_given();
            }
            kind @ (Kind::Absorbance | Kind::Weighting | Kind::Lines | Kind::Other) => {
                let overlays = &mut self.document.overlays;
                if !overlays.iter().any(|o| o.key == entry.key) {
                    overlays.push(entry.clone());
                }
                self.say(
                    Tone::Info,
                    tr!(
                        "{name} is neither a light nor a reflectance ({kind}): drawn as an \
                         overlay.",
                        name = entry.name(),
                        kind = said(kind.word())
                    ),
                );
            }
        }
    }

    /// Derives what cannot be the same any more.
    fn recompute(&mut self, kept: Kept) {
        self.changes += 1;
        if kept == Kept::AllButPages {
            return;
        }
        if kept != Kept::AllOrders {
            self.laid = OnceLock::new();
        }
        if kept != Kept::Model {
            let wanted = tables_for(&self.document);
            if wanted != self.tables_for {
                self.tables = Arc::new(make_tables(&wanted));
                self.tables_for = wanted;
            }
            let curve = (kept == Kept::AllOrders).then(|| &self.derived.curve[..]);
            self.derived = Arc::new(derive(&self.document, &self.tables, curve));
            self.surfaces = OnceLock::new();
            self.name_spikes();
        }
        self.beside = Beside::of(&self.document, self.beside.take());
        let spectrum = &self.document.subject_entry().spectrum;
        self.product = self.document.patch.and_then(|index| {
            let patches = self.tables.patches.as_ref()?;
            let sampling = self.document.settings.sampling;
            ProductView::of(&self.derived, patches, index, sampling)
        });
        // Integrals over the whole table: once a change, not once a frame.
        self.scale_factor = self.document.scale.factor(spectrum).unwrap_or(1.0);
        self.unit = self.document.scale.unit(spectrum);
        self.revision += 1;
    }

    fn name_spikes(&mut self) {
        let subject = self.document.subject_entry();
        let is_told = |told: &Arc<Told>| Arc::ptr_eq(&told.of, subject);
        let told = self.told.take().filter(is_told);
        let told = told.unwrap_or_else(|| Arc::new(Told::of(subject, self.element_lines())));
        self.names = names_in(&told.light, subject, &self.derived);
        self.told = Some(told);
    }
}
