//! The spectrum of a photograph: light for each nm, as the camera saw it.

use super::Photograph;
use crate::photographs::axis::Curve;

/// Light at a wavelength, relative to the brightest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Where.
    pub nm: f64,
    /// The sum of the channels.
    pub value: f64,
    /// Its noise, one standard deviation.
    pub sigma: f64,
    /// Red, green and blue.
    pub channels: [f64; 3],
    /// A channel was at its end: the value is not known.
    pub is_clipped: bool,
}

/// A spectrum by rising wavelengths.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    pub rows: Vec<Row>,
    /// Where they stand.
    pub stands: Stands,
}

/// Where the rows of a spectrum stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stands {
    /// On whole nm, each the mean over its nm.
    WholeNm,
    /// At the columns' own places.
    Columns,
    /// On the grid of the response that they were read through.
    Response,
}

impl Photograph {
    /// The spectrum on the axis that is used, where that holds; `None` without one.
    pub fn rows(&self) -> Option<Rows> {
        let curve = self.used_curve()?;
        let (from, to) = self.valid_nm()?;
        let profile = &self.found.profile;
        let last = profile.columns() as f64 - 1.0;
        let finest = [0.0, 0.5 * last, last].map(|px| curve.slope(px).abs());
        let is_on_whole_nm = finest.iter().all(|step| *step < 1.0);
        let stands = match self.through {
            Some(_) => Stands::Response,
            None if is_on_whole_nm => Stands::WholeNm,
            None => Stands::Columns,
        };
        let over_1_nm = |nm: f64| {
            let ends = [nm - 0.5, nm + 0.5].map(|nm| curve.px(nm, 0.0, last));
            let [Some(a), Some(b)] = ends else {
                return None;
            };
            Some(self.mean(nm, a.min(b), a.max(b)))
        };
        let whole = (from.ceil() as i32..=to.floor() as i32).map(f64::from);
        let mut rows: Vec<Row> = match (&self.through, stands) {
            (Some(through), _) => {
                let all = &through.corrected;
                let known = all.nm.iter().zip(&all.value).zip(&all.sigma);
                known
                    .filter_map(|((nm, value), sigma)| Some((*nm, (*value)?, (*sigma)?)))
                    .filter(|(nm, ..)| (from..=to).contains(nm))
                    .filter_map(|(nm, value, sigma)| {
                        let seen = over_1_nm(nm)?;
                        Some(Row {
                            value,
                            sigma,
                            ..seen
                        })
                    })
                    .collect()
            }
            (None, Stands::WholeNm) => whole.filter_map(over_1_nm).collect(),
            _ => self.at_columns(&curve, from, to),
        };
        let top = rows.iter().map(|row: &Row| row.value).fold(0.0, f64::max);
        if top <= 0.0 {
            return None;
        }
        // Through a response light and channels have different units.
        let sum = |row: &Row| row.channels.iter().sum::<f64>();
        let seen = rows.iter().map(sum).fold(f64::MIN_POSITIVE, f64::max);
        for row in &mut rows {
            row.value /= top;
            row.sigma /= top;
            row.channels = row.channels.map(|c| c / seen);
        }
        Some(Rows { rows, stands })
    }

    /// The light of all columns between two places, which are 1 nm apart.
    fn mean(&self, nm: f64, from: f64, to: f64) -> Row {
        let profile = &self.found.profile;
        let mut channels = [0.0; 3];
        let mut variance = 0.0;
        let mut is_clipped = false;
        let first = (from + 0.5).floor().max(0.0) as usize;
        let last = ((to + 0.5).floor() as usize).min(profile.columns() - 1);
        for column in first..=last {
            let (left, right) = (column as f64 - 0.5, column as f64 + 0.5);
            let share = (right.min(to) - left.max(from)).max(0.0);
            for (sum, channel) in channels.iter_mut().zip(&profile.channels) {
                *sum += share * channel[column];
            }
            variance += (share * profile.sum_sigma() * self.noise_factor(column)).powi(2);
            is_clipped |= share > 0.0 && profile.clipped[column];
        }
        Row {
            nm,
            value: channels.iter().sum(),
            sigma: variance.sqrt(),
            channels,
            is_clipped,
        }
    }

    /// Each column at its own place, its light for 1 nm.
    fn at_columns(&self, curve: &Curve, from: f64, to: f64) -> Vec<Row> {
        let profile = &self.found.profile;
        let row = |column: usize| {
            let px = column as f64;
            let step = curve.slope(px).abs();
            let channels = profile.channels.each_ref().map(|c| c[column] / step);
            Row {
                nm: curve.nm(px),
                value: channels.iter().sum(),
                sigma: profile.sum_sigma() * self.noise_factor(column) / step,
                channels,
                is_clipped: profile.clipped[column],
            }
        };
        let inside = |row: &Row| (from..=to).contains(&row.nm);
        let mut rows: Vec<Row> = (0..profile.columns()).map(row).filter(inside).collect();
        rows.sort_by(|a, b| a.nm.total_cmp(&b.nm));
        rows
    }
}
