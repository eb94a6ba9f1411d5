//! Other ways to keep the same picture at the same count of numbers, measured in the same run.

use std::io::{Seek, SeekFrom, Write};

use nalgebra::DMatrix;

use crate::io::{EXR_BLOCK_ROWS, Precision, write_exr_rows};
use crate::study::Progress;

use super::lines::find_lines;
use super::measure::{Errors, Exactly, Spread, measure, white_y_of};
use super::survey::Survey;
use super::{Operator, PictureError, Pixels, Plan, Reference};

/// One row of the table of peers.
#[derive(Clone, Debug, PartialEq)]
pub struct Peer {
    /// Name of the method.
    pub name: &'static str,
    /// Numbers a pixel; the bands' count for what keeps all.
    pub numbers: usize,
    /// Bytes of the file, or of the numbers and their basis.
    pub bytes: Option<u64>,
    /// Its errors; `None` where it was not run.
    pub error: Option<Errors>,
    /// A remark.
    pub description: String,
}

impl Peer {
    /// The mean of the errors under the judging lights; none where it cannot be relit.
    pub(crate) fn lights(&self) -> Option<Spread> {
        let lights = &self.error.as_ref()?.lights;
        let count = lights.len() as f64;
        let mean = |of: fn(&Spread) -> f64| lights.values().map(of).sum::<f64>() / count;
        (!lights.is_empty()).then(|| Spread {
            mean: mean(|s| s.mean),
            p95: mean(|s| s.p95),
            max: lights.values().map(|s| s.max).fold(0.0, f64::max),
        })
    }
}

/// All peers of an operator on its picture, the operator itself first.
///
/// # Errors
/// Those of the source, and [`PictureError::Cancelled`].
pub(crate) fn peers(
    pixels: &dyn Pixels,
    operator: &Operator,
    survey: &Survey,
    progress: &Progress,
) -> Result<Vec<Peer>, PictureError> {
    let numbers = operator.numbers();
    let bands = operator.bands();
    let (width, height) = pixels.size();
    let kept = |extra: usize| Some(2 * (numbers * width * height + extra) as u64);
    let bare = Plan {
        series: numbers,
        weighting: None,
        exact: false,
        lines: Vec::new(),
        second: None,
        reference: Reference::one(bands),
        ..operator.plan().clone()
    };
    let mut rows: Vec<(&'static str, Option<u64>, Operator, &str)> = vec![(
        later!("composite"),
        kept(0),
        operator.clone(),
        later!("half numbers before packing"),
    )];
    let basis = numbers * bands.len();
    if let Some(components) = components(operator, &bare, survey) {
        rows.push((
            later!("components of the picture"),
            kept(basis),
            components,
            later!("its basis is counted"),
        ));
    }
    rows.push((
        later!("plain samples"),
        kept(0),
        samples(operator, &bare),
        later!("even wavelengths, straight lines between"),
    ));
    if let Ok(series) = Operator::new(bands, &bare) {
        rows.push((later!("bare series"), kept(0), series, ""));
    }
    let mut lines = find_lines(bands, &survey.mean)?;
    lines.truncate(numbers.saturating_sub(3));
    let paper = Plan {
        series: numbers - lines.len(),
        lines,
        ..bare.clone()
    };
    if let Ok(paper) = Operator::new(bands, &paper) {
        rows.push((
            later!("the paper's form: series and lines"),
            kept(0),
            paper,
            "",
        ));
    }
    let mut peers = Vec::new();
    for (name, bytes, way, description) in rows {
        let white = white_y_of(&way, &survey.sample);
        peers.push(Peer {
            name,
            numbers,
            bytes,
            error: Some(measure(pixels, &way, &Exactly, white, progress)?),
            description: description.to_owned(),
        });
    }
    for (name, precision) in [
        (later!("spectral OpenEXR, half, ZIP"), Precision::Half),
        (later!("spectral OpenEXR, float, ZIP"), Precision::Single),
    ] {
        peers.push(Peer {
            name,
            numbers: bands.len(),
            bytes: Some(exact_bytes(pixels, precision, progress)?),
            error: None,
            description: later!("every band").to_owned(),
        });
    }
    Ok(peers)
}

