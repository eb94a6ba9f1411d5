//! A light that falls on a picture: at full resolution for colour, under the bands' hats where it
//! multiplies a pixel.

use std::sync::LazyLock;

use nalgebra::DMatrix;

use crate::color::Observer;
use crate::color::Xyz;
use crate::color::xyz::{FIRST_NM, LAST_NM};
use crate::preset::{self, Preset};
use crate::spectrum::{Kind, Line, Outside, Sampled, dot};

use super::{Bands, PictureError};

/// A light: a table and, where it has any, lines of no width.
#[derive(Clone, Debug, PartialEq)]
pub struct Illuminant {
    name: String,
    table: Sampled,
    spikes: Vec<Line>,
    on_nm: Vec<f64>,
}

/// Weights for X, Y and Z: one each a band, or a number.
pub(super) type Rows = [Vec<f64>; 3];

/// Three weighted sums.
pub(super) fn sums(rows: &Rows, values: &[f64]) -> Xyz {
    Xyz::from_array(rows.each_ref().map(|row| dot(row, values)))
}

/// Weights of what a matrix is applied to, from those of what comes out.
pub(super) fn times(rows: &Rows, matrix: &DMatrix<f64>) -> Rows {
    let of_row = |row: &Vec<f64>| {
        matrix
            .column_iter()
            .map(|c| dot(c.as_slice(), row))
            .collect()
    };
    rows.each_ref().map(of_row)
}

/// Lights that judge a choice: none of them is an own light by default.
pub(crate) const JUDGES: [&str; 6] = ["A", "FL2", "FL11", "LED-B3", "HP1", "Mercury"];

impl Illuminant {
    /// A light from its table.
    pub fn new(name: &str, table: &Sampled) -> Self {
        Self::with_spikes(name, table, Vec::new())
    }

    /// A light from its smooth part and its lines (value x nm).
    pub(crate) fn with_spikes(name: &str, table: &Sampled, spikes: Vec<Line>) -> Self {
        Self {
            name: name.to_owned(),
            on_nm: table.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero),
            table: table.clone(),
            spikes,
        }
    }

    /// The light that is equal everywhere.
    pub(crate) fn equal_energy() -> Self {
        let ends = vec![1.0, 1e6];
        let table = Sampled::new(ends, vec![1.0; 2]).expect("two rising wavelengths");
        Self::new("E", &table)
    }

    /// A light of the library by its name there or its short one: `D65`, `FL11`, `HP1`, `Mercury`.
    pub fn named(name: &str) -> Option<Self> {
        let group = match name {
            "E" => return Some(Self::equal_energy()),
            "Mercury" | "Hg" => return in_group("lamps_nist_traditional", name, "Mercury"),
            _ if name.starts_with("FL") => "cie_fluorescent_1nm",
            _ if name.starts_with("LED-") => "cie_led_1nm",
            _ if name.starts_with("HP") && name.len() == 3 => "cie_hp_5nm",
            _ => "cie_illuminants",
        };
        in_group(group, name, name)
            .or_else(|| in_group(group, name, &format!("CIE {name}")))
            .or_else(|| anywhere(name))
    }

    /// The CIE FL and LED lights of the library, 1 nm tables: what a fit is weighted with.
    pub fn weighting() -> &'static [Self] {
        static LIGHTS: LazyLock<Vec<Illuminant>> = LazyLock::new(|| {
            let groups = ["cie_fluorescent_1nm", "cie_led_1nm"];
            let groups = groups.into_iter().filter_map(preset::group);
            let lights = groups.flat_map(|group| {
                let tables = group.items.iter();
                let lights = tables.filter_map(|item| Some((item.name.as_str(), item.spectrum()?)));
                lights
                    .map(|(name, table)| Illuminant::new(name, &table.samples))
                    .collect::<Vec<_>>()
            });
            lights.collect()
        });
        &LIGHTS
    }

    /// The six lights that judge.
    pub fn judges() -> &'static [Self] {
        static LIGHTS: LazyLock<Vec<Illuminant>> =
            LazyLock::new(|| JUDGES.into_iter().filter_map(Illuminant::named).collect());
        &LIGHTS
    }

    /// Name in lists.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its lines.
    pub fn spikes(&self) -> &[Line] {
        &self.spikes
    }

    /// Its table on the whole nm 360-830.
    pub(crate) fn on_nm(&self) -> &[f64] {
        &self.on_nm
    }

    /// Its power times the colour-matching functions: at each whole nm of 360-830, then at its
    /// lines (nm, XYZ).
    pub(super) fn seen(&self, observer: Observer) -> Vec<(f64, [f64; 3])> {
        let table = observer.table();
        let whole = (FIRST_NM..=LAST_NM)
            .map(f64::from)
            .zip(self.on_nm.iter().copied());
        let lines = self.spikes.iter().map(|line| (line.at_nm, line.weight));
        let all = whole.chain(lines);
        all.map(|(nm, power)| (nm, table.at(nm).map(|seen| seen * power)))
            .collect()
    }

    /// Its XYZ as sums over 360-830 nm, not scaled.
    pub fn xyz(&self, observer: Observer) -> Xyz {
        let seen = self.seen(observer).into_iter();
        seen.fold(Xyz::ZERO, |sum, (_, xyz)| sum + Xyz::from_array(xyz))
    }

    /// Its colour at Y = 1; `None` when it does not shine.
    pub fn white(&self, observer: Observer) -> Option<Xyz> {
        self.xyz(observer).with_y(1.0)
    }

    /// XYZ of a reflectance picture's pixel under it, Y = 1 for the light: three weights a band.
    ///
    /// # Errors
    /// [`PictureError::NoOwnLight`] when it does not shine.
    pub fn weights(&self, bands: &Bands, observer: Observer) -> Result<Rows, PictureError> {
        over_y(bands.fold(&self.seen(observer)), self.xyz(observer).y)
            .filter(|rows| rows[1].iter().any(|w| *w != 0.0))
            .ok_or_else(|| PictureError::NoOwnLight {
                light: self.name.clone(),
            })
    }

    /// The light on the bands of a picture that it lights, scaled to a mean of 1.
    ///
    /// # Errors
    /// [`PictureError::NoOverlap`] when nothing of it falls on the bands.
    pub(crate) fn on_bands(&self, bands: &Bands) -> Result<Vec<f64>, PictureError> {
        let mut values = bands.under_hats(&self.table, &self.spikes);
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        if !(mean > 0.0 && mean.is_finite()) {
            return Err(PictureError::NoOverlap {
                light: self.name.clone(),
            });
        }
        values.iter_mut().for_each(|v| *v /= mean);
        Ok(values)
    }

    /// Both lights shared out, `share` of this one's Y: a slider from one to the other.
    pub(crate) fn mixed_with(&self, other: &Self, share: f64, observer: Observer) -> Option<Self> {
        let (a, b) = (self.xyz(observer).y, other.xyz(observer).y);
        if !(a > 0.0 && b > 0.0) {
            return None;
        }
        let (a, b) = (share / a, (1.0 - share) / b);
        let both = self.on_nm.iter().zip(&other.on_nm);
        let on_nm = both.map(|(x, y)| a * x + b * y).collect();
        let table = Sampled::even(f64::from(FIRST_NM), 1.0, on_nm).ok()?;
        let own = self.spikes.iter().map(|line| (line, a));
        let spikes = own.chain(other.spikes.iter().map(|line| (line, b)));
        let scaled = spikes.map(|(line, factor)| Line {
            weight: line.weight * factor,
            ..*line
        });
        let name = tr!("{name} and {other}", name = self.name, other = other.name);
        Some(Self::with_spikes(&name, &table, scaled.collect()))
    }
}

