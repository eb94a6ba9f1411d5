//! Tables: one description of their columns for the window, CSV, JSON and screen readers.
//!
//! In files numbers read back exactly, and text cannot be taken for anything else.

use serde_json::{Map, Value};

use crate::{
    app::numbers::or_dash,
    io::{Provenance, no_formula, one_line, quoted_where, shortest},
    languages::{self, with_sign},
    spectrum::NamedSpectrum,
};

/// A value as files have it and as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    value: Value,
    shown: String,
    /// What CSV has instead of the value in full.
    filed: Option<String>,
}

/// A cell of a value that is shown as it is; a dash for none.
pub fn cell(value: impl Into<Value>) -> Cell {
    let value = value.into();
    let shown = match &value {
        Value::Null => or_dash(None, |_| String::new()),
        Value::String(text) => text.clone(),
        value => with_sign(filed(value)),
    };
    Cell {
        value,
        shown,
        filed: None,
    }
}

/// A cell of a number with fixed decimals, in CSV too; `otherwise` where there is none.
pub fn rounded(value: impl Into<Option<f64>>, digits: usize, otherwise: &str) -> Cell {
    let value = value.into().filter(|value| value.is_finite());
    let text = value.map_or_else(|| otherwise.to_owned(), |v| format!("{v:.digits$}"));
    Cell {
        filed: Some(text.clone()),
        ..cell(value).shown(with_sign(text))
    }
}

impl Cell {
    /// The same value in other words on screen.
    pub fn shown(self, words: impl Into<String>) -> Self {
        Self {
            shown: words.into(),
            ..self
        }
    }

    fn filed(&self) -> String {
        self.filed.clone().unwrap_or_else(|| filed(&self.value))
    }
}

/// A value in a line of CSV.
fn filed(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => words(text),
        Value::Number(n) if n.is_f64() => number(n.as_f64()),
        value => value.to_string(),
    }
}

/// CSV as it is, or with decimal commas and semicolons, as many spreadsheets read it.
pub fn as_chosen(csv: String) -> String {
    if !languages::has_decimal_commas() {
        return csv;
    }
    let row = |row: &str| match row.starts_with('#') {
        true => row.to_owned(),
        // What stands in quotes is text.
        false => {
            let parts = row.split('"').enumerate();
            let parts = parts.map(|(place, part)| match place % 2 {
                0 => {
                    let cells = part.split(',').map(|cell| match cell.parse::<f64>() {
                        Ok(_) => cell.replace('.', ","),
                        Err(_) => cell.to_owned(),
                    });
                    cells.collect::<Vec<_>>().join(";")
                }
                _ => part.to_owned(),
            });
            parts.collect::<Vec<_>>().join("\"")
        }
    };
    csv.split('\n').map(row).collect::<Vec<_>>().join("\n")
}

/// Name and meaning of a column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Head {
    /// In files, empty where it is shown alone; a point in it nests in JSON and is `_` in CSV.
    pub key: String,
    /// On screen, empty where files alone have the column.
    pub title: String,
    /// For hover, a sentence with its unit.
    pub meaning: String,
    /// Its cells stand at the right on screen.
    pub is_number: bool,
}

impl Head {
    fn filed_key(&self) -> String {
        self.key.replace('.', "_")
    }
}

/// A column of a table of `T`.
pub struct Column<'a, T> {
    head: Head,
    cell: Box<dyn Fn(&T) -> Cell + 'a>,
}

/// A column of files.
pub fn column<'a, T>(key: impl Into<String>, cell: impl Fn(&T) -> Cell + 'a) -> Column<'a, T> {
    Column {
        head: Head {
            key: key.into(),
            ..Head::default()
        },
        cell: Box::new(cell),
    }
}

impl<'a, T> Column<'a, T> {
    /// The same column on screen too, of words: its title and its meaning.
    pub fn titled(mut self, title: impl Into<String>, meaning: impl Into<String>) -> Self {
        self.head.title = title.into();
        self.head.meaning = meaning.into();
        self
    }

    /// The same of numbers.
    pub fn figures(self, title: impl Into<String>, meaning: impl Into<String>) -> Self {
        let mut column = self.titled(title, meaning);
        column.head.is_number = true;
        column
    }
}

