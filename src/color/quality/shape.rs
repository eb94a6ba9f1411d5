//! Peak, centroid and width of a light within 360-830 nm.

use super::{
    light::{FIRST_NM, Light, positive},
    no_figure::NoFigure,
};

/// The highest place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Peak {
    /// Whole nm of the largest value, the first of several.
    pub nm: u32,
    /// True if the table ends there, so that the light may be higher beyond.
    pub is_at_end: bool,
}

/// Width at half height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Width {
    /// Full width at half maximum, nm, between straight crossings.
    pub fwhm_nm: f64,
    /// Middle of the two crossings, nm.
    pub middle_nm: f64,
}

/// Shape of a light's curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The highest place; none for a model with lines, which have weight but no height.
    pub peak: Result<Peak, NoFigure>,
    /// `sum(l P) / sum(P)`, nm.
    pub centroid_nm: Result<f64, NoFigure>,
    /// Width, where one stretch reaches half of the maximum and ends within the table.
    pub width: Result<Width, NoFigure>,
    /// Stretches of whole nm that reach half of the maximum.
    pub half_height_runs: Result<usize, NoFigure>,
}

/// Peak, centroid and width of a light.
///
/// # Errors
/// [`NoFigure::Dark`] when there is no light.
pub fn shape(light: &Light) -> Result<Shape, NoFigure> {
    let light = light.lit()?;
    let moment: f64 = light
        .values()
        .iter()
        .zip(FIRST_NM..)
        .map(|(v, nm)| v * f64::from(nm))
        .chain(light.lines().iter().map(|l| l.weight * l.at_nm))
        .sum();
    let centroid_nm =
        positive(light.power(), later!("sum of the values")).map(|power| moment / power);
    let heaviest = light
        .lines()
        .iter()
        .max_by(|a, b| a.weight.abs().total_cmp(&b.weight.abs()));
    if let Some(line) = heaviest {
        let no = NoFigure::LineWithoutHeight {
            heaviest_nm: line.at_nm,
        };
        return Ok(Shape {
            peak: Err(no.clone()),
            centroid_nm,
            width: Err(no.clone()),
            half_height_runs: Err(no),
        });
    }
    let values = light.values();
    let (at, highest) = values
        .iter()
        .enumerate()
        .fold((0, f64::NEG_INFINITY), |best, (i, v)| {
            if *v > best.1 { (i, *v) } else { best }
        });
    let highest = match positive(highest, later!("value")) {
        Ok(highest) => highest,
        Err(no) => {
            return Ok(Shape {
                peak: Err(no.clone()),
                centroid_nm,
                width: Err(no.clone()),
                half_height_runs: Err(no),
            });
        }
    };
    let nm = FIRST_NM + at as u32;
    let runs = runs_above(values, 0.5 * highest);
    Ok(Shape {
        peak: Ok(Peak {
            nm,
            is_at_end: light.ends_nm().contains(&nm),
        }),
        centroid_nm,
        width: width(light, &runs, 0.5 * highest),
        half_height_runs: Ok(runs.len()),
    })
}

/// First and last index of every stretch that reaches a height.
fn runs_above(values: &[f64], height: f64) -> Vec<[usize; 2]> {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for (i, _) in values.iter().enumerate().filter(|(_, v)| **v >= height) {
        match runs.last_mut() {
            Some(run) if run[1] + 1 == i => run[1] = i,
            _ => runs.push([i, i]),
        }
    }
    runs
}

fn width(light: &Light, runs: &[[usize; 2]], half: f64) -> Result<Width, NoFigure> {
    let [[first, last]] = runs else {
        return Err(NoFigure::ManyRuns { runs: runs.len() });
    };
    let ends = light.ends_nm().map(|nm| (nm - FIRST_NM) as usize);
    for (index, end) in [(*first, ends[0]), (*last, ends[1])] {
        if index == end || index == 0 || index + 1 == light.values().len() {
            return Err(NoFigure::TouchesEnd {
                at_nm: FIRST_NM + index as u32,
            });
        }
    }
    let values = light.values();
    // Where the straight line between an outer point below the height and an inner one reaches it.
    let share =
        |outer: usize, inner: usize| (half - values[outer]) / (values[inner] - values[outer]);
    let from = f64::from(FIRST_NM) + *first as f64 - 1.0 + share(first - 1, *first);
    let to = f64::from(FIRST_NM) + *last as f64 + 1.0 - share(last + 1, *last);
    Ok(Width {
        fwhm_nm: to - from,
        middle_nm: 0.5 * (from + to),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::quality::POINTS,
        spectrum::{Band, Line},
    };

    #[test]
    fn a_triangle_is_as_wide_as_half_its_foot() {
        let mut values = [0.0; POINTS];
        for (value, nm) in values.iter_mut().zip(FIRST_NM..) {
            *value = (10.0 - f64::from(nm.abs_diff(500))).max(0.0);
        }
        let found = shape(&Light::of_nm_values(&values)).unwrap();
        assert_eq!(
            found.width,
            Ok(Width {
                fwhm_nm: 10.0,
                middle_nm: 500.0
            })
        );
        assert_eq!(found.peak.unwrap().nm, 500);
        // A sum of symmetric products near 1e4.
        assert!((found.centroid_nm.unwrap() - 500.0).abs() < 1e-10);
    }

    #[test]
    fn a_model_with_lines_has_a_centroid_but_no_height() {
        let spike = Line::ideal(546.1, 3.0);
        let band = Band::VISIBLE;
        let light = Light::of_parts(band, &vec![0.0; band.points()], &[spike]);
        let found = shape(&light).unwrap();
        assert_eq!(found.centroid_nm, Ok(546.1));
        assert_eq!(
            found.peak,
            Err(NoFigure::LineWithoutHeight { heaviest_nm: 546.1 })
        );
    }

    #[test]
    fn a_light_that_is_cut_off_has_no_width() {
        let found = shape(&Light::of_nm_values(&[1.0; POINTS])).unwrap();
        assert_eq!(found.width, Err(NoFigure::TouchesEnd { at_nm: 360 }));
        assert!(found.peak.unwrap().is_at_end);
    }
}
