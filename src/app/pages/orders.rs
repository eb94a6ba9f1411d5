//! The page "Order by order": what every order of the series leaves out.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::{
    app::{
        App, Command,
        chart::{Chart, Ink, Series},
        document::Document,
        studies::Question,
    },
    study::{Measure, Progress},
};

pub(super) const ROW: Row = row(
    Page::Orders,
    Place::Numbers,
    ("Order by order", "orders"),
    "waves",
    "What every order leaves out of the spectrum.",
)
.under(Page::Coefficients);

/// How far the page looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct OrdersState {
    pub highest: usize,
}

impl Default for OrdersState {
    fn default() -> Self {
        Self { highest: 20 }
    }
}

impl OrdersState {
    pub const HIGHEST: Knob<Self> = knob!(highest: "Highest order", Reach::Within(1.0, 40.0), 0 "",
        "The last order that is tried.");
}

impl PageState for OrdersState {
    const KNOBS: &'static [Knob<Self>] = &[Self::HIGHEST];
}

/// The errors of all orders of a document's model.
#[derive(Clone, Debug, PartialEq)]
pub struct OrdersAsk {
    pub document: Document,
    pub highest: usize,
}

impl Question for OrdersAsk {
    /// An error for each order from 0.
    type Answer = Vec<f64>;

    fn answer(&self, progress: &Progress) -> Option<Vec<f64>> {
        progress.expect(self.highest + 1);
        let mut app = App::with_document(self.document.clone());
        let error = |order: usize| {
            let mut settings = app.document().settings;
            settings.order = order;
            app.apply(Command::Edit(settings));
            progress.step();
            let error = app.derived().figures[Measure::Rms];
            error.filter(|_| !progress.is_cancelled())
        };
        (0..=self.highest).map(error).collect()
    }
}

pub fn headline(errors: &[f64]) -> String {
    let last = errors.last().map_or(0.0, |error| 100.0 * error);
    format!("Order {} leaves out {last:.1} %.", errors.len().max(1) - 1)
}

pub fn chart(errors: &[f64]) -> Chart {
    let points = errors.iter().enumerate();
    let points = points.map(|(order, error)| [order as f64, 100.0 * error]);
    Chart {
        title: "What each order leaves out".to_owned(),
        x_label: "Order".to_owned(),
        y_label: "Relative RMS (%)".to_owned(),
        x_range: [0.0, errors.len() as f64],
        series: vec![Series::line("error", Ink::Model, points.collect())],
        ..Chart::default()
    }
}
