//! Spectral OpenEXR out: pictures of one channel a wavelength.
//!
//! The layout is that of Fichet, Pacanowski and Wilkie, JCGT 10(3), 2021: `T.550,000000nm` is the
//! reflectance at 550 nm, `S0.550,000000nm` the light there. Light with spikes has one channel more
//! a spike, `line.<nm>nm` with its exact energy, so that a reader who knows it gets smooth part and
//! spikes apart, and all others the right colour. `io/formats/spectral_exr.rs` reads them back.

use super::exr;

use crate::languages::said;

/// Planes at wavelengths (nm), each row after row from the top.
type Planes = Vec<(f64, Vec<f32>)>;

/// The message about planes that are not one value a pixel each, a plane a band.
const UNEQUAL: &str = later!("found planes of another size, expected one value a pixel and band");

/// A picture of reflectances, a plane for each band (nm). `facts` become attributes (`made.light`
/// for "light").
///
/// # Errors
/// The fault of the planes, or the encoder's error, in words.
pub fn reflectance_exr(
    size: [usize; 2],
    bands_nm: &[f64],
    planes: Vec<Vec<f32>>,
    facts: &[(&str, String)],
) -> Result<Vec<u8>, String> {
    if planes.len() != bands_nm.len() {
        return Err(said(UNEQUAL).to_owned());
    }
    let bands = bands_nm.iter().copied().zip(planes).collect();
    let texts = [("spectralLayoutVersion", "1.0")];
    spectral(size, named("T", bands), &texts, facts)
}

/// A picture of light: a plane for each stratum at its middle (the whole light a nm, spikes
/// within), a plane for each spike (its energy). `facts` as in [`reflectance_exr`].
///
/// # Errors
/// As [`reflectance_exr`].
pub(crate) fn light_exr(
    size: [usize; 2],
    [strata, spikes]: [Planes; 2],
    facts: &[(&str, String)],
) -> Result<Vec<u8>, String> {
    let texts = [
        ("spectralLayoutVersion", "1.0"),
        ("emissiveUnits", "W.m^-2.sr^-1.nm^-1"),
    ];
    let channels = named("S0", strata).chain(named("line", spikes));
    spectral(size, channels, &texts, facts)
}

fn named(what: &str, planes: Planes) -> impl Iterator<Item = (String, Vec<f32>)> {
    planes.into_iter().map(move |(nm, plane)| {
        let place = format!("{nm:.6}").replace('.', ",");
        (format!("{what}.{place}nm"), plane)
    })
}

fn spectral(
    size: [usize; 2],
    channels: impl Iterator<Item = (String, Vec<f32>)>,
    texts: &[(&str, &str)],
    facts: &[(&str, String)],
) -> Result<Vec<u8>, String> {
    let channels: Vec<_> = channels.collect();
    if channels
        .iter()
        .any(|(_, plane)| plane.len() != size[0] * size[1])
    {
        return Err(said(UNEQUAL).to_owned());
    }
    let texts = texts
        .iter()
        .map(|(key, text)| ((*key).to_owned(), (*text).to_owned()));
    // Plain names such as "view" are the format's own.
    let facts = facts
        .iter()
        .map(|(key, fact)| (format!("made.{key}"), fact.clone()));
    exr::image(size, channels, texts.chain(facts))
        .map_err(|why| tr!("found {why}, expected to write OpenEXR", why))
}
