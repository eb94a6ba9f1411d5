//! The controls of a number, as its row says.

use std::ops::RangeInclusive;

use eframe::egui;
use egui::{DragValue, Slider, emath::Numeric};

use crate::app::pages::knob::Knob;

/// What was typed as a number, with a comma or a point.
fn typed(text: &str) -> Option<f64> {
    let text = text.replace(char::is_whitespace, "").replace('−', "-");
    text.replace(',', ".").parse().ok()
}

/// A number to drag or to type, as any language writes it.
pub fn drag_value<N: Numeric>(value: &mut N) -> DragValue<'_> {
    DragValue::new(value).custom_parser(typed)
}

/// A slider whose number can be typed as any language writes it.
pub fn slide<N: Numeric>(value: &mut N, range: RangeInclusive<N>) -> Slider<'_> {
    Slider::new(value, range).custom_parser(typed)
}

/// A slider over all that the knob reaches.
pub fn slider<'a, T>(knob: &'a Knob<T>, value: &'a mut T) -> Slider<'a> {
    Slider::from_get_set(knob.reach.range(), moves(knob, value))
        .fixed_decimals(knob.digits.unsigned_abs() as usize)
        .suffix(knob.unit())
        .custom_parser(typed)
}

/// A number to drag or to type.
pub fn drag<'a, T>(knob: &'a Knob<T>, value: &'a mut T) -> DragValue<'a> {
    DragValue::from_get_set(moves(knob, value))
        .range(knob.reach.range())
        .max_decimals(knob.digits.unsigned_abs() as usize)
        .suffix(knob.unit())
        .custom_parser(typed)
}

fn moves<'a, T>(knob: &'a Knob<T>, value: &'a mut T) -> impl FnMut(Option<f64>) -> f64 + 'a {
    move |wanted| {
        if let Some(wanted) = wanted {
            knob.set(value, wanted);
        }
        knob.get(value)
    }
}
