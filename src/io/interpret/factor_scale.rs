//! The scale of the values of a reflectance or transmittance: fractions, per cent, or whole
//! numbers. The user's choice takes precedence over the format, the format over titles and header,
//! and these over the size of the values.

use super::kinds::{kind_of_words, states_values};
use crate::io::Counted;
use crate::io::reading::decision::Decision;
use crate::io::text::NumberedLines;
use crate::io::text::words::holds_one;
use crate::languages::fixed;
use crate::spectrum::Kind;

/// The factor from the file's numbers to the unit, as far as a format determines it.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum KnownScale {
    /// Nothing: of a factor titles or the size of the values must tell.
    #[default]
    Open,
    /// This factor.
    Stated(f64),
    /// Factors are fractions, unless their size says that somebody wrote per cent.
    Fractions,
    /// The reader's decision for all spectra of the file.
    Told(Decision<Counted>),
}

/// The scale of the values of a factor, and the multiplier to fractions; for other values the
/// multiplier to their unit. `size` decides by titles and by the size of the values.
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

const EIGHT_BITS: f64 = 255.0;

/// True if the largest values leave hardly any doubt about their scale.
pub(crate) fn is_plain_size(counted: Counted, high: f64) -> bool {
    match counted {
        Counted::Fraction => PLAIN_FRACTION.contains(&high),
        Counted::Percent => PLAIN_PERCENT.contains(&high),
        Counted::TenThousandths => PLAIN_PERCENT.contains(&(0.01 * high)),
        Counted::EightBits | Counted::SixteenBits | Counted::Otherwise => false,
    }
}

/// The scale of the values of a factor (reflectance, transmittance): as stated by their title, per
/// cent signs, or the header (`header` is per cent), else by their size.
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
    let of_title = |counted| Decision::stated(counted, said!("the column's title"));
    if counts_ten_thousandths(&title) {
        return of_title(Counted::TenThousandths);
    }
    if signs {
        return Decision::stated(Counted::Percent, said!("per cent signs"));
    }
    // Many a title keeps its per cent sign over fractions.
    let or_fractions = |stated: &str, doubted: fn(f64) -> String| match largest(values) {
        high if high <= MOST_DOUBTFUL => Decision::guessed(Counted::Percent, false, doubted(high)),
        _ => Decision::stated(Counted::Percent, stated),
    };
    if is_percent_title(&title) {
        return or_fractions(said!("the column's title"), |high| {
            tr!(
                "the column's title, but no value exceeds {high}: they may be fractions",
                high = fixed(high, 3)
            )
        });
    }
    if holds_one(title.trim(), "[1.0];fraction;^tfr$;^rfr$") {
        return of_title(Counted::Fraction);
    }
    match header {
        Some(true) => or_fractions(said!("the header"), |high| {
            tr!(
                "the header, but no value exceeds {high}: they may be fractions",
                high = fixed(high, 3)
            )
        }),
        Some(false) => Decision::stated(Counted::Fraction, said!("the header")),
        None => by_size(values),
    }
}

/// Largest values that are hardly per cent, whatever a title says.
const MOST_DOUBTFUL: f64 = 1.2;

/// True if a title (lower case) means per cent.
fn is_percent_title(title: &str) -> bool {
    holds_one(title.trim(), "%;percent;^tpc$;^rpc$")
}

/// True if title, header or signs state that values are per cent.
pub(crate) fn states_percent(title: &str, header: Option<bool>, signs: bool) -> bool {
    signs || is_percent_title(&title.to_lowercase()) || header == Some(true)
}

/// The scale implied by the size of the values.
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
        // More than white sends back, and whole numbers throughout.
        true if high > *PLAIN_PERCENT.end() && are_bytes(values) => Counted::EightBits,
        _ => Counted::percent(percent),
    };
    let reason = tr!(
        "the values' size (up to about {high})",
        high = fixed(high, 3)
    );
    Decision::guessed(counted, is_plain_size(counted, high), reason)
}

fn are_bytes(values: &[f64]) -> bool {
    let is_byte = |v: &f64| v.fract() == 0.0 && (0.0..=EIGHT_BITS).contains(v);
    values.len() >= 10 && values.iter().all(is_byte)
}

/// True if 10 000 is all of the light by a title (lower case): "reflectance (x10000)".
fn counts_ten_thousandths(title: &str) -> bool {
    const TIMES: &str = "x10000|;x1e4|;x10^4|;*10000|;*1e4|;*10^4|;×10000|;×1e4|;×10^4|";
    let bare: String = title.chars().filter(|c| !c.is_whitespace()).collect();
    holds_one(&bare, TIMES)
}

/// True if a header states per cent, false if it states fractions; `None` if neither.
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

/// True if a line (lower case) states the scale of the values of a factor: humidities and other
/// settings are per cent too. It names the y axis or the factor, or only a unit.
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

/// The scale implied by the size of values, where they may be whole numbers to 10,000.
pub(crate) fn or_large(
    size: Decision<Counted>,
    may_be_large: bool,
    values: &[f64],
) -> Decision<Counted> {
    let value = match size.value {
        Counted::SixteenBits | Counted::EightBits => size.value,
        _ if may_be_large && largest(values) > MOST_PERCENT => Counted::TenThousandths,
        value => value,
    };
    Decision { value, ..size }
}
