//! Where the frames of `follow` come from, and through which instrument they are read.

use std::{fs::File, path::Path};

use super::{arguments::Follow, inputs::Inputs, refusal::Refusal};
use crate::{
    app::{instruments, photograph},
    io::{
        Choices, FileSource, FolderSource, Lines, Reach, Replay, Source, listen, name_of, piped,
        shown,
        stream::{ITS_NAME, is_standard_input, is_stream},
        why_unopened,
    },
    measurements::Instrument,
};

/// What an instrument's file says.
#[derive(Default)]
pub(super) struct Through {
    /// Its response, where it has one for lines.
    pub response: Option<Instrument>,
    /// Wavelengths of lines that tell none, nm.
    nm: Option<Vec<f64>>,
}

impl Through {
    /// The instrument of `--instrument`.
    ///
    /// # Errors
    /// [`Refusal::File`] for a file that is none.
    pub(super) fn of(options: &Follow, inputs: &mut Inputs) -> Result<Self, Refusal> {
        let Some(path) = &options.instrument else {
            return Ok(Self::default());
        };
        let refused = |why: String| Refusal::File(format!("--instrument: {why}"));
        let text = inputs.text(path).map_err(refused)?;
        let why = match instruments::json_of(&text).and_then(|all| instruments::of(&all)) {
            Ok(response) => {
                return Ok(Self {
                    nm: Some(response.factor.samples.nm().to_vec()),
                    response: Some(response),
                });
            }
            Err(why) => why,
        };
        let photograph = photograph::Instrument::read(&text);
        let photograph = photograph.map_err(|_| refused(format!("{}: {why}", shown(path))))?;
        inputs
            .note("--instrument: its response is that of pictures; only its wavelengths are used");
        Ok(Self {
            response: None,
            nm: Some(photograph.wavelengths()),
        })
    }

    fn lines(&self, name: &str) -> Result<Lines, Refusal> {
        let lines = Lines::new(name);
        match &self.nm {
            None => Ok(lines),
            Some(nm) => lines
                .on_axis(nm.clone())
                .map_err(|why| Refusal::File(format!("--instrument: {why}"))),
        }
    }
}

/// The source of frames.
///
/// # Errors
/// [`Refusal`] for a file that is not there, an address that nothing can listen at, a serial port
/// that does not open.
pub(super) fn source(
    options: &Follow,
    through: &Through,
    inputs: &mut Inputs,
) -> Result<Box<dyn Source>, Refusal> {
    if let Some(address) = options.listen {
        let reach = match options.listen_all {
            true => Reach::All,
            false => Reach::Loopback,
        };
        let source = listen(address, reach, through.lines("TCP")?);
        let source = source.map_err(|why| match why {
            crate::io::ListenError::NotLoopback(_) => {
                Refusal::Usage(format!("--listen: {why}, or --listen-all"))
            }
            why => Refusal::File(format!("--listen: {why}")),
        })?;
        inputs.remark(&format!("listening at {}", source.name()));
        return Ok(Box::new(source));
    }
    if let Some(path) = &options.serial {
        return serial(path, options, through);
    }
    let path = options.source.as_deref().unwrap_or(Path::new(""));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    if is_standard_input(path) {
        let lines = through.lines(ITS_NAME)?;
        return Ok(Box::new(piped(std::io::stdin(), ITS_NAME, lines)));
    }
    let unopened = |error: std::io::Error| {
        let (found, expected) = why_unopened(path, &error);
        Refusal::File(format!(
            "{}: found {found}, expected {expected}",
            shown(path)
        ))
    };
    let lines = through.lines(&stem)?;
    if is_stream(path) {
        let pipe = File::open(path).map_err(unopened)?;
        return Ok(Box::new(piped(pipe, &name_of(path), lines)));
    }
    let is_folder = std::fs::metadata(path).map_err(unopened)?.is_dir();
    if let Some(pace) = options.replay {
        let replay = match is_folder {
            true => Err("found a folder, expected a recording".to_owned()),
            false => Replay::open(path, pace, lines),
        };
        let replay = replay.map_err(|why| Refusal::File(format!("{}: {why}", shown(path))))?;
        return Ok(Box::new(replay));
    }
    let choices = inputs.choices(&Choices::default());
    Ok(match is_folder {
        true => Box::new(FolderSource::new(path, &choices).with_lines(lines)),
        false => Box::new(FileSource::new(path, &choices).with_lines(lines)),
    })
}

#[cfg(feature = "serial")]
fn serial(path: &Path, options: &Follow, through: &Through) -> Result<Box<dyn Source>, Refusal> {
    let baud = options.baud.unwrap_or(crate::io::BAUD);
    let name = name_of(path);
    let source = crate::io::Serial::open(path.to_owned(), baud, through.lines(&name)?);
    let source = source.map_err(|why| Refusal::File(format!("--serial: {why}")))?;
    Ok(Box::new(source))
}

/// The serial ports, a line each.
#[cfg(feature = "serial")]
pub(super) fn ports() -> Result<String, Refusal> {
    let ports = crate::io::ports();
    Ok(ports
        .iter()
        .map(|path| format!("{}\n", shown(path)))
        .collect())
}

#[cfg(not(feature = "serial"))]
const NO_SERIAL: &str = "found a build without serial ports, expected one with the feature serial";

#[cfg(not(feature = "serial"))]
fn serial(_: &Path, _: &Follow, _: &Through) -> Result<Box<dyn Source>, Refusal> {
    Err(Refusal::Usage(format!("--serial: {NO_SERIAL}")))
}

#[cfg(not(feature = "serial"))]
pub(super) fn ports() -> Result<String, Refusal> {
    Err(Refusal::Usage(format!("--ports: {NO_SERIAL}")))
}
