//! The page "Live": a light that changes, its figures, what was captured of it, and its course.

mod begin;
mod captures;
mod over_time;

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use eframe::egui;
use egui::{Button, RichText, Ui, vec2};

use super::{PageContext, PageWish};
use crate::{
    app::{
        ByAddress, Memo,
        chart::Chart,
        charts::live::newest,
        following::{Following, Seen, Standing},
        live_figures::{Told, Wanted, figures},
    },
    io::many::capitalised,
    languages::{said, with_colon},
    live::{Reference, Shown},
    measurements::{Measurement, Quantity},
    streams::Pace,
    ui::{
        kit::{GROUP, down, headline, knob, named, number, pressed, pressed_if, scrolled, warning},
        theme::Theme,
    },
};

/// What a path that is chosen is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToFollow {
    File,
    Folder,
    Recording(Pace),
    Instrument,
}

/// What buttons and fields are called.
pub mod names {
    pub const HOLD: &str = later!("Hold");
    pub const GO_ON: &str = later!("Go on");
    pub const HOLD_MEANS: &str = later!("Keeps what is shown, or goes on with the newest (Space).");
    pub const CAPTURE: &str = later!("Capture");
    pub const CAPTURE_MEANS: &str =
        later!("Keeps what is shown in My files, with its time (Enter).");
    pub const DARK: &str = later!("Dark");
    pub const REFERENCE: &str = later!("Reference");
    pub const PEAK: &str = later!("Peaks");
    pub const AS_LIGHT: &str = later!("Counts as a light");
    pub const FIGURES: &str = later!("Figures…");
    pub const STOP: &str = later!("Stop");
    pub const STOP_MEANS: &str =
        later!("Follows it no longer; the last spectrum and all captures stay.");
    pub const SHOW: &str = later!("Show it on every page");
    pub const PATH: &str = later!("File or folder that changes");
    pub const FOLLOW: &str = later!("Follow");
    pub const FILE: &str = later!("Choose a file…");
    pub const FOLDER: &str = later!("Choose a folder…");
    pub const RECORDING: &str = later!("Play a recording…");
    pub const SPEED: &str = later!("Speed");
    pub const PORT: &str = later!("Port");
    pub const LISTEN: &str = later!("Listen");
    pub const SERIAL: &str = later!("Serial port");
    pub const BAUD: &str = later!("Bits a second");
    pub const INSTRUMENT: &str = later!("Instrument…");
    pub const SAVE: &str = later!("Save as CSV…");
}

/// Figures that may be shown.
const OFFERED: [&str; 12] = [
    "cct",
    "duv",
    "Y",
    "x",
    "y",
    "ra",
    "r9",
    "rf",
    "rg",
    "ler",
    "melanopic_der",
    "peak_nm",
];

/// Width from which figures stand beside the spectrum, and theirs, points.
const WIDE: f32 = 640.0;
const FIGURES: f32 = 168.0;

/// Parts of the height that is left for the spectrum and for what is over time, and their least,
/// points.
const SPECTRUM: (f32, f32) = (0.56, 180.0);
const COURSE: (f32, f32) = (0.44, 150.0);
/// They grow with the type up to this scale.
const MOST_SCALE: f32 = 1.2;

/// The page and what it keeps from frame to frame.
#[derive(Default)]
pub struct LiveView {
    begin: begin::Begin,
    course: over_time::OverTime,
    /// Kept until another spectrum is shown, which most frames of the window do not bring.
    chart: Memo<ChartOf, Chart>,
    told: Memo<ToldOf, Vec<Told>>,
}

/// What figures are told of: a spectrum, and which ones.
type ToldOf = (Option<ByAddress<Shown>>, Vec<String>);

/// What the spectrum's chart is made of.
#[derive(Clone, PartialEq)]
struct ChartOf {
    shown: ByAddress<Shown>,
    peak: Option<ByAddress<Measurement>>,
    is_held: bool,
}

impl LiveView {
    /// The instrument that lights are followed through from now on.
    pub fn take_instrument(&mut self, path: &Path) {
        self.begin.instrument = path.display().to_string();
    }

