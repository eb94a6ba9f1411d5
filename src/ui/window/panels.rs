//! What stands in the panels between the top bar and the status line.

use eframe::egui;
use egui::{Panel, Rect, ScrollArea, Ui, UiBuilder, vec2};

use super::{
    super::{
        colour_view, curve_view,
        fit::{Fit, Front, LIBRARY_WIDTHS, MODEL_WIDTH, MOST_MODEL_WIDTH, PAGE_WIDTH},
        model_view,
        pages::{self, PageContext},
        patches_view, spikes_view,
        theme::{self, Theme},
    },
    Window,
};
use crate::app::{Command, pages::Page, picture::shown, spike_hand::SpikeAct, state::Tone};

/// Least height of a page, points: a lower window scrolls it.
const LEAST_PAGE: f32 = 480.0;

impl Window {
    /// Whether the library is shown.
    pub(super) fn shows_library(&self, fit: Fit) -> bool {
        match fit {
            Fit::All => !self.preferences.no_library,
            Fit::Two | Fit::One => self.front == Front::Library,
        }
    }

    /// The library on the left, or alone where nothing else has room.
    pub(super) fn library_panel(
        &mut self,
        ui: &mut Ui,
        theme: Theme,
        fit: Fit,
        commands: &mut Vec<Command>,
    ) {
        let beside = match fit {
            Fit::All => (PAGE_WIDTH + MODEL_WIDTH) * theme.scale,
            Fit::Two | Fit::One => PAGE_WIDTH * theme.scale,
        };
        let [least, most] = LIBRARY_WIDTHS;
        let most = (ui.available_width() - beside).clamp(least, most);
        let (library, app, preferences) = (&mut self.library, &self.app, &mut self.preferences);
        let add = |ui: &mut Ui| library.show(ui, app, preferences, theme, commands);
        if fit == Fit::One {
            egui::CentralPanel::default_margins().show(ui, add);
        } else {
            Panel::left("library")
                .default_size(224.0)
                .size_range(least..=most)
                .show(ui, add);
        }
    }

    /// The model's knobs and numbers on the right, or alone where nothing else has room.
    pub(super) fn model_panel(&mut self, ui: &mut Ui, theme: Theme, fit: Fit) {
        if fit == Fit::One {
            egui::CentralPanel::default_margins().show(ui, |ui| {
                ScrollArea::both()
                    .auto_shrink(false)
                    .show(ui, |ui| self.right_panel(ui, theme));
            });
            return;
        }
        // Large type needs another width: each keeps its own.
        let right = if self.preferences.projector {
            "model, projector"
        } else {
            "model"
        };
        let least = MODEL_WIDTH * theme.scale;
        let most = ui.available_width() - PAGE_WIDTH * theme.scale;
        Panel::right(right)
            .default_size(least)
            .size_range(least..=most.clamp(least, MOST_MODEL_WIDTH.max(least)))
            .show(ui, |ui| {
                in_its_size(ui, |ui| {
                    ScrollArea::vertical()
                        .auto_shrink(false)
                        .show(ui, |ui| self.right_panel(ui, theme));
                });
            });
    }

