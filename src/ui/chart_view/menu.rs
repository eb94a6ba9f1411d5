//! The menu at a chart's corner: its numbers and its pictures, to copy or to save.

use eframe::egui;
use egui::{Button, RichText, Ui};

use super::super::kit::named;
use crate::{
    app::{chart::Chart, export::stem_of},
    languages::said,
};

/// What a chart is wanted as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartForm {
    /// The numbers, into the clipboard.
    CopyCsv,
    /// The numbers, as a file.
    Csv,
    /// A picture of pixels.
    Png,
    /// A picture of lines.
    Svg,
    /// A picture of lines that the browser opens, to print it.
    Print,
}

impl ChartForm {
    /// All forms with what the menu calls them, in its order.
    pub const ALL: [(Self, &'static str); 5] = [
        (Self::CopyCsv, later!("Copy as CSV")),
        (Self::Csv, later!("Save CSV…")),
        (Self::Png, later!("Save PNG…")),
        (Self::Svg, later!("Save SVG…")),
        (Self::Print, later!("Print…")),
    ];

    /// The extension of its file.
    pub fn extension(self) -> &'static str {
        match self {
            Self::CopyCsv | Self::Csv => "csv",
            Self::Png => "png",
            Self::Svg | Self::Print => "svg",
        }
    }
}

/// A chart to copy or save.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartWish {
    /// The chart as it was shown.
    pub chart: Box<Chart>,
    pub form: ChartForm,
    /// The file's name without its extension; made of the title, and free to be replaced.
    pub stem: String,
}

impl ChartWish {
    /// A wish for a chart, under a name made of its title.
    pub fn new(chart: &Chart, form: ChartForm) -> Self {
        // What stands in brackets tells details, and is too long for a name.
        let title = chart.title.split(" (").next().unwrap_or_default();
        Self {
            stem: stem_of(title, "chart"),
            chart: Box::new(chart.clone()),
            form,
        }
    }

    pub fn file_name(&self) -> String {
        format!("{}.{}", self.stem, self.form.extension())
    }
}

/// The same menu where the right button clicks the chart.
pub(super) fn on_right_click(response: &egui::Response, chart: &Chart) -> Option<ChartWish> {
    let mut wish = None;
    response.context_menu(|ui| wish = items(ui, chart));
    wish
}

fn items(ui: &mut Ui, chart: &Chart) -> Option<ChartWish> {
    let mut wish = None;
    for (form, words) in ChartForm::ALL {
        if ui.button(said(words)).clicked() {
            wish = Some(ChartWish::new(chart, form));
            ui.close();
        }
    }
    wish
}

/// Draws the menu's button.
pub(super) fn menu(ui: &mut Ui, chart: &Chart) -> Option<ChartWish> {
    let mut wish = None;
    let button = Button::new(RichText::new("⋯").strong()).frame_when_inactive(false);
    let (response, _) = egui::containers::menu::MenuButton::from_button(button)
        .ui(ui, |ui| wish = items(ui, chart));
    let name = tr!("Save chart: {title}", title = chart.title);
    let name = name.trim_end_matches([':', ' ']);
    named(&response, egui::Role::Button, name);
    response.on_hover_text(said!(
        "Copy or save this chart: numbers (CSV), picture (PNG, SVG)."
    ));
    wish
}
