//! What came of opening many files: a headline, and a row for each of them.

use std::path::PathBuf;

use super::{
    Loaded,
    came::{Came, FileRead},
};
use crate::{
    app::{
        cells::{Columns, Table, cell, column},
        opened::Opened,
    },
    io::{Guessed, OpenQuestion, shown},
};

/// Formats that the headline tells by name.
const MOST_FORMATS: usize = 4;

/// What came of one file.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    Read {
        /// The format that read it.
        format: &'static str,
        /// How many spectra it holds.
        spectra: usize,
        /// How many images.
        images: usize,
        /// How it was read, in a line.
        how: String,
        /// What a person should look at, a phrase each; empty when nothing is doubtful.
        doubts: Vec<String>,
    },
    /// A project of this program was opened.
    Project,
    /// It was refused, in one line.
    Refused(String),
    /// It was not looked at, and why.
    NotRead(String),
}

#[derive(Clone, Debug, PartialEq)]
pub struct FileRow {
    /// Its path below what was opened, or its name.
    pub file: String,
    /// Where it is; `None` when it came without a path.
    pub path: Option<PathBuf>,
    /// What came of it.
    pub outcome: Outcome,
    pub before: OpenBefore,
}

/// Whether a file of a batch was open before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OpenBefore {
    #[default]
    No,
    /// It was, with the same values: it is not opened twice.
    Same,
    /// It was, with other values: it stands beside them.
    OtherValues,
}

impl OpenBefore {
    /// In words, to stand before how a file was read.
    pub fn words(self) -> &'static str {
        match self {
            Self::No => "",
            Self::Same => said!("open already"),
            Self::OtherValues => said!("open already with other values, opened beside them"),
        }
    }
}

/// What came of all of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// A row a file, in the order in which they were opened.
    pub rows: Vec<FileRow>,
    /// Whether a person stopped it before its end.
    pub cancelled: bool,
}

impl FileRow {
    /// The row of a file.
    pub(super) fn of(file: &FileRead) -> Self {
        let outcome = match &file.came {
            Came::Loaded(Loaded::File(opened)) => read(opened),
            Came::Loaded(Loaded::Project { .. }) => Outcome::Project,
            Came::Loaded(Loaded::Refused(why)) => Outcome::Refused(why.clone()),
            Came::NotRead(why) => Outcome::NotRead(why.clone()),
        };
        Self {
            file: file.label.clone(),
            path: file.path.clone(),
            outcome,
            before: OpenBefore::No,
        }
    }

    pub fn is_read(&self) -> bool {
        matches!(self.outcome, Outcome::Read { .. } | Outcome::Project)
    }

    pub fn is_project(&self) -> bool {
        self.outcome == Outcome::Project
    }

    pub fn is_refused(&self) -> bool {
        matches!(self.outcome, Outcome::Refused(_))
    }

    /// Whether a guess about it should be looked at.
    pub fn is_doubtful(&self) -> bool {
        matches!(&self.outcome, Outcome::Read { doubts, .. } if !doubts.is_empty())
    }

