//! Live work: which spectrum of a stream is shown, and what is taken off it.

use std::{collections::VecDeque, sync::LazyLock};

use super::words::clock;
use crate::{
    languages::with_sign,
    measurements::{
        CountsSign, Formula, Instrument, Measurement, MeasurementError, Options, Quantity, combine,
        counts_sign, flat_tops, noise_of, quantity_of,
    },
    spectrum::{NamedSpectrum, Sampled},
    streams::Frame,
};

/// Most frames that are averaged.
pub const MOST_AVERAGED: usize = 64;

/// Arrivals that the rate is told by.
const RATED: usize = 33;

/// Ends of the scales of converters beyond 8 bit: a whole number at one of them is clipped.
const ENDS_OF_SCALES: [f64; 6] = [1023.0, 4095.0, 8191.0, 16_383.0, 32_767.0, 65_535.0];

/// A spectrum of the stream that others are compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// What the instrument tells without light: taken off.
    Dark,
    /// The light without a sample: divided by.
    Light,
}

/// The spectrum that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    pub of: Measurement,
    /// Time of the newest frame in it, ms.
    pub time_ms: f64,
    /// Frames that it is the mean of.
    pub frames: usize,
    /// Stretches in which the newest frame is clipped, nm; of one column both ends are its own.
    pub clipped: Vec<[f64; 2]>,
    /// Why the values are counts, where they are.
    pub counts: Option<CountsSign>,
}

/// What a person has of a stream.
pub struct Live {
    as_light: bool,
    instrument: Option<Instrument>,
    /// The newest, all alike, the newest last.
    frames: VecDeque<Frame>,
    /// Frames since the last that must not be averaged with them.
    alike: usize,
    average: usize,
    dark: Option<Measurement>,
    light: Option<Measurement>,
    peak: Option<Option<Sampled>>,
    held: Option<Shown>,
    counts: Option<CountsSign>,
    /// Times at which frames came, s.
    arrivals: VecDeque<f64>,
    count: u64,
}

impl Live {
    /// A stream whose counts are taken as a light where `as_light` says so, read through an
    /// instrument where there is one.
    pub fn new(instrument: Option<Instrument>, as_light: bool) -> Self {
        Self {
            as_light,
            instrument,
            frames: VecDeque::new(),
            alike: 0,
            average: 1,
            dark: None,
            light: None,
            peak: None,
            held: None,
            counts: None,
            arrivals: VecDeque::new(),
            count: 0,
        }
    }

    /// Takes a frame that came at a time, s, on the clock of whoever asks; says what it puts an end
    /// to.
    pub fn push(&mut self, frame: Frame, now_s: f64) -> Option<String> {
        self.count += 1;
        self.arrivals.push_back(now_s);
        if self.arrivals.len() > RATED {
            self.arrivals.pop_front();
        }
        let mut said = None;
        if let Some(last) = self.frames.back().filter(|last| !last.is_like(&frame)) {
            said = self.changes(last, &frame);
            if said.is_some() {
                (self.dark, self.light) = (None, None);
            }
            self.frames.clear();
            self.alike = 0;
            self.counts = None;
            self.peak = self.peak.take().map(|_| None);
        }
        if let Some(peak) = &mut self.peak {
            *peak = Some(match peak.take() {
                Some(peak) => highest(&peak, &frame.samples),
                None => frame.samples.clone(),
            });
        }
        // A stream of counts stays one when it gets dim.
        self.counts = self.counts.take().or_else(|| counts_sign(&named(&frame)));
        self.frames.push_back(frame);
        self.alike += 1;
        if self.frames.len() > MOST_AVERAGED {
            self.frames.pop_front();
        }
        said
    }

