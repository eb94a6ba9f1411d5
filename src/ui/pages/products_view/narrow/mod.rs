//! The part "Narrow filters" of the page "Products": a band-pass moved over the light.

mod band_pass;

use crate::ui::kit::{drag_value, slide};
use eframe::egui;
use egui::{RichText, Sense, Ui, Vec2, vec2};

use crate::{
    app::{
        App, Memo,
        chart::Chart,
        charts::products::narrow::{
            Behind, Figures, Filter, FilterRow, SecondBehind, WAY_MEANINGS, WAYS,
        },
        headlines,
        numbers::{delta_e, figure, percent},
        pages::{NarrowMemory, PASS_WIDTHS_NM},
        ticks::short,
    },
    color::Swatch,
    languages::{said, signed},
    spectrum::Band,
    study::products::NarrowPoint,
    ui::{
        kit::{self, Chooser, drawing, headline, scrolled, titled, transmittances, two_columns},
        pages::PageContext,
        swatch,
    },
};

/// From this width on the two charts stand side by side, points.
const WIDE: f32 = 1040.0;

/// What people and tests call the controls.
pub mod names {
    pub const CENTRE: &str = later!("Centre");
    pub const WIDTH: &str = later!("Width");
    pub const FILTER: &str = later!("Filter");
    pub const GAUSSIAN: &str = later!("Gaussian");
    pub const COPY: &str = later!("Copy filters as CSV");
    pub const COLOUR: &str = "ΔE₀₀";
    pub const LUMINANCE: &str = later!("luminance");
}

/// What one filter leaves of the light and of the second one, and the two charts.
type Shown = (Figures, Option<SecondBehind>, [Chart; 2]);

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct NarrowView {
    behind: Memo<u64, (Behind, Vec<FilterRow>)>,
    curve: Memo<(u64, f64), Vec<NarrowPoint>>,
    shown: Memo<(u64, NarrowMemory), Shown>,
    grip: Option<band_pass::Grip>,
}

impl NarrowView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let (app, revision) = (context.app, context.app.revision());
        let (behind, rows) = &*self.behind.get(revision, |_| {
            let behind = Behind::of(app);
            let table = behind.table(app);
            (behind, table)
        });
        let band = behind.band;
        let memory = context.pages.narrow.clone();
        let filter = filter_of(app, &memory, band);
        let curve = self
            .curve
            .get((revision, memory.width_nm), |(_, width_nm)| {
                behind.curve(*width_nm)
            });
        let key = (revision, memory);
        let (figures, second, [light, errors]) = &*self.shown.get(key, |(_, memory)| {
            let marked = match &filter {
                Filter::Gaussian { centre_nm, .. } => Some(*centre_nm),
                Filter::Real(_) => None,
            };
            let width_nm = memory.width_nm;
            let light = behind.light_chart(app, &filter);
            let errors = behind.error_chart(app, curve, memory.luminance, width_nm, marked);
            let figures = behind.figures(&filter);
            let second = behind.second(&figures, &filter);
            (figures, second, [light, errors])
        });
        headline(
            ui,
            context.theme,
            headlines::narrow(behind, figures, &filter),
        );
        controls(ui, context, band);
        let room = ui.available_size();
        let scale = context.theme.scale;
        let grip = &mut self.grip;
        scrolled(ui, "narrow", |ui| {
            let width = ui.available_width();
            if width >= WIDE * scale {
                let height = (0.52 * room.y).max(260.0 * scale);
                let left = |ui: &mut Ui, context: &mut PageContext<'_>| {
                    let size = vec2(ui.available_width(), height);
                    band_pass::light(ui, context, band, light, size, grip);
                };
                two_columns(ui, context, left, |ui, context| {
                    let size = vec2(ui.available_width(), height);
                    band_pass::errors(ui, context, band, errors, size);
                });
                fields(ui, context, behind, (figures, second.as_ref()));
            } else {
                let height = (0.37 * room.y).clamp(210.0 * scale, 380.0 * scale);
                let size = vec2(width, height);
                band_pass::light(ui, context, band, light, size, grip);
                fields(ui, context, behind, (figures, second.as_ref()));
                band_pass::errors(ui, context, band, errors, size);
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
    let memory = &mut context.pages.narrow;
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(said(names::CENTRE));
        let mut centre = memory.centre_nm.clamp(band.min_nm(), band.max_nm());
        let slider = slide(&mut centre, band.min_nm()..=band.max_nm())
            .fixed_decimals(1)
            .suffix(" nm");
        let response = ui.add(slider).labelled_by(label.id).on_hover_text(said!(
            "Centre of the Gaussian band-pass, nm. It can be dragged in the chart too."
        ));
        if response.changed() {
            memory.centre_nm = centre;
            memory.filter = None;
        }
        let label = ui.label(said(names::WIDTH));
        let [least, most] = PASS_WIDTHS_NM;
        let width = drag_value(&mut memory.width_nm)
            .speed(0.1)
            .range(least..=most)
            .fixed_decimals(1)
            .suffix(" nm");
        let response = ui.add(width).labelled_by(label.id).on_hover_text(tr!(
            "Full width of the band-pass at half its maximum, {least} to {most} nm. Its edges can \
             be dragged in the chart too.",
            least = short(least),
            most = short(most)
        ));
        if response.changed() {
            memory.filter = None;
        }
        ui.separator();
        let chosen = memory.filter.as_ref().and_then(|key| app.entry(key));
        let meaning = said!("The Gaussian band-pass of this centre and width.");
        if ui
            .selectable_label(chosen.is_none(), said(names::GAUSSIAN))
            .on_hover_text(meaning)
            .clicked()
        {
            memory.filter = None;
        }
        let says = chosen
            .as_ref()
            .map_or(said!("or a measured filter"), |e| e.name());
        let chooser = Chooser {
            name: said(names::FILTER),
            meaning: said!(
                "A measured filter or glass in the Gaussian's place: shipped or your own."
            ),
            says,
            offers: transmittances,
            width: 150.0 * context.theme.scale,
        };
        if let Some(entry) = chooser.show(ui, app) {
            memory.filter = Some(entry.key.clone());
        }
    });
}

