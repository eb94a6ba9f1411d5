//! The story: arguments, then the command line or the window, then an exit code.

use std::{io, path::PathBuf, process::ExitCode, time::Instant};

use spectral_explorer::{
    app::workspace::Preferences,
    app::{App, chart, charts::spectrum::spectrum_chart, workspace},
    cli::{self, Input, Outcome, Pictures},
    ui::{picture, shell},
};

/// Draws for the command line with the window's own painter.
struct Painted;

impl Pictures for Painted {
    fn window(&self, app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8> {
        picture::window_png(app, preferences, size)
    }

    fn plot(&self, app: &App, theme: chart::Theme, size: [u32; 2]) -> Vec<u8> {
        picture::chart_png(&spectrum_chart(app, theme), size)
    }

    fn chart(&self, chart: &chart::Chart, size: [u32; 2]) -> Vec<u8> {
        picture::chart_png(chart, size)
    }
}

/// Names another file to keep the workspace in (tests, portable use); empty keeps none.
const WORKSPACE: &str = "SPECTRAL_EXPLORER_WORKSPACE";
/// Closes the window by itself after this many frames: a smoke test.
const FRAMES: &str = "SPECTRAL_EXPLORER_FRAMES";

fn main() -> ExitCode {
    let started = Instant::now();
    let (mut out, mut err) = (io::stdout(), io::stderr());
    let (files, insist) = match cli::run(std::env::args_os(), &Painted, &mut out, &mut err) {
        Outcome::Done(code) => return ExitCode::from(code),
        Outcome::Window { files, insist } => (files, insist),
    };
    let start = shell::Start {
        files: files.iter().filter_map(Input::file).collect(),
        presets: files.iter().filter_map(Input::preset).collect(),
        workspace: workspace_path(),
        frames: std::env::var(FRAMES).ok().and_then(|n| n.parse().ok()),
        started: Some(started),
    };
    match shell::run(start) {
        Ok(()) => ExitCode::SUCCESS,
        Err(shell::NoWindow::NoDisplay(_)) => {
            let (app, refused) = cli::app_with(&files);
            for why in refused {
                eprintln!("{}: {why}", cli::PROGRAM);
            }
            ExitCode::from(cli::without_display(
                &app, insist, &Painted, &mut out, &mut err,
            ))
        }
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
