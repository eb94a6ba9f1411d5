//! The page "Combine": one's own measurements taken together, each result with its doubt.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::{
    app::{
        FIRST_LIGHT,
        cells::Table,
        chart::Chart,
        charts::combined::{combined_chart, readings_chart},
        combining::{
            Act, Drawn, Found, KeptInstrument, Part, ScanRow, Verb, example, learnt, measurements,
            of_change, table::tables, words,
        },
        entry::Entry,
        instruments,
        memo::ByAddress,
        recipe::Recipe,
        state::App,
        studies::Question,
    },
    languages::said,
    measurements::{Kernel, Known, Normalise},
    study::Progress,
};

pub(super) const ROW: Row = row(
    Page::Combine,
    Place::Look,
    (later!("Combine"), "combine"),
    "instrument",
    later!(
        "Your own measurements with their uncertainty: means of scans, differences, quotients, \
         slits."
    ),
);

/// Keys of the light and the filter that stand beside the library's light in examples.
const EXAMPLE: [&str; 2] = [
    "cie_illuminants/CIE A",
    "filters_glass_cc0/isuzu IVG530 (Green filter) 2 mm",
];

/// Most instruments that are kept.
const MOST_INSTRUMENTS: usize = 20;

/// A verb, and the spectra that it is asked of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CombineState {
    pub verb: Verb,
    /// Keys of A, B and C.
    pub slots: [Option<String>; 3],
    /// Keys of scans of one light.
    pub scans: Vec<String>,
    /// Keys of the scans that they are compared with.
    pub others: Vec<String>,
    /// Width of the slit, nm.
    pub fwhm_nm: f64,
    /// True if a slit that is taken off has that width; else the light's lines tell it.
    pub is_told: bool,
    pub shape: Kernel,
    pub keep_all: bool,
    /// True if the quotient of two lights is a reflectance.
    pub of_surface: bool,
    /// What lights are brought to one scale by first.
    pub equal: Option<Normalise>,
    /// The instruments that were learnt.
    pub instruments: Vec<KeptInstrument>,
    /// Place of the one that corrects.
    pub instrument: usize,
    /// True if the light that an instrument is learnt from is daylight; else a black body.
    pub is_daylight: bool,
    /// Its temperature and the standard uncertainty of that, K.
    pub kelvin: f64,
    pub kelvin_doubt: f64,
}

impl Default for CombineState {
    fn default() -> Self {
        Self {
            verb: Verb::default(),
            slots: [const { None }; 3],
            scans: Vec::new(),
            others: Vec::new(),
            fwhm_nm: 10.0,
            is_told: false,
            shape: Kernel::Gauss,
            keep_all: false,
            of_surface: false,
            equal: None,
            instruments: Vec::new(),
            instrument: 0,
            is_daylight: false,
            kelvin: 2856.0,
            kelvin_doubt: 50.0,
        }
    }
}

impl PageState for CombineState {
    const KNOBS: &'static [Knob<Self>] = &[Self::WIDTH, Self::KELVIN, Self::DOUBT];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("verb", later!("the combination")),
        ("slots", later!("the spectra chosen")),
        ("scans", later!("the scans chosen")),
        ("others", later!("the scans compared with")),
        ("is_told", later!("a width that is known")),
        ("shape", later!("the shape of the slit")),
        ("keep_all", later!("everything kept")),
        ("of_surface", later!("a reflectance or a transmittance")),
        ("equal", later!("the scale of the lights")),
        ("instruments", later!("the instruments kept")),
        ("instrument", later!("the instrument chosen")),
        ("is_daylight", later!("the light that is known")),
    ];

    fn settle(&mut self) {
        self.instruments.truncate(MOST_INSTRUMENTS);
    }

    fn forget(&mut self, key: &str) {
        for slot in &mut self.slots {
            *slot = slot.take().filter(|chosen| chosen != key);
        }
        self.scans.retain(|chosen| chosen != key);
        self.others.retain(|chosen| chosen != key);
    }
}

