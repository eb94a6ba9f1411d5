//! What colours the gem.

use crate::ui::kit::slide;

use super::names;
use crate::{
    app::pages::{GemColour, GemMemory},
    languages::said,
    ui::{
        kit::{Choice, Chooser, Form, transmittances},
        pages::PageContext,
    },
};

/// Draws the choice and what belongs to the kind chosen.
pub(super) fn show(form: &mut Form<'_>, context: &mut PageContext<'_>) {
    let app = context.app;
    let memory = &mut context.pages.gem;
    let choice = Choice {
        name: said(names::COLOUR),
        meaning: said!(
            "The light that the gem takes out on its way, which goes to and fro in it many times."
        ),
        width: 130.0,
    };
    form.choice(choice, memory.colour.title(), |ui| {
        for colour in GemColour::ALL {
            ui.selectable_value(&mut memory.colour, colour, colour.title());
        }
    });
    match memory.colour {
        GemColour::Clear => {}
        GemColour::Grey => {
            let of = slide(&mut memory.grey, GemMemory::GREY.reach.range()).fixed_decimals(2);
            let meaning =
                said!("Absorption for each radius of the girdle: 1 leaves 37 % of the light.");
            form.slider((said(names::ABSORBS), meaning), of);
        }
        GemColour::Filter => {
            let entry = app.entry(&memory.filter);
            let chooser = Chooser {
                name: said(names::FILTER),
                meaning: said!("The gem takes away what this glass takes away."),
                says: entry
                    .as_ref()
                    .map_or(said!("choose a filter"), |entry| entry.name()),
                offers: transmittances,
                width: 150.0,
            };
            let chosen = form.row((said(names::FILTER), chooser.meaning), |ui, _| {
                chooser.show(ui, app)
            });
            if let Some(entry) = chosen {
                memory.filter.clone_from(&entry.key);
            }
            let of = slide(&mut memory.thickness, GemMemory::THICKNESS.reach.range())
                .logarithmic(true)
                .fixed_decimals(1)
                .suffix(format!(" {}", said!("radii")));
            let meaning = said!(
                "How large the gem is against the filter: the filter's transmittance is that of so \
                 many radii of the gem. Less makes it darker."
            );
            form.slider((said(names::THICKNESS), meaning), of);
        }
    }
}
