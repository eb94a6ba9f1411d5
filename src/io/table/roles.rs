//! The roles of a table's columns: spectra, or something beside them.

mod left_out;

use super::block::Block;
use super::row_order::{extent, runs_one_way};
use super::titles::Titles;
use crate::io::interpret::kinds::kind_of_title;
use crate::io::text::units::{BESIDE, WavelengthUnit, names_wavelength};
use crate::io::text::words::{holds, holds_one, without_brackets};
use crate::spectrum::Kind;

pub(crate) use left_out::{LeftOut, left_out_words, shown};
use left_out::{SECOND_AXIS, SPREAD};

/// A column of wavelengths and the columns with values at them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Group {
    pub axis: usize,
    pub values: Vec<usize>,
}

/// Columns that are spectra, each under its wavelengths, and what else was found, a sentence each.
///
/// Tables that stand side by side have several columns of wavelengths: each holds for the columns
/// behind it up to the next.
pub(crate) fn groups(
    block: &Block,
    titles: &Titles,
    wavelength: usize,
) -> (Vec<Group>, Vec<LeftOut>) {
    let axes = axes(block, titles, wavelength);
    let (values, mut left_out) = value_columns(block, titles, wavelength, &axes);
    let mut of_axis = vec![Vec::new(); axes.len()];
    for column in values {
        let before = axes.partition_point(|axis| *axis < column);
        of_axis[before.saturating_sub(1)].push(column);
    }
    let groups: Vec<Group> = axes
        .into_iter()
        .zip(of_axis)
        .filter(|(_, values)| !values.is_empty())
        .map(|(axis, values)| Group { axis, values })
        .collect();
    let others = groups.iter().map(|group| group.axis);
    let others = others.filter(|axis| *axis != wavelength);
    let why = "holds the wavelengths of the columns behind it";
    left_out.extend(others.map(|column| LeftOut { column, why }));
    (groups, left_out)
}

/// Keeps the spreads that stand right behind what they are the spread of.
pub(crate) fn keep_spreads(groups: &mut [Group], left_out: &mut Vec<LeftOut>) {
    left_out.retain(|out| {
        let before = |group: &&mut Group| {
            out.why == SPREAD && group.values.iter().any(|column| column + 1 == out.column)
        };
        let Some(group) = groups.iter_mut().find(before) else {
            return true;
        };
        let place = group.values.partition_point(|column| *column < out.column);
        group.values.insert(place, out.column);
        false
    });
}

/// Columns that are spectra beside columns of wavelengths (`axes`), and why others were left out.
pub(crate) fn value_columns(
    block: &Block,
    titles: &Titles,
    wavelength: usize,
    axes: &[usize],
) -> (Vec<usize>, Vec<LeftOut>) {
    let (mut values, mut left_out) = (Vec::new(), Vec::new());
    let raw_beside = beside_processed(titles, wavelength);
    for column in (0..block.width).filter(|c| axes.binary_search(c).is_err()) {
        let stats = &block.columns[column];
        let title = titles.whole(column);
        let mut leave_out = |why| left_out.push(LeftOut { column, why });
        if stats.numbers == 0 {
            if stats.texts > 0 {
                leave_out("holds words and was left out");
            }
        } else if column < wavelength && (block.counts_rows(column) || is_counter(&title)) {
            leave_out("counts the rows and was left out");
        } else if column < wavelength && title.is_empty() && block.is_constant(column) {
            leave_out("is one number throughout and was left out");
        } else if column < wavelength
            && !title.is_empty()
            && kind_of_title(&title).is_none()
            && is_ramp(block, column)
        {
            leave_out("rises by the same from row to row and was left out");
        } else if title.is_empty() && is_setting(block, column, wavelength) {
            leave_out("holds whole numbers below zero throughout, a setting, and was left out");
        } else if is_spread(&title) {
            values.push(column);
        } else if names_axis_beside(&title, titles, wavelength)
            || holds(&title.to_lowercase(), "raman shift")
            || is_axis_by_values(block, column, wavelength)
        {
            leave_out(SECOND_AXIS);
        } else if raw_beside.binary_search(&column).is_ok() {
            leave_out("is a raw reading and was left out");
        } else {
            values.push(column);
        }
    }
    let (mut values, others) = by_titles(|column| titles.whole(column), values);
    left_out.extend(others);
    // "AxisUnit = nm" above the values is no second axis: there is nothing else that they could be.
    if values.is_empty() {
        let second_axis = |column: &usize| {
            axes.binary_search(column).is_err()
                && block.columns[*column].numbers > 0
                && names_wavelength(&titles.whole(*column))
        };
        values.extend((0..block.width).find(second_axis));
        left_out.retain(|column| column.why != SECOND_AXIS);
    }
    // The ratio before the readings that it was made of, where all are kept.
    let made_of = |column: &usize| {
        let title = titles.whole(*column).to_lowercase();
        title.contains("(ref") || title.contains("target")
    };
    if values.iter().any(made_of) {
        values.sort_by_key(made_of);
    }
    (values, left_out)
}

