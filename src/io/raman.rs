//! Raman spectrometers' text: the axis counts wave numbers from a laser line, not nanometres.
//!
//! A shift `s` (1/cm) from a laser of `L` nm is light of `1e7 / (1e7 / L - s)` nm. The laser is told
//! by the header ("Laser wavelength 785 nm") or by the file's name as Horiba's instruments write it
//! (`iR785`, `iR532`); shifts from an unknown laser are refused. A table that holds wavelengths
//! beside the shifts is left to [`columns`](super::columns).

use super::columns;
use super::decided::BY_HAND;
use super::layout::Layout;
use super::measured::Measured;
use super::pick;
use super::reading::{AxisTold, Told};
use super::roles::value_columns;
use super::text::lines;
use super::{Confidence, Format, Guess, Guessed, Input, ReadError, Reading};

/// Raman text.
pub const FORMAT: Format = Format {
    name: "Raman text",
    extensions: &["txt"],
    sniff,
    read,
};

/// Lasers that Raman spectrometers have, nm: from deep ultraviolet to infrared.
const LASERS_NM: std::ops::RangeInclusive<f64> = 220.0..=1100.0;

/// Most lines of a header that are looked at.
const HEADER_LINES: usize = 60;

/// Words that name an axis of shifts, lower case.
const SHIFTS: [&str; 4] = [
    "raman shift",
    "ramanshift",
    "raman_shift",
    "rel. wavenumber",
];

fn headers(text: &str) -> impl Iterator<Item = &str> {
    lines(text)
        .take(HEADER_LINES)
        .map(|(_, line)| line.trim())
        .filter(|line| line.len() <= 400 && line.contains(|c: char| c.is_alphabetic()))
}

/// Whether a header names shifts and no wavelengths beside them.
fn names_shifts(head: &str) -> bool {
    headers(head).any(|line| {
        let lower = line.to_lowercase();
        SHIFTS.iter().any(|word| lower.contains(word)) && !lower.contains("wavelength")
    })
}

/// Whether a header as Horiba's LabSpec writes it counts its first axis in 1/cm: shifts from the
/// laser that it names.
fn counts_shifts(head: &str) -> bool {
    let unit = headers(head).find(|line| line.to_lowercase().contains("axisunit[1]"));
    unit.is_some_and(|line| line.contains("1/cm") || line.contains("cm-1"))
        && laser_of_header(head).is_some()
}

/// The laser in a file's name: `iR785`.
fn laser_of_name(name: &str) -> Option<f64> {
    name.match_indices("iR").find_map(|(at, _)| {
        let before = name[..at].chars().next_back();
        let digits: String = name[at + 2..]
            .chars()
            .take_while(char::is_ascii_digit)
            .collect();
        let apart = before.is_none_or(|c| !c.is_alphanumeric());
        digits
            .parse()
            .ok()
            .filter(|nm| apart && digits.len() >= 3 && LASERS_NM.contains(nm))
    })
}

/// The laser in a header line: `Laser wavelength: 785 nm`, `#Laser=785nm_edge`.
fn laser_of_header(text: &str) -> Option<f64> {
    let named: Vec<Laser> = headers(text).flat_map(lasers_of_line).collect();
    let by_unit = named.iter().find(|laser| laser.says_nm);
    by_unit.or(named.first()).map(|laser| laser.nm)
}

/// A number behind the word "laser".
struct Laser {
    nm: f64,
    /// Whether it is said to be a wavelength.
    says_nm: bool,
}

/// The numbers of a header line that may be a laser's wavelength: not its power or its share.
fn lasers_of_line(line: &str) -> Vec<Laser> {
    let lower = line.to_lowercase();
    let Some(at) = lower.find("laser").or_else(|| lower.find("excitation")) else {
        return Vec::new();
    };
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    let names_wavelength = lower.contains("wavelength") || lower.contains("lambda");
    let names_other = ["power", "attenuation", "exposure"]
        .iter()
        .any(|word| lower.contains(word));
    let mut lasers = Vec::new();
    let mut rest = &lower[at..];
    while let Some(from) = rest.find(is_number) {
        rest = &rest[from..];
        let end = rest.find(|c| !is_number(c)).unwrap_or(rest.len());
        let (number, behind) = rest.split_at(end);
        let unit = behind.trim_start();
        let counts_other = ["mw", "w", "%", "µw", "s", "ms"]
            .iter()
            .any(|other| word_of(unit) == *other);
        let says_nm = word_of(unit).starts_with("nm");
        if let Ok(nm) = number.parse::<f64>()
            && LASERS_NM.contains(&nm)
            && nm != 1000.0
            && (says_nm || !counts_other && !names_other)
        {
            lasers.push(Laser {
                nm,
                says_nm: says_nm || names_wavelength,
            });
        }
        rest = behind;
    }
    lasers
}

/// The letters (or per cent sign) that a text begins with.
fn word_of(text: &str) -> &str {
    let end = text
        .find(|c: char| !(c.is_alphabetic() || c == '%'))
        .unwrap_or(text.len());
    &text[..end]
}

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    if head.is_empty() || head.starts_with(['{', '<']) || head.starts_with("##") {
        Confidence::No
    } else if names_shifts(head)
        || counts_shifts(head)
        || laser_of_name(&input.name).is_some() && !names_nm(head)
    {
        Confidence::Likely
    } else {
        Confidence::No
    }
}