    /// The page in force, scrolled where the window is too low for it. Gives where it is seen.
    pub(super) fn page_panel(&mut self, ui: &mut Ui, theme: Theme) -> Rect {
        let room = ui.available_rect_before_wrap();
        let least = LEAST_PAGE * theme.scale;
        if room.height() >= least {
            return self.whole_page(ui, theme);
        }
        let mut centre = room;
        egui::CentralPanel::no_frame().show(ui, |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                let size = vec2(ui.available_width(), least);
                let whole = Rect::from_min_size(ui.cursor().min, size);
                let mut child = ui.new_child(UiBuilder::new().max_rect(whole));
                centre = self.whole_page(&mut child, theme).intersect(room);
                ui.advance_cursor_after_rect(whole);
            });
        });
        centre
    }

    fn whole_page(&mut self, ui: &mut Ui, theme: Theme) -> Rect {
        let context = ui.ctx().clone();
        let on_spectrum = self.preferences.pages.page == Page::Spectrum;
        if on_spectrum {
            Panel::bottom("below")
                .default_size(156.0 * theme.scale)
                .size_range(90.0..=420.0)
                .resizable(true)
                .show(ui, |ui| in_its_size(ui, |ui| self.below(ui, theme)));
        }
        let mut centre = ui.max_rect();
        egui::CentralPanel::default_margins().show(ui, |ui| {
            centre = ui.max_rect();
            pages::tabs(ui, &mut self.preferences.pages.page);
            if !on_spectrum {
                self.page(ui, theme);
                return;
            }
            let wishes = self.spectrum.show(ui, &self.app, theme);
            let mut commands = wishes.commands;
            self.apply(&mut commands);
            let before = self.app.revision();
            for act in wishes.acts {
                self.app.act_on_spikes(act);
            }
            if self.app.revision() != before {
                // The plot was drawn before the drag moved the spike.
                context.request_repaint();
            }
            if wishes.gesture_ended {
                self.app.end_gesture();
            }
        });
        centre
    }

    /// A page beside the spectrum.
    fn page(&mut self, ui: &mut Ui, theme: Theme) {
        let context = ui.ctx().clone();
        let (mut commands, mut wishes) = (Vec::new(), Vec::new());
        // Every page keeps its own place in its scroll area.
        let salt = self.preferences.pages.page.word();
        let (pages, page_ui) = (
            &mut self.pages,
            &mut ui.new_child(egui::UiBuilder::new().id_salt(salt)),
        );
        pages.show(
            page_ui,
            &mut PageContext {
                app: &self.app,
                studies: &mut self.studies,
                memory: &mut self.preferences.pages,
                theme,
                wake: &theme::waker(&context),
                commands: &mut commands,
                wishes: &mut wishes,
                quiet: self.quiet,
            },
        );
        for wish in wishes {
            self.save_chart(wish, &context);
        }
        if !commands.is_empty() {
            // The right panel was drawn before the page's click.
            context.request_repaint();
        }
        self.apply(&mut commands);
    }

    fn right_panel(&mut self, ui: &mut Ui, theme: Theme) {
        let mut commands = Vec::new();
        self.tell_whose_model(ui);
        let said = model_view::controls(ui, &self.app, &mut commands);
        self.apply(&mut commands);
        if let Some(words) = said {
            self.app.say(Tone::Info, words);
        }
        curve_view::show(ui, &self.app, &mut self.preferences, theme, &mut commands);
        let moved = !commands.is_empty();
        self.apply(&mut commands);
        if moved {
            // The curve was drawn before its own click: show the new order at once.
            ui.ctx().request_discard("the order curve was clicked");
        }
        self.spend(ui);
        ui.add_space(2.0);
        ui.separator();
        if !self.makers.tabs(ui, &self.app) {
            let is_titled = !self.app.document().subject_entry().makers.is_empty();
            colour_view::show(ui, &self.app, theme, is_titled);
        } else if let Some(words) = self.makers.show(ui, &self.app) {
            self.app.say(Tone::Info, words);
        }
    }

    /// On the page of images the panel may be of another spectrum than the picture's frame.
    fn tell_whose_model(&self, ui: &mut Ui) {
        let pages = &self.preferences.pages;
        let document = self.app.document();
        let Some(image) = shown(document, &pages.image).filter(|_| pages.page == Page::Image)
        else {
            return;
        };
        let chosen = image.image.name_of(pages.image.rect(&image.image.cube));
        let subject = document.subject_entry().name();
        if subject != chosen {
            let words = format!(
                "This panel is of {subject}, not of the pixels chosen in the picture; \"{}\" brings \
                 those here.",
                pages::image_view::names::TAKE
            );
            ui.add(egui::Label::new(egui::RichText::new(words).small().weak()).wrap());
        }
    }

    /// "Spend 21 numbers for me."
    fn spend(&mut self, ui: &mut Ui) {
        let mut commands = Vec::new();
        let wake = theme::waker(ui.ctx());
        let outcome = self.spend.show(
            ui,
            &self.app,
            &mut self.studies,
            &mut self.preferences.pages,
            &wake,
            &mut commands,
        );
        if !commands.is_empty() {
            // The model's knobs stand above and were drawn before.
            ui.ctx().request_repaint();
        }
        self.apply(&mut commands);
        if let Some((tone, words)) = outcome {
            self.app.say(tone, words);
        }
    }

    fn below(&mut self, ui: &mut Ui, theme: Theme) {
        let mut commands = Vec::new();
        let mut acts: Vec<SpikeAct> = Vec::new();
        ui.horizontal_wrapped(|ui| {
            let spikes = self.app.derived().parts.spikes.len();
            let below = &mut self.preferences.spikes_below;
            if ui
                .selectable_label(!*below, "Through reflectances")
                .on_hover_text("Patches under the measured light and under the model.")
                .clicked()
            {
                *below = false;
            }
            if ui
                .selectable_label(*below, format!("Spikes ({spikes})"))
                .on_hover_text("The spikes as a table to edit.")
                .clicked()
            {
                *below = true;
            }
            ui.separator();
            if self.preferences.spikes_below {
                spikes_view::head(ui, &self.app, &mut acts);
            } else {
                patches_view::head(ui, &self.app, &mut commands);
            }
        });
        self.apply(&mut commands);
        if self.preferences.spikes_below {
            spikes_view::table(ui, &self.app, theme, &mut acts);
        } else {
            patches_view::patches(ui, &self.app, theme, &mut commands);
        }
        self.apply(&mut commands);
        for act in acts {
            self.app.act_on_spikes(act);
        }
    }
}

/// Contents in a panel that neither grows nor shrinks with them.
pub(super) fn in_its_size(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    let room = ui.available_rect_before_wrap();
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(room));
    // Frames of what has the keyboard's focus reach a little beyond.
    inner.shrink_clip_rect(room.expand(3.0));
    add(&mut inner);
    ui.advance_cursor_after_rect(room);
}
