//! Claim by claim: the paper's words, and what is measured here in words.

use std::fmt::Write as _;

use super::{
    Claims,
    row::{Row, Verdict, off_percent, range, three},
};
use crate::{
    app::{
        numbers::{ROUNDING, delta_e, figure, percent, signed},
        ticks::short,
        verdicts::HARD_TO_SEE,
    },
    color::Observer,
    io::many,
    spectrum::{Basis, Sampling, numbers_of_order},
    study::{
        Measure,
        truth::{self, Match, STATED_ORDER, STATED_SHARE},
    },
};

pub(super) fn five_percent_row(claims: &Claims) -> Row {
    let stated = STATED_ORDER.figure as usize;
    let channels = claims.five_percent.channels;
    let row = |measured: String, verdict, condition: &str| Row {
        claim: "Eleven numbers are enough",
        place: STATED_ORDER.place,
        paper: format!(
            "On 400-700 nm, with N = {stated}, the first term left out is below {} % and the \
             following vanish rapidly.",
            percent(STATED_SHARE.figure)
        ),
        measured,
        verdict,
        condition: condition.to_owned(),
    };
    if is_all_in_spikes(claims) {
        return row(String::new(), Verdict::Open, ALL_IN_SPIKES);
    }
    let Some(left_out) = all(channels.map(|c| c.at_stated_order)) else {
        return row(String::new(), Verdict::Open, &no_colour_or_short(claims));
    };
    let mut measured = format!(
        "Summed to N = {stated}, X, Y and Z are off by {} %; the largest single terms left out are \
         {} %.",
        three(left_out.map(|l| off_percent(l.tail))),
        three(left_out.map(|l| percent(l.largest_term))),
    );
    if claims.harmonics.orders.iter().any(|o| o.bound.is_some()) {
        let _ = write!(
            measured,
            " On {} the corrected Eq. 12 promises terms below 5 % from n = {} on (as printed \
             {}).",
            range(claims.band),
            three(channels.map(|c| c.promised.to_string())),
            three(channels.map(|c| c.promised_as_printed.to_string())),
        );
    } else if claims.basis == Basis::Fourier {
        measured.push_str(" Eq. 12 is about the CIE 1931 functions alone: no bound here.");
    } else {
        measured.push_str(" Eq. 12 is about the Fourier basis; for another there is no bound.");
    }
    let limit = STATED_SHARE.figure;
    let small = |l: &truth::Neglected| l.tail.abs() < limit && l.largest_term < limit;
    let premise = claims.harmonics.slowest_fall;
    if left_out.iter().all(small) {
        let condition = match premise.filter(|p| !p.meets_eq_11()) {
            Some(slow) => format!(
                "by measurement, not by Eq. 12, as the light does not fall like 1/n (at n = {} it \
                 is {} times |a0|/n)",
                slow.order,
                figure(slow.fall)
            ),
            None => String::new(),
        };
        return row(measured, Verdict::Holds, &condition);
    }
    match all(channels.map(|c| c.sufficient_order)) {
        Some(orders) => {
            let order = orders.into_iter().max().unwrap_or(stated).max(stated);
            let condition = if order > stated {
                format!(
                    "from N = {order} on ({})",
                    many::numbers(numbers_of_order(order))
                )
            } else {
                "for the sum: a single term left out is larger".to_owned()
            };
            row(measured, Verdict::OnlyIf, &condition)
        }
        None => row(
            measured,
            Verdict::Fails,
            &format!(
                "no order up to {} is enough",
                claims.five_percent.highest_order
            ),
        ),
    }
}

fn no_colour_or_short(claims: &Claims) -> String {
    if claims.harmonics.exact.iter().any(|v| *v <= 0.0) {
        NO_COLOUR.to_owned()
    } else {
        format!(
            "this range carries orders up to {} only",
            claims.five_percent.highest_order
        )
    }
}

/// Why a spectrum has no X, Y, Z to add up to.
const NO_COLOUR: &str = "X, Y and Z are not all positive in this range";

/// Why a claim about the smooth part says nothing.
const ALL_IN_SPIKES: &str = "the smooth part is zero: all of it is in the spikes";

/// Whether nothing is left for the smooth part.
fn is_all_in_spikes(claims: &Claims) -> bool {
    claims.harmonics.numbers.iter().all(|n| n.light == 0.0)
}

fn all<T: Copy>(three: [Option<T>; 3]) -> Option<[T; 3]> {
    let [x, y, z] = three;
    Some([x?, y?, z?])
}

