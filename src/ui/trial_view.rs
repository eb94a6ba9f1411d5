//! "Try another lamp": a lesson's claims tried on any light of the library.

use std::sync::Arc;

use eframe::egui;
use egui::{Label, Ui};

use super::{
    kit::{Chooser, lights, warning},
    pages::progress,
    theme::{Theme, Wake},
};
use crate::app::{
    App, ByAddress, Entry,
    lessons::{Lesson, TrialAsk},
    studies::Studies,
};

/// The light that was chosen last.
#[derive(Default)]
pub(super) struct TrialView {
    chosen: Option<Arc<Entry>>,
    /// The lesson that it was chosen for.
    of: String,
}

impl TrialView {
    /// Draws the list of lights and what came of the trial.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        lesson: &Arc<Lesson>,
        (app, studies, wake): (&App, &mut Studies, &Wake),
        theme: Theme,
    ) {
        let chooser = Chooser {
            name: said!("Try another lamp"),
            meaning: said!(
                "Takes the lesson with another light in place of its own, out of sight, and says \
                 where its claim fails."
            ),
            says: said!("Try another lamp…"),
            offers: lights,
            width: ui.available_width().min(260.0 * theme.scale),
        };
        if self.of != lesson.name {
            (self.chosen, self.of) = (None, lesson.name.clone());
        }
        let chosen = chooser.show(ui, app);
        self.chosen = chosen.or_else(|| self.chosen.take());
        let Some(light) = &self.chosen else { return };
        let ask = TrialAsk {
            lesson: ByAddress(lesson.clone()),
            light: ByAddress(light.clone()),
        };
        let job = studies.job();
        job.put(&ask, wake);
        progress(ui, job, said!("The trial"));
        let Some(trial) = job.result_for(&ask) else {
            return;
        };
        ui.add(Label::new(&trial.headline).wrap());
        for fault in &trial.faults {
            warning(ui, theme, fault.as_str());
        }
    }
}
