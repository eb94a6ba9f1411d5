//! Options of `picture` and `fit`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::{
    cli::{
        options::FileOptions,
        room_words::{self, Lines},
        words,
    },
    pictures::ReferenceKind,
    spectrum::Kind,
};

/// Options of `picture`.
#[derive(Args, Debug)]
pub(crate) struct Picture {
    /// A spectral picture: an ENVI cube (its header or its data) or a spectral OpenEXR; with
    /// --relight one of few numbers (.exr or .cspx.png). The word wall is a wall of paints that the
    /// program makes, with --light as that light shows it.
    #[arg(value_name = "IN")]
    pub input: PathBuf,
    /// Numbers a pixel, 3 or more and fewer than bands.
    #[arg(long, value_name = "N", conflicts_with = "bound", allow_negative_numbers = true,
        value_parser = room_words::whole_number)]
    pub numbers: Option<usize>,
    /// The fewest numbers that keep the 95th percentile of the colour difference within this, 0.01
    /// to 20 [default: 0.5].
    #[arg(long, value_name = "DE", allow_hyphen_values = true, value_parser = room_words::bound)]
    pub bound: Option<f64>,
    /// Multiplier of the series: one, light (--light) or mean [default: what is best].
    #[arg(long, value_name = "REFERENCE", value_parser = room_words::reference)]
    pub reference: Option<ReferenceKind>,
    /// The light on a reflectance (then its own, CIE D65 without) or the one that lit a picture
    /// of light, a file or a preset.
    #[arg(long, value_name = "NAME")]
    pub light: Option<OsString>,
    /// Lines with a number of their own: auto, none or places in nm with commas
    /// [default: what is best].
    #[arg(long, value_name = "LINES", value_parser = room_words::lines)]
    pub lines: Option<Lines>,
    /// Kind of the values, where the file leaves it open: light, reflectance or transmittance.
    #[arg(long, value_name = "KIND", value_parser = words::usable_kind, conflicts_with = "relight")]
    pub kind: Option<Kind>,
    /// Keep bands that nobody sees too.
    #[arg(long)]
    pub all_bands: bool,
    /// Tell of other ways of keeping the picture in as many numbers instead.
    #[arg(long, conflicts_with_all = ["out", "relight", "force"])]
    pub peers: bool,
    /// Show a picture of few numbers under this light, into --out A.png.
    #[arg(long, value_name = "NAME", requires = "out",
        conflicts_with_all = ["numbers", "bound", "reference", "lines", "all_bands"])]
    pub relight: Option<OsString>,
    /// The file to write: .exr holds every number, .cspx.png is small and opens as a picture; with
    /// --relight a .png.
    #[arg(long, value_name = "FILE", value_parser = words::path_in(&["png", "exr"]))]
    pub out: Option<PathBuf>,
    /// Let it replace a file that exists.
    #[arg(long, requires = "out")]
    pub force: bool,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON; its keys are stable.
    #[arg(long)]
    pub json: bool,
}

/// Options of `fit`.
#[derive(Args, Debug)]
pub(crate) struct Fit {
    /// A file of spectra or a folder with such files; - reads lines of JSON with nm and values, and
    /// answers each by a line.
    #[arg(value_name = "TABLE|FOLDER")]
    pub input: OsString,
    /// Numbers a spectrum, 3 or more and fewer than wavelengths.
    #[arg(long, value_name = "N", default_value = "20", allow_negative_numbers = true,
        value_parser = room_words::whole_number)]
    pub numbers: usize,
    /// Multiplier of the series: one or mean.
    #[arg(long, value_name = "REFERENCE", default_value = "one",
        value_parser = room_words::fit_reference)]
    pub reference: ReferenceKind,
    /// Lines with a number of their own: auto or none.
    #[arg(long, value_name = "LINES", default_value = "auto",
        action = clap::ArgAction::Set, value_parser = room_words::fit_lines)]
    pub lines: bool,
    /// The file to write, .csv or .json; needed but for lines of JSON.
    #[arg(long, value_name = "FILE", value_parser = words::path_in(&["csv", "json"]))]
    pub out: Option<PathBuf>,
    /// Let it replace a file that exists.
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Print JSON; its keys are stable. Lines of JSON are answered by such lines anyhow.
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub files: FileOptions,
}
