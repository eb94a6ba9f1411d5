//! How a file was read, to look at and to turn round: its first rows, what was decided and why,
//! and every other choice one step away. The spectra are in the document already.

use std::{
    path::PathBuf,
    sync::{Arc, Weak},
};

use super::{
    command::Command,
    document::{Document, FIRST_LIGHT, Subject},
    entry::Entry,
    open::{Loaded, load_bytes_as, load_path_as},
    opened::{ImageEntry, Opened},
    state::App,
    studies::{Job, Stage, Wake},
};
use crate::{
    io::{
        Choices, Counted, Dialect, Guess, Guessed,
        choices::OfOne,
        decided::{BY_HAND, MOST_UNDERSTOOD},
        dialect::Delimiter,
        envi,
        reading::{AxisTold, TableFound, Told, Understood},
        text,
        units::WavelengthUnit,
    },
    spectrum::Kind,
};

/// Files up to this size are read again at once, larger ones on a thread of their own; bytes.
const AT_ONCE_BYTES: u64 = 4 * 1024 * 1024;

/// Bytes of a file that its first rows are looked for in.
const HEAD_BYTES: usize = 256 * 1024;

/// Rows shown.
const ROWS: usize = 40;

/// Columns shown, and columns offered for the wavelengths.
pub const MOST_COLUMNS: usize = 10;

/// Lines shown of what stands above the table.
const LINES_ABOVE: usize = 3;

/// Letters shown of a cell and of a line.
const CELL_LETTERS: usize = 18;
const LINE_LETTERS: usize = 110;

/// What was on screen before a file was opened.
#[derive(Clone, Debug)]
pub struct Before {
    light: Arc<Entry>,
    factor: Option<Arc<Entry>>,
    subject: Subject,
    own: usize,
    images: usize,
}

impl Before {
    /// What is on screen now.
    pub fn of(app: &App) -> Self {
        let document = app.document();
        Self {
            light: document.light.clone(),
            factor: document.factor.clone(),
            subject: document.subject,
            own: document.own.len(),
            images: document.images.len(),
        }
    }

    /// Keys of the entries that joined since.
    pub fn joined(&self, app: &App) -> Vec<String> {
        let own = app.document().own.iter().skip(self.own);
        own.map(|entry| entry.key.clone()).collect()
    }

    /// What of a file joined since.
    fn brought(&self, app: &App) -> Held {
        let images = app.document().images.iter().skip(self.images);
        Held {
            keys: self.joined(app),
            images: images.map(|image| image.key.clone()).collect(),
        }
    }
}

/// What the document holds of a file: keys of spectra and of images.
#[derive(Clone, Debug, Default, PartialEq)]
struct Held {
    keys: Vec<String>,
    images: Vec<String>,
}

impl Held {
    fn is_empty(&self) -> bool {
        self.keys.is_empty() && self.images.is_empty()
    }

    fn has(&self, key: &str) -> bool {
        self.keys.iter().chain(&self.images).any(|k| k == key)
    }

    /// Whether they are of the same file.
    fn meets(&self, other: &Self) -> bool {
        let first = |keys: &[String], others: &[String]| {
            keys.first().is_some_and(|key| others.first() == Some(key))
        };
        first(&self.keys, &other.keys) || first(&self.images, &other.images)
    }

    /// The first spectrum or image, as the document has it: other places hold copies.
    fn first(&self, document: &Document) -> First {
        let own = || {
            let key = self.keys.first()?;
            document.own.iter().find(|e| e.key == *key)
        };
        let image = || {
            let key = self.images.first()?;
            document.images.iter().find(|i| i.key == *key)
        };
        match (own(), image()) {
            (Some(entry), _) => First::Spectrum(Arc::downgrade(entry)),
            (None, Some(image)) => First::Image(Arc::downgrade(image)),
            (None, None) => First::None,
        }
    }
}

/// What tells one reading of a file from another: the very thing that the document holds of it.
#[derive(Clone, Debug)]
enum First {
    None,
    Spectrum(Weak<Entry>),
    Image(Weak<ImageEntry>),
}

impl PartialEq for First {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Spectrum(a), Self::Spectrum(b)) => a.ptr_eq(b),
            (Self::Image(a), Self::Image(b)) => a.ptr_eq(b),
            _ => false,
        }
    }
}

/// A file that was opened, to be read again.
#[derive(Clone, Debug)]
pub struct Source {
    path: Option<PathBuf>,
    bytes: Option<Arc<[u8]>>,
    file: String,
    /// Its spectra are of no interest: they are the user's own numbers since long.
    images_only: bool,
}

impl Source {
    /// Where a file that was opened came from.
    pub fn of(opened: &Opened) -> Self {
        Self {
            path: opened.path.clone(),
            bytes: opened.bytes.clone(),
            file: opened.file.clone(),
            images_only: false,
        }
    }

    /// The file of an image that was read again from a workspace.
    fn of_image(image: &ImageEntry) -> Self {
        Self {
            path: image.path.clone(),
            bytes: None,
            file: image.image.source.clone(),
            images_only: true,
        }
    }

