//! Known lamps and wide lines in the race: per cent of cells won against each peer.
//!
//! A cell is a class of lights, a count of numbers, an error (patches, filters, blurred) and a figure
//! of its spread (median, 95th percentile, worst). Judged is by what took no part in any choice. No
//! table holds the light at hand: principal components are those trained without it, its namesakes
//! and its likes. Known lamps are left out by the same rule ([`LeaveOut::Likes`] and namesakes), or
//! by that of LINES.md alone ([`LeaveOut::Itself`]), which keeps the 5 nm table of a lamp raced at
//! 1 nm.

use std::sync::{
    Mutex,
    atomic::{AtomicUsize, Ordering},
};

use super::{
    ask::{Ask, Count, LeaveOut},
    encoder::Encoder,
    error::EncodingError,
    judge::{Errors, Exact, Panel},
    known::known_lamps,
    standing::{Entrant, Standing},
    today::Today,
};
use crate::{
    color::PatchSet,
    rivals::{Bounds, Family, FitTables},
    study::{
        Progress,
        race::{Course, Lamp},
        reference::scaled_to_one,
    },
};

/// What all lights share at one count.
struct Heat {
    numbers: usize,
    today: Today,
    /// The judging patches as each entrant has them.
    patches: Vec<PatchSet>,
    /// The choosing patches as cosines, for the choice among today's ways.
    choosing: PatchSet,
}

/// A light on the grid with its exact sides.
struct Runner<'a> {
    lamp: &'a Lamp,
    values: Vec<f64>,
    judged: Exact,
    chosen: Exact,
}

/// Runs the race on all processors; `None` when it was cancelled or no light has a colour.
///
/// # Errors
/// [`EncodingError`] for a count that the encoder does not take.
pub fn race(
    course: &Course,
    lamps: &[Lamp],
    encoder: &Encoder,
    (count, leave_out): (Count, LeaveOut),
    progress: &Progress,
) -> Result<Option<Standing>, EncodingError> {
    let band = encoder.panel().band();
    if course.measures.band() != band {
        return Err(EncodingError::Band {
            found: course.measures.band(),
            expected: band,
        });
    }
    let judge = Panel::judging(band, encoder.panel().observer());
    let runners: Vec<Runner<'_>> = lamps
        .iter()
        .filter_map(|lamp| runner(lamp, encoder, &judge))
        .collect();
    if runners.is_empty() {
        return Ok(None);
    }
    let most = course.budgets.iter().copied().max().unwrap_or(1).max(3);
    let tables = FitTables::new(band, most);
    let heats: Vec<Heat> = course
        .budgets
        .iter()
        .map(|n| heat(course, encoder, &judge, &tables, *n))
        .collect();
    let track = Track {
        course,
        encoder,
        judge: &judge,
        tables: &tables,
        count,
        leave_out,
    };
    let tasks: Vec<(usize, usize)> = (0..runners.len())
        .flat_map(|lamp| (0..heats.len()).map(move |budget| (lamp, budget)))
        .collect();
    progress.expect(tasks.len());
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<(usize, RunResult)>> = Mutex::default();
    let work = || {
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some((lamp, budget)) = tasks.get(place) else {
                return;
            };
            if progress.is_cancelled() {
                return;
            }
            let result = track.run(&runners[*lamp], &heats[*budget]);
            // A thread that panicked holds no half-written result: each push is whole.
            found
                .lock()
                .unwrap_or_else(|e| e.into_inner())
                .push((place, result));
            progress.step();
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    let mut found = found.into_inner().unwrap_or_else(|e| e.into_inner());
    if progress.is_cancelled() || found.len() < tasks.len() {
        return Ok(None);
    }
    found.sort_by_key(|(place, _)| *place);
    let mut errors = Vec::with_capacity(tasks.len() * Entrant::ALL.len());
    for (_, result) in found {
        errors.extend(result?);
    }
    Ok(Some(Standing {
        lamps: runners
            .iter()
            .map(|r| (r.lamp.name.clone(), r.lamp.class.clone()))
            .collect(),
        budgets: course.budgets.clone(),
        count,
        leave_out,
        errors,
    }))
}

fn runner<'a>(lamp: &'a Lamp, encoder: &Encoder, judge: &Panel) -> Option<Runner<'a>> {
    let values = scaled_to_one(&lamp.values).filter(|v| v.len() == judge.band().points())?;
    Some(Runner {
        judged: judge.exact(&values)?,
        chosen: encoder.panel().exact(&values)?,
        values,
        lamp,
    })
}

