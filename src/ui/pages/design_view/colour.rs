//! The page "From a colour": a colour, the spectra that have it, and how they differ.

use eframe::egui;
use egui::{DragValue, RichText, TextEdit, Ui, vec2};

use super::{DesignView, headline};
use crate::{
    app::{
        Command,
        chart::Chart,
        charts::colour::colour_chart,
        command::MadeFor,
        design::colour::{ColourSheet, Under, method_name, of_hex},
        recipe::Given,
    },
    color::Swatch,
    design::recover::Method,
    ui::{
        kit::{Chooser, Column, Row, Table, lights, named, scrolled},
        pages::PageContext,
        swatch,
    },
};

/// From this width on the chart stands beside the colour, points.
const WIDE: f32 = 720.0;

/// What a page shows of a colour.
pub struct Shown {
    sheet: ColourSheet,
    chart: Chart,
}

impl DesignView {
    /// Spectra from a colour.
    pub fn from_colour(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let theme = context.chart_theme();
        let key = (context.app.revision(), theme, context.memory.colour.clone());
        let document = context.app.document();
        let shown = &*self.colour.get(key, |(_, theme, from)| {
            let sheet = ColourSheet::of(from, document)?;
            let chart = colour_chart(&sheet, *theme);
            Ok(Shown { sheet, chart })
        });
        let (words, colour) = match shown {
            Ok(shown) => (shown.sheet.sentence(), shown.sheet.swatch.rgb8),
            Err(why) => (why.clone(), Swatch::of_light(crate::color::Xyz::ZERO).rgb8),
        };
        headline(ui, context, swatch::colour(colour), &words);
        ui.add_space(4.0);
        let typed = &mut self.typed;
        let room = ui.available_size();
        let scale = context.theme.scale;
        if room.x >= WIDE * scale {
            let left = vec2((0.40 * room.x).clamp(330.0 * scale, 520.0 * scale), room.y);
            ui.horizontal_top(|ui| {
                ui.allocate_ui_with_layout(left, egui::Layout::top_down(egui::Align::Min), |ui| {
                    ui.set_min_size(left);
                    scrolled(ui, "colour", |ui| {
                        asked(ui, context, shown, typed);
                        trust(ui, context, shown);
                    });
                });
                ui.vertical(|ui| {
                    let rest = 170.0 * scale;
                    let size = vec2(ui.available_width(), (room.y - rest).max(220.0));
                    drawn(ui, context, shown, size);
                });
            });
        } else {
            scrolled(ui, "colour", |ui| {
                asked(ui, context, shown, typed);
                let size = vec2(ui.available_width(), 0.6 * room.y);
                drawn(ui, context, shown, size);
                trust(ui, context, shown);
            });
        }
    }
}

/// The colour and the light that it is seen under.
fn asked(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    shown: &Result<Shown, String>,
    typed: &mut Option<String>,
) {
    let sheet = shown.as_ref().ok().map(|shown| &shown.sheet);
    let scale = context.theme.scale;
    let mut given = context.memory.colour.given.clone();
    ui.horizontal_wrapped(|ui| {
        ui.label("Colour");
        let now = sheet.map_or([128; 3], |sheet| sheet.swatch.rgb8.0);
        let mut rgb = now;
        let picker = ui.color_edit_button_srgb(&mut rgb);
        named(&picker, egui::Role::ColorWell, "Pick a colour");
        picker.on_hover_text("As the screen shows it to an eye that is adapted to the light.");
        if rgb != now {
            given = Given::Srgb(rgb);
        }
        let [r, g, b] = now;
        let mut text = typed
            .clone()
            .unwrap_or_else(|| format!("#{r:02x}{g:02x}{b:02x}"));
        let edit = ui.add(TextEdit::singleline(&mut text).desired_width(72.0 * scale));
        named(&edit, egui::Role::TextInput, "Colour in hexadecimal");
        if edit.changed() {
            if let Some(rgb) = of_hex(&text) {
                given = Given::Srgb(rgb);
            }
            *typed = Some(text);
        }
        if !edit.has_focus() {
            *typed = None;
        }
        edit.on_hover_text("sRGB in hexadecimal, such as #c08040.");
    });
    lab_row(ui, sheet, &mut given);
    ui.horizontal_wrapped(|ui| {
        ui.label("or that of");
        let says = match &given {
            Given::Of(key) => key.rsplit('/').next().unwrap_or(key),
            _ => "a surface",
        };
        let surface = Chooser {
            name: "Surface to start from",
            meaning: "A measured surface: how well would its colour alone have told it?",
            says,
            offers: reflectances,
            width: 130.0 * scale,
        }
        .show(ui, context.app);
        if let Some(surface) = surface {
            given = Given::Of(surface.key.clone());
        }
        ui.label("under");
        let says = sheet.map_or("a light", |sheet| sheet.light.as_str());
        let light = Chooser {
            name: "Light that the colour is seen under",
            meaning: "Another light makes other surfaces of the same colour.",
            says,
            offers: lights,
            width: 130.0 * scale,
        }
        .show(ui, context.app);
        if let Some(light) = light {
            context.memory.colour.light.clone_from(&light.key);
        }
    });
    context.memory.colour.given = given;
}