    fn is_small(&self) -> bool {
        let size = match (&self.bytes, &self.path) {
            (Some(bytes), _) => bytes.len() as u64,
            (None, Some(path)) => std::fs::metadata(path).map_or(0, |about| about.len()),
            (None, None) => 0,
        };
        size <= AT_ONCE_BYTES
    }

    /// The file read again; a refusal is one line.
    fn read(&self, choices: &Choices) -> Result<Opened, String> {
        let read = || match (&self.bytes, &self.path) {
            (Some(bytes), _) => load_bytes_as(&self.file, bytes, choices),
            (None, Some(path)) => load_path_as(path, choices),
            (None, None) => Loaded::Refused(format!("{}: it cannot be read again", self.file)),
        };
        // A panic in a reader must not take the window along.
        let loaded = std::panic::catch_unwind(std::panic::AssertUnwindSafe(read));
        match loaded {
            Ok(Loaded::File(opened)) if opened.spectra.is_empty() && opened.images.is_empty() => {
                Err(format!("{}: found no spectrum", self.file))
            }
            Ok(Loaded::File(mut opened)) => {
                if self.images_only {
                    opened.spectra.clear();
                    opened.guesses.clear();
                }
                Ok(*opened)
            }
            Ok(Loaded::Refused(why)) => Err(why),
            Ok(Loaded::Project { .. }) => Err(format!("{}: it is a project now", self.file)),
            Err(_) => Err(format!("{}: the reader failed on this file", self.file)),
        }
    }

    /// The beginning of the file's text; nothing for a binary file.
    fn head(&self) -> String {
        use std::io::Read;
        let mut bytes = Vec::new();
        match (&self.bytes, &self.path) {
            (Some(all), _) => bytes.extend(&all[..all.len().min(HEAD_BYTES)]),
            (None, Some(path)) => {
                let read = std::fs::File::open(path)
                    .and_then(|file| file.take(HEAD_BYTES as u64).read_to_end(&mut bytes));
                if read.is_err() {
                    return String::new();
                }
            }
            (None, None) => {}
        }
        if text::is_binary(&bytes) {
            return String::new();
        }
        if bytes.len() == HEAD_BYTES {
            // A letter cut in two would make the whole look like another encoding.
            let wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
            let end = bytes.iter().rposition(|b| *b == b'\n').unwrap_or(0);
            bytes.truncate(if wide { end & !1 } else { end });
        }
        text::decode(&bytes).text.into_owned()
    }
}

/// One reading of a file that the document has or had.
#[derive(Clone, Debug)]
struct Mark {
    held: Held,
    first: First,
    choices: Choices,
}

impl Mark {
    fn of(app: &App, held: Held, choices: Choices) -> Self {
        Self {
            first: held.first(app.document()),
            held,
            choices,
        }
    }
}

/// Where own entries came from, in this session: newest last.
#[derive(Clone, Debug, Default)]
pub struct Origins {
    all: Vec<Origin>,
}

#[derive(Clone, Debug)]
struct Origin {
    source: Source,
    before: Before,
    marks: Vec<Mark>,
}

impl Origins {
    /// Remembers a file whose spectra the document has.
    pub fn remember(&mut self, app: &App, source: Source, choices: Choices, before: Before) {
        let held = before.brought(app);
        if !held.is_empty() {
            self.all.push(Origin {
                marks: vec![Mark::of(app, held, choices)],
                source,
                before,
            });
        }
    }

    /// Remembers files that came in together: each with how many spectra and images it brought, in
    /// the order in which they joined the document.
    pub fn remember_each(
        &mut self,
        app: &App,
        files: Vec<(Source, Choices, [usize; 2])>,
        before: &Before,
    ) {
        let joined = before.brought(app);
        let mut keys = joined.keys.into_iter();
        let mut images = joined.images.into_iter();
        for (source, choices, [spectra, pictures]) in files {
            let held = Held {
                keys: keys.by_ref().take(spectra).collect(),
                images: images.by_ref().take(pictures).collect(),
            };
            if !held.is_empty() {
                self.all.push(Origin {
                    marks: vec![Mark::of(app, held, choices)],
                    source,
                    before: before.clone(),
                });
            }
        }
    }

    /// Remembers another reading of a file.
    fn reread(&mut self, app: &App, before: &Held, held: Held, choices: Choices) {
        let found = self.all.iter_mut().rev().find(|origin| {
            let mut marks = origin.marks.iter();
            marks.any(|mark| mark.held.meets(before))
        });
        if let Some(origin) = found {
            origin.marks.push(Mark::of(app, held, choices));
        }
    }

