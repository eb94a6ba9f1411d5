//! The program without a window: what a person does, said in commands, and what comes of it.

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc,
    },
    time::Duration,
};

use crate::common::shipped;
use crate::full::{D65, RED, awkward, full_document, full_preferences, preset, slope, spectrum};
use crate::plain::{FL11, plain};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use serde_json::Value;
use spectral_explorer::{
    app::{
        App, Command, Document, Entry, FIRST_LIGHT, FIRST_PATCH_SET, Height, Library, MadeFor,
        Opened, Recipe, Scale, Settings, SpikeAct, Subject, Times, Tone, View,
        chart::Theme,
        charts::tradeoff,
        derived::OF_CURVE,
        export::{Export, composite_file},
        open::{Came, Loaded, Loader, load_bytes, load_path, resolve},
        products::{Link, Products},
        report,
        workspace::{self, Preferences, Restored, StoredImage},
    },
    color::Observer,
    io::{composite_json, read_bytes},
    lamps::FitOptions,
    spectrum::{
        Band, Basis, Composite, HandSpike, Kind, NamedSpectrum, Sampled, Sampling, SpikeEdits,
        numbers_of_order,
    },
    study::Measure,
};

fn all_zero() -> NamedSpectrum {
    spectrum("darkness", Kind::Light, 380.0, 5.0, vec![0.0; 81])
}

/// A light with nothing visible: 850-1100 nm.
fn infrared() -> NamedSpectrum {
    let values = (0..=50).map(|i| 1.0 + (f64::from(i) / 5.0).sin()).collect();
    spectrum("heater", Kind::Light, 850.0, 5.0, values)
}

fn app_with(spectrum: NamedSpectrum) -> App {
    let mut app = plain();
    app.apply(Command::Adopt(vec![spectrum]));
    app
}

fn edit(app: &mut App, change: impl Fn(&mut Settings)) {
    let mut settings = app.document().settings;
    change(&mut settings);
    app.apply(Command::Edit(settings));
    app.end_gesture();
}

fn spikes(app: &App) -> usize {
    app.derived().model.lines().len()
}

/// Weights of all spikes and the integral of the smooth part's target: the energy of the light.
fn energy(app: &App) -> f64 {
    let derived = app.derived();
    let weights: f64 = derived.parts.spikes.iter().map(|s| s.spike.weight).sum();
    weights + derived.band.integral(&derived.parts.smooth)
}

/// Every number that is shown, to look for one that is none.
fn numbers_shown(app: &App) -> Vec<(&'static str, f64)> {
    let d = app.derived();
    let mut all = vec![("scale", app.scale_factor()), ("power", d.parts.power)];
    let list = |name: &'static str, values: &[f64]| -> Vec<(&'static str, f64)> {
        values.iter().map(|v| (name, *v)).collect()
    };
    all.extend(list("measured", &d.measured));
    all.extend(list("smooth", &d.smooth));
    all.extend(list("residual", &d.residual));
    all.extend(list("coefficient", &d.model.smooth().coefficients));
    for spike in d.model.lines() {
        all.extend(list("spike", &[spike.at_nm, spike.weight]));
    }
    let figures = Measure::ALL.map(|measure| d.figures[measure]);
    all.extend(figures.into_iter().flatten().map(|v| ("figure", v)));
    all.push(("missing luminance", d.colour.missing_luminance));
    for colour in [d.colour.exact, d.colour.model, d.colour.full]
        .into_iter()
        .flatten()
    {
        all.extend(list("xyz", &colour.xyz.to_array()));
        all.extend(list("xy", &colour.xy));
        all.extend(list("uv", &colour.uv));
        if let Some(Ok(cct)) = colour.cct {
            all.extend(list("cct", &[cct.kelvin, cct.duv]));
        }
    }
    all.extend(d.colour.delta_e_2000.map(|v| ("own delta E", v)));
    all.extend(d.colour.delta_uv.map(|v| ("delta uv", v)));
    if let Some(patches) = &d.patches {
        all.extend([("patches mean", patches.mean), ("patches max", patches.max)]);
        all.extend(patches.items.iter().map(|p| ("patch", p.delta_e_2000)));
    }
    for point in &d.curve {
        let values = OF_CURVE.map(|measure| point.figures[measure]);
        all.extend(values.into_iter().flatten().map(|v| ("curve", v)));
    }
    all
}

#[track_caller]
fn assert_all_finite(app: &App) {
    for (what, value) in numbers_shown(app) {
        assert!(value.is_finite(), "{what} is {value}");
    }
}

/// Words of a text that stand for no number.
fn no_numbers(text: &str) -> Vec<&str> {
    text.split(|c: char| !c.is_alphanumeric())
        .filter(|word| {
            let word = word.to_lowercase();
            word == "nan" || word == "inf" || word == "infinity"
        })
        .collect()
}

fn is_one_line(text: &str) -> bool {
    !text.is_empty() && !text.contains(['\n', '\r'])
}

// ------------------------------------------------------------------------------- first start

#[test]
fn the_first_start_shows_fl2_and_a_lamp_of_many_lines_has_them_as_spikes() {
    let first = App::new();
    assert_eq!(first.document().light.key, FIRST_LIGHT);
    assert_eq!(first.derived().model.lines().len(), 4, "mercury's four");
    let app = plain();
    assert_eq!(app.document().light.name(), "FL11");
    assert!(app.document().is_about_light());
    let m = spikes(&app);
    assert!(m >= 4, "a triphosphor lamp has more than {m} lines");
    assert_eq!(app.derived().numbers(), 2 * 7 + 1 + 2 * m);
    // The lamp's blue mercury line and its red europium line, on data of 1 nm.
    for line_nm in [435.8, 611.3] {
        let nearest = app.derived().model.lines().iter();
        let nearest = nearest
            .map(|s| (s.at_nm - line_nm).abs())
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1.5, "no spike within 1.5 nm of {line_nm}");
    }
    let names: Vec<_> = app
        .spike_names()
        .iter()
        .filter_map(|n| n.safe.clone())
        .collect();
    assert!(names.contains(&"Hg 435.8".to_owned()), "{names:?}");
    let patches = app.derived().patches.as_ref().expect("a light has patches");
    assert_eq!(app.document().patch_set, FIRST_PATCH_SET);
    assert_eq!(patches.items.len(), 24);
    assert!(app.undo_words().is_none() && app.redo_words().is_none());
    assert_eq!(app.message(), None);
    assert_all_finite(&app);
}

// ------------------------------------------------------------------------------------- knobs

#[test]
fn the_order_moves_the_numbers_and_the_errors_along_the_curve() {
    let mut app = plain();
    let m = spikes(&app);
    let mut last = f64::INFINITY;
    for order in [0, 1, 3, 7, 15, 40] {
        edit(&mut app, |s| s.order = order);
        let derived = app.derived();
        assert_eq!(spikes(&app), m, "the order does not touch the spikes");
        assert_eq!(derived.numbers(), numbers_of_order(order) + 2 * m);
        // Least squares: more functions never fit the smooth part worse.
        let rest: f64 = derived
            .smooth
            .iter()
            .zip(&derived.parts.smooth)
            .map(|(a, b)| (a - b).powi(2))
            .sum();
        assert!(rest < last, "order {order}: {rest} after {last}");
        last = rest;
        // The curve holds the same figures by a shorter way: sums in another order, so 1e-9.
        let point = derived.curve[order];
        assert_eq!((point.order, point.numbers), (order, derived.numbers()));
        for measure in OF_CURVE {
            let [curve, figure] =
                [point.figures, derived.figures].map(|f| f[measure].expect("FL11 has all"));
            if measure == Measure::Own {
                assert_abs_diff_eq!(curve, figure, epsilon = 1e-9);
            } else {
                assert_relative_eq!(curve, figure, max_relative = 1e-9);
            }
        }
    }
}

#[test]
fn a_higher_threshold_leaves_fewer_spikes_and_no_spikes_leaves_none() {
    let mut app = plain();
    let mut counts = Vec::new();
    for threshold in [0.01, 0.5, 2.0, 10.0, 50.0] {
        edit(&mut app, |s| s.threshold_percent = threshold);
        counts.push(spikes(&app));
        assert_eq!(app.derived().numbers(), 15 + 2 * spikes(&app));
        for spike in &app.derived().parts.spikes {
            let share = 100.0 * spike.spike.weight / app.derived().parts.power;
            assert!(share >= threshold, "{share} % passed {threshold} %");
        }
    }
    assert!(counts.is_sorted_by(|a, b| a >= b), "{counts:?}");
    assert!(counts[1] > counts[3] && counts[4] == 0, "{counts:?}");
    edit(&mut app, |s| {
        s.spikes = false;
        s.threshold_percent = 0.5;
    });
    assert_eq!((spikes(&app), app.derived().numbers()), (0, 15));
}

#[test]
fn silly_settings_become_the_nearest_sensible_ones() {
    let mut app = plain();
    let default = Settings::default();
    type Knob = fn(&mut Settings) -> &mut f64;
    let knobs: [(Knob, f64, [f64; 2]); 3] = [
        (
            |s| &mut s.threshold_percent,
            default.threshold_percent,
            [0.01, 50.0],
        ),
        (|s| &mut s.max_width_nm, default.max_width_nm, [1.0, 50.0]),
        (
            |s| &mut s.gradient_percent,
            default.gradient_percent,
            [0.1, 50.0],
        ),
    ];
    for (knob, default, [least, most]) in knobs {
        for (asked, got) in [
            (f64::NAN, default),
            (1e9, most),
            (f64::INFINITY, most),
            (f64::NEG_INFINITY, least),
            (-1.0, least),
            (0.0, least),
        ] {
            edit(&mut app, |s| *knob(s) = asked);
            let mut settings = app.document().settings;
            assert_eq!(*knob(&mut settings), got, "asked for {asked}");
            assert_all_finite(&app);
        }
    }
    edit(&mut app, |s| s.order = usize::MAX);
    assert_eq!(
        app.document().settings.order as f64,
        *Settings::ORDER.reach.range().end()
    );
    assert_all_finite(&app);
    let clamped = app.document().settings;
    assert_eq!(
        clamped,
        clamped.clamped(),
        "clamping twice is clamping once"
    );
}

