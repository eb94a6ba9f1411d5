//! Two lights compared, for people.

use std::fmt::Write as _;

use super::{better::Better, compared::Compared};
use crate::{app::quality_report::table_of_two, languages::said};

/// The summary, a sentence for each purpose, the figures of both lights and what is to be known.
pub fn text(compared: &Compared) -> String {
    let [a, b] = &compared.sides;
    let head = tr!("{a} against {b}", a = a.name, b = b.name);
    let mut out = format!("{head}\n\n{}\n\n", compared.summary);
    let title = |better: &Better| said(better.purpose.title);
    let titles = compared.better.iter().map(title);
    let width = titles.map(|title| title.chars().count()).max().unwrap_or(0);
    // Writing to a String cannot fail.
    for better in &compared.better {
        let _ = writeln!(out, "{:width$}  {}", title(better), better.words);
    }
    out.push('\n');
    out += &table_of_two([&a.name, &b.name], [&a.figures, &b.figures]);
    out.push('\n');
    for note in &compared.notes {
        out += &tr!("Note: {note}", note);
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{comparison::side::Side, open};

    #[test]
    fn people_read_every_sentence_and_the_figures_that_a_light_has() {
        let side = |name: &str| {
            let entry = open::resolve(name, None, None).expect("a preset");
            Side::of(entry.name().to_owned(), &entry.spectrum)
        };
        let compared = Compared::of([side("HP1"), side("LED-B5")]);
        let text = text(&compared);
        let sentences = compared.better.iter().map(|better| &better.words);
        for words in sentences.chain([&compared.summary]).chain(&compared.notes) {
            assert!(text.contains(words.as_str()), "{words}");
        }
        let ssi = compared.sides.each_ref().map(|side| {
            let own = side.figures.similarity.as_ref().unwrap().of_cct.as_ref();
            own.unwrap().1
        });
        assert!(ssi.iter().all(|ssi| *ssi < 70.0), "{ssi:?}");
        let cameras = format!(
            "Nothing can be said of cameras: SSI is below 70 in both lights (SSI {:.0} and {:.0}).",
            ssi[0], ssi[1]
        );
        assert!(text.contains(&cameras), "{text}");
        // Neither has an illuminance or TLCI; the LED alone has a width at half height.
        assert!(
            !text.contains("Illuminance") && !text.contains("TLCI"),
            "{text}"
        );
        let width = text
            .lines()
            .find(|line| line.starts_with("Width at half height"));
        assert!(width.is_some_and(|line| line.contains('–') && line.ends_with(" nm")));
    }
}
