//! Errors of models, a row for each measure.

use super::{Figure, NUMBER, Unit, Words};
use crate::study::Measure;

/// A colour difference: key, title and short name, goal, meaning.
const fn delta_e(key: Words, [title, short]: [Words; 2], goal: Words, meaning: Words) -> Figure {
    Figure {
        key,
        title,
        short,
        unit: Unit::DELTA_E,
        digits: 3,
        meaning,
        goal,
        ..NUMBER
    }
}

/// A share of the spectrum: key, title and short name, as the report says it, meaning.
const fn share(key: Words, [title, short]: [Words; 2], said: Words, meaning: Words) -> Figure {
    Figure {
        said,
        unit: Unit::PERCENT,
        digits: 2,
        ..delta_e(key, [title, short], "", meaning)
    }
}

impl Measure {
    /// What is said of it.
    #[expect(clippy::too_many_lines, reason = "a table: one row a measure")]
    pub fn figure(self) -> Figure {
        match self {
            Self::Own => delta_e(
                "delta_e_own",
                [later!("own colour"), later!("own")],
                later!("in its own colour"),
                later!("CIEDE2000 of the spectrum's own colour."),
            ),
            Self::Patches => delta_e(
                "delta_e_patches_mean",
                [later!("mean of the surfaces"), later!("surfaces")],
                later!("on the surfaces (mean)"),
                later!("Mean CIEDE2000 of the surfaces under the light, products at 1 nm."),
            ),
            Self::PatchesWorst => delta_e(
                "delta_e_patches_max",
                [later!("worst surface"), later!("worst")],
                later!("on every surface"),
                later!("Largest CIEDE2000 of the surfaces under the light, products at 1 nm."),
            ),
            Self::Filters => delta_e(
                "delta_e_filters",
                [later!("narrow filters"), later!("filters")],
                later!("behind narrow filters (mean)"),
                later!(
                    "Mean CIEDE2000 behind Gaussian band-passes of 10 nm full width at 420, 430 \
                     ... 670 nm. The filter is exact; the exact light behind it is brought to Y = \
                     50."
                ),
            ),
            Self::Rms => Figure {
                goal: later!("rms at 1 nm"),
                ..share(
                    "relative_rms",
                    [later!("rms at 1 nm"), later!("rms 1 nm")],
                    later!("; at 1 nm {} rms"),
                    later!(
                        "Root mean square of model minus measured over that of the spectrum, on \
                         the 1 nm grid. A line of the model has no width: against a line of \
                         several nm, lamps with broad lines show large numbers."
                    ),
                )
            },
            Self::RmsBlurred => Figure {
                goal: later!("rms behind a 10 nm blur"),
                ..share(
                    "relative_rms_10nm",
                    [later!("rms behind 10 nm"), later!("rms 10 nm")],
                    later!("{} rms behind a 10 nm blur"),
                    later!(
                        "Root mean square of model minus measured over that of the spectrum, both \
                     behind a Gaussian blur of 10 nm full width at half maximum."
                    ),
                )
            },
            Self::MaxAbs => share(
                "max_abs",
                [later!("largest"); 2],
                later!(", {} at most"),
                later!("Largest difference over the largest value."),
            ),
            Self::Energy => Figure {
                digits: 3,
                signed: true,
                ..share(
                    "energy",
                    [later!("energy"); 2],
                    later!(", energy {}"),
                    later!("Power of the model over that of the spectrum, less one."),
                )
            },
            Self::Lowest => share(
                "lowest",
                [later!("lowest"); 2],
                later!(", lowest {}"),
                later!(
                    "Lowest value of the smooth part over the largest value; negative is a lobe \
                     below zero."
                ),
            ),
            Self::Displacement => Figure {
                unit: Unit::NANOMETRE,
                ..share(
                    "displacement_nm",
                    [later!("displacement"), later!("displaced")],
                    later!(", light displaced by {}"),
                    later!(
                        "Mean distance that the model's power would have to be moved to be where \
                         it was measured: the area between both running sums of power, each over \
                         its own total."
                    ),
                )
            },
        }
    }
}

/// The shares in the order of the panel, where two stand in a row.
pub const SHARES: [Measure; 6] = [
    Measure::Displacement,
    Measure::RmsBlurred,
    Measure::Rms,
    Measure::MaxAbs,
    Measure::Lowest,
    Measure::Energy,
];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_figure_has_a_key_of_its_own_and_says_what_it_is() {
        let keys: BTreeSet<&str> = Measure::ALL.map(|m| m.figure().key).into();
        assert_eq!(keys.len(), Measure::ALL.len());
        for measure in Measure::ALL {
            let figure = measure.figure();
            assert!(figure.meaning.ends_with('.'), "{measure:?}");
            assert_eq!(figure.unit == Unit::DELTA_E, measure.is_colour());
            assert_ne!(SHARES.contains(&measure), measure.is_colour());
            let is_compared = Measure::COMPARED.contains(&measure);
            assert_ne!(figure.goal.is_empty(), is_compared, "{measure:?}");
        }
    }
}
