//! Files that were opened together: how far they are, and what came of each.

use eframe::egui;
use egui::{Align2, Context, Key, Modifiers, Rect, RichText, Sense, TextStyle, Ui, vec2};

use super::{
    kit::{Column, Row, Table, named, pressed, pressed_if, pressed_small},
    theme::Theme,
};
use crate::{
    app::open::{FileRow, Progress, Summary},
    languages::{Language, in_language, said, with_colon},
};

/// Width of the bar, points.
const BAR: f32 = 120.0;

/// Letters of a file's name beside the bar.
const MOST_LETTERS: usize = 28;

/// Bar, file at work and Cancel, from right to left; whether Cancel was clicked.
pub(super) fn progress(ui: &mut Ui, progress: &Progress) -> bool {
    let Progress {
        done,
        total,
        at_work,
    } = progress;
    let meaning = said!("Stops reading files; what was read until now is kept.");
    let cancelled = pressed_small(ui, said!("Cancel"), meaning);
    let (share, words) = match total {
        Some(1) => (0.0, said!("reading").to_owned()),
        Some(total) => (
            *done as f32 / (*total).max(1) as f32,
            tr!("{done} of {total} files", done, total),
        ),
        None => (0.0, said!("looking through folders").to_owned()),
    };
    let bar = egui::ProgressBar::new(share)
        .desired_width(BAR)
        .text(RichText::new(&words).small());
    let response = ui.add(bar);
    named(&response, egui::Role::ProgressIndicator, &words);
    response.on_hover_text(said!("Files read, of those opened together."));
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

/// What a file of a batch brought into the document first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Brought {
    /// Nothing: it was refused, not read, or a project.
    Nothing,
    /// A spectrum, by the key of its entry and the file that it is of.
    Spectrum {
        /// The entry's key.
        key: String,
        /// Its source: after an undo another file may have the key.
        source: String,
    },
    /// An image, by its key.
    Image(String),
}

/// What was asked for in the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// What a file brought is to be shown.
    Show(Brought),
    /// How a file was read is to be looked at.
    Look(Brought),
    /// A sentence for the status line.
    Say(String),
    /// How many numbers the lights of one's own need.
    Numbers,
    /// How good the lights are that these rows of the summary brought.
    Quality,
}

/// What one does with many spectra.
const NEXT: [(&str, &str, Wish); 2] = [
    (
        later!("How many numbers do they need?"),
        later!("Goes to Many lights, with your own lights."),
        Wish::Numbers,
    ),
    (
        later!("Compare their quality"),
        later!("White, colour rendering and efficacy of each light, the best first."),
        Wish::Quality,
    ),
];

/// The questions; the one that was clicked.
fn next(ui: &mut Ui) -> Option<Wish> {
    let mut wish = None;
    ui.horizontal_wrapped(|ui| {
        for (words, meaning, asked) in NEXT {
            if pressed(ui, said(words), said(meaning)) {
                wish = Some(asked);
            }
        }
    });
    ui.add_space(4.0);
    wish
}

/// The buttons above the rows: words, how many rows, what they are.
fn views(counts: [usize; 3]) -> [(Shown, &'static str, usize, &'static str); 3] {
    let [all, doubtful, not_read] = counts;
    [
        (
            Shown::All,
            said!("All"),
            all,
            said!("Every file that was opened."),
        ),
        (
            Shown::Doubtful,
            said!("Doubtful"),
            doubtful,
            said!(
                "Files read with a guess that you should look at: what the values stand for, per \
                 cent or fractions, the unit of the wavelengths."
            ),
        ),
        (
            Shown::NotRead,
            said!("Refused or not read"),
            not_read,
            said!("Files in which nothing could be read, and files that were not reached."),
        ),
    ]
}

impl Brought {
    fn is_spectrum(&self) -> bool {
        matches!(self, Self::Spectrum { .. })
    }
}

/// The last summary, and its window.
#[derive(Default)]
pub(super) struct BatchView {
    summary: Option<Summary>,
    headline: String,
    is_open: bool,
    shown: Shown,
    /// What each row of the summary brought.
    brought: Vec<Brought>,
    /// Rows as they are drawn, made once, and the row of the summary that each is.
    rows: Vec<Row>,
    of: Vec<usize>,
    /// The row of the summary that was clicked last.
    chosen: Option<usize>,
}

