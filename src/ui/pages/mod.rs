//! The pages beside the spectrum: studies of the same document.

mod auction_view;
pub mod coefficients_view;
pub mod combine_view;
mod design_view;
pub mod gem_view;
mod glossary_view;
pub mod image_view;
mod known_lamps_view;
mod lesson_cards;
mod lessons_view;
pub mod live_view;
mod many_view;
pub mod photograph_view;
pub(super) mod presented;
mod prism_view;
pub mod products_view;
mod quality_view;
mod race_view;
pub mod relit_view;
pub mod same_surface;
mod tradeoff_view;
pub mod truth_view;

pub use lessons_view::{LessonFile, LessonsView};

use auction_view::AuctionView;
use coefficients_view::CoefficientsView;
use combine_view::CombineView;
use design_view::DesignView;
use gem_view::GemView;
use glossary_view::GlossaryView;
use image_view::ImageView;
use known_lamps_view::KnownLampsView;
use live_view::{LiveView, ToFollow};
use many_view::ManyView;
use photograph_view::PhotographView;
use prism_view::PrismView;
use products_view::{
    absorption::AbsorptionView, bounces::BouncesView, chain::ChainView, metamers::MetamersView,
    narrow::NarrowView, resampling::ResamplingView, two_lights::TwoLightsView,
};
use quality_view::QualityView;
use race_view::RaceView;
use relit_view::RelitView;
use same_surface::SameSurfaceView;
use tradeoff_view::TradeoffView;
use truth_view::TruthView;

use std::{
    any::{Any, TypeId},
    collections::HashMap,
    path::PathBuf,
    sync::Arc,
};

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
    following::{FollowAsked, Following},
    lessons::Lesson,
    pages::{Page, PageStates},
    photograph::{Instrument, Seen},
    relit::PictureWish,
    studies::{Job, Question, Stage, Studies},
};

/// What a page sees and may ask for.
pub struct PageContext<'a> {
    /// The program.
    pub app: &'a App,
    /// The long computations.
    pub studies: &'a mut Studies,
    /// The light that is followed.
    pub following: &'a mut Option<Following>,
    /// What the pages keep: a copy, which becomes the document's after the frame.
    pub pages: &'a mut PageStates,
    /// The page shown.
    pub page: &'a mut Page,
    /// Names of the lessons that were gone through.
    pub finished: &'a [String],
    /// The code of the language that lessons are shown in.
    pub language: &'a mut String,
    /// Photographs of spectra that are to be read, and files of instruments, once.
    pub photographs_asked: &'a mut Vec<PathBuf>,
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
    /// Saves the instrument of photographs of spectra.
    Instrument(Box<Instrument>),
    /// Follows a light.
    Follow(Box<FollowAsked>),
    /// Asks for a path that is to be followed.
    PickToFollow(ToFollow),
    /// Holds the light that is followed, or goes on.
    Hold,
    /// Keeps the spectrum that is shown of it.
    Capture,
    /// Follows it no longer.
    FollowNoMore,
    /// Saves it over time.
    Tracks { stem: String, csv: String },
    /// Opens a picture.
    OpenPicture,
    /// Takes note of a photograph of a spectrum that was read.
    Photograph(Seen),
    /// Takes a lesson's picture away from the place of the person's own.
    OwnPicture,
    /// Shows how the image of this key was read.
    Reading(String),
    /// Begins the lesson of this name.
    Begin(String),
}

impl PageContext<'_> {
    /// Goes to the page "From a colour" with a screen's colour.
    pub fn ask_about_colour(&mut self, rgb: [u8; 3]) {
        self.pages.from_colour = self.pages.from_colour.clone().about(rgb);
        *self.page = Page::FromColour;
    }

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

/// What the views of pages keep from frame to frame, each made when it is first asked for.
#[derive(Default)]
pub struct Pages(HashMap<TypeId, Box<dyn Any>>);

