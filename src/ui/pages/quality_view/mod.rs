//! The place "Quality": whether it is a good light, and which of two is better.

mod figures;
mod rendition;

use eframe::egui;
use egui::{Ui, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        App, ByOrder, Memo, QualityShown,
        chart::Chart,
        charts::quality::{against_order, diagram},
        pages::DiagramShows,
        settled_words,
    },
    study::{Progress, quality::Chosen},
    ui::kit::{down, headline, scrolled},
};

/// From this width on three charts stand side by side, points.
const WIDE: f32 = 780.0;
/// Lowest chart of several, points.
const LEAST_CHART: f32 = 190.0;
/// Room of a scroll bar, points.
const BAR: f32 = 14.0;

/// What the pages keep from frame to frame.
#[derive(Default)]
pub(super) struct QualityView {
    shown: Memo<u64, QualityShown>,
    rendition: rendition::RenditionView,
    /// The diagram, and the neighbourhood of the lights.
    diagram: Memo<(u64, DiagramShows), [Chart; 2]>,
}

impl QualityView {
    fn shown(&mut self, app: &App) -> &QualityShown {
        &*self.shown.get(app.revision(), |_| QualityShown::of(app))
    }

    /// The light's verdict, surfaces under it, and its figures.
    pub(super) fn figures(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        figures::show(ui, context, self.shown(context.app));
    }

    /// Where the light is among colours.
    pub(super) fn diagram(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let revision = context.app.revision();
        let shown = self.shown(context.app);
        headline(ui, context.theme, &shown.place);
        let placed = shown.placed();
        // In a wide room the neighbourhood stands beside the whole.
        let has_both = ui.available_width() >= 1.5 * ui.available_height();
        let shows = &mut context.pages.chromaticity;
        ui.horizontal_wrapped(|ui| {
            let mut switch = |on: &mut bool, title: &str, meaning: &str| {
                ui.toggle_value(on, title).on_hover_text(meaning);
            };
            switch(
                &mut shows.uniform,
                "u′v′",
                said!("CIE 1976 u′v′, in which equal steps look more alike; else CIE 1931 x, y."),
            );
            switch(
                &mut shows.whites,
                said!("Whites sold"),
                said!("The quadrangles of ANSI C78.377 that lamps are sold by."),
            );
            switch(
                &mut shows.gamuts,
                said!("Screens"),
                said!("The colours that screens of sRGB, P3 and Rec. 2020 show."),
            );
            switch(
                &mut shows.ellipses,
                said!("Ellipses"),
                said!(
                    "MacAdam's ellipses: how one observer's matches of a colour scattered, ten \
                     times enlarged."
                ),
            );
            switch(
                &mut shows.surfaces,
                said!("Surfaces"),
                said!("The eight test colours of Ra under the light: how far its colours reach."),
            );
            if !has_both {
                switch(
                    &mut shows.near,
                    said!("Near the light"),
                    said!("The neighbourhood of the light; of two lights that of both."),
                );
            }
        });
        let shows = *shows;
        let make = |(_, shows): &(u64, DiagramShows)| {
            [shows.near, true].map(|near| diagram(&placed, DiagramShows { near, ..*shows }))
        };
        let mut key = (revision, shows);
        key.1.near &= !has_both;
        let [chart, near] = &*self.diagram.get(key, make);
        let room = ui.available_size();
        if has_both {
            let half = vec2((0.5 * (room.x - 16.0)).floor(), room.y);
            ui.horizontal_top(|ui| {
                down(ui, half, |ui| {
                    context.chart(ui, chart, "chromaticity", half)
                });
                ui.add_space(10.0);
                down(ui, half, |ui| {
                    context.chart(ui, near, "near the light", half)
                });
            });
            return;
        }
        context.chart(ui, chart, "chromaticity", room);
    }

    /// What it does to colours: TM-30 and CRI.
    pub(super) fn rendition(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let shown = &*self
            .shown
            .get(context.app.revision(), |_| QualityShown::of(context.app));
        self.rendition.show(ui, context, shown);
    }

    /// What a few numbers do to the figures.
    pub(super) fn order(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let job = context.studies.job();
        job.ask(&app.revision(), context.wake, || {
            let ask = ByOrder::of(app);
            move |progress: &Progress| ask.answer(progress)
        });
        progress(ui, job, said!("Quality against waves"));
        let Some(found) = job.result().cloned() else {
            return;
        };
        headline(ui, context.theme, settled_words(&found));
        let charts = Chosen::ALL.map(|chosen| against_order(&found, chosen));
        grid(ui, context, &charts, "quality against waves");
    }
}

/// Charts side by side, two in a row or three where there is room.
fn grid(ui: &mut Ui, context: &mut PageContext<'_>, charts: &[Chart], id: &str) {
    let scale = context.theme.scale;
    let room = ui.available_size();
    let gap = ui.spacing().item_spacing;
    let columns = match charts.len() > 4 && room.x >= WIDE * scale {
        true => 3,
        false => 2,
    };
    let rows = charts.len().div_ceil(columns) as f32;
    let shared = vec2(
        (room.x - BAR) / columns as f32 - gap.x,
        room.y / rows - gap.y,
    );
    let field = vec2(shared.x, shared.y.max(LEAST_CHART * scale));
    scrolled(ui, id, |ui| {
        for (row, some) in charts.chunks(columns).enumerate() {
            ui.horizontal_top(|ui| {
                for (column, chart) in some.iter().enumerate() {
                    down(ui, field, |ui| {
                        ui.set_min_width(field.x);
                        context.chart(ui, chart, (id, row, column), field);
                    });
                }
            });
        }
    });
}
