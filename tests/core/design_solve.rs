//! Mixtures that are wished for and fronts of free lines, beside brute force.

use std::{collections::BTreeSet, sync::LazyLock};

use proptest::prelude::*;
use serde_json::Value;
use spectral_explorer::{
    app::Library,
    color::uv_1976_from_xyz,
    design::{
        SampleTables,
        mixture::{Channel, MixError, Spec, composite, mixed},
        solve::{
            Against, Floors, FrontPoint, FrontProblem, MixFigures, Mixer, Objective, Problem,
            Solution, Target, faders, front, front_json, mix_json,
        },
    },
    spectrum::{Outside, Sampled},
    study::Progress,
};

fn golden() -> Value {
    serde_json::from_str(include_str!("../golden/design_golden.json")).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn pair(value: &Value) -> [f64; 2] {
    [number(&value[0]), number(&value[1])]
}

fn channels(specs: &[String]) -> Vec<Channel> {
    let one = |spec: &String| Channel::new(spec.parse().unwrap(), None).unwrap();
    specs.iter().map(one).collect()
}

fn named(specs: &[&str]) -> Vec<Channel> {
    channels(&specs.iter().map(|s| (*s).to_owned()).collect::<Vec<_>>())
}

/// Channels of a golden case.
fn channels_of(case: &Value) -> Vec<Channel> {
    let spec = |channel: &Value| match channel["kind"].as_str().unwrap() {
        "line" => format!("line:{}", channel["place_nm"]),
        _ => format!("gauss:{},{}", channel["centre_nm"], channel["fwhm_nm"]),
    };
    channels(
        &case["channels"]
            .as_array()
            .unwrap()
            .iter()
            .map(spec)
            .collect::<Vec<_>>(),
    )
}

fn table(name: &str) -> &'static Sampled {
    &Library::bundled()
        .find(name)
        .unwrap()
        .spectrum()
        .unwrap()
        .samples
}

/// The tables that the study was made with: 5 nm, straight in between.
fn study_tables() -> &'static SampleTables {
    static TABLES: LazyLock<SampleTables> = LazyLock::new(|| {
        let group = |id: &str, first: &str| -> Vec<Vec<f64>> {
            let items = &Library::bundled().group(id).unwrap().items;
            let named = items.iter().filter(|item| item.name.starts_with(first));
            let on_nm = |samples: &Sampled| samples.on_whole_nm(360, 830, Outside::Hold);
            named
                .map(|item| on_nm(&item.spectrum().unwrap().samples))
                .collect()
        };
        let tables = SampleTables::new(&group("cri_tcs", "TCS"), &group("tm30_ces99_5nm", ""));
        tables.unwrap()
    });
    &TABLES
}

fn solved(channels: &[Channel], wish: Problem<'_>) -> Solution {
    Mixer::new(channels, SampleTables::shipped())
        .unwrap()
        .solve(&wish)
}

fn shares(solution: &Solution) -> Vec<f64> {
    let whole: f64 = solution.weights.iter().sum();
    solution.weights.iter().map(|w| w / whole).collect()
}

#[test]
fn the_figures_of_given_lights_are_those_of_the_study() {
    let golden = golden();
    let mut seen = 0;
    for target in ["D65", "P2700"] {
        for (section, form) in [
            ("A_three_lines", "line:{}"),
            ("B_four_lines", "line:{}"),
            ("C_three_leds_fwhm20", "gauss:{},20"),
            ("C_four_leds_fwhm20", "gauss:{},20"),
        ] {
            for front in ["front_LER_Ra", "front_LER_Rf"] {
                for light in golden["targets"][target][section][front]
                    .as_array()
                    .unwrap()
                {
                    let spec = |nm: &f64| form.replace("{}", &nm.to_string());
                    let places = numbers(&light["places_nm"]);
                    let made = channels(&places.iter().map(spec).collect::<Vec<_>>());
                    let mixer = Mixer::new(&made, study_tables()).unwrap();
                    let found = mixer.figures(&numbers(&light["power_shares"]));
                    let off = |found: f64, key: &str| (found - number(&light[key])).abs();
                    // The study's suggestion, with a little more for Ra and Rf: the CCT here is
                    // Ohno's, within 0.1 K, and M1 and M2 of daylight are not rounded.
                    assert!(off(found.ler, "LER") < 0.002, "{light}");
                    assert!(off(found.ra.unwrap(), "Ra") < 0.05, "{light} {found:?}");
                    assert!(off(found.rf.unwrap(), "Rf") < 0.05, "{light} {found:?}");
                    assert!(off(found.rg.unwrap(), "Rg") < 0.1, "{light} {found:?}");
                    assert!(off(found.melanopic_der, "melanopic_DER") < 1e-4, "{light}");
                    seen += 1;
                }
            }
        }
    }
    assert_eq!(seen, 192);
}

