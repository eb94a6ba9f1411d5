//! The spectrum: measured, model, smooth part, spikes that can be dragged, residual below.

use std::sync::Arc;

use eframe::egui;
use egui::{Id, Ui};
use egui_plot::PlotTransform;

use super::{
    chart_view::{ChartWish, How, Screen, draw, reset},
    theme::Theme,
};
use crate::{
    app::{
        App, Command, Memo, SpikeAct,
        chart::{Chart, Ink, Marks},
        charts::spectrum::spectrum_chart,
    },
    io::many::numbers,
};

mod drag;
mod read_out;

use drag::{Dragging, Stems};
use read_out::hover;

/// What the plot remembers between frames.
#[derive(Default)]
pub struct SpectrumView {
    /// From screen to plot and back, as of the last frame; tests aim with it.
    pub transform: Option<PlotTransform>,
    main: Option<Screen>,
    dragging: Dragging,
    reset: bool,
    /// Kept until what it shows changes.
    chart: Memo<u64, Arc<Chart>>,
    /// The next click in the plot sets a line.
    pub(super) adds_line: bool,
}

/// What one frame asked for.
#[derive(Default)]
pub struct Wishes {
    /// Changes of the document.
    pub commands: Vec<Command>,
    /// Acts on the spikes.
    pub acts: Vec<SpikeAct>,
    /// The pointer was let go after a drag.
    pub gesture_ended: bool,
    /// A chart to save, copy or print.
    pub chart: Option<ChartWish>,
}

impl SpectrumView {
    /// Brings the whole range back into view.
    pub fn reset(&mut self) {
        self.reset = true;
    }

    /// Draws the chart into all the room there is.
    pub fn show(&mut self, ui: &mut Ui, app: &App, theme: Theme) -> Wishes {
        let mut wishes = Wishes::default();
        let make = |_: &u64| {
            let mut chart = spectrum_chart(app);
            chart.title = spoken(app);
            Arc::new(chart)
        };
        let chart = self.chart.get(app.revision(), make).clone();
        let pointer = ui.input(|i| i.pointer.interact_pos());
        let near = self
            .main
            .and_then(|main| Dragging::nearest(&main, pointer, &stems(&chart)));
        // Another spectrum is looked at over the same wavelengths, at its own height.
        let document = app.document();
        let of = (
            &document.subject_entry().key,
            document.scale,
            document.view.height as u8,
            app.derived().band.points(),
        );
        let how = How {
            pans: near.is_none() && !self.dragging.holds() && !self.adds_line,
            // With Shift it sets a line.
            fits: near.is_none() && !ui.input(|i| i.modifiers.shift),
            y_of: Some(Id::unique(of)),
            ..How::PART
        };
        let id = Id::unique("spectrum");
        if std::mem::take(&mut self.reset) {
            reset(ui, id, how);
        }
        let size = ui.available_size();
        let shown = draw(ui, &chart, id, size, theme, how);
        // Files have the title of files.
        let asked = shown.wish.as_ref();
        wishes.chart = asked.map(|wish| ChartWish::new(&spectrum_chart(app), wish.form));
        hover(ui, app, theme, &shown.main);
        self.transform = Some(shown.transform);
        self.main = Some(shown.main);
        let tips = stems(&chart).tips;
        let adds = (&mut self.adds_line, near);
        self.dragging
            .interact(ui, app, &shown, tips, adds, &mut wishes);
        if let Some(tip) = near.and_then(|near| shown.main.pos(*stems(&chart).tips.get(near)?)) {
            // What a press would take hold of.
            let stroke = egui::Stroke::new(2.0, ui.visuals().strong_text_color());
            ui.painter().circle_stroke(tip, 7.0 * theme.scale, stroke);
        }
        wishes
    }
}

/// The stems of the model's spikes, if they are shown.
fn stems(chart: &Chart) -> Stems<'_> {
    let series = chart.series.iter();
    let mut spikes = series.filter(|series| series.colour == Ink::Spikes);
    let stems = spikes.find_map(|series| match &series.marks {
        Marks::Stems { points, base, .. } => Some(Stems {
            tips: points,
            feet: base,
        }),
        _ => None,
    });
    stems.unwrap_or_default()
}

/// The plot in words, for those who have it read out.
fn spoken(app: &App) -> String {
    let derived = app.derived();
    let unit = match app.unit() {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    let name = app.document().subject_entry().name();
    let lines = tr!("{n} line" | "{n} lines" % derived.model.lines().len());
    let counts = format!("{}, {lines}{unit}", numbers(derived.numbers()));
    match app.is_measured_in_range() {
        true => tr!("Spectrum of {name}: {counts}", name, counts),
        false => tr!(
            "Spectrum of {name}, nothing measured in this range: {counts}",
            name,
            counts
        ),
    }
}
