//! How a file was read, to look at and to turn round: its first rows, what was decided and why,
//! and every other choice one step away. The spectra are in the document already.

mod file_reader;
mod first_rows;
mod parts;
mod questions;

use std::sync::Arc;

use self::{
    file_reader::FileReader,
    questions::{Alike, alike},
};
pub use self::{
    first_rows::{ColumnRole, Head, MOST_COLUMNS},
    parts::{About, Part},
    questions::{Answer, Question},
};
use super::{
    command::Command,
    document::{Document, FIRST_LIGHT, Subject},
    memo::ByAddress,
    opened::Opened,
    origin::{FileReading, FromFile, SourceFile},
    state::App,
    studies::Wake,
};
use crate::{
    io::{Choices, Counted, Delimiter, Dialect, OfOne, WavelengthUnit},
    spectrum::Kind,
};

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
    /// Whether a column of deviations is the noise of the one before it.
    TakeSigma(bool),
    /// Back to all that the reader chooses by itself.
    ReadersOwn,
}

/// A look at how one file was read. What the document holds of it is found there, so that an undo
/// is followed.
pub struct Import {
    file: ByAddress<SourceFile>,
    /// The reading that is looked at, as the document has it.
    reading: Arc<FileReading>,
    opened: Arc<Opened>,
    head: Head,
    alike: Vec<Alike>,
    text: String,
    refusal: Option<String>,
    reader: FileReader,
    /// Whether what is being read is to go into the document.
    flips: bool,
    about: About,
}

/// Keys of what a document holds of a file, and where it came from.
fn all_of<'a>(
    document: &'a Document,
    file: &'a ByAddress<SourceFile>,
) -> impl Iterator<Item = (&'a str, &'a FromFile)> {
    let own = document.own.iter();
    let own = own.filter_map(|entry| Some((entry.key.as_str(), entry.origin.file()?)));
    let images = document.images.iter();
    let images = images.map(|image| (image.key.as_str(), &image.from));
    own.chain(images).filter(|(_, from)| from.is_of(file))
}

impl Import {
    /// A look at a file that was opened just now; `None` when it brought nothing.
    pub fn of(app: &App, opened: Opened) -> Option<Self> {
        let document = app.document();
        let newest = if opened.spectra.is_empty() {
            document.images.last().map(|image| &image.from)
        } else {
            document.own.last().and_then(|entry| entry.origin.file())
        };
        let reading = newest?.reading.clone();
        Some(Self::holding(opened, reading))
    }

    fn holding(opened: Opened, reading: Arc<FileReading>) -> Self {
        let file = reading.file.clone();
        let text = file_reader::head(&file);
        let mut import = Self {
            head: first_rows::head(&text, opened.table.as_ref()),
            alike: alike(&opened),
            opened: Arc::new(opened),
            text,
            refusal: None,
            reader: FileReader::new(file.clone()),
            flips: false,
            file: ByAddress(file),
            reading,
            about: About::Alike(0),
        };
        import.about = About::Alike(import.first_doubtful());
        import
    }

    fn look_at(&mut self, opened: Opened, reading: Arc<FileReading>) {
        self.refusal = None;
        self.head = first_rows::head(&self.text, opened.table.as_ref());
        self.alike = alike(&opened);
        self.opened = Arc::new(opened);
        self.reading = reading;
        if self.asked_first() >= self.alike.len() {
            self.about = About::Alike(0);
        }
    }

    /// The file as it was read last.
    pub fn opened(&self) -> &Arc<Opened> {
        &self.opened
    }

    /// Its first rows.
    pub fn head(&self) -> &Head {
        &self.head
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
        if choices != self.opened.choices && !self.is_reading() {
            self.flips = true;
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
            Flip::Kind(kind) => {
                self.choose(&mut choices, kind, |all| &mut all.kind, |one| &mut one.kind);
            }
            Flip::Counted(counted) => self.choose(
                &mut choices,
                counted,
                |all| &mut all.counted,
                |one| &mut one.counted,
            ),
            Flip::KeepPhotons(keep) => choices.keep_photons = keep,
            Flip::TakeSigma(take) => choices.take_sigma = take,
            Flip::ReadersOwn => choices = Choices::default(),
        }
        choices
    }

    /// Decides for all of the file, or for the parts that are asked about.
    fn choose<T: Copy>(
        &self,
        choices: &mut Choices,
        chosen: T,
        of_all: fn(&mut Choices) -> &mut Option<T>,
        of_one: fn(&mut OfOne) -> &mut Option<T>,
    ) {
        let parts = self.asked_about();
        let is_all = parts.len() == self.alike.len();
        let each = if self.is_of_images() {
            &mut choices.each_image
        } else {
            &mut choices.each
        };
        if is_all {
            each.values_mut().for_each(|one| *of_one(one) = None);
            each.retain(|_, one| *one != OfOne::default());
            *of_all(choices) = Some(chosen);
        } else {
            for part in parts {
                *of_one(each.entry(part).or_default()) = Some(chosen);
            }
        }
    }

