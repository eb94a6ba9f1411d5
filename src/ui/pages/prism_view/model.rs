//! The model's two knobs where its lines are seen: one moves the smooth part, the other what is a
//! line of its own.

use eframe::egui;
use egui::{Slider, SliderClamping, Ui};

use super::slider;
use crate::{
    app::{Command, Detector, answers::LINE_THRESHOLDS, ticks},
    ui::pages::PageContext,
};

/// What people and tests call them.
pub(crate) mod names {
    pub(crate) const ORDER: &str = "Smoothness N";
    pub(crate) const LINES: &str = "Lines above";
}

/// Orders that the slider reaches; more can be typed elsewhere.
const MOST: usize = 40;

/// Draws both and asks for what a hand changed.
pub(crate) fn knobs(ui: &mut Ui, context: &mut PageContext<'_>) {
    let before = context.app.document().settings;
    let mut settings = before;
    let of = Slider::new(&mut settings.order, 0..=MOST).clamping(SliderClamping::Never);
    let meaning = "Order of the model's smooth part: 2N + 1 numbers.";
    slider(ui, (names::ORDER, meaning), of);
    // Otherwise it decides nothing.
    if settings.spikes && settings.detector == Detector::Energy {
        let [least, most] = LINE_THRESHOLDS;
        let of = Slider::new(&mut settings.threshold_percent, least..=most)
            .logarithmic(true)
            .clamping(SliderClamping::Never)
            .custom_formatter(|v, _| ticks::short(v))
            .suffix(" %");
        let meaning = "Share of the power above which a peak is a line of its own, one exact ray; \
                       below it melts into the smooth part and is smeared.";
        slider(ui, (names::LINES, meaning), of);
    }
    if settings != before {
        context.commands.push(Command::Edit(settings));
    }
}
