//! A light that falls on a picture: at full resolution for colour, under the bands' tents where it
//! multiplies a pixel.

use std::sync::LazyLock;

use crate::color::Observer;
use crate::color::Xyz;
use crate::color::xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values};
use crate::preset::{self, Preset};
use crate::spectrum::{Line, Outside, Sampled};

use super::{Bands, PictureError};

/// A light: a table and, where it has any, lines of no width.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    name: String,
    table: Sampled,
    spikes: Vec<Line>,
    on_nm: Vec<f64>,
}

/// Lights that judge a choice: none of them is an own light by default.
pub const JUDGES: [&str; 6] = ["A", "FL2", "FL11", "LED-B3", "HP1", "Mercury"];

impl Light {
    /// A light from its table.
    pub fn new(name: &str, table: &Sampled) -> Self {
        Self::with_spikes(name, table, Vec::new())
    }

    /// A light from its smooth part and its lines (value x nm).
    pub fn with_spikes(name: &str, table: &Sampled, spikes: Vec<Line>) -> Self {
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
        static LIGHTS: LazyLock<Vec<Light>> = LazyLock::new(|| {
            let groups = ["cie_fluorescent_1nm", "cie_led_1nm"];
            let groups = groups.into_iter().filter_map(preset::group);
            let lights = groups.flat_map(|group| {
                let tables = group.items.iter();
                let lights = tables.filter_map(|item| Some((item.name.as_str(), item.spectrum()?)));
                lights
                    .map(|(name, table)| Light::new(name, &table.samples))
                    .collect::<Vec<_>>()
            });
            lights.collect()
        });
        &LIGHTS
    }

    /// The six lights that judge.
    pub fn judges() -> &'static [Self] {
        static LIGHTS: LazyLock<Vec<Light>> =
            LazyLock::new(|| JUDGES.into_iter().filter_map(Light::named).collect());
        &LIGHTS
    }

    /// What lists call it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its lines.
    pub fn spikes(&self) -> &[Line] {
        &self.spikes
    }

    /// Its table on the whole nm 360-830.
    pub fn on_nm(&self) -> &[f64] {
        &self.on_nm
    }

    /// Its XYZ as sums over 360-830 nm, not scaled.
    pub fn xyz(&self, observer: Observer) -> Xyz {
        let smooth = xyz_from_nm_values(&self.on_nm, observer);
        let table = observer.table();
        self.spikes.iter().fold(smooth, |sum, spike| {
            sum + Xyz::from_array(table.at(spike.at_nm)) * spike.weight
        })
    }

    /// Its colour at Y = 1; `None` when it does not shine.
    pub fn white(&self, observer: Observer) -> Option<Xyz> {
        self.xyz(observer).with_y(1.0)
    }

    /// XYZ of a reflectance picture's pixel under it, Y = 1 for the light: three weights a band.
    ///
    /// # Errors
    /// [`PictureError::NoOwnLight`] when it does not shine.
    pub fn weights(
        &self,
        bands: &Bands,
        observer: Observer,
    ) -> Result<[Vec<f64>; 3], PictureError> {
        let dark = || PictureError::NoOwnLight {
            light: self.name.clone(),
        };
        let y = self.xyz(observer).y;
        if !(y > 0.0 && y.is_finite()) {
            return Err(dark());
        }
        let table = observer.table();
        let rows = std::array::from_fn(|k| {
            let seen = seen_on_nm(observer, k);
            let on_nm: Vec<f64> = seen
                .iter()
                .zip(&self.on_nm)
                .map(|(s, l)| s * l / y)
                .collect();
            let spikes = self.spikes.iter();
            let at: Vec<(f64, f64)> = spikes
                .map(|s| (s.at_nm, s.weight * table.at(s.at_nm)[k] / y))
                .collect();
            bands.fold(&on_nm, &at)
        });
        let shines = |row: &Vec<f64>| row.iter().any(|w| *w != 0.0);
        if shines(&rows[1]) {
            Ok(rows)
        } else {
            Err(dark())
        }
    }

    /// The light on the bands of a picture that it lights, scaled to a mean of 1.
    ///
    /// # Errors
    /// [`PictureError::NoOverlap`] when nothing of it falls on the bands.
    pub fn on_bands(&self, bands: &Bands) -> Result<Vec<f64>, PictureError> {
        let mut values = bands.under_tents(&self.table, &self.spikes);
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
        let on_nm = self
            .on_nm
            .iter()
            .zip(&other.on_nm)
            .map(|(x, y)| a * x + b * y);
        let table = Sampled::even(f64::from(FIRST_NM), 1.0, on_nm.collect()).ok()?;
        let scaled = |spikes: &[Line], factor: f64| -> Vec<Line> {
            let spikes = spikes.iter();
            spikes
                .map(|s| Line {
                    weight: s.weight * factor,
                    ..*s
                })
                .collect()
        };
        let mut spikes = scaled(&self.spikes, a);
        spikes.extend(scaled(&other.spikes, b));
        let name = format!("{} and {}", self.name, other.name);
        Some(Self::with_spikes(&name, &table, spikes))
    }
}

