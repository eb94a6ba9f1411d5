//! The part "Two lights": patches under two lights, metamers found and made.

use std::sync::Arc;

use eframe::egui;
use egui::{
    Align, Align2, Button, ComboBox, CornerRadius, Layout, Rect, RichText, ScrollArea, Sense,
    Slider, Stroke, TextStyle, Ui, Vec2, pos2, vec2,
};

use super::picker::{self, Picker};
use crate::{
    app::{
        Command, View,
        charts::products::lights::{lights_chart, made_chart, pair_chart},
        library::Library,
        plot_svg::{self, Chart},
        products::{
            Products,
            memory::ROOM_PERCENT,
            two_lights::{LightsSheet, Made, NoMetamer, pairs_csv, swatches},
        },
        studies::{
            PairsAsk, Same, Stage,
            surfaces::{Pairs, shipped_reflectances},
        },
    },
    color::{Adaptation, Swatch},
    study::{
        Progress,
        products::{TwoLights, lights::MATCH_DELTA_E},
    },
    ui::{
        chart_view::ChartView,
        model_view::named,
        pages::{PageContext, progress},
        patches_view::set_title,
        swatch,
    },
};

/// From this width on the part has two columns, points.
const WIDE: f32 = 940.0;

/// Most fields in one row: the ColorChecker makes two rows.
const PER_ROW: usize = 12;

/// Rows of fields that are seen at a time.
const ROWS: usize = 2;

/// Found pairs that are seen at a time.
const PAIR_ROWS: usize = 6;

