//! The same engine on tables of many spectra: every spectrum a row of numbers.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::io::quoted_where;
use crate::spectrum::{Kind, Outside, Sampled};
use crate::study::{Progress, error::height};

use super::lines::find_lines;
use super::strips::{joined, over_strips};
use super::survey::Survey;
use super::{Bands, InMemory, Operator, PictureError, Plan, Reference, ReferenceKind};

/// Most spectra or points that one line of JSON may hold.
const MOST_POINTS: usize = 100_000;

/// Wavelengths that end below this are in another unit.
const SHORTEST_NM: f64 = 20.0;

/// Spectra that one thread fits at a time.
const AT_ONCE: usize = 512;

/// Settings of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitAsk {
    /// Numbers a spectrum.
    pub numbers: usize,
    /// `One` or `Mean`.
    pub reference: ReferenceKind,
    /// True if lines are to be sought in the mean.
    pub lines: bool,
}

/// Many spectra in few numbers each.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// Their names.
    pub names: Vec<String>,
    /// The operator.
    pub operator: Operator,
    /// `[number * spectra + i]`; NaN for one that was not measured in full.
    pub numbers: Vec<f32>,
    /// Relative rms of each; `None` for one that was not measured in full.
    pub relative_rms: Vec<Option<f64>>,
}

/// The operator for spectra on common bands.
fn operator_for(bands: &Bands, mean: &[f64], ask: FitAsk) -> Result<Operator, PictureError> {
    let mut lines = match ask.lines {
        true => find_lines(bands, mean)?,
        false => Vec::new(),
    };
    lines.truncate(ask.numbers.saturating_sub(3));
    let reference = match ask.reference {
        ReferenceKind::Mean => Reference::of_mean(mean)?,
        ReferenceKind::One | ReferenceKind::Light => Reference::one(bands),
    };
    let series = ask.numbers.saturating_sub(lines.len());
    let plan = Plan {
        reference,
        lines,
        ..Plan::new(bands, series)
    };
    Operator::steady(bands, &plan)
}

/// Fits spectra that lie band after band in memory: `values[band * spectra + i]`.
///
/// # Errors
/// [`PictureError`] when they cannot be fitted, or it was cancelled.
pub fn fit_values(
    names: Vec<String>,
    bands: Bands,
    values: Vec<f32>,
    ask: FitAsk,
    progress: &Progress,
) -> Result<Fitted, PictureError> {
    let count = names.len();
    // As a column, so that rows are shared out over threads.
    let pixels = InMemory::new(1, count, bands.clone(), values)?;
    let survey = Survey::of(&pixels, progress)?;
    let operator = operator_for(&bands, &survey.mean, ask)?;
    let (encode, decode) = (operator.encoder(), operator.decoder());
    progress.expect(count.div_ceil(AT_ONCE));
    let parts = over_strips(&pixels, AT_ONCE, progress, |strip| {
        let here = strip.pixels;
        let mut numbers = vec![0.0; operator.numbers() * here];
        encode.apply(strip.values, here, &mut numbers);
        let mut back = vec![0.0; bands.len() * here];
        decode.apply(&numbers, here, &mut back);
        let of = |i: usize| {
            let pairs = (0..bands.len()).map(|j| (strip.values[j * here + i], back[j * here + i]));
            relative_rms(
                pairs.map(|(exact, found)| [exact, found].map(f64::from)),
                &bands,
            )
        };
        Ok((numbers, (0..here).map(of).collect::<Vec<_>>()))
    })?;
    Ok(Fitted {
        names,
        numbers: joined(parts.iter().map(|(numbers, _)| numbers), operator.numbers()),
        relative_rms: parts.into_iter().flat_map(|(_, rms)| rms).collect(),
        operator,
    })
}

