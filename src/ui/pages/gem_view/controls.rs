//! What the gem is, how it is cut, how it is looked at, and its file.

use std::sync::Arc;

use eframe::egui;
use egui::Ui;

use super::{colour, names};
use crate::{
    app::{
        ByAddress,
        dispersion::{GemFile, GemFilm, GemForm, GemLook, places},
        pages::{GemMemory, LightPart, RAYS_SHOWN, SIZES_SHOWN, knob::Knob},
    },
    languages::said,
    optics::{Brilliant, FilmSettings, Light, film_bytes},
    ui::{
        kit::{
            Choice, Chooser, Form, GROUP, fold, form, knob, lights, pressed_if, pressed_small,
            seen_choice,
        },
        pages::{
            PageContext, PageWish,
            prism_view::{exposure, model, substance},
        },
    },
};

/// How many sliders of the cut are always there.
const ALWAYS: usize = 2;

pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    film: Option<&Arc<GemFilm>>,
    both: &[Light],
) {
    ui.spacing_mut().slider_width = 100.0 * context.theme.scale;
    let app = context.app;
    form(ui, "gem", |form| {
        let meaning = said!(
            "Diamond bends light most and spreads its colours; zirconia spreads them further, \
             glass much less."
        );
        let made_of = &mut context.pages.gem.made_of;
        substance(form, app, (said(names::MATERIAL), meaning), made_of);
        other_light(form, context, both.get(1));
        for of in GemMemory::cut_knobs().take(ALWAYS) {
            slider(form, &mut context.pages.gem, of);
        }
    });
    ui.add_space(GROUP);
    let meaning = said!("Looks at the gem as at first: down on the crown.");
    form(ui, "how the gem is seen", |form| {
        looks(form, context);
        if form.rest(|ui| pressed_small(ui, said(names::FRONT), meaning)) {
            context.pages.gem.look_from_front();
        }
    });
    ui.add_space(GROUP);
    form(ui, "gem's light", |form| {
        model::sent(form, &mut context.pages.gem.sent);
        model::knobs(form, context, context.pages.gem.sent);
    });
    ui.add_space(GROUP);
    let memory = &mut context.pages.gem;
    fold(ui, "more of the cut", said!("More of the cut"), |ui| {
        rest_of_cut(ui, memory);
    });
    fold(ui, "more of the gem", said!("Colour and picture"), |ui| {
        form(ui, "more of the gem", |form| {
            colour::show(form, context);
            picture(form, context, both);
        });
        save(ui, context, film, &both[0]);
    });
}

/// What of the cut changes the picture less.
fn rest_of_cut(ui: &mut Ui, gem: &mut GemMemory) {
    form(ui, "more of the cut", |form| {
        for of in GemMemory::cut_knobs().skip(ALWAYS) {
            slider(form, gem, of);
        }
    });
    let usual = Brilliant::default();
    let button = egui::Button::new(said(names::USUAL_CUT)).small();
    let meaning = said!("The round brilliant that most diamonds are cut to.");
    if pressed_if(ui, gem.cut != usual, button, meaning) {
        gem.cut = usual;
    }
}

fn slider(form: &mut Form<'_>, gem: &mut GemMemory, of: &Knob<GemMemory>) {
    let slider = knob::slider(of, gem);
    let slider = if of.unit.is_empty() {
        slider
            .custom_formatter(|value, _| format!("{:.0} %", 100.0 * value))
            .custom_parser(|text| {
                let percent: f64 = text.trim().trim_end_matches('%').trim().parse().ok()?;
                Some(percent / 100.0)
            })
    } else {
        slider.step_by(0.05).fixed_decimals(1)
    };
    form.slider((said(of.title), said(of.meaning)), slider);
}

