//! The exact light and the three representations behind the filter, as colours.

use eframe::egui;
use egui::{RichText, Sense, Ui, Vec2, vec2};

use crate::{
    app::{
        charts::products::narrow::{Behind, Figures, Filter, WAY_MEANINGS, WAYS},
        studies::paper::{delta_e, figure, percent},
    },
    color::Swatch,
    ui::{kit::named, pages::PageContext, swatch},
};

/// The exact light and the three representations behind the filter, side by side.
pub(super) fn show(
    ui: &mut Ui,
    context: &PageContext<'_>,
    behind: &Behind,
    figures: &Figures,
    filter: &Filter,
) {
    ui.add_space(2.0);
    if !behind.has_colour() {
        ui.weak("There is no visible light in this range: nothing to see behind a filter.");
        return;
    }
    let over = match filter {
        Filter::Gaussian {
            centre_nm,
            width_nm,
        } => format!("Behind {centre_nm:.1} nm, {width_nm:.1} nm wide"),
        Filter::Real(entry) => format!("Behind {}", entry.name()),
    };
    let (swatches, gain) = behind.swatches(figures);
    let sentence = format!(
        "{over}: {} % of the luminance; three times {} numbers.",
        percent(figures.luminance),
        behind.numbers()
    );
    ui.add(egui::Label::new(sentence).truncate())
        .on_hover_text(format!(
            "Shown {} times as bright as it is, as the colours are compared.",
            figure(gain)
        ));
    ui.horizontal(|ui| {
        let spacing = 8.0;
        ui.spacing_mut().item_spacing.x = spacing;
        let width = ((ui.available_width() - 3.0 * spacing) / 4.0).floor();
        let height = 30.0 * context.theme.scale;
        field(
            ui,
            vec2(width, height),
            &swatches[0],
            "exact",
            "",
            "Measured light, exact filter.",
        );
        for (way, colours) in figures.ways.iter().enumerate() {
            let words = format!("ΔE00 {}", delta_e(colours.delta_e_2000));
            let luminance = colours.luminance_error.map_or_else(
                || "no luminance to be off by".to_owned(),
                |error| format!("luminance {:+.2} %", 100.0 * error),
            );
            let meaning = format!("{}\n{words}, {luminance}.", WAY_MEANINGS[way]);
            field(
                ui,
                vec2(width, height),
                &swatches[way + 1],
                WAYS[way],
                &words,
                &meaning,
            );
        }
    });
    ui.add_space(4.0);
}

/// One colour with what it is and by how much it is off below it.
fn field(ui: &mut Ui, size: Vec2, colour: &Swatch, name: &str, words: &str, meaning: &str) {
    ui.vertical(|ui| {
        ui.set_width(size.x);
        ui.spacing_mut().item_spacing.y = 1.0;
        let told = format!("{name} behind the filter {words}");
        let hex = colour.hex();
        let mapping = if colour.in_gamut {
            String::new()
        } else {
            " The screen cannot show it; the nearest it can.".to_owned()
        };
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        named(&response, egui::Role::Image, &told);
        let shown = swatch::colour(colour.rgb8);
        swatch::paint_split(ui, rect, shown, shown);
        if !colour.in_gamut {
            swatch::out_of_gamut_mark(ui, rect.left_top() + vec2(9.0, 8.0));
        }
        response.on_hover_text(format!("{meaning}\nsRGB {hex}.{mapping}"));
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.add(egui::Label::new(RichText::new(name).small()).truncate());
            ui.add(egui::Label::new(RichText::new(words).small().strong()).truncate());
        });
    });
}