/// Weights that make a Y 1; `None` where it is not above zero.
fn over_y(rows: Rows, y: f64) -> Option<Rows> {
    let scaled = |row: Vec<f64>| row.into_iter().map(|w| w / y).collect();
    (y > 0.0 && y.is_finite()).then(|| rows.map(scaled))
}

/// XYZ of a pixel that is itself light: three weights a band, scaled so that what is 1 on
/// `white` has Y = 1.
///
/// # Errors
/// [`PictureError::NoOwnLight`] when `white` has no Y on the bands.
pub(super) fn emissive_weights(
    bands: &Bands,
    observer: Observer,
    white: &[f64],
) -> Result<Rows, PictureError> {
    let rows = bands.fold(&Illuminant::equal_energy().seen(observer));
    let y = dot(&rows[1], white);
    over_y(rows, y).ok_or_else(|| PictureError::NoOwnLight {
        light: said!("what the eye sees").to_owned(),
    })
}

fn in_group(id: &str, name: &str, full: &str) -> Option<Illuminant> {
    Some(Illuminant::new(name, preset::table(id, full)?))
}

/// A light by its name or `group/name` anywhere in the library.
fn anywhere(name: &str) -> Option<Illuminant> {
    let mut items = preset::groups().flat_map(|group| &group.items);
    let is_it =
        |item: &&Preset| item.kind == Kind::Light && (item.name == name || item.id() == name);
    let found = items.find(is_it)?;
    Some(Illuminant::new(name, &found.spectrum()?.samples))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mixture_lies_between_its_lights() {
        let (a, b) = (
            Illuminant::named("A").unwrap(),
            Illuminant::named("D65").unwrap(),
        );
        let mixed = a.mixed_with(&b, 0.25, Observer::CIE_1931).unwrap();
        let white = |light: &Illuminant| light.white(Observer::CIE_1931).unwrap();
        let between = white(&a) * 0.25 + white(&b) * 0.75;
        // Linear, so only rounding differs.
        assert!((white(&mixed).x - between.x).abs() < 1e-12);
    }
}
