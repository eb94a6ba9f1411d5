//! The line at the bottom: what to notice, a question to try and the lesson that answers it; else
//! what was said last.

use crate::{
    app::{
        App, Detector, Settings,
        answers::{LINE_THRESHOLDS, hard_to_see_from, judged, line_shares},
        behind_slit::without_lines,
        lessons::{Lesson, shelf},
        numbers::figure,
        pages::Page,
        readings::COUNTS,
        ticks::short,
    },
    languages::{fixed, translated},
};

/// What is to be noticed on a page, and a question to try.
pub(super) fn words(app: &App, page: Page) -> (String, String) {
    if page != Page::Spectrum {
        return (page.meaning().to_owned(), String::new());
    }
    let derived = app.derived();
    let spikes = derived.model.lines();
    let share: f64 = spikes
        .iter()
        .filter_map(|spike| derived.parts.share(spike.weight))
        .sum();
    let settings = &app.document().settings;
    if judged(app) == Err(COUNTS) {
        return (
            tr!("{n} line in the counts." | "{n} lines in the counts." % spikes.len()),
            said!("Combine corrects them with a known light: which light are they?").to_owned(),
        );
    }
    if spikes.is_empty() && derived.measured.iter().all(|value| *value <= 0.0) {
        let [from, to] = [derived.band.min_nm(), derived.band.max_nm()];
        let [from, to] = [short(from), short(to)];
        let notice = tr!(
            "Nothing above zero lies between {from} and {to} nm.",
            from,
            to
        );
        return (
            notice,
            said!("Set another range, or open another spectrum.").to_owned(),
        );
    }
    let below = match spikes.is_empty() {
        true => line_shares(app),
        false => Vec::new(),
    };
    let lost = without_lines(app, &below);
    let notice = match spikes.len() {
        0 if !below.is_empty() => {
            let left =
                tr!("{n} line is left to the waves."
                    | "{n} lines are left to the waves." % below.len());
            let rest = lost.unwrap_or_else(|| {
                tr!(
                    "The largest holds {share} % of the power.",
                    share = figure(below[0])
                )
            });
            format!("{left} {rest}")
        }
        0 if !settings.spikes => said!("Lines are off: the waves have to draw them.").to_owned(),
        0 => no_lines(app),
        count => tr!(
            "{n} line holds {share} % of the power."
                | "{n} lines hold {share} % of the power." % count,
            share = fixed(100.0 * share, 0)
        ),
    };
    let order = derived.model.smooth().order();
    let as_it_starts = app.document().settings == Settings::default();
    let family = app.told().and_then(|told| told.family);
    let of_family = family.map_or("", |family| family.question.as_str());
    if !below.is_empty() {
        return (
            notice,
            said!("Push Lines to the right to keep them.").to_owned(),
        );
    }
    if as_it_starts && !of_family.is_empty() {
        return (notice, translated(of_family).to_owned());
    }
    let question = question(app, order, !spikes.is_empty());
    (notice, question)
}

/// What to try with the waves and lines of a model of so many waves.
fn question(app: &App, order: usize, has_lines: bool) -> String {
    match hard_to_see_from(app) {
        Some(from) if from > 0 && order > from => {
            tr!(
                "Pull Waves left to {waves}. The curve goes wrong: do the colours?",
                waves = from
            )
        }
        Some(from) if from > 0 && order < from => {
            tr!(
                "Push Waves right to {waves}: what becomes right first, curve or colours?",
                waves = from
            )
        }
        Some(_) if has_lines => {
            said!("Pull Lines to the left until one drops out: which colours notice?").to_owned()
        }
        Some(_) => said!("Pull Waves left to 0: what is left of the colours?").to_owned(),
        None => said!("Push Waves to the right: do the colours ever come right?").to_owned(),
    }
}

/// What is known of a spectrum in which no line was found.
fn no_lines(app: &App) -> String {
    let settings = app.document().settings;
    if app.document().as_given().is_some() {
        return said!("The model keeps no line.").to_owned();
    }
    match settings.detector {
        Detector::Energy => {
            let least = settings.threshold_percent.min(LINE_THRESHOLDS[0]);
            tr!(
                "No line holds {share} % of the power or more.",
                share = short(least)
            )
        }
        Detector::Gradient => {
            let least = short(settings.gradient_percent);
            tr!("No line is steeper than {slope} % per nm.", slope = least)
        }
    }
}