/// Every shipped filter glass and the user's own filters.
fn filters(ui: &mut Ui, context: &mut PageContext<'_>, behind: &Behind, rows: &[FilterRow]) {
    let table = behind.filters_table(context.app, rows);
    ui.add_space(4.0);
    titled(
        ui,
        said!("Behind measured filters and glasses"),
        said(names::COPY),
        said!("Copies all filters with what the three are off by as a table."),
        || table.csv(),
    );
    if rows.is_empty() {
        ui.weak(said!("There are no filters."));
        return;
    }
    let columns = kit::columns(&table, &[3.4, 1.1, 1.2, 1.2, 1.2]);
    let told = kit::rows(&table, |_, cells| {
        let name = &cells[0];
        [
            tr!(
                "Filter {name}: {figures}",
                name,
                figures = cells[2..].join(", ")
            ),
            tr!("{name}\nClick to put it over the light.", name),
        ]
    });
    let memory = &mut context.pages.narrow;
    let chosen = memory
        .filter
        .as_ref()
        .and_then(|key| rows.iter().position(|row| row.entry.key == *key));
    let theme = context.theme;
    let clicked = kit::table(ui, &columns, &told, chosen, true, theme);
    if let Some(row) = clicked.and_then(|index| rows.get(index)) {
        let key = &row.entry.key;
        memory.filter = Some(key.clone()).filter(|key| memory.filter.as_ref() != Some(key));
    }
}

/// The exact light and the three representations behind the filter, side by side.
fn fields(
    ui: &mut Ui,
    context: &PageContext<'_>,
    behind: &Behind,
    (figures, second): (&Figures, Option<&SecondBehind>),
) {
    ui.add_space(2.0);
    if !behind.has_colour() {
        return;
    }
    let (swatches, gain) = behind.swatches(figures);
    let own = percent(figures.luminance);
    let sentence = match second {
        None => tr!("{own} % of the luminance comes through.", own),
        Some(second) => tr!(
            "{own} % of the luminance comes through, of {light} {share} %.",
            own,
            light = second.name,
            share = percent(second.luminance)
        ),
    };
    ui.add(egui::Label::new(sentence).truncate())
        .on_hover_text(tr!(
            "Shown {factor} times as bright as it is.",
            factor = figure(gain)
        ));
    ui.horizontal(|ui| {
        let spacing = 8.0;
        ui.spacing_mut().item_spacing.x = spacing;
        let count = if second.is_some() { 5.0 } else { 4.0 };
        let width = ((ui.available_width() - (count - 1.0) * spacing) / count).floor();
        let size = vec2(width, 30.0 * context.theme.scale);
        let meaning = said!("Measured light, exact filter.");
        let words = second.map_or("", |_| &behind.light);
        field(ui, size, &swatches[0], said!("exact"), words, meaning);
        if let Some(second) = second {
            let meaning = tr!(
                "{meaning} Both lights equally bright before the filter.",
                meaning
            );
            field(
                ui,
                size,
                &second.swatch,
                said!("exact"),
                &second.name,
                &meaning,
            );
        }
        for (way, colours) in figures.ways.iter().enumerate() {
            let words = format!("ΔE₀₀ {}", delta_e(colours.delta_e_2000));
            let luminance = colours.luminance_error.map_or_else(
                || said!("no luminance to be off by").to_owned(),
                |error| tr!("luminance {error} %", error = signed(100.0 * error, 2)),
            );
            let meaning = format!("{}\n{words}, {luminance}.", said(WAY_MEANINGS[way]));
            field(
                ui,
                size,
                &swatches[way + 1],
                said(WAYS[way]),
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
        let told = tr!(
            "{name} behind the filter {difference}",
            name,
            difference = words
        );
        let hex = colour.hex();
        let mapping = if colour.in_gamut {
            String::new()
        } else {
            said!(" The screen cannot show it; the nearest it can.").to_owned()
        };
        let (rect, response) = drawing(ui, size, Sense::hover(), &told);
        let shown = swatch::colour(colour.rgb8);
        swatch::paint_split(ui, rect, shown, shown);
        if !colour.in_gamut {
            swatch::out_of_gamut_mark(ui, rect);
        }
        response.on_hover_text(tr!(
            "{meaning}\nsRGB {hex}.{mapping}",
            meaning,
            hex,
            mapping
        ));
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.add(egui::Label::new(RichText::new(name).small()).truncate());
            ui.add(egui::Label::new(RichText::new(words).small().strong()).truncate());
        });
    });
}
