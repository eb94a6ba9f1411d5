//! The spectrum: measured, model, smooth part, spikes that can be dragged, residual below.

use eframe::egui;
use egui::{Align2, Color32, ColorImage, Id, Pos2, Rect, TextureHandle, Ui, pos2, vec2};
use egui_plot::{Line, LineStyle, Plot, PlotPoint, PlotPoints, PlotTransform, Points, VLine};

use super::{
    axes,
    theme::{Theme, grey, ink},
};
use crate::{
    app::{App, Command, Entry, View, line_names::nearest_line, spike_hand::SpikeAct, ticks},
    color::{Srgb, srgb_from_wavelength_over},
    spectrum::Spike,
};

/// What the plot remembers between frames.
#[derive(Default)]
pub struct SpectrumView {
    /// From screen to plot and back, as of the last frame; tests aim with it.
    pub transform: Option<PlotTransform>,
    drag: Option<Drag>,
    reset: bool,
    strip: Option<(StripKey, TextureHandle)>,
}

/// A spike under the pointer's button.
#[derive(Clone, Copy, Debug)]
struct Drag {
    index: usize,
    /// Its place among the hand edits once it was moved.
    hand: Option<usize>,
    start: Pos2,
}

type StripKey = (u32, u32, bool);

/// Room for the numbers of the vertical axes, points; both plots have the same.
const Y_WIDTH: f32 = 46.0;

/// How near the pointer must come to a spike's tip, points.
const GRAB: f32 = 10.0;
/// How far the pointer must move before a press becomes a drag, points.
const DEAD_ZONE: f32 = 3.0;
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

/// The vertical axis: the scale in force and, if wanted, logarithms.
#[derive(Clone, Copy)]
struct Axis {
    factor: f64,
    log: bool,
    /// Smallest value shown on a logarithmic axis.
    floor: f64,
}

impl Axis {
    /// Where a value of the spectrum stands; `None` when a logarithmic axis cannot show it.
    fn place(self, value: f64) -> Option<f64> {
        let value = value * self.factor;
        if !self.log {
            return Some(value);
        }
        (value >= self.floor).then(|| value.log10())
    }

    /// The value of the spectrum at a height.
    fn value(self, height: f64) -> f64 {
        let value = if self.log {
            10_f64.powf(height)
        } else {
            height
        };
        value / self.factor
    }

    /// The number written at a height.
    fn words(self, height: f64) -> String {
        ticks::short(if self.log {
            10_f64.powf(height)
        } else {
            height
        })
    }
}

impl SpectrumView {
    /// Brings the whole range back into view.
    pub fn reset(&mut self) {
        self.reset = true;
    }

