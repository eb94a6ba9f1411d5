//! Accuracy against numbers: the sweep, the auction and their promises on the shipped lamps.

use std::{collections::BTreeSet, sync::Arc};

use super::common::{on_band, values};
use super::plain::plain;
use proptest::prelude::*;
use spectral_explorer::{
    app::{
        App, Command, Entry, Library, Settings,
        derived::OF_CURVE,
        studies::{AuctionAsk, Question, SweepAsk, paper::Claims, take},
    },
    color::{Observer, patches::PatchSet},
    lamps::own_profile,
    spectrum::{Band, Basis, Kind, NamedSpectrum, SpikeSettings},
    study::{
        FitVariant, Goal, Measure, Measures, Progress, Subject, Sweep,
        auction::{Auction, Ended, Purchase, Terms, hold},
        just_noticeable,
    },
};

const BAND: Band = Band::VISIBLE;

/// The measures with the 24 patches of the ColorChecker.
fn measures(band: Band) -> Arc<Measures> {
    let group = Library::bundled()
        .group("colorchecker_ohta")
        .expect("the ColorChecker is shipped");
    let (names, reflectances): (Vec<String>, Vec<Vec<f64>>) = group
        .items
        .iter()
        .filter_map(|p| p.spectrum())
        .map(|s| (s.name.clone(), values(s, band)))
        .unzip();
    let set = PatchSet::new(&reflectances, names, band, Observer::CIE_1931);
    Arc::new(Measures::new(set))
}

fn subject(values: Vec<f64>) -> Subject {
    Subject {
        measures: measures(BAND),
        values,
        under: None,
        spikes: SpikeSettings::default(),
        profile: Some(own_profile),
    }
}

/// Every shipped table of a light.
fn lamps() -> Vec<&'static NamedSpectrum> {
    let all = Library::bundled().spectra();
    all.filter(|s| s.kind == Kind::Light).collect()
}

fn terms(way: FitVariant, goal: Goal, numbers: usize) -> Terms {
    Terms {
        basis: way.basis,
        colour_exact: way.colour_exact,
        goal,
        numbers,
    }
}

fn auction(name: &str, way: FitVariant, goal: Goal, numbers: usize) -> Auction {
    let subject = subject(on_band(name, BAND));
    hold(&subject, terms(way, goal, numbers), &Progress::default()).expect("a light that shines")
}

/// The ways that an auction can be held in: it decides on spikes itself.
fn grounds() -> impl Iterator<Item = FitVariant> {
    FitVariant::ALL.into_iter().filter(|way| way.spikes)
}

/// Everything bought, in order.
fn purchases(auction: &Auction) -> Vec<Purchase> {
    auction
        .steps
        .iter()
        .flat_map(|s| s.bought.clone())
        .collect()
}

fn lines_bought(purchases: &[Purchase]) -> Vec<f64> {
    let line = |purchase: &Purchase| match purchase {
        Purchase::Line(spike) => Some(spike.at_nm),
        Purchase::Order(_) | Purchase::Widths => None,
    };
    purchases.iter().filter_map(line).collect()
}

fn app_about(name: &str, settings: Settings) -> App {
    let mut app = plain();
    let preset = Library::bundled().find(name).expect("it is shipped");
    app.apply(Command::Show(
        Entry::of_preset(preset).expect("it is a table").into(),
    ));
    app.apply(Command::Edit(settings));
    app
}

#[test]
fn even_samples_that_do_as_well_as_twenty_numbers_are_sought_among_all_counts() {
    let claims = Claims::of(&app_about("FL2", Settings::plain()));
    let found = claims.samples.expect("FL2 shines");
    assert!(found.tried.iter().map(|t| t.samples).eq((2..=401).rev()));
    // Whole steps of a nm leave 401 alone; other even grids of less than one a nm do as well, and
    // none of 300 does.
    for measure in [Measure::Own, Measure::Rms, Measure::RmsBlurred] {
        let needed = found.needed[measure].expect("a colour and a spectrum");
        let (best, surely) = (needed.at_best.samples, needed.surely.samples);
        println!("FL2 {measure:?}: {best} at best, {surely} surely");
        assert!((300..=400).contains(&best), "{measure:?}: {best}");
        assert!(surely >= best);
    }
}

