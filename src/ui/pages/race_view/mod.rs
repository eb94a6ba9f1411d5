//! The page "Race": the composite beside other representations, at equal counts of numbers.

mod halves;
mod table;
mod ways;
mod winners;

use std::sync::Arc;

use eframe::egui;
use egui::{Ui, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        ByAddress, Memo,
        chart::{Chart, Marks},
        charts::race::{
            Half, RaceCell, RaceTable, Winners, ahead, error_chart, halves, looks, strip_chart,
            table_chart,
        },
        pages::{FieldChoice, RACE_BUDGETS},
        studies::{RaceAsk, Stage},
    },
    languages::said,
    spectrum::Kind,
    study::{Measure, Race, race::Racer},
    ui::{
        chart_view::{ChartForm, ChartView, ChartWish},
        kit::{Choice, Column, GROUP, Look, Table, bar, fold, headline, named, rolled},
        theme::{Theme, section},
    },
};

/// What people and tests call the folds.
mod names {
    pub(super) const TABLE: &str = later!("Every figure at this count");
    pub(super) const WAYS: &str =
        later!("How far known lamps and lines of their own width are ahead");
    pub(super) const NUMBERS: &str = later!("Errors against numbers, and who wins");
}

/// Height of the folds while they are shut, points.
const FOLDS: f32 = 84.0;

/// The page is laid out in two columns from this width on, points.
const WIDE: f32 = 1150.0;

/// Width of the winners beside the chart, points.
const WINNERS: f32 = 672.0;

#[derive(Default)]
pub(super) struct RaceView {
    /// The class shown where several race; all of them without one.
    class: Option<String>,
    shown: Memo<Key, Shown>,
    ways: ways::WaysView,
    /// Costs are shown in place of errors, where there is no room for both.
    costs: bool,
}

/// What decides how a result is shown: the race, the class, which count, the figure, the looks.
type Key = (ByAddress<Race>, Option<String>, usize, Measure);

/// What is made once for a result and a choice.
struct Shown {
    words: String,
    strip: Chart,
    chart: Chart,
    table: table::TableRows,
    winners: winners::WinnerRows,
    halves: Option<Vec<Half>>,
}

impl Shown {
    fn of(ask: &RaceAsk, (race, class, budget, measure): &Key) -> Self {
        let (race, class) = (&race.0, class.as_deref());
        let table = RaceTable::new(race, class, *budget, *measure);
        let winners = Winners::new(ask, race, *budget, *measure);
        let at = (class, *budget);
        Self {
            words: ahead(ask, race, at, *measure),
            strip: strip_chart(ask, race, at, *measure),
            chart: error_chart(ask, race, class, *measure),
            table: table::TableRows::of(&table),
            winners: winners::WinnerRows::of(winners),
            halves: halves(ask, race, *budget),
        }
    }
}