    /// Draws header, plot, colour strip and residual into all the room there is.
    pub fn show(&mut self, ui: &mut Ui, app: &App, theme: Theme) -> Wishes {
        let mut wishes = Wishes::default();
        let derived = app.derived();
        let view = app.document().view;
        let read_out = head(ui, app, theme);
        self.layers(ui, app, theme, &mut wishes);

        let top = derived.measured.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let axis = Axis {
            factor: app.scale_factor(),
            log: view.log_axis,
            floor: LOG_FLOOR * top * app.scale_factor(),
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
        if let Some(transform) = self.transform {
            hover(ui, app, theme, axis, &transform, plot_rect, read_out);
            if view.spikes {
                labels(ui, app, theme, axis, &transform);
            }
            if view.strip {
                self.strip(ui, app, theme, &transform, strip_height);
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

    /// The layers as switches that are their own legend.
    fn layers(&mut self, ui: &mut Ui, app: &App, theme: Theme, wishes: &mut Wishes) {
        let document = app.document();
        let before = document.view;
        let mut view = before;
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 3.0;
            let inks = theme.inks;
            layer(
                ui,
                &mut view.measured,
                "measured",
                Some(inks.measured),
                "The spectrum as measured.",
            );
            layer(
                ui,
                &mut view.smooth,
                "smooth",
                Some(inks.smooth),
                "The smooth part: the short series.",
            );
            layer(
                ui,
                &mut view.spikes,
                "spikes",
                Some(inks.spikes),
                "The spikes as stems. A stem's height above the smooth part is weight / (1.0645 x \
                 widest line), the peak of a Gaussian of that width and weight.",
            );
            layer(
                ui,
                &mut view.model,
                "model",
                Some(inks.spikes),
                "Smooth part and spikes together, each spike split over its two neighbouring nm.",
            );
            layer(
                ui,
                &mut view.residual,
                "residual",
                Some(inks.residual),
                "Model minus measured, below.",
            );
            layer(
                ui,
                &mut view.strip,
                "colours",
                None,
                "The colour of each wavelength under the axis.",
            );
            if !document.overlays.is_empty() {
                layer(
                    ui,
                    &mut view.overlays,
                    "overlays",
                    Some(inks.overlays[0]),
                    "The spectra laid over for comparison. One of another kind (a reflectance over a \
                     light) is drawn to the same height.",
                );
                for (i, overlay) in document.overlays.iter().enumerate().take(MOST_NAMES) {
                    let colour = ink(inks.overlays[i % inks.overlays.len()]);
                    let name = shortened(overlay.name());
                    ui.label(egui::RichText::new(name).small().color(colour));
                }
                if document.overlays.len() > MOST_NAMES {
                    let more = document.overlays.len() - MOST_NAMES;
                    ui.small(format!("and {more} more"));
                }
                if ui
                    .small_button("clear")
                    .on_hover_text("Takes all overlays away.")
                    .clicked()
                {
                    wishes.commands.push(Command::ClearOverlays);
                }
            }
            layer(
                ui,
                &mut view.log_axis,
                "log",
                None,
                "Logarithmic vertical axis.",
            );
            if ui
                .small_button("whole range")
                .on_hover_text(
                    "Brings the whole range back into view (Home). Drag to move, Ctrl and \
                    wheel to zoom, right drag for a box.",
                )
                .clicked()
            {
                self.reset = true;
            }
        });
        if view != before {
            wishes.commands.push(Command::View(View { ..view }));
        }
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
        let near = self.nearest(pointer, &tips).filter(|_| view.spikes);
        let busy = self.drag.is_some() || near.is_some();
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
        let plot_width = ui.available_width();
        let mut plot = Plot::new(id)
            .height(height)
            .link_axis(link, [true, false])
            .link_cursor(link, [true, false])
            .allow_drag(!busy)
            .allow_scroll(false)
            .allow_double_click_reset(false)
            .show_crosshair(false)
            .default_x_bounds(band.min_nm(), band.max_nm())
            .auto_bounds([false, self.drag.is_none()])
            .set_margin_fraction(vec2(0.0, 0.08))
            .x_grid_spacer(axes::marks((plot_width / (75.0 * theme.scale)) as usize))
            .label_formatter(|_| None);
        let y_marks = (height / (44.0 * theme.scale)) as usize;
        plot = if axis.log {
            plot.y_grid_spacer(axes::decades(y_marks))
        } else {
            plot.include_y(0.0).y_grid_spacer(axes::marks(y_marks))
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
        let dragging = self.drag.is_some();
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
                    let style = if i < inks.len() {
                        LineStyle::Solid
                    } else {
                        LineStyle::dashed_dense()
                    };
                    let points = overlay_points(overlay, app, axis);
                    let colour = ink(inks[i % inks.len()]);
                    plot.line(line(overlay.name(), points, colour).style(style));
                }
            }
            if view.measured {
                plot.line(line(
                    "measured",
                    curve(&derived.measured),
                    ink(theme.inks.measured),
                ));
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
                    "Spectrum of {}: {} numbers, {} spikes{}",
                    document.subject_entry().name(),
                    derived.numbers(),
                    derived.model.spikes.len(),
                    if unit.is_empty() {
                        String::new()
                    } else {
                        format!(", {unit}")
                    }
                ),
            )
        });
        self.interact(ui, app, axis, &response.response, near, wishes);
        rect
    }

    /// The spike whose tip is under the pointer.
    fn nearest(&self, pointer: Option<Pos2>, tips: &[Option<[f64; 2]>]) -> Option<usize> {
        let (pointer, transform) = (pointer?, self.transform?);
        if !transform.frame().contains(pointer) {
            return None;
        }
        tips.iter()
            .enumerate()
            .filter_map(|(i, tip)| {
                let [x, y] = (*tip)?;
                let at = transform.position_from_point(&PlotPoint::new(x, y));
                Some((at.distance(pointer), i))
            })
            .filter(|(distance, _)| *distance <= GRAB)
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, i)| i)
    }

    fn interact(
        &mut self,
        ui: &Ui,
        app: &App,
        axis: Axis,
        response: &egui::Response,
        near: Option<usize>,
        wishes: &mut Wishes,
    ) {
        let Some(transform) = self.transform else {
            return;
        };
        let (pointer, pressed, released) = ui.input(|i| {
            (
                i.pointer.interact_pos(),
                i.pointer.primary_pressed(),
                i.pointer.primary_released(),
            )
        });
        let inside = response.contains_pointer();
        if near.is_some() && inside {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
        }
        let derived = app.derived();
        let base_at = |nm: f64| derived.band.interpolate(&derived.smooth, nm);
        if let (Some(index), Some(start), true) = (near, pointer, pressed && inside) {
            let hand = derived.parts.spikes.get(index).and_then(|s| s.hand);
            self.drag = Some(Drag { index, hand, start });
        }
        if let (Some(drag), Some(pointer)) = (self.drag, pointer)
            && (drag.start.distance(pointer) > DEAD_ZONE || drag.hand_moved(app))
        {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
            let at = transform.value_from_position(pointer);
            let at_nm = at.x.clamp(derived.band.min_nm(), derived.band.max_nm());
            let height = axis.value(at.y) - base_at(at_nm);
            let width = app.document().settings.max_width_nm;
            let weight = Spike::weight_from_stem(height, width);
            let hands = app.document().subject_edits().hand.len();
            let hand = drag.hand.unwrap_or(hands);
            let index = derived
                .parts
                .spikes
                .iter()
                .position(|s| s.hand == Some(hand))
                .unwrap_or(drag.index);
            wishes.acts.push(SpikeAct::Set {
                index,
                at_nm,
                weight,
            });
            self.drag = Some(Drag {
                hand: Some(hand),
                ..drag
            });
        }
        if released && self.drag.take().is_some() {
            wishes.gesture_ended = true;
        }
        if response.double_clicked()
            && near.is_none()
            && let Some(pointer) = pointer
        {
            let at = transform.value_from_position(pointer);
            let height = axis.value(at.y) - base_at(at.x);
            if derived.band.contains(at.x) {
                wishes.acts.push(SpikeAct::Add {
                    at_nm: at.x,
                    weight: Spike::weight_from_stem(height, app.document().settings.max_width_nm),
                });
            }
        }
    }

    /// The colours of the wavelengths, exactly under the plot's axis.
    fn strip(
        &mut self,
        ui: &mut Ui,
        app: &App,
        theme: Theme,
        transform: &PlotTransform,
        height: f32,
    ) {
        let band = app.derived().band;
        let (area, _) =
            ui.allocate_exact_size(vec2(ui.available_width(), height), egui::Sense::hover());
        let key = (band.min_nm() as u32, band.max_nm() as u32, theme.dark);
        let texture = match &self.strip {
            Some((made_for, texture)) if *made_for == key => texture.clone(),
            _ => {
                let [r, g, b, _] = theme.ground.to_array();
                let pixels: Vec<Color32> = band
                    .grid()
                    .map(|nm| {
                        let Srgb([r, g, b]) = srgb_from_wavelength_over(nm, Srgb([r, g, b]));
                        Color32::from_rgb(r, g, b)
                    })
                    .collect();
                let image = ColorImage::new([pixels.len(), 1], pixels);
                let texture = ui
                    .ctx()
                    .load_texture("strip", image, egui::TextureOptions::LINEAR);
                self.strip = Some((key, texture.clone()));
                texture
            }
        };
        let frame = transform.frame();
        let x = |nm: f64| transform.position_from_point_x(nm);
        let (left, right) = (x(band.min_nm()), x(band.max_nm()));
        let painter = ui.painter().with_clip_rect(Rect::from_min_max(
            pos2(frame.left(), area.top()),
            pos2(frame.right(), area.bottom()),
        ));
        // Grid points are the middles of texels: the first and last stand on the band's ends.
        let half = 0.5 / band.points() as f32;
        painter.image(
            texture.id(),
            Rect::from_min_max(
                pos2(left, area.top() + 2.0),
                pos2(right, area.bottom() - 2.0),
            ),
            Rect::from_min_max(pos2(half, 0.0), pos2(1.0 - half, 1.0)),
            Color32::WHITE,
        );
    }
}

