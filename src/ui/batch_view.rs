//! Files that were opened together: how far they are, and what came of each.

use eframe::egui;
use egui::{Context, RichText, ScrollArea, Ui, vec2};

use super::{
    pages::rows::{self, Column, Row},
    theme::Theme,
};
use crate::app::open::{FileRow, Progress, Summary};

/// Width of the bar, points.
const BAR: f32 = 120.0;

/// Letters of a file's name beside the bar.
const MOST_LETTERS: usize = 28;

/// Bar, file at work and Cancel, from right to left; whether Cancel was clicked.
pub fn progress(ui: &mut Ui, progress: &Progress) -> bool {
    let Progress {
        done,
        total,
        at_work,
    } = progress;
    let cancelled = ui
        .small_button("Cancel")
        .on_hover_text("Stops reading files; what was read until now is kept.")
        .clicked();
    let (share, words) = match total {
        Some(1) => (0.0, "reading".to_owned()),
        Some(total) => (
            *done as f32 / (*total).max(1) as f32,
            format!("{done} of {total} files"),
        ),
        None => (0.0, "looking through folders".to_owned()),
    };
    let bar = egui::ProgressBar::new(share)
        .desired_width(BAR)
        .text(RichText::new(&words).small());
    let response = ui.add(bar);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ProgressIndicator, true, &words));
    response.on_hover_text("Files read, of those that were opened together.");
    ui.label(shortened(at_work)).on_hover_text(at_work);
    cancelled
}

/// The end of a path: its file's name stands there.
fn shortened(label: &str) -> String {
    let letters: Vec<char> = label.chars().collect();
    if letters.len() <= MOST_LETTERS {
        return label.to_owned();
    }
    let end: String = letters[letters.len() - MOST_LETTERS + 1..].iter().collect();
    format!("…{end}")
}

/// Which rows are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Shown {
    #[default]
    All,
    Doubtful,
    NotRead,
}

/// The last summary, and its window.
#[derive(Default)]
pub struct BatchView {
    summary: Option<Summary>,
    headline: String,
    is_open: bool,
    shown: Shown,
    /// Rows as they are drawn, made once.
    rows: Vec<Row>,
}

impl BatchView {
    /// A new summary: its window opens.
    pub fn take(&mut self, summary: Summary) {
        self.headline = format!("{}.", summary.headline());
        self.summary = Some(summary);
        self.choose(Shown::All);
        self.is_open = true;
    }

    /// Opens the window again.
    pub fn show(&mut self) {
        self.is_open = self.summary.is_some();
    }

    /// Whether there is something to show.
    pub fn has_summary(&self) -> bool {
        self.summary.is_some()
    }

    /// Whether a message tells of the summary.
    pub fn is_told_by(&self, message: &str) -> bool {
        self.summary.is_some() && message == self.headline
    }

    fn choose(&mut self, shown: Shown) {
        self.shown = shown;
        let rows = || self.summary.iter().flat_map(|summary| &summary.rows);
        // All in one folder: its name is no news.
        let folder = rows()
            .next()
            .and_then(|row| row.file.split_once('/'))
            .map(|(folder, _)| format!("{folder}/"))
            .filter(|folder| rows().all(|row| row.file.starts_with(folder.as_str())))
            .unwrap_or_default();
        self.rows = rows()
            .filter(|row| match shown {
                Shown::All => true,
                Shown::Doubtful => row.is_doubtful(),
                Shown::NotRead => !row.is_read(),
            })
            .map(|row| drawn(row, &folder))
            .collect();
    }

