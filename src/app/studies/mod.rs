//! Long computations about the document, each a job with progress, cancel, and a result that stays
//! while the next is computed.

mod about;
mod crossing;
mod far;
mod field;
mod job;
mod lamps;
pub mod lights_quality;
pub mod paper;
mod surfaces;
pub mod take;

pub use super::worker::Wake;
pub use about::{About, Patches, reflectances};
pub use crossing::Crossing;
pub use far::answered;
pub use field::{CHECK_SET, Class, Field, RaceAsk};
pub use job::{Job, Question, Stage, Work};
pub use lamps::{EncodeAsk, EncodedLight, most_numbers};
pub use lights_quality::LightsQualityAsk;
pub(super) use surfaces::surfaces;
pub use surfaces::{Pairs, PairsAsk, Surface, shipped_reflectances};
pub use take::take;

use std::{
    any::{Any, TypeId},
    collections::{HashMap, HashSet},
};

use serde::{Deserialize, Serialize};

use super::{document::Document, memo::ByAddress, pages::FieldChoice, tables::CURVE_ORDER};
use crate::{
    lamps::own_profile,
    spectrum::{Basis, Kind},
    study::{
        Auction, Goal, ManyLights, Progress, Race, Subject, Sweep,
        auction::{self, Terms},
        products::{ProductTime, Sizes, product_times},
        race::{self, Lamp},
    },
};

/// What a sweep is about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweepAsk {
    /// The spectrum and its measures.
    pub about: About,
    /// Basis of the threshold map.
    pub basis: Basis,
    /// Fit of the threshold map.
    pub colour_exact: bool,
    pub highest_order: usize,
}

impl SweepAsk {
    /// The sweep of a document: to the order curve's end, or to the order in force beyond it.
    pub fn of(document: &Document) -> Self {
        let settings = document.settings;
        Self {
            about: About::of(document),
            basis: settings.basis,
            colour_exact: settings.colour_exact,
            highest_order: CURVE_ORDER.max(settings.effective_order()),
        }
    }
}

impl Question for SweepAsk {
    type Answer = Sweep;

    fn answer(&self, progress: &Progress) -> Option<Sweep> {
        Sweep::of(
            &self.about.subject(),
            self.highest_order,
            self.basis,
            self.colour_exact,
            progress,
        )
    }

    fn crossing() -> Option<Crossing<Self, Sweep>> {
        Some(Crossing::of("sweep"))
    }
}

/// What error against order of many lights is about: who, and on what, as in a race.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ManyAsk(pub RaceAsk);

impl ManyAsk {
    /// These lights under a document's settings.
    pub fn of(document: &Document, field: Field) -> Self {
        Self(RaceAsk::of(document, field, Vec::new()))
    }

    /// The lights, each once: many a shipped one has two tables, of which the finer stands first.
    fn lights(&self) -> Vec<Lamp> {
        let mut lights = self.0.lamps();
        if matches!(self.0.field, Field::Shipped | Field::Class(_)) {
            let mut known = HashSet::new();
            lights.retain(|light| known.insert(light.name.clone()));
        }
        lights
    }
}

impl Question for ManyAsk {
    type Answer = ManyLights;

    /// The answer; `None` when no light shines or it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<ManyLights> {
        let Self(of) = self;
        let measures = of.patches.measures(of.band, of.observer);
        ManyLights::of(&measures, of.spikes, &self.lights(), CURVE_ORDER, progress)
    }

    fn crossing() -> Option<Crossing<Self, ManyLights>> {
        Some(Crossing::of("many"))
    }
}

/// What an auction is about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AuctionAsk {
    /// The spectrum and its measures.
    pub about: About,
    /// Basis, fit, goal and budget.
    pub terms: Terms,
}

impl AuctionAsk {
    /// The auction of a document's subject with its basis and fit.
    pub fn of(document: &Document, goal: Goal, numbers: usize) -> Self {
        let settings = document.settings;
        Self {
            about: About::of(document),
            terms: Terms {
                basis: settings.basis,
                colour_exact: settings.colour_exact,
                goal,
                numbers,
            },
        }
    }
}

impl Question for AuctionAsk {
    type Answer = Auction;

    fn answer(&self, progress: &Progress) -> Option<Auction> {
        let subject = Subject {
            profile: Some(own_profile),
            ..self.about.subject()
        };
        auction::hold(&subject, self.terms, progress)
    }

    fn crossing() -> Option<Crossing<Self, Auction>> {
        Some(Crossing::of("auction"))
    }
}

