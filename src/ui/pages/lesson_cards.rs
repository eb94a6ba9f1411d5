//! The cards of lessons: a picture of what is seen in it, title, sentence, time and audience.

use std::{
    collections::hash_map::DefaultHasher,
    hash::{Hash, Hasher},
    sync::{Arc, Mutex, PoisonError},
};

use eframe::egui;
use egui::{ColorImage, Galley, Rect, TextureHandle, TextureOptions, Ui, vec2};

use super::PageContext;
use crate::{
    app::{ByAddress, lessons::Lesson, studies::Question},
    study::Progress,
    ui::{kit::tile_button, picture, theme::Theme},
};

/// Pictures of some lessons, which take a moment to draw.
#[derive(Clone, PartialEq)]
struct PicturesAsk {
    lessons: Vec<ByAddress<Lesson>>,
    dark: bool,
}

/// A picture that was drawn: of which lesson, on a dark ground or not.
type Kept = (u64, bool, Arc<ColorImage>);

/// Most pictures that are kept while the program runs.
const MOST_KEPT: usize = 256;

impl Question for PicturesAsk {
    type Answer = Vec<Arc<ColorImage>>;

    fn answer(&self, progress: &Progress) -> Option<Self::Answer> {
        static KEPT: Mutex<Vec<Kept>> = Mutex::new(Vec::new());
        let kept = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        progress.expect(self.lessons.len());
        let drawn = self.lessons.iter().map(|lesson| {
            let mut hasher = DefaultHasher::new();
            lesson.0.text.hash(&mut hasher);
            let of = (hasher.finish(), self.dark);
            let known = kept().iter().find(|one| (one.0, one.1) == of).cloned();
            let image = match known {
                _ if progress.is_cancelled() => return None,
                Some((_, _, image)) => image,
                None => Arc::new(picture::of_lesson(&lesson.0, self.dark)),
            };
            let mut kept = kept();
            if kept.iter().all(|one| (one.0, one.1) != of) && kept.len() < MOST_KEPT {
                kept.push((of.0, of.1, image.clone()));
            }
            progress.step();
            Some(image)
        });
        drawn.collect()
    }
}

/// The pictures that the window has.
#[derive(Default)]
pub(super) struct LessonPictures {
    shown: Vec<(ByAddress<Lesson>, bool, TextureHandle)>,
    /// Lessons whose cards were in sight without one.
    wanted: Vec<ByAddress<Lesson>>,
}

impl LessonPictures {
    fn of(&mut self, lesson: &Arc<Lesson>, dark: bool) -> Option<TextureHandle> {
        let lesson = ByAddress(lesson.clone());
        let mut shown = self.shown.iter();
        let found = shown.find(|(of, on, _)| *of == lesson && *on == dark);
        if found.is_none() {
            self.wanted.push(lesson);
        }
        found.map(|(_, _, texture)| texture.clone())
    }

    /// Has those drawn that are missing, and takes in those that are.
    pub(super) fn draw(&mut self, ui: &Ui, context: &mut PageContext<'_>) {
        let lessons = std::mem::take(&mut self.wanted);
        if lessons.is_empty() {
            return;
        }
        let dark = context.theme.dark;
        let ask = PicturesAsk { lessons, dark };
        let Some(found) = context.put(&ask).result_for(&ask) else {
            return;
        };
        for (lesson, image) in ask.lessons.iter().zip(found.iter()) {
            let name = format!("lesson {}", lesson.0.name);
            let image = egui::ImageData::Color(image.clone());
            let texture = ui.ctx().load_texture(name, image, TextureOptions::LINEAR);
            self.shown.push((lesson.clone(), dark, texture));
        }
        ui.ctx().request_repaint();
    }
}

/// What is said of a lesson beside its own words.
pub(super) struct Marks {
    pub number: usize,
    pub finished: bool,
    /// It is the first of its path.
    pub first: bool,
}

/// A lesson of the list, laid out.
pub(super) struct Card {
    title: Arc<Galley>,
    sentence: Arc<Galley>,
    small: Arc<Galley>,
    name: String,
    size: egui::Vec2,
}

/// Around a card's words, and between them and the picture, points.
const MARGIN: f32 = 10.0;
const LINE_GAP: f32 = 4.0;

impl Card {
    pub(super) fn of(ui: &Ui, lesson: &Lesson, marks: &Marks, width: f32, theme: Theme) -> Self {
        let room = width - 3.0 * MARGIN - picture::LESSON[0] as f32;
        let lay = |text: String, style: egui::TextStyle, ink| {
            let font = style.resolve(ui.style());
            ui.painter().layout(text, font, ink, room.max(60.0))
        };
        let visuals = ui.visuals();
        let (minutes, audience) = (lesson.minutes, lesson.audience_words());
        let sign = match (marks.finished, marks.first) {
            (true, _) => Some(said!("✔ finished")),
            (false, true) => Some(said!("Start here")),
            (false, false) => None,
        };
        let ink = match marks.first && !marks.finished {
            true => theme.accent,
            false => visuals.weak_text_color(),
        };
        let minutes = tr!("{n} minutes" | "{n} minutes" % minutes);
        let small: Vec<&str> = sign.into_iter().chain([&*minutes, &*audience]).collect();
        let small = small.join(" · ");
        let title = format!("{}. {}", marks.number, lesson.title);
        let [strong, plain] = [visuals.strong_text_color(), visuals.text_color()];
        let mut card = Self {
            title: lay(title, egui::TextStyle::Heading, strong),
            sentence: lay(lesson.sentence.clone(), egui::TextStyle::Body, plain),
            small: lay(small, egui::TextStyle::Small, ink),
            name: tr!("Lesson: {title}", title = lesson.title),
            size: vec2(width, 0.0),
        };
        let lines = card.lines().map(|line| line.size().y + LINE_GAP);
        let words: f32 = lines.iter().sum();
        card.size.y = words.max(picture::LESSON[1] as f32) + 2.0 * MARGIN;
        card
    }

    fn lines(&self) -> [&Arc<Galley>; 3] {
        [&self.title, &self.sentence, &self.small]
    }

    pub(super) fn height(&self) -> f32 {
        self.size.y
    }

    /// Draws it as a button as high as its row; where it stands, and whether it was clicked.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        lesson: &Arc<Lesson>,
        height: f32,
        (pictures, theme): (&mut LessonPictures, Theme),
    ) -> (Rect, bool) {
        let size = vec2(self.size.x, height);
        let (rect, response) = tile_button(ui, size, &self.name);
        let [wide, high] = picture::LESSON.map(|side| side as f32);
        let place = Rect::from_min_size(rect.min + vec2(MARGIN, MARGIN), vec2(wide, high));
        if ui.is_rect_visible(rect) {
            let texture = pictures.of(lesson, theme.dark);
            match texture {
                Some(texture) => {
                    let whole = Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
                    let white = egui::Color32::WHITE;
                    ui.painter().image(texture.id(), place, whole, white);
                }
                None => {
                    ui.painter().rect_filled(place, 2.0, theme.ground);
                }
            }
        }
        let mut at = place.right_top() + vec2(MARGIN, 0.0);
        for line in self.lines() {
            ui.painter()
                .galley(at, line.clone(), ui.visuals().text_color());
            at.y += line.size().y + LINE_GAP;
        }
        (rect, response.clicked())
    }
}