/// What buttons and lists are called.
pub mod names {
    /// The list of second lights.
    pub const OTHER: &str = "Second light";
    /// The list of patch sets.
    pub const SET: &str = "Patch set";
    /// Where pairs are looked for.
    pub const AMONG: &str = "Pairs among";
    /// Copies the patches.
    pub const COPY_PATCHES: &str = "Copy the patches as CSV";
    /// Copies the pairs.
    pub const COPY_PAIRS: &str = "Copy the pairs as CSV";
    /// The patch that a metamer is made of.
    pub const PATCH: &str = "Patch";
    /// How much of the room is used.
    pub const ROOM: &str = "Part of the room";
    /// Keeps the metamer.
    pub const KEEP: &str = "Keep as my own spectrum";
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct LightsView {
    built: Option<Built>,
    made: Option<MadeBuilt>,
    found: Option<FoundBuilt>,
}

/// What a revision of the document shows.
struct Built {
    of: (u64, plot_svg::Theme),
    sheet: Option<LightsSheet>,
    exact: Vec<[Swatch; 2]>,
    model: Vec<[Swatch; 2]>,
    chart: Option<Chart>,
}

/// The metamer made, for a revision, a theme, a patch and a part of the room.
struct MadeBuilt {
    of: (u64, plot_svg::Theme, usize, i32),
    made: Result<(Made, Chart, Vec<[Swatch; 2]>), NoMetamer>,
}

/// The pairs found: swatches of all surfaces and the chosen pair's chart.
struct FoundBuilt {
    pairs: Arc<Pairs>,
    /// The lights that they were found under.
    lights: [String; 2],
    of: (Adaptation, plot_svg::Theme, usize),
    swatches: Vec<[Swatch; 2]>,
    chart: Option<Chart>,
}

impl LightsView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        head(ui, context);
        self.rebuild(context);
        if let Some(ask) = &pairs_ask(context) {
            context.studies.surfaces.pairs.ask(ask, context.wake, || {
                let ask = ask.clone();
                move |progress: &Progress| ask.answer(progress)
            });
        }
        self.rebuild_pairs(context);
        let Self { built, made, found } = self;
        let Some(built) = built else {
            return;
        };
        let Some(sheet) = &built.sheet else {
            ui.add_space(8.0);
            ui.label("Choose a second light above to see the patches under both.");
            return;
        };
        let room = ui.available_size();
        let scale = context.theme.scale;
        let id = "two lights";
        ScrollArea::vertical()
            .id_salt(id)
            .auto_shrink(false)
            .show(ui, |ui| {
                // The bar of the scroll area stands over the right edge.
                let width = ui.available_width() - 10.0;
                ui.set_max_width(width);
                if width >= WIDE * scale {
                    let chart =
                        (0.5 * (room.y - 400.0 * scale)).clamp(180.0 * scale, 400.0 * scale);
                    let lights = (room.y - 250.0 * scale).clamp(chart, 520.0 * scale);
                    ui.columns(2, |columns| {
                        column(&mut columns[0], |ui| {
                            patches(ui, context, built, sheet);
                            ui.add_space(6.0);
                            spectra(ui, context, built, lights);
                        });
                        column(&mut columns[1], |ui| {
                            made_section(ui, context, sheet, made, chart);
                            ui.add_space(6.0);
                            found_section(ui, context, found, chart);
                        });
                    });
                } else {
                    let chart = (0.34 * room.y).clamp(170.0 * scale, 240.0 * scale);
                    patches(ui, context, built, sheet);
                    ui.add_space(6.0);
                    spectra(ui, context, built, chart);
                    ui.add_space(6.0);
                    made_section(ui, context, sheet, made, chart);
                    ui.add_space(6.0);
                    found_section(ui, context, found, chart);
                }
            });
    }

    fn rebuild(&mut self, context: &PageContext<'_>) {
        let (app, theme) = (context.app, context.chart_theme());
        let of = (app.revision(), theme);
        if self.built.as_ref().is_none_or(|built| built.of != of) {
            // A theme alone changes no figure.
            let same = self.built.take().filter(|built| built.of.0 == of.0);
            let sheet = match same {
                Some(built) => built.sheet,
                None => LightsSheet::of(app),
            };
            let adaptation = adaptation(context);
            let of_all = |both: &Option<TwoLights>| {
                both.as_ref()
                    .map_or_else(Vec::new, |both| swatches(both, adaptation))
            };
            self.built = Some(Built {
                of,
                exact: sheet.as_ref().map_or_else(Vec::new, |s| of_all(&s.exact)),
                model: sheet.as_ref().map_or_else(Vec::new, |s| of_all(&s.model)),
                chart: sheet.as_ref().map(|sheet| lights_chart(app, sheet, theme)),
                sheet,
            });
        }
        let Some(sheet) = self.built.as_ref().and_then(|built| built.sheet.as_ref()) else {
            self.made = None;
            return;
        };
        let memory = context.memory.products.lights;
        let patch = memory.patch.min(sheet.names.len().saturating_sub(1));
        let of = (of.0, of.1, patch, memory.room_percent);
        if self.made.as_ref().is_none_or(|made| made.of != of) {
            let made = Made::of(sheet, patch, memory.room_percent).map(|made| {
                let chart = made_chart(app, sheet, &made, theme);
                let shown = swatches(&made.both, adaptation(context));
                (made, chart, shown)
            });
            self.made = Some(MadeBuilt { of, made });
        }
    }

    fn rebuild_pairs(&mut self, context: &PageContext<'_>) {
        let Some((ask, pairs)) = context.studies.surfaces.pairs.answer() else {
            self.found = None;
            return;
        };
        let last = pairs.metamers.pairs.len().saturating_sub(1);
        let chosen = context.memory.products.lights.pair.min(last);
        let of = (adaptation(context), context.chart_theme(), chosen);
        let is_built = |found: &FoundBuilt| Arc::ptr_eq(&found.pairs, pairs) && found.of == of;
        if self.found.as_ref().is_some_and(is_built) {
            return;
        }
        let pair = pairs.metamers.pairs.get(chosen);
        self.found = Some(FoundBuilt {
            of,
            swatches: swatches(&pairs.both, of.0),
            lights: [0, 1].map(|i| ask.lights[i].0.name().to_owned()),
            chart: pair.map(|pair| {
                let pair = pair.pair.map(|i| &pairs.surfaces[i]);
                pair_chart(context.app, ask.band, pair, of.1)
            }),
            pairs: pairs.clone(),
        });
    }
}

/// A column whose text is ragged: columns are justified otherwise.
pub(super) fn column(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    ui.with_layout(Layout::top_down(Align::Min), add);
}

fn adaptation(context: &PageContext<'_>) -> Adaptation {
    if context.app.document().view.adapt_patches {
        Adaptation::ToLight
    } else {
        Adaptation::None
    }
}

