//! The part "chain" of the page "Products": a light and what it passes, as cards in their order.

use eframe::egui;
use egui::{
    Align, Color32, ComboBox, CursorIcon, DragValue, Frame, Label, Layout, Margin, Rect, RichText,
    ScrollArea, Sense, Stroke, Ui, UiBuilder, Vec2, pos2, vec2,
};

use super::picker::{Picker, factors, lights};
use crate::{
    app::{
        Command,
        chart::{self, Chart},
        charts::products::chain::{StageDrawn, stage_chart},
        charts::spectrum::provenance,
        product_report::{Told, scaled, spikes_csv, stages_csv},
        products::{BOUNCES, KnownLines, Link, Lit, MOST_LINKS, Products, THICKNESSES},
        ticks::short,
    },
    spectrum::{Sampling, Spike},
    study::products::Colours,
    ui::{
        chart_view::ChartView,
        model_view::{named, sampling_words},
        pages::{
            PageContext,
            rows::{Column, Row, table},
        },
        swatch,
        theme::{Theme, ink},
    },
};

/// Names of controls, shared with the tests that move them.
pub mod names {
    /// The list that adds a factor.
    pub const ADD: &str = "Add a filter, glass or surface";
    /// The list that chooses the light.
    pub const LIGHT: &str = "Light of the chain";
    /// The ways of forming products.
    pub const WAY: &str = "Products formed";
    /// The button that copies all stages.
    pub const COPY_STAGES: &str = "Stages as CSV";
    /// The button that copies the spikes of the stage that is drawn.
    pub const COPY_SPIKES: &str = "Spikes as CSV";
    /// The button that takes all factors away.
    pub const CLEAR: &str = "Empty the chain";
}

/// Width of the column of cards, points: a share of the page within bounds.
const CARDS: (f32, [f32; 2]) = (0.37, [256.0, 400.0]);

/// Height of the small spectrum on a card, points.
const SPARK: f32 = 34.0;

/// Width of the split swatch on a card, points.
const SWATCH: f32 = 54.0;

/// Part of the height that the table of spikes may take.
const TABLE_SHARE: f32 = 0.34;

/// Points that a small spectrum is drawn with at most.
const SPARK_POINTS: usize = 120;

/// A card: the light, or a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Card {
    Light,
    Stage(usize),
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct ChainView {
    passed: Option<Passed>,
    chart: Option<(ChartKey, Chart)>,
    /// The stage that the pointer holds.
    held: Option<usize>,
}

/// What the chart was made for: revision, card, looks.
type ChartKey = (u64, Card, chart::Theme);

/// A chain that the light went through.
struct Passed {
    revision: u64,
    lit: Lit,
    told: Told,
    notes: Vec<Vec<String>>,
    /// Small spectra: the light's, then each stage's; exact and smooth part, heights 0-1.
    sparks: Vec<[Vec<f32>; 2]>,
}

impl Passed {
    fn of(context: &PageContext<'_>) -> Self {
        let (app, lit) = (context.app, Lit::of(context.app));
        let told = Told::of(app, &lit, &app.document().products.chain);
        let notes = told.stage_notes(&lit);
        let mut sparks = vec![spark(&lit.derived.measured, &lit.derived.smooth)];
        let steps = &told.passage.steps;
        sparks.extend(steps.iter().map(|step| spark(&step.exact, &step.smooth)));
        Self {
            revision: app.revision(),
            lit,
            told,
            notes,
            sparks,
        }
    }

    fn spikes(&self, card: Card) -> &[Spike] {
        match card {
            Card::Light => &self.lit.derived.model.spikes,
            Card::Stage(index) => &self.told.passage.steps[index].spikes,
        }
    }
}

/// Two curves over the peak of the first.
fn spark(exact: &[f64], smooth: &[f64]) -> [Vec<f32>; 2] {
    let top = exact.iter().copied().fold(0.0, f64::max);
    // A line of 1 nm must not fall between the points that are drawn.
    let chunk = exact.len().div_ceil(SPARK_POINTS).max(1);
    let heights = |values: &[f64]| {
        let highest = |part: &[f64]| part.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let height = |v: f64| {
            let share = v / top;
            if share.is_finite() {
                share.clamp(0.0, 1.0) as f32
            } else {
                0.0
            }
        };
        values.chunks(chunk).map(|c| height(highest(c))).collect()
    };
    [heights(exact), heights(smooth)]
}