    /// What a frame unlike the last one puts an end to.
    fn changes(&self, last: &Frame, frame: &Frame) -> Option<String> {
        let ms = |ms: Option<f64>| match ms {
            None => said!("unknown").to_owned(),
            Some(ms) => format!("{} ms", with_sign(ms.to_string())),
        };
        let is_same = last.integration_ms == frame.integration_ms;
        let [was, is] = [last.integration_ms, frame.integration_ms].map(ms);
        Some(match (&self.dark, &self.light, is_same) {
            (None, None, _) => return None,
            (Some(_), None, false) => tr!(
                "Dark dropped: the integration time changed from {was} to {is}.",
                was,
                is
            ),
            (None, Some(_), false) => tr!(
                "Reference dropped: the integration time changed from {was} to {is}.",
                was,
                is
            ),
            (Some(_), Some(_), false) => tr!(
                "Dark and reference dropped: the integration time changed from {was} to {is}.",
                was,
                is
            ),
            (Some(_), None, true) => said!("Dark dropped: wavelengths or unit changed.").to_owned(),
            (None, Some(_), true) => {
                said!("Reference dropped: wavelengths or unit changed.").to_owned()
            }
            (Some(_), Some(_), true) => {
                said!("Dark and reference dropped: wavelengths or unit changed.").to_owned()
            }
        })
    }

    /// Frames so far.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Averages the last `frames` true frames, 1 to [`MOST_AVERAGED`].
    pub fn average_over(&mut self, frames: usize) {
        self.average = frames.clamp(1, MOST_AVERAGED);
    }

    /// Holds what is shown, or goes on.
    ///
    /// # Errors
    /// As [`Self::shown`]; then nothing is held.
    pub fn hold(&mut self, holds: bool) -> Result<(), MeasurementError> {
        self.held = None;
        if holds {
            self.held = self.shown()?;
        }
        Ok(())
    }

    pub fn is_held(&self) -> bool {
        self.held.is_some()
    }

    /// Takes the mean of the last frames as dark or reference; false where there are none.
    pub fn take(&mut self, which: Reference) -> bool {
        let taken = self.mean().and_then(Result::ok);
        let has_taken = taken.is_some();
        match which {
            Reference::Dark => self.dark = taken,
            Reference::Light => self.light = taken,
        }
        // What comes next is of something else.
        self.alike = 0;
        has_taken
    }

    /// True while dark or reference are taken into account.
    pub fn has(&self, which: Reference) -> bool {
        match which {
            Reference::Dark => self.dark.is_some(),
            Reference::Light => self.light.is_some(),
        }
    }

    /// Takes counts as a light from now on, or no longer.
    pub fn take_as_light(&mut self, as_light: bool) {
        self.as_light = as_light;
    }

    /// Goes on without dark or reference.
    pub fn drop(&mut self, which: Reference) {
        match which {
            Reference::Dark => self.dark = None,
            Reference::Light => self.light = None,
        }
    }

    /// Keeps the highest value of every column from now on, or no longer.
    pub fn hold_peak(&mut self, holds: bool) {
        self.peak = holds.then_some(None);
    }

    /// True while the highest values are kept.
    pub fn holds_peak(&self) -> bool {
        self.peak.is_some()
    }

    /// The highest values so far; `None` where none are held.
    ///
    /// # Errors
    /// As [`Self::shown`].
    pub fn peak(&self) -> Result<Option<Measurement>, MeasurementError> {
        let (Some(Some(peak)), Some(frame)) = (&self.peak, self.frames.back()) else {
            return Ok(None);
        };
        self.corrected(self.measurement(frame, peak.clone())?)
            .map(Some)
    }

    /// The spectrum that is shown: what is held, else the mean of the last frames without dark,
    /// over the reference or through the instrument. `None` before the first frame.
    ///
    /// # Errors
    /// A sentence where dark, reference or instrument do not fit.
    pub fn shown(&self) -> Result<Option<Shown>, MeasurementError> {
        match &self.held {
            Some(held) => Ok(Some(held.clone())),
            None => self.newest(),
        }
    }

    /// The same, whatever is held.
    ///
    /// # Errors
    /// As [`Self::shown`].
    pub fn newest(&self) -> Result<Option<Shown>, MeasurementError> {
        let (Some(frame), Some(mean)) = (self.frames.back(), self.mean()) else {
            return Ok(None);
        };
        Ok(Some(Shown {
            of: self.corrected(mean?)?,
            time_ms: frame.time_ms,
            frames: self.averaged(),
            clipped: clipped(&self.measurement(frame, frame.samples.clone())?),
            counts: self.counts.clone(),
        }))
    }

