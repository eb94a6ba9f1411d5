//! Parts of a sheet, whatever it is written as.

use std::fmt::Write as _;

/// A picture of a step.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Picture {
    /// The plot of the first page.
    Svg(String),
    /// The page as the window shows it.
    Png(Vec<u8>),
}

/// A part of a sheet.
pub(super) enum Block {
    Title(String),
    Heading(String),
    Words(String),
    /// A word in bold before the words.
    Led(&'static str, String),
    /// A letter and an answer, with a box to tick.
    Choice(char, String),
    Picture(Picture),
    /// An empty axis of wavelengths.
    Axis,
    /// So many lines to write on.
    Lines(usize),
    NewPage,
}

/// The empty axis as SVG: 380 to 780 nm.
pub(super) fn axis_svg() -> String {
    let mut body = String::new();
    for nm in (400..=750).step_by(50) {
        let x = 20 + (nm - 380) * 860 / 400;
        // Writing to a string cannot fail.
        let _ = write!(
            body,
            "<path d=\"M{x} 250v8\"/><text x=\"{x}\" y=\"276\" text-anchor=\"middle\" \
             font-size=\"16\" stroke=\"none\" fill=\"#333333\">{nm}</text>"
        );
    }
    let axis = said!("wavelength, nm");
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"300\" viewBox=\"0 0 900 \
         300\" font-family=\"DejaVu Sans, sans-serif\"><g stroke=\"#333333\" fill=\"none\"><path \
         d=\"M20 20V250H880\"/>{body}</g><text x=\"880\" y=\"296\" text-anchor=\"end\" \
         font-size=\"16\" fill=\"#333333\">{axis}</text></svg>"
    )
}

/// An SVG without the lines before it.
pub(super) fn bare(svg: &str) -> &str {
    svg.find("<svg").map_or("", |at| &svg[at..])
}

pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}
