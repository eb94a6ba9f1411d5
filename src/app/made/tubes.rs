//! Line tubes and lasers: composites without a smooth part, from the table of atomic lines.
//!
//! A tube's strengths are those of the table, each a share of all lines within the visible, and
//! that is what they are: relative, qualitative, and not those of any one tube. Current, pressure
//! and mixture of a discharge decide which lines are strong. Neon's in the table are on several
//! scales (its lines at 454 to 540 nm and beyond 692 nm would outshine the red ones), so the neon
//! tube has those of its ten 2p levels by radiative rates at one excitation temperature: power of a
//! line ~ g A exp(-E/kT) / wavelength (statistical weight g of the upper level, rate A, energy E).

use super::{empty, preset};
use crate::{
    preset::{self, Body, Composite, Group, LineList, PrintedSpike},
    spectrum::{Band, Kind},
};

/// Ids of the groups.
pub(super) const TUBES: &str = "line_tubes";
pub(super) const LASERS: &str = "laser_lines";
/// The group that the lines are in.
const LINES: &str = "atomic_lines";

/// Elements and names of their tubes.
const NAMES: [(&str, &str); 9] = [
    ("H", "Hydrogen tube"),
    ("He", "Helium tube"),
    ("Ne", "Neon tube"),
    ("Na", "Sodium tube"),
    ("Hg", "Mercury tube"),
    ("Cd", "Cadmium tube"),
    ("Ar", "Argon tube"),
    ("Kr", "Krypton tube"),
    ("Xe", "Xenon tube"),
];

/// A tube's whole power, relative: weights are per cent of it.
const POWER: f64 = 100.0;

/// A line of neon with its upper level.
struct Rate {
    at_nm: f64,
    /// Statistical weight of the upper level.
    weight: f64,
    /// Rate of the transition, 1e8 a second.
    rate: f64,
    /// Energy of the upper level, eV.
    energy_ev: f64,
}

const fn rate(at_nm: f64, weight: f64, rate: f64, energy_ev: f64) -> Rate {
    Rate {
        at_nm,
        weight,
        rate,
        energy_ev,
    }
}

/// Neon's lines of the ten levels 2p (Paschen), NIST Atomic Spectra Database, places in air.
const NEON: [Rate; 29] = [
    rate(540.056, 1.0, 0.0090, 18.9660),
    rate(585.249, 1.0, 0.682, 18.9660),
    rate(588.190, 3.0, 0.115, 18.7264),
    rate(594.483, 5.0, 0.113, 18.7041),
    rate(597.553, 3.0, 0.0351, 18.6934),
    rate(603.000, 3.0, 0.0561, 18.7264),
    rate(607.434, 1.0, 0.603, 18.7114),
    rate(609.616, 5.0, 0.181, 18.7041),
    rate(612.845, 3.0, 0.0067, 18.6934),
    rate(614.306, 5.0, 0.282, 18.6368),
    rate(616.359, 3.0, 0.146, 18.7264),
    rate(621.728, 3.0, 0.0637, 18.6129),
    rate(626.650, 3.0, 0.249, 18.6934),
    rate(630.479, 5.0, 0.0416, 18.6368),
    rate(633.443, 5.0, 0.161, 18.5758),
    rate(638.299, 3.0, 0.321, 18.6129),
    rate(640.225, 7.0, 0.514, 18.5551),
    rate(650.653, 5.0, 0.300, 18.5758),
    rate(653.288, 3.0, 0.108, 18.6129),
    rate(659.895, 3.0, 0.232, 18.7264),
    rate(665.209, 1.0, 0.0029, 18.7114),
    rate(667.828, 5.0, 0.233, 18.7041),
    rate(671.704, 3.0, 0.217, 18.6934),
    rate(692.947, 5.0, 0.174, 18.6368),
    rate(702.405, 3.0, 0.0189, 18.6129),
    rate(703.241, 3.0, 0.253, 18.3816),
    rate(717.394, 5.0, 0.0287, 18.5758),
    rate(724.517, 3.0, 0.0935, 18.3816),
    rate(743.890, 3.0, 0.0231, 18.3816),
];
/// The excitation temperature of a glow discharge in neon, about, eV.
const NEON_EV: f64 = 1.0;

