//! Measured tables and the ranges they are modelled on: reading between samples, averaging fine
//! data, going on outside a table, and refusing what is not a spectrum.

use super::common::{on_band, shipped, values};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use proptest::prelude::*;
use spectral_explorer::spectrum::{
    Band, BandError, Kind, LONGEST_NM, Line, MOST_STEPS, Outside, SHORTEST_NM, Sampled,
    SampledError, add_lines,
};

const BAND: Band = Band::VISIBLE;

fn table(nm: &[f64], values: &[f64]) -> Sampled {
    Sampled::new(nm.to_vec(), values.to_vec()).expect("a rising table")
}

#[test]
fn what_is_not_a_spectrum_is_refused_with_its_place() {
    let refused = |nm: &[f64], values: &[f64]| {
        Sampled::new(nm.to_vec(), values.to_vec()).expect_err("not a spectrum")
    };
    let lengths = SampledError::Lengths {
        wavelengths: 3,
        values: 2,
    };
    assert_eq!(refused(&[1.0, 2.0, 3.0], &[1.0, 2.0]), lengths);
    for few in [&[][..], &[500.0]] {
        let found = few.len();
        assert_eq!(refused(few, few), SampledError::TooFew { found });
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let index = 1;
        let not_finite = SampledError::NotFinite { index };
        assert_eq!(refused(&[1.0, bad, 3.0], &[0.0; 3]), not_finite);
        assert_eq!(refused(&[1.0, 2.0, 3.0], &[0.0, bad, 0.0]), not_finite);
    }
    for again in [500.0, 499.0] {
        let not_rising = SampledError::NotRising {
            index: 2,
            found_nm: again,
            after_nm: 500.0,
        };
        let error = refused(&[400.0, 500.0, again], &[0.0; 3]);
        assert_eq!(error, not_rising);
        let words = error.to_string();
        assert!(
            words.contains("point 3") && words.contains("500 nm"),
            "{words}"
        );
    }
}

#[test]
fn a_range_that_cannot_be_modelled_is_refused() {
    for (min_nm, max_nm, found) in [
        (380.5, 780.0, 380.5),
        (380.0, f64::INFINITY, f64::INFINITY),
        (-1.0, 780.0, -1.0),
    ] {
        assert_eq!(
            Band::new(min_nm, max_nm),
            Err(BandError::NotWhole { found })
        );
    }
    assert!(Band::new(f64::NAN, 780.0).is_err());
    let shortest = f64::from(SHORTEST_NM);
    for (min_nm, max_nm) in [(780.0, 380.0), (500.0, 500.0), (380.0, 379.0 + shortest)] {
        let too_short = BandError::TooShort { min_nm, max_nm };
        assert_eq!(Band::new(min_nm, max_nm), Err(too_short));
    }
    assert!(Band::new(380.0, 380.0 + shortest).is_ok());
    let (most, longest) = (f64::from(MOST_STEPS), f64::from(LONGEST_NM));
    assert!(Band::new(longest - most, longest).is_ok());
    for (min_nm, max_nm) in [(0.0, most + 1.0), (longest - 20.0, longest + 1.0)] {
        let too_long = BandError::TooLong { min_nm, max_nm };
        assert_eq!(Band::new(min_nm, max_nm), Err(too_long));
    }
    // A project file goes through the same gate.
    assert_eq!(serde_json::from_str::<Band>("[380,780]").ok(), Some(BAND));
    assert!(serde_json::from_str::<Band>("[380,381]").is_err());
}

