//! Look, the first screen: the spectrum with its model, the two knobs, and surfaces under both.

mod sliders;
mod title;

use std::borrow::Cow;

use eframe::egui;
use egui::{Rect, Ui, UiBuilder, Vec2, vec2};

pub use sliders::names;
use sliders::{Asked, SlidersView};
pub use title::ADD_LINE;

use super::{
    brief_view,
    chart_view::ChartWish,
    kit::bounded,
    patches_view,
    spectrum_view::SpectrumView,
    theme::{Theme, Wake},
};
use crate::{
    app::{
        App, Command, Document, Memo, NoiseBegins, Pair, SpikeAct, Tone,
        answers::{LINE_THRESHOLDS, best_of, knobs_of},
        lamps_asked, lamps_better, last_order_in,
        pages::{Page, PageStates},
        studies::{About, Stage, Studies, SweepAsk},
    },
    languages::said,
    spectrum::Basis,
};

#[derive(Default)]
pub struct LookView {
    /// The plot and what is being dragged in it.
    pub spectrum: SpectrumView,
    sliders: SlidersView,
    /// What Automatic was asked about, and for how many numbers, and has not answered yet.
    waiting: Option<(About, usize)>,
    /// Where the noise of the light begins, by the program's revision.
    noise: Memo<u64, NoiseBegins>,
}

/// What the page sees.
pub struct Scene<'a> {
    /// The program.
    pub app: &'a App,
    /// The long computations.
    pub studies: &'a mut Studies,
    /// What the pages keep: a copy, which becomes the document's after the frame.
    pub pages: &'a mut PageStates,
    /// The page shown.
    pub page: &'a mut Page,
    /// The looks.
    pub theme: Theme,
    /// Wakes the window when a computation is done.
    pub wake: &'a Wake,
    /// Whether swatch and verdict, or the pair, stand beside the patches, not in a column of their
    /// own.
    pub verdict_below: bool,
    /// Two surfaces that are compared: they stand in the verdict's place.
    pub pair: Option<Pair>,
    /// The plot, swatch, patches and the two knobs alone.
    pub present: bool,
    /// A lesson is being taken: no hints, no buttons beside the knobs, and no knobs where it shows
    /// no model.
    pub in_lesson: bool,
}

impl Scene<'_> {
    /// Whether the knobs of the model are there.
    fn has_knobs(&self) -> bool {
        !self.in_lesson || self.app.document().view.model
    }
}

/// What one frame asked for.
#[derive(Default)]
pub struct Wishes {
    /// Changes of the document.
    pub commands: Vec<Command>,
    /// Acts on the spikes.
    pub acts: Vec<SpikeAct>,
    /// The pointer was let go after a drag.
    pub gesture_ended: bool,
    pub said: Option<(Tone, String)>,
    /// Back to the whole window.
    pub leaves: bool,
    /// Every knob is to be shown.
    pub opens_settings: bool,
    /// A chart to save, copy or print.
    pub chart: Option<ChartWish>,
}

/// Height of the patches, points: least and largest.
const PATCHES: [f32; 2] = [108.0, 220.0];
/// Margin of the card around what is in it, points.
const CARD_MARGIN: Vec2 = vec2(16.0, 8.0);
/// Room beside the patches for swatch and verdict, points.
const VERDICT: f32 = 304.0;
/// Below this width they stand over the patches, this high.
const STACKED: f32 = 560.0;
const BRIEF: f32 = 112.0;
/// Where a page is lower than this in a type of usual size the plot needs the room: where a line of
/// them is not cut they take one, and the patches least.
const LOW: f32 = 640.0;
const WHOLE_LINE: f32 = 460.0;
const USUAL_TYPE: f32 = 1.2;
const BRIEF_LINE: f32 = 44.0;
const GAP: f32 = 8.0;

