//! What may be followed, and the instrument that it is read through.

use std::{
    fs::{self, File},
    net::SocketAddr,
    path::{Path, PathBuf},
};

use crate::{
    app::{instruments, photograph},
    io::{
        Choices, name_of, shown,
        stream::{ITS_NAME, is_standard_input, is_stream},
        why_unopened,
    },
    measurements::Instrument,
    streams::{
        FileSource, FolderSource, Lines, ListenError, Pace, Reach, Replay, Source, listen, piped,
    },
};

/// A source of spectra that change.
#[derive(Clone, Debug, PartialEq)]
pub enum Asked {
    /// A file that changes, a folder, a pipe, or `-` for standard input.
    Path(PathBuf),
    /// A recording.
    Replay(PathBuf, Pace),
    /// Lines that are sent to an address over TCP.
    Tcp(SocketAddr, Reach),
    /// Lines of a serial port, at bits a second.
    Serial(PathBuf, u32),
}

/// Why nothing is followed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotFollowed {
    /// It must not be asked for so.
    Asked(String),
    /// What was found, and what was expected.
    Found(String),
}

impl NotFollowed {
    pub fn words(self) -> String {
        match self {
            Self::Asked(why) | Self::Found(why) => why,
        }
    }
}

/// What an instrument's file says.
#[derive(Clone, Debug, Default)]
pub struct Through {
    /// Its response, where it has one for lines.
    pub response: Option<Instrument>,
    /// Wavelengths of lines that tell none, nm.
    nm: Option<Vec<f64>>,
}

/// What is said of an instrument of photographs.
pub const ONLY_ITS_AXIS: &str = "its response is that of pictures; only its wavelengths are used";

impl Through {
    /// The instrument in the text of a file: of measurements, with its response, or of photographs.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn of_text(path: &Path, text: &str) -> Result<Self, String> {
        let why = match instruments::json_of(text).and_then(|all| instruments::of(&all)) {
            Ok(response) => {
                return Ok(Self {
                    nm: Some(response.factor.samples.nm().to_vec()),
                    response: Some(response),
                });
            }
            Err(why) => why,
        };
        let photograph = photograph::Instrument::read(text);
        let photograph = photograph.map_err(|_| format!("{}: {why}", shown(path)))?;
        Ok(Self {
            response: None,
            nm: Some(photograph.wavelengths()),
        })
    }

    /// The same of a file.
    ///
    /// # Errors
    /// As [`Self::of_text`].
    pub fn read(path: &Path) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|error| unopened(path, &error))?;
        Self::of_text(path, &text)
    }

    /// True for an instrument that corrects no more than the axis.
    pub fn is_axis_alone(&self) -> bool {
        self.nm.is_some() && self.response.is_none()
    }

    fn lines(&self, name: &str) -> Result<Lines, NotFollowed> {
        let lines = Lines::new(name);
        match &self.nm {
            None => Ok(lines),
            Some(nm) => lines
                .on_axis(nm.clone())
                .map_err(|why| NotFollowed::Found(tr!("the instrument: {why}", why))),
        }
    }
}

fn unopened(path: &Path, error: &std::io::Error) -> String {
    let (found, expected) = why_unopened(path, error);
    tr!(
        "{path}: found {found}, expected {expected}",
        path = shown(path),
        found,
        expected
    )
}

impl Asked {
    /// Opens it; a file is read with the decisions of a person.
    ///
    /// # Errors
    /// Why it cannot be followed.
    pub fn open(
        &self,
        through: &Through,
        choices: &Choices,
    ) -> Result<Box<dyn Source>, NotFollowed> {
        let path = match self {
            Self::Tcp(address, reach) => {
                let source = listen(*address, *reach, through.lines("TCP")?);
                let source = source.map_err(|why| match why {
                    ListenError::NotLoopback(_) => NotFollowed::Asked(why.to_string()),
                    ListenError::Taken { .. } => NotFollowed::Found(why.to_string()),
                })?;
                return Ok(Box::new(source));
            }
            Self::Serial(path, baud) => return serial(path, *baud, through),
            Self::Path(path) | Self::Replay(path, _) => path,
        };
        if is_standard_input(path) {
            let lines = through.lines(ITS_NAME)?;
            return Ok(Box::new(piped(std::io::stdin(), ITS_NAME, lines)));
        }
        let unopened = |error: std::io::Error| NotFollowed::Found(unopened(path, &error));
        let lines = through.lines(&path.file_stem().unwrap_or_default().to_string_lossy())?;
        if is_stream(path) {
            let pipe = File::open(path).map_err(unopened)?;
            return Ok(Box::new(piped(pipe, &name_of(path), lines)));
        }
        let is_folder = fs::metadata(path).map_err(unopened)?.is_dir();
        if let Self::Replay(_, pace) = self {
            let replay = match is_folder {
                true => Err(said!("found a folder, expected a recording").to_owned()),
                false => Replay::open(path, *pace, lines),
            };
            let replay =
                replay.map_err(|why| NotFollowed::Found(format!("{}: {why}", shown(path))))?;
            return Ok(Box::new(replay));
        }
        Ok(match is_folder {
            true => Box::new(FolderSource::new(path, choices).with_lines(lines)),
            false => Box::new(FileSource::new(path, choices).with_lines(lines)),
        })
    }
}

#[cfg(feature = "serial")]
fn serial(path: &Path, baud: u32, through: &Through) -> Result<Box<dyn Source>, NotFollowed> {
    let lines = through.lines(&name_of(path))?;
    let source = crate::streams::Serial::open(path.to_owned(), baud, lines);
    Ok(Box::new(source.map_err(NotFollowed::Found)?))
}

/// What a build without serial ports says.
#[cfg(not(feature = "serial"))]
const NO_SERIAL: &str =
    later!("found a build without serial ports, expected one with the feature serial");

#[cfg(not(feature = "serial"))]
fn serial(_: &Path, _: u32, _: &Through) -> Result<Box<dyn Source>, NotFollowed> {
    Err(NotFollowed::Asked(
        crate::languages::said(NO_SERIAL).to_owned(),
    ))
}

/// The serial ports of this machine.
///
/// # Errors
/// A build that knows none.
#[cfg(feature = "serial")]
pub fn ports() -> Result<Vec<PathBuf>, String> {
    Ok(crate::streams::ports())
}

#[cfg(not(feature = "serial"))]
pub fn ports() -> Result<Vec<PathBuf>, String> {
    Err(crate::languages::said(NO_SERIAL).to_owned())
}
