//! Which absorption line a dip may be named after.
//!
//! A wrong name is worse than none. A dip gets a name only when the measured curve shows most of
//! the other lines of the same family too: sunlight's Fraunhofer lines, holmium oxide's bands,
//! neodymium's. The witnesses are looked for in the curve itself, for a line may be too weak to be
//! a spike and still be seen. A dip near by that is none of them has no name. Once a family is
//! there, all its lines are looked for at their places, each by a threshold of its own, and those
//! that are too weak here are told as such ([`dark_lines`]).
//!
//! The places are facts of the literature. Fraunhofer's letters stand at the elements' own lines
//! in air (NIST Atomic Spectra Database: Ca II 393.37 and 396.85, H 410.17, 434.05, 486.13 and
//! 656.28, Fe 430.79 and 526.95, Mg 516.73-518.36, Na 589.00 and 589.59); oxygen and water of the
//! air begin where their bands' heads are. Holmium's are the peaks on the certificates of
//! holmium-glass filters; in oxide powder they stand up to 5 nm elsewhere (its own minima in USGS
//! splib07a: 386, 420, 451, 486, 538, 638 nm), hence the wide reach. Neodymium's are the bands of
//! didymium glass that praseodymium has no part in.

use crate::{
    languages::fixed,
    spectrum::{Band, Basis, Kind},
};

use super::{entry::Entry, line_names::LineName};

/// A line or band of a family.
struct Feature {
    /// What it is called beside a dip.
    name: &'static str,
    /// Where it stands, from and to, nm: the same twice for one line.
    nm: [f64; 2],
    /// Part of the light around it that is missing at least where it is seen, 0-1; `None` for one
    /// that is no witness: it comes and goes with the air.
    least: Option<f64>,
}

/// Lines that come together.
struct Family {
    /// What has them.
    title: &'static str,
    /// Whether they are bands, which spikes are not meant for.
    are_bands: bool,
    features: &'static [Feature],
    /// A dip may stand this far outside a feature, nm.
    reach_nm: f64,
    /// The light beside a feature is looked for this far from it, nm.
    shoulder_nm: f64,
    /// Witnesses that must be seen at least, whatever the range holds.
    witnesses: usize,
    /// Largest step of data that can show it, nm.
    coarsest_nm: f64,
    /// What may have it.
    kinds: &'static [Kind],
}

const fn line(name: &'static str, at_nm: f64, least: f64) -> Feature {
    band(name, [at_nm, at_nm], Some(least))
}

const fn band(name: &'static str, nm: [f64; 2], least: Option<f64>) -> Feature {
    Feature { name, nm, least }
}

/// Sunlight: Fraunhofer's lines, and those of the air below it.
const SUN: Family = Family {
    title: "sunlight",
    are_bands: false,
    features: &[
        line("Ca K 393.4", 393.37, 0.1),
        line("Ca H 396.8", 396.85, 0.1),
        line("H-delta 410.2", 410.17, 0.02),
        line("G band 430.8", 430.79, 0.05),
        line("H-gamma 434.0", 434.05, 0.02),
        line("H-beta 486.1", 486.13, 0.03),
        band("Mg b 517-518", [516.73, 518.36], Some(0.03)),
        line("Fe E 527.0", 526.95, 0.02),
        band("Na D 589.3", [589.0, 589.59], Some(0.02)),
        line("H-alpha 656.3", 656.28, 0.03),
        band("O2 B 687-688", [686.7, 688.4], None),
        band("H2O 718-730", [718.0, 730.0], None),
        band("O2 A 759-762", [759.4, 762.1], None),
        band("H2O 810-830", [810.0, 830.0], None),
        band("H2O 930-950", [930.0, 950.0], None),
    ],
    reach_nm: 1.0,
    shoulder_nm: 5.0,
    witnesses: 4,
    coarsest_nm: 1.5,
    kinds: &[Kind::Light],
};

