//! The purpose of a film's planes, and the size and resolution of a film.

/// Purpose of a plane of a film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plane {
    /// Wavelengths between two, nm.
    Stratum {
        /// First, nm.
        from_nm: f64,
        /// Last, nm.
        to_nm: f64,
    },
    /// One wavelength, nm.
    Line {
        /// Its place, nm.
        at_nm: f64,
    },
}

/// Size and resolution of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilmSettings {
    /// Side of the square picture, pixels.
    pub size: usize,
    /// Equal strata of 380-780 nm.
    pub strata: usize,
    /// The same seed gives the same bits.
    pub seed: u64,
}

impl Default for FilmSettings {
    fn default() -> Self {
        Self {
            size: 480,
            strata: 40,
            seed: 1,
        }
    }
}
