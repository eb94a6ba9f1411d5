//! How many numbers the model takes, and the whole error-against-order curve.

use eframe::egui;
use egui::{Id, Ui, vec2};

use super::{
    chart_view::{How, draw},
    model_view::named,
    theme::Theme,
};
use crate::{
    app::{
        App, Command, Settings,
        chart::Marks,
        charts::spectrum::order_chart,
        ticks,
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

fn plot(ui: &mut Ui, app: &App, chosen: CurveQuantity, theme: Theme, commands: &mut Vec<Command>) {
    let quantity = shown(app, chosen);
    let derived = app.derived();
    let order = derived.model.smooth.order();
    let size = vec2(ui.available_width(), 96.0 * theme.scale);
    let Some(mut chart) = order_chart(app, quantity, theme.of_charts()) else {
        ui.allocate_ui(size, |ui| {
            ui.weak("There is no colour to compare in this range.");
        });
        return;
    };
    chart.title = "Error against order; click to go to an order".to_owned();
    let how = How {
        moves: false,
        ..How::PART
    };
    let id = Id::unique("error against order");
    let drawn = draw(ui, &chart, id, size, theme, how);
    let highest = derived.curve.last().map_or(0, |point| point.order) as f64;
    let pointed = drawn.response.hover_pos().map(|at| {
        let [order, _] = drawn.main.values(at);
        order.round().clamp(0.0, highest) as usize
    });
    if let Some(pointed) = pointed
        && drawn.response.clicked()
        && pointed != order
    {
        commands.push(Command::Edit(Settings {
            order: pointed,
            ..app.document().settings
        }));
    }
    let read = pointed.unwrap_or(order);
    let points = chart.series.iter().flat_map(|series| match &series.marks {
        Marks::Points { points, .. } => points.as_slice(),
        _ => &[],
    });
    if let (Some(point), Some(count)) = (
        points.into_iter().find(|p| p[0] as usize == read),
        derived.curve.get(read).map(|p| p.numbers),
    ) {
        let error = ticks::short(point[1]);
        drawn.response.on_hover_text_at_pointer(format!(
            "N = {read}: {error}{} ({}). Click to go there.",
            chart.y_unit,
            numbers(count)
        ));
    }
}
