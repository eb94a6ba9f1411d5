//! The line at the bottom: what to notice, and a question to try; else what was said last.

use crate::{
    app::{App, Settings, answers::not_seen_from, pages::Page},
    io::many::many,
};

/// What is to be noticed on a page, and a question to try.
pub fn words(app: &App, page: Page) -> (String, String) {
    if page != Page::Spectrum {
        return (page.meaning().to_owned(), String::new());
    }
    let derived = app.derived();
    let spikes = &derived.model.spikes;
    let share: f64 = spikes
        .iter()
        .filter_map(|spike| derived.parts.share(spike.weight))
        .sum();
    let notice = match spikes.len() {
        0 => "No lines stand out: the spectrum is smooth.".to_owned(),
        count => format!(
            "{} {} {:.0} % of the power.",
            many(count, "line", "lines"),
            if count == 1 { "holds" } else { "hold" },
            100.0 * share
        ),
    };
    let order = derived.model.smooth.order();
    let as_it_starts = app.document().settings == Settings::default();
    let family = app.told().and_then(|told| told.family);
    let of_family = family.map_or("", |family| family.question.as_str());
    if as_it_starts && !of_family.is_empty() {
        return (notice, of_family.to_owned());
    }
    let question = match not_seen_from(app) {
        Some(from) if from > 0 && order > from => {
            format!("Pull Smoothness down to {from}. The curve goes wrong: do the colours?")
        }
        Some(from) if from > 0 && order < from => {
            format!("Push Smoothness up to {from}: what becomes right first, curve or colours?")
        }
        Some(_) if !spikes.is_empty() => {
            "Pull Lines to the left until one drops out: which colours notice?".to_owned()
        }
        Some(_) => "Pull Smoothness down to 0: what is left of the colours?".to_owned(),
        None => "Push Smoothness up: do the colours ever come right?".to_owned(),
    };
    (notice, question)
}
