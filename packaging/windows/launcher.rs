//! Opens the window on Windows without a console beside it; files dropped on it are passed on.
#![cfg_attr(windows, windows_subsystem = "windows")]

use std::{env, process::Command};

/// The process has no console of its own (`CREATE_NO_WINDOW`).
#[cfg(windows)]
const NO_CONSOLE: u32 = 0x0800_0000;

fn main() -> std::io::Result<()> {
    let program = env::current_exe()?.with_file_name(if cfg!(windows) {
        "spectral-explorer.exe"
    } else {
        "spectral-explorer"
    });
    let mut command = Command::new(program);
    command.arg("--window").args(env::args_os().skip(1));
    #[cfg(windows)]
    std::os::windows::process::CommandExt::creation_flags(&mut command, NO_CONSOLE);
    command.spawn().map(drop)
}
