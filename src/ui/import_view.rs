//! "How lamp.csv was read": the first rows, every decision as a row of answers to click, and the
//! curve. It stands over the plot and blocks nothing.

use std::sync::Arc;

use eframe::egui;
use egui::{
    Context, Key, Label, Rect, RichText, ScrollArea, Ui, Vec2, WidgetText, text::LayoutJob, vec2,
};

use super::{
    chart_view::{ChartView, ChartWish},
    kit::Choice,
    theme::{Theme, waker},
};
use crate::app::{
    App,
    chart::{self, Chart},
    charts::import::curves,
    import::{About, Again, Answer, Flip, Head, Import, Question},
    memo::{ByAddress, Memo},
    opened::Opened,
};
use crate::spectrum::SpectralImage;

/// What was asked for.
pub enum Wish {
    /// Another answer.
    Flip(Flip),
    /// The questions are to be about another part of the file.
    About(About),
    /// It is right as it is.
    Keep,
    /// The file's spectra go again.
    Remove,
    /// The chart's menu.
    Save(ChartWish),
}

/// The look at a file, if one is open.
#[derive(Default)]
pub struct ImportView {
    /// What is looked at.
    pub now: Option<Import>,
    /// A file that is being read to be looked at.
    pub again: Option<Again>,
    /// The chart and what it was made of.
    chart: Memo<(ByAddress<Opened>, chart::Theme), Chart>,
    /// Tells the windows of different files apart: each comes up in its place.
    turn: u64,
}

/// The window's width, points; narrower where the plot is.
const WIDTH: f32 = 1100.0;

/// Its height where the plot has room for it.
const HEIGHT: f32 = 820.0;

/// Largest height of the table, least and largest of the chart, and that of the buttons, points.
const TABLE: f32 = 152.0;
const CHART: [f32; 2] = [170.0, 560.0];
const BUTTONS: f32 = 30.0;

/// Width of what is asked, before the answers, points.
const LABEL: f32 = 118.0;

/// Width that a reason needs beside the answers, points; else it stands below them.
const REASON: f32 = 150.0;

/// Width from which the curve stands beside the table, points, and the table's share of it.
const BESIDE: f32 = 520.0;
const TABLE_SHARE: f32 = 0.42;

impl ImportView {
    /// Shows another file.
    pub fn open(&mut self, import: Option<Import>) {
        if import.is_some() {
            self.now = import;
            self.chart = Memo::default();
            self.turn += 1;
        }
    }

    /// Closes it; what was looked at is handed out.
    pub fn close(&mut self) -> Option<Import> {
        self.chart = Memo::default();
        self.now.take()
    }

    /// Draws it within a part of the window.
    pub fn show(
        &mut self,
        context: &Context,
        app: &App,
        theme: Theme,
        file_theme: chart::Theme,
        within: Rect,
        keys_are_free: bool,
    ) -> Vec<Wish> {
        let wake = waker(context);
        let is_gone = |import: &mut Import| !import.follow(app, &wake);
        if self.now.as_mut().is_some_and(is_gone) {
            self.close();
        }
        let Some(import) = &self.now else {
            return Vec::new();
        };
        let mut wishes = Vec::new();
        let mut open = true;
        let opened = import.opened();
        let of = (ByAddress(opened.clone()), file_theme);
        let chart = &*self
            .chart
            .get(of, |(opened, theme)| curves_of(&opened.0, *theme));
        let width = (WIDTH * theme.scale).min(within.width() - 24.0);
        let height = (HEIGHT * theme.scale).min(within.height() - 40.0);
        egui::Window::new(format!("How {} was read", opened.file))
            .id(egui::Id::unique(("how it was read", self.turn)))
            .open(&mut open)
            .default_pos(within.left_top() + vec2(6.0, 30.0))
            .default_size(vec2(width, height))
            .min_size(vec2(320.0, 200.0))
            .constrain_to(within.expand(8.0))
            .collapsible(true)
            .resizable(true)
            .show(context, |ui| {
                let buttons = BUTTONS * theme.scale;
                let room = (ui.available_height() - buttons).max(80.0);
                ScrollArea::vertical()
                    .auto_shrink(false)
                    .max_height(room)
                    .show(ui, |ui| {
                        body(ui, import, chart, theme, (self.turn, room), &mut wishes);
                    });
                foot(ui, import, &mut wishes);
            });
        let enter = keys_are_free
            && context.memory(|m| m.focused().is_none())
            && context.input(|i| i.key_pressed(Key::Enter));
        if !open || enter {
            wishes.push(Wish::Keep);
        }
        wishes
    }
}

