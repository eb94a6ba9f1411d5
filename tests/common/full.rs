//! A program in which everything differs from a fresh one, for the tests of what is kept of it.

use std::{path::PathBuf, sync::Arc};

use spectral_explorer::{
    app::{
        App, Command, Detector, Document, Entry, FIRST_LIGHT, Gel, Given, Height, Scale, Settings,
        SpikeAct, View,
        charts::quality::OfColours,
        combining::{KeptInstrument, Verb},
        design::{
            DeskSurfaces, Telling,
            colour::FromColour,
            mix::{Mix, MixChannel, Snapshot},
            wish::MixWish,
        },
        dispersion::{Sent, Substance},
        pages::{
            AbsorptionMemory, Beside, BouncesMemory, ChainMemory, CombineState, DiagramShows,
            FieldChoice, GemColour, GemMemory, ImageMemory, LightPart, Look, ManyMemory,
            NarrowMemory, Page, PageStates, PrismMemory, RainbowMemory, RelitMemory,
            ResamplingMemory, SameSurfaceMemory, Show, Spread, TwoLightsMemory, WaysShown,
            WordsMemory,
        },
        products::{Link, Products},
        workspace::Preferences,
    },
    color::Observer,
    design::{
        mixture::Source,
        recover::Method,
        solve::{Against, Floors, Objective},
    },
    live::Track,
    measurements::{Kernel, Normalise},
    optics::Brilliant,
    pictures::{FixedSettings, LineChoice, ReferenceKind},
    spectrum::{Band, Basis, Kind, NamedSpectrum, Rect, Sampled, Sampling},
    study::{Goal, Measure},
};

pub(crate) const D65: &str = "cie_illuminants/CIE D65";
pub(crate) const GEL: &str = "filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm";
pub(crate) const RED: &str = "colorchecker_ohta/red";

/// A shipped spectrum by `group/name`.
#[track_caller]
pub(crate) fn preset(app: &App, key: &str) -> Arc<Entry> {
    app.entry(key).unwrap_or_else(|| panic!("{key} is shipped"))
}

pub(crate) fn spectrum(
    name: &str,
    kind: Kind,
    first_nm: f64,
    step_nm: f64,
    values: Vec<f64>,
) -> NamedSpectrum {
    NamedSpectrum {
        name: name.to_owned(),
        kind,
        unit: "W m-2 nm-1".to_owned(),
        scale: 1.0,
        samples: Sampled::even(first_nm, step_nm, values).expect("finite values, rising grid"),
        notes: vec!["Made up for a test.".to_owned()],
        source: "a test".to_owned(),
    }
}

/// A light with a slope, 380-780 nm.
pub(crate) fn slope(name: &str) -> NamedSpectrum {
    let values = (0..=80).map(|i| 1.0 + 0.02 * f64::from(i)).collect();
    spectrum(name, Kind::Light, 380.0, 5.0, values)
}

/// Numbers that are hard to write: sums, denormals, thirds, extremes, a negative zero.
pub(crate) fn awkward() -> NamedSpectrum {
    let nm = vec![
        360.1,
        1e3 / 3.0 + 100.0,
        500.000_000_1,
        612.34,
        780.0,
        2500.25,
    ];
    let values = vec![0.1 + 0.2, -0.0, 5e-324, 1.0 / 3.0, 1.797e300, -1e-300];
    NamedSpectrum {
        name: "Lampe <b> & \"no. 1\", käse; µ\u{2028}".to_owned(),
        scale: 0.01,
        samples: Sampled::new(nm, values).expect("finite values, rising grid"),
        ..slope("")
    }
}