    /// The same, where there is one.
    pub fn instrument(&self) -> Option<PathBuf> {
        let path = self.begin.instrument.trim();
        (!path.is_empty()).then(|| PathBuf::from(path))
    }

    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let Some(following) = context.following.take() else {
            return self.begin.show(ui, context);
        };
        let room = ui.available_height();
        scrolled(ui, "live", |ui| {
            let top = ui.cursor().top();
            let seen = following.seen();
            let told = self.told(context, seen);
            headline(ui, context.theme, sentence(seen, &told));
            standing(ui, context.theme, seen);
            ui.add_space(8.0);
            controls(ui, context, &following);
            ui.add_space(8.0);
            let Some(shown) = &seen.shown else {
                if following.takes_lines && seen.standing == Standing::Waiting {
                    ui.add_space(GROUP);
                    begin::lines(ui, context.theme);
                }
                return;
            };
            let used = ui.cursor().top() - top + captures::height(context);
            let has_course = !following.stream().tracks.is_empty();
            let [high, of_course] = heights(room - used, context.theme.scale, has_course);
            self.spectrum(ui, context, (seen, shown), &told, high);
            captures::show(ui, context);
            ui.add_space(GROUP);
            match has_course {
                true => self.course.show(ui, context, &following, of_course),
                false => {
                    let words =
                        said!("Over time: a course begins with the first spectrum of a light.");
                    let words = RichText::new(words).color(context.theme.faint);
                    ui.add(egui::Label::new(words).wrap());
                }
            }
        });
        *context.following = Some(following);
    }

    /// The figures that are asked for; none of what is no light.
    fn told(&mut self, context: &PageContext<'_>, seen: &Seen) -> Vec<Told> {
        let keys = &context.pages.live.figures;
        let key = (seen.shown.clone().map(ByAddress), keys.clone());
        let make = |(shown, keys): &(Option<ByAddress<Shown>>, Vec<String>)| {
            let wanted = keys.iter().filter_map(|key| Wanted::named(key).ok());
            let wanted: Vec<Wanted> = wanted.collect();
            let shown = shown.as_ref();
            shown.map_or_else(Vec::new, |shown| figures(&shown.0, &wanted))
        };
        self.told.get(key, make).clone()
    }

    /// The spectrum that is shown, its figures beside it where there is room.
    fn spectrum(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (seen, shown): (&Seen, &Arc<Shown>),
        told: &[Told],
        high: f32,
    ) {
        let key = ChartOf {
            shown: ByAddress(shown.clone()),
            peak: seen.peak.clone().map(ByAddress),
            is_held: seen.standing == Standing::Held,
        };
        let make = |of: &ChartOf| {
            let peak = of.peak.as_ref().map(|peak| &*peak.0);
            newest(&of.shown.0, peak, of.is_held)
        };
        let chart = &*self.chart.get(key, make);
        let scale = context.theme.scale;
        let width = ui.available_width();
        if width < WIDE * scale || told.is_empty() {
            context.chart(ui, chart, "live", vec2(width, high));
            return;
        }
        ui.horizontal_top(|ui| {
            let wide = width - FIGURES * scale - 12.0;
            context.chart(ui, chart, "live", vec2(wide, high));
            let size = vec2(FIGURES * scale, high);
            down(ui, size, |ui| beside(ui, context.theme, told));
        });
    }
}

/// Heights of the spectrum and of what is over time, in the room that is left for both. Where it is
/// too low for both the spectrum takes it, and the other is scrolled to whole.
fn heights(left: f32, scale: f32, has_course: bool) -> [f32; 2] {
    let left = left - over_time::HEAD * scale - GROUP;
    // Presented type is twice as large, and the window is not.
    let scale = scale.min(MOST_SCALE);
    let (of_spectrum, of_course) = (SPECTRUM.1 * scale, COURSE.1 * scale);
    match has_course && left >= of_spectrum + of_course {
        true => [SPECTRUM, COURSE].map(|(part, least)| (part * left).max(least * scale)),
        false => [left.max(of_spectrum), of_course.max(0.5 * left)],
    }
}

/// The light's name with its first figures.
fn sentence(seen: &Seen, told: &[Told]) -> String {
    let Some(shown) = &seen.shown else {
        return match seen.name.is_empty() {
            true => said!("Waiting for a light").to_owned(),
            false => tr!("Waiting for a light from {source}", source = seen.name),
        };
    };
    let name = &shown.of.name;
    let first: Vec<String> = told
        .iter()
        .filter(|told| told.value.is_ok())
        .take(3)
        .map(Told::words)
        .collect();
    let name = match seen.standing {
        Standing::Held => tr!("{light}, held", light = name),
        _ => name.clone(),
    };
    match (&first[..], shown.of.quantity) {
        (_, Quantity::Counts) => tr!("{name}: counts, not light", name),
        ([], _) => name,
        (first, _) => with_colon(name, first.join(", ")),
    }
}

/// How the stream stands, in words.
fn standing(ui: &mut Ui, theme: Theme, seen: &Seen) {
    match seen.standing.is_trouble() {
        true => warning(ui, theme, seen.words.clone()),
        false => {
            let words = RichText::new(&seen.words);
            // What goes on though the picture stands still.
            let words = match seen.standing == Standing::Held {
                true => words.strong(),
                false => words.color(theme.faint),
            };
            ui.add(egui::Label::new(words).wrap());
        }
    }
    for words in &seen.warnings {
        warning(ui, theme, words.clone());
    }
}

/// A switch of the stream, once it has a frame; whether it was clicked.
fn switch(ui: &mut Ui, (has_frame, is_on): (bool, bool), name: &str, meaning: &str) -> bool {
    let button = Button::selectable(is_on, name).frame_when_inactive(true);
    pressed_if(ui, has_frame, button, meaning)
}