#[test]
fn every_point_of_the_sweep_is_what_the_main_page_shows_for_that_model() {
    let close = |found: Option<f64>, shown: Option<f64>| match (found, shown) {
        // The same sums in another order and at another scale; CIEDE2000 takes square roots of
        // differences near 1e-8, which is what rounding leaves of an exact colour.
        (Some(a), Some(b)) => (a - b).abs() <= 1e-6 * (1.0 + b.abs()),
        (None, None) => true,
        _ => false,
    };
    for name in ["FL11", "CIE D65", "HP1"] {
        for way in FitVariant::ALL {
            let settings = Settings {
                basis: way.basis,
                spikes: way.spikes,
                colour_exact: way.colour_exact,
                ..Settings::plain()
            };
            let app = app_about(name, settings);
            let ask = SweepAsk::of(app.document());
            let sweep = ask.answer(&Progress::default()).expect("it shines");
            let points: Vec<_> = sweep.of_way(way).collect();
            assert_eq!(points.len(), app.derived().curve.len());
            for (point, shown) in points.iter().zip(&app.derived().curve) {
                let place = format!("{name} {} N = {}", way.word(), point.order);
                assert_eq!((point.order, point.numbers), (shown.order, shown.numbers));
                for measure in OF_CURVE {
                    let (found, shown) = (point.verdict[measure], shown.figures[measure]);
                    assert!(
                        close(found, shown),
                        "{place} {measure:?} {found:?} {shown:?}"
                    );
                }
            }
            let order = app.document().settings.order;
            let lowest = app.derived().figures[Measure::Lowest];
            let found = points[order].verdict[Measure::Lowest];
            assert!(close(found, lowest), "{name}");
        }
    }
}

#[test]
fn the_threshold_map_has_the_row_of_the_threshold_in_force() {
    let subject = subject(on_band("FL11", BAND));
    let sweep = Sweep::of(&subject, 20, Basis::Cosine, true, &Progress::default());
    let sweep = sweep.expect("it shines");
    let map = &sweep.map;
    assert_eq!(map.verdicts.len(), map.thresholds_percent.len() * 21);
    // Found spikes fall with the threshold, but for one that regrouping may add.
    assert!(map.spikes.windows(2).all(|w| w[1] <= w[0] + 1));
    assert!(map.spikes[0] > map.spikes[map.spikes.len() - 1]);
    for (i, percent) in map.thresholds_percent.iter().enumerate() {
        let at = Subject {
            spikes: SpikeSettings {
                threshold: percent / 100.0,
                ..subject.spikes
            },
            ..subject.clone()
        };
        let own = Sweep::of(&at, 20, Basis::Cosine, true, &Progress::default());
        let own = own.expect("it shines");
        let way = FitVariant::new(Basis::Cosine, true, true);
        for point in own.of_way(way) {
            assert_eq!(point.verdict, *map.at(i, point.order), "{percent} %");
            assert_eq!(point.spikes, map.spikes[i]);
        }
    }
}

#[test]
fn the_front_is_what_no_cheaper_model_reaches() {
    let subject = subject(on_band("FL2", BAND));
    let sweep = Sweep::of(&subject, 30, Basis::Fourier, false, &Progress::default());
    let sweep = sweep.expect("it shines");
    for measure in Measure::COMPARED {
        let front: Vec<_> = sweep
            .front(measure, |_| true)
            .into_iter()
            .map(|index| &sweep.points[index])
            .collect();
        let error = |p: &spectral_explorer::study::SweepPoint| {
            p.verdict[measure].expect("a light has every figure")
        };
        assert!(!front.is_empty());
        for pair in front.windows(2) {
            assert!(pair[0].numbers < pair[1].numbers);
            assert!(error(pair[0]) > error(pair[1]));
        }
        for point in &sweep.points {
            let cheaper = front.iter().filter(|f| f.numbers <= point.numbers);
            let best = cheaper.map(|f| error(f)).fold(f64::INFINITY, f64::min);
            assert!(
                best <= error(point).max(just_noticeable(measure)),
                "{measure:?} {point:?}"
            );
        }
    }
}