/// A document in which everything differs from a fresh one.
#[expect(
    clippy::too_many_lines,
    reason = "a table: one row a field that a document keeps"
)]
pub(crate) fn full_document() -> Document {
    let mut app = App::new();
    app.apply(Command::Adopt(vec![awkward(), slope("second")]));
    app.apply(Command::Show(preset(&app, FIRST_LIGHT)));
    app.act_on_spikes(SpikeAct::Set {
        index: 0,
        at_nm: 404.0 + 1.0 / 3.0,
        weight: 0.1 + 0.2,
    });
    app.act_on_spikes(SpikeAct::Delete { index: 3 });
    app.act_on_spikes(SpikeAct::Add {
        at_nm: 700.1,
        weight: -1e-7,
    });
    app.apply(Command::PatchSet("cri_tcs".to_owned()));
    app.apply(Command::Patch(Some(5)));
    app.apply(Command::Show(preset(&app, RED)));
    app.apply(Command::ToggleOverlay(preset(&app, D65)));
    app.apply(Command::ToggleOverlay(app.document().own[0].clone()));
    app.apply(Command::Edit(Settings {
        basis: Basis::Cosine,
        order: 13,
        spikes: false,
        wide_lines: true,
        threshold_percent: 1.0 / 3.0,
        max_width_nm: 7.7,
        dips: true,
        detector: Detector::Gradient,
        gradient_percent: 3.3,
        colour_exact: true,
        band: Band::new(400.0, 701.0).expect("a range"),
        observer: Observer::CIE[1],
        sampling: Sampling::ThreeN,
    }));
    app.apply(Command::ToggleOverlay(preset(&app, "paper/Sodium")));
    app.apply(Command::WeightFactor(123.4));
    let key = app.document().own[1].key.clone();
    app.apply(Command::ToggleOwnPatch { key });
    app.apply(Command::Scale(Scale::OneWatt));
    app.apply(Command::View(View {
        measured: false,
        model: true,
        smooth: false,
        spikes: false,
        residual: false,
        overlays: false,
        strip: false,
        height: Height::Log,
        adapt_patches: true,
    }));
    let red = preset(&app, RED);
    let own = app.document().own[1].clone();
    app.apply(Command::Compare(Some(own.clone())));
    app.apply(Command::Products(Products {
        chain: vec![
            Link {
                entry: red.clone(),
                thickness: 0.1 + 0.2,
                bounces: 3,
            },
            Link::once(red.clone()),
        ],
        surface: Some(red),
        outgoing: Some(own),
    }));
    let desk = Mix {
        gels: vec![Gel {
            key: GEL.to_owned(),
            thickness: 0.1 + 0.2,
        }],
        channels: vec![
            MixChannel {
                level: 100.0 / 3.0,
                mute: true,
                solo: true,
                lock: true,
                group: 2,
                ..MixChannel::new(Source::Line { at_nm: 546.1 })
            },
            MixChannel::new(Source::Named(RED.to_owned())),
            MixChannel::new(Source::Gauss {
                centre_nm: 450.0 + 1.0 / 3.0,
                fwhm_nm: 20.0,
            }),
            MixChannel::new(Source::Blackbody { kelvin: 2700.0 }),
            MixChannel::new(Source::Daylight { kelvin: 6500.0 }),
        ],
    };
    app.edit_pages(|pages| {
        *pages = full_pages();
        pages.mix.desk = desk;
    });
    app.document().clone()
}

pub(crate) fn full_preferences() -> Preferences {
    Preferences {
        without_cones: Some(spectral_explorer::color::MissingCones::Middle),
        dark: false,
        zoom: 1.3,
        touch: Some(true),
        present: true,
        recent: vec![PathBuf::from("a lamp.csv"), PathBuf::from("b.spdx")],
        window: Some([1280.0, 800.5]),
        curve: Measure::RmsBlurred,
        folded: vec!["LED".to_owned()],
        pinned: true,
        greeted: true,
        grown: 1.0,
        page: Page::Race,
        last_of_places: vec![Page::Rainbow, Page::Race],
        photographs_asked: Vec::new(),
        lessons_finished: vec!["prism".to_owned()],
        language: spectral_explorer::languages::Language::Spanish,
        decimal_commas: true,
        lesson_language: "de".to_owned(),
        lesson_asked: None,
        follow_asked: None,
    }
}

