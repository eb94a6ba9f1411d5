//! Options of `recover` and `mix`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::{
    cli::{options::FileOptions, room_words, words},
    color::Srgb,
    design::{
        recover::Method,
        solve::{Against, Objective},
    },
};

/// Options of `recover`.
#[derive(Args, Debug)]
pub(crate) struct Recover {
    /// The colour as a screen shows it, adapted to the light: #rrggbb.
    #[arg(long, value_name = "HEX", value_parser = room_words::colour,
        conflicts_with_all = ["xyz", "lab", "image"])]
    pub colour: Option<Srgb>,
    /// The colour as XYZ, Y = 100 for the light.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = room_words::place,
        conflicts_with_all = ["lab", "image"])]
    pub xyz: Option<[f64; 3]>,
    /// The colour as L*a*b* against the light.
    #[arg(long, value_name = "L,A,B", allow_hyphen_values = true, value_parser = room_words::lab,
        conflicts_with = "image")]
    pub lab: Option<[f64; 3]>,
    /// The light that the surface is seen under, a file or a preset [default: CIE D65].
    #[arg(long, value_name = "LIGHT")]
    pub light: Option<OsString>,
    /// The same surface's colour under a second light: #rrggbb.
    #[arg(long, value_name = "HEX", value_parser = room_words::colour,
        conflicts_with_all = ["second_xyz", "second_lab"])]
    pub second_colour: Option<Srgb>,
    /// The same as XYZ, Y = 100 for the second light.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = room_words::place,
        conflicts_with = "second_lab")]
    pub second_xyz: Option<[f64; 3]>,
    /// The same as L*a*b* against the second light.
    #[arg(long, value_name = "L,A,B", allow_hyphen_values = true, value_parser = room_words::lab)]
    pub second_lab: Option<[f64; 3]>,
    /// The second light, a file or a preset.
    #[arg(long, value_name = "LIGHT", conflicts_with = "image")]
    pub second_light: Option<OsString>,
    /// Way: smoothest, fourier3, fourier6 (two colours) or lines (a light of that colour) [default:
    /// smoothest].
    #[arg(long, value_name = "METHOD", value_parser = room_words::method, conflicts_with = "image")]
    pub method: Option<Method>,
    /// Places of the lines for --method lines, nm, with commas [default: 405,436,546,578].
    #[arg(long, value_name = "NM", value_delimiter = ',', allow_hyphen_values = true,
        value_parser = room_words::finite)]
    pub lines: Vec<f64>,
    /// The light whose shape is behind the lines [default: the smooth part of FL2].
    #[arg(long, value_name = "LIGHT")]
    pub background: Option<OsString>,
    /// Instead of a colour a picture of colours: a PNG file.
    #[arg(long, value_name = "FILE.png", requires = "out")]
    pub image: Option<PathBuf>,
    /// The spectral picture to write, .exr.
    #[arg(long, value_name = "FILE.exr", requires = "image",
        conflicts_with_all = ["colour", "xyz", "lab"], value_parser = words::path_in(&["exr"]))]
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

/// Options of `mix`.
#[derive(Args, Debug)]
pub(crate) struct Mix {
    /// A channel: line:546.1, gauss:450,20 (centre and full width at half height), blackbody:2700,
    /// daylight:6500, or a light by its file or name; =WEIGHT behind it fixes its power.
    #[arg(
        long = "channel",
        value_name = "SPEC",
        required_unless_present = "front"
    )]
    pub channels: Vec<String>,
    /// The colour: a temperature (6500K), x,y or a light whose colour is met and whose spectrum is
    /// come near to [default: weights as fixed, 1 where not; for --front 4000K].
    #[arg(long, value_name = "TARGET", allow_hyphen_values = true)]
    pub target: Option<String>,
    /// How far off the blackbodies' locus a temperature is, -0.05 to 0.05, positive towards green.
    #[arg(long, value_name = "DUV", requires = "target", allow_hyphen_values = true,
        value_parser = room_words::finite)]
    pub duv: Option<f64>,
    /// The goal: ler, rf, ra, melanopic or fewest; by rf and ra the best of several searches
    /// [default: rf].
    #[arg(long, value_name = "FIGURE", value_parser = room_words::favour, conflicts_with = "front")]
    pub favour: Option<Objective>,
    /// Floors that hold, such as rf=80, ra=90, ler=300 or melanopic=0.5; repeated.
    #[arg(long = "floor", value_name = "FIGURE=VALUE", conflicts_with = "front")]
    pub floors: Vec<String>,
    /// Instead of channels: the best trade of rf or ra for ler that is found with lines free to move:
    /// rf,ler or ra,ler.
    #[arg(long, value_name = "FIGURES", value_parser = room_words::against, conflicts_with = "channels",
        requires = "lines")]
    pub front: Option<Against>,
    /// How many lines each light of the front has, 2 to 8.
    #[arg(long, value_name = "COUNT", requires = "front", conflicts_with = "channels",
        allow_negative_numbers = true,
        value_parser = room_words::free_lines)]
    pub lines: Option<usize>,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON; its keys are stable.
    #[arg(long)]
    pub json: bool,
}