/// Height that swatch and verdict take over the patches; nothing where they stand beside them.
pub fn stacked(room: Vec2, with_verdict: bool, scale: f32) -> f32 {
    let is_stacked = with_verdict && room.x < STACKED * scale.min(1.6);
    match (is_stacked, is_low(room, scale)) {
        (true, true) => BRIEF_LINE * scale + GAP,
        (true, false) => BRIEF * scale + GAP,
        (false, _) => 0.0,
    }
}

fn is_low(room: Vec2, scale: f32) -> bool {
    scale < USUAL_TYPE && room.y < LOW && room.x >= WHOLE_LINE
}

/// Height of the two knobs alone in a width, points.
pub fn knobs_height(width: f32, theme: Theme) -> f32 {
    sliders::height(width - 2.0 * CARD_MARGIN.x, theme.scale, false) + 2.0 * CARD_MARGIN.y
}

impl LookView {
    /// Draws the two knobs alone, where another page is presented.
    pub fn knobs(&mut self, ui: &mut Ui, app: &App, theme: Theme, commands: &mut Vec<Command>) {
        let size = vec2(
            ui.available_width(),
            knobs_height(ui.available_width(), theme),
        );
        let room = Rect::from_min_size(ui.cursor().min, size);
        let mut inside = ui.new_child(UiBuilder::new().max_rect(room.shrink2(CARD_MARGIN)));
        let mut unused = 0;
        let budget = (&mut unused, false);
        let noise = self.noise_of(app);
        let sliders = &mut self.sliders;
        sliders.show(&mut inside, app, (budget, false, noise), theme, commands);
        ui.advance_cursor_after_rect(room);
    }

    /// Draws the page into all the room there is.
    pub fn show(&mut self, ui: &mut Ui, scene: &mut Scene<'_>) -> Wishes {
        let mut wishes = Wishes::default();
        let (app, theme) = (scene.app, scene.theme);
        let room = ui.available_rect_before_wrap();
        let [mut plot, card, patches] = parts(room, scene);
        let beside = verdict_beside(plot, scene);
        if let Some(verdict) = beside {
            plot.max.x = verdict.left() - 2.0 * GAP;
        }
        let mut child = |rect: Rect| {
            // A window may be lower than what stands in it.
            let rect = Rect::from_min_max(rect.min, rect.max.max(rect.min));
            let mut child = ui.new_child(UiBuilder::new().max_rect(rect));
            child.shrink_clip_rect(rect.expand(3.0));
            child
        };
        if scene.has_knobs() {
            self.card(&mut child(card), scene, &mut wishes);
        }
        if let Some(verdict) = beside {
            brief_view::presented(&mut child(verdict), app, theme);
        }
        let told = beside.is_none() && scene.verdict_below;
        below(
            &mut child(patches),
            scene,
            (room.size(), told),
            &mut wishes.commands,
        );
        let ui = &mut child(plot);
        title::show(ui, app, theme, scene.present.then_some(&mut wishes.leaves));
        let mut view = app.document().view;
        let before = view;
        if !scene.has_knobs() {
            title::compared(ui, app, theme);
        } else if !scene.present {
            let adds_line = &mut self.spectrum.adds_line;
            title::layers(ui, app, theme, (&mut view, adds_line), &mut wishes.commands);
        }
        if view != before {
            wishes.commands.push(Command::View(view));
        }
        ui.add_space(4.0);
        let drawn = self.spectrum.show(ui, app, theme);
        wishes.chart = drawn.chart;
        wishes.commands.extend(drawn.commands);
        wishes.acts.extend(drawn.acts);
        wishes.gesture_ended |= drawn.gesture_ended;
        self.settle(scene, &mut wishes);
        wishes
    }

    fn noise_of(&mut self, app: &App) -> NoiseBegins {
        let [lowest, _] = LINE_THRESHOLDS;
        let of = |_: &u64| NoiseBegins::of(app.document(), lowest);
        *self.noise.get(app.revision(), of)
    }

