//! What colours the gem.

use eframe::egui;
use egui::Ui;

use super::names;
use crate::{
    app::pages::{GemColour, GemMemory},
    ui::{
        kit::{Choice, Chooser, knob, transmittances},
        pages::{PageContext, prism_view::slider},
    },
};

/// Draws the choice and what belongs to the kind chosen.
pub(super) fn show(ui: &mut Ui, context: &mut PageContext<'_>) {
    let app = context.app;
    let memory = &mut context.pages.gem;
    ui.horizontal(|ui| {
        ui.label(names::COLOUR);
        let choice = Choice {
            name: names::COLOUR,
            meaning: "What the gem takes out of the light on its way, which goes to and fro in it \
                      many times.",
            width: 130.0,
        };
        choice.pick(ui, &mut memory.colour, GemColour::ALL, |c| (c.title(), ""));
    });
    match memory.colour {
        GemColour::Clear => {}
        GemColour::Grey => {
            let of = knob::slider(&GemMemory::GREY, memory);
            let meaning = "Absorption for each radius of the girdle: 1 leaves 37 % of the light.";
            slider(ui, (names::ABSORBS, meaning), of);
        }
        GemColour::Filter => {
            ui.horizontal(|ui| {
                ui.label(names::FILTER);
                let entry = app.entry(&memory.filter);
                let chooser = Chooser {
                    name: names::FILTER,
                    meaning: "The gem takes away what this glass takes away.",
                    says: entry
                        .as_ref()
                        .map_or("choose a filter", |entry| entry.name()),
                    offers: transmittances,
                    width: 170.0,
                };
                if let Some(entry) = chooser.show(ui, app) {
                    memory.filter.clone_from(&entry.key);
                }
            });
            let of = knob::slider(&GemMemory::THICKNESS, memory).logarithmic(true);
            let meaning = "How large the gem is against the filter: the filter's transmittance is \
                           that of so many radii of the gem. Less makes it darker.";
            slider(ui, (names::THICKNESS, meaning), of);
        }
    }
}
