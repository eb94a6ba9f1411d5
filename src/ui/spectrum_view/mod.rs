//! The spectrum: measured, model, smooth part, spikes that can be dragged, residual below.

use eframe::egui;
use egui::{Id, Rect, Ui, vec2};
use egui_plot::{Line, LineStyle, Plot, PlotPoints, PlotTransform, VLine};

use super::{
    axes,
    theme::{Theme, ink},
};
use crate::{
    app::{App, Command, spike_hand::SpikeAct, ticks},
    io::many::{many, numbers},
    spectrum::Band,
};

mod axis;
mod drag;
mod layers;
mod overlays;
mod read_out;
mod residual;
mod stems;
mod strip;

use axis::Axis;
use drag::Dragging;
use layers::layers;
use overlays::{overlay_names, overlay_points};
use read_out::hover;
use residual::residual;
use stems::{draw_stems, labels, stem_tips, tips};
use strip::Strip;

/// What the plot remembers between frames.
#[derive(Default)]
pub struct SpectrumView {
    /// From screen to plot and back, as of the last frame; tests aim with it.
    pub transform: Option<PlotTransform>,
    /// Leaves out the switches, for pictures.
    bare: bool,
    dragging: Dragging,
    reset: bool,
    /// The range shown last: another one comes into view by itself.
    shown: Option<Band>,
    strip: Strip,
}

/// Room for the numbers of the vertical axes, points; both plots have the same.
const Y_WIDTH: f32 = 46.0;

/// Width of the plots, points: the last wavelength's number stands half beyond them.
fn width(ui: &Ui, band: Band, theme: Theme) -> f32 {
    let beyond = if band.max_nm() < 1000.0 { 14.0 } else { 22.0 };
    (ui.available_width() - beyond * theme.scale).max(80.0)
}

/// How many wavelengths stand below a plot: long numbers need more room.
fn columns(width: f32, band: Band, theme: Theme) -> usize {
    let letters = if band.max_nm() < 1000.0 { 75.0 } else { 95.0 };
    (width / (letters * theme.scale)) as usize
}

/// A logarithmic axis shows this much below the largest value.
const LOG_FLOOR: f64 = 1e-5;

/// What one frame asked for.
#[derive(Default)]
pub struct Wishes {
    /// Changes of the document.
    pub commands: Vec<Command>,
    /// Acts on the spikes.
    pub acts: Vec<SpikeAct>,
    /// The pointer was let go after a drag.
    pub gesture_ended: bool,
}

impl SpectrumView {
    /// A plot without switches, for pictures.
    pub fn bare() -> Self {
        Self {
            bare: true,
            ..Self::default()
        }
    }

    /// Brings the whole range back into view.
    pub fn reset(&mut self) {
        self.reset = true;
    }

    /// Draws header, plot, colour strip and residual into all the room there is.
    pub fn show(&mut self, ui: &mut Ui, app: &App, theme: Theme) -> Wishes {
        let mut wishes = Wishes::default();
        let derived = app.derived();
        if self.shown.replace(derived.band) != Some(derived.band) {
            self.reset = true;
        }
        let view = app.document().view;
        let read_out = head(ui, app);
        if !self.bare {
            self.reset |= layers(ui, app, theme, &mut wishes);
        }

        let top = derived.measured.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let axis = Axis {
            factor: app.scale_factor(),
            log: view.log_axis,
            // Darkness has no logarithm either: the axis then starts at the smallest number.
            floor: (LOG_FLOOR * top * app.scale_factor()).max(f64::MIN_POSITIVE),
        };
        let room = ui.available_height();
        let strip_height = if view.strip { 16.0 * theme.scale } else { 0.0 };
        let residual_height = if view.residual {
            (0.24 * room).clamp(60.0, 150.0)
        } else {
            0.0
        };
        let height = (room - strip_height - residual_height - 8.0).max(80.0);
        let link = Id::unique("spectrum plots");
        let plot_rect = self.main_plot(ui, app, theme, axis, height, link, &mut wishes);
        if !app.is_measured_in_range() {
            nothing_here(ui, app, theme, plot_rect);
        }
        if let Some(transform) = self.transform {
            hover(ui, app, theme, axis, &transform, plot_rect, read_out);
            if view.overlays {
                overlay_names(ui, app, theme, axis, &transform);
            }
            if view.spikes {
                labels(ui, app, theme, axis, &transform);
            }
            if view.strip {
                self.strip.show(ui, app, theme, &transform, strip_height);
            }
        }
        if view.residual {
            residual(
                ui,
                app,
                theme,
                axis.factor,
                residual_height,
                link,
                self.reset,
            );
        }
        self.reset = false;
        wishes
    }

