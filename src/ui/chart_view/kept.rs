//! What a chart is painted of, kept from frame to frame: what has not changed is neither laid out
//! nor cut into triangles again.

use std::sync::Arc;

use eframe::egui;
use egui::{Id, Mesh, Shape, Ui, Vec2, epaint::Tessellator};

use super::paint;
use crate::app::chart::{Chart, Drawing, Looks, Primitive, View};
use crate::languages::{Language, spoken};

/// From this many places on a thing is kept by itself: its neighbours may change beside it.
const MANY: usize = 64;

/// All that a picture is made from.
#[derive(Clone, PartialEq)]
struct Of {
    chart: Chart,
    size: [f64; 2],
    looks: Looks,
    view: View,
    place: Place,
}

/// Where a picture is, and how fine the screen is there.
#[derive(Clone, Copy, PartialEq)]
struct Place {
    origin: Vec2,
    pixels_per_point: f32,
    /// Figures on axes are written as it writes them.
    language: Language,
}

/// Things that stand one upon another, in order.
#[derive(Clone)]
struct Part {
    things: Vec<Primitive>,
    /// Their triangles; `None` of what egui keeps itself: words, and discs that it has ready.
    mesh: Option<Arc<Mesh>>,
}

#[derive(Clone)]
struct Kept {
    of: Of,
    parts: Vec<Part>,
}

/// The shapes of a chart that was laid out for a size, in a view, from an origin on.
pub(super) fn shapes(
    ui: &Ui,
    id: Id,
    (drawing, looks): (&Drawing<'_>, Looks),
    view: View,
    origin: Vec2,
) -> Vec<Shape> {
    let place = Place {
        origin,
        pixels_per_point: ui.pixels_per_point(),
        language: spoken(),
    };
    let before: Option<Arc<Kept>> = ui.data(|data| data.get_temp(id));
    let is_same = |kept: &Kept| {
        let of = &kept.of;
        let how = (of.size, of.looks, of.view, of.place);
        how == (drawing.size, looks, view, place) && of.chart == *drawing.chart
    };
    let kept = match before {
        Some(kept) if is_same(&kept) => kept,
        before => {
            let had = before.as_deref().filter(|kept| kept.of.place == place);
            let had = had.map_or(&[][..], |kept| &kept.parts);
            let kept = Arc::new(Kept {
                parts: parts(ui, drawing.primitives(view), had, place),
                of: Of {
                    chart: drawing.chart.clone(),
                    size: drawing.size,
                    looks,
                    view,
                    place,
                },
            });
            ui.data_mut(|data| data.insert_temp(id, kept.clone()));
            kept
        }
    };
    let mut out = Vec::new();
    for part in &kept.parts {
        match &part.mesh {
            Some(mesh) => out.push(Shape::Mesh(mesh.clone())),
            None => out.extend(paint::shapes(ui.painter(), origin, &part.things)),
        }
    }
    out
}

/// Parts of a picture, those that were there before with the triangles that they had.
fn parts(ui: &Ui, things: Vec<Primitive>, had: &[Part], place: Place) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut last = None;
    for thing in things {
        let kind = (egui_keeps(&thing), places(&thing) >= MANY);
        match parts.last_mut() {
            Some(part) if last == Some(kind) && !kind.1 => part.things.push(thing),
            _ => parts.push(Part {
                things: vec![thing],
                mesh: None,
            }),
        }
        last = Some(kind);
    }
    for part in &mut parts {
        if egui_keeps(&part.things[0]) {
            continue;
        }
        let same = had.iter().find(|had| had.things == part.things);
        part.mesh = match same.and_then(|had| had.mesh.clone()) {
            Some(mesh) => Some(mesh),
            None => Some(Arc::new(triangles(ui, &part.things, place))),
        };
    }
    parts
}

fn triangles(ui: &Ui, things: &[Primitive], place: Place) -> Mesh {
    let options = ui.ctx().tessellation_options(|options| *options);
    // No letter and no disc is among them: the picture of the type is not asked for.
    let mut tessellator = Tessellator::new(place.pixels_per_point, options, [1, 1], Vec::new());
    let mut mesh = Mesh::default();
    for shape in paint::shapes(ui.painter(), place.origin, things) {
        tessellator.tessellate_shape(shape, &mut mesh);
    }
    mesh
}

fn egui_keeps(thing: &Primitive) -> bool {
    match thing {
        Primitive::Text(_) | Primitive::Circle { .. } => true,
        Primitive::Group { inner, .. } => inner.iter().any(egui_keeps),
        _ => false,
    }
}

fn places(thing: &Primitive) -> usize {
    match thing {
        Primitive::Lines { runs, .. } => runs.iter().map(Vec::len).sum(),
        Primitive::Band { corners, .. } => corners.len(),
        Primitive::Fields(fields) => fields.len(),
        Primitive::Pieces(pieces) => pieces.len(),
        Primitive::Group { inner, .. } => inner.iter().map(places).sum(),
        Primitive::Polygon { .. } | Primitive::Circle { .. } | Primitive::Text(_) => 1,
    }
}
