//! The page "Many lights": how few waves are enough for most lights of a set or a folder.

use eframe::egui;
use egui::{Ui, vec2};

use super::{
    PageContext, progress,
    race_view::{field_choice, has_own_lights, title_and_meaning},
};
use crate::{
    app::{
        App, ByAddress, Command, Memo, Settings,
        cells::Table,
        chart::Chart,
        charts::many::{Wanted, chart, rows, sentence, table},
        pages::{FieldChoice, ManyMemory},
        studies::{ManyAsk, Stage},
    },
    languages::said,
    study::{ManyLights, Measure},
    ui::kit::{self, Choice, Column, Row, form, headline, knob, number, scrolled, titled},
};

/// Names of controls, shared with the tests that move them.
pub(super) mod names {
    pub(crate) const LIGHTS: &str = later!("Lights that are looked at");
    pub(crate) const SHARE: &str = later!("Share of the lights");
    pub(crate) const LIMIT: &str = later!("Limit");
    pub(crate) const COPY: &str = later!("Copy all lights as CSV");
}

/// From this width on the table stands beside the chart, points.
const WIDE: f32 = 820.0;

#[derive(Default)]
pub(super) struct ManyView {
    shown: Memo<Key, Shown>,
}

/// What decides how a result is shown: the result, what is asked of it, the order, the looks.
type Key = (ByAddress<ManyLights>, ManyMemory, Settings);

struct Shown {
    sentence: String,
    chart: Chart,
    table: Table,
    columns: Vec<Column>,
    rows: Vec<Row>,
    /// The waves that the sentence tells.
    order: Option<usize>,
}

impl ManyView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let document = context.app.document();
        let memory = context.pages.many;
        let ask = ManyAsk::of(document, memory.field.field(document));
        let settings = document.settings;
        let nobody = memory.field == FieldChoice::Own && !has_own_lights(context);
        let job = context.studies.job();
        if !nobody {
            job.put(&ask, context.wake);
        }
        // What is still there where no answer can be had answers another question.
        let is_this = !nobody && job.stage() != Stage::Impossible;
        let answer = job.answer().filter(|_| is_this);
        let answer = answer.map(|(of, many)| (of.clone(), many.clone()));
        let Some((of, many)) = answer else {
            let words = match nobody {
                true => said!(
                    "There are no lights of your own: open a folder of them, or drop it here."
                ),
                false => said!("How many numbers do most of these lights need?"),
            };
            headline(ui, context.theme, words);
            controls(ui, context);
            if !nobody {
                let job = context.studies.of::<ManyAsk>();
                progress(ui, job, said!("Error against waves"));
            }
            return;
        };
        let key = (ByAddress(many.clone()), memory, settings);
        let app = context.app;
        let shown = &*self.shown.get(key, |(many, memory, _)| {
            Shown::of(app, (&of, &many.0), memory)
        });
        headline(ui, context.theme, &shown.sentence);
        controls(ui, context);
        let job = context.studies.of::<ManyAsk>();
        if job.stage() != Stage::Done {
            progress(ui, job, said!("Error against waves"));
        }
        if many.dark > 0 {
            ui.weak(tr!(
                "{dark} dark in this range, left out.",
                dark = many.dark
            ));
        }
        let room = ui.available_size();
        let scale = context.theme.scale;
        if room.x >= WIDE * scale {
            ui.horizontal_top(|ui| {
                let left = vec2((0.55 * room.x).floor(), room.y - 4.0);
                ui.vertical(|ui| {
                    ui.set_width(left.x);
                    context.chart(ui, &shown.chart, "many lights", left);
                });
                ui.add_space(8.0);
                ui.vertical(|ui| lights(ui, context, shown));
            });
        } else {
            let size = vec2(room.x, (0.5 * room.y).max(190.0 * scale));
            context.chart(ui, &shown.chart, "many lights", size);
            lights(ui, context, shown);
        }
    }
}

