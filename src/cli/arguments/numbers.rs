//! Options of what accuracy costs: `sweep`, `auction`, `race`, `product`. The comments here are what
//! `--help` prints.

use std::ffi::OsString;

use clap::Args;

use crate::{
    cli::{
        options::{FileOptions, ModelOptions, PickOptions},
        words,
    },
    spectrum::Kind,
    study::Goal,
};

/// Options of `sweep`.
#[derive(Args, Debug)]
pub(crate) struct Sweep {
    /// A file (- is standard input), a preset's name (FL2, "CIE D65") or group/name
    /// (paper/Mercury).
    #[arg(value_name = "INPUT")]
    pub input: OsString,
    #[command(flatten)]
    pub pick: PickOptions,
    /// The model: every order, basis and fit is tried; basis and fit are those of the threshold map,
    /// which --json has.
    #[command(flatten)]
    pub model: ModelOptions,
    /// Print JSON instead of CSV; its keys are stable. In both relative errors are fractions of 1
    /// and not per cent.
    #[arg(long)]
    pub json: bool,
}

/// Options of `auction`.
#[derive(Args, Debug)]
pub(crate) struct Auction {
    /// A file (- is standard input), a preset's name (FL2, "CIE D65") or group/name
    /// (paper/Mercury).
    #[arg(value_name = "INPUT")]
    pub input: OsString,
    /// The error to make small: own, patches (the surfaces), spectrum, filters or a mix such as
    /// patches=2,filters=1 (each error over its value at order 0).
    #[arg(long, value_name = "GOAL", value_parser = words::goal)]
    pub goal: Goal,
    /// Most numbers that may be spent, 1 to 101.
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = words::numbers)]
    pub numbers: usize,
    #[command(flatten)]
    pub pick: PickOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// Print JSON instead of CSV; its keys are stable. In both relative errors are fractions of 1
    /// and not per cent.
    #[arg(long)]
    pub json: bool,
}

/// Options of `race`.
#[derive(Args, Debug)]
pub(crate) struct Race {
    /// A light that races alone: a file (- is standard input), a preset's name or group/name
    /// [default: all shipped lights].
    #[arg(value_name = "INPUT")]
    pub input: Option<OsString>,
    /// Counts of numbers, 1 to 101, repeated or with commas (11,20,31).
    #[arg(long, value_name = "P", required = true, value_delimiter = ',',
        allow_negative_numbers = true, value_parser = words::numbers)]
    pub numbers: Vec<usize>,
    /// Lights that race: a group of presets (cie_fluorescent_1nm), a class (smooth, led,
    /// fluorescent or discharge) or a folder with files of lights.
    #[arg(long, value_name = "GROUP|FOLDER")]
    pub set: Option<OsString>,
    #[command(flatten)]
    pub pick: PickOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// Counts a known lamp's index and a line's width as numbers of their own.
    #[arg(long)]
    pub strict: bool,
    /// Print JSON instead of CSV; its keys are stable. In both relative errors and negative_lobes
    /// are fractions of 1 and not per cent.
    #[arg(long)]
    pub json: bool,
}

/// Options of `product`.
#[derive(Args, Debug)]
pub(crate) struct Product {
    /// A light: a file (lamps.csv#2 is the second of several spectra, - is standard input), a
    /// preset's name (FL2, "CIE D65") or group/name. A file that states another kind is refused.
    #[arg(value_name = "LIGHT")]
    pub light: OsString,
    /// Filters and surfaces that it meets, in order: reflectances and transmittances, each a file,
    /// a preset's name or group/name (colorchecker_ohta/red). One given twice counts twice. What
    /// may follow the name: #SPECTRUM which one of a file, by name or number from 1; @4mm or @x2
    /// how thick a glass is, in mm where its name tells them or as a multiple; *3 how many times in
    /// a row the light meets it ("isuzu IVG550 (Green filter) 2 mm@4mm", "red*3",
    /// glasses.csv#2@x1.5).
    #[arg(value_name = "FACTOR")]
    pub factors: Vec<OsString>,
    /// Instead of factors a group of presets (tm30_ces99_5nm): each alone, and their spread.
    #[arg(long, value_name = "GROUP")]
    pub set: Option<String>,
    /// Instead of the product: whether this spectrum is the light off the factors, up to a
    /// factor, in the model's numbers. A file, a preset's name or group/name.
    #[arg(long, value_name = "OUTGOING")]
    pub check: Option<OsString>,
    /// Kind of the files among the factors: reflectance or transmittance [default: as each file
    /// says].
    #[arg(long, value_name = "KIND", value_parser = words::factor_kind)]
    pub kind: Option<Kind>,
    #[command(flatten)]
    pub files: FileOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// Print JSON; its keys are stable. Shares are fractions of 1 and not per cent: transmission,
    /// luminance_error, folded_share, depth.
    #[arg(long)]
    pub json: bool,
}
