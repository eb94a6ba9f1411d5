//! A light as known lamps, a cosine series and lines of their own width.
//!
//! ```text
//! S(l) = sum w_k A_k(l) + sum c_n cos(pi n (l - min)/L) + sum v_m g(l; p_m, f_m)
//! ```

use super::{
    error::EncodingError,
    known::{Atom, atoms_on},
};
use crate::{
    spectrum::{Band, Basis, BasisTable, Composite, Line, Series, gaussian},
    study::FitVariant,
};

/// Most known lamps in one encoding: the label has room for two.
pub(super) const MOST_ATOMS: usize = 2;

/// Most smooth numbers beside a label, which has six bits for their count.
pub(super) const MOST_LABELLED: usize = 63;

/// Places of a line in the range: 1/128 nm on 380-780.
pub(super) const PLACES: f64 = 51_200.0;

/// Widths of a line that is not ideal.
const WIDTHS: f64 = 254.0;
/// The narrowest and the widest, nm.
pub(super) const WIDTH_NM: [f64; 2] = [2.0, 90.0];

/// A known lamp with the radiant power it brings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtomWeight {
    /// Its index in [`known_lamps`](super::known_lamps).
    pub index: u8,
    /// Radiant power over the band, in the spectrum's unit x nm; may be negative.
    pub weight: f64,
}

/// An encoded light.
#[derive(Clone, Debug, PartialEq)]
pub struct Encoding {
    /// Known lamps, at most `MOST_ATOMS`.
    pub atoms: Vec<AtomWeight>,
    /// The smooth part.
    pub smooth: Series,
    /// Lines, in the order in which they were bought; places and widths as they are stored.
    pub lines: Vec<Line>,
    /// One of today's ways, which needs no label; `None` for known lamps and lines of own width.
    pub way: Option<FitVariant>,
}

impl Encoding {
    /// The band.
    pub fn band(&self) -> Band {
        self.smooth.band
    }

    /// True if a label comes first: as soon as there is a known lamp or a line, unless it is one of
    /// today's ways.
    pub(crate) fn has_label(&self) -> bool {
        self.way.is_none() && !(self.atoms.is_empty() && self.lines.is_empty())
    }

    /// Count of numbers (32-bit words): 1 for the label, 1 per known lamp, 1 per smooth number,
    /// 2 per line.
    pub fn numbers(&self) -> usize {
        usize::from(self.has_label())
            + self.atoms.len()
            + self.smooth.coefficients.len()
            + 2 * self.lines.len()
    }

    /// The same counted strictly: the index of a known lamp and the width of a line are numbers of
    /// their own. Today's ways have neither.
    pub(crate) fn strict_numbers(&self) -> usize {
        match self.way {
            Some(_) => self.numbers(),
            None => self.numbers() + self.atoms.len() + self.lines.len(),
        }
    }

    /// Smooth part and lines without the known lamps.
    pub fn composite(&self) -> Composite {
        let mut spikes = self.lines.clone();
        spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        Composite::of_lines_inside(self.smooth.clone(), spikes)
    }

    /// Radiant power over the band.
    pub fn power(&self) -> f64 {
        self.composite().power() + self.atoms.iter().map(|a| a.weight).sum::<f64>()
    }

    /// Everything times a factor.
    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        self.sizes_mut().for_each(|size| *size *= factor);
        self
    }

    /// The numbers that have the light's unit: of known lamps, of the smooth part, of lines.
    pub(super) fn sizes_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        let atoms = self.atoms.iter_mut().map(|a| &mut a.weight);
        let lines = self.lines.iter_mut().map(|l| &mut l.weight);
        atoms.chain(&mut self.smooth.coefficients).chain(lines)
    }
}

/// The width of a stored byte: 0 ideal, 1..=255 from 2 to 90 nm in even steps of ratio.
pub(super) fn width_of_byte(byte: u8) -> f64 {
    match byte {
        0 => 0.0,
        _ => WIDTH_NM[0] * (WIDTH_NM[1] / WIDTH_NM[0]).powf(f64::from(byte - 1) / WIDTHS),
    }
}

/// The byte nearest to a width; 0 below 2 nm.
pub(super) fn byte_of_width(width_nm: f64) -> u8 {
    if width_nm.is_nan() || width_nm < WIDTH_NM[0] {
        return 0;
    }
    let step = WIDTHS * (width_nm / WIDTH_NM[0]).ln() / (WIDTH_NM[1] / WIDTH_NM[0]).ln();
    (1.0 + step.round().min(WIDTHS)) as u8
}