#[test]
fn an_order_that_the_range_cannot_carry_is_cut_and_said() {
    let mut app = plain();
    edit(&mut app, |s| {
        s.band = Band::new(500.0, 520.0).expect("20 nm");
        s.order = 40;
    });
    let carried = app.document().settings.effective_order();
    assert!(carried < 40);
    assert_eq!(app.derived().model.smooth().order(), carried);
    let warnings = app.derived().warnings.join(" ");
    assert!(
        warnings.contains(&format!("Order cut to {carried}")),
        "{warnings}"
    );
    assert!(
        warnings.contains("leaves out"),
        "most of the light is outside: {warnings}"
    );
    assert_all_finite(&app);
}

// -------------------------------------------------------------------------------------- undo

/// The variant of a command; a new one must be thought of here and in the story below.
fn variant(command: &Command) -> &'static str {
    match command {
        Command::Edit(_) => "edit",
        Command::Show(_) => "show",
        Command::ShowWith { .. } => "show with",
        Command::Compare(_) => "compare",
        Command::ToggleOverlay(_) => "toggle overlay",
        Command::ClearOverlays => "clear overlays",
        Command::About(_) => "about",
        Command::EditSpikes(_) => "edit spikes",
        Command::TakeModel { .. } => "take model",
        Command::Analyse => "analyse",
        Command::Reset => "reset",
        Command::PatchSet(_) => "patch set",
        Command::Patch(_) => "patch",
        Command::ToggleOwnPatch { .. } => "toggle own patch",
        Command::Scale(_) => "scale",
        Command::WeightFactor(_) => "weight factor",
        Command::View(_) => "view",
        Command::Products(_) => "products",
        Command::Page(_) => "page",
        Command::Adopt(_) => "adopt",
        Command::Open(_) => "open",
        Command::Make { .. } => "make",
        Command::MakeOtherwise { .. } => "make otherwise",
        Command::Freeze { .. } => "freeze",
        Command::Reread { .. } => "reread",
        Command::ImageIsBack(_) => "image is back",
        Command::RemoveImage { .. } => "remove image",
        Command::Rename { .. } => "rename",
        Command::SetKind { .. } => "set kind",
        Command::Remove { .. } => "remove",
        Command::Replace(_) => "replace",
        Command::Undo | Command::Redo => "history",
    }
}

/// A light off the red patch.
fn off_red(light: &str) -> Recipe {
    Recipe::Through {
        light: light.to_owned(),
        chain: vec![(RED.to_owned(), Times::default())],
    }
}

/// A session in which every command changes something.
#[expect(clippy::too_many_lines, reason = "a table: one row a command")]
fn session(app: &App) -> Vec<Command> {
    let settings = app.document().settings;
    let view = app.document().view;
    let key = || "own/1".to_owned();
    vec![
        Command::Edit(Settings {
            order: 12,
            ..settings
        }),
        Command::Show(preset(app, D65)),
        Command::Show(preset(app, RED)),
        Command::ShowWith {
            entry: preset(app, D65),
            settings: Settings {
                order: 9,
                ..settings
            },
        },
        Command::About(Subject::Factor),
        Command::About(Subject::Light),
        Command::Compare(Some(preset(app, D65))),
        Command::ToggleOverlay(preset(app, FIRST_LIGHT)),
        Command::ClearOverlays,
        Command::EditSpikes(SpikeEdits {
            hand: vec![HandSpike {
                at_nm: 500.5,
                weight: 3.25,
                line_nm: None,
                window_nm: None,
                is_dip: false,
            }],
            deleted_nm: vec![611.0],
        }),
        Command::EditSpikes(SpikeEdits::default()),
        Command::TakeModel {
            settings: Settings {
                order: 9,
                basis: Basis::Cosine,
                ..settings
            },
            edits: SpikeEdits {
                hand: Vec::new(),
                deleted_nm: vec![546.0],
            },
        },
        Command::Show(preset(app, "paper/Mercury")),
        Command::Analyse,
        Command::Show(preset(app, D65)),
        Command::Patch(Some(3)),
        Command::PatchSet("cri_tcs".to_owned()),
        Command::Reset,
        Command::Scale(Scale::HundredLux),
        Command::WeightFactor(150.0),
        Command::View(View {
            height: Height::Log,
            ..view
        }),
        Command::Page({
            let mut pages = Box::new(app.document().pages.clone());
            pages.mix.desk = pages.mix.desk.dimmed(50.0);
            pages
        }),
        Command::Products(Products {
            chain: vec![Link::once(preset(app, RED))],
            ..Products::first()
        }),
        Command::Adopt(vec![slope("mine"), slope("mine too")]),
        Command::Rename {
            key: key(),
            name: "renamed".to_owned(),
        },
        Command::SetKind {
            key: key(),
            kind: Kind::Reflectance,
        },
        Command::ToggleOwnPatch { key: key() },
        Command::Open(vec![opened("once.csv", b"nm,W\n380,1\n400,4\n")]),
        Command::Reread {
            key: "own/3".to_owned(),
            opened: Box::new(opened("again.csv", b"nm,W\n380,1\n390,2\n400,3\n")),
        },
        Command::Make {
            recipe: off_red(FIRST_LIGHT),
            place: MadeFor::Shown,
        },
        Command::MakeOtherwise {
            key: "own/4".to_owned(),
            recipe: off_red(D65),
        },
        Command::Freeze {
            key: "own/4".to_owned(),
        },
        Command::Remove { key: key() },
        Command::Open(vec![opened_image()]),
        Command::RemoveImage {
            key: "image/5".to_owned(),
        },
        Command::Replace(Box::new(Document::about(preset(app, D65)))),
    ]
}

/// A file that was read.
#[track_caller]
fn opened(name: &str, bytes: &[u8]) -> Opened {
    match load_bytes(name, bytes) {
        Loaded::File(opened) => *opened,
        other => panic!("{name} is a table: {other:?}"),
    }
}

/// An image of two pixels and three bands.
fn opened_image() -> Opened {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let header = "ENVI\nsamples = 2\nlines = 1\nbands = 3\ndata type = 1\ninterleave = bsq\n\
                  wavelength units = nm\nwavelength = {400, 500, 600}\n";
    std::fs::write(folder.path().join("two.hdr"), header).expect("a header");
    let path = folder.path().join("two.img");
    std::fs::write(&path, [1, 2, 3, 4, 5, 6]).expect("six numbers");
    match load_path(&path) {
        Loaded::File(opened) => *opened,
        other => panic!("an image: {other:?}"),
    }
}

#[test]
fn every_command_is_undone_and_done_again_exactly() {
    let mut app = plain();
    let commands = session(&app);
    let seen: BTreeSet<&str> = commands.iter().map(variant).collect();
    assert_eq!(seen.len(), 30, "the session leaves out a command: {seen:?}");
    let mut states = vec![(app.document().clone(), app.derived().clone())];
    for command in commands {
        let words = variant(&command);
        app.end_gesture();
        app.apply(command);
        let (before, _) = states.last().expect("the first state");
        assert_ne!(app.document(), before, "{words} changed nothing");
        states.push((app.document().clone(), app.derived().clone()));
    }
    for (document, derived) in states.iter().rev().skip(1) {
        app.apply(Command::Undo);
        assert_eq!(app.document(), document);
        assert_eq!(app.derived(), derived, "what is shown follows");
    }
    assert!(app.undo_words().is_none());
    for (document, derived) in states.iter().skip(1) {
        app.apply(Command::Redo);
        assert_eq!(app.document(), document);
        assert_eq!(app.derived(), derived);
    }
    assert!(app.redo_words().is_none());
}

#[test]
fn what_cannot_change_the_model_derives_nothing_and_what_can_derives_it_anew() {
    let beside = [
        "compare",
        "toggle overlay",
        "clear overlays",
        "patch",
        "scale",
        "page",
        "products",
    ];
    let mut app = plain();
    for command in session(&app) {
        let words = variant(&command);
        let before = app.derived().clone();
        app.apply(command);
        let anew = App::with_document(app.document().clone());
        assert_eq!(app.derived(), anew.derived(), "{words}");
        assert_eq!(app.spike_names(), anew.spike_names(), "{words}");
        let laid = |app: &App| app.laid().map(|(_, laid)| laid).collect::<Vec<_>>();
        assert_eq!(laid(&app), laid(&anew), "{words}");
        if beside.contains(&words) {
            assert!(Arc::ptr_eq(&before, app.derived()), "{words} derived anew");
        }
    }
    // Of the layers only how patches are adapted is a part of the model's figures.
    let before = app.derived().clone();
    let view = app.document().view;
    let residual = !view.residual;
    app.apply(Command::View(View { residual, ..view }));
    assert!(Arc::ptr_eq(&before, app.derived()));
    let adapt_patches = !view.adapt_patches;
    app.apply(Command::View(View {
        adapt_patches,
        ..view
    }));
    assert!(!Arc::ptr_eq(&before, app.derived()));
}

#[test]
fn a_drag_is_one_step_of_undo_and_the_next_drag_another() {
    let mut app = plain();
    let first = app.document().clone();
    let drag = |app: &mut App, to: std::ops::Range<usize>| {
        for order in to {
            let settings = Settings {
                order,
                ..app.document().settings
            };
            app.apply(Command::Edit(settings));
        }
        app.end_gesture();
    };
    drag(&mut app, 8..20);
    let between = app.document().clone();
    drag(&mut app, 20..30);
    app.apply(Command::Undo);
    assert_eq!(app.document(), &between);
    app.apply(Command::Undo);
    assert_eq!(app.document(), &first);
    assert!(app.undo_words().is_none());
}

#[test]
fn another_kind_of_change_ends_a_drag_too() {
    let mut app = plain();
    let settings = app.document().settings;
    app.apply(Command::Edit(Settings {
        order: 9,
        ..settings
    }));
    app.apply(Command::Scale(Scale::PeakOne));
    app.apply(Command::Edit(Settings {
        order: 10,
        ..settings
    }));
    app.apply(Command::Undo);
    let document = app.document();
    assert_eq!(
        (document.settings.order, document.scale),
        (9, Scale::PeakOne)
    );
    app.apply(Command::Undo);
    app.apply(Command::Undo);
    assert_eq!(app.document().settings.order, 7);
    assert!(app.undo_words().is_none());
}

#[test]
fn a_change_after_undo_forgets_what_was_undone() {
    let mut app = plain();
    edit(&mut app, |s| s.order = 9);
    app.apply(Command::Undo);
    assert!(app.redo_words().is_some());
    edit(&mut app, |s| s.order = 3);
    assert!(app.redo_words().is_none());
    app.apply(Command::Redo);
    assert_eq!(app.document().settings.order, 3);
    assert_eq!(app.message().map(|m| m.tone), Some(Tone::Info));
}

