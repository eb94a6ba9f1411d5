//! The page "Coefficients": the light's numbers beside those of the eye, and sums that grow.

mod words;

use crate::ui::kit::slide;
use eframe::egui;
use egui::{Ui, Vec2, vec2};

use super::PageContext;
use crate::{
    app::{
        CURVE_ORDER, Command, Memo, Settings,
        chart::Chart,
        charts::coefficients::{CoefficientCharts, Sight},
        combining::words::with_half,
        half_widths_of_numbers,
        numbers::{figure, percent},
        studies::paper::{CHANNELS, colours_summed, harmonics_of, off_percent},
    },
    io::many::numbers,
    languages::{fixed, said},
    spectrum::numbers_of_order,
    study::harmonics::Harmonics,
    ui::{
        chart_view::ChartResponse,
        kit::{GROUP, down, fold, headline, pressed, scrolled},
        swatch,
    },
};

/// Time between two orders while playing, s.
const STEP_SECONDS: f64 = 0.5;

/// From this width on charts stand side by side, points.
const BESIDE: f32 = 640.0;

/// Part of the width for the sum.
const PARTIAL: f32 = 0.58;

/// Least height of the sum, and height of a fold that is shut, points.
const LEAST_TOP: f32 = 260.0;
const FOLDED: f32 = 34.0;

/// Room of the colours side by side, points.
const SWATCH: Vec2 = vec2(120.0, 44.0);

/// Lowest row of bars, points.
const LEAST_ROW: f32 = 204.0;

/// Names of controls, shared with the tests that use them.
pub mod names {
    pub const PARTIAL: &str = later!("Sum of waves up to");
    pub const PLAY: &str = later!("▶ Play");
    pub const STOP: &str = later!("■ Stop");
    pub const ORDERS: &str = later!("Wave by wave");
}

#[derive(Default)]
pub struct CoefficientsView {
    harmonics: Memo<u64, Harmonics>,
    /// Half widths of the 95 % intervals of the light's numbers; none where no noise is known.
    half_widths: Memo<u64, Vec<f64>>,
    charts: Memo<(u64, Sight), CoefficientCharts>,
    /// The order whose bar is under the pointer.
    pointed: Option<usize>,
    /// When the next order comes, while playing: the program's time in s.
    next_step: Option<f64>,
}

impl CoefficientsView {
    /// The order whose bar is under the pointer.
    pub fn pointed(&self) -> Option<usize> {
        self.pointed
    }

    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let revision = context.app.revision();
        let harmonics = &*self.harmonics.get(revision, |_| harmonics_of(context.app));
        let highest = harmonics.orders.len().saturating_sub(1);
        context.pages.why.partial_order = context.pages.why.partial_order.min(highest);
        if !context.app.derived().has_errors() {
            self.next_step = None;
            ui.add_space(6.0);
            ui.weak(said!(
                "The spectrum is zero over the whole range: there is nothing to add up."
            ));
            return;
        }
        play(ui, context, &mut self.next_step, highest);
        ui.horizontal_top(|ui| {
            let order = context.pages.why.partial_order;
            if let Some([whole, summed]) = colours_summed(context.app, harmonics, order) {
                let size = SWATCH * context.theme.scale;
                let name = tr!(
                    "Colour: measured {measured}, summed {summed}",
                    measured = whole.hex(),
                    summed = summed.hex()
                );
                swatch::split(ui, size, &whole, &summed, &name).on_hover_text(tr!(
                    "Left the colour as measured, right the colour of the waves up to {order}.",
                    order
                ));
            }
            ui.vertical(|ui| {
                let [result, more] = words::sentences(context, harmonics);
                headline(ui, context.theme, result);
                if !more.is_empty() {
                    ui.label(more);
                }
            });
        });
        ui.add_space(GROUP);
        controls(ui, context, &mut self.next_step, highest);
        ui.add_space(GROUP);

        let sight = Sight {
            channel: context.pages.why.channel,
            partial_order: context.pages.why.partial_order,
            pointed: self.pointed,
        };
        let key = (revision, sight);
        let charts = &*self.charts.get(key, |(_, sight)| {
            CoefficientCharts::of(context.app, harmonics, *sight)
        });
        let half_widths = self.half_widths.get(revision, |_| {
            half_widths_of_numbers(context.app.document(), numbers_of_order(highest))
        });
        let known = (harmonics, half_widths.as_slice());
        let pointed = draw(ui, context, charts, known, self.pointed);
        if pointed != self.pointed {
            self.pointed = pointed;
            ui.ctx().request_repaint();
        }
    }
}

/// The order at which playing ends: that in force, or the end of the curve from there on.
fn last_played(context: &PageContext<'_>, highest: usize) -> usize {
    let in_force = context.app.derived().model.smooth().order();
    if in_force == 0 || context.pages.why.partial_order > in_force {
        CURVE_ORDER.min(highest)
    } else {
        in_force.min(highest)
    }
}