impl FieldChoice {
    /// The lights of the choice in a document.
    pub fn field(self, document: &Document) -> Field {
        match self {
            Self::ThisLight => Field::One(ByAddress(document.light.clone())),
            Self::Shipped => Field::Shipped,
            Self::Smooth => Field::Class(Class::Smooth),
            Self::Led => Field::Class(Class::Led),
            Self::Fluorescent => Field::Class(Class::Fluorescent),
            Self::Discharge => Field::Class(Class::Discharge),
            Self::Own => Field::These(
                document
                    .own
                    .iter()
                    .filter(|entry| entry.kind() == Kind::Light)
                    .map(|entry| ByAddress(entry.clone()))
                    .collect(),
            ),
        }
    }
}

impl Question for RaceAsk {
    type Answer = Race;

    /// The answer; `None` when no light shines, the range is too long ([`RaceAsk::why_not`]) or it
    /// was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Race> {
        if self.why_not().is_some() {
            return None;
        }
        race::run(&self.course(), &self.lamps(), progress)
    }

    fn crossing() -> Option<Crossing<Self, Race>> {
        Some(Crossing::of("race"))
    }
}

/// What the times of products are about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimingAsk {
    /// How large the products are.
    pub sizes: Sizes,
    /// Which measurement it is: asking again is another one.
    pub turn: u32,
}

impl Question for TimingAsk {
    type Answer = Vec<ProductTime>;

    /// The answer; `None` when it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Vec<ProductTime>> {
        product_times(self.sizes, progress)
    }
}

/// The jobs of a window, each found by what is asked and what the answer is. A page brings its
/// own: there is no list of them.
#[derive(Default)]
pub struct Studies {
    jobs: HashMap<TypeId, Box<dyn Work>>,
    /// While a light is followed: each job is finished, and then asked about the newest frame.
    pub patient: bool,
}

impl Studies {
    /// The job of a kind of key and answer.
    ///
    /// # Panics
    /// Never: what is kept for a kind of job is one of that kind.
    pub fn job<K, T>(&mut self) -> &mut Job<K, T>
    where
        K: Clone + PartialEq + 'static,
        T: Send + 'static,
    {
        let kind = TypeId::of::<Job<K, T>>();
        let job = self.jobs.entry(kind);
        let job: &mut dyn Any = &mut **job.or_insert_with(|| Box::new(Job::<K, T>::default()));
        let job = job.downcast_mut::<Job<K, T>>().expect("a job of its kind");
        job.patient = self.patient;
        job
    }

    /// The job of a kind of question that holds all that its answer depends on.
    pub fn of<Q>(&mut self) -> &mut Job<Q, Q::Answer>
    where
        Q: Question<Answer: Send> + Clone + PartialEq + 'static,
    {
        self.job()
    }

    /// Takes in what is finished.
    pub fn take_in(&mut self) {
        self.jobs.values_mut().for_each(|job| job.take_in());
    }

    /// Whether anything is being computed.
    pub fn is_running(&self) -> bool {
        self.jobs.values().any(|job| job.is_running())
    }

    /// Waits for everything.
    pub fn finish(&mut self) {
        self.jobs.values_mut().for_each(|job| job.finish());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{App, Command, Library},
        spectrum::Outside,
    };

    #[test]
    fn of_two_tables_of_one_light_the_finer_is_looked_at() {
        let ask = ManyAsk::of(App::new().document(), Field::Shipped);
        let (all, lights) = (ask.0.lamps(), ask.lights());
        let called = |lamps: &[Lamp], name: &str| -> Vec<Vec<f64>> {
            let of_name = lamps.iter().filter(|lamp| lamp.name == name);
            of_name.map(|lamp| lamp.values.clone()).collect()
        };
        for lamp in &all {
            assert_eq!(called(&lights, &lamp.name).len(), 1, "{}", lamp.name);
        }
        let fine = Library::bundled().find("cie_led_1nm/LED-B4");
        let fine = fine.expect("shipped").spectrum().expect("a table");
        let values = fine.samples.on_band(ask.0.band, Outside::Zero);
        assert_eq!(called(&all, "LED-B4").len(), 2);
        assert_eq!(called(&lights, "LED-B4"), [values]);
    }

    #[test]
    fn a_surface_of_ones_own_among_the_patches_judges_many_lights_too() {
        let mut app = App::new();
        let red = Library::bundled().find("colorchecker_ohta/red");
        let red = red.expect("shipped").spectrum().expect("a table");
        app.apply(Command::Adopt(vec![red.clone()]));
        let key = app.document().own[0].key.clone();
        let before = ManyAsk::of(app.document(), Field::Shipped);
        app.apply(Command::ToggleOwnPatch { key });
        let ask = ManyAsk::of(app.document(), Field::Shipped);
        assert!(ask != before, "another question");
        assert_eq!(ask.0.course().patches.len(), 25);
        assert_eq!(ask.0.patches.words(), "colorchecker_ohta and 1 of your own");
    }
}
