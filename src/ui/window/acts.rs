//! What keys and the top bar ask for.

use eframe::egui;
use egui::Context;

use super::{
    super::{
        chart_view::{ChartForm, ChartWish},
        dialogs::Dialog,
        eyes,
        files::Ask,
        keys::{self, Act},
        picture,
        theme::waker,
        top_view::Wish,
    },
    Window,
    filing::Saving,
};
use crate::app::{
    Command, Settings, Tone, chart,
    charts::order::curve_chart,
    command_lines,
    export::Export,
    link::{self, Target},
    pages::{AskedLesson, Page, Place},
    workspace::ZOOMS,
};
use crate::languages::{Language, in_language};

impl Window {
    /// Opens what a link asks for ([`link`]).
    pub fn open_link(&mut self, link: &str) {
        for target in link::targets(link) {
            // What is opened is to be seen.
            self.greets = false;
            match target {
                Ok(Target::Page(page)) => self.preferences.page = page,
                Ok(Target::Light(entry)) => self.app.apply(Command::Show(entry)),
                Ok(Target::File(loaded)) => self.take(loaded),
                Ok(Target::Lesson(name)) => {
                    self.preferences.lesson_asked = Some(AskedLesson {
                        name,
                        step: 0,
                        done: false,
                    });
                }
                Err(why) => self.app.say(Tone::Problem, why),
            }
            self.app.end_gesture();
        }
    }

    /// The window's picture as it would be drawn at a size, without a display.
    pub fn picture(&self, size: [u32; 2]) -> Vec<u8> {
        picture::window_png(&self.app, &self.preferences, size)
    }

    pub(super) fn keys(&mut self, context: &Context) {
        if self.dialog.is_some() {
            return;
        }
        let others = self.palette.is_open() || self.drawer.open || self.menu_open;
        let escapes = context.input(|i| i.key_pressed(egui::Key::Escape));
        if escapes && !others && self.lesson_view.close_word() {
            return;
        }
        if self.preferences.presents()
            && !others
            && context.input(|i| i.key_pressed(egui::Key::Escape))
        {
            self.leave();
        }
        self.lesson_keys(context);
        let follows = self.following.is_some() && !others && self.import.now.is_none();
        for act in keys::pressed(context, follows) {
            self.act(act, context);
        }
    }

    pub(super) fn act(&mut self, act: Act, context: &Context) {
        const FINER: f64 = 1.25;
        match act {
            Act::Open => self.ask(Ask::Open, None, context),
            Act::OpenFolder => self.ask(Ask::OpenFolder, None, context),
            Act::TypePath => self.dialog = Some(Dialog::OpenPath(String::new())),
            Act::SaveProject => self.save(Saving::Text(Export::Project), context),
            Act::Undo => self.app.apply(Command::Undo),
            Act::Redo => self.app.apply(Command::Redo),
            Act::OrderDown => self.edit(|s| s.order = s.order.saturating_sub(1)),
            Act::OrderUp => self.edit(|s| s.order += 1),
            Act::ThresholdDown => self.edit(|s| s.threshold_percent /= FINER),
            Act::ThresholdUp => self.edit(|s| s.threshold_percent *= FINER),
            Act::ResetView => self.look.spectrum.reset(),
            Act::Theme => self.preferences.dark = !self.preferences.dark,
            Act::Eyes => {
                let (eyes, words) = eyes::next(self.preferences.without_cones);
                self.preferences.without_cones = eyes;
                self.app.say(Tone::Info, format!("{words}."));
            }
            Act::Touch => {
                self.preferences.touch = Some(self.preferences.touch != Some(true));
            }
            Act::Present => self.preferences.present = !self.preferences.present,
            Act::Search => {
                self.drawer.open = true;
                self.library.wants_search = true;
            }
            Act::Library => {
                self.drawer.open = !self.drawer.open;
                self.drawer.compares = false;
                self.library.wants_search = self.drawer.open;
            }
            Act::Place(number) => {
                if let Some(place) = Place::ALL.get(number) {
                    self.preferences.go_to(*place);
                }
            }
            Act::Reset => {
                self.app.apply(Command::Reset);
                self.app.end_gesture();
            }
            Act::ResetPage => {
                let page = self.preferences.page;
                self.app.edit_pages(|pages| pages.set_back(page));
                self.app.end_gesture();
            }
            Act::Palette => self.palette.open(),
            Act::Greeting => self.greets = true,
            Act::ZoomIn => self.zoom(self.preferences.zoom + 0.1),
            Act::ZoomOut => self.zoom(self.preferences.zoom - 0.1),
            Act::ZoomReset => self.zoom(1.0),
            Act::Print => self.print_page(context),
            Act::Hold => self.hold(),
            Act::Capture => self.capture(),
            Act::Shortcuts => self.dialog = Some(Dialog::Shortcuts),
            Act::CopyPicture => {
                let size = context.content_rect().size();
                let image = picture::window_image(
                    &self.app,
                    &self.preferences,
                    [size.x as u32, size.y as u32],
                );
                context.copy_image(image);
                self.app
                    .say(Tone::Info, said!("A picture of the window was copied."));
            }
            Act::CopyCommand => self.copy_command(context),
        }
    }

