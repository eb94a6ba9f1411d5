//! What is made follows what it is made of, is undone and saved like everything else, and can be
//! frozen.

use std::sync::Arc;

use spectral_explorer::{
    app::{
        App, Command, Entry, FIRST_LIGHT, MadeFor, Recipe, Settings, Times, Tone,
        combining::Act,
        open::{Loaded, load_path},
        workspace,
    },
    spectrum::{Band, Kind, NamedSpectrum, Rect, Sampled},
};

const RED: &str = "colorchecker_ohta/red";
const D65: &str = "cie_illuminants/CIE D65";

/// A light with these values at 380 and 780 nm.
fn slope(name: &str, first: f64, last: f64) -> NamedSpectrum {
    NamedSpectrum {
        name: name.to_owned(),
        kind: Kind::Light,
        unit: "relative".to_owned(),
        scale: 1.0,
        samples: Sampled::new(vec![380.0, 780.0], vec![first, last]).expect("two points"),
        notes: Vec::new(),
        source: "made up".to_owned(),
    }
}

fn own<'a>(app: &'a App, key: &str) -> &'a Arc<Entry> {
    let mut own = app.document().own.iter();
    own.find(|entry| entry.key == key).expect(key)
}

fn through(light: &str, chain: &[&str]) -> Recipe {
    Recipe::Through {
        light: light.to_owned(),
        chain: chain
            .iter()
            .map(|key| ((*key).to_owned(), Times::default()))
            .collect(),
    }
}

fn make(app: &mut App, recipe: Recipe) {
    let place = MadeFor::Shown;
    app.apply(Command::Make { recipe, place });
    app.end_gesture();
}

/// A lamp of one's own that a file brought, and what red paint leaves of it: own/1 and own/2.
fn lamp_off_red(folder: &std::path::Path) -> App {
    let path = folder.join("lamp.csv");
    std::fs::write(&path, "nm,W/nm\n380,1\n780,1\n").expect("a file");
    let Loaded::File(opened) = load_path(&path) else {
        panic!("a lamp")
    };
    let mut app = App::new();
    app.apply(Command::Open(vec![*opened]));
    make(&mut app, through("own/1", &[RED]));
    app
}

fn reread(app: &mut App, path: &std::path::Path) {
    let Loaded::File(opened) = load_path(path) else {
        panic!("a lamp")
    };
    app.apply(Command::Reread {
        key: "own/1".to_owned(),
        opened,
    });
    app.end_gesture();
}

#[test]
fn what_is_combined_follows_its_parts_keeps_its_doubt_in_a_project_and_is_frozen_without_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let put = |value: f64| {
        let path = folder.path().join("lamp.csv");
        let rows: String = (380..=780)
            .map(|nm| format!("{nm},{value},0.1\n"))
            .collect();
        let head = "# Spectral Explorer\n# name: lamp\n# kind: light\n# unit: W/nm\n";
        let head = format!("{head}wavelength_nm,lamp,sigma of lamp\n");
        std::fs::write(&path, format!("{head}{rows}")).expect("a file");
        path
    };
    let path = put(3.0);
    let Loaded::File(opened) = load_path(&path) else {
        panic!("a lamp")
    };
    let mut app = App::new();
    app.apply(Command::Open(vec![*opened]));
    assert_eq!(app.document().own.len(), 1, "its sigma is no spectrum");
    let act = Act::Formula {
        text: "A - 0.5*A".to_owned(),
        keep_all: false,
        equal: None,
        of_surface: false,
    };
    let parts = vec!["own/1".to_owned()];
    make(&mut app, Recipe::Combined { act, parts });
    let made = |app: &App| {
        let entry = own(app, "own/2").clone();
        let sigma = entry.measured.as_ref().and_then(|of| of.sigma.clone());
        (
            entry.spectrum.samples.values()[0],
            sigma.expect("a sigma")[0],
        )
    };
    assert_eq!(own(&app, "own/2").name(), "lamp - 0.5*lamp");
    // A - 0.5 A is half of A, its noise too.
    assert_eq!(made(&app), (1.5, 0.05));
    put(4.0);
    reread(&mut app, &path);
    assert_eq!(made(&app), (2.0, 0.05));
    let text = workspace::to_json(app.document(), None).expect("JSON");
    let restored = workspace::from_json(&text).expect("a project");
    assert_eq!(restored.losses, Vec::<String>::new());
    for (kept, entry) in restored.document.own.iter().zip(&app.document().own) {
        assert_eq!(kept.measured, entry.measured);
        assert_eq!(kept.origin.recipe(), entry.origin.recipe());
    }
    app.apply(Command::Remove {
        key: "own/1".to_owned(),
    });
    assert_eq!(own(&app, "own/2").origin.recipe(), None);
    assert_eq!(made(&app), (2.0, 0.05));
}

