//! The page "Race": the composite beside other representations, at equal counts of numbers.

mod larger;
mod table;
mod winners;

use std::sync::Arc;

use eframe::egui;
use egui::{Align, Label, Layout, Response, RichText, Ui, WidgetText, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        chart::{self, Chart, Marks},
        charts::race::{error_chart, table_chart},
        pages::{FieldChoice, RACE_BUDGETS},
        studies::{RaceAsk, Stage},
    },
    spectrum::Kind,
    study::{Measure, Race},
    ui::{
        chart_view::{ChartForm, ChartView, ChartWish},
        model_view::named,
        theme::{Theme, section},
    },
};

/// The page is laid out in two columns from this width on, points.
const WIDE: f32 = 1150.0;

/// Width of the winners beside the chart, points.
const WINNERS: f32 = 672.0;

/// The page and what it keeps from frame to frame.
#[derive(Default)]
pub struct RaceView {
    /// The class shown where several race; all of them without one.
    class: Option<String>,
    drawn: Option<Drawn>,
}

/// What is made once for a result and a choice.
struct Drawn {
    key: Key,
    chart: Chart,
    table: table::Table,
    winners: winners::Winners,
    larger: Option<larger::Larger>,
}

/// What decides how a result is shown.
#[derive(Clone)]
struct Key {
    /// Held, so that no later race can stand in its place.
    race: Arc<Race>,
    class: Option<String>,
    budget: usize,
    measure: Measure,
    theme: chart::Theme,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            race,
            class,
            budget,
            measure,
            theme,
        } = self;
        Arc::ptr_eq(race, &other.race)
            && *class == other.class
            && *budget == other.budget
            && *measure == other.measure
            && *theme == other.theme
    }
}

