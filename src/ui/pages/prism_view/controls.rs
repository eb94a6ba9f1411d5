//! What is set by hand on the pages Prism and Rainbow.

use crate::ui::kit::slide;
use eframe::egui;
use egui::Ui;

use super::{exposure, model, names, substance};
use crate::{
    app::pages::{Beside, PrismMemory, RainbowMemory},
    languages::said,
    optics::SEEN_NM,
    ui::{
        kit::{Choice, Form, GROUP, fold, form},
        pages::PageContext,
    },
};

/// The light of the second strip.
pub(super) fn beside(form: &mut Form<'_>, chosen: &mut Beside) {
    let choice = Choice {
        name: said(names::BESIDE),
        meaning: said!("A second light in the same place: what is missing in this one is seen."),
        width: 150.0,
    };
    form.choice(choice, chosen.title(), |ui| {
        for one in Beside::ALL {
            ui.selectable_value(chosen, one, one.title());
        }
    });
}

/// Which rays are drawn in the drop.
pub(super) fn drop(form: &mut Form<'_>, memory: &mut RainbowMemory) {
    let choice = Choice {
        name: said(names::BOW),
        meaning: said!(
            "After one reflection inside the drop rays make the first bow, after two the second."
        ),
        width: 110.0,
    };
    let title = |twice: bool| {
        if twice {
            said!("the second bow")
        } else {
            said!("the first bow")
        }
    };
    form.choice(choice, title(memory.twice), |ui| {
        for twice in [false, true] {
            let is_now = memory.twice == twice;
            if ui.selectable_label(is_now, title(twice)).clicked() && !is_now {
                memory.look_at(twice);
            }
        }
    });
    let of = slide(&mut memory.impact, RainbowMemory::IMPACT.reach.range())
        .fixed_decimals(2)
        .suffix(format!(" {}", said!("radii")));
    let meaning = said!(
        "How far off its middle the coloured rays meet the drop; where the thin rays crowd \
         together they make the bow."
    );
    form.slider((said(names::IMPACT), meaning), of);
}

/// The bench: what a class plays with, and the rest on demand.
pub(super) fn prism(ui: &mut Ui, context: &mut PageContext<'_>) {
    let app = context.app;
    form(ui, "prism", |form| {
        let memory = &mut context.pages.prism;
        let meaning = said!(
            "The material of the prism: flint glass spreads colours twice as far as crown glass."
        );
        substance(
            form,
            app,
            (said(names::GLASS), meaning),
            &mut memory.made_of,
        );
        let of = slide(&mut memory.apex_deg, PrismMemory::APEX.reach.range())
            .step_by(0.5)
            .suffix("\u{b0}");
        let meaning = said!("The angle between the two faces that the light goes through.");
        form.slider((said(names::APEX), meaning), of);
        let of = slide(&mut memory.slit_mm, PrismMemory::SLIT.reach.range())
            .logarithmic(true)
            .fixed_decimals(2)
            .suffix(" mm");
        let meaning =
            said!("Width of the beam. Wide, lines run together and the middle turns white.");
        form.slider((said(names::SLIT), meaning), of);
        beside(form, &mut memory.beside);
    });
    ui.add_space(GROUP);
    form(ui, "prism's light", |form| {
        model::sent(form, &mut context.pages.prism.sent);
        let sent = context.pages.prism.sent;
        model::knobs(form, context, sent);
    });
    ui.add_space(GROUP);
    fold(ui, "bench", said!("Bench"), |ui| bench(ui, context));
}

/// How the prism stands, how far the screen is, how bright it is shown.
fn bench(ui: &mut Ui, context: &mut PageContext<'_>) {
    let memory = &mut context.pages.prism;
    form(ui, "bench", |form| {
        form.rest(|ui| {
            ui.checkbox(&mut memory.at_minimum, said(names::MINIMUM))
                .on_hover_text(said!(
                    "The light meets the prism so that one wavelength passes at minimum deviation, as \
                     one sets a spectroscope; else at an angle of your choice. Drag the drawing to turn it."
                ))
        });
        if memory.at_minimum {
            let of = slide(&mut memory.minimum_nm, SEEN_NM[0]..=SEEN_NM[1])
                .fixed_decimals(0)
                .suffix(" nm");
            form.slider(
                (
                    said(names::GREEN),
                    said!("The wavelength that passes at minimum deviation."),
                ),
                of,
            );
        } else {
            let of = slide(
                &mut memory.incidence_deg,
                PrismMemory::INCIDENCE.reach.range(),
            )
            .fixed_decimals(1)
            .suffix("\u{b0}");
            let meaning = said!("Angle between the light and the normal of the first face.");
            form.slider((said(names::INCIDENCE), meaning), of);
        }
        let of = slide(&mut memory.screen_mm, PrismMemory::SCREEN.reach.range())
            .logarithmic(true)
            .fixed_decimals(0)
            .suffix(" mm");
        form.slider(
            (said(names::SCREEN), said!("From the prism to the screen.")),
            of,
        );
        exposure(form, &mut memory.stops);
    });
}
