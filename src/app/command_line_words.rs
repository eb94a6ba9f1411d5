//! The command line that gives what the window shows: its numbers and its picture.

use std::fmt::Display;

use super::{
    entry::Entry,
    origin::Origin,
    pages::Page,
    settings::{Detector, Settings},
    state::App,
    ticks::short,
};
use crate::{
    io::Choices,
    languages::{Language, in_language},
    spectrum::Kind,
};

/// Two lines: `report` with the model's settings, and `render` with page, size in points and theme.
///
/// # Errors
/// A sentence where no command line gives the same: spectra that are in no file, hand edits, the
/// paper's own detector.
pub fn command_lines(app: &App, page: Page, size: [u32; 2], dark: bool) -> Result<String, String> {
    let document = app.document();
    if !document.subject_edits().is_empty() {
        return Err(
            said!("Lines were changed by hand: save the project and name its file.").to_owned(),
        );
    }
    let settings = document.settings;
    if settings.detector == Detector::Gradient {
        return Err(said!("The command line has no detector by steepness.").to_owned());
    }
    let subject = document.subject_entry();
    let mut about = words_of(subject)?;
    if subject.kind() != Kind::Light {
        let light = words_of(&document.light)?;
        if light.contains(" --spectrum ") {
            return Err(
                said!("The command line takes a light from a file of its own only.").to_owned(),
            );
        }
        about += &format!(" --light {light}");
    }
    // A composite as it is has its own series, range and lines; any option would analyse it.
    let options = match document.as_given() {
        Some(composite) => {
            let usual = Settings::default();
            let as_given = settings.with_model_of(usual).of_composite(composite);
            if settings != as_given
                || settings.observer != usual.observer
                || settings.sampling != usual.sampling
            {
                return Err(said!(
                    "A composite as it is takes no options: save the project and name its file."
                )
                .to_owned());
            }
            String::new()
        }
        None => options(settings),
    };
    let against = match document
        .second
        .as_ref()
        .filter(|_| document.is_about_light())
    {
        Some(second) => {
            let words = words_of(second)?;
            if words.contains(" --spectrum ") {
                return Err(
                    said!("The command line takes a light from a file of its own only.").to_owned(),
                );
            }
            format!(" --against {words}")
        }
        None => String::new(),
    };
    let theme = if dark { "dark" } else { "light" };
    let [width, height] = size;
    Ok(format!(
        "spectral-explorer report {about}{options}\nspectral-explorer render {about}{options}{against} \
         --page {} --size {width}x{height} --theme {theme} --out view.png",
        page.word()
    ))
}

/// What finds an entry again on the command line: its word, and which spectrum of a file it is.
fn words_of(entry: &Entry) -> Result<String, String> {
    let in_no_file = || {
        tr!(
            "{name} is in no file: save it, or the project, and name that file.",
            name = entry.name()
        )
    };
    let from = match &entry.origin {
        Origin::Preset(_) => return Ok(quoted(&entry.key)),
        Origin::File(from) => from,
        Origin::Made(_) | Origin::Numbers => return Err(in_no_file()),
    };
    let file = &from.reading.file;
    if from.reading.choices != Choices::default() {
        return Err(tr!(
            "How {file} is read was decided by hand: save the project and name its file.",
            file = file.name
        ));
    }
    let path = file.path.as_ref().ok_or_else(in_no_file)?;
    let path = quoted(&path.display().to_string());
    Ok(match from.reading.spectra {
        1 => path,
        _ => format!("{path} --spectrum {}", from.index + 1),
    })
}

