//! A colour and the spectra that have it: what the page "From a colour" shows.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::recovered::{Asked, OBSERVER, line_light};
use crate::{
    app::{
        document::Document,
        entry::Entry,
        make::{entry_of, table_of},
        recipe::{Given, Recipe},
    },
    color::{
        Adaptation, Lab, Srgb, Swatch, Xyz, delta_e_of_xyz, lab_from_xyz, xyz_from_reflectance,
    },
    design::recover::{
        LineLight, MetamerBand, Method, NODES, Recovered, Told, Viewing, metamers, node_nm, told,
    },
    spectrum::Sampled,
};

/// Lights that a recovered surface is looked at under, by their keys.
pub const UNDER: [&str; 6] = [
    "cie_illuminants/CIE D65",
    "cie_illuminants/CIE A",
    "cie_fluorescent_1nm/FL2",
    "cie_fluorescent_1nm/FL11",
    "cie_led_1nm/LED-B3",
    "cie_led_1nm/LED-RGB1",
];

/// Lines of mercury, where none are told.
pub const MERCURY_NM: [f64; 4] = [405.0, 436.0, 546.0, 578.0];

/// Where the band's width is told: the ends are hardly seen, nm.
const TOLD_NM: std::ops::RangeInclusive<f64> = 420.0..=680.0;

/// What the page asks about; not part of undo.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FromColour {
    /// The colour.
    pub given: Given,
    /// Key of the light that it is seen under.
    pub light: String,
    /// What is taken to the library.
    pub method: Method,
    /// Places of the lines of a light of lines, nm.
    pub lines: Vec<f64>,
    /// Key of the lamp whose smooth part stands behind them.
    pub lamp: String,
}

impl Default for FromColour {
    fn default() -> Self {
        Self {
            given: Given::Srgb([0xc0, 0x80, 0x40]),
            light: UNDER[0].to_owned(),
            method: Method::Smoothest,
            lines: MERCURY_NM.to_vec(),
            lamp: UNDER[2].to_owned(),
        }
    }
}

impl FromColour {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(mut self) -> Self {
        if let Given::Lab(lab) = &mut self.given {
            let within = |v: f64, [low, high]: [f64; 2]| v.max(low).min(high);
            let ends = [[0.0, 100.0], [-200.0, 200.0], [-200.0, 200.0]];
            *lab = std::array::from_fn(|k| within(lab[k], ends[k]));
        }
        self.lines.retain(|nm| nm.is_finite());
        self.lines.truncate(12);
        if self.method == Method::Fourier6 {
            self.method = Method::Fourier3;
        }
        self
    }

    /// The spectrum of the method chosen as a spectrum of the library.
    pub fn recipe(&self) -> Recipe {
        let lines = self.method == Method::Lines;
        Recipe::Colour {
            given: self.given.clone(),
            light: if lines { &self.lamp } else { &self.light }.clone(),
            method: self.method,
            lines: if lines {
                self.lines.clone()
            } else {
                Vec::new()
            },
        }
    }
}

/// What a surface looks like under a light: as the two methods have it, and as it is.
#[derive(Clone, Debug)]
pub struct Under {
    /// The light's name.
    pub light: String,
    /// The smoothest reflectance.
    pub smoothest: Swatch,
    /// Three Fourier coefficients.
    pub fourier: Option<Swatch>,
    /// The surface itself, where it is known.
    pub real: Option<Swatch>,
    /// CIEDE2000 of the smoothest reflectance: from the surface itself where it is known, else
    /// from the other method's.
    pub differs: Option<f64>,
}

