//! How a file was read, to look at and to turn round: its first rows, what was decided and why,
//! and every other choice one step away. The spectra are in the document already.

use std::{
    path::PathBuf,
    sync::{Arc, Weak},
};

use super::{
    command::Command,
    document::{FIRST_LIGHT, Subject},
    entry::Entry,
    open::{Loaded, load_bytes_as, load_path_as},
    opened::Opened,
    state::App,
    studies::{Job, Stage, Wake},
};
use crate::{
    io::{
        Choices, Dialect, Guessed,
        dialect::Delimiter,
        reading::{TableFound, Told},
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
const ROWS: usize = 10;

/// Columns shown, and columns offered for the wavelengths.
pub const MOST_COLUMNS: usize = 8;

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
        }
    }

    /// Keys of the entries that joined since.
    pub fn joined(&self, app: &App) -> Vec<String> {
        let own = app.document().own.iter().skip(self.own);
        own.map(|entry| entry.key.clone()).collect()
    }
}

/// A file that was opened, to be read again.
#[derive(Clone, Debug)]
pub struct Source {
    path: Option<PathBuf>,
    bytes: Option<Arc<[u8]>>,
    file: String,
}

impl Source {
    /// Where a file that was opened came from.
    pub fn of(opened: &Opened) -> Self {
        Self {
            path: opened.path.clone(),
            bytes: opened.bytes.clone(),
            file: opened.file.clone(),
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
            Ok(Loaded::File(opened)) if opened.spectra.is_empty() => {
                Err(format!("{}: found no spectrum", self.file))
            }
            Ok(Loaded::File(opened)) => Ok(*opened),
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
    keys: Vec<String>,
    first: Weak<Entry>,
    choices: Choices,
}

impl Mark {
    fn of(app: &App, keys: &[String], choices: Choices) -> Self {
        Self {
            keys: keys.to_vec(),
            first: first_entry(app, keys).map_or_else(Weak::new, |entry| Arc::downgrade(&entry)),
            choices,
        }
    }

    fn is_of(&self, entry: &Arc<Entry>) -> bool {
        std::ptr::eq(self.first.as_ptr(), Arc::as_ptr(entry))
    }
}

/// The own entry, as the list has it: other places hold copies.
fn own_entry(app: &App, key: &str) -> Option<Arc<Entry>> {
    app.document().own.iter().find(|e| e.key == key).cloned()
}

fn first_entry(app: &App, keys: &[String]) -> Option<Arc<Entry>> {
    own_entry(app, keys.first()?)
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
        let keys = before.joined(app);
        if !keys.is_empty() {
            self.all.push(Origin {
                marks: vec![Mark::of(app, &keys, choices)],
                source,
                before,
            });
        }
    }

    /// Remembers files that came in together: each with how many spectra it brought, in the order
    /// in which they joined the document.
    pub fn remember_each(
        &mut self,
        app: &App,
        files: Vec<(Source, Choices, usize)>,
        before: &Before,
    ) {
        let joined = before.joined(app);
        let mut rest = &joined[..];
        for (source, choices, count) in files {
            let (keys, others) = rest.split_at(count.min(rest.len()));
            rest = others;
            if !keys.is_empty() {
                self.all.push(Origin {
                    marks: vec![Mark::of(app, keys, choices)],
                    source,
                    before: before.clone(),
                });
            }
        }
    }

    /// Remembers another reading of a file.
    fn reread(&mut self, app: &App, before: &[String], keys: &[String], choices: Choices) {
        let found = self.all.iter_mut().rev().find(|origin| {
            let mut marks = origin.marks.iter();
            marks.any(|mark| mark.keys.first() == before.first())
        });
        if let Some(origin) = found {
            origin.marks.push(Mark::of(app, keys, choices));
        }
    }

    /// Whether it is known where an own entry came from.
    pub fn knows(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    fn find(&self, key: &str) -> Option<&Origin> {
        let has = |origin: &&Origin| {
            let mut keys = origin.marks.iter().flat_map(|mark| &mark.keys);
            keys.any(|k| k == key)
        };
        self.all.iter().rev().find(has)
    }

    /// Starts to read the file of an own entry again, as it was read for it.
    pub fn again(&self, app: &App, key: &str, wake: &Wake) -> Option<Again> {
        let origin = self.find(key)?;
        let of_now = |mark: &&Mark| first_entry(app, &mark.keys).is_some_and(|e| mark.is_of(&e));
        let with_key = |mark: &&Mark| mark.keys.iter().any(|k| k == key);
        let mark = origin
            .marks
            .iter()
            .rev()
            .find(of_now)
            .or_else(|| origin.marks.iter().rev().find(with_key))?;
        let mut reader = Reader::new(origin.source.clone());
        reader.ask(mark.choices, wake);
        Some(Again {
            reader,
            keys: mark.keys.clone(),
            before: origin.before.clone(),
        })
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
        self.asked = Some(choices);
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
        let choices = self.asked?;
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
        self.asked = None;
        Some((choices, answer))
    }
}

/// A file that is read again to be looked at.
pub struct Again {
    reader: Reader,
    keys: Vec<String>,
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
            read.map(|opened| {
                Import::with_keys(app, opened, self.keys.clone(), self.before.clone())
            }),
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
    /// What the values stand for.
    Kind(Kind),
    /// Whether values are per cent.
    Percent(bool),
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
}

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
    keys: Vec<String>,
    first: Weak<Entry>,
    head: Head,
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
}

impl Import {
    /// A look at a file that was opened just now; `None` when it brought no spectra.
    pub fn of(app: &App, opened: Opened, before: Before) -> Option<Self> {
        let keys = before.joined(app);
        (!keys.is_empty() && !opened.spectra.is_empty())
            .then(|| Self::with_keys(app, opened, keys, before))
    }