impl CombineState {
    pub const WIDTH: Knob<Self> = knob!(fwhm_nm: later!("Slit"), Reach::Within(0.5, 30.0), 1 " nm",
        later!("Full width at half of the slit's top."));
    pub const KELVIN: Knob<Self> = knob!(kelvin: later!("Temperature"),
        Reach::Within(1000.0, 25_000.0), 0 " K",
        later!("Colour temperature of the known light; of daylight 4000 K or more."));
    pub const DOUBT: Knob<Self> = knob!(kelvin_doubt: later!(
        "Its uncertainty"
    ), Reach::Within(0.0, 1000.0), 0 " K",
        later!(
            "Standard uncertainty of the temperature; every light that is corrected shares it."
        ));

    /// What is done with the spectra; `None` for a comparison and for what is learnt, which make no
    /// spectrum, and without an instrument.
    fn act(&self) -> Option<Act> {
        let formula = |text: &str| Act::Formula {
            text: text.to_owned(),
            keep_all: self.keep_all,
            equal: self.equal,
            of_surface: self.of_surface,
        };
        let shape = self.shape;
        Some(match self.verb {
            Verb::Mean => Act::Mean {
                keep_all: self.keep_all,
            },
            Verb::Difference => formula("A - B"),
            Verb::Sum => formula("A + B"),
            Verb::Quotient => formula("A / B"),
            Verb::QuotientLessDark => formula("(A - C) / (B - C)"),
            Verb::Absorbance => formula("-log10(A / B)"),
            Verb::Splice => Act::Splice { is_sound: false },
            Verb::Slit => Act::Slit {
                fwhm_nm: self.fwhm_nm,
                shape,
            },
            Verb::Unslit => Act::Unslit {
                fwhm_nm: self.is_told.then_some(self.fwhm_nm),
                shape,
            },
            Verb::Corrected => {
                let kept = self
                    .instruments
                    .get(self.instrument)
                    .or(self.instruments.first())?;
                let instrument = instruments::json_of(&kept.text).ok()?;
                Act::Corrected { instrument }
            }
            Verb::Learnt | Verb::Changed => return None,
        })
    }

    /// Keys of what stands in the places of the verb, and of the set that is compared with.
    fn keys(&self) -> [Vec<&str>; 2] {
        let slots = self.verb.slots().len();
        if slots > 0 {
            let filled = self.slots.iter().take(slots).flatten();
            return [filled.map(String::as_str).collect(), Vec::new()];
        }
        let others = match self.verb {
            Verb::Changed => self.others.iter().map(String::as_str).collect(),
            _ => Vec::new(),
        };
        [self.scans.iter().map(String::as_str).collect(), others]
    }

    /// The recipe of the spectrum that is made, which follows its parts; `None` where a place is
    /// empty, and for a comparison.
    pub fn recipe(&self) -> Option<Recipe> {
        let act = self.act()?;
        let [parts, _] = self.keys();
        let is_full = parts.len() >= self.verb.slots().len().max(1);
        let parts = parts.into_iter().map(str::to_owned).collect();
        is_full.then_some(Recipe::Combined { act, parts })
    }

    /// Puts a spectrum in the first empty place, or among the scans.
    pub fn add(&mut self, entry: &Entry) {
        let slots = self.verb.slots().len();
        let key = entry.key.clone();
        if slots == 0 {
            if !self.scans.contains(&key) {
                self.scans.push(key);
            }
            return;
        }
        let places = &mut self.slots[..slots];
        let place = places.iter().position(Option::is_none);
        places[place.unwrap_or(slots - 1)] = Some(key);
    }

    /// What an empty place waits for, a sentence.
    fn waits(&self) -> Option<String> {
        let slots = self.verb.slots();
        let empty = slots.iter().zip(&self.slots);
        let empty = empty.filter(|(_, key)| key.is_none());
        let names = empty.map(|(slot, _)| said(slot.name).to_owned());
        let names = names.reduce(|one, other| tr!("{one} and {other}", one, other));
        match (self.verb, names) {
            (_, Some(places)) => Some(tr!("Choose {places}.", places)),
            (Verb::Changed, _) if self.scans.is_empty() => {
                Some(said!("Mark the scans of the first set.").to_owned())
            }
            (Verb::Changed, _) if self.others.is_empty() => {
                Some(said!("Mark the scans that they are compared with.").to_owned())
            }
            (Verb::Corrected, _) if self.instruments.is_empty() => {
                Some(said!("No instrument is kept yet: make one first.").to_owned())
            }
            _ => None,
        }
    }

