//! Writing pbrt and Mitsuba `.spd`.

use std::fmt::Write;

use crate::io::provenance::{Provenance, shortest};
use crate::spectrum::NamedSpectrum;

/// A spectrum as `.spd` text, with name, kind, unit and provenance in comments.
pub(crate) fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> String {
    let mut out = String::new();
    for (key, value) in provenance.of(spectrum) {
        let _ = writeln!(out, "# {key}: {value}");
    }
    for (nm, value) in spectrum.samples.nm().iter().zip(spectrum.samples.values()) {
        let _ = writeln!(out, "{} {}", shortest(*nm), shortest(*value));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::read_bytes;
    use crate::io::write::tests::awkward_spectrum;
    use crate::spectrum::Kind;

    #[test]
    fn what_is_written_is_read_back_to_the_bit() {
        for kind in [Kind::Light, Kind::Reflectance, Kind::Weighting] {
            let spectrum = awkward_spectrum(kind);
            let text = write(&spectrum, &Provenance::default());
            let back = read_bytes("x.spd", text.as_bytes())
                .unwrap()
                .spectra
                .remove(0);
            assert_eq!(back.samples, spectrum.samples);
            assert_eq!((back.kind, &back.name), (kind, &spectrum.name));
        }
    }
}
