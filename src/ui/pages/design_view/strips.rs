//! The channels of the desk: what each is, its fader and its switches.

use eframe::egui;
use egui::{DragValue, Ui, vec2};

use super::{Fader, change};
use crate::{
    app::design::{
        Desk, Strip,
        mix::{FULL, GROUPS, MixChannel},
        named_lines::NamedLine,
    },
    design::mixture::Source,
    ui::{
        kit::{cell, named, number, sign_button},
        pages::PageContext,
        swatch,
    },
};

/// Thickest gel of the fader.
const THICKEST: f64 = 4.0;

/// Width of what a channel is, points.
const WHAT: f32 = 164.0;

/// The channels, one below the other.
pub(super) fn show(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk, lines: &[NamedLine]) {
    let mut gone = None;
    for (index, (channel, strip)) in desk.mix.channels.iter().zip(&desk.strips).enumerate() {
        let mut after = channel.clone();
        let row = ui.push_id(index, |ui| {
            ui.horizontal(|ui| one(ui, context, strip, &mut after, lines, index + 1))
                .inner
        });
        if row.inner {
            gone = Some(index);
        } else if after != *channel {
            change(context, |mix| mix.channels[index] = after);
        }
    }
    if let Some(index) = gone {
        change(context, |mix| drop(mix.channels.remove(index)));
    }
}

/// One channel; whether it goes.
fn one(
    ui: &mut Ui,
    context: &PageContext<'_>,
    strip: &Strip,
    channel: &mut MixChannel,
    lines: &[NamedLine],
    place: usize,
) -> bool {
    let scale = context.theme.scale;
    let (rect, response) = ui.allocate_exact_size(vec2(14.0, 18.0) * scale, egui::Sense::hover());
    ui.painter()
        .rect_filled(rect, 2.0, swatch::colour(strip.colour));
    swatch::outline(ui, rect, ui.visuals().widgets.noninteractive.bg_stroke);
    response.on_hover_text(&strip.title);
    cell(ui, WHAT * scale, |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        what(ui, strip, channel, lines, place);
    });
    ui.spacing_mut().item_spacing.x = 4.0;
    let buttons = 5.0 * (ui.spacing().interact_size.y + 8.0);
    Fader {
        name: &format!("Fader {place}"),
        meaning: "Its power, per cent of the most it can give; the same for each channel.",
        range: 0.0..=FULL,
        digits: 1,
        suffix: " %",
        logarithmic: false,
    }
    .show(ui, &mut channel.level, buttons, scale);
    let mut switch = |on: &mut bool, sign: &str, name: &str, meaning: &str| {
        let button = ui.toggle_value(on, sign);
        named(&button, egui::Role::CheckBox, &format!("{name} {place}"));
        button.on_hover_text(format!("{name}: {meaning}"));
    };
    switch(&mut channel.mute, "M", "Mute", "switches this channel off.");
    switch(
        &mut channel.solo,
        "S",
        "Solo",
        "switches all other channels off.",
    );
    switch(
        &mut channel.lock,
        "L",
        "Lock",
        "solving leaves this fader where it is.",
    );
    let words = match channel.group {
        0 => "–".to_owned(),
        group => group.to_string(),
    };
    let group = ui.selectable_label(channel.group > 0, words);
    named(&group, egui::Role::Button, &format!("Group {place}"));
    if group.clicked() {
        channel.group = (channel.group + 1) % (GROUPS + 1);
    }
    group.on_hover_text(
        "Group: click to put the channel into group 1, 2, 3 or none. Each group has a fader below, \
         which moves all of it.",
    );
    let name = format!("Remove {place}");
    sign_button(ui, "✖", &name, "Takes the channel off the desk.")
}

