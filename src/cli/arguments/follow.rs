//! Options of `follow`. The comments here are what `--help` prints.

use std::{net::SocketAddr, path::PathBuf};

use clap::Args;

use crate::{
    app::live_figures::Wanted,
    cli::{options::FileOptions, words},
    live::MOST_AVERAGED,
    streams::Pace,
};

/// Options of `follow`.
#[derive(Args, Debug)]
pub(crate) struct Follow {
    /// A file that grows or is rewritten, a folder that files are written into, or - for lines on
    /// standard input. A line holds numbers between commas, tabs or blanks (wavelengths once, then
    /// values), label:value pairs, or an object with wavelength_nm, values, integration_ms, unit.
    #[arg(value_name = "SOURCE", required_unless_present_any = ["listen", "serial", "ports"],
        conflicts_with_all = ["listen", "serial", "ports"])]
    pub source: Option<PathBuf>,
    /// Take such lines over TCP: a port of this machine, or its loopback address with a port
    /// (127.0.0.1:5000); port 0 is any that is free.
    #[arg(long, value_name = "ADDRESS", value_parser = words::address,
        conflicts_with_all = ["serial", "ports"])]
    pub listen: Option<SocketAddr>,
    /// Let --listen have an address that others on the network reach.
    #[arg(long, requires = "listen", conflicts_with_all = ["source", "serial"])]
    pub listen_all: bool,
    /// Take such lines from a serial port.
    #[arg(long, value_name = "PORT", conflicts_with = "ports")]
    pub serial: Option<PathBuf>,
    /// Bits a second of the serial port, 1 to 10000000 [default: 115200].
    #[arg(long, value_name = "BAUD", requires = "serial", conflicts_with_all = ["source", "listen"],
        value_parser = |word: &str| words::whole(word, &(1..=10_000_000_u32)))]
    pub baud: Option<u32>,
    /// List the serial ports of this machine.
    #[arg(long)]
    pub ports: bool,
    /// Play the file as a recording: at times its own speed (1, 10, 0.5), or step for every frame
    /// at once.
    #[arg(long, value_name = "SPEED", value_parser = words::pace, requires = "source",
        conflicts_with_all = ["listen", "serial"])]
    pub replay: Option<Pace>,
    /// An instrument's file, as combine instrument learn or photo --save-instrument writes it:
    /// the wavelengths of lines that tell none, and the response that is taken off.
    #[arg(long, value_name = "FILE.json")]
    pub instrument: Option<PathBuf>,
    /// Figures to tell of each frame: Y, and those of light such as cct, duv, x, y, ra, r9, rf,
    /// melanopic_der, peak_nm.
    #[arg(long, value_name = "FIGURES", value_delimiter = ',', value_parser = Wanted::named,
        default_values = ["cct", "Y", "ra"])]
    pub figures: Vec<Wanted>,
    /// Average the last N frames, 1 to 64.
    #[arg(long, value_name = "N", default_value = "1",
        value_parser = |word: &str| words::whole(word, &(1..=MOST_AVERAGED)))]
    pub average: usize,
    /// Take the mean of the first N frames, 1 to 64, off the later ones, until the integration time
    /// changes.
    #[arg(long, value_name = "N",
        value_parser = |word: &str| words::whole(word, &(1..=MOST_AVERAGED)))]
    pub dark: Option<usize>,
    /// Divide by the mean of the first N frames, 1 to 64, behind those of --dark, until the
    /// integration time changes.
    #[arg(long, value_name = "N",
        value_parser = |word: &str| words::whole(word, &(1..=MOST_AVERAGED)))]
    pub reference: Option<usize>,
    /// End after N frames that were told.
    #[arg(long, value_name = "N",
        value_parser = |word: &str| words::whole(word, &(1..=u64::MAX)))]
    pub count: Option<u64>,
    /// Write the frames as they come into a recording, an object a line.
    #[arg(long, value_name = "FILE.jsonl")]
    pub record: Option<PathBuf>,
    /// Write lines, share of the glow, CCT and Y over time as CSV.
    #[arg(long, value_name = "FILE.csv", value_parser = words::path_in(&["csv"]))]
    pub tracks: Option<PathBuf>,
    /// Let --record and --tracks replace other files, except the source.
    #[arg(long)]
    pub force: bool,
    /// Take counts of an instrument as a light.
    #[arg(long)]
    pub as_light: bool,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON, an object a frame and line; its keys are stable.
    #[arg(long)]
    pub json: bool,
}

/// What the window follows.
#[derive(Args, Debug)]
pub(crate) struct Followed {
    /// Follow a light that changes in the window: a file, a folder, or - for lines on standard
    /// input (see follow).
    #[arg(long, value_name = "SOURCE", conflicts_with = "listen")]
    pub follow: Option<PathBuf>,
    /// Follow lines over TCP in the window: a port of this machine, or its loopback address with a
    /// port.
    #[arg(long, value_name = "ADDRESS", value_parser = words::address)]
    pub listen: Option<SocketAddr>,
    /// Let --listen have an address that others on the network reach.
    #[arg(long, requires = "listen")]
    pub listen_all: bool,
    /// Play the source of --follow as a recording: at times its own speed, or step for all at once.
    #[arg(long, value_name = "SPEED", value_parser = words::pace, requires = "follow")]
    pub replay: Option<Pace>,
    /// The instrument that is followed: the wavelengths of lines that tell none, and the response.
    #[arg(long, value_name = "FILE.json")]
    pub instrument: Option<PathBuf>,
}
