//! Raman spectrometers' text: the axis counts wave numbers from a laser line, not nanometres.
//!
//! A shift `s` (1/cm) from a laser of `L` nm is light of `1e7 / (1e7 / L - s)` nm. The laser is in
//! the header ("Laser wavelength 785 nm") or in the file's name as Horiba's instruments write it
//! (`iR785`, `iR532`) and the RRUFF project in its own (`__Raman__532__`); shifts from an unknown
//! laser are refused. A table that holds wavelengths beside the shifts is left to
//! [`columns`](super::columns).
//!
//! ```text
//! Horiba LabSpec  #Range (cm-1): 200 - 3198 / #Laser: 785
//! RRUFF           ##NAMES=Corundum / ##RRUFFID=R060020 / ##RAMAN WAVELENGTH=514
//! Renishaw WiRE   #Wave <TAB> <TAB> #Intensity; a map has #X and #Y before
//! WITec           rel. 1/cm <TAB> CCD cts
//! JASCO           DATA TYPE,RAMAN SPECTRUM / XUNITS,1/CM
//! ```

use super::{Confidence, Format, columns};
use crate::io::interpret::interpret;
use crate::io::interpret::raw::{RawAxis, RawSpectrum};
use crate::io::reading::decision::{AxisDecision, Decision};
use crate::io::reading::remark::taken_as;
use crate::io::table::block::Block;
use crate::io::table::layout::Layout;
use crate::io::table::pick;
use crate::io::table::roles::value_columns;
use crate::io::table::scan::scan;
use crate::io::table::titles::Titles;
use crate::io::text::dialect::Dialect;
use crate::io::text::lines;
use crate::io::text::words::holds_one;
use crate::io::{Input, ReadError, Reading};
use crate::languages::with_sign;

/// Raman text.
pub(crate) const FORMAT: Format = Format {
    name: later!("Raman text"),
    extensions: &["txt"],
    sniff,
    read,
};

/// Most lines of a header that are examined.
const HEADER_LINES: usize = 60;

/// Lasers that Raman spectrometers have, nm: from deep ultraviolet to infrared.
const LASERS_NM: std::ops::RangeInclusive<f64> = 220.0..=1100.0;

/// Names of an axis of shifts, lower case.
const SHIFTS: &str = "raman shift;ramanshift;raman_shift;rel. wavenumber;relative wavenumber;\
                      rel. 1/cm;rel.1/cm;rel 1/cm;relative 1/cm";

/// Words followed by a laser's wavelength, lower case.
const LASER: [&str; 4] = [
    "laser",
    "excitation",
    "raman wavelength",
    "raman_wavelength",
];

/// The lines above the numbers that have letters, as they are and in lower case.
struct Head<'a>(Vec<(&'a str, String)>);

impl<'a> Head<'a> {
    fn of(text: &'a str) -> Self {
        let first = lines(text).take(HEADER_LINES).map(|(_, line)| line.trim());
        let words = first.filter(|line| line.len() <= 400 && line.contains(char::is_alphabetic));
        Self(words.map(|line| (line, line.to_lowercase())).collect())
    }

    /// True if any line in lower case satisfies the predicate.
    fn any(&self, is_so: impl Fn(&str) -> bool) -> bool {
        self.0.iter().any(|(_, lower)| is_so(lower))
    }

    /// Keys of lines (lower case letters and digits only) and the text behind them.
    fn keys(&self) -> impl Iterator<Item = (String, &'a str)> {
        self.0.iter().filter_map(|(line, _)| {
            let (key, value) = line.split_once(['=', ':', ',', ';', '\t'])?;
            let key = key.chars().filter(|c| c.is_alphanumeric());
            Some((key.flat_map(char::to_lowercase).collect(), value.trim()))
        })
    }

    /// True if it names an axis of shifts, and no wavelengths beside them.
    fn names_shifts(&self) -> bool {
        self.any(|line| holds_one(line, SHIFTS) && !line.contains("wavelength"))
    }

