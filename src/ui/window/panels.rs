//! What stands in the panels of the window, by the room there is.

use eframe::egui;
use egui::{Context, Frame, Key, Margin, Panel, Rect, ScrollArea, Ui, UiBuilder, vec2};

use super::{
    super::{
        foot_view,
        greeting_view::{self, Beginning},
        keys::Act,
        kit::rolled,
        lesson_view,
        look_view::{self, Scene},
        pages,
        palette_view::Chosen,
        rail_view,
        theme::{self, Theme},
        top_view::{self, Drawer},
        verdict_view::{self, Side},
    },
    Window,
};
use crate::app::{Command, lessons::Run, pages::Page, workspace::Preferences};

/// Widths from which the column of the verdict stands beside the page, and from which it is wider,
/// points.
const WIDE: f32 = 1150.0;
const VERY_WIDE: f32 = 1600.0;
/// Below this the column has the window alone.
const NARROW: f32 = 660.0;
/// Below this height the window is low.
const LOW: f32 = 720.0;

/// Widths of the column: very wide, usual, and beside the drawer.
pub(super) const COLUMN: [f32; 3] = [440.0, 360.0, 304.0];
/// Width of the library's drawer.
const DRAWER: f32 = 384.0;
/// Around a page.
const PAGE_MARGIN: Margin = Margin::symmetric(16, 12);
/// Width of a page from which the model's line stands beside its tabs.
const LINE_BESIDE: f32 = 820.0;
/// The lamp to play with at a first start: three bands, many lines.
const LIVE: &str = "cie_fluorescent_1nm/FL11";
/// Least height of a page: a lower window scrolls it.
const LEAST_PAGE: f32 = 540.0;

/// The shape of the window: which of its parts have room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shape {
    /// The column stands beside the page.
    pub wide: bool,
    pub(super) very_wide: bool,
    pub(super) narrow: bool,
    /// Too narrow for a page beside every figure.
    pub(super) narrower: bool,
    low: bool,
    /// Presenting: the page alone, with swatch and patches.
    pub present: bool,
}

impl Shape {
    /// `taken`: the width that a lesson takes.
    pub(super) fn of(ui: &Ui, preferences: &Preferences, theme: Theme, taken: f32) -> Self {
        let size = ui.available_size();
        let width = (size.x - taken) / theme.scale.min(1.0);
        let present = preferences.presents();
        Self {
            wide: width >= WIDE && !present,
            very_wide: width >= VERY_WIDE,
            narrow: width < NARROW,
            narrower: width < NARROW + COLUMN[0] - COLUMN[2],
            low: size.y < LOW,
            present,
        }
    }
}

/// A frame without a line around it.
pub(super) fn plain(ui: &Ui, margin: Margin) -> Frame {
    Frame::new()
        .fill(ui.visuals().panel_fill)
        .inner_margin(margin)
}

/// A panel at a side that no hand makes wider.
pub(super) fn fixed(panel: Panel, frame: Frame, width: f32) -> Panel {
    panel.frame(frame).resizable(false).exact_size(width)
}

impl Window {
    /// The top bar.
    pub(super) fn bar(&mut self, ui: &mut Ui, shape: Shape, context: &Context) {
        let mut wishes = Vec::new();
        let before = self.drawer;
        let frame = plain(ui, Margin::symmetric(16, 0));
        let height = if shape.low { 44.0 } else { 48.0 };
        Panel::top("top")
            .frame(frame)
            .exact_size(height)
            .show(ui, |ui| {
                in_its_size(ui, |ui| {
                    let menus = top_view::Menus {
                        dialog_open: self.waiting.is_some(),
                        has_summary: self.batch.has_summary(),
                        lessons: self.lessons_folder.as_deref(),
                        is_page: self.address.is_some(),
                    };
                    let drawer = &mut self.drawer;
                    top_view::show(ui, &self.app, &self.preferences, drawer, menus, &mut wishes);
                });
            });
        // What is typed next is meant for it.
        self.library.wants_search |= self.drawer.open && self.drawer != before;
        for wish in wishes {
            self.fulfil(wish, context);
        }
    }

    /// The line at the bottom.
    pub(super) fn foot(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) {
        let frame = plain(ui, Margin::symmetric(16, 0));
        let height = if shape.low { 36.0 } else { 48.0 };
        Panel::bottom("foot")
            .frame(frame)
            .exact_size(height)
            .show(ui, |ui| {
                in_its_size(ui, |ui| {
                    let page = self.preferences.page;
                    // A lesson asks its own questions.
                    let words = match self.lesson {
                        Some(_) => Default::default(),
                        None => {
                            let (app, key) = (&self.app, (self.app.changes(), page));
                            let make = |_: &_| foot_view::words(app, page);
                            self.foot_words.get(key, make).clone()
                        }
                    };
                    let offered = foot_view::lesson(&self.app, page);
                    self.status(ui, theme, words, offered.filter(|_| self.lesson.is_none()));
                });
            });
    }

