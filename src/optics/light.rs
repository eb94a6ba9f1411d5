//! The light that is sent through things: a smooth part and spikes, as the model has them.

use std::borrow::Cow;

use crate::{
    color::{Observer, Xyz},
    spectrum::{Band, Composite, Line},
};

/// First and last wavelength that is traced, nm: what the eye sees but for a trace.
pub(crate) const SEEN_NM: [f64; 2] = [380.0, 780.0];

/// Places and weights of Gauss-Legendre's rule of three points on [0, 1]: exact to the fifth power.
pub(super) const GAUSS: [[f64; 2]; 3] = [
    [0.112_701_665_379_258_31, 5.0 / 18.0],
    [0.5, 8.0 / 18.0],
    [0.887_298_334_620_741_7, 5.0 / 18.0],
];

/// A smooth part on a band's 1 nm grid, straight between, and spikes.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its display name.
    pub name: String,
    band: Band,
    smooth: Vec<f64>,
    spikes: Vec<Line>,
}

/// Why there is no light.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LightError {
    /// Not one value per grid point.
    #[error("{}", tr!("expected {expected} values of a light, found {found}", expected, found))]
    Values { expected: usize, found: usize },
    /// A value, place or weight that is no finite number.
    #[error("{}", said!("expected finite numbers of a light, found others"))]
    NotFinite,
    /// Nothing shines between 380 and 780 nm.
    #[error(
        "{}",
        tr!("{name}: expected a light with power between 380 and 780 nm, found none", name)
    )]
    Dark { name: String },
}

impl Light {
    /// From a smooth part on a band's grid (value) and spikes (weights in value x nm).
    ///
    /// # Errors
    /// [`LightError`] for another count of values, numbers that are not finite, and a light with
    /// nothing between 380 and 780 nm.
    pub fn new(
        name: &str,
        band: Band,
        smooth: Vec<f64>,
        mut spikes: Vec<Line>,
    ) -> Result<Self, LightError> {
        if smooth.len() != band.points() {
            return Err(LightError::Values {
                expected: band.points(),
                found: smooth.len(),
            });
        }
        let of_spikes = spikes.iter().flat_map(|s| [s.at_nm, s.weight]);
        if !smooth.iter().copied().chain(of_spikes).all(f64::is_finite) {
            return Err(LightError::NotFinite);
        }
        spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        let light = Self {
            name: name.to_owned(),
            band,
            smooth,
            spikes,
        };
        if light.power_within(SEEN_NM) > 0.0 {
            Ok(light)
        } else {
            Err(LightError::Dark { name: light.name })
        }
    }

    /// The model's own light: its series on the grid and its spikes.
    ///
    /// # Errors
    /// As [`Light::new`].
    pub fn of_composite(name: &str, composite: &Composite) -> Result<Self, LightError> {
        Self::new(
            name,
            composite.band(),
            composite.smooth().on_band(),
            composite.lines().to_vec(),
        )
    }

    /// One wavelength alone.
    ///
    /// # Errors
    /// As [`Light::new`].
    pub(crate) fn of_line(at_nm: f64) -> Result<Self, LightError> {
        let band = Band::VISIBLE;
        let (dark, spikes) = (vec![0.0; band.points()], vec![Line::ideal(at_nm, 1.0)]);
        Self::new(&format!("{at_nm} nm"), band, dark, spikes)
    }

    /// The light without its smooth part; `None` where no spike of it is seen.
    pub(crate) fn lines_alone(&self) -> Option<Self> {
        let smooth = vec![0.0; self.smooth.len()];
        Self::new(&self.name, self.band, smooth, self.spikes.clone()).ok()
    }

    /// The light without its spikes; `None` where nothing else of it is seen.
    pub(crate) fn smooth_alone(&self) -> Option<Self> {
        Self::new(&self.name, self.band, self.smooth.clone(), Vec::new()).ok()
    }

    /// The smooth part at a wavelength, straight between whole nm and zero outside the band.
    pub fn smooth_at(&self, at_nm: f64) -> f64 {
        self.band.interpolate(&self.smooth, at_nm)
    }

    /// The band of the smooth part.
    pub fn band(&self) -> Band {
        self.band
    }

    /// The smooth part on the band's grid.
    pub fn smooth(&self) -> &[f64] {
        &self.smooth
    }

    /// All spikes by rising wavelength.
    pub fn spikes(&self) -> &[Line] {
        &self.spikes
    }

