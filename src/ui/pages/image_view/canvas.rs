//! The picture: fitted to its space, zoomed and panned, with pixels to choose by hand and by key.

use eframe::egui;
use egui::{
    Color32, Key, PointerButton, Pos2, Rect as Area, Sense, Stroke, StrokeKind, TextureId, Ui,
    Vec2, pos2, vec2,
};

use crate::{
    spectrum::Rect,
    ui::{
        kit::{drawing, hold_arrows},
        theme::{Theme, grey},
    },
};

/// Most points that a pixel is magnified to.
const MOST_SCALE: f32 = 64.0;

/// What part of an image is seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Canvas {
    /// The image that the rest is of.
    key: String,
    /// Times the size that fits, from 1 on.
    zoom: f32,
    /// The pixel in the middle.
    centre: Vec2,
    /// Where a rectangle was begun.
    begun: Option<[usize; 2]>,
}

/// A picture to show.
pub(super) struct Picture<'a> {
    /// Which image it is of.
    pub key: &'a str,
    /// Its name for screen readers.
    pub name: &'a str,
    /// Columns and rows of the image.
    pub pixels: [usize; 2],
    /// Its texture, and how many pixels of the image each texel stands for.
    pub texture: Option<(TextureId, [usize; 2], usize)>,
    /// The chosen pixels; `None` for all.
    pub selection: Option<Rect>,
}

/// What a hand did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Touched {
    /// The pixel under the pointer.
    pub pointed: Option<[usize; 2]>,
    /// New pixels.
    pub selected: Option<Rect>,
    /// The chosen pixels are to become a spectrum.
    pub take: bool,
    /// The keys are the picture's.
    pub focused: bool,
}

/// From pixels of the image to the screen and back.
#[derive(Clone, Copy)]
struct Mapping {
    area: Area,
    centre: Vec2,
    /// Points of a pixel.
    scale: f32,
    pixels: [usize; 2],
}

impl Mapping {
    fn pos(self, x: f32, y: f32) -> Pos2 {
        self.area.center() + (vec2(x, y) - self.centre) * self.scale
    }

    fn place(self, at: Pos2) -> Vec2 {
        (at - self.area.center()) / self.scale + self.centre
    }

    /// The pixel at a place of the screen; the nearest one where the place is beside the image.
    fn nearest(self, at: Pos2) -> [usize; 2] {
        let place = self.place(at);
        // `as usize` takes what is negative to 0.
        let pixel = |v: f32, count: usize| (v.floor() as usize).min(count - 1);
        [
            pixel(place.x, self.pixels[0]),
            pixel(place.y, self.pixels[1]),
        ]
    }

    fn inside(self, at: Pos2) -> bool {
        let place = self.place(at);
        let within = |v: f32, count: usize| v >= 0.0 && v < count as f32;
        self.area.contains(at) && within(place.x, self.pixels[0]) && within(place.y, self.pixels[1])
    }
}

impl Canvas {
    /// Shows all of the image again.
    pub(super) fn fit(&mut self) {
        self.zoom = 1.0;
    }

