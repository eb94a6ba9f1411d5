//! The stream over time: a quantity as a curve, and the waterfall beside it.

use eframe::egui;
use egui::{Align2, Color32, FontId, Rect, Sense, TextureHandle, TextureOptions, Ui, pos2, vec2};

use super::names;
use crate::{
    app::{
        chart::{Chart, Ink},
        charts::live::{TRACKS, WATERFALL_NM, ends_ms, over_time, track_words, waterfall},
        following::{Following, jump_words},
    },
    languages::{Language, said, spoken},
    live::{Jump, Track, clock},
    spectrum::Sampled,
    ui::{
        kit::{drawing, pressed_small, segments, two_columns},
        pages::{PageContext, PageWish},
        swatch,
        theme::Theme,
    },
};

/// Between two drawings, s: an hour has 36,000 frames.
const EVERY: f64 = 1.0;

/// Pixels of the waterfall.
const PIXELS: [usize; 2] = [401, 240];

/// Jumps that are told in words.
const MOST_JUMPS: usize = 3;

const JUMPS_MEAN: &str = later!(
    "Where the five spectra behind a moment differ from the five before it beyond their noise and \
     one slope, all moments and quantities tested together at 5 %: shares of the lines and of the \
     glow, its shape, and the level."
);

/// Wavelengths below the waterfall, nm.
const TICKS: [f64; 4] = [400.0, 500.0, 600.0, 700.0];

/// Room for times beside the waterfall, and for wavelengths below, points.
const TIMES: f32 = 66.0;
const BELOW: f32 = 18.0;

/// Height of the row above both with the space around it, points.
pub(super) const HEAD: f32 = 44.0;

/// Width from which both stand side by side, points.
const WIDE: f32 = 620.0;

#[derive(Default)]
pub(super) struct OverTime {
    drawn: Option<Drawn>,
}

/// What it is drawn of.
#[derive(Clone, Copy, PartialEq)]
struct Of {
    count: u64,
    track: Track,
    held_ms: Option<f64>,
    language: Language,
}

struct Drawn {
    at: f64,
    of: Of,
    chart: Chart,
    waterfall: Option<TextureHandle>,
    ends_ms: [f64; 2],
    /// The newest jumps in words.
    jumps: String,
}

/// Least height of the pictures, points.
const LEAST: f32 = 80.0;

impl OverTime {
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        following: &Following,
        high: f32,
    ) {
        ui.horizontal_wrapped(|ui| {
            ui.label(egui::RichText::new(said!("Over time")).strong());
            segments(ui, &mut context.pages.live.track, TRACKS, track_words);
            if pressed_small(
                ui,
                said(names::SAVE),
                said!("Saves Y, CCT, glow and lines of every spectrum."),
            ) {
                let (stem, csv) = {
                    let stream = following.stream();
                    (stream.name.clone(), stream.tracks.csv())
                };
                let stem = stem.replace(|c: char| !c.is_alphanumeric(), "-");
                context.wishes.push(PageWish::Tracks { stem, csv });
            }
        });
        ui.add_space(4.0);
        self.draw_anew(ui, context.pages.live.track, following);
        let Some(drawn) = &self.drawn else { return };
        let top = ui.cursor().top();
        if !drawn.jumps.is_empty() {
            ui.add(egui::Label::new(&drawn.jumps).wrap())
                .on_hover_text(said(JUMPS_MEAN));
            ui.add_space(4.0);
        }
        // The sentence takes its room from the pictures.
        let high = (high - (ui.cursor().top() - top)).max(LEAST);
        let course = |ui: &mut Ui, context: &mut PageContext<'_>| {
            let size = vec2(ui.available_width(), high);
            context.chart(ui, &drawn.chart, "over time", size);
        };
        let fall = |ui: &mut Ui, context: &mut PageContext<'_>| {
            paint(ui, context.theme, drawn, high);
        };
        match ui.available_width() >= WIDE * context.theme.scale {
            true => two_columns(ui, context, course, fall),
            false => {
                course(ui, context);
                ui.add_space(6.0);
                fall(ui, context);
            }
        }
    }

    /// Draws it again where it is older than a moment.
    fn draw_anew(&mut self, ui: &Ui, track: Track, following: &Following) {
        let now = ui.input(|i| i.time);
        let of = Of {
            count: following.seen().count,
            track,
            held_ms: following.seen().held_ms,
            language: spoken(),
        };
        if let Some(drawn) = &self.drawn {
            if drawn.of == of {
                return;
            }
            let count = drawn.of.count;
            let is_other = drawn.of != Of { count, ..of };
            if !is_other && (0.0..EVERY).contains(&(now - drawn.at)) {
                let wait = std::time::Duration::from_secs_f64(EVERY);
                return ui.ctx().request_repaint_after(wait);
            }
        }
        let (chart, pixels, ends_ms, jumps) = {
            let tracks = &following.stream().tracks;
            let jumps = tracks.jumps();
            (
                over_time(tracks, track, &jumps, of.held_ms),
                waterfall(tracks, PIXELS),
                ends_ms(tracks),
                jumps,
            )
        };
        let shown = following.seen().shown.as_ref();
        let light = shown.map(|shown| &shown.of.samples);
        let waterfall = (!pixels.is_empty()).then(|| {
            let image = swatch::image(PIXELS, &pixels);
            ui.ctx()
                .load_texture("waterfall", image, TextureOptions::LINEAR)
        });
        self.drawn = Some(Drawn {
            at: now,
            of,
            chart,
            waterfall,
            ends_ms,
            jumps: newest_jumps(&jumps, light),
        });
    }
}

