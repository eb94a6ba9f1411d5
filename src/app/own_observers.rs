//! Observers from files: colour-matching functions of one's own, or the sensitivities of a camera.

use std::{path::Path, sync::Arc};

use super::{App, Entry};
use crate::{
    color::{ColourMatching, Observer},
    io::read_path,
    spectrum::{Kind, NamedSpectrum},
};

/// The observer of a file that holds three functions of wavelength: x, y, z (or red, green, blue)
/// by their names, else in the file's order.
///
/// # Errors
/// What was found and what was expected, in one sentence that names the file.
pub fn observer_of_file(path: &Path) -> Result<Observer, String> {
    let reading = read_path(path).map_err(|error| error.to_string())?;
    let three: Vec<&NamedSpectrum> = reading.spectra.iter().collect();
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    observer_of(&name, &reading.file, &three).map_err(|why| format!("{}: {why}", reading.file))
}

/// The observer of three functions.
///
/// # Errors
/// What was found and what was expected.
fn observer_of(name: &str, source: &str, three: &[&NamedSpectrum]) -> Result<Observer, String> {
    let &[first, second, third] = three else {
        return Err(tr!(
            "found {n} column, expected three functions of wavelength: x, y, z or red, green, blue"
                | "found {n} columns, expected three functions of wavelength: x, y, z or red, \
                   green, blue"
                    % three.len()
        ));
    };
    let mut ordered = [first, second, third];
    let places = ordered.map(|function| place_of(&function.name));
    if let [Some(a), Some(b), Some(c)] = places
        && a + b + c == 3
        && a != b
        && b != c
    {
        for (function, place) in [first, second, third].into_iter().zip([a, b, c]) {
            ordered[place] = function;
        }
    }
    ColourMatching::of(ordered.map(|function| &function.samples))
        .and_then(|table| Observer::own(name, source, table))
        .map_err(|why| why.to_string())
}

/// Which of three functions a column's title names: `x̄`, `xbar`, `R`, `red`, `z10(λ)`.
fn place_of(title: &str) -> Option<usize> {
    let words = title.split(|c: char| !c.is_alphabetic() && c != '\u{304}' && c != '_');
    let mut places = words.filter_map(|word| {
        let word = word.to_lowercase();
        let is_short = word.chars().count() <= 2;
        let is_one = |letter: char, name: &str| {
            let bar = format!("{letter}bar");
            let underlined = format!("{letter}_bar");
            word == name
                || (is_short && word.starts_with(letter))
                || word == bar
                || word == underlined
        };
        [
            [('x', "x"), ('r', "red")],
            [('y', "y"), ('g', "green")],
            [('z', "z"), ('b', "blue")],
        ]
        .iter()
        .position(|names| names.iter().any(|(letter, name)| is_one(*letter, name)))
    });
    places.next()
}

/// The observers that the window offers: the shipped ones, the one in force, and every opened file
/// of three sensitivities.
pub fn observers(app: &App) -> Vec<Observer> {
    let mut all: Vec<Observer> = Observer::shipped().collect();
    let entries = &app.document().own;
    for entry in entries {
        let Some(from) = entry.origin.file() else {
            continue;
        };
        if from.index != 0 || from.reading.spectra != 3 {
            continue;
        }
        let is_of_file = |other: &&Arc<Entry>| {
            let file = other.origin.file();
            file.is_some_and(|of| Arc::ptr_eq(&of.reading, &from.reading))
        };
        let of_file = entries.iter().filter(is_of_file);
        let three: Vec<&NamedSpectrum> = of_file.map(|other| &other.spectrum).collect();
        if three
            .iter()
            .any(|spectrum| spectrum.kind != Kind::Weighting)
        {
            continue;
        }
        let file = &from.reading.file.name;
        let name = file.rsplit_once('.').map_or(&**file, |(stem, _)| stem);
        all.extend(observer_of(name, file, &three).ok());
    }
    let chosen = app.document().settings.observer;
    if !all.contains(&chosen) {
        all.push(chosen);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_put_in_order_by_their_titles() {
        for (title, place) in [
            ("x\u{304}(\u{3bb})", Some(0)),
            ("ybar", Some(1)),
            ("z10", Some(2)),
            ("Canon 5D, R", Some(0)),
            ("green", Some(1)),
            ("B", Some(2)),
            ("sensitivity", None),
            ("column 2", None),
        ] {
            assert_eq!(place_of(title), place, "{title}");
        }
    }

    #[test]
    fn a_file_of_three_functions_is_an_observer_and_any_other_is_refused_in_words() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("my eye.csv");
        let table = Observer::CIE_1964.table();
        let rows = (390..=700).map(|nm| {
            let [x, y, z] = table.at(f64::from(nm));
            format!("{nm},{z},{x},{y}\n")
        });
        let text: String = std::iter::once("nm,zbar,xbar,ybar\n".to_owned())
            .chain(rows)
            .collect();
        std::fs::write(&path, text).expect("written");
        let own = observer_of_file(&path).expect("an observer");
        assert_eq!((own.word(), own.source()), ("my eye", "my eye.csv"));
        assert_eq!(own.table().first_nm, 390);
        // The shortest decimals come back to the bit.
        assert_eq!(own.table().at(555.0), table.at(555.0));
        let two = folder.path().join("two.csv");
        std::fs::write(&two, "nm,a,b\n400,1,2\n500,2,3\n600,1,2\n").expect("written");
        let why = observer_of_file(&two).expect_err("two columns");
        assert!(
            why.starts_with("two.csv: found 2 columns, expected three"),
            "{why}"
        );
    }
}
