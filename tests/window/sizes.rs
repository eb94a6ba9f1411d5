//! Every page at every size that a screen may leave the window: no word lies over another, none is
//! cut off, everything is within the window, and every page says its result in a sentence.

use std::fmt;

use crate::{
    driver::Ui,
    narrow::{everything, give, over, rest},
};
use eframe::egui;
use egui::{Rect, Role, Shape, Vec2, epaint::ClippedShape, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};
use spectral_explorer::{
    app::{
        Command,
        pages::{Page, Place},
        workspace::Preferences,
    },
    languages::{self, Language},
    ui::{kit::HEADLINE, theme},
};

/// Points that a window has: 1280x800 and 1920x1080 pixels at 100 %, 1000x700 at 100 and 150 %, and a
/// high one, in which everything that is else scrolled to is seen at once.
const SIZES: [[f32; 2]; 5] = [
    [1280.0, 800.0],
    [667.0, 467.0],
    [1000.0, 700.0],
    [1920.0, 1080.0],
    [1280.0, 4000.0],
];

/// A row of text as it is painted.
#[derive(Clone)]
pub(crate) struct Words {
    /// What it says.
    pub text: String,
    /// Where its ink is.
    ink: Rect,
    /// What of that is seen.
    seen: Rect,
    /// What it may be painted in.
    clip: Rect,
    /// How it is turned, radians, and where it would stand were everything turned back.
    turned: (f32, Rect),
    /// Size of its first letter.
    pub size: f32,
}

impl fmt::Debug for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} at {:?}", self.text, self.ink)
    }
}

/// All text that is painted and at least partly to be seen.
pub(crate) fn words<S>(ui: &Harness<'static, S>, size: Vec2) -> Vec<Words> {
    let mut found = Vec::new();
    for ClippedShape {
        clip_rect, shape, ..
    } in &ui.output().shapes
    {
        let clip = clip_rect.intersect(Rect::from_min_size(egui::Pos2::ZERO, size));
        gather(shape, clip, &mut found);
    }
    found.retain(|words| words.seen.width() > 1.0 && words.seen.height() > 1.0);
    found
}

fn gather(shape: &Shape, clip: Rect, found: &mut Vec<Words>) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, clip, found)),
        Shape::Text(text) => {
            let mut push = |words: String, ink: Rect, size: f32, turned: (f32, Rect)| {
                if !words.trim().is_empty() {
                    found.push(Words {
                        text: words,
                        ink,
                        seen: ink.intersect(clip),
                        clip,
                        turned,
                        size,
                    });
                }
            };
            let sections = &text.galley.job.sections;
            let size = sections.first().map_or(0.0, |s| s.format.font_id.size);
            if text.angle != 0.0 {
                let ink = Shape::Text(text.clone()).visual_bounding_rect();
                let back = egui::emath::Rot2::from_angle(-text.angle) * text.pos.to_vec2();
                let own = text.galley.mesh_bounds.translate(back);
                return push(text.galley.text().to_owned(), ink, size, (text.angle, own));
            }
            for row in &text.galley.rows {
                let at = text.pos + row.pos.to_vec2();
                let ink = row.visuals.mesh_bounds.translate(at.to_vec2());
                push(row.text(), ink, size, (0.0, ink));
            }
        }
        _ => {}
    }
}

/// Whether two rows of text are in each other's way. The same words a little aside are a letter's
/// own edge, drawn for contrast.
fn collide(a: &Words, b: &Words) -> bool {
    let both = match a.turned.0 == b.turned.0 {
        // Slanted words stand in each other's boxes without touching.
        true if a.turned.0 != 0.0 => a.turned.1.intersect(b.turned.1),
        _ => a.seen.intersect(b.seen),
    };
    let apart = both.width() <= 1.5 || both.height() <= 3.0;
    let edge = a.text == b.text && a.ink.min.distance(b.ink.min) <= 8.0;
    !apart && !edge
}

