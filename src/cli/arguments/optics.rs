//! Options of `prism`, `rainbow` and `gem`. The comments here are what `--help` prints.

use std::{ffi::OsString, path::PathBuf};

use clap::Args;

use crate::{
    cli::{
        options::{FileOptions, ModelOptions},
        room_words, words,
    },
    color::Adaptation,
    optics::View,
};

/// Options of `prism`.
#[derive(Args, Debug)]
pub(crate) struct Prism {
    /// A light: a file (lamps.csv#2 is the second of several spectra, - is standard input), a
    /// preset's name (FL2, "CIE D65") or group/name.
    #[arg(value_name = "INPUT")]
    pub input: OsString,
    #[arg(long, value_name = "MATERIAL", default_value = "n-sf11",
        help = words::material_help("The glass"))]
    pub material: OsString,
    /// Angle between both faces, degrees, above 0 and below 180.
    #[arg(long, value_name = "DEGREES", default_value = "60",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub apex: f64,
    /// Angle from the first face's normal, degrees between -90 and 90 [default: that of the least
    /// deviation of --minimum].
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true,
        value_parser = room_words::finite, conflicts_with = "minimum")]
    pub incidence: Option<f64>,
    /// The wavelength whose deviation is to be the least, nm.
    #[arg(long, value_name = "NM", default_value = "546.075",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub minimum: f64,
    /// From the apex to where the light meets the first face, mm.
    #[arg(long, value_name = "MM", default_value = "30",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub entry: f64,
    /// From the prism to the screen, mm.
    #[arg(long, value_name = "MM", default_value = "500",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub screen: f64,
    /// Width of the slit, mm.
    #[arg(long, value_name = "MM", default_value = "0.5",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub slit: f64,
    /// The wavelength in whose way the screen stands, nm.
    #[arg(long, value_name = "NM", default_value = "546.075",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub reference: f64,
    /// Wavelengths to tell of beside the light's lines, nm, repeated or with commas.
    #[arg(long, value_name = "NM", value_delimiter = ',',
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub at: Vec<f64>,
    /// A transmittance for what the glass absorbs, a file or a preset.
    #[arg(long, value_name = "NAME", requires = "thickness")]
    pub filter: Option<OsString>,
    /// How thick that filter was, mm.
    #[arg(long, value_name = "MM", requires = "filter",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub thickness: Option<f64>,
    /// The model, whose lines are told of.
    #[command(flatten)]
    pub model: ModelOptions,
    /// Send the light's model through instead of the light as measured; lines are exact rays
    /// either way.
    #[arg(long)]
    pub as_modelled: bool,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON; its keys are stable.
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Print a table as CSV.
    #[arg(long)]
    pub csv: bool,
}

/// Options of `rainbow`.
#[derive(Args, Debug)]
pub(crate) struct Rainbow {
    /// A light: a file (- is standard input), a preset's name or group/name; its lines are told of.
    #[arg(value_name = "INPUT")]
    pub input: Option<OsString>,
    /// Wavelengths to tell of beside them, nm, repeated or with commas.
    #[arg(long, value_name = "NM", value_delimiter = ',',
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub at: Vec<f64>,
    /// Material of the drops, as in prism.
    #[arg(long, value_name = "MATERIAL", default_value = "water")]
    pub material: OsString,
    /// The model, whose lines are told of.
    #[command(flatten)]
    pub model: ModelOptions,
    /// Send the light's model through instead of the light as measured; lines are exact rays
    /// either way.
    #[arg(long)]
    pub as_modelled: bool,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON; its keys are stable.
    #[arg(long)]
    pub json: bool,
}