/// A colour with all that has it.
#[derive(Clone, Debug)]
pub struct ColourSheet {
    /// The colour as a screen shows it, adapted to the light.
    pub swatch: Swatch,
    /// The colour against the light.
    pub lab: Lab,
    /// The light's name.
    pub light: String,
    /// The surface that it started from.
    pub surface: Option<Arc<Entry>>,
    /// The smoothest reflectance.
    pub smoothest: Recovered,
    /// Three Fourier coefficients, or why there are none.
    pub fourier: Result<Recovered, String>,
    /// A light of lines, or why there is none.
    pub lines: Result<LineLight, String>,
    /// Least and greatest reflectance of all surfaces of the colour.
    pub band: Option<MetamerBand>,
    /// Under other lights.
    pub under: Vec<Under>,
    /// How well the colour tells the surface that it started from.
    pub told: Option<Told>,
}

impl ColourSheet {
    /// Of a document.
    ///
    /// # Errors
    /// Why there is nothing to show, a sentence.
    pub fn of(from: &FromColour, document: &Document) -> Result<Self, String> {
        let missing = |key: &str| format!("The library has no {key} any more: choose another.");
        let light = table_of(document, &from.light).ok_or_else(|| missing(&from.light))?;
        let name = from.light.rsplit('/').next().unwrap_or_default().to_owned();
        let surface = match &from.given {
            Given::Of(key) => Some(entry_of(document, key).ok_or_else(|| missing(key))?),
            _ => None,
        };
        let measured = surface.as_ref().map(|entry| &entry.spectrum.samples);
        let refused =
            |why: crate::design::recover::RecoverError| format!("Not under {name}: {why}.");
        let asked = Asked::new(&from.given, &light, measured).map_err(refused)?;
        let seen = [asked.seen()];
        let smoothest = Recovered::new(Method::Smoothest, &seen).map_err(refused)?;
        let fourier = Recovered::new(Method::Fourier3, &seen).map_err(|why| why.to_string());
        let lines = match table_of(document, &from.lamp) {
            Some(lamp) => {
                line_light(&from.given, &from.lines, &lamp, measured).map_err(|why| why.to_string())
            }
            None => Err(missing(&from.lamp)),
        };
        let lights: Vec<(String, Sampled, Viewing)> = UNDER
            .iter()
            .filter_map(|key| {
                let table = table_of(document, key)?;
                let viewing = Viewing::to_look(&table, OBSERVER).ok()?;
                Some((key.rsplit('/').next()?.to_owned(), table, viewing))
            })
            .collect();
        let told = measured.map(|measured| {
            let pairs: Vec<_> = lights.iter().map(|(_, t, v)| (t, v)).collect();
            told(&smoothest, measured, &pairs)
        });
        let white = asked.viewing.white();
        let under = lights
            .iter()
            .map(|(name, table, viewing)| {
                under(
                    name,
                    (table, viewing),
                    &smoothest,
                    fourier.as_ref().ok(),
                    measured,
                )
            })
            .collect();
        Ok(Self {
            swatch: Swatch::of_patch(asked.xyz, white, Adaptation::ToLight),
            lab: lab_from_xyz(asked.xyz, white),
            light: name,
            band: metamers(&seen),
            surface,
            smoothest,
            fourier,
            lines,
            under,
            told,
        })
    }

    /// The result in a sentence.
    pub fn sentence(&self) -> String {
        let light = &self.light;
        if let Some(nearest) = &self.smoothest.nearest {
            let off = nearest.delta_e.iter().copied().fold(0.0, f64::max);
            return format!(
                "No surface has this colour under {light}: the nearest that one can have is \
                 {off:.1} \u{394}E00 off, and is what is drawn."
            );
        }
        let first = match (&self.surface, &self.told) {
            (Some(entry), Some(told)) => {
                let looks = self.under.iter().zip(&told.delta_e);
                let worst = looks
                    .filter_map(|(under, off)| Some((&under.light, (*off)?)))
                    .max_by(|a, b| a.1.total_cmp(&b.1));
                let worst = worst.map_or_else(String::new, |(light, off)| {
                    format!(", and under {light} it looks {off:.1} \u{394}E00 off")
                });
                format!(
                    "From its colour under {light}, {} comes out {:.3} off (rms){worst}.",
                    entry.name(),
                    told.rms
                )
            }
            _ => {
                let [low, high] = self.smoothest.reflectance.extent().map(|v| 100.0 * v);
                format!(
                    "The smoothest surface of {} reflects {low:.0} to {high:.0} %.",
                    self.swatch.hex()
                )
            }
        };
        let spread = self.spread().map_or_else(String::new, |spread| {
            let per_cent = 100.0 * spread;
            format!(
                " Surfaces that look just the same under {light} can be {per_cent:.0} % of \
                 reflectance apart, on average over the wavelengths."
            )
        });
        format!("{first}{spread}")
    }

