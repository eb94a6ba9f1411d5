//! Light through filters and off surfaces: what the command line prints, in words or as JSON.
//!
//! The JSON's keys are stable; docs/command_line.md tells them. XYZ has the exact light's Y at 100,
//! the white of every difference is the exact light, and a number that does not exist is `null`.

mod text;

pub use text::{chain_text, set_text};

use serde_json::{Value, json};

use super::{
    cells::{Columns, Table, cell, comments},
    export::provenance,
    products::{KnownLines, Link, ModelledLight},
    report::settings_json,
    state::App,
    ticks::short,
};
use crate::{
    color::{Xyz, srgb::Swatch},
    io::one_line,
    languages::fixed,
    spectrum::{Factor, Line},
    study::{
        Spread,
        products::{Colours, Passage, SetErrors, Step},
    },
};

/// Shares above this are no shares of light: bright fluorescent surfaces stay below.
const LARGEST_SHARE: f64 = 2.0;

/// A light through a chain, with what is told beside its figures.
#[derive(Clone, Debug)]
pub struct Told {
    /// Names of the factors, in their order.
    pub names: Vec<String>,
    /// Names of lines and dips.
    pub known: KnownLines,
    /// The light behind each factor.
    pub passage: Passage,
    /// What is to be known of each factor's own table, a sentence each.
    pub remarks: Vec<Vec<String>>,
}

impl Told {
    /// What must be said about each stage, a sentence each, without the stage's name. What is said
    /// of one stage and holds for those behind it is not said again.
    pub fn stage_notes(&self, lit: &ModelledLight) -> Vec<Vec<String>> {
        let named = |nm: f64| match self.known.safe(nm) {
            Some(name) => format!("{} nm ({name})", fixed(nm, 1)),
            None => format!("{} nm", fixed(nm, 1)),
        };
        let (mut before, mut said) = (&lit.derived.measured, Vec::new());
        let mut all = self.remarks.clone();
        for (notes, step) in all.iter_mut().zip(&self.passage.steps) {
            let mut both = before.iter().zip(&step.exact);
            if both.any(|(before, after)| *before > 0.0 && *after > LARGEST_SHARE * before) {
                notes.push(tr!(
                    "values above {most}: a share of light is at most 1. Are they per cent?",
                    most = short(LARGEST_SHARE)
                ));
            }
            before = &step.exact;
            for met in &step.met {
                notes.push(tr!(
                    "the line at {line} stands on a dip at {dip} {depth} % deep; it is multiplied \
                     by what the dip lets through.",
                    line = named(met.line_nm),
                    dip = named(met.dip_nm),
                    depth = fixed(100.0 * met.depth, 0)
                ));
            }
            for nm in step.below_zero.iter().chain(&step.turned) {
                // What is below zero at one stage is so at the next ones.
                if said.contains(nm) {
                    continue;
                }
                said.push(*nm);
                let place = named(*nm);
                notes.push(if step.turned.contains(nm) {
                    tr!(
                        "its share is below zero at {place} and turns the line there negative.",
                        place
                    )
                } else {
                    tr!("the dip at {place} takes the total below zero.", place)
                });
            }
        }
        all
    }

    /// Sends a light through a chain.
    pub fn of(app: &App, lit: &ModelledLight, chain: &[Link]) -> Self {
        let band = lit.band();
        let factors = factors(lit, chain);
        Self {
            names: chain.iter().map(Link::words).collect(),
            known: KnownLines::of(
                band,
                lit.derived.model.lines(),
                &lit.spike_names(app),
                chain.iter().map(|link| &*link.entry).zip(&factors),
            ),
            passage: passage(lit, &factors, chain),
            remarks: chain.iter().map(|link| link.remarks(band)).collect(),
        }
    }
}

/// The steps of a chain, each met once.
fn factors(lit: &ModelledLight, chain: &[Link]) -> Vec<Factor> {
    let once = chain.iter().map(|link| link.once_on_band(lit.band()));
    once.map(|values| lit.factor(values)).collect()
}