    /// Copies the command lines that print these numbers and draw this view.
    fn copy_command(&mut self, context: &Context) {
        let size = context.content_rect().size();
        let page = self.preferences.page;
        let size = [size.x as u32, size.y as u32];
        let dark = self.preferences.dark;
        let lines = || command_lines(&self.app, page, size, dark);
        match in_language(Language::English, lines) {
            Ok(words) => {
                let told = said!("Copied: the command lines for these numbers and this view.");
                self.app.say(Tone::Info, told);
                context.copy_text(words);
            }
            Err(why) => self.app.say(Tone::Problem, why),
        }
    }

    /// One step of the model's settings by a key.
    fn edit(&mut self, change: impl FnOnce(&mut Settings)) {
        let mut settings = self.app.document().settings;
        change(&mut settings);
        self.app.apply(Command::Edit(settings));
        self.app.end_gesture();
    }

    pub(super) fn zoom(&mut self, zoom: f32) {
        self.preferences.zoom = ((zoom * 10.0).round() / 10.0).clamp(ZOOMS[0], ZOOMS[1]);
    }

    pub(super) fn fulfil(&mut self, wish: Wish, context: &Context) {
        match wish {
            Wish::Act(act) => self.act(act, context),
            Wish::Speak(language) => self.preferences.speak(language),
            Wish::DecimalCommas(are_wanted) => self.preferences.decimal_commas = are_wanted,
            Wish::Recent(index) => {
                let path = self.preferences.recent.get(index).cloned();
                self.open_files(path.into_iter().collect(), waker(context));
            }
            Wish::Follow => self.preferences.page = Page::Live,
            Wish::Summary => self.batch.show(),
            Wish::Save(export) => self.save(Saving::Text(export), context),
            Wish::SavePlotPng => self.save(Saving::PlotPng, context),
            Wish::SaveSheetPdf => self.save(Saving::SheetPdf, context),
            Wish::SaveCurvePng => {
                let chart = curve_chart(&self.app);
                let mut wish = ChartWish::new(&chart, ChartForm::Png);
                let name = Export::CurveSvg.suggested_name(&self.app);
                wish.stem = name.trim_end_matches(".svg").to_owned();
                self.save_chart(wish, context);
            }
            Wish::SaveWindowPng => self.save(Saving::WindowPng, context),
            Wish::Copy(export) => {
                let theme = chart::Theme::Light;
                match export.text(&self.app, theme) {
                    Ok(text) => {
                        context.copy_text(text.trim_end().to_owned());
                        self.app
                            .say(Tone::Info, tr!("Copied: {what}.", what = export.title()));
                    }
                    Err(why) => self.app.say(Tone::Problem, why),
                }
            }
            Wish::CopyLink => {
                let address = self.address.clone().unwrap_or_default();
                let link = link::of_view(&self.app, self.preferences.page);
                context.copy_text(format!("{address}#{link}"));
                self.app
                    .say(Tone::Info, said!("Copied: a link to this view."));
            }
            Wish::LessonsFolder => {
                if let Some(folder) = &self.lessons_folder {
                    let path = folder.display().to_string();
                    self.app
                        .say(Tone::Info, tr!("Copied: {what}.", what = path));
                    context.copy_text(path);
                }
            }
            Wish::CompareNoMore => {
                self.app.apply(Command::Compare(None));
                self.app.end_gesture();
            }
            Wish::About => self.dialog = Some(Dialog::About(None)),
        }
    }
}