#[test]
fn what_a_chain_leaves_follows_the_light_and_undo_takes_both_back_in_one_step() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut app = lamp_off_red(folder.path());
    assert_eq!(own(&app, "own/2").name(), "lamp off red");
    let before = own(&app, "own/2").spectrum.clone();
    let path = folder.path().join("lamp.csv");
    std::fs::write(&path, "nm,W/nm\n380,2\n780,2\n").expect("a file");
    reread(&mut app, &path);
    let after = own(&app, "own/2").spectrum.clone();
    for (a, b) in before.samples.values().iter().zip(after.samples.values()) {
        assert_eq!(2.0 * a, *b, "a factor of two is exact");
    }
    // What is on screen is what is in the library.
    assert!(Arc::ptr_eq(&app.document().light, own(&app, "own/2")));
    app.apply(Command::Undo);
    assert_eq!(own(&app, "own/2").spectrum, before);
    app.apply(Command::Redo);
    assert_eq!(own(&app, "own/2").spectrum, after);
}

#[test]
fn a_made_spectrum_can_stand_on_another_made_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut app = lamp_off_red(folder.path());
    make(&mut app, through("own/2", &[RED]));
    let before = own(&app, "own/3").spectrum.samples.clone();
    let path = folder.path().join("lamp.csv");
    std::fs::write(&path, "nm,W/nm\n380,4\n780,4\n").expect("a file");
    reread(&mut app, &path);
    let after = &own(&app, "own/3").spectrum.samples;
    assert_eq!(4.0 * before.values()[9], after.values()[9]);
}

#[test]
fn frozen_numbers_stay_and_so_does_what_stood_on_something_that_is_gone() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lamp.csv");
    let mut app = lamp_off_red(folder.path());
    let before = own(&app, "own/2").spectrum.clone();
    app.apply(Command::Freeze {
        key: "own/2".to_owned(),
    });
    std::fs::write(&path, "nm,W/nm\n380,2\n780,2\n").expect("a file");
    reread(&mut app, &path);
    assert_eq!(own(&app, "own/2").spectrum, before);

    let mut app = lamp_off_red(folder.path());
    let before = own(&app, "own/2").spectrum.clone();
    app.apply(Command::Remove {
        key: "own/1".to_owned(),
    });
    assert_eq!(own(&app, "own/2").spectrum, before);
    assert_eq!(own(&app, "own/2").origin.recipe(), None);
    app.apply(Command::Undo);
    assert!(own(&app, "own/2").origin.recipe().is_some());
}

#[test]
fn a_name_given_by_hand_outlives_what_is_made_anew() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lamp.csv");
    let mut app = lamp_off_red(folder.path());
    app.apply(Command::Rename {
        key: "own/2".to_owned(),
        name: "my red".to_owned(),
    });
    std::fs::write(&path, "nm,W/nm\n380,2\n780,2\n").expect("a file");
    reread(&mut app, &path);
    assert_eq!(own(&app, "own/2").name(), "my red");
}