impl ChainView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let revision = context.app.revision();
        let passed = match self.passed.take() {
            Some(passed) if passed.revision == revision => passed,
            _ => Passed::of(context),
        };
        let count = passed.told.passage.steps.len();
        head(ui, context, &passed);
        totals(ui, context, &passed);
        ui.add_space(2.0);
        let room = ui.available_size();
        let (share, [least, most]) = CARDS;
        let scale = context.theme.scale;
        let width = (share * room.x).clamp(least * scale, most * scale);
        ui.horizontal_top(|ui| {
            ui.allocate_ui_with_layout(vec2(width, room.y), Layout::top_down(Align::Min), |ui| {
                self.cards(ui, context, &passed, width)
            });
            ui.add_space(4.0);
            let size = ui.available_size();
            ui.allocate_ui_with_layout(size, Layout::top_down(Align::Min), |ui| {
                let card = chosen(context, count);
                self.larger(ui, context, &passed, card);
            });
        });
        self.passed = Some(passed);
    }

    fn cards(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, passed: &Passed, width: f32) {
        ScrollArea::vertical()
            .id_salt("cards of the chain")
            .auto_shrink(false)
            .show(ui, |ui| {
                // The bar of the scroll area stands over the right edge.
                ui.set_width(width - 10.0);
                ui.spacing_mut().item_spacing.y = 5.0;
                card(ui, context, passed, Card::Light);
                let count = passed.told.passage.steps.len();
                let mut rects = Vec::with_capacity(count);
                for index in 0..count {
                    let response = card(ui, context, passed, Card::Stage(index));
                    if response.drag_started() {
                        self.held = Some(index);
                    }
                    rects.push(response.rect);
                }
                self.carry(ui, context, passed, &rects);
                if count == 0 {
                    ui.add_space(8.0);
                    ui.label(
                        "The chain is empty: nothing stands in the light's way. Add a filter, a \
                         glass or a surface above; files that you open join the list.",
                    );
                } else if count > 1 {
                    ui.weak("Drag cards into another order, or use their arrows.");
                }
            });
    }

    /// A card in the hand: where it would land, and landing.
    fn carry(&mut self, ui: &Ui, context: &mut PageContext<'_>, passed: &Passed, rects: &[Rect]) {
        let Some(from) = self.held.filter(|held| *held < rects.len()) else {
            self.held = None;
            return;
        };
        let Some(pointer) = ui.input(|i| i.pointer.latest_pos()) else {
            return;
        };
        let slot = rects.iter().filter(|r| r.center().y < pointer.y).count();
        ui.set_cursor_icon(CursorIcon::Grabbing);
        let y = match slot.checked_sub(1) {
            Some(above) => rects[above].bottom() + 2.5,
            None => rects[0].top() - 2.5,
        };
        let colour = ui.visuals().widgets.active.bg_stroke.color;
        ui.painter().hline(rects[0].x_range(), y, (3.0, colour));
        let layer = egui::LayerId::new(egui::Order::Tooltip, ui.scope_id().with("held card"));
        let painter = ui.ctx().layer_painter(layer);
        let font = egui::TextStyle::Body.resolve(ui.style());
        let words = passed.told.names[from].clone();
        let galley = painter.layout_no_wrap(words, font, ui.visuals().strong_text_color());
        let ghost = Rect::from_min_size(pointer + vec2(14.0, 4.0), galley.size() + vec2(12.0, 8.0));
        painter.rect(
            ghost,
            4.0,
            ui.visuals().window_fill,
            Stroke::new(1.0, colour),
            egui::StrokeKind::Inside,
        );
        painter.galley(ghost.min + vec2(6.0, 4.0), galley, Color32::WHITE);
        if ui.input(|i| i.key_pressed(egui::Key::Escape)) {
            self.held = None;
        } else if !ui.input(|i| i.pointer.any_down()) {
            self.held = None;
            // Taking it out moves what is below it up by one.
            let to = if slot > from { slot - 1 } else { slot };
            move_link(context, from, to);
        }
    }

    /// The stage that is drawn large, and its spikes.
    fn larger(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, passed: &Passed, card: Card) {
        let key = (passed.revision, card, context.chart_theme());
        if self.chart.as_ref().is_none_or(|(of, _)| *of != key) {
            self.chart = Some((key, chart(context, passed, card)));
        }
        let Some((_, chart)) = &self.chart else {
            return;
        };
        let spikes = passed.spikes(card);
        let line = ui.text_style_height(&egui::TextStyle::Body) + 5.0;
        let wanted = line * (spikes.len().max(1) + 1) as f32 + 34.0;
        let below = wanted.min(TABLE_SHARE * ui.available_height());
        let size = vec2(
            ui.available_width(),
            ui.available_height() - below - ui.spacing().item_spacing.y,
        );
        let shown = ChartView::show(ui, chart, "chain", size, context.theme);
        context.wishes.extend(shown.wish);
        spike_table(ui, context, passed, card);
    }
}