    /// Whether it is known where an own entry came from.
    pub fn knows(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    fn find(&self, key: &str) -> Option<&Origin> {
        let has = |origin: &&Origin| {
            let mut marks = origin.marks.iter();
            marks.any(|mark| mark.held.has(key))
        };
        self.all.iter().rev().find(has)
    }

    /// Starts to read the file of an own entry again, as it was read for it.
    pub fn again(&self, app: &App, key: &str, wake: &Wake) -> Option<Again> {
        let origin = self.find(key)?;
        let of_now = |mark: &&Mark| mark.held.first(app.document()) == mark.first;
        let with_key = |mark: &&Mark| mark.held.has(key);
        let mark = origin
            .marks
            .iter()
            .rev()
            .find(of_now)
            .or_else(|| origin.marks.iter().rev().find(with_key))?;
        let mut reader = Reader::new(origin.source.clone());
        reader.ask(mark.choices.clone(), wake);
        Some(Again {
            reader,
            held: mark.held.clone(),
            before: origin.before.clone(),
        })
    }

    /// Starts to read the file of an image again, as it was read for it: one that came back from
    /// a workspace is none that was opened in this session.
    pub fn image_again(&mut self, app: &App, key: &str, wake: &Wake) -> Option<Again> {
        if !self.knows(key) {
            let images = &app.document().images;
            let image = images.iter().find(|image| image.key == key)?;
            image.path.as_ref()?;
            let of_file = |other: &&Arc<ImageEntry>| {
                (&other.path, &other.choices) == (&image.path, &image.choices)
            };
            let held = Held {
                keys: Vec::new(),
                images: images
                    .iter()
                    .filter(of_file)
                    .map(|i| i.key.clone())
                    .collect(),
            };
            self.all.push(Origin {
                marks: vec![Mark::of(app, held, image.choices.clone())],
                source: Source::of_image(image),
                before: Before::of(app),
            });
        }
        self.again(app, key, wake)
    }
}

/// Reads one file again and again.
struct Reader {
    source: Source,
    small: bool,
    turn: u64,
    /// What is being read, or was and is not taken yet.
    asked: Option<Choices>,
    answer: Option<Result<Opened, String>>,
    job: Job<u64, Result<Opened, String>>,
}

impl Reader {
    fn new(source: Source) -> Self {
        Self {
            small: source.is_small(),
            source,
            turn: 0,
            asked: None,
            answer: None,
            job: Job::default(),
        }
    }

    fn ask(&mut self, choices: Choices, wake: &Wake) {
        if self.asked.is_some() {
            return;
        }
        self.asked = Some(choices.clone());
        if self.small {
            self.answer = Some(self.source.read(&choices));
            return;
        }
        self.turn += 1;
        let source = self.source.clone();
        self.job
            .ask(&self.turn, wake, || move |_| Some(source.read(&choices)));
    }

    /// What was read, once.
    fn take(&mut self) -> Option<(Choices, Result<Opened, String>)> {
        self.asked.as_ref()?;
        if self.answer.is_none() && !self.small {
            self.job.take_in();
            self.answer = match self.job.stage() {
                Stage::Running(_) => None,
                _ => self
                    .job
                    .result_for(&self.turn)
                    .map(|read| Result::clone(read))
                    .or_else(|| Some(Err(format!("{}: not read", self.source.file)))),
            };
        }
        let answer = self.answer.take()?;
        Some((self.asked.take()?, answer))
    }
}

/// A file that is read again to be looked at.
pub struct Again {
    reader: Reader,
    held: Held,
    before: Before,
}

impl Again {
    /// What came of it: `None` while it is being read.
    ///
    /// # Errors
    /// Why it cannot be read any more, in one line.
    pub fn finished(&mut self, app: &App) -> Option<Result<Import, String>> {
        let (_, read) = self.reader.take()?;
        Some(
            read.map(|opened| Import::holding(app, opened, self.held.clone(), self.before.clone())),
        )
    }
}

/// Turns one decision about a file round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flip {
    /// What stands between cells.
    Delimiter(Delimiter),
    /// Whether decimals are marked by a comma.
    DecimalComma(bool),
    /// The column of wavelengths, from 0.
    AxisColumn(usize),
    /// What the wavelength axis counts.
    Wavelengths(WavelengthUnit),
    /// The laser that Raman shifts count from, nm.
    Laser(f64),
    /// What the values stand for, of the spectra that are asked about.
    Kind(Kind),
    /// What the values are counted in, of the spectra that are asked about.
    Counted(Counted),
    /// Whether photon counts of lights stay what they are.
    KeepPhotons(bool),
    /// Back to all that the reader chooses by itself.
    ReadersOwn,
}

/// What a column of the file was taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnRole {
    /// Wavelengths.
    Wavelengths,
    /// Values of a spectrum.
    Values,
    /// Neither.
    LeftOut,
}

impl ColumnRole {
    /// A word and a mark for it.
    pub fn words(self) -> &'static str {
        match self {
            Self::Wavelengths => "λ wavelengths",
            Self::Values => "● values",
            Self::LeftOut => "– left out",
        }
    }
}