/// To whom the gem is shown, how bright and under which part of the light.
fn looks(form: &mut Form<'_>, context: &mut PageContext<'_>) {
    let (app, wide) = (context.app, 190.0 * context.theme.scale);
    form.row((said!("Seen"), ""), |ui, _| {
        seen_choice(ui, app, (said(names::SEEN), wide), context.commands);
    });
    let memory = &mut context.pages.gem;
    let choice = Choice {
        name: said(names::PART),
        meaning: said!(
            "The lines' picture and the smooth part's, each as bright as it is in the whole: \
             together they are the whole."
        ),
        width: 150.0,
    };
    form.choice(choice, memory.part.title(), |ui| {
        for part in LightPart::ALL {
            ui.selectable_value(&mut memory.part, part, part.title());
        }
    });
    exposure(form, &mut memory.stops);
}

/// How fine the picture is.
fn picture(form: &mut Form<'_>, context: &mut PageContext<'_>, both: &[Light]) {
    let memory = &mut context.pages.gem;
    let choice = Choice {
        name: said(names::SIZE),
        meaning: said!("Columns and rows of the picture, and the memory that its film takes."),
        width: 60.0,
    };
    let planes = FilmSettings::default().strata + both.iter().flat_map(places).count();
    form.choice(choice, &format!("{} px", memory.size), |ui| {
        for size in SIZES_SHOWN {
            let megabytes = film_bytes(size, planes).div_ceil(1 << 20);
            let words = format!("{size} px, {megabytes} MB");
            ui.selectable_value(&mut memory.size, size, words);
        }
    });
    let choice = Choice {
        name: said(names::RAYS),
        meaning: said!(
            "Rays a pixel: twice as many take twice the time and leave 0.7 of the noise."
        ),
        width: 50.0,
    };
    form.choice(choice, &memory.rays.to_string(), |ui| {
        for rays in RAYS_SHOWN {
            ui.selectable_value(&mut memory.rays, rays, rays.to_string());
        }
    });
}

/// How the pictures are looked at.
pub(super) fn look(context: &PageContext<'_>) -> GemLook {
    let (document, memory) = (context.app.document(), &context.pages.gem);
    GemLook {
        observer: document.settings.observer,
        stops: memory.stops,
        adaptation: document.view.adaptation(),
        part: memory.part,
    }
}

/// The light of the second picture.
fn other_light(form: &mut Form<'_>, context: &mut PageContext<'_>, other: Option<&Light>) {
    let meaning = said!(
        "A second light on the same gem: its picture is summed from the same rays, only its lines \
         are traced."
    );
    form.row((said(names::UNDER), meaning), |ui, _| {
        let chooser = Chooser {
            name: said(names::UNDER),
            meaning,
            says: other.map_or(said!("choose a light"), |light| light.name.as_str()),
            offers: lights,
            width: 100.0,
        };
        if let Some(entry) = chooser.show(ui, context.app) {
            context.pages.gem.under = Some(entry.key.clone());
        }
        let button = egui::Button::new(said(names::NO_OTHER)).small();
        let meaning = said!("One large picture under the document's light alone.");
        if pressed_if(ui, other.is_some(), button, meaning) {
            context.pages.gem.under = None;
        }
    });
}

/// The buttons that save the first picture.
fn save(ui: &mut Ui, context: &mut PageContext<'_>, film: Option<&Arc<GemFilm>>, light: &Light) {
    let forms = [
        (
            GemForm::Png,
            said(names::PNG),
            said!("The picture under the document's light as it is shown."),
        ),
        (
            GemForm::Exr,
            said(names::EXR),
            said!(
                "The spectral picture under the document's light: every plane of wavelengths and \
                 every line."
            ),
        ),
    ];
    ui.horizontal_wrapped(|ui| {
        for (form, words, meaning) in forms {
            let button = ui.add_enabled(film.is_some(), egui::Button::new(words).small());
            if let Some(film) = film.filter(|_| button.clicked()) {
                let gem = GemFile {
                    film: ByAddress(film.clone()),
                    light: light.clone(),
                    look: look(context),
                    form,
                };
                context.wishes.push(PageWish::Gem(gem));
            }
            button.on_hover_text(meaning);
        }
    });
}