#[test]
fn a_reflectance_is_swept_under_its_light_without_patches_and_filters() {
    let mut app = app_about("CIE D65", Settings::plain());
    let red = app.entry("cri_tcs/TCS09").expect("it is shipped");
    app.apply(Command::Show(red));
    let sweep = SweepAsk::of(app.document())
        .answer(&Progress::default())
        .expect("it reflects");
    let points: Vec<_> = sweep
        .of_way(FitVariant::new(Basis::Fourier, true, false))
        .collect();
    for (point, shown) in points.iter().zip(&app.derived().curve) {
        let (found, shown) = (point.verdict[Measure::Own], shown.figures[Measure::Own]);
        let (found, shown) = (found.expect("a colour"), shown.expect("a colour"));
        // As above: the same sums at another scale.
        assert!((found - shown).abs() < 1e-6);
        assert_eq!(point.verdict[Measure::Patches], None);
        assert_eq!(point.verdict[Measure::Filters], None);
    }
    assert!(sweep.front(Measure::Patches, |_| true).is_empty());
    for (goal, exists) in [(Goal::OWN, true), (Goal::PATCHES, false)] {
        let ask = AuctionAsk::of(app.document(), goal, 21);
        assert_eq!(ask.answer(&Progress::default()).is_some(), exists);
    }
}

#[test]
fn a_dark_spectrum_and_a_cancelled_study_have_no_answer() {
    let way = FitVariant::new(Basis::Cosine, true, true);
    let dark = subject(vec![0.0; BAND.points()]);
    let go = Progress::default();
    assert_eq!(Sweep::of(&dark, 10, Basis::Cosine, false, &go), None);
    assert_eq!(hold(&dark, terms(way, Goal::OWN, 21), &go), None);
    let bright = subject(on_band("FL2", BAND));
    let stop = Progress::default();
    stop.cancel();
    assert_eq!(Sweep::of(&bright, 10, Basis::Cosine, false, &stop), None);
    assert_eq!(hold(&bright, terms(way, Goal::OWN, 21), &stop), None);
}

#[test]
fn behind_narrow_filters_fl2_buys_mercurys_four_lines_among_its_first_nine() {
    for way in grounds() {
        // Nine purchases make 19 numbers.
        let auction = auction("FL2", way, Goal::FILTERS, 19);
        let held = &auction.last().lines;
        let lines: Vec<f64> = held.iter().map(|i| auction.lines[*i].at_nm).collect();
        for mercury_nm in [435.8, 546.1, 404.7, 578.0] {
            assert!(
                lines.iter().any(|nm| (nm - mercury_nm).abs() < 3.0),
                "{}: {mercury_nm} is not in {lines:?}",
                way.word()
            );
        }
    }
}

#[test]
fn lines_of_their_own_width_are_bought_where_the_spectrum_counts() {
    let way = FitVariant::new(Basis::Cosine, true, true);
    let wide = auction("FL11", way, Goal::SPECTRUM, 31);
    assert!(wide.last().wide, "{:?}", wide.last());
    let bought = purchases(&wide);
    assert!(bought.contains(&Purchase::Widths));
    // The same without widths for sale.
    let ideal = Subject {
        profile: None,
        ..subject(on_band("FL11", BAND))
    };
    let terms = terms(way, Goal::SPECTRUM, 31);
    let ideal = hold(&ideal, terms, &Progress::default()).expect("it shines");
    let [wide, ideal] = [wide, ideal].map(|auction| auction.last().error);
    println!("FL11, 31 numbers: blurred {wide:.4} with widths, {ideal:.4} without");
    assert!(wide < 0.8 * ideal, "{wide} {ideal}");
}