/// Lasers whose line is in the table of neon, and one that is none of an atom in a tube: the
/// second harmonic of the 1064.1 nm of neodymium in YAG.
const HELIUM_NEON_NM: f64 = 632.8;
const GREEN_NM: f64 = 532.1;

/// The tubes and the lasers, from the shipped lists of lines.
pub(super) fn groups() -> Vec<Group> {
    let Some(lines) = preset::group(LINES) else {
        return Vec::new();
    };
    let like = |id: &str, title: &str| Group {
        licence: lines.licence.clone(),
        attribution: lines.attribution.clone(),
        changes: "Places and relative strengths of lines, made into composites without a smooth \
                  part; the strengths of neon computed from radiative rates."
            .to_owned(),
        ..empty(id, title, lines.shelf, Kind::Light, &lines.source)
    };
    let list = |element: &str| {
        let mut lists = lines.items.iter().filter_map(|item| item.line_list());
        lists.find(|list| list.element.as_deref() == Some(element))
    };
    let mut tubes = like(TUBES, "Line tubes, made from the atomic lines");
    let made = NAMES.iter().filter_map(|(element, name)| {
        let strengths = strengths(element, list(element)?);
        let body = Body::Composite(composite(&strengths));
        Some(preset(&tubes, name, UNIT, notes(element), body))
    });
    tubes.items = made.collect();
    let mut lasers = like(LASERS, "Lasers, one line each");
    let red = list("Ne").and_then(|neon| {
        let near = |line: &&crate::preset::AtomicLine| (line.at_nm - HELIUM_NEON_NM).abs() < 0.05;
        neon.lines.iter().find(near).map(|line| line.at_nm)
    });
    let all = [
        ("Helium-neon laser", red),
        ("Green laser pointer", Some(GREEN_NM)),
        ("Blue argon laser", Some(487.99)),
    ];
    let made = all.into_iter().filter_map(|(name, at_nm)| {
        let notes = vec!["Made by this program: one line and nothing else.".to_owned()];
        let body = Body::Composite(composite(&[(at_nm?, 1.0)]));
        Some(preset(&lasers, name, UNIT, notes, body))
    });
    lasers.items = made.collect();
    vec![tubes, lasers]
}

const UNIT: &str = "relative (weights in % of the power)";

/// Places and strengths of a tube's lines.
fn strengths(element: &str, list: &LineList) -> Vec<(f64, f64)> {
    if element == "Ne" {
        let power =
            |line: &Rate| line.weight * line.rate * (-line.energy_ev / NEON_EV).exp() / line.at_nm;
        return NEON.iter().map(|line| (line.at_nm, power(line))).collect();
    }
    let known = list.lines.iter();
    known
        .filter_map(|line| Some((line.at_nm, line.strength.filter(|s| *s > 0.0)?)))
        .collect()
}

/// Lines over the visible as spikes, their weights per cent of all.
fn composite(strengths: &[(f64, f64)]) -> Composite {
    let band = Band::VISIBLE;
    let inside: Vec<&(f64, f64)> = strengths
        .iter()
        .filter(|(nm, _)| band.contains(*nm))
        .collect();
    let sum: f64 = inside.iter().map(|(_, strength)| strength).sum();
    Composite {
        range_nm: [band.min_nm(), band.max_nm()],
        a: vec![0.0],
        b: Vec::new(),
        spikes: inside
            .iter()
            .map(|(at_nm, strength)| PrintedSpike {
                at_nm: *at_nm,
                weight: POWER * strength / sum,
            })
            .collect(),
        weight_factor: 1.0,
    }
}

fn notes(element: &str) -> Vec<String> {
    let mut notes = vec![
        "Made by this program: lines of the neutral atom and nothing else.".to_owned(),
        "The strengths are relative and depend on the excitation: current, pressure and mixture \
         of a real tube decide which lines are strong."
            .to_owned(),
    ];
    notes.push(if element == "Ne" {
        format!(
            "Strengths by radiative rates (NIST ASD) of levels at one excitation temperature, \
             {NEON_EV} eV: the table's own are on several scales."
        )
    } else {
        "Strengths of the NIST tables, which are qualitative; lines of unknown strength are left \
         out."
            .to_owned()
    });
    notes
}
