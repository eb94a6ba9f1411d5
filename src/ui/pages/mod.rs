//! The pages beside the spectrum: studies of the same document.

mod auction_view;
pub mod coefficients_view;
mod design_view;
pub mod gem_view;
mod glossary_view;
pub mod image_view;
mod known_lamps_view;
mod lesson_cards;
mod lessons_view;
mod many_view;
pub mod photograph_view;
pub(super) mod presented;
mod prism_view;
pub mod products_view;
mod quality_view;
mod race_view;
pub mod relit_view;
mod tradeoff_view;
pub mod truth_view;

pub use lessons_view::LessonFile;
pub(super) use lessons_view::begin;

use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::Ui;

use super::{
    chart_view::{ChartResponse, ChartView, ChartWish},
    kit::{named, pressed_small, segments},
    theme::{Theme, Wake},
};
use crate::app::{
    App, Command,
    chart::Chart,
    dispersion::GemFile,
    lessons::Lesson,
    pages::{Page, PageMemory},
    relit::PictureWish,
    studies::{Job, Question, Stage, Studies},
};

/// What a page sees and may ask for.
pub struct PageContext<'a> {
    /// The program.
    pub app: &'a App,
    /// The long computations.
    pub studies: &'a mut Studies,
    /// What the pages remember.
    pub memory: &'a mut PageMemory,
    /// The looks.
    pub theme: Theme,
    /// Wakes the window when a computation is done.
    pub wake: &'a Wake,
    /// Changes of the document that the page asks for.
    pub commands: &'a mut Vec<Command>,
    /// What the page asks of the window.
    pub wishes: &'a mut Vec<PageWish>,
    /// Whether what changes from run to run (times) is left out, for pictures.
    pub quiet: bool,
    /// While a page is drawn unseen, to be presented: its largest chart so far, with its area.
    pub taken: Option<Option<(f32, Box<Chart>)>>,
}

/// What a page asks of the window.
pub enum PageWish {
    /// Copies or saves a chart.
    Chart(ChartWish),
    /// Saves a picture of a gem.
    Gem(GemFile),
    /// Saves a picture in few numbers.
    FewNumbers(PictureWish),
    /// Saves a lesson's sheet or file.
    Lesson(Arc<Lesson>, LessonFile),
    /// Opens a picture.
    OpenPicture,
    /// Shows how the image of this key was read.
    Reading(String),
}

impl PageContext<'_> {
    /// Draws a chart with its menu; what the menu was asked for is passed on.
    pub fn chart(
        &mut self,
        ui: &mut Ui,
        chart: &Chart,
        id: impl std::hash::Hash + std::fmt::Debug,
        size: egui::Vec2,
    ) -> ChartResponse {
        if let Some(taken) = &mut self.taken
            && taken
                .as_ref()
                .is_none_or(|(area, _)| *area < size.x * size.y)
        {
            *taken = Some((size.x * size.y, Box::new(chart.clone())));
        }
        let mut shown = ChartView::show(ui, chart, id, size, self.theme);
        self.ask_for_chart(shown.wish.take());
        shown
    }

    /// Passes on what a chart's menu was asked for.
    pub fn ask_for_chart(&mut self, wish: Option<ChartWish>) {
        self.wishes.extend(wish.map(PageWish::Chart));
    }

    /// Puts a question that holds all that its answer depends on; its job.
    pub fn put<Q>(&mut self, question: &Q) -> &mut Job<Q, Q::Answer>
    where
        Q: Question<Answer: Send> + Clone + PartialEq + Send + 'static,
    {
        let job = self.studies.of::<Q>();
        job.put(question, self.wake);
        job
    }
}

/// All pages with what they keep from frame to frame.
#[derive(Default)]
pub struct Pages {
    coefficients: coefficients_view::CoefficientsView,
    tradeoff: tradeoff_view::TradeoffView,
    many: many_view::ManyView,
    auction: auction_view::AuctionView,
    race: race_view::RaceView,
    known_lamps: known_lamps_view::KnownLampsView,
    products: products_view::ProductsView,
    quality: quality_view::QualityView,
    design: design_view::DesignView,
    image: image_view::ImageView,
    photograph: photograph_view::PhotographView,
    prism: prism_view::PrismView,
    gem: gem_view::GemView,
    relit: relit_view::RelitView,
    /// The lessons, also those of a person's own files.
    pub lessons: lessons_view::LessonsView,
    glossary: glossary_view::GlossaryView,
    truth: truth_view::TruthView,
}

impl Pages {
    /// The picture of colours whose pixels are to be taken.
    pub fn take_photo(&mut self, path: PathBuf) {
        self.design.photo = Some(path);
    }