#[test]
fn the_most_lumens_of_fixed_channels_are_those_of_the_linear_programme() {
    for case in golden()["lp"].as_array().unwrap() {
        let channels = channels_of(case);
        let target = Target::of_xy(pair(&case["target_xy"])).unwrap();
        let found = solved(
            &channels,
            Problem {
                target: Some(target),
                ..Problem::default()
            },
        );
        let name = &case["case"];
        if case["feasible"].as_bool().unwrap() {
            assert!(found.reached, "{name} {found:?}");
            // The promise; the golden shares are printed to ten digits.
            assert!(found.delta_uv_to_target.unwrap() < 1e-6, "{name}");
            assert!(
                (found.figures.ler - number(&case["max_LER"])).abs() < 1e-4,
                "{name}"
            );
            let mut expected = numbers(&case["power_shares"]);
            let mut shares = shares(&found);
            if case["case"] == "lp07" {
                // Two channels are the same: only their sum is determined.
                for of in [&mut expected, &mut shares] {
                    of[1] += of[2];
                    of[2] = 0.0;
                }
            }
            for (a, b) in shares.iter().zip(&expected) {
                assert!((a - b).abs() < 1e-6, "{name} {shares:?}");
            }
        } else {
            assert!(!found.reached);
            let distance = found.delta_uv_to_target.unwrap();
            // Eight digits are printed.
            assert!(
                (distance - number(&case["nearest_distance_upvp"])).abs() < 1e-7,
                "{name}"
            );
            for (a, b) in shares(&found)
                .iter()
                .zip(numbers(&case["nearest_power_shares"]))
            {
                assert!((a - b).abs() < 1e-6, "{name}");
            }
            let words = format!("{distance:.4} in u'v'");
            assert!(found.why.contains(&words), "{}", found.why);
        }
    }
}

#[test]
fn a_light_is_matched_in_the_least_squares_with_exactly_its_colour() {
    for case in golden()["match"].as_array().unwrap() {
        let channels = channels_of(case);
        let light = table(case["target"].as_str().unwrap());
        let values = light.on_whole_nm(360, 830, Outside::Zero);
        let target = Some(Target::of_light(light).unwrap());
        let found = solved(
            &channels,
            Problem {
                target,
                alike: Some(&values),
                ..Problem::default()
            },
        );
        if case["feasible"].as_bool().unwrap() {
            let expected = numbers(&case["weights"]);
            let greatest = expected.iter().copied().fold(0.0, f64::max);
            for (a, b) in found.weights.iter().zip(&expected) {
                assert!(
                    (a - b).abs() < 1e-4 * greatest,
                    "{} {:?}",
                    case["case"],
                    found.weights
                );
            }
            assert!(found.delta_uv_to_target.unwrap() < 1e-6 && found.reached);
        } else {
            let distance = number(&case["nearest_distance_upvp"]);
            assert!((found.delta_uv_to_target.unwrap() - distance).abs() < 1e-7);
        }
    }
}

