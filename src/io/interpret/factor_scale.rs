//! What the values of a reflectance or transmittance are counted in: fractions, per cent, or whole
//! numbers. A person's word goes before what the format says, that before titles and header, and
//! these before the size of the values.

use super::kinds::{kind_of_words, states_values};
use crate::io::Counted;
use crate::io::reading::decision::Decision;
use crate::io::text::NumberedLines;
use crate::io::text::words::holds;
use crate::spectrum::Kind;

/// What a format knows of the factor from the file's numbers to the unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum KnownScale {
    /// Nothing: of a factor titles or the size of the values must tell.
    #[default]
    Open,
    /// This factor.
    Stated(f64),
    /// Factors are fractions, unless their size says that somebody wrote per cent.
    Fractions,
    /// What the reader decided for all spectra of the file.
    Told(Decision<Counted>),
}

/// What the values of a factor are counted in, and the factor to fractions; for other values the
/// factor to their unit. `size` decides by titles and by the size of the values.
pub(crate) fn decide_scale(
    (kind, own): (Kind, Kind),
    known: &KnownScale,
    chosen: Option<Counted>,
    size: impl FnOnce() -> Decision<Counted>,
) -> (Option<Decision<Counted>>, f64) {
    match known {
        KnownScale::Stated(scale) if !kind.is_factor() => return (None, *scale),
        _ if !kind.is_factor() => return (None, 1.0),
        _ => {}
    }
    let is_own = own.is_factor();
    let decision = match (chosen.filter(|counted| counted.scale().is_some()), known) {
        (Some(counted), _) => Decision::chosen(counted),
        (None, KnownScale::Stated(scale)) if is_own || *scale != 1.0 => {
            let counted = Decision::of_format(Counted::of_scale(*scale));
            return (Some(counted), *scale);
        }
        (None, KnownScale::Told(counted)) => counted.clone(),
        (None, KnownScale::Fractions) if is_own => match size() {
            size if size.value == Counted::Fraction => Decision::of_format(size.value),
            other => other,
        },
        (None, _) => size(),
    };
    let scale = decision.value.scale().unwrap_or(1.0);
    (Some(decision), scale)
}

/// Largest values that are per cent; of larger ones 10 000 is all of the light.
pub(crate) const MOST_PERCENT: f64 = 160.0;

/// Largest values that only fractions, and only per cent, have: nothing reflects less than 1 %
/// everywhere or more than all of the light by much.
const PLAIN_FRACTION: std::ops::RangeInclusive<f64> = 0.1..=1.2;

const PLAIN_PERCENT: std::ops::RangeInclusive<f64> = 10.0..=120.0;

/// Largest values that are neither: remote sensing stores ten thousandths.
const TEN_THOUSANDTHS: std::ops::RangeInclusive<f64> = 1000.0..=12_000.0;

/// Largest values that are whole numbers of 16 bits; beyond them nobody knows.
const SIXTEEN_BITS: std::ops::RangeInclusive<f64> = 12_000.0..=65_535.0;

/// Whether the largest values leave hardly a doubt about what they are counted in.
pub(crate) fn is_plain_size(counted: Counted, high: f64) -> bool {
    match counted {
        Counted::Fraction => PLAIN_FRACTION.contains(&high),
        Counted::Percent => PLAIN_PERCENT.contains(&high),
        Counted::TenThousandths => PLAIN_PERCENT.contains(&(0.01 * high)),
        Counted::SixteenBits | Counted::Otherwise => false,
    }
}

/// What the values of a factor (reflectance, transmittance) are counted in: as their title states,
/// per cent signs, or the header (`header` is per cent), else by their size.
///
/// Unstated, it is per cent when more than 1 % of the values exceed 1.5 and they are not just
/// noise over fractions: the middle value exceeds 1.5 too, or lies far under the largest (a
/// narrow filter is near 0 nearly everywhere).
pub(crate) fn counted(
    title: &str,
    header: Option<bool>,
    signs: bool,
    values: &[f64],
) -> Decision<Counted> {
    let title = title.to_lowercase();
    let of_title = |counted| Decision::stated(counted, "the column's title");
    if counts_ten_thousandths(&title) {
        return of_title(Counted::TenThousandths);
    }
    if signs {
        return Decision::stated(Counted::Percent, "per cent signs");
    }
    if title.contains('%') || title.contains("percent") || ["tpc", "rpc"].contains(&title.trim()) {
        return of_title(Counted::Percent);
    }
    if title.contains("[1.0]")
        || title.contains("fraction")
        || ["tfr", "rfr"].contains(&title.trim())
    {
        return of_title(Counted::Fraction);
    }
    if let Some(percent) = header {
        return Decision::stated(Counted::percent(percent), "the header");
    }
    by_size(values)
}

