//! `plot`: a spectrum and its model as SVG or PNG.

use std::io::Write;

use super::{Pictures, arguments::Plot, painter, print, refusal::Refusal, subject, words};
use crate::{app::chart, io::atomic::save_atomically};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a picture that cannot be written.
pub fn run(
    options: &Plot,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<(), Refusal> {
    let Plot {
        input,
        pick,
        model,
        out: path,
        size,
        theme,
    } = options;
    let painter = match words::extension(path).as_str() {
        "svg" => None,
        _ => Some(painter(pictures, "a plot as PNG")?),
    };
    let app = subject::app(input, pick, *model, err)?;
    let [width, height] = *size;
    let picture = match painter {
        Some(painter) => painter.plot(&app, *theme, *size),
        None => {
            let chart = chart::spectrum_chart(&app, *theme);
            chart.to_svg(width, height).into_bytes()
        }
    };
    save_atomically(path, &picture).map_err(|why| Refusal::File(why.to_string()))?;
    print(
        out,
        &format!("Wrote {}, {width} x {height} px.\n", path.display()),
    )
}
