//! Chains of products, errors against bounces, narrow filters, two lights and the reflection check, on the
//! shipped lights and reflectances; figures with
//! `cargo test --lib core_tests::products_chain:: -- --nocapture`.

use super::{
    common::{on_band, values},
    lights,
};
use spectral_explorer::{
    app::Library,
    color::{Observer, Weights},
    preset::Shelf,
    spectrum::{
        Band, Basis, BasisTable, ChainTables, Composite, Factor, Line, Sampling, Series,
        SpikeSettings, add_lines, bounces, detect, glass,
        product::{chain_points, convolve, folded_share},
    },
    study::{
        Progress,
        error::Spread,
        products::{
            BounceErrors, Checker, MATCH_DELTA_E, Narrow, Product, Reflection, SAME_RESIDUAL,
            bounce_errors, metameric_black, metameric_pairs, two_lights,
        },
    },
};

const BAND: Band = Band::VISIBLE;

fn observer() -> Weights {
    Observer::CIE_1931.table().on_band(BAND)
}

fn series(values: &[f64], basis: Basis, numbers: usize) -> Series {
    Series {
        band: BAND,
        basis,
        coefficients: BasisTable::new(BAND, basis, numbers).project(values, numbers),
    }
}

/// The program's model of a light: lines as spikes, the rest as a series.
fn fitted(values: &[f64], basis: Basis, numbers: usize) -> Composite {
    let parts = detect(BAND, values, SpikeSettings::default());
    Composite::of_lines_inside(
        series(&parts.smooth, basis, numbers),
        parts.spikes.iter().map(|found| found.spike).collect(),
    )
}

fn factor(name: &str) -> Factor {
    Factor::new(on_band(name, BAND))
}

/// Reflectances of a shipped group.
fn group(id: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let group = Library::bundled().group(id).expect("shipped");
    let spectra = group.items.iter().filter_map(|item| item.spectrum());
    spectra.map(|s| (s.name.clone(), values(s, BAND))).unzip()
}

fn multiply(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a * b).collect()
}

/// The largest difference between two curves as a share of the first one's largest value.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let top = a.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max) / top
}

fn three_factors() -> [Factor; 3] {
    [
        "colorchecker_ohta/red",
        "filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm",
        "colorchecker_ohta/blue",
    ]
    .map(factor)
}

#[test]
fn a_factor_of_one_changes_nothing_in_any_way() {
    let measured = on_band("FL2", BAND);
    let one = Factor::new(vec![1.0; BAND.points()]);
    for basis in Basis::ALL {
        let light = fitted(&measured, basis, 15);
        for sampling in Sampling::ALL {
            let chain = vec![one.clone(); 6];
            let stages = ChainTables::for_light(&light, sampling, 6).pass(&light, &chain);
            for stage in &stages {
                // Six transforms there and back of numbers near the light's own.
                let miss = apart(&light.smooth().on_band(), &stage.smooth);
                assert!(miss < 1e-12, "{basis:?} {sampling:?} {miss:e}");
                assert!(stage.folded_share < 1e-20);
                for (before, after) in light.lines().iter().zip(&stage.spikes) {
                    assert_eq!(before.at_nm, after.at_nm);
                    // The series of 1 is 1 but for the rounding of its projection.
                    assert!((after.weight / before.weight - 1.0).abs() < 1e-12);
                }
            }
        }
    }
}

