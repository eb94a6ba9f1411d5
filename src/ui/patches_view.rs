//! Through reflectances: each patch under the measured light and under the model.

use eframe::egui;
use egui::{Ui, vec2};

use super::{
    kit::{Choice, rolled, seen_choice},
    swatch,
    theme::{self, Theme},
};
use crate::{
    app::{
        App, Command, Library, Lit,
        answers::{judged, set_title},
        chart::elided,
        derived::PatchPair,
        readings::COUNTS,
        under_favourites,
        verdicts::Seen,
    },
    color::Swatch,
    languages::{fixed, with_colon},
};

/// Most patches in one row: the ColorChecker makes two rows.
const PER_ROW: usize = 12;

/// A choice among the sets of reflectances.
pub(super) fn set_choice(ui: &mut Ui, choice: Choice<'_>, app: &App, commands: &mut Vec<Command>) {
    let now = &app.document().patch_set;
    choice.show(ui, set_title(now), |ui| {
        let groups = Library::bundled().all_groups();
        for group in groups.filter(|g| g.items.iter().any(|p| p.kind.is_factor())) {
            let response = ui.selectable_label(*now == group.id, set_title(&group.id));
            if response.on_hover_text(&group.title).clicked() {
                commands.push(Command::PatchSet(group.id.clone()));
            }
        }
    });
}

/// The row above the patches: the set, what lies outside the screen's colours, how they are seen.
/// `whole`: as measured alone, without a model beside it.
pub(super) fn head(
    ui: &mut Ui,
    app: &App,
    (theme, whole): (Theme, bool),
    commands: &mut Vec<Command>,
) {
    if !app.document().is_about_light() {
        let words = tr!(
            "{surface} under six lights",
            surface = app.document().subject_entry().name()
        );
        ui.add(egui::Label::new(words).truncate());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            seen_choice(ui, app, (said!("How surfaces are seen"), 220.0), commands);
        });
        return;
    }
    let choice = Choice {
        name: said!("Set of surfaces"),
        meaning: said!("The surfaces that the light falls on."),
        width: 140.0,
    };
    set_choice(ui, choice, app, commands);
    let small = |words: &str| {
        egui::RichText::new(words.to_owned())
            .small()
            .color(theme.faint)
    };
    let halves = match &app.document().second {
        Some(second) => format!("{} | {}", app.document().light.name(), second.name()),
        None if whole => String::new(),
        None => said!("measured | model").to_owned(),
    };
    if ui.available_width() > 420.0 {
        let rest = ui.available_width() - 240.0;
        let halves = elided(&halves, (rest / 6.5) as usize);
        ui.label(small(&halves));
    }
    if let Some(fields) = Fields::of(app, whole) {
        let off = |field: &&Field<'_>| !field.halves.iter().all(|half| half.in_gamut);
        let count = fields.items.iter().filter(off).count();
        if count > 0 && ui.available_width() > 330.0 {
            ui.label(small(&tr!(
                "◥ {n} outside the screen's colours" | "◥ {n} outside the screen's colours" % count
            )));
        }
    }
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        seen_choice(ui, app, (said!("How surfaces are seen"), 220.0), commands);
    });
}

/// The patches themselves, on a ground that is equal to none of them.
pub(super) fn patches(
    ui: &mut Ui,
    app: &App,
    (theme, whole): (Theme, bool),
    commands: &mut Vec<Command>,
) {
    let Some(fields) = Fields::of(app, whole) else {
        if app.document().is_about_light() {
            ui.add_space(6.0);
            ui.weak(match judged(app) {
                Err(COUNTS) => said!("Counts are no light that surfaces could be seen under."),
                _ => said!("There is no visible light in this range: surfaces would be black."),
            });
        } else {
            under_lights(ui, app, theme);
        }
        return;
    };
    let room = ui.available_rect_before_wrap();
    ui.painter().rect_filled(room, 4.0, theme.swatch_ground);
    let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(room.shrink(8.0)));
    rolled(&mut inside, |ui| grid(ui, app, &fields, theme, commands));
}

/// The surface that is looked at, under six lights.
fn under_lights(ui: &mut Ui, app: &App, theme: Theme) {
    let shown = under_favourites(app);
    let room = ui.available_rect_before_wrap();
    ui.painter().rect_filled(room, 4.0, theme.swatch_ground);
    let inside = room.shrink(8.0);
    let row = ui.text_style_height(&egui::TextStyle::Small);
    let count = shown.len().max(1) as f32;
    let width = (inside.width() - 8.0 * (count - 1.0)) / count;
    let ink = theme::grey(if theme.dark { 240 } else { 16 });
    let mut font = egui::TextStyle::Small.resolve(ui.style());
    let painter = ui.painter().clone();
    let lay = |words: &str, font: &egui::FontId| {
        painter.layout_no_wrap(words.to_owned(), font.clone(), ink)
    };
    let widths = shown.iter().map(|(light, _)| lay(light, &font).size().x);
    let widest = widths.fold(width, f32::max);
    // All in one size, in which the longest name stands below its field.
    font.size *= (width / widest).max(0.1);
    for (k, (light, colour)) in shown.iter().enumerate() {
        let left = inside.left() + k as f32 * (width + 8.0);
        let size = vec2(width, (inside.height() - row - 2.0).max(1.0));
        let field = egui::Rect::from_min_size(egui::pos2(left, inside.top()), size);
        let mut child = ui.new_child(egui::UiBuilder::new().max_rect(field));
        let name = tr!("Under {light}: {hex}", light, hex = colour.hex());
        swatch::split(&mut child, size, colour, colour, &name).on_hover_text(name.as_str());
        let at = egui::pos2(field.center().x, inside.bottom());
        let words = lay(light, &font);
        let corner = at - vec2(words.size().x / 2.0, words.size().y);
        let painter = ui.painter().with_clip_rect(field.with_max_y(room.bottom()));
        painter.galley(corner, words, ink);
    }
}

