//! A panel: its grid and frame, its vertical axis, and the series inside.

use std::fmt::Write as _;

use super::{
    MARGIN, Scale, Series, TICK,
    axes::{Horizontal, Vertical},
    marks::Plot,
    palette::{Palette, hex},
    text::{Anchor, TEXT_SIZE, Text, escaped, px},
};

/// Place and size of a panel in the picture, px.
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl Frame {
    /// Writes a panel: grid, axes, marks.
    pub(super) fn draw(
        &self,
        out: &mut String,
        palette: &Palette,
        horizontal: &Horizontal,
        vertical: &Vertical,
        y_label: &str,
        series: &[Series],
    ) {
        let (left, top) = (px(self.left), px(self.top));
        let (width, height) = (px(self.width), px(self.height));

        let mut grid = String::new();
        // Names have no in-between that a line could help to read.
        let across = horizontal.ticks.iter().filter(|_| !horizontal.named);
        for &tick in across {
            let x = self.left + horizontal.px(tick);
            let _ = write!(grid, "M{} {top}v{height}", px(x));
        }
        for &tick in &vertical.ticks {
            let y = self.top + vertical.px(tick);
            let _ = write!(grid, "M{left} {}h{width}", px(y));
        }
        let colour = hex(palette.grid);
        let _ = writeln!(out, r#"<path d="{grid}" stroke="{colour}"/>"#);
        let axis = hex(palette.axis);
        let is_map = series.iter().any(|series| series.marks.cells().is_some());
        let crossed = vertical.range[0] < 0.0 && vertical.range[1] > 0.0;
        if vertical.scale == Scale::Linear && crossed && !is_map {
            let y = px(self.top + vertical.px(0.0));
            let _ = writeln!(out, r#"<path d="M{left} {y}h{width}" stroke="{axis}"/>"#);
        }

        let label = Text {
            size: TEXT_SIZE,
            colour: palette.text,
            anchor: Anchor::End,
        };
        for (tick, text) in vertical.ticks.iter().zip(&vertical.labels) {
            let y = self.top + vertical.px(*tick);
            let start = px(self.left - TICK);
            let _ = writeln!(
                out,
                r#"<path d="M{start} {}h{TICK}" stroke="{axis}"/>"#,
                px(y)
            );
            let at = [self.left - TICK - 3.0, y + TEXT_SIZE * 0.36];
            label.write(out, at, text);
        }
        if !y_label.is_empty() {
            let (x, y) = (MARGIN + TEXT_SIZE * 0.8, self.top + self.height / 2.0);
            let _ = writeln!(
                out,
                r#"<text transform="translate({} {}) rotate(-90)" font-size="{TEXT_SIZE}" text-anchor="middle" fill="{}">{}</text>"#,
                px(x),
                px(y),
                hex(palette.text),
                escaped(y_label),
            );
        }

        let _ = writeln!(out, r#"<g transform="translate({left} {top})">"#);
        let mut taken = Vec::new();
        for series in series {
            let _ = writeln!(out, "<g>");
            if !series.name.is_empty() {
                let _ = writeln!(out, "<title>{}</title>", escaped(&series.name));
            }
            let plot = Plot {
                horizontal,
                vertical,
                palette,
            };
            plot.marks(out, series, &mut taken);
            let _ = writeln!(out, "</g>");
        }
        let _ = writeln!(
            out,
            "</g>\n<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" stroke=\"{axis}\"/>"
        );
    }
}
