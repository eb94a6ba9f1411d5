//! The knobs of the lines.

use crate::ui::kit::slide;
use eframe::egui;
use egui::{Slider, SliderClamping, Ui};

use super::{names, reach_words};
use crate::{
    app::{Detector, Settings, ticks},
    languages::said,
    ui::kit::{Choice, knob},
};

/// The sliders' own reach; more can be typed.
const SLIDER_THRESHOLDS: std::ops::RangeInclusive<f64> = 0.1..=5.0;
const SLIDER_WIDTHS_NM: std::ops::RangeInclusive<f64> = 2.0..=20.0;

/// The least line: by its slope or its share of the power.
fn threshold_row(ui: &mut Ui, settings: &mut Settings) {
    let enabled = settings.spikes;
    if settings.detector == Detector::Gradient {
        let slider = knob::slider(&Settings::GRADIENT, settings).logarithmic(true);
        let meaning = said!("Least slope of a line's flanks, percent of the largest value per nm.");
        return slider_row(ui, enabled, said!("Slope"), slider, meaning);
    }
    let slider = slide(&mut settings.threshold_percent, SLIDER_THRESHOLDS)
        .logarithmic(true)
        .clamping(SliderClamping::Never)
        .suffix(" %");
    let meaning = tr!(
        "Least share of the total power that a line must carry, percent. {range} can be typed.",
        range = reach_words(&Settings::THRESHOLD)
    );
    slider_row(ui, enabled, said(names::THRESHOLD), slider, &meaning);
}

fn slider_row(ui: &mut Ui, enabled: bool, name: &str, slider: Slider<'_>, meaning: &str) {
    let label = ui.add_enabled(enabled, egui::Label::new(name));
    let slider = slider.custom_formatter(|v, _| ticks::short(v));
    ui.add_enabled(enabled, slider)
        .labelled_by(label.id)
        .on_hover_text(meaning);
    ui.end_row();
}

/// How lines are found, and what that means.
fn detector_words(detector: Detector) -> (&'static str, &'static str) {
    match detector {
        Detector::Energy => (
            said!("by energy"),
            said!("Prominent, narrow peaks whose energy is above the threshold."),
        ),
        Detector::Gradient => (
            said!("by gradient"),
            said!("The paper's way: steep on both sides."),
        ),
    }
}

/// Draws what is taken for a line.
pub(super) fn spike_rows(ui: &mut Ui, settings: &mut Settings) {
    ui.checkbox(&mut settings.spikes, said(names::SPIKES))
        .on_hover_text(said!(
            "Takes lines out of the spectrum and keeps each as a place and a weight."
        ));
    ui.horizontal(|ui| {
        ui.add_enabled_ui(settings.spikes, |ui| {
            let choice = Choice {
                name: said!("How lines are found"),
                meaning: said!("The rule that tells a line from the smooth part."),
                width: ui.spacing().combo_width,
            };
            let both = [Detector::Energy, Detector::Gradient];
            choice.pick(ui, &mut settings.detector, both, detector_words);
            ui.add_enabled(
                settings.detector == Detector::Energy,
                egui::Checkbox::new(&mut settings.dips, said(names::DIPS)),
            )
            .on_disabled_hover_text(said!("The gradient detector finds bright lines only."))
            .on_hover_text(said!(
                "Looks for absorption lines too; they become lines of negative weight."
            ));
        });
    });
    ui.end_row();

    threshold_row(ui, settings);
    let slider = slide(&mut settings.max_width_nm, SLIDER_WIDTHS_NM)
        .clamping(SliderClamping::Never)
        .suffix(" nm");
    let meaning = tr!(
        "Full width at half maximum of the widest line that is kept, nm. {range} can be typed.",
        range = reach_words(&Settings::WIDTH)
    );
    slider_row(ui, settings.spikes, said(names::WIDTH), slider, &meaning);
}