    /// The places.
    pub(super) fn rail(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) {
        let [words, none] = rail_view::WIDTHS;
        let width = if shape.wide { words } else { none };
        let frame = plain(ui, Margin::ZERO);
        fixed(Panel::left("rail"), frame, width).show(ui, |ui| {
            let preferences = &mut self.preferences;
            ScrollArea::vertical().show(ui, |ui| {
                rail_view::show(ui, preferences, shape.wide, theme);
            });
        });
    }

    /// The library: beside the page where there is room, else over it.
    pub(super) fn drawer(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) {
        let may_stay = shape.wide && !shape.present && self.lesson.is_none();
        let pinned = self.preferences.pinned && may_stay;
        if !self.drawer.open && !pinned {
            return;
        }
        let mut commands = Vec::new();
        let escapes = ui.input(|i| i.key_pressed(Key::Escape)) && !self.menu_open;
        let mut closes = escapes && !self.library.escaped();
        let compares = self.drawer.compares;
        let (library, app, preferences) = (&mut self.library, &self.app, &mut self.preferences);
        let mut show = |ui: &mut Ui| {
            library.show(ui, app, preferences, (theme, compares), &mut commands);
        };
        if shape.wide {
            let frame = plain(ui, Margin::same(12));
            let panel = fixed(Panel::left("library"), frame, DRAWER);
            panel.show(ui, |ui| in_its_size(ui, &mut show));
        } else {
            let room = ui.available_rect_before_wrap();
            let width = DRAWER.min(room.width() - 8.0);
            let rect = Rect::from_min_size(room.min, vec2(width, room.height()));
            egui::Area::new(egui::Id::unique("library over the page"))
                .fixed_pos(rect.min)
                .order(egui::Order::Foreground)
                .show(ui.ctx(), |ui| {
                    let frame = plain(ui, Margin::same(12));
                    frame.stroke(ui.visuals().window_stroke).show(ui, |ui| {
                        let size = rect.size() - vec2(24.0, 24.0);
                        ui.set_min_size(size);
                        ui.set_max_size(size);
                        show(ui);
                    });
                });
            // What was chosen is to be seen.
            closes |= !commands.is_empty() && !compares;
        }
        // A second light is chosen once; of surfaces many may be compared.
        let is_second = |command: &Command| matches!(command, Command::Compare(_));
        closes |= compares && commands.iter().any(is_second);
        if closes || std::mem::take(&mut self.library.closes) {
            self.drawer = Drawer::default();
            self.preferences.pinned &= closes;
        }
        self.keep_surface(&mut commands);
        self.apply(&mut commands);
    }

    /// The page in force, scrolled where the window is too low for it. Gives where it is seen.
    pub(super) fn page_panel(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) -> Rect {
        let room = ui.available_rect_before_wrap();
        if shape.present && self.preferences.page != Page::Spectrum {
            return self.whole_page(ui, shape, theme);
        }
        let folded = !shape.wide && !self.side_is_open(shape);
        let beside = folded && self.tells_verdict() || self.pair().is_some();
        let with_verdict = self.preferences.page == Page::Spectrum && beside;
        let inner = room.width() - 2.0 * f32::from(PAGE_MARGIN.left);
        let above = look_view::stacked(vec2(inner, room.height()), with_verdict, theme.scale);
        // Large type at the axes and the knobs takes the plot's room.
        let least = LEAST_PAGE + above + 120.0 * (theme.scale - 1.0);
        if room.height() >= least {
            return self.whole_page(ui, shape, theme);
        }
        let mut centre = room;
        egui::CentralPanel::no_frame().show(ui, |ui| {
            rolled(ui, |ui| {
                let size = vec2(ui.available_width(), least);
                let whole = Rect::from_min_size(ui.cursor().min, size);
                let mut child = ui.new_child(UiBuilder::new().max_rect(whole));
                centre = self.whole_page(&mut child, shape, theme).intersect(room);
                ui.advance_cursor_after_rect(whole);
            });
        });
        centre
    }