/// Holmium oxide, in glass or as powder.
const HOLMIUM: Family = Family {
    title: "holmium oxide",
    are_bands: true,
    features: &[
        line("Ho band 241.5", 241.5, 0.05),
        line("Ho band 279", 279.4, 0.05),
        line("Ho band 288", 287.5, 0.05),
        line("Ho band 334", 333.7, 0.05),
        line("Ho band 361", 360.9, 0.1),
        line("Ho band 386", 385.8, 0.02),
        line("Ho band 419", 418.7, 0.1),
        line("Ho band 453", 453.2, 0.1),
        line("Ho band 460", 460.0, 0.0),
        line("Ho band 484", 484.5, 0.02),
        line("Ho band 536", 536.2, 0.1),
        line("Ho band 638", 637.5, 0.02),
    ],
    reach_nm: 5.0,
    shoulder_nm: 25.0,
    witnesses: 4,
    coarsest_nm: 5.0,
    kinds: &[Kind::Reflectance, Kind::Transmittance],
};

const NEODYMIUM_TITLE: &str = "neodymium";

/// Neodymium in glass: a filter, or a lamp with a bulb of it.
const NEODYMIUM: Family = Family {
    title: NEODYMIUM_TITLE,
    are_bands: true,
    features: &[
        line("Nd band 512", 512.0, 0.01),
        line("Nd band 529", 529.0, 0.04),
        band("Nd band 573-585", [573.0, 585.0], Some(0.2)),
        band("Nd band 740-748", [740.0, 748.0], Some(0.1)),
        line("Nd band 807", 807.0, 0.1),
    ],
    reach_nm: 3.0,
    shoulder_nm: 25.0,
    witnesses: 3,
    coarsest_nm: 5.0,
    kinds: &[Kind::Light, Kind::Reflectance, Kind::Transmittance],
};

const FAMILIES: [&Family; 3] = [&SUN, &HOLMIUM, &NEODYMIUM];

/// From this depth on a feature is deep: no family is there without it.
const DEEP: f64 = 0.2;

/// Largest ratio of the highest to the median value on a side of a deep feature.
const UNEVEN: f64 = 1.7;

/// Largest ratio of the medians of both sides.
const UNLIKE: f64 = 3.0;

/// Share of a family's witnesses in the range that must be seen.
const MOST_OF_THEM: f64 = 0.75;

/// What comes and goes with the air is seen from this depth on.
const OF_THE_AIR: f64 = 0.05;

/// A measured curve on a grid, and what is known of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curve<'a> {
    /// What its values stand for.
    pub kind: Kind,
    /// The grid.
    pub band: Band,
    /// The measured values on it.
    pub values: &'a [f64],
    /// The data's own step, nm.
    pub step_nm: f64,
}

impl<'a> Curve<'a> {
    /// The curve of an entry whose values on the band's grid are `values`.
    pub(super) fn of(entry: &Entry, band: Band, values: &'a [f64]) -> Self {
        Self {
            kind: entry.kind(),
            band,
            values,
            step_nm: mean_step_nm(entry),
        }
    }

    /// Whether there is a dip in the curve at a feature: lower than what stands on both sides.
    fn shows(&self, family: &Family, feature: &Feature, least: f64) -> bool {
        let depth = self.depth(family, feature, least >= DEEP);
        depth.is_some_and(|depth| depth > least)
    }

    /// Share of the light beside a feature that is missing at it; `None` where there is no light
    /// beside it.
    ///
    /// Beside a deep one the curve must be even, and alike on both sides: a valley between two
    /// lines of a lamp is deep too.
    fn depth(&self, family: &Family, feature: &Feature, is_deep: bool) -> Option<f64> {
        let [from, to] = feature.nm;
        let (from, to) = (from - family.reach_nm, to + family.reach_nm);
        // Median and largest.
        let beside = |low: f64, high: f64| {
            let values = self.sorted(low, high);
            Some([*values.get(values.len() / 2)?, *values.last()?])
        };
        let bottom = self.sorted(from, to).first().copied()?;
        let left = beside(from - family.shoulder_nm, from)?;
        let right = beside(to, to + family.shoulder_nm)?;
        let uneven = |[median, largest]: [f64; 2]| largest > UNEVEN * median;
        let unlike = left[0].max(right[0]) > UNLIKE * left[0].min(right[0]);
        if is_deep && (uneven(left) || uneven(right) || unlike) {
            return None;
        }
        let which = usize::from(!is_deep);
        let beside = left[which].min(right[which]);
        (beside > 0.0).then(|| 1.0 - bottom / beside)
    }

