//! What the mixing desk shows: each channel as a light, the figures of the mixture, the table of
//! channels.

use super::{
    light,
    mix::{FULL, Mix, MixChannel},
};
use crate::{
    app::{
        cells::{Columns, Table, cell, rounded},
        document::Document,
        make::{entry_of, table_of},
        recipe::Recipe,
        tint,
    },
    color::{
        Observer, Srgb, Swatch, Xyz,
        quality::{Light, RENDERING_NAMES, Rendering, rendering},
        uv_1976_from_xyz,
        xyz::xyz_from_nm_values,
    },
    design::{
        SampleTables,
        mixture::{Channel, MixError, Source, mixed},
        solve::{MixFigures, Mixer},
    },
    languages::{fixed, said, with_sign},
};

/// From which value on a figure is good, and from which it is fair: what standards and
/// specifications of lamps commonly ask for.
const GOOD_RA: [f64; 2] = [90.0, 80.0];
const GOOD_R9: [f64; 2] = [50.0, 20.0];
const GOOD_RF: [f64; 2] = [85.0, 75.0];

/// A figure that a light is chosen by.
#[derive(Clone, Debug, PartialEq)]
pub struct MainFigure {
    pub name: &'static str,
    /// With its unit.
    pub value: String,
    /// How good it is; may be empty.
    pub word: &'static str,
    /// A sentence.
    pub meaning: &'static str,
}

/// A channel as a light, behind the gels.
#[derive(Clone, Debug)]
pub struct Strip {
    /// What it is, in words.
    pub title: String,
    /// Its light; why there is none.
    pub light: Result<Channel, MixError>,
    /// Its place in CIE 1976 u'v'; `None` for what is not seen.
    pub uv: Option<[f64; 2]>,
    pub colour: Srgb,
}

/// The desk as it stands.
#[derive(Clone, Debug)]
pub struct Desk {
    /// The desk in the document.
    pub mix: Mix,
    /// Its channels, in order.
    pub strips: Vec<Strip>,
    /// The mixture, power a nm on 360-830.
    pub values: Vec<f64>,
    /// Its figures; `None` where no channel is a light.
    pub figures: Option<MixFigures>,
    /// The test colours under the mixture and under its reference.
    pub rendering: Option<Rendering>,
    /// Corners of what the channels that are heard can show, CIE 1976 u'v'.
    pub reach: Vec<[f64; 2]>,
}

impl Desk {
    /// The desk of a document.
    pub fn of(document: &Document) -> Self {
        Self::of_mix(document.pages.mix.desk.clone(), document)
    }

    /// The second light of a document as a mixture of itself; `None` where none was chosen.
    pub fn of_second(document: &Document) -> Option<Self> {
        let key = document.second.as_ref()?.key.clone();
        let mix = Mix {
            channels: vec![MixChannel::new(Source::Named(key))],
            gels: Vec::new(),
        };
        Some(Self::of_mix(mix, document))
    }

    fn of_mix(mix: Mix, document: &Document) -> Self {
        let gels = light::gels_on_nm(&mix.gels, |key| entry_of(document, key));
        let strip =
            |source: &_| light::channel(source, |key| table_of(document, key), gels.as_deref());
        let strips: Vec<Strip> = mix
            .channels
            .iter()
            .map(|channel| {
                let title = channel.title(&|key| document.name_of(key));
                Strip::of(title, strip(&channel.source))
            })
            .collect();
        let mut desk = Self {
            mix,
            strips,
            values: Vec::new(),
            figures: None,
            rendering: None,
            reach: Vec::new(),
        };
        let (channels, powers) = desk.lights();
        desk.values = mixed(&channels, &powers);
        let tables = SampleTables::shipped();
        if let Ok(mixer) = Mixer::new(&channels, tables) {
            desk.figures = Some(mixer.figures(&powers));
            desk.reach = mixer.reachable_uv();
        }
        let cct = desk.figures.as_ref().and_then(|figures| figures.cct);
        desk.rendering =
            cct.and_then(|cct| rendering(&Light::of_nm_values(&desk.values), cct).ok());
        desk
    }

