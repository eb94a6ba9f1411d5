//! The part "Resampling" of the page "Products": one product formed in every way.

use std::sync::Arc;

use eframe::egui;
use egui::{Align, Layout, Rect, RichText, ScrollArea, Ui, vec2};

use super::picker::{Picker, factors};
use crate::{
    app::{
        App, Command, Entry,
        chart::{self, Chart},
        charts::products::forming::{Bench, time_of, way_meaning, way_name},
        products::Products,
        studies::{
            Stage, TimingAsk,
            paper::{delta_e, figure},
        },
        ticks::short,
    },
    io::many::numbers,
    spectrum::Sampling,
    study::products::{Formed, ProductTime, timing},
    ui::{
        chart_view::ChartView,
        pages::{
            PageContext, progress,
            rows::{Column, Row, table, table_with},
        },
        theme::Theme,
    },
};

/// From this width on the tables stand beside the chart, points.
const WIDE: f32 = 1040.0;

/// What people and tests call the controls.
pub mod names {
    /// The list of factors.
    pub const FACTOR: &str = "Factor";
    /// Copies the ways.
    pub const COPY: &str = "Copy as CSV";
    /// Copies Eq. 17.
    pub const COPY_SPIKES: &str = "Copy spikes as CSV";
    /// Measures the times once more.
    pub const AGAIN: &str = "Measure again";
}

/// What the chart was built from.
#[derive(PartialEq)]
struct Of {
    revision: u64,
    hidden: Vec<Sampling>,
    theme: chart::Theme,
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct FormingView {
    bench: Option<(u64, Bench)>,
    chart: Option<(Of, Chart)>,
    /// How often the times were asked for.
    turn: u32,
}

impl FormingView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, revision) = (context.app, context.app.revision());
        let chosen = app.document().products.surface.clone();
        ui.horizontal_wrapped(|ui| {
            surface_picker(ui, context, names::FACTOR);
            if let Some((_, bench)) = self.bench.as_ref().filter(|_| chosen.is_some()) {
                ui.weak(format!(
                    "{} in {}{}",
                    bench.light,
                    numbers(bench.sizes.numbers),
                    match bench.sizes.spikes {
                        0 => String::new(),
                        1 => " and 1 spike".to_owned(),
                        many => format!(" and {many} spikes"),
                    }
                ));
            }
        });
        let Some(factor) = chosen else {
            ui.weak("Choose what the light is multiplied by.");
            return;
        };
        if self.bench.as_ref().is_none_or(|(of, _)| *of != revision) {
            self.bench = Some((revision, Bench::of(app, &factor)));
        }
        let Some((_, bench)) = &self.bench else {
            return;
        };
        let times = self.times(context, bench);
        shown_ways(ui, context);
        let hidden = &context.memory.products.forming.hidden;
        let of = Of {
            revision,
            hidden: hidden.clone(),
            theme: context.chart_theme(),
        };
        if self.chart.as_ref().is_none_or(|(known, _)| *known != of) {
            let chart = bench.chart(app, hidden, of.theme);
            self.chart = Some((of, chart));
        }
        let Some((_, chart)) = &self.chart else {
            return;
        };
        let room = ui.available_size();
        let scale = context.theme.scale;
        let mut asked_again = false;
        let times = times.as_ref().map(|times| times.as_slice());
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let width = ui.available_width() - 8.0;
            ui.set_max_width(width);
            if width >= WIDE * scale {
                ui.columns(2, |columns| {
                    let size = vec2(
                        columns[0].available_width(),
                        (room.y - 8.0).max(380.0 * scale),
                    );
                    let size = vec2(size.x, size.y.min(1.25 * size.x));
                    draw(&mut columns[0], context, chart, size);
                    asked_again = figures(&mut columns[1], context, bench, times);
                    eq_17(&mut columns[1], context, bench);
                });
            } else {
                let height = (0.5 * room.y).clamp(290.0 * scale, 460.0 * scale);
                draw(ui, context, chart, vec2(width, height));
                asked_again = figures(ui, context, bench, times);
                eq_17(ui, context, bench);
            }
        });
        if asked_again {
            self.turn = self.turn.wrapping_add(1);
        }
    }

    /// The times of products of this size, measured when nobody did yet.
    fn times(&self, context: &mut PageContext<'_>, bench: &Bench) -> Option<Arc<Vec<ProductTime>>> {
        // Times change from run to run: a picture does without.
        if context.quiet {
            return None;
        }
        let ask = TimingAsk {
            sizes: bench.sizes,
            turn: self.turn,
        };
        let job = &mut context.studies.timing;
        job.ask(&ask, context.wake, || {
            move |progress: &crate::study::Progress| ask.answer(progress)
        });
        let (of, times) = job.answer()?;
        (of.sizes == ask.sizes).then(|| times.clone())
    }
}

