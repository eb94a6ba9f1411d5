//! What is set by hand on the pages Prism and Rainbow.

use eframe::egui;
use egui::{Slider, Ui};

use super::{exposure, model, named_choice, names, slider, substance, together};
use crate::{
    app::dispersion::{
        APEXES_DEG, Beside, IMPACTS, INCIDENCES_DEG, RainbowMemory, SCREENS_MM, SLITS_MM,
    },
    optics::SEEN_NM,
    ui::{kit::Choice, pages::PageContext},
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
    let of = Slider::new(&mut memory.impact, IMPACTS)
        .fixed_decimals(3)
        .suffix(" radii");
    let meaning = "How far off its middle the coloured rays meet the drop; where the thin rays \
                   crowd together they make the bow.";
    slider(ui, (names::IMPACT, meaning), of);
}

/// The bench.
pub(super) fn prism(ui: &mut Ui, context: &mut PageContext<'_>) {
    let app = context.app;
    ui.horizontal_wrapped(|ui| {
        let memory = &mut context.memory.dispersion.prism;
        ui.spacing_mut().slider_width = 90.0;
        let meaning = "What the prism is made of: flint glass spreads colours twice as far as \
                       crown glass.";
        substance(ui, app, (names::GLASS, meaning), &mut memory.made_of);
        let of = Slider::new(&mut memory.apex_deg, APEXES_DEG)
            .step_by(0.5)
            .suffix("\u{b0}");
        let meaning = "The angle between the two faces that the light goes through.";
        slider(ui, (names::APEX, meaning), of);
        together(ui, names::MINIMUM, 30.0);
        ui.checkbox(&mut memory.at_minimum, names::MINIMUM)
            .on_hover_text(
                "The light meets the prism so that one wavelength is bent least, as in a \
                 spectroscope; else at an angle of your choice. Drag the drawing to turn it.",
            );
        if memory.at_minimum {
            let of = Slider::new(&mut memory.minimum_nm, SEEN_NM[0]..=SEEN_NM[1])
                .fixed_decimals(1)
                .suffix(" nm");
            slider(ui, (names::GREEN, "The wavelength that is bent least."), of);
        } else {
            let of = Slider::new(&mut memory.incidence_deg, INCIDENCES_DEG)
                .fixed_decimals(1)
                .suffix("\u{b0}");
            let meaning = "Angle between the light and the normal of the first face.";
            slider(ui, (names::INCIDENCE, meaning), of);
        }
        let of = Slider::new(&mut memory.slit_mm, SLITS_MM)
            .logarithmic(true)
            .fixed_decimals(2)
            .suffix(" mm");
        let meaning = "Width of the beam. Wide, lines run together and the middle turns white.";
        slider(ui, (names::SLIT, meaning), of);
        let of = Slider::new(&mut memory.screen_mm, SCREENS_MM)
            .logarithmic(true)
            .fixed_decimals(0)
            .suffix(" mm");
        slider(ui, (names::SCREEN, "From the prism to the screen."), of);
        exposure(ui, &mut memory.stops);
        beside(ui, &mut memory.beside);
        model::sent(ui, &mut memory.sent);
        let sent = memory.sent;
        model::knobs(ui, context, sent);
    });
}
