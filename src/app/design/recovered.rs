//! From a colour to a spectrum that has it.

use crate::{
    app::recipe::Given,
    color::{Lab, Observer, Srgb, Xyz, xyz_from_reflectance},
    design::recover::{
        BAND, Colour, LineLight, LitColour, Method, RecoverError, Recovered, Seen, Viewing,
    },
    languages::{Language, in_language},
    spectrum::{Kind, NamedSpectrum, Outside, Sampled, SpikeSettings, detect},
};

/// The observer that colours are meant for.
pub(crate) const OBSERVER: Observer = Observer::CIE_1931;

/// A colour under a light.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
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
    pub(crate) fn new(
        given: &Given,
        light: &Sampled,
        surface: Option<&Sampled>,
    ) -> Result<Self, RecoverError> {
        let viewing = Viewing::new(light, OBSERVER)?;
        let xyz = match given {
            Given::Srgb(rgb) => Colour::Srgb(Srgb(*rgb)).under(&viewing)?,
            Given::Xyz(xyz) => Colour::Xyz(Xyz::from_array(*xyz)).under(&viewing)?,
            Given::Lab([l, a, b]) => Colour::Lab(Lab::new(*l, *a, *b)).under(&viewing)?,
            Given::Xyy(xyy) => Colour::Xyy(*xyy).under(&viewing)?,
            Given::Of(_) => surface
                .and_then(|surface| xyz_from_reflectance(surface, light, OBSERVER))
                .ok_or(RecoverError::NotAColour)?,
        };
        Ok(Self { viewing, xyz })
    }

    /// As methods take it.
    pub(crate) fn seen(&self) -> Seen<'_> {
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
pub(crate) fn line_light(
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

/// A given colour under a light, with the words for both.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// The colour.
    pub given: Given,
    /// The colour in words, or the name of the surface that it is of.
    pub colour: String,
    /// The light's name.
    pub lamp: String,
    pub light: Sampled,
    /// The surface that it is of, where it is of one.
    pub surface: Option<Sampled>,
}

/// A spectrum by a method: a reflectance that has one colour, or two under two lights; or a light
/// of lines of the first colour, over the smooth part of its light.
///
/// # Errors
/// [`RecoverError`] for what cannot be.
pub(crate) fn spectrum(
    method: Method,
    shown: &[Shown],
    lines: &[f64],
) -> Result<NamedSpectrum, RecoverError> {
    let first = shown.first().ok_or(RecoverError::NotAColour)?;
    let each = |shown: &Shown| {
        tr!(
            "{colour} under {light}",
            colour = shown.colour,
            light = shown.lamp
        )
    };
    let from = || match method {
        Method::Lines => tr!(
            "{colour} and the glow of {light}",
            colour = first.colour,
            light = first.lamp
        ),
        Method::Smoothest | Method::Fourier3 | Method::Fourier6 => shown
            .iter()
            .map(each)
            .reduce(|list, last| tr!("{list} and {last}", list, last))
            .unwrap_or_default(),
    };
    let (kind, unit, samples, name) = match method {
        Method::Lines => {
            let found = line_light(&first.given, lines, &first.light, first.surface.as_ref())?;
            let samples = Sampled::even(BAND.min_nm(), 1.0, found.on_band())
                .map_err(|_| RecoverError::NotAColour)?;
            let name = tr!("Light of lines, {colour}", colour = first.colour);
            (Kind::Light, "relative", samples, name)
        }
        Method::Smoothest | Method::Fourier3 | Method::Fourier6 => {
            let asked = shown.iter();
            let asked = asked.map(|s| Asked::new(&s.given, &s.light, s.surface.as_ref()));
            let asked = asked.collect::<Result<Vec<_>, _>>()?;
            let seen: Vec<Seen> = asked.iter().map(Asked::seen).collect();
            let samples = Recovered::new(method, &seen)?.reflectance.sampled();
            let name = tr!("Surface from {colours}", colours = from());
            (Kind::Reflectance, "fraction", samples, name)
        }
    };
    Ok(NamedSpectrum {
        name,
        kind,
        unit: unit.to_owned(),
        scale: 1.0,
        samples,
        notes: vec![tr!(
            "Made from {colours}: {method}.",
            colours = from(),
            method = method.title()
        )],
        // What tells its kind of source again, so in one language.
        source: in_language(Language::English, || format!("made from {}", from())),
    })
}
