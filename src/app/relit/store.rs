//! What a picture takes on disk in each form, measured by writing it, and saving it.

use std::{path::Path, sync::Arc};

use super::{Fit, Outcome, told};
use crate::{
    app::{memo::ByAddress, studies::Question},
    languages::fixed,
    pictures::{
        About, Bytes, CompactPlan, Errors, Half, Peer, PictureError, Precision, compact_plan,
        exact_bytes, measure, peers, save_compact, save_full, white_y_of,
    },
    study::Progress,
};

/// "1.24 MiB".
pub fn bytes_words(bytes: u64) -> String {
    match bytes {
        0..1024 => tr!("{bytes} bytes", bytes),
        1024..1_048_576 => format!("{} KiB", fixed(bytes as f64 / 1024.0, 0)),
        _ => format!("{} MiB", fixed(bytes as f64 / 1_048_576.0, 1)),
    }
}

/// Whose bytes are counted.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreAsk(pub ByAddress<Fit>);

/// What a picture takes, and what it is off by after it was read back.
#[derive(Debug)]
pub struct Stored {
    /// Bytes of each form.
    pub bytes: Bytes,
    /// What the full form is off by.
    pub full: Errors,
    /// How the compact form is written, and what it is off by.
    pub compact: CompactPlan,
    half: Half,
}

/// A form on disk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// OpenEXR with every number.
    Full,
    /// A PNG with the numbers in private chunks.
    Compact,
}

impl Form {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Full, Self::Compact];

    /// What its files end in.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Full => "exr",
            Self::Compact => "cspx.png",
        }
    }

    /// What it is, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Full => {
                said!(
                    "OpenEXR: every number in half precision, and red, green and blue that any \
                     viewer of EXR shows."
                )
            }
            Self::Compact => {
                said!(
                    "A PNG that any viewer shows, small; the numbers are in it, in steps too \
                     small to see."
                )
            }
        }
    }
}

impl StoreAsk {
    fn stored(&self, progress: &Progress) -> Result<Stored, PictureError> {
        let fit = &*self.0.0;
        let (looked, operator) = (&fit.looked.0, &fit.operator);
        let sample = &looked.survey.sample;
        let white_y = white_y_of(operator, sample);
        let numbers: Vec<Vec<f64>> = sample.iter().map(|p| operator.numbers_of(p)).collect();
        let half = Half::of(&numbers);
        looked.with_pixels(|pixels| {
            let full = measure(pixels, operator, &half, white_y, progress)?;
            let compact = compact_plan(
                pixels,
                operator,
                sample,
                looked.ask.bound,
                white_y,
                progress,
            )?;
            let mut stored = Stored {
                bytes: Bytes::default(),
                full,
                compact,
                half,
            };
            let folder = tempfile::tempdir()?;
            let place = folder.path().join("picture");
            for form in Form::ALL {
                let bytes = stored.written(fit, form, &place, progress)?;
                match form {
                    Form::Full => stored.bytes.full = Some(bytes),
                    Form::Compact => stored.bytes.compact = Some(bytes),
                }
            }
            stored.bytes.exact = Some(exact_bytes(pixels, Precision::Half, progress)?);
            Ok(stored)
        })
    }
}

impl Question for StoreAsk {
    type Answer = Outcome<Stored>;

    fn answer(&self, progress: &Progress) -> Option<Self::Answer> {
        told(self.stored(progress))
    }
}

impl Stored {
    fn written(
        &self,
        fit: &Fit,
        form: Form,
        path: &Path,
        progress: &Progress,
    ) -> Result<u64, PictureError> {
        let (looked, operator) = (&fit.looked.0, &fit.operator);
        let about = About {
            unit: looked.unit.clone(),
            source: looked.name.clone(),
            noise: looked.survey.usual_noise(),
        };
        looked.with_pixels(|pixels| match form {
            Form::Full => {
                let kept = (Precision::Half, self.half);
                let said = (&about, self.full.clone());
                save_full(path, pixels, operator, kept, said, progress)
            }
            Form::Compact => save_compact(path, pixels, operator, &self.compact, &about, progress),
        })
    }
}

/// A picture that is to be saved.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureWish {
    /// The picture.
    pub fit: ByAddress<Fit>,
    /// How it is written.
    pub stored: ByAddress<Stored>,
    pub form: Form,
}

impl PictureWish {
    pub fn file_name(&self) -> String {
        let name = self.fit.0.looked.0.name.to_lowercase();
        let sound = |c: char| if c.is_alphanumeric() { c } else { '-' };
        let stem: String = name.chars().map(sound).collect();
        format!("{}.{}", stem.trim_matches('-'), self.form.ending())
    }

    /// Writes the file; what was written, a sentence.
    ///
    /// # Errors
    /// Why it was not, a sentence; nothing is left behind.
    pub fn save(&self, path: &Path) -> Result<String, String> {
        let progress = Progress::default();
        let written = self
            .stored
            .0
            .written(&self.fit.0, self.form, path, &progress);
        let bytes = written.map_err(|why| match why {
            PictureError::Unsaved(words) => words,
            why => format!("{}: {why}", path.display()),
        })?;
        Ok(tr!(
            "Saved {file}: {count} numbers a pixel, {size}.",
            file = path.display(),
            count = self.fit.0.operator.numbers(),
            size = bytes_words(bytes)
        ))
    }
}

/// Whose peers are asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct PeersAsk(pub ByAddress<Fit>);

impl Question for PeersAsk {
    type Answer = Outcome<Vec<Peer>>;

    fn answer(&self, progress: &Progress) -> Option<Self::Answer> {
        let fit = &*self.0.0;
        let looked: &Arc<_> = &fit.looked.0;
        told(looked.with_pixels(|pixels| peers(pixels, &fit.operator, &looked.survey, progress)))
    }
}
