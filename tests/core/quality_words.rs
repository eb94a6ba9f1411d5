//! Lights without figures answer in words, models are weighed as they are, JSON has its keys.

use proptest::prelude::*;
use serde_json::Value;
use spectral_explorer::{
    app::{
        figures::TLCI,
        quality_report::{full_json, json, lights_table, rows},
    },
    color::{
        Observer,
        quality::{
            Dark, EFFICACY, FewFigures, Figures, Light, Measured, NoFigure, POINTS, Radiometric,
            SP_RATIO,
        },
    },
    preset,
    spectrum::{
        Band, Basis, BasisTable, Composite, Line, Outside, Sampled, Series, SpikeSettings, detect,
        numbers_of_order,
    },
    study::{
        Progress,
        quality::{Chosen, figures_against_order, figures_of_many},
    },
};

fn shipped(group: &str, name: &str) -> Sampled {
    let table = preset::table(group, name);
    table
        .unwrap_or_else(|| panic!("no table {group}/{name}"))
        .clone()
}

fn table(nm: [f64; 2], values: [f64; 2]) -> Light {
    Light::of_sampled(&Sampled::new(nm.to_vec(), values.to_vec()).expect("two points"))
}

fn line(at_nm: f64) -> Light {
    Light::of_line(Line::ideal(at_nm, 1.0))
}

/// A composite of a light: spikes detected, the rest projected on cosines.
fn model(table: &Sampled, order: usize) -> Composite {
    let band = Band::VISIBLE;
    let values = table.on_band(band, Outside::Zero);
    let parts = detect(band, &values, SpikeSettings::default());
    let numbers = numbers_of_order(order);
    let basis = BasisTable::new(band, Basis::Cosine, numbers);
    Composite::of_lines_inside(
        Series {
            band,
            basis: Basis::Cosine,
            coefficients: basis.project(&parts.smooth, numbers),
        },
        parts.spikes.iter().map(|found| found.spike).collect(),
    )
}

/// Every number in a JSON value.
fn has_only_finite_numbers(value: &Value) -> bool {
    match value {
        Value::Number(number) => number.as_f64().is_some_and(f64::is_finite),
        Value::Array(list) => list.iter().all(has_only_finite_numbers),
        Value::Object(map) => map.values().all(has_only_finite_numbers),
        Value::Null | Value::Bool(_) | Value::String(_) => true,
    }
}