impl Shown {
    fn of(app: &App, (ask, many): (&ManyAsk, &ManyLights), memory: &ManyMemory) -> Self {
        let wanted = Wanted::of(app.document().settings, memory);
        let found = many.order_for(wanted.way, wanted.measure, wanted.limit, wanted.share);
        let classes = rows(many, wanted, app.document().settings.order);
        let table = table(app, ask, many, wanted);
        let name = |i: usize, cells: &[String]| names_of(&classes[i].light.class, cells);
        Self {
            sentence: sentence(many, wanted),
            chart: chart(many, wanted),
            rows: kit::rows(&table, name),
            columns: kit::columns(&table, &[2.6, 1.0, 0.9, 1.3, 1.3]),
            table,
            order: found.map(|(order, _)| order),
        }
    }
}

/// The light as it is read out, and its class.
fn names_of(class: &str, cells: &[String]) -> [String; 2] {
    let [name, order, lines, numbers, now] = [0, 1, 2, 3, 4].map(|i| &cells[i]);
    let words = match lines.as_str() {
        "1" => tr!(
            "{name}: {waves} waves, {lines} line, {numbers} numbers, now {now}",
            name,
            waves = order,
            lines,
            numbers,
            now
        ),
        _ => tr!(
            "{name}: {waves} waves, {lines} lines, {numbers} numbers, now {now}",
            name,
            waves = order,
            lines,
            numbers,
            now
        ),
    };
    [words, tr!("Listed under {class}.", class)]
}

/// Which lights, how good, for how many.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>) {
    form(ui, "many lights", |form| {
        let mut field = context.pages.many.field;
        let meaning = said!(
            "Shipped lights, or your own: all lights of the files and folders that you opened."
        );
        form.row((said!("Lights"), meaning), |ui, _| {
            field_choice(ui, context, (said(names::LIGHTS), meaning), &mut field);
            let settings = context.app.document().settings;
            let way = Wanted::of(settings, &context.pages.many).way;
            ui.weak(tr!(
                "{way}, as in the model.",
                way = crate::languages::said(way.title())
            ))
            .on_hover_text(said!(
                "Basis, fit, lines and range are the document's; change them there."
            ));
        });
        let memory = &mut context.pages.many;
        memory.field = field;
        form.row((said!("Good enough"), ""), |ui, _| {
            let figure = memory.measure.figure();
            let choice = Choice {
                name: said!("Figure with a limit"),
                meaning: figure.meaning(),
                width: 140.0,
            };
            let before = memory.measure;
            let all = Measure::COMPARED;
            choice.pick(ui, &mut memory.measure, all, title_and_meaning);
            if before.is_colour() != memory.measure.is_colour() {
                memory.limit = ManyMemory::usual_limit(memory.measure);
            }
            ui.label(said!("at most"));
            let tail = memory.measure.figure().unit.tail;
            let limit = knob::drag(&ManyMemory::LIMIT, memory)
                .speed(0.02)
                .suffix(tail);
            number(ui, limit, said(names::LIMIT))
                .on_hover_text(said!("Largest value of the figure that is good enough."));
            ui.label(tr!("for a share of the lights" => "for"));
            let share = knob::drag(&ManyMemory::SHARE, memory).speed(0.2);
            number(ui, share, said(names::SHARE)).on_hover_text(said!(
                "Share of the lights for which the waves must be enough."
            ));
            ui.label(said!("of them"));
        });
    });
    ui.add_space(2.0);
}

/// The lights with what each of them needs; a click takes a light.
fn lights(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Shown) {
    let app = context.app;
    let meaning = said!("Copies every light with the waves that it needs as a table.");
    titled(
        ui,
        said!("Needs of each light"),
        said(names::COPY),
        meaning,
        || shown.table.csv(),
    );
    if let Some(order) = shown.order {
        let settings = app.document().settings;
        let words = tr!("Take {n} wave" | "Take {n} waves" % order);
        let button = ui.add_enabled(settings.order != order, egui::Button::new(words));
        if button
            .on_disabled_hover_text(said!("The model has so many waves."))
            .clicked()
        {
            context
                .commands
                .push(Command::Edit(Settings { order, ..settings }));
        }
    }
    scrolled(ui, "lights that need", |ui| {
        kit::table(ui, &shown.columns, &shown.rows, None, false, context.theme);
    });
}
