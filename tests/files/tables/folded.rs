//! Curves that were printed in several columns, and columns that are spectra of their own.

use crate::told::read;

/// A table of a lamp in rows of `count` values: of one curve, or of readings that drift by 1 %
/// from column to column.
fn table(titles: &str, count: u32, drifts: bool) -> String {
    let lamp = |nm: u32| 1e-3 * (f64::from(nm) / 150.0).exp();
    let row = |row: u32| {
        let nm = 380 + count * row;
        let value = |at: u32| match drifts {
            true => lamp(nm) * (1.0 + 0.01 * f64::from(at)),
            false => lamp(nm + at),
        };
        let values: String = (0..count).map(|at| format!(",{:.6}", value(at))).collect();
        format!("{nm}{values}\n")
    };
    titles.to_owned() + &(0..30).map(row).collect::<String>()
}

#[test]
fn rows_of_one_curve_are_one_spectrum_and_readings_that_drift_are_several() {
    for (titles, count, drifts, spectra) in [
        ("", 5, false, 1),
        ("nm,0,1,2,3,4\n", 5, false, 1),
        ("", 5, true, 5),
        ("nm,0,1,2,3,4\n", 5, true, 5),
        ("nm,0,1,2\n", 3, false, 3),
        ("nm,0,1,2\n", 3, true, 3),
    ] {
        let text = table(titles, count, drifts);
        let reading = read("a.csv", text);
        let found = reading.spectra.len();
        assert_eq!(found, spectra, "{titles:?} {drifts}: {:?}", reading.notes);
    }
}

#[test]
fn columns_side_by_side_are_one_spectrum_only_where_value_and_slope_agree() {
    let edge = |nm: f64, at: f64| 0.9 / (1.0 + ((at - nm) / 12.0).exp()) + 0.05;
    let band = |nm: f64, at: f64| (-((nm - at) / 15.0).powi(2)).exp();
    let table = |rows: [i32; 2], value: &dyn Fn(usize, f64) -> f64| {
        let cells = |of: usize, at: i32| {
            let nm = 380.0 + f64::from(5 * (at + rows[0] * of as i32));
            let cells = format!("{nm},{:.4}", value(of, nm));
            if at < rows[of] { cells } else { ",".to_owned() }
        };
        let rows = (0..rows[0]).map(|at| format!("{},{}\n", cells(0, at), cells(1, at)));
        "nm,T,nm,T\n".to_owned() + &rows.collect::<String>()
    };
    for (text, spectra) in [
        (table([40, 40], &|_: usize, nm: f64| edge(nm, 570.0)), 1),
        (table([40, 39], &|_: usize, nm: f64| edge(nm, 570.0)), 1),
        (table([40, 30], &|_: usize, nm: f64| edge(nm, 570.0)), 2),
        // Edges at 500 and 650 nm, two bands, and one that rises where the other falls.
        (
            table([40, 40], &|of: usize, nm: f64| {
                edge(nm, 500.0 + 150.0 * of as f64)
            }),
            2,
        ),
        (
            table([40, 40], &|of: usize, nm: f64| {
                band(nm, 480.0 + 200.0 * of as f64)
            }),
            2,
        ),
        (
            table([40, 40], &|_: usize, nm: f64| {
                0.2 + (nm - 577.5).abs() / 400.0
            }),
            2,
        ),
    ] {
        let reading = read("a.csv", text);
        assert_eq!(reading.spectra.len(), spectra, "{:?}", reading.notes);
    }
}