/// The colour as L*, a* and b*.
fn lab_row(ui: &mut Ui, sheet: Option<&ColourSheet>, given: &mut Given) {
    ui.horizontal_wrapped(|ui| {
        let now = sheet.map_or([50.0, 0.0, 0.0], |s| [s.lab.l, s.lab.a, s.lab.b]);
        let mut lab = now;
        for (value, title) in lab.iter_mut().zip(["L*", "a*", "b*"]) {
            ui.label(title);
            let range = if title == "L*" {
                0.0..=100.0
            } else {
                -200.0..=200.0
            };
            let number = DragValue::new(value)
                .range(range)
                .speed(0.3)
                .fixed_decimals(1);
            let response = ui.add(number);
            named(&response, egui::Role::SpinButton, title);
            response.on_hover_text("CIE 1976, against the light's own white.");
        }
        if lab != now {
            *given = Given::Lab(lab);
        }
    });
}

/// What is a reflectance.
fn reflectances(entry: &crate::app::Entry) -> bool {
    entry.kind() == crate::spectrum::Kind::Reflectance
}

/// What each way is to be trusted by; the one chosen goes to the library.
fn trust(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Result<Shown, String>) {
    let Ok(Shown { sheet, .. }) = shown else {
        return;
    };
    ui.add_space(8.0);
    let columns = [
        Column::words("way", "Click the one to take to the library.", 1.7),
        Column::words(
            "values",
            "Lowest and highest value; a surface is within 0 to 1.",
            2.0,
        ),
        Column::numbers(
            "\u{394}E00",
            "Round trip: how far its colour is from the one asked for (CIEDE2000).",
            0.6,
        ),
        Column::numbers(
            "cond.",
            "Condition number: by how much it makes errors of the colour larger.",
            0.7,
        ),
    ];
    let methods = [Method::Smoothest, Method::Fourier3, Method::Lines];
    let rows: Vec<Row> = sheet
        .facts()
        .into_iter()
        .map(|cells| Row {
            name: cells.join(", "),
            tips: cells.to_vec(),
            cells: cells.to_vec(),
            ..Row::default()
        })
        .collect();
    let method = context.memory.colour.method;
    let table = Table {
        chosen: methods.iter().position(|one| *one == method),
        ..Table::new(&columns, context.theme)
    };
    let clicked = table.show(ui, &rows, &mut |_, _, _| {});
    if let Some(method) = clicked.and_then(|row| methods.get(row)) {
        context.memory.colour.method = *method;
    }
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        let button = ui.button("To the library").on_hover_text(
            "Keeps the chosen spectrum as one of your own, which follows the light and the \
             surface that it was made from.",
        );
        if button.clicked() {
            let (recipe, place) = (context.memory.colour.recipe(), MadeFor::Shown);
            context.commands.push(Command::Make { recipe, place });
        }
        ui.weak(method_name(method));
    });
    if method == Method::Lines {
        lines_of(ui, context);
    }
}

/// The lines of a light of lines, and what stands behind them.
fn lines_of(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.label("Lines at");
        let places = &mut context.memory.colour.lines;
        for (i, nm) in places.iter_mut().enumerate() {
            let number = DragValue::new(nm)
                .range(380.0..=780.0)
                .speed(0.2)
                .max_decimals(1);
            let response = ui.add(number);
            named(
                &response,
                egui::Role::SpinButton,
                &format!("Line {}", i + 1),
            );
        }
        if places.len() < 8
            && ui
                .small_button("+")
                .on_hover_text("One line more.")
                .clicked()
        {
            places.push(600.0);
        }
        if places.len() > 1
            && ui
                .small_button("−")
                .on_hover_text("The last line goes.")
                .clicked()
        {
            places.pop();
        }
        ui.label("nm over the glow of");
        let lamp = context.memory.colour.lamp.clone();
        let chosen = Chooser {
            name: "Lamp whose glow stands behind the lines",
            meaning: "Its lines are taken out; what is left is the background's shape.",
            says: lamp.rsplit('/').next().unwrap_or(&lamp),
            offers: lights,
            width: 110.0 * context.theme.scale,
        }
        .show(ui, context.app);
        if let Some(chosen) = chosen {
            context.memory.colour.lamp.clone_from(&chosen.key);
        }
    });
}

/// The chart, and below it what each way predicts under other lights.
fn drawn(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    shown: &Result<Shown, String>,
    size: egui::Vec2,
) {
    let Ok(Shown { sheet, chart }) = shown else {
        return;
    };
    context.chart(ui, chart, "from a colour", size);
    ui.add_space(4.0);
    let words = match sheet.surface {
        Some(_) => "Under other lights: smoothest, three coefficients, the surface itself",
        None => "Under other lights: smoothest, three coefficients",
    };
    let words = ui.label(RichText::new(words).strong());
    words.on_hover_text("Each as an eye adapted to that light sees it (Bradford).");
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
    ui.allocate_ui_with_layout(size, egui::Layout::top_down(egui::Align::Min), |ui| {
        ui.set_min_width(width);
        ui.set_max_width(width);
        let field = vec2(width, 52.0 * context.theme.scale);
        let (rect, response) = ui.allocate_exact_size(field, egui::Sense::hover());
        let name = format!("Under {}", under.light);
        named(&response, egui::Role::Image, &name);
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
            ui.small(format!("\u{394}E00 {differs:.1}"));
        }
    });
}
