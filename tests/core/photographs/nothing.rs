//! Pictures that show no spectrum.

use super::{dice::Dice, jpeg};

/// Kinds of them.
pub(crate) const NOTHINGS: [&str; 10] = [
    "blobs", "sunset", "words", "chart", "grass", "bars", "rainbow", "street", "noise", "flat",
];

/// A picture of a kind, 480 x 336 px.
pub(crate) fn no_spectrum(kind: &str, dice: &mut Dice) -> ([usize; 2], Vec<u8>) {
    let size = [480, 336];
    let [width, height] = size;
    let (w, h) = (width as f64, height as f64);
    let mut spots: Vec<[f64; 6]> = Vec::new();
    for _ in 0..dice.between(4.0, 30.0) as usize {
        spots.push([
            dice.between(0.0, w),
            dice.between(0.0, h),
            dice.between(3.0, 60.0),
            dice.between(0.0, 255.0),
            dice.between(0.0, 255.0),
            dice.between(0.0, 255.0),
        ]);
    }
    let bars: Vec<[f64; 3]> = (0..24)
        .map(|_| [(); 3].map(|()| dice.between(0.0, 255.0)))
        .collect();
    let (wide, noise) = (dice.between(12.0, 60.0), dice.between(1.0, 9.0));
    let wave = [dice.between(0.02, 0.3), dice.between(0.02, 0.3)];
    let paint = |x: f64, y: f64, dice: &mut Dice| -> [f64; 3] {
        let spot =
            |s: &[f64; 6]| (-0.5 * ((x - s[0]).powi(2) + (y - s[1]).powi(2)) / s[2].powi(2)).exp();
        match kind {
            "blobs" => [0, 1, 2].map(|k| spots.iter().map(|s| s[3 + k] * spot(s)).sum()),
            "street" => [0, 1, 2].map(|k| {
                let warm = [1.0, 0.75, 0.4][k];
                12.0 + spots
                    .iter()
                    .map(|s| 2.0 * s[3] * warm * spot(&[s[0], s[1], 0.15 * s[2], 0.0, 0.0, 0.0]))
                    .sum::<f64>()
            }),
            "sunset" => {
                let t = y / h;
                [40.0 + 210.0 * t, 30.0 + 150.0 * t * t, 120.0 - 90.0 * t]
            }
            "words" => {
                let row = (y / 14.0) as i64;
                let is_ink = (y as i64 % 14) < 8
                    && ((x * 0.7 + row as f64 * 3.1).sin() * (x * 1.9 + row as f64).cos()) > 0.25;
                [if is_ink { 20.0 } else { 235.0 }; 3]
            }
            "chart" => bars[((x / 80.0) as usize + 6 * (y / 84.0) as usize) % 24],
            "grass" => {
                let blade = 60.0 * (wave[0] * x + 3.0 * (wave[1] * y).sin()).sin();
                [50.0 + 0.5 * blade, 110.0 + blade, 35.0 + 0.3 * blade]
            }
            "bars" => bars[(x / wide) as usize % 24],
            "rainbow" => {
                let hue = 6.0 * x / w;
                let up = |at: f64| (2.0 - (hue - at).abs()).clamp(0.0, 1.0);
                let inside = if (y - 0.5 * h).abs() < 2.0 * wide {
                    255.0
                } else {
                    10.0
                };
                [
                    (up(0.0) + up(6.0)).min(1.0) * inside,
                    up(2.0) * inside,
                    up(4.0) * inside,
                ]
            }
            "noise" => [(); 3].map(|()| dice.between(0.0, 255.0)),
            _ => bars[0],
        }
    };
    let mut codes = Vec::with_capacity(3 * width * height);
    for y in 0..height {
        for x in 0..width {
            for v in paint(x as f64, y as f64, dice) {
                let v = if kind == "flat" {
                    v
                } else {
                    v + noise * dice.normal()
                };
                codes.push(v.round().clamp(0.0, 255.0) as u8);
            }
        }
    }
    let quality = dice.between(75.0, 95.0) as u32;
    (size, jpeg::through(&codes, size, quality))
}
