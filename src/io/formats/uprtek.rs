//! UPRtek spectrometers (MK350, CV600, PG100N, ...): TAB text, often named `.xls`.
//!
//! ```text
//! Model Name<TAB>CV600
//! CCT<TAB>5198.000000          the maker's own results: LUX, CCT, Duv, CRI, R1..R15, Rf, Rg, PPFD
//! IRR<TAB>2.607891             W m-2
//! 380nm<TAB>0.030267           mW m-2 nm-1
//! ```
//!
//! Results may also stand behind the spectrum, several measurements side by side in columns. The
//! values are mW m-2 nm-1; files of photons (µmol m-2 s-1 nm-1) look the same, so that the
//! spectrum's total, by the trapezium rule, is held against the maker's `IRR`, `PFD` and `PPFD`.

use std::ops::RangeInclusive;

use super::keyed_lines::{KeyedLines, is_point, reading_of};
use super::{Confidence, Format};
use crate::io::interpret::raw::RawSpectrum;
use crate::io::interpret::value_unit::PHOTONS;
use crate::io::reading::makers_results::{MakersResult, Quantity};
use crate::io::reading::remark::PHOTON_NOTE;
use crate::io::text::{lines, number};
use crate::io::{Input, ReadError, Reading};

/// UPRtek text.
pub(crate) const FORMAT: Format = Format {
    name: "UPRtek",
    extensions: &["xls", "txt"],
    sniff,
    read,
};

/// Largest difference, as a share, between the spectrum's total and the one that the maker states.
const SAME_TOTAL: f64 = 0.01;