fn heat(
    course: &Course,
    encoder: &Encoder,
    judge: &Panel,
    tables: &FitTables,
    numbers: usize,
) -> Heat {
    let of_peer = |family: Family| {
        judge.patches_as(|r| {
            let fit = tables.fit(
                family,
                r,
                numbers,
                Bounds::Reflectance,
                &course.reflectances,
            );
            fit.on_band()
        })
    };
    let cosines = judge.patches_as_cosines(numbers);
    let patches = Entrant::ALL.map(|entrant| match entrant {
        Entrant::Peer(family) => of_peer(family),
        Entrant::KnownLamps | Entrant::WideLines | Entrant::Today => cosines.clone(),
    });
    Heat {
        numbers,
        today: Today::new(encoder.panel(), numbers, course.spikes),
        patches: patches.into(),
        choosing: encoder.panel().patches_as_cosines(numbers),
    }
}

/// Everybody's errors on one light at one count.
type RunResult = Result<Vec<Option<Errors>>, EncodingError>;

/// What every task needs.
struct Track<'a> {
    course: &'a Course,
    encoder: &'a Encoder,
    judge: &'a Panel,
    tables: &'a FitTables,
    count: Count,
    leave_out: LeaveOut,
}

impl Track<'_> {
    /// Everybody's errors on one light.
    fn run(&self, runner: &Runner<'_>, heat: &Heat) -> Result<Vec<Option<Errors>>, EncodingError> {
        let mut all = Vec::with_capacity(Entrant::ALL.len());
        for (entrant, patches) in Entrant::ALL.into_iter().zip(&heat.patches) {
            let values = match entrant {
                Entrant::KnownLamps => Some(self.encoded(runner, heat, true)?),
                Entrant::WideLines => Some(self.encoded(runner, heat, false)?),
                Entrant::Today => self.best_of_today(runner, heat)?,
                Entrant::Peer(family) => Some(self.peer(family, runner, heat.numbers)),
            };
            all.push(values.map(|values| self.judge.errors(&runner.judged, &values, patches)));
        }
        Ok(all)
    }

    fn encoded(
        &self,
        runner: &Runner<'_>,
        heat: &Heat,
        with_lamps: bool,
    ) -> Result<Vec<f64>, EncodingError> {
        let ask = Ask {
            numbers: heat.numbers,
            count: self.count,
            known_lamps: with_lamps,
            leave_out: self.leave_out,
        };
        let name = runner.lamp.name.as_str();
        let is_namesake = |known: &str| !known.is_empty() && known.eq_ignore_ascii_case(name);
        let namesakes: Vec<u8> = match self.leave_out {
            LeaveOut::None | LeaveOut::Itself => Vec::new(),
            LeaveOut::Likes => {
                let lamps = known_lamps().iter().filter(|lamp| is_namesake(&lamp.name));
                lamps.map(|lamp| lamp.index).collect()
            }
        };
        let chosen = self
            .encoder
            .encode_without(&runner.values, ask, &namesakes)?;
        self.encoder.decoder().decode(&chosen.encoding)
    }

    /// The way that is best on the patches that choose, as the program chooses today.
    fn best_of_today(
        &self,
        runner: &Runner<'_>,
        heat: &Heat,
    ) -> Result<Option<Vec<f64>>, EncodingError> {
        let mut best: Option<(f64, Vec<f64>)> = None;
        for way in heat.today.ways(&runner.values) {
            let values = self.encoder.decoder().decode(&way)?;
            let errors = self
                .encoder
                .panel()
                .errors(&runner.chosen, &values, &heat.choosing);
            if best
                .as_ref()
                .is_none_or(|(least, _)| errors.patches < *least)
            {
                best = Some((errors.patches, values));
            }
        }
        Ok(best.map(|(_, values)| values))
    }

    fn peer(&self, family: Family, runner: &Runner<'_>, numbers: usize) -> Vec<f64> {
        let basis = match family {
            Family::Principal => {
                self.course
                    .lights
                    .basis_for(&runner.lamp.name, &runner.values, numbers)
            }
            _ => &self.course.reflectances,
        };
        self.tables
            .fit(family, &runner.values, numbers, Bounds::Light, basis)
            .on_band()
    }
}