fn front_at(target: &Value, against: Against, lines: usize, floors: Vec<f64>) -> Vec<FrontPoint> {
    let wish = FrontProblem {
        target: Target::of_xy(pair(target)).unwrap(),
        against,
        lines,
        points: floors.len(),
        floors: Some(floors),
    };
    front(&wish, study_tables(), &Progress::default())
        .unwrap()
        .unwrap()
}

/// Fronts are no worse than brute force by more than `slack` at any floor.
fn no_worse(target: &str, section: &str, lines: usize, figure: &str, slack: f64, every: usize) {
    let golden = golden();
    let target = &golden["targets"][target];
    let known: Vec<Value> = target[section][format!("front_LER_{figure}")]
        .as_array()
        .unwrap()
        .iter()
        .step_by(every)
        .cloned()
        .collect();
    let floors: Vec<f64> = known
        .iter()
        .map(|light| number(&light["LER_floor"]))
        .collect();
    let against = if figure == "Ra" {
        Against::Ra
    } else {
        Against::Rf
    };
    let found = front_at(&target["target_xy"], against, lines, floors);
    assert_eq!(found.len(), known.len());
    for (light, point) in known.iter().zip(&found) {
        let figures = &point.figures;
        let value = if figure == "Ra" {
            figures.ra
        } else {
            figures.rf
        };
        let missing = number(&light[figure]) - value.unwrap();
        assert!(missing < slack, "{section} {figure} {light} {point:?}");
        assert!(figures.ler >= point.floor - 1e-6, "{point:?}");
        let whole: f64 = point.lines.iter().map(|line| line.share_of_power).sum();
        assert!((whole - 1.0).abs() < 1e-12 && point.lines.len() <= lines);
        let [x, y] = figures.xy.unwrap();
        let [tx, ty] = pair(&target["target_xy"]);
        assert!((x - tx).hypot(y - ty) < 1e-9);
    }
}

// The issue asks for .3 (three lines) and .5 (four). Three free lines beat the study's net of 2 nm
// everywhere; four come within the kink of its last digit.
#[test]
fn three_free_lines_are_no_worse_than_brute_force_in_ra() {
    no_worse("D65", "A_three_lines", 3, "Ra", 0.02, 1);
    no_worse("P2700", "A_three_lines", 3, "Ra", 0.02, 1);
}

#[test]
fn three_free_lines_are_no_worse_than_brute_force_in_rf() {
    no_worse("D65", "A_three_lines", 3, "Rf", 0.02, 1);
    no_worse("P2700", "A_three_lines", 3, "Rf", 0.02, 1);
}

#[test]
fn four_free_lines_are_no_worse_than_brute_force_in_ra() {
    no_worse("D65", "B_four_lines", 4, "Ra", 0.2, 1);
    no_worse("P2700", "B_four_lines", 4, "Ra", 0.2, 1);
}

#[test]
fn four_free_lines_are_no_worse_than_brute_force_in_rf() {
    no_worse("D65", "B_four_lines", 4, "Rf", 0.2, 2);
    no_worse("P2700", "B_four_lines", 4, "Rf", 0.2, 3);
}

#[test]
fn four_lines_are_never_worse_than_three() {
    let target = golden()["targets"]["P2700"]["target_xy"].clone();
    let floors = vec![400.0, 440.0, 470.0, 491.0, 505.0];
    let three = front_at(&target, Against::Ra, 3, floors.clone());
    let four = front_at(&target, Against::Ra, 4, floors);
    for (three, four) in three.iter().zip(&four) {
        // Doubled lines start at the same light, to the rounding of one elimination.
        assert!(four.figures.ra.unwrap() > three.figures.ra.unwrap() - 1e-6);
    }
}

