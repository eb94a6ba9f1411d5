//! What the page "Known lamps" says of a light in few words.

use super::studies::EncodedLight;

/// One figure with what it means.
#[derive(Clone, Debug, PartialEq)]
pub struct WordsFigure {
    /// What it is.
    pub title: &'static str,
    /// How much it is, with its unit.
    pub value: String,
    /// What that means, a sentence.
    pub meaning: &'static str,
}

/// What is said beside the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct WordsShown {
    /// The result in a sentence.
    pub sentence: String,
    /// What the words are off by.
    pub figures: Vec<WordsFigure>,
    /// Where the lines are, how wide, and their shares of the power; empty without lines.
    pub lines: String,
    /// The words in hexadecimal digits, to be copied.
    pub words: String,
    /// What is needed to read the words.
    pub needs: &'static str,
}

impl WordsShown {
    /// Of a light of this name.
    pub fn of(name: &str, found: &EncodedLight) -> Self {
        let EncodedLight {
            encoded, makeup, ..
        } = found;
        let (errors, numbers) = (encoded.errors, encoded.words.len());
        let words: Vec<String> = encoded.words.iter().map(|w| format!("{w:08x}")).collect();
        Self {
            sentence: format!(
                "{name} in {numbers} numbers: {}. Colours under it are {} ΔE00 off, its spectrum \
                 {} %.",
                makeup.in_words(),
                short(errors.patches),
                short(100.0 * errors.blurred)
            ),
            figures: vec![
                WordsFigure {
                    title: "colours under it",
                    value: format!("{} ΔE00", short(errors.patches)),
                    meaning: "Mean of the 99 samples of TM-30, their reflectances in as many \
                              numbers; 1 is seen side by side.",
                },
                WordsFigure {
                    title: "behind narrow filters",
                    value: format!("{} ΔE00", short(errors.filters)),
                    meaning: "Mean behind filters 10 nm wide, each brightened to a middle grey.",
                },
                WordsFigure {
                    title: "the spectrum itself",
                    value: format!("{} %", short(100.0 * errors.blurred)),
                    meaning: "Root mean square behind a blur of 10 nm, of the measured one's.",
                },
                WordsFigure {
                    title: "its own colour",
                    value: own(encoded.own),
                    meaning: if encoded.own < EXACT {
                        "X, Y and Z are made exact; what is left is the rounding to 32 bits."
                    } else {
                        "The best way here is a plain series, which does not make X, Y and Z exact."
                    },
                },
            ],
            lines: match &makeup.lines_in_words()[..] {
                [] => String::new(),
                [one] => format!("Line at {one}."),
                lines => format!("Lines at {}.", lines.join("; ")),
            },
            words: words.join(" "),
            needs: if makeup.parts.is_empty() {
                "Whoever has the formula can decode these words."
            } else {
                "Whoever decodes these words needs the program's list of lamps."
            },
        }
    }
}

/// Two or three digits.
fn short(value: f64) -> String {
    match value {
        v if v < 0.000_1 => "< 0.0001".to_owned(),
        v if v < 0.01 => format!("{v:.4}"),
        v if v < 1.0 => format!("{v:.3}"),
        v => format!("{v:.2}"),
    }
}

/// An own colour that is off by less is exact but for rounding.
const EXACT: f64 = 1e-4;

fn own(delta_e: f64) -> String {
    if delta_e < EXACT {
        "exact".to_owned()
    } else {
        format!("{} ΔE00", short(delta_e))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{App, Command, studies::EncodeAsk},
        lamps::read_encoding,
        spectrum::Band,
        study::Progress,
    };

    fn shown(key: &str, numbers: usize, known_lamps: bool) -> (WordsShown, EncodedLight) {
        let mut app = App::new();
        app.apply(Command::Show(app.entry(key).expect("shipped")));
        let found = EncodeAsk::of(app.document(), numbers, known_lamps, false)
            .answer(&Progress::default())
            .expect("not cancelled")
            .expect("a light");
        (WordsShown::of(app.document().light.name(), &found), found)
    }

    #[test]
    fn the_sentence_tells_the_makeup_and_the_words_can_be_read_back() {
        let (shown, found) = shown("cie_fluorescent_1nm/FL2", 20, true);
        assert!(shown.sentence.starts_with("FL2 in "), "{}", shown.sentence);
        assert!(shown.sentence.contains(&found.makeup.in_words()));
        assert!(shown.needs.contains("list of lamps"));
        let (read, _) = read_encoding(&shown.words, Band::VISIBLE).expect("words");
        assert_eq!(read.numbers(), found.encoded.words.len());
        assert_eq!(shown.figures.len(), 4);
        assert_eq!(shown.figures[3].value, "exact");
    }

    #[test]
    fn without_known_lamps_the_formula_is_enough() {
        let (shown, found) = shown("cie_fluorescent_1nm/FL2", 3, false);
        assert!(shown.needs.contains("formula") && found.parts.is_empty());
        assert_eq!(shown.words.split(' ').count(), 3);
        assert!(shown.lines.is_empty());
    }
}