#[test]
fn a_command_that_changes_nothing_is_no_step_and_no_work() {
    let mut app = plain();
    let revision = app.revision();
    app.apply(Command::Edit(app.document().settings));
    app.apply(Command::ClearOverlays);
    app.apply(Command::Show(app.document().light.clone()));
    app.apply(Command::Remove {
        key: "own/7".to_owned(),
    });
    app.apply(Command::Undo);
    assert!(app.undo_words().is_none());
    assert_eq!(app.revision(), revision);
    assert_eq!(
        app.message().map(|m| m.text.as_str()),
        Some("Nothing to undo.")
    );
}

#[test]
fn undo_reaches_back_over_loaded_files_and_opened_projects() {
    let mut app = plain();
    let first = app.document().clone();
    edit(&mut app, |s| s.order = 11);
    app.apply(Command::Adopt(vec![slope("one"), slope("two")]));
    assert_eq!(app.document().own.len(), 2);
    assert_eq!(app.document().light.name(), "one", "the first is shown");
    let project = Document::about(preset(&app, D65));
    app.apply(Command::Replace(Box::new(project)));
    assert!(app.document().own.is_empty());
    app.apply(Command::Undo);
    assert_eq!(app.document().own.len(), 2);
    app.apply(Command::Undo);
    assert!(app.document().own.is_empty());
    assert_eq!(app.document().settings.order, 11);
    app.apply(Command::Undo);
    assert_eq!(app.document(), &first);
}

// ---------------------------------------------------------------------------- overlays, subject

#[test]
fn an_overlay_comes_and_goes_and_the_subject_stays() {
    let mut app = plain();
    let subject = app.derived().clone();
    let (a, b) = (preset(&app, D65), preset(&app, RED));
    app.apply(Command::ToggleOverlay(a.clone()));
    app.apply(Command::ToggleOverlay(b.clone()));
    assert_eq!(app.document().overlays, [a.clone(), b.clone()]);
    assert_eq!(
        app.derived(),
        &subject,
        "overlays change nothing that is computed"
    );
    app.apply(Command::ToggleOverlay(a));
    assert_eq!(app.document().overlays, [b]);
    app.apply(Command::ClearOverlays);
    assert!(app.document().overlays.is_empty());
}

#[test]
fn what_is_neither_light_nor_reflectance_is_laid_over_and_said() {
    let mut app = plain();
    let observer = preset(&app, "observers/V(lambda) photopic");
    app.apply(Command::Show(observer.clone()));
    assert_eq!(app.document().light.key, FL11);
    assert_eq!(app.document().overlays, std::slice::from_ref(&observer));
    let message = app.message().expect("a sentence").text.clone();
    assert!(message.contains("overlay"), "{message}");
    app.apply(Command::Show(observer));
    assert_eq!(app.document().overlays.len(), 1, "once is enough");
}

#[test]
fn a_reflectance_is_looked_at_under_the_light() {
    let mut app = plain();
    app.apply(Command::Show(preset(&app, D65)));
    app.apply(Command::Show(preset(&app, RED)));
    assert_eq!(app.document().subject, Subject::Factor);
    assert_eq!(app.document().light.key, D65, "the light stays");
    let derived = app.derived();
    assert!(derived.patches.is_none());
    assert!(
        derived
            .curve
            .iter()
            .all(|p| p.figures[Measure::Patches].is_none() && p.figures[Measure::Own].is_some())
    );
    let exact = derived.colour.exact.expect("red has a colour");
    assert!(
        exact.cct.is_none(),
        "a reflectance has no colour temperature"
    );
    // The same by hand: light times reflectance times observer, Y of the light at 100.
    let band = Band::VISIBLE;
    let light = crate::common::on_band(D65, band);
    let red = crate::common::on_band(RED, band);
    let cmf = Observer::CIE_1931.table().on_band(band);
    let product: Vec<f64> = light.iter().zip(&red).map(|(s, r)| s * r).collect();
    let scale = 100.0 / band.inner(&light, &cmf[1]);
    for (got, row) in exact.xyz.to_array().into_iter().zip(cmf.iter()) {
        // The same sums in another order: a few rounding errors of numbers near 100.
        assert_abs_diff_eq!(got, scale * band.inner(&product, row), epsilon = 1e-10);
    }
    assert!(exact.xyz.y > 1.0 && exact.xyz.y < 50.0, "{:?}", exact.xyz);

    app.apply(Command::About(Subject::Light));
    assert!(app.derived().patches.is_some());
    assert!(app.document().factor.is_some(), "it stays selected");
    app.apply(Command::Show(preset(&app, "cie_illuminants/CIE A")));
    app.apply(Command::About(Subject::Factor));
    let under_a = app.derived().colour.exact.expect("red has a colour");
    assert!(
        under_a.xy[0] > exact.xy[0] + 0.05,
        "redder under incandescent light"
    );
}

// ------------------------------------------------------------------------------------ products

#[test]
fn a_selected_patch_gives_the_product_with_the_light() {
    let mut app = plain();
    assert_eq!(app.product(), None);
    let names: Vec<String> = {
        let patches = app.derived().patches.as_ref().expect("a light");
        patches.items.iter().map(|p| p.name.clone()).collect()
    };
    let index = names
        .iter()
        .position(|n| n == "red")
        .expect("the red patch");
    app.apply(Command::Patch(Some(index)));
    let product = app.product().expect("a patch is selected");
    assert_eq!(
        (product.name.as_str(), product.sampling),
        ("red", Sampling::Exact)
    );
    let derived = app.derived();
    let red = crate::common::on_band(RED, derived.band);
    assert_eq!(product.reflectance, red);
    for (i, r) in red.iter().enumerate() {
        assert_eq!(product.exact[i], derived.measured[i] * r);
        // The same product of two doubles, read from the series once more: rounding only.
        assert_relative_eq!(
            product.smooth[i],
            derived.smooth[i] * r,
            max_relative = 1e-9,
            epsilon = 1e-9
        );
    }
    assert_eq!(product.spikes.len(), spikes(&app));
    for (weighed, spike) in product.spikes.iter().zip(derived.model.lines()) {
        assert_eq!(weighed.at_nm, spike.at_nm);
        let r = derived.band.interpolate(&red, spike.at_nm);
        assert_relative_eq!(weighed.weight, spike.weight * r, max_relative = 1e-12);
    }
    // Products on a few points model the reflectance too, so they differ, each in its own way.
    let mut smooths = vec![product.smooth.clone()];
    for sampling in [
        Sampling::Paper,
        Sampling::Double,
        Sampling::ThreeN,
        Sampling::Convolution,
    ] {
        edit(&mut app, |s| s.sampling = sampling);
        let product = app.product().expect("a patch is selected");
        assert_eq!(product.sampling, sampling);
        for other in &smooths {
            let apart = product.smooth.iter().zip(other);
            let apart = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart > 1e-6, "{sampling:?} is like another");
        }
        smooths.push(product.smooth.clone());
    }
    app.apply(Command::Patch(None));
    assert_eq!(app.product(), None);
}

#[test]
fn a_patch_that_is_not_there_is_not_selected() {
    let mut app = plain();
    app.apply(Command::Patch(Some(24)));
    assert_eq!((app.document().patch, app.product()), (None, None));
    app.apply(Command::Patch(Some(23)));
    assert!(app.product().is_some());
    app.apply(Command::PatchSet("cri_tcs".to_owned()));
    assert_eq!(app.document().patch, None, "another set, another choice");
    app.apply(Command::PatchSet("no such group".to_owned()));
    assert_all_finite(&app);
    assert_eq!(app.derived().patches.as_ref().map(|p| p.items.len()), None);
}

#[test]
fn how_products_are_formed_moves_the_patches_but_not_the_curve() {
    let mut app = plain();
    let mean = |app: &App| app.derived().patches.as_ref().expect("a light").mean;
    let (exact, curve) = (mean(&app), app.derived().curve.clone());
    let mut by = |sampling| {
        edit(&mut app, |s| s.sampling = sampling);
        assert_eq!(app.derived().curve, curve, "the curve is of 1 nm products");
        mean(&app)
    };
    let [paper, three, four, double, convolution] = [
        Sampling::Paper,
        Sampling::ThreeN,
        Sampling::FourN,
        Sampling::Double,
        Sampling::Convolution,
    ]
    .map(&mut by);
    // 4N + 1 points and the 4N + 2 of twice the numbers both hold every order of a product; only
    // rounding is between them, many times under the least difference of the others.
    assert_abs_diff_eq!(four, double, epsilon = 1e-9);
    let mut apart = [exact, paper, three, four, convolution];
    apart.sort_by(f64::total_cmp);
    assert!(apart.windows(2).all(|w| w[1] - w[0] > 1e-6), "{apart:?}");
    assert_eq!(by(Sampling::Exact), exact);
}

// --------------------------------------------------------------------------------------- scale

#[test]
fn the_scale_switch_does_what_its_words_say() {
    let mut app = plain();
    let samples = &shipped(FL11).samples;
    let v = Observer::CIE_1931.table();
    let luminance: f64 = (360..=830)
        .map(f64::from)
        .map(|nm| samples.at(nm, Kind::Light.outside()) * v.at(nm)[1])
        .sum();
    let power: f64 = samples
        .nm()
        .windows(2)
        .zip(samples.values().windows(2))
        .map(|(nm, s)| (nm[1] - nm[0]) * (s[0] + s[1]) / 2.0)
        .sum();
    let top = samples.values().iter().copied().fold(0.0, f64::max);
    let derived = app.derived().clone();
    for (scale, quantity, wanted) in [
        (Scale::AsMeasured, 1.0, 1.0),
        (Scale::PeakOne, top, 1.0),
        (Scale::LuminanceHundred, luminance, 100.0),
        (Scale::HundredLux, 683.002 * luminance, 100.0),
        (Scale::OneWatt, power, 1.0),
    ] {
        app.apply(Command::Scale(scale));
        // One division and one multiplication of doubles.
        assert_relative_eq!(app.scale_factor() * quantity, wanted, max_relative = 1e-12);
        assert_eq!(app.derived(), &derived, "a scale is only for looking");
    }
}

#[test]
fn a_reflectance_and_a_dark_light_have_no_scale() {
    let mut app = plain();
    app.apply(Command::Show(preset(&app, RED)));
    let unit = app.unit().to_owned();
    for scale in Scale::ALL {
        app.apply(Command::Scale(scale));
        assert_eq!((app.scale_factor(), app.unit()), (1.0, unit.as_str()));
    }
    let mut dark = app_with(all_zero());
    for scale in Scale::ALL {
        dark.apply(Command::Scale(scale));
        assert_eq!(dark.scale_factor(), 1.0, "{scale:?}");
        assert_eq!(dark.unit(), "W m-2 nm-1");
    }
}

