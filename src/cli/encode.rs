//! `encode`: a light in a few words, by known lamps and lines of their own width.

use std::io::Write;

use super::{
    arguments::Encode, inputs::Inputs, options::ModelOptions, print, print_json, race::light_alone,
    refusal::Refusal, subject,
};
use crate::{
    app::Settings,
    lamps::{
        Ask, Count, Encoder, EncodingError, EvaluationSet, LeaveOut, encode_json, encode_words,
        judged,
    },
    spectrum::Band,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read, is no light or has no colour, and a count or range
/// that cannot be encoded.
pub(super) fn run(
    options: &Encode,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Encode {
        input,
        numbers,
        portable,
        strict,
        pick,
        range,
        observer,
        json,
    } = options;
    let model = ModelOptions {
        range: *range,
        observer: *observer,
        ..ModelOptions::default()
    };
    let app = subject::app(input, pick, model, inputs)?;
    let light = light_alone(&app)?;
    let Settings { band, observer, .. } = app.document().settings;
    let refused = |why: EncodingError| match why {
        EncodingError::NoColour { .. }
        | EncodingError::NotFinite { .. }
        | EncodingError::TooSmall { .. } => Refusal::File(format!("{}: {why}", light.name())),
        EncodingError::Numbers { .. } => Refusal::Usage(format!("--{why}")),
        why => Refusal::Usage(why.to_string()),
    };
    let spikes = app.document().settings.spike_settings();
    let encoder = Encoder::new(band, observer, spikes).map_err(refused)?;
    let spectrum = &light.spectrum;
    let values = spectrum.samples.on_band(band, spectrum.kind.outside());
    let ask = Ask {
        numbers: *numbers,
        count: if *strict { Count::Strict } else { Count::Words },
        known_lamps: !portable,
        leave_out: LeaveOut::None,
    };
    let chosen = encoder.encode(&values, ask).map_err(refused)?;
    let judge = EvaluationSet::judging(band, observer);
    let encoded =
        judged(&encoder, &judge, &values, (&chosen.encoding, *numbers)).map_err(refused)?;
    if !*json && band != Band::VISIBLE {
        inputs.note(format!(
            "the words do not hold the range: decode them with --range {}:{}",
            band.min_nm(),
            band.max_nm()
        ));
    }
    if !encoded.encoding.atoms.is_empty() {
        inputs.note("the words need the program's list of known lamps to be decoded");
    }
    if *json {
        print_json(out, &encode_json(&encoded))
    } else {
        print(out, &encode_words(&encoded, ask.count))
    }
}
