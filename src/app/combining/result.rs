//! The result of a combination: a spectrum that was made, or what differs, with what is known of it.

use std::sync::Arc;

use super::parts::Part;
use crate::{
    app::{
        Entry,
        measured::{is_light, spectrum},
        readings::Reading,
    },
    languages::with_sign,
    measurements::{
        Changed, Doubted, Drift, Instrument, LinePoint, LineWithDoubt, Measurement, NarrowLine,
        Quantity, SlitFound, Spliced, doubts, lines_of, missing_light,
    },
    spectrum::{Composite, Line},
};

/// One scan of a mean.
pub struct ScanRow {
    pub name: String,
    /// Its level less that of the mean, a share.
    pub level: f64,
    pub shift_nm: f64,
    pub residual: f64,
    /// False where it was left out.
    pub is_kept: bool,
    /// Why it does not belong to the others.
    pub why: Option<String>,
}

/// One line of the result: of a light its power, of a quotient the quotient there.
#[derive(Clone, Copy)]
pub struct LineRow {
    pub at_nm: f64,
    /// None of a line whose top is cut.
    pub weight: Option<f64>,
    /// Share of the light's power.
    pub share: Option<f64>,
    /// Standard uncertainties of place, weight and share.
    pub u: [Option<f64>; 3],
    pub is_certain: bool,
}

impl LineRow {
    pub(super) fn of_light(line: LineWithDoubt) -> Self {
        let u = line.u;
        Self {
            at_nm: line.at_nm,
            weight: Some(line.weight),
            share: Some(line.share),
            u: [0, 1, 2].map(|k| u.map(|u| u[k])),
            is_certain: line.is_certain,
        }
    }

    pub(super) fn of_quotient(point: LinePoint) -> Self {
        Self {
            at_nm: point.at_nm,
            weight: Some(point.value),
            share: None,
            u: [None, Some(point.u), None],
            is_certain: true,
        }
    }

    pub(super) fn of_composite(line: &Line, power: f64) -> Self {
        Self {
            at_nm: line.at_nm,
            weight: Some(line.weight),
            share: (power != 0.0).then_some(line.weight / power),
            u: [None; 3],
            is_certain: true,
        }
    }

    pub(super) fn of_narrow(line: &NarrowLine, power: f64) -> Self {
        Self {
            at_nm: line.at_nm,
            weight: Some(line.weight),
            share: (power > 0.0).then_some(line.weight / power),
            u: [
                Some(line.u_at_nm),
                Some(line.u_weight),
                (power > 0.0).then_some(line.u_weight / power),
            ],
            is_certain: true,
        }
    }
}

/// What a combination found.
pub struct Found {
    /// The spectrum that was made; none where two sets were compared.
    pub result: Option<Measurement>,
    pub made_by: String,
    /// Where its doubt is from: repeats, residuals, stated.
    pub doubt_from: &'static str,
    pub scans: Vec<ScanRow>,
    pub drift: Option<Drift>,
    pub splice: Option<Spliced>,
    pub changed: Option<(Changed, Vec<String>)>,
    pub lines: Vec<LineRow>,
    /// What the inputs tell of themselves.
    pub reading: Reading,
    /// The slit that was found or taken off.
    pub slit: Option<SlitFound>,
    pub instrument: Option<Instrument>,
    /// True where the instrument is the result.
    pub is_learnt: bool,
    /// The composite that the result is.
    pub composite: Option<Composite>,
    /// Intervals that hold each value of a quotient 95 times of 100.
    pub intervals: Option<Vec<Option<[f64; 2]>>>,
    pub notes: Vec<String>,
    /// Finest step of the inputs, nm.
    pub step_nm: f64,
    /// Wavelengths of the inputs, as --grid names them.
    pub first_nm: Vec<Vec<f64>>,
}

impl Found {
    /// A spectrum and nothing beside it.
    pub fn of(result: Measurement, made_by: String, doubt_from: &'static str) -> Self {
        Self {
            step_nm: result.samples.step_nm(),
            result: Some(result),
            made_by,
            doubt_from,
            ..Self::nothing()
        }
    }

    fn nothing() -> Self {
        Self {
            result: None,
            made_by: String::new(),
            doubt_from: "repeats",
            scans: Vec::new(),
            drift: None,
            splice: None,
            changed: None,
            lines: Vec::new(),
            reading: Reading::default(),
            slit: None,
            instrument: None,
            is_learnt: false,
            composite: None,
            intervals: None,
            notes: Vec::new(),
            step_nm: 0.0,
            first_nm: Vec::new(),
        }
    }