/// The stored place nearest to a wavelength of the band. Sixteen bits end at 65535, the range at
/// 51200.
pub(super) fn stored_place(band: Band, at_nm: f64) -> u16 {
    let x = (at_nm - band.min_nm()) / band.length_nm();
    (x * PLACES).round().clamp(0.0, PLACES) as u16
}

/// The wavelength of a stored place, nm; `None` beyond the end of the band.
pub(super) fn place_nm(band: Band, stored: u16) -> Option<f64> {
    let x = f64::from(stored) / PLACES;
    (x <= 1.0).then(|| band.min_nm() + x * band.length_nm())
}

/// A line as it is stored: place and width at their nearest steps.
pub(super) fn stored_line(band: Band, line: Line) -> Line {
    Line {
        at_nm: place_nm(band, stored_place(band, line.at_nm)).unwrap_or(band.max_nm()),
        weight: line.weight,
        fwhm_nm: width_of_byte(byte_of_width(line.fwhm_nm)),
    }
}

/// Reads encodings of one band back into spectra.
#[derive(Clone, Debug)]
pub struct Decoder {
    band: Band,
    /// Cosines on the first half of the grid, one after another: even orders are the same on the
    /// other half, odd ones opposite.
    cosines: Vec<Vec<f64>>,
    atoms: Vec<Atom>,
}

impl Decoder {
    /// A decoder for a band; known lamps whose table does not cover it are not there.
    pub fn new(band: Band) -> Self {
        Self::with_atoms(band, atoms_on(band))
    }

    /// A decoder that has these known lamps.
    pub(crate) fn with_atoms(band: Band, atoms: Vec<Atom>) -> Self {
        let table = BasisTable::new(band, Basis::Cosine, MOST_LABELLED + 1);
        Self {
            band,
            cosines: (0..table.numbers())
                .map(|n| table.row(n)[..band.points().div_ceil(2)].to_vec())
                .collect(),
            atoms,
        }
    }

    /// The band.
    pub fn band(&self) -> Band {
        self.band
    }

    /// The known lamps of the band.
    pub(crate) fn atoms(&self) -> &[Atom] {
        &self.atoms
    }

    /// A known lamp on the grid by its index.
    pub(crate) fn atom(&self, index: u8) -> Option<&[f64]> {
        let atom = self.atoms.iter().find(|atom| atom.index == index)?;
        Some(&atom.values)
    }

    /// The spectrum on the band's grid, in the unit it was encoded in.
    ///
    /// # Errors
    /// [`EncodingError`] for another band, or a known lamp that the band does not have.
    pub fn decode(&self, encoding: &Encoding) -> Result<Vec<f64>, EncodingError> {
        let mut values = vec![0.0; self.band.points()];
        self.decode_into(encoding, &mut values)?;
        Ok(values)
    }

    /// [`Decoder::decode`] into a buffer of the grid's length.
    ///
    /// # Errors
    /// As [`Decoder::decode`], or a buffer of another length.
    pub fn decode_into(
        &self,
        encoding: &Encoding,
        values: &mut [f64],
    ) -> Result<(), EncodingError> {
        if encoding.band() != self.band {
            return Err(EncodingError::Band {
                found: encoding.band(),
                expected: self.band,
            });
        }
        if values.len() != self.band.points() {
            return Err(EncodingError::Points {
                found: values.len(),
                expected: self.band.points(),
            });
        }
        let series = &encoding.smooth;
        if series.basis == Basis::Cosine && series.coefficients.len() <= self.cosines.len() {
            self.cosines_into(&series.coefficients, values);
        } else {
            values.copy_from_slice(&series.on_band());
        }
        for AtomWeight { index, weight } in &encoding.atoms {
            let atom = self
                .atom(*index)
                .ok_or(EncodingError::Lamp { found: *index })?;
            for (value, a) in values.iter_mut().zip(atom) {
                *value += weight * a;
            }
        }
        crate::spectrum::add_lines(self.band, &encoding.lines, values);
        Ok(())
    }