    fn with_keys(app: &App, opened: Opened, keys: Vec<String>, before: Before) -> Self {
        let source = Source::of(&opened);
        let text = source.head();
        let mut import = Self {
            known: Vec::new(),
            shown: 0,
            text,
            refusal: None,
            reader: Reader::new(source),
            before,
        };
        import.know(app, opened, keys);
        import
    }

    fn know(&mut self, app: &App, opened: Opened, keys: Vec<String>) {
        if self.known.len() == MOST_KNOWN {
            self.known.remove(0);
        }
        self.known.push(Known {
            first: first_entry(app, &keys).map_or_else(Weak::new, |e| Arc::downgrade(&e)),
            head: head(&self.text, opened.table.as_ref()),
            opened: Arc::new(opened),
            keys,
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
        &self.now().keys
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
        let mut choices = opened.choices;
        let dialect = opened.table.as_ref().map(|table| table.dialect);
        match flip {
            Flip::Delimiter(delimiter) => {
                choices.dialect = dialect.map(|d| Dialect { delimiter, ..d });
                // Columns are counted anew.
                choices.axis_column = None;
            }
            Flip::DecimalComma(decimal_comma) => {
                choices.dialect = dialect.map(|d| Dialect { decimal_comma, ..d });
            }
            Flip::AxisColumn(column) => choices.axis_column = Some(column),
            Flip::Wavelengths(unit) => choices.wavelengths = Some(unit),
            Flip::Kind(kind) => choices.kind = Some(kind),
            Flip::Percent(percent) => choices.percent = Some(percent),
            Flip::ReadersOwn => choices = Choices::default(),
        }
        choices
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
        let keys: Vec<String> = self.keys().to_vec();
        app.end_gesture();
        app.apply(Command::Reread {
            keys: keys.clone(),
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
        origins.reread(app, &keys, &new_keys, choices);
        self.know(app, opened, new_keys);
        true
    }

    /// Follows an undo, a redo or a removal; false when the document has nothing of the file any
    /// more.
    pub fn follow(&mut self, app: &App) -> bool {
        let now = self.now();
        let entry = first_entry(app, &now.keys);
        if let Some(entry) = &entry
            && std::ptr::eq(now.first.as_ptr(), Arc::as_ptr(entry))
        {
            return true;
        }
        let is_there = |known: &Known| {
            first_entry(app, &known.keys)
                .is_some_and(|e| std::ptr::eq(known.first.as_ptr(), Arc::as_ptr(&e)))
        };
        if let Some(index) = self.known.iter().rposition(is_there) {
            self.shown = index;
            self.refusal = None;
        }
        let keys = &self.now().keys;
        app.document().own.iter().any(|e| keys.contains(&e.key))
    }

    /// The document without the file's spectra, with what was on screen before them: one step of
    /// undo.
    pub fn removal(&self, app: &App) -> Command {
        let keys = self.keys();
        let is_gone = |key: &str| keys.iter().any(|k| k == key);
        let mut document = app.document().clone();
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
        let mut questions = Vec::new();
        let doubt = |what: Guessed| {
            let mut guesses = opened.guesses.iter();
            guesses.find(|guess| guess.what == what && guess.is_doubtful())
        };
        let understood = opened.understood.as_ref();
        if let Some(first) = opened.spectra.first() {
            let guess = doubt(Guessed::Kind);
            let because = match (guess, understood) {
                (Some(guess), _) => guess.because.clone(),
                (None, Some(understood)) => why(&understood.kind),
                (None, None) if opened.choices.kind.is_some() => "chosen by hand".to_owned(),
                (None, None) => "stated by the file".to_owned(),
            };
            let mut kinds = KINDS.to_vec();
            if !kinds.contains(&first.kind) {
                kinds.push(first.kind);
            }
            questions.push(Question {
                what: "Values are",
                meaning: "What the values stand for: a light is drawn as a light, a reflectance \
                          or transmittance is looked at under one.",
                answers: answers(kinds, first.kind, Flip::Kind, |kind| kind.word().to_owned()),
                because,
                doubtful: guess.is_some(),
            });
        }
        if let Some(told) = understood.and_then(|u| u.percent.as_ref()) {
            questions.push(Question {
                what: "Counted in",
                meaning: "Whether a value of 100 or of 1 reflects (or transmits) all of the light.",
                answers: answers([true, false], told.is, Flip::Percent, |percent| {
                    if percent { "percent" } else { "fraction" }.to_owned()
                }),
                because: why(told),
                doubtful: doubt(Guessed::Percent).is_some(),
            });
        }
        if let Some(understood) = understood {
            let told = &understood.wavelengths;
            questions.push(Question {
                what: "Wavelengths in",
                meaning: "What the numbers of the wavelength axis count.",
                answers: answers(WavelengthUnit::ALL, told.is, Flip::Wavelengths, |unit| {
                    unit.word().to_owned()
                }),
                because: why(told),
                doubtful: doubt(Guessed::WavelengthUnit).is_some(),
            });
        }
        if let Some(table) = &opened.table {
            questions.extend(table_questions(table, &opened.choices));
        }
        questions
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

const BY_HAND: &str = "chosen by hand";

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
