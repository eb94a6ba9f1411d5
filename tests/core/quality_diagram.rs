//! The geometry of diagrams against the facts.

use serde_json::Value;
use spectral_explorer::color::{
    quality::{
        Figures, Light, daylight, daylight_xy,
        diagram::{
            ELLIPSES, GAMUTS, Plane, QUADRANGLES, planckian_locus, spectral_locus, tick,
            uv_1960_of_cct, xy_from_uv_1960,
        },
    },
    uv_1960_from_kelvin,
};

fn facts() -> Value {
    serde_json::from_str(include_str!("../golden/diagram_facts.json")).expect("a golden file")
}

fn pair(value: &Value) -> [f64; 2] {
    [value[0].as_f64().unwrap(), value[1].as_f64().unwrap()]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

#[test]
fn quadrangles_have_the_corners_of_the_standard() {
    let facts = facts();
    let items = facts["ansi_quadrangles"]["items"].as_array().unwrap();
    assert_eq!(items.len(), QUADRANGLES.len());
    for (found, item) in QUADRANGLES.iter().zip(items) {
        assert_eq!(Some(found.nominal_k), item["nominal_K"].as_f64());
        assert_eq!(Some(found.target_k), item["target_K"].as_f64());
        assert_eq!(Some(found.tolerance_k), item["tolerance_K"].as_f64());
        for (found, expected) in found
            .corners
            .iter()
            .zip(item["corners"].as_array().unwrap())
        {
            assert!(distance(*found, pair(expected)) < 2e-5, "{item}");
        }
        if let Some(quoted) = item["corners_quoted_2015"].as_array() {
            for (found, expected) in found.corners.iter().zip(quoted) {
                // Four decimals, from another computation.
                assert!(distance(*found, pair(expected)) < 2e-4, "{item}");
            }
        }
        // Stated to four decimals, from a Duv rounded to four.
        assert!(
            distance(found.centre, pair(&item["centre"])) < 2e-4,
            "{item}"
        );
    }
}

#[test]
fn blackbodies_lie_where_they_were_computed_to_lie() {
    let facts = facts();
    for item in facts["planck_locus"]["items"].as_array().unwrap() {
        let kelvin = item["K"].as_f64().unwrap_or(f64::INFINITY);
        let at = uv_1960_of_cct(kelvin, 0.0).unwrap();
        // Seven decimals are told.
        assert!(distance(at, pair(&item["uv"])) < 1e-7, "{item}");
        assert!(
            distance(xy_from_uv_1960(at), pair(&item["xy"])) < 2e-7,
            "{item}"
        );
        if item["isotherm_uv"].is_array() {
            let beside = uv_1960_of_cct(kelvin, 0.01).unwrap();
            let direction = [0, 1].map(|k| (beside[k] - at[k]) / 0.01);
            // Six decimals are told.
            assert!(
                distance(direction, pair(&item["isotherm_uv"])) < 2e-6,
                "{item}: {direction:?}"
            );
        }
    }
    let curve = planckian_locus(Plane::Xy);
    let first = xy_from_uv_1960(uv_1960_from_kelvin(1000.0).unwrap());
    assert_eq!(curve[0], first);
    let mark = tick(4000.0, 0.01, Plane::Xy).unwrap();
    assert!(mark.above[1] > mark.at[1] && mark.at[1] > mark.below[1]);
}

#[test]
fn daylight_lies_where_it_was_computed_to_lie() {
    let facts = facts();
    for item in facts["daylight_locus"]["items"].as_array().unwrap() {
        let kelvin = item["K"].as_f64().unwrap();
        assert!(
            distance(daylight_xy(kelvin), pair(&item["xy"])) < 1e-7,
            "{item}"
        );
        let light = Light::of_nm_values(&daylight(kelvin));
        let found = Figures::of(&light, None).xy[0].clone().unwrap();
        assert!(
            distance(found, pair(&item["xy_of_spectrum"])) < 1e-7,
            "{item}"
        );
    }
}

#[test]
fn gamuts_and_ellipses_are_those_of_their_sources() {
    let facts = facts();
    for gamut in GAMUTS {
        let item = &facts["rgb_primaries"]["items"][gamut.name];
        for (found, expected) in gamut
            .primaries
            .iter()
            .zip(item["primaries"].as_array().unwrap())
        {
            assert_eq!(*found, pair(expected), "{}", gamut.name);
        }
        assert_eq!(gamut.white, pair(&item["white"]));
    }
    let items = facts["macadam_1942"]["items"].as_array().unwrap();
    assert_eq!(items.len(), ELLIPSES.len());
    for (found, item) in ELLIPSES.iter().zip(items) {
        let expected: Vec<f64> = item
            .as_array()
            .unwrap()
            .iter()
            .map(|v| v.as_f64().unwrap())
            .collect();
        let [x, y] = found.centre;
        let [long, short] = found.semi_axes;
        assert_eq!(vec![x, y, long, short, found.angle_deg], expected);
    }
}

#[test]
fn the_locus_goes_round_the_primaries_of_srgb() {
    let locus: Vec<[f64; 2]> = spectral_locus(Default::default(), Plane::Xy)
        .iter()
        .map(|point| point.at)
        .collect();
    // The red of P3 and the primaries of Rec. 2020 stand on the locus itself.
    for gamut in &GAMUTS[..1] {
        for corner in gamut.primaries {
            // Around a point inside, the angles of a closed curve add up to a turn.
            let angle = |p: [f64; 2]| (p[1] - corner[1]).atan2(p[0] - corner[0]);
            let next = locus.iter().cycle().skip(1);
            let turn: f64 = locus
                .iter()
                .zip(next)
                .map(|(a, b)| {
                    let step = angle(*b) - angle(*a);
                    (step + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
                        - std::f64::consts::PI
                })
                .sum();
            assert!(
                (turn.abs() - std::f64::consts::TAU).abs() < 1e-9,
                "{}",
                gamut.name
            );
        }
    }
}