fn passage(lit: &ModelledLight, factors: &[Factor], chain: &[Link]) -> Passage {
    let times: Vec<usize> = chain.iter().map(|link| link.bounces as usize).collect();
    let met = factors.iter().zip(&times);
    let each: Vec<Factor> = met
        .flat_map(|(factor, times)| std::iter::repeat_n(factor.clone(), *times))
        .collect();
    lit.product().through(&each).grouped(&times)
}

/// The second light behind each step of a chain; `None` where none was chosen.
pub fn second_passage(app: &App, lit: &ModelledLight, chain: &[Link]) -> Option<Passage> {
    let second = lit.of_second(app)?;
    Some(passage(&second, &factors(&second, chain), chain))
}

/// A stage of a chain in its table: the light first, which nothing forms.
struct Stage<'a> {
    place: usize,
    name: &'a str,
    link: Option<&'a Link>,
    colours: &'a Colours,
    step: Option<&'a Step>,
}

/// A chain as a table: what comes out of each stage.
pub fn stages_table(app: &App, told: &Told, chain: &[Link]) -> Table {
    let passage = &told.passage;
    let y = |xyz: Xyz| cell(scaled(passage, xyz).map(|(xyz, _)| xyz.y));
    let passes = |at: usize| {
        move |stage: &Stage<'_>| cell(stage.step.and_then(|step| step.transmission[at]))
    };
    let columns = Columns::<Stage<'_>>::default()
        .with("stage", |stage| cell(stage.place))
        .with("name", |stage| cell(stage.name))
        .with("thickness", |stage| cell(stage.link.map(|l| l.thickness)))
        .with("times", |stage| cell(stage.link.map(|l| l.bounces)))
        .with("passes exact", passes(0))
        .with("passes model", passes(1))
        .with("Y exact", |stage| y(stage.colours.exact))
        .with("Y model", |stage| y(stage.colours.model))
        .with("CIEDE2000", |stage| cell(stage.colours.delta_e_2000))
        .with("luminance error", |stage| {
            cell(stage.colours.luminance_error)
        })
        .with("CIEDE2000 added", |stage| {
            cell(stage.step.and_then(|step| step.added))
        })
        .with("folded share", |stage| {
            cell(stage.step.map(|step| step.folded_share))
        })
        .with("multiplications", |stage| {
            cell(stage.step.map(|step| step.multiplications))
        });
    let light = Stage {
        place: 0,
        name: app.document().light.name(),
        link: None,
        colours: &passage.light,
        step: None,
    };
    let steps = chain.iter().zip(&passage.steps).enumerate();
    let stages = steps.map(|(i, (link, step))| Stage {
        place: i + 1,
        name: link.entry.name(),
        link: Some(link),
        colours: &step.colours,
        step: Some(step),
    });
    Table::new(
        table_head(app),
        columns,
        std::iter::once(light).chain(stages),
    )
}

/// The spikes behind a stage as a table, in the light's own unit x nm.
pub fn spikes_table(app: &App, stage: &str, spikes: &[Line], known: &KnownLines) -> Table {
    let comments = format!("{}# behind: {}\n", table_head(app), one_line(stage));
    let columns = Columns::<&Line>::default()
        .with("place nm", |spike| cell(spike.at_nm))
        .with("weight", |spike| cell(spike.weight))
        .with("name", |spike| cell(known.safe(spike.at_nm)));
    Table::new(comments, columns, spikes)
}

/// Comments over a table: the light, its source and how products are formed.
fn table_head(app: &App) -> String {
    let head = comments(&provenance(app), &app.document().light.spectrum);
    let way = app.document().settings.sampling.word();
    format!("{head}# products: {way}\n")
}

pub fn chain_json(app: &App, told: &Told) -> Value {
    let Told {
        remarks: _,
        names,
        known,
        passage,
    } = told;
    let total = passage.total();
    let stages: Vec<Value> = names
        .iter()
        .zip(&passage.steps)
        .map(|(name, step)| stage_json(passage, name, step, known))
        .collect();
    let mut value = head_json(app);
    value["factors"] = json!(names);
    value["delta_e_2000"] = json!(total.colours.delta_e_2000);
    value["luminance_error"] = json!(total.colours.luminance_error);
    value["added"] = json!(total.added);
    value["total"] = json!(total.colours.delta_e_2000);
    value["folded_share"] = json!(total.folded_share);
    value["multiplications"] = json!(total.multiplications);
    value["transmission"] = transmission_json(total.transmission);
    value["exact"] = colour_json(passage, total.colours.exact);
    value["model"] = colour_json(passage, total.colours.model);
    value["stages"] = json!(stages);
    value["notes"] = json!(notes(app, told));
    value
}

