//! Claim by claim: the paper's words, and what is measured here in words.

mod samples;

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
    languages::{fixed, said, with_sign},
    spectrum::{Basis, Sampling, numbers_of_order},
    study::truth::{self, STATED_ORDER, STATED_SHARE},
};

pub(super) use samples::samples_row;

pub(super) fn five_percent_row(claims: &Claims) -> Row {
    let stated = STATED_ORDER.figure as usize;
    let channels = claims.five_percent.channels;
    let row = |measured: String, verdict, condition: &str| Row {
        claim: said!("Eleven numbers are enough"),
        place: said(STATED_ORDER.place),
        paper: tr!(
            "On 400-700 nm, with N = {order}, the first term left out is below {share} % and the \
             following vanish rapidly.",
            order = stated,
            share = percent(STATED_SHARE.figure)
        ),
        measured,
        verdict,
        condition: condition.to_owned(),
    };
    if is_all_in_spikes(claims) {
        return row(String::new(), Verdict::Open, said(ALL_IN_SPIKES));
    }
    let Some(left_out) = all(channels.map(|c| c.at_stated_order)) else {
        return row(String::new(), Verdict::Open, &no_colour_or_short(claims));
    };
    let summed = tr!(
        "Summed to N = {order}, X, Y and Z are off by {off} %; the largest single terms left out \
         are {terms} %.",
        order = stated,
        off = three(left_out.map(|l| off_percent(l.tail))),
        terms = three(left_out.map(|l| percent(l.largest_term)))
    );
    let bound = if claims.harmonics.orders.iter().any(|o| o.bound.is_some()) {
        tr!(
            "On {range} the corrected Eq. 12 promises terms below 5 % from n = {promised} on (as \
             printed {printed}).",
            range = range(claims.band),
            promised = three(channels.map(|c| c.promised.to_string())),
            printed = three(channels.map(|c| c.promised_as_printed.to_string()))
        )
    } else if claims.basis == Basis::Fourier {
        said!("Eq. 12 is about the CIE 1931 functions alone: no bound here.").to_owned()
    } else {
        said!("Eq. 12 is about the Fourier basis; for another there is no bound.").to_owned()
    };
    let measured = format!("{summed} {bound}");
    let limit = STATED_SHARE.figure;
    let small = |l: &truth::Neglected| l.tail.abs() < limit && l.largest_term < limit;
    let premise = claims.harmonics.slowest_fall;
    if left_out.iter().all(small) {
        let condition = match premise.filter(|p| !p.meets_eq_11()) {
            Some(slow) => tr!(
                "by measurement, not by Eq. 12, as the light does not fall like 1/n (at n = \
                 {order} it is {times} times |a0|/n)",
                order = slow.order,
                times = figure(slow.fall)
            ),
            None => String::new(),
        };
        return row(measured, Verdict::Holds, &condition);
    }
    match all(channels.map(|c| c.sufficient_order)) {
        Some(orders) => {
            let order = orders.into_iter().max().unwrap_or(stated).max(stated);
            let condition = if order > stated {
                tr!(
                    "from N = {order} on ({numbers})",
                    order,
                    numbers = many::numbers(numbers_of_order(order))
                )
            } else {
                said!("for the sum: a single term left out is larger").to_owned()
            };
            row(measured, Verdict::OnlyIf, &condition)
        }
        None => row(
            measured,
            Verdict::Fails,
            &tr!(
                "no order up to {highest} is enough",
                highest = claims.five_percent.highest_order
            ),
        ),
    }
}

fn no_colour_or_short(claims: &Claims) -> String {
    if claims.harmonics.exact.iter().any(|v| *v <= 0.0) {
        said(NO_COLOUR).to_owned()
    } else {
        tr!(
            "this range carries orders up to {highest} only",
            highest = claims.five_percent.highest_order
        )
    }
}

/// Why a spectrum has no X, Y, Z to add up to.
const NO_COLOUR: &str = later!("X, Y and Z are not all positive in this range");

/// Why a claim about the smooth part says nothing.
const ALL_IN_SPIKES: &str = later!("the smooth part is zero: all of it is in the spikes");