#[test]
fn a_range_counts_its_grid_from_end_to_end() {
    assert_eq!((BAND.steps(), BAND.points()), (400, 401));
    assert_eq!((BAND.nm(0), BAND.nm(400)), (380.0, 780.0));
    assert!(BAND.contains(380.0) && BAND.contains(780.0));
    assert!(!BAND.contains(379.999) && !BAND.contains(f64::NAN));
    let ones = vec![1.0; 401];
    assert_eq!(BAND.integral(&ones), BAND.length_nm());
    let weights: f64 = (0..401).map(|i| BAND.weight(i)).sum();
    assert_eq!(weights, BAND.length_nm());
    // The trapezoid rule is exact for a straight line.
    let line: Vec<f64> = BAND.grid().collect();
    assert_eq!(BAND.integral(&line), (780.0 * 780.0 - 380.0 * 380.0) / 2.0);
    assert_eq!(BAND.inner(&line, &ones), BAND.integral(&line));
    assert_eq!(BAND.interpolate(&line, 546.25), 546.25);
    assert_eq!(BAND.interpolate(&line, 780.0), 780.0);
    assert_eq!(BAND.interpolate(&line, 780.5), 0.0);
}

#[test]
fn between_samples_a_spectrum_is_straight_and_on_them_exact() {
    let sampled = table(&[400.0, 403.0, 420.0], &[1.0, 4.0, -2.5]);
    for (nm, value) in sampled.nm().iter().zip(sampled.values()) {
        assert_eq!(sampled.at(*nm, Outside::Zero), *value);
    }
    assert_eq!(sampled.at(401.5, Outside::Zero), 2.5);
    // One product and one sum.
    assert_abs_diff_eq!(sampled.at(411.5, Outside::Zero), 0.75, epsilon = 1e-15);
    assert_eq!(
        sampled.on_whole_nm(400, 403, Outside::Zero),
        [1.0, 2.0, 3.0, 4.0]
    );
    assert_eq!(sampled.step_nm(), 17.0, "the upper of two steps");
}

#[test]
fn outside_its_table_a_light_is_dark_and_a_reflectance_goes_on() {
    let sampled = table(&[400.0, 700.0], &[0.25, 0.75]);
    for kind in Kind::ALL {
        let (below, above) = match kind {
            Kind::Reflectance | Kind::Transmittance => (0.25, 0.75),
            _ => (0.0, 0.0),
        };
        let outside = kind.outside();
        assert_eq!(sampled.at(399.9, outside), below, "{kind}");
        assert_eq!(sampled.at(700.1, outside), above, "{kind}");
        let grid = sampled.on_band(BAND, outside);
        assert_eq!((grid[0], grid[400]), (below, above), "{kind}");
        assert_eq!((grid[20], grid[320]), (0.25, 0.75), "the ends themselves");
    }
}

#[test]
fn data_at_1_nm_or_coarser_is_read_off_not_averaged() {
    let zigzag: Vec<f64> = (0..401).map(|i| f64::from(i % 2)).collect();
    let sampled = Sampled::even(380.0, 1.0, zigzag.clone()).expect("a rising grid");
    assert_eq!(sampled.on_band(BAND, Outside::Zero), zigzag);
    let five = shipped("cie_fluorescent_5nm/FL2");
    let grid = values(five, BAND);
    for (nm, value) in five.samples.nm().iter().zip(five.samples.values()) {
        assert_eq!(grid[(nm - 380.0) as usize], *value);
    }
}

#[test]
fn a_narrow_line_between_two_grid_points_keeps_its_power() {
    // A line 0.2 nm wide and 5 high, its area 1, at a tenth of a nm: picking samples at whole nm
    // would see all of it or nothing.
    for tenth in 0..=20_usize {
        let centre = 500 + tenth;
        let values = (0..1001).map(|i| if i == centre { 10.0 } else { 0.0 });
        let sampled = Sampled::even(480.0, 0.1, values.collect()).expect("a rising grid");
        let grid = sampled.on_band(BAND, Outside::Zero);
        // Exact but for the rounding of 0.1 nm steps: its power, and where it stands.
        assert_abs_diff_eq!(BAND.integral(&grid), 1.0, epsilon = 1e-9);
        let moment: f64 = BAND.grid().zip(&grid).map(|(nm, v)| nm * v).sum();
        assert_abs_diff_eq!(moment, 480.0 + 0.1 * centre as f64, epsilon = 1e-6);
        let lit = grid.iter().filter(|v| **v > 1e-9).count();
        assert!(lit <= 3, "a line between two nm stays there: {lit}");
    }
}