fn pairs_ask(context: &PageContext<'_>) -> Option<PairsAsk> {
    let document = context.app.document();
    let other = document.products.other_light.clone()?;
    let everywhere = context.memory.products.lights.everywhere;
    Some(PairsAsk {
        lights: [Same(document.light.clone()), Same(other)],
        band: document.settings.band,
        observer: document.settings.observer,
        group: (!everywhere).then(|| document.patch_set.clone()),
    })
}

/// The lights, the patch set and how fields are shown.
fn head(ui: &mut Ui, context: &mut PageContext<'_>) {
    let document = context.app.document();
    ui.horizontal_wrapped(|ui| {
        ui.label("Under");
        ui.add(egui::Label::new(RichText::new(document.light.name()).strong()).truncate())
            .on_hover_text("The document's light: choose another in the library.");
        ui.label("and");
        let other = document.products.other_light.as_ref();
        let chosen = Picker {
            name: names::OTHER,
            meaning: "The light that the patches are seen under on the right of each field.",
            says: other.map_or("choose a light", |light| light.name()),
            offers: picker::lights,
            width: 150.0 * context.theme.scale,
        }
        .show(ui, context.app);
        if let Some(light) = chosen {
            context.commands.push(Command::Products(Products {
                other_light: Some(light),
                ..document.products.clone()
            }));
        }
        ui.separator();
        set_combo(ui, context);
        let mut adapt = document.view.adapt_patches;
        let response = ui.checkbox(&mut adapt, "Adapt").on_hover_text(
            "Shows each half as an eye adapted to its light sees it (Bradford). It changes the \
             colours on screen, not the figures.",
        );
        if response.changed() {
            context.commands.push(Command::View(View {
                adapt_patches: adapt,
                ..document.view
            }));
        }
    });
}

fn set_combo(ui: &mut Ui, context: &mut PageContext<'_>) {
    let document = context.app.document();
    let combo = ComboBox::from_id_salt("set under two lights")
        .selected_text(set_title(&document.patch_set))
        .width(128.0 * context.theme.scale)
        .show_ui(ui, |ui| {
            let groups = Library::bundled().all_groups();
            for group in groups.filter(|g| g.items.iter().any(|p| p.kind.is_factor())) {
                let is_chosen = document.patch_set == group.id;
                let response = ui.selectable_label(is_chosen, set_title(&group.id));
                if response.on_hover_text(&group.title).clicked() {
                    context.commands.push(Command::PatchSet(group.id.clone()));
                }
            }
        });
    named(&combo.response, egui::Role::ComboBox, names::SET);
    combo
        .response
        .on_hover_text("Whose reflectances are seen under both lights.");
}

/// A section's title with a button that copies its table.
fn title(ui: &mut Ui, words: &str, copy: Option<(&str, &dyn Fn() -> String)>) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(words).heading());
        if let Some((name, text)) = copy {
            let button = ui.small_button("Copy as CSV");
            named(&button, egui::Role::Button, name);
            if button.clicked() {
                ui.ctx().copy_text(text());
            }
        }
    });
}

/// The patches, what they do and how well the models tell it.
fn patches(ui: &mut Ui, context: &mut PageContext<'_>, built: &Built, sheet: &LightsSheet) {
    let copy = || sheet.csv();
    title(
        ui,
        "Patches under both lights",
        Some((names::COPY_PATCHES, &copy)),
    );
    let (Some(exact), Some(model)) = (&sheet.exact, &sheet.model) else {
        ui.label("One of the lights is not seen on this range, so there is no colour to compare.");
        return;
    };
    let [first, second] = &sheet.lights;
    if let (Some(mean), Some(worst)) = (exact.mean(), exact.worst()) {
        ui.label(format!(
            "From {first} to {second} the patches move by ΔE00 {mean:.2} on average, most {} by \
             {:.2}.",
            sheet.names[worst], exact.patches[worst].delta_e_2000
        ))
        .on_hover_text(
            "CIEDE2000 between the patch under the first light and under the second, each \
             against its own light's white: what is left when the eye has adapted.",
        );
    }
    if let (Some(mean), Some((off, most, by))) = (model.mean(), sheet.shift_error()) {
        ui.label(format!(
            "By the models of both lights {mean:.2} on average; a patch's shift is off by {off:.3} \
             on average, at most by {by:.3} ({}).",
            sheet.names[most]
        ))
        .on_hover_text(
            "The same shift with both lights replaced by their models (same settings, whites of \
             the measured lights), and its difference to the shift by the measured lights.",
        );
    }
    ui.weak(
        "Left under the first light, right under the second; above as measured, the strip below \
         by the models. Under each field its shift ΔE00, measured and (m) by the models.",
    );
    ui.weak(if context.app.document().view.adapt_patches {
        "Each half is shown adapted to its own light, as the figures have it."
    } else {
        "Each half keeps the tint of its own light, which the figures leave out (Adapt takes it \
         away)."
    });
    ui.add_space(2.0);
    fields(ui, context, built, sheet, [exact, model]);
}

