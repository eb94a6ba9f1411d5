//! Per cent or fraction is one answer for all spectra of a kind in a file: of a white and a black
//! patch in per cent, the black one alone would look like a fraction.

use crate::io::Reading;
use crate::io::choices::Counted;
use crate::io::reading::decision::{Decision, Decisions, Origin};
use crate::io::reading::facts::Facts;
use crate::languages::fixed;
use crate::spectrum::Kind;

/// Takes what was guessed to be a fraction for per cent where others of its kind in the file were
/// guessed to be per cent. What the file states, or a person decided, stays. What is plain of one
/// spectrum is plain of the others, so that nothing is asked about the black patch of a chart.
pub(crate) fn agree(reading: &mut Reading) {
    for kind in [Kind::Reflectance, Kind::Transmittance] {
        count_alike(kind, reading);
    }
    let counted = reading
        .facts
        .iter()
        .filter_map(|facts| facts.decisions.counted.as_ref());
    let evident = counted.filter(|counted| counted.origin == Origin::Evident);
    let mut evident: Vec<Counted> = evident.map(|counted| counted.value).collect();
    evident.dedup();
    for facts in &mut reading.facts {
        if let Some(counted) = &mut facts.decisions.counted
            && counted.is_doubtful()
            && evident.contains(&counted.value)
        {
            counted.origin = Origin::Evident;
        }
    }
}

fn count_alike(kind: Kind, reading: &mut Reading) {
    let guessed = |facts: &Facts, as_what: Counted| {
        let Decisions {
            kind: of, counted, ..
        } = &facts.decisions;
        let is_it = |counted: &Decision<_>| counted.is_guess() && counted.value == as_what;
        of.value == kind && counted.as_ref().is_some_and(is_it)
    };
    let spectra = reading.spectra.iter().zip(&reading.facts);
    let percent = spectra.filter(|(_, facts)| guessed(facts, Counted::Percent));
    let highest = percent
        .flat_map(|(spectrum, _)| spectrum.samples.values())
        .fold(0.0_f64, |highest, value| highest.max(*value));
    if highest <= 0.0 {
        return;
    }
    let to_fraction = Counted::Percent.scale().unwrap_or(1.0);
    let reason = tr!(
        "others in the file reach {highest}",
        highest = fixed(highest / to_fraction, 3)
    );
    let spectra = reading.spectra.iter_mut().zip(&mut reading.facts);
    for (spectrum, facts) in spectra.filter(|(_, facts)| guessed(facts, Counted::Fraction)) {
        spectrum.samples = spectrum.samples.scaled(to_fraction);
        spectrum.scale *= to_fraction;
        facts.tells_scale = true;
        facts.decisions.counted = Some(Decision::guessed(Counted::Percent, true, &*reason));
    }
}
