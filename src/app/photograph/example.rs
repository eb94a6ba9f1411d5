//! A photograph that the program draws: an energy-saving lamp through a slit and a grating.

use crate::io::{ColourPixels, Exif, Photo};

/// Width and height.
const SIZE: [usize; 2] = [960, 300];
/// The lamp's lines: nm, strength, width.
const LINES: [[f64; 3]; 14] = [
    [404.66, 0.25, 2.0],
    [435.83, 0.8, 2.0],
    [487.7, 0.25, 4.5],
    [493.0, 0.08, 4.0],
    [542.4, 0.75, 2.6],
    [546.07, 0.75, 2.0],
    [576.96, 0.1, 2.0],
    [579.07, 0.1, 2.0],
    [584.5, 0.1, 3.0],
    [587.6, 0.16, 3.0],
    [593.0, 0.12, 2.2],
    [599.6, 0.1, 2.2],
    [611.3, 1.0, 2.2],
    [631.0, 0.13, 2.6],
];
/// Centres and widths of the camera's red, green and blue, nm.
const CAMERA: [[f64; 2]; 3] = [[605.0, 36.0], [535.0, 38.0], [455.0, 34.0]];
/// Light between the lines, light of the dark room, and the brightest line.
const LEVELS: [f64; 3] = [0.006, 0.0015, 0.85];
/// Slope of the strip and lean of its lines, for a pixel; half of its height, px.
const SLOPE: f64 = 0.015;
const LEAN: f64 = 0.03;
const HALF: f64 = 55.0;

/// The wavelength at a pixel.
fn nm(x: f64, y: f64) -> f64 {
    let t = (x - 480.0 - LEAN * (y - 150.0)) / 960.0;
    540.0 + 380.0 * t + 12.0 * t * t
}

/// Code of linear light in sRGB.
fn code(light: f64) -> f64 {
    if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    }
}

/// The photograph.
pub(super) fn photo() -> Photo {
    let [smooth, dark, top] = LEVELS;
    let mut state = 1_u32;
    let mut codes = Vec::with_capacity(3 * SIZE[0] * SIZE[1]);
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            let (x, y) = (x as f64, y as f64);
            let away = (y - 150.0 - SLOPE * (x - 480.0)).abs();
            let row = 1.0 / (1.0 + ((away - HALF) / 1.6).exp());
            let nm = nm(x, y);
            let of_line = |[at, strength, fwhm]: &[f64; 3]| {
                strength * (-2.773 * ((nm - at) / fwhm).powi(2)).exp()
            };
            let light = smooth + LINES.iter().map(of_line).sum::<f64>();
            for [centre, width] in CAMERA {
                let seen = (-0.5 * ((nm - centre) / width).powi(2)).exp();
                // Numerical Recipes' quick generator: as good as noise here.
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let noise = 2.0 * (f64::from(state >> 16) / 65_536.0 - 0.5);
                let code = 255.0 * code(dark + top * row * light * seen) + noise;
                codes.push(code.round().clamp(0.0, 255.0) as u8);
            }
        }
    }
    Photo {
        size: SIZE,
        pixels: ColourPixels::Eight(codes),
        is_linear: false,
        exif: Exif::default(),
        notes: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{Said, Source, of_photo},
        *,
    };

    #[test]
    fn the_example_is_found_to_be_what_it_is() {
        let found = of_photo("example", photo(), &Said::default()).expect("a strip");
        assert_eq!(found.source(), Source::Found);
        let curve = found.curve().expect("an axis");
        for (x, y) in [(250.0, 140.0), (480.0, 150.0), (700.0, 160.0)] {
            let off = curve.nm(found.found.strip.column_of(x, y).0) - nm(x, y);
            // A slit of 2 nm over columns of .4 nm.
            assert!(off.abs() < 0.5, "{x}: {off}");
        }
    }
}