    /// The values between two wavelengths, the lowest first.
    fn sorted(&self, low_nm: f64, high_nm: f64) -> Vec<f64> {
        let within = |(nm, _): &(f64, &f64)| (low_nm..=high_nm).contains(nm);
        let places = self.band.grid().zip(self.values).filter(within);
        let mut values: Vec<f64> = places.map(|(_, v)| *v).collect();
        values.sort_by(f64::total_cmp);
        values
    }

    /// Whether the band reaches some way beyond a feature on both sides.
    fn surrounds(&self, family: &Family, feature: &Feature) -> bool {
        let margin = family.reach_nm + 1.0;
        let [from, to] = feature.nm;
        self.band.contains(from - margin) && self.band.contains(to + margin)
    }

    /// Whether most of a family's lines are in the curve, its deep ones all.
    fn is_of(&self, family: &Family) -> bool {
        if !family.kinds.contains(&self.kind) || self.step_nm > family.coarsest_nm {
            return false;
        }
        // A witness must be in the range with some light on both sides.
        let inside = |f: &&Feature| self.surrounds(family, f);
        let witnesses = family.features.iter().filter(inside);
        let (mut seen, mut all) = (0, 0);
        for feature in witnesses {
            let Some(least) = feature.least else {
                continue;
            };
            let is_there = self.shows(family, feature, least);
            if least >= DEEP && !is_there {
                return false;
            }
            all += 1;
            seen += usize::from(is_there);
        }
        seen >= family.witnesses && seen as f64 >= MOST_OF_THEM * all as f64
    }
}

/// Names of dips that stand at `places` (nm) of a curve, in their order.
pub(super) fn name_dips(places: &[f64], curve: Curve<'_>) -> Vec<LineName> {
    let mut names = vec![LineName::default(); places.len()];
    for family in FAMILIES.into_iter().filter(|family| curve.is_of(family)) {
        for feature in family.features {
            let off = |at_nm: f64| {
                let [from, to] = feature.nm;
                (from - at_nm).max(at_nm - to).max(0.0)
            };
            // A wide band is many lines, any other feature is one dip: the nearest.
            let is_wide = feature.nm[1] - feature.nm[0] > 2.0 * family.reach_nm;
            let hit = |at_nm: &f64| off(*at_nm) <= family.reach_nm;
            let nearest = places
                .iter()
                .enumerate()
                .filter(|(_, at_nm)| hit(at_nm))
                .min_by(|a, b| {
                    let middle = 0.5 * (feature.nm[0] + feature.nm[1]);
                    (a.1 - middle).abs().total_cmp(&(b.1 - middle).abs())
                })
                .map(|(index, _)| index);
            for (index, name) in names.iter_mut().enumerate() {
                let is_it = if is_wide {
                    hit(&places[index])
                } else {
                    nearest == Some(index)
                };
                if is_it && name.safe.is_none() {
                    name.safe = Some(feature.name.to_owned());
                    name.label.clone_from(&name.safe);
                }
            }
        }
    }
    names
}

/// Whether a light's curve is one of dark lines, in which what stands up is what is left.
pub(super) fn has_dark_lines(curve: Curve<'_>) -> bool {
    FAMILIES.into_iter().any(|family| curve.is_of(family))
}

/// A known dark line or band, looked for at its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DarkLine {
    pub name: &'static str,
    /// Where it stands, from and to, nm.
    pub nm: [f64; 2],
    /// Share of the light beside it that is missing, 0-1.
    pub depth: f64,
    /// Whether it is as deep as it must be to be seen; otherwise it is known, and too weak here.
    pub is_seen: bool,
}

