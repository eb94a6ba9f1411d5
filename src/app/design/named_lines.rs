//! Lines to put channels on: the strongest of the usual tubes, and common lasers.

use crate::app::line_names::ElementLine;

/// Elements of usual tubes.
const ELEMENTS: [&str; 9] = ["Hg", "Na", "H", "He", "Ne", "Ar", "Kr", "Xe", "Cd"];

/// Lines of each.
const EACH: usize = 6;

/// Two lines of one element nearer than this are one, nm.
const APART_NM: f64 = 0.7;

/// Where lines are looked for: what is well seen, nm.
const SEEN_NM: std::ops::RangeInclusive<f64> = 400.0..=710.0;

/// Common lasers, nm in air.
const LASERS: [(&str, f64); 11] = [
    (later!("laser InGaN"), 405.0),
    (later!("laser He-Cd"), 441.6),
    (later!("laser InGaN"), 450.0),
    (later!("laser Ar+"), 488.0),
    (later!("laser Ar+"), 514.5),
    (later!("laser Nd:YAG, doubled"), 532.0),
    (later!("laser He-Ne"), 543.5),
    (later!("laser He-Ne"), 594.1),
    (later!("laser He-Ne"), 632.8),
    (later!("laser AlGaInP"), 650.0),
    (later!("laser ruby"), 694.3),
];

/// A line with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedLine {
    /// What shines there: an element or a laser.
    pub of: &'static str,
    /// Its place.
    pub at_nm: f64,
}

/// The named lines, element by element, each by place; the lasers last.
pub fn named_lines(lines: &[ElementLine]) -> Vec<NamedLine> {
    let mut all = Vec::new();
    for of in ELEMENTS {
        let mut own: Vec<&ElementLine> = lines
            .iter()
            .filter(|line| line.element == of && SEEN_NM.contains(&line.at_nm))
            .collect();
        own.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        let mut places: Vec<f64> = Vec::new();
        for line in own {
            let is_new = places.iter().all(|nm| (nm - line.at_nm).abs() > APART_NM);
            if is_new && places.len() < EACH {
                places.push(line.at_nm);
            }
        }
        places.sort_by(f64::total_cmp);
        all.extend(places.into_iter().map(|at_nm| NamedLine { of, at_nm }));
    }
    all.extend(LASERS.map(|(of, at_nm)| NamedLine { of, at_nm }));
    all
}

/// The named line that a place snaps to, within `reach_nm`.
pub fn snapped(lines: &[NamedLine], at_nm: f64, reach_nm: f64) -> Option<&NamedLine> {
    let distance = |line: &NamedLine| (line.at_nm - at_nm).abs();
    let nearest = lines
        .iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.filter(|line| distance(line) <= reach_nm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::App;

    #[test]
    fn the_well_known_lines_are_there_and_are_snapped_to() {
        let lines = named_lines(App::new().element_lines());
        for (of, nm) in [("Hg", 546.1), ("Hg", 435.8), ("Na", 589.0), ("Ne", 640.2)] {
            let is_it = |line: &&NamedLine| line.of == of && (line.at_nm - nm).abs() < 0.7;
            assert!(lines.iter().any(|line| is_it(&line)), "{of} {nm}");
        }
        assert_eq!(snapped(&lines, 546.3, 1.0).map(|line| line.of), Some("Hg"));
        assert_eq!(snapped(&lines, 470.0, 0.1), None);
    }
}
