//! The names of the lines of all shipped lights, against a table that was read by eye.

use std::collections::BTreeMap;

use crate::root::root;
use spectral_explorer::{
    app::{App, Command, Entry, Families, Settings, SpikeAct, bundled_entries},
    spectrum::{Band, Kind},
};

type Names = BTreeMap<String, Vec<String>>;

/// Place and name of each spike, "-" where it has none, as the first look at a light shows them.
fn names(app: &App) -> Vec<String> {
    let spikes = app.derived().model.lines().iter();
    spikes
        .zip(app.spike_names())
        .map(|(spike, name)| format!("{:.1} {}", spike.at_nm, name.safe.as_deref().unwrap_or("-")))
        .collect()
}

fn lights() -> impl Iterator<Item = &'static std::sync::Arc<Entry>> {
    bundled_entries()
        .iter()
        .filter(|entry| entry.kind() == Kind::Light)
}

fn expected() -> Names {
    let path = root().join("tests/data/line_names.json");
    let text = std::fs::read_to_string(path).expect("the table");
    serde_json::from_str(&text).expect("names by light")
}

#[test]
fn the_lines_of_every_shipped_light_have_the_names_of_the_table() {
    let mut app = App::new();
    let mut found = Names::new();
    for light in lights() {
        app.apply(Command::Show(light.clone()));
        found.insert(light.key.clone(), names(&app));
    }
    // What is to be copied when a rule is changed on purpose, after it was read.
    println!("{}", serde_json::to_string_pretty(&found).unwrap());
    let expected = expected();
    for (key, names) in &found {
        assert_eq!(Some(names), expected.get(key), "{key}");
    }
    assert_eq!(found.len(), expected.len(), "every light once");
}

#[test]
fn the_names_do_not_change_while_the_knobs_are_turned() {
    let mut app = App::new();
    for key in [
        "cie_fluorescent_1nm/FL2",
        "cie_fluorescent_1nm/FL11",
        "cie_hp_5nm/HP1",
        "lamps_nist_traditional/Metal Halide",
    ] {
        app.apply(Command::Show(app.entry(key).expect(key)));
        app.apply(Command::Edit(Settings::default()));
        let at_first = names(&app);
        for (threshold_percent, order, from_nm) in [(0.2, 3, 380.0), (2.0, 20, 400.0)] {
            app.apply(Command::Edit(Settings {
                threshold_percent,
                order,
                band: Band::new(from_nm, 720.0).unwrap(),
                ..Settings::default()
            }));
            for name in names(&app) {
                let (nm, words) = name.split_once(' ').unwrap();
                let same = |other: &&String| other.split_once(' ').unwrap().0 == nm;
                if let Some(before) = at_first.iter().find(same) {
                    assert_eq!(before, &name, "{key}, {threshold_percent} %, {words}");
                }
            }
        }
    }
}

/// Which elements' names a family of lamps may carry.
fn may_be_in(family: &str) -> &'static [&'static str] {
    match family {
        "tube" | "broad-tube" | "three-band" => &["Hg", "terbium", "europium"],
        "mercury" => &["Hg", "europium"],
        "hps" => &["Na", "K"],
        "lps" => &["Na"],
        "metal-halide" => &["Hg", "Na", "Tl", "Sc", "Li", "In", "Dy"],
        "paper" => &["Hg", "Na"],
        "laser" => &["Ne"],
        _ => &[],
    }
}

#[test]
fn no_light_carries_the_name_of_an_element_that_is_not_in_it() {
    let mut app = App::new();
    for light in lights() {
        app.apply(Command::Show(light.clone()));
        let family = Families::shipped().family_of(&light.key).expect("a family");
        let tube = light.key.strip_prefix("line_tubes/");
        for name in names(&app) {
            let words = name.split_once(' ').unwrap().1;
            let element = words.split(' ').next().unwrap();
            if element == "-" {
                continue;
            }
            match tube {
                Some(tube) => {
                    let symbol = TUBES.iter().find(|(name, _)| tube.starts_with(name));
                    assert_eq!(Some(element), symbol.map(|(_, symbol)| *symbol), "{tube}");
                }
                None => assert!(
                    may_be_in(&family.key).contains(&element),
                    "{} ({}): {name}",
                    light.key,
                    family.key
                ),
            }
        }
    }
}

const TUBES: [(&str, &str); 9] = [
    ("Hydrogen", "H"),
    ("Helium", "He"),
    ("Neon", "Ne"),
    ("Sodium", "Na"),
    ("Mercury", "Hg"),
    ("Cadmium", "Cd"),
    ("Argon", "Ar"),
    ("Krypton", "Kr"),
    ("Xenon", "Xe"),
];

#[test]
fn the_cies_sodium_lamps_show_sodium_and_its_tubes_mercury() {
    let mut app = App::new();
    let mut show = |key: &str| {
        app.apply(Command::Show(app.entry(key).expect(key)));
        names(&app)
    };
    for key in ["cie_hp_5nm/HP1", "cie_hp_5nm/HP2"] {
        let names = show(key);
        let sodium = names.iter().filter(|name| name.contains(" Na "));
        assert!(sodium.count() >= 2, "{key}: {names:?}");
    }
    let hp1 = show("cie_hp_5nm/HP1");
    assert!(
        hp1.iter()
            .any(|name| name.ends_with("Na D 589.3, self-reversed"))
    );
    for lamp in 1..=12 {
        for group in ["cie_fluorescent_1nm", "cie_fluorescent_5nm"] {
            let names = show(&format!("{group}/FL{lamp}"));
            // The green line is there on every tube, by itself or in terbium's band.
            let green = names.iter().filter(|name| name.contains("Hg 546.1"));
            assert_eq!(green.count(), 1, "{group}/FL{lamp}: {names:?}");
        }
    }
}

#[test]
fn a_spike_put_beside_the_lines_has_no_name() {
    let mut app = App::new();
    app.apply(Command::Show(
        app.entry("cie_fluorescent_1nm/FL2").expect("FL2"),
    ));
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 611.0,
        weight: 1.0,
    });
    let names = names(&app);
    assert!(names.contains(&"611.0 -".to_owned()), "{names:?}");
}