fn body(
    ui: &mut Ui,
    import: &Import,
    chart: &Chart,
    theme: Theme,
    (turn, room): (u64, f32),
    wishes: &mut Vec<Wish>,
) {
    let top = ui.cursor().top();
    let questions = import.questions();
    headline(ui, import, &questions, theme);
    about(ui, import, theme, wishes);
    // What stands below the curve has its height; the curve gets the rest.
    let row = row_height(ui) + ui.spacing().item_spacing.y;
    let beside = |q: &&Question| stands_beside(ui, q, theme);
    let rows = 2 * questions.len() - questions.iter().filter(beside).count() + 1;
    let below = row * rows as f32 + 6.0;
    let [least, most] = CHART.map(|height| height * theme.scale);
    let height = (room - (ui.cursor().top() - top) - below).clamp(least, most);
    let width = ui.available_width();
    let mut flips = Vec::new();
    let narrow = width < BESIDE * theme.scale && !import.head().rows.is_empty();
    let mut curve = |ui: &mut Ui, size: Vec2| {
        if let Some(wish) = ChartView::show(ui, chart, ("import", turn), size, theme).wish {
            wishes.push(Wish::Save(wish));
        }
    };
    if import.head().rows.is_empty() {
        curve(ui, vec2(width, height));
    } else if narrow {
        // There is no room for everything: what can be clicked comes first.
        answers(ui, &questions, theme, &mut flips);
        table(ui, import.head(), theme, turn, TABLE * theme.scale);
        curve(ui, vec2(width, least));
    } else {
        let left = (TABLE_SHARE * width).round();
        ui.horizontal_top(|ui| {
            ui.allocate_ui(vec2(left, height), |ui| {
                ui.set_width(left);
                ui.vertical(|ui| table(ui, import.head(), theme, turn, height));
            });
            ui.vertical(|ui| curve(ui, vec2(ui.available_width(), height)));
        });
    }
    ui.add_space(2.0);
    if !narrow {
        answers(ui, &questions, theme, &mut flips);
    }
    wishes.append(&mut flips);
    message(ui, import, theme);
}

/// The curves of a file; of images a few of their pixels.
fn curves_of(opened: &Opened, theme: chart::Theme) -> Chart {
    if opened.images.is_empty() {
        return curves(&opened.file, &opened.spectra, theme);
    }
    let pixels_of = |image: &Arc<SpectralImage>| {
        let mut pixels = image.probes();
        for pixel in &mut pixels {
            if let Some(place) = pixel.name.strip_prefix(&format!("{}, ", image.name)) {
                pixel.name = place.to_owned();
            }
        }
        pixels
    };
    let pixels: Vec<_> = opened.images.iter().flat_map(pixels_of).collect();
    Chart {
        title: format!("Some pixels of {}", opened.file),
        ..curves(&opened.file, &pixels, theme)
    }
}

/// How much is open, and what was read, in a line.
fn headline(ui: &mut Ui, import: &Import, questions: &[Question], theme: Theme) {
    let opened = import.opened();
    let here = questions.iter().filter(|q| q.doubtful).count();
    let elsewhere = import.parts().iter().filter(|part| part.doubtful).count();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let words = match (here, elsewhere) {
            (0, 0) => "Nothing is open; any choice can still be turned round.".to_owned(),
            (0, _) => "Nothing is open here; see the other spectra of the file.".to_owned(),
            (1, _) => "The file leaves one thing open; click what is right.".to_owned(),
            (n, _) => format!("The file leaves {n} things open; click what is right."),
        };
        if here + elsewhere > 0 {
            ui.colored_label(theme.warning, "▲");
        }
        ui.label(words);
        let many = |count: usize, one: &str, more: &str| match count {
            0 => String::new(),
            1 => format!(", 1 {one}"),
            n => format!(", {n} {more}"),
        };
        let brought = format!(
            "{}{}{}, loaded already.",
            opened.format,
            many(opened.spectra.len(), "spectrum", "spectra"),
            many(opened.images.len(), "image", "images"),
        );
        ui.add(Label::new(RichText::new(brought).weak()).truncate());
    });
}

