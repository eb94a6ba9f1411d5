//! The sentence with its evidence, and what a person may say to it.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::Ui;

use super::{PageContext, PageWish, PhotographView, ResponseAsk, names};
use crate::{
    app::{
        Command,
        photograph::{
            Instrument, Known, LampChoice, Photograph, Said, SeenPhotograph, Source, colour_words,
            sentence_parts, table, warnings,
        },
    },
    io::name_of,
    languages::{self, fixed},
    photographs::Lamp,
    ui::kit::{self, Choice, copy_button, number, pressed, pressed_small},
};

impl PhotographView {
    /// All that is said of the picture, and what can be said to it.
    pub(super) fn words(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        seen: &SeenPhotograph,
    ) {
        match &seen.found {
            Ok(found) => {
                let [what, lines] = sentence_parts(found);
                kit::headline(ui, context.theme, what.replace(" (--yes)", ""));
                if !lines.is_empty() {
                    ui.label(format!("{lines}."));
                }
                ui.horizontal_wrapped(|ui| self.answers(ui, found));
                if let Some(words) = colour_words(found) {
                    ui.label(words);
                }
                let resolution = found.resolution();
                if let Some((low, high)) = found.valid_nm() {
                    let mut words = tr!(
                        "The axis holds from {low} to {high} nm.",
                        low = fixed(low, 0),
                        high = fixed(high, 0)
                    );
                    if let Some((fwhm, nm)) = resolution {
                        words += " ";
                        words += &tr!(
                            "Resolution {width} nm at {nm}.",
                            width = fixed(fwhm, 1),
                            nm = fixed(nm, 0)
                        );
                    }
                    ui.weak(words);
                }
                kit::small_warnings(ui, context.theme, &warnings(found));
            }
            Err(why) => {
                kit::headline(ui, context.theme, said!("Cannot be said."));
                kit::warning(ui, context.theme, why.clone());
            }
        }
        ui.add_space(4.0);
        self.uses(ui, context, seen);
        self.show_many(ui, context);
        ui.add_space(4.0);
        self.pins(ui, seen);
        kit::fold(ui, "strip by hand", said!("Strip by hand"), |ui| {
            self.by_hand(ui, seen)
        });
    }

    /// Yes, no, and the lamp that it is.
    fn answers(&mut self, ui: &mut Ui, found: &Photograph) {
        let mut said = self.said.clone();
        if found.is_open() && pressed(ui, languages::said(names::YES), said!("Takes the axis.")) {
            said.yes = true;
        }
        let has_axis = found.curve().is_some();
        if has_axis
            && pressed(
                ui,
                languages::said(names::NO),
                said!("Takes the axis away; the picture stays."),
            )
        {
            said = Said {
                strip: said.strip,
                lamp: LampChoice::Nothing,
                ..Said::default()
            };
        }
        let answer = found.answer.as_ref().filter(|_| found.is_by_lines());
        let both = answer.and_then(|a| a.best.as_ref().zip(a.other_lamp.as_ref()));
        if let Some((best, other)) = both.filter(|(_, other)| other.score > 0.0) {
            let (name, scores) = (
                languages::said(other.lamp.name()),
                (other.score, best.score),
            );
            let words = tr!(
                "{lamp}, {score} against {best}",
                lamp = name,
                score = fixed(scores.0, 1),
                best = fixed(scores.1, 1)
            );
            if pressed(ui, &words, said!("Takes the next best lamp instead.")) {
                said.lamp = LampChoice::Is(other.lamp);
            }
        }
        let chosen = match said.lamp {
            LampChoice::Auto => said!("any lamp"),
            LampChoice::Nothing => said!("no lamp"),
            LampChoice::Is(lamp) => languages::said(lamp.name()),
        };
        let choice = Choice {
            name: languages::said(names::LAMP),
            meaning: said!("The lamp whose lines are looked for."),
            width: 110.0,
        };
        choice.show(ui, chosen, |ui| {
            ui.selectable_value(&mut said.lamp, LampChoice::Auto, said!("any lamp"));
            for lamp in Lamp::ALL {
                let name = languages::said(lamp.name());
                ui.selectable_value(&mut said.lamp, LampChoice::Is(lamp), name);
            }
            ui.selectable_value(&mut said.lamp, LampChoice::Nothing, said!("no lamp"));
        });
        self.say(said);
        let undo = said!("Takes back what was said last of this picture.");
        if !self.past.is_empty() && pressed(ui, languages::said(names::UNDO), undo) {
            self.said = self.past.pop().unwrap_or_default();
        }
    }

