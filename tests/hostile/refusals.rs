//! What is no spectrum is refused, however large it is, in a time that grows as the file does, and
//! in no more memory than 512 MiB or 20 times the file.

use std::fs;

use super::large::{most_memory, told_of};

const SIZE: usize = 200_000_000;

/// As many bytes as an instrument's own format may have.
const SIZE_OF_FORMAT: usize = 64_000_000;

/// From so many seconds of the processor on it is asked how the time grows: less is at once on any
/// machine.
const SECONDS: f64 = 2.0;

/// Times as long for four times the file: 4 where each byte is read so often, 16 where each is read
/// once for every other one. Between them, for caches and the noise of a busy machine.
const MOST_GROWTH: f64 = 9.0;

/// What a file starts with, and what follows again and again.
enum Shape {
    /// Words.
    Of(&'static str, &'static str),
    /// What is too long to be written out.
    Made(fn() -> (String, String)),
}

use Shape::{Made, Of};

/// Some rows of as many numbers.
fn wide(columns: usize, row: &str) -> String {
    row.repeat(columns / 2) + "1\n"
}

/// What may be as large as any file.
const TABLES: &[(&str, Shape)] = &[
    // One line.
    ("commas.csv", Of("", ",")),
    ("semicolons.csv", Of("", ";")),
    ("tabs.tsv", Of("", "\t")),
    ("blanks.txt", Of("", " ")),
    ("quotes.csv", Of("", "\"")),
    ("quoted_commas.csv", Of("", "\"\",")),
    ("digits.txt", Of("", "1234567890")),
    ("letters.txt", Of("", "abcdefghij")),
    ("words.txt", Of("", "some words ")),
    ("numbers.txt", Of("", "1 ")),
    ("hashes.txt", Of("", "#")),
    ("open_brackets.txt", Of("", "[")),
    ("open_brackets.json", Of("", "[")),
    ("open_braces.txt", Of("", "{")),
    ("less_than.xml", Of("", "<")),
    ("nuls.bin", Of("", "\0")),
    ("nuls_in_words.txt", Of("", "ab\0\0")),
    ("semicolon_comma.csv", Of("", ";,")),
    ("no_break_spaces.txt", Of("", "\u{a0}")),
    // Lines without rows.
    ("line_ends.txt", Of("", "\n")),
    ("carriage_returns.txt", Of("", "\r")),
    ("both_line_ends.txt", Of("", "\r\n")),
    ("lines_of_a_comma.csv", Of("", ",\n")),
    ("lines_of_a_quote.csv", Of("", "\"\n")),
    ("lines_of_a_letter.txt", Of("", "a\n")),
    ("lines_of_a_letter_and_a_figure.txt", Of("", "a1,b\n")),
    (
        "lines_of_words.txt",
        Of("", "some words here and 12 more\n"),
    ),
    ("comments.spd", Of("", "# a\n")),
    ("keys.txt", Of("", "Name: value\n")),
    ("column_of_ones.txt", Of("", "1\n")),
    ("column_of_numbers.txt", Of("", "1234567.5\n")),
    ("by_turns.csv", Of("", "1,\n,1\n")),
    ("single_rows.csv", Of("", "1,2\na,b\n")),
    // Rows that are no table.
    ("rows_without_wavelengths.txt", Of("", "1 2\n")),
    ("rows_of_words_and_numbers.csv", Of("", "1,2,a,b\n")),
    ("rows_of_gaps.csv", Of("", "380,,\n")),
    ("one_wavelength.txt", Of("", "400 1\n")),
    ("thousands.txt", Of("", "1'000 2'000\n")),
    ("tables_of_two_rows.txt", Of("", "1 2\n3 4\nx\n")),
    (
        "tables_of_three_rows.txt",
        Of("", "380 1\n390 2\n400 3\nx\n"),
    ),
    (
        "tables_of_five_rows.txt",
        Of("", "380 1\n390 2\n400 3\n410 4\n420 5\nx\n"),
    ),
    (
        "wide_tables.csv",
        Made(|| (String::new(), wide(4000, "1,1,").repeat(2) + "x\n")),
    ),
    (
        "words_among_columns.csv",
        Made(|| {
            let rows = wide(30_000, "1,a,") + &wide(30_000, "a,1,");
            (wide(30_000, "1,1,").repeat(3), rows)
        }),
    ),
    ("numbers.json", Of("{\"a\":[", "1, ")),
    ("keys.json", Of("{", "\"a\":1,")),
    ("text.json", Of("{\"a\":\"", "b")),
    ("own_titles.csv", Of("# kind: light\nwavelength_nm", ",")),
    (
        "raman_lines.txt",
        Of("#Laser: 785\n#Range (cm-1): 200 - 3198\n#Acq: 1\n", "a\n"),
    ),
    (
        "raman_rows.txt",
        Of("#Laser: 785\n#Range (cm-1): 200 - 3198\n#Acq: 1\n", "1 2\n"),
    ),
];

