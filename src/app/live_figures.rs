//! Figures of the frames of a stream: no others than are asked for, since they come a hundred times a
//! second.

use super::{
    figures::{Figure, OF_QUALITY, QualityFigure, Unit},
    measured::spectrum,
    numbers::{fixed, significant},
    quality_report::light_of,
    readings::COUNTS,
};
use crate::{
    color::quality::{Figures, Parts},
    languages::said,
    live::{Shown, sums},
    measurements::Quantity,
};

/// The meaning of Y of a stream.
pub const SUM_MEANS: &str =
    later!("Sum with the luminosity function, in the unit of the values x nm.");

/// The brightness, which only a stream has: elsewhere the light's Y is 100.
static SUM: Figure = Figure {
    key: "Y",
    title: "Y",
    short: "Y",
    unit: Unit::NONE,
    digits: 3,
    signed: false,
    meaning: SUM_MEANS,
    said: "",
    goal: "",
};

/// A figure that is asked for.
#[derive(Clone, Copy, Debug)]
pub enum Wanted {
    /// The sum with the luminosity function.
    Sum,
    /// A figure of light quality.
    Of(&'static QualityFigure),
}

/// A figure of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    pub figure: &'static Figure,
    /// The number, or why there is none.
    pub value: Result<f64, String>,
}

impl Wanted {
    /// Every figure that a stream has.
    fn all() -> impl Iterator<Item = Self> {
        let of_quality = OF_QUALITY.iter().filter(|row| !row.figure.key.is_empty());
        std::iter::once(Self::Sum).chain(of_quality.map(Self::Of))
    }

    /// A figure by its key.
    ///
    /// # Errors
    /// The keys that there are.
    pub fn named(key: &str) -> Result<Self, String> {
        let key = key.trim();
        let found = Self::all().find(|wanted| wanted.figure().key == key);
        found.ok_or_else(|| {
            let keys: Vec<&str> = Self::all().map(|wanted| wanted.figure().key).collect();
            format!(
                "found the figure {key}, expected one of {}",
                keys.join(", ")
            )
        })
    }

    pub fn figure(self) -> &'static Figure {
        match self {
            Self::Sum => &SUM,
            Self::Of(row) => &row.figure,
        }
    }

    /// Adds what it needs to the parts that are computed.
    fn add_to(self, parts: &mut Parts) {
        let key = self.figure().key;
        let is_sample = |rest: &str| rest.parse::<u8>().is_ok();
        match key {
            "Y" | "x" | "y" | "u_prime" | "v_prime" | "cct" | "duv" => {}
            "ra" => parts.rendering = true,
            "rf" | "rg" => parts.fidelity = true,
            key if key.strip_prefix('r').is_some_and(is_sample) => parts.rendering = true,
            _ => parts.others = true,
        }
    }
}

/// The figures of what is shown, in the order asked for; none of what is no light.
pub fn figures(shown: &Shown, wanted: &[Wanted]) -> Vec<Told> {
    let mut parts = Parts::default();
    wanted.iter().for_each(|wanted| wanted.add_to(&mut parts));
    let light = match shown.of.quantity {
        Quantity::Light => Ok(spectrum(&shown.of, "")),
        Quantity::Counts => Err(said(COUNTS).to_owned()),
        other => Err(tr!("{quantity} is no light", quantity = other)),
    };
    let light = light.map(|spectrum| {
        let (light, measured) = light_of(&spectrum);
        let figures = Figures::of_parts(&light, measured, parts);
        (spectrum, figures)
    });
    let value = |wanted: &Wanted| -> Result<f64, String> {
        let (spectrum, figures) = light.as_ref().map_err(Clone::clone)?;
        match wanted {
            Wanted::Sum => Ok(sums(&spectrum.samples).y),
            Wanted::Of(row) if (row.applies)(figures) => {
                row.value(figures).map_err(|why| why.to_string())
            }
            Wanted::Of(_) => {
                Err(said!("the unit of the values is that of another quantity").to_owned())
            }
        }
    };
    let told = |wanted: &Wanted| Told {
        figure: wanted.figure(),
        value: value(wanted).and_then(|value| match value.is_finite() {
            true => Ok(value),
            false => Err(said!("it is beyond all numbers").to_owned()),
        }),
    };
    wanted.iter().map(told).collect()
}

impl Told {
    /// In a line of words: `CCT 2856 K`.
    pub fn words(&self) -> String {
        format!("{} {}", self.name(), self.number())
    }

    /// The figure in a word or two.
    pub fn name(&self) -> &'static str {
        match self.figure.title() {
            "" => self.figure.key,
            title => title,
        }
    }

    /// The number with its unit, a dash where there is none.
    pub fn number(&self) -> String {
        match self.value {
            Ok(value) if self.figure.key == SUM.key => three_digits(value),
            Ok(value) => self.figure.written(value),
            Err(_) => super::numbers::DASH.to_owned(),
        }
    }
}

/// Three digits, noughts kept where they fit: a number that flickers must not change its length.
fn three_digits(value: f64) -> String {
    match value.abs() {
        size if (0.01..1000.0).contains(&size) => {
            fixed(value, (2.0 - size.log10().floor()) as usize)
        }
        _ => significant(value, 3),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{
        document::first_light, entry::bundled_entries, measured::measurement, quality_report::rows,
    };

    #[test]
    fn every_figure_is_that_of_a_report_however_few_are_asked_for() {
        let entry = first_light(bundled_entries());
        let shown = |factor: f64| Shown {
            of: {
                let mut of = measurement(&entry.spectrum, None).expect("a light");
                of.samples = of.samples.scaled(factor);
                of
            },
            time_ms: 0.0,
            frames: 1,
            clipped: Vec::new(),
            counts: None,
        };
        let (light, measured) = light_of(&entry.spectrum);
        let report = rows(&Figures::of(&light, measured));
        assert!(report.len() > 30, "{}", report.len());
        for row in report {
            let wanted = Wanted::named(row.figure.key).expect("a key");
            let alone = figures(&shown(1.0), &[wanted]).remove(0);
            assert_eq!((alone.figure, alone.value), (row.figure, row.value));
        }
        let y = |factor: f64| figures(&shown(factor), &[Wanted::Sum]).remove(0).value;
        assert_eq!(y(2.0), y(1.0).map(|y| 2.0 * y));
        assert_eq!(
            [61.0, 58.94, 0.5, 7.0, 612.0, 1234.0].map(three_digits),
            ["61.0", "58.9", "0.500", "7.00", "612", "1230"]
        );
        // Each key is of one figure.
        let mut keys: Vec<&str> = Wanted::all().map(|wanted| wanted.figure().key).collect();
        let count = keys.len();
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), count);
    }
}
