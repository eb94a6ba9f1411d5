//! Every shipped lesson taken by hand in the window: each wrong answer, the task with mouse and keys,
//! a drag too far, Reset, F5 and the way back; and the lesson that takes a class's own photograph.

use eframe::egui::{self, Key, Role};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        lessons::{Lesson, Scene, Step, Wanted, shelf},
        pages::Page,
    },
    ui::{look_view::names as knobs, pages::photograph_view::names, theme::waker},
};

use crate::{
    driver::{Ui, app, assert_written, click, is_written, settle, words},
    lessons::{at, begun, place, press},
    root::root,
};

/// What a stage sets, as far as it tells two states of a step apart.
fn set(ui: &Ui) -> (String, Page, String) {
    let document = app(ui).document();
    let chain = document.products.chain.iter();
    let chain: Vec<_> = chain
        .map(|link| (link.entry.name(), link.times()))
        .collect();
    let over: Vec<&str> = document.laid_over().map(|one| one.name()).collect();
    let whole = format!("{:?} {chain:?} {over:?}", document.settings);
    (
        document.light.name().to_owned(),
        ui.state().preferences.page,
        whole,
    )
}

/// The program shows a task until it is done.
fn watch_until_done(ui: &mut Ui) {
    for _ in 0..60 {
        if is_written(ui, "✔") {
            return;
        }
        ui.state_mut().studies.finish();
        (0..10).for_each(|_| ui.step());
    }
}

/// Opens the library with a button and takes the first that a name finds.
fn choose(ui: &mut Ui, opener: &str, name: &str) {
    let buttons = ui.query_all_by_role(Role::Button);
    let called = |node: &egui_kittest::Node<'_>| {
        let label = egui_kittest::kittest::NodeT::accesskit_node(node).label();
        label.is_some_and(|label| label.starts_with(opener))
    };
    let button = buttons.into_iter().find(called);
    button.unwrap_or_else(|| panic!("no {opener}")).click();
    ui.run();
    let short = name.rsplit('/').next().unwrap_or(name);
    ui.event(egui::Event::Text(short.to_owned()));
    ui.run();
    press(ui, Key::Enter);
    ui.run();
}

/// Does a task as its words say; whether a hand did it.
fn done_by_hand(ui: &mut Ui, step: &Step) -> bool {
    let Some(task) = &step.task else { return false };
    let control = step.point.as_ref().and_then(|point| point.control());
    match (&task.until[0].wanted, control) {
        (Wanted::Light(name), _) => choose(ui, "Library", name),
        (Wanted::Overlay(name), _) => choose(ui, "+ Compare", name),
        (_, Some(name)) if [knobs::ORDER, knobs::LINES, "Centre"].contains(&name) => {
            ui.get_by_role_and_label(Role::Slider, name).focus();
            ui.run();
            // Most tasks move it to the right, some from there to the left.
            for (key, most) in [(Key::ArrowRight, 100), (Key::ArrowLeft, 300)] {
                for _ in 0..most {
                    if is_written(ui, "✔") {
                        break;
                    }
                    press(ui, key);
                }
            }
        }
        (Wanted::Chain(_), Some(name)) => click(ui, name),
        (Wanted::Figure(key), Some(name)) if key == "dip_count" => {
            ui.get_by_role_and_label(Role::CheckBox, name).click();
            ui.run();
        }
        _ => return false,
    }
    is_written(ui, "✔")
}