/// The drawing of a page.
type Draw = fn(&mut Pages, &mut Ui, &mut PageContext<'_>);

/// The drawing of every page but the spectrum, which the window draws itself.
const DRAWN: &[(Page, Draw)] = &[
    (Page::Lessons, |p, ui, c| p.of::<LessonsView>().list(ui, c)),
    (Page::Teachers, |p, ui, c| {
        p.of::<LessonsView>().teachers(ui, c)
    }),
    (Page::Glossary, |p, ui, c| {
        p.of::<GlossaryView>().show(ui, c.theme)
    }),
    (Page::Truth, |p, ui, c| p.of::<TruthView>().show(ui, c)),
    (Page::Absorption, |p, ui, c| {
        p.of::<AbsorptionView>().show(ui, c)
    }),
    (Page::Live, |p, ui, c| p.of::<LiveView>().show(ui, c)),
    (Page::Chain, |p, ui, c| p.of::<ChainView>().show(ui, c)),
    (Page::Narrow, |p, ui, c| p.of::<NarrowView>().show(ui, c)),
    (Page::TwoLights, |p, ui, c| {
        p.of::<TwoLightsView>().show(ui, c)
    }),
    (Page::Metamers, |p, ui, c| {
        p.of::<MetamersView>().show(ui, c)
    }),
    (Page::SameSurface, |p, ui, c| {
        p.of::<SameSurfaceView>().show(ui, c)
    }),
    (Page::Combine, |p, ui, c| p.of::<CombineView>().show(ui, c)),
    (Page::Quality, |p, ui, c| {
        p.of::<QualityView>().figures(ui, c)
    }),
    (Page::Chromaticity, |p, ui, c| {
        p.of::<QualityView>().diagram(ui, c)
    }),
    (Page::Rendition, |p, ui, c| {
        p.of::<QualityView>().rendition(ui, c)
    }),
    (Page::QualityOrder, |p, ui, c| {
        p.of::<QualityView>().order(ui, c)
    }),
    (Page::Mix, |p, ui, c| p.of::<DesignView>().mix(ui, c)),
    (Page::Solve, |p, ui, c| p.of::<DesignView>().solve(ui, c)),
    (Page::FromColour, |p, ui, c| {
        p.of::<DesignView>().spectra_of_colour(ui, c)
    }),
    (Page::Coefficients, |p, ui, c| {
        p.of::<CoefficientsView>().show(ui, c)
    }),
    (Page::Tradeoff, |p, ui, c| {
        p.of::<TradeoffView>().show(ui, c)
    }),
    (Page::Many, |p, ui, c| p.of::<ManyView>().show(ui, c)),
    (Page::Auction, |p, ui, c| p.of::<AuctionView>().show(ui, c)),
    (Page::Race, |p, ui, c| p.of::<RaceView>().show(ui, c)),
    (Page::KnownLamps, |p, ui, c| {
        p.of::<KnownLampsView>().show(ui, c)
    }),
    (Page::Resampling, |p, ui, c| {
        p.of::<ResamplingView>().show(ui, c)
    }),
    (Page::Bounces, |p, ui, c| p.of::<BouncesView>().show(ui, c)),
    (Page::Image, |p, ui, c| p.of::<ImageView>().show(ui, c)),
    (Page::Photograph, |p, ui, c| {
        p.of::<PhotographView>().show(ui, c)
    }),
    (Page::Prism, |p, ui, c| p.of::<PrismView>().prism(ui, c)),
    (Page::Rainbow, |p, ui, c| p.of::<PrismView>().rainbow(ui, c)),
    (Page::Gem, |p, ui, c| p.of::<GemView>().show(ui, c)),
    (Page::Relit, |p, ui, c| p.of::<RelitView>().show(ui, c)),
];

impl Pages {
    /// The one view of this kind.
    pub fn of<V: Default + Any>(&mut self) -> &mut V {
        let made = || -> Box<dyn Any> { Box::<V>::default() };
        let view = self.0.entry(TypeId::of::<V>()).or_insert_with(made);
        view.downcast_mut().expect("kept under its own kind")
    }

    /// The picture of colours whose pixels are to be taken.
    pub fn take_photo(&mut self, path: PathBuf) {
        self.of::<DesignView>().photo = Some(path);
    }

    /// The instrument that lights are followed through from now on.
    pub fn take_instrument(&mut self, path: &std::path::Path) {
        self.of::<LiveView>().take_instrument(path);
    }

    /// Draws the page in force.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let drawn = DRAWN.iter().find(|(page, _)| page == context.page);
        if let Some((_, draw)) = drawn {
            draw(self, ui, context);
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
    // In a sentence, one thing or several.
    let name = what.replacen("The ", "the ", 1);
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
                let meaning = said!("Stops it; the last result stays.");
                if pressed_small(ui, said!("Cancel"), meaning) {
                    job.cancel();
                }
                ui.weak(if job.result().is_some() {
                    tr!("Computing: {name}. The last result stays until then.", name)
                } else {
                    tr!("Computing: {name}.", name)
                });
            });
        }
        Stage::Cancelled => {
            ui.horizontal(|ui| {
                ui.weak(tr!("Cancelled: {name}.", name));
                if ui.small_button(said!("Compute")).clicked() {
                    job.retry();
                }
            });
        }
        Stage::Broken => {
            ui.weak(tr!(
                "{what} broke down: a fault of this program, told on its standard error.",
                what
            ));
        }
        Stage::Impossible => {
            ui.weak(tr!(
                "{what}: there is nothing to measure on this spectrum and range.",
                what
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_but_the_spectrum_is_drawn_by_one_view() {
        for page in Page::all().filter(|page| *page != Page::Spectrum) {
            let views = DRAWN.iter().filter(|(drawn, _)| *drawn == page);
            assert_eq!(views.count(), 1, "{}", page.title());
        }
    }
}