    /// R9 of the mixture.
    pub fn r9(&self) -> Option<f64> {
        let rendering = self.rendering.as_ref()?;
        Some(rendering.samples[8].index)
    }

    /// The channels that are lights and are heard, with their powers.
    pub fn lights(&self) -> (Vec<Channel>, Vec<f64>) {
        let heard = self.heard();
        heard
            .into_iter()
            .map(|(index, light)| (light.clone(), self.mix.channels[index].level))
            .unzip()
    }

    /// The channels that are lights and are heard, by their numbers.
    pub fn heard(&self) -> Vec<(usize, &Channel)> {
        let strips = self.strips.iter().zip(&self.mix.channels).enumerate();
        strips
            .filter(|(_, (_, channel))| self.mix.is_heard(channel))
            .filter_map(|(index, (strip, _))| Some((index, strip.light.as_ref().ok()?)))
            .collect()
    }

    /// The mixture as a light of the library; `None` where nothing shines.
    pub fn recipe(&self) -> Option<Recipe> {
        let heard = self.heard().into_iter();
        let channel = heard.map(|(index, _)| &self.mix.channels[index]);
        let channels: Vec<_> = channel
            .filter(|channel| channel.level > 0.0)
            .map(|channel| (channel.source.clone(), channel.level))
            .collect();
        let gels = self.mix.gels.clone();
        (!channels.is_empty()).then_some(Recipe::Mix { channels, gels })
    }

    /// The colour of the mixture, as bright as a screen can show it.
    pub fn swatch(&self) -> Swatch {
        let xyz = self.figures.as_ref().and_then(|figures| figures.xyz);
        Swatch::of_light(xyz.unwrap_or(Xyz::ZERO))
    }

    /// The result in a sentence.
    pub fn sentence(&self) -> String {
        match &self.figures {
            None if self.mix.channels.is_empty() => {
                said!("Nothing is mixed yet: add a channel.").to_owned()
            }
            Some(figures) if figures.xyz.is_some() => words(figures, self.r9()),
            _ => said!("Nothing shines: move a fader up.").to_owned(),
        }
    }

    /// What the light is and what it does to colours, a sentence.
    pub fn headline(&self) -> String {
        let figures = self.figures.as_ref();
        let Some((figures, cct)) = figures.and_then(|figures| Some((figures, figures.cct?))) else {
            return self.sentence();
        };
        let what = tint::light_words(cct);
        let light = tr!(
            "{what} of {temperature}",
            what,
            temperature = tint::kelvin_words(cct.kelvin)
        );
        let colours = match figures.ra {
            None => return format!("{light}."),
            Some(ra) if ra >= GOOD_RA[0] => said!("colours look right"),
            Some(ra) if ra >= GOOD_RA[1] => said!("colours look almost right"),
            Some(ra) if ra >= 60.0 => said!("colours look visibly wrong"),
            Some(_) => said!("colours look wrong"),
        };
        let samples = self.rendering.iter().flat_map(|found| &found.samples);
        let indices = samples.map(|sample| sample.index).enumerate();
        let worst = indices.min_by(|a, b| a.1.total_cmp(&b.1));
        let worst = worst.filter(|(_, index)| *index < GOOD_R9[1]);
        match worst {
            None => format!("{light}: {colours}."),
            Some((at, index)) => tr!(
                "{light}: {colours}, {worst} most of all (R{number} {index}).",
                light,
                colours,
                worst = said(RENDERING_NAMES[at]),
                number = at + 1,
                index = fixed(index, 0)
            ),
        }
    }

