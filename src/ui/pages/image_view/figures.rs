//! Numbers: the pixel under the pointer, and the model of the chosen spectrum.

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{Drawn, Shown};
use crate::{
    app::{
        charts::tradeoff::{spikes_words, waves_words},
        derived::Derived,
        numbers::{hundredths, two_digits},
        picture::{RegionSpectrum, seen_in},
        ticks::short,
    },
    color::{Srgb, Swatch},
    io::many::{capitalised, numbers},
    languages::said,
    spectrum::Sampled,
    study::Measure,
    ui::{pages::PageContext, swatch, theme::Theme},
};

/// Height of the model's figures, points.
pub(super) fn height(ui: &Ui, theme: Theme) -> f32 {
    (SWATCH + CAPTION) * theme.scale + 2.0 * super::line(ui)
}

/// Height of the two colours side by side, points.
const SWATCH: f32 = 24.0;

/// Height of the words under them, points.
const CAPTION: f32 = 15.0;

/// What is under the pointer; where nothing is, how to choose.
pub(super) fn pointed(
    ui: &mut Ui,
    shown: &Shown,
    drawn: Option<&Drawn>,
    pointed: Option<[usize; 2]>,
) {
    let Some([x, y]) = pointed else {
        ui.weak(said!(
            "Click a pixel, drag a rectangle; the wheel zooms, the right button pans."
        ));
        return;
    };
    let mut words = tr!("row {row}, column {column}", row = y, column = x);
    if let Some(colour) = drawn.map(|drawn| colour_at(drawn, [x, y])) {
        let (rect, _) = ui.allocate_exact_size(vec2(18.0, 14.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 2.0, swatch::colour(colour));
        words += &format!(", {colour}");
    }
    let image = &shown.entry.image;
    let measured = image.cube.values_at(x, y);
    let bands: Vec<usize> = if shown.bands.is_empty() {
        vec![image.cube.nearest_band(550.0)]
    } else {
        shown.bands.clone()
    };
    for band in bands {
        let value = measured[band] * image.scale;
        let value = if value.is_finite() {
            short(value)
        } else {
            said!("not measured").to_owned()
        };
        words += &format!(", {} nm: {value}", short(image.cube.nm()[band]));
    }
    if let Some(xyz) = shown
        .weights
        .as_ref()
        .and_then(|weights| weights.pixel(image, x, y))
    {
        // A reflectance has the light's Y at 100, a light that of the picture's white.
        let over = match drawn {
            Some(drawn) if !image.kind.is_factor() && drawn.raster.is_xyz => drawn.raster.full[1],
            _ => 1.0,
        };
        if over > 0.0 {
            let [x, y, z] = (xyz * (100.0 / over)).to_array().map(short);
            words += &format!(", XYZ {x} {y} {z}");
        }
    }
    ui.add(egui::Label::new(words).truncate())
        .on_hover_text(said!(
            "Row and column from 0, the colour as drawn, values in the image's unit, and X, Y, Z \
             with Y = 100 for the light on a reflectance or for the picture's white at exposure 0."
        ));
}

fn colour_at(drawn: &Drawn, [x, y]: [usize; 2]) -> Srgb {
    let step = drawn.raster.step;
    let index = (y / step) * drawn.exposed.width + x / step;
    let pixels = &drawn.exposed.pixels;
    Srgb(pixels.get(index).copied().unwrap_or_default())
}

/// Measured and model as the picture shows them; `None` where it shows bands.
fn as_in_picture(
    region: &RegionSpectrum,
    derived: &Derived,
    shown: &Shown,
    drawn: Option<&Drawn>,
) -> Option<[Swatch; 2]> {
    let (weights, drawn) = (shown.weights.as_ref()?, drawn?);
    let band = derived.band;
    let model = Sampled::even(band.min_nm(), 1.0, derived.model_values()).ok()?;
    let seen = |samples: &Sampled| seen_in(&drawn.raster, drawn.stops, weights.xyz(samples));
    Some([seen(&region.spectrum.samples)?, seen(&model)?])
}

/// The colour of the chosen pixels, as the picture shows it where it does.
pub(super) fn colour_of(
    region: &RegionSpectrum,
    shown: &Shown,
    drawn: Option<&Drawn>,
) -> Option<Srgb> {
    let derived = region.derived.as_ref()?;
    let swatch = match as_in_picture(region, derived, shown, drawn) {
        Some([exact, _]) => exact,
        None => derived.colour.exact?.swatch,
    };
    Some(swatch.rgb8)
}

/// How bright colours are that are not drawn as the picture.
fn own_scale(shown: &Shown) -> &'static str {
    if shown.entry.image.kind.is_factor() {
        said!("a white under the document's light is the screen's white")
    } else {
        said!("as bright as the screen can")
    }
}

