//! A spectrum in the window's hands: where it came from and by what name it is found again.

use std::sync::{Arc, LazyLock};

use super::{library::Library, origin::Origin};
use crate::{
    io::MakersResult,
    measurements::Measurement,
    preset::{self, Body, Preset, Shelf},
    spectrum::{Band, Basis, Composite, Kind, Line, NamedSpectrum, Sampled, Series},
};

/// One spectrum of the library or of the user's own files.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// What finds it again: `group/name` for a preset, `own/<number>` for a file's spectrum.
    pub key: String,
    /// Where it came from.
    pub origin: Origin,
    pub spectrum: NamedSpectrum,
    /// Under which terms the numbers may be passed on; empty for the user's own.
    pub licence: String,
    /// What the instrument computed itself, as far as the file says.
    pub makers: Vec<MakersResult>,
    /// The composite that the spectrum is by its own source; its table is that composite's. `None` for what was measured or computed otherwise.
    pub composite: Option<Arc<Composite>>,
    /// The measurement that the values are of, with sigma, mask and what else is known of its doubt;
    /// `None` where nothing is.
    pub measured: Option<Arc<Measurement>>,
}

/// Its numbers are finite, so it equals itself: one that two documents share is not read through to be
/// compared.
impl Eq for Entry {}

impl Entry {
    /// A shipped spectrum; `None` for lists of lines, which are not spectra.
    pub fn of_preset(preset: &Preset) -> Option<Self> {
        Self::of_preset_weighing(preset, None)
    }

    /// A shipped spectrum; of the paper's lamps the weights of the spikes multiplied by `factor`
    /// instead of the file's own factor.
    pub fn of_preset_weighing(preset: &Preset, factor: Option<f64>) -> Option<Self> {
        let mut given = None;
        let spectrum = match &preset.body {
            Body::Spectrum(spectrum) => spectrum.clone(),
            Body::Composite(printed) => {
                let mut composite = printed.clone();
                let of_the_paper = factor.filter(|_| preset.shelf == Shelf::Paper);
                composite.weight_factor = of_the_paper.unwrap_or(printed.weight_factor);
                let composite = composite_from_preset(&composite)?;
                let samples = sampled(&composite)?;
                // A line tube is every line of an atom: what is seen of it, an analysis tells.
                given = (preset.shelf == Shelf::Paper).then(|| Arc::new(composite));
                NamedSpectrum {
                    name: preset.name.clone(),
                    kind: preset.kind,
                    unit: preset.unit.clone(),
                    scale: 1.0,
                    samples,
                    notes: [&preset.notes[..], &[SAMPLED_NOTE.to_owned()]].concat(),
                    source: preset.source.clone(),
                }
            }
            Body::Lines(_) => return None,
        };
        Some(Self {
            key: preset.id(),
            origin: Origin::Preset(preset.shelf),
            spectrum,
            licence: preset.licence.words.clone(),
            makers: Vec::new(),
            composite: given,
            measured: None,
        })
    }

    /// The heading it stands under; `None` for the user's own.
    pub fn shelf(&self) -> Option<Shelf> {
        match self.origin {
            Origin::Preset(shelf) => Some(shelf),
            Origin::File(_) | Origin::Made(_) | Origin::Numbers => None,
        }
    }

    /// Whether it is one of the paper's lamps, whose spikes' weights wait for a factor.
    pub fn is_of_the_paper(&self) -> bool {
        self.shelf() == Some(Shelf::Paper)
    }

    /// The user's own spectrum number `number`.
    pub fn own(number: u64, spectrum: NamedSpectrum) -> Self {
        Self {
            key: format!("own/{number}"),
            origin: Origin::Numbers,
            spectrum,
            licence: String::new(),
            makers: Vec::new(),
            composite: None,
            measured: None,
        }
    }

    pub fn name(&self) -> &str {
        &self.spectrum.name
    }

    /// What its values stand for.
    pub fn kind(&self) -> Kind {
        self.spectrum.kind
    }

    /// Whether the window can take it as a light or a reflectance.
    pub fn is_usable(&self) -> bool {
        self.kind() == Kind::Light || self.kind().is_factor()
    }

    /// Its values on a band's grid.
    pub fn on_band(&self, band: Band) -> Vec<f64> {
        self.spectrum.samples.on_band(band, self.kind().outside())
    }
}

/// All shipped spectra that can be shown, in the library's order, made once.
pub fn bundled_entries() -> &'static [Arc<Entry>] {
    static ALL: LazyLock<Vec<Arc<Entry>>> = LazyLock::new(|| {
        let all = Library::bundled().everything();
        all.filter_map(Entry::of_preset).map(Arc::new).collect()
    });
    &ALL
}

const SAMPLED_NOTE: &str =
    "A composite, sampled at 1 nm; each spike is split linearly over its two neighbouring nm.";

/// A composite as a 1 nm table over its own range; an ideal spike is split linearly over its two
/// neighbouring nm. `None` for a composite with numbers that are not finite.
pub(super) fn sampled(composite: &Composite) -> Option<Sampled> {
    Sampled::even(composite.band().min_nm(), 1.0, composite.on_band()).ok()
}

/// The paper's lamps as composites, the visible weight factor applied.
pub fn composite_from_preset(printed: &preset::Composite) -> Option<Composite> {
    let [min_nm, max_nm] = printed.range_nm;
    let band = Band::new(min_nm, max_nm).ok()?;
    Some(Composite::of_lines_inside(
        Series::from_lists(
            band,
            Basis::Fourier,
            &[("a", &printed.a[..]), ("b", &printed.b[..])],
        )?,
        printed
            .spikes_in_unit_nm()
            .map(|(at_nm, weight)| Line::ideal(at_nm, weight))
            .collect(),
    ))
}
