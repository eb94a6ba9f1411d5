//! Thousands and decimals that are told by all numbers of a column or a row.

use crate::told::read;
use spectral_explorer::io::Guessed;

#[test]
fn rows_with_gaps_and_limits_are_written_anew_with_the_others() {
    for marks in [[",", "."], [".", ","]] {
        let row = |at: u32| {
            let value = match at {
                5 => String::new(),
                6 => "NaN".to_owned(),
                7 => format!("<0{}05", marks[1]),
                _ => format!("{}{}2345", at + 1, marks[1]),
            };
            format!("{}{}5;{value}\n", 400 + 10 * at, marks[0])
        };
        let text = "nm;W\n".to_owned() + &(0..20).map(row).collect::<String>();
        let reading = read("a.csv", text);
        let samples = &reading.spectra[0].samples;
        assert_eq!((samples.len(), samples.last_nm()), (18, 590.5), "{marks:?}");
        assert_eq!((samples.nm()[5], samples.values()[5]), (470.5, 0.05));
        let is_lost = |note: &String| note.contains("left out");
        assert!(!reading.notes.iter().any(is_lost), "{:?}", reading.notes);
    }
}

#[test]
fn thousands_that_only_whole_numbers_below_1000_tell_of_are_asked_about() {
    // The last one is proven by a second mark in it.
    for (last, is_asked) in [("1.250", true), ("1.001.250", false)] {
        let rows = ["950", "960", "970", "1.020", last];
        let rows = rows
            .iter()
            .zip(0..)
            .map(|(v, at)| format!("{};{v}\n", 400 + at));
        let text = "nm;Counts\n".to_owned() + &rows.collect::<String>();
        let reading = read("a.csv", text);
        assert_eq!(reading.spectra[0].samples.values()[3], 1020.0);
        let guesses = &reading.guesses;
        let found = guesses.iter().any(|of| of.what == Guessed::Columns);
        assert_eq!(
            (found, reading.is_doubtful()),
            (is_asked, is_asked),
            "{guesses:?}"
        );
    }
}

#[test]
fn only_zeros_of_decimals_prove_that_commas_mark_them() {
    let table = |titles: &str, row: &dyn Fn(u32) -> String| {
        let text = titles.to_owned() + &(0..8).map(row).collect::<String>();
        let reading = read("a.csv", text);
        let guesses = &reading.guesses;
        let is_asked = guesses.iter().any(|of| of.what == Guessed::Columns);
        (reading.spectra.len(), is_asked)
    };
    let decimals = |at: u32| format!("{},1,{:02}\n", 400 + at, 5 * at);
    let whole = |at: u32| format!("{},1{at},{}\n", 400 + at, 11 + 7 * at);
    let filled_up = |at: u32| format!("{},{:03},{:03}\n", 400 + at, 10 + at, 5 * at);
    assert_eq!(table("nm,W\n", &decimals), (1, false));
    assert_eq!(table("nm,W\n", &whole), (1, true));
    assert_eq!(table("nm,W\n", &filled_up), (1, true));
    assert_eq!(table("", &filled_up), (2, false));
}