    /// Mean distance of the least and the greatest reflectance.
    fn spread(&self) -> Option<f64> {
        let band = self.band.as_ref()?;
        let seen: Vec<usize> = (0..NODES)
            .filter(|node| TOLD_NM.contains(&node_nm(*node)))
            .collect();
        let sum: f64 = seen
            .iter()
            .map(|i| band.greatest[*i] - band.least[*i])
            .sum();
        Some(sum / seen.len() as f64)
    }

    /// What each way is to be trusted by: name, range of values, round trip, condition, words.
    pub fn facts(&self) -> Vec<[String; 4]> {
        let of_surface = |method: Method, found: &Recovered| {
            let [low, high] = found.reflectance.extent();
            let inside = match found.is_inside_0_1() {
                true => "",
                false => " \u{25b2} no surface is so",
            };
            let condition = found.condition_number;
            [
                method_name(method).to_owned(),
                format!("{low:.2} to {high:.2}{inside}"),
                format!("{:.2}", found.round_trip_delta_e),
                condition.map_or_else(|| "-".to_owned(), |condition| format!("{condition:.0}")),
            ]
        };
        let none = |method: Method, why: &String| {
            let dash = "-".to_owned();
            [
                method_name(method).to_owned(),
                why.clone(),
                dash.clone(),
                dash,
            ]
        };
        let fourier = match &self.fourier {
            Ok(found) => of_surface(Method::Fourier3, found),
            Err(why) => none(Method::Fourier3, why),
        };
        let lines = match &self.lines {
            Ok(found) => {
                let power: f64 = found.background.iter().sum();
                let lines: f64 = found.lines.iter().map(|line| line.weight).sum();
                let share = 100.0 * lines / (lines + power);
                let off = match &found.nearest {
                    Some(_) => " \u{25b2} only near it",
                    None => "",
                };
                [
                    method_name(Method::Lines).to_owned(),
                    format!("{share:.0} % in the lines{off}"),
                    format!("{:.2}", found.round_trip_delta_e),
                    format!("{:.0}", found.condition_number),
                ]
            }
            Err(why) => none(Method::Lines, why),
        };
        vec![
            of_surface(Method::Smoothest, &self.smoothest),
            fourier,
            lines,
        ]
    }
}

/// What a method is called on the page.
pub fn method_name(method: Method) -> &'static str {
    match method {
        Method::Smoothest => "Smoothest surface",
        Method::Fourier3 => "Three coefficients (Eq. 18)",
        Method::Fourier6 => "Six coefficients",
        Method::Lines => "Light of lines",
    }
}

fn under(
    name: &str,
    (table, viewing): (&Sampled, &Viewing),
    smoothest: &Recovered,
    fourier: Option<&Recovered>,
    measured: Option<&Sampled>,
) -> Under {
    let white = viewing.white();
    let swatch = |xyz: Xyz| Swatch::of_patch(xyz, white, Adaptation::ToLight);
    let xyz = smoothest.reflectance.xyz(viewing);
    let fourier = fourier.map(|found| found.reflectance.xyz(viewing));
    let real = measured.and_then(|surface| xyz_from_reflectance(surface, table, OBSERVER));
    let other = real.or(fourier);
    Under {
        light: name.to_owned(),
        smoothest: swatch(xyz),
        fourier: fourier.map(swatch),
        real: real.map(swatch),
        differs: other.and_then(|other| delta_e_of_xyz(other, xyz, white)),
    }
}