impl RaceView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let document = context.app.document();
        let field = context.pages.race.field;
        let nobody = field == FieldChoice::Own && !has_own_lights(context);
        if nobody {
            self.controls(ui, context);
            ui.weak(said!(
                "There are no lights of your own: open or drop a file, or choose other lights."
            ));
            return;
        }
        let ask = RaceAsk {
            strict: context.pages.race.strict,
            ..RaceAsk::of(document, field.field(document), RACE_BUDGETS.to_vec())
        };
        if let Some(why) = ask.why_not() {
            self.controls(ui, context);
            ui.weak(tr!("The race is not run: {reason}.", reason = why));
            return;
        }
        let race = context.put(&ask);
        progress(ui, race, said!("The race"));
        let is_impossible = race.stage() == Stage::Impossible;
        let answer = race.answer();
        let answer = answer.map(|(ask, race)| (ask.clone(), race.clone()));
        // What is still there of an impossible one answers another question.
        let Some((ask, race)) = answer.filter(|_| !is_impossible) else {
            self.controls(ui, context);
            return;
        };
        self.result(ui, context, (&ask, &race));
    }

    /// Who races, on how many numbers, and what decides.
    fn controls(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let light = context.app.document().light.name().to_owned();
        let about_light = context.app.document().is_about_light();
        ui.horizontal_wrapped(|ui| {
            ui.label(said!("Lights"));
            let meaning = if about_light {
                tr!(
                    "{light} alone, or many lights together with their spread.",
                    light
                )
            } else {
                tr!("Only lights race; of this document it is {light}.", light)
            };
            let mut field = context.pages.race.field;
            field_choice(
                ui,
                context,
                (said!("Lights that race"), &meaning),
                &mut field,
            );
            context.pages.race.field = field;
            if let Some((_, race)) = context.studies.of::<RaceAsk>().answer() {
                self.class_menu(ui, race);
            }
        });
        let memory = &mut context.pages.race;
        ui.horizontal_wrapped(|ui| {
            ui.label(said!("Numbers"));
            for budget in RACE_BUDGETS {
                let chosen = &mut memory.numbers;
                let button = ui
                    .selectable_value(chosen, budget, budget.to_string())
                    .on_hover_text(said!(
                        "Numbers that each may spend on a light: a line costs two, anything else \
                         one."
                    ));
                named(
                    &button,
                    egui::Role::Button,
                    &tr!("{n} number" | "{n} numbers" % budget),
                );
            }
            ui.separator();
            ui.label(said!("By"));
            let choice = Choice {
                name: said!("Deciding figure"),
                meaning: said!("The figure that the chart shows and that decides who wins."),
                width: 140.0,
            };
            let decides = |measure: &Measure| *measure != Measure::PatchesWorst;
            let all = Measure::COMPARED.into_iter().filter(decides);
            choice.pick(ui, &mut memory.measure, all, title_and_meaning);
        });
        if !about_light && context.pages.race.field == FieldChoice::ThisLight {
            ui.weak(tr!(
                "Only lights race: this is {light}, the light in force.",
                light
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
        ui.label(said!("Class"));
        let all = || said!("all").to_owned();
        let choice = Choice {
            name: said!("Class of lights"),
            meaning: said!("Lights whose medians table and chart show."),
            width: 90.0,
        };
        choice.show(ui, self.class.clone().unwrap_or_else(all), |ui| {
            ui.selectable_value(&mut self.class, None, said!("all"));
            for class in classes {
                let count = race.of_class(Some(class)).count();
                let chosen = Some(class.to_owned());
                ui.selectable_value(&mut self.class, chosen, format!("{class} ({count})"));
            }
        });
    }

    fn result(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (ask, race): (&RaceAsk, &Arc<Race>),
    ) {
        let numbers = context.pages.race.numbers;
        let Some(budget) = race.budgets.iter().position(|n| *n == numbers) else {
            return;
        };
        let key = (
            ByAddress(race.clone()),
            self.class.clone(),
            budget,
            context.pages.race.measure,
        );
        self.shown.get(key, |key| Shown::of(ask, key));
        let words = self.shown.held().map_or("", |shown| shown.words.as_str());
        headline(ui, context.theme, words);
        ui.add_space(GROUP);
        self.controls(ui, context);
        ui.add_space(GROUP);
        let Some(drawn) = self.shown.held() else {
            return;
        };
        let class = self.class.as_deref();
        let (theme, ways, costs) = (context.theme, &mut self.ways, &mut self.costs);
        // Measured outside: what is scrolled must not grow by what it was scrolled.
        let room = ui.available_height() - FOLDS * theme.scale;
        rolled(ui, |ui| {
            let size = vec2(ui.available_width(), room.max(240.0 * theme.scale));
            context.chart(ui, &drawn.strip, "race strip", size);
            fold(ui, "race table", said(names::TABLE), |ui| {
                table_head(ui, context, ask, race, class, budget);
                drawn.table.show(ui, theme, costs);
            });
            fold(ui, "race ways", said(names::WAYS), |ui| {
                ways.show(ui, context, (ask, race), (class, budget));
            });
            fold(ui, "race numbers", said(names::NUMBERS), |ui| {
                let height = (360.0 * theme.scale).max(240.0);
                let wide = ui.available_width() >= WIDE;
                let width = ui.available_width();
                if wide {
                    ui.horizontal_top(|ui| {
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
                    chart(ui, context, &drawn.chart, vec2(width, height));
                    ui.add_space(8.0);
                    drawn.winners.show(ui, context, 230.0 * theme.scale);
                }
                if let Some(halves) = &drawn.halves {
                    ui.add_space(8.0);
                    ui.separator();
                    halves::show(ui, halves);
                }
            });
            ui.add_space(6.0);
        });
    }
}

/// A list of sets of lights, called and explained so.
pub(super) fn field_choice(
    ui: &mut Ui,
    context: &PageContext<'_>,
    (name, meaning): (&str, &str),
    field: &mut FieldChoice,
) {
    let has_own = has_own_lights(context);
    let choice = Choice {
        name,
        meaning,
        width: 124.0,
    };
    choice.show(ui, field.title(), |ui| {
        for choice in FieldChoice::ALL {
            let can = choice != FieldChoice::Own || has_own;
            let item = egui::Button::selectable(*field == choice, choice.title());
            let response = ui
                .add_enabled(can, item)
                .on_disabled_hover_text(said!("There are none: open or drop a file with a light."));
            if response.clicked() {
                *field = choice;
            }
        }
    });
}

pub(super) fn has_own_lights(context: &PageContext<'_>) -> bool {
    let own = &context.app.document().own;
    own.iter().any(|entry| entry.kind() == Kind::Light)
}

/// What a figure is called, and what it counts.
pub(super) fn title_and_meaning(measure: Measure) -> (&'static str, &'static str) {
    (measure.figure().title(), measure.figure().meaning())
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
        (count, Some(class)) => tr!("{n} {class} light" | "{n} {class} lights" % count, class),
        (count, None) => tr!("{n} light" | "{n} lights" % count),
    };
    ui.horizontal_wrapped(|ui| {
        section(
            ui,
            &tr!(
                "{lights}, {n} number each" | "{lights}, {n} numbers each" % race.budgets[budget],
                lights = who
            ),
        );
        ui.weak(said!("★ least error of a column"));
        for (words, form, tip) in [
            (
                said!("Copy CSV"),
                ChartForm::CopyCsv,
                said!("Copies this table."),
            ),
            (
                said!("Save CSV…"),
                ChartForm::Csv,
                said!("Saves this table as a file."),
            ),
        ] {
            if ui.small_button(words).on_hover_text(tip).clicked() {
                let table = table_chart(ask, race, class, budget);
                context.ask_for_chart(Some(ChartWish::new(&table, form)));
            }
        }
    });
}

fn chart(ui: &mut Ui, context: &mut PageContext<'_>, chart: &Chart, size: egui::Vec2) {
    if chart.series.is_empty() {
        ui.weak(said!(
            "This figure does not exist in this range: there is no visible light in it."
        ));
        return;
    }
    let response = ChartView::show(ui, chart, "race errors", size, context.theme);
    if let Some(mut wish) = response.wish {
        if matches!(wish.form, ChartForm::CopyCsv | ChartForm::Csv) {
            // Each racer is drawn twice, as a line and as points: once is enough in a table.
            let is_line = |marks: &Marks| matches!(marks, Marks::Line { .. });
            wish.chart.series.retain(|series| !is_line(&series.marks));
        }
        context.ask_for_chart(Some(wish));
    }
}

/// Width of a column at the theme's type.
fn scaled(width: f32, theme: Theme) -> f32 {
    width * theme.scale
}

/// A bar that shows that there is more to the side, where rows leave no room to one that floats.
fn solid_bars(ui: &mut Ui) {
    ui.spacing_mut().scroll = egui::style::ScrollStyle {
        bar_width: 6.0,
        ..egui::style::ScrollStyle::solid()
    };
}

/// A table of as much as there is, which scrolls to the side where there is no room for all of it.
fn sideways(
    ui: &mut Ui,
    (id, shrinks): (&str, bool),
    columns: &[Column],
    theme: Theme,
    add: impl FnOnce(&mut Ui, Table<'_>),
) {
    let width: f32 = columns.iter().map(|column| column.share).sum();
    egui::ScrollArea::horizontal()
        .id_salt(id)
        .auto_shrink([shrinks, true])
        .show(ui, |ui| {
            ui.vertical(|ui| {
                ui.set_width(scaled(width, theme));
                add(ui, Table::dense(columns, theme));
            });
        });
}

/// What cells of the race say, and how: those that win have a sign.
fn starred<'a>(cells: impl Iterator<Item = &'a RaceCell>) -> (Vec<String>, Vec<Look>) {
    cells
        .map(|cell| match cell.wins {
            true => (format!("★ {}", cell.text), Look::Strong),
            false => (cell.text.clone(), Look::Plain),
        })
        .unzip()
}

/// A column of racers' names, each with its ink before it.
fn with_bar(title: &str, meaning: &str, share: f32) -> Column {
    Column {
        indent: 5.0,
        ..Column::words(title, meaning, share)
    }
}

/// The ink of a racer before its name.
fn winner_bar(ui: &Ui, cell: egui::Rect, racer: Racer, theme: Theme) {
    let (colour, ..) = looks(racer);
    bar(ui, cell, theme.ink(colour));
}
