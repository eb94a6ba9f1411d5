//! What the race gave on a larger collection of lights, to set beside the shipped ones.
//!
//! The figures are data: they were computed in another program and another language, over 380 to
//! 780 nm for the CIE 1931 observer and the 24 patches of the ColorChecker.

use super::{
    measure::Measure,
    race::{Race, Racer},
    way::FitVariant,
};
use crate::{rivals::Family, spectrum::Basis};

/// Where the figures come from.
pub const ORIGIN: &str = "A larger collection that may not be shipped: 35 smooth, 221 LED, 79 \
    fluorescent and 30 discharge lights, computed independently in Python over 380-780 nm (CIE \
    1931, ColorChecker).";

/// A class of lights at a count of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The class.
    pub class: &'static str,
    /// Numbers.
    pub numbers: usize,
    /// Lights of that class in the larger collection.
    pub lamps: usize,
}

const fn column(class: &'static str, numbers: usize, lamps: usize) -> Column {
    Column {
        class,
        numbers,
        lamps,
    }
}

/// The columns of [`TABLE`].
pub const COLUMNS: [Column; 7] = [
    column("smooth", 11, 35),
    column("smooth", 20, 35),
    column("LED", 20, 221),
    column("fluorescent", 11, 79),
    column("fluorescent", 20, 79),
    column("fluorescent", 31, 79),
    column("discharge", 20, 30),
];

/// Mean CIEDE2000 of the patches over a class; the worst is known of discharge lamps only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Median over the lights.
    pub median: f64,
    /// 95th percentile.
    pub p95: f64,
    /// The worst light.
    pub worst: Option<f64>,
}

/// One representation's figures, in the order of [`COLUMNS`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Who.
    pub racer: Racer,
    /// Its figures.
    pub figures: [Figure; 7],
}

const fn composite(basis: Basis, spikes: bool, colour_exact: bool) -> Racer {
    Racer::Composite(FitVariant::new(basis, spikes, colour_exact))
}

/// A line from its medians and 95th percentiles, and the worst discharge lamp.
const fn line(racer: Racer, medians: [f64; 7], p95s: [f64; 7], worst: f64) -> Line {
    let mut figures = [Figure {
        median: 0.0,
        p95: 0.0,
        worst: None,
    }; 7];
    let mut i = 0;
    while i < 7 {
        figures[i].median = medians[i];
        figures[i].p95 = p95s[i];
        i += 1;
    }
    figures[6].worst = Some(worst);
    Line { racer, figures }
}

/// The larger collection's table.
pub const TABLE: [Line; 11] = [
    line(
        composite(Basis::Fourier, false, false),
        [0.71, 0.12, 0.17, 0.63, 0.62, 0.19, 0.19],
        [1.9, 0.51, 0.43, 2.5, 0.99, 0.35, 1.4],
        29.0,
    ),
    line(
        composite(Basis::Fourier, true, false),
        [0.71, 0.12, 0.17, 1.7, 0.40, 0.29, 0.21],
        [1.9, 0.51, 0.43, 4.9, 1.1, 0.46, 1.1],
        1.2,
    ),
    line(
        composite(Basis::Cosine, false, false),
        [0.25, 0.008, 0.09, 0.50, 0.40, 0.026, 0.12],
        [0.54, 0.018, 0.18, 2.1, 0.68, 0.062, 1.1],
        19.0,
    ),
    line(
        composite(Basis::Cosine, true, false),
        [0.25, 0.008, 0.09, 1.6, 0.15, 0.042, 0.14],
        [0.54, 0.018, 0.18, 9.0, 0.43, 0.11, 0.71],
        0.9,
    ),
    line(
        composite(Basis::Cosine, false, true),
        [0.064, 0.0026, 0.031, 0.36, 0.067, 0.019, 0.07],
        [0.097, 0.0076, 0.089, 0.73, 0.14, 0.028, 0.27],
        17.0,
    ),
    line(
        composite(Basis::Cosine, true, true),
        [0.064, 0.0026, 0.031, 0.77, 0.13, 0.023, 0.08],
        [0.097, 0.0076, 0.089, 1.2, 0.24, 0.058, 0.38],
        1.9,
    ),
    line(
        Racer::Rival(Family::Moments),
        [0.39, 0.013, 0.10, 0.69, 0.38, 0.043, 0.14],
        [0.62, 0.028, 0.20, 1.2, 0.54, 0.070, 0.63],
        12.0,
    ),
    line(
        Racer::Rival(Family::Principal),
        [0.22, 0.019, 0.10, 1.5, 0.15, 0.09, 0.74],
        [0.50, 0.039, 0.43, 3.4, 0.43, 0.16, 5.3],
        29.0,
    ),
    line(
        Racer::Rival(Family::Legendre),
        [0.38, 0.013, 0.13, 1.8, 0.44, 0.06, 0.33],
        [0.43, 0.024, 0.71, 3.0, 0.94, 0.17, 0.92],
        23.0,
    ),
    line(
        Racer::Rival(Family::Bins),
        [0.97, 0.29, 0.78, 2.7, 1.8, 0.56, 0.86],
        [1.5, 0.41, 1.3, 3.8, 2.6, 1.0, 3.8],
        4.2,
    ),
    line(
        Racer::Rival(Family::Samples),
        [1.1, 0.33, 1.6, 12.0, 9.8, 7.2, 7.2],
        [1.4, 0.42, 5.8, 27.0, 16.0, 12.0, 25.0],
        28.0,
    ),
];

