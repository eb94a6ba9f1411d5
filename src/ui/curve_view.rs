//! The error against the number of waves.

use std::sync::Arc;

use eframe::egui;
use egui::{Id, Ui, vec2};

use super::{
    chart_view::{How, draw},
    kit::Choice,
    theme::Theme,
};
use crate::{
    app::{
        App, Command, Memo, Settings,
        answers::judged,
        chart::{Chart, Marks},
        charts::order::order_chart,
        derived::OF_CURVE,
        readings::COUNTS,
        ticks,
        workspace::Preferences,
    },
    io::many::numbers,
    study::Measure,
};

/// The curve in a height, with the choice of its quantity; clicking it goes to that order.
pub(super) fn show(
    ui: &mut Ui,
    app: &App,
    preferences: &mut Preferences,
    theme: Theme,
    height: f32,
    commands: &mut Vec<Command>,
) {
    let top = ui.cursor().top();
    quantity_row(ui, app, preferences);
    let height = height - (ui.cursor().top() - top) - ui.spacing().item_spacing.y;
    plot(ui, app, preferences.curve, (height, theme), commands);
}

/// An error's name, with a sign of what it counts.
fn name(measure: Measure) -> String {
    let delta_e = if measure.is_colour() {
        " ΔE₀₀"
    } else {
        ""
    };
    format!("{}{delta_e}", measure.figure().title())
}

/// The chosen quantity where it exists: a reflectance has no patches, counts have no colour.
fn shown(app: &App, chosen: Measure) -> Measure {
    if chosen.is_colour() && judged(app) == Err(COUNTS) {
        return Measure::RmsBlurred;
    }
    let of_patches = matches!(chosen, Measure::Patches | Measure::PatchesWorst);
    if of_patches && app.derived().patches.is_none() {
        Measure::Own
    } else {
        chosen
    }
}

fn quantity_row(ui: &mut Ui, app: &App, preferences: &mut Preferences) {
    let now = shown(app, preferences.curve);
    ui.horizontal(|ui| {
        ui.label(said!("Error against waves"));
        let choice = Choice {
            name: said!("Figure of the curve"),
            meaning: now.figure().meaning(),
            width: ui.available_width() - 8.0,
        };
        choice.cut(ui, name(now), |ui| {
            for measure in OF_CURVE {
                if shown(app, measure) == measure {
                    ui.selectable_value(&mut preferences.curve, measure, name(measure))
                        .on_hover_text(measure.figure().meaning());
                }
            }
        });
    });
}

/// The chart, kept until what it shows changes.
fn kept_chart(ui: &Ui, app: &App, measure: Measure) -> Option<Arc<Chart>> {
    type Kept = Memo<(u64, Measure), Option<Arc<Chart>>>;
    let id = Id::unique("the chart of errors against waves");
    let mut kept: Kept = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let key = (app.revision(), measure);
    let make = |_: &_| {
        let mut chart = order_chart(app, measure)?;
        chart.title = said!("Error against waves; click to go there").to_owned();
        Some(Arc::new(chart))
    };
    let chart = kept.get(key, make).clone();
    ui.data_mut(|data| data.insert_temp(id, kept));
    chart
}

fn plot(
    ui: &mut Ui,
    app: &App,
    chosen: Measure,
    (height, theme): (f32, Theme),
    commands: &mut Vec<Command>,
) {
    let measure = shown(app, chosen);
    let derived = app.derived();
    let order = derived.model.smooth().order();
    let size = vec2(
        ui.available_width(),
        height.clamp(60.0, 240.0 * theme.scale),
    );
    let Some(chart) = kept_chart(ui, app, measure) else {
        ui.allocate_ui(size, |ui| {
            ui.weak(said!("There is no colour to compare in this range."));
        });
        return;
    };
    let how = How {
        moves: false,
        ..How::PART
    };
    let id = Id::unique("error against waves");
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
        drawn.response.on_hover_text_at_pointer(tr!(
            "Waves {waves}: {error}{unit} ({numbers}). Click to go there.",
            waves = read,
            error,
            unit = chart.y_unit,
            numbers = numbers(count)
        ));
    }
}