/// The first rows of a file as its table was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Head {
    /// Lines above the table, the last ones.
    pub above: Vec<String>,
    /// What each shown column was taken for.
    pub roles: Vec<ColumnRole>,
    /// Titles of the shown columns; empty when the line above is none of titles.
    pub titles: Vec<String>,
    /// Cells of the first rows.
    pub rows: Vec<Vec<String>>,
    /// Columns that are not shown.
    pub more_columns: usize,
    /// Whether the wavelengths stand in a row.
    pub along_rows: bool,
}

impl Head {
    /// Columns that are held of every row.
    pub fn width(&self) -> usize {
        self.roles.len()
    }
}

/// A decision with its other answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// What is decided.
    pub what: &'static str,
    /// What it means, in a sentence.
    pub meaning: &'static str,
    /// The answers; one is chosen, but where the file is of a kind that is not offered.
    pub answers: Vec<Answer>,
    /// What spoke for the chosen one.
    pub because: String,
    /// Whether a person should look.
    pub doubtful: bool,
    /// Whether it applies: what does not keeps its place, so that nothing moves when it does.
    pub applies: bool,
}

/// Which spectra (or images) of a file the questions are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// All that were understood as the one at this place was.
    Alike(usize),
    /// One alone.
    One(usize),
}

/// Some of a file's spectra or images that can be asked about.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// "all 2 taken as reflectance: R(adaxial), R(abaxial)", or a name with its kind.
    pub words: String,
    /// What takes the questions there.
    pub about: About,
    /// Whether a person should look at it.
    pub doubtful: bool,
}

/// Single spectra that are offered to be asked about.
const MOST_PARTS: usize = 200;

/// One answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// In a word.
    pub words: String,
    /// What takes the file there.
    pub flip: Flip,
    /// Whether the file was read so.
    pub chosen: bool,
}

/// A reading that the document has or had: an undo goes back to it here too.
struct Known {
    opened: Arc<Opened>,
    held: Held,
    first: First,
    head: Head,
    alike: Vec<Alike>,
}

/// Readings kept for undo.
const MOST_KNOWN: usize = 24;

/// A look at how one file was read.
pub struct Import {
    known: Vec<Known>,
    shown: usize,
    text: String,
    refusal: Option<String>,
    reader: Reader,
    before: Before,
    about: About,
}

impl Import {
    /// A look at a file that was opened just now; `None` when it brought nothing.
    pub fn of(app: &App, opened: Opened, before: Before) -> Option<Self> {
        let held = before.brought(app);
        (!held.is_empty()).then(|| Self::holding(app, opened, held, before))
    }

    fn holding(app: &App, opened: Opened, held: Held, before: Before) -> Self {
        let source = Source::of(&opened);
        let text = source.head();
        let mut import = Self {
            known: Vec::new(),
            shown: 0,
            text,
            refusal: None,
            reader: Reader::new(source),
            before,
            about: About::Alike(0),
        };
        import.know(app, opened, held);
        import.about = About::Alike(import.first_doubtful());
        import
    }

    fn know(&mut self, app: &App, opened: Opened, held: Held) {
        if self.known.len() == MOST_KNOWN {
            self.known.remove(0);
        }
        self.known.push(Known {
            first: held.first(app.document()),
            head: head(&self.text, opened.table.as_ref()),
            alike: alike(&opened),
            opened: Arc::new(opened),
            held,
        });
        self.shown = self.known.len() - 1;
    }

    fn now(&self) -> &Known {
        &self.known[self.shown]
    }

    /// The file as it was read last.
    pub fn opened(&self) -> &Arc<Opened> {
        &self.now().opened
    }

    /// Keys of its entries.
    pub fn keys(&self) -> &[String] {
        &self.now().held.keys
    }

    /// Its first rows.
    pub fn head(&self) -> &Head {
        &self.now().head
    }

