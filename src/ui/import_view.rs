//! "How lamp.csv was read": the first rows, every decision as a row of answers to click, and the
//! curve. It stands over the plot and blocks nothing.

use std::sync::Arc;

use eframe::egui;
use egui::{Context, Key, Rect, RichText, ScrollArea, Ui, Vec2, vec2};

use super::{
    chart_view::{ChartView, ChartWish},
    theme::Theme,
};
use crate::app::{
    App,
    charts::import::curves,
    import::{Again, Flip, Head, Import, Question},
    opened::Opened,
    plot_svg::{self, Chart},
};

/// What was asked for.
pub enum Wish {
    /// Another answer.
    Flip(Flip),
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
    chart: Option<(Arc<Opened>, plot_svg::Theme, Chart)>,
    /// Tells the windows of different files apart: each comes up in its place.
    turn: u64,
}

/// The window's width, points; narrower where the plot is.
const WIDTH: f32 = 720.0;

/// Its height where the plot has room for it.
const HEIGHT: f32 = 540.0;

/// Largest height of the table, least and largest of the chart, and that of the buttons, points.
const TABLE: f32 = 152.0;
const CHART: [f32; 2] = [170.0, 460.0];
const BUTTONS: f32 = 30.0;

/// Width of what is asked, before the answers, points.
const LABEL: f32 = 118.0;

/// Width from which the curve stands beside the table, points, and the table's share of it.
const BESIDE: f32 = 520.0;
const TABLE_SHARE: f32 = 0.42;

impl ImportView {
    /// Shows another file.
    pub fn open(&mut self, import: Option<Import>) {
        if import.is_some() {
            self.now = import;
            self.chart = None;
            self.turn += 1;
        }
    }

    /// Closes it; what was looked at is handed out.
    pub fn close(&mut self) -> Option<Import> {
        self.chart = None;
        self.now.take()
    }

    /// Draws it within a part of the window.
    pub fn show(
        &mut self,
        context: &Context,
        app: &App,
        theme: Theme,
        file_theme: plot_svg::Theme,
        within: Rect,
        keys_are_free: bool,
    ) -> Vec<Wish> {
        if self.now.as_mut().is_some_and(|import| !import.follow(app)) {
            self.close();
        }
        let Some(import) = &self.now else {
            return Vec::new();
        };
        let mut wishes = Vec::new();
        let mut open = true;
        let opened = import.opened();
        let is_drawn = self
            .chart
            .as_ref()
            .is_some_and(|(of, theme, _)| Arc::ptr_eq(of, opened) && *theme == file_theme);
        if !is_drawn {
            let chart = curves(&opened.file, &opened.spectra, file_theme);
            self.chart = Some((opened.clone(), file_theme, chart));
        }
        let Some((_, _, chart)) = &self.chart else {
            return Vec::new();
        };
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
    let opened = import.opened();
    let questions = import.questions();
    let open_questions = questions.iter().filter(|q| q.doubtful).count();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        if open_questions > 0 {
            ui.colored_label(theme.warning, "▲");
            ui.label(match open_questions {
                1 => "The file leaves one thing open; click what is right.".to_owned(),
                n => format!("The file leaves {n} things open; click what is right."),
            });
        } else {
            ui.label("Nothing is open; any choice can still be turned round.");
        }
        let count = opened.spectra.len();
        ui.weak(format!(
            "{}, {count} {}, loaded already.",
            opened.format,
            if count == 1 { "spectrum" } else { "spectra" }
        ));
    });
    // What stands below the curve has its height; the curve gets the rest.
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let below = row * (questions.len() as f32 + if import.refusal().is_some() { 2.5 } else { 1.2 });
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
    if let Some(why) = import.refusal() {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.colored_label(theme.warning, "▲");
            ui.label(format!("Not read so: {why}. The last good reading stays."));
        });
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

/// One row of answers a question.
fn answers(ui: &mut Ui, questions: &[Question], theme: Theme, wishes: &mut Vec<Wish>) {
    for question in questions {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let size = vec2(LABEL * theme.scale, ui.spacing().interact_size.y);
            let left = egui::Layout::left_to_right(egui::Align::Center);
            ui.allocate_ui_with_layout(size, left, |ui| {
                ui.set_min_width(size.x);
                ui.label(question.what).on_hover_text(question.meaning);
            });
            for answer in &question.answers {
                let button = ui
                    .add(egui::Button::new(&answer.words).selected(answer.chosen))
                    .on_hover_text(question.meaning);
                let name = format!("{} {}", question.what, answer.words);
                button.widget_info(|| {
                    egui::WidgetInfo::selected(egui::Role::Button, true, answer.chosen, &name)
                });
                if button.clicked() && !answer.chosen {
                    wishes.push(Wish::Flip(answer.flip));
                }
            }
            if question.doubtful {
                ui.colored_label(theme.warning, "▲ doubtful:");
            }
            ui.small(RichText::new(&question.because).color(theme.faint));
        });
    }
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
                            for role in &head.roles {
                                ui.small(RichText::new(role.words()).strong());
                            }
                            if head.more_columns > 0 {
                                ui.small(format!("and {} more columns", head.more_columns));
                            }
                            ui.end_row();
                        }
                        if !head.titles.is_empty() {
                            for title in &head.titles {
                                ui.small(RichText::new(title).color(theme.faint));
                            }
                            ui.end_row();
                        }
                        for row in &head.rows {
                            for cell in row {
                                ui.small(RichText::new(cell).monospace());
                            }
                            ui.end_row();
                        }
                    });
            });
    });
}
