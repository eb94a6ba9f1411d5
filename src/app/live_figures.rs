//! Figures of the frames of a stream: those that are asked for and no others, since they come a
//! hundred times a second.

use std::cell::OnceCell;

use super::{
    figures::three_digits,
    measured::spectrum,
    quality_report::{Row, known, light_of, rows},
    readings::COUNTS,
};
use crate::{
    color::{
        Cct,
        quality::{
            Fidelity, Figures, Light, Measured, NoFigure, Rendering, cct, fidelity, rendering,
        },
    },
    live::{Shown, sums},
    measurements::Quantity,
};

/// The brightness, which a stream has beside the figures of light quality.
static Y: Row = Row {
    key: "y",
    title: "Y",
    unit: "",
    digits: 3,
    method: "sum with the luminosity function, in the unit of the values x nm",
    value: Ok(0.0),
    reading: String::new(),
};

/// Every figure that a stream has.
fn all() -> impl Iterator<Item = &'static Row> {
    std::iter::once(&Y).chain(known())
}

/// A figure by its key.
///
/// # Errors
/// The keys that there are.
pub fn named(key: &str) -> Result<&'static Row, String> {
    let found = all().find(|row| row.key == key.trim());
    found.ok_or_else(|| {
        let keys: Vec<&str> = all().map(|row| row.key).collect();
        format!(
            "found the figure {key}, expected one of {}",
            keys.join(", ")
        )
    })
}

/// A light with what figures share, each computed once it is asked for.
struct Computed {
    light: Light,
    measured: Option<Measured>,
    cct: OnceCell<Result<Cct, NoFigure>>,
    rendering: OnceCell<Result<Rendering, NoFigure>>,
    fidelity: OnceCell<Result<Fidelity, NoFigure>>,
    all: OnceCell<Vec<Row>>,
}

impl Computed {
    fn cct(&self) -> Result<Cct, NoFigure> {
        self.cct.get_or_init(|| cct(&self.light)).clone()
    }

    fn of_rendering(&self, of: impl Fn(&Rendering) -> f64) -> Result<f64, NoFigure> {
        let found = self
            .rendering
            .get_or_init(|| rendering(&self.light, self.cct()?));
        found.as_ref().map(of).map_err(Clone::clone)
    }

    fn of_fidelity(&self, of: impl Fn(&Fidelity) -> f64) -> Result<f64, NoFigure> {
        let found = self
            .fidelity
            .get_or_init(|| fidelity(&self.light, self.cct()?));
        found.as_ref().map(of).map_err(Clone::clone)
    }

    fn value(&self, key: &str) -> Result<f64, String> {
        let sample = || key.strip_prefix('r')?.parse::<usize>().ok();
        let found = match key {
            "cct" => self.cct().map(|cct| cct.kelvin),
            "duv" => self.cct().map(|cct| cct.duv),
            "ra" => self.of_rendering(|found| found.ra),
            "rf" => self.of_fidelity(|found| found.rf),
            "rg" => self.of_fidelity(|found| found.rg),
            _ => match sample() {
                Some(sample) => self.of_rendering(|found| found.samples[sample - 1].index),
                None => return self.any(key),
            },
        };
        found.map_err(|why| why.to_string())
    }

    fn any(&self, key: &str) -> Result<f64, String> {
        let all = self
            .all
            .get_or_init(|| rows(&Figures::of(&self.light, self.measured)));
        match all.iter().find(|row| row.key == key) {
            Some(row) => row.value.clone(),
            None => Err("the unit of the values has another quantity".to_owned()),
        }
    }
}

/// The figures of what is shown, in the order asked for; none of what is no light.
pub fn figures(shown: &Shown, wanted: &[&'static Row]) -> Vec<Row> {
    let light = match shown.of.quantity {
        Quantity::Light => Ok(spectrum(&shown.of, "")),
        Quantity::Counts => Err(COUNTS.to_owned()),
        other => Err(format!("{other} is no light")),
    };
    let light = light.map(|spectrum| {
        let (light, measured) = light_of(&spectrum);
        let computed = Computed {
            light,
            measured,
            cct: OnceCell::new(),
            rendering: OnceCell::new(),
            fidelity: OnceCell::new(),
            all: OnceCell::new(),
        };
        (spectrum, computed)
    });
    let value = |key: &str| match &light {
        Err(why) => Err(why.clone()),
        Ok((spectrum, _)) if key == Y.key => Ok(sums(&spectrum.samples).y),
        Ok((_, computed)) => computed.value(key),
    };
    let figure = |known: &&'static Row| Row {
        value: value(known.key),
        ..(*known).clone()
    };
    wanted.iter().map(figure).collect()
}

/// A figure in a line of words: `CCT 2856 K`.
pub fn words(figure: &Row) -> String {
    match figure.value {
        Ok(value) if figure.key == Y.key => format!("{} {}", figure.title, three_digits(value)),
        _ => format!("{} {}", figure.title, figure.shown()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{document::first_light, entry::bundled_entries, measured::measurement};

    #[test]
    fn every_figure_is_that_of_a_report_and_no_key_stands_for_two() {
        let entry = first_light(bundled_entries());
        let of = measurement(&entry.spectrum, None).expect("a light");
        let shown = Shown {
            of,
            time_ms: 0.0,
            frames: 1,
            clipped: Vec::new(),
            counts: None,
        };
        let wanted: Vec<&'static Row> = all().collect();
        let light = Light::of_sampled(&entry.spectrum.samples);
        let report = rows(&Figures::of(&light, light_of(&entry.spectrum).1));
        let found = figures(&shown, &wanted);
        assert_eq!(found.len(), report.len() + 1);
        for (found, row) in found[1..].iter().zip(&report) {
            assert_eq!((found.key, &found.value), (row.key, &row.value));
        }
        assert!(found.iter().skip(1).all(|row| row.key != Y.key));
        let brighter = Shown {
            of: measurement(
                &crate::spectrum::NamedSpectrum {
                    samples: entry.spectrum.samples.scaled(2.0),
                    ..entry.spectrum.clone()
                },
                None,
            )
            .expect("a light"),
            ..shown
        };
        let [one, two] = [&found[0], &figures(&brighter, &wanted)[0]].map(|row| row.value.clone());
        assert_eq!(two, one.map(|y| 2.0 * y));
    }
}
