//! Pictures of the window and of the plot, without display or GPU.

use std::sync::Arc;

use eframe::egui;
use egui::ColorImage;

use super::{
    Window,
    chart_view::paint,
    files::Picked,
    painter::{encode_png, picture_with},
    theme,
};
use crate::app::{
    App,
    chart::{Chart, Drawing, Looks},
    workspace::Preferences,
};

/// Frames until layout, fonts and automatic axes are settled.
const PASSES: usize = 4;

/// Least and largest side of a picture, points.
const SIDES: std::ops::RangeInclusive<u32> = 64..=8192;

fn sides(size: [u32; 2]) -> egui::Vec2 {
    let [width, height] = size.map(|s| s.clamp(*SIDES.start(), *SIDES.end()) as f32);
    egui::vec2(width, height)
}

/// The real window over a program, drawn at a size in points and one pixel each.
pub fn window_image(app: &App, preferences: &Preferences, size: [u32; 2]) -> ColorImage {
    let context = egui::Context::default();
    let preferences = Preferences {
        // The size asked for is the picture's: a zoom would change it.
        zoom: 1.0,
        ..preferences.clone()
    };
    let no_files = Arc::new(|_: &super::files::Ask| Picked::Cancelled);
    let mut window = Window::new(app.clone(), preferences, no_files, None);
    window.quiet = true;
    picture_with(&context, sides(size), 1.0, PASSES, |ui| {
        window.show(ui);
        window.studies.finish();
    })
}

/// [`window_image`] as a PNG file.
pub fn window_png(app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8> {
    encode_png(&window_image(app, preferences, size))
}

/// A chart as a PNG file, with its title, the names of its series and its notes.
pub fn chart_png(chart: &Chart, size: [u32; 2]) -> Vec<u8> {
    let context = egui::Context::default();
    theme::install_fonts(&context);
    let sides = sides(size);
    let drawing = Drawing::new(chart, [sides.x, sides.y].map(f64::from), Looks::FILE);
    let primitives = drawing.primitives(chart.whole_view());
    let image = picture_with(&context, sides, 1.0, PASSES, |ui| {
        let shapes = paint::shapes(ui.painter(), egui::Vec2::ZERO, &primitives);
        ui.painter().extend(shapes);
    });
    encode_png(&image)
}
