//! What pages keep in the document, under undo and in projects: plain data, spectra by their keys.
//! A page that needs a setting under undo adds it here and nowhere else.

use serde::{Deserialize, Serialize};

use crate::app::{design::mix::Mix, recipe::NameOf};

/// What pages keep, each under its own key of a project.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PageSettings {
    /// The mixing desk of the place `Design`.
    pub mix: Mix,
}

/// What one page keeps.
#[derive(Clone, Debug, PartialEq)]
pub enum PageSetting {
    /// The mixing desk.
    Mix(Mix),
}

impl Default for PageSettings {
    fn default() -> Self {
        Self { mix: Mix::first() }
    }
}

impl PageSettings {
    /// One of them anew, moved to what is allowed.
    pub fn set(&mut self, setting: PageSetting) {
        match setting {
            PageSetting::Mix(mix) => self.mix = mix.clamped(),
        }
    }

    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        Self {
            mix: self.mix.clamped(),
        }
    }

    /// Lets go of a spectrum that left the library.
    pub fn forget(&mut self, key: &str) {
        self.mix.forget(key);
    }

    /// What changed, in words.
    pub fn changed_since(&self, before: &Self, name_of: NameOf<'_>) -> Vec<String> {
        let mix = self.mix.changed_since(&before.mix, name_of);
        mix.into_iter().collect()
    }
}
