//! From a film and a light to a picture, and how noisy it is.

use serde::Serialize;

use super::{
    film::Film,
    light::Light,
    plane::Plane,
    studio::Studio,
    tile::{BLOCK, BLOCKS_ACROSS, PIXELS, SIDE, Tile},
};
use crate::{
    color::{Observer, Xyz, delta_e_2000, lab_from_xyz},
    spectrum::{Line, quantile},
};

/// X, Y, Z of each pixel, row after row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Side, pixels.
    pub size: usize,
    /// Pixels, in the scale of `white`.
    pub xyz: Vec<[f32; 3]>,
    /// XYZ of a place that shines with radiance 1, value x nm.
    pub white: Xyz,
    /// Spikes whose strata stand in for them somewhere, nm: they are not traced yet, are not among
    /// the strongest, or have no index.
    pub stand_ins_nm: Vec<f64>,
    /// True if some part of the light could not be shown at all yet.
    pub unfinished: bool,
}

/// Noise of a picture, from its two halves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Noise {
    /// Mean over pixels of `((Y_A - Y_B) / 2)^2 / (Y + .02 Y_white)^2`.
    pub relative_mse: f64,
    /// Median of CIEDE2000 between the halves' blocks of 8 x 8 pixels, halved.
    pub delta_e_median: f64,
    /// 95th percentile of the same.
    pub delta_e_p95: f64,
    /// Mean over the blocks that the gem touches: beside it there is no noise, and where it covers
    /// less than half of the picture the median is that of the empty half. `None` where it
    /// touches none.
    pub delta_e_on_gem: Option<f64>,
}

/// Share of the white's Y by which a dark pixel's is raised before a noise is divided by it.
const DARK: f64 = 0.02;

/// Factors of a tile's planes.
struct Weights {
    planes: Vec<(usize, [f64; 3])>,
    stand_ins_nm: Vec<f64>,
    unfinished: bool,
}

/// A part of a light: wavelengths and X, Y, Z.
struct Part {
    nm: f64,
    /// Its own plane; none of a line that has none.
    plane: Option<usize>,
    is_line: bool,
    xyz: [f64; 3],
}

impl Film {
    /// The light's parts in the order of the planes: strata, then spikes.
    fn parts(&self, light: &Light, observer: Observer) -> Vec<Part> {
        let stratum = |(place, plane): (usize, &Plane)| match *plane {
            Plane::Stratum { from_nm, to_nm } => Some(Part {
                nm: 0.5 * (from_nm + to_nm),
                plane: Some(place),
                is_line: false,
                xyz: light
                    .smooth_xyz([from_nm, to_nm], observer, false)
                    .to_array(),
            }),
            Plane::Line { .. } => None,
        };
        let line = |Line { at_nm, weight, .. }| Part {
            nm: at_nm,
            plane: self.line(at_nm),
            is_line: true,
            xyz: observer.table().at(at_nm).map(|v| v * weight),
        };
        let strata = self.planes().iter().enumerate().filter_map(stratum);
        strata.chain(light.seen_spikes().map(line)).collect()
    }

    /// Weights of a tile's planes. What a plane without rays should show, the plane nearest in
    /// wavelength shows for it, a stratum before a line.
    fn weights(&self, parts: &[Part], tile: &Tile) -> Weights {
        let planes = self.planes();
        let strata = self.settings().strata;
        let mut sums = vec![[0.0; 3]; planes.len()];
        let mut weights = Weights {
            planes: Vec::new(),
            stand_ins_nm: Vec::new(),
            unfinished: false,
        };
        let off = |place: usize, nm: f64| match planes[place] {
            Plane::Stratum { from_nm, to_nm } => (0.5 * (from_nm + to_nm) - nm).abs(),
            Plane::Line { at_nm } => (at_nm - nm).abs(),
        };
        let traced = |place: &usize| tile.count(*place) > 0.0;
        for part in parts.iter().filter(|part| part.xyz != [0.0; 3]) {
            let place = part.plane.filter(traced).or_else(|| {
                let nearest = |places: std::ops::Range<usize>| {
                    places
                        .filter(traced)
                        .min_by(|a, b| off(*a, part.nm).total_cmp(&off(*b, part.nm)))
                };
                nearest(0..strata).or_else(|| nearest(strata..planes.len()))
            });
            if part.is_line && place != part.plane {
                weights.stand_ins_nm.push(part.nm);
            }
            match place {
                Some(place) => {
                    weights.unfinished |= !part.is_line && Some(place) != part.plane;
                    for (sum, v) in sums[place].iter_mut().zip(part.xyz) {
                        *sum += v;
                    }
                }
                None => weights.unfinished = true,
            }
        }
        weights.planes = sums
            .into_iter()
            .enumerate()
            .filter(|(_, xyz)| *xyz != [0.0; 3])
            .map(|(place, xyz)| (place, xyz.map(|v| v / tile.count(place))))
            .collect();
        weights
    }