/// One order further when its time has come.
fn play(ui: &Ui, context: &mut PageContext<'_>, next_step: &mut Option<f64>, highest: usize) {
    let Some(at) = *next_step else {
        return;
    };
    let now = ui.input(|i| i.time);
    if now < at {
        wake_in(ui, at - now);
        return;
    }
    let last = last_played(context, highest);
    if context.pages.why.partial_order >= last {
        *next_step = None;
        return;
    }
    context.pages.why.partial_order += 1;
    *next_step = (context.pages.why.partial_order < last).then_some(now + STEP_SECONDS);
    if next_step.is_some() {
        wake_in(ui, STEP_SECONDS);
    }
}

fn wake_in(ui: &Ui, seconds: f64) {
    let after = std::time::Duration::from_secs_f64(seconds.max(0.01));
    ui.ctx().request_repaint_after(after);
}

fn controls(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    next_step: &mut Option<f64>,
    highest: usize,
) {
    ui.horizontal_wrapped(|ui| {
        for (k, name) in CHANNELS.into_iter().enumerate() {
            ui.selectable_value(&mut context.pages.why.channel, k, name)
                .on_hover_text(tr!(
                    "Shows the coefficients that make {name} of CIE X, Y, Z.",
                    name
                ));
        }
        ui.separator();
        let label = ui.label(said(names::PARTIAL));
        let reach = 0..=CURVE_ORDER
            .min(highest)
            .max(context.pages.why.partial_order);
        let slider = ui
            .add(slide(&mut context.pages.why.partial_order, reach).integer())
            .labelled_by(label.id)
            .on_hover_text(said!(
                "Waves of the partial sum that is drawn; the model itself stays."
            ));
        if slider.changed() {
            *next_step = None;
        }
        let playing = next_step.is_some();
        let words = if playing {
            said(names::STOP)
        } else {
            said(names::PLAY)
        };
        let meaning = said!("Adds the waves 0, 1, 2, ... one after the other, two a second.");
        if pressed(ui, words, meaning) {
            *next_step = if playing {
                None
            } else {
                if context.pages.why.partial_order >= last_played(context, highest) {
                    context.pages.why.partial_order = 0;
                }
                wake_in(ui, STEP_SECONDS);
                Some(ui.input(|i| i.time) + STEP_SECONDS)
            };
        }
        use_button(ui, context);
    });
}

fn use_button(ui: &mut Ui, context: &mut PageContext<'_>) {
    let settings = context.app.document().settings;
    let order = context.pages.why.partial_order;
    let button = egui::Button::new(tr!("Use {n} wave" | "Use {n} waves" % order));
    if ui
        .add_enabled(order != settings.order, button)
        .on_hover_text(tr!(
            "Gives the model so many waves: {numbers} for the smooth part.",
            numbers = numbers(numbers_of_order(order))
        ))
        .on_disabled_hover_text(said!("The model has so many waves."))
        .clicked()
    {
        context
            .commands
            .push(Command::Edit(Settings { order, ..settings }));
    }
}

/// The figures of one order: that under the pointer, or the last of the sum.
fn details(
    ui: &mut Ui,
    context: &PageContext<'_>,
    (harmonics, half_widths): (&Harmonics, &[f64]),
    pointed: Option<usize>,
) {
    let k = context.pages.why.channel;
    let n = pointed.unwrap_or(context.pages.why.partial_order);
    let Some(order) = harmonics.orders.get(n) else {
        return;
    };
    let name = CHANNELS[k];
    let exact = Some(harmonics.exact[k]).filter(|exact| *exact > 0.0);
    let share = |part: f64| percent(exact.map(|exact| part / exact));
    let first = harmonics.basis.number_name((2 * n).saturating_sub(1));
    let second = (n > 0).then(|| harmonics.basis.number_name(2 * n));
    let row = |ui: &mut Ui, what: &str, values: [f64; 2], half_widths: [Option<f64>; 2]| {
        ui.label(what);
        let columns = if second.is_some() { 2 } else { 1 };
        for (value, half_width) in values.into_iter().zip(half_widths).take(columns) {
            number(ui, value, half_width);
        }
        ui.end_row();
    };
    let half_width = |k: usize| half_widths.get(k).copied();
    let of_light = [half_width((2 * n).saturating_sub(1)), half_width(2 * n)];
    ui.strong(match pointed {
        Some(_) => tr!("Wave {n}, under the pointer", n),
        None => tr!("Wave {n}, the last of the sum", n),
    });
    egui::Grid::new("order in figures")
        .striped(true)
        .spacing([14.0, 3.0])
        .show(ui, |ui| {
            ui.label("");
            ui.strong(&first);
            if let Some(second) = &second {
                ui.strong(second);
            }
            ui.end_row();
            row(ui, said!("spectrum, its own unit"), order.light, of_light);
            row(
                ui,
                &tr!("what weighs {name}", name),
                order.weights[k],
                [None; 2],
            );
            if let Some(fit) = order.gaussian {
                row(ui, said!("the same by Eq. 10"), fit[k], [None; 2]);
            }
        });
    ui.add_space(2.0);
    ui.label(tr!(
        "Adds {share} % of {name}.",
        share = share(order.contribution[k]),
        name
    ));
    if let Some(missing) = order.neglected[k] {
        let reached = 100.0 * (1.0 - missing);
        let off = off_percent(missing);
        ui.label(tr!(
            "The sum is at {reached} %, off by {off} %.",
            reached = fixed(reached, 2),
            off
        ));
    }
    if let Some(bound) = order.bound {
        ui.label(tr!(
            "Term {n} over term 0: {share} %; bound {bound} %, as printed {printed} %.",
            n,
            share = percent(order.share_of_first[k]),
            bound = percent(bound.channels[k]),
            printed = percent(bound.channels_as_printed[k])
        ));
    }
}

