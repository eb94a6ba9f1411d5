//! What an entry is, in words: its family, a title and a sentence.

use super::{
    combining::{doubts_of, words::figure_words},
    entry::Entry,
    families::{Families, Family},
    line_names::Identified,
    made::is_made,
    origin::{CAPTURED, FOLLOWED},
    readings::COUNTS,
    ticks::{extent, short},
    tint::kelvin_words,
};
use crate::{
    color::{Observer, cct_from_xyz, xyz::xyz_from_light},
    io::many::capitalised,
    languages::{said, translated},
    measurements::{Figure, counts_sign},
    spectrum::{Kind, Sampled},
};

/// What is said of an entry.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct About {
    pub name: String,
    /// What it is in a few words; empty where nobody knows.
    pub what: String,
    /// Its correlated colour temperature, K; `None` for what is no light and for lights too far
    /// from the black bodies.
    pub kelvin: Option<f64>,
    /// A sentence about it; may be empty.
    pub about: String,
    /// Whose table it is and in which steps.
    pub table: String,
}

impl About {
    /// What is said of a shipped entry, or of one of the user's own.
    pub fn of(entry: &Entry) -> Self {
        let words = Self::words_of(entry);
        // A shipped spectrum is none, which a test holds.
        let own = Some(entry).filter(|entry| entry.shelf().is_none());
        match own.and_then(|entry| counts_sign(&entry.spectrum)) {
            Some(sign) if sign.is_certain => Self {
                about: said(COUNTS).to_owned(),
                ..words
            },
            Some(sign) => Self {
                kelvin: kelvin_of(entry),
                about: tr!("These may be counts, not light: {why}.", why = sign.why),
                ..words
            },
            None => Self {
                kelvin: kelvin_of(entry),
                about: match doubt_words(entry) {
                    doubt if words.about.is_empty() => doubt,
                    doubt => format!("{} {doubt}", words.about).trim_end().to_owned(),
                },
                ..words
            },
        }
    }

    /// The same without what must be computed.
    pub(super) fn words_of(entry: &Entry) -> Self {
        let families = Families::shipped();
        let item = families.item(&entry.key);
        let table = families.table_of(&entry.key);
        let what = item.map(|item| &item.what);
        let what = what.or(table.map(|table| &table.what));
        Self {
            name: entry.name().to_owned(),
            what: what.map_or_else(String::new, |what| translated(what).to_owned()),
            kelvin: None,
            about: item.map_or_else(String::new, |item| translated(&item.about).to_owned()),
            table: table_words(entry),
        }
    }

    /// "FL2: cool white fluorescent tube, 4220 K".
    pub fn title(&self) -> String {
        let kelvin = self.kelvin.map(kelvin_words);
        let what = Some(self.what.clone()).filter(|what| !what.is_empty());
        let parts: Vec<String> = what.into_iter().chain(kelvin).collect();
        if parts.is_empty() {
            self.name.clone()
        } else {
            tr!(
                "{light}: {what}",
                light = self.name,
                what = parts.join(", ")
            )
        }
    }

    /// The title, the sentence and the table: "FL2: cool white fluorescent tube, 4220 K. Four
    /// mercury lines on a phosphor glow. CIE table, 1 nm from 5 nm data."
    pub fn sentence(&self) -> String {
        let mut sentence = format!("{}.", self.title());
        if !self.about.is_empty() {
            sentence = format!("{sentence} {}", self.about);
        }
        if !self.table.is_empty() {
            sentence = format!("{sentence} {}.", self.table);
        }
        sentence
    }
}

fn kelvin_of(entry: &Entry) -> Option<f64> {
    if entry.kind() != Kind::Light {
        return None;
    }
    let samples = &entry.spectrum.samples;
    let xyz = xyz_from_light(samples, entry.kind().outside(), Observer::CIE_1931)?;
    cct_from_xyz(xyz).ok().map(|cct| cct.kelvin)
}

/// The figures that a light is known by with their doubt, a sentence; empty where none is known.
fn doubt_words(entry: &Entry) -> String {
    let doubts = doubts_of(entry);
    let known = doubts
        .iter()
        .filter(|d| matches!(d.figure, Figure::Cct | Figure::Ra | Figure::Rf));
    let told: Vec<String> = known
        .map(|d| format!("{} {}", d.figure.words(), figure_words(d)))
        .collect();
    if told.is_empty() {
        return String::new();
    }
    let figures = told.join(", ");
    match entry.measured.as_ref().and_then(|of| of.scans) {
        Some(scans) if scans > 1 => tr!("{figures} ({scans} scans).", figures, scans),
        _ => format!("{figures}."),
    }
}

