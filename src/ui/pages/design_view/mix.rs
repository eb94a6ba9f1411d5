//! The page "Mix": faders, the diagram, the spectrum of the mixture.

use eframe::egui;
use egui::{Ui, vec2};

use super::{DesignView, Fader, change, headline, set, strips};
use crate::{
    app::{
        Command, Gel, MadeFor,
        charts::design::{held_at, mixed_spectrum},
        design::{
            Beside, Desk, DeskSurfaces, beside,
            mix::{FULL, GROUPS, MOST_CHANNELS, MOST_GELS, MixChannel, Snapshot},
            named_lines::{NamedLine, snapped},
        },
    },
    design::mixture::Source,
    ui::{
        chart_view::ChartView,
        kit::{Choice, Chooser, column, copy_button, lights, scrolled, transmittances},
        pages::PageContext,
        swatch,
    },
};

/// From this width on the diagram stands beside the faders, points.
const WIDE: f32 = 840.0;

/// How near to a line or an LED a drag takes hold of it, nm.
const REACH_NM: f64 = 12.0;

/// Most surfaces in a row, and rows: more would leave no room for faders.
const IN_ROW: usize = 24;
const MOST_ROWS: usize = 2;

/// Height of a row of surfaces, points.
const SWATCH: f32 = 28.0;

/// How near to a named line a dragged one snaps to it, nm.
const SNAP_NM: f64 = 0.8;

impl DesignView {
    /// Channels mixed by hand.
    pub(crate) fn mix(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        self.refresh(context.app);
        let Some(desk) = self.desk.held().cloned() else {
            return;
        };
        let lines = self.lines.held().cloned().unwrap_or_default();
        let document = context.app.document();
        let key = (context.app.revision(), context.memory.desk_surfaces);
        let beside = self
            .beside
            .get(key, |(_, surfaces)| beside(&desk, *surfaces, document))
            .clone();
        headline(
            ui,
            context,
            [swatch::colour(desk.swatch().rgb8); 2],
            "Its colour as bright as the screen can show it.",
            &desk.sentence(),
        );
        ui.add_space(4.0);
        let room = ui.available_size();
        let scale = context.theme.scale;
        if room.x >= WIDE * scale {
            let left = (0.5 * room.x).min(620.0 * scale);
            ui.horizontal_top(|ui| {
                let faders = vec2(left, room.y);
                column(ui, faders, |ui| {
                    faders_of(ui, context, &desk, (&lines, &beside));
                });
                ui.vertical(|ui| {
                    let width = ui.available_width();
                    let gap = ui.spacing().item_spacing.y;
                    let high = (0.58 * room.y).floor();
                    self.diagram(ui, context, None, vec2(width, high));
                    self.spectrum(ui, context, &desk, &lines, vec2(width, room.y - high - gap));
                });
            });
        } else {
            scrolled(ui, "mix", |ui| {
                let width = ui.available_width();
                self.diagram(ui, context, None, vec2(width, 0.5 * room.y));
                add_row(ui, context, &desk, &lines);
                strips::show(ui, context, &desk, &lines);
                strips::gels(ui, context, &desk);
                below(ui, context, &desk, &beside);
                self.spectrum(ui, context, &desk, &lines, vec2(width, 0.4 * room.y));
            });
        }
    }

    /// The mixture over the wavelengths; lines and LEDs can be dragged.
    fn spectrum(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        desk: &Desk,
        lines: &[NamedLine],
        size: egui::Vec2,
    ) {
        let key = context.app.revision();
        let chart = &*self.spectrum.get(key, |_| mixed_spectrum(desk));
        let mut shown = ChartView::held(ui, chart, "mixed spectrum", size, context.theme);
        context.ask_for_chart(shown.wish.take());
        let Some([at_nm, _]) = shown.dragged else {
            self.held = None;
            return;
        };
        if shown.response.drag_started() {
            self.held = held_at(desk, at_nm, REACH_NM);
        }
        let Some(index) = self.held else { return };
        let at_nm = snapped(lines, at_nm, SNAP_NM)
            .map_or_else(|| (10.0 * at_nm).round() / 10.0, |line| line.at_nm);
        let mut source = desk.mix.channels.get(index).map(|c| c.source.clone());
        if let Some(
            Source::Line { at_nm: place }
            | Source::Gauss {
                centre_nm: place, ..
            },
        ) = &mut source
        {
            *place = at_nm;
        }
        if let Some(source) = source {
            change(context, |mix| mix.channels[index].source = source);
        }
    }
}

