//! The shapes of slits, and how they weigh the samples of a table.

use serde::{Deserialize, Serialize};

/// The shape of a slit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kernel {
    /// A triangle whose half base is its FWHM.
    Triangle,
    /// A Gaussian, cut where it is below 1e-6 of its top.
    Gauss,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slit {
    pub shape: Kernel,
    /// Full width at half maximum, nm.
    pub fwhm_nm: f64,
}

/// Cut-off of the Gaussian, in FWHM from its middle.
const GAUSS_REACH: f64 = 2.2;

/// FWHM of a Gaussian over its standard deviation.
const FWHM_OVER_SIGMA: f64 = 2.354_820_045_030_949_3;

impl Kernel {
    /// The word of files and of the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Triangle => "triangle",
            Self::Gauss => "gauss",
        }
    }

    /// The kernel of a word.
    pub fn from_word(word: &str) -> Option<Self> {
        let all = [Self::Triangle, Self::Gauss];
        all.into_iter().find(|kernel| kernel.word() == word)
    }
}

impl Slit {
    /// Reach to either side, nm.
    pub(super) fn reach_nm(self) -> f64 {
        match self.shape {
            Kernel::Triangle => self.fwhm_nm,
            Kernel::Gauss => GAUSS_REACH * self.fwhm_nm,
        }
    }

    /// Height of the kernel `u` nm from its middle; its area is 1.
    pub(super) fn height(self, u: f64) -> f64 {
        if u.abs() >= self.reach_nm() {
            return 0.0;
        }
        match self.shape {
            Kernel::Triangle => (self.fwhm_nm - u.abs()) / (self.fwhm_nm * self.fwhm_nm),
            Kernel::Gauss => {
                let sigma = self.fwhm_nm / FWHM_OVER_SIGMA;
                let z = u / sigma;
                (-0.5 * z * z).exp() / (sigma * (2.0 * std::f64::consts::PI).sqrt())
            }
        }
    }

    /// Integrals of the kernel and of the kernel times `u` from its beginning to `u` nm from its
    /// middle; the first from its middle for the Gaussian: only differences count.
    fn running(self, u: f64) -> [f64; 2] {
        let f = self.fwhm_nm;
        let u = u.clamp(-self.reach_nm(), self.reach_nm());
        match self.shape {
            Kernel::Triangle => {
                let left = (f - u.abs()).powi(2) / (2.0 * f * f);
                let zeroth = if u < 0.0 { left } else { 1.0 - left };
                let first = (0.5 * u * u - u.abs().powi(3) / (3.0 * f)) / f - f / 6.0;
                [zeroth, first]
            }
            Kernel::Gauss => {
                let sigma = f / FWHM_OVER_SIGMA;
                let z = u / sigma;
                let height = (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
                [normal_integral(z), -sigma * height]
            }
        }
    }

    /// Weights of a table's samples in what is seen at a wavelength: the index of the first, and
    /// one each; none where the kernel lies outside the table.
    pub(super) fn weights(self, nm: &[f64], at_nm: f64) -> (usize, Vec<f64>) {
        let (from, to) = (at_nm - self.reach_nm(), at_nm + self.reach_nm());
        let first = nm.partition_point(|nm| *nm <= from).saturating_sub(1);
        let end = (nm.partition_point(|nm| *nm < to) + 1).min(nm.len());
        if end < first + 2 {
            return (first, Vec::new());
        }
        let own = &nm[first..end];
        let mut weights = vec![0.0; own.len()];
        let mut inside = 0.0;
        let mut before = self.running(own[0] - at_nm);
        for (k, w) in own.windows(2).enumerate() {
            let behind = self.running(w[1] - at_nm);
            let [zeroth, one] = [behind[0] - before[0], behind[1] - before[1]];
            let right = (one - (w[0] - at_nm) * zeroth) / (w[1] - w[0]);
            weights[k] += zeroth - right;
            weights[k + 1] += right;
            inside += zeroth;
            before = behind;
        }
        if inside <= 0.0 {
            return (first, Vec::new());
        }
        weights.iter_mut().for_each(|w| *w /= inside);
        (first, weights)
    }
}

/// Integral of the normal density from 0 to `z`, by its series (exact to rounding for |z| < 7).
fn normal_integral(z: f64) -> f64 {
    let square = z * z;
    // z + z^3/3 + z^5/15 + ..., each term the last times z^2 over the next odd number: all of one
    // sign.
    let (mut term, mut sum, mut odd) = (z, z, 1.0);
    while term.abs() > 1e-17 * sum.abs() {
        odd += 2.0;
        term *= square / odd;
        sum += term;
    }
    sum * (-0.5 * square).exp() / (2.0 * std::f64::consts::PI).sqrt()
}