/// Whether a page, or a table of it, scrolls sideways at a width: any other shows all of its width.
fn scrolls_sideways(page: Page, width: f32) -> bool {
    let least = match page {
        Page::Spectrum => 0.0,
        Page::Race => 900.0,
        // Its cards are a strip that scrolls: a stage more is always beside what is seen.
        Page::Chain => 760.0,
        _ => 480.0,
    };
    width < least
}

/// What is wrong with the texts of a page.
fn faults(ui: &Ui, page: Page, size: Vec2) -> Vec<String> {
    let words = words(ui, size);
    let sideways = scrolls_sideways(page, size.x);
    let mut wrong = Vec::new();
    for (i, one) in words.iter().enumerate() {
        let others = words[..i].iter().filter(|other| collide(one, other));
        wrong.extend(others.map(|other| format!("{one:?} lies over {other:?}")));
        let cut =
            one.ink.left() < one.clip.left() - 1.5 || one.ink.right() > one.clip.right() + 1.5;
        if cut && !sideways {
            wrong.push(format!("{one:?} is cut off at {:?}", one.clip));
        }
    }
    let outside = |rect: &Rect| rect.left() < -0.5 || rect.right() > size.x + 0.5;
    let found = everything(ui).into_iter();
    let found = found.filter(|(_, rect)| outside(rect) && !sideways);
    wrong.extend(found.map(|(name, rect)| format!("{name} at {rect:?} is outside")));
    wrong
}

/// Whether a sentence in the type of a result is seen: it may go on in further rows.
fn says_something(ui: &Ui, size: Vec2, scale: f32) -> bool {
    let words = words(ui, size);
    words.iter().any(|words| {
        let large = (words.size - HEADLINE * scale).abs() < 0.1;
        large && words.text.split_whitespace().count() >= 3
    })
}

/// Gives the window a size in points; one of few has them by a zoom.
fn set_size(ui: &mut Ui, size: Vec2) {
    ui.state_mut().0.preferences.zoom = if size.x < 1000.0 { 1.5 } else { 1.0 };
    rest(ui);
    ui.set_size(size);
}

/// Walks a page through all sizes, with what its computations find.
pub(crate) fn walk(preferences: Preferences, sizes: &[[f32; 2]], wrong: &mut Vec<String>) {
    let page = preferences.page;
    let present = if preferences.presents() {
        ", presented"
    } else {
        ""
    };
    let mut ui = over(preferences, sizes[0]);
    for _ in 0..4 {
        ui.state_mut().0.studies.finish();
        rest(&mut ui);
    }
    for &[width, height] in sizes {
        let size = vec2(width, height);
        set_size(&mut ui, size);
        rest(&mut ui);
        let case = format!("{}{present} at {width} x {height}", page.title());
        wrong.extend(
            faults(&ui, page, size)
                .into_iter()
                .map(|fault| format!("{case}: {fault}")),
        );
        let says = says_something(&ui, size, theme::grown(size));
        if page != Page::Spectrum && width >= 1000.0 && !says {
            wrong.push(format!("{case}: no sentence"));
        }
        let way = ui.query_all_by_role_and_label(Role::Button, page.place().title());
        if present.is_empty() && way.count() == 0 {
            wrong.push(format!("{case}: no way to its place"));
        }
    }
}

