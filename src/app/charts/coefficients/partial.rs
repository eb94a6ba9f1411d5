//! The spectrum with the sum of its first orders.

use super::Draw;
use crate::app::{
    chart::{Chart, Dash, Ink, Series, Shape, stroke},
    charts::{
        spectrum::{on_grid, over, provenance},
        tradeoff::waves_words,
        units::value_label,
    },
    numbers::figure,
    ticks::extent,
};

/// How many times higher than all else the measured curve must be to be cut.
const FLAT: f64 = 2.0;

impl Draw<'_> {
    /// The heights of all but the measured curve, with some room, where its spikes would press
    /// everything else flat.
    fn cut(&self, series: &[Series]) -> Option<[f64; 2]> {
        let heights = |series: &[Series]| {
            let points = series.iter().flat_map(|s| s.marks.points());
            extent(points.map(|p| p[1]))
        };
        let ([low, high], [_, peak]) = (heights(series.get(1..)?)?, heights(series)?);
        let room = 0.12 * (high - low.min(0.0));
        (peak > FLAT * high && room > 0.0).then_some([low.min(0.0) - room, high + 2.0 * room])
    }

    /// Marks at the upper edge where spikes go beyond it, with how far they go.
    fn beyond(&self, top: f64) -> Option<Series> {
        let (derived, factor) = (self.app.derived(), self.app.scale_factor());
        let mut points = Vec::new();
        let mut notes = Vec::new();
        let values = derived.measured.iter().map(|v| v * factor);
        let values: Vec<f64> = values.collect();
        for (i, nm) in derived.band.grid().enumerate() {
            let is_peak = i > 0
                && i + 1 < values.len()
                && values[i - 1] < values[i]
                && values[i] >= values[i + 1];
            if is_peak && values[i] > top {
                points.push([nm, 0.97 * top]);
                notes.push(tr!("reaches {value}", value = figure(values[i])));
            }
        }
        let name = said!("goes beyond");
        let series = Series::points(name, Ink::Measured, Shape::Triangle, points);
        (!notes.is_empty()).then(|| series.with_notes(notes))
    }

    /// The spectrum with the partial sum.
    pub(super) fn partial(&self) -> Chart {
        let (derived, table) = (self.app.derived(), &self.app.tables().basis);
        let (factor, order) = (self.app.scale_factor(), self.sight.partial_order);
        let curve = |values: &[f64]| on_grid(derived.band, values, factor);
        let thin = |name: &str, ink: Ink, values: &[f64], dash: Dash| {
            stroke(name, ink, curve(values), 1.2, dash)
        };
        let mut series = vec![thin(
            said!("measured"),
            Ink::Measured,
            &derived.measured,
            Dash::Solid,
        )];
        if !derived.model.lines().is_empty() {
            series.push(thin(
                said!("without its lines"),
                Ink::Residual,
                &derived.parts.smooth,
                Dash::Dashed,
            ));
        }
        if let Some(before) = order.checked_sub(1) {
            let values = self.harmonics.partial_sum(table, before);
            let name = tr!("sum of {waves}", waves = waves_words(before));
            series.push(thin(&name, Ink::Overlay(2), &values, Dash::Dotted));
        }
        let sum = self.harmonics.partial_sum(table, order);
        let name = tr!("sum of {waves}", waves = waves_words(order));
        series.push(stroke(name, Ink::Smooth, curve(&sum), 2.6, Dash::Solid));
        if let Some(pointed) = self
            .sight
            .pointed
            .filter(|n| *n < self.harmonics.orders.len())
        {
            let values = self.harmonics.single(table, pointed);
            let name = tr!("wave {pointed} alone", pointed);
            series.push(Series::line(name, Ink::Product, curve(&values)).dashed(Dash::Dashed));
        }
        let y_range = self.cut(&series);
        if let Some([_, top]) = y_range {
            series.extend(self.beyond(top));
        }
        let unit = self.app.unit();
        Chart {
            y_range,
            title: tr!(
                "{subject}: the sum of {waves}",
                subject = self.app.document().subject_entry().name(),
                waves = waves_words(order)
            ),
            y_label: value_label(unit),
            series,
            notes: provenance(self.app),
            ..over(derived.band)
        }
    }
}
