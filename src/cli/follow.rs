//! `follow`: figures of spectra as they come, a line a frame, without a window.

use std::{
    fs::File,
    io::Write,
    path::Path,
    time::{Duration, Instant},
};

use serde_json::{Map, Value, json};

use super::{
    arguments::Follow,
    follow_source::{instrument, source},
    inputs::Inputs,
    print,
    refusal::Refusal,
    target::{Replaces, Target},
};
use crate::{
    app::{
        following::{jump_words, ports},
        live_figures::{Told, figures},
        measured::spectrum,
    },
    io::shown,
    live::{Live, Reference, Shown, Tracks, clock},
    measurements::Quantity,
    spectrum::Sampled,
    streams::{Event, Frame, Recorder, Source},
};

/// Between two looks at what else is to be done.
const PATIENCE: Duration = Duration::from_millis(250);

/// Between two writings of the tracks.
const SAVED_EVERY: Duration = Duration::from_secs(5);

/// Carries the command out, until the source ends or enough frames were told.
///
/// # Errors
/// [`Refusal`] for a source that cannot be opened or brought no frame, and for a file that cannot be
/// written.
pub(super) fn run(
    options: &Follow,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    if options.ports {
        let ports = ports().map_err(|why| Refusal::Usage(format!("--ports: {why}")))?;
        let lines = ports.iter().map(|path| format!("{}\n", shown(path)));
        return print(out, &lines.collect::<String>());
    }
    let record = target("--record", options.record.as_deref(), options)?;
    let tracks = target("--tracks", options.tracks.as_deref(), options)?;
    let through = instrument(options.instrument.as_ref(), inputs)?;
    let mut source = source(options, &through, inputs)?;
    let mut session = Session {
        options,
        live: Live::new(through.response, options.as_light),
        tracks: Tracks::default(),
        light: None,
        recorder: match record {
            Some(target) => Some(Recorder::new(created(&target)?)),
            None => None,
        },
        dark: options.dark.unwrap_or(0),
        reference: options.reference.unwrap_or(0),
        told: 0,
        why_not: String::new(),
        began: Instant::now(),
    };
    session.live.average_over(options.average);
    let done = session.follow(&mut *source, tracks.as_ref(), out, inputs);
    if let Some(target) = tracks {
        session.save_tracks(&target)?;
        for jump in session.tracks.jumps() {
            let words = jump_words(&jump, session.light.as_ref());
            inputs.remark(&format!("a jump at {words}"));
        }
    }
    done?;
    let broken = source.broken();
    if broken.count > 0 {
        let (count, last) = (broken.count, &broken.last);
        let many = if count == 1 { "line was" } else { "lines were" };
        inputs.remark(&format!("{count} broken {many} skipped, the last: {last}"));
    }
    match session.live.count() {
        0 => Err(Refusal::File(format!(
            "{}: found no spectrum, expected one a line, or files with one",
            source.name()
        ))),
        _ => Ok(()),
    }
}

/// Where something is written to.
fn target<'o>(
    what: &'static str,
    path: Option<&'o Path>,
    options: &'o Follow,
) -> Result<Option<Target<'o>>, Refusal> {
    let Some(path) = path else {
        return Ok(None);
    };
    let read = [&options.source, &options.instrument];
    let read = read.map(|path| path.as_deref().map(Path::as_os_str));
    let target = Target {
        what,
        ..Target::out(path, Replaces::Nothing, options.force, &read)
    };
    target.path()?;
    Ok(Some(target))
}

fn created(target: &Target) -> Result<File, Refusal> {
    File::create(target.path()?).map_err(|why| {
        let (what, path) = (target.what, shown(target.path));
        Refusal::File(format!("{what}: {path} cannot be written ({why})"))
    })
}

/// A stream that is being followed.
struct Session<'o> {
    options: &'o Follow,
    live: Live,
    tracks: Tracks,
    /// The newest light of the tracks.
    light: Option<Sampled>,
    recorder: Option<Recorder<File>>,
    /// Frames that are still to come of the dark and of the reference.
    dark: usize,
    reference: usize,
    /// Frames that were told.
    told: u64,
    /// Why the last of the others were not.
    why_not: String,
    began: Instant,
}