    /// The picture under a light: a sum over planes, nothing is traced.
    pub fn picture(&self, light: &Light, observer: Observer) -> Picture {
        let light = &*light.in_reach();
        let size = self.settings().size;
        let mut picture = Picture {
            size,
            xyz: vec![[0.0; 3]; size * size],
            white: light.white(observer),
            stand_ins_nm: Vec::new(),
            unfinished: false,
        };
        let parts = self.parts(light, observer);
        let mut sums = [[0.0_f32; PIXELS]; 3];
        for tile in self.tiles() {
            let weights = self.weights(&parts, tile);
            picture.unfinished |= weights.unfinished;
            for nm in weights.stand_ins_nm {
                if !picture.stand_ins_nm.contains(&nm) {
                    picture.stand_ins_nm.push(nm);
                }
            }
            sums.iter_mut().for_each(|sum| sum.fill(0.0));
            for (place, xyz) in &weights.planes {
                let [x, y, z] = xyz.map(|v| v as f32);
                let [to_x, to_y, to_z] = &mut sums;
                let to = to_x.iter_mut().zip(to_y).zip(to_z);
                for (((to_x, to_y), to_z), value) in to.zip(tile.sums(*place)) {
                    *to_x += x * value;
                    *to_y += y * value;
                    *to_z += z * value;
                }
            }
            let [columns, rows] = tile.extent;
            for row in 0..rows {
                let to = (tile.corner[1] + row) * size + tile.corner[0];
                let pixels = &mut picture.xyz[to..to + columns];
                for (column, pixel) in pixels.iter_mut().enumerate() {
                    *pixel = sums.each_ref().map(|sum| sum[row * SIDE + column]);
                }
            }
        }
        picture
    }

    /// Transport of a plane, row after row from the top: radiance under light of radiance 1; 0
    /// where nothing was traced.
    pub fn plane(&self, place: usize) -> Vec<f32> {
        let size = self.settings().size;
        let mut values = vec![0.0; size * size];
        if place >= self.planes().len() {
            return values;
        }
        for tile in self.tiles() {
            let count = tile.count(place);
            let over = if count > 0.0 { 1.0 / count } else { 0.0 };
            let [columns, rows] = tile.extent;
            for row in 0..rows {
                let to = (tile.corner[1] + row) * size + tile.corner[0];
                let from = &tile.sums(place)[row * SIDE..][..columns];
                for (value, sum) in values[to..to + columns].iter_mut().zip(from) {
                    *value = (f64::from(*sum) * over) as f32;
                }
            }
        }
        values
    }

    /// Transport at a wavelength: of its own plane, or where that has no rays of its stratum.
    pub(crate) fn transport(&self, at_nm: f64) -> Vec<f32> {
        let has_rays = |place: &usize| self.tiles().iter().all(|tile| tile.count(*place) > 0.0);
        let stratum = || {
            let holds = |plane: &Plane| matches!(plane, Plane::Stratum { from_nm, to_nm } if (*from_nm..=*to_nm).contains(&at_nm));
            self.planes().iter().position(holds)
        };
        let place = self.line(at_nm).filter(has_rays).or_else(stratum);
        self.plane(place.unwrap_or(usize::MAX))
    }

