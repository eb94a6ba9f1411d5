//! Strips of light as a telephone or a webcam sees them: turned, leaning, bent, dusty, noisy.

use super::{
    cameras::{Camera, Grating, Sums},
    dice::Dice,
    jpeg,
    lights::Light,
};
use crate::photographs::Profile;

/// What stands in a picture beside its strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Strange {
    ZeroOrder,
    Reflection,
    Glow,
    Words,
    TwoStrips,
}

/// A bench that pictures are taken with.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    /// Width and height before the picture is turned.
    pub size: [usize; 2],
    pub grating: Grating,
    camera: Camera,
    pub slit_nm: f64,
    pub nm_a_column: f64,
    pub is_grey: bool,
    /// Colours from top to bottom, and from the other side.
    pub is_vertical: bool,
    pub is_flipped: bool,
    pub tilt_deg: f64,
    shear: f64,
    smile: f64,
    middle: [f64; 2],
    half: f64,
    /// Quality of the JPEG; none of a PNG.
    pub quality: Option<u32>,
    pub strange: Vec<Strange>,
}

/// A picture whose wavelengths are known.
pub(crate) struct Drawn {
    pub size: [usize; 2],
    pub codes: Vec<u8>,
    /// nm, x, y in the picture as shown.
    pub points: Vec<[f64; 3]>,
}

impl Setup {
    /// Any bench: small pictures as the web has them.
    pub(crate) fn any(dice: &mut Dice) -> Self {
        let width = dice.one_of(&[320, 400, 480, 640, 640, 800]);
        let height = width * dice.one_of(&[56, 56, 75]) / 100;
        let mut setup = Self::of([width, height], dice);
        for (strange, share) in [
            (Strange::ZeroOrder, 0.3),
            (Strange::Reflection, 0.2),
            (Strange::Glow, 0.2),
            (Strange::Words, 0.2),
            (Strange::TwoStrips, 0.12),
        ] {
            if dice.chance(share) {
                setup.strange.push(strange);
            }
        }
        setup
    }

    /// A bench of a size with nothing strange in it.
    pub(crate) fn of([width, height]: [usize; 2], dice: &mut Dice) -> Self {
        let (w, h) = (width as f64, height as f64);
        let nm_a_column = 300.0 / (w * dice.between(0.33, 0.85));
        let is_grey = dice.chance(0.06);
        let half = h * dice.between(0.07, 0.14);
        Self {
            size: [width, height],
            grating: Grating::of(w, nm_a_column, dice),
            camera: Camera::of(dice, is_grey),
            slit_nm: 0.8 * 7.0_f64.powf(dice.roll()),
            nm_a_column,
            is_grey,
            is_vertical: dice.chance(0.3),
            is_flipped: dice.chance(0.5),
            tilt_deg: 2.5 * dice.normal(),
            shear: 0.06 * dice.normal(),
            smile: 0.02 * dice.normal() / half,
            middle: [w * dice.between(0.42, 0.58), h * dice.between(0.38, 0.62)],
            half,
            quality: (!dice.chance(0.15)).then(|| dice.between(70.0, 96.0) as u32),
            strange: Vec::new(),
        }
    }

    /// Red, green and blue along the strip: from `first` in quarters of a column.
    fn strip(&self, light: &Light, exposure: f64) -> (f64, [Vec<f64>; 3]) {
        // The lens blurs what the slit lets through.
        let psf = 1.3 * self.nm_a_column;
        let channels = self.camera.sees(&light.on_grid(self.slit_nm.hypot(psf)));
        let first = -1.2 * self.size[0] as f64;
        let count = (4.0 * 2.4 * self.size[0] as f64) as usize;
        let mut strip = channels.map(|channel| {
            let sums = Sums::of(&channel);
            let mean = |i: usize| {
                let u = first + 0.25 * i as f64;
                let (a, b) = (self.grating.nm(u - 0.5), self.grating.nm(u + 0.5));
                if (b - a).abs() > 4.0 * self.nm_a_column {
                    0.0
                } else {
                    sums.mean(a, b)
                }
            };
            (0..count).map(mean).collect::<Vec<f64>>()
        });
        let top = strip.iter().flatten().copied().fold(0.0, f64::max);
        for value in strip.iter_mut().flatten() {
            *value *= exposure / top.max(1e-12);
        }
        (first, strip)
    }

