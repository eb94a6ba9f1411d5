//! What an instrument computed from its spectrum, beside what this program computes from it.
//!
//! The instrument's numbers stand in the file; ours come from the whole measured table, whatever
//! range the model is on: colours and lux by plain 1 nm sums over 360-830 nm (CIE 1931), colour
//! rendering and hue by [`Figures`], totals by the trapezium rule over the table's own points. Ours
//! are given in the instrument's unit.

use std::cell::OnceCell;

use super::{
    cells::{Columns, Table, cell},
    entry::Entry,
    figures::of_quantity,
    photons::JOULE_NM_PER_MICROMOLE,
    quality_report::light_of,
    scale::LUMENS_PER_WATT,
    spectral_unit::{Counted, SpectralUnit},
};
use crate::{
    color::{
        Observer, Xyz,
        quality::{Figures, NoFigure},
        xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values},
    },
    io::{MakersResult, Quantity},
    spectrum::{Kind, NamedSpectrum, Outside, Sampled},
};

/// What is said where the program does not know the quantity.
pub const NOT_YET: &str = later!("not computed here yet");

/// Said where nothing is seen.
const DARK: &str = later!("no visible light");

/// Square metres in a square foot: lux of one foot-candle are its inverse.
const SQUARE_FOOT_M2: f64 = 0.3048 * 0.3048;

/// One number of the instrument and ours.
#[derive(Clone, Debug, PartialEq)]
pub struct Beside {
    /// What was computed.
    pub quantity: Quantity,
    /// Unit of both numbers; empty for pure numbers.
    pub unit: String,
    /// The instrument's.
    pub theirs: f64,
    /// Ours, or why there is none.
    pub ours: Result<f64, &'static str>,
    /// Half of the last figure that the file writes: how far its number is told at all.
    pub told_to: Option<f64>,
}

impl Beside {
    /// Ours less theirs.
    pub fn difference(&self) -> Option<f64> {
        self.ours.ok().map(|ours| ours - self.theirs)
    }

    /// Whether the difference is no more than what the file's rounding hides.
    pub fn is_as_told(&self) -> bool {
        let Some((difference, told_to)) = self.difference().zip(self.told_to) else {
            return false;
        };
        // Half a figure is hardly ever a whole number of bits.
        difference.abs() <= told_to * (1.0 + 1e-9)
    }
}

/// Every result of the instrument that wrote an entry, beside ours, in the file's order.
pub fn beside(entry: &Entry) -> Vec<Beside> {
    if entry.makers.is_empty() {
        return Vec::new();
    }
    let light = Light::of(entry);
    let of = |result: &MakersResult| {
        let MakersResult {
            spectrum: _,
            quantity,
            value,
            unit,
            as_written,
        } = result;
        let of_photons = |words: &str| words.starts_with("PFD-");
        let unit = match quantity {
            // LI-COR writes no unit beside the parts of the flux whose unit it does write.
            Quantity::Other(words) if unit.is_empty() && of_photons(words) => {
                Quantity::Pfd.usual_unit().to_owned()
            }
            _ => unit.clone(),
        };
        Beside {
            told_to: half_of_last_figure(as_written, *value),
            ours: light.compute(quantity, &unit),
            quantity: quantity.clone(),
            unit,
            theirs: *value,
        }
    };
    entry.makers.iter().map(of).collect()
}

/// Half of the last figure of a number in the words that it was written in: 0.05 for `PPFD 0.4`.
fn half_of_last_figure(as_written: &str, value: f64) -> Option<f64> {
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',');
    let mut numbers = as_written.rsplit(|c: char| !is_of_number(c));
    numbers.find_map(|text| {
        let text = text.replace(',', ".");
        let number: f64 = text.parse().ok()?;
        if (number - value.abs()).abs() > 1e-9 * number {
            return None;
        }
        let decimals = text.split_once('.').map_or(0, |(_, behind)| behind.len());
        Some(0.5 * 10f64.powi(-(decimals as i32)))
    })
}

