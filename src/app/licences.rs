//! Under which terms the program, its data and its fonts may be passed on.

use std::{collections::BTreeMap, fmt::Write as _, sync::LazyLock};

use super::library::Library;
use crate::preset::{self, Group};

/// A licence or notice in full.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Licence {
    /// SPDX id, or the file's name in `LICENSES/` where there is no id.
    pub id: &'static str,
    /// What it covers here, in a line.
    pub title: &'static str,
    /// The full text.
    pub text: &'static str,
}

static ALL: [Licence; 9] = [
    Licence {
        id: "MIT",
        title: later!(
            "MIT License: the program's own code (at choice), and the resampled USGS spectra"
        ),
        text: include_str!("../../LICENSES/MIT.txt"),
    },
    Licence {
        id: "Apache-2.0",
        title: later!(
            "Apache License 2.0: the program's own code (at choice), and the 190 AMPAS \
             reflectances"
        ),
        text: include_str!("../../LICENSES/Apache-2.0.txt"),
    },
    Licence {
        id: "CC-BY-SA-4.0",
        title: later!("Creative Commons Attribution-ShareAlike 4.0: the CIE's tables"),
        text: include_str!("../../LICENSES/CC-BY-SA-4.0.txt"),
    },
    Licence {
        id: "BSD-3-Clause",
        title: later!("BSD 3-Clause: tables from colour-science, pvlib and rascal"),
        text: include_str!("../../LICENSES/BSD-3-Clause.txt"),
    },
    Licence {
        id: "CC0-1.0",
        title: later!("Creative Commons Zero 1.0: metals and filter glasses"),
        text: include_str!("../../LICENSES/CC0-1.0.txt"),
    },
    Licence {
        id: "DejaVu-Fonts",
        title: later!("Bitstream Vera and Arev licences: the font DejaVu Sans"),
        text: include_str!("../../LICENSES/DejaVu-Fonts.txt"),
    },
    Licence {
        id: "Ubuntu-font-1.0",
        title: later!("Ubuntu Font Licence 1.0: the font Ubuntu Light"),
        text: include_str!("../../LICENSES/Ubuntu-font-1.0.txt"),
    },
    Licence {
        id: "Hack-Fonts",
        title: later!("MIT and Bitstream Vera licences: the font Hack"),
        text: include_str!("../../LICENSES/Hack-Fonts.txt"),
    },
    Licence {
        id: "egui-icons",
        title: later!("MIT License: the icon font of the window toolkit"),
        text: include_str!("../../LICENSES/egui-icons.txt"),
    },
];

/// Width of the rules between the parts, characters.
const RULE: usize = 78;

/// Every licence text that travels with the program.
pub fn all() -> &'static [Licence] {
    &ALL
}

/// What is under which licence: the code, each group of spectra, the fonts.
pub fn overview(library: &Library) -> String {
    let mut out = String::from(
        "Spectral Explorer\n\
         Copyright 2026 The Spectral Explorer developers\n\
         The program's own code: MIT OR Apache-2.0, at your choice.\n\
         The shipped spectra are data files with terms of their own:\n",
    );
    for group in library.all_groups() {
        out += &of_group(group);
    }
    out += &OF_UNLISTED;
    out.push_str("\nFonts in the window:\n");
    for licence in &ALL[5..] {
        let _ = writeln!(out, "  {}", licence.title);
    }
    out
}

/// The tables that no library lists: read once, since a dialog shows the overview in every frame.
static OF_UNLISTED: LazyLock<String> = LazyLock::new(|| preset::unlisted().map(of_group).collect());

/// Where a group comes from and under which terms it stands.
fn of_group(group: &Group) -> String {
    let mut out = String::new();
    let _ = write!(
        out,
        "\n{id}: {title}\n  licence: {licence}\n  source: {source}\n  attribution: {attribution}\n  changes: {changes}\n",
        id = group.id,
        title = group.title,
        licence = group.licence,
        source = group.source,
        attribution = group.attribution,
        changes = group.changes,
    );
    let mut others: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for item in &group.items {
        if item.licence != group.licence {
            let names = others.entry(item.licence.to_string()).or_default();
            names.push(&item.name);
        }
    }
    for (other, names) in others {
        let _ = writeln!(out, "  otherwise: {}: {other}", names.join(", "));
    }
    out
}