impl BatchView {
    /// A new summary: its window opens.
    ///
    /// `brought` tells what each of its rows brought.
    pub(super) fn take(&mut self, summary: Summary, brought: Vec<Brought>) {
        self.brought = brought;
        self.chosen = None;
        self.headline = format!("{}.", summary.headline());
        self.summary = Some(summary);
        self.choose(Shown::All);
        self.is_open = true;
    }

    /// Opens the window again.
    pub(super) fn show(&mut self) {
        self.is_open = self.summary.is_some();
    }

    /// Whether there is something to show.
    pub(super) fn has_summary(&self) -> bool {
        self.summary.is_some()
    }

    /// Whether a message tells of the summary.
    pub(super) fn is_told_by(&self, message: &str) -> bool {
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
        let seen = rows().enumerate().filter(|(_, row)| match shown {
            Shown::All => true,
            Shown::Doubtful => row.is_doubtful(),
            Shown::NotRead => !row.is_read(),
        });
        let (of, rows) = seen.map(|(i, row)| (i, drawn(row, &folder))).unzip();
        (self.of, self.rows) = (of, rows);
    }

    /// Draws the window if it is open, and tells what was asked for in it. Escape closes it where
    /// the key is nobody else's.
    pub(super) fn window(
        &mut self,
        context: &Context,
        theme: Theme,
        keys_are_free: bool,
    ) -> Option<Wish> {
        if !self.is_open {
            return None;
        }
        let mut open = true;
        let mut wish = None;
        let room = context.content_rect().size();
        let width = (0.86 * room.x).clamp(800.0, 1680.0);
        egui::Window::new(said!("Files opened together"))
            .open(&mut open)
            .collapsible(false)
            .default_pos(egui::pos2(
                (0.5 * (room.x - width)).max(8.0),
                (0.18 * room.y).max(8.0),
            ))
            .default_size(vec2(width, 0.5 * room.y).min(room - vec2(40.0, 80.0)))
            .min_size(vec2(420.0, 200.0))
            .show(context, |ui| wish = self.content(ui, theme));
        let escaped = keys_are_free
            && !context.text_edit_focused()
            && !egui::Popup::is_any_open(context)
            && context.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape));
        self.is_open &= open && !escaped;
        wish
    }

    fn content(&mut self, ui: &mut Ui, theme: Theme) -> Option<Wish> {
        let summary = self.summary.as_ref()?;
        ui.add(egui::Label::new(&self.headline).wrap());
        ui.add_space(4.0);
        let (all, doubtful, not_read) = (
            summary.rows.len(),
            summary.count(FileRow::is_doubtful),
            summary.count(|row| !row.is_read()),
        );
        let (mut chosen, mut wish, mut closed) = (None, None, false);
        if self.brought.iter().filter(|b| b.is_spectrum()).count() > 1 {
            wish = next(ui);
        }
        ui.horizontal(|ui| {
            for (shown, words, count, meaning) in views([all, doubtful, not_read]) {
                let label =
                    egui::Button::selectable(self.shown == shown, format!("{words} ({count})"));
                let possible = shown == Shown::All || count > 0;
                if pressed_if(ui, possible, label, meaning) {
                    chosen = Some(shown);
                }
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                closed = ui
                    .button(said!("Close"))
                    .on_hover_text(said!("Escape"))
                    .clicked();
                let meaning = said!("Every file with format, count, how it was read and its path.");
                if pressed(ui, said!("Copy as CSV"), meaning) {
                    let csv = in_language(Language::English, || summary.table().csv());
                    ui.copy_text(csv.trim_end().to_owned());
                    wish = Some(Wish::Say(
                        said!("Copied as CSV: files opened together.").to_owned(),
                    ));
                }
            });
        });
        ui.add_space(2.0);
        let doubts: Vec<bool> = self
            .of
            .iter()
            .map(|i| summary.rows[*i].is_doubtful() && self.has_spectrum(*i))
            .collect();
        let now = self.of.iter().position(|i| Some(*i) == self.chosen);
        match table(ui, &self.rows, &doubts, now, theme) {
            Some(Clicked::Row(row)) => {
                self.chosen = Some(self.of[row]);
                wish = Some(match &self.brought(self.of[row]) {
                    Brought::Nothing => Wish::Say(self.rows[row].name.clone()),
                    brought => Wish::Show(brought.clone()),
                });
            }
            Some(Clicked::Look(row)) => {
                self.chosen = Some(self.of[row]);
                wish = Some(Wish::Look(self.brought(self.of[row])));
            }
            None => {}
        }
        if let Some(shown) = chosen {
            self.choose(shown);
        }
        closed |= matches!(wish, Some(Wish::Numbers | Wish::Quality));
        self.is_open &= !closed;
        wish
    }

    /// Keys of the spectra that its rows brought first.
    pub(super) fn keys(&self) -> Vec<String> {
        let key = |brought: &Brought| match brought {
            Brought::Spectrum { key, .. } => Some(key.clone()),
            Brought::Nothing | Brought::Image(_) => None,
        };
        self.brought.iter().filter_map(key).collect()
    }

    fn brought(&self, row: usize) -> Brought {
        self.brought.get(row).cloned().unwrap_or(Brought::Nothing)
    }

    fn has_spectrum(&self, row: usize) -> bool {
        self.brought.get(row).is_some_and(Brought::is_spectrum)
    }
}