/// Median, 95th percentile and worst at 20 numbers on reflectances that took no part in the
/// choice, for the composite chosen per light and the two best peers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checked {
    /// The class.
    pub class: &'static str,
    /// The composite chosen per light on the patches.
    pub chosen: [f64; 3],
    /// Maximum-entropy moments.
    pub moments: [f64; 3],
    /// Principal components.
    pub principal: [f64; 3],
}

/// Numbers that [`CHECKED`] and [`OTHER_HALF`] are for.
pub(crate) const CHECKED_NUMBERS: usize = 20;

/// The half that the composite wins.
pub(crate) const CHECKED: [Checked; 4] = [
    Checked {
        class: "smooth",
        chosen: [0.0023, 0.0060, 0.0069],
        moments: [0.0104, 0.024, 0.053],
        principal: [0.029, 0.052, 0.12],
    },
    Checked {
        class: "LED",
        chosen: [0.026, 0.083, 0.11],
        moments: [0.087, 0.20, 0.31],
        principal: [0.11, 0.37, 0.90],
    },
    Checked {
        class: "fluorescent",
        chosen: [0.083, 0.17, 0.18],
        moments: [0.35, 0.48, 0.52],
        principal: [0.20, 0.46, 1.5],
    },
    Checked {
        class: "discharge",
        chosen: [0.057, 0.24, 0.91],
        moments: [0.14, 0.49, 12.0],
        principal: [0.77, 5.3, 30.0],
    },
];

/// The half that it does not win, on fluorescent lights: behind narrow filters (median, 95th
/// percentile, worst) and the 10 nm-blurred relative RMS (median, 95th percentile).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Otherwise {
    /// Who.
    pub racer: Racer,
    /// Mean CIEDE2000 behind narrow filters.
    pub filters: [f64; 3],
    /// Relative RMS behind a 10 nm blur.
    pub rms_blurred: [f64; 2],
}

/// Fluorescent lights at [`CHECKED_NUMBERS`].
pub(crate) const OTHER_HALF: [Otherwise; 3] = [
    Otherwise {
        racer: Racer::Chosen,
        filters: [1.3, 8.3, 12.0],
        rms_blurred: [0.078, 0.26],
    },
    Otherwise {
        racer: Racer::Rival(Family::Principal),
        filters: [0.37, 1.2, 8.7],
        rms_blurred: [0.015, 0.052],
    },
    Otherwise {
        racer: Racer::Rival(Family::Moments),
        filters: [3.0, 5.1, 8.4],
        rms_blurred: [0.18, 0.22],
    },
];

/// Medians that differ by more than this factor are explained.
pub const NOTABLE: f64 = 1.5;

/// One cell of the comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// Class and count.
    pub column: Column,
    /// The larger collection.
    pub theirs: Figure,
    /// This race.
    pub ours: Figure,
}

impl Beside {
    /// This race's median over the larger collection's.
    pub fn factor(&self) -> f64 {
        self.ours.median / self.theirs.median
    }

    /// Whether the medians differ by more than [`NOTABLE`].
    pub fn differs(&self) -> bool {
        let factor = self.factor();
        !(1.0 / NOTABLE..=NOTABLE).contains(&factor)
    }
}

impl Line {
    /// This line beside a race; `None` where the race has no such class or count.
    pub fn beside(&self, race: &Race) -> [Option<Beside>; 7] {
        let racer = race.racers.iter().position(|r| *r == self.racer);
        std::array::from_fn(|i| {
            let column = COLUMNS[i];
            let budget = race.budgets.iter().position(|n| *n == column.numbers)?;
            let ours = race.spread(Some(column.class), budget, racer?, Measure::Patches)?;
            Some(Beside {
                column,
                theirs: self.figures[i],
                ours: Figure {
                    median: ours.median,
                    p95: ours.p95,
                    worst: Some(ours.worst),
                },
            })
        })
    }

