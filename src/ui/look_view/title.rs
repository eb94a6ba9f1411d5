//! What light it is, in a line and a sentence, and the layers of the plot.

use eframe::egui;
use egui::{Align, Button, Color32, Label, Layout, RichText, Ui};

use crate::{
    app::{App, Command, Height, Laid, View, chart::Ink},
    languages::said,
    ui::{
        kit::{named, named_choice, pressed},
        theme::Theme,
    },
};

/// Draws title and sentence. Where nothing else of the window is shown, a button leads back to it.
pub(super) fn show(ui: &mut Ui, app: &App, theme: Theme, leaves: Option<&mut bool>) {
    let (subject, told) = (app.document().subject_entry(), app.told());
    let bare = leaves.is_some();
    let size = if bare && theme.scale > 1.0 {
        16.0
    } else {
        20.0
    };
    let title = |ui: &mut Ui| {
        let title = told.map_or_else(|| subject.name().to_owned(), |told| told.about.title());
        let title = RichText::new(title)
            .size(size * theme.scale)
            .color(ui.visuals().strong_text_color());
        ui.add(Label::new(title).truncate());
        if let Some(product) = app.product() {
            let words = tr!(
                "off {product}",
                product = app.document().patch_called(&product.name)
            );
            ui.add(Label::new(words).truncate());
        }
    };
    ui.horizontal(|ui| {
        let Some(leaves) = leaves else {
            return title(ui);
        };
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let back = ui.add(Button::new("✕").frame(false));
            named(&back, egui::Role::Button, said!("Whole window"));
            *leaves = back
                .on_hover_text(said!("Back to the whole window (Esc)."))
                .clicked();
            ui.with_layout(Layout::left_to_right(Align::Center), title);
        });
    });
    if !bare {
        ui.horizontal(|ui| {
            let unit = match app.unit() {
                "" => said!("no unit stated"),
                unit => unit_words(unit),
            };
            let about = told.map_or("", |told| told.about.about.as_str());
            let table = told.map_or("", |told| told.about.table.as_str());
            let scale = app.document().scale.words();
            let words = [about, table, &format!("{unit}, {scale}")];
            let words: Vec<&str> = words.into_iter().filter(|part| !part.is_empty()).collect();
            // A sentence ends with its own full stop.
            let words = words.join(" · ").replace(". · ", ". ");
            ui.add(Label::new(RichText::new(words).color(theme.faint)).truncate());
        });
        let compared = app.compared().filter(|_| app.document().is_about_light());
        if let Some(compared) = compared {
            ui.add(Label::new(&compared.summary).wrap());
        }
    }
}

/// Units of the shipped tables.
const UNITS: [&str; 9] = [
    later!("relative"),
    later!("relative (S(560 nm)=100 for A, C, D, ID)"),
    later!("relative (as CIE illuminant C, 100 at 560 nm)"),
    later!("relative (weights in % of the power)"),
    later!("relative component (may be negative)"),
    later!("fraction"),
    later!("fraction, INTERNAL transmittance of 2 mm, computed exp(-4 pi k d/lambda)"),
    later!("fraction, normal incidence, computed R=((n-1)^2+k^2)/((n+1)^2+k^2)"),
    later!("dimensionless"),
];

/// A unit of a shipped table in the language spoken; others as a file has them.
fn unit_words(unit: &str) -> &str {
    match UNITS.into_iter().find(|known| *known == unit) {
        Some(known) => said(known),
        None => unit,
    }
}

/// Words of the row of layers.
const WORDS: [&str; 13] = [
    later!("Measured"),
    later!("Model"),
    later!("Lines"),
    ADD_LINE,
    later!("Ideal"),
    later!("As wide as they are"),
    later!("Smooth part"),
    later!("Residual"),
    later!("Layers"),
    later!("Log"),
    later!("Root"),
    later!("Even"),
    later!("Height"),
];

/// By how much they are longer in the language spoken than in English: 1 or more.
fn lengthening() -> f32 {
    let letters = |words: [&str; 13]| words.iter().map(|word| word.chars().count()).sum::<usize>();
    (letters(WORDS.map(said)) as f32 / letters(WORDS) as f32).max(1.0)
}