    fn card(&mut self, ui: &mut Ui, scene: &mut Scene<'_>, wishes: &mut Wishes) {
        let busy = self.waiting.is_some();
        let (app, theme) = (scene.app, scene.theme);
        let rect = ui.max_rect();
        let outline = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter()
            .rect_stroke(rect, 4.0, outline, egui::StrokeKind::Inside);
        let inner = rect.shrink2(CARD_MARGIN);
        let mut inside = ui.new_child(UiBuilder::new().max_rect(inner));
        let budget = (&mut scene.pages.look.numbers, busy);
        let commands = &mut wishes.commands;
        let bare = scene.in_lesson;
        let noise = self.noise_of(app);
        let sliders = &mut self.sliders;
        let asked = sliders.show(&mut inside, app, (budget, bare, noise), theme, commands);
        let Asked {
            automatic,
            reset,
            more,
        } = asked;
        wishes.opens_settings = more;
        if automatic {
            scene.studies.of::<SweepAsk>().retry();
            let about = About::of(&without_noise(app, noise));
            self.waiting = Some((about, scene.pages.look.numbers));
        }
        if reset {
            wishes.commands.push(Command::Reset);
        }
    }

    /// Carries out what Automatic was asked for, once the sweep is there.
    fn settle(&mut self, scene: &mut Scene<'_>, wishes: &mut Wishes) {
        let noise = self.noise_of(scene.app);
        if let Some((about, most)) = &self.waiting
            && let Some(said) = automatic(scene, (about, *most, noise), &mut wishes.commands)
        {
            self.waiting = None;
            wishes.said = Some(said);
        }
    }
}

/// What Automatic takes of a sweep about a spectrum, with at most so many numbers, and what is to
/// be said of it; `None` while something is still computed.
fn automatic(
    scene: &mut Scene<'_>,
    (about, most, noise): (&About, usize, NoiseBegins),
    commands: &mut Vec<Command>,
) -> Option<(Tone, String)> {
    let told = |words: String| Some((Tone::Info, words));
    let document = &*without_noise(scene.app, noise);
    let ask = SweepAsk::of(document);
    if *about != ask.about {
        return told(said!("Automatic gave up: another spectrum is shown.").to_owned());
    }
    let job = scene.studies.job();
    job.put(&ask, scene.wake);
    let Some(sweep) = job.result_for(&ask).cloned() else {
        let is_open = matches!(job.stage(), Stage::Idle | Stage::Running(_) | Stage::Done);
        let words = said!("There is nothing to measure on this spectrum and range.");
        return (!is_open).then(|| (Tone::Problem, words.to_owned()));
    };
    let orders = Basis::ALL.map(|basis| (basis, last_order_in(document, basis)));
    let last_order = |basis: Basis| orders.iter().find(|of| of.0 == basis)?.1;
    let Some((point, measure)) = best_of(&sweep, most, last_order) else {
        return told(tr!(
            "No model takes as few as {n} number." | "No model takes as few as {n} numbers." % most
        ));
    };
    let lamps = lamps_asked(document, scene.pages.known_lamps, most);
    let mut better = None;
    if let Some(lamps) = &lamps {
        let job = scene.studies.job();
        job.put(lamps, scene.wake);
        if matches!(job.stage(), Stage::Running(_)) {
            return None;
        }
        let found = job.result_for(lamps).map(|found| &**found);
        let found = found.and_then(|found| found.as_ref().ok());
        better = found.and_then(|found| lamps_better(about, found, (point, measure)));
    }
    let best = knobs_of(document.settings, point);
    commands.push(Command::Edit(best));
    if let Some(words) = better {
        *scene.page = Page::KnownLamps;
        let known = &mut scene.pages.known_lamps;
        known.portable = false;
        known.numbers = lamps.map_or(most, |lamps| lamps.numbers);
        return told(words);
    }
    let lines = match best.spikes {
        true => said!("with its lines"),
        false => said!("without lines"),
    };
    let exact = best.colour_exact.then_some(said!("colour-exact"));
    let waves = tr!("{n} waves" | "{n} waves" % best.order);
    let model = [
        Some(said(best.basis.word())),
        exact,
        Some(waves.as_str()),
        Some(lines),
    ];
    let model: Vec<&str> = model.into_iter().flatten().collect();
    let best_of_all = tr!(
        "The best of all ways with at most {n} number: {model}."
            | "The best of all ways with at most {n} numbers: {model}." % most,
        model = model.join(", ")
    );
    told(match last_order(best.basis) == Some(best.order) {
        true => [
            best_of_all.as_str(),
            said!("More waves would draw the noise."),
        ]
        .join(" "),
        false => best_of_all,
    })
}