/// The card whose spectrum is drawn.
fn chosen(context: &PageContext<'_>, count: usize) -> Card {
    let memory = context.memory.products.chain;
    match (memory.light, memory.stage, count) {
        (true, ..) | (_, _, 0) => Card::Light,
        (false, Some(stage), _) => Card::Stage(stage.min(count - 1)),
        (false, None, _) => Card::Stage(count - 1),
    }
}

fn choose(context: &mut PageContext<'_>, card: Card) {
    let memory = &mut context.memory.products.chain;
    match card {
        Card::Light => memory.light = true,
        Card::Stage(index) => {
            memory.light = false;
            memory.stage = Some(index);
        }
    }
}

fn change(context: &mut PageContext<'_>, change: impl FnOnce(&mut Products)) {
    let mut products = context.app.document().products.clone();
    change(&mut products);
    context.commands.push(Command::Products(products));
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

fn head(ui: &mut Ui, context: &mut PageContext<'_>, passed: &Passed) {
    ui.horizontal_wrapped(|ui| {
        let app = context.app;
        let count = passed.told.passage.steps.len();
        let room = count < MOST_LINKS;
        let chosen = ui
            .add_enabled_ui(room, |ui| {
                Picker {
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
            choose(context, Card::Stage(count));
        }
        if !room {
            ui.weak(format!("{MOST_LINKS} at most."));
        }
        way(ui, context);
        if ui
            .button(names::COPY_STAGES)
            .on_hover_text("Copies the light and every stage as a table.")
            .clicked()
        {
            let chain = &app.document().products.chain;
            ui.ctx().copy_text(stages_csv(app, &passed.told, chain));
        }
        if count > 0
            && ui
                .button(names::CLEAR)
                .on_hover_text("Takes all factors away; undo brings them back.")
                .clicked()
        {
            change(context, |products| products.chain.clear());
        }
    });
}

/// The ways of forming products.
fn way(ui: &mut Ui, context: &mut PageContext<'_>) {
    let mut settings = context.app.document().settings;
    let before = settings.sampling;
    ui.label("formed by").on_hover_text(
        "How the model's product of light and factor is formed; the exact side is always the \
         measured curves at every nm.",
    );
    let (words, meaning) = sampling_words(before);
    let combo = ComboBox::from_id_salt("chain's products")
        .selected_text(words)
        .width(120.0 * context.theme.scale)
        .show_ui(ui, |ui| {
            for sampling in Sampling::ALL {
                let (words, meaning) = sampling_words(sampling);
                ui.selectable_value(&mut settings.sampling, sampling, words)
                    .on_hover_text(meaning);
            }
        });
    named(&combo.response, egui::Role::ComboBox, names::WAY);
    combo.response.on_hover_text(meaning);
    if settings.sampling != before {
        context.commands.push(Command::Edit(settings));
    }
}

/// A line about the chain as one product.
fn totals(ui: &mut Ui, context: &PageContext<'_>, passed: &Passed) {
    let total = passed.told.passage.total();
    let derived = &passed.lit.derived;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let mut figure = |what: &str, value: String, meaning: &str| {
            ui.weak(what).on_hover_text(meaning);
            ui.strong(value).on_hover_text(meaning);
            ui.add_space(6.0);
        };
        figure(
            "ΔE00",
            delta(total.colours.delta_e_2000),
            "CIEDE2000 between the measured light times the measured factors and the model's \
             product; the white is the exact light.",
        );
        figure(
            "of it forming",
            delta(total.added),
            "CIEDE2000 that forming the products adds, against the exact product of the same \
             model and series. Errors of colour do not simply add up.",
        );
        figure(
            "luminance",
            percent(total.colours.luminance_error, true),
            "Y of the model over Y exact, minus 1, percent.",
        );
        figure(
            "folded",
            percent(Some(total.folded_share), false),
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
            percent(total.transmission[0], false),
            "Y of what comes out over Y of the light, exact.",
        );
        if derived.errors.is_none() || derived.colour.exact.is_none() {
            ui.colored_label(context.theme.warning, "▲");
            ui.label(if derived.errors.is_none() {
                "The light is zero over the whole range."
            } else {
                "No visible light in this range: there is no colour."
            });
        }
    });
}

/// One card; its response is the card's own, below what stands on it.
fn card(ui: &mut Ui, context: &mut PageContext<'_>, passed: &Passed, card: Card) -> egui::Response {
    let count = passed.told.passage.steps.len();
    let is_chosen = chosen(context, count) == card;
    let sense = match card {
        Card::Light => Sense::click(),
        Card::Stage(_) => Sense::click_and_drag(),
    };
    let salt = match card {
        Card::Light => ("card", 0),
        Card::Stage(index) => ("card", index + 1),
    };
    let builder = UiBuilder::new().id_salt(salt).sense(sense);
    let response = ui
        .scope_builder(builder, |ui| {
            // A press on words is a press on the card.
            ui.style_mut().interaction.selectable_labels = false;
            let visuals = ui.visuals();
            let own = ui.response();
            let stroke = if is_chosen || own.has_focus() {
                Stroke::new(2.0, visuals.widgets.active.bg_stroke.color)
            } else {
                visuals.widgets.noninteractive.bg_stroke
            };
            let fill = if own.hovered() && !is_chosen {
                visuals.widgets.inactive.bg_fill
            } else {
                visuals.faint_bg_color
            };
            Frame::new()
                .fill(fill)
                .stroke(stroke)
                .corner_radius(4)
                .inner_margin(Margin::symmetric(8, 6))
                .show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    ui.spacing_mut().item_spacing.y = 3.0;
                    match card {
                        Card::Light => light_card(ui, context, passed),
                        Card::Stage(index) => stage_card(ui, context, passed, index),
                    }
                });
        })
        .response;
    let name = match card {
        Card::Light => format!("Light: {}", context.app.document().light.name()),
        Card::Stage(index) => format!("Stage {}: {}", index + 1, passed.told.names[index]),
    };
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::Button, true, is_chosen, name.as_str())
    });
    if response.clicked() {
        choose(context, card);
    }
    response
}

