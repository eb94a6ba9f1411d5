//! The lines of an axis as a table.

use std::fmt::Write as _;

use eframe::egui::Ui;

use crate::{
    app::photograph::Photograph,
    languages::with_sign,
    ui::{
        kit::{Column, Row, table, titled},
        theme::Theme,
    },
};

/// The lines with what each is off by; nothing without an axis by lines.
pub(super) fn show(ui: &mut Ui, found: &Photograph, theme: Theme) {
    let rows = rows(found);
    if rows.is_empty() {
        return;
    }
    ui.add_space(8.0);
    titled(
        ui,
        said!("Lines"),
        said!("Copy the lines as CSV"),
        "",
        || csv(&rows),
    );
    let columns = [
        Column::numbers("nm", said!("Wavelength of the lamp's line."), 62.0),
        Column::numbers("px", said!("Column of the strip."), 56.0),
        Column::numbers(said!("error"), said!("Error of the axis there, nm."), 56.0),
        Column::numbers(
            said!("width"),
            said!("Full width at half height, nm."),
            50.0,
        ),
        Column::words("", said!("A line whose top is over-exposed."), 60.0),
    ];
    let rows: Vec<Row> = rows
        .into_iter()
        .map(|cells| Row::of(cells.map(with_sign).to_vec()))
        .collect();
    table(ui, &columns, &rows, None, false, theme);
}

fn rows(found: &Photograph) -> Vec<[String; 5]> {
    let best = found
        .answer
        .as_ref()
        .and_then(|answer| answer.best.as_ref());
    let Some(best) = best.filter(|_| found.is_by_lines()) else {
        return Vec::new();
    };
    let peaks = &found.peaks().peaks;
    let mut lines: Vec<_> = best.matches.iter().collect();
    lines.sort_by(|a, b| a.landmark.nm.total_cmp(&b.landmark.nm));
    let row = |line: &crate::photographs::axis::Match| {
        let peak = peaks[line.peak];
        let clipped = if peak.is_clipped {
            said!("clipped")
        } else {
            ""
        };
        [
            format!("{:.1}", line.landmark.nm),
            format!("{:.1}", peak.px),
            // Never a minus before nothing.
            format!("{:+.2}", (100.0 * line.error_nm).round() / 100.0 + 0.0),
            format!("{:.1}", peak.fwhm_px * best.curve.slope(peak.px).abs()),
            clipped.to_owned(),
        ]
    };
    lines.into_iter().map(row).collect()
}

fn csv(rows: &[[String; 5]]) -> String {
    let mut text = "nm,px,error_nm,width_nm,clipped\n".to_owned();
    for [nm, px, error, width, clipped] in rows {
        let clipped = u8::from(!clipped.is_empty());
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{nm},{px},{error},{width},{clipped}");
    }
    text
}
