//! Pictures in few numbers, from a look at them to their files.

use std::sync::Arc;

use super::*;
use crate::{
    app::{
        App, Command, assert_says,
        charts::relit::difference_chart,
        open::{Loaded, load_path},
        pages::{ImageMemory, RelitMemory},
        studies::Question,
    },
    color::Observer,
    pictures::{
        Between, FixedSettings, Illuminant, InMemory, LineChoice, Pixels, ReferenceKind, Scene,
        Verdict,
    },
    spectrum::{
        Cube, Kind, SpectralImage,
        cube::{Interleave, Layout, Number},
    },
    study::Progress,
};

const SIZE: [usize; 2] = [24, 16];

/// The wall as if it had been opened, under a light or as reflectances.
fn image(lit: Option<&str>) -> Subject {
    let [width, height] = SIZE;
    let nm: Vec<f64> = (0..31).map(|i| 400.0 + 10.0 * f64::from(i)).collect();
    let lights: Vec<Illuminant> = lit.and_then(Illuminant::named).into_iter().collect();
    let scene = match lit {
        Some(_) => Scene::lit(width, height, nm.clone(), &lights),
        None => Scene::reflectance(width, height, nm.clone()),
    };
    let scene = scene.expect("bands");
    let pixels = InMemory::of(&scene).expect("pixels");
    let bytes = pixels.values().iter().flat_map(|v| v.to_le_bytes());
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Bands,
        stored_bands: nm.len(),
        missing: None,
    };
    let bands: Vec<(f64, usize)> = nm.into_iter().zip(0..).collect();
    let cube = Cube::new(width, height, &bands, layout, Arc::new(bytes.collect()));
    Subject::Image(ByAddress(Arc::new(SpectralImage {
        name: "wall".to_owned(),
        kind: scene.bands().kind(),
        unit: String::new(),
        scale: 1.0,
        bandwidth_nm: None,
        cube: cube.expect("a sound cube"),
        notes: Vec::new(),
        source: "wall.img".to_owned(),
    })))
}

/// What a job answers that is not cancelled.
fn answered<Q, T>(ask: &Q) -> ByAddress<T>
where
    Q: Question<Answer = Outcome<T>>,
{
    let answer = ask.answer(&Progress::default()).expect("not cancelled");
    answer.expect("a sound picture")
}

fn fit(subject: Subject, taken_under: Option<&str>, numbers: Option<usize>) -> ByAddress<Fit> {
    fit_with(subject, taken_under, numbers, FixedSettings::default())
}

fn fit_with(
    subject: Subject,
    taken_under: Option<&str>,
    numbers: Option<usize>,
    wish: FixedSettings,
) -> ByAddress<Fit> {
    let looked = answered(&look(subject, taken_under, wish));
    answered(&FitAsk { looked, numbers })
}

fn look(subject: Subject, taken_under: Option<&str>, wish: FixedSettings) -> LookAsk {
    let entry = taken_under.map(|key| App::new().entry(key).expect("shipped"));
    LookAsk {
        subject,
        taken_under: entry.map(ByAddress),
        own: None,
        bound: 0.5,
        observer: Observer::CIE_1931,
        wish,
        weighted: true,
    }
}

fn turned(fit: &ByAddress<Fit>, key: &str, second: Option<(&str, u32)>) -> ByAddress<Turned> {
    answered(&turn(fit, key, second))
}

fn turn(fit: &ByAddress<Fit>, key: &str, second: Option<(&str, u32)>) -> TurnAsk {
    let app = App::new();
    let entry = |key: &str| ByAddress(app.entry(key).expect("shipped"));
    TurnAsk {
        fit: fit.clone(),
        light: entry(key),
        second: second.map(|(key, percent)| (entry(key), percent)),
        to_light: true,
        between: Between::Bands,
    }
}

const A: &str = "cie_illuminants/CIE A";
const D65: &str = "cie_illuminants/CIE D65";
const FL11: &str = "cie_fluorescent_1nm/FL11";

#[test]
fn without_an_image_the_page_is_about_the_wall() {
    let app = App::new();
    let memory = RelitMemory {
        taken_under: Some(FL11.to_owned()),
        ..RelitMemory::default()
    };
    let ask = LookAsk::of(&app, &memory, &ImageMemory::default());
    assert_eq!(ask.subject, Subject::Wall);
    assert!(ask.taken_under.is_some() && ask.asks_for_light());
    let of_surfaces = LookAsk {
        subject: image(None),
        ..ask
    };
    assert!(!of_surfaces.asks_for_light(), "it was divided already");
}