/// Whether nothing is left for the smooth part.
fn is_all_in_spikes(claims: &Claims) -> bool {
    claims.harmonics.numbers.iter().all(|n| n.light == 0.0)
}

fn all<T: Copy>(three: [Option<T>; 3]) -> Option<[T; 3]> {
    let [x, y, z] = three;
    Some([x?, y?, z?])
}

pub(super) fn eq_17_row(claims: &Claims) -> Row {
    let mut measured = Vec::new();
    if let Some(worked) = claims.worked {
        measured.push(tr!(
            "On 400-700 nm with N = 5 a straight line read at {place} nm gives {printed} nm as \
             printed and {corrected} nm corrected.",
            place = with_sign(worked.at_nm.to_string()),
            printed = fixed(worked.printed_nm, 1),
            corrected = fixed(worked.corrected_nm, 1)
        ));
    }
    let mut condition = said!("with its two weights exchanged");
    if let (Some(found), Some(factor)) = (&claims.eq_17, &claims.factor) {
        if found.readings.is_empty() {
            measured.push(tr!(
                "{light} has no spikes to read it at.",
                light = claims.light
            ));
        } else if let (Some(printed), Some(linear)) = (found.printed_cost, found.linear_cost) {
            measured.push(tr!(
                "At the {n} line of {light} on {surface} it costs ΔE₀₀ {printed} as printed and \
                 {corrected} corrected, against the series read exactly."
                    | "At the {n} lines of {light} on {surface} it costs ΔE₀₀ {printed} as \
                       printed and {corrected} corrected, against the series read exactly."
                        % found.readings.len(),
                light = claims.light,
                surface = factor,
                printed = delta_e(printed),
                corrected = delta_e(linear)
            ));
            if linear >= HARD_TO_SEE {
                condition = said!(
                    "with its two weights exchanged, and the straight line itself still costs \
                     colour here"
                );
            }
        }
    }
    Row {
        claim: said!("The factor at a spike, by a straight line"),
        place: said!("Eq. 17"),
        paper: said!(
            "The factor at a spike is read by linear interpolation between the two points around \
             it."
        )
        .to_owned(),
        measured: measured.join(" "),
        verdict: Verdict::OnlyIf,
        condition: condition.to_owned(),
    }
}

pub(super) fn table_2_row(claims: &Claims) -> Row {
    let found = claims.table_2;
    let off = three(found.worst.map(|d| {
        tr!(
            "{deviation} at {place} nm",
            deviation = signed(d.off(), 3),
            place = short(d.at_nm)
        )
    }));
    let mut measured = vec![tr!(
        "The largest deviations of x-bar, y-bar and z-bar are {deviations}.",
        deviations = off
    )];
    if claims.observer != Observer::CIE_1931 {
        measured.push(tr!(
            "The fit was made for CIE 1931; the observer in force is {observer}.",
            observer = claims.observer.title()
        ));
    }
    let (verdict, condition) = match found.delta_uv.zip(found.delta_e_2000) {
        Some((uv, colour)) => {
            measured.push(tr!(
                "Used for colour it would move {light} by Δu'v' {shift} (ΔE₀₀ {difference}).",
                light = claims.light,
                shift = figure(uv),
                difference = delta_e(colour)
            ));
            if colour < HARD_TO_SEE {
                (Verdict::Holds, String::new())
            } else {
                let why = said!("for the shape of the functions, not for colour").to_owned();
                (Verdict::OnlyIf, why)
            }
        }
        None => (
            Verdict::Open,
            said!("there is no visible light in this range").to_owned(),
        ),
    };
    Row {
        claim: said!("Bells for the colour-matching functions"),
        place: said!("Eq. 9, Table 2, Figure 2"),
        paper: said!(
            "Four Gaussian bells show a good correspondence with the CIE colour-matching functions."
        )
        .to_owned(),
        measured: measured.join(" "),
        verdict,
        condition,
    }
}