    /// Why the last wish could not be fulfilled, in one line.
    pub fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }

    /// Whether the file is being read again.
    pub fn is_reading(&self) -> bool {
        self.reader.asked.is_some()
    }

    /// Whether a person decided anything about it.
    pub fn has_choices(&self) -> bool {
        self.opened().choices != Choices::default()
    }

    /// Reads the file again with one decision turned round.
    pub fn flip(&mut self, flip: Flip, wake: &Wake) {
        let choices = self.choices_after(flip);
        if choices != self.opened().choices {
            self.reader.ask(choices, wake);
        }
    }

    fn choices_after(&self, flip: Flip) -> Choices {
        let opened = self.opened();
        let mut choices = opened.choices.clone();
        let dialect = opened.table.as_ref().map(|table| table.dialect);
        match flip {
            Flip::Delimiter(delimiter) => {
                choices.dialect = dialect.map(|d| Dialect { delimiter, ..d });
                // Columns are counted anew.
                choices.axis_column = None;
                choices.each.clear();
            }
            Flip::DecimalComma(decimal_comma) => {
                choices.dialect = dialect.map(|d| Dialect { decimal_comma, ..d });
                choices.each.clear();
            }
            Flip::AxisColumn(column) => {
                choices.axis_column = Some(column);
                choices.each.clear();
            }
            Flip::Wavelengths(unit) => choices.wavelengths = Some(unit),
            Flip::Laser(nm) => choices.laser_nm = Some(nm),
            Flip::Kind(kind) => self.choose(
                &mut choices,
                |choices| choices.kind = Some(kind),
                |one| one.kind = Some(kind),
                |one| one.kind = None,
            ),
            Flip::Counted(counted) => self.choose(
                &mut choices,
                |choices| choices.counted = Some(counted),
                |one| one.counted = Some(counted),
                |one| one.counted = None,
            ),
            Flip::KeepPhotons(keep) => choices.keep_photons = keep,
            Flip::ReadersOwn => choices = Choices::default(),
        }
        choices
    }

    /// Decides for all of the file, or for the parts that are asked about.
    fn choose(
        &self,
        choices: &mut Choices,
        of_all: impl Fn(&mut Choices),
        of_one: impl Fn(&mut OfOne),
        forget: impl Fn(&mut OfOne),
    ) {
        let parts = self.asked_about();
        let is_all = parts.len() == self.now().alike.len();
        let each = if self.is_of_images() {
            &mut choices.each_image
        } else {
            &mut choices.each
        };
        if is_all {
            each.values_mut().for_each(forget);
            each.retain(|_, one| *one != OfOne::default());
            of_all(choices);
        } else {
            for part in parts {
                of_one(each.entry(part).or_default());
            }
        }
    }

    /// Whether the questions are about images.
    pub fn is_of_images(&self) -> bool {
        !self.opened().images.is_empty()
    }

    /// The parts of the file that the questions are about.
    fn asked_about(&self) -> Vec<usize> {
        let alike = &self.now().alike;
        match self.about {
            About::One(at) => vec![at],
            About::Alike(at) => {
                let of = alike.get(at);
                (0..alike.len()).filter(|i| alike.get(*i) == of).collect()
            }
        }
    }

    /// The part that stands for all that are asked about.
    fn asked_first(&self) -> usize {
        let (About::One(at) | About::Alike(at)) = self.about;
        at
    }

    fn first_doubtful(&self) -> usize {
        let mut alike = self.now().alike.iter();
        alike.position(|one| one.doubtful).unwrap_or(0)
    }

    /// Which part of the file is asked about.
    pub fn about(&self) -> About {
        self.about
    }

    /// Asks about another part of the file.
    pub fn ask_about(&mut self, about: About) {
        self.about = about;
    }

    /// What of the file can be asked about: those understood alike, then each by itself; nothing
    /// where there is one only.
    pub fn parts(&self) -> Vec<Part> {
        let alike = &self.now().alike;
        if alike.len() < 2 {
            return Vec::new();
        }
        let mut parts = Vec::new();
        let mut known: Vec<&Alike> = Vec::new();
        for (at, one) in alike.iter().enumerate() {
            if known.contains(&one) {
                continue;
            }
            known.push(one);
            let count = alike.iter().filter(|other| *other == one).count();
            if count > 1 {
                parts.push(Part {
                    words: self.words_of_many(one, count),
                    about: About::Alike(at),
                    doubtful: one.doubtful,
                });
            }
        }
        parts.extend((0..alike.len().min(MOST_PARTS)).map(|at| Part {
            words: format!("{}: {}", self.name_of(at), alike[at].kind.word()),
            about: About::One(at),
            doubtful: alike[at].doubtful,
        }));
        parts
    }

    /// What is asked about, in words.
    pub fn about_words(&self) -> String {
        let alike = &self.now().alike;
        let at = self.asked_first();
        match (alike.get(at), self.asked_about().len()) {
            (Some(one), 2..) => self.words_of_many(one, self.asked_about().len()),
            (Some(one), _) => format!("{}: {}", self.name_of(at), one.kind.word()),
            (None, _) => String::new(),
        }
    }

    fn words_of_many(&self, one: &Alike, count: usize) -> String {
        let what = if self.is_of_images() {
            "images"
        } else {
            "spectra"
        };
        let all = if count == self.now().alike.len() {
            "all"
        } else {
            "the"
        };
        let told = if one.guessed { "taken as" } else { "of" };
        format!("{all} {count} {what} {told} {}", one.kind.word())
    }

    fn name_of(&self, at: usize) -> &str {
        let opened = self.opened();
        if self.is_of_images() {
            opened.images.get(at).map_or("", |image| &image.name)
        } else {
            opened.spectra.get(at).map_or("", |spectrum| &spectrum.name)
        }
    }

    /// Puts what was read meanwhile into the document, one step of undo each; a refusal keeps the
    /// last good reading. Says whether anything changed.
    pub fn settle(&mut self, app: &mut App, origins: &mut Origins) -> bool {
        let Some((choices, read)) = self.reader.take() else {
            return false;
        };
        let opened = match read {
            Ok(opened) => opened,
            Err(why) => {
                self.refusal = Some(why);
                return true;
            }
        };
        self.refusal = None;
        let held = self.now().held.clone();
        let keys = &held.keys;
        app.end_gesture();
        app.apply(Command::Reread {
            keys: keys.clone(),
            images: held.images.clone(),
            opened: Box::new(opened.clone()),
        });
        app.end_gesture();
        let count = opened.spectra.len();
        let own = &app.document().own;
        let joined = count.saturating_sub(keys.len());
        let new = own[own.len().saturating_sub(joined)..].iter();
        let new_keys: Vec<String> = keys
            .iter()
            .take(count)
            .cloned()
            .chain(new.map(|e| e.key.clone()))
            .collect();
        let new = Held {
            keys: new_keys,
            images: held.images.clone(),
        };
        origins.reread(app, &held, new.clone(), choices);
        self.know(app, opened, new);
        let parts = self.now().alike.len();
        if self.asked_first() >= parts {
            self.about = About::Alike(0);
        }
        true
    }

    /// Follows an undo, a redo or a removal; false when the document has nothing of the file any
    /// more.
    pub fn follow(&mut self, app: &App) -> bool {
        let now = self.now();
        let document = app.document();
        let is_there = |known: &Known| known.held.first(document) == known.first;
        if is_there(now) {
            return true;
        }
        if let Some(index) = self.known.iter().rposition(is_there) {
            self.shown = index;
            self.refusal = None;
        }
        let held = &self.now().held;
        document.own.iter().any(|e| held.keys.contains(&e.key))
            || document.images.iter().any(|i| held.images.contains(&i.key))
    }

    /// The document without the file's spectra, with what was on screen before them: one step of
    /// undo.
    pub fn removal(&self, app: &App) -> Command {
        let keys = self.keys();
        let is_gone = |key: &str| keys.iter().any(|k| k == key);
        let mut document = app.document().clone();
        let images = &self.now().held.images;
        document.images.retain(|i| !images.contains(&i.key));
        document.own.retain(|e| !is_gone(&e.key));
        document.overlays.retain(|e| !is_gone(&e.key));
        for key in keys {
            document.edits.remove(key);
            document.products.forget(key);
        }
        // Another of the user's own may have gone, or changed, meanwhile.
        let still = |entry: &Arc<Entry>| match entry.shelf {
            Some(_) => Some(entry.clone()),
            None => document.own.iter().find(|e| e.key == entry.key).cloned(),
        };
        let was_light = is_gone(&document.light.key);
        let was_factor = document.factor.as_ref().is_some_and(|f| is_gone(&f.key));
        if was_light {
            document.light = still(&self.before.light)
                .or_else(|| app.entry(FIRST_LIGHT))
                .unwrap_or_else(|| self.before.light.clone());
        }
        if was_factor {
            document.factor = self.before.factor.as_ref().and_then(still);
        }
        if was_light || was_factor {
            document.subject = match document.factor {
                Some(_) => self.before.subject,
                None => Subject::Light,
            };
        }
        document.weigh_the_papers_lamps();
        Command::Replace(Box::new(document))
    }

    /// What was decided about the file, with the other answers; only what applies to it. What is
    /// most often in doubt comes first, and rows do not change places when they are answered.
    pub fn questions(&self) -> Vec<Question> {
        let opened = self.opened();
        let at = self.asked_first();
        let all = if self.is_of_images() {
            &opened.images_understood
        } else {
            &opened.understood
        };
        // The questions of one file are the same whatever is asked about.
        let understood = all
            .get(at)
            .or(all.first().filter(|_| at >= MOST_UNDERSTOOD));
        let mut questions = Vec::new();
        if let Some(one) = self.now().alike.get(at) {
            questions.push(kind_question(one, all.get(at), opened, at));
            questions.push(counted_question(
                understood.and_then(|u| u.counted.as_ref()),
                opened.format,
            ));
        }
        match understood.and_then(|u| u.axis.as_ref()) {
            Some(AxisTold::Unit(told)) => questions.push(Question {
                what: "Wavelengths in",
                meaning: "What the numbers of the wavelength axis count.",
                answers: answers(WavelengthUnit::ALL, told.is, Flip::Wavelengths, |unit| {
                    unit.word().to_owned()
                }),
                because: why(told),
                doubtful: AxisTold::Unit(told.clone()).is_doubtful(),
                applies: true,
            }),
            Some(AxisTold::Laser(told)) => questions.push(laser_question(told)),
            None => {}
        }
        if opened.photons {
            questions.push(photon_question(&opened.choices));
        }
        if let Some(table) = &opened.table {
            questions.extend(table_questions(table, &opened.choices));
        }
        questions
    }
}