/// Those of some columns that are spectra by their titles, and why the others are none: spreads and
/// what was noted beside each point, unless there is nothing else.
pub(crate) fn by_titles(
    title: impl Fn(usize) -> String,
    columns: Vec<usize>,
) -> (Vec<usize>, Vec<LeftOut>) {
    let with_title = |column: usize| (column, title(column).to_lowercase());
    let mut kept: Vec<(usize, String)> = columns.into_iter().map(with_title).collect();
    let mut left_out = Vec::new();
    let mut without = |is_out: &dyn Fn(&str) -> bool, why| {
        if !kept.iter().all(|(_, title)| is_out(title)) {
            let out = kept.extract_if(.., |(_, title)| is_out(title));
            left_out.extend(out.map(|(column, _)| LeftOut { column, why }));
        }
        kept.iter().map(|(_, title)| title.clone()).collect()
    };
    let titles: Vec<String> = without(&is_spread, SPREAD);
    let why = "is no spectrum by its title and was left out";
    let titles: Vec<String> = without(&is_beside(&titles), why);
    // Where all are such functions they are what the file is for.
    if titles
        .iter()
        .any(|title| kind_of_title(title) != Some(Kind::Weighting))
    {
        without(&is_matching_function, "weighs a light and was left out");
    }
    (
        kept.into_iter().map(|(column, _)| column).collect(),
        left_out,
    )
}

/// True if a title, in lower case, names a colour-matching function, which is not a light.
fn is_matching_function(title: &str) -> bool {
    let name: String = title
        .chars()
        .filter(|c| c.is_alphanumeric() || "\u{304}".contains(*c))
        .collect();
    holds_one(
        &name,
        "^xbar;^ybar;^zbar;^x\u{304};^y\u{304};^z\u{304};^x̅;^y̅;^z̅;^ȳ",
    )
}

/// True if a title, in lower case, has a unit that no spectrum has: of time, temperature, voltage,
/// humidity, pressure, angle. A single letter may name a sample ("Leaf (K)"): it is a unit only
/// after the word for its quantity.
fn counts_beside(title: &str) -> bool {
    const UNITS: &str = "sec;seconds;ms;msec;us;µs;μs;hr;°c;ºc;℃;degc;deg c;°f;deg;°;%rh;rh;pa;hpa;\
         kpa;bar;mbar;rpm;hz";
    const BEHIND: &str = "_ms$;_msec$;_us$;_sec$;_degc$;^t_c$;^temp_c$";
    const TEMPERATURES: &str = "temperatur;|temp|;|tc|;|tj|;|tcase|";
    const TIMES: &str = "time|;|zeit|;|elapsed;|duration;|delay;|age|;|exposure|;|integration|";
    let is_unit = |(name, unit): (&str, &str)| {
        let unit = unit.trim_end_matches([')', ']']).trim();
        let is_warm = unit.contains(['°', 'º', '℃']);
        let is_known = match unit {
            "c" | "k" if name.trim() == "t" => return true,
            "c" | "k" => holds_one(name, TEMPERATURES),
            "s" | "h" => holds_one(name, TIMES),
            _ => UNITS.split(';').any(|own| own == unit),
        };
        // "R (s)" is of light that swings across.
        is_known && (is_warm || kind_of_title(title).is_none())
    };
    title.rsplit_once(['(', '[']).is_some_and(is_unit) || holds_one(title.trim(), BEHIND)
}

/// The test for titles, in lower case, of data noted beside each point, by a word found in no other
/// column's title: several spectra may be named by days.
fn is_beside(titles: &[String]) -> impl Fn(&str) -> bool {
    const OF_POINTS: &str =
        "|flag|;|id|;|pixel|;|elapsed|;|integration|;|exposure|;|gain|;|averages|;|scans|";
    let words = || BESIDE.split(';').chain(OF_POINTS.split(';'));
    let of_one = |word: &&str| titles.iter().filter(|title| holds(title, word)).count() == 1;
    let of_one: Vec<&str> = words().filter(of_one).collect();
    move |title| {
        let word = words().find(|word| holds(title, word));
        !title.contains(|c: char| c.is_ascii_digit())
            && (counts_beside(title)
                || word.is_some_and(|word| of_one.contains(&word))
                    && kind_of_title(title).is_none())
    }
}

