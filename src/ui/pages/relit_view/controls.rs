//! Which picture, what lit it, what shines on it now, how many numbers, and saving.

use crate::ui::kit::{drag_value, slide};
use eframe::egui;
use egui::{Button, RichText, TextWrapMode, Ui, containers::menu::MenuButton};

use crate::{
    app::{
        App, ByAddress,
        pages::{Look, RelitMemory},
        picture::shown,
        relit::{Fit, Form, LookAsk, Looked, PictureWish, RelitShown, fewer},
    },
    languages::said,
    ui::{
        kit::{Choice, Chooser, adapt_box, lights, named, number, pressed_small},
        pages::PageContext,
    },
};

/// What people and tests call the controls.
pub mod names {
    pub const PICTURE: &str = later!("Picture in few numbers");
    pub const OWN: &str = later!("Own light");
    pub const BOUND: &str = later!("Within");
    pub const TAKEN: &str = later!("Photographed under");
    pub const LIGHT: &str = later!("Shown under");
    pub const SECOND: &str = later!("Second light");
    pub const SHARE: &str = later!("Share of the second light");
    pub const NUMBERS: &str = later!("Numbers a pixel");
    pub const ENOUGH: &str = later!("As few as needed");
    pub const SAVE: &str = later!("Save…");
    pub const WORST: &str = later!("Worst pixel");
    pub const KEPT: &str = later!("Numbers kept of a pixel");
    pub const WEIGHTED: &str = later!("Weighed by colours under many lights");
    pub const LEAVE: &str = later!("Let reference and lines be chosen");
    pub const BETWEEN: &str = later!("The series between bands");
    pub const HAND: &str = later!("By hand");
    pub const NEXT_LINE: &str = later!("Place of a line");
    pub const ADD_LINE: &str = later!("Add line");
}

/// Lights at hand: title and key.
const AT_HAND: [(&str, &str); 5] = [
    (later!("Daylight"), "cie_illuminants/CIE D65"),
    (later!("Bulb"), "cie_illuminants/CIE A"),
    (later!("Tube"), "cie_fluorescent_1nm/FL11"),
    (later!("Mercury"), "lamps_nist_traditional/Mercury"),
    (later!("Sodium"), "lamps_nist_traditional/LPS"),
];

/// Width of lists, points.
const LIST: f32 = 120.0;

fn name_of(app: &App, key: Option<&str>, otherwise: &str) -> String {
    let entry = key.and_then(|key| app.entry(key));
    entry.map_or_else(|| otherwise.to_owned(), |entry| entry.name().to_owned())
}

/// A light of the library in `key`, or what is said `otherwise`, by a list of a name, a meaning and
/// a width.
fn choose_light(
    ui: &mut Ui,
    app: &App,
    (name, meaning, width): (&str, &str, f32),
    (key, otherwise): (&mut Option<String>, &str),
) {
    let chooser = Chooser {
        name,
        meaning,
        says: &name_of(app, key.as_deref(), otherwise),
        offers: lights,
        width,
    };
    if let Some(entry) = chooser.show(ui, app) {
        *key = Some(entry.key.clone());
    }
}

/// A button that takes a chosen light away again.
fn clear(ui: &mut Ui, key: &mut Option<String>, meaning: &str) {
    if key.is_some() && pressed_small(ui, "×", meaning) {
        *key = None;
    }
}

/// Which picture, and what fell on it.
pub(super) fn subject(ui: &mut Ui, context: &mut PageContext<'_>) {
    let app = context.app;
    let open = shown(app.document(), &context.pages.image).cloned();
    if let Some(open) = open {
        let memory = &mut context.pages.relit;
        let choice = Choice {
            name: said(names::PICTURE),
            meaning: said!(
                "The image that is open (another one is chosen on the page Spectral image), or a \
                 wall of measured paints that this program makes."
            ),
            width: LIST,
        };
        let (image, wall) = (
            open.image.name.clone(),
            said!("a wall of paints").to_owned(),
        );
        let now = if memory.wall { &wall } else { &image };
        let before = memory.wall;
        choice.cut(ui, now.clone(), |ui| {
            ui.selectable_value(&mut memory.wall, false, image.clone());
            ui.selectable_value(&mut memory.wall, true, wall.clone());
        });
        if memory.wall != before {
            memory.pixel = None;
            ui.ctx().request_repaint();
        }
    }
    let ask = LookAsk::of(app, &context.pages.relit, &context.pages.image);
    if !ask.asks_for_light() {
        return own(ui, context);
    }
    let memory = &mut context.pages.relit;
    ui.label(said!("Taken under"));
    let is_wall = ask.subject == crate::app::relit::Subject::Wall;
    let otherwise = if is_wall {
        said!("an even light")
    } else {
        said!("unknown")
    };
    let meaning = said!(
        "The light that fell on the picture when it was taken. It is divided out again, so that \
         the picture can be shown under other lights."
    );
    let key = &mut memory.taken_under;
    choose_light(
        ui,
        app,
        (said(names::TAKEN), meaning, LIST),
        (key, otherwise),
    );
    let meaning = if is_wall {
        said!("Photographs it in even light.")
    } else {
        said!("Nobody knows what lit it.")
    };
    clear(ui, &mut memory.taken_under, meaning);
}