/// What becomes of photon counts.
fn photon_question(choices: &Choices) -> Question {
    Question {
        what: "Photons are",
        meaning: "Colours and errors are of power: a photon of half the wavelength carries twice \
                  as much of it.",
        answers: answers(
            [false, true],
            choices.keep_photons,
            Flip::KeepPhotons,
            |keep| {
                if keep {
                    "as they are"
                } else {
                    "turned into power"
                }
                .to_owned()
            },
        ),
        because: if choices.keep_photons {
            "chosen by hand".to_owned()
        } else {
            "the unit counts photons".to_owned()
        },
        doubtful: false,
        applies: true,
    }
}

/// Kinds that are offered.
const KINDS: [Kind; 5] = [
    Kind::Light,
    Kind::Reflectance,
    Kind::Transmittance,
    Kind::Absorbance,
    Kind::Other,
];

/// What tells whether two spectra of a file were understood alike.
#[derive(Clone, Debug, PartialEq)]
struct Alike {
    kind: Kind,
    guessed: bool,
    by_hand: bool,
    doubtful: bool,
}

/// How each spectrum of a file was understood, or each of its images.
fn alike(opened: &Opened) -> Vec<Alike> {
    let Choices {
        each, each_image, ..
    } = &opened.choices;
    if !opened.images.is_empty() {
        let images = opened.images.iter().zip(&opened.images_understood);
        return images
            .enumerate()
            .map(|(at, (image, understood))| Alike {
                kind: image.kind,
                guessed: !understood.kind.stated,
                by_hand: each_image.contains_key(&at),
                doubtful: understood.is_doubtful(),
            })
            .collect();
    }
    let spectra = opened.spectra.iter().enumerate();
    let mut all: Vec<Alike> = spectra
        .map(|(at, spectrum)| Alike {
            kind: spectrum.kind,
            guessed: false,
            by_hand: each.contains_key(&at),
            doubtful: false,
        })
        .collect();
    for guess in &opened.guesses {
        if let Some(one) = all.get_mut(guess.spectrum) {
            one.guessed |= guess.what == Guessed::Kind;
            one.doubtful |= guess.is_doubtful();
        }
    }
    all
}

