//! The two knobs of the model by their right names, and what decides in their place.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::{RichText, Ui, vec2};

use crate::{
    app::{
        App, Command, Detector, Memo, NoiseBegins, Settings,
        answers::{self, LINE_THRESHOLDS},
        numbers::significant,
        pages::SPENDABLE,
        ticks::short,
        verdicts::HARD_TO_SEE,
    },
    languages::said,
    ui::{
        kit::{Stops, main_button, named, number, pressed, pressed_if},
        theme::{MOST_GROWN, Theme},
    },
};

/// Names of controls, shared with the tests that move them.
pub mod names {
    /// The order slider.
    pub const ORDER: &str = later!("Waves");
    /// The threshold slider.
    pub const LINES: &str = later!("Lines");
    /// The order as a number.
    pub const ORDER_TYPED: &str = later!("Number of waves");
    /// The count of lines as a number.
    pub const LINES_TYPED: &str = later!("Number of lines");
    /// The best way for a count of numbers.
    pub const AUTOMATIC: &str = later!("Automatic");
    /// The count of numbers for it.
    pub const BUDGET: &str = later!("Numbers for Automatic");
    /// Back to the start.
    pub const RESET: &str = later!("Reset");
    /// All other knobs.
    pub const MORE: &str = later!("More");
    /// The paper's settings.
    pub const PAPER: &str = later!("As in the paper");
}

/// Orders that the slider reaches; more can be typed.
const MOST: usize = 40;
/// Orders that most lights need: they have this share of the slider.
const USEFUL: f64 = 12.0;
const USEFUL_SHARE: f64 = 0.75;

/// Where an order stands on the slider.
fn place_of_order(order: f64) -> f64 {
    let rest = (order - USEFUL) / (MOST as f64 - USEFUL);
    match order <= USEFUL {
        true => USEFUL_SHARE * order / USEFUL,
        false => (USEFUL_SHARE + (1.0 - USEFUL_SHARE) * rest).min(1.0),
    }
}

/// The order at a place of the slider.
fn order_at(place: f64) -> f64 {
    let rest = (place - USEFUL_SHARE) / (1.0 - USEFUL_SHARE);
    match place <= USEFUL_SHARE {
        true => (USEFUL * place / USEFUL_SHARE).round(),
        false => (USEFUL + (MOST as f64 - USEFUL) * rest).round(),
    }
}

/// What the card keeps from frame to frame.
#[derive(Default)]
pub(super) struct SlidersView {
    /// Shares of the lines that can be let in, by the program's revision.
    shares: Memo<u64, Vec<f64>>,
}

/// What the card asks for beside commands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Asked {
    /// The best way for the count of numbers.
    pub automatic: bool,
    /// Everything back to the start.
    pub reset: bool,
    /// All other knobs.
    pub more: bool,
}

impl SlidersView {
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        app: &App,
        ((budget, busy), bare, noise): ((&mut usize, bool), bool, NoiseBegins),
        theme: Theme,
        commands: &mut Vec<Command>,
    ) -> Asked {
        let mut asked = Asked::default();
        let before = app.document().settings;
        let mut settings = before;
        let room = ui.max_rect();
        let shares = self
            .shares
            .get(app.revision(), |_| answers::line_shares(app));
        let layout = Layout::of(room.width(), theme.scale, bare);
        let mut child = |at: egui::Pos2, size: egui::Vec2| {
            let rect = egui::Rect::from_min_size(at, size);
            ui.new_child(egui::UiBuilder::new().max_rect(rect))
        };
        let knob = vec2(layout.knob, KNOB * theme.scale);
        let second = room.min + vec2(layout.knob + GAP, 0.0);
        waves(
            &mut child(room.min, knob),
            app,
            &mut settings,
            (layout.knob, bare, noise.order),
            theme,
        );
        lines(
            &mut child(second, knob),
            app,
            (shares, noise.percent),
            &mut settings,
            layout.knob,
            theme,
        );
        let high = ACTS * theme.scale;
        let acts_room = match layout.acts {
            Acts::Beside => Some((
                room.min + vec2(2.0 * (layout.knob + GAP), 0.5 * (knob.y - high)),
                vec2(buttons() * theme.scale, high),
            )),
            Acts::Below => Some((room.min + vec2(0.0, knob.y + 4.0), vec2(room.width(), high))),
            Acts::None => None,
        };
        if let Some((at, size)) = acts_room {
            child(at, size).horizontal(|ui| {
                ui.spacing_mut().interact_size.y = high;
                ui.spacing_mut().item_spacing.x = 8.0;
                acts(ui, (budget, busy), theme, &mut asked);
            });
        }
        if settings != before {
            commands.push(Command::Edit(settings));
        }
        asked
    }
}