/// Takes a step by hand in every way; whether its task, if any, was done so.
fn take(ui: &mut Ui, lesson: &Lesson, index: usize) -> bool {
    let set_back = "What is shown has changed since";
    let (step, what) = (
        &lesson.steps[index],
        format!("{}, step {}", lesson.name, index + 1),
    );
    begun(ui, lesson, index);
    ui.state_mut().studies.finish();
    ui.run();
    let page = ui.state().preferences.page;
    let begun_with = set(ui);
    let answers = step.ask.iter().flat_map(|ask| &ask.answers);
    let is_open = step.ask.as_ref().is_some_and(|ask| ask.open);
    let keys = [Key::Num1, Key::Num2, Key::Num3, Key::Num4];
    let wrong = answers.enumerate().filter(|(_, answer)| !answer.right);
    for (place, answer) in wrong {
        press(ui, keys[place]);
        if step.task.is_some() {
            assert!(!is_written(ui, "✘"), "{what}: told before the task");
            press(ui, Key::Space);
            watch_until_done(ui);
        }
        assert_eq!(is_written(ui, "✘"), !is_open, "{what}: a wrong answer");
        if !answer.because.contains('{') {
            let because = &answer.because;
            assert!(is_written(ui, because), "{what}: {because}");
        }
        click(ui, "Back to the step");
        assert!(
            !is_written(ui, "✘") && !is_written(ui, "✔"),
            "{what}: Reset begins it again"
        );
        assert!(set(ui) == begun_with, "{what}: as it began");
    }
    // A task that hands do on the page is done behind the veil, too.
    if let Some(right) = step.ask.as_ref().filter(|_| step.veil) {
        let place = right.answers.iter().position(|answer| answer.right);
        press(ui, keys[place.unwrap_or(0)]);
    }
    let mut by_hand = true;
    if step.task.is_some() {
        by_hand = done_by_hand(ui, step);
        if !by_hand {
            // A slider that was moved has the keys.
            click(ui, "Show me");
            watch_until_done(ui);
        }
        let shown = || words(ui).join(" | ");
        assert!(is_written(ui, "✔"), "{what}: not done: {}", shown());
        assert!(!is_written(ui, set_back), "{what}: its reason fits");
        let control = step.point.as_ref().and_then(|point| point.control());
        let slides = |name: &&str| [knobs::ORDER, knobs::LINES, "Centre"].contains(name);
        if let Some(slider) = control.filter(slides) {
            ui.get_by_role_and_label(Role::Slider, slider).focus();
            ui.run();
            (0..25).for_each(|_| press(ui, Key::ArrowRight));
            let scene = Scene {
                app: app(ui),
                page: ui.state().preferences.page,
            };
            let holds = step.holds(&scene);
            assert_eq!(is_written(ui, set_back), !holds, "{what}: too far");
            assert!(is_written(ui, "✔"), "{what}: what was done was done");
        }
        click(ui, "Back to the step");
        assert!(set(ui) == begun_with, "{what}: Reset after the task");
        assert!(!is_written(ui, "✔"), "{what}: not done any more");
    }
    press(ui, Key::F5);
    assert!(ui.state().preferences.presents(), "{what}: F5");
    assert_eq!(ui.state().preferences.page, page, "{what}: F5");
    let of = lesson.steps.len();
    assert_written(ui, &format!("Step {} of {of}", index + 1));
    press(ui, Key::F5);
    assert_eq!(ui.state().preferences.page, page, "{what}: F5 again");
    if index > 0 {
        click(ui, "Back");
        assert_written(ui, &format!("Step {index} of {of}"));
    }
    by_hand
}

/// Takes every fourth lesson.
fn take_lessons(first: usize) {
    // Faders and numbers that are typed: the program shows them.
    const SHOWN: [(&str, usize); 8] = [
        ("samples", 0),
        ("quality", 0),
        ("filters", 1),
        ("white", 0),
        ("white", 1),
        ("spend", 0),
        ("room", 2),
        ("waves", 1),
    ];
    for lesson in shelf::shipped().iter().skip(first).step_by(4) {
        let mut ui = at(Page::Lessons);
        for index in 0..lesson.steps.len() {
            let by_hand = take(&mut ui, lesson, index);
            let is_shown = SHOWN.contains(&(lesson.name.as_str(), index));
            assert!(by_hand || is_shown, "{}, step {}", lesson.name, index + 1);
        }
    }
}

#[test]
fn every_lesson_is_taken_by_hand_the_first_quarter() {
    take_lessons(0);
}

#[test]
fn every_lesson_is_taken_by_hand_the_second_quarter() {
    take_lessons(1);
}

#[test]
fn every_lesson_is_taken_by_hand_the_third_quarter() {
    take_lessons(2);
}

#[test]
fn every_lesson_is_taken_by_hand_the_fourth_quarter() {
    take_lessons(3);
}

#[test]
fn the_next_step_finds_the_library_shut_and_its_search_empty() {
    let lesson = shelf::named("gas").expect("shipped");
    let mut ui = at(Page::Lessons);
    begun(&mut ui, &lesson, 1);
    for next in ["Next", "Back"] {
        choose(&mut ui, "+ Compare", "no such tube");
        assert_written(&ui, "Close the library");
        click(&mut ui, next);
        assert!(!is_written(&ui, "Close the library"), "{next}");
        assert!(!is_written(&ui, "no such tube"), "{next}");
    }
}

