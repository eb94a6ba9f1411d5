//! Both file forms: what is written comes back, what is broken is refused.

use std::io::Cursor;

use proptest::prelude::*;
use spectral_explorer::pictures::*;
use spectral_explorer::spectrum::Kind;
use spectral_explorer::study::Progress;

fn nm(count: usize) -> Vec<f64> {
    (0..count)
        .map(|j| 400.0 + 300.0 * j as f64 / (count - 1) as f64)
        .collect()
}

fn quiet() -> Progress {
    Progress::default()
}

/// A wall of paints with a hole where nothing was measured.
fn wall(width: usize, height: usize) -> InMemory {
    let scene = Scene::reflectance(width, height, nm(31)).unwrap();
    let whole = InMemory::of(&scene).unwrap();
    let mut values = whole.values().to_vec();
    let pixels = width * height;
    for y in 3..6.min(height) {
        for x in 5..9.min(width) {
            values[7 * pixels + y * width + x] = f32::NAN;
        }
    }
    InMemory::new(width, height, whole.bands().clone(), values).unwrap()
}

fn operator(pixels: &InMemory, numbers: usize) -> Operator {
    Operator::steady(pixels.bands(), &Plan::new(pixels.bands(), numbers)).unwrap()
}

fn about() -> About {
    About {
        unit: "fraction".to_owned(),
        source: "a wall of paints, größer als nötig \u{1F308}".to_owned(),
        noise: 0.002,
    }
}

fn full(pixels: &InMemory, operator: &Operator, precision: Precision) -> (Vec<u8>, Picture) {
    let survey = Survey::of(pixels, &quiet()).unwrap();
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let half = Half::of(&sample);
    let storage: &dyn Storage = if precision == Precision::Half {
        &half
    } else {
        &Exactly
    };
    let error = measure(pixels, operator, storage, 1.0, &quiet()).unwrap();
    let mut bytes = Cursor::new(Vec::new());
    write_full(
        &mut bytes,
        pixels,
        operator,
        (precision, half),
        (&about(), error.clone()),
        &quiet(),
    )
    .unwrap();
    let picture = Picture::encode(pixels, operator, storage, (&about(), error), &quiet()).unwrap();
    (bytes.into_inner(), picture)
}

fn compact(pixels: &InMemory, operator: &Operator, bound: f64, coder: Coder) -> (Vec<u8>, Picture) {
    let survey = Survey::of(pixels, &quiet()).unwrap();
    let plan = compact_plan(pixels, operator, &survey.sample, bound, 1.0, &quiet()).unwrap();
    let mut bytes = Vec::new();
    write_compact(
        &mut bytes,
        pixels,
        operator,
        &plan,
        &about(),
        coder,
        &quiet(),
    )
    .unwrap();
    let picture = Picture::encode(
        pixels,
        operator,
        &plan.quantiser,
        (&about(), plan.error),
        &quiet(),
    )
    .unwrap();
    (bytes, picture)
}

fn same_bits(a: &Picture, b: &Picture) {
    assert_eq!(a.planes.len(), b.planes.len());
    for (at, (a, b)) in a.planes.iter().zip(&b.planes).enumerate() {
        assert!(
            a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
            "number {at}: {a} and {b}"
        );
    }
}

#[test]
fn the_full_form_comes_back_bit_for_bit() {
    for (width, height) in [(41, 37), (16, 1), (1, 50)] {
        let pixels = wall(width, height);
        for precision in [Precision::Half, Precision::Single] {
            let operator = operator(&pixels, 11);
            let (bytes, picture) = full(&pixels, &operator, precision);
            let back = read_full(&bytes).unwrap();
            same_bits(&back, &picture);
            assert_eq!(back.header.error, picture.header.error);
            assert_eq!(back.header.source, about().source);
        }
    }
}

#[test]
fn the_compact_form_comes_back_bit_for_bit_with_either_coder() {
    // More than one tile across and down.
    let pixels = wall(300, 270);
    let operator = operator(&pixels, 11);
    for coder in [Coder::Simple, Coder::Fitted] {
        let (bytes, picture) = compact(&pixels, &operator, 0.5, coder);
        let file = CompactFile::open(bytes).unwrap();
        assert_eq!(file.tiles(), (2, 2));
        same_bits(&file.picture(&quiet()).unwrap(), &picture);
        assert_eq!(file.header.error.no_data, 12);
        // The bound is on the 95th percentile, corrected at most three times.
        assert!(
            file.header.error.own.p95 <= 0.5 * 1.03,
            "{:?}",
            file.header.error.own
        );
        assert!(
            file.header.error.own.p95 >= 0.5 * 0.8,
            "{:?}",
            file.header.error.own
        );
    }
}