impl RaceView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        self.controls(ui, context);
        let document = context.app.document();
        let field = context.memory.field;
        let nobody = field == FieldChoice::Own && !has_own_lights(context);
        if nobody {
            ui.weak(
                "There are no lights of your own: open or drop a file, or choose other lights.",
            );
            return;
        }
        let ask = RaceAsk::of(document, field.field(document), RACE_BUDGETS.to_vec());
        let race = &mut context.studies.race;
        race.ask(&ask, context.wake, || {
            let ask = ask.clone();
            move |progress| ask.answer(progress)
        });
        progress(ui, race, "The race");
        if race.stage() == Stage::Impossible {
            // What is still there answers another question.
            return;
        }
        let Some((ask, race)) = race.answer().map(|(ask, race)| (ask.clone(), race.clone())) else {
            return;
        };
        self.result(ui, context, &ask, &race);
    }

    /// Who races, on how many numbers, and what decides.
    fn controls(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let has_own = has_own_lights(context);
        let light = context.app.document().light.name().to_owned();
        let about_light = context.app.document().is_about_light();
        let memory = &mut *context.memory;
        ui.horizontal_wrapped(|ui| {
            ui.label("Lights");
            let combo = egui::ComboBox::from_id_salt("race field")
                .selected_text(memory.field.title())
                .width(124.0)
                .show_ui(ui, |ui| {
                    for choice in FieldChoice::ALL {
                        let can = choice != FieldChoice::Own || has_own;
                        let item = egui::Button::selectable(memory.field == choice, choice.title());
                        let response = ui.add_enabled(can, item).on_disabled_hover_text(
                            "There are none: open or drop a file with a light.",
                        );
                        if response.clicked() {
                            memory.field = choice;
                        }
                    }
                });
            named(&combo.response, egui::Role::ComboBox, "Lights that race");
            combo.response.on_hover_text(if about_light {
                format!("Who races: {light} alone, or many lights together with their spread.")
            } else {
                format!("Only lights race; of this document it is {light}.")
            });
            if let Some((_, race)) = context.studies.race.answer() {
                self.class_menu(ui, race);
            }
        });
        ui.horizontal_wrapped(|ui| {
            ui.label("Numbers");
            for budget in RACE_BUDGETS {
                let button = ui
                    .selectable_label(memory.race_numbers == budget, budget.to_string())
                    .on_hover_text(
                        "How many numbers each may spend on a light: a spike costs two, anything \
                         else one.",
                    );
                named(&button, egui::Role::Button, &format!("{budget} numbers"));
                if button.clicked() {
                    memory.race_numbers = budget;
                }
            }
            ui.separator();
            ui.label("By");
            let combo = egui::ComboBox::from_id_salt("race measure")
                .selected_text(memory.race_measure.title())
                .width(140.0)
                .show_ui(ui, |ui| {
                    let decides = |measure: &Measure| *measure != Measure::PatchesWorst;
                    for measure in Measure::ALL.into_iter().filter(decides) {
                        ui.selectable_value(&mut memory.race_measure, measure, measure.title())
                            .on_hover_text(table::meaning(measure));
                    }
                });
            named(&combo.response, egui::Role::ComboBox, "Deciding figure");
            combo
                .response
                .on_hover_text("The figure that the chart shows and that decides who wins.");
        });
        if !about_light && context.memory.field == FieldChoice::ThisLight {
            ui.weak(format!(
                "Only lights race: this is {light}, the light in force."
            ));
        }
    }

    fn class_menu(&mut self, ui: &mut Ui, race: &Race) {
        let classes = race.classes();
        if self.class.as_deref().is_some_and(|c| !classes.contains(&c)) {
            self.class = None;
        }
        if classes.len() < 2 {
            return;
        }
        ui.separator();
        ui.label("Class");
        let all = || "all".to_owned();
        let combo = egui::ComboBox::from_id_salt("race class")
            .selected_text(self.class.clone().unwrap_or_else(all))
            .width(90.0)
            .show_ui(ui, |ui| {
                ui.selectable_value(&mut self.class, None, "all");
                for class in classes {
                    let count = race.of_class(Some(class)).count();
                    ui.selectable_value(
                        &mut self.class,
                        Some(class.to_owned()),
                        format!("{class} ({count})"),
                    );
                }
            });
        named(&combo.response, egui::Role::ComboBox, "Class of lights");
        combo
            .response
            .on_hover_text("Whose medians table and chart show.");
    }

    fn result(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        ask: &RaceAsk,
        race: &Arc<Race>,
    ) {
        let numbers = context.memory.race_numbers;
        let Some(budget) = race.budgets.iter().position(|n| *n == numbers) else {
            return;
        };
        let key = Key {
            race: race.clone(),
            class: self.class.clone(),
            budget,
            measure: context.memory.race_measure,
            theme: context.chart_theme(),
        };
        if self.drawn.as_ref().map(|d| &d.key) != Some(&key) {
            let class = key.class.as_deref();
            self.drawn = Some(Drawn {
                chart: error_chart(ask, race, class, key.measure, key.theme),
                table: table::Table::new(race, class, budget, key.measure),
                winners: winners::Winners::new(ask, race, budget, key.measure),
                larger: larger::Larger::new(ask, race, budget),
                key,
            });
        }
        let Some(drawn) = &self.drawn else {
            return;
        };
        let theme = context.theme;
        egui::ScrollArea::vertical()
            .auto_shrink(false)
            .show(ui, |ui| {
                let class = drawn.key.class.as_deref();
                table_head(ui, context, ask, race, class, budget);
                drawn.table.show(ui, theme);
                ui.add_space(8.0);
                let wide = ui.available_width() >= WIDE;
                let height = (360.0 * theme.scale).max(240.0);
                if wide {
                    ui.horizontal_top(|ui| {
                        let width = ui.available_width();
                        let left = width - WINNERS.min(0.5 * width);
                        ui.vertical(|ui| {
                            chart(ui, context, &drawn.chart, vec2(left, height));
                        });
                        ui.add_space(8.0);
                        ui.vertical(|ui| {
                            drawn.winners.show(ui, context, height);
                        });
                    });
                } else {
                    let width = ui.available_width();
                    chart(ui, context, &drawn.chart, vec2(width, height));
                    ui.add_space(8.0);
                    drawn.winners.show(ui, context, 230.0 * theme.scale);
                }
                if let Some(larger) = &drawn.larger {
                    ui.add_space(8.0);
                    ui.separator();
                    larger.show(ui, theme);
                }
                ui.add_space(6.0);
            });
    }
}

