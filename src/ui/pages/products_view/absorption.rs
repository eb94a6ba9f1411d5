//! The page "Dark lines": dips as negative spikes, and their names.

use crate::ui::kit::drag_value;
use eframe::egui;
use egui::{Ui, vec2};

use crate::{
    app::{
        App, Command, Detector, Entry, Memo, Settings,
        charts::products::absorption::{AbsorptionSheet, DarkLine, DipRow, looks},
        headlines,
        pages::knob::Knob,
        ticks::short,
    },
    languages::{fixed, said},
    spectrum::Band,
    ui::{
        kit::{
            Chooser, Column, GROUP, Row, copy_button, fold, headline, named, scrolled, table,
            warning,
        },
        pages::PageContext,
    },
};

/// Names of controls, shared with the tests that move them.
pub mod names {
    pub const OTHER: &str = later!("Another light, glass or surface");
    pub const DIPS: &str = later!("Look for dark lines");
    pub const THRESHOLD: &str = later!("Least share of a dark line");
    pub const WIDTH: &str = later!("Widest dark line");
    pub const COPY: &str = later!("Copy as CSV");
    pub const ALL: &str = later!("Every dark line in figures");
}

/// Least height of the chart, and height of a fold that is shut, points.
const CHART: f32 = 240.0;
const FOLDED: f32 = 30.0;

/// Something worth looking at, with knobs that suit it.
struct Example {
    title: &'static str,
    meaning: &'static str,
    key: &'static str,
    threshold_percent: f64,
    max_width_nm: f64,
    band_nm: [f64; 2],
}

const EXAMPLES: [Example; 4] = [
    Example {
        title: later!("Sun on the ground"),
        meaning: later!("ASTM G173 global tilt: Fraunhofer's lines, and the oxygen of the air."),
        key: "solar_astm_g173/ASTM G173-03 global tilt AM1.5G",
        threshold_percent: 0.1,
        max_width_nm: 4.5,
        band_nm: [380.0, 780.0],
    },
    Example {
        title: later!("Sun in space"),
        meaning: later!("ASTM G173 extraterrestrial: the sun's own lines alone."),
        key: "solar_astm_g173/ASTM G173-03 extraterrestrial",
        threshold_percent: 0.05,
        max_width_nm: 3.0,
        band_nm: [380.0, 780.0],
    },
    Example {
        title: later!("Holmium oxide"),
        meaning: later!("The powder's reflectance: bands so wide that few pass for lines."),
        key: "usgs_splib07/Holmium oxide powder (USGS splib07a Record 18789)",
        threshold_percent: 0.15,
        max_width_nm: 25.0,
        band_nm: [380.0, 700.0],
    },
    Example {
        title: later!("Neodymium lamp"),
        meaning: later!("An incandescent lamp with neodymium in its bulb, a table of 5 nm."),
        key: "lamps_nist_traditional/Neodimium Incandescent",
        threshold_percent: 0.15,
        max_width_nm: 30.0,
        band_nm: [380.0, 780.0],
    },
];

/// The page and what it keeps from frame to frame.
#[derive(Default)]
pub struct AbsorptionView {
    found: Memo<u64, Found>,
}

/// What is shown: dark lines of the document, or of the first example where it is not searched.
struct Found {
    sheet: AbsorptionSheet,
    rows: Vec<Row>,
    words: String,
    is_example: bool,
}

impl Found {
    fn of(app: &App) -> Self {
        let example = instead(app);
        let is_example = example.is_some();
        let app = example.as_ref().unwrap_or(app);
        let sheet = AbsorptionSheet::of(app);
        let dips = sheet.dips.iter();
        let dips = dips.map(|dip| (dip.spike.at_nm, row(app, dip)));
        let known = sheet.known.iter();
        let known = known.map(|line| (line.at_nm(), known_row(line)));
        let mut rows: Vec<(f64, Row)> = dips.chain(known).collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let words = headlines::dark_lines(app, &sheet.dips);
        let subject = app.document().subject_entry();
        let example = EXAMPLES.iter().find(|example| example.key == subject.key);
        Self {
            // An example is called as on its button.
            words: example.map_or(words.clone(), |example| {
                words.replace(subject.name(), said(example.title))
            }),
            rows: rows.into_iter().map(|(_, row)| row).collect(),
            sheet,
            is_example,
        }
    }
}

/// The program with the first example, where the document is none and is not searched itself.
fn instead(app: &App) -> Option<App> {
    let document = app.document();
    let subject = &document.subject_entry().key;
    if looks(document.settings) || EXAMPLES.iter().any(|example| example.key == *subject) {
        return None;
    }
    let first = &EXAMPLES[0];
    let entry = app.entry(first.key)?;
    let settings = first.over(document.settings);
    let mut other = app.clone();
    other.apply(Command::ShowWith { entry, settings });
    Some(other)
}

