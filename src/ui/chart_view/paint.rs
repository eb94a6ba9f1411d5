//! The primitives of a drawing as egui shapes.

use eframe::egui;
use egui::{
    Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Shape, Stroke, Vec2, epaint::TextShape,
    pos2, vec2,
};

use super::super::theme::ink;
use crate::app::chart::{Anchor, Field, Place, Primitive, Text};

/// Points closer than this to the last one drawn change nothing that can be seen.
const UNSEEN: f32 = 0.4;

/// A place of the drawing on screen.
pub(super) fn pos(origin: Vec2, [x, y]: Place) -> Pos2 {
    pos2(x as f32, y as f32) + origin
}

/// A field of the drawing on screen.
pub(super) fn rect(origin: Vec2, field: Field) -> Rect {
    let [low, high] = field.corners().map(|corner| pos(origin, corner));
    Rect::from_min_max(low, high)
}

/// What is drawn, as shapes from an origin on.
pub fn shapes(painter: &Painter, origin: Vec2, primitives: &[Primitive]) -> Vec<Shape> {
    let mut out = Vec::new();
    for primitive in primitives {
        add(&mut out, painter, origin, primitive);
    }
    out
}

fn add(out: &mut Vec<Shape>, painter: &Painter, origin: Vec2, primitive: &Primitive) {
    match primitive {
        Primitive::Lines {
            runs,
            width,
            dash,
            colour,
        } => {
            let stroke = Stroke::new(*width as f32, ink(*colour));
            for run in runs {
                let run = thinned(run.iter().map(|at| pos(origin, *at)));
                match (dash.pattern(), &run[..]) {
                    // Upright and level ones are put on whole pixels.
                    (None, [from, to]) => out.push(Shape::line_segment([*from, *to], stroke)),
                    (None, _) => out.push(Shape::line(run, stroke)),
                    (Some([dash, gap]), _) => {
                        out.extend(Shape::dashed_line(&run, stroke, dash as f32, gap as f32));
                    }
                }
            }
        }
        Primitive::Band {
            corners,
            shades,
            colour,
            opacity,
        } => {
            let mut mesh = Mesh::default();
            for (i, [x, one, other]) in corners.iter().enumerate() {
                let shade = ink(*shades.get(i).unwrap_or(colour));
                let fill = shade.gamma_multiply(*opacity as f32);
                let first = mesh.vertices.len() as u32;
                mesh.colored_vertex(pos(origin, [*x, *one]), fill);
                mesh.colored_vertex(pos(origin, [*x, *other]), fill);
                if first > 0 {
                    mesh.add_triangle(first - 2, first - 1, first);
                    mesh.add_triangle(first - 1, first, first + 1);
                }
            }
            out.push(mesh.into());
        }
        Primitive::Fields(fields) => {
            let mut mesh = Mesh::default();
            for (field, colour) in fields {
                mesh.add_colored_rect(rect(origin, *field), ink(*colour));
            }
            out.push(mesh.into());
        }
        Primitive::Pieces(pieces) => {
            let mut mesh = Mesh::default();
            for (corners, colours) in pieces {
                let first = mesh.vertices.len() as u32;
                for (at, colour) in corners.iter().zip(colours) {
                    mesh.colored_vertex(pos(origin, *at), ink(*colour));
                }
                mesh.add_triangle(first, first + 1, first + 2);
                mesh.add_triangle(first, first + 2, first + 3);
            }
            out.push(mesh.into());
        }
        Primitive::Polygon { corners, colour } => {
            let corners = corners.iter().map(|at| pos(origin, *at)).collect();
            out.push(Shape::convex_polygon(corners, ink(*colour), Stroke::NONE));
        }
        Primitive::Circle {
            at,
            radius,
            colour,
            hollow,
        } => {
            let (at, radius, colour) = (pos(origin, *at), *radius as f32, ink(*colour));
            out.push(match hollow {
                Some(width) => Shape::circle_stroke(at, radius, (*width as f32, colour)),
                None => Shape::circle_filled(at, radius, colour),
            });
        }
        Primitive::Text(text) => add_text(out, painter, origin, text),
        Primitive::Group { inner, .. } => out.extend(shapes(painter, origin, inner)),
    }
}

fn add_text(out: &mut Vec<Shape>, painter: &Painter, origin: Vec2, text: &Text) {
    let font = FontId::proportional(text.size as f32);
    let galley = painter.layout_no_wrap(text.words.clone(), font, ink(text.colour));
    let anchor = match text.anchor {
        Anchor::Start => Align2::LEFT_CENTER,
        Anchor::Middle => Align2::CENTER_CENTER,
        Anchor::End => Align2::RIGHT_CENTER,
    };
    let rect = anchor.anchor_size(pos(origin, text.at), galley.size());
    if let Some(ground) = text.ground {
        let ground = ink(ground).gamma_multiply(0.75);
        let field = rect.expand2(vec2(2.0, 0.0));
        out.push(Shape::rect_filled(field, 2.0, ground));
    }
    let turn = -(text.rise as f32).to_radians();
    let shape = TextShape::new(rect.min, galley, Color32::PLACEHOLDER);
    out.push(shape.with_angle_and_anchor(turn, anchor).into());
}

/// A line without corners that nobody can see.
fn thinned(run: impl ExactSizeIterator<Item = Pos2>) -> Vec<Pos2> {
    let last = run.len().saturating_sub(1);
    let mut kept: Vec<Pos2> = Vec::with_capacity(run.len());
    for (i, at) in run.enumerate() {
        let far = kept
            .last()
            .is_none_or(|k| (at - *k).length_sq() > UNSEEN * UNSEEN);
        if far || i == last {
            kept.push(at);
        }
    }
    kept
}
