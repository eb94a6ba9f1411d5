//! What a body is made of: the program's materials, curves of n that were opened, two numbers.

use crate::ui::kit::slide;
use eframe::egui;
use egui::Ui;

use crate::{
    app::{
        App,
        dispersion::{ABBES, INDICES, Substance, own_indices},
    },
    optics::BuiltinMaterial,
    ui::kit::{Choice, Form},
};

/// What people and tests call the two numbers.
pub(super) mod names {
    pub(crate) const INDEX: &str = "n";
    pub(crate) const ABBE: &str = "V";
}

/// Draws the choice by its name and what it is for, and two numbers where they are chosen.
pub(crate) fn substance(
    form: &mut Form<'_>,
    app: &App,
    (name, meaning): (&str, &str),
    made_of: &mut Substance,
) {
    let choice = Choice {
        name,
        meaning,
        width: 150.0,
    };
    let now = made_of.title(app);
    let list = |ui: &mut Ui| {
        let shipped = BuiltinMaterial::ALL.map(Substance::Shipped);
        let own = own_indices(app).map(|entry| Substance::Own {
            index: entry.key.clone(),
        });
        for one in shipped.into_iter().chain(own) {
            let title = one.title(app);
            ui.selectable_value(made_of, one, title);
        }
        let is_numbers = matches!(made_of, Substance::Numbers { .. });
        let numbers = ui.selectable_label(is_numbers, Substance::NUMBERS.title(app));
        if numbers.clicked() && !is_numbers {
            *made_of = Substance::NUMBERS;
        }
        ui.weak(said!(
            "Files of refractiveindex.info that you open join the list."
        ));
    };
    form.choice(choice, &now, list);
    if let Substance::Numbers { n_d, v_d } = made_of {
        let of = slide(n_d, INDICES.range()).fixed_decimals(4);
        let meaning = said!("Index of refraction at the yellow line d, 587.6 nm.");
        form.slider((names::INDEX, meaning), of);
        let of = slide(v_d, ABBES.range()).fixed_decimals(1);
        let meaning = said!("Abbe number: the smaller, the further the colours are spread.");
        form.slider((names::ABBE, meaning), of);
    }
}
