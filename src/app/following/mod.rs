//! Following a light that changes: a thread reads it, and the window looks at what is newest.
//!
//! ```text
//! jump_words  jumps in words
//! source      what may be followed: a file, a folder, TCP, a serial port, a recording; the instrument
//! stream      its frames, hold, tracks, and how it stands in words
//! ```
//!
//! Frames that come between two looks are averaged, tracked and counted, and not drawn. Nothing
//! listens unless it is asked for.

mod jump_words;
mod source;
mod stream;

use std::{
    path::PathBuf,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
    time::{Duration, Instant},
};

use super::{
    entry::Entry,
    measured::{has_doubt, spectrum},
    origin::{CAPTURED, FOLLOWED},
    pages::LiveMemory,
    state::{App, Tone},
    worker::{Tell, Wake, Worker},
};
use crate::{
    io::Choices,
    live::{Live, Shown},
    measurements::{Measurement, Quantity, quantity_of},
    spectrum::{Kind, NamedSpectrum},
    streams::Source,
};

pub use jump_words::jump_words;
pub use source::{Asked, NotFollowed, ONLY_ITS_AXIS, Through, ports};
pub use stream::{Seen, Standing, Stream};

/// How long the thread waits for an event before it looks whether it is still wanted.
const PATIENCE: Duration = Duration::from_millis(100);

/// What is to be followed.
#[derive(Clone, Debug, PartialEq)]
pub struct FollowAsked {
    pub source: Asked,
    /// An instrument's file: axis and response.
    pub instrument: Option<PathBuf>,
    /// What a person decided about a file.
    pub choices: Choices,
}

impl FollowAsked {
    pub fn new(source: Asked) -> Self {
        Self {
            source,
            instrument: None,
            choices: Choices::default(),
        }
    }

    /// Opens the source.
    ///
    /// # Errors
    /// Why it cannot be followed.
    fn open(&self) -> Result<(Box<dyn Source>, Through), NotFollowed> {
        let through = self.instrument.as_deref().map(Through::read).transpose();
        let through = through.map_err(|why| NotFollowed::Found(tr!("the instrument: {why}", why)));
        let through = through?.unwrap_or_default();
        let source = self.source.open(&through, &self.choices)?;
        Ok((source, through))
    }
}

/// A stream that is being followed.
pub struct Following {
    stream: Arc<Mutex<Stream>>,
    /// Dropped, it asks the thread to stop.
    reader: Option<Worker<()>>,
    began: Instant,
    /// True if it comes as lines, which somebody has to send.
    pub takes_lines: bool,
    /// The frame that was drawn last.
    drawn: u64,
    /// Frames that were drawn.
    pub drawn_count: u64,
    seen: Seen,
    /// The key of its light in the library, and the light as it was last put there.
    key: Option<String>,
    entry: Option<Arc<Entry>>,
}

