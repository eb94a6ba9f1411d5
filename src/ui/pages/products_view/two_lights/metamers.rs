//! Metamers: one made for the chosen patch, and those found in the library.

use eframe::egui;
use egui::{Button, RichText, Slider, Ui, vec2};

use super::{super::among, names};
use crate::{
    app::{
        Command, MadeFor, Recipe,
        charts::products::two_lights::{Found, MadeShown},
        products::{
            ROOM_PERCENT,
            two_lights::{NoMetamer, TwoLightsSheet, pairs_table},
        },
        studies::{Pairs, PairsAsk, Stage},
    },
    study::products::{MATCH_DELTA_E, MetamericPair},
    ui::{
        kit::{Choice, Column, Row, Table, copy_button, named},
        pages::{PageContext, progress},
        swatch,
    },
};

/// Found pairs that are seen at a time.
const PAIR_ROWS: usize = 6;

/// A metamer made for the chosen patch.
pub(super) fn made(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &TwoLightsSheet,
    (made, patch): (&Result<MadeShown, NoMetamer>, usize),
    height: f32,
) {
    ui.label(RichText::new("A metamer made").heading());
    ui.weak(format!(
        "A curve that is invisible under {} is added to a surface: the sum looks the same there, \
         and different under other lights.",
        sheet.lights[0]
    ));
    let memory = &mut context.memory.products.two_lights;
    ui.horizontal_wrapped(|ui| {
        let choice = Choice {
            name: names::PATCH,
            meaning: "The patch that is changed; a click on a field chooses it too.",
            width: 130.0 * context.theme.scale,
        };
        let chosen = sheet.names.get(patch).map_or("", String::as_str);
        choice.cut(ui, chosen, |ui| {
            for (i, name) in sheet.names.iter().enumerate() {
                ui.selectable_value(&mut memory.patch, i, name);
            }
        });
        let slider = Slider::new(&mut memory.room_percent, ROOM_PERCENT).suffix(" %");
        let slider = ui.add_enabled(made.is_ok(), slider);
        named(&slider, egui::Role::Slider, names::ROOM);
        slider.on_hover_text(
            "How much of the room is used before the sum leaves 0 to 1: 100 % all the way up the \
             black, -100 % all the way down, 0 % the patch itself.",
        );
        let kept = made
            .as_ref()
            .ok()
            .filter(|shown| shown.made.room_percent != 0);
        let button = ui
            .add_enabled(kept.is_some(), Button::new(names::KEEP))
            .on_hover_text("Puts the made reflectance into the library and opens it.")
            .on_disabled_hover_text("There is nothing made to keep.");
        let document = context.app.document();
        if button.clicked()
            && let (Some(shown), Some(other)) = (kept, &document.products.other_light)
        {
            let recipe = Recipe::Metamer {
                light: document.light.key.clone(),
                other: other.key.clone(),
                patch_set: document.patch_set.clone(),
                patch: shown.made.patch,
                room_percent: shown.made.room_percent,
            };
            let place = MadeFor::Shown;
            context.commands.push(Command::Make { recipe, place });
        }
    });
    let MadeShown {
        made,
        chart,
        swatches,
    } = match made {
        Ok(shown) => shown,
        Err(why) => {
            ui.label(why.words());
            return;
        }
    };
    let scale = context.theme.scale;
    ui.horizontal_wrapped(|ui| {
        for (i, light) in sheet.lights.iter().enumerate() {
            let size = vec2(74.0, 26.0) * scale;
            let name = format!("Patch and metamer under {light}");
            swatch::split(ui, size, &swatches[0][i], &swatches[1][i], &name)
                .on_hover_text(format!("{name}: left the patch, right the metamer."));
            ui.label(format!("ΔE₀₀ {:.2} under {light}", made.delta_e_2000[i]));
            ui.add_space(8.0);
        }
    });
    let size = vec2(ui.available_width(), height);
    context.chart(ui, chart, "metamer made", size);
}