/// A list that changes the document's surface.
pub(super) fn surface_picker(ui: &mut Ui, context: &mut PageContext<'_>, name: &'static str) {
    let products = &context.app.document().products;
    let says = products
        .surface
        .as_ref()
        .map_or("none chosen", |e| e.name());
    ui.label(name);
    let picker = Picker {
        name,
        meaning: "The filter, glass or surface that the light is multiplied by; the parts \
                  Resampling, Bounces and Same surface? share it.",
        says,
        offers: factors,
        width: 220.0 * context.theme.scale,
    };
    if let Some(entry) = picker.show(ui, context.app) {
        take_surface(context, entry);
    }
}

fn take_surface(context: &mut PageContext<'_>, entry: Arc<Entry>) {
    let products = context.app.document().products.clone();
    context.commands.push(Command::Products(Products {
        surface: Some(entry),
        ..products
    }));
}

/// Which ways have curves.
fn shown_ways(ui: &mut Ui, context: &mut PageContext<'_>) {
    let memory = &mut context.memory.products.forming;
    ui.horizontal_wrapped(|ui| {
        ui.label("Show");
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

fn draw(ui: &mut Ui, context: &mut PageContext<'_>, chart: &Chart, size: egui::Vec2) {
    let shown = ChartView::show(ui, chart, "forming", size, context.theme);
    context.wishes.extend(shown.wish);
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
    head(
        ui,
        "The same product by every way",
        names::COPY,
        "Copies the ways and their figures as a table.",
        || bench.csv(app, times),
    );
    let ways = &bench.forming.ways;
    let rows: Vec<Row> = ways.iter().map(|way| row(way, times)).collect();
    let settings = app.document().settings;
    let chosen = ways
        .iter()
        .position(|way| way.sampling == settings.sampling);
    let shares: Vec<f64> = ways.iter().map(|way| way.step.folded_share).collect();
    let meter = |ui: &Ui, [row, column]: [usize; 2], cell: Rect| {
        if column == FOLDED {
            alias_meter(ui, cell, shares[row], theme);
        }
    };
    let mut clicked = None;
    ui.scope(|ui| {
        clicked = table_with(ui, &columns(), &rows, (chosen, true), theme, meter);
    });
    if let Some(way) = clicked.and_then(|row| ways.get(row)) {
        take_way(context, way.sampling);
    }
    ui.add_space(2.0);
    if !bench.has_colour() {
        ui.weak("There is no visible light in this range, so there is no colour to be off by.");
    }
    times_row(ui, context, times)
}

/// Takes a way of forming products as the document's.
pub(super) fn take_way(context: &mut PageContext<'_>, sampling: Sampling) {
    let mut settings = context.app.document().settings;
    settings.sampling = sampling;
    context.commands.push(Command::Edit(settings));
}

/// The column of the alias meter.
const FOLDED: usize = 4;

fn columns() -> Vec<Column> {
    vec![
        Column::words(
            "way",
            "How the product is formed. Click a row to form all products so.",
            2.3,
        ),
        Column::numbers(
            "points",
            "Independent points, one multiplication each.",
            0.8,
        ),
        Column::numbers(
            "ΔE00 total",
            "CIEDE2000 of the model's product against measured light times measured factor; the \
             white is the light.",
            1.25,
        ),
        Column::numbers(
            "added",
            "CIEDE2000 against the exact product of the very same series: what forming it adds.",
            1.3,
        ),
        Column::numbers(
            "folded",
            "Alias meter: share of the product's power in orders that the points fold back, or \
             that the convolution cuts off. The bar is logarithmic, from 0.0001 % to 100 %.",
            1.95,
        ),
        Column::numbers(
            "mult.",
            "Multiplications of one product: one a point, or one a pair of numbers, and one a \
             spike.",
            0.8,
        ),
        Column::numbers(
            "ns",
            "Nanoseconds of one product, measured here and now: the median batch.",
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
        format!(
            "\nMedian {} ns, batches from {} to {} ns.",
            whole(time.ns),
            whole(time.range_ns[0]),
            whole(time.range_ns[1])
        )
    });
    Row {
        name: format!(
            "{}: ΔE00 {}, added {}, folded {}",
            way_name(way.sampling),
            cells[2],
            cells[3],
            cells[4]
        ),
        note: format!(
            "{}{range}\nClick to form all products so.",
            way_meaning(way.sampling)
        ),
        cells,
    }
}

/// Nanoseconds in few digits.
fn whole(ns: f64) -> String {
    if ns < 10.0 {
        format!("{ns:.1}")
    } else {
        format!("{ns:.0}")
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
    if share < LEAST_SHARE {
        return "<0.0001 %".to_owned();
    }
    format!("{} %", figure(100.0 * share))
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
    painter.rect_filled(full, 2.0, crate::ui::theme::ink(theme.inks.spikes));
}

/// How the times were measured, and the button to do so again.
fn times_row(ui: &mut Ui, context: &mut PageContext<'_>, times: Option<&[ProductTime]>) -> bool {
    if context.quiet {
        ui.weak("Times are measured in the window; a picture leaves them out.");
        return false;
    }
    let mut again = false;
    let row = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_height(row.y);
        let job = &mut context.studies.timing;
        if job.stage() != Stage::Done {
            progress(ui, job, "Time of a product");
            return;
        }
        again = ui
            .small_button(names::AGAIN)
            .on_hover_text(
                "Measures the times of all ways once more, for about a tenth of a second.",
            )
            .clicked();
        if times.is_some() {
            ui.add(egui::Label::new(RichText::new(HOW_SHORT).weak()).truncate())
                .on_hover_text(how());
        }
    });
    again
}

const HOW_SHORT: &str = "ns: one product in this process, values already on their points.";

fn how() -> String {
    format!(
        "Measured by this program on this machine: the multiplications alone, with the values \
         already on their points and the factor already read at the spikes, all in the cache, on \
         one thread. A convolution includes the memory for its result. After {} ms of warm-up each \
         way is timed in {} batches of at least {} µs, the ways taking turns; the median batch is \
         told. Other work on the machine shows.",
        timing::WARM_UP.as_millis(),
        timing::BATCHES,
        timing::BATCH.as_micros(),
    )
}

/// A heading with a button that copies what is below.
pub(super) fn head(
    ui: &mut Ui,
    title: &str,
    copy: &str,
    meaning: &str,
    csv: impl FnOnce() -> String,
) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(title).strong());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let button = ui.small_button("Copy as CSV").on_hover_text(meaning);
            button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, copy));
            if button.clicked() {
                ui.ctx().copy_text(csv());
            }
        });
    });
}

