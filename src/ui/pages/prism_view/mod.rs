//! The pages "Prism" and "Rainbow": a bench and a sky that the light is sent through.

mod bench;
mod controls;
mod drop;
pub(super) mod model;
mod presented;
mod sky;
mod strips;
mod substance;

pub(super) use substance::substance;

use crate::ui::kit::slide;
use bench::Moved;
use eframe::egui;
use egui::{RichText, Ui, Vec2, vec2};

use super::PageContext;
use crate::{
    app::{
        Memo,
        dispersion::{PrismShown, RainbowShown, Sent, sky},
        pages::{PrismMemory, RainbowMemory, STOPS},
    },
    languages::{fixed, said},
    optics::Sky,
    ui::kit::{
        self, Column, Form, GROUP, Row, Table, copy_button, fold, form, headline, with_panel,
    },
};

/// What people and tests call the controls.
pub(super) mod names {
    pub(crate) const GLASS: &str = later!("Glass");
    pub(crate) const APEX: &str = later!("Apex angle");
    pub(crate) const MINIMUM: &str = later!("least deviation");
    pub(crate) const INCIDENCE: &str = later!("Light meets it at");
    pub(crate) const GREEN: &str = later!("for");
    pub(crate) const SLIT: &str = later!("Slit");
    pub(crate) const SCREEN: &str = later!("Screen");
    pub(crate) const IMPACT: &str = later!("Rays meet it at");
    pub(crate) const BOW: &str = later!("Drawn");
    pub(crate) const EXPOSURE: &str = later!("Exposure");
    pub(crate) const BESIDE: &str = later!("Beside it");
    pub(crate) const DISC: &str = later!("as wide as the sun");
    pub(crate) const COPY: &str = later!("Copy lines as CSV");
}

/// Height of a fold that is shut, with the notes above it, points.
const FOLDED: f32 = 44.0;

/// Least height of a drawing, points.
const LEAST: f32 = 190.0;

/// The pages and what they keep from frame to frame.
#[derive(Default)]
pub(super) struct PrismView {
    prism: Memo<(u64, PrismMemory), PrismShown>,
    sky: Memo<(), Sky>,
    rainbow: Memo<(u64, RainbowMemory), RainbowShown>,
    picture: sky::Painted,
    /// Heights of what stands below the drawings while they are presented, points.
    below: [Option<f32>; 2],
}

/// How bright the picture is.
pub(super) fn exposure(form: &mut Form<'_>, stops: &mut f64) {
    let of = slide(stops, STOPS.range())
        .step_by(0.1)
        .fixed_decimals(1)
        .suffix(format!(" {}", said!("stops")));
    let meaning = said!(
        "Brightness of the picture; each stop doubles it. A double click in the number's box lets \
         you type it."
    );
    form.slider((said(names::EXPOSURE), meaning), of);
}

/// What must be said beside a picture, in small type.
pub(super) fn notes<'a>(ui: &mut Ui, notes: impl Iterator<Item = &'a str>) {
    let words: Vec<&str> = notes.filter(|words| !words.is_empty()).collect();
    if !words.is_empty() {
        let text = RichText::new(words.join(" ")).small().weak();
        ui.add(egui::Label::new(text).wrap());
    }
}

/// A table of the lines with the button that copies it.
fn lines(
    ui: &mut Ui,
    context: &PageContext<'_>,
    (columns, rows, notes): (&[Column], &[Vec<String>], &[String]),
    copy: impl FnOnce() -> String,
) {
    if rows.is_empty() {
        return;
    }
    let notes = notes
        .iter()
        .cloned()
        .chain(std::iter::repeat(String::new()));
    let rows: Vec<Row> = rows
        .iter()
        .zip(notes)
        .map(|(cells, note)| Row {
            note,
            ..Row::of(cells.clone())
        })
        .collect();
    Table::dense(columns, context.theme).show(ui, &rows, &mut |_, _, _| {});
    ui.horizontal(|ui| {
        copy_button(
            ui,
            said(names::COPY),
            said!("The lines with every figure."),
            copy,
        );
    });
}

