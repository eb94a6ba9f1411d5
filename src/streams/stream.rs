//! Lines that come over standard input, a pipe or TCP.

use std::{
    collections::VecDeque,
    io::{self, ErrorKind, Read},
    net::{SocketAddr, TcpListener, TcpStream},
    sync::mpsc::{Receiver, RecvTimeoutError, sync_channel},
    thread,
    time::{Duration, Instant},
};

use super::{
    Event, Source,
    lines::{Broken, Lines},
};

/// Most bytes that are read at once.
const CHUNK: usize = 1 << 16;

/// Chunks that wait to be read; then their writer waits.
const MOST_CHUNKS: usize = 16;

/// Between two looks for a producer that connects.
const PAUSE: Duration = Duration::from_millis(10);

/// What a link to a producer brought.
#[derive(Debug)]
pub enum Heard {
    Bytes(Vec<u8>),
    /// Another producer begins; a sentence about it.
    Begin(String),
    /// The producer is gone, and another may come.
    Gone(String),
    Nothing,
    End,
}

/// A way by which bytes come.
pub trait Link: Send {
    /// What comes within this time.
    fn hear(&mut self, patience: Duration) -> Heard;
}

/// Frames in the lines that come over a link.
pub struct LineSource<L> {
    name: String,
    link: L,
    lines: Lines,
    waiting: VecDeque<Event>,
    since: Instant,
    has_ended: bool,
}

impl<L: Link> LineSource<L> {
    pub(super) fn new(link: L, name: &str, lines: Lines) -> Self {
        Self {
            name: name.to_owned(),
            link,
            lines,
            waiting: VecDeque::new(),
            since: Instant::now(),
            has_ended: false,
        }
    }

    /// Takes what was heard; false for nothing.
    fn take(&mut self, heard: Heard) -> bool {
        match heard {
            Heard::Bytes(bytes) => {
                let time_ms = 1e3 * self.since.elapsed().as_secs_f64();
                let waiting = &mut self.waiting;
                let keep = |frame| waiting.push_back(Event::Frame(Box::new(frame)));
                self.lines.feed(&bytes, time_ms, keep);
            }
            Heard::Begin(words) | Heard::Gone(words) => {
                self.lines.begin();
                self.waiting.push_back(Event::Said(words));
            }
            Heard::Nothing => return false,
            Heard::End => {
                let time_ms = 1e3 * self.since.elapsed().as_secs_f64();
                let last = self.lines.whole_object(time_ms);
                self.waiting
                    .extend(last.map(|frame| Event::Frame(Box::new(frame))));
                self.lines.finish();
                self.has_ended = true;
            }
        }
        true
    }
}

impl<L: Link> Source for LineSource<L> {
    fn name(&self) -> &str {
        &self.name
    }

    fn next(&mut self, patience: Duration) -> Option<Event> {
        let until = Instant::now() + patience;
        loop {
            if let Some(event) = self.waiting.pop_front() {
                return Some(event);
            }
            if self.has_ended {
                return Some(Event::End);
            }
            let left = until.saturating_duration_since(Instant::now());
            let heard = self.link.hear(left);
            // What ends no line is no event.
            if !self.take(heard) || left.is_zero() && self.waiting.is_empty() {
                return None;
            }
        }
    }

    fn broken(&self) -> &Broken {
        &self.lines.broken
    }
}

/// What is read to its end by a thread of its own: nobody can wait for it for a while only.
pub struct Piped {
    chunks: Receiver<Vec<u8>>,
}

/// Lines of standard input or of a pipe.
pub fn piped(from: impl Read + Send + 'static, name: &str, lines: Lines) -> LineSource<Piped> {
    let (sender, chunks) = sync_channel(MOST_CHUNKS);
    thread::spawn(move || {
        let mut from = from;
        let mut buffer = vec![0; CHUNK];
        loop {
            match from.read(&mut buffer) {
                Ok(0) => return,
                Ok(count) if sender.send(buffer[..count].to_vec()).is_err() => return,
                Err(error) if error.kind() != ErrorKind::Interrupted => return,
                _ => {}
            }
        }
    });
    LineSource::new(Piped { chunks }, name, lines)
}

