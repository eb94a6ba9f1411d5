//! The window in a page of a browser: what `web/page.js` calls, and what it is asked for.

use std::{
    cell::{OnceCell, RefCell},
    path::{Path, PathBuf},
    sync::Arc,
};

use eframe::{egui, web_sys::HtmlCanvasElement};
use wasm_bindgen::prelude::*;

use super::{
    Window,
    files::{Ask, Picked, Picker, Printer},
    saver::{self, Saver},
    theme::{self, waker},
};
use crate::{
    app::{
        App, Tone,
        hands::{self, Came, Others, take_turn},
        open::Loaded,
        studies,
        workspace::{self, Preferences},
    },
    io::disk,
    languages::{self, Language, said},
    study::Progress,
};

/// What the page does for the program.
#[wasm_bindgen]
extern "C" {
    /// Asks for files, or for all of a folder; they come by [`hand_over`].
    #[wasm_bindgen(js_namespace = host)]
    fn pick(folder: bool);
    /// Saves a file as a download.
    #[wasm_bindgen(js_namespace = host)]
    fn download(name: &str, bytes: &[u8]);
    /// Opens a page that was made here.
    #[wasm_bindgen(js_namespace = host)]
    fn show(html: &[u8]);
    /// Keeps a text in the browser; why it did not, empty where it did.
    #[wasm_bindgen(js_namespace = host)]
    pub(super) fn keep(text: &str) -> String;
    /// The text that is kept.
    #[wasm_bindgen(js_namespace = host)]
    fn kept() -> Option<String>;
    /// Address of the page without what stands behind `#`.
    #[wasm_bindgen(js_namespace = host)]
    fn address() -> String;
    /// Tells that a frame was drawn.
    #[wasm_bindgen(js_namespace = host)]
    fn drawn();
    /// Puts a question to a Web Worker; what comes of it comes by [`come`], how far it is by
    /// [`tell_progress`].
    #[wasm_bindgen(js_namespace = host)]
    fn ask(number: u32, kind: &str, question: &[u8]);
    /// Ends the Web Worker that works on a question.
    #[wasm_bindgen(js_namespace = host)]
    fn stop(number: u32);
    /// Tells, in a Web Worker, how far the work is.
    #[wasm_bindgen(js_namespace = host)]
    fn told(done: usize, total: usize);
}

/// What came from the page since the last frame.
enum Arrived {
    File(PathBuf),
    Link(String),
}

thread_local! {
    static ARRIVED: RefCell<Vec<Arrived>> = RefCell::default();
    static CONTEXT: OnceCell<egui::Context> = const { OnceCell::new() };
    /// Pages to be shown in place of being saved.
    static SHOWN: RefCell<Vec<PathBuf>> = RefCell::default();
}

fn arrive(what: Arrived) {
    ARRIVED.with_borrow_mut(|arrived| arrived.push(what));
    CONTEXT.with(|context| context.get().map(egui::Context::request_repaint));
}

/// Opens a file that was chosen or dropped.
#[wasm_bindgen]
pub fn hand_over(name: &str, bytes: Vec<u8>) {
    arrive(Arrived::File(disk::hand_over(name, bytes)));
}

/// Follows a link: what stands behind `#`, decoded.
#[wasm_bindgen]
pub fn follow(link: String) {
    arrive(Arrived::Link(link));
}

/// Keeps the workspace at once: the page may be closed at any moment.
#[wasm_bindgen]
pub fn hide() {
    saver::write();
}

/// Answers a question in a Web Worker; nothing where it has to be answered where it was asked.
#[wasm_bindgen]
pub fn answer(kind: &str, question: &[u8]) -> Option<Vec<u8>> {
    studies::answered(kind, question, &Progress::telling(told))
}

/// Takes what came of a question.
#[wasm_bindgen]
pub fn come(number: u32, answer: Option<Vec<u8>>) {
    hands::come(number, answer.map_or(Came::Nothing, Came::Bytes));
}