impl Drag {
    /// Whether the spike was moved already: then every further move counts.
    fn hand_moved(self, app: &App) -> bool {
        self.hand
            .is_some_and(|h| h < app.document().subject_edits().hand.len())
            && app
                .derived()
                .parts
                .spikes
                .get(self.index)
                .is_none_or(|s| s.hand != self.hand)
    }
}

/// Name, unit and grid of the subject; returns where the read-out may be written.
fn head(ui: &mut Ui, app: &App, _theme: Theme) -> Rect {
    let document = app.document();
    let subject = document.subject_entry();
    ui.horizontal(|ui| {
        ui.label(egui::RichText::new(subject.name()).heading());
        let unit = app.unit();
        let words = [
            if unit.is_empty() {
                "no unit stated".to_owned()
            } else {
                unit
            },
            document.scale.words().to_owned(),
        ];
        ui.weak(words.join(", "));
        if let Some(product) = app.product() {
            ui.label(format!("through {}", product.name));
        }
        ui.available_rect_before_wrap()
    })
    .inner
}

fn layer(ui: &mut Ui, on: &mut bool, name: &str, colour: Option<[u8; 3]>, meaning: &str) {
    let text = egui::RichText::new(name).small();
    let button = match colour {
        Some(colour) => {
            let mark = egui::RichText::new(if *on { "●" } else { "○" })
                .small()
                .color(ink(colour));
            egui::Button::selectable(*on, (mark, text))
        }
        None => egui::Button::selectable(*on, text),
    };
    let response = ui.add(button).on_hover_text(meaning);
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::CheckBox, true, *on, format!("Show {name}"))
    });
    if response.clicked() {
        *on = !*on;
    }
}

