//! The page "From a colour": a colour, the spectra that have it, and how they differ.

use crate::ui::kit::drag_value;
use std::sync::Arc;

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{DesignView, asked::asked, large_swatch};
use crate::{
    app::{
        Command, MadeFor,
        chart::Chart,
        charts::colour::colour_chart,
        design::{
            colour::{ColourSheet, Under},
            method_name,
        },
    },
    color::Swatch,
    design::recover::Method,
    languages::fixed,
    ui::{
        kit::{
            Chooser, Column, GROUP, Row, column, down, drawing, headline, lights, number,
            pressed_small, scrolled, table,
        },
        pages::PageContext,
        swatch,
    },
};

/// From this width on the chart stands beside the colour, points.
const WIDE: f32 = 720.0;

/// What a page shows of a colour.
pub(super) struct Shown {
    sheet: ColourSheet,
    chart: Chart,
}

impl DesignView {
    pub(crate) fn spectra_of_colour(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let key = (context.app.revision(), context.pages.from_colour.clone());
        let document = context.app.document();
        let shown = &self
            .colour
            .get(key, |(_, from)| {
                let sheet = ColourSheet::of(from, document)?;
                let chart = colour_chart(&sheet);
                Ok(Arc::new(Shown { sheet, chart }))
            })
            .clone();
        let (words, colour) = match shown {
            Ok(shown) => (shown.sheet.sentence(), shown.sheet.swatch().rgb8),
            Err(why) => (why.clone(), Swatch::of_light(crate::color::Xyz::ZERO).rgb8),
        };
        headline(ui, context.theme, words);
        ui.add_space(GROUP);
        let field = |ui: &mut Ui, context: &PageContext<'_>| {
            let meaning = said!("Its colour as bright as the screen can show it.");
            let named = (said!("The colour"), meaning);
            large_swatch(ui, context, [swatch::colour(colour); 2], named, ["", ""]);
        };
        let sheet = shown.as_ref().ok().map(|shown| &shown.sheet);
        let room = ui.available_size();
        let scale = context.theme.scale;
        if room.x >= WIDE * scale {
            let left = vec2((0.40 * room.x).clamp(330.0 * scale, 520.0 * scale), room.y);
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = GROUP;
                column(ui, left, |ui| {
                    ui.spacing_mut().item_spacing.x = 6.0;
                    scrolled(ui, "colour", |ui| {
                        field(ui, context);
                        asked(ui, context, sheet, &mut self.typed);
                        self.photo(ui, context);
                        trust(ui, context, shown);
                    });
                });
                ui.vertical(|ui| {
                    ui.spacing_mut().item_spacing.x = 6.0;
                    let rest = 150.0 * scale;
                    let size = vec2(ui.available_width(), (room.y - rest).max(220.0));
                    drawn(ui, context, shown, size);
                });
            });
        } else {
            scrolled(ui, "colour", |ui| {
                field(ui, context);
                asked(ui, context, sheet, &mut self.typed);
                self.photo(ui, context);
                let size = vec2(ui.available_width(), 0.6 * room.y);
                drawn(ui, context, shown, size);
                trust(ui, context, shown);
            });
        }
    }
}

/// What each way is to be trusted by; the one chosen goes to the library.
fn trust(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Result<Arc<Shown>, String>) {
    let Ok(shown) = shown else { return };
    let sheet = &shown.sheet;
    ui.add_space(GROUP);
    ui.strong(said!("Spectra that have it"));
    let columns = [
        Column::words(
            said!("way"),
            said!(
                "Click the one to take. Three coefficients for one colour, six for two are the \
                 paper's Eq. 18."
            ),
            2.0,
        ),
        Column::words(
            said!("values"),
            said!("Lowest and highest value; a surface is within 0 to 1."),
            1.8,
        ),
        Column::numbers(
            "ΔE₀₀",
            said!("Round trip: how far its colour is from the one asked for (CIEDE2000)."),
            0.75,
        ),
        Column::numbers(
            said!("× error"),
            said!("Condition number: by how much it makes errors of the colour larger."),
            0.7,
        ),
    ];
    let methods = context.pages.from_colour.methods();
    let row = |cells: [String; 4]| Row {
        tips: cells.to_vec(),
        ..Row::of(cells.to_vec())
    };
    let rows: Vec<Row> = sheet.facts().into_iter().map(row).collect();
    let method = context.pages.from_colour.method;
    let chosen = methods.iter().position(|one| *one == method);
    let clicked = table(ui, &columns, &rows, chosen, true, context.theme);
    if let Some(method) = clicked.and_then(|row| methods.get(row)) {
        context.pages.from_colour.method = *method;
    }
    ui.add_space(4.0);
    taken(ui, context, method);
    if method == Method::Lines {
        lines_of(ui, context);
    }
}

