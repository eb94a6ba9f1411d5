//! The page "Live" in the real window, driven without a display.

use std::{
    fs,
    io::Write as _,
    net::{Ipv4Addr, TcpListener, TcpStream},
    path::{Path, PathBuf},
    sync::Arc,
};

use eframe::egui;
use egui::{Key, Role};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{
        Command, Entry,
        chart::Marks,
        charts::spectrum::spectrum_chart,
        following::{Asked, FollowAsked, is_capture},
        pages::{AskedLesson, Page},
        workspace::Preferences,
    },
    streams::Pace,
    ui::{
        Window,
        files::{Ask, Picked, Picker},
        pages::live_view::names,
    },
};

use crate::driver::{
    Shown, Ui, app, assert_written, at_rest, click, harness, is_written, no_files, wait_until,
};
use crate::plain::plain;

/// A line with a light on whole nm.
fn line_of(time_ms: f64, value: impl Fn(f64) -> f64) -> String {
    let nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let values: Vec<f64> = nm.iter().map(|nm| value(*nm)).collect();
    format!(
        "{{\"time_ms\":{time_ms},\"wavelength_nm\":{nm:?},\"values\":{values:?},\
         \"unit\":\"W m-2 nm-1\"}}\n"
    )
}

/// The same with a glow and a line of mercury, all times a factor.
fn line(time_ms: f64, factor: f64) -> String {
    line_of(time_ms, |nm| {
        let green = 5.0 * (-((nm - 546.1) / 2.0).powi(2)).exp();
        factor * (1.0 + 0.002 * (nm - 380.0) + green)
    })
}

fn window(files: Picker) -> Ui {
    let mut window = Window::new(plain(), Preferences::default(), files, None);
    window.preferences.page = Page::Live;
    at_rest(window)
}

fn follow(ui: &mut Ui, source: Asked) {
    let context = ui.ctx.clone();
    ui.state_mut()
        .0
        .follow_light(FollowAsked::new(source), &context);
    ui.step();
}

/// The value of the light at 400 nm.
fn at_400(ui: &Ui) -> f64 {
    app(ui).document().light.spectrum.samples.values()[20]
}

fn wait_for_factor(ui: &mut Ui, factor: f64) {
    let wanted = factor * 1.04;
    let words = format!("the frame times {factor}");
    wait_until(ui, &words, |ui| (at_400(ui) / wanted - 1.0).abs() < 1e-9);
}

/// Puts a whole file in the place of another at once, as instruments' programs should.
fn put(path: &Path, text: &str) {
    let beside = path.with_extension("new");
    fs::write(&beside, text).expect("written");
    fs::rename(beside, path).expect("renamed");
}

fn captures(ui: &Ui) -> Vec<Arc<Entry>> {
    let own = app(ui).document().own.iter();
    own.filter(|entry| is_capture(entry)).cloned().collect()
}

#[test]
fn a_file_that_is_followed_is_the_light_of_every_page_and_no_frame_is_a_step() {
    let folder = tempfile::tempdir().expect("a folder");
    let meter = folder.path().join("meter.jsonl");
    fs::write(&meter, line(0.0, 1.0)).expect("written");
    let mut ui = window(no_files());
    let first = app(&ui).document().light.clone();
    follow(&mut ui, Asked::Path(meter.clone()));
    wait_for_factor(&mut ui, 1.0);
    assert_written(&ui, "meter: CCT");
    for factor in [2.0, 3.0] {
        put(&meter, &line(0.0, factor));
        wait_for_factor(&mut ui, factor);
    }
    // What is derived follows.
    let derived = app(&ui).derived().clone();
    assert!((derived.measured[20] / 3.12 - 1.0).abs() < 1e-9);
    // On another page a bar tells how it stands.
    ui.state_mut().0.preferences.page = Page::Quality;
    ui.run();
    assert_written(&ui, "meter.jsonl: ");
    put(&meter, &line(0.0, 4.0));
    wait_for_factor(&mut ui, 4.0);
    // One step: it became the light. It stays in the library, and goes on there.
    ui.state_mut().0.app.apply(Command::Undo);
    ui.run();
    assert_eq!(app(&ui).document().light, first);
    assert!(app(&ui).undo_words().is_none());
    let own = app(&ui).document().own.clone();
    assert_eq!(own.len(), 1);
    assert_eq!(own[0].name(), "meter");
    assert!((own[0].spectrum.samples.values()[20] / 4.16 - 1.0).abs() < 1e-9);
    click(&mut ui, "Live");
    click(&mut ui, names::SHOW);
    assert_eq!(app(&ui).document().light.key, own[0].key);
    // A file that is gone is told, and its last light stays.
    fs::remove_file(&meter).expect("removed");
    wait_until(&mut ui, "what is said of it", |ui| {
        is_written(ui, "the last spectrum stays")
    });
    assert!((at_400(&ui) / 4.16 - 1.0).abs() < 1e-9);
    click(&mut ui, names::STOP);
    assert_written(&ui, "Follow a light that changes");
    assert_eq!(app(&ui).document().own.len(), 1);
}