#[test]
fn the_order_of_the_factors_does_not_matter_where_nothing_is_cut_in_between() {
    let light = fitted(&on_band("FL11", BAND), Basis::Cosine, 15);
    let factors = three_factors();
    let mut turned = factors.clone();
    turned.rotate_left(1);
    for sampling in [Sampling::Exact, Sampling::Double, Sampling::Paper] {
        let tables = ChainTables::for_light(&light, sampling, 3);
        let (a, b) = (
            tables.pass(&light, &factors).pop().expect("three stages"),
            tables.pass(&light, &turned).pop().expect("three stages"),
        );
        // The same three products, rounded in another order; a transform of 30 numbers.
        assert!(apart(&a.smooth, &b.smooth) < 1e-13, "{sampling:?}");
        for (a, b) in a.spikes.iter().zip(&b.spikes) {
            assert!((a.weight / b.weight - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn two_panes_of_half_the_thickness_are_one_pane() {
    let light = fitted(&on_band("FL2", BAND), Basis::Fourier, 15);
    let pane = on_band("filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm", BAND);
    let half = Factor::new(glass(&pane, 0.5));
    let tables = ChainTables::for_light(&light, Sampling::Exact, 2);
    let two = tables.pass(&light, &[half.clone(), half]);
    let one = tables.pass(&light, &[Factor::new(pane)]);
    // A root and a square of numbers below 1.
    assert!(apart(&one[0].smooth, &two[1].smooth) < 1e-14);
    for (one, two) in one[0].spikes.iter().zip(&two[1].spikes) {
        // Between two nm the straight line runs over the root here and over the pane there:
        // 1e-3 is what the curvature of this glass makes of it.
        assert!((one.weight / two.weight - 1.0).abs() < 1e-3);
    }
}

#[test]
fn k_bounces_are_k_equal_stages() {
    let light = fitted(&on_band("FL2", BAND), Basis::Fourier, 15);
    let surface = on_band("colorchecker_ohta/red", BAND);
    let tables = ChainTables::for_light(&light, Sampling::Exact, 8);
    let stages = tables.pass(&light, &vec![Factor::new(surface.clone()); 8]);
    for (k, stage) in stages.iter().enumerate() {
        let at_once = Factor::new(bounces(&surface, k as u32 + 1));
        let one = &tables.pass(&light, &[at_once])[0];
        // Eight multiplications against one power.
        assert!(apart(&one.smooth, &stage.smooth) < 1e-14, "K = {}", k + 1);
    }
}

#[test]
fn the_weights_of_spikes_multiply_exactly_in_every_way() {
    let factors = three_factors();
    for basis in Basis::ALL {
        let light = fitted(&on_band("FL11", BAND), basis, 15);
        assert!(light.lines().len() > 2);
        let mut by_series = Vec::new();
        for sampling in Sampling::ALL {
            let stages = ChainTables::for_light(&light, sampling, 3).pass(&light, &factors);
            for (i, spike) in light.lines().iter().enumerate() {
                let mut weight = spike.weight;
                for (stage, factor) in stages.iter().zip(&factors) {
                    let share = match sampling {
                        Sampling::Exact => BAND.interpolate(factor.values(), spike.at_nm),
                        _ => series(factor.values(), basis, 15).at(spike.at_nm),
                    };
                    weight *= share;
                    // The series is projected by another sum here: rounding only.
                    let found = stage.spikes[i].weight;
                    assert!((found - weight).abs() <= 1e-12 * spike.weight.abs());
                }
            }
            if sampling != Sampling::Exact {
                by_series.push(stages[2].spikes.clone());
            }
        }
        // No resampling touches a spike.
        assert!(by_series.iter().all(|spikes| *spikes == by_series[0]));
    }
}

#[test]
fn the_power_behind_a_factor_is_the_lights_power_weighed_by_it() {
    let measured = on_band("FL2", BAND);
    let factor = factor("colorchecker_ohta/red");
    for basis in Basis::ALL {
        let light = fitted(&measured, basis, 15);
        let short = series(factor.values(), basis, 15);
        let power = light.integrate(|nm| short.at(nm));
        for sampling in [Sampling::FourN, Sampling::Double, Sampling::Convolution] {
            let stage = &ChainTables::for_light(&light, sampling, 1)
                .pass(&light, std::slice::from_ref(&factor))[0];
            let lines: f64 = stage.spikes.iter().map(|spike| spike.weight).sum();
            let found = BAND.integral(&stage.smooth) + lines;
            let is_exact = basis == Basis::Fourier || sampling != Sampling::FourN;
            // The mean of the product is kept even where higher orders are cut.
            assert!(
                !is_exact || (found / power - 1.0).abs() < 1e-12,
                "{basis:?} {sampling:?}"
            );
        }
    }
}

#[test]
fn the_alias_meter_of_a_chain_is_that_of_one_product_and_rises_with_its_length() {
    let measured = on_band("CIE A", BAND);
    let red = factor("colorchecker_ohta/red");
    for basis in Basis::ALL {
        let light = fitted(&measured, basis, 15);
        let short = series(red.values(), basis, 15);
        for sampling in Sampling::ALL {
            let tables = ChainTables::for_light(&light, sampling, 4);
            let stages = tables.pass(&light, &vec![red.clone(); 4]);
            let points = tables.points().unwrap_or(15);
            let one = folded_share(light.smooth(), &short, points);
            let found = stages[0].folded_share;
            if sampling == Sampling::Exact {
                assert!(stages.iter().all(|stage| stage.folded_share == 0.0));
            } else {
                // The chain's series are scaled to 1 first: rounding only.
                assert!((found - one).abs() <= 1e-9 * one, "{found} {one}");
                assert!(stages[3].folded_share > stages[0].folded_share);
            }
        }
        let whole = convolve(light.smooth(), &short);
        assert!(whole.coefficients.len() <= chain_points(15, 1));
    }
}

fn product<'a>(
    measured: &'a [f64],
    model: &'a Composite,
    sampling: Sampling,
    seen: &'a Weights,
) -> Product<'a> {
    Product {
        measured,
        model,
        sampling,
        seen,
        width_nm: 10.0,
    }
}

#[test]
fn the_stages_multiply_to_the_whole_chain() {
    let (measured, seen) = (on_band("FL11", BAND), observer());
    let model = fitted(&measured, Basis::Cosine, 15);
    for sampling in Sampling::ALL {
        let passage = product(&measured, &model, sampling, &seen).through(&three_factors());
        let total = passage.total();
        for which in [0, 1] {
            let steps = passage.steps.iter();
            let through: f64 = steps
                .map(|step| step.transmission[which].expect("light comes in"))
                .product();
            // Three quotients multiplied against one.
            let whole = total.transmission[which].expect("light comes in");
            assert!((through / whole - 1.0).abs() < 1e-12);
        }
        assert_eq!(total.colours, passage.steps[2].colours);
        let expected = match sampling {
            Sampling::Exact => 401,
            Sampling::Convolution => 15 * 15,
            Sampling::Double => 30,
            other => other.points(15).expect("points"),
        } + model.lines().len();
        assert_eq!(total.multiplications, 3 * expected);
        assert_eq!(total.added == Some(0.0), sampling == Sampling::Exact);
    }
}

#[test]
fn without_a_light_or_a_factor_there_is_nothing_to_say_and_no_nan() {
    let (dark, seen) = (vec![0.0; BAND.points()], observer());
    let model = fitted(&dark, Basis::Fourier, 15);
    for sampling in Sampling::ALL {
        let passage = product(&dark, &model, sampling, &seen).through(&three_factors());
        for step in &passage.steps {
            assert_eq!(step.colours.delta_e_2000, None);
            assert_eq!(step.colours.luminance_error, None);
            assert_eq!(step.transmission, [None, None]);
        }
        let set = product(&dark, &model, sampling, &seen).over(&three_factors());
        assert_eq!((set.count, set.added, set.total), (3, None, None));
    }
    let measured = on_band("CIE D65", BAND);
    let model = fitted(&measured, Basis::Fourier, 15);
    let nothing = product(&measured, &model, Sampling::Exact, &seen).through(&[]);
    assert_eq!(nothing.total().colours, nothing.light);
    assert_eq!(nothing.total().transmission, [Some(1.0), Some(1.0)]);
    let black = Factor::new(vec![0.0; BAND.points()]);
    let behind =
        product(&measured, &model, Sampling::Double, &seen).through(std::slice::from_ref(&black));
    // Black is black in both: there is a colour, but no luminance to compare with.
    assert_eq!(behind.total().colours.luminance_error, None);
    let grown = bounce_errors(product(&measured, &model, Sampling::Exact, &seen), &black);
    let none = |list: &[Option<f64>]| list.iter().all(Option::is_none);
    assert!(grown.iter().all(|way| none(&way.total) && none(&way.added)));
}

#[test]
fn over_a_set_added_and_total_error_stand_apart() {
    let (names, samples) = group("tm30_ces99_5nm");
    assert_eq!(names.len(), 99);
    let factors: Vec<Factor> = samples.into_iter().map(Factor::new).collect();
    let seen = observer();
    let study = [
        (5, [0.68, 5.3], [0.013, 0.14], [0.23, 3.4]),
        (7, [0.15, 1.3], [0.002, 0.02], [0.04, 0.41]),
        (10, [0.07, 0.94], [0.002, 0.02], [0.03, 0.75]),
    ];
    let tables = lights::smooth();
    let tables = tables.iter().chain(lights::on_shelf(Shelf::Led));
    let measured: Vec<Vec<f64>> = tables.map(|light| values(light, BAND)).collect();
    println!(
        "added and total dE00, 99 samples x {} smooth and LED lights, Fourier, median / p95 / worst",
        measured.len()
    );
    for (order, paper, three_n, cut_back) in study {
        for sampling in Sampling::ALL {
            let (mut added, mut total) = (Vec::new(), Vec::new());
            for light in &measured {
                let model = Composite::of_lines_inside(
                    series(light, Basis::Fourier, 2 * order + 1),
                    Vec::new(),
                );
                let set = product(light, &model, sampling, &seen).over(&factors);
                added.extend(set.each.iter().filter_map(|each| each[0]));
                total.extend(set.each.iter().filter_map(|each| each[1]));
            }
            let [added, total] = [added, total].map(|list| Spread::of(&list).expect("colours"));
            let figures = match sampling {
                Sampling::Paper => Some(paper),
                Sampling::ThreeN => Some(three_n),
                Sampling::Convolution => Some(cut_back),
                Sampling::FourN => Some([0.0, 0.0]),
                Sampling::Double | Sampling::Exact => None,
            };
            println!(
                "N = {order:<2} {:<12} added {:8.1e} / {:8.1e} / {:8.1e}  study {:<16} total {:.2} / {:.2} / {:.2}",
                sampling.word(),
                added.median,
                added.p95,
                added.worst,
                figures.map_or("-".to_owned(), |[m, p]| format!("{m} / {p}")),
                total.median,
                total.p95,
                total.worst,
            );
            match (sampling, figures) {
                // Nothing folds: rounding in XYZ, seen through the cube root of dark colours.
                (Sampling::FourN | Sampling::Double | Sampling::Exact, _) => {
                    assert!(added.worst < 1e-8, "{sampling:?} {}", added.worst);
                }
                (_, Some(study)) => {
                    // Other lights than the study's: the order of magnitude, and better.
                    for (found, study) in [added.median, added.p95].into_iter().zip(study) {
                        assert!((0.5..2.0).contains(&(found / study)), "{found} {study}");
                    }
                }
                (_, None) => {}
            }
        }
    }
}

fn at(errors: &[BounceErrors], sampling: Sampling, bounces: usize) -> [f64; 2] {
    let way = errors.iter().find(|way| way.sampling == sampling);
    let way = way.expect("every way is followed");
    [&way.added, &way.total].map(|list| list[bounces - 1].expect("light is left"))
}

#[test]
fn errors_grow_with_the_bounces_on_the_papers_points_and_not_on_twice_the_numbers() {
    let (measured, seen) = (on_band("CIE D65", BAND), observer());
    let red = factor("colorchecker_ohta/red");
    for (basis, numbers) in [
        (Basis::Fourier, 15),
        (Basis::Cosine, 15),
        (Basis::Cosine, 21),
    ] {
        let model = fitted(&measured, basis, numbers);
        let grown = bounce_errors(product(&measured, &model, Sampling::Exact, &seen), &red);
        assert_eq!(grown.len(), Sampling::ALL.len());
        println!("{basis:?}, {numbers} numbers, D65 off ColorChecker red, added / total dE00");
        for way in &grown {
            assert_eq!((way.added.len(), way.total.len()), (16, 16));
            let cell = |k: usize| {
                let [added, total] = at(&grown, way.sampling, k);
                format!("{added:8.4} / {total:7.3}")
            };
            let cells: Vec<String> = [1, 2, 4, 8, 16].map(cell).into();
            println!("{:<12} {}", way.sampling.word(), cells.join("  "));
        }
        let added = |sampling, k| at(&grown, sampling, k)[0];
        assert!(added(Sampling::Paper, 16) > added(Sampling::Paper, 1));
        for k in 1..=16 {
            assert_eq!(added(Sampling::Exact, k), 0.0);
            assert!(added(Sampling::Double, k) <= added(Sampling::Paper, k) + 1e-9);
        }
        // One product is exact on twice the numbers.
        assert!(added(Sampling::Double, 1) < 1e-8);
    }
}

#[test]
fn every_short_chain_of_the_bounces_is_the_chain_itself() {
    let (measured, seen) = (on_band("FL2", BAND), observer());
    let model = fitted(&measured, Basis::Cosine, 11);
    let surface = factor("colorchecker_ohta/red");
    let half = 0.5 * BAND.inner(&measured, &seen[1]);
    for way in bounce_errors(product(&measured, &model, Sampling::Exact, &seen), &surface) {
        for count in [1, 4, 5] {
            let ask = product(&measured, &model, way.sampling, &seen);
            let passage = ask.through(&vec![surface.clone(); count]);
            let total = passage.total().colours;
            // The errors behind bounces brighten both sides; the luminance's ratio tells that it is the same.
            assert!(total.exact.y < half);
            let white = passage.white;
            let gain = half / total.exact.y;
            let lab = |xyz| spectral_explorer::color::lab_from_xyz(xyz, white);
            let expected = spectral_explorer::color::delta_e_2000(
                lab(total.exact * gain),
                lab(total.model * gain),
            );
            let found = way.total[count - 1].expect("light is left");
            // The same sums; the gain is a quotient of the same numbers.
            assert!((found - expected).abs() < 1e-9, "{way:?}");
        }
    }
}

#[test]
fn behind_a_narrow_filter_a_line_is_there_only_for_the_composite() {
    let seen = observer();
    println!("behind a 15 nm band-pass at 546 nm: composite, series, samples (dE00, luminance)");
    for name in ["FL2", "FL11", "lamps_nist_traditional/Mercury"] {
        let measured = on_band(name, BAND);
        let model = fitted(&measured, Basis::Cosine, 11);
        let narrow = Narrow::new(&measured, &model, false, &seen);
        assert_eq!(narrow.numbers(), model.numbers());
        let point = narrow.behind(546.1, 15.0);
        let ways = [point.composite, point.series, point.samples];
        let off = ways.map(|way| way.luminance_error.expect("light comes through").abs());
        println!(
            "{name:<32} {:?} {off:.2?}",
            ways.map(|way| (1e2 * way.delta_e_2000.unwrap_or(f64::NAN)).round() / 1e2)
        );
        assert!(off[0] < off[1] && off[0] < off[2], "{name}: {off:?}");
        let curve = narrow.curve(15.0, 5);
        assert_eq!(curve.len(), 81);
        assert_eq!(curve[0].centre_nm, 380.0);
        let finite = |value: Option<f64>| value.is_none_or(f64::is_finite);
        assert!(curve.iter().all(|point| {
            [point.composite, point.series, point.samples]
                .iter()
                .all(|c| finite(c.delta_e_2000) && finite(c.luminance_error))
        }));
    }
}

#[test]
fn behind_a_filter_narrower_than_a_line_the_width_counts() {
    let seen = observer();
    let series = |value: f64| Series {
        band: BAND,
        basis: Basis::Cosine,
        coefficients: vec![value, 0.0, 0.0],
    };
    let smooth = series(0.001);
    // The light is what the model says: a line 20 nm wide on a little light.
    let line = Line {
        at_nm: 546.0,
        weight: 1.0,
        fwhm_nm: 20.0,
    };
    let mut values = smooth.on_band();
    add_lines(BAND, &[line], &mut values);
    let centre =
        Composite::of_lines_inside(smooth.clone(), vec![Line::ideal(line.at_nm, line.weight)]);
    let parts = (&values[..], &[][..], centre.numbers() + 1);
    let wide = Narrow::of_parts(&values, &smooth, parts, false, &seen);
    let ideal = Narrow::new(&values, &centre, false, &seen);
    assert_eq!(wide.numbers(), 6);
    for centre_nm in [536.0, 546.0, 556.0] {
        let off = |narrow: &Narrow| narrow.behind(centre_nm, 4.0).composite.luminance_error;
        assert_eq!(off(&wide), Some(0.0), "{centre_nm}");
        // A line without width goes through whole or not at all.
        assert!(
            off(&ideal).is_some_and(|off| off.abs() > 0.5),
            "{centre_nm}"
        );
    }
}

#[test]
fn behind_any_filter_a_flat_light_is_right_in_every_way() {
    let (measured, seen) = (vec![3.0; BAND.points()], observer());
    let model = fitted(&measured, Basis::Fourier, 15);
    let narrow = Narrow::new(&measured, &model, true, &seen);
    for point in narrow.curve(0.0, 20) {
        for way in [point.composite, point.series, point.samples] {
            // A constant in 15 numbers: rounding, brightened by up to 50.
            assert!(way.delta_e_2000.expect("a white") < 1e-8);
        }
    }
    let open = narrow.through(|_| 1.0);
    assert!(
        open.iter()
            .all(|way| way.luminance_error.expect("light").abs() < 1e-12)
    );
}

#[test]
fn under_the_same_light_twice_no_patch_moves() {
    let (_, patches) = group("colorchecker_ohta");
    let (d65, a, seen) = (on_band("CIE D65", BAND), on_band("CIE A", BAND), observer());
    let same = two_lights(BAND, &patches, [&d65, &d65], &seen).expect("lights");
    assert_eq!(same.mean(), Some(0.0));
    let other = two_lights(BAND, &patches, [&d65, &a], &seen).expect("lights");
    assert_eq!(other.patches.len(), 24);
    assert!(other.whites.iter().all(|white| white.y == 100.0));
    // A perfect reflector is the white under both.
    let white = two_lights(BAND, &[vec![1.0; BAND.points()]], [&d65, &a], &seen).expect("lights");
    // L* of 100 from a cube root of a ratio that is 1 but for rounding.
    assert!(white.patches[0].delta_e_2000 < 1e-9);
    let mean = other.mean().expect("patches");
    println!("ColorChecker from D65 to A, each against its own white: mean dE00 {mean:.2}");
    assert!(mean > 1.0);
    let dark = vec![0.0; BAND.points()];
    assert_eq!(two_lights(BAND, &patches, [&d65, &dark], &seen), None);
}

#[test]
fn the_library_has_surfaces_that_match_under_one_light_and_part_under_another() {
    let (mut names, mut surfaces) = group("aces_training_190");
    for id in ["tm30_ces99_5nm", "colorchecker_ohta"] {
        let (more_names, more) = group(id);
        names.extend(more_names);
        surfaces.extend(more);
    }
    let seen = observer();
    for (first, second) in [("CIE D65", "FL11"), ("CIE D65", "CIE A"), ("CIE A", "FL2")] {
        let lights = [first, second].map(|name| on_band(name, BAND));
        let both = two_lights(BAND, &surfaces, [&lights[0], &lights[1]], &seen).expect("lights");
        let found = metameric_pairs(BAND, &surfaces, &both, MATCH_DELTA_E, &Progress::default())
            .expect("nobody cancels");
        let [most, ..] = &found.pairs[..] else {
            panic!("no pair among {} surfaces", surfaces.len());
        };
        println!(
            "{first} / {second}: {} pairs of {} surfaces, index {:.2}; {} and {}: {:.2} and {:.2} dE00",
            found.pairs.len(),
            surfaces.len(),
            found.index.expect("pairs"),
            names[most.pair[0]],
            names[most.pair[1]],
            most.delta_e_2000[0],
            most.delta_e_2000[1],
        );
        assert!(most.delta_e_2000[0] < MATCH_DELTA_E);
        // Corrected for what is left under the first light, few pairs of real paints part widely.
        assert!(most.delta_e_2000[1] > 0.8 * MATCH_DELTA_E);
        let falling = |w: &[spectral_explorer::study::products::MetamericPair]| {
            w[0].delta_e_2000[1] >= w[1].delta_e_2000[1]
        };
        assert!(found.pairs.windows(2).all(falling));
    }
}

#[test]
fn a_metameric_black_is_not_seen_under_its_light_and_is_under_others() {
    let (names, patches) = group("colorchecker_ohta");
    let seen = observer();
    let (d65, a) = (on_band("CIE D65", BAND), on_band("CIE A", BAND));
    let mut parted: f64 = 0.0;
    for (name, patch) in names.iter().zip(&patches) {
        let black = metameric_black(BAND, patch, &d65, &seen)
            .unwrap_or_else(|| panic!("{name} leaves no room"));
        // The side with more room is taken.
        let [down, up] = black.room;
        let other = black.added(patch, if up >= -down { 1.0 } else { -1.0 });
        assert!(other.iter().all(|v| (0.0..=1.0).contains(v)), "{name}");
        // As far as it goes: somewhere it touches 0 or 1.
        assert!(other.iter().any(|v| *v < 1e-9 || *v > 1.0 - 1e-9), "{name}");
        let both = two_lights(BAND, &[patch.clone(), other], [&d65, &a], &seen).expect("lights");
        let [one, two] = &both.patches[..] else {
            panic!("two surfaces")
        };
        for (one, two) in one.xyz[0].to_array().into_iter().zip(two.xyz[0].to_array()) {
            // Orthogonal to three rows of 401 products, XYZ up to 100.
            assert!((one - two).abs() < 1e-9, "{name}: {one} {two}");
        }
        let under_a = spectral_explorer::color::delta_e_2000(one.labs[1], two.labs[1]);
        parted = parted.max(under_a);
    }
    println!(
        "metameric blacks of the ColorChecker under D65 part by up to {parted:.2} dE00 under A"
    );
    assert!(parted > 1.0);
    let dark = vec![0.0; BAND.points()];
    assert_eq!(metameric_black(BAND, &patches[0], &dark, &seen), None);
    let full = vec![1.0; BAND.points()];
    assert_eq!(metameric_black(BAND, &full, &d65, &seen), None);
    let infrared = Band::new(900.0, 1000.0).expect("a band");
    let unseen = Observer::CIE_1931.table().on_band(infrared);
    let grey = vec![0.5; infrared.points()];
    assert_eq!(metameric_black(infrared, &grey, &grey, &unseen), None);
}

/// Tests `outgoing = light x reflectance` in the model's numbers.
fn reflection_check(
    light: &Composite,
    reflectance: &[f64],
    outgoing: &Composite,
) -> Option<Reflection> {
    let compared = Checker::new(light, outgoing).against(reflectance)?;
    Some(compared.reflection)
}

#[test]
fn light_off_a_surface_is_told_from_light_off_another() {
    let (_, samples) = group("tm30_ces99_5nm");
    let shelves = [
        Shelf::Standard,
        Shelf::Led,
        Shelf::Fluorescent,
        Shelf::Discharge,
    ];
    for (basis, numbers) in [
        (Basis::Fourier, 15),
        (Basis::Cosine, 15),
        (Basis::Cosine, 21),
    ] {
        let (mut right, mut wrong) = (Vec::new(), Vec::new());
        for shelf in shelves {
            let (mut here, mut there, mut factors) = (Vec::new(), Vec::new(), Vec::new());
            for light in lights::on_shelf(shelf).into_iter().step_by(3) {
                let light = values(light, BAND);
                let model = fitted(&light, basis, numbers);
                for i in (0..99).step_by(7) {
                    let outgoing = multiply(&light, &samples[i]);
                    let outgoing: Vec<f64> = outgoing.iter().map(|v| 0.3 * v).collect();
                    let outgoing = fitted(&outgoing, basis, numbers);
                    let off = |j: usize| {
                        reflection_check(&model, &samples[j % 99], &outgoing).expect("light")
                    };
                    let (own, other) = (off(i), off(i + 37));
                    factors.push((own.factor / 0.3 - 1.0).abs());
                    here.push(own.residual);
                    there.push(other.residual);
                }
            }
            let [h, t] = [&here, &there].map(|list| Spread::of(list).expect("lights"));
            println!(
                "{basis:?} {numbers} {shelf:?}: right {:.3} / {:.3} / {:.3}, wrong {:.3} / {:.3}",
                h.median, h.p95, h.worst, t.median, t.p95
            );
            let factors = Spread::of(&factors).expect("lights");
            // The factor is found to the degree of the spectrum or better.
            assert!(
                factors.median < 0.01 && factors.p95 < SAME_RESIDUAL,
                "{factors:?}"
            );
            right.extend(here);
            wrong.extend(there);
        }
        let held = |list: &[f64]| {
            let held = list.iter().filter(|r| **r <= SAME_RESIDUAL).count();
            held as f64 / list.len() as f64
        };
        println!(
            "{basis:?} {numbers}: right ones that hold {:.3}, wrong ones that hold {:.3}",
            held(&right),
            held(&wrong)
        );
        assert!(held(&right) > 0.9 && held(&wrong) < 0.05);
    }
}

#[test]
fn a_reflection_of_nothing_is_no_question_and_a_product_is_itself() {
    let light = fitted(&on_band("FL2", BAND), Basis::Cosine, 15);
    let dark = fitted(&vec![0.0; BAND.points()], Basis::Cosine, 15);
    let grey = vec![0.25; BAND.points()];
    assert_eq!(reflection_check(&dark, &grey, &light), None);
    assert_eq!(reflection_check(&light, &grey, &dark), None);
    let own = reflection_check(&light, &grey, &light).expect("light");
    // A grey is one coefficient: the product is the light times it, to rounding.
    assert!(
        own.residual < 1e-12 && (own.factor - 4.0).abs() < 1e-11,
        "{own:?}"
    );
    assert!(own.holds());
}