/// The comparison as a table.
pub fn table(rows: &[Beside]) -> Table {
    let columns = Columns::<&Beside>::default()
        .with("quantity", |row| cell(row.quantity.to_string()))
        .with("unit", |row| cell(row.unit.as_str()))
        .with("instrument", |row| cell(row.theirs))
        .with("ours", |row| cell(row.ours.ok()))
        .with("difference", |row| cell(row.difference()));
    Table::new("", columns, rows)
}

/// A measured table with what its unit says.
struct Light<'a> {
    spectrum: &'a NamedSpectrum,
    unit: Option<SpectralUnit>,
    /// Values on whole nm 360-830 as power, in the table's own unit or W m-2 nm-1.
    xyz: Xyz,
    /// Colour rendering and hue, computed once one of them is asked for.
    figures: OnceCell<Figures>,
}

impl<'a> Light<'a> {
    fn of(entry: &'a Entry) -> Self {
        let spectrum = &entry.spectrum;
        let unit = SpectralUnit::of(&spectrum.unit);
        let mut values = spectrum
            .samples
            .on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero);
        if unit.is_some_and(|u| u.counted == Counted::Micromoles) {
            for (nm, value) in (FIRST_NM..=LAST_NM).zip(&mut values) {
                *value *= JOULE_NM_PER_MICROMOLE / f64::from(nm);
            }
        }
        Self {
            spectrum,
            figures: OnceCell::new(),
            unit,
            xyz: xyz_from_nm_values(&values, Observer::CIE_1931),
        }
    }

    /// Our number for a quantity, in a unit.
    fn compute(&self, quantity: &Quantity, unit: &str) -> Result<f64, &'static str> {
        let finite = |value: f64| Some(value).filter(|v| v.is_finite()).ok_or(DARK);
        if *quantity == Quantity::PeakNm {
            return self.peak_nm().ok_or(later!("no values"));
        }
        if let Some(found) = self.quality(quantity) {
            return found;
        }
        if self.spectrum.kind != Kind::Light {
            return Err(later!("the values are no light"));
        }
        match quantity {
            // Meters write 683 lm/W x the sums; Y is the lux.
            Quantity::TristimulusX => finite(self.photometric(false)? * self.xyz.x),
            Quantity::TristimulusZ => finite(self.photometric(false)? * self.xyz.z),
            Quantity::TristimulusY | Quantity::Illuminance => {
                finite(self.photometric(false)? * self.xyz.y)
            }
            Quantity::Luminance => finite(self.photometric(true)? * self.xyz.y),
            Quantity::Irradiance => self.total(Counted::Watts, unit, None),
            Quantity::Ppfd => self.total(Counted::Micromoles, unit, Some([400.0, 700.0])),
            Quantity::Pfd => self.total(Counted::Micromoles, unit, None),
            Quantity::Other(words) => self.other(words, unit),
            _ => Err(NOT_YET),
        }
    }

    /// Figures of light quality; `None` for other quantities, and where there is no light.
    fn quality(&self, quantity: &Quantity) -> Option<Result<f64, &'static str>> {
        let (row, factor) = of_quantity(quantity)?;
        if self.spectrum.kind != Kind::Light {
            return None;
        }
        let figures = self.figures.get_or_init(|| {
            let (light, measured) = light_of(self.spectrum);
            Figures::of(&light, measured)
        });
        let found = row.value(figures).map(|value| factor * value);
        Some(found.map_err(|why| match why {
            NoFigure::Dark(_) | NoFigure::NotPositive { .. } => DARK,
            NoFigure::NoCct(_) => later!("too far from the blackbody locus"),
            NoFigure::NearWhite { .. } => later!("no hue: too near the white"),
            NoFigure::VioletEnd => later!("the violet end of the locus"),
            NoFigure::RedEnd => later!("the red end of the locus"),
            _ => later!("out of the formula's range"),
        }))
    }

    /// What makers' own words name and is computed like the rest.
    fn other(&self, words: &str, unit: &str) -> Result<f64, &'static str> {
        // LI-COR's parts of the photon flux.
        let range = match words {
            "PFD-UV" => [380.0, 400.0],
            "PFD-B" => [400.0, 500.0],
            "PFD-G" => [500.0, 600.0],
            "PFD-R" => [600.0, 700.0],
            "PFD-FR" => [700.0, 780.0],
            "Illuminance" if unit == "fc" => {
                return Ok(self.photometric(false)? * self.xyz.y * SQUARE_FOOT_M2);
            }
            _ => return Err(NOT_YET),
        };
        self.total(Counted::Micromoles, unit, Some(range))
    }

    /// What turns the sums of the colour-matching functions into lm m-2, or cd m-2.
    fn photometric(&self, per_steradian: bool) -> Result<f64, &'static str> {
        let unit = self.spectral_unit()?;
        if unit.per_steradian != per_steradian {
            return Err(if per_steradian {
                later!("the values are no radiance")
            } else {
                later!("the values are no irradiance")
            });
        }
        Ok(LUMENS_PER_WATT * unit.factor)
    }

    fn spectral_unit(&self) -> Result<SpectralUnit, &'static str> {
        const UNKNOWN: &str = later!("the unit of the values is not known");
        self.unit.filter(|u| u.per_nm && u.per_area).ok_or(UNKNOWN)
    }

    /// The integral over the table, or a part of it, of power or of photons.
    fn total(
        &self,
        counted: Counted,
        unit: &str,
        range_nm: Option<[f64; 2]>,
    ) -> Result<f64, &'static str> {
        const ODD: &str = later!("the instrument's unit is not known");
        let own = self.spectral_unit()?;
        if own.per_steradian {
            return Err(later!("the values are no irradiance"));
        }
        let theirs = match unit {
            "" => 1.0,
            _ => {
                let theirs = SpectralUnit::of(unit).filter(|u| u.counted == counted && !u.per_nm);
                theirs.ok_or(ODD)?.factor
            }
        };
        let samples = &self.spectrum.samples;
        let range_nm = range_nm.unwrap_or([samples.first_nm(), samples.last_nm()]);
        let weight = |nm: f64| match (own.counted, counted) {
            (Counted::Watts, Counted::Micromoles) => nm / JOULE_NM_PER_MICROMOLE,
            (Counted::Micromoles, Counted::Watts) => JOULE_NM_PER_MICROMOLE / nm,
            _ => 1.0,
        };
        Ok(own.factor / theirs * integral(samples, range_nm, weight))
    }

    fn peak_nm(&self) -> Option<f64> {
        let samples = &self.spectrum.samples;
        let values = samples.values().iter().enumerate();
        let (index, _) = values.max_by(|a, b| a.1.total_cmp(b.1).then(b.0.cmp(&a.0)))?;
        Some(samples.nm()[index])
    }
}

