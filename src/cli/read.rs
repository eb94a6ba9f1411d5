//! `read`: what files hold and how they were read.

use std::{
    io::Write,
    path::{Path, PathBuf},
};

use serde_json::Value;

use super::{arguments::Read, print, refusal::Refusal, remark};
use crate::{app::read_report, io};

/// Carries the command out. A file that is refused does not stop the others.
///
/// # Errors
/// [`Refusal`] when a folder cannot be listed, and, after everything was printed, when one of the
/// files was refused.
pub fn run(options: &Read, out: &mut dyn Write, err: &mut dyn Write) -> Result<(), Refusal> {
    let mut files = Vec::new();
    for input in &options.files {
        if input.is_dir() {
            files.extend(files_in(input)?);
        } else {
            files.push(input.clone());
        }
    }
    let mut refused = Vec::new();
    let mut values = Vec::new();
    for path in &files {
        let reading = io::read_path(path);
        if let Err(refusal) = &reading {
            refused.push(refusal.to_string());
        }
        if options.json {
            values.push(read_report::json(path, &reading));
        } else if reading.is_ok() {
            print(out, &read_report::text(path, &reading))?;
        }
    }
    if options.json {
        print(out, &format!("{:#}\n", Value::Array(values)))?;
    }
    let Some(last) = refused.pop() else {
        return Ok(());
    };
    for line in refused {
        remark(err, &line);
    }
    Err(Refusal::File(last))
}

/// The files of a folder in the order of their names, hidden ones and folders left out.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Refusal> {
    let trouble = |error: std::io::Error| {
        Refusal::File(format!(
            "{}: found {error}, expected a folder that can be listed",
            folder.display()
        ))
    };
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(trouble)? {
        let entry = entry.map_err(trouble)?;
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        if !hidden && entry.path().is_file() {
            files.push(entry.path());
        }
    }
    files.sort();
    if files.is_empty() {
        return Err(Refusal::File(format!(
            "{}: found no file, expected a folder with files",
            folder.display()
        )));
    }
    Ok(files)
}