/// Where the chosen spectrum goes, by one click.
fn taken(ui: &mut Ui, context: &mut PageContext<'_>, method: Method) {
    ui.weak(format!("{}:", method_name(method)));
    ui.horizontal_wrapped(|ui| {
        let is_surface = method != Method::Lines;
        for (title, meaning, place, is_there) in [
            (
                said!("To the library"),
                said!(
                    "Keeps it as one of your own spectra and shows it. It follows the lights and \
                     the surface that it was made from."
                ),
                MadeFor::Shown,
                true,
            ),
            (
                said!("Into the chain"),
                said!(
                    "Puts it at the end of what the light meets, on the page Chain; it joins the \
                     library too."
                ),
                MadeFor::Chain,
                is_surface,
            ),
            (
                said!("To the surfaces"),
                said!(
                    "Puts it behind the surfaces of the page Spectrum; it joins the library too."
                ),
                MadeFor::Patches,
                is_surface,
            ),
        ] {
            let button = ui
                .add_enabled(is_there, egui::Button::new(title))
                .on_hover_text(meaning)
                .on_disabled_hover_text(said!("A light of lines is no surface."));
            if button.clicked() {
                let recipe = context.pages.from_colour.recipe();
                context.commands.push(Command::Make { recipe, place });
            }
        }
    });
}

/// The lines of a light of lines, and what stands behind them.
fn lines_of(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Lines at"));
        let places = &mut context.pages.from_colour.lines;
        for (i, nm) in places.iter_mut().enumerate() {
            let place = drag_value(nm)
                .range(380.0..=780.0)
                .speed(0.2)
                .max_decimals(1);
            number(ui, place, &tr!("Line {number}", number = i + 1));
        }
        if places.len() < 8 && pressed_small(ui, "+", said!("One line more.")) {
            places.push(600.0);
        }
        if places.len() > 1 && pressed_small(ui, "−", said!("The last line goes.")) {
            places.pop();
        }
        ui.label(said!("nm over the glow of"));
        let lamp = context.pages.from_colour.lamp.clone();
        let chosen = Chooser {
            name: said!("Lamp whose glow stands behind the lines"),
            meaning: said!("Its lines are taken out; what is left is the background's shape."),
            says: &context.app.document().name_of(&lamp),
            offers: lights,
            width: 110.0 * context.theme.scale,
        }
        .show(ui, context.app);
        if let Some(chosen) = chosen {
            context.pages.from_colour.lamp.clone_from(&chosen.key);
        }
    });
}

/// The chart, and below it what each way predicts under other lights.
fn drawn(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    shown: &Result<Arc<Shown>, String>,
    size: egui::Vec2,
) {
    let Ok(shown) = shown else { return };
    let Shown { sheet, chart } = &**shown;
    context.chart(ui, chart, "from a colour", size);
    ui.add_space(4.0);
    let words = match (sheet.surface.is_some(), sheet.seen.len() > 1) {
        (true, false) => {
            said!("Under other lights: smoothest, three coefficients, the surface itself")
        }
        (true, true) => {
            said!("Under other lights: smoothest, six coefficients, the surface itself")
        }
        (false, false) => said!("Under other lights: smoothest, three coefficients"),
        (false, true) => said!("Under other lights: smoothest, six coefficients"),
    };
    let words = ui.label(RichText::new(words).strong());
    words.on_hover_text(said!(
        "Each as an eye adapted to that light sees it (Bradford)."
    ));
    let count = sheet.under.len() as f32;
    let gap = ui.spacing().item_spacing.x;
    let width = ((ui.available_width() - gap * (count - 1.0)) / count).max(60.0);
    ui.horizontal_top(|ui| {
        for under in &sheet.under {
            predicted(ui, context, under, width);
        }
    });
}

/// What is predicted under one light.
fn predicted(ui: &mut Ui, context: &PageContext<'_>, under: &Under, width: f32) {
    let size = vec2(width, 100.0 * context.theme.scale);
    down(ui, size, |ui| {
        ui.set_min_width(width);
        ui.set_max_width(width);
        let field = vec2(width, 52.0 * context.theme.scale);
        let name = tr!("Under {light}", light = under.light);
        let (rect, response) = drawing(ui, field, egui::Sense::hover(), &name);
        let all = [Some(under.smoothest), under.fourier, under.real];
        let all: Vec<Swatch> = all.into_iter().flatten().collect();
        let part = rect.width() / all.len() as f32;
        for (i, one) in all.iter().enumerate() {
            let left = rect.left() + part * i as f32;
            let field =
                egui::Rect::from_min_size(egui::pos2(left, rect.top()), vec2(part, rect.height()));
            ui.painter()
                .rect_filled(field, 0.0, swatch::colour(one.rgb8));
            if !one.in_gamut {
                swatch::out_of_gamut_mark(ui, field);
            }
        }
        swatch::outline(ui, rect, ui.visuals().widgets.noninteractive.bg_stroke);
        let hexes: Vec<String> = all.iter().map(|one| one.hex()).collect();
        response.on_hover_text(format!("{name}: {}", hexes.join(", ")));
        ui.add(egui::Label::new(RichText::new(&under.light).small()).truncate());
        if let Some(differs) = under.differs {
            ui.small(format!("ΔE₀₀ {}", fixed(differs, 1)));
        }
    });
}
