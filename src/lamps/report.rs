//! Encodings as JSON; the keys are stable.

use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::{
    ask::Count,
    encoder::Encoder,
    encoding::Encoding,
    error::EncodingError,
    judge::{Errors, Panel},
    known::known_lamps,
    makeup::Ingredients,
    words::{from_words, rounded, to_words, words_from_text},
};
use crate::spectrum::{Band, Basis};

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
    judge: &Panel,
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
    let encoding = rounded(encoding, decoder, judge.observer())?;
    let words = to_words(&encoding)?;
    let exact = judge
        .exact(values)
        .ok_or(EncodingError::NoColour { band: judge.band() })?;
    let decoded = decoder.decode(&encoding)?;
    let patches = judge.patches_as_cosines(numbers);
    Ok(Encoded {
        errors: judge.errors(&exact, &decoded, &patches),
        own: judge.own(&exact, &decoded),
        encoding,
        words,
    })
}

/// What `encode --json` prints.
pub fn encode_json(encoded: &Encoded) -> Value {
    let Encoded {
        encoding,
        words,
        errors,
        own,
    } = encoded;
    let mut all = parts_json(encoding, words);
    all.insert(
        "error".to_owned(),
        json!({
            "patches_check": errors.patches,
            "filters": errors.filters,
            "relative_rms_10nm": errors.blurred,
            "delta_e_own": own,
        }),
    );
    Value::Object(all)
}

/// What `decode --json` prints: the same without errors, which need the light.
pub(crate) fn decode_json(encoding: &Encoding, words: &[u32]) -> Value {
    Value::Object(parts_json(encoding, words))
}

fn parts_json(encoding: &Encoding, words: &[u32]) -> Map<String, Value> {
    let title = |index: u8| {
        known_lamps()
            .get(usize::from(index))
            .map(|lamp| lamp.title.as_str())
    };
    let atoms = encoding
        .atoms
        .iter()
        .map(|a| json!({"name": title(a.index), "weight": a.weight}));
    let lines = encoding
        .lines
        .iter()
        .map(|l| json!({"at_nm": l.at_nm, "fwhm_nm": l.fwhm_nm, "weight": l.weight}));
    let words: Vec<String> = words.iter().map(|word| format!("{word:08x}")).collect();
    let smooth = &encoding.smooth.coefficients;
    let none: &[f64] = &[];
    let (cosine, fourier) = match encoding.smooth.basis {
        Basis::Cosine => (&smooth[..], None),
        Basis::Fourier => (none, Some(&smooth[..])),
    };
    let mut all = Map::new();
    let band = encoding.band();
    all.insert("numbers".to_owned(), json!(encoding.numbers()));
    let strict = encoding.strict_numbers();
    all.insert("strict_numbers".to_owned(), json!(strict));
    let range_nm = [band.min_nm(), band.max_nm()];
    all.insert("range_nm".to_owned(), json!(range_nm));
    all.insert("words".to_owned(), json!(words));
    all.insert("atoms".to_owned(), atoms.collect());
    all.insert("cosine".to_owned(), json!(cosine));
    // Only where one of today's Fourier ways was the best.
    if let Some(fourier) = fourier {
        all.insert("fourier".to_owned(), json!(fourier));
    }
    all.insert("lines".to_owned(), lines.collect());
    all
}

/// What `encode` prints without `--json`: words, makeup and errors for people; numbers as they were
/// counted.
pub(crate) fn encode_words(encoded: &Encoded, count: Count) -> String {
    let Encoded {
        encoding,
        words,
        errors,
        own,
    } = encoded;
    let words: Vec<String> = words.iter().map(|word| format!("{word:08x}")).collect();
    let makeup = Ingredients::of(encoding);
    let mut text = format!("{}\n{}\n", words.join(" "), makeup.in_words());
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
pub fn read_encoding(
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
        if !range.is_null() {
            let read = Band::deserialize(range).map_err(|_| EncodingError::Words {
                found: format!("the range {range}"),
                expected: "\"range_nm\" with two whole nm, as in [380, 780]",
            })?;
            of_text = Some(read);
        }
        let list = json["words"]
            .as_array()
            .ok_or_else(|| wrong("JSON without it".to_owned()))?;
        let mut words = Vec::with_capacity(list.len());
        for word in list {
            let word = word
                .as_str()
                .ok_or_else(|| wrong(format!("the word {word}")))?;
            words.extend(words_from_text(word)?);
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
