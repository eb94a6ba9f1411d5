//! The part "Two lights": patches under two lights, metamers found and made.

mod metamers;
mod patches;

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::change;
use crate::{
    app::{
        ByAddress, Memo,
        chart::Chart,
        charts::products::two_lights::{Found, MadeShown, two_lights_chart},
        headlines,
        products::two_lights::{NoMetamer, TwoLightsSheet, swatches},
        studies::{Pairs, PairsAsk},
    },
    color::{Adaptation, Swatch},
    study::products::TwoLights,
    ui::{
        kit::{Choice, Chooser, Row, adapt_box, bounded, headline, lights, scrolled, two_columns},
        pages::PageContext,
        patches_view::set_choice,
    },
};

/// From this width on the part has two columns, points.
const WIDE: f32 = 940.0;

/// What buttons and lists are called.
pub mod names {
    pub const OTHER: &str = "Second light";
    pub const SET: &str = "Patch set";
    pub const AMONG: &str = "Pairs among";
    pub const COPY_PATCHES: &str = "Copy the patches as CSV";
    pub const COPY_PAIRS: &str = "Copy the pairs as CSV";
    pub const PATCH: &str = "Patch";
    pub const ROOM: &str = "Part of the room";
    pub const KEEP: &str = "Keep as my own spectrum";
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct TwoLightsView {
    sheet: Memo<u64, Option<TwoLightsSheet>>,
    shown: Memo<u64, Shown>,
    made: Memo<(u64, usize, i32), Result<MadeShown, NoMetamer>>,
    found: Memo<(ByAddress<Pairs>, Adaptation, usize), Found>,
    rows: Memo<ByAddress<Pairs>, Vec<Row>>,
}

/// The patches in colours of the screen, and the chart of both lights.
struct Shown {
    exact: Vec<[Swatch; 2]>,
    model: Vec<[Swatch; 2]>,
    chart: Chart,
}

impl TwoLightsView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let (revision, adaptation) = (app.revision(), context.app.document().view.adaptation());
        let Some(sheet) = &*self.sheet.get(revision, |_| TwoLightsSheet::of(app)) else {
            let words = "Choose a second light to see the patches under both.";
            headline(ui, context.theme, words);
            head(ui, context);
            return;
        };
        headline(ui, context.theme, headlines::two_lights(sheet));
        head(ui, context);
        if let Some(ask) = &pairs_ask(context) {
            context.put(ask);
        }
        let shown = &*self.shown.get(revision, |_| {
            let of_all = |both: &Option<TwoLights>| {
                let both = both.as_ref();
                both.map_or_else(Vec::new, |both| swatches(both, adaptation))
            };
            Shown {
                exact: of_all(&sheet.exact),
                model: of_all(&sheet.model),
                chart: two_lights_chart(app, sheet),
            }
        });
        let memory = context.pages.two_lights;
        let patch = memory.patch.min(sheet.names.len().saturating_sub(1));
        let room_percent = memory.room_percent;
        let made = (revision, patch, room_percent);
        let made = &*self.made.get(made, |_| {
            MadeShown::of(app, sheet, (patch, room_percent), adaptation)
        });
        let found = context.studies.of::<PairsAsk>().answer();
        let found = found.map(|(ask, pairs)| {
            let last = pairs.metamers.pairs.len().saturating_sub(1);
            let chosen = memory.pair.min(last);
            let of = ByAddress(pairs.clone());
            let key = (of.clone(), adaptation, chosen);
            let found = self
                .found
                .get(key, |_| Found::of(app, ask, pairs, chosen, adaptation));
            let rows = self.rows.get(of, |_| metamers::rows(pairs));
            (&*found, rows.as_slice())
        });
        let room = ui.available_size();
        let scale = context.theme.scale;
        scrolled(ui, "two lights", |ui| {
            if ui.available_width() >= WIDE * scale {
                let chart = (0.5 * (room.y - 400.0 * scale)).clamp(180.0 * scale, 400.0 * scale);
                let lights = bounded(room.y - 250.0 * scale, chart, 520.0 * scale);
                let left = |ui: &mut Ui, context: &mut PageContext<'_>| {
                    patches::show(ui, context, sheet, shown);
                    ui.add_space(6.0);
                    spectra(ui, context, shown, lights);
                };
                two_columns(ui, context, left, |ui, context| {
                    metamers::made(ui, context, sheet, (made, patch), chart);
                    ui.add_space(6.0);
                    metamers::found(ui, context, found, chart);
                });
            } else {
                let chart = (0.34 * room.y).clamp(170.0 * scale, 240.0 * scale);
                patches::show(ui, context, sheet, shown);
                ui.add_space(6.0);
                spectra(ui, context, shown, chart);
                ui.add_space(6.0);
                metamers::made(ui, context, sheet, (made, patch), chart);
                ui.add_space(6.0);
                metamers::found(ui, context, found, chart);
            }
        });
    }
}

fn spectra(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Shown, height: f32) {
    let size = vec2(ui.available_width(), height);
    context.chart(ui, &shown.chart, "two lights", size);
}

fn pairs_ask(context: &PageContext<'_>) -> Option<PairsAsk> {
    let document = context.app.document();
    let other = document.products.other_light.clone()?;
    let everywhere = context.pages.two_lights.everywhere;
    Some(PairsAsk {
        lights: [ByAddress(document.light.clone()), ByAddress(other)],
        band: document.settings.band,
        observer: document.settings.observer,
        group: (!everywhere).then(|| document.patch_set.clone()),
    })
}

/// The lights, the patch set and how fields are shown.
fn head(ui: &mut Ui, context: &mut PageContext<'_>) {
    let document = context.app.document();
    ui.horizontal_wrapped(|ui| {
        ui.label("Under");
        ui.add(egui::Label::new(RichText::new(document.light.name()).strong()).truncate())
            .on_hover_text("The document's light: choose another in the library.");
        ui.label("and");
        let other = document.products.other_light.as_ref();
        let chosen = Chooser {
            name: names::OTHER,
            meaning: "The light that the patches are seen under on the right of each field.",
            says: other.map_or("choose a light", |light| light.name()),
            offers: lights,
            width: 150.0 * context.theme.scale,
        }
        .show(ui, context.app);
        if let Some(light) = chosen {
            change(context, |products| products.other_light = Some(light));
        }
        ui.separator();
        let choice = Choice {
            name: names::SET,
            meaning: "Whose reflectances are seen under both lights.",
            width: 128.0 * context.theme.scale,
        };
        set_choice(ui, choice, context.app, context.commands);
        let meaning = "Shows each half as an eye adapted to its light sees it (Bradford). It \
                       changes the colours on screen, not the figures.";
        adapt_box(ui, context.app, ("Adapt", meaning), context.commands);
    });
}
