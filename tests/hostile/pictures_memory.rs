//! A picture larger than the memory it may take: a process of its own, since it watches memory.

use std::io::Write;

use spectral_explorer::pictures::*;
use spectral_explorer::study::Progress;

/// The most memory that this process ever held, MiB; `None` where the system does not tell.
fn peak_mib() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib / 1024)
}

/// Writes 2.1 GB to the temporary folder and takes minutes: `cargo test -- --ignored`.
#[test]
#[ignore = "writes 2.1 GB and takes minutes"]
fn a_cube_of_two_gigabytes_is_stored_within_512_mib() {
    const SIDE: usize = 4096;
    let folder = tempfile::tempdir().unwrap();
    let nm: Vec<f64> = (0..31).map(|j| 400.0 + 10.0 * f64::from(j)).collect();
    let scene = Scene::reflectance(SIDE, 64, nm.clone()).unwrap();
    let mut strip = vec![0.0; SIDE * 64 * 31];
    scene.rows(0, 64, &mut strip).unwrap();
    let mut file = std::fs::File::create(folder.path().join("wall.img")).unwrap();
    for band in strip.chunks_exact(SIDE * 64) {
        let bytes: Vec<u8> = band.iter().flat_map(|v| v.to_le_bytes()).collect();
        (0..SIDE / 64).for_each(|_| file.write_all(&bytes).unwrap());
    }
    drop((file, strip, scene));
    let list: Vec<String> = nm.iter().map(f64::to_string).collect();
    let header = format!(
        "ENVI\nsamples = {SIDE}\nlines = {SIDE}\nbands = 31\nheader offset = 0\ndata type = 4\n\
         interleave = bsq\nbyte order = 0\nwavelength units = Nanometers\n\
         reflectance scale factor = 1\nwavelength = {{{}}}\n",
        list.join(", ")
    );
    let path = folder.path().join("wall.hdr");
    std::fs::write(&path, header).unwrap();
    let quiet = Progress::default();
    let started = std::time::Instant::now();
    let pixels = EnviFile::open(&path, false, None).unwrap();
    assert!(pixels.bands().is_factor());
    let survey = Survey::of(&pixels, &quiet).unwrap();
    println!("survey {:?}, peak {:?} MiB", started.elapsed(), peak_mib());
    let operator = Operator::new(pixels.bands(), &Plan::new(pixels.bands(), 20)).unwrap();
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let quantiser = Quantiser::new(&operator, &sample, 1.0, None).unwrap();
    let error = measure(&pixels, &operator, &quantiser, 1.0, &quiet).unwrap();
    println!(
        "measured {:?}, peak {:?} MiB",
        started.elapsed(),
        peak_mib()
    );
    let plan = CompactPlan {
        quantiser,
        error: error.clone(),
    };
    let compact = folder.path().join("wall.cspx.png");
    let bytes = save_compact(
        &compact,
        &pixels,
        &operator,
        &plan,
        &About::default(),
        &quiet,
    )
    .unwrap();
    println!(
        "compact {bytes} bytes {:?}, peak {:?} MiB",
        started.elapsed(),
        peak_mib()
    );
    let full = folder.path().join("wall.exr");
    let kept = (Precision::Half, Half::of(&sample));
    let bytes = save_full(
        &full,
        &pixels,
        &operator,
        kept,
        (&About::default(), error),
        &quiet,
    )
    .unwrap();
    println!(
        "full {bytes} bytes {:?}, peak {:?} MiB",
        started.elapsed(),
        peak_mib()
    );
    // Where the system does not tell, only the saving is tested.
    assert!(
        peak_mib().is_none_or(|peak| peak <= 512),
        "{:?} MiB",
        peak_mib()
    );
}
