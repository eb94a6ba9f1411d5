//! What is set by hand on the pages Prism and Rainbow.

use eframe::egui;
use egui::Ui;

use super::{exposure, model, named_choice, names, slider, substance, together};
use crate::{
    app::pages::{Beside, PrismMemory, RainbowMemory, knob::Knob},
    ui::{
        kit::{Choice, knob},
        pages::PageContext,
    },
};

/// The light of the second strip.
pub(super) fn beside(ui: &mut Ui, chosen: &mut Beside) {
    let choice = Choice {
        name: names::BESIDE,
        meaning: "A second light in the same place: what is missing in this one is seen.",
        width: 150.0,
    };
    named_choice(ui, choice, chosen.title(), |ui| {
        for one in Beside::ALL {
            ui.selectable_value(chosen, one, one.title());
        }
    });
}

/// Which rays are drawn in the drop.
pub(super) fn drop(ui: &mut Ui, memory: &mut RainbowMemory) {
    let choice = Choice {
        name: names::BOW,
        meaning: "After one reflection inside the drop rays make the first bow, after two the \
                  second.",
        width: 110.0,
    };
    let title = |twice: bool| {
        if twice {
            "the second bow"
        } else {
            "the first bow"
        }
    };
    named_choice(ui, choice, title(memory.twice), |ui| {
        for twice in [false, true] {
            let is_now = memory.twice == twice;
            if ui.selectable_label(is_now, title(twice)).clicked() && !is_now {
                memory.look_at(twice);
            }
        }
    });
    let knob = &RainbowMemory::IMPACT;
    slider(ui, (knob.title, knob.meaning), knob::slider(knob, memory));
}

/// The bench.
pub(super) fn prism(ui: &mut Ui, context: &mut PageContext<'_>) {
    let app = context.app;
    ui.horizontal_wrapped(|ui| {
        let memory = &mut context.pages.prism;
        ui.spacing_mut().slider_width = 90.0;
        let meaning = "What the prism is made of: flint glass spreads colours twice as far as \
                       crown glass.";
        substance(ui, app, (names::GLASS, meaning), &mut memory.made_of);
        let show = |ui: &mut Ui, knob: &Knob<PrismMemory>, memory: &mut PrismMemory| {
            slider(ui, (knob.title, knob.meaning), knob::slider(knob, memory));
        };
        let long = |ui: &mut Ui, knob: &Knob<PrismMemory>, memory: &mut PrismMemory| {
            let of = knob::slider(knob, memory).logarithmic(true);
            slider(ui, (knob.title, knob.meaning), of);
        };
        show(ui, &PrismMemory::APEX, memory);
        together(ui, names::MINIMUM, 30.0);
        ui.checkbox(&mut memory.at_minimum, names::MINIMUM)
            .on_hover_text(
                "The light meets the prism so that one wavelength is bent least, as one sets a \
                 spectroscope; else at an angle of your choice. Drag the drawing to turn it.",
            );
        if memory.at_minimum {
            show(ui, &PrismMemory::MINIMUM, memory);
        } else {
            show(ui, &PrismMemory::INCIDENCE, memory);
        }
        long(ui, &PrismMemory::SLIT, memory);
        long(ui, &PrismMemory::SCREEN, memory);
        exposure(ui, &mut memory.stops);
        beside(ui, &mut memory.beside);
        model::sent(ui, &mut memory.sent);
        let sent = memory.sent;
        model::knobs(ui, context, sent);
    });
}