#[test]
fn the_papers_lamps_follow_the_factor_of_their_weights() {
    let mut app = plain();
    app.apply(Command::ToggleOverlay(preset(&app, "paper/Sodium")));
    app.apply(Command::Show(preset(&app, "paper/Mercury")));
    let mut at = |factor: f64| {
        app.apply(Command::WeightFactor(factor));
        assert_eq!(app.document().weight_factor, factor);
        let overlay = app.document().overlays[0].on_band(Band::PAPER);
        (app.derived().measured.clone(), overlay)
    };
    let [low, middle, high] = [100.0, 200.0, 300.0].map(&mut at);
    for (low, middle, high) in [(low.0, middle.0, high.0), (low.1, middle.1, high.1)] {
        assert_ne!(low, high);
        for ((l, m), h) in low.iter().zip(&middle).zip(&high) {
            // The light is the smooth part and the factor times the lines: linear but for rounding.
            assert_abs_diff_eq!(h - l, 2.0 * (m - l), epsilon = 1e-9);
        }
    }
    // A lamp that is shown later has the factor in force, silly factors are moved or ignored.
    app.apply(Command::WeightFactor(100.0));
    let low = app.derived().measured.clone();
    app.apply(Command::Show(preset(&app, FIRST_LIGHT)));
    app.apply(Command::Show(preset(&app, "paper/Mercury")));
    assert_eq!(app.derived().measured, low);
    for (asked, got) in [(1e9, 1000.0), (f64::NAN, 1000.0), (-5.0, 1.0)] {
        app.apply(Command::WeightFactor(asked));
        assert_eq!(app.document().weight_factor, got, "asked for {asked}");
    }
}

// ---------------------------------------------------------------------------------- hand spikes

#[test]
fn a_spike_that_is_set_stays_where_it_was_put() {
    let mut app = plain();
    let before = spikes(&app);
    let smooth = app.derived().parts.smooth.clone();
    let act = SpikeAct::Set {
        index: 1,
        at_nm: 470.25,
        weight: 12.5,
    };
    app.act_on_spikes(act);
    assert_eq!(spikes(&app), before);
    let set = app.derived().parts.spikes.iter().find(|s| s.hand.is_some());
    let set = set.expect("the spike is locked now");
    assert_eq!((set.spike.at_nm, set.spike.weight), (470.25, 12.5));
    // Its line stays out of the smooth part, so the error it makes is seen. The line is looked
    // for by place now, which finds the same samples: rounding only.
    for (now, then) in app.derived().parts.smooth.iter().zip(&smooth) {
        assert_abs_diff_eq!(now, then, epsilon = 1e-9);
    }
    // Moved again, it is the same spike.
    let index = app
        .derived()
        .parts
        .spikes
        .iter()
        .position(|s| s.hand.is_some());
    app.act_on_spikes(SpikeAct::Set {
        index: index.expect("still there"),
        at_nm: 600.5,
        weight: 1.0,
    });
    assert_eq!(app.document().subject_edits().hand.len(), 1);
    assert_eq!(spikes(&app), before);
}

#[test]
fn moving_a_spike_in_one_gesture_is_one_step_of_undo() {
    let mut app = plain();
    let first = app.document().clone();
    for step in 0..10 {
        let index = app
            .derived()
            .parts
            .spikes
            .iter()
            .position(|s| s.hand.is_some());
        let at_nm = 480.0 + 0.5 * f64::from(step);
        let act = SpikeAct::Set {
            index: index.unwrap_or(1),
            at_nm,
            weight: 5.0,
        };
        app.act_on_spikes(act);
    }
    app.end_gesture();
    let moved = app.document().clone();
    app.act_on_spikes(SpikeAct::Delete { index: 0 });
    app.apply(Command::Undo);
    assert_eq!(app.document(), &moved);
    app.apply(Command::Undo);
    assert_eq!(app.document(), &first);
}

#[test]
fn a_locked_spike_survives_a_threshold_that_drops_all_others() {
    let mut app = plain();
    let parts = &app.derived().parts;
    let weakest = (0..parts.spikes.len())
        .min_by(|a, b| {
            let weight = |i: usize| parts.spikes[i].spike.weight;
            weight(*a).total_cmp(&weight(*b))
        })
        .expect("FL11 has spikes");
    let spike = parts.spikes[weakest].spike;
    app.act_on_spikes(SpikeAct::Lock { index: weakest });
    edit(&mut app, |s| s.threshold_percent = 50.0);
    let left: Vec<_> = app.derived().model.lines().to_vec();
    assert_eq!(left, [spike], "the lock keeps place and weight");
    app.act_on_spikes(SpikeAct::Unlock { index: 0 });
    assert_eq!(spikes(&app), 0);
    assert!(app.document().edits.is_empty(), "nothing is left behind");
}

