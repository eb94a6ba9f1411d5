//! The sentence with its evidence, and what a person may say to it.

use eframe::egui;
use egui::{DragValue, Ui};

use super::{Bench, PageContext, PageWish, PhotographView, ResponseAsk, names};
use crate::{
    app::{
        Command,
        photograph::{
            Instrument, LampChoice, Photograph, PhotographAsk, Said, SeenPhotograph, Source,
            colour_words, sentence, table, warnings,
        },
    },
    photographs::{Lamp, strip::ByHand},
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
                kit::headline(
                    ui,
                    context.theme,
                    sentence(found).replace(" (--yes takes it)", ""),
                );
                ui.horizontal_wrapped(|ui| self.answers(ui, found));
                if let Some(words) = colour_words(found) {
                    ui.label(words);
                }
                if let Some((low, high)) = found.valid_nm() {
                    ui.weak(format!("The axis holds from {low:.0} to {high:.0} nm."));
                }
                kit::small_warnings(ui, context.theme, &warnings(found));
            }
            Err(why) => {
                kit::headline(ui, context.theme, "Cannot be said.");
                kit::warning(ui, context.theme, why.clone());
            }
        }
        ui.add_space(4.0);
        self.by_hand(ui, seen);
        ui.add_space(4.0);
        self.uses(ui, context, seen);
    }

    /// Yes, no, and the lamp that it is.
    fn answers(&mut self, ui: &mut Ui, found: &Photograph) {
        let mut said = self.said.clone();
        if found.is_open() && pressed(ui, names::YES, "Takes the axis.") {
            said.yes = true;
        }
        let has_axis = found.curve().is_some();
        if has_axis && pressed(ui, names::NO, "Takes the axis away; the picture stays.") {
            said = Said {
                strip: said.strip,
                lamp: LampChoice::Nothing,
                ..Said::default()
            };
        }
        let answer = found.answer.as_ref().filter(|_| found.is_by_lines());
        let both = answer.and_then(|a| a.best.as_ref().zip(a.runner_up.as_ref()));
        if let Some((best, other)) = both.filter(|(best, other)| best.lamp != other.lamp) {
            let (name, scores) = (other.lamp.name(), (other.score, best.score));
            let words = format!("{name}, {:.1} against {:.1}", scores.0, scores.1);
            if pressed(ui, &words, "Takes the next best lamp instead.") {
                said.lamp = LampChoice::Is(other.lamp);
            }
        }
        let chosen = match said.lamp {
            LampChoice::Auto => "any lamp",
            LampChoice::Nothing => "no lamp",
            LampChoice::Is(lamp) => lamp.name(),
        };
        let choice = Choice {
            name: names::LAMP,
            meaning: "The lamp whose lines are looked for.",
            width: 110.0,
        };
        choice.show(ui, chosen, |ui| {
            ui.selectable_value(&mut said.lamp, LampChoice::Auto, "any lamp");
            for lamp in Lamp::ALL {
                ui.selectable_value(&mut said.lamp, LampChoice::Is(lamp), lamp.name());
            }
            ui.selectable_value(&mut said.lamp, LampChoice::Nothing, "no lamp");
        });
        self.say(said);
        let undo = "Takes back what was said last of this picture.";
        if !self.past.is_empty() && pressed(ui, names::UNDO, undo) {
            self.said = self.past.pop().unwrap_or_default();
        }
    }

    /// Position of the strip, as far as it is set by hand.
    fn by_hand(&mut self, ui: &mut Ui, seen: &SeenPhotograph) {
        let mut said = self.said.clone();
        ui.horizontal_wrapped(|ui| {
            let way = &mut said.strip.is_vertical;
            let words = |way: Option<bool>| match way {
                None => ("either way", "As the colours run."),
                Some(false) => ("horizontal", "Colours run from left to right."),
                Some(true) => ("vertical", "Colours run from top to bottom."),
            };
            let choice = Choice {
                name: "Way of the strip",
                meaning: "The way that the colours run.",
                width: 90.0,
            };
            choice.pick(ui, way, [None, Some(false), Some(true)], words);
            let found = seen.found.as_ref().ok();
            let mut turn = said
                .strip
                .turn_deg
                .or(found.map(|f| f.found.strip.turn_deg))
                .unwrap_or(0.0);
            let field = DragValue::new(&mut turn)
                .range(-45.0..=45.0)
                .speed(0.05)
                .fixed_decimals(2)
                .suffix("°");
            if number(ui, field, "Turn of the strip").changed() {
                said.strip.turn_deg = Some(turn);
            }
            let strips = found.map_or(1, |f| f.found.strips);
            if strips > 1 || said.strip.strip.is_some() {
                let now = said.strip.strip.unwrap_or(1);
                if pressed_small(
                    ui,
                    &format!("strip {now} of {strips}"),
                    "Reads the next strip.",
                ) {
                    said.strip.strip = Some(now % strips.max(1) + 1);
                }
            }
            let as_found = "Takes back all that was set by hand of the strip.";
            if said.strip != ByHand::default() && pressed_small(ui, "as found", as_found) {
                said.strip = ByHand::default();
            }
        });
        ui.weak("Drag over the picture to draw the band by hand; drag a tick to its peak.");
        if said.strip != self.said.strip {
            said.instrument = None;
        }
        self.say(said);
    }

    /// What becomes of the picture.
    fn uses(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, seen: &SeenPhotograph) {
        let found = seen.found.as_ref().ok();
        let used = found.filter(|found| found.used_curve().is_some());
        ui.horizontal_wrapped(|ui| {
            if let Some(found) = used {
                let meaning = "The spectrum joins your own: relative, as read.";
                if pressed(ui, names::LIBRARY, meaning)
                    && let Some(spectrum) = found.spectrum()
                {
                    context.commands.push(Command::Adopt(vec![spectrum]));
                }
                let is_own = found.source() != Source::Instrument;
                let meaning = "The next pictures are read with this strip and axis, if they fit.";
                if is_own && pressed(ui, names::INSTRUMENT, meaning) {
                    self.keep(found, &seen.name);
                }
                copy_button(ui, "Copy the spectrum as CSV", "", || {
                    table(found).map_or_else(String::new, |table| table.csv())
                });
            }
            if pressed(ui, names::OPEN, "Opens another picture.") {
                context.wishes.push(PageWish::OpenPicture);
            }
        });
        let Some(bench) = &self.bench else { return };
        let name = bench.instrument.name.clone();
        ui.horizontal_wrapped(|ui| {
            ui.label(format!("Instrument: {name}"));
            if pressed_small(ui, "put away", "The next pictures are read by themselves.") {
                self.bench = None;
                self.said.instrument = None;
            }
        });
        if used.is_some_and(|found| found.source() == Source::Instrument) {
            self.known_light(ui);
        }
    }

    /// This picture is a bulb of a temperature: its response is learnt.
    fn known_light(&mut self, ui: &mut Ui) {
        let (Some(bench), Some(path)) = (&self.bench, self.path.clone()) else {
            return;
        };
        let lamp = bench.lamp.clone();
        if self.kelvin < 1000.0 {
            self.kelvin = 2856.0;
        }
        ui.horizontal_wrapped(|ui| {
            ui.label("This picture is a bulb of");
            let field = DragValue::new(&mut self.kelvin)
                .range(1000.0..=20_000.0)
                .suffix(" K");
            number(ui, field, "Temperature of the bulb");
            let meaning = "Learns what the camera makes of each wavelength; 100 K off is 3 % of a \
                           colour temperature.";
            if pressed(ui, "Learn the response", meaning) {
                let kelvin = self.kelvin;
                self.learning = Some(ResponseAsk { lamp, path, kelvin });
            }
        });
    }

    /// The strip and the axis of this picture for the next ones.
    fn keep(&mut self, found: &Photograph, name: &str) {
        let (Some(path), Some(instrument)) = (self.path.clone(), Instrument::of(found, name, None))
        else {
            return;
        };
        let said = self.said.clone();
        self.bench = Some(Bench {
            instrument,
            lamp: PhotographAsk { path, said },
        });
    }
}
