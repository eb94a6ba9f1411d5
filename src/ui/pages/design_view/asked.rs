//! What the page "From a colour" is asked: a colour, told in one of several ways, and its light;
//! where there is a second light, the colour under that.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::{TextEdit, Ui};

use crate::{
    app::{
        Given,
        design::{
            Telling,
            colour::{ColourSheet, UNDER, of_hex},
        },
    },
    color::Xyz,
    ui::{
        kit::{Choice, Chooser, form, lights, named, number, reflectances},
        pages::PageContext,
    },
};

/// The colour and the light that it is seen under; where there is a second light, that under it.
pub(super) fn asked(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: Option<&ColourSheet>,
    typed: &mut Option<(usize, String)>,
) {
    let before = context.pages.from_colour.clone();
    let mut given = before.given.clone();
    let scale = context.theme.scale;
    form(ui, "colour asked for", |form| {
        let meaning = said!("As a screen's colour, or by three numbers.");
        form.row((said!("Colour"), meaning), |ui, _| {
            let choice = Choice {
                name: said!("How a colour is told"),
                meaning,
                width: 60.0 * scale,
            };
            let telling = &mut context.pages.from_colour.telling;
            choice.pick(ui, telling, Telling::ALL, |way| {
                (way.title(), way.meaning())
            });
            told(ui, context, (sheet, 0), &mut given, typed);
        });
        let says = match given.surface() {
            Some(key) => &context.app.document().name_of(key),
            None => said!("a surface"),
        };
        let chooser = Chooser {
            name: said!("Surface to start from"),
            meaning: said!("A measured surface: how well would its colour alone have told it?"),
            says,
            offers: reflectances,
            width: 150.0 * scale,
        };
        let named = (said!("or that of"), chooser.meaning);
        let surface = form.row(named, |ui, _| chooser.show(ui, context.app));
        let says = &context.app.document().name_of(&before.light);
        let chooser = Chooser {
            name: said!("Light that the colour is seen under"),
            meaning: said!("Another light makes other surfaces of the same colour."),
            says,
            offers: lights,
            width: 150.0 * scale,
        };
        let named = (said!("seen under"), chooser.meaning);
        let light = form.row(named, |ui, _| chooser.show(ui, context.app));
        let asked = &mut context.pages.from_colour;
        if let Some(light) = light {
            asked.light.clone_from(&light.key);
        }
        if let Some(surface) = surface {
            given = Given::Of(surface.key.clone());
            if let Some((second, _)) = &mut asked.second {
                second.clone_from(&given);
            }
        }
        asked.given = given;
    });
    second(ui, context, sheet, typed);
}

/// The same surface's colour under a second light.
fn second(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: Option<&ColourSheet>,
    typed: &mut Option<(usize, String)>,
) {
    let before = context.pages.from_colour.clone();
    ui.horizontal_wrapped(|ui| {
        let mut is_on = before.second.is_some();
        let check = ui.checkbox(&mut is_on, said!("and under a second light"));
        check.on_hover_text(said!(
            "The same surface's colours under two lights tell more about it: six numbers."
        ));
        let second = &context.app.document().second;
        let usual = second.as_ref().map_or(UNDER[1], |entry| &entry.key);
        let key = before.second.as_ref().map_or(usual, |(_, key)| key);
        let mut chosen = (is_on && before.second.is_none()).then(|| key.to_owned());
        if is_on {
            let light = Chooser {
                name: said!("Second light"),
                meaning: said!("The light under which the second colour was seen."),
                says: &context.app.document().name_of(key),
                offers: lights,
                width: 130.0 * context.theme.scale,
            }
            .show(ui, context.app);
            chosen = light.map(|light| light.key.clone()).or(chosen);
        }
        let document = context.app.document();
        let asked = &mut context.pages.from_colour;
        match (&chosen, is_on) {
            (Some(key), _) => *asked = before.clone().with_second(sheet, key, document),
            (None, false) => *asked = before.clone().with_one(),
            (None, true) => {}
        }
    });
    let Some((mut given, key)) = context.pages.from_colour.second.clone() else {
        return;
    };
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("where it is"));
        told(ui, context, (sheet, 1), &mut given, typed);
    });
    context.pages.from_colour.second = Some((given, key));
}

/// The fields of one colour: the `index`-th of the sheet.
fn told(
    ui: &mut Ui,
    context: &PageContext<'_>,
    (sheet, index): (Option<&ColourSheet>, usize),
    given: &mut Given,
    typed: &mut Option<(usize, String)>,
) {
    let telling = context.pages.from_colour.telling;
    // Where nothing is seen, the numbers are those of black.
    let [xyz, white] = sheet
        .and_then(|sheet| sheet.seen.get(index))
        .map_or([Xyz::ZERO, Xyz::new(100.0, 100.0, 100.0)], |seen| {
            [seen.xyz, seen.white]
        });
    let now = telling.told(given, xyz, white);
    match telling.numbers() {
        Some(numbers) => {
            let mut after = now;
            for (value, told) in after.iter_mut().zip(numbers) {
                ui.label(told.title);
                let [least, most] = told.range;
                let field = drag_value(value)
                    .range(least..=most)
                    .speed(3.0 * 0.1_f64.powi(told.digits as i32))
                    .fixed_decimals(told.digits);
                let name = match index {
                    0 => told.title.to_owned(),
                    _ => tr!(
                        "{coordinate} under the second light",
                        coordinate = told.title
                    ),
                };
                number(ui, field, &name).on_hover_text(telling.meaning());
            }
            if after != now {
                *given = telling.given(after);
            }
        }
        None => {
            let rgb = now.map(|v| v as u8);
            if let Some(rgb) = picked(ui, context, rgb, index, typed) {
                *given = Given::Srgb(rgb);
            }
        }
    }
}

/// A screen's colour, picked or typed; the new one.
fn picked(
    ui: &mut Ui,
    context: &PageContext<'_>,
    now: [u8; 3],
    index: usize,
    typed: &mut Option<(usize, String)>,
) -> Option<[u8; 3]> {
    let mut rgb = now;
    let picker = ui.color_edit_button_srgb(&mut rgb);
    let name = match index {
        0 => said!("Pick a colour"),
        _ => said!("Pick a colour under the second light"),
    };
    named(&picker, egui::Role::ColorWell, name);
    picker.on_hover_text(Telling::Srgb.meaning());
    let mut found = (rgb != now).then_some(rgb);
    let [r, g, b] = now;
    let is_typed = typed.as_ref().filter(|(at, _)| *at == index);
    let mut text = is_typed.map_or_else(
        || format!("#{r:02x}{g:02x}{b:02x}"),
        |(_, text)| text.clone(),
    );
    let width = 72.0 * context.theme.scale;
    let edit = ui.add(TextEdit::singleline(&mut text).desired_width(width));
    let name = match index {
        0 => said!("Colour in hexadecimal"),
        _ => said!("Colour in hexadecimal under the second light"),
    };
    named(&edit, egui::Role::TextInput, name);
    if edit.changed() {
        found = of_hex(&text).or(found);
        *typed = Some((index, text));
    }
    if edit.lost_focus() {
        *typed = None;
    }
    edit.on_hover_text(said!("sRGB in hexadecimal, such as #c08040."));
    found
}
