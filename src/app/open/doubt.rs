//! What a file tells of its spectra beside their values: sigma, mask, exposure.

use std::sync::Arc;

use crate::{
    app::{
        measured::{is_sigma_of, measurement, own_measurement, spectrum, states_doubt},
        opened::Opened,
    },
    io::{disk, exposure_ms},
    measurements::Measurement,
    spectrum::NamedSpectrum,
};

/// Bytes of a file that are looked through for an exposure.
const HEAD: u64 = 1 << 16;

/// Finds what is known of a file's spectra beside their values.
pub(super) fn find(opened: &mut Opened) {
    let Some(head) = text_of(opened, HEAD) else {
        return;
    };
    let pairs = opened.spectra.windows(2).enumerate();
    let beside = pairs.filter(|(_, pair)| {
        let says_so = is_sigma_of(&pair[1].name, &pair[0].name);
        says_so.is_some_and(|is_own| is_own || opened.choices.take_sigma)
            && pair[0].samples.nm() == pair[1].samples.nm()
    });
    opened.sigmas = beside.map(|(index, _)| index + 1).collect();
    let exposure = exposure_ms(&head);
    let own = || own_measurement(&text_of(opened, u64::MAX)?);
    let whole = states_doubt(&head).then(own).flatten();
    let all = 0..opened.spectra.len();
    let known = all.filter(|index| !opened.is_sigma(*index));
    let known = known.filter_map(|index| {
        let of = &opened.spectra[index];
        let sigma = opened.spectra.get(index + 1);
        let sigma = sigma.filter(|_| opened.is_sigma(index + 1));
        let sigma = sigma.map(|sigma| on_scale_of(sigma, of));
        let sigma = sigma.as_ref();
        let whole = whole.clone().filter(|whole| is_that(whole, of));
        let mut found = whole.or_else(|| measurement(of, sigma).ok())?;
        found.exposure_ms = exposure.or(found.exposure_ms);
        let is_more = found != measurement(of, None).ok()?;
        is_more.then(|| (index, Arc::new(found)))
    });
    opened.measured = known.collect();
}

/// A sigma on the scale that the values were read on: per cent are per cent of both.
fn on_scale_of(sigma: &NamedSpectrum, of: &NamedSpectrum) -> NamedSpectrum {
    let by = of.scale / sigma.scale;
    let is_other = by.is_finite() && by > 0.0 && by != 1.0;
    NamedSpectrum {
        samples: match is_other {
            true => sigma.samples.scaled(by),
            false => sigma.samples.clone(),
        },
        ..sigma.clone()
    }
}

/// True if a measurement is what a spectrum was read from.
fn is_that(whole: &Measurement, of: &NamedSpectrum) -> bool {
    spectrum(whole, "").samples == of.samples
}

/// The beginning of a file of text.
fn text_of(opened: &Opened, most: u64) -> Option<String> {
    let found = match (&opened.bytes, &opened.path) {
        (Some(bytes), _) => {
            let count = usize::try_from(most).map_or(bytes.len(), |most| most.min(bytes.len()));
            bytes[..count].to_vec()
        }
        // A pipe is empty by now.
        (None, Some(path)) if disk::is_file(path) => disk::head(path, most),
        (None, _) => return None,
    };
    Some(String::from_utf8_lossy(&found).into_owned())
}