/// A family of dark lines that is in a curve.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DarkFamily {
    /// What has these lines: "sunlight".
    pub title: &'static str,
    /// Whether they are bands and no lines.
    pub are_bands: bool,
    /// All of it that the band holds, by rising wavelength; of what the air takes only what is
    /// seen.
    pub lines: Vec<DarkLine>,
}

/// The families of dark lines in a curve, each line looked for at its own place, whatever a
/// detector's threshold is.
pub(super) fn dark_lines(curve: Curve<'_>) -> Vec<DarkFamily> {
    let there = FAMILIES.into_iter().filter(|family| curve.is_of(family));
    let told = |family: &Family| -> Vec<DarkLine> {
        let inside = family
            .features
            .iter()
            .filter(|f| curve.surrounds(family, f));
        let found = inside.filter_map(|feature| {
            let is_of_the_air = feature.least.is_none();
            let least = feature.least.unwrap_or(OF_THE_AIR);
            let depth = curve.depth(family, feature, least >= DEEP).unwrap_or(0.0);
            let is_seen = depth > least;
            let line = DarkLine {
                name: feature.name,
                nm: feature.nm,
                depth: depth.max(0.0),
                is_seen,
            };
            (is_seen || !is_of_the_air).then_some(line)
        });
        found.collect()
    };
    there
        .map(|family| DarkFamily {
            title: family.title,
            are_bands: family.are_bands,
            lines: told(family),
        })
        .collect()
}

impl DarkLine {
    /// The middle of where it stands, nm.
    pub fn at_nm(&self) -> f64 {
        0.5 * (self.nm[0] + self.nm[1])
    }
}

impl DarkFamily {
    /// What is to be said of a family of bands, with the order from which on a series follows
    /// bands as narrow as the narrowest seen; `None` for lines, which spikes are for.
    pub(super) fn advice(&self, curve: Curve<'_>, basis: Basis) -> Option<String> {
        if !self.are_bands {
            return None;
        }
        let seen = self.lines.iter().filter(|line| line.is_seen);
        let widths = seen.filter_map(|line| half_width_nm(curve, line));
        let narrowest = widths.fold(f64::INFINITY, f64::min);
        // The highest function turns once within a band: cosines have half a period on the range
        // for each order, Fourier's a whole one.
        let turns = basis.half_turns() as f64;
        let order = (curve.band.length_nm() / (turns * narrowest)).ceil();
        let order = order.is_finite().then(|| fixed(order, 0));
        Some(match (self.title, order) {
            (NEODYMIUM_TITLE, Some(order)) => tr!(
                "The dips of neodymium are bands, not lines, and lines do not fit them. More \
                 waves follow them, from about {order} waves on.",
                order
            ),
            (NEODYMIUM_TITLE, None) => tr!(
                "The dips of neodymium are bands, not lines, and lines do not fit them. More \
                 waves follow them."
            ),
            (_, Some(order)) => tr!(
                "The dips of holmium oxide are bands, not lines, and lines do not fit them. More \
                 waves follow them, from about {order} waves on.",
                order
            ),
            (_, None) => tr!(
                "The dips of holmium oxide are bands, not lines, and lines do not fit them. More \
                 waves follow them."
            ),
        })
    }
}

/// Full width of a band at half its depth, nm; `None` where the curve does not come up on both
/// sides.
fn half_width_nm(curve: Curve<'_>, line: &DarkLine) -> Option<f64> {
    let values = curve.values;
    let middle = 0.5 * (line.nm[0] + line.nm[1]);
    let about = (0..values.len()).filter(|i| (curve.band.nm(*i) - middle).abs() <= 6.0);
    let lowest = about.min_by(|a, b| values[*a].total_cmp(&values[*b]))?;
    let half = values[lowest] / (1.0 - line.depth) * (1.0 - 0.5 * line.depth);
    let left = (0..lowest).rev().find(|i| values[*i] >= half)?;
    let right = (lowest + 1..values.len()).find(|i| values[*i] >= half)?;
    Some(curve.band.nm(right) - curve.band.nm(left))
}

