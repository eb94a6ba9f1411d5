//! Points as primitives.

use super::{
    Dash, Shape,
    primitive::{Place, Primitive},
};

/// A filled circle.
pub(super) fn dot(at: Place, radius: f64, colour: [u8; 3]) -> Primitive {
    Primitive::Circle {
        at,
        radius,
        colour,
        hollow: None,
    }
}

/// A point of a form.
pub(super) fn form(at: Place, radius: f64, shape: Shape, colour: [u8; 3]) -> Primitive {
    let corner = |c: &[f64; 2]| [at[0] + radius * c[0], at[1] + radius * c[1]];
    let corners: Vec<Place> = shape.corners().iter().map(corner).collect();
    let thickness = 0.45 * radius;
    match (shape, &corners[..]) {
        (Shape::Ring, _) => Primitive::Circle {
            at,
            radius,
            colour,
            hollow: Some(thickness),
        },
        (Shape::Cross, [a, b, c, d]) => Primitive::Lines {
            runs: vec![vec![*a, *b], vec![*c, *d]],
            width: thickness,
            dash: Dash::Solid,
            colour,
        },
        (_, []) => dot(at, radius, colour),
        _ => Primitive::Polygon { corners, colour },
    }
}
