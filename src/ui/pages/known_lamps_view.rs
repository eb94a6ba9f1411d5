//! The page "Known lamps": a light in few words, what they decode to, and what it is made of.

use crate::ui::kit::slide;
use eframe::egui;
use egui::{Label, RichText, Ui, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        ByAddress, Memo, WordsShown,
        chart::Chart,
        charts::known_lamps::words_chart,
        pages::WordsMemory,
        studies::{EncodeAsk, EncodedLight, most_numbers},
    },
    lamps::NUMBERS,
    ui::kit::{
        Column, GROUP, Row, Table, fold, headline, named, pressed_small, scrolled, two_columns,
    },
};

/// Room below the chart, points.
const BELOW: f32 = 176.0;
/// Least height of the chart, points: in a lower one the numbers at the axis of what it is off by
/// stand in each other's way.
const LEAST_CHART: f32 = 260.0;

#[derive(Default)]
pub(super) struct KnownLampsView {
    shown: Memo<Key, (WordsShown, Chart)>,
}

/// What decides how a result is shown.
type Key = ByAddress<Result<EncodedLight, String>>;

impl KnownLampsView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let WordsMemory {
            numbers,
            portable,
            itself,
            automatic: _,
        } = context.pages.known_lamps;
        let ask = EncodeAsk::of(context.app.document(), numbers, !portable, itself);
        let answer = context
            .put(&ask)
            .answer()
            .map(|(ask, found)| (ask.clone(), found.clone()));
        // What it says of another light would be wrong; of other numbers it stays until the next.
        let answer = answer.filter(|(of, _)| of.light == ask.light);
        let Some((of, found)) = answer else {
            controls(ui, context);
            let job = context.studies.of::<EncodeAsk>();
            progress(ui, job, said!("The makeup of the light"));
            return;
        };
        match &*found {
            Err(why) => {
                headline(ui, context.theme, why);
                controls(ui, context);
            }
            Ok(encoded) => {
                let name = of.light.0.name();
                let (words, chart) = &*self.shown.get(ByAddress(found.clone()), |_| {
                    let shown = WordsShown::of(name, encoded);
                    (shown, words_chart(name, encoded))
                });
                headline(ui, context.theme, &words.sentence);
                ui.add_space(GROUP);
                controls(ui, context);
                ui.add_space(GROUP);
                let room = ui.available_size();
                let below = BELOW * context.theme.scale;
                let least = LEAST_CHART * context.theme.scale;
                if room.y - below >= least {
                    let size = vec2(room.x, room.y - below);
                    context.chart(ui, chart, "known lamps", size);
                    scrolled(ui, "below known lamps", |ui| {
                        below_chart(ui, context, words)
                    });
                } else {
                    scrolled(ui, "known lamps in a low page", |ui| {
                        let size = vec2(ui.available_width(), least);
                        context.chart(ui, chart, "known lamps", size);
                        below_chart(ui, context, words);
                    });
                }
            }
        }
    }
}

/// How many numbers, and which lamps.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>) {
    let most = most_numbers(context.app.document().settings.band);
    let memory = &mut context.pages.known_lamps;
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Numbers"));
        let slider = ui
            .add(slide(&mut memory.numbers, NUMBERS[0]..=most))
            .on_hover_text(said!("The most words of 32 bits that the light may take."));
        named(&slider, egui::Role::Slider, said!("Numbers for the light"));
        ui.separator();
        let mut known = !memory.portable;
        ui.toggle_value(&mut known, said!("Known lamps"))
            .on_hover_text(said!(
                "Lets the light be made of lamps of the program's list: the words then need that \
                 list. Off: a short series and lines, which anybody can decode."
            ));
        memory.portable = !known;
        ui.add_enabled_ui(known, |ui| {
            ui.toggle_value(&mut memory.itself, said!("Itself too"))
                .on_hover_text(said!(
                    "A lamp of the list may be itself. Off: it is made of others, as a lamp that \
                     the program has never seen would be."
                ));
        });
    });
}

/// What it is off by, and the words.
fn below_chart(ui: &mut Ui, context: &mut PageContext<'_>, words: &WordsShown) {
    ui.add_space(4.0);
    let theme = context.theme;
    two_columns(
        ui,
        context,
        |ui, _| {
            let columns = [
                Column::words(
                    said!("off by"),
                    said!("Judged by what took no part in the choice."),
                    1.6,
                ),
                Column::numbers("", "", 1.0),
            ];
            let rows: Vec<Row> = words
                .figures
                .iter()
                .map(|figure| Row {
                    name: crate::languages::with_colon(figure.title, &figure.value),
                    cells: vec![figure.title.to_owned(), figure.value.clone()],
                    note: figure.meaning.to_owned(),
                    ..Row::default()
                })
                .collect();
            Table::dense(&columns, theme).show(ui, &rows, &mut |_, _, _| {});
        },
        |ui, _| {
            ui.horizontal(|ui| {
                ui.label(RichText::new(said!("The words")).strong());
                let meaning = said!(
                    "Copies them; \"spectral-explorer decode\" makes the spectrum of them again."
                );
                if pressed_small(ui, said!("Copy words"), meaning) {
                    ui.ctx().copy_text(words.words.clone());
                }
            });
            ui.weak(words.needs);
            if !words.lines.is_empty() {
                ui.add(Label::new(RichText::new(&words.lines).small()).wrap());
            }
            fold(ui, "words", said!("In hexadecimal"), |ui| {
                let text = RichText::new(&words.words).monospace().small();
                ui.add(Label::new(text).wrap());
            });
        },
    );
}
