//! What the library lists: shelves with their spectra, files of several, or what a search found.

use std::{collections::HashMap, sync::Arc};

use eframe::egui::Ui;

use crate::{
    app::{
        App, Entry, Families,
        search::{Folded, fold},
        workspace::Preferences,
    },
    preset::Shelf,
    spectrum::Kind,
    ui::kit::{are_same, found},
};

/// The rows, kept until what they are made of changes: thousands are not looked through in every
/// frame.
#[derive(Default)]
pub(super) struct Listed {
    /// The rows and what they were made for.
    rows: Option<(RowsOf, Arc<Vec<Row>>)>,
}

/// What the rows are made of.
struct RowsOf {
    search: String,
    folded: Vec<String>,
    own: Vec<Arc<Entry>>,
    bundled: usize,
}

impl RowsOf {
    fn is_still(&self, search: &str, folded: &[String], app: &App) -> bool {
        self.search == search
            && self.folded == folded
            && self.bundled == app.bundled().len()
            && are_same(&self.own, &app.document().own)
    }
}

/// One line of the list.
pub(super) enum Row {
    Heading {
        title: String,
        count: usize,
        folded: bool,
    },
    /// A file of the user's own with several spectra.
    File {
        name: String,
        count: usize,
        folded: bool,
    },
    Item {
        entry: Arc<Entry>,
        /// Letters at the beginning and the end that all names of its file have in common;
        /// `None` where it stands alone.
        in_file: Option<[usize; 2]>,
    },
}

/// What a file is called among the folds that are remembered: none of the shelves is called so.
pub(super) fn fold_of(file: &str) -> String {
    format!("file: {file}")
}

const OWN: &str = later!("My files");

impl Listed {
    /// The rows, made anew when search, folds or spectra changed.
    pub(super) fn rows(
        &mut self,
        ui: &Ui,
        search: &str,
        app: &App,
        preferences: &Preferences,
    ) -> Arc<Vec<Row>> {
        if let Some((of, rows)) = &self.rows
            && of.is_still(search, &preferences.folded, app)
        {
            return rows.clone();
        }
        let of = RowsOf {
            search: search.to_owned(),
            folded: preferences.folded.clone(),
            own: app.document().own.clone(),
            bundled: app.bundled().len(),
        };
        let rows = Arc::new(if search.trim().is_empty() {
            on_shelves(app, preferences)
        } else {
            found(ui.ctx(), app, search)
                .into_iter()
                .map(alone)
                .collect()
        });
        self.rows = Some((of, rows.clone()));
        rows
    }
}

/// A spectrum that stands for itself, not for one of a file.
fn alone(entry: Arc<Entry>) -> Row {
    Row::Item {
        entry,
        in_file: None,
    }
}

/// The spectra on their shelves, the user's own first.
fn on_shelves(app: &App, preferences: &Preferences) -> Vec<Row> {
    let mut rows = Vec::new();
    let is_folded = |title: &str| preferences.folded.iter().any(|f| f == title);
    let heading = |rows: &mut Vec<Row>, title: &str, count: usize| {
        let folded = is_folded(title);
        if count > 0 {
            rows.push(Row::Heading {
                title: title.to_owned(),
                count,
                folded,
            });
        }
        count > 0 && !folded
    };
    let own = &app.document().own;
    if heading(&mut rows, OWN, own.len()) {
        by_file(own.clone(), |file| is_folded(&fold_of(file)), &mut rows);
    }
    let item = |row: Folded| alone(row.entry);
    let is_light = |entry: &&Arc<Entry>| entry.kind() == Kind::Light;
    let lights = fold(app.bundled().iter().filter(is_light));
    let families = Families::shipped();
    let mut headings: Vec<&str> = Vec::new();
    for family in families.all() {
        if !headings.contains(&family.heading.as_str()) {
            headings.push(&family.heading);
        }
    }
    for title in headings {
        let is_its = |row: &&Folded| {
            let family = families.family_of(&row.entry.key);
            family.is_some_and(|family| family.heading == title)
        };
        let under: Vec<Folded> = lights.iter().filter(is_its).cloned().collect();
        if heading(&mut rows, title, under.len()) {
            rows.extend(under.into_iter().map(item));
        }
    }
    for place in Shelf::ALL {
        let others = app.bundled().iter().filter(|entry| !is_light(entry));
        let under = fold(others.filter(|e| e.shelf() == Some(place)));
        if heading(&mut rows, place.heading(), under.len()) {
            rows.extend(under.into_iter().map(item));
        }
    }
    rows
}

/// Spectra of the user's own with a heading over those of a file that brought several.
fn by_file(entries: Vec<Arc<Entry>>, is_folded: impl Fn(&str) -> bool, rows: &mut Vec<Row>) {
    let mut places: HashMap<String, usize> = HashMap::new();
    let mut files: Vec<Vec<Arc<Entry>>> = Vec::new();
    for entry in entries {
        let file = entry.spectrum.source.clone();
        match places.get(&file) {
            Some(place) if !file.is_empty() => files[*place].push(entry),
            _ => {
                places.insert(file, files.len());
                files.push(vec![entry]);
            }
        }
    }
    for file in files {
        if file.len() == 1 {
            rows.extend(file.into_iter().map(alone));
            continue;
        }
        let name = file[0].spectrum.source.clone();
        let folded = is_folded(&name);
        rows.push(Row::File {
            count: file.len(),
            folded,
            name,
        });
        if folded {
            continue;
        }
        let in_file = Some(common(&file));
        rows.extend(file.into_iter().map(|entry| Row::Item { entry, in_file }));
    }
}

/// How many letters all names have in common at their beginning and, behind those, at their end.
fn common(entries: &[Arc<Entry>]) -> [usize; 2] {
    let mut names = entries.iter().map(|e| e.name().chars().collect::<Vec<_>>());
    let Some(first) = names.next() else {
        return [0; 2];
    };
    let same = |a: &mut dyn Iterator<Item = (char, char)>| a.take_while(|(a, b)| a == b).count();
    let (mut head, mut tail, mut least) = (first.len(), first.len(), first.len());
    for name in names {
        let forth = &mut first.iter().copied().zip(name.iter().copied());
        head = head.min(same(forth));
        let back = &mut first.iter().rev().copied().zip(name.iter().rev().copied());
        tail = tail.min(same(back));
        least = least.min(name.len());
    }
    let head = head.min(least);
    let tail = tail.min(least - head);
    // Whole words: "…column 1" tells more than "…1".
    let is_gap = |c: &char| !c.is_alphanumeric();
    let begun = first[..head].iter().rposition(|c| !is_gap(c)).unwrap_or(0);
    let head = first[..begun]
        .iter()
        .rposition(is_gap)
        .map_or(0, |at| at + 1);
    let behind = &first[first.len() - tail..];
    let tail = behind.iter().position(is_gap).map_or(0, |at| tail - at);
    [head, tail]
}
