//! The command line in a page of a browser.

use std::ffi::OsString;

use wasm_bindgen::prelude::*;

use crate::cli;

/// Runs a command of the command line; what it prints.
#[wasm_bindgen]
pub fn command(words: Vec<String>) -> String {
    let program = std::iter::once(cli::PROGRAM.to_owned());
    let words = program.chain(words).map(OsString::from);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    cli::run(words, None, &mut out, &mut err);
    out.append(&mut err);
    String::from_utf8_lossy(&out).into_owned()
}