/// Height of a knob: its caption and its slider, and of the buttons, points.
const KNOB: f32 = 56.0;
const ACTS: f32 = 28.0;
/// Width of the buttons, and between what stands side by side.
const BUTTONS: f32 = 312.0;
const GAP: f32 = 24.0;
/// What stands behind the count of numbers for Automatic.
const NUMBERS: &str = later!("numbers");
/// Usual width of a letter, points.
const LETTER: f32 = 7.5;

/// Width of the buttons in the language spoken, points.
fn buttons() -> f32 {
    let letters = |words: &str| words.chars().count() as f32;
    let words = [names::AUTOMATIC, NUMBERS, names::MORE, names::RESET];
    let more = words.map(|english| letters(said(english)) - letters(english));
    BUTTONS + LETTER * more.iter().sum::<f32>().max(0.0)
}

/// Where the buttons stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Acts {
    Beside,
    Below,
    /// Presenting and in lessons there are the two knobs alone.
    None,
}

/// How the card shares its width.
struct Layout {
    knob: f32,
    acts: Acts,
}

impl Layout {
    fn of(width: f32, scale: f32, bare: bool) -> Self {
        let beside = (width - buttons() * scale - 2.0 * GAP) / 2.0;
        // A large window's type is larger too, but less so.
        let acts = match (bare || scale > MOST_GROWN, beside >= 190.0 * scale) {
            (true, _) => Acts::None,
            (false, true) => Acts::Beside,
            (false, false) => Acts::Below,
        };
        let knob = match acts {
            Acts::Beside => beside,
            Acts::Below | Acts::None => (width - GAP) / 2.0,
        }
        .max(40.0);
        Self { knob, acts }
    }
}

/// Height of the card's contents at a width, points.
pub(super) fn height(width: f32, scale: f32, bare: bool) -> f32 {
    let acts = match Layout::of(width, scale, bare).acts {
        Acts::Below => ACTS * scale + 4.0,
        Acts::Beside | Acts::None => 0.0,
    };
    KNOB * scale + acts
}

/// A row over a slider: its name, and what its value does.
fn caption(ui: &mut Ui, width: f32, name: &str, meaning: &str, does: &str, theme: Theme) {
    ui.allocate_ui(vec2(width, 0.0), |ui| {
        ui.set_width(width);
        ui.horizontal(|ui| {
            ui.label(name).on_hover_text(meaning);
            if width < 190.0 * theme.scale {
                return;
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(does).small().color(theme.faint)).truncate());
            });
        });
    });
}

const BOX: f32 = 44.0;

/// What the tall tick means.
const NOISE_BEGINS: &str = later!(
    "The tall tick: the noise begins here. What lies beyond it draws the noise of the readings, and \
     Automatic stops there."
);

fn waves(
    ui: &mut Ui,
    app: &App,
    settings: &mut Settings,
    (width, bare, noise): (f32, bool, Option<usize>),
    theme: Theme,
) {
    ui.spacing_mut().item_spacing.x = 8.0;
    // In a lesson it would be the answer.
    let from = answers::hard_to_see_from(app).filter(|_| !bare && answers::judged(app).is_ok());
    let does = match (from, noise) {
        (None, None) => String::new(),
        (Some(0), None) => said!("no difference is seen").to_owned(),
        (Some(order), None) => tr!("looks alike from {order} on", order),
        (None, Some(order)) => tr!("draws noise beyond {order}", order),
        // As short as the row at its narrowest.
        (Some(order), Some(last)) => tr!("alike from {order}, noise beyond {last}", order, last),
    };
    let judged = match from {
        Some(_) => tr!(
            "Hard to see: ΔE₀₀ below {limit} from so many waves on, judged {judged_on}.",
            limit = short(HARD_TO_SEE),
            judged_on = answers::judged_on(app)
        ),
        None => String::new(),
    };
    let meaning = said!(
        "Waves that draw the smooth part: order N, which takes 2N + 1 numbers. Arrow keys move it \
         by one."
    );
    let meaning = [meaning, &judged, noise.map_or("", |_| said(NOISE_BEGINS))].join(" ");
    let meaning = meaning.replace("  ", " ");
    let meaning = meaning.trim_end();
    caption(ui, width, said(names::ORDER), meaning, &does, theme);
    ui.horizontal(|ui| {
        let order = settings.order as f64;
        let mut place = place_of_order(order);
        let stops = Stops {
            name: names::ORDER,
            ticks: &[],
            well_from: from.map(|order| place_of_order(order as f64)),
            noise_from: noise.map(|order| place_of_order(order as f64 + 0.5)),
            stepped: |place, steps| place_of_order((order_at(place) + steps).max(0.0)),
            value: order,
            ends: [0.0, MOST as f64],
            place_of: place_of_order,
        };
        let slider = stops.show(ui, &mut place, width - (BOX + 10.0) * theme.scale, theme);
        if slider.changed() {
            settings.order = order_at(place) as usize;
        }
        let typed = ui.add_sized(
            vec2(BOX, 24.0) * theme.scale,
            drag_value(&mut settings.order)
                .range(Settings::ORDER.reach.range())
                .speed(0.1),
        );
        named(&typed, egui::Role::SpinButton, said(names::ORDER_TYPED));
        typed.on_hover_text(said!("Drag or type: 0 to 100."));
    });
}