    /// Spikes between 380 and 780 nm, by rising wavelength.
    pub(crate) fn seen_spikes(&self) -> impl Iterator<Item = Line> + '_ {
        let [from, to] = SEEN_NM;
        let seen = move |s: &&Line| (from..=to).contains(&s.at_nm) && s.weight != 0.0;
        self.spikes.iter().filter(seen).copied()
    }

    /// Whole nm of 380-780 at which the smooth part is not zero, then the places of its spikes.
    pub(super) fn lit_nm(&self) -> impl Iterator<Item = f64> + '_ {
        let smooth = (380..=780).map(f64::from);
        let smooth = smooth.filter(|nm| self.smooth_at(*nm) != 0.0);
        smooth.chain(self.seen_spikes().map(|spike| spike.at_nm))
    }

    /// Share of the power (absolute values) outside 380-780 nm, which is not traced.
    pub(crate) fn share_unseen(&self) -> f64 {
        let all = self.power_within([f64::NEG_INFINITY, f64::INFINITY]);
        (1.0 - self.power_within(SEEN_NM) / all).max(0.0)
    }

    /// Absolute power between two wavelengths, value x nm.
    fn power_within(&self, [from, to]: [f64; 2]) -> f64 {
        let spikes = self
            .spikes
            .iter()
            .filter(|s| (from..=to).contains(&s.at_nm));
        let spikes: f64 = spikes.map(|s| s.weight.abs()).sum();
        let (from, to) = (from.max(self.band.min_nm()), to.min(self.band.max_nm()));
        let ends = |a: f64, b: f64| self.smooth_at(a).abs() + self.smooth_at(b).abs();
        let smooth = pieces(from, to).map(|[a, b]| 0.5 * (b - a) * ends(a, b));
        spikes + smooth.sum::<f64>()
    }

    /// Integral of the smooth part times colour-matching functions between two wavelengths, value
    /// x nm; of its absolute value with `absolute`.
    pub(super) fn smooth_xyz(
        &self,
        [from, to]: [f64; 2],
        observer: Observer,
        absolute: bool,
    ) -> Xyz {
        let table = observer.table();
        let (from, to) = (from.max(self.band.min_nm()), to.min(self.band.max_nm()));
        let mut sum = Xyz::ZERO;
        for [a, b] in pieces(from, to) {
            for [place, weight] in GAUSS {
                let nm = a + place * (b - a);
                let value = self.smooth_at(nm);
                let value = if absolute { value.abs() } else { value };
                sum += Xyz::from_array(table.at(nm)) * (value * weight * (b - a));
            }
        }
        sum
    }

    /// Integral of the smooth part between two wavelengths, value x nm.
    pub(super) fn smooth_power(&self, [from, to]: [f64; 2]) -> f64 {
        let (from, to) = (from.max(self.band.min_nm()), to.min(self.band.max_nm()));
        let piece = |[a, b]: [f64; 2]| 0.5 * (b - a) * (self.smooth_at(a) + self.smooth_at(b));
        pieces(from, to).map(piece).sum()
    }

    /// The same light in a unit in which pictures of single precision hold it: as it is, but for
    /// one beyond 1e-20 to 1e20, which is taken times a power of two.
    pub(super) fn in_reach(&self) -> Cow<'_, Self> {
        let weights = self.spikes.iter().map(|spike| spike.weight);
        let all = self.smooth.iter().copied().chain(weights);
        let peak = all.fold(0.0_f64, |most, value| most.max(value.abs()));
        if (1e-20..=1e20).contains(&peak) {
            return Cow::Borrowed(self);
        }
        // No larger: a number just above zero has no inverse.
        let factor = (-peak.log2().floor()).min(1000.0).exp2();
        let mut scaled = self.clone();
        let weights = scaled.spikes.iter_mut().map(|spike| &mut spike.weight);
        let all = scaled.smooth.iter_mut().chain(weights);
        all.for_each(|value| *value *= factor);
        Cow::Owned(scaled)
    }

    /// XYZ of the whole light between 380 and 780 nm, value x nm.
    pub fn white(&self, observer: Observer) -> Xyz {
        let table = observer.table();
        let smooth = self.smooth_xyz(SEEN_NM, observer, false);
        self.seen_spikes().fold(smooth, |sum, s| {
            sum + Xyz::from_array(table.at(s.at_nm)) * s.weight
        })
    }
}

/// A range cut at whole nm, where straight lines bend.
pub(super) fn pieces(from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> {
    let first = from.floor();
    let length = if to > from { to - first } else { 0.0 };
    (0..length.ceil() as usize).map(move |i| {
        let left = first + i as f64;
        [left.max(from), (left + 1.0).min(to)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_is_cut_at_whole_nm() {
        let cut: Vec<_> = pieces(400.25, 402.5).collect();
        assert_eq!(cut, [[400.25, 401.0], [401.0, 402.0], [402.0, 402.5]]);
        assert_eq!(pieces(5.0, 5.0).count(), 0);
        assert_eq!(pieces(6.0, 5.0).count(), 0);
        assert_eq!(pieces(5.0, 7.0).count(), 2);
    }

    #[test]
    fn both_parts_make_the_whole() {
        let band = Band::VISIBLE;
        let spike = Line::ideal(546.1, 40.0);
        let whole = Light::new("both", band, vec![1.0; band.points()], vec![spike]).unwrap();
        let (lines, smooth) = (whole.lines_alone().unwrap(), whole.smooth_alone().unwrap());
        let white = |light: &Light| light.white(Observer::CIE_1931).y;
        assert!((white(&lines) + white(&smooth) - white(&whole)).abs() < 1e-9 * white(&whole));
        assert!(smooth.lines_alone().is_none() && lines.smooth_alone().is_none());
    }

    #[test]
    fn darkness_is_refused_and_what_is_unseen_is_told() {
        let band = Band::new(700.0, 900.0).unwrap();
        let flat = Light::new("flat", band, vec![1.0; 201], Vec::new()).unwrap();
        assert!((flat.share_unseen() - 0.6).abs() < 1e-12);
        let far = Band::new(800.0, 900.0).unwrap();
        let said = Light::new("far", far, vec![1.0; 101], Vec::new()).unwrap_err();
        assert_eq!(
            said.to_string(),
            "far: expected a light with power between 380 and 780 nm, found none"
        );
        assert!(Light::new("x", far, vec![f64::NAN; 101], Vec::new()).is_err());
        assert!(Light::new("x", far, vec![1.0; 3], Vec::new()).is_err());
        assert!(Light::of_line(546.1).is_ok() && Light::of_line(900.0).is_err());
    }
}
