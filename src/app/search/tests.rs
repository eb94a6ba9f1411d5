//! Tests of the search: what a teacher or a designer types, and what comes first.

use std::collections::BTreeSet;

use super::*;
use crate::app::entry::bundled_entries;

fn index() -> Index {
    Index::of(bundled_entries())
}

/// What is typed that does not find first what it should.
fn wrong(asked: &[(&str, &str)]) -> Vec<String> {
    let index = index();
    let check = |(typed, expected): &(&str, &str)| {
        let found = index.search(typed);
        let first = found.first().map(|row| row.entry.key.as_str());
        (first != Some(*expected)).then(|| format!("{typed}: {first:?}, expected {expected}"))
    };
    asked.iter().filter_map(check).collect()
}

/// Words that a teacher or a designer may type, and what must come first.
const ASKED: [(&str, &str); 77] = [
    ("bulb", "cie_illuminants/CIE A"),
    ("light bulb", "cie_illuminants/CIE A"),
    ("tungsten", "cie_illuminants/CIE A"),
    ("filament", "cie_illuminants/CIE A"),
    ("incandescent bulb", "cie_illuminants/CIE A"),
    ("incandescent", "lamps_nist_traditional/Incandescent"),
    ("halogen", "cie_illuminants/CIE A"),
    ("black body", "thermal_lights/Black body 3000 K"),
    ("candle", "thermal_lights/Candle flame"),
    ("flame", "thermal_lights/Candle flame"),
    ("fire", "thermal_lights/Candle flame"),
    ("sun", "solar_astm_g173/ASTM G173-03 global tilt AM1.5G"),
    (
        "sunlight",
        "solar_astm_g173/ASTM G173-03 global tilt AM1.5G",
    ),
    ("solar", "solar_astm_g173/ASTM G173-03 global tilt AM1.5G"),
    ("space", "solar_astm_g173/ASTM G173-03 extraterrestrial"),
    ("daylight", "cie_illuminants/CIE D65"),
    ("d65", "cie_illuminants/CIE D65"),
    ("overcast", "cie_illuminants/CIE D65"),
    ("sky", "cie_illuminants/CIE D75"),
    ("north sky", "cie_illuminants/CIE D75"),
    ("print", "cie_illuminants/CIE D50"),
    ("window", "cie_illuminants/CIE ID50"),
    ("equal energy", "cie_illuminants/CIE E"),
    ("led", "cie_led_1nm/LED-B3"),
    ("white LED", "cie_led_1nm/LED-B3"),
    ("RGB", "cie_led_1nm/LED-RGB1"),
    ("rgb led", "cie_led_1nm/LED-RGB1"),
    ("violet led", "cie_led_1nm/LED-V1"),
    ("tube", "cie_fluorescent_1nm/FL2"),
    ("fluorescent", "cie_fluorescent_1nm/FL2"),
    ("office", "cie_fluorescent_1nm/FL2"),
    ("cool white", "cie_fluorescent_1nm/FL2"),
    ("energy saver", "cie_fluorescent_1nm/FL12"),
    ("energy-saving lamp", "cie_fluorescent_1nm/FL12"),
    ("compact fluorescent", "cie_fluorescent_1nm/FL12"),
    ("CFL", "cie_fluorescent_1nm/FL12"),
    ("supermarket", "cie_fluorescent_1nm/FL11"),
    ("triphosphor", "cie_fluorescent_1nm/FL11"),
    ("TL84", "lamps_rit/Philips TL-84"),
    ("street lamp", "cie_hp_5nm/HP1"),
    ("street light", "cie_hp_5nm/HP1"),
    ("high pressure sodium", "cie_hp_5nm/HP1"),
    ("sodium", "lamps_nist_traditional/LPS"),
    ("low-pressure sodium", "lamps_nist_traditional/LPS"),
    ("mercury", "lamps_nist_traditional/Mercury"),
    ("mercury vapour", "lamps_nist_traditional/Mercury"),
    ("metal halide", "cie_hp_5nm/HP4"),
    ("stadium", "cie_hp_5nm/HP4"),
    ("scandium", "lamps_nist_traditional/Metal Halide"),
    ("xenon", "lamps_common/Kinoton 75P"),
    ("projector", "lamps_common/Kinoton 75P"),
    ("neodymium", "lamps_nist_traditional/Neodimium Incandescent"),
    ("neon", "line_tubes/Neon tube"),
    ("neon sign", "line_tubes/Neon tube"),
    ("helium", "line_tubes/Helium tube"),
    ("hydrogen", "line_tubes/Hydrogen tube"),
    ("argon", "line_tubes/Argon tube"),
    ("cadmium", "line_tubes/Cadmium tube"),
    ("laser", "laser_lines/Helium-neon laser"),
    ("green laser", "laser_lines/Green laser pointer"),
    ("gel", "stage_gels/Straw gel"),
    ("amber", "stage_gels/Amber gel"),
    ("theatre gel", "stage_gels/Red gel"),
    ("cto", "stage_gels/Warming gel 5600 K to 3200 K"),
    ("red filter", "ideal_filters/Ideal long-pass 600 nm"),
    (
        "green filter",
        "filters_glass_cc0/isuzu IVG530 (Green filter) 2 mm",
    ),
    (
        "blue filter",
        "filters_glass_cc0/isuzu IVB490 (Blue filter) 2 mm",
    ),
    ("notch", "ideal_filters/Ideal notch 532 nm, 20 nm wide"),
    ("skin", "everyday_surfaces/Skin, light"),
    ("leaf", "everyday_surfaces/Leaf"),
    ("leaves", "everyday_surfaces/Leaf"),
    ("flowers", "everyday_surfaces/Flower, blue"),
    ("brick", "everyday_surfaces/Brick, grey paving"),
    ("soil", "everyday_surfaces/Rangeland, plants on soil"),
    ("gold", "everyday_surfaces/Gold"),
    ("mirror", "metals_refractiveindex/Ag (Johnson)"),
    (
        "holmium",
        "usgs_splib07/Holmium oxide powder (USGS splib07a Record 18789)",
    ),
];