    /// What becomes of the picture.
    fn uses(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, seen: &SeenPhotograph) {
        let found = seen.found.as_ref().ok();
        let used = found.filter(|found| found.used_curve().is_some());
        ui.horizontal_wrapped(|ui| {
            if let Some(found) = used {
                let meaning = said!("The spectrum joins your own: relative, as read.");
                if pressed(ui, languages::said(names::LIBRARY), meaning)
                    && let Some(spectrum) = found.spectrum()
                {
                    context.commands.push(Command::Adopt(vec![spectrum]));
                }
                let is_own = found.source() != Source::Instrument && self.path.is_some();
                let meaning =
                    said!("The next pictures are read with this strip and axis, if they fit.");
                if is_own && pressed(ui, languages::said(names::INSTRUMENT), meaning) {
                    self.keep(found, &seen.name);
                }
                copy_button(ui, said!("Copy the spectrum as CSV"), "", || {
                    table(found).map_or_else(String::new, |table| table.csv())
                });
            }
            if self.path.is_some()
                && pressed(
                    ui,
                    languages::said(names::OPEN),
                    said!("Opens another picture."),
                )
            {
                context.wishes.push(PageWish::OpenPicture);
            }
        });
        let Some(bench) = &self.bench else { return };
        let instrument = bench.instrument.clone();
        ui.horizontal_wrapped(|ui| {
            ui.label(tr!(
                "Instrument: {instrument}",
                instrument = instrument.name
            ));
            let meaning = said!("Strip, axis and response in a file; no picture and no place.");
            if pressed_small(ui, languages::said(names::SAVE_INSTRUMENT), meaning) {
                let wish = PageWish::Instrument(Box::new(instrument.clone()));
                context.wishes.push(wish);
            }
            if pressed_small(
                ui,
                said!("put away"),
                said!("The next pictures are read by themselves."),
            ) {
                self.bench = None;
                self.said.instrument = None;
            }
        });
        if used.is_some_and(|found| found.source() == Source::Instrument) {
            self.known_light(ui, context);
        }
    }

    /// This picture is a light that is known: its response is learnt.
    fn known_light(&mut self, ui: &mut Ui, context: &PageContext<'_>) {
        let (Some(bench), Some(path)) = (&self.bench, self.path.clone()) else {
            return;
        };
        let (lamp, instrument) = (bench.lamp.clone(), bench.instrument.clone());
        let light = &mut self.known;
        let base = &context.app.document().light;
        ui.horizontal_wrapped(|ui| {
            ui.label(said!("This picture is a known light:"));
            let chosen = match light.of {
                KnownAs::Bulb => said!("a bulb"),
                KnownAs::Daylight => said!("daylight"),
                KnownAs::Shown => said!("the light of the library"),
            };
            let choice = Choice {
                name: said!("The known light"),
                meaning: said!("What this picture shows."),
                width: 150.0,
            };
            choice.show(ui, chosen, |ui| {
                ui.selectable_value(&mut light.of, KnownAs::Bulb, said!("a bulb"));
                ui.selectable_value(&mut light.of, KnownAs::Daylight, said!("daylight"));
                let shown = tr!("{light}, chosen in the library", light = base.name());
                ui.selectable_value(&mut light.of, KnownAs::Shown, shown);
            });
            let known = match light.of {
                KnownAs::Bulb => {
                    let field = drag_value(&mut light.bulb_k)
                        .range(1000.0..=20_000.0)
                        .suffix(" K");
                    number(ui, field, said!("Temperature of the bulb"));
                    Known::Blackbody(light.bulb_k)
                }
                KnownAs::Daylight => {
                    let field = drag_value(&mut light.sky_k)
                        .range(4000.0..=25_000.0)
                        .suffix(" K");
                    number(ui, field, said!("Temperature of the daylight"));
                    Known::Daylight(light.sky_k)
                }
                KnownAs::Shown => {
                    Known::Spectrum(base.name().to_owned(), base.spectrum.samples.clone())
                }
            };
            let meaning = said!(
                "Learns what the camera makes of each wavelength; a bulb that is 100 K off changes \
                 a colour temperature by 3 %."
            );
            if pressed(ui, said!("Learn the response"), meaning) {
                self.learning = Some(ResponseAsk {
                    instrument,
                    lamp,
                    path,
                    known,
                });
            }
        });
    }

