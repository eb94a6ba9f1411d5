//! One curve that was printed in several columns: the units of the wavelengths along the head of the
//! table and the tens down its side (`nm 0 1 2 ... 9`), or its second half beside the first.

use super::pick::Table;
use super::roles::Group;
use super::row_order::runs_one_way;
use super::titles::Titles;

/// Fewest rows that tell that a table is folded.
const FEWEST_ROWS: usize = 3;

/// Fewest columns of values that a row is folded into: two or three are readings at other settings.
const FEWEST_COLUMNS: usize = 5;

/// The share of rows that start again as the row above, from which on columns are spectra of their
/// own: of a folded curve noise makes one in five look so, of readings that drift nearly all do.
const MOST_AGAIN: f64 = 0.4;

/// The share of the greatest value from which on values tell that two columns are one curve.
const LEAST_AT_JOINT: f64 = 0.05;

/// The largest total variation of a curve relative to that of every tenth of its points: emission
/// lines lie between those.
const LABELLED: f64 = 5.0;
const UNLABELLED: f64 = 1.5;

/// The table with one column of wavelengths and one of values, and what is said of it, where columns
/// are pieces of one curve.
pub(crate) fn unfold<'a>(
    table: &Table<'a>,
    groups: &[Group],
    wavelength: usize,
) -> Option<(Table<'a>, String)> {
    match groups {
        [one] => in_rows(table, one),
        [_, _, ..] => side_by_side(table, groups),
        [] => None,
    }
    .map(|(points, title, note)| (of_points(table, wavelength, points, title), note.to_owned()))
}

/// A wavelength, a value and its line.
type Point = (f64, f64, u32);

/// The points of a curve, the column whose title it has, and what is said of it.
type Unfolded = (Vec<Point>, Option<usize>, &'static str);

fn of_points<'a>(
    table: &Table<'a>,
    axis: usize,
    points: Vec<Point>,
    title: Option<usize>,
) -> Table<'a> {
    let of = |texts: &[String]| {
        let value = title.map_or(String::new(), |column| texts[column].clone());
        vec![texts[axis].clone(), value]
    };
    let Titles { names, units } = &table.titles;
    Table {
        titles: Titles {
            names: of(names),
            units: of(units),
        },
        block: table
            .block
            .of_points([axis, title.unwrap_or(axis + 1)], &points),
        ..table.clone()
    }
}

/// Pairs of columns under the same titles whose wavelengths and values go on from one to the next.
fn side_by_side(table: &Table, groups: &[Group]) -> Option<Unfolded> {
    let (block, titles) = (&table.block, &table.titles);
    let mut points: Vec<Point> = Vec::new();
    let mut joints = Vec::new();
    let first = &groups[0];
    for group in groups {
        let [value] = group.values[..] else {
            return None;
        };
        let is_alike = titles.whole(group.axis) == titles.whole(first.axis)
            && titles.whole(value) == titles.whole(first.values[0]);
        if !is_alike {
            return None;
        }
        joints.push(points.len());
        let rows = block.column(group.axis).iter().zip(block.column(value));
        let rows = rows
            .zip(&block.lines)
            .filter(|((nm, v), _)| !nm.is_nan() && !v.is_nan());
        points.extend(rows.map(|((nm, v), line)| (*nm, *v, *line)));
    }
    let nm: Vec<f64> = points.iter().map(|point| point.0).collect();
    let ends = joints.iter().skip(1).copied().chain([points.len()]);
    let rows: Vec<usize> = joints.iter().zip(ends).map(|(a, b)| b - a).collect();
    // Points that do not fill all columns leave the last one short: of two by one row.
    let (last, others) = rows.split_last()?;
    let is_even = others.iter().all(|count| *count == rows[0]) && *last <= rows[0];
    let is_filled = rows.len() > 2 || last + 1 >= rows[0];
    if !(is_even && is_filled && *last >= FEWEST_ROWS && runs_one_way(&nm)) {
        return None;
    }
    let step = |at: usize| (nm[at] - nm[at - 1]).abs();
    let inside = (1..nm.len()).filter(|at| !joints.contains(at));
    let most_step = inside.map(step).fold(0.0, f64::max);
    let greatest = points.iter().map(|p| p.1.abs()).fold(0.0, f64::max);
    let goes_on = |at: &usize| step(*at) <= 1.01 * most_step && is_smooth(&points, *at, greatest);
    // Two filters that let nothing through where they meet agree there as well.
    let tells = |at: &usize| points[*at].1.abs() > LEAST_AT_JOINT * greatest;
    let joints = &joints[1..];
    let note = said!("columns side by side go on with one another: read as one spectrum");
    (joints.iter().all(goes_on) && joints.iter().any(tells)).then_some((
        points,
        Some(first.values[0]),
        note,
    ))
}

