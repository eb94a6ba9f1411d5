//! The lights that are meant by files, folders, projects and names of presets.
//!
//! A file means all its lights, `FILE#SPECTRUM` one of them, a folder all lights in the files below
//! it.

use std::{
    ffi::{OsStr, OsString},
    path::{Path, PathBuf},
    sync::{
        Arc,
        mpsc::{RecvTimeoutError, channel},
    },
    time::Duration,
};

use super::{inputs::Inputs, options::ModelOptions, refusal::Refusal, subject::light};
use crate::{
    app::{
        Document, Entry, Opened, coarse_words,
        measured::is_sigma,
        open::{Came, Found, Loaded, Loader, named},
        quality_report::{Modeller, Sheet},
        workspace::Restored,
    },
    io::{Choices, many::many, name_of, shown, stream::is_stream},
    spectrum::Kind,
};

/// How often is told how far it is.
pub(super) const TOLD_EVERY: Duration = Duration::from_millis(500);

/// What a light's model is made by.
pub(super) enum Of {
    /// The command line's settings.
    Light(Arc<Entry>),
    /// A project's own settings and edits.
    Project(Box<Document>),
}

impl Of {
    /// The light itself.
    pub(super) fn light(&self) -> &Arc<Entry> {
        match self {
            Self::Light(light) => light,
            Self::Project(document) => &document.light,
        }
    }
}

pub(super) struct AskedLight {
    /// What it is called where it stands alone, and among others: there by the word or file that
    /// it came from.
    pub names: [String; 2],
    /// The light.
    pub of: Of,
}

impl AskedLight {
    /// Its figures and those of its model, under one of its names.
    pub(super) fn sheet(&self, name: String, modeller: &Modeller) -> Sheet {
        match &self.of {
            Of::Light(light) => modeller.sheet(name, &modeller.document(light.clone())),
            Of::Project(document) => modeller.sheet(name, document),
        }
    }

    /// Says so where its table is coarse.
    pub(super) fn note_coarse(&self, inputs: &mut Inputs) {
        let light = self.of.light();
        if let Some(words) = coarse_words(&light.spectrum) {
            inputs.note(format!("{}: {words}", light.name()));
        }
    }
}

/// All that is asked for, in its order.
pub(super) struct Asked {
    /// What refusals call the words that named the lights.
    what: &'static str,
    pub lights: Vec<AskedLight>,
    /// Why some INPUTs were refused, a line each.
    pub refused: Vec<String>,
    /// Whether one INPUT was a folder.
    pub has_folder: bool,
}

impl Asked {
    /// Everything that the words mean. A word that is refused does not stop the others.
    /// `what` is what refusals call them.
    pub(super) fn of(
        what: &'static str,
        words: &[OsString],
        model: ModelOptions,
        inputs: &mut Inputs,
    ) -> Self {
        let mut asked = Self {
            what,
            lights: Vec::new(),
            refused: Vec::new(),
            has_folder: false,
        };
        for word in words {
            if let Err(why) = asked.ask(word, model, inputs) {
                asked.refused.push(why);
            }
        }
        asked
    }

    /// Adds what a word means.
    fn ask(
        &mut self,
        word: &OsStr,
        model: ModelOptions,
        inputs: &mut Inputs,
    ) -> Result<(), String> {
        let path = Path::new(word);
        if path.is_dir() {
            self.has_folder = true;
            return self.folder(path, inputs);
        }
        if !is_stream(path) && !path.exists() {
            let entry = light(self.what, word, inputs).map_err(Refusal::into_words)?;
            self.add(shown(path), entry);
            return Ok(());
        }
        match inputs.load(path, &Choices::default()) {
            Loaded::Refused(why) => Err(format!("{}: {why}", self.what)),
            Loaded::Project { restored, .. } => self.project(path, *restored, model, inputs),
            Loaded::File(opened) => self.file(path, *opened, inputs),
        }
    }

    fn add(&mut self, among_others: String, entry: Entry) {
        self.lights.push(AskedLight {
            names: [entry.name().to_owned(), among_others],
            of: Of::Light(Arc::new(entry)),
        });
    }

    fn project(
        &mut self,
        path: &Path,
        restored: Restored,
        model: ModelOptions,
        inputs: &mut Inputs,
    ) -> Result<(), String> {
        let name = shown(path);
        for loss in &restored.losses {
            inputs.note(format!("{name}: {loss}"));
        }
        let mut document = restored.document;
        if !document.is_about_light() {
            return Err(format!(
                "{}: {name}: found a project about a {}, expected a light",
                self.what,
                document.subject_entry().kind()
            ));
        }
        document.settings = model.over(document.settings).clamped();
        self.lights.push(AskedLight {
            names: [document.light.name().to_owned(), name],
            of: Of::Project(Box::new(document)),
        });
        Ok(())
    }

    /// All lights of a file that was named.
    fn file(&mut self, path: &Path, opened: Opened, inputs: &mut Inputs) -> Result<(), String> {
        let name = shown(path);
        let found = every(path, opened, inputs);
        let count = found.spectra.len();
        if found.is_unsaid {
            inputs.note(format!(
                "{}: {name}: found nothing that says what its values are, taken as a light",
                self.what
            ));
        }
        let remedy = match count {
            1 => " (convert it with --kind light if it is one)",
            _ => "",
        };
        let what = self.what;
        match self.lights_of(&name, found.spectra) {
            (0, Some(why)) => Err(format!("{what}: {why}{remedy}")),
            (0, None) => Err(format!(
                "{what}: {name}: found nothing measured, expected a light"
            )),
            (_, others) => {
                if let Some(why) = others {
                    inputs.remark(&skipped(&why));
                }
                Ok(())
            }
        }
    }

