//! Options of `combine`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::cli::{options::FileOptions, room_words, words};

/// Options of `combine`.
#[derive(Args, Debug)]
pub(crate) struct Combine {
    /// What to do with the inputs, whose letters are A, B, C, ... in their order: a formula with
    /// the signs + - * / ( ), numbers and -log10, such as "A - B", "A / B", "(A - C) / (B - C)",
    /// "-log10(A / B)"; or mean (scans of one light), splice (two ranges), slit NM
    /// [triangle|gauss] (as such an instrument sees it), changed (what differs: the second set
    /// stands behind --).
    #[arg(value_name = "FORMULA", allow_hyphen_values = true)]
    pub formula: OsString,
    /// Spectra: files (lamps.csv#2 is the second of several, - is standard input), presets' names
    /// or group/name. For mean and changed a file means all its spectra.
    #[arg(value_name = "INPUT")]
    pub inputs: Vec<OsString>,
    /// The second set of scans for changed, behind --.
    #[arg(value_name = "OTHER", last = true)]
    pub others: Vec<OsString>,
    /// Wavelengths of the result: union of all grids, a or b for those of an input, or a step in
    /// nm such as 1; a coarser grid takes areas, never single samples.
    #[arg(long, value_name = "GRID", default_value = "union", value_parser = room_words::grid)]
    pub grid: room_words::Grid,
    /// Uncertainty of a reading's level, such as 1%.
    #[arg(long, value_name = "PERCENT", value_parser = room_words::level)]
    pub level: Option<f64>,
    /// Uncertainty of the wavelengths, such as 0.1nm.
    #[arg(long, value_name = "NM", value_parser = room_words::axis)]
    pub axis: Option<f64>,
    /// Keep all of a quotient, even where the reference is dark.
    #[arg(long)]
    pub keep_all: bool,
    /// The spectrum to write: .csv with a column of sigma, or .json, .sp (Argyll), .spd, .spdx.
    #[arg(long, value_name = "FILE",
        value_parser = words::path_in(&["csv", "json", "sp", "spd", "spdx"]))]
    pub out: Option<PathBuf>,
    /// Let it replace a file that exists.
    #[arg(long, requires = "out")]
    pub force: bool,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON; its keys are stable.
    #[arg(long)]
    pub json: bool,
    /// Print the result as CSV, as --out has it.
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,
}