#[test]
fn what_a_teacher_or_a_designer_types_finds_first_what_is_meant() {
    assert_eq!(wrong(&ASKED), [""; 0]);
}

#[test]
fn a_word_of_many_lamps_finds_them_all() {
    let index = index();
    let keys = |typed: &str| -> BTreeSet<String> {
        index
            .search(typed)
            .iter()
            .map(|row| row.entry.key.clone())
            .collect()
    };
    let sodium = keys("sodium");
    for key in [
        "cie_hp_5nm/HP1",
        "lamps_nist_traditional/HPS",
        "lamps_nist_traditional/LPS",
        "paper/Sodium",
        "line_tubes/Sodium tube",
    ] {
        assert!(sodium.contains(key), "{key}");
    }
    let high = keys("high pressure");
    assert!(
        high.contains("cie_hp_5nm/HP1") && high.contains("lamps_nist_philips/H38HT-100 (Mercury)")
    );
    assert!(keys("street lamp").contains("lamps_nist_traditional/LPS"));
    let gels = index.search("gel");
    let filters = gels.iter().filter(|row| row.entry.kind().is_factor());
    assert_eq!(
        filters.count(),
        gels.len(),
        "gels are filters, and no spruce"
    );
    assert!(keys("europium").len() > 10);
}

#[test]
fn nothing_is_a_dead_end_for_a_typing_error_and_nonsense_is_one() {
    let asked = [
        ("tungten", "cie_illuminants/CIE A"),
        ("sodum", "lamps_nist_traditional/LPS"),
        ("flourescent", "cie_fluorescent_1nm/FL2"),
        ("neodimium", "lamps_nist_traditional/Neodimium Incandescent"),
        // Two letters exchanged, and an error in one of several words.
        ("candel", "thermal_lights/Candle flame"),
        ("stret lamp", "cie_hp_5nm/HP1"),
        ("flourescent ofice", "cie_fluorescent_1nm/FL2"),
    ];
    assert_eq!(wrong(&asked), [""; 0]);
    let index = index();
    assert!(index.search("qqqqqqqq").is_empty());
    assert!(index.search("sodium qqqqqqqq").is_empty());
}

#[test]
fn a_name_finds_its_own_spectrum_first_whatever_its_letters() {
    let asked = [
        ("FL11", "cie_fluorescent_1nm/FL11"),
        ("fl3.11", "cie_fluorescent_1nm/FL3.11"),
        ("led-b5", "cie_led_1nm/LED-B5"),
        ("hp3", "cie_hp_5nm/HP3"),
        ("VS14", "nist_cqs_vs/NIST CQS 7.4: VS14"),
        ("F34T12/LW/RS/EW", "lamps_nist_philips/F34T12/LW/RS/EW"),
        ("dark skin", "colorchecker_ohta/dark skin"),
    ];
    assert_eq!(wrong(&asked), [""; 0]);
}

#[test]
fn twins_are_one_row() {
    let entries = bundled_entries();
    let rows = fold(entries);
    assert_eq!(rows.len() + 27 + 9 + 3, entries.len());
    let fl2 = rows
        .iter()
        .find(|row| row.entry.key == "cie_fluorescent_1nm/FL2")
        .unwrap();
    let twins: Vec<&str> = fl2.twins.iter().map(|twin| twin.key.as_str()).collect();
    assert_eq!(twins, ["cie_fluorescent_5nm/FL2"]);
    // By the coarse table's name its row is found.
    let found = index().search("cie_fluorescent_5nm/FL2");
    assert_eq!(found[0].entry.key, "cie_fluorescent_1nm/FL2");
    // A coarse table alone is a row.
    let alone = entries
        .iter()
        .filter(|e| e.key == "cie_fluorescent_5nm/FL2");
    assert_eq!(fold(alone).len(), 1);
}

