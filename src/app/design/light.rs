//! Channels as lights, what stands before them, and a mixture as a spectrum.

use std::sync::Arc;

use crate::{
    app::{
        design::mix::title,
        entry::Entry,
        products::Link,
        recipe::{Gel, NameOf, Times},
    },
    color::xyz::{FIRST_NM, LAST_NM},
    design::mixture::{Channel, MixError, Source, Spec, mixed},
    languages::fixed,
    spectrum::{Band, Kind, NamedSpectrum, Sampled},
};

/// A channel of what it is made of; `table` has the light of a key, `gels` the shares that pass what
/// stands before it on whole nm 360-830.
///
/// # Errors
/// [`MixError`] for a light that is not there or has no power.
pub(crate) fn channel(
    source: &Source,
    table: impl FnOnce(&str) -> Option<Sampled>,
    gels: Option<&[f64]>,
) -> Result<Channel, MixError> {
    let light = match source {
        Source::Named(key) => table(key),
        _ => None,
    };
    let channel = Channel::new(Spec::of(source.clone()), light.as_ref())?;
    match gels {
        Some(shares) => channel.through(shares),
        None => Ok(channel),
    }
}

/// The shares that pass all gels on whole nm 360-830, each at its thickness; `None` without one. A
/// gel that is not there keeps nothing back.
pub(crate) fn gels_on_nm(
    gels: &[Gel],
    find: impl Fn(&str) -> Option<Arc<Entry>>,
) -> Option<Vec<f64>> {
    let band = Band::new(f64::from(FIRST_NM), f64::from(LAST_NM)).ok()?;
    let each = gels.iter().filter_map(|gel| {
        let times = Times {
            thickness: gel.thickness,
            ..Times::default()
        };
        Some(Link::new(find(&gel.key)?, times).on_band(band))
    });
    each.reduce(|mut all, one| {
        all.iter_mut().zip(one).for_each(|(a, b)| *a *= b);
        all
    })
}

/// The mixture as a light on whole nm 360-830; `None` where nothing shines.
pub(crate) fn spectrum(
    channels: &[Channel],
    powers: &[f64],
    gels: &[Gel],
    name_of: NameOf<'_>,
) -> Option<NamedSpectrum> {
    let values = mixed(channels, powers);
    let both = channels.iter().zip(powers);
    let shine: Vec<(&Channel, f64)> = both.map(|(c, power)| (c, power * c.power())).collect();
    let whole: f64 = shine.iter().map(|(_, power)| power).sum();
    let share = |power: &f64| format!("{} %", fixed(100.0 * power / whole, 1));
    let parts: Vec<String> = shine
        .iter()
        .filter(|(_, power)| *power > 0.0)
        .map(|(channel, power)| {
            format!("{} {}", title(&channel.spec.source, name_of), share(power))
        })
        .collect();
    let gels: Vec<String> = gels.iter().map(|gel| gel.words(name_of)).collect();
    let gels = gels
        .into_iter()
        .reduce(|list, last| tr!("{list} and {last}", list, last));
    let name = match (&parts[..], &gels) {
        ([], _) => return None,
        ([one], None) => tr!("Mixture of {channel}", channel = one),
        ([one], Some(gels)) => tr!("Mixture of {channel} behind {gels}", channel = one, gels),
        (all, None) => tr!("Mixture of {count} channels", count = all.len()),
        (all, Some(gels)) => tr!(
            "Mixture of {count} channels behind {gels}",
            count = all.len(),
            gels
        ),
    };
    let shares = parts.join(", ");
    let note = match &gels {
        None => tr!(
            "Mixed, shares of power: {shares}. A line without width is split over its two \
             neighbouring nm.",
            shares
        ),
        Some(gels) => tr!(
            "Mixed behind {gels}, shares of power: {shares}. A line without width is split over \
             its two neighbouring nm.",
            gels,
            shares
        ),
    };
    Some(NamedSpectrum {
        name,
        kind: Kind::Light,
        unit: "relative".to_owned(),
        scale: 1.0,
        samples: Sampled::even(f64::from(FIRST_NM), 1.0, values).ok()?,
        notes: vec![note],
        source: "mixed channels".to_owned(),
    })
}
