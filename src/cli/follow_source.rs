//! Where the frames of `follow` come from, and through which instrument they are read.

use std::path::{Path, PathBuf};

use super::{arguments::Follow, inputs::Inputs, refusal::Refusal};
use crate::{
    app::following::{Asked, NotFollowed, ONLY_ITS_AXIS, Through},
    io::Choices,
    streams::{BAUD, Reach, Source},
};

/// The instrument of `--instrument`.
///
/// # Errors
/// [`Refusal::File`] for a file that is none.
pub(super) fn instrument(path: Option<&PathBuf>, inputs: &mut Inputs) -> Result<Through, Refusal> {
    let Some(path) = path else {
        return Ok(Through::default());
    };
    let text = inputs.text(path);
    let through = text.and_then(|text| Through::of_text(path, &text));
    let through = through.map_err(|why| Refusal::File(format!("--instrument: {why}")))?;
    if through.is_axis_alone() {
        inputs.note(format!("--instrument: {ONLY_ITS_AXIS}"));
    }
    Ok(through)
}

/// What is asked for, and by which option.
fn asked(options: &Follow) -> (Asked, &'static str) {
    if let Some(address) = options.listen {
        let reach = match options.listen_all {
            true => Reach::All,
            false => Reach::Loopback,
        };
        return (Asked::Tcp(address, reach), "--listen: ");
    }
    if let Some(path) = &options.serial {
        let baud = options.baud.unwrap_or(BAUD);
        return (Asked::Serial(path.clone(), baud), "--serial: ");
    }
    let path = options.source.as_deref().unwrap_or(Path::new(""));
    let path = path.to_owned();
    match options.replay {
        Some(pace) => (Asked::Replay(path, pace), ""),
        None => (Asked::Path(path), ""),
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
    let (asked, option) = asked(options);
    let choices = inputs.choices(&Choices::default());
    let source = asked
        .open(through, &choices)
        .map_err(|why| refused(&asked, option, why))?;
    if matches!(asked, Asked::Tcp(..)) {
        inputs.remark(&format!("listening at {}", source.name()));
    }
    Ok(source)
}

/// A refusal in the words of the option.
pub(super) fn refused(asked: &Asked, option: &str, why: NotFollowed) -> Refusal {
    match (why, asked) {
        (NotFollowed::Asked(why), Asked::Tcp(..)) => {
            Refusal::Usage(format!("{option}{why}, or --listen-all"))
        }
        (NotFollowed::Asked(why), _) => Refusal::Usage(format!("{option}{why}")),
        (NotFollowed::Found(why), _) => Refusal::File(format!("{option}{why}")),
    }
}
