//! The page "Colours under it": a large chart of what the light does to colours beside a board of
//! surfaces, and the other charts in small.

use eframe::egui;
use egui::{Label, RichText, Sense, Stroke, StrokeKind, TextStyle, Ui, Vec2, vec2};

use crate::{
    app::{
        Memo, QualityShown,
        chart::{Chart, Drawing, Looks, Marks},
        charts::quality::{
            OfBins, OfColours, bin_bars, fidelity_bars, hue_at, sample_bars, vector_graphic,
        },
        verdicts,
    },
    color::quality::HUE_NAMES,
    languages::{fixed, said},
    ui::{
        chart_view::paint,
        kit::{Choice, adapt_box, bounded, down, headline, line, named_choice, rolled},
        lit_field::{self, Field, from_references},
        pages::PageContext,
        patches_view::set_choice,
    },
};

/// From this width on chart and board stand side by side, points.
const BESIDE: f32 = 620.0;
/// Height of a small chart, points.
const SMALL: f32 = 72.0;
/// Surfaces in a row of the board.
const IN_ROW: usize = 4;
/// Height of a surface's colours: least and largest, points.
const COLOURS: [f32; 2] = [26.0, 90.0];

/// What the page keeps from frame to frame.
#[derive(Default)]
pub(super) struct RenditionView {
    /// The large chart.
    chart: Memo<(u64, OfColours, Option<usize>), Chart>,
    /// All of them in small.
    small: Memo<u64, Vec<Chart>>,
    /// The hue that the pointer was over in the last frame.
    pointed: Option<usize>,
}

impl RenditionView {
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        shown: &QualityShown,
    ) {
        headline(ui, context.theme, &shown.rendition);
        if shown.fidelities().is_empty() {
            return;
        }
        let scale = context.theme.scale;
        let room = ui.available_size();
        let small = (SMALL + 24.0) * scale;
        let high = (room.y - small - 8.0).max(240.0);
        let before = self.pointed.take();
        if room.x >= BESIDE * scale {
            let left = (0.52 * room.x).min(1.17 * high).floor();
            ui.horizontal_top(|ui| {
                down(ui, vec2(left, high), |ui| {
                    ui.set_min_size(vec2(left, high));
                    self.large(ui, context, shown, before);
                });
                let rest = vec2(ui.available_width(), high);
                down(ui, rest, |ui| {
                    ui.set_min_size(rest);
                    self.board(ui, context, shown, before);
                });
            });
            self.thumbnails(ui, context, shown);
        } else {
            rolled(ui, |ui| {
                let side = room.x.min(high);
                down(ui, vec2(room.x, side), |ui| {
                    self.large(ui, context, shown, before)
                });
                self.thumbnails(ui, context, shown);
                self.board(ui, context, shown, before);
            });
        }
        if self.pointed != before {
            ui.ctx().request_repaint();
        }
    }

    /// The chart that was chosen, and what the hue that is pointed at does.
    fn large(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        shown: &QualityShown,
        pointed: Option<usize>,
    ) {
        let chosen = context.pages.rendition.large;
        let key = (context.app.revision(), chosen, pointed);
        let chart = &*self.chart.get(key, |_| chart_of(chosen, shown, pointed));
        let words = ui.spacing().interact_size.y + 4.0;
        let size = vec2(ui.available_width(), ui.available_height() - words);
        let drawn = context.chart(ui, chart, ("of colours", chosen), size);
        let at = drawn.response.hover_pos().map(|at| drawn.main.values(at));
        self.pointed = match chosen {
            OfColours::Vectors => at.and_then(hue_at),
            OfColours::Fidelity | OfColours::Chroma | OfColours::Hue => at.and_then(|[x, _]| {
                let bin = x.round() - 1.0;
                (0.0..HUE_NAMES.len() as f64)
                    .contains(&bin)
                    .then_some(bin as usize)
            }),
            OfColours::Samples | OfColours::Surfaces => None,
        };
        line(ui, |ui| {
            let words = match pointed {
                Some(hue) => of_hue(shown, hue),
                None => said!("Point at a hue: its surfaces light up.").to_owned(),
            };
            ui.add(Label::new(RichText::new(words).color(context.theme.faint)).truncate());
        });
    }

    /// The surfaces of the set, hue by hue.
    fn board(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        shown: &QualityShown,
        pointed: Option<usize>,
    ) {
        let (board, theme) = (&shown.board, context.theme);
        ui.horizontal_wrapped(|ui| {
            let choice = Choice {
                name: said!("Surface set"),
                meaning: said!("The surfaces that the light falls on."),
                width: 128.0 * theme.scale,
            };
            set_choice(ui, choice, context.app, context.commands);
            let meaning = said!(
                "Shows each half as an eye used to its light sees it (Bradford). It changes the \
                 colours on screen, not the figures."
            );
            adapt_box(ui, context.app, (said!("Adapt"), meaning), context.commands);
        });
        let names = shown.sides.iter().map(|side| side.name.as_str());
        let lights = lit_field::referenced(board, names);
        let caption = RichText::new(lit_field::caption(&lights))
            .small()
            .color(theme.faint);
        ui.add(Label::new(caption).truncate())
            .on_hover_text(lit_field::caption(&lights));
        let width = lit_field::width(ui.available_width() - 10.0, IN_ROW);
        let rows = board.len().div_ceil(IN_ROW).clamp(1, 6) as f32;
        let words = lit_field::size(ui, width, 0.0).y;
        let each = (ui.available_height() - 4.0) / rows - words - lit_field::GAP;
        let colours = bounded(each, COLOURS[0], COLOURS[1] * theme.scale);
        let size = lit_field::size(ui, width, colours);
        let mut over = None;
        rolled(ui, |ui| {
            ui.spacing_mut().item_spacing = Vec2::splat(lit_field::GAP);
            for first in (0..board.len()).step_by(IN_ROW) {
                ui.horizontal(|ui| {
                    for i in first..board.len().min(first + IN_ROW) {
                        let lit: Vec<_> = board.surface(i).collect();
                        let hue = lit.first().and_then(|lit| lit.hue);
                        let field = Field {
                            said: from_references(&lit, &lights),
                            lit,
                            lights_up: pointed.is_some() && hue == pointed,
                            source: "",
                        };
                        if field.show(ui, size, theme).hovered() {
                            over = hue;
                        }
                    }
                });
            }
        });
        self.pointed = self.pointed.or(over);
    }

    /// All charts in small: a click makes one the large one.
    fn thumbnails(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, shown: &QualityShown) {
        let small = &*self.small.get(context.app.revision(), |_| {
            OfColours::ALL
                .map(|of| in_small(chart_of(of, shown, None)))
                .to_vec()
        });
        let theme = context.theme;
        let width = lit_field::width(ui.available_width(), OfColours::ALL.len());
        let looks = Looks {
            scale: f64::from(theme.scale),
            line: 0.6,
            whole: false,
            legend: false,
            theme: theme.of_charts(),
        };
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = lit_field::GAP;
            for (of, chart) in OfColours::ALL.into_iter().zip(small) {
                let text = ui.text_style_height(&TextStyle::Small);
                let size = vec2(width, SMALL * theme.scale + text + 6.0);
                let (rect, response) = ui.allocate_exact_size(size, Sense::click());
                let field = rect.with_max_y(rect.bottom() - text - 6.0);
                let sides = [field.width(), field.height()].map(f64::from);
                let drawing = Drawing::new(chart, sides, looks);
                let marks = drawing.primitives(chart.whole_view());
                let marks = paint::shapes(ui.painter(), field.min.to_vec2(), &marks);
                ui.painter().with_clip_rect(field).extend(marks);
                let is_large = context.pages.rendition.large == of;
                named_choice(&response, egui::Role::Button, is_large, of.word());
                let visuals = ui.visuals();
                let (stroke, ink) = match (is_large, response.hovered() || response.has_focus()) {
                    (true, _) => (Stroke::new(2.0, theme.accent), visuals.strong_text_color()),
                    (false, true) => (visuals.widgets.active.bg_stroke, visuals.text_color()),
                    (false, false) => (Stroke::NONE, visuals.text_color()),
                };
                ui.painter()
                    .rect_stroke(field, 2.0, stroke, StrokeKind::Outside);
                let font = TextStyle::Small.resolve(ui.style());
                let at = egui::pos2(rect.center().x, rect.bottom() - text);
                let middle = egui::Align2::CENTER_TOP;
                ui.painter().text(at, middle, of.word(), font, ink);
                if response.clicked() {
                    context.pages.rendition.large = of;
                }
            }
        });
    }
}

