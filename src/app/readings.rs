//! What is to be known of a reading before any figure of it: counts are no light, and a cut top has
//! lost its height.

use serde_json::{Value, json};

use super::{entry::Entry, library::Library, line_names::Identified, measured::measurement};
use crate::{
    languages,
    measurements::{
        CountsSign, FlatTop, Measurement, MeasurementError, Quantity, counts_sign, flat_tops,
    },
    spectrum::{NamedSpectrum, Outside, Sampled},
};

/// What stands in place of the figures of counts.
pub const COUNTS: &str = later!(
    "Counts, not light: the instrument's response is still in it. Correct with a known light."
);

/// Whether a spectrum of the user's own is surely what an instrument counted.
pub fn is_counts(entry: &Entry) -> bool {
    let own = Some(entry).filter(|entry| entry.shelf().is_none());
    let sign = own.and_then(|entry| counts_sign(&entry.spectrum));
    sign.is_some_and(|sign| sign.is_certain)
}

/// Whether a column that may be a spectrum's sigma was left out of it.
pub fn lost_its_sigma(of: &NamedSpectrum) -> bool {
    of.notes.iter().any(|note| note.contains("is a spread"))
}

/// What a reading tells of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Why its values are counts.
    pub counts: Option<CountsSign>,
    /// True if a person says that they are a light all the same.
    pub is_taken_as_light: bool,
    /// Where its top is cut.
    pub clipped: Vec<FlatTop>,
}

impl Reading {
    /// What a spectrum tells.
    pub fn of(spectrum: &NamedSpectrum, as_light: bool) -> Self {
        let clipped = measurement(spectrum, None).map(|m| flat_tops(&m));
        Self {
            counts: counts_sign(spectrum),
            is_taken_as_light: as_light,
            clipped: clipped.unwrap_or_default(),
        }
    }

    /// What the inputs of a combination tell together; `of_result` is what is made of them.
    pub fn of_parts(parts: &[Self], of_result: Quantity) -> Self {
        let counts = parts.iter().find_map(|part| part.counts.clone());
        Self {
            counts: counts.filter(|_| of_result == Quantity::Counts),
            is_taken_as_light: parts.iter().any(|part| part.is_taken_as_light),
            clipped: parts.iter().flat_map(|part| part.clipped.clone()).collect(),
        }
    }

    /// True if figures of light would be those of an instrument's response.
    pub fn has_no_figures(&self) -> bool {
        self.counts.is_some() && !self.is_taken_as_light
    }

    /// The keys `counts` and `clipped`.
    pub fn keys(&self) -> [(&'static str, Value); 2] {
        let top = |top: &FlatTop| json!({ "from_nm": top.from_nm, "to_nm": top.to_nm, "sure": top.is_sure });
        let why = self.counts.as_ref().map(|sign| &sign.why);
        [
            ("counts", json!({ "is": self.counts.is_some(), "why": why })),
            ("clipped", self.clipped.iter().map(top).collect()),
        ]
    }

    /// What is to be said beside the figures, a sentence each.
    pub fn sentences(&self) -> Vec<String> {
        let mut said = Vec::new();
        if let Some(sign) = &self.counts {
            said.push(match (self.is_taken_as_light, sign.is_certain) {
                (true, _) => tr!(
                    "Counts ({why}), taken as a light all the same.",
                    why = sign.why
                ),
                (false, true) => languages::said(COUNTS).to_owned(),
                (false, false) => {
                    tr!(
                        "{counts} ({why}; --as-light says it is a light.)",
                        counts = languages::said(COUNTS),
                        why = sign.why
                    )
                }
            });
        }
        let tops: Vec<String> = self
            .clipped
            .iter()
            .filter(|top| top.is_sure)
            .map(|top| format!("{}-{}", top.from_nm, top.to_nm))
            .collect();
        if !tops.is_empty() {
            said.push(tr!(
                "Clipped at {places} nm: the line's strength is lost.",
                places = tops.join(", ")
            ));
        }
        if self.clipped.iter().any(|top| !top.is_sure) {
            said.push(said!("The top may be clipped: it stands at the end of 8 bit.").to_owned());
        }
        said
    }
}

/// Names of a light's lines at some places, `Hg 546.1`; none for lines that nothing explains.
pub fn names_of_lines(samples: &Sampled, places_nm: &[f64]) -> Vec<Option<String>> {
    let lines = Library::bundled().lines();
    let identified = Identified::of(samples, Outside::Zero, lines);
    let names = identified.names_at(places_nm).into_iter();
    names.map(|name| name.label).collect()
}

/// The measurement that a spectrum is: counts where nothing says that they are a light.
///
/// # Errors
/// A sentence for what is no measurement.
pub fn measured(
    spectrum: &NamedSpectrum,
    sigma: Option<&NamedSpectrum>,
    as_light: bool,
) -> Result<(Measurement, Reading), MeasurementError> {
    let mut found = measurement(spectrum, sigma)?;
    let reading = Reading::of(spectrum, as_light);
    match found.quantity {
        Quantity::Light if reading.has_no_figures() => found.quantity = Quantity::Counts,
        Quantity::Counts if as_light => found.quantity = Quantity::Light,
        _ => {}
    }
    Ok((found, reading))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::entry::bundled_entries, io::exposure_ms, spectrum::Kind};

