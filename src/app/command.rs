//! What a person can do to the document. Views push these; only [`App::apply`] carries them out.
//!
//! [`App::apply`]: super::App::apply

use std::sync::Arc;

use super::{
    document::{Document, Subject, View},
    entry::Entry,
    opened::{ImageEntry, Opened},
    pages::PageStates,
    products::Products,
    recipe::Recipe,
    scale::Scale,
    settings::Settings,
};
use crate::spectrum::{Kind, NamedSpectrum, SpikeEdits};

/// What becomes of a spectrum that was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MadeFor {
    Shown,
    /// It is the last that the light meets.
    Chain,
    /// It stands behind the patches.
    Patches,
    /// It is the light that may have come off a surface; what is shown stays.
    Outgoing,
}

/// One change of the document, or a step through its history.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// New knobs; they are clamped when applied.
    Edit(Settings),
    /// Makes a spectrum the light, or the selected reflectance, by its kind.
    Show(Arc<Entry>),
    /// Shows a spectrum with knobs that suit it, in one step.
    ShowWith {
        /// The spectrum.
        entry: Arc<Entry>,
        /// The knobs; they are clamped when applied.
        settings: Settings,
    },
    /// The light that the light is compared with; `None` for none.
    Compare(Option<Arc<Entry>>),
    /// Adds a spectrum to the overlays, or takes it away.
    ToggleOverlay(Arc<Entry>),
    /// No overlays.
    ClearOverlays,
    /// What the model is of.
    About(Subject),
    /// New hand edits of the subject's spikes.
    EditSpikes(SpikeEdits),
    /// A whole model at once: knobs and hand edits, as a study found them best.
    TakeModel {
        /// The knobs; they are clamped when applied.
        settings: Settings,
        /// The hand edits of the subject's spikes.
        edits: SpikeEdits,
    },
    /// Takes a composite that is shown as it is apart like any other spectrum.
    Analyse,
    /// Model, layers, patches and hand edits as they are at the start; light and overlays stay.
    Reset,
    /// The group whose reflectances are the patches.
    PatchSet(String),
    /// The patch whose product is drawn.
    Patch(Option<usize>),
    /// Puts one of the user's own surfaces behind the patches, or takes it away.
    ToggleOwnPatch {
        /// The entry's key.
        key: String,
    },
    /// The scale switch.
    Scale(Scale),
    /// What the weights of the paper's lamps are multiplied by, nm.
    WeightFactor(f64),
    /// What the plot shows.
    View(View),
    /// What the page `Products` multiplies; clamped when applied.
    Products(Products),
    /// What pages keep; moved to what is allowed when applied.
    Page(Box<PageStates>),
    /// Takes spectra in as the user's own and shows the first.
    Adopt(Vec<NamedSpectrum>),
    /// Takes a spectrum in as one of the user's own; what is shown stays.
    Capture(Box<Entry>),
    /// Makes a spectrum, which joins the user's own and follows what it is made of.
    Make {
        recipe: Recipe,
        /// What becomes of it.
        place: MadeFor,
    },
    /// Makes one of the user's own in another way than so far.
    MakeOtherwise {
        /// The entry's key.
        key: String,
        recipe: Recipe,
    },
    /// What was made stays as it is, whatever happens to what it was made of.
    Freeze {
        /// The entry's key.
        key: String,
    },
    /// Takes in all that files brought, in one step, and shows the first light or factor, else
    /// the first spectrum.
    Open(Vec<Opened>),
    /// Puts what was read anew from a file in the place of what it brought before, each spectrum
    /// and image in that of the same number; those left over go, new ones join.
    Reread {
        /// Key of a spectrum or an image that came from the file.
        key: String,
        /// What it holds now.
        opened: Box<Opened>,
    },
    /// An image of the last time was read again: it stands where it stood, in every step of the
    /// history too. That it was away for a moment is nothing to undo.
    ImageIsBack(Arc<ImageEntry>),
    /// Takes an image out of the list.
    RemoveImage { key: String },
    /// A new name for one of the user's own.
    Rename {
        /// The entry's key.
        key: String,
        /// Its new name.
        name: String,
    },
    /// What one of the user's own stands for.
    SetKind {
        /// The entry's key.
        key: String,
        kind: Kind,
    },
    /// Takes one of the user's own out of the library.
    Remove {
        /// The entry's key.
        key: String,
    },
    /// Another document altogether: a project that was opened.
    Replace(Box<Document>),
    /// One step back.
    Undo,
    /// One step forward again.
    Redo,
}

/// What a person does without letting go: its commands are one step of undo, as of a slider that is
/// dragged, not one a frame.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Gesture {
    Knobs,
    Spikes,
    WeightFactor,
    Products,
    Pages,
    Making(String),
    Naming(String),
}

impl Command {
    /// The gesture that this may be a part of; `None` for what is a step of its own.
    pub(super) fn gesture(&self) -> Option<Gesture> {
        Some(match self {
            Self::Page(_) => Gesture::Pages,
            Self::Edit(_) => Gesture::Knobs,
            Self::EditSpikes(_) => Gesture::Spikes,
            Self::WeightFactor(_) => Gesture::WeightFactor,
            Self::Products(_) => Gesture::Products,
            Self::MakeOtherwise { key, .. } => Gesture::Making(key.clone()),
            Self::Rename { key, .. } => Gesture::Naming(key.clone()),
            _ => return None,
        })
    }
}