#[test]
fn a_locked_line_is_never_counted_twice_whatever_the_threshold() {
    let mut wrong = Vec::new();
    for index in 0..spikes(&plain()) {
        let mut app = plain();
        let whole = app.derived().band.integral(&app.derived().measured);
        let spike = app.derived().parts.spikes[index].spike;
        app.act_on_spikes(SpikeAct::Lock { index });
        for threshold in [0.01, 0.5, 3.0, 50.0] {
            edit(&mut app, |s| s.threshold_percent = threshold);
            let locked = app.derived().parts.spikes.iter().find(|s| s.hand.is_some());
            let locked = locked.expect("a locked spike stays");
            assert_eq!(locked.spike, spike, "as it was locked");
            // The line found again may weigh a little more or less, because its foot depends on
            // which neighbours are lines too: 0.7 % of the light at most here. A line that is
            // in two spikes, or in a spike and in the smooth part, has no width and adds up.
            let off = energy(&app) / whole - 1.0;
            if locked.width_nm.is_none() || off.abs() > 0.01 {
                let at_nm = spike.at_nm;
                wrong.push(format!("{at_nm:.1} nm at {threshold} %: energy {off:+.4}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("; "));
}

#[test]
fn a_deleted_spike_gives_its_energy_back_and_reset_brings_it_back() {
    let mut app = plain();
    let (whole, before) = (energy(&app), app.derived().clone());
    let deleted = before.parts.spikes[2].spike;
    app.act_on_spikes(SpikeAct::Delete { index: 2 });
    assert_eq!(spikes(&app), before.model.lines().len() - 1);
    // What a spike takes from the grid is its weight: the sum changes by rounding only.
    assert_relative_eq!(energy(&app), whole, max_relative = 1e-12);
    let smooth = |app: &App| app.derived().band.integral(&app.derived().parts.smooth);
    let gained = smooth(&app) - before.band.integral(&before.parts.smooth);
    // The neighbours share a baseline with it and may move a little.
    assert_relative_eq!(gained, deleted.weight, max_relative = 0.2);
    app.act_on_spikes(SpikeAct::Reset);
    assert!(app.document().edits.is_empty());
    assert_eq!(app.derived(), &before);
    // A locked one that is deleted is gone as well, not found again.
    app.act_on_spikes(SpikeAct::Lock { index: 2 });
    app.act_on_spikes(SpikeAct::Delete { index: 2 });
    assert_eq!(spikes(&app), before.model.lines().len() - 1);
    assert_relative_eq!(energy(&app), whole, max_relative = 1e-12);
}

#[test]
fn a_spike_can_be_added_anywhere_and_brings_a_deleted_line_back() {
    let mut app = plain();
    let before = spikes(&app);
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 675.5,
        weight: 2.5,
    });
    assert_eq!(spikes(&app), before + 1);
    let added = app.derived().parts.spikes.iter().find(|s| s.hand.is_some());
    let added = added.expect("the added one");
    assert_eq!((added.spike.at_nm, added.spike.weight), (675.5, 2.5));
    app.act_on_spikes(SpikeAct::Reset);
    // Deleted and set again by hand: one spike for the line, not two.
    let line = app.derived().parts.spikes[1].spike;
    app.act_on_spikes(SpikeAct::Delete { index: 1 });
    app.act_on_spikes(SpikeAct::Add {
        at_nm: line.at_nm + 0.5,
        weight: line.weight,
    });
    assert_eq!(spikes(&app), before);
    assert!(app.document().subject_edits().deleted_nm.is_empty());
}

#[test]
fn acts_on_spikes_that_are_not_there_or_are_no_numbers_do_nothing() {
    let mut app = plain();
    let (index, weight) = (99, 1.0);
    for act in [
        SpikeAct::Set {
            index,
            at_nm: 500.0,
            weight,
        },
        SpikeAct::Lock { index },
        SpikeAct::Unlock { index },
        SpikeAct::Unlock { index: 0 },
        SpikeAct::Delete { index },
        SpikeAct::Set {
            index: 0,
            at_nm: f64::NAN,
            weight,
        },
        SpikeAct::Set {
            index: 0,
            at_nm: 500.0,
            weight: f64::INFINITY,
        },
        SpikeAct::Add {
            at_nm: 500.0,
            weight: f64::NAN,
        },
        SpikeAct::Reset,
    ] {
        app.act_on_spikes(act);
        assert!(app.undo_words().is_none(), "{act:?} did something");
    }
}

#[test]
fn hand_edits_belong_to_the_spectrum_they_were_made_on() {
    let mut app = plain();
    app.act_on_spikes(SpikeAct::Delete { index: 0 });
    let fewer = spikes(&app);
    app.apply(Command::Show(preset(&app, "cie_fluorescent_1nm/FL2")));
    assert!(app.document().subject_edits().is_empty());
    app.apply(Command::Show(preset(&app, FL11)));
    assert_eq!(spikes(&app), fewer);
}

// ---------------------------------------------------------------------------------- own entries

fn own_keys(app: &App) -> Vec<&str> {
    app.document().own.iter().map(|e| e.key.as_str()).collect()
}

#[test]
fn a_renamed_spectrum_is_renamed_wherever_it_stands() {
    let mut app = app_with(slope("first name"));
    let key = app.document().light.key.clone();
    app.apply(Command::ToggleOverlay(app.document().light.clone()));
    for name in ["n", "ne", "new"] {
        app.apply(Command::Rename {
            key: key.clone(),
            name: name.to_owned(),
        });
    }
    let document = app.document();
    assert_eq!(document.light.name(), "new");
    assert_eq!(document.own[0].name(), "new");
    assert_eq!(document.overlays[0].name(), "new");
    app.apply(Command::Undo);
    assert_eq!(
        app.document().light.name(),
        "first name",
        "typing is one step"
    );
}

#[test]
fn a_shown_light_that_turns_into_a_reflectance_changes_its_place() {
    let mut app = app_with(slope("mine"));
    let key = app.document().light.key.clone();
    let set = |app: &mut App, kind| {
        app.apply(Command::SetKind {
            key: key.clone(),
            kind,
        })
    };
    set(&mut app, Kind::Reflectance);
    let document = app.document();
    assert_eq!(document.light.key, FIRST_LIGHT, "something must shine");
    assert_eq!(
        document.factor.as_ref().map(|f| f.key.as_str()),
        Some(key.as_str())
    );
    assert_eq!(document.subject, Subject::Factor);
    assert_eq!(document.own[0].kind(), Kind::Reflectance);
    set(&mut app, Kind::Light);
    let document = app.document();
    assert_eq!(
        (document.light.key.as_str(), document.factor.is_none()),
        (key.as_str(), true)
    );
    assert!(document.is_about_light());
    set(&mut app, Kind::Other);
    assert_eq!(app.document().light.key, FIRST_LIGHT);
    assert_eq!(
        app.document().overlays.len(),
        1,
        "it is drawn as an overlay"
    );
}

#[test]
fn what_is_removed_leaves_nothing_behind_and_undo_brings_it_back() {
    let mut app = plain();
    let reflectance = NamedSpectrum {
        kind: Kind::Reflectance,
        ..slope("paint")
    };
    app.apply(Command::Adopt(vec![slope("lamp")]));
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 500.0,
        weight: 1.0,
    });
    app.apply(Command::Adopt(vec![reflectance]));
    app.apply(Command::ToggleOverlay(app.document().light.clone()));
    let full = app.document().clone();
    assert_eq!(own_keys(&app), ["own/1", "own/2"]);
    app.apply(Command::Remove {
        key: "own/2".to_owned(),
    });
    assert!(app.document().factor.is_none() && app.document().is_about_light());
    app.apply(Command::Remove {
        key: "own/1".to_owned(),
    });
    let document = app.document();
    assert_eq!(document.light.key, FIRST_LIGHT);
    assert!(document.own.is_empty() && document.overlays.is_empty());
    assert!(document.edits.is_empty());
    app.apply(Command::Undo);
    app.apply(Command::Undo);
    assert_eq!(app.document(), &full);
    // A number is not given twice, so an old project's edits never meet a new spectrum.
    app.apply(Command::Remove {
        key: "own/2".to_owned(),
    });
    app.apply(Command::Adopt(vec![slope("later")]));
    assert_eq!(own_keys(&app), ["own/1", "own/3"]);
}

#[test]
fn a_shipped_spectrum_cannot_be_renamed_or_turned_into_something_else() {
    let key = || FIRST_LIGHT.to_owned();
    for command in [
        Command::Rename {
            key: key(),
            name: "mine".to_owned(),
        },
        Command::SetKind {
            key: key(),
            kind: Kind::Reflectance,
        },
    ] {
        let mut app = plain();
        app.apply(command);
        assert!(
            app.undo_words().is_none(),
            "{:?}",
            app.document().light.name()
        );
    }
}

// --------------------------------------------------------------------- composites as they are

/// Places of the model's lines.
fn lines_nm(app: &App) -> Vec<f64> {
    let spikes = app.derived().model.lines();
    spikes.iter().map(|spike| spike.at_nm).collect()
}

const MERCURY_NM: [f64; 6] = [404.7, 435.8, 491.6, 546.1, 577.8, 693.8];

#[test]
fn the_papers_mercury_is_shown_as_the_composite_that_it_is() {
    let mut app = plain();
    let before = app.document().settings;
    app.apply(Command::Show(preset(&app, "paper/Mercury")));
    assert_eq!(lines_nm(&app), MERCURY_NM);
    let entry = preset(&app, "paper/Mercury");
    let given = entry.composite.as_deref().expect("a composite");
    let model = &app.derived().model;
    assert_eq!(model.smooth().band, given.smooth().band);
    for (found, told) in model
        .smooth()
        .coefficients
        .iter()
        .zip(&given.smooth().coefficients)
    {
        assert_relative_eq!(
            found,
            told,
            epsilon = 1e-9 * given.smooth().coefficients[0].abs()
        );
    }
    let off = app.derived().figures[Measure::Own].expect("a colour");
    assert!(off < 1e-6, "it is off from itself by {off}");
    assert!(app.derived().warnings[0].contains("Shown as the composite that it is"));
    // A shorter series is cut from the same one, and the lines stay.
    let shorter = Settings {
        order: 2,
        ..app.document().settings
    };
    app.apply(Command::Edit(shorter));
    assert_eq!(lines_nm(&app), MERCURY_NM);
    let cut = app.derived().model.smooth().coefficients.iter();
    for (found, told) in cut.zip(&given.smooth().coefficients[..5]) {
        assert_relative_eq!(found, told, max_relative = 1e-12);
    }
    // Another light has the knobs of before.
    app.apply(Command::Show(preset(&app, D65)));
    assert_eq!(app.document().settings, before);
    app.apply(Command::Undo);
    assert_eq!(lines_nm(&app), MERCURY_NM);
}

#[test]
fn a_composite_is_analysed_on_request_and_its_tables_end_is_no_line() {
    let mut app = plain();
    let before = app.document().settings;
    app.apply(Command::Show(preset(&app, "paper/Mercury")));
    app.apply(Command::Analyse);
    assert_eq!(app.document().settings, before);
    let found = lines_nm(&app);
    assert!(found.iter().any(|nm| (nm - 546.1).abs() < 0.1), "{found:?}");
    let is_end = |nm: &f64| (694.5..=700.5).contains(nm);
    assert!(
        !found.iter().any(is_end),
        "the table ends at 700: {found:?}"
    );
    assert_eq!(
        app.undo_words()
            .as_deref()
            .map(|w| w.contains("analysed anew")),
        Some(true)
    );
    app.apply(Command::Reset);
    assert_eq!(lines_nm(&app), MERCURY_NM);
    let other = Settings {
        threshold_percent: 2.0,
        ..app.document().settings
    };
    app.apply(Command::Edit(other));
    assert!(
        app.document().as_given().is_none(),
        "another threshold asks for an analysis"
    );
    // Only what was moved is as it was moved; the next light has the knobs of before.
    let moved = app.document().settings;
    assert_eq!(
        (moved.basis, moved.band),
        (Settings::default().basis, Settings::default().band)
    );
    assert_eq!(moved.threshold_percent, 2.0);
    app.apply(Command::Show(preset(&app, "cie_illuminants/CIE D65")));
    assert_eq!(app.document().settings, moved);
}

#[test]
fn a_problem_is_seen_for_three_steps_and_stays_among_what_was_said() {
    let mut app = plain();
    app.say(Tone::Problem, "There is no such file.");
    let order = |app: &App, order: usize| {
        Command::Edit(Settings {
            order,
            ..app.document().settings
        })
    };
    for n in [3, 4] {
        app.end_gesture();
        app.apply(order(&app, n));
        assert!(app.current_message().is_some(), "after order {n}");
    }
    app.end_gesture();
    app.apply(order(&app, 5));
    assert_eq!(app.current_message(), None);
    assert_eq!(app.message().map(|m| m.tone), Some(Tone::Problem));
}

#[test]
fn a_surface_under_a_composite_has_the_knobs_of_before_it() {
    let mut app = plain();
    let usual = app.document().settings;
    app.apply(Command::Show(preset(&app, "colorchecker_ohta/red")));
    app.apply(Command::Show(preset(&app, "paper/Mercury")));
    assert!(app.document().as_given().is_some());
    app.apply(Command::About(Subject::Factor));
    assert_eq!(app.document().settings, usual);
    app.apply(Command::About(Subject::Light));
    assert!(app.document().as_given().is_some());
}

#[test]
fn a_composite_from_a_file_is_shown_as_it_is_and_comes_back_so() {
    let mut app = plain();
    app.apply(Command::Show(preset(&app, "paper/Sodium")));
    let text = composite_json(&composite_file(&app)).expect("a composite");
    let shown = app.derived().model.clone();
    let mut again = plain();
    again.apply(Command::Open(vec![opened("lamp.json", text.as_bytes())]));
    assert_eq!(again.derived().model.lines(), shown.lines());
    assert!(again.document().as_given().is_some());
    let stored = workspace::to_json(again.document(), None).expect("a workspace");
    let back = workspace::from_json(&stored).expect("read again");
    assert_eq!(back.document, *again.document());
}

// ------------------------------------------------------------------------------------ workspace

#[test]
fn a_workspace_comes_back_to_the_bit() {
    let (document, preferences) = (full_document(), full_preferences());
    let text = workspace::to_json(&document, Some(&preferences)).unwrap();
    let restored = workspace::from_json(&text).expect("its own text");
    assert_eq!(restored.document, document);
    assert_eq!(restored.preferences, Some(preferences));
    assert!(restored.losses.is_empty(), "{:?}", restored.losses);
    // `==` takes -0 for 0: the bits as well.
    let bits = |document: &Document| -> Vec<u64> {
        let samples = &document.own[0].spectrum.samples;
        let numbers = samples.nm().iter().chain(samples.values());
        numbers.map(|v| v.to_bits()).collect()
    };
    assert_eq!(bits(&restored.document), bits(&document));
    assert_eq!(
        workspace::to_json(&restored.document, restored.preferences.as_ref()).unwrap(),
        text
    );
    // And the program over it shows the same.
    let (before, after) = (
        App::with_document(document),
        App::with_document(restored.document),
    );
    assert_eq!(before.derived(), after.derived());
}

#[cfg(unix)]
#[test]
fn names_of_files_that_are_no_text_are_kept_to_the_byte() {
    use std::os::unix::ffi::OsStrExt;
    let odd = PathBuf::from(std::ffi::OsStr::from_bytes(b"/lamps/l\xe9ger.csv"));
    let preferences = Preferences {
        recent: vec![odd.clone(), PathBuf::from("/lamps/été.csv")],
        ..Preferences::default()
    };
    let image = StoredImage {
        choices: spectral_explorer::io::Choices::default(),
        key: "image/1".to_owned(),
        path: odd,
        index: 0,
    };
    let document = full_document();
    let images = std::slice::from_ref(&image);
    let text = workspace::to_json_with(&document, Some(&preferences), images).unwrap();
    let restored = workspace::from_json(&text).expect("its own text");
    assert!(restored.images.contains(&image));
    assert_eq!(restored.preferences, Some(preferences));
}

#[test]
fn a_project_is_a_workspace_without_the_windows_looks() {
    let document = full_document();
    let restored = workspace::from_json(&workspace::to_json(&document, None).unwrap());
    let restored = restored.expect("its own text");
    assert_eq!((restored.document, restored.preferences), (document, None));
}

/// A workspace as JSON to damage.
fn stored() -> Value {
    let text = workspace::to_json(&full_document(), Some(&full_preferences())).unwrap();
    serde_json::from_str(&text).expect("our own JSON")
}

#[test]
fn what_a_version_does_not_know_any_more_is_left_out_and_said() {
    let mut value = stored();
    value["light"] = "a_group_of_old/Lamp".into();
    value["factor"] = "a_group_of_old/Paint".into();
    value["overlays"] = serde_json::json!(["a_group_of_old/Other", D65]);
    value["own"][1]["nm"] = serde_json::json!([400.0, 400.0]);
    let Restored {
        document, losses, ..
    } = workspace::from_json(&value.to_string()).expect("the rest is sound");
    assert_eq!(document.light.key, FIRST_LIGHT);
    assert!(document.factor.is_none() && document.is_about_light());
    assert_eq!(document.overlays.len(), 1);
    assert_eq!(document.own.len(), 1);
    assert_eq!(losses.len(), 5, "{losses:?}");
    for word in ["Lamp", "Paint", "Other", "second", "own/2"] {
        let told = losses
            .iter()
            .filter(|l| l.contains(word) && is_one_line(l))
            .count();
        assert_eq!(told, 1, "{word} in {losses:?}");
    }
    assert_all_finite(&App::with_document(document));
}

#[test]
fn what_is_no_workspace_is_refused_in_one_line() {
    let mut other = stored();
    other["format"] = "composite-spectrum".into();
    let mut newer = stored();
    newer["version"] = 2.into();
    for (text, word) in [
        (String::new(), "expected"),
        ("{}".to_owned(), "expected"),
        ("[1, 2".to_owned(), "expected"),
        ("\u{feff}not json\nat all".to_owned(), "expected"),
        (other.to_string(), "composite-spectrum"),
        (newer.to_string(), "newer"),
        ("[".repeat(100_000), "expected"),
    ] {
        let why = workspace::from_json(&text).expect_err("no workspace");
        assert!(is_one_line(&why) && why.contains(word), "{why}");
        assert!(why.len() < 400, "{} letters", why.len());
    }
    // Cut off anywhere it is refused, never taken for a whole one. Every 97th place will do.
    let text = workspace::to_json(&full_document(), None).unwrap();
    let places = (0..text.len() - 1)
        .step_by(97)
        .filter(|i| text.is_char_boundary(*i));
    for place in places {
        let why = workspace::from_json(&text[..place]).expect_err("half a workspace");
        assert!(is_one_line(&why), "{why}");
    }
}

#[test]
fn silly_numbers_in_a_workspace_are_moved_to_sensible_ones() {
    let mut value = stored();
    value["settings"]["order"] = 1_000_000.into();
    value["settings"]["threshold_percent"] = (-3.0).into();
    value["patch"] = 4_000_000.into();
    value["preferences"]["zoom"] = 99.0.into();
    let restored = workspace::from_json(&value.to_string()).expect("sound but silly");
    assert_eq!(restored.preferences.map(|p| p.zoom), Some(2.5));
    let mut app = App::with_document(restored.document);
    assert_eq!(app.document().settings.order, 100);
    assert_eq!(app.document().settings.threshold_percent, 0.01);
    app.apply(Command::About(Subject::Light));
    assert_eq!(app.document().patch, None);
    assert_all_finite(&app);
}

#[test]
fn a_workspace_that_counted_to_the_end_still_takes_files() {
    let mut value = stored();
    value["next_own"] = u64::MAX.into();
    let restored = workspace::from_json(&value.to_string()).expect("sound but silly");
    let mut app = App::with_document(restored.document);
    let before = app.document().own.len();
    app.apply(Command::Adopt(vec![slope("one more"), slope("and one")]));
    let keys: BTreeSet<&str> = own_keys(&app).into_iter().collect();
    assert_eq!(
        keys.len(),
        before + 2,
        "every spectrum has a key of its own"
    );
}

#[test]
fn a_saved_workspace_is_loaded_as_it_was_and_a_first_start_finds_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("new folder").join("workspace.json");
    assert_eq!(workspace::load(&path), Ok(None));
    let (document, preferences) = (full_document(), full_preferences());
    let text = workspace::to_json(&document, Some(&preferences)).unwrap();
    workspace::save(&path, &text).expect("saved, folder and all");
    let restored = workspace::load(&path).expect("readable").expect("there");
    assert_eq!(restored.document, document);
    assert_eq!(restored.preferences, Some(preferences));
    let beside: Vec<_> = fs::read_dir(path.parent().expect("a folder"))
        .expect("listed")
        .collect();
    assert_eq!(beside.len(), 1, "nothing is left beside it");
}

