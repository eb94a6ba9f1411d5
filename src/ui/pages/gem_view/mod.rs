//! The page "Gem": a film traced in the background, summed anew for every light.

mod colour;
mod controls;
pub mod names;

use std::sync::Arc;

use eframe::egui;
use egui::{
    Color32, ColorImage, Rect, RichText, Sense, TextureHandle, TextureOptions, Ui, Vec2, pos2, vec2,
};

use super::{
    PageContext,
    presented::head,
    prism_view::{exposure, notes},
    progress,
};
use crate::{
    app::{
        ByAddress, Memo,
        dispersion::{
            GemFilm, GemLook, GemPass, GemScene, GemShown, NoiseAsk, Sent, another_light,
            document_light, facts_of, next_pass, noise_words, places, sentence,
        },
        pages::GemMemory,
        studies::Stage,
    },
    io::many::capitalised,
    languages::fixed,
    optics::{Light, Noise},
    study::Progress,
    ui::{
        kit::{GROUP, down, drawing, form, headline, warning, with_panel},
        swatch,
        theme::grey,
    },
};

/// How dark the wall behind the pictures is.
const WALL: u8 = 16;

/// A light, or why there is none.
type Lit = Result<Light, String>;

/// What a texture was made of.
type DrawnOf = (ByAddress<GemFilm>, Light, GemLook);

/// A picture on the graphics card.
struct Drawn {
    of: DrawnOf,
    texture: TextureHandle,
    words: String,
}

#[derive(Default)]
pub struct GemView {
    light: Memo<(u64, Sent), Lit>,
    other: Memo<(u64, Option<String>, Sent), Option<Lit>>,
    /// What is to be traced, or why there is no such gem.
    scene: Memo<(u64, GemMemory), Result<GemScene, String>>,
    asked: Option<GemPass>,
    drawn: [Option<Drawn>; 2],
}