    /// The noise of that picture; `None` before two rays a pixel, and without a white.
    pub fn noise(&self, light: &Light, observer: Observer) -> Option<Noise> {
        let light = &*light.in_reach();
        let picture = self.picture(light, observer);
        let white = picture.white;
        if !(white.y > 0.0 && white.is_finite()) || self.rays_a_pixel() < 1.5 {
            return None;
        }
        let parts = self.parts(light, observer);
        let stride = self.stride();
        let (mut squares, mut pixels) = (0.0, 0_usize);
        let (mut deltas, mut on_gem) = (Vec::new(), Vec::new());
        for tile in self.tiles() {
            let weights = self.weights(&parts, tile);
            let mut kept = vec![0.0_f64; PIXELS / stride];
            let mut blocks = [[0.0_f64; 3]; BLOCKS_ACROSS * BLOCKS_ACROSS];
            for (place, xyz) in &weights.planes {
                for (sum, value) in kept.iter_mut().zip(tile.differences(*place, stride)) {
                    *sum += xyz[1] * f64::from(*value);
                }
                for (block, value) in blocks.iter_mut().zip(tile.blocks(*place)) {
                    for (sum, weight) in block.iter_mut().zip(xyz) {
                        *sum += weight * f64::from(*value);
                    }
                }
            }
            for (group, difference) in kept.iter().enumerate() {
                let pixel = tile.kept(group, stride);
                let [x, y] = [pixel % SIDE, pixel / SIDE];
                if x >= tile.extent[0] || y >= tile.extent[1] {
                    continue;
                }
                let index = (tile.corner[1] + y) * picture.size + tile.corner[0] + x;
                let level = f64::from(picture.xyz[index][1]) + DARK * white.y;
                // Light below zero has no relative noise.
                if level > 0.0 {
                    squares += (difference / level).powi(2);
                    pixels += 1;
                }
            }
            for (number, block) in blocks.iter().enumerate() {
                let Some(delta) = block_delta(&picture, tile, number, *block) else {
                    continue;
                };
                let first = block_corner(number);
                let place = [tile.corner[0] + first[0], tile.corner[1] + first[1]];
                deltas.push(delta);
                if touches_gem(self.studio(), place, picture.size) {
                    on_gem.push(delta);
                }
            }
        }
        let count = on_gem.len() as f64;
        Some(Noise {
            relative_mse: squares / pixels.max(1) as f64,
            delta_e_median: quantile(&mut deltas, 0.5)?,
            delta_e_p95: quantile(&mut deltas, 0.95)?,
            delta_e_on_gem: (count > 0.0).then(|| on_gem.iter().sum::<f64>() / count),
        })
    }
}

/// First column and row of a block in its tile.
fn block_corner(number: usize) -> [usize; 2] {
    [
        number % BLOCKS_ACROSS * BLOCK,
        number / BLOCKS_ACROSS * BLOCK,
    ]
}

/// True if the block of pixels from a column and row on shows the gem at any of 5 x 5 places.
fn touches_gem(studio: &Studio, [column, row]: [usize; 2], size: usize) -> bool {
    let step = |i: usize| i as f64 * BLOCK as f64 / 4.0;
    let film = |first: usize, i: usize| 2.0 * (first as f64 + step(i)) / size as f64 - 1.0;
    (0..25).any(|i| studio.meets([film(column, i % 5), -film(row, i / 5)]))
}

/// Half the colour difference between a block's two halves.
fn block_delta(picture: &Picture, tile: &Tile, number: usize, difference: [f64; 3]) -> Option<f64> {
    let first = block_corner(number);
    let extent: [usize; 2] =
        std::array::from_fn(|k| tile.extent[k].saturating_sub(first[k]).min(BLOCK));
    let count = (extent[0] * extent[1]) as f64;
    if count == 0.0 {
        return None;
    }
    let from: [usize; 2] = std::array::from_fn(|k| tile.corner[k] + first[k]);
    let mean = picture.mean_of(from, [from[0] + extent[0], from[1] + extent[1]]);
    let scale = 1.0 / picture.white.y;
    let half = |sign: f64| {
        let xyz = std::array::from_fn(|k| mean[k] + sign * scale * difference[k] / count);
        lab_from_xyz(Xyz::from_array(xyz), picture.white * scale)
    };
    Some(0.5 * delta_e_2000(half(1.0), half(-1.0)))
}

impl Picture {
    /// X, Y, Z of the whole picture's mean, the white's Y at 1.
    pub fn mean(&self) -> [f64; 3] {
        self.mean_of([0, 0], [self.size, self.size])
    }

    /// Means of `count` x `count` blocks, row after row from the top, the white's Y at 1.
    pub fn blocks(&self, count: usize) -> Vec<Vec<[f64; 3]>> {
        let count = count.clamp(1, self.size);
        let edge = |i: usize| i * self.size / count;
        let block = |row: usize, column: usize| {
            self.mean_of([edge(column), edge(row)], [edge(column + 1), edge(row + 1)])
        };
        let row = |row: usize| (0..count).map(|column| block(row, column)).collect();
        (0..count).map(row).collect()
    }

    fn mean_of(&self, first: [usize; 2], end: [usize; 2]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for y in first[1]..end[1] {
            for pixel in &self.xyz[y * self.size..][first[0]..end[0]] {
                for (sum, v) in sum.iter_mut().zip(pixel) {
                    *sum += f64::from(*v);
                }
            }
        }
        let count = ((end[0] - first[0]) * (end[1] - first[1])).max(1) as f64;
        let is_lit = self.white.y > 0.0;
        let scale = if is_lit { self.white.y } else { 1.0 };
        sum.map(|v| v / count / scale)
    }
}
