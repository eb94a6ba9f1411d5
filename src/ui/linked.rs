//! Texts whose words lead to the glossary: a click opens what the word means beside them.

use super::kit::kept;
use eframe::egui;
use egui::{
    Color32, CursorIcon, Galley, Id, Label, Pos2, Rect, RichText, Sense, Stroke, TextFormat, Ui,
    text::{CCursor, LayoutJob},
};

use super::{
    kit::{named, pressed},
    theme::Theme,
};
use crate::app::glossary::{self, Word};

/// Width of what a word means, points of usual type.
const WIDTH: f32 = 300.0;

/// The word that is open, and where it was clicked.
#[derive(Default)]
pub(super) struct Linked {
    open: Option<(&'static Word, Pos2)>,
    /// It was opened by the click of this frame, which is elsewhere for it.
    opens: bool,
    /// Words that have a link already.
    seen: Vec<&'static str>,
}

impl Linked {
    /// Forgets which words have links: a new page of text begins.
    pub(super) fn begin(&mut self) {
        self.seen.clear();
    }

    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub(super) fn close(&mut self) {
        self.open = None;
    }

    /// Draws a text; the first time that a word of the glossary stands in it, it is a link.
    pub(super) fn text(&mut self, ui: &mut Ui, text: &str, ink: Color32) -> Rect {
        // In other languages each form is looked up: once a text, not once a frame.
        let id = Id::unique("words of the glossary in").with(text);
        let find = || glossary::found_in(text);
        let mut links = kept(ui.ctx(), id, text.to_owned(), find);
        links.retain(|(_, word)| !self.seen.contains(&word.word));
        self.seen.extend(links.iter().map(|(_, word)| word.word));
        let font = egui::TextStyle::Body.resolve(ui.style());
        let plain = TextFormat::simple(font, ink);
        let under = TextFormat {
            underline: Stroke::new(1.0, ui.visuals().hyperlink_color),
            ..plain.clone()
        };
        let mut job = LayoutJob::default();
        let mut done = 0;
        for (at, _) in &links {
            job.append(&text[done..at.start], 0.0, plain.clone());
            job.append(&text[at.clone()], 0.0, under.clone());
            done = at.end;
        }
        job.append(&text[done..], 0.0, plain);
        let label = Label::new(job).wrap().selectable(false);
        let (corner, galley, response) = label.layout_in_ui(ui);
        named(&response, egui::Role::Label, text);
        for (at, word) in links {
            let chars = |byte: usize| text[..byte].chars().count();
            let runs = runs(&galley, chars(at.start), chars(at.end));
            for (row, run) in runs.into_iter().enumerate() {
                let rect = run.translate(corner.to_vec2());
                let id = response.id.with((word.word, row));
                let link = ui.interact(rect, id, Sense::click());
                if row == 0 {
                    named(
                        &link,
                        egui::Role::Link,
                        &tr!("Glossary: {word}", word = word.word()),
                    );
                }
                if link.has_focus() {
                    let stroke = ui.visuals().selection.stroke;
                    let outside = egui::StrokeKind::Outside;
                    ui.painter().rect_stroke(rect, 2.0, stroke, outside);
                }
                let link = link.on_hover_cursor(CursorIcon::PointingHand);
                if link.on_hover_text(said!("What it means.")).clicked() {
                    self.open = Some((word, rect.right_bottom()));
                    self.opens = true;
                }
            }
        }
        ui.painter().galley(corner, galley, ink);
        response.rect
    }

    /// Draws what the open word means, at the right of `column`; a click elsewhere closes it.
    pub(super) fn show(&mut self, context: &egui::Context, column: f32, theme: Theme) {
        let Some((word, at)) = self.open else { return };
        let area = egui::Area::new(Id::unique("word of the glossary"))
            .order(egui::Order::Foreground)
            .constrain(true)
            .fixed_pos(egui::pos2(column + 8.0, at.y));
        let mut back = false;
        let shown = area.show(context, |ui| {
            egui::Frame::popup(ui.style())
                .inner_margin(12)
                .show(ui, |ui| {
                    ui.set_width(WIDTH * theme.scale.min(1.5));
                    let strong = ui.visuals().strong_text_color();
                    ui.label(RichText::new(word.word()).color(strong).heading());
                    ui.add(Label::new(word.means()).wrap());
                    ui.add_space(4.0);
                    back = pressed(ui, said!("Back to the lesson"), said!("Closes this (Esc)."));
                });
        });
        let opens = std::mem::take(&mut self.opens);
        if back || shown.response.clicked_elsewhere() && !opens {
            self.close();
        }
    }
}

/// Where letters stand in a text that was laid out, a rectangle each row.
fn runs(galley: &Galley, from: usize, to: usize) -> Vec<Rect> {
    let place = |index: usize, prefer_next_row: bool| {
        galley.pos_from_cursor(CCursor {
            index: index.into(),
            prefer_next_row,
        })
    };
    let mut runs: Vec<Rect> = Vec::new();
    for index in from..to {
        let (left, right) = (place(index, true), place(index + 1, false));
        let letter = left.union(right);
        match runs.last_mut() {
            Some(run) if (run.top() - letter.top()).abs() < 1.0 => *run = run.union(letter),
            _ => runs.push(letter),
        }
    }
    runs
}
