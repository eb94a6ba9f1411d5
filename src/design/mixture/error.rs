//! Why channels do not make a light.

/// Most channels of a mixture.
pub(crate) const MOST_CHANNELS: usize = 128;

/// Why channels do not make a light.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MixError {
    /// A channel's words are not of a form that is known.
    #[error(
        "{}",
        tr!("channel: expected {expected}, found {found}", expected, found = format!("{found:?}"))
    )]
    Spec {
        /// The words.
        found: String,
        /// The form expected of them.
        expected: String,
    },
    /// A light of a channel has no power in 360-830 nm, or less than none.
    #[error(
        "{}",
        tr!(
            "channel {spec}: expected a light with power in 360-830 nm, found none",
            spec = format!("{spec:?}")
        )
    )]
    NoPower {
        /// The channel.
        spec: String,
    },
    /// No channel, or too many.
    #[error(
        "{}",
        tr!("channels: expected 1 to {most}, found {found}", most = MOST_CHANNELS, found)
    )]
    Channels {
        /// The number found.
        found: usize,
    },
    /// A target that is no colour.
    #[error("{}", tr!("target: expected {expected}, found {found}", expected, found))]
    Target {
        /// The target found.
        found: String,
        /// The form expected of it.
        expected: String,
    },
    /// A floor or a figure that is not known.
    #[error(
        "{}",
        tr!("expected {expected}, found {found}", expected, found = format!("{found:?}"))
    )]
    Word {
        /// The word.
        found: String,
        /// The words there are.
        expected: &'static str,
    },
}