/// Columns that are named one after the other.
pub struct Columns<'a, T>(Vec<Column<'a, T>>);

impl<T> Default for Columns<'_, T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<'a, T> Columns<'a, T> {
    /// A further column of files.
    pub fn with(mut self, key: impl Into<String>, cell: impl Fn(&T) -> Cell + 'a) -> Self {
        self.push(key, cell);
        self
    }

    /// A further column.
    pub fn and(mut self, column: Column<'a, T>) -> Self {
        self.0.push(column);
        self
    }

    /// Appends a column of files.
    pub fn push(&mut self, key: impl Into<String>, cell: impl Fn(&T) -> Cell + 'a) {
        self.0.push(column(key, cell));
    }

    /// The last column on screen too, of words: its title and its meaning.
    pub fn titled(mut self, title: impl Into<String>, meaning: impl Into<String>) -> Self {
        let last = self.0.pop().map(|last| last.titled(title, meaning));
        self.0.extend(last);
        self
    }

    /// The same of numbers.
    pub fn figures(mut self, title: impl Into<String>, meaning: impl Into<String>) -> Self {
        let last = self.0.pop().map(|last| last.figures(title, meaning));
        self.0.extend(last);
        self
    }
}

/// A table, ready to be written or shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    comments: String,
    heads: Vec<Head>,
    rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Walks the columns for every row; `comments` are the lines above it in CSV, each with its
    /// `#` and its end.
    pub fn new<T>(
        comments: impl Into<String>,
        columns: Columns<'_, T>,
        rows: impl IntoIterator<Item = T>,
    ) -> Self {
        let Columns(columns) = columns;
        let cells = |row: T| columns.iter().map(|column| (column.cell)(&row)).collect();
        Self {
            comments: comments.into(),
            rows: rows.into_iter().map(cells).collect(),
            heads: columns.into_iter().map(|column| column.head).collect(),
        }
    }

    /// The columns of files as CSV, below the comments; with decimal commas where that was chosen
    /// for what this thread writes.
    pub fn csv(&self) -> String {
        let filed = || self.heads.iter().filter(|head| !head.key.is_empty());
        let mut out = self.comments.clone();
        out += &line(filed().map(|head| words(&head.filed_key())));
        for row in &self.rows {
            let cells = self.heads.iter().zip(row);
            let cells = cells.filter(|(head, _)| !head.key.is_empty());
            out += &line(cells.map(|(_, cell)| cell.filed()));
        }
        as_chosen(out)
    }

    /// The columns of files as JSON, an object a row.
    pub fn json(&self) -> Vec<Value> {
        let object = |row: &Vec<Cell>| {
            let mut object = Value::Object(Map::new());
            for (head, cell) in self.heads.iter().zip(row) {
                if !head.key.is_empty() {
                    put(&mut object, &head.key, cell.value.clone());
                }
            }
            object
        };
        self.rows.iter().map(object).collect()
    }

    /// The columns of files as numbers, by their names in CSV; `None` for what is no number.
    pub fn numbers(&self) -> Vec<(String, Vec<Option<f64>>)> {
        let column = |(place, head): (usize, &Head)| {
            let cells = self.rows.iter().map(|row| row[place].value.as_f64());
            (head.filed_key(), cells.collect())
        };
        let columns = self.heads.iter().enumerate();
        columns
            .filter(|(_, head)| !head.key.is_empty())
            .map(column)
            .collect()
    }

    /// The columns of the screen.
    pub fn heads(&self) -> impl Iterator<Item = &Head> {
        self.heads.iter().filter(|head| !head.title.is_empty())
    }

    /// Words of each row's cells under the columns of the screen.
    pub fn shown(&self) -> impl Iterator<Item = Vec<String>> {
        self.rows.iter().map(|row| {
            let cells = self.heads.iter().zip(row);
            let cells = cells.filter(|(head, _)| !head.title.is_empty());
            cells.map(|(_, cell)| cell.shown.clone()).collect()
        })
    }

    /// Rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// Puts a value under a path of keys.
pub fn put(object: &mut Value, path: &str, value: Value) {
    let place = path.split('.').fold(object, |place, key| &mut place[key]);
    *place = value;
}

