//! The part "Same surface?": is a spectrum the light off a surface?

use std::sync::Arc;

use eframe::egui;
use egui::{
    Align2, Button, ComboBox, Frame, Margin, RichText, ScrollArea, Sense, TextStyle, Ui, Vec2,
    pos2, vec2,
};

use super::{
    lights::column,
    picker::{self, Picker},
};
use crate::{
    app::{
        Command,
        chart::{self, Chart},
        charts::products::check::check_chart,
        command::MadeFor,
        entry::Entry,
        products::{
            Products,
            same_surface::{CheckSheet, example, ranking_csv},
        },
        studies::{
            RankAsk, Stage,
            surfaces::{Ranked, shipped_reflectances},
        },
        ticks::short,
    },
    io::many::numbers,
    study::{
        Progress,
        products::{Compared, Sameness, check::SAME_RESIDUAL},
    },
    ui::{
        chart_view::ChartView,
        model_view::named,
        pages::{PageContext, progress},
        patches_view::set_title,
        swatch,
    },
};

/// From this width on words and ranking stand beside the charts, points.
const WIDE: f32 = 940.0;

/// Surfaces of the ranking that are seen at a time in a narrow window.
const ROWS: f32 = 8.0;

/// What buttons and lists are called.
pub mod names {
    /// The list of surfaces.
    pub const SURFACE: &str = "Surface S2";
    /// The list of outgoing spectra.
    pub const OUTGOING: &str = "Outgoing spectrum S3";
    /// The list of surfaces for an example.
    pub const EXAMPLE: &str = "Surface of the example";
    /// Whether the example's light meets it twice.
    pub const TWICE: &str = "twice";
    /// Makes an example.
    pub const MAKE: &str = "Make an example";
    /// Where the best surface is looked for.
    pub const AMONG: &str = "Best surface among";
    /// Copies the ranking.
    pub const COPY: &str = "Copy the ranking as CSV";
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct CheckView {
    built: Option<Built>,
    /// The surface of the example; `None` for S2.
    example: Option<Arc<Entry>>,
}

/// What a revision of the document shows.
struct Built {
    of: (u64, chart::Theme, bool),
    sheet: Option<CheckSheet>,
    ranking: Option<RankAsk>,
    charts: [Option<Chart>; 2],
}

impl CheckView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        choices(ui, context);
        self.example_row(ui, context);
        ui.separator();
        self.rebuild(context);
        let Some(built) = &self.built else {
            return;
        };
        let Some(sheet) = &built.sheet else {
            explain(ui, context);
            return;
        };
        if let Some(ask) = &built.ranking {
            context.studies.surfaces.ranking.ask(ask, context.wake, || {
                let ask = ask.clone();
                move |progress: &Progress| ask.answer(progress)
            });
        }
        let room = ui.available_size();
        let scale = context.theme.scale;
        ScrollArea::vertical()
            .id_salt("same surface")
            .auto_shrink(false)
            .show(ui, |ui| {
                // The bar of the scroll area stands over the right edge.
                let width = ui.available_width() - 10.0;
                ui.set_max_width(width);
                if width >= WIDE * scale {
                    ui.columns(2, |columns| {
                        column(&mut columns[0], |ui| {
                            verdicts(ui, context, sheet);
                            ui.add_space(6.0);
                            ranking(ui, context, sheet, room.y - 270.0 * scale);
                        });
                        let height = (0.5 * room.y - 12.0).max(240.0 * scale);
                        for (chart, id) in built.charts.iter().zip(["model", "measured"]) {
                            let size = vec2(columns[1].available_width(), height);
                            draw(&mut columns[1], context, chart, id, size);
                        }
                    });
                } else {
                    verdicts(ui, context, sheet);
                    ui.add_space(4.0);
                    let height = (0.40 * room.y).clamp(230.0 * scale, 320.0 * scale);
                    ui.columns(2, |columns| {
                        for (i, id) in ["model", "measured"].into_iter().enumerate() {
                            let size = vec2(columns[i].available_width(), height);
                            draw(&mut columns[i], context, &built.charts[i], id, size);
                        }
                    });
                    ui.add_space(6.0);
                    let row = ui.text_style_height(&TextStyle::Body) + 8.0;
                    ranking(ui, context, sheet, ROWS * row);
                }
            });
    }

    fn rebuild(&mut self, context: &PageContext<'_>) {
        let (app, theme) = (context.app, context.chart_theme());
        let everywhere = context.memory.products.check.everywhere;
        let of = (app.revision(), theme, everywhere);
        if self.built.as_ref().is_some_and(|built| built.of == of) {
            return;
        }
        // Theme and place of the search change no figure.
        let same = self.built.take().filter(|built| built.of.0 == of.0);
        let sheet = match same {
            Some(built) => built.sheet,
            None => CheckSheet::of(app),
        };
        let chart = |compared: Option<&Compared>, what: &str| {
            let sheet = sheet.as_ref()?;
            Some(check_chart(app, sheet, compared?, what, theme))
        };
        let sides = sheet.as_ref();
        self.built = Some(Built {
            of,
            charts: [
                chart(
                    sides.and_then(|s| s.model.as_ref()),
                    "In the model's numbers",
                ),
                chart(sides.and_then(|s| s.measured.as_ref()), "Measured curves"),
            ],
            ranking: sides.and_then(|sheet| sheet.ranking(app.document(), everywhere)),
            sheet,
        });
    }

    /// Makes an outgoing spectrum from the light and a surface.
    fn example_row(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let products = &context.app.document().products;
        ui.horizontal_wrapped(|ui| {
            let surface = self.example.as_ref().or(products.surface.as_ref()).cloned();
            let can = surface.is_some();
            let make = ui
                .add_enabled(can, Button::new(names::MAKE))
                .on_hover_text(
                    "Computes the present light off the surface, keeps it as a spectrum of your \
                     own and takes it as S3: something to check when there is no file at hand.",
                )
                .on_disabled_hover_text("Choose a surface first.");
            ui.label("of this light off");
            let says = match (&self.example, &surface) {
                (Some(entry), _) => entry.name().to_owned(),
                (None, Some(entry)) => format!("S2 ({})", entry.name()),
                (None, None) => "choose a surface".to_owned(),
            };
            let chosen = Picker {
                name: names::EXAMPLE,
                meaning: "The surface that the example's light really comes from.",
                says: &says,
                offers: picker::factors,
                width: 150.0 * context.theme.scale,
            }
            .show(ui, context.app);
            if chosen.is_some() {
                self.example = chosen;
            }
            let twice = &mut context.memory.products.check.twice;
            ui.checkbox(twice, names::TWICE).on_hover_text(
                "The light meets the surface twice, as in a corner: a single reflection should \
                 then not explain it.",
            );
            if make.clicked()
                && let Some(surface) = surface
            {
                context.commands.push(Command::Make {
                    recipe: example(context.app, &surface, *twice),
                    place: MadeFor::Outgoing,
                });
            }
        });
    }
}

