//! The window in the colours that a colour-blind eye sees.

use eframe::egui;
use egui::{
    Color32, Context, LayerId,
    epaint::{ClippedShape, shape_transform::adjust_colors},
    layers::ShapeIdx,
};

use crate::color::{MissingCones, Srgb};

/// Gives all that was painted in this frame the colours that such an eye sees. Pictures of pixels
/// keep theirs.
pub(super) fn apply(context: &Context, eyes: MissingCones) {
    let mut layers: Vec<LayerId> = context.memory(|memory| memory.layer_ids().collect());
    layers.push(LayerId::background());
    layers.sort_by_key(|layer| layer.id.value());
    layers.dedup();
    let seen = move |colour: &mut Color32| *colour = as_seen(*colour, eyes);
    context.graphics_mut(|graphics| {
        for layer in layers {
            let Some(list) = graphics.get_mut(layer) else {
                continue;
            };
            for index in 0..list.next_idx().0 {
                let recolour = |shape: &mut ClippedShape| adjust_colors(&mut shape.shape, seen);
                list.mutate_shape(ShapeIdx(index), recolour);
            }
        }
    });
}

fn as_seen(colour: Color32, eyes: MissingCones) -> Color32 {
    let [r, g, b, alpha] = colour.to_srgba_unmultiplied();
    if colour == Color32::PLACEHOLDER || (r == g && g == b) {
        return colour;
    }
    let Srgb([r, g, b]) = eyes.seen(Srgb([r, g, b]));
    Color32::from_rgba_unmultiplied(r, g, b, alpha)
}

/// The eyes that come after these, and what the act is called that gives them.
pub(super) fn next(eyes: Option<MissingCones>) -> (Option<MissingCones>, &'static str) {
    match eyes {
        None => (
            Some(MissingCones::Long),
            said!("As seen without red cones (protanopia)"),
        ),
        Some(MissingCones::Long) => (
            Some(MissingCones::Middle),
            said!("As seen without green cones (deuteranopia)"),
        ),
        Some(MissingCones::Middle) => (None, said!("As seen with all cones")),
    }
}
