//! The page "Truth".

use eframe::egui;
use egui::Ui;

use super::PageContext;

/// The page and what it keeps from frame to frame.
#[derive(Default)]
pub struct TruthView;

impl TruthView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let _ = (ui, context);
    }
}