impl Link for Piped {
    fn hear(&mut self, patience: Duration) -> Heard {
        match self.chunks.recv_timeout(patience) {
            Ok(bytes) => Heard::Bytes(bytes),
            Err(RecvTimeoutError::Timeout) => Heard::Nothing,
            Err(RecvTimeoutError::Disconnected) => Heard::End,
        }
    }
}

/// Who may connect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Programs on this machine.
    Loopback,
    /// The network.
    All,
}

/// Why nothing listens.
#[derive(Debug, thiserror::Error)]
pub enum ListenError {
    #[error(
        "{}",
        tr!(
            "found {address}, which others on the network reach, expected a loopback address \
             (127.0.0.1)",
            address = .0
        )
    )]
    NotLoopback(SocketAddr),
    #[error(
        "{}",
        tr!("found {address}, where nothing can listen ({why}), expected a free port", address, why)
    )]
    Taken { address: SocketAddr, why: io::Error },
}

/// A place where producers connect. One at a time is heard: another takes over from one that is
/// silent or gone.
pub struct Listener {
    listener: TcpListener,
    producer: Option<TcpStream>,
    buffer: Vec<u8>,
}

/// Lines that are sent to an address over TCP. The source is called by the address, with the port
/// that was chosen where 0 was asked for.
///
/// # Errors
/// [`ListenError`] for an address beyond the reach, and one that is taken.
pub fn listen(
    address: SocketAddr,
    reach: Reach,
    lines: Lines,
) -> Result<LineSource<Listener>, ListenError> {
    if reach == Reach::Loopback && !address.ip().is_loopback() {
        return Err(ListenError::NotLoopback(address));
    }
    let taken = |why| ListenError::Taken { address, why };
    let listener = TcpListener::bind(address).map_err(taken)?;
    listener.set_nonblocking(true).map_err(taken)?;
    let name = listener.local_addr().unwrap_or(address).to_string();
    let listener = Listener {
        listener,
        producer: None,
        buffer: vec![0; CHUNK],
    };
    Ok(LineSource::new(listener, &name, lines))
}

/// True for a read that brought nothing within its time.
pub(super) fn is_late(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted
    )
}

impl Listener {
    fn gone(&self) -> String {
        match self.listener.local_addr() {
            Ok(address) => tr!(
                "The producer is gone: the last spectrum stays, and another producer may connect \
                 to {address}.",
                address
            ),
            Err(_) => said!(
                "The producer is gone: the last spectrum stays, and another producer may connect."
            )
            .to_owned(),
        }
    }
}

impl Link for Listener {
    fn hear(&mut self, patience: Duration) -> Heard {
        let until = Instant::now() + patience;
        loop {
            let left = until.saturating_duration_since(Instant::now());
            match &mut self.producer {
                None => thread::sleep(left.min(PAUSE)),
                Some(producer) => {
                    // No time at all would be for ever.
                    let wait = left.clamp(Duration::from_millis(1), PAUSE);
                    let read = producer.set_read_timeout(Some(wait));
                    match read.and_then(|()| producer.read(&mut self.buffer)) {
                        Ok(count) if count > 0 => {
                            return Heard::Bytes(self.buffer[..count].to_vec());
                        }
                        Err(error) if is_late(&error) => {}
                        _ => {
                            self.producer = None;
                            return Heard::Gone(self.gone());
                        }
                    }
                }
            }
            if let Ok((producer, from)) = self.listener.accept()
                && producer.set_nonblocking(false).is_ok()
            {
                self.producer = Some(producer);
                return Heard::Begin(tr!("{from} sends.", from));
            }
            if left.is_zero() {
                return Heard::Nothing;
            }
        }
    }
}

#[cfg(test)]
#[path = "../../tests/core/live/stream.rs"]
mod tests;
