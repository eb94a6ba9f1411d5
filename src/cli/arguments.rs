//! What may stand on the command line. The comments here are what `--help` prints.

mod convert;
mod design;
mod encoding;
mod follow;
mod lessons;
mod measurements;
mod numbers;
mod optics;
mod photo;
mod pictures;

use std::{ffi::OsString, path::PathBuf};

use clap::{Args, Parser, Subcommand};

use super::{
    options::{FileOptions, ModelOptions, PickOptions},
    words,
};
use crate::{
    app::{chart::Theme, pages::Page},
    languages::Language,
    spectrum::Kind,
};

pub(super) use convert::Convert;
pub(super) use design::{Mix, Recover};
pub(super) use encoding::{Decode, Encode};
pub(super) use follow::{Follow, Followed};
pub(super) use lessons::{LessonAct, Lessons};
pub(super) use measurements::{Combine, Stated};
pub(super) use numbers::{Auction, Product, Race, Sweep};
pub(super) use optics::{CutOptions, Gem, Prism, Rainbow, ViewOptions};
pub(super) use photo::Photo;
pub(super) use pictures::{Fit, Picture};

/// Opens light spectra and shows their parts: a short series and a few lines.
///
/// With no command it opens the window, with the given files, folders or presets in it.
#[derive(Parser, Debug)]
#[command(
    name = super::PROGRAM,
    version,
    propagate_version = true,
    args_conflicts_with_subcommands = true
)]
pub(super) struct Arguments {
    /// Files, folders whose files are opened together, or names of presets.
    #[arg(value_name = "FILES")]
    pub files: Vec<OsString>,
    /// A missing display is an error (exit code 3) instead of a reason to work without.
    #[arg(long)]
    pub window: bool,
    #[command(flatten)]
    pub followed: Followed,
    /// Print the licences of program, data and fonts.
    #[arg(long)]
    pub licences: bool,
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// What can be done without a window.
#[derive(Subcommand, Debug)]
pub(super) enum Command {
    /// Print the model of a spectrum, its error and its colour.
    Report(Report),
    /// Print every figure of lights and of their models: CCT, Ra, Rf, melanopic ratio, ...
    Light(Light),
    /// Print error against numbers: every count of waves in every basis, with and without lines.
    Sweep(Sweep),
    /// Print what the next numbers buy best: a wave, a line or the lines' widths.
    Auction(Auction),
    /// Print the composite beside other representations at equal counts of numbers.
    Race(Race),
    /// Print a light through filters and off surfaces, exact beside the model.
    Product(Product),
    /// Combine measurements: sums, quotients, means of scans with their doubt, spliced ranges.
    Combine(Combine),
    /// Print the spectrum of a surface or a light from its colour.
    Recover(Recover),
    /// Print how channels mix to a light of a colour.
    Mix(Mix),
    /// Print a light in few words: known lamps, a short series and lines of their own width.
    Encode(Encode),
    /// Write the spectrum that such words stand for.
    Decode(Decode),
    /// Print where a light's lines land behind a prism.
    Prism(Prism),
    /// Print where the bows of a light's lines appear.
    Rainbow(Rainbow),
    /// Trace a brilliant under a light, and say how noisy the picture is.
    Gem(Gem),
    /// Read the spectrum in a photograph of one: its axis by the lines of a lamp, or by pins.
    Photo(Photo),
    /// Keep a spectral picture in few numbers a pixel, or show one under another light.
    Picture(Picture),
    /// Write tables of many spectra in few numbers each.
    Fit(Fit),
    /// Print figures of spectra as they come: from a file that changes, a folder, a stream.
    Follow(Follow),
    /// Print what files hold and how they were read.
    Read(Read),
    /// List the shipped spectra.
    List(List),
    /// List the lessons, check one, or write a sheet for a class.
    Lessons(Lessons),
    /// Save a picture of the window; needs no display.
    Render(Render),
    /// Save the plot of a spectrum and its model as SVG or PNG.
    Plot(Plot),
    /// Write a spectrum, or its model, in another format.
    Convert(Convert),
}

impl Command {
    /// How the command's files are read; `None` for one that reads none.
    pub(super) fn files(&self) -> Option<FileOptions> {
        match self {
            Self::Report(options) => Some(options.pick.files),
            Self::Light(options) => Some(options.files),
            Self::Sweep(options) => Some(options.pick.files),
            Self::Auction(options) => Some(options.pick.files),
            Self::Race(options) => Some(options.pick.files),
            Self::Product(options) => Some(options.files),
            Self::Combine(options) => Some(options.files),
            Self::Recover(options) => Some(options.files),
            Self::Mix(options) => Some(options.files),
            Self::Encode(options) => Some(options.pick.files),
            Self::Prism(options) => Some(options.files),
            Self::Rainbow(options) => Some(options.files),
            Self::Gem(options) => Some(options.files),
            Self::Picture(options) => Some(options.files),
            Self::Fit(options) => Some(options.files),
            Self::Follow(options) => Some(options.files),
            Self::Read(options) => Some(options.files),
            Self::Render(options) => Some(options.pick.files),
            Self::Plot(options) => Some(options.pick.files),
            Self::Convert(options) => Some(options.pick.files),
            Self::Decode(_) | Self::Photo(_) | Self::List(_) | Self::Lessons(_) => None,
        }
    }