    /// The place of a pixel along and across the strip, before the picture is turned.
    fn along(&self, x: f64, y: f64) -> (f64, f64) {
        let (sin, cos) = self.tilt_deg.to_radians().sin_cos();
        let (dx, dy) = (x - self.middle[0], y - self.middle[1]);
        let (u, v) = (dx * cos + dy * sin, dy * cos - dx * sin);
        (u - self.shear * v - self.smile * v * v, v)
    }

    /// The pixel, as shown, of a place on the middle line.
    fn pixel(&self, u: f64) -> [f64; 2] {
        let (sin, cos) = self.tilt_deg.to_radians().sin_cos();
        let (x, y) = (self.middle[0] + u * cos, self.middle[1] + u * sin);
        let x = if self.is_flipped {
            self.size[0] as f64 - 1.0 - x
        } else {
            x
        };
        if self.is_vertical { [y, x] } else { [x, y] }
    }
}

/// A light through a bench: exposed so that its brightest channel reaches `exposure` of full, the
/// picture moved by some columns.
pub(crate) fn picture(
    setup: &Setup,
    light: &Light,
    exposure: f64,
    moved: f64,
    dice: &mut Dice,
) -> Drawn {
    let [width, height] = setup.size;
    let mut setup = setup.clone();
    setup.middle[0] += moved;
    let (first, strip) = setup.strip(light, exposure);
    let floor = dice.between(0.002, 0.012);
    let cast = [dice.factor(0.08), dice.factor(0.08), dice.factor(0.08)];
    let stray = dice.between(0.0, 0.003);
    let dust: Vec<f64> = (0..2 * setup.size[1])
        .map(|_| {
            if dice.chance(0.03) {
                dice.between(0.3, 0.9)
            } else {
                1.0 + 0.02 * dice.normal()
            }
        })
        .collect();
    let marks = Marks::of(&setup, dice);
    let mut linear = vec![[0.0; 3]; width * height];
    for (i, pixel) in linear.iter_mut().enumerate() {
        let (x, y) = ((i % width) as f64, (i / width) as f64);
        let (u, v) = setup.along(x, y);
        let row =
            marks.row(v) * dust[(v.round() + setup.size[1] as f64).max(0.0) as usize % dust.len()];
        let ghost = marks.ghost(v);
        let white = marks.white(u, v, x, y);
        let seen = |k: usize, u: f64| between(&strip[k], 4.0 * (u - first));
        for k in 0..3 {
            pixel[k] = floor * cast[k] + row * (seen(k, u) + stray) + white;
            if ghost > 0.0 {
                pixel[k] += ghost * seen(k, u + marks.ghost_u);
            }
        }
    }
    let mut codes = developed(&linear, setup.size, dice);
    marks.words(&mut codes, setup.size);
    let points = (0..16)
        .map(|i| 400.0 + 20.0 * f64::from(i))
        .filter_map(|nm| {
            let u = place_of(&setup.grating, nm, width as f64)?;
            let [x, y] = setup.pixel(u);
            let size = if setup.is_vertical {
                [height, width]
            } else {
                [width, height]
            };
            let inside = x >= 0.0 && y >= 0.0 && x < size[0] as f64 && y < size[1] as f64;
            inside.then_some([nm, x, y])
        })
        .collect();
    let (mut codes, size) = shown(&codes, &setup);
    if let Some(quality) = setup.quality {
        codes = jpeg::through(&codes, size, quality);
    }
    Drawn {
        size,
        codes,
        points,
    }
}

/// A list between its places.
fn between(list: &[f64], place: f64) -> f64 {
    if place < 0.0 || place >= (list.len() - 1) as f64 {
        return 0.0;
    }
    let left = place as usize;
    list[left] + (list[left + 1] - list[left]) * (place - left as f64)
}

