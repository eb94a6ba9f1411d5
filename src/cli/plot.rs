//! `plot`: a spectrum and its model as SVG or PNG.

use std::io::Write;

use super::{
    Pictures,
    arguments::Plot,
    inputs::Inputs,
    painter, print,
    refusal::Refusal,
    subject,
    target::{Replaces, Target},
    words,
};
use crate::{
    app::{App, charts::spectrum::spectrum_chart, share, sheet},
    io::shown,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a picture that cannot be written.
pub(super) fn run(
    options: &Plot,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Plot {
        input,
        pick,
        model,
        against,
        out: path,
        sheet,
        qr,
        force,
        size,
        theme,
    } = options;
    let (extension, is_page) = (words::extension(path), *sheet);
    let painter = match (extension.as_str(), is_page) {
        ("svg", _) | ("pdf", true) => None,
        ("png", false) if *qr => None,
        (other, _) if is_page || other == "pdf" => {
            let expected = ["--out with .svg or .png", "--sheet with .svg or .pdf"];
            return Err(Refusal::Usage(format!(
                "--out {}: found .{other}, expected {}",
                shown(path),
                expected[usize::from(is_page)]
            )));
        }
        _ => Some(painter(pictures, "a plot as PNG")?),
    };
    let read = [
        Some(input.as_os_str()),
        pick.light.as_deref(),
        against.as_deref(),
    ];
    let target = Target::out(path, Replaces::Pictures, *force, &read);
    target.path()?;
    let mut app = subject::app(input, pick, *model, inputs)?;
    subject::compare(&mut app, against.as_deref(), inputs)?;
    let [width, height] = *size;
    if is_page {
        if !app.document().is_about_light() {
            return Err(Refusal::File(format!(
                "{}: found {} values, expected a light for --sheet",
                app.document().subject_entry().name(),
                app.document().subject_entry().kind()
            )));
        }
        let page = match extension.as_str() {
            "pdf" => sheet::to_pdf(&app).map_err(Refusal::File)?,
            _ => sheet::to_svg(&app).into_bytes(),
        };
        target.save(&page)?;
        return print(out, &format!("Wrote {}, one page.\n", shown(path)));
    }
    if *qr {
        return code(&app, &target, &extension, out);
    }
    let picture = match painter {
        Some(painter) => painter.plot(&app, *theme, *size),
        None => {
            let chart = spectrum_chart(&app);
            chart.to_svg(width, height, *theme).into_bytes()
        }
    };
    target.save(&picture)?;
    print(
        out,
        &format!("Wrote {}, {width} x {height} px.\n", shown(path)),
    )
}

/// Writes the model's line as a QR code, and tells the line and what rounding costs.
fn code(
    app: &App,
    target: &Target<'_>,
    extension: &str,
    out: &mut dyn Write,
) -> Result<(), Refusal> {
    let line = share::short_line(&app.derived().model, app.document().settings.observer);
    let rows = share::qr(&line.text).ok_or_else(|| {
        Refusal::File(format!(
            "found a line of {} characters, expected one that a QR code holds: use fewer numbers",
            line.text.len()
        ))
    })?;
    let picture = match extension {
        "png" => share::qr_png(&rows),
        _ => Some(share::qr_picture(&rows).into_bytes()),
    };
    target.save(&picture.unwrap_or_default())?;
    print(
        out,
        &format!(
            "{}\nWrote {}: {} characters; {}.\n",
            line.text,
            shown(target.path),
            line.text.len(),
            line.cost()
        ),
    )
}