#[test]
fn two_lines_of_a_colour_are_never_better_than_three_and_no_pair_is_better_than_theirs() {
    let target = golden()["targets"]["P2700"]["target_xy"].clone();
    let floors = vec![300.0, 400.0, 450.0, 500.0];
    for against in [Against::Ra, Against::Rf] {
        let two = front_at(&target, against, 2, floors.clone());
        let three = front_at(&target, against, 3, floors.clone());
        let worth = |point: &FrontPoint| against.of(&point.figures).unwrap();
        for point in &two {
            let above = three.iter().find(|three| three.floor == point.floor);
            assert!(worth(point) <= worth(above.unwrap()) + 0.02, "{point:?}");
            assert!(point.lines.len() <= 2 && point.figures.ler >= point.floor - 1e-6);
            let [x, y] = point.figures.xy.unwrap();
            let [tx, ty] = pair(&target);
            assert!((x - tx).hypot(y - ty) < 1e-9, "{point:?}");
        }
        assert!(!two.is_empty());
        // Pairs that the search did not look at: a channel each whole nm, solved for.
        let best = two.iter().map(worth).fold(f64::NEG_INFINITY, f64::max);
        for first in (405..=500).step_by(5) {
            let specs = [format!("line:{first}.3"), "line:577.9".to_owned()];
            let found = solved(
                &channels(&specs),
                Problem {
                    target: Some(Target::of_xy(pair(&target)).unwrap()),
                    ..Problem::default()
                },
            );
            let figure = against.of(&found.figures);
            assert!(!found.reached || figure.unwrap() < best + 0.05);
        }
    }
}

#[test]
fn each_line_more_is_no_worse_and_has_no_better_powers_than_those_it_found() {
    let target = golden()["targets"]["D65"]["target_xy"].clone();
    let floors = vec![250.0, 320.0, 380.0];
    let colour = Target::of_xy(pair(&target)).unwrap();
    for (against, objective) in [(Against::Ra, Objective::Ra), (Against::Rf, Objective::Rf)] {
        let worth = |figures: &MixFigures| against.of(figures).unwrap();
        let mut before = vec![f64::NEG_INFINITY; floors.len()];
        for lines in [4, 5, 6, 8] {
            let found = front_at(&target, against, lines, floors.clone());
            assert_eq!(found.len(), floors.len());
            for (point, before) in found.iter().zip(&mut before) {
                assert!(worth(&point.figures) > *before - 1e-6, "{lines}: {point:?}");
                *before = worth(&point.figures);
                assert!(point.lines.len() <= lines);
                assert!(point.figures.ler >= point.floor - 1e-6, "{point:?}");
                let [x, y] = point.figures.xy.unwrap();
                let [tx, ty] = pair(&target);
                assert!((x - tx).hypot(y - ty) < 1e-9, "{point:?}");
                // The same places with powers by the solver of the mixing desk.
                let places = point
                    .lines
                    .iter()
                    .map(|line| format!("line:{}", line.at_nm));
                let again = solved(
                    &channels(&places.collect::<Vec<_>>()),
                    Problem {
                        target: Some(colour),
                        objective,
                        floors: Floors {
                            ler: Some(point.floor),
                            ..Floors::default()
                        },
                        ..Problem::default()
                    },
                );
                let missing = worth(&again.figures) - worth(&point.figures);
                assert!(
                    !again.reached || missing < 0.3,
                    "{lines}: {missing} {point:?}"
                );
            }
        }
    }
}

#[test]
fn the_known_trade_of_three_lines_comes_out_by_itself() {
    // Thornton 1971: three lines near 450, 540 and 610 nm give Ra about 80 at high efficacy.
    let wish = FrontProblem {
        target: Target::of_kelvin(4000.0, 0.0).unwrap(),
        against: Against::Ra,
        lines: 3,
        points: 12,
        floors: None,
    };
    let found = front(&wish, SampleTables::shipped(), &Progress::default())
        .unwrap()
        .unwrap();
    assert!((6..=12).contains(&found.len()));
    let best = &found[0];
    assert!(
        best.figures.ra.unwrap() > 79.0 && best.figures.ler > 330.0,
        "{best:?}"
    );
    let near = [(440.0, 480.0), (530.0, 560.0), (600.0, 620.0)];
    for (line, (from, to)) in best.lines.iter().zip(near) {
        assert!((from..=to).contains(&line.at_nm), "{best:?}");
    }
    for two in found.windows(2) {
        assert!(two[1].figures.ler >= two[0].figures.ler);
        assert!(two[1].figures.ra <= two[0].figures.ra);
    }
    let json = front_json(&found);
    let first = &json["front"][0];
    assert_eq!(keys(first), ["ler", "rf", "ra", "rg", "lines"].into());
    assert_eq!(keys(&first["lines"][0]), ["at_nm", "share_of_power"].into());
}

