//! What a step of undo changes, in words.

use super::{
    document::{Document, View},
    entry::Entry,
    settings::Settings,
    ticks::short,
};

/// From one document to the next: "order 7 to 24", "light FL2 to CIE D65".
pub(super) fn difference(before: &Document, after: &Document) -> String {
    let mut words = Vec::new();
    if before.light.key != after.light.key {
        words.push(format!(
            "light {} to {}",
            before.light.name(),
            after.light.name()
        ));
    }
    if before.light.key == after.light.key && before.given.is_some() && after.given.is_none() {
        words.push("analysed anew".to_owned());
    }
    words.extend(of_settings(before.settings, after.settings));
    words.extend(of_spectra(before, after));
    let name = |entry: &Option<std::sync::Arc<Entry>>| {
        let entry = entry.as_ref();
        entry.map_or_else(|| "none".to_owned(), |entry| entry.name().to_owned())
    };
    if name(&before.factor) != name(&after.factor) {
        words.push(format!("surface {}", name(&after.factor)));
    } else if before.subject != after.subject {
        words.push(format!("model of {}", after.subject_entry().name()));
    }
    if before.overlays.len() != after.overlays.len() {
        words.push(format!("{} overlays", after.overlays.len()));
    }
    if before.edits != after.edits {
        words.push("a line changed by hand".to_owned());
    }
    if before.patch_set != after.patch_set {
        words.push("another set of surfaces".to_owned());
    } else if before.own_patches != after.own_patches {
        words.push("own surfaces among the patches".to_owned());
    } else if before.patch != after.patch {
        words.push("a surface chosen".to_owned());
    }
    if before.scale != after.scale {
        words.push(format!("scale {}", after.scale.words()));
    }
    if before.weight_factor != after.weight_factor {
        words.push(format!("weight factor {} nm", short(after.weight_factor)));
    }
    if before.view != after.view {
        words.push(of_view(before.view, after.view).to_owned());
    }
    if before.products != after.products {
        words.push("what light meets".to_owned());
    }
    let name_of = |key: &str| after.name_of(key);
    let pages = after.pages.change(&before.pages, &name_of);
    words.extend(pages.map(|(_, words)| words));
    match words.len() {
        0 => "a change".to_owned(),
        1 | 2 => words.join(", "),
        more => format!("{}, {} and {} more", words[0], words[1], more - 2),
    }
}

fn of_settings(before: Settings, after: Settings) -> Vec<String> {
    let mut words = Vec::new();
    if before.order != after.order {
        words.push(format!("order {} to {}", before.order, after.order));
    }
    if before.threshold_percent != after.threshold_percent {
        let [from, to] = [before, after].map(|s| short(s.threshold_percent));
        words.push(format!("threshold {from} to {to} %"));
    }
    if before.basis != after.basis {
        words.push(format!("{} series", after.basis.word()));
    }
    if before.band != after.band {
        let band = after.band;
        words.push(format!("range {} to {} nm", band.min_nm(), band.max_nm()));
    }
    if before.wide_lines != after.wide_lines {
        let how = if after.wide_lines {
            "lines as wide as they are"
        } else {
            "ideal lines"
        };
        words.push(how.to_owned());
    }
    let rest = |settings: Settings| Settings {
        wide_lines: false,
        order: 0,
        threshold_percent: 0.0,
        basis: after.basis,
        band: after.band,
        ..settings
    };
    if rest(before) != rest(after) {
        words.push("settings of the model".to_owned());
    }
    words
}

fn of_spectra(before: &Document, after: &Document) -> Option<String> {
    let (was, is) = (&before.own, &after.own);
    let new = is.iter().find(|e| !was.iter().any(|b| b.key == e.key));
    let gone = was.iter().find(|e| !is.iter().any(|b| b.key == e.key));
    match (new, gone) {
        (Some(entry), _) => Some(format!("{} joined", entry.name())),
        (None, Some(entry)) => Some(format!("{} taken out", entry.name())),
        (None, None) if before.images.len() < after.images.len() => {
            Some("an image joined".to_owned())
        }
        (None, None) if before.images.len() > after.images.len() => {
            Some("an image taken out".to_owned())
        }
        (None, None) => {
            let changed = is
                .iter()
                .zip(was)
                .find(|(a, b)| !std::sync::Arc::ptr_eq(a, b));
            changed.map(|(entry, _)| format!("{} changed", entry.name()))
        }
    }
}

fn of_view(before: View, after: View) -> &'static str {
    if before.height != after.height {
        "heights of the plot"
    } else if before.adapt_patches != after.adapt_patches {
        "adaptation of the surfaces"
    } else {
        "layers of the plot"
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
        assert_eq!(difference(&before, &after), "order 7 to 24");
        after.settings.threshold_percent = 1.0;
        after.patch = Some(2);
        let words = "order 7 to 24, threshold 0.5 to 1 % and 1 more";
        assert_eq!(difference(&before, &after), words);
    }
}
