//! Which element a spike may be named after.
//!
//! A wrong name is worse than none. A spike gets an element's name only when the element is one
//! that lamps are made of, the spike stands within reach of a principal line of it, and another of
//! its lines is there too, or the spike is nearly all of the light. Any other line near by
//! is only told on hover. What hangs down is no line of a lamp: dips have names of their own
//! (`absorption_names`) and are no witnesses here.

use crate::spectrum::Spike;

/// One tabulated line.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementLine {
    /// Chemical symbol.
    pub element: String,
    /// Wavelength in air, nm.
    pub at_nm: f64,
    /// Relative strength within the element; NIST's are only qualitative.
    pub strength: f64,
}

/// What a spike is called.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineName {
    /// A name that is safe to print beside the spike: "Hg 435.8", "Hg 577/579".
    pub safe: Option<String>,
    /// The nearest tabulated line of any element, for hover: "near Xe 611.2".
    pub near: Option<String>,
}

/// Elements that ordinary lamps show, with the lines (nm, air) by which their discharge is known.
///
/// Only these may be printed beside a spike. The table's strengths cannot choose them: NIST's are
/// qualitative, and its mercury lines at 708 and 709 nm, as strong there as 577 nm, would give the
/// name to europium's phosphor line at 709 nm.
const PRINCIPAL: [(&str, &[f64]); 5] = [
    ("Hg", &[404.656, 435.833, 546.075, 576.961, 579.067]),
    ("Na", &[588.995, 589.592]),
    ("H", &[410.173, 434.047, 486.135, 656.279]),
    (
        "He",
        &[388.865, 447.148, 501.568, 587.562, 667.815, 706.519],
    ),
    ("Cd", &[467.815, 479.991, 508.582, 643.847]),
];
/// A tabulated line is a principal one when it stands this near, nm.
const SAME_LINE_NM: f64 = 0.05;
/// A spike may be this far from the line it is named after on data of 1-2 nm.
const REACH_FINE_NM: f64 = 1.0;
/// The same on 5 nm data, where a line's centroid is drawn to the samples.
const REACH_COARSE_NM: f64 = 3.0;
/// Data is coarse from this step on.
const COARSE_STEP_NM: f64 = 4.0;
/// Share that makes a line worth looking for as a witness.
const WITNESS: f64 = 0.005;
/// Two principal lines of one element closer than this arrive as one spike between them.
const BLEND_NM: f64 = 4.0;
/// Share of the light's power above which a spike needs no witness: a one-line lamp.
const ALONE: f64 = 0.5;
/// Hover names lines within this distance.
const NEAR_NM: f64 = 2.0;

/// A place where an element's line, or two of them blended, would be seen.
struct Place<'a> {
    element: &'a str,
    at_nm: f64,
    label: String,
    /// Strength as a share of the element's strongest.
    relative: f64,
    /// One of the lines that may be printed.
    principal: bool,
    /// Two lines seen as one.
    blend: bool,
}

/// Names for spikes, in their order.
///
/// `step_nm` is the data's own step, `power` the light's total power in the spikes' unit.
pub fn name_spikes(
    spikes: &[Spike],
    step_nm: f64,
    power: f64,
    lines: &[ElementLine],
) -> Vec<LineName> {
    let reach = if step_nm >= COARSE_STEP_NM {
        REACH_COARSE_NM
    } else {
        REACH_FINE_NM
    };
    let places = places(lines);
    let hit = |place: &Place<'_>, spike: &Spike| (place.at_nm - spike.at_nm).abs() <= reach;
    spikes
        .iter()
        .enumerate()
        .map(|(index, spike)| {
            if spike.weight < 0.0 {
                return LineName::default();
            }
            let safe = places
                .iter()
                .filter(|p| p.principal && hit(p, spike))
                .filter(|p| {
                    let witnessed = spikes.iter().enumerate().any(|(other, s)| {
                        other != index
                            && s.weight > 0.0
                            && places.iter().any(|w| {
                                w.element == p.element
                                    && w.relative >= WITNESS
                                    && (w.at_nm - p.at_nm).abs() > BLEND_NM
                                    && hit(w, s)
                            })
                    });
                    witnessed || spike.weight > ALONE * power
                })
                .min_by(|a, b| {
                    // A spike within reach of a blended pair stands for the pair.
                    let rank = |p: &Place<'_>| (!p.blend, (p.at_nm - spike.at_nm).abs());
                    let (a, b) = (rank(a), rank(b));
                    a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
                })
                .map(|p| format!("{} {}", p.element, p.label));
            LineName {
                near: near(spike, lines),
                safe,
            }
        })
        .collect()
}

/// The nearest tabulated line to a place within 2 nm: "Hg 435.8".
pub fn nearest_line(at_nm: f64, lines: &[ElementLine]) -> Option<String> {
    lines
        .iter()
        .map(|l| ((l.at_nm - at_nm).abs(), l))
        .filter(|(distance, _)| *distance <= NEAR_NM)
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, l)| format!("{} {:.1}", l.element, l.at_nm))
}