fn has_own_lights(context: &PageContext<'_>) -> bool {
    let own = &context.app.document().own;
    own.iter().any(|entry| entry.kind() == Kind::Light)
}

fn table_head(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    ask: &RaceAsk,
    race: &Race,
    class: Option<&str>,
    budget: usize,
) {
    let count = race.of_class(class).count();
    let who = match (count, class) {
        (1, _) => {
            let lamp = race.of_class(class).next().unwrap_or(0);
            race.lamps[lamp].0.clone()
        }
        (count, Some(class)) => format!("{count} {class} lights"),
        (count, None) => format!("{count} lights"),
    };
    ui.horizontal_wrapped(|ui| {
        section(ui, &format!("{who}, {} numbers each", race.budgets[budget]));
        ui.weak("★ least error of a column");
        for (words, form, tip) in [
            ("Copy CSV", ChartForm::CopyCsv, "Copies this table."),
            ("Save CSV…", ChartForm::Csv, "Saves this table as a file."),
        ] {
            if ui.small_button(words).on_hover_text(tip).clicked() {
                let table = table_chart(ask, race, class, budget);
                context.wishes.push(ChartWish::new(&table, form));
            }
        }
    });
}

fn chart(ui: &mut Ui, context: &mut PageContext<'_>, chart: &Chart, size: egui::Vec2) {
    if chart.series.is_empty() {
        ui.weak("This figure does not exist in this range: there is no visible light in it.");
        return;
    }
    let response = ChartView::show(ui, chart, "race errors", size, context.theme);
    if let Some(mut wish) = response.wish {
        if matches!(wish.form, ChartForm::CopyCsv | ChartForm::Csv) {
            // Each racer is drawn twice, as a line and as points: once is enough in a table.
            let is_line = |marks: &Marks| matches!(marks, Marks::Line { .. });
            wish.chart.series.retain(|series| !is_line(&series.marks));
        }
        context.wishes.push(wish);
    }
}

/// Height of a line of a table, points.
fn line_height(ui: &Ui) -> f32 {
    (ui.text_style_height(&egui::TextStyle::Body) + 3.0).ceil()
}

/// Lines of [`line_height`] without gaps, and a bar that shows that there is more to the side.
fn dense(ui: &mut Ui) {
    let height = line_height(ui);
    let spacing = ui.spacing_mut();
    spacing.item_spacing.y = 0.0;
    spacing.interact_size.y = height;
    spacing.scroll = egui::style::ScrollStyle {
        bar_width: 6.0,
        ..egui::style::ScrollStyle::solid()
    };
}

/// A text in a column of fixed width.
fn cell(ui: &mut Ui, width: f32, text: impl Into<WidgetText>, right: bool) -> Response {
    let height = line_height(ui);
    let layout = if right {
        Layout::right_to_left(Align::Center)
    } else {
        Layout::left_to_right(Align::Center)
    };
    let size = vec2(width, height);
    ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_min_size(size);
        ui.add(Label::new(text).truncate())
    })
    .inner
}

/// A stripe behind every other line of a table.
fn stripe(ui: &Ui, index: usize, width: f32) {
    if index % 2 == 1 {
        let height = line_height(ui);
        let rect = egui::Rect::from_min_size(ui.cursor().min, vec2(width, height));
        let fill = ui.visuals().faint_bg_color;
        ui.painter().rect_filled(rect, 0.0, fill);
    }
}

/// Strong where a figure wins, with a sign beside it.
fn winning(text: &str, wins: bool) -> RichText {
    if wins {
        RichText::new(format!("★ {text}")).strong()
    } else {
        RichText::new(text)
    }
}

/// Width of a column at the theme's type.
fn scaled(width: f32, theme: Theme) -> f32 {
    width * theme.scale
}
