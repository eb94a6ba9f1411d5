//! The acts that make something of measurements, as recipes keep them.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::measurements::{Kernel, Normalise};

/// What is done with the parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Act {
    /// A formula of their letters, A, B, C in their order.
    Formula {
        text: String,
        /// True if nothing is masked.
        #[serde(default)]
        keep_all: bool,
        /// What lights are brought to one scale by first.
        #[serde(default)]
        equal: Option<Normalise>,
        /// True if a quotient of two lights is a reflectance, whatever their names say.
        #[serde(default)]
        of_surface: bool,
    },
    /// The mean of scans of one light.
    Mean {
        /// True if scans unlike the others stay in.
        #[serde(default)]
        keep_all: bool,
    },
    /// Two ranges of one light.
    Splice {
        /// True if their axes are known to be right.
        #[serde(default)]
        is_sound: bool,
    },
    /// As an instrument of this slit sees it.
    Slit { fwhm_nm: f64, shape: Kernel },
    /// Its slit taken off: of this width, or as the light's own lines tell it.
    Unslit {
        #[serde(default)]
        fwhm_nm: Option<f64>,
        shape: Kernel,
    },
    /// An instrument's response taken off; the instrument as its file holds it.
    Corrected { instrument: Value },
}
