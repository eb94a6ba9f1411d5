//! Lessons in the window: begun by a click, taken with the keyboard alone, left without a trace.

use std::{path::PathBuf, sync::Arc};

use eframe::egui::{self, Key, Rect, Role, Shape};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{
        App,
        charts::spectrum::spectrum_chart,
        lessons::{Aim, Lesson, shelf},
        pages::{AskedLesson, Page},
        verdicts::Seen,
        workspace::Preferences,
    },
    spectrum::Kind,
    ui::{Window, files::Picked, look_view::names as knobs, saver::Saver},
};

use crate::driver::{
    Ui, app, assert_written, at_rest, click, is_written, no_files, wait_until, words,
};

pub(crate) fn at(page: Page) -> Ui {
    let preferences = Preferences {
        page,
        ..Preferences::default()
    };
    at_rest(Window::new(App::new(), preferences, no_files(), None))
}

pub(crate) fn press(ui: &mut Ui, key: Key) {
    ui.key_press(key);
    ui.run();
}

/// The program shows a task at a pace that one can follow.
fn watch(ui: &mut Ui) {
    for _ in 0..400 {
        ui.step();
    }
}

#[test]
fn a_lesson_is_taken_with_the_keyboard_alone_and_leaves_everything_as_it_was() {
    let mut ui = at(Page::Lessons);
    let before = app(&ui).document().clone();
    ui.get_by_label("Lesson: Draw a lamp with waves")
        .scroll_to_me();
    watch(&mut ui);
    click(&mut ui, "Lesson: Draw a lamp with waves");
    assert_written(&ui, "Step 1 of 4");
    assert_eq!(app(&ui).document().light.name(), "CIE D65");
    press(&mut ui, Key::Space);
    watch(&mut ui);
    assert_eq!(app(&ui).document().settings.order, 12);
    press(&mut ui, Key::ArrowRight);
    assert_written(&ui, "Step 2 of 4");
    press(&mut ui, Key::Num1);
    press(&mut ui, Key::Space);
    watch(&mut ui);
    assert_written(&ui, "A sum that stops early overshoots on both sides");
    press(&mut ui, Key::PageUp);
    assert_written(&ui, "Step 1 of 4");
    assert_eq!(app(&ui).document().settings.order, 1);
    click(&mut ui, "Leave the lesson");
    assert!(*app(&ui).document() == before);
    assert_eq!(ui.state().preferences.page, Page::Lessons);
    press(&mut ui, Key::ArrowRight);
    assert_eq!(
        app(&ui).document().settings.order,
        before.settings.order + 1
    );
}

#[test]
fn a_lesson_that_was_finished_has_a_tick() {
    let mut ui = at(Page::Lessons);
    click(&mut ui, "Lesson: What is in this light?");
    let lesson = shelf::named("light").expect("shipped");
    // Page Down tells first, and goes on then.
    for _ in 0..lesson.steps.len() {
        press(&mut ui, Key::PageDown);
        watch(&mut ui);
        if !is_written(&ui, &lesson.remember) {
            press(&mut ui, Key::PageDown);
        }
    }
    assert_written(&ui, &lesson.remember);
    click(&mut ui, "Finish");
    assert_eq!(ui.state().preferences.lessons_finished, ["light"]);
    assert_written(
        &ui,
        &format!("1 of {} lessons finished", shelf::FILES.len()),
    );
}

#[test]
fn a_file_of_a_lesson_joins_the_list_and_one_with_a_fault_says_where() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = &shelf::named("samples").expect("shipped").text;
    let put = |name: &str, text: String| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("a file");
        path
    };
    let mine = put(
        "mine.json",
        text.replace("Where samples", "Mine: where samples"),
    );
    let wrong = put("wrong.json", text.replacen("\"say\"", "\"sya\"", 1));
    // What the check refuses the window refuses, too.
    let unknown = put("unknown.json", text.replacen("{numbers}", "{foo}", 1));
    let ring = put(
        "ring.json",
        text.replacen("\"control\": \"Centre\"", "\"control\": \"Foo\"", 1),
    );
    let mut ui = at(Page::Spectrum);
    let wake: spectral_explorer::ui::theme::Wake = std::sync::Arc::new(|| {});
    ui.state_mut()
        .open_files(vec![wrong, unknown, ring, mine], wake);
    wait_until(&mut ui, "the lessons", |ui| !ui.state().is_busy());
    assert_eq!(ui.state().preferences.page, Page::Lessons);
    let said: Vec<String> = app(&ui).messages().iter().map(|m| m.text.clone()).collect();
    assert!(
        said.iter()
            .any(|words| words.contains("step 1: found the field `sya`")),
        "{said:?}"
    );
    for fault in [
        "step 1: found the figure foo, expected one of",
        "step 1: found the control \"Foo\" in point, expected the name of one on the page filter",
    ] {
        assert!(said.iter().any(|words| words.contains(fault)), "{said:?}");
    }
    assert!(
        ui.query_by_label("Lesson: Mine: where samples go wrong")
            .is_some()
    );
}

