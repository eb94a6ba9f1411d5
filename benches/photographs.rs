//! Speed of photographs of spectra: 12 megapixels to strip, profile and axis, beside decoding alone.
//!
//! `cargo bench -p benches --bench photographs`

use std::{fs, hint::black_box, io::Cursor, path::PathBuf, time::Duration};

use criterion::{Criterion, criterion_group, criterion_main};
use spectral_explorer::app::photograph::{Said, read};

const SIZE: [u32; 2] = [4000, 3000];
/// Lines of a fluorescent lamp: nm, strength, width in nm.
const LINES: [[f64; 3]; 10] = [
    [404.66, 0.25, 1.9],
    [435.83, 0.8, 1.9],
    [487.7, 0.25, 4.5],
    [542.4, 0.75, 2.6],
    [546.07, 0.75, 1.9],
    [578.0, 0.15, 3.0],
    [587.6, 0.16, 3.0],
    [599.6, 0.10, 2.2],
    [611.3, 1.0, 2.2],
    [631.0, 0.13, 2.6],
];
/// Centres and widths of the camera's channels, nm.
const CAMERA: [(f64, f64); 3] = [(605.0, 36.0), (535.0, 38.0), (455.0, 34.0)];

fn code(x: u32, y: u32) -> [u8; 3] {
    let [width, height] = SIZE.map(f64::from);
    let row = 1.0 / (1.0 + (((f64::from(y) - 0.5 * height).abs() - 300.0) / 8.0).exp());
    let nm = 530.0 + 400.0 * (f64::from(x) / width - 0.5);
    let line =
        |[at, strength, fwhm]: &[f64; 3]| strength * (-2.77 * ((nm - at) / fwhm).powi(2)).exp();
    let light = 0.004 + LINES.iter().map(line).sum::<f64>();
    let noise = f64::from((x * 7919 + y * 104_729) % 17) / 17.0 - 0.5;
    CAMERA.map(|(centre, wide)| {
        let seen = 0.003 + 0.8 * row * light * (-0.5 * ((nm - centre) / wide).powi(2)).exp();
        (255.0 * seen.powf(1.0 / 2.2) + 2.0 * noise).clamp(0.0, 255.0) as u8
    })
}

fn picture(folder: &std::path::Path) -> PathBuf {
    let [width, height] = SIZE;
    let pixels = (0..height).flat_map(|y| (0..width).flat_map(move |x| code(x, y)));
    let pixels: Vec<u8> = pixels.collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&pixels).expect("pixels");
    writer.finish().expect("an end");
    let path = folder.join("lamp.png");
    fs::write(&path, bytes).expect("a file in a temporary folder");
    path
}

fn photographs(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = picture(folder.path());
    let found = read(&path, &Said::default()).expect("a strip");
    assert!(found.curve().is_some(), "an axis");
    let mut group = criterion.benchmark_group("photograph of 12 megapixels");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(10));
    group.bench_function("to strip, profile and axis", |bench| {
        bench.iter(|| read(black_box(&path), &Said::default()));
    });
    group.bench_function("decoding alone", |bench| {
        bench.iter(|| {
            let bytes = fs::read(black_box(&path)).expect("the file");
            let mut reader = png::Decoder::new(Cursor::new(bytes))
                .read_info()
                .expect("a PNG");
            let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
            reader.next_frame(&mut pixels).expect("pixels");
            pixels
        });
    });
    group.finish();
}

criterion_group!(benches, photographs);
criterion_main!(benches);
