//! What joins the desk: a channel, a gel.

use eframe::egui;
use egui::Ui;

use super::{change, longer, strips};
use crate::{
    app::{
        Gel,
        design::{
            Desk,
            mix::{MOST_CHANNELS, MOST_GELS, MixChannel},
            named_lines::NamedLine,
        },
    },
    design::mixture::Source,
    languages::said,
    ui::{
        kit::{Chooser, lights, transmittances},
        pages::PageContext,
    },
};

/// What lists say that only add.
const ANY_LIGHT: &str = later!("Any light");
const GEL: &str = later!("Gel");

/// What joins the desk.
pub(super) fn add_row(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    desk: &Desk,
    lines: &[NamedLine],
) {
    let mut new = None;
    let is_full = desk.mix.channels.len() >= MOST_CHANNELS;
    ui.add_enabled_ui(!is_full, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.weak(said!("Add"));
            let line = ui.menu_button(said!("Line"), |ui| {
                if let Some(line) = strips::line_menu(ui, lines) {
                    new = Some(Source::Line { at_nm: line });
                }
            });
            line.response.on_hover_text(said!(
                "A line without width, at the place of one that has a name."
            ));
            let mut button = |title: &str, meaning: &str, source: Source| {
                if ui.button(title).on_hover_text(meaning).clicked() {
                    new = Some(source);
                }
            };
            button(
                "LED",
                said!("A Gaussian with a centre and a full width at half its height."),
                Source::Gauss {
                    centre_nm: 500.0,
                    fwhm_nm: 20.0,
                },
            );
            button(
                said!("Blackbody"),
                said!("The light of a glowing body of a temperature."),
                Source::Blackbody { kelvin: 2700.0 },
            );
            button(
                said!("Daylight"),
                said!("Daylight of a temperature, by the CIE's components."),
                Source::Daylight { kelvin: 6500.0 },
            );
            let chosen = Chooser {
                name: said!("A light to mix"),
                meaning: said!("Any light of the library, shipped or your own, as a channel."),
                says: said(ANY_LIGHT),
                offers: lights,
                width: 70.0 * longer([ANY_LIGHT]) * context.theme.scale,
            }
            .show(ui, context.app);
            if let Some(light) = chosen {
                new = Some(Source::Named(light.key.clone()));
            }
            add_gel(ui, context, desk);
        });
    });
    if let Some(source) = new {
        change(context, |mix| mix.channels.push(MixChannel::new(source)));
    }
}

/// What joins the gels.
fn add_gel(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    if desk.mix.gels.len() >= MOST_GELS {
        return;
    }
    let gel = Chooser {
        name: said!("A gel before the lamps"),
        meaning: said!(
            "A filter or glass of the library, or of a file that was opened, before all channels."
        ),
        says: said(GEL),
        offers: transmittances,
        width: 40.0 * longer([GEL]) * context.theme.scale,
    }
    .show(ui, context.app);
    if let Some(gel) = gel {
        let key = gel.key.clone();
        let thickness = 1.0;
        change(context, |mix| mix.gels.push(Gel { key, thickness }));
    }
}
