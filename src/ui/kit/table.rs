//! The table: rows of words and figures that can be clicked, with what is painted beside them.

use eframe::egui;
use egui::{
    Align, Color32, Label, Rect, RichText, ScrollArea, Sense, TextStyle, Ui, UiBuilder, pos2, vec2,
};

use super::named_choice;
use crate::{
    app::cells,
    ui::theme::{Theme, least_row},
};

/// A column: its title, what it means, and its share of the width.
#[derive(Clone, Debug)]
pub struct Column {
    /// Stands over the column.
    pub title: String,
    /// What it counts, with its unit, for hover.
    pub meaning: String,
    /// Share of the width; points where a table is given the sum of them as its width.
    pub share: f32,
    /// Numbers stand at the right.
    pub right: bool,
    /// The title is underlined: this column decides.
    pub decides: bool,
    /// Room before the words, for a [`bar`], points.
    pub indent: f32,
}

impl Column {
    /// A column of words.
    pub fn words(title: &str, meaning: &str, share: f32) -> Self {
        Self {
            title: title.to_owned(),
            meaning: meaning.to_owned(),
            share,
            right: false,
            decides: false,
            indent: 0.0,
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

/// The columns of a table, each with its share of the width.
pub fn columns(table: &cells::Table, shares: &[f32]) -> Vec<Column> {
    let heads = table.heads().zip(shares);
    let column = |(head, share): (&cells::Head, &f32)| Column {
        right: head.is_number,
        ..Column::words(&head.title, &head.meaning, *share)
    };
    heads.map(column).collect()
}

/// The rows of a table, each with its name for those who have it read out, and a note for hover.
pub fn rows(table: &cells::Table, names: impl Fn(usize, &[String]) -> [String; 2]) -> Vec<Row> {
    let row = |(i, cells): (usize, Vec<String>)| {
        let [name, note] = names(i, &cells);
        Row {
            name,
            note,
            cells,
            ..Row::default()
        }
    };
    table.shown().enumerate().map(row).collect()
}

/// How the words of a cell are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// As any text.
    #[default]
    Plain,
    /// What wins, or what matters most.
    Strong,
    /// As any text, in small type.
    Small,
    /// Strong in small type.
    SmallStrong,
    /// What stands back, in small type: a group's name.
    SmallWeak,
}

#[derive(Clone, Debug, Default)]
pub struct Row {
    /// What stands in each column.
    pub cells: Vec<String>,
    /// The row in one line, for those who have it read out.
    pub name: String,
    /// For hover.
    pub note: String,
    /// For hover over each cell in the note's place; those that are left out or empty have none.
    pub tips: Vec<String>,
    /// How each cell is written; those that are left out are plain.
    pub looks: Vec<Look>,
}

impl Row {
    /// A row that is read out as its cells.
    pub fn of(cells: Vec<String>) -> Self {
        Self {
            name: cells.join(", "),
            cells,
            ..Self::default()
        }
    }
}

/// What is painted into cells beside their text: it gets row and column and the cell's box, once
/// for every cell that is seen.
pub(super) type Paint<'a> = &'a mut dyn FnMut(&Ui, [usize; 2], Rect);

/// Free space at both sides of a cell, points.
const INSET: f32 = 4.0;

/// How a table is drawn.
#[derive(Clone, Copy)]
pub struct Table<'a> {
    pub columns: &'a [Column],
    /// The row that is drawn as selected.
    pub chosen: Option<usize>,
    /// Whether rows can be clicked.
    pub enabled: bool,
    /// Whether titles stand over it.
    pub titles: bool,
    /// Whether lines stand closer, for tables of many short ones.
    pub dense: bool,
    /// The looks.
    pub theme: Theme,
}

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
    let table = Table {
        chosen,
        enabled,
        ..Table::new(columns, theme)
    };
    table.show(ui, rows, &mut |_, _, _| {})
}

impl<'a> Table<'a> {
    /// A table whose rows can be clicked.
    pub fn new(columns: &'a [Column], theme: Theme) -> Self {
        Self {
            columns,
            chosen: None,
            enabled: true,
            titles: true,
            dense: false,
            theme,
        }
    }

    /// A table of many short lines that cannot be clicked.
    pub fn dense(columns: &'a [Column], theme: Theme) -> Self {
        Self {
            enabled: false,
            dense: true,
            ..Self::new(columns, theme)
        }
    }

    /// Titles and all rows; returns the row that was clicked.
    pub fn show(&self, ui: &mut Ui, rows: &[Row], paint: Paint<'_>) -> Option<usize> {
        ui.scope(|ui| {
            self.head(ui);
            self.rows(ui, (rows, 0), paint)
        })
        .inner
    }

    /// Titles, and below them rows that scroll within a height (all that there is where it is
    /// infinite); returns the row that was clicked.
    pub fn scrolled(
        &self,
        ui: &mut Ui,
        id: &str,
        height: f32,
        rows: &[Row],
        paint: Paint<'_>,
    ) -> Option<usize> {
        ui.scope(|ui| {
            self.head(ui);
            ScrollArea::vertical()
                .id_salt(id)
                .max_height(height)
                .auto_shrink([false, height.is_finite()])
                .show_rows(ui, self.row_height(ui), rows.len(), |ui, range| {
                    self.rows(ui, (&rows[range.clone()], range.start), paint)
                })
                .inner
        })
        .inner
    }

    /// Height of a row, points.
    pub fn row_height(&self, ui: &Ui) -> f32 {
        let text = ui.text_style_height(&TextStyle::Body);
        let height = if self.dense {
            (text + 3.0).ceil()
        } else {
            text + 5.0
        };
        match self.enabled {
            true => height.max(least_row(ui)),
            false => height,
        }
    }

