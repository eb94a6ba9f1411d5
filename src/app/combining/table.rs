//! The result of a combination as tables: figures and lines with their doubt, scans, what differs.

use super::{
    result::{Found, LineRow, ScanRow},
    words::{change_words, figure_words, scan_words, with_half},
};
use crate::measurements::OF_95;
use crate::{
    app::{
        cells::{Columns, Table, cell, column},
        readings::names_of_lines,
    },
    languages,
    measurements::{Doubted, Part},
};

/// Most lines that are listed, the strongest ones.
const MOST_LINES: usize = 8;

const HALF_WIDTH: &str = later!("\u{b1} is the half width of the 95 % interval.");

/// The tables that have rows, each under its title.
pub fn tables(found: &Found) -> Vec<(&'static str, Table)> {
    let figures = found.figures().map(|(all, _)| all).unwrap_or_default();
    let mut all = Vec::new();
    if !figures.is_empty() {
        all.push((said!("Figures"), of_figures(&figures)));
    }
    if let Some((changed, names)) = &found.changed
        && !changed.parts.is_empty()
    {
        let named: Vec<(&String, &Part)> = names.iter().zip(&changed.parts).collect();
        all.push((said!("Differences"), of_parts(&named)));
    }
    if !found.lines.is_empty() {
        all.push((said!("Lines"), of_lines(found)));
    }
    if !found.scans.is_empty() {
        all.push((said!("Scans"), of_scans(&found.scans)));
    }
    all
}

fn of_figures(figures: &[Doubted]) -> Table {
    type Row<'a> = &'a Doubted;
    let half = |d: &Row<'_>| d.doubt.map(|doubt| doubt.half_width_95);
    let columns = Columns::<Row<'_>>::default()
        .with("figure", |d: &Row<'_>| cell(d.figure.words()))
        .titled(said!("figure"), "")
        .with("value", |d| {
            cell(d.doubt.map(|doubt| doubt.value)).shown(figure_words(d))
        })
        .titled(said!("value"), languages::said(HALF_WIDTH))
        .with("half_width_95", move |d| {
            cell(half(d).filter(|half| half.is_finite()))
        });
    Table::new("", columns, figures)
}

fn of_parts(parts: &[(&String, &Part)]) -> Table {
    type Row<'a> = &'a (&'a String, &'a Part);
    let columns = Columns::<Row<'_>>::default()
        .with("part", |(name, _): &Row<'_>| cell(name.as_str()))
        .titled(
            said!("part"),
            said!("A line by its name, or what lies below the lines."),
        )
        .with("change", |(_, part)| {
            cell(part.change).shown(change_words(part))
        })
        .titled(said!("change"), languages::said(HALF_WIDTH))
        .with("half_width_95", |(_, part)| cell(OF_95 * part.u));
    Table::new("", columns, parts)
}

/// The strongest lines in the order of their places, by name where they have one.
fn of_lines(found: &Found) -> Table {
    let mut lines: Vec<&LineRow> = found.lines.iter().collect();
    let weight = |line: &LineRow| line.weight.map_or(f64::INFINITY, f64::abs);
    lines.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    lines.truncate(MOST_LINES);
    lines.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
    let places: Vec<f64> = lines.iter().map(|line| line.at_nm).collect();
    let names = match &found.result {
        Some(result) => names_of_lines(&result.samples, &places),
        None => vec![None; lines.len()],
    };
    type Row<'a> = (Option<String>, &'a LineRow);
    let half = |u: Option<f64>| u.map(|u| OF_95 * u);
    let told = move |key: &'static str, k: usize, of: fn(&LineRow) -> Option<f64>| {
        column(key, move |(_, line): &Row<'_>| {
            let shown = of(line).map_or("\u{2013}".to_owned(), |v| with_half(v, half(line.u[k])));
            cell(of(line)).shown(shown)
        })
    };
    let halves = move |key: &'static str, k: usize| {
        column(key, move |(_, line): &Row<'_>| cell(half(line.u[k])))
    };
    let columns = Columns::<Row<'_>>::default()
        .with("line", |(name, line): &Row<'_>| {
            let shown = name.as_deref().unwrap_or("");
            cell(name.as_deref()).shown(match line.is_certain {
                true => shown.to_owned(),
                false => tr!("{name} (uncertain)", name = shown),
            })
        })
        .titled(said!("line"), said!("Its name, where an atom explains it."))
        .and(told("at_nm", 0, |line| Some(line.at_nm)))
        .titled("nm", languages::said(HALF_WIDTH))
        .and(halves("at_nm_half_width_95", 0))
        .and(told("weight", 1, |line| line.weight))
        .titled(
            said!("weight"),
            said!("Its power, or of a quotient the quotient there."),
        )
        .and(halves("weight_half_width_95", 1))
        .with("share", |(_, line)| {
            let shown = line
                .share
                .map(|share| format!("{} %", languages::fixed(100.0 * share, 1)));
            cell(line.share).shown(shown.unwrap_or_default())
        })
        .titled(said!("share"), said!("Its share of the power."));
    Table::new("", columns, names.into_iter().zip(lines))
}

fn of_scans(scans: &[ScanRow]) -> Table {
    type Row<'a> = &'a ScanRow;
    let columns = Columns::<Row<'_>>::default()
        .with("scan", |scan: &Row<'_>| cell(scan.name.as_str()))
        .titled(said!("scan"), "")
        .with("level", |scan| {
            cell(scan.level).shown(match &scan.why {
                Some(why) if !scan.is_kept => tr!("left out: {why}", why),
                _ => scan_words(scan),
            })
        })
        .titled(
            said!("beside the mean"),
            said!("Its level and its wavelengths."),
        )
        .with("shift_nm", |scan| cell(scan.shift_nm))
        .with("kept", |scan| cell(scan.is_kept));
    Table::new("", columns, scans)
}
