//! What the place "Quality" shows of a state: figures measured and by the model, and sentences.

mod board;
mod tiles;
mod verdict;

use super::{
    charts::quality::PlacedLight,
    combining::doubts_of,
    comparison::Side,
    entry::Entry,
    products::ModelledLight,
    quality_report::{ModelsByOrder, Row, Sheet, light_of, rows_with},
    state::App,
    ticks::short,
    tint,
};
use crate::{
    color::quality::{Fidelity, Light, NoFigure, Rendering, diagram::quadrangle_of},
    languages::{fixed, said, signed},
    measurements::Doubted,
    spectrum::NamedSpectrum,
    study::{
        Progress,
        quality::{Chosen, OrderFigures, figures_against_order},
    },
};

pub use board::{Board, CLIENTS_TABLES};
pub use tiles::{GROUPS, IN_GROUP, Tile, Told};

/// Everything that the place shows beside the curves against the order.
#[derive(Clone, Debug)]
pub struct QualityShown {
    /// The verdict; of two lights which is better for what.
    pub sentence: String,
    /// What the light is good enough for; of two lights each one's own verdict.
    pub more: Vec<String>,
    /// Where it is among whites, a sentence.
    pub place: String,
    /// What it does to colours, a sentence.
    pub rendition: String,
    /// The figures in large type.
    pub tiles: Vec<Tile>,
    /// The surfaces that a client asks for.
    pub surfaces: Board,
    /// The surfaces of the document, hue by hue.
    pub board: Board,
    /// Each figure as measured; then by the model, of two lights that of the second.
    pub rows: Vec<[Row; 2]>,
    /// The lights that are shown: one or two.
    pub sides: Vec<Side>,
    /// The light and its model.
    pub sheet: Sheet,
}

impl QualityShown {
    /// Of the document's light, and of the second one.
    pub fn of(app: &App) -> Self {
        let document = app.document();
        let light = &document.light;
        let sheet = Sheet::of(
            light.name().to_owned(),
            document,
            &ModelledLight::of(app).derived,
        );
        let compared = app.compared();
        let sides = match compared {
            Some(compared) => compared.sides.to_vec(),
            None => {
                let figures = sheet.measured.clone();
                vec![Side::new(sheet.name.clone(), &light.spectrum, figures)]
            }
        };
        let entries = [Some(light), document.second.as_ref()];
        let entries = entries.into_iter().flatten().map(|entry| &**entry);
        let lights: Vec<(&Entry, &Side)> = entries.zip(&sides).collect();
        let doubts: Vec<Vec<Doubted>> = lights.iter().map(|(entry, _)| doubts_of(entry)).collect();
        let mut verdicts = sides.iter().map(verdict::verdict);
        let (sentence, mut more) = match compared {
            Some(compared) => (compared.summary.clone(), verdicts.collect()),
            None => (verdicts.next().unwrap_or_default(), Vec::new()),
        };
        more.extend(coarse_words(&light.spectrum));
        Self {
            sentence,
            more,
            place: joined(&sides, place),
            rendition: verdict::rendition(&sides),
            tiles: tiles::tiles(&sides, compared, &doubts),
            surfaces: Board::for_clients(&lights, document.view.adaptation()),
            board: Board::by_hue(document, &lights),
            rows: pairs(
                rows_with(&sheet.measured, &doubts[0]),
                match sides.get(1) {
                    Some(second) => rows_with(&second.figures, &doubts[1]),
                    None => rows_with(&sheet.model, &[]),
                },
            ),
            sides,
            sheet,
        }
    }

    /// The second light's name.
    pub fn second(&self) -> Option<&str> {
        self.sides.get(1).map(|side| side.name.as_str())
    }

    /// The lights in the chromaticity diagram.
    pub fn placed(&self) -> Vec<PlacedLight> {
        let placed = |side: &Side| PlacedLight::of(&side.name, &side.figures);
        self.sides.iter().map(placed).collect()
    }

