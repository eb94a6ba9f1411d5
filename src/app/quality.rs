//! What the place "Quality" shows of a state: figures measured and by the model, and sentences.

use std::sync::Arc;

use super::{
    entry::Entry,
    products::ModelledLight,
    quality_report::{ModelsByOrder, Row, Sheet, light_of, rows},
    state::App,
    ticks::short,
    tint, verdicts,
};
use crate::{
    color::quality::{Figures, HUE_NAMES, Light, NoFigure, diagram::quadrangle_of},
    spectrum::{Kind, NamedSpectrum},
    study::{
        Progress,
        quality::{Chosen, OrderFigures, figures_against_order},
    },
};

/// Everything that the place shows beside the curves against the order.
#[derive(Clone, Debug)]
pub struct QualityShown {
    /// The result in a sentence.
    pub sentence: String,
    /// Where it is among whites, a sentence.
    pub place: String,
    /// What it does to colours, a sentence.
    pub rendition: String,
    /// Each figure as measured, then by the model, then of every light laid over it.
    pub rows: Vec<Vec<Row>>,
    /// Those lights.
    pub others: Vec<String>,
    /// The light and its model.
    pub sheet: Sheet,
}

impl QualityShown {
    /// Of the document's light.
    pub fn of(app: &App) -> Self {
        let document = app.document();
        let name = document.light.name().to_owned();
        let sheet = Sheet::of(name, document, &ModelledLight::of(app).derived);
        let beside: Vec<&Arc<Entry>> = document
            .overlays
            .iter()
            .filter(|entry| entry.kind() == Kind::Light)
            .take(MOST_BESIDE)
            .collect();
        let columns = [rows(&sheet.measured), rows(&sheet.model)].into_iter();
        let columns: Vec<Vec<Row>> = columns
            .chain(beside.iter().map(|entry| {
                let (light, measured) = light_of(&entry.spectrum);
                rows(&Figures::of(&light, measured))
            }))
            .collect();
        let rows = columns[0]
            .iter()
            .map(|first| {
                let same = |column: &Vec<Row>| {
                    let row = column.iter().find(|row| row.figure.key == first.figure.key);
                    row.cloned().unwrap_or_else(|| Row {
                        value: Err("counted in another unit".to_owned()),
                        reading: String::new(),
                        ..first.clone()
                    })
                };
                columns.iter().map(same).collect()
            })
            .collect();
        let others = beside.iter().map(|entry| entry.name().to_owned()).collect();
        Self {
            sentence: match coarse_words(&document.light.spectrum) {
                Some(words) => format!("{} {words}", sentence(&sheet)),
                None => sentence(&sheet),
            },
            place: place(&sheet),
            rendition: rendition(&sheet),
            rows,
            others,
            sheet,
        }
    }

    /// Chromaticities as measured and by the model.
    pub fn places(&self) -> [Option<[f64; 2]>; 2] {
        let xy = |figures: &Figures| figures.xy[0].clone().ok();
        [xy(&self.sheet.measured), xy(&self.sheet.model)]
    }
}

/// "FL2 has no ...: why", for sentences that need a figure.
fn without(name: &str, what: &str, why: &NoFigure) -> String {
    format!("{name} has no {what}: {why}.")
}

/// What is to be said of a table that is too coarse for figures of quality: their standards
/// (CIE 13.3, ANSI/IES TM-30) ask for steps of 5 nm at most.
pub fn coarse_words(spectrum: &NamedSpectrum) -> Option<String> {
    const MOST_NM: f64 = 5.5;
    let step_nm = spectrum.samples.step_nm();
    (step_nm > MOST_NM).then(|| {
        let step = short(step_nm);
        format!("Its table has steps of {step} nm, where these figures want 5 nm or less.")
    })
}

