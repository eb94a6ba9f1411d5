//! The part "Chain" of the page "Products": a light and what it passes, as cards in their order.

mod cards;
mod knobs;

use eframe::egui;
use egui::{Align, Layout, Ui, vec2};

use super::{change, take_way};
use crate::{
    app::{
        Memo,
        chart::Chart,
        charts::products::chain::{ChainSheet, Place},
        headlines,
        numbers::{short_delta_e, short_percent},
        product_report::{spikes_table, stages_table},
        products::{KnownLines, Link, MOST_LINKS},
        ticks::short,
    },
    spectrum::{Line, Sampling},
    ui::{
        kit::{
            Choice, Chooser, Column, Row, down, factors, headline, pressed, pressed_small,
            scrolled, table,
        },
        model_view::sampling_words,
        pages::PageContext,
    },
};

/// Names of controls, shared with the tests that move them.
pub mod names {
    pub const ADD: &str = "Add a filter, glass or surface";
    pub const LIGHT: &str = "Light of the chain";
    pub const WAY: &str = "Products formed";
    pub const COPY_STAGES: &str = "Stages as CSV";
    pub const COPY_SPIKES: &str = "Spikes as CSV";
    pub const CLEAR: &str = "Empty the chain";
}

/// Below this width the cards stand above the spectrum, points.
const NARROW: f32 = 520.0;

/// Width of the column of cards, points: a share of the page within bounds.
const CARDS: (f32, [f32; 2]) = (0.37, [256.0, 400.0]);

/// Part of the height that the table of spikes may take.
const TABLE_SHARE: f32 = 0.34;

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
        let light = app.document().light.name();
        headline(ui, context.theme, headlines::chain(light, &sheet.told));
        head(ui, context, sheet);
        totals(ui, context, sheet);
        ui.add_space(2.0);
        let room = ui.available_size();
        let (share, [least, most]) = CARDS;
        let scale = context.theme.scale;
        let width = (share * room.x).clamp(least * scale, most * scale);
        let is_narrow = room.x < NARROW * scale;
        let cards = match is_narrow {
            true => vec2(room.x, 0.5 * room.y),
            false => vec2(width, room.y),
        };
        let (held, chart) = (&mut self.held, &mut self.chart);
        let layout = match is_narrow {
            true => Layout::top_down(Align::Min),
            false => Layout::left_to_right(Align::Min),
        };
        ui.with_layout(layout, |ui| {
            down(ui, cards, |ui| {
                self::cards::show(ui, context, sheet, cards.x, held);
            });
            ui.add_space(4.0);
            down(ui, ui.available_size(), |ui| {
                let place = chosen(context, sheet.stages());
                let key = (revision, place);
                let chart = chart.get(key, |_| sheet.chart(app, place));
                larger(ui, context, sheet, (chart, place));
            });
        });
    }
}

/// The light at a place in full, and its spikes below.
fn larger(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    (chart, place): (&Chart, Place),
) {
    let line = ui.text_style_height(&egui::TextStyle::Body) + 5.0;
    let wanted = line * (sheet.spikes(place).len().max(1) + 1) as f32 + 34.0;
    let below = wanted.min(TABLE_SHARE * ui.available_height());
    let height = ui.available_height() - below - ui.spacing().item_spacing.y;
    context.chart(ui, chart, "chain", vec2(ui.available_width(), height));
    spike_table(ui, context, sheet, place);
}

/// The place whose spectrum is drawn.
fn chosen(context: &PageContext<'_>, count: usize) -> Place {
    let memory = context.memory.products.chain;
    match (memory.light, memory.stage, count) {
        (true, ..) | (_, _, 0) => Place::Light,
        (false, Some(stage), _) => Place::Stage(stage.min(count - 1)),
        (false, None, _) => Place::Stage(count - 1),
    }
}

fn choose(context: &mut PageContext<'_>, place: Place) {
    let memory = &mut context.memory.products.chain;
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
    let memory = &mut context.memory.products.chain;
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
                    name: names::ADD,
                    meaning: "Reflectances and transmittances, shipped and your own; the one \
                              chosen joins the end of the chain.",
                    says: names::ADD,
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
            ui.weak(format!("{MOST_LINKS} at most."));
        }
        way(ui, context);
        let meaning = "Copies the light and every stage as a table.";
        if pressed(ui, names::COPY_STAGES, meaning) {
            let chain = &app.document().products.chain;
            ui.ctx()
                .copy_text(stages_table(app, &sheet.told, chain).csv());
        }
        let meaning = "Takes all factors away; undo brings them back.";
        if count > 0 && pressed(ui, names::CLEAR, meaning) {
            change(context, |products| products.chain.clear());
        }
    });
}