/// Root of the squared difference over the squared values, each band by its width; `None` where a
/// value is missing or no number. Pairs are exact and found.
fn relative_rms(pairs: impl Iterator<Item = [f64; 2]>, bands: &Bands) -> Option<f64> {
    let (mut off, mut all) = (0.0, 0.0);
    for ([exact, found], weight) in pairs.zip(bands.weights_nm()) {
        off += weight * (found - exact).powi(2);
        all += weight * exact.powi(2);
    }
    let rms = if all == 0.0 { 0.0 } else { (off / all).sqrt() };
    rms.is_finite().then_some(rms)
}

/// Fits a table of spectra; those on other wavelengths than the first come to its by straight
/// lines and must cover them.
///
/// # Errors
/// [`PictureError`] with the name of the spectrum that does not fit.
pub(crate) fn fit_spectra(
    spectra: &[(String, &Sampled)],
    kind: Kind,
    ask: FitAsk,
    progress: &Progress,
) -> Result<Fitted, PictureError> {
    let (_, first) = spectra.first().ok_or(PictureError::NothingMeasured)?;
    let bands = Bands::new(first.nm().to_vec(), kind)?;
    let mut values = vec![0.0; bands.len() * spectra.len()];
    for (i, (name, table)) in spectra.iter().enumerate() {
        let [from, to] = [table.first_nm(), table.last_nm()];
        let [first_nm, last_nm] = [first.first_nm(), first.last_nm()];
        if from > first_nm || to < last_nm {
            return Err(PictureError::broken(
                format!("{name} from {from} to {to} nm"),
                format!("spectra that cover {first_nm} to {last_nm} nm"),
            ));
        }
        let on_bands = match table.nm() == bands.nm() {
            true => table.values().to_vec(),
            false => bands.by_area(table, Outside::Hold),
        };
        for (j, value) in on_bands.into_iter().enumerate() {
            if !(value as f32).is_finite() {
                let found = format!("{name} with {value:e} at {} nm", bands.nm()[j]);
                return Err(PictureError::broken(found, "values up to 3.4e38"));
            }
            values[j * spectra.len() + i] = value as f32;
        }
    }
    let names = spectra.iter().map(|(name, _)| name.clone()).collect();
    fit_values(names, bands, values, ask, progress)
}

impl Fitted {
    /// The numbers of one spectrum.
    pub fn row(&self, index: usize) -> Vec<f64> {
        let count = self.names.len();
        (0..self.operator.numbers())
            .map(|n| f64::from(self.numbers[n * count + index]))
            .collect()
    }

    /// A table: comments with what the numbers mean, the reference among them where it is not 1
    /// everywhere; then a row a spectrum.
    pub fn csv(&self) -> String {
        let plan = self.operator.plan();
        let [lo, hi] = self.operator.range_nm();
        let mut out = format!(
            "# series {} over {lo}:{hi} nm, reference {}\n",
            plan.series,
            plan.reference.kind.word()
        );
        let mut listed = |what: &str, values: &[f64]| {
            let _ = write!(out, "# {what}");
            values.iter().for_each(|value| {
                let _ = write!(out, " {value}");
            });
            out.push('\n');
        };
        if plan.reference.kind != ReferenceKind::One {
            listed("bands_nm", self.operator.bands().nm());
            listed("reference", &plan.reference.values);
        }
        out.push_str("name");
        (0..plan.series).for_each(|n| {
            let _ = write!(out, ",c{n}");
        });
        plan.lines.iter().for_each(|line| {
            let _ = write!(out, ",line {:.2} nm", line.at_nm);
        });
        out.push_str(",relative_rms\n");
        for (i, name) in self.names.iter().enumerate() {
            let is_special = name.contains([',', '"', '\n', '\r']);
            out.push_str(&quoted_where(is_special, name));
            self.row(i).iter().for_each(|z| {
                let _ = write!(out, ",{}", *z as f32);
            });
            let rms = self.relative_rms[i].map(|rms| (rms as f32).to_string());
            let _ = writeln!(out, ",{}", rms.unwrap_or_default());
        }
        out
    }

