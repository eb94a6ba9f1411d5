//! The choice between a light as measured and as its model has it.

use serde::{Deserialize, Serialize};

/// The form of a light that is sent through.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sent {
    /// Its lines, each as one wavelength, and what was measured beside them.
    #[default]
    Measured,
    /// Its model: the lines, and the series beside them.
    Model,
}

impl Sent {
    /// Both, in the order of the menu.
    pub const ALL: [Self; 2] = [Self::Measured, Self::Model];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Measured => said!("as measured"),
            Self::Model => said!("as the model has it"),
        }
    }

    /// The word of JSON and of the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::Model => "model",
        }
    }
}
