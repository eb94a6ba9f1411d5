//! What a person sets by hand: the strip, and columns whose wavelengths are known.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::Ui;

use super::{PhotographView, names};
use crate::{
    app::{
        photograph::{LampChoice, SeenPhotograph},
        ticks::short,
    },
    languages::{self, fixed},
    photographs::{axis::Pin, strip::ByHand},
    ui::kit::{Choice, number, pressed, pressed_small},
};

/// Lasers that are often at hand, nm.
const LASERS: [f64; 7] = [405.0, 450.0, 520.0, 532.0, 632.8, 635.0, 650.0];

/// What stands beside what was said.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ByHandState {
    /// The column that was clicked on, for which a wavelength is typed.
    pub column: Option<f64>,
    /// That wavelength, nm.
    pub nm: f64,
    /// The wavelength of the tick that arrow keys move.
    pub chosen_nm: Option<f64>,
    /// The lamp's lines are shown to be lined up, though no axis is known.
    pub lines_up: bool,
}

impl PhotographView {
    /// Pins: typed for a column, or a lamp's lines dragged to their peaks.
    pub(super) fn pins(&mut self, ui: &mut Ui, seen: &SeenPhotograph) {
        let Ok(found) = &seen.found else { return };
        let mut said = self.said.clone();
        ui.horizontal_wrapped(|ui| {
            let is_named = matches!(said.lamp, LampChoice::Is(_));
            let meaning = said!("Shows the lamp's lines: drag two of them to their peaks.");
            let is_open = is_named && found.curve().is_none() && !self.by_hand.lines_up;
            if is_open && pressed(ui, languages::said(names::LINE_UP), meaning) {
                self.by_hand.lines_up = true;
            }
            let Some(column) = self.by_hand.column else {
                ui.weak(said!(
                    "Drag a tick to its peak, or click on a peak and type its wavelength; arrow \
                     keys move the tick by 0.1 px."
                ));
                return;
            };
            ui.label(tr!("Column {column} is", column = fixed(column, 1)));
            let field = drag_value(&mut self.by_hand.nm)
                .range(100.0..=5000.0)
                .speed(0.1)
                .max_decimals(2)
                .suffix(" nm");
            number(ui, field, languages::said(names::PIN));
            let mut is_set = pressed_small(
                ui,
                languages::said(names::SET_PIN),
                said!("The axis goes through it."),
            );
            for nm in LASERS {
                let meaning = if [532.0, 632.8].contains(&nm) {
                    said!("A laser that keeps to its wavelength.")
                } else {
                    said!("Laser diodes are off by up to 10 nm.")
                };
                if pressed_small(ui, &short(nm), meaning) {
                    (self.by_hand.nm, is_set) = (nm, true);
                }
            }
            if is_set {
                let nm = self.by_hand.nm;
                said.pins.retain(|pin| (pin.nm - nm).abs() > 0.01);
                said.pins.push(Pin::near(column, nm));
                // One pin alone makes no axis: it waits for its second.
                self.by_hand.column = None;
            }
        });
        if said.pins.len() == 1 && !matches!(said.lamp, LampChoice::Is(_)) {
            ui.weak(said!("One pin is set; a second makes an axis."));
        }
        self.say(said);
    }

