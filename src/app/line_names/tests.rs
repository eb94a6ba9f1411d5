//! Which names lights get, lamp by lamp and under any knobs.

use super::*;
use crate::{
    app::library::Library,
    spectrum::{Line, Outside, Sampled},
};

/// Lines of a width on a glow, 350 to 800 nm.
fn lamp(lines: &[(f64, f64)], width_nm: f64, step_nm: f64, glow: f64) -> Sampled {
    let sigma = width_nm / 2.354_82;
    let count = (450.0 / step_nm) as usize + 1;
    let values = (0..count).map(|i| {
        let nm = 350.0 + step_nm * i as f64;
        let of =
            |(at, power): &(f64, f64)| power / sigma * (-0.5 * ((nm - at) / sigma).powi(2)).exp();
        glow + lines.iter().map(of).sum::<f64>()
    });
    Sampled::even(350.0, step_nm, values.collect()).expect("finite values")
}

fn identified(samples: &Sampled) -> Identified {
    Identified::of(samples, Outside::Zero, Library::bundled().lines())
}

fn elements(lines: &[(f64, f64)], width_nm: f64, step_nm: f64, glow: f64) -> Vec<&'static str> {
    identified(&lamp(lines, width_nm, step_nm, glow)).elements()
}

fn safe(found: &Identified, at_nm: f64) -> Option<String> {
    found.names_at(&[at_nm])[0].safe.clone()
}

/// Strengths of an element's lines as the table has them; neon's beyond 692 nm are on another
/// scale there.
fn strengths(element: &str) -> Vec<(f64, f64)> {
    let lines = Library::bundled().lines().iter();
    let lines = lines.filter(|line| line.element == element);
    let known = lines.filter(|line| line.strength > 0.0);
    let scale = |nm: f64| {
        if element == "Ne" && nm > 692.0 {
            0.05
        } else {
            1.0
        }
    };
    known
        .map(|line| (line.at_nm, line.strength * scale(line.at_nm)))
        .collect()
}

const MERCURY: [(f64, f64); 5] = [
    (404.656, 4.0),
    (435.833, 10.0),
    (546.075, 8.0),
    (576.961, 1.5),
    (579.067, 1.6),
];

#[test]
fn every_line_that_names_are_made_of_is_in_the_table() {
    let lines = Library::bundled().lines();
    let scene = scene::Scene::of(peaks::Points::default(), lines);
    let has = |element: &str, nm: f64| {
        let near = |l: &&ElementLine| l.element == element && (l.at_nm - nm).abs() <= 0.06;
        assert!(lines.iter().any(|l| near(&l)), "{element} {nm}");
    };
    for gas in &table::GASES {
        for nm in gas.strongest.iter().chain(gas.others) {
            has(gas.symbol, *nm);
        }
    }
    for nm in [table::HG_VIOLET, table::HG_BLUE, table::HG_GREEN] {
        has("Hg", nm);
    }
    for nm in table::HG_YELLOW.iter().chain(&table::HG_FAINT) {
        has("Hg", *nm);
    }
    let pairs = table::NA_OTHERS.iter().chain(&table::NA_FAINT);
    let pairs = pairs.chain([&table::NA_INFRARED, &table::NA_D]);
    for nm in pairs.flatten() {
        has("Na", *nm);
    }
    for (element, nm) in [
        ("K", table::K_RED[0]),
        ("K", table::K_RED[1]),
        ("Tl", table::TL_GREEN),
        ("Li", table::LI_RED),
        ("In", table::IN_BLUE),
        ("In", table::IN_VIOLET),
    ] {
        has(element, nm);
    }
    for nm in table::DY_STRONGEST.iter().chain(&table::DY_OTHERS) {
        has("Dy", *nm);
    }
    assert_eq!(scene.name_of("Hg", &table::HG_YELLOW).words, "Hg 577/579");
    assert_eq!(scene.name_of("Na", &table::NA_OTHERS[0]).words, "Na 568.5");
    assert_eq!(scene.name_of("Na", &table::NA_D).words, "Na 589.3");
    assert_eq!(scene.name_of("K", &table::K_RED).words, "K 766/770");
}

#[test]
fn mercury_is_named_when_its_lines_are_there_on_fine_and_on_coarse_data() {
    for (width, step) in [
        (0.5, 0.3),
        (1.0, 1.0),
        (2.0, 1.0),
        (5.0, 1.0),
        (10.0, 1.0),
        (6.0, 5.0),
    ] {
        let found = identified(&lamp(&MERCURY, width, step, 0.2));
        for (nm, name) in [
            (404.7, "Hg 404.7"),
            (435.8, "Hg 435.8"),
            (546.1, "Hg 546.1"),
            (578.2, "Hg 577/579"),
        ] {
            assert_eq!(
                safe(&found, nm).as_deref(),
                Some(name),
                "{width} nm, {step} nm"
            );
        }
        assert_eq!(found.elements(), ["Hg"]);
    }
}