    /// Whether the questions are about images.
    pub fn is_of_images(&self) -> bool {
        !self.opened().images.is_empty()
    }

    /// Puts what was read meanwhile into the document, one step of undo each; a refusal keeps the
    /// last good reading. Says whether anything changed.
    pub fn settle(&mut self, app: &mut App) -> bool {
        let Some(read) = self.reader.take() else {
            return false;
        };
        let opened = match read {
            Ok(opened) => opened,
            Err(why) => {
                self.refusal = Some(why);
                return true;
            }
        };
        if std::mem::take(&mut self.flips)
            && let Some(key) = self.key(app)
        {
            app.end_gesture();
            app.apply(Command::Reread {
                key,
                opened: Box::new(opened.clone()),
            });
            app.end_gesture();
        }
        let of_file = all_of(app.document(), &self.file).next();
        let reading = of_file.map_or(self.reading.clone(), |(_, from)| from.reading.clone());
        self.look_at(opened, reading);
        true
    }

    fn key(&self, app: &App) -> Option<String> {
        let (key, _) = all_of(app.document(), &self.file).next()?;
        Some(key.to_owned())
    }

    /// Follows an undo, a redo or a removal; false when the document has nothing of the file any
    /// more. What an undo brought back is read again: [`Self::settle`] shows it.
    pub fn follow(&mut self, app: &App, wake: &Wake) -> bool {
        let Some((_, from)) = all_of(app.document(), &self.file).next() else {
            return false;
        };
        if !Arc::ptr_eq(&from.reading, &self.reading) && !self.is_reading() {
            self.reading = from.reading.clone();
            self.reader.ask(self.reading.choices.clone(), wake);
        }
        true
    }

    /// The document without the file's spectra, with what was on screen before them: one step of
    /// undo.
    pub fn removal(&self, app: &App) -> Command {
        let mut document = app.document().clone();
        let of_file = all_of(app.document(), &self.file);
        let gone: Vec<&str> = of_file.map(|(key, _)| key).collect();
        let is_gone = |key: &str| gone.contains(&key);
        document.images.retain(|image| !is_gone(&image.key));
        document.own.retain(|e| !is_gone(&e.key));
        document.overlays.retain(|e| !is_gone(&e.key));
        document.second.take_if(|second| is_gone(&second.key));
        for key in gone.iter().copied() {
            document.edits.remove(key);
            document.products.forget(key);
        }
        // Another of the user's own may have gone, or changed, meanwhile.
        let still = |key: &str| app.entry(key).filter(|_| !is_gone(key));
        let before = &self.file.0.before;
        let was_light = is_gone(&document.light.key);
        let was_factor = document.factor.as_ref().is_some_and(|f| is_gone(&f.key));
        if was_light {
            let light = still(&before.light).or_else(|| app.entry(FIRST_LIGHT));
            document.light = light.unwrap_or_else(|| app.bundled()[0].clone());
        }
        if was_factor {
            document.factor = before.factor.as_deref().and_then(still);
        }
        if was_light || was_factor {
            document.subject = match document.factor {
                Some(_) if before.about_factor => Subject::Factor,
                _ => Subject::Light,
            };
        }
        document.weigh_the_papers_lamps();
        Command::Replace(Box::new(document))
    }

    /// What was decided about the file, with the other answers; only what applies to it. What is
    /// most often in doubt comes first, and rows do not change places when they are answered.
    pub fn questions(&self) -> Vec<Question> {
        let at = self.asked_first();
        questions::all(self.opened(), self.alike.get(at), at)
    }
}

/// A file that is read again to be looked at, as it was read for what the document holds of it.
pub struct Again {
    reader: FileReader,
    reading: Arc<FileReading>,
}

impl Again {
    /// Starts to read the file that something came from.
    pub fn of(from: &FromFile, wake: &Wake) -> Self {
        let reading = from.reading.clone();
        let mut reader = FileReader::new(reading.file.clone());
        reader.ask(reading.choices.clone(), wake);
        Self { reader, reading }
    }

    /// What came of it: `None` while it is being read.
    ///
    /// # Errors
    /// Why it cannot be read any more, in one line.
    pub fn finished(&mut self) -> Option<Result<Import, String>> {
        let read = self.reader.take()?;
        Some(read.map(|opened| Import::holding(opened, self.reading.clone())))
    }
}
