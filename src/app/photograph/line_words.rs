//! The lines of an axis by the elements that they are of.

use super::Photograph;
use crate::{
    languages::fixed,
    photographs::{
        Lamp,
        axis::{Match, Solution},
    },
};

/// Lines of mercury, and of terbium and europium in the phosphors of fluorescent lamps, nm.
const HG: [f64; 8] = [404.7, 407.8, 435.8, 491.6, 546.1, 577.0, 579.1, 690.7];
const TB: [f64; 8] = [487.4, 491.2, 542.6, 549.0, 584.2, 587.4, 621.5, 625.0];
const EU: [f64; 9] = [
    593.0, 599.6, 611.3, 613.3, 631.0, 650.5, 662.6, 687.4, 709.0,
];
const NA: [f64; 6] = [466.8, 498.2, 515.3, 568.6, 589.3, 615.8];
/// Lines of one element that are as far off are it, nm.
const NEAR_NM: f64 = 2.5;
/// Lines closer than this many widths are one peak.
const BLENDED: f64 = 1.2;

/// The lists of a lamp's elements.
fn elements(lamp: Lamp) -> &'static [(&'static str, &'static [f64])] {
    match lamp {
        Lamp::Fluorescent => &[("Hg", &HG), ("Tb", &TB), ("Eu", &EU)],
        Lamp::Mercury => &[("Hg", &HG)],
        Lamp::Sodium => &[("Na", &NA), ("Hg", &HG)],
        _ => &[],
    }
}

/// The symbol of a lamp of one element.
fn symbol(lamp: Lamp) -> &'static str {
    match lamp {
        Lamp::Neon => "Ne",
        Lamp::Argon => "Ar",
        Lamp::Krypton => "Kr",
        Lamp::Xenon => "Xe",
        Lamp::Hydrogen => "H",
        Lamp::Helium => "He",
        _ => "",
    }
}

/// The elements of a line that is so wide, the nearest first.
fn elements_at(lamp: Lamp, nm: f64, fwhm_nm: f64) -> Vec<&'static str> {
    let reach = NEAR_NM.max(0.5 * BLENDED * fwhm_nm);
    let away = |list: &[f64]| list.iter().map(|l| (l - nm).abs()).fold(f64::MAX, f64::min);
    let mut near: Vec<(f64, &str)> = (elements(lamp).iter())
        .map(|(symbol, list)| (away(list), *symbol))
        .filter(|(away, _)| *away <= reach)
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A second one is told only where the slit cannot part them.
    let blended = |(away, _): &&(f64, &str)| *away <= 0.5 * BLENDED * fwhm_nm;
    let others = near.iter().skip(1).filter(blended);
    near.iter().take(1).chain(others).map(|n| n.1).collect()
}

/// The lines with their elements: "Hg 404.7, 435.8, Tb 488.4, Tb and Hg together 544.4".
pub(super) fn told(photograph: &Photograph, best: &Solution) -> String {
    let width = |m: &Match| {
        let peak = photograph.peaks().peaks[m.peak];
        peak.fwhm_px * best.curve.slope(peak.px).abs()
    };
    let mut lines: Vec<(f64, f64)> = best
        .matches
        .iter()
        .map(|m| (m.landmark.nm, width(m)))
        .collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut words = Vec::new();
    let mut last = String::new();
    for (nm, fwhm) in lines {
        let who = match elements_at(best.lamp, nm, fwhm)[..] {
            [] => symbol(best.lamp).to_owned(),
            [one] => one.to_owned(),
            ref all => tr!("{elements} together", elements = all.join(said!(" and "))),
        };
        if who == last || who.is_empty() {
            words.push(fixed(nm, 1));
        } else {
            words.push(format!("{who} {}", fixed(nm, 1)));
        }
        last = who;
    }
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_have_their_elements_and_those_that_a_slit_does_not_part_have_both() {
        let at = |nm, fwhm| elements_at(Lamp::Fluorescent, nm, fwhm);
        assert_eq!((at(435.8, 2.0), at(611.4, 2.0)), (vec!["Hg"], vec!["Eu"]));
        assert_eq!(at(546.1, 1.5), ["Hg"]);
        assert_eq!(at(543.8, 4.0), ["Tb", "Hg"]);
        assert!(at(460.0, 2.0).is_empty());
        assert_eq!(symbol(Lamp::Neon), "Ne");
    }
}
