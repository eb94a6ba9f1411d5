//! The claims as a table.

use super::{
    Claims,
    row::Row,
    rows::{eq_7_row, eq_17_row, five_percent_row, resampling_row, samples_row, table_2_row},
};
use crate::{
    app::{
        cells::{Columns, Table, cell},
        export::table_head,
        state::App,
    },
    io::one_line,
};

/// Every claim as a row, in the paper's order.
pub fn truth_table(claims: &Claims) -> Vec<Row> {
    vec![
        eq_7_row(claims),
        five_percent_row(claims),
        table_2_row(claims),
        resampling_row(claims),
        eq_17_row(claims),
        samples_row(claims),
    ]
}

/// The claims as the table that is copied.
pub fn copied_table(app: &App, claims: &Claims) -> Table {
    let products = claims.factor.as_ref().map(|factor| {
        let [light, factor] = [&claims.light, factor].map(|name| one_line(name));
        format!("# products: {light} x {factor}\n")
    });
    let columns = Columns::<Row>::default()
        .with("claim", |row| cell(row.claim))
        .with("paper", |row| {
            cell(format!("{} ({})", row.paper, row.place))
        })
        .with("measured", |row| cell(row.measured.as_str()))
        .with("verdict", |row| cell(row.verdict_words()));
    let comments = table_head(app) + &products.unwrap_or_default();
    Table::new(comments, columns, truth_table(claims))
}