    /// Adds the lights among the spectra of a file; how many they are, and what is said of the
    /// others.
    fn lights_of(&mut self, file: &str, spectra: Vec<(String, Entry)>) -> (usize, Option<String>) {
        let (mut lights, mut others) = (0, Vec::new());
        for (index, (at, entry)) in spectra.into_iter().enumerate() {
            // What stands beside a light and tells its noise is none itself.
            if index > 0 && is_sigma(entry.name()) {
                continue;
            }
            let name = format!("{file}{at}");
            if entry.kind() == Kind::Light {
                self.add(name, entry);
                lights += 1;
            } else {
                others.push(format!(
                    "{name}: found {} values, expected a light",
                    entry.kind()
                ));
            }
        }
        let said = match others.len() {
            0 | 1 => others.pop(),
            count => Some(format!(
                "{file}: found {count} spectra that are no lights, expected lights"
            )),
        };
        (lights, said)
    }

    /// All lights in the files of a folder and of those below it.
    fn folder(&mut self, folder: &Path, inputs: &mut Inputs) -> Result<(), String> {
        let (mut files, mut lights, mut unsaid) = (0, 0, 0);
        for (label, path, came) in files_in(folder, inputs) {
            if path == folder {
                let why = of_folder(&label, &path, came).err().unwrap_or_default();
                return Err(format!("{}: {why}", self.what));
            }
            files += usize::from(!path.is_dir());
            let opened = match of_folder(&label, &path, came) {
                Ok(opened) => opened,
                Err(why) => {
                    inputs.remark(&skipped(&why));
                    continue;
                }
            };
            let found = every(&path, opened, inputs);
            unsaid += usize::from(found.is_unsaid);
            let (added, others) = self.lights_of(&label, found.spectra);
            lights += added;
            if let Some(why) = others {
                inputs.remark(&skipped(&why));
            }
        }
        let (name, files) = (shown(folder), many(files, "file", "files"));
        if unsaid > 0 {
            inputs.note(format!(
                "{name}: found {unsaid} of {files} with nothing that says what the values are, \
                 taken as lights"
            ));
        }
        if lights == 0 {
            return Err(format!(
                "{}: {name}: found no light in {files}, expected at least one",
                self.what
            ));
        }
        let lights = many(lights, "light", "lights");
        inputs.remark(&format!("{name}: {lights} in {files}"));
        Ok(())
    }
}

fn skipped(why: &str) -> String {
    format!("skipped: {why}")
}

/// The spectra of a file.
struct Spectra {
    /// With what follows the file's name where it has several: `#NAME`, or `#NUMBER`.
    spectra: Vec<(String, Entry)>,
    /// Whether some were taken as lights because nothing says what they are.
    is_unsaid: bool,
}

/// Every spectrum of a file; what does not say what it is, is taken as a light.
fn every(path: &Path, opened: Opened, inputs: &mut Inputs) -> Spectra {
    let choices = Choices::default();
    let mut all = named::every(opened, &choices);
    let is_other = |found: &Found| found.is_kind_open && found.entry.kind() != Kind::Light;
    if all.iter().any(is_other) {
        // Their numbers may have been taken for per cent.
        let choices = Choices {
            kind: Some(Kind::Light),
            ..choices
        };
        if let Loaded::File(again) = inputs.load(path, &choices) {
            for (found, light) in all.iter_mut().zip(named::every(*again, &choices)) {
                if is_other(found) {
                    found.entry = light.entry;
                }
            }
        }
    }
    let names: Vec<String> = all.iter().map(|f| f.entry.name().to_owned()).collect();
    let at = |index: usize, name: &String| match names.iter().filter(|n| *n == name).count() {
        _ if names.len() == 1 => String::new(),
        1 => format!("#{name}"),
        _ => format!("#{}", index + 1),
    };
    Spectra {
        is_unsaid: all.iter().any(|found| found.is_kind_open),
        spectra: all
            .into_iter()
            .enumerate()
            .map(|(index, found)| (at(index, &names[index]), found.entry))
            .collect(),
    }
}

/// What a file of a folder holds.
///
/// # Errors
/// Why it holds nothing, in one line.
fn of_folder(label: &str, path: &Path, came: Came) -> Result<Opened, String> {
    match came {
        Came::Loaded(Loaded::File(opened)) => Ok(*opened),
        // Readers know the file's name and not its folder.
        Came::Loaded(Loaded::Refused(why)) => Err(match why.strip_prefix(&name_of(path)) {
            Some(rest) => format!("{label}{rest}"),
            None => why,
        }),
        Came::Loaded(Loaded::Project { .. }) => Err(format!(
            "{label}: a project of this program; name it by itself"
        )),
        Came::NotRead(why) => Err(format!("{label}: {why}")),
    }
}

/// The files of a folder, read by as many threads as the window reads them.
fn files_in(folder: &Path, inputs: &mut Inputs) -> Vec<(String, PathBuf, Came)> {
    let (sender, woken) = channel();
    let mut loader = Loader::default();
    let wake = move || {
        // Nobody listens any more once all is read.
        let _ = sender.send(());
    };
    loader.open(vec![folder.to_owned()], Arc::new(wake));
    loop {
        let is_late = woken.recv_timeout(TOLD_EVERY) == Err(RecvTimeoutError::Timeout);
        if let Some(finished) = loader.finished() {
            let files = finished.files.into_iter();
            let files = files.map(|file| (file.label, file.path.unwrap_or_default(), file.came));
            return files.collect();
        }
        if let Some((done, total)) = loader.progress().and_then(|p| Some((p.done, p.total?)))
            && is_late
        {
            let files = many(total, "file", "files");
            inputs.remark(&format!("{}: {done} of {files} read", shown(folder)));
        }
    }
}
