//! The pages beside the spectrum: studies of the same document.

pub mod auction_view;
pub mod coefficients_view;
pub mod image_view;
pub mod products_view;
pub mod race_view;
pub mod tradeoff_view;
pub mod truth_view;

use eframe::egui;
use egui::Ui;

use super::{
    chart_view::{ChartResponse, ChartView, ChartWish},
    kit::named,
    theme::{Theme, Wake},
};
use crate::app::{
    App, Command,
    chart::{self, Chart},
    pages::{Page, PageMemory},
    studies::{Job, Stage, Studies},
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
    /// Charts to copy or save.
    pub wishes: &'a mut Vec<ChartWish>,
    /// Whether what changes from run to run (times) is left out, for pictures.
    pub quiet: bool,
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
        let mut shown = ChartView::show(ui, chart, id, size, self.theme);
        self.wishes.extend(shown.wish.take());
        shown
    }

    /// The theme of charts.
    pub fn chart_theme(&self) -> chart::Theme {
        self.theme.of_charts()
    }
}

/// All pages with what they keep from frame to frame.
#[derive(Default)]
pub struct Pages {
    coefficients: coefficients_view::CoefficientsView,
    tradeoff: tradeoff_view::TradeoffView,
    auction: auction_view::AuctionView,
    race: race_view::RaceView,
    products: products_view::ProductsView,
    image: image_view::ImageView,
    truth: truth_view::TruthView,
}

impl Pages {
    /// The key of an image whose reading is to be looked at, once.
    pub fn wants_reading(&mut self) -> Option<String> {
        self.image.wants_reading.take()
    }

    /// Draws the page in force; nothing for the spectrum, which the window draws itself.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        match context.memory.page {
            Page::Spectrum => {}
            Page::Coefficients => self.coefficients.show(ui, context),
            Page::Tradeoff => self.tradeoff.show(ui, context),
            Page::Auction => self.auction.show(ui, context),
            Page::Race => self.race.show(ui, context),
            Page::Products => self.products.show(ui, context),
            Page::Image => self.image.show(ui, context),
            Page::Truth => self.truth.show(ui, context),
        }
    }
}

/// The row of tabs.
pub fn tabs(ui: &mut Ui, page: &mut Page) {
    ui.horizontal_wrapped(|ui| {
        for tab in Page::ALL {
            ui.selectable_value(page, tab, tab.title())
                .on_hover_text(tab.meaning());
        }
    });
}

/// How a computation stands, in a line with a bar and a button to stop it.
pub fn progress<K: Clone + PartialEq, T: Send + 'static>(
    ui: &mut Ui,
    job: &mut Job<K, T>,
    what: &str,
) {
    match job.stage() {
        Stage::Idle | Stage::Done => {}
        Stage::Running(share) => {
            ui.horizontal(|ui| {
                let bar = ui.add(
                    egui::ProgressBar::new(share)
                        .desired_width(120.0)
                        .show_percentage(),
                );
                named(&bar, egui::Role::ProgressIndicator, what);
                if ui
                    .small_button("Cancel")
                    .on_hover_text("Stops it; the last result stays.")
                    .clicked()
                {
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
