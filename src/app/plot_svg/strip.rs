//! Colours along the horizontal axis.

use std::fmt::Write as _;

use super::{Rgb, cut::Place, palette::hex, text::px};

/// Height of the colour strip, px.
pub(super) const STRIP_HEIGHT: f64 = 14.0;

/// Writes colours as a row of boxes.
///
/// The first colour belongs to the left end and the last to the right end, so each box reaches
/// from half way to its left neighbour to half way to its right one. Equal neighbours are one box.
pub(super) fn draw_strip(out: &mut String, at: Place, width: f64, colours: &[Rgb]) {
    let steps = (colours.len() - 1).max(1) as f64;
    let border = |i: usize| ((i as f64 - 0.5) / steps).clamp(0.0, 1.0) * width;
    let _ = writeln!(out, r#"<g shape-rendering="crispEdges">"#);
    let mut first = 0;
    for run in colours.chunk_by(|a, b| a == b) {
        let end = first + run.len();
        let from = border(first);
        // Up to the right end, so that no rounding leaves a gap; the next boxes go on top.
        let _ = writeln!(
            out,
            r#"<rect x="{}" y="{}" width="{}" height="{STRIP_HEIGHT}" fill="{}"/>"#,
            px(at[0] + from),
            px(at[1]),
            px(width - from),
            hex(run[0]),
        );
        first = end;
    }
    let _ = writeln!(out, "</g>");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strip_gives_its_end_colours_half_a_step() {
        let mut out = String::new();
        draw_strip(&mut out, [0.0, 0.0], 100.0, &[[1; 3], [2; 3], [3; 3]]);
        let starts: Vec<bool> = [r#"x="0""#, r#"x="25""#, r#"x="75""#]
            .map(|start| out.contains(start))
            .to_vec();
        assert_eq!(starts, [true; 3]);
    }
}