#[test]
fn a_slider_does_a_task_in_the_direction_that_the_words_name() {
    let mut moved = 0;
    for lesson in shelf::shipped() {
        for (index, step) in lesson.steps.iter().enumerate() {
            let (Some(task), Some(point)) = (&step.task, &step.point) else {
                continue;
            };
            let says = |words: &str| task.words.contains(words) || point.label.contains(words);
            let key = match (says("to the right"), says("to the left")) {
                (true, false) => Key::ArrowRight,
                (false, true) => Key::ArrowLeft,
                (false, false) => continue,
                (true, true) => panic!("{}, step {}: both ways", lesson.name, index + 1),
            };
            let mut ui = at(Page::Lessons);
            begun(&mut ui, lesson, index);
            // Where a step points at the plot its words name the slider.
            let control = point.control().unwrap_or(knobs::ORDER);
            ui.get_by_role_and_label(Role::Slider, control).focus();
            ui.run();
            let mut left = 100;
            while !is_written(&ui, "✔") && left > 0 {
                press(&mut ui, key);
                left -= 1;
            }
            let what = format!("{}, step {}: {}", lesson.name, index + 1, task.words);
            assert!(is_written(&ui, "✔"), "{what}");
            moved += 1;
        }
    }
    assert!(moved >= 4, "{moved}");
}

#[test]
fn a_lesson_that_is_not_about_the_model_judges_none() {
    for name in [
        "light", "metamers", "missing", "quality", "white", "recover",
    ] {
        let lesson = shelf::named(name).expect("shipped");
        let mut ui = at(Page::Lessons);
        for index in 0..lesson.steps.len() {
            begun(&mut ui, &lesson, index);
            for seen in Seen::ALL {
                let brief = format!("Difference {}", seen.seen());
                for verdict in [
                    seen.verdict(Kind::Light),
                    seen.verdict(Kind::Reflectance),
                    brief,
                ] {
                    let step = index + 1;
                    assert!(!is_written(&ui, &verdict), "{name}, step {step}: {verdict}");
                }
            }
            assert!(!is_written(&ui, "Model: "), "{name}, step {}", index + 1);
        }
    }
}

#[test]
fn a_lamp_that_is_chosen_in_a_lesson_shines_on_the_surfaces_that_are_looked_at() {
    let lesson = shelf::named("metamers").expect("shipped");
    let mut ui = at(Page::Lessons);
    // The colours of both surfaces, largest difference of a channel.
    let apart = |ui: &Ui| {
        let all = words(ui);
        let pair = all
            .iter()
            .find(|one| one.starts_with("Surfaces: Twin of the grey #"));
        let pair = pair.unwrap_or_else(|| panic!("{all:?}"));
        let hex: Vec<u32> = pair
            .split('#')
            .skip(1)
            .map(|rest| u32::from_str_radix(&rest[..6], 16).expect("a colour"))
            .collect();
        let channel = |colour: u32, k: u32| (colour >> (8 * k)) & 0xff;
        let apart = (0..3).map(|k| channel(hex[0], k).abs_diff(channel(hex[1], k)));
        apart.max().expect("three channels")
    };
    begun(&mut ui, &lesson, 1);
    assert!(apart(&ui) <= 1, "a twin in daylight");
    click(&mut ui, "Library: Twin of the grey");
    ui.event(egui::Event::Text("CIE A".to_owned()));
    ui.run();
    click(&mut ui, "CIE A");
    let document = app(&ui).document();
    assert_eq!(document.light.name(), "CIE A");
    assert_eq!(document.subject_entry().name(), "Twin of the grey");
    assert!(apart(&ui) >= 5, "no twin under the bulb");
    let chart = spectrum_chart(app(&ui));
    let names: Vec<&str> = chart.series.iter().map(|one| &*one.name).collect();
    assert!(
        names.iter().any(|name| name.starts_with("neutral 3.5")),
        "the paint beside its twin: {names:?}"
    );
    assert_written(&ui, "✔");
}

