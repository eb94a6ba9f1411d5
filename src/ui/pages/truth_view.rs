//! The page "Truth": the paper's claims, each with what is measured here and what becomes of it.

use eframe::egui;
use egui::{Grid, RichText, Ui, vec2};

use super::PageContext;
use crate::{
    app::{
        Memo,
        chart::Chart,
        charts::truth::{neglected_chart, samples_chart, table_2_chart},
        headlines,
        numbers::{delta_e, figure, percent},
        studies::paper::{Claims, Row, Verdict, copied_table, truth_table},
        ticks::short,
    },
    spectrum::Sampling,
    ui::kit::{framed, headline, pressed, scrolled},
};

/// From this width on cards stand in two columns, points.
const TWO_COLUMNS: f32 = 940.0;

/// From this width on a card has its chart beside its words, points.
const BESIDE: f32 = 480.0;

/// Height of a card's chart, points, and that in a window with room to spare.
const CHART: f32 = 210.0;
const TALL_CHART: f32 = 280.0;

/// From this height on there is room to spare, points.
const TALL: f32 = 850.0;

/// Spikes that the table of Eq. 17 shows.
const MOST_SPIKES: usize = 8;

/// The button that copies everything.
pub const COPY: &str = "Copy as CSV";

#[derive(Default)]
pub struct TruthView {
    measured: Memo<u64, (Claims, Vec<Row>)>,
    charts: Memo<u64, Charts>,
}

/// The charts of the cards.
struct Charts {
    neglected: Option<Chart>,
    table_2: Option<Chart>,
    samples: Option<Chart>,
}

impl TruthView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, revision) = (context.app, context.app.revision());
        let (claims, rows) = &*self.measured.get(revision, |_| {
            let claims = Claims::of(app);
            let rows = truth_table(&claims);
            (claims, rows)
        });
        let drawn = revision;
        let charts = &*self.charts.get(drawn, |_| Charts {
            neglected: neglected_chart(app, claims),
            table_2: table_2_chart(app, claims),
            samples: samples_chart(app, claims),
        });
        let tall = ui.available_height() >= TALL * context.theme.scale;
        let chart_height = context.theme.scale * if tall { TALL_CHART } else { CHART };
        headline(ui, context.theme, headlines::paper(&claims.subject, rows));
        head(ui, context, claims);
        scrolled(ui, "truth", |ui| {
            if ui.available_width() < TWO_COLUMNS * context.theme.scale {
                for (index, row) in rows.iter().enumerate() {
                    card(ui, context, claims, charts, (index, row), chart_height);
                }
                return;
            }
            ui.columns(2, |columns| {
                for (index, row) in rows.iter().enumerate() {
                    card(
                        &mut columns[index % 2],
                        context,
                        claims,
                        charts,
                        (index, row),
                        chart_height,
                    );
                }
            });
        });
    }
}

fn head(ui: &mut Ui, context: &PageContext<'_>, claims: &Claims) {
    ui.horizontal_wrapped(|ui| {
        let meaning = "Copies claim, paper, measured and verdict of every card as a table.";
        if pressed(ui, COPY, meaning) {
            ui.ctx().copy_text(copied_table(context.app, claims).csv());
        }
        ui.weak(format!(
            "Measured on {}, {}-{} nm, {} basis, N = {}.",
            claims.subject,
            short(claims.band.min_nm()),
            short(claims.band.max_nm()),
            claims.basis.name(),
            claims.order,
        ));
    });
}

fn card(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    claims: &Claims,
    charts: &Charts,
    (index, row): (usize, &Row),
    height: f32,
) {
    let picture = Picture::of(claims, charts, index);
    framed(ui, |ui| {
        let width = ui.available_width();
        let beside = width >= BESIDE * context.theme.scale;
        if picture.is_none() || !beside {
            words(ui, context, row);
            if let Some(picture) = picture {
                ui.add_space(4.0);
                picture.draw(ui, context, claims, [width, height]);
            }
            return;
        }
        ui.horizontal_top(|ui| {
            let left = (0.46 * width).floor();
            ui.vertical(|ui| {
                ui.set_width(left);
                words(ui, context, row);
            });
            ui.add_space(8.0);
            let gaps = 8.0 + 3.0 * ui.spacing().item_spacing.x;
            let right = ui.available_width().min(width - left - gaps);
            ui.vertical(|ui| {
                ui.set_width(right);
                if let Some(picture) = picture {
                    picture.draw(ui, context, claims, [right, height]);
                }
            });
        });
    });
    ui.add_space(4.0);
}

