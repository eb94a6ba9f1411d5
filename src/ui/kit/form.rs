//! Controls under their names, in two columns: a name at the right edge of the first, what it sets
//! in the second.

use eframe::egui;
use egui::{Align, Grid, Layout, Response, Slider, TextStyle, TextWrapMode, Ui, WidgetText, vec2};

use super::Choice;

/// Free space above a group of what belongs together, points.
pub const GROUP: f32 = 16.0;

/// Width of names, heights of a control: forms below each other line up.
const NAME: f32 = 4.6;

/// Rows of a form.
pub struct Form<'a> {
    ui: &'a mut Ui,
}

/// Draws a form; `id` tells it apart from others of the page.
pub fn form<R>(ui: &mut Ui, id: &str, add: impl FnOnce(&mut Form<'_>) -> R) -> R {
    Grid::new(id)
        .num_columns(2)
        .spacing([10.0, 6.0])
        .show(ui, |ui| add(&mut Form { ui }))
        .inner
}

impl Form<'_> {
    /// A row: its name, which may be empty, and what it sets. The name comes with it.
    pub fn row<R>(
        &mut self,
        (name, meaning): (&str, &str),
        add: impl FnOnce(&mut Ui, &Response) -> R,
    ) -> R {
        let mut size = self.ui.spacing().interact_size.y * vec2(NAME, 1.0);
        let words = WidgetText::from(name).into_galley(
            self.ui,
            Some(TextWrapMode::Extend),
            f32::INFINITY,
            TextStyle::Body,
        );
        size.x = size.x.max(words.size().x);
        let right = Layout::right_to_left(Align::Center);
        let cell = self.ui.allocate_ui_with_layout(size, right, |ui| {
            ui.set_min_size(size);
            ui.label(name)
        });
        let label = cell.inner;
        let label = match meaning.is_empty() {
            true => label,
            false => label.on_hover_text(meaning),
        };
        let added = self.ui.horizontal(|ui| add(ui, &label)).inner;
        self.ui.end_row();
        added
    }

    /// A slider under its name.
    pub fn slider(&mut self, named: (&str, &str), slider: Slider<'_>) -> Response {
        self.row(named, |ui, label| {
            ui.add(slider).labelled_by(label.id).on_hover_text(named.1)
        })
    }

    /// A choice under the name that screen readers call it.
    pub fn choice(&mut self, choice: Choice<'_>, chosen: &str, list: impl FnOnce(&mut Ui)) {
        self.row((choice.name, choice.meaning), |ui, _| {
            choice.cut(ui, chosen, list);
        });
    }

    /// What has its name in itself, below the other controls.
    pub fn rest<R>(&mut self, add: impl FnOnce(&mut Ui) -> R) -> R {
        self.row(("", ""), |ui, _| add(ui))
    }

    /// The window's part that it is drawn into.
    pub fn ui(&mut self) -> &mut Ui {
        self.ui
    }
}
