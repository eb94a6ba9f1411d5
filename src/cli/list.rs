//! `list`: the shipped spectra by the names that the other commands take.

use std::io::Write;

use serde_json::{Value, json};

use super::{arguments::List, print, refusal::Refusal};
use crate::{app::Entry, app::library::Library, preset::Preset, spectrum::Kind};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] when nothing can be printed.
pub fn run(options: List, out: &mut dyn Write) -> Result<(), Refusal> {
    let rows = rows(options.kind);
    if options.json {
        let rows: Vec<Value> = rows.iter().map(Row::json).collect();
        print(out, &format!("{:#}\n", Value::Array(rows)))
    } else {
        let width = rows.iter().map(|row| row.id.chars().count()).max();
        let lines: Vec<String> = rows
            .iter()
            .map(|row| row.line(width.unwrap_or(0)))
            .collect();
        print(out, &lines.concat())
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
}

/// All items of a kind; without one, those that the other commands take.
fn rows(kind: Option<Kind>) -> Vec<Row> {
    Library::bundled()
        .presets()
        .filter_map(Row::of)
        .filter(|row| match kind {
            Some(kind) => row.kind == kind,
            None => row.kind == Kind::Light || row.kind.is_factor(),
        })
        .collect()
}

impl Row {
    fn of(preset: &Preset) -> Option<Self> {
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
                let samples = Entry::of_preset(preset)?.spectrum.samples;
                (samples.len(), samples.first_nm(), samples.last_nm())
            }
        };
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
        })
    }

    fn line(&self, width: usize) -> String {
        let Self {
            id,
            kind,
            count,
            first_nm,
            last_nm,
            ..
        } = self;
        // A kind's own Display knows no width.
        let kind_word = kind.word();
        let what = if *kind == Kind::Lines {
            "lines"
        } else {
            "points"
        };
        format!("{id:width$}  {kind_word:13}  {count} {what}, {first_nm}-{last_nm} nm\n")
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
        })
    }
}