/// Where a table was clicked, by the row drawn.
enum Clicked {
    Row(usize),
    /// On the button of a doubtful row.
    Look(usize),
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
        name: with_colon(&row.file, format!("{}, {story}", row.format())),
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
        ..Row::default()
    }
}

/// The rows in view; there may be thousands. `doubts` tells which of them have a button that
/// shows how they were read.
fn table(
    ui: &mut Ui,
    rows: &[Row],
    doubts: &[bool],
    chosen: Option<usize>,
    theme: Theme,
) -> Option<Clicked> {
    let mut columns = vec![
        Column::words(
            said!("File"),
            said!(
                "Its path below the folder that was opened. × refused or not read, ? doubtful. A \
                 click shows its first spectrum."
            ),
            2.4,
        ),
        Column::words(said!("Format"), said!("The format that read it."), 1.5),
        Column::numbers(
            said!("Spectra"),
            said!("Spectra that it holds; images beside them."),
            0.8,
        ),
        Column::words(
            said!("How it was read"),
            said!("Grid, points, range, kind and unit; or why it was refused."),
            // Long sentences: a wide window is theirs.
            (ui.available_width() / (110.0 * theme.scale) - 5.4).max(5.0),
        ),
    ];
    if doubts.contains(&true) {
        let meaning =
            said!("Shows the file's first rows and what was decided, to look at or turn round.");
        columns.push(Column::words("", meaning, 0.8));
    }
    let mut looked = None;
    let table = Table {
        chosen,
        ..Table::new(&columns, theme)
    };
    let row = table.scrolled(
        ui,
        "files of the batch",
        f32::INFINITY,
        rows,
        &mut |ui, [row, column], cell| {
            if column == 4 && doubts.get(row) == Some(&true) && look(ui, row, cell) {
                looked = Some(row);
            }
        },
    );
    looked.map(Clicked::Look).or(row.map(Clicked::Row))
}

/// The button of a doubtful row, over the row itself.
fn look(ui: &Ui, row: usize, cell: Rect) -> bool {
    let rect = cell.shrink2(vec2(0.0, 1.0));
    let response = ui.interact(rect, ui.scope_id().with(("look", row)), Sense::click());
    named(&response, egui::Role::Button, said!("Look…"));
    let visuals = ui.style().interact(&response);
    ui.painter().rect_filled(rect, 3.0, visuals.bg_fill);
    ui.painter().text(
        rect.center(),
        Align2::CENTER_CENTER,
        said!("Look…"),
        TextStyle::Small.resolve(ui.style()),
        visuals.text_color(),
    );
    response
        .on_hover_text(said!(
            "How it was read: its first rows, what was decided, the other choices."
        ))
        .clicked()
}