fn fields(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    built: &Built,
    sheet: &LightsSheet,
    [exact, model]: [&TwoLights; 2],
) {
    let gap = 4.0;
    let scale = context.theme.scale;
    let count = sheet.names.len();
    let width = ((ui.available_width() - 10.0 - gap * (PER_ROW - 1) as f32) / PER_ROW as f32)
        .min(90.0 * scale)
        .floor();
    let text = ui.text_style_height(&TextStyle::Small);
    let size = vec2(width, 40.0 * scale + 2.0 * text + 2.0);
    let rows = count.div_ceil(PER_ROW);
    let seen = rows.min(ROWS) as f32;
    // Half a row more tells that there are more.
    let half = if rows > ROWS { 0.5 } else { 0.0 };
    let worst = exact.worst();
    let chosen = context.memory.products.lights.patch.min(count.max(1) - 1);
    let mut clicked = None;
    ScrollArea::vertical()
        .id_salt("fields under two lights")
        .max_height((seen + half) * (size.y + gap))
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(gap, gap);
            for row in 0..rows {
                ui.horizontal(|ui| {
                    for i in row * PER_ROW..count.min((row + 1) * PER_ROW) {
                        let shifts = [exact, model].map(|both| both.patches[i].delta_e_2000);
                        let field = Field {
                            name: &sheet.names[i],
                            exact: &built.exact[i],
                            model: &built.model[i],
                            shifts,
                            worst: worst == Some(i),
                            chosen: chosen == i,
                        };
                        if field.show(ui, size) {
                            clicked = Some(i);
                        }
                    }
                });
            }
        });
    if let Some(patch) = clicked {
        context.memory.products.lights.patch = patch;
    }
}

/// One patch: above as measured, below by the models; left and right the two lights.
struct Field<'a> {
    name: &'a str,
    exact: &'a [Swatch; 2],
    model: &'a [Swatch; 2],
    /// CIEDE2000, measured and by the models.
    shifts: [f64; 2],
    worst: bool,
    chosen: bool,
}

