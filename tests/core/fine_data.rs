//! Data finer than 1 nm: what every place that shows a colour makes of lines narrower than a nm,
//! against the integral of the fine data themselves.

use std::{f64::consts::LN_2, sync::Arc};

use proptest::prelude::*;
use spectral_explorer::{
    app::{App, Document, Entry, Library, Scale, makers, picture::BandWeights},
    color::{Observer, Xyz, cct_from_xyz, xyz_from_light, xyz_from_reflectance},
    io::{MakersResult, Quantity},
    spectrum::{
        Cube, Kind, NamedSpectrum, Outside, Sampled, SpectralImage,
        cube::{Interleave, Layout, Number},
    },
};

fn bell(nm: f64, at_nm: f64, width_nm: f64) -> f64 {
    (-4.0 * LN_2 * ((nm - at_nm) / width_nm).powi(2)).exp()
}

/// A glow and five lines of one width on 380-780 nm.
fn lamp(step_nm: f64, width_nm: f64, lines_nm: [f64; 5]) -> Sampled {
    let points = (400.0 / step_nm).round() as usize + 1;
    let heights = [3.0, 7.0, 10.0, 4.0, 6.0];
    let value = |nm: f64| {
        let lines = lines_nm.iter().zip(heights);
        let lines: f64 = lines.map(|(at, h)| h * bell(nm, *at, width_nm)).sum();
        0.02 + 0.05 * bell(nm, 560.0, 120.0) + lines / width_nm
    };
    let values = (0..points).map(|i| value(380.0 + step_nm * i as f64));
    Sampled::even(380.0, step_nm, values.collect()).expect("a rising grid")
}

/// Steps of .01 to .38 nm, widths of .05 to 1 nm, lines on whole nm and off them.
fn lamps() -> impl Iterator<Item = (String, Sampled)> {
    let on = [405.0, 436.0, 546.0, 578.0, 612.0];
    let off = [404.656, 435.833, 546.5, 577.25, 611.7];
    [0.01, 0.05, 0.1, 0.2, 0.25, 0.31, 0.38]
        .into_iter()
        .flat_map(|step| [0.05, 0.1, 0.3, 1.0].map(|width| (step, width)))
        .flat_map(move |(step, width)| [on, off].map(|lines| (step, width, lines)))
        .map(|(step, width, lines)| {
            let name = format!("{step} nm steps, lines {width} nm wide, {lines:?}");
            (name, lamp(step, width, lines))
        })
}

/// XYZ of a product of straight lines, piece by piece: Simpson's rule is exact for the products of
/// two and three of them.
fn integral(samples: &Sampled, factor: impl Fn(f64) -> f64, observer: Observer) -> Xyz {
    let table = observer.table();
    let mut sum = [0.0; 3];
    for (left, w) in samples.nm().windows(2).enumerate() {
        // The observer's own whole nm are corners too.
        let corner = w[1].floor();
        let cuts = if corner > w[0] && corner < w[1] {
            vec![w[0], corner, w[1]]
        } else {
            w.to_vec()
        };
        for piece in cuts.windows(2) {
            let (a, b) = (piece[0], piece[1]);
            let value = |nm: f64| {
                let t = (nm - w[0]) / (w[1] - w[0]);
                samples.values()[left] * (1.0 - t) + samples.values()[left + 1] * t
            };
            for (k, sum) in sum.iter_mut().enumerate() {
                let at = |nm: f64| value(nm) * factor(nm) * table.at(nm)[k];
                *sum += (b - a) / 6.0 * (at(a) + 4.0 * at(0.5 * (a + b)) + at(b));
            }
        }
    }
    Xyz::from_array(sum)
}

/// A ten thousandth: what is left is the half step that a table is taken to reach beyond its ends.
const RELATIVE: f64 = 1e-4;

/// Bluer than this no lamp is, a kelvin is nothing, and XYZ say it better.
const BLUEST_KELVIN: f64 = 20_000.0;

#[track_caller]
fn same(found: Xyz, expected: Xyz, place: &str) {
    let scale = expected.y / found.y;
    let (f, e) = (found.scaled(scale).to_array(), expected.to_array());
    for (f, e) in f.iter().zip(e) {
        assert!(
            (f / e - 1.0).abs() < RELATIVE,
            "{place}: {found:?}, expected {expected:?}"
        );
    }
    let cct = |xyz| cct_from_xyz(xyz).map(|cct| cct.kelvin);
    if let (Ok(found), Ok(expected)) = (cct(found), cct(expected))
        && expected < BLUEST_KELVIN
    {
        assert!(
            (found - expected).abs() < 1.0,
            "{place}: {found} K, expected {expected} K"
        );
    }
}

