//! What of a light is sent through: as it was measured, or as the model has it; and the model's two
//! knobs, of which one moves its smooth part, the other what is a line of its own.

use crate::ui::kit::slide;
use eframe::egui;
use egui::SliderClamping;

use crate::{
    app::{Command, Detector, answers::LINE_THRESHOLDS, dispersion::Sent, ticks},
    languages::said,
    ui::{kit::Form, pages::PageContext},
};

/// What people and tests call them.
pub(crate) mod names {
    pub(crate) const MODEL: &str = later!("as the model has it");
    pub(crate) const ORDER: &str = later!("Waves");
    pub(crate) const LINES: &str = later!("Lines above");
}

/// Orders that the slider reaches; more can be typed elsewhere.
const MOST: usize = 40;

/// The switch between what was measured and the model.
pub(crate) fn sent(form: &mut Form<'_>, sent: &mut Sent) {
    let mut of_model = *sent == Sent::Model;
    let meaning = said!(
        "Each line is one wavelength either way. The rest goes through as it was measured, or as \
         the model's waves draw it: what the model loses is seen."
    );
    let switch = form.rest(|ui| ui.checkbox(&mut of_model, said(names::MODEL)));
    if switch.on_hover_text(meaning).changed() {
        *sent = if of_model {
            Sent::Model
        } else {
            Sent::Measured
        };
    }
}

/// Draws the knobs that decide something and asks for what a hand changed.
pub(crate) fn knobs(form: &mut Form<'_>, context: &mut PageContext<'_>, sent: Sent) {
    let before = context.app.document().settings;
    let mut settings = before;
    if sent == Sent::Model {
        let of = slide(&mut settings.order, 0..=MOST).clamping(SliderClamping::Never);
        let meaning =
            said!("Waves that draw the smooth part: order N, which takes 2N + 1 numbers.");
        form.slider((said(names::ORDER), meaning), of);
    }
    // Otherwise it decides nothing.
    if settings.spikes && settings.detector == Detector::Energy {
        let [least, most] = LINE_THRESHOLDS;
        let of = slide(&mut settings.threshold_percent, least..=most)
            .logarithmic(true)
            .clamping(SliderClamping::Never)
            .custom_formatter(|v, _| ticks::short(v))
            .suffix(" %");
        let meaning = said!(
            "Share of the power above which a peak is a line of its own, one exact ray; below it \
             melts into the smooth part and is smeared."
        );
        form.slider((said(names::LINES), meaning), of);
    }
    if settings != before {
        context.commands.push(Command::Edit(settings));
    }
}