#[test]
fn a_damaged_workspace_is_set_aside_and_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let whole = workspace::to_json(&full_document(), None).unwrap();
    let damaged: [&[u8]; 3] = [&whole.as_bytes()[..whole.len() / 2], b"", b"{\xff\xfe}"];
    let mut kept = BTreeSet::new();
    for bytes in damaged {
        fs::write(&path, bytes).expect("written");
        let why = workspace::load(&path).expect_err("damaged");
        assert!(is_one_line(&why), "{why}");
        assert!(!path.exists(), "the way is free for a new one");
        let now: BTreeSet<PathBuf> = fs::read_dir(folder.path())
            .expect("listed")
            .map(|e| e.expect("listed").path())
            .collect();
        let new: Vec<&PathBuf> = now.difference(&kept).collect();
        assert_eq!(new.len(), 1, "each is kept under a name of its own");
        assert_eq!(fs::read(new[0]).expect("kept"), bytes);
        let name = new[0].file_name().expect("a name").to_string_lossy();
        assert!(why.contains(&*name), "{why}");
        assert!(why.contains(&folder.path().display().to_string()), "{why}");
        assert!(!why.contains("EOF") && !why.contains("at line"), "{why}");
        kept = now;
    }
}

#[test]
fn whoever_looks_while_a_workspace_is_saved_sees_a_whole_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let small =
        workspace::to_json(&Document::about(plain().document().light.clone()), None).unwrap();
    let large = workspace::to_json(&full_document(), Some(&full_preferences())).unwrap();
    assert!(large.len() > small.len());
    workspace::save(&path, &small).expect("saved");
    let done = AtomicBool::new(false);
    let seen = std::thread::scope(|scope| {
        scope.spawn(|| {
            for round in 0..60 {
                let text = if round % 2 == 0 { &large } else { &small };
                workspace::save(&path, text).expect("saved");
            }
            done.store(true, Ordering::SeqCst);
        });
        let mut seen = 0;
        loop {
            let last = done.load(Ordering::SeqCst);
            let text = fs::read_to_string(&path).expect("there is always a file");
            assert!(
                text == small || text == large,
                "half a file: {} bytes",
                text.len()
            );
            workspace::from_json(&text).expect("a whole workspace");
            seen += 1;
            if last {
                break seen;
            }
        }
    });
    assert!(seen > 0);
    assert_eq!(fs::read_dir(folder.path()).expect("listed").count(), 1);
}

#[test]
fn preferences_are_moved_into_what_a_window_can_be() {
    for (asked, got) in [
        (f32::NAN, 1.0),
        (f32::INFINITY, 1.0),
        (0.1, 0.8),
        (99.0, 2.5),
        (1.5, 1.5),
    ] {
        let preferences = Preferences {
            zoom: asked,
            ..Preferences::default()
        };
        assert_eq!(preferences.clamped().zoom, got, "asked for {asked}");
    }
    for size in [[f32::NAN, 800.0], [1280.0, 3.0], [1e9, 800.0]] {
        let preferences = Preferences {
            window: Some(size),
            ..Preferences::default()
        };
        assert_eq!(preferences.clamped().window, None, "{size:?}");
    }
    let mut preferences = Preferences::default();
    for number in 0..30 {
        preferences.remember_file(Path::new(&format!("{number}.csv")));
    }
    preferences.remember_file(Path::new("25.csv"));
    let recent = &preferences.recent;
    assert_eq!(recent.len(), 12);
    assert_eq!(
        recent[..2],
        [PathBuf::from("25.csv"), PathBuf::from("29.csv")]
    );
    assert_eq!(recent.iter().filter(|p| p.ends_with("25.csv")).count(), 1);
}

// -------------------------------------------------------------------------------------- exports

fn text_of(export: Export, app: &App) -> String {
    let text = export.text(app, Theme::Light);
    text.unwrap_or_else(|why| panic!("{export:?}: {why}"))
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// A table's head and rows, comments left out; quoted cells may hold commas.
fn table(text: &str) -> Vec<Vec<String>> {
    text.lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| {
            let (mut cells, mut quoted) = (vec![String::new()], false);
            for letter in line.chars() {
                match letter {
                    '"' => quoted = !quoted,
                    ',' if !quoted => cells.push(String::new()),
                    _ => cells.last_mut().expect("never empty").push(letter),
                }
            }
            assert!(!quoted, "an open quotation: {line}");
            cells
        })
        .collect()
}

/// The numbers of a table's column; an empty cell is none.
fn column(rows: &[Vec<String>], title: &str) -> Vec<Option<f64>> {
    let index = rows[0].iter().position(|t| t == title);
    let index = index.unwrap_or_else(|| panic!("{title} in {:?}", rows[0]));
    let cells = rows[1..].iter().map(|row| &row[index]);
    cells
        .map(|cell| {
            let number = cell.parse::<f64>();
            (!cell.is_empty()).then(|| number.unwrap_or_else(|e| panic!("{cell:?}: {e}")))
        })
        .collect()
}

