//! Plain columns: CSV, TSV and whatever else writes wavelengths and values as text.
//!
//! Nothing about the table is taken from the extension. [`pick`] finds delimiter and
//! decimal mark, [`block`](crate::io::table::block) the blocks of numbers,
//! [`titles`](crate::io::table::titles) and [`layout`](crate::io::table::layout) where the wavelengths are,
//! [`meaning`](crate::io::interpret::meaning) what the values stand for,
//! [`curve`](crate::io::interpret::curve) puts them in order. Each decision is a note, each guess a
//! [`Guess`](crate::io::Guess).

use super::{Confidence, Format};
use crate::io::interpret::check_room;
use crate::io::reading::TableFound;
use crate::io::table::block::{BadCell, most_left_out};
use crate::io::table::columns::{File, read_groups};
use crate::io::table::layout::Layout;
use crate::io::table::pick::{self, Look, NoTable, Table};
use crate::io::table::roles::{self, Group};
use crate::io::table::rows::{AlongRow, read_rows};
use crate::io::table::{alternating, no_table};
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::write::csv::{self, Own};
use crate::io::{Choices, Guess, Guessed, Input, ReadError, Reading};

/// Plain columns of numbers.
pub(crate) const FORMAT: Format = Format {
    name: "plain columns",
    extensions: &["csv", "tsv", "txt", "dat", "asc", "prn"],
    sniff,
    read,
};

