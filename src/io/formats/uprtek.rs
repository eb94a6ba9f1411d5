//! UPRtek spectrometers (MK350, CV600, PG100N, ...) and the LI-COR LI-180, which is built from them:
//! TAB text, often named `.xls`.
//!
//! ```text
//! Model Name<TAB>CV600
//! CCT<TAB>5198.000000          the maker's own results: LUX, CCT, Duv, CRI, R1..R15, Rf, Rg, PPFD
//! IRR<TAB>2.607891             W m-2
//! 380nm<TAB>0.030267           mW m-2 nm-1
//! ```
//!
//! Results may also follow the spectrum, several measurements side by side in columns. The
//! values are mW m-2 nm-1; files of photons (µmol m-2 s-1 nm-1) look the same, so that the
//! spectrum's total, by the trapezium rule, is held against the maker's `IRR`, `PFD` and `PPFD`.

use std::ops::RangeInclusive;

use super::keyed_lines::{KeyedLines, is_point, reading_of};
use super::{Confidence, Format};
use crate::io::interpret::{RawSpectrum, value_unit::PHOTONS};
use crate::io::reading::remark::PHOTON_NOTE;
use crate::io::text::{lines, number};
use crate::io::{Input, MakersResult, Quantity, ReadError, Reading};
use crate::languages::{said, translated, with_sign};

pub(crate) const FORMAT: Format = Format::new(
    "UPRtek",
    &["xls", "txt"],
    |input| Confidence::certain_if(is_meter(input) && !is_li180(input)),
    |input| read(input, "UPRtek's"),
);

/// The maker of [`LI_180`] in words.
const LICORS: &str = "the LI-180's";

/// LI-COR's meter, which is built from UPRtek's and writes the same.
pub(crate) const LI_180: Format = Format::new(
    "LI-COR LI-180",
    &["txt", "xls"],
    |input| Confidence::certain_if(is_li180(input) && is_meter(input)),
    |input| read(input, LICORS),
);

/// Largest difference, as a share, between the spectrum's total and the one that the maker states.
const SAME_TOTAL: f64 = 0.01;

/// True if a text has the layout shared by UPRtek's meters and those built by it.
fn is_meter(input: &Input) -> bool {
    let head = input.head();
    let has_key = |most: usize, keys: &[&str]| {
        lines(head).take(most).any(|(_, line)| {
            let line = line.trim_start_matches('"').to_lowercase();
            let mut behind = keys.iter().filter_map(|key| line.strip_prefix(key));
            behind.any(|rest| rest.starts_with(['\t', ';', ',', '"']))
        })
    };
    let model = has_key(20, &["model name", "model"]);
    let known = has_key(usize::MAX, &["lambdap", "lambdapvalue", "i-time", "tlmf-a"]);
    // A model's name alone is written by any program.
    let results = || has_key(usize::MAX, &["lux", "cct", "ppfd", "pfd", "irr"]);
    let points = lines(head).filter(|(_, l)| is_point(l)).take(2).count() == 2;
    known && (points || model) || model && points && results()
}

/// True if the meter is LI-COR's LI-180.
fn is_li180(input: &Input) -> bool {
    let is_told = |l: &str| l.to_lowercase().starts_with("model name") && l.contains("LI-180");
    lines(input.head()).take(20).any(|(_, line)| is_told(line))
}

/// Reads a meter's file; `makers` names the maker, whose meters count in mW m-2 nm-1 unless their
/// totals imply otherwise.
///
/// # Errors
/// [`ReadError`] for a file without points, or with a word for a value.
fn read(input: &Input, makers: &str) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let none = match makers {
        LICORS => said!("the LI-180's results and no spectrum"),
        _ => said!("UPRtek's results and no spectrum"),
    };
    let none = [none, said!("lines such as \"380nm\", TAB and a value")];
    let found = KeyedLines::of_meter(input, text, none)?;
    let nm = found.nm();
    reading_of(input, &found, 0..nm.len(), |column, values, results| {
        let peak = found.get_of("lambdapvalue", column);
        let peak = peak.and_then(|value| number::number(value, false));
        let (unit, because) = match peak {
            Some(peak) if is_over_its_peak(&values, peak) => {
                let because = tr!(
                    "values over the largest, which is {peak} by the maker",
                    peak = with_sign(peak.to_string())
                );
                ("", because)
            }
            _ => unit(nm, &values, results, makers),
        };
        let mut keys = ["memo", "title", "name"].into_iter();
        let name = match keys.find_map(|key| found.get_of(key, column)) {
            Some(name) => name.to_owned(),
            None if found.columns() == 1 => input.stem().to_owned(),
            None => format!("{}, {}", input.stem(), column + 1),
        };
        let mut spectrum = RawSpectrum::light(name, nm, values, unit);
        spectrum.notes.push(because);
        if unit == PHOTONS {
            spectrum.notes.push(said(PHOTON_NOTE).to_owned());
        }
        if let Some(model) = found.get("model name") {
            spectrum.notes.push(tr!("measured with a {model}", model));
        }
        spectrum
    })
}

/// True if values were divided by the largest, which the maker gives as another number.
fn is_over_its_peak(values: &[f64], peak: f64) -> bool {
    let most = values.iter().copied().fold(f64::MIN, f64::max);
    most == 1.0 && (peak - most).abs() > SAME_TOTAL
}

/// The unit of the values and its justification in words.
fn unit(
    nm: &[f64],
    values: &[f64],
    results: &[MakersResult],
    makers: &str,
) -> (&'static str, String) {
    let total_of = |range: RangeInclusive<f64>| -> f64 {
        nm.windows(2)
            .zip(values.windows(2))
            .filter(|(x, _)| range.contains(&x[0]) && range.contains(&x[1]))
            .map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1]))
            .sum()
    };
    let total = total_of(f64::MIN..=f64::MAX);
    // Photosynthesis counts 400-700 nm only.
    let of_plants = total_of(400.0..=700.0);
    for (quantity, total, unit) in [
        (Quantity::Irradiance, 1e-3 * total, "mW m-2 nm-1"),
        (Quantity::Irradiance, total, "W m-2 nm-1"),
        (Quantity::Irradiance, 1e-2 * total, "µW cm-2 nm-1"),
        (Quantity::Pfd, total, PHOTONS),
        (Quantity::Ppfd, of_plants, PHOTONS),
    ] {
        let stated = results.iter().find(|result| result.quantity == quantity);
        let stated = stated.map(|result| result.value).filter(|v| *v > 0.0);
        if let Some(stated) = stated
            && (total - stated).abs() <= SAME_TOTAL * stated
        {
            let (of, name) = (quantity.usual_unit(), quantity.to_string());
            let number = with_sign(stated.to_string());
            let because = match unit {
                PHOTONS => tr!(
                    "counted in photons: the total is the maker's {quantity} of {number} {unit}",
                    quantity = translated(&name),
                    number,
                    unit = of
                ),
                _ => tr!(
                    "counted in {counted}: the total is the maker's {quantity} of {number} {unit}",
                    counted = unit,
                    quantity = translated(&name),
                    number,
                    unit = of
                ),
            };
            return (unit, because);
        }
    }
    let because = match makers {
        LICORS => said!("mW m-2 nm-1 is the LI-180's unit; the file states none"),
        _ => said!("mW m-2 nm-1 is UPRtek's unit; the file states none"),
    };
    ("mW m-2 nm-1", because.to_owned())
}
