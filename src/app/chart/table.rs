//! The numbers of a chart as a table.

use std::{collections::BTreeSet, fmt::Write as _};

use super::{Chart, Marks, Series};
use crate::{
    app::cells::{number, words},
    io::one_line,
};

/// A column of numbers over places of its own.
struct Column {
    name: String,
    points: Vec<[f64; 2]>,
}

impl Chart {
    /// The numbers of all series as CSV, after comment lines that say where they come from.
    ///
    /// Series that share their places, or the names of their places, are columns of one table.
    /// Others stand below one another as `series, x, y`, with the name of the place in a column of
    /// its own where places have names. A heat map has one line a box, at the box's middle. A cell
    /// is empty where there is no number.
    pub fn to_csv(&self) -> String {
        let mut out = String::new();
        let mut comment = |key: &str, text: &str| {
            let text = one_line(text);
            if !text.is_empty() {
                // Writing to a String cannot fail.
                let _ = writeln!(out, "# {key}{text}");
            }
        };
        comment("title: ", &self.title);
        comment("y: ", &self.y_label);
        if let Some(panel) = &self.residual {
            comment("below: ", &panel.y_label);
        }
        for note in &self.notes {
            comment("", note);
        }
        let columns = self.columns();
        let has_cells = self.all_series().any(|s| s.marks.cells().is_some());
        if has_cells {
            self.cells_table(&mut out, &columns);
        } else if let Some(places) = self.shared_places(&columns) {
            self.wide_table(&mut out, &columns, &places);
        } else {
            self.long_table(&mut out, &columns);
        }
        out
    }

    fn columns(&self) -> Vec<Column> {
        let mut columns = Vec::new();
        for (i, series) in self.all_series().enumerate() {
            if series.marks.is_no_series() {
                continue;
            }
            let name = name_of(series, i);
            let points = series.marks.points().to_vec();
            if let Marks::Stems { base, .. } | Marks::Area { base, .. } = &series.marks
                && !base.is_empty()
            {
                columns.push(Column {
                    name: format!("{name} (base)"),
                    points: points.iter().zip(base).map(|(p, b)| [p[0], *b]).collect(),
                });
            }
            columns.push(Column { name, points });
        }
        columns
    }

    fn x_title(&self) -> String {
        words(title_or(&self.x_label, "x"))
    }

    /// The cells that a place takes at the beginning of a line: its number and perhaps its name.
    fn place(&self, x: f64) -> String {
        match self.x_names.is_empty() {
            true => number(x),
            false => format!("{},{}", number(x), words(self.name_at(x).unwrap_or(""))),
        }
    }

    fn place_title(&self) -> String {
        match self.x_names.is_empty() {
            true => self.x_title(),
            false => format!("{},name", self.x_title()),
        }
    }

    /// What begins the lines of a table that all columns fit: their places where they share them,
    /// or the names of their places, which bars side by side share.
    fn shared_places(&self, columns: &[Column]) -> Option<Vec<String>> {
        let of = |place: &dyn Fn(f64) -> String| {
            let places = |column: &Column| -> Vec<String> {
                column.points.iter().map(|point| place(point[0])).collect()
            };
            let first = columns.first().map(places).unwrap_or_default();
            let shared = columns.iter().all(|column| places(column) == first);
            shared.then_some(first)
        };
        if self.x_names.is_empty() {
            return of(&number);
        }
        let names = of(&|x| words(self.name_at(x).unwrap_or_default()))?;
        let different: BTreeSet<&String> = names.iter().collect();
        (different.len() == names.len()).then_some(names)
    }

    fn wide_table(&self, out: &mut String, columns: &[Column], places: &[String]) {
        out.push_str(&self.x_title());
        for column in columns {
            let _ = write!(out, ",{}", words(&column.name));
        }
        out.push('\n');
        for (i, place) in places.iter().enumerate() {
            out.push_str(place);
            for column in columns {
                let _ = write!(out, ",{}", number(column.points[i][1]));
            }
            out.push('\n');
        }
    }

    fn long_table(&self, out: &mut String, columns: &[Column]) {
        let y = words(title_or(&self.y_label, "y"));
        let _ = writeln!(out, "series,{},{y}", self.place_title());
        for column in columns {
            let name = words(&column.name);
            for &[x, y] in &column.points {
                let _ = writeln!(out, "{name},{},{}", self.place(x), number(y));
            }
        }
    }

    fn cells_table(&self, out: &mut String, columns: &[Column]) {
        let all = || self.all_series().enumerate();
        let maps = all().filter_map(|(i, s)| Some((name_of(s, i), s.marks.cells()?)));
        let maps: Vec<_> = maps.collect();
        let alone = maps.len() == 1 && columns.is_empty();
        let y = words(title_or(&self.y_label, "y"));
        let value = match &maps[..] {
            [(_, cells)] => words(title_or(&cells.label, "value")),
            _ => "value".to_owned(),
        };
        if !alone {
            out.push_str("series,");
        }
        let _ = writeln!(out, "{},{y},{value}", self.place_title());
        let mut line = |name: &str, [x, y]: [f64; 2], value: Option<f64>| {
            if !alone {
                let _ = write!(out, "{},", words(name));
            }
            let value = value.map(number).unwrap_or_default();
            let _ = writeln!(out, "{},{},{value}", self.place(x), number(y));
        };
        for (name, cells) in &maps {
            for (i, value) in cells.values.iter().enumerate() {
                if let Some(middle) = cells.middle(i) {
                    line(name, middle, *value);
                }
            }
        }
        for column in columns {
            for point in &column.points {
                line(&column.name, *point, None);
            }
        }
    }
}

fn name_of(series: &Series, index: usize) -> String {
    match series.name.is_empty() {
        true => format!("series {}", index + 1),
        false => series.name.clone(),
    }
}

fn title_or<'a>(title: &'a str, otherwise: &'a str) -> &'a str {
    if title.trim().is_empty() {
        otherwise
    } else {
        title
    }
}