    /// The format, or a dash.
    pub fn format(&self) -> &'static str {
        match &self.outcome {
            Outcome::Read { format, .. } => format,
            Outcome::Project => said!("project"),
            Outcome::Refused(_) | Outcome::NotRead(_) => "–",
        }
    }

    /// Spectra and images that it brought.
    fn counts(&self) -> [usize; 2] {
        match self.outcome {
            Outcome::Read {
                spectra, images, ..
            } => [spectra, images],
            Outcome::Project | Outcome::Refused(_) | Outcome::NotRead(_) => [0; 2],
        }
    }

    /// What it brought: "3", "1 image", or a dash.
    pub fn brought(&self) -> String {
        match self.counts() {
            _ if !matches!(self.outcome, Outcome::Read { .. }) => "–".to_owned(),
            [spectra, 0] => spectra.to_string(),
            [0, images] => images_of(images),
            [spectra, images] => format!("{spectra}, {}", images_of(images)),
        }
    }

    /// How it was read, or why not, in a line; a doubtful guess comes first.
    pub fn story(&self) -> String {
        let story = match &self.outcome {
            Outcome::Read { how, doubts, .. } if doubts.is_empty() => how.clone(),
            Outcome::Read { how, doubts, .. } => {
                tr!("doubtful: {doubts}; {how}", doubts = doubts.join("; "), how)
            }
            Outcome::Project => said!("a project, opened").to_owned(),
            Outcome::Refused(why) => tr!("refused: {why}", why = self.without_its_name(why)),
            Outcome::NotRead(why) => tr!("not read: {why}", why = self.without_its_name(why)),
        };
        match self.before.words() {
            "" => story,
            words => format!("{words}; {story}"),
        }
    }

    /// Why it was not read, with its path: two files may be called alike.
    pub fn trouble(&self) -> Option<String> {
        let name = self.path.as_deref().map_or(self.file.clone(), shown);
        match &self.outcome {
            Outcome::Refused(why) => {
                let rest = self.without_its_name(why);
                let at_line = why[..why.len() - rest.len()].ends_with(", ");
                Some(format!("{name}{}{rest}", if at_line { ", " } else { ": " }))
            }
            Outcome::NotRead(why) => Some(tr!("{name}: not read, {why}", name, why)),
            Outcome::Read { .. } | Outcome::Project => None,
        }
    }

    /// A refusal without the file's name in front: it stands in the row already.
    fn without_its_name<'a>(&self, why: &'a str) -> &'a str {
        let names = [self.file.rsplit('/').next(), Some(self.file.as_str())];
        let mut short = names.into_iter().flatten().filter_map(|name| {
            let rest = why.strip_prefix(name)?;
            rest.strip_prefix(": ").or(rest.strip_prefix(", "))
        });
        short.next().unwrap_or(why)
    }
}

fn images_of(count: usize) -> String {
    tr!("{n} image" | "{n} images" % count)
}

fn read(opened: &Opened) -> Outcome {
    let in_front = format!("{}: {}", opened.file, opened.format);
    let how = opened.how.strip_prefix(&in_front).unwrap_or(&opened.how);
    Outcome::Read {
        format: opened.format,
        spectra: opened.spectra.len(),
        images: opened.images.len(),
        how: how.trim_start_matches([',', ' ']).to_owned(),
        doubts: doubts(&opened.guesses),
    }
}

/// Doubtful guesses in words, each once however many spectra share it.
fn doubts(guesses: &[OpenQuestion]) -> Vec<String> {
    // Guesses for one reason in one phrase, whatever numbers of each spectrum stand behind it.
    let mut all: Vec<(Guessed, Vec<String>, &str, &str)> = Vec::new();
    for guess in guesses.iter().filter(|guess| guess.is_doubtful()) {
        let what = guess.what;
        let (chosen, because) = (guess.chosen.to_string(), guess.because.as_str());
        let reason = because.split(" (").next().unwrap_or(because);
        let known = all
            .iter_mut()
            .find(|known| (known.0, known.2) == (what, reason));
        match known {
            Some((_, known, _, told)) => {
                if *told != because {
                    *told = reason;
                }
                if !known.contains(&chosen) {
                    known.push(chosen);
                }
            }
            None => all.push((what, vec![chosen], reason, because)),
        }
    }
    let phrase = |(what, chosen, _, because): (Guessed, Vec<String>, &str, &str)| {
        let chosen = chosen.into_iter();
        let chosen = chosen.reduce(|one, other| tr!("{one} and {other}", one, other));
        let chosen = chosen.unwrap_or_default();
        match what {
            Guessed::Kind => tr!("taken for {chosen} ({because})", chosen, because),
            Guessed::WavelengthUnit => {
                tr!("wavelengths taken as {chosen} ({because})", chosen, because)
            }
            Guessed::Percent => tr!("values taken as {chosen} ({because})", chosen, because),
            Guessed::Columns => tr!("taken as {chosen} ({because})", chosen, because),
        }
    };
    all.into_iter().map(phrase).collect()
}

impl Summary {
    /// Files of a sort.
    pub fn count(&self, is: impl Fn(&FileRow) -> bool) -> usize {
        self.rows.iter().filter(|row| is(row)).count()
    }

    /// Spectra that were read.
    pub fn spectra(&self) -> usize {
        self.rows.iter().map(|row| row.counts()[0]).sum()
    }