impl GemView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        self.page(ui, context, false);
    }

    /// The pictures alone with their exposure; whether a hand wants the whole window back.
    pub(super) fn present(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) -> bool {
        self.page(ui, context, true)
    }

    fn page(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, presented: bool) -> bool {
        let (app, revision) = (context.app, context.app.revision());
        let sent = context.pages.gem.sent;
        let light = match &*self
            .light
            .get((revision, sent), |_| document_light(app, sent))
        {
            Ok(light) => light.clone(),
            Err(why) => {
                headline(ui, context.theme, why);
                return presented && head(ui, "");
            }
        };
        let second = context.app.document().second.as_deref();
        let under = context.pages.gem.light_beside(second);
        let other = self.other.get((revision, under, sent), |(_, key, _)| {
            let entry = app.entry(key.as_ref()?)?;
            Some(another_light(app, &entry, sent))
        });
        let (other, trouble) = match &*other {
            Some(Ok(light)) => (Some(light.clone()), None),
            Some(Err(why)) => (None, Some(why.clone())),
            None => (None, None),
        };
        let lights: Vec<Light> = std::iter::once(light).chain(other).collect();
        let asked = context.pages.gem.clone();
        let scene = self
            .scene
            .get((revision, asked), |(_, memory)| GemScene::of(app, memory))
            .clone();
        let film = self.film(context, scene.as_ref().ok(), &lights);
        let noise = film
            .as_ref()
            .and_then(|film| noise(context, film, &lights[0]));

        let memory = &context.pages.gem;
        let words = sentence(app, memory, &lights);
        let scale = context.theme.scale;
        let (shown, both) = (film.clone(), &lights);
        let noise = noise.as_ref().map(noise_words);
        if presented {
            let leaves = head(ui, &words);
            let row = ui.spacing().interact_size.y + 2.0 * ui.spacing().item_spacing.y;
            let size = vec2(ui.available_width(), ui.available_height() - row);
            down(ui, size, |ui| {
                self.pictures(ui, context, (film.as_ref(), both, noise), size);
            });
            let stops = &mut context.pages.gem.stops;
            form(ui, "gem presented", |form| exposure(form, stops));
            return leaves;
        }
        headline(ui, context.theme, words);
        for words in scene.as_ref().err().into_iter().chain(&trouble) {
            warning(ui, context.theme, words.as_str());
        }
        ui.add_space(GROUP);
        with_panel(
            ui,
            context,
            ("gem", scale),
            |ui, context, room| {
                self.pictures(ui, context, (film.as_ref(), both, noise), room);
            },
            |ui, context| controls::show(ui, context, shown.as_ref(), both),
        );
        false
    }

    /// The finest film that there is, whatever it shows; what is missing of it is asked for.
    fn film(
        &mut self,
        context: &mut PageContext<'_>,
        scene: Option<&GemScene>,
        lights: &[Light],
    ) -> Option<Arc<GemFilm>> {
        let rays = context.pages.gem.rays;
        let job = context.studies.job::<GemPass, GemFilm>();
        let held = job.result().cloned();
        let Some(scene) = scene else {
            return held;
        };
        let mut lines: Vec<f64> = lights.iter().flat_map(places).collect();
        lines.sort_by(f64::total_cmp);
        lines.dedup();
        let before = held.as_ref().map(|held| &held.pass);
        let next = next_pass(before, scene, rays, &lines, context.quiet);
        // What is under way for this gem, or is done in a moment, is let be: otherwise a hand that
        // moves would never see a picture.
        let is_running = matches!(job.stage(), Stage::Running(_));
        let under_way = self
            .asked
            .clone()
            .filter(|asked| is_running && (asked.is_of(scene) || asked.is_quick()));
        if let Some(ask) = under_way.or(next) {
            let from = held.clone();
            job.ask(&ask, context.wake, || {
                let (ask, lights) = (ask.clone(), lights.to_vec());
                move |progress: &Progress| ask.trace(from, &lights, progress)
            });
            self.asked = Some(ask);
        }
        held
    }

    /// One picture for each light, beside each other.
    fn pictures(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (film, lights, noise): (Option<&Arc<GemFilm>>, &[Light], Option<String>),
        room: Vec2,
    ) {
        let text = ui.text_style_height(&egui::TextStyle::Small);
        // Below the pictures: three lines of words each, progress, and notes.
        let below = 5.0 * text + ui.spacing().interact_size.y + 30.0;
        let gap = 8.0;
        let count = lights.len() as f32;
        let side = ((room.x - gap * (count - 1.0)) / count).min(room.y - below);
        let side = side.max(80.0);
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for (light, place) in lights.iter().zip(0..) {
                let size = vec2(side, side + 3.0 * text + 12.0);
                down(ui, size, |ui| {
                    self.draw(ui, context, film, light, place);
                    self.picture(ui, context, light, place, side);
                });
            }
        });
        progress(
            ui,
            context.studies.job::<GemPass, GemFilm>(),
            said!("The picture"),
        );
        let mut said = Vec::new();
        if let Some(film) = film {
            said.extend(lights.iter().flat_map(|light| facts_of(film, light)));
            said.dedup();
            said.extend(noise.map(|words| format!("{}.", capitalised(&words))));
            let traced = film.film.traced();
            said.push(tr!(
                "{size} x {size} pixels, {rays} rays a pixel, {faces} faces a ray, {megabytes} MB. \
                 Light at each face as if unpolarised.",
                size = film.film.settings().size,
                rays = film.pass.rays,
                faces = fixed(traced.segments_per_ray(), 1),
                megabytes = film.film.bytes().div_ceil(1 << 20)
            ));
            if !context.quiet && film.seconds > 0.0 {
                said.push(tr!(
                    "Traced in {seconds} s, {speed} million rays a second.",
                    seconds = fixed(film.seconds, 1),
                    speed = fixed(traced.rays as f64 / film.seconds / 1e6, 2)
                ));
            }
        }
        notes(ui, said.iter().map(String::as_str));
    }

    /// The texture of a light, made anew when film, light or exposure changed.
    fn draw(
        &mut self,
        ui: &Ui,
        context: &PageContext<'_>,
        film: Option<&Arc<GemFilm>>,
        light: &Light,
        place: usize,
    ) {
        let Some(film) = film else {
            return;
        };
        let look = controls::look(context);
        let of: DrawnOf = (ByAddress(film.clone()), light.clone(), look);
        if self.drawn[place]
            .as_ref()
            .is_some_and(|drawn| drawn.of == of)
        {
            return;
        }
        let (image, words) = match GemShown::of(film, light, look) {
            Ok(shown) => (swatch::image([shown.size; 2], &shown.pixels), shown.words),
            Err(why) => (ColorImage::filled([1; 2], Color32::BLACK), why),
        };
        let name = format!("gem {place}");
        let texture = ui.ctx().load_texture(name, image, TextureOptions::LINEAR);
        self.drawn[place] = Some(Drawn { of, texture, words });
    }

    /// A picture with the name of its light; a hand turns the gem.
    fn picture(
        &self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        light: &Light,
        place: usize,
        side: f32,
    ) {
        let name = tr!("The gem under {light}", light = light.name);
        let (area, response) = drawing(ui, Vec2::splat(side), Sense::drag(), &name);
        let painter = ui.painter();
        painter.rect_filled(area, 2.0, grey(WALL));
        let drawn = self.drawn[place].as_ref();
        if let Some(drawn) = drawn {
            let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(drawn.texture.id(), area, uv, Color32::WHITE);
        }
        let moved = response.drag_delta();
        if moved != Vec2::ZERO {
            context.pages.gem.turn_by([moved.x, moved.y].map(f64::from));
        }
        response.on_hover_text_at_pointer(said!("Drag to look from another side."));
        let name = RichText::new(&light.name).strong();
        ui.add(egui::Label::new(name).truncate());
        let words = drawn.map_or("", |drawn| drawn.words.as_str());
        ui.add(egui::Label::new(RichText::new(words).small().weak()).wrap());
    }
}

/// The noise of the first picture, once nothing is traced any more.
fn noise(context: &mut PageContext<'_>, film: &Arc<GemFilm>, light: &Light) -> Option<Noise> {
    let is_running = matches!(
        context.studies.job::<GemPass, GemFilm>().stage(),
        Stage::Running(_)
    );
    let ask = NoiseAsk {
        film: ByAddress(film.clone()),
        light: light.clone(),
        observer: context.app.document().settings.observer,
    };
    let job = context.studies.job();
    if !is_running && !film.pass.is_quick() {
        job.put(&ask, context.wake);
    }
    job.result_for(&ask).map(|noise| **noise)
}
