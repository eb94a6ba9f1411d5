//! "By the instrument": what the meter computed beside what the program computes.

use crate::languages::{Language, in_language};
use eframe::egui;
use egui::Ui;

use super::{
    kit::{figure_grid, pressed_small},
    theme::section,
};
use crate::{
    app::{
        App, ByAddress, Entry, Memo,
        figures::of_quantity,
        makers::{self, Beside, NOT_YET, beside},
        numbers::signed,
        spectral_unit::{Counted, SpectralUnit},
        ticks::short,
    },
    io::Quantity,
    languages::{said, with_sign},
};

/// The table, computed once an entry.
#[derive(Default)]
pub(super) struct MakersView {
    made: Memo<ByAddress<Entry>, Vec<Beside>>,
    /// Whether its table stands in the place of our own numbers.
    is_open: bool,
}

impl MakersView {
    /// Where the shown spectrum has such numbers, two tabs: ours, and theirs beside ours. Below
    /// each other they would not fit in a window of 800 points. Whether theirs are open.
    pub(super) fn tabs(&mut self, ui: &mut Ui, app: &App) -> bool {
        let makers = app.document().subject_entry().makers.len();
        if makers == 0 {
            self.made = Memo::default();
            return false;
        }
        ui.horizontal(|ui| {
            ui.selectable_value(&mut self.is_open, false, said!("Colour and error"));
            let words = tr!("By the instrument ({makers})", makers);
            ui.selectable_value(&mut self.is_open, true, words)
                .on_hover_text(said!(
                    "The figures that the instrument wrote into the file, beside ours."
                ));
        });
        self.is_open
    }

    /// Draws the instrument's numbers; says what was copied.
    pub(super) fn show(&mut self, ui: &mut Ui, app: &App) -> Option<String> {
        let entry = app.document().subject_entry();
        let of = ByAddress(entry.clone());
        let rows = &*self.made.get(of, |entry| beside(&entry.0));
        let mut said = None;
        ui.horizontal(|ui| {
            section(ui, said!("By the instrument"));
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let meaning = said!("Copies every number of the instrument beside ours.");
                if pressed_small(ui, said!("Copy CSV"), meaning) {
                    let csv = in_language(Language::English, || makers::table(rows).csv());
                    ui.ctx().copy_text(csv.trim_end().to_owned());
                    said = Some(
                        said!("Copied as CSV: the instrument's numbers beside ours.").to_owned(),
                    );
                }
            });
        });
        let (near, far): (Vec<&Beside>, Vec<&Beside>) = rows.iter().partition(|row| is_near(row));
        table(ui, "by the instrument", &near);
        if !far.is_empty() {
            egui::CollapsingHeader::new(tr!(
                "{n} more of the instrument's" | "{n} more of the instrument's" % far.len()
            ))
            .id_salt("more by the instrument")
            .show(ui, |ui| table(ui, "more by the instrument", &far));
        }
        said
    }
}

/// Whether a row stands in the short table: what has a number of ours, and Ra, which people miss.
fn is_near(row: &Beside) -> bool {
    row.ours.is_ok() || row.quantity == Quantity::Ra
}

fn table(ui: &mut Ui, id: &str, rows: &[&Beside]) {
    figure_grid(ui, id, |ui| {
        ui.weak("");
        ui.weak(said!("instrument"))
            .on_hover_text(said!("As the file states it."));
        ui.weak(said!("ours")).on_hover_text(said!(
            "From the whole measured spectrum: colours and lux by 1 nm sums over 360-830 nm (CIE \
             1931), totals over the table's own points."
        ));
        ui.weak(said!("difference"))
            .on_hover_text(said!("Ours less theirs."));
        ui.end_row();
        for row in rows {
            line(ui, row);
        }
    });
}

fn line(ui: &mut Ui, row: &Beside) {
    let decimals = decimals(&row.quantity);
    let written = |value: f64| match decimals {
        Some(decimals) => with_sign(format!("{value:.decimals$}")),
        None => short(value),
    };
    let quantity = match &row.quantity {
        Quantity::PeakNm => said!("peak").to_owned(),
        Quantity::DominantNm => said!("dominant").to_owned(),
        other => shortened(&other.to_string()),
    };
    let name = match row.unit.as_str() {
        "" => quantity,
        unit => format!("{quantity}, {}", unit_words(unit)),
    };
    let figure = of_quantity(&row.quantity).map(|(known, _)| known.figure.meaning());
    ui.label(name)
        .on_hover_text(figure.unwrap_or_else(|| meaning(&row.quantity)));
    ui.monospace(written(row.theirs));
    match row.ours {
        Ok(ours) => {
            ui.monospace(written(ours));
            let difference = ours - row.theirs;
            let percent = 100.0 * difference / row.theirs;
            let text = match decimals {
                Some(decimals) => signed(difference, decimals),
                None if percent.is_finite() => format!("{} %", signed(percent, 2)),
                None => short(difference),
            };
            match row.told_to.filter(|_| row.is_as_told()) {
                Some(told_to) => ui.weak(said!("as told")).on_hover_text(tr!(
                    "As far as the file's figures tell: it writes {figure} and so leaves ±{width} \
                     open; the difference, {difference}, is within that.",
                    figure = short(row.theirs),
                    width = short(told_to),
                    difference = text
                )),
                None => ui.monospace(text),
            };
        }
        Err(why) => {
            ui.monospace("–");
            ui.small(egui::RichText::new(said(why)).weak())
                .on_hover_text(if why == NOT_YET {
                    said!("This program has no such number yet.")
                } else {
                    said!("Why this program has no number for this spectrum.")
                });
        }
    }
    ui.end_row();
}

/// Decimals of quantities whose differences are told as such; others differ by per cent.
fn decimals(quantity: &Quantity) -> Option<usize> {
    match quantity {
        Quantity::PeakNm | Quantity::Purity => Some(1),
        known => of_quantity(known).map(|(known, _)| known.figure.digits),
    }
}

fn meaning(quantity: &Quantity) -> &'static str {
    match quantity {
        Quantity::Illuminance => said!("Illuminance: 683 lm/W times the sum with y-bar, lx."),
        Quantity::Luminance => said!("Luminance: 683 lm/W times the sum with y-bar, cd m⁻²."),
        Quantity::Irradiance => said!("Power on an area, over the whole table."),
        Quantity::Ppfd => said!("Photons of 400-700 nm on an area, µmol m⁻² s⁻¹."),
        Quantity::Pfd => said!("Photons on an area over the whole table, µmol m⁻² s⁻¹."),
        Quantity::TristimulusX | Quantity::TristimulusY | Quantity::TristimulusZ => {
            said!("Tristimulus value of CIE 1931, Y in lx.")
        }
        Quantity::PeakNm => said!("Wavelength of the largest value of the table, nm."),
        _ => said!("A number of the maker's own, in the maker's words."),
    }
}

/// The maker's own words can be long; the panel must not grow with them.
fn shortened(words: &str) -> String {
    match words.char_indices().nth(20) {
        Some((end, _)) => format!("{}…", &words[..end]),
        None => words.to_owned(),
    }
}

/// A unit with raised exponents, spelled alike for every maker.
fn unit_words(unit: &str) -> String {
    let photons = |u: &SpectralUnit| {
        u.counted == Counted::Micromoles && u.factor == 1.0 && u.per_area && !u.per_nm
    };
    if SpectralUnit::of(unit).is_some_and(|u| photons(&u) && !u.per_steradian) {
        return "µmol m⁻² s⁻¹".to_owned();
    }
    unit.replace("-1", "⁻¹").replace("-2", "⁻²")
}
