//! The page "Chain": a light and what it passes, as cards in their order.

mod cards;
mod knobs;
mod model;

use eframe::egui::{Ui, vec2};

use super::change;
use crate::{
    app::{
        Memo,
        chart::Chart,
        charts::products::chain::{ChainSheet, Place},
        headlines,
        products::{Link, MOST_LINKS},
    },
    languages::said,
    ui::{
        kit::{Chooser, GROUP, factors, fold, headline, pressed, scrolled, warning},
        pages::PageContext,
    },
};

/// Names of controls, shared with the tests that move them.
pub mod names {
    pub const ADD: &str = later!("Add a filter, glass or surface");
    pub const LIGHT: &str = later!("Light of the chain");
    pub const WAY: &str = later!("Products formed");
    pub const COPY_STAGES: &str = later!("Steps as CSV");
    pub const COPY_SPIKES: &str = later!("Lines as CSV");
    pub const CLEAR: &str = later!("Empty the chain");
    pub const MODEL: &str = later!("The model, step by step");
}

/// Least height of the spectrum before a class, points.
const LEAST_PRESENTED: f32 = 140.0;

/// Least height of the spectrum, and height of a fold that is shut, points.
const SPECTRUM: f32 = 220.0;
const FOLDED: f32 = 30.0;

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct ChainView {
    sheet: Memo<u64, ChainSheet>,
    chart: Memo<(u64, Place), Chart>,
    /// The stage that the pointer holds.
    held: Option<usize>,
}

impl ChainView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let revision = app.revision();
        let sheet = &*self.sheet.get(revision, |_| ChainSheet::of(app));
        let document = app.document();
        let light = document.light.name();
        let second = document.second.as_ref().map(|entry| entry.name());
        let second = second.zip(sheet.second.as_ref());
        let words = headlines::chain(light, &sheet.told, second, document.view.model);
        headline(ui, context.theme, words);
        ui.add_space(GROUP);
        let (held, chart) = (&mut self.held, &mut self.chart);
        let scale = context.theme.scale;
        // Measured outside: what is scrolled must not grow by what it was scrolled.
        let room = ui.available_height();
        scrolled(ui, "chain", |ui| {
            let top = ui.cursor().top();
            if !context.theme.presents {
                head(ui, context, sheet);
                ui.add_space(6.0);
            }
            self::cards::show(ui, context, sheet, held);
            trouble(ui, context, sheet);
            ui.add_space(GROUP);
            let place = chosen(context, sheet.stages());
            let chart = chart.get((revision, place), |_| sheet.chart(app, place));
            let left = room - (ui.cursor().top() - top);
            let width = ui.available_width();
            if context.theme.presents {
                let least = LEAST_PRESENTED * scale;
                context.chart(ui, chart, "chain", vec2(width, left.max(least)));
                return;
            }
            let high = (left - FOLDED * scale).max(SPECTRUM * scale);
            context.chart(ui, chart, "chain", vec2(width, high));
            fold(ui, "model", said(names::MODEL), |ui| {
                model::show(ui, context, sheet, place);
            });
        });
    }
}

/// What must be said about the light and the steps.
fn trouble(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet) {
    let derived = &sheet.light.derived;
    if !derived.has_errors() {
        warning(
            ui,
            context.theme,
            said!("The light is zero over the whole range."),
        );
    } else if derived.colour.exact.is_none() {
        let words = said!("No visible light in this range: there is no colour.");
        warning(ui, context.theme, words);
    }
    for (index, notes) in sheet.notes.iter().enumerate() {
        for note in notes {
            warning(
                ui,
                context.theme,
                tr!("Step {number}: {note}", number = index + 1, note),
            );
        }
    }
}

/// The place whose spectrum is drawn.
fn chosen(context: &PageContext<'_>, count: usize) -> Place {
    let memory = context.pages.chain;
    match (memory.light, memory.stage, count) {
        (true, ..) | (_, _, 0) => Place::Light,
        (false, Some(stage), _) => Place::Stage(stage.min(count - 1)),
        (false, None, _) => Place::Stage(count - 1),
    }
}

fn choose(context: &mut PageContext<'_>, place: Place) {
    let memory = &mut context.pages.chain;
    match place {
        Place::Light => memory.light = true,
        Place::Stage(index) => {
            memory.light = false;
            memory.stage = Some(index);
        }
    }
}

/// Takes a link to another place; the stage that is drawn stays with its link.
fn move_link(context: &mut PageContext<'_>, from: usize, to: usize) {
    if from == to {
        return;
    }
    change(context, |products| {
        let link = products.chain.remove(from);
        products.chain.insert(to.min(products.chain.len()), link);
    });
    let memory = &mut context.pages.chain;
    memory.stage = memory.stage.map(|stage| {
        if stage == from {
            to
        } else if from < stage && stage <= to {
            stage - 1
        } else if to <= stage && stage < from {
            stage + 1
        } else {
            stage
        }
    });
}

fn head(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet) {
    ui.horizontal_wrapped(|ui| {
        let app = context.app;
        let count = sheet.stages();
        let room = count < MOST_LINKS;
        let chosen = ui
            .add_enabled_ui(room, |ui| {
                Chooser {
                    name: said(names::ADD),
                    meaning: said!(
                        "Reflectances and transmittances, shipped and your own; the one chosen \
                         joins the end of the chain."
                    ),
                    says: said(names::ADD),
                    offers: factors,
                    width: 190.0 * context.theme.scale,
                }
                .show(ui, app)
            })
            .inner;
        if let Some(entry) = chosen {
            change(context, |products| products.chain.push(Link::once(entry)));
            choose(context, Place::Stage(count));
        }
        if !room {
            ui.weak(tr!("{count} at most.", count = MOST_LINKS));
        }
        let meaning = said!("Takes all steps away; undo brings them back.");
        if count > 0 && pressed(ui, said(names::CLEAR), meaning) {
            change(context, |products| products.chain.clear());
        }
        if count > 1 && !context.theme.presents {
            ui.weak(said!("Drag cards into another order, or use their arrows."));
        }
    });
}
