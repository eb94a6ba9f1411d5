//! `plot`: a spectrum and its model as SVG or PNG.

use std::io::Write;

use super::{Pictures, arguments::Plot, print, refusal::Refusal, subject, words};
use crate::{app::charts::spectrum::spectrum_chart, io::atomic::save_atomically};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a picture that cannot be written.
pub fn run(
    options: &Plot,
    pictures: &dyn Pictures,
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
    let app = subject::app(input, pick, *model, err)?;
    let [width, height] = *size;
    let picture = if words::extension(path) == "svg" {
        let chart = spectrum_chart(&app, *theme);
        chart.to_svg(width, height).into_bytes()
    } else {
        pictures.plot(&app, *theme, *size)
    };
    save_atomically(path, &picture).map_err(|why| Refusal::File(why.to_string()))?;
    print(
        out,
        &format!("Wrote {}, {width} x {height} px.\n", path.display()),
    )
}