fn sentence(sheet: &Sheet) -> String {
    let (name, figures) = (&sheet.name, &sheet.measured);
    let (fidelity, rendering) = match (&figures.fidelity, &figures.rendering) {
        (Ok(fidelity), Ok(rendering)) => (fidelity, rendering),
        (Err(why), _) | (_, Err(why)) => return without(name, "colour rendition", why),
    };
    let word = verdicts::of_rf(fidelity.rf);
    let by_model = sheet.model.fidelity.as_ref().map_or_else(
        |_| String::new(),
        |model| {
            let numbers = sheet.composite.numbers();
            let off = model.rf - fidelity.rf;
            let how = match off {
                off if off.abs() < 0.05 => "the same Rf".to_owned(),
                off if off < 0.0 => format!("an Rf {:.1} lower", -off),
                off => format!("an Rf {off:.1} higher"),
            };
            format!(" Its model of {numbers} numbers has {how}.")
        },
    );
    // A mean tells nothing of the worst.
    let samples = fidelity.samples.iter().copied();
    let lowest = samples.fold(f64::INFINITY, f64::min);
    format!(
        "{name} {word} on average: Rf {:.0} ({lowest:.0} on the worst of {} samples), Ra {:.0}, \
         R9 {:.0}.{by_model}",
        fidelity.rf,
        fidelity.samples.len(),
        rendering.ra,
        rendering.samples[8].index
    )
}

fn place(sheet: &Sheet) -> String {
    let (name, figures) = (&sheet.name, &sheet.measured);
    let cct = match &figures.cct {
        Ok(cct) => cct,
        Err(why) => return without(name, "colour temperature", why),
    };
    let white = figures.xy[0].clone().ok().and_then(quadrangle_of);
    let white = white.map_or_else(
        || "in none of the whites that lamps are sold by".to_owned(),
        |white| format!("may be sold as {:.0} K", white.nominal_k),
    );
    let (title, duv) = (tint::title_words(*cct), cct.duv);
    format!("{name}: {title} (Duv {duv:+.4}), {white}.")
}

fn rendition(sheet: &Sheet) -> String {
    let name = &sheet.name;
    let fidelity = match &sheet.measured.fidelity {
        Ok(fidelity) => fidelity,
        Err(why) => return without(name, "colour rendition", why),
    };
    let bins = fidelity.bins.iter().enumerate();
    let worst = bins
        .filter_map(|(i, bin)| Some((i, bin.as_ref()?)))
        .min_by(|a, b| a.1.rf.total_cmp(&b.1.rf));
    let worst = worst.map_or_else(String::new, |(i, bin)| {
        let how = verdicts::of_shift(bin.rcs, bin.rhs);
        let hue = HUE_NAMES[i];
        format!(
            " Most shifts {hue} (hue {} of 16): {how}, Rf {:.0}.",
            i + 1,
            bin.rf
        )
    });
    format!(
        "{name}: Rf {:.0}, Rg {:.0}.{worst}",
        fidelity.rf, fidelity.rg
    )
}

/// How many lights laid over it have columns beside it.
const MOST_BESIDE: usize = 4;

/// Highest order of the curves.
const HIGHEST: usize = 40;

/// What the figures against the order are of.
#[derive(Clone, Debug)]
pub struct ByOrder {
    light: Light,
    models: ModelsByOrder,
}

impl ByOrder {
    /// Of a state's light; the order in force does not matter.
    pub fn of(app: &App) -> Self {
        let (document, modelled) = (app.document(), ModelledLight::of(app));
        let ModelledLight {
            derived, tables, ..
        } = modelled;
        let (light, _) = light_of(&document.light.spectrum);
        Self {
            light: light.within(derived.band),
            models: ModelsByOrder::new(&derived, tables, document.settings.colour_exact),
        }
    }

    /// The answer; `None` when it was cancelled.
    pub fn answer(&self, progress: &Progress) -> Option<OrderFigures> {
        let highest = self.models.highest_order().min(HIGHEST);
        figures_against_order(&self.light, highest, |n| self.models.model(n), progress)
    }
}

