//! A chart as an SVG document.
//!
//! Everything is cut to its panel before it is written, so the file needs no clip paths (and no
//! ids, which would clash where several charts are pasted into one page), and no number in it is
//! far outside the picture.

use std::{
    collections::HashSet,
    fmt::{self, Write as _},
};

use super::{
    Chart, Dash, Rgb, Theme,
    drawing::Drawing,
    looks::Looks,
    primitive::{Anchor, Field, Place, Primitive, Text},
};
use crate::app::ticks::without_trailing_zeros;

/// How every SVG document of the program begins: the command line knows its own pictures by it, and
/// replaces no others.
pub const SVG_HEAD: &str = concat!(
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg data-drawn-by=\"",
    env!("CARGO_PKG_NAME"),
    "\""
);

impl Chart {
    /// The chart as an SVG document of the given size in px (at least 160 x 120).
    ///
    /// The document is higher than asked where titles and notes leave no room for the panels.
    pub fn to_svg(&self, width: u32, height: u32, theme: Theme) -> String {
        let asked = [width.max(160), height.max(120)].map(f64::from);
        let (body, size) = self.to_svg_body(asked, theme);
        let [width, height] = size.map(|side| px(side.ceil()));
        let title = escaped(&self.title);
        let description = escaped(&self.description());
        format!(
            r#"{SVG_HEAD} xmlns="http://www.w3.org/2000/svg" role="img" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="sans-serif" fill="none">
<title>{title}</title>
<desc>{description}</desc>
{body}</svg>
"#
        )
    }

    /// What stands in such a document, for a page of several charts, and how large it became.
    pub fn to_svg_body(&self, size: [f64; 2], theme: Theme) -> (String, [f64; 2]) {
        let drawing = Drawing::new(self, size, Looks::of_file(theme));
        let mut body = String::new();
        for primitive in drawing.primitives(self.whole_view()) {
            // Writing to a String cannot fail.
            let _ = write(&mut body, &primitive);
        }
        (body, drawing.size)
    }
}