    /// The model's options; `None` for a command that has none.
    pub(super) fn model(&mut self) -> Option<&mut ModelOptions> {
        match self {
            Self::Report(options) => Some(&mut options.model),
            Self::Light(options) => Some(&mut options.model),
            Self::Sweep(options) => Some(&mut options.model),
            Self::Auction(options) => Some(&mut options.model),
            Self::Race(options) => Some(&mut options.model),
            Self::Product(options) => Some(&mut options.model),
            Self::Prism(options) => Some(&mut options.model),
            Self::Rainbow(options) => Some(&mut options.model),
            Self::Gem(options) => Some(&mut options.model),
            Self::Render(options) => Some(&mut options.model),
            Self::Plot(options) => Some(&mut options.model),
            Self::Convert(options) => Some(&mut options.model),
            Self::Combine(_)
            | Self::Recover(_)
            | Self::Mix(_)
            | Self::Encode(_)
            | Self::Decode(_)
            | Self::Photo(_)
            | Self::Picture(_)
            | Self::Fit(_)
            | Self::Follow(_)
            | Self::Read(_)
            | Self::List(_)
            | Self::Lessons(_) => None,
        }
    }
}

/// Options of `read`.
#[derive(Args, Debug)]
pub(super) struct Read {
    /// Files, or folders whose files are read; - is standard input.
    #[arg(value_name = "FILE", required = true)]
    pub inputs: Vec<PathBuf>,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON, a list with one object a file; its keys are stable.
    #[arg(long)]
    pub json: bool,
}

/// Options of `report`.
#[derive(Args, Debug)]
pub(super) struct Report {
    /// A file (- is standard input), a preset's name (FL2, "CIE D65") or group/name
    /// (paper/Mercury).
    #[arg(value_name = "INPUT")]
    pub input: OsString,
    /// More scans of the same light, with --repeats.
    #[arg(value_name = "SCAN", requires = "repeats")]
    pub scans: Vec<OsString>,
    /// All inputs are scans of one light: their mean is reported, each figure with its doubt.
    #[arg(long)]
    pub repeats: bool,
    #[command(flatten)]
    pub stated: Stated,
    #[command(flatten)]
    pub pick: PickOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// Print JSON; its keys are stable. Shares are fractions of 1 and not per cent: all of error,
    /// share_of_power.
    #[arg(long)]
    pub json: bool,
}

/// Options of `light`.
#[derive(Args, Debug)]
pub(super) struct Light {
    /// Lights: files (lamps.csv#2 is the second of several spectra, - is standard input), folders
    /// with such files, presets' names (FL2, "CIE D65") or group/name. A file means all its lights.
    /// TLCI is left out: the camera and sample tables of EBU Tech 3355 are not openly licensed.
    #[arg(value_name = "INPUT", required = true)]
    pub lights: Vec<OsString>,
    /// All inputs are scans of one light: their mean is told, each figure with its doubt.
    #[arg(long, conflicts_with_all = ["csv", "against"])]
    pub repeats: bool,
    #[command(flatten)]
    pub stated: Stated,
    #[command(flatten)]
    pub files: FileOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// Print JSON; its keys are stable. One light is an object; several, and a folder, are a list.
    #[arg(long)]
    pub json: bool,
    /// Print CSV, a line a light, for one light too [default: words for one light, CSV for
    /// several and for a folder].
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,
    /// With --json also what has no key there: absolute values such as lux and PPFD, other
    /// observers, every sample of TM-30, the shape, and the reasons by key.
    #[arg(long, requires = "json", conflicts_with = "csv")]
    pub full: bool,
    /// Compare one INPUT with this light, a file or a name: which is better for what. With --json
    /// both lights' figures stand beside it.
    #[arg(long, value_name = "LIGHT", conflicts_with = "csv")]
    pub against: Option<OsString>,
}

/// Options of `list`.
#[derive(Args, Clone, Debug)]
pub(super) struct List {
    /// Only this kind: light, reflectance, transmittance, absorbance, weighting, lines or other
    /// [default: the first three, which the other commands take].
    #[arg(long, value_name = "KIND", value_parser = words::any_kind)]
    pub kind: Option<Kind>,
    /// Only matches of these words, the best first: a name, a family, an element, a use ("street
    /// lamp", neon, skin), a colour temperature ("2700 K"), a figure ("led Ra 90"), a German,
    /// French or Spanish word (Kerze); twins of one lamp are one line.
    #[arg(long, value_name = "WORDS")]
    pub search: Option<String>,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
}

/// Options of `render`.
#[derive(Args, Debug)]
pub(super) struct Render {
    /// A file (- is standard input), a preset's name or group/name [default: what the window
    /// shows at first].
    #[arg(value_name = "INPUT")]
    pub input: Option<OsString>,
    #[command(flatten)]
    pub pick: PickOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// A second light beside the INPUT, a file or a name: it is compared with this one.
    #[arg(long, value_name = "LIGHT")]
    pub against: Option<OsString>,
    /// The picture to write; it may replace one that this program drew.
    #[arg(long, value_name = "FILE.png", value_parser = words::path_in(&["png"]))]
    pub out: PathBuf,
    /// Let it replace any other file, except the inputs.
    #[arg(long)]
    pub force: bool,
    /// Width and height in px.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x800", value_parser = words::size)]
    pub size: [u32; 2],
    /// dark or light.
    #[arg(long, value_name = "THEME", default_value = "dark", value_parser = words::theme)]
    pub theme: Theme,
    /// The window's language: en, de, es or fr.
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = words::language)]
    pub language: Language,
    // The help is made of the one list of pages.
    #[arg(long, value_name = "PAGE", default_value = "look", value_parser = words::page,
        help = words::help_on_pages())]
    pub page: Page,
    /// A lesson that is being taken: its name or its file, at its first step or another (waves:2,
    /// mine.json:2). It brings its own light and page.
    #[arg(long, value_name = "LESSON[:STEP]")]
    pub lesson: Option<String>,
    /// The step with its task done and its answer told.
    #[arg(long, requires = "lesson")]
    pub done: bool,
    /// As the page is presented to a class (F5): its main picture and its main controls, large.
    #[arg(long)]
    pub present: bool,
    /// Play this recording to its end first (as follow --record writes it): the page live shows it.
    #[arg(long, value_name = "FILE.jsonl", conflicts_with = "lesson")]
    pub follow: Option<PathBuf>,
}

