//! The part "Resampling" of the page "Products": one product formed in every way.

mod eq_17;

use std::sync::Arc;

use eframe::egui;
use egui::{Rect, RichText, Ui, vec2};

use super::{surface_chooser, take_way};
use crate::{
    app::{
        Memo,
        chart::{Chart, Ink},
        charts::products::resampling::{Bench, time_of, way_meaning, way_name},
        headlines,
        numbers::{delta_e, hundredths},
        studies::{Stage, TimingAsk},
    },
    io::many::numbers,
    languages::{fixed, said},
    spectrum::Sampling,
    study::products::{Formed, ProductTime, timing},
    ui::{
        kit::{
            Column, GROUP, Row, Table, headline, line, pressed_small, scrolled, titled, two_columns,
        },
        pages::{PageContext, progress},
        theme::Theme,
    },
};

/// From this width on the tables stand beside the chart, points.
const WIDE: f32 = 1040.0;

/// What people and tests call the controls.
pub mod names {
    pub const FACTOR: &str = later!("Filter or surface");
    pub const COPY: &str = later!("Copy as CSV");
    pub const COPY_SPIKES: &str = later!("Copy lines as CSV");
    pub const AGAIN: &str = later!("Measure again");
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct ResamplingView {
    bench: Memo<u64, Bench>,
    chart: Memo<(u64, Vec<Sampling>), Chart>,
    /// How often the times were asked for.
    turn: u32,
}

impl ResamplingView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, revision) = (context.app, context.app.revision());
        let chosen = app.document().products.surface.clone();
        let words = match &chosen {
            Some(factor) => {
                headlines::resampling(self.bench.get(revision, |_| Bench::of(app, factor)))
            }
            None => said!("Choose what the light is multiplied by.").to_owned(),
        };
        headline(ui, context.theme, words);
        ui.add_space(GROUP);
        ui.horizontal_wrapped(|ui| {
            surface_chooser(ui, context, said(names::FACTOR));
            if let Some(bench) = self.bench.held().filter(|_| chosen.is_some()) {
                ui.weak(match bench.sizes.spikes {
                    0 => tr!(
                        "{light} in {numbers}",
                        light = bench.light,
                        numbers = numbers(bench.sizes.numbers)
                    ),
                    spikes => tr!(
                        "{light} in {numbers} and {n} line"
                            | "{light} in {numbers} and {n} lines" % spikes,
                        light = bench.light,
                        numbers = numbers(bench.sizes.numbers)
                    ),
                });
            }
        });
        let Some(factor) = chosen else {
            return;
        };
        let bench = &*self.bench.get(revision, |_| Bench::of(app, &factor));
        let times = times(context, bench, self.turn);
        shown_ways(ui, context);
        let hidden = context.pages.resampling.hidden.clone();
        let key = (revision, hidden);
        let chart = &*self.chart.get(key, |(_, hidden)| bench.chart(app, hidden));
        let room = ui.available_size();
        let scale = context.theme.scale;
        let mut asked_again = false;
        let times = times.as_ref().map(|times| times.as_slice());
        let mut tables = |ui: &mut Ui, context: &mut PageContext<'_>| {
            asked_again = figures(ui, context, bench, times);
            eq_17::show(ui, context, bench);
        };
        scrolled(ui, "resampling", |ui| {
            let width = ui.available_width();
            if width >= WIDE * scale {
                let left = |ui: &mut Ui, context: &mut PageContext<'_>| {
                    let width = ui.available_width();
                    let height = (room.y - 8.0).max(380.0 * scale).min(1.25 * width);
                    context.chart(ui, chart, "resampling", vec2(width, height));
                };
                two_columns(ui, context, left, tables);
            } else {
                let height = (0.5 * room.y).clamp(290.0 * scale, 460.0 * scale);
                context.chart(ui, chart, "resampling", vec2(width, height));
                tables(ui, context);
            }
        });
        if asked_again {
            self.turn = self.turn.wrapping_add(1);
        }
    }
}