/// Comment lines over a table: where a spectrum and what was computed from it come from.
pub(super) fn comments(provenance: &Provenance, spectrum: &NamedSpectrum) -> String {
    provenance.comments(spectrum)
}

/// A number in the fewest digits that read back to it; nothing where there is none, since tables
/// know neither NaN nor infinity.
pub(super) fn number(value: impl Into<Option<f64>>) -> String {
    value
        .into()
        .filter(|v| v.is_finite())
        .map(shortest)
        .unwrap_or_default()
}

/// Text as one cell: in quotes where it holds a sign of the table's own or begins like a comment,
/// and never the beginning of a formula.
pub(super) fn words(text: &str) -> String {
    let text = no_formula(one_line(text));
    // A name such as 2.5 is no number to be given a comma.
    let is_number = languages::has_decimal_commas() && text.parse::<f64>().is_ok();
    let is_special = is_number || text.contains([',', '"', ';']) || text.starts_with('#');
    quoted_where(is_special, &text)
}

/// A line of a table.
pub(super) fn line(cells: impl IntoIterator<Item = impl Into<String>>) -> String {
    let cells: Vec<String> = cells.into_iter().map(Into::into).collect();
    cells.join(",") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_decimal_commas_where_that_was_chosen() {
        let csv = "# a, b. c\nnm,name\n380.5,FL3.1\n-1e-7,\"1.5, or so\"\n".to_owned();
        assert_eq!(as_chosen(csv.clone()), csv);
        assert_eq!(words("2.5"), "2.5");
        languages::write_decimal_commas(true);
        let chosen = as_chosen(csv);
        let name = as_chosen(words("2.5"));
        languages::write_decimal_commas(false);
        assert_eq!(name, "\"2.5\"", "a name is no number");
        let expected = "# a, b. c\nnm;name\n380,5;FL3.1\n-1e-7;\"1.5, or so\"\n";
        assert_eq!(chosen, expected);
    }

    #[test]
    fn a_cell_is_what_was_meant_or_nothing() {
        assert_eq!(number(0.1), "0.1");
        assert_eq!(number(f64::NAN), "");
        assert_eq!(number(None), "");
        assert_eq!(words("FL2"), "FL2");
        assert_eq!(words("a, \"b\"\nc"), "\"a, \"\"b\"\" c\"");
        assert_eq!(words("=1+1"), "'=1+1");
        assert_eq!(words("@a, b"), "\"'@a, b\"");
        assert_eq!(line([number(1.5), words("x")]), "1.5,x\n");
    }

    #[test]
    fn a_table_is_written_and_shown_by_the_same_columns() {
        let columns = Columns::<(&str, f64)>::default()
            .with("name", |row| cell(row.0))
            .titled("light", "Its name.")
            .with("error.mean", |row| {
                cell(row.1).shown(format!("{:.1} %", 100.0 * row.1))
            })
            .figures("off by", "Of all, percent.")
            .with("share", |row| rounded(row.1, 2, "-"))
            .with("is_small", |row| cell(row.1 < 0.2));
        let rows = [("a, b", 1.0 / 3.0), ("=c", f64::NAN)];
        let table = Table::new("# two\n", columns, rows);
        let csv = "# two\nname,error_mean,share,is_small\n\
                   \"a, b\",0.3333333333333333,0.33,false\n'=c,,-,false\n";
        assert_eq!(table.csv(), csv);
        let json = serde_json::json!([
            {"name": "a, b", "error": {"mean": 1.0 / 3.0}, "share": 1.0 / 3.0, "is_small": false},
            {"name": "=c", "error": {"mean": null}, "share": null, "is_small": false},
        ]);
        assert_eq!(Value::Array(table.json()), json);
        let heads = table
            .heads()
            .map(|head| (head.title.as_str(), head.is_number));
        assert_eq!(
            heads.collect::<Vec<_>>(),
            [("light", false), ("off by", true)]
        );
        let shown: Vec<Vec<String>> = table.shown().collect();
        assert_eq!(shown, [["a, b", "33.3 %"], ["=c", "NaN %"]]);
    }
}
