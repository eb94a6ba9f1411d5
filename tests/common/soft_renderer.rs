//! Lets egui_kittest draw with the program's own CPU painter: UI pictures without a GPU.
//!
//! ```ignore
//! let mut harness = Harness::builder()
//!     .with_size([900.0, 600.0])
//!     .renderer(SoftRenderer::default())
//!     .build_ui(|ui| { .. });
//! harness.run();
//! harness.snapshot("main_window");
//! ```

use eframe::egui;
use egui_kittest::TestRenderer;
use spectral_explorer::ui::painter::Painter;

/// The painter as egui_kittest wants to see it.
#[derive(Default)]
pub(crate) struct SoftRenderer(Painter);

impl TestRenderer for SoftRenderer {
    fn handle_delta(&mut self, delta: &mut egui::TexturesDelta) {
        self.0.apply(std::mem::take(delta));
    }

    fn render(
        &mut self,
        context: &egui::Context,
        output: &egui::FullOutput,
    ) -> Result<image::RgbaImage, String> {
        let scale = context.pixels_per_point();
        let size = context.content_rect().size() * scale;
        let [width, height] = [size.x, size.y].map(|side| side.round() as usize);
        let primitives = context.tessellate(output.shapes.clone(), scale);
        let clear = egui::Color32::TRANSPARENT;
        let drawn = self.0.paint(&primitives, [width, height], scale, clear);
        let pixels = drawn.pixels.iter();
        let bytes = pixels.flat_map(|pixel| pixel.to_srgba_unmultiplied());
        image::RgbaImage::from_raw(width as u32, height as u32, bytes.collect())
            .ok_or_else(|| format!("expected {width} x {height} pixels"))
    }
}
