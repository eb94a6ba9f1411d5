//! Eq. 17: the factor at a spike, by a straight line between two points.

use super::STATED_LINE_NM;
use crate::{
    color::{Weights, Xyz, delta_e_of_xyz, xyz_of_parts},
    spectrum::{
        Band, Basis, BasisTable, Composite, Line, SampleGrid, Series, numbers_of_order,
        product::multiply,
    },
};

/// A factor read at every spike of a light in four ways, and what that does to the colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Eq17 {
    /// The points that the straight lines run between.
    pub grid: SampleGrid,
    /// Spike by spike.
    pub readings: Vec<SpikeReading>,
    /// CIEDE2000 of the product when spikes are weighed by the corrected straight line instead of
    /// the series.
    pub linear_cost: Option<f64>,
    /// The same by Eq. 17 as printed.
    pub printed_cost: Option<f64>,
    /// The green mercury line on this range, off a straight line through the wavelengths
    /// themselves; `None` where the range does not hold the line.
    pub straight_line: Option<StraightLine>,
}

/// A factor at the place of one spike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpikeReading {
    /// The light's spike.
    pub spike: Line,
    /// The factor as measured.
    pub measured: f64,
    /// Its series, evaluated exactly.
    pub series: f64,
    /// Eq. 17, corrected: the straight line between the two points around.
    pub linear: f64,
    /// Eq. 17 as printed, its two weights swapped.
    pub printed: f64,
}

impl SpikeReading {
    /// The spike behind a factor that is read so.
    pub(in crate::study) fn weighed(&self, factor: f64) -> Line {
        self.spike.weighing(self.spike.weight * factor)
    }
}

/// Reading of a straight line `S(l) = l` by Eq. 17, all in nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightLine {
    /// The place asked for.
    pub at_nm: f64,
    /// The point on its left.
    pub left_nm: f64,
    /// The point on its right.
    pub right_nm: f64,
    /// Value read with the corrected weights: the place requested.
    pub corrected_nm: f64,
    /// Value read with the printed weights: its mirror image between the two points.
    pub printed_nm: f64,
}

/// Reads a factor (values on the grid) at the spikes of a light on the paper's points.
///
/// The factor is cut to as many numbers as the light has, or as the table holds. `weights` and
/// `white` are those of `Question`.
///
/// # Panics
/// When the factor or the weights are not on the grid of the table's band, or the light is not on
/// that band.
pub(crate) fn eq_17(
    light: &Composite,
    factor: &[f64],
    table: &BasisTable,
    weights: &Weights,
    white: Xyz,
) -> Eq17 {
    let band = table.band();
    let series = cut(factor, table, light);
    let grid = paper_grid(&series);
    let samples = grid.sample(&series);
    let readings: Vec<SpikeReading> = light
        .lines()
        .iter()
        .map(|spike| SpikeReading {
            spike: *spike,
            measured: band.interpolate(factor, spike.at_nm),
            series: series.at(spike.at_nm),
            linear: grid.linear_at(&samples, spike.at_nm),
            printed: grid.linear_at_as_printed(&samples, spike.at_nm),
        })
        .collect();
    let smooth = multiply(&light.smooth().on_band(), &series.on_band());
    let weighed_by = |value: fn(&SpikeReading) -> f64| {
        let spikes: Vec<Line> = readings.iter().map(|r| r.weighed(value(r))).collect();
        xyz_of_parts(band, &smooth, &spikes, weights)
    };
    let exact = weighed_by(|reading| reading.series);
    Eq17 {
        grid,
        linear_cost: delta_e_of_xyz(exact, weighed_by(|reading| reading.linear), white),
        printed_cost: delta_e_of_xyz(exact, weighed_by(|reading| reading.printed), white),
        straight_line: straight_line(band, series.order(), STATED_LINE_NM.figure),
        readings,
    }
}

/// Reads `S(l) = l` at a place by Eq. 17 on the paper's 2N+2 points of a range; `None` outside it.
pub(crate) fn straight_line(band: Band, order: usize, at_nm: f64) -> Option<StraightLine> {
    if !band.contains(at_nm) {
        return None;
    }
    let grid = SampleGrid::new(band, Basis::Fourier, numbers_of_order(order));
    let x = (at_nm - band.min_nm()) / grid.step_nm();
    let left = (x as usize).min(grid.points - 1);
    let (left_nm, right_nm) = (grid.nm(left), grid.nm(left + 1));
    let t = x - left as f64;
    Some(StraightLine {
        at_nm,
        left_nm,
        right_nm,
        corrected_nm: left_nm * (1.0 - t) + right_nm * t,
        printed_nm: left_nm * t + right_nm * (1.0 - t),
    })
}

pub(super) fn paper_grid(series: &Series) -> SampleGrid {
    SampleGrid::new(series.band, series.basis, series.coefficients.len())
}

/// A factor fitted with as many numbers as the light has, or as the table holds.
pub(in crate::study) fn cut(factor: &[f64], table: &BasisTable, light: &Composite) -> Series {
    Series::new(
        table.band(),
        table.basis(),
        table.project(factor, light.smooth().coefficients.len()),
    )
}