    /// An encoding's value at one wavelength of the band: known lamps between the points of their
    /// grid, lines as Gaussians, those of no width left out.
    pub fn at(&self, encoding: &Encoding, nm: f64) -> f64 {
        let atoms = encoding.atoms.iter().filter_map(|part| {
            let atom = self.atom(part.index)?;
            Some(part.weight * self.band.interpolate(atom, nm))
        });
        let lines = encoding.lines.iter().filter(|line| !line.is_ideal());
        let line = |line: &Line| {
            line.stem_height(line.fwhm_nm) * gaussian((nm - line.at_nm) / line.fwhm_nm)
        };
        encoding.smooth.at(nm) + atoms.sum::<f64>() + lines.map(line).sum::<f64>()
    }

    fn cosines_into(&self, coefficients: &[f64], values: &mut [f64]) {
        let points = values.len();
        let half = points.div_ceil(2);
        values.fill(0.0);
        // Even orders are summed in the first half, odd ones in the second, the middle in the first.
        let (even, odd) = values.split_at_mut(half);
        for (n, (c, row)) in coefficients.iter().zip(&self.cosines).enumerate() {
            let sums = if n % 2 == 0 { &mut *even } else { &mut *odd };
            for (sum, f) in sums.iter_mut().zip(row) {
                *sum += c * f;
            }
        }
        // Odd sums lie from the start on; each pair is read before either is written.
        let rest = points - half;
        for i in 0..rest.div_ceil(2) {
            let mirror = rest - 1 - i;
            let (e, o) = (even[i], odd[i]);
            let (e2, o2) = (even[mirror], odd[mirror]);
            even[i] = e + o;
            odd[mirror] = e - o;
            even[mirror] = e2 + o2;
            odd[i] = e2 - o2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stored_widths_lead_back_to_their_bytes() {
        for byte in 0..=255 {
            assert_eq!(byte_of_width(width_of_byte(byte)), byte);
        }
        assert_eq!(width_of_byte(1), 2.0);
        // The power of a rounded ratio.
        assert!((width_of_byte(255) - 90.0).abs() < 1e-12);
        assert_eq!(
            [
                byte_of_width(1.99),
                byte_of_width(f64::NAN),
                byte_of_width(1e9)
            ],
            [0, 0, 255]
        );
    }

    #[test]
    fn half_a_grid_of_cosines_is_the_whole_series() {
        for band in [
            Band::VISIBLE,
            Band::new(401.0, 700.0).expect("an odd length"),
        ] {
            for numbers in [1, 2, 7, 20] {
                let coefficients = (0..numbers).map(|n| 1.0 / (1.0 + f64::from(n))).collect();
                let smooth = Series {
                    band,
                    basis: Basis::Cosine,
                    coefficients,
                };
                let expected = smooth.on_band();
                let encoding = Encoding {
                    atoms: Vec::new(),
                    smooth,
                    lines: Vec::new(),
                    way: None,
                };
                let found = Decoder::new(band).decode(&encoding).expect("its own band");
                // Twenty products of numbers below 1; the series goes by a recurrence.
                assert!(
                    found
                        .iter()
                        .zip(&expected)
                        .all(|(a, b)| (a - b).abs() < 1e-13)
                );
            }
        }
    }

    #[test]
    fn a_value_at_one_wavelength_is_that_of_the_whole_spectrum() {
        let decoder = Decoder::new(Band::VISIBLE);
        let encoding = Encoding {
            atoms: vec![AtomWeight {
                index: 3,
                weight: 2.0,
            }],
            smooth: Series {
                band: Band::VISIBLE,
                basis: Basis::Cosine,
                coefficients: vec![0.01, 0.004, -0.002],
            },
            lines: vec![Line {
                at_nm: 546.2,
                weight: 0.5,
                fwhm_nm: 8.0,
            }],
            way: None,
        };
        let values = decoder.decode(&encoding).expect("its own band");
        for (nm, value) in Band::VISIBLE.grid().zip(values) {
            // The area of a Gaussian sampled each nm, and its foot beyond the shape's reach.
            assert!((decoder.at(&encoding, nm) - value).abs() < 1e-9, "{nm}");
        }
    }

    #[test]
    fn stored_places_are_an_eighth_of_a_sixteenth_of_a_nm_on_the_visible_range() {
        let band = Band::VISIBLE;
        assert_eq!(place_nm(band, stored_place(band, 436.8)), Some(436.796875));
        for stored in [0, 1, 7_168, 51_200] {
            assert_eq!(
                place_nm(band, stored).map(|nm| stored_place(band, nm)),
                Some(stored)
            );
        }
        assert_eq!(place_nm(band, 51_201), None);
    }
}
