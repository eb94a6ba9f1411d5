//! `list`: the shipped spectra by the names that the other commands take.

use std::io::Write;

use serde_json::{Value, json};

use super::{arguments::List, inputs::Inputs, print, print_json, refusal::Refusal};
use crate::{
    app::{
        Entry, Families, Library,
        about::About,
        bundled_entries, is_made,
        search::{Folded, Index},
    },
    io::quoted,
    preset::Preset,
    spectrum::Kind,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] when nothing can be printed.
pub(super) fn run(options: List, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let rows = match &options.search {
        Some(words) => found(words, options.kind),
        None => rows(options.kind),
    };
    if rows.is_empty() {
        inputs.note(nothing_words(&options));
    }
    if options.json {
        let rows: Vec<Value> = rows.iter().map(Row::json).collect();
        print_json(out, &Value::Array(rows))
    } else {
        let width = rows.iter().map(|row| row.id.chars().count()).max();
        let lines: Vec<String> = rows
            .iter()
            .map(|row| row.line(width.unwrap_or(0)))
            .collect();
        print(out, &lines.concat())
    }
}

/// What is said of an empty list.
fn nothing_words(options: &List) -> String {
    let kind = match options.kind {
        Some(kind) => format!("no {kind} spectrum"),
        None => "no spectrum".to_owned(),
    };
    match &options.search {
        Some(words) => format!("{kind} in the library is called {}", quoted(words)),
        None => format!("{kind} is in the library"),
    }
}

/// One item of the list.
struct Row {
    id: String,
    group: String,
    name: String,
    kind: Kind,
    unit: String,
    count: usize,
    first_nm: f64,
    last_nm: f64,
    source: String,
    licence: String,
    /// Its family's key and title.
    family: Option<[String; 2]>,
    /// What it is in a few words; may be empty.
    what: String,
    /// A sentence that says all of it.
    about: String,
    made: bool,
    /// Tables of the same light that a search folds into it.
    twins: Vec<String>,
}

/// All items of a kind; without one, those that the other commands take.
fn rows(kind: Option<Kind>) -> Vec<Row> {
    let all = Library::bundled().everything().filter_map(Row::of);
    all.filter(|row| is_wanted(row.kind, kind)).collect()
}

/// What a search finds, the best first.
fn found(words: &str, kind: Option<Kind>) -> Vec<Row> {
    let entries = bundled_entries();
    let wanted = entries.iter().filter(|entry| is_wanted(entry.kind(), kind));
    let found = Index::of(wanted).search(words).into_iter();
    found
        .filter_map(|Folded { entry, twins }| {
            let row = Row::of(Library::bundled().find(&entry.key).ok()?)?;
            let twins = twins.iter().map(|twin| twin.key.clone()).collect();
            Some(Row { twins, ..row })
        })
        .collect()
}

fn is_wanted(found: Kind, kind: Option<Kind>) -> bool {
    kind.map_or(found == Kind::Light || found.is_factor(), |kind| {
        found == kind
    })
}

impl Row {
    fn of(preset: &Preset) -> Option<Self> {
        let mut about = About::default();
        let (count, first_nm, last_nm) = match preset.line_list() {
            Some(list) => {
                let places = || list.lines.iter().map(|line| line.at_nm);
                (
                    list.lines.len(),
                    places().reduce(f64::min)?,
                    places().reduce(f64::max)?,
                )
            }
            None => {
                let entry = Entry::of_preset(preset)?;
                about = About::of(&entry);
                let samples = entry.spectrum.samples;
                (samples.len(), samples.first_nm(), samples.last_nm())
            }
        };
        let family = Families::shipped().family_of(&preset.id());
        Some(Self {
            id: preset.id(),
            group: preset.group.clone(),
            name: preset.name.clone(),
            kind: preset.kind,
            unit: preset.unit.clone(),
            count,
            first_nm,
            last_nm,
            source: preset.source.clone(),
            licence: preset.licence.to_string(),
            family: family.map(|family| [family.key.clone(), family.title.clone()]),
            about: if about.name.is_empty() {
                String::new()
            } else {
                about.sentence()
            },
            what: about.what,
            made: is_made(&preset.id()),
            twins: Vec::new(),
        })
    }

    fn line(&self, width: usize) -> String {
        let Self {
            id,
            kind,
            count,
            first_nm,
            last_nm,
            what,
            ..
        } = self;
        // A kind's own Display knows no width.
        let kind_word = kind.word();
        let points = if *kind == Kind::Lines {
            "lines"
        } else {
            "points"
        };
        let words = if what.is_empty() {
            String::new()
        } else {
            format!("  {what}")
        };
        format!("{id:width$}  {kind_word:13}  {count} {points}, {first_nm}-{last_nm} nm{words}\n")
    }

    fn json(&self) -> Value {
        json!({
            "id": self.id,
            "group": self.group,
            "name": self.name,
            "kind": self.kind.word(),
            "unit": self.unit,
            "points": self.count,
            "first_nm": self.first_nm,
            "last_nm": self.last_nm,
            "source": self.source,
            "licence": self.licence,
            "family": self.family.as_ref().map(|[key, _]| key),
            "family_title": self.family.as_ref().map(|[_, title]| title),
            "what": self.what,
            "about": self.about,
            "made": self.made,
            "twins": self.twins,
        })
    }
}
