//! A picture of colours on the page "From a colour": a click takes a pixel's colour.

use std::sync::Arc;

use eframe::egui;
use egui::{TextureHandle, TextureOptions, Ui, vec2};

use super::DesignView;
use crate::{
    app::design::photo::{Photo, PhotoAsk},
    color::Srgb,
    ui::{
        kit::{drawing, sign_button},
        pages::{PageContext, PageWish, progress},
        swatch,
    },
};

/// Longest side of the picture as it is drawn, pixels.
const MOST_SIDE: usize = 1024;

/// Greatest height of the picture on the page, points.
const HEIGHT: f32 = 180.0;

/// A picture on the graphics card.
pub(super) struct DrawnPhoto {
    of: Arc<Result<Photo, String>>,
    texture: TextureHandle,
}

impl DesignView {
    /// The picture that was opened; a click takes a pixel's colour.
    pub(super) fn photo(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        ui.horizontal_wrapped(|ui| {
            let words = match self.photo {
                None => said!("Picture…"),
                Some(_) => said!("Another picture…"),
            };
            let opens = ui.button(words).on_hover_text(said!(
                "Opens a picture (PNG) whose pixels can be clicked for their colours; or drop one \
                 on this page."
            ));
            if opens.clicked() {
                context.wishes.push(PageWish::OpenPicture);
            }
            let (name, meaning) = (said!("Close the picture"), said!("Takes the picture away."));
            if self.photo.is_some() && sign_button(ui, "✖", name, meaning) {
                self.photo = None;
            }
            ui.weak(said!("or right click a swatch on any page"));
        });
        let Some(path) = &self.photo else {
            self.drawn_photo = None;
            return;
        };
        let ask = PhotoAsk(path.clone());
        let job = context.put(&ask);
        progress(ui, job, said!("The picture"));
        let Some(found) = job.result_for(&ask).cloned() else {
            return;
        };
        match &*found {
            Ok(photo) => {
                let texture = self.texture(ui, &found, photo);
                clicked(ui, context, photo, texture);
            }
            Err(why) => {
                ui.weak(why);
            }
        }
    }

    fn texture(
        &mut self,
        ui: &Ui,
        found: &Arc<Result<Photo, String>>,
        photo: &Photo,
    ) -> egui::TextureId {
        let is_it = |drawn: &DrawnPhoto| Arc::ptr_eq(&drawn.of, found);
        let held = self.drawn_photo.take().filter(is_it);
        let drawn = held.unwrap_or_else(|| {
            let (size, pixels, _) = photo.drawn(MOST_SIDE);
            let image = swatch::image(size, &pixels);
            let options = TextureOptions::LINEAR;
            DrawnPhoto {
                of: found.clone(),
                texture: ui.ctx().load_texture("photo", image, options),
            }
        });
        self.drawn_photo.insert(drawn).texture.id()
    }
}

fn clicked(ui: &mut Ui, context: &mut PageContext<'_>, photo: &Photo, texture: egui::TextureId) {
    let [width, height] = photo.png.size.map(|side| side.max(1) as f32);
    let room = vec2(ui.available_width(), HEIGHT * context.theme.scale);
    let scale = (room.x / width).min(room.y / height);
    let size = vec2(width, height) * scale;
    let name = tr!("Picture {file}", file = photo.name);
    let (rect, response) = drawing(ui, size, egui::Sense::click(), &name);
    let whole = egui::Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
    ui.painter()
        .image(texture, rect, whole, egui::Color32::WHITE);
    let pointed = response.hover_pos().or(response.interact_pointer_pos());
    let at = pointed.map(|at| (at - rect.min) / rect.size());
    let Some(([x, y], rgb)) = at.and_then(|at| photo.at([at.x, at.y])) else {
        ui.small(tr!(
            "{file}: click a pixel to take its colour.",
            file = photo.name
        ));
        return;
    };
    let colour = Srgb(rgb).hex();
    ui.small(tr!(
        "Row {row}, column {column}: {colour}. Click to take it.",
        row = y,
        column = x,
        colour
    ));
    if response.clicked() {
        context.ask_about_colour(rgb);
    }
}