#[test]
fn fine_data_keep_their_area_about_every_nm() {
    // A parabola at 0.25 nm steps: each grid value is the mean of what falls to it, the nearer the
    // more, which differs from the value in the middle by a known amount.
    let value = |nm: f64| (nm - 500.0) * (nm - 500.0);
    let fine: Vec<f64> = (0..=400)
        .map(|i| value(450.0 + 0.25 * f64::from(i)))
        .collect();
    let sampled = Sampled::even(450.0, 0.25, fine).expect("a rising grid");
    let band = Band::new(460.0, 540.0).expect("80 nm");
    let grid = sampled.on_band(band, Outside::Zero);
    for (nm, found) in band.grid().zip(&grid).skip(1).take(79) {
        // Mean of x^2 under a triangle of +-1 is x^2 + 1/6; straight pieces of 1/4 nm add
        // (1/4)^2 / 6.
        let expected = value(nm) + 1.0 / 6.0 + 0.0625 / 6.0;
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-9);
    }
    // The ends stand for the half nm inside: the integral is that of the fine data.
    let straight: f64 = (40..360)
        .map(|i| [i, i + 1].map(|i| value(450.0 + 0.25 * f64::from(i))))
        .map(|[a, b]| 0.125 * (a + b))
        .sum();
    assert_relative_eq!(band.integral(&grid), straight, max_relative = 1e-13);
}

#[test]
fn fine_data_are_averaged_over_what_their_table_covers() {
    // From 380.2 to 450.1 nm: the first and the last nm are covered in part only.
    let sampled = Sampled::even(380.2, 0.1, vec![2.0; 700]).expect("a rising grid");
    let grid = sampled.on_band(BAND, Outside::Zero);
    for (nm, found) in BAND.grid().zip(grid) {
        // What the table covers of the triangle about a grid point it does not reach.
        let expected = match nm {
            380.0 => 2.0 * 0.5 * 0.8 * 0.8,
            381.0 => 2.0 * (0.5 + 0.8 - 0.5 * 0.8 * 0.8),
            450.0 => 2.0 * (0.5 + 0.1 - 0.5 * 0.1 * 0.1),
            451.0 => 2.0 * 0.5 * 0.1 * 0.1,
            382.0..=449.0 => 2.0,
            _ => 0.0,
        };
        // Ten pieces of 0.1 nm, and the first grid point counts for the half nm inside the band.
        let expected = if nm == 380.0 {
            2.0 * expected
        } else {
            expected
        };
        assert_abs_diff_eq!(found, expected, epsilon = 1e-10);
    }
}

#[test]
fn a_table_of_half_and_whole_nm_is_averaged_only_where_it_is_fine() {
    // ASTM G173 steps by 0.5 nm up to 400 nm and by 1 nm beyond.
    let sun = &shipped("solar_astm_g173/ASTM G173-03 direct+circumsolar AM1.5D").samples;
    let steps = |from_nm: f64, to_nm: f64| {
        let pairs = sun.nm().windows(2);
        let inside = pairs.filter(move |p| p[0] >= from_nm && p[1] <= to_nm);
        inside.map(|p| p[1] - p[0]).collect::<Vec<_>>()
    };
    assert!(steps(300.0, 400.0).iter().all(|step| *step == 0.5));
    assert!(steps(400.0, 900.0).iter().all(|step| *step == 1.0));
    let value = |nm: f64| sun.at(nm, Outside::Zero);
    let grid = sun.on_band(BAND, Outside::Zero);
    for nm in [385.0, 393.0, 399.0] {
        // Straight lines over the two half steps on either side, under a triangle.
        let beside = |half: f64| value(nm - half) + value(nm + half);
        let expected = (10.0 * value(nm) + 6.0 * beside(0.5) + beside(1.0)) / 24.0;
        let found = grid[(nm - 380.0) as usize];
        assert_relative_eq!(found, expected, max_relative = 1e-12);
        assert!(
            (found / value(nm) - 1.0).abs() > 1e-4,
            "the sun is not straight here"
        );
    }
    for nm in [401.0, 546.0, 780.0] {
        assert_eq!(grid[(nm - 380.0) as usize], value(nm));
    }
}

