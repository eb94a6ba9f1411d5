//! A colour and the spectra that have it: what the page "From a colour" shows.

use std::sync::{Arc, LazyLock};

use super::{
    recovered::{Asked, OBSERVER, line_light},
    telling::Telling,
};
use crate::{
    app::{
        document::Document,
        entry::Entry,
        library::Library,
        make::{entry_of, table_of},
        pages::states::in_reach,
        recipe::{Given, Recipe},
    },
    color::{Adaptation, Srgb, Swatch, Xyz, delta_e_of_xyz, xyz_from_reflectance},
    design::recover::{
        Deviation, LineLight, MetamerBand, Method, NODES, Recovered, Reflectance, Seen, Viewing,
        deviation, examples, metamers,
    },
    spectrum::Sampled,
};

pub use crate::app::pages::{FromColour, MERCURY_NM, UNDER};

/// A light to look under: its name, its table, and the same for looking.
type Light = (String, Sampled, Viewing);

/// Those lights with their names: shipped, so that they are prepared once.
static LIGHTS: LazyLock<Vec<Light>> = LazyLock::new(|| {
    let one = |key: &&str| {
        let preset = Library::bundled().find(key).ok()?;
        light(&preset.name, &preset.spectrum()?.samples)
    };
    UNDER.iter().filter_map(one).collect()
});

/// None of a light that is not seen.
fn light(name: &str, table: &Sampled) -> Option<Light> {
    let viewing = Viewing::to_look(table, OBSERVER).ok()?;
    Some((name.to_owned(), table.clone(), viewing))
}

/// The light of a document and the second one, then the usual ones, as many as those.
fn lights_to_look_under(document: &Document) -> Vec<Light> {
    let own = std::iter::once(&document.light).chain(&document.second);
    let own: Vec<Light> = own
        .filter_map(|entry| light(entry.name(), &entry.spectrum.samples))
        .collect();
    let is_new = |usual: &&Light| own.iter().all(|(name, ..)| *name != usual.0);
    let usual = LIGHTS.iter().filter(is_new).cloned().collect::<Vec<_>>();
    own.into_iter().chain(usual).take(UNDER.len()).collect()
}

impl FromColour {
    /// The same about a screen's colour, by itself.
    #[must_use]
    pub fn about(self, rgb: [u8; 3]) -> Self {
        in_reach(Self {
            given: Given::Srgb(rgb),
            second: None,
            telling: Telling::Srgb,
            ..self
        })
    }

    /// The methods that the page shows.
    pub fn methods(&self) -> [Method; 3] {
        [Method::Smoothest, self.coefficients(), Method::Lines]
    }

    /// The same with one light.
    #[must_use]
    pub fn with_one(self) -> Self {
        in_reach(Self {
            second: None,
            ..self
        })
    }

    /// The same with a second light: at first with the colour that the smoothest surface has under
    /// it, or the surface's own.
    #[must_use]
    pub fn with_second(
        self,
        sheet: Option<&ColourSheet>,
        light: &str,
        document: &Document,
    ) -> Self {
        let found = || {
            if self.given.surface().is_some() {
                return Some(self.given.clone());
            }
            let table = table_of(document, light)?;
            let viewing = Viewing::to_look(&table, OBSERVER).ok()?;
            let xyz = sheet?.smoothest.reflectance.xyz(&viewing);
            Some(Given::Xyz(xyz.to_array()))
        };
        let second = found().map(|given| (given, light.to_owned()));
        in_reach(Self { second, ..self })
    }