pub(super) fn resampling_row(claims: &Claims) -> Row {
    let order = claims.order;
    let row = |measured: String, verdict, condition: String| Row {
        claim: said!("A product on 2N+2 points"),
        place: said!("Eq. 15, 16"),
        paper: tr!(
            "2N + 2 sample points avoid information loss, so a product of two smooth spectra \
             takes {count} multiplications.",
            count = with_sign(truth::stated_multiplications(order).figure.to_string())
        ),
        measured,
        verdict,
        condition,
    };
    let (Some(factor), Some(paper)) = (&claims.factor, claims.way(Sampling::Paper)) else {
        let why = said!("there is no factor to multiply with").to_owned();
        return row(String::new(), Verdict::Open, why);
    };
    let mut measured = tr!(
        "{light} x {surface}, both cut to N = {order}: {points} independent points fold {share} % \
         of the product's power into lower orders and cost ΔE₀₀ {difference}.",
        light = claims.light,
        surface = factor,
        order,
        points = paper.points,
        share = percent(paper.folded_share),
        difference = delta_e(paper.delta_e_2000)
    );
    let others = claims.resampling.iter().flat_map(|r| r.ways.iter().skip(1));
    let others: Vec<String> = others
        .map(|way| {
            tr!(
                "{points} points ΔE₀₀ {difference}",
                points = way.points,
                difference = delta_e(way.delta_e_2000)
            )
        })
        .collect();
    if !others.is_empty() {
        measured += &format!(" {}.", others.join(", "));
    }
    if is_all_in_spikes(claims) {
        return row(String::new(), Verdict::Open, said(ALL_IN_SPIKES).to_owned());
    }
    if claims.light_is_dark {
        let why = said!("the light is zero over the whole range").to_owned();
        return row(String::new(), Verdict::Open, why);
    }
    if paper.folded_share.is_nan() || paper.folded_share < ROUNDING {
        return row(measured, Verdict::Holds, String::new());
    }
    let condition = match paper.delta_e_2000 {
        Some(cost) => tr!(
            "roughly: the product has order 2N, and here that costs ΔE₀₀ {difference}",
            difference = delta_e(cost)
        ),
        None => said!("roughly: the product has order 2N").to_owned(),
    };
    row(measured, Verdict::OnlyIf, condition)
}

pub(super) fn eq_7_row(claims: &Claims) -> Row {
    let row = |measured: String, verdict, condition: &str| Row {
        claim: said!("X, Y, Z from the coefficients"),
        place: said!("Eq. 7"),
        paper: said!("The sum of the products of the coefficients, that of order 0 divided by 4.")
            .to_owned(),
        measured,
        verdict,
        condition: condition.to_owned(),
    };
    let Some(found) = claims.eq_7 else {
        let why = if claims.basis == Basis::Fourier {
            said(NO_COLOUR)
        } else {
            said!("Eq. 7 is written for the Fourier basis")
        };
        return row(String::new(), Verdict::Open, why);
    };
    let pair = |[x, y]: [f64; 2]| format!("({}, {})", fixed(x, 3), fixed(y, 3));
    let (order, subject) = (claims.order, &claims.subject);
    let (corrected, exact) = (pair(found.corrected), pair(found.exact));
    let mut measured = match found.printed {
        Some(xy) => tr!(
            "At N = {order} it puts {subject} at xy {printed} as printed, and at xy {corrected} \
             with order 0 divided by 2; measured {exact}.",
            order,
            subject,
            printed = pair(xy),
            corrected,
            exact
        ),
        None => tr!(
            "At N = {order} it puts {subject} nowhere as printed, and at xy {corrected} with \
             order 0 divided by 2; measured {exact}.",
            order,
            subject,
            corrected,
            exact
        ),
    };
    if found.lowest_printed < 0.0 {
        measured += " ";
        measured += said!("As printed one of X, Y and Z is negative.");
    }
    if found.printed == Some(found.corrected) {
        // Everything is in the spikes: order 0 is zero.
        return row(measured, Verdict::Open, said!("order 0 adds nothing here"));
    }
    row(
        measured,
        Verdict::OnlyIf,
        said!("with order 0 divided by 2, not by 4"),
    )
}
