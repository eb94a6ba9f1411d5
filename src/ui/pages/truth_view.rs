//! The page "Truth": the paper's claims, each with what is measured here and what becomes of it.

use crate::languages::{Language, in_language};
use eframe::egui;
use egui::{Align, Grid, Layout, RichText, Ui, vec2};

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
    languages::{fixed, said},
    spectrum::{Basis, Sampling},
    ui::kit::{GROUP, framed, headline, pressed, scrolled, sign_button},
};

/// Widest row of words, points: longer lines are hard to read.
const WIDEST: f32 = 860.0;

/// Height of a claim's chart, points.
const CHART: f32 = 300.0;

/// Spikes that the table of Eq. 17 shows.
const MOST_SPIKES: usize = 8;

/// The button that copies everything.
pub const COPY: &str = later!("Copy as CSV");

pub struct TruthView {
    measured: Memo<u64, (Claims, Vec<Row>)>,
    charts: Memo<u64, Charts>,
    /// The claim that is unfolded.
    open: Option<usize>,
}

impl Default for TruthView {
    fn default() -> Self {
        Self {
            measured: Memo::default(),
            charts: Memo::default(),
            open: Some(FIRST_OPEN),
        }
    }
}

/// The claim that is unfolded at first: "Eleven numbers are enough".
const FIRST_OPEN: usize = 1;

/// The charts of the claims.
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
        headline(ui, context.theme, headlines::paper(&claims.subject, rows));
        ui.add_space(GROUP);
        let open = &mut self.open;
        scrolled(ui, "truth", |ui| {
            ui.set_max_width(ui.available_width().min(WIDEST * context.theme.scale));
            for (index, row) in rows.iter().enumerate() {
                claim(ui, context, (claims, charts), (index, row), open);
            }
            head(ui, context, claims);
        });
    }
}

fn head(ui: &mut Ui, context: &PageContext<'_>, claims: &Claims) {
    ui.horizontal_wrapped(|ui| {
        let meaning = said!("Copies claim, paper, measured and verdict of every card as a table.");
        if pressed(ui, said(COPY), meaning) {
            let table = || copied_table(context.app, claims).csv();
            ui.ctx().copy_text(in_language(Language::English, table));
        }
        ui.weak(match claims.basis {
            Basis::Fourier => tr!(
                "Measured on {subject}, {from}-{to} nm, Fourier basis, N = {order}.",
                subject = claims.subject,
                from = short(claims.band.min_nm()),
                to = short(claims.band.max_nm()),
                order = claims.order
            ),
            Basis::Cosine => tr!(
                "Measured on {subject}, {from}-{to} nm, cosine basis, N = {order}.",
                subject = claims.subject,
                from = short(claims.band.min_nm()),
                to = short(claims.band.max_nm()),
                order = claims.order
            ),
        });
    });
}

/// A claim in a row with its verdict; unfolded with what the paper says, what is measured here, and
/// its picture.
fn claim(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (claims, charts): (&Claims, &Charts),
    (index, row): (usize, &Row),
    open: &mut Option<usize>,
) {
    let is_open = *open == Some(index);
    framed(ui, |ui| {
        ui.horizontal(|ui| {
            let colour = match row.verdict {
                Verdict::Holds | Verdict::Open => ui.visuals().strong_text_color(),
                Verdict::OnlyIf | Verdict::Fails => context.theme.warning,
            };
            let sign = RichText::new(row.verdict.sign()).size(16.0 * context.theme.scale);
            ui.label(sign.color(colour));
            ui.label(RichText::new(row.claim).strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let says = if is_open {
                    said!("Hide")
                } else {
                    said!("Show")
                };
                let name = match is_open {
                    true => tr!("Hide {claim}", claim = row.claim),
                    false => tr!("Show {claim}", claim = row.claim),
                };
                let meaning = said!("The paper's words, and the measurement here.");
                if sign_button(ui, says, &name, meaning) {
                    *open = (!is_open).then_some(index);
                }
                let words = RichText::new(row.verdict_words()).color(colour);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.add(egui::Label::new(words).truncate());
                });
            });
        });
        if is_open {
            ui.add_space(4.0);
            let paper = tr!(
                "Paper ({place}): {words}",
                place = row.place,
                words = row.paper
            );
            ui.add(egui::Label::new(RichText::new(paper).weak()).wrap());
            if !row.measured.is_empty() {
                ui.add(egui::Label::new(tr!("Here: {measured}", measured = row.measured)).wrap());
            }
            if let Some(picture) = Picture::of(claims, charts, index) {
                ui.add_space(8.0);
                let size = [ui.available_width(), CHART * context.theme.scale];
                picture.draw(ui, context, claims, size);
            }
        }
    });
    ui.add_space(4.0);
}

/// What stands below a claim's words.
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
    Grid::new("surface at lines")
        .striped(true)
        .spacing([14.0, 3.0])
        .show(ui, |ui| {
            heads(
                ui,
                &[
                    (said!("at nm"), said!("The line's wavelength, nm.")),
                    (said!("measured"), said!("The surface as measured there.")),
                    (
                        said!("series"),
                        said!("The surface's series, evaluated exactly."),
                    ),
                    (
                        said!("corrected"),
                        said!("Eq. 17 with its two weights exchanged."),
                    ),
                    (
                        said!("as printed"),
                        said!("Eq. 17 with the weights as printed."),
                    ),
                ],
            );
            for reading in &readings {
                ui.label(fixed(reading.spike.at_nm, 1));
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
        ui.weak(tr!(
            "The {count} heaviest; {left} more.",
            count = readings.len(),
            left
        ));
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
                    (
                        said!("points"),
                        said!("Independent points, one multiplication each."),
                    ),
                    (said!("way"), said!("How they are counted.")),
                    (
                        said!("folded, %"),
                        said!("Share of the product's power that lands in wrong waves."),
                    ),
                    (
                        "ΔE₀₀",
                        said!("CIEDE2000 against the exact product of the same two series."),
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
        Sampling::Paper => said!("the paper's"),
        Sampling::ThreeN => "3N+1",
        Sampling::FourN => "4N+1",
        Sampling::Double => said!("twice the numbers"),
        Sampling::Convolution => said!("convolution, cut to N"),
        Sampling::Exact => "1 nm",
    }
}