#[test]
fn one_line_at_a_place_of_mercurys_is_no_mercury() {
    for step in [1.0_f64, 5.0] {
        let two = [(435.8, 1.0), (611.2, 2.0)];
        assert_eq!(elements(&two, step.max(2.0), step, 0.1), [""; 0], "{step}");
    }
    // Three lasers of a projector stand at no element's lines.
    let lasers = [(445.0, 1.0), (532.0, 1.0), (638.0, 1.0)];
    for (width, step) in [(1.0, 1.0), (5.0, 5.0)] {
        assert_eq!(elements(&lasers, width, step, 0.0), [""; 0], "{step}");
    }
}

#[test]
fn each_line_tube_is_named_after_its_own_gas_and_no_other() {
    for element in ["H", "He", "Ne", "Ar", "Kr", "Xe", "Cd", "Na", "Hg"] {
        for (width, step) in [(0.6, 0.25), (1.5, 1.0)] {
            let found = elements(&strengths(element), width, step, 0.0);
            assert_eq!(found, [element], "{width} nm, {step} nm");
        }
    }
}

#[test]
fn data_too_coarse_for_a_gas_gives_it_no_name_and_no_false_one() {
    for element in ["H", "He", "Ne", "Ar", "Kr", "Xe", "Cd"] {
        for (width, step) in [(5.0, 1.0), (5.0, 5.0), (10.0, 5.0), (12.0, 1.0)] {
            for name in elements(&strengths(element), width, step, 0.0) {
                assert_eq!(name, element, "{width} nm, {step} nm");
            }
        }
    }
}

#[test]
fn two_vapours_in_one_lamp_are_both_named() {
    let mut both = MERCURY.to_vec();
    both.extend(strengths("Cd").iter().map(|(nm, s)| (*nm, 0.004 * s)));
    let found = identified(&lamp(&both, 1.5, 1.0, 0.0));
    assert_eq!(safe(&found, 508.6).as_deref(), Some("Cd 508.6"));
    assert_eq!(safe(&found, 546.1).as_deref(), Some("Hg 546.1"));
    let mut elements = found.elements();
    elements.sort_unstable();
    assert_eq!(elements, ["Cd", "Hg"]);
}

#[test]
fn heliums_yellow_line_beside_mercury_is_no_helium() {
    let mut lines = MERCURY.to_vec();
    lines.extend([(587.6, 1.0), (501.6, 0.5)]);
    let found = identified(&lamp(&lines, 1.5, 1.0, 0.1));
    assert_eq!(found.elements(), ["Hg"]);
    assert_eq!(safe(&found, 587.6), None);
}

#[test]
fn a_lamp_of_one_yellow_line_is_sodium_and_a_yellow_diode_is_not() {
    let found = identified(&lamp(&[(589.2, 1.0)], 2.0, 1.0, 0.0));
    assert_eq!(safe(&found, 589.1).as_deref(), Some("Na D 589.3"));
    let diode = identified(&lamp(&[(589.2, 1.0)], 15.0, 1.0, 0.0));
    assert_eq!(safe(&diode, 589.1), None);
}

#[test]
fn a_spike_that_was_moved_away_from_its_line_loses_the_name() {
    let found = identified(&lamp(&MERCURY, 2.0, 1.0, 0.1));
    assert_eq!(safe(&found, 436.3).as_deref(), Some("Hg 435.8"));
    assert_eq!(safe(&found, 440.0), None);
    assert_eq!(safe(&found, 520.0), None);
}

#[test]
fn random_lines_are_hardly_ever_taken_for_an_element() {
    // The same every time (SplitMix64).
    let mut state = 7_u64;
    let mut chance = || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    };
    let lines = Library::bundled().lines();
    let mut named = [0; 2];
    const LAMPS: usize = 400;
    for lamps in 0..LAMPS {
        let count = 3 + lamps % 15;
        let all: Vec<(f64, f64)> = (0..count)
            .map(|_| (385.0 + 390.0 * chance(), 0.1 + chance()))
            .collect();
        for (which, (width, step)) in [(1.5, 1.0), (6.0, 5.0)].into_iter().enumerate() {
            let samples = lamp(&all, width, step, 0.05);
            let found = Identified::of(&samples, Outside::Zero, lines);
            named[which] += usize::from(!found.elements().is_empty());
        }
    }
    println!(
        "of {LAMPS} lamps of random lines named: fine {} coarse {}",
        named[0], named[1]
    );
    // Coarse data leaves more room for chance.
    assert!(named[0] <= LAMPS / 100, "{named:?}");
    assert!(named[1] <= LAMPS * 3 / 100, "{named:?}");
}

#[test]
fn the_pointer_names_the_spike_it_is_on_and_nothing_else() {
    let spikes = [435.8, 546.1].map(|at_nm| Line::ideal(at_nm, 1.0));
    let found = identified(&lamp(&MERCURY, 2.0, 1.0, 0.1));
    let names = found.names_at(&spikes.map(|spike| spike.at_nm));
    let (spike, name) = spike_under(&spikes, &names, 547.0, 2.0).expect("a spike");
    assert_eq!(
        (spike.at_nm, name.safe.as_deref()),
        (546.1, Some("Hg 546.1"))
    );
    assert_eq!(spike_under(&spikes, &names, 497.0, 2.0), None);
}
