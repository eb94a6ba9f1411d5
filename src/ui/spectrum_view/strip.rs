//! The colours of the wavelengths, exactly under the plot's axis.

use eframe::egui;
use egui::{Color32, ColorImage, Rect, TextureHandle, Ui, pos2, vec2};
use egui_plot::PlotTransform;

use super::super::theme::Theme;
use crate::{
    app::App,
    color::{Srgb, srgb_from_wavelength_over},
};

/// What a strip was made for: first and last wavelength, texels, dark ground.
type Key = (u32, u32, usize, bool);

/// Most texels of the strip: more than a screen shows, and no range is too wide for a texture.
const MOST_TEXELS: usize = 1024;

/// The strip's texture, made anew only for another range or theme.
#[derive(Default)]
pub(super) struct Strip {
    made: Option<(Key, TextureHandle)>,
}

impl Strip {
    /// The colours of the wavelengths, exactly under the plot's axis.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        app: &App,
        theme: Theme,
        transform: &PlotTransform,
        height: f32,
    ) {
        let band = app.derived().band;
        let (area, _) =
            ui.allocate_exact_size(vec2(ui.available_width(), height), egui::Sense::hover());
        let side = ui.input(|i| i.max_texture_side);
        let texels = band.points().min(MOST_TEXELS).min(side).max(2);
        let ends = (band.min_nm() as u32, band.max_nm() as u32);
        let key = (ends.0, ends.1, texels, theme.dark);
        let texture = match &self.made {
            Some((made_for, texture)) if *made_for == key => texture.clone(),
            _ => {
                let [r, g, b, _] = theme.ground.to_array();
                let step = band.length_nm() / (texels - 1) as f64;
                let pixels: Vec<Color32> = (0..texels)
                    .map(|i| {
                        let nm = band.min_nm() + step * i as f64;
                        let Srgb([r, g, b]) = srgb_from_wavelength_over(nm, Srgb([r, g, b]));
                        Color32::from_rgb(r, g, b)
                    })
                    .collect();
                let image = ColorImage::new([pixels.len(), 1], pixels);
                let texture = ui
                    .ctx()
                    .load_texture("strip", image, egui::TextureOptions::LINEAR);
                self.made = Some((key, texture.clone()));
                texture
            }
        };
        let frame = transform.frame();
        let x = |nm: f64| transform.position_from_point_x(nm);
        let (left, right) = (x(band.min_nm()), x(band.max_nm()));
        let painter = ui.painter().with_clip_rect(Rect::from_min_max(
            pos2(frame.left(), area.top()),
            pos2(frame.right(), area.bottom()),
        ));
        // Wavelengths are the middles of texels: the first and last stand on the band's ends.
        let half = 0.5 / texels as f32;
        painter.image(
            texture.id(),
            Rect::from_min_max(
                pos2(left, area.top() + 2.0),
                pos2(right, area.bottom() - 2.0),
            ),
            Rect::from_min_max(pos2(half, 0.0), pos2(1.0 - half, 1.0)),
            Color32::WHITE,
        );
    }
}
