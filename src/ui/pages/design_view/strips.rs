//! The channels of the desk: what each is, its fader and its switches.

use crate::ui::kit::{drag_value, slide};
use eframe::egui;
use egui::{Button, Color32, RichText, ScrollArea, Ui, Vec2, style::HandleShape, vec2};

use super::{Fader, change};
use crate::{
    app::{
        chart::elided,
        design::{
            Desk, Strip,
            mix::{FULL, GROUPS, MixChannel},
            named_lines::NamedLine,
        },
        ticks::short,
    },
    design::mixture::Source,
    languages::{fixed, said},
    ui::{
        kit::{cell, column, named, number, sign_button},
        pages::PageContext,
        swatch,
        theme::Theme,
    },
};

/// Thickest gel of the fader.
const THICKEST: f64 = 4.0;

/// Width of what a gel is, points.
const WHAT: f32 = 110.0;

/// Least and largest distance of two faders, points.
const APART: [f32; 2] = [48.0, 120.0];

/// Letters of a light's name below its fader.
const LETTERS: usize = 11;

/// Height of what stands below a fader, points.
const BELOW: f32 = 62.0;

/// Thickness of an upright fader's handle and track, points.
const HANDLE: f32 = 34.0;
const TRACK: f32 = 6.0;

/// The faders side by side, those of groups and of all together at the right; a click on a
/// channel's name chooses it.
pub(super) fn faders(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    desk: &Desk,
    chosen: &mut usize,
    high: f32,
) {
    let scale = context.theme.scale;
    let groups: Vec<(u8, f64)> = (1..=GROUPS)
        .filter_map(|group| Some((group, desk.mix.group_highest(group)?)))
        .collect();
    let count = desk.mix.channels.len() + groups.len() + 1;
    let apart = (ui.available_width() / count as f32).clamp(APART[0] * scale, APART[1] * scale);
    let size = vec2(apart, high);
    ScrollArea::horizontal()
        .id_salt("faders")
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 0.0;
                for index in 0..desk.mix.channels.len() {
                    channel(ui, context, (desk, index), chosen, size);
                }
                for (group, highest) in groups {
                    let name = tr!("Fader of group {group}", group);
                    let says = tr!("Group {group}", group);
                    let meaning = said!("Moves all faders of the group together.");
                    if let Some(to) = together(ui, context, [&says, &name, meaning], highest, size)
                    {
                        change(context, |mix| *mix = mix.clone().group_dimmed(group, to));
                    }
                }
                let meaning =
                    said!("Moves all faders together: brighter or darker at constant colour.");
                let all = [said!("All"), said!("All faders"), meaning];
                if let Some(to) = together(ui, context, all, desk.mix.highest(), size) {
                    change(context, |mix| *mix = mix.clone().dimmed(to));
                }
            });
        });
}

/// A channel's fader over its value and name.
fn channel(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (desk, index): (&Desk, usize),
    chosen: &mut usize,
    size: Vec2,
) {
    let (channel, strip) = (&desk.mix.channels[index], &desk.strips[index]);
    let mut level = channel.level;
    let is_heard = desk.mix.is_heard(channel);
    let colour = match is_heard {
        true => swatch::colour(strip.colour),
        false => context.theme.track,
    };
    let name = format!("Fader {}", index + 1);
    let meaning = said!("Its power, per cent of the most it can give; the same for each channel.");
    column(ui, size, |ui| {
        upright(
            ui,
            (&name, meaning),
            &mut level,
            (colour, size.y, context.theme),
        );
        let [what, place] = short_words(channel, strip);
        ui.vertical_centered(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let words = RichText::new(format!("{what}\n{place}")).small();
            let words = if is_heard { words } else { words.weak() };
            let button = Button::selectable(*chosen == index, words);
            let button = ui.add_sized([size.x - 4.0, 34.0 * context.theme.scale], button);
            named(
                &button,
                egui::Role::Button,
                &format!("Channel {}: {}", index + 1, strip.title),
            );
            if button.clicked() {
                *chosen = index;
            }
            button.on_hover_text(tr!(
                "{channel}. Click for its place and its switches.",
                channel = strip.title
            ));
        });
    });
    if level != channel.level {
        change(context, |mix| mix.channels[index].level = level);
    }
}

