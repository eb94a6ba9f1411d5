//! A film that holds transport and no light.
//!
//! For each stratum of wavelengths and each spike's place it keeps the radiance of every pixel under
//! light of radiance 1. A picture under a light is a sum over these planes, so another light of the
//! library is a new sum at once; only its new spikes must be traced.

use std::{
    num::NonZero,
    sync::{Mutex, PoisonError},
};

use super::{
    chain::Traced,
    light::{Light, SEEN_NM},
    plan::{Importance, Plan},
    plane::{FilmSettings, Plane},
    studio::Studio,
    tile::{Entries, Entry, SIDE, Tile},
};
use crate::{
    color::Observer,
    spectrum::Line,
    study::{Progress, in_parallel, processors},
};

/// Sides of a picture, pixels.
pub(crate) const SIZES: std::ops::RangeInclusive<usize> = 16..=4096;

/// Rays a pixel that may be asked for.
pub(crate) const RAYS: std::ops::RangeInclusive<u32> = 1..=65_536;

/// Most spikes with a plane of their own; of more the strongest have one.
pub(crate) const MOST_LINES: usize = 64;

/// Most bytes that a film may take.
pub(crate) const MOST_BYTES: usize = 2 << 30;

/// Bytes that the differences of single pixels may take before some pixels are left out.
const DIFFERENCES_BYTES: usize = 8 << 20;

/// One round of tracing has at most so many rays a pixel: cancel is heard between tiles.
const RAYS_A_ROUND: u32 = 256;

/// Why there is no film, or no more of it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FilmError {
    /// A side out of range.
    #[error(
        "{}",
        tr!(
            "size: expected {least} to {most} pixels, found {found}",
            least = SIZES.start(),
            most = SIZES.end(),
            found
        )
    )]
    Size { found: usize },
    /// A count of strata out of range.
    #[error("{}", tr!("strata: expected 4 to 400, found {found}", found))]
    Strata { found: usize },
    /// A count of rays out of range.
    #[error(
        "{}",
        tr!(
            "rays: expected {least} to {most} a pixel, found {found}",
            least = RAYS.start(),
            most = RAYS.end(),
            found
        )
    )]
    Rays { found: u32 },
    /// The film would not fit.
    #[error(
        "{}",
        tr!(
            "expected a film of at most {most} MB, found one of {found} MB",
            most = MOST_BYTES >> 20,
            found = bytes >> 20
        )
    )]
    Memory { bytes: usize },
    /// It was asked to stop; what was traced is kept.
    #[error("{}", said!("cancelled"))]
    Cancelled,
}

/// Planes of transport over a picture.
#[derive(Clone, Debug)]
pub struct Film {
    studio: Studio,
    settings: FilmSettings,
    planes: Vec<Plane>,
    /// Of how many pixels one keeps its difference of halves.
    stride: usize,
    tiles: Vec<Tile>,
}

/// Bytes that a film of a size takes with some planes: their sums, and the differences of their
/// halves for the noise.
pub(crate) fn film_bytes(size: usize, planes: usize) -> usize {
    let tiles = size.div_ceil(SIDE);
    let pixels = tiles * tiles * SIDE * SIDE;
    let sums = pixels.saturating_mul(planes).saturating_mul(4);
    sums.saturating_add(sums / stride_of(size, planes))
        .saturating_add(sums / 64)
}

fn fits(size: usize, planes: usize) -> Result<(), FilmError> {
    match film_bytes(size, planes) {
        ..=MOST_BYTES => Ok(()),
        bytes => Err(FilmError::Memory { bytes }),
    }
}

fn stride_of(size: usize, planes: usize) -> usize {
    let bytes = size * size * planes * 4;
    [1, 2, 4]
        .into_iter()
        .find(|stride| bytes / stride <= DIFFERENCES_BYTES)
        .unwrap_or(8)
}