/// A light with every factor of a group as JSON.
pub fn set_json(app: &App, set: &str, names: &[String], errors: &SetErrors) -> Value {
    let items = names.iter().zip(&errors.each);
    let items =
        items.map(|(name, [added, total])| json!({ "name": name, "added": added, "total": total }));
    let mut value = head_json(app);
    value["set"] = json!(set);
    value["count"] = json!(errors.count);
    value["added"] = spread_json(errors.added);
    value["total"] = spread_json(errors.total);
    value["items"] = items.collect();
    value
}

fn head_json(app: &App) -> Value {
    let light = &app.document().light.spectrum;
    json!({
        "program": { "name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION") },
        "light": { "name": light.name, "unit": light.unit, "source": light.source },
        "settings": settings_json(app),
        "sampling": app.document().settings.sampling.word(),
    })
}

fn stage_json(passage: &Passage, name: &str, step: &Step, known: &KnownLines) -> Value {
    let Step {
        exact: _,
        smooth: _,
        spikes,
        colours,
        added,
        transmission,
        folded_share,
        multiplications,
        met,
        below_zero,
        turned,
    } = step;
    json!({
        "name": name,
        "delta_e_2000": colours.delta_e_2000,
        "luminance_error": colours.luminance_error,
        "added": added,
        "folded_share": folded_share,
        "multiplications": multiplications,
        "transmission": transmission_json(*transmission),
        "exact": colour_json(passage, colours.exact),
        "model": colour_json(passage, colours.model),
        "spikes": spikes
            .iter()
            .map(|Line { at_nm, weight, .. }| {
                json!({ "at_nm": at_nm, "weight": weight, "name": known.safe(*at_nm) })
            })
            .collect::<Vec<_>>(),
        "lines_on_dips": met
            .iter()
            .map(|met| {
                json!({
                    "at_nm": met.line_nm,
                    "dip_nm": met.dip_nm,
                    "depth": met.depth,
                    "name": known.safe(met.line_nm),
                    "dip_name": known.safe(met.dip_nm),
                })
            })
            .collect::<Vec<_>>(),
        "below_zero_nm": below_zero,
        "turned_negative_nm": turned,
    })
}

fn transmission_json([exact, model]: [Option<f64>; 2]) -> Value {
    json!({ "exact": exact, "model": model })
}

/// Of a set: median, 95th percentile and worst.
pub(super) fn spread_json(spread: Option<Spread>) -> Value {
    json!({
        "median": spread.map(|s| s.median),
        "p95": spread.map(|s| s.p95),
        "worst": spread.map(|s| s.worst),
    })
}

/// XYZ with the exact light's Y at 100 and what the screen shows; `null` without a white.
fn colour_json(passage: &Passage, xyz: Xyz) -> Value {
    let Some((xyz, swatch)) = scaled(passage, xyz) else {
        return json!({ "xyz": null, "srgb_hex": null });
    };
    json!({ "xyz": xyz.to_array(), "srgb_hex": swatch.hex() })
}

/// A colour of a passage with the exact light's Y at 100, and what the screen shows of it; `None`
/// without a white.
pub fn scaled(passage: &Passage, xyz: Xyz) -> Option<(Xyz, Swatch)> {
    let white = passage.white.with_y(100.0)?;
    let xyz = xyz * (100.0 / passage.white.y);
    xyz.is_finite()
        .then(|| (xyz, Swatch::beside_light(xyz, white)))
}

/// What must be said about the result, a sentence each.
fn notes(app: &App, told: &Told) -> Vec<String> {
    let mut notes = app.derived().warnings.clone();
    let of_stages = told.stage_notes(&ModelledLight::of(app));
    for (name, sentences) in told.names.iter().zip(of_stages) {
        let sentences = sentences.into_iter();
        notes.extend(sentences.map(|sentence| format!("{name}: {sentence}")));
    }
    notes
}