fn named(samples: Sampled, kind: Kind) -> NamedSpectrum {
    NamedSpectrum {
        name: "lamp".to_owned(),
        kind,
        unit: "W m-2 nm-1".to_owned(),
        scale: 1.0,
        samples,
        notes: Vec::new(),
        source: String::new(),
    }
}

fn plain(_: f64) -> f64 {
    1.0
}

#[test]
fn the_colour_of_a_light_is_that_of_its_fine_data() {
    for (name, samples) in lamps() {
        for observer in Observer::CIE {
            let found = xyz_from_light(&samples, Outside::Zero, observer).expect("a light");
            same(
                found,
                integral(&samples, plain, observer),
                &format!("{name}, {observer:?}"),
            );
        }
    }
}

#[test]
fn both_colours_of_the_panel_are_those_of_the_fine_data() {
    for (name, samples) in lamps() {
        let expected = integral(&samples, plain, Observer::CIE_1931);
        let entry = Entry::own(1, named(samples, Kind::Light));
        let app = App::with_document(Document::about(Arc::new(entry)));
        let colour = &app.derived().colour;
        for (place, found) in [("exact", &colour.exact), ("360-830", &colour.full)] {
            let found = found.as_ref().expect("a light").xyz;
            same(found, expected, &format!("{name}, {place}"));
        }
    }
}

#[test]
fn the_scales_and_the_makers_comparison_weigh_the_fine_data() {
    for (name, samples) in lamps() {
        let expected = integral(&samples, plain, Observer::CIE_1931);
        let mut entry = Entry::own(1, named(samples, Kind::Light));
        let y = Scale::LuminanceHundred
            .factor(&entry.spectrum)
            .expect("a light")
            * expected.y;
        assert!((y / 100.0 - 1.0).abs() < RELATIVE, "{name}: Y {y}");
        let result = |quantity, unit: &str| MakersResult {
            spectrum: Some(0),
            quantity,
            value: 1.0,
            unit: unit.to_owned(),
            as_written: String::new(),
        };
        entry.makers = vec![
            result(Quantity::Illuminance, "lx"),
            result(Quantity::Cct, "K"),
        ];
        let ours: Vec<_> = makers::beside(&entry).iter().map(|b| b.ours).collect();
        let lux = ours[0].expect("lux");
        assert!(
            (lux / (683.002 * expected.y) - 1.0).abs() < RELATIVE,
            "{name}: {lux} lx"
        );
        if let (Ok(kelvin), Ok(expected)) = (ours[1], cct_from_xyz(expected))
            && expected.kelvin < BLUEST_KELVIN
        {
            let off = (kelvin - expected.kelvin).abs();
            assert!(off < 1.0, "{name}: {kelvin} K");
        }
    }
}

#[test]
fn reflectances_and_pictures_are_seen_by_the_fine_data() {
    let grey = Sampled::new(vec![360.0, 830.0], vec![0.2, 0.7]).expect("two points");
    for (name, samples) in lamps() {
        let factor = |nm: f64| grey.at(nm, Outside::Hold);
        let expected = integral(&samples, factor, Observer::CIE_1931);
        let found = xyz_from_reflectance(&grey, &samples, Observer::CIE_1931).expect("a light");
        same(found, expected, &format!("{name}, a grey under it"));
        let picture =
            BandWeights::of(&image(Kind::Light), Observer::CIE_1931, None, false).expect("an eye");
        let whole = integral(&samples, plain, Observer::CIE_1931);
        same(
            picture.xyz(&samples),
            whole,
            &format!("{name}, a pixel of a picture"),
        );
        let light = named(samples, Kind::Light);
        let under = BandWeights::of(
            &image(Kind::Reflectance),
            Observer::CIE_1931,
            Some(&light),
            false,
        );
        let seen = under.expect("a light").xyz(&grey);
        same(seen, expected, &format!("{name}, a pixel under it"));
    }
}

