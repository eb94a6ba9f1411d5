//! The lines as a table: place, weight, share, name; each can be changed, locked, deleted.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::{Align, Layout, Ui};

use super::{
    kit::{named_choice, number, pressed, sign_button},
    theme::Theme,
};
use crate::{
    app::{App, SpikeAct, ticks},
    languages::fixed,
};

/// Draws the table; an act is pushed for the window to carry out.
pub(super) fn table(ui: &mut Ui, app: &App, theme: Theme, acts: &mut Vec<SpikeAct>) {
    let derived = app.derived();
    let factor = app.scale_factor();
    let spikes = &derived.parts.spikes;
    if spikes.is_empty() {
        ui.add_space(6.0);
        ui.weak(if app.document().settings.spikes {
            said!("No lines. Push Lines to the right, or set one: + Line above the plot.")
        } else {
            said!("Lines are switched off.")
        });
        return;
    }
    let band = derived.band;
    egui::ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        egui::Grid::new("spikes")
            .num_columns(7)
            .striped(true)
            .spacing([5.0 * theme.scale, 2.0])
            .show(ui, |ui| {
                titles(ui, app);
                for (index, spike) in spikes.iter().enumerate() {
                    let (mut at_nm, mut weight) = (spike.spike.at_nm, spike.spike.weight * factor);
                    let place = drag_value(&mut at_nm)
                        .speed(0.1)
                        .range(band.min_nm()..=band.max_nm())
                        .fixed_decimals(2);
                    let place = number(ui, place, &tr!("Line {number} place", number = index + 1));
                    let size = weight.abs().max(f64::MIN_POSITIVE);
                    let power = drag_value(&mut weight)
                        .speed(0.01 * size)
                        .custom_formatter(|v, _| ticks::short(v));
                    let power = number(ui, power, &tr!("Line {number} weight", number = index + 1));
                    if place.changed() || power.changed() {
                        acts.push(SpikeAct::Set {
                            index,
                            at_nm,
                            weight: weight / factor,
                        });
                    }
                    let share = derived.parts.share(spike.spike.weight);
                    figure(ui, share.map(|share| fixed(100.0 * share, 2)));
                    figure(ui, spike.width_nm.map(|width| fixed(width, 1)));
                    let name = app.spike_names().get(index);
                    let line = ui.label(name.and_then(|n| n.label.as_deref()).unwrap_or("–"));
                    if let Some(whole) = name.and_then(|n| n.safe.as_deref()) {
                        line.clone().on_hover_text(whole);
                    }
                    if spike.peaks > 1 {
                        line.on_hover_text(tr!(
                            "{count} peaks without a valley between them make one line. Another \
                             threshold can part or join them.",
                            count = spike.peaks
                        ));
                    }
                    ui.horizontal(|ui| hand(ui, index, spike.hand.is_some(), acts));
                    ui.end_row();
                }
            });
    });
}

/// A number with its decimal point under the others', or a dash.
fn figure(ui: &mut Ui, figure: Option<String>) {
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.label(figure.as_deref().unwrap_or("–"))
    });
}

fn titles(ui: &mut Ui, app: &App) {
    let unit = app.unit();
    ui.weak("nm");
    ui.weak(said!("weight"))
        .on_hover_text(match unit.is_empty() {
            true => said!("Radiant power of the line, in the file's unit x nm.").to_owned(),
            false => tr!("Radiant power of the line, in {unit} x nm.", unit),
        });
    for (title, meaning) in [
        ("%", said!("Of the total power in the range, percent.")),
        (
            said!("width, nm"),
            said!("Full width at half maximum of the measured line, nm."),
        ),
    ] {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.weak(title).on_hover_text(meaning)
        });
    }
    ui.weak(said!("line"))
        .on_hover_text(said!("Named only where the name is safe."));
    ui.weak(said!("lock"));
    ui.end_row();
}

/// Locks a spike, or deletes it.
fn hand(ui: &mut Ui, index: usize, mut locked: bool, acts: &mut Vec<SpikeAct>) {
    let lock = ui
        .checkbox(&mut locked, "")
        .on_hover_text(said!("Keeps this line whatever the threshold is."));
    let number = index + 1;
    let name = tr!("Lock line {number}", number);
    named_choice(&lock, egui::Role::CheckBox, locked, &name);
    if lock.changed() {
        acts.push(if locked {
            SpikeAct::Lock { index }
        } else {
            SpikeAct::Unlock { index }
        });
    }
    let name = tr!("Delete line {number}", number);
    let meaning = said!("Removes this line; its light goes back to the waves.");
    if sign_button(ui, "✕", &name, meaning) {
        acts.push(SpikeAct::Delete { index });
    }
}

/// The row above the table.
pub(super) fn head(ui: &mut Ui, app: &App, acts: &mut Vec<SpikeAct>) {
    let edits = app.document().subject_edits();
    ui.weak(said!("Drag lines in the plot or edit them here."));
    let meaning = said!("Back to the lines that are found.");
    if !edits.is_empty() && pressed(ui, said!("Forget hand edits"), meaning) {
        acts.push(SpikeAct::Reset);
    }
}