    /// Position of the strip, as far as it is set by hand.
    pub(super) fn by_hand(&mut self, ui: &mut Ui, seen: &SeenPhotograph) {
        let mut strip = self.said.strip.clone();
        let (mut falls, mut is_linear) = (self.said.falls, self.said.is_linear);
        let found = seen.found.as_ref().ok();
        ui.weak(said!(
            "Drag over the picture to draw the band, its edges to move them, its end to turn it."
        ));
        ui.horizontal_wrapped(|ui| ways(ui, &mut strip.is_vertical, &mut falls));
        let shown = found.map(|found| found.found.strip);
        ui.horizontal_wrapped(|ui| {
            let mut field = |set: &mut Option<f64>, found: Option<f64>, form: Field| {
                let mut value = set.or(found).unwrap_or(0.0);
                let drag = drag_value(&mut value)
                    .range(-form.most..=form.most)
                    .speed(form.speed)
                    .fixed_decimals(form.decimals)
                    .suffix(form.unit);
                ui.label(languages::said(form.word));
                if number(ui, drag, languages::said(form.name)).changed() && value.is_finite() {
                    *set = Some(value);
                }
            };
            field(&mut strip.turn_deg, shown.map(|s| s.turn_deg), TURN);
            field(&mut strip.shear, shown.map(|s| s.shear), SHEAR);
            field(&mut strip.smile, shown.map(|s| s.smile), SMILE);
        });
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut strip.is_one_row, said!("one row only"))
                .on_hover_text(said!("Reads the middle row of the band alone."));
            ui.checkbox(&mut is_linear, said!("linear codes"))
                .on_hover_text(said!("The codes of the picture are proportional to light."));
            let strips = found.map_or(1, |f| f.found.strips);
            if strips > 1 || strip.strip.is_some() {
                let now = strip.strip.unwrap_or(1);
                let words = tr!("strip {strip} of {strips}", strip = now, strips);
                if pressed_small(ui, &words, said!("Reads the next strip.")) {
                    strip.strip = Some(now % strips.max(1) + 1);
                    strip.area = None;
                }
            }
            let is_set = strip != ByHand::default() || falls.is_some() || is_linear;
            let meaning = said!("Takes back all that was set by hand of the strip.");
            if is_set && pressed_small(ui, said!("as found"), meaning) {
                (strip, falls, is_linear) = (ByHand::default(), None, false);
            }
        });
        self.set_strip(strip);
        let said = super::Said {
            falls,
            is_linear,
            ..self.said.clone()
        };
        self.say(said);
    }
}

/// The way that the colours run, and the side that blue lies on.
fn ways(ui: &mut Ui, is_vertical: &mut Option<bool>, falls: &mut Option<bool>) {
    let words = |way: Option<bool>| match way {
        None => (said!("either way"), said!("As the colours run.")),
        Some(false) => (
            said!("horizontal"),
            said!("Colours run from left to right."),
        ),
        Some(true) => (said!("vertical"), said!("Colours run from top to bottom.")),
    };
    let choice = Choice {
        name: said!("Way of the strip"),
        meaning: said!("The way that the colours run."),
        width: 90.0,
    };
    choice.pick(ui, is_vertical, [None, Some(false), Some(true)], words);
    let words = |falls: Option<bool>| match falls {
        None => (said!("blue either side"), said!("As the lines have it.")),
        Some(false) => (
            said!("blue first"),
            said!("Wavelengths rise to the right, or downwards."),
        ),
        Some(true) => (
            said!("red first"),
            said!("Wavelengths fall to the right, or downwards."),
        ),
    };
    let choice = Choice {
        name: said!("Side of the blue"),
        meaning: said!("The side that blue lies on."),
        width: 110.0,
    };
    choice.pick(ui, falls, [None, Some(false), Some(true)], words);
}

/// A field of a number.
struct Field {
    word: &'static str,
    name: &'static str,
    most: f64,
    speed: f64,
    decimals: usize,
    unit: &'static str,
}

const TURN: Field = Field {
    word: later!("turn"),
    name: later!("Turn of the strip"),
    most: 45.0,
    speed: 0.05,
    decimals: 2,
    unit: "\u{b0}",
};
const SHEAR: Field = Field {
    word: later!("shear"),
    name: later!("Shear of the strip"),
    most: 5.0,
    speed: 0.002,
    decimals: 3,
    unit: "",
};
const SMILE: Field = Field {
    word: later!("smile"),
    name: later!("Smile of the strip"),
    most: 5.0,
    speed: 0.000_05,
    decimals: 5,
    unit: "",
};