fn faders_of(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    desk: &Desk,
    (lines, beside): (&[NamedLine], &[Beside]),
) {
    add_row(ui, context, desk, lines);
    ui.add_space(4.0);
    let groups = groups(desk).count() as f32;
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let rows = beside.len().div_ceil(IN_ROW).clamp(1, MOST_ROWS) as f32;
    let rest = (98.0 + rows * SWATCH) * context.theme.scale + groups * row;
    let height = (ui.available_height() - rest).max(80.0);
    let size = vec2(ui.available_width(), height);
    column(ui, size, |ui| {
        scrolled(ui, "faders", |ui| {
            strips::show(ui, context, desk, lines);
            strips::gels(ui, context, desk);
        });
    });
    below(ui, context, desk, beside);
}

/// Groups with channels in them, and their highest fader.
fn groups(desk: &Desk) -> impl Iterator<Item = (u8, f64)> {
    (1..=GROUPS).filter_map(|group| Some((group, desk.mix.group_highest(group)?)))
}

/// What joins the desk.
fn add_row(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk, lines: &[NamedLine]) {
    let mut new = None;
    let is_full = desk.mix.channels.len() >= MOST_CHANNELS;
    ui.add_enabled_ui(!is_full, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.label("Add");
            let line = ui.menu_button("Line", |ui| {
                if let Some(line) = strips::line_menu(ui, lines) {
                    new = Some(Source::Line { at_nm: line });
                }
            });
            line.response
                .on_hover_text("A line without width, at the place of one that has a name.");
            let mut button = |title: &str, meaning: &str, source: Source| {
                if ui.button(title).on_hover_text(meaning).clicked() {
                    new = Some(source);
                }
            };
            button(
                "LED",
                "A Gaussian with a centre and a full width at half its height.",
                Source::Gauss {
                    centre_nm: 500.0,
                    fwhm_nm: 20.0,
                },
            );
            button(
                "Blackbody",
                "What a glowing body of a temperature shines.",
                Source::Blackbody { kelvin: 2700.0 },
            );
            button(
                "Daylight",
                "Daylight of a temperature, by the CIE's components.",
                Source::Daylight { kelvin: 6500.0 },
            );
            let chosen = Chooser {
                name: "A light to mix",
                meaning: "Any light of the library, shipped or your own, as a channel.",
                says: "Any light",
                offers: lights,
                width: 120.0 * context.theme.scale,
            }
            .show(ui, context.app);
            if let Some(light) = chosen {
                new = Some(Source::Named(light.key.clone()));
            }
            add_gel(ui, context, desk);
        });
    });
    if let Some(source) = new {
        change(context, |mix| mix.channels.push(MixChannel::new(source)));
    }
}

/// What joins the gels.
fn add_gel(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    if desk.mix.gels.len() >= MOST_GELS {
        return;
    }
    let gel = Chooser {
        name: "A gel before the lamps",
        meaning: "A filter or glass of the library, or of a file that was opened, before all \
                  channels.",
        says: "Gel",
        offers: transmittances,
        width: 60.0 * context.theme.scale,
    }
    .show(ui, context.app);
    if let Some(gel) = gel {
        let key = gel.key.clone();
        let thickness = 1.0;
        change(context, |mix| mix.gels.push(Gel { key, thickness }));
    }
}

