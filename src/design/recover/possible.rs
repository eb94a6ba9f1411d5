//! The colours that surfaces can have, and the nearest one to a colour that none can have.
//!
//! Under a light the colours of all reflectances of 0-1 are a convex body, the optimal-colour
//! solid (Schrödinger 1920, MacAdam 1935). Nearest means least CIE 1976 difference in L\*a\*b\*
//! against the light; with two lights the sum of squares of both. L\*a\*b\* bends the body, so the
//! nearest point is found by turns: the difference is made straight at the last point found
//! (Gauss-Newton), and the nearest point of the body in that measure is exact.

use super::viewing::NODES;
use crate::{
    color::{Lab, Xyz, lab_from_xyz, xyz_from_lab},
    design::{
        nearest_point::nearest_shares,
        programme::Programme,
        small::{add, combined, dot},
    },
};

/// Turns; a handful is enough, and none makes it worse.
const MOST_TURNS: usize = 60;

/// A turn that moves no L\*a\*b\* number by more ends the search.
const STILL: f64 = 1e-9;

/// Feasibility tolerance on a surface's colours, white = 1: a thousand times finer than any colour
/// is known.
const POSSIBLE: f64 = 1e-9;

/// True if some reflectance of 0-1 has these colours (white = 1). At the very edge of possible
/// colours rounding stops the simplex method short, so only two methods together reject a colour.
pub(super) fn is_possible<const M: usize>(columns: &[[f64; M]; NODES], target: [f64; M]) -> bool {
    let mut programme = Programme::new(&columns[..], &[1.0; NODES], target);
    if programme.corner().is_ok() {
        return true;
    }
    let mut rest = combined(columns, &nearest_shares(columns, target));
    add(&mut rest, &target, -1.0);
    dot(&rest, &rest).sqrt() <= POSSIBLE
}

/// The reflectance whose colours come nearest to those asked for. `whites` and `targets` have one
/// XYZ a light, white = 1, as `M / 3` blocks of the columns.
pub(super) fn nearest<const M: usize>(
    columns: &[[f64; M]; NODES],
    whites: &[Xyz],
    targets: &[Xyz],
) -> [f64; NODES] {
    let asked: Vec<Lab> = labs(whites, targets);
    // The square of a difference in L*a*b* has more than one valley over X, Y and Z: the way is
    // gone from several greys, the first being that of the luminance asked for.
    let level = targets.first().map_or(0.5, |t| t.y.clamp(0.02, 0.98));
    let mut best = ([level; NODES], f64::INFINITY);
    for start in [level, 0.005, 0.2, 0.98] {
        let found = descended(columns, whites, &asked, [start; NODES]);
        if found.1 < best.1 - STILL {
            best = found;
        }
    }
    best.0
}

/// The way down from a reflectance: where it ends, and the difference left.
fn descended<const M: usize>(
    columns: &[[f64; M]; NODES],
    whites: &[Xyz],
    asked: &[Lab],
    start: [f64; NODES],
) -> ([f64; NODES], f64) {
    let mut reflectance = start;
    let mut at = colours(columns, &reflectance);
    let mut distance = apart(asked, &labs(whites, &at));
    for _ in 0..MOST_TURNS {
        let (turned, goal) = straightened(columns, whites, &at, asked);
        let shares = nearest_shares(&turned, goal);
        let before = distance;
        let from = reflectance;
        // The whole way, or as much of it as is best among its halves.
        let mut part = 1.0;
        while part > 1e-5 {
            let trial: [f64; NODES] =
                std::array::from_fn(|j| from[j] + part * (shares[j] - from[j]));
            let there = colours(columns, &trial);
            let new = apart(asked, &labs(whites, &there));
            if new < distance {
                (reflectance, at, distance) = (trial, there, new);
            } else if distance < before {
                break;
            }
            part *= 0.5;
        }
        if before - distance < STILL {
            break;
        }
    }
    (reflectance, distance)
}

/// The colours of a reflectance, one a light.
fn colours<const M: usize>(columns: &[[f64; M]; NODES], reflectance: &[f64; NODES]) -> Vec<Xyz> {
    let sum = combined(columns, reflectance);
    let blocks = sum.chunks_exact(3);
    blocks.map(|b| Xyz::new(b[0], b[1], b[2])).collect()
}

fn labs(whites: &[Xyz], colours: &[Xyz]) -> Vec<Lab> {
    let both = colours.iter().zip(whites);
    both.map(|(xyz, white)| lab_from_xyz(*xyz, *white))
        .collect()
}

/// Root of the summed squares of CIE 1976 differences.
fn apart(first: &[Lab], second: &[Lab]) -> f64 {
    let squares = first
        .iter()
        .zip(second)
        .map(|(a, b)| a.delta_e_1976(*b).powi(2));
    squares.sum::<f64>().sqrt()
}

/// The columns in L\*a\*b\* made straight at the colours `at`, and the goal in the same measure,
/// both in hundredths.
fn straightened<const M: usize>(
    columns: &[[f64; M]; NODES],
    whites: &[Xyz],
    at: &[Xyz],
    asked: &[Lab],
) -> (Vec<[f64; M]>, [f64; M]) {
    // Rows of the derivative of L*, a*, b* by X, Y, Z, block after block.
    let mut derivative = [[0.0; 3]; M];
    let mut goal = [0.0; M];
    for (light, ((white, here), asked)) in whites.iter().zip(at).zip(asked).enumerate() {
        let lab = lab_from_xyz(*here, *white);
        let parts = slopes(*white, lab);
        let rows = [
            [0.0, 1.16 * parts[1], 0.0],
            [5.0 * parts[0], -5.0 * parts[1], 0.0],
            [0.0, 2.0 * parts[1], -2.0 * parts[2]],
        ];
        let now = here.to_array();
        let difference = [asked.l - lab.l, asked.a - lab.a, asked.b - lab.b];
        for k in 0..3 {
            derivative[3 * light + k] = rows[k];
            let base: f64 = rows[k].iter().zip(now).map(|(d, v)| d * v).sum();
            goal[3 * light + k] = base + 0.01 * difference[k];
        }
    }
    let turned = columns
        .iter()
        .map(|column| {
            std::array::from_fn(|row| {
                let block = &column[row / 3 * 3..row / 3 * 3 + 3];
                derivative[row].iter().zip(block).map(|(d, v)| d * v).sum()
            })
        })
        .collect();
    (turned, goal)
}

/// Derivatives of the compressed X, Y and Z by X, Y and Z, from the program's own L\*a\*b\*: the
/// inverse function is a cube or a line, whose slope is its difference over a small step.
fn slopes(white: Xyz, lab: Lab) -> [f64; 3] {
    const STEP: f64 = 1e-4;
    let there = |sign: f64| {
        // f of X, Y and Z grow by 1 when L* grows by 116; a* and b* stay.
        let moved = Lab::new(lab.l + sign * 116.0 * STEP, lab.a, lab.b);
        xyz_from_lab(moved, white).to_array()
    };
    let (up, down) = (there(1.0), there(-1.0));
    std::array::from_fn(|k| 2.0 * STEP / (up[k] - down[k]).max(f64::MIN_POSITIVE))
}
