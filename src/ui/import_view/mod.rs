//! "How lamp.csv was read": the first rows, every decision as a row of answers to click, and the
//! curve. It stands over the plot and blocks nothing.

mod answers;
mod table;

use std::sync::Arc;

use eframe::egui;
use egui::{Context, Key, Label, Rect, RichText, ScrollArea, Ui, Vec2, vec2};

use self::{
    answers::{answers, label, row_height, stands_beside, two_lines},
    table::table,
};
use super::{
    chart_view::{ChartView, ChartWish},
    kit::{Choice, bounded, pressed, pressed_if},
    theme::{Theme, waker},
};
use crate::app::{
    App, ByAddress, Memo, Opened,
    chart::Chart,
    charts::import::curves,
    import::{About, Again, Flip, Import, Question},
};
use crate::spectrum::SpectralImage;

/// What was asked for.
pub(super) enum Wish {
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
pub(super) struct ImportView {
    /// What is looked at.
    pub now: Option<Import>,
    /// A file that is being read to be looked at.
    pub again: Option<Again>,
    /// The chart and what it was made of.
    chart: Memo<ByAddress<Opened>, Chart>,
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

/// Width from which the curve stands beside the table, points, and the table's share of it.
const BESIDE: f32 = 520.0;
const TABLE_SHARE: f32 = 0.42;

impl ImportView {
    /// Shows another file.
    pub(super) fn open(&mut self, import: Option<Import>) {
        if import.is_some() {
            self.now = import;
            self.chart = Memo::default();
            self.turn += 1;
        }
    }

    /// Closes it; what was looked at is handed out.
    pub(super) fn close(&mut self) -> Option<Import> {
        self.chart = Memo::default();
        self.now.take()
    }

    /// Draws it within a part of the window.
    pub(super) fn show(
        &mut self,
        context: &Context,
        app: &App,
        theme: Theme,
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
        let of = ByAddress(opened.clone());
        let chart = &*self.chart.get(of, |opened| curves_of(&opened.0));
        let width = (WIDTH * theme.scale).min(within.width() - 24.0);
        let height = (HEIGHT * theme.scale).min(within.height() - 40.0);
        egui::Window::new(tr!("How {file} was read", file = opened.file))
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
    let height = bounded(room - (ui.cursor().top() - top) - below, least, most);
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
fn curves_of(opened: &Opened) -> Chart {
    if opened.images.is_empty() {
        return curves(&opened.file, &opened.spectra);
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
        title: tr!("Some pixels of {file}", file = opened.file),
        ..curves(&opened.file, &pixels)
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
            (0, 0) => said!("Nothing is open; any choice can still be turned round.").to_owned(),
            (0, _) => said!("Nothing is open here; see the other spectra of the file.").to_owned(),
            (1, _) => said!("The file leaves one thing open; click what is right.").to_owned(),
            (n, _) => tr!("The file leaves {n} things open; click what is right.", n),
        };
        if here + elsewhere > 0 {
            ui.colored_label(theme.warning, "▲");
        }
        ui.label(words);
        let (spectra, images) = (opened.spectra.len(), opened.images.len());
        let spectra = (spectra > 0).then(|| tr!("{n} spectrum" | "{n} spectra" % spectra));
        let images = (images > 0).then(|| tr!("{n} image" | "{n} images" % images));
        let format = std::iter::once(opened.format.to_string());
        let brought: Vec<String> = format.chain(spectra).chain(images).collect();
        let brought = tr!("{brought}, loaded already.", brought = brought.join(", "));
        ui.add(Label::new(RichText::new(brought).weak()).truncate());
    });
}

/// Which of the file's spectra are asked about, where there are several.
fn about(ui: &mut Ui, import: &Import, theme: Theme, wishes: &mut Vec<Wish>) {
    let parts = import.parts();
    if parts.is_empty() {
        return;
    }
    let what = said!("Asked about");
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        label(
            ui,
            what,
            said!("The spectra that the answers about values are for."),
            true,
            theme,
        );
        let choice = Choice {
            name: what,
            meaning: said!(
                "The answers about values go for these spectra alone; each spectrum of the file \
                 has its own."
            ),
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
                let words = tr!(
                    "That way it cannot be read: {why}. The last good reading stays.",
                    why
                );
                two_lines(ui, &words, ui.visuals().text_color(), width);
            }
            None => two_lines(
                ui,
                said!("Every answer is one step of Undo."),
                theme.faint,
                width,
            ),
        }
    });
}

/// The buttons that end it.
fn foot(ui: &mut Ui, import: &Import, wishes: &mut Vec<Wish>) {
    ui.horizontal(|ui| {
        let meaning = said!("It is right as it is: closes this window (Enter).");
        if pressed(ui, said!("Keep"), meaning) {
            wishes.push(Wish::Keep);
        }
        let back = egui::Button::new(said!("Back to the reader's own choice"));
        let meaning = said!("Forgets what was chosen here.");
        if pressed_if(ui, import.has_choices(), back, meaning) {
            wishes.push(Wish::Flip(Flip::ReadersOwn));
        }
        let meaning = said!("Takes the file's spectra out and shows what was there before.");
        if pressed(ui, said!("Remove it again"), meaning) {
            wishes.push(Wish::Remove);
        }
        if import.is_reading() {
            ui.label(said!("reading it again"));
        }
    });
}
