//! The system's frame around the window: start, save, close, and clear words when there is none.

use std::{path::PathBuf, time::Instant};

use eframe::egui;

use super::{
    Window,
    files::watch_dialogs,
    saver::Saver,
    system_picker,
    theme::{self, waker},
};
use crate::app::{
    App, Command, Entry,
    following::FollowAsked,
    workspace::{self, Place, Preferences, StoredImage},
};
use crate::languages::Language;

/// Why there is no window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoWindow {
    /// No display to open a window on.
    NoDisplay(String),
    /// A display, but nothing to draw with.
    NoGraphics(String),
    /// The program itself failed.
    Failed(String),
}

impl std::fmt::Display for NoWindow {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoDisplay(why) => write!(f, "no usable display ({why})"),
            Self::NoGraphics(why) => write!(f, "no usable graphics driver ({why})"),
            Self::Failed(why) => write!(f, "the window failed ({why})"),
        }
    }
}

/// What the window starts with.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Files to open.
    pub files: Vec<PathBuf>,
    /// Shipped spectra to show.
    pub presets: Vec<std::sync::Arc<Entry>>,
    /// What is followed.
    pub follow: Option<FollowAsked>,
    /// Where the workspace is kept; `None` keeps none.
    pub workspace: Option<PathBuf>,
    /// Close by itself after this many frames (a smoke test), telling when the first was drawn.
    pub frames: Option<u32>,
    /// When the process started.
    pub started: Option<Instant>,
}

/// The size of a first window, points.
const FIRST_SIZE: [f32; 2] = [1280.0, 800.0];
/// The smallest window that still makes sense, points.
const LEAST_SIZE: [f32; 2] = [1000.0, 600.0];

/// Program and preferences as they were left, or as they are at a first start.
#[derive(Debug)]
pub struct Restart {
    /// The program.
    pub app: App,
    /// How the window looks.
    pub preferences: Preferences,
    /// Images that are to be read again.
    pub images: Vec<StoredImage>,
    /// Nothing was kept before.
    pub is_first: bool,
    /// Where this window keeps its workspace; `None` where nothing is kept. No other window writes
    /// there for as long as this lives.
    pub place: Option<Place>,
}

/// What a window over the workspace at a path starts with.
pub fn restore(path: Option<&std::path::Path>) -> Restart {
    let begun = path.map(workspace::begin).unwrap_or_default();
    let is_first = begun.restored.is_none();
    let (mut app, preferences, images) = match begun.restored {
        Some(restored) => Window::restored(restored),
        None => (App::new(), Preferences::default(), Vec::new()),
    };
    for (tone, words) in begun.words {
        app.say(tone, words);
    }
    Restart {
        app,
        preferences,
        images,
        is_first,
        place: begun.place,
    }
}

/// Opens the window and stays until it is closed.
///
/// # Errors
/// [`NoWindow`] in plain words; never a panic, whatever the display libraries do.
pub fn run(start: Start) -> Result<(), NoWindow> {
    watch_dialogs();
    // The window library panics when a display library is missing; the message would be raw.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| open(start)));
    std::panic::set_hook(hook);
    match outcome {
        Ok(Ok(())) => Ok(()),
        Ok(Err(eframe::Error::WinitEventLoop(e))) => Err(NoWindow::NoDisplay(last_part(&e))),
        Ok(Err(eframe::Error::AppCreation(e))) => Err(NoWindow::Failed(last_part(&e))),
        Ok(Err(e)) => Err(NoWindow::NoGraphics(last_part(&e))),
        Err(panic) => {
            let text = panic
                .downcast_ref::<String>()
                .cloned()
                .or_else(|| panic.downcast_ref::<&str>().map(|s| (*s).to_owned()))
                .unwrap_or_default();
            let is_missing_library = text.contains("xkbcommon") || text.contains("Library");
            Err(if is_missing_library {
                NoWindow::NoDisplay(format!(
                    "a display library is missing: {}",
                    first_line(&text)
                ))
            } else {
                NoWindow::Failed(first_line(&text))
            })
        }
    }
}

fn open(start: Start) -> eframe::Result {
    let Restart {
        app,
        mut preferences,
        images,
        is_first,
        place,
    } = restore(start.workspace.as_deref());
    if is_first {
        preferences.speak(Language::of_system());
    }
    let size = preferences.window.unwrap_or(FIRST_SIZE);
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_app_id("spectral-explorer")
            .with_title("Spectral Explorer")
            .with_inner_size(size)
            .with_min_inner_size(LEAST_SIZE)
            .with_drag_and_drop(true),
        renderer: eframe::Renderer::Glow,
        // Colours are shown as computed.
        dithering: false,
        ..Default::default()
    };
    eframe::run_native(
        "Spectral Explorer",
        options,
        Box::new(move |creation| {
            // Fonts take effect in the next frame: before the first one they are never missed.
            theme::install_fonts(&creation.egui_ctx);
            let saver = place.as_ref().map(|p| Saver::new(p.path().to_owned()));
            let mut window = Window::new(app, preferences, system_picker(), saver);
            // What is named first is shown: it comes last, as on the command line.
            for entry in start.presets.iter().rev().cloned() {
                window.app.apply(Command::Show(entry));
            }
            if let Some(asked) = start.follow {
                window.follow_light(asked, &creation.egui_ctx);
            } else if start.presets.is_empty() && start.files.is_empty() {
                window.greet();
            }
            window.bring_back(images, &creation.egui_ctx);
            window.open_files(start.files, waker(&creation.egui_ctx));
            Ok(Box::new(Shell {
                window,
                frames_left: start.frames,
                started: start.started,
                first_shown: false,
                _place: place,
            }))
        }),
    )
}

struct Shell {
    window: Window,
    frames_left: Option<u32>,
    started: Option<Instant>,
    first_shown: bool,
    /// Let go of after the window has written its last: fields are dropped in their order.
    _place: Option<Place>,
}

impl eframe::App for Shell {
    fn logic(&mut self, context: &egui::Context, _frame: &mut eframe::Frame) {
        self.window.unseen(context);
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        if self.frames_left.is_some()
            && self.first_shown
            && let Some(started) = self.started.take()
        {
            // The second frame begins when the first one is on screen: a smoke test wants to know.
            println!(
                "first frame shown after {:.3} s",
                started.elapsed().as_secs_f64()
            );
        }
        self.first_shown = true;
        self.window.show(ui);
        let context = ui.ctx();
        let size = context.input(|i| i.viewport().inner_rect).map(|r| r.size());
        if let Some(size) = size {
            // The viewport tells points of the present zoom; the builder wants points at zoom 1.
            let zoom = context.zoom_factor();
            self.window.preferences.window = Some([size.x * zoom, size.y * zoom]);
        }
        if let Some(left) = &mut self.frames_left {
            *left = left.saturating_sub(1);
            if *left == 0 {
                context.send_viewport_cmd(egui::ViewportCommand::Close);
            }
            context.request_repaint();
        }
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.window.keep_now();
        self.window.finish_writing();
    }
}

/// The last part of a chain of error messages: what went wrong, without paths of a build machine.
fn last_part(error: &dyn std::fmt::Display) -> String {
    let text = error.to_string();
    first_line(text.rsplit(": ").next().unwrap_or_default())
}

fn first_line(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default().trim();
    line.chars().take(160).collect()
}
