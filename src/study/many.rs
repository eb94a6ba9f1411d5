//! Error against order for many lights: which order is enough for how many of them.

use std::sync::Arc;

use super::{
    measure::Measure,
    parallel::{in_parallel, processors},
    progress::Progress,
    race::Lamp,
    reference::Measures,
    sweep::{Examined, Subject, SweepPoint},
    way::FitVariant,
};
use crate::spectrum::{Basis, SpikeSettings, numbers_of_order};

/// A light with its models of every way and order.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SweptLight {
    /// Its name.
    pub name: String,
    /// Class under which it is listed.
    pub class: String,
    /// All orders of the first way, then of the next.
    points: Vec<SweepPoint>,
}

impl SweptLight {
    /// The models of a way, by rising order.
    pub(crate) fn of_way(&self, way: FitVariant) -> impl DoubleEndedIterator<Item = &SweepPoint> {
        self.points.iter().filter(move |point| point.way == way)
    }

    /// The first model of a way from which on no order is off by more than a limit; `None` where
    /// the highest order still is, or where the figure does not exist.
    pub(crate) fn enough(
        &self,
        way: FitVariant,
        measure: Measure,
        limit: f64,
    ) -> Option<&SweepPoint> {
        let within = |point: &&SweepPoint| point.verdict[measure].is_some_and(|off| off <= limit);
        self.of_way(way).rev().take_while(within).last()
    }
}

/// Many lights, each with its models of every way and order.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ManyLights {
    /// Those that shine in the range.
    pub lights: Vec<SweptLight>,
    /// Number of lights that do not, and are left out.
    pub dark: usize,
    /// Highest order looked at.
    pub highest_order: usize,
}

impl ManyLights {
    /// Sweeps lights on the grid of the measures to `highest_order`, several at a time. `None` when
    /// none of them shines or it was cancelled.
    pub(crate) fn of(
        measures: &Arc<Measures>,
        spikes: SpikeSettings,
        lamps: &[Lamp],
        highest_order: usize,
        progress: &Progress,
    ) -> Option<Self> {
        let highest_order = highest_order.min(Basis::highest_order(measures.band()));
        progress.expect(lamps.len());
        let swept = |lamp: &Lamp| {
            if !lamp.shines() {
                return None;
            }
            let subject = Subject {
                measures: measures.clone(),
                values: lamp.values.clone(),
                under: None,
                spikes,
                profile: None,
            };
            let examined = Examined::of(&subject, numbers_of_order(highest_order))?;
            Some(SweptLight {
                name: lamp.name.clone(),
                class: lamp.class.clone(),
                points: examined.every_way(highest_order, progress, || {})?,
            })
        };
        let found = in_parallel(lamps, processors(), progress, swept)?;
        let lights: Vec<SweptLight> = found.into_iter().flatten().collect();
        (!progress.is_cancelled() && !lights.is_empty()).then(|| Self {
            dark: lamps.len() - lights.len(),
            lights,
            highest_order,
        })
    }

    /// For how many lights each order is enough, from 0 on; it never falls.
    pub(crate) fn counts(&self, way: FitVariant, measure: Measure, limit: f64) -> Vec<usize> {
        let enough = self.lights.iter().filter_map(|light| {
            let point = light.enough(way, measure, limit)?;
            Some(point.order)
        });
        let mut counts = vec![0; self.highest_order + 1];
        enough.for_each(|order| counts[order] += 1);
        let mut sum = 0;
        for count in &mut counts {
            sum += *count;
            *count = sum;
        }
        counts
    }

