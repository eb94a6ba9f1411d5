//! Who wins: per class and count, and per light.

use std::sync::Arc;

use super::{error_words, place};
use crate::{
    app::{
        Entry,
        library::Library,
        race_report::sets,
        studies::{Class, Field, RaceAsk},
    },
    preset::Preset,
    spectrum::Kind,
    study::{Measure, Race, race::Racer},
};

/// A winner with its error in words.
#[derive(Clone)]
pub struct Won {
    /// Who wins; none where the figure does not exist.
    pub racer: Option<Racer>,
    /// By which error, with its unit.
    pub error: String,
}

/// A light of the race.
pub struct Lamp {
    pub name: String,
    pub class: String,
    /// Who wins on it.
    pub won: Won,
    /// Its entry in the library; none when it left.
    pub entry: Option<Arc<Entry>>,
}

pub struct Winners {
    /// What decides.
    pub measure: Measure,
    /// The count of numbers of [`lamps`](Self::lamps).
    pub numbers: usize,
    /// The counts of numbers of [`sets`](Self::sets).
    pub budgets: Vec<usize>,
    /// A set's name with its count of lights and its winner at every count of numbers.
    pub sets: Vec<(String, usize, Vec<Won>)>,
    /// Every light.
    pub lamps: Vec<Lamp>,
}

impl Winners {
    /// The winners of a race, per light at one count.
    pub fn new(ask: &RaceAsk, race: &Race, budget: usize, measure: Measure) -> Self {
        let won = |racer: Option<Racer>, error: &dyn Fn(usize) -> Option<f64>| {
            let at = racer.and_then(|racer| place(race, racer));
            Won {
                racer,
                error: error_words(measure, at.and_then(error)),
            }
        };
        let sets = sets(race)
            .into_iter()
            .map(|(name, class)| {
                let class = class.as_deref();
                let won = (0..race.budgets.len())
                    .map(|budget| {
                        let racer = race.winner_of(class, budget, measure);
                        won(racer, &|place| {
                            Some(race.spread(class, budget, place, measure)?.median)
                        })
                    })
                    .collect();
                (name, race.of_class(class).count(), won)
            })
            .collect();
        let lamps = race
            .lamps
            .iter()
            .enumerate()
            .map(|(i, (name, class))| {
                let racer = race.winner_on(i, budget, measure);
                Lamp {
                    name: name.clone(),
                    class: class.clone(),
                    won: won(racer, &|place| race.run(i, budget, place).verdict[measure]),
                    entry: entry_of(&ask.field, race, i),
                }
            })
            .collect();
        Self {
            measure,
            numbers: race.budgets[budget],
            budgets: race.budgets.clone(),
            sets,
            lamps,
        }
    }
}

/// The entry of the library, or of the user's own, that a light of the race came from.
fn entry_of(field: &Field, race: &Race, lamp: usize) -> Option<Arc<Entry>> {
    let name = &race.lamps[lamp].0;
    // Two tables of one name stand in the order in which they raced.
    let before = race.lamps[..lamp].iter().filter(|l| l.0 == *name).count();
    let shipped = |wanted: &dyn Fn(&Preset) -> bool| {
        let mut called = Library::bundled()
            .presets()
            .filter(|p| p.kind == Kind::Light && p.name == *name && p.line_list().is_none())
            .filter(|p| wanted(p));
        Entry::of_preset(called.nth(before)?).map(Arc::new)
    };
    match field {
        Field::One(entry) => Some(entry.0.clone()),
        Field::Shipped => shipped(&|_| true),
        Field::Class(class) => shipped(&|p| Class::of(p) == Some(*class)),
        Field::Group(group) => shipped(&|p| p.group == *group),
        Field::These(entries) => entries
            .iter()
            .filter(|entry| entry.0.name() == name)
            .nth(before)
            .map(|entry| entry.0.clone()),
    }
}
