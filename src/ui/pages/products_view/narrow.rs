//! The part "Narrow filters" of the page "Products": a band-pass moved over the light.

use std::sync::Arc;

use eframe::egui;
use egui::{CursorIcon, DragValue, RichText, ScrollArea, Sense, Slider, Ui, Vec2, pos2, vec2};

use super::{forming::head, picker::Picker};
use crate::{
    app::{
        App, Entry,
        chart::{self, Chart},
        charts::products::narrow::{Behind, Figures, Filter, FilterRow, WAY_MEANINGS, WAYS},
        products::memory::{NarrowMemory, PASS_WIDTHS_NM},
        studies::paper::{delta_e, figure, percent},
    },
    color::Swatch,
    io::many::numbers,
    spectrum::{Band, Kind},
    study::products::NarrowPoint,
    ui::{
        chart_view::{ChartResponse, ChartView},
        model_view::named,
        pages::{
            PageContext,
            rows::{Column, Row, table},
        },
        swatch,
    },
};

/// From this width on the two charts stand side by side, points.
const WIDE: f32 = 1040.0;

/// How near the pointer must be to an edge of the band-pass to take it, points.
const REACH: f32 = 7.0;

/// What people and tests call the controls.
pub mod names {
    /// The centre.
    pub const CENTRE: &str = "Centre";
    /// The full width.
    pub const WIDTH: &str = "Width";
    /// The list of measured filters.
    pub const FILTER: &str = "Filter";
    /// Back to the Gaussian.
    pub const GAUSSIAN: &str = "Gaussian";
    /// Copies the filters.
    pub const COPY: &str = "Copy filters as CSV";
    /// Errors of colour.
    pub const COLOUR: &str = "ΔE00";
    /// Errors of luminance.
    pub const LUMINANCE: &str = "luminance";
}

/// What of the band-pass is held.
#[derive(Clone, Copy, PartialEq)]
enum Grip {
    /// All of it, by a place this many nm right of its centre.
    Whole(f64),
    /// One of its edges.
    Edge,
}

/// What both charts are built from.
#[derive(Clone, PartialEq)]
struct Of {
    revision: u64,
    memory: NarrowMemory,
    theme: chart::Theme,
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct NarrowView {
    behind: Option<(u64, Behind, Vec<FilterRow>)>,
    curve: Option<((u64, f64), Vec<NarrowPoint>)>,
    charts: Option<(Of, [Chart; 2])>,
    grip: Option<Grip>,
}

impl NarrowView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, revision) = (context.app, context.app.revision());
        if self.behind.as_ref().is_none_or(|(of, ..)| *of != revision) {
            let behind = Behind::of(app);
            let table = behind.table(app);
            self.behind = Some((revision, behind, table));
        }
        let Some((_, behind, rows)) = &self.behind else {
            return;
        };
        controls(ui, context, behind.band);
        let memory = context.memory.products.narrow.clone();
        let filter = filter_of(app, &memory, behind.band);
        let of = (revision, memory.width_nm);
        if self.curve.as_ref().is_none_or(|(known, _)| *known != of) {
            self.curve = Some((of, behind.curve(memory.width_nm)));
        }
        let Some((_, curve)) = &self.curve else {
            return;
        };
        let of = Of {
            revision,
            memory: memory.clone(),
            theme: context.chart_theme(),
        };
        if self.charts.as_ref().is_none_or(|(known, _)| *known != of) {
            let marked = match &filter {
                Filter::Gaussian { centre_nm, .. } => Some(*centre_nm),
                Filter::Real(_) => None,
            };
            let charts = [
                behind.light_chart(app, &filter, of.theme),
                behind.error_chart(
                    app,
                    curve,
                    memory.luminance,
                    memory.width_nm,
                    marked,
                    of.theme,
                ),
            ];
            self.charts = Some((of, charts));
        }
        let Some((_, charts)) = &self.charts else {
            return;
        };
        let figures = behind.figures(&filter);
        let room = ui.available_size();
        let scale = context.theme.scale;
        let grip = &mut self.grip;
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let width = ui.available_width() - 8.0;
            ui.set_max_width(width);
            if width >= WIDE * scale {
                let height = (0.52 * room.y).max(260.0 * scale);
                ui.columns(2, |columns| {
                    let size = vec2(columns[0].available_width(), height);
                    light(
                        &mut columns[0],
                        context,
                        behind.band,
                        &charts[0],
                        size,
                        grip,
                    );
                    errors(&mut columns[1], context, behind.band, &charts[1], size);
                });
                fields(ui, context, behind, &figures, &filter);
            } else {
                let height = (0.37 * room.y).clamp(210.0 * scale, 380.0 * scale);
                let size = vec2(width, height);
                light(ui, context, behind.band, &charts[0], size, grip);
                fields(ui, context, behind, &figures, &filter);
                errors(ui, context, behind.band, &charts[1], size);
            }
            filters(ui, context, behind, rows);
        });
    }
}