/// What every page keeps, each value another than at first.
#[expect(
    clippy::too_many_lines,
    reason = "a table: one row a field that a page keeps"
)]
pub(crate) fn full_pages() -> PageStates {
    let mut pages = PageStates::default();
    pages.why.partial_order = 5;
    pages.why.channel = 2;
    pages.tradeoff.measure = Measure::Filters;
    pages.tradeoff.every_way = true;
    pages.auction.goal = Goal {
        own: 0.5,
        ..Goal::FILTERS
    };
    pages.auction.numbers = 33;
    pages.look.numbers = 15;
    pages.live.average = 16;
    pages.live.as_light = true;
    pages.live.figures = vec!["duv".to_owned()];
    pages.live.track = Track::Cct;
    pages.look.goal = Some(Goal::SPECTRUM);
    pages.race.field = FieldChoice::Discharge;
    pages.race.numbers = 31;
    pages.race.measure = Measure::Rms;
    pages.race.strict = true;
    pages.known_lamps = WordsMemory {
        numbers: 11,
        portable: true,
        itself: true,
        automatic: true,
    };
    pages.tradeoff.ways = WaysShown {
        plain: false,
        ..WaysShown::default()
    };
    pages.chain = ChainMemory {
        stage: Some(1),
        light: true,
    };
    pages.narrow = NarrowMemory {
        centre_nm: 500.25,
        width_nm: 20.0,
        filter: Some(RED.to_owned()),
        luminance: true,
    };
    pages.resampling = ResamplingMemory {
        hidden: vec![Sampling::ThreeN],
    };
    pages.bounces = BouncesMemory {
        added: true,
        log: false,
    };
    pages.two_lights = TwoLightsMemory {
        patch: 3,
        pair: 2,
        makes: true,
        everywhere: false,
        room_percent: -40,
    };
    pages.same_surface = SameSurfaceMemory {
        everywhere: false,
        twice: true,
    };
    pages.combine = CombineState {
        verb: Verb::Quotient,
        slots: [Some(D65.to_owned()), Some("paper/Sodium".to_owned()), None],
        scans: vec!["own/1".to_owned()],
        others: vec!["own/2".to_owned()],
        fwhm_nm: 7.5,
        is_told: true,
        shape: Kernel::Triangle,
        keep_all: true,
        of_surface: true,
        equal: Some(Normalise::Y),
        instruments: ["Flame", "Ocean"]
            .map(|name| KeptInstrument {
                name: name.to_owned(),
                about: "by black body 2856 K".to_owned(),
                text: "{}".to_owned(),
            })
            .to_vec(),
        instrument: 1,
        is_daylight: true,
        kelvin: 6500.0,
        kelvin_doubt: 100.0,
    };
    pages.dark_lines = AbsorptionMemory { example: 1 };
    pages.chromaticity = DiagramShows {
        gamuts: true,
        near: true,
        ..DiagramShows::default()
    };
    pages.rendition.large = OfColours::Samples;
    pages.from_colour = FromColour {
        given: Given::Lab([50.5, 0.1 + 0.2, -20.0]),
        light: RED.to_owned(),
        method: Method::Lines,
        lines: vec![1e3 / 3.0 + 100.0],
        lamp: D65.to_owned(),
        second: Some((Given::Xyy([0.3, 0.1 + 0.2, 20.0]), D65.to_owned())),
        telling: Telling::Xyy,
    };
    pages.mix.kept = [
        Some(Snapshot {
            mix: Mix::first(),
            words: "A white light.".to_owned(),
        }),
        None,
        Some(Snapshot {
            mix: Mix::default(),
            words: String::new(),
        }),
    ];
    pages.solve = MixWish {
        light: None,
        xy: Some([0.1 + 0.2, 0.35]),
        kelvin: 3000.0,
        duv: 0.001,
        alike: true,
        favour: Objective::Fewest,
        floors: Floors {
            rf: Some(80.0),
            ..Floors::default()
        },
        against: Against::Ra,
        lines: 8,
    };
    pages.mix.surfaces = DeskSurfaces::Everyday;
    pages.image = ImageMemory {
        key: Some("image/3".to_owned()),
        selection: Some(Rect::pixel(2, 5)),
        show: Show::ThreeBands,
        three_nm: [700.0, 560.0, 450.0],
        one_nm: 611.0,
        stops: -1.5,
        spread: Spread::Extremes,
    };
    pages.prism = PrismMemory {
        made_of: Substance::Numbers {
            n_d: 1.6,
            v_d: 40.0,
        },
        apex_deg: 45.5,
        at_minimum: false,
        minimum_nm: 589.3,
        incidence_deg: 33.3,
        slit_mm: 1.25,
        screen_mm: 750.0,
        stops: 0.5,
        beside: Beside::Overlaid,
        sent: Sent::Model,
    };
    pages.rainbow = RainbowMemory {
        disc: false,
        impact: 0.5,
        twice: true,
        stops: -0.5,
        beside: Beside::Nothing,
        sent: Sent::Model,
    };
    pages.gem = GemMemory {
        made_of: Substance::Own {
            index: "own/1".to_owned(),
        },
        colour: GemColour::Filter,
        grey: 0.7,
        filter: "own/2".to_owned(),
        thickness: 4.0,
        cut: Brilliant {
            table: 0.61,
            ..Brilliant::default()
        },
        turn_deg: 20.0,
        height_deg: 70.0,
        size: 240,
        rays: 16,
        stops: 1.0,
        part: LightPart::Lines,
        under: None,
        sent: Sent::Model,
    };
    pages.many = ManyMemory {
        field: FieldChoice::Led,
        measure: Measure::RmsBlurred,
        limit: 2.5,
        share_percent: 80,
    };
    pages.relit = RelitMemory {
        wall: true,
        taken_under: Some(D65.to_owned()),
        own: Some("paper/Sodium".to_owned()),
        numbers: Some(11),
        bound: 1.25,
        wish: FixedSettings {
            reference: Some(ReferenceKind::Mean),
            lines: LineChoice::At(vec![435.8, 546.1]),
        },
        weighted: false,
        between_series: true,
        under: Some(D65.to_owned()),
        second: Some("paper/Sodium".to_owned()),
        second_percent: 30,
        look: Look::Difference,
        split: 0.25,
        pixel: Some([4, 7]),
    };
    pages
}