#[test]
fn space_holds_and_enter_captures_and_undo_knows_captures() {
    let folder = tempfile::tempdir().expect("a folder");
    let meter = folder.path().join("meter.jsonl");
    fs::write(&meter, line(61_000.0, 1.0)).expect("written");
    let mut ui = window(no_files());
    ui.key_press(Key::Enter);
    ui.run();
    assert!(captures(&ui).is_empty());
    follow(&mut ui, Asked::Path(meter.clone()));
    wait_for_factor(&mut ui, 1.0);
    ui.key_press(Key::Space);
    ui.run();
    assert_written(&ui, "Held at 0:01:01.0; nothing came since.");
    // The picture says so itself, and its course where it stopped.
    assert_written(&ui, "meter, held at 0:01:01.0");
    put(&meter, &line(62_000.0, 2.0));
    wait_until(&mut ui, "what came since", |ui| {
        is_written(ui, "1 spectrum came since")
    });
    assert!((at_400(&ui) / 1.04 - 1.0).abs() < 1e-9, "held");
    ui.key_press(Key::Enter);
    ui.run();
    ui.key_press(Key::Space);
    wait_for_factor(&mut ui, 2.0);
    ui.key_press(Key::Enter);
    ui.run();
    let names: Vec<String> = captures(&ui).iter().map(|e| e.name().to_owned()).collect();
    assert_eq!(names, ["meter at 0:01:01.0", "meter at 0:01:02.0"]);
    // They are beside the light, which is the stream's still.
    assert_eq!(app(&ui).document().light.name(), "meter");
    assert_written(&ui, "Captured: meter at 0:01:02.0");
    ui.state_mut().0.app.apply(Command::Undo);
    ui.run();
    assert_eq!(captures(&ui).len(), 1);
    assert_eq!(app(&ui).document().light.name(), "meter");
    // A click on one shows it everywhere, and the stream goes on beside it.
    click(&mut ui, "Captured: meter at 0:01:01.0");
    assert_eq!(app(&ui).document().light.name(), "meter at 0:01:01.0");
    assert!(is_written(&ui, names::SHOW));
}

#[test]
fn dark_reference_and_peaks_are_of_the_stream_and_average_is_a_knob() {
    let folder = tempfile::tempdir().expect("a folder");
    let meter = folder.path().join("meter.jsonl");
    fs::write(&meter, line(0.0, 1.0)).expect("written");
    let mut ui = window(no_files());
    follow(&mut ui, Asked::Path(meter.clone()));
    wait_for_factor(&mut ui, 1.0);
    click(&mut ui, names::DARK);
    put(&meter, &line(1000.0, 3.0));
    // 3 less 1.
    wait_for_factor(&mut ui, 2.0);
    click(&mut ui, names::DARK);
    wait_for_factor(&mut ui, 3.0);
    click(&mut ui, names::PEAK);
    put(&meter, &line(2000.0, 1.0));
    wait_for_factor(&mut ui, 1.0);
    assert_written(&ui, "highest so far");
    click(&mut ui, names::REFERENCE);
    put(&meter, &line(3000.0, 0.5));
    wait_until(&mut ui, "a transmittance", |ui| {
        let subject = app(ui).document().subject_entry();
        (subject.spectrum.samples.values()[20] - 0.5).abs() < 1e-9
    });
    assert!(app(&ui).document().subject_entry().kind().is_factor());
    click(&mut ui, names::REFERENCE);
    wait_for_factor(&mut ui, 0.5);
    assert!(app(&ui).document().is_about_light());
    let field = ui.get_by_role_and_label(Role::SpinButton, "Average");
    field.set_value_accesskit(2.0);
    ui.run();
    assert_eq!(app(&ui).document().pages.live.average, 2);
    put(&meter, &line(4000.0, 1.5));
    // The mean of the newest two.
    wait_for_factor(&mut ui, 1.0);
}

