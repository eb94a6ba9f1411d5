//! Pairs of surfaces that were found in the library, as rows and columns of a table.

use crate::{
    app::studies::Pairs,
    languages::fixed,
    study::products::MetamericPair,
    ui::kit::{Column, Row},
};

/// Found pairs as rows.
pub(super) fn rows(pairs: &Pairs) -> Vec<Row> {
    let row = |found: &MetamericPair| {
        let [one, other] = found.pair.map(|i| &pairs.surfaces[i]);
        let [first, second] = found.delta_e_2000;
        Row {
            name: tr!(
                "Pair: {one} and {other}, {first} under the first light, {second} under the second",
                one = one.words(),
                other = other.words(),
                first = fixed(first, 2),
                second = fixed(second, 2)
            ),
            note: tr!(
                "{one} and {other}\nΔE₀₀ {first} under the first light, {second} under the second; \
                 the curves differ by {difference} (root mean square).\nClick to see both.",
                one = one.key,
                other = other.key,
                first = fixed(first, 3),
                second = fixed(second, 3),
                difference = fixed(found.rms, 3)
            ),
            cells: vec![
                format!("{} · {}", one.words(), other.words()),
                String::new(),
                fixed(first, 2),
                String::new(),
                fixed(second, 2),
            ],
            ..Row::default()
        }
    };
    pairs.metamers.pairs.iter().map(row).collect()
}

/// The columns of the found pairs under these lights.
pub(super) fn columns([first, second]: &[String; 2]) -> [Column; 5] {
    let under = |light: &str| tr!("The pair side by side under {light}.", light);
    let differ = |light: &str| {
        tr!(
            "CIEDE2000 under {light}; the pairs that part most stand first.",
            light
        )
    };
    [
        Column::words(said!("surfaces"), said!("Click a row to see both."), 0.50),
        Column::words(said!("1st light"), &under(first), 0.14),
        Column::words("ΔE₀₀", &differ(first), 0.11),
        Column::words(said!("2nd light"), &under(second), 0.14),
        Column::words("ΔE₀₀", &differ(second), 0.11),
    ]
}
