//! A square of a film: its sums, and how it is traced.

use super::{
    chain::{Traced, Work},
    lanes::Start,
    plane::{FilmSettings, Plane},
    points::{mixed, point_2, point_3, share},
    studio::Studio,
};

/// Side of a tile, pixels.
pub(super) const SIDE: usize = 32;

/// Pixels of a tile, those beyond the picture's edge too.
pub(super) const PIXELS: usize = SIDE * SIDE;

/// Side of the blocks over which the noise of colour is told, pixels.
pub(super) const BLOCK: usize = 8;

/// Blocks across a tile.
pub(super) const BLOCKS_ACROSS: usize = SIDE / BLOCK;

/// Blocks of a tile.
pub(super) const BLOCKS: usize = BLOCKS_ACROSS * BLOCKS_ACROSS;

/// So many strata share a film point in a pixel's first rays: less noise of colour.
const GROUP: usize = 4;

/// Sums over the pixels of a square.
#[derive(Clone, Debug)]
pub(super) struct Tile {
    /// First column and row.
    pub(super) corner: [usize; 2],
    /// Columns and rows inside the picture.
    pub(super) extent: [usize; 2],
    /// Plane after plane, the sum of each pixel.
    sums: Vec<f32>,
    /// Plane after plane, for one pixel in each `stride`: first half less second half.
    differences: Vec<f32>,
    /// Plane after plane, the same for blocks.
    blocks: Vec<f32>,
    /// Rays that each plane's sums stand for.
    counts: Vec<f64>,
    /// Points of its sequence that each plane used.
    used: Vec<u32>,
    pub(super) traced: Traced,
}

/// Work of a round for a plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    place: usize,
    /// Rays a pixel: a whole number, or how many there are on average.
    planned: f64,
    /// First point of the plane's sequence.
    first: u32,
    /// Weight of a ray of each half in the difference; `None` when the halves alternate.
    halves: Option<[f32; 2]>,
}

impl Entry {
    pub(super) fn new(place: usize, planned: f64, first: u32) -> Self {
        let whole = planned >= 2.0 && planned.fract() == 0.0;
        // Each half by its own count, so that the difference is that of two means.
        let halves = whole.then(|| {
            let first_half = (planned / 2.0).ceil();
            let of = |n: f64| (planned / (2.0 * n)) as f32;
            [of(first_half), of(planned - first_half)]
        });
        Self {
            place,
            planned,
            first,
            halves,
        }
    }
}

/// A round: rays for spikes and for strata.
#[derive(Clone, Debug, Default)]
pub(super) struct Entries {
    pub(super) lines: Vec<Entry>,
    pub(super) strata: Vec<Entry>,
}

/// A plane's optics: fixed for a line, by wavelength for a stratum.
enum Ray {
    Line {
        key: u64,
        optics: Option<[f64; 2]>,
    },
    Stratum {
        number: u64,
        group: u64,
        from_nm: f64,
        width_nm: f64,
    },
}

/// A ray that waits: entry, number of its point, half (2 for neither).
type Job = (u32, u32, u8);

/// The work of a round on a tile.
struct Round<'a> {
    tile: &'a mut Tile,
    studio: &'a Studio,
    settings: FilmSettings,
    entries: Vec<(Entry, Ray)>,
    lines: usize,
    stride: usize,
    /// The next pixel.
    pixel: usize,
    /// The pixel at work.
    at: Pixel,
    jobs: Vec<Job>,
}

/// A pixel of the picture.
#[derive(Clone, Copy, Default)]
struct Pixel {
    /// Its number in the tile.
    number: usize,
    column: usize,
    row: usize,
    key: u64,
}

impl Tile {
    pub(super) fn new(place: [usize; 2], size: usize, planes: usize, stride: usize) -> Self {
        let corner = place.map(|p| p * SIDE);
        let mut tile = Self {
            corner,
            extent: corner.map(|c| (size - c).min(SIDE)),
            sums: Vec::new(),
            differences: Vec::new(),
            blocks: Vec::new(),
            counts: Vec::new(),
            used: Vec::new(),
            traced: Traced::default(),
        };
        tile.widen(planes, stride);
        tile
    }