pub(super) fn samples_row(claims: &Claims) -> Row {
    let row = |measured: String, verdict, condition: String| Row {
        claim: "20 numbers instead of 400 samples",
        place: truth::STATED_SAMPLES.place,
        paper: format!(
            "From 380 to 780 nm at least {} samples to avoid missing any spikes, or about {} \
             numbers: {} for the background and {} for the spikes.",
            truth::STATED_SAMPLES.figure,
            truth::STATED_NUMBERS.figure,
            truth::STATED_BACKGROUND.figure,
            truth::STATED_SPIKE_NUMBERS.figure,
        ),
        measured,
        verdict,
        condition,
    };
    let Some(found) = &claims.samples else {
        let why = "the spectrum is zero over the whole range".to_owned();
        return row(String::new(), Verdict::Open, why);
    };
    let numbers = found.numbers();
    let both = |m: Match| {
        let (surely, best) = (m.surely.samples, m.at_best.samples);
        if surely == best {
            surely.to_string()
        } else {
            format!("{surely} ({best} where they happen to fall well)")
        }
    };
    let (errors, needed) = (found.composite, found.needed);
    let samples = |measure| needed[measure].map_or_else(String::new, both);
    let of_colour = errors[Measure::Own].map_or_else(String::new, |own| {
        format!(" an own colour off by ΔE₀₀ {},", delta_e(own))
    });
    let for_colour =
        needed[Measure::Own].map_or_else(String::new, |own| format!(" own colour {},", both(own)));
    let measured = format!(
        "{} ({} for the background, {} for {}) leave{of_colour} rms {} % at 1 nm \
         (where a line of some width counts as missed by its spike) and {} % behind 10 nm. \
         Even samples joined by straight lines, every count tried, that do as well:{for_colour} rms {}, behind 10 nm {}.",
        many::numbers(numbers),
        found.background,
        2 * found.spikes,
        many::many(found.spikes, "spike", "spikes"),
        percent(errors[Measure::Rms]),
        percent(errors[Measure::RmsBlurred]),
        samples(Measure::Rms),
        samples(Measure::RmsBlurred),
    );
    let judged = [
        ("own colour", Measure::Own),
        ("the spectrum at 1 nm", Measure::Rms),
        ("the spectrum behind 10 nm", Measure::RmsBlurred),
    ];
    let judged: Vec<(&str, bool)> = judged
        .into_iter()
        // A count that does as well where the samples happen to fall well is no proof.
        .filter_map(|(what, measure)| Some((what, needed[measure]?.at_best.samples > numbers)))
        .collect();
    let good: Vec<&str> = judged.iter().filter(|j| j.1).map(|j| j.0).collect();
    let (verdict, condition) = if good.len() == judged.len() {
        (
            Verdict::Holds,
            format!("more than {numbers} samples are needed for the same"),
        )
    } else if good.is_empty() {
        (
            Verdict::Fails,
            format!("{numbers} samples or fewer do as well here"),
        )
    } else {
        (Verdict::OnlyIf, format!("for {}", good.join(" and ")))
    };
    row(measured, verdict, condition)
}

pub(super) fn eq_17_row(claims: &Claims) -> Row {
    let mut measured = String::new();
    if let Some(worked) = claims.worked {
        let _ = write!(
            measured,
            "On 400-700 nm with N = 5 a straight line read at {} nm gives {:.1} nm as printed and \
             {:.1} nm corrected.",
            worked.at_nm, worked.printed_nm, worked.corrected_nm
        );
    }
    let mut condition = "with its two weights exchanged".to_owned();
    if let (Some(found), Some(factor)) = (&claims.eq_17, &claims.factor) {
        if found.readings.is_empty() {
            let _ = write!(measured, " {} has no spikes to read it at.", claims.light);
        } else if let (Some(printed), Some(linear)) = (found.printed_cost, found.linear_cost) {
            let _ = write!(
                measured,
                " At the {} of {} on {factor} it costs ΔE₀₀ {} as printed and {} corrected, \
                 against the series read exactly.",
                many::many(found.readings.len(), "spike", "spikes"),
                claims.light,
                delta_e(printed),
                delta_e(linear),
            );
            if linear >= HARD_TO_SEE {
                condition.push_str(", and the straight line itself still costs colour here");
            }
        }
    }
    Row {
        claim: "The factor at a spike, by a straight line",
        place: "Eq. 17",
        paper: "The factor at a spike is read by linear interpolation between the two points \
                around it."
            .to_owned(),
        measured: measured.trim_start().to_owned(),
        verdict: Verdict::OnlyIf,
        condition,
    }
}

