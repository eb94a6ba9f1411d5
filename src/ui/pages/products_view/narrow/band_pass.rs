//! The two charts in which the band-pass is moved by hand.

use eframe::egui;
use egui::{CursorIcon, Ui, Vec2, pos2, vec2};

use super::names;
use crate::{
    app::{chart::Chart, pages::NarrowMemory},
    languages::said,
    spectrum::Band,
    ui::{
        chart_view::{ChartResponse, ChartView},
        pages::PageContext,
    },
};

/// How near the pointer must be to an edge of the band-pass to take it, points.
const REACH: f32 = 7.0;

/// What of the band-pass is held.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Grip {
    /// All of it, by a place this many nm right of its centre.
    Whole(f64),
    /// One of its edges.
    Edge,
}

/// The light with the filter over it, which can be dragged; `grip` is what is held.
pub(super) fn light(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    band: Band,
    chart: &Chart,
    size: Vec2,
    grip: &mut Option<Grip>,
) {
    let shown = ChartView::held(ui, chart, "narrow light", size, context.theme);
    let memory = &mut context.pages.narrow;
    drag(ui, &shown, memory, band, grip);
    context.ask_for_chart(shown.wish);
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
    if let Some(nm) = clicked_nm(shown) {
        memory.centre_nm = inside(nm, band);
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
            NarrowMemory::WIDTH.set(memory, width);
        }
    }
}

/// The wavelength that was clicked.
fn clicked_nm(shown: &ChartResponse) -> Option<f64> {
    let response = &shown.response;
    let at = response
        .interact_pointer_pos()
        .filter(|_| response.clicked())?;
    Some(shown.transform.value_from_position(at).x)
}

/// A place of the band, in tenths of a nm.
fn inside(nm: f64, band: Band) -> f64 {
    ((10.0 * nm).round() / 10.0).clamp(band.min_nm(), band.max_nm())
}

/// Errors against the centre; a click or a drag takes the band-pass there.
pub(super) fn errors(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    band: Band,
    chart: &Chart,
    size: Vec2,
) {
    if chart.y_range.is_none() {
        return;
    }
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    ui.horizontal_wrapped(|ui| {
        let memory = &mut context.pages.narrow;
        ui.label(said!("Error of"));
        ui.selectable_value(&mut memory.luminance, false, names::COLOUR)
            .on_hover_text(said!(
                "CIEDE2000, what is below 0.1 at the foot of the axis; both sides brightened so \
                 that the exact light behind the filter has half the whole light's Y, by at most \
                 fifty times."
            ));
        ui.selectable_value(&mut memory.luminance, true, said(names::LUMINANCE))
            .on_hover_text(said!(
                "Y of the representation over that of the exact light, minus 1, percent."
            ));
        ui.weak(said!("Click or drag to move the band-pass."));
    });
    let size = vec2(size.x, size.y - row);
    let shown = ChartView::held(ui, chart, "narrow error", size, context.theme);
    let nm = shown.dragged.map(|[nm, _]| nm).or(clicked_nm(&shown));
    context.ask_for_chart(shown.wish);
    if let Some(nm) = nm {
        let memory = &mut context.pages.narrow;
        memory.centre_nm = inside(nm, band);
        memory.filter = None;
    }
}
