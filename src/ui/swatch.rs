//! Colour fields: one colour, or two side by side, with a name for screen readers.

use eframe::egui;
use egui::{
    Color32, ColorImage, CornerRadius, Rect, Response, Sense, Stroke, StrokeKind, TextureFilter,
    TextureOptions, Ui, Vec2,
};

use crate::color::{Srgb, Swatch};

/// A colour as egui has it: no colour management, sRGB values as they are.
pub(super) fn colour(Srgb([r, g, b]): Srgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// Columns and rows of pixels as egui has them.
pub(super) fn image(size: [usize; 2], pixels: &[[u8; 3]]) -> ColorImage {
    let colours = pixels.iter().map(|rgb| colour(Srgb(*rgb)));
    ColorImage::new(size, colours.collect())
}

/// How a picture is drawn whose pixels stay squares however large they are.
pub(super) const SQUARES: TextureOptions = TextureOptions {
    magnification: TextureFilter::Nearest,
    ..TextureOptions::LINEAR
};

/// Two colours in one field, left and right, with no line between: what differs is seen.
pub(super) fn split(
    ui: &mut Ui,
    size: Vec2,
    left: &Swatch,
    right: &Swatch,
    name: &str,
) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), name));
    paint_split(ui, rect, colour(left.rgb8), colour(right.rgb8));
    if response.hovered() || response.has_focus() {
        outline(ui, rect, ui.visuals().widgets.active.bg_stroke);
    } else {
        // A white field must not melt into a light window.
        outline(ui, rect, ui.visuals().widgets.noninteractive.bg_stroke);
    }
    // On every field of a row it would be louder than the colours.
    if !(left.in_gamut && right.in_gamut) && (response.hovered() || response.has_focus()) {
        out_of_gamut_mark(ui, rect);
    }
    menu(&response, [left.rgb8, right.rgb8]);
    response
}

/// Where the colour lies that was asked for in the menu of a swatch.
fn place() -> egui::Id {
    egui::Id::unique("colour of a swatch")
}

/// The menu of a swatch: its colours can be taken to the page "From a colour".
pub(super) fn menu(response: &Response, colours: [Srgb; 2]) {
    response.context_menu(|ui| {
        ui.label(said!("Which surfaces have this colour?"));
        let [left, right] = colours;
        let parts = match left == right {
            true => vec![left.to_string()],
            false => vec![
                tr!("left: {colour}", colour = left),
                tr!("right: {colour}", colour = right),
            ],
        };
        for (words, colour) in parts.into_iter().zip(colours) {
            if ui.button(words).clicked() {
                ui.data_mut(|data| data.insert_temp(place(), colour.0));
                ui.close();
            }
        }
    });
}

/// The colour that was asked for in the menu of a swatch, once.
pub(super) fn asked_for(context: &egui::Context) -> Option<[u8; 3]> {
    context.data_mut(|data| data.remove_temp(place()))
}

/// Fills a rectangle with two colours.
pub(super) fn paint_split(ui: &Ui, rect: Rect, left: Color32, right: Color32) {
    let middle = rect.center().x.round();
    let painter = ui.painter();
    let (l, r) = rect.split_left_right_at_x(middle);
    let corners = |west, east| CornerRadius {
        nw: west,
        sw: west,
        ne: east,
        se: east,
    };
    painter.rect_filled(l, corners(3, 0), left);
    painter.rect_filled(r, corners(0, 3), right);
}

/// Two small marks in the middle of a field that tell where its halves meet: without them a
/// difference that cannot be seen looks like no comparison.
pub(super) fn ticks(ui: &Ui, rect: Rect, length: f32) {
    let x = rect.center().x.round();
    let inks = [
        Color32::BLACK.gamma_multiply(0.75),
        Color32::WHITE.gamma_multiply(0.5),
    ];
    for top in [rect.top(), rect.bottom() - length] {
        for (at, ink) in [x, x + 1.0].into_iter().zip(inks) {
            ui.painter().vline(at, top..=top + length, (1.0, ink));
        }
    }
}

/// The mark of the worst of several fields: a dot in its corner, seen on any colour.
pub(super) fn dot(ui: &Ui, rect: Rect, scale: f32) {
    let at = rect.left_bottom() + Vec2::new(8.0, -8.0) * scale;
    let edge = Stroke::new(1.5 * scale, Color32::BLACK);
    ui.painter().circle(at, 4.0 * scale, Color32::WHITE, edge);
}

/// The mark of the chosen one of several fields: a ring inside it, seen on any colour.
pub(super) fn ring(ui: &Ui, rect: Rect, scale: f32) {
    for (inset, ink) in [(0.0, Color32::BLACK), (1.5, Color32::WHITE)] {
        let stroke = Stroke::new(1.5 * scale, ink);
        let corners = CornerRadius::same(3);
        let field = rect.shrink(inset * scale);
        ui.painter()
            .rect_stroke(field, corners, stroke, StrokeKind::Inside);
    }
}

/// Draws a line around a field.
pub(super) fn outline(ui: &Ui, rect: Rect, stroke: Stroke) {
    ui.painter()
        .rect_stroke(rect, CornerRadius::same(3), stroke, StrokeKind::Outside);
}

/// A corner: this colour is not the one on screen.
pub(super) fn out_of_gamut_mark(ui: &Ui, rect: Rect) {
    const SIDE: f32 = 9.0;
    let corner = rect.right_top();
    let corners = vec![
        corner,
        corner + Vec2::new(0.0, SIDE),
        corner - Vec2::new(SIDE, 0.0),
    ];
    ui.painter().add(egui::Shape::convex_polygon(
        corners,
        Color32::BLACK,
        Stroke::NONE,
    ));
}