impl AbsorptionView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let found = &*self.found.get(app.revision(), |_| Found::of(app));
        headline(ui, context.theme, &*found.words);
        ui.add_space(GROUP);
        let scale = context.theme.scale;
        // Measured outside: what is scrolled must not grow by what it was scrolled.
        let room = ui.available_height();
        scrolled(ui, "dark lines", |ui| {
            let top = ui.cursor().top();
            examples(ui, context, found.is_example);
            knobs(ui, context, found.is_example);
            warnings(ui, context, &found.sheet);
            ui.add_space(GROUP);
            for sentence in &found.sheet.met {
                warning(ui, context.theme, sentence.as_str());
            }
            let left = room - (ui.cursor().top() - top) - FOLDED * scale;
            let size = vec2(ui.available_width(), left.max(CHART * scale));
            context.chart(ui, &found.sheet.chart, "absorption", size);
            fold(ui, "dips", said(names::ALL), |ui| {
                dip_table(ui, context, &found.sheet, &found.rows);
            });
        });
    }
}

fn examples(ui: &mut Ui, context: &mut PageContext<'_>, is_example: bool) {
    let app = context.app;
    let subject = app.document().subject_entry();
    ui.horizontal_wrapped(|ui| {
        for (index, example) in EXAMPLES.iter().enumerate() {
            let is_shown = subject.key == example.key || is_example && index == 0;
            let response = ui.selectable_label(is_shown, said(example.title));
            if response
                .on_hover_text(tr!(
                    "{meaning} Shows it with dark lines of at least {share} % of the power, up to \
                     {width} nm wide, on {from}-{to} nm.",
                    meaning = said(example.meaning),
                    share = short(example.threshold_percent),
                    width = short(example.max_width_nm),
                    from = short(example.band_nm[0]),
                    to = short(example.band_nm[1])
                ))
                .clicked()
                && let Some(entry) = app.entry(example.key)
            {
                context.pages.dark_lines.example = index;
                context.commands.push(Command::ShowWith {
                    entry,
                    settings: example.over(app.document().settings),
                });
            }
        }
        let other = Chooser {
            name: said(names::OTHER),
            meaning: said!(
                "Any light, filter, glass or surface, shipped or your own; it becomes what the \
                 window shows."
            ),
            says: if EXAMPLES.iter().any(|e| e.key == subject.key) {
                said!("Another …")
            } else {
                subject.name()
            },
            offers: Entry::is_usable,
            width: 150.0 * context.theme.scale,
        };
        if let Some(entry) = other.show(ui, app) {
            context.commands.push(Command::Show(entry));
        }
    });
}

impl Example {
    fn over(&self, settings: Settings) -> Settings {
        let [min, max] = self.band_nm;
        Settings {
            threshold_percent: self.threshold_percent,
            max_width_nm: self.max_width_nm,
            band: Band::new(min, max).unwrap_or(settings.band),
            ..looking(settings)
        }
    }
}

/// The same settings with dips looked for: only one of the detectors can.
fn looking(settings: Settings) -> Settings {
    Settings {
        dips: true,
        spikes: true,
        detector: Detector::Energy,
        ..settings
    }
}

fn knobs(ui: &mut Ui, context: &mut PageContext<'_>, is_example: bool) {
    let document = context.app.document();
    let before = document.settings;
    let mut settings = before;
    ui.horizontal_wrapped(|ui| {
        if is_example {
            ui.weak(tr!(
                "An example. In {spectrum}:",
                spectrum = document.subject_entry().name()
            ));
        }
        let mut on = looks(before);
        if ui
            .checkbox(&mut on, said(names::DIPS))
            .on_hover_text(said!(
                "Absorption lines become lines of negative weight. This needs lines found by \
                 energy and switches that on."
            ))
            .changed()
        {
            settings = if on {
                looking(settings)
            } else {
                Settings {
                    dips: false,
                    ..settings
                }
            };
        }
        if is_example {
            return;
        }
        let mut knob = |before: &str,
                        value: &mut f64,
                        (knob, speed): (Knob<Settings>, f64),
                        meaning: &str,
                        name| {
            let label = ui.label(before);
            let drag = drag_value(value)
                .range(knob.reach.range())
                .speed(speed)
                .custom_formatter(|v, _| short(v))
                .suffix(knob.unit());
            let response = ui.add(drag).labelled_by(label.id).on_hover_text(meaning);
            named(&response, egui::Role::SpinButton, name);
        };
        knob(
            said!("of at least"),
            &mut settings.threshold_percent,
            (Settings::THRESHOLD, 0.01),
            said!("Least share of the total power that a line must carry or lack, percent."),
            said(names::THRESHOLD),
        );
        knob(
            said!("up to"),
            &mut settings.max_width_nm,
            (Settings::WIDTH, 0.1),
            said!("Widest line, full width at half maximum, nm."),
            said(names::WIDTH),
        );
        ui.label(said!("wide"));
    });
    if settings != before {
        context.commands.push(Command::Edit(settings));
    }
}