/// Light, surface and outgoing spectrum.
fn choices(ui: &mut Ui, context: &mut PageContext<'_>) {
    let document = context.app.document();
    let products = &document.products;
    let width = 150.0 * context.theme.scale;
    ui.horizontal_wrapped(|ui| {
        ui.label("Is S3");
        let outgoing = Picker {
            name: names::OUTGOING,
            meaning: "The spectrum that may have come from the surface; files that you open as \
                      lights are in the list.",
            says: products
                .outgoing
                .as_ref()
                .map_or("choose a spectrum", |entry| entry.name()),
            offers: picker::lights,
            width,
        }
        .show(ui, context.app);
        if outgoing.is_some() {
            context.commands.push(Command::Products(Products {
                outgoing,
                ..products.clone()
            }));
        }
        ui.label("the light S1");
        ui.add(egui::Label::new(RichText::new(document.light.name()).strong()).truncate())
            .on_hover_text("The document's light: choose another in the library.");
        ui.label("off the surface S2");
        let surface = Picker {
            name: names::SURFACE,
            meaning: "The reflectance that may have turned the light into the spectrum.",
            says: products
                .surface
                .as_ref()
                .map_or("choose a surface", |entry| entry.name()),
            offers: picker::factors,
            width,
        }
        .show(ui, context.app);
        if surface.is_some() {
            context.commands.push(Command::Products(Products {
                surface,
                ..products.clone()
            }));
        }
        ui.label("?");
    });
}