    /// The CRI of those lights that have it, with their names.
    pub fn renderings(&self) -> Vec<(&str, &Rendering)> {
        let sides = self.sides.iter();
        let found = sides.filter_map(|side| {
            let rendering = side.figures.rendering.as_ref().ok()?;
            Some((side.name.as_str(), rendering))
        });
        found.collect()
    }

    /// The TM-30 figures of those lights that have them, with their names.
    pub fn fidelities(&self) -> Vec<(&str, &Fidelity)> {
        let sides = self.sides.iter();
        let found = sides.filter_map(|side| {
            let fidelity = side.figures.fidelity.as_ref().ok()?;
            Some((side.name.as_str(), fidelity))
        });
        found.collect()
    }
}

/// Each figure of one beside the same of another.
fn pairs(first: Vec<Row>, second: Vec<Row>) -> Vec<[Row; 2]> {
    let pair = |row: Row| {
        let same = second
            .iter()
            .find(|other| other.figure.key == row.figure.key);
        let same = same.cloned().unwrap_or_else(|| Row {
            value: Err(said!("counted in another unit").to_owned()),
            reading: String::new(),
            doubt: None,
            ..row.clone()
        });
        [row, same]
    };
    first.into_iter().map(pair).collect()
}

/// A sentence of each light.
fn joined(sides: &[Side], words: impl Fn(&Side) -> String) -> String {
    let all: Vec<String> = sides.iter().map(words).collect();
    all.join(" ")
}

/// For a sentence that needs figures of what a light does to colours.
fn without_rendition(name: &str, why: &NoFigure) -> String {
    tr!("{name} has no colour rendition: {why}", name, why)
}

/// What is to be said of a table that is too coarse for figures of quality: their standards
/// (CIE 13.3, ANSI/IES TM-30) ask for steps of 5 nm at most.
pub fn coarse_words(spectrum: &NamedSpectrum) -> Option<String> {
    const MOST_NM: f64 = 5.5;
    let step_nm = spectrum.samples.step_nm();
    (step_nm > MOST_NM).then(|| {
        let step = short(step_nm);
        tr!(
            "Its table has steps of {step} nm, where these figures want 5 nm or less.",
            step
        )
    })
}