    /// The spectrum of the method chosen as a spectrum of the library.
    pub fn recipe(&self) -> Recipe {
        let lines = self.method == Method::Lines;
        Recipe::Colour {
            given: self.given.clone(),
            light: if lines { &self.lamp } else { &self.light }.clone(),
            method: self.method,
            lines: self.lines.iter().copied().filter(|_| lines).collect(),
            second: self.second.clone().filter(|_| !lines),
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

/// A colour under a light, as the page shows it.
#[derive(Clone, Debug)]
pub struct SeenColour {
    /// As a screen shows it, adapted to the light.
    pub swatch: Swatch,
    /// Y = 100 for the light.
    pub xyz: Xyz,
    /// Of the light, Y = 100.
    pub white: Xyz,
    /// The light's name.
    pub light: String,
}

/// A colour, or the same surface's colours under two lights, with all that has them.
#[derive(Clone, Debug)]
pub struct ColourSheet {
    /// The colour, and that under the second light where there is one.
    pub seen: Vec<SeenColour>,
    /// The surface that it started from.
    pub surface: Option<Arc<Entry>>,
    /// The smoothest reflectance.
    pub smoothest: Recovered,
    /// Three Fourier coefficients, for two colours six; or why there are none.
    pub fourier: Result<Recovered, String>,
    /// A light of lines, or why there is none.
    pub lines: Result<LineLight, String>,
    /// Least and greatest reflectance of all surfaces of the colour.
    pub band: Option<MetamerBand>,
    /// Other surfaces of the colour, values at the nodes: how different they can be.
    pub examples: Vec<[f64; NODES]>,
    /// Under other lights.
    pub under: Vec<Under>,
    /// How well the colour tells the surface that it started from.
    pub told: Option<Deviation>,
}

impl ColourSheet {
    /// Of a document.
    ///
    /// # Errors
    /// Why there is nothing to show, a sentence.
    pub fn of(from: &FromColour, document: &Document) -> Result<Self, String> {
        let surface = surface_of(&from.given, document)?;
        let measured = surface.as_ref().map(|entry| &entry.spectrum.samples);
        let mut asked = vec![asked(&from.given, &from.light, document)?];
        if let Some((given, light)) = &from.second {
            asked.push(self::asked(given, light, document)?);
        }
        let seen: Vec<Seen> = asked.iter().map(|(_, asked)| asked.seen()).collect();
        let smoothest = Recovered::new(Method::Smoothest, &seen)
            .map_err(|why| tr!("There is no such surface: {why}.", why))?;
        let fourier = Recovered::new(from.coefficients(), &seen).map_err(|why| why.to_string());
        let lines = match table_of(document, &from.lamp) {
            Some(lamp) => {
                line_light(&from.given, &from.lines, &lamp, measured).map_err(|why| why.to_string())
            }
            None => Err(missing(&from.lamp)),
        };
        let lights = &*LIGHTS;
        let told = measured.map(|measured| {
            let pairs: Vec<_> = lights.iter().map(|(_, t, v)| (t, v)).collect();
            deviation(&smoothest, measured, &pairs)
        });
        let under = lights_to_look_under(document)
            .iter()
            .map(|light| under(light, &smoothest, fourier.as_ref().ok(), measured))
            .collect();
        let band = metamers(&seen);
        let examples = match (&smoothest.reflectance, &smoothest.nearest) {
            (Reflectance::Nodes(nodes), None) => examples(&seen, nodes),
            _ => Vec::new(),
        };
        let seen = asked.into_iter().map(|(light, asked)| SeenColour {
            swatch: Swatch::of_patch(asked.xyz, asked.viewing.white(), Adaptation::ToLight),
            xyz: asked.xyz,
            white: asked.viewing.white(),
            light,
        });
        Ok(Self {
            seen: seen.collect(),
            band,
            examples,
            surface,
            smoothest,
            fourier,
            lines,
            under,
            told,
        })
    }

    /// The colour as a screen shows it, adapted to its light.
    pub fn swatch(&self) -> Swatch {
        let first = self.seen.first().map(|seen| seen.swatch);
        first.unwrap_or_else(|| Swatch::of_light(Xyz::ZERO))
    }
}

/// A given colour under a light, with the light's name.
fn asked(given: &Given, key: &str, document: &Document) -> Result<(String, Asked), String> {
    let light = table_of(document, key).ok_or_else(|| missing(key))?;
    let name = document.name_of(key);
    let surface = surface_of(given, document)?;
    let measured = surface.as_ref().map(|entry| &entry.spectrum.samples);
    match Asked::new(given, &light, measured) {
        Ok(asked) => Ok((name, asked)),
        Err(why) => Err(tr!("Not under {name}: {why}.", name, why)),
    }
}

fn surface_of(given: &Given, document: &Document) -> Result<Option<Arc<Entry>>, String> {
    let found = |key| entry_of(document, key).ok_or_else(|| missing(key));
    given.surface().map(found).transpose()
}

fn missing(key: &str) -> String {
    tr!("The library has no {key} any more: choose another.", key)
}

fn under(
    (name, table, viewing): &Light,
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
        light: name.clone(),
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
        app::{App, Command, assert_says, command::MadeFor},
        spectrum::Kind,
    };

    /// A colour by itself, everything else as at first.
    fn of(given: Given) -> FromColour {
        FromColour {
            given,
            ..FromColour::default()
        }
    }

    fn surface(key: &str) -> FromColour {
        of(Given::Of(key.to_owned()))
    }

    fn sheet(from: &FromColour) -> ColourSheet {
        ColourSheet::of(from, App::new().document()).expect("a colour under a light")
    }

    #[test]
    fn the_light_and_the_second_one_are_the_first_that_it_is_looked_at_under() {
        let mut app = App::new();
        let names = |app: &App| {
            let sheet = ColourSheet::of(&FromColour::default(), app.document());
            let sheet = sheet.expect("a colour under a light");
            sheet
                .under
                .into_iter()
                .map(|under| under.light)
                .collect::<Vec<_>>()
        };
        let alone = names(&app);
        assert_eq!((alone[0].as_str(), alone.len()), ("FL2", UNDER.len()));
        let second = app.entry("cie_led_1nm/LED-B1").expect("shipped");
        app.apply(Command::Compare(Some(second)));
        let both = names(&app);
        assert_eq!(both[..2], ["FL2", "LED-B1"]);
        assert_eq!(both[2..], alone[1..UNDER.len() - 1]);
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
        assert_eq!(found.swatch().hex(), "#c08040");
        assert_eq!((found.under.len(), found.facts().len()), (UNDER.len(), 3));
        assert_says(&found.sentence(), "#c08040");
        // The examples are surfaces, and have the colour that was asked for.
        assert_eq!(found.examples.len(), 8);
        let seen = &found.seen[0];
        let viewing = Viewing::new(
            &table_of(App::new().document(), "cie_illuminants/CIE D65").expect("a light"),
            crate::color::Observer::CIE_1931,
        );
        for example in &found.examples {
            assert!(example.iter().all(|v| (0.0..=1.0).contains(v)));
            let xyz = viewing.as_ref().expect("it shines").xyz(example);
            let off = [xyz.x - seen.xyz.x, xyz.y - seen.xyz.y, xyz.z - seen.xyz.z];
            // The smoothest has it to 1e-7 of the white, the rest is rounding.
            assert!(off.iter().all(|off| off.abs() < 1e-6), "{off:?}");
        }
        // The band is of single wavelengths, and of what is straight between its points: the
        // sentence says the first, the handbook all of it.
        assert_says(&found.sentence(), "averaged over wavelength");
        assert_says(&found.sentence(), "smoothest");
        let handbook = include_str!("../../../docs/window.md");
        for words in [
            "at each wavelength alone",
            "straight between points 5 nm apart",
            "match it to the standard observer",
            "least slope of artanh(2r - 1)",
        ] {
            assert_says(handbook, words);
        }
    }

    #[test]
    fn a_colour_that_no_surface_has_says_how_far_the_nearest_is() {
        let found = sheet(&of(Given::Lab([50.0, 150.0, -150.0])));
        assert!(found.sentence().starts_with("No surface has this colour"));
        assert_says(&found.sentence(), "nearest by ΔE*ab");
        assert!(found.band.is_none());
    }

    #[test]
    fn a_surface_of_the_library_is_told_by_its_colour_as_well_as_it_says() {
        let found = sheet(&surface("colorchecker_ohta/red"));
        let told = found.told.as_ref().expect("a surface to compare with");
        assert!(told.rms > 0.0 && told.rms < 0.3, "{}", told.rms);
        assert_says(&found.sentence(), "red comes out");
        // Under the light that it was told by it looks the same.
        let by = found.under.iter().find(|under| under.light == "CIE D65");
        assert!(by.expect("usual").differs.expect("seen") < 0.05);
        assert!(found.under.iter().all(|under| under.real.is_some()));
    }

    #[test]
    fn two_lights_tell_a_surface_better_than_one_and_tell_how_well_they_differ() {
        let one = surface("colorchecker_ohta/blue");
        let first = sheet(&one);
        let app = App::new();
        let two = one.with_second(Some(&first), UNDER[1], app.document());
        let found = sheet(&two);
        let rms = |sheet: &ColourSheet| sheet.told.as_ref().map(|told| told.rms);
        let (two_off, one_off) = (rms(&found), rms(&first));
        assert!(two_off < one_off, "{two_off:?} {one_off:?}");
        let band = |sheet: &ColourSheet| sheet.spread().expect("a surface can have it");
        assert!(band(&found) < band(&first));
        let few = found.fourier.as_ref().expect("D65 and A differ");
        assert_eq!((few.method, few.xyz.len()), (Method::Fourier6, 2));
        let of_one = first.fourier.as_ref().expect("D65 shows colours");
        assert!(few.condition_number > of_one.condition_number);
        assert_says(&found.sentence(), "CIE D65 and CIE A");
        // The recipe has both colours, and follows both lights.
        let recipe = two.recipe();
        assert!(recipe.stands_on().contains(&UNDER[1]));
        let mut app = App::new();
        app.apply(Command::Make {
            recipe,
            place: MadeFor::Shown,
        });
        let made = &app.document().own[0].spectrum.samples;
        assert_eq!(*made, found.smoothest.reflectance.sampled());
        // One light less, and the coefficients are three again.
        let few = FromColour {
            method: Method::Fourier6,
            ..two.clone()
        };
        assert_eq!(in_reach(few.clone()).method, Method::Fourier6);
        assert_eq!(few.with_one().method, Method::Fourier3);
        // The same light twice tells no six numbers.
        let same = two.with_second(Some(&first), UNDER[0], app.document());
        assert!(sheet(&same).fourier.is_err());
    }

    #[test]
    fn a_second_light_begins_with_the_colour_that_the_smoothest_surface_has() {
        let one = FromColour::default();
        let first = sheet(&one);
        let two = one.with_second(Some(&first), UNDER[1], App::new().document());
        let found = sheet(&two);
        assert!(found.smoothest.nearest.is_none());
        let values = |sheet: &ColourSheet| sheet.smoothest.reflectance.sampled();
        for (a, b) in values(&first).values().iter().zip(values(&found).values()) {
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
        // Two colours that no surface has together get a word and the nearest.
        let odd = FromColour {
            second: Some((Given::Srgb([0, 0, 255]), UNDER[1].to_owned())),
            ..FromColour::default()
        };
        let words = sheet(&odd).sentence();
        assert!(words.starts_with("No surface has these colours under"));
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
            method: Method::Fourier6,
            ..of(Given::Lab([f64::NAN, 1e9, 0.0]))
        };
        let sound = in_reach(nonsense);
        assert_eq!(sound.given, Given::Lab([0.0, 200.0, 0.0]));
        assert_eq!(sound.method, Method::Fourier3);
        assert_eq!(of_hex(" C08040"), Some([0xc0, 0x80, 0x40]));
        assert_eq!(of_hex("orange"), None);
    }
}