/// Under which light the colours of a reflectance are exact.
fn own(ui: &mut Ui, context: &mut PageContext<'_>) {
    let key = &mut context.pages.relit.own;
    ui.label(said!("Own light"));
    let meaning = said!(
        "Under this light the colours in few numbers are exactly those of every band, and the \
         preview of a file shows it."
    );
    let list = (said(names::OWN), meaning, LIST);
    choose_light(ui, context.app, list, (key, "CIE D65"));
    clear(ui, key, said!("Daylight, CIE D65."));
}

/// What shines on it now.
pub(super) fn light(ui: &mut Ui, context: &mut PageContext<'_>) {
    let app = context.app;
    let of_window = &app.document().light;
    ui.label(said!("Shown under"));
    let meaning = said!(
        "The light that shines on the picture, here alone; at first the window's. The picture \
         turns at once; only three weights a number are new."
    );
    let under = &mut context.pages.relit.under;
    let list = (said(names::LIGHT), meaning, LIST);
    choose_light(ui, app, list, (under, of_window.name()));
    clear(ui, under, said!("The window's light."));
    for (title, key) in AT_HAND {
        let Some(entry) = app.entry(key) else {
            continue;
        };
        let is_now = under.as_deref().unwrap_or(&of_window.key) == key;
        let button = ui.selectable_label(is_now, said(title));
        if button.on_hover_text(entry.name()).clicked() {
            *under = Some(key.to_owned());
        }
    }
    let meaning = said!(
        "As the eye sees it after a minute: the light's own colour becomes the screen's white."
    );
    adapt_box(ui, context.app, (said!("adapt"), meaning), context.commands);
    let memory = &mut context.pages.relit;
    let meaning = said!("A second light beside the first, to mix them.");
    let list = (said(names::SECOND), meaning, 0.6 * LIST);
    choose_light(
        ui,
        context.app,
        list,
        (&mut memory.second, said!("+ light")),
    );
    if memory.second.is_some() {
        ui.spacing_mut().slider_width = 90.0 * context.theme.scale;
        let slider = slide(&mut memory.second_percent, 0..=100).suffix(" %");
        let slider = ui.add(slider);
        named(&slider, egui::Role::Slider, said(names::SHARE));
        slider.on_hover_text(said!("Share of the brightness that is the second light's."));
        clear(ui, &mut memory.second, said!("One light alone."));
    }
}

/// How many numbers, and what stands large.
pub(super) fn numbers(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    looked: &Looked,
    fit: Option<&ByAddress<Fit>>,
) {
    let now = fit.map_or(looked.choice.chosen.numbers, |fit| fit.0.operator.numbers());
    let memory = &mut context.pages.relit;
    let [least, most] = looked.numbers();
    let mut count = memory.numbers.unwrap_or(now).clamp(least, most);
    ui.label(said!("Numbers a pixel"));
    ui.spacing_mut().slider_width = 150.0 * context.theme.scale;
    let slider = ui.add(slide(&mut count, least..=most));
    let slider = slider.on_hover_text(said!(
        "Numbers for each pixel. Multiplier and lines are chosen for each count."
    ));
    if slider.changed() {
        memory.numbers = Some(count);
    }
    let mut by_itself = memory.numbers.is_none();
    let enough = ui.selectable_label(by_itself, said(names::ENOUGH));
    if enough.on_hover_text(fewer(looked)).clicked() {
        by_itself = !by_itself;
        memory.numbers = (!by_itself).then_some(count);
    }
    let bound = drag_value(&mut memory.bound)
        .range(RelitMemory::BOUND.reach.range())
        .speed(0.01)
        .max_decimals(2)
        .prefix("ΔE₀₀ ");
    number(ui, bound, said(names::BOUND)).on_hover_text(said!(
        "Bound that 95 % of the pixels keep. The compact file keeps its own colours within it too."
    ));
    ui.separator();
    for look in Look::ALL {
        ui.selectable_value(&mut memory.look, look, look.title())
            .on_hover_text(look.meaning());
    }
}

/// Saving in either form; what is to be saved.
pub(super) fn save(ui: &mut Ui, shown: &RelitShown) -> Option<PictureWish> {
    let ready = shown.turned.as_ref().zip(shown.stored.as_ref());
    let mut wish = None;
    // It goes to the next row whole rather than into what is left of this one.
    let button = Button::new(said(names::SAVE)).wrap_mode(TextWrapMode::Extend);
    let Some(((fit, _), stored)) = ready else {
        ui.add_enabled(false, button)
            .on_disabled_hover_text(said!("Its bytes are being measured."));
        return wish;
    };
    let (menu, _) = MenuButton::from_button(button).ui(ui, |ui| {
        for form in Form::ALL {
            let bytes = match form {
                Form::Full => stored.0.bytes.full,
                Form::Compact => stored.0.bytes.compact,
            };
            let words = tr!(
                "As .{ending} ({size})",
                ending = form.ending(),
                size = crate::app::relit::bytes_words(bytes.unwrap_or(0))
            );
            let button = ui.button(RichText::new(words));
            if button.on_hover_text(form.meaning()).clicked() {
                wish = Some(PictureWish {
                    fit: fit.clone(),
                    stored: stored.clone(),
                    form,
                });
                ui.close();
            }
        }
    });
    menu.on_hover_text(said!("Saves the picture in few numbers."));
    wish
}
