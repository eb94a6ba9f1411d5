//! The place Design as a whole: files as channels and gels, faders and undo, where recovered
//! surfaces go.

use std::io::Write as _;

use spectral_explorer::{
    app::{
        App, Command, Gel, Given, MadeFor, Recipe,
        derived::PatchComparison,
        design::{
            Desk,
            colour::FromColour,
            front::on_desk,
            mix::{Mix, MixChannel},
            wish::{MixWish, Solved},
        },
        open::{Loaded, load_bytes},
        workspace,
    },
    design::{
        SampleTables,
        mixture::Source,
        recover::Method,
        solve::{Against, Care, FrontProblem, Target, front},
    },
    spectrum::Kind,
    study::Progress,
};

/// A fixture of two emitters and a filter, as GDTF has them.
const FIXTURE: &str = r#"<?xml version="1.0"?><GDTF DataVersion="1.1"><FixtureType Name="Spot">
<Emitters>
<Emitter Name="Blue"><Measurement Physical="100">
<MeasurementPoint WaveLength="430" Energy="0"/><MeasurementPoint WaveLength="450" Energy="1"/>
<MeasurementPoint WaveLength="470" Energy="0"/></Measurement></Emitter>
<Emitter Name="Lime"><Measurement Physical="100">
<MeasurementPoint WaveLength="500" Energy="0"/><MeasurementPoint WaveLength="560" Energy="1"/>
<MeasurementPoint WaveLength="640" Energy="0"/></Measurement></Emitter>
</Emitters>
<Filters><Filter Name="CTO"><Measurement Physical="1">
<MeasurementPoint WaveLength="400" Energy="0.2"/>
<MeasurementPoint WaveLength="700" Energy="0.8"/></Measurement></Filter></Filters>
</FixtureType></GDTF>"#;

fn fixture() -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    zip.start_file("description.xml", options)
        .expect("a member");
    zip.write_all(FIXTURE.as_bytes()).expect("in memory");
    zip.finish().expect("in memory").into_inner()
}

fn mix(app: &mut App, change: impl Fn(&mut Mix)) {
    app.edit_pages(|pages| change(&mut pages.mix.desk));
}

#[test]
fn emitters_of_a_gdtf_fixture_are_channels_and_its_filters_gels() {
    let mut app = App::new();
    let Loaded::File(opened) = load_bytes("spot.gdtf", &fixture()) else {
        panic!("a fixture");
    };
    app.apply(Command::Open(vec![*opened]));
    let own: Vec<(String, Kind)> = app
        .document()
        .own
        .iter()
        .map(|e| (e.key.clone(), e.kind()))
        .collect();
    let kinds: Vec<Kind> = own.iter().map(|(_, kind)| *kind).collect();
    assert_eq!(kinds, [Kind::Light, Kind::Light, Kind::Transmittance]);
    let key = |k: usize| own[k].0.clone();
    let channels = [0, 1].map(|k| MixChannel::new(Source::Named(key(k))));
    mix(&mut app, |mix| mix.channels = channels.to_vec());
    let bare = Desk::of(app.document());
    assert!(bare.strips.iter().all(|strip| strip.light.is_ok()));
    let gel = Gel {
        key: key(2),
        thickness: 1.0,
    };
    mix(&mut app, |mix| mix.gels = vec![gel.clone()]);
    let behind = Desk::of(app.document());
    for nm in [450, 560] {
        let passes = behind.values[nm - 360] / bare.values[nm - 360];
        let measured = 0.2 + 0.6 * (nm as f64 - 400.0) / 300.0;
        assert!(
            (passes - measured).abs() < 1e-9,
            "{nm}: {passes} {measured}"
        );
    }
    // It warms, as its name says.
    let kelvin = |desk: &Desk| desk.figures.as_ref().and_then(|f| f.xy).expect("a colour")[0];
    assert!(kelvin(&behind) > kelvin(&bare));
    // A fixture that is taken out of the library leaves desk and gels.
    app.apply(Command::Remove { key: key(2) });
    app.apply(Command::Remove { key: key(0) });
    let left = &app.document().pages.mix.desk;
    assert_eq!((left.channels.len(), left.gels.len()), (1, 0));
}