/// The lesson that answers what a page asks; none in Learn, where all of them are.
pub(super) fn lesson(app: &App, page: Page) -> Option<&'static Lesson> {
    let family = app.told().and_then(|told| told.family);
    let of_light = match family.map_or("", |family| &family.key) {
        "sun" => Some("missing"),
        "line-tube" | "lps" => Some("gas"),
        "flame" | "incandescent" => Some("hotter"),
        "white-led" | "violet-led" | "mixed-led" => Some("phone"),
        _ => None,
    };
    let name = match (page, of_light) {
        (Page::Spectrum, Some(name)) => name,
        (Page::Spectrum, None) if app.derived().model.lines().is_empty() => "colour",
        (page, _) => page.lesson()?,
    };
    let lesson = shelf::as_spoken().iter().find(|lesson| lesson.name == name);
    lesson.map(|lesson| &**lesson)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{Command, pages::Place};
    use crate::spectrum::Band;

    #[test]
    fn lines_that_are_not_taken_out_are_not_said_to_be_absent() {
        let mut app = App::new();
        let settings = Settings {
            spikes: false,
            ..app.document().settings
        };
        app.apply(Command::Edit(settings));
        let (notice, _) = words(&app, Page::Spectrum);
        let said = "4 lines are left to the waves. The eye hardly notices, but an instrument sees ";
        assert!(notice.starts_with(said), "{notice}");
        // Steepness is not counted in shares: it is not known how many lines there are.
        let settings = Settings {
            detector: Detector::Gradient,
            ..settings
        };
        app.apply(Command::Edit(settings));
        let (notice, _) = words(&app, Page::Spectrum);
        assert!(notice.starts_with("Lines are off:"), "{notice}");
    }

    #[test]
    fn lines_below_the_threshold_are_counted_and_only_their_absence_is_said_to_be_one() {
        let with = |key: &str, threshold_percent: f64| {
            let mut app = crate::app::showing(key);
            let settings = Settings {
                threshold_percent,
                ..app.document().settings
            };
            app.apply(Command::Edit(settings));
            assert!(app.derived().model.lines().is_empty(), "{key}");
            words(&app, Page::Spectrum)
        };
        let (notice, question) = with("cie_fluorescent_1nm/FL2", 30.0);
        let said = "4 lines are left to the waves. The eye hardly notices, but an instrument sees ";
        assert!(notice.starts_with(said), "{notice}");
        assert_eq!(question, "Push Lines to the right to keep them.");
        let (notice, question) = with("cie_illuminants/CIE A", 30.0);
        assert_eq!(notice, "No line holds 0.1 % of the power or more.");
        assert!(!question.contains("Lines"), "{question}");
    }

    #[test]
    fn a_range_without_light_asks_no_question_about_its_colours() {
        let mut app = App::new();
        let settings = Settings {
            band: Band::new(1800.0, 1900.0).unwrap(),
            ..app.document().settings
        };
        app.apply(Command::Edit(settings));
        let (notice, question) = words(&app, Page::Spectrum);
        assert_eq!(notice, "Nothing above zero lies between 1800 and 1900 nm.");
        assert!(question.starts_with("Set another range"), "{question}");
    }

    #[test]
    fn every_page_but_those_of_learn_has_a_lesson_and_lights_of_a_family_have_their_own() {
        let mut app = App::new();
        for page in Page::all() {
            let lesson = lesson(&app, page);
            assert_eq!(lesson.is_none(), page.place() == Place::Learn, "{page:?}");
        }
        for (light, name) in [
            ("line_tubes/Neon tube", "gas"),
            ("thermal_lights/Candle flame", "hotter"),
            ("cie_led_1nm/LED-B3", "phone"),
        ] {
            let entry = app.entry(light).expect("shipped");
            app.apply(Command::Show(entry));
            let offered = lesson(&app, Page::Spectrum).map(|lesson| lesson.name.as_str());
            assert_eq!(offered, Some(name), "{light}");
        }
    }
}