/// All faders together, and where the mixture goes.
fn below(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk, beside: &[Beside]) {
    surfaces(ui, context, beside);
    let scale = context.theme.scale;
    for (group, highest) in groups(desk) {
        let name = format!("Group {group}");
        let fader = format!("Fader of group {group}");
        let meaning = "Moves all faders of the group together.";
        if let Some(way) = together(ui, [&name, &fader, meaning], highest, scale) {
            change(context, |mix| *mix = mix.clone().group_dimmed(group, way));
        }
    }
    let all = [
        "All",
        "All faders",
        "Moves all faders together: brighter or darker at constant colour.",
    ];
    if let Some(way) = together(ui, all, desk.mix.highest(), scale) {
        change(context, |mix| *mix = mix.clone().dimmed(way));
    }
    ui.horizontal(|ui| {
        let recipe = desk.recipe();
        let button = ui
            .add_enabled(recipe.is_some(), egui::Button::new("To the library"))
            .on_hover_text(
                "Keeps the mixture as a light of your own and shows it everywhere. It follows \
                 the lights that it is made of.",
            );
        if let Some(recipe) = recipe.filter(|_| button.clicked()) {
            let place = MadeFor::Shown;
            context.commands.push(Command::Make { recipe, place });
        }
        kept(ui, context, desk);
        copy_button(
            ui,
            "Copy the channels as CSV",
            "Channels with their drive in per cent, their share of the power, and values for \
             lighting desks of 8 and 16 bits (DMX).",
            || desk.table().csv(),
        );
    });
}

/// Surfaces, at the left as under the mixture, at the right as under its reference.
fn surfaces(ui: &mut Ui, context: &mut PageContext<'_>, surfaces: &[Beside]) {
    let now = &mut context.memory.desk_surfaces;
    let scale = context.theme.scale;
    ui.horizontal(|ui| {
        let choice = Choice {
            name: "Surfaces under the mixture",
            meaning: "Which surfaces stand below.",
            width: 130.0 * scale,
        };
        choice.pick(ui, now, DeskSurfaces::ALL, |one| {
            (one.title(), one.meaning())
        });
        let words = match surfaces.len() {
            0 => "this light has no reference to stand beside".to_owned(),
            count if count > MOST_ROWS * IN_ROW => format!(
                "under the mixture | under its reference; the first {} of {count}",
                MOST_ROWS * IN_ROW
            ),
            _ => "under the mixture | under its reference".to_owned(),
        };
        let label = egui::Label::new(egui::RichText::new(words).small()).truncate();
        ui.add(label).on_hover_text(
            "The reference is a blackbody, from 5000 K on daylight, of the same temperature. Each \
             half as an eye adapted to its light sees it.",
        );
    });
    let gap = 2.0;
    let in_row = surfaces.len().clamp(1, IN_ROW);
    let room = ui.available_width() - gap * (in_row - 1) as f32;
    let size = vec2(
        (room / in_row as f32).floor().max(8.0),
        (SWATCH - gap) * scale,
    );
    let rows = surfaces.chunks(in_row).take(MOST_ROWS);
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(gap, gap);
        for row in rows {
            ui.horizontal(|ui| {
                for one in row {
                    let words = &one.words;
                    swatch::split(ui, size, &one.test, &one.reference, words).on_hover_text(words);
                }
            });
        }
    });
}

/// Desks to come back to.
fn kept(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    let mut back = None;
    for (slot, name) in context.memory.kept.iter_mut().zip(["A", "B", "C"]) {
        let is_here = slot.as_ref().is_some_and(|kept| kept.mix == desk.mix);
        let button = ui.selectable_label(is_here, name);
        let words = match slot {
            Some(kept) => format!(
                "{}\nClick to restore this mix; right click to forget it.",
                kept.words
            ),
            None => format!("Saves this mix as {name}, to restore and to compare."),
        };
        if button.secondary_clicked() {
            *slot = None;
        } else if button.clicked() {
            match slot {
                Some(kept) => back = Some(kept.mix.clone()),
                None => {
                    *slot = Some(Snapshot {
                        mix: desk.mix.clone(),
                        words: desk.sentence(),
                    });
                }
            }
        }
        button.on_hover_text(words);
    }
    if let Some(mix) = back {
        set(context, mix);
    }
}

/// One fader that moves several, under its name: where it was drawn to.
fn together(
    ui: &mut Ui,
    [says, name, meaning]: [&str; 3],
    highest: f64,
    scale: f32,
) -> Option<f64> {
    let mut now = highest;
    ui.horizontal(|ui| {
        ui.label(says);
        // From nothing there is no way up: the shares would be lost.
        ui.add_enabled_ui(highest > 0.0, |ui| {
            Fader {
                name,
                meaning,
                range: 0.0..=FULL,
                digits: 0,
                suffix: " %",
                logarithmic: false,
            }
            .show(ui, &mut now, 0.0, scale);
        });
    });
    (now != highest).then_some(now.max(0.1))
}
