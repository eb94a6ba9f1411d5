//! What the gem is, how it is cut, how it is looked at, and its file.

use std::sync::Arc;

use eframe::egui;
use egui::{CollapsingHeader, Ui};

use super::{colour, names};
use crate::{
    app::{
        ByAddress,
        dispersion::{GemFile, GemFilm, GemForm, GemLook, places},
        pages::{GemMemory, LightPart, RAYS_SHOWN, SIZES_SHOWN, knob::Knob},
    },
    optics::{Brilliant, FilmSettings, Light, film_bytes},
    ui::{
        kit::{Choice, Chooser, knob, lights, pressed_if, pressed_small, seen_choice},
        pages::{
            PageContext, PageWish,
            prism_view::{exposure, model, substance},
        },
    },
};

/// How many sliders of the cut are always there.
const ALWAYS: usize = 3;

pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    film: Option<&Arc<GemFilm>>,
    both: &[Light],
) {
    ui.spacing_mut().slider_width = 84.0 * context.theme.scale;
    substance(
        ui,
        context.app,
        (
            names::MATERIAL,
            "Diamond bends light most and spreads its colours; zirconia spreads them further, \
             glass much less.",
        ),
        &mut context.pages.gem.made_of,
    );
    colour::show(ui, context);
    cut(ui, &mut context.pages.gem);
    ui.separator();
    looks(ui, context, both);
    ui.separator();
    other_light(ui, context, both.get(1));
    model::sent(ui, &mut context.pages.gem.sent);
    model::knobs(ui, context, context.pages.gem.sent);
    ui.separator();
    save(ui, context, film, &both[0]);
}

fn cut(ui: &mut Ui, gem: &mut GemMemory) {
    let sliders = |ui: &mut Ui, gem: &mut GemMemory, id: &str, [skip, take]: [usize; 2]| {
        egui::Grid::new(id).num_columns(2).show(ui, |ui| {
            let knobs = GemMemory::cut_knobs().skip(skip).take(take);
            knobs.for_each(|knob| slider(ui, gem, knob));
        });
    };
    sliders(ui, gem, "cut", [0, ALWAYS]);
    CollapsingHeader::new("More of the cut").show(ui, |ui| {
        sliders(ui, gem, "more of the cut", [ALWAYS, usize::MAX]);
        let usual = Brilliant::default();
        let button = egui::Button::new(names::USUAL_CUT).small();
        let meaning = "The round brilliant that most diamonds are cut to.";
        if pressed_if(ui, gem.cut != usual, button, meaning) {
            gem.cut = usual;
        }
    });
}

fn slider(ui: &mut Ui, gem: &mut GemMemory, of: &Knob<GemMemory>) {
    let label = ui.label(of.title).on_hover_text(of.meaning);
    let slider = knob::slider(of, gem);
    let slider = match of.unit {
        "" => slider
            .custom_formatter(|value, _| format!("{:.1} %", 100.0 * value))
            .custom_parser(|text| {
                let percent: f64 = text.trim().trim_end_matches('%').trim().parse().ok()?;
                Some(percent / 100.0)
            }),
        _ => slider.step_by(0.05),
    };
    ui.add(slider)
        .labelled_by(label.id)
        .on_hover_text(of.meaning);
    ui.end_row();
}

fn looks(ui: &mut Ui, context: &mut PageContext<'_>, both: &[Light]) {
    let (app, wide) = (context.app, 225.0 * context.theme.scale);
    seen_choice(ui, app, (names::SEEN, wide), context.commands);
    let memory = &mut context.pages.gem;
    ui.horizontal(|ui| {
        ui.label(names::PART);
        let choice = Choice {
            name: names::PART,
            meaning: "The lines' picture and the smooth part's, each as bright as it is in the \
                      whole: together they are the whole.",
            width: 150.0,
        };
        choice.pick(ui, &mut memory.part, LightPart::ALL, |p| (p.title(), ""));
    });
    exposure(ui, &mut memory.stops);
    ui.horizontal(|ui| {
        ui.label(names::SIZE);
        let choice = Choice {
            name: names::SIZE,
            meaning: "Columns and rows of the picture, and the memory that its film takes.",
            width: 60.0,
        };
        let planes = FilmSettings::default().strata + both.iter().flat_map(places).count();
        choice.show(ui, format!("{} px", memory.size), |ui| {
            for size in SIZES_SHOWN {
                let megabytes = film_bytes(size, planes).div_ceil(1 << 20);
                let words = format!("{size} px, {megabytes} MB");
                ui.selectable_value(&mut memory.size, size, words);
            }
        });
        ui.label("rays");
        let choice = Choice {
            name: names::RAYS,
            meaning: "Rays a pixel: twice as many take twice the time and leave 0.7 of the noise.",
            width: 50.0,
        };
        choice.show(ui, memory.rays.to_string(), |ui| {
            for rays in RAYS_SHOWN {
                ui.selectable_value(&mut memory.rays, rays, rays.to_string());
            }
        });
    });
    let meaning = "Looks at the gem as at first: down on the crown.";
    if pressed_small(ui, names::FRONT, meaning) {
        memory.look_from_front();
    }
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
fn other_light(ui: &mut Ui, context: &mut PageContext<'_>, other: Option<&Light>) {
    ui.horizontal(|ui| {
        ui.label(names::UNDER);
        let chooser = Chooser {
            name: names::UNDER,
            meaning: "A second light on the same gem: its picture is summed from the same rays, \
                      only its lines are traced.",
            says: other.map_or("choose a light", |light| light.name.as_str()),
            offers: lights,
            width: 110.0,
        };
        if let Some(entry) = chooser.show(ui, context.app) {
            context.pages.gem.under = Some(entry.key.clone());
        }
        let button = egui::Button::new(names::NO_OTHER).small();
        let meaning = "One large picture under the document's light alone.";
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
            names::PNG,
            "The picture under the document's light as it is shown.",
        ),
        (
            GemForm::Exr,
            names::EXR,
            "The spectral picture under the document's light: every plane of wavelengths and \
             every line.",
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