fn light_card(ui: &mut Ui, context: &mut PageContext<'_>, passed: &Passed) {
    let app = context.app;
    ui.horizontal(|ui| {
        ui.weak("Light");
        let chosen = Picker {
            name: names::LIGHT,
            meaning: "Another light, shipped or your own; it becomes the window's light.",
            says: app.document().light.name(),
            offers: lights,
            width: ui.available_width() - 4.0,
        }
        .show(ui, app);
        if let Some(entry) = chosen {
            context.commands.push(Command::Show(entry));
        }
    });
    let light = passed.told.passage.light;
    picture(ui, context, passed, Card::Light, &light);
    figures(ui, context, passed, &light, None);
}

fn stage_card(ui: &mut Ui, context: &mut PageContext<'_>, passed: &Passed, index: usize) {
    let app = context.app;
    let chain = &app.document().products.chain;
    let (Some(link), Some(step)) = (chain.get(index), passed.told.passage.steps.get(index)) else {
        return;
    };
    let number = index + 1;
    ui.horizontal(|ui| {
        grip(ui, context.theme);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            let mut button = |sign: &str, what: &str, meaning: &str, on: bool| {
                let button = egui::Button::new(sign).small();
                let response = ui.add_enabled(on, button);
                let name = format!("{what} stage {number}");
                response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, on, &name));
                response.on_hover_text(meaning).clicked()
            };
            if button("×", "Remove", "Takes this factor out of the chain.", true) {
                change(context, |products| drop(products.chain.remove(index)));
            }
            let last = index + 1 == chain.len();
            if button("↓", "Move down", "Later in the chain.", !last) {
                move_link(context, index, index + 1);
            }
            if button("↑", "Move up", "Earlier in the chain.", index > 0) {
                move_link(context, index, index - 1);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let name = RichText::new(format!("{number}  {}", link.entry.name())).strong();
                ui.add(Label::new(name).truncate()).on_hover_text(format!(
                    "{}\n{}",
                    link.entry.key, link.entry.spectrum.source
                ));
            });
        });
    });
    picture(ui, context, passed, Card::Stage(index), &step.colours);
    figures(ui, context, passed, &step.colours, Some(step.transmission));
    ui.horizontal(|ui| {
        thickness(ui, context, link, index);
        times(ui, context, link, index);
    });
    for note in &passed.notes[index] {
        ui.horizontal_top(|ui| {
            ui.colored_label(context.theme.warning, "▲");
            let mut text = note.clone();
            if let Some(first) = text.get(..1).map(str::to_uppercase) {
                text.replace_range(..1, &first);
            }
            ui.add(Label::new(RichText::new(text).small()).wrap());
        });
    }
}