/// What stands over the light: a measured filter while it is there, else the Gaussian, its centre
/// inside the band.
fn filter_of(app: &App, memory: &NarrowMemory, band: Band) -> Filter {
    let entry = memory.filter.as_ref().and_then(|key| app.entry(key));
    match entry.filter(|entry| entry.kind().is_factor()) {
        Some(entry) => Filter::Real(entry),
        None => Filter::Gaussian {
            centre_nm: memory.centre_nm.clamp(band.min_nm(), band.max_nm()),
            width_nm: memory.width_nm,
        },
    }
}

/// Centre, width, and a measured filter in their place.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>, band: Band) {
    let app = context.app;
    let memory = &mut context.memory.products.narrow;
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(names::CENTRE);
        let mut centre = memory.centre_nm.clamp(band.min_nm(), band.max_nm());
        let slider = Slider::new(&mut centre, band.min_nm()..=band.max_nm())
            .fixed_decimals(1)
            .suffix(" nm");
        let response = ui.add(slider).labelled_by(label.id).on_hover_text(
            "Centre of the Gaussian band-pass, nm. It can be dragged in the chart too.",
        );
        if response.changed() {
            memory.centre_nm = centre;
            memory.filter = None;
        }
        let label = ui.label(names::WIDTH);
        let width = DragValue::new(&mut memory.width_nm)
            .speed(0.1)
            .range(PASS_WIDTHS_NM)
            .fixed_decimals(1)
            .suffix(" nm");
        let response = ui.add(width).labelled_by(label.id).on_hover_text(format!(
            "Full width of the band-pass at half its maximum, {} to {} nm. Its edges can be \
             dragged in the chart too.",
            PASS_WIDTHS_NM.start(),
            PASS_WIDTHS_NM.end()
        ));
        if response.changed() {
            memory.filter = None;
        }
        ui.separator();
        let chosen = memory.filter.as_ref().and_then(|key| app.entry(key));
        if ui
            .selectable_label(chosen.is_none(), names::GAUSSIAN)
            .on_hover_text("The Gaussian band-pass of this centre and width.")
            .clicked()
        {
            memory.filter = None;
        }
        let says = chosen.as_ref().map_or("or a measured filter", |e| e.name());
        let picker = Picker {
            name: names::FILTER,
            meaning: "A measured filter or glass in the Gaussian's place: shipped or your own.",
            says,
            offers: transmittances,
            width: 150.0 * context.theme.scale,
        };
        if let Some(entry) = picker.show(ui, app) {
            memory.filter = Some(entry.key.clone());
        }
    });
}

fn transmittances(entry: &Entry) -> bool {
    entry.kind() == Kind::Transmittance
}

/// The light with the filter over it, which can be dragged.
fn light(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    band: Band,
    chart: &Chart,
    size: Vec2,
    grip: &mut Option<Grip>,
) {
    let shown = ChartView::held(ui, chart, "narrow light", size, context.theme);
    let memory = &mut context.memory.products.narrow;
    drag(ui, &shown, memory, band, grip);
    context.wishes.extend(shown.wish);
}