/// The overview and every licence in full, as `--licences` prints them.
pub fn text(library: &Library) -> String {
    let mut out = overview(library);
    for Licence { id, title, text } in all() {
        let rule = "=".repeat(RULE);
        let _ = write!(
            out,
            "\n{rule}\n{id}\n{title}\n{rule}\n\n{}\n",
            text.trim_end()
        );
    }
    out
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_licence_that_an_item_names_is_there_in_full() {
        let ids: BTreeSet<&str> = all().iter().map(|licence| licence.id).collect();
        assert_eq!(ids.len(), all().len(), "ids are unique");
        for preset in Library::bundled().everything() {
            for id in preset.licence.id.split(" AND ") {
                // A LicenseRef of ours says that nobody holds rights: there is no text.
                let is_there = ids.contains(id) || id.starts_with("LicenseRef-");
                assert!(is_there, "{}: {id}", preset.id());
            }
        }
    }

    #[test]
    fn the_texts_are_complete_from_their_first_to_their_last_words() {
        for (id, first, last) in [
            (
                "MIT",
                "Permission is hereby granted",
                "DEALINGS IN THE\nSOFTWARE.",
            ),
            (
                "Apache-2.0",
                "Apache License",
                "limitations under the License.",
            ),
            (
                "CC-BY-SA-4.0",
                "Attribution-ShareAlike 4.0",
                "creativecommons.org.",
            ),
            (
                "BSD-3-Clause",
                "Copyright 2013 Colour Developers",
                "SUCH DAMAGE.",
            ),
            ("CC0-1.0", "CC0 1.0 Universal", "use of the Work."),
            (
                "DejaVu-Fonts",
                "Bitstream Vera Fonts Copyright",
                "tavmjong @ free\n. fr.",
            ),
            (
                "Ubuntu-font-1.0",
                "UBUNTU FONT LICENCE Version 1.0",
                "SOFTWARE.",
            ),
            ("Hack-Fonts", "Source Foundry Authors", "gnome dot org."),
            ("egui-icons", "John Slegers", "SOFTWARE."),
        ] {
            let licence = all().iter().find(|l| l.id == id).expect(id);
            assert!(licence.text.contains(first), "{id}");
            let in_a_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            let (text, last) = (in_a_line(licence.text), in_a_line(last));
            let end = &text[text.len() - 60..];
            assert!(text.ends_with(&last), "{id} ends in {end}");
        }
        let by_sa = all().iter().find(|l| l.id == "CC-BY-SA-4.0").expect("it");
        for section in 1..=8 {
            assert!(by_sa.text.contains(&format!("Section {section} -- ")));
        }
    }

    #[test]
    fn the_overview_tells_of_every_group_where_from_and_what_was_changed() {
        let library = Library::bundled();
        let overview = overview(library);
        for group in library.all_groups().chain(preset::unlisted()) {
            for part in [
                &group.id,
                &group.source,
                &group.attribution,
                &group.changes,
                &group.licence.words,
            ] {
                assert!(overview.contains(part.as_str()), "{}: {part}", group.id);
            }
        }
        assert!(overview.contains("MIT OR Apache-2.0"));
        assert!(overview.contains("DejaVu Sans"));
    }

    #[test]
    fn the_whole_text_holds_every_licence() {
        let text = text(Library::bundled());
        for licence in all() {
            assert!(text.contains(licence.text.trim_end()), "{}", licence.id);
        }
    }

    #[test]
    fn the_program_names_its_own_developers() {
        let ours = "Copyright 2026 The Spectral Explorer developers";
        assert!(ALL[0].text.contains(ours));
    }
}