/// Six dots: this can be taken in the hand.
fn grip(ui: &mut Ui, theme: Theme) {
    let (rect, _) = ui.allocate_exact_size(vec2(8.0, 14.0) * theme.scale, Sense::hover());
    for row in 0..3 {
        for column in 0..2 {
            let at = rect.center()
                + vec2(column as f32 * 4.0 - 2.0, row as f32 * 4.0 - 4.0) * theme.scale;
            ui.painter()
                .circle_filled(at, 1.2 * theme.scale, theme.faint);
        }
    }
}

/// The small spectrum and the split swatch of a card.
fn picture(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    passed: &Passed,
    card: Card,
    colours: &Colours,
) {
    let theme = context.theme;
    ui.horizontal(|ui| {
        let swatch_width = SWATCH * theme.scale;
        let size = vec2(
            (ui.available_width() - swatch_width - 6.0).max(40.0),
            SPARK * theme.scale,
        );
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        let index = match card {
            Card::Light => 0,
            Card::Stage(index) => index + 1,
        };
        ui.painter().rect_filled(rect, 2.0, theme.ground);
        let [exact, smooth] = &passed.sparks[index];
        small_curve(ui, rect, smooth, ink(theme.inks.smooth));
        small_curve(ui, rect, exact, ink(theme.inks.measured));
        response.on_hover_text(
            "The exact light behind this stage and the model's smooth part, over the exact peak.",
        );
        swatch_of(ui, passed, colours, index, swatch_width).map_or_else(
            || {
                ui.weak("no colour")
                    .on_hover_text("No visible light in this range.");
            },
            |clicked| {
                if clicked {
                    choose(context, card);
                }
            },
        );
    });
}

/// The split swatch; whether it was clicked, `None` without a colour.
fn swatch_of(
    ui: &mut Ui,
    passed: &Passed,
    colours: &Colours,
    index: usize,
    width: f32,
) -> Option<bool> {
    let passage = &passed.told.passage;
    let (exact, model) = (
        scaled(passage, colours.exact)?,
        scaled(passage, colours.model)?,
    );
    let name = match index {
        0 => "Light, exact and model".to_owned(),
        stage => format!("Stage {stage}, exact and model"),
    };
    let size = Vec2::new(width, ui.available_height());
    let response = swatch::split(ui, size, &exact.1, &model.1, &name);
    let clicked = response.clicked();
    response.on_hover_text(format!(
        "Left exact {}, right the model {}, the light's Y as the screen's white.\nY {} and {} of \
         the light's 100.",
        exact.1.hex(),
        model.1.hex(),
        short(exact.0.y),
        short(model.0.y),
    ));
    Some(clicked)
}

fn small_curve(ui: &Ui, rect: Rect, heights: &[f32], colour: Color32) {
    let rect = rect.shrink2(vec2(2.0, 2.0));
    let step = rect.width() / (heights.len().max(2) - 1) as f32;
    let points = heights.iter().enumerate().map(|(i, h)| {
        pos2(
            rect.left() + i as f32 * step,
            rect.bottom() - h * rect.height(),
        )
    });
    let stroke = Stroke::new(1.2, colour);
    ui.painter()
        .add(egui::Shape::line(points.collect(), stroke));
}

