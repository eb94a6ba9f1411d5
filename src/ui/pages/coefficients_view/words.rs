//! What the numbers of the page "Coefficients" say, in sentences.

use crate::{
    app::{
        numbers::{figure, percent},
        studies::paper::{off_percent, three},
    },
    spectrum::Basis,
    study::harmonics::Harmonics,
    ui::pages::PageContext,
};

/// What the numbers say, in a sentence or two.
pub(super) fn sentences(context: &PageContext<'_>, harmonics: &Harmonics) -> [String; 2] {
    let order = context.pages.why.partial_order;
    let missed = harmonics.orders.get(order).map(|o| o.neglected);
    let Some([Some(x), Some(y), Some(z)]) = missed else {
        let none =
            said!("X, Y and Z are not all positive on this range: there are no shares of them.");
        return [none.to_owned(), String::new()];
    };
    let mut first = tr!(
        "The sum of {n} wave has X, Y and Z off by {shares} %"
            | "The sum of {n} waves has X, Y and Z off by {shares} %" % order,
        shares = three([x, y, z].map(off_percent))
    );
    let of_spikes = harmonics.spikes[1] / harmonics.exact[1];
    if of_spikes != 0.0 {
        first += "; ";
        first += &tr!("lines bring {share} % of Y", share = percent(of_spikes));
    }
    first.push('.');
    [first, about_the_bound(context, harmonics)]
}

fn about_the_bound(context: &PageContext<'_>, harmonics: &Harmonics) -> String {
    match harmonics.basis {
        Basis::Fourier => {}
        Basis::Cosine => {
            return said!(
                "Eq. 10 and the bound of Eq. 12 are about the Fourier basis: for cosine series \
                 there is no such bound."
            )
            .to_owned();
        }
    }
    if harmonics.orders.iter().all(|o| o.bound.is_none()) {
        return if context.app.document().is_about_light() {
            said!(
                "Eq. 10 and Eq. 12 are about the CIE 1931 functions; another observer is in force."
            )
        } else {
            said!(
                "Eq. 10 and Eq. 12 are about the colour-matching functions alone, not times a \
                 light."
            )
        }
        .to_owned();
    }
    match harmonics.slowest_fall {
        Some(slow) if slow.meets_eq_11() => tr!(
            "The bound of Eq. 12 asks that the coefficients fall like 1/n; these do (at most \
             {figure} times |a0|/n, at n = {order}).",
            figure = figure(slow.fall),
            order = slow.order
        ),
        Some(slow) => tr!(
            "The bound of Eq. 12 asks that the coefficients fall like 1/n; these do not: at n = \
             {order} they are {figure} times |a0|/n.",
            order = slow.order,
            figure = figure(slow.fall)
        ),
        None => said!("Without a mean there is nothing that the coefficients could fall from.")
            .to_owned(),
    }
}
