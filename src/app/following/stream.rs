//! A stream as it is followed: its frames, what its producer does, and how it stands in words.

use std::sync::Arc;

use crate::{
    app::measured::spectrum,
    languages::with_sign,
    live::{Live, Shown, Tracks, age, clock, rate},
    measurements::{Measurement, Quantity},
    streams::{Broken, Event},
};

/// A frame is late beyond this many of the usual intervals, and no sooner than this, s.
const LATE: (f64, f64) = (4.0, 1.0);

/// A stream and what is kept of it.
pub struct Stream {
    pub name: String,
    pub live: Live,
    pub tracks: Tracks,
    pub broken: Broken,
    /// What the producer did since the last frame.
    said: Option<String>,
    /// Nothing more will come; why nothing ever could.
    end: Option<Result<(), String>>,
    /// Sentences that nobody has heard yet.
    notices: Vec<String>,
    /// Frames that had come when it was held.
    held_from: u64,
}

/// How a stream stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Standing {
    /// No frame came yet.
    #[default]
    Waiting,
    /// Frames come.
    Runs,
    /// The next frame is late.
    Slow,
    /// The producer is gone, or cannot be read just now.
    Gone,
    /// Nothing more will come.
    Ended,
    /// What is shown stays, whatever comes.
    Held,
    /// It could not be opened.
    Refused,
}

impl Standing {
    /// True for what a person has to look after.
    pub fn is_trouble(self) -> bool {
        matches!(self, Self::Slow | Self::Gone | Self::Refused)
    }
}

/// What is seen of a stream at a moment.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    pub name: String,
    pub shown: Option<Arc<Shown>>,
    /// The highest values so far.
    pub peak: Option<Arc<Measurement>>,
    /// Frames so far.
    pub count: u64,
    pub standing: Standing,
    /// The same in a sentence.
    pub words: String,
    /// The time of what is held, ms.
    pub held_ms: Option<f64>,
    /// Further sentences: what is clipped, what was skipped, what does not fit.
    pub warnings: Vec<String>,
}

impl Seen {
    /// The same with what is shown as it was seen before where it has not changed: it is drawn again
    /// only where it is another.
    #[must_use]
    pub fn sharing(self, before: &Self) -> Self {
        fn same<T: PartialEq>(now: Option<Arc<T>>, before: &Option<Arc<T>>) -> Option<Arc<T>> {
            if now == *before { before.clone() } else { now }
        }
        Self {
            shown: same(self.shown, &before.shown),
            peak: same(self.peak, &before.peak),
            ..self
        }
    }
}

impl Stream {
    pub fn new(name: &str, live: Live) -> Self {
        Self {
            name: name.to_owned(),
            live,
            tracks: Tracks::default(),
            broken: Broken::default(),
            said: None,
            end: None,
            notices: Vec::new(),
            held_from: 0,
        }
    }

    /// Takes an event that came at a time, s.
    pub fn hear(&mut self, event: Event, now_s: f64) {
        match event {
            Event::Frame(frame) => {
                self.said = None;
                self.notices.extend(self.live.push(*frame, now_s));
                let newest = self.live.newest().ok().flatten();
                if let Some(shown) = newest.filter(|shown| shown.of.quantity == Quantity::Light) {
                    let light = spectrum(&shown.of, "");
                    self.tracks.push(shown.time_ms, &light.samples);
                }
            }
            Event::Said(words) => self.said = Some(words),
            Event::End => self.end = Some(Ok(())),
        }
    }

    /// It could not be opened.
    pub fn refuse(&mut self, why: String) {
        self.end = Some(Err(why));
    }

    pub fn is_over(&self) -> bool {
        self.end.is_some()
    }

    /// Holds what is shown, or goes on; without a frame there is nothing to hold.
    pub fn hold(&mut self, holds: bool) {
        self.held_from = self.live.count();
        if let Err(why) = self.live.hold(holds) {
            self.notices.push(why.to_string());
        }
    }