    /// The least order that is enough for a share (0-1) of the lights, and for how many it is;
    /// `None` where no order looked at is.
    pub(crate) fn order_for(
        &self,
        way: FitVariant,
        measure: Measure,
        limit: f64,
        share: f64,
    ) -> Option<(usize, usize)> {
        // Rounding of the share asks for no light more.
        let wanted = (share * self.lights.len() as f64 - 1e-9).ceil() as usize;
        let counts = self.counts(way, measure, limit);
        let order = counts.iter().position(|count| *count >= wanted)?;
        Some((order, counts[order]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::{Observer, patches::PatchSet},
        spectrum::Band,
        study::Sweep,
    };

    fn lamp(name: &str, value: impl Fn(f64) -> f64) -> Lamp {
        Lamp {
            name: name.to_owned(),
            class: "own".to_owned(),
            values: Band::VISIBLE.grid().map(value).collect(),
        }
    }

    fn measures() -> Arc<Measures> {
        let band = Band::VISIBLE;
        let grey: Vec<f64> = band.grid().map(|nm| 0.2 + 0.001 * (nm - 380.0)).collect();
        let patches = PatchSet::new(&[grey], vec!["grey".to_owned()], band, Observer::CIE_1931);
        Arc::new(Measures::new(patches))
    }

    /// A flat light, a slope, one of many waves, one that is dark and one below zero.
    fn lamps() -> Vec<Lamp> {
        vec![
            lamp("flat", |_| 1.0),
            lamp("slope", |nm| nm / 500.0),
            lamp("waves", |nm| 1.2 + (nm / 8.0).sin()),
            lamp("dark", |_| 0.0),
            lamp("negative", |_| -1.0),
        ]
    }

    const WAY: FitVariant = FitVariant::new(Basis::Cosine, false, false);

    #[test]
    fn each_light_is_swept_as_it_is_alone_and_a_dark_one_is_left_out() {
        let (judge, spikes) = (measures(), SpikeSettings::default());
        let many =
            ManyLights::of(&judge, spikes, &lamps(), 30, &Progress::default()).expect("lights");
        let names: Vec<&str> = many
            .lights
            .iter()
            .map(|light| light.name.as_str())
            .collect();
        assert_eq!((names, many.dark), (vec!["flat", "slope", "waves"], 2));
        let alone = Subject {
            measures: judge,
            values: lamps()[2].values.clone(),
            under: None,
            spikes,
            profile: None,
        };
        let progress = Progress::default();
        let alone = Sweep::of(&alone, 30, Basis::Cosine, false, &progress).expect("a sweep");
        assert_eq!(many.lights[2].points, alone.points);
        progress.cancel();
        let lamps = lamps();
        assert!(ManyLights::of(&measures(), spikes, &lamps, 3, &progress).is_none());
        assert!(
            ManyLights::of(&measures(), spikes, &lamps[3..], 3, &Progress::default()).is_none()
        );
    }

    #[test]
    fn an_order_is_enough_when_no_higher_one_is_worse_than_the_limit() {
        let many = ManyLights::of(
            &measures(),
            SpikeSettings::default(),
            &lamps(),
            60,
            &Progress::default(),
        )
        .expect("lights");
        let (measure, limit) = (Measure::RmsBlurred, 0.01);
        let flat = many.lights[0].enough(WAY, measure, limit).expect("flat");
        assert_eq!(flat.order, 0);
        let waves = many.lights[2].enough(WAY, measure, limit).expect("enough");
        assert!(waves.order > 5, "{}", waves.order);
        let off = |order: usize| {
            many.lights[2]
                .of_way(WAY)
                .nth(order)
                .expect("there")
                .verdict
        };
        assert!(off(waves.order - 1)[measure].expect("a figure") > limit);
        for order in waves.order..=60 {
            assert!(off(order)[measure].expect("a figure") <= limit);
        }
        let counts = many.counts(WAY, measure, limit);
        assert!(counts.is_sorted());
        assert_eq!((counts[0], counts[60]), (1, 3));
        assert_eq!(
            many.order_for(WAY, measure, limit, 1.0),
            Some((waves.order, 3))
        );
        let two = many
            .order_for(WAY, measure, limit, 2.0 / 3.0)
            .expect("two of three");
        assert!(two.0 < waves.order && two.1 == 2, "{two:?}");
        assert_eq!(many.order_for(WAY, measure, 0.0, 1.0), None);
    }
}
