//! Input that can be read only once: standard input and pipes.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

use crate::io::text::MOST_BYTES;
use crate::io::unopened;

/// The word that means standard input; `./-` is a file of that name.
pub(crate) const STANDARD_INPUT: &str = "-";

/// The name of standard input in messages and spectra.
pub(crate) const ITS_NAME: &str = "standard input";

/// The wait for a pipe's writer before a message is shown.
const PATIENCE: Duration = Duration::from_secs(2);

/// True if the input at a path can be read only once.
pub(crate) fn is_stream(path: &Path) -> bool {
    is_standard_input(path) || is_pipe(path)
}

/// True if a path is the word for standard input.
pub(crate) fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == STANDARD_INPUT
}

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    std::fs::metadata(path).is_ok_and(|about| about.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_pipe(_: &Path) -> bool {
    false
}

/// All that comes out of a stream, up to one byte more than a file may have. `waits` is called
/// when nobody has opened the other end of a pipe for a while: it may be that nobody will.
///
/// # Errors
/// When it cannot be opened or read.
pub(crate) fn drained(path: &Path, waits: impl FnOnce()) -> io::Result<Vec<u8>> {
    if is_standard_input(path) {
        return whole(io::stdin().lock());
    }
    let (sender, opened) = channel();
    let path: PathBuf = path.to_owned();
    // Opening a pipe takes as long as its writer takes to come.
    let reader = thread::spawn(move || {
        let pipe = File::open(path);
        // Whoever waits for it may be waiting for the thread by now.
        let _ = sender.send(());
        whole(pipe?)
    });
    if opened.recv_timeout(PATIENCE).is_err() {
        waits();
    }
    reader
        .join()
        .unwrap_or_else(|_| Err(io::Error::other(said!("the pipe could not be read"))))
}

/// The bytes of a file, one more than `most` at the most: of what is no file, such as a device or a
/// pipe, nobody knows that it ends.
///
/// # Errors
/// The obstacle, and the content expected instead.
pub(crate) fn bytes_of_file(path: &Path, most: u64) -> Result<Vec<u8>, (String, &'static str)> {
    let about = std::fs::metadata(path);
    if about.is_ok_and(|about| !about.is_file()) {
        let found = if path.is_dir() {
            said!("a folder")
        } else {
            said!("a device or a pipe")
        };
        return Err((found.to_owned(), said!("a file")));
    }
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(most + 1).read_to_end(&mut bytes))
        .map_err(|error| unopened::words(path, &error))?;
    Ok(bytes)
}

fn whole(stream: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    stream.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
