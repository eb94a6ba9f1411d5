//! A light to hand on: its model as one line of text with as few digits as its colour allows, and
//! that line as a QR code.

use std::fmt::Write as _;

use qrcode::{EcLevel, QrCode};

use super::{
    chart::{SVG_HEAD, px},
    ticks::short,
};
use crate::{
    color::{Observer, delta_e_2000, lab_from_xyz},
    io::{self, composite_line},
    spectrum::{Composite, Line, Series},
};

/// How far rounding may move the light's colour, CIEDE2000 against the light itself as white.
pub const MOST_DELTA_E: f64 = 0.1;

/// Modules of nothing that a reader wants around a code.
const QUIET: usize = 4;

/// A model in one line, rounded.
#[derive(Clone, Debug, PartialEq)]
pub struct ShortLine {
    /// The line, `cs1;...` or `cs2;...`.
    pub text: String,
    /// What rounding costs: CIEDE2000 between the colour of the model and that of the line; `None`
    /// for a model that has no colour, whose line is not rounded.
    pub delta_e: Option<f64>,
}

/// A model in one line with the fewest digits, two at least, that keep its colour to
/// [`MOST_DELTA_E`]; with all digits for a model that has no colour.
pub fn short_line(model: &Composite, observer: Observer) -> ShortLine {
    let white = model.xyz(observer);
    let exact = lab_from_xyz(white, white);
    let largest = (model.smooth().coefficients.iter())
        .chain(model.lines().iter().map(|line| &line.weight))
        .fold(0.0_f64, |most, number| most.max(number.abs()));
    let has_colour = white.y > 0.0 && largest.is_normal();
    (2..=15)
        .filter(|_| has_colour)
        .map(|digits| rounded(model, largest, digits))
        .find_map(|rounded| {
            let delta_e = delta_e_2000(exact, lab_from_xyz(rounded.xyz(observer), white));
            (delta_e <= MOST_DELTA_E).then(|| ShortLine {
                text: composite_line(&rounded),
                delta_e: Some(delta_e),
            })
        })
        .unwrap_or_else(|| ShortLine {
            text: composite_line(model),
            delta_e: None,
        })
}

/// Digits behind the point that a line's place or width is worth: .01 nm moves no colour.
const PLACES: i32 = 2;

/// A model with its coefficients rounded to a step that leaves the largest number so many digits,
/// and the weights of its lines to ten such steps: a coefficient counts over the whole band. A line
/// that comes to nothing goes.
fn rounded(model: &Composite, largest: f64, digits: i32) -> Composite {
    let places = (digits - 1).min(PLACES);
    let step = digits - 1 - largest.log10().floor() as i32;
    let smooth = model.smooth();
    let coefficients = (smooth.coefficients.iter())
        .map(|&c| to_places(c, step))
        .collect();
    let lines = (model.lines().iter())
        .map(|line| Line {
            at_nm: to_places(line.at_nm, places).clamp(smooth.band.min_nm(), smooth.band.max_nm()),
            weight: to_places(line.weight, step - 1),
            fwhm_nm: to_places(line.fwhm_nm, places),
        })
        .filter(|line| line.weight != 0.0)
        .collect();
    let smooth = Series::new(smooth.band, smooth.basis, coefficients);
    Composite::of_lines_inside(smooth, lines)
}

/// A number to so many decimal places (negative ones are whole tens), as the nearest double, so
/// that it is written in few digits.
fn to_places(value: f64, places: i32) -> f64 {
    if places >= 0 {
        format!("{value:.0$}", places as usize)
            .parse()
            .map_or(value, |v: f64| v + 0.0)
    } else {
        let unit = 10_f64.powi(-places);
        (value / unit).round() * unit + 0.0
    }
}

impl ShortLine {
    /// What rounding costs, in words.
    pub fn cost(&self) -> String {
        match self.delta_e {
            Some(delta_e) => tr!(
                "rounding moves the colour by dE {difference}",
                difference = short(delta_e)
            ),
            None => said!("not rounded, as it has no colour").to_owned(),
        }
    }
}

/// A text as QR code: rows of modules, `true` is dark. `None` for a text that no code holds.
pub fn qr(text: &str) -> Option<Vec<Vec<bool>>> {
    let code = QrCode::with_error_correction_level(text, EcLevel::M).ok()?;
    let dark = code.to_colors();
    let rows = dark.chunks(code.width());
    Some(
        rows.map(|row| row.iter().map(|&c| c == qrcode::Color::Dark).collect())
            .collect(),
    )
}

/// A QR code as PNG, eight px a module.
pub fn qr_png(rows: &[Vec<bool>]) -> Option<Vec<u8>> {
    const MODULE: usize = 8;
    let side = (rows.len() + 2 * QUIET) * MODULE;
    let is_dark = |x: usize, y: usize| {
        let module = |px: usize| (px / MODULE).checked_sub(QUIET);
        let dark = rows.get(module(y)?)?.get(module(x)?)?;
        Some(*dark)
    };
    let level = |at: usize| match is_dark(at % side, at / side) {
        Some(true) => 0,
        _ => 255,
    };
    let pixels: Vec<u8> = (0..side * side).flat_map(|at| [level(at); 3]).collect();
    io::png([side; 2], &pixels)
}

