//! Every figure of one light.

use crate::{
    color::{
        Cct, Observer, Xyz, cct::cct_from_xyz, uv_1976_from_xyz, xy_from_xyz,
        xyz::xyz_from_nm_values,
    },
    languages::fixed,
};

use super::{
    SINGLES, Single,
    absolute::{Absolute, Measured, absolute},
    alpha_opic::{AlphaOpic, alpha_opic},
    dominant::{Dominant, dominant},
    fidelity::{Fidelity, fidelity},
    light::{FIRST_NM, LAST_NM, Light, POINTS, positive},
    no_figure::NoFigure,
    photons::{PhotonsPer100Lx, photons_per_100_lx},
    reference::DAYLIGHT_TO_K,
    rendering::{Rendering, rendering},
    shape::{Shape, shape},
    similarity::{Similarity, similarity},
};

/// Every figure of a light; each is itself or why it does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    /// CIE 1931, Y = 100.
    pub xyz: Result<Xyz, NoFigure>,
    /// Chromaticity for each of [`Observer::CIE`].
    pub xy: [Result<[f64; 2], NoFigure>; 4],
    /// CIE 1976 u'v' (CIE 1931 observer).
    pub uv: Result<[f64; 2], NoFigure>,
    /// Correlated colour temperature and Duv.
    pub cct: Result<Cct, NoFigure>,
    /// CRI.
    pub rendering: Result<Rendering, NoFigure>,
    /// TM-30.
    pub fidelity: Result<Fidelity, NoFigure>,
    /// Dominant wavelength and purity.
    pub dominant: Result<Dominant, NoFigure>,
    /// Those of one number, as [`SINGLES`].
    singles: [Result<f64, NoFigure>; SINGLES.len()],
    /// Alpha-opic ratios.
    pub alpha_opic: Result<AlphaOpic, NoFigure>,
    /// Photons that come with 100 lx.
    pub photons: Result<PhotonsPer100Lx, NoFigure>,
    /// Spectral similarity.
    pub similarity: Result<Similarity, NoFigure>,
    /// Peak, centroid, width.
    pub shape: Result<Shape, NoFigure>,
    /// Lux and the like, where the unit says what is measured.
    pub absolute: Result<Absolute, NoFigure>,
    /// Remarks on the figures, a sentence each.
    pub notes: Vec<String>,
}

/// The figures that a light is judged by first, on the tables of [`Figures`]: against the order of
/// a model, and wherever a light is designed.
#[derive(Clone, Debug, PartialEq)]
pub struct FewFigures {
    /// CRI.
    pub ra: Result<f64, NoFigure>,
    /// TM-30.
    pub rf: Result<f64, NoFigure>,
    /// TM-30.
    pub rg: Result<f64, NoFigure>,
    /// Correlated colour temperature and Duv.
    pub cct: Result<Cct, NoFigure>,
    /// Melanopic daylight efficacy ratio.
    pub melanopic_der: Result<f64, NoFigure>,
}

/// The parts of a light's figures that take time; colour, CCT and Duv are always there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Parts {
    /// CRI.
    pub rendering: bool,
    /// TM-30.
    pub fidelity: bool,
    /// All but these two.
    pub others: bool,
}

impl Figures {
    /// All figures of a light whose values measure what `measured` says.
    pub fn of(light: &Light, measured: Option<Measured>) -> Self {
        let all = Parts {
            rendering: true,
            fidelity: true,
            others: true,
        };
        Self::of_parts(light, measured, all)
    }