#[test]
fn every_export_says_its_scale_its_source_and_its_program() {
    let mut app = plain();
    for scale in Scale::ALL {
        app.apply(Command::Scale(scale));
        for export in Export::ALL {
            let text = text_of(export, &app);
            assert!(!text.trim().is_empty(), "{export:?}");
            assert_eq!(no_numbers(&text), [""; 0], "{export:?}");
            // The composite is in the file's own unit whatever the switch says, and a project
            // keeps the switch itself.
            let (is_model, is_project) = (
                matches!(export, Export::CompositeJson | Export::CompositeLine),
                export == Export::Project,
            );
            if is_project {
                assert_eq!(
                    workspace::from_json(&text).expect("a project").document,
                    *app.document()
                );
            } else if !is_model {
                assert!(
                    text.contains(scale.words()),
                    "{export:?} does not say {scale:?}"
                );
                assert!(text.contains("Spectral Explorer"), "{export:?}");
                let source = &app.document().light.spectrum.source;
                let start: String = source.chars().take(12).collect();
                assert!(text.contains(&start), "{export:?} does not say {start}");
            }
        }
    }
}

#[test]
fn every_export_gets_a_name_that_any_disk_takes() {
    let mut app = app_with(awkward());
    let mut names = BTreeSet::new();
    for export in Export::ALL {
        let name = export.suggested_name(&app);
        assert!(
            name.chars()
                .all(|c| c.is_alphanumeric() || "-_.".contains(c)),
            "{name}"
        );
        assert!(
            name.ends_with(&format!(".{}", export.extension())),
            "{name}"
        );
        assert!(
            names.insert(name.clone()),
            "{name} would overwrite another export"
        );
    }
    let key = app.document().light.key.clone();
    app.apply(Command::Rename {
        key,
        name: "../..".to_owned(),
    });
    assert_eq!(Export::PlotSvg.suggested_name(&app), "spectrum.svg");
}

#[test]
fn an_exported_composite_is_read_back_to_the_bit() {
    let mut app = plain();
    for basis in Basis::ALL {
        edit(&mut app, |s| s.basis = basis);
        app.apply(Command::Scale(Scale::PeakOne));
        for export in [Export::CompositeJson, Export::CompositeLine] {
            let text = text_of(export, &app);
            let reading = read_bytes("x.json", text.as_bytes()).expect("our own");
            let (back, model) = (&reading.composites[0].composite, &app.derived().model);
            assert_eq!(back, model, "{export:?}");
            assert_eq!(
                bits(&back.smooth().coefficients),
                bits(&model.smooth().coefficients)
            );
            if export == Export::CompositeJson {
                assert_eq!(
                    reading.composites[0].unit,
                    app.document().light.spectrum.unit
                );
            }
        }
    }
}

#[test]
fn exported_spectra_are_read_back_with_the_scale_applied() {
    let mut app = app_with(slope("lamp"));
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 500.5,
        weight: 3.0,
    });
    app.apply(Command::Scale(Scale::HundredLux));
    let factor = app.scale_factor();
    assert!(factor != 1.0);
    let measured = &slope("").samples;
    let scaled: Vec<f64> = measured.values().iter().map(|v| v * factor).collect();
    for export in [Export::Spdx, Export::SpectrumJson] {
        let text = text_of(export, &app);
        let name = format!("x.{}", export.extension());
        let reading = read_bytes(&name, text.as_bytes()).expect("our own");
        let back = &reading.spectra[0];
        assert_eq!(bits(back.samples.nm()), bits(measured.nm()), "{export:?}");
        assert_eq!(bits(back.samples.values()), bits(&scaled), "{export:?}");
        assert_eq!(
            (back.kind, back.name.as_str()),
            (Kind::Light, "lamp"),
            "{export:?}"
        );
    }
    let derived = app.derived();
    let model: Vec<f64> = derived.model_values().iter().map(|v| v * factor).collect();
    let reading = read_bytes("x.spd", text_of(Export::Spd, &app).as_bytes()).expect("our own");
    assert_eq!(bits(reading.spectra[0].samples.values()), bits(&model));

    let text = text_of(Export::Csv, &app);
    let rows = table(&text);
    assert_eq!(rows.len(), 1 + derived.band.points());
    let at = |title: &str| -> Vec<f64> {
        column(&rows, title)
            .into_iter()
            .map(|v| v.expect("a number"))
            .collect()
    };
    assert_eq!(bits(&at("model")), bits(&model));
    for (((m, s), p), r) in at("model")
        .iter()
        .zip(at("smooth"))
        .zip(at("spikes"))
        .zip(at("residual"))
    {
        // Sums of scaled doubles of size 0.1: rounding only.
        assert_abs_diff_eq!(*m, s + p, epsilon = 1e-12);
        assert!(r.is_finite());
    }
    let reading = read_bytes("x.csv", text.as_bytes()).expect("our own");
    assert_eq!(reading.spectra.len(), 5, "every column comes back");
    assert_eq!(bits(reading.spectra[1].samples.values()), bits(&model));
}

#[test]
fn exported_tables_hold_what_the_window_shows() {
    let mut app = plain();
    app.act_on_spikes(SpikeAct::Lock { index: 0 });
    app.apply(Command::Scale(Scale::PeakOne));
    let derived = app.derived();
    for export in [Export::PatchesCsv, Export::SpikesCsv, Export::CurveCsv] {
        let rows = table(&text_of(export, &app));
        assert!(rows.iter().all(|r| r.len() == rows[0].len()), "{export:?}");
    }
    let patches = derived.patches.as_ref().expect("a light");
    let rows = table(&text_of(Export::PatchesCsv, &app));
    assert_eq!(rows.len(), 1 + 24);
    for ((row, delta), patch) in rows[1..]
        .iter()
        .zip(column(&rows, "delta_e_2000"))
        .zip(&patches.items)
    {
        assert_eq!(
            (row[0].as_str(), delta),
            (patch.name.as_str(), Some(patch.delta_e_2000))
        );
        assert!(row.iter().all(|cell| !cell.is_empty()), "{row:?}");
    }
    let rows = table(&text_of(Export::SpikesCsv, &app));
    let weights = column(&rows, "weight");
    assert_eq!(weights.len(), spikes(&app));
    for (weight, spike) in weights.iter().zip(derived.model.lines()) {
        assert_eq!(*weight, Some(spike.weight * app.scale_factor()));
    }
    assert_eq!(
        rows[1].last().map(String::as_str),
        Some("true"),
        "the locked one"
    );
    assert_eq!(rows[2].last().map(String::as_str), Some("false"));
    let rows = table(&text_of(Export::CurveCsv, &app));
    let means: Vec<_> = derived
        .curve
        .iter()
        .map(|p| p.figures[Measure::Patches])
        .collect();
    assert_eq!(column(&rows, "delta_e_patches_mean"), means);
}

#[test]
fn the_plot_is_sound_xml() {
    let mut app = app_with(awkward());
    for scale in [Scale::AsMeasured, Scale::PeakOne] {
        app.apply(Command::Scale(scale));
        for theme in [Theme::Light, Theme::Dark] {
            let svg = Export::PlotSvg.text(&app, theme).expect("a picture");
            let parsed = roxmltree::Document::parse(&svg).expect("sound XML");
            assert_eq!(parsed.root_element().tag_name().name(), "svg");
        }
    }
}

// ------------------------------------------------------------------------- dark and invisible

#[test]
fn an_all_zero_light_is_told_in_words_and_never_as_nan() {
    let mut app = app_with(all_zero());
    let derived = app.derived();
    assert!(!derived.has_errors() && derived.colour.exact.is_none() && derived.patches.is_none());
    assert!(
        derived.warnings.iter().any(|w| w.contains("zero")),
        "{:?}",
        derived.warnings
    );
    for scale in Scale::ALL {
        app.apply(Command::Scale(scale));
        for colour_exact in [false, true] {
            edit(&mut app, |s| s.colour_exact = colour_exact);
            assert_all_finite(&app);
            for export in Export::ALL {
                let text = text_of(export, &app);
                assert_eq!(no_numbers(&text), [""; 0], "{export:?} at {scale:?}");
            }
        }
    }
    assert_eq!(no_numbers(&report::text(&app)), [""; 0]);
    let json = report::json(&app);
    assert!(json["error"]["relative_rms"].is_null() && json["patches"].is_null());
    assert!(json["colour"]["exact"]["xyz"].is_null());
}

#[test]
fn values_too_small_to_compute_with_are_called_that_and_not_zero() {
    let tiny = |value: f64| {
        let values = (0..81).map(|i| value * f64::from(1 + i % 7)).collect();
        app_with(spectrum("tiny", Kind::Light, 380.0, 5.0, values))
    };
    let too_small = tiny(1e-320);
    let derived = too_small.derived();
    assert!(!derived.has_errors() && derived.colour.exact.is_none());
    let said = "The spectrum's values are too small to compute with: none reaches 1e-308.";
    assert_eq!(derived.warnings[0], said);
    let lack = tradeoff::lack(&too_small, Measure::Rms);
    assert_eq!(lack, Some(said));
    let derived = tiny(1e-307).derived().clone();
    assert!(derived.has_errors() && derived.colour.exact.is_some());
    assert_eq!(derived.warnings, [""; 0]);
}

#[test]
fn a_spike_set_by_hand_in_the_dark_has_no_share_of_nothing() {
    let mut app = app_with(all_zero());
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 500.0,
        weight: 1.0,
    });
    assert_eq!(spikes(&app), 1);
    assert_all_finite(&app);
    for export in Export::ALL {
        assert_eq!(no_numbers(&text_of(export, &app)), [""; 0], "{export:?}");
    }
    assert_eq!(
        no_numbers(&report::text(&app)),
        [""; 0],
        "{}",
        report::text(&app)
    );
}

#[test]
fn light_that_nobody_sees_has_errors_but_no_colour() {
    let mut app = app_with(infrared());
    assert!(
        app.derived()
            .warnings
            .iter()
            .any(|w| w.starts_with("Nothing was measured in 380-780 nm"))
    );
    edit(&mut app, |s| {
        s.band = Band::new(850.0, 1100.0).expect("a range")
    });
    let derived = app.derived();
    assert!(derived.has_errors());
    assert!(derived.colour.exact.is_none() && derived.patches.is_none());
    assert!(
        derived.warnings.iter().any(|w| w.contains("no colour")),
        "{:?}",
        derived.warnings
    );
    assert!(
        derived
            .curve
            .iter()
            .all(|p| p.figures[Measure::Own].is_none() && p.figures[Measure::Rms].is_some())
    );
    for observer in Observer::CIE {
        for colour_exact in [false, true] {
            edit(&mut app, |s| {
                (s.observer, s.colour_exact) = (observer, colour_exact)
            });
            assert_all_finite(&app);
        }
    }
    let json = report::json(&app);
    assert!(json["colour"]["exact"]["xyz"].is_null() && json["colour"]["delta_e_2000"].is_null());
    assert!(json["error"]["relative_rms"].is_number());
    assert_eq!(no_numbers(&report::text(&app)), [""; 0]);
    for export in Export::ALL {
        assert_eq!(no_numbers(&text_of(export, &app)), [""; 0], "{export:?}");
    }
    // A reflectance under it has no colour either.
    app.apply(Command::Show(preset(&app, RED)));
    assert!(app.derived().colour.exact.is_none());
    assert_all_finite(&app);
}