#[test]
fn daylight_is_sold_no_line() {
    for way in grounds() {
        for (_, goal) in Goal::PLAIN {
            let auction = auction("CIE D65", way, goal, 41);
            assert!(lines_bought(&purchases(&auction)).is_empty());
            let mut orders = BTreeSet::new();
            for purchase in purchases(&auction) {
                let Purchase::Order(order) = purchase else {
                    panic!("a line was sold");
                };
                assert!(orders.insert(order), "order {order} was bought twice");
            }
        }
    }
}

#[test]
fn once_the_colour_is_exact_nothing_more_is_sold() {
    let exact = FitVariant::new(Basis::Cosine, true, true);
    let auction = auction("FL2", exact, Goal::OWN, 41);
    assert_eq!(auction.ended, Ended::NothingHelps);
    // Three numbers repair three inner products.
    assert_eq!(auction.last().numbers, 3);
}

#[test]
fn a_line_that_pays_only_with_the_next_order_is_bought_all_the_same() {
    // On FL2, judged by the patches, the line at 435.8 lowers nothing alone at this price.
    let plain = FitVariant::new(Basis::Cosine, true, false);
    let auction = auction("FL2", plain, Goal::PATCHES, 21);
    let lines = lines_bought(&purchases(&auction));
    assert!(lines.iter().any(|nm| (nm - 435.8).abs() < 1.0), "{lines:?}");
    let at = |numbers: usize| {
        let mut steps = auction.steps.iter().rev();
        steps
            .find(|s| s.numbers <= numbers)
            .map(|s| s.error)
            .expect("it begins at 1")
    };
    // The plan's figures for this purchase: .48 to .11.
    println!(
        "FL2, patches: {:.2} with 9 numbers, {:.2} with 15",
        at(9),
        at(15)
    );
    assert!(at(9) > 0.4 && at(15) < 0.12);
}

/// What must hold for every auction.
fn check(auction: &Auction, terms: Terms, place: &str) {
    let first = &auction.steps[0];
    assert_eq!((first.numbers, first.order), (1, 0), "{place}");
    let mut held: (usize, BTreeSet<u64>, bool) = (0, BTreeSet::new(), false);
    for (i, step) in auction.steps.iter().enumerate() {
        assert!(step.numbers <= terms.numbers, "{place}: {step:?}");
        let label = usize::from(step.wide);
        assert_eq!(
            step.numbers,
            1 + 2 * (step.order + step.lines.len()) + label
        );
        assert!(
            !step.wide || !step.lines.is_empty(),
            "{place}: widths of no line"
        );
        if let Some(before) = i.checked_sub(1).map(|i| &auction.steps[i]) {
            assert!(
                before.numbers < step.numbers && before.error > step.error,
                "{place}"
            );
        }
        for purchase in &step.gave_back {
            match purchase {
                Purchase::Order(_) => held.0 -= 1,
                Purchase::Widths => assert!(std::mem::replace(&mut held.2, false), "{place}"),
                Purchase::Line(s) => assert!(held.1.remove(&s.at_nm.to_bits()), "{place}"),
            }
        }
        for purchase in &step.bought {
            match purchase {
                Purchase::Order(_) => held.0 += 1,
                Purchase::Widths => assert!(!std::mem::replace(&mut held.2, true), "{place}"),
                Purchase::Line(s) => assert!(held.1.insert(s.at_nm.to_bits()), "{place}"),
            }
        }
        assert_eq!(
            (held.0, held.1.len(), held.2),
            (step.order, step.lines.len(), step.wide),
            "{place}"
        );
    }
    // At every price never worse than the better of "with" and "without".
    for bid in auction.with.iter().chain(&auction.without) {
        let mut steps = auction.steps.iter().rev();
        let pick = steps
            .find(|s| s.numbers <= bid.numbers)
            .expect("it begins at 1");
        // The path leaves out what is better by rounding only.
        let rounding = 1e-9 * first.error;
        assert!(
            pick.error <= bid.error + rounding,
            "{place}: {bid:?} beats {pick:?}"
        );
    }
}