/// Options of `gem`.
#[derive(Args, Debug)]
pub(crate) struct Gem {
    /// The light: a file (lamps.csv#2 is the second of several spectra), a preset's name or
    /// group/name [default: CIE D65].
    #[arg(long, value_name = "NAME")]
    pub light: Option<OsString>,
    /// Instead of a light one wavelength of radiance 1, nm.
    #[arg(long, value_name = "NM", conflicts_with = "light",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub wavelength: Option<f64>,
    #[arg(long, value_name = "MATERIAL", default_value = "diamond",
        help = words::material_help("The stone"))]
    pub material: OsString,
    #[command(flatten)]
    pub cut: CutOptions,
    /// Place of the camera.
    #[command(flatten)]
    pub view: ViewOptions,
    /// Lamps on it: four soft boxes and two small lamps before a dim dome (studio), or many lamps
    /// before a dark room, as in the window (jeweller).
    #[arg(long, value_name = "LAMPS", default_value = "jeweller",
        value_parser = room_words::lamps)]
    pub lamps: room_words::Lamps,
    /// How much it absorbs a unit of length at every wavelength; a unit is the girdle's radius.
    #[arg(long, value_name = "PER_UNIT", conflicts_with = "filter",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub absorption: Option<f64>,
    /// A transmittance for what it absorbs, a file or a preset.
    #[arg(long, value_name = "NAME", requires = "thickness")]
    pub filter: Option<OsString>,
    /// How thick that filter was, in radii of the girdle.
    #[arg(long, value_name = "D", requires = "filter", conflicts_with = "absorption",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub thickness: Option<f64>,
    /// Width and height of the picture, px, 16 to 4096.
    #[arg(long, value_name = "PX", default_value = "480",
        allow_hyphen_values = true, value_parser = room_words::side)]
    pub size: usize,
    /// Rays a pixel, 1 to 65536.
    #[arg(long, value_name = "COUNT", default_value = "64",
        allow_hyphen_values = true, value_parser = room_words::rays)]
    pub rays: u32,
    /// The same seed gives the same picture, value by value.
    #[arg(long, value_name = "SEED", default_value = "1",
        allow_hyphen_values = true, value_parser = room_words::seed)]
    pub seed: u64,
    /// How many blocks across and down the JSON tells of.
    #[arg(long, value_name = "COUNT", default_value = "16",
        allow_hyphen_values = true, value_parser = room_words::blocks)]
    pub blocks: usize,
    /// Brightness of a PNG above its own exposure, in stops from -20 to 20 [default: 0].
    #[arg(long, value_name = "STOPS", allow_hyphen_values = true, value_parser = room_words::stops)]
    pub stops: Option<f64>,
    /// View of a PNG: by an eye that is used to the light after a minute, or by a daylight camera
    /// [default: eye].
    #[arg(long, value_name = "BY", value_parser = room_words::seen)]
    pub seen: Option<Adaptation>,
    /// The model, whose lines are traced.
    #[command(flatten)]
    pub model: ModelOptions,
    /// Send the light's model through instead of the light as measured; lines are exact rays
    /// either way.
    #[arg(long)]
    pub as_modelled: bool,
    /// The picture to write: .png, which may replace one that this program drew, or .exr with every wavelength.
    #[arg(long, value_name = "FILE", value_parser = words::path_in(&["png", "exr"]))]
    pub out: Option<PathBuf>,
    /// Let it replace any other file, except the inputs.
    #[arg(long, requires = "out")]
    pub force: bool,
    #[command(flatten)]
    pub files: FileOptions,
    /// Print JSON; its keys are stable.
    #[arg(long)]
    pub json: bool,
}

/// The cut of a brilliant.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct CutOptions {
    /// Width of the table, of the diameter.
    #[arg(long, value_name = "SHARE", default_value = "0.57",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub table: f64,
    /// Slope of the crown's main facets, degrees.
    #[arg(long, value_name = "DEGREES", default_value = "34.5",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub crown: f64,
    /// Slope of the pavilion's main facets, degrees.
    #[arg(long, value_name = "DEGREES", default_value = "40.75",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub pavilion: f64,
    /// How far the stars reach from the table's edge to the girdle, 0 to 1.
    #[arg(long, value_name = "SHARE", default_value = "0.5",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub star: f64,
    /// How far the lower halves reach from the girdle to the tip, 0 to 1.
    #[arg(long, value_name = "SHARE", default_value = "0.77",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub lower: f64,
    /// Height of the girdle, of the diameter.
    #[arg(long, value_name = "SHARE", default_value = "0.03",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub girdle: f64,
    /// Width of the culet, of the diameter; 0 is a tip.
    #[arg(long, value_name = "SHARE", default_value = "0",
        allow_hyphen_values = true, value_parser = room_words::finite)]
    pub culet: f64,
}

/// Where a gem is looked at from; lengths are radii of its girdle, z goes up from it.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct ViewOptions {
    /// A view by its name: A, down on the crown from the front [default: A].
    #[arg(long, value_name = "VIEW", value_parser = room_words::view,
        conflicts_with_all = ["from", "towards", "angle"])]
    pub view: Option<View>,
    /// Where the camera is, in radii of the girdle, z up [default: 0,-4.6,7.2].
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = room_words::place)]
    pub from: Option<[f64; 3]>,
    /// What it looks at [default: 0,0,-0.2].
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = room_words::place)]
    pub towards: Option<[f64; 3]>,
    /// How wide it looks, degrees [default: 16].
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, value_parser = room_words::finite)]
    pub angle: Option<f64>,
}
