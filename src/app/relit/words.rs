//! What was measured of a picture in few numbers, in sentences and rows of tables.

use super::{Fit, Looked, Stored, Turned, store::bytes_words};
use crate::{
    app::verdicts::Seen,
    io::many::capitalised,
    languages::{fixed, with_sign},
    pictures::{Errors, Peer, Trust, Verdict},
};

/// Cells of a table, row after row.
pub type Rows = Vec<Vec<String>>;

/// The result: numbers, what colours are off by, bytes.
pub fn headline(fit: &Fit, turned: &Turned, stored: Option<&Stored>) -> String {
    let looked = &fit.looked.0;
    let spread = turned.spread;
    let (mean, p95) = (fixed(spread.mean, 2), fixed(spread.p95, 2));
    let (seen, worst) = (Seen::of(spread.p95).seen(), fixed(spread.max, 1));
    let off = if turned.refused.is_empty() {
        tr!(
            "Under {light} its colours are off by ΔE₀₀ {mean} on average, at most {p95} in 95 % \
             of the pixels ({seen}), {worst} in the worst.",
            light = turned.light,
            mean,
            p95,
            seen,
            worst
        )
    } else {
        tr!(
            "Its own colours are off by ΔE₀₀ {mean} on average, at most {p95} in 95 % of the \
             pixels ({seen}), {worst} in the worst.",
            mean,
            p95,
            seen,
            worst
        )
    };
    let files = stored.and_then(|stored| {
        let bytes = stored.bytes;
        let [full, compact, exact] = [bytes.full?, bytes.compact?, bytes.exact?].map(bytes_words);
        Some(tr!(
            "Files: {full} full, {compact} compact, {exact} with every band.",
            full,
            compact,
            exact
        ))
    });
    let numbers = tr!(
        "{picture} in {count} numbers a pixel instead of {bands}.",
        picture = capitalised(&looked.name),
        count = fit.operator.numbers(),
        bands = looked.bands().len()
    );
    let all: Vec<String> = [numbers, off].into_iter().chain(files).collect();
    all.join(" ")
}

/// How far the colours under this light can be believed.
pub fn trust_line(turned: &Turned) -> String {
    let Some(trust) = &turned.trust else {
        return turned.refused.clone();
    };
    let Trust { noise, .. } = trust;
    let blind = trust.blind.iter().copied().fold(0.0, f64::max);
    let (light, share) = (&turned.light, fixed(100.0 * blind, 0));
    let noise = fixed(noise, 2);
    match trust.verdict {
        Verdict::Good => tr!(
            "Colours under {light} are reliable here: noise of the bands moves colours by about \
             ΔE₀₀ {noise}.",
            light,
            noise
        ),
        Verdict::Care | Verdict::Refused => tr!(
            "Colours under {light} are uncertain: {share} % of its colour falls where the picture \
             was in the dark; noise of the bands moves colours by about ΔE₀₀ {noise}.",
            light,
            share,
            noise
        ),
    }
}

/// How fast it went, a sentence: the numbers made, and the light turned.
pub fn speed_line(fit: &Fit, turned: &Turned) -> String {
    let [width, height] = fit.looked.0.size();
    let pixels = (width * height) as f64;
    let seconds = fit.encoded_in.as_secs_f64().max(1e-9);
    tr!(
        "One matrix made these numbers, {speed} million pixels a second on this computer; another \
         light takes {time} ms for the {count} pixels that are drawn.",
        speed = fixed(1e-6 * pixels / seconds, 1),
        time = fixed(1e3 * turned.turned_in.as_secs_f64(), 1),
        count = width * height
    )
}