pub(super) fn table_2_row(claims: &Claims) -> Row {
    let found = claims.table_2;
    let off = three(
        found
            .worst
            .map(|d| format!("{} at {} nm", signed(d.off(), 3), short(d.at_nm))),
    );
    let mut measured = format!("The largest deviations of x-bar, y-bar and z-bar are {off}.");
    if claims.observer != Observer::CIE_1931 {
        let _ = write!(
            measured,
            " The fit was made for CIE 1931; the observer in force is {}.",
            claims.observer.title()
        );
    }
    let (verdict, condition) = match found.delta_uv.zip(found.delta_e_2000) {
        Some((uv, colour)) => {
            let _ = write!(
                measured,
                " Used for colour it would move {} by Δu'v' {} (ΔE₀₀ {}).",
                claims.light,
                figure(uv),
                delta_e(colour)
            );
            if colour < HARD_TO_SEE {
                (Verdict::Holds, String::new())
            } else {
                let why = "for the shape of the functions, not for colour".to_owned();
                (Verdict::OnlyIf, why)
            }
        }
        None => (
            Verdict::Open,
            "there is no visible light in this range".to_owned(),
        ),
    };
    Row {
        claim: "Bells for the colour-matching functions",
        place: "Eq. 9, Table 2, Figure 2",
        paper: "Four Gaussian bells show a good correspondence with the CIE colour-matching \
                functions."
            .to_owned(),
        measured,
        verdict,
        condition,
    }
}

pub(super) fn resampling_row(claims: &Claims) -> Row {
    let order = claims.order;
    let row = |measured: String, verdict, condition: String| Row {
        claim: "A product on 2N+2 points",
        place: "Eq. 15, 16",
        paper: format!(
            "2N + 2 sample points avoid information loss, so a product of two smooth spectra \
             takes {} multiplications.",
            truth::stated_multiplications(order).figure
        ),
        measured,
        verdict,
        condition,
    };
    let (Some(factor), Some(paper)) = (&claims.factor, claims.way(Sampling::Paper)) else {
        let why = "there is no factor to multiply with".to_owned();
        return row(String::new(), Verdict::Open, why);
    };
    let mut measured = format!(
        "{} x {factor}, both cut to N = {order}: {} independent points fold {} % of the product's \
         power into lower orders and cost ΔE₀₀ {}.",
        claims.light,
        paper.points,
        percent(paper.folded_share),
        delta_e(paper.delta_e_2000),
    );
    let others = claims.resampling.iter().flat_map(|r| r.ways.iter().skip(1));
    let others: Vec<String> = others
        .map(|way| format!("{} points ΔE₀₀ {}", way.points, delta_e(way.delta_e_2000)))
        .collect();
    if !others.is_empty() {
        let _ = write!(measured, " {}.", others.join(", "));
    }
    if is_all_in_spikes(claims) {
        return row(String::new(), Verdict::Open, ALL_IN_SPIKES.to_owned());
    }
    if claims.light_is_dark {
        let why = "the light is zero over the whole range".to_owned();
        return row(String::new(), Verdict::Open, why);
    }
    if paper.folded_share.is_nan() || paper.folded_share < ROUNDING {
        return row(measured, Verdict::Holds, String::new());
    }
    let condition = match paper.delta_e_2000 {
        Some(cost) => format!(
            "roughly: the product has order 2N, and here that costs ΔE₀₀ {}",
            delta_e(cost)
        ),
        None => "roughly: the product has order 2N".to_owned(),
    };
    row(measured, Verdict::OnlyIf, condition)
}

pub(super) fn eq_7_row(claims: &Claims) -> Row {
    let row = |measured: String, verdict, condition: &str| Row {
        claim: "X, Y, Z from the coefficients",
        place: "Eq. 7",
        paper: "The sum of the products of the coefficients, that of order 0 divided by 4."
            .to_owned(),
        measured,
        verdict,
        condition: condition.to_owned(),
    };
    let Some(found) = claims.eq_7 else {
        let why = if claims.basis == Basis::Fourier {
            NO_COLOUR
        } else {
            "Eq. 7 is written for the Fourier basis"
        };
        return row(String::new(), Verdict::Open, why);
    };
    let pair = |[x, y]: [f64; 2]| format!("({x:.3}, {y:.3})");
    let mut measured = format!(
        "At N = {} it puts {} {} as printed, and at xy {} with order 0 divided by 2; measured {}.",
        claims.order,
        claims.subject,
        found
            .printed
            .map_or_else(|| "nowhere".to_owned(), |xy| format!("at xy {}", pair(xy))),
        pair(found.corrected),
        pair(found.exact),
    );
    if found.lowest_printed < 0.0 {
        measured.push_str(" As printed one of X, Y and Z is negative.");
    }
    if found.printed == Some(found.corrected) {
        // Everything is in the spikes: order 0 is zero.
        return row(measured, Verdict::Open, "order 0 adds nothing here");
    }
    row(
        measured,
        Verdict::OnlyIf,
        "with order 0 divided by 2, not by 4",
    )
}
