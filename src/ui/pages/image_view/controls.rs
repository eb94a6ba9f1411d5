//! Which image, how it is drawn, and what becomes of the chosen pixels.

use crate::ui::kit::slide;
use eframe::egui;
use egui::Ui;

use super::{Shown, canvas::Canvas, names};
use crate::{
    app::{
        Command, ImageEntry,
        pages::{ImageMemory, Page, Show, Spread},
        ticks::short,
    },
    color::Srgb,
    io::budget,
    languages::said,
    ui::{
        kit::{Choice, adapt_box, pressed, pressed_if, pressed_small, sign_button},
        pages::{PageContext, PageWish},
    },
};

/// The list of images, what the chosen one is, and the buttons that remove it and that show how
/// it was read; says whether the latter was clicked.
pub(super) fn images(ui: &mut Ui, context: &mut PageContext<'_>, entry: &ImageEntry) -> bool {
    let images = &context.app.document().images;
    let row = ui.horizontal(|ui| {
        if images.is_empty() {
            let meaning = said!(
                "An ENVI cube (its header .hdr or its data beside it) or a spectral OpenEXR \
                 (.exr). It can be dropped here too."
            );
            if pressed(ui, said(names::OPEN), meaning) {
                context.wishes.push(PageWish::OpenPicture);
            }
            about(ui, entry);
            return false;
        }
        let choice = Choice {
            name: said(names::IMAGE),
            meaning: &tr!(
                "The spectral images that are open: {images}.",
                images = images.len()
            ),
            width: 170.0,
        };
        choice.cut(ui, &entry.image.name, |ui| {
            for image in images {
                let chosen = image.key == entry.key;
                let words = format!("{} ({})", image.image.name, image.image.source);
                if ui.selectable_label(chosen, words).clicked() {
                    context.pages.image.choose(&image.key);
                }
            }
        });
        let meaning = said!("Takes this image out of the list; Undo brings it back.");
        if sign_button(ui, said!("Remove"), said(names::REMOVE), meaning) {
            let key = entry.key.clone();
            context.commands.push(Command::RemoveImage { key });
        }
        let button = egui::Button::new(said(names::READING)).small();
        let meaning = said!(
            "Kind and scale of the values, the unit of the wavelengths, and the other choices; the \
             picture is drawn anew with each."
        );
        let reading = pressed_if(ui, entry.path().is_some(), button, meaning);
        about(ui, entry);
        reading
    });
    row.inner
}

/// Its size, its bands and what its values are.
fn about(ui: &mut Ui, entry: &ImageEntry) {
    let cube = &entry.image.cube;
    let nm = cube.nm();
    let words = tr!(
        "{width} x {height} pixels, {bands} bands {first_nm}–{last_nm} nm, {kind}, {memory}",
        width = cube.width(),
        height = cube.height(),
        bands = nm.len(),
        first_nm = short(nm[0]),
        last_nm = short(nm[nm.len() - 1]),
        kind = said(entry.image.kind.word()),
        memory = budget::in_words(cube.memory())
    );
    ui.add(egui::Label::new(egui::RichText::new(words).weak()).truncate())
        .on_hover_ui(|ui| {
            ui.label(said!(
                "Size, bands, kind of the values, and the memory that they take."
            ));
            for note in &entry.image.notes {
                ui.label(note);
            }
        });
}

/// True colour or bands, and the exposure.
pub(super) fn looks(ui: &mut Ui, context: &mut PageContext<'_>, entry: &ImageEntry) {
    ui.horizontal_wrapped(|ui| {
        for show in Show::ALL {
            ui.selectable_value(&mut context.pages.image.show, show, show.title())
                .on_hover_text(show.meaning());
        }
        if ui.available_size_before_wrap().x < EXPOSURE_ROOM * context.theme.scale {
            // A slider does not go on in a further row by itself.
            let high = ui.spacing().interact_size.y;
            ui.end_row();
            ui.set_row_height(high);
        } else {
            ui.separator();
        }
        exposure(ui, context);
        let is_factor = entry.image.kind.is_factor();
        if is_factor && context.pages.image.show == Show::TrueColour {
            let meaning = tr!(
                "Brings the colour of the light, {light}, to the screen's white (Bradford), here \
                 and in the surfaces.",
                light = context.app.document().light.name()
            );
            let words = (said(names::ADAPT), meaning.as_str());
            adapt_box(ui, context.app, words, context.commands);
        }
    });
    let nm = entry.image.cube.nm();
    let memory = &mut context.pages.image;
    match memory.show {
        Show::TrueColour => {}
        Show::ThreeBands => {
            let scale = context.theme.scale;
            let bands = memory.three_nm.iter_mut().zip(names::RGB);
            if ui.available_width() < 3.0 * BAND_ROOM * scale {
                for (at, name) in bands {
                    ui.horizontal(|ui| band_slider(ui, entry, nm, at, name));
                }
            } else {
                ui.horizontal(|ui| {
                    let share = ui.available_width() / 3.0;
                    let rail = share - (BAND_ROOM - BAND_RAIL) * scale;
                    ui.spacing_mut().slider_width = rail.min(2.0 * BAND_RAIL * scale);
                    bands.for_each(|(at, name)| band_slider(ui, entry, nm, at, name));
                });
            }
        }
        Show::OneBand => {
            ui.horizontal(|ui| band_slider(ui, entry, nm, &mut memory.one_nm, names::BAND));
        }
    }
}