    /// Some of the figures; the others are left out.
    pub(crate) fn of_parts(light: &Light, measured: Option<Measured>, parts: Parts) -> Self {
        fn only<T>(
            is_wanted: bool,
            of: impl FnOnce() -> Result<T, NoFigure>,
        ) -> Result<T, NoFigure> {
            match is_wanted {
                true => of(),
                false => Err(NoFigure::LeftOut(later!("not asked for"))),
            }
        }
        let others = parts.others;
        let xyz = xyz_of(light, Observer::CIE_1931);
        let xy = Observer::CIE.map(|observer| chromaticity(light, observer));
        let cct = cct_of(&xyz);
        let mut figures = Self {
            uv: xyz.clone().and_then(uv_of),
            dominant: only(others, || dominant(xy[0].clone()?)),
            rendering: only(parts.rendering, || rendering(light, cct.clone()?)),
            fidelity: only(parts.fidelity, || fidelity(light, cct.clone()?)),
            singles: SINGLES.map(|single| only(others, || (single.of)(light))),
            alpha_opic: only(others, || alpha_opic(light)),
            photons: only(others, || photons_per_100_lx(light)),
            similarity: only(others, || {
                similarity(light, cct.clone().map(|cct| cct.kelvin))
            }),
            shape: only(others, || shape(light)),
            absolute: only(others, || absolute(light, measured)),
            notes: Vec::new(),
            xyz,
            xy,
            cct,
        };
        figures.notes = figures.noted(light);
        figures
    }

    /// Every figure of one number.
    pub(crate) fn singles(
        &self,
    ) -> impl Iterator<Item = (&'static Single, &Result<f64, NoFigure>)> {
        let all: &'static [Single] = &SINGLES;
        all.iter().zip(&self.singles)
    }

    /// A figure of one number.
    pub(crate) fn single(&self, wanted: &Single) -> Result<f64, NoFigure> {
        let is_it = |(single, _): &(&Single, _)| single.key == wanted.key;
        let found = self.singles().find(is_it);
        let (_, number) = found.unwrap_or_else(|| panic!("{} is not in SINGLES", wanted.key));
        number.clone()
    }

    fn noted(&self, light: &Light) -> Vec<String> {
        let mut notes = Vec::new();
        if light.lit().is_err() {
            return notes;
        }
        let negatives = light.negatives();
        if negatives > 0 {
            notes.push(tr!(
                "{negatives} of the values on whole nm are negative and were used as they are",
                negatives
            ));
        }
        let [first_nm, last_nm] = light.ends_nm();
        // What the luminosity function weighs outside is below 1e-4 of its whole.
        if first_nm > 380 || last_nm < 780 {
            notes.push(tr!(
                "the light is known from {first_nm} to {last_nm} nm only; what is missing of \
                 380-780 nm counts as zero",
                first_nm,
                last_nm
            ));
        }
        if let Ok(found) = &self.rendering
            && found.is_too_far()
        {
            notes.push(tr!(
                "Ra: the colour is {distance} from its reference in CIE 1960 uv; CIE 13.3 vouches \
                 for its index within 0.0054",
                distance = fixed(found.distance, 4)
            ));
        }
        if let Ok(found) = &self.fidelity {
            let empty = found.bins.iter().filter(|bin| bin.is_none()).count();
            if empty > 0 {
                notes.push(tr!(
                    "{empty} of the 16 hue bins hold no sample under this reference",
                    empty
                ));
            }
        }
        if let Ok(cct) = &self.cct
            && cct.kelvin > DAYLIGHT_TO_K
        {
            notes.push(tr!(
                "the formula of the daylight reference is stated up to {most} K and was used at \
                 {kelvin} K",
                most = fixed(DAYLIGHT_TO_K, 0),
                kelvin = fixed(cct.kelvin, 0)
            ));
        }
        if let Ok(found) = &self.dominant
            && found.purity > 1.0 + 1e-6
        {
            notes.push(
                said!("purity above 1: negative values take the colour beyond the locus")
                    .to_owned(),
            );
        }
        notes
    }
}

