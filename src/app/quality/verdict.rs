//! What a light does, in sentences that a client understands.

use super::without;
use crate::{
    app::{comparison::Side, tint, verdicts},
    color::quality::{Fidelity, HUE_NAMES},
};

/// What a light does to colours, and what it is good enough for; two sentences.
pub(super) fn verdict(side: &Side) -> String {
    let (name, figures) = (&side.name, &side.figures);
    let (fidelity, rendering) = match (&figures.fidelity, &figures.rendering) {
        (Ok(fidelity), Ok(rendering)) => (fidelity, rendering),
        (Err(why), _) | (_, Err(why)) => return without(name, "colour rendition", why),
    };
    let how = verdicts::of_rf(fidelity.rf);
    let coloured = figures.cct.as_ref().is_ok_and(|cct| {
        // No reference of a white is like it.
        tint::whiteness(*cct) == tint::Whiteness::Coloured
    });
    if coloured || rendering.is_too_far() {
        let rf = fidelity.rf;
        return format!(
            "{name} {how} on average (Rf {rf:.0}). It is not white enough for CRI to say more."
        );
    }
    let [red, skin] = [8, 12].map(|i| rendering.samples[i].index);
    let [red_looks, skin_looks] = [red, skin].map(verdicts::of_sample);
    let surfaces = match red_looks == skin_looks {
        true => format!("light skin and strong red both {}", plural(red_looks)),
        false => format!("light skin {skin_looks}, strong red {red_looks}"),
    };
    let ra = rendering.ra;
    // As the figure is printed, so that the sentence does not contradict it.
    let reaches = if ra.round() >= 80.0 {
        "reaches"
    } else {
        "misses"
    };
    format!(
        "{name} {how} on average: {surfaces}. Its Ra of {ra:.0} {reaches} the 80 that EN 12464-1 \
         asks for where people read and work."
    )
}

/// "looks off" of two.
fn plural(looks: &str) -> String {
    looks.replacen("looks", "look", 1)
}

/// The hue that shifts most under each light, a sentence.
pub(super) fn rendition(sides: &[Side]) -> String {
    let clauses = sides.iter().enumerate().map(|(i, side)| {
        let name = &side.name;
        match &side.figures.fidelity {
            Ok(fidelity) => worst_hue(name, fidelity, i > 0),
            Err(why) => {
                let words = without(name, "colour rendition", why);
                words.trim_end_matches('.').to_owned()
            }
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
        || format!("{name} has no hue to tell of"),
        |(bin, hue)| {
            let how = verdicts::of_shift(bin.rcs, bin.rhs);
            let under = if goes_on { "under" } else { "Under" };
            format!("{under} {name} {hue} shifts most: {how}, Rf {:.0}", bin.rf)
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
                words.contains(skin) || words.contains(&plural(skin)),
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
        for name in ["HP1", "paper/Sodium", "paper/Mercury"] {
            let words = verdict(&side(name));
            assert!(words.ends_with('.') && !words.contains("NaN"), "{words}");
            assert!(!words.contains("EN 12464"), "{words}");
        }
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
