//! The pages of what light meets: filters, surfaces, a second light; and products in few numbers.

pub mod absorption;
pub mod bounces;
pub mod chain;
pub mod metamers;
pub mod narrow;
pub mod resampling;
pub mod two_lights;

use eframe::egui::Ui;

use super::PageContext;
use crate::{
    app::{Command, answers::set_title, products::Products, studies::shipped_reflectances},
    languages::said,
    spectrum::Sampling,
    ui::kit::{Choice, Chooser, factors, lights},
};

/// Changes what the page has chosen from the library.
pub(super) fn change(context: &mut PageContext<'_>, change: impl FnOnce(&mut Products)) {
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
        meaning: said!(
            "The filter, glass or surface that the light is multiplied by; the parts Resampling, \
             Bounces and Same surface? share it."
        ),
        says: surface.map_or(said!("none chosen"), |entry| entry.name()),
        offers: factors,
        width: 220.0 * context.theme.scale,
    };
    let chosen = chooser.show(ui, context.app);
    if chosen.is_some() {
        change(context, |products| products.surface = chosen);
    }
}

/// Where no second light was chosen: what stands in for it, and a list to choose from.
fn second_light(ui: &mut Ui, context: &mut PageContext<'_>) {
    let document = context.app.document();
    if document.second.is_some() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("No second light is chosen:"));
        let chosen = Chooser {
            name: said(SECOND),
            meaning: said!("The light that surfaces are compared under, on every page."),
            says: document.light_beside().name(),
            offers: lights,
            width: 150.0 * context.theme.scale,
        }
        .show(ui, context.app);
        ui.label(said!("stands in for it."));
        if chosen.is_some() {
            context.commands.push(Command::Compare(chosen));
        }
    });
}

/// What the list of second lights is called.
pub const SECOND: &str = later!("Second light");

/// Where surfaces are looked for, the patch set or everything shipped; whether it is everything.
pub(super) fn among(
    ui: &mut Ui,
    context: &PageContext<'_>,
    name: &str,
    meaning: &str,
    mut everywhere: bool,
) -> bool {
    let set = set_title(&context.app.document().patch_set);
    let all = tr!(
        "all {count} shipped reflectances",
        count = shipped_reflectances()
    );
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
