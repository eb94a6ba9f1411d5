//! The workspace: what comes back after a restart or a kill, and the same as a named project.
//!
//! Shipped spectra are kept by name, the user's own with all their numbers. What no longer exists
//! (a preset of another version) is left out and said.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::Arc,
    time::Duration,
};

use serde::{Deserialize, Serialize};

use super::{
    document::{Document, FIRST_LIGHT, PAPER_WEIGHT_FACTOR, Subject, View, WEIGHT_FACTORS},
    entry::{Entry, bundled_entries},
    pages::PageMemory,
    products::{Link, Products, Times},
    scale::Scale,
    settings::Settings,
    stored_path,
};
use crate::{
    io::{
        Choices, MakersResult,
        atomic::{UNFINISHED, save_atomically},
    },
    spectrum::{Kind, NamedSpectrum, Sampled, SpikeEdits},
};

/// The word that marks a workspace or project file.
pub const FORMAT: &str = "spectral-explorer-project";
/// The version written.
pub const VERSION: u32 = 1;

/// How the window looks; not part of undo.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Preferences {
    /// Dark surroundings.
    pub dark: bool,
    /// Zoom of the whole window, 0.8-2.5.
    pub zoom: f32,
    /// Large type and thick lines.
    pub projector: bool,
    /// Files opened last, newest first.
    #[serde(with = "stored_path::list")]
    pub recent: Vec<PathBuf>,
    /// Inner size of the window in points, if it was ever shown.
    pub window: Option<[f32; 2]>,
    /// What the error-against-order curve shows.
    pub curve: CurveQuantity,
    /// The shelves that are folded in the library.
    pub folded: Vec<String>,
    /// The library is folded away.
    pub no_library: bool,
    /// The bottom panel shows the spikes instead of the patches.
    pub spikes_below: bool,
    /// What the pages remember.
    pub pages: PageMemory,
}

impl Default for Preferences {
    fn default() -> Self {
        Self {
            dark: true,
            zoom: 1.0,
            projector: false,
            recent: Vec::new(),
            window: None,
            curve: CurveQuantity::default(),
            folded: FOLDED_AT_FIRST.map(str::to_owned).to_vec(),
            no_library: false,
            spikes_below: false,
            pages: PageMemory::default(),
        }
    }
}

/// Shelves of the library that start folded: there are hundreds of reflectances.
pub const FOLDED_AT_FIRST: [&str; 3] = ["Reflectances", "Filters and glasses", "Observers"];

/// Smallest and largest zoom.
pub const ZOOMS: [f32; 2] = [0.8, 2.5];

impl Preferences {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(mut self) -> Self {
        self.zoom = if self.zoom.is_finite() {
            self.zoom.clamp(ZOOMS[0], ZOOMS[1])
        } else {
            1.0
        };
        self.window = self
            .window
            .filter(|size| size.iter().all(|s| (200.0..=20_000.0).contains(s)));
        self.recent.truncate(MOST_RECENT);
        self.pages = self.pages.clamped();
        self
    }

    /// Puts a file on top of the recent ones.
    pub fn remember_file(&mut self, path: &Path) {
        self.recent.retain(|p| p != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(MOST_RECENT);
    }
}

/// Recent files kept.
const MOST_RECENT: usize = 12;

/// What the error-against-order curve shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveQuantity {
    /// CIEDE2000 of the light itself.
    Own,
    /// Mean CIEDE2000 of the patches.
    #[default]
    Patches,
    /// Largest CIEDE2000 of the patches.
    PatchesWorst,
    /// Relative RMS at 1 nm.
    Rms,
    /// Relative RMS behind a 10 nm blur.
    RmsBlurred,
}

/// A spectrum of the user's own with all its numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct OwnSpectrum {
    key: String,
    name: String,
    kind: Kind,
    unit: String,
    scale: f64,
    nm: Vec<f64>,
    values: Vec<f64>,
    notes: Vec<String>,
    source: String,
    #[serde(default)]
    makers: Vec<MakersResult>,
}

/// An image by the file that it is read from again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredImage {
    /// Its key.
    pub key: String,
    /// The file.
    #[serde(with = "stored_path")]
    pub path: PathBuf,
    /// Which of the file's images, from 0.
    pub index: usize,
    /// What a person decided about the file.
    #[serde(default)]
    pub choices: Choices,
}

