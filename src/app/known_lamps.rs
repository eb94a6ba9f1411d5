//! What the page "Known lamps" says of a light in few words, and whether Automatic takes them.

use super::{
    document::Document,
    numbers::error,
    pages::WordsMemory,
    studies::{About, EncodeAsk, EncodedLight},
};
use crate::{
    lamps::{NUMBERS, words_in_text},
    languages::said,
    study::{
        Measure, Reference, SweepPoint, Verdict,
        error::{height, times},
    },
};

/// One figure with what it means.
#[derive(Clone, Debug, PartialEq)]
pub struct WordsFigure {
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
        let words = words_in_text(&encoded.words);
        Self {
            sentence: tr!(
                "{name} in {numbers} numbers: {makeup}. Colours under it are {off} ΔE₀₀ off, its \
                 spectrum, blurred by 10 nm, {share} %.",
                name,
                numbers,
                makeup = makeup.in_words(),
                off = error(errors.patches),
                share = error(100.0 * errors.blurred)
            ),
            figures: vec![
                WordsFigure {
                    title: said!("colours under it"),
                    value: format!("{} ΔE₀₀", error(errors.patches)),
                    meaning: said!(
                        "Mean of the 99 samples of TM-30, their reflectances approximated too, \
                              in as many numbers as the light may take; about 1 can just be seen."
                    ),
                },
                WordsFigure {
                    title: said!("behind narrow filters"),
                    value: format!("{} ΔE₀₀", error(errors.filters)),
                    meaning: said!(
                        "Mean behind filters 10 nm wide, each brightened to a middle grey."
                    ),
                },
                WordsFigure {
                    title: said!("spectrum, blurred by 10 nm"),
                    value: format!("{} %", error(100.0 * errors.blurred)),
                    meaning: said!(
                        "Root mean square of what is left behind a blur of 10 nm, as a share of \
                         the measured spectrum's: narrower lines count by their power, not by \
                         their shape."
                    ),
                },
                WordsFigure {
                    title: said!("its own colour"),
                    value: own(encoded.own),
                    meaning: if encoded.own < EXACT {
                        said!("X, Y and Z are made exact; what is left is the rounding to 32 bits.")
                    } else {
                        said!(
                            "The best way here is a plain series, which does not make X, Y and Z \
                             exact."
                        )
                    },
                },
            ],
            lines: match &makeup.lines_in_words()[..] {
                [] => String::new(),
                [place] => tr!("Line at {place}.", place),
                lines => tr!("Lines at {places}.", places = lines.join("; ")),
            },
            words: words.join(" "),
            needs: if makeup.parts.is_empty() {
                said!("Decoding needs the formula alone.")
            } else {
                said!("Decoding needs this program's list of lamps.")
            },
        }
    }
}

/// Which light Automatic asks known lamps for, where a person allows their list; `None` where it is
/// not allowed, for what is no light, and for fewer numbers than an encoding takes.
pub fn lamps_asked(document: &Document, words: WordsMemory, numbers: usize) -> Option<EncodeAsk> {
    let can = words.automatic && document.is_about_light() && numbers >= NUMBERS[0];
    can.then(|| EncodeAsk::of(document, numbers, true, words.itself))
}

/// What known lamps are off by, measured as a sweep measures its models.
pub(super) fn lamps_verdict(about: &About, found: &EncodedLight) -> Verdict {
    let subject = about.subject();
    let Some(unit) = height(&subject.values) else {
        return Verdict::default();
    };
    let [light, decoded] = [&subject.values, &found.decoded].map(|values| times(values, unit));
    Reference::of_light(&subject.measures, &light).verdict(&decoded, &[])
}

/// In words, that known lamps are better than the best of a sweep; nothing where they are not.
pub fn lamps_better(
    about: &About,
    found: &EncodedLight,
    (best, measure): (&SweepPoint, Measure),
) -> Option<String> {
    let (theirs, ours) = (
        lamps_verdict(about, found)[measure]?,
        best.verdict[measure]?,
    );
    let figure = measure.figure();
    let words = |off: f64| format!("{}{}", error(off * figure.unit.factor), figure.unit.tail);
    (theirs < ours).then(|| {
        tr!(
            "Known lamps are better with {n} number: {makeup}, {figure} {theirs} against {ours} of \
             the best of all eight ways. Decoding needs this program's list of lamps."
                | "Known lamps are better with {n} numbers: {makeup}, {figure} {theirs} against \
                   {ours} of the best of all eight ways. Decoding needs this program's list of \
                   lamps."
                    % found.encoded.words.len(),
            makeup = found.makeup.in_words(),
            figure = said(figure.title),
            theirs = words(theirs),
            ours = words(ours)
        )
    })
}

/// An own colour that is off by less is exact but for rounding.
const EXACT: f64 = 1e-4;

fn own(delta_e: f64) -> String {
    if delta_e < EXACT {
        said!("exact").to_owned()
    } else {
        format!("{} ΔE₀₀", error(delta_e))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            answers::best_of,
            assert_says, showing,
            studies::{Question, SweepAsk},
        },
        lamps::read_encoding,
        spectrum::Band,
        study::Progress,
    };

    fn shown(key: &str, numbers: usize, known_lamps: bool) -> (WordsShown, EncodedLight) {
        let app = showing(key);
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
        let (read, _) = read_encoding(&shown.words, Some(Band::VISIBLE)).expect("words");
        assert_eq!(read.numbers(), found.encoded.words.len());
        assert_eq!(shown.figures.len(), 4);
        assert_eq!(shown.figures[3].value, "exact");
    }

    #[test]
    fn automatic_is_told_of_known_lamps_where_they_are_allowed_and_better() {
        let app = showing("cie_fluorescent_1nm/FL11");
        let (about, words) = (About::of(app.document()), WordsMemory::default());
        assert_eq!(lamps_asked(app.document(), words, 21), None);
        let words = WordsMemory {
            automatic: true,
            itself: true,
            ..words
        };
        assert_eq!(lamps_asked(app.document(), words, 2), None);
        let ask = lamps_asked(app.document(), words, 21).expect("a light");
        let found = ask.answer(&Progress::default()).expect("not cancelled");
        let found = found.expect("a light");
        // FL11 is FL11: only the rounding to words is left.
        let off = lamps_verdict(&about, &found)[Measure::Patches].expect("seen");
        assert!(off < 1e-4, "{off}");
        let sweep = SweepAsk::of(app.document()).answer(&Progress::default());
        let sweep = sweep.expect("it shines");
        let best = best_of(&sweep, 21, |_| None).expect("affordable");
        let said = lamps_better(&about, &found, best).expect("better");
        assert_says(&said, "FL11");
        assert_says(&said, "list of lamps");
        let mut worse = found;
        worse.decoded.iter_mut().step_by(2).for_each(|v| *v = 0.0);
        assert_eq!(lamps_better(&about, &worse, best), None);
    }

    #[test]
    fn without_known_lamps_the_formula_is_enough() {
        let (shown, found) = shown("cie_fluorescent_1nm/FL2", 3, false);
        assert!(shown.needs.contains("formula") && found.parts.is_empty());
        assert_eq!(shown.words.split(' ').count(), 3);
        assert!(shown.lines.is_empty());
    }
}
