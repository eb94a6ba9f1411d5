//! `race`: the composite beside other representations at equal counts of numbers.

use std::{ffi::OsStr, io::Write, path::Path, sync::Arc};

use super::{
    arguments::Race,
    folder::{files_in, spectra_of},
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    subject::{self, no_power, with_power},
};
use crate::{
    app::{
        App, ByAddress, Entry, Library,
        charts::race::Ways,
        race_report,
        studies::{Class, Field, Question, RaceAsk},
    },
    io::{many::many, quoted, shown},
    preset::Preset,
    spectrum::Kind,
    study::Progress,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input or a set that cannot be read or has no light.
pub(super) fn run(options: &Race, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let Race {
        input,
        numbers,
        set,
        pick,
        model,
        strict,
        json,
    } = options;
    let (app, field) = match (input, set) {
        (Some(_), Some(_)) => {
            return Err(Refusal::Usage(
                "--set: found an INPUT too, expected one of them".to_owned(),
            ));
        }
        (Some(input), None) => {
            let app = subject::app(input, pick, *model, inputs)?;
            let field = alone(&app)?;
            with_power(&app)?;
            (app, field)
        }
        (None, Some(set)) => (subject::first_app(pick, *model)?, set_of(set, inputs)?),
        (None, None) => (subject::first_app(pick, *model)?, Field::Shipped),
    };
    let mut budgets = numbers.clone();
    budgets.sort_unstable();
    budgets.dedup();
    let ask = RaceAsk {
        strict: *strict,
        ..RaceAsk::of(app.document(), field, budgets)
    };
    if let Some(why) = ask.why_not() {
        return Err(Refusal::Usage(format!("--range: {why}")));
    }
    let race = ask
        .answer(&Progress::default())
        .ok_or_else(|| match (input, set) {
            (Some(_), _) => no_power(&app),
            (None, set) => Refusal::File(format!(
                "{}: found no light with a value above zero from {} to {} nm, expected one to \
                 measure",
                set.as_ref().map_or_else(
                    || "the shipped lights".to_owned(),
                    |set| shown(Path::new(set))
                ),
                ask.band.min_nm(),
                ask.band.max_nm(),
            )),
        })?;
    for lamp in ask.lamps() {
        if !lamp.shines() {
            let band = ask.band;
            inputs.remark(&format!(
                "skipped: {}: nothing above zero from {} to {} nm",
                lamp.name,
                band.min_nm(),
                band.max_nm()
            ));
        }
    }
    if *json {
        print_json(out, &race_report::race_json(&ask, &race))
    } else {
        let won = Ways::of(&ask, &race, &ask.budgets);
        let lines = won.map_or_else(Vec::new, |ways| ways.notes());
        print(out, &race_report::race_table(&ask, &race, &lines).csv())
    }
}

/// The input as the only light.
fn alone(app: &App) -> Result<Field, Refusal> {
    Ok(Field::One(ByAddress(light_alone(app)?)))
}

/// The light that the input is.
///
/// # Errors
/// [`Refusal::File`] for an input that is no light.
pub(super) fn light_alone(app: &App) -> Result<Arc<Entry>, Refusal> {
    let document = app.document();
    if !document.is_about_light() {
        let subject = document.subject_entry();
        return Err(Refusal::File(format!(
            "{}: found a {}, expected a light (say --kind)",
            subject.name(),
            subject.kind(),
        )));
    }
    Ok(document.light.clone())
}

/// The lights of a class, a group or a folder.
fn set_of(set: &OsStr, inputs: &mut Inputs) -> Result<Field, Refusal> {
    let folder = Path::new(set);
    let set = set.to_string_lossy();
    let word = set.trim().to_lowercase();
    let called = |class: &Class| class.word().to_lowercase() == word;
    if let Some(class) = Class::ALL.into_iter().find(called) {
        return Ok(Field::Class(class));
    }
    if let Some(group) = Library::bundled().group(&word) {
        let shown = |preset: &Preset| Entry::of_preset(preset);
        let is_light = |entry: &Entry| entry.kind() == Kind::Light;
        if group.items.iter().filter_map(shown).any(|e| is_light(&e)) {
            return Ok(Field::Group(word));
        }
        return Err(Refusal::File(format!(
            "--set: found the group {word}, which has no light, expected a group of lights"
        )));
    }
    if folder.is_dir() {
        return lights_in(folder, inputs);
    }
    Err(Refusal::File(format!(
        "--set: found {}, expected a group of presets, smooth, led, fluorescent, discharge or a \
         folder",
        quoted(&set)
    )))
}

/// Every light in the files of a folder, not in the folders below it.
fn lights_in(folder: &Path, inputs: &mut Inputs) -> Result<Field, Refusal> {
    let paths = files_in(folder)?;
    let spectra = spectra_of(&paths, inputs).into_iter();
    let (lights, others): (Vec<_>, Vec<_>) = spectra
        .map(|(_, spectrum)| spectrum)
        .partition(|spectrum| spectrum.kind == Kind::Light);
    if !others.is_empty() {
        let others = many(
            others.len(),
            "spectrum that is no light",
            "spectra that are no lights",
        );
        inputs.remark(&format!("skipped {others}"));
    }
    if lights.is_empty() {
        return Err(Refusal::File(format!(
            "{}: found no light in {}, expected at least one",
            shown(folder),
            many(paths.len(), "file", "files"),
        )));
    }
    let entry = |(number, light)| ByAddress(Arc::new(Entry::own(number, light)));
    Ok(Field::These((1..).zip(lights).map(entry).collect()))
}