/// Integral of a table times a weight between two wavelengths: trapeziums over the table's points
/// and the two ends; nothing outside the table.
fn integral(samples: &Sampled, [from, to]: [f64; 2], weight: impl Fn(f64) -> f64) -> f64 {
    let (from, to) = (from.max(samples.first_nm()), to.min(samples.last_nm()));
    if from >= to {
        return 0.0;
    }
    let value = |nm: f64| samples.at(nm, Outside::Zero) * weight(nm);
    let places = samples.nm().iter().copied();
    let inner = places.filter(|nm| *nm > from && *nm < to);
    let mut sum = 0.0;
    let mut last = (from, value(from));
    for nm in inner.chain([to]) {
        let here = (nm, value(nm));
        sum += 0.5 * (here.0 - last.0) * (here.1 + last.1);
        last = here;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::NamedSpectrum;
    use approx::assert_relative_eq;

    fn light(unit: &str, first_nm: f64, values: Vec<f64>, makers: &[(&str, &str)]) -> Entry {
        let spectrum = NamedSpectrum {
            name: "lamp".to_owned(),
            kind: Kind::Light,
            unit: unit.to_owned(),
            scale: 1.0,
            samples: Sampled::even(first_nm, 1.0, values).expect("finite"),
            notes: Vec::new(),
            source: String::new(),
        };
        let result = |(key, value): &(&str, &str)| MakersResult::of(Some(0), key, value, false);
        Entry {
            makers: makers.iter().filter_map(result).collect(),
            ..Entry::own(1, spectrum)
        }
    }

    /// One watt per square metre within 1 nm of a wavelength.
    fn line(at_nm: f64, unit: &str, height: f64, makers: &[(&str, &str)]) -> Vec<f64> {
        let entry = light(unit, at_nm - 1.0, vec![0.0, height, 0.0], makers);
        let rows = beside(&entry);
        assert_eq!(rows.len(), makers.len());
        rows.iter().map(|r| r.ours.expect("ours")).collect()
    }

    #[test]
    fn a_watt_of_green_is_683_lux_in_whatever_unit_it_is_written() {
        for (unit, height) in [
            ("W m-2 nm-1", 1.0),
            ("mW m-2 nm-1", 1e3),
            ("µW/cm²/nm", 100.0),
            ("W/m2/um", 1e3),
            ("W/(m^2 nm)", 1.0),
        ] {
            let ours = line(
                555.0,
                unit,
                height,
                &[("LUX", "683"), ("IRR", "1"), ("fc", "63")],
            );
            assert_relative_eq!(ours[0], 683.002, max_relative = 1e-6);
            assert_relative_eq!(ours[1], 1.0, max_relative = 1e-12);
            assert_relative_eq!(ours[2], 683.002 / 10.763_910_4, max_relative = 1e-6);
        }
    }

    #[test]
    fn photons_of_one_wavelength_are_counted_by_their_energy() {
        // 1 W of 598.13 nm is 5 µmol of photons a second: 119.6265... J nm / µmol.
        let nm = 598.0;
        let micromoles = nm / 119.626_565_8;
        let ours = line(
            nm,
            "W m-2 nm-1",
            1.0,
            &[("PPFD", "5"), ("PFD", "5"), ("PFD-G", "5")],
        );
        for value in ours {
            assert_relative_eq!(value, micromoles, max_relative = 1e-8);
        }
        // And back: photons as power.
        let back = line(
            nm,
            "µmol m-2 s-1 nm-1",
            micromoles,
            &[("IRR", "1"), ("PPFD", "5")],
        );
        assert_relative_eq!(back[0], 1.0, max_relative = 1e-8);
        assert_relative_eq!(back[1], micromoles, max_relative = 1e-12);
    }

    #[test]
    fn ppfd_ends_at_400_and_700_nm_and_pfd_does_not() {
        let entry = light(
            "µmol m-2 s-1 nm-1",
            350.0,
            vec![1.0; 451],
            &[
                ("PPFD", "300"),
                ("PFD", "450"),
                ("PFD-FR", "80"),
                ("PFD-UV", "20"),
            ],
        );
        let ours: Vec<f64> = beside(&entry).iter().map(|r| r.ours.unwrap()).collect();
        for (ours, expected) in ours.iter().zip([300.0, 450.0, 80.0, 20.0]) {
            assert_relative_eq!(*ours, expected, max_relative = 1e-12);
        }
    }

    #[test]
    fn the_equal_energy_light_has_its_known_colour_and_our_numbers_come_in_their_unit() {
        let entry = light(
            "mW m-2 nm-1",
            360.0,
            vec![1.0; 471],
            &[
                ("x", "0.3333"),
                ("y", "0.3333"),
                ("u'", "0.2105"),
                ("v'", "0.4737"),
                ("CCT", "5455"),
                ("Duv", "-0.0044"),
                ("IRR [mW/m2]", "470"),
                ("LambdaP", "360"),
            ],
        );
        for row in beside(&entry) {
            let ours = row.ours.expect("ours");
            let off = (ours - row.theirs).abs();
            let allowed = match row.quantity {
                Quantity::Cct => 3.0,
                _ => 1e-4,
            };
            assert!(off < allowed, "{}: {ours} and {}", row.quantity, row.theirs);
        }
    }

    #[test]
    fn what_is_not_computed_says_why() {
        let why = |unit: &str, key: &str| {
            let entry = light(unit, 500.0, vec![1.0; 101], &[(key, "1")]);
            beside(&entry)[0].ours.expect_err("nothing")
        };
        assert_eq!(why("W m-2 nm-1", "R:B"), NOT_YET);
        assert!(why("counts", "LUX").contains("unit of the values"));
        assert!(why("W m-2 nm-1", "Luminance").contains("no radiance"));
        assert!(why("W m-2 sr-1 nm-1", "LUX").contains("no irradiance"));
        assert!(why("W m-2 nm-1", "IRR [lm]").contains("instrument's unit"));
        assert!(beside(&light("W", 500.0, vec![0.0; 9], &[])).is_empty());
        let dark = light(
            "W m-2 nm-1",
            500.0,
            vec![0.0; 9],
            &[
                ("x", "0.3"),
                ("CCT", "3000"),
                ("Ra", "80"),
                ("LambdaD", "500"),
            ],
        );
        let rows = beside(&dark);
        assert!(rows.iter().all(|row| row.ours.is_err()));
        assert!(rows[2..].iter().all(|row| row.ours == Err(DARK)));
        let green = light("", 540.0, vec![0.0, 1.0, 0.0], &[("Ra", "0"), ("Rf", "0")]);
        for row in beside(&green) {
            let why = row.ours.expect_err("nothing");
            assert!(why.contains("blackbody locus"), "{}: {why}", row.quantity);
        }
    }

    #[test]
    fn colour_rendering_is_that_of_the_quality_figures() {
        // FL2 by CIE 13.3 and TM-30 as other programs have it: Ra 64, R9 -84, Rf 70, Rg 86.
        let entry = crate::app::open::resolve("cie_fluorescent_5nm/FL2", None, None).expect("FL2");
        let keys = ["Ra", "R9", "R15", "Rf", "Rg", "LambdaD", "Purity"];
        let results = keys.map(|key| MakersResult::of(Some(0), key, "1", false).expect(key));
        let entry = Entry {
            makers: results.to_vec(),
            ..entry
        };
        let (found, measured) = light_of(&entry.spectrum);
        let figures = Figures::of(&found, measured);
        let rendering = figures.rendering.expect("a lamp");
        let fidelity = figures.fidelity.expect("a lamp");
        let dominant = figures.dominant.expect("a tint");
        let expected = [
            rendering.ra,
            rendering.samples[8].index,
            rendering.samples[14].index,
            fidelity.rf,
            fidelity.rg,
            dominant.nm.expect("a hue"),
            100.0 * dominant.purity,
        ];
        for (row, expected) in beside(&entry).iter().zip(expected) {
            assert_eq!(row.ours, Ok(expected), "{}", row.quantity);
        }
        assert_relative_eq!(expected[0], 64.0, epsilon = 1.0);
        let wrong = MakersResult {
            quantity: Quantity::R(16),
            ..results[1].clone()
        };
        let entry = Entry {
            makers: vec![wrong],
            ..entry
        };
        assert_eq!(beside(&entry)[0].ours, Err(NOT_YET));
    }

    #[test]
    fn the_table_has_a_line_a_result() {
        let entry = light(
            "W m-2 nm-1",
            554.0,
            vec![0.0, 1.0, 0.0],
            &[("IRR", "1.25"), ("R:B", "90")],
        );
        let csv = table(&beside(&entry)).csv();
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines[0], "quantity,unit,instrument,ours,difference");
        assert_eq!(lines[1], "irradiance,W m-2,1.25,1,-0.25");
        assert_eq!(lines[2], "R:B,,90,,");
    }
}
