//! Programs of others that pictures are measured against where they are installed: numpy's product
//! of matrices, and JPEG XL as the coder of planes.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use nalgebra::DMatrix;
use spectral_explorer::color::{Xyz, delta_e_of_xyz};
use spectral_explorer::pictures::*;
use spectral_explorer::study::Progress;

/// Million pixels a second of numpy's f32 product, best of nine; `None` without numpy.
pub(crate) fn numpy(bands: usize, numbers: usize, pixels: usize) -> Option<f64> {
    let script = format!(
        "import numpy as np,time\n\
         a=np.random.rand({numbers},{bands}).astype('f4');b=np.random.rand({bands},{pixels}).astype('f4')\n\
         o=np.empty(({numbers},{pixels}),'f4');t=[]\n\
         for _ in range(9):\n\
         \x20 s=time.perf_counter();np.matmul(a,b,out=o);t.append(time.perf_counter()-s)\n\
         print({pixels}/min(t)/1e6)\n"
    );
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let told = Command::new(python)
        .args(["-c", &script])
        .env("OPENBLAS_NUM_THREADS", "1")
        .stderr(Stdio::null())
        .output();
    String::from_utf8(told.ok()?.stdout)
        .ok()?
        .trim()
        .parse()
        .ok()
}

/// A file through `cjxl`: its bytes, and what `djxl` makes of them; `None` where it is not there.
fn through(folder: &Path, name: &str, more: &[&str]) -> Option<(u64, std::path::PathBuf)> {
    let (coded, back) = (folder.join("a.jxl"), folder.join(format!("back-{name}")));
    let run = |program: &str, args: &[&str], files: [&Path; 2]| {
        let mut command = Command::new(program);
        let told = command
            .args(files)
            .args(args)
            .stderr(Stdio::null())
            .status();
        told.ok().filter(std::process::ExitStatus::success)
    };
    run("cjxl", more, [&folder.join(name), &coded])?;
    run("djxl", &[], [&coded, &back])?;
    Some((fs::metadata(&coded).ok()?.len(), back))
}

/// Whole numbers of 16 bits as PGM, without loss, effort 7: bytes; `None` without `cjxl`.
pub(crate) fn lossless(width: usize, height: usize, values: &[i32]) -> Option<u64> {
    let folder = tempfile::tempdir().ok()?;
    let least = *values.iter().min()?;
    let mut file = format!("P5\n{width} {height}\n65535\n").into_bytes();
    for value in values {
        file.extend(u16::try_from(value - least).ok()?.to_be_bytes());
    }
    fs::write(folder.path().join("a.pgm"), file).ok()?;
    Some(through(folder.path(), "a.pgm", &["-d", "0", "-e", "7"])?.0)
}

/// A plane of floats as PFM (rows from below), at a distance: bytes and the plane again.
fn float_plane(
    plane: &[f64],
    [width, height]: [usize; 2],
    distance: f64,
) -> Option<(u64, Vec<f64>)> {
    let folder = tempfile::tempdir().ok()?;
    let mut file = format!("Pf\n{width} {height}\n-1.0\n").into_bytes();
    for row in plane.chunks_exact(width).rev() {
        row.iter()
            .for_each(|v| file.extend((*v as f32).to_le_bytes()));
    }
    fs::File::create(folder.path().join("a.pfm"))
        .ok()?
        .write_all(&file)
        .ok()?;
    let distance = format!("{distance}");
    let (bytes, back) = through(folder.path(), "a.pfm", &["-d", &distance, "-e", "3"])?;
    let back = fs::read(back).ok()?;
    let tail = &back[back.len().checked_sub(4 * width * height)?..];
    // The sign of the last number of the header tells the order of bytes.
    let head = &back[..back.len() - tail.len()];
    let is_big = !head.contains(&b'-');
    let number = |b: &[u8]| {
        let b: [u8; 4] = b.try_into().expect("four bytes");
        f64::from(if is_big {
            f32::from_be_bytes(b)
        } else {
            f32::from_le_bytes(b)
        })
    };
    let rows: Vec<Vec<f64>> = tail
        .chunks_exact(4 * width)
        .map(|row| row.chunks_exact(4).map(number).collect())
        .collect();
    Some((bytes, rows.into_iter().rev().flatten().collect()))
}

/// A plane of 0-1 as grey of 16 bits, at a distance: bytes and the plane again.
fn grey_plane(
    plane: &[f64],
    [width, height]: [usize; 2],
    distance: f64,
) -> Option<(u64, Vec<f64>)> {
    let folder = tempfile::tempdir().ok()?;
    let mut file = format!("P5\n{width} {height}\n65535\n").into_bytes();
    let whole = |v: &f64| (v * 65535.0).round().clamp(0.0, 65535.0) as u16;
    plane
        .iter()
        .for_each(|v| file.extend(whole(v).to_be_bytes()));
    fs::write(folder.path().join("a.pgm"), file).ok()?;
    let distance = format!("{distance}");
    let (bytes, back) = through(folder.path(), "a.pgm", &["-d", &distance, "-e", "3"])?;
    let back = fs::read(back).ok()?;
    let count = width * height;
    let is_deep = back.windows(5).take(30).any(|w| w == b"65535");
    let size = if is_deep { 2 } else { 1 };
    let tail = &back[back.len().checked_sub(size * count)?..];
    let number = |b: &[u8]| match b {
        [high, low] => f64::from(u16::from_be_bytes([*high, *low])) / 65535.0,
        _ => f64::from(b[0]) / 255.0,
    };
    Some((bytes, tail.chunks_exact(size).map(number).collect()))
}