/// The window at a step of a lesson.
pub(crate) fn begun(ui: &mut Ui, lesson: &Lesson, step: usize) {
    ui.state_mut().preferences.lesson_asked = Some(AskedLesson {
        name: lesson.name.clone(),
        step,
        done: false,
    });
    ui.run();
}

/// Where the first control of a name stands, or the first whose name begins so, or else words.
pub(crate) fn place(ui: &Ui, name: &str) -> Option<Rect> {
    let fits = |whole: bool, is_control: bool| {
        let nodes = ui.root().children_recursive();
        let named = nodes.filter(|node| {
            let node = node.accesskit_node();
            let is_words = matches!(node.role(), Role::Label | Role::TextRun);
            if is_words == is_control {
                return false;
            }
            let names = [node.label(), node.value()];
            names.into_iter().flatten().any(|word| match whole {
                true => word == name,
                false => word.starts_with(name),
            })
        });
        let rects: Vec<Rect> = named.map(|node| node.rect()).collect();
        rects.into_iter().min_by(|a, b| {
            (a.top(), a.left())
                .partial_cmp(&(b.top(), b.left()))
                .unwrap()
        })
    };
    let ways = [(true, true), (true, false), (false, true), (false, false)];
    ways.into_iter()
        .find_map(|(whole, is_control)| fits(whole, is_control))
}

/// Whether a ring is painted around a place.
fn is_ringed(ui: &Ui, around: Rect) -> bool {
    let mut shapes = ui.output().shapes.iter();
    shapes.any(|clipped| match &clipped.shape {
        Shape::Rect(ring) => {
            ring.fill == egui::Color32::TRANSPARENT
                && ring.stroke.width >= 3.0
                && ring.rect.contains_rect(around)
                && ring.rect.width() < around.width() + 40.0
        }
        _ => false,
    })
}

#[test]
fn a_ring_is_drawn_around_everything_that_a_step_points_at() {
    let screen = Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(1280.0, 800.0));
    let mut rings = 0;
    for lesson in shelf::shipped() {
        let mut ui = at(Page::Lessons);
        for (index, step) in lesson.steps.iter().enumerate() {
            // A page that is covered has nothing to point at.
            let Some(point) = step.point.as_ref().filter(|_| !step.veil) else {
                continue;
            };
            let what = format!("{}, step {}: {point:?}", lesson.name, index + 1);
            begun(&mut ui, lesson, index);
            // A photograph is read beside the window.
            ui.state_mut().studies.finish();
            ui.run();
            let aimed = |ui: &Ui| {
                let page = ui.state().preferences.page;
                match point.aim(app(ui), page).expect(&what) {
                    Aim::Named(name) => place(ui, &name).unwrap_or_else(|| panic!("{what}")),
                    Aim::Nm(nm) => {
                        let plot = ui.state().look.spectrum.transform.expect("a plot");
                        let x = plot.position_from_point_x(nm);
                        Rect::from_x_y_ranges(x - 2.0..=x + 2.0, plot.frame().y_range())
                    }
                }
            };
            // A page that computes moves for a few frames, and the ring with it.
            let mut around = aimed(&ui);
            for _ in 0..200 {
                if is_ringed(&ui, around) {
                    break;
                }
                std::thread::sleep(std::time::Duration::from_millis(10));
                ui.step();
                around = aimed(&ui);
            }
            assert!(screen.contains_rect(around), "{what} is at {around:?}");
            assert!(is_ringed(&ui, around), "{what} has no ring");
            let spoken = place(&ui, &format!("Here: {}", point.label));
            assert!(
                spoken.is_some_and(|ring| ring.contains_rect(around)),
                "{what}"
            );
            rings += 1;
        }
        // Out of the lesson there is nothing to point at.
        // Of some every step is covered.
        if is_written(&ui, "Leave the lesson") {
            click(&mut ui, "Leave the lesson");
        }
        assert!(!is_written(&ui, "Here: "), "{}", lesson.name);
    }
    assert!(rings >= 24, "{rings}");
}