impl PrismView {
    /// Draws the prism's page.
    pub(super) fn prism(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let memory = context.pages.prism.clone();
        let key = (context.app.revision(), memory);
        let app = context.app;
        let shown = &*self
            .prism
            .get(key, |(_, memory)| PrismShown::of(app, memory));
        headline(ui, context.theme, &shown.sentence);
        ui.add_space(GROUP);
        let scale = context.theme.scale;
        let picture = |ui: &mut Ui, context: &mut PageContext<'_>, room: Vec2| {
            let tells = |x_mm: f64| told(shown, x_mm);
            let axis = axis_of(shown, &tells);
            // What the strips leave, and no less than a drawing needs.
            let below = strips::height(&shown.strips, &axis, context.theme) + FOLDED * scale;
            let height = (room.y - below).min(0.7 * room.x).max(LEAST);
            ui.scope(|ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                drawn(ui, context, (shown, &axis), vec2(room.x, height));
                strips::show(ui, &shown.strips, &axis, context.theme);
            });
            said_of(ui, shown, context.pages.prism.sent);
            if !shown.rows.is_empty() {
                fold(ui, "lines", said!("Every line in figures"), |ui| {
                    let columns = prism_columns();
                    let table = (&columns[..], &shown.rows[..], &shown.told[..]);
                    lines(ui, context, table, || shown.csv.clone());
                });
            }
        };
        with_panel(ui, context, ("prism", scale), picture, controls::prism);
    }

    /// Draws the rainbow's page.
    pub(super) fn rainbow(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let key = (context.app.revision(), context.pages.rainbow);
        let app = context.app;
        let sky = &*self.sky.get((), |()| sky());
        let shown = &*self
            .rainbow
            .get(key, |(_, memory)| RainbowShown::of(app, memory, sky));
        headline(ui, context.theme, &shown.sentence);
        ui.add_space(GROUP);
        let (theme, painted) = (context.theme, &mut self.picture);
        let picture = |ui: &mut Ui, context: &mut PageContext<'_>, room: Vec2| {
            let axis = strips::Axis {
                ends: shown.ends_deg,
                label: said!("° from the point opposite the sun"),
                nm: &[],
                tells: &|angle| {
                    tr!(
                        "{angle}° from the point opposite the sun",
                        angle = fixed(angle, 2)
                    )
                },
            };
            let below = strips::height(&shown.strips, &axis, theme) + FOLDED * theme.scale;
            let high = (room.y - below).min(0.6 * room.x).max(LEAST);
            if let Some(strip) = shown.strips.first() {
                let size = vec2(room.x, high);
                let colours = (&*strip.colours.rgb, shown.ends_deg);
                painted.show(ui, colours, (size, shown.first_deg), theme);
            }
            strips::show(ui, &shown.strips, &axis, theme);
            let said = shown.notes.iter().map(String::as_str);
            let always = said!(
                "By rays alone: no supernumerary bows, as in drops above 0.5 mm. The ground, the \
                 sky behind and the person are drawn, not computed."
            );
            notes(ui, said.chain([always]));
            if !shown.table.is_empty() {
                fold(ui, "lines", said!("Every line in figures"), |ui| {
                    let columns = kit::columns(&shown.table, &[2.2, 1.0, 1.0, 1.0, 1.0, 1.0]);
                    let rows: Vec<Vec<String>> = shown.table.shown().collect();
                    lines(ui, context, (&columns, &rows, &[]), || shown.table.csv());
                });
            }
        };
        let panel = |ui: &mut Ui, context: &mut PageContext<'_>| {
            rainbow_controls(ui, context, shown);
        };
        with_panel(ui, context, ("rainbow", theme.scale), picture, panel);
    }
}