fn locked(stream: &Mutex<Stream>) -> MutexGuard<'_, Stream> {
    stream.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Following {
    fn of(stream: Stream) -> Self {
        Self {
            stream: Arc::new(Mutex::new(stream)),
            reader: None,
            began: Instant::now(),
            takes_lines: false,
            drawn: 0,
            drawn_count: 0,
            seen: Seen::default(),
            key: None,
            entry: None,
        }
    }

    /// Begins to follow; what cannot be opened says so in its words.
    pub fn start(asked: FollowAsked, wake: &Wake) -> Self {
        let mut following = Self::of(Stream::new("", Live::new(None, false)));
        following.takes_lines = matches!(asked.source, Asked::Tcp(..) | Asked::Serial(..));
        let (stream, began) = (following.stream.clone(), following.began);
        following.reader = Some(Worker::start(wake, move |tell| {
            read(&asked, &stream, began, tell);
        }));
        following
    }

    /// Follows a source to its end at once, each frame at its own time: for pictures.
    pub fn played(asked: &FollowAsked) -> Self {
        let mut stream = Stream::new("", Live::new(None, false));
        let mut now_s = 0.0;
        match asked.open() {
            Err(why) => stream.refuse(why.words()),
            Ok((mut source, through)) => {
                stream = Stream::new(source.name(), Live::new(through.response, false));
                while !stream.is_over() {
                    if let Some(event) = source.next(PATIENCE) {
                        if let crate::streams::Event::Frame(frame) = &event {
                            now_s = 1e-3 * frame.time_ms;
                        }
                        stream.broken.clone_from(source.broken());
                        stream.hear(event, now_s);
                    }
                }
            }
        }
        Self::of(stream)
    }

    /// The stream, for what a person does with it. The thread waits meanwhile.
    pub fn stream(&self) -> MutexGuard<'_, Stream> {
        locked(&self.stream)
    }

    /// What was seen at the last look.
    pub fn seen(&self) -> &Seen {
        &self.seen
    }

    /// The key of its light in the library, once there is one.
    pub fn key(&self) -> Option<&str> {
        self.key.as_deref()
    }

    /// True while frames may come.
    pub fn is_on(&self) -> bool {
        self.reader.is_some() && !self.stream().is_over()
    }

    /// Looks at the stream: a frame that is new becomes the light in the library, which is no step of
    /// undo. True if the program shows another light now.
    pub fn look(&mut self, app: &mut App) -> bool {
        let memory = app.document().pages.live.clone();
        let mut stream = locked(&self.stream);
        set(&mut stream.live, &memory);
        let before = std::mem::take(&mut self.seen);
        self.seen = stream
            .seen(self.began.elapsed().as_secs_f64())
            .sharing(&before);
        let notices = stream.notices();
        drop(stream);
        for notice in notices {
            app.say(Tone::Problem, notice);
        }
        self.put_in(app)
    }

    fn put_in(&mut self, app: &mut App) -> bool {
        let Some(shown) = self.seen.shown.clone() else {
            return false;
        };
        if self.seen.count != self.drawn {
            self.drawn = self.seen.count;
            self.drawn_count += 1;
        }
        let source = format!("{FOLLOWED}{}", self.seen.name);
        let entry = entry_of(&shown, source);
        let key = match &self.key {
            Some(key) => key.clone(),
            None => {
                let key = app.follow(entry);
                self.entry = app.entry(&key);
                self.key = Some(key);
                return true;
            }
        };
        let is_there = |entry: &Arc<Entry>| app.entry(&key).is_some_and(|e| Arc::ptr_eq(&e, entry));
        let is_new = self
            .entry
            .as_ref()
            .is_none_or(|old| old.spectrum != entry.spectrum || !is_there(old));
        if is_new {
            app.put_frame(&key, &entry);
            self.entry = app.entry(&key);
        }
        is_new
    }

    /// What is shown, to be kept: its time stands in its name; `None` before the first frame.
    pub fn capture(&self) -> Option<Entry> {
        let stream = self.stream();
        let of = stream.live.capture().ok().flatten()?;
        Some(entry_of_measurement(
            &of,
            format!("{CAPTURED}{}", stream.name),
        ))
    }
}

/// A light as an instrument would send it, for what shows how following goes.
pub fn played(light: &Entry) -> Entry {
    let spectrum = NamedSpectrum {
        name: format!("{}, live", light.name()),
        source: format!("{FOLLOWED}a lesson"),
        ..light.spectrum.clone()
    };
    Entry::own(0, spectrum)
}

/// Whether a spectrum of the library was captured from a stream.
pub fn is_capture(entry: &Entry) -> bool {
    entry.spectrum.source.starts_with(CAPTURED)
}

fn set(live: &mut Live, memory: &LiveMemory) {
    live.average_over(memory.average);
    live.take_as_light(memory.as_light);
}

fn read(asked: &FollowAsked, stream: &Mutex<Stream>, began: Instant, tell: &Tell<()>) {
    let mut source = match asked.open() {
        Err(why) => return locked(stream).refuse(why.words()),
        Ok((source, through)) => {
            let mut stream = locked(stream);
            *stream = Stream::new(source.name(), Live::new(through.response, false));
            source
        }
    };
    (tell.wake)();
    while !tell.progress.is_cancelled() && !locked(stream).is_over() {
        if let Some(event) = source.next(PATIENCE) {
            let mut stream = locked(stream);
            stream.broken.clone_from(source.broken());
            stream.hear(event, began.elapsed().as_secs_f64());
            drop(stream);
            (tell.wake)();
        }
    }
}

/// The light of a stream as the library holds it.
fn entry_of(shown: &Shown, source: String) -> Entry {
    entry_of_measurement(&shown.of, source)
}

fn entry_of_measurement(of: &Measurement, source: String) -> Entry {
    let of_light = spectrum(of, &source);
    let kind = match of.quantity {
        // Their reading says that they are none yet.
        Quantity::Counts => Kind::Light,
        _ => of_light.kind,
    };
    let says_counts = quantity_of(&of.name, Kind::Light, &of.unit) == Ok(Quantity::Counts);
    let unit = match (of.quantity, says_counts) {
        // What the stream takes for counts is none on any page, whatever told it.
        (Quantity::Counts, false) => "counts".to_owned(),
        // A person takes them as a light.
        (Quantity::Light, true) => String::new(),
        _ => of_light.unit,
    };
    let of_light = NamedSpectrum {
        kind,
        unit,
        ..of_light
    };
    let measured = has_doubt(of).then(|| Arc::new(of.clone()));
    Entry {
        measured,
        ..Entry::own(0, of_light)
    }
}