fn sniff(input: &Input) -> Confidence {
    if is_meter(input) && !is_li180(input) {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

/// Whether a text has the layout that UPRtek's meters and those built by it share.
pub(crate) fn is_meter(input: &Input) -> bool {
    let head = input.head();
    let key = |line: &str, words: &[&str]| {
        let line = line.trim_start_matches('"').to_lowercase();
        words.iter().any(|word| {
            line.strip_prefix(word)
                .is_some_and(|rest| rest.starts_with(['\t', ';', ',', '"']))
        })
    };
    let model = lines(head)
        .take(20)
        .any(|(_, l)| key(l, &["model name", "model"]));
    let known = lines(head).any(|(_, l)| key(l, &["lambdap", "lambdapvalue", "i-time", "tlmf-a"]));
    // A model's name alone is written by any program.
    let results = || lines(head).any(|(_, l)| key(l, &["lux", "cct", "ppfd", "pfd", "irr"]));
    let points = lines(head).filter(|(_, l)| is_point(l)).take(2).count() == 2;
    known && (points || model) || model && points && results()
}

/// Whether the meter is LI-COR's.
pub(crate) fn is_li180(input: &Input) -> bool {
    let head = input.head();
    lines(head)
        .take(20)
        .any(|(_, l)| l.to_lowercase().starts_with("model name") && l.contains("LI-180"))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    read_meter(input, "UPRtek's")
}

/// Reads a meter's file; `makers` is whose meters count in mW m-2 nm-1 unless their totals say
/// otherwise.
///
/// # Errors
/// [`ReadError`] for a file without points, or with a word for a value.
pub(crate) fn read_meter(input: &Input, makers: &str) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let none = format!("{makers} results and no spectrum");
    let none = [&*none, "lines such as \"380nm\", TAB and a value"];
    let found = KeyedLines::of_meter(input, text, none)?;
    reading_of(
        input,
        &found,
        0..found.nm.len(),
        |column, values, results| {
            let peak = found.get_of("lambdapvalue", column);
            let peak = peak.and_then(|value| number::number(value, false));
            let unit = match peak {
                Some(peak) if is_over_its_peak(&values, peak) => UnitFound {
                    unit: "",
                    because: format!("values over the largest, which is {peak} by the maker"),
                },
                _ => unit(&found.nm, &values, results, makers),
            };
            let name = ["memo", "title", "name"]
                .iter()
                .find_map(|key| found.get_of(key, column))
                .map_or_else(
                    || match found.columns {
                        1 => input.stem().to_owned(),
                        _ => format!("{}, {}", input.stem(), column + 1),
                    },
                    str::to_owned,
                );
            let mut spectrum = RawSpectrum::light(name, &found.nm, values, unit.unit);
            spectrum.notes.push(unit.because);
            if unit.unit == PHOTONS {
                spectrum.notes.push(PHOTON_NOTE.to_owned());
            }
            if let Some(model) = found.get("model name") {
                spectrum.notes.push(format!("measured with a {model}"));
            }
            spectrum
        },
    )
}

/// A unit and what told it.
struct UnitFound {
    unit: &'static str,
    because: String,
}

/// Whether values were divided by the largest, which the maker gives as another number.
fn is_over_its_peak(values: &[f64], peak: f64) -> bool {
    let most = values.iter().copied().fold(f64::MIN, f64::max);
    most == 1.0 && (peak - most).abs() > SAME_TOTAL
}

fn unit(nm: &[f64], values: &[f64], results: &[MakersResult], makers: &str) -> UnitFound {
    let total_of = |range: RangeInclusive<f64>| -> f64 {
        nm.windows(2)
            .zip(values.windows(2))
            .filter(|(x, _)| range.contains(&x[0]) && range.contains(&x[1]))
            .map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1]))
            .sum()
    };
    let total = total_of(f64::MIN..=f64::MAX);
    let stated = |quantity: &Quantity| {
        results
            .iter()
            .find(|r| r.quantity == *quantity)
            .map(|r| r.value)
            .filter(|v| *v > 0.0)
    };
    let same = |total: f64, stated: f64| (total - stated).abs() <= SAME_TOTAL * stated;
    if let Some(irradiance) = stated(&Quantity::Irradiance) {
        for (unit, factor) in [
            ("mW m-2 nm-1", 1e-3),
            ("W m-2 nm-1", 1.0),
            ("µW cm-2 nm-1", 1e-2),
        ] {
            if same(factor * total, irradiance) {
                let because = format!(
                    "counted in {unit}: the total is the maker's irradiance of {irradiance} W m-2"
                );
                return UnitFound { unit, because };
            }
        }
    }
    // Photosynthesis counts 400-700 nm only.
    let fluxes = [
        (Quantity::Pfd, total),
        (Quantity::Ppfd, total_of(400.0..=700.0)),
    ];
    for (quantity, total) in fluxes {
        if let Some(flux) = stated(&quantity)
            && same(total, flux)
        {
            let because = format!(
                "counted in photons: the total is the maker's {quantity} of {flux} µmol m-2 s-1"
            );
            return UnitFound {
                unit: PHOTONS,
                because,
            };
        }
    }
    UnitFound {
        unit: "mW m-2 nm-1",
        because: format!("mW m-2 nm-1 is {makers} unit; the file states none"),
    }
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;
    use crate::io::reading::makers_results::Quantity;
    use crate::spectrum::Kind;

    const SMALL: &str = "Model Name\tMK350\nMemo\t\nLUX\t12.5\nCCT\t3000.0\nx\t0.44\nI-Time\t100\n\
                         CRI\t92.0\nR9\t50.5\nRf\t90\nIRR\t0.03\n380nm\t1.0\n390nm\t2.0\n400nm\t-0.5\n";

    #[test]
    fn photons_are_told_by_their_flux_in_the_range_of_photosynthesis() {
        let rows: String = (0..=40)
            .map(|i| format!("{}nm\t0.5\n", 380 + 10 * i))
            .collect();
        let text = format!("Model Name\tMK350\nPPFD\t150.0\n{rows}");
        let reading = read_bytes("a.xls", text.as_bytes()).unwrap();
        assert_eq!(reading.spectra[0].unit, super::PHOTONS);
    }

    #[test]
    fn spectrum_unit_and_results_are_read() {
        let reading = read_bytes("a.xls", SMALL.as_bytes()).unwrap();
        assert_eq!(reading.format, "UPRtek");
        let spectrum = &reading.spectra[0];
        assert_eq!(spectrum.samples.values(), [1.0, 2.0, -0.5]);
        assert_eq!(
            (spectrum.kind, spectrum.unit.as_str()),
            (Kind::Light, "mW m-2 nm-1")
        );
        let value = |quantity: Quantity| {
            let found = reading.results.iter().find(|r| r.quantity == quantity);
            found.map(|r| r.value)
        };
        assert_eq!(value(Quantity::Cct), Some(3000.0));
        assert_eq!(value(Quantity::Ra), Some(92.0));
        assert_eq!(value(Quantity::R(9)), Some(50.5));
        assert_eq!(value(Quantity::ChromaticityX), Some(0.44));
        assert_eq!(value(Quantity::Illuminance), Some(12.5));
        assert!(
            !reading
                .results
                .iter()
                .any(|r| r.as_written.starts_with("I-Time"))
        );
    }

    #[test]
    fn line_ends_marks_and_separators_do_not_matter() {
        let want = read_bytes("a", SMALL.as_bytes()).unwrap();
        for text in [
            SMALL.replace('\n', "\r\n"),
            format!("\u{feff}{SMALL}"),
            SMALL.replace('.', ","),
            SMALL.replace('\t', ","),
            SMALL.replace('.', ",").replace('\t', ";"),
            SMALL.replace("nm\t", " nm\t"),
        ] {
            let reading = read_bytes("a", text.as_bytes()).unwrap();
            assert_eq!(reading.format, "UPRtek", "{text}");
            assert_eq!(
                reading.spectra[0].samples, want.spectra[0].samples,
                "{text}"
            );
            let values =
                |r: &crate::io::Reading| r.results.iter().map(|r| r.value).collect::<Vec<_>>();
            assert_eq!(values(&reading), values(&want));
        }
    }

    #[test]
    fn the_total_tells_photons_from_energy() {
        let text = "Model Name\tPG100N\nPPFD\t30\n400nm\t1\n410nm\t2\n420nm\t1\nIRR\t99\n";
        let spectrum = read_bytes("a", text.as_bytes()).unwrap().spectra.remove(0);
        assert_eq!(spectrum.unit, super::PHOTONS);
        assert!(
            spectrum
                .notes
                .iter()
                .any(|n| n.contains("photons, not energy"))
        );
    }

    #[test]
    fn a_file_without_points_and_a_word_in_one_are_refused() {
        let why = |text: &str| {
            read_bytes("a.xls", text.as_bytes())
                .unwrap_err()
                .to_string()
        };
        assert_eq!(
            why("Model Name\tCV600\nI-Time\t5\nCCT\t5000\n"),
            "a.xls: found UPRtek's results and no spectrum, expected lines such as \"380nm\", TAB and a value"
        );
        assert_eq!(
            why("Model Name\tCV600\nCCT\t5000\n380nm\t5\n381nm\t6\n382nm\tabc\n"),
            "a.xls, line 5: found \"abc\", expected a number behind the wavelength"
        );
    }
}
