//! The light along a strip: three channels in linear light, each column with its doubt.

/// Light against columns, in units in which the brightest code is 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// Red, green and blue, black level taken off; three equal ones of a grey picture.
    pub channels: [Vec<f64>; 3],
    /// Noise of each channel, one standard deviation.
    pub sigma: [f64; 3],
    /// Columns where a channel is at its end in some of the rows: their height is not known.
    pub clipped: Vec<bool>,
    /// No colours to go by.
    pub is_grey: bool,
    /// Rows beside the strip told the black level.
    pub black_seen: bool,
    /// Rows that were used.
    pub rows: usize,
}

impl Profile {
    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.clipped.len()
    }

    /// The sum of the channels in each column.
    pub fn sum(&self) -> Vec<f64> {
        let [r, g, b] = &self.channels;
        let both = r.iter().zip(g).zip(b);
        both.map(|((r, g), b)| r + g + b).collect()
    }

    /// The noise of the sum, one standard deviation.
    pub fn sum_sigma(&self) -> f64 {
        self.sigma.iter().map(|s| s * s).sum::<f64>().sqrt()
    }

    /// Number of clipped columns.
    pub fn clipped_columns(&self) -> usize {
        self.clipped.iter().filter(|c| **c).count()
    }
}
