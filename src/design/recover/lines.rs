//! A light of lines at known places over a background of known shape, from its colour.
//!
//! The paper's fluorescent lamp: the places of the lines are known (mercury's), their weights are
//! not. Its three Fourier terms for the phosphor do not do (a phosphor is no three terms, and the
//! line at 405 nm came out wrong by all of itself), so the background's shape is taken from a
//! lamp and only its amount is solved for.
//!
//! Every colour is three equations: that of the light itself, and those of surfaces of known
//! reflectance under it. Fewer equations than unknowns leave a family; of it the light is taken
//! whose powers have the least sum of squares, which shares the power out as evenly as the colour
//! allows. More equations are met in the least squares, and what is left over is told.
//!
//! Powers and XYZ go together: `XYZ = sum over nm of power per nm x colour-matching function`, so a
//! light asked for with Y = 100 has luminous sum 100.

use nalgebra::DMatrix;

use super::{error::RecoverError, method::Method, recovered::Nearest, viewing::BAND};
use crate::{
    color::{Observer, Xyz, delta_e_of_xyz, lab_from_xyz, uv_1976_from_xyz, xyz},
    design::{gamut::nearest_mix, least_squares::least_squares, programme::End},
    spectrum::{Line, Outside, Sampled, condition_number},
};

/// Most lines that are solved for.
const MOST_LINES: usize = 32;

/// A colour of the light, or of a surface under it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LitColour<'a> {
    /// The surface; `None` for the light itself.
    pub surface: Option<&'a Sampled>,
    /// XYZ, all colours in the same scale.
    pub xyz: Xyz,
}

/// A light of lines over a background.
#[derive(Clone, Debug, PartialEq)]
pub struct LineLight {
    /// The background on the whole nm of 380-780, per nm.
    pub background: Vec<f64>,
    /// The lines by rising place, weights in power (the background's unit x nm).
    pub lines: Vec<Line>,
    /// XYZ of each colour asked for, as this light gives it.
    pub xyz: Vec<Xyz>,
    /// Largest CIEDE2000 between asked and given, against the light's own colour.
    pub round_trip_delta_e: f64,
    /// Root of the summed squares of what is left over in all XYZ, as a share of those asked for.
    pub residual: f64,
    /// Ratio of the greatest to the least singular value of the equations, each unknown at unit
    /// power.
    pub condition_number: f64,
    /// The nearest colour in CIE 1976 u'v', where one colour was asked for and no mixture has it.
    pub nearest: Option<Nearest>,
}

impl LineLight {
    /// Values on the whole nm of 380-780, each line split over its two neighbours.
    pub(crate) fn on_band(&self) -> Vec<f64> {
        let mut values = self.background.clone();
        add_lines(&self.lines, &mut values);
        values
    }