/// What follows the start of an instrument's own format.
const FORMATS: &[(&str, Shape)] = &[
    ("uprtek.xls", Of("Model Name\tX\nlambdap\t5\n", "\t")),
    (
        "sekonic.csv",
        Of("Date Saved,1\nMeasuring Mode,1\nTcp [K],1\nCCT,3\n", "a\n"),
    ),
    (
        "cgats.ti3",
        Of(
            "CGATS.17\nBEGIN_DATA_FORMAT\nnm380 nm390 nm400\nEND_DATA_FORMAT\nBEGIN_DATA\n",
            ",",
        ),
    ),
    (
        "jcamp_abscissas.dx",
        Of(
            "##TITLE= a\n##XUNITS= NANOMETERS\n##YUNITS= ABSORBANCE\n##XYDATA= (X++(Y..Y))\n",
            "1\n",
        ),
    ),
    (
        "jcamp_pairs.dx",
        Of(
            "##TITLE= a\n##XUNITS= NANOMETERS\n##YUNITS= ABSORBANCE\n##XYPOINTS= (XY..XY)\n",
            "a\n",
        ),
    ),
    (
        "elements.spdx",
        Of("<?xml version=\"1.0\"?><IESTM2714>", "<a/>"),
    ),
    ("elements.cxf", Of("<CxF>", "<a>b</a>")),
    ("blanks.yml", Of("", "\n")),
];

#[test]
#[cfg(target_os = "linux")]
fn the_time_of_a_refusal_grows_as_the_file_and_its_memory_stays_that_of_any_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut wrong = Vec::new();
    let only = std::env::var("SPECTRAL_EXPLORER_HOSTILE_FILE").unwrap_or_default();
    println!("file, bytes, ms of the processor, peak MiB, times its size, answer");
    let tables = TABLES.iter().map(|shape| (shape, SIZE));
    let formats = FORMATS.iter().map(|shape| (shape, SIZE_OF_FORMAT));
    for ((name, shape), most) in tables.chain(formats) {
        if !name.contains(&only) {
            continue;
        }
        let (head, piece) = match shape {
            Of(head, piece) => ((*head).to_owned(), (*piece).to_owned()),
            Made(made) => made(),
        };
        let path = folder.path().join(name);
        let put = |most: usize| {
            let bytes = head.clone() + &piece.repeat(most / piece.len());
            fs::write(&path, &bytes).expect("room on the disk");
            bytes.len()
        };
        let size = put(most);
        match told_of(&path, size) {
            Err(why) => wrong.push(format!("{name}: {why}")),
            Ok(told) => {
                println!(
                    "{name}, {size}, {:.0}, {:.1}, {:.1}, {}",
                    told.seconds * 1e3,
                    told.memory as f64 / f64::from(1 << 20),
                    told.memory as f64 / size as f64,
                    told.answer
                );
                if !told.answer.contains("expected") {
                    wrong.push(format!("{name} is read: {}", told.answer));
                }
                if told.memory > most_memory(size) {
                    wrong.push(format!("{name}: {} bytes for {size}", told.memory));
                }
                if told.seconds > SECONDS {
                    let quarter = put(most / 4);
                    match told_of(&path, quarter) {
                        Ok(less) if told.seconds <= MOST_GROWTH * less.seconds => {}
                        less => wrong.push(format!(
                            "{name}: {:.1} s, and {:?} s for a quarter of it",
                            told.seconds,
                            less.map(|less| less.seconds)
                        )),
                    }
                }
            }
        }
        fs::remove_file(path).expect("a file to remove");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