impl Field<'_> {
    fn show(&self, ui: &mut Ui, size: Vec2) -> bool {
        let Self {
            name,
            exact,
            model,
            shifts,
            worst,
            chosen,
        } = self;
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let said = format!(
            "{name}: shift {:.3}, by the models {:.3}",
            shifts[0], shifts[1]
        );
        response.widget_info(|| {
            egui::WidgetInfo::selected(egui::Role::Button, ui.is_enabled(), *chosen, &said)
        });
        if !ui.is_rect_visible(rect) {
            return response.clicked();
        }
        let text = ui.text_style_height(&TextStyle::Small);
        let colours = rect.with_max_y(rect.bottom() - 2.0 * text - 2.0);
        let seam = (colours.top() + 0.7 * colours.height()).round();
        let lower = colours.with_min_y(seam);
        let [left, right] = exact.map(|s| swatch::colour(s.rgb8));
        swatch::paint_split(ui, colours, left, right);
        // No corners where the two parts meet: what differs is seen as a step.
        let [left, right] = model.map(|s| swatch::colour(s.rgb8));
        let (l, r) = lower.split_left_right_at_x(lower.center().x.round());
        let corner = |sw, se| CornerRadius {
            sw,
            se,
            ..CornerRadius::ZERO
        };
        ui.painter().rect_filled(l, corner(3, 0), left);
        ui.painter().rect_filled(r, corner(0, 3), right);
        for (side, x) in [(0, rect.left() + 9.0), (1, rect.right() - 9.0)] {
            if !exact[side].in_gamut {
                swatch::out_of_gamut_mark(ui, pos2(x, rect.top() + 8.0));
            }
        }
        if *chosen {
            let stroke = Stroke::new(2.0, ui.visuals().strong_text_color());
            swatch::outline(ui, colours, stroke);
        } else if response.hovered() || response.has_focus() {
            swatch::outline(ui, colours, ui.visuals().widgets.active.bg_stroke);
        }
        let font = TextStyle::Small.resolve(ui.style());
        let (strong, weak) = (ui.visuals().text_color(), ui.visuals().weak_text_color());
        let mark = if *worst { "▲" } else { "" };
        let x = rect.center().x;
        for (line, words, colour) in [
            (2.0, format!("{mark}{:.2}", shifts[0]), strong),
            (1.0, format!("m {:.2}", shifts[1]), weak),
        ] {
            let at = pos2(x, rect.bottom() - line * text);
            ui.painter()
                .text(at, Align2::CENTER_TOP, words, font.clone(), colour);
        }
        let clicked = response.clicked();
        response.on_hover_text(format!(
            "{name}: ΔE00 {:.3} between the two lights, {:.3} by their models{}.\nMeasured: left \
             {}, right {}. Models: left {}, right {}.\nClick to make a metamer of it.",
            shifts[0],
            shifts[1],
            if *worst { " (the most)" } else { "" },
            exact[0].hex(),
            exact[1].hex(),
            model[0].hex(),
            model[1].hex(),
        ));
        clicked
    }
}

fn spectra(ui: &mut Ui, context: &mut PageContext<'_>, built: &Built, height: f32) {
    if let Some(chart) = &built.chart {
        let size = vec2(ui.available_width(), height);
        let shown = ChartView::show(ui, chart, "two lights", size, context.theme);
        context.wishes.extend(shown.wish);
    }
}

/// A metamer made for the chosen patch.
fn made_section(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &LightsSheet,
    built: &Option<MadeBuilt>,
    height: f32,
) {
    let Some(built) = built else {
        return;
    };
    title(ui, "A metamer made", None);
    ui.weak(format!(
        "A black of {} (a curve that this light shows as nothing) is added to a patch within 0 to \
         1: the sum matches it there.",
        sheet.lights[0]
    ));
    let memory = &mut context.memory.products.lights;
    ui.horizontal_wrapped(|ui| {
        let patch = built.of.2;
        let combo = ComboBox::from_id_salt("patch of the metamer")
            .selected_text(sheet.names.get(patch).map_or("", String::as_str))
            .width(130.0 * context.theme.scale)
            .truncate()
            .show_ui(ui, |ui| {
                for (i, name) in sheet.names.iter().enumerate() {
                    ui.selectable_value(&mut memory.patch, i, name);
                }
            });
        named(&combo.response, egui::Role::ComboBox, names::PATCH);
        combo
            .response
            .on_hover_text("The patch that is changed; a click on a field chooses it too.");
        let slider = Slider::new(&mut memory.room_percent, ROOM_PERCENT).suffix(" %");
        let slider = ui.add_enabled(built.made.is_ok(), slider);
        named(&slider, egui::Role::Slider, names::ROOM);
        slider.on_hover_text(
            "How much of the room is used before the sum leaves 0 to 1: 100 % all the way up the \
             black, -100 % all the way down, 0 % the patch itself.",
        );
        let kept = built.made.as_ref().ok().filter(|_| built.of.3 != 0);
        let button = ui
            .add_enabled(kept.is_some(), Button::new(names::KEEP))
            .on_hover_text("Puts the made reflectance into the library and opens it.")
            .on_disabled_hover_text("There is nothing made to keep.");
        if button.clicked()
            && let Some(spectrum) = kept.and_then(|(made, ..)| made.spectrum(sheet))
        {
            context.commands.push(Command::Adopt(vec![spectrum]));
        }
    });
    let (made, chart, shown) = match &built.made {
        Ok(made) => made,
        Err(why) => {
            ui.label(why.words());
            return;
        }
    };
    let scale = context.theme.scale;
    ui.horizontal_wrapped(|ui| {
        for (i, light) in sheet.lights.iter().enumerate() {
            let size = vec2(74.0, 26.0) * scale;
            let name = format!("Patch and metamer under {light}");
            swatch::split(ui, size, &shown[0][i], &shown[1][i], &name)
                .on_hover_text(format!("{name}: left the patch, right the metamer."));
            ui.label(format!("ΔE00 {:.2} under {light}", made.delta_e_2000[i]));
            ui.add_space(8.0);
        }
    });
    let size = vec2(ui.available_width(), height);
    let drawn = ChartView::show(ui, chart, "metamer made", size, context.theme);
    context.wishes.extend(drawn.wish);
}