fn table_words(entry: &Entry) -> String {
    if is_made(&entry.key) {
        return said!("Made by this program").to_owned();
    }
    let (steps, source) = (steps_words(&entry.spectrum.samples), &entry.spectrum.source);
    match Families::shipped().table_of(&entry.key) {
        Some(table) => {
            let table_of = capitalised(translated(&table.of));
            match table.from_nm {
                Some(nm) => tr!("{table_of}, {steps} from {nm} nm data", table_of, steps, nm),
                None => format!("{table_of}, {steps}"),
            }
        }
        None if source.is_empty() => String::new(),
        None if source.starts_with("made ") => match source.strip_prefix("made from ") {
            Some(names) => tr!("Made from {names}, {steps}", names, steps),
            None => format!("{}, {steps}", capitalised(translated(source))),
        },
        None => match (source.strip_prefix(FOLLOWED), source.strip_prefix(CAPTURED)) {
            (Some(source), _) => tr!("Followed from {source}, {steps}", source, steps),
            (_, Some(source)) => tr!("Captured from {source}, {steps}", source, steps),
            _ => tr!("From {source}, {steps}", source, steps),
        },
    }
}

/// "1 nm", "0.5 to 1 nm".
fn steps_words(samples: &Sampled) -> String {
    if samples.has_even_steps() {
        return format!("{} nm", short(samples.step_nm()));
    }
    let steps = samples.nm().windows(2).map(|w| w[1] - w[0]);
    let [least, most] = extent(steps).unwrap_or_default();
    tr!(
        "{least} to {most} nm",
        least = short(least),
        most = short(most)
    )
}

/// The family of an entry: of a shipped one as it is written, of the user's own light as far as
/// its lines tell.
pub fn family(entry: &Entry, light: &Identified) -> Option<&'static Family> {
    let families = Families::shipped();
    if entry.shelf().is_some() {
        return families.family_of(&entry.key);
    }
    families.family(light.family_key()?)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::app::{entry::bundled_entries, library::Library, spike_names::identified};

    fn about(id: &str) -> About {
        let preset = Library::bundled().find(id).expect(id);
        About::of(&Entry::of_preset(preset).expect(id))
    }

    #[test]
    fn the_first_lights_title_says_what_it_is() {
        let fl2 = about("cie_fluorescent_1nm/FL2");
        assert_eq!(fl2.title(), "FL2: cool white fluorescent tube, 4220 K");
        assert_eq!(
            fl2.sentence(),
            "FL2: cool white fluorescent tube, 4220 K. Four mercury lines on a phosphor glow. CIE \
             table, 1 nm from 5 nm data."
        );
        for (id, end) in [
            ("cie_fluorescent_5nm/FL2", "CIE table, 5 nm."),
            ("line_tubes/Neon tube", "Made by this program."),
        ] {
            assert!(about(id).sentence().ends_with(end), "{id}");
        }
        assert_eq!(
            about("cie_illuminants/CIE A").title(),
            "CIE A: standard tungsten bulb, 2860 K"
        );
    }

    #[test]
    fn where_a_spectrum_is_from_is_a_sentence_whoever_wrote_it() {
        let of = |source: &str| {
            let shipped = &bundled_entries()[0].spectrum;
            let source = source.to_owned();
            let own = crate::spectrum::NamedSpectrum {
                source,
                ..shipped.clone()
            };
            About::of(&Entry::own(0, own)).table
        };
        assert!(of("followed from COM3").starts_with("Followed from COM3, "));
        assert!(of("captured from COM3").starts_with("Captured from COM3, "));
        assert!(of("lamp.csv").starts_with("From lamp.csv, "));
    }

    #[test]
    fn every_shipped_light_has_a_family_and_a_sentence() {
        for entry in bundled_entries() {
            let told = About::of(entry);
            let family = family(entry, &Identified::default());
            assert!(family.is_some(), "{}", entry.key);
            assert!(!told.table.is_empty(), "{}", entry.key);
            if entry.kind() != Kind::Light {
                continue;
            }
            let key = &entry.key;
            assert!(!told.what.is_empty() && told.about.ends_with('.'), "{key}");
            // Numbers are computed, not written: what stands beside a unit of temperature is ours.
            for words in [&told.what, &told.about] {
                assert!(!words.contains(" K"), "{key}: {words}");
            }
            assert!(told.what.chars().count() <= 60, "{key}: {}", told.what);
        }
    }

    #[test]
    fn a_sentence_that_counts_mercury_lines_counts_those_that_have_names() {
        let lines = Library::bundled().lines();
        let mut counted = 0;
        for entry in bundled_entries() {
            let told = About::of(entry);
            let light = identified(entry, lines);
            let named: BTreeSet<&str> = light.peaks().filter_map(|(_, name)| name).collect();
            let mercury = named.iter().filter(|name| name.contains("Hg ")).count();
            if told.about.starts_with("Four mercury lines") {
                counted += 1;
                assert_eq!(mercury, 4, "{}: {named:?}", entry.key);
            }
            let spoken = told.about.to_lowercase();
            for (element, symbol) in [
                ("mercury", "Hg"),
                ("terbium", "terbium"),
                ("europium", "europium"),
                ("thallium", "Tl"),
                ("lithium", "Li"),
                ("scandium", "Sc"),
            ] {
                let is_told = spoken.contains(element) && entry.kind() == Kind::Light;
                let is_named = named.iter().any(|name| name.contains(symbol));
                let of_the_paper = entry.key.starts_with("paper/");
                let holds = !is_told || is_named || of_the_paper;
                assert!(holds, "{}: {element}", entry.key);
            }
        }
        assert!(counted > 20, "{counted}");
    }
}
