//! Where a model of a light whose noise is known begins to draw that noise.

use super::{document::Document, settings::Settings};
use crate::{
    measurements::{
        MOST_ORDER, Measurement, OF_95, doubts_of_numbers, lines_of_the_noise, order_of_the_noise,
    },
    spectrum::{Band, Basis, SpikeSettings},
};

/// A threshold is so much above the share of a line that it keeps out.
const ABOVE: f64 = 1.02;

/// The last order of a basis that draws a document's light and not its noise; `None` where no noise is
/// known, or none is drawn.
pub fn last_order_in(document: &Document, basis: Basis) -> Option<usize> {
    let of = document.subject_entry().measured.as_deref()?;
    let of = Some(of).filter(|_| document.is_about_light())?;
    last_order_of(of, document.settings.band, basis)
}

/// The same of a light itself.
pub fn last_order_of(of: &Measurement, band: Band, basis: Basis) -> Option<usize> {
    let order = order_of_the_noise(of, band, basis);
    order.filter(|order| *order < MOST_ORDER)
}

/// Half widths of the 95 % intervals of the first numbers of the series of a document's light; none
/// where no noise is known.
pub fn half_widths_of_numbers(document: &Document, numbers: usize) -> Vec<f64> {
    let of = document.subject_entry().measured.as_deref();
    let of = of.filter(|_| document.is_about_light());
    let Settings { band, basis, .. } = document.settings;
    let doubts = of.and_then(|of| doubts_of_numbers(of, band, basis, numbers));
    let doubts = doubts.unwrap_or_default().into_iter();
    doubts.map(|u| OF_95 * u).collect()
}

/// Where the noise begins; nothing of it is known of a light without sigma.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NoiseBegins {
    /// The last order that draws the light: higher ones draw its noise.
    pub order: Option<usize>,
    /// Share of the power, per cent, below which a line may be one of the noise.
    pub percent: Option<f64>,
}

impl NoiseBegins {
    /// Of a document's light, with the lines that a threshold of `lowest_percent` lets in.
    pub fn of(document: &Document, lowest_percent: f64) -> Self {
        let Some(of) = document.subject_entry().measured.as_deref() else {
            return Self::default();
        };
        if of.sigma.is_none() || !document.is_about_light() {
            return Self::default();
        }
        let settings = document.settings;
        let lowest = SpikeSettings {
            threshold: lowest_percent / 100.0,
            ..settings.spike_settings()
        };
        let lines = lines_of_the_noise(of, settings.band, lowest).into_iter();
        Self {
            order: last_order_in(document, settings.basis),
            percent: lines.map(|(_, share)| 100.0 * share).reduce(f64::max),
        }
    }

    /// Settings that let no line of the noise in.
    pub fn without_its_lines(self, settings: Settings) -> Settings {
        let percent = self.percent.map_or(0.0, |percent| ABOVE * percent);
        Settings {
            threshold_percent: settings.threshold_percent.max(percent),
            ..settings
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{
        app::{App, Command, Entry, measured::spectrum},
        measurements::{Quantity, Repeats, normal},
        spectrum::Sampled,
    };

    /// A glow of one cosine wave and a line.
    fn light(nm: i32) -> f64 {
        let x = std::f64::consts::PI * f64::from(nm - 380) / 400.0;
        let line = (-((f64::from(nm) - 546.1) / 1.5).powi(2)).exp();
        1.0 + 0.4 * (2.0 * x).cos() + line
    }

    fn table(noise: impl Iterator<Item = f64>) -> Measurement {
        let values = (380..=780).zip(noise).map(|(nm, e)| light(nm) + e);
        let samples = Sampled::even(380.0, 1.0, values.collect()).expect("finite");
        Measurement::new("lamp", Quantity::Light, "", samples)
    }

    fn document(of: &Measurement) -> Document {
        let entry = Entry {
            measured: Some(Arc::new(of.clone())),
            ..Entry::own(1, spectrum(of, ""))
        };
        let mut app = App::new();
        app.apply(Command::Show(Arc::new(entry)));
        app.document().clone()
    }

    #[test]
    fn the_noise_begins_behind_the_waves_of_the_light_and_nowhere_where_none_is_known() {
        let mut of = table(normal(3).map(|e| 0.01 * e));
        let silent = NoiseBegins::of(&document(&of), 0.1);
        assert_eq!(silent, NoiseBegins::default());
        of.sigma = Some(vec![0.01; 401]);
        // Order 1 has cosines 1 and 2.
        assert_eq!(NoiseBegins::of(&document(&of), 0.1).order, Some(1));
    }

    #[test]
    fn lines_of_the_noise_are_kept_out_by_a_threshold_above_them_and_the_lamps_own_stay() {
        let own = 100.0 * 1.5 * std::f64::consts::PI.sqrt() / 402.0;
        let mut draws = 0;
        for seed in 0..8 {
            // Noise that the instrument smooths makes lines; five scans tell what it is like.
            let white: Vec<f64> = normal(seed).take(5 * 406).collect();
            let scans: Vec<Measurement> = white
                .chunks(406)
                .map(|one| {
                    let smoothed = one.windows(6).map(|near| near.iter().sum::<f64>());
                    table(smoothed.map(|e| 0.02 * e))
                })
                .collect();
            let mean = Repeats::of(&scans).expect("five on one grid").mean;
            let document = document(&mean);
            let found = NoiseBegins::of(&document, 0.01);
            let Some(percent) = found.percent else {
                continue;
            };
            draws += 1;
            assert!(percent < own, "{percent}");
            let low = Settings {
                threshold_percent: 0.01,
                ..document.settings
            };
            let kept = found.without_its_lines(low).threshold_percent;
            assert!(percent < kept && kept < own, "{percent} {kept}");
        }
        assert!(draws > 0, "no draw made a line");
    }

    #[test]
    fn a_threshold_is_raised_where_noise_would_come_in_and_nowhere_else() {
        let settings = Settings::default();
        let at = |percent| NoiseBegins {
            order: None,
            percent,
        };
        assert_eq!(at(None).without_its_lines(settings), settings);
        let raised = at(Some(0.8)).without_its_lines(settings);
        assert!(raised.threshold_percent > 0.8 && raised.threshold_percent < 0.85);
        assert_eq!(at(Some(0.1)).without_its_lines(settings), settings);
    }
}