#[track_caller]
fn assert_sound(place: Place) {
    let mut wrong = Vec::new();
    for page in Page::all().filter(|page| page.place() == place) {
        let preferences = Preferences {
            page,
            greeted: true,
            ..Preferences::default()
        };
        walk(preferences, &SIZES, &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn nothing_collides_or_is_cut_in_learn() {
    assert_sound(Place::Learn);
}

#[test]
fn nothing_collides_or_is_cut_in_look() {
    assert_sound(Place::Look);
}

#[test]
fn nothing_collides_or_is_cut_in_through() {
    assert_sound(Place::Through);
}

#[test]
fn nothing_collides_or_is_cut_in_quality() {
    assert_sound(Place::Quality);
}

#[test]
fn nothing_collides_or_is_cut_in_design() {
    assert_sound(Place::Design);
}

#[test]
fn nothing_collides_or_is_cut_in_numbers() {
    assert_sound(Place::Numbers);
}

#[test]
fn nothing_collides_or_is_cut_in_picture() {
    assert_sound(Place::Picture);
}

#[test]
fn every_page_knows_the_second_light_and_nothing_collides_or_is_cut() {
    let mut wrong = Vec::new();
    for page in Page::all() {
        let preferences = Preferences {
            page,
            greeted: true,
            ..Preferences::default()
        };
        let mut ui = over(preferences, [1000.0, 700.0]);
        let app = &mut ui.state_mut().0.app;
        let second = app.entry("cie_led_1nm/LED-B1").expect("shipped");
        app.apply(Command::Compare(Some(second)));
        for _ in 0..4 {
            rest(&mut ui);
            ui.state_mut().0.studies.finish();
        }
        for [width, height] in [[1000.0, 700.0], [1280.0, 800.0], [667.0, 467.0]] {
            let size = vec2(width, height);
            set_size(&mut ui, size);
            rest(&mut ui);
            let case = format!("{} at {width} x {height}", page.title());
            let found = faults(&ui, page, size).into_iter();
            wrong.extend(found.map(|fault| format!("{case}: {fault}")));
            let chip = ui.query_by_role_and_label(Role::Button, "Compared with LED-B1");
            if chip.is_none() {
                wrong.push(format!("{case}: no chip"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A page at the smallest window and at a usual one, in the languages whose words are longest.
fn assert_sound_in(language: Language) {
    let mut wrong = Vec::new();
    for page in Page::all() {
        let mut preferences = Preferences {
            page,
            greeted: true,
            ..Preferences::default()
        };
        preferences.speak(language);
        languages::in_language(language, || {
            walk(preferences, &[[1280.0, 800.0], [1000.0, 700.0]], &mut wrong);
        });
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn nothing_collides_or_is_cut_in_german() {
    assert_sound_in(Language::German);
}

#[test]
fn nothing_collides_or_is_cut_in_spanish() {
    assert_sound_in(Language::Spanish);
}

#[test]
fn nothing_collides_or_is_cut_in_french() {
    assert_sound_in(Language::French);
}

#[test]
fn another_language_is_spoken_at_once_everywhere_and_kept() {
    let mut ui = over(Preferences::default(), [1280.0, 800.0]);
    for (menu, name, open) in [
        ("Language", "Deutsch", "Öffnen"),
        ("Sprache", "Español", "Abrir"),
        ("Idioma", "Français", "Ouvrir"),
        ("Langue", "English", "Open"),
    ] {
        ui.get_by_role_and_label(Role::Button, menu).click();
        rest(&mut ui);
        ui.get_by_label(name).click();
        rest(&mut ui);
        assert!(ui.query_by_label(open).is_some(), "{name}");
        let preferences = &ui.state().0.preferences;
        assert_eq!(preferences.language.name(), name);
        assert_eq!(preferences.lesson_language, preferences.language.code());
    }
}

#[test]
fn nothing_collides_or_is_cut_while_presenting() {
    let mut wrong = Vec::new();
    let preferences = Preferences {
        present: true,
        greeted: true,
        ..Preferences::default()
    };
    walk(preferences, &SIZES, &mut wrong);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_window_smaller_than_the_smallest_layout_is_scaled_and_a_zoom_is_not_taken_back() {
    let mut ui = over(Preferences::default(), [1280.0, 800.0]);
    // Pixels of the window, the zoom that was asked for, and the one that is seen.
    for (pixels, zoom, seen) in [
        ([1280.0, 800.0], 1.0, 1.0),
        ([900.0, 600.0], 1.0, 1.0),
        ([720.0, 600.0], 1.0, 0.8),
        ([900.0, 300.0], 1.0, 0.5),
        ([720.0, 600.0], 1.5, 1.2),
        ([1280.0, 800.0], 2.5, 2.5),
    ] {
        ui.state_mut().0.preferences.zoom = zoom;
        give(&mut ui, pixels.into());
        let now = ui.ctx.zoom_factor();
        assert!((now - seen).abs() < 1e-4, "{pixels:?} at {zoom}: {now}");
    }
}