/// Options of `plot`.
#[derive(Args, Debug)]
pub(super) struct Plot {
    /// A file (- is standard input), a preset's name or group/name.
    #[arg(value_name = "INPUT")]
    pub input: OsString,
    #[command(flatten)]
    pub pick: PickOptions,
    #[command(flatten)]
    pub model: ModelOptions,
    /// A second light beside the INPUT, a file or a name: it is compared with this one.
    #[arg(long, value_name = "LIGHT")]
    pub against: Option<OsString>,
    /// The picture to write, .svg or .png, with --sheet .svg or .pdf; it may replace one that
    /// this program drew.
    #[arg(long, value_name = "FILE", value_parser = words::plot_path())]
    pub out: PathBuf,
    /// One page about the light in place of its plot: what it is, how good it is, its colours, the
    /// numbers of its model. A4; --size and --theme are not used.
    #[arg(long)]
    pub sheet: bool,
    /// The model in one line, rounded so that its colour stays within dE 0.1, as a QR code in place
    /// of the plot; --size and --theme are not used.
    #[arg(long, conflicts_with_all = ["sheet", "against"])]
    pub qr: bool,
    /// Let it replace any other file, except the inputs.
    #[arg(long)]
    pub force: bool,
    /// Width and height in px.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x800", value_parser = words::size)]
    pub size: [u32; 2],
    /// dark or light.
    #[arg(long, value_name = "THEME", default_value = "light", value_parser = words::theme)]
    pub theme: Theme,
}