/// Transmission, luminance and error of a card.
fn figures(
    ui: &mut Ui,
    context: &PageContext<'_>,
    passed: &Passed,
    colours: &Colours,
    passes: Option<[Option<f64>; 2]>,
) {
    let y = |xyz| scaled(&passed.told.passage, xyz).map(|(xyz, _)| xyz.y);
    let [exact, model] = [colours.exact, colours.model].map(y);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let font = egui::TextStyle::Small.resolve(ui.style());
        let inks = [context.theme.faint, ui.visuals().text_color()];
        let mut pair = |what: &str, text: String, meaning: &str| {
            // One text, so that a figure is never parted from its name.
            let mut job = egui::text::LayoutJob::default();
            for (text, colour) in [what, &text].into_iter().zip(inks) {
                let format = egui::TextFormat::simple(font.clone(), colour);
                job.append(text, if job.text.is_empty() { 0.0 } else { 4.0 }, format);
            }
            ui.add(Label::new(job).extend()).on_hover_text(meaning);
            ui.add_space(4.0);
        };
        if let Some([exact, model]) = passes {
            pair(
                "passes",
                format!("{} | {}", percent(exact, false), percent(model, false)),
                "Transmission or reflection of this factor for this light: Y out over Y in, \
                 exact | model.",
            );
        }
        pair(
            "Y",
            format!("{} | {}", plain(exact), plain(model)),
            "Luminance, the light's at 100: exact | model.",
        );
        pair(
            "ΔE00",
            delta(colours.delta_e_2000),
            "CIEDE2000 between exact and model; the white is the exact light.",
        );
        pair(
            "lum.",
            percent(colours.luminance_error, true),
            "Luminance error: Y model over Y exact, minus 1.",
        );
    });
}

fn thickness(ui: &mut Ui, context: &mut PageContext<'_>, link: &Link, index: usize) {
    if !link.has_thickness() {
        return;
    }
    let label = ui.label(
        RichText::new("thickness")
            .small()
            .color(context.theme.faint),
    );
    let mm = link.measured_mm();
    let unit = mm.unwrap_or(1.0);
    let mut value = link.thickness * unit;
    let drag = DragValue::new(&mut value)
        .range(*THICKNESSES.start() * unit..=*THICKNESSES.end() * unit)
        .speed(0.02 * unit)
        .custom_formatter(|v, _| short(v));
    let drag = match mm {
        Some(_) => drag.suffix(" mm"),
        None => drag.suffix(" ×"),
    };
    let response = ui.add(drag);
    let name = format!("Thickness of stage {}", index + 1);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, &name));
    let meaning = match mm {
        Some(mm) => format!(
            "Thickness of the glass, mm; measured at {} mm. Internal transmittance to the power \
             of the ratio (Beer-Lambert).",
            short(mm)
        ),
        None => "Thickness as a multiple of the measured one (Beer-Lambert): each share to this \
                 power. For glasses and filters."
            .to_owned(),
    };
    let changed = response.changed();
    label.on_hover_text(&meaning);
    response.on_hover_text(meaning);
    if changed {
        let ratio = value / unit;
        change(context, |products| products.chain[index].thickness = ratio);
    }
}

fn times(ui: &mut Ui, context: &mut PageContext<'_>, link: &Link, index: usize) {
    let meaning = "How many times in a row the light meets it: bounces off a surface, passes \
                   through a filter.";
    let label = ui.label(RichText::new("met").small().color(context.theme.faint));
    label.on_hover_text(meaning);
    let mut bounces = link.bounces;
    let response = ui.add(
        DragValue::new(&mut bounces)
            .range(BOUNCES)
            .speed(0.05)
            .suffix(if link.bounces == 1 { " time" } else { " times" }),
    );
    let name = format!("Bounces of stage {}", index + 1);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, &name));
    let changed = response.changed();
    response.on_hover_text(meaning);
    if changed {
        change(context, |products| products.chain[index].bounces = bounces);
    }
}