#[test]
fn the_same_front_is_the_same_bits_and_can_be_cancelled() {
    let wish = FrontProblem {
        target: Target::of_kelvin(3000.0, 0.0).unwrap(),
        against: Against::Ra,
        lines: 4,
        points: 4,
        floors: None,
    };
    let made = || front(&wish, SampleTables::shipped(), &Progress::default()).unwrap();
    assert_eq!(made(), made());
    let progress = Progress::default();
    progress.cancel();
    assert_eq!(front(&wish, SampleTables::shipped(), &progress), Ok(None));
    for lines in [1, 9] {
        let wish = FrontProblem {
            lines,
            ..wish.clone()
        };
        assert_eq!(
            front(&wish, SampleTables::shipped(), &Progress::default()),
            Err(MixError::Channels { found: lines })
        );
    }
}

const LEDS: [&str; 8] = [
    "gauss:420,15",
    "gauss:450,20",
    "gauss:475,25",
    "gauss:505,30",
    "gauss:530,35",
    "gauss:590,15",
    "gauss:630,20",
    "gauss:660,20",
];

fn at_4000() -> Option<Target> {
    Some(Target::of_kelvin(4000.0, 0.0).unwrap())
}

#[test]
fn each_favour_is_best_at_what_it_favours() {
    let channels = named(&LEDS);
    let value = |objective| {
        let found = solved(
            &channels,
            Problem {
                target: at_4000(),
                objective,
                ..Problem::default()
            },
        );
        assert!(
            found.reached && found.delta_uv_to_target.unwrap() < 1e-6,
            "{found:?}"
        );
        found.figures
    };
    let all: Vec<_> = Objective::ALL.map(value).to_vec();
    let [ler, rf, ra, melanopic, fewest] = &all[..] else {
        panic!("five favours");
    };
    for other in &all {
        assert!(ler.ler >= other.ler - 1e-9 && rf.rf >= other.rf && ra.ra >= other.ra);
        assert!(melanopic.melanopic_der >= other.melanopic_der - 1e-9);
    }
    assert_eq!(
        fewest.ler, ler.ler,
        "three channels reach the greatest efficacy"
    );
    assert!(rf.rf.unwrap() > 90.0 && ra.ra.unwrap() > 93.0);
}

#[test]
fn no_random_mixture_of_the_colour_is_clearly_better_than_the_solved_one() {
    let channels = named(&LEDS);
    let mixer = Mixer::new(&channels, SampleTables::shipped()).unwrap();
    let target = at_4000();
    let best = |objective| {
        mixer
            .solve(&Problem {
                target,
                objective,
                ..Problem::default()
            })
            .figures
    };
    let (rf, ra) = (
        best(Objective::Rf).rf.unwrap(),
        best(Objective::Ra).ra.unwrap(),
    );
    // Mixtures of the colour: random mixtures of the corners that random prices lead to, here by
    // matching random lights with the colour exact.
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1_u64 << 24) as f64
    };
    for _ in 0..400 {
        let goal: Vec<f64> = {
            let weights: Vec<f64> = channels.iter().map(|_| random().powi(2)).collect();
            mixed(&channels, &weights)
        };
        let found = mixer.solve(&Problem {
            target,
            alike: Some(&goal),
            ..Problem::default()
        });
        assert!(found.reached);
        // Sizes of differences are rounded off by 3e-4 in the end: .002 of Ra, .003 of Rf.
        assert!(
            found.figures.rf.unwrap() < rf + 0.003,
            "{:?}",
            found.figures
        );
        assert!(
            found.figures.ra.unwrap() < ra + 0.003,
            "{:?}",
            found.figures
        );
    }
}