/// From a threshold to a place: lower thresholds, which let more lines in, stand further right.
fn place_of(threshold_percent: f64) -> f64 {
    let [lowest, highest] = LINE_THRESHOLDS;
    ((highest / threshold_percent).ln() / (highest / lowest).ln()).clamp(0.0, 1.0)
}

fn lines(
    ui: &mut Ui,
    app: &App,
    (shares, noise): (&[f64], Option<f64>),
    settings: &mut Settings,
    width: f32,
    theme: Theme,
) {
    ui.spacing_mut().item_spacing.x = 8.0;
    let meaning = said!(
        "The least share of the power that a line must hold to be kept as a line of its own, a \
         place and a weight: two numbers each. Each tick is a line that drops out there."
    );
    let meaning = [meaning, noise.map_or("", |_| said(NOISE_BEGINS))].join(" ");
    let mut does = answers::lines_words(app);
    if let Some(percent) = noise {
        let noise = tr!("noise up to {share} %", share = significant(percent, 2));
        does = [does, noise].join(", ");
    }
    caption(
        ui,
        width,
        said(names::LINES),
        meaning.trim_end(),
        &does,
        theme,
    );
    let by_energy = settings.detector == Detector::Energy;
    ui.horizontal(|ui| {
        let [lowest, highest] = LINE_THRESHOLDS;
        let mut place = if settings.spikes {
            place_of(settings.threshold_percent)
        } else {
            0.0
        };
        let ticks: Vec<f64> = shares.iter().map(|share| place_of(*share)).collect();
        let stops = Stops {
            name: names::LINES,
            ticks: &ticks,
            well_from: None,
            noise_from: noise.map(place_of),
            stepped: |place, steps| place + 0.02 * steps,
            value: settings.threshold_percent,
            ends: LINE_THRESHOLDS,
            place_of,
        };
        let room = width - (BOX + 10.0) * theme.scale;
        let slider = ui
            .add_enabled_ui(by_energy, |ui| stops.show(ui, &mut place, room, theme))
            .inner;
        if slider.changed() {
            settings.spikes = true;
            let threshold = highest * (lowest / highest).powf(place);
            settings.threshold_percent = (threshold * 1e3).round() / 1e3;
        }
        let found = app.derived().model.lines().len();
        let mut count = found;
        let typed = ui
            .add_enabled_ui(by_energy, |ui| {
                ui.add_sized(
                    vec2(BOX, 24.0) * theme.scale,
                    drag_value(&mut count)
                        .range(0..=shares.len().max(found))
                        .speed(0.05),
                )
            })
            .inner;
        named(&typed, egui::Role::SpinButton, said(names::LINES_TYPED));
        if typed.changed() && count != found {
            settings.spikes = count > 0;
            if count > 0 {
                settings.threshold_percent = answers::threshold_for(app, shares, count);
            }
        }
        typed.on_hover_text(said!("Lines that are kept: drag or type."));
    });
}

/// What decides in the place of the knobs, and the other knobs.
fn acts(ui: &mut Ui, (budget, busy): (&mut usize, bool), theme: Theme, asked: &mut Asked) {
    let button = main_button(ui, said(names::AUTOMATIC));
    let meaning = said!(
        "The best model with at most this many numbers, over every basis, with and without lines, \
         plain and colour-exact; one step of undo."
    );
    asked.automatic = pressed_if(ui, !busy, button, meaning);
    let count = drag_value(budget).range(SPENDABLE).speed(0.1);
    number(ui, count, said(names::BUDGET))
        .on_hover_text(said!("Most numbers that Automatic may spend, 1 to 101."));
    // In a narrow window the buttons need the room.
    if ui.available_width() >= 170.0 * theme.scale {
        ui.label(said(NUMBERS));
    }
    let meaning = said!("Basis, colour-exact, widest line, dark lines, range, observer, products.");
    asked.more = pressed(ui, said(names::MORE), meaning);
    let meaning = said!("Model, layers and surfaces back to the start (R).");
    asked.reset = pressed(ui, said(names::RESET), meaning);
}