    /// The known light, and its words.
    fn known(&self) -> (Known, String) {
        let kelvin = self.kelvin;
        match self.is_daylight {
            true => {
                let kelvin = kelvin.max(4000.0);
                (
                    Known::Daylight { kelvin },
                    format!("daylight {kelvin:.0} K"),
                )
            }
            false => (
                Known::BlackBody { kelvin },
                format!("black body {kelvin:.0} K"),
            ),
        }
    }
}

/// What the page asks: the state with the spectra that it names.
#[derive(Clone, Debug, PartialEq)]
pub struct CombineAsk {
    state: CombineState,
    sets: [Vec<ByAddress<Entry>>; 2],
    /// The light, another one and a filter, of which examples are made.
    example: [ByAddress<Entry>; 3],
}

impl CombineAsk {
    /// The question of a state; `None` without the shipped spectra that examples are made of.
    pub fn of(app: &App, state: &CombineState) -> Option<Self> {
        let entry = |key: &str| app.entry(key).map(ByAddress);
        let [other, filter] = EXAMPLE.map(entry);
        // What came from a file may be a dark frame.
        let light = Some(ByAddress(app.document().light.clone()));
        let light = light.filter(|light| light.0.shelf().is_some());
        let light = light.or_else(|| entry(FIRST_LIGHT));
        let sets = state.keys();
        Some(Self {
            sets: sets.map(|keys| keys.into_iter().filter_map(entry).collect()),
            state: state.clone(),
            example: [light?, other?, filter?],
        })
    }

    fn is_example(&self) -> bool {
        self.sets.iter().all(Vec::is_empty)
    }

    fn example_of(&self) -> Option<String> {
        let name = || self.example[0].0.name().to_owned();
        self.is_example().then(name)
    }

    fn drawn(&self) -> Drawn<'_> {
        let [light, other, filter] = self.example.each_ref().map(|entry| &*entry.0);
        Drawn {
            light,
            other,
            filter,
        }
    }

    /// A reading corrected by the instrument of the example.
    fn by_the_example(&self, parts: &[Part]) -> Result<Found, String> {
        let [reading, _] = example(Verb::Learnt, &self.drawn())?;
        let usual = CombineState::default();
        let (known, words) = usual.known();
        let doubt = usual.kelvin_doubt;
        let found = learnt(&measurements(&reading), &known, &words, doubt, None)?;
        let instrument = found.instrument.ok_or(said!("nothing was learnt"))?;
        let text = instruments::text(&instrument);
        let instrument = instruments::json_of(&text)?;
        Act::Corrected { instrument }.of(parts)
    }

    /// The measurements of both sets.
    fn parts(&self) -> Result<[Vec<Part>; 2], String> {
        if self.is_example() {
            return example(self.state.verb, &self.drawn());
        }
        let parts = |set: &[ByAddress<Entry>]| -> Result<Vec<Part>, String> {
            let part = |entry: &ByAddress<Entry>| Part::of_entry(&entry.0, false);
            set.iter().map(part).collect()
        };
        Ok([parts(&self.sets[0])?, parts(&self.sets[1])?])
    }
}

impl Question for CombineAsk {
    type Answer = Combined;

    fn answer(&self, _: &Progress) -> Option<Combined> {
        let parts = match self.parts() {
            Ok(parts) => parts,
            Err(why) => return Some(Combined::refused(why, self, &[const { Vec::new() }; 2])),
        };
        if !self.is_example()
            && let Some(words) = self.state.waits()
        {
            return Some(Combined::refused(words, self, &parts));
        }
        let [first, second] = &parts;
        let act = self.state.act();
        let found = match (&act, self.state.verb) {
            (Some(act), _) => act.of(first),
            (None, Verb::Changed) => {
                let sets = [first, second].map(|set| measurements(set));
                of_change(&sets[0], &sets[1], self.state.keep_all)
            }
            (None, Verb::Corrected) => self.by_the_example(first),
            (None, _) => {
                let (known, words) = self.state.known();
                let doubt = self.state.kelvin_doubt;
                learnt(&measurements(first), &known, &words, doubt, None)
            }
        };
        Some(match found {
            Ok(found) => {
                let title = act.map_or_else(|| found.made_by.clone(), |act| act.name(first));
                Combined::of(&found, self, &parts, title)
            }
            Err(why) => Combined::refused(why, self, &parts),
        })
    }
}

