//! Beside a larger collection: its table and this race's, the differences in words, and both
//! halves of the result: what the composite wins and what it loses.

use eframe::egui;
use egui::{RichText, Ui};

use super::{WIDE, cell, dense, scaled};
use crate::{
    app::{
        charts::race::{figure, short_name, shown_factor, spread_of},
        studies::{Field, RaceAsk},
    },
    color::Observer,
    rivals::Family,
    spectrum::{Band, SpikeSettings},
    study::{
        Measure, Race, Spread,
        race::Racer,
        race_reference::{
            Beside, CHECKED, CHECKED_NUMBERS, COLUMNS, OF_FEW, ORIGIN, OTHER_HALF, TABLE,
        },
    },
    ui::theme::{Theme, section},
};

/// Width of a representation's name and of a cell, points.
const NAMES: f32 = 92.0;
const CELL: f32 = 74.0;

/// The figures of both, in words, made once.
pub struct Larger {
    /// What a sentence says for each class and measure: who wins, and by how much.
    halves: Vec<(&'static str, Vec<String>)>,
    /// Both tables; none where the settings are not those of the larger collection.
    tables: Option<Tables>,
}

struct Tables {
    lines: Vec<(Racer, [Option<Beside>; 7], String)>,
    /// Title and cells `[ours, theirs]` a line.
    checked: Vec<(String, Vec<[String; 2]>)>,
    others: Vec<String>,
}

impl Larger {
    /// The comparison of a race over a whole set; `None` where single lights race.
    pub fn new(ask: &RaceAsk, race: &Race, budget: usize) -> Option<Self> {
        let whole = match ask.field {
            Field::Shipped | Field::Class(_) | Field::Group(_) => true,
            Field::One(_) | Field::These(_) => false,
        };
        if !whole {
            return None;
        }
        let halves = [
            (Measure::Patches, "On the patches"),
            (Measure::Filters, "Behind narrow filters"),
            (
                Measure::RmsBlurred,
                "For the spectrum itself, behind a 10 nm blur",
            ),
        ]
        .into_iter()
        .map(|(measure, title)| (title, sentences(race, budget, measure)))
        .filter(|(_, sentences)| !sentences.is_empty())
        .collect();
        Some(Self {
            halves,
            tables: comparable(ask).then(|| Tables::new(race)),
        })
    }

