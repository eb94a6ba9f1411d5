//! The shipped spectra, found by name.
//!
//! Each group says where its numbers come from and under which licence they stand. Beside the
//! groups of the shipped files stand those that are made (`made`).

use std::{borrow::Cow, fmt, sync::LazyLock};

use super::made;
use crate::{
    preset::{self, Body, Group, Preset},
    spectrum::{Kind, NamedSpectrum},
};

/// Most names that an error offers instead of an unknown one.
const MOST_SUGGESTIONS: usize = 3;

/// Names of earlier versions, by which files and people still ask: of skins, which are named by
/// their tone now.
const FORMER: [[&str; 2]; 6] = [
    ["pmc_chart/Caucasian", "pmc_chart/Skin tone 1"],
    ["pmc_chart/Oriental", "pmc_chart/Skin tone 2"],
    ["pmc_chart/South Asian", "pmc_chart/Skin tone 3"],
    ["pmc_chart/African", "pmc_chart/Skin tone 4"],
    [
        "everyday_surfaces/Skin, East Asian",
        "everyday_surfaces/Skin, medium light",
    ],
    [
        "everyday_surfaces/Skin, South Asian",
        "everyday_surfaces/Skin, medium",
    ],
];

/// What a name of an earlier version, plain or as `group/name`, stands for now as `group/name`.
pub(super) fn now_called(name: &str) -> Option<&'static str> {
    let is_it = |former: &str| {
        let plain = former.split_once('/').map_or(former, |(_, plain)| plain);
        [former, plain].iter().any(|f| f.eq_ignore_ascii_case(name))
    };
    let found = FORMER.iter().find(|[former, _]| is_it(former));
    found.map(|[_, now]| *now)
}

/// All shipped spectra, composites and lines.
#[derive(Clone, Debug)]
pub struct Library {
    groups: Vec<&'static Group>,
    made: Vec<Group>,
    lines: Vec<ElementLine>,
}

/// A line that can name a spike.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementLine {
    /// Symbol of its element, such as "Hg".
    pub element: String,
    /// Place in air, nm.
    pub at_nm: f64,
    /// Strength, comparable within the element only and not radiometric (NIST's are only
    /// qualitative); 0 where unknown.
    pub strength: f64,
}

/// Why a name does not stand for one shipped spectrum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FindError {
    /// Nothing is called that.
    Unknown {
        /// What was asked for.
        name: String,
        /// At most three names that come close, the closest first.
        suggestions: Vec<String>,
    },
    /// Several items are called that.
    Ambiguous {
        /// What was asked for.
        name: String,
        /// All of them as `group/name`.
        choices: Vec<String>,
    },
    /// A list of spectral lines is called that.
    Lines { name: String },
    /// A whole group is called that.
    Group { name: String, items: usize },
}

impl fmt::Display for FindError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name, suggestions } => {
                write!(f, "no shipped spectrum is called \"{name}\"")?;
                if suggestions.is_empty() {
                    return Ok(());
                }
                write!(f, "; close to it: {}", suggestions.join(", "))
            }
            Self::Ambiguous { name, choices } => {
                write!(f, "\"{name}\" stands for several: {}", choices.join(", "))
            }
            Self::Lines { name } => write!(
                f,
                "\"{name}\" is a list of spectral lines that names spikes, not a spectrum"
            ),
            Self::Group { name, items } => write!(
                f,
                "\"{name}\" is a group of {items}: expected {name}/NAME for one of them"
            ),
        }
    }
}

impl std::error::Error for FindError {}

static BUNDLED: LazyLock<Library> = LazyLock::new(|| {
    let groups: Vec<&'static Group> = preset::groups().collect();
    Library {
        made: made::groups(),
        lines: element_lines(&groups),
        groups,
    }
});