/// The times of products of this size, measured when nobody did yet.
fn times(context: &mut PageContext<'_>, bench: &Bench, turn: u32) -> Option<Arc<Vec<ProductTime>>> {
    // Times change from run to run: a picture does without.
    if context.quiet {
        return None;
    }
    let ask = TimingAsk {
        sizes: bench.sizes,
        turn,
    };
    let (of, times) = context.put(&ask).answer()?;
    (of.sizes == ask.sizes).then(|| times.clone())
}

/// Which ways have curves.
fn shown_ways(ui: &mut Ui, context: &mut PageContext<'_>) {
    let memory = &mut context.pages.resampling;
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Show"));
        for way in Sampling::ALL {
            // At 1 nm nothing is formed from series.
            if way == Sampling::Exact {
                continue;
            }
            let mut shown = !memory.hidden.contains(&way);
            if ui
                .checkbox(&mut shown, way_name(way))
                .on_hover_text(way_meaning(way))
                .changed()
            {
                memory.show(way, shown);
            }
        }
    });
}

/// The table of the ways, and how its times came about; whether they are wanted again.
fn figures(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    bench: &Bench,
    times: Option<&[ProductTime]>,
) -> bool {
    let (app, theme) = (context.app, context.theme);
    ui.add_space(4.0);
    titled(
        ui,
        said!("The same product by every way"),
        said(names::COPY),
        said!("Copies the ways and their figures as a table."),
        || bench.table(app, times).csv(),
    );
    let ways = &bench.resampled.ways;
    let rows: Vec<Row> = ways.iter().map(|way| row(way, times)).collect();
    let settings = app.document().settings;
    let chosen = ways
        .iter()
        .position(|way| way.sampling == settings.sampling);
    let shares: Vec<f64> = ways.iter().map(|way| way.step.folded_share).collect();
    let mut meter = |ui: &Ui, [row, column]: [usize; 2], cell: Rect| {
        if column == FOLDED {
            alias_meter(ui, cell, shares[row], theme);
        }
    };
    let columns = columns();
    let table = Table {
        chosen,
        ..Table::new(&columns, theme)
    };
    let clicked = table.show(ui, &rows, &mut meter);
    if let Some(way) = clicked.and_then(|row| ways.get(row)) {
        take_way(context, way.sampling);
    }
    ui.add_space(2.0);
    if !bench.has_colour() {
        ui.weak(said!(
            "There is no visible light in this range, so there is no colour to be off by."
        ));
    }
    times_row(ui, context, times)
}

/// The column of the alias meter.
const FOLDED: usize = 4;

fn columns() -> Vec<Column> {
    vec![
        Column::words(
            said!("way"),
            said!("Way of forming the product. Click a row to form all products so."),
            2.3,
        ),
        Column::numbers(
            said!("points"),
            said!("Independent points, one multiplication each."),
            0.8,
        ),
        Column::numbers(
            said!("ΔE₀₀ total"),
            said!(
                "CIEDE2000 of the model's product against measured light times measured surface; \
                 the white is the light."
            ),
            1.25,
        ),
        Column::numbers(
            said!("added"),
            said!(
                "CIEDE2000 against the exact product of the very same series: the part that \
                 forming it adds."
            ),
            1.3,
        ),
        Column::numbers(
            said!("folded"),
            said!(
                "Alias meter: share of the product's power in waves that the points fold back, or \
                 that the convolution cuts off. The bar is logarithmic, from 0.0001 % to 100 %."
            ),
            1.95,
        ),
        Column::numbers(
            said!("mult."),
            said!(
                "Multiplications of one product: one a point, or one a pair of numbers, and one a \
                 line."
            ),
            0.8,
        ),
        Column::numbers(
            "ns",
            said!("Nanoseconds of one product, measured here and now: the median batch."),
            0.85,
        ),
    ]
}

