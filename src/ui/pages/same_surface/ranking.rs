//! Which surface explains the outgoing spectrum best.

use std::sync::Arc;

use eframe::egui;
use egui::Ui;

use super::{
    super::products_view::{among, change},
    names,
};
use crate::{
    app::{
        ByAddress, Memo,
        numbers::hundredths,
        pages::same_surface::{RankAsk, Ranked, SameSurfaceSheet, ranking},
        studies::Stage,
    },
    study::products::Sameness,
    ui::{
        kit::{self, Column, Row, Table, copy_button},
        pages::{PageContext, progress},
        swatch,
    },
};

/// The ranking, within a height.
pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &SameSurfaceSheet,
    laid_out: &mut Memo<ByAddress<Vec<Ranked>>, (Vec<Column>, Vec<Row>)>,
    height: f32,
) {
    let answer = context.studies.of::<RankAsk>().answer();
    let ranked = answer.map(|(_, ranked)| ranked.clone());
    ui.horizontal_wrapped(|ui| {
        ui.strong("Which surface explains it best?");
        copy_button(ui, names::COPY, "", || {
            let csv = |ranked: &Arc<Vec<Ranked>>| ranking(&sheet.names, ranked).csv();
            ranked.as_ref().map_or_else(String::new, csv)
        });
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("Among");
        let meaning = "Which surfaces are tried: the patch set, or everything shipped.";
        let everywhere = context.pages.same_surface.everywhere;
        context.pages.same_surface.everywhere =
            among(ui, context, names::AMONG, meaning, everywhere);
        let job = context.studies.of::<RankAsk>();
        if job.stage() != Stage::Done {
            progress(ui, job, "The ranking");
        }
    });
    let Some(ranked) =
        ranked.filter(|_| context.studies.of::<RankAsk>().stage() != Stage::Impossible)
    else {
        return;
    };
    let count = |verdict: Sameness| ranked.iter().filter(|r| r.verdict == verdict).count();
    let (holding, open) = (count(Sameness::Holds), count(Sameness::Unknown));
    ui.label(format!(
        "{holding} of {} surfaces fit the model's numbers{}{}",
        ranked.len(),
        if open > 0 {
            format!("; {open} are undecided")
        } else {
            String::new()
        },
        if 3 * holding > ranked.len() {
            ": this light tells surfaces badly apart."
        } else {
            "."
        }
    ));
    let (columns, rows) = laid_out.get(ByAddress(ranked.clone()), |_| {
        self::laid_out(sheet, &ranked)
    });
    let chosen = context.app.document().products.surface.as_ref();
    let chosen = chosen.and_then(|entry| ranked.iter().position(|r| r.key == entry.key));
    let table = Table {
        chosen,
        ..Table::new(columns, context.theme)
    };
    let clicked = table.scrolled(
        ui,
        "ranking",
        height.max(4.0 * table.row_height(ui)),
        rows,
        &mut |ui, [row, column], cell| {
            if column == 0 {
                let fill = swatch::colour(ranked[row].swatch.rgb8);
                let field = cell.shrink2(egui::vec2(0.0, 2.0));
                ui.painter().rect_filled(field, 3.0, fill);
            }
        },
    );
    let clicked = clicked.and_then(|row| context.app.entry(&ranked[row].key));
    if let Some(surface) = clicked {
        change(context, |products| products.surface = Some(surface));
    }
}

/// Its columns and rows, a field of colour before each.
pub(super) fn laid_out(sheet: &SameSurfaceSheet, ranked: &[Ranked]) -> (Vec<Column>, Vec<Row>) {
    let table = ranking(&sheet.names, ranked);
    let mut columns = kit::columns(&table, &[0.43, 0.14, 0.15, 0.19]);
    columns.insert(
        0,
        Column::words("", "Colour of the surface under the light.", 0.09),
    );
    let mut rows = kit::rows(&table, |i, cells| {
        let ranked = &ranked[i];
        let [name, residual] = [&cells[0], &cells[1]];
        [
            format!("{name}: residual {residual}, {}", ranked.verdict.words()),
            format!(
                "{}\nFactor {} in the model's numbers, {} measured.\nClick to take it as the \
                 surface S2.",
                ranked.key,
                hundredths(ranked.model.map(|m| m.factor)),
                hundredths(ranked.measured.map(|m| m.factor)),
            ),
        ]
    });
    for row in &mut rows {
        row.cells.insert(0, String::new());
    }
    (columns, rows)
}