/// What stands before all channels, one below the other.
pub(super) fn gels(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    let scale = context.theme.scale;
    let mut gone = None;
    for (index, gel) in desk.mix.gels.iter().enumerate() {
        let mut after = gel.clone();
        ui.push_id(("gel", index), |ui| {
            ui.horizontal(|ui| {
                ui.label("Gel");
                let name = context.app.document().name_of(&gel.key);
                cell(ui, WHAT * scale, |ui| {
                    ui.add(egui::Label::new(name).truncate())
                        .on_hover_text(&gel.key);
                });
                Fader {
                    name: &format!("Thickness of gel {}", index + 1),
                    meaning: "How thick it is, as a multiple of what was measured (Beer-Lambert); \
                              0 is no gel at all.",
                    range: 0.0..=THICKEST,
                    digits: 2,
                    suffix: " ×",
                    logarithmic: false,
                }
                .show(ui, &mut after.thickness, 30.0 * scale, scale);
                let name = format!("Remove gel {}", index + 1);
                if sign_button(ui, "✖", &name, "Takes the gel off.") {
                    gone = Some(index);
                }
            });
        });
        if after != *gel {
            change(context, |mix| mix.gels[index] = after);
        }
    }
    if let Some(index) = gone {
        change(context, |mix| drop(mix.gels.remove(index)));
    }
}

/// What a channel is, to change it.
fn what(ui: &mut Ui, strip: &Strip, channel: &mut MixChannel, lines: &[NamedLine], place: usize) {
    let value = |ui: &mut Ui, value: &mut f64, speed: f64, suffix: &str, name: &str| {
        let box_of = DragValue::new(value)
            .speed(speed)
            .max_decimals(2)
            .suffix(suffix);
        number(ui, box_of, &format!("{name} {place}"))
            .on_hover_text(format!("{name}: drag, or click to type."));
    };
    match &mut channel.source {
        Source::Line { at_nm } => {
            let menu = ui.menu_button("line", |ui| {
                if let Some(found) = line_menu(ui, lines) {
                    *at_nm = found;
                }
            });
            menu.response
                .on_hover_text("Puts it on a line that has a name.");
            value(ui, at_nm, 0.1, " nm", "Place");
            let is_it = |line: &&NamedLine| (line.at_nm - *at_nm).abs() < 0.05;
            if let Some(line) = lines.iter().find(is_it) {
                ui.add(egui::Label::new(line.of).truncate());
            }
        }
        Source::Gauss { centre_nm, fwhm_nm } => {
            ui.label("LED");
            value(ui, centre_nm, 0.2, "", "Centre");
            ui.label("±")
                .on_hover_text("Half of its full width at half its height.");
            let mut half = 0.5 * *fwhm_nm;
            value(ui, &mut half, 0.1, " nm", "Half width");
            *fwhm_nm = 2.0 * half;
        }
        Source::Blackbody { kelvin } => {
            ui.label("blackbody");
            value(ui, kelvin, 10.0, " K", "Temperature");
        }
        Source::Daylight { kelvin } => {
            ui.label("daylight");
            value(ui, kelvin, 10.0, " K", "Temperature");
        }
        Source::Named(key) => {
            let words = match &strip.light {
                Ok(_) => strip.title.clone(),
                Err(_) => format!("{} gives no light", strip.title),
            };
            let hover = match &strip.light {
                Ok(_) => key.clone(),
                Err(why) => why.to_string(),
            };
            ui.add(egui::Label::new(words).truncate())
                .on_hover_text(hover);
        }
    }
}

/// The lines that have names, by what shines there; the place of the one that was chosen.
pub(super) fn line_menu(ui: &mut Ui, lines: &[NamedLine]) -> Option<f64> {
    let mut chosen = None;
    let mut sort: Vec<(&str, Vec<&NamedLine>)> = Vec::new();
    for line in lines {
        let of = if line.of.starts_with("laser") {
            "Lasers"
        } else {
            line.of
        };
        match sort.iter_mut().find(|(name, _)| *name == of) {
            Some((_, all)) => all.push(line),
            None => sort.push((of, vec![line])),
        }
    }
    for (of, lines) in sort {
        ui.menu_button(of, |ui| {
            for line in lines {
                let words = format!("{} {:.1} nm", line.of, line.at_nm);
                if ui.button(words).clicked() {
                    chosen = Some(line.at_nm);
                    ui.close();
                }
            }
        });
    }
    chosen
}
