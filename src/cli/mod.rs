//! The same engine without a window: arguments in, words, JSON and files out.
//!
//! ```text
//! spectral-explorer [FILES] [--window]          the window, opened by the caller
//! spectral-explorer report|light|sweep|race|product|gem|read|list ...   one command a file
//! ```
//!
//! Everything is written to what the caller hands in, and pictures are made by the caller's
//! [`Pictures`], so that nothing here knows of a window. A refusal is one line on `err` that says
//! what was found and what was expected.

mod against;
mod arguments;
mod asked_lights;
mod auction;
mod combine;
mod combine_inputs;
mod combine_instrument;
mod combine_json;
mod convert;
mod decode;
mod encode;
mod factor;
mod fit;
mod folder;
mod follow;
mod follow_source;
mod gem;
mod inputs;
mod lessons;
mod light;
mod list;
mod material;
mod mix;
mod no_display;
mod options;
mod peaks;
mod photo;
mod photo_words;
mod picture;
mod picture_input;
mod picture_relit;
mod plot;
mod prism;
mod product;
mod race;
mod rainbow;
mod read;
mod recover;
mod recover_image;
mod refusal;
mod render;
mod repeats;
mod report;
mod room_words;
mod subject;
mod sweep;
mod target;
mod unused;
mod viewing;
mod watch;
mod window;
mod words;

use std::{
    ffi::OsString,
    io::{self, Write},
    path::Path,
};

use clap::{CommandFactory, FromArgMatches};
use serde_json::Value;

use crate::{
    app::{App, Library, chart::Theme, licences, workspace::Preferences},
    io::shown,
};
use arguments::{Arguments, Command};
use inputs::Inputs;
pub use no_display::without_display;
use refusal::Refusal;
pub use window::{Input, app_with};

/// What messages and `--version` call the program.
pub const PROGRAM: &str = env!("CARGO_PKG_NAME");

/// What is left to do for the caller.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Nothing; leave with this exit code.
    Done(u8),
    /// Open the window.
    Window {
        /// What to open in it.
        files: Vec<Input>,
        /// A missing display is an error.
        insist: bool,
    },
}

/// Who draws pictures: the window's own painter, handed in by the caller. A build without the
/// window has none.
pub trait Pictures {
    /// The whole window as PNG, `size` in px.
    fn window(&self, app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8>;
    /// The spectrum plot alone as PNG, `size` in px.
    fn plot(&self, app: &App, theme: Theme, size: [u32; 2]) -> Vec<u8>;
    /// Names of all that the window shows, as screen readers are told them, controls first; `None`
    /// where nobody can tell.
    fn names(&self, _app: &App, _preferences: &Preferences) -> Option<Vec<String>> {
        None
    }
}

/// Carries out a command line; `args` begins with the program's own name.
///
/// Exit codes: 0 done (also when the reader of `out` went away), 1 an input or a place to write
/// to was bad, 2 the arguments were.
pub fn run(
    args: impl IntoIterator<Item = OsString>,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Outcome {
    let understood = Arguments::command()
        .try_get_matches_from(args)
        .and_then(|matches| Ok((Arguments::from_arg_matches(&matches)?, matches)));
    let done = match understood {
        Ok((mut arguments, matches)) => {
            let mut inputs = Inputs::new(&mut *err);
            let files = arguments.command.as_ref().and_then(Command::files);
            inputs.read_as(files.unwrap_or_default());
            let unused = unused::of(&matches);
            unused::say(&unused, &mut inputs);
            if let Some(model) = arguments.command.as_mut().and_then(Command::model) {
                unused.iter().for_each(|(option, _)| model.forget(option));
            }
            match carry_out(arguments, pictures, out, &mut inputs) {
                Ok(outcome) => {
                    inputs.tell_notes();
                    return outcome;
                }
                Err(refusal) => Err(refusal),
            }
        }
        Err(error) => refusal::of_clap(&error).and_then(|text| print(out, &text)),
    };
    Outcome::Done(match done {
        Ok(()) => 0,
        Err(refusal) => refusal.tell(err),
    })
}

fn carry_out(
    arguments: Arguments,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<Outcome, Refusal> {
    match arguments {
        Arguments {
            licences: true,
            files,
            window,
            ..
        } => {
            let window = window.then(|| "--window".to_owned());
            let files = files.iter().map(|file| shown(Path::new(file)));
            for word in files.chain(window) {
                inputs.note(format!("{word} is not used: --licences opens nothing"));
            }
            print(out, &licences::text(Library::bundled()))?;
        }
        Arguments {
            command: Some(command),
            ..
        } => match command {
            Command::Report(options) => report::run(&options, out, inputs)?,
            Command::Light(options) => light::run(&options, out, inputs)?,
            Command::Sweep(options) => sweep::run(&options, out, inputs)?,
            Command::Auction(options) => auction::run(&options, out, inputs)?,
            Command::Race(options) => race::run(&options, out, inputs)?,
            Command::Product(options) => product::run(&options, out, inputs)?,
            Command::Combine(options) => combine::run(&options, out, inputs)?,
            Command::Recover(options) => recover::run(&options, out, inputs)?,
            Command::Mix(options) => mix::run(&options, out, inputs)?,
            Command::Encode(options) => encode::run(&options, out, inputs)?,
            Command::Decode(options) => decode::run(&options, out, inputs)?,
            Command::Prism(options) => prism::run(&options, out, inputs)?,
            Command::Rainbow(options) => rainbow::run(&options, out, inputs)?,
            Command::Gem(options) => gem::run(&options, out, inputs)?,
            Command::Photo(options) => return photo::run(&options, out, inputs).map(Outcome::Done),
            Command::Picture(options) => picture::run(&options, out, inputs)?,
            Command::Fit(options) => fit::run(&options, out, inputs)?,
            Command::Follow(options) => follow::run(&options, out, inputs)?,
            Command::Read(options) => read::run(&options, out, inputs)?,
            Command::Peaks(options) => peaks::run(&options, out, inputs)?,
            Command::List(options) => list::run(options, out, inputs)?,
            Command::Lessons(options) => lessons::run(&options, pictures, out)?,
            Command::Render(options) => render::run(&options, pictures, out, inputs)?,
            Command::Plot(options) => plot::run(&options, pictures, out, inputs)?,
            Command::Convert(options) => convert::run(&options, out, inputs)?,
        },
        Arguments { files, window, .. } => {
            return Ok(Outcome::Window {
                files: window::inputs(&files)?,
                insist: window,
            });
        }
    }
    Ok(Outcome::Done(0))
}

/// What draws pictures, for a command that cannot do without; `whose` names it.
fn painter<'p>(
    pictures: Option<&'p dyn Pictures>,
    whose: &str,
) -> Result<&'p dyn Pictures, Refusal> {
    pictures.ok_or_else(|| {
        Refusal::Usage(format!(
            "{whose}: found a build without the window, which draws it, expected one with it \
             (cargo build --release); plot --out FILE.svg needs none"
        ))
    })
}

/// Prints text and brings it out.
fn print(out: &mut dyn Write, text: &str) -> Result<(), Refusal> {
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(Refusal::Output)
}

/// Prints JSON as every command has it: indented, with a line end.
fn print_json(out: &mut dyn Write, json: &Value) -> Result<(), Refusal> {
    print(out, &format!("{json:#}\n"))
}

/// Says something that is no part of the result, on a line of its own.
///
/// Nobody may be listening, and there is nowhere else to say so.
fn remark(err: &mut dyn Write, text: &str) {
    let _: io::Result<()> = writeln!(err, "{PROGRAM}: {}", refusal::in_one_line(text));
}
