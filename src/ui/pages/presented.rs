//! A page before a class: its main picture with its two or three main controls, large, and nothing
//! else of the window.

use eframe::egui;
use egui::{Align, Button, Label, Layout, Rect, RichText, Ui, UiBuilder, pos2, vec2};

use super::{GemView, PageContext, Pages, PrismView};
use crate::{
    app::{chart::Chart, pages::Page},
    ui::{
        chart_view::ChartView,
        kit::{column, hidden_headline, named, rolled},
        theme::Theme,
    },
};

/// The knobs of the model: their height in a width, and how they are drawn.
pub(in crate::ui) struct Knobs<'a> {
    /// Their height in points, in a width at a scale.
    pub height: f32,
    pub show: &'a mut dyn FnMut(&mut Ui, &mut PageContext<'_>),
}

/// Between what stands over each other, points.
const GAP: f32 = 8.0;

/// Size that a page has while its chart is taken out of it, points; it lies far off the window.
const HIDDEN: egui::Vec2 = vec2(1280.0, 900.0);
const FAR: f32 = 1e5;

/// Draws the page in force; whether a hand wants the whole window back. `in_lesson`: a lesson's step
/// is shown, and whether its controls are used: then the whole page is shown, large.
pub(in crate::ui) fn show(
    pages: &mut Pages,
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    in_lesson: Option<bool>,
    knobs: Knobs<'_>,
) -> bool {
    let page = *context.page;
    match (page, in_lesson) {
        (Page::Prism, _) => {
            let view = pages.of::<PrismView>();
            view.present_prism(ui, context, in_lesson.is_some())
        }
        (Page::Rainbow, _) => pages.of::<PrismView>().present_rainbow(ui, context),
        (Page::Gem, _) => pages.of::<GemView>().present(ui, context),
        (_, Some(true)) => in_lessons(pages, ui, context),
        (_, Some(false)) if !is_one_chart(page) => in_lessons(pages, ui, context),
        (_, None) if is_whole(page) => {
            let leaves = head(ui, page.title());
            rolled(ui, |ui| pages.show(ui, context));
            leaves
        }
        (_, Some(false)) => chart(pages, ui, context, None),
        (_, None) => chart(pages, ui, context, Some(knobs)),
    }
}

/// Type of a whole page beside a lesson, of that of a chart alone: more of it must be seen at once.
const BESIDE_LESSON: f32 = 0.66;

/// A whole page beside a lesson's column.
fn in_lessons(pages: &mut Pages, ui: &mut Ui, context: &mut PageContext<'_>) -> bool {
    let leaves = head(ui, "");
    ui.add_space(-2.0 * GAP - ui.text_style_height(&egui::TextStyle::Body));
    let whole = context.theme;
    context.theme.scale = (BESIDE_LESSON * whole.scale).max(1.0);
    // A step may point at any control.
    context.theme.presents = false;
    let share = context.theme.scale / whole.scale;
    ui.scope(|ui| {
        for font in ui.style_mut().text_styles.values_mut() {
            font.size *= share;
        }
        let spacing = ui.spacing_mut();
        spacing.interact_size *= share;
        spacing.button_padding *= share;
        spacing.item_spacing *= share;
        spacing.slider_width *= share;
        rolled(ui, |ui| {
            ui.set_max_width(ui.available_width() - 24.0 * whole.scale);
            pages.show(ui, context);
        });
    });
    context.theme = whole;
    leaves
}

/// Whether the page says what it has to say with one chart.
fn is_one_chart(page: Page) -> bool {
    matches!(page, Page::Absorption | Page::Rendition | Page::Auction)
}

/// Whether the page's main picture is no chart, or more than one: it is shown as it is, large.
fn is_whole(page: Page) -> bool {
    matches!(
        page,
        Page::Lessons
            | Page::Teachers
            | Page::Glossary
            | Page::Live
            | Page::Chain
            | Page::Narrow
            | Page::TwoLights
            | Page::Metamers
            | Page::SameSurface
            | Page::Quality
            | Page::Mix
            | Page::Solve
            | Page::Image
            | Page::Relit
    )
}

/// Whether the model's knobs move what the page's chart shows.
fn follows_knobs(page: Page) -> bool {
    matches!(
        page,
        Page::Tradeoff | Page::Auction | Page::Resampling | Page::Bounces
    )
}

/// A sentence at the size of titles, and at its right what leads back to the whole window.
pub(super) fn head(ui: &mut Ui, words: &str) -> bool {
    let mut leaves = false;
    ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
        let back = ui.add(Button::new("✕").frame(false));
        named(&back, egui::Role::Button, said!("Whole window"));
        leaves = back
            .on_hover_text(said!("Back to the whole window (Esc)."))
            .clicked();
        let size = vec2(ui.available_width(), 0.0);
        ui.allocate_ui_with_layout(size, Layout::top_down(Align::Min), |ui| {
            let ink = ui.visuals().strong_text_color();
            ui.add(Label::new(RichText::new(words).color(ink)).wrap());
        });
    });
    ui.add_space(GAP);
    leaves
}

/// The largest chart of the page, its sentence above, the model's knobs below.
fn chart(
    pages: &mut Pages,
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    knobs: Option<Knobs<'_>>,
) -> bool {
    let page = *context.page;
    let (words, found) = taken_out(pages, ui, context);
    let Some(found) = found else {
        // It is not computed yet, or there is nothing to draw: the page says which.
        let leaves = head(ui, page.title());
        rolled(ui, |ui| pages.show(ui, context));
        return leaves;
    };
    let leaves = head(ui, &words);
    let knobs = knobs.filter(|_| follows_knobs(page));
    let below = knobs.as_ref().map_or(0.0, |knobs| knobs.height + GAP);
    let room = ui.available_size();
    let size = vec2(room.x, (room.y - below).max(1.0));
    column(ui, size, |ui| {
        let id = ("presented", page);
        let size = ui.available_size();
        let mut shown = ChartView::show(ui, &found, id, size, context.theme);
        context.ask_for_chart(shown.wish.take());
    });
    if let Some(knobs) = knobs {
        ui.add_space(GAP);
        (knobs.show)(ui, context);
    }
    leaves
}

/// The page drawn where nobody sees it: its sentence and its largest chart.
fn taken_out(
    pages: &mut Pages,
    ui: &mut Ui,
    context: &mut PageContext<'_>,
) -> (String, Option<Box<Chart>>) {
    let far = Rect::from_min_size(pos2(0.0, FAR), HIDDEN);
    let mut hidden = ui.new_child(
        UiBuilder::new()
            .id_salt(("hidden", *context.page))
            .max_rect(far)
            .invisible(),
    );
    let theme = Theme {
        scale: 1.0,
        presents: false,
        ..context.theme
    };
    let large = std::mem::replace(&mut context.theme, theme);
    context.taken = Some(None);
    pages.show(&mut hidden, context);
    context.theme = large;
    let taken = context.taken.take().flatten();
    (hidden_headline(&hidden), taken.map(|(_, chart)| chart))
}