/// Between quotation marks where a shell would part it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/_-.+:".contains(c);
    match word.chars().all(plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

/// An option with its value, where that differs.
fn value<T: PartialEq + Display>(option: &str, value: T, usual: T) -> Option<String> {
    (value != usual).then(|| format!(" --{option} {value}"))
}

/// The options that make the settings of every command these.
fn options(settings: Settings) -> String {
    let usual = Settings::default();
    let Settings {
        basis,
        spikes,
        wide_lines,
        dips,
        detector: _,
        colour_exact,
        band,
        observer,
        sampling,
        .. // Numbers, which have their options beside them.
    } = settings;
    let numbers = Settings::KNOBS
        .into_iter()
        .filter(|(option, _)| !option.is_empty());
    let numbers = numbers.map(|(option, knob)| {
        let [now, usual] = [settings, usual].map(|mut settings| knob.get(&mut settings));
        value(option, now, usual)
    });
    let flag = |is_said: bool, option: &str| is_said.then(|| format!(" --{option}"));
    let ends = || [band.min_nm(), band.max_nm()].map(short);
    let [least, most] = in_language(Language::English, ends);
    let said = [
        value("basis", basis.word(), usual.basis.word()),
        flag(!colour_exact, "plain"),
        flag(!spikes, "no-spikes"),
        flag(wide_lines, "wide-lines"),
        flag(dips, "dips"),
        flag(band != usual.band, &format!("range {least}:{most}")),
        (observer != usual.observer).then(|| {
            let own = || quoted(observer.source());
            let word = if observer.is_shipped() {
                observer.word().to_owned()
            } else {
                own()
            };
            format!(" --observer {word}")
        }),
        value("sampling", sampling.word(), usual.sampling.word()),
    ];
    numbers.chain(said).flatten().collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{
        app::{
            Command, assert_says,
            open::{Loaded, load_path_as, resolve},
        },
        spectrum::{Basis, NamedSpectrum},
    };

    fn lines(app: &App) -> Result<String, String> {
        command_lines(app, Page::Tradeoff, [1280, 800], true)
    }

    #[test]
    fn only_what_differs_from_the_commands_own_settings_is_said() {
        let mut app = App::new();
        let told = lines(&app).expect("a shipped light");
        assert_eq!(
            told,
            "spectral-explorer report cie_fluorescent_1nm/FL2\nspectral-explorer render cie_fluorescent_1nm/FL2 --page tradeoff \
             --size 1280x800 --theme dark --out view.png"
        );
        app.apply(Command::Edit(Settings {
            order: 12,
            threshold_percent: 1.25,
            basis: Basis::Fourier,
            colour_exact: false,
            spikes: false,
            ..app.document().settings
        }));
        let told = lines(&app).expect("a shipped light");
        let options = "FL2 --order 12 --threshold 1.25 --basis fourier --plain --no-spikes";
        assert_says(&told, &format!("report cie_fluorescent_1nm/{options}\n"));
        assert_says(
            &told,
            &format!("render cie_fluorescent_1nm/{options} --page"),
        );
    }

    #[test]
    fn names_are_quoted_and_what_is_in_no_file_is_said() {
        let mut app = App::new();
        let d65 = resolve("CIE D65", None, None).expect("shipped");
        let numbers: NamedSpectrum = d65.spectrum.clone();
        app.apply(Command::Show(Arc::new(d65)));
        let told = lines(&app).expect("a shipped light");
        assert_says(&told, "report 'cie_illuminants/CIE D65'\n");
        app.apply(Command::Show(Arc::new(
            resolve("paper/Mercury", None, None).expect("shipped"),
        )));
        let told = lines(&app).expect("a composite");
        assert!(
            told.starts_with("spectral-explorer report paper/Mercury\n"),
            "{told}"
        );
        let order = Settings {
            order: 3,
            ..app.document().settings
        };
        app.apply(Command::Edit(order));
        assert!(lines(&app).is_err_and(|why| why.contains("takes no options")));
        app.apply(Command::Adopt(vec![numbers]));
        assert!(lines(&app).is_err_and(|why| why.contains("in no file")));
    }

    #[test]
    fn one_of_several_in_a_file_is_named_behind_the_quoted_path_and_other_readings_are_said() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("two of them.csv");
        let rows: String = (0..9)
            .map(|i| format!("{},1,{i}\n", 400 + 40 * i))
            .collect();
        std::fs::write(&path, format!("nm,a,b\n{rows}")).expect("written");
        let shown = |choices: &Choices| {
            let mut app = App::new();
            let Loaded::File(opened) = load_path_as(&path, choices) else {
                panic!("spectra");
            };
            app.apply(Command::Open(vec![*opened]));
            lines(&app)
        };
        let told = shown(&Choices::default()).expect("in a file");
        let start = format!("spectral-explorer report '{}' --spectrum ", path.display());
        assert!(told.starts_with(&start), "{told}");
        let by_hand = Choices {
            kind: Some(Kind::Light),
            ..Choices::default()
        };
        assert!(shown(&by_hand).is_err_and(|why| why.contains("by hand")));
    }
}
