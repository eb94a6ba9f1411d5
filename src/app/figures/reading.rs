//! What figures mean in plain words. The words themselves and their borders stand in `verdicts` and
//! `tint`.

use crate::{
    app::{tint, verdicts},
    color::{
        Cct,
        quality::{
            EFFICACY, Figures, RENDERING_NAMES, Rendering, SP_RATIO, Single,
            diagram::quadrangle_of, sample_names,
        },
    },
    languages::{fixed, said},
};

/// CCT, with the quadrangle that the colour lies in.
pub(super) fn of_cct(figures: &Figures, cct: Cct) -> String {
    let white = tint::name(cct);
    let quadrangle = figures.xy[0].clone().ok().and_then(quadrangle_of);
    match quadrangle {
        Some(found) => tr!(
            "{white}; may be sold as {kelvin} K",
            white,
            kelvin = fixed(found.nominal_k, 0)
        ),
        None => tr!(
            "{white}; in none of the ten basic quadrangles of ANSI C78.377",
            white
        ),
    }
}

/// Ra, with the test colour that shifts most: the mean tells nothing of it.
pub(super) fn of_ra(found: &Rendering) -> String {
    let indices = found.indices();
    let lowest = (0..indices.len()).min_by(|a, b| indices[*a].total_cmp(&indices[*b]));
    let lowest = lowest.unwrap_or(0);
    tr!(
        "{verdict}; lowest R{number} {index}",
        verdict = verdicts::of_ra(found.ra),
        number = lowest + 1,
        index = fixed(indices[lowest], 0)
    )
}

/// Where the hue bins stand of whose chroma is told: strong red, and light and medium skin, which
/// lie in two bins or near their border.
fn bins_of(number: usize) -> &'static [usize] {
    match number {
        9 => &[0],
        13 | 15 => &[1, 2],
        _ => &[],
    }
}

/// One of R1 to R15, named by its test colour; of reds and skin also which way they shift, by the
/// local chroma of TM-30, as an index has no direction.
pub(super) fn of_sample(figures: &Figures, number: usize, index: f64) -> String {
    let bins = figures.fidelity.as_ref().map(|found| &found.bins);
    let chroma = bins_of(number).iter().filter_map(|bin| {
        let bins = bins.ok()?;
        Some(bins[*bin].as_ref()?.rcs)
    });
    let chroma: Vec<f64> = chroma.collect();
    let way = verdicts::of_chroma(&chroma).filter(|_| index < 90.0);
    let way = way.map_or_else(String::new, |way| format!(", {way}"));
    tr!(
        "{colour} {looks}: R{number} {index}{way}",
        colour = said(RENDERING_NAMES[number - 1]),
        looks = verdicts::of_sample(index),
        number,
        index = fixed(index, 0),
        way
    )
}

/// Rf, with the sample that shifts most: the mean tells nothing of it.
pub(super) fn of_rf(rf: f64, samples: &[f64]) -> String {
    let said = tr!("{verdict} on average", verdict = verdicts::of_rf(rf));
    let all = samples.iter().zip(sample_names());
    match all.min_by(|a, b| a.0.total_cmp(b.0)) {
        Some((lowest, sample)) => tr!(
            "{verdict}; most {sample} ({index})",
            verdict = said,
            sample,
            index = fixed(lowest, 0)
        ),
        None => said,
    }
}

/// The words of a figure of one number; none where nobody has written any.
pub(super) fn of_single(single: &Single) -> fn(f64) -> String {
    match single.key {
        key if key == EFFICACY.key => of_efficacy,
        key if key == SP_RATIO.key => of_sp,
        _ => |_| String::new(),
    }
}

fn of_efficacy(lumens: f64) -> String {
    let share = fixed(100.0 * lumens / 683.0, 0);
    tr!("{share} % of the 683 lm/W that are possible", share)
}

pub(super) fn of_melanopic(der: f64) -> String {
    let ratio = fixed(der, 2);
    tr!(
        "has {ratio} times the melanopic light of D65 at the same lux",
        ratio
    )
}

fn of_sp(ratio: f64) -> String {
    match ratio {
        r if r < 1.0 => said!("little for eyes adapted to the dark"),
        r if r < 2.0 => said!("like most lamps for eyes adapted to the dark"),
        _ => said!("much for eyes adapted to the dark; daylight has 2.5"),
    }
    .to_owned()
}

pub(super) fn of_purity(purity: f64) -> String {
    let share = fixed(100.0 * purity, 0);
    tr!("{share} % of the way from white to the pure colour", share)
}

pub(super) fn of_dominant(nm: f64) -> String {
    let hue = verdicts::of_wavelength(nm.abs());
    if nm < 0.0 {
        tr!("a purple: the complement of {hue} light", hue)
    } else {
        tr!("the hue of {hue} light", hue)
    }
}

pub(super) fn of_edi(lux: f64) -> String {
    match lux >= 250.0 {
        true => said!("reaches the 250 lx at the eye advised by day (Brown et al. 2022)"),
        false => said!("below the 250 lx at the eye advised by day (Brown et al. 2022)"),
    }
    .to_owned()
}

pub(super) fn of_peak(figures: &Figures) -> String {
    let peak = figures.shape.as_ref().map(|shape| &shape.peak);
    match peak {
        Ok(Ok(peak)) if peak.is_at_end => {
            said!("where the table or the visible ends: it may be higher beyond").to_owned()
        }
        _ => String::new(),
    }
}
