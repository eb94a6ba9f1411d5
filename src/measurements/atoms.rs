//! Atomic lines without width: by which the slit and the axis of an instrument are told.
//!
//! Wavelengths in standard air, nm, as in the NIST Atomic Spectra Database. Lines of phosphors and of
//! metals under pressure have a width of their own and are left out, as are pairs that no ordinary
//! spectrometer parts.

/// Greatest distance of a line from its place, nm, for an axis that is off by up to 1 nm.
const REACH_NM: f64 = 1.5;

/// The lines of one element, and how many of them must be seen at least.
struct Atom {
    symbol: &'static str,
    least: usize,
    nm: &'static [f64],
}

const ATOMS: [Atom; 7] = [
    Atom {
        symbol: "Hg",
        least: 2,
        nm: &[365.015, 404.656, 435.833, 546.074],
    },
    Atom {
        symbol: "H",
        least: 2,
        nm: &[486.133, 656.279],
    },
    Atom {
        symbol: "He",
        least: 3,
        nm: &[
            388.865, 447.148, 501.568, 587.562, 667.815, 706.519, 728.135,
        ],
    },
    Atom {
        symbol: "Cd",
        least: 3,
        nm: &[467.815, 479.991, 508.582, 643.847],
    },
    Atom {
        symbol: "Ne",
        least: 4,
        nm: &[
            585.249, 594.483, 614.306, 640.225, 667.828, 692.947, 703.241, 717.394, 724.517,
            743.890,
        ],
    },
    Atom {
        symbol: "Ar",
        least: 4,
        nm: &[
            696.543, 706.722, 738.398, 763.511, 772.4, 794.818, 811.531, 826.452, 842.465, 912.297,
        ],
    },
    Atom {
        symbol: "Kr",
        least: 3,
        nm: &[
            557.029, 587.092, 760.155, 769.454, 785.482, 819.006, 877.675,
        ],
    },
];

/// A line of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Named {
    pub symbol: &'static str,
    /// Its place, nm.
    pub nm: f64,
    /// Index of the peak that it is.
    pub peak: usize,
}

/// Which of some places are lines of an element that is there: one of which enough lines, and at
/// least half of those in the range, are seen.
pub(super) fn named(places_nm: &[f64], range_nm: [f64; 2]) -> Vec<Named> {
    let mut found = Vec::new();
    for atom in &ATOMS {
        let inside = atom.nm.iter().copied();
        let inside: Vec<f64> = inside
            .filter(|nm| (range_nm[0]..=range_nm[1]).contains(nm))
            .collect();
        let nearest = |nm: f64| {
            let all = places_nm.iter().enumerate();
            let near = all.filter(|(_, at)| (*at - nm).abs() <= REACH_NM);
            near.min_by(|a, b| (a.1 - nm).abs().total_cmp(&(b.1 - nm).abs()))
        };
        let seen: Vec<Named> = inside
            .iter()
            .filter_map(|nm| {
                Some(Named {
                    symbol: atom.symbol,
                    nm: *nm,
                    peak: nearest(*nm)?.0,
                })
            })
            .collect();
        if seen.len() >= atom.least && 2 * seen.len() >= inside.len() {
            found.extend(seen);
        }
    }
    // A peak is the line of one element.
    found.sort_by(|a, b| a.nm.total_cmp(&b.nm));
    found.dedup_by_key(|line| line.peak);
    found
}
