//! The layers of the plot as switches that are their own legend.

use eframe::egui;
use egui::Ui;

use super::{
    super::theme::{Theme, ink},
    Wishes,
};
use crate::app::{App, Command};

/// Draws the switches; returns whether the whole range is to come back into view.
pub(super) fn layers(ui: &mut Ui, app: &App, theme: Theme, wishes: &mut Wishes) -> bool {
    let mut reset = false;
    let document = app.document();
    let before = document.view;
    let mut view = before;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let inks = theme.inks;
        layer(
            ui,
            &mut view.measured,
            "measured",
            Some(inks.measured),
            "The spectrum as measured.",
        );
        layer(
            ui,
            &mut view.smooth,
            "smooth",
            Some(inks.smooth),
            "The smooth part: the short series.",
        );
        layer(
            ui,
            &mut view.spikes,
            "spikes",
            Some(inks.spikes),
            "The spikes as stems. A stem's height above the smooth part is weight / (1.0645 x \
                 widest line), the peak of a Gaussian of that width and weight.",
        );
        layer(
            ui,
            &mut view.model,
            "model",
            Some(inks.spikes),
            "Smooth part and spikes together, each spike split over its two neighbouring nm.",
        );
        layer(
            ui,
            &mut view.residual,
            "residual",
            Some(inks.residual),
            "Model minus measured, below.",
        );
        layer(
            ui,
            &mut view.strip,
            "colours",
            None,
            "The colour of each wavelength under the axis.",
        );
        if !document.overlays.is_empty() {
            overlays(ui, app, theme, &mut view.overlays, wishes);
        }
        layer(
            ui,
            &mut view.log_axis,
            "log",
            None,
            "Logarithmic vertical axis.",
        );
        if ui
            .small_button("whole range")
            .on_hover_text(
                "Brings the whole range back into view (Home). Drag to move, Ctrl and \
                    wheel to zoom, right drag for a box.",
            )
            .clicked()
        {
            reset = true;
        }
    });
    if view != before {
        wishes.commands.push(Command::View(view));
    }
    reset
}

/// The switch of the overlays, their names, and what takes them away.
fn overlays(ui: &mut Ui, app: &App, theme: Theme, on: &mut bool, wishes: &mut Wishes) {
    let (document, inks) = (app.document(), theme.inks);
    layer(
        ui,
        on,
        "overlays",
        Some(inks.overlays[0]),
        "The spectra laid over for comparison. One of another kind (a reflectance over a \
                     light) is drawn to the same height.",
    );
    for (i, overlay) in document.overlays.iter().enumerate().take(MOST_NAMES) {
        let colour = ink(inks.overlays[i % inks.overlays.len()]);
        let name = shortened(overlay.name());
        ui.label(egui::RichText::new(name).small().color(colour));
    }
    if document.overlays.len() > MOST_NAMES {
        let more = document.overlays.len() - MOST_NAMES;
        ui.small(format!("and {more} more"));
    }
    if ui
        .small_button("clear")
        .on_hover_text("Takes all overlays away.")
        .clicked()
    {
        wishes.commands.push(Command::ClearOverlays);
    }
}

fn layer(ui: &mut Ui, on: &mut bool, name: &str, colour: Option<[u8; 3]>, meaning: &str) {
    let text = egui::RichText::new(name).small();
    let button = match colour {
        Some(colour) => {
            let mark = egui::RichText::new(if *on { "●" } else { "○" })
                .small()
                .color(ink(colour));
            egui::Button::selectable(*on, (mark, text))
        }
        None => egui::Button::selectable(*on, text),
    };
    let response = ui.add(button).on_hover_text(meaning);
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::CheckBox, true, *on, format!("Show {name}"))
    });
    if response.clicked() {
        *on = !*on;
    }
}

/// Overlays named beside their switch.
const MOST_NAMES: usize = 4;

/// A name of at most a few letters.
fn shortened(name: &str) -> String {
    const MOST: usize = 14;
    if name.chars().count() <= MOST {
        return name.to_owned();
    }
    name.chars().take(MOST - 1).chain(['…']).collect()
}
