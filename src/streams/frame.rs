//! One spectrum of a stream, and its line in a recording.

use std::io::{self, Write};

use serde::{Deserialize, Serialize};

use crate::spectrum::{Kind, Sampled};

/// One spectrum of a stream.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// As its line states it, else since the source was opened, ms.
    pub time_ms: f64,
    pub name: String,
    pub kind: Kind,
    /// As read: no dark is taken off, no response.
    pub samples: Sampled,
    /// Exposure, ms; `None` where the source does not tell it.
    pub integration_ms: Option<f64>,
    /// Unit of the values; empty where the source does not tell it.
    pub unit: String,
    /// Instrument as the source calls it; mostly empty.
    pub instrument: String,
}

impl Frame {
    /// True if both may be averaged: one grid, one unit, one exposure.
    pub fn is_like(&self, other: &Self) -> bool {
        self.samples.nm() == other.samples.nm()
            && self.unit == other.unit
            && self.kind == other.kind
            && self.integration_ms == other.integration_ms
    }
}

/// The object of a line; wavelengths that are left out are those of the line before.
#[derive(Default, Deserialize, Serialize)]
#[serde(default)]
pub(super) struct Line {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_ms: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub integration_ms: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub instrument: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wavelength_nm: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub values: Option<Vec<f64>>,
}

/// Writes frames as lines of a recording; wavelengths stand where they change.
#[derive(Debug)]
pub struct Recorder<W> {
    out: W,
    last: Option<Sampled>,
}

impl<W: Write> Recorder<W> {
    pub fn new(out: W) -> Self {
        Self { out, last: None }
    }

    /// Writes a frame and brings it out, so that a kill loses none.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&mut self, frame: &Frame) -> io::Result<()> {
        let last = self.last.as_ref();
        let is_new = last.is_none_or(|last| last.nm() != frame.samples.nm());
        let word = |word: &String| Some(word.clone()).filter(|word| !word.is_empty());
        let line = Line {
            time_ms: Some(frame.time_ms),
            name: word(&frame.name),
            integration_ms: frame.integration_ms,
            unit: word(&frame.unit),
            instrument: word(&frame.instrument),
            wavelength_nm: is_new.then(|| frame.samples.nm().to_vec()),
            values: Some(frame.samples.values().to_vec()),
        };
        let mut text = serde_json::to_vec(&line)?;
        text.push(b'\n');
        self.out.write_all(&text)?;
        self.out.flush()?;
        self.last = Some(frame.samples.clone());
        Ok(())
    }
}
