//! The figures of the library's lights that can be searched by.

use super::wanted::Figure;
use crate::{
    app::{
        entry::Entry,
        quality_report::light_of,
        tint::{Whiteness, whiteness},
    },
    color::{
        Cct, Observer, cct_from_xyz,
        quality::{fidelity, rendering},
        xyz::xyz_from_light,
    },
    spectrum::Kind,
};

/// The colour temperature of a light that is white or nearly so.
pub(super) fn kelvin(entry: &Entry) -> Option<f64> {
    cct(entry).map(|cct| cct.kelvin)
}

fn cct(entry: &Entry) -> Option<Cct> {
    if entry.kind() != Kind::Light {
        return None;
    }
    let samples = &entry.spectrum.samples;
    let xyz = xyz_from_light(samples, entry.kind().outside(), Observer::CIE_1931)?;
    let cct = cct_from_xyz(xyz).ok()?;
    (whiteness(cct) != Whiteness::Coloured).then_some(cct)
}

/// What a light's colours are like; `None` where there is no such figure.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Indices {
    ra: Option<f64>,
    rf: Option<f64>,
    r9: Option<f64>,
    r13: Option<f64>,
}

impl Indices {
    /// Those of a white light.
    pub(super) fn of(entry: &Entry) -> Self {
        let Some(cct) = cct(entry) else {
            return Self::default();
        };
        let light = light_of(&entry.spectrum).0;
        let found = rendering(&light, cct).ok();
        let sample = |number: usize| Some(found.as_ref()?.samples[number - 1].index);
        Self {
            ra: found.as_ref().map(|found| found.ra),
            rf: fidelity(&light, cct).ok().map(|found| found.rf),
            r9: sample(9),
            r13: sample(13),
        }
    }

    /// One of them; there is no temperature among them.
    pub(super) fn get(self, figure: Figure) -> Option<f64> {
        match figure {
            Figure::Kelvin => None,
            Figure::Ra => self.ra,
            Figure::Rf => self.rf,
            Figure::R9 => self.r9,
            Figure::R13 => self.r13,
        }
    }
}
