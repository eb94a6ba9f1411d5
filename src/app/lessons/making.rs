//! Spectra that a lesson makes: a mixture of a light's colour, a surface recovered from its
//! colours, a metamer.

use serde::Deserialize;

use super::names::entry;
use crate::{
    app::{App, Command, Entry, command::MadeFor, library::Library, recipe::Recipe},
    color::{
        Observer,
        xyz::{FIRST_NM, xyz_from_reflectance},
    },
    design::{
        SampleTables,
        mixture::{Channel, Source, Spec, mixed},
        recover::{Method, Recovered, Seen, Viewing},
        solve::{Mixer, Objective, Problem, Target},
    },
    spectrum::{Kind, NamedSpectrum, Sampled},
};

/// A spectrum and how it is made.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Making {
    /// Channels mixed to the colour of a light.
    Mix {
        /// What it is called.
        name: String,
        /// Channels as the command line has them: `line:450`, `gauss:540,30`.
        channels: Vec<String>,
        /// The light whose colour it has.
        like: String,
        /// What is to be large among the mixtures of that colour: ler, rf, ra, melanopic, fewest.
        #[serde(default)]
        favour: Option<String>,
    },
    /// The smoothest surface that has a surface's colours under one light or two.
    Recovered {
        /// What it is called.
        name: String,
        /// The surface whose colours are taken.
        surface: String,
        /// One light, or two.
        under: Vec<String>,
    },
    /// A surface of the same colour under one light and another under a second.
    Metamer {
        /// What it is called.
        name: String,
        /// The surface, `group/name`.
        surface: String,
        /// Where both are alike.
        light: String,
        /// Where they part.
        other: String,
    },
}

impl Making {
    /// What it is called.
    pub fn name(&self) -> &str {
        match self {
            Self::Mix { name, .. } | Self::Recovered { name, .. } | Self::Metamer { name, .. } => {
                name
            }
        }
    }

    /// Makes it one of the person's own spectra and gives its key.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn make(&self, app: &mut App) -> Result<String, String> {
        match self {
            Self::Mix {
                name,
                channels,
                like,
                favour,
            } => {
                let light = entry(app, like)?;
                let spectrum = mixture(name, channels, &light, favour.as_deref())?;
                app.apply(Command::Adopt(vec![spectrum]));
            }
            Self::Recovered {
                name,
                surface,
                under,
            } => {
                let surface = entry(app, surface)?;
                let lights = under.iter().map(|light| entry(app, light));
                let lights = lights.collect::<Result<Vec<_>, _>>()?;
                let spectrum = recovered(name, &surface, &lights)?;
                app.apply(Command::Adopt(vec![spectrum]));
            }
            Self::Metamer {
                name,
                surface,
                light,
                other,
            } => metamer(app, name, surface, [light, other])?,
        }
        let own = app.document().own.last();
        own.map(|own| own.key.clone())
            .ok_or_else(|| format!("found nothing made, expected {}", self.name()))
    }
}

fn mixture(
    name: &str,
    words: &[String],
    like: &Entry,
    favour: Option<&str>,
) -> Result<NamedSpectrum, String> {
    let channel = |words: &String| {
        let spec: Spec = words.parse().map_err(found)?;
        match spec.source {
            Source::Named(name) => Err(format!(
                "found the channel {name}, expected line:, gauss: or the like"
            )),
            _ => Channel::new(spec, None).map_err(found),
        }
    };
    let channels = words.iter().map(channel).collect::<Result<Vec<_>, _>>()?;
    let favour = favour.map(|word| {
        let known = Objective::ALL.into_iter().find(|one| one.word() == word);
        let all = || Objective::ALL.map(Objective::word).join(", ");
        known.ok_or_else(|| format!("found favour {word}, expected one of {}", all()))
    });
    let favour = favour.transpose()?.unwrap_or_default();
    let wish = Problem {
        target: Some(Target::of_light(&like.spectrum.samples).map_err(found)?),
        objective: favour,
        ..Problem::default()
    };
    let mixer = Mixer::new(&channels, SampleTables::shipped()).map_err(found)?;
    let solution = mixer.solve(&wish);
    if !solution.reached {
        return Err(format!("found no mixture of that colour: {}", solution.why));
    }
    let values = mixed(&channels, &solution.weights);
    let samples = Sampled::even(f64::from(FIRST_NM), 1.0, values).map_err(|why| why.to_string())?;
    let note = format!(
        "Mixed to the colour of {} of {}.",
        like.name(),
        words.join(", ")
    );
    Ok(named(name, Kind::Light, "relative", samples, note))
}

fn found(why: impl std::fmt::Display) -> String {
    format!("found what cannot be mixed: {why}")
}

fn recovered(
    name: &str,
    surface: &Entry,
    lights: &[std::sync::Arc<Entry>],
) -> Result<NamedSpectrum, String> {
    const OBSERVER: Observer = Observer::CIE_1931;
    let words = |why: &dyn std::fmt::Display| format!("found what cannot be recovered: {why}");
    let mut views = Vec::new();
    for light in lights {
        let samples = &light.spectrum.samples;
        let viewing = Viewing::new(samples, OBSERVER).map_err(|why| words(&why))?;
        let xyz = xyz_from_reflectance(&surface.spectrum.samples, samples, OBSERVER)
            .ok_or_else(|| words(&"the light is dark"))?;
        views.push((viewing, xyz));
    }
    let seen: Vec<Seen> = views
        .iter()
        .map(|(under, xyz)| Seen { under, xyz: *xyz })
        .collect();
    let recovered = Recovered::new(Method::Smoothest, &seen).map_err(|why| words(&why))?;
    let names: Vec<&str> = lights.iter().map(|light| light.name()).collect();
    let note = format!(
        "The smoothest surface with the colour of {} under {}.",
        surface.name(),
        names.join(" and ")
    );
    let samples = recovered.reflectance.sampled();
    Ok(named(name, Kind::Reflectance, "fraction", samples, note))
}

fn metamer(app: &mut App, name: &str, surface: &str, lights: [&String; 2]) -> Result<(), String> {
    let patch = Library::bundled()
        .find(surface)
        .map_err(|why| format!("found {why}"))?;
    let group = Library::bundled().group(&patch.group);
    let items = group.map(|group| &group.items[..]).unwrap_or_default();
    let mut surfaces = items
        .iter()
        .filter(|p| p.kind.is_factor() && p.spectrum().is_some());
    let index = surfaces.position(|p| p.name == patch.name);
    let index = index.ok_or_else(|| format!("found {surface}, expected a surface of a set"))?;
    let [light, other] = lights.map(|light| entry(app, light));
    let recipe = Recipe::Metamer {
        light: light?.key.clone(),
        other: other?.key.clone(),
        patch_set: patch.group.clone(),
        patch: index,
        room_percent: 100,
    };
    let before = app.document().own.len();
    app.apply(Command::Make {
        recipe,
        place: MadeFor::Shown,
    });
    match app.document().own.last() {
        Some(own) if app.document().own.len() > before => {
            let key = own.key.clone();
            app.apply(Command::Rename {
                key,
                name: name.to_owned(),
            });
            Ok(())
        }
        _ => Err(format!(
            "found no metamer of {surface} between these lights, expected one"
        )),
    }
}

fn named(name: &str, kind: Kind, unit: &str, samples: Sampled, note: String) -> NamedSpectrum {
    NamedSpectrum {
        name: name.to_owned(),
        kind,
        unit: unit.to_owned(),
        scale: 1.0,
        samples,
        notes: vec![note],
        source: "made by a lesson".to_owned(),
    }
}