impl Film {
    /// An empty film.
    ///
    /// # Errors
    /// [`FilmError`] for a size or count of strata out of range, and where it would not fit.
    pub fn new(studio: Studio, settings: FilmSettings) -> Result<Self, FilmError> {
        let FilmSettings { size, strata, .. } = settings;
        if !SIZES.contains(&size) {
            return Err(FilmError::Size { found: size });
        }
        if !(4..=400).contains(&strata) {
            return Err(FilmError::Strata { found: strata });
        }
        fits(size, strata)?;
        let width = (SEEN_NM[1] - SEEN_NM[0]) / strata as f64;
        let edge = |j: usize| SEEN_NM[0] + width * j as f64;
        let planes: Vec<Plane> = (0..strata)
            .map(|j| Plane::Stratum {
                from_nm: edge(j),
                to_nm: edge(j + 1),
            })
            .collect();
        let stride = stride_of(size, strata + 8);
        let across = size.div_ceil(SIDE);
        let tile = |i: usize| Tile::new([i % across, i / across], size, strata, stride);
        Ok(Self {
            studio,
            settings,
            stride,
            tiles: (0..across * across).map(tile).collect(),
            planes,
        })
    }

    /// The studio being traced.
    pub(crate) fn studio(&self) -> &Studio {
        &self.studio
    }

    /// Size, strata, seed.
    pub(crate) fn settings(&self) -> FilmSettings {
        self.settings
    }

