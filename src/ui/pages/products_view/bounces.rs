//! The part "Bounces" of the page "Products": error against the number of bounces.

use eframe::egui;
use egui::{Ui, vec2};

use super::{surface_chooser, take_way};
use crate::{
    app::{
        ByAddress, Memo,
        chart::Chart,
        charts::products::{
            bounces::{Bounced, TOLD, errors},
            resampling::{way_meaning, way_name},
        },
        numbers::delta_e,
        pages::BouncesMemory,
        products::ModelledLight,
        studies::Stage,
        ticks::short,
        verdicts::HARD_TO_SEE,
    },
    languages::said,
    study::Progress,
    ui::{
        kit::{Column, GROUP, Row, headline, scrolled, table, titled},
        pages::{PageContext, progress},
    },
};

/// What people and tests call the controls.
pub mod names {
    pub const SURFACE: &str = later!("Surface");
    pub const TOTAL: &str = later!("total");
    pub const ADDED: &str = later!("added by forming");
    pub const LOG: &str = later!("logarithmic");
    pub const COPY: &str = later!("Copy bounces as CSV");
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct BouncesView {
    chart: Memo<(ByAddress<Bounced>, BouncesMemory), Chart>,
}

impl BouncesView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, revision) = (context.app, context.app.revision());
        let Some(surface) = app.document().products.surface.clone() else {
            headline(
                ui,
                context.theme,
                said!("Choose the surface that the light bounces off."),
            );
            controls(ui, context);
            return;
        };
        let job = context.studies.job();
        job.ask(&revision, context.wake, || {
            let (lit, light) = (
                ModelledLight::of(app),
                app.document().light.name().to_owned(),
            );
            move |progress: &Progress| {
                let found = Bounced::lit(&lit, &light, &surface);
                (!progress.is_cancelled()).then_some(found)
            }
        });
        if !matches!(job.stage(), Stage::Done | Stage::Running(_)) {
            progress(ui, job, said!("Error against bounces"));
        }
        let Some(bounced) = job.result().cloned() else {
            controls(ui, context);
            return;
        };
        let words = bounced.sentence(context.pages.bounces.added);
        headline(ui, context.theme, words).on_hover_text(said!(
            "Measured on this light and surface. Both sides are brightened so that the exact \
             product has half the light's Y."
        ));
        ui.add_space(GROUP);
        controls(ui, context);
        ui.add_space(GROUP);
        let memory = context.pages.bounces;
        let key = (ByAddress(bounced.clone()), memory);
        let chart = &*self
            .chart
            .get(key, |_| bounced.chart(app, memory.added, memory.log));
        let room = ui.available_size();
        let scale = context.theme.scale;
        scrolled(ui, "bounces", |ui| {
            let width = ui.available_width();
            let below = 9.0 * (ui.spacing().interact_size.y + 3.0) + 40.0 * scale;
            let height = (room.y - below).max(300.0 * scale);
            context.chart(ui, chart, "bounces", vec2(width, height));
            ui.add_space(4.0);
            figures(ui, context, &bounced, memory.added);
        });
    }
}

/// The surface, and what is drawn.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.horizontal_wrapped(|ui| {
        surface_chooser(ui, context, said(names::SURFACE));
        ui.separator();
        let memory = &mut context.pages.bounces;
        ui.label("ΔE₀₀");
        ui.selectable_value(&mut memory.added, false, said(names::TOTAL))
            .on_hover_text(said!(
                "CIEDE2000 of the model against measured light times the measured surface."
            ));
        ui.selectable_value(&mut memory.added, true, said(names::ADDED))
            .on_hover_text(said!(
                "CIEDE2000 against the exact product of the very same series: what forming the \
                 products adds. At 1 nm nothing is added."
            ));
        ui.separator();
        ui.checkbox(&mut memory.log, said(names::LOG))
            .on_hover_text(said!(
                "A logarithmic vertical axis; errors below 0.001 stand at its foot."
            ));
    });
}

/// Errors behind a few counts of bounces.
fn figures(ui: &mut Ui, context: &mut PageContext<'_>, bounced: &Bounced, added: bool) {
    let title = if added {
        said!(
            "ΔE₀₀ added by forming the products, behind K bounces, both brightened to half the \
             light's Y"
        )
    } else {
        said!("ΔE₀₀ behind K bounces, both sides brightened to half the light's Y")
    };
    let app = context.app;
    let copied = said!("Copies total and added errors behind every number of bounces as a table.");
    titled(ui, title, said(names::COPY), copied, || {
        bounced.table(app).csv()
    });
    let mut columns = vec![Column::words(
        said!("way"),
        said!("Way of forming products. Click a row to form all products so."),
        2.2,
    )];
    columns.extend(TOLD.map(|k| {
        Column::numbers(
            &format!("K = {k}"),
            &tr!("CIEDE2000 behind {n} bounces, the white is the light."
                | "CIEDE2000 behind {n} bounces, the white is the light." % k),
            1.2,
        )
    }));
    columns.push(Column::numbers(
        said!("below 1 up to"),
        &tr!(
            "The last bounce of those from the first on whose ΔE₀₀ stay below {limit}.",
            limit = short(HARD_TO_SEE)
        ),
        1.3,
    ));
    let stays = bounced.stays(added);
    let rows: Vec<Row> = bounced
        .ways
        .iter()
        .zip(&stays)
        .map(|(way, (below, seen))| {
            let errors = errors(way, added);
            let told = TOLD.map(|k| match errors.get(k - 1).copied().flatten() {
                Some(0.0) => "0".to_owned(),
                error => delta_e(error),
            });
            let name = way_name(way.sampling);
            let until = match below {
                _ if *seen == 0 => "–".to_owned(),
                0 => said!("none").to_owned(),
                below if below == seen && *below == errors.len() => {
                    tr!("all {count}", count = below)
                }
                below => format!("K = {below}"),
            };
            Row {
                name: tr!("{way}: below 1 up to {bounce}", way = name, bounce = until),
                note: tr!(
                    "{meaning}\nClick to form all products so.",
                    meaning = way_meaning(way.sampling)
                ),
                cells: std::iter::once(name.to_owned())
                    .chain(told)
                    .chain([until])
                    .collect(),
                ..Row::default()
            }
        })
        .collect();
    let settings = app.document().settings;
    let chosen = bounced
        .ways
        .iter()
        .position(|way| way.sampling == settings.sampling);
    let theme = context.theme;
    let clicked = table(ui, &columns, &rows, chosen, true, theme);
    if let Some(way) = clicked.and_then(|row| bounced.ways.get(row)) {
        take_way(context, way.sampling);
    }
}
