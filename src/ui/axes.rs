//! Axes of all plots: round numbers, quiet grid lines, labels that are always readable.

use eframe::egui;
use egui::Rangef;
use egui_plot::{AxisHints, GridInput, GridMark, Plot};

use super::theme::{Theme, grey};
use crate::app::ticks::{log_ticks, nice_ticks};

/// Grid lines and labels of one strength: which marks there are is decided by the spacers below.
const ALWAYS: Rangef = Rangef { min: 0.1, max: 0.2 };

/// Gives a plot the program's grid and its two axes.
///
/// `x_words` and `y_words` write a mark's number; `y_width` keeps the axes of plots that stand
/// over one another in line.
pub fn dress<'a>(
    plot: Plot<'a>,
    theme: Theme,
    y_width: f32,
    x_words: impl Fn(f64) -> String + 'a,
    y_words: impl Fn(f64) -> String + 'a,
) -> Plot<'a> {
    let font = |hints: AxisHints<'a>| hints.label_spacing(ALWAYS).tick_label_color(theme.faint);
    plot.grid_color(grey(if theme.dark { 46 } else { 222 }))
        .grid_fade(0.0)
        .grid_spacing(ALWAYS)
        .custom_x_axes(vec![
            font(AxisHints::new_x()).formatter(move |mark, _| x_words(mark.value)),
        ])
        .custom_y_axes(vec![
            font(AxisHints::new_y())
                .min_thickness(y_width)
                .formatter(move |mark, _| y_words(mark.value)),
        ])
}

/// About `target` round marks over what is shown.
pub fn marks(target: usize) -> impl Fn(GridInput) -> Vec<GridMark> {
    move |input| {
        let (low, high) = input.bounds;
        let ticks = nice_ticks(low, high, target);
        let step_size = ticks.get(1).zip(ticks.first()).map_or(1.0, |(b, a)| b - a);
        ticks
            .into_iter()
            .map(|value| GridMark { value, step_size })
            .collect()
    }
}

/// Whole numbers of an axis whose values are decimal logarithms: every decade, or every few.
pub fn decades(target: usize) -> impl Fn(GridInput) -> Vec<GridMark> {
    move |input| {
        let (low, high) = input.bounds;
        let (first, last) = (low.ceil() as i64, high.floor() as i64);
        let every = usize::try_from((last - first).max(0))
            .unwrap_or(0)
            .div_ceil(target.max(1))
            .max(1);
        (first..=last)
            .step_by(every)
            .map(|decade| GridMark {
                value: decade as f64,
                step_size: every as f64,
            })
            .collect()
    }
}

/// About `target` round numbers of an axis whose values are decimal logarithms: decades, and where
/// there are few of them 2 and 5 in between.
pub fn log_marks(target: usize) -> impl Fn(GridInput) -> Vec<GridMark> {
    move |input| {
        let (low, high) = input.bounds;
        let ticks = log_ticks(10_f64.powf(low), 10_f64.powf(high), target);
        ticks.into_iter().map(|tick| mark(tick.log10())).collect()
    }
}

/// A mark as strong as any.
fn mark(value: f64) -> GridMark {
    GridMark {
        value,
        step_size: 1.0,
    }
}