/// The first eigenvectors of the sample's second moments.
fn components(operator: &Operator, plan: &Plan, survey: &Survey) -> Option<Operator> {
    let count = operator.bands().len();
    let all = DMatrix::from_fn(count, survey.sample.len(), |j, i| survey.sample[i][j]);
    let eigen = (&all * all.transpose()).symmetric_eigen();
    if eigen.eigenvalues.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let values = &eigen.eigenvalues;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let decode = DMatrix::from_fn(count, operator.numbers(), |j, n| {
        eigen.eigenvectors[(j, order[n])]
    });
    let encode = decode.transpose();
    Some(operator.other_way(plan, decode, encode))
}

fn samples(operator: &Operator, plan: &Plan) -> Operator {
    let nm = operator.bands().nm();
    let (first, last) = (nm[0], nm[nm.len() - 1]);
    let count = operator.numbers();
    let places: Vec<f64> = (0..count)
        .map(|n| first + (last - first) * n as f64 / (count - 1) as f64)
        .collect();
    let encode = DMatrix::from_fn(count, nm.len(), |n, j| hat(nm, j, places[n]));
    let decode = DMatrix::from_fn(nm.len(), count, |j, n| hat(&places, n, nm[j]));
    operator.other_way(plan, decode, encode)
}

/// Weight of a sample at a place, by linear interpolation between samples.
fn hat(nm: &[f64], at: usize, place: f64) -> f64 {
    let right = nm.partition_point(|w| *w < place).clamp(1, nm.len() - 1);
    let t = ((place - nm[right - 1]) / (nm[right] - nm[right - 1])).clamp(0.0, 1.0);
    match at {
        _ if at == right => t,
        _ if at + 1 == right => 1.0 - t,
        _ => 0.0,
    }
}

impl Operator {
    /// Other matrices on the same bands, judged in the same way.
    fn other_way(&self, plan: &Plan, decode: DMatrix<f64>, encode: DMatrix<f64>) -> Self {
        let mut other = self.clone();
        other.plan = plan.clone();
        (other.decode, other.encode) = (decode, encode);
        other
    }
}

/// Counts what is written and keeps nothing.
#[derive(Default)]
struct Counter {
    at: u64,
    end: u64,
}

impl Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.at += bytes.len() as u64;
        self.end = self.end.max(self.at);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Seek for Counter {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        self.at = match to {
            SeekFrom::Start(at) => at,
            SeekFrom::End(by) => self.end.saturating_add_signed(by),
            SeekFrom::Current(by) => self.at.saturating_add_signed(by),
        };
        Ok(self.at)
    }
}

/// Bytes of a spectral OpenEXR with every band, ZIP.
///
/// # Errors
/// Those of the source, and [`PictureError::Cancelled`].
pub fn exact_bytes(
    pixels: &dyn Pixels,
    precision: Precision,
    progress: &Progress,
) -> Result<u64, PictureError> {
    let (width, height) = pixels.size();
    let bands = pixels.bands();
    let prefix = if bands.is_factor() { "T." } else { "S0." };
    let name = |nm: &f64| format!("{prefix}{}nm", format!("{nm:.6}").replace('.', ","));
    let names = bands.nm().iter().map(name);
    let mut names: Vec<(String, usize)> = names.zip(0..).collect();
    names.sort();
    let channels: Vec<_> = names
        .iter()
        .map(|(name, _)| (name.clone(), precision))
        .collect();
    let mut counter = Counter::default();
    progress.expect(height.div_ceil(EXR_BLOCK_ROWS));
    write_exr_rows(
        &mut counter,
        [width, height],
        &channels,
        None,
        |top, rows| {
            if progress.is_cancelled() {
                return Err(PictureError::Cancelled);
            }
            let count = width * rows;
            let mut values = vec![0.0; count * bands.len()];
            pixels.rows(top, rows, &mut values)?;
            progress.step();
            let plane = |(_, j): &(String, usize)| &values[j * count..][..count];
            Ok(names.iter().map(plane).collect::<Vec<_>>().concat())
        },
    )?;
    Ok(counter.end)
}