    /// What is shown, to be kept: its time stands in its name.
    ///
    /// # Errors
    /// As [`Self::shown`].
    pub fn capture(&self) -> Result<Option<Measurement>, MeasurementError> {
        Ok(self.shown()?.map(|shown| Measurement {
            name: tr!(
                "{name} at {time}",
                name = shown.of.name,
                time = clock(shown.time_ms)
            ),
            ..shown.of
        }))
    }

    /// Frames a second; `None` before the second one.
    pub fn rate(&self) -> Option<f64> {
        let (first, last) = (self.arrivals.front()?, self.arrivals.back()?);
        let spans = self.arrivals.len() - 1;
        (last > first).then(|| spans as f64 / (last - first))
    }

    /// Time since the last frame, s.
    pub fn age(&self, now_s: f64) -> Option<f64> {
        self.arrivals.back().map(|last| (now_s - last).max(0.0))
    }

    /// How many frames the mean is of.
    fn averaged(&self) -> usize {
        self.average.min(self.frames.len()).min(self.alike.max(1))
    }

    /// The mean of the last frames as they came.
    fn mean(&self) -> Option<Result<Measurement, MeasurementError>> {
        let newest = self.frames.back()?;
        let count = self.averaged();
        let mut sum = vec![0.0; newest.samples.len()];
        for frame in self.frames.iter().rev().take(count) {
            let values = frame.samples.values().iter();
            sum.iter_mut().zip(values).for_each(|(sum, v)| *sum += v);
        }
        sum.iter_mut().for_each(|sum| *sum /= count as f64);
        Some(match newest.samples.sharing(sum) {
            Ok(samples) => self.measurement(newest, samples),
            Err((why, _)) => Err(why.into()),
        })
    }

    /// The measurement that values of a frame's kind are.
    fn measurement(
        &self,
        frame: &Frame,
        samples: Sampled,
    ) -> Result<Measurement, MeasurementError> {
        let quantity = match quantity_of(&frame.name, frame.kind, &frame.unit)? {
            Quantity::Light if self.counts.is_some() && !self.as_light => Quantity::Counts,
            Quantity::Counts if self.as_light => Quantity::Light,
            quantity => quantity,
        };
        let mut found = Measurement::new(&frame.name, quantity, &frame.unit, samples);
        found.exposure_ms = frame.integration_ms;
        Ok(found)
    }

    fn corrected(&self, of: Measurement) -> Result<Measurement, MeasurementError> {
        static WITHOUT_DARK: LazyLock<Option<Formula>> =
            LazyLock::new(|| Formula::parse("A - B").ok());
        static OVER: LazyLock<Option<Formula>> = LazyLock::new(|| Formula::parse("A / B").ok());
        static BOTH: LazyLock<Option<Formula>> =
            LazyLock::new(|| Formula::parse("(A - C) / (B - C)").ok());
        let (formula, others) = match (&self.light, &self.dark) {
            (None, None) => return self.through_the_instrument(of),
            (None, Some(dark)) => (&WITHOUT_DARK, vec![dark]),
            (Some(light), None) => (&OVER, vec![light]),
            (Some(light), Some(dark)) => (&BOTH, vec![light, dark]),
        };
        let Some(formula) = &**formula else {
            return Ok(of);
        };
        let name = of.name.clone();
        let parts = std::iter::once(of).chain(others.into_iter().cloned());
        let with_noise = |part: Measurement| Measurement {
            sigma: noise_of(&part.samples),
            ..part
        };
        let parts: Vec<Measurement> = parts.map(with_noise).collect();
        let made = combine(formula, &parts, Options::default())?.result;
        let made = Measurement { name, ..made };
        match self.light {
            // A quotient has no response left in it.
            Some(_) => Ok(made),
            None => self.through_the_instrument(made),
        }
    }