    /// True if it counts its first axis in 1/cm as Horiba's LabSpec writes it: shifts from the
    /// laser. LabSpec's range (`#Range (cm-1):`) is of shifts, since it has no other wave numbers;
    /// the lines about the laser or the exposure distinguish it from other programs' headers.
    fn counts_shifts(&self) -> bool {
        let unit = (self.0.iter()).find(|(_, lower)| lower.contains("axisunit[1]"));
        let range = self.0.iter().any(|(line, _)| {
            let line = line.trim_start_matches('#').trim_start();
            let key = line.split(['=', ':', '\t']).next().unwrap_or(line);
            key.to_lowercase().starts_with("range") && is_per_cm(key)
        });
        let is_of_labspec = |key: &str| key.starts_with("laser") || key.starts_with("acq");
        unit.is_some_and(|(unit, _)| is_per_cm(unit)) && self.laser_nm().is_some()
            || range && self.keys().any(|(key, _)| is_of_labspec(&key))
    }

    /// True if it declares its data a Raman spectrum, and does not mention wavelengths.
    fn says_raman(&self) -> bool {
        let says = self.keys().any(|(key, value)| {
            matches!(&*key, "datatype" | "filetype" | "technique")
                && value.to_lowercase().contains("raman")
        });
        says && !self.any(|line| {
            let is_laser = holds_one(line, "laser;excitation;raman wavelength");
            !is_laser && holds_one(line, "wavelength;nanomet")
        })
    }

    /// True if it is of one of the RRUFF project's Raman spectra: those of infrared light and
    /// X-rays are marked as such.
    fn is_rruff(&self, name: &str) -> bool {
        let is_other = |text: &str| holds_one(&text.to_lowercase(), "infrared;x-ray;xray;powder");
        let kind = self.keys().find(|(key, _)| key == "filetype");
        self.keys().any(|(key, _)| key == "rruffid")
            && !is_other(name)
            && !kind.is_some_and(|(_, kind)| is_other(kind))
    }

    /// The number of columns in a table of Renishaw's WiRE: `#Wave`, `#Intensity`, preceded by the
    /// position in a map.
    fn wire_columns(&self) -> Option<usize> {
        let (_, line) = self.0.iter().find(|(line, _)| line.starts_with('#'))?;
        let titles: Vec<&str> = line.split_whitespace().collect();
        let is_wire = titles.contains(&"#wave") && titles.contains(&"#intensity");
        is_wire.then_some(titles.len())
    }

    /// The laser's wavelength, nm: `Laser wavelength: 785 nm`, `#Laser=785nm_edge`.
    fn laser_nm(&self) -> Option<f64> {
        let lines = self.0.iter();
        let named: Vec<_> = lines.flat_map(|(_, line)| lasers_of(line)).collect();
        let by_unit = named.iter().find(|(_, says_nm)| *says_nm);
        by_unit.or(named.first()).map(|(nm, _)| *nm)
    }
}

/// True if a text holds the unit of a shift.
fn is_per_cm(text: &str) -> bool {
    holds_one(text, "1/cm;1/CM;cm-1;cm-¹;cm⁻¹;cm^-1")
}

