//! The shipped lights by their nature, and the blackbodies that belong to the smooth ones.

use spectral_explorer::{
    app::Library,
    color::blackbody,
    preset::Shelf,
    spectrum::{Kind, NamedSpectrum, Sampled},
};

/// The groups of the 137 lamps that the study counts.
pub(crate) const COUNTED_GROUPS: [&str; 10] = [
    "cie_illuminants",
    "cie_fluorescent_1nm",
    "cie_fluorescent_5nm",
    "cie_led_1nm",
    "cie_hp_5nm",
    "lamps_nist_traditional",
    "lamps_nist_philips",
    "lamps_nist_led",
    "lamps_rit",
    "lamps_common",
];

/// Every shipped light of a shelf that is a table.
pub(crate) fn on_shelf(shelf: Shelf) -> Vec<&'static NamedSpectrum> {
    Library::bundled()
        .presets()
        .filter(move |preset| preset.shelf == shelf)
        .filter_map(|preset| preset.spectrum())
        .filter(|spectrum| spectrum.kind == Kind::Light)
        .collect()
}

/// Smooth lights: the shelf of A, C, D, E, ID and incandescent lamps, and ten blackbodies of
/// 2000 to 20000 K.
pub(crate) fn smooth() -> Vec<NamedSpectrum> {
    let table = on_shelf(Shelf::Standard).into_iter().cloned();
    table.chain((1..=10).map(blackbody_light)).collect()
}

fn blackbody_light(step: u16) -> NamedSpectrum {
    let kelvin = 2000.0 * f64::from(step);
    let values = (300..=900)
        .map(|nm| blackbody::relative(f64::from(nm), kelvin))
        .collect();
    NamedSpectrum {
        name: format!("blackbody {kelvin} K"),
        kind: Kind::Light,
        unit: String::new(),
        scale: 1.0,
        samples: Sampled::even(300.0, 1.0, values).expect("finite values on a rising grid"),
        notes: Vec::new(),
        source: "Planck's law".to_owned(),
    }
}
