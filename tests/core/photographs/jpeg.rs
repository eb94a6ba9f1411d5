//! The marks that JPEG leaves on pixels: coarse colours, and blocks of rounded waves.

use std::f64::consts::PI;

const LUMA: [u8; 64] = [
    16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56,
    14, 17, 22, 29, 51, 87, 80, 62, 18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113,
    92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99,
];
const CHROMA: [u8; 64] = [
    17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99, 99, 99,
    47, 66, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
    99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
];

/// The steps of a table at a quality of 1 to 100, as the usual encoder has them.
fn steps(table: &[u8; 64], quality: u32) -> [f64; 64] {
    let scale = if quality < 50 {
        5000.0 / f64::from(quality)
    } else {
        200.0 - 2.0 * f64::from(quality)
    };
    table.map(|s| {
        ((f64::from(s) * scale + 50.0) / 100.0)
            .floor()
            .clamp(1.0, 255.0)
    })
}

/// A plane behind rounding of its waves, block by block.
fn rounded(plane: &mut [f64], [width, height]: [usize; 2], steps: &[f64; 64]) {
    let mut wave = [[0.0; 8]; 8];
    for (u, row) in wave.iter_mut().enumerate() {
        for (x, w) in row.iter_mut().enumerate() {
            let norm: f64 = if u == 0 { 0.125_f64.sqrt() } else { 0.5 };
            *w = norm * ((2 * x + 1) as f64 * u as f64 * PI / 16.0).cos();
        }
    }
    for top in (0..height).step_by(8) {
        for left in (0..width).step_by(8) {
            let place =
                |x: usize, y: usize| (top + y).min(height - 1) * width + (left + x).min(width - 1);
            let mut block = [[0.0; 8]; 8];
            for (y, row) in block.iter_mut().enumerate() {
                for (x, v) in row.iter_mut().enumerate() {
                    *v = plane[place(x, y)] - 128.0;
                }
            }
            let along = |b: &[[f64; 8]; 8], back: bool| {
                let mut out = [[0.0; 8]; 8];
                for y in 0..8 {
                    for u in 0..8 {
                        // Transposed on the way, so that twice is both ways.
                        out[u][y] = (0..8)
                            .map(|x| b[y][x] * if back { wave[x][u] } else { wave[u][x] })
                            .sum();
                    }
                }
                out
            };
            let mut waves = along(&along(&block, false), false);
            for (v, row) in waves.iter_mut().enumerate() {
                for (u, w) in row.iter_mut().enumerate() {
                    let step = steps[8 * v + u];
                    *w = (*w / step).round() * step;
                }
            }
            let block = along(&along(&waves, true), true);
            for (y, row) in block.iter().enumerate() {
                for (x, v) in row.iter().enumerate() {
                    if top + y < height && left + x < width {
                        plane[place(x, y)] = (v + 128.0).clamp(0.0, 255.0);
                    }
                }
            }
        }
    }
}

/// Codes as they come back from a JPEG of a quality, its colours at half the size.
pub(crate) fn through(codes: &[u8], size: [usize; 2], quality: u32) -> Vec<u8> {
    let [width, height] = size;
    let mut planes = [(); 3].map(|()| vec![0.0; width * height]);
    for (i, p) in codes.chunks_exact(3).enumerate() {
        let [r, g, b] = [0, 1, 2].map(|k| f64::from(p[k]));
        planes[0][i] = 0.299 * r + 0.587 * g + 0.114 * b;
        planes[1][i] = 128.0 - 0.168_736 * r - 0.331_264 * g + 0.5 * b;
        planes[2][i] = 128.0 + 0.5 * r - 0.418_688 * g - 0.081_312 * b;
    }
    rounded(&mut planes[0], size, &steps(&LUMA, quality));
    let half = [width.div_ceil(2), height.div_ceil(2)];
    for plane in &mut planes[1..] {
        let whole = |x: usize, y: usize| plane[y.min(height - 1) * width + x.min(width - 1)];
        let mut small: Vec<f64> = (0..half[0] * half[1])
            .map(|i| (2 * (i % half[0]), 2 * (i / half[0])))
            .map(|(x, y)| {
                0.25 * (whole(x, y) + whole(x + 1, y) + whole(x, y + 1) + whole(x + 1, y + 1))
            })
            .collect();
        rounded(&mut small, half, &steps(&CHROMA, quality));
        for y in 0..height {
            for x in 0..width {
                // Three quarters of the nearest and a quarter of the next, both ways.
                let near = |i: usize, most: usize| {
                    let next = if i.is_multiple_of(2) {
                        (i / 2).saturating_sub(1)
                    } else {
                        i / 2 + 1
                    };
                    (i / 2, next.min(most - 1))
                };
                let ((x0, x1), (y0, y1)) = (near(x, half[0]), near(y, half[1]));
                let s = |x: usize, y: usize| small[y * half[0] + x];
                plane[y * width + x] = 0.75 * (0.75 * s(x0, y0) + 0.25 * s(x1, y0))
                    + 0.25 * (0.75 * s(x0, y1) + 0.25 * s(x1, y1));
            }
        }
    }
    let code = |v: f64| v.round().clamp(0.0, 255.0) as u8;
    (0..width * height)
        .flat_map(|i| {
            let [y, cb, cr] = [0, 1, 2].map(|k| planes[k][i] - if k == 0 { 0.0 } else { 128.0 });
            [
                code(y + 1.402 * cr),
                code(y - 0.344_136 * cb - 0.714_136 * cr),
                code(y + 1.772 * cb),
            ]
        })
        .collect()
}