    /// The strip and the axis of this picture for the next ones.
    fn keep(&mut self, found: &Photograph, name: &str) {
        if let (Some(path), Some(instrument)) =
            (self.path.clone(), Instrument::of(found, name, None))
        {
            let said = self.said.clone();
            self.choose(instrument, Some((path, said)));
        }
    }
}

/// Kinds of a light that is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum KnownAs {
    #[default]
    Bulb,
    Daylight,
    /// The light that the program shows.
    Shown,
}

/// The light that a picture is said to show.
pub(super) struct KnownLight {
    of: KnownAs,
    bulb_k: f64,
    sky_k: f64,
}

impl Default for KnownLight {
    fn default() -> Self {
        Self {
            of: KnownAs::default(),
            bulb_k: 2856.0,
            sky_k: 6500.0,
        }
    }
}

/// The first step in little room.
pub(super) fn begin(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.strong(said!("An example, drawn by the program."));
        opens(ui, context);
    });
}

fn opens(ui: &mut Ui, context: &mut PageContext<'_>) {
    let meaning = said!("Opens a picture of a spectrum, JPEG or PNG.");
    let button = ui
        .button(languages::said(names::OPEN))
        .on_hover_text(meaning);
    if button.clicked() {
        context.wishes.push(PageWish::OpenPicture);
    }
}

/// What the page is for, and how to begin, over an example.
pub(super) fn nothing_open(ui: &mut Ui, context: &mut PageContext<'_>) {
    purpose(ui, context);
    ui.add_space(12.0);
    ui.strong(said!("An example, drawn by the program"));
}

fn purpose(ui: &mut Ui, context: &mut PageContext<'_>) {
    kit::headline(
        ui,
        context.theme,
        said!("A photograph of a spectrum becomes a spectrum."),
    );
    ui.add_space(4.0);
    ui.label(said!(
        "Hold a telephone before a grating or a DVD, with a slit before an energy-saving lamp. \
         Drop the picture here (JPEG or PNG): the lamp's lines fix the wavelengths. A picture of a \
         bulb with the same set-up fixes what the camera makes of them."
    ));
    ui.add_space(6.0);
    opens(ui, context);
    ui.add_space(4.0);
    ui.weak(said!(
        "The picture stays on this computer; the place where it was taken is never read."
    ));
}

impl PhotographView {
    /// A lesson waits for a picture; one that was there before it can be had back.
    pub(super) fn nothing_yet(&self, ui: &mut Ui, context: &mut PageContext<'_>) {
        purpose(ui, context);
        let path = self.own.path.as_deref();
        let meaning = path.map(|path| tr!("Shows {file} again.", file = name_of(path)));
        if let Some(meaning) = meaning
            && pressed(ui, languages::said(names::OWN), &meaning)
        {
            context.wishes.push(PageWish::OwnPicture);
        }
    }
}