/// A chart of one light or two; `pointed` is the hue that is pointed at.
fn chart_of(of: OfColours, shown: &QualityShown, pointed: Option<usize>) -> Chart {
    let lights = &shown.fidelities()[..];
    match of {
        OfColours::Vectors => vector_graphic(lights, pointed),
        OfColours::Fidelity => bin_bars(lights, OfBins::Fidelity),
        OfColours::Chroma => bin_bars(lights, OfBins::Chroma),
        OfColours::Hue => bin_bars(lights, OfBins::Hue),
        OfColours::Samples => sample_bars(&shown.renderings()),
        OfColours::Surfaces => fidelity_bars(lights),
    }
}

/// A chart as a small picture of itself, without a word.
fn in_small(chart: Chart) -> Chart {
    let is_drawn = |marks: &Marks| !matches!(marks, Marks::Words { .. });
    Chart {
        is_bare: true,
        x_label: String::new(),
        y_label: String::new(),
        series: chart
            .series
            .into_iter()
            .filter(|series| is_drawn(&series.marks))
            .collect(),
        ..chart
    }
}

/// What each light does to a hue.
fn of_hue(shown: &QualityShown, hue: usize) -> String {
    let name = said(HUE_NAMES[hue]);
    let each = shown.fidelities().into_iter().map(|(light, fidelity)| {
        fidelity.bins[hue].as_ref().map_or_else(
            || tr!("no sample under {light}", light),
            |bin| {
                let how = verdicts::of_shift(bin.rcs, bin.rhs);
                tr!(
                    "{change} under {light} (Rf {figure})",
                    change = how,
                    light,
                    figure = fixed(bin.rf, 0)
                )
            },
        )
    });
    let each: Vec<String> = each.collect();
    format!("{name}: {}", each.join("; "))
}