/// A surface of which two halves are seen: measured and by the model, or under two lights.
struct Field<'a> {
    name: &'a str,
    /// Difference of its halves; none where both are one.
    delta_e_2000: Option<f64>,
    halves: [&'a Swatch; 2],
}

struct Fields<'a> {
    items: Vec<Field<'a>>,
    /// What the halves are under.
    under: [String; 2],
}

impl<'a> Fields<'a> {
    /// `None` where no light falls on surfaces.
    fn of(app: &'a App, whole: bool) -> Option<Self> {
        let patches = app.derived().patches.as_ref();
        let patches = patches.filter(|_| judged(app) != Err(COUNTS))?;
        if let Some((second, lit)) = app.document().second.as_ref().zip(app.surfaces_beside()) {
            let field = |lit: &'a Lit| Field {
                name: &lit.name,
                delta_e_2000: Some(lit.delta_e_2000),
                halves: lit.swatches.each_ref(),
            };
            return Some(Self {
                items: lit.iter().map(field).collect(),
                under: [&app.document().light, second].map(|light| light.name().to_owned()),
            });
        }
        let field = |patch: &'a PatchPair| Field {
            name: &patch.name,
            delta_e_2000: (!whole).then_some(patch.delta_e_2000),
            halves: match whole {
                true => [&patch.exact_swatch; 2],
                false => [&patch.exact_swatch, &patch.model_swatch],
            },
        };
        Some(Self {
            items: patches.items.iter().map(field).collect(),
            under: [said!("the measured light"), said!("the model")].map(str::to_owned),
        })
    }

    /// The place of the surface whose halves differ most.
    fn worst(&self) -> Option<usize> {
        let all = self.items.iter().enumerate();
        let all = all.filter_map(|(i, field)| Some((i, field.delta_e_2000?)));
        all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    }
}

fn grid(ui: &mut Ui, app: &App, fields: &Fields<'_>, theme: Theme, commands: &mut Vec<Command>) {
    let gap = 8.0;
    ui.spacing_mut().item_spacing = vec2(gap, gap);
    let room = ui.available_size();
    let count = fields.items.len();
    let worst = fields.worst();
    let [left, right] = &fields.under;
    // A low field has one row of all 24, a usual one two; more patches scroll.
    let in_row = if room.y < 70.0 { 2 * PER_ROW } else { PER_ROW };
    let rows = count.div_ceil(in_row).max(1);
    let width = (room.x - gap * (in_row - 1) as f32) / in_row as f32;
    let shown = rows.min(2) as f32;
    let height = ((room.y - gap * (shown - 1.0)) / shown).clamp(18.0, 90.0 * theme.scale);
    let selected = app.document().patch;
    for (row, chunk) in fields.items.chunks(in_row).enumerate() {
        ui.horizontal(|ui| {
            for (column, patch) in chunk.iter().enumerate() {
                let index = row * in_row + column;
                let [first, second] = patch.halves;
                let (off, called) = (patch.delta_e_2000, app.document().patch_called(patch.name));
                let name = match off {
                    Some(off) => with_colon(called, format!("ΔE₀₀ {}", fixed(off, 3))),
                    None => with_colon(called, first.hex()),
                };
                let response = swatch::split(ui, vec2(width, height), first, second, &name);
                if off.is_some() {
                    swatch::ticks(ui, response.rect, 5.0 * theme.scale);
                }
                // The worst is marked only where it can be seen.
                let is_seen = off.is_some_and(|off| Seen::of(off) != Seen::Hardly);
                let is_worst = Some(index) == worst && is_seen;
                if is_worst {
                    swatch::dot(ui, response.rect, theme.scale);
                }
                if selected == Some(index) {
                    swatch::ring(ui, response.rect, theme.scale);
                }
                if response.clicked() {
                    let patch = (selected != Some(index)).then_some(index);
                    commands.push(Command::Patch(patch));
                }
                let Some(off) = off else {
                    response.on_hover_text(name.as_str());
                    continue;
                };
                let surface = match is_worst {
                    true => tr!("{surface} (the worst)", surface = called),
                    false => called.to_owned(),
                };
                response.on_hover_text(tr!(
                    "{surface}: ΔE₀₀ {difference}, {seen}\nLeft under {left} {left_hex}, right \
                     under {right} {right_hex}.\nClick to see the light off it in the plot.",
                    surface,
                    difference = fixed(off, 4),
                    seen = Seen::of(off).seen(),
                    left,
                    left_hex = first.hex(),
                    right,
                    right_hex = second.hex()
                ));
            }
        });
    }
}