    fn images(&self) -> usize {
        self.rows.iter().map(|row| row.counts()[1]).sum()
    }

    /// All in one line: "98 of 100 files read, 240 spectra: 95 plain columns, 3 TM-27 .spdx; 2
    /// refused".
    pub fn headline(&self) -> String {
        let read = self.count(FileRow::is_read);
        let files = self.rows.len();
        let mut line = match self.cancelled {
            true => tr!(
                "Cancelled: {read} of {n} file read"
                    | "Cancelled: {read} of {n} files read" % files,
                read
            ),
            false => tr!(
                "{read} of {n} file read" | "{read} of {n} files read" % files,
                read
            ),
        };
        if read > 0 {
            line += ", ";
            line += &tr!("{n} spectrum" | "{n} spectra" % self.spectra());
        }
        match self.images() {
            0 => {}
            images => line = tr!("{line} and {images}", line, images = images_of(images)),
        }
        if read > 0 {
            line += &format!(": {}", self.formats());
        }
        let same = self.count(|row| row.before == OpenBefore::Same);
        let others = self.count(|row| row.before == OpenBefore::OtherValues);
        let doubtful = self.count(FileRow::is_doubtful);
        let refused = self.count(FileRow::is_refused);
        let not_read = self.count(|row| matches!(row.outcome, Outcome::NotRead(_)));
        for (count, words) in [
            (same, tr!("{n} open already" | "{n} open already" % same)),
            (
                others,
                tr!("{n} open already with other values"
                    | "{n} open already with other values" % others),
            ),
            (
                doubtful,
                tr!("{n} with a doubtful guess" | "{n} with a doubtful guess" % doubtful),
            ),
            (refused, tr!("{n} refused" | "{n} refused" % refused)),
            (not_read, tr!("{n} not read" | "{n} not read" % not_read)),
        ] {
            if count > 0 {
                line += "; ";
                line += &words;
            }
        }
        line
    }

    fn formats(&self) -> String {
        let mut counts: Vec<(&str, usize)> = Vec::new();
        for row in self.rows.iter().filter(|row| row.is_read()) {
            let format = row.format();
            match counts.iter_mut().find(|(known, _)| *known == format) {
                Some((_, count)) => *count += 1,
                None => counts.push((format, 1)),
            }
        }
        counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let rest: usize = counts.iter().skip(MOST_FORMATS).map(|(_, n)| n).sum();
        let mut told: Vec<String> = counts
            .iter()
            .take(MOST_FORMATS)
            .map(|(format, count)| format!("{count} {format}"))
            .collect();
        if rest > 0 {
            told.push(tr!("{count} of other formats", count = rest));
        }
        told.join(", ")
    }

    /// The files as a table.
    pub fn table(&self) -> Table {
        let comments = format!(
            "# {}\n# written by: Spectral Explorer {}\n",
            self.headline(),
            env!("CARGO_PKG_VERSION")
        );
        let count = |key: &'static str, at: usize| {
            column(key, move |row: &&FileRow| {
                cell((!row.is_project()).then(|| row.counts()[at]))
            })
        };
        let columns = Columns::<&FileRow>::default()
            .with("file", |row| cell(row.file.as_str()))
            .with("outcome", |row| {
                cell(match &row.outcome {
                    Outcome::Read { .. } => "read",
                    Outcome::Project => "project",
                    Outcome::Refused(_) => "refused",
                    Outcome::NotRead(_) => "not read",
                })
            })
            .with("format", |row| {
                cell(if row.is_read() { row.format() } else { "" })
            })
            .and(count("spectra", 0))
            .and(count("images", 1))
            .with("how", |row| {
                cell(match &row.outcome {
                    Outcome::Read { how, .. } => how.as_str(),
                    Outcome::Project => "",
                    Outcome::Refused(why) | Outcome::NotRead(why) => why.as_str(),
                })
            })
            .with("doubtful", |row| match &row.outcome {
                Outcome::Read { doubts, .. } => cell(doubts.join("; ")),
                _ => cell(""),
            })
            .with("path", |row| {
                cell(row.path.as_ref().map(|path| path.display().to_string()))
            });
        Table::new(comments, columns, &self.rows)
    }
}