/// True if a column holds a setting of each point, such as the range of an amplifier: negative
/// whole numbers throughout, beside measured ones.
fn is_setting(block: &Block, column: usize, wavelength: usize) -> bool {
    let numbers = |column: usize| block.column(column).iter().filter(|v| !v.is_nan());
    let mut others = (0..block.width).filter(|other| *other != column && *other != wavelength);
    numbers(column).all(|v| *v < 0.0 && v.fract() == 0.0)
        && others.any(|other| numbers(other).any(|v| *v > 0.0 && v.fract() != 0.0))
}

/// True if a column rises by the same step in every row, as times do.
fn is_ramp(block: &Block, column: usize) -> bool {
    let values = block.column(column);
    let others = block.columns[column + 1..].iter();
    if values.len() < 5 || others.filter(|c| c.numbers > 0).count() < 2 {
        return false;
    }
    let step = (values[values.len() - 1] - values[0]) / (values.len() - 1) as f64;
    let is_even = |pair: &[f64]| (pair[1] - pair[0] - step).abs() <= 1e-6 * step;
    step > 0.0 && values.windows(2).all(is_even)
}

/// A column that counts detector elements, by its title.
fn is_counter(title: &str) -> bool {
    const COUNTERS: &str = "^chan$;^channel$;^pixel$;^pixels$;^index$;^no$;^nr$;^number$;^row$";
    let title = title.to_lowercase();
    holds_one(title.trim_matches(['"', '#', '.', ' ']), COUNTERS)
}

/// True if a column's title names another axis. An "x" beside nanometres is a chromaticity
/// coordinate.
fn names_axis_beside(title: &str, titles: &Titles, wavelength: usize) -> bool {
    let is_x = |title: &str| title.trim().eq_ignore_ascii_case("x");
    names_wavelength(title) && (!is_x(title) || is_x(&titles.whole(wavelength)))
}

/// True if a title is words and a unit of length after them ("Em nm"): no quantity for each nm.
fn ends_in_length(title: &str) -> bool {
    let ends = " nm$; (nm)$; [nm]$;_nm$";
    holds_one(&title.to_lowercase(), ends) && !title.contains(['/', '^'])
}

/// Columns of wavelengths from left to right: the one that was found, and others that are titled
/// so, rise or fall throughout, and have values behind them. A second one of the same points (1/cm
/// beside nm) is none.
fn axes(block: &Block, titles: &Titles, wavelength: usize) -> Vec<usize> {
    let title = titles.whole(wavelength).to_lowercase();
    let is_axis = |column: &usize| {
        let runs = || {
            let numbers = block.column(*column).iter().copied();
            let numbers: Vec<f64> = numbers.filter(|v| !v.is_nan()).collect();
            numbers.len() >= 2 && runs_one_way(&numbers)
        };
        let other = titles.whole(*column);
        // Under the same title it is one even where a wavelength was mistyped or stands twice.
        *column == wavelength
            || names_axis_beside(&other, titles, wavelength)
                && (other.to_lowercase() == title || runs())
            || ends_in_length(&other) && ends_in_length(&title) && !is_spread(&other) && runs()
            || is_axis_by_values(block, *column, wavelength)
    };
    let found: Vec<usize> = (0..block.width).filter(is_axis).collect();
    let has_numbers = |mut columns: std::ops::Range<usize>| {
        columns.any(|column| block.columns[column].numbers > 0)
    };
    let mut kept: Vec<usize> = Vec::new();
    for (number, column) in found.iter().copied().enumerate() {
        let end = found.get(number + 1).copied().unwrap_or(block.width);
        let last = kept.last().copied();
        let same = last.is_some_and(|last| {
            !has_numbers(last + 1..column) || are_same_points(block, titles, last, column)
        });
        if column == wavelength {
            // The column that was found stands for those that say the same.
            kept.pop_if(|_| same);
            kept.push(column);
        } else if !same && has_numbers(column + 1..end) {
            kept.push(column);
        }
    }
    kept
}