/// The column of a wavelength to the right of the middle.
fn place_of(grating: &Grating, nm: f64, width: f64) -> Option<f64> {
    let (mut low, mut high) = (-width, width);
    if grating.nm(low) > nm || grating.nm(high) < nm {
        return None;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if grating.nm(middle) < nm {
            low = middle
        } else {
            high = middle
        }
    }
    Some(low)
}

/// What disturbs a strip.
struct Marks {
    half: f64,
    edge: f64,
    has_gap: bool,
    ghost: Option<(f64, f64)>,
    ghost_u: f64,
    zero: Option<(f64, f64)>,
    glow: Option<[f64; 4]>,
    /// Pixels of words.
    ink: Vec<[usize; 2]>,
}

impl Marks {
    fn of(setup: &Setup, dice: &mut Dice) -> Self {
        let has = |what| setup.strange.contains(&what);
        let [w, h] = setup.size.map(|s| s as f64);
        // The image of the slit itself stands beyond the blue end, wherever there is room.
        let blue = place_of(&setup.grating, 385.0, w).unwrap_or(-0.5 * w);
        let zero = (blue - dice.between(0.05, 0.4) * w).max(5.0 - setup.middle[0]);
        let corner = [
            dice.between(0.02, 0.7) * w,
            if dice.chance(0.5) { 0.04 * h } else { 0.92 * h },
        ];
        let mut ink = Vec::new();
        if has(Strange::Words) {
            for letter in 0..dice.between(8.0, 18.0) as usize {
                for _ in 0..11 {
                    let x = corner[0] as usize + 6 * letter + dice.between(0.0, 5.0) as usize;
                    ink.push([x, corner[1] as usize + dice.between(0.0, 7.0) as usize]);
                }
            }
        }
        let side = if dice.chance(0.5) { 1.0 } else { -1.0 };
        Self {
            half: setup.half,
            edge: dice.between(0.5, 1.6),
            has_gap: has(Strange::TwoStrips),
            ghost: has(Strange::Reflection).then(|| {
                (
                    side * dice.between(1.9, 3.0) * setup.half,
                    dice.between(0.08, 0.35),
                )
            }),
            ghost_u: dice.between(-0.04, 0.04) * w,
            zero: has(Strange::ZeroOrder).then(|| (zero, dice.between(3.0, 8.0))),
            glow: has(Strange::Glow).then(|| {
                [
                    dice.between(0.1, 0.9) * w,
                    if dice.chance(0.5) { 0.05 * h } else { 0.93 * h },
                    dice.between(0.05, 0.09) * h,
                    dice.between(0.2, 0.6),
                ]
            }),
            ink,
        }
    }

    /// How bright a row of the strip is.
    fn row(&self, v: f64) -> f64 {
        let inside = 1.0 / (1.0 + ((v.abs() - self.half) / self.edge).exp());
        if self.has_gap {
            inside * (1.0 - 1.0 / (1.0 + ((v.abs() - 0.12 * self.half) / 0.6).exp()))
        } else {
            inside
        }
    }

    fn ghost(&self, v: f64) -> f64 {
        self.ghost.map_or(0.0, |(at, strength)| {
            let off = v - at;
            let row = 1.0 / (1.0 + ((off.abs() - 0.8 * self.half) / (3.0 * self.edge)).exp());
            strength * row * (1.0 - 0.5 * (off / self.half).clamp(-1.0, 1.0))
        })
    }

    fn white(&self, u: f64, v: f64, x: f64, y: f64) -> f64 {
        let zero = self.zero.map_or(0.0, |(at, wide)| {
            1.5 * self.row(v) / (1.0 + ((u - at).abs() - wide).exp())
        });
        let glow = self.glow.map_or(0.0, |[gx, gy, wide, height]| {
            height * (-0.5 * ((x - gx).powi(2) + (y - gy).powi(2)) / wide.powi(2)).exp()
        });
        zero + glow
    }

    fn words(&self, codes: &mut [u8], [width, height]: [usize; 2]) {
        for [x, y] in &self.ink {
            if *x < width && *y < height {
                codes[3 * (y * width + x)..][..3].fill(215);
            }
        }
    }
}

