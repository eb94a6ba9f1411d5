//! What stands for every pixel: chosen by itself, or by hand.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::{
    PopupCloseBehavior, Ui,
    containers::menu::{MenuButton, MenuConfig},
};

use super::names;
use crate::{
    app::{
        pages::{LINES_NM, MOST_LINES},
        relit::Fit,
    },
    languages::{fixed, said},
    pictures::{LineChoice, ReferenceKind},
    ui::{
        kit::{named, number},
        pages::PageContext,
    },
};

/// Where the next line by hand goes, nm: mercury's green one, until another place is set.
const FIRST_NM: f64 = 546.1;

/// What multiplies the series: title and meaning.
const REFERENCES: [(Option<ReferenceKind>, &str, &str); 4] = [
    (
        None,
        later!("Best"),
        later!("The choice with the smallest error."),
    ),
    (
        Some(ReferenceKind::One),
        later!("Nothing"),
        later!("A bare cosine series."),
    ),
    (
        Some(ReferenceKind::Mean),
        later!("The mean"),
        later!("The picture's own mean: the series is what a pixel is beside it."),
    ),
    (
        Some(ReferenceKind::Light),
        later!("The light"),
        later!(
            "The light that the picture was taken under: it carries the lines, and the series is \
             the surface's alone."
        ),
    ),
];

/// The menu: what multiplies the series, which lines there are, what counts.
pub(super) fn menu(ui: &mut Ui, context: &mut PageContext<'_>, fit: &Fit) {
    let outside = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let words = tr!("Kept: {numbers} ▾", numbers = fit.how());
    let button = MenuButton::from_button(egui::Button::new(words).truncate()).config(outside);
    let (response, _) = button.ui(ui, |ui| {
        ui.set_min_width(300.0 * context.theme.scale);
        reference(ui, context, fit);
        ui.separator();
        lines(ui, context, fit);
        ui.separator();
        let memory = &mut context.pages.relit;
        if fit.operator.bands().is_factor() {
            ui.checkbox(&mut memory.weighted, said(names::WEIGHTED))
                .on_hover_text(said!(
                    "The numbers are fitted so that colours are near under many lamps. Without, \
                     they are the plain least squares of the spectra."
                ));
        }
        ui.checkbox(&mut memory.between_series, said(names::BETWEEN))
            .on_hover_text(said!(
                "Between its bands the picture in few numbers is the series itself, not a straight \
                 line. Where bands are 10 nm apart or more that is nearer to the truth, and \
                 further from every band, which straight lines join."
            ));
    });
    named(&response, egui::Role::Button, said(names::KEPT));
    response.on_hover_text(said!(
        "The numbers that stand for every pixel. Click to choose them by hand."
    ));
}

fn reference(ui: &mut Ui, context: &mut PageContext<'_>, fit: &Fit) {
    ui.label(said!("Multiplier of the series"));
    let is_known = fit.looked.0.known.is_some();
    let wish = &mut context.pages.relit.wish;
    ui.horizontal(|ui| {
        for (kind, title, meaning) in REFERENCES {
            let can_be = kind != Some(ReferenceKind::Light) || is_known;
            ui.add_enabled_ui(can_be, |ui| {
                ui.selectable_value(&mut wish.reference, kind, said(title))
                    .on_hover_text(said(meaning))
                    .on_disabled_hover_text(said!("Nobody knows what lit this picture."));
            });
        }
    });
}

fn lines(ui: &mut Ui, context: &mut PageContext<'_>, fit: &Fit) {
    ui.label(said!("Lines that all pixels share, a number each"));
    let now: Vec<f64> = fit.operator.plan().lines.iter().map(|l| l.at_nm).collect();
    let lines = &mut context.pages.relit.wish.lines;
    ui.horizontal(|ui| {
        for (choice, title, meaning) in [
            (
                LineChoice::Best,
                said!("Best"),
                said!("Lines that were found, where they pay."),
            ),
            (LineChoice::None, said!("None"), said!("The series alone.")),
            (
                LineChoice::Found,
                said!("Found"),
                said!("Lines that rise above the light or the mean, the strongest first."),
            ),
        ] {
            ui.selectable_value(lines, choice, title)
                .on_hover_text(meaning);
        }
        let is_by_hand = matches!(lines, LineChoice::At(_));
        let by_hand = ui.selectable_label(is_by_hand, said(names::HAND));
        let by_hand = by_hand.on_hover_text(said!(
            "Add and remove them, beginning with those there are."
        ));
        if by_hand.clicked() && !is_by_hand {
            *lines = LineChoice::At(now.iter().copied().take(MOST_LINES).collect());
        }
    });
    match lines {
        LineChoice::At(places) => hand(ui, places, fit),
        _ if now.is_empty() => drop(ui.weak(said!("None now."))),
        _ => {
            let now: Vec<String> = now.iter().map(|nm| fixed(nm, 1)).collect();
            ui.weak(tr!("Now at {places} nm.", places = now.join(", ")));
        }
    }
}

/// The list to add to and take from.
fn hand(ui: &mut Ui, places: &mut Vec<f64>, fit: &Fit) {
    let mut gone = None;
    ui.horizontal_wrapped(|ui| {
        for (i, nm) in places.iter().enumerate() {
            let button = ui.button(format!("{} nm ×", fixed(nm, 1)));
            if button
                .on_hover_text(said!("Takes this line away."))
                .clicked()
            {
                gone = Some(i);
            }
        }
    });
    if let Some(i) = gone {
        places.remove(i);
    }
    let bands = fit.operator.bands().nm();
    let [first, last] = [bands[0], bands[bands.len() - 1]].map(|nm| LINES_NM.nearest(nm, nm));
    let id = ui.make_persistent_id("next line");
    let mut next = ui.data_mut(|d| d.get_temp(id)).unwrap_or(FIRST_NM);
    next = next.clamp(first, last);
    ui.horizontal(|ui| {
        let place = drag_value(&mut next)
            .range(first..=last)
            .speed(0.5)
            .max_decimals(1)
            .suffix(" nm");
        number(ui, place, said(names::NEXT_LINE)).on_hover_text(said!("Drag, or click and type."));
        let room = places.len() < MOST_LINES && !places.contains(&next);
        let add = ui.add_enabled(room, egui::Button::new(said(names::ADD_LINE)));
        if add.clicked() {
            places.push(next);
            places.sort_by(f64::total_cmp);
        }
    });
    ui.data_mut(|d| d.insert_temp(id, next));
}
