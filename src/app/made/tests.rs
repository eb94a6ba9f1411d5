//! Tests of what is made by rule.

use super::*;
use crate::{
    app::{entry::composite_from_preset, library::Library},
    color::{
        Observer, cct_from_xyz, lab_from_xyz,
        xyz::{xyz_from_light, xyz_from_reflectance},
    },
    spectrum::Outside,
};

fn table(id: &str) -> Sampled {
    let found = Library::bundled().find_or_make(id).expect(id);
    let entry = crate::app::Entry::of_preset(&found).expect(id);
    entry.spectrum.samples
}

/// CIE 1931 x, y.
fn xy(id: &str) -> [f64; 2] {
    let xyz = xyz_from_light(&table(id), Outside::Zero, Observer::CIE_1931).expect(id);
    let sum = xyz.x + xyz.y + xyz.z;
    [xyz.x / sum, xyz.y / sum]
}

#[test]
fn line_tubes_are_composites_of_the_tables_lines_and_of_nothing_else() {
    let library = Library::bundled();
    let tubes = library.group("line_tubes").expect("the tubes");
    assert_eq!(tubes.items.len(), 9);
    for tube in &tubes.items {
        let printed = tube.composite().expect("a composite");
        let composite = composite_from_preset(printed).expect("finite numbers");
        assert!(composite.smooth().coefficients.iter().all(|c| *c == 0.0));
        let sum: f64 = composite.lines().iter().map(|s| s.weight).sum();
        assert!((sum - 100.0).abs() < 1e-9, "{}: {sum}", tube.name);
        let words = tube.notes.join(" ");
        assert!(words.contains("Made by this program") && words.contains("excitation"));
        for spike in &printed.spikes {
            // Neon's places are written with its rates: the table's own to a picometre.
            let near =
                |line: &crate::app::library::ElementLine| (line.at_nm - spike.at_nm).abs() < 0.0021;
            assert!(
                library.lines().iter().any(near),
                "{} {}",
                tube.name,
                spike.at_nm
            );
        }
        assert!(is_made(&tube.id()));
    }
}

#[test]
fn the_neon_tube_is_red_and_the_sodium_tube_yellow() {
    // A neon sign is at 0.66 to 0.68, 0.32 to 0.34 whatever drives it: its lines are all red.
    let [x, y] = xy("line_tubes/Neon tube");
    assert!(
        (0.65..0.69).contains(&x) && (0.31..0.35).contains(&y),
        "{x} {y}"
    );
    // The spectrum locus at 589.3 nm.
    let [x, y] = xy("line_tubes/Sodium tube");
    assert!(
        (x - 0.569).abs() < 0.01 && (y - 0.430).abs() < 0.01,
        "{x} {y}"
    );
    let [x, y] = xy("line_tubes/Hydrogen tube");
    assert!(x > 0.25 && y < 0.2, "hydrogen glows pink: {x} {y}");
}

#[test]
fn a_candle_has_the_temperature_of_its_soot() {
    let candle = table("thermal_lights/Candle flame");
    let xyz = xyz_from_light(&candle, Outside::Zero, Observer::CIE_1931).expect("light");
    let cct = cct_from_xyz(xyz).expect("on the locus");
    assert!(
        (cct.kelvin - 1900.0).abs() < 2.0 && cct.duv.abs() < 1e-4,
        "{cct:?}"
    );
    assert_eq!(
        on_demand("black body 2700 K").expect("it").name,
        "Black body 2700 K"
    );
    assert!(on_demand("black body 12 K").is_none());
}