/// One colour-matching function on the whole nm 360-830, zero outside its table.
pub(super) fn seen_on_nm(observer: Observer, k: usize) -> Vec<f64> {
    let table = observer.table();
    let whole_nm = FIRST_NM..=LAST_NM;
    whole_nm.map(|nm| table.at(f64::from(nm))[k]).collect()
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
) -> Result<[Vec<f64>; 3], PictureError> {
    let rows: [Vec<f64>; 3] = std::array::from_fn(|k| bands.fold(&seen_on_nm(observer, k), &[]));
    let y: f64 = rows[1].iter().zip(white).map(|(w, v)| w * v).sum();
    if !(y > 0.0 && y.is_finite()) {
        return Err(PictureError::NoOwnLight {
            light: "what the eye sees".to_owned(),
        });
    }
    Ok(rows.map(|row| row.into_iter().map(|w| w / y).collect()))
}

fn in_group(id: &str, name: &str, full: &str) -> Option<Light> {
    Some(Light::new(name, preset::table(id, full)?))
}

/// A light by its name or `group/name` anywhere in the library.
fn anywhere(name: &str) -> Option<Light> {
    let mut items = preset::groups().flat_map(|group| &group.items);
    let is_it = |item: &&Preset| {
        item.kind == crate::spectrum::Kind::Light && (item.name == name || item.id() == name)
    };
    let found = items.find(is_it)?;
    Some(Light::new(name, &found.spectrum()?.samples))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Kind;

    #[test]
    fn every_judge_and_thirty_six_weighting_lights_are_in_the_library() {
        assert_eq!(Light::judges().len(), 6);
        assert_eq!(Light::weighting().len(), 36);
        assert!(Light::named("H38HT-100 (Mercury)").is_some());
        assert!(Light::named("no such lamp").is_none());
    }

    #[test]
    fn a_perfect_reflector_has_the_colour_of_the_light() {
        let bands = Bands::new(vec![400.0, 500.0, 620.0, 700.0], Kind::Reflectance).unwrap();
        for light in Light::judges() {
            let rows = light.weights(&bands, Observer::CIE_1931).unwrap();
            let white = light.white(Observer::CIE_1931).unwrap().to_array();
            for (row, white) in rows.iter().zip(white) {
                // The same 471 products, shared out over the bands and summed again.
                assert!((row.iter().sum::<f64>() - white).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_line_acts_at_its_own_wavelength() {
        let dark = Sampled::new(vec![300.0, 900.0], vec![0.0; 2]).unwrap();
        let line = Light::with_spikes("line", &dark, vec![Line::ideal(546.1, 2.0)]);
        let bands = Bands::new(vec![400.0, 540.0, 550.0, 700.0], Kind::Reflectance).unwrap();
        let [x, y, _] = line.weights(&bands, Observer::CIE_1931).unwrap();
        let seen = Observer::CIE_1931.table().at(546.1);
        assert!((y[2] - 0.61).abs() < 1e-12 && (y[1] - 0.39).abs() < 1e-12);
        assert!((x[2] - 0.61 * seen[0] / seen[1]).abs() < 1e-12);
    }

    #[test]
    fn a_mixture_lies_between_its_lights() {
        let (a, b) = (Light::named("A").unwrap(), Light::named("D65").unwrap());
        let mixed = a.mixed_with(&b, 0.25, Observer::CIE_1931).unwrap();
        let white = |light: &Light| light.white(Observer::CIE_1931).unwrap();
        let between = white(&a) * 0.25 + white(&b) * 0.75;
        // Linear, so only rounding differs.
        assert!((white(&mixed).x - between.x).abs() < 1e-12);
    }

    #[test]
    fn a_light_beyond_the_bands_is_refused_in_words() {
        let far = Sampled::new(vec![1000.0, 1100.0], vec![1.0; 2]).unwrap();
        let bands = Bands::new(vec![400.0, 500.0, 600.0], Kind::Light).unwrap();
        let said = Light::new("heater", &far).on_bands(&bands).unwrap_err();
        assert!(
            said.to_string()
                .contains("overlaps the bands, found heater")
        );
    }
}