    fn through_the_instrument(&self, of: Measurement) -> Result<Measurement, MeasurementError> {
        match &self.instrument {
            None => Ok(of),
            // Values that told no wavelengths stand on the instrument's own, which are right.
            Some(own) if own.factor.samples.nm() == of.samples.nm() => {
                let own = Instrument {
                    axis: None,
                    ..own.clone()
                };
                own.corrected(&of)
            }
            Some(own) => own.corrected(&of),
        }
    }
}

fn named(frame: &Frame) -> NamedSpectrum {
    NamedSpectrum {
        name: frame.name.clone(),
        kind: frame.kind,
        unit: frame.unit.clone(),
        scale: 1.0,
        samples: frame.samples.clone(),
        notes: Vec::new(),
        source: String::new(),
    }
}

/// Column by column the higher value of two tables of one grid.
fn highest(one: &Sampled, other: &Sampled) -> Sampled {
    let both = one.values().iter().zip(other.values());
    let values = both.map(|(a, b)| a.max(*b)).collect();
    one.sharing(values).unwrap_or_else(|_| one.clone())
}

/// Where a frame as it came is clipped: its flat tops, and whole numbers at the end of a scale.
fn clipped(of: &Measurement) -> Vec<[f64; 2]> {
    let tops = flat_tops(of).into_iter();
    let mut found: Vec<[f64; 2]> = tops.map(|top| [top.from_nm, top.to_nm]).collect();
    let (nm, values) = (of.samples.nm(), of.samples.values());
    let top = values.iter().copied().fold(0.0, f64::max);
    if ENDS_OF_SCALES.contains(&top) && values.iter().all(|value| value.fract() == 0.0) {
        // Columns side by side are one stretch, which takes in the flat tops.
        found.clear();
        for at in (0..nm.len()).filter(|i| values[*i] == top) {
            match found.last_mut().filter(|_| at > 0 && values[at - 1] == top) {
                Some([_, to]) => *to = nm[at],
                None => found.push([nm[at]; 2]),
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{measurements::normal, spectrum::Kind};

    const POINTS: usize = 401;

    fn frame(time_ms: f64, integration_ms: f64, values: Vec<f64>) -> Frame {
        Frame {
            time_ms,
            name: "lamp".to_owned(),
            kind: Kind::Light,
            samples: Sampled::even(380.0, 1.0, values).expect("finite"),
            integration_ms: Some(integration_ms),
            unit: "W m-2 nm-1".to_owned(),
            instrument: String::new(),
        }
    }

    fn flat(value: f64) -> Vec<f64> {
        (0..POINTS)
            .map(|i| value * (1.0 + 0.001 * i as f64))
            .collect()
    }

    fn values(live: &Live) -> Vec<f64> {
        let shown = live.shown().expect("sound").expect("a frame");
        shown.of.samples.values().to_vec()
    }

    #[test]
    fn the_average_of_sixteen_frames_has_a_quarter_of_the_noise() {
        let mut draws = normal(7);
        let mut noisy = || -> Vec<f64> {
            let noise = draws.by_ref().take(POINTS);
            noise.zip(flat(1.0)).map(|(e, v)| v + 0.01 * e).collect()
        };
        let mut live = Live::new(None, false);
        let noise = |live: &Live| {
            let off = values(live).into_iter().zip(flat(1.0));
            let squares: f64 = off.map(|(v, exact)| (v - exact).powi(2)).sum();
            squares / POINTS as f64
        };
        let mut sums = [0.0; 2];
        for index in 0..160 {
            live.push(frame(f64::from(index), 10.0, noisy()), 0.0);
            live.average_over(1);
            sums[0] += noise(&live);
            live.average_over(16);
            if index % 16 == 15 {
                assert_eq!(live.shown().unwrap().unwrap().frames, 16);
                sums[1] += 16.0 * noise(&live);
            }
        }
        let ratio = (sums[0] / sums[1]).sqrt();
        // 4010 samples tell the smaller noise to 1.1 %.
        assert!((ratio - 4.0).abs() < 0.4, "{ratio}");
    }

    #[test]
    fn what_is_held_stays_while_frames_go_on() {
        let mut live = Live::new(None, false);
        assert_eq!(live.shown(), Ok(None));
        live.push(frame(0.0, 10.0, flat(1.0)), 0.0);
        live.hold(true).expect("held");
        live.push(frame(83_000.0, 10.0, flat(2.0)), 1.0);
        assert_eq!(values(&live), flat(1.0));
        assert_eq!(live.capture().unwrap().unwrap().name, "lamp at 0:00:00.0");
        live.hold(false).expect("sound");
        assert_eq!(values(&live), flat(2.0));
        assert_eq!(live.capture().unwrap().unwrap().name, "lamp at 0:01:23.0");
        assert_eq!(
            (live.count(), live.rate(), live.age(4.0)),
            (2, Some(1.0), Some(3.0))
        );
    }

    #[test]
    fn dark_and_reference_are_taken_from_the_stream_and_dropped_with_another_exposure() {
        let mut live = Live::new(None, false);
        let push =
            |live: &mut Live, ms: f64, value: f64| live.push(frame(0.0, ms, flat(value)), 0.0);
        push(&mut live, 10.0, 1.0);
        assert!(live.take(Reference::Dark));
        // The dark is not averaged with what follows.
        live.average_over(2);
        push(&mut live, 10.0, 5.0);
        // A difference of two numbers of size 5.
        for (found, exact) in values(&live).iter().zip(flat(4.0)) {
            assert!((found - exact).abs() < 1e-14, "{found} {exact}");
        }
        assert!(live.take(Reference::Light));
        push(&mut live, 10.0, 3.0);
        let shown = live.shown().unwrap().unwrap();
        assert_eq!(
            (shown.of.quantity, shown.frames),
            (Quantity::Transmittance, 1)
        );
        let found = shown.of.samples.values();
        assert!(found.iter().all(|t| (t - 0.5).abs() < 1e-12));
        let said = push(&mut live, 30.0, 3.0).expect("said");
        assert_eq!(
            said,
            "Dark and reference dropped: the integration time changed from 10 ms to 30 ms."
        );
        assert_eq!(values(&live), flat(3.0));
        assert_eq!(push(&mut live, 10.0, 3.0), None);
    }

    #[test]
    fn peaks_are_the_highest_values_of_every_column() {
        let mut live = Live::new(None, false);
        live.hold_peak(true);
        for at in [10, 20, 30] {
            let mut values = flat(1.0);
            values[at] = 7.0;
            live.push(frame(0.0, 10.0, values), 0.0);
        }
        let peak = live.peak().unwrap().expect("held");
        for (i, value) in peak.samples.values().iter().enumerate() {
            let exact = if [10, 20, 30].contains(&i) {
                7.0
            } else {
                flat(1.0)[i]
            };
            assert_eq!(*value, exact);
        }
        live.hold_peak(false);
        assert_eq!(live.peak(), Ok(None));
    }

    #[test]
    fn counts_stay_counts_when_they_get_dim_and_clipped_columns_are_told() {
        let counts = |top: f64| Frame {
            unit: String::new(),
            ..frame(0.0, 10.0, flat(top).into_iter().map(f64::floor).collect())
        };
        let mut live = Live::new(None, false);
        live.push(counts(40_000.0), 0.0);
        live.push(counts(100.0), 0.0);
        let shown = live.shown().unwrap().unwrap();
        assert_eq!(shown.of.quantity, Quantity::Counts);
        assert!(shown.counts.is_some() && shown.clipped.is_empty());
        let mut full = counts(40_000.0);
        let mut values = full.samples.values().to_vec();
        values[100] = 65_535.0;
        full.samples = full.samples.sharing(values).expect("finite");
        live.push(full, 0.0);
        assert_eq!(live.shown().unwrap().unwrap().clipped, [[480.0, 480.0]]);
        let mut as_light = Live::new(None, true);
        as_light.push(counts(40_000.0), 0.0);
        let shown = as_light.shown().unwrap().unwrap();
        assert_eq!(shown.of.quantity, Quantity::Light);
    }
}
