//! The page "Mix": faders, the diagram in which the colour is dragged, what the mixture is worth, and
//! surfaces under it.

use eframe::egui;
use egui::{Ui, Vec2, vec2};

use super::{
    DesignView, Second,
    adding::add_row,
    change, set, strips,
    worth::{self, kept_row, main_figures, surfaces},
};
use crate::{
    app::{
        charts::design::{held_at, mixed_spectrum},
        design::{
            Desk, beside,
            named_lines::{NamedLine, snapped},
            wish::MixWish,
        },
    },
    design::{mixture::Source, solve::Care},
    ui::{
        chart_view::{ChartResponse, ChartView},
        kit::{Choice, GROUP, column, drawing, framed, headline, scrolled},
        pages::PageContext,
        swatch,
    },
};

/// From this width on faders, diagram and figures stand side by side, points.
const WIDE: f32 = 840.0;

/// From this width on the faders stand beside the diagram, points.
const PAIR: f32 = 620.0;

/// Parts of the width for the faders and for the figures.
const PARTS: [f32; 2] = [0.36, 0.27];

/// Height of the desk in a page that is too narrow for all of it side by side, points.
const DESK: f32 = 400.0;

/// How near to a line or an LED a drag takes hold of it, nm.
const REACH_NM: f64 = 12.0;

/// How near to the ring or the dot in the diagram a drag takes hold of it, points.
const REACH: f32 = 18.0;

/// Surfaces in a row, in a page that is high enough for two rows and in a lower one.
const IN_ROW: [usize; 2] = [12, 24];
const HIGH: f32 = 560.0;

/// How near to a named line a dragged one snaps to it, nm.
const SNAP_NM: f64 = 0.8;

/// What the pointer holds in the diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Held {
    /// The ring: the colour that is aimed at.
    Target,
    /// The mixture, which the faders follow.
    Mixture,
}

/// Temperatures to aim at, K.
const AIMS: [f64; 7] = [2200.0, 2700.0, 3000.0, 3500.0, 4000.0, 5000.0, 6500.0];