/// The table's mean step, nm: the median would have to sort a large table at every move.
fn mean_step_nm(entry: &Entry) -> f64 {
    let samples = &entry.spectrum.samples;
    (samples.last_nm() - samples.first_nm()) / (samples.len().max(2) - 1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::entry::bundled_entries, spectrum::Factor, spectrum::SpikeSettings};

    fn families_of(entry: &Entry, band: Band) -> Vec<usize> {
        let values = entry.on_band(band);
        let curve = Curve::of(entry, band, &values);
        (0..FAMILIES.len())
            .filter(|family| curve.is_of(FAMILIES[*family]))
            .collect()
    }

    #[test]
    fn of_all_shipped_spectra_only_sunlight_holmium_and_neodymium_are_taken_for_themselves() {
        let mut wrong = Vec::new();
        for band in [Band::VISIBLE, Band::new(380.0, 700.0).unwrap()] {
            for entry in bundled_entries() {
                let expected = match entry.name() {
                    name if name.starts_with("ASTM G173") => vec![0],
                    name if name.starts_with("Holmium") => vec![1],
                    name if name.starts_with("Neodimium") => vec![2],
                    _ => Vec::new(),
                };
                let found = families_of(entry, band);
                if found != expected {
                    wrong.push(format!("{} {band:?} {found:?}", entry.key));
                }
            }
        }
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn a_smooth_curve_has_no_name_and_neither_has_a_lone_dip() {
        let band = Band::VISIBLE;
        let flat = vec![1.0; band.points()];
        let at = |values: &[f64], places: &[f64]| {
            let curve = Curve {
                kind: Kind::Light,
                band,
                values,
                step_nm: 1.0,
            };
            name_dips(places, curve)
        };
        assert_eq!(at(&flat, &[589.3])[0], LineName::default());
        let dented: Vec<f64> = band
            .grid()
            .map(|nm| 1.0 - 0.8 * (-(nm - 589.0_f64).powi(2)).exp())
            .collect();
        assert_eq!(at(&dented, &[589.0])[0], LineName::default());
    }

    #[test]
    fn one_line_names_one_dip_a_wide_band_all_that_stand_in_it() {
        let sun = bundled_entries()
            .iter()
            .find(|e| e.name().contains("AM1.5G"))
            .unwrap();
        let band = Band::new(380.0, 1000.0).unwrap();
        let values = sun.on_band(band);
        let curve = Curve::of(sun, band, &values);
        let names = name_dips(&[589.2, 589.9, 658.0, 720.0, 726.0], curve);
        let safe: Vec<_> = names.iter().map(|n| n.safe.as_deref()).collect();
        let water = Some("H2O 718-730");
        assert_eq!(safe, [Some("Na D 589.3"), None, None, water, water]);
    }

    #[test]
    fn the_bands_of_neodymium_are_named_in_a_filter_too() {
        let band = Band::VISIBLE;
        let dip = |nm: f64, at: f64, width: f64| (-((nm - at) / width).powi(2)).exp();
        let values: Vec<f64> = band
            .grid()
            .map(|nm| {
                0.9 - 0.2 * dip(nm, 512.5, 2.5)
                    - 0.3 * dip(nm, 529.4, 3.0)
                    - 0.8 * dip(nm, 583.0, 3.5)
                    - 0.6 * dip(nm, 745.0, 4.0)
            })
            .collect();
        let settings = SpikeSettings {
            threshold: 0.001,
            ..SpikeSettings::default()
        };
        let factor = Factor::keeping_dips(band, values.clone(), settings);
        let places: Vec<f64> = factor.dips().iter().map(|d| d.at_nm).collect();
        let curve = Curve {
            kind: Kind::Transmittance,
            band,
            values: &values,
            step_nm: 1.0,
        };
        let names = name_dips(&places, curve);
        let safe: Vec<_> = names.iter().filter_map(|n| n.safe.as_deref()).collect();
        assert_eq!(
            safe,
            [
                "Nd band 512",
                "Nd band 529",
                "Nd band 573-585",
                "Nd band 740-748"
            ]
        );
    }

    fn entry(id: &str) -> std::sync::Arc<Entry> {
        let mut all = bundled_entries().iter();
        all.find(|e| e.key == id).expect(id).clone()
    }

    fn families(id: &str, band: Band) -> Vec<DarkFamily> {
        let entry = entry(id);
        let values = entry.on_band(band);
        dark_lines(Curve::of(&entry, band, &values))
    }

    #[test]
    fn sodium_and_hydrogen_are_found_in_the_sun_on_the_ground_and_in_space() {
        for id in [
            "solar_astm_g173/ASTM G173-03 extraterrestrial",
            "solar_astm_g173/ASTM G173-03 global tilt AM1.5G",
            "solar_astm_g173/ASTM G173-03 direct+circumsolar AM1.5D",
        ] {
            let families = families(id, Band::VISIBLE);
            let [sun] = &families[..] else {
                panic!("{id}: {families:?}");
            };
            assert_eq!((sun.title, sun.are_bands), ("sunlight", false));
            for name in ["Na D 589.3", "H-beta 486.1", "Ca K 393.4"] {
                let line = sun.lines.iter().find(|line| line.name == name);
                assert!(line.is_some_and(|line| line.is_seen), "{id}: {name}");
            }
            // What the air takes is told where there is air, and not known where there is none.
            let oxygen = sun.lines.iter().any(|line| line.name == "O2 A 759-762");
            assert_eq!(oxygen, !id.ends_with("extraterrestrial"), "{id}");
            for line in &sun.lines {
                assert!((0.0..=1.0).contains(&line.depth), "{line:?}");
            }
        }
    }

    #[test]
    fn a_line_too_weak_to_be_seen_is_told_as_known() {
        let sun = entry("solar_astm_g173/ASTM G173-03 extraterrestrial");
        let band = Band::VISIBLE;
        let mut values = sun.on_band(band);
        // Sodium's line filled up to what stands beside it.
        for (nm, value) in band.grid().zip(&mut values) {
            if (587.0..=592.0).contains(&nm) {
                *value = 1.8;
            }
        }
        let families = dark_lines(Curve::of(&sun, band, &values));
        let sodium = families[0]
            .lines
            .iter()
            .find(|line| line.name == "Na D 589.3");
        assert!(sodium.is_some_and(|line| !line.is_seen), "{families:?}");
    }

    #[test]
    fn holmiums_dips_are_called_bands_and_more_orders_are_offered() {
        let id = "usgs_splib07/Holmium oxide powder (USGS splib07a Record 18789)";
        let band = Band::new(380.0, 700.0).unwrap();
        let families = families(id, band);
        let [holmium] = &families[..] else {
            panic!("{families:?}");
        };
        let mut lines = holmium.lines.iter();
        assert!(lines.all(|line| line.name.starts_with("Ho band ")));
        let entry = entry(id);
        let values = entry.on_band(band);
        let curve = Curve::of(&entry, band, &values);
        let fourier = holmium.advice(curve, Basis::Fourier).expect("bands");
        let cosine = holmium.advice(curve, Basis::Cosine).expect("bands");
        assert!(fourier.contains("bands, not lines"), "{fourier}");
        let order = |words: &str| -> f64 {
            let rest = words.split("from about ").nth(1).expect("an order");
            rest.split(' ').next().unwrap().parse().expect("a number")
        };
        println!("{fourier}");
        // A cosine needs twice the order for the same turns.
        assert!((order(&cosine) / order(&fourier) - 2.0).abs() < 0.1);
        assert!((5.0..60.0).contains(&order(&fourier)), "{fourier}");
    }
}