/// What to do when something is missing.
fn explain(ui: &mut Ui, context: &PageContext<'_>) {
    let products = &context.app.document().products;
    ui.add_space(10.0);
    let mut say = |words: &str| {
        ui.add(egui::Label::new(words).wrap());
        ui.add_space(4.0);
    };
    if products.outgoing.is_none() {
        say(
            "There is no outgoing spectrum S3 yet. Open a file with the spectrum seen at a place \
             that another surface may light, and choose it in the first list above; or press \
             \"Make an example\".",
        );
    }
    if products.surface.is_none() {
        say("There is no surface S2 yet: choose one in the last list above.");
    }
    say(&format!(
        "The check is the paper's S3 = S1 S2: the light times the reflectance, both in the \
         model's numbers, against the spectrum found, up to a factor and behind a 10 nm blur. It \
         holds up to a residual of {} of the spectrum found.",
        short(SAME_RESIDUAL)
    ));
}

/// Both verdicts, with sign and words.
fn verdicts(ui: &mut Ui, context: &PageContext<'_>, sheet: &CheckSheet) {
    let [light, surface, outgoing] = &sheet.names;
    let verdict = sheet.verdict();
    let colour = match verdict {
        Sameness::Holds => ui.visuals().strong_text_color(),
        Sameness::DoesNotHold | Sameness::Unknown => context.theme.warning,
    };
    let sentence = match verdict {
        Sameness::Holds => format!("{outgoing} can be {light} off {surface}."),
        Sameness::DoesNotHold => format!("{outgoing} is not {light} off {surface}."),
        Sameness::Unknown if sheet.model.is_none() => {
            "One of the spectra is dark on this range.".to_owned()
        }
        Sameness::Unknown => format!(
            "The models are too short to tell: behind 10 nm they leave out {:.1} % of S1 and {:.1} \
             % of S3 themselves. More numbers may decide.",
            100.0 * sheet.left_out[0],
            100.0 * sheet.left_out[1]
        ),
    };
    Frame::new()
        .fill(ui.visuals().faint_bg_color)
        .stroke(ui.visuals().widgets.noninteractive.bg_stroke)
        .corner_radius(4)
        .inner_margin(Margin::symmetric(10, 8))
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            let words = format!("{} S3 = S1 S2 {}", verdict.sign(), verdict.words());
            ui.label(RichText::new(words).heading().color(colour));
            ui.label(sentence);
            ui.add_space(2.0);
            egui::Grid::new("verdicts")
                .spacing([16.0, 3.0])
                .show(ui, |ui| {
                    for (head, meaning) in [
                        ("", ""),
                        ("residual", RESIDUAL_MEANS),
                        ("factor", FACTOR_MEANS),
                        ("verdict", "Up to the threshold it holds; see below."),
                    ] {
                        let label = ui.label(RichText::new(head).small());
                        if !meaning.is_empty() {
                            label.on_hover_text(meaning);
                        }
                    }
                    ui.end_row();
                    let model = format!(
                        "in the model's {} and {}",
                        sheet.numbers[0],
                        numbers(sheet.numbers[1])
                    );
                    let rows = [
                        (model, &sheet.model, verdict),
                        (
                            "measured curves".to_owned(),
                            &sheet.measured,
                            sheet.measured_verdict(),
                        ),
                    ];
                    for (what, compared, verdict) in rows {
                        let found = compared.as_ref().map(|c| c.reflection);
                        ui.label(what);
                        ui.label(figure(found.map(|f| f.residual)));
                        ui.label(figure(found.map(|f| f.factor)));
                        ui.label(format!("{} {}", verdict.sign(), verdict.words()));
                        ui.end_row();
                    }
                });
            ui.weak(format!(
                "It holds up to a residual of {}, and does not hold beyond that plus what the models \
                 leave out themselves. In tests with shipped lights off shipped surfaces 95 of 100 \
                 right surfaces stayed below it, and 2 of 100 wrong ones.",
                short(SAME_RESIDUAL)
            ));
        });
}