/// A QR code as a picture of its own.
pub fn qr_picture(rows: &[Vec<bool>]) -> String {
    let side = 8.0 * (rows.len() + 2 * QUIET) as f64;
    let body = qr_svg(rows, [0.0; 2], side);
    let side = px(side);
    format!(
        "{SVG_HEAD} xmlns=\"http://www.w3.org/2000/svg\" width=\"{side}\" height=\"{side}\" \
         viewBox=\"0 0 {side} {side}\">\n{body}</svg>\n"
    )
}

/// A QR code as SVG elements in a square whose upper left corner and side, px, are given; its quiet
/// zone is part of the square.
pub fn qr_svg(rows: &[Vec<bool>], [x, y]: [f64; 2], side: f64) -> String {
    let module = side / (rows.len() + 2 * QUIET) as f64;
    let mut path = String::new();
    for (row, modules) in rows.iter().enumerate() {
        let mut column = 0;
        for run in modules.chunk_by(|a, b| a == b) {
            if run[0] {
                let _ = write!(
                    path,
                    "M{} {}h{2}v1h-{2}z",
                    column + QUIET,
                    row + QUIET,
                    run.len()
                );
            }
            column += run.len();
        }
    }
    format!(
        "<g transform=\"translate({} {}) scale({module:.5})\">\
         <rect width=\"{2}\" height=\"{2}\" fill=\"#ffffff\"/>\
         <path d=\"{path}\" fill=\"#000000\" shape-rendering=\"crispEdges\"/></g>\n",
        px(x),
        px(y),
        rows.len() + 2 * QUIET,
    )
}

#[cfg(test)]
mod tests {
    use resvg::{tiny_skia, usvg};

    use super::*;
    use crate::{
        app::{App, Command, sheet, showing},
        io::parse_composite_line,
        spectrum::{Band, Basis},
    };

    /// What a reader finds in a picture of grey levels, rows of `width`.
    fn read(width: usize, levels: &[u8]) -> Option<String> {
        let height = levels.len() / width;
        let mut image = rqrr::PreparedImage::prepare_from_greyscale(width, height, |x, y| {
            levels[y * width + x]
        });
        let codes = image.detect_grids();
        codes.first()?.decode().ok().map(|(_, text)| text)
    }

    #[test]
    fn the_line_of_every_shipped_light_fits_a_code_keeps_its_colour_and_reads_back() {
        let mut longest = 0;
        let mut app = App::new();
        for entry in crate::app::bundled_entries() {
            app.apply(Command::Show(entry.clone()));
            if !app.document().is_about_light() {
                continue;
            }
            let model = &app.derived().model;
            let line = short_line(model, Observer::CIE_1931);
            let delta_e = line.delta_e.expect("a colour");
            assert!(delta_e <= MOST_DELTA_E);
            // Made tubes of gases have a line for each of theirs: a longer code.
            if ["cie_", "lamps_"]
                .iter()
                .any(|group| entry.key.starts_with(group))
            {
                longest = longest.max(line.text.len());
            }
            assert!(qr(&line.text).is_some());
            let back = parse_composite_line(&line.text).unwrap();
            let white = model.xyz(Observer::CIE_1931);
            let moved = delta_e_2000(
                lab_from_xyz(white, white),
                lab_from_xyz(back.xyz(Observer::CIE_1931), white),
            );
            // Computed from the same doubles.
            assert!((moved - delta_e).abs() < 1e-12);
        }
        assert!(longest <= 300, "{longest} characters");
    }

    #[test]
    fn a_model_without_a_colour_is_not_rounded_and_says_so() {
        let dark = Series::new(Band::VISIBLE, Basis::Cosine, vec![0.0, 0.0]);
        let line = short_line(
            &Composite::of_lines_inside(dark, Vec::new()),
            Observer::CIE_1931,
        );
        assert_eq!(line.delta_e, None);
        assert_eq!(line.cost(), "not rounded, as it has no colour");
        assert_eq!(line.text, "cs1;cosine;380:780;0 0;");
    }

    #[test]
    fn the_code_on_the_page_is_read_back_at_150_dpi() {
        for key in [
            "cie_fluorescent_1nm/FL2",
            "cie_fluorescent_1nm/FL11",
            "cie_illuminants/CIE D65",
        ] {
            let app = showing(key);
            let line = short_line(&app.derived().model, app.document().settings.observer);
            let tree = usvg::Tree::from_str(&sheet::to_svg(&app), &sheet::svg_options()).unwrap();
            // The page is measured in px of 1/96 inch.
            let scale = 150.0 / 96.0;
            let [width, height] = [tree.size().width(), tree.size().height()]
                .map(|side| (side * scale).round() as u32);
            let mut paper = tiny_skia::Pixmap::new(width, height).unwrap();
            let transform = tiny_skia::Transform::from_scale(scale, scale);
            resvg::render(&tree, transform, &mut paper.as_mut());
            let levels: Vec<u8> = paper.pixels().iter().map(|p| p.green()).collect();
            assert_eq!(
                read(width as usize, &levels).as_ref(),
                Some(&line.text),
                "{key}"
            );
        }
    }

    #[test]
    fn a_code_as_a_picture_is_read_back() {
        let text = "cs1;cosine;380:780;1 0 -0.5;";
        let rows = qr(text).unwrap();
        let file = qr_png(&rows).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        let levels: Vec<u8> = pixels.chunks(3).map(|pixel| pixel[0]).collect();
        assert_eq!(read(info.width as usize, &levels).as_deref(), Some(text));
        assert!(qr(&"x".repeat(4000)).is_none());
    }
}