fn warnings(ui: &mut Ui, context: &PageContext<'_>, found: &AbsorptionSheet) {
    let below: Vec<String> = found
        .dips
        .iter()
        .filter(|dip| dip.below_zero)
        .map(|dip| fixed(dip.spike.at_nm, 1))
        .collect();
    if below.is_empty() {
        return;
    }
    let width = short(context.app.document().settings.max_width_nm);
    let words = match below.len() {
        1 => tr!(
            "The model's total goes below zero at {place} nm: drawn {width} nm wide, the dark line \
             takes more than the smooth part has there. Not to be believed at this place.",
            place = below[0],
            width
        ),
        _ => tr!(
            "The model's total goes below zero at {places} nm: drawn {width} nm wide, these dark \
             lines take more than the smooth part has there. Not to be believed at these places.",
            places = below.join(", "),
            width
        ),
    };
    warning(ui, context.theme, words);
}

fn dip_table(ui: &mut Ui, context: &PageContext<'_>, found: &AbsorptionSheet, rows: &[Row]) {
    ui.horizontal(|ui| {
        let count = found.dips.len();
        ui.strong(match count {
            0 => said!("No dark lines").to_owned(),
            _ => tr!("{n} dark line" | "{n} dark lines" % count),
        });
        if count > 0 {
            let named = found.dips.iter().filter(|dip| dip.name.is_some()).count();
            ui.weak(tr!("{n} named" | "{n} named" % named))
                .on_hover_text(said!(
                    "A dark line has a name only where it stands at a known line and most other \
                     lines of the same family are in the measured curve too."
                ));
            let meaning = said!("Copies places, weights, depths and names as a table.");
            copy_button(ui, said(names::COPY), meaning, || found.table.csv());
        }
    });
    if rows.is_empty() {
        if looks(context.app.document().settings) {
            ui.weak(said!(
                "Nothing narrow enough is missing. Lower the share or allow wider ones."
            ));
        }
        return;
    }
    let columns = [
        Column::numbers("nm", said!("Centroid of the dark line, nm."), 0.8),
        Column::numbers(
            said!("weight"),
            said!("Power that is missing, in the plot's unit × nm."),
            1.0,
        ),
        Column::numbers(
            said!("depth"),
            said!("Share of the background that is missing at its deepest, percent."),
            0.9,
        ),
        Column::words(
            said!("line"),
            said!(
                "Named only where it is safe. A known line without a weight is seen in the curve, \
                 but takes less than the least share: it is no number of the model."
            ),
            1.6,
        ),
    ];
    table(ui, &columns, rows, None, false, context.theme);
}

fn row(app: &App, dip: &DipRow) -> Row {
    let depth = dip.depth.map_or_else(
        || "–".to_owned(),
        |depth| format!("{} %", fixed(100.0 * depth, 1)),
    );
    let mut name = dip.name.clone().unwrap_or_else(|| "–".to_owned());
    if dip.below_zero {
        name = format!("▲ {name}");
    }
    let cells = vec![
        fixed(dip.spike.at_nm, 1),
        short(app.scale_factor() * dip.spike.weight),
        depth,
        name.clone(),
    ];
    Row {
        name: tr!(
            "Dark line at {place} nm, depth {depth}, {name}",
            place = cells[0],
            depth = cells[2],
            name
        ),
        note: if dip.below_zero {
            said!("The dark line takes the model's total below zero.").to_owned()
        } else {
            String::new()
        },
        cells,
        ..Row::default()
    }
}

/// A known line that is seen and is no dip of the model.
fn known_row(line: &DarkLine) -> Row {
    let [at, depth] = [
        fixed(line.at_nm(), 1),
        format!("{} %", fixed(100.0 * line.depth, 1)),
    ];
    Row {
        name: tr!(
            "Known line at {place} nm, depth {depth}, {name}",
            place = at,
            depth,
            name = line.name
        ),
        note: said!("Seen in the curve; no number of the model stands for it.").to_owned(),
        cells: vec![at, "–".to_owned(), depth, line.name.to_owned()],
        ..Row::default()
    }
}