const RESIDUAL_MEANS: &str = "Root mean square of what the best factor leaves, over that of the outgoing spectrum, both \
     behind a 10 nm blur; 0 is a perfect match.";
const FACTOR_MEANS: &str =
    "What light times surface is multiplied by to come closest: geometry, not colour.";

/// A figure with four digits; a dash for none.
fn figure(value: Option<f64>) -> String {
    match value {
        Some(value) if value.abs() >= 1e4 || (value != 0.0 && value.abs() < 1e-3) => short(value),
        Some(value) => format!("{value:.4}"),
        None => "–".to_owned(),
    }
}

fn draw(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    chart: &Option<Chart>,
    id: &'static str,
    size: Vec2,
) {
    if let Some(chart) = chart {
        let shown = ChartView::show(ui, chart, ("check", id), size, context.theme);
        context.wishes.extend(shown.wish);
    }
}

/// Which surface explains the spectrum best.
fn ranking(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &CheckSheet, height: f32) {
    let answer = context.studies.surfaces.ranking.answer();
    let ranked = answer.map(|(_, ranked)| ranked.clone());
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new("Which surface explains it best?").heading());
        let button = ui.small_button("Copy as CSV");
        named(&button, egui::Role::Button, names::COPY);
        if button.clicked()
            && let Some(ranked) = &ranked
        {
            ui.ctx().copy_text(ranking_csv(&sheet.names, ranked));
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("Among");
        let set = set_title(&context.app.document().patch_set);
        let all = format!("all {} shipped reflectances", shipped_reflectances());
        let everywhere = &mut context.memory.products.check.everywhere;
        let combo = ComboBox::from_id_salt("surfaces ranked")
            .selected_text(if *everywhere { &all } else { &set })
            .width(190.0 * context.theme.scale)
            .show_ui(ui, |ui| {
                ui.selectable_value(everywhere, false, &set);
                ui.selectable_value(everywhere, true, &all);
            });
        named(&combo.response, egui::Role::ComboBox, names::AMONG);
        combo
            .response
            .on_hover_text("Which surfaces are tried: the patch set, or everything shipped.");
        let job = &mut context.studies.surfaces.ranking;
        if job.stage() != Stage::Done {
            progress(ui, job, "The ranking");
        }
    });
    let Some(ranked) =
        ranked.filter(|_| context.studies.surfaces.ranking.stage() != Stage::Impossible)
    else {
        return;
    };
    let count = |verdict: Sameness| ranked.iter().filter(|r| r.verdict == verdict).count();
    let (holding, open) = (count(Sameness::Holds), count(Sameness::Unknown));
    ui.label(format!(
        "In the model's numbers {holding} of {} hold{}{}",
        ranked.len(),
        if open > 0 {
            format!(", of {open} it cannot be said")
        } else {
            String::new()
        },
        if 3 * holding > ranked.len() {
            ": this light tells surfaces badly apart."
        } else {
            "."
        }
    ));
    let width = ui.available_width();
    let row = ui.text_style_height(&TextStyle::Body) + 8.0;
    rank_head(ui, width);
    let chosen = context.app.document().products.surface.clone();
    let mut clicked = None;
    ScrollArea::vertical()
        .id_salt("ranking")
        .max_height(height.max(4.0 * row))
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let top = ui.cursor().top();
            let view = ui.clip_rect();
            let all = ranked.len();
            let line = |y: f32| ((y - top) / row).max(0.0);
            let from = (line(view.top()).floor() as usize).min(all);
            let to = (line(view.bottom()).ceil() as usize).min(all);
            ui.add_space(from as f32 * row);
            for (index, ranked) in ranked.iter().enumerate().take(to).skip(from) {
                let is_chosen = chosen.as_ref().is_some_and(|entry| entry.key == ranked.key);
                if rank_row(ui, vec2(width, row), ranked, index, is_chosen) {
                    clicked = Some(ranked.key.clone());
                }
            }
            ui.add_space((all - to) as f32 * row);
        });
    if let Some(surface) = clicked.and_then(|key| context.app.entry(&key)) {
        context.commands.push(Command::Products(Products {
            surface: Some(surface),
            ..context.app.document().products.clone()
        }));
    }
}

