//! How thick a factor is and how often it is met.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::{RichText, Ui};

use super::super::change;
use crate::{
    app::{
        products::{BOUNCES, Link, THICKNESSES},
        ticks::short,
    },
    spectrum::Kind,
    ui::{kit::number, pages::PageContext},
};

pub(super) fn thickness(ui: &mut Ui, context: &mut PageContext<'_>, link: &Link, index: usize) {
    if !link.has_thickness() {
        return;
    }
    let label = ui.label(
        RichText::new(said!("thickness"))
            .small()
            .color(context.theme.faint),
    );
    let mm = link.measured_mm();
    let unit = mm.unwrap_or(1.0);
    let mut value = link.thickness * unit;
    let drag = drag_value(&mut value)
        .range(*THICKNESSES.start() * unit..=*THICKNESSES.end() * unit)
        .speed(0.02 * unit)
        .custom_formatter(|v, _| short(v));
    let drag = match mm {
        Some(_) => drag.suffix(" mm"),
        None => drag.suffix(" ×"),
    };
    let response = number(
        ui,
        drag,
        &tr!("Thickness of step {number}", number = index + 1),
    );
    let meaning = match mm {
        Some(mm) => tr!(
            "Thickness of the glass, mm; measured at {thickness} mm. Internal transmittance to the \
             power of the ratio (Beer-Lambert).",
            thickness = short(mm)
        ),
        None => said!(
            "Thickness as a multiple of the measured one (Beer-Lambert): each share to this power. \
             For glasses and filters."
        )
        .to_owned(),
    };
    let changed = response.changed();
    label.on_hover_text(&meaning);
    response.on_hover_text(meaning);
    if changed {
        let ratio = value / unit;
        change(context, |products| products.chain[index].thickness = ratio);
    }
}

pub(super) fn times(ui: &mut Ui, context: &mut PageContext<'_>, link: &Link, index: usize) {
    let meaning =
        said!("Bounces off the surface, or passes through the filter, one after the other.");
    let name = match link.entry.kind() {
        Kind::Transmittance => said!("passes"),
        _ => said!("bounces"),
    };
    let label = ui.label(RichText::new(name).small().color(context.theme.faint));
    label.on_hover_text(meaning);
    let mut bounces = link.bounces;
    let drag = drag_value(&mut bounces).range(BOUNCES).speed(0.05);
    let response = number(
        ui,
        drag,
        &tr!("Bounces of step {number}", number = index + 1),
    );
    let changed = response.changed();
    response.on_hover_text(meaning);
    if changed {
        change(context, |products| products.chain[index].bounces = bounces);
    }
}