    /// The figures that a light is chosen by, with a word where one is good or low.
    pub fn main_figures(&self) -> Vec<MainFigure> {
        let Some(figures) = self.figures.as_ref().filter(|f| f.xyz.is_some()) else {
            return Vec::new();
        };
        let whole = |value: Option<f64>| value.map_or("–".to_owned(), |v| format!("{v:.0}"));
        let word = |value: Option<f64>, [good, fair]: [f64; 2]| match value {
            None => "",
            Some(value) if value >= good => later!("good"),
            Some(value) if value >= fair => later!("fair"),
            Some(_) => later!("low"),
        };
        let (cct, r9) = (figures.cct, self.r9());
        let rf_rg = format!("{}, {}", whole(figures.rf), whole(figures.rg));
        let figure = |name, value, word, meaning| MainFigure {
            name,
            value,
            word,
            meaning,
        };
        vec![
            figure(
                said!("White"),
                cct.map_or("–".to_owned(), |cct| tint::kelvin_words(cct.kelvin)),
                cct.map_or(later!("coloured"), tint::tint),
                said!("Correlated colour temperature."),
            ),
            figure(
                "Duv",
                cct.map_or("–".to_owned(), |cct| {
                    with_sign(format!("{:+.4}", cct.duv))
                }),
                "",
                said!("Distance from the line of blackbodies: above 0 greenish, below 0 pinkish."),
            ),
            figure(
                said!("Light"),
                format!("{:.0} lm/W", figures.ler),
                "",
                said!(
                    "Luminous efficacy: lumens for each watt of radiation, not of electric power."
                ),
            ),
            figure(
                "CRI Ra",
                whole(figures.ra),
                word(figures.ra, GOOD_RA),
                said!("Colour rendering index, a mean over 8 pale test colours: good from 90 on."),
            ),
            figure(
                "CRI R9",
                whole(r9),
                word(r9, GOOD_R9),
                said!("Rendering of a strong red: good from 50 on."),
            ),
            figure(
                "TM-30 Rf, Rg",
                rf_rg,
                word(figures.rf, GOOD_RF),
                said!(
                    "Fidelity over 99 surfaces, good from 85 on, and gamut: above 100 colours are \
                     more vivid than under the reference."
                ),
            ),
        ]
    }

    /// The channels as a table: specification, fader, share of the power, DMX values.
    pub fn table(&self) -> Table {
        // A gel leaves every channel another share of its power.
        let passes = |strip: &Strip| strip.light.as_ref().map_or(0.0, Channel::power);
        let powers = self.mix.powers();
        let through = self.strips.iter().zip(&powers);
        let through: Vec<f64> = through.map(|(strip, p)| p * passes(strip)).collect();
        let whole: f64 = through.iter().sum();
        // Name, power over the full one, share of the power of all.
        let columns = Columns::<(String, f64, f64)>::default()
            .with("channel", |(name, ..)| cell(name.as_str()))
            .with("drive_percent", |(_, drive, _)| {
                rounded(100.0 * drive, 2, "")
            })
            .with("share_of_power_percent", |(.., share)| {
                rounded(100.0 * share, 2, "")
            })
            .with("dmx_8", |(_, drive, _)| rounded(255.0 * drive, 0, ""))
            .with("dmx_16", |(_, drive, _)| rounded(65535.0 * drive, 0, ""));
        let rows = self.mix.channels.iter().zip(powers).zip(through);
        let rows = rows.map(|((channel, power), through)| {
            let share = if whole > 0.0 { through / whole } else { 0.0 };
            (channel.source.words(), power / FULL, share)
        });
        Table::new("", columns, rows)
    }
}

impl Strip {
    fn of(title: String, light: Result<Channel, MixError>) -> Self {
        let seen = |channel: &Channel| xyz_from_nm_values(&channel.values, Observer::CIE_1931);
        let channel = light.as_ref().ok();
        let xyz = channel.and_then(|channel| seen(channel).with_y(100.0));
        Self {
            title,
            uv: xyz.and_then(uv_1976_from_xyz),
            colour: Swatch::of_light(xyz.unwrap_or(Xyz::ZERO)).rgb8,
            light,
        }
    }
}

