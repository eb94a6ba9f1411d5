//! The photograph of the page as the rest of the program sees it: read, or put there by a lesson.

use std::sync::{Arc, LazyLock};

use serde::Deserialize;

use super::{Photograph, PhotographAsk, PictureOf, Said, SeenPhotograph};
/// A photograph that was read, or why it was not.
pub type Seen = Arc<Result<SeenPhotograph, String>>;

/// Picture that a lesson puts in the place of a person's own, which comes back after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Staged {
    /// No picture: one is to be opened.
    Nothing,
    /// The one that the program draws.
    Example,
}

/// The page's photograph.
#[derive(Clone, Debug, Default)]
pub struct OnPage {
    pub staged: Option<Staged>,
    /// The last one that was read, and what was staged then.
    seen: Option<(Option<Staged>, Seen)>,
}

impl OnPage {
    /// The photograph, where there is one that could be read.
    pub(in crate::app) fn photograph(&self) -> Option<&Photograph> {
        let read = self.seen.as_ref();
        let read = read.filter(|(staged, _)| *staged == self.staged);
        let seen = match (read, self.staged) {
            (_, Some(Staged::Nothing)) | (None, None) => return None,
            (None, Some(Staged::Example)) => example(),
            (Some((_, seen)), _) => seen,
        };
        let seen = seen.as_ref().as_ref().ok()?;
        seen.found.as_ref().ok()
    }

    /// Takes note of the photograph that is shown now; whether it is another.
    pub(in crate::app) fn note(&mut self, seen: &Seen) -> bool {
        let known = self.seen.as_ref();
        let is_known =
            known.is_some_and(|(of, known)| *of == self.staged && Arc::ptr_eq(known, seen));
        if !is_known {
            self.seen = Some((self.staged, seen.clone()));
        }
        !is_known
    }
}

/// The picture that the program draws, read once.
pub fn example() -> &'static Seen {
    static EXAMPLE: LazyLock<Seen> = LazyLock::new(|| {
        let ask = PhotographAsk {
            of: PictureOf::Example,
            said: Said::default(),
        };
        Arc::new(ask.seen())
    });
    &EXAMPLE
}