/// Pairs found in the library.
pub(super) fn found(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    found: Option<(&Found, &[Row])>,
    height: f32,
) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("Metamers found").heading());
        copy_button(ui, names::COPY_PAIRS, "", || {
            found.map_or_else(String::new, |(found, _)| {
                pairs_table(&found.lights, &found.pairs).csv()
            })
        });
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("Among");
        let meaning = "Which surfaces are compared, each with each.";
        let everywhere = context.memory.products.two_lights.everywhere;
        context.memory.products.two_lights.everywhere =
            among(ui, context, names::AMONG, meaning, everywhere);
        let job = context.studies.of::<PairsAsk>();
        if job.stage() != Stage::Done {
            progress(ui, job, "The pairs");
        }
    });
    let possible = context.studies.of::<PairsAsk>().stage() != Stage::Impossible;
    let Some((found, rows)) = found.filter(|_| possible) else {
        return;
    };
    let pairs = &found.pairs.metamers.pairs;
    let [first, second] = &found.lights;
    let Some(index) = found.pairs.metamers.index else {
        ui.label(format!(
            "No two of {} surfaces match under {first} (ΔE₀₀ below {MATCH_DELTA_E}) without being \
             the same curve.",
            found.pairs.surfaces.len()
        ));
        return;
    };
    ui.label(format!(
        "{} of {} surfaces match under {first} (ΔE₀₀ below {MATCH_DELTA_E}); metamerism index \
         under {second}: {index:.2}.",
        match pairs.len() {
            1 => "1 pair".to_owned(),
            many => format!("{many} pairs"),
        },
        found.pairs.surfaces.len()
    ))
    .on_hover_text(
        "Metamerism index: mean CIEDE2000 under the second light of all pairs that match under \
         the first. Two curves closer than 0.01 (root mean square) are one surface and no pair.",
    );
    let columns = columns(&found.lights);
    let table = Table {
        chosen: Some(found.chosen),
        ..Table::new(&columns, context.theme)
    };
    let height_of_rows = pairs.len().min(PAIR_ROWS) as f32 * table.row_height(ui);
    let clicked = table.scrolled(
        ui,
        "pairs",
        height_of_rows,
        rows,
        &mut |ui, [row, column], cell| {
            if let 1 | 3 = column {
                let light = column / 2;
                let surfaces = pairs[row].pair;
                let [left, right] = surfaces.map(|i| swatch::colour(found.swatches[i][light].rgb8));
                swatch::paint_split(ui, cell.shrink2(vec2(0.0, 2.0)), left, right);
            }
        },
    );
    if let Some(pair) = clicked {
        context.memory.products.two_lights.pair = pair;
    }
    if let Some(chart) = &found.chart {
        ui.add_space(4.0);
        let size = vec2(ui.available_width(), height);
        context.chart(ui, chart, "metamers found", size);
    }
}

/// Found pairs as rows.
pub(super) fn rows(pairs: &Pairs) -> Vec<Row> {
    let row = |found: &MetamericPair| {
        let [one, other] = found.pair.map(|i| &pairs.surfaces[i]);
        let [first, second] = found.delta_e_2000;
        Row {
            name: format!(
                "Pair: {} and {}, {first:.2} under the first light, {second:.2} under the second",
                one.name, other.name
            ),
            note: format!(
                "{} and {}\nΔE₀₀ {first:.3} under the first light, {second:.3} under the second; \
                 the curves differ by {:.3} (root mean square).\nClick to see both curves.",
                one.key, other.key, found.rms
            ),
            cells: vec![
                format!("{} · {}", one.name, other.name),
                String::new(),
                format!("{first:.2}"),
                String::new(),
                format!("{second:.2}"),
            ],
            ..Row::default()
        }
    };
    pairs.metamers.pairs.iter().map(row).collect()
}

fn columns([first, second]: &[String; 2]) -> [Column; 5] {
    let under = |light: &str| format!("The pair side by side under {light}.");
    let differ =
        |light: &str| format!("CIEDE2000 under {light}; the pairs that part most stand first.");
    [
        Column::words("surfaces", "Click a row to see both curves.", 0.58),
        Column::words("1st light", &under(first), 0.11),
        Column::words("ΔE₀₀", &differ(first), 0.10),
        Column::words("2nd light", &under(second), 0.11),
        Column::words("ΔE₀₀", &differ(second), 0.10),
    ]
}
