//! The model's column: the verdict, every figure, every knob; and the edge that it folds to.

use eframe::egui;
use egui::{Margin, Panel, ScrollArea, Ui, UiBuilder};

use super::{
    super::{
        colour_view,
        kit::{pressed, rolled},
        look_view, model_view, spikes_view,
        theme::{self, Theme},
        verdict_view::{self, Side},
    },
    Window,
    panels::{COLUMN, Shape, fixed, in_its_size, plain},
};
use crate::{
    app::{App, Command, Pair, SpikeAct, Tone, answers},
    languages::said,
};

/// Width of the edge that the column folds to.
const EDGE: f32 = 24.0;
impl Window {
    /// Whether the model is judged beside the page: not in a lesson or at a projector that shows no
    /// model, where the verdict would be taken for one about the light.
    pub(super) fn tells_verdict(&self) -> bool {
        let is_shown_to_others = self.lesson.is_some() || self.preferences.presents();
        !is_shown_to_others || self.app.document().view.model
    }

    /// Two surfaces that are shown side by side where the model is not judged.
    pub(super) fn pair(&mut self) -> Option<Pair> {
        if self.tells_verdict() {
            return None;
        }
        let app = &self.app;
        let make = |_: &_| Pair::of(app.document());
        self.pair_shown.get(app.revision(), make).clone()
    }

    /// Whether the column of the verdict is open.
    pub(super) fn side_is_open(&self, shape: Shape) -> bool {
        let has_model = self.preferences.page.has_model();
        !shape.present && self.tells_verdict() && self.side_open.unwrap_or(shape.wide && has_model)
    }

    /// Whether the open column leaves no room for the page.
    pub(super) fn side_alone(&self, shape: Shape) -> bool {
        let no_room = match self.side {
            Side::Figures => shape.narrower,
            Side::Verdict | Side::Settings => shape.narrow,
        };
        no_room && !shape.present && self.side_is_open(shape)
    }

    /// The model's column, or the edge that it folds to. A column without knobs is left to be drawn
    /// behind the page, whose knobs it tells of: its room is given.
    pub(super) fn side_panel(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) -> Option<Ui> {
        let has_model = self.preferences.page.has_model();
        if shape.present || !self.tells_verdict() || !(has_model || self.side_open == Some(true)) {
            return None;
        }
        let open = self.side_is_open(shape);
        if !shape.wide || self.side_open.is_some() {
            let frame = plain(ui, Margin::ZERO);
            fixed(Panel::right("edge"), frame, EDGE).show(ui, |ui| {
                if verdict_view::edge(ui, open) {
                    self.side_open = match (open, shape.wide && has_model) {
                        (true, false) | (false, true) => None,
                        (open, _) => Some(!open),
                    };
                }
            });
        }
        if !open {
            return None;
        }
        let frame = plain(ui, Margin::same(16));
        if self.side_alone(shape) {
            egui::CentralPanel::default()
                .frame(frame)
                .show(ui, |ui| self.column(ui, theme));
            return None;
        }
        let [widest, usual, least] = COLUMN;
        let width = match (shape.very_wide, self.drawer.open || !shape.wide) {
            // Tables are never cut.
            _ if self.side == Side::Figures => widest,
            (true, _) => widest,
            (false, true) => least,
            (false, false) => usual,
        };
        let mut left = None;
        // What stands in it grows with the window's type.
        fixed(Panel::right("model"), frame, width * theme.scale.max(1.0)).show(ui, |ui| {
            in_its_size(ui, |ui| match self.side {
                Side::Settings => self.column(ui, theme),
                Side::Verdict | Side::Figures => {
                    left = Some(ui.new_child(UiBuilder::new().id_salt("column")));
                }
            });
        });
        left
    }

    pub(super) fn column(&mut self, ui: &mut Ui, theme: Theme) {
        let (mut commands, mut said) = (Vec::new(), None);
        if self.side == Side::Verdict {
            let (app, preferences) = (&self.app, &mut self.preferences);
            let mut acts: Vec<SpikeAct> = Vec::new();
            let height = ui.available_height() - verdict_view::FOOT * theme.scale;
            ScrollArea::vertical()
                .auto_shrink(false)
                .max_height(height)
                .show(ui, |ui| {
                    let top = ui.cursor().top();
                    verdict_view::show(ui, app, preferences, theme, height, &mut commands);
                    let left = height - (ui.cursor().top() - top);
                    let [least, wide] = [LINES, LINES_WIDE].map(|room| room * theme.scale);
                    if left >= least && ui.available_width() >= wide {
                        theme::section(ui, said!("Lines"));
                        spikes_view::table(ui, app, theme, &mut acts);
                    }
                });
            for act in acts {
                self.app.act_on_spikes(act);
            }
            ui.add_space(8.0);
            verdict_view::foot(ui, theme, &mut self.side);
        } else {
            ui.horizontal(|ui| {
                for (side, words) in [
                    (Side::Verdict, said!("◀ Verdict")),
                    (Side::Figures, said!("All figures")),
                    (Side::Settings, said!("Settings")),
                ] {
                    ui.selectable_value(&mut self.side, side, words);
                }
            });
            ui.add_space(4.0);
            rolled(ui, |ui| {
                if self.side == Side::Settings {
                    said = model_view::controls(ui, &self.app, &mut commands);
                    let mut automatic = self.app.document().pages.known_lamps.automatic;
                    let asked = ui
                        .checkbox(&mut automatic, said!("Automatic: known lamps too"))
                        .on_hover_text(said!(
                            "Automatic may also describe the light by lamps that the program \
                             knows. Decoding then needs this program's list of lamps. Where that \
                             is better, the page Known lamps opens."
                        ));
                    if asked.changed() {
                        self.app
                            .edit_pages(|pages| pages.known_lamps.automatic = automatic);
                    }
                    ui.add_space(8.0);
                    as_in_the_paper(ui, &self.app, &mut commands);
                } else {
                    self.figures(ui, theme);
                }
            });
        }
        if !commands.is_empty() {
            // The lines above and below the page were drawn before, and perhaps the page itself.
            ui.ctx().request_repaint();
        }
        self.apply(&mut commands);
        // What was taken is said of the model as it is now.
        if let Some(words) = said {
            self.app.say(Tone::Info, words);
        }
    }

    /// Every figure: colours and errors, or the maker's own results, and the lines.
    fn figures(&mut self, ui: &mut Ui, theme: Theme) {
        if !self.makers.tabs(ui, &self.app) {
            let is_titled = !self.app.document().subject_entry().makers.is_empty();
            colour_view::show(ui, &self.app, theme, is_titled);
        } else if let Some(words) = self.makers.show(ui, &self.app) {
            self.app.say(Tone::Info, words);
        }
        let mut acts: Vec<SpikeAct> = Vec::new();
        ui.add_space(8.0);
        theme::section(ui, said!("Lines"));
        spikes_view::head(ui, &self.app, &mut acts);
        spikes_view::table(ui, &self.app, theme, &mut acts);
        for act in acts {
            self.app.act_on_spikes(act);
        }
    }
}

/// Room below the verdict from which on the lines are listed there, points.
const LINES: f32 = 180.0;
/// Width that their table needs, points.
const LINES_WIDE: f32 = 396.0;

/// The paper's settings in one click.
fn as_in_the_paper(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let meaning = said!(
        "Plain Fourier series on 400 to 700 nm where the table reaches, lines by their slope, \
         products on the paper's points."
    );
    if pressed(ui, said(look_view::names::PAPER), meaning) {
        commands.push(Command::Edit(answers::as_in_the_paper(app)));
    }
}
