//! The page "Order by order".

use eframe::egui::Ui;

use super::{PageContext, progress};
use crate::{
    app::pages::orders::{OrdersAsk, OrdersState, chart, headline},
    ui::kit::{self, knob},
};

#[derive(Default)]
pub(super) struct OrdersView;

impl OrdersView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let ask = OrdersAsk {
            document: context.app.document().clone(),
            highest: context.pages.orders.highest,
        };
        let job = context.put(&ask);
        progress(ui, job, "Order by order");
        let errors = job.result().cloned();
        let slider = knob::slider(&OrdersState::HIGHEST, &mut context.pages.orders);
        ui.add(slider.text(OrdersState::HIGHEST.title));
        if let Some(errors) = errors {
            kit::headline(ui, context.theme, headline(&errors));
            context.chart(ui, &chart(&errors), "orders", ui.available_size());
        }
    }
}
