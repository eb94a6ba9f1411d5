//! A page beside the spectrum: drawn as it is or presented, and what it asks of the window.

use eframe::egui;
use egui::{Context, Rect, ScrollArea, Ui, UiBuilder, vec2};

use super::{
    super::{
        files::Ask,
        look_view,
        pages::{PageContext, PageWish, Pages, presented},
        theme::{self, Theme},
    },
    Window,
    filing::Saving,
};
use crate::app::{Command, import::Again, pages::PageStates};

/// Least width of what is on a page beside the spectrum: a narrower window scrolls it.
const LEAST_WIDTH: f32 = 400.0;
impl Window {
    /// A page beside the spectrum, large and without the rest of the window.
    pub(super) fn presented(&mut self, ui: &mut Ui, theme: Theme) {
        let in_lesson = self.lesson.as_ref().map(|run| run.uses_page());
        let mut look = std::mem::take(&mut self.look);
        let mut leaves = false;
        self.page(ui, theme, |pages, ui, shown| {
            let knobs = presented::Knobs {
                height: look_view::knobs_height(ui.available_width(), theme),
                show: &mut |ui, shown| look.knobs(ui, shown.app, theme, shown.commands),
            };
            leaves = presented::show(pages, ui, shown, in_lesson, knobs);
        });
        self.look = look;
        if leaves {
            self.leave();
        }
    }

    /// A page beside the spectrum.
    pub(super) fn page(
        &mut self,
        ui: &mut Ui,
        theme: Theme,
        mut draw: impl FnMut(&mut Pages, &mut Ui, &mut PageContext<'_>),
    ) {
        let context = ui.ctx().clone();
        let (mut commands, mut wishes) = (Vec::new(), Vec::new());
        // Every page keeps its own place in its scroll area.
        let salt = self.preferences.page.word();
        let pages = &mut self.pages;
        let mut kept = self.app.document().pages.clone();
        let mut shown = PageContext {
            app: &self.app,
            studies: &mut self.studies,
            pages: &mut kept,
            page: &mut self.preferences.page,
            finished: &self.preferences.lessons_finished,
            language: &mut self.preferences.lesson_language,
            photographs_asked: &mut self.preferences.photographs_asked,
            theme,
            wake: &theme::waker(&context),
            commands: &mut commands,
            wishes: &mut wishes,
            quiet: self.quiet,
            taken: None,
        };
        let page_ui = &mut ui.new_child(egui::UiBuilder::new().id_salt(salt));
        let size = page_ui.available_size();
        if size.x >= LEAST_WIDTH {
            draw(pages, page_ui, &mut shown);
        } else {
            ScrollArea::horizontal()
                .auto_shrink(false)
                .show(page_ui, |ui| {
                    let whole =
                        Rect::from_min_size(ui.cursor().min, vec2(LEAST_WIDTH, size.y - 10.0));
                    let mut child = ui.new_child(UiBuilder::new().max_rect(whole));
                    draw(pages, &mut child, &mut shown);
                    ui.advance_cursor_after_rect(whole);
                });
        }
        if !commands.is_empty() {
            // The right panel was drawn before the page's click.
            context.request_repaint();
        }
        self.keep_pages(kept, &mut commands, &context);
        for wish in wishes {
            self.grant(wish, &context);
        }
    }

    /// Carries out what a page asked for, and makes what it keeps now the document's: by a hand it
    /// is a step of undo, by itself (a sum that is played) it belongs to the step before.
    pub(super) fn keep_pages(
        &mut self,
        kept: PageStates,
        commands: &mut Vec<Command>,
        context: &Context,
    ) {
        let is_touched = kept != self.app.document().pages;
        let before = self.app.changes();
        self.apply(commands);
        if !is_touched {
            return;
        }
        let moved = |event: &egui::Event| {
            matches!(
                event,
                egui::Event::PointerMoved(_) | egui::Event::MouseMoved(_)
            )
        };
        let by_hand = context.input(|i| i.pointer.any_down() || !i.events.iter().all(moved));
        let change = |pages: &mut PageStates| *pages = kept;
        if by_hand && self.app.changes() == before {
            self.app.edit_pages(change);
        } else {
            self.app.pages_follow(change);
        }
    }

    /// Does what a page asked for.
    fn grant(&mut self, wish: PageWish, context: &Context) {
        match wish {
            PageWish::Chart(chart) => self.save_chart(chart, context),
            PageWish::Gem(gem) => self.save(Saving::Gem(Box::new(gem)), context),
            PageWish::FewNumbers(picture) => self.save(Saving::Picture(picture), context),
            PageWish::Lesson(lesson, file) => self.save(Saving::Lesson(lesson, file), context),
            PageWish::Begin(name) => self.begin_lesson(name, context),
            PageWish::Instrument(instrument) => {
                self.save(Saving::Instrument(instrument), context);
            }
            PageWish::Photograph(seen) => self.app.note_photograph(&seen),
            PageWish::OwnPicture => {
                self.app.stage_photograph(None);
                context.request_repaint();
            }
            PageWish::OpenPicture => self.ask(Ask::Open, None, context),
            PageWish::Reading(key) => {
                let image = self.app.document().images.iter().find(|i| i.key == key);
                let wake = theme::waker(context);
                self.import.again = image.map(|image| Again::of(&image.from, &wake));
                context.request_repaint();
            }
        }
    }
}