#[test]
fn favourites_are_twelve_and_their_labels_find_them() {
    let entries = bundled_entries();
    let favourites = favourites(entries);
    assert_eq!(favourites.len(), 12);
    let index = index();
    for favourite in favourites {
        let found = index.search(favourite.label);
        assert_eq!(
            found[0].entry.key, favourite.entry.key,
            "{}",
            favourite.label
        );
    }
}

#[test]
fn nothing_typed_is_the_whole_library_in_its_order() {
    let entries = bundled_entries();
    assert_eq!(index().search("  "), fold(entries));
}

#[test]
fn a_temperature_finds_the_white_lights_near_it_the_nearest_first() {
    let index = index();
    for kelvin in [2700.0, 4000.0, 6500.0] {
        for typed in [format!("{kelvin} K"), format!("{kelvin}k")] {
            let found = index.search(&typed);
            assert!(found.len() > 3, "{typed}: {}", found.len());
            let off: Vec<f64> = found
                .iter()
                .map_while(|row| Some((known::kelvin(&row.entry)? - kelvin).abs()))
                .take_while(|off| *off <= 150.0)
                .collect();
            assert!(off.len() > 3 && off.is_sorted(), "{typed}: {off:?}");
        }
    }
    let first = &index.search("6500 K")[0].entry;
    assert!(
        (known::kelvin(first).unwrap() - 6500.0).abs() < 20.0,
        "{}",
        first.key
    );
    // Among words, and without its unit behind what is called so.
    let leds = index.search("LED 2700 K");
    assert!(leds[0].entry.key.contains("led"), "{}", leds[0].entry.key);
    let polylux = index.search("4000");
    assert_eq!(polylux[0].entry.key, "lamps_rit/T8 Polylux 4000");
    assert!(polylux.len() > 5, "{}", polylux.len());
    // A name with a temperature in it is a name.
    let named = index.search("Black body 3000 K");
    assert_eq!(named[0].entry.key, "thermal_lights/Black body 3000 K");
}

#[test]
fn a_figure_finds_the_lights_that_reach_it() {
    let index = index();
    let ra = |row: &Folded| Indices::of(&row.entry).get(Figure::Ra);
    for typed in ["Ra 90", "cri 90", "CRI>=90"] {
        let found = index.search(typed);
        let reached = found
            .iter()
            .take_while(|row| ra(row).is_some_and(|ra| ra.round() >= 90.0));
        let all = index
            .rows
            .iter()
            .filter(|(row, _)| ra(row).is_some_and(|ra| ra.round() >= 90.0));
        assert_eq!(reached.count(), all.count(), "{typed}");
        assert!(ra(&found[0]).is_some_and(|ra| ra < 93.0), "{typed}");
    }
    let led = index.search("led ra 90");
    assert!(!led.is_empty());
    for row in &led {
        assert!(
            ra(row).is_some_and(|ra| ra.round() >= 90.0),
            "{}",
            row.entry.key
        );
    }
}

#[test]
fn a_german_french_or_spanish_word_finds_what_its_english_finds() {
    let index = index();
    let mut off = Vec::new();
    for (word, english) in foreign::table() {
        let (found, expected) = (index.search(word), index.search(english));
        let [found, expected] =
            [&found, &expected].map(|rows| rows.first().map(|row| row.entry.key.as_str()));
        if found != expected || expected.is_none() {
            off.push(format!("{word}: {found:?}, {english}: {expected:?}"));
        }
    }
    assert!(off.is_empty(), "{}", off.join("\n"));
    let asked = [
        ("Kerze", "thermal_lights/Candle flame"),
        ("gluehbirne", "cie_illuminants/CIE A"),
        ("Energiesparlampe", "cie_fluorescent_1nm/FL12"),
        ("soleil", "solar_astm_g173/ASTM G173-03 global tilt AM1.5G"),
        ("lampe à sodium", "lamps_nist_traditional/LPS"),
        ("farola", "cie_hp_5nm/HP1"),
        ("piel", "everyday_surfaces/Skin, light"),
        // Not typed to its end, and with an error.
        ("Quecks", "lamps_nist_traditional/Mercury"),
        ("Quekcsilber", "lamps_nist_traditional/Mercury"),
    ];
    assert_eq!(wrong(&asked), [""; 0]);
}
