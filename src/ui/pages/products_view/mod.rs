//! The page "Products": light through filters and off surfaces, a part a file.

pub mod absorption;
pub mod bounces;
pub mod chain;
pub mod check;
pub mod forming;
pub mod lights;
pub mod narrow;
pub mod picker;

use eframe::egui::Ui;

use super::PageContext;
use crate::app::products::Part;

/// The page and what its parts keep from frame to frame.
#[derive(Default)]
pub struct ProductsView {
    chain: chain::ChainView,
    forming: forming::FormingView,
    bounces: bounces::BouncesView,
    narrow: narrow::NarrowView,
    lights: lights::LightsView,
    check: check::CheckView,
    absorption: absorption::AbsorptionView,
}

impl ProductsView {
    /// Draws the part in force below the row of parts.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        ui.horizontal_wrapped(|ui| {
            for part in Part::ALL {
                ui.selectable_value(&mut context.memory.products.part, part, part.title())
                    .on_hover_text(part.meaning());
            }
        });
        match context.memory.products.part {
            Part::Chain => self.chain.show(ui, context),
            Part::Forming => self.forming.show(ui, context),
            Part::Bounces => self.bounces.show(ui, context),
            Part::Narrow => self.narrow.show(ui, context),
            Part::Lights => self.lights.show(ui, context),
            Part::Check => self.check.show(ui, context),
            Part::Absorption => self.absorption.show(ui, context),
        }
    }
}
