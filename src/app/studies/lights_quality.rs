//! Light quality of many lights at once: a row a light, the best first.

use std::collections::HashSet;

use serde::{Deserialize, Serialize};

use crate::{
    app::{App, Entry, memo::ByAddress, quality_report::light_of, tint},
    color::quality::{EFFICACY, Figures},
    languages::fixed,
    spectrum::Kind,
    study::{Progress, quality::figures_of_many},
};

use super::{Crossing, Question};

/// The lights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LightsQualityAsk(pub Vec<ByAddress<Entry>>);

/// The quality of a light; what a light has no figure of is left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LightQuality {
    /// The entry's key.
    pub key: String,
    pub name: String,
    /// Its white: "4220 K, slightly green".
    pub white: Option<String>,
    pub kelvin: Option<f64>,
    pub rf: Option<f64>,
    pub ra: Option<f64>,
    pub r9: Option<f64>,
    /// lm/W of radiation.
    pub efficacy: Option<f64>,
}

impl LightsQualityAsk {
    /// The lights that have these keys, of the user's own and the shipped ones.
    pub fn of(app: &App, keys: &[String]) -> Self {
        let keys: HashSet<&str> = keys.iter().map(String::as_str).collect();
        let all = app.document().own.iter().chain(app.bundled());
        let wanted = all.filter(|e| e.kind() == Kind::Light && keys.contains(e.key.as_str()));
        Self(wanted.map(|entry| ByAddress(entry.clone())).collect())
    }
}

impl LightQuality {
    fn of(entry: &Entry, figures: &Figures) -> Self {
        let rendering = figures.rendering.as_ref().ok();
        Self {
            key: entry.key.clone(),
            name: entry.name().to_owned(),
            white: figures.cct.as_ref().ok().map(|cct| tint::title_words(*cct)),
            kelvin: figures.cct.as_ref().ok().map(|cct| cct.kelvin),
            rf: figures.fidelity.as_ref().ok().map(|found| found.rf),
            ra: rendering.map(|found| found.ra),
            r9: rendering.map(|found| found.samples[8].index),
            efficacy: figures.single(&EFFICACY).as_ref().ok().copied(),
        }
    }
}

impl Question for LightsQualityAsk {
    type Answer = Vec<LightQuality>;

    fn answer(&self, progress: &Progress) -> Option<Vec<LightQuality>> {
        let lights: Vec<_> = self.0.iter().map(|e| light_of(&e.0.spectrum)).collect();
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let figures = figures_of_many(&lights, threads, progress)?;
        let both = self.0.iter().zip(&figures);
        let mut rows: Vec<LightQuality> = both
            .map(|(entry, figures)| LightQuality::of(&entry.0, figures))
            .collect();
        let height = |row: &LightQuality| row.rf.unwrap_or(f64::NEG_INFINITY);
        rows.sort_by(|a, b| height(b).total_cmp(&height(a)));
        Some(rows)
    }

    fn crossing() -> Option<Crossing<Self, Self::Answer>> {
        Some(Crossing::of("quality"))
    }
}

/// "Rf from 98 (a.csv) to 51 (c.csv): 2 of 3 lights reach 80."
pub fn sentence(rows: &[LightQuality]) -> String {
    const GOOD: f64 = 80.0;
    let known: Vec<(&LightQuality, f64)> =
        rows.iter().filter_map(|row| Some((row, row.rf?))).collect();
    match (known.first(), known.last()) {
        (Some((best, most)), Some((worst, least))) => tr!(
            "Rf from {highest} ({best}) to {lowest} ({worst}): {count} of {all} lights reach \
             {good}.",
            highest = fixed(most, 0),
            best = best.name,
            lowest = fixed(least, 0),
            worst = worst.name,
            count = known.iter().filter(|(_, rf)| *rf >= GOOD).count(),
            all = rows.len(),
            good = fixed(GOOD, 0)
        ),
        _ => said!("None of these lights has a colour rendering to compare.").to_owned(),
    }
}

/// The rows as CSV.
pub fn csv(rows: &[LightQuality]) -> String {
    let cell = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let number = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:.2}"));
    let mut out = "light,white,Rf,Ra,R9,lm/W\n".to_owned();
    for row in rows {
        let white = row.white.as_deref().unwrap_or_default();
        let numbers = [row.rf, row.ra, row.r9, row.efficacy].map(number).join(",");
        out += &format!("{},{},{numbers}\n", cell(&row.name), cell(white));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::Command, study::Progress};

    #[test]
    fn many_lights_are_sorted_by_their_own_figures_and_the_sentence_reads_them_back() {
        let mut app = App::new();
        let names = ["cie_fluorescent_1nm/FL2", "cie_illuminants/CIE A"];
        let spectra = names.map(|key| app.entry(key).expect(key).spectrum.clone());
        app.apply(Command::Adopt(spectra.to_vec()));
        let keys: Vec<String> = app.document().own.iter().map(|e| e.key.clone()).collect();
        let ask = LightsQualityAsk::of(&app, &keys);
        let rows = ask.answer(&Progress::default()).expect("not cancelled");
        // A blackbody is its own reference.
        assert!(rows[0].name.contains('A') && rows[0].rf.is_some_and(|rf| rf > 99.0));
        assert_eq!(rows[1].white.as_deref(), Some("4220 K, slightly green"));
        let said = sentence(&rows);
        let [best, worst] = [&rows[0], &rows[1]].map(|row| row.rf.expect("a white"));
        assert!(said.contains(&format!("from {best:.0} (")), "{said}");
        assert!(
            said.contains(&format!("to {worst:.0} (FL2): 1 of 2")),
            "{said}"
        );
        assert_eq!(csv(&rows).lines().count(), 3);
        // Shipped lights by their own keys are the same lights.
        let shipped = LightsQualityAsk::of(&app, &names.map(str::to_owned));
        let shipped = shipped.answer(&Progress::default()).expect("not cancelled");
        let figures =
            |rows: &[LightQuality]| rows.iter().map(|r| (r.rf, r.kelvin)).collect::<Vec<_>>();
        assert_eq!(figures(&shipped), figures(&rows));
        assert!(sentence(&[]).starts_with("None"));
    }
}
