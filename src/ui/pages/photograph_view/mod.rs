//! The page "Photograph": a picture of a spectrum, its strip and profile, and whose lines they are.

mod band;
mod by_hand;
mod controls;
mod many;
mod profile;
mod table;
mod ticks;

use std::{fs, path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{Color32, Pos2, Rect, Sense, TextureHandle, TextureOptions, Ui, pos2, vec2};

use super::{PageContext, PageWish, progress};
use crate::io::name_of;
use crate::{
    app::photograph::{
        Instrument, ManyAsk, PhotographAsk, PictureOf, Pixels, ResponseAsk, Said, Seen,
        SeenPhotograph, Staged, is_instrument,
    },
    languages::said,
    ui::{
        kit::{self, drawing},
        swatch,
        theme::Theme,
    },
};

/// What people and tests call the controls.
pub mod names {
    pub const OPEN: &str = later!("Open a photograph…");
    pub const OWN: &str = later!("Back to your picture");
    pub const YES: &str = later!("Yes");
    pub const NO: &str = later!("No");
    pub const LAMP: &str = later!("Lamp");
    pub const UNDO: &str = later!("Take back");
    pub const LIBRARY: &str = later!("To the library");
    pub const INSTRUMENT: &str = later!("Use as instrument");
    pub const SAVE_INSTRUMENT: &str = later!("Save the instrument…");
    pub const LINE_UP: &str = later!("Line up by hand");
    pub const SET_PIN: &str = later!("Set a pin");
    pub const PIN: &str = later!("Wavelength of the pin");
}

/// From this width on pictures and words stand side by side, points.
const WIDE: f32 = 900.0;
/// Width of the words beside the pictures, and height of the straightened strip, points.
const WORDS: f32 = 310.0;
const STRIP: f32 = 26.0;
const GAP: f32 = 6.0;
/// Part of the height for the pictures where the words stand below them.
const NARROW_PICTURES: f32 = 0.72;

/// Pictures on the graphics card.
struct Drawn {
    of: Seen,
    picture: TextureHandle,
    strip: Option<TextureHandle>,
}

/// A hand on the page.
#[derive(Clone, Copy)]
enum Hand {
    /// Draws a band, from here in pixels of the picture.
    Band(Pos2),
    /// Moves an edge of the band.
    Edge(band::Edge),
    /// Moves the tick of a line, which is at this column now.
    Line(usize, f64),
}

/// An instrument that the next pictures are read with, and the picture that it is from, where that
/// is at hand.
struct Bench {
    instrument: Instrument,
    lamp: Option<(PathBuf, Said)>,
}

/// A picture, and what was said of it.
#[derive(Default)]
struct Told {
    path: Option<PathBuf>,
    said: Said,
    /// What was said before, the latest last.
    past: Vec<Said>,
}

#[derive(Default)]
pub struct PhotographView {
    path: Option<PathBuf>,
    said: Said,
    /// What was said before, the latest last.
    past: Vec<Said>,
    /// The picture of a lesson that stands here, and the person's own meanwhile.
    staged: Option<Staged>,
    own: Told,
    /// The last picture that was read, while the next is.
    seen: Option<Seen>,
    drawn: Option<Drawn>,
    hand: Option<Hand>,
    bench: Option<Bench>,
    /// The response that is being learnt.
    learning: Option<ResponseAsk>,
    /// Pictures that are read with the instrument, all at once.
    many: Option<ManyAsk>,
    /// Why the file of an instrument was not taken.
    trouble: Option<String>,
    by_hand: by_hand::ByHandState,
    known: controls::KnownLight,
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
        self.by_hand = by_hand::ByHandState::default();
    }

    /// Puts a lesson's picture in the place of the person's own, or gives the place back.
    fn follow(&mut self, staged: Option<Staged>) {
        if self.staged == staged {
            return;
        }
        let mut now = Told {
            path: self.path.take(),
            said: std::mem::take(&mut self.said),
            past: std::mem::take(&mut self.past),
        };
        if self.staged.is_none() {
            self.own = std::mem::take(&mut now);
        }
        if staged.is_none() {
            let own = std::mem::take(&mut self.own);
            (self.path, self.said, self.past) = (own.path, own.said, own.past);
        }
        self.staged = staged;
        self.hand = None;
    }

    /// Pictures and instruments that were opened or dropped: of several pictures the last is shown,
    /// and with an instrument all are read.
    fn take_all(&mut self, paths: Vec<PathBuf>) {
        let (instruments, pictures): (Vec<PathBuf>, Vec<PathBuf>) =
            paths.into_iter().partition(|path| is_instrument(path));
        self.trouble = None;
        if let Some(path) = instruments.last() {
            let text = fs::read_to_string(path).map_err(|why| why.to_string());
            match text.and_then(|text| Instrument::read(&text)) {
                Ok(instrument) => self.choose(instrument, None),
                Err(why) => self.trouble = Some(format!("{}: {why}.", name_of(path))),
            }
        }
        let several = self.bench.as_ref().filter(|_| pictures.len() > 1);
        self.many = several.map(|bench| ManyAsk {
            paths: pictures.clone(),
            instrument: bench.instrument.clone(),
        });
        if let Some(path) = pictures.into_iter().next_back() {
            self.take(path);
        }
    }

    /// The next pictures are read with an instrument, and so is the one that is shown, unless it is
    /// the one that the instrument is from.
    fn choose(&mut self, instrument: Instrument, lamp: Option<(PathBuf, Said)>) {
        if lamp.is_none() && self.path.is_some() {
            self.say(Said {
                instrument: Some(instrument.clone()),
                ..Said::default()
            });
        }
        self.bench = Some(Bench { instrument, lamp });
    }

    /// Says something else of the picture; what was said can be had back.
    fn say(&mut self, said: Said) {
        if said != self.said {
            self.past.push(std::mem::replace(&mut self.said, said));
        }
    }

    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        self.follow(context.app.staged_photograph());
        let asked = std::mem::take(context.photographs_asked);
        if !asked.is_empty() {
            self.take_all(asked);
        }
        if self.staged == Some(Staged::Nothing) {
            self.nothing_yet(ui, context);
            return;
        }
        let ask = PhotographAsk {
            of: (self.path.clone()).map_or(PictureOf::Example, PictureOf::File),
            said: self.said.clone(),
        };
        let job = context.put(&ask);
        if let Some(found) = job.result_for(&ask) {
            self.seen = Some(found.clone());
        }
        let is_read = job.result_for(&ask).is_some();
        progress(ui, job, said!("The photograph"));
        let read = self.seen.as_ref().filter(|_| is_read);
        let wish = read.cloned().map(PageWish::Photograph);
        context.wishes.extend(wish);
        if let Some(trouble) = &self.trouble {
            kit::warning(ui, context.theme, trouble.clone());
        }
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
                if kit::pressed(ui, said(names::OPEN), said!("Opens another picture.")) {
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
                if self.path.is_none() {
                    controls::begin(ui, context);
                }
                // What is written of a picture is read after it was seen.
                self.pictures(ui, context.theme, seen, room.y * NARROW_PICTURES);
                ui.add_space(GAP);
                self.words(ui, context, seen);
                if let Ok(found) = &seen.found {
                    table::show(ui, found, context.theme);
                }
            });
            return;
        }
        ui.horizontal_top(|ui| {
            kit::column(ui, vec2(WORDS * scale, room.y), |ui| {
                kit::scrolled(ui, "photograph words", |ui| {
                    if self.path.is_none() {
                        controls::nothing_open(ui, context);
                    }
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
        progress(ui, job, said!("The response"));
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
    fn load(&mut self, ui: &Ui, of: &Seen, seen: &SeenPhotograph) {
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
        let name = tr!("Picture {file}", file = seen.name);
        let (room, _) = ui.allocate_exact_size(vec2(width, scale * size[1]), Sense::hover());
        let rect = Rect::from_center_size(room.center(), vec2(size[0], size[1]) * scale);
        let response = ui.interact(rect, ui.scope_id().with("band"), Sense::drag());
        kit::named(&response, egui::Role::Image, &name);
        let Some(drawn) = &self.drawn else { return };
        whole(ui, drawn.picture.id(), rect);
        let to_screen =
            |x: f64, y: f64| rect.min + vec2((x as f32 + 0.5) * scale, (y as f32 + 0.5) * scale);
        if let Some(found) = found {
            band::draw(ui, theme, &found.found.strip, to_screen);
        }
        self.band(ui, theme, &response, (rect, scale), seen);
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
            // Lessons point at it by this name.
            "Straightened strip",
        );
        if let Some(strip) = strip {
            whole(ui, strip, rect);
        }
        profile::marks(ui, theme, found, rect);
        let rest = (height - scale * size[1] - STRIP * theme.scale - 3.0 * GAP).max(150.0);
        let rest = rest.min(ui.available_height().max(150.0));
        self.profile(ui, theme, found, vec2(width, rest));
    }
}

/// A texture over all of a rectangle.
fn whole(ui: &Ui, texture: egui::TextureId, rect: Rect) {
    let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter().image(texture, rect, all, Color32::WHITE);
}
