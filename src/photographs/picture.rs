//! A photograph's pixels, and the light that their codes stand for.

/// Codes of red, green and blue, one pixel behind the other, row by row.
#[derive(Clone, Debug, PartialEq)]
pub enum Codes {
    /// Bytes.
    Eight(Vec<u8>),
    /// Numbers of two bytes.
    Sixteen(Vec<u16>),
}

/// A photograph as it is shown: the centre of its first pixel is (0, 0), y runs down.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    size: [usize; 2],
    codes: Codes,
    /// Light of each code, 0 to 1.
    light: Vec<f32>,
    is_linear: bool,
    /// From this code on a channel is at its end.
    full: u16,
}

/// How a camera bends what it sees before it is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tones {
    /// The power of an S: a share z of the largest code was made `z^p / (z^p + (1 - z)^p)`.
    pub s_power: f64,
    /// The power of the light that codes stand for.
    pub light_power: f64,
}

impl Tones {
    /// Those of a straight camera.
    pub const STRAIGHT: Self = Self {
        s_power: 1.0,
        light_power: 1.0,
    };
}

/// A channel is at its end from this share of the largest code on.
const FULL: f64 = 250.0 / 255.0;

/// The light of a share of the largest code: sRGB.
fn srgb(share: f64) -> f64 {
    if share <= 0.04045 {
        share / 12.92
    } else {
        ((share + 0.055) / 1.055).powf(2.4)
    }
}

impl Picture {
    /// A picture of codes; `None` where they are not as many as its pixels have.
    ///
    /// `is_linear` says that codes are proportional to light; without, they are those of sRGB.
    pub fn new(size: [usize; 2], codes: Codes, is_linear: bool) -> Option<Self> {
        let (count, largest) = match &codes {
            Codes::Eight(codes) => (codes.len(), u16::from(u8::MAX)),
            Codes::Sixteen(codes) => (codes.len(), u16::MAX),
        };
        if count == 0 || size[0].checked_mul(size[1])?.checked_mul(3)? != count {
            return None;
        }
        let mut picture = Self {
            size,
            codes,
            light: Vec::new(),
            is_linear,
            full: (FULL * f64::from(largest)).ceil() as u16,
        };
        picture.straighten_tones(Tones::STRAIGHT);
        Some(picture)
    }

    /// Takes codes for those of a camera that bends its tones.
    pub fn straighten_tones(&mut self, tones: Tones) {
        let power = tones.s_power;
        let largest = match &self.codes {
            Codes::Eight(_) => u16::from(u8::MAX),
            Codes::Sixteen(_) => u16::MAX,
        };
        let light = |code: u16| {
            let share = f64::from(code) / f64::from(largest);
            let (a, b) = (share.powf(1.0 / power), (1.0 - share).powf(1.0 / power));
            let straight = if power == 1.0 { share } else { a / (a + b) };
            let light = if self.is_linear {
                straight
            } else {
                srgb(straight)
            };
            light.powf(1.0 / tones.light_power) as f32
        };
        self.light = (0..=largest).map(light).collect();
    }

    /// Width and height.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The codes of a pixel as bytes.
    pub fn shown(&self, [x, y]: [usize; 2]) -> [u8; 3] {
        let is_wide = matches!(self.codes, Codes::Sixteen(_));
        self.code(x, y)
            .map(|code| (if is_wide { code >> 8 } else { code }) as u8)
    }

    /// The codes of a pixel.
    fn code(&self, x: usize, y: usize) -> [u16; 3] {
        let at = 3 * (y * self.size[0] + x);
        match &self.codes {
            Codes::Eight(codes) => [0, 1, 2].map(|k| u16::from(codes[at + k])),
            Codes::Sixteen(codes) => [0, 1, 2].map(|k| codes[at + k]),
        }
    }

    /// The light of a pixel.
    fn light(&self, x: usize, y: usize) -> [f32; 3] {
        self.code(x, y).map(|code| self.light[usize::from(code)])
    }

    /// Means of blocks of pixels in linear light: a picture whose longest side is at most `side`.
    pub(super) fn small(&self, side: usize) -> Small {
        let [width, height] = self.size;
        let block = width.max(height).div_ceil(side).max(1);
        let [columns, rows] = [(width / block).max(1), (height / block).max(1)];
        let mut channels = [(); 3].map(|()| vec![0.0_f32; columns * rows]);
        for y in 0..(rows * block).min(height) {
            for x in 0..(columns * block).min(width) {
                let at = (y / block) * columns + x / block;
                let light = self.light(x, y);
                for (channel, light) in channels.iter_mut().zip(light) {
                    channel[at] += light;
                }
            }
        }
        let share = 1.0 / (block * block) as f32;
        channels.iter_mut().flatten().for_each(|sum| *sum *= share);
        Small {
            size: [columns, rows],
            channels,
            block,
        }
    }
}

/// A picture made small, in linear light.
pub(super) struct Small {
    pub size: [usize; 2],
    pub channels: [Vec<f32>; 3],
    /// Pixels of the photograph in one of this, along a side.
    pub block: usize,
}

/// A photograph looked at with its dispersion from left to right.
#[derive(Clone, Copy)]
pub(super) struct View<'p> {
    pub picture: &'p Picture,
    /// Columns of the view are rows of the photograph.
    pub is_vertical: bool,
}