/// What a channel is, in two short lines.
fn short_words(channel: &MixChannel, strip: &Strip) -> [String; 2] {
    let nm = |nm: f64| format!("{} nm", short(nm));
    match &channel.source {
        Source::Line { at_nm } => [said!("Line").to_owned(), nm(*at_nm)],
        Source::Gauss { centre_nm, .. } => ["LED".to_owned(), nm(*centre_nm)],
        Source::Blackbody { kelvin } => [said!("Blackbody").to_owned(), format!("{kelvin:.0} K")],
        Source::Daylight { kelvin } => [said!("Daylight").to_owned(), format!("{kelvin:.0} K")],
        Source::Named(_) => [elided(&strip.title, LETTERS), String::new()],
    }
}

/// One fader that moves several, under its name: where it was drawn to.
fn together(
    ui: &mut Ui,
    context: &PageContext<'_>,
    [says, name, meaning]: [&str; 3],
    highest: f64,
    size: Vec2,
) -> Option<f64> {
    let mut now = highest;
    column(ui, size, |ui| {
        // From nothing there is no way up: the shares would be lost.
        ui.add_enabled_ui(highest > 0.0, |ui| {
            let colour = ui.visuals().text_color();
            upright(
                ui,
                (name, meaning),
                &mut now,
                (colour, size.y, context.theme),
            );
        });
        ui.vertical_centered(|ui| ui.label(RichText::new(says).small()));
    });
    (now != highest).then_some(now.max(0.1))
}

/// An upright fader with its number below.
fn upright(
    ui: &mut Ui,
    (name, meaning): (&str, &str),
    level: &mut f64,
    (colour, high, theme): (Color32, f32, Theme),
) {
    let scale = theme.scale;
    ui.vertical_centered(|ui| {
        ui.scope(|ui| {
            let spacing = ui.spacing_mut();
            spacing.slider_width = (high - BELOW * scale).max(40.0);
            spacing.slider_rail_height = TRACK * scale;
            spacing.interact_size.y = HANDLE * scale;
            let visuals = ui.visuals_mut();
            visuals.selection.bg_fill = colour;
            visuals.widgets.inactive.bg_fill = theme.track;
            let handle = HandleShape::Rect { aspect_ratio: 0.5 };
            let slider = slide(level, 0.0..=FULL)
                .vertical()
                .trailing_fill(true)
                .handle_shape(handle)
                .show_value(false);
            let slider = ui.add(slider);
            named(&slider, egui::Role::Slider, name);
            slider.on_hover_text(meaning);
        });
        let drag = drag_value(level)
            .range(0.0..=FULL)
            .speed(0.2)
            .max_decimals(1)
            .custom_formatter(|value, _| format!("{value:.0}"))
            .suffix(" %");
        number(ui, drag, name).on_hover_text(meaning);
    });
}

/// What the chosen channel is, and its switches.
pub(super) fn chosen(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (desk, lines): (&Desk, &[NamedLine]),
    chosen: &mut usize,
) {
    *chosen = (*chosen).min(desk.mix.channels.len().saturating_sub(1));
    let index = *chosen;
    let Some((channel, strip)) = desk.mix.channels.get(index).zip(desk.strips.get(index)) else {
        ui.weak(said!("Add a channel to begin."));
        return;
    };
    let mut after = channel.clone();
    let place = index + 1;
    ui.horizontal(|ui| {
        let size = vec2(12.0, 16.0) * context.theme.scale;
        let (rect, _) = ui.allocate_exact_size(size, egui::Sense::hover());
        ui.painter()
            .rect_filled(rect, 2.0, swatch::colour(strip.colour));
        swatch::outline(ui, rect, ui.visuals().widgets.noninteractive.bg_stroke);
        what(ui, strip, &mut after, lines, place);
    });
    let gone = ui
        .horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            switches(ui, &mut after, place)
        })
        .inner;
    if gone {
        change(context, |mix| drop(mix.channels.remove(index)));
    } else if after != *channel {
        change(context, |mix| mix.channels[index] = after);
    }
}

/// A channel's switches; whether it goes.
fn switches(ui: &mut Ui, channel: &mut MixChannel, place: usize) -> bool {
    let mut switch = |on: &mut bool, says: &str, name: String, meaning: &str| {
        let button = ui.toggle_value(on, says);
        named(&button, egui::Role::CheckBox, &name);
        button.on_hover_text(meaning);
    };
    switch(
        &mut channel.mute,
        said!("Off"),
        tr!("Mute {channel}", channel = place),
        said!("Switches this channel off."),
    );
    switch(
        &mut channel.solo,
        said!("Only this"),
        tr!("Solo {channel}", channel = place),
        said!("Switches all other channels off."),
    );
    switch(
        &mut channel.lock,
        said!("Locked"),
        tr!("Lock {channel}", channel = place),
        said!("Solving leaves this fader where it is."),
    );
    let words = match channel.group {
        0 => said!("No group").to_owned(),
        group => tr!("Group {group}", group),
    };
    let group = ui.selectable_label(channel.group > 0, words);
    named(
        &group,
        egui::Role::Button,
        &tr!("Group of channel {channel}", channel = place),
    );
    if group.clicked() {
        channel.group = (channel.group + 1) % (GROUPS + 1);
    }
    group.on_hover_text(said!(
        "Click to put the channel into group 1, 2, 3 or none. Each group has a fader at the right, \
         which moves all of it."
    ));
    let name = tr!("Remove {channel}", channel = place);
    sign_button(
        ui,
        said!("Remove"),
        &name,
        said!("Takes the channel off the desk."),
    )
}