#[test]
fn on_every_lamp_the_auction_is_never_worse_than_with_or_without_spikes() {
    let shared = measures(BAND);
    let lamps = lamps();
    assert!(lamps.len() > 130);
    std::thread::scope(|scope| {
        let (first, second) = lamps.split_at(lamps.len() / 2);
        for half in [first, second] {
            let shared = &shared;
            scope.spawn(move || {
                for (i, lamp) in half.iter().enumerate() {
                    let subject = Subject {
                        measures: shared.clone(),
                        values: values(lamp, BAND),
                        under: None,
                        spikes: SpikeSettings::default(),
                        profile: Some(own_profile),
                    };
                    // One way and goal each: all sixteen take turns over the lamps.
                    let way = grounds().nth(i % 4).expect("four ways");
                    let (word, goal) = Goal::PLAIN[i / 4 % 4];
                    let terms = terms(way, goal, 31);
                    let auction = hold(&subject, terms, &Progress::default());
                    let auction = auction.expect("a lamp that shines");
                    let place = format!("{} {} {word}", lamp.name, way.word());
                    check(&auction, terms, &place);
                    let with = 1 + 2 * auction.lines.len();
                    assert_eq!(auction.with.is_empty(), with > 31, "{place}");
                }
            });
        }
    });
}

proptest! {
    // Each case is a whole auction, about 20 ms.
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_mix_of_goals_on_any_lamp_keeps_the_auctions_promises(
        lamp in 0_usize..140,
        way in 0_usize..4,
        weights in [0.0_f64..2.0, 0.0..2.0, 0.0..2.0, 0.0..2.0],
        numbers in 1_usize..34,
        threshold in 0.0002_f64..0.02,
    ) {
        let lamps = lamps();
        let lamp = lamps[lamp % lamps.len()];
        let [own, patches, spectrum, filters] = weights;
        let goal = Goal { own, patches, spectrum, filters };
        let way = grounds().nth(way).expect("four ways");
        let mut subject = subject(values(lamp, BAND));
        subject.spikes.threshold = threshold;
        let terms = terms(way, goal, numbers);
        let auction = hold(&subject, terms, &Progress::default()).expect("it shines");
        check(&auction, terms, &lamp.name);
        // A mixed goal starts at 1: every error over its own value at order 0.
        let mixed = goal.weights().iter().filter(|w| **w > 0.0).count() > 1;
        if mixed {
            // A few quotients of a number by itself, weighted.
            prop_assert!((auction.steps[0].error - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn what_is_bought_is_what_the_document_then_shows() {
    for name in ["FL2", "FL11", "CIE D65", "HP1"] {
        for colour_exact in [false, true] {
            let settings = Settings {
                basis: Basis::Cosine,
                colour_exact,
                ..Settings::plain()
            };
            let mut app = app_about(name, settings);
            let ask = AuctionAsk::of(app.document(), Goal::PATCHES, 21);
            let auction = ask.answer(&Progress::default()).expect("it shines");
            for step in &auction.steps {
                app.apply(take(settings, &ask, &auction, step));
                let derived = app.derived();
                assert_eq!(derived.numbers(), step.numbers, "{name}");
                let mean = derived.patches.as_ref().map(|p| p.mean).expect("it shines");
                // Lines left in the smooth part may move a neighbour's hull a little: the lines
                // are looked for again without them.
                assert!(
                    (mean - step.error).abs() < 0.02 * step.error.max(0.05),
                    "{name} {} numbers: {mean} {}",
                    step.numbers,
                    step.error
                );
            }
            app.apply(Command::Undo);
            let before = &auction.steps[auction.steps.len() - 2];
            assert_eq!(app.derived().numbers(), before.numbers, "one step of undo");
        }
    }
}