fn kind_question(
    one: &Alike,
    understood: Option<&Understood>,
    opened: &Opened,
    at: usize,
) -> Question {
    let mut guesses = opened.guesses.iter();
    let guess = guesses.find(|guess| guess.what == Guessed::Kind && guess.spectrum == at);
    let because = match (understood, guess) {
        (Some(understood), _) => why(&understood.kind),
        (None, Some(guess)) => guess.because.clone(),
        (None, None) if opened.choices.kind_of(at).is_some() => BY_HAND.to_owned(),
        (None, None) => "stated by the file".to_owned(),
    };
    let doubtful = match understood {
        Some(understood) => !understood.kind.plain,
        None => guess.is_some_and(Guess::is_doubtful),
    };
    let mut kinds = KINDS.to_vec();
    if !kinds.contains(&one.kind) {
        kinds.push(one.kind);
    }
    Question {
        what: "Values are",
        meaning: "What the values stand for: a light is drawn as a light, a reflectance or \
                  transmittance is looked at under one.",
        answers: answers(kinds, one.kind, Flip::Kind, |kind| kind.word().to_owned()),
        because,
        doubtful,
        applies: true,
    }
}

fn counted_question(told: Option<&Told<Counted>>, format: &str) -> Question {
    let is = told.map(|told| told.is);
    let is_stored_large = |counted| is == Some(counted) || format == envi::FORMAT.name;
    let offered = [
        Counted::Percent,
        Counted::Fraction,
        Counted::TenThousandths,
        Counted::Otherwise,
    ]
    .into_iter()
    .filter(|counted| match counted {
        Counted::Percent | Counted::Fraction => true,
        Counted::TenThousandths => is_stored_large(*counted),
        Counted::Otherwise => is == Some(*counted),
    });
    Question {
        what: "Counted in",
        meaning: "Whether a value of 100, of 1 or of 10 000 reflects (or transmits) all of the \
                  light; fractions are taken as they are.",
        answers: offered
            .map(|counted| Answer {
                words: counted.word().to_owned(),
                flip: Flip::Counted(counted),
                chosen: is == Some(counted),
            })
            .collect(),
        because: told.map_or_else(
            || "asked of reflectances and transmittances".to_owned(),
            why,
        ),
        doubtful: told.is_some_and(|told| !told.plain),
        applies: told.is_some(),
    }
}

/// Lasers of Raman spectrometers that are sold, nm.
const LASERS_NM: [f64; 7] = [405.0, 488.0, 514.5, 532.0, 633.0, 785.0, 1064.0];

fn laser_question(told: &Told<f64>) -> Question {
    let mut lasers = LASERS_NM.to_vec();
    if !lasers.contains(&told.is) {
        lasers.push(told.is);
        lasers.sort_by(f64::total_cmp);
    }
    Question {
        what: "Shifts from",
        meaning: "The laser, in nm, from whose line the Raman shifts count.",
        answers: answers(lasers, told.is, Flip::Laser, |nm| format!("{nm} nm")),
        because: why(told),
        doubtful: !told.plain,
        applies: true,
    }
}

