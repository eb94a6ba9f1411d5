//! Who wins: per class and count, and per light.

use std::sync::Arc;

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{super::PageContext, cell, dense, line_height, scaled, stripe, table::about};
use crate::{
    app::{
        Command, Entry,
        charts::race::{figure, looks, short_name, shown_factor, spread_of},
        library::Library,
        studies::{Class, Field, RaceAsk},
        study_report::sets,
    },
    preset::Preset,
    spectrum::Kind,
    study::{Measure, Race, race::Racer},
    ui::{
        model_view::named,
        theme::{Theme, ink, section},
    },
};

/// Width of the classes' names, points.
const CLASSES: f32 = 74.0;

/// Width of a winner's short name, points.
const WINNER: f32 = 75.0;

/// A winner with its error in words.
#[derive(Clone)]
struct Won {
    racer: Option<Racer>,
    error: String,
}

/// A light of the race.
struct Lamp {
    name: String,
    class: String,
    won: Won,
    entry: Option<Arc<Entry>>,
}

/// All winners, found once.
pub struct Winners {
    measure: Measure,
    numbers: usize,
    budgets: Vec<usize>,
    /// A set's name with its count of lights and its winner at every count of numbers.
    sets: Vec<(String, usize, Vec<Won>)>,
    lamps: Vec<Lamp>,
}

impl Winners {
    /// The winners of a race, per light at one count.
    pub fn new(ask: &RaceAsk, race: &Race, budget: usize, measure: Measure) -> Self {
        let words = |error: Option<f64>| match error {
            Some(error) if measure.is_colour() => figure(error),
            Some(error) => format!("{} %", figure(shown_factor(measure) * error)),
            None => "–".to_owned(),
        };
        let place = |racer: Racer| race.racers.iter().position(|r| *r == racer);
        let sets = sets(race)
            .into_iter()
            .map(|(name, class)| {
                let class = class.as_deref();
                let won = (0..race.budgets.len())
                    .map(|budget| {
                        let racer = race.winner_of(class, budget, measure);
                        let spread = racer
                            .and_then(place)
                            .and_then(|place| spread_of(race, class, budget, place, measure));
                        Won {
                            racer,
                            error: words(spread.map(|s| s.median)),
                        }
                    })
                    .collect();
                (name, race.of_class(class).count(), won)
            })
            .collect();
        let lamps = race
            .lamps
            .iter()
            .enumerate()
            .map(|(i, (name, class))| {
                let racer = race.winner_on(i, budget, measure);
                let error = racer
                    .and_then(place)
                    .and_then(|place| measure.of(&race.run(i, budget, place).verdict));
                Lamp {
                    name: name.clone(),
                    class: class.clone(),
                    won: Won {
                        racer,
                        error: words(error),
                    },
                    entry: entry_of(&ask.field, race, i),
                }
            })
            .collect();
        Self {
            measure,
            numbers: race.budgets[budget],
            budgets: race.budgets.clone(),
            sets,
            lamps,
        }
    }

    /// Draws them within a height.
    pub fn show(&self, ui: &mut Ui, context: &mut PageContext<'_>, height: f32) {
        let theme = context.theme;
        let top = ui.cursor().top();
        self.classes(ui, theme);
        if self.lamps.len() < 2 {
            return;
        }
        ui.add_space(4.0);
        section(ui, &format!("Winner per light, {} numbers", self.numbers));
        let left = (height - (ui.cursor().top() - top)).max(140.0 * theme.scale);
        let row = line_height(ui);
        let width = ui.available_width().min(scaled(560.0, theme));
        let show_class = self.sets.len() > 1;
        egui::ScrollArea::vertical()
            .id_salt("race lamps")
            .max_height(left)
            .auto_shrink([false, true])
            .show_rows(ui, row, self.lamps.len(), |ui, rows| {
                dense(ui);
                for i in rows {
                    stripe(ui, i, ui.available_width());
                    self.lamp(ui, context, i, width, show_class);
                }
            });
    }

