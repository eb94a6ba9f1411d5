//! The image on the screen behind a prism: a smooth band and one line per spike.
//!
//! The smooth part goes onto the screen in cells of wavelength, each a box of the cell's extent
//! blurred by the slit's image, so that its energy is kept whatever the columns. A spike is its own
//! image of the slit and never touches the smooth part's columns.

use super::{
    bench::{Bench, Spot},
    light::{GAUSS, Light, SEEN_NM, pieces},
    screen::{Columns, Deposit},
};
use crate::{
    color::{Observer, Xyz},
    languages::fixed,
    spectrum::Line,
};

/// The part of the screen in view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// Left and right end, mm.
    pub ends_mm: [f64; 2],
    /// Columns between, at least 1.
    pub columns: usize,
}

/// A spike on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineImage {
    /// The spike.
    pub spike: Line,
    /// Middle of its image, mm.
    pub x_mm: f64,
    /// Width of its image, mm.
    pub width_mm: f64,
    /// Weight times transmittance, value x nm.
    pub energy: f64,
}

/// The image on a screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// The part that was looked at.
    pub screen: Screen,
    /// Energy of the smooth part in each column, value x nm.
    pub smooth: Vec<f64>,
    /// Energy of the spikes in each column, value x nm.
    pub lines: Vec<f64>,
    /// X, Y, Z of each column, all parts, value x nm.
    pub xyz: Vec<Xyz>,
    /// The spikes that leave the prism, by rising wavelength.
    pub images: Vec<LineImage>,
    /// Spikes that are totally reflected or have no index, nm.
    pub lost_spikes_nm: Vec<f64>,
    /// Energy that leaves the prism towards the screen's line, value x nm.
    pub energy: f64,
    /// Share of that energy that falls beside the screen.
    pub share_beside: f64,
    /// The totally reflected stretches of 380-780 nm, from and to, nm; rising.
    pub reflected_nm: Vec<[f64; 2]>,
    /// True if some of it rests on an index outside the range it was published for.
    pub extrapolated: bool,
}

/// Halvings of a cell at most.
const DEEPEST: u32 = 14;

/// Most columns.
pub const MOST_COLUMNS: usize = 1 << 16;

impl Bench {
    /// The screen that just holds all the light of 380-780 nm that leaves; `None` where none does.
    pub fn whole_screen(&self, light: &Light, columns: usize) -> Option<Screen> {
        let spots = pieces(SEEN_NM[0], SEEN_NM[1]).flatten();
        let spikes = light.seen_spikes().map(|s| s.at_nm);
        // Just beside total reflection the light runs along the face: it lands far out.
        let edges = self.reflected_nm().into_iter();
        let beside = edges.flat_map(|[from, to]| [from - 1e-3, to + 1e-3]);
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for nm in spots.chain(spikes).chain(beside) {
            if let Some(Spot { x, width, .. }) = self.spot(nm) {
                ends = [ends[0].min(x - 0.5 * width), ends[1].max(x + 0.5 * width)];
            }
        }
        let margin = 0.01 * (ends[1] - ends[0]);
        (ends[1] > ends[0]).then(|| Screen {
            ends_mm: [ends[0] - margin, ends[1] + margin],
            columns: columns.clamp(1, MOST_COLUMNS),
        })
    }

    /// The stretches of 380-780 nm that are totally reflected, from and to, nm; rising. Usually
    /// one from the blue end; where the index rises with wavelength any.
    pub(crate) fn reflected_nm(&self) -> Vec<[f64; 2]> {
        let whole: Vec<f64> = (380..=780).map(f64::from).collect();
        let runs = whole.chunk_by(|a, b| self.is_reflected(*a) == self.is_reflected(*b));
        let ends = |run: &[f64]| {
            let [from, to] = [run[0], run[run.len() - 1]];
            let is_first = from <= SEEN_NM[0];
            let is_last = to >= SEEN_NM[1];
            [
                if is_first {
                    from
                } else {
                    self.edge(from, from - 1.0)
                },
                if is_last { to } else { self.edge(to, to + 1.0) },
            ]
        };
        runs.filter(|run| self.is_reflected(run[0]))
            .map(ends)
            .collect()
    }

    /// The end of total reflection between a wavelength that is reflected and one that is not, nm;
    /// itself reflected.
    fn edge(&self, mut reflected: f64, mut passing: f64) -> f64 {
        for _ in 0..50 {
            let middle = 0.5 * (reflected + passing);
            if self.is_reflected(middle) {
                reflected = middle;
            } else {
                passing = middle;
            }
        }
        reflected
    }

    /// The end of what is totally reflected from the blue end on, nm.
    pub(crate) fn reflected_to_nm(&self) -> Option<f64> {
        let first = self.reflected_nm().into_iter().next()?;
        (first[0] <= SEEN_NM[0]).then_some(first[1])
    }

