//! The page "Photograph": a picture of a spectrum, its strip and profile, and whose lines they are.

mod controls;
mod profile;
mod table;

use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{Color32, Pos2, Rect, Sense, Stroke, TextureHandle, TextureOptions, Ui, pos2, vec2};

use super::{PageContext, PageWish, progress};
use crate::{
    app::photograph::{
        Instrument, LampChoice, Photograph, PhotographAsk, Pixels, ResponseAsk, Said,
        SeenPhotograph,
    },
    ui::{
        kit::{self, drawing},
        swatch,
        theme::Theme,
    },
};

/// What people and tests call the controls.
pub mod names {
    pub const OPEN: &str = "Open a photograph…";
    pub const YES: &str = "Yes";
    pub const NO: &str = "No";
    pub const LAMP: &str = "Lamp";
    pub const UNDO: &str = "Undo";
    pub const LIBRARY: &str = "To the library";
    pub const INSTRUMENT: &str = "Use as instrument";
}

/// From this width on pictures and words stand side by side, points.
const WIDE: f32 = 900.0;
/// Width of the words beside the pictures, and height of the straightened strip, points.
const WORDS: f32 = 310.0;
const STRIP: f32 = 26.0;
const GAP: f32 = 6.0;

/// Pictures on the graphics card.
struct Drawn {
    of: Arc<Result<SeenPhotograph, String>>,
    picture: TextureHandle,
    strip: Option<TextureHandle>,
}

/// A hand on the page.
#[derive(Clone, Copy)]
enum Hand {
    /// Draws a band, from here in pixels of the picture.
    Band(Pos2),
    /// Moves the tick of a line, which is at this column now.
    Line(usize, f64),
}

/// An instrument that the next pictures are read with, and the picture that it is from.
struct Bench {
    instrument: Instrument,
    lamp: PhotographAsk,
}

#[derive(Default)]
pub struct PhotographView {
    path: Option<PathBuf>,
    said: Said,
    /// What was said before, the latest last.
    past: Vec<Said>,
    /// The last picture that was read, while the next is.
    seen: Option<Arc<Result<SeenPhotograph, String>>>,
    drawn: Option<Drawn>,
    hand: Option<Hand>,
    bench: Option<Bench>,
    /// The response that is being learnt.
    learning: Option<ResponseAsk>,
    kelvin: f64,
}

impl PhotographView {
    /// The picture that is to be read.
    fn take(&mut self, path: PathBuf) {
        let instrument = self.bench.as_ref().map(|bench| bench.instrument.clone());
        self.said = Said {
            instrument,
            ..Said::default()
        };
        self.path = Some(path);
        (self.past, self.hand) = (Vec::new(), None);
    }

