//! Mixtures by figures of samples, beside the best of a slow search with many starts.

use serde_json::Value;
use spectral_explorer::{
    color::{
        cct_from_xyz,
        quality::{Light, fidelity, rendering},
    },
    design::{
        SampleTables,
        mixture::{Channel, mixed},
        solve::{Care, Floors, MixFigures, Mixer, Objective, Problem, Solution, Target},
    },
};

struct Case {
    channels: Vec<Channel>,
    target: Target,
    /// Favour, its figure at the best, and the weights there.
    best: [(Objective, f64, Vec<f64>); 2],
}

fn cases() -> Vec<Case> {
    let golden: Value = serde_json::from_str(include_str!("../golden/mix_best.json")).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    let case = |case: &Value| {
        let channel =
            |words: &Value| Channel::new(words.as_str().unwrap().parse().unwrap(), None).unwrap();
        let best = |objective: Objective| {
            let weights = case[format!("weights_{}", objective.word())]
                .as_array()
                .unwrap();
            let weights = weights.iter().map(number).collect();
            (objective, number(&case[objective.word()]), weights)
        };
        Case {
            channels: case["channels"]
                .as_array()
                .unwrap()
                .iter()
                .map(channel)
                .collect(),
            target: Target::of_kelvin(number(&case["kelvin"]), 0.0).unwrap(),
            best: [best(Objective::Ra), best(Objective::Rf)],
        }
    };
    let cases: Vec<Case> = golden["cases"]
        .as_array()
        .unwrap()
        .iter()
        .map(case)
        .collect();
    assert_eq!(cases.len(), 64);
    cases
}

fn solved(channels: &[Channel], target: Target, objective: Objective, floors: Floors) -> Solution {
    let mixer = Mixer::new(channels, SampleTables::shipped()).unwrap();
    mixer.solve(&Problem {
        target: Some(target),
        objective,
        floors,
        ..Problem::default()
    })
}

fn figure(objective: Objective, figures: &MixFigures) -> f64 {
    match objective {
        Objective::Ra => figures.ra.unwrap(),
        _ => figures.rf.unwrap(),
    }
}

fn floors(objective: Objective, floor: f64) -> Floors {
    match objective {
        Objective::Ra => Floors {
            ra: Some(floor),
            ..Floors::default()
        },
        _ => Floors {
            rf: Some(floor),
            ..Floors::default()
        },
    }
}

#[test]
fn mixtures_of_eight_channels_are_as_good_as_the_best_of_a_slow_search() {
    for (index, case) in cases().iter().enumerate() {
        for (objective, best, weights) in &case.best {
            let mixer = Mixer::new(&case.channels, SampleTables::shipped()).unwrap();
            // The same definitions: nine digits of weights, four of the figure; the temperature is
            // found again to 0.1 K here.
            let given = figure(*objective, &mixer.figures(weights));
            assert!(
                (given - best).abs() < 0.005,
                "{index} {objective:?}: {given} {best}"
            );
            for care in [Care::Full, Care::Quick] {
                let found = mixer.solve(&Problem {
                    target: Some(case.target),
                    objective: *objective,
                    care,
                    ..Problem::default()
                });
                assert!(found.reached && found.delta_uv_to_target.unwrap() < 1e-9);
                assert!(found.weights.iter().all(|w| *w >= 0.0));
                // The issue asks for .1; sizes of differences are rounded off by 3e-4 in the end.
                let found = figure(*objective, &found.figures);
                assert!(
                    found > best - 0.01,
                    "{index} {objective:?} {care:?}: {found} {best}"
                );
            }
        }
    }
}

