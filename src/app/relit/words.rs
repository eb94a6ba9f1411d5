//! What was measured of a picture in few numbers, in sentences and rows of tables.

use super::{Fit, Looked, Stored, Turned, store::bytes_words};
use crate::{
    app::verdicts::Seen,
    io::many::{capitalised, many},
    pictures::{Errors, Peer, Trust, Verdict},
};

/// Cells of a table, row after row.
pub type Rows = Vec<Vec<String>>;

/// The result: numbers, what colours are off by, bytes.
pub fn headline(fit: &Fit, turned: &Turned, stored: Option<&Stored>) -> String {
    let looked = &fit.looked.0;
    let spread = turned.spread;
    let under = if turned.refused.is_empty() {
        format!("Under {} its colours are", turned.light)
    } else {
        "Its own colours are".to_owned()
    };
    let bytes = stored.and_then(|stored| {
        let bytes = stored.bytes;
        let [full, compact, exact] = [bytes.full?, bytes.compact?, bytes.exact?].map(bytes_words);
        Some(format!(
            " Files: {full} full, {compact} compact, {exact} with every band."
        ))
    });
    format!(
        "{} in {} numbers a pixel instead of {}. {under} off by ΔE₀₀ {:.2} on average, at most \
         {:.2} in 95 % of the pixels ({}), {:.1} in the worst.{}",
        capitalised(&looked.name),
        fit.operator.numbers(),
        looked.bands().len(),
        spread.mean,
        spread.p95,
        Seen::of(spread.p95).seen(),
        spread.max,
        bytes.unwrap_or_default()
    )
}

/// How far the colours under this light can be believed.
pub fn trust_line(turned: &Turned) -> String {
    let Some(trust) = &turned.trust else {
        return turned.refused.clone();
    };
    let Trust { noise, .. } = trust;
    let blind = trust.blind.iter().copied().fold(0.0, f64::max);
    let (light, percent) = (&turned.light, 100.0 * blind);
    let noise = format!("noise of the bands moves colours by about ΔE₀₀ {noise:.2}");
    match trust.verdict {
        Verdict::Good => format!("Colours under {light} are reliable here: {noise}."),
        Verdict::Care | Verdict::Refused => format!(
            "Colours under {light} are uncertain: {percent:.0} % of its colour falls where the \
             picture was in the dark; {noise}."
        ),
    }
}

/// How fast it went, a sentence: the numbers made, and the light turned.
pub fn speed_line(fit: &Fit, turned: &Turned) -> String {
    let [width, height] = fit.looked.0.size();
    let pixels = (width * height) as f64;
    let seconds = fit.encoded_in.as_secs_f64().max(1e-9);
    format!(
        "One matrix made these numbers, {:.1} million pixels a second on this computer; another \
         light takes {:.1} ms for the {} pixels that are drawn.",
        1e-6 * pixels / seconds,
        1e3 * turned.turned_in.as_secs_f64(),
        width * height
    )
}

/// How many numbers are enough, a sentence.
pub fn fewer(looked: &Looked) -> String {
    let choice = &looked.choice;
    let count = choice.chosen.numbers;
    let under = if looked.bands().is_factor() || looked.known.is_some() {
        "under six lights"
    } else {
        "of its own colour"
    };
    let (p95, rms) = (choice.bound_p95, 100.0 * choice.bound_rms);
    if choice.is_reached {
        format!(
            "{count} are the fewest that keep ΔE₀₀ {under} within {p95} in 95 % of the \
             pixels and the spectra within {rms:.1} % (rms)."
        )
    } else {
        format!(
            "No count keeps ΔE₀₀ {under} within {p95} in 95 % of the pixels and the spectra \
             within {rms:.1} % (rms); {} nearest.",
            many(count, "comes", "come")
        )
    }
}

/// Each form on disk: what it is, its bytes, bytes a pixel, what own colours are off by in 95 %.
pub fn byte_rows(fit: &Fit, stored: &Stored) -> Rows {
    let looked = &fit.looked.0;
    let pixels = (looked.survey.measured + looked.survey.no_data).max(1) as f64;
    let own = |p95: f64| format!("{p95:.2}");
    let bytes = stored.bytes;
    let rows = [
        ("every band, .exr", bytes.exact, "–".to_owned()),
        ("full, .exr", bytes.full, own(stored.full.own.p95)),
        (
            "compact, .cspx.png",
            bytes.compact,
            own(stored.compact.error.own.p95),
        ),
    ];
    let row = |(name, bytes, off): (&str, Option<u64>, String)| {
        let bytes = bytes.unwrap_or(0);
        vec![
            name.to_owned(),
            bytes_words(bytes),
            format!("{:.1}", bytes as f64 / pixels),
            off,
        ]
    };
    rows.into_iter().map(row).collect()
}

/// How many decoded values are below zero, a sentence; empty where none is.
pub fn negative_words(errors: &Errors) -> String {
    match errors.negative {
        0 => String::new(),
        count => format!(
            "{} below zero when they are decoded: kept, and cut on the screen alone.",
            many(count as usize, "value is", "values are")
        ),
    }
}

/// The ways of keeping a picture: cells row after row, and what they say, a sentence.
pub fn peer_rows(peers: &[Peer]) -> (Rows, String) {
    let number = |value: Option<f64>| value.map_or("–".to_owned(), |v| format!("{v:.2}"));
    let rows = peers.iter().map(|peer| {
        let (error, lights) = (peer.error.as_ref(), peer.lights());
        vec![
            peer.name.to_owned(),
            peer.numbers.to_string(),
            peer.bytes.map_or("–".to_owned(), bytes_words),
            number(error.map(|e| e.own.p95)),
            number(lights.map(|s| s.mean)),
            number(lights.map(|s| s.p95)),
            number(error.map(|e| 100.0 * e.relative_rms)),
            peer.description.clone(),
        ]
    });
    (rows.collect(), nearest(peers))
}

/// Which of the ways of so many numbers is nearest, whoever it is.
fn nearest(peers: &[Peer]) -> String {
    let run = || peers.iter().filter(|peer| peer.error.is_some());
    let off = |peer: &Peer| {
        let own = peer.error.as_ref().map_or(f64::INFINITY, |e| e.own.mean);
        peer.lights().map_or(own, |lights| lights.mean)
    };
    let rms = |peer: &Peer| {
        let error = peer.error.as_ref();
        error.map_or(f64::INFINITY, |e| e.relative_rms)
    };
    let best = |of: &dyn Fn(&Peer) -> f64| run().min_by(|a, b| of(a).total_cmp(&of(b)));
    let (Some(colour), Some(spectra)) = (best(&off), best(&rms)) else {
        return "Nothing was measured.".to_owned();
    };
    let ways = many(run().count(), "way", "ways");
    format!(
        "Of {ways} with {} numbers a pixel, {} is nearest in colour (mean ΔE₀₀ {:.2}) and {} in \
         the spectra (rms {:.2} %).",
        colour.numbers,
        colour.name,
        off(colour),
        spectra.name,
        100.0 * rms(spectra)
    )
}