/// Overlays named beside their switch.
const MOST_NAMES: usize = 4;

/// A name of at most a few letters.
fn shortened(name: &str) -> String {
    const MOST: usize = 14;
    if name.chars().count() <= MOST {
        return name.to_owned();
    }
    name.chars().take(MOST - 1).chain(['…']).collect()
}

/// Foot and tip of each stem in the spectrum's own numbers.
fn stem_tips(
    spikes: &[Spike],
    width_nm: f64,
    base_at: impl Fn(f64) -> f64,
) -> Vec<(f64, f64, f64)> {
    spikes
        .iter()
        .map(|s| {
            let base = base_at(s.at_nm);
            (s.at_nm, base, base + s.stem_height(width_nm))
        })
        .collect()
}

fn draw_stems(
    plot: &mut egui_plot::PlotUi<'_>,
    tips: &[(f64, f64, f64)],
    axis: Axis,
    theme: Theme,
    colour: Color32,
    radius: f32,
) {
    let mut heads = Vec::new();
    for (nm, base, tip) in tips {
        let foot = axis.place(*base).unwrap_or_else(|| axis.floor.log10());
        let Some(top) = axis.place(*tip) else {
            continue;
        };
        plot.line(
            Line::new("", PlotPoints::from(vec![[*nm, foot], [*nm, top]]))
                .color(colour)
                .width(theme.line * 1.2)
                .allow_hover(false),
        );
        heads.push([*nm, top]);
    }
    plot.points(
        Points::new("spikes", PlotPoints::from(heads))
            .color(colour)
            .radius(radius * theme.scale)
            .allow_hover(false),
    );
}

