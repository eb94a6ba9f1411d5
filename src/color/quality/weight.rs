//! Weighting functions for lights: tables on whole nm, read once from the shipped presets.

use crate::{
    color::observer,
    preset,
    spectrum::{Outside, Sampled, dot},
};

use super::light::{FIRST_NM, LAST_NM, Light};

/// A weighting function on whole nm within 360-830, straight between them and zero outside.
#[derive(Clone, Debug)]
pub(super) struct Weight {
    first_nm: u32,
    values: Vec<f64>,
}

impl Weight {
    /// Values on every nm from `first_nm`.
    pub(super) fn new(first_nm: u32, values: Vec<f64>) -> Self {
        debug_assert!(first_nm >= FIRST_NM && values.len() >= 2);
        debug_assert!(first_nm as usize + values.len() <= LAST_NM as usize + 1);
        Self { first_nm, values }
    }

    /// A table, on the whole nm that it has.
    pub(super) fn of(table: &Sampled) -> Self {
        let first_nm = (table.first_nm().ceil() as u32).max(FIRST_NM);
        let last_nm = (table.last_nm().floor() as u32).min(LAST_NM);
        Self::new(
            first_nm,
            table.on_whole_nm(first_nm, last_nm, Outside::Zero),
        )
    }

    /// A table of `presets/observers.json`.
    pub(super) fn named(name: &str) -> Self {
        Self::of(observer::bundled(name))
    }

    /// Sum over the light's whole nm, each line with the weight at its place.
    pub(super) fn sum(&self, light: &Light) -> f64 {
        let skip = (self.first_nm - FIRST_NM) as usize;
        let smooth = dot(&light.values()[skip..][..self.values.len()], &self.values);
        let lines = light.lines().iter().map(|l| l.weight * self.at(l.at_nm));
        smooth + lines.sum::<f64>()
    }

    /// The weight at a wavelength.
    pub(super) fn at(&self, at_nm: f64) -> f64 {
        value_at(self.first_nm, &self.values, at_nm)
    }
}

/// A value between whole nm from `first_nm` by straight lines; zero outside.
pub(super) fn value_at(first_nm: u32, values: &[f64], at_nm: f64) -> f64 {
    let x = at_nm - f64::from(first_nm);
    let last = values.len() - 1;
    if !(x >= 0.0 && x <= last as f64) {
        return 0.0;
    }
    let left = (x as usize).min(last - 1);
    let t = x - left as f64;
    values[left] * (1.0 - t) + values[left + 1] * t
}

/// A shipped table; its absence is a broken build, which a test would show.
pub(super) fn shipped(group: &str, name: &str) -> &'static Sampled {
    preset::table(group, name).unwrap_or_else(|| panic!("no shipped table {group}/{name}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Line;

    #[test]
    fn a_line_counts_with_the_weight_at_its_exact_place() {
        let v = Weight::named("V(lambda) photopic");
        let light = Light::of_line(Line::ideal(546.25, 3.0));
        let expected = 0.75 * v.at(546.0) + 0.25 * v.at(547.0);
        // The light is scaled to a heaviest line of 1; one product and one sum of rounding.
        assert!((v.sum(&light) * light.scale() - 3.0 * expected).abs() < 1e-15);
    }

    #[test]
    fn outside_a_table_nothing_counts() {
        let mel = Weight::named("S026 s_mel (melanopic)");
        assert_eq!(mel.first_nm, 380);
        for at_nm in [300.0, 379.9, 780.1, 829.0, f64::NAN, f64::INFINITY] {
            assert_eq!(mel.at(at_nm), 0.0);
        }
        assert!(mel.at(780.0) > 0.0);
    }
}
