//! Pictures that were dropped together, read with one instrument.

use eframe::egui::Ui;

use super::{PageContext, PhotographView, progress};
use crate::{
    app::Command,
    ui::kit::{self, pressed, pressed_small},
};

impl PhotographView {
    /// Which of them fit, with a button that takes their spectra, and why the others do not.
    pub(super) fn show_many(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let Some(ask) = self.many.clone() else { return };
        let job = context.put(&ask);
        progress(ui, job, said!("The pictures"));
        let Some(all) = job.result_for(&ask).cloned() else {
            return;
        };
        let fitting = all.iter().filter_map(|one| one.spectrum.as_ref().ok());
        let fitting: Vec<_> = fitting.cloned().collect();
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| {
            ui.strong(tr!(
                "{fitting} of {all} pictures fit the instrument.",
                fitting = fitting.len(),
                all = all.len()
            ));
            let meaning = said!("The spectra of the fitting ones join your own.");
            if !fitting.is_empty() && pressed(ui, said!("All to the library"), meaning) {
                context.commands.push(Command::Adopt(fitting.clone()));
            }
        });
        let mut opened = None;
        for one in all.iter() {
            ui.horizontal_wrapped(|ui| {
                if pressed_small(ui, &one.name, said!("Shows this picture.")) {
                    opened = Some(one.path.clone());
                }
                if let Err(why) = &one.spectrum {
                    kit::warning(ui, context.theme, why.clone());
                }
            });
        }
        if let Some(path) = opened {
            self.take(path);
        }
    }
}
