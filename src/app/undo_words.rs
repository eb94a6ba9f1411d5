//! What a step of undo changes, in words.

use std::sync::Arc;

use super::{
    document::{Document, View},
    entry::Entry,
    origin::SourceFile,
    pages::knob::moved_words,
    settings::Settings,
    ticks::short,
};
use crate::spectrum::Basis;

/// From one document to the next: "waves 7 to 24", "light FL2 to CIE D65".
pub(super) fn difference(before: &Document, after: &Document) -> String {
    let mut words = Vec::new();
    if let Some(opened) = opened(before, after) {
        return opened;
    }
    if before.light.key != after.light.key {
        words.push(tr!(
            "light {before} to {after}",
            before = before.light.name(),
            after = after.light.name()
        ));
    }
    if before.second.as_ref().map(|e| &e.key) != after.second.as_ref().map(|e| &e.key) {
        words.push(match &after.second {
            Some(second) => tr!("compared with {light}", light = second.name()),
            None => said!("no second light").to_owned(),
        });
    }
    if before.light.key == after.light.key && before.given.is_some() && after.given.is_none() {
        words.push(said!("analysed anew").to_owned());
    }
    words.extend(of_settings(before.settings, after.settings));
    words.extend(of_spectra(before, after));
    let name = |entry: &Option<Arc<Entry>>| {
        let entry = entry.as_ref();
        entry.map_or_else(|| said!("none").to_owned(), |entry| entry.name().to_owned())
    };
    if name(&before.factor) != name(&after.factor) {
        words.push(tr!("surface {name}", name = name(&after.factor)));
    } else if before.subject != after.subject {
        words.push(tr!("model of {name}", name = after.subject_entry().name()));
    }
    if before.overlays.len() != after.overlays.len() {
        words.push(tr!("{count} overlays", count = after.overlays.len()));
    }
    if before.edits != after.edits {
        words.push(said!("a line changed by hand").to_owned());
    }
    if before.patch_set != after.patch_set {
        words.push(said!("another set of surfaces").to_owned());
    } else if before.own_patches != after.own_patches {
        words.push(said!("own surfaces added or removed").to_owned());
    } else if before.patch != after.patch {
        words.push(said!("a surface chosen").to_owned());
    }
    if before.scale != after.scale {
        words.push(tr!("scale {scale}", scale = after.scale.words()));
    }
    if before.weight_factor != after.weight_factor {
        words.push(tr!(
            "weight factor {factor} nm",
            factor = short(after.weight_factor)
        ));
    }
    if before.view != after.view {
        words.push(of_view(before.view, after.view).to_owned());
    }
    if before.products != after.products {
        words.push(said!("what light meets").to_owned());
    }
    let name_of = |key: &str| after.name_of(key);
    let pages = after.pages.change(&before.pages, &name_of);
    words.extend(pages.map(|(_, words)| words));
    match words.len() {
        0 => said!("a change").to_owned(),
        1 | 2 => words.join(", "),
        more => tr!(
            "{first}, {second} and {count} more",
            first = words[0],
            second = words[1],
            count = more - 2
        ),
    }
}