    /// Makes room for planes.
    pub(super) fn widen(&mut self, planes: usize, stride: usize) {
        self.sums.resize(planes * PIXELS, 0.0);
        self.differences.resize(planes * (PIXELS / stride), 0.0);
        self.blocks.resize(planes * BLOCKS, 0.0);
        self.counts.resize(planes, 0.0);
        self.used.resize(planes, 0);
    }

    /// Rays that a plane's sums stand for.
    pub(super) fn count(&self, plane: usize) -> f64 {
        self.counts.get(plane).copied().unwrap_or(0.0)
    }

    pub(super) fn used(&self, plane: usize) -> u32 {
        self.used.get(plane).copied().unwrap_or(0)
    }

    /// Sums of a plane, a pixel after another.
    pub(super) fn sums(&self, plane: usize) -> &[f32] {
        &self.sums[plane * PIXELS..][..PIXELS]
    }

    /// Differences of a plane, for one pixel of each stride.
    pub(super) fn differences(&self, plane: usize, stride: usize) -> &[f32] {
        &self.differences[plane * (PIXELS / stride)..][..PIXELS / stride]
    }

    /// Differences of a plane, summed over blocks.
    pub(super) fn blocks(&self, plane: usize) -> &[f32] {
        &self.blocks[plane * BLOCKS..][..BLOCKS]
    }

    /// The pixel of a stride whose difference is kept.
    pub(super) fn kept(&self, group: usize, stride: usize) -> usize {
        let here = mixed(
            (self.corner[0] * 65_536 + self.corner[1]) as u64,
            group as u64,
        );
        group * stride + (here % stride as u64) as usize
    }

    /// Traces a round.
    pub(super) fn trace(
        &mut self,
        studio: &Studio,
        settings: FilmSettings,
        planes: &[Plane],
        entries: &Entries,
        stride: usize,
    ) {
        let groups = (settings.strata as u64).div_ceil(GROUP as u64);
        let ray = |entry: &Entry| {
            let ray = match planes[entry.place] {
                Plane::Line { at_nm } => Ray::Line {
                    key: at_nm.to_bits(),
                    optics: studio.optics_at(at_nm),
                },
                Plane::Stratum { from_nm, to_nm } => Ray::Stratum {
                    number: entry.place as u64,
                    group: entry.place as u64 % groups,
                    from_nm,
                    width_nm: to_nm - from_nm,
                },
            };
            (*entry, ray)
        };
        let all = entries.lines.iter().chain(&entries.strata);
        let mut traced = Traced::default();
        let mut round = Round {
            entries: all.clone().map(ray).collect(),
            lines: entries.lines.len(),
            tile: self,
            studio,
            settings,
            stride,
            pixel: 0,
            at: Pixel::default(),
            jobs: Vec::new(),
        };
        studio.fast().follow(&mut round, &mut traced);
        self.traced.add(&traced);
        for entry in all {
            self.counts[entry.place] += entry.planned;
            let used = self.used(entry.place).max(entry.first);
            self.used[entry.place] = used + entry.planned.ceil() as u32;
        }
    }
}