impl View<'_> {
    /// Width and height.
    pub(super) fn size(self) -> [usize; 2] {
        let [width, height] = self.picture.size;
        if self.is_vertical {
            [height, width]
        } else {
            [width, height]
        }
    }

    /// The light at a place between pixels; `None` beside the picture.
    pub(super) fn light(self, x: f64, y: f64) -> Option<[f32; 3]> {
        let [width, height] = self.size();
        let inside = |at: f64, count: usize| at >= -0.5 && at <= count as f64 - 0.5;
        if !inside(x, width) || !inside(y, height) {
            return None;
        }
        let (x, y) = (
            x.clamp(0.0, width as f64 - 1.0),
            y.clamp(0.0, height as f64 - 1.0),
        );
        let (left, above) = (x as usize, y as usize);
        let (right, below) = ((left + 1).min(width - 1), (above + 1).min(height - 1));
        let (fx, fy) = ((x - left as f64) as f32, (y - above as f64) as f32);
        let corners =
            [(left, above), (right, above), (left, below), (right, below)].map(|(x, y)| {
                if self.is_vertical {
                    self.picture.light(y, x)
                } else {
                    self.picture.light(x, y)
                }
            });
        Some([0, 1, 2].map(|k| {
            let upper = corners[0][k] + (corners[1][k] - corners[0][k]) * fx;
            let lower = corners[2][k] + (corners[3][k] - corners[2][k]) * fx;
            upper + (lower - upper) * fy
        }))
    }

    /// True if a channel is saturated at the pixel that contains a place.
    pub(super) fn is_full(self, x: f64, y: f64) -> bool {
        let [width, height] = self.size();
        let near = |at: f64, count: usize| (at.round().max(0.0) as usize).min(count - 1);
        let (x, y) = (near(x, width), near(y, height));
        let codes = if self.is_vertical {
            self.picture.code(y, x)
        } else {
            self.picture.code(x, y)
        };
        codes.iter().any(|code| *code >= self.picture.full)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> Picture {
        let codes = (0..12_u8).flat_map(|i| [20 * i, 0, 255]).collect();
        Picture::new([4, 3], Codes::Eight(codes), false).expect("a picture")
    }

    #[test]
    fn codes_become_light_by_the_formula_of_srgb() {
        let picture = picture();
        assert_eq!(picture.light(0, 0), [0.0, 0.0, 1.0]);
        let expected = ((100.0 / 255.0 + 0.055_f64) / 1.055).powf(2.4);
        assert!((f64::from(picture.light(1, 1)[0]) - expected).abs() < 1e-6);
        let straight = Picture::new([1, 1], Codes::Sixteen(vec![32_768; 3]), true);
        assert!((straight.expect("a pixel").light(0, 0)[0] - 0.5).abs() < 1e-4);
        assert_eq!(Picture::new([2, 1], Codes::Eight(vec![0; 3]), false), None);
    }

    #[test]
    fn tones_that_a_camera_has_bent_are_straightened() {
        let straight = picture();
        let bent = |share: f64| {
            let (a, b) = (share.powf(1.3), (1.0 - share).powf(1.3));
            a / (a + b)
        };
        let codes = (0..12_u16).flat_map(|i| [bent(f64::from(20 * i) / 255.0), 0.0, 1.0]);
        let codes = codes.map(|share| (65_535.0 * share).round() as u16);
        let mut picture = Picture::new([4, 3], Codes::Sixteen(codes.collect()), false);
        let picture = picture.as_mut().expect("a picture");
        picture.straighten_tones(Tones {
            s_power: 1.3,
            ..Tones::STRAIGHT
        });
        for (x, y) in [(1, 0), (2, 1), (3, 2)] {
            let off = picture.light(x, y)[0] - straight.light(x, y)[0];
            // Codes of two bytes are rounded by 1 in 131,070.
            assert!(off.abs() < 1e-4, "{off}");
        }
    }

    #[test]
    fn a_power_of_the_light_is_undone() {
        let mut picture = picture();
        let plain = picture.light(2, 1);
        picture.straighten_tones(Tones {
            light_power: 1.25,
            ..Tones::STRAIGHT
        });
        let straight = picture.light(2, 1);
        // Single precision keeps seven digits.
        assert!((straight[0].powf(1.25) - plain[0]).abs() < 1e-6);
        assert_eq!((straight[1], straight[2]), (0.0, 1.0));
    }

    #[test]
    fn between_pixels_light_is_linear_and_beside_the_picture_there_is_none() {
        let picture = picture();
        let view = View {
            picture: &picture,
            is_vertical: false,
        };
        let turned = View {
            picture: &picture,
            is_vertical: true,
        };
        let at = |x, y| view.light(x, y).expect("inside")[0];
        assert!((at(0.25, 0.0) - 0.75 * at(0.0, 0.0) - 0.25 * at(1.0, 0.0)).abs() < 1e-6);
        assert_eq!(turned.light(2.0, 1.0), view.light(1.0, 2.0));
        assert_eq!(view.light(-1.0, 0.0), None);
        assert_eq!(view.light(0.0, 2.6), None);
        assert!(view.is_full(1.0, 1.0));
    }

    #[test]
    fn a_small_picture_is_means_of_blocks() {
        let small = picture().small(2);
        assert_eq!((small.size, small.block), ([2, 1], 2));
        let mean = [0, 1, 4, 5]
            .map(|i| srgb(f64::from(20 * i) / 255.0))
            .iter()
            .sum::<f64>()
            / 4.0;
        assert!((f64::from(small.channels[0][0]) - mean).abs() < 1e-6);
    }
}
