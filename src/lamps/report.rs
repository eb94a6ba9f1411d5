//! Encodings as JSON; the keys are stable.

use serde::Deserialize;
use serde_json::{Value, json};

use super::{
    ask::Count,
    encoder::Encoder,
    encoding::Encoding,
    error::EncodingError,
    judge::{Errors, EvaluationSet},
    known::known_lamps,
    makeup::Ingredients,
    words::{from_words, rounded, to_words, words_from_text, words_in_text},
};
use crate::{spectrum::Band, study::Measure};

/// Least height of a light in words: an f32 loses its digits below 1e-38, and a light is made of
/// numbers much smaller than itself.
const LEAST_PEAK: f64 = 1e-36;

/// An encoding as it is handed on: rounded to words, judged by what took no part in the choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Encoded {
    /// The encoding, its numbers those of the words.
    pub encoding: Encoding,
    /// Its words.
    pub words: Vec<u32>,
    /// Its errors on the panel that judges.
    pub errors: Errors,
    /// CIEDE2000 of its own colour.
    pub own: f64,
}

/// Rounds an encoding of a light (values on the band's grid) to words and judges what they decode
/// to; the reflectances of the patches have `numbers` numbers, those that the light was allowed.
///
/// # Errors
/// [`EncodingError`] for a light without colour and numbers that no word holds.
pub fn judged(
    encoder: &Encoder,
    judge: &EvaluationSet,
    values: &[f64],
    (encoding, numbers): (&Encoding, usize),
) -> Result<Encoded, EncodingError> {
    let largest = values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    if largest > 0.0 && largest < LEAST_PEAK {
        return Err(EncodingError::TooSmall {
            found: largest,
            least: LEAST_PEAK,
        });
    }
    let decoder = encoder.decoder();
    let measures = judge.measures();
    let encoding = rounded(encoding, decoder, measures.patches.observer())?;
    let words = to_words(&encoding)?;
    let exact = judge
        .exact(values)
        .ok_or(EncodingError::NoColour { band: judge.band() })?;
    let decoded = decoder.decode(&encoding)?;
    let verdict = exact.verdict_through(&decoded, &[], &judge.patches_as_cosines(numbers));
    Ok(Encoded {
        errors: (&verdict).into(),
        own: verdict[Measure::Own].unwrap_or(f64::INFINITY),
        encoding,
        words,
    })
}

/// Output of `encode --json`.
pub(crate) fn encode_json(encoded: &Encoded) -> Value {
    let mut all = decode_json(&encoded.encoding, &encoded.words);
    all["error"] = json!(encoded.errors);
    all["error"]["delta_e_own"] = json!(encoded.own);
    all
}

/// Output of `decode --json`: the same without errors, which need the light.
pub(crate) fn decode_json(encoding: &Encoding, words: &[u32]) -> Value {
    let title = |index: u8| Some(&known_lamps().get(usize::from(index))?.title);
    let atoms = encoding.atoms.iter();
    let atoms = atoms.map(|a| json!({"name": title(a.index), "weight": a.weight}));
    let mut all = json!({
        "numbers": encoding.numbers(),
        "strict_numbers": encoding.strict_numbers(),
        "range_nm": encoding.band(),
        "words": words_in_text(words),
        "atoms": atoms.collect::<Value>(),
        "cosine": [],
        "lines": encoding.lines,
    });
    // Another basis only where one of today's ways was the best.
    all[encoding.smooth.basis.word()] = json!(encoding.smooth.coefficients);
    all
}

/// Output of `encode` without `--json`: words, makeup and errors in readable form; numbers by the
/// counting rule used.
pub(crate) fn encode_words(encoded: &Encoded, count: Count) -> String {
    let Encoded {
        encoding,
        words,
        errors,
        own,
    } = encoded;
    let makeup = Ingredients::of(encoding);
    let mut text = format!(
        "{}\n{}\n",
        words_in_text(words).join(" "),
        makeup.in_words()
    );
    for line in makeup.lines_in_words() {
        text.push_str(&format!("  line at {line}\n"));
    }
    let numbers = encoding.numbers();
    let numbers = match count {
        Count::Words => format!("{numbers} numbers"),
        Count::Strict => format!(
            "{} numbers, strictly counted ({numbers} words)",
            encoding.strict_numbers()
        ),
    };
    text.push_str(&format!(
        "{numbers}; patches {:.4}, behind 10 nm filters {:.4}, spectrum {:.3} %, own colour {:.1e}\n",
        errors.patches,
        errors.filters,
        100.0 * errors.blurred,
        own
    ));
    text
}

/// The encoding in a text: words in hexadecimal digits, or the JSON that `encode` prints. JSON says
/// the range that was encoded; words, and JSON that does not, are of `band`, or of 380-780 nm where
/// none is given.
///
/// # Errors
/// [`EncodingError::Words`] with what is wrong, [`EncodingError::Band`] for a `band` that is not the
/// JSON's.
pub(crate) fn read_encoding(
    text: &str,
    band: Option<Band>,
) -> Result<(Encoding, Vec<u32>), EncodingError> {
    let text = text.trim();
    let mut of_text = None;
    let words = if text.starts_with('{') {
        let wrong = |found: String| EncodingError::Words {
            found,
            expected: "JSON with the list \"words\"",
        };
        let json: Value = serde_json::from_str(text).map_err(|e| wrong(e.to_string()))?;
        let range = &json["range_nm"];
        of_text = Option::<Band>::deserialize(range).map_err(|_| EncodingError::Words {
            found: format!("the range {range}"),
            expected: "\"range_nm\" with two whole nm, as in [380, 780]",
        })?;
        let list = json["words"].as_array();
        let list = list.ok_or_else(|| wrong("JSON without it".to_owned()))?;
        let mut words = Vec::with_capacity(list.len());
        for word in list {
            let text = word.as_str();
            let text = text.ok_or_else(|| wrong(format!("the word {word}")))?;
            words.extend(words_from_text(text)?);
        }
        words
    } else {
        words_from_text(text)?
    };
    let expected = of_text.or(band).unwrap_or(Band::VISIBLE);
    match band {
        Some(found) if found != expected => Err(EncodingError::Band { found, expected }),
        _ => Ok((from_words(&words, expected)?, words)),
    }
}
