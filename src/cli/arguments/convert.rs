//! Options of `convert`.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::cli::{
    options::{ModelOptions, PickOptions},
    words::{self, Form},
};

/// Options of `convert`.
#[derive(Args, Debug)]
pub(crate) struct Convert {
    /// A file (- is standard input), a preset's name or group/name.
    #[arg(value_name = "IN")]
    pub input: OsString,
    /// The file to write: .csv, .json, .sp (Argyll), .spd, .spdx, or .txt (a model in one line);
    /// a new one, never the one that is read.
    #[arg(value_name = "OUT")]
    pub out: PathBuf,
    /// Let OUT replace a file that exists.
    #[arg(long)]
    pub force: bool,
    /// Write the samples (spectrum) or the model (composite, as .json or .txt only)
    /// [default: composite for .txt, for OUT.composite.json, or for .json from a composite].
    #[arg(long = "as", value_name = "FORM", value_parser = words::form)]
    pub form: Option<Form>,
    /// Write all spectra of the file, a column each; into .csv only. Without it one of several
    /// must be named by --spectrum.
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub pick: PickOptions,
    /// The model, where one is written.
    #[command(flatten)]
    pub model: ModelOptions,
}
