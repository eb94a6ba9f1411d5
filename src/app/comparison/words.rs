//! Two lights compared, for people.

use std::fmt::Write as _;

use super::compared::Compared;
use crate::app::quality_report::table_of_two;

/// The summary, a sentence for each purpose, the figures of both lights and what is to be known.
pub fn text(compared: &Compared) -> String {
    let [a, b] = &compared.sides;
    let mut out = format!("{} against {}\n\n{}\n\n", a.name, b.name, compared.summary);
    let titles = compared.better.iter().map(|better| better.purpose.title);
    let width = titles.map(|title| title.chars().count()).max().unwrap_or(0);
    // Writing to a String cannot fail.
    for better in &compared.better {
        let _ = writeln!(out, "{:width$}  {}", better.purpose.title, better.words);
    }
    out.push('\n');
    out += &table_of_two([&a.name, &b.name], [&a.figures, &b.figures]);
    out.push('\n');
    for note in &compared.notes {
        let _ = writeln!(out, "Note: {note}");
    }
    out
}
