//! What stands for every pixel: chosen by itself, or by hand.

use eframe::egui;
use egui::{
    DragValue, PopupCloseBehavior, Ui,
    containers::menu::{MenuButton, MenuConfig},
};

use super::names;
use crate::{
    app::{
        pages::{LINES_NM, MOST_LINES},
        relit::Fit,
    },
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
    (None, "Best", "What is off by the least."),
    (Some(ReferenceKind::One), "Nothing", "A bare cosine series."),
    (
        Some(ReferenceKind::Mean),
        "The mean",
        "The picture's own mean: the series is what a pixel is beside it.",
    ),
    (
        Some(ReferenceKind::Light),
        "The light",
        "The light that the picture was taken under: it carries the lines, and the series is the \
         surface's alone.",
    ),
];

/// The menu: what multiplies the series, which lines there are, what counts.
pub(super) fn menu(ui: &mut Ui, context: &mut PageContext<'_>, fit: &Fit) {
    let outside = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let words = format!("Kept: {} ▾", fit.how());
    let button = MenuButton::from_button(egui::Button::new(words).truncate()).config(outside);
    let (response, _) = button.ui(ui, |ui| {
        ui.set_min_width(300.0 * context.theme.scale);
        reference(ui, context, fit);
        ui.separator();
        lines(ui, context, fit);
        ui.separator();
        let memory = &mut context.pages.relit;
        if fit.operator.bands().is_factor() {
            ui.checkbox(&mut memory.weighted, names::WEIGHTED)
                .on_hover_text(
                    "The numbers are fitted so that colours are near under many lamps. Without, \
                     they are the plain least squares of the spectra.",
                );
        }
        ui.checkbox(&mut memory.between_series, names::BETWEEN)
            .on_hover_text(
                "What the picture in few numbers is between its bands: the series itself, not a \
                 straight line. Where bands are 10 nm apart or more that is nearer to the truth, \
                 and further from every band, which straight lines join.",
            );
    });
    named(&response, egui::Role::Button, names::KEPT);
    response.on_hover_text("What stands for every pixel. Click to choose it by hand.");
}

fn reference(ui: &mut Ui, context: &mut PageContext<'_>, fit: &Fit) {
    ui.label("What multiplies the series");
    let is_known = fit.looked.0.known.is_some();
    let wish = &mut context.pages.relit.wish;
    ui.horizontal(|ui| {
        for (kind, title, meaning) in REFERENCES {
            let can_be = kind != Some(ReferenceKind::Light) || is_known;
            ui.add_enabled_ui(can_be, |ui| {
                ui.selectable_value(&mut wish.reference, kind, title)
                    .on_hover_text(meaning)
                    .on_disabled_hover_text("Nobody knows what lit this picture.");
            });
        }
    });
}

fn lines(ui: &mut Ui, context: &mut PageContext<'_>, fit: &Fit) {
    ui.label("Lines that all pixels share, a number each");
    let now: Vec<f64> = fit.operator.plan().lines.iter().map(|l| l.at_nm).collect();
    let lines = &mut context.pages.relit.wish.lines;
    ui.horizontal(|ui| {
        for (choice, title, meaning) in [
            (
                LineChoice::Best,
                "Best",
                "Lines that were found, where they pay.",
            ),
            (LineChoice::None, "None", "The series alone."),
            (
                LineChoice::Found,
                "Found",
                "Lines that rise above the light or the mean, the strongest first.",
            ),
        ] {
            ui.selectable_value(lines, choice, title)
                .on_hover_text(meaning);
        }
        let is_by_hand = matches!(lines, LineChoice::At(_));
        let by_hand = ui.selectable_label(is_by_hand, names::HAND);
        let by_hand = by_hand.on_hover_text("Add and remove them, beginning with those there are.");
        if by_hand.clicked() && !is_by_hand {
            *lines = LineChoice::At(now.iter().copied().take(MOST_LINES).collect());
        }
    });
    match lines {
        LineChoice::At(places) => hand(ui, places, fit),
        _ if now.is_empty() => drop(ui.weak("None now.")),
        _ => {
            let now: Vec<String> = now.iter().map(|nm| format!("{nm:.1}")).collect();
            ui.weak(format!("Now at {} nm.", now.join(", ")));
        }
    }
}

/// The list to add to and take from.
fn hand(ui: &mut Ui, places: &mut Vec<f64>, fit: &Fit) {
    let mut gone = None;
    ui.horizontal_wrapped(|ui| {
        for (i, nm) in places.iter().enumerate() {
            let button = ui.button(format!("{nm:.1} nm ×"));
            if button.on_hover_text("Takes this line away.").clicked() {
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
        let place = DragValue::new(&mut next)
            .range(first..=last)
            .speed(0.5)
            .max_decimals(1)
            .suffix(" nm");
        number(ui, place, names::NEXT_LINE).on_hover_text("Drag, or click and type.");
        let room = places.len() < MOST_LINES && !places.contains(&next);
        let add = ui.add_enabled(room, egui::Button::new(names::ADD_LINE));
        if add.clicked() {
            places.push(next);
            places.sort_by(f64::total_cmp);
        }
    });
    ui.data_mut(|d| d.insert_temp(id, next));
}