impl DesignView {
    /// Channels mixed by hand.
    pub(crate) fn mix(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        self.refresh(context.app);
        let Some(desk) = self.desk.held().cloned() else {
            return;
        };
        let lines = self.lines.held().cloned().unwrap_or_default();
        let second = self.second.held().cloned().flatten();
        let document = context.app.document();
        let key = (context.app.changes(), context.pages.mix.surfaces);
        let make = |(_, surfaces): &(u64, _)| {
            let second = second.as_ref().map(|second| &second.desk);
            beside(&desk, second, *surfaces, document)
        };
        let beside = self.beside.get(key, make).clone();
        let foot = (&beside[..], second.as_ref().map(|second| &second.name[..]));
        let parts = (&desk, &lines[..], second.as_ref());
        headline(ui, context.theme, desk.headline());
        ui.add_space(GROUP);
        let room = ui.available_size();
        let scale = context.theme.scale;
        if context.theme.presents {
            self.presented(ui, context, &desk, room);
        } else if room.x < WIDE * scale {
            scrolled(ui, "mix", |ui| {
                let width = ui.available_width();
                let high = DESK * scale;
                if width >= PAIR * scale {
                    ui.horizontal_top(|ui| {
                        ui.spacing_mut().item_spacing.x = GROUP;
                        let half = vec2((0.5 * (width - GROUP)).floor(), high);
                        self.channels(ui, context, parts, half);
                        self.among_colours(ui, context, &desk, half);
                    });
                    surfaces(ui, context, foot, IN_ROW[0]);
                    self.worth(ui, context, parts, vec2(width, high));
                } else {
                    self.channels(ui, context, parts, vec2(width, high));
                    self.among_colours(ui, context, &desk, vec2(width, high));
                    self.worth(ui, context, parts, vec2(width, high));
                    surfaces(ui, context, foot, IN_ROW[0]);
                }
            });
        } else {
            let in_row = IN_ROW[usize::from(room.y < HIGH * scale)];
            let rows = beside.len().div_ceil(in_row).clamp(1, 2);
            let high = room.y - worth::height(rows) * scale - GROUP;
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = GROUP;
                let width = room.x - 2.0 * GROUP;
                let [left, right] = PARTS.map(|part| (part * width).floor());
                let middle = width - left - right;
                self.channels(ui, context, parts, vec2(left, high));
                self.among_colours(ui, context, &desk, vec2(middle, high));
                self.worth(ui, context, parts, vec2(right, high));
            });
            ui.add_space(GROUP - ui.spacing().item_spacing.y);
            surfaces(ui, context, foot, in_row);
        }
        self.faders_follow(ui, context, &desk);
    }

    /// Before a class: the faders, and the diagram that they move.
    fn presented(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk, room: Vec2) {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = GROUP;
            let half = vec2((0.5 * (room.x - GROUP)).floor(), room.y - GROUP);
            card(ui, half, |ui| {
                let high = ui.available_height();
                strips::faders(ui, context, desk, &mut self.chosen, high);
            });
            self.among_colours(ui, context, desk, half);
        });
    }

    /// The channels with their faders, and what they are aimed at.
    fn channels(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (desk, lines, second): (&Desk, &[NamedLine], Option<&Second>),
        size: Vec2,
    ) {
        card(ui, size, |ui| {
            ui.strong(said!("Channels"));
            add_row(ui, context, desk, lines);
            ui.add_space(6.0);
            let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
            let gels = desk.mix.gels.len() as f32;
            let rest = (3.0 + gels) * row + 22.0 * context.theme.scale;
            let high = (ui.available_height() - rest).max(120.0 * context.theme.scale);
            strips::faders(ui, context, desk, &mut self.chosen, high);
            strips::gels(ui, context, desk);
            strips::chosen(ui, context, (desk, lines), &mut self.chosen);
            ui.add_space(4.0);
            ui.separator();
            self.aim(ui, context, desk, second);
        });
    }

    /// What is aimed at, and the button that sets the faders for it.
    fn aim(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        desk: &Desk,
        second: Option<&Second>,
    ) {
        ui.horizontal(|ui| {
            ui.label(said!("Aim at"));
            let words = context.pages.solve.colour_words(context.app.document());
            let choice = Choice {
                name: said!("The colour that is aimed at"),
                meaning: said!(
                    "The ring in the diagram, which can be dragged too. The page Solve has lights \
                     and x, y."
                ),
                width: 110.0 * context.theme.scale,
            };
            choice.cut(ui, words, |ui| {
                if let Some(second) = second
                    && ui
                        .button(tr!("the colour of {light}", light = second.name))
                        .clicked()
                {
                    context.pages.solve.light = Some(second.key.clone());
                    context.pages.solve.xy = None;
                }
                for kelvin in AIMS {
                    if ui.button(format!("{kelvin:.0} K")).clicked() {
                        context.pages.solve = MixWish {
                            light: None,
                            xy: None,
                            kelvin,
                            duv: 0.0,
                            ..context.pages.solve.clone()
                        };
                    }
                }
            });
            let button = egui::Button::new(said!("Solve")).fill(ui.visuals().selection.bg_fill);
            let meaning = said!(
                "Sets the faders so that the mixture has this colour, and among such mixtures the \
                 best: the page Solve says at what. One step of undo."
            );
            if ui.add(button).on_hover_text(meaning).clicked() {
                let wish = context.pages.solve.clone();
                let solved = self.solved.get(context.app, &wish, desk, Care::Full);
                if let Ok(solved) = solved {
                    set(context, solved.mix.clone());
                }
            }
        });
    }

    /// Where channels, mixture and target are among colours; ring and dot can be dragged.
    fn among_colours(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        desk: &Desk,
        size: Vec2,
    ) {
        let document = context.app.document();
        let target = context.pages.solve.target(document).ok();
        let target = target.map(|target| target.uv());
        column(ui, size, |ui| {
            let mut shown = self.diagram(ui, context, target, size);
            context.ask_for_chart(shown.wish.take());
            self.drag(ui, context, (desk, target), &shown);
        });
    }

    /// Takes ring or dot along with the pointer.
    fn drag(
        &mut self,
        ui: &Ui,
        context: &mut PageContext<'_>,
        (desk, target): (&Desk, Option<[f64; 2]>),
        shown: &ChartResponse,
    ) {
        let mixture = desk.figures.as_ref().and_then(|figures| figures.uv);
        let near = |uv: Option<[f64; 2]>, at: egui::Pos2| {
            let place = shown.main.pos(uv?)?;
            (place.distance(at) < REACH).then_some(())
        };
        let held_at = |at: egui::Pos2| match (near(mixture, at), near(target, at)) {
            (Some(()), _) => Some(Held::Mixture),
            (None, Some(())) => Some(Held::Target),
            (None, None) => None,
        };
        if let Some(at) = shown.response.hover_pos()
            && (held_at(at).is_some() || self.dragged.is_some())
        {
            ui.set_cursor_icon(egui::CursorIcon::Grab);
        }
        let Some(uv) = shown.dragged else {
            self.dragged = None;
            return;
        };
        if shown.response.drag_started() {
            let pressed = ui.input(|input| input.pointer.press_origin());
            self.dragged = pressed.and_then(held_at);
        }
        if let Some(held) = self.dragged {
            context.pages.solve = context.pages.solve.clone().at_uv(uv);
            self.follows |= held == Held::Mixture;
            ui.request_repaint();
        }
    }

    /// Sets the faders for a mixture that is dragged.
    fn faders_follow(&mut self, ui: &Ui, context: &mut PageContext<'_>, desk: &Desk) {
        if !self.follows {
            return;
        }
        let care = match ui.input(|input| input.pointer.any_down()) {
            true => Care::Quick,
            false => Care::Full,
        };
        let wish = context.pages.solve.clone();
        if self.solved.get(context.app, &wish, desk, care).is_ok()
            && let Some(mix) = self.solved.follow(&desk.mix)
        {
            set(context, mix);
        }
        self.follows = care == Care::Quick;
    }

    /// The mixture's colour, its figures and its spectrum, and where it goes.
    fn worth(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (desk, lines, second): (&Desk, &[NamedLine], Option<&Second>),
        size: Vec2,
    ) {
        column(ui, size, |ui| {
            let scale = context.theme.scale;
            let wide = vec2(size.x, 56.0 * scale);
            let name = said!("Colour of the mixture");
            let (rect, response) = drawing(ui, wide, egui::Sense::hover(), name);
            ui.painter()
                .rect_filled(rect, 4.0, context.theme.swatch_ground);
            let own = swatch::colour(desk.swatch().rgb8);
            let its = second.map(|second| swatch::colour(second.desk.swatch().rgb8));
            swatch::paint_split(ui, rect.shrink(8.0), own, its.unwrap_or(own));
            response.on_hover_text(match second {
                Some(Second { name, .. }) => {
                    tr!(
                        "Left the mixture, right {light}, beside daylight, each as bright as the \
                         screen can show it.",
                        light = name
                    )
                }
                None => said!("As it looks beside daylight, as bright as the screen can show it.")
                    .to_owned(),
            });
            ui.add_space(8.0);
            let figures = desk.main_figures();
            let of_second = second.map(|second| (&second.name[..], second.desk.main_figures()));
            main_figures(ui, context.theme, &figures, of_second);
            ui.add_space(8.0);
            let foot = worth::kept_height(ui, size.x, scale) + 10.0;
            let high = (ui.available_height() - foot).max(100.0 * scale);
            let second = second.map(Second::named);
            self.spectrum(ui, context, (desk, lines, second), vec2(size.x, high));
            kept_row(ui, context, desk);
        });
    }

    /// The mixture over the wavelengths; lines and LEDs can be dragged.
    fn spectrum(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (desk, lines, second): (&Desk, &[NamedLine], Option<(&str, &Desk)>),
        size: Vec2,
    ) {
        let key = context.app.changes();
        let chart = &*self.spectrum.get(key, |_| mixed_spectrum(desk, second));
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

/// A card of a size.
fn card(ui: &mut Ui, size: Vec2, add: impl FnOnce(&mut Ui)) {
    column(ui, size, |ui| {
        framed(ui, |ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.set_min_height(size.y - 18.0);
            ui.set_max_height(size.y - 18.0);
            add(ui);
        });
    });
}