#[test]
fn a_floor_below_the_best_is_met_and_one_above_it_is_not() {
    for (index, case) in cases().iter().enumerate().step_by(3) {
        for (objective, best, _) in &case.best {
            for wish in [Objective::Ler, Objective::Melanopic] {
                let found = solved(
                    &case.channels,
                    case.target,
                    wish,
                    floors(*objective, best - 0.05),
                );
                assert!(found.reached, "{index} {objective:?} {best}: {}", found.why);
                // The floor costs: without it there is more of what is favoured.
                let free = solved(&case.channels, case.target, wish, Floors::default());
                let worth = |solution: &Solution| match wish {
                    Objective::Ler => solution.figures.ler,
                    _ => solution.figures.melanopic_der,
                };
                assert!(worth(&free) >= worth(&found) * (1.0 - 1e-9));
                // With a lower floor there is more, or the same.
                let low = floors(*objective, best - 3.0);
                let low = solved(&case.channels, case.target, wish, low);
                assert!(
                    low.reached && worth(&low) >= worth(&found) * (1.0 - 1e-5),
                    "{index}"
                );
            }
            let above = solved(
                &case.channels,
                case.target,
                Objective::Ler,
                floors(*objective, best + 0.05),
            );
            assert!(!above.reached, "{index} {objective:?}: {}", above.why);
            // What is told instead is the best that either method finds.
            let told = figure(*objective, &above.figures);
            assert!(
                (told - best).abs() < 0.02,
                "{index} {objective:?}: {told} {best}"
            );
        }
    }
}

#[test]
fn two_floors_are_both_met_where_a_mixture_meets_both() {
    for (index, case) in cases().iter().enumerate().step_by(7) {
        let [(_, _, ra), (_, _, rf)] = &case.best;
        let mixer = Mixer::new(&case.channels, SampleTables::shipped()).unwrap();
        // Half of the best of either, at one brightness: it has the colour too.
        let bright = |weights: &[f64]| {
            let sum = mixer.figures(weights).ler;
            weights.iter().map(|w| w / sum).collect::<Vec<f64>>()
        };
        let both = bright(ra).into_iter().zip(bright(rf));
        let between: Vec<f64> = both.map(|(a, b)| a + b).collect();
        let known = mixer.figures(&between);
        let floors = Floors {
            ra: known.ra.map(|v| v - 0.01),
            rf: known.rf.map(|v| v - 0.01),
            ler: Some(known.ler - 0.01),
            melanopic: None,
        };
        let found = solved(&case.channels, case.target, Objective::Ler, floors);
        assert!(found.reached, "{index}: {} {known:?}", found.why);
    }
}

#[test]
fn more_channels_are_never_worse() {
    for (index, case) in cases().iter().enumerate() {
        for objective in [Objective::Ra, Objective::Rf] {
            let mut before = f64::NEG_INFINITY;
            for count in 4..=8 {
                let some = &case.channels[..count];
                let found = solved(some, case.target, objective, Floors::default());
                if !found.reached {
                    assert_eq!(before, f64::NEG_INFINITY, "{index}: {}", found.why);
                    continue;
                }
                let now = figure(objective, &found.figures);
                // Rounded off as above, twice.
                assert!(
                    now > before - 0.01,
                    "{index} {objective:?} {count}: {now} {before}"
                );
                before = now;
            }
        }
    }
}

#[test]
fn the_figures_of_a_mixture_are_those_of_its_spectrum() {
    for case in &cases() {
        for (objective, _, _) in &case.best {
            let found = solved(&case.channels, case.target, *objective, Floors::default());
            let light = Light::of_nm_values(&mixed(&case.channels, &found.weights));
            let cct = cct_from_xyz(found.figures.xyz.unwrap()).unwrap();
            let rendering = rendering(&light, cct).unwrap();
            let fidelity = fidelity(&light, cct).unwrap();
            let off = |a: Option<f64>, b: f64| (a.unwrap() - b).abs();
            // The same sums in another order.
            assert!(off(found.figures.ra, rendering.ra) < 1e-9);
            assert!(off(found.figures.rf, fidelity.rf) < 1e-9);
            assert!(off(found.figures.rg, fidelity.rg) < 1e-9);
        }
    }
}

#[test]
fn beside_what_is_fixed_the_others_are_the_best_too() {
    for (index, case) in cases().iter().enumerate().step_by(5) {
        let (objective, best, weights) = &case.best[0];
        // The strongest of the best, fixed at its power there: the rest comes back.
        let strongest = (0..weights.len()).max_by(|a, b| weights[*a].total_cmp(&weights[*b]));
        let mut channels = case.channels.clone();
        let strongest = strongest.unwrap();
        channels[strongest].spec.fixed = Some(weights[strongest]);
        let found = solved(&channels, case.target, *objective, Floors::default());
        let figure = figure(*objective, &found.figures);
        assert!(
            found.reached && figure > best - 0.01,
            "{index}: {figure} {best}"
        );
        assert_eq!(found.weights[strongest], weights[strongest]);
    }
}