/// Eq. 17 at the light's spikes.
fn eq_17(ui: &mut Ui, context: &PageContext<'_>, bench: &Bench) {
    ui.add_space(6.0);
    let app: &App = context.app;
    head(
        ui,
        "The factor at each spike, and what reading it so costs",
        names::COPY_SPIKES,
        "Copies Eq. 17 at every spike as a table.",
        || bench.spikes_csv(app),
    );
    let costs = &bench.spikes;
    if costs.each.is_empty() {
        ui.weak("This model has no spikes.");
        return;
    }
    ui.weak(
        "Costs are against the factor as measured: where the series is far off, a wrong reading \
         may come out nearer by chance. The page Truth compares with the series.",
    );
    let columns = [
        Column::numbers("at nm", "The spike's wavelength, nm.", 0.9),
        Column::numbers("measured", "The factor as measured there.", 1.1),
        Column::numbers(
            "series",
            "The factor's series evaluated exactly at the spike: what this program does.",
            1.0,
        ),
        Column::numbers("ΔE00", COST, 1.2),
        Column::numbers(
            "corrected",
            "Eq. 17 with its two weights exchanged: the straight line between two of the paper's \
             points.",
            1.3,
        ),
        Column::numbers("ΔE00", COST, 1.2),
        Column::numbers("as printed", "Eq. 17 with its weights as printed.", 1.2),
        Column::numbers("ΔE00", COST, 1.2),
    ];
    let mut rows: Vec<Row> = costs
        .each
        .iter()
        .map(|(reading, [series, corrected, printed])| {
            let at = format!("{:.1}", reading.spike.at_nm);
            Row {
                name: format!("Spike at {at} nm"),
                note: format!(
                    "Weight of the spike: {}.\n{COST}",
                    short(reading.spike.weight)
                ),
                cells: vec![
                    at,
                    figure(reading.measured),
                    figure(reading.series),
                    delta_e(*series),
                    figure(reading.linear),
                    delta_e(*corrected),
                    figure(reading.printed),
                    delta_e(*printed),
                ],
            }
        })
        .collect();
    let [series, corrected, printed] = costs.all;
    rows.push(Row {
        name: "All spikes".to_owned(),
        note: "All spikes read so at once.".to_owned(),
        cells: vec![
            "all".to_owned(),
            String::new(),
            String::new(),
            delta_e(series),
            String::new(),
            delta_e(corrected),
            String::new(),
            delta_e(printed),
        ],
    });
    let last = rows.len() - 1;
    ui.scope(|ui| table(ui, &columns, &rows, Some(last), false, context.theme));
}

const COST: &str =
    "CIEDE2000 against the same product with this spike weighed by the factor as measured there.";