impl Library {
    /// The spectra that are part of the program, read at the first call (5 ms, once).
    pub fn bundled() -> &'static Self {
        &BUNDLED
    }

    /// The groups of tables, lights first: what studies speak of.
    pub fn groups(&self) -> &[&'static Group] {
        &self.groups
    }

    /// All groups: those of tables, then those that are made.
    pub fn all_groups(&self) -> impl Iterator<Item = &Group> {
        self.groups.iter().copied().chain(&self.made)
    }

    /// The group with an id, made or not.
    pub fn group(&self, id: &str) -> Option<&Group> {
        self.all_groups().find(|group| group.id == id)
    }

    /// All items that can be found, group by group, those that are made last.
    pub fn everything(&self) -> impl Iterator<Item = &Preset> {
        self.all_groups().flat_map(|group| &group.items)
    }

    /// All items of the groups of tables, group by group.
    pub fn presets(&self) -> impl Iterator<Item = &Preset> {
        self.groups.iter().flat_map(|group| &group.items)
    }

    /// All tables, of every kind.
    pub fn spectra(&self) -> impl Iterator<Item = &NamedSpectrum> {
        self.presets().filter_map(Preset::spectrum)
    }

    /// All lines of known elements, by rising wavelength, for naming spikes.
    pub fn lines(&self) -> &[ElementLine] {
        &self.lines
    }

    /// The spectrum or composite with a name, either plain or as `group/name`.
    ///
    /// Exact spelling goes before spelling that differs in capitals. A plain name that stands in
    /// a 5 nm and a 1 nm table of the same family means the 1 nm one.
    ///
    /// # Errors
    /// [`FindError`] when the name is unknown, stands for several items, for a whole group or for
    /// a list of lines.
    pub fn find(&self, name: &str) -> Result<&Preset, FindError> {
        let asked = name.trim();
        let lower = asked.to_lowercase();
        let exact = self.called(|preset| preset.name == asked || preset.id() == asked);
        let found = if exact.is_empty() {
            self.called(|preset| {
                preset.name.to_lowercase() == lower || preset.id().to_lowercase() == lower
            })
        } else {
            exact
        };
        if let (true, Some(now)) = (found.is_empty(), now_called(asked)) {
            return self.find(now);
        }
        match found[..] {
            // People leave out the CIE: D65 is "CIE D65".
            [] if !lower.starts_with("cie ") => self
                .find(&format!("CIE {asked}"))
                .map_err(|_| self.not_found(asked, &lower)),
            [] => Err(self.not_found(asked, &lower)),
            [preset] if matches!(preset.body, Body::Lines(_)) => {
                Err(FindError::Lines { name: asked.into() })
            }
            [preset] => Ok(preset),
            _ => Err(FindError::Ambiguous {
                name: asked.into(),
                choices: found.iter().map(|preset| preset.id()).collect(),
            }),
        }
    }

    /// The same, and what is made when it is asked for: an ideal filter at any place, a black body
    /// of any temperature.
    ///
    /// # Errors
    /// [`FindError`] as for [`find`](Self::find).
    pub fn find_or_make(&self, name: &str) -> Result<Cow<'_, Preset>, FindError> {
        self.find(name)
            .map(Cow::Borrowed)
            .or_else(|why| made::on_demand(name).map(Cow::Owned).ok_or(why))
    }

    /// Whether a name stands for something in the library.
    pub fn knows(&self, name: &str) -> bool {
        self.find_or_make(name).is_ok()
    }

    fn called(&self, is_it: impl Fn(&Preset) -> bool) -> Vec<&Preset> {
        let all: Vec<&Preset> = self.everything().filter(|preset| is_it(preset)).collect();
        all.iter()
            .copied()
            .filter(|preset| {
                let finer = preset
                    .group
                    .strip_suffix("_5nm")
                    .map(|family| format!("{family}_1nm"));
                !all.iter().any(|other| Some(&other.group) == finer.as_ref())
            })
            .collect()
    }

    fn not_found(&self, asked: &str, lower: &str) -> FindError {
        match self.group(lower) {
            Some(group) if group.kind == Kind::Lines => FindError::Lines { name: asked.into() },
            Some(group) => FindError::Group {
                name: group.id.clone(),
                items: group.items.len(),
            },
            None => FindError::Unknown {
                name: asked.into(),
                suggestions: self.suggestions(lower),
            },
        }
    }

    fn suggestions(&self, lower: &str) -> Vec<String> {
        if lower.is_empty() {
            return Vec::new();
        }
        let mut ranked: Vec<(usize, String)> = Vec::new();
        for preset in self.everything() {
            if matches!(preset.body, Body::Lines(_)) {
                continue;
            }
            let plain = preset.name.to_lowercase();
            let full = preset.id().to_lowercase();
            let Some(rank) = [closeness(lower, &plain), closeness(lower, &full)]
                .into_iter()
                .flatten()
                .min()
            else {
                continue;
            };
            // A name that would be ambiguous itself is offered with its group.
            let offer = match self.called(|other| other.name == preset.name).len() {
                1 => preset.name.clone(),
                _ => preset.id(),
            };
            if !ranked.iter().any(|(_, other)| *other == offer) {
                ranked.push((rank, offer));
            }
        }
        ranked.sort_by_key(|(rank, _)| *rank);
        ranked.truncate(MOST_SUGGESTIONS);
        ranked.into_iter().map(|(_, offer)| offer).collect()
    }
}