#[test]
fn more_numbers_are_nearer_and_own_colour_is_exact() {
    let subject = image(None);
    let off = |numbers: usize, key: &str| {
        let fit = fit(subject.clone(), None, Some(numbers));
        assert_eq!(fit.0.operator.numbers(), numbers);
        turned(&fit, key, None).0.spread
    };
    let (few, many) = (off(6, FL11), off(18, FL11));
    assert!(few.p95 > 2.0 * many.p95, "{few:?} {many:?}");
    assert!(off(6, D65).max < 0.01, "the own light");
}

#[test]
fn the_sentence_says_what_was_measured() {
    let fit = fit(image(None), None, Some(8));
    let under_a = turned(&fit, A, None);
    let words = headline(&fit.0, &under_a.0, None);
    let spread = under_a.0.spread;
    for part in [
        "Wall in 8 numbers a pixel instead of 31.".to_owned(),
        format!("ΔE₀₀ {:.2} on average", spread.mean),
        format!("{:.1} in the worst", spread.max),
    ] {
        assert_says(&words, &part);
    }
    let worst = f64::from(under_a.0.off[under_a.0.worst]);
    assert!((worst - spread.max).abs() < 1e-5);
}

#[test]
fn a_mixture_lies_between_its_lights() {
    let fit = fit(image(None), None, Some(10));
    let both = turned(&fit, A, Some((D65, 50)));
    assert_eq!(both.0.light, "CIE A and CIE D65");
    let all = turned(&fit, A, Some((D65, 0)));
    assert_eq!(
        all.0.sides[0].pixels,
        turned(&fit, A, None).0.sides[0].pixels
    );
    assert_ne!(all.0.sides[0].pixels, both.0.sides[0].pixels);
}

#[test]
fn light_of_an_unknown_lamp_is_relit_only_when_the_lamp_is_told() {
    let subject = image(Some("FL11"));
    let unknown = fit(subject.clone(), None, Some(11));
    let own = turned(&unknown, A, None);
    assert!(own.0.trust.is_none() && !own.0.refused.is_empty());
    assert!(trust_line(&own.0).contains("Choose the light"));
    let known = fit(subject, Some(FL11), Some(11));
    let relit = turned(&known, A, None);
    let trust = relit.0.trust.as_ref().expect("it can be relit");
    assert_eq!(trust.verdict, Verdict::Good);
    assert!(relit.0.refused.is_empty() && relit.0.spread.mean < 2.0);
}

#[test]
fn both_files_are_as_large_as_told_and_open_again() {
    let fit = fit(image(None), None, Some(8));
    let stored = answered(&StoreAsk(fit.clone()));
    assert_eq!(byte_rows(&fit.0, &stored.0).len(), 3);
    let folder = tempfile::tempdir().expect("a folder");
    for form in Form::ALL {
        let wish = PictureWish {
            fit: fit.clone(),
            stored: stored.clone(),
            form,
        };
        let path = folder.path().join(wish.file_name());
        let words = wish.save(&path).expect("saved");
        assert_says(&words, "8 numbers a pixel");
        let length = std::fs::metadata(&path).expect("written").len();
        let told = match form {
            Form::Full => stored.0.bytes.full,
            Form::Compact => stored.0.bytes.compact,
        };
        assert_eq!(Some(length), told);
        let Loaded::File(opened) = load_path(&path) else {
            panic!("it opens again");
        };
        let image = &opened.images[0];
        assert_eq!([image.cube.width(), image.cube.height()], SIZE);
        assert_eq!((image.kind, image.cube.nm().len()), (Kind::Reflectance, 31));
        let mut app = App::new();
        app.apply(Command::Open(vec![*opened]));
        let ask = LookAsk::of(&app, &RelitMemory::default(), &ImageMemory::default());
        assert!(matches!(ask.subject, Subject::Image(_)));
    }
}

#[test]
fn the_table_of_others_names_the_nearest_whoever_it_is() {
    let fit = fit(image(None), None, Some(6));
    let peers = answered(&PeersAsk(fit));
    let (rows, words) = peer_rows(&peers.0);
    assert_eq!(rows.len(), peers.0.len());
    let measured = peers
        .0
        .iter()
        .filter_map(|p| Some((p.name, p.lights()?.mean)));
    let nearest = measured.min_by(|a, b| a.1.total_cmp(&b.1)).expect("some");
    assert!(words.contains(nearest.0), "{words}");
}