fn write(out: &mut String, primitive: &Primitive) -> fmt::Result {
    match primitive {
        Primitive::Lines {
            runs,
            width,
            dash,
            colour,
        } => write_lines(out, runs, *width, *dash, *colour),
        Primitive::Band {
            corners, shades, ..
        } if !shades.is_empty() => write_shaded(out, corners, shades),
        Primitive::Band {
            corners,
            shades: _,
            colour,
            opacity,
        } => {
            let there = corners.iter().map(|[x, one, _]| [*x, *one]);
            let back = corners.iter().rev().map(|[x, _, other]| [*x, *other]);
            let ring: Vec<Place> = there.chain(back).collect();
            let (path, colour) = (path(&ring), hex(*colour));
            writeln!(
                out,
                r#"<path d="{path}Z" fill="{colour}" fill-opacity="{opacity}"/>"#
            )
        }
        Primitive::Fields(fields) => write_fields(out, fields),
        Primitive::Pieces(pieces) => write_pieces(out, pieces),
        Primitive::Polygon { corners, colour } => {
            let (path, colour) = (path(corners), hex(*colour));
            writeln!(out, r#"<path d="{path}Z" fill="{colour}"/>"#)
        }
        Primitive::Circle {
            at,
            radius,
            colour,
            hollow,
        } => {
            let ([x, y], r, colour) = (at.map(px), px(*radius), hex(*colour));
            let how = match hollow {
                Some(width) => format!(r#"stroke="{colour}" stroke-width="{}""#, px(*width)),
                None => format!(r#"fill="{colour}""#),
            };
            writeln!(out, r#"<circle cx="{x}" cy="{y}" r="{r}" {how}/>"#)
        }
        Primitive::Text(text) => write_text(out, text),
        Primitive::Group { title, inner } => {
            writeln!(out, "<g>\n<title>{}</title>", escaped(title))?;
            for primitive in inner {
                write(out, primitive)?;
            }
            writeln!(out, "</g>")
        }
    }
}

fn write_lines(
    out: &mut String,
    runs: &[Vec<Place>],
    width: f64,
    dash: Dash,
    colour: Rgb,
) -> fmt::Result {
    let path: String = runs.iter().map(|run| path(run)).collect();
    if path.is_empty() {
        return Ok(());
    }
    let dashes = dash.pattern().map(|pattern| pattern.map(px));
    let dashes = dashes.map_or(String::new(), |[dash, gap]| {
        format!(r#" stroke-dasharray="{dash} {gap}""#)
    });
    let (colour, width) = (hex(colour), px(width));
    writeln!(
        out,
        r#"<path d="{path}" stroke="{colour}" stroke-linejoin="round" stroke-width="{width}"{dashes}/>"#
    )
}

/// A band of many colours as pieces of one colour each. A piece reaches under the next one, whose
/// smoothed edge would show the ground otherwise.
fn write_shaded(out: &mut String, corners: &[[f64; 3]], shades: &[[u8; 3]]) -> std::fmt::Result {
    let pieces = corners.len().saturating_sub(1);
    for (i, shade) in shades.iter().enumerate().take(pieces) {
        let reach = &corners[i..(i + 3).min(corners.len())];
        let there = reach.iter().map(|[x, one, _]| [*x, *one]);
        let back = reach.iter().rev().map(|[x, _, other]| [*x, *other]);
        let ring: Vec<Place> = there.chain(back).collect();
        let (path, colour) = (path(&ring), hex(*shade));
        writeln!(out, r#"<path d="{path}Z" fill="{colour}"/>"#)?;
    }
    Ok(())
}

/// How far a field reaches under one that is drawn later and touches it, px: the smoothed edge of
/// that one would show the ground otherwise.
const UNDER: f64 = 1.0;

fn write_fields(out: &mut String, fields: &[(Field, Rgb)]) -> fmt::Result {
    let place = |[x, y]: [f64; 2]| (px(x), px(y));
    let (mut starts, mut feet) = (HashSet::new(), HashSet::new());
    let mut reaching = Vec::with_capacity(fields.len());
    for (field, colour) in fields.iter().rev() {
        let Field { left, top, .. } = *field;
        let (right, bottom) = (field.right(), field.bottom());
        let under = |is_met: bool| if is_met { UNDER } else { 0.0 };
        let up = under(feet.contains(&place([left, top])));
        let right_by = under(starts.contains(&place([right, top])));
        let down = under(starts.contains(&place([left, bottom])));
        reaching.push((
            [left, top - up],
            [field.width + right_by, field.height + up + down],
            colour,
        ));
        starts.insert(place([left, top]));
        feet.insert(place([left, bottom]));
    }
    writeln!(out, r#"<g shape-rendering="crispEdges">"#)?;
    for (corner, size, colour) in reaching.into_iter().rev() {
        let ([left, top], [width, height], colour) = (corner.map(px), size.map(px), hex(*colour));
        writeln!(
            out,
            r#"<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="{colour}"/>"#
        )?;
    }
    writeln!(out, "</g>")
}

/// Pieces of one colour each. A line in that colour hides the seam between neighbours.
fn write_pieces(out: &mut String, pieces: &[([Place; 4], [Rgb; 4])]) -> fmt::Result {
    for (corners, colours) in pieces {
        let mean = |k: usize| colours.iter().map(|c| u32::from(c[k])).sum::<u32>() / 4;
        let colour = hex([0, 1, 2].map(|k| mean(k) as u8));
        let path = path(corners);
        writeln!(
            out,
            r#"<path d="{path}Z" fill="{colour}" stroke="{colour}"/>"#
        )?;
    }
    Ok(())
}

fn write_text(out: &mut String, text: &Text) -> fmt::Result {
    let anchor = match text.anchor {
        Anchor::Start => "",
        Anchor::Middle => r#" text-anchor="middle""#,
        Anchor::End => r#" text-anchor="end""#,
    };
    // The middle of small letters and digits is this far above their baseline.
    let drop = text.size * 0.36;
    let [x, y] = text.at;
    let place = if text.rise == 0.0 {
        format!(r#"x="{}" y="{}""#, px(x), px(y + drop))
    } else {
        let (x, y, rise, drop) = (px(x), px(y), px(-text.rise), px(drop));
        format!(r#"transform="translate({x} {y}) rotate({rise})" y="{drop}""#)
    };
    // A rim in the ground's colour keeps the text legible over lines.
    let rim = text.ground.map_or(String::new(), |ground| {
        let ground = hex(ground);
        format!(
            r#" stroke="{ground}" stroke-width="3" stroke-linejoin="round" paint-order="stroke""#
        )
    });
    writeln!(
        out,
        r#"<text {place} font-size="{}"{anchor} fill="{}"{rim}>{}</text>"#,
        px(text.size),
        hex(text.colour),
        escaped(&text.words)
    )
}

fn path(run: &[Place]) -> String {
    let mut path = String::new();
    for (i, at) in run.iter().enumerate() {
        let step = if i == 0 { 'M' } else { 'L' };
        let [x, y] = at.map(px);
        let _ = write!(path, "{step}{x} {y}");
    }
    path
}

pub(super) fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A length in px with as many digits as can be seen.
pub fn px(length: f64) -> String {
    let digits = format!("{length:.2}");
    let digits = without_trailing_zeros(&digits);
    if digits == "-0" { "0" } else { digits }.to_owned()
}

/// A text as it stands between tags: on one line, without the characters that XML 1.0 forbids.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => {
                out.push(char::REPLACEMENT_CHARACTER);
            }
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            c => out.push(c),
        }
    }
    out
}