fn element_lines(groups: &[&Group]) -> Vec<ElementLine> {
    let lists = groups
        .iter()
        .flat_map(|group| &group.items)
        .filter_map(Preset::line_list);
    let mut lines = Vec::new();
    for list in lists {
        let Some(element) = &list.element else {
            continue;
        };
        lines.extend(list.lines.iter().map(|line| ElementLine {
            element: element.clone(),
            at_nm: line.at_nm,
            strength: line.strength.unwrap_or(0.0),
        }));
    }
    lines.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
    lines
}

/// How far a name is from what was asked for, both in lower case; none when too far to be meant.
///
/// A name of which it is a whole word comes first, then one that holds it anywhere, the shorter
/// the better; hyphens and blanks do not count. Otherwise the number of typing errors decides, of
/// which a third of the letters may be.
fn closeness(asked: &str, name: &str) -> Option<usize> {
    const INSIDE_A_WORD: usize = 1000;
    const TYPING_ERROR: usize = 10_000;
    let joined = |text: &str| text.replace(['-', '_', ' '], "");
    let (short, long) = (joined(asked), joined(name));
    if !short.is_empty() && long.contains(&short) {
        let whole_word = name.split_whitespace().any(|word| word == asked);
        let place = if whole_word { 0 } else { INSIDE_A_WORD };
        return Some(place + long.len() - short.len());
    }
    let errors = strsim::levenshtein(asked, name);
    (errors <= asked.chars().count() / 3).then_some(errors * TYPING_ERROR)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::preset::{OpticalConstants, Shelf};

    fn id_of(name: &str) -> String {
        match Library::bundled().find(name) {
            Ok(preset) => preset.id(),
            Err(error) => panic!("{error}"),
        }
    }

    fn refusal(name: &str) -> FindError {
        Library::bundled().find(name).expect_err(name)
    }

    fn suggestions(name: &str) -> Vec<String> {
        match refusal(name) {
            FindError::Unknown { suggestions, .. } => suggestions,
            other => panic!("{other}"),
        }
    }

    #[test]
    fn each_group_holds_as_many_items_as_its_source() {
        let counts: BTreeMap<_, _> = Library::bundled()
            .groups()
            .iter()
            .map(|group| (group.id.as_str(), group.items.len()))
            .collect();
        let expected = BTreeMap::from([
            ("aces_training_190", 190),
            ("atomic_lines", 16),
            ("cie_fluorescent_1nm", 27),
            ("cie_fluorescent_5nm", 27),
            ("cie_hp_5nm", 5),
            ("cie_illuminants", 13),
            ("cie_led_1nm", 9),
            ("cie_led_5nm", 9),
            ("colorchecker_ohta", 24),
            ("cri_tcs", 29),
            ("filters_glass_cc0", 32),
            ("lamps_common", 1),
            ("lamps_nist_led", 15),
            ("lamps_nist_philips", 22),
            ("lamps_nist_traditional", 10),
            ("lamps_rit", 8),
            ("metals_refractiveindex", 19),
            ("nist_cqs_vs", 30),
            ("observers", 25),
            ("paper", 3),
            ("pmc_chart", 30),
            ("solar_astm_g173", 3),
            ("tm30_ces99_5nm", 99),
            ("usgs_splib07", 18),
        ]);
        assert_eq!(counts, expected);
    }

    #[test]
    fn each_group_and_item_states_source_licence_and_changes() {
        for group in Library::bundled().all_groups() {
            for text in [
                &group.title,
                &group.source,
                &group.licence.id,
                &group.licence.words,
                &group.attribution,
                &group.changes,
            ] {
                assert!(!text.trim().is_empty(), "{}", group.id);
            }
            for preset in &group.items {
                assert!(!preset.source.is_empty() && !preset.licence.id.is_empty());
                assert!(!preset.unit.is_empty(), "{}", preset.id());
            }
        }
    }

    #[test]
    fn groups_of_the_cie_name_the_cie_title_doi_and_changes() {
        let mut seen = 0;
        for group in Library::bundled().groups() {
            if group.licence.id != "CC-BY-SA-4.0" {
                continue;
            }
            seen += 1;
            for part in [
                "International Commission on Illumination",
                "https://doi.org/10.25039/CIE.DS.",
                "https://creativecommons.org/licenses/by-sa/4.0/",
                ": \"",
            ] {
                assert!(group.attribution.contains(part), "{}: {part}", group.id);
            }
            assert!(group.changes.contains("Converted"), "{}", group.id);
            for preset in &group.items {
                let own = preset.licence.id == "CC-BY-SA-4.0";
                let cited = preset
                    .source
                    .contains("International Commission on Illumination")
                    && (preset.source.contains("DOI 10.25039/CIE.DS.")
                        || preset.source == group.source);
                assert!(cited || !own, "{}: {}", preset.id(), preset.source);
                // Every DOI that an item names is in the group's attribution, with its title.
                for doi in preset.source.split("DOI ").skip(1) {
                    let doi: String = doi
                        .chars()
                        .take_while(|c| c.is_alphanumeric() || "./".contains(*c))
                        .collect();
                    assert!(group.attribution.contains(&doi), "{}: {doi}", preset.id());
                }
            }
        }
        assert_eq!(seen, 7);
    }

    #[test]
    fn a_plain_name_and_a_full_one_find_the_same() {
        for (name, id) in [
            ("CIE D65", "cie_illuminants/CIE D65"),
            ("cie_illuminants/CIE D65", "cie_illuminants/CIE D65"),
            (" cie d65 ", "cie_illuminants/CIE D65"),
            ("CIE_Illuminants/cie d65", "cie_illuminants/CIE D65"),
            // Exact capitals go before others.
            ("magenta", "colorchecker_ohta/magenta"),
            ("Magenta", "pmc_chart/Magenta"),
            // A name in a 1 nm and a 5 nm table means the 1 nm one.
            ("FL11", "cie_fluorescent_1nm/FL11"),
            ("led-b3", "cie_led_1nm/LED-B3"),
            ("cie_led_5nm/LED-B3", "cie_led_5nm/LED-B3"),
            // A standard light is found without its CIE, after what has the very name: SC is a lamp
            // of the RIT.
            ("D65", "cie_illuminants/CIE D65"),
            ("d65", "cie_illuminants/CIE D65"),
            ("A", "cie_illuminants/CIE A"),
            ("SC", "lamps_rit/SC"),
        ] {
            assert_eq!(id_of(name), id);
        }
        assert!(matches!(refusal("MAGENTA"), FindError::Ambiguous { .. }));
    }

    #[test]
    fn slashes_in_names_are_part_of_the_name() {
        for name in ["60 A/W (Soft White)", "F32T8/TL830 (Triphosphor)"] {
            let id = format!("lamps_nist_philips/{name}");
            assert_eq!(id_of(name), id);
            assert_eq!(id_of(&id), id);
        }
    }

    #[test]
    fn every_item_is_found_by_its_full_name() {
        for preset in Library::bundled().everything() {
            match Library::bundled().find(&preset.id()) {
                Ok(found) => assert_eq!(found.id(), preset.id()),
                Err(FindError::Lines { .. }) => assert!(preset.line_list().is_some()),
                Err(error) => panic!("{error}"),
            }
        }
    }

    #[test]
    fn skins_are_named_by_their_tone_and_found_by_their_former_names() {
        for [former, now] in FORMER {
            assert_eq!(id_of(former), now);
            let plain = former.split_once('/').expect("a group").1;
            assert_eq!(id_of(plain), now);
            let entry = crate::app::App::new().entry(former).expect(former);
            assert_eq!(entry.key, now);
        }
        let peoples = ["caucasian", "oriental", "asian", "african", "japanese"];
        for preset in Library::bundled().everything() {
            let said = format!("{} {}", preset.id(), preset.notes.join(" ")).to_lowercase();
            // The title of the CIE's data set is quoted as its source, which is no name.
            let names = peoples.iter().filter(|people| said.contains(**people));
            let is_quoted = said.starts_with("cri_tcs/cie 2024");
            assert!(is_quoted || names.count() == 0, "{said}");
        }
    }

    #[test]
    fn an_ambiguous_name_lists_the_choices() {
        assert_eq!(
            refusal("Mercury").to_string(),
            "\"Mercury\" stands for several: lamps_nist_traditional/Mercury, paper/Mercury"
        );
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_closest() {
        assert!(suggestions("CIE D66").contains(&"CIE D65".to_owned()));
        assert_eq!(suggestions("TL84")[0], "Philips TL-84");
        assert_eq!(
            refusal("Kinoten 75P").to_string(),
            "no shipped spectrum is called \"Kinoten 75P\"; close to it: Kinoton 75P"
        );
        assert_eq!(
            suggestions("mercuri")[..2],
            ["lamps_nist_traditional/Mercury", "paper/Mercury"]
        );
        let far = refusal("qqqqqqqqqqqqqqq").to_string();
        assert_eq!(far, "no shipped spectrum is called \"qqqqqqqqqqqqqqq\"");
        assert!(matches!(refusal(""), FindError::Unknown { .. }));
    }

    #[test]
    fn lines_and_groups_are_refused_in_words() {
        for name in ["Hg I lines", "atomic_lines/Hg I lines", "atomic_lines"] {
            let said = refusal(name).to_string();
            assert!(said.contains("spectral lines"), "{said}");
        }
        assert_eq!(
            refusal("paper").to_string(),
            "\"paper\" is a group of 3: expected paper/NAME for one of them"
        );
    }

    #[test]
    fn lines_rise_and_know_their_element() {
        let lines = Library::bundled().lines();
        assert!(lines.windows(2).all(|pair| pair[0].at_nm <= pair[1].at_nm));
        let green = lines
            .iter()
            .find(|line| line.element == "Hg" && line.at_nm == 546.075);
        assert_eq!(green.map(|line| line.strength), Some(6000.0));
        let elements: std::collections::BTreeSet<_> =
            lines.iter().map(|line| line.element.as_str()).collect();
        let expected = [
            "Ar", "Cd", "Dy", "H", "He", "Hg", "In", "K", "Kr", "Li", "Na", "Ne", "Sc", "Tl", "Xe",
        ];
        assert!(elements.into_iter().eq(expected));
        let lists = Library::bundled().presets().filter_map(Preset::line_list);
        assert_eq!(lists.count(), 16);
    }

    #[test]
    fn shelves_follow_the_lamp_and_not_the_file() {
        let shelf = |name: &str| Library::bundled().find(name).expect(name).shelf;
        for (name, expected) in [
            ("lamps_nist_traditional/Mercury", Shelf::Discharge),
            ("Cool White FL", Shelf::Fluorescent),
            ("Incandescent", Shelf::Standard),
            ("60 A/W (Soft White)", Shelf::Standard),
            ("SDW-T 100W/LV (Super HPS)", Shelf::Discharge),
            ("Philips TL-84", Shelf::Fluorescent),
            ("SC", Shelf::Standard),
            ("CIE L41", Shelf::Led),
            ("HP1", Shelf::Discharge),
            ("Sodium", Shelf::Paper),
            ("ASTM G173-03 extraterrestrial", Shelf::Sun),
            ("Au (Johnson)", Shelf::Reflectances),
        ] {
            assert_eq!(shelf(name), expected, "{name}");
        }
        for shelf in Shelf::ALL {
            assert!(
                Library::bundled()
                    .presets()
                    .any(|preset| preset.shelf == shelf)
            );
        }
    }

    #[test]
    fn daylight_components_are_not_offered_as_lights() {
        for n in 0..3 {
            let name = format!("CIE daylight component S{n}");
            let preset = Library::bundled().find(&name).expect("a component");
            assert_eq!(preset.kind, Kind::Other);
        }
        for spectrum in Library::bundled().spectra() {
            let dark = spectrum.samples.values().iter().any(|v| *v < 0.0);
            assert!(!dark || spectrum.kind == Kind::Other, "{}", spectrum.name);
        }
    }

    #[test]
    fn the_papers_lamps_are_as_printed() {
        let lamp = |name: &str| {
            let preset = Library::bundled().find(&format!("paper/{name}"));
            preset.expect(name).composite().expect(name)
        };
        let c = lamp("Source C");
        assert_eq!(c.a, [199., -5., -8., -7., -2., -4.]);
        assert_eq!(c.b, [16., 5., -3., 1., -1.]);
        assert!(c.spikes.is_empty());
        let hg = lamp("Mercury");
        assert_eq!(hg.a, [69., 2., 12., -6., 1., -1.]);
        assert_eq!(hg.b, [2., 14., 2., 5., 0.]);
        let spikes: Vec<_> = hg.spikes.iter().map(|s| (s.at_nm, s.weight)).collect();
        let printed = [
            (404.7, 5.1),
            (435.8, 10.4),
            (491.6, 0.3),
            (546.1, 13.7),
            (577.8, 19.3),
            (693.8, 2.3),
        ];
        assert_eq!(spikes, printed);
        assert_eq!((hg.range_nm, hg.weight_factor), ([400.0, 700.0], 300.0));
        // The reading chosen: the lines carry 60 % of the lamp's power.
        let lines: f64 = hg.spikes_in_unit_nm().map(|(_, weight)| weight).sum();
        let smooth = hg.a[0] / 2.0 * 300.0;
        let share = lines / (lines + smooth);
        assert!((share - 0.6).abs() < 0.01, "{share}");
        let na = lamp("Sodium");
        assert!(na.a.iter().all(|a| *a == 0.0));
        assert_eq!((na.spikes[0].at_nm, na.spikes[0].weight), (589.0, 31.95));
    }

    #[test]
    fn metals_keep_n_and_k_from_which_their_reflectance_follows() {
        for preset in &Library::bundled()
            .group("metals_refractiveindex")
            .expect("metals")
            .items
        {
            let OpticalConstants { n, k } = preset.optical.as_ref().expect("n and k");
            let table = preset.spectrum().expect("a table");
            for ((n, k), r) in n.iter().zip(k).zip(table.samples.values()) {
                let fresnel = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
                // n, k and the reflectance are each rounded to six figures (measured: 2e-6).
                assert!((fresnel - r).abs() < 1e-5, "{}: {fresnel} {r}", preset.name);
            }
        }
    }
}
