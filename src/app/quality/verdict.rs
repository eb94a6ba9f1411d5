//! What a light does, in sentences that a client understands.

use super::without_rendition;
use crate::{
    app::{comparison::Side, tint, verdicts},
    color::quality::{Fidelity, HUE_NAMES},
    languages::{fixed, said},
};

/// What a light does to colours, and what it is good enough for; two sentences.
pub(super) fn verdict(side: &Side) -> String {
    let (name, figures) = (&side.name, &side.figures);
    let (fidelity, rendering) = match (&figures.fidelity, &figures.rendering) {
        (Ok(fidelity), Ok(rendering)) => (fidelity, rendering),
        (Err(why), _) | (_, Err(why)) => return format!("{}.", without_rendition(name, why)),
    };
    let shifts = verdicts::shifts_on_average(name, fidelity.rf);
    let coloured = figures.cct.as_ref().is_ok_and(|cct| {
        // No reference of a white is like it.
        tint::whiteness(*cct) == tint::Whiteness::Coloured
    });
    if coloured || rendering.is_too_far() {
        let rf = fixed(fidelity.rf, 0);
        return tr!(
            "{shifts} (Rf {rf}). It is not white enough for CRI to say more.",
            shifts,
            rf
        );
    }
    let [red, skin] = [8, 12].map(|i| rendering.samples[i].index);
    let surfaces = match verdicts::Looks::of(skin) == verdicts::Looks::of(red) {
        true => both_look(red).to_owned(),
        false => format!("{}, {}", skin_looks(skin), red_looks(red)),
    };
    let ra = rendering.ra;
    // As the figure is printed, so that the sentence does not contradict it.
    if ra.round() >= 80.0 {
        tr!(
            "{shifts}: {surfaces}. Its Ra of {ra} reaches the 80 that EN 12464-1 asks for where \
             people read and work.",
            shifts,
            surfaces,
            ra = fixed(ra, 0)
        )
    } else {
        tr!(
            "{shifts}: {surfaces}. Its Ra of {ra} misses the 80 that EN 12464-1 asks for where \
             people read and work.",
            shifts,
            surfaces,
            ra = fixed(ra, 0)
        )
    }
}

fn skin_looks(index: f64) -> &'static str {
    match verdicts::Looks::of(index) {
        verdicts::Looks::Right => said!("light skin looks right"),
        verdicts::Looks::LittleOff => said!("light skin looks a little off"),
        verdicts::Looks::Off => said!("light skin looks off"),
        verdicts::Looks::Wrong => said!("light skin looks wrong"),
    }
}

fn red_looks(index: f64) -> &'static str {
    match verdicts::Looks::of(index) {
        verdicts::Looks::Right => said!("strong red looks right"),
        verdicts::Looks::LittleOff => said!("strong red looks a little off"),
        verdicts::Looks::Off => said!("strong red looks off"),
        verdicts::Looks::Wrong => said!("strong red looks wrong"),
    }
}

fn both_look(index: f64) -> &'static str {
    match verdicts::Looks::of(index) {
        verdicts::Looks::Right => said!("light skin and strong red both look right"),
        verdicts::Looks::LittleOff => said!("light skin and strong red both look a little off"),
        verdicts::Looks::Off => said!("light skin and strong red both look off"),
        verdicts::Looks::Wrong => said!("light skin and strong red both look wrong"),
    }
}

/// The hue that shifts most under each light, a sentence.
pub(super) fn rendition(sides: &[Side]) -> String {
    let clauses = sides.iter().enumerate().map(|(i, side)| {
        let name = &side.name;
        match &side.figures.fidelity {
            Ok(fidelity) => worst_hue(name, fidelity, i > 0),
            Err(why) => without_rendition(name, why),
        }
    });
    let clauses: Vec<String> = clauses.collect();
    format!("{}.", clauses.join("; "))
}

fn worst_hue(name: &str, fidelity: &Fidelity, goes_on: bool) -> String {
    let bins = fidelity.bins.iter().zip(HUE_NAMES);
    let known = bins.filter_map(|(bin, hue)| Some((bin.as_ref()?, hue)));
    let worst = known.min_by(|a, b| a.0.rf.total_cmp(&b.0.rf));
    worst.map_or_else(
        || tr!("{name} has no hue to tell of", name),
        |(bin, hue)| {
            let how = verdicts::of_shift(bin.rcs, bin.rhs);
            let (hue, rf) = (said(hue), fixed(bin.rf, 0));
            // As the figure is printed: where the worst is 100, nothing shifts.
            match (bin.rf >= 99.5, goes_on) {
                (true, false) => tr!("Under {name} no hue shifts: Rf {rf} at worst", name, rf),
                (true, true) => tr!("under {name} no hue shifts: Rf {rf} at worst", name, rf),
                (false, false) => tr!(
                    "Under {name} {hue} shifts most: {how}, Rf {rf}",
                    name,
                    hue,
                    how,
                    rf
                ),
                (false, true) => tr!(
                    "under {name} {hue} shifts most: {how}, Rf {rf}",
                    name,
                    hue,
                    how,
                    rf
                ),
            }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::open;

    fn side(name: &str) -> Side {
        let entry = open::resolve(name, None, None).expect("a preset");
        Side::of(entry.name().to_owned(), &entry.spectrum)
    }

    #[test]
    fn a_verdict_says_what_its_figures_say() {
        for name in ["FL2", "LED-B1", "CIE A", "FL11"] {
            let side = side(name);
            let words = verdict(&side);
            let rendering = side.figures.rendering.as_ref().expect("a white");
            let rf = side.figures.fidelity.as_ref().expect("a white").rf;
            assert!(words.contains(verdicts::of_rf(rf)), "{words}");
            let skin = verdicts::of_sample(rendering.samples[12].index);
            assert!(
                words.contains(skin) || words.contains(both_look(rendering.samples[12].index)),
                "{words}"
            );
            let reaches = words.contains(" reaches the 80 ");
            assert_eq!(reaches, rendering.ra.round() >= 80.0, "{words}");
            assert!(
                words.contains(&format!("Ra of {:.0}", rendering.ra)),
                "{words}"
            );
        }
    }

    #[test]
    fn what_is_no_white_is_not_measured_against_one() {
        for name in ["Neon tube", "paper/Sodium", "paper/Mercury"] {
            let words = verdict(&side(name));
            assert!(words.ends_with('.') && !words.contains("NaN"), "{words}");
            assert!(!words.contains("EN 12464"), "{words}");
        }
        // 0.0008 from the blackbodies: CIE 13.3 vouches for the index, bad as it is.
        let words = verdict(&side("HP1"));
        assert!(words.contains(" misses the 80 "), "{words}");
    }

    #[test]
    fn the_hue_that_shifts_most_has_a_name_and_its_own_fidelity() {
        let sides = [side("FL2"), side("LED-B1")];
        let words = rendition(&sides);
        for side in &sides {
            let bins = &side.figures.fidelity.as_ref().expect("a white").bins;
            let lowest = bins.iter().flatten().map(|bin| bin.rf);
            let lowest = lowest.fold(f64::INFINITY, f64::min);
            assert!(words.contains(&format!("nder {} ", side.name)), "{words}");
            assert!(words.contains(&format!("Rf {lowest:.0}")), "{words}");
        }
        let hues = HUE_NAMES.iter().filter(|hue| words.contains(*hue)).count();
        assert!(hues >= 1, "{words}");
    }
}
