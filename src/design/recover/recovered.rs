//! A spectrum made from colours, with what must be known to trust it.

use super::{
    error::RecoverError,
    fourier,
    metamers::{MetamerBand, metamer_band, metamer_examples},
    method::Method,
    possible,
    smoothest::smoothest,
    viewing::{BAND, NODES, Nodes, Viewing, sampled_nodes},
};
use crate::{
    color::{Xyz, delta_e_of_xyz, lab_from_xyz},
    spectrum::{Basis, Sampled, Series},
};

/// A colour under a light.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// The light and the observer.
    pub under: &'a Viewing,
    /// XYZ, Y = 100 for the light.
    pub xyz: Xyz,
}

/// A reflectance made from one colour or two.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovered {
    /// The method used.
    pub method: Method,
    /// The reflectance; nothing keeps a Fourier series in 0-1.
    pub reflectance: Reflectance,
    /// Its colours under the lights it was made from, Y = 100 for the light.
    pub xyz: Vec<Xyz>,
    /// Largest CIEDE2000 between the colours asked for and those it has.
    pub round_trip_delta_e: f64,
    /// Condition number of the equations that were solved for coefficients.
    pub condition_number: Option<f64>,
    /// The colours that came nearest, where no surface has those asked for.
    pub nearest: Option<Nearest>,
}

/// The nearest colours that a surface or a light of lines can have: of a surface by the CIE 1976
/// difference (the sum of squares of both lights'), of lines by CIE 1976 u'v'.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest {
    /// One a light, Y = 100 for the light.
    pub xyz: Vec<Xyz>,
    /// CIEDE2000 between what was asked for and what can be, one a light.
    pub delta_e: Vec<f64>,
    /// CIE 1976 difference, of which these are the nearest, one a light.
    pub delta_e_ab: Vec<f64>,
}

/// The values of a recovered reflectance.
#[derive(Clone, Debug, PartialEq)]
pub enum Reflectance {
    /// Every 5 nm, straight in between.
    Nodes(Box<Nodes>),
    /// A short series.
    Series(Series),
}

impl Reflectance {
    /// The values as a table of 380-780 nm: every 5 nm, a series every nm.
    pub fn sampled(&self) -> Sampled {
        match self {
            Self::Nodes(nodes) => sampled_nodes(nodes),
            Self::Series(series) => Sampled::even(BAND.min_nm(), 1.0, series.on_band())
                .expect("a finite series on a rising grid"),
        }
    }

    /// XYZ under a light, Y = 100 for the light: exact for the values as they are.
    pub fn xyz(&self, viewing: &Viewing) -> Xyz {
        match self {
            Self::Nodes(nodes) => viewing.xyz(nodes),
            Self::Series(series) => viewing.xyz_of_series(&series.coefficients),
        }
    }

    /// The lowest and the highest value.
    pub(crate) fn extent(&self) -> [f64; 2] {
        let values = match self {
            Self::Nodes(nodes) => nodes.to_vec(),
            Self::Series(series) => series.on_band(),
        };
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        let wider = |[low, high]: [f64; 2], v: &f64| [low.min(*v), high.max(*v)];
        values.iter().fold(ends, wider)
    }
}

