//! Examples of what can be done with measurements: readings of a light as an instrument makes them,
//! the same ones every time.

use super::{Part, Verb, said};
use crate::{
    app::{Entry, readings::Reading, ticks::short},
    measurements::{Kernel, Measurement, Quantity, Slit, normal, smoothed},
    spectrum::{Outside, Sampled},
};

/// Wavelengths of a reading, nm.
const NM: std::ops::RangeInclusive<i32> = 380..=780;

/// Noise of a sample, a share of the largest value.
const NOISE: f64 = 0.0005;

/// What the level of a scan is known to, a share, and its wavelengths, nm.
const LEVEL: f64 = 0.01;
const AXIS_NM: f64 = 0.05;

/// Scans of a set.
const SCANS: usize = 5;

/// The largest value of a reading, W/(m² nm), and of one in counts.
const TOP: f64 = 0.01;
const TOP_COUNTS: f64 = 40_000.0;

/// Counts without light.
const DARK_COUNTS: f64 = 1200.0;

/// Where two ranges of one light end and begin, nm, and what the second reads more, a share.
const RANGES_NM: [f64; 2] = [610.0, 560.0];
const SECOND_RANGE: f64 = 0.06;

/// By how much the second set of scans is warmer: it falls by this share at the blue end.
const WARMER: f64 = 0.1;

/// The slit that is taken off.
const SLIT: Slit = Slit {
    shape: Kernel::Gauss,
    fwhm_nm: 7.0,
};

/// What examples are made of.
pub struct Drawn<'a> {
    pub light: &'a Entry,
    /// A second light, that is added or stands in the background.
    pub other: &'a Entry,
    /// A filter, the sample of quotients.
    pub filter: &'a Entry,
}

/// What an instrument reads, drawn from a seed.
struct Reader {
    noise: Box<dyn Iterator<Item = f64>>,
}

impl Reader {
    fn next(&mut self) -> f64 {
        self.noise.next().unwrap_or(0.0)
    }

    /// A reading of values over nm: level, axis and noise are this reading's own.
    fn scan(&mut self, name: &str, value: impl Fn(f64) -> f64) -> Result<Part, String> {
        let by = 1.0 + LEVEL * self.next();
        let shift = AXIS_NM * self.next();
        let values = NM.map(|nm| by * value(f64::from(nm) - shift)).collect();
        self.noisy(name, "W/(m\u{b2} nm)", Quantity::Light, TOP, values)
    }

    /// A reading in counts, whole numbers.
    fn counts(&mut self, name: &str, value: impl Fn(f64) -> f64) -> Result<Part, String> {
        let values = NM.map(|nm| value(f64::from(nm))).collect();
        let mut part = self.noisy(name, "counts", Quantity::Counts, TOP_COUNTS, values)?;
        let whole = part.of.samples.values().iter().map(|v| v.round()).collect();
        part.of.samples = part
            .of
            .samples
            .sharing(whole)
            .map_err(|(why, _)| said(why))?;
        Ok(part)
    }

    fn noisy(
        &mut self,
        name: &str,
        unit: &str,
        quantity: Quantity,
        top: f64,
        mut values: Vec<f64>,
    ) -> Result<Part, String> {
        for value in &mut values {
            *value += NOISE * top * self.next();
        }
        let samples = Sampled::even(f64::from(*NM.start()), 1.0, values).map_err(said)?;
        Ok(Part {
            of: Measurement::new(name, quantity, unit, samples),
            reading: Reading::default(),
            composite: None,
        })
    }
}

