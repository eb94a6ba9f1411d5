//! The story: arguments, then the command line or the window, then an exit code.

use std::{io, process::ExitCode, time::Instant};

use spectral_explorer::cli::{self, Input, Outcome};

#[cfg(feature = "window")]
use window::{PICTURES, open};

fn main() -> ExitCode {
    let started = Instant::now();
    let (mut out, mut err) = (io::stdout(), io::stderr());
    match cli::run(std::env::args_os(), PICTURES, &mut out, &mut err) {
        Outcome::Done(code) => ExitCode::from(code),
        Outcome::Window { files, insist } => open(&files, insist, started),
    }
}

/// The main job without a window: the report of these files, and a picture where one can be drawn.
fn report(files: &[Input], insist: bool) -> ExitCode {
    let (app, refused) = cli::app_with(files);
    for why in refused {
        eprintln!("{}: {why}", cli::PROGRAM);
    }
    let (mut out, mut err) = (io::stdout(), io::stderr());
    let code = cli::without_display(&app, insist, PICTURES, &mut out, &mut err);
    ExitCode::from(code)
}

#[cfg(not(feature = "window"))]
const PICTURES: Option<&dyn cli::Pictures> = None;

#[cfg(not(feature = "window"))]
fn open(files: &[Input], insist: bool, _: Instant) -> ExitCode {
    report(files, insist)
}

#[cfg(feature = "window")]
mod window {
    use std::{path::PathBuf, process::ExitCode, sync::Arc, time::Instant};

    use spectral_explorer::{
        app::{
            App, chart::Theme, charts::spectrum::spectrum_chart, lessons::Lesson, workspace,
            workspace::Preferences,
        },
        cli::{self, Input, Pictures},
        ui::{picture, shell},
    };

    /// Draws for the command line with the window's own painter.
    struct Painted;

    pub(crate) const PICTURES: Option<&dyn Pictures> = Some(&Painted);

    impl Pictures for Painted {
        fn window(&self, app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8> {
            picture::window_png(app, preferences, size)
        }

        fn plot(&self, app: &App, theme: Theme, size: [u32; 2]) -> Vec<u8> {
            picture::chart_png(&spectrum_chart(app), size, theme)
        }

        fn names(&self, app: &App, preferences: &Preferences) -> Option<Vec<String>> {
            Some(picture::names(app, preferences))
        }

        fn step(&self, lesson: &Arc<Lesson>, step: usize) -> Option<Vec<u8>> {
            Some(picture::step_png(lesson, step))
        }
    }

    /// Names another file to keep the workspace in (tests, portable use); empty keeps none.
    const WORKSPACE: &str = "SPECTRAL_EXPLORER_WORKSPACE";
    /// Closes the window by itself after this many frames: a smoke test.
    const FRAMES: &str = "SPECTRAL_EXPLORER_FRAMES";

    pub(crate) fn open(files: &[Input], insist: bool, started: Instant) -> ExitCode {
        let start = shell::Start {
            files: files.iter().filter_map(Input::file).collect(),
            presets: files.iter().filter_map(Input::preset).collect(),
            workspace: workspace_path(),
            frames: std::env::var(FRAMES).ok().and_then(|n| n.parse().ok()),
            started: Some(started),
        };
        match shell::run(start) {
            Ok(()) => ExitCode::SUCCESS,
            Err(shell::NoWindow::NoDisplay(_)) => super::report(files, insist),
            Err(why) => {
                eprintln!("{}: {why}", cli::PROGRAM);
                ExitCode::from(4)
            }
        }
    }

    fn workspace_path() -> Option<PathBuf> {
        match std::env::var_os(WORKSPACE) {
            Some(path) if path.is_empty() => None,
            Some(path) => Some(PathBuf::from(path)),
            None => workspace::default_path(),
        }
    }
}