/// Moves the band-pass, or makes it wider or narrower.
fn drag(
    ui: &Ui,
    shown: &ChartResponse,
    memory: &mut NarrowMemory,
    band: Band,
    grip: &mut Option<Grip>,
) {
    let centre = memory.centre_nm.clamp(band.min_nm(), band.max_nm());
    let at_x = |nm: f64| shown.transform.position_from_point_x(nm);
    let nm_at = |x: f32| shown.transform.value_from_position(pos2(x, 0.0)).x;
    let half = 0.5 * memory.width_nm;
    // Over an edge, over the band-pass, or elsewhere: there the band-pass comes to the pointer.
    let take = |x: f32| {
        let off = |nm: f64| (at_x(nm) - x).abs();
        if memory.filter.is_some() {
            Grip::Whole(0.0)
        } else if off(centre - half).min(off(centre + half)) <= REACH && off(centre) > REACH / 2.0 {
            Grip::Edge
        } else if (nm_at(x) - centre).abs() < half {
            Grip::Whole(nm_at(x) - centre)
        } else {
            Grip::Whole(0.0)
        }
    };
    if shown.dragged.is_none() {
        *grip = None;
        if let Some(at) = shown.response.hover_pos() {
            ui.ctx().set_cursor_icon(match take(at.x) {
                Grip::Edge => CursorIcon::ResizeHorizontal,
                Grip::Whole(_) => CursorIcon::Grab,
            });
        }
    }
    let clicked = shown
        .response
        .clicked()
        .then(|| shown.response.interact_pointer_pos());
    if let Some(at) = clicked.flatten() {
        memory.centre_nm = inside(nm_at(at.x), band);
        memory.filter = None;
        return;
    }
    let Some([nm, _]) = shown.dragged else {
        return;
    };
    let begun = ui.input(|input| input.pointer.press_origin());
    let held = *grip.get_or_insert_with(|| begun.map_or(Grip::Whole(0.0), |at| take(at.x)));
    memory.filter = None;
    match held {
        Grip::Whole(off) => memory.centre_nm = inside(nm - off, band),
        Grip::Edge => {
            let width = 2.0 * (nm - centre).abs();
            memory.width_nm = width.clamp(*PASS_WIDTHS_NM.start(), *PASS_WIDTHS_NM.end());
        }
    }
}

/// A place of the band, in tenths of a nm.
fn inside(nm: f64, band: Band) -> f64 {
    ((10.0 * nm).round() / 10.0).clamp(band.min_nm(), band.max_nm())
}

/// Errors against the centre; a click or a drag takes the band-pass there.
fn errors(ui: &mut Ui, context: &mut PageContext<'_>, band: Band, chart: &Chart, size: Vec2) {
    if chart.y_range.is_none() {
        return;
    }
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    ui.horizontal_wrapped(|ui| {
        let memory = &mut context.memory.products.narrow;
        ui.label("Error of");
        ui.selectable_value(&mut memory.luminance, false, names::COLOUR)
            .on_hover_text(
                "CIEDE2000, what is below 0.1 at the foot of the axis; both sides brightened so that the exact light behind the filter has \
                 half the whole light's Y, by at most fifty times.",
            );
        ui.selectable_value(&mut memory.luminance, true, names::LUMINANCE)
            .on_hover_text(
                "Y of the representation over that of the exact light, minus 1, percent.",
            );
        ui.weak("Click or drag to move the band-pass.");
    });
    let size = vec2(size.x, size.y - row);
    let shown = ChartView::held(ui, chart, "narrow error", size, context.theme);
    context.wishes.extend(shown.wish);
    let clicked = shown
        .response
        .clicked()
        .then(|| shown.response.interact_pointer_pos());
    let clicked = clicked
        .flatten()
        .map(|at| shown.transform.value_from_position(at).x);
    if let Some(nm) = shown.dragged.map(|[nm, _]| nm).or(clicked) {
        let memory = &mut context.memory.products.narrow;
        memory.centre_nm = inside(nm, band);
        memory.filter = None;
    }
}

