//! The part "Two lights": the same surfaces under the light and the second light, those that change
//! most first.

use eframe::egui;
use egui::{RichText, Ui, Vec2, vec2};

use super::second_light;
use crate::{
    app::{Lit, Memo, headlines, verdicts::Seen},
    languages::{fixed, said},
    ui::{
        kit::{Choice, adapt_box, bounded, copy_button, headline, scrolled},
        lit_field::{self, Field},
        pages::PageContext,
        patches_view::set_choice,
    },
};

/// What buttons and lists are called.
pub mod names {
    pub const SET: &str = later!("Surface set");
    pub const COPY: &str = later!("Copy the surfaces as CSV");
}

/// Widest a surface stands, and the least, points.
const WIDTH: [f32; 2] = [250.0, 96.0];
/// Height of a surface's colours: least and largest, points.
const COLOURS: [f32; 2] = [44.0, 300.0];

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct TwoLightsView {
    lit: Memo<u64, Option<Vec<Lit>>>,
}

impl TwoLightsView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, theme) = (context.app, context.theme);
        let document = app.document();
        let second = document.light_beside();
        let lights = [document.light.name(), second.name()];
        let lit = &*self.lit.get(app.revision(), |_| {
            let mut lit = Lit::beside(document, &second)?;
            lit.sort_by(|a, b| b.delta_e_2000.total_cmp(&a.delta_e_2000));
            Some(lit)
        });
        headline(ui, theme, headlines::two_lights(lights, lit.as_deref()));
        second_light(ui, context);
        ui.horizontal_wrapped(|ui| {
            let choice = Choice {
                name: said(names::SET),
                meaning: said!("The surfaces that are seen under both lights."),
                width: 128.0 * theme.scale,
            };
            set_choice(ui, choice, app, context.commands);
            let meaning = said!(
                "Shows each half as an eye used to its light sees it (Bradford). It changes the \
                 colours on screen, not the figures."
            );
            adapt_box(ui, app, (said!("Adapt"), meaning), context.commands);
            let shown = lit.as_deref().unwrap_or_default();
            copy_button(ui, said(names::COPY), "", || Lit::csv(lights, shown));
            let [first, second] = lights;
            let words = tr!(
                "left {first}, right {second}; below the change ΔE₀₀, the largest first",
                first,
                second
            );
            ui.label(RichText::new(words).small().color(theme.faint));
        });
        ui.add_space(4.0);
        let lit = lit.as_deref().unwrap_or_default();
        let room = ui.available_size();
        let fits = |width: f32| ((room.x + lit_field::GAP) / (width + lit_field::GAP)) as usize;
        let [most, least] = WIDTH.map(|width| fits(width * theme.scale));
        // Rows of the same length where they have room.
        let in_row = [8, 6, 12, 4, 3, 2];
        let in_row = in_row.into_iter().find(|n| (most..=least).contains(n));
        let in_row = in_row.unwrap_or(least.max(1));
        let width = lit_field::width(room.x - 10.0, in_row);
        let rows = lit.len().div_ceil(in_row).max(1) as f32;
        let words = lit_field::size(ui, width, 0.0).y;
        let each = room.y / rows - words - lit_field::GAP;
        let colours = bounded(each, COLOURS[0], COLOURS[1] * theme.scale);
        let size = lit_field::size(ui, width, colours);
        scrolled(ui, "two lights", |ui| {
            ui.spacing_mut().item_spacing = Vec2::splat(lit_field::GAP);
            for row in lit.chunks(in_row) {
                ui.horizontal(|ui| {
                    for lit in row {
                        field(lit, lights).show(ui, size, theme);
                    }
                });
            }
            ui.allocate_space(vec2(1.0, 1.0));
        });
    }
}

fn field<'a>(lit: &'a Lit, [first, second]: [&str; 2]) -> Field<'a> {
    let Lit {
        name, delta_e_2000, ..
    } = lit;
    let seen = Seen::of(*delta_e_2000).seen();
    Field {
        lit: vec![lit],
        said: tr!(
            "{name}: from {first} to {second} ΔE₀₀ {difference}, {seen}",
            name,
            first,
            second,
            difference = fixed(delta_e_2000, 1),
            seen
        ),
        lights_up: false,
        source: "",
    }
}