#[test]
fn who_has_finished_takes_the_lesson_again_with_another_of_its_lights() {
    let lesson = shelf::named("samples").expect("shipped");
    let mut ui = at(Page::Lessons);
    begun(&mut ui, &lesson, lesson.steps.len() - 1);
    let light = &lesson.also[1];
    assert!(!is_written(&ui, "Take the lesson again with"));
    press(&mut ui, Key::Num1);
    assert_written(&ui, "Take the lesson again with");
    assert!(!is_written(&ui, "Try another lamp"));
    ui.get_by_role_and_label(Role::Button, light).scroll_to_me();
    (0..60).for_each(|_| ui.step());
    click(&mut ui, light);
    assert_written(&ui, "Step 1 of 2");
    assert_eq!(app(&ui).document().light.name(), light);
    click(&mut ui, "Next");
    press(&mut ui, Key::Num2);
    click(&mut ui, "Finish");
    assert_eq!(ui.state().preferences.lessons_finished, ["samples"]);
}

#[test]
fn a_lesson_without_a_model_shows_surfaces_whole() {
    let lesson = shelf::named("gas").expect("shipped");
    let mut ui = at(Page::Lessons);
    // The lines of hydrogen are not what waves of order 7 make of them.
    begun(&mut ui, &lesson, 0);
    press(&mut ui, Key::Num1);
    assert!(!is_written(&ui, "ΔE₀₀") && !is_written(&ui, "measured | model"));
    assert_written(&ui, "dark skin: #");
    let lesson = shelf::named("colour").expect("shipped");
    begun(&mut ui, &lesson, 0);
    assert_written(&ui, "dark skin: ΔE₀₀");
}

#[test]
fn a_ring_is_around_a_slider_and_not_around_the_words_that_name_it() {
    let lesson = shelf::named("samples").expect("shipped");
    let mut ui = at(Page::Lessons);
    begun(&mut ui, &lesson, 0);
    press(&mut ui, Key::Num1);
    (0..4).for_each(|_| ui.step());
    let slider = ui.get_by_role_and_label(Role::Slider, "Centre").rect();
    let label = place(&ui, "Here: drag it onto the green line").expect("a ring");
    assert!(label.contains_rect(slider), "{label} {slider}");
}

#[test]
fn a_class_takes_its_own_photograph_which_reset_puts_aside_and_the_end_gives_back() {
    let golden = |name: &str| root().join("tests/golden/photographs/pictures").join(name);
    let lesson = shelf::named("room").expect("shipped");
    let mut ui = at(Page::Photograph);
    let open = |ui: &mut Ui, name: &str| {
        let wake = waker(&ui.ctx);
        ui.state_mut().open_files(vec![golden(name)], wake);
        settle(ui);
    };
    open(&mut ui, "16.jpg");
    assert_written(&ui, "Picture 16.jpg");
    begun(&mut ui, &lesson, 0);
    settle(&mut ui);
    assert_written(&ui, "Picture an example");
    begun(&mut ui, &lesson, 2);
    settle(&mut ui);
    assert!(!is_written(&ui, "Picture ") && !is_written(&ui, "✔"));
    assert_written(&ui, "Lines that are known: 0 (aim: above 4)");
    // A light without lines has no wavelengths to tell.
    open(&mut ui, "inst0_led.jpg");
    assert_written(&ui, "Picture inst0_led.jpg");
    assert!(!is_written(&ui, "✔"));
    press(&mut ui, Key::Num1);
    open(&mut ui, "inst0_cfl.jpg");
    assert_written(&ui, "✔");
    let lines = app(&ui).photograph().and_then(|found| {
        let best = found.answer.as_ref()?.best.as_ref()?;
        Some(best.matches.len())
    });
    let told = format!("{} lines give this picture", lines.expect("an axis"));
    assert_written(&ui, &told);
    click(&mut ui, "Back to the step");
    settle(&mut ui);
    assert!(!is_written(&ui, "✔") && !is_written(&ui, "Picture "));
    click(&mut ui, names::OWN);
    settle(&mut ui);
    assert_written(&ui, "Picture inst0_cfl.jpg");
    assert_written(&ui, "✔");
    click(&mut ui, "Next");
    settle(&mut ui);
    let own = app(&ui)
        .document()
        .own
        .last()
        .cloned()
        .expect("one is made");
    assert_eq!(own.name(), "From the photograph");
    assert_eq!(own.spectrum.source, "inst0_cfl.jpg");
    click(&mut ui, "Leave the lesson");
    settle(&mut ui);
    assert_written(&ui, "Picture inst0_cfl.jpg");
    assert!(app(&ui).document().own.is_empty());
}