    fn spectrum(unit: &str, values: Vec<f64>) -> NamedSpectrum {
        NamedSpectrum {
            name: "lamp".to_owned(),
            kind: Kind::Light,
            unit: unit.to_owned(),
            scale: 1.0,
            samples: Sampled::even(380.0, 1.0, values).expect("finite"),
            notes: Vec::new(),
            source: String::new(),
        }
    }

    #[test]
    fn an_exposure_is_read_with_its_unit_wherever_that_stands() {
        let of = |line: &str| exposure_ms(&format!("title\n{line}\n400,1\n"));
        assert_eq!(of("Integration Time (usec): 30000 (USB4000)"), Some(30.0));
        assert_eq!(of("Integration Time (sec): 1.000000E-1"), Some(100.0));
        assert_eq!(of("Integration time [ms],92.0"), Some(92.0));
        assert_eq!(of("# exposure: 30ms"), Some(30.0));
        assert_eq!(of("Exposure: 30"), None);
        assert_eq!(of("lamp"), None);
    }

    #[test]
    fn no_shipped_spectrum_is_accused_of_counts_or_of_a_cut_top() {
        let mut seen = 0;
        for entry in bundled_entries() {
            let found = Reading::of(&entry.spectrum, false);
            assert_eq!(found.counts, None, "{}", entry.key);
            if entry.kind() == Kind::Light {
                seen += 1;
                assert_eq!(found.clipped, [], "{}", entry.key);
            }
        }
        assert!(seen > 140, "{seen}");
    }

    #[test]
    fn counts_are_told_by_word_by_per_cent_and_by_whole_numbers_above_a_byte() {
        let top: Vec<f64> = (0..401).map(|i| 10.0 + f64::from(i % 97) * 40.0).collect();
        let said = Reading::of(&spectrum("Intensity (counts)", top.clone()), false);
        assert!(said.counts.clone().is_some_and(|sign| sign.is_certain));
        assert_eq!(said.sentences()[0], COUNTS);
        let asked = Reading::of(&spectrum("", top.clone()), false);
        assert!(asked.counts.clone().is_some_and(|sign| !sign.is_certain));
        let light = Reading::of(&spectrum("W m-2 nm-1", top.clone()), false);
        assert_eq!(light.counts, None);
        let taken = Reading::of(&spectrum("counts", top.clone()), true);
        assert!(!taken.has_no_figures() && taken.counts.is_some());
        let mut glass = spectrum("%", top.iter().map(|v| 0.01 * v).collect());
        (glass.kind, glass.scale) = (Kind::Transmittance, 0.01);
        assert!(counts_sign(&glass).is_some_and(|sign| sign.is_certain));
    }
}