/// Where the model's tips stand in plot coordinates.
fn tips(app: &App, axis: Axis) -> Vec<Option<[f64; 2]>> {
    let derived = app.derived();
    let width = app.document().settings.max_width_nm;
    stem_tips(&derived.model.spikes, width, |nm| {
        derived.band.interpolate(&derived.smooth, nm)
    })
    .into_iter()
    .map(|(nm, _, tip)| Some([nm, axis.place(tip)?]))
    .collect()
}

fn overlay_points(overlay: &Entry, app: &App, axis: Axis) -> Vec<[f64; 2]> {
    let spectrum = &overlay.spectrum;
    let document = app.document();
    let factor = if overlay.kind() == document.subject_entry().kind() {
        document.scale.factor(spectrum).unwrap_or(1.0)
    } else {
        // Watts and fractions have no common axis: another kind is drawn to the same height.
        let top = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        let own = top(spectrum.samples.values());
        if own > 0.0 {
            app.scale_factor() * top(&app.derived().measured) / own
        } else {
            1.0
        }
    };
    let own = Axis { factor, ..axis };
    let samples = &spectrum.samples;
    samples
        .nm()
        .iter()
        .zip(samples.values())
        .filter_map(|(nm, v)| Some([*nm, own.place(*v)?]))
        .collect()
}

/// Labels above the tips: moved up where they would overlap, left out where there is no room.
fn labels(ui: &Ui, app: &App, theme: Theme, axis: Axis, transform: &PlotTransform) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let painter = ui.painter().with_clip_rect(*transform.frame());
    let mut taken: Vec<Rect> = Vec::new();
    for ((spike, name), tip) in app
        .derived()
        .model
        .spikes
        .iter()
        .zip(app.spike_names())
        .zip(tips(app, axis))
    {
        let Some([x, y]) = tip else { continue };
        let text = match &name.safe {
            Some(name) => name.clone(),
            None => format!("{:.1}", spike.at_nm),
        };
        let galley = painter.layout_no_wrap(text, font.clone(), ui.visuals().text_color());
        let tip = transform.position_from_point(&PlotPoint::new(x, y));
        let mut rect = Align2::CENTER_BOTTOM.anchor_size(tip - vec2(0.0, 7.0), galley.size());
        let frame = transform.frame();
        // Beside the frame's edges a label slides in; above its top it hangs below the edge.
        rect = rect.translate(vec2(
            (frame.left() + 2.0 - rect.left()).max(0.0)
                - (rect.right() - frame.right() + 2.0).max(0.0),
            (frame.top() + 2.0 - rect.top()).max(0.0),
        ));
        const MOST_ROWS: usize = 5;
        let mut rows = 0;
        while rows < MOST_ROWS && taken.iter().any(|t| t.expand(1.0).intersects(rect)) {
            rect = rect.translate(vec2(0.0, -galley.size().y));
            rows += 1;
        }
        if rows == MOST_ROWS || rect.top() < frame.top() {
            continue;
        }
        let ground = theme.ground.gamma_multiply(0.75);
        painter.rect_filled(rect.expand2(vec2(2.0, 0.0)), 2.0, ground);
        painter.galley(rect.min, galley, ui.visuals().text_color());
        taken.push(rect);
    }
}