    /// Titles that sort; returns the column that was clicked.
    pub fn sorting_head(&self, ui: &mut Ui) -> Option<usize> {
        ui.scope(|ui| self.titles(ui, true)).inner
    }

    /// Titles.
    pub fn head(&self, ui: &mut Ui) {
        if self.titles {
            self.titles(ui, false);
        }
    }

    fn titles(&self, ui: &mut Ui, sorts: bool) -> Option<usize> {
        let mut clicked = None;
        ui.spacing_mut().item_spacing.y = 0.0;
        let size = vec2(ui.available_width(), self.row_height(ui));
        let (head, _) = ui.allocate_exact_size(size, Sense::hover());
        for (index, (column, cell)) in self.columns.iter().zip(self.cells(head)).enumerate() {
            let text = RichText::new(&column.title).small();
            let text = if column.decides {
                text.strong().underline()
            } else {
                text.color(self.theme.faint)
            };
            let mut title = put(ui, cell, column.right, text);
            if sorts {
                title = title.interact(Sense::click());
                let name = tr!("Sort by {title}", title = column.title);
                named_choice(&title, egui::Role::Button, column.decides, &name);
                if title.clicked() {
                    clicked = Some(index);
                }
            }
            if !column.meaning.is_empty() {
                title.on_hover_text(&column.meaning);
            }
        }
        let line = head.bottom() - 1.0;
        let colour = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().hline(head.x_range(), line, colour);
        clicked
    }

    /// Rows without titles or stripes, for tables with words between their rows.
    pub fn plain(&self, ui: &mut Ui, rows: &[Row]) {
        for row in rows {
            self.rows(ui, (std::slice::from_ref(row), 0), &mut |_, _, _| {});
        }
    }

    /// Rows without titles; the second of the pair is the index of the first of them.
    fn rows(&self, ui: &mut Ui, (rows, first): (&[Row], usize), paint: Paint<'_>) -> Option<usize> {
        ui.spacing_mut().item_spacing.y = 0.0;
        let size = vec2(ui.available_width(), self.row_height(ui));
        let sense = if self.enabled {
            Sense::click()
        } else {
            Sense::hover()
        };
        let mut clicked = None;
        for (index, row) in (first..).zip(rows) {
            let (rect, response) = ui.allocate_exact_size(size, sense);
            let chosen = self.chosen == Some(index);
            response.widget_info(|| {
                egui::WidgetInfo::selected(egui::Role::Button, self.enabled, chosen, &row.name)
            });
            if !ui.is_rect_visible(rect) {
                continue;
            }
            let visuals = ui.visuals();
            let fill = if chosen {
                visuals.selection.bg_fill
            } else if self.enabled && (response.hovered() || response.has_focus()) {
                visuals.widgets.hovered.bg_fill
            } else if index % 2 == 1 {
                visuals.faint_bg_color
            } else {
                Color32::TRANSPARENT
            };
            ui.painter().rect_filled(rect, 2.0, fill);
            let mut tip = row.note.as_str();
            for (column, cell) in self.cells(rect).enumerate() {
                let look = row.looks.get(column).copied().unwrap_or_default();
                if let Some(text) = row.cells.get(column).filter(|text| !text.is_empty()) {
                    let Column { right, indent, .. } = self.columns[column];
                    write(ui, cell.with_min_x(cell.left() + indent), right, text, look);
                }
                paint(ui, [index, column], cell);
                let whole = cell.expand2(vec2(INSET, 0.0));
                let own = row.tips.get(column).filter(|tip| !tip.is_empty());
                if response.hover_pos().is_some_and(|at| whole.contains(at)) {
                    tip = own.map_or(tip, String::as_str);
                }
            }
            if response.clicked() {
                clicked = Some(index);
            }
            if !tip.is_empty() {
                response.on_hover_text_at_pointer(tip);
            }
        }
        clicked
    }

    /// The boxes of a row.
    fn cells(&self, row: Rect) -> impl Iterator<Item = Rect> {
        let whole: f32 = self.columns.iter().map(|column| column.share).sum();
        let scale = row.width() / whole.max(f32::MIN_POSITIVE);
        let mut sum = 0.0;
        self.columns.iter().map(move |column| {
            let left = row.left() + scale * sum;
            sum += column.share;
            let right = row.left() + scale * sum;
            Rect::from_x_y_ranges(left..=right, row.y_range()).shrink2(vec2(INSET, 0.0))
        })
    }
}

/// A bar of colour before a cell's words, in the free space at its side.
pub fn bar(ui: &Ui, cell: Rect, colour: Color32) {
    let left = cell.left() - INSET;
    let bar = cell.with_min_x(left).with_max_x(left + 3.0);
    ui.painter()
        .rect_filled(bar.shrink2(vec2(0.0, 2.0)), 1.0, colour);
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
fn write(ui: &Ui, cell: Rect, right: bool, text: &str, look: Look) {
    let visuals = ui.visuals();
    let (style, colour) = match look {
        Look::Plain => (TextStyle::Body, visuals.text_color()),
        Look::Strong => (TextStyle::Body, visuals.strong_text_color()),
        Look::Small => (TextStyle::Small, visuals.text_color()),
        Look::SmallStrong => (TextStyle::Small, visuals.strong_text_color()),
        Look::SmallWeak => (TextStyle::Small, visuals.weak_text_color()),
    };
    let font = style.resolve(ui.style());
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