impl FewFigures {
    /// The few figures of a light.
    pub fn of(light: &Light) -> Self {
        let cct = cct_of(&xyz_of(light, Observer::CIE_1931));
        let found = cct.clone().and_then(|cct| fidelity(light, cct));
        let found = found.map(|found| (found.rf, found.rg));
        Self {
            ra: cct.clone().and_then(|cct| Ok(rendering(light, cct)?.ra)),
            rf: found.clone().map(|(rf, _)| rf),
            rg: found.map(|(_, rg)| rg),
            melanopic_der: alpha_opic(light).map(|found| found.melanopic_der()),
            cct,
        }
    }
}

/// XYZ with Y = 100.
fn xyz_of(light: &Light, observer: Observer) -> Result<Xyz, NoFigure> {
    let sums = sums_of(light.lit()?, observer);
    positive(sums.y, later!("sum with the luminosity function"))?;
    sums.with_y(100.0).ok_or(NoFigure::OutOfRange {
        what: later!("the sums with the colour-matching functions"),
    })
}

fn sums_of(light: &Light, observer: Observer) -> Xyz {
    let table = observer.table();
    let lines = light.lines().iter();
    let lines = lines.map(|l| Xyz::from_array(table.at(l.at_nm)) * l.weight);
    lines.fold(xyz_from_nm_values(light.values(), observer), |sum, line| {
        sum + line
    })
}

fn chromaticity(light: &Light, observer: Observer) -> Result<[f64; 2], NoFigure> {
    let first_nm = observer.table().first_nm;
    let from = (first_nm.saturating_sub(FIRST_NM) as usize).min(POINTS);
    let is_below = light.lit()?.values()[from..].iter().all(|v| *v == 0.0)
        && !light
            .lines()
            .iter()
            .any(|l| (f64::from(first_nm)..=f64::from(LAST_NM)).contains(&l.at_nm));
    if is_below {
        return Err(NoFigure::BelowObserver { observer, first_nm });
    }
    let sums = sums_of(light, observer);
    positive(sums.x + sums.y + sums.z, "X + Y + Z")?;
    xy_from_xyz(sums).ok_or(NoFigure::OutOfRange {
        what: later!("the sums with the colour-matching functions"),
    })
}

fn uv_of(xyz: Xyz) -> Result<[f64; 2], NoFigure> {
    uv_1976_from_xyz(xyz).ok_or(NoFigure::OutOfRange {
        what: later!("X + 15 Y + 3 Z is not positive"),
    })
}

fn cct_of(xyz: &Result<Xyz, NoFigure>) -> Result<Cct, NoFigure> {
    Ok(cct_from_xyz(xyz.clone()?)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::quality::SP_RATIO;
    use crate::spectrum::{Line, Sampled};

    #[test]
    fn the_unit_of_the_values_changes_no_ratio() {
        let light = |factor: f64| {
            let values = [3.0, 5.0, 2.0].map(|v| v * factor).to_vec();
            Light::of_sampled(&Sampled::new(vec![380.0, 550.0, 780.0], values).unwrap())
        };
        // A power of two leaves every bit as it is.
        assert_eq!(
            Figures::of(&light(1.0), None),
            Figures::of(&light(2.0_f64.powi(-900)), None)
        );
    }

    #[test]
    fn a_line_is_the_limit_of_a_narrow_triangle() {
        let line = Line::ideal(546.0, 1.0);
        let table = Sampled::new(vec![545.999, 546.0, 546.001], vec![0.0, 1000.0, 0.0]).unwrap();
        let (exact, narrow) = (Light::of_line(line), Light::of_sampled(&table));
        let (exact, narrow) = (Figures::of(&exact, None), Figures::of(&narrow, None));
        let (a, b) = (exact.xy[0].clone().unwrap(), narrow.xy[0].clone().unwrap());
        // The triangle's mean distance from its middle is 3e-4 nm, and the locus moves 0.01 a nm.
        assert!((a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5);
        let (a, b) = (
            exact.single(&SP_RATIO).unwrap(),
            narrow.single(&SP_RATIO).unwrap(),
        );
        assert!((a / b - 1.0).abs() < 1e-4);
    }
}