/// Whether a `null` figure of the command's keys is explained in the notes.
fn every_null_has_a_reason(object: &Value) -> bool {
    let notes: Vec<&str> = object["notes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|n| n.as_str().unwrap())
        .collect();
    let map = object.as_object().unwrap();
    map.iter()
        .filter(|(key, value)| value.is_null() && *key != "model")
        .all(|(key, _)| {
            notes.iter().any(|note| {
                let head = note.split(": ").next().unwrap_or("");
                head.split(", ").any(|word| word == key)
            })
        })
}

#[test]
fn a_light_that_is_none_says_so_for_every_figure() {
    let dark = [
        table([400.0, 700.0], [0.0, 0.0]),
        table([900.0, 1000.0], [1.0, 1.0]),
        table([100.0, 300.0], [1.0, 1.0]),
    ];
    for light in dark {
        let figures = Figures::of(&light, None);
        assert!(matches!(figures.xyz, Err(NoFigure::Dark(_))));
        assert!(rows(&figures).iter().all(|row| row.value.is_err()));
        let found = json("dark", &figures, None);
        assert!(every_null_has_a_reason(&found), "{found}");
        assert!(found["ssi"]["value"].is_null());
    }
    let infrared = Figures::of(&table([900.0, 1000.0], [1.0, 1.0]), None);
    let words = infrared.xyz.unwrap_err().to_string();
    assert_eq!(
        words,
        "no light between 360 and 830 nm: the table is of 900 to 1000 nm"
    );
    let zero = Figures::of(&table([400.0, 700.0], [0.0, 0.0]), None);
    assert_eq!(zero.xyz, Err(NoFigure::Dark(Dark::AllZero)));
}

#[test]
fn a_laser_line_has_a_colour_but_no_colour_temperature() {
    let figures = Figures::of(&line(532.0), None);
    // The polyline of the locus goes through the colours of whole nm.
    assert!((figures.dominant.as_ref().unwrap().nm.clone().unwrap() - 532.0).abs() < 1e-9);
    assert!((figures.dominant.as_ref().unwrap().purity - 1.0).abs() < 1e-12);
    assert!(matches!(figures.cct, Err(NoFigure::NoCct(_))));
    assert!(matches!(figures.rendering, Err(NoFigure::NoCct(_))));
    let found = json("laser", &figures, None);
    assert!(found["ra"].is_null() && found["cct"].is_null() && found["duv"].is_null());
    assert!(every_null_has_a_reason(&found), "{found}");
    assert!(found["ssi"]["value"].is_null() && found["ssi"]["d65"].is_number());
}

#[test]
fn sodium_is_bad_and_has_numbers_all_the_same() {
    let figures = Figures::of(
        &Light::of_sampled(&shipped("lamps_nist_traditional", "LPS")),
        None,
    );
    // The reference table states Ra -46 and Rf 0.15.
    assert_eq!(figures.rendering.as_ref().unwrap().ra.round(), -46.0);
    assert!((figures.fidelity.as_ref().unwrap().rf - 0.15).abs() < 0.01);
    assert!(figures.fidelity.as_ref().unwrap().rg.abs() < 0.05);
    let similarity = figures.similarity.as_ref().unwrap();
    assert_eq!(similarity.p3200.round(), -137.0);
}

#[test]
fn equal_energy_has_no_hue() {
    let figures = Figures::of(&Light::of_nm_values(&[1.0; POINTS]), None);
    let words = figures.dominant.as_ref().unwrap_err().to_string();
    assert!(words.starts_with("no hue"), "{words}");
    assert!(json("E", &figures, None)["purity"].is_null());
}

#[test]
fn below_390_nm_the_observers_of_2015_see_nothing() {
    let figures = Figures::of(&line(365.0), None);
    assert!(figures.xy[0].is_ok() && figures.xy[1].is_ok());
    for (index, observer) in Observer::CIE.into_iter().enumerate().skip(2) {
        let expected = NoFigure::BelowObserver {
            observer,
            first_nm: 390,
        };
        assert_eq!(figures.xy[index], Err(expected));
    }
}

#[test]
fn negative_samples_are_used_and_told_or_refused_in_words() {
    let mut values = [1.0; POINTS];
    values[100] = -0.01;
    let figures = Figures::of(&Light::of_nm_values(&values), None);
    assert!(
        figures.notes[0].starts_with("1 of the values"),
        "{:?}",
        figures.notes
    );
    assert!(figures.rendering.is_ok());
    let figures = Figures::of(&Light::of_nm_values(&[-1.0; POINTS]), None);
    assert!(matches!(figures.xyz, Err(NoFigure::NotPositive { .. })));
    assert!(every_null_has_a_reason(&json("negative", &figures, None)));
}

#[test]
fn tlci_is_left_out_by_name() {
    let figures = Figures::of(&Light::of_nm_values(&[1.0; POINTS]), None);
    let rows = rows(&figures);
    let tlci = rows.iter().find(|row| row.figure.key == "tlci").unwrap();
    assert_eq!(tlci.value, Err(TLCI.to_owned()));
    assert_eq!(tlci.shown(), "–");
}

#[test]
fn json_has_the_keys_of_the_command_and_else_only_figures() {
    let fl2 = shipped("cie_fluorescent_5nm", "FL2");
    let measured = Figures::of(&Light::of_sampled(&fl2), None);
    let fitted = Figures::of(&Light::of_composite(&model(&fl2, 7)), None);
    let found = json("FL2", &measured, Some(&fitted));
    let keys = |value: &Value| -> Vec<String> {
        let mut keys: Vec<String> = value.as_object().unwrap().keys().cloned().collect();
        keys.sort();
        keys
    };
    let mut expected: Vec<String> = "name xyz xy uv cct duv ra r rf rg hue_bins ler dominant_nm purity sp_ratio melanopic_der alphaopic ppfd_per_100lx ssi notes"
        .split(' ')
        .map(str::to_owned)
        .collect();
    // A figure that joins the list of figures joins the JSON.
    let all = rows(&measured);
    let is_figure = |key: &String| all.iter().any(|row| row.figure.key == key);
    for (group, own) in [(&found["model"], None), (&found, Some("model"))] {
        expected.extend(own.map(str::to_owned));
        let found = keys(group);
        let missing: Vec<&String> = expected.iter().filter(|key| !found.contains(key)).collect();
        assert!(missing.is_empty(), "{missing:?}");
        let is_known = |key: &&String| expected.contains(key) || is_figure(key);
        let unknown: Vec<&String> = found.iter().filter(|key| !is_known(key)).collect();
        assert!(unknown.is_empty(), "{unknown:?}");
    }
    assert_eq!(found["r"].as_array().unwrap().len(), 15);
    assert_eq!(found["hue_bins"].as_array().unwrap().len(), 16);
    assert_eq!(
        keys(&found["hue_bins"][0]),
        ["rcs", "reference_ab", "rf", "rhs", "test_ab"]
    );
    assert_eq!(
        keys(&found["alphaopic"]),
        ["l_cone", "m_cone", "melanopic", "rhodopic", "s_cone"]
    );
    assert_eq!(found["ssi"]["reference"], "D4225");
    assert_eq!(found["alphaopic"]["melanopic"], found["melanopic_der"]);
    assert!(has_only_finite_numbers(&full_json(
        "FL2",
        &measured,
        Some(&fitted)
    )));
    assert_eq!(
        full_json("FL2", &measured, None)["rf_samples"]
            .as_array()
            .unwrap()
            .len(),
        99
    );
}

#[test]
fn a_reading_says_it_plainly() {
    let figures = Figures::of(&Light::of_sampled(&shipped("cie_led_5nm", "LED-B3")), None);
    let rows = rows(&figures);
    let r9 = rows.iter().find(|row| row.figure.key == "r9").unwrap();
    assert_eq!(r9.reading, "strong red looks wrong: R9 24, duller");
    let cct = rows.iter().find(|row| row.figure.key == "cct").unwrap();
    assert_eq!(cct.reading, "neutral white; may be sold as 4000 K");
    assert_eq!(cct.shown(), "4102 K");
}

#[test]
fn watts_per_square_metre_give_lux_and_photons() {
    let d65 = shipped("cie_illuminants", "CIE D65");
    let measured = |factor| {
        Some(Measured {
            what: Radiometric::Irradiance,
            factor,
        })
    };
    let figures = Figures::of(&Light::of_sampled(&d65), measured(1e-3));
    let found = figures.absolute.clone().unwrap();
    let per_100 = figures.photons.clone().unwrap();
    // The same sums in another order.
    assert!((found.ppfd / found.photometric * 100.0 / per_100.ppfd - 1.0).abs() < 1e-12);
    let rows = rows(&figures);
    let edi = rows
        .iter()
        .find(|row| row.figure.key == "melanopic_edi")
        .unwrap();
    // D65 is its own daylight.
    assert!((edi.value.clone().unwrap() / found.photometric - 1.0).abs() < 1e-12);
    assert!(
        Figures::of(&Light::of_sampled(&d65), None)
            .absolute
            .is_err()
    );
    assert!(
        Figures::of(&Light::of_sampled(&d65), measured(f64::INFINITY))
            .absolute
            .is_err()
    );
}

#[test]
fn a_series_that_is_exact_has_the_figures_of_its_light() {
    // A light that is a cosine series to begin with: its model is itself.
    let band = Band::VISIBLE;
    let series = Series {
        band,
        basis: Basis::Cosine,
        coefficients: vec![2.0, 0.5, -0.7, 0.1],
    };
    let values = series.on_band();
    let nm: Vec<f64> = band.grid().collect();
    let measured = Light::of_sampled(&Sampled::new(nm, values).unwrap());
    let model = Light::of_composite(&Composite::of_lines_inside(series, Vec::new()));
    assert_eq!(Figures::of(&measured, None), Figures::of(&model, None));
}

#[test]
fn spikes_are_weighed_where_they_stand() {
    // A line at a whole nm is the same as a table's value there, for all that weighs.
    let band = Band::VISIBLE;
    let mut values = vec![0.5; band.points()];
    let spike = Line::ideal(546.0, 3.0);
    let with_line = Figures::of(&Light::of_parts(band, &values, &[spike]), None);
    values[166] += 3.0;
    let on_grid = Figures::of(&Light::of_parts(band, &values, &[]), None);
    let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * a.abs().max(1.0);
    // Only the order of sums differs; Rf and Ra enlarge that little.
    assert!(close(
        with_line.rendering.as_ref().unwrap().ra,
        on_grid.rendering.as_ref().unwrap().ra
    ));
    assert!(close(
        with_line.fidelity.as_ref().unwrap().rf,
        on_grid.fidelity.as_ref().unwrap().rf
    ));
    assert!(close(
        with_line.single(&SP_RATIO).unwrap(),
        on_grid.single(&SP_RATIO).unwrap()
    ));
    assert!(close(
        with_line.photons.as_ref().unwrap().eppfd,
        on_grid.photons.as_ref().unwrap().eppfd
    ));
    assert!(close(
        with_line.single(&EFFICACY).unwrap(),
        on_grid.single(&EFFICACY).unwrap()
    ));
    let similarity = |figures: &Figures| figures.similarity.as_ref().unwrap().d65;
    let on_grid = Figures::of(&Light::of_parts(band, &values, &[]), None);
    values[166] -= 3.0;
    let with_line = Figures::of(&Light::of_parts(band, &values, &[spike]), None);
    assert!(close(similarity(&with_line), similarity(&on_grid)));
}

#[test]
fn figures_settle_as_the_order_grows() {
    let fl2 = shipped("cie_fluorescent_5nm", "FL2");
    let light = Light::of_sampled(&fl2).within(Band::VISIBLE);
    let found =
        figures_against_order(&light, 30, |n| model(&fl2, n), &Progress::default()).unwrap();
    assert_eq!(found.points.len(), 31);
    for chosen in Chosen::ALL {
        let least = found.least_within(chosen).expect("30 orders are enough");
        let settled = found.settled_from(chosen).expect("30 orders are enough");
        assert!(least <= settled && settled <= 30, "{chosen:?}");
        let exact = chosen.of(&found.exact).unwrap();
        for point in found.points.iter().filter(|point| point.order >= settled) {
            let value = chosen.of(&point.figures).unwrap();
            assert!((value - exact).abs() <= chosen.near_enough(exact));
        }
    }
    let progress = Progress::default();
    progress.cancel();
    assert_eq!(
        figures_against_order(&light, 3, |n| model(&fl2, n), &progress),
        None
    );
}

#[test]
fn the_few_figures_are_those_of_all() {
    let light = Light::of_sampled(&shipped("cie_hp_5nm", "HP1"));
    let (few, all) = (FewFigures::of(&light), Figures::of(&light, None));
    assert_eq!(few.ra.unwrap(), all.rendering.unwrap().ra);
    let fidelity = all.fidelity.unwrap();
    assert_eq!(few.rf.unwrap(), fidelity.rf);
    assert_eq!(few.rg.unwrap(), fidelity.rg);
    assert_eq!(
        few.melanopic_der.unwrap(),
        all.alpha_opic.unwrap().melanopic_der()
    );
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let names = ["FL1", "FL2", "FL3", "FL4", "FL5", "FL6", "FL7"];
    let lights: Vec<(Light, Option<Measured>)> = names
        .map(|name| {
            (
                Light::of_sampled(&shipped("cie_fluorescent_5nm", name)),
                None,
            )
        })
        .into();
    let one = figures_of_many(&lights, 1, &Progress::default()).unwrap();
    let three = figures_of_many(&lights, 3, &Progress::default()).unwrap();
    assert_eq!(one, three);
    let csv = lights_table(names.into_iter().zip(&one).map(|(n, f)| (n, Ok((f, None))))).csv();
    let (head, rows) = csv.split_once('\n').expect("a head");
    assert!(head.starts_with("name,x,y,"));
    assert!(
        rows.lines()
            .zip(names)
            .all(|(row, name)| row.starts_with(name))
    );
    assert_eq!(
        figures_of_many(&[], 2, &Progress::default()),
        Some(Vec::new())
    );
    let progress = Progress::default();
    progress.cancel();
    assert_eq!(figures_of_many(&lights, 2, &progress), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_light_gives_a_number_that_is_none(
        values in prop::collection::vec(-0.2..1.0_f64, 48),
        spikes in prop::collection::vec((300.0..900.0_f64, -5.0..20.0_f64), 0..4),
        exponent in -300..300_i32,
    ) {
        let size = 10.0_f64.powi(exponent);
        let values: Vec<f64> = values.iter().map(|v| v * size).collect();
        let table = Sampled::even(360.0, 10.0, values).unwrap();
        let band = Band::new(360.0, 830.0).unwrap();
        let spikes: Vec<Line> = spikes
            .iter()
            .map(|(at_nm, weight)| Line::ideal(*at_nm, weight * size))
            .collect();
        let light = Light::of_parts(band, &table.on_band(band, Outside::Zero), &spikes);
        let figures = Figures::of(&light, Some(Measured { what: Radiometric::Radiance, factor: 1.0 }));
        let found = full_json("any", &figures, Some(&figures));
        prop_assert!(has_only_finite_numbers(&found));
        prop_assert!(every_null_has_a_reason(&json("any", &figures, None)), "{found}");
    }

    #[test]
    fn no_smooth_light_is_beyond_the_scales(
        coefficients in prop::collection::vec(-0.3..0.3_f64, 6),
    ) {
        let smooth = Series { band: Band::VISIBLE, basis: Basis::Cosine, coefficients };
        let values: Vec<f64> = smooth.on_band().iter().map(|v| v.exp()).collect();
        let light = Light::of_parts(Band::VISIBLE, &values, &[]);
        let figures = Figures::of(&light, None);
        let dominant = figures.dominant.as_ref().unwrap();
        prop_assert!((0.0..=1.0).contains(&dominant.purity));
        prop_assert!((0.0..=683.0).contains(&figures.single(&EFFICACY).unwrap()));
        if let Ok(found) = figures.rendering {
            prop_assert!(found.ra <= 100.0 + 1e-9);
        }
        if let Ok(found) = figures.fidelity {
            // No difference reads 100 + 10 ln(1 + e^-10).
            prop_assert!((0.0..100.001).contains(&found.rf) && found.rg > 0.0);
        }
    }
}
