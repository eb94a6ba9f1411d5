//! The spectrum: measured, model, smooth part, spikes that can be dragged, residual below.

use eframe::egui;
use egui::{Id, Rect, Ui};
use egui_plot::PlotTransform;

use super::{
    chart_view::{How, Screen, draw, reset},
    theme::Theme,
};
use crate::{
    app::{
        App, Command,
        chart::Chart,
        charts::spectrum::{SPIKES, spectrum_chart},
        spike_hand::SpikeAct,
    },
    io::many::{many, numbers},
};

mod drag;
mod layers;
mod read_out;

use drag::Dragging;
use layers::layers;
use read_out::hover;

/// What the plot remembers between frames.
#[derive(Default)]
pub struct SpectrumView {
    /// From screen to plot and back, as of the last frame; tests aim with it.
    pub transform: Option<PlotTransform>,
    main: Option<Screen>,
    dragging: Dragging,
    reset: bool,
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
}

impl SpectrumView {
    /// Brings the whole range back into view.
    pub fn reset(&mut self) {
        self.reset = true;
    }

    /// Draws header, switches and chart into all the room there is.
    pub fn show(&mut self, ui: &mut Ui, app: &App, theme: Theme) -> Wishes {
        let mut wishes = Wishes::default();
        let read_out = head(ui, app);
        self.reset |= layers(ui, app, theme, &mut wishes);
        let mut chart = spectrum_chart(app, theme.of_charts());
        chart.title = spoken(app);
        if let Some(range) = self.dragging.range() {
            chart.y_range = Some(range);
        }
        let pointer = ui.input(|i| i.pointer.interact_pos());
        let near = self
            .main
            .and_then(|main| Dragging::nearest(&main, pointer, tips(&chart)));
        // Another spectrum is looked at over the same wavelengths, at its own height.
        let document = app.document();
        let of = (
            &document.subject_entry().key,
            document.scale,
            document.view.log_axis,
            app.derived().band.points(),
        );
        let how = How {
            pans: near.is_none() && self.dragging.range().is_none(),
            y_of: Some(Id::unique(of)),
            ..How::PART
        };
        let id = Id::unique("spectrum");
        if std::mem::take(&mut self.reset) {
            reset(ui, id, how);
        }
        let size = ui.available_size();
        let shown = draw(ui, &chart, id, size, theme, how);
        hover(ui, app, theme, &shown.main, read_out);
        self.transform = Some(shown.transform);
        self.main = Some(shown.main);
        let range = chart.y_limits();
        self.dragging
            .interact(ui, app, &shown, range, near, &mut wishes);
        wishes
    }
}

/// The tips of the model's spikes, if they are shown.
fn tips(chart: &Chart) -> &[[f64; 2]] {
    let spikes = chart.series.iter().find(|series| series.name == SPIKES);
    spikes.map_or(&[], |series| series.marks.points())
}

/// The plot in words, for those who have it read out.
fn spoken(app: &App) -> String {
    let derived = app.derived();
    let nothing = match app.is_measured_in_range() {
        true => "",
        false => ", nothing measured in this range",
    };
    let unit = match app.unit() {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    format!(
        "Spectrum of {}{nothing}: {}, {}{unit}",
        app.document().subject_entry().name(),
        numbers(derived.numbers()),
        many(derived.model.spikes.len(), "spike", "spikes"),
    )
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