fn image(kind: Kind) -> SpectralImage {
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Bands,
        stored_bands: 2,
        missing: None,
    };
    let bands = [(400.0, 0), (700.0, 1)];
    SpectralImage {
        name: "two bands".to_owned(),
        kind,
        unit: String::new(),
        scale: 1.0,
        bandwidth_nm: None,
        cube: Cube::new(1, 1, &bands, layout, Arc::new(vec![0; 8])).expect("a sound cube"),
        notes: Vec::new(),
        source: String::new(),
    }
}

#[test]
fn shipped_tables_of_whole_nm_are_read_off_and_not_averaged() {
    for spectrum in Library::bundled().spectra() {
        let nm = spectrum.samples.nm();
        if nm.iter().any(|nm| nm.fract() != 0.0) {
            continue;
        }
        let outside = spectrum.kind.outside();
        for (nm, value) in (360..=830).zip(spectrum.samples.on_whole_nm(360, 830, outside)) {
            let read = spectrum.samples.at(f64::from(nm), outside);
            assert_eq!(value, read, "{} at {nm} nm", spectrum.name);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    /// Data of any steps, moved a little: no value of the grid moves by more than the samples did,
    /// and the area between the grid's ends is that of the straight lines.
    #[test]
    fn what_is_put_on_the_grid_follows_its_samples_without_a_jump(
        steps in proptest::collection::vec(prop_oneof![0.05..0.4_f64, Just(1.0), 0.8..3.0_f64], 8..40),
        heights in proptest::collection::vec(0.0..1.0_f64, 41),
        start in prop_oneof![Just(400.0), 400.0..401.0_f64],
        by in -1e-7..1e-7_f64,
    ) {
        let places = |by: f64| -> Vec<f64> {
            let mut nm = vec![start + by];
            nm.extend(steps.iter().scan(start + by, |at, step| { *at += step; Some(*at) }));
            nm
        };
        let of = |by: f64| {
            let nm = places(by);
            let values = heights[..nm.len()].to_vec();
            Sampled::new(nm, values).expect("rising").on_grid(390.0, 1.0, 140, Outside::Zero)
        };
        let (here, moved) = (of(0.0), of(by));
        for (a, b) in here.iter().zip(&moved) {
            // Slopes of up to 1 in .05 nm, on either side of a grid point.
            prop_assert!((a - b).abs() <= 60.0 * by.abs() + 1e-12, "{} {}", a, b);
        }
        let (nm, last) = (places(0.0), steps.len());
        let area: f64 = nm
            .windows(2)
            .zip(heights.windows(2))
            .map(|(at, value)| 0.5 * (at[1] - at[0]) * (value[0] + value[1]))
            .sum();
        // An end counts for half its own step more where it stands on a grid point, the more the
        // nearer.
        let more = |at: usize, step: f64| {
            let on_it = (1.0 - 25.0 * (nm[at] - nm[at].round()).abs()).max(0.0);
            0.5 * step.min(1.0) * on_it * heights[at]
        };
        let counted = area + more(0, steps[0]) + more(last, steps[last - 1]);
        prop_assert!((here.iter().sum::<f64>() - counted).abs() < 1e-9);
    }
}

#[test]
fn a_label_that_is_rounded_takes_nothing_from_a_peak() {
    for by in [-0.001, -1e-5, -1e-12, 0.0, 1e-12, 1e-5, 0.001] {
        let nm: Vec<f64> = (0..11).map(|i| 540.0 + f64::from(i) + by).collect();
        let peak = (0..11).map(|i| f64::from(u8::from(i == 5))).collect();
        let grid = Sampled::new(nm, peak)
            .expect("rising")
            .on_grid(530.0, 1.0, 31, Outside::Zero);
        // As far from the peak as the samples are from the grid: the slope is 1 a nm.
        // As its neighbours are joined over the label, up to two thirds of that more.
        let most = (1.0 + 2.0 / 3.0) * by.abs() + 1e-9;
        assert!((grid[15] - 1.0).abs() <= most, "{by}: {}", grid[15]);
        assert!((grid.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{by}");
    }
}

#[test]
fn a_narrow_table_on_whole_nm_gains_no_more_than_half_its_own_steps() {
    // From 546.0 to 546.2 nm in .1 nm: .2 of area, and half a step of .1 at the end on whole nm.
    let table = Sampled::even(546.0, 0.1, vec![1.0; 3]).expect("rising");
    let grid = table.on_grid(540.0, 1.0, 21, Outside::Zero);
    let sum: f64 = grid.iter().sum();
    assert!((sum - 0.25).abs() < 1e-12, "{sum}");
}
