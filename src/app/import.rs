//! How a file was read, to look at and to turn round: its first rows, what was decided and why,
//! and every other choice one step away. The spectra are in the document already.

mod first_rows;
mod origins;
mod questions;

use std::sync::Arc;

pub use self::{
    first_rows::{ColumnRole, Head, MOST_COLUMNS},
    origins::{Again, Before, Origins, Source},
    questions::{Answer, Question},
};
use self::{
    origins::{First, Held, Reader},
    questions::{Alike, alike},
};
use super::{
    command::Command,
    document::{FIRST_LIGHT, Subject},
    entry::Entry,
    opened::Opened,
    state::App,
    studies::Wake,
};
use crate::{
    io::{Choices, Counted, Dialect, choices::OfOne, dialect::Delimiter, units::WavelengthUnit},
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
    /// Back to all that the reader chooses by itself.
    ReadersOwn,
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
            head: first_rows::head(&self.text, opened.table.as_ref()),
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
        let at = self.asked_first();
        questions::all(self.opened(), self.now().alike.get(at), at)
    }
}