    /// Solves for the weights of lines at `lines_nm` over a background of the shape of
    /// `background` in 380-780 nm.
    ///
    /// # Errors
    /// [`RecoverError::Lines`] and [`RecoverError::LineOutside`] for lines, [`RecoverError::NoBackground`]
    /// for the shape, [`RecoverError::Colours`] without a colour, [`RecoverError::NotAColour`] for
    /// numbers that are not finite and for a light without Y.
    pub(crate) fn new(
        lines_nm: &[f64],
        background: &Sampled,
        colours: &[LitColour<'_>],
        observer: Observer,
    ) -> Result<Self, RecoverError> {
        let mut places = lines_nm.to_vec();
        places.sort_by(f64::total_cmp);
        places.dedup();
        if places.is_empty() || places.len() > MOST_LINES {
            return Err(RecoverError::Lines {
                found: places.len(),
            });
        }
        if let Some(found_nm) = places.iter().copied().find(|nm| !BAND.contains(*nm)) {
            return Err(RecoverError::LineOutside { found_nm });
        }
        let (method, found) = (Method::Lines, colours.len());
        if colours.is_empty() {
            return Err(RecoverError::Colours { method, found });
        }
        if colours.iter().any(|c| !c.xyz.is_finite()) {
            return Err(RecoverError::NotAColour);
        }
        let shape = background.on_band(BAND, Outside::Zero);
        let power: f64 = shape.iter().sum();
        if !(power > 0.0 && power.is_finite() && shape.iter().all(|v| *v >= 0.0)) {
            return Err(RecoverError::NoBackground);
        }
        let shape: Vec<f64> = shape.iter().map(|v| v / power).collect();
        // Unknowns: the background's power, then the lines'.
        let mut parts = vec![shape.clone()];
        for at_nm in &places {
            let mut values = vec![0.0; BAND.points()];
            add_lines(&[Line::ideal(*at_nm, 1.0)], &mut values);
            parts.push(values);
        }
        let equations: Vec<Vec<f64>> = parts
            .iter()
            .map(|part| {
                colours
                    .iter()
                    .flat_map(|c| seen(part, c, observer))
                    .collect()
            })
            .collect();
        let (weights, nearest) = solved(&equations, colours)?;
        let line = |(at_nm, weight): (&f64, &f64)| Line::ideal(*at_nm, *weight);
        let xyz = given(&equations, &weights);
        let white = colours.iter().position(|c| c.surface.is_none());
        Ok(Self {
            background: shape.iter().map(|v| v * weights[0]).collect(),
            lines: places.iter().zip(&weights[1..]).map(line).collect(),
            round_trip_delta_e: largest_difference(colours, &xyz, white),
            residual: left_over(colours, &xyz),
            // Of a matrix that is wider than high: the singular values of its rows.
            condition_number: condition_number(
                &equations.iter().map(Vec::as_slice).collect::<Vec<_>>(),
            ),
            xyz,
            nearest,
        })
    }
}

/// Lines split over their two neighbouring nm, for plain sums: the ends of the range count in full.
fn add_lines(lines: &[Line], values: &mut [f64]) {
    for line in lines {
        let x = line.at_nm - BAND.min_nm();
        let left = (x as usize).min(BAND.steps() - 1);
        let share = x - left as f64;
        values[left] += line.weight * (1.0 - share);
        values[left + 1] += line.weight * share;
    }
}

/// XYZ of a part of the light, or of a surface under it.
fn seen(part: &[f64], colour: &LitColour<'_>, observer: Observer) -> [f64; 3] {
    let mut values = vec![0.0; xyz::POINTS];
    let first = BAND.min_nm() as usize - xyz::FIRST_NM as usize;
    values[first..first + part.len()].copy_from_slice(part);
    if let Some(surface) = colour.surface {
        let shares = surface.on_whole_nm(xyz::FIRST_NM, xyz::LAST_NM, Outside::Hold);
        values.iter_mut().zip(&shares).for_each(|(v, r)| *v *= r);
    }
    xyz::xyz_from_nm_values(&values, observer).to_array()
}

/// The powers, and the nearest colour where the only one asked for cannot be.
fn solved(
    equations: &[Vec<f64>],
    colours: &[LitColour<'_>],
) -> Result<(Vec<f64>, Option<Nearest>), RecoverError> {
    let count = equations.len();
    let not_solved = |end: End| RecoverError::NotSolved {
        why: end.to_string(),
    };
    let [one] = colours else {
        let asked: Vec<f64> = colours.iter().flat_map(|c| c.xyz.to_array()).collect();
        let columns: Vec<&[f64]> = equations.iter().map(Vec::as_slice).collect();
        let weights = least_squares(&columns, &asked, &vec![[]; count], []);
        return Ok((weights.map_err(not_solved)?, None));
    };
    let rows: Vec<[f64; 3]> = equations.iter().map(|e| [e[0], e[1], e[2]]).collect();
    // Nothing to match but the colour: the least sum of squares.
    let own = DMatrix::<f64>::identity(count, count);
    let own: Vec<&[f64]> = own.as_slice().chunks_exact(count).collect();
    match least_squares(&own, &vec![0.0; count], &rows, one.xyz.to_array()) {
        Ok(weights) => return Ok((weights, None)),
        Err(End::Impossible) => {}
        Err(end) => return Err(not_solved(end)),
    }
    let uv = uv_1976_from_xyz(one.xyz).filter(|_| one.xyz.y > 0.0);
    let uv = uv.ok_or(RecoverError::NotAColour)?;
    let mix = nearest_mix(&rows, uv, one.xyz.y).ok_or(RecoverError::NoBackground)?;
    let xyz = given(equations, &mix.weights);
    let delta_e = delta_e_of_xyz(one.xyz, xyz[0], one.xyz).unwrap_or(0.0);
    let lab = |xyz: Xyz| lab_from_xyz(xyz, one.xyz);
    let nearest = Nearest {
        delta_e_ab: vec![lab(one.xyz).delta_e_1976(lab(xyz[0]))],
        xyz,
        delta_e: vec![delta_e],
    };
    Ok((mix.weights, Some(nearest)))
}

/// The colours that these powers give.
fn given(equations: &[Vec<f64>], weights: &[f64]) -> Vec<Xyz> {
    let rows = equations.first().map_or(0, Vec::len);
    let value = |row: usize| equations.iter().zip(weights).map(|(e, w)| e[row] * w).sum();
    let values: Vec<f64> = (0..rows).map(value).collect();
    values
        .chunks_exact(3)
        .map(|c| Xyz::new(c[0], c[1], c[2]))
        .collect()
}

fn largest_difference(colours: &[LitColour<'_>], given: &[Xyz], light: Option<usize>) -> f64 {
    let brightest = || {
        let y = |c: &&LitColour<'_>| c.xyz.y;
        colours
            .iter()
            .max_by(|a, b| y(a).total_cmp(&y(b)))
            .map(|c| c.xyz)
    };
    let white = light.map(|at| colours[at].xyz).or_else(brightest);
    let white = white.unwrap_or(Xyz::ZERO);
    let both = colours.iter().zip(given);
    both.filter_map(|(c, xyz)| delta_e_of_xyz(c.xyz, *xyz, white))
        .fold(0.0, f64::max)
}

fn left_over(colours: &[LitColour<'_>], given: &[Xyz]) -> f64 {
    let square = |xyz: Xyz| xyz.to_array().iter().map(|v| v * v).sum::<f64>();
    let all: f64 = colours.iter().map(|c| square(c.xyz)).sum();
    let rest: f64 = colours
        .iter()
        .zip(given)
        .map(|(c, xyz)| square(c.xyz - *xyz))
        .sum();
    if all > 0.0 { (rest / all).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MERCURY_NM: [f64; 4] = [404.7, 435.8, 546.1, 578.0];

    fn phosphor() -> Sampled {
        let nm: Vec<f64> = (380..=780).step_by(5).map(f64::from).collect();
        let value = |nm: &f64| (-((nm - 580.0) / 50.0).powi(2)).exp();
        let values = nm.iter().map(value).collect();
        Sampled::new(nm, values).unwrap()
    }

    /// A lamp whose powers are known, as colours of itself and of ramps under it.
    fn lamp(places: &[f64], powers: &[f64], surfaces: &[Sampled]) -> Vec<Xyz> {
        let shape = phosphor().on_band(BAND, Outside::Zero);
        let sum: f64 = shape.iter().sum();
        let mut values: Vec<f64> = shape.iter().map(|v| v / sum * powers[0]).collect();
        for (at_nm, weight) in places.iter().zip(&powers[1..]) {
            add_lines(&[Line::ideal(*at_nm, *weight)], &mut values);
        }
        let surface = |surface| LitColour {
            surface,
            xyz: Xyz::ZERO,
        };
        std::iter::once(None)
            .chain(surfaces.iter().map(Some))
            .map(|s| Xyz::from_array(seen(&values, &surface(s), Observer::CIE_1931)))
            .collect()
    }

    fn ramps() -> Vec<Sampled> {
        [
            [0.9, 0.1, 0.2, 0.3],
            [0.1, 0.8, 0.2, 0.9],
            [0.5, 0.2, 0.9, 0.1],
            [0.2, 0.3, 0.1, 0.8],
        ]
        .iter()
        .map(|v| Sampled::new(vec![400.0, 480.0, 560.0, 640.0], v.to_vec()).unwrap())
        .collect()
    }

    #[test]
    fn one_colour_is_met_by_a_light_of_no_negative_power() {
        let xyz = Xyz::new(98.0, 100.0, 60.0);
        let colour = LitColour { surface: None, xyz };
        let found =
            LineLight::new(&MERCURY_NM, &phosphor(), &[colour], Observer::CIE_1931).unwrap();
        // Least squares meet their equations to the rounding of one elimination.
        assert!(found.round_trip_delta_e < 1e-6 && found.residual < 1e-9);
        assert!(found.lines.iter().all(|line| line.weight >= 0.0));
        assert!(found.background.iter().all(|v| *v >= 0.0) && found.nearest.is_none());
    }

    #[test]
    fn the_colours_of_surfaces_under_it_tell_the_powers_of_a_lamp() {
        // The second has two of mercury's lines in the violet, 3 nm apart.
        let cases: [(&[f64], &[f64]); 2] = [
            (&MERCURY_NM, &[60.0, 2.0, 9.0, 6.0, 3.0]),
            (
                &[404.7, 407.8, 435.8, 546.1, 576.96, 579.07],
                &[60.0, 2.0, 0.5, 9.0, 6.0, 3.0, 1.0],
            ),
        ];
        for (lines, powers) in cases {
            let surfaces = ramps();
            let xyz = lamp(lines, powers, &surfaces);
            let places = std::iter::once(None).chain(surfaces.iter().map(Some));
            let colours: Vec<LitColour<'_>> = places
                .zip(xyz)
                .map(|(surface, xyz)| LitColour { surface, xyz })
                .collect();
            let found = LineLight::new(lines, &phosphor(), &colours, Observer::CIE_1931).unwrap();
            // Rounding of XYZ near 1e4 (1e-12) times a condition of up to some 1e5.
            assert!((found.background.iter().sum::<f64>() - 60.0).abs() < 1e-6);
            for (line, power) in found.lines.iter().zip(&powers[1..]) {
                assert!((line.weight - power).abs() < 1e-6, "{line:?} {power}");
            }
            assert!(found.residual < 1e-12 && found.condition_number > 10.0);
        }
    }

    #[test]
    fn a_colour_beyond_the_lines_is_answered_by_the_nearest() {
        let xyz = Xyz::new(10.0, 100.0, 5.0);
        let colour = LitColour { surface: None, xyz };
        let found =
            LineLight::new(&MERCURY_NM, &phosphor(), &[colour], Observer::CIE_1931).unwrap();
        let nearest = found.nearest.unwrap();
        assert!(nearest.delta_e[0] > 1.0 && found.round_trip_delta_e == nearest.delta_e[0]);
        assert!((found.xyz[0].y - 100.0).abs() < 1e-9);
    }

    #[test]
    fn lines_and_backgrounds_that_are_none_are_refused() {
        let xyz = Xyz::new(98.0, 100.0, 60.0);
        let colours = [LitColour { surface: None, xyz }];
        let dark = phosphor().scaled(0.0);
        let made = |lines: &[f64], background: &Sampled, colours: &[LitColour<'_>]| {
            LineLight::new(lines, background, colours, Observer::CIE_1931).unwrap_err()
        };
        assert_eq!(
            made(&[], &phosphor(), &colours),
            RecoverError::Lines { found: 0 }
        );
        assert!(matches!(
            made(&[f64::NAN], &phosphor(), &colours),
            RecoverError::LineOutside { .. }
        ));
        assert_eq!(
            made(&MERCURY_NM, &dark, &colours),
            RecoverError::NoBackground
        );
        assert!(matches!(
            made(&MERCURY_NM, &phosphor(), &[]),
            RecoverError::Colours { found: 0, .. }
        ));
    }
}
