//! A table whose rows can be clicked: charts tell the shape, rows tell the figures.

use eframe::egui;
use egui::{Align, Label, Rect, RichText, Sense, TextStyle, Ui, UiBuilder, pos2, vec2};

use super::super::theme::Theme;

/// A column: its title, what it means, and its share of the width.
#[derive(Clone, Debug)]
pub struct Column {
    /// Stands over the column.
    pub title: String,
    /// What it counts, with its unit, for hover.
    pub meaning: String,
    /// Share of the width.
    pub share: f32,
    /// Numbers stand at the right.
    pub right: bool,
}

impl Column {
    /// A column of words.
    pub fn words(title: &str, meaning: &str, share: f32) -> Self {
        Self {
            title: title.to_owned(),
            meaning: meaning.to_owned(),
            share,
            right: false,
        }
    }

    /// A column of numbers.
    pub fn numbers(title: &str, meaning: &str, share: f32) -> Self {
        Self {
            right: true,
            ..Self::words(title, meaning, share)
        }
    }
}

/// A row.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// What stands in each column.
    pub cells: Vec<String>,
    /// The row in one line, for those who have it read out.
    pub name: String,
    /// For hover.
    pub note: String,
}

/// Free space at both sides of a cell, points.
const INSET: f32 = 4.0;

/// Draws a table as wide as there is room; returns the row that was clicked. `chosen` is drawn as
/// selected.
pub fn table(
    ui: &mut Ui,
    columns: &[Column],
    rows: &[Row],
    chosen: Option<usize>,
    enabled: bool,
    theme: Theme,
) -> Option<usize> {
    table_with(ui, columns, rows, (chosen, enabled), theme, |_, _, _| {})
}

/// The same with something painted into cells beside their text: `paint` gets row and column and
/// the cell's box, once for every cell that is seen.
pub fn table_with(
    ui: &mut Ui,
    columns: &[Column],
    rows: &[Row],
    (chosen, enabled): (Option<usize>, bool),
    theme: Theme,
    mut paint: impl FnMut(&Ui, [usize; 2], Rect),
) -> Option<usize> {
    head(ui, columns, theme);
    body(ui, columns, (rows, 0), (chosen, enabled), &mut paint)
}

/// Height of a row, points.
pub fn height(ui: &Ui) -> f32 {
    ui.text_style_height(&TextStyle::Body) + 5.0
}

/// Draws the titles.
pub fn head(ui: &mut Ui, columns: &[Column], theme: Theme) {
    let width = ui.available_width();
    let borders = borders(columns, width);
    ui.spacing_mut().item_spacing.y = 0.0;
    let (head, _) = ui.allocate_exact_size(vec2(width, height(ui)), Sense::hover());
    for (column, cell) in columns.iter().zip(cells(head, &borders)) {
        let text = RichText::new(&column.title).small().color(theme.faint);
        put(ui, cell, column.right, text).on_hover_text(&column.meaning);
    }
    let line = head.bottom() - 1.0;
    let colour = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().hline(head.x_range(), line, colour);
}

/// Draws rows of a table without its titles; `first` is the index of the first of them. Returns
/// the index of the row that was clicked.
pub fn body(
    ui: &mut Ui,
    columns: &[Column],
    (rows, first): (&[Row], usize),
    (chosen, enabled): (Option<usize>, bool),
    paint: &mut dyn FnMut(&Ui, [usize; 2], Rect),
) -> Option<usize> {
    let width = ui.available_width();
    let borders = borders(columns, width);
    ui.spacing_mut().item_spacing.y = 0.0;
    let sense = if enabled {
        Sense::click()
    } else {
        Sense::hover()
    };
    let mut clicked = None;
    for (index, row) in (first..).zip(rows) {
        let (rect, response) = ui.allocate_exact_size(vec2(width, height(ui)), sense);
        response.widget_info(|| {
            egui::WidgetInfo::selected(
                egui::Role::Button,
                enabled,
                chosen == Some(index),
                &row.name,
            )
        });
        if !ui.is_rect_visible(rect) {
            continue;
        }
        let visuals = ui.visuals();
        let fill = if chosen == Some(index) {
            visuals.selection.bg_fill
        } else if enabled && (response.hovered() || response.has_focus()) {
            visuals.widgets.hovered.bg_fill
        } else if index % 2 == 1 {
            visuals.faint_bg_color
        } else {
            egui::Color32::TRANSPARENT
        };
        ui.painter().rect_filled(rect, 2.0, fill);
        for ((column, cell), text) in columns.iter().zip(cells(rect, &borders)).zip(&row.cells) {
            write(ui, cell, column.right, text);
        }
        for (column, cell) in cells(rect, &borders).enumerate() {
            paint(ui, [index, column], cell);
        }
        if response.clicked() {
            clicked = Some(index);
        }
        if !row.note.is_empty() {
            response.on_hover_text_at_pointer(&row.note);
        }
    }
    clicked
}

/// Where columns end, points from the left.
fn borders(columns: &[Column], width: f32) -> Vec<f32> {
    let whole: f32 = columns.iter().map(|column| column.share).sum();
    let mut sum = 0.0;
    columns
        .iter()
        .map(|column| {
            sum += column.share;
            width * sum / whole.max(f32::MIN_POSITIVE)
        })
        .collect()
}

/// The boxes of a row.
fn cells<'a>(row: Rect, borders: &'a [f32]) -> impl Iterator<Item = Rect> + 'a {
    let mut left = row.left();
    borders.iter().map(move |border| {
        let right = row.left() + border;
        let cell = Rect::from_x_y_ranges(left..=right, row.y_range());
        left = right;
        cell.shrink2(vec2(INSET, 0.0))
    })
}

/// A title as a widget of its own.
fn put(ui: &mut Ui, cell: Rect, right: bool, text: RichText) -> egui::Response {
    let layout = if right {
        egui::Layout::right_to_left(Align::Center)
    } else {
        egui::Layout::left_to_right(Align::Center)
    };
    let mut inner = ui.new_child(UiBuilder::new().max_rect(cell).layout(layout));
    inner.add(Label::new(text).truncate().selectable(false))
}

/// Text without a widget: the row has its name.
fn write(ui: &Ui, cell: Rect, right: bool, text: &str) {
    let font = TextStyle::Body.resolve(ui.style());
    let colour = ui.visuals().text_color();
    let mut job = egui::text::LayoutJob::simple_singleline(text.to_owned(), font, colour);
    job.wrap = egui::text::TextWrapping::truncate_at_width(cell.width());
    let galley = ui.painter().layout_job(job);
    let size = galley.size();
    let x = if right {
        cell.right() - size.x
    } else {
        cell.left()
    };
    let corner = pos2(x, cell.center().y - size.y / 2.0);
    ui.painter().galley(corner, galley, colour);
}
