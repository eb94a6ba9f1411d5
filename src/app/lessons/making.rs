//! Spectra that a lesson makes: a mixture of a light's colour, a surface recovered from its
//! colours, a metamer, a lamp without a label, a light as an instrument or a camera records it.

use std::sync::Arc;

use serde::Deserialize;

use super::names::{entry, light};
use crate::{
    app::{
        App, Command, Entry,
        combining::Act,
        command::MadeFor,
        library::Library,
        photograph::{Photograph, example},
        recipe::Recipe,
    },
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
    measurements::{Kernel, Measurement, Quantity, Slit, normal, smoothed},
    spectrum::{Band, Kind, NamedSpectrum, Outside, Sampled},
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
    /// Lights added with equal power, under a name that does not tell which they are.
    Sum {
        /// What it is called.
        name: String,
        /// The lights, 1 to 8.
        lights: Vec<String>,
    },
    /// A light as an instrument records it.
    Recorded {
        /// What it is called.
        name: String,
        light: String,
        /// Full width at half maximum of the triangular slit, nm, 0.5 to 50.
        slit_nm: f64,
        /// Standard deviation of white noise, per cent of the largest value, 0 to 50.
        #[serde(default)]
        noise_percent: f64,
        /// Width over which the instrument smooths its noisy readings, nm, 0 to 50.
        #[serde(default)]
        smoothed_nm: f64,
        /// Which scan it is: noise is new in each.
        #[serde(default = "first")]
        scan: u32,
    },
    /// The mean of scans of one light, with its uncertainty.
    Mean {
        /// What it is called.
        name: String,
        /// The scans, 3 to 20.
        scans: Vec<String>,
    },
    /// The light of the photograph on its page; without one that has wavelengths that of the example.
    Photographed {
        /// What it is called.
        name: String,
    },
}

fn first() -> u32 {
    1
}

