//! The encoder: known lamps, a short cosine series and a few lines of their own width, chosen so
//! that patches, narrow filters and the spectrum itself are all off by little.

use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex},
};

use super::{
    columns::Columns, encoding::Decoder, error::EncodingError, judge::EvaluationSet,
    known::atoms_on,
};
use crate::{
    color::{Observer, PatchSet},
    spectrum::{Band, PerBasis, SpikeSettings},
    study::FitBasis,
};

/// Longest range that is encoded, nm: ten times the visible. Time and memory grow with it, and beyond
/// lies nothing that the eye sees.
pub(crate) const LONGEST_RANGE_NM: usize = 4000;

/// Encodes lights of one band for one observer. Made once (some tenths of a second) and shared.
#[derive(Debug)]
pub struct Encoder {
    pub(super) columns: Columns,
    pub(super) panel: EvaluationSet,
    pub(super) decoder: Decoder,
    pub(super) spikes: SpikeSettings,
    /// Data that depend on the count of numbers alone.
    counted: Mutex<BTreeMap<usize, Arc<Counted>>>,
}

/// Data that depend on the count of numbers alone.
#[derive(Debug)]
pub(super) struct Counted {
    /// The patches as cosine series.
    pub(super) patches: PatchSet,
    pub(super) numbers: usize,
    /// Each basis as today's ways have it.
    pub(super) bases: PerBasis<FitBasis>,
}

impl Encoder {
    /// An encoder for a band and an observer; `spikes` is how today's ways look for lines.
    ///
    /// # Errors
    /// [`EncodingError::Unseen`] when the band misses the visible, [`EncodingError::TooLong`] when it
    /// is longer than `LONGEST_RANGE_NM`.
    pub fn new(
        band: Band,
        observer: Observer,
        spikes: SpikeSettings,
    ) -> Result<Self, EncodingError> {
        if band.steps() > LONGEST_RANGE_NM {
            return Err(EncodingError::TooLong {
                band,
                most: LONGEST_RANGE_NM,
            });
        }
        let panel = EvaluationSet::choosing(band, observer);
        let atoms = atoms_on(band);
        Ok(Self {
            columns: Columns::new(&panel, &atoms)?,
            decoder: Decoder::with_atoms(band, atoms),
            spikes,
            counted: Mutex::default(),
            panel,
        })
    }

    /// The decoder of the same band.
    pub fn decoder(&self) -> &Decoder {
        &self.decoder
    }

    /// The panel that chooses.
    pub(crate) fn panel(&self) -> &EvaluationSet {
        &self.panel
    }

    pub(super) fn counted(&self, numbers: usize) -> Arc<Counted> {
        let mut known = self.counted.lock().unwrap_or_else(|e| e.into_inner());
        let (band, seen) = (self.panel.band(), &self.panel.measures().seen);
        let new = || Counted {
            patches: self.panel.patches_as_cosines(numbers),
            numbers,
            bases: PerBasis::of(|basis| FitBasis::new(band, basis, numbers, seen)),
        };
        known
            .entry(numbers)
            .or_insert_with(|| Arc::new(new()))
            .clone()
    }
}