/// Two sets of readings to try a verb on; the second is empty but for a comparison of sets.
///
/// # Errors
/// A sentence for a light that cannot be read.
pub fn example(verb: Verb, of: &Drawn<'_>) -> Result<[Vec<Part>; 2], String> {
    let mut reader = Reader {
        noise: Box::new(normal(verb as u64 + 1)),
    };
    let light = at_peak(of.light)?;
    let other = at_peak(of.other)?;
    let through = |nm: f64| of.filter.spectrum.samples.at(nm, Outside::Hold);
    let glow = |nm: f64| TOP * light.at(nm, Outside::Zero);
    let back = |nm: f64| 0.2 * TOP * other.at(nm, Outside::Zero);
    let counted = |nm: f64| 0.95 * TOP_COUNTS * light.at(nm, Outside::Zero) * response(nm);
    let [name, other_name, filter] = [of.light, of.other, of.filter].map(Entry::name);
    let behind = tr!("{name} behind {filter}", name, filter);
    let mut set = |warmer: f64| -> Result<Vec<Part>, String> {
        let value = |nm: f64| glow(nm) * (1.0 - warmer * (780.0 - nm) / 400.0);
        let scan_name = |number: usize| match warmer > 0.0 {
            true => tr!("{name}, later {number}", name, number),
            false => tr!("{name}, scan {number}", name, number),
        };
        let scans = 1..=SCANS;
        scans
            .map(|number| reader.scan(&scan_name(number), value))
            .collect()
    };
    let first = match verb {
        Verb::Mean => set(0.0)?,
        Verb::Changed => return Ok([set(0.0)?, set(WARMER)?]),
        Verb::Difference => vec![
            reader.scan(&tr!("{name} in a lit room", name), |nm| glow(nm) + back(nm))?,
            reader.scan(said!("the room"), back)?,
        ],
        Verb::Sum => vec![reader.scan(name, glow)?, reader.scan(other_name, back)?],
        Verb::Quotient | Verb::Absorbance => vec![
            reader.scan(&behind, |nm| glow(nm) * through(nm))?,
            reader.scan(name, glow)?,
        ],
        Verb::QuotientLessDark => vec![
            reader.counts(&behind, |nm| DARK_COUNTS + counted(nm) * through(nm))?,
            reader.counts(name, |nm| DARK_COUNTS + counted(nm))?,
            reader.counts(said!("dark"), |_| DARK_COUNTS)?,
        ],
        Verb::Corrected => vec![reader.counts(name, counted)?],
        Verb::Learnt => {
            let bulb = |nm: f64| 0.95 * TOP_COUNTS * other.at(nm, Outside::Zero) * response(nm);
            vec![reader.counts(&tr!("{other_name}, counted", other_name), bulb)?]
        }
        Verb::Splice => {
            let [end, start] = RANGES_NM;
            let second = |nm: f64| (1.0 + SECOND_RANGE) * glow(nm);
            vec![
                cut(reader.scan(&tr!("{name}, blue", name), glow)?, 0.0, end)?,
                cut(reader.scan(&tr!("{name}, red", name), second)?, start, 1e9)?,
            ]
        }
        Verb::Slit => vec![reader.scan(name, glow)?],
        Verb::Unslit => {
            let seen = Measurement::new(name, Quantity::Light, "", light.clone());
            let seen = smoothed(&seen, SLIT).map_err(said)?.samples;
            let name = tr!(
                "{name} through {width} nm",
                name,
                width = short(SLIT.fwhm_nm)
            );
            vec![reader.scan(&name, |nm| TOP * seen.at(nm, Outside::Hold))?]
        }
    };
    Ok([first, Vec::new()])
}

/// A light with its largest value at 1.
fn at_peak(entry: &Entry) -> Result<Sampled, String> {
    let samples = &entry.spectrum.samples;
    let values: Vec<f64> = NM
        .map(|nm| samples.at(f64::from(nm), Outside::Zero))
        .collect();
    let top = values.iter().copied().fold(0.0, f64::max);
    if top <= 0.0 {
        return Err(tr!(
            "{light} does not shine from 380 to 780 nm.",
            light = entry.name()
        ));
    }
    let values = values.into_iter().map(|value| value / top).collect();
    Sampled::even(f64::from(*NM.start()), 1.0, values).map_err(said)
}

/// The response of an instrument whose detector is best in the green, 1 at most.
fn response(nm: f64) -> f64 {
    (-((nm - 540.0) / 160.0).powi(2)).exp()
}

/// A reading without what lies outside a range.
fn cut(mut part: Part, from_nm: f64, to_nm: f64) -> Result<Part, String> {
    let samples = &part.of.samples;
    let pairs = samples.nm().iter().zip(samples.values());
    let kept = pairs.filter(|(nm, _)| (from_nm..=to_nm).contains(*nm));
    let (nm, values) = kept.map(|(nm, value)| (*nm, *value)).unzip();
    part.of.samples = Sampled::new(nm, values).map_err(said)?;
    Ok(part)
}