    /// The difference in words: where the medians are apart, by how much, and why.
    pub fn explained(&self, cells: &[Option<Beside>; 7]) -> String {
        let known = || cells.iter().flatten();
        let apart: Vec<&Beside> = known().filter(|cell| cell.differs()).collect();
        if known().next().is_none() {
            return "None of these classes and counts raced.".to_owned();
        }
        if apart.is_empty() {
            let most = known()
                .map(|cell| cell.factor().max(1.0 / cell.factor()))
                .fold(1.0, f64::max);
            return format!("All medians lie within a factor of {most:.2} of one another.");
        }
        let places: Vec<String> = apart
            .iter()
            .map(|cell| {
                let (class, numbers) = (cell.column.class, cell.column.numbers);
                format!("{class} at {numbers} (×{:.2})", cell.factor())
            })
            .collect();
        let mut words = format!("Apart: {}.", places.join(", "));
        let mut told: Vec<&str> = Vec::new();
        for cell in apart {
            let reason = reason(self.racer, cell.column.class, cell.factor() > 1.0);
            if !told.contains(&reason) {
                words.push(' ');
                words.push_str(reason);
                told.push(reason);
            }
        }
        words
    }
}

/// Why a median differs, as experiments on the shipped lights showed.
fn reason(racer: Racer, class: &str, higher: bool) -> &'static str {
    match (racer, class, higher) {
        (Racer::Rival(Family::Principal), "smooth", true) => {
            "A table has no more components than lights that taught it, and the shipped smooth \
             lights are 17, of few kinds: their own table has as few as 11. With 20 blackbodies as further \
             teachers the medians of all 17 fall from 0.57 to 0.12 at 11 numbers and from 0.56 to 0.011 at \
             20."
        }
        (Racer::Rival(Family::Principal), "LED", true) => {
            "The 34 shipped tables are 25 lamps (nine stand in a 5 nm and a 1 nm table), against \
             221 teachers. It is the teachers that lack: with half of the 25 the median at 20 \
             numbers rises from 0.48 to 2.1."
        }
        (Racer::Rival(Family::Principal), "fluorescent", true) => {
            "The 77 shipped tables are 50 lamps (27 stand in a 5 nm and a 1 nm table), and a lamp \
             does not teach itself. With half of the 50 the median at 20 numbers rises from 0.31 \
             to 0.63."
        }
        (Racer::Rival(Family::Principal), "discharge", true) => {
            "18 shipped lamps teach, against 30. With half of them the median at 20 numbers rises from 1.8 to 3.6."
        }
        (Racer::Rival(Family::Legendre), "smooth", true) => {
            "Most shipped smooth lights are daylight and sun, whose curves bend: 20 blackbodies \
             from 2000 to 20000 K alone give 0.0125 at 20 numbers here."
        }
        (Racer::Composite(way), "smooth", true) if way.colour_exact => {
            "Most shipped smooth lights are daylight and sun, whose curves bend (CIE D65 0.0069): \
             20 blackbodies from 2000 to 20000 K alone give 0.0018 at 20 numbers here."
        }
        (_, "smooth", true) => {
            "Most shipped smooth lights are daylight and sun, whose curves bend (CIE D65 0.44): 20 \
             blackbodies from 2000 to 20000 K alone give 0.24 at 11 numbers here."
        }
        (Racer::Rival(Family::Legendre), "fluorescent", false) => {
            "54 of the 77 shipped tables are the 27 CIE lamps, each at 1 and 5 nm, and easier than \
             others: 1.0 at 11 numbers, against 1.4 on the other 23 and 1.8 on the six measured by \
             RIT, which give 0.079 at 31."
        }
        (_, "fluorescent", false) => {
            "54 of the 77 shipped tables are the 27 CIE lamps, each at 1 and 5 nm, and easier than \
             others: moments 0.43 at 11 numbers, against 0.49 on the other 23 and 0.61 on the six \
             measured by RIT."
        }
        _ => "The lights are others, and fewer.",
    }
}

/// Why 95th percentiles and worst cases of discharge lamps are larger here.
pub const OF_FEW: &str = "The 95th percentile of 18 discharge lamps lies between the two worst of \
    them, and at 20 numbers low-pressure sodium, all but one line, is the worst of every \
    representation without spikes except box bins.";