#[test]
fn two_floors_of_one_number_are_each_their_own() {
    let wish = |floors: Floors| Problem {
        target: at_4000(),
        objective: Objective::Ra,
        floors,
        ..Problem::default()
    };
    let channels = named(&LEDS);
    let melanopic = Floors::default().with("melanopic=0.75").unwrap();
    let alone = solved(&channels, wish(melanopic));
    // A floor of .75 lm/W is no floor: every white has more.
    let both = solved(&channels, wish(melanopic.with("ler=0.75").unwrap()));
    assert_eq!(alone.reached, both.reached);
    let [alone, both] = [alone, both].map(|found| found.figures);
    assert!((alone.melanopic_der - both.melanopic_der).abs() < 1e-3);
    assert!((alone.ra.unwrap() - both.ra.unwrap()).abs() < 0.05);
}

#[test]
fn floors_are_kept_or_what_is_missing_is_told() {
    let channels = named(&LEDS);
    let floors = Floors::default()
        .with("rf=80")
        .unwrap()
        .with("melanopic=0.6")
        .unwrap();
    let found = solved(
        &channels,
        Problem {
            target: at_4000(),
            floors,
            ..Problem::default()
        },
    );
    assert!(found.reached, "{found:?}");
    assert!(found.figures.rf.unwrap() >= 80.0 - 1e-3);
    assert!(found.figures.melanopic_der >= 0.6 - 1e-6);
    let best_rf = solved(
        &channels,
        Problem {
            target: at_4000(),
            objective: Objective::Rf,
            ..Problem::default()
        },
    );
    assert!(found.figures.ler > best_rf.figures.ler);
    let too_much = Floors::default().with("ler=900").unwrap();
    let refused = solved(
        &channels,
        Problem {
            target: at_4000(),
            floors: too_much,
            ..Problem::default()
        },
    );
    assert!(
        !refused.reached && refused.why.contains("LER"),
        "{}",
        refused.why
    );
    let too_good = Floors::default().with("rf=99.9").unwrap();
    let refused = solved(
        &channels,
        Problem {
            target: at_4000(),
            floors: too_good,
            ..Problem::default()
        },
    );
    assert!(
        !refused.reached && refused.why.contains("Rf"),
        "{}",
        refused.why
    );
    assert!(refused.delta_uv_to_target.unwrap() < 1e-6);
    // Two floors for one figure: neither is silently the one that counts.
    let twice = Floors::default().with("rf=80").unwrap().with("rf=10");
    assert_eq!(
        twice.unwrap_err().to_string(),
        "expected one floor for each figure, found \"rf=10\""
    );
    for wrong in ["rf", "rf=x", "cri=80", "rf=nan"] {
        assert!(Floors::default().with(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn a_fixed_channel_stays_and_the_others_bring_the_colour() {
    let channels = named(&[
        "gauss:450,20",
        "gauss:530,35=2.5",
        "gauss:590,15",
        "gauss:630,20",
    ]);
    let found = solved(
        &channels,
        Problem {
            target: at_4000(),
            ..Problem::default()
        },
    );
    assert!(found.reached, "{found:?}");
    assert_eq!(found.weights[1], 2.5);
    assert!(found.delta_uv_to_target.unwrap() < 1e-6);
}

#[test]
fn without_a_target_the_faders_are_what_they_are() {
    let channels = named(&["blackbody:2700=1", "line:546.1=0.5", "daylight:6500"]);
    let found = solved(&channels, Problem::default());
    assert_eq!(found.weights, [1.0, 0.5, 1.0]);
    assert!(found.reached && found.delta_uv_to_target.is_none());
    let model = composite(&channels, &found.weights);
    assert_eq!(model.lines().len(), 1);
    assert_eq!(
        (model.lines()[0].at_nm, model.lines()[0].weight),
        (546.1, 0.5)
    );
}

#[test]
fn lights_of_a_name_need_their_table_and_some_power() {
    let spec = Spec::named("CIE A");
    assert!(Channel::new(spec.clone(), None).is_err());
    assert!(Channel::new(spec.clone(), Some(table("CIE A"))).is_ok());
    let dark = table("CIE A").scaled(0.0);
    assert_eq!(
        Channel::new(spec, Some(&dark)).unwrap_err(),
        MixError::NoPower {
            spec: "CIE A".to_owned()
        }
    );
    assert!(Mixer::new(&[], SampleTables::shipped()).is_err());
}

fn keys(value: &Value) -> BTreeSet<&str> {
    value
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect()
}

#[test]
fn the_json_has_the_promised_keys() {
    let channels = named(&LEDS);
    let found = solved(
        &channels,
        Problem {
            target: at_4000(),
            ..Problem::default()
        },
    );
    let value = mix_json(&channels, &found);
    let promised = [
        "channels",
        "xyz",
        "xy",
        "uv",
        "cct",
        "duv",
        "ra",
        "rf",
        "rg",
        "ler",
        "melanopic_der",
        "delta_uv_to_target",
        "reached",
        "why",
        "composite",
    ];
    assert_eq!(keys(&value), promised.into());
    let channel = ["spec", "weight", "share_of_power", "drive_percent"];
    assert_eq!(keys(&value["channels"][0]), channel.into());
    assert_eq!(value["composite"]["format"], "composite-spectrum");
    let faders = faders(&channels, &found.weights);
    assert_eq!(faders.iter().map(|f| f.dmx_8).max(), Some(255));
    assert_eq!(faders.iter().map(|f| f.dmx_16).max(), Some(65535));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn whatever_a_mixture_can_show_is_solved_exactly_and_anything_else_is_told(
        places in proptest::collection::vec((400.0..700.0_f64, 5.0..60.0_f64), 1..10),
        lines in proptest::collection::vec(400.0..700.0_f64, 0..5),
        seeds in proptest::collection::vec(0.0..1.0_f64, 15),
        asked in (0.1..0.6_f64, 0.05..0.6_f64),
    ) {
        let mut specs: Vec<String> =
            places.iter().map(|(at, width)| format!("gauss:{at},{width}")).collect();
        specs.extend(lines.iter().map(|at| format!("line:{at}")));
        let channels = channels(&specs);
        let mixer = Mixer::new(&channels, SampleTables::shipped()).unwrap();
        let weights: Vec<f64> = channels.iter().zip(&seeds).map(|(_, s)| s + 0.01).collect();
        let xy = mixer.figures(&weights).xy.unwrap();
        let target = Some(Target::of_xy(xy).unwrap());
        let found = mixer.solve(&Problem { target, ..Problem::default() });
        prop_assert!(found.reached, "{found:?}");
        prop_assert!(found.delta_uv_to_target.unwrap() < 1e-6);
        prop_assert!(found.weights.iter().all(|w| *w >= 0.0));
        // No mixture of the colour has more lumens for its power.
        prop_assert!(found.figures.ler >= mixer.figures(&weights).ler * (1.0 - 1e-9));
        prop_assert_eq!(&found, &mixer.solve(&Problem { target, ..Problem::default() }));
        if asked.0 + asked.1 <= 1.0 {
            let target = Target::of_xy([asked.0, asked.1]).unwrap();
            let found = mixer.solve(&Problem { target: Some(target), ..Problem::default() });
            let distance = found.delta_uv_to_target.unwrap();
            prop_assert_eq!(found.reached, distance < 1e-6);
            // No mixture is nearer.
            let [u, v] = uv_1976_from_xyz(mixer.figures(&weights).xyz.unwrap()).unwrap();
            let [tu, tv] = target.uv();
            prop_assert!((u - tu).hypot(v - tv) >= distance - 1e-7);
        }
    }
}