    /// Draws it.
    pub fn show(&self, ui: &mut Ui, theme: Theme) {
        section(ui, "What the composite wins, and what it does not");
        if ui.available_width() >= WIDE && !self.halves.is_empty() {
            ui.columns(self.halves.len(), |columns| {
                for (ui, half) in columns.iter_mut().zip(&self.halves) {
                    // Columns would stretch the words to their width.
                    ui.vertical(|ui| {
                        ui.set_max_width(ui.available_width() - 10.0);
                        told(ui, half);
                    });
                }
            });
        } else {
            for half in &self.halves {
                told(ui, half);
            }
        }
        ui.add_space(6.0);
        section(ui, "Beside a larger collection");
        match &self.tables {
            Some(tables) => tables.show(ui, theme),
            None => {
                ui.weak(
                    "The larger collection was measured over 380-780 nm, for the CIE 1931 observer, \
                     with the ColorChecker and lines from 0.5 % of the power: with other settings \
                     there is nothing to set beside it.",
                );
            }
        }
    }
}

/// One measure's sentences under their title.
fn told(ui: &mut Ui, (title, sentences): &(&'static str, Vec<String>)) {
    ui.label(RichText::new(*title).strong());
    for sentence in sentences {
        ui.label(sentence);
    }
    ui.add_space(2.0);
}

/// Whether the race was run as the larger collection was.
fn comparable(ask: &RaceAsk) -> bool {
    ask.band == Band::VISIBLE
        && ask.observer == Observer::Cie1931
        && ask.patch_set == "colorchecker_ohta"
        && ask.spikes == SpikeSettings::default()
}

/// Who wins a measure on each class, and by how much.
fn sentences(race: &Race, budget: usize, measure: Measure) -> Vec<String> {
    let classes = race.classes();
    classes
        .into_iter()
        .filter_map(|class| sentence(race, class, budget, measure))
        .collect()
}

fn sentence(race: &Race, class: &str, budget: usize, measure: Measure) -> Option<String> {
    let best = |wanted: &dyn Fn(Racer) -> bool| {
        (0..race.racers.len())
            .filter(|racer| wanted(race.racers[*racer]))
            .filter_map(|racer| {
                let spread = spread_of(race, Some(class), budget, racer, measure)?;
                Some((race.racers[racer], spread))
            })
            .min_by(|a, b| a.1.median.total_cmp(&b.1.median))
    };
    let (composite, ours) = best(&|racer| matches!(racer, Racer::Composite(_)))?;
    let (rival, theirs) = best(&|racer| matches!(racer, Racer::Rival(_)))?;
    let words = |spread: Spread| {
        let factor = shown_factor(measure);
        let unit = if measure.is_colour() { "" } else { " %" };
        format!("{}{unit}", figure(factor * spread.median))
    };
    let (ours_words, theirs_words) = (words(ours), words(theirs));
    let class = capitalised(class);
    let (composite, rival) = (composite.title(), rival_words(rival));
    Some(if ours.median < theirs.median {
        format!(
            "{class}: the composite wins: {ours_words} ({composite}) against {theirs_words} of \
             {rival}."
        )
    } else {
        format!(
            "{class}: the composite loses: {rival} {theirs_words} against {ours_words} of the best \
             composite ({composite})."
        )
    })
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// A rival in the middle of a sentence.
fn rival_words(racer: Racer) -> &'static str {
    match racer {
        Racer::Rival(family) => family.about().in_a_sentence,
        other => other.title(),
    }
}

fn pair(spread: [f64; 3]) -> String {
    spread.map(figure).join("/")
}

fn three(spread: Spread) -> [f64; 3] {
    [spread.median, spread.p95, spread.worst]
}

impl Tables {
    fn new(race: &Race) -> Self {
        let lines = TABLE
            .iter()
            .map(|line| {
                let cells = line.beside(race);
                let words = line.explained(&cells);
                (line.racer, cells, words)
            })
            .collect();
        Self {
            lines,
            checked: checked(race),
            others: others(race),
        }
    }

    fn show(&self, ui: &mut Ui, theme: Theme) {
        ui.weak(ORIGIN);
        let width = ui.available_width();
        let table = scaled(NAMES + 7.0 * (CELL + 4.0), theme) + 8.0;
        if width >= WIDE {
            ui.horizontal_top(|ui| {
                ui.vertical(|ui| {
                    ui.set_max_width(table);
                    self.patches(ui, theme);
                });
                ui.add_space(16.0);
                ui.vertical(|ui| self.check(ui, theme));
            });
        } else {
            self.patches(ui, theme);
            ui.add_space(6.0);
            self.check(ui, theme);
        }
    }

    fn patches(&self, ui: &mut Ui, theme: Theme) {
        ui.label(RichText::new("Mean ΔE00 of the patches").strong());
        ui.weak(
            "Median / 95th percentile: above in this race, below in the larger collection. ▲ \
             marks medians more than a factor of 1.5 apart.",
        );
        ui.add_space(2.0);
        ui.scope(|ui| {
            dense(ui);
            egui::ScrollArea::horizontal()
                .id_salt("larger collection")
                .auto_shrink([false, true])
                .show(ui, |ui| {
                    ui.vertical(|ui| {
                        ui.spacing_mut().item_spacing.x = 4.0;
                        self.table(ui, theme);
                    });
                });
        });
        if self.lines.iter().any(|line| line.1[6].is_some()) {
            ui.weak(OF_FEW);
        }
    }

    fn check(&self, ui: &mut Ui, theme: Theme) {
        if self.checked.is_empty() {
            return;
        }
        ui.label(
            RichText::new(format!(
                "Chosen per light on the patches, judged on other samples, {CHECKED_NUMBERS} \
                 numbers"
            ))
            .strong(),
        );
        ui.weak(
            "Mean ΔE00 of the 99 samples of TM-30, which took no part in the choice: median / \
             95th percentile / worst, above in this race, below in the larger collection.",
        );
        ui.scope(|ui| {
            dense(ui);
            egui::ScrollArea::horizontal()
                .id_salt("larger check")
                .auto_shrink([false, true])
                .show(ui, |ui| {
                    ui.vertical(|ui| {
                        ui.spacing_mut().item_spacing.x = 4.0;
                        self.check_table(ui, theme);
                    });
                });
        });
        ui.add_space(4.0);
        for words in &self.others {
            ui.label(words);
        }
    }

    fn table(&self, ui: &mut Ui, theme: Theme) {
        let (names, width) = (scaled(NAMES, theme), scaled(CELL, theme));
        ui.horizontal(|ui| {
            cell(ui, names, "", false);
            for column in COLUMNS {
                let title =
                    RichText::new(format!("{} {}", short_class(column.class), column.numbers));
                cell(ui, width, title.weak(), true).on_hover_text(format!(
                    "{} lights at {} numbers; {} lights in the larger collection.",
                    column.class, column.numbers, column.lamps
                ));
            }
        });
        for (racer, cells, words) in &self.lines {
            ui.add_space(3.0);
            ui.horizontal(|ui| {
                cell(ui, names, RichText::new(short_name(*racer)).strong(), false)
                    .on_hover_text(super::table::about(*racer));
                for beside in cells {
                    let text = beside.map_or_else(
                        || RichText::new("–"),
                        |b| {
                            let mark = if b.differs() { "▲ " } else { "" };
                            let text =
                                format!("{mark}{}/{}", brief(b.ours.median), brief(b.ours.p95));
                            RichText::new(text).small().strong()
                        },
                    );
                    let shown = cell(ui, width, text, true);
                    if let Some(b) = beside {
                        shown.on_hover_text(format!(
                            "{} at {}: {} here against {}, a factor of {:.2}.",
                            b.column.class,
                            b.column.numbers,
                            figure(b.ours.median),
                            figure(b.theirs.median),
                            b.factor()
                        ));
                    }
                }
            });
            ui.horizontal(|ui| {
                cell(ui, names, "", false);
                let line = TABLE.iter().find(|line| line.racer == *racer);
                for figures in line.iter().flat_map(|line| &line.figures) {
                    let text = format!("{}/{}", brief(figures.median), brief(figures.p95));
                    cell(ui, width, RichText::new(text).small().weak(), true);
                }
            });
            let whole = names + 7.0 * (width + 4.0);
            ui.scope(|ui| {
                ui.set_max_width(whole);
                ui.add(egui::Label::new(RichText::new(words).small()).wrap());
            });
        }
    }

    fn check_table(&self, ui: &mut Ui, theme: Theme) {
        let (names, width) = (scaled(NAMES, theme), scaled(136.0, theme));
        ui.horizontal(|ui| {
            cell(ui, names, "", false);
            for title in ["Composite, chosen", "Moments", "Principal components"] {
                cell(ui, width, RichText::new(title).weak(), true);
            }
        });
        for (class, cells) in &self.checked {
            for which in 0..2 {
                ui.horizontal(|ui| {
                    let title = if which == 0 { class.as_str() } else { "" };
                    cell(ui, names, title, false);
                    for pair in cells {
                        let text = RichText::new(&pair[which]).small();
                        let text = if which == 0 {
                            text.strong()
                        } else {
                            text.weak()
                        };
                        cell(ui, width, text, true);
                    }
                });
            }
            ui.add_space(3.0);
        }
    }
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

fn place(race: &Race, racer: Racer) -> Option<usize> {
    race.racers.iter().position(|r| *r == racer)
}

fn checked(race: &Race) -> Vec<(String, Vec<[String; 2]>)> {
    let Some(budget) = race.budgets.iter().position(|n| *n == CHECKED_NUMBERS) else {
        return Vec::new();
    };
    CHECKED
        .iter()
        .filter(|line| race.classes().contains(&line.class))
        .map(|line| {
            let cells = [
                (Racer::Chosen, line.chosen),
                (Racer::Rival(Family::Moments), line.moments),
                (Racer::Rival(Family::Principal), line.principal),
            ]
            .into_iter()
            .map(|(racer, theirs)| {
                let row = place(race, racer).map(|p| race.row(Some(line.class), budget, p));
                let ours = row.and_then(|row| row.check);
                let ours = ours.map_or_else(|| "–".to_owned(), |s| pair(three(s)));
                [ours, pair(theirs)]
            })
            .collect();
            (line.class.to_owned(), cells)
        })
        .collect()
}

/// The half that the composite does not win, on fluorescent lights.
fn others(race: &Race) -> Vec<String> {
    let class = "fluorescent";
    let Some(budget) = race.budgets.iter().position(|n| *n == CHECKED_NUMBERS) else {
        return Vec::new();
    };
    if !race.classes().contains(&class) {
        return Vec::new();
    }
    let mut words = vec![format!(
        "On fluorescent lights at {CHECKED_NUMBERS} numbers, behind narrow filters (median/95th \
         percentile/worst) and rms behind 10 nm (median/95th percentile):"
    )];
    for other in OTHER_HALF {
        let Some(place) = place(race, other.racer) else {
            continue;
        };
        let row = race.row(Some(class), budget, place);
        let (Some(filters), Some(rms)) = (row.filters, row.relative_rms_10nm) else {
            continue;
        };
        words.push(format!(
            "{}: {} and {}/{} here, {} and {}/{} in the larger collection.",
            other.racer.title(),
            pair(three(filters)),
            figure(rms.median),
            figure(rms.p95),
            pair(other.filters),
            figure(other.relative_rms_10nm[0]),
            figure(other.relative_rms_10nm[1]),
        ));
    }
    let (mut without, mut all) = (0, 0);
    if let Some(place) = place(race, Racer::Chosen) {
        for lamp in race.of_class(Some(class)) {
            all += 1;
            without += usize::from(race.run(lamp, budget, place).spikes == 0);
        }
        let with = race
            .racers
            .iter()
            .enumerate()
            .filter(|(_, racer)| matches!(racer, Racer::Composite(_)))
            .filter_map(|(i, racer)| {
                let spread = spread_of(race, Some(class), budget, i, Measure::Filters)?;
                Some((racer, spread.median))
            })
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let best = with.map_or_else(String::new, |(racer, median)| {
            format!(
                " Behind narrow filters the best composite is {}, median {}.",
                racer.title(),
                figure(median)
            )
        });
        words.push(format!(
            "The choice is by the patches alone: on {without} of {all} lights it takes no spike.{best}"
        ));
    }
    words
}