/// Pairs found in the library.
fn found_section(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    found: &Option<FoundBuilt>,
    height: f32,
) {
    let csv = || {
        found
            .as_ref()
            .map_or_else(String::new, |found| pairs_csv(&found.lights, &found.pairs))
    };
    title(ui, "Metamers found", Some((names::COPY_PAIRS, &csv)));
    ui.horizontal_wrapped(|ui| {
        ui.label("Among");
        let set = set_title(&context.app.document().patch_set);
        let all = format!("all {} shipped reflectances", shipped_reflectances());
        let memory = &mut context.memory.products.lights;
        let combo = ComboBox::from_id_salt("pairs among")
            .selected_text(if memory.everywhere { &all } else { &set })
            .width(190.0 * context.theme.scale)
            .show_ui(ui, |ui| {
                ui.selectable_value(&mut memory.everywhere, false, &set);
                ui.selectable_value(&mut memory.everywhere, true, &all);
            });
        named(&combo.response, egui::Role::ComboBox, names::AMONG);
        combo
            .response
            .on_hover_text("Which surfaces are compared, each with each.");
        if context.studies.surfaces.pairs.stage() != Stage::Done {
            progress(ui, &mut context.studies.surfaces.pairs, "The pairs");
        }
    });
    let possible = context.studies.surfaces.pairs.stage() != Stage::Impossible;
    let Some(found) = found.as_ref().filter(|_| possible) else {
        return;
    };
    let pairs = &found.pairs.metamers.pairs;
    let [first, second] = &found.lights;
    let Some(index) = found.pairs.metamers.index else {
        ui.label(format!(
            "No two of {} surfaces match under {first} (ΔE00 below {MATCH_DELTA_E}) without being \
             the same curve.",
            found.pairs.surfaces.len()
        ));
        return;
    };
    ui.label(format!(
        "{} of {} surfaces match under {first} (ΔE00 below {MATCH_DELTA_E}); metamerism index \
         under {second}: {index:.2}.",
        if pairs.len() == 1 {
            "1 pair".to_owned()
        } else {
            format!("{} pairs", pairs.len())
        },
        found.pairs.surfaces.len()
    ))
    .on_hover_text(
        "Metamerism index: mean CIEDE2000 under the second light of all pairs that match under \
         the first. Two curves closer than 0.01 (root mean square) are one surface and no pair.",
    );
    let text = ui.text_style_height(&TextStyle::Body);
    let size = text + 8.0;
    let mut clicked = None;
    let rows = pairs.len().min(PAIR_ROWS) as f32;
    let width = ui.available_width();
    pair_head(ui, width, &found.lights);
    ScrollArea::vertical()
        .id_salt("pairs")
        .max_height(rows * size)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            ui.set_width(width);
            let height = size;
            let all = pairs.len();
            let view = ui.clip_rect();
            let top = ui.cursor().top();
            let from = (((view.top() - top) / height).floor().max(0.0) as usize).min(all);
            let to = (((view.bottom() - top) / height).ceil().max(0.0) as usize).min(all);
            ui.add_space(from as f32 * height);
            for index in from..to {
                if pair_row(ui, vec2(width, height), found, index) {
                    clicked = Some(index);
                }
            }
            ui.add_space((all - to) as f32 * height);
        });
    if let Some(pair) = clicked {
        context.memory.products.lights.pair = pair;
    }
    if let Some(chart) = &found.chart {
        ui.add_space(4.0);
        let size = vec2(ui.available_width(), height);
        let drawn = ChartView::show(ui, chart, "metamers found", size, context.theme);
        context.wishes.extend(drawn.wish);
    }
}