fn words(ui: &mut Ui, context: &PageContext<'_>, row: &Row) {
    ui.add(egui::Label::new(RichText::new(row.claim).heading()).wrap());
    let verdict = format!("{} {}", row.verdict.sign(), row.verdict_words());
    let colour = match row.verdict {
        Verdict::Holds | Verdict::Open => ui.visuals().strong_text_color(),
        Verdict::OnlyIf | Verdict::Fails => context.theme.warning,
    };
    ui.add(egui::Label::new(RichText::new(verdict).color(colour)).wrap());
    ui.add_space(2.0);
    ui.add(egui::Label::new(RichText::new(format!("Paper: {}", row.paper)).italics()).wrap())
        .on_hover_text(format!("In the paper: {}.", row.place));
    if !row.measured.is_empty() {
        ui.add(egui::Label::new(format!("Here: {}", row.measured)).wrap());
    }
}

/// What stands beside a card's words.
enum Picture<'a> {
    Chart(&'a Chart, &'static str),
    Spikes,
    Points,
}

impl<'a> Picture<'a> {
    fn of(claims: &Claims, charts: &'a Charts, index: usize) -> Option<Self> {
        let chart = |chart: &'a Option<Chart>, id| Some(Self::Chart(chart.as_ref()?, id));
        match index {
            1 => chart(&charts.neglected, "neglected"),
            2 => chart(&charts.table_2, "table 2"),
            3 => claims
                .resampling
                .as_ref()
                .filter(|r| !r.ways.is_empty() && !claims.light_is_dark)
                .map(|_| Self::Points),
            4 => claims
                .eq_17
                .as_ref()
                .filter(|found| !found.readings.is_empty())
                .map(|_| Self::Spikes),
            5 => chart(&charts.samples, "samples"),
            _ => None,
        }
    }

    fn draw(
        &self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        claims: &Claims,
        [width, height]: [f32; 2],
    ) {
        match self {
            Self::Chart(chart, id) => {
                let size = vec2(width, height);
                context.chart(ui, chart, ("truth", *id), size);
            }
            Self::Spikes => spikes(ui, claims),
            Self::Points => points(ui, claims),
        }
    }
}

fn heads(ui: &mut Ui, heads: &[(&str, &str)]) {
    for (name, meaning) in heads {
        ui.label(RichText::new(*name).strong().small())
            .on_hover_text(*meaning);
    }
    ui.end_row();
}

/// Eq. 17 at each spike.
fn spikes(ui: &mut Ui, claims: &Claims) {
    let Some(found) = &claims.eq_17 else {
        return;
    };
    let mut readings: Vec<_> = found.readings.iter().collect();
    readings.sort_by(|a, b| b.spike.weight.abs().total_cmp(&a.spike.weight.abs()));
    readings.truncate(MOST_SPIKES);
    readings.sort_by(|a, b| a.spike.at_nm.total_cmp(&b.spike.at_nm));
    Grid::new("factor at spikes")
        .striped(true)
        .spacing([14.0, 3.0])
        .show(ui, |ui| {
            heads(
                ui,
                &[
                    ("at nm", "The spike's wavelength, nm."),
                    ("measured", "The factor as measured there."),
                    ("series", "The factor's series, evaluated exactly."),
                    ("corrected", "Eq. 17 with its two weights exchanged."),
                    ("as printed", "Eq. 17 with the weights as printed."),
                ],
            );
            for reading in &readings {
                ui.label(format!("{:.1}", reading.spike.at_nm));
                for value in [
                    reading.measured,
                    reading.series,
                    reading.linear,
                    reading.printed,
                ] {
                    ui.label(figure(value));
                }
                ui.end_row();
            }
        });
    let left = found.readings.len() - readings.len();
    if left > 0 {
        ui.weak(format!("The {} heaviest; {left} more.", readings.len()));
    }
}

/// The product on each number of points.
fn points(ui: &mut Ui, claims: &Claims) {
    let Some(found) = &claims.resampling else {
        return;
    };
    Grid::new("points of a product")
        .striped(true)
        .spacing([9.0, 3.0])
        .show(ui, |ui| {
            heads(
                ui,
                &[
                    ("points", "Independent points, one multiplication each."),
                    ("way", "How they are counted."),
                    (
                        "folded, %",
                        "Share of the product's power that lands in wrong orders.",
                    ),
                    (
                        "ΔE₀₀",
                        "CIEDE2000 against the exact product of the same two series.",
                    ),
                ],
            );
            for way in &found.ways {
                ui.label(way.points.to_string());
                ui.label(way_name(way.sampling));
                ui.label(percent(way.folded_share));
                ui.label(delta_e(way.delta_e_2000));
                ui.end_row();
            }
        });
}

/// A way of forming a product, short.
fn way_name(sampling: Sampling) -> &'static str {
    match sampling {
        Sampling::Paper => "the paper's",
        Sampling::ThreeN => "3N+1",
        Sampling::FourN => "4N+1",
        Sampling::Double => "twice the numbers",
        Sampling::Convolution => "convolution, cut to N",
        Sampling::Exact => "1 nm",
    }
}
