//! From a colour to a spectrum that has it.

use crate::{
    app::recipe::Given,
    color::{Lab, Observer, Srgb, Xyz, xyz_from_reflectance},
    design::recover::{
        BAND, Colour, LineLight, LitColour, Method, RecoverError, Recovered, Seen, Viewing,
    },
    spectrum::{Kind, NamedSpectrum, Outside, Sampled, SpikeSettings, spikes::detect},
};

/// The observer that colours are meant for.
pub const OBSERVER: Observer = Observer::Cie1931;

/// A colour under a light.
#[derive(Clone, Debug)]
pub struct Asked {
    /// The light.
    pub viewing: Viewing,
    /// The colour, Y = 100 for the light.
    pub xyz: Xyz,
}

impl Asked {
    /// A given colour under a light; `surface` is what it is of, where it is of one.
    ///
    /// # Errors
    /// [`RecoverError`] for a light that shows no colours and for what is no colour.
    pub fn new(
        given: &Given,
        light: &Sampled,
        surface: Option<&Sampled>,
    ) -> Result<Self, RecoverError> {
        let viewing = Viewing::new(light, OBSERVER)?;
        let xyz = match given {
            Given::Srgb(rgb) => Colour::Srgb(Srgb(*rgb)).under(&viewing)?,
            Given::Lab([l, a, b]) => Colour::Lab(Lab::new(*l, *a, *b)).under(&viewing)?,
            Given::Of(_) => surface
                .and_then(|surface| xyz_from_reflectance(surface, light, OBSERVER))
                .ok_or(RecoverError::NotAColour)?,
        };
        Ok(Self { viewing, xyz })
    }

    /// As methods take it.
    pub fn seen(&self) -> Seen<'_> {
        Seen {
            under: &self.viewing,
            xyz: self.xyz,
        }
    }
}

/// A light of lines over the smooth part of a lamp, of a given colour; a light's own colour is
/// against no other white than the equal-energy one.
///
/// # Errors
/// [`RecoverError`] for lines, lamps and colours that do not do.
pub fn line_light(
    given: &Given,
    lines: &[f64],
    lamp: &Sampled,
    surface: Option<&Sampled>,
) -> Result<LineLight, RecoverError> {
    let equal = Sampled::even(360.0, 1.0, vec![1.0; 471]).map_err(|_| RecoverError::NoLight)?;
    let asked = LitColour {
        surface: None,
        xyz: Asked::new(given, &equal, surface)?.xyz,
    };
    let values = lamp.on_band(BAND, Outside::Zero);
    let smooth = detect(BAND, &values, SpikeSettings::default()).smooth;
    // What is left of a line below zero is no light.
    let smooth = smooth.into_iter().map(|value| value.max(0.0)).collect();
    let background =
        Sampled::even(BAND.min_nm(), 1.0, smooth).map_err(|_| RecoverError::NoBackground)?;
    LineLight::new(lines, &background, &[asked], OBSERVER)
}

/// A spectrum of a given colour by a method: a reflectance under `light`, or a light of lines over
/// the smooth part of `light`. `words` say what the colour and the light are.
///
/// # Errors
/// [`RecoverError`] for what cannot be.
pub fn spectrum(
    method: Method,
    (given, lines): (&Given, &[f64]),
    light: &Sampled,
    surface: Option<&Sampled>,
    [colour, lamp]: [&str; 2],
) -> Result<NamedSpectrum, RecoverError> {
    let title = method.title();
    let (kind, unit, samples, name) = match method {
        Method::Lines => {
            let found = line_light(given, lines, light, surface)?;
            let samples = Sampled::even(BAND.min_nm(), 1.0, found.on_band())
                .map_err(|_| RecoverError::NotAColour)?;
            (
                Kind::Light,
                "relative",
                samples,
                format!("Light of lines, {colour}"),
            )
        }
        _ => {
            let asked = Asked::new(given, light, surface)?;
            let found = Recovered::new(method, &[asked.seen()])?;
            let name = format!("Surface from {colour} under {lamp}");
            (
                Kind::Reflectance,
                "fraction",
                found.reflectance.sampled(),
                name,
            )
        }
    };
    Ok(NamedSpectrum {
        name,
        kind,
        unit: unit.to_owned(),
        scale: 1.0,
        samples,
        notes: vec![format!(
            "Made from the colour {colour} and {lamp}: {title}."
        )],
        source: format!("made from a colour and {lamp}"),
    })
}