impl Making {
    /// What it is called.
    pub fn name(&self) -> &str {
        match self {
            Self::Mix { name, .. }
            | Self::Recovered { name, .. }
            | Self::Metamer { name, .. }
            | Self::Sum { name, .. }
            | Self::Recorded { name, .. }
            | Self::Mean { name, .. }
            | Self::Photographed { name } => name,
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
                light: here,
                other,
            } => metamer(app, name, surface, [here, other])?,
            Self::Sum { name, lights } => {
                let lights = lights.iter().map(|name| light(app, name));
                let spectrum = sum(name, &lights.collect::<Result<Vec<_>, _>>()?)?;
                app.apply(Command::Adopt(vec![spectrum]));
            }
            Self::Recorded {
                name,
                light: of,
                slit_nm,
                noise_percent,
                smoothed_nm,
                scan,
            } => {
                let by = Recording {
                    slit_nm: *slit_nm,
                    noise_percent: *noise_percent,
                    smoothed_nm: *smoothed_nm,
                    scan: *scan,
                };
                let spectrum = by.of(name, &*light(app, of)?)?;
                app.apply(Command::Adopt(vec![spectrum]));
            }
            Self::Mean { name, scans } => mean(app, name, scans)?,
            Self::Photographed { name } => {
                let drawn = example().as_ref().as_ref().ok();
                let drawn = drawn.and_then(|drawn| drawn.found.as_ref().ok());
                let shown = [app.photograph(), drawn].into_iter().flatten();
                let spectrum = shown.filter_map(Photograph::spectrum).next();
                let spectrum =
                    spectrum.ok_or("found no photograph with wavelengths, expected one")?;
                let name = name.clone();
                app.apply(Command::Adopt(vec![NamedSpectrum { name, ..spectrum }]));
            }
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

fn recovered(name: &str, surface: &Entry, lights: &[Arc<Entry>]) -> Result<NamedSpectrum, String> {
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
    match by_recipe(app, name, recipe) {
        true => Ok(()),
        false => Err(format!(
            "found no metamer of {surface} between these lights, expected one"
        )),
    }
}

fn mean(app: &mut App, name: &str, scans: &[String]) -> Result<(), String> {
    const COUNT: std::ops::RangeInclusive<usize> = 3..=20;
    if !COUNT.contains(&scans.len()) {
        let count = scans.len();
        return Err(format!("found a mean of {count} scans, expected 3 to 20"));
    }
    let parts = scans.iter().map(|scan| Ok(light(app, scan)?.key.clone()));
    let recipe = Recipe::Combined {
        act: Act::Mean { keep_all: false },
        parts: parts.collect::<Result<_, String>>()?,
    };
    match by_recipe(app, name, recipe) {
        true => Ok(()),
        false => Err(format!(
            "found no mean of {}, expected scans of one light",
            scans.join(", ")
        )),
    }
}

/// Makes a spectrum under a name; false where the recipe makes none.
fn by_recipe(app: &mut App, name: &str, recipe: Recipe) -> bool {
    let before = app.document().own.len();
    app.apply(Command::Make {
        recipe,
        place: MadeFor::Shown,
    });
    if app.document().own.len() == before {
        return false;
    }
    let made = app.document().own.last().map(|own| own.key.clone());
    if let Some(key) = made {
        let name = name.to_owned();
        app.apply(Command::Rename { key, name });
    }
    true
}

fn sum(name: &str, lights: &[Arc<Entry>]) -> Result<NamedSpectrum, String> {
    const LAST_NM: f64 = 830.0;
    const MOST: usize = 8;
    if !(1..=MOST).contains(&lights.len()) {
        let count = lights.len();
        return Err(format!(
            "found a sum of {count} lights, expected 1 to {MOST}"
        ));
    }
    let first_nm = f64::from(FIRST_NM);
    let band = Band::new(first_nm, LAST_NM).map_err(|why| why.to_string())?;
    let mut values = vec![0.0; (LAST_NM - first_nm) as usize + 1];
    for light in lights {
        let samples = &light.spectrum.samples;
        let power = samples.integrate(band, Outside::Zero, |_| 1.0);
        if power <= 0.0 {
            return Err(format!(
                "found {} without power, expected a light",
                light.name()
            ));
        }
        for (index, value) in values.iter_mut().enumerate() {
            *value += samples.at(first_nm + index as f64, Outside::Zero) / power;
        }
    }
    let samples = Sampled::even(first_nm, 1.0, values).map_err(|why| why.to_string())?;
    Ok(named(
        name,
        Kind::Light,
        "relative",
        samples,
        "A lamp without a label.".to_owned(),
    ))
}

/// An instrument's way from a light to its numbers.
struct Recording {
    slit_nm: f64,
    noise_percent: f64,
    smoothed_nm: f64,
    scan: u32,
}

impl Recording {
    fn of(&self, name: &str, light: &Entry) -> Result<NamedSpectrum, String> {
        let (slit_nm, noise_percent) = (self.slit_nm, self.noise_percent);
        for (what, value, [least, most]) in [
            ("slit_nm", slit_nm, [0.5, 50.0]),
            ("noise_percent", noise_percent, [0.0, 50.0]),
            ("smoothed_nm", self.smoothed_nm, [0.0, 50.0]),
        ] {
            if !(least..=most).contains(&value) {
                return Err(format!("found {what} {value}, expected {least} to {most}"));
            }
        }
        let through = |samples: Sampled, fwhm_nm: f64| {
            let measured = Measurement::new(light.name(), Quantity::Light, "", samples);
            let shape = Kernel::Triangle;
            let seen = smoothed(&measured, Slit { shape, fwhm_nm });
            seen.map(|seen| seen.samples).map_err(|why| why.to_string())
        };
        let mut samples = through(light.spectrum.samples.clone(), slit_nm)?;
        let largest = samples.values().iter().copied().fold(0.0, f64::max);
        let sigma = largest * noise_percent / 100.0;
        // The same every time: every class sees the same noise.
        let noise = normal(u64::from(self.scan));
        let noisy = samples.values().iter().zip(noise);
        let values = noisy.map(|(value, noise)| value + sigma * noise).collect();
        samples = Sampled::new(samples.nm().to_vec(), values).map_err(|why| why.to_string())?;
        let mut note = format!(
            "{} behind a slit of {slit_nm} nm, with noise of {noise_percent} % of its largest value.",
            light.name()
        );
        if self.smoothed_nm > 0.0 {
            samples = through(samples, self.smoothed_nm)?;
            note.push_str(&format!(" Smoothed over {} nm.", self.smoothed_nm));
        }
        Ok(named(name, Kind::Light, "relative", samples, note))
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