#[test]
fn what_was_in_the_dark_is_not_shown_in_another_light() {
    let fit = fit(
        image(Some("LPS")),
        Some("lamps_nist_traditional/LPS"),
        Some(8),
    );
    let daylight = turned(&fit, D65, None);
    assert!(daylight.0.trust.is_none());
    assert!(trust_line(&daylight.0).contains("was in the dark"));
    assert!(headline(&fit.0, &daylight.0, None).contains("Its own colours"));
}

#[test]
fn reference_and_lines_by_hand_are_what_is_kept() {
    let subject = image(Some("FL11"));
    let by_hand = FixedSettings {
        reference: Some(ReferenceKind::Mean),
        lines: LineChoice::At(vec![545.0, 611.0, 900.0]),
    };
    let fit = fit_with(subject.clone(), Some(FL11), Some(9), by_hand);
    let plan = fit.0.operator.plan();
    assert_eq!(plan.reference.kind, ReferenceKind::Mean);
    let places: Vec<f64> = plan.lines.iter().map(|line| line.at_nm.round()).collect();
    assert_eq!((plan.series, places.len()), (7, 2), "{places:?}");
    let mut both = places.iter().zip([545.0, 611.0]);
    assert!(both.all(|(a, b)| (a - b).abs() < 6.0));
    let said = fit.0.looked.0.said.join(" ");
    assert!(said.contains("The line at 900 nm is left out"), "{said}");
    assert_eq!(fit.0.looked.0.numbers(), [5, 30]);
    let none = FixedSettings {
        reference: Some(ReferenceKind::One),
        lines: LineChoice::None,
    };
    let bare = fit_with(subject, Some(FL11), Some(9), none);
    let plan = bare.0.operator.plan();
    assert_eq!(
        (plan.reference.kind, plan.lines.len()),
        (ReferenceKind::One, 0)
    );
}

#[test]
fn the_light_of_another_picture_is_not_asked_for() {
    let memory = RelitMemory {
        wish: FixedSettings {
            reference: Some(ReferenceKind::Light),
            ..FixedSettings::default()
        },
        ..RelitMemory::default()
    };
    let app = App::new();
    let ask = LookAsk::of(&app, &memory, &ImageMemory::default());
    assert_eq!(ask.wish.reference, None);
    let lit = RelitMemory {
        taken_under: Some(FL11.to_owned()),
        ..memory
    };
    let ask = LookAsk::of(&app, &lit, &ImageMemory::default());
    assert_eq!(ask.wish.reference, Some(ReferenceKind::Light));
}

#[test]
fn the_histogram_counts_every_pixel_that_was_measured() {
    let fit = fit(image(None), None, Some(6));
    let under_a = turned(&fit, A, None);
    let chart = difference_chart(&under_a.0);
    let counted: f64 = chart.series[0].marks.points().iter().map(|p| p[1]).sum();
    assert_eq!(counted, (SIZE[0] * SIZE[1]) as f64);
    let named = |word: &str, value: f64| {
        let name = format!("{word} {value:.2}");
        assert!(chart.series.iter().any(|s| s.name == name), "{name}");
    };
    let spread = under_a.0.spread;
    named("mean", spread.mean);
    named("95 %", spread.p95);
    named("most", spread.max);
    // Own colour is exact: there is nothing to count.
    let own = difference_chart(&turned(&fit, D65, None).0);
    assert!(own.series.is_empty() && !own.blank.is_empty());
}

#[test]
fn own_colour_is_exact_under_the_light_that_is_chosen_for_it() {
    let entry = App::new().entry(FL11).expect("shipped");
    let ask = LookAsk {
        own: Some(ByAddress(entry)),
        bound: 2.0,
        weighted: false,
        ..look(image(None), None, FixedSettings::default())
    };
    let looked = answered(&ask);
    let words = fewer(&looked.0);
    assert_says(&words, "within 2 in 95 %");
    let numbers = None;
    let fit = answered(&FitAsk { looked, numbers });
    assert!(fit.0.operator.plan().weighting.is_none());
    assert!(turned(&fit, FL11, None).0.spread.max < 0.01);
    assert!(turned(&fit, D65, None).0.spread.max > 0.01);
}

#[test]
fn the_series_may_stand_between_bands_and_colours_move_a_little() {
    let fit = fit(image(None), None, Some(12));
    let under = |between| {
        let ask = TurnAsk {
            between,
            ..turn(&fit, FL11, None)
        };
        answered(&ask).0.spread.mean
    };
    let apart = (under(Between::Bands) - under(Between::Series)).abs();
    // Straight lines over 10 nm are off by about 0.1 themselves.
    assert!(apart > 0.0 && apart < 0.3, "{apart}");
}
