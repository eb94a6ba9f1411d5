//! One of two lights that are compared, and the figures that are compared.

use crate::{
    app::{
        quality_report::light_of,
        tint::{Whiteness, whiteness},
    },
    color::quality::{
        Figures, Light, NoFigure, Rendering, SP_RATIO, luminous_efficacy, photons_per_100_lx,
    },
    languages::fixed,
    spectrum::{Band, NamedSpectrum},
};

/// One of two lights that are compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// What the sentences call it.
    pub name: String,
    pub figures: Figures,
    /// The light itself, over all that is known of it.
    pub light: Light,
    /// Where both lights are known, where that is less than all that is known of either.
    shared: Option<Band>,
}

impl Side {
    /// A light by its figures, which are known already.
    pub fn new(name: String, spectrum: &NamedSpectrum, figures: Figures) -> Self {
        Self {
            name,
            figures,
            light: light_of(spectrum).0,
            shared: None,
        }
    }

    /// A light and its figures.
    pub fn of(name: String, spectrum: &NamedSpectrum) -> Self {
        let (light, measured) = light_of(spectrum);
        Self {
            name,
            figures: Figures::of(&light, measured),
            light,
            shared: None,
        }
    }

    /// Two lights of two names; where they are known over different ranges, the range of both.
    pub(super) fn paired([mut a, mut b]: [Self; 2]) -> ([Self; 2], Option<Band>) {
        if a.name == b.name {
            a.name += " (A)";
            b.name += " (B)";
        }
        let (ends_a, ends_b) = (a.light.ends_nm(), b.light.ends_nm());
        let shared = (ends_a != ends_b)
            .then(|| {
                let [from, to] = [ends_a[0].max(ends_b[0]), ends_a[1].min(ends_b[1])];
                Band::new(f64::from(from), f64::from(to)).ok()
            })
            .flatten();
        a.shared = shared;
        b.shared = shared;
        ([a, b], shared)
    }

    /// TM-30's mean fidelity.
    pub(super) fn rf(&self) -> Result<f64, String> {
        let rf = self.figures.fidelity.as_ref().map(|found| found.rf);
        let rf = self.known(rf, |light, why| has_no(light, "Rf", why))?;
        self.white().map(|()| rf)
    }

    /// The mean of CRI.
    pub(super) fn ra(&self) -> Result<f64, String> {
        self.rendered("Ra", |found| found.ra)
    }

    /// The strong red of CRI.
    pub(super) fn r9(&self) -> Result<f64, String> {
        self.rendered("R9", |found| found.samples[8].index)
    }

    /// The light skin of CRI.
    pub(super) fn r13(&self) -> Result<f64, String> {
        self.rendered("R13", |found| found.samples[12].index)
    }

    /// The similarity to the reference of its own temperature.
    pub(super) fn ssi(&self) -> Result<f64, String> {
        let own = self.figures.similarity.as_ref();
        let own = own.and_then(|found| found.of_cct.as_ref());
        let ssi = own.map(|(_, value)| *value);
        let ssi = self.known(ssi, |light, why| has_no(light, "SSI", why))?;
        self.white().map(|()| ssi)
    }

    /// The melanopic ratio to daylight.
    pub(super) fn melanopic(&self) -> Result<f64, String> {
        let found = self.figures.alpha_opic.as_ref();
        self.known(found.map(|found| found.melanopic_der()), |light, why| {
            tr!("{light} has no melanopic DER ({why})", light, why)
        })
    }

    /// The ratio of scotopic to photopic light.
    pub(super) fn sp_ratio(&self) -> Result<f64, String> {
        let found = self.figures.single(&SP_RATIO);
        self.known(found.as_ref().copied(), |light, why| {
            tr!("{light} has no S/P ratio ({why})", light, why)
        })
    }

    /// Luminous efficacy of the radiation in the range of both lights, lm/W.
    pub(super) fn efficacy(&self) -> Result<f64, String> {
        let found = luminous_efficacy(&self.in_range());
        self.known(found.as_ref().copied(), |light, why| {
            tr!("{light} has no luminous efficacy ({why})", light, why)
        })
    }

    /// Photons of 400-700 nm of the radiation in the range of both lights, µmol/J.
    pub(super) fn photon_efficacy(&self) -> Result<f64, String> {
        let light = self.in_range();
        let found = photons_per_100_lx(&light)
            .and_then(|photons| Ok(photons.ppfd / 100.0 * luminous_efficacy(&light)?));
        self.known(found.as_ref().copied(), |light, why| {
            tr!("{light} has no number of photons ({why})", light, why)
        })
    }

    fn in_range(&self) -> Light {
        match self.shared {
            Some(band) => self.light.within(band),
            None => self.light.clone(),
        }
    }

    /// A figure of CRI, where the standard vouches for it.
    fn rendered(&self, figure: &str, of: impl Fn(&Rendering) -> f64) -> Result<f64, String> {
        let rendering = self.figures.rendering.as_ref();
        let found = self.known(rendering, |light, why| has_no(light, figure, why))?;
        self.white()?;
        if found.is_too_far() {
            return Err(tr!(
                "No {figure}: too far from white. CIE 13.3 does not hold for {light}, whose \
                 colour is {distance} from its reference in CIE 1960 uv",
                figure,
                light = self.name,
                distance = fixed(found.distance, 4)
            ));
        }
        Ok(of(found))
    }

    /// Refuses coloured lights, which no white reference is like.
    fn white(&self) -> Result<(), String> {
        match &self.figures.cct {
            Ok(cct) if whiteness(*cct) == Whiteness::Coloured => {
                Err(tr!("{light} is a coloured light", light = self.name))
            }
            _ => Ok(()),
        }
    }

    /// A value, or a sentence why the light has none.
    fn known<T>(
        &self,
        value: Result<T, &NoFigure>,
        none: impl FnOnce(&str, &NoFigure) -> String,
    ) -> Result<T, String> {
        value.map_err(|why| none(&self.name, why))
    }
}

/// A light without a figure that is a symbol.
fn has_no(light: &str, figure: &str, why: &NoFigure) -> String {
    tr!("{light} has no {figure} ({why})", light, figure, why)
}