/// What came of it, as it is shown.
#[derive(Clone, Debug)]
pub struct Combined {
    /// A sentence: the result, what an empty place waits for, or why it means nothing.
    pub says: String,
    pub chart: Chart,
    /// Figures, lines, scans, parts that differ, each under its title.
    pub tables: Vec<(&'static str, Table)>,
    pub notes: Vec<String>,
    /// Keys of scans that are left out, each with why.
    pub left_out: Vec<(String, String)>,
    /// True if a spectrum was made of the user's own choice.
    pub is_made: bool,
    /// The instrument that was learnt.
    pub instrument: Option<KeptInstrument>,
    /// The name of the light that an example is drawn of; none where it is the user's own.
    pub example_of: Option<String>,
}

impl Combined {
    fn of(found: &Found, ask: &CombineAsk, sets: &[Vec<Part>; 2], title: String) -> Self {
        let (own, rest) = found.notes();
        // A comparison's first note is its sentence.
        let told = usize::from(found.result.is_none());
        let keys = ask.sets[0].iter().map(|entry| entry.0.key.clone());
        let odd = keys.zip(&found.scans).filter(|(_, scan)| !scan.is_kept);
        let why = |(key, scan): (String, &ScanRow)| Some((key, scan.why.clone()?));
        Self {
            says: words::headline(found),
            chart: match &found.result {
                Some(_) => combined_chart(found, title, &sets[0]),
                None => readings_chart(sets),
            },
            tables: tables(found),
            notes: own.into_iter().skip(told).chain(rest).collect(),
            left_out: odd.filter_map(why).collect(),
            is_made: found.result.is_some() && !found.is_learnt && !ask.is_example(),
            instrument: found
                .instrument
                .as_ref()
                .filter(|_| found.is_learnt && !ask.is_example())
                .map(KeptInstrument::of),
            example_of: ask.example_of(),
        }
    }

