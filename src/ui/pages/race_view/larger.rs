//! Beside a larger collection: both tables and what they say.

use eframe::egui;
use egui::{RichText, Ui};

use super::{WIDE, scaled, sideways, solid_bars};
use crate::{
    app::charts::race::{Larger, Tables, about, figure, short_name},
    study::{
        race::Racer,
        race_reference::{Beside, CHECKED_NUMBERS, COLUMNS, OF_FEW, ORIGIN, TABLE},
    },
    ui::{
        kit::{Column, Look, Row, Table},
        theme::{Theme, section},
    },
};

/// Width of a representation's name, of a cell, and of a cell with three figures, points.
const NAMES: f32 = 96.0;
const CELL: f32 = 78.0;
const WIDE_CELL: f32 = 140.0;

/// The comparison as rows.
pub(super) struct LargerRows {
    larger: Larger,
    columns: Vec<Column>,
    /// Of each representation this race's row, and the larger collection's.
    lines: Vec<[Row; 2]>,
    /// The same of each class.
    checked: Vec<[Row; 2]>,
}

impl LargerRows {
    /// The rows of a comparison.
    pub(super) fn of(larger: Larger) -> Self {
        let figures = COLUMNS.map(|column| {
            let title = format!("{} {}", short_class(column.class), column.numbers);
            let meaning = format!(
                "{} lights at {} numbers; {} lights in the larger collection.",
                column.class, column.numbers, column.lamps
            );
            Column::numbers(&title, &meaning, CELL)
        });
        let mut columns = vec![Column::words("", "", NAMES)];
        columns.extend(figures);
        let tables = larger.tables.as_ref();
        Self {
            columns,
            lines: tables.map_or_else(Vec::new, lines),
            checked: tables.map_or_else(Vec::new, checked),
            larger,
        }
    }

    pub(super) fn show(&self, ui: &mut Ui, theme: Theme) {
        section(ui, "What the composite wins, and what it does not");
        if ui.available_width() >= WIDE && !self.larger.halves.is_empty() {
            ui.columns(self.larger.halves.len(), |columns| {
                for (ui, half) in columns.iter_mut().zip(&self.larger.halves) {
                    // Columns would stretch the words to their width.
                    ui.vertical(|ui| {
                        ui.set_max_width(ui.available_width() - 10.0);
                        told(ui, half);
                    });
                }
            });
        } else {
            for half in &self.larger.halves {
                told(ui, half);
            }
        }
        ui.add_space(6.0);
        section(ui, "Beside a larger collection");
        match &self.larger.tables {
            Some(tables) => self.tables(ui, tables, theme),
            None => {
                ui.weak(
                    "The larger collection was measured over 380-780 nm, for the CIE 1931 observer, \
                     with the ColorChecker and lines from 0.5 % of the power: with other settings \
                     there is nothing to set beside it.",
                );
            }
        }
    }

    fn tables(&self, ui: &mut Ui, tables: &Tables, theme: Theme) {
        ui.weak(ORIGIN);
        let width = ui.available_width();
        let table = scaled(NAMES + 7.0 * CELL, theme) + 8.0;
        if width >= WIDE {
            ui.horizontal_top(|ui| {
                ui.vertical(|ui| {
                    ui.set_max_width(table);
                    self.patches(ui, tables, theme);
                });
                ui.add_space(16.0);
                ui.vertical(|ui| self.check(ui, tables, theme));
            });
        } else {
            self.patches(ui, tables, theme);
            ui.add_space(6.0);
            self.check(ui, tables, theme);
        }
    }

    fn patches(&self, ui: &mut Ui, tables: &Tables, theme: Theme) {
        ui.label(RichText::new("Mean ΔE₀₀ of the patches").strong());
        ui.weak(
            "Median / 95th percentile: above in this race, below in the larger collection. ▲ \
             marks medians more than a factor of 1.5 apart.",
        );
        ui.add_space(2.0);
        beside(
            ui,
            "larger collection",
            &self.columns,
            theme,
            |ui, table| {
                for (rows, (_, _, words)) in self.lines.iter().zip(&tables.lines) {
                    ui.add_space(3.0);
                    table.plain(ui, rows);
                    ui.add(egui::Label::new(RichText::new(words).small()).wrap());
                }
            },
        );
        if tables.lines.iter().any(|line| line.1[6].is_some()) {
            ui.weak(OF_FEW);
        }
    }