/// Where the columns of the ranking begin, shares of the width.
const COLUMNS: [f32; 5] = [0.0, 0.09, 0.52, 0.66, 0.81];

fn rank_head(ui: &mut Ui, width: f32) {
    let height = ui.text_style_height(&TextStyle::Small) + 3.0;
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let font = TextStyle::Small.resolve(ui.style());
    let colour = ui.visuals().weak_text_color();
    let heads = ["", "surface", "residual", "measured", "verdict"];
    for (at, words) in COLUMNS.into_iter().zip(heads) {
        let place = pos2(rect.left() + 4.0 + at * width, rect.top());
        ui.painter()
            .text(place, Align2::LEFT_TOP, words, font.clone(), colour);
    }
    response.on_hover_text(format!(
        "Colour of the surface under the light, residual in the model's numbers and of the \
         measured curves, and the model's verdict.\n{RESIDUAL_MEANS}"
    ));
}

fn rank_row(ui: &mut Ui, size: Vec2, ranked: &Ranked, index: usize, chosen: bool) -> bool {
    let verdict = ranked.verdict;
    let residual = figure(ranked.model.map(|m| m.residual));
    let measured = figure(ranked.measured.map(|m| m.residual));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let said = format!("{}: residual {residual}, {}", ranked.name, verdict.words());
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
    let colour = visuals.text_color();
    let font = TextStyle::Body.resolve(ui.style());
    let at = |share: f32| rect.left() + 4.0 + share * rect.width();
    let ends = [COLUMNS[2], COLUMNS[3], COLUMNS[4], 1.0];
    let words = [
        ranked.name.clone(),
        residual,
        measured,
        format!("{} {}", verdict.sign(), verdict.words()),
    ];
    for ((from, to), text) in COLUMNS[1..].iter().zip(ends).zip(words) {
        let mut job = egui::text::LayoutJob::simple_singleline(text, font.clone(), colour);
        job.wrap = egui::text::TextWrapping::truncate_at_width(at(to) - at(*from) - 6.0);
        let galley = ui.painter().layout_job(job);
        let top = rect.center().y - galley.size().y / 2.0;
        ui.painter().galley(pos2(at(*from), top), galley, colour);
    }
    let field = rect
        .shrink2(vec2(0.0, 2.0))
        .with_min_x(at(COLUMNS[0]))
        .with_max_x(at(COLUMNS[1]) - 8.0);
    let fill = swatch::colour(ranked.swatch.rgb8);
    ui.painter().rect_filled(field, 3.0, fill);
    let clicked = response.clicked();
    response.on_hover_text_at_pointer(format!(
        "{}\nFactor {} in the model's numbers, {} measured.\nClick to take it as the surface S2.",
        ranked.key,
        figure(ranked.model.map(|m| m.factor)),
        figure(ranked.measured.map(|m| m.factor)),
    ));
    clicked
}