/// A colour of a hexadecimal word, with or without its sign.
pub fn of_hex(text: &str) -> Option<[u8; 3]> {
    let text = text.trim();
    let word = format!("#{}", text.strip_prefix('#').unwrap_or(text));
    word.parse::<Srgb>().ok().map(|Srgb(rgb)| rgb)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{App, Command, command::MadeFor},
        spectrum::Kind,
    };

    fn sheet(from: &FromColour) -> ColourSheet {
        ColourSheet::of(from, App::new().document()).expect("a colour under a light")
    }

    #[test]
    fn the_smoothest_surface_has_its_colour_and_lies_in_the_band() {
        let found = sheet(&FromColour::default());
        assert!(found.smoothest.round_trip_delta_e < 0.01);
        assert!(found.smoothest.is_inside_0_1());
        let band = found.band.as_ref().expect("a surface can have it");
        let values = found.smoothest.reflectance.sampled();
        for (node, value) in values.values().iter().enumerate() {
            let within = band.least[node] - 1e-6..=band.greatest[node] + 1e-6;
            assert!(within.contains(value), "{node}");
        }
        assert_eq!(found.swatch.hex(), "#c08040");
        assert_eq!((found.under.len(), found.facts().len()), (UNDER.len(), 3));
        assert!(found.sentence().contains("#c08040"), "{}", found.sentence());
    }

    #[test]
    fn a_colour_that_no_surface_has_says_how_far_the_nearest_is() {
        let found = sheet(&FromColour {
            given: Given::Lab([50.0, 150.0, -150.0]),
            ..FromColour::default()
        });
        assert!(found.sentence().starts_with("No surface has this colour"));
        assert!(found.band.is_none());
    }

    #[test]
    fn a_surface_of_the_library_is_told_by_its_colour_as_well_as_it_says() {
        let found = sheet(&FromColour {
            given: Given::Of("colorchecker_ohta/red".to_owned()),
            ..FromColour::default()
        });
        let told = found.told.as_ref().expect("a surface to compare with");
        assert!(told.rms > 0.0 && told.rms < 0.3, "{}", told.rms);
        assert!(
            found.sentence().contains("red comes out"),
            "{}",
            found.sentence()
        );
        // Under the light that it was told by it looks the same.
        assert!(found.under[0].differs.expect("seen") < 0.05);
        assert!(found.under.iter().all(|under| under.real.is_some()));
    }

    #[test]
    fn what_is_made_of_a_colour_joins_the_library_as_what_it_is() {
        let mut app = App::new();
        for (method, kind) in [
            (Method::Smoothest, Kind::Reflectance),
            (Method::Fourier3, Kind::Reflectance),
            (Method::Lines, Kind::Light),
        ] {
            let from = FromColour {
                method,
                ..FromColour::default()
            };
            let (recipe, place) = (from.recipe(), MadeFor::Shown);
            app.apply(Command::Make { recipe, place });
            let made = app.document().own.last().expect("it joined");
            assert_eq!(made.kind(), kind);
        }
    }

    #[test]
    fn a_light_that_is_gone_says_so_and_nonsense_becomes_allowed() {
        let gone = FromColour {
            light: "own/77".to_owned(),
            ..FromColour::default()
        };
        let why = ColourSheet::of(&gone, App::new().document()).expect_err("no light");
        assert!(why.contains("own/77"));
        let nonsense = FromColour {
            given: Given::Lab([f64::NAN, 1e9, 0.0]),
            method: Method::Fourier6,
            ..FromColour::default()
        };
        let sound = nonsense.clamped();
        assert_eq!(sound.given, Given::Lab([0.0, 200.0, 0.0]));
        assert_eq!(sound.method, Method::Fourier3);
        assert_eq!(of_hex(" C08040"), Some([0xc0, 0x80, 0x40]));
        assert_eq!(of_hex("orange"), None);
    }
}