/// Which of the file's spectra are asked about, where there are several.
fn about(ui: &mut Ui, import: &Import, theme: Theme, wishes: &mut Vec<Wish>) {
    let parts = import.parts();
    if parts.is_empty() {
        return;
    }
    let what = "Asked about";
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        label(
            ui,
            what,
            "Which spectra the answers about values go for.",
            true,
            theme,
        );
        let choice = Choice {
            name: what,
            meaning: "The answers about values go for these spectra alone; each spectrum of the \
                      file has its own.",
            width: 300.0,
        };
        choice.cut(ui, import.about_words(), |ui| {
            for part in parts {
                let mark = if part.doubtful { "▲ " } else { "" };
                let words = format!("{mark}{}", part.words);
                let chosen = part.about == import.about();
                if ui.selectable_label(chosen, words).clicked() {
                    wishes.push(Wish::About(part.about));
                }
            }
        });
    });
}

/// The place of what could not be done: always there, so that nothing moves.
fn message(ui: &mut Ui, import: &Import, theme: Theme) {
    let size = vec2(ui.available_width(), row_height(ui));
    let layout = egui::Layout::left_to_right(egui::Align::Min);
    ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_min_size(size);
        ui.spacing_mut().item_spacing.x = 4.0;
        let width = ui.available_width() - 20.0;
        match import.refusal() {
            Some(why) => {
                ui.colored_label(theme.warning, "▲");
                let words = format!("Not read so: {why}. The last good reading stays.");
                two_lines(ui, &words, ui.visuals().text_color(), width);
            }
            None => two_lines(ui, "Every answer is one step of Undo.", theme.faint, width),
        }
    });
}

/// Height of a row of answers with its reason: two small lines, or a button.
fn row_height(ui: &Ui) -> f32 {
    let line = ui.text_style_height(&egui::TextStyle::Small);
    (2.0 * line + 1.0).max(ui.spacing().interact_size.y)
}

/// Small text in at most two lines; all of it in its tooltip where it is longer.
fn two_lines(ui: &mut Ui, text: &str, colour: egui::Color32, width: f32) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let mut job = LayoutJob::simple(text.to_owned(), font, colour, width.max(40.0));
    job.wrap.max_rows = 2;
    let galley = ui.painter().layout_job(job);
    let is_cut = galley.elided;
    let label = ui.add(Label::new(WidgetText::Galley(galley)));
    if is_cut {
        label.on_hover_text(text);
    }
}

/// The buttons that end it.
fn foot(ui: &mut Ui, import: &Import, wishes: &mut Vec<Wish>) {
    ui.horizontal(|ui| {
        if ui
            .button("Keep")
            .on_hover_text("It is right as it is: closes this window (Enter).")
            .clicked()
        {
            wishes.push(Wish::Keep);
        }
        if ui
            .add_enabled(
                import.has_choices(),
                egui::Button::new("Back to the reader's own choice"),
            )
            .on_hover_text("Forgets what was chosen here.")
            .clicked()
        {
            wishes.push(Wish::Flip(Flip::ReadersOwn));
        }
        if ui
            .button("Remove it again")
            .on_hover_text("Takes the file's spectra out and shows what was there before.")
            .clicked()
        {
            wishes.push(Wish::Remove);
        }
        if import.is_reading() {
            ui.spinner();
            ui.label("reading it again");
        }
    });
}

/// One row of answers a question; rows keep their height whatever is answered.
fn answers(ui: &mut Ui, questions: &[Question], theme: Theme, wishes: &mut Vec<Wish>) {
    for question in questions {
        let beside = stands_beside(ui, question, theme);
        let size = vec2(ui.available_width(), row_height(ui));
        let layout = egui::Layout::left_to_right(egui::Align::Center);
        ui.allocate_ui_with_layout(size, layout, |ui| {
            ui.set_min_height(size.y);
            ui.spacing_mut().item_spacing.x = 4.0;
            label(ui, question.what, question.meaning, question.applies, theme);
            if beside {
                buttons(ui, question, wishes);
                reason(ui, question, theme);
            } else {
                ui.horizontal_wrapped(|ui| buttons(ui, question, wishes));
            }
        });
        if !beside {
            ui.horizontal(|ui| {
                ui.set_min_height(row_height(ui));
                ui.add_space(LABEL * theme.scale + 4.0);
                reason(ui, question, theme);
            });
        }
    }
}

/// What is asked, in the width that all rows give it.
fn label(ui: &mut Ui, what: &str, meaning: &str, applies: bool, theme: Theme) {
    let size = vec2(LABEL * theme.scale, ui.spacing().interact_size.y);
    let left = egui::Layout::left_to_right(egui::Align::Center);
    ui.allocate_ui_with_layout(size, left, |ui| {
        ui.set_min_width(size.x);
        ui.add_enabled(applies, Label::new(what))
            .on_hover_text(meaning);
    });
}

