//! The controls of a knob, as its row says.

use eframe::egui;
use egui::{DragValue, Slider};

use crate::app::pages::knob::Knob;

/// A slider over all that the knob reaches.
pub fn slider<'a, T>(knob: &'a Knob<T>, value: &'a mut T) -> Slider<'a> {
    Slider::from_get_set(knob.reach.range(), moves(knob, value))
        .fixed_decimals(knob.digits.unsigned_abs() as usize)
        .suffix(knob.unit)
}

/// A number to drag or to type.
pub fn drag<'a, T>(knob: &'a Knob<T>, value: &'a mut T) -> DragValue<'a> {
    DragValue::from_get_set(moves(knob, value))
        .range(knob.reach.range())
        .max_decimals(knob.digits.unsigned_abs() as usize)
        .suffix(knob.unit)
}

fn moves<'a, T>(knob: &'a Knob<T>, value: &'a mut T) -> impl FnMut(Option<f64>) -> f64 + 'a {
    move |wanted| {
        if let Some(wanted) = wanted {
            knob.set(value, wanted);
        }
        knob.get(value)
    }
}
