//! The part "bounces" of the page "Products".

use eframe::egui::Ui;

use crate::ui::pages::PageContext;

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct BouncesView;

impl BouncesView {
    /// Draws the part.
    pub fn show(&mut self, _ui: &mut Ui, _context: &mut PageContext<'_>) {}
}