/// Where the parts of a pair's row begin, shares of the width: names, two pairs of swatches with
/// their figures.
const COLUMNS: [f32; 5] = [0.0, 0.58, 0.69, 0.79, 0.90];

fn pair_head(ui: &mut Ui, width: f32, lights: &[String; 2]) {
    let height = ui.text_style_height(&TextStyle::Small) + 3.0;
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let font = TextStyle::Small.resolve(ui.style());
    let colour = ui.visuals().weak_text_color();
    for (at, words) in [
        (COLUMNS[0], "surfaces"),
        (COLUMNS[1], "1st light, ΔE00"),
        (COLUMNS[3], "2nd light, ΔE00"),
    ] {
        let place = pos2(rect.left() + 4.0 + at * width, rect.top());
        ui.painter()
            .text(place, Align2::LEFT_TOP, words, font.clone(), colour);
    }
    response.on_hover_text(format!(
        "Each pair side by side under {} and under {}, with its CIEDE2000 there; those that part \
         most stand first.",
        lights[0], lights[1]
    ));
}

fn pair_row(ui: &mut Ui, size: Vec2, found: &FoundBuilt, index: usize) -> bool {
    let pair = &found.pairs.metamers.pairs[index];
    let chosen = found.of.2 == index;
    let names = pair.pair.map(|i| &found.pairs.surfaces[i]);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let said = format!(
        "Pair: {} and {}, {:.2} under the first light, {:.2} under the second",
        names[0].name, names[1].name, pair.delta_e_2000[0], pair.delta_e_2000[1]
    );
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::Button, ui.is_enabled(), chosen, &said)
    });
    let visuals = ui.visuals();
    let fill = if chosen {
        visuals.selection.bg_fill
    } else if response.hovered() || response.has_focus() {
        visuals.widgets.hovered.bg_fill
    } else if index % 2 == 1 {
        visuals.faint_bg_color
    } else {
        egui::Color32::TRANSPARENT
    };
    ui.painter().rect_filled(rect, 2.0, fill);
    let font = TextStyle::Body.resolve(ui.style());
    let colour = visuals.text_color();
    let at = |share: f32| rect.left() + 4.0 + share * rect.width();
    let both = format!("{} · {}", names[0].name, names[1].name);
    let mut job = egui::text::LayoutJob::simple_singleline(both, font.clone(), colour);
    let room = at(COLUMNS[1]) - at(COLUMNS[0]) - 8.0;
    job.wrap = egui::text::TextWrapping::truncate_at_width(room);
    let galley = ui.painter().layout_job(job);
    let top = rect.center().y - galley.size().y / 2.0;
    ui.painter()
        .galley(pos2(at(COLUMNS[0]), top), galley, colour);
    for light in 0..2 {
        let [left, right] = pair
            .pair
            .map(|i| swatch::colour(found.swatches[i][light].rgb8));
        let x = at(COLUMNS[1 + 2 * light]);
        let to = at(COLUMNS[2 + 2 * light]) - 8.0;
        let field = Rect::from_x_y_ranges(x..=to, rect.shrink2(vec2(0.0, 2.0)).y_range());
        swatch::paint_split(ui, field, left, right);
        let words = format!("{:.2}", pair.delta_e_2000[light]);
        let place = pos2(at(COLUMNS[2 + 2 * light]), rect.center().y);
        ui.painter()
            .text(place, Align2::LEFT_CENTER, words, font.clone(), colour);
    }
    let clicked = response.clicked();
    response.on_hover_text_at_pointer(format!(
        "{} and {}\nΔE00 {:.3} under the first light, {:.3} under the second; the curves differ by \
         {:.3} (root mean square).\nClick to see both curves.",
        names[0].key, names[1].key, pair.delta_e_2000[0], pair.delta_e_2000[1], pair.rms
    ));
    clicked
}
