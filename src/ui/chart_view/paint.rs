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
/// A line may pass a place by this much, points: a tenth of the width of the thinnest.
const BESIDE: f32 = 0.08;

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
    // The last place that was looked at, and the directions from the last kept one in which a
    // straight line passes all places since closely enough.
    let (mut before, mut cone): (Option<Pos2>, Option<[Vec2; 2]>) = (None, None);
    for (i, at) in run.enumerate() {
        let Some(from) = before else {
            kept.push(at);
            before = Some(at);
            continue;
        };
        if (at - from).length_sq() <= UNSEEN * UNSEEN && i < last {
            continue;
        }
        let mut step = at - *kept.last().unwrap_or(&from);
        if !cone.is_none_or(|cone| is_within(cone, step)) {
            kept.push(from);
            step = at - from;
            cone = None;
        }
        let length = step.length();
        if length > BESIDE {
            // To both sides as far as a place may lie beside the line.
            let aside = step.rot90() * (BESIDE / length);
            let [left, right] = [step + aside, step - aside];
            cone = Some(cone.map_or([left, right], |[l, r]| {
                [
                    if turn(l, left) > 0.0 { left } else { l },
                    if turn(r, right) < 0.0 { right } else { r },
                ]
            }));
        }
        before = Some(at);
    }
    kept.extend(before.filter(|_| last > 0));
    kept
}

/// Above 0 where the second direction lies clockwise of the first, as screens count.
fn turn(one: Vec2, other: Vec2) -> f32 {
    one.x * other.y - one.y * other.x
}

fn is_within([left, right]: [Vec2; 2], step: Vec2) -> bool {
    turn(left, step) >= 0.0 && turn(step, right) >= 0.0 && step.dot(left + right) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(at: Pos2, [from, to]: [Pos2; 2]) -> f32 {
        let along = to - from;
        let share = ((at - from).dot(along) / along.length_sq()).clamp(0.0, 1.0);
        (at - (from + along * share)).length()
    }

    #[test]
    fn a_line_is_drawn_of_fewer_corners_and_passes_every_place_unseen() {
        let waves = |steps: u32| {
            let place = move |i: u32| {
                let x = i as f32 * 800.0 / steps as f32;
                let peak = 300.0 * (-((x - 400.0) / 3.0).powi(2)).exp();
                pos2(x, 200.0 + 80.0 * (x / 90.0).sin() - peak)
            };
            (0..=steps).map(place).collect::<Vec<_>>()
        };
        for run in [waves(400), waves(40_000)] {
            let drawn = thinned(run.iter().copied());
            assert!(drawn.len() < 200, "{} corners", drawn.len());
            assert_eq!(
                [drawn[0], drawn[drawn.len() - 1]],
                [run[0], run[run.len() - 1]]
            );
            let lines: Vec<[Pos2; 2]> = drawn.windows(2).map(|w| [w[0], w[1]]).collect();
            for at in run {
                let apart = lines.iter().map(|line| distance(at, *line));
                let apart = apart.fold(f32::INFINITY, f32::min);
                // A place passed over for the one before it adds as much as it is away from that.
                assert!(apart <= BESIDE + UNSEEN, "{at} is {apart} beside the line");
            }
        }
    }

    #[test]
    fn a_needle_keeps_its_tip_and_a_single_place_is_one() {
        let needle = [
            pos2(0.0, 9.0),
            pos2(5.0, 9.0),
            pos2(5.0, 1.0),
            pos2(5.0, 9.0),
            pos2(9.0, 9.0),
        ];
        assert_eq!(thinned(needle.into_iter()), needle);
        assert_eq!(thinned([pos2(1.0, 2.0)].into_iter()), [pos2(1.0, 2.0)]);
        assert!(thinned([].into_iter()).is_empty());
    }
}