#[test]
fn nothing_listens_before_it_is_asked_for_and_a_producer_that_goes_is_told() {
    let port = {
        let free = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("a free port");
        free.local_addr().expect("its address").port()
    };
    let connect = || TcpStream::connect((Ipv4Addr::LOCALHOST, port));
    let mut ui = window(no_files());
    let field = ui.get_by_role_and_label(Role::SpinButton, names::PORT);
    field.set_value_accesskit(f64::from(port));
    ui.run();
    assert!(connect().is_err(), "it listens already");
    click(&mut ui, names::LISTEN);
    wait_until(&mut ui, "an open port", |ui| {
        is_written(ui, &format!("127.0.0.1:{port}"))
    });
    // What to send is told, and what needs a spectrum waits for one.
    assert_written(&ui, "A line is one spectrum");
    for name in [names::HOLD, names::CAPTURE, names::DARK, names::REFERENCE] {
        let button = ui.get_by_role_and_label(Role::Button, name);
        assert!(button.accesskit_node().is_disabled(), "{name}");
    }
    let mut producer = connect().expect("it listens");
    producer
        .write_all(format!("no numbers\n{}", line(0.0, 2.0)).as_bytes())
        .expect("sent");
    wait_for_factor(&mut ui, 2.0);
    assert_written(&ui, "1 broken line skipped");
    drop(producer);
    wait_until(&mut ui, "the producer's end", |ui| {
        is_written(ui, "The producer is gone: the last spectrum stays")
    });
    assert_written(&ui, &format!("may connect to 127.0.0.1:{port}."));
    assert!((at_400(&ui) / 2.08 - 1.0).abs() < 1e-9);
    click(&mut ui, names::STOP);
    wait_until(&mut ui, "a closed port", |_| connect().is_err());
}

#[test]
fn a_recording_is_played_with_what_is_clipped_and_its_course() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("run.jsonl");
    let frames = (0..50).map(|i| line(100.0 * f64::from(i), 1.0 + f64::from(i)));
    let nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let cut: Vec<f64> = nm
        .iter()
        .map(|nm| (40.0 * (nm - 380.0)).min(4095.0).floor())
        .collect();
    let last = format!("{{\"time_ms\":5000,\"wavelength_nm\":{nm:?},\"values\":{cut:?}}}\n");
    fs::write(&path, frames.chain([last]).collect::<String>()).expect("written");
    let picked: PathBuf = path.clone();
    let picker: Picker = Arc::new(move |ask: &Ask| {
        assert_eq!(*ask, Ask::Open);
        Picked::Paths(vec![picked.clone()])
    });
    let mut ui = window(picker);
    click(&mut ui, "at once");
    click(&mut ui, names::RECORDING);
    wait_until(&mut ui, "its end", |ui| is_written(ui, "It has ended"));
    assert_written(&ui, "Clipped at 483 to 780 nm");
    assert_written(&ui, "counts, not light");
    assert_written(
        &ui,
        "Waterfall: wavelengths from left to right, 0:00:00.0 above",
    );
    ui.get_by_role_and_label(Role::CheckBox, names::AS_LIGHT)
        .click();
    ui.run();
    // A recording that is not there is told in words.
    click(&mut ui, names::STOP);
    follow(
        &mut ui,
        Asked::Replay(folder.path().join("gone.jsonl"), Pace::Stepped),
    );
    wait_until(&mut ui, "a refusal", |ui| {
        is_written(ui, "Nothing is followed: ")
    });
    assert_written(&ui, "no such file");
}

/// What stands over the lines of the first screen's chart.
fn labels_of_lines(ui: &Ui) -> Vec<String> {
    let chart = spectrum_chart(app(ui));
    let labels = chart
        .series
        .into_iter()
        .filter_map(|series| match series.marks {
            Marks::Stems { labels, .. } => Some(labels),
            _ => None,
        });
    labels.flatten().collect()
}