fn row(way: &Formed, times: Option<&[ProductTime]>) -> Row {
    let step = &way.step;
    let time = time_of(times, way.sampling);
    let cells = vec![
        way_name(way.sampling).to_owned(),
        way.points.map_or_else(|| "–".to_owned(), |p| p.to_string()),
        delta_e(step.colours.delta_e_2000),
        match step.added {
            Some(0.0) => "0".to_owned(),
            added => delta_e(added),
        },
        share_words(step.folded_share),
        step.multiplications.to_string(),
        time.map_or_else(|| "–".to_owned(), |time| whole(time.ns)),
    ];
    let range = time.map_or_else(String::new, |time| {
        tr!(
            "\nMedian {median} ns, batches from {least} to {most} ns.",
            median = whole(time.ns),
            least = whole(time.range_ns[0]),
            most = whole(time.range_ns[1])
        )
    });
    Row {
        name: tr!(
            "{way}: ΔE₀₀ {total}, added {added}, folded {folded}",
            way = way_name(way.sampling),
            total = cells[2],
            added = cells[3],
            folded = cells[4]
        ),
        note: tr!(
            "{meaning}\nClick to form all products so.",
            meaning = format!("{}{range}", way_meaning(way.sampling))
        ),
        cells,
        ..Row::default()
    }
}

/// Nanoseconds in few digits.
fn whole(ns: f64) -> String {
    if ns < 10.0 {
        fixed(ns, 1)
    } else {
        fixed(ns, 0)
    }
}

/// Shares below this are rounding, or nothing to speak of.
const LEAST_SHARE: f64 = 1e-6;

fn share_words(share: f64) -> String {
    if !share.is_finite() {
        return "–".to_owned();
    }
    if share <= 0.0 {
        return "0 %".to_owned();
    }
    format!("{} %", hundredths(100.0 * share))
}

/// Part of its cell that the meter's bar takes.
const BAR: f32 = 0.36;

/// A bar for a share, logarithmic from [`LEAST_SHARE`] to everything.
fn alias_meter(ui: &Ui, cell: Rect, share: f64, theme: Theme) {
    let height = 6.0 * theme.scale;
    let track = Rect::from_min_size(
        egui::pos2(cell.left(), cell.center().y - height / 2.0),
        vec2(BAR * cell.width(), height),
    );
    let painter = ui.painter();
    painter.rect_filled(track, 2.0, ui.visuals().widgets.inactive.bg_fill);
    if !(share > LEAST_SHARE && share.is_finite()) {
        return;
    }
    let part = 1.0 - (share.min(1.0).log10() / LEAST_SHARE.log10()) as f32;
    let full = Rect::from_min_size(track.min, vec2(part * track.width(), height));
    painter.rect_filled(full, 2.0, theme.ink(Ink::Spikes));
}

/// How the times were measured, and the button to do so again.
fn times_row(ui: &mut Ui, context: &mut PageContext<'_>, times: Option<&[ProductTime]>) -> bool {
    if context.quiet {
        ui.weak(said!(
            "Times are measured in the window; a picture leaves them out."
        ));
        return false;
    }
    let mut again = false;
    line(ui, |ui| {
        let job = context.studies.of::<TimingAsk>();
        if job.stage() != Stage::Done {
            progress(ui, job, said!("Time of a product"));
            return;
        }
        let meaning =
            said!("Measures the times of all ways once more, for about a tenth of a second.");
        again = pressed_small(ui, said(names::AGAIN), meaning);
        if times.is_some() {
            ui.add(egui::Label::new(RichText::new(said(HOW_SHORT)).weak()).truncate())
                .on_hover_text(how());
        }
    });
    again
}

const HOW_SHORT: &str = later!("ns: one product in this process, values already on their points.");

fn how() -> String {
    tr!(
        "Measured by this program on this machine: the multiplications alone, with the values \
         already on their points and the surface already read at the lines, all in the cache, on \
         one thread. A convolution includes the memory for its result. After {warm_up} ms of \
         warm-up each way is timed in {batches} batches of at least {least} µs, the ways taking \
         turns; the median batch is told. Other work on the machine shows.",
        warm_up = timing::WARM_UP.as_millis(),
        batches = timing::BATCHES,
        least = timing::BATCH.as_micros()
    )
}
