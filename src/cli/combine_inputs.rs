//! The measurements that the inputs of `combine` mean.

use std::{ffi::OsStr, path::Path};

use super::{
    arguments::Stated,
    inputs::{Inputs, named_spectrum},
    refusal::Refusal,
};
use crate::{
    app::{
        Entry,
        combining::Part,
        measured::is_sigma_of,
        open::{Loaded, Wanted, named},
        readings::lost_its_sigma,
    },
    io::{Choices, shown, stream::is_stream},
};

/// The measurements that a word means: one, or for scans all of a file.
pub(super) fn read(
    word: &OsStr,
    all: bool,
    stated: Stated,
    inputs: &mut Inputs,
) -> Result<Vec<Part>, Refusal> {
    let path = Path::new(word);
    let refused = |why: String| Refusal::File(format!("INPUT: {why}"));
    let choices = Choices {
        keep_photons: true,
        take_sigma: stated.take_sigma,
        ..Choices::default()
    };
    let (file, pick) = named_spectrum(word);
    let is_file = path.is_file() || is_stream(path) || Path::new(file).is_file();
    let mut beside = match is_file {
        true => spectra_of(Path::new(file), &choices, inputs)?,
        false => Vec::new(),
    };
    if pick.is_some() || !all && beside.len() > 1 || beside.is_empty() {
        let wanted = Wanted {
            choices,
            ..Wanted::default()
        };
        let found = inputs.find(word, &wanted);
        let is_option = !is_file && word.to_string_lossy().starts_with("--");
        let found = found.map_err(|why| match is_option {
            true => refused(format!("{why}; options stand before --")),
            false => refused(why),
        })?;
        beside = vec![found.entry];
    }
    let part = |entry: &Entry| {
        let part = Part::of_entry(entry, stated.as_light);
        let part = part.map_err(|why| refused(format!("{}: {why}", shown(path))))?;
        Ok(Part {
            of: stated.of(part.of),
            ..part
        })
    };
    beside.iter().map(part).collect()
}

/// Every spectrum of a file but the sigma of others.
fn spectra_of(path: &Path, choices: &Choices, inputs: &mut Inputs) -> Result<Vec<Entry>, Refusal> {
    let opened = match inputs.load(path, choices) {
        Loaded::File(opened) => opened,
        Loaded::Refused(why) => return Err(Refusal::File(format!("INPUT: {why}"))),
        Loaded::Project { .. } => return Ok(Vec::new()),
    };
    let mut is_out = vec![false; opened.spectra.len()];
    for (index, pair) in opened.spectra.windows(2).enumerate() {
        let (name, of) = (&pair[1].name, &pair[0].name);
        let said = match (opened.is_sigma(index + 1), is_sigma_of(name, of)) {
            (true, Some(true)) => None,
            (true, _) => Some(format!("{name} is taken as the sigma of {of}")),
            (false, Some(_)) => Some(format!(
                "{name} may be the sigma of {of}, and is left out: --take-sigma takes it so"
            )),
            (false, None) => continue,
        };
        is_out[index + 1] = true;
        if let Some(said) = said {
            inputs.note(format!("{}: {said}", shown(path)));
        }
    }
    if opened.spectra.iter().any(lost_its_sigma) {
        let lost = "a column of deviations was left out: --take-sigma takes it as sigma";
        inputs.note(format!("{}: {lost}", shown(path)));
    }
    let all = named::every(*opened, choices).into_iter();
    let entries = all.map(|found| found.entry).enumerate();
    let kept = entries.filter(|(index, _)| is_out.get(*index) != Some(&true));
    Ok(kept.map(|(_, entry)| entry).collect())
}