#[test]
fn a_spike_between_two_nm_is_split_without_loss() {
    for at_nm in [380.0, 380.25, 404.7, 546.5, 779.5, 780.0] {
        let mut grid = vec![0.0; BAND.points()];
        let spike = Line::ideal(at_nm, -3.0);
        add_lines(BAND, &[spike], &mut grid);
        // Two shares that add up to one.
        assert_abs_diff_eq!(BAND.integral(&grid), -3.0, epsilon = 1e-14);
        let moment: f64 = (0..grid.len())
            .map(|i| BAND.weight(i) * grid[i] * BAND.nm(i))
            .sum();
        // Near 800, a few roundings.
        assert_abs_diff_eq!(moment / -3.0, at_nm, epsilon = 1e-11);
        assert_eq!(
            grid.iter().filter(|v| **v != 0.0).count(),
            1 + usize::from(at_nm.fract() != 0.0)
        );
    }
    let mut grid = on_band("CIE D65", BAND);
    let before = grid.clone();
    for at_nm in [379.9, 780.1, f64::NAN] {
        add_lines(BAND, &[Line::ideal(at_nm, 1.0)], &mut grid);
    }
    assert_eq!(grid, before, "outside the range nothing is added");
}

#[test]
fn scaling_multiplies_every_value_and_no_wavelength() {
    let light = &shipped("CIE D65").samples;
    let half = light.scaled(0.5);
    assert_eq!(half.nm(), light.nm());
    assert!(
        half.values()
            .iter()
            .zip(light.values())
            .all(|(h, v)| *h == 0.5 * v)
    );
}

/// Any rising table from 0.05 to 12 nm steps that covers 400-440 nm.
fn any_table() -> impl Strategy<Value = Sampled> {
    let step = prop_oneof![0.05..0.9_f64, 0.9..1.1_f64, 1.1..12.0_f64];
    prop::collection::vec((step, -1.0..2.0_f64), 80..400).prop_map(|points| {
        let (mut nm, mut values) = (vec![380.0], vec![0.5]);
        for (step, value) in points {
            nm.push(nm[nm.len() - 1] + step);
            values.push(value);
        }
        Sampled::new(nm, values).expect("rising and finite")
    })
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(173),
        ..ProptestConfig::default()
    })]

    #[test]
    fn on_any_grid_a_value_lies_between_the_samples_around_it(sampled in any_table()) {
        let band = Band::new(400.0, 440.0).expect("40 nm");
        for (at_nm, found) in band.grid().zip(sampled.on_band(band, Outside::Zero)) {
            if at_nm >= sampled.last_nm() + 1.0 {
                prop_assert_eq!(found, 0.0);
                continue;
            }
            // The dark beyond the table's end fills a value in part.
            let dark = if at_nm + 1.0 > sampled.last_nm() { 0.0 } else { f64::NAN };
            // Every sample within a nm, and one beyond on either side.
            let first = sampled.nm().partition_point(|nm| *nm < at_nm - 1.0).saturating_sub(1);
            let last = sampled.nm().partition_point(|nm| *nm <= at_nm + 1.0);
            let near = &sampled.values()[first..=last.min(sampled.len() - 1)];
            let low = near.iter().copied().fold(dark, f64::min);
            let high = near.iter().copied().fold(dark, f64::max);
            // An average of numbers up to 2, rounded once a sample.
            prop_assert!((low - 1e-12..=high + 1e-12).contains(&found), "{} at {}", found, at_nm);
        }
    }
}