/// The numbers of a line in lower case that may be a laser's wavelength, not its power or its
/// share, each with true if it is named as one.
fn lasers_of(line: &str) -> Vec<(f64, bool)> {
    let mut lasers = Vec::new();
    let at = LASER.iter().find_map(|word| line.find(word));
    // RRUFF's crystals lie somehow to the beam: "Laser parallel to c* (0 0 1)".
    let at = at.filter(|_| !holds_one(line, "orientation;parallel"));
    let mut rest = at.map_or("", |at| &line[at..]);
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    let names_wavelength = holds_one(line, "wavelength;lambda");
    let names_other = holds_one(line, "power;attenuation;exposure");
    while let Some(from) = rest.find(is_number) {
        let end = rest[from..].find(|c| !is_number(c));
        let (number, behind) = rest[from..].split_at(end.unwrap_or(rest.len() - from));
        let mut words = behind
            .trim_start()
            .split(|c: char| !(c.is_alphabetic() || c == '%'));
        let unit = words.next().unwrap_or("");
        let counts_other = ["mw", "w", "%", "µw", "s", "ms"].contains(&unit);
        let says_nm = unit.starts_with("nm");
        let nm = number
            .parse()
            .ok()
            .filter(|nm| LASERS_NM.contains(nm) && *nm != 1000.0);
        if let Some(nm) = nm.filter(|_| says_nm || !counts_other && !names_other) {
            lasers.push((nm, says_nm || names_wavelength));
        }
        rest = behind;
    }
    lasers
}

/// The laser in a file's name: `iR785`, `__Raman__532__`.
fn laser_of_name(name: &str) -> Option<f64> {
    let horiba = name.match_indices("iR");
    horiba
        .chain(name.match_indices("__Raman__"))
        .find_map(|(at, word)| {
            let before = name[..at].chars().next_back();
            let is_apart = word != "iR" || before.is_none_or(|c| !c.is_alphanumeric());
            let behind = &name[at + word.len()..];
            let end = behind.find(|c: char| !c.is_ascii_digit());
            let digits = &behind[..end.unwrap_or(behind.len())];
            let nm = digits.parse().ok().filter(|nm| LASERS_NM.contains(nm));
            nm.filter(|_| is_apart && digits.len() >= 3)
        })
}

fn sniff(input: &Input) -> Confidence {
    let text = input.head();
    if text.is_empty() || text.starts_with(['{', '<']) {
        return Confidence::No;
    }
    let head = Head::of(text);
    if text.starts_with("##") {
        // Its labels are written as JCAMP-DX's, which recognises its own files.
        return Confidence::certain_if(head.is_rruff(&input.name));
    }
    let names_nm = || head.any(|line| holds_one(line, "wavelength;nm"));
    let is_raman = match head.wire_columns() {
        // WiRE writes wavelengths under the same title: the user may choose them.
        Some(_) => input.choices.wavelengths.is_none(),
        None => {
            head.names_shifts()
                || head.counts_shifts()
                || head.says_raman()
                || laser_of_name(&input.name).is_some() && !names_nm()
        }
    };
    match is_raman {
        true => Confidence::Likely,
        false => Confidence::No,
    }
}