/// A picture kept by a stand-in for the method of Fichet and Peters (2025), by `cjxl` a plane: not
/// their program. Cosine series over the bands, the first number as it is, the others relative to
/// it and stretched to 0-1; each plane is coded as coarsely as leaves its error at or below that
/// of the first of them.
pub(crate) struct StandIn {
    /// Bytes of all planes.
    pub bytes: u64,
    /// What own colour is off by.
    pub own: Spread,
    /// What the spectra are off by, relative.
    pub relative_rms: f64,
}

/// Distances that a plane's may be beside the one before.
const COARSER: [f64; 5] = [8.0, 4.0, 2.0, 1.4, 1.0];

/// The stand-in at a distance; `None` without `cjxl` and `djxl`.
pub(crate) fn stand_in(pixels: &InMemory, operator: &Operator, distance: f64) -> Option<StandIn> {
    let (width, height) = pixels.size();
    let (count, bands) = (width * height, pixels.bands().len());
    let wave = |n: usize, j: usize| {
        let norm = if n == 0 { 1.0 } else { 2.0 } / bands as f64;
        let angle = std::f64::consts::PI * n as f64 * (j as f64 + 0.5) / bands as f64;
        (norm, angle.cos())
    };
    let number = |n: usize, i: usize| -> f64 {
        let of_band = |j: usize| f64::from(pixels.values()[j * count + i]) * wave(n, j).1;
        wave(n, 0).0 * (0..bands).map(of_band).sum::<f64>()
    };
    let first: Vec<f64> = (0..count).map(|i| number(0, i)).collect();
    let (mut bytes, first) = float_plane(&first, [width, height], distance)?;
    let mut back = DMatrix::<f64>::zeros(count, bands);
    let (mut coarse, mut bound) = (distance, f64::INFINITY);
    for n in 1..bands {
        let over = |i: usize| number(n, i) / first[i].max(1e-6);
        let exact: Vec<f64> = (0..count).map(over).collect();
        let [low, high] = exact
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
                [l.min(*v), h.max(*v)]
            });
        let span = (high - low).max(1e-12);
        let unit: Vec<f64> = exact.iter().map(|v| (v - low) / span).collect();
        let off = |found: &[f64]| {
            let squares = unit.iter().zip(found).map(|(a, b)| (a - b).powi(2));
            (squares.sum::<f64>() / count as f64).sqrt() * span
        };
        let tried = if n == 1 { &COARSER[4..] } else { &COARSER[..] };
        let mut kept = None;
        for times in tried {
            let at = (coarse * times).min(15.0);
            let (size, found) = grey_plane(&unit, [width, height], at)?;
            let error = off(&found);
            if error <= bound || *times <= 1.0 {
                kept = Some((at, size, found, error));
                break;
            }
        }
        let (at, size, found, error) = kept?;
        if n == 1 {
            bound = error;
        }
        coarse = at;
        bytes += size;
        for i in 0..count {
            let value = (low + span * found[i]) * first[i];
            for j in 0..bands {
                back[(i, j)] += value * wave(n, j).1;
            }
        }
    }
    for i in 0..count {
        for j in 0..bands {
            back[(i, j)] += first[i];
        }
    }
    let own = operator.own_colour();
    let (mut tally, mut off, mut all) = (Tally::default(), 0.0, 0.0);
    for i in 0..count {
        let exact: Vec<f64> = (0..bands)
            .map(|j| f64::from(pixels.values()[j * count + i]))
            .collect();
        let seen = |pixel: &dyn Fn(usize) -> f64| {
            let of = |row: &Vec<f64>| (0..bands).map(|j| row[j] * pixel(j)).sum();
            Xyz::from_array(operator.own_weights().each_ref().map(of))
        };
        let [a, b] = [seen(&|j| exact[j]), seen(&|j| back[(i, j)])];
        tally.add(delta_e_of_xyz(a, b, own.white).unwrap_or(1e3));
        for (j, weight) in pixels.bands().weights_nm().iter().enumerate() {
            off += weight * (back[(i, j)] - exact[j]).powi(2);
            all += weight * exact[j].powi(2);
        }
    }
    Some(StandIn {
        bytes,
        own: tally.spread(),
        relative_rms: (off / all).sqrt(),
    })
}

/// What the composite takes at the same 95th percentile of own colour: bytes without the preview,
/// and its errors.
pub(crate) fn composite_at(pixels: &InMemory, operator: &Operator, p95: f64) -> (u64, Errors) {
    let quiet = Progress::default();
    let survey = Survey::of(pixels, &quiet).expect("measured");
    let plan = compact_plan(pixels, operator, &survey.sample, p95, 1.0, &quiet).expect("a plan");
    let mut file = Vec::new();
    let about = About::default();
    let coder = Coder::Fitted;
    write_compact(&mut file, pixels, operator, &plan, &about, coder, &quiet).expect("written");
    (bytes_of(&file, &[b"csPH", b"csPT"]), plan.error)
}

/// Bytes of some chunks of a PNG.
pub(crate) fn bytes_of(file: &[u8], kinds: &[&[u8; 4]]) -> u64 {
    let (mut at, mut sum) = (8, 0);
    while at + 8 <= file.len() {
        let length = u32::from_be_bytes(file[at..at + 4].try_into().expect("four bytes"));
        if kinds.iter().any(|kind| file[at + 4..at + 8] == **kind) {
            sum += u64::from(length);
        }
        at += length as usize + 12;
    }
    sum
}
