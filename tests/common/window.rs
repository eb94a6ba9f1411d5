//! The window as the whole of a program, and a hand that works it without a display.

use std::{
    ops::{Deref, DerefMut},
    sync::Arc,
    time::{Duration, Instant},
};

use eframe::egui;
use egui::Role;
use egui_kittest::{
    Harness, HarnessBuilder,
    kittest::{NodeT as _, Queryable as _},
};
use spectral_explorer::{
    app::{App, Command, Settings, open::resolve},
    ui::{
        Window,
        files::{Picked, Picker},
        theme,
    },
};

/// The window from edge to edge.
pub(crate) struct Shown(pub Window);

impl eframe::App for Shown {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        self.0.show(ui);
    }
}

impl Deref for Shown {
    type Target = Window;

    fn deref(&self) -> &Window {
        &self.0
    }
}

impl DerefMut for Shown {
    fn deref_mut(&mut self) -> &mut Window {
        &mut self.0
    }
}

pub(crate) type Ui = Harness<'static, Shown>;

/// Far beyond what a small file takes to read or write, or a study to end.
pub(crate) const LONGEST_WAIT: Duration = Duration::from_secs(120);

/// Every dialog is cancelled.
pub(crate) fn no_files() -> Picker {
    Arc::new(|_| Picked::Cancelled)
}

/// A display: `frame` s of the program pass between two frames (0.02 makes two clicks a double
/// click), and it must come to rest within `most` of them (a tooltip comes after 0.35 s).
pub(crate) fn display<S>(size: [f32; 2], frame: f32, most: u64) -> HarnessBuilder<S> {
    Harness::builder()
        .with_size(size)
        .with_step_dt(frame)
        .with_max_steps(most)
        .with_context_setup(theme::install_fonts)
}

/// Something in place of the program's window, not yet drawn, on a [`display`].
pub(crate) fn harness<S: eframe::App + 'static>(
    shown: S,
    size: [f32; 2],
    frame: f32,
    most: u64,
) -> Harness<'static, S> {
    display(size, frame, most).build_eframe(|_| shown)
}

/// A window of 1280 x 800 points at rest.
pub(crate) fn at_rest(window: Window) -> Ui {
    let mut ui = harness(Shown(window), [1280.0, 800.0], 0.02, 40);
    ui.run();
    ui
}

/// A program that shows a spectrum.
pub(crate) fn about(key: &str) -> App {
    let mut app = App::new();
    app.apply(Command::Show(Arc::new(resolve(key, None, None).unwrap())));
    app
}

/// The same with other settings.
pub(crate) fn with(mut app: App, change: impl FnOnce(&mut Settings)) -> App {
    let mut settings = app.document().settings;
    change(&mut settings);
    app.apply(Command::Edit(settings));
    app
}

pub(crate) fn app(ui: &Ui) -> &App {
    &ui.state().app
}

/// All that is written or named on screen.
pub(crate) fn words<S>(ui: &Harness<'static, S>) -> Vec<String> {
    ui.root()
        .children_recursive()
        .flat_map(|node| {
            let node = node.accesskit_node();
            [node.label(), node.value()]
        })
        .flatten()
        .collect()
}

pub(crate) fn is_written<S>(ui: &Harness<'static, S>, text: &str) -> bool {
    words(ui).iter().any(|word| word.contains(text))
}

#[track_caller]
pub(crate) fn assert_written<S>(ui: &Harness<'static, S>, text: &str) {
    let words = words(ui);
    let is_there = words.iter().any(|word| word.contains(text));
    assert!(is_there, "{text:?} is not on screen: {}", words.join(" | "));
}

/// Steps until nothing is read or computed any more.
pub(crate) fn settle(ui: &mut Ui) {
    let until = std::time::Instant::now() + std::time::Duration::from_secs(60);
    loop {
        ui.step();
        ui.state_mut().0.studies.finish();
        if !ui.state().0.is_busy() && !ui.state_mut().0.studies.is_running() {
            break;
        }
        assert!(std::time::Instant::now() < until, "still busy");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    // What was asked last is drawn.
    for _ in 0..4 {
        ui.step();
        ui.state_mut().0.studies.finish();
    }
    ui.run();
}

/// Clicks the button of that name, the first from above where there are several, and takes the
/// pointer away.
#[track_caller]
pub(crate) fn click<S>(ui: &mut Harness<'static, S>, name: &str) {
    ui.query_all_by_role_and_label(Role::Button, name)
        .next()
        .unwrap_or_else(|| panic!("no button is called {name:?}"))
        .click();
    ui.run();
    ui.remove_cursor();
    ui.run();
}

/// What a click copies.
pub(crate) fn copied<S>(ui: &mut Harness<'static, S>, button: &str) -> Option<String> {
    ui.get_by_role_and_label(Role::Button, button).click();
    let mut found = None;
    for _ in 0..6 {
        // The command is there for one frame only.
        ui.step();
        for command in &ui.output().platform_output.commands {
            if let egui::OutputCommand::CopyText(text) = command {
                found = Some(text.clone());
            }
        }
    }
    found
}

/// Lets frames pass until something holds; work on other threads takes as long as it takes.
#[track_caller]
pub(crate) fn wait_until<S>(
    ui: &mut Harness<'static, S>,
    what: &str,
    holds: impl Fn(&Harness<'static, S>) -> bool,
) {
    let start = Instant::now();
    while !holds(ui) {
        assert!(start.elapsed() < LONGEST_WAIT, "waited in vain for {what}");
        std::thread::sleep(Duration::from_millis(2));
        ui.step();
    }
    ui.run();
}