    /// The totally reflected wavelengths, in words.
    pub(crate) fn reflected_words(&self) -> Option<String> {
        let words = |[from, to]: &[f64; 2]| match (*from <= SEEN_NM[0], *to >= SEEN_NM[1]) {
            (true, _) => tr!("{to} nm and shorter", to = fixed(to, 1)),
            (false, true) => tr!("{from} nm and longer", from = fixed(from, 1)),
            (false, false) => tr!(
                "{from} to {to} nm",
                from = fixed(from, 1),
                to = fixed(to, 1)
            ),
        };
        let all: Vec<String> = self.reflected_nm().iter().map(words).collect();
        let all = all.join(said!(", and "));
        (!all.is_empty()).then(|| tr!("{ranges} are totally reflected", ranges = all))
    }

    /// Puts a light onto a screen. Columns beyond [`MOST_COLUMNS`] are left away.
    pub fn strip(&self, light: &Light, screen: Screen, observer: Observer) -> Strip {
        let screen = Screen {
            columns: screen.columns.clamp(1, MOST_COLUMNS),
            ..screen
        };
        let columns = Columns {
            from: screen.ends_mm[0],
            width: (screen.ends_mm[1] - screen.ends_mm[0]) / screen.columns as f64,
            count: screen.columns,
        };
        let reflected_nm = self.reflected_nm();
        let mut painter = Painter {
            bench: self,
            light,
            observer,
            deposit: Deposit::new(columns),
            smallest: 0.5 * columns.width,
            energy: 0.0,
        };
        let band = light.band();
        let starts = std::iter::once(SEEN_NM[0]).chain(reflected_nm.iter().map(|s| s[1]));
        let ends = reflected_nm.iter().map(|s| s[0]).chain([SEEN_NM[1]]);
        for (from, to) in starts.zip(ends) {
            for [a, b] in pieces(from.max(band.min_nm()), to.min(band.max_nm())) {
                painter.cell([a, b], [self.spot(a), self.spot(b)], 0);
            }
        }
        let mut energy = painter.energy;
        let smooth = painter.deposit.columns();
        let mut deposit = Deposit::new(columns);
        let (mut images, mut lost_spikes_nm) = (Vec::new(), Vec::new());
        for spike in light.seen_spikes() {
            let Some(spot) = self.spot(spike.at_nm) else {
                lost_spikes_nm.push(spike.at_nm);
                continue;
            };
            let own = spike.weight * spot.transmittance;
            let energies = with_xyz(own, observer.table().at(spike.at_nm));
            deposit.spread([spot.x; 2], spot.width, energies);
            energy += own;
            images.push(LineImage {
                spike,
                x_mm: spot.x,
                width_mm: spot.width,
                energy: own,
            });
        }
        let lines = deposit.columns();
        let both = smooth.iter().zip(&lines);
        let on_screen: f64 = both.clone().map(|(a, b)| a[0] + b[0]).sum();
        let xyz = both
            .map(|(a, b)| Xyz::new(a[1] + b[1], a[2] + b[2], a[3] + b[3]))
            .collect();
        let beside = 1.0 - on_screen / energy;
        Strip {
            screen,
            smooth: smooth.iter().map(|c| c[0]).collect(),
            lines: lines.iter().map(|c| c[0]).collect(),
            xyz,
            images,
            lost_spikes_nm,
            energy,
            share_beside: if beside.is_finite() {
                beside.clamp(0.0, 1.0)
            } else {
                0.0
            },
            reflected_nm,
            extrapolated: self.is_extrapolated(light),
        }
    }

    /// True if a light has power where the index is from a formula outside its published range.
    fn is_extrapolated(&self, light: &Light) -> bool {
        light.lit_nm().any(|nm| self.material().is_extrapolated(nm))
    }
}

fn with_xyz(energy: f64, [x, y, z]: [f64; 3]) -> [f64; 4] {
    [energy, energy * x, energy * y, energy * z]
}

/// The smooth part on its way to the columns.
struct Painter<'a> {
    bench: &'a Bench,
    light: &'a Light,
    observer: Observer,
    deposit: Deposit,
    /// A cell's extent goes below this.
    smallest: f64,
    energy: f64,
}

impl Painter<'_> {
    fn cell(&mut self, [a, b]: [f64; 2], ends: [Option<Spot>; 2], depth: u32) {
        let middle = 0.5 * (a + b);
        let is_small = match ends {
            [Some(a), Some(b)] => (b.x - a.x).abs() < self.smallest,
            [None, None] => true,
            _ => false,
        };
        if !is_small && depth < DEEPEST {
            let between = self.bench.spot(middle);
            self.cell([a, middle], [ends[0], between], depth + 1);
            self.cell([middle, b], [between, ends[1]], depth + 1);
            return;
        }
        let mut energy = [0.0; 4];
        let mut width = 0.0;
        let table = self.observer.table();
        for [place, weight] in GAUSS {
            let nm = a + place * (b - a);
            let Some(spot) = self.bench.spot(nm) else {
                continue;
            };
            let own = self.light.smooth_at(nm) * spot.transmittance * weight * (b - a);
            let parts = with_xyz(own, table.at(nm));
            energy
                .iter_mut()
                .zip(parts)
                .for_each(|(sum, part)| *sum += part);
            width += weight * spot.width;
        }
        self.energy += energy[0];
        let [a, b] = ends;
        if let (Some(a), Some(b)) = (a.or(b), b.or(a)) {
            self.deposit.spread([a.x, b.x], width, energy);
        }
    }
}