    fn whole_page(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) -> Rect {
        let frame = plain(ui, PAGE_MARGIN);
        let mut centre = ui.max_rect();
        egui::CentralPanel::default().frame(frame).show(ui, |ui| {
            centre = ui.max_rect();
            let tells = self.tells_verdict();
            if !shape.present {
                let page = &mut self.preferences.page;
                // In a lesson it could be the answer.
                let is_free = self.lesson.is_none() && self.side_open != Some(true);
                let has_line = tells && page.has_model_line() && is_free;
                let mut opens = false;
                if page.place().tabs().count() > 1 || has_line {
                    let beside = has_line && ui.available_width() >= LINE_BESIDE;
                    pages::tabs(ui, page, |ui| {
                        if beside {
                            opens = verdict_view::line(ui, &self.app);
                        }
                    });
                    if has_line && !beside {
                        opens = verdict_view::line(ui, &self.app);
                    }
                    ui.add_space(6.0);
                }
                if opens {
                    self.side_open = Some(true);
                }
            }
            if self.lesson.as_ref().is_some_and(Run::is_veiled) {
                lesson_view::veil(ui);
                return;
            }
            match (self.preferences.page, shape.present) {
                (Page::Spectrum, _) => self.look(ui, shape, theme),
                (_, false) => self.page(ui, theme, |pages, ui, shown| pages.show(ui, shown)),
                (_, true) => self.presented(ui, theme),
            }
        });
        centre
    }

    /// Back from presenting to the whole window.
    pub(super) fn leave(&mut self) {
        self.preferences.present = false;
    }

    /// The first screen.
    fn look(&mut self, ui: &mut Ui, shape: Shape, theme: Theme) {
        let context = ui.ctx().clone();
        let folded = !shape.wide && !self.side_is_open(shape);
        let pair = self.pair();
        let verdict_below = (folded || shape.present) && self.tells_verdict() || pair.is_some();
        let wake = theme::waker(&context);
        let mut kept = self.app.document().pages.clone();
        let mut scene = Scene {
            app: &self.app,
            studies: &mut self.studies,
            pages: &mut kept,
            page: &mut self.preferences.page,
            theme,
            wake: &wake,
            verdict_below,
            pair,
            present: shape.present,
            in_lesson: self.lesson.is_some(),
        };
        let wishes = self.look.show(ui, &mut scene);
        let mut commands = wishes.commands;
        let before = self.app.revision();
        self.keep_pages(kept, &mut commands, &context);
        for act in wishes.acts {
            self.app.act_on_spikes(act);
        }
        if self.app.revision() != before {
            // Plot and verdict were drawn before.
            context.request_discard("the model changed");
        }
        if wishes.gesture_ended {
            self.app.end_gesture();
        }
        if let Some((tone, words)) = wishes.said {
            self.app.say(tone, words);
        }
        if wishes.opens_settings {
            let is_open = self.side_is_open(shape);
            self.side = match is_open && self.side == Side::Settings {
                true => Side::Verdict,
                false => Side::Settings,
            };
            if !is_open {
                self.side_open = Some(true);
            }
            context.request_repaint();
        }
        if let Some(chart) = wishes.chart {
            self.save_chart(chart, &context);
        }
        if wishes.leaves {
            self.leave();
        }
    }

    /// The colour of a swatch, as its menu asked for.
    pub(super) fn take_colour(&mut self, context: &Context) {
        if let Some(rgb) = super::super::swatch::asked_for(context) {
            self.app.edit_pages(|pages| {
                pages.from_colour = pages.from_colour.clone().about(rgb);
            });
            self.preferences.page = Page::FromColour;
            context.request_repaint();
        }
    }

    /// The palette over everything.
    pub(super) fn palette(&mut self, context: &Context) {
        match self.palette.show(context, &self.app) {
            None => {}
            Some(Chosen::Entry(entry)) => {
                let mut commands = vec![Command::Show(entry)];
                self.keep_surface(&mut commands);
                self.apply(&mut commands);
                self.app.end_gesture();
            }
            Some(Chosen::Page(page)) => self.preferences.page = page,
            Some(Chosen::Act(act)) => self.act(act, context),
        }
    }

    /// The ways to begin.
    pub(super) fn greeting(&mut self, context: &Context, theme: Theme) {
        if !self.greets {
            return;
        }
        let (chosen, leaves) = greeting_view::show(context, theme);
        if leaves {
            self.greets = false;
            self.preferences.greeted = true;
        }
        match chosen {
            None => {}
            Some(Beginning::Page(page)) => self.preferences.page = page,
            Some(Beginning::Own) => self.act(Act::Open, context),
            Some(Beginning::Live) => {
                self.preferences.page = Page::Spectrum;
                if let Some(lamp) = self.app.entry(LIVE) {
                    self.app.apply(Command::Show(lamp));
                    self.app.end_gesture();
                }
            }
        }
        if chosen.is_some() {
            // The page was drawn before.
            context.request_repaint();
        }
    }

    /// Shows the ways to begin to who was never here.
    pub fn greet(&mut self) {
        self.greets = !self.preferences.greeted;
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