/// About what the buttons of a row take.
fn buttons_width(ui: &Ui, question: &Question) -> f32 {
    let font = egui::TextStyle::Button.resolve(ui.style());
    let padding = 2.0 * ui.spacing().button_padding.x + 4.0;
    let width = |answer: &Answer| {
        let text = answer.words.clone();
        let galley = ui
            .painter()
            .layout_no_wrap(text, font.clone(), egui::Color32::WHITE);
        galley.size().x + padding
    };
    question.answers.iter().map(width).sum()
}

/// Whether the reason has room beside the answers.
fn stands_beside(ui: &Ui, question: &Question, theme: Theme) -> bool {
    let needs = LABEL * theme.scale + buttons_width(ui, question);
    ui.available_width() - needs >= REASON * theme.scale
}

fn buttons(ui: &mut Ui, question: &Question, wishes: &mut Vec<Wish>) {
    for answer in &question.answers {
        let button = egui::Button::new(&answer.words).selected(answer.chosen);
        let button = ui
            .add_enabled(question.applies, button)
            .on_hover_text(question.meaning);
        let name = format!("{} {}", question.what, answer.words);
        button.widget_info(|| {
            let enabled = question.applies;
            egui::WidgetInfo::selected(egui::Role::Button, enabled, answer.chosen, &name)
        });
        if button.clicked() && !answer.chosen {
            wishes.push(Wish::Flip(answer.flip));
        }
    }
}

/// Why a question was answered as it is.
fn reason(ui: &mut Ui, question: &Question, theme: Theme) {
    let width = ui.available_width();
    if question.doubtful {
        let words = format!("▲ doubtful: {}", question.because);
        two_lines(ui, &words, theme.warning, width);
    } else {
        two_lines(ui, &question.because, theme.faint, width);
    }
}

/// How many of the shown columns the width has room for, two at least.
fn columns_that_fit(ui: &Ui, head: &Head) -> usize {
    let letter = 0.5 * ui.text_style_height(&egui::TextStyle::Small);
    let mut left = ui.available_width() - 8.0;
    (0..head.width())
        .take_while(|column| {
            let cells = head.rows.iter().chain([&head.titles]);
            let cells = cells.filter_map(|row| row.get(*column));
            let longest = cells.map(|cell| cell.chars().count()).max().unwrap_or(0);
            left -= letter * longest.max(9) as f32 + 14.0;
            *column < 2 || left >= 0.0
        })
        .count()
}

/// The first rows with what each column was taken for.
fn table(ui: &mut Ui, head: &Head, theme: Theme, turn: u64, height: f32) {
    let top = ui.cursor().top();
    if head.rows.is_empty() {
        return;
    }
    for line in &head.above {
        ui.add(egui::Label::new(RichText::new(line).small().color(theme.faint)).truncate());
    }
    if head.along_rows {
        ui.small("The wavelengths stand in a row, one spectrum in each row below.");
    }
    let columns = columns_that_fit(ui, head);
    let more = head.width() + head.more_columns - columns;
    if more > 0 && !head.along_rows {
        ui.small(format!(
            "The first {columns} columns, + {more} more columns"
        ));
    }
    let area = egui::Frame::new()
        .fill(ui.visuals().extreme_bg_color)
        .inner_margin(4)
        .corner_radius(3);
    area.show(ui, |ui| {
        ScrollArea::both()
            .id_salt(("rows", turn))
            .auto_shrink([false, true])
            .max_height((height - (ui.cursor().top() - top)).max(60.0))
            .show(ui, |ui| {
                egui::Grid::new(("first rows", turn))
                    .striped(true)
                    .min_row_height(12.0)
                    .spacing([14.0, 1.0])
                    .show(ui, |ui| {
                        if !head.along_rows {
                            for role in head.roles.iter().take(columns) {
                                ui.small(RichText::new(role.words()).strong());
                            }
                            ui.end_row();
                        }
                        if !head.titles.is_empty() {
                            for title in head.titles.iter().take(columns) {
                                ui.small(RichText::new(title).color(theme.faint));
                            }
                            ui.end_row();
                        }
                        for row in &head.rows {
                            for cell in row.iter().take(columns) {
                                ui.small(RichText::new(cell).monospace());
                            }
                            ui.end_row();
                        }
                    });
            });
    });
}
