//! Every filter over the light, a row each, as a table.

use std::sync::Arc;

use super::{Behind, Figures, Filter, WAY_MEANINGS, WAYS};
use crate::{
    app::{
        App, Entry, Families,
        cells::{Columns, Table, cell},
        charts::spectrum::table_head,
        made::is_made,
        numbers::{delta_e, or_dash},
    },
    languages::{fixed, said},
    preset::Shelf,
    spectrum::Kind,
};

/// A filter of the table.
#[derive(Clone, Debug)]
pub struct FilterRow {
    /// The filter.
    pub entry: Arc<Entry>,
    /// What it leaves.
    pub figures: Figures,
}

impl Behind {
    /// Every transmittance of the user's own and every shipped filter: gels, then glasses.
    pub fn table(&self, app: &App) -> Vec<FilterRow> {
        let all = app.document().own.iter().chain(app.bundled());
        let mut filters: Vec<_> = all.filter(|entry| is_filter(entry)).collect();
        filters.sort_by_key(|entry| Families::shipped().place_of(&entry.key));
        let row = |entry: &Arc<Entry>| FilterRow {
            figures: self.figures(&Filter::Real(entry.clone())),
            entry: entry.clone(),
        };
        filters.into_iter().map(row).collect()
    }

    /// The filters as a table.
    pub fn filters_table(&self, app: &App, rows: &[FilterRow]) -> Table {
        let head = format!("# light: {}\n# numbers: {}\n", self.light, self.numbers());
        let mut columns = Columns::<&FilterRow>::default()
            .with("filter", |row| cell(row.entry.name()))
            .titled(
                said!("filter"),
                said!("Measured transmittance. Click a row to put it over the light."),
            )
            .with("luminance_share", |row| {
                let share = row.figures.luminance;
                cell(share).shown(or_dash(share, |share| {
                    format!("{} %", fixed(100.0 * share, 1))
                }))
            })
            .figures(
                said!("luminance"),
                said!(
                    "Y of the exact light behind the filter over that of the whole light, percent."
                ),
            );
        for (way, key) in ["composite", "series", "samples"].into_iter().enumerate() {
            let error = move |row: &&FilterRow| row.figures.ways[way].delta_e_2000;
            let meaning = format!("CIEDE2000. {}", said(WAY_MEANINGS[way]));
            columns = columns
                .with(format!("{key}_delta_e_2000"), move |row| {
                    cell(error(row)).shown(delta_e(error(row)))
                })
                .figures(said(WAYS[way]), meaning);
        }
        Table::new(table_head(head, app), columns, rows)
    }
}

/// Shipped filter glasses, and the user's own transmittances.
fn is_filter(entry: &Entry) -> bool {
    let is_glass = |shelf| shelf == Shelf::Filters && !is_made(&entry.key);
    entry.kind() == Kind::Transmittance && entry.shelf().is_none_or(is_glass)
}