/// An act at the desk: what it is, what undo calls it, and the frames that it takes.
type Act = (&'static str, fn(&mut Mix, f64));

#[test]
fn whatever_is_done_at_the_desk_is_one_step_of_undo_with_words() {
    let acts: [Act; 13] = [
        ("fader of LED 455 nm to", |mix, part| {
            mix.channels[0].level = 30.0 + part
        }),
        ("a switch of LED 455 nm", |mix, _| {
            mix.channels[0].mute = true
        }),
        ("a switch of LED 455 nm", |mix, _| {
            mix.channels[0].solo = true
        }),
        ("a switch of LED 455 nm", |mix, _| {
            mix.channels[0].lock = true
        }),
        ("LED 530 nm in group 2", |mix, _| mix.channels[1].group = 2),
        ("fader of group 2", |mix, part| {
            mix.channels[1].group = 2;
            mix.channels[2].group = 2;
            *mix = mix.clone().group_dimmed(2, 30.0 + part);
        }),
        ("faders of the mixture", |mix, part| {
            *mix = mix.clone().dimmed(30.0 + part)
        }),
        ("LED 455 nm to LED", |mix, part| {
            mix.channels[0].source = Source::Gauss {
                centre_nm: 450.0 + part,
                fwhm_nm: 20.0,
            };
        }),
        ("more channels to mix", |mix, _| {
            if mix.channels.len() == 4 {
                mix.channels
                    .push(MixChannel::new(Source::Line { at_nm: 589.0 }));
            }
        }),
        ("fewer channels to mix", |mix, _| mix.channels.truncate(3)),
        ("gel Green put on", |mix, _| mix.gels = vec![gel(1.0)]),
        ("gel Green", |mix, part| mix.gels = vec![gel(1.0 + part)]),
        ("gel Green \u{d7} 1.90 taken off", |mix, _| mix.gels.clear()),
    ];
    let mut app = App::new();
    for (words, act) in acts {
        // Each from a fresh desk, but a gel that is moved or taken off is on already.
        let gels = match words.starts_with("gel") {
            true => app.document().pages.mix.desk.gels.clone(),
            false => Vec::new(),
        };
        app.edit_pages(|pages| {
            pages.mix.desk = Mix {
                gels,
                ..Mix::first()
            };
        });
        app.end_gesture();
        let before = app.document().pages.mix.desk.clone();
        for part in [0.5, 0.7, 0.9] {
            mix(&mut app, |mix| act(mix, part));
        }
        app.end_gesture();
        let after = app.document().pages.mix.desk.clone();
        assert_ne!(after, before, "{words}");
        let said = app.undo_words().expect("a step");
        assert!(said.starts_with(words), "{said}: expected {words}");
        app.apply(Command::Undo);
        assert_eq!(app.document().pages.mix.desk, before, "{words}");
        app.apply(Command::Redo);
        assert_eq!(app.document().pages.mix.desk, after, "{words}");
    }
}

fn gel(thickness: f64) -> Gel {
    Gel {
        key: "glasses/Green".to_owned(),
        thickness,
    }
}

#[test]
fn a_wish_and_a_point_of_the_front_are_one_step_each() {
    let mut app = App::new();
    let first = app.document().pages.mix.desk.clone();
    // A temperature that is dragged takes the faders along.
    for kelvin in [3000.0, 3500.0, 4000.0] {
        let wish = MixWish {
            kelvin,
            ..MixWish::default()
        };
        let desk = Desk::of(app.document());
        let found = Solved::of(&wish, &desk, app.document(), Care::Full).expect("channels");
        app.edit_pages(|pages| pages.mix.desk = found.mix);
    }
    app.end_gesture();
    let solved = app.document().pages.mix.desk.clone();
    let wish = FrontProblem {
        target: Target::of_kelvin(4000.0, 0.0).expect("a white"),
        against: Against::Ra,
        lines: 2,
        points: 2,
        floors: None,
    };
    let points = front(&wish, SampleTables::shipped(), &Progress::default());
    let points = points.expect("a front").expect("not cancelled");
    app.edit_pages(|pages| pages.mix.desk = on_desk(&points[0]));
    app.end_gesture();
    assert_eq!(app.document().pages.mix.desk.channels.len(), 2);
    for expected in [solved, first] {
        app.apply(Command::Undo);
        assert_eq!(app.document().pages.mix.desk, expected);
    }
    assert!(app.undo_words().is_none());
}

fn patches(app: &App) -> &PatchComparison {
    app.derived()
        .patches
        .as_ref()
        .expect("patches under a light")
}

#[test]
fn a_recovered_surface_goes_to_the_library_the_chain_and_the_patches_by_one_step_each() {
    let mut app = App::new();
    let recipe = || {
        FromColour {
            given: Given::Lab([60.0, 20.0, 40.0]),
            ..FromColour::default()
        }
        .recipe()
    };
    let make = |app: &mut App, place: MadeFor| {
        app.apply(Command::Make {
            recipe: recipe(),
            place,
        });
        app.end_gesture();
    };
    make(&mut app, MadeFor::Shown);
    assert_eq!(app.document().subject_entry().key, "own/1");
    app.apply(Command::Undo);
    let links = app.document().products.chain.len();
    make(&mut app, MadeFor::Chain);
    let chain = &app.document().products.chain;
    assert_eq!(
        (chain.len(), chain[links].entry.key.as_str()),
        (links + 1, "own/1")
    );
    app.apply(Command::Undo);
    assert_eq!(app.document().products.chain.len(), links);
    assert!(app.document().own.is_empty());
    make(&mut app, MadeFor::Patches);
    assert_eq!(patches(&app).items.len(), 25);
    assert!(
        patches(&app).items[24]
            .name
            .starts_with("Surface from L*a*b*")
    );
    // Its product is drawn like that of any other.
    app.apply(Command::Patch(Some(24)));
    assert_eq!(app.document().patch, Some(24));
    // A workspace keeps it.
    let text = workspace::to_json(app.document(), None).expect("a project");
    let back = workspace::from_json(&text).expect("the project");
    assert_eq!(back.losses, Vec::<String>::new());
    assert_eq!(back.document.own_patches, ["own/1"]);
    assert_eq!(back.document.patch, Some(24));
    // Taken away, and gone with its spectrum.
    let key = "own/1".to_owned();
    app.apply(Command::ToggleOwnPatch { key: key.clone() });
    assert_eq!(patches(&app).items.len(), 24);
    assert_eq!(app.document().patch, None);
    app.apply(Command::ToggleOwnPatch { key: key.clone() });
    app.apply(Command::Remove { key });
    assert_eq!(patches(&app).items.len(), 24);
    // A full chain says so and changes nothing.
    for _ in 0..40 {
        make(&mut app, MadeFor::Chain);
    }
    assert!(app.document().products.chain.len() <= 16);
    assert!(
        app.messages()
            .iter()
            .any(|m| m.text.contains("chain is full"))
    );
}

#[test]
fn a_surface_of_two_colours_follows_both_lights() {
    let mut app = App::new();
    let given = || Given::Of("colorchecker_ohta/red".to_owned());
    let blackbody = |kelvin: f64| Recipe::Mix {
        channels: vec![(Source::Blackbody { kelvin }, 1.0)],
        gels: Vec::new(),
    };
    let recipe = blackbody(3000.0);
    app.apply(Command::Make {
        recipe,
        place: MadeFor::Shown,
    });
    let from = FromColour {
        given: given(),
        method: Method::Fourier6,
        second: Some((given(), "own/1".to_owned())),
        ..FromColour::default()
    };
    app.apply(Command::Make {
        recipe: from.recipe(),
        place: MadeFor::Chain,
    });
    let values = |app: &App| {
        app.entry("own/2")
            .expect("made")
            .spectrum
            .samples
            .values()
            .to_vec()
    };
    let before = values(&app);
    let recipe = blackbody(2000.0);
    app.apply(Command::MakeOtherwise {
        key: "own/1".to_owned(),
        recipe,
    });
    assert_ne!(values(&app), before);
}
