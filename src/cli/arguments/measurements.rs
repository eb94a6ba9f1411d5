//! Options of `combine`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::{
    cli::{options::FileOptions, room_words, words},
    measurements::{Measurement, Normalise},
};

/// What is stated of a reading.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Stated {
    /// Uncertainty of a reading's level, such as 1%.
    #[arg(long, value_name = "PERCENT", value_parser = room_words::level)]
    pub level: Option<f64>,
    /// Uncertainty of the wavelengths, such as 0.1nm.
    #[arg(long, value_name = "NM", value_parser = room_words::axis)]
    pub axis: Option<f64>,
    /// Take counts of an instrument as a light; they stay marked.
    #[arg(long)]
    pub as_light: bool,
    /// Take a column called sd, std, stdev, sigma, u, error or +- as the standard deviation of the
    /// one before it.
    #[arg(long)]
    pub take_sigma: bool,
}

impl Stated {
    /// A measurement with what is stated of it.
    pub(crate) fn of(self, mut part: Measurement) -> Measurement {
        part.level = self.level.unwrap_or(part.level);
        part.axis_nm = self.axis.unwrap_or(part.axis_nm);
        part
    }
}

/// Options of `combine`.
#[derive(Args, Debug)]
pub(crate) struct Combine {
    /// What to do with the inputs, whose letters are A, B, C, ... in their order: a formula with
    /// the signs + - * / ( ), numbers and -log10, such as "A - B", "A / B", "(A - C) / (B - C)",
    /// "-log10(A / B)"; or mean (scans of one light), splice (two ranges), slit NM
    /// [triangle|gauss] (as such an instrument sees it), unslit auto|NM [triangle|gauss] (its slit
    /// taken off), changed (what differs: the second set stands behind --), instrument learn
    /// READING [DARK] (its response, by --known), instrument use INSTRUMENT.json READING [DARK].
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
    #[command(flatten)]
    pub stated: Stated,
    /// Keep everything: all of a quotient, even where the reference is dark, and all scans, even
    /// those that do not belong to the others.
    #[arg(long)]
    pub keep_all: bool,
    /// Bring lights to one scale first, by their Y, area, peak or their value at a wavelength in nm;
    /// for a formula.
    #[arg(long, value_name = "BY", value_parser = room_words::equal)]
    pub equal: Option<Normalise>,
    /// The quotient of two lights is a reflectance; without it their names decide, and else it is a
    /// transmittance.
    #[arg(long)]
    pub reflectance: bool,
    /// For instrument learn the light that was read: "black body 2856 K", "daylight 6500 K", or a
    /// file or preset whose values are known.
    #[arg(long, value_name = "LIGHT")]
    pub known: Option<OsString>,
    /// Standard uncertainty of its temperature, K.
    #[arg(long, value_name = "KELVIN", requires = "known", value_parser = room_words::known_doubt)]
    pub known_doubt: Option<f64>,
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