    /// All planes: strata first, then lines in the order in which they were asked for.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    pub(super) fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    pub(super) fn stride(&self) -> usize {
        self.stride
    }

    /// Counts of the rays traced so far.
    pub fn traced(&self) -> Traced {
        let mut all = Traced::default();
        self.tiles.iter().for_each(|tile| all.add(&tile.traced));
        all
    }

    /// Rays a pixel so far.
    pub(crate) fn rays_a_pixel(&self) -> f64 {
        let pixels = (self.settings.size * self.settings.size) as f64;
        self.traced().rays as f64 / pixels
    }

    /// Bytes it takes.
    pub fn bytes(&self) -> usize {
        film_bytes(self.settings.size, self.planes.len())
    }

    /// Spikes of a light that a film gives planes: all between 380 and 780 nm, of more than
    /// [`MOST_LINES`] the strongest; by rising wavelength.
    pub(crate) fn lines_of(light: &Light) -> Vec<Line> {
        let mut lines: Vec<Line> = light.seen_spikes().collect();
        lines.sort_by(|a, b| b.weight.abs().total_cmp(&a.weight.abs()));
        lines.truncate(MOST_LINES);
        lines.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        lines.dedup_by(|a, b| a.at_nm == b.at_nm);
        lines
    }

    /// Spikes of a light that have no rays yet, nm: strata stand in for them.
    pub(crate) fn missing_lines(&self, light: &Light) -> Vec<f64> {
        let is_missing = |at_nm: &f64| {
            let place = self.line(*at_nm);
            place.is_none_or(|p| self.tiles.iter().any(|tile| tile.count(p) == 0.0))
        };
        Self::lines_of(light)
            .into_iter()
            .map(|spike| spike.at_nm)
            .filter(is_missing)
            .collect()
    }

    /// The place of a line's plane.
    pub(super) fn line(&self, at_nm: f64) -> Option<usize> {
        self.planes
            .iter()
            .position(|plane| matches!(plane, Plane::Line { at_nm: own } if *own == at_nm))
    }

    /// Adds rays for a light, so many a pixel, shared among its parts by what they weigh.
    ///
    /// `None` threads are as many as the machine has processors. Any number gives the same bits.
    ///
    /// # Errors
    /// [`FilmError`] for rays out of range, a film that would not fit, and when it was cancelled:
    /// then the tiles that were done have their rays.
    pub fn trace(
        &mut self,
        light: &Light,
        rays: u32,
        threads: Option<NonZero<usize>>,
        progress: &Progress,
    ) -> Result<(), FilmError> {
        let lines = Self::lines_of(light);
        let places = self.with_lines(lines.iter().map(|s| s.at_nm), rays)?;
        let importance = self.importance(light, &lines);
        let plan = |own| Plan::new(&importance, own);
        self.rounds(&places, plan, rays, threads, progress)
    }

    /// Adds rays for some wavelengths alone, so many a pixel for each.
    ///
    /// # Errors
    /// As [`Film::trace`]; wavelengths outside 380-780 nm are left out.
    pub fn trace_lines(
        &mut self,
        lines_nm: &[f64],
        rays: u32,
        threads: Option<NonZero<usize>>,
        progress: &Progress,
    ) -> Result<(), FilmError> {
        let seen = |nm: &f64| (SEEN_NM[0]..=SEEN_NM[1]).contains(nm);
        let places = self.with_lines(lines_nm.iter().copied().filter(seen), rays)?;
        let plan = |own| Plan {
            lines: vec![f64::from(own); places.len()],
            strata: Vec::new(),
        };
        self.rounds(&places, plan, rays, threads, progress)
    }

    /// Adds rays round by round; `plan` shares out those of a round.
    fn rounds(
        &mut self,
        places: &[usize],
        plan: impl Fn(u32) -> Plan,
        rays: u32,
        threads: Option<NonZero<usize>>,
        progress: &Progress,
    ) -> Result<(), FilmError> {
        let rounds = rays.div_ceil(RAYS_A_ROUND);
        progress.expect(self.tiles.len() * rounds as usize);
        for round in 0..rounds {
            let own = rays / rounds + u32::from(round < rays % rounds);
            self.round(&self.entries(&plan(own), places), threads, progress)?;
        }
        Ok(())
    }

    /// Places of the planes of lines that are to have so many rays, new ones added.
    fn with_lines(
        &mut self,
        lines_nm: impl Iterator<Item = f64>,
        rays: u32,
    ) -> Result<Vec<usize>, FilmError> {
        if !RAYS.contains(&rays) {
            return Err(FilmError::Rays { found: rays });
        }
        let lines: Vec<f64> = lines_nm.collect();
        let new = lines.iter().filter(|nm| self.line(**nm).is_none()).count();
        fits(self.settings.size, self.planes.len() + new)?;
        let mut places = Vec::with_capacity(lines.len());
        for at_nm in lines {
            places.push(self.line(at_nm).unwrap_or_else(|| {
                self.planes.push(Plane::Line { at_nm });
                self.planes.len() - 1
            }));
        }
        let (count, stride) = (self.planes.len(), self.stride);
        self.tiles
            .iter_mut()
            .for_each(|tile| tile.widen(count, stride));
        Ok(places)
    }

    fn importance(&self, light: &Light, lines: &[Line]) -> Importance {
        // Rays are shared for the standard observer whoever looks.
        let observer = Observer::CIE_1931;
        let table = observer.table();
        let sum = |xyz: [f64; 3]| xyz.iter().map(|v| v.abs()).sum::<f64>();
        let stratum = |plane: &Plane| match *plane {
            Plane::Stratum { from_nm, to_nm } => Some(sum(light
                .smooth_xyz([from_nm, to_nm], observer, true)
                .to_array())),
            Plane::Line { .. } => None,
        };
        Importance {
            lines: lines
                .iter()
                .map(|s| s.weight.abs() * sum(table.at(s.at_nm)))
                .collect(),
            strata: self.planes.iter().filter_map(stratum).collect(),
        }
    }

    fn entries(&self, plan: &Plan, places: &[usize]) -> Entries {
        let used = |plane: usize| {
            let most = self.tiles.iter().map(|tile| tile.used(plane)).max();
            most.unwrap_or(0)
        };
        let line = |(place, planned): (&usize, &f64)| Entry::new(*place, *planned, used(*place));
        let stratum = |(place, planned): (usize, &f64)| Entry::new(place, *planned, used(place));
        Entries {
            lines: places.iter().zip(&plan.lines).map(line).collect(),
            strata: plan.strata.iter().enumerate().map(stratum).collect(),
        }
    }

    /// One round over all tiles.
    fn round(
        &mut self,
        entries: &Entries,
        threads: Option<NonZero<usize>>,
        progress: &Progress,
    ) -> Result<(), FilmError> {
        let threads = threads.map_or_else(processors, NonZero::get);
        let (studio, settings, planes) = (&self.studio, self.settings, &self.planes[..]);
        let stride = self.stride;
        let tiles: Vec<Mutex<&mut Tile>> = self.tiles.iter_mut().map(Mutex::new).collect();
        let traced = in_parallel(&tiles, threads, progress, |tile| {
            let mut tile = tile.lock().unwrap_or_else(PoisonError::into_inner);
            tile.trace(studio, settings, planes, entries, stride);
        });
        traced.map(drop).ok_or(FilmError::Cancelled)
    }
}