#[test]
fn counts_are_judged_as_a_light_nowhere_until_a_person_takes_them_for_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let sensor = folder.path().join("sensor.jsonl");
    let nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let value = |nm: f64| 1.0 + 0.002 * (nm - 380.0) + 5.0 * (-((nm - 546.1) / 2.0).powi(2)).exp();
    let values = nm.iter().map(|nm| (600.0 * value(*nm)).floor());
    let values: Vec<f64> = values.collect();
    // No unit tells it: the whole numbers do.
    let counts = format!("{{\"wavelength_nm\":{nm:?},\"values\":{values:?}}}\n");
    fs::write(&sensor, counts).expect("written");
    let mut ui = window(no_files());
    follow(&mut ui, Asked::Path(sensor));
    wait_until(&mut ui, "the counts", |ui| {
        is_written(ui, "sensor: counts, not light")
    });
    let judged = ["To the eye: ", "White", "Colour: measured", "look alike"];
    for page in [Page::Live, Page::Spectrum] {
        ui.state_mut().0.preferences.page = page;
        ui.run();
        assert_written(
            &ui,
            "Counts, not light: the instrument's response is still in it.",
        );
        // The shape is compared all the same.
        assert_written(&ui, "To an instrument: ");
        for words in judged {
            assert!(!is_written(&ui, words), "{page:?}: {words}");
        }
        // Lines have their places, and no powers.
        let labels = labels_of_lines(&ui);
        assert!(!labels.is_empty());
        for label in labels {
            assert!(label.contains("54") && !label.contains('%'), "{label}");
        }
    }
    ui.state_mut().0.preferences.page = Page::Live;
    ui.run();
    assert_written(&ui, "a course begins with the first spectrum of a light");
    ui.get_by_role_and_label(Role::CheckBox, names::AS_LIGHT)
        .click();
    wait_until(&mut ui, "its figures", |ui| is_written(ui, "sensor: CCT"));
    for words in judged {
        assert_written(&ui, words);
    }
    let labels = labels_of_lines(&ui);
    assert!(labels[0].ends_with("% of the power"), "{labels:?}");
    // They stay marked where the spectrum is told.
    ui.state_mut().0.preferences.page = Page::Spectrum;
    ui.run();
    assert_written(&ui, "These may be counts, not light");
}

#[test]
fn a_step_of_a_lesson_waits_for_a_figure_of_the_light_that_is_followed() {
    let folder = tempfile::tempdir().expect("a folder");
    let lesson = folder.path().join("warm.json");
    let text = r#"{"format":"spectral-explorer-lesson","version":1,"title":"Warm","sentence":"S.",
        "minutes":5,"audience":["school"],"language":"en","teaches":"A.","remember":"R.",
        "next":"N.","notes_for_teachers":"","steps":[{"say":"Follow your instrument.",
        "stage":{"light":"FL2","page":"live"},"task":{"words":"Bring a warm lamp.",
        "until":[{"figure":"cct","of":"live","below":4000}],"show":[{"replay":["CIE A"]}]},
        "explain":"Your lamp has {cct of live}."}]}"#;
    fs::write(&lesson, text).expect("written");
    let mut ui = window(no_files());
    let asked = AskedLesson {
        name: lesson.display().to_string(),
        step: 0,
        done: false,
    };
    ui.state_mut().0.preferences.lesson_asked = Some(asked);
    ui.run();
    assert_written(&ui, "Bring a warm lamp.");
    let meter = folder.path().join("meter.jsonl");
    fs::write(&meter, line_of(0.0, |_| 1.0)).expect("written");
    follow(&mut ui, Asked::Path(meter.clone()));
    wait_until(&mut ui, "the first light", |ui| {
        is_written(ui, "meter: CCT")
    });
    // An even light has 5455 K.
    assert!(!is_written(&ui, "Your lamp has"));
    put(&meter, &line_of(0.0, |nm| (nm - 370.0) / 100.0));
    wait_until(&mut ui, "the task to be done", |ui| {
        is_written(ui, "Your lamp has ")
    });
}

#[test]
fn the_page_has_room_in_every_window_and_is_presented_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("run.jsonl");
    let frames = (0..30).map(|i| line(1000.0 * f64::from(i), 1.0 + f64::from(i)));
    fs::write(&path, frames.collect::<String>()).expect("written");
    for (size, presents) in [([1000.0, 700.0], false), ([1280.0, 800.0], true)] {
        let preferences = Preferences {
            page: Page::Live,
            present: presents,
            follow_asked: Some(FollowAsked::new(Asked::Replay(path.clone(), Pace::Stepped))),
            ..Preferences::default()
        };
        let mut window = Window::new(plain(), preferences, no_files(), None);
        window.quiet = true;
        let mut ui = harness(Shown(window), size, 0.02, 40);
        ui.run();
        assert_written(&ui, "run: CCT");
        let hold = ui.get_by_role_and_label(Role::Button, names::HOLD).rect();
        assert!(
            hold.right() <= size[0] && hold.bottom() <= size[1],
            "{hold:?}"
        );
        // What is over time begins in sight, however large the type.
        let course = ui.get_by_role_and_label(Role::Button, names::SAVE).rect();
        assert!(course.bottom() <= size[1], "{course:?}");
    }
}
