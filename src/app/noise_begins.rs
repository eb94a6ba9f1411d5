//! Where a model of a light whose noise is known begins to draw that noise.

use super::{document::Document, settings::Settings};
use crate::{
    measurements::{MOST_ORDER, order_of_the_noise, shares_of_the_noise},
    spectrum::{Basis, SpikeSettings},
};

/// A threshold is so much above the share of a line that it keeps out.
const ABOVE: f64 = 1.02;

/// The last order of a basis that draws a document's light and not its noise; `None` where no noise is
/// known, or none is drawn.
pub fn last_order_in(document: &Document, basis: Basis) -> Option<usize> {
    let of = document.subject_entry().measured.as_deref()?;
    if !document.is_about_light() {
        return None;
    }
    let order = order_of_the_noise(of, document.settings.band, basis);
    order.filter(|order| *order < MOST_ORDER)
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
        let shares = shares_of_the_noise(of, settings.band, lowest).into_iter();
        Self {
            order: last_order_in(document, settings.basis),
            percent: shares.reduce(f64::max).map(|share| 100.0 * share),
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
        measurements::{Measurement, Quantity, normal},
        spectrum::Sampled,
    };

    /// A glow of one cosine wave and a line, of this noise in each sample.
    fn document(sigma: f64, tells: bool) -> Document {
        let value = |(nm, e): (i32, f64)| {
            let x = std::f64::consts::PI * f64::from(nm - 380) / 400.0;
            let line = (-((f64::from(nm) - 546.1) / 1.5).powi(2)).exp();
            1.0 + 0.4 * (2.0 * x).cos() + line + sigma * e
        };
        let values = (380..=780).zip(normal(3)).map(value).collect();
        let samples = Sampled::even(380.0, 1.0, values).expect("finite");
        let mut of = Measurement::new("lamp", Quantity::Light, "", samples);
        of.sigma = tells.then(|| vec![sigma; 401]);
        let entry = Entry {
            measured: Some(Arc::new(of.clone())),
            ..Entry::own(1, spectrum(&of, ""))
        };
        let mut app = App::new();
        app.apply(Command::Show(Arc::new(entry)));
        app.document().clone()
    }

    #[test]
    fn the_noise_begins_behind_the_waves_of_the_light_and_nowhere_where_none_is_known() {
        let noisy = NoiseBegins::of(&document(0.01, true), 0.1);
        // Order 1 has cosines 1 and 2.
        assert_eq!(noisy.order, Some(1));
        assert_eq!(
            NoiseBegins::of(&document(0.01, false), 0.1),
            NoiseBegins::default()
        );
    }

    #[test]
    fn lines_of_the_noise_are_kept_out_by_a_threshold_above_them_and_the_lamps_own_stay() {
        let document = document(0.03, true);
        let found = NoiseBegins::of(&document, 0.01);
        let own = 100.0 * 1.5 * std::f64::consts::PI.sqrt() / 402.0;
        assert!(
            found.percent.is_none_or(|percent| percent < own),
            "{found:?}"
        );
        let at = |percent| NoiseBegins {
            order: None,
            percent,
        };
        let settings = document.settings;
        assert_eq!(at(None).without_its_lines(settings), settings);
        let raised = at(Some(0.8)).without_its_lines(settings);
        assert!(raised.threshold_percent > 0.8 && raised.threshold_percent < 0.85);
        assert_eq!(at(Some(0.1)).without_its_lines(settings), settings);
    }
}