/// What stands before all channels, one below the other.
pub(super) fn gels(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    let scale = context.theme.scale;
    let mut gone = None;
    for (index, gel) in desk.mix.gels.iter().enumerate() {
        let mut after = gel.clone();
        ui.push_id(("gel", index), |ui| {
            ui.horizontal(|ui| {
                ui.label(said!("Gel"));
                let name = context.app.document().name_of(&gel.key);
                cell(ui, WHAT * scale, |ui| {
                    ui.add(egui::Label::new(name).truncate())
                        .on_hover_text(&gel.key);
                });
                Fader {
                    name: &tr!("Thickness of gel {number}", number = index + 1),
                    meaning: said!(
                        "How thick it is, as a multiple of what was measured (Beer-Lambert); 0 is \
                         no gel at all."
                    ),
                    range: 0.0..=THICKEST,
                    digits: 2,
                    suffix: " ×",
                    logarithmic: false,
                }
                .show(ui, &mut after.thickness, 30.0 * scale, scale);
                let name = tr!("Remove gel {number}", number = index + 1);
                if sign_button(ui, "✖", &name, said!("Takes the gel off.")) {
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
    // Lessons point at it by its English name.
    let value = |ui: &mut Ui, value: &mut f64, speed: f64, suffix: &str, name: &'static str| {
        let box_of = drag_value(value)
            .speed(speed)
            .max_decimals(2)
            .suffix(suffix);
        number(ui, box_of, &format!("{name} {place}"))
            .on_hover_text(tr!("{name}: drag, or click to type.", name = said(name)));
    };
    match &mut channel.source {
        Source::Line { at_nm } => {
            let menu = ui.menu_button(said!("line"), |ui| {
                if let Some(found) = line_menu(ui, lines) {
                    *at_nm = found;
                }
            });
            menu.response
                .on_hover_text(said!("Puts it on a line that has a name."));
            value(ui, at_nm, 0.1, " nm", later!("Place"));
            let is_it = |line: &&NamedLine| (line.at_nm - *at_nm).abs() < 0.05;
            if let Some(line) = lines.iter().find(is_it) {
                ui.add(egui::Label::new(said(line.of)).truncate());
            }
        }
        Source::Gauss { centre_nm, fwhm_nm } => {
            ui.label("LED");
            value(ui, centre_nm, 0.2, "", later!("Centre"));
            ui.label("±")
                .on_hover_text(said!("Half of its full width at half its height."));
            let mut half = 0.5 * *fwhm_nm;
            value(ui, &mut half, 0.1, " nm", later!("Half width"));
            *fwhm_nm = 2.0 * half;
        }
        Source::Blackbody { kelvin } => {
            ui.label(said!("blackbody"));
            value(ui, kelvin, 10.0, " K", later!("Temperature"));
        }
        Source::Daylight { kelvin } => {
            ui.label(said!("daylight"));
            value(ui, kelvin, 10.0, " K", later!("Temperature"));
        }
        Source::Named(key) => {
            let words = match &strip.light {
                Ok(_) => strip.title.clone(),
                Err(_) => tr!("{channel} gives no light", channel = strip.title),
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
    let mut sort: Vec<(&'static str, Vec<&NamedLine>)> = Vec::new();
    for line in lines {
        let of = if line.of.starts_with("laser") {
            later!("Lasers")
        } else {
            line.of
        };
        match sort.iter_mut().find(|(name, _)| *name == of) {
            Some((_, all)) => all.push(line),
            None => sort.push((of, vec![line])),
        }
    }
    for (of, lines) in sort {
        ui.menu_button(said(of), |ui| {
            for line in lines {
                let words = format!("{} {} nm", said(line.of), fixed(line.at_nm, 1));
                if ui.button(words).clicked() {
                    chosen = Some(line.at_nm);
                    ui.close();
                }
            }
        });
    }
    chosen
}