#[test]
fn what_a_file_claims_is_what_its_decoded_pixels_are_off_by() {
    let pixels = wall(96, 80);
    let operator = operator(&pixels, 9);
    let (bytes, _) = compact(&pixels, &operator, 0.5, Coder::Fitted);
    let picture = CompactFile::open(bytes).unwrap().picture(&quiet()).unwrap();
    // The reader's own operator, made from the header alone.
    let again = picture.header.operator().unwrap();
    let (mut off, mut all, mut largest) = (0.0, 0.0, 0.0_f64);
    let own = again.own_colour();
    for y in 0..80 {
        for x in 0..96 {
            let exact = pixels.pixel(x, y);
            let number = |n: usize| picture.planes[n * 96 * 80 + y * 96 + x];
            let numbers: Vec<f64> = (0..9).map(|n| f64::from(number(n))).collect();
            if exact.iter().any(|v| v.is_nan()) {
                assert!(numbers.iter().all(|z| z.is_nan()));
                continue;
            }
            let back = again.pixel_of(&numbers);
            for j in 0..31 {
                let weight = pixels.bands().weights_nm()[j];
                off += weight * (back[j] - exact[j]).powi(2);
                all += weight * exact[j].powi(2);
            }
            let seen = own_xyz(&again, &exact);
            let difference =
                spectral_explorer::color::delta_e_of_xyz(seen, own.xyz(&numbers), own.white)
                    .unwrap();
            largest = largest.max(difference);
        }
    }
    let claimed = &picture.header.error;
    // The measurement runs in single precision.
    assert!(((off / all).sqrt() / claimed.relative_rms - 1.0).abs() < 1e-4);
    assert!(
        (largest - claimed.own.max).abs() < 1e-3,
        "{largest} {:?}",
        claimed.own
    );
}

fn own_xyz(operator: &Operator, pixel: &[f64]) -> spectral_explorer::color::Xyz {
    let sum = |row: &Vec<f64>| row.iter().zip(pixel).map(|(w, v)| w * v).sum();
    spectral_explorer::color::Xyz::from_array(operator.own_weights().each_ref().map(sum))
}

#[test]
fn the_compact_form_is_an_ordinary_png_with_the_preview() {
    let pixels = wall(300, 270);
    let operator = operator(&pixels, 8);
    let (bytes, _) = compact(&pixels, &operator, 1.0, Coder::Fitted);
    let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
    let mut image = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut image).unwrap();
    assert_eq!((info.width, info.height), (150, 135));
    let preview = Preview::of(&pixels, &operator, &quiet()).unwrap();
    assert_eq!((preview.step, &image), (2, &preview.rgb));
    // It is a picture and not one grey.
    let (low, high) = (image.iter().min().unwrap(), image.iter().max().unwrap());
    assert!(high - low > 150);
}

#[test]
fn an_edited_png_and_other_pictures_are_refused_by_what_they_are() {
    let mut plain = Vec::new();
    let mut writer = png::Encoder::new(&mut plain, 2, 1);
    writer.set_color(png::ColorType::Rgb);
    let mut writer = writer.write_header().unwrap();
    writer.write_image_data(&[0; 6]).unwrap();
    writer.finish().unwrap();
    let said = CompactFile::open(plain).unwrap_err().to_string();
    assert!(said.contains("an editor may have dropped it"), "{said}");
    let said = CompactFile::open(b"GIF89a".to_vec())
        .unwrap_err()
        .to_string();
    assert_eq!(
        said,
        "expected a composite picture NAME.cspx.png, found no PNG"
    );
    assert!(read_full(b"GIF89a").is_err());
}

#[test]
fn unknown_keys_of_a_header_are_kept_and_newer_versions_refused() {
    let pixels = wall(20, 20);
    let (bytes, picture) = full(&pixels, &operator(&pixels, 6), Precision::Half);
    assert!(read_full(&bytes).is_ok());
    let text = picture.header.to_json();
    let more = text.replacen('{', "{\"camera\":{\"iso\":200},", 1);
    let header = Header::from_json(&more).unwrap();
    assert!(header.to_json().contains("\"camera\":{\"iso\":200}"));
    let newer = text.replace("\"version\":1", "\"version\":2");
    let said = Header::from_json(&newer).unwrap_err().to_string();
    assert_eq!(said, "expected version 1 to 1, found version 2");
}

#[test]
fn cancelling_leaves_nothing_to_be_taken_for_a_file() {
    let pixels = wall(60, 60);
    let operator = operator(&pixels, 6);
    let progress = quiet();
    progress.cancel();
    let survey = Survey::of(&pixels, &quiet()).unwrap();
    let plan = compact_plan(&pixels, &operator, &survey.sample, 0.5, 1.0, &quiet()).unwrap();
    let stopped = write_compact(
        &mut Vec::new(),
        &pixels,
        &operator,
        &plan,
        &about(),
        Coder::Simple,
        &progress,
    );
    assert_eq!(stopped.unwrap_err(), PictureError::Cancelled);
    assert_eq!(
        Survey::of(&pixels, &progress).unwrap_err(),
        PictureError::Cancelled
    );
}

#[test]
fn a_bright_picture_does_not_overflow_halves() {
    let bands = Bands::new(nm(12), Kind::Light).unwrap();
    let values = (0..12 * 100)
        .map(|i| 1e7 * (1.0 + (i % 7) as f32))
        .collect();
    let pixels = InMemory::new(10, 10, bands, values).unwrap();
    let operator = Operator::new(pixels.bands(), &Plan::new(pixels.bands(), 6)).unwrap();
    let (bytes, picture) = full(&pixels, &operator, Precision::Half);
    let back = read_full(&bytes).unwrap();
    assert!(back.header.scale > 1.0);
    assert!(back.planes.iter().all(|z| z.is_finite()));
    same_bits(&back, &picture);
}

proptest! {
    #[test]
    fn any_header_of_any_numbers_is_refused_or_safe(
        width in 0_usize..usize::MAX, numbers in 0_usize..300, series in 0_usize..300, scale in any::<f64>(),
    ) {
        let pixels = wall(8, 8);
        let operator = operator(&pixels, 5);
        let mut header = Header::of(&operator, (8, 8), &about(), Errors::default());
        header.width = width;
        header.numbers = numbers;
        header.series = series;
        header.scale = scale;
        if let Ok(header) = Header::from_json(&header.to_json()) {
            prop_assert!(header.operator().is_ok());
        }
    }
}
