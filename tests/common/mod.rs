//! Shipped spectra by name, for the tests of the numbers.

use spectral_explorer::{
    app::Library,
    spectrum::{Band, NamedSpectrum},
};

/// The shipped table of that name, plain or as `group/name`.
#[track_caller]
pub(crate) fn shipped(name: &str) -> &'static NamedSpectrum {
    let preset = Library::bundled().find(name);
    let table = preset.ok().and_then(|preset| preset.spectrum());
    table.unwrap_or_else(|| panic!("no shipped table is called {name}"))
}

/// Its values on a band's grid.
#[track_caller]
pub(crate) fn on_band(name: &str, band: Band) -> Vec<f64> {
    values(shipped(name), band)
}

/// A spectrum's values on a band's grid, continued outside its table as its kind asks for.
pub(crate) fn values(spectrum: &NamedSpectrum, band: Band) -> Vec<f64> {
    spectrum.samples.on_band(band, spectrum.kind.outside())
}