/// Takes that the Web Worker of a question broke down.
#[wasm_bindgen]
pub fn come_broken(number: u32) {
    hands::come(number, Came::Broken);
}

/// Takes how far the work on a question is.
#[wasm_bindgen]
pub fn tell_progress(number: u32, done: usize, total: usize) {
    hands::follow(number, done, total);
}

/// Starts the window on a canvas.
///
/// # Errors
/// No WebGL, or the window could not be made.
#[wasm_bindgen]
pub async fn start(canvas: HtmlCanvasElement) -> Result<(), JsValue> {
    let options = eframe::WebOptions {
        // Colours are shown as computed.
        dithering: false,
        ..Default::default()
    };
    let creator: eframe::AppCreator<'static> = Box::new(|creation| {
        // Fonts take effect in the next frame: before the first one they are never missed.
        theme::install_fonts(&creation.egui_ctx);
        hands::reach(Others { ask, stop });
        CONTEXT.with(|context| context.set(creation.egui_ctx.clone()).is_ok());
        Ok(Box::new(Shell::new()))
    });
    eframe::WebRunner::new()
        .start(canvas, options, creator)
        .await
}

/// What is said at a first start.
const PRIVATE: &str =
    later!("This page sends nothing anywhere. What you do stays in this browser.");

struct Shell {
    window: Window,
}

impl Shell {
    fn new() -> Self {
        let (mut app, mut preferences) = (App::new(), Preferences::default());
        match kept().map(|text| workspace::from_json(&text)) {
            None => {
                preferences.speak(Language::of_system());
                app.say(
                    Tone::Info,
                    languages::in_language(preferences.language, || said(PRIVATE)),
                );
            }
            Some(Ok(restored)) => (app, preferences, _) = Window::restored(restored),
            Some(Err(why)) => {
                let words = tr!(
                    "The last workspace is damaged and given up ({reason}).",
                    reason = why
                );
                app.say(Tone::Problem, words);
            }
        }
        let saver = Saver::new(PathBuf::from("workspace.json"));
        let mut window = Window::new(app, preferences, system_picker(), Some(saver));
        window.address = Some(address());
        window.greet();
        Self { window }
    }
}

impl eframe::App for Shell {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        // What waits since the last frame, which is on screen by now.
        if take_turn() {
            context.request_repaint();
        }
        let mut paths = Vec::new();
        for what in ARRIVED.with_borrow_mut(std::mem::take) {
            match what {
                Arrived::File(path) => paths.push(path),
                Arrived::Link(link) => self.window.open_link(&link),
            }
        }
        self.window.open_files(paths, waker(&context));
        self.window.show(ui);
        hands::stop_cancelled();
        for disk::Saved { path, bytes } in disk::take_saved() {
            let is_shown = SHOWN.with_borrow_mut(|shown| {
                let place = shown.iter().position(|one| *one == path);
                place.map(|place| shown.swap_remove(place)).is_some()
            });
            match is_shown {
                true => show(&bytes),
                false => download(&path.to_string_lossy(), &bytes),
            }
        }
        // A change is kept when it is due, also where nobody moves.
        context.request_repaint_after(saver::AFTER);
        drawn();
    }
}

/// The browser's choice of files; a file to be saved is a download of the name offered.
pub(super) fn system_picker() -> Picker {
    Arc::new(|ask| match ask {
        Ask::Save { suggested, .. } => Picked::Paths(vec![PathBuf::from(suggested)]),
        Ask::Open | Ask::OpenFolder => {
            pick(*ask == Ask::OpenFolder);
            Picked::Later
        }
    })
}

/// Opens a page in another tab of the browser.
pub(super) fn system_printer() -> Printer {
    Arc::new(|path: &Path| {
        SHOWN.with_borrow_mut(|shown| shown.push(path.to_owned()));
        Ok(())
    })
}

/// Files that were dropped come by [`hand_over`].
pub(super) fn dropped(_: &egui::Ui) -> (Vec<PathBuf>, Vec<(String, Loaded)>) {
    (Vec::new(), Vec::new())
}