/// The exact light and the three representations behind the filter, side by side.
fn fields(
    ui: &mut Ui,
    context: &PageContext<'_>,
    behind: &Behind,
    figures: &Figures,
    filter: &Filter,
) {
    ui.add_space(2.0);
    if !behind.has_colour() {
        ui.weak("There is no visible light in this range: nothing to see behind a filter.");
        return;
    }
    let over = match filter {
        Filter::Gaussian {
            centre_nm,
            width_nm,
        } => format!("Behind {centre_nm:.1} nm, {width_nm:.1} nm wide"),
        Filter::Real(entry) => format!("Behind {}", entry.name()),
    };
    let (swatches, gain) = behind.swatches(figures);
    let sentence = format!(
        "{over}: {} % of the luminance; three times {}.",
        percent(figures.luminance),
        numbers(behind.numbers())
    );
    ui.add(egui::Label::new(sentence).truncate())
        .on_hover_text(format!(
            "Shown {} times as bright as it is, as the colours are compared.",
            figure(gain)
        ));
    ui.horizontal(|ui| {
        let spacing = 8.0;
        ui.spacing_mut().item_spacing.x = spacing;
        let width = ((ui.available_width() - 3.0 * spacing) / 4.0).floor();
        let height = 30.0 * context.theme.scale;
        field(
            ui,
            vec2(width, height),
            &swatches[0],
            "exact",
            "",
            "Measured light, exact filter.",
        );
        for (way, colours) in figures.ways.iter().enumerate() {
            let words = format!("ΔE00 {}", delta_e(colours.delta_e_2000));
            let luminance = colours.luminance_error.map_or_else(
                || "no luminance to be off by".to_owned(),
                |error| format!("luminance {:+.2} %", 100.0 * error),
            );
            let meaning = format!("{}\n{words}, {luminance}.", WAY_MEANINGS[way]);
            field(
                ui,
                vec2(width, height),
                &swatches[way + 1],
                WAYS[way],
                &words,
                &meaning,
            );
        }
    });
    ui.add_space(4.0);
}

/// One colour with what it is and by how much it is off below it.
fn field(ui: &mut Ui, size: Vec2, colour: &Swatch, name: &str, words: &str, meaning: &str) {
    ui.vertical(|ui| {
        ui.set_width(size.x);
        ui.spacing_mut().item_spacing.y = 1.0;
        let told = format!("{name} behind the filter {words}");
        let hex = colour.hex();
        let mapping = if colour.in_gamut {
            String::new()
        } else {
            " The screen cannot show it; the nearest it can.".to_owned()
        };
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        named(&response, egui::Role::Image, &told);
        let shown = swatch::colour(colour.rgb8);
        swatch::paint_split(ui, rect, shown, shown);
        if !colour.in_gamut {
            swatch::out_of_gamut_mark(ui, rect.left_top() + vec2(9.0, 8.0));
        }
        response.on_hover_text(format!("{meaning}\nsRGB {hex}.{mapping}"));
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.add(egui::Label::new(RichText::new(name).small()).truncate());
            ui.add(egui::Label::new(RichText::new(words).small().strong()).truncate());
        });
    });
}

/// Every shipped filter glass and the user's own filters.
fn filters(ui: &mut Ui, context: &mut PageContext<'_>, behind: &Behind, rows: &[FilterRow]) {
    let app = context.app;
    ui.add_space(4.0);
    head(
        ui,
        "Behind measured filters and glasses",
        names::COPY,
        "Copies all filters with what the three are off by as a table.",
        || behind.csv(app, rows),
    );
    if rows.is_empty() {
        ui.weak("There are no filters.");
        return;
    }
    let mut columns = vec![
        Column::words(
            "filter",
            "Measured transmittance. Click a row to put it over the light.",
            3.4,
        ),
        Column::numbers(
            "luminance",
            "Y of the exact light behind the filter over that of the whole light, percent.",
            1.1,
        ),
    ];
    columns.extend((0..WAYS.len()).map(|way| {
        let meaning = format!("CIEDE2000. {}", WAY_MEANINGS[way]);
        Column::numbers(WAYS[way], &meaning, 1.2)
    }));
    let told: Vec<Row> = rows
        .iter()
        .map(|row| {
            let errors = row.figures.ways.map(|way| delta_e(way.delta_e_2000));
            let name = row.entry.name();
            Row {
                name: format!("Filter {name}: {}", errors.join(", ")),
                note: format!("{name}\nClick to put it over the light."),
                cells: [
                    name.to_owned(),
                    match row.figures.luminance {
                        Some(share) => format!("{} %", percent(share)),
                        None => "–".to_owned(),
                    },
                ]
                .into_iter()
                .chain(errors)
                .collect(),
            }
        })
        .collect();
    let memory = &mut context.memory.products.narrow;
    let chosen = memory
        .filter
        .as_ref()
        .and_then(|key| rows.iter().position(|row| row.entry.key == *key));
    let theme = context.theme;
    let clicked = ui
        .scope(|ui| table(ui, &columns, &told, chosen, true, theme))
        .inner;
    if let Some(row) = clicked.and_then(|index| rows.get(index)) {
        let entry: &Arc<Entry> = &row.entry;
        memory.filter =
            (chosen.is_none_or(|c| rows[c].entry.key != entry.key)).then(|| entry.key.clone());
    }
}