/// How many numbers are enough, a sentence.
pub fn fewer(looked: &Looked) -> String {
    let choice = &looked.choice;
    let count = choice.chosen.numbers;
    let is_under_lights = looked.bands().is_factor() || looked.known.is_some();
    let p95 = with_sign(choice.bound_p95.to_string());
    let rms = fixed(100.0 * choice.bound_rms, 1);
    match (choice.is_reached, is_under_lights) {
        (true, true) => tr!(
            "{count} are the fewest that keep ΔE₀₀ under six lights within {p95} in 95 % of the \
             pixels and the spectra within {rms} % (rms).",
            count,
            p95,
            rms
        ),
        (true, false) => tr!(
            "{count} are the fewest that keep ΔE₀₀ of its own colour within {p95} in 95 % of the \
             pixels and the spectra within {rms} % (rms).",
            count,
            p95,
            rms
        ),
        (false, true) => tr!(
            "No count keeps ΔE₀₀ under six lights within {p95} in 95 % of the pixels and the \
             spectra within {rms} % (rms); {n} comes nearest."
                | "No count keeps ΔE₀₀ under six lights within {p95} in 95 % of the pixels and \
                   the spectra within {rms} % (rms); {n} come nearest."
                    % count,
            p95,
            rms
        ),
        (false, false) => tr!(
            "No count keeps ΔE₀₀ of its own colour within {p95} in 95 % of the pixels and the \
             spectra within {rms} % (rms); {n} comes nearest."
                | "No count keeps ΔE₀₀ of its own colour within {p95} in 95 % of the pixels and \
                   the spectra within {rms} % (rms); {n} come nearest."
                    % count,
            p95,
            rms
        ),
    }
}

/// Each form on disk: what it is, its bytes, bytes a pixel, what own colours are off by in 95 %.
pub fn byte_rows(fit: &Fit, stored: &Stored) -> Rows {
    let looked = &fit.looked.0;
    let pixels = (looked.survey.measured + looked.survey.no_data).max(1) as f64;
    let own = |p95: f64| fixed(p95, 2);
    let bytes = stored.bytes;
    let rows = [
        (said!("every band, .exr"), bytes.exact, "–".to_owned()),
        (said!("full, .exr"), bytes.full, own(stored.full.own.p95)),
        (
            said!("compact, .cspx.png"),
            bytes.compact,
            own(stored.compact.error.own.p95),
        ),
    ];
    let row = |(name, bytes, off): (&str, Option<u64>, String)| {
        let bytes = bytes.unwrap_or(0);
        vec![
            name.to_owned(),
            bytes_words(bytes),
            fixed(bytes as f64 / pixels, 1),
            off,
        ]
    };
    rows.into_iter().map(row).collect()
}

/// How many decoded values are below zero, a sentence; empty where none is.
pub fn negative_words(errors: &Errors) -> String {
    match errors.negative {
        0 => String::new(),
        count => tr!(
            "{n} value is below zero when they are decoded: kept, and cut on the screen alone."
                | "{n} values are below zero when they are decoded: kept, and cut on the screen \
                   alone."
                    % count
        ),
    }
}

/// The ways of keeping a picture: cells row after row, and what they say, a sentence.
pub fn peer_rows(peers: &[Peer]) -> (Rows, String) {
    let number = |value: Option<f64>| value.map_or("–".to_owned(), |v| fixed(v, 2));
    let rows = peers.iter().map(|peer| {
        let (error, lights) = (peer.error.as_ref(), peer.lights());
        vec![
            crate::languages::said(peer.name).to_owned(),
            peer.numbers.to_string(),
            peer.bytes.map_or("–".to_owned(), bytes_words),
            number(error.map(|e| e.own.p95)),
            number(lights.map(|s| s.mean)),
            number(lights.map(|s| s.p95)),
            number(error.map(|e| 100.0 * e.relative_rms)),
            crate::languages::translated(&peer.description).to_owned(),
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
        return said!("Nothing was measured.").to_owned();
    };
    tr!(
        "Of {n} way with {numbers} numbers a pixel, {colour} is nearest in colour (mean ΔE₀₀ \
         {off}) and {spectra} in the spectra (rms {rms} %)."
            | "Of {n} ways with {numbers} numbers a pixel, {colour} is nearest in colour (mean \
               ΔE₀₀ {off}) and {spectra} in the spectra (rms {rms} %)."
                % run().count(),
        numbers = colour.numbers,
        colour = crate::languages::said(colour.name),
        off = fixed(off(colour), 2),
        spectra = crate::languages::said(spectra.name),
        rms = fixed(100.0 * rms(spectra), 2)
    )
}