    #[expect(clippy::too_many_arguments, reason = "one plot, called once")]
    fn main_plot(
        &mut self,
        ui: &mut Ui,
        app: &App,
        theme: Theme,
        axis: Axis,
        height: f32,
        link: Id,
        wishes: &mut Wishes,
    ) -> Rect {
        let derived = app.derived();
        let document = app.document();
        let (band, view) = (derived.band, document.view);
        let tips = tips(app, axis);
        let pointer = ui.input(|i| i.pointer.interact_pos());
        let near = Dragging::nearest(self.transform, pointer, &tips).filter(|_| view.spikes);
        let busy = self.dragging.is_on() || near.is_some();
        let subject = &document.subject_entry().key;
        let id = (
            "spectrum",
            subject,
            document.scale,
            view.log_axis,
            band.min_nm() as u32,
            band.max_nm() as u32,
        );
        let unit = app.unit();
        let plot_width = width(ui, band, theme);
        let mut plot = Plot::new(id)
            .height(height)
            .width(plot_width)
            .link_axis(link, [true, false])
            .link_cursor(link, [true, false])
            .allow_drag(!busy)
            .allow_scroll(false)
            .allow_double_click_reset(false)
            .show_crosshair(false)
            .default_x_bounds(band.min_nm(), band.max_nm())
            .auto_bounds([false, !self.dragging.is_on()])
            .set_margin_fraction(vec2(0.0, 0.08))
            .x_grid_spacer(axes::marks(columns(plot_width, band, theme)))
            .label_formatter(|_| None);
        let y_marks = (height / (44.0 * theme.scale)) as usize;
        plot = if axis.log {
            plot.y_grid_spacer(axes::decades(y_marks))
        } else {
            let is_flat = derived.measured.iter().all(|v| *v == 0.0);
            // Else nothing but zeros would stand on an axis to some hundreds.
            let most = if is_flat { 1.0 } else { 0.0 };
            plot.include_y(0.0)
                .include_y(most)
                .y_grid_spacer(axes::marks(y_marks))
        };
        plot = axes::dress(
            plot,
            theme,
            Y_WIDTH * theme.scale,
            |nm| format!("{} nm", ticks::short(nm)),
            move |height| axis.words(height),
        );
        if self.reset {
            plot = plot.reset();
        }
        let dragging = self.dragging.is_on();
        let response = plot.show(ui, |plot| {
            if dragging {
                plot.set_auto_bounds([false, false]);
            }
            let curve = |values: &[f64]| -> Vec<[f64; 2]> {
                band.grid()
                    .zip(values)
                    .filter_map(|(nm, v)| Some([nm, axis.place(*v)?]))
                    .collect()
            };
            let line = |name: &str, points: Vec<[f64; 2]>, colour| {
                Line::new(name, PlotPoints::from(points))
                    .color(colour)
                    .width(theme.line)
                    .allow_hover(false)
            };
            if view.overlays {
                for (i, overlay) in document.overlays.iter().enumerate() {
                    let inks = theme.inks.overlays;
                    // The second round of inks is thinner: dashes of many curves cost a third of
                    // a frame.
                    let width = theme.line / (1 + i / inks.len()) as f32;
                    let points = overlay_points(overlay, app, axis);
                    let colour = ink(inks[i % inks.len()]);
                    plot.line(line(overlay.name(), points, colour).width(width.max(0.6)));
                }
            }
            // Where nothing was measured there is nothing to draw, not a line of zeros.
            if !app.is_measured_in_range() {
                return;
            }
            if view.measured {
                let points = app.measured_points();
                let points = points.filter_map(|(nm, v)| Some([nm, axis.place(v)?]));
                plot.line(line("measured", points.collect(), ink(theme.inks.measured)));
            }
            if let Some(product) = app.product() {
                let colour = ink(theme.inks.product);
                plot.line(line("product", curve(&product.exact), colour));
                plot.line(
                    line("product by the model", curve(&product.smooth), colour)
                        .style(LineStyle::dashed_dense()),
                );
                let settings = document.settings;
                let tips = stem_tips(&product.spikes, settings.max_width_nm, |nm| {
                    band.interpolate(&product.smooth, nm)
                });
                draw_stems(plot, &tips, axis, theme, colour, 2.5);
            }
            if view.model {
                plot.line(
                    line(
                        "model",
                        curve(&derived.model_values()),
                        ink(theme.inks.spikes),
                    )
                    .width(theme.line * 0.8),
                );
            }
            if view.smooth {
                plot.line(
                    line(
                        "smooth part",
                        curve(&derived.smooth),
                        ink(theme.inks.smooth),
                    )
                    .width(theme.line * 1.3),
                );
            }
            if view.spikes {
                let tips = stem_tips(
                    &derived.model.spikes,
                    document.settings.max_width_nm,
                    |nm| band.interpolate(&derived.smooth, nm),
                );
                draw_stems(plot, &tips, axis, theme, ink(theme.inks.spikes), 4.0);
            }
            if let Some(at) = plot.pointer_coordinate()
                && plot.response().hovered()
            {
                plot.vline(VLine::new("", at.x).color(theme.faint).width(0.6));
            }
        });
        self.transform = Some(response.transform);
        let rect = *response.transform.frame();
        response.response.widget_info(|| {
            egui::WidgetInfo::labeled(
                egui::Role::Image,
                true,
                format!(
                    "Spectrum of {}{}: {}, {}{}",
                    document.subject_entry().name(),
                    if app.is_measured_in_range() {
                        ""
                    } else {
                        ", nothing measured in this range"
                    },
                    numbers(derived.numbers()),
                    many(derived.model.spikes.len(), "spike", "spikes"),
                    if unit.is_empty() {
                        String::new()
                    } else {
                        format!(", {unit}")
                    }
                ),
            )
        });
        self.dragging
            .interact(ui, app, axis, &response, near, wishes);
        rect
    }
}