/// The document with a threshold that keeps the lines of the noise out.
fn without_noise(app: &App, noise: NoiseBegins) -> Cow<'_, Document> {
    let document = app.document();
    let settings = noise.without_its_lines(document.settings);
    match settings == document.settings {
        true => Cow::Borrowed(document),
        false => Cow::Owned(Document {
            settings,
            ..document.clone()
        }),
    }
}

/// Where plot, knobs and patches stand.
fn parts(room: Rect, scene: &Scene<'_>) -> [Rect; 3] {
    let scale = scene.theme.scale;
    let inner = room.width() - 2.0 * CARD_MARGIN.x;
    let card = match scene.has_knobs() {
        true => sliders::height(inner, scale, scene.in_lesson) + 2.0 * CARD_MARGIN.y,
        false => -GAP,
    };
    let [least, most] = PATCHES;
    let stacked = stacked(room.size(), scene.verdict_below, scale);
    let share = if stacked > 0.0 && is_low(room.size(), scale) {
        0.0
    } else {
        0.23
    };
    let patches = bounded(share * room.height(), least, most * scale) + stacked;
    let at = |top: f32, height: f32| {
        Rect::from_min_size(egui::pos2(room.left(), top), vec2(room.width(), height))
    };
    let patches_top = room.bottom() - patches;
    let card_top = patches_top - GAP - card;
    [
        at(room.top(), card_top - GAP - room.top()),
        at(card_top, card),
        at(patches_top, patches),
    ]
}

/// Least size of a plot that is presented with the verdict beside it, and the verdict's width.
const PRESENTED: Vec2 = vec2(900.0, 390.0);
const VERDICT_PRESENTED: f32 = 376.0;

/// Where the verdict stands beside the plot, while presenting.
fn verdict_beside(plot: Rect, scene: &Scene<'_>) -> Option<Rect> {
    let tells = scene.present && scene.verdict_below && scene.pair.is_none();
    let has_room = plot.width() >= PRESENTED.x && plot.height() >= PRESENTED.y;
    (tells && has_room).then(|| plot.with_min_x(plot.right() - VERDICT_PRESENTED))
}

/// The patches, and where the column is folded the verdict beside them.
fn below(
    ui: &mut Ui,
    scene: &Scene<'_>,
    (room, beside): (Vec2, bool),
    commands: &mut Vec<Command>,
) {
    let (app, theme) = (scene.app, scene.theme);
    let rect = ui.max_rect();
    let (mut field, mut brief) = (rect, rect);
    let above = stacked(room, beside, theme.scale);
    if above > 0.0 {
        brief.max.y = rect.top() + above - GAP;
        field.min.y = rect.top() + above;
    } else if beside {
        let width = (VERDICT * theme.scale).min(0.45 * rect.width());
        field.max.x -= width + 16.0;
        brief.min.x = field.right() + 16.0;
    }
    if beside {
        let mut verdict = ui.new_child(UiBuilder::new().max_rect(brief));
        verdict.shrink_clip_rect(brief);
        match &scene.pair {
            Some(pair) => brief_view::pair(&mut verdict, pair, theme),
            None => brief_view::brief(&mut verdict, app, theme),
        }
    }
    let mut patches = ui.new_child(UiBuilder::new().max_rect(field));
    let looks = (theme, !scene.has_knobs());
    if !scene.present {
        patches.horizontal(|ui| patches_view::head(ui, app, looks, commands));
    }
    patches_view::patches(&mut patches, app, looks, commands);
}