/// True if value and slope agree across the joint before a point: to within the change of nearby
/// slopes, or the rounding of the greatest value.
fn is_smooth(points: &[Point], joint: usize, greatest: f64) -> bool {
    const CLOSE_BY: usize = 6;
    let slope = |pair: &[Point]| (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
    let slopes = |points: &[Point]| points.windows(2).map(slope).collect::<Vec<f64>>();
    let before = slopes(&points[joint.saturating_sub(CLOSE_BY)..joint]);
    let behind = slopes(&points[joint..points.len().min(joint + CLOSE_BY)]);
    let bend = |slopes: &[f64]| {
        let bends = slopes.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        bends.fold(0.0, f64::max)
    };
    let rounding = 2e-3 * greatest / (points[joint].0 - points[joint - 1].0).abs();
    let most = 2.0 * bend(&before).max(bend(&behind)) + rounding;
    let across = slope(&points[joint - 1..=joint]);
    let beside = [before.last(), behind.first()];
    let mut beside = beside.into_iter().flatten();
    beside.all(|slope| (slope - across).abs() <= most)
}

/// Rows of as many values as lie between the wavelengths of two rows.
fn in_rows(table: &Table, group: &Group) -> Option<Unfolded> {
    let (block, titles) = (&table.block, &table.titles);
    let (count, rows) = (group.values.len(), block.rows());
    let axis = block.column(group.axis);
    if count < FEWEST_COLUMNS || rows < FEWEST_ROWS {
        return None;
    }
    let step = axis[1] - axis[0];
    let is_even = axis
        .windows(2)
        .all(|pair| (pair[1] - pair[0] - step).abs() <= 1e-6 * step);
    if !(step > 0.0 && is_even) {
        return None;
    }
    let along = step / count as f64;
    // Nobody prints a curve at every seventh of a nm.
    let is_round = (2.0 * along).fract() == 0.0;
    let label = |column: &usize| titles.whole(*column).parse::<f64>().ok();
    let labels: Option<Vec<f64>> = group.values.iter().map(label).collect();
    let is_label = |(at, label): (usize, &f64)| (label - along * at as f64).abs() <= 1e-6 * step;
    let most = match &labels {
        Some(labels) if labels.iter().enumerate().all(is_label) => LABELLED,
        Some(_) => return None,
        None if is_round && group.values.iter().all(|c| titles.whole(*c).is_empty()) => UNLABELLED,
        None => return None,
    };
    let mut points = Vec::with_capacity(rows * count);
    for (row, line) in block.lines.iter().enumerate() {
        for (at, column) in group.values.iter().enumerate() {
            let nm = axis[row] + along * at as f64;
            points.push((nm, block.column(*column)[row], *line));
        }
    }
    let way = |values: &mut dyn Iterator<Item = f64>| -> f64 {
        let values: Vec<f64> = values.filter(|value| !value.is_nan()).collect();
        values
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).abs())
            .sum()
    };
    let folded: f64 = group
        .values
        .iter()
        .map(|c| way(&mut block.column(*c).iter().copied()))
        .sum();
    let whole = way(&mut points.iter().map(|point| point.1));
    // Of repeated readings the values of a row would be one, with a step to the next row.
    let at_ends: f64 = (1..rows)
        .map(|row| (points[row * count].1 - points[row * count - 1].1).abs())
        .filter(|step| !step.is_nan())
        .sum();
    let values: Vec<f64> = points.iter().map(|point| point.1).collect();
    let is_curve = whole > 0.0
        && starting_again(&values, count) <= MOST_AGAIN
        && whole <= most * folded / count as f64
        && at_ends * count as f64 <= 3.0 * whole.max(f64::MIN_POSITIVE);
    points.retain(|point| !point.1.is_nan());
    let note = said!("each row goes on in its columns: read as one spectrum");
    (is_curve && points.len() > rows).then_some((points, None, note))
}

/// The share of rows, `count` values each, that start again as the row above: their first value
/// moves from there as the others of the row do, and does not stand between the values beside it.
fn starting_again(values: &[f64], count: usize) -> f64 {
    let rows: Vec<&[f64]> = values.chunks_exact(count).collect();
    let starts_again = |pair: &&[&[f64]]| {
        let (above, row) = (pair[0], pair[1]);
        let moves = above.iter().zip(row).map(|(a, b)| b - a);
        let others = moves.skip(1).sum::<f64>() / (count - 1) as f64;
        let off_column = (row[0] - above[0] - others).abs();
        let off_curve = (row[0] - 0.5 * (above[count - 1] + row[1])).abs();
        2.0 * off_column < off_curve
    };
    rows.windows(2).filter(starts_again).count() as f64 / (rows.len() - 1) as f64
}
