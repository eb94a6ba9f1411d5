//! A recording that is played: at its own speed, faster or slower, or stepped.

use std::{
    collections::VecDeque,
    fs::File,
    io::Read,
    path::Path,
    thread,
    time::{Duration, Instant},
};

use super::{
    Event, Source,
    frame::Frame,
    lines::{Broken, Lines},
};
use crate::io::{name_of, why_unopened};

/// Between frames that tell no time, ms.
const UNTIMED_MS: f64 = 100.0;

/// Speed of a replay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// Times its own speed.
    Times(f64),
    /// A frame whenever one is asked for.
    Stepped,
}

/// A recording.
pub struct Replay {
    name: String,
    file: File,
    lines: Lines,
    pace: Pace,
    frames: VecDeque<Frame>,
    count: u64,
    /// The first frame's time in the recording, ms, and when it was shown.
    first: Option<(f64, Instant)>,
    last_ms: f64,
    is_read: bool,
}

impl Replay {
    /// A recording in a file.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn open(path: &Path, pace: Pace, lines: Lines) -> Result<Self, String> {
        let file = File::open(path).map_err(|error| {
            let (found, expected) = why_unopened(path, &error);
            tr!("found {found}, expected {expected}", found, expected)
        })?;
        Ok(Self {
            name: name_of(path),
            file,
            lines,
            pace,
            frames: VecDeque::new(),
            count: 0,
            first: None,
            last_ms: 0.0,
            is_read: false,
        })
    }

    /// Reads on until there is a frame.
    fn read(&mut self) {
        let mut buffer = vec![0; 1 << 16];
        while self.frames.is_empty() && !self.is_read {
            let count = self.file.read(&mut buffer).unwrap_or(0);
            let frames = &mut self.frames;
            self.lines
                .feed(&buffer[..count], f64::NAN, |frame| frames.push_back(frame));
            if count == 0 {
                self.is_read = true;
                frames.extend(self.lines.whole_object(f64::NAN));
                self.lines.finish();
            }
        }
    }

    /// How long until a frame is due.
    fn due(&self, time_ms: f64) -> Duration {
        match (self.pace, self.first) {
            (Pace::Times(speed), Some((first_ms, began))) => {
                let ms = (time_ms - first_ms) / speed;
                let due = Duration::try_from_secs_f64(1e-3 * ms).unwrap_or_default();
                due.saturating_sub(began.elapsed())
            }
            _ => Duration::ZERO,
        }
    }
}

impl Source for Replay {
    fn name(&self) -> &str {
        &self.name
    }

    fn next(&mut self, patience: Duration) -> Option<Event> {
        self.read();
        let Some(frame) = self.frames.front_mut() else {
            return Some(Event::End);
        };
        if frame.time_ms.is_nan() {
            let is_first = self.count == 0;
            frame.time_ms = self.last_ms + if is_first { 0.0 } else { UNTIMED_MS };
        }
        let time_ms = frame.time_ms;
        let due = self.due(time_ms);
        thread::sleep(due.min(patience));
        if due > patience {
            return None;
        }
        self.first = self.first.or(Some((time_ms, Instant::now())));
        self.last_ms = time_ms;
        self.count += 1;
        let frame = self.frames.pop_front()?;
        Some(Event::Frame(Box::new(frame)))
    }

    fn broken(&self) -> &Broken {
        &self.lines.broken
    }
}