/// A drop with its rays, the sun and the light.
fn rainbow_controls(ui: &mut Ui, context: &mut PageContext<'_>, shown: &RainbowShown) {
    let theme = context.theme;
    if let Some(drawing) = &shown.drop {
        ui.strong(said!("One of the drops"));
        let wide = ui.available_width();
        let moved = drop::show(ui, drawing, vec2(wide, 0.72 * wide), theme);
        let impact = &mut context.pages.rainbow.impact;
        *impact = moved.map_or(*impact, |to| {
            to.clamp(
                *RainbowMemory::IMPACT.reach.range().start(),
                *RainbowMemory::IMPACT.reach.range().end(),
            )
        });
        notes(ui, [drawing.words.as_str()].into_iter());
        ui.add_space(GROUP);
    }
    form(ui, "rainbow", |form| {
        let memory = &mut context.pages.rainbow;
        controls::drop(form, memory);
        form.rest(|ui| {
            ui.checkbox(&mut memory.disc, said(names::DISC))
                .on_hover_text(said!(
                    "The sun is half a degree wide and blurs every bow by as much; without it each \
                     line is as sharp as a drop makes it."
                ))
        });
        controls::beside(form, &mut memory.beside);
        exposure(form, &mut memory.stops);
    });
    ui.add_space(GROUP);
    form(ui, "rainbow's light", |form| {
        model::sent(form, &mut context.pages.rainbow.sent);
        let sent = context.pages.rainbow.sent;
        model::knobs(form, context, sent);
    });
}

/// The bench; a hand turns the prism and moves its handles.
fn drawn(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (shown, axis): (&PrismShown, &strips::Axis<'_>),
    size: Vec2,
) {
    let share = |x_mm: f64| axis.share(x_mm);
    let looks: (&dyn Fn(f64) -> f32, _) = (&share, context.theme);
    let moved = bench::show(ui, shown.drawing.as_ref(), size, looks);
    let memory = &mut context.pages.prism;
    match moved {
        None => {}
        Some(Moved::Turned(by)) => memory.turn(shown.incidence_deg, by),
        Some(Moved::Set(handle, to)) => memory.set(handle, to),
    }
}

/// What is told of a place on the screen.
fn told(shown: &PrismShown, x_mm: f64) -> String {
    shown.told(x_mm).unwrap_or_else(|| {
        tr!(
            "{place} mm: no light from 380 to 780 nm lands there.",
            place = fixed(x_mm, 2)
        )
    })
}

fn axis_of<'a>(shown: &'a PrismShown, tells: &'a dyn Fn(f64) -> String) -> strips::Axis<'a> {
    strips::Axis {
        ends: shown.ends_mm,
        label: said!("mm on the screen"),
        nm: &shown.scale,
        tells,
    }
}

/// What must be said of what lands on the screen.
fn said_of(ui: &mut Ui, shown: &PrismShown, sent: Sent) {
    let words = shown.strips.first();
    let words = words.map(|strip| strip.colours.words(sent));
    let said = shown.notes.iter().map(String::as_str);
    notes(ui, said.chain(words.as_deref()));
}

/// The columns of the table of the lines.
fn prism_columns() -> [Column; 8] {
    [
        Column::words(
            said!("line"),
            said!("The element, by all lines together."),
            1.7,
        ),
        Column::numbers("nm", said!("Wavelength in air."), 1.0),
        Column::numbers("n", said!("Index of refraction of the glass there."), 1.0),
        Column::numbers(
            said!("turned °"),
            said!("Deviation: how far the ray is turned."),
            1.0,
        ),
        Column::numbers(
            said!("place mm"),
            said!("Where it lands on the screen."),
            1.0,
        ),
        Column::numbers(said!("width mm"), said!("Width of the slit's image."), 1.0),
        Column::numbers(
            said!("passed %"),
            said!("Share of its light that both faces let through."),
            1.0,
        ),
        Column::numbers(
            said!("apart nm"),
            said!(
                "Two lines nearer than this run together, and what limits it: the slit, or the \
                 length of the glass."
            ),
            1.4,
        ),
    ]
}