    /// The sentences that nobody has heard yet.
    pub fn notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }

    /// How it stands at a time, s.
    pub fn seen(&self, now_s: f64) -> Seen {
        let (shown, trouble) = match self.live.shown() {
            Ok(shown) => (shown.map(Arc::new), None),
            Err(why) => (None, Some(why.to_string())),
        };
        let standing = self.standing(now_s);
        let clipped = shown.iter().flat_map(|shown| &shown.clipped);
        let clipped: Vec<String> = clipped
            .map(|[from, to]| match from == to {
                true => with_sign(from.to_string()),
                false => tr!(
                    "{from} to {to}",
                    from = with_sign(from.to_string()),
                    to = with_sign(to.to_string())
                ),
            })
            .collect();
        let clipped = (!clipped.is_empty()).then(|| {
            tr!(
                "Clipped at {ranges} nm: the light is stronger there than the instrument can tell. \
                 Shorten its exposure, or dim the light.",
                ranges = clipped.join(", ")
            )
        });
        let Broken { count, last } = &self.broken;
        let broken = (*count > 0).then(|| {
            tr!(
                "{n} broken line skipped, the last: {last}."
                    | "{n} broken lines skipped, the last: {last}." % *count,
                last
            )
        });
        let held_ms = shown.as_ref().map(|shown| shown.time_ms);
        Seen {
            name: self.name.clone(),
            held_ms: held_ms.filter(|_| self.live.is_held()),
            words: self.words(standing, shown.as_deref(), now_s),
            shown,
            peak: self.live.peak().ok().flatten().map(Arc::new),
            count: self.live.count(),
            standing,
            warnings: [trouble, clipped, broken].into_iter().flatten().collect(),
        }
    }

    fn standing(&self, now_s: f64) -> Standing {
        let (rate, age) = (self.live.rate(), self.live.age(now_s));
        let is_late = |age: f64| {
            let (intervals, least) = LATE;
            rate.is_some_and(|rate| age > (intervals / rate).max(least))
        };
        match (&self.end, age) {
            (Some(Err(_)), _) => Standing::Refused,
            _ if self.live.is_held() => Standing::Held,
            (Some(Ok(())), _) => Standing::Ended,
            (None, None) => Standing::Waiting,
            (None, Some(_)) if self.said.is_some() => Standing::Gone,
            (None, Some(age)) if is_late(age) => Standing::Slow,
            (None, Some(_)) => Standing::Runs,
        }
    }

    fn words(&self, standing: Standing, shown: Option<&Shown>, now_s: f64) -> String {
        let (told, last) = (rate(self.live.rate()), age(self.live.age(now_s)));
        let said = || self.said.clone();
        match standing {
            Standing::Refused => {
                let why = self.end.clone().and_then(Result::err).unwrap_or_default();
                tr!("Nothing is followed: {why}.", why)
            }
            Standing::Waiting => {
                said().unwrap_or_else(|| said!("Waiting for the first spectrum.").to_owned())
            }
            Standing::Gone => said().unwrap_or_default(),
            Standing::Runs => match self.live.count() {
                1 => tr!("The first spectrum came {last}.", last),
                _ => tr!("{rate}, the last {last}.", rate = capital(&told), last),
            },
            Standing::Slow => tr!(
                "Slow: the last spectrum came {last}, before that {rate}.",
                last,
                rate = told
            ),
            Standing::Ended if self.live.count() == 0 => {
                said!("It has ended without a spectrum.").to_owned()
            }
            Standing::Ended => said!("It has ended; the last spectrum stays.").to_owned(),
            Standing::Held => {
                let at = clock(shown.map_or(0.0, |shown| shown.time_ms));
                let since = self.live.count() - self.held_from;
                let held = match since {
                    0 => tr!("Held at {at}; nothing came since.", at),
                    since => tr!(
                        "Held at {at}; {n} spectrum came since."
                            | "Held at {at}; {n} spectra came since." % since,
                        at
                    ),
                };
                match (&self.said, &self.end) {
                    (Some(said), None) => format!("{held} {said}"),
                    (_, Some(_)) => format!("{held} {}", said!("It has ended.")),
                    (None, None) => held,
                }
            }
        }
    }
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        spectrum::{Kind, Sampled},
        streams::Frame,
    };

    fn frame(time_ms: f64, values: impl Fn(f64) -> f64) -> Event {
        let values = (380..=780).map(|nm| values(f64::from(nm))).collect();
        Event::Frame(Box::new(Frame {
            time_ms,
            name: "lamp".to_owned(),
            kind: Kind::Light,
            samples: Sampled::even(380.0, 1.0, values).expect("finite"),
            integration_ms: None,
            unit: "W m-2 nm-1".to_owned(),
            instrument: String::new(),
        }))
    }

    fn glow(nm: f64) -> f64 {
        0.2 + nm / 1000.0
    }

    #[test]
    fn a_stream_tells_in_words_how_it_stands() {
        let mut stream = Stream::new("lamp", Live::new(None, false));
        let told = |stream: &Stream, now: f64| {
            let seen = stream.seen(now);
            (seen.standing, seen.words)
        };
        assert_eq!(told(&stream, 0.0).0, Standing::Waiting);
        stream.hear(frame(0.0, glow), 0.0);
        assert_eq!(told(&stream, 0.5).0, Standing::Runs);
        for second in 1..=10 {
            stream.hear(frame(1000.0 * f64::from(second), glow), f64::from(second));
        }
        let (standing, words) = told(&stream, 10.2);
        assert_eq!(standing, Standing::Runs);
        assert_eq!(words, "1.0 spectra a second, the last just now.");
        // Four intervals of a second.
        assert_eq!(told(&stream, 14.0).0, Standing::Runs);
        let (standing, words) = told(&stream, 17.0);
        assert_eq!(standing, Standing::Slow);
        let slow = "Slow: the last spectrum came 7 s ago, before that 1.0 spectra a second.";
        assert_eq!(words, slow);
        stream.hear(Event::Said("The producer is gone.".to_owned()), 18.0);
        let gone = (Standing::Gone, "The producer is gone.".to_owned());
        assert_eq!(told(&stream, 18.0), gone);
        assert!(stream.seen(18.0).shown.is_some(), "the last frame stays");
        stream.hear(frame(19_000.0, glow), 19.0);
        assert_eq!(told(&stream, 19.0).0, Standing::Runs);
        stream.hold(true);
        stream.hear(frame(20_000.0, |nm| 2.0 * glow(nm)), 20.0);
        let held = (
            Standing::Held,
            "Held at 0:00:19.0; 1 spectrum came since.".to_owned(),
        );
        assert_eq!(told(&stream, 20.0), held);
        // What happens meanwhile is told beside it.
        stream.hear(Event::Said("The producer is gone.".to_owned()), 20.5);
        let held_and_gone = (held.0, format!("{} The producer is gone.", held.1));
        assert_eq!(told(&stream, 20.5), held_and_gone);
        assert_eq!(stream.seen(20.5).held_ms, Some(19_000.0));
        stream.hear(Event::End, 21.0);
        let held_and_over = (held.0, format!("{} It has ended.", held.1));
        assert_eq!(told(&stream, 21.0), held_and_over);
        stream.hold(false);
        assert_eq!(told(&stream, 21.0).0, Standing::Ended);
        // What is held back from the screen is in the tracks.
        assert_eq!(stream.tracks.len(), 13);
        let y = |index: usize| stream.tracks.point(index).expect("a frame").y;
        assert!((y(12) / y(11) - 2.0).abs() < 1e-6);
    }

    #[test]
    fn what_is_shown_is_one_and_the_same_until_another_spectrum_comes() {
        let mut stream = Stream::new("lamp", Live::new(None, false));
        stream.hear(frame(0.0, glow), 0.0);
        let first = stream.seen(0.0);
        let is_same = |seen: &Seen| {
            let both = seen.shown.as_ref().zip(first.shown.as_ref());
            both.is_some_and(|(now, before)| Arc::ptr_eq(now, before))
        };
        assert!(!is_same(&stream.seen(1.0)), "made anew");
        assert!(is_same(&stream.seen(1.0).sharing(&first)));
        stream.hear(frame(2000.0, |nm| 2.0 * glow(nm)), 2.0);
        assert!(!is_same(&stream.seen(2.0).sharing(&first)));
    }

    #[test]
    fn what_is_clipped_skipped_or_refused_is_told() {
        let mut stream = Stream::new("lamp", Live::new(None, false));
        stream.hear(frame(0.0, |nm| (60.0 * (nm - 380.0)).min(4095.0)), 0.0);
        stream.broken.count = 2;
        "found half a line".clone_into(&mut stream.broken.last);
        let warnings = stream.seen(0.0).warnings;
        assert_eq!(warnings.len(), 2, "{warnings:?}");
        assert!(
            warnings[0].starts_with("Clipped at 449 to 780 nm"),
            "{warnings:?}"
        );
        assert_eq!(
            warnings[1],
            "2 broken lines skipped, the last: found half a line."
        );
        stream.refuse("no such port".to_owned());
        let seen = stream.seen(0.0);
        assert_eq!(seen.standing, Standing::Refused);
        assert_eq!(seen.words, "Nothing is followed: no such port.");
    }
}