fn near(spike: &Spike, lines: &[ElementLine]) -> Option<String> {
    nearest_line(spike.at_nm, lines).map(|name| format!("near {name}"))
}

fn places(lines: &[ElementLine]) -> Vec<Place<'_>> {
    let mut places = Vec::new();
    for (element, principal) in PRINCIPAL {
        let is_principal = |line: &ElementLine| {
            principal
                .iter()
                .any(|nm| (nm - line.at_nm).abs() <= SAME_LINE_NM)
        };
        let of_element: Vec<&ElementLine> = lines.iter().filter(|l| l.element == element).collect();
        let strongest = of_element.iter().fold(0.0_f64, |m, l| m.max(l.strength));
        if strongest <= 0.0 {
            continue;
        }
        for line in &of_element {
            places.push(Place {
                element,
                at_nm: line.at_nm,
                label: format!("{:.1}", line.at_nm),
                relative: line.strength / strongest,
                principal: is_principal(line),
                blend: false,
            });
        }
        for pair in of_element.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let both_principal = is_principal(a) && is_principal(b);
            // A pair of very unequal lines stays where the stronger one is.
            let alike = a.strength.min(b.strength) >= 0.3 * a.strength.max(b.strength);
            if b.at_nm - a.at_nm < BLEND_NM && both_principal && alike {
                let sum = a.strength + b.strength;
                places.push(Place {
                    element,
                    at_nm: (a.at_nm * a.strength + b.at_nm * b.strength) / sum,
                    label: format!("{:.0}/{:.0}", a.at_nm, b.at_nm),
                    relative: a.strength.max(b.strength) / strongest,
                    principal: true,
                    blend: true,
                });
            }
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Vec<ElementLine> {
        [
            ("Hg", 404.656, 12000.0),
            ("Hg", 435.833, 12000.0),
            ("Hg", 546.075, 6000.0),
            ("Hg", 576.961, 1000.0),
            ("Hg", 579.067, 900.0),
            ("Na", 588.995, 80000.0),
            ("Na", 589.5924, 40000.0),
            ("Xe", 611.2, 100.0),
        ]
        .map(|(element, at_nm, strength)| ElementLine {
            element: element.to_owned(),
            at_nm,
            strength,
        })
        .to_vec()
    }

    fn spikes(places: &[f64]) -> Vec<Spike> {
        places
            .iter()
            .map(|at_nm| Spike {
                at_nm: *at_nm,
                weight: 1.0,
            })
            .collect()
    }

    #[test]
    fn mercury_is_named_when_two_of_its_lines_are_there() {
        let names = name_spikes(&spikes(&[404.9, 435.8, 578.0]), 1.0, 100.0, &table());
        let safe: Vec<_> = names.iter().map(|n| n.safe.as_deref()).collect();
        assert_eq!(
            safe,
            [Some("Hg 404.7"), Some("Hg 435.8"), Some("Hg 577/579")]
        );
    }

    #[test]
    fn a_lone_coincidence_is_not_named_but_told_on_hover() {
        let names = name_spikes(&spikes(&[435.9, 611.0]), 1.0, 100.0, &table());
        assert_eq!(names[0].safe, None);
        assert_eq!(names[0].near.as_deref(), Some("near Hg 435.8"));
        assert_eq!(names[1].near.as_deref(), Some("near Xe 611.2"));
    }

    #[test]
    fn a_phosphor_line_is_not_taken_for_a_strong_red_line_of_the_table() {
        let mut lines = table();
        lines.push(ElementLine {
            element: "Hg".to_owned(),
            at_nm: 709.186,
            strength: 12000.0,
        });
        let names = name_spikes(&spikes(&[404.7, 435.8, 709.6]), 1.0, 100.0, &lines);
        assert_eq!(names[0].safe.as_deref(), Some("Hg 404.7"));
        assert_eq!(names[2].safe, None);
        assert_eq!(names[2].near.as_deref(), Some("near Hg 709.2"));
    }

    #[test]
    fn a_dip_is_neither_named_after_a_lamp_nor_a_witness_of_one() {
        let mut dipped = spikes(&[404.9, 435.8]);
        dipped[0].weight = -1.0;
        let names = name_spikes(&dipped, 1.0, 100.0, &table());
        assert_eq!(names[0], LineName::default());
        assert_eq!(names[1].safe, None);
    }

    #[test]
    fn a_lamp_of_one_line_needs_no_witness() {
        let names = name_spikes(&spikes(&[589.1]), 1.0, 1.5, &table());
        assert_eq!(names[0].safe.as_deref(), Some("Na 589/590"));
    }

    #[test]
    fn coarse_data_may_stand_three_nanometres_off() {
        let names = name_spikes(&spikes(&[407.0, 438.0]), 5.0, 100.0, &table());
        assert_eq!(names[0].safe.as_deref(), Some("Hg 404.7"));
        let fine = name_spikes(&spikes(&[407.0, 438.0]), 1.0, 100.0, &table());
        assert_eq!(fine[0].safe, None);
    }
}
