//! Beside the picture: one pixel's spectrum, the error against numbers or the histogram of
//! differences, the bytes.

use eframe::egui;
use egui::{Ui, Vec2, vec2};

use super::{RelitView, kept, names};
use crate::{
    app::{
        charts::relit::{difference_chart, error_chart, pixel_chart},
        pages::Look,
        relit::{RelitShown, StoreAsk, byte_rows, negative_words},
        studies::Stage,
    },
    languages::said,
    ui::{
        kit::{self, Column, Row, table},
        pages::{PageContext, progress},
    },
};

/// Rows of the table of bytes with its titles.
const ROWS: f32 = 4.0;

impl RelitView {
    /// Charts and bytes in the room there is.
    pub(super) fn side(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        shown: &RelitShown,
        room: Vec2,
    ) {
        let (Some(looked), Some((fit, turned))) = (&shown.looked, &shown.turned) else {
            return;
        };
        let row = ui.text_style_height(&egui::TextStyle::Body) + 5.0;
        let line = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
        let gaps = 3.0 * ui.spacing().item_spacing.y;
        let height = (room.y - ROWS * row - 2.0 * line - gaps) / 2.0;
        let size = vec2(room.x, height.max(70.0));
        let pixel = self.chosen(context, &fit.0.looked.0, &turned.0);
        kit::line(ui, |ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let memory = &mut context.pages.relit;
                let worst = ui.add_enabled(
                    memory.pixel.is_some(),
                    egui::Button::new(said(names::WORST)).small(),
                );
                let worst = worst.on_hover_text(said!("Shows the pixel that is most off."));
                if worst
                    .on_disabled_hover_text(said!(
                        "The pixel that is most off is shown; click another."
                    ))
                    .clicked()
                {
                    memory.pixel = None;
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    kept::menu(ui, context, &fit.0);
                });
            });
        });
        let key = (fit.clone(), pixel);
        let chart = self
            .pixel
            .get(key, |(fit, pixel)| pixel_chart(&fit.0, *pixel));
        context.chart(ui, chart, "pixel in few numbers", size);
        if context.pages.relit.look == Look::Difference {
            let chart = self
                .off
                .get(turned.clone(), |turned| difference_chart(&turned.0));
            context.chart(ui, chart, "pixels by their difference", size);
        } else {
            let now = fit.0.operator.numbers();
            let key = (looked.clone(), now);
            let chart = self
                .error
                .get(key, |(looked, now)| error_chart(&looked.0, *now));
            let touched = context.chart(ui, chart, "error against numbers a pixel", size);
            if let Some(hit) = touched.clicked {
                context.pages.relit.numbers = Some(hit.at[0].round() as usize);
            }
        }
        bytes(ui, context, shown);
    }
}

/// What each form takes on disk.
fn bytes(ui: &mut Ui, context: &mut PageContext<'_>, shown: &RelitShown) {
    let job = context.studies.of::<StoreAsk>();
    let (Some(stored), Some((fit, _))) = (&shown.stored, &shown.turned) else {
        return match job.stage() {
            Stage::Done => {}
            _ => progress(ui, job, said!("The size of its files")),
        };
    };
    let columns = [
        Column::words(said!("file"), said!("The way of keeping the picture."), 2.4),
        Column::numbers(said!("size"), said!("Written and counted here."), 1.2),
        Column::numbers(said!("B/pixel"), said!("Bytes a pixel."), 1.0),
        Column::numbers(
            "ΔE₀₀",
            said!("Own colour, read back: 95 % of all pixels are within."),
            0.8,
        ),
    ];
    let notes = [
        String::new(),
        negative_words(&stored.0.full),
        negative_words(&stored.0.compact.error),
    ];
    let rows: Vec<Row> = byte_rows(&fit.0, &stored.0)
        .into_iter()
        .zip(notes)
        .map(|(cells, note)| Row {
            note,
            ..Row::of(cells)
        })
        .collect();
    table(ui, &columns, &rows, None, false, context.theme);
}
