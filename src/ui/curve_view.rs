//! How many numbers the model takes, and the whole error-against-order curve.

use eframe::egui;
use egui::Ui;
use egui_plot::{HLine, Line, Plot, PlotPoints, Points, VLine};

use super::{
    axes,
    model_view::named,
    theme::{Theme, ink},
};
use crate::{
    app::{
        App, Command, Settings, ticks,
        workspace::{CurveQuantity, Preferences},
    },
    io::many::numbers,
};

/// The count of numbers, and the curve; clicking it goes to that order.
pub fn show(
    ui: &mut Ui,
    app: &App,
    preferences: &mut Preferences,
    theme: Theme,
    commands: &mut Vec<Command>,
) {
    let derived = app.derived();
    let smooth = derived.model.smooth.coefficients.len();
    let spikes = derived.model.spikes.len();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label("Numbers used");
        ui.strong(derived.numbers().to_string());
        ui.weak(format!(
            "= {smooth} smooth + {} for {spikes} {}",
            2 * spikes,
            if spikes == 1 { "spike" } else { "spikes" }
        ));
    })
    .response
    .on_hover_text("An order N takes 2N + 1 numbers; a spike takes two, its place and its weight.");
    quantity_row(ui, app, preferences);
    plot(ui, app, preferences.curve, theme, commands);
}

fn quantity_words(quantity: CurveQuantity) -> (&'static str, &'static str) {
    match quantity {
        CurveQuantity::Own => ("own colour ΔE", "CIEDE2000 of the spectrum's own colour."),
        CurveQuantity::Patches => (
            "patches' mean ΔE",
            "Mean CIEDE2000 of the patches under the light, products at 1 nm.",
        ),
        CurveQuantity::PatchesWorst => (
            "worst patch ΔE",
            "Largest CIEDE2000 of the patches under the light, products at 1 nm.",
        ),
        CurveQuantity::Rms => (
            "rms at 1 nm",
            "Root mean square of model minus measured over that of the spectrum.",
        ),
        CurveQuantity::RmsBlurred => (
            "rms behind 10 nm",
            "The same after a Gaussian blur of 10 nm full width.",
        ),
    }
}

const QUANTITIES: [CurveQuantity; 5] = [
    CurveQuantity::Own,
    CurveQuantity::Patches,
    CurveQuantity::PatchesWorst,
    CurveQuantity::Rms,
    CurveQuantity::RmsBlurred,
];

/// The chosen quantity where it exists: a reflectance has no patches.
fn shown(app: &App, chosen: CurveQuantity) -> CurveQuantity {
    let of_patches = matches!(chosen, CurveQuantity::Patches | CurveQuantity::PatchesWorst);
    if of_patches && app.derived().patches.is_none() {
        CurveQuantity::Own
    } else {
        chosen
    }
}

fn quantity_row(ui: &mut Ui, app: &App, preferences: &mut Preferences) {
    let now = shown(app, preferences.curve);
    ui.horizontal(|ui| {
        ui.label("Error against order");
        let combo = egui::ComboBox::from_id_salt("curve quantity")
            .selected_text(quantity_words(now).0)
            .width(ui.available_width() - 8.0)
            .show_ui(ui, |ui| {
                for quantity in QUANTITIES {
                    if shown(app, quantity) == quantity {
                        let (name, meaning) = quantity_words(quantity);
                        ui.selectable_value(&mut preferences.curve, quantity, name)
                            .on_hover_text(meaning);
                    }
                }
            });
        named(
            &combo.response,
            egui::Role::ComboBox,
            "What the curve shows",
        );
        combo.response.on_hover_text(quantity_words(now).1);
    });
}

/// Errors below this are drawn at it: the axis is logarithmic.
const FLOOR: f64 = 1e-4;

/// A just noticeable colour difference, about; the line drawn for orientation.
const NOTICEABLE: f64 = 1.0;