/// Says in the middle of the plot why it is empty.
fn nothing_here(ui: &Ui, app: &App, theme: Theme, plot: Rect) {
    let band = app.derived().band;
    let samples = &app.document().subject_entry().spectrum.samples;
    let words = format!(
        "Nothing was measured from {} to {} nm.\nThe table covers {} to {} nm.",
        band.min_nm(),
        band.max_nm(),
        ticks::short(samples.first_nm()),
        ticks::short(samples.last_nm()),
    );
    let font = egui::TextStyle::Body.resolve(ui.style());
    let painter = ui.painter().with_clip_rect(plot);
    let words = painter.layout(words, font, theme.faint, plot.width() - 16.0);
    painter.galley(plot.center() - words.size() / 2.0, words, theme.faint);
}

/// Name, unit and grid of the subject; returns where the read-out may be written.
fn head(ui: &mut Ui, app: &App) -> Rect {
    let document = app.document();
    let subject = document.subject_entry();
    ui.horizontal(|ui| {
        ui.label(egui::RichText::new(subject.name()).heading());
        let unit = app.unit();
        let words = [
            if unit.is_empty() {
                "no unit stated"
            } else {
                unit
            },
            document.scale.words(),
        ];
        ui.weak(words.join(", "));
        if let Some(product) = app.product() {
            ui.label(format!("through {}", product.name));
        }
        ui.available_rect_before_wrap()
    })
    .inner
}