fn why<T>(told: &Told<T>) -> String {
    match (told.stated, told.because.as_str()) {
        (false, because) => because.to_owned(),
        (true, BY_HAND) => BY_HAND.to_owned(),
        (true, because) => format!("stated by the file: {because}"),
    }
}

fn answers<T: Copy + PartialEq>(
    all: impl IntoIterator<Item = T>,
    chosen: T,
    flip: impl Fn(T) -> Flip,
    words: impl Fn(T) -> String,
) -> Vec<Answer> {
    let answer = |one: T| Answer {
        words: words(one),
        flip: flip(one),
        chosen: one == chosen,
    };
    all.into_iter().map(answer).collect()
}

fn table_questions(table: &TableFound, choices: &Choices) -> Vec<Question> {
    let because =
        |by_hand: bool, otherwise: &str| if by_hand { BY_HAND } else { otherwise }.to_owned();
    let by_hand = choices.dialect.is_some();
    let delimiters = [
        Delimiter::Tab,
        Delimiter::Semicolon,
        Delimiter::Comma,
        Delimiter::Space,
    ];
    let mut questions = Vec::new();
    if let Some(axis) = table.axis_column {
        let columns = (0..table.width).filter(|c| *c < MOST_COLUMNS || *c == axis);
        questions.push(Question {
            what: "Wavelength column",
            meaning: "Which column holds the wavelengths.",
            answers: answers(columns, axis, Flip::AxisColumn, |column| {
                (column + 1).to_string()
            }),
            because: because(
                choices.axis_column.is_some(),
                "it rises or falls throughout",
            ),
            doubtful: false,
            applies: true,
        });
    }
    questions.extend([
        Question {
            what: "Cells between",
            meaning: "What stands between two cells of a row.",
            answers: answers(
                delimiters,
                table.dialect.delimiter,
                Flip::Delimiter,
                |delimiter| {
                    match delimiter {
                        Delimiter::Tab => "TAB",
                        Delimiter::Semicolon => "semicolon ;",
                        Delimiter::Comma => "comma ,",
                        Delimiter::Space => "blanks",
                    }
                    .to_owned()
                },
            ),
            because: because(by_hand, "it makes the most even table"),
            doubtful: false,
            applies: true,
        },
        Question {
            what: "Decimal mark",
            meaning: "What stands before the decimals of a number.",
            answers: answers(
                [false, true],
                table.dialect.decimal_comma,
                Flip::DecimalComma,
                |comma| {
                    if comma {
                        "decimal comma"
                    } else {
                        "decimal point"
                    }
                    .to_owned()
                },
            ),
            because: because(by_hand, "it makes the most numbers"),
            doubtful: false,
            applies: true,
        },
    ]);
    questions
}

/// The first rows of a text, cut as its table was.
fn head(text: &str, table: Option<&TableFound>) -> Head {
    let Some(table) = table else {
        return Head::default();
    };
    let mut head = Head {
        along_rows: table.axis_column.is_none(),
        more_columns: table.width.saturating_sub(MOST_COLUMNS),
        ..Head::default()
    };
    let columns = table.width.min(MOST_COLUMNS);
    head.roles = (0..columns).map(|column| role(table, column)).collect();
    let cut = |line: &str| -> (usize, Vec<String>) {
        let mut cells = Vec::new();
        table.dialect.split(line, &mut cells);
        let shown = cells.iter().take(columns);
        (
            crate::io::dialect::used(&cells),
            shown.map(|cell| shortened(cell, CELL_LETTERS)).collect(),
        )
    };
    let mut above: Vec<&str> = Vec::new();
    for (number, line) in text::lines(text) {
        if number < table.first_line {
            if !line.trim().is_empty() {
                above.push(line);
            }
            continue;
        }
        if head.rows.len() == ROWS {
            break;
        }
        if !line.trim().is_empty() {
            head.rows.push(cut(line).1);
        }
    }
    if let Some(last) = above.last() {
        let (width, titles) = cut(last);
        if width == table.width && width > 1 {
            head.titles = titles;
            above.pop();
        }
    }
    let first = above.len().saturating_sub(LINES_ABOVE);
    head.above = above[first..]
        .iter()
        .map(|line| shortened(line, LINE_LETTERS))
        .collect();
    if first > 0 {
        head.above.insert(0, format!("… {first} lines above"));
    }
    head
}

fn role(table: &TableFound, column: usize) -> ColumnRole {
    match table.axis_column {
        None => ColumnRole::Values,
        Some(axis) if axis == column => ColumnRole::Wavelengths,
        Some(_) if table.values.contains(&column) => ColumnRole::Values,
        Some(_) => ColumnRole::LeftOut,
    }
}

/// A text for the screen: no control signs (fonts have none), and not too long.
fn shortened(text: &str, letters: usize) -> String {
    let clean = |c: char| {
        if c.is_control() || c == '\u{fffd}' {
            ' '
        } else {
            c
        }
    };
    let mut shown: String = text.chars().take(letters).map(clean).collect();
    if text.chars().nth(letters).is_some() {
        shown.push('…');
    }
    shown
}