/// The model of the chosen spectrum: colours, numbers, errors.
pub(super) fn model(
    ui: &mut Ui,
    context: &PageContext<'_>,
    region: &RegionSpectrum,
    shown: &Shown,
    drawn: Option<&Drawn>,
) {
    let Some(derived) = &region.derived else {
        ui.weak(tr!(
            "{kind} values have no model here: it takes a light, a reflectance or a transmittance.",
            kind = said(region.spectrum.kind.word())
        ));
        return;
    };
    let colour = &derived.colour;
    let size = vec2(ui.available_width(), SWATCH * context.theme.scale);
    let delta_e = hundredths(colour.delta_e_2000);
    if let (Some(exact), Some(model)) = (colour.exact, colour.model) {
        let (exact, model, scale) = match as_in_picture(region, derived, shown, drawn) {
            Some([exact, model]) => (exact, model, said!("as bright as in the picture")),
            None => (exact.swatch, model.swatch, own_scale(shown)),
        };
        ui.spacing_mut().item_spacing.y = 2.0;
        let name = tr!(
            "Image colours: measured {measured}, model {model}",
            measured = exact.hex(),
            model = model.hex()
        );
        swatch::split(ui, size, &exact, &model, &name).on_hover_text(format!(
            "{} {}.",
            said!("Left the chosen spectrum as measured, right by its model."),
            capitalised(crate::languages::said(exact.mapping.words()))
        ));
        let words = tr!(
            "Measured {measured}, model {model}: {scale}.",
            measured = exact.hex(),
            model = model.hex(),
            scale
        );
        ui.add(egui::Label::new(RichText::new(words).small().weak()).truncate());
    } else {
        let size = size + vec2(0.0, CAPTION * context.theme.scale);
        ui.allocate_ui(size, |ui| {
            ui.set_min_height(size.y);
            ui.weak(said!("No visible light in the model's range: no colour."));
        });
    }
    let model = &derived.model;
    let rms = derived.figures[Measure::Rms];
    let rms = rms.map(|rms| format!(", rms {} %", two_digits(100.0 * rms)));
    let words = tr!(
        "Model: {numbers}, {waves}, {lines}; ΔE₀₀ {delta_e}{rms}",
        numbers = numbers(derived.numbers()),
        waves = waves_words(model.smooth().order()),
        lines = spikes_words(model.lines().len()),
        delta_e,
        rms = rms.unwrap_or_default()
    );
    ui.add(egui::Label::new(RichText::new(words).strong()).truncate())
        .on_hover_text(said!(
            "With the waves and lines of the model. CIEDE2000 and relative root mean square \
             between the chosen spectrum and its model, on the model's range."
        ));
    let nm = (region.nm[0], region.nm[region.nm.len() - 1]);
    let band = derived.band;
    if nm.0 > band.min_nm() + 1.0 || nm.1 < band.max_nm() - 1.0 {
        let bands = format!("{}–{}", short(nm.0), short(nm.1));
        let range = format!("{}–{}", short(band.min_nm()), short(band.max_nm()));
        let words = match region.spectrum.kind.is_factor() {
            true => tr!(
                "Bands {bands} nm: the model's range {range} nm reaches beyond, where values are \
                 held.",
                bands,
                range
            ),
            false => tr!(
                "Bands {bands} nm: the model's range {range} nm reaches beyond, where values are \
                 zero.",
                bands,
                range
            ),
        };
        ui.add(egui::Label::new(RichText::new(words).weak()).truncate());
    }
}