/// What is written: the document by names, and the window's preferences.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Stored {
    format: String,
    version: u32,
    program: String,
    light: String,
    #[serde(default)]
    factor: Option<String>,
    #[serde(default)]
    subject: Subject,
    #[serde(default)]
    overlays: Vec<String>,
    #[serde(default)]
    own: Vec<OwnSpectrum>,
    #[serde(default)]
    images: Vec<StoredImage>,
    #[serde(default)]
    next_own: u64,
    #[serde(default)]
    settings: Settings,
    #[serde(default)]
    edits: BTreeMap<String, SpikeEdits>,
    patch_set: String,
    #[serde(default)]
    patch: Option<usize>,
    #[serde(default)]
    scale: Scale,
    #[serde(default = "paper_weight_factor")]
    weight_factor: f64,
    #[serde(default)]
    view: View,
    #[serde(default)]
    products: Option<StoredProducts>,
    #[serde(default)]
    preferences: Option<Preferences>,
}

/// What the page `Products` multiplies, by names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct StoredProducts {
    chain: Vec<(String, Times)>,
    other_light: Option<String>,
    surface: Option<String>,
    outgoing: Option<String>,
}

impl StoredProducts {
    fn of(products: &Products) -> Self {
        let Products {
            chain,
            other_light,
            surface,
            outgoing,
        } = products;
        let key = |entry: &Option<Arc<Entry>>| entry.as_ref().map(|e| e.key.clone());
        let link = |link: &Link| {
            let Link {
                entry,
                thickness,
                bounces,
            } = link;
            let times = Times {
                thickness: *thickness,
                bounces: *bounces,
            };
            (entry.key.clone(), times)
        };
        Self {
            chain: chain.iter().map(link).collect(),
            other_light: key(other_light),
            surface: key(surface),
            outgoing: key(outgoing),
        }
    }

    fn found(self, mut find: impl FnMut(&str) -> Option<Arc<Entry>>) -> Products {
        let links = self.chain.into_iter().filter_map(|(key, times)| {
            Some(Link {
                entry: find(&key)?,
                thickness: times.thickness,
                bounces: times.bounces,
            })
        });
        Products {
            chain: links.collect(),
            other_light: self.other_light.as_deref().and_then(&mut find),
            surface: self.surface.as_deref().and_then(&mut find),
            outgoing: self.outgoing.as_deref().and_then(&mut find),
        }
        .clamped()
    }
}

/// What came back from a workspace or project.
#[derive(Clone, Debug, PartialEq)]
pub struct Restored {
    /// The document.
    pub document: Document,
    /// Images that are to be read again: a text holds no picture.
    pub images: Vec<StoredImage>,
    /// The window's preferences; `None` in a project.
    pub preferences: Option<Preferences>,
    /// What could not be brought back, a sentence each.
    pub losses: Vec<String>,
}

/// The text of a workspace (with preferences) or a project (without).
///
/// # Errors
/// One line when it cannot be written as text; then nothing must be saved over what is there.
pub fn to_json(document: &Document, preferences: Option<&Preferences>) -> Result<String, String> {
    to_json_with(document, preferences, &[])
}

/// The same with images that are still being read again, or that were not found this time: what
/// is not there yet is not lost.
///
/// # Errors
/// As [`to_json`].
pub fn to_json_with(
    document: &Document,
    preferences: Option<&Preferences>,
    waiting: &[StoredImage],
) -> Result<String, String> {
    let Document {
        light,
        factor,
        subject,
        overlays,
        own,
        images,
        next_own,
        settings,
        edits,
        patch_set,
        patch,
        scale,
        weight_factor,
        view,
        products,
    } = document;
    let stored = Stored {
        format: FORMAT.to_owned(),
        version: VERSION,
        program: env!("CARGO_PKG_VERSION").to_owned(),
        light: light.key.clone(),
        factor: factor.as_ref().map(|f| f.key.clone()),
        subject: *subject,
        overlays: overlays.iter().map(|o| o.key.clone()).collect(),
        own: own.iter().map(|entry| OwnSpectrum::of(entry)).collect(),
        images: images
            .iter()
            .filter_map(|image| {
                Some(StoredImage {
                    key: image.key.clone(),
                    path: image.path.clone()?,
                    index: image.index,
                    choices: image.choices.clone(),
                })
            })
            .chain(waiting.iter().cloned())
            .collect(),
        next_own: *next_own,
        settings: *settings,
        edits: edits.clone(),
        patch_set: patch_set.clone(),
        patch: *patch,
        scale: *scale,
        weight_factor: *weight_factor,
        view: *view,
        products: Some(StoredProducts::of(products)),
        preferences: preferences.cloned(),
    };
    serde_json::to_string_pretty(&stored)
        .map_err(|error| format!("the document cannot be written as JSON: {error}"))
}

