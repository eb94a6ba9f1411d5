//! The claims as a table, and as CSV.

use std::fmt::Write as _;

use super::{
    Claims,
    row::Row,
    rows::{eq_7_row, eq_17_row, five_percent_row, resampling_row, samples_row, table_2_row},
};
use crate::{
    app::{
        cells::{line, words},
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

/// The table as CSV: comment lines that say where it comes from, then
/// `claim,paper,measured,verdict`.
pub fn truth_csv(app: &App, claims: &Claims) -> String {
    let mut out = table_head(app);
    if let Some(factor) = &claims.factor {
        // Writing to a String cannot fail.
        let _ = writeln!(
            out,
            "# products: {} x {}",
            one_line(&claims.light),
            one_line(factor)
        );
    }
    out.push_str("claim,paper,measured,verdict\n");
    for row in truth_table(claims) {
        let paper = format!("{} ({})", row.paper, row.place);
        let cells = [row.claim, &paper, &row.measured, &row.verdict_words()].map(words);
        out.push_str(&line(cells));
    }
    out
}
