//! The texts of the shipped files.

/// The shipped files, in the order in which the library lists their groups.
pub const SHIPPED: [&str; 24] = [
    include_str!("../../presets/cie_illuminants.json"),
    include_str!("../../presets/cie_fluorescent_1nm.json"),
    include_str!("../../presets/cie_fluorescent_5nm.json"),
    include_str!("../../presets/cie_led_1nm.json"),
    include_str!("../../presets/cie_led_5nm.json"),
    include_str!("../../presets/cie_hp_5nm.json"),
    include_str!("../../presets/lamps_nist_traditional.json"),
    include_str!("../../presets/lamps_nist_philips.json"),
    include_str!("../../presets/lamps_nist_led.json"),
    include_str!("../../presets/lamps_rit.json"),
    include_str!("../../presets/lamps_common.json"),
    include_str!("../../presets/solar_astm_g173.json"),
    include_str!("../../presets/paper.json"),
    include_str!("../../presets/atomic_lines.json"),
    include_str!("../../presets/colorchecker_ohta.json"),
    include_str!("../../presets/cri_tcs.json"),
    include_str!("../../presets/nist_cqs_vs.json"),
    include_str!("../../presets/tm30_ces99_5nm.json"),
    include_str!("../../presets/pmc_chart.json"),
    include_str!("../../presets/aces_training_190.json"),
    include_str!("../../presets/metals_refractiveindex.json"),
    include_str!("../../presets/usgs_splib07.json"),
    include_str!("../../presets/filters_glass_cc0.json"),
    OBSERVERS,
];

/// Colour-matching functions and the other weighting tables of the CIE.
pub const OBSERVERS: &str = include_str!("../../presets/observers.json");

/// What each shipped spectrum is, in words.
pub const FAMILIES: &str = include_str!("../../presets/families.json");

/// Which shipped surfaces make a set by everyday names.
pub const EVERYDAY: &str = include_str!("../../presets/everyday_surfaces.json");