/// Draws the switches of the layers, each its own legend, and the choice of heights.
pub(super) fn layers(
    ui: &mut Ui,
    app: &App,
    theme: Theme,
    (view, adds_line): (&mut View, &mut bool),
    commands: &mut Vec<Command>,
) {
    // The widths below are those that English needs.
    let width = ui.available_width() / lengthening();
    let (wide, tight) = (width >= 780.0, width < 500.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = if tight { 4.0 } else { 8.0 };
        chip(
            ui,
            &mut view.measured,
            [said!("Measured"), said!("Show measured")],
            Some(theme.ink(Ink::Smooth)),
            said!("The spectrum as measured, filled with the wavelengths' own colours."),
        );
        chip(
            ui,
            &mut view.model,
            [said!("Model"), said!("Show model")],
            Some(theme.ink(Ink::Model)),
            said!("The model's smooth part as an outline; its lines stand on it."),
        );
        let with_widths = width >= 920.0;
        if !tight {
            lines(ui, theme, view);
            add_line(ui, adds_line);
        }
        if with_widths {
            widths(ui, app, width >= 1000.0, commands);
        }
        // What is laid over, and on what scale, takes their place.
        let has_over = app.document().laid_over().next().is_some();
        let with_others = wide && !has_over;
        if with_others {
            others(ui, theme, view);
        }
        let menu = ui.menu_button(said!("Layers"), |ui| {
            if tight {
                ui.horizontal(|ui| heights(ui, app, view, true));
                lines(ui, theme, view);
                add_line(ui, adds_line);
            }
            if !with_others {
                others(ui, theme, view);
            }
            if !with_widths {
                ui.horizontal(|ui| widths(ui, app, true, commands));
            }
            chip(
                ui,
                &mut view.strip,
                [said!("Colours"), said!("Show colours")],
                None,
                said!("Fills a light with the colours of its wavelengths."),
            );
            overlays(ui, app, theme, view, commands);
        });
        menu.response
            .on_hover_text(said!("More layers, and the spectra that are compared."));
        if !tight {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                heights(ui, app, view, wide);
                if has_over && ui.available_width() > 60.0 {
                    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                        let words = RichText::new(laid_over(app)).small().color(theme.faint);
                        ui.add(Label::new(words).truncate());
                    });
                }
            });
        }
    });
}

/// What is laid over and on what scale, where the layers are not to be chosen.
pub(super) fn compared(ui: &mut Ui, app: &App, theme: Theme) {
    if app.document().laid_over().next().is_some() {
        let words = RichText::new(laid_over(app)).color(theme.faint);
        ui.add(Label::new(words).truncate());
    }
}

fn lines(ui: &mut Ui, theme: Theme, view: &mut View) {
    chip(
        ui,
        &mut view.spikes,
        [said!("Lines"), said!("Show lines")],
        Some(theme.ink(Ink::Spikes)),
        said!(
            "The model's lines, each as high as the line that it stands for: weight / (1.0645 x \
             its width)."
        ),
    );
}

/// The name of the button that sets a line.
pub const ADD_LINE: &str = later!("+ Line");

/// Has the next click in the plot set a line.
fn add_line(ui: &mut Ui, adds_line: &mut bool) {
    let button = Button::selectable(*adds_line, said(ADD_LINE)).frame_when_inactive(true);
    let meaning = said!(
        "Then click in the plot where the line stands. Shift and double click does the same."
    );
    if ui.add(button).on_hover_text(meaning).clicked() {
        *adds_line = !*adds_line;
    }
}

/// The layers that are put away where there is little room.
fn others(ui: &mut Ui, theme: Theme, view: &mut View) {
    chip(
        ui,
        &mut view.smooth,
        [said!("Smooth part"), said!("Show smooth part")],
        Some(theme.ink(Ink::Smooth)),
        said!("The smooth part alone: the short series."),
    );
    chip(
        ui,
        &mut view.residual,
        [said!("Residual"), said!("Show residual")],
        Some(theme.ink(Ink::Residual)),
        said!("Model minus measured, below; lines as wide as they are."),
    );
}

/// What lies over the spectrum, and on what scale.
fn laid_over(app: &App) -> String {
    let (overlays, laid): (Vec<_>, Vec<_>) = app.laid().unzip();
    let names = match &overlays[..] {
        [one] => one.name().to_owned(),
        _ => tr!("{n} other" | "{n} others" % overlays.len()),
    };
    let of = |all: &str, some: fn(usize) -> String, is: fn(&Laid) -> bool| match laid
        .iter()
        .filter(|l| is(l))
        .count()
    {
        0 => String::new(),
        n if n == overlays.len() => format!(" {all}"),
        n => format!(", {}", some(n)),
    };
    let equal = of(
        said!("at the same brightness"),
        |n| tr!("{n} of them at the same brightness" | "{n} of them at the same brightness" % n),
        |laid| matches!(laid, Laid::EquallyBright(_)),
    );
    let as_high = of(
        said!("as high as the spectrum"),
        |n| tr!("{n} of them as high as the spectrum" | "{n} of them as high as the spectrum" % n),
        |laid| matches!(laid, Laid::AsHigh(_)),
    );
    let apart = of(
        said!("not drawn: power and reflectance have no common axis"),
        |n| {
            tr!(
                "{n} of them not drawn: power and reflectance have no common axis"
                    | "{n} of them not drawn: power and reflectance have no common axis" % n
            )
        },
        |laid| *laid == Laid::Apart,
    );
    names + &equal + &as_high + &apart
}