impl Session<'_> {
    fn follow(
        &mut self,
        source: &mut dyn Source,
        tracks: Option<&Target>,
        out: &mut dyn Write,
        inputs: &mut Inputs,
    ) -> Result<(), Refusal> {
        let mut saved = Instant::now();
        let mut has_told_broken = false;
        while self.options.count.is_none_or(|count| self.told < count) {
            let event = source.next(PATIENCE);
            let broken = source.broken();
            if broken.count > 0 && !has_told_broken {
                has_told_broken = true;
                inputs.remark(&format!("a broken line is skipped: {}", broken.last));
            }
            let broken = broken.count;
            match event {
                Some(Event::End) => return Ok(()),
                Some(Event::Said(words)) => inputs.remark(&words),
                Some(Event::Frame(frame)) => self.take(*frame, broken, out, inputs)?,
                None => {}
            }
            if let Some(target) = tracks.filter(|_| saved.elapsed() >= SAVED_EVERY) {
                self.save_tracks(target)?;
                saved = Instant::now();
            }
        }
        Ok(())
    }

    fn take(
        &mut self,
        frame: Frame,
        broken: u64,
        out: &mut dyn Write,
        inputs: &mut Inputs,
    ) -> Result<(), Refusal> {
        if let Some(recorder) = &mut self.recorder {
            recorder.write(&frame).map_err(|why| {
                Refusal::File(format!("--record: the frame cannot be written ({why})"))
            })?;
        }
        let integration_ms = frame.integration_ms;
        if let Some(said) = self.live.push(frame, self.began.elapsed().as_secs_f64()) {
            inputs.remark(&said);
        }
        if self.is_taken(inputs) {
            return Ok(());
        }
        let shown = match self.live.shown() {
            Ok(Some(shown)) => shown,
            Ok(None) => return Ok(()),
            Err(why) => {
                let why = why.to_string();
                if self.why_not != why {
                    inputs.remark(&why);
                    self.why_not = why;
                }
                return Ok(());
            }
        };
        if shown.of.quantity == Quantity::Light && self.options.tracks.is_some() {
            let light = spectrum(&shown.of, "").samples;
            self.tracks.push(shown.time_ms, &light);
            self.light = Some(light);
        }
        self.told += 1;
        let figures = figures(&shown, &self.options.figures);
        let line = match self.options.json {
            true => self
                .json(&shown, &figures, integration_ms, broken)
                .to_string(),
            false => in_words(&shown, &figures),
        };
        print(out, &(line + "\n"))
    }

    /// Whether the frame is one of the dark or the reference, which are taken at their last.
    fn is_taken(&mut self, inputs: &mut Inputs) -> bool {
        let (left, asked, which, name) = if self.dark > 0 {
            (&mut self.dark, self.options.dark, Reference::Dark, "Dark")
        } else if self.reference > 0 {
            let asked = self.options.reference;
            (&mut self.reference, asked, Reference::Light, "Reference")
        } else {
            return false;
        };
        *left -= 1;
        if *left == 0 {
            let count = asked.unwrap_or(1);
            self.live.average_over(count);
            self.live.take(which);
            self.live.average_over(self.options.average);
            inputs.remark(&format!("{name}: the mean of {count} frames."));
        }
        true
    }

    fn json(
        &self,
        shown: &Shown,
        figures: &[Told],
        integration_ms: Option<f64>,
        broken: u64,
    ) -> Value {
        let mut notes: Vec<String> = Vec::new();
        let mut object = Map::new();
        for figure in figures {
            if let Err(why) = &figure.value {
                notes.push(format!("{}: {why}", figure.figure.key));
            }
            object.insert(
                figure.figure.key.to_owned(),
                json!(figure.value.as_ref().ok()),
            );
        }
        let clipped = shown.clipped.iter();
        let clipped = clipped.map(|[from, to]| json!({ "from_nm": from, "to_nm": to }));
        let others = [
            ("frame", json!(self.told)),
            ("time_ms", json!(shown.time_ms)),
            ("name", json!(shown.of.name)),
            ("quantity", json!(shown.of.quantity.word())),
            ("averaged", json!(shown.frames)),
            ("integration_ms", json!(integration_ms)),
            ("clipped", clipped.collect()),
            ("broken", json!(broken)),
            ("notes", json!(notes)),
        ];
        object.extend(others.map(|(key, value)| (key.to_owned(), value)));
        Value::Object(object)
    }

    fn save_tracks(&self, target: &Target) -> Result<(), Refusal> {
        let again = Target {
            force: true,
            ..target.clone()
        };
        again.save(self.tracks.csv().as_bytes())
    }
}

/// `0:00:03.2  CCT 2856 K  Y 12.3  Ra 99.6`.
fn in_words(shown: &Shown, figures: &[Told]) -> String {
    let mut parts = vec![clock(shown.time_ms)];
    parts.extend(figures.iter().map(Told::words));
    if let Some(why) = figures
        .iter()
        .find_map(|figure| figure.value.as_ref().err())
    {
        parts.push(format!("({why})"));
    }
    let clipped = shown.clipped.iter();
    let clipped: Vec<String> = clipped
        .map(|[from, to]| match from == to {
            true => from.to_string(),
            false => format!("{from}-{to}"),
        })
        .collect();
    if !clipped.is_empty() {
        parts.push(format!("clipped at {} nm", clipped.join(", ")));
    }
    parts.join("  ")
}