/// Codes of linear light, with the noise of a sensor and the blur of its mosaic.
fn developed(linear: &[[f64; 3]], [width, height]: [usize; 2], dice: &mut Dice) -> Vec<u8> {
    let (shot, read) = (dice.between(0.0004, 0.004), dice.between(0.0006, 0.004));
    let noisy: Vec<[f64; 3]> = (linear.iter())
        .map(|p| {
            p.map(|v| v + (shot * shot * v.max(0.0) * 25.0 + read * read).sqrt() * dice.normal())
        })
        .collect();
    let mixed = |from: &[[f64; 3]], at: usize, step: usize, place: usize, count: usize| {
        let left = if place > 0 { at - step } else { at };
        let right = if place + 1 < count { at + step } else { at };
        [0, 1, 2].map(|k| 0.7 * from[at][k] + 0.15 * (from[left][k] + from[right][k]))
    };
    let level: Vec<[f64; 3]> = (0..noisy.len())
        .map(|i| mixed(&noisy, i, 1, i % width, width))
        .collect();
    let both = (0..noisy.len()).map(|i| mixed(&level, i, width, i / width, height));
    let code = |v: f64| {
        let v = v.clamp(0.0, 1.0);
        let share = if v <= 0.003_130_8 {
            12.92 * v
        } else {
            1.055 * v.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * share).round() as u8
    };
    both.flat_map(|p| p.map(code)).collect()
}

/// A picture mirrored and turned as the bench has it.
fn shown(codes: &[u8], setup: &Setup) -> (Vec<u8>, [usize; 2]) {
    let [width, height] = setup.size;
    let size = if setup.is_vertical {
        [height, width]
    } else {
        [width, height]
    };
    let pixel = |i: usize| {
        let (x, y) = (i % size[0], i / size[0]);
        let (x, y) = if setup.is_vertical { (y, x) } else { (x, y) };
        let x = if setup.is_flipped { width - 1 - x } else { x };
        let at = 3 * (y * width + x);
        [codes[at], codes[at + 1], codes[at + 2]]
    };
    ((0..width * height).flat_map(pixel).collect(), size)
}

/// A profile of a light, and the true wavelengths of its columns.
pub(crate) fn drawn_profile(light: &Light, dice: &mut Dice) -> (Profile, Vec<f64>) {
    let columns = dice.one_of(&[300, 400, 400, 600, 900, 1600]);
    let mut setup = Setup::of([columns, 100], dice);
    // Half the pictures are cut near to the light.
    setup.nm_a_column = 330.0 * 3.3_f64.powf(dice.roll().powf(1.7)) / columns as f64;
    setup.grating = Grating::of(columns as f64, setup.nm_a_column, dice);
    let exposure = if dice.chance(0.25) {
        dice.between(1.0, 3.0)
    } else {
        dice.between(0.3, 0.98)
    };
    let (first, strip) = setup.strip(light, exposure);
    let (noise, floor) = (dice.between(0.0005, 0.0023), dice.between(0.003, 0.015));
    let half = 0.5 * columns as f64;
    let place = |i: usize| {
        let i = if setup.is_flipped { columns - 1 - i } else { i };
        i as f64 - half
    };
    let mut clipped = vec![false; columns];
    let channels = [0, 1, 2].map(|k| {
        (0..columns)
            .map(|i| {
                let v = floor + between(&strip[k], 4.0 * (place(i) - first));
                clipped[i] |= v >= 0.955;
                v.min(1.0) - floor + floor * 0.5 + noise * dice.normal()
            })
            .collect::<Vec<f64>>()
    });
    let channels = if setup.is_grey {
        [
            channels[0].clone(),
            channels[0].clone(),
            channels[0].clone(),
        ]
    } else {
        channels
    };
    let nm = (0..columns).map(|i| setup.grating.nm(place(i))).collect();
    let profile = Profile {
        channels,
        sigma: [noise; 3],
        clipped,
        is_grey: setup.is_grey,
        black_seen: true,
        rows: 40,
    };
    (profile, nm)
}