/// The tables of shifts of a text, each with its titles and the column of shifts, and notes on
/// omissions.
fn tables_of(text: &str, dialect: Dialect) -> (Vec<(Block<'_>, Titles, usize)>, Vec<String>) {
    let (mut found, mut notes) = (Vec::new(), Vec::new());
    for table in pick::tables(text, dialect).unwrap_or_default() {
        if table.is_short {
            notes.push(pick::lines_left_out(&table.block));
            continue;
        }
        let axis = match table.layout {
            // A rising column beside shifts below zero looks more like wavelengths than they do.
            _ if leads(&table.block) => 0,
            Layout::Column(axis) => axis,
            _ => continue,
        };
        found.push((table.block, table.titles, axis));
    }
    if found.is_empty() {
        // Shifts from zero or below are no wavelengths to the finder of tables.
        let blocks = scan(text, 0, dialect).unwrap_or_default();
        let longest = blocks.into_iter().filter(leads).max_by_key(Block::rows);
        found.extend(longest.map(|block| {
            let titles = Titles::of(&block, dialect);
            (block, titles, 0)
        }));
    }
    (found, notes)
}

/// True if the first column of a block can be one of shifts.
fn leads(block: &Block) -> bool {
    if block.width < 2 || block.rows() < 2 || block.counts_rows(0) {
        return false;
    }
    let first = block.column(0);
    first.is_sorted_by(|a, b| a < b) || first.is_sorted_by(|a, b| a > b)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let head = Head::of(input.head());
    if head.wire_columns().is_some_and(|columns| columns > 2) {
        return Err(input.error(
            said!("a Raman map or series of several points"),
            said!("the spectrum of one point: #Wave and #Intensity"),
        ));
    }
    // `iR785` in a name is the laser of a Raman spectrometer and nothing else.
    let by_name = laser_of_name(&input.name);
    let by_name = || Some(Decision::guessed(by_name?, true, said!("the file's name")));
    let by_header = || {
        Some(Decision::stated(
            Head::of(text).laser_nm()?,
            said!("the header"),
        ))
    };
    let by_hand = input.choices.laser_nm.map(Decision::chosen);
    let laser = by_hand.or_else(by_header).or_else(by_name).ok_or_else(|| {
        let found = said!("Raman shifts (1/cm) from a laser that is not named");
        let expected = said!("wavelengths, or the laser's wavelength in the header");
        input.error(found, expected)
    })?;
    let (dialect, seen) = pick::look(text, input.choices.delimiter);
    let (mut tables, mut notes) = tables_of(seen, dialect);
    if seen.len() < text.len() && !tables.is_empty() {
        (tables, notes) = tables_of(text, dialect);
    }
    let no_shifts = || {
        input.error(
            said!("no column of Raman shifts"),
            said!("shifts (1/cm) and values"),
        )
    };
    if tables.is_empty() {
        // The refusal of plain columns is more specific; their reading of shifts is not shown.
        let refusal = (columns::FORMAT.read)(input).err();
        return Err(refusal.unwrap_or_else(no_shifts));
    }
    let is_rruff = input.head().starts_with("##") && head.is_rruff(&input.name);
    let mut keys = head.keys().filter(|_| is_rruff);
    let named = keys.find(|(key, name)| matches!(&**key, "names" | "name") && !name.is_empty());
    let name = named.map_or(input.stem(), |(_, name)| name);
    let mut reading = Reading {
        notes,
        cut_by: Some(dialect.delimiter),
        ..Reading::default()
    };
    for table in &tables {
        add(input, table, name, (&laser, dialect), &mut reading)?;
    }
    if reading.spectra.is_empty() {
        return Err(no_shifts());
    }
    reading.notes.push(dialect.words());
    Ok(reading)
}

/// Adds the spectra of a table with its titles and the column of shifts; the laser in nm.
fn add(
    input: &Input,
    (block, titles, axis): &(Block, Titles, usize),
    stem: &str,
    (laser, dialect): (&Decision<f64>, Dialect),
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let to_nm = |shift: &f64| 1e7 / (1e7 / laser.value - shift);
    let nm: Vec<f64> = block.column(*axis).iter().map(to_nm).collect();
    let (values, _) = value_columns(block, titles, *axis, &[*axis]);
    let is_used = |column| column == *axis || values.contains(&column);
    if let Some(bad) = block.bad.iter().find(|bad| is_used(bad.column)) {
        return Err(bad.refusal(input));
    }
    let line = with_sign(laser.value.to_string());
    let shifts = tr!("Raman shifts from {laser} nm", laser = line);
    for column in &values {
        let name = match values.len() {
            1 => stem.to_owned(),
            _ => format!("{stem}, column {}", column + 1),
        };
        let spectrum = RawSpectrum {
            lines: &block.lines,
            how: vec![tr!("from Raman shifts of {laser} nm", laser = line)],
            notes: vec![taken_as(&shifts, &laser.reason)],
            axis: RawAxis::Nm(&nm, Some(AxisDecision::Laser(laser.clone()))),
            ..RawSpectrum::light(name, &nm, block.column(*column).to_vec(), "")
        };
        interpret(spectrum.with_comma(dialect.decimal_comma), input, reading)?;
    }
    Ok(())
}
