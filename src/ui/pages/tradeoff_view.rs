//! The page "Tradeoff".

use eframe::egui;
use egui::Ui;

use super::PageContext;

/// The page and what it keeps from frame to frame.
#[derive(Default)]
pub struct TradeoffView;

impl TradeoffView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let _ = (ui, context);
    }
}