#[test]
fn a_control_below_the_edge_is_brought_into_view_and_a_task_that_is_done_needs_no_ring() {
    let lesson = shelf::named("waves").expect("shipped");
    let mut lesson = Lesson::clone(&lesson);
    lesson.name = "long".to_owned();
    let folder = tempfile::tempdir().expect("a folder");
    let text = lesson.text.replacen(
        r#""control": "Waves""#,
        r#""control": "Copy the surfaces as CSV""#,
        1,
    );
    let text = text.replacen(
        r#""light": "CIE D65","#,
        r#""light": "CIE D65", "page": "two-lights","#,
        1,
    );
    let path = folder.path().join("long.json");
    std::fs::write(&path, text).expect("a file");
    let mut ui = at(Page::Lessons);
    ui.state_mut().open_files(vec![path], Arc::new(|| {}));
    wait_until(&mut ui, "the lessons", |ui| !ui.state().is_busy());
    begun(&mut ui, &lesson, 0);
    let around = place(&ui, "Copy the surfaces as CSV").expect("it is on the page");
    assert!(is_ringed(&ui, around), "{around:?}");
    let first = shelf::named("waves").expect("shipped");
    begun(&mut ui, &first, 0);
    assert!(is_written(&ui, "Here: "));
    press(&mut ui, Key::Space);
    watch(&mut ui);
    assert!(!is_written(&ui, "Here: "));
}

/// The sizes of all words that the lesson's column shows, with those words, and whether all of
/// them stand within its sides.
fn column(ui: &Ui) -> (f32, bool, Vec<(f32, String)>) {
    let next = place(ui, "Next").expect("a column");
    let left = place(ui, "Step 1 of").expect("a column").left() - 12.0;
    let right = place(ui, "Leave the lesson").expect("a column").right() + 12.0;
    let mut within = true;
    let mut words = Vec::new();
    for clipped in &ui.output().shapes {
        let Shape::Text(text) = &clipped.shape else {
            continue;
        };
        let rect = text.visual_bounding_rect();
        let is_beside = left <= rect.left() && rect.left() < right;
        // Above is the bar, below the bottom line.
        let is_of_column = is_beside && rect.top() > 50.0 && rect.top() < next.bottom();
        if !is_of_column || text.galley.text().trim().is_empty() || clipped.clip_rect.left() > right
        {
            continue;
        }
        let is_foot = ["Back", "Next"].contains(&text.galley.text());
        // At a projector long words are scrolled: the plot keeps its room.
        let may_scroll = ui.state().preferences.presents();
        let has_room = is_foot || may_scroll || rect.bottom() <= next.top();
        within &= rect.right() <= right && has_room;
        let sizes = text
            .galley
            .job
            .sections
            .iter()
            .map(|s| s.format.font_id.size);
        let least = sizes.fold(f32::INFINITY, f32::min);
        words.push((least, text.galley.text().to_owned()));
    }
    (right - left, within, words)
}

#[test]
fn every_first_step_is_large_enough_to_read_and_stays_within_its_column() {
    for (present, least) in [(false, 18.0), (true, 28.0)] {
        for lesson in shelf::shipped() {
            let mut ui = at(Page::Lessons);
            ui.state_mut().preferences.present = present;
            begun(&mut ui, lesson, 0);
            let what = format!("{} (present {present})", lesson.name);
            let presents = ui.state().preferences.presents();
            let least = if presents { least } else { 18.0 };
            let (width, within, words) = column(&ui);
            assert!(within && width >= 340.0, "{what}: {words:?}");
            assert!(words.len() >= 6, "{what}: {words:?}");
            // What stands beside a ring is no text of the column.
            let beside = lesson.steps[0].point.as_ref().map(|point| &point.label);
            for (size, word) in words.into_iter().filter(|(_, word)| Some(word) != beside) {
                assert!(size >= least, "{what}: {size} points for {word:?}");
            }
        }
    }
}

#[test]
fn a_lesson_is_begun_taken_and_finished_without_a_mouse() {
    let lesson = shelf::named("waves").expect("shipped");
    let mut ui = at(Page::Lessons);
    let card = format!("Lesson: {}", lesson.title);
    for _ in 0..80 {
        if ui.get_by_label(&card).is_focused() {
            break;
        }
        press(&mut ui, Key::Tab);
    }
    assert!(ui.get_by_label(&card).is_focused());
    press(&mut ui, Key::Enter);
    assert_eq!(ui.state().preferences.page, Page::Spectrum);
    for (index, step) in lesson.steps.iter().enumerate() {
        assert_written(
            &ui,
            &format!("Step {} of {}", index + 1, lesson.steps.len()),
        );
        if let Some(ask) = &step.ask {
            // A task comes before the reason; without one a choice is told at once.
            press(&mut ui, Key::Num2);
            assert_eq!(
                is_written(&ui, &ask.answers[1].because),
                step.task.is_none()
            );
            if step.task.is_some() {
                press(&mut ui, Key::Space);
                watch(&mut ui);
            }
            assert_written(&ui, &ask.answers[1].because);
        } else {
            press(&mut ui, Key::Space);
            watch(&mut ui);
            assert_written(&ui, "✔");
        }
        // Arrows and a clicker's keys take turns.
        press(&mut ui, [Key::ArrowRight, Key::PageDown][index % 2]);
    }
    assert_written(
        &ui,
        &format!("1 of {} lessons finished", shelf::FILES.len()),
    );
}