/// From which order on the figures are near enough to the measured ones, and how near, a sentence.
pub fn settled_words(found: &OrderFigures) -> String {
    let highest = found.points.last().map_or(0, |point| point.order);
    let said = Chosen::ALL.map(|chosen| {
        let title = chosen.title();
        let Some(exact) = chosen.of(&found.exact) else {
            return format!("{title} has no value");
        };
        let near = chosen.near_enough(exact);
        let within = match chosen {
            Chosen::Cct => format!("{near:.0} K"),
            _ => short(near),
        };
        match found.settled_from(chosen) {
            Some(order) => format!("{title} within {within} from order {order} on"),
            None => format!("{title} within {within} at no order up to {highest}"),
        }
    });
    format!("As measured: {}.", said.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{Command, showing},
        spectrum::Sampled,
    };

    #[test]
    fn a_coarse_table_is_said_to_be_one() {
        let light = |step_nm: f64| NamedSpectrum {
            samples: Sampled::even(400.0, step_nm, vec![1.0, 2.0]).expect("two points"),
            ..App::new().document().light.spectrum.clone()
        };
        assert_eq!(coarse_words(&light(5.0)), None);
        let said = coarse_words(&light(300.0)).expect("words");
        assert!(said.contains("steps of 300 nm"), "{said}");
    }

    #[test]
    fn the_sentence_has_the_figures_of_the_sheet() {
        let app = App::new();
        let shown = QualityShown::of(&app);
        let fidelity = shown.sheet.measured.fidelity.as_ref().expect("a white");
        assert!(shown.sentence.contains(&format!("Rf {:.0}", fidelity.rf)));
        let worst = fidelity.samples.iter().copied().fold(100.0, f64::min);
        let worst = format!("({worst:.0} on the worst of 99 samples)");
        assert!(shown.sentence.contains(&worst), "{}", shown.sentence);
        let title = "FL2: 4220 K, slightly green (Duv +0.0018)";
        assert!(shown.place.starts_with(title), "{}", shown.place);
        let worst = shown.rendition.split_once("Most shifts ").expect("a hue").1;
        assert!(
            HUE_NAMES.iter().any(|hue| worst.starts_with(hue)),
            "{worst}"
        );
        assert!(shown.rows.iter().all(|row| row.len() == 2));
    }

    #[test]
    fn lights_laid_over_it_stand_beside_it_and_surfaces_do_not() {
        let mut app = App::new();
        for key in ["cie_fluorescent_1nm/FL11", "colorchecker_ohta/red"] {
            let entry = app.entry(key).expect("shipped");
            app.apply(Command::ToggleOverlay(entry));
        }
        let shown = QualityShown::of(&app);
        assert_eq!(shown.others, ["FL11"]);
        let rf = shown.rows.iter().find(|row| row[0].figure.key == "rf");
        let rf = rf.expect("every light has the row");
        assert_eq!(rf.len(), 3);
        assert!(rf[2].value.is_ok() && rf[2].value != rf[0].value);
    }

    #[test]
    fn a_light_without_a_white_says_why() {
        let shown = QualityShown::of(&showing("paper/Mercury"));
        for words in [&shown.sentence, &shown.place, &shown.rendition] {
            assert!(words.ends_with('.') && !words.contains("NaN"), "{words}");
        }
    }

    #[test]
    fn figures_against_order_are_those_of_the_models() {
        let app = App::new();
        let ask = ByOrder::of(&app);
        let found = ask.answer(&Progress::default()).expect("not cancelled");
        assert_eq!(found.points.len(), HIGHEST + 1);
        let words = settled_words(&found);
        for chosen in Chosen::ALL {
            assert!(words.contains(chosen.title()), "{words}");
        }
        // How near that is, is said with it: 21 K are half a per cent of 4224 K.
        for bound in ["Ra within 0.5 ", "CCT within 21 K ", "DER within 0.005 "] {
            assert!(words.contains(bound), "{words}");
        }
    }
}