    /// The same as JSON.
    pub fn json(&self) -> Value {
        let plan = self.operator.plan();
        let spectra: Vec<Value> = (0..self.names.len())
            .map(|i| json!({"name": self.names[i], "coefficients": finite(&self.row(i)), "relative_rms": self.relative_rms[i]}))
            .collect();
        json!({
            "numbers": plan.numbers(),
            "series": plan.series,
            "range_nm": self.operator.range_nm(),
            "bands_nm": self.operator.bands().nm(),
            "reference": {"kind": plan.reference.kind, "values": plan.reference.values},
            "lines": plan.lines.iter().map(|l| json!({"at_nm": l.at_nm, "share": l.share, "shape": l.shape})).collect::<Vec<_>>(),
            "spectra": spectra,
        })
    }
}

fn finite(values: &[f64]) -> Vec<Option<f64>> {
    values.iter().map(|v| v.is_finite().then_some(*v)).collect()
}

/// One line of JSON in, one out: `{"name"?, "nm": [...], "values": [...], "kind"?}`. Nothing is
/// remembered from line to line, so lines may be spread over machines.
///
/// # Errors
/// [`PictureError`] when the line is no spectrum, or the mean of other lines is asked for.
pub fn fit_line(line: &str, ask: FitAsk) -> Result<String, PictureError> {
    if ask.reference != ReferenceKind::One {
        return Err(PictureError::broken(
            "a reference that needs all spectra",
            "--reference one with lines of JSON, which are fitted one by one",
        ));
    }
    let bad = |what: String| PictureError::broken(what, "{\"nm\": [...], \"values\": [...]}");
    let value: Value =
        serde_json::from_str(line).map_err(|error| bad(format!("no JSON ({error})")))?;
    let list = |key: &str| -> Result<Vec<f64>, PictureError> {
        let list = value
            .get(key)
            .and_then(Value::as_array)
            .ok_or_else(|| bad(format!("no list {key:?}")))?;
        let numbers = list.iter().take(MOST_POINTS + 1).map(Value::as_f64);
        let numbers: Option<Vec<f64>> = numbers.collect();
        let numbers = numbers.filter(|n| n.len() <= MOST_POINTS);
        numbers.ok_or_else(|| bad(format!("no numbers in {key:?}")))
    };
    let (nm, values) = (list("nm")?, list("values")?);
    let kind = match value.get("kind").map(|kind| (kind, kind.as_str())) {
        None | Some((_, Some("light"))) => Kind::Light,
        Some((_, Some("reflectance"))) => Kind::Reflectance,
        Some((_, Some("transmittance"))) => Kind::Transmittance,
        Some((other, _)) => {
            return Err(PictureError::broken(
                format!("the kind {other}"),
                "light, reflectance or transmittance",
            ));
        }
    };
    // Nothing is measured there, and light of 0.4 to 0.7 um is.
    if let Some(last) = nm.last().filter(|last| **last < SHORTEST_NM) {
        return Err(PictureError::broken(
            format!("wavelengths up to {last} nm"),
            "some in nm (1 um is 1000 nm)",
        ));
    }
    let counts = [nm.len(), values.len()];
    if counts[0] != counts[1] {
        let [nm, values] = counts;
        return Err(bad(format!("{nm} wavelengths and {values} values")));
    }
    let bands = Bands::new(nm, kind)?;
    let operator = operator_for(&bands, &values, ask)?;
    let numbers = operator.numbers_of(&values);
    let back = operator.pixel_of(&numbers);
    // Squares of numbers beyond 1e154 would be infinite.
    let unit = height(&values).unwrap_or(1.0);
    let pairs = values.iter().zip(&back);
    let rms = relative_rms(pairs.map(|(a, b)| [unit * a, unit * b]), &bands);
    let series = operator.plan().series;
    let lines = operator.plan().lines.iter().zip(&numbers[series..]);
    let answer = json!({
        "name": value.get("name").cloned().unwrap_or(Value::Null),
        "numbers": operator.numbers(),
        "range_nm": operator.range_nm(),
        "coefficients": finite(&numbers[..series]),
        "lines": lines.map(|(line, w)| json!({"at_nm": line.at_nm, "weight": w})).collect::<Vec<_>>(),
        "relative_rms": rms,
    });
    Ok(answer.to_string())
}