/// "3000 K and white ...: Ra 92, ..." of the figures of a light.
pub(super) fn words(figures: &MixFigures, r9: Option<f64>) -> String {
    let per_watt = format!("{:.0} lm/W", figures.ler);
    let melanopic = tr!(
        "melanopic DER {value}",
        value = fixed(figures.melanopic_der, 2)
    );
    let Some(cct) = figures.cct else {
        return tr!(
            "A coloured light without a colour temperature: {per_watt}, {melanopic}.",
            per_watt,
            melanopic
        );
    };
    let what = tint::light_words(cct);
    let index = |name: &str, value: Option<f64>| value.map(|v| format!("{name} {v:.0}"));
    let indices = [
        index("Ra", figures.ra),
        index("R9", r9),
        index("Rf", figures.rf),
        index("Rg", figures.rg),
    ];
    let mut all: Vec<String> = indices.into_iter().flatten().collect();
    all.extend([per_watt, melanopic]);
    tr!(
        "{what} of {temperature} (Duv {duv}): {figures}.",
        what,
        temperature = tint::kelvin_words(cct.kelvin),
        duv = with_sign(format!("{:+.4}", cct.duv)),
        figures = all.join(", ")
    )
}

/// Puts a mixture on the desk and tells what it shows.
#[cfg(test)]
pub(super) fn put_on_desk(app: &mut crate::app::App, mix: Mix) -> Desk {
    app.edit_pages(|pages| pages.mix.desk = mix);
    Desk::of(app.document())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{App, Command, assert_says, command::MadeFor, design::mix::MixChannel, recipe::Gel},
        design::mixture::Source,
    };

    fn make_light(app: &mut App, recipe: Recipe) -> std::sync::Arc<crate::app::Entry> {
        let place = MadeFor::Shown;
        app.apply(Command::Make { recipe, place });
        app.document().light.clone()
    }

    #[test]
    fn the_first_mixture_is_white_and_its_sentence_has_its_figures() {
        let desk = Desk::of(App::new().document());
        let cct = desk.figures.as_ref().and_then(|f| f.cct).expect("a white");
        assert_eq!(tint::whiteness(cct), tint::Whiteness::White, "{cct:?}");
        let sentence = desk.sentence();
        assert!(sentence.starts_with("A white light of "), "{sentence}");
        for part in [&tint::kelvin_words(cct.kelvin), "R9 ", "Rg "] {
            assert_says(&sentence, part);
        }
    }

    #[test]
    fn the_headline_names_what_suffers_most_and_the_figures_say_the_same() {
        let desk = Desk::of(App::new().document());
        let found = desk.rendering.as_ref().expect("a white");
        let worst = found.samples.iter().map(|s| s.index).fold(100.0, f64::min);
        let at = found.samples.iter().position(|s| s.index == worst);
        let at = at.expect("one of 15");
        assert!(worst < 20.0, "{worst}");
        let words = desk.headline();
        assert_says(&words, &format!("R{} {worst:.0}", at + 1));
        assert_says(&words, RENDERING_NAMES[at]);
        let shown = desk.main_figures();
        assert_eq!(shown.len(), 6);
        let r9 = &shown[4];
        let figures = desk.r9().expect("a white");
        assert_eq!(r9.value, format!("{figures:.0}"));
        assert_eq!(r9.word, if figures < 20.0 { "low" } else { "fair" });
        // Of what does not shine there is nothing to say.
        let dark = put_on_desk(&mut App::new(), Mix::default());
        assert!(dark.main_figures().is_empty());
        assert_eq!(dark.headline(), dark.sentence());
    }

    #[test]
    fn a_dark_desk_and_an_empty_one_say_so() {
        let mut app = App::new();
        let mut mix = app.document().pages.mix.desk.clone();
        mix.channels
            .iter_mut()
            .for_each(|channel| channel.level = 0.0);
        let desk = put_on_desk(&mut app, mix);
        assert!(desk.recipe().is_none());
        assert_eq!(desk.sentence(), "Nothing shines: move a fader up.");
        let empty = put_on_desk(&mut app, Mix::default());
        assert_says(&empty.sentence(), "add a channel");
    }

    #[test]
    fn a_moved_fader_is_one_step_of_undo_with_words() {
        let mut app = App::new();
        let before = app.document().pages.mix.desk.clone();
        for level in [20.0, 30.0, 40.0] {
            let mut mix = app.document().pages.mix.desk.clone();
            mix.channels[0].level = level;
            put_on_desk(&mut app, mix);
        }
        app.end_gesture();
        let words = app.undo_words().expect("a step");
        assert_eq!(words, "fader of LED 455 nm to 40 %");
        app.apply(Command::Undo);
        assert_eq!(app.document().pages.mix.desk, before);
        assert!(app.undo_words().is_none());
    }

    #[test]
    fn the_mixed_light_follows_the_lights_that_it_is_made_of() {
        let mut app = App::new();
        let key = "cie_illuminants/CIE A".to_owned();
        let mut mix = Mix::first();
        mix.channels.push(MixChannel::new(Source::Named(key)));
        let desk = put_on_desk(&mut app, mix);
        let made = make_light(&mut app, desk.recipe().expect("it shines"));
        assert_eq!(made.spectrum.samples.values(), desk.values);
        // A mixture of that mixture.
        let mix = Mix {
            channels: vec![MixChannel::new(Source::Named(made.key.clone()))],
            gels: Vec::new(),
        };
        let recipe = put_on_desk(&mut app, mix).recipe().expect("it shines");
        let second = make_light(&mut app, recipe);
        let recipe = Recipe::Mix {
            channels: vec![(Source::Line { at_nm: 500.0 }, 1.0)],
            gels: Vec::new(),
        };
        let key = made.key.clone();
        app.apply(Command::MakeOtherwise { key, recipe });
        let now = app.entry(&second.key).expect("it is there");
        assert_ne!(now.spectrum.samples, second.spectrum.samples);
        let samples = &now.spectrum.samples;
        let at = samples.nm().iter().position(|nm| *nm == 500.0);
        assert_eq!(samples.values()[at.expect("on whole nm")], 50.0);
        // Without that light the channel is gone, and what was made of it stays.
        app.apply(Command::Remove {
            key: made.key.clone(),
        });
        assert!(app.document().pages.mix.desk.channels.is_empty());
        assert!(app.entry(&second.key).is_some());
    }

    #[test]
    fn gels_stand_before_every_channel_and_the_mixture_follows_them() {
        const GREEN: &str = "filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm";
        let mut app = App::new();
        let bare = Desk::of(app.document());
        let put_on = |app: &mut App, thickness: f64| {
            let key = GREEN.to_owned();
            let mix = Mix {
                gels: vec![Gel { key, thickness }],
                ..app.document().pages.mix.desk.clone()
            };
            let desk = put_on_desk(app, mix);
            app.end_gesture();
            desk
        };
        // No thickness is no gel.
        assert_eq!(put_on(&mut app, 0.0).values, bare.values);
        let (once, twice) = (put_on(&mut app, 1.0), put_on(&mut app, 2.0));
        let at = |desk: &Desk, nm: usize| desk.values[nm - 360] / bare.values[nm - 360];
        for nm in [455, 530, 632] {
            let (a, b) = (at(&once, nm), at(&twice, nm));
            assert!(a < 1.0 && (a * a - b).abs() < 1e-12, "{nm}: {a} {b}");
        }
        assert!(at(&once, 530) > at(&once, 455));
        // What is solved for is met behind the gel, and the light of the library is behind it too.
        assert!(app.undo_words().is_some_and(|w| w.ends_with("2.00")));
        let made = make_light(&mut app, twice.recipe().expect("it shines"));
        assert_eq!(made.spectrum.samples.values(), twice.values);
        assert_says(made.name(), "behind isuzu");
    }

    #[test]
    fn the_table_has_the_drive_in_per_cent_and_for_desks_of_8_and_16_bits() {
        let mut app = App::new();
        let mut mix = Mix::first();
        mix.channels[3].level = 100.0;
        mix.channels[0].mute = true;
        let csv = put_on_desk(&mut app, mix).table().csv();
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines.len(), 5);
        assert_eq!(lines[1], "\"gauss:455,20\",0.00,0.00,0,0");
        assert!(lines[4].starts_with("\"gauss:632,18\",100.00,"));
        assert!(lines[4].ends_with(",255,65535"));
    }
}