/// The newest jumps in a sentence, nothing where there is none.
fn newest_jumps(jumps: &[Jump], light: Option<&Sampled>) -> String {
    let newest = jumps.iter().rev().take(MOST_JUMPS);
    let words: Vec<String> = newest.map(|jump| jump_words(jump, light)).collect();
    match jumps.len() {
        0 => String::new(),
        count if count > MOST_JUMPS => tr!(
            "{count} jumps, the newest at {jumps}.",
            count,
            jumps = words.join("; ")
        ),
        _ => tr!("Jumps at {jumps}.", jumps = words.join("; ")),
    }
}

/// The waterfall with its times at the left and wavelengths below.
fn paint(ui: &mut Ui, theme: Theme, drawn: &Drawn, high: f32) {
    let [first, last] = drawn.ends_ms.map(clock);
    let name = tr!(
        "Waterfall: wavelengths from left to right, {first} above, {last} below",
        first,
        last
    );
    let size = vec2(ui.available_width(), high);
    let (rect, response) = drawing(ui, size, Sense::hover(), &name);
    let corner = rect.min + vec2(TIMES * theme.scale, 4.0);
    let picture = Rect::from_min_max(corner, rect.max - vec2(8.0, BELOW * theme.scale));
    let painter = ui.painter();
    let ink = ui.visuals().text_color();
    let font = FontId::proportional(11.0 * theme.scale);
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    match &drawn.waterfall {
        Some(texture) => drop(painter.image(texture.id(), picture, whole, egui::Color32::WHITE)),
        None => {
            painter.rect_filled(picture, 0.0, egui::Color32::BLACK);
            let words = said!("There was no light yet.").to_owned();
            let font = FontId::proportional(12.0 * theme.scale);
            let ink = egui::Color32::from_gray(180);
            painter.text(picture.center(), Align2::CENTER_CENTER, words, font, ink);
        }
    }
    for (words, y, align) in [
        (first, picture.top(), Align2::RIGHT_TOP),
        (last, picture.bottom(), Align2::RIGHT_BOTTOM),
    ] {
        let at = pos2(picture.left() - 6.0, y);
        painter.text(at, align, words, font.clone(), ink);
    }
    if let Some(held_ms) = drawn.of.held_ms {
        let colour = theme.ink(Ink::Second);
        held(ui, drawn, held_ms, picture, (font.clone(), colour));
    }
    let [from, to] = WATERFALL_NM;
    for nm in TICKS {
        let share = ((nm - from) / (to - from)) as f32;
        let at = pos2(
            picture.left() + share * picture.width(),
            picture.bottom() + 3.0,
        );
        painter.text(
            at,
            Align2::CENTER_TOP,
            format!("{nm} nm"),
            font.clone(),
            ink,
        );
    }
    response.on_hover_text(said!(
        "Every row is a moment, the first above; as bright as the light was at each wavelength."
    ));
}

/// A mark over the waterfall at the moment that is held.
fn held(ui: &Ui, drawn: &Drawn, held_ms: f64, picture: Rect, (font, colour): (FontId, Color32)) {
    let [first, last] = drawn.ends_ms;
    if !(first..=last).contains(&held_ms) || first == last {
        return;
    }
    let y = picture.top() + ((held_ms - first) / (last - first)) as f32 * picture.height();
    let painter = ui.painter();
    painter.hline(picture.x_range(), y, (1.6, colour));
    // Not over the times at both ends.
    let room = 2.0 * font.size;
    if (picture.top() + room..picture.bottom() - room).contains(&y) {
        let at = pos2(picture.left() - 6.0, y);
        painter.text(at, Align2::RIGHT_CENTER, said!("held"), font, colour);
    }
}