#[test]
fn the_same_recipe_with_another_light_is_what_that_light_gives_and_never_a_circle() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut app = lamp_off_red(folder.path());
    app.apply(Command::MakeOtherwise {
        key: "own/2".to_owned(),
        recipe: through(D65, &[RED]),
    });
    assert_eq!(own(&app, "own/2").name(), "CIE D65 off red");
    let before = app.document().clone();
    for recipe in [through("own/2", &[RED]), through("nobody", &[RED])] {
        app.apply(Command::MakeOtherwise {
            key: "own/2".to_owned(),
            recipe,
        });
        assert_eq!(*app.document(), before);
        let last = app.messages().last().expect("a word");
        assert_eq!(last.tone, Tone::Problem, "{last:?}");
    }
}

#[test]
fn a_metamer_follows_the_range_it_is_made_on() {
    let mut app = App::new();
    make(
        &mut app,
        Recipe::Metamer {
            light: D65.to_owned(),
            other: FIRST_LIGHT.to_owned(),
            patch_set: "colorchecker_ohta".to_owned(),
            patch: 3,
            room_percent: 50,
        },
    );
    let made = own(&app, "own/1").spectrum.samples.clone();
    assert_eq!((made.first_nm(), made.last_nm()), (380.0, 780.0));
    app.apply(Command::Edit(Settings {
        band: Band::new(400.0, 700.0).expect("a range"),
        ..app.document().settings
    }));
    let made = own(&app, "own/1").spectrum.samples.clone();
    assert_eq!((made.first_nm(), made.last_nm()), (400.0, 700.0));
}

#[test]
fn a_region_of_an_image_is_its_mean_and_follows_how_the_image_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let header = "ENVI\nsamples = 2\nlines = 1\nbands = 3\ndata type = 1\ninterleave = bsq\n\
                  wavelength units = nm\nwavelength = {400, 500, 600}\n";
    std::fs::write(folder.path().join("two.hdr"), header).expect("a header");
    let path = folder.path().join("two.img");
    std::fs::write(&path, [1, 2, 3, 4, 5, 6]).expect("six numbers");
    let open = || match load_path(&path) {
        Loaded::File(opened) => opened,
        other => panic!("an image: {other:?}"),
    };
    let mut app = App::new();
    app.apply(Command::Open(vec![*open()]));
    let image = "image/1".to_owned();
    let rect = Rect::between([0, 0], [1, 0]);
    make(&mut app, Recipe::Region { image, rect });
    // So small an image brings each of its pixels as a spectrum, too.
    let values = own(&app, "own/4").spectrum.samples.values().to_vec();
    let scale = app.document().images[0].image.scale;
    let means = [1.5, 3.5, 5.5].map(|mean| mean * scale);
    for (value, mean) in values.iter().zip(means) {
        assert!((value - mean).abs() < 1e-12, "{values:?} {means:?}");
    }
    std::fs::write(&path, [2, 4, 6, 8, 10, 12]).expect("six numbers");
    app.apply(Command::Reread {
        key: "image/1".to_owned(),
        opened: open(),
    });
    let doubled = own(&app, "own/4").spectrum.samples.values();
    assert!((doubled[1] - 2.0 * values[1]).abs() < 1e-12);
}

#[test]
fn a_project_keeps_the_recipe_and_the_numbers() {
    let folder = tempfile::tempdir().expect("a folder");
    let app = lamp_off_red(folder.path());
    let text = workspace::to_json(app.document(), None).expect("a text");
    let restored = workspace::from_json(&text).expect("a project");
    assert_eq!(restored.losses, Vec::<String>::new());
    assert_eq!(restored.document, *app.document());
    let mut app = App::with_document(restored.document);
    assert!(own(&app, "own/2").origin.recipe().is_some());
    // The lamp's file is not known any more; its kind can be changed all the same.
    app.apply(Command::Adopt(vec![slope("later", 1.0, 2.0)]));
    app.apply(Command::MakeOtherwise {
        key: "own/2".to_owned(),
        recipe: through("own/3", &[RED]),
    });
    assert_eq!(own(&app, "own/2").name(), "later off red");
}
