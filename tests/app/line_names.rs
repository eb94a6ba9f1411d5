//! The names of the lines of all shipped lights, against a table that was read by eye.

use std::collections::BTreeMap;

use crate::root::root;
use spectral_explorer::{
    app::{App, Command, Entry, Settings, entry::bundled_entries},
    spectrum::{Band, Kind},
};

type Names = BTreeMap<String, Vec<String>>;

/// Place and name of each spike, "-" where it has none, as the first look at a light shows them.
fn names(app: &App) -> Vec<String> {
    let spikes = app.derived().model.spikes.iter();
    spikes
        .zip(app.spike_names())
        .map(|(spike, name)| format!("{:.1} {}", spike.at_nm, name.safe.as_deref().unwrap_or("-")))
        .collect()
}

fn lights() -> impl Iterator<Item = std::sync::Arc<Entry>> {
    bundled_entries()
        .into_iter()
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