    /// Draws the page in force; nothing for the spectrum, which the window draws itself.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let products = &mut self.products;
        match context.memory.page {
            Page::Spectrum => {}
            Page::Absorption => products.absorption.show(ui, context),
            Page::Chain => products.chain.show(ui, context),
            Page::Narrow => products.narrow.show(ui, context),
            Page::TwoLights => products.two_lights.show(ui, context),
            Page::Metamers => products.metamers.show(ui, context),
            Page::SameSurface => products.same_surface.show(ui, context),
            Page::Quality => self.quality.figures(ui, context),
            Page::Chromaticity => self.quality.diagram(ui, context),
            Page::Rendition => self.quality.rendition(ui, context),
            Page::QualityOrder => self.quality.order(ui, context),
            Page::Mix => self.design.mix(ui, context),
            Page::Solve => self.design.solve(ui, context),
            Page::FromColour => self.design.spectra_of_colour(ui, context),
            Page::Coefficients => self.coefficients.show(ui, context),
            Page::Tradeoff => self.tradeoff.show(ui, context),
            Page::Many => self.many.show(ui, context),
            Page::Auction => self.auction.show(ui, context),
            Page::Race => self.race.show(ui, context),
            Page::KnownLamps => self.known_lamps.show(ui, context),
            Page::Resampling => products.resampling.show(ui, context),
            Page::Bounces => products.bounces.show(ui, context),
            Page::Image => self.image.show(ui, context),
            Page::Photograph => self.photograph.show(ui, context),
            Page::Prism => self.prism.prism(ui, context),
            Page::Rainbow => self.prism.rainbow(ui, context),
            Page::Gem => self.gem.show(ui, context),
            Page::Relit => self.relit.show(ui, context),
            Page::Lessons => self.lessons.list(ui, context),
            Page::Teachers => self.lessons.teachers(ui, context),
            Page::Glossary => self.glossary.show(ui, context.theme),
            Page::Truth => self.truth.show(ui, context),
        }
    }
}

/// The tabs of the place, at the right end what `at_end` draws; below them the modes of a tab that
/// has several.
pub fn tabs(ui: &mut Ui, page: &mut Page, at_end: impl FnOnce(&mut Ui)) {
    let wide = ui.available_width() >= 560.0;
    let row = |ui: &mut Ui, add: &mut dyn FnMut(&mut Ui)| match wide {
        true => ui.horizontal(add).response,
        false => ui.horizontal_wrapped(add).response,
    };
    let mut at_end = Some(at_end);
    row(ui, &mut |ui| {
        for tab in page.place().tabs() {
            let is_here = page.tab() == tab;
            let response = ui.selectable_label(is_here, tab.tab_title());
            if response.on_hover_text(tab.meaning()).clicked() && !is_here {
                *page = tab;
            }
        }
        if let Some(at_end) = at_end.take().filter(|_| wide) {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), at_end);
        }
    });
    let modes: Vec<Page> = page.modes().collect();
    if modes.len() > 1 {
        ui.add_space(4.0);
        segments(ui, page, modes, |mode| (mode.mode(), mode.meaning()));
    }
}

/// How a computation stands, in a line with a bar and a button to stop it.
pub fn progress<K: Clone + PartialEq + 'static, T: Send + 'static>(
    ui: &mut Ui,
    job: &mut Job<K, T>,
    what: &str,
) {
    match job.stage() {
        Stage::Idle | Stage::Done => {}
        Stage::Running(share) => {
            ui.horizontal_wrapped(|ui| {
                let bar = ui.add(
                    egui::ProgressBar::new(share)
                        .desired_width(120.0)
                        .show_percentage(),
                );
                named(&bar, egui::Role::ProgressIndicator, what);
                let meaning = "Stops it; the last result stays.";
                if pressed_small(ui, "Cancel", meaning) {
                    job.cancel();
                }
                ui.weak(if job.result().is_some() {
                    format!("{what} is being computed; the last result stays until then.")
                } else {
                    format!("{what} is being computed.")
                });
            });
        }
        Stage::Cancelled => {
            ui.horizontal(|ui| {
                ui.weak(format!("{what} was cancelled."));
                if ui.small_button("Compute").clicked() {
                    job.retry();
                }
            });
        }
        Stage::Broken => {
            ui.weak(format!(
                "{what} broke down: a fault of this program, told on its standard error."
            ));
        }
        Stage::Impossible => {
            ui.weak(format!(
                "{what}: there is nothing to measure on this spectrum and range."
            ));
        }
    }
}