    /// What differs between two sets, each part with its words, and a sentence.
    pub fn of_change(changed: Changed, words: Vec<String>, sentence: String) -> Self {
        Self {
            notes: vec![sentence],
            changed: Some((changed, words)),
            ..Self::nothing()
        }
    }

    /// The spectrum that was made.
    ///
    /// # Panics
    /// For a comparison, which makes none and is told before any is asked for.
    pub fn result(&self) -> &Measurement {
        self.result.as_ref().expect("a spectrum was made")
    }

    /// The same, to be completed.
    ///
    /// # Panics
    /// As [`Found::result`].
    pub fn result_mut(&mut self) -> &mut Measurement {
        self.result.as_mut().expect("a spectrum was made")
    }

    /// The lines of a light that was made, where nothing else told them.
    pub fn tell_lines(&mut self) {
        if let Some(result) = &self.result
            && result.quantity == Quantity::Light
            && self.lines.is_empty()
            && self.composite.is_none()
        {
            self.lines = lines_of(result)
                .into_iter()
                .map(LineRow::of_light)
                .collect();
        }
    }

    /// Lines whose top is cut keep their place, the middle of the cut, and lose their weight.
    pub(super) fn cut_lines(&mut self) {
        for top in &self.reading.clipped {
            let is_cut = |line: &&mut LineRow| (top.from_nm..=top.to_nm).contains(&line.at_nm);
            for line in self.lines.iter_mut().filter(is_cut) {
                line.at_nm = 0.5 * (top.from_nm + top.to_nm);
                (line.weight, line.share) = (None, None);
                (line.u[1], line.u[2]) = (None, None);
            }
        }
    }

    /// Figures of a light with their doubt, and what stands beside them; none where it is no light.
    /// A clipped light, and one of which too much is masked, has no doubt that could be told.
    pub fn figures(&self) -> Option<(Vec<Doubted>, Vec<String>)> {
        let result = self.result.as_ref().filter(|of| is_light(of))?;
        if self.reading.has_no_figures() {
            return None;
        }
        let mut all = doubts(result);
        let missing = missing_light(result);
        let is_clipped = !self.reading.clipped.is_empty();
        if is_clipped || !missing.is_empty() {
            for doubt in all.iter_mut().filter_map(|d| d.doubt.as_mut()) {
                doubt.value = doubt.of_the_table;
                (doubt.u, doubt.half_width_95) = (f64::NAN, f64::NAN);
            }
        }
        let stretches: Vec<String> = missing
            .iter()
            .map(|ends| {
                let [from, to] = ends.map(|nm| with_sign(nm.to_string()));
                format!("{from}-{to} nm")
            })
            .collect();
        let said = (!missing.is_empty()).then(|| {
            tr!(
                "The figures are without {stretches}, and have no \u{b1}.",
                stretches = stretches.join(", ")
            )
        });
        Some((all, said.into_iter().collect()))
    }

    /// The spectrum that was made, as one of the user's own of this name.
    pub fn into_entry(self, name: &str) -> Entry {
        let mut result = self.result().clone();
        name.clone_into(&mut result.name);
        let mut made = spectrum(&result, &self.made_by);
        made.notes = vec![tr!("Made: {made_by}.", made_by = self.made_by)];
        made.notes.extend(self.notes);
        Entry {
            measured: Some(Arc::new(result)),
            composite: self.composite.map(Arc::new),
            ..Entry::own(0, made)
        }
    }

    /// What is said beside the result: of the combination, and of figures and readings.
    pub fn notes(&self) -> (Vec<String>, Vec<String>) {
        let mut rest = self.reading.sentences();
        rest.extend(self.figures().into_iter().flat_map(|(_, said)| said));
        (self.notes.clone(), rest)
    }
}

/// The figures of a spectrum whose doubt is known, with it; none of one without.
pub fn doubts_of(entry: &Entry) -> Vec<Doubted> {
    let has_noise = |of: &Measurement| {
        of.sigma.is_some() || of.level > 0.0 || of.axis_nm > 0.0 || !of.shared.is_empty()
    };
    if !entry.measured.as_deref().is_some_and(has_noise) {
        return Vec::new();
    }
    let Ok(part) = Part::of_entry(entry, false) else {
        return Vec::new();
    };
    let found = Found {
        reading: part.reading,
        ..Found::of(part.of, String::new(), "stated")
    };
    let (mut all, _) = found.figures().unwrap_or_default();
    all.retain(|d| d.doubt.is_some_and(|doubt| doubt.half_width_95 > 0.0));
    all
}