fn place(side: &Side) -> String {
    let (name, figures) = (&side.name, &side.figures);
    let cct = match &figures.cct {
        Ok(cct) => cct,
        Err(why) => return tr!("{name} has no colour temperature: {why}.", name, why),
    };
    let white = figures.xy[0].clone().ok().and_then(quadrangle_of);
    let (title, duv) = (tint::title_words(*cct), signed(cct.duv, 4));
    match white {
        Some(white) => tr!(
            "{name}: {title} (Duv {duv}), may be sold as {kelvin} K.",
            name,
            title,
            duv,
            kelvin = fixed(white.nominal_k, 0)
        ),
        None => tr!(
            "{name}: {title} (Duv {duv}), in none of the whites that lamps are sold by.",
            name,
            title,
            duv
        ),
    }
}

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
        let title = said(chosen.title());
        let Some(exact) = chosen.of(&found.exact) else {
            return tr!("{title} has no value", title);
        };
        let near = chosen.near_enough(exact);
        let within = match chosen {
            Chosen::Cct => format!("{} K", fixed(near, 0)),
            _ => short(near),
        };
        match found.settled_from(chosen) {
            Some(order) => tr!(
                "{title} (within {within}) from {order}",
                title,
                within,
                order
            ),
            None => tr!(
                "{title} (within {within}) with none up to {highest}",
                title,
                within,
                highest
            ),
        }
    });
    tr!(
        "Waves that give the light's own figures: {figures}.",
        figures = said.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{Command, quality_report::rows, showing},
        measurements::{Measurement, Quantity},
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
    fn a_light_alone_has_its_own_verdict_beside_its_model() {
        let app = App::new();
        let shown = QualityShown::of(&app);
        assert!(shown.sentence.starts_with("FL2 "), "{}", shown.sentence);
        assert!(shown.more.is_empty() && shown.second().is_none());
        let title = "FL2: 4220 K, slightly green (Duv +0.0018)";
        assert!(shown.place.starts_with(title), "{}", shown.place);
        let of_model = rows(&shown.sheet.model);
        for ([measured, model], row) in shown.rows.iter().zip(of_model) {
            assert_eq!(measured.figure.key, model.figure.key);
            assert_eq!(model.value, row.value);
        }
    }

    #[test]
    fn figures_of_scans_have_their_doubt_beside_them_and_others_none() {
        let app = App::new();
        assert!(
            QualityShown::of(&app)
                .rows
                .iter()
                .flatten()
                .all(|row| row.doubt.is_none())
        );
        let light = app.document().light.spectrum.samples.clone();
        let sigma = vec![0.002 * light.values().iter().copied().fold(0.0, f64::max); light.len()];
        let mut of = Measurement::new("mean", Quantity::Light, "", light);
        (of.sigma, of.level, of.scans) = (Some(sigma), 0.01, Some(4));
        let mut entry = (*app.document().light).clone();
        (entry.key, entry.measured) = ("own/1".to_owned(), Some(std::sync::Arc::new(of)));
        let mut app = app;
        app.apply(Command::Show(std::sync::Arc::new(entry)));
        let shown = QualityShown::of(&app);
        let told = |key: &str| {
            let row = shown.rows.iter().find(|row| row[0].figure.key == key);
            row.expect("a row").each_ref().map(Row::shown)
        };
        for key in ["cct", "duv", "ra", "r9", "rf"] {
            let [light, model] = told(key);
            assert!(light.contains(" ± "), "{key}: {light}");
            assert!(!model.contains('±'), "{key}: {model}");
        }
        assert!(!told("rg")[0].contains('±'));
        let of_tile = |figure: &str| {
            let tile = shown.tiles.iter().find(|tile| tile.figure == figure);
            tile.expect("a tile").sides[0].clone()
        };
        for figure in ["Rf", "Ra", "K", "Duv"] {
            assert!(of_tile(figure).half.starts_with("± "), "{figure}");
        }
        assert_eq!(of_tile("Rg").half, "");
    }

    #[test]
    fn a_second_light_stands_beside_it_and_overlays_do_not() {
        let mut app = App::new();
        let entry = |app: &App, key: &str| app.entry(key).expect("shipped");
        app.apply(Command::ToggleOverlay(entry(&app, "cie_illuminants/CIE A")));
        assert_eq!(QualityShown::of(&app).second(), None);
        let second = entry(&app, "cie_fluorescent_1nm/FL11");
        app.apply(Command::Compare(Some(second)));
        let shown = QualityShown::of(&app);
        assert_eq!(shown.second(), Some("FL11"));
        let compared = app.compared().expect("two lights");
        assert_eq!(shown.sentence, compared.summary);
        assert_eq!(shown.more.len(), 2);
        for words in [&shown.place, &shown.rendition] {
            assert!(words.contains("FL2") && words.contains("FL11"), "{words}");
        }
        let own = rows(&compared.sides[1].figures);
        let rf = |row: &Row| row.figure.key == "rf";
        let beside = shown.rows.iter().find(|row| rf(&row[0])).expect("a row");
        let own = own.iter().find(|row| rf(row)).expect("a row");
        assert_eq!(beside[1].value, own.value);
        assert!(shown.tiles.iter().all(|tile| tile.sides.len() == 2));
        assert_eq!((shown.surfaces.sides.len(), shown.board.len()), (2, 24));
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
        for bound in ["Ra (within 0.5)", "CCT (within 21 K)", "DER (within 0.005)"] {
            assert!(words.contains(bound), "{words}");
        }
    }
}
