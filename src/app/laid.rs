//! How spectra are laid over the subject: on what scale, or not at all.

use super::{entry::Entry, scale::Scale, spectral_unit::SpectralUnit, state::App};
use crate::spectrum::Kind;

/// Peaks of one absolute unit that differ by more than this have no common height.
const FAR_APART: f64 = 5.0;

/// How a spectrum is laid over the subject.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Laid {
    /// On the subject's own scale: its values are multiplied by the factor of the scale alone.
    Alike(f64),
    /// A light multiplied so that it has the luminance of the light that is shown.
    EquallyBright(f64),
    /// Neither light nor surface: multiplied so that it is as high as the subject.
    AsHigh(f64),
    /// Not at all: a share of light and a power have no common axis.
    Apart,
}

impl Laid {
    /// How an entry is laid over the present subject.
    pub fn of(app: &App, entry: &Entry) -> Self {
        let document = app.document();
        let subject = &document.subject_entry().spectrum;
        let values = entry.spectrum.samples.values().iter().copied();
        let most = values.fold(0.0, f64::max);
        let as_high = || Self::AsHigh(if most > 0.0 { top(app) / most } else { 1.0 });
        match (subject.kind, entry.kind()) {
            (Kind::Light, Kind::Light) => {}
            (of, over) if of.is_factor() && over.is_factor() => return Self::Alike(1.0),
            (of, over) if of.is_factor() || over.is_factor() => {
                let both = [of, over]
                    .iter()
                    .all(|k| k.is_factor() || *k == Kind::Light);
                return if both { Self::Apart } else { as_high() };
            }
            _ => return as_high(),
        }
        // A scale that was chosen says itself what is equal.
        let own = document.scale.factor(&entry.spectrum);
        if let Some(own) = own.filter(|_| document.scale != Scale::AsMeasured) {
            return Self::Alike(own);
        }
        let ratio = most / top(app);
        let is_near = (1.0 / FAR_APART..=FAR_APART).contains(&ratio);
        let is_absolute = SpectralUnit::of(&subject.unit).is_some();
        if is_absolute && is_near && entry.spectrum.unit == subject.unit {
            return Self::Alike(1.0);
        }
        let per_luminance = |spectrum| Scale::LuminanceHundred.factor(spectrum);
        let equal = per_luminance(&entry.spectrum).zip(per_luminance(subject));
        let factor = equal.map(|(over, of)| app.scale_factor() * over / of);
        let factor = factor.filter(|factor| factor.is_finite() && *factor > 0.0);
        factor.map_or_else(as_high, Self::EquallyBright)
    }
}

/// The largest measured size on the scale in force.
pub(super) fn top(app: &App) -> f64 {
    let sizes = app.derived().measured.iter().map(|v| v.abs());
    app.scale_factor() * sizes.fold(0.0, f64::max)
}
