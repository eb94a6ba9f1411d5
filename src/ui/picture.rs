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
use crate::{
    app::{
        App,
        chart::{Chart, Drawing, Looks, Theme},
        lessons::Lesson,
        workspace::Preferences,
    },
    languages::{self, Language},
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
    let language = preferences.language;
    let mut window = Window::new(app.clone(), preferences, no_files, None);
    window.quiet = true;
    languages::in_language(language, || {
        picture_with(&context, sides(size), 1.0, PASSES, |ui| {
            window.show(ui);
            window.studies.finish();
        })
    })
}

/// Size of the window in which names are looked for, points.
const ROOM: egui::Vec2 = egui::vec2(1280.0, 800.0);

/// Names of all that the window shows over a program, as screen readers are told them: of controls
/// first, of words behind them, each from above.
pub fn names(app: &App, preferences: &Preferences) -> Vec<String> {
    let context = egui::Context::default();
    context.enable_accesskit();
    let no_files = Arc::new(|_: &super::files::Ask| Picked::Cancelled);
    let mut window = Window::new(app.clone(), preferences.clone(), no_files, None);
    window.quiet = true;
    let mut found = Vec::new();
    for pass in 0..PASSES {
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, ROOM)),
            time: Some(pass as f64),
            ..egui::RawInput::default()
        };
        let mut output = context.run_ui(input, |ui| {
            window.show(ui);
            window.studies.finish();
        });
        // Nothing is painted.
        output.textures_delta.clear();
        found = output
            .platform_output
            .accesskit_update
            .map_or(Vec::new(), |u| u.nodes);
    }
    let mut names: Vec<(bool, i64, String)> = Vec::new();
    for (_, node) in &found {
        let is_words = node.role() == egui::accesskit::Role::Label;
        let top = node.bounds().map_or(0, |bounds| bounds.y0 as i64);
        let named = [node.label(), node.value()].into_iter().flatten();
        let named = named.filter(|name| !name.trim().is_empty());
        names.extend(named.map(|name| (is_words, top, name.to_owned())));
    }
    names.sort();
    let mut names: Vec<String> = names.into_iter().map(|(_, _, name)| name).collect();
    names.dedup();
    names
}

/// Size of the picture of a lesson in their list, points and pixels.
pub const LESSON: [usize; 2] = [180, 120];

/// Window in which a lesson's step is drawn, points: its page is 930 wide.
const CLASS: egui::Vec2 = egui::vec2(1550.0, 720.0);

/// The window before a class at a step of a lesson, as it begins or as it ends, and where the page
/// begins in it beside the lesson's column.
fn before_class(
    lesson: &Arc<Lesson>,
    (step, done): (usize, bool),
    dark: bool,
) -> (ColorImage, usize) {
    let context = egui::Context::default();
    let mut preferences = Preferences {
        dark,
        present: true,
        ..Preferences::default()
    };
    let language = Language::of_locale(&lesson.language).unwrap_or_default();
    preferences.speak(language);
    let no_files = Arc::new(|_: &super::files::Ask| Picked::Cancelled);
    let mut window = Window::new(App::new(), preferences, no_files, None);
    window.quiet = true;
    let picture = languages::in_language(language, || {
        window.begin(lesson, step, done);
        picture_with(&context, CLASS, 1.0, PASSES, |ui| {
            window.show(ui);
            window.studies.finish();
        })
    });
    // Behind the line at the column's edge.
    (picture, window.lesson_ends().ceil() as usize + 2)
}

/// The page of a lesson's step, from 0, as a class sees it when it begins, nothing covered and
/// nothing pointed at, on paper's white, as a PNG file.
pub fn step_png(lesson: &Arc<Lesson>, step: usize) -> Vec<u8> {
    let mut open = Lesson::clone(lesson);
    for step in &mut open.steps {
        (step.veil, step.point) = (false, None);
    }
    let (whole, column) = before_class(&Arc::new(open), (step, false), false);
    let [width, _] = whole.size;
    let rows = whole.pixels.chunks(width);
    let pixels: Vec<_> = rows.flat_map(|row| &row[column..]).copied().collect();
    let size = [width - column, whole.size[1]];
    encode_png(&ColorImage::new(size, pixels))
}

/// The page of a lesson's step as a class sees it, small.
pub fn of_lesson(lesson: &Arc<Lesson>, dark: bool) -> ColorImage {
    /// Where the picture begins beside the lesson's column and below the page's title, and by how
    /// much it is made smaller.
    const CORNER: [usize; 2] = [14, 84];
    const SMALLER: usize = 5;
    let step = lesson.picture.saturating_sub(1);
    let (whole, column) = before_class(lesson, (step, true), dark);
    let mean = |x: usize, y: usize| {
        let square = (0..SMALLER * SMALLER).map(|at| {
            let left = column + CORNER[0] + SMALLER * x + at % SMALLER;
            let top = CORNER[1] + SMALLER * y + at / SMALLER;
            whole.pixels[left.min(whole.size[0] - 1) + top * whole.size[0]]
        });
        let sums = square.fold([0_u32; 3], |sums, pixel| {
            let [red, green, blue, _] = pixel.to_array().map(u32::from);
            [sums[0] + red, sums[1] + green, sums[2] + blue]
        });
        let count = (SMALLER * SMALLER) as u32;
        let [red, green, blue] = sums.map(|sum| (sum / count) as u8);
        egui::Color32::from_rgb(red, green, blue)
    };
    let [width, height] = LESSON;
    let pixels = (0..width * height).map(|at| mean(at % width, at / width));
    ColorImage::new(LESSON, pixels.collect())
}

/// [`window_image`] as a PNG file.
pub fn window_png(app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8> {
    encode_png(&window_image(app, preferences, size))
}

/// A chart as a PNG file, with its title, the names of its series and its notes.
pub fn chart_png(chart: &Chart, size: [u32; 2], theme: Theme) -> Vec<u8> {
    let context = egui::Context::default();
    theme::install_fonts(&context);
    let sides = sides(size);
    let drawing = Drawing::new(
        chart,
        [sides.x, sides.y].map(f64::from),
        Looks::of_file(theme),
    );
    let primitives = drawing.primitives(chart.whole_view());
    let image = picture_with(&context, sides, 1.0, PASSES, |ui| {
        let shapes = paint::shapes(ui.painter(), egui::Vec2::ZERO, &primitives);
        ui.painter().extend(shapes);
    });
    encode_png(&image)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::lessons::shelf;

    #[test]
    fn the_picture_of_a_step_is_of_its_page_alone() {
        for name in ["light", "prism"] {
            let lesson = shelf::named(name).expect("shipped");
            let (whole, column) = before_class(&lesson, (0, false), false);
            let width = whole.size[0];
            assert!((900..960).contains(&(width - column)), "{name}: {column}");
            // The page's margin: no word of the column, nor its edge.
            let margin = whole.pixels.chunks(width).map(|row| row[column]);
            let first = whole.pixels[column];
            assert!(margin.into_iter().all(|pixel| pixel == first), "{name}");
        }
    }
}
