//! Options of `photo`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::{
    app::photograph::{Exposure, LampChoice},
    cli::{photo_words, words},
    photographs::axis::Pin,
};

/// Options of `photo`.
///
/// The shape of a light behind a response was tested on pictures that are drawn; no open pair of
/// photographs of a bulb and of a light whose spectrum is known was found.
#[derive(Args, Debug)]
pub(crate) struct Photo {
    /// Photographs of a spectrum, JPEG or PNG.
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Tell the wavelength at this pixel of the picture as it is shown; repeated for more.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = photo_words::pixel)]
    pub at: Vec<[f64; 2]>,
    /// The strip by hand: left, top, right and bottom in pixels.
    #[arg(long = "box", value_name = "X0,Y0,X1,Y1", value_parser = photo_words::area)]
    pub area: Option<[f64; 4]>,
    /// By how many degrees the strip is turned, -45 to 45 [default: as it is found; with --box 0].
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, value_parser = photo_words::turn)]
    pub turn: Option<f64>,
    /// Colours run from top to bottom.
    #[arg(long, conflicts_with = "horizontal")]
    pub vertical: bool,
    /// Colours run from left to right.
    #[arg(long)]
    pub horizontal: bool,
    /// By how many columns lines lean for a row of the strip [default: as it is found].
    #[arg(long, value_name = "COLUMNS", allow_hyphen_values = true, value_parser = photo_words::lean)]
    pub shear: Option<f64>,
    /// By how many columns lines bend for a row, squared [default: as it is found].
    #[arg(long, value_name = "COLUMNS", allow_hyphen_values = true, value_parser = photo_words::lean)]
    pub smile: Option<f64>,
    /// Wavelengths fall from left to right, or from top to bottom: only such axes are tried.
    #[arg(long, conflicts_with = "no_flip")]
    pub flip: bool,
    /// They rise: only such axes are tried.
    #[arg(long)]
    pub no_flip: bool,
    /// Read the middle row of the strip alone.
    #[arg(long)]
    pub one_row: bool,
    /// The codes of the picture are proportional to light.
    #[arg(long)]
    pub linear: bool,
    /// Which of several strips, the strongest is 1.
    #[arg(long, value_name = "N", conflicts_with = "area", value_parser = photo_words::strip)]
    pub strip: Option<usize>,
    /// The lamp: fluorescent, mercury, sodium, neon, argon, krypton, xenon, hydrogen, helium,
    /// daylight, auto or none.
    #[arg(long, value_name = "NAME", default_value = "auto", value_parser = photo_words::lamp)]
    pub lamp: LampChoice,
    /// A column of the strip and its wavelength in nm; repeated for more. Two or more make an axis,
    /// and with --lamp they narrow its search down.
    #[arg(long, value_name = "PX:NM", value_parser = photo_words::pin)]
    pub pin: Vec<Pin>,
    /// The strip and the axis of an instrument that was kept; it is checked whether it still fits.
    #[arg(long, value_name = "FILE.json", conflicts_with_all = ["area", "turn", "vertical",
        "horizontal", "strip", "pin", "shear", "smile", "flip", "no_flip", "one_row"])]
    pub instrument: Option<PathBuf>,
    /// Keep strip, axis and response as an instrument for other pictures.
    #[arg(long, value_name = "FILE.json", value_parser = words::path_in(&["json"]))]
    pub save_instrument: Option<PathBuf>,
    /// A picture of a light that is known, by the same instrument: its response is learnt from it.
    #[arg(long, value_name = "PHOTO", requires = "known")]
    pub response_from: Option<PathBuf>,
    /// What that light is: blackbody:2856 or daylight:6500 in K, a file or a preset.
    #[arg(long = "as", value_name = "LIGHT", requires = "response_from")]
    pub known: Option<OsString>,
    /// Two or more exposures of one light by the same camera, each with its time in seconds: they
    /// tell by which power of the light its values go, which is undone. Where FILE is one of them,
    /// columns that are over-exposed in it are taken from a darker one.
    #[arg(long, value_name = "PHOTO:SECONDS", num_args = 2.., value_parser = photo_words::exposure)]
    pub exposures: Vec<Exposure>,
    /// Take an axis that is only suggested, or an instrument that has moved.
    #[arg(long)]
    pub yes: bool,
    /// The spectrum to write.
    #[arg(long, value_name = "FILE.csv", value_parser = words::path_in(&["csv"]))]
    pub out: Option<PathBuf>,
    /// Let it replace a file that exists.
    #[arg(long)]
    pub force: bool,
    /// Print JSON; its keys are stable. One picture is an object, several are a list.
    #[arg(long)]
    pub json: bool,
}