fn chart(context: &PageContext<'_>, passed: &Passed, card: Card) -> Chart {
    let document = context.app.document();
    let light = &document.light;
    let steps = &passed.told.passage.steps;
    let derived = &passed.lit.derived;
    let (title, exact, smooth) = match card {
        Card::Light => (
            format!("The light: {}", light.name()),
            &derived.measured,
            &derived.smooth,
        ),
        Card::Stage(index) => (
            format!("Behind stage {}: {}", index + 1, passed.told.names[index]),
            &steps[index].exact,
            &steps[index].smooth,
        ),
    };
    let mut notes = vec![format!("Light: {}", light.name())];
    let names = passed.told.names.iter().enumerate();
    notes.extend(names.map(|(i, name)| format!("{}. {name}", i + 1)));
    notes.extend(provenance(context.app));
    stage_chart(
        StageDrawn {
            title: &title,
            band: derived.band,
            exact,
            smooth,
            spikes: passed.spikes(card),
            known: &passed.told.known,
            width_nm: document.settings.max_width_nm,
            factor: document.scale.factor(&light.spectrum).unwrap_or(1.0),
            unit: &document.scale.unit(&light.spectrum),
            notes: &notes,
        },
        context.chart_theme(),
    )
}

/// The spikes behind the stage that is drawn.
fn spike_table(ui: &mut Ui, context: &PageContext<'_>, passed: &Passed, card: Card) {
    let (app, spikes) = (context.app, passed.spikes(card));
    ui.horizontal(|ui| {
        let title = "Spikes, carried exactly (Eq. 14)";
        ui.strong(title).on_hover_text(
            "Each spike keeps its place; its weight is multiplied by the factor where it stands.",
        );
        if !spikes.is_empty()
            && ui
                .small_button(names::COPY_SPIKES)
                .on_hover_text("Copies places, weights and names as a table.")
                .clicked()
        {
            let stage = match card {
                Card::Light => "the light",
                Card::Stage(index) => &passed.told.names[index],
            };
            ui.ctx()
                .copy_text(spikes_csv(app, stage, spikes, &passed.told.known));
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
             at its place. A dip of a factor has none in the light.",
            1.1,
        ),
        Column::words(
            "line",
            "Named only where it is safe; otherwise the nearest line.",
            1.4,
        ),
    ];
    let own = &passed.lit.derived.model.spikes;
    let rows: Vec<Row> = spikes
        .iter()
        .map(|spike| row(spike, own, factor, &passed.told.known))
        .collect();
    ScrollArea::vertical()
        .id_salt("spikes of the stage")
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.set_max_width(ui.available_width() - 8.0);
            table(ui, &columns, &rows, None, false, context.theme);
        });
}

fn row(spike: &Spike, own: &[Spike], factor: f64, known: &KnownLines) -> Row {
    let in_light = own.iter().find(|s| s.at_nm == spike.at_nm);
    let share = in_light.map(|s| spike.weight / s.weight);
    let name = known
        .at(spike.at_nm)
        .and_then(|name| name.safe.clone().or_else(|| name.near.clone()))
        .unwrap_or_else(|| "–".to_owned());
    let cells = vec![
        format!("{:.1}", spike.at_nm),
        short(spike.weight * factor),
        percent(share.filter(|s| s.is_finite()), false),
        name.clone(),
    ];
    Row {
        name: format!("Spike at {} nm, weight {}, {name}", cells[0], cells[1]),
        cells,
        note: String::new(),
    }
}

/// A colour difference, or a dash.
fn delta(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(value) if value != 0.0 && value < 0.0005 => "<.001".to_owned(),
        Some(value) => format!("{value:.3}"),
    }
}

/// A share in percent, or a dash; `signed` for what may go both ways.
fn percent(share: Option<f64>, signed: bool) -> String {
    let Some(share) = share else {
        return "–".to_owned();
    };
    // Adding zero turns -0 into 0.
    let value = (1e4 * share).round() / 1e2 + 0.0;
    match (share != 0.0 && value == 0.0, signed) {
        (true, _) => "<.01 %".to_owned(),
        (false, true) => format!("{value:+.2} %"),
        (false, false) => format!("{value:.2} %"),
    }
}

fn plain(value: Option<f64>) -> String {
    value.map_or_else(
        || "–".to_owned(),
        |value| short((1e3 * value).round() / 1e3 + 0.0),
    )
}