/// Whether lines are ideal, or as wide as they are.
fn widths(ui: &mut Ui, app: &App, in_full: bool, commands: &mut Vec<Command>) {
    let settings = app.document().settings;
    ui.spacing_mut().item_spacing.x = 0.0;
    for (wide_lines, word, name, meaning) in [
        (
            false,
            said!("Ideal"),
            said!("Lines: ideal"),
            said!("Lines have no width, as in the paper: a place and a weight."),
        ),
        (
            true,
            said!("As wide as they are"),
            said!("Lines: as wide as they are"),
            said!(
                "Each line is a bell of its own width, kept in the same word as its place; one \
                 number more tells so. Figures, chromaticity, colours and One filter take the \
                 widths; the other pages take a line's centre."
            ),
        ),
    ] {
        let is_chosen = settings.wide_lines == wide_lines;
        let shown = if wide_lines && !in_full {
            said!("Wide")
        } else {
            word
        };
        let button = ui
            .add_enabled(settings.spikes, Button::selectable(is_chosen, shown))
            .on_hover_text(meaning)
            .on_disabled_hover_text(said!("No lines are taken out."));
        named_choice(&button, egui::Role::RadioButton, is_chosen, name);
        if button.clicked() && !is_chosen {
            commands.push(Command::Edit(crate::app::Settings {
                wide_lines,
                ..settings
            }));
        }
    }
    ui.add_space(8.0);
    ui.spacing_mut().item_spacing.x = 8.0;
}

const HEIGHTS: [(Height, &str, &str); 3] = [
    (
        Height::Log,
        later!("Log"),
        later!("By their logarithms: faint parts are seen."),
    ),
    (
        Height::Root,
        later!("Root"),
        later!("By their square roots: glow and whole lines are seen together."),
    ),
    (
        Height::Even,
        later!("Even"),
        later!("Evenly: equal areas are equal power."),
    ),
];

/// How heights are drawn.
fn heights(ui: &mut Ui, app: &App, view: &mut View, wide: bool) {
    use crate::app::{chart::Scale, charts::spectrum::scale};
    let now = match scale(app) {
        Scale::Linear => Height::Even,
        Scale::Root => Height::Root,
        Scale::Log10 => Height::Log,
    };
    ui.spacing_mut().item_spacing.x = 0.0;
    for (height, word, meaning) in HEIGHTS {
        let (word, meaning) = (said(word), said(meaning));
        let button = ui
            .add(Button::selectable(now == height, word))
            .on_hover_text(meaning);
        let name = tr!("Height: {word}", word);
        named_choice(&button, egui::Role::RadioButton, now == height, &name);
        if button.clicked() {
            view.height = height;
        }
    }
    if wide {
        ui.add_space(8.0);
        ui.weak(said!("Height"));
    }
}

/// The overlays' switch, their names, and what takes them away.
fn overlays(ui: &mut Ui, app: &App, theme: Theme, view: &mut View, commands: &mut Vec<Command>) {
    let document = app.document();
    if document.overlays.is_empty() {
        return;
    }
    ui.separator();
    chip(
        ui,
        &mut view.overlays,
        [said!("Overlays"), said!("Show overlays")],
        Some(theme.ink(Ink::Overlay(0))),
        said!(
            "The spectra that are compared. Lights of relative units are drawn as bright as the \
             one that is shown; surfaces are drawn over surfaces only."
        ),
    );
    for (i, overlay) in document.overlays.iter().enumerate() {
        let colour = theme.ink(Ink::Overlay(i));
        ui.label(RichText::new(overlay.name()).color(colour));
    }
    if pressed(
        ui,
        &tr!("take away" => "Clear"),
        said!("Takes all overlays away."),
    ) {
        commands.push(Command::ClearOverlays);
        ui.close();
    }
}

/// A switch of a layer, and what screen readers call it.
fn chip(
    ui: &mut Ui,
    on: &mut bool,
    [name, called]: [&str; 2],
    mark: Option<Color32>,
    meaning: &str,
) {
    let button = match mark {
        Some(colour) => {
            let sign = if *on { "●" } else { "○" };
            let mark = RichText::new(sign).small().color(colour);
            Button::selectable(*on, (mark, name))
        }
        None => Button::selectable(*on, name),
    };
    let outline = ui.visuals().widgets.noninteractive.bg_stroke;
    let button = button.frame_when_inactive(true).stroke(outline);
    let response = ui.add(button).on_hover_text(meaning);
    named_choice(&response, egui::Role::CheckBox, *on, called);
    if response.clicked() {
        *on = !*on;
    }
}