fn sniff(input: &Input) -> Confidence {
    match input.text() {
        Some(text) if csv::is_own(&text.text) => Confidence::Own,
        Some(_) => Confidence::Possible,
        None => Confidence::No,
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let mut reading = read_cells(input)?;
    let dialect = reading.table.as_ref().map(|table| table.dialect);
    reading.notes.extend(dialect.map(Dialect::words));
    Ok(reading)
}

/// Reads columns; how their cells are set apart is not told.
///
/// # Errors
/// [`ReadError`] when there is no table.
pub(crate) fn read_cells(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let Choices {
        dialect, delimiter, ..
    } = input.choices;
    let own = Own::of(text).filter(|_| dialect.is_none() && delimiter.is_none());
    let look = match (&own, dialect) {
        (Some(_), _) => Look::at_all(text, csv::DIALECT),
        (None, Some(dialect)) => Look::at_all(text, dialect),
        (None, None) => pick::look(text, delimiter),
    };
    let dialect = look.dialect;
    let found = match &own {
        Some(own) => pick::own_tables(own),
        None => look.tables(),
    };
    let mut tables = match found {
        Ok(tables) => tables,
        // A table with a word in it is a table: read in another way it would be nonsense.
        Err(bad @ NoTable::Bad(_)) => return Err(no_table::refusal(input, text, bad)),
        Err(why) => {
            if let Some(pairs) = alternating::find(text) {
                return alternating::read(input, &pairs);
            }
            return Err(no_table::refusal(input, text, why));
        }
    };
    let file = File {
        input,
        dialect,
        own: own.as_ref(),
    };
    check_room(input, tables.len())?;
    let left_out = without_false_tables(&file, &mut tables);
    let mut reading = Reading {
        notes: left_out,
        table: tables.iter().find(|t| !t.is_short).map(|table| TableFound {
            dialect,
            axis_column: match table.layout {
                Layout::Column(column) => Some(column),
                Layout::Row { .. } => None,
            },
            width: table.block.width,
            first_line: table.block.lines[0] as usize,
            values: Vec::new(),
        }),
        ..Reading::default()
    };
    let several = tables.len() > 1;
    if let Some(column) = input.choices.axis_column {
        for table in tables.iter_mut().filter(|table| !table.is_short) {
            if column >= table.block.width {
                return Err(input.error(
                    format!("a table of {} columns", table.block.width),
                    format!("wavelengths in column {}, as chosen", column + 1),
                ));
            }
            table.layout = Layout::Column(column);
        }
        if let Some(found) = &mut reading.table {
            found.axis_column = Some(column);
        }
    }
    for (number, table) in tables.iter_mut().enumerate() {
        let part = if several {
            format!(", table {}", number + 1)
        } else {
            String::new()
        };
        read_table(&file, table, &part, &mut reading)?;
    }
    // Columns and rows that are nearly empty were left out; here that was all of them.
    if reading.spectra.is_empty() {
        return Err(too_sparse(input, &tables));
    }
    Ok(reading)
}

/// Leaves out short tables that turn out to be none, and says so.
fn without_false_tables(file: &File, tables: &mut Vec<Table>) -> Vec<String> {
    let mut left_out = Vec::new();
    tables.retain(|table| {
        let read = || read_table(file, &mut table.clone(), "", &mut Reading::default());
        let Some(why) = table.is_short.then(read).and_then(Result::err) else {
            return true;
        };
        let lines = pick::lines_left_out(&table.block);
        left_out.push(format!("{lines}: found {}", why.found));
        false
    });
    left_out
}

/// The refusal for tables whose every column or row has next to no values.
fn too_sparse(input: &Input, tables: &[Table]) -> ReadError {
    let of = match tables.first().map(|table| &table.layout) {
        Some(Layout::Row { .. }) => "row",
        _ => "column",
    };
    let refusal = input.error(
        format!("fewer than two values in every {of}"),
        "at least two values of a spectrum",
    );
    match tables.first().and_then(|table| table.block.lines.first()) {
        Some(line) => refusal.at_line(*line as usize),
        None => refusal,
    }
}

fn read_table(
    file: &File,
    table: &mut Table,
    part: &str,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    reading.notes.extend(table.notes.iter().cloned());
    let first = reading.spectra.len();
    let doubt = titles_short_of_cells(table, file.dialect);
    match &table.layout {
        Layout::Column(wavelength) => {
            let wavelength = *wavelength;
            let (groups, left_out) = match file.own {
                Some(_) => (vec![all_beside(wavelength, table.block.width)], Vec::new()),
                None => roles::groups(&table.block, &table.titles, wavelength),
            };
            reading
                .notes
                .extend(check(file, table, wavelength, &groups)?);
            if let Some(found) = &mut reading.table
                && found.values.is_empty()
                && !table.is_short
            {
                let values = groups.iter().flat_map(|group| &group.values);
                found.values = values.copied().collect();
            }
            read_groups(file, table, &groups, part, left_out, reading)?;
        }
        Layout::Row {
            first,
            axis,
            from_row,
            says_nm,
        } => {
            let row = AlongRow {
                first: *first,
                axis,
                from_row: *from_row,
                says_nm: *says_nm,
            };
            read_rows(file.input, file.dialect, table, &row, reading)?;
        }
    }
    if let Some(because) = doubt
        && first < reading.spectra.len()
    {
        reading.guesses.push(Guess {
            spectrum: first,
            what: Guessed::Columns,
            chosen: file.dialect.words(),
            because,
            plain: false,
        });
    }
    Ok(())
}

/// Every column but the wavelengths.
fn all_beside(axis: usize, width: usize) -> Group {
    Group {
        axis,
        values: (0..width).filter(|column| *column != axis).collect(),
    }
}

/// Refuses words among the numbers that count, and tables without any. Where a column is all numbers
/// but for a word or two, these are gaps, and said.
fn check(
    file: &File,
    table: &Table,
    wavelength: usize,
    groups: &[Group],
) -> Result<Vec<String>, ReadError> {
    let block = &table.block;
    let mut counts = vec![false; block.width];
    counts[wavelength] = true;
    for group in groups {
        counts[group.axis] = true;
        group
            .values
            .iter()
            .for_each(|column| counts[*column] = true);
    }
    let most = most_left_out(block.rows());
    let bad = block.bad.iter().filter(|bad| counts[bad.column]);
    let (few, many): (Vec<&BadCell>, Vec<&BadCell>) =
        bad.partition(|bad| block.columns[bad.column].texts <= most);
    if let Some(bad) = many.into_iter().min_by_key(|bad| bad.line) {
        return Err(bad.refusal(file.input));
    }
    if groups.iter().all(|group| group.values.is_empty()) {
        return Err(file
            .input
            .error(
                "wavelengths and no values (empty cells, words such as NaN and numbers of 1e30 \
                 and beyond count as missing)",
                no_table::A_TABLE,
            )
            .at_line(block.lines[0] as usize));
    }
    Ok(few.into_iter().map(|bad| bad.left_out("cell")).collect())
}

/// What speaks against the cells of a table with commas between them: fewer titles than numbers in
/// each row. Decimal commas without quotes look so.
fn titles_short_of_cells(table: &Table, dialect: Dialect) -> Option<String> {
    let block = &table.block;
    let (line, titles) = block.header.last()?;
    let mut cells = Vec::new();
    dialect.split(titles, &mut cells);
    let count = used(&cells);
    let is_title = |cell: &&str| cell.contains(char::is_alphabetic);
    let has_row_names = block.columns[0].numbers == 0 || block.counts_rows(0);
    (dialect.delimiter == Delimiter::Comma
        && !dialect.decimal_comma
        && !has_row_names
        && (2..block.width).contains(&count)
        && cells[..count].iter().all(is_title)
        && block.columns[count..]
            .iter()
            .all(|column| column.numbers > 0))
    .then(|| {
        format!(
            "line {line} has {count} titles and the rows {} cells; commas may mark decimals",
            block.width
        )
    })
}

#[cfg(test)]
mod tests {
    use crate::io::{Guessed, Reading, read_bytes};
    use crate::spectrum::Kind;

    #[test]
    fn the_r_of_rgb_is_no_reflectance() {
        let text = b"nm,R,G,B\n400,0.1,0.2,0.3\n410,0.2,0.3,0.4\n420,0.3,0.4,0.5\n";
        let spectra = read_bytes("a.csv", text).unwrap().spectra;
        assert!(spectra.iter().all(|s| s.kind == Kind::Light), "{spectra:?}");
        assert_eq!(spectra[0].name, "R");
        let alone = b"nm,R\n400,0.1\n410,0.2\n420,0.3\n";
        let leaf = &read_bytes("a.csv", alone).unwrap().spectra[0];
        assert_eq!(leaf.kind, Kind::Reflectance);
    }

    #[test]
    fn columns_of_one_title_are_named_by_the_line_above() {
        for text in [
            "WP,first,second\nWavelength,Processed,Processed\n400,1,2\n410,3,4\n420,5,6\n",
            "first,,second,,\nWavelength (nm),%T,Wavelength (nm),%T,\n400,1,400,2,\n410,3,410,4,\n420,5,420,6,\n",
        ] {
            let spectra = read_bytes("a.csv", text.as_bytes()).unwrap().spectra;
            let names: Vec<&str> = spectra.iter().map(|s| s.name.as_str()).collect();
            assert_eq!(names, ["first", "second"], "{text}");
        }
    }

    #[test]
    fn pairs_side_by_side_have_wavelengths_of_their_own() {
        let text = b"nm,%T,nm,%T\n400,1,402,5\n410,2,412,6\n420,3,422,7\n,,432,8\n";
        let reading = read_bytes("a.csv", text).unwrap();
        let samples: Vec<_> = reading.spectra.iter().map(|s| &s.samples).collect();
        assert_eq!(samples[0].nm(), [400.0, 410.0, 420.0]);
        assert_eq!(samples[1].nm(), [402.0, 412.0, 422.0, 432.0]);
        let said = "holds the wavelengths of the columns behind it";
        assert!(
            reading.notes.iter().any(|note| note.contains(said)),
            "{reading:?}"
        );
    }

    #[test]
    fn the_other_end_of_a_band_is_no_axis_of_its_own() {
        let text = b"wl_min,wl_max,E,F\n400,401,1,5\n401,402,2,6\n402,403,3,7\n";
        let spectra = read_bytes("a.csv", text).unwrap().spectra;
        assert!(
            spectra.iter().all(|s| s.samples.first_nm() == 400.0),
            "{spectra:?}"
        );
    }

    fn read(text: &str) -> Reading {
        read_bytes("a.csv", text.as_bytes()).expect("a table")
    }

    fn names(reading: &Reading) -> Vec<&str> {
        reading.spectra.iter().map(|s| s.name.as_str()).collect()
    }

    /// Rows of two columns that rise by 1 nm from a wavelength on.
    fn rows(from: usize, count: usize) -> String {
        (0..count)
            .map(|i| format!("{},0.{}\n", from + i, i % 10))
            .collect()
    }

    #[test]
    fn a_second_table_is_read_however_short() {
        let text = format!(
            "nm,lamp A\n{}\nnm,lamp B\n{}",
            rows(380, 401),
            rows(400, 41)
        );
        let reading = read(&text);
        assert_eq!(names(&reading), ["lamp A, table 1", "lamp B, table 2"]);
        assert_eq!(reading.spectra[1].samples.len(), 41);
    }

    #[test]
    fn a_few_rows_that_are_no_table_leave_the_long_one_alone() {
        let text = format!(
            "pixel,gain\n1,400\n2,500\n3,600\n\nnm,lamp\n{}",
            rows(380, 401)
        );
        let reading = read(&text);
        assert_eq!(names(&reading), ["lamp"]);
        assert!(
            reading
                .notes
                .iter()
                .any(|note| note.starts_with("lines 2 to 4 left out"))
        );
        // Nor do they stand for a long block without wavelengths.
        let text = "7,1\n3,9\n".repeat(50) + "nm,b\n" + &rows(380, 5);
        let refusal = read_bytes("a.csv", text.as_bytes()).unwrap_err();
        assert_eq!(refusal.found, "numbers with no wavelengths among them");
    }

    #[test]
    fn a_block_that_is_left_out_is_said() {
        let text = format!("gains\n1,7\n2,3\n1,4\nnm,lamp\n{}", rows(380, 401));
        let reading = read(&text);
        assert_eq!(reading.spectra.len(), 1);
        let said = "lines 2 to 4 left out".to_owned();
        assert!(reading.notes.contains(&said), "{:?}", reading.notes);
    }

    #[test]
    fn tables_side_by_side_keep_their_own_wavelengths() {
        let text = "Wavelength (nm),A,Wavelength (nm),B\n380,0,1000,100\n390,1,1010,101\n\
                    400,2,,\n";
        let reading = read(text);
        assert_eq!(names(&reading), ["A", "B"]);
        assert_eq!(reading.spectra[0].samples.nm(), [380.0, 390.0, 400.0]);
        assert_eq!(reading.spectra[1].samples.nm(), [1000.0, 1010.0]);
        assert_eq!(reading.spectra[1].samples.values(), [100.0, 101.0]);
        let missing = |note: &String| note.contains("missing");
        assert!(!reading.spectra[1].notes.iter().any(missing));
    }

    #[test]
    fn a_column_of_names_does_not_hide_the_table() {
        for text in [
            "sample,nm,value\nleaf,380,0.10\nleaf,390,0.20\nleaf,400,0.15\n",
            "380,leaf,0.10\n390,leaf,0.20\n400,leaf,0.15\n",
            "sample;nm;value\nleaf a;380;0,10\nleaf a;390;0,20\nleaf a;400;0,15\n",
        ] {
            let reading = read(text);
            assert_eq!(
                reading.spectra[0].samples.nm(),
                [380.0, 390.0, 400.0],
                "{text}"
            );
            assert_eq!(reading.spectra[0].samples.values(), [0.1, 0.2, 0.15]);
        }
    }

    #[test]
    fn fewer_titles_than_cells_are_doubtful() {
        let reading = read("nm,lamp (W/m2/nm)\n380,0,10\n390,0,20\n400,0,15\n");
        assert!(reading.is_doubtful());
        let columns = |guess: &crate::io::Guess| guess.what == Guessed::Columns;
        assert!(reading.guesses.iter().any(columns), "{:?}", reading.guesses);
        let whole = read("nm,a (W/m2/nm),b\n380,0,10\n390,0,20\n400,0,15\n");
        assert!(!whole.guesses.iter().any(columns));
    }

    #[test]
    fn a_humidity_in_per_cent_does_not_scale_the_values() {
        let text = "Measurement humidity: 45 %\nWavelength (nm);Reflectance\n\
                    380;0.2\n390;0.4\n400;0.5\n";
        let spectrum = &read(text).spectra[0];
        assert_eq!((spectrum.scale, spectrum.samples.values()[2]), (1.0, 0.5));
    }

    #[test]
    fn a_long_name_of_a_wavelength_column_is_no_unit() {
        let reading = read("Våglängd;Reflektans\n380;0.2\n580;0.4\n780;0.5\n");
        assert_eq!(reading.spectra[0].samples.nm(), [380.0, 580.0, 780.0]);
    }

    /// Rows of wavelengths from 400 nm on and what a function makes of each.
    fn rows_of(count: u32, row: impl Fn(f64) -> String) -> String {
        (0..count).map(|i| row(f64::from(i)) + "\n").collect()
    }

    #[test]
    fn wavelengths_that_are_numbered_stand_under_their_number() {
        let rows = rows_of(30, |i| {
            let (one, other) = (400.0 + 5.0 * i, 500.0 + 10.0 * i);
            format!("{one}\t{}\t{other}\t{}", 20.0 + i, 60.0 + i)
        });
        let text = "w.length.1\ttransmittance.1\tw.length.2\ttransmittance.2\n".to_owned() + &rows;
        let reading = read_bytes("gel.txt", text.as_bytes()).expect("a table");
        assert_eq!(names(&reading), ["transmittance.1", "transmittance.2"]);
        assert_eq!(reading.spectra[1].samples.last_nm(), 790.0);
    }

    #[test]
    fn the_technique_of_a_spectrometer_tells_what_it_measured() {
        let rows = rows_of(30, |i| format!("{},{}", 400.0 + i, 80.0 + 0.1 * i));
        let text = "Raman Intensity Corrected,False\nLaser Wavelength,0.0\n\
                    Technique,Transmission\n\nWavelength,Processed\n"
            .to_owned()
            + &rows;
        let spectrum = &read_bytes("enlighten.csv", text.as_bytes())
            .expect("a table")
            .spectra[0];
        assert_eq!((spectrum.kind, spectrum.scale), (Kind::Transmittance, 0.01));
    }

    #[test]
    fn of_several_titled_columns_each_is_what_its_own_title_says() {
        let rows = rows_of(30, |i| {
            format!("{i};{};900;65535;{};50.5;0.3", 540.0 + i, 900.0 + 60.0 * i)
        });
        let text = "laser_wavelength;532\n\
                    Pixel;Wavelength;Dark;Reference;Dark Subtracted #1;%TR #1;Absorbance #1\n"
            .to_owned()
            + &rows;
        let reading = read_bytes("bw.txt", text.as_bytes()).expect("a table");
        let kinds: Vec<Kind> = reading.spectra.iter().map(|s| s.kind).collect();
        assert_eq!(kinds, [Kind::Light, Kind::Transmittance, Kind::Absorbance]);
        let may_be = |note: &String| note.contains("may be a reflectance");
        assert!(reading.spectra[1].notes.iter().any(may_be));
    }

    #[test]
    fn a_value_with_its_unit_and_a_wavelength_with_a_colon_are_read() {
        let rows = rows_of(9, |i| format!("{} nm,{} W/m2", 400.0 + i, 0.5 + i));
        let spectrum = &read(&rows).spectra[0];
        assert_eq!(
            (spectrum.unit.as_str(), spectrum.samples.len()),
            ("W/m2", 9)
        );
        let rows = rows_of(9, |i| format!("{}: {}", 400.0 + i, 0.5 + i));
        assert_eq!(read(&rows).spectra[0].samples.len(), 9);
        let lists = "wavelengths: [400, 410, 420, 430, 440]\nvalues: [1, 2, 3, 4, 5]\n";
        let spectrum = &read(lists).spectra[0];
        assert_eq!(
            (spectrum.name.as_str(), spectrum.samples.len()),
            ("values", 5)
        );
    }

    #[test]
    fn a_line_of_key_and_value_names_no_spectrum() {
        let text = "Name: Dry grass\nY Units: Reflectance (percent)\n\
                    Additional Information:  None.\n\n380 14.2\n390 14.5\n400 14.9\n";
        let reading = read_bytes("a.txt", text.as_bytes()).expect("a table");
        assert_eq!(names(&reading), ["Dry grass"]);
    }
}