/// The row of controls.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>, following: &Following) {
    let mut stream = following.stream();
    let has_frame = stream.live.count() > 0;
    let is_held = stream.live.is_held();
    let reference_of = |which: Reference, stream: &mut crate::app::following::Stream| {
        if stream.live.has(which) {
            stream.live.drop(which);
        } else {
            stream.live.take(which);
        }
    };
    ui.horizontal_wrapped(|ui| {
        let hold = if is_held {
            said(names::GO_ON)
        } else {
            said(names::HOLD)
        };
        let hold = Button::selectable(is_held, hold).frame_when_inactive(true);
        if pressed_if(ui, has_frame, hold, said(names::HOLD_MEANS)) {
            context.wishes.push(PageWish::Hold);
        }
        let capture = Button::new(said(names::CAPTURE));
        if pressed_if(ui, has_frame, capture, said(names::CAPTURE_MEANS)) {
            context.wishes.push(PageWish::Capture);
        }
        ui.separator();
        let row = crate::app::pages::LiveMemory::AVERAGE;
        ui.label(row.title()).on_hover_text(row.meaning());
        let field = knob::drag(&row, &mut context.pages.live);
        number(ui, field, row.title()).on_hover_text(row.meaning());
        let (has_dark, has_reference) = (
            stream.live.has(Reference::Dark),
            stream.live.has(Reference::Light),
        );
        let meaning = said!(
            "Takes what is shown now off every spectrum: cover the instrument first. A click more \
             goes on without."
        );
        if switch(ui, (has_frame, has_dark), said(names::DARK), meaning) {
            reference_of(Reference::Dark, &mut stream);
        }
        let meaning = said!(
            "Divides every spectrum by what is shown now: the light without the sample. A click \
             more goes on without."
        );
        let name = said(names::REFERENCE);
        if switch(ui, (has_frame, has_reference), name, meaning) {
            reference_of(Reference::Light, &mut stream);
        }
        let peak = stream.live.holds_peak();
        let meaning = said!("Draws the highest value of every column from now on.");
        if switch(ui, (has_frame, peak), said(names::PEAK), meaning) {
            stream.live.hold_peak(!peak);
        }
        let shown = following.seen().shown.as_deref();
        let is_counted = shown.is_some_and(|shown| shown.counts.is_some());
        if is_counted || context.pages.live.as_light {
            let meaning = said!(
                "Takes counts as a light, as if the instrument answered to all wavelengths alike."
            );
            ui.checkbox(&mut context.pages.live.as_light, said(names::AS_LIGHT))
                .on_hover_text(meaning);
        }
        drop(stream);
        ui.separator();
        figures_menu(ui, context);
        let document = context.app.document();
        let is_shown = following
            .key()
            .is_none_or(|key| document.subject_entry().key == key);
        let entry = following.key().and_then(|key| context.app.entry(key));
        if let Some(entry) = entry.filter(|_| !is_shown) {
            let meaning = said!("Another light is shown on the other pages: shows this one there.");
            if pressed(ui, said(names::SHOW), meaning) {
                context.commands.push(crate::app::Command::Show(entry));
            }
        }
        if pressed(ui, said(names::STOP), said(names::STOP_MEANS)) {
            context.wishes.push(PageWish::FollowNoMore);
        }
    });
}

fn figures_menu(ui: &mut Ui, context: &mut PageContext<'_>) {
    let shown = &mut context.pages.live.figures;
    let menu = ui.menu_button(said(names::FIGURES), |ui| {
        for figure in OFFERED.iter().filter_map(|key| Wanted::named(key).ok()) {
            let figure = figure.figure();
            let mut is_shown = shown.iter().any(|key| key == figure.key);
            let title = if figure.title().is_empty() {
                figure.key
            } else {
                figure.title()
            };
            let item = ui
                .checkbox(&mut is_shown, title)
                .on_hover_text(figure.meaning());
            if item.changed() {
                match is_shown {
                    true => shown.push(figure.key.to_owned()),
                    false => shown.retain(|key| key != figure.key),
                }
            }
        }
    });
    named(&menu.response, egui::Role::Button, said(names::FIGURES));
    menu.response
        .on_hover_text(said!("The figures that are shown."));
}

/// The figures beside the spectrum; where all are missing for one reason, the reason.
fn beside(ui: &mut Ui, theme: Theme, told: &[Told]) {
    let mut whys = told.iter().map(|told| told.value.as_ref().err());
    if let Some(Some(why)) = whys.next()
        && whys.all(|other| other == Some(why))
    {
        ui.add(egui::Label::new(capitalised(why)).wrap());
        return;
    }
    for told in told {
        ui.label(RichText::new(told.name()).color(theme.faint));
        let number = RichText::new(told.number())
            .size(24.0 * theme.scale)
            .strong();
        let number = ui.add(egui::Label::new(number).truncate());
        let why = told.value.as_ref().err();
        number.on_hover_text(why.map_or(told.figure.meaning(), |why| why));
        ui.add_space(4.0);
    }
}
