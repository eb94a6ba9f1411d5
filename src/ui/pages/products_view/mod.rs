//! The page "Products": light through filters and off surfaces, a part a file.

pub mod absorption;
pub mod bounces;
pub mod chain;
pub mod narrow;
pub mod resampling;
pub mod same_surface;
pub mod two_lights;

use eframe::egui::Ui;

use super::PageContext;
use crate::{
    app::{
        Command,
        products::{Part, Products},
        studies::surfaces::shipped_reflectances,
    },
    spectrum::Sampling,
    ui::{
        kit::{Choice, Chooser, factors},
        patches_view::set_title,
    },
};

/// The page and what its parts keep from frame to frame.
#[derive(Default)]
pub struct ProductsView {
    chain: chain::ChainView,
    resampling: resampling::ResamplingView,
    bounces: bounces::BouncesView,
    narrow: narrow::NarrowView,
    two_lights: two_lights::TwoLightsView,
    same_surface: same_surface::SameSurfaceView,
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
            Part::Resampling => self.resampling.show(ui, context),
            Part::Bounces => self.bounces.show(ui, context),
            Part::Narrow => self.narrow.show(ui, context),
            Part::TwoLights => self.two_lights.show(ui, context),
            Part::SameSurface => self.same_surface.show(ui, context),
            Part::Absorption => self.absorption.show(ui, context),
        }
    }
}

/// Changes what the page has chosen from the library.
fn change(context: &mut PageContext<'_>, change: impl FnOnce(&mut Products)) {
    let mut products = context.app.document().products.clone();
    change(&mut products);
    context.commands.push(Command::Products(products));
}

/// Takes a way of forming products as the document's.
fn take_way(context: &mut PageContext<'_>, sampling: Sampling) {
    let mut settings = context.app.document().settings;
    settings.sampling = sampling;
    context.commands.push(Command::Edit(settings));
}

/// A list that changes the document's surface.
fn surface_chooser(ui: &mut Ui, context: &mut PageContext<'_>, name: &'static str) {
    let surface = context.app.document().products.surface.as_ref();
    ui.label(name);
    let chooser = Chooser {
        name,
        meaning: "The filter, glass or surface that the light is multiplied by; the parts \
                  Resampling, Bounces and Same surface? share it.",
        says: surface.map_or("none chosen", |entry| entry.name()),
        offers: factors,
        width: 220.0 * context.theme.scale,
    };
    let chosen = chooser.show(ui, context.app);
    if chosen.is_some() {
        change(context, |products| products.surface = chosen);
    }
}

/// Where surfaces are looked for, the patch set or everything shipped; whether it is everything.
fn among(
    ui: &mut Ui,
    context: &PageContext<'_>,
    name: &str,
    meaning: &str,
    mut everywhere: bool,
) -> bool {
    let set = set_title(&context.app.document().patch_set);
    let all = format!("all {} shipped reflectances", shipped_reflectances());
    let choice = Choice {
        name,
        meaning,
        width: 190.0 * context.theme.scale,
    };
    choice.show(ui, if everywhere { &all } else { &set }, |ui| {
        ui.selectable_value(&mut everywhere, false, &set);
        ui.selectable_value(&mut everywhere, true, &all);
    });
    everywhere
}