/// What the size of the values tells.
pub(crate) fn by_size(values: &[f64]) -> Decision<Counted> {
    let mut sizes: Vec<f64> = values.iter().map(|v| v.abs()).collect();
    let mut at = |share: f64| {
        let index = (share * sizes.len() as f64) as usize;
        (index < sizes.len()).then(|| *sizes.select_nth_unstable_by(index, f64::total_cmp).1)
    };
    let (middle, high) = (at(0.5).unwrap_or(0.0), at(0.99).unwrap_or(0.0));
    let percent = high > 1.5 && (middle > 1.5 || middle < 0.03 * high);
    let counted = match percent {
        true if TEN_THOUSANDTHS.contains(&high) => Counted::TenThousandths,
        true if SIXTEEN_BITS.contains(&high) => Counted::SixteenBits,
        _ => Counted::percent(percent),
    };
    let reason = format!("the values' size (up to about {high:.3})");
    Decision::guessed(counted, is_plain_size(counted, high), reason)
}

/// Whether a title (lower case) says that 10 000 is all of the light: "reflectance (x10000)".
fn counts_ten_thousandths(title: &str) -> bool {
    let bare: String = title.chars().filter(|c| !c.is_whitespace()).collect();
    let of = |times: &str| ["10000|", "1e4|", "10^4|"].map(|number| format!("{times}{number}"));
    let mut words = ["x", "*", "×"].into_iter().flat_map(of);
    words.any(|word| holds(&bare, &word))
}

/// Whether a header says that values are per cent, or fractions; `None` where it does not.
pub(crate) fn percent_of_header(header: &NumberedLines) -> Option<bool> {
    header.iter().rev().find_map(|(_, line)| {
        let line = line.trim().to_lowercase();
        if !is_about_factors(&line) {
            None
        } else if line.contains('%') || line.contains("percent") {
            Some(true)
        } else {
            line.contains("fraction").then_some(false)
        }
    })
}

/// Whether a line (lower case) states how the values of a factor are counted: humidities and other
/// settings are per cent too. It names the y axis or the factor, or nothing but a unit.
fn is_about_factors(line: &str) -> bool {
    let bare = ["unit", "units"].iter().any(|key| {
        line.strip_prefix(key).is_some_and(|rest| {
            let rest = rest.trim_matches(|c: char| !c.is_alphanumeric() && c != '%');
            ["%", "percent", "per cent", "fraction"].contains(&rest)
        })
    });
    let names_factor = || kind_of_words(line).is_some_and(Kind::is_factor);
    bare || states_values(line) && (line.starts_with('y') || names_factor())
}

/// The size that hardly a value exceeds.
pub(crate) fn largest(values: &[f64]) -> f64 {
    let sizes = values.iter().map(|v| v.abs());
    let mut sizes: Vec<f64> = sizes.filter(|v| v.is_finite()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() * 99 / 100).copied().unwrap_or(0.0)
}

/// What the size of values tells, where they may be whole numbers to 10,000.
pub(crate) fn or_large(
    size: Decision<Counted>,
    may_be_large: bool,
    values: &[f64],
) -> Decision<Counted> {
    let value = match size.value {
        Counted::SixteenBits => Counted::SixteenBits,
        _ if may_be_large && largest(values) > MOST_PERCENT => Counted::TenThousandths,
        value => value,
    };
    Decision { value, ..size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn per_cent_is_told_from_noisy_fractions_and_whole_numbers() {
        let mut noisy = vec![0.9; 200];
        noisy[5..15].fill(20.0);
        assert!(by_size(&noisy).value != Counted::Percent);
        let mut filter = vec![0.01; 200];
        filter[90..100].fill(80.0);
        for (values, counted) in [
            (&filter[..], Counted::Percent),
            (&[40.0, 50.0, 60.0], Counted::Percent),
            (&[6553.5, 32_767.0, 65_535.0], Counted::SixteenBits),
            (&[1000.0, 5000.0, 10_000.0], Counted::TenThousandths),
        ] {
            assert_eq!(by_size(values).value, counted);
        }
        assert!(by_size(&[6553.5, 32_767.0, 65_535.0]).is_doubtful());
    }

    #[test]
    fn a_stated_per_cent_needs_no_look_at_the_values() {
        let header = percent_of_header(&[(1, "Y Units: Reflectance (percent)")]);
        let of = |title, values: &[f64]| counted(title, header, false, values).value;
        assert_eq!(of("", &[0.5]), Counted::Percent);
        assert_eq!(of("Reflect. [1.0]", &[50.0]), Counted::Fraction);
    }

    #[test]
    fn a_per_cent_of_something_else_is_not_the_values() {
        for (line, percent) in [
            ("Measurement humidity: 45 %", None),
            ("measurement: 5 % uncertainty", None),
            ("Unit serial 50%", None),
            ("Y Units: %", Some(true)),
            ("Unit: %", Some(true)),
            ("Units\t[%]", Some(true)),
            ("Measurement: % Reflectance", Some(true)),
            ("unit: fraction", Some(false)),
        ] {
            assert_eq!(percent_of_header(&[(1, line)]), percent, "{line}");
        }
    }
}