    /// Nothing was made: the spectra chosen so far are drawn.
    fn refused(says: String, ask: &CombineAsk, sets: &[Vec<Part>; 2]) -> Self {
        Self {
            says,
            chart: readings_chart(sets),
            tables: Vec::new(),
            notes: Vec::new(),
            left_out: Vec::new(),
            is_made: false,
            instrument: None,
            example_of: ask.example_of(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{Command, MadeFor},
        spectrum::{Kind, NamedSpectrum, Outside, Sampled},
    };

    fn answer(app: &App, state: &CombineState) -> Combined {
        let ask = CombineAsk::of(app, state).expect("shipped examples");
        ask.answer(&Progress::default()).expect("an answer")
    }

    #[test]
    fn the_page_makes_what_its_recipe_makes_and_says_what_it_waits_for() {
        let mut app = App::new();
        let mut state = CombineState {
            verb: Verb::Quotient,
            ..CombineState::default()
        };
        assert_eq!(answer(&app, &state).example_of.as_deref(), Some("FL2"));
        let [fl2, a] = ["cie_fluorescent_1nm/FL2", "cie_illuminants/CIE A"].map(str::to_owned);
        state.slots = [Some(fl2), None, None];
        let waiting = answer(&app, &state);
        assert_eq!(waiting.says, "Choose Reference B.");
        assert!(!waiting.is_made && state.recipe().is_none());
        state.slots[1] = Some(a);
        assert!(answer(&app, &state).is_made);
        let recipe = state.recipe().expect("a spectrum");
        let place = MadeFor::Shown;
        app.apply(Command::Make { recipe, place });
        let own = app.document().own[0].clone();
        assert_eq!(own.name(), "FL2 / CIE A");
        state.verb = Verb::Mean;
        state.add(&own);
        state.add(&own);
        assert_eq!(state.scans.len(), 1);
        state.verb = Verb::Absorbance;
        state.slots[1] = Some("colorchecker_ohta/red".to_owned());
        let refused = answer(&app, &state);
        assert!(
            refused.says.contains("A light has no absorbance"),
            "{}",
            refused.says
        );
        state.forget("cie_fluorescent_1nm/FL2");
        state.forget(&own.key);
        assert_eq!((&state.slots[0], state.scans.len()), (&None, 0));
    }

    #[test]
    fn an_instrument_learnt_from_a_bulb_makes_a_light_of_counts() {
        let mut app = App::new();
        let response = |nm: f64| 1e4 * (-((nm - 540.0) / 160.0).powi(2)).exp();
        let mut counted = |key: &str| {
            let of = app.entry(key).expect("shipped").spectrum.clone();
            let values = (380..=780).map(f64::from);
            let values = values.map(|nm| response(nm) * of.samples.at(nm, Outside::Zero));
            let samples = Sampled::even(380.0, 1.0, values.collect()).expect("finite");
            let counts = NamedSpectrum {
                kind: Kind::Other,
                unit: "counts".to_owned(),
                samples,
                ..of
            };
            app.apply(Command::Adopt(vec![counts]));
            app.document().own.last().expect("it").key.clone()
        };
        let [bulb, tube] = ["cie_illuminants/CIE A", "cie_fluorescent_1nm/FL2"].map(&mut counted);
        let mut state = CombineState {
            verb: Verb::Learnt,
            slots: [Some(bulb), None, None],
            ..CombineState::default()
        };
        let learnt = answer(&app, &state);
        assert!(!learnt.is_made, "{}", learnt.says);
        state.instruments.extend(learnt.instrument);
        assert!(state.instruments[0].about.contains("black body 2856 K"));
        state.verb = Verb::Corrected;
        state.slots[0] = Some(tube);
        assert!(answer(&app, &state).is_made);
        let recipe = state.recipe().expect("a light");
        let place = MadeFor::Shown;
        app.apply(Command::Make { recipe, place });
        let light = app.document().own.last().expect("made").clone();
        let of = app.entry("cie_fluorescent_1nm/FL2").expect("shipped");
        let ratio = |nm: f64| {
            let value = |entry: &Entry| entry.spectrum.samples.at(nm, Outside::Zero);
            value(&light) / value(&of)
        };
        for nm in [436.0, 500.0, 546.0, 620.0] {
            // CIE A is a black body with another c2: at 2856 K it is one of 2855.5 K, less than .1 %.
            assert!((ratio(nm) / ratio(560.0) - 1.0).abs() < 2e-3, "{nm}");
        }
        state.instruments.clear();
        let refused = answer(&app, &state);
        assert!(
            refused.says.starts_with("No instrument is kept"),
            "{}",
            refused.says
        );
    }

    #[test]
    fn every_verb_has_an_example_that_makes_something_of_the_first_light() {
        let app = App::new();
        for verb in Verb::ALL {
            let state = CombineState {
                verb,
                ..CombineState::default()
            };
            let ask = CombineAsk::of(&app, &state).expect("shipped examples");
            let [first, second] = ask.parts().expect("readings");
            let wanted = verb.slots().len();
            assert!(wanted == 0 || first.len() == wanted, "{}", verb.title());
            assert_eq!(second.is_empty(), verb != Verb::Changed);
            let shown = answer(&app, &state);
            assert!(shown.chart.all_series().count() > 0, "{}", verb.title());
            match verb {
                Verb::Mean => assert!(shown.says.starts_with("The mean of 5 scans: CCT")),
                Verb::Changed => assert!(shown.says.starts_with("Different:"), "{}", shown.says),
                // A green filter of 2 mm: all of it is above the noise of a bright reference.
                Verb::Quotient => assert!(shown.says.starts_with("A transmittance")),
                Verb::Unslit => {
                    let slit = shown.notes.iter().find(|note| note.contains("The slit is"));
                    assert!(slit.is_some(), "{:?}", shown.notes);
                }
                _ => {}
            }
        }
    }
}