impl Round<'_> {
    /// Sets the next pixel of the picture up; `false` after the last.
    fn advance(&mut self) -> bool {
        let [columns, rows] = self.tile.extent;
        while self.pixel < PIXELS {
            let (x, y) = (self.pixel % SIDE, self.pixel / SIDE);
            let number = self.pixel;
            self.pixel += 1;
            if x >= columns || y >= rows {
                continue;
            }
            let (column, row) = (self.tile.corner[0] + x, self.tile.corner[1] + y);
            let key = mixed(self.settings.seed, ((row as u64) << 32) | column as u64);
            self.at = Pixel {
                number,
                column,
                row,
                key,
            };
            self.fill();
            return true;
        }
        false
    }

    /// Lists the rays of the pixel at work.
    fn fill(&mut self) {
        self.jobs.clear();
        let Pixel {
            column, row, key, ..
        } = self.at;
        let offset = |which: u64| {
            let first = self.entries.first().map_or(0, |(entry, _)| entry.first);
            share(mixed(key, 0x5eed + 2 * u64::from(first) + which) as u32)
        };
        let mut half = ((column + row) % 2) as u8;
        for (which, range) in [0..self.lines, self.lines..self.entries.len()]
            .into_iter()
            .enumerate()
        {
            // Systematic sampling: as many as whole numbers lie between two sums of plans.
            let mut sum = offset(which as u64);
            let is_line = which == 0;
            for index in range {
                let (entry, _) = &self.entries[index];
                let before = sum.floor();
                sum += entry.planned;
                let count = (sum.floor() - before).max(0.0) as u32;
                for i in 0..count {
                    let own = if entry.halves.is_some() {
                        (i % 2) as u8
                    } else if is_line && entry.planned == 1.0 {
                        // One ray alone says nothing of its noise.
                        2
                    } else {
                        half ^= 1;
                        half
                    };
                    self.jobs.push((index as u32, i, own));
                }
            }
        }
        // Taken from the end.
        self.jobs.reverse();
    }

    /// Film point, index and absorption of a ray (`None` where the material has no index), and
    /// its chance.
    fn ray(&self, index: u32, i: u32) -> ([f64; 2], Option<[f64; 2]>, u32) {
        let (entry, ray) = &self.entries[index as usize];
        let point = entry.first + i;
        match ray {
            Ray::Line { key, optics } => {
                let own = mixed(self.at.key, *key);
                (point_2(own, point), *optics, chance(own, point))
            }
            Ray::Stratum {
                number,
                group,
                from_nm,
                width_nm,
            } => {
                let own = mixed(self.at.key, *number);
                let [x, y, z] = point_3(own, point);
                let within = if point == 0 {
                    point_2(mixed(self.at.key, 0x6000 + *group), 0)
                } else {
                    [x, y]
                };
                let optics = self.studio.optics_at(from_nm + z * width_nm);
                (within, optics, chance(own, point))
            }
        }
    }

    fn owner(&self, index: u32, half: u8) -> u32 {
        (index << 12) | ((self.at.number as u32) << 2) | u32::from(half)
    }

    fn record(&mut self, owner: u32, radiance: f32) {
        let half = (owner & 3) as usize;
        let pixel = ((owner >> 2) as usize) & (PIXELS - 1);
        let (entry, _) = &self.entries[(owner >> 12) as usize];
        let tile = &mut *self.tile;
        tile.sums[entry.place * PIXELS + pixel] += radiance;
        if half > 1 {
            return;
        }
        let factor = entry.halves.map_or(1.0, |halves| halves[half]);
        let signed = if half == 0 { factor } else { -factor } * radiance;
        let (x, y) = (pixel % SIDE, pixel / SIDE);
        let block = y / BLOCK * BLOCKS_ACROSS + x / BLOCK;
        tile.blocks[entry.place * BLOCKS + block] += signed;
        let group = pixel / self.stride;
        if self.stride == 1 || tile.kept(group, self.stride) == pixel {
            tile.differences[entry.place * (PIXELS / self.stride) + group] += signed;
        }
    }
}

/// Initial value of a chain's roulette.
fn chance(key: u64, point: u32) -> u32 {
    mixed(key, 0x7000 + u64::from(point)) as u32
}

impl Work<f32> for Round<'_> {
    fn next(&mut self) -> Option<Start<f32>> {
        loop {
            let Some((index, i, half)) = self.jobs.pop() else {
                if self.advance() {
                    continue;
                }
                return None;
            };
            self.tile.traced.rays += 1;
            let ([x, y], optics, chance) = self.ray(index, i);
            let owner = self.owner(index, half);
            // Where there is no index nothing is seen.
            let Some(optics) = optics else {
                continue;
            };
            let size = self.settings.size as f64;
            let film = [
                2.0 * (self.at.column as f64 + x) / size - 1.0,
                1.0 - 2.0 * (self.at.row as f64 + y) / size,
            ];
            let direction = self.studio.camera().direction(film);
            let begun = self
                .studio
                .fast()
                .begin(film, direction, optics, chance, owner);
            match begun {
                Ok(start) => return Some(start),
                Err(radiance) => self.record(owner, radiance),
            }
        }
    }

    fn done(&mut self, owner: u32, radiance: f32) {
        self.record(owner, radiance);
    }
}