/// The values under the pointer, written into the header's free room.
fn hover(
    ui: &Ui,
    app: &App,
    theme: Theme,
    axis: Axis,
    transform: &PlotTransform,
    plot: Rect,
    room: Rect,
) {
    let Some(pointer) = ui.input(|i| i.pointer.hover_pos()) else {
        return;
    };
    if !plot.contains(pointer) {
        return;
    }
    let derived = app.derived();
    let nm = transform.value_from_position(pointer).x;
    if !derived.band.contains(nm) {
        return;
    }
    let value = |values: &[f64]| ticks::short(axis.factor * derived.band.interpolate(values, nm));
    let mut text = format!(
        "{nm:.1} nm   measured {}   model {}",
        value(&derived.measured),
        value(&derived.model_values()),
    );
    if let Some(line) = nearest_line(nm, app.element_lines()) {
        text.push_str(&format!("   near {line}"));
    }
    let [r, g, b, _] = theme.ground.to_array();
    let Srgb([r, g, b]) = srgb_from_wavelength_over(nm, Srgb([r, g, b]));
    let font = egui::TextStyle::Body.resolve(ui.style());
    let galley = ui
        .painter()
        .layout_no_wrap(text, font, ui.visuals().strong_text_color());
    let corner = pos2(room.right() - galley.size().x - 4.0, room.top());
    let field = Rect::from_min_size(corner - vec2(20.0, -1.0), vec2(14.0, galley.size().y - 2.0));
    let painter = ui.painter();
    let ground = Rect::from_min_max(
        field.min - vec2(8.0, 2.0),
        room.right_top() + vec2(0.0, galley.size().y + 2.0),
    );
    painter.rect_filled(ground, 3.0, ui.visuals().panel_fill);
    painter.rect_filled(field, 2.0, Color32::from_rgb(r, g, b));
    painter.rect_stroke(
        field,
        2.0,
        egui::Stroke::new(1.0, grey(128)),
        egui::StrokeKind::Outside,
    );
    painter.galley(corner, galley, ui.visuals().strong_text_color());
}

fn residual(ui: &mut Ui, app: &App, theme: Theme, factor: f64, height: f32, link: Id, reset: bool) {
    let derived = app.derived();
    let band = derived.band;
    let points: Vec<[f64; 2]> = band
        .grid()
        .zip(&derived.residual)
        .map(|(nm, v)| [nm, v * factor])
        .collect();
    let key = &app.document().subject_entry().key;
    let columns = (ui.available_width() / (75.0 * theme.scale)) as usize;
    let mut plot = Plot::new(("residual", key, app.document().scale))
        .height(height)
        .x_grid_spacer(axes::marks(columns))
        .link_axis(link, [true, false])
        .link_cursor(link, [true, false])
        .allow_scroll(false)
        .allow_double_click_reset(false)
        .show_crosshair(false)
        .default_x_bounds(band.min_nm(), band.max_nm())
        .auto_bounds([false, true])
        .include_y(0.0)
        .set_margin_fraction(vec2(0.0, 0.12))
        .y_grid_spacer(axes::marks((height / (36.0 * theme.scale)) as usize))
        .label_formatter(|_| None);
    plot = axes::dress(
        plot,
        theme,
        Y_WIDTH * theme.scale,
        |_| String::new(),
        ticks::short,
    );
    if reset {
        plot = plot.reset();
    }
    let response = plot.show(ui, |plot| {
        plot.line(
            Line::new("residual", PlotPoints::from(points))
                .color(ink(theme.inks.residual))
                .width(theme.line)
                .allow_hover(false),
        );
    });
    response.response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Image, true, "Residual: model minus measured")
    });
    let frame = response.transform.frame();
    ui.painter().text(
        frame.left_top() + vec2(6.0, 4.0),
        Align2::LEFT_TOP,
        "model − measured",
        egui::TextStyle::Small.resolve(ui.style()),
        theme.faint,
    );
}
