//! What the program does where there is no display, or no window in it: it says so and does its
//! main job.

use std::{io::Write, path::Path};

use super::{Pictures, print, refusal::Refusal, remark, target::new_picture};
use crate::{
    app::{App, report, workspace::Preferences},
    io::{save_atomically, shown},
};

/// Exit code for a missing display or window where a window was insisted on.
const NO_DISPLAY: u8 = 3;

/// Size of the picture, px.
const SIZE: [u32; 2] = [1280, 800];

/// Says in one sentence that there is no display, prints the report of what is open and writes a
/// picture of the window to a new file that it names. A build without the window, which has no
/// `pictures` either, says that and prints the report. Gives the exit code.
///
/// With `insist` what is missing is an error with exit code 3.
pub fn without_display(
    app: &App,
    insist: bool,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> u8 {
    let (missing, instead) = match pictures {
        Some(_) => (
            "--window: found no display, expected one (DISPLAY or WAYLAND_DISPLAY names it)",
            "There is no display, so here is the report, and the window as a picture.",
        ),
        None => (
            "--window: found a build without the window, expected one with it (cargo build \
             --release)",
            "This build has no window (cargo build --release makes one with it), so here is the \
             report.",
        ),
    };
    if insist {
        remark(err, missing);
        return NO_DISPLAY;
    }
    remark(err, instead);
    match report_and_picture(app, pictures, out) {
        Ok(()) => 0,
        Err(refusal) => refusal.tell(err),
    }
}

fn report_and_picture(
    app: &App,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
) -> Result<(), Refusal> {
    print(out, &report::text(app))?;
    let Some(pictures) = pictures else {
        return Ok(());
    };
    let picture = pictures.window(app, &Preferences::default(), SIZE);
    let here = new_picture(Path::new(""));
    let path = match save_atomically(&here, &picture) {
        Ok(()) => here,
        // A folder that cannot be written to is no reason to give nothing.
        Err(_) => {
            let elsewhere = new_picture(&std::env::temp_dir());
            save_atomically(&elsewhere, &picture).map_err(Refusal::file)?;
            elsewhere
        }
    };
    print(out, &format!("Picture   {}\n", shown(&path)))
}