    /// Says something else of the picture; what was said can be had back.
    fn say(&mut self, said: Said) {
        if said != self.said {
            self.past.push(std::mem::replace(&mut self.said, said));
        }
    }

    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        if let Some(path) = context.photograph_asked.take() {
            self.take(path);
        }
        let Some(path) = self.path.clone() else {
            nothing_open(ui, context);
            return;
        };
        let ask = PhotographAsk {
            path,
            said: self.said.clone(),
        };
        let job = context.put(&ask);
        if let Some(found) = job.result_for(&ask) {
            self.seen = Some(found.clone());
        }
        progress(ui, job, "The photograph");
        self.learn(ui, context);
        let Some(held) = self.seen.clone() else {
            return;
        };
        match &*held {
            Ok(seen) => {
                self.load(ui, &held, seen);
                self.parts(ui, context, seen);
            }
            Err(why) => {
                kit::warning(ui, context.theme, why.clone());
                if kit::pressed(ui, names::OPEN, "Opens another picture.") {
                    context.wishes.push(PageWish::OpenPicture);
                }
            }
        }
    }

    /// The words beside the pictures where there is room, else over them.
    fn parts(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, seen: &SeenPhotograph) {
        let scale = context.theme.scale;
        let room = ui.available_size();
        if room.x < WIDE * scale {
            kit::scrolled(ui, "photograph", |ui| {
                self.words(ui, context, seen);
                self.pictures(ui, context.theme, seen, room.y * 0.9);
                if let Ok(found) = &seen.found {
                    table::show(ui, found, context.theme);
                }
            });
            return;
        }
        ui.horizontal_top(|ui| {
            kit::column(ui, vec2(WORDS * scale, room.y), |ui| {
                kit::scrolled(ui, "photograph words", |ui| {
                    self.words(ui, context, seen);
                    if let Ok(found) = &seen.found {
                        table::show(ui, found, context.theme);
                    }
                });
            });
            let width = ui.available_width();
            kit::column(ui, vec2(width, room.y), |ui| {
                self.pictures(ui, context.theme, seen, room.y - GAP);
            });
        });
    }

    /// The response that is learnt from this picture becomes the instrument's.
    fn learn(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let theme = context.theme;
        let Some(ask) = &self.learning else { return };
        let job = context.put(ask);
        progress(ui, job, "The response");
        let Some(found) = job.result_for(ask) else {
            return;
        };
        match &**found {
            Ok(instrument) => {
                self.said.instrument = Some(instrument.clone());
                self.bench = Some(Bench {
                    instrument: instrument.clone(),
                    lamp: ask.lamp.clone(),
                });
                self.learning = None;
            }
            Err(why) => kit::warning(ui, theme, why.clone()),
        }
    }

    /// The textures, made anew with the picture.
    fn load(&mut self, ui: &Ui, of: &Arc<Result<SeenPhotograph, String>>, seen: &SeenPhotograph) {
        let is_it = |drawn: &Drawn| Arc::ptr_eq(&drawn.of, of);
        if self.drawn.as_ref().is_some_and(is_it) {
            return;
        }
        let texture = |name: &str, of: &Pixels| {
            let image = swatch::image(of.size, &of.pixels);
            ui.ctx().load_texture(name, image, TextureOptions::LINEAR)
        };
        self.drawn = Some(Drawn {
            of: of.clone(),
            picture: texture("photograph", &seen.picture),
            strip: (!seen.strip.pixels.is_empty()).then(|| texture("strip", &seen.strip)),
        });
    }

    /// The picture with its band, the straightened strip under it, the profile below.
    fn pictures(&mut self, ui: &mut Ui, theme: Theme, seen: &SeenPhotograph, height: f32) {
        let width = ui.available_width();
        let found = seen.found.as_ref().ok();
        let share = if found.is_some() { 0.5 } else { 0.95 };
        let size = seen.size.map(|side| side.max(1) as f32);
        let scale = (width / size[0]).min(share * height / size[1]);
        let name = format!("Picture {}", seen.name);
        let (room, _) = ui.allocate_exact_size(vec2(width, scale * size[1]), Sense::hover());
        let rect = Rect::from_center_size(room.center(), vec2(size[0], size[1]) * scale);
        let response = ui.interact(rect, ui.scope_id().with("band"), Sense::drag());
        kit::named(&response, egui::Role::Image, &name);
        let Some(drawn) = &self.drawn else { return };
        whole(ui, drawn.picture.id(), rect);
        let to_screen =
            |x: f64, y: f64| rect.min + vec2((x as f32 + 0.5) * scale, (y as f32 + 0.5) * scale);
        if let Some(found) = found {
            let ink = Stroke::new(theme.line, theme.accent);
            let strip = found.found.strip;
            let (last, half) = (strip.columns as f64 - 1.0, strip.half);
            let corners = [(0.0, -half), (last, -half), (last, half), (0.0, half)];
            let corners = corners.map(|(column, v)| {
                let (x, y) = strip.pixel_of(column, v);
                to_screen(x, y)
            });
            for i in 0..4 {
                ui.painter()
                    .line_segment([corners[i], corners[(i + 1) % 4]], ink);
            }
        }
        self.band(ui, theme, &response, (rect, scale), seen.size);
        let Some(found) = found else { return };
        ui.add_space(GAP);
        let strip = self
            .drawn
            .as_ref()
            .and_then(|d| d.strip.as_ref())
            .map(TextureHandle::id);
        let (rect, _) = drawing(
            ui,
            vec2(width, STRIP * theme.scale),
            Sense::hover(),
            "Straightened strip",
        );
        if let Some(strip) = strip {
            whole(ui, strip, rect);
        }
        profile::marks(ui, theme, found, rect);
        let rest = (height - share * height - STRIP * theme.scale - 3.0 * GAP).max(150.0);
        let rest = rest.min(ui.available_height().max(150.0));
        self.profile(ui, theme, found, vec2(width, rest));
    }

    /// A hand draws another band over the picture.
    fn band(
        &mut self,
        ui: &Ui,
        theme: Theme,
        response: &egui::Response,
        (rect, scale): (Rect, f32),
        size: [usize; 2],
    ) {
        let touched = response.interact_pointer_pos();
        let Some(pointer) = touched.or_else(|| response.hover_pos()) else {
            return;
        };
        let place = |at: Pos2| {
            let [w, h] = size.map(|side| side as f32 - 1.0);
            let at = (at - rect.min) / scale;
            pos2(at.x.clamp(0.0, w), at.y.clamp(0.0, h))
        };
        if response.drag_started() {
            self.hand = Some(Hand::Band(place(pointer)));
        }
        let Some(Hand::Band(from)) = self.hand else {
            return;
        };
        let to = place(pointer);
        let back = |at: Pos2| rect.min + at.to_vec2() * scale;
        let box_ = Rect::from_two_pos(back(from), back(to));
        swatch::outline(ui, box_, Stroke::new(theme.line, Color32::WHITE));
        if response.drag_stopped() {
            self.hand = None;
            let (x, y) = (
                (from.x.min(to.x), from.x.max(to.x)),
                (from.y.min(to.y), from.y.max(to.y)),
            );
            if x.1 - x.0 >= 3.0 && y.1 - y.0 >= 3.0 {
                let mut said = self.said.clone();
                said.strip.area = Some([x.0, y.0, x.1, y.1].map(f64::from));
                said.instrument = None;
                self.say(said);
            }
        }
    }

    /// The lamp whose lines a hand has put right.
    fn lamp_of(found: &Photograph) -> LampChoice {
        let best = found
            .answer
            .as_ref()
            .and_then(|answer| answer.best.as_ref());
        best.map_or(LampChoice::Auto, |best| LampChoice::Is(best.lamp))
    }
}

/// A texture over all of a rectangle.
fn whole(ui: &Ui, texture: egui::TextureId, rect: Rect) {
    let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter().image(texture, rect, all, Color32::WHITE);
}

/// What the page is for, and how to begin.
fn nothing_open(ui: &mut Ui, context: &mut PageContext<'_>) {
    kit::headline(
        ui,
        context.theme,
        "A photograph of a spectrum becomes a spectrum.",
    );
    ui.add_space(4.0);
    ui.label(
        "Hold a telephone before a grating or a DVD, with a slit before a lamp, and open the \
         picture here or drop it (JPEG or PNG). The lines of an energy-saving lamp fix the \
         wavelengths; a bulb's smooth light fixes what the camera makes of them.",
    );
    ui.add_space(6.0);
    if kit::pressed(
        ui,
        names::OPEN,
        "Opens a picture of a spectrum, JPEG or PNG.",
    ) {
        context.wishes.push(PageWish::OpenPicture);
    }
    ui.add_space(4.0);
    ui.weak("The picture stays on this computer; the place where it was taken is never read.");
}