fn plot(ui: &mut Ui, app: &App, chosen: CurveQuantity, theme: Theme, commands: &mut Vec<Command>) {
    let quantity = shown(app, chosen);
    let derived = app.derived();
    let order = derived.model.smooth.order();
    let points: Vec<[f64; 2]> = derived
        .curve
        .iter()
        .filter_map(|p| {
            let value = match quantity {
                CurveQuantity::Own => p.own,
                CurveQuantity::Patches => p.patches_mean,
                CurveQuantity::PatchesWorst => p.patches_max,
                CurveQuantity::Rms => p.relative_rms,
                CurveQuantity::RmsBlurred => p.relative_rms_10nm,
            }?;
            Some([p.order as f64, value.max(FLOOR).log10()])
        })
        .collect();
    let height = 96.0 * theme.scale;
    if points.is_empty() {
        ui.allocate_ui(egui::vec2(ui.available_width(), height), |ui| {
            ui.weak("There is no colour to compare in this range.");
        });
        return;
    }
    let is_colour = !matches!(quantity, CurveQuantity::Rms | CurveQuantity::RmsBlurred);
    let highest = points.last().map_or(1.0, |p| p[0]);
    let lowest_log = points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let highest_log = points
        .iter()
        .map(|p| p[1])
        .fold(f64::NEG_INFINITY, f64::max);
    let words = move |log: f64| {
        if is_colour {
            ticks::short(10_f64.powf(log))
        } else {
            format!("{} %", ticks::short(100.0 * 10_f64.powf(log)))
        }
    };
    let now = points.iter().find(|p| p[0] as usize == order).copied();
    let line = theme.line;
    let inks = theme.inks;
    let plot = Plot::new("error against order")
        .height(height)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .show_crosshair(false)
        .set_margin_fraction(egui::vec2(0.02, 0.08))
        .include_x(0.0)
        .include_x(highest)
        .include_y((lowest_log - 0.1).floor().max(FLOOR.log10()))
        .include_y(highest_log.ceil())
        .x_grid_spacer(axes::marks(8))
        .y_grid_spacer(axes::decades(3))
        .label_formatter(|_| None);
    let response =
        axes::dress(plot, theme, 34.0 * theme.scale, ticks::short, words).show(ui, |plot| {
            if is_colour {
                plot.hline(
                    HLine::new("", NOTICEABLE.log10())
                        .color(theme.faint.gamma_multiply(0.6))
                        .width(1.0),
                );
            }
            plot.vline(VLine::new("", order as f64).color(theme.faint).width(1.0));
            plot.line(
                Line::new("error", PlotPoints::from(points.clone()))
                    .color(ink(inks.smooth))
                    .width(line),
            );
            plot.points(
                Points::new("orders", PlotPoints::from(points.clone()))
                    .color(ink(inks.smooth))
                    .radius(1.8 * theme.scale),
            );
            if let Some(now) = now {
                plot.points(
                    Points::new("now", PlotPoints::from(vec![now]))
                        .color(ink(inks.spikes))
                        .radius(4.5 * theme.scale),
                );
            }
            plot.pointer_coordinate()
        });
    named(
        &response.response,
        egui::Role::Image,
        "Error against order; click to go to an order",
    );
    let pointed = response
        .inner
        .filter(|_| response.response.hovered())
        .map(|at| (at.x.round().clamp(0.0, highest)) as usize);
    if let Some(pointed) = pointed
        && response.response.clicked()
        && pointed != order
    {
        commands.push(Command::Edit(Settings {
            order: pointed,
            ..app.document().settings
        }));
    }
    let read = pointed.unwrap_or(order);
    if let (Some(point), Some(count)) = (
        points.iter().find(|p| p[0] as usize == read),
        derived.curve.get(read).map(|p| p.numbers),
    ) {
        response.response.on_hover_text_at_pointer(format!(
            "N = {read}: {} ({}). Click to go there.",
            words(point[1]),
            numbers(count)
        ));
    }
}