/// Room of a band's name, slider and number, and of the slider's rail in it, points.
const BAND_ROOM: f32 = 200.0;
const BAND_RAIL: f32 = 60.0;

/// Room of the exposure's name, slider and number, points.
const EXPOSURE_ROOM: f32 = 230.0;

/// The exposure with what its 0 means beside it.
fn exposure(ui: &mut Ui, context: &mut PageContext<'_>) {
    let meaning = said!(
        "The brightness of the picture alone: each stop doubles it. At 0 stops the 99th percentile \
         of the pixels' strongest channel has the screen's full brightness."
    );
    ui.spacing_mut().slider_width = 64.0 * context.theme.scale;
    let label = ui.label(said(names::EXPOSURE)).on_hover_text(meaning);
    let slider = slide(
        &mut context.pages.image.stops,
        ImageMemory::EXPOSURE.reach.range(),
    )
    .step_by(0.1)
    .fixed_decimals(1)
    .suffix(format!(" {}", said!("stops")));
    ui.add(slider).labelled_by(label.id).on_hover_text(meaning);
    ui.weak(said!("over what fits the screen"))
        .on_hover_text(meaning);
}

fn band_slider(ui: &mut Ui, entry: &ImageEntry, nm: &[f64], at: &mut f64, name: &'static str) {
    let mut band = entry.image.cube.nearest_band(*at);
    let last = nm.len() - 1;
    let of_band = |band: f64| nm[(band.max(0.0) as usize).min(last)];
    let slider = slide(&mut band, 0..=last)
        .custom_formatter(move |band, _| format!("{} nm", short(of_band(band))))
        .custom_parser(|text| {
            let nm = text.trim().trim_end_matches("nm").trim().parse().ok()?;
            Some(entry.image.cube.nearest_band(nm) as f64)
        });
    let label = ui.label(said(name));
    let response = ui
        .add(slider)
        .labelled_by(label.id)
        .on_hover_text(said!("A band of the image by its wavelength, nm."));
    if response.changed() {
        *at = nm[band.min(last)];
    }
}

/// What the chosen pixels are and what can be done with them; whether they are to be taken.
pub(super) fn choice(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (shown, colour): (&Shown, Option<Srgb>),
    canvas: &mut Canvas,
) -> bool {
    let mut take = false;
    let all = shown.cube().all();
    // A row wider than its column would take the curve below it over the window's edge.
    ui.horizontal_wrapped(|ui| {
        let meaning = said!(
            "The pixel's spectrum, or the mean of the region, becomes one of your own and is \
             shown. Enter or a double click does the same."
        );
        take = pressed(ui, said(names::TAKE), meaning);
        let ask = ui
            .add_enabled(colour.is_some(), egui::Button::new(said(names::COLOUR)))
            .on_hover_text(said!(
                "Takes the colour alone to the page From a colour: which surfaces have it?"
            ));
        if let Some(Srgb(rgb)) = colour.filter(|_| ask.clicked()) {
            context.ask_about_colour(rgb);
        }
        let whole = shown.rect == all;
        let meaning = said!("Chooses every pixel of the image.");
        if pressed_if(ui, !whole, egui::Button::new(said(names::WHOLE)), meaning) {
            context.pages.image.selection = None;
        }
        let meaning = said!("Shows all of the picture. The wheel zooms, the right button pans.");
        if pressed_if(
            ui,
            !canvas.is_fitted(),
            egui::Button::new(said(names::FIT)),
            meaning,
        ) {
            canvas.fit();
        }
        if shown.rect.pixels() > 1 {
            ui.separator();
            let spread = &mut context.pages.image.spread;
            ui.selectable_value(spread, Spread::Deviation, "± 1 σ")
                .on_hover_text(said!(
                    "Around the mean: one standard deviation of the pixels."
                ));
            ui.selectable_value(spread, Spread::Extremes, said!("min–max"))
                .on_hover_text(said!(
                    "Around the mean: the smallest and the largest pixel of each band."
                ));
        }
    });
    take
}

/// What was taken last, and the way to it.
pub(super) fn taken(ui: &mut Ui, context: &mut PageContext<'_>, name: &str) {
    let meaning = said!("Goes to the page Spectrum.");
    if pressed_small(ui, said!("Show on Spectrum"), meaning) {
        *context.page = Page::Spectrum;
    }
    let words = egui::RichText::new(tr!("Taken into My files: {name}", name));
    ui.add(egui::Label::new(words).truncate());
}