/// Reads a workspace or project.
///
/// # Errors
/// One line that says what is wrong with the text.
pub fn from_json(text: &str) -> Result<Restored, String> {
    let stored: Stored = serde_json::from_str(text).map_err(|e| broken_json(&e))?;
    if stored.format != FORMAT {
        return Err(format!(
            "found the format {:?}, expected {FORMAT:?}",
            stored.format
        ));
    }
    if stored.version > VERSION {
        return Err(format!(
            "found version {}, expected {VERSION} or lower: a newer Spectral Explorer wrote it",
            stored.version
        ));
    }
    let mut losses = Vec::new();
    let mut own = Vec::new();
    for spectrum in stored.own {
        let name = spectrum.name.clone();
        match spectrum.into_entry() {
            Ok(entry) => own.push(Arc::new(entry)),
            Err(why) => losses.push(format!("{name} was not brought back: {why}.")),
        }
    }
    let bundled = bundled_entries();
    let mut find = |key: &str| {
        let found = own.iter().chain(&bundled).find(|e| e.key == key).cloned();
        if found.is_none() {
            let words = format!("{key} is not in this version's library.");
            // One spectrum may stand in several places.
            if !losses.contains(&words) {
                losses.push(words);
            }
        }
        found
    };
    let light = find(&stored.light)
        .or_else(|| find(FIRST_LIGHT))
        .ok_or("no light to show")?;
    let mut document = Document {
        light,
        factor: stored.factor.as_deref().and_then(&mut find),
        subject: stored.subject,
        overlays: stored.overlays.iter().filter_map(|key| find(key)).collect(),
        next_own: next_own(stored.next_own, &own),
        own: own.clone(),
        images: Vec::new(),
        settings: stored.settings.clamped(),
        edits: stored.edits,
        patch_set: stored.patch_set,
        patch: stored.patch,
        scale: stored.scale,
        weight_factor: stored
            .weight_factor
            .clamp(*WEIGHT_FACTORS.start(), *WEIGHT_FACTORS.end()),
        view: stored.view,
        products: stored
            .products
            .map_or_else(Products::first, |products| products.found(&mut find)),
    };
    document.weigh_the_papers_lamps();
    Ok(Restored {
        document,
        images: stored.images,
        preferences: stored.preferences.map(Preferences::clamped),
        losses,
    })
}

/// A number that no own spectrum has yet.
fn next_own(stored: u64, own: &[Arc<Entry>]) -> u64 {
    let highest = own
        .iter()
        .filter_map(|e| e.key.strip_prefix("own/")?.parse::<u64>().ok())
        .filter(|n| *n < MOST_OWN)
        .max()
        .unwrap_or(0);
    stored.min(MOST_OWN).max(highest + 1)
}

/// Far more spectra than anybody opens; a file that claims more counts from here.
const MOST_OWN: u64 = 1 << 40;

fn paper_weight_factor() -> f64 {
    PAPER_WEIGHT_FACTOR
}

impl OwnSpectrum {
    fn of(entry: &Entry) -> Self {
        let NamedSpectrum {
            name,
            kind,
            unit,
            scale,
            samples,
            notes,
            source,
        } = &entry.spectrum;
        let makers = entry.makers.clone();
        Self {
            key: entry.key.clone(),
            name: name.clone(),
            kind: *kind,
            unit: unit.clone(),
            scale: *scale,
            nm: samples.nm().to_vec(),
            values: samples.values().to_vec(),
            notes: notes.clone(),
            source: source.clone(),
            makers,
        }
    }