#[test]
fn ideal_filters_stand_at_any_place_and_keep_it() {
    for (asked, name) in [
        ("long-pass 550", "Ideal long-pass 550 nm"),
        ("Longpass 546.1 nm", "Ideal long-pass 546.1 nm"),
        (
            "ideal_filters/Ideal short-pass 480 nm",
            "Ideal short-pass 480 nm",
        ),
        ("band-pass 546/10", "Ideal band-pass 546 nm, 10 nm wide"),
        (
            "Ideal notch 589 nm, 20 nm wide",
            "Ideal notch 589 nm, 20 nm wide",
        ),
    ] {
        let made = on_demand(asked).expect(asked);
        assert_eq!(made.name, name);
        // By its own full name it is found again.
        assert_eq!(on_demand(&made.id()).expect(name), made);
        assert!(made.notes[0].starts_with("Made by this program"));
    }
    for refused in [
        "long-pass",
        "long-pass 50",
        "band-pass 546",
        "notch 500/0",
        "glass 550",
        "550",
    ] {
        assert!(on_demand(refused).is_none(), "{refused}");
    }
    // Nothing below the edge, all above it, and its place to the last digit.
    let edge = table("long-pass 546.3");
    let ends = [545.0, 548.0].map(|nm| edge.at(nm, Outside::Hold));
    assert_eq!(ends, [0.0, 1.0]);
    assert!((edge.power_between(300.0, 1100.0) - (1100.0 - 546.3)).abs() < 1e-9);
    let band = table("band-pass 546.25/10.5");
    assert!((band.power_between(300.0, 1100.0) - 10.5).abs() < 1e-9);
    let notch = table("notch 589/20");
    assert_eq!(
        (
            notch.at(589.0, Outside::Hold),
            notch.at(620.0, Outside::Hold)
        ),
        (0.0, 1.0)
    );
}

#[test]
fn gels_have_the_hue_of_their_name_and_turn_whites_into_each_other() {
    // Hue angles of CIELAB under daylight: red from 25, yellow 90, green 150, cyan 200, blue 300,
    // magenta 325, pink before red; bands as wide as the names are loose.
    let hues = [
        ("Straw", 85.0..110.0),
        ("Amber", 70.0..90.0),
        ("Orange", 45.0..70.0),
        ("Red", 25.0..45.0),
        ("Pink", 330.0..355.0),
        ("Magenta", 318.0..335.0),
        ("Lavender", 295.0..318.0),
        ("Blue", 280.0..312.0),
        ("Steel blue", 205.0..240.0),
        ("Cyan", 190.0..215.0),
        ("Green", 130.0..160.0),
    ];
    let daylight = table("cie_illuminants/CIE D65");
    let white = xyz_from_light(&daylight, Outside::Zero, Observer::CIE_1931).expect("daylight");
    for (name, hue) in hues {
        let gel = table(&format!("stage_gels/{name} gel"));
        let xyz = xyz_from_reflectance(&gel, &daylight, Observer::CIE_1931).expect(name);
        let found = lab_from_xyz(xyz, white).hue_degrees().expect(name);
        assert!(hue.contains(&found), "{name}: {found}");
    }
    // Blackbodies that pass, within what the ends of the observer's table beyond the gel change.
    for (name, from, to) in [
        ("Warming gel 5600 K to 3200 K", 5600.0, 3200.0),
        ("Cooling gel 3200 K to 5600 K", 3200.0, 5600.0),
    ] {
        let gel = table(&format!("stage_gels/{name}"));
        let light = table(&format!("black body {from} K"));
        let xyz = xyz_from_reflectance(&gel, &light, Observer::CIE_1931).expect(name);
        let kelvin = cct_from_xyz(xyz).expect(name).kelvin;
        assert!((kelvin - to).abs() < 2.0, "{name}: {kelvin}");
    }
}

#[test]
fn everyday_surfaces_are_24_shipped_tables_with_their_sources() {
    let library = Library::bundled();
    let set = library.group(EVERYDAY_SET).expect("the set");
    assert_eq!(set.items.len(), 24);
    for item in &set.items {
        let of = item.notes[0]
            .strip_prefix("The table ")
            .and_then(|rest| rest.strip_suffix(" under an everyday name."))
            .expect("where it is from");
        let origin = library.find(of).expect(of);
        assert_eq!(
            item.spectrum().unwrap().samples,
            origin.spectrum().unwrap().samples
        );
        assert_eq!(
            (&item.source, &item.licence),
            (&origin.source, &origin.licence)
        );
        assert!(!is_made(&item.id()), "it was measured");
        // No plain name means two things.
        assert_eq!(library.find(&item.name).expect("one").id(), item.id());
    }
}

#[test]
fn what_is_made_stands_beside_the_tables_that_studies_count() {
    let library = Library::bundled();
    assert!(library.presets().all(|preset| !is_made(&preset.id())));
    assert!(library.everything().count() > library.presets().count() + 40);
}