// --------------------------------------------------------------------------------------- opening

const TWO_COLUMNS: &str = "nm,Lamp A,lamp b\n400,1,2\n500,2,4\n600,3,8\n700,2,1\n";

fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    fs::write(&path, text).expect("written");
    path
}

#[test]
fn a_word_on_the_command_line_is_a_file_or_else_a_preset() {
    let folder = tempfile::tempdir().expect("a folder");
    let fl2 = resolve("FL2", None, None).expect("shipped");
    assert_eq!(
        fl2.key, "cie_fluorescent_1nm/FL2",
        "a plain name means the 1 nm table"
    );
    let coarse = resolve("cie_fluorescent_5nm/FL2", None, None).expect("shipped");
    assert!(coarse.spectrum.samples.len() < fl2.spectrum.samples.len());
    // A file of that very name comes first.
    let path = file(&folder, "FL2", TWO_COLUMNS);
    let entry = resolve(&path.display().to_string(), None, None).expect("a file");
    assert_eq!((entry.key.as_str(), entry.name()), ("own/1", "Lamp A"));
}

#[test]
fn one_of_several_spectra_in_a_file_is_picked_by_name_or_number() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "two.csv", TWO_COLUMNS).display().to_string();
    for (pick, name) in [
        (None, "Lamp A"),
        (Some("lamp b"), "lamp b"),
        (Some("LAMP B"), "lamp b"),
        (Some("2"), "lamp b"),
        (Some("1"), "Lamp A"),
    ] {
        let entry = resolve(&path, pick, None).expect("there");
        assert_eq!(entry.name(), name, "{pick:?}");
        let notes = entry.spectrum.notes.join(" ");
        assert!(notes.contains("of 2 in the file"), "{notes}");
    }
    for pick in ["0", "3", "lamp c", ""] {
        let why = resolve(&path, Some(pick), None).expect_err("not there");
        assert!(
            is_one_line(&why) && why.contains("from 1 to 2 (Lamp A, lamp b)"),
            "{why}"
        );
    }
    let why = resolve("FL2", Some("1"), None).expect_err("a preset");
    assert!(why.contains("expected a file"), "{why}");
}

#[test]
fn what_cannot_be_shown_is_refused_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let bad = file(
        &folder,
        "bad.csv",
        "nm,value\n400,1\n410,2\n420,1\n430,abc\n440,2\n450,2\n",
    );
    let missing = folder.path().join("none.csv").display().to_string();
    for (input, words) in [
        (missing.as_str(), "none.csv: found no such file"),
        ("none.csv", "found no such file"),
        ("observers/V(lambda) photopic", "say --kind"),
        ("there is no such lamp", "there is no such lamp"),
    ] {
        let why = resolve(input, None, None).expect_err("nothing to show");
        assert!(is_one_line(&why) && why.contains(words), "{input}: {why}");
    }
    let bad = bad.display().to_string();
    let why = resolve(&bad, None, None).expect_err("a bad cell");
    assert!(
        why.starts_with(&format!("{bad}, line 5: found")) && is_one_line(&why),
        "{why}"
    );
    let seen = resolve("observers/V(lambda) photopic", None, Some(Kind::Light));
    assert_eq!(seen.expect("a light if we say so").kind(), Kind::Light);
    let lines = Library::bundled()
        .presets()
        .find(|p| p.line_list().is_some());
    let id = lines.expect("a list of lines").id();
    let why = resolve(&id, None, None).expect_err("no spectrum");
    assert!(
        is_one_line(&why) && why.contains("list of spectral lines"),
        "{why}"
    );
}

#[test]
fn a_project_is_told_from_a_spectrum_by_its_content() {
    let folder = tempfile::tempdir().expect("a folder");
    let document = full_document();
    let text = workspace::to_json(&document, None).unwrap();
    // Whatever it is called.
    let path = file(&folder, "project.csv", &text);
    for loaded in [load_path(&path), load_bytes("project.csv", text.as_bytes())] {
        match loaded {
            Loaded::Project { restored, .. } => assert_eq!(restored.document, document),
            other => panic!("{other:?}"),
        }
    }
    match load_bytes("cut.json", &text.as_bytes()[..text.len() / 2]) {
        Loaded::Refused(why) => {
            assert!(why.starts_with("cut.json: ") && is_one_line(&why), "{why}")
        }
        other => panic!("{other:?}"),
    }
    let entry = resolve(&path.display().to_string(), None, None).expect("its subject");
    assert_eq!(entry, **document.subject_entry());
}

#[test]
fn several_files_are_read_in_turn_and_a_bad_one_stops_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let paths = vec![
        file(&folder, "one.csv", "400 1\n500 2\n600 1\n"),
        file(&folder, "bad.bin", "\u{0}\u{1}\u{2}"),
        folder.path().join("missing.spd"),
        file(&folder, "two.csv", TWO_COLUMNS),
    ];
    let (awake, woken) = mpsc::channel();
    let mut loader = Loader::default();
    let here = std::thread::current().id();
    loader.open(
        paths.clone(),
        Arc::new(move || {
            assert_ne!(
                std::thread::current().id(),
                here,
                "read off the window's thread"
            );
            // The test may have stopped listening.
            let _ = awake.send(());
        }),
    );
    assert!(loader.is_busy());
    // Far beyond what four small files take.
    woken
        .recv_timeout(Duration::from_secs(60))
        .expect("the end of the batch");
    let finished = loader.finished().expect("all of them");
    assert!(!loader.is_busy());
    let words: Vec<String> = finished
        .files
        .into_iter()
        .map(|file| match file.came {
            Came::Loaded(Loaded::File(opened)) => {
                let Opened {
                    path, spectra, how, ..
                } = *opened;
                assert!(path.is_some() && is_one_line(&how), "{how}");
                format!(
                    "{} of {}",
                    spectra.len(),
                    how.split(':').next().unwrap_or_default()
                )
            }
            Came::Loaded(Loaded::Refused(why)) => {
                assert!(is_one_line(&why));
                format!("refused {}", why.split(':').next().unwrap_or_default())
            }
            Came::Loaded(Loaded::Project { .. }) => "a project".to_owned(),
            Came::NotRead(why) => why,
        })
        .collect();
    assert_eq!(
        words,
        [
            "1 of one.csv",
            "refused bad.bin",
            "refused missing.spd",
            "2 of two.csv"
        ]
    );
}

#[test]
fn only_so_many_messages_are_kept() {
    let mut app = plain();
    for number in 0..500 {
        app.say(Tone::Info, format!("message {number}"));
    }
    assert_eq!(app.messages().len(), 200);
    assert_eq!(app.message().map(|m| m.text.as_str()), Some("message 499"));
}

/// An own light of these values from 380 nm on, 1 nm apart.
fn own_light(values: Vec<f64>) -> App {
    let spectrum = NamedSpectrum {
        name: "odd".to_owned(),
        kind: Kind::Light,
        unit: String::new(),
        scale: 1.0,
        samples: Sampled::even(380.0, 1.0, values).expect("a table"),
        notes: Vec::new(),
        source: String::new(),
    };
    App::with_document(Document::about(Arc::new(Entry::own(1, spectrum))))
}

#[test]
fn a_negative_light_has_no_colour() {
    let app = own_light(vec![-1.0; 401]);
    let colour = &app.derived().colour;
    assert_eq!(
        (colour.exact, colour.model, colour.delta_e_2000),
        (None, None, None)
    );
}

#[test]
fn huge_and_tiny_numbers_have_the_errors_of_ordinary_ones() {
    let shape = |factor: f64| -> Vec<f64> {
        (0..401)
            .map(|i| factor * (1.0 + (f64::from(i) / 40.0).sin().abs()))
            .collect()
    };
    let ordinary = own_light(shape(1.0)).derived().figures;
    for factor in [1e-250, 1e-120, 1e160, 1e290] {
        let app = own_light(shape(factor));
        let found = app.derived().figures;
        // The same numbers in another unit: only rounding differs.
        for measure in [
            Measure::Rms,
            Measure::RmsBlurred,
            Measure::MaxAbs,
            Measure::Lowest,
        ] {
            let [a, b] = [found, ordinary].map(|f| f[measure].expect("not zero"));
            assert!((a - b).abs() < 1e-9, "{factor}: {a} {b}");
        }
        let curve = &app.derived().curve;
        assert!(
            curve
                .iter()
                .all(|p| p.figures[Measure::Rms].is_some_and(f64::is_finite))
        );
    }
}

#[test]
fn overlays_of_the_papers_lamps_have_the_factor_in_force() {
    let mut app = plain();
    app.apply(Command::WeightFactor(150.0));
    let mercury = app.entry("paper/Mercury").expect("the paper's lamp");
    app.apply(Command::ToggleOverlay(mercury.clone()));
    let top = |entry: &Entry| {
        let values = entry.spectrum.samples.values();
        values.iter().copied().fold(0.0, f64::max)
    };
    assert!(top(&app.document().overlays[0]) < 0.6 * top(&mercury));
}

#[test]
fn a_fit_is_the_model_that_the_window_shows() {
    let mut app = App::new();
    for name in ["cie_fluorescent_1nm/FL2", "cie_fluorescent_1nm/FL11"] {
        app.apply(Command::Show(app.entry(name).expect("shipped")));
        let settings = app.document().settings;
        let options = FitOptions::default()
            .on(settings.band)
            .basis(settings.basis)
            .order(settings.order)
            .lines(Some(settings.spike_settings()))
            .colour_of(settings.colour_exact.then_some(settings.observer));
        let samples = &app.document().subject_entry().spectrum.samples;
        let fit = Composite::fit(samples, &options);
        let shown = &app.derived().model;
        assert_eq!(fit.composite.lines(), shown.lines(), "{name}");
        let both = fit.composite.smooth().coefficients.iter();
        for (ours, theirs) in both.zip(&shown.smooth().coefficients) {
            // The same sums in another order.
            assert!(
                (ours - theirs).abs() < 1e-9 * theirs.abs().max(1.0),
                "{name}"
            );
        }
    }
}