    fn into_entry(self) -> Result<Entry, String> {
        let samples = Sampled::new(self.nm, self.values).map_err(|e| e.to_string())?;
        Ok(Entry {
            key: self.key,
            shelf: None,
            spectrum: NamedSpectrum {
                name: self.name,
                kind: self.kind,
                unit: self.unit,
                scale: self.scale,
                samples,
                notes: self.notes,
                source: self.source,
            },
            licence: String::new(),
            makers: self.makers,
        })
    }
}

/// What is wrong with a text that is no project, in words.
fn broken_json(error: &serde_json::Error) -> String {
    let line = error.line();
    match error.classify() {
        serde_json::error::Category::Eof if line <= 1 && error.column() == 0 => {
            format!("found an empty file, expected a {FORMAT} file")
        }
        serde_json::error::Category::Eof => {
            format!("line {line}: the file ends in the middle, expected a whole {FORMAT} file")
        }
        _ => {
            // serde repeats the place at the end.
            let words = error.to_string();
            let words = words.split(" at line ").next().unwrap_or_default();
            format!("line {line}: {words}, expected a {FORMAT} file")
        }
    }
}

/// Where the workspace lies on this computer; `None` when the system names no data folder.
pub fn default_path() -> Option<PathBuf> {
    let folders = directories::ProjectDirs::from("org", "", "spectral-explorer")?;
    Some(folders.data_dir().join("workspace.json"))
}

/// Saves a workspace so that a kill at any moment leaves either the old or the new one.
///
/// # Errors
/// One line for the status line.
pub fn save(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)
            .map_err(|e| format!("Workspace not saved: {}.", no_folder(folder, &e)))?;
    }
    save_atomically(path, text.as_bytes()).map_err(|e| format!("Workspace not saved: {e}."))
}

/// Why a folder for the workspace could not be made.
fn no_folder(folder: &Path, error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    let folder = folder.display();
    match error.kind() {
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
            format!("found no permission to make the folder {folder}, expected one to write to")
        }
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            format!("found the disk full at {folder}, expected room for the workspace")
        }
        ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
            format!("found a file in the way of the folder {folder}, expected a folder")
        }
        _ => format!("the folder {folder} cannot be made, expected one that can be written to"),
    }
}

/// Takes away what a save left unfinished when the program was killed, if it is older than `age`:
/// what is younger may be another window's that is saving just now.
pub fn sweep_leftovers(path: &Path, age: Duration) {
    let Some(Ok(folder)) = path.parent().map(std::fs::read_dir) else {
        return;
    };
    for entry in folder.filter_map(Result::ok) {
        let is_ours = entry.file_name().to_string_lossy().starts_with(UNFINISHED);
        let modified = entry.metadata().and_then(|about| about.modified());
        let is_old = modified.is_ok_and(|at| at.elapsed().is_ok_and(|passed| passed >= age));
        if is_ours && is_old {
            // Somebody else may have taken it away meanwhile.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Loads the workspace; `Ok(None)` when there is none yet.
///
/// # Errors
/// One line. A workspace that cannot be read is set aside under another name, so that nothing
/// overwrites it.
pub fn load(path: &Path) -> Result<Option<Restored>, String> {
    let text = match std::fs::read_to_string(path) {
        Ok(text) => text,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(_) if path.is_dir() => {
            return Err(format!(
                "The workspace {} is a folder: nothing is kept.",
                path.display()
            ));
        }
        Err(e) => return Err(set_aside(path, &e.to_string())),
    };
    from_json(&text)
        .map(Some)
        .map_err(|why| set_aside(path, &why))
}

fn set_aside(path: &Path, why: &str) -> String {
    let mut kept = path.with_extension("damaged.json");
    let mut number = 2;
    while kept.exists() {
        kept = path.with_extension(format!("damaged-{number}.json"));
        number += 1;
    }
    match std::fs::rename(path, &kept) {
        // The new name first: a narrow status line cuts the end, its tooltip has all.
        Ok(()) => format!(
            "The last workspace is damaged and kept as {} in {} ({why}).",
            kept.file_name().unwrap_or_default().to_string_lossy(),
            kept.parent().unwrap_or(Path::new("")).display()
        ),
        Err(e) => format!("The last workspace could not be read ({why}) nor set aside ({e})."),
    }
}