/// A window whose workspace and lessons are kept in a folder.
fn kept_in(folder: &std::path::Path, page: Page) -> Ui {
    let preferences = Preferences {
        page,
        ..Preferences::default()
    };
    let saver = Saver::new(folder.join("workspace.json"));
    at_rest(Window::new(
        App::new(),
        preferences,
        no_files(),
        Some(saver),
    ))
}

#[test]
fn a_lesson_of_ones_own_is_there_again_after_a_restart_and_the_menu_names_its_folder() {
    let (home, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let text = &shelf::named("samples").expect("shipped").text;
    let mine = other.path().join("mine.json");
    std::fs::write(&mine, text.replace("Where samples", "Mine: where samples")).unwrap();
    let mut ui = kept_in(home.path(), Page::Spectrum);
    ui.state_mut()
        .open_files(vec![mine.clone()], Arc::new(|| {}));
    wait_until(&mut ui, "the lessons", |ui| !ui.state().is_busy());
    drop(ui);
    std::fs::remove_file(mine).unwrap();
    let lessons = home.path().join("lessons");
    std::fs::write(
        lessons.join("wrong.json"),
        text.replacen("\"say\"", "\"sya\"", 1),
    )
    .unwrap();
    let mut ui = kept_in(home.path(), Page::Lessons);
    assert!(
        ui.query_by_label("Lesson: Mine: where samples go wrong")
            .is_some()
    );
    assert_written(&ui, "wrong.json: step 1: found the field `sya`");
    assert_written(&ui, &lessons.display().to_string());
    click(&mut ui, "Open");
    click(&mut ui, "Folder of your lessons");
    assert_written(&ui, &format!("Copied: {}", lessons.display()));
}

#[test]
fn a_shipped_lesson_is_written_out_as_a_start() {
    let folder = tempfile::tempdir().unwrap();
    let path: PathBuf = folder.path().join("my.json");
    let picked = path.clone();
    let picker = Arc::new(move |_: &_| Picked::Paths(vec![picked.clone()]));
    let preferences = Preferences {
        page: Page::Teachers,
        ..Preferences::default()
    };
    let mut ui = at_rest(Window::new(App::new(), preferences, picker, None));
    click(&mut ui, "Copy as a start");
    wait_until(&mut ui, "the file", |ui| is_written(ui, "Saved "));
    let text = std::fs::read_to_string(&path).unwrap();
    assert_eq!(text, shelf::shipped()[0].text);
}

#[test]
fn another_lamp_is_tried_and_the_claims_that_fail_are_told() {
    let mut ui = at(Page::Teachers);
    let number = shelf::shipped().iter().position(|l| l.name == "samples");
    let title = format!("{}. Where samples go wrong", number.unwrap() + 1);
    click(&mut ui, &title);
    for (light, verdict) in [
        ("FL3", "With FL3 everything holds"),
        ("CIE D65", "With CIE D65, 1 of 2 steps fails."),
    ] {
        ui.get_by_role_and_label(Role::ComboBox, "Try another lamp")
            .click();
        ui.run();
        ui.event(egui::Event::Text(light.to_owned()));
        ui.run();
        click(&mut ui, light);
        wait_until(&mut ui, verdict, |ui| is_written(ui, verdict));
    }
    assert_written(&ui, "Step 1: its claim does not hold");
}

#[test]
fn the_bottom_line_leads_to_the_lesson_about_a_page_and_back_to_the_page() {
    let mut ui = at(Page::Prism);
    click(&mut ui, "Lesson about this page");
    assert_written(&ui, "Step 1 of 3");
    assert!(ui.query_by_label("Lesson about this page").is_none());
    click(&mut ui, "Leave the lesson");
    assert_eq!(ui.state().preferences.page, Page::Prism);
    let mut ui = at(Page::Spectrum);
    click(&mut ui, "Lesson about this page");
    assert_written(&ui, "Draw a lamp with waves");
}

#[test]
fn a_word_of_the_glossary_opens_beside_the_lesson_and_comes_back_to_it() {
    let mut ui = at(Page::Lessons);
    begun(&mut ui, &shelf::named("light").expect("shipped"), 0);
    let before = app(&ui).document().clone();
    let means = "A body that absorbs all light, so that what it sends out";
    for closes in [None, Some(Key::Escape)] {
        assert!(!is_written(&ui, means));
        ui.get_by_role_and_label(egui::accesskit::Role::Link, "Glossary: Black body")
            .click();
        ui.run();
        assert_written(&ui, means);
        let card = place(&ui, means).expect("a card");
        let column = place(&ui, "Leave the lesson").expect("a column");
        assert!(card.left() > column.right(), "beside the lesson");
        match closes {
            None => click(&mut ui, "Back to the lesson"),
            Some(key) => press(&mut ui, key),
        }
        assert!(!is_written(&ui, means));
        assert_written(&ui, "Step 1 of 4");
        assert!(*app(&ui).document() == before);
    }
    // The whole sentence is one text for who hears it.
    assert_written(
        &ui,
        "This is the light of a tungsten bulb: its power at each wavelength",
    );
}

#[test]
fn presenting_enlarges_the_lessons_own_page_and_stays_through_its_steps() {
    let lesson = shelf::named("filters").expect("shipped");
    let mut ui = at(Page::Lessons);
    begun(&mut ui, &lesson, 0);
    press(&mut ui, Key::F5);
    assert!(ui.state().preferences.presents());
    assert_eq!(ui.state().preferences.page, Page::Chain);
    assert!(
        place(&ui, "Move down step 1").is_some(),
        "the cards to swap"
    );
    assert_written(&ui, "Step 1 of 3");
    press(&mut ui, Key::ArrowRight);
    assert!(ui.state().preferences.presents());
    assert_written(&ui, "Step 2 of 3");
    press(&mut ui, Key::F5);
    assert!(!ui.state().preferences.presents());
    assert_eq!(ui.state().preferences.page, Page::Chain);
    assert_written(&ui, "Step 2 of 3");
}

#[test]
fn a_lesson_of_ones_own_is_removed_and_its_file_is_kept() {
    let (home, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let text = &shelf::named("samples").expect("shipped").text;
    let mine = other.path().join("mine.json");
    std::fs::write(&mine, text.replace("Where samples", "Mine: where samples")).unwrap();
    let mut ui = kept_in(home.path(), Page::Spectrum);
    ui.state_mut().open_files(vec![mine], Arc::new(|| {}));
    wait_until(&mut ui, "the lessons", |ui| !ui.state().is_busy());
    ui.get_by_label("Remove the lesson Mine: where samples go wrong")
        .scroll_to_me();
    watch(&mut ui);
    click(&mut ui, "Remove the lesson Mine: where samples go wrong");
    assert!(
        ui.query_by_label("Lesson: Mine: where samples go wrong")
            .is_none()
    );
    assert_written(&ui, "Mine: where samples go wrong was removed");
    let lessons = home.path().join("lessons");
    assert!(!lessons.join("mine.json").exists());
    let kept = std::fs::read_to_string(lessons.join("mine.json.removed")).unwrap();
    assert!(kept.contains("Mine: where samples"));
    drop(ui);
    let ui = kept_in(home.path(), Page::Lessons);
    assert!(
        ui.query_by_label("Lesson: Mine: where samples go wrong")
            .is_none()
    );
}

#[test]
fn a_dropped_lesson_tells_all_its_faults_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = &shelf::named("samples").expect("shipped").text;
    let path = folder.path().join("wrong.json");
    std::fs::write(&path, text.replace("\"say\"", "\"sya\"")).unwrap();
    let mut ui = at(Page::Spectrum);
    ui.state_mut().open_files(vec![path], Arc::new(|| {}));
    wait_until(&mut ui, "the check", |ui| !ui.state().is_busy());
    let said: Vec<String> = app(&ui).messages().iter().map(|m| m.text.clone()).collect();
    for step in ["step 1", "step 2"] {
        let fault = format!("{step}: found the field `sya`");
        assert!(said.iter().any(|words| words.contains(&fault)), "{said:?}");
    }
}