    /// Whether all of the image is seen.
    pub(super) fn is_fitted(&self) -> bool {
        self.zoom <= 1.0
    }

    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        size: Vec2,
        picture: &Picture<'_>,
        theme: Theme,
    ) -> Touched {
        let (area, response) = drawing(ui, size, Sense::click_and_drag(), picture.name);
        if self.key != picture.key {
            *self = Self {
                key: picture.key.to_owned(),
                zoom: 1.0,
                ..Self::default()
            };
        }
        let [width, height] = picture.pixels;
        if width == 0 || height == 0 {
            return Touched::default();
        }
        let whole = vec2(width as f32, height as f32);
        let fit = (area.width() / whole.x).min(area.height() / whole.y);
        self.move_view(ui, area, &response, whole, fit);
        let mapping = Mapping {
            area,
            centre: self.centre,
            scale: fit * self.zoom,
            pixels: picture.pixels,
        };
        let touched = self.touch(ui, &response, mapping, picture);
        let selection = touched.selected.or(picture.selection);
        paint(ui, mapping, picture, selection, theme);
        if response.has_focus() {
            let stroke = ui.visuals().widgets.active.bg_stroke;
            ui.painter()
                .rect_stroke(area, 2.0, stroke, StrokeKind::Inside);
        }
        if response.hovered() {
            ui.set_cursor_icon(egui::CursorIcon::Crosshair);
        }
        touched
    }

    /// Wheel, pinch and the right button.
    fn move_view(&mut self, ui: &Ui, area: Area, response: &egui::Response, whole: Vec2, fit: f32) {
        let most = (MOST_SCALE / fit).max(1.0);
        if let Some(at) = response.hover_pos() {
            let (pinch, wheel) = ui.input(|i| (i.zoom_delta(), i.smooth_scroll_delta().y));
            let factor = pinch * (wheel / 200.0).exp();
            if factor != 1.0 {
                // The pixel under the pointer stays there.
                let from_middle = at - area.center();
                let pixel = self.centre + from_middle / (fit * self.zoom);
                self.zoom = (self.zoom * factor).clamp(1.0, most);
                self.centre = pixel - from_middle / (fit * self.zoom);
            }
        }
        self.zoom = self.zoom.clamp(1.0, most);
        let scale = fit * self.zoom;
        let pans = [PointerButton::Secondary, PointerButton::Middle];
        if pans.iter().any(|button| response.dragged_by(*button)) {
            self.centre -= response.drag_delta() / scale;
        }
        // No empty space where there is image to show.
        let seen = area.size() / scale;
        for k in 0..2 {
            let half = (seen[k] / 2.0).min(whole[k] / 2.0);
            self.centre[k] = self.centre[k].clamp(half, whole[k] - half);
        }
    }

    /// Clicks, rectangles and keys.
    fn touch(
        &mut self,
        ui: &Ui,
        response: &egui::Response,
        mapping: Mapping,
        picture: &Picture<'_>,
    ) -> Touched {
        let mut touched = Touched {
            pointed: response
                .hover_pos()
                .filter(|at| mapping.inside(*at))
                .map(|at| mapping.nearest(at)),
            ..Touched::default()
        };
        if response.drag_started_by(PointerButton::Primary) {
            let origin = ui.input(|i| i.pointer.press_origin());
            self.begun = origin.map(|at| mapping.nearest(at));
        }
        if let Some(begun) = self.begun {
            if let Some(at) = response.interact_pointer_pos() {
                touched.selected = Some(Rect::between(begun, mapping.nearest(at)));
            }
            if !response.dragged_by(PointerButton::Primary) {
                self.begun = None;
            }
        }
        if response.clicked() {
            response.request_focus();
            let at = response.interact_pointer_pos();
            touched.selected = at
                .filter(|at| mapping.inside(*at))
                .map(|at| mapping.nearest(at))
                .map(|[x, y]| Rect::pixel(x, y));
            touched.take = response.double_clicked() && touched.selected.is_some();
        }
        touched.focused = response.has_focus();
        if touched.focused {
            hold_arrows(ui, response.id, true);
            let moved = moved_by_keys(ui, picture);
            touched.selected = touched.selected.or(moved);
        }
        touched
    }
}

/// The arrow keys move the chosen pixels, ten at a time with Shift.
fn moved_by_keys(ui: &Ui, picture: &Picture<'_>) -> Option<Rect> {
    let [width, height] = picture.pixels;
    let step = if ui.input(|i| i.modifiers.shift) {
        10
    } else {
        1
    };
    let pressed = |key| ui.input(|i| i.num_presses(key)) * step;
    let [left, right, up, down] = [
        Key::ArrowLeft,
        Key::ArrowRight,
        Key::ArrowUp,
        Key::ArrowDown,
    ]
    .map(pressed);
    if left + right + up + down == 0 {
        return None;
    }
    // From the whole image the keys begin in its middle.
    let rect = picture
        .selection
        .unwrap_or_else(|| Rect::pixel(width / 2, height / 2));
    Some(Rect {
        x: (rect.x + right)
            .saturating_sub(left)
            .min(width - rect.width),
        y: (rect.y + down).saturating_sub(up).min(height - rect.height),
        ..rect
    })
}

fn paint(ui: &Ui, mapping: Mapping, picture: &Picture<'_>, selection: Option<Rect>, theme: Theme) {
    let painter = ui.painter().with_clip_rect(mapping.area);
    // A neutral ground that no pixel of the picture is lost in.
    painter.rect_filled(mapping.area, 2.0, grey(if theme.dark { 20 } else { 205 }));
    let [width, height] = picture.pixels.map(|side| side as f32);
    let screen = Area::from_two_pos(mapping.pos(0.0, 0.0), mapping.pos(width, height));
    if let Some((texture, [across, down], step)) = picture.texture {
        // The last block may reach beyond the image.
        let covered = vec2((across * step) as f32, (down * step) as f32);
        let uv = Area::from_min_max(Pos2::ZERO, pos2(width / covered.x, height / covered.y));
        painter.image(texture, screen, uv, Color32::WHITE);
    }
    let Some(rect) = selection else {
        return;
    };
    let corner = mapping.pos(rect.x as f32, rect.y as f32);
    let size = vec2(rect.width as f32, rect.height as f32) * mapping.scale;
    let mut frame = Area::from_min_size(corner, size);
    // A pixel that is smaller than its frame is still found.
    let least = 7.0 * theme.scale;
    frame = frame.expand2((Vec2::splat(least) - frame.size()).max(Vec2::ZERO) / 2.0);
    for (width, colour) in [(3.0, Color32::BLACK), (1.2, Color32::WHITE)] {
        let stroke = Stroke::new(width * theme.scale, colour);
        painter.rect_stroke(frame, 0.0, stroke, StrokeKind::Outside);
    }
}