    fn check(&self, ui: &mut Ui, tables: &Tables, theme: Theme) {
        if self.checked.is_empty() {
            return;
        }
        ui.strong(format!(
            "Chosen per light on the patches, judged on other samples, {CHECKED_NUMBERS} numbers"
        ));
        ui.weak(
            "Mean ΔE₀₀ of the 99 samples of TM-30, which took no part in the choice: median / \
             95th percentile / worst, above in this race, below in the larger collection.",
        );
        let title = |title: &str| Column::numbers(title, "", WIDE_CELL);
        let columns = [
            Column::words("", "", NAMES),
            title("Composite, chosen"),
            title("Moments"),
            title("Principal components"),
        ];
        beside(ui, "larger check", &columns, theme, |ui, table| {
            for rows in &self.checked {
                table.plain(ui, rows);
                ui.add_space(3.0);
            }
        });
        ui.add_space(4.0);
        for words in &tables.others {
            ui.label(words);
        }
    }
}

/// A table that scrolls to the side where there is no room for all of it.
fn beside(
    ui: &mut Ui,
    id: &str,
    columns: &[Column],
    theme: Theme,
    rows: impl FnOnce(&mut Ui, Table<'_>),
) {
    ui.scope(|ui| {
        solid_bars(ui);
        sideways(ui, (id, false), columns, theme, |ui, table| {
            table.head(ui);
            rows(ui, table);
        });
    });
}

/// Figures of each representation: this race's, and the larger collection's.
fn lines(tables: &Tables) -> Vec<[Row; 2]> {
    let line = |(racer, cells, _): &(Racer, [Option<Beside>; 7], String)| {
        let ours = cells.map(|beside| {
            beside.map_or_else(
                || "–".to_owned(),
                |b| {
                    let mark = if b.differs() { "▲ " } else { "" };
                    format!("{mark}{}/{}", brief(b.ours.median), brief(b.ours.p95))
                },
            )
        });
        let tip = |beside: &Option<Beside>| {
            beside.map_or_else(String::new, |b| {
                format!(
                    "{} at {}: {} here against {}, a factor of {:.2}.",
                    b.column.class,
                    b.column.numbers,
                    figure(b.ours.median),
                    figure(b.theirs.median),
                    b.factor()
                )
            })
        };
        let theirs = TABLE.iter().find(|line| line.racer == *racer);
        let theirs = theirs.iter().flat_map(|line| &line.figures);
        let theirs = theirs.map(|f| format!("{}/{}", brief(f.median), brief(f.p95)));
        let tips = std::iter::once(about(*racer)).chain(cells.iter().map(tip));
        let [ours, theirs] = pair(short_name(*racer), ours.to_vec(), theirs.collect());
        let ours = Row {
            tips: tips.collect(),
            ..ours
        };
        [ours, theirs]
    };
    tables.lines.iter().map(line).collect()
}

/// The same of each class.
fn checked(tables: &Tables) -> Vec<[Row; 2]> {
    let line = |(class, cells): &(String, Vec<[String; 2]>)| {
        let of = |which: usize| cells.iter().map(|both| both[which].clone()).collect();
        pair(class, of(0), of(1))
    };
    tables.checked.iter().map(line).collect()
}

/// Two rows about the same: this race's figures, and the larger collection's.
fn pair(name: &str, ours: Vec<String>, theirs: Vec<String>) -> [Row; 2] {
    let row = |who: &str, title: &str, figures: Vec<String>, look| Row {
        name: format!("{name}, {who}: {}", figures.join(", ")),
        looks: std::iter::once(Look::Strong)
            .chain(figures.iter().map(|_| look))
            .collect(),
        cells: std::iter::once(title.to_owned()).chain(figures).collect(),
        ..Row::default()
    };
    [
        row("in this race", name, ours, Look::SmallStrong),
        row("in the larger collection", "", theirs, Look::SmallWeak),
    ]
}

/// One measure's sentences under their title.
fn told(ui: &mut Ui, (title, sentences): &(&'static str, Vec<String>)) {
    ui.label(RichText::new(*title).strong());
    for sentence in sentences {
        ui.label(sentence);
    }
    ui.add_space(2.0);
}

/// A class in few letters, for a narrow column.
fn short_class(class: &str) -> &str {
    match class {
        "fluorescent" => "fluor.",
        "discharge" => "disch.",
        other => other,
    }
}

/// Two significant digits, without the zero before the point: there are many in a line.
fn brief(value: f64) -> String {
    let text = match value {
        v if v < 0.01 => format!("{v:.4}"),
        v if v < 0.1 => format!("{v:.3}"),
        v if v < 1.0 => format!("{v:.2}"),
        v if v < 10.0 => format!("{v:.1}"),
        v => format!("{v:.0}"),
    };
    match text.strip_prefix('0') {
        Some(rest) if rest.starts_with('.') => rest.to_owned(),
        _ => text,
    }
}
