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
    languages::said,
    study::products::Sameness,
    ui::{
        kit::{self, Column, Row, Table, copy_button},
        pages::{PageContext, progress},
        swatch,
    },
};

/// The ranking as a table, kept until it is another.
pub(super) type LaidOut = Memo<ByAddress<Vec<Ranked>>, (Vec<Column>, Vec<Row>)>;

/// The ranking, within a height.
pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &SameSurfaceSheet,
    laid_out: &mut LaidOut,
    height: f32,
) {
    let answer = context.studies.of::<RankAsk>().answer();
    let ranked = answer.map(|(_, ranked)| ranked.clone());
    ui.horizontal_wrapped(|ui| {
        ui.strong(said!("The surfaces that explain it best"));
        copy_button(ui, said(names::COPY), "", || {
            let csv = |ranked: &Arc<Vec<Ranked>>| ranking(&sheet.names, ranked).csv();
            ranked.as_ref().map_or_else(String::new, csv)
        });
    });
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Among"));
        let meaning = said!("The surfaces that are tried: the chosen set, or everything shipped.");
        let everywhere = context.pages.same_surface.everywhere;
        context.pages.same_surface.everywhere =
            among(ui, context, said(names::AMONG), meaning, everywhere);
        let job = context.studies.of::<RankAsk>();
        if job.stage() != Stage::Done {
            progress(ui, job, said!("The ranking"));
        }
    });
    let Some(ranked) =
        ranked.filter(|_| context.studies.of::<RankAsk>().stage() != Stage::Impossible)
    else {
        return;
    };
    let count = |verdict: Sameness| ranked.iter().filter(|r| r.verdict == verdict).count();
    let (holding, open) = (count(Sameness::Holds), count(Sameness::Unknown));
    ui.label(match (open > 0, 3 * holding > ranked.len()) {
        (true, true) => tr!(
            "{holding} of {count} surfaces fit the model's numbers; {open} are undecided: this \
             light tells surfaces badly apart.",
            holding,
            count = ranked.len(),
            open
        ),
        (true, false) => tr!(
            "{holding} of {count} surfaces fit the model's numbers; {open} are undecided.",
            holding,
            count = ranked.len(),
            open
        ),
        (false, true) => tr!(
            "{holding} of {count} surfaces fit the model's numbers: this light tells surfaces \
             badly apart.",
            holding,
            count = ranked.len()
        ),
        (false, false) => tr!(
            "{holding} of {count} surfaces fit the model's numbers.",
            holding,
            count = ranked.len()
        ),
    });
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
        Column::words("", said!("Colour of the surface under the light."), 0.09),
    );
    let mut rows = kit::rows(&table, |i, cells| {
        let ranked = &ranked[i];
        let [name, residual] = [&cells[0], &cells[1]];
        [
            tr!(
                "{name}: residual {residual}, {verdict}",
                name,
                residual,
                verdict = said(ranked.verdict.told())
            ),
            tr!(
                "{surface}\nTimes {modelled} in the model's numbers, {measured} measured.\nClick \
                 to take it as the surface S2.",
                surface = ranked.key,
                modelled = hundredths(ranked.model.map(|m| m.factor)),
                measured = hundredths(ranked.measured.map(|m| m.factor))
            ),
        ]
    });
    for row in &mut rows {
        row.cells.insert(0, String::new());
    }
    (columns, rows)
}
