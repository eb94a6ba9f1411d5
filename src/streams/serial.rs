//! Lines of a serial port, which may be unplugged and come back.

use std::{
    io,
    path::PathBuf,
    thread,
    time::{Duration, Instant},
};

use serial2::SerialPort;

use super::{
    lines::Lines,
    stream::{Heard, LineSource, Link, is_late},
};
use crate::io::shown;

/// Between two attempts to open a port that was unplugged.
const AGAIN: Duration = Duration::from_millis(500);

/// The serial ports of this machine.
pub fn ports() -> Vec<PathBuf> {
    let mut ports = SerialPort::available_ports().unwrap_or_default();
    ports.sort();
    ports
}

/// A serial port.
pub struct Serial {
    path: PathBuf,
    baud: u32,
    port: Option<SerialPort>,
    buffer: Vec<u8>,
}

impl Serial {
    /// Lines of a port.
    ///
    /// # Errors
    /// When it cannot be opened, with the ports that there are.
    pub fn open(path: PathBuf, baud: u32, lines: Lines) -> Result<LineSource<Self>, String> {
        let name = shown(&path);
        let port = SerialPort::open(&path, baud).map_err(|why| {
            let others = ports();
            let others: Vec<String> = others.iter().map(|path| shown(path)).collect();
            let expected = match &others[..] {
                [] => said!("a serial port (this machine has none)").to_owned(),
                others => tr!("one of {ports}", ports = others.join(", ")),
            };
            tr!(
                "{name}: found no serial port that opens ({why}), expected {expected}",
                name,
                why,
                expected
            )
        })?;
        Ok(Self::of(port, path, baud, lines))
    }

    fn of(port: SerialPort, path: PathBuf, baud: u32, lines: Lines) -> LineSource<Self> {
        let name = shown(&path);
        let serial = Self {
            path,
            baud,
            port: Some(port),
            buffer: vec![0; 1 << 12],
        };
        LineSource::new(serial, &name, lines)
    }

    fn read(&mut self, patience: Duration) -> io::Result<Vec<u8>> {
        let port = self.port.as_mut().ok_or(io::ErrorKind::NotConnected)?;
        port.set_read_timeout(patience.max(Duration::from_millis(1)))?;
        match port.read(&mut self.buffer)? {
            0 => Err(io::ErrorKind::UnexpectedEof.into()),
            count => Ok(self.buffer[..count].to_vec()),
        }
    }
}

impl Link for Serial {
    fn hear(&mut self, patience: Duration) -> Heard {
        let until = Instant::now() + patience;
        loop {
            let left = until.saturating_duration_since(Instant::now());
            if self.port.is_some() {
                return match self.read(left) {
                    Ok(bytes) => Heard::Bytes(bytes),
                    Err(error) if is_late(&error) => Heard::Nothing,
                    Err(_) => {
                        self.port = None;
                        let name = shown(&self.path);
                        Heard::Gone(tr!(
                            "{name} is unplugged: the last spectrum stays, waiting for it.",
                            name
                        ))
                    }
                };
            }
            self.port = SerialPort::open(&self.path, self.baud).ok();
            if self.port.is_some() {
                return Heard::Begin(tr!("{name} is back.", name = shown(&self.path)));
            }
            if left.is_zero() {
                return Heard::Nothing;
            }
            thread::sleep(left.min(AGAIN));
        }
    }
}

#[cfg(all(test, unix))]
#[path = "../../tests/core/live/serial.rs"]
mod tests;