    /// Draws the window if it is open; a sentence for the status line if something was copied.
    pub fn window(&mut self, context: &Context, theme: Theme) -> Option<String> {
        if !self.is_open {
            return None;
        }
        let mut open = true;
        let mut copied = None;
        let room = context.content_rect().size();
        let width = (0.6 * room.x).clamp(800.0, 1100.0);
        egui::Window::new("Files opened together")
            .open(&mut open)
            .collapsible(false)
            .default_pos(egui::pos2(
                (0.5 * (room.x - width)).max(8.0),
                (0.18 * room.y).max(8.0),
            ))
            .default_size(vec2(width, 0.5 * room.y).min(room - vec2(40.0, 80.0)))
            .min_size(vec2(420.0, 200.0))
            .show(context, |ui| copied = self.content(ui, theme));
        self.is_open &= open;
        copied
    }

    fn content(&mut self, ui: &mut Ui, theme: Theme) -> Option<String> {
        let summary = self.summary.as_ref()?;
        ui.add(egui::Label::new(&self.headline).wrap());
        ui.add_space(4.0);
        let (all, doubtful, not_read) = (
            summary.rows.len(),
            summary.count(FileRow::is_doubtful),
            summary.count(|row| !row.is_read()),
        );
        let (mut chosen, mut copied, mut closed) = (None, None, false);
        ui.horizontal(|ui| {
            for (shown, words, count, meaning) in [
                (Shown::All, "All", all, "Every file that was opened."),
                (
                    Shown::Doubtful,
                    "Doubtful",
                    doubtful,
                    "Files read with a guess that you should look at: what the values stand for, \
                     per cent or fractions, the unit of the wavelengths.",
                ),
                (
                    Shown::NotRead,
                    "Refused or not read",
                    not_read,
                    "Files that hold nothing that can be read, and those that were not reached.",
                ),
            ] {
                let label =
                    egui::Button::selectable(self.shown == shown, format!("{words} ({count})"));
                let possible = shown == Shown::All || count > 0;
                if ui
                    .add_enabled(possible, label)
                    .on_hover_text(meaning)
                    .clicked()
                {
                    chosen = Some(shown);
                }
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                closed = ui.button("Close").clicked();
                if ui
                    .button("Copy as CSV")
                    .on_hover_text("Every file with format, count, how it was read and its path.")
                    .clicked()
                {
                    ui.copy_text(summary.csv().trim_end().to_owned());
                    copied = Some("Copied as CSV: files opened together.".to_owned());
                }
            });
        });
        ui.add_space(2.0);
        table(ui, &self.rows, theme);
        if let Some(shown) = chosen {
            self.choose(shown);
        }
        self.is_open &= !closed;
        copied
    }
}

fn drawn(row: &FileRow, folder: &str) -> Row {
    let mark = if !row.is_read() {
        "× "
    } else if row.is_doubtful() {
        "? "
    } else {
        ""
    };
    let story = row.story();
    let mut note = format!("{}\n{story}", row.file);
    if let Some(path) = &row.path {
        note += &format!("\n{}", path.display());
    }
    Row {
        name: format!("{}: {}, {story}", row.file, row.format()),
        cells: vec![
            format!(
                "{mark}{}",
                row.file.strip_prefix(folder).unwrap_or(&row.file)
            ),
            row.format().to_owned(),
            row.brought(),
            story,
        ],
        note,
    }
}

/// The rows in view; there may be thousands.
fn table(ui: &mut Ui, rows: &[Row], theme: Theme) {
    let columns = [
        Column::words(
            "File",
            "Its path below the folder that was opened. × refused or not read, ? doubtful.",
            2.6,
        ),
        Column::words("Format", "The format that read it.", 1.7),
        Column::numbers(
            "Spectra",
            "How many spectra it holds; images beside them.",
            0.9,
        ),
        Column::words(
            "How it was read",
            "Grid, points, range, kind and unit; or why it was refused.",
            5.0,
        ),
    ];
    let height = rows::height(ui);
    rows::head(ui, &columns, theme);
    ScrollArea::vertical()
        .auto_shrink(false)
        .show_rows(ui, height, rows.len(), |ui, range| {
            let first = range.start;
            let seen = &rows[range];
            rows::body(
                ui,
                &columns,
                (seen, first),
                (None, false),
                &mut |_, _, _| {},
            );
        });
}