/// True if a column is another axis by its numbers: columns come in pairs, and it holds the first
/// axis again, or whole wavelengths at even steps.
fn is_axis_by_values(block: &Block, column: usize, wavelength: usize) -> bool {
    let is_paired = block.width >= wavelength + 4
        && (block.width - wavelength).is_multiple_of(2)
        && column > wavelength
        && (column - wavelength).is_multiple_of(2);
    if !is_paired {
        return false;
    }
    let numbers = |column: usize| block.column(column).iter().copied().filter(|v| !v.is_nan());
    let own: Vec<f64> = numbers(column).collect();
    let is_same = own.iter().copied().eq(numbers(wavelength));
    let is_ramp = || {
        let step = |pair: &[f64]| pair[1] - pair[0];
        own.windows(2).all(|pair| step(pair) == step(&own[..2]))
            && own.iter().all(|v| v.fract() == 0.0)
    };
    let is_nm = || {
        let (low, high) = extent(&own);
        WavelengthUnit::of_range(low, high) == Some(WavelengthUnit::Nanometre) && runs_one_way(&own)
    };
    own.len() >= 5 && (is_same || is_nm() && is_ramp())
}

/// True if two columns hold the same wavelengths: the same numbers in one unit, or equal to the
/// rounding of a table in two units.
fn are_same_points(block: &Block, titles: &Titles, one: usize, other: usize) -> bool {
    let unit = |column: usize| {
        let (low, high) = extent(block.column(column));
        WavelengthUnit::of_title(&titles.whole(column))
            .or_else(|| WavelengthUnit::of_range(low, high))
            .unwrap_or(WavelengthUnit::Nanometre)
    };
    let (a, b) = (unit(one), unit(other));
    let rounding = if a == b { 1e-9 } else { 2e-3 };
    let mut rows = block.column(one).iter().zip(block.column(other));
    rows.all(|(x, y)| {
        let (x, y) = (a.to_nm(*x), b.to_nm(*y));
        x.is_nan() && y.is_nan() || (x - y).abs() <= rounding * x.abs()
    })
}

/// A column of standard deviations or uncertainties: its title is such a word or ends with one. A
/// name may begin with it ("Std D65").
fn is_spread(title: &str) -> bool {
    const SPREADS: &str = "|std$;|stdev$;|stddev$;|std.dev$;|std dev$;|st.dev$;|st dev$;|sigma$;|error$;\
         |variance$;|standard deviation$;|uncertainty$;^standard dev|;^standard deviation|;^std.dev|;\
         ^stdev|;^uncertainty|;^uncert.;^sd$;^se$;^sem$;^fwhm$;^bandwidth$";
    let title = title.to_lowercase();
    let name = without_brackets(&title).trim_end_matches('.');
    title.contains('±') || holds_one(name, SPREADS)
}

/// Raw readings that stand beside the processed values: dark, reference and sample counts next to
/// a transmittance, in the same rows as a column called "Processed", or the letters W D R S P that
/// Ocean Optics writes (no R where nothing was compared, no D where no dark reading was taken).
fn beside_processed(titles: &Titles, wavelength: usize) -> Vec<usize> {
    let others: Vec<usize> = (0..titles.names.len())
        .filter(|c| *c != wavelength)
        .collect();
    let letters: Vec<&str> = others.iter().map(|c| titles.names[*c].as_str()).collect();
    if let [readings @ .., "P"] = letters.as_slice()
        && !readings.is_empty()
        && readings.iter().all(|l| ["D", "R", "S"].contains(l))
    {
        return others[..readings.len()].to_vec();
    }
    const RAW: &str = "^dark$;^ref$;^reference$;^sample$;^scope$;^raw$;^norm$;^background$";
    let title = |column: &usize| titles.whole(*column).to_lowercase();
    let raw = |column: &usize| {
        let title = title(column);
        let word = title.split([' ', '[', '(', '.']).next().unwrap_or("");
        holds_one(word, RAW)
            && (kind_of_title(&title).is_none() || title.contains("counts"))
            && !title.contains("subtracted")
    };
    let (raws, others): (Vec<usize>, Vec<usize>) = others.into_iter().partition(raw);
    // The sigma of a raw reading is no result of it.
    let is_sigma = |title: &str| title.to_lowercase().starts_with("sigma of ");
    let is_result = |title: String| {
        kind_of_title(&title).is_some() && !is_sigma(&title) || is_processed(&title)
    };
    if others.iter().any(|c| is_result(titles.whole(*c))) {
        return raws;
    }
    // A sample in counts beside what was measured without it.
    let starts = |column: &usize, word| title(column).starts_with(word);
    let is_sample = |column: &usize| starts(column, "sample") || starts(column, "scope");
    let (samples, mut others): (Vec<usize>, Vec<usize>) = raws.into_iter().partition(is_sample);
    if samples.len() != 1 || !others.iter().any(|column| starts(column, "dark")) {
        others.clear();
    }
    others
}

/// True if a title names its column only as the result.
pub(crate) fn is_processed(title: &str) -> bool {
    title.trim().eq_ignore_ascii_case("processed")
}