impl Recovered {
    /// A reflectance of these colours, by a method.
    ///
    /// Colours that no surface can have are answered by the nearest ones that can, and
    /// [`Recovered::nearest`] says so.
    ///
    /// # Errors
    /// [`RecoverError::Colours`] for a number of colours that the method does not take,
    /// [`RecoverError::NotAColour`] for numbers that are not finite,
    /// [`RecoverError::SameLights`] where two lights tell no six numbers.
    pub fn new(method: Method, seen: &[Seen<'_>]) -> Result<Self, RecoverError> {
        if seen.iter().any(|seen| !seen.xyz.is_finite()) {
            return Err(RecoverError::NotAColour);
        }
        match (method, seen) {
            // Seen twice under one light it tells three numbers, not six.
            (Method::Smoothest, [one, two]) if one.under.is_alike(two.under) => {
                if one.xyz == two.xyz {
                    Self::new(method, &seen[..1])
                } else {
                    let condition = f64::INFINITY;
                    Err(RecoverError::SameLights { condition })
                }
            }
            (Method::Smoothest, [_]) => Self::bounded::<3>(seen, &columns_of(seen)),
            (Method::Smoothest, [_, _]) => Self::bounded::<6>(seen, &columns_of(seen)),
            (Method::Fourier3, [one]) => {
                let solved = fourier::three(one.under, target_of(seen));
                Self::series(method, seen, solved)
            }
            (Method::Fourier6, [one, two]) => {
                let solved = fourier::six([one.under, two.under], target_of(seen));
                Self::series(method, seen, solved)
            }
            _ => {
                let found = seen.len();
                Err(RecoverError::Colours { method, found })
            }
        }
    }

    /// True if every value lies in 0-1 (to rounding of the last digits of a series).
    pub(crate) fn is_inside_0_1(&self) -> bool {
        let [lowest, highest] = self.reflectance.extent();
        lowest >= -1e-12 && highest <= 1.0 + 1e-12
    }

    fn bounded<const M: usize>(
        seen: &[Seen<'_>],
        columns: &[[f64; M]; NODES],
    ) -> Result<Self, RecoverError> {
        if let Some((found, _)) = smoothest(columns, target_of(seen), None) {
            return Ok(Self::of(Method::Smoothest, seen, nodes(found), None, None));
        }
        let whites: Vec<Xyz> = seen.iter().map(|s| s.under.white() * 0.01).collect();
        let targets: Vec<Xyz> = seen.iter().map(|s| s.xyz * 0.01).collect();
        let reflectance = nodes(possible::nearest(columns, &whites, &targets));
        let xyz: Vec<Xyz> = seen.iter().map(|s| reflectance.xyz(s.under)).collect();
        let both = seen.iter().zip(&xyz);
        let apart = both.map(|(seen, xyz)| {
            let lab = |xyz: Xyz| lab_from_xyz(xyz, seen.under.white());
            lab(seen.xyz).delta_e_1976(lab(*xyz))
        });
        let nearest = Nearest {
            delta_e_ab: apart.collect(),
            delta_e: differences(seen, &xyz),
            xyz,
        };
        Ok(Self::of(
            Method::Smoothest,
            seen,
            reflectance,
            None,
            Some(nearest),
        ))
    }

    fn series(
        method: Method,
        seen: &[Seen<'_>],
        solved: fourier::Solved,
    ) -> Result<Self, RecoverError> {
        let (coefficients, condition) = match solved {
            Ok(found) => found,
            Err(condition) if seen.len() == 2 => {
                return Err(RecoverError::SameLights { condition });
            }
            Err(condition) => return Err(RecoverError::FewColours { condition }),
        };
        let reflectance = Reflectance::Series(Series {
            band: BAND,
            basis: Basis::Fourier,
            coefficients,
        });
        let nearest = if can_be(seen) {
            None
        } else {
            Self::new(Method::Smoothest, seen)?.nearest
        };
        Ok(Self::of(
            method,
            seen,
            reflectance,
            Some(condition),
            nearest,
        ))
    }

    fn of(
        method: Method,
        seen: &[Seen<'_>],
        reflectance: Reflectance,
        condition_number: Option<f64>,
        nearest: Option<Nearest>,
    ) -> Self {
        let xyz: Vec<Xyz> = seen.iter().map(|s| reflectance.xyz(s.under)).collect();
        let round_trip_delta_e = differences(seen, &xyz).into_iter().fold(0.0, f64::max);
        Self {
            method,
            reflectance,
            xyz,
            round_trip_delta_e,
            condition_number,
            nearest,
        }
    }
}

/// True if some surface has these colours; false for any number of colours but one or two.
pub(crate) fn can_be(seen: &[Seen<'_>]) -> bool {
    match seen {
        [_] => possible::is_possible::<3>(&columns_of(seen), target_of(seen)),
        [_, _] => possible::is_possible::<6>(&columns_of(seen), target_of(seen)),
        _ => false,
    }
}

/// Least and greatest reflectance over all surfaces of these colours; `None` where there is none,
/// and for another number of colours than one or two.
pub fn metamers(seen: &[Seen<'_>]) -> Option<MetamerBand> {
    match seen {
        [_] => metamer_band::<3>(&columns_of(seen), target_of(seen)),
        [_, _] => metamer_band::<6>(&columns_of(seen), target_of(seen)),
        _ => None,
    }
}

/// Smooth surfaces with the same colours as one, which is within 0 and 1: eight, or none for another
/// number of colours than one or two.
pub(crate) fn examples(seen: &[Seen<'_>], of: &Nodes) -> Vec<Nodes> {
    match seen {
        [_] => metamer_examples::<3>(&columns_of(seen), of),
        [_, _] => metamer_examples::<6>(&columns_of(seen), of),
        _ => Vec::new(),
    }
}

fn nodes(values: Nodes) -> Reflectance {
    Reflectance::Nodes(Box::new(values))
}

fn differences(seen: &[Seen<'_>], xyz: &[Xyz]) -> Vec<f64> {
    let both = seen.iter().zip(xyz);
    both.map(|(seen, xyz)| delta_e_of_xyz(seen.xyz, *xyz, seen.under.white()).unwrap_or(0.0))
        .collect()
}

/// Three or six numbers a node, the lights' one behind the other.
fn columns_of<const M: usize>(seen: &[Seen<'_>]) -> Box<[[f64; M]; NODES]> {
    let mut columns = Box::new([[0.0; M]; NODES]);
    for (node, column) in columns.iter_mut().enumerate() {
        for (row, value) in column.iter_mut().enumerate() {
            *value = seen[row / 3].under.columns[node][row % 3];
        }
    }
    columns
}

/// The colours, white = 1, one behind the other.
fn target_of<const M: usize>(seen: &[Seen<'_>]) -> [f64; M] {
    std::array::from_fn(|row| 0.01 * seen[row / 3].xyz.to_array()[row % 3])
}