/// A number of the series with half the width of its 95 % interval; faint where that holds 0.
fn number(ui: &mut Ui, value: f64, half_width: Option<f64>) {
    let Some(half_width) = half_width.filter(|half_width| *half_width > 0.0) else {
        ui.label(figure(value));
        return;
    };
    let words = with_half(value, Some(half_width));
    let is_noise = value.abs() < half_width;
    let response = if is_noise {
        ui.weak(words)
    } else {
        ui.label(words)
    };
    response.on_hover_text(if is_noise {
        said!("± is the 95 % interval. It holds 0: this number may be one of the noise.")
    } else {
        said!("± is the 95 % interval, by the noise of the readings.")
    });
}

/// All charts; returns the order under the pointer.
fn draw(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    charts: &CoefficientCharts,
    known: (&Harmonics, &[f64]),
    before: Option<usize>,
) -> Option<usize> {
    let highest = known.0.orders.len().saturating_sub(1);
    let scale = context.theme.scale;
    let order = |at: [f64; 2]| (at[0].round().max(0.0) as usize).min(highest);
    let mut pointed = None;
    // Measured outside: what is scrolled must not grow by what it was scrolled.
    let room = ui.available_height();
    scrolled(ui, "why few", |ui| {
        let width = ui.available_width();
        let top = (room - FOLDED * scale).max(LEAST_TOP * scale);
        let product = ("product", charts.product.as_ref());
        if width >= BESIDE * scale {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = GROUP;
                let left = vec2((PARTIAL * (width - GROUP)).floor(), top);
                down(ui, left, |ui| {
                    context.chart(ui, &charts.partial, "partial sum", left);
                });
                let right = vec2(width - left.x - GROUP, top);
                let shown = down(ui, right, |ui| one(ui, context, product, right));
                pointed = taken(context, shown, order);
            });
        } else {
            // Lower ones would have no room for their own words.
            let size = vec2(width, (0.5 * top).max(LEAST_ROW * scale));
            context.chart(ui, &charts.partial, "partial sum", size);
            let shown = one(ui, context, product, size);
            pointed = taken(context, shown, order);
        }
        fold(ui, "orders", said(names::ORDERS), |ui| {
            let bars = [
                ("light", charts.light.as_ref()),
                ("weight", charts.weight.as_ref()),
                ("running", charts.running.as_ref()),
                ("neglected", charts.neglected.as_ref()),
            ];
            let columns = if width >= BESIDE * scale { 2 } else { 1 };
            let gap = ui.spacing().item_spacing.x;
            let wide = (ui.available_width() - (columns - 1) as f32 * gap) / columns as f32;
            let size = vec2(wide.floor(), LEAST_ROW * scale);
            for line in bars.chunks(columns) {
                ui.horizontal_top(|ui| {
                    for bar in line {
                        // A chart lays out downwards what stands over it.
                        let shown = down(ui, size, |ui| one(ui, context, *bar, size));
                        pointed = pointed.or(taken(context, shown, order));
                    }
                });
            }
            details(ui, context, known, before);
        });
    });
    pointed
}

/// The order under the pointer in a chart; a click takes the sum there.
fn taken(
    context: &mut PageContext<'_>,
    shown: Option<ChartResponse>,
    order: impl Fn([f64; 2]) -> usize,
) -> Option<usize> {
    let shown = shown?;
    if let Some(hit) = shown.clicked {
        context.pages.why.partial_order = order(hit.at);
    }
    shown.pointed.map(|hit| order(hit.at))
}

/// A chart, or what stands in its place.
fn one(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (id, chart): (&str, Option<&Chart>),
    size: Vec2,
) -> Option<ChartResponse> {
    let Some(chart) = chart else {
        let name = CHANNELS[context.pages.why.channel];
        ui.set_min_size(size);
        ui.add_space(4.0);
        ui.weak(match id {
            "light" => {
                said!("The mean is zero: there is nothing to compare the coefficients with.")
                    .to_owned()
            }
            "weight" => tr!("The functions of {name} are zero on this range.", name),
            _ => tr!(
                "{name} is not positive on this range: there are no shares of it.",
                name
            ),
        });
        return None;
    };
    Some(context.chart(ui, chart, ("coefficients", id), size))
}