/// The ways of forming products.
fn way(ui: &mut Ui, context: &mut PageContext<'_>) {
    let before = context.app.document().settings.sampling;
    ui.label("formed by").on_hover_text(
        "How the model's product of light and factor is formed; the exact side is always the \
         measured curves at every nm.",
    );
    let choice = Choice {
        name: names::WAY,
        meaning: sampling_words(before).1,
        width: 120.0 * context.theme.scale,
    };
    let mut sampling = before;
    choice.pick(ui, &mut sampling, Sampling::ALL, sampling_words);
    if sampling != before {
        take_way(context, sampling);
    }
}

/// A line about the chain as one product.
fn totals(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet) {
    let total = sheet.told.passage.total();
    let derived = &sheet.light.derived;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let mut figure = |what: &str, value: String, meaning: &str| {
            ui.weak(what).on_hover_text(meaning);
            ui.strong(value).on_hover_text(meaning);
            ui.add_space(6.0);
        };
        figure(
            "ΔE₀₀",
            short_delta_e(total.colours.delta_e_2000),
            "CIEDE2000 between the measured light times the measured factors and the model's \
             product; the white is the exact light.",
        );
        figure(
            "of it forming",
            short_delta_e(total.added),
            "CIEDE2000 that forming the products adds, against the exact product of the same \
             model and series. Errors of colour do not simply add up.",
        );
        figure(
            "luminance",
            short_percent(total.colours.luminance_error, true),
            "Y of the model over Y exact, minus 1, percent.",
        );
        figure(
            "folded",
            short_percent(Some(total.folded_share), false),
            "Share of the product's power in orders that the points fold back (a convolution: \
             cuts off), percent.",
        );
        figure(
            "multiplications",
            total.multiplications.to_string(),
            "One a point (a convolution: one a pair of numbers) and one a spike, all factors \
             together.",
        );
        figure(
            "passes",
            short_percent(total.transmission[0], false),
            "Y of what comes out over Y of the light, exact.",
        );
        if !derived.has_errors() || derived.colour.exact.is_none() {
            ui.colored_label(context.theme.warning, "▲");
            ui.label(if !derived.has_errors() {
                "The light is zero over the whole range."
            } else {
                "No visible light in this range: there is no colour."
            });
        }
    });
}

/// The spikes behind the stage that is drawn.
fn spike_table(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet, place: Place) {
    let (app, spikes) = (context.app, sheet.spikes(place));
    ui.horizontal(|ui| {
        let title = "Spikes, carried exactly (Eq. 14)";
        ui.strong(title).on_hover_text(
            "Each spike keeps its place; its weight is multiplied by the factor where it stands.",
        );
        let meaning = "Copies places, weights and names as a table.";
        if !spikes.is_empty() && pressed_small(ui, names::COPY_SPIKES, meaning) {
            let stage = match place {
                Place::Light => "the light",
                Place::Stage(index) => &sheet.told.names[index],
            };
            ui.ctx()
                .copy_text(spikes_table(app, stage, spikes, &sheet.told.known).csv());
        }
    });
    if spikes.is_empty() {
        ui.weak(if app.document().settings.spikes {
            "No spikes: the light's lines are below the threshold, or there are none."
        } else {
            "Spikes are switched off."
        });
        return;
    }
    let document = app.document();
    let factor = document
        .scale
        .factor(&document.light.spectrum)
        .unwrap_or(1.0);
    let columns = [
        Column::numbers("nm", "Where the spike stands, nm.", 0.8),
        Column::numbers(
            "weight",
            "Power of the spike here, in the unit of the plot × nm.",
            1.1,
        ),
        Column::numbers(
            "of the light's",
            "Its weight here over that in the light, percent: what the factors so far let through \
             at its place. A dark line of a factor has none in the light.",
            1.1,
        ),
        Column::words(
            "line",
            "Named only where it is safe; otherwise the nearest line.",
            1.4,
        ),
    ];
    let own = sheet.light.derived.model.lines();
    let rows: Vec<Row> = spikes
        .iter()
        .map(|spike| row(spike, own, factor, &sheet.told.known))
        .collect();
    scrolled(ui, "spikes of the stage", |ui| {
        table(ui, &columns, &rows, None, false, context.theme)
    });
}

fn row(spike: &Line, own: &[Line], factor: f64, known: &KnownLines) -> Row {
    let in_light = own.iter().find(|s| s.at_nm == spike.at_nm);
    let share = in_light.map(|s| spike.weight / s.weight);
    let name = known
        .at(spike.at_nm)
        .and_then(|name| name.safe.clone())
        .unwrap_or_else(|| "–".to_owned());
    let cells = vec![
        format!("{:.1}", spike.at_nm),
        short(spike.weight * factor),
        short_percent(share.filter(|s| s.is_finite()), false),
        name.clone(),
    ];
    Row {
        name: format!("Spike at {} nm, weight {}, {name}", cells[0], cells[1]),
        cells,
        ..Row::default()
    }
}
