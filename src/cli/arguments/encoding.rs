//! Options of `encode` and `decode`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::{
    cli::{options::PickOptions, room_words, words},
    color::Observer,
    spectrum::Band,
};

/// Options of `encode`.
#[derive(Args, Debug)]
pub(crate) struct Encode {
    /// A light: a file (- is standard input), a preset's name (FL2, "CIE D65") or group/name.
    #[arg(value_name = "INPUT")]
    pub input: OsString,
    /// Most numbers that the light may take, 3 to 64.
    #[arg(long, value_name = "N", default_value = "20",
        allow_negative_numbers = true, value_parser = room_words::whole_number)]
    pub numbers: usize,
    /// Without known lamps: the formula alone then decodes the words.
    #[arg(long)]
    pub portable: bool,
    /// Count a known lamp's index and a line's width as numbers of their own; the words are then
    /// fewer.
    #[arg(long)]
    pub strict: bool,
    #[command(flatten)]
    pub pick: PickOptions,
    /// Range that is encoded, in whole nm, at most 4000; decoding words needs the same [default:
    /// 380:780].
    #[arg(long, value_name = "MIN:MAX", allow_hyphen_values = true, value_parser = words::range)]
    pub range: Option<Band>,
    #[arg(long, value_name = "OBSERVER", value_parser = words::observer,
        help = words::observer_help())]
    pub observer: Option<Observer>,
    /// Print JSON; its keys are stable.
    #[arg(long)]
    pub json: bool,
}

/// Options of `decode`.
#[derive(Args, Debug)]
pub(crate) struct Decode {
    /// Words of eight hexadecimal digits each, or a file with them or with the JSON of encode
    /// (- is standard input).
    #[arg(value_name = "WORDS|FILE", required = true)]
    pub words: Vec<OsString>,
    /// Range that was encoded, in whole nm: words do not hold it, JSON does [default: 380:780].
    #[arg(long, value_name = "MIN:MAX", allow_hyphen_values = true, value_parser = words::range)]
    pub range: Option<Band>,
    /// The spectrum to write: .csv, .json, .sp (Argyll), .spd or .spdx.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Let it replace a file that exists.
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Print JSON; its keys are those of encode without error.
    #[arg(long)]
    pub json: bool,
}