/// What was opened, where files or numbers came in: the light that it brought is no news then.
fn opened(before: &Document, after: &Document) -> Option<String> {
    let is_new = |entry: &&Arc<Entry>| !before.own.iter().any(|b| b.key == entry.key);
    let is_whole = before
        .own
        .iter()
        .all(|b| after.own.iter().any(|a| a.key == b.key));
    let new: Vec<&Arc<Entry>> = after.own.iter().filter(is_new).collect();
    let files: Vec<&Arc<SourceFile>> = new
        .iter()
        .filter_map(|entry| entry.origin.file())
        .map(|from| &from.reading.file)
        .collect();
    if new.is_empty() || !is_whole || files.len() < new.len() {
        return None;
    }
    let mut different: Vec<&Arc<SourceFile>> = Vec::new();
    for file in files {
        if !different.iter().any(|other| Arc::ptr_eq(other, file)) {
            different.push(file);
        }
    }
    Some(match (&new[..], &different[..]) {
        ([one], _) => tr!("opened \"{name}\"", name = one.name()),
        (all, [file]) => tr!(
            "opened {count} spectra of {file}",
            count = all.len(),
            file = file.name
        ),
        (_, files) => {
            let folder = |file: &Arc<SourceFile>| Some(file.path.as_ref()?.parent()?.to_owned());
            let first = folder(files[0]);
            let is_one = first.is_some() && files.iter().all(|file| folder(file) == first);
            let name = first
                .as_deref()
                .and_then(|f| f.file_name())
                .filter(|_| is_one);
            match name {
                Some(folder) => tr!(
                    "opened {count} files from {folder}",
                    count = files.len(),
                    folder = folder.to_string_lossy()
                ),
                None => tr!("opened {count} files", count = files.len()),
            }
        }
    })
}

fn of_settings(before: Settings, after: Settings) -> Vec<String> {
    let knobs = Settings::KNOBS.map(|(_, knob)| moved_words(&[knob], &before, &after));
    let mut words: Vec<String> = knobs.into_iter().flatten().collect();
    if before.basis != after.basis {
        let series = match after.basis {
            Basis::Fourier => said!("fourier series"),
            Basis::Cosine => said!("cosine series"),
        };
        words.push(series.to_owned());
    }
    if before.band != after.band {
        let band = after.band;
        words.push(tr!(
            "range {min} to {max} nm",
            min = short(band.min_nm()),
            max = short(band.max_nm())
        ));
    }
    if before.wide_lines != after.wide_lines {
        let how = if after.wide_lines {
            said!("lines as wide as they are")
        } else {
            said!("ideal lines")
        };
        words.push(how.to_owned());
    }
    let mut rest = Settings {
        wide_lines: after.wide_lines,
        basis: after.basis,
        band: after.band,
        ..before
    };
    for (_, knob) in Settings::KNOBS {
        knob.set(&mut rest, knob.get(&mut { after }));
    }
    if rest != after {
        words.push(said!("settings of the model").to_owned());
    }
    words
}

fn of_spectra(before: &Document, after: &Document) -> Option<String> {
    let (was, is) = (&before.own, &after.own);
    let new = is.iter().find(|e| !was.iter().any(|b| b.key == e.key));
    let gone = was.iter().find(|e| !is.iter().any(|b| b.key == e.key));
    match (new, gone) {
        (Some(entry), _) => {
            let name = entry.name();
            Some(match entry.origin.recipe() {
                Some(_) => tr!("made \"{name}\"", name),
                None => tr!("added \"{name}\"", name),
            })
        }
        (None, Some(entry)) => Some(tr!("{name} taken out", name = entry.name())),
        (None, None) if before.images.len() < after.images.len() => {
            Some(said!("an image joined").to_owned())
        }
        (None, None) if before.images.len() > after.images.len() => {
            Some(said!("an image taken out").to_owned())
        }
        (None, None) => {
            let changed = is.iter().zip(was).find(|(a, b)| !Arc::ptr_eq(a, b));
            changed.map(|(entry, _)| tr!("{name} changed", name = entry.name()))
        }
    }
}

fn of_view(before: View, after: View) -> &'static str {
    if before.height != after.height {
        said!("heights of the plot")
    } else if before.adapt_patches != after.adapt_patches {
        said!("adaptation of the surfaces")
    } else {
        said!("layers of the plot")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{document::first_light, entry::bundled_entries};

    #[test]
    fn a_step_is_told_by_what_it_changes() {
        let before = Document::about(first_light(bundled_entries()));
        let mut after = before.clone();
        after.settings.order = 24;
        assert_eq!(difference(&before, &after), "waves 7 to 24");
        after.settings.threshold_percent = 1.0;
        after.patch = Some(2);
        let words = "waves 7 to 24, lines above 0.5 to 1 % and 1 more";
        assert_eq!(difference(&before, &after), words);
    }
}