    fn classes(&self, ui: &mut Ui, theme: Theme) {
        section(ui, &format!("Least {}, by numbers", self.measure.title()));
        ui.scope(|ui| {
            dense(ui);
            egui::ScrollArea::horizontal()
                .id_salt("race classes")
                .auto_shrink([false, true])
                .show(ui, |ui| {
                    ui.vertical(|ui| {
                        ui.spacing_mut().item_spacing.x = 2.0;
                        ui.horizontal(|ui| {
                            cell(ui, scaled(CLASSES, theme), "", false);
                            for numbers in &self.budgets {
                                let title = RichText::new(numbers.to_string()).weak();
                                cell(ui, scaled(WINNER, theme), title, false)
                                    .on_hover_text("Numbers that each may spend.");
                            }
                        });
                        for (index, (set, count, won)) in self.sets.iter().enumerate() {
                            let whole = CLASSES + self.budgets.len() as f32 * (WINNER + 2.0);
                            stripe(ui, index + 1, scaled(whole, theme));
                            ui.horizontal(|ui| {
                                cell(ui, scaled(CLASSES, theme), set, false)
                                    .on_hover_text(lights(*count));
                                for won in won {
                                    winner(ui, won, scaled(WINNER, theme), theme);
                                }
                            });
                        }
                    });
                });
        });
    }

    fn lamp(
        &self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        index: usize,
        width: f32,
        show_class: bool,
    ) {
        let theme = context.theme;
        let lamp = &self.lamps[index];
        let [class, winner_width, error] = [80.0, 92.0, 64.0].map(|w| scaled(w, theme));
        let class = if show_class { class } else { 0.0 };
        let name = (width - class - winner_width - error - 30.0).max(90.0);
        ui.horizontal(|ui| {
            let present = context.app.document().light.name() == lamp.name;
            let height = line_height(ui);
            let left = egui::Layout::left_to_right(egui::Align::Center);
            let button = egui::Button::selectable(present, lamp.name.as_str()).truncate();
            let response = ui
                .allocate_ui_with_layout(vec2(name, height), left, |ui| {
                    ui.set_min_width(name);
                    ui.spacing_mut().button_padding = vec2(3.0, 0.0);
                    ui.spacing_mut().interact_size.y = height;
                    ui.add_enabled(lamp.entry.is_some(), button)
                })
                .inner;
            named(
                &response,
                egui::Role::Button,
                &format!("Show {} ({})", lamp.name, index + 1),
            );
            if response.clicked()
                && let Some(entry) = &lamp.entry
            {
                context.commands.push(Command::Show(entry.clone()));
            }
            response.on_hover_text(format!("{}: click to make it the light.", lamp.name));
            if show_class {
                cell(ui, class, RichText::new(&lamp.class).weak(), false);
            }
            winner(ui, &lamp.won, winner_width, theme);
            cell(ui, error, lamp.won.error.as_str(), true);
        });
    }
}

fn lights(count: usize) -> String {
    match count {
        1 => "One light.".to_owned(),
        n => format!("{n} lights; the least median wins."),
    }
}

fn winner(ui: &mut Ui, won: &Won, width: f32, theme: Theme) {
    match won.racer {
        None => {
            cell(ui, width, "–", false)
                .on_hover_text("This figure does not exist here: there is no visible light.");
        }
        Some(racer) => {
            let (colour, ..) = looks(racer, theme.inks);
            ui.scope(|ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let height = line_height(ui);
                let (rect, _) = ui.allocate_exact_size(vec2(3.0, height), egui::Sense::hover());
                ui.painter()
                    .rect_filled(rect.shrink2(vec2(0.0, 3.0)), 1.0, ink(colour));
                let text = RichText::new(short_name(racer)).small();
                cell(ui, width - 7.0, text, false).on_hover_text(format!(
                    "{}\nError {}.",
                    about(racer),
                    won.error
                ));
            });
        }
    }
}

/// The entry of the library, or of the user's own, that a light of the race came from.
fn entry_of(field: &Field, race: &Race, lamp: usize) -> Option<Arc<Entry>> {
    let name = &race.lamps[lamp].0;
    // Two tables of one name stand in the order in which they raced.
    let before = race.lamps[..lamp].iter().filter(|l| l.0 == *name).count();
    let shipped = |wanted: &dyn Fn(&Preset) -> bool| {
        let mut called = Library::bundled()
            .presets()
            .filter(|p| p.kind == Kind::Light && p.name == *name && p.line_list().is_none())
            .filter(|p| wanted(p));
        Entry::of_preset(called.nth(before)?).map(Arc::new)
    };
    match field {
        Field::One(entry) => Some(entry.0.clone()),
        Field::Shipped => shipped(&|_| true),
        Field::Class(class) => shipped(&|p| Class::of(p) == Some(*class)),
        Field::Group(group) => shipped(&|p| p.group == *group),
        Field::These(entries) => entries
            .iter()
            .filter(|entry| entry.0.name() == name)
            .nth(before)
            .map(|entry| entry.0.clone()),
    }
}