/// Whether a header names wavelengths.
fn names_nm(head: &str) -> bool {
    headers(head).any(|line| {
        let lower = line.to_lowercase();
        lower.contains("wavelength") || lower.contains("nm")
    })
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let by_hand = input.choices.laser_nm.map(|nm| (nm, BY_HAND, true));
    let by_header = || laser_of_header(text).map(|nm| (nm, "the header", true));
    let by_name = || laser_of_name(&input.name).map(|nm| (nm, "the file's name", false));
    let Some((laser, because, stated)) = by_hand.or_else(by_header).or_else(by_name) else {
        return Err(input.error(
            "Raman shifts (1/cm) from a laser that is not named",
            "wavelengths, or the laser's wavelength in the header",
        ));
    };
    let dialect = pick::dialect(text);
    let Ok(tables) = pick::tables(text, dialect) else {
        return (columns::FORMAT.read)(input);
    };
    let mut reading = Reading {
        axis: Some(AxisTold::Laser(Told {
            is: laser,
            because: because.to_owned(),
            stated,
            // `iR785` in a name is the laser of a Raman spectrometer and nothing else.
            plain: true,
        })),
        ..Reading::default()
    };
    for table in &tables {
        let Layout::Column(axis) = table.layout else {
            continue;
        };
        let block = &table.block;
        if table.is_short {
            reading.notes.push(pick::lines_left_out(block));
            continue;
        }
        let nm: Vec<f64> = block
            .column(axis)
            .iter()
            .map(|shift| 1e7 / (1e7 / laser - shift))
            .collect();
        let (values, _) = value_columns(block, &table.titles, axis);
        if let Some(bad) = block
            .bad
            .iter()
            .find(|bad| bad.column == axis || values.contains(&bad.column))
        {
            return Err(columns::bad_cell(input, bad));
        }
        for column in &values {
            let name = match values.len() {
                1 => input.stem().to_owned(),
                _ => format!("{}, column {}", input.stem(), column + 1),
            };
            let why = format!("Raman shifts from {laser} nm: {because}");
            let mut spectrum = Measured::light(name, &nm, block.column(*column).to_vec(), "");
            spectrum.lines = &block.lines;
            spectrum
                .how
                .push(format!("from Raman shifts of {laser} nm"));
            spectrum.notes.push(format!("taken as {why}"));
            if dialect.decimal_comma {
                spectrum.how.push("decimal comma".to_owned());
            }
            reading.guesses.push(Guess {
                spectrum: reading.spectra.len(),
                what: Guessed::WavelengthUnit,
                chosen: format!("Raman shift from {laser} nm"),
                because: because.to_owned(),
                plain: true,
            });
            spectrum.finish(input, &mut reading)?;
        }
    }
    if reading.spectra.is_empty() {
        return Err(input.error("no column of Raman shifts", "shifts (1/cm) and values"));
    }
    reading.notes.push(dialect.words());
    Ok(reading)
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;

    #[test]
    fn the_lasers_power_is_not_its_wavelength() {
        let rows = "100.5\t10\n200.5\t20\n300.5\t30\n400.5\t40\n";
        for header in [
            "Laser power: 300 mW\nLaser wavelength: 785 nm\n",
            "Laser: 300 mW, 785 nm\n",
            "Laser power 300\nLaser 785\n",
        ] {
            let text = format!("{header}Raman shift (cm-1)\tIntensity\n{rows}");
            let reading = read_bytes("a.txt", text.as_bytes()).unwrap();
            let first = reading.spectra[0].samples.first_nm();
            assert!((790.0..800.0).contains(&first), "{header}: {first}");
        }
    }

    #[test]
    fn shifts_from_a_known_laser_become_wavelengths() {
        let rows = "100.5\t10\n200.5\t20\n300.5\t30\n400.5\t40\n";
        for (name, text) in [
            ("Neon_iR785_x.txt", rows.to_owned()),
            (
                "a.txt",
                format!("Laser wavelength: 785 nm\nRaman shift (cm-1)\tIntensity\n{rows}"),
            ),
            (
                "a.txt",
                format!("#Laser=\t785.0\n#AxisType[1]=\tSpectr\n#AxisUnit[1]=\t1/cm\n{rows}"),
            ),
            (
                "a.txt",
                format!(
                    "#Laser=\t785nm_edge\r\n#Raman shift\r\n{}",
                    rows.replace('\n', "\r\n")
                ),
            ),
        ] {
            let reading = read_bytes(name, text.as_bytes()).unwrap();
            assert_eq!(reading.format, "Raman text", "{text}");
            let want = 1e7 / (1e7 / 785.0 - 100.5);
            assert_eq!(reading.spectra[0].samples.first_nm(), want);
            assert!(
                reading
                    .guesses
                    .iter()
                    .any(|g| g.chosen == "Raman shift from 785 nm")
            );
        }
    }

    #[test]
    fn an_unknown_laser_is_refused_and_wavelengths_beside_are_taken() {
        let why = read_bytes("a.txt", b"Raman shift\tCounts\n100\t1\n200\t2\n300\t3\n");
        assert_eq!(
            why.unwrap_err().to_string(),
            "a.txt: found Raman shifts (1/cm) from a laser that is not named, expected wavelengths, or the laser's wavelength in the header"
        );
        let both = "Wavelength (nm)\tRaman Shift\tCounts\n400\t1\t1\n500\t2\t2\n600\t3\t3\n";
        assert_eq!(
            read_bytes("a.txt", both.as_bytes()).unwrap().format,
            "plain columns"
        );
    }
}
