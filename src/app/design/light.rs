//! Channels as lights, and a mixture as a spectrum.

use crate::{
    app::design::mix::title,
    color::xyz::FIRST_NM,
    design::mixture::{Channel, MixError, Source, Spec, mixed},
    spectrum::{Kind, NamedSpectrum, Sampled},
};

/// A channel of what it is made of; `table` has the light of a key.
///
/// # Errors
/// [`MixError`] for a light that is not there or has no power.
pub fn channel(
    source: &Source,
    table: impl FnOnce(&str) -> Option<Sampled>,
) -> Result<Channel, MixError> {
    let light = match source {
        Source::Named(key) => table(key),
        _ => None,
    };
    Channel::new(Spec::of(source.clone()), light.as_ref())
}

/// The mixture as a light on whole nm 360-830; `None` where nothing shines.
pub fn spectrum(channels: &[Channel], powers: &[f64]) -> Option<NamedSpectrum> {
    let values = mixed(channels, powers);
    let whole: f64 = powers.iter().sum();
    let share = |power: &f64| format!("{:.1} %", 100.0 * power / whole);
    let parts: Vec<String> = channels
        .iter()
        .zip(powers)
        .filter(|(_, power)| **power > 0.0)
        .map(|(channel, power)| format!("{} {}", title(&channel.spec.source), share(power)))
        .collect();
    let name = match &parts[..] {
        [] => return None,
        [one] => format!("Mixture of {one}"),
        many => format!("Mixture of {} channels", many.len()),
    };
    Some(NamedSpectrum {
        name,
        kind: Kind::Light,
        unit: "relative".to_owned(),
        scale: 1.0,
        samples: Sampled::even(f64::from(FIRST_NM), 1.0, values).ok()?,
        notes: vec![format!(
            "Mixed, shares of power: {}. A line without width is split over its two neighbouring nm.",
            parts.join(", ")
        )],
        source: "mixed channels".to_owned(),
    })
}
