//! `render`: a picture of the window, with no display needed.

use std::io::Write;

use super::{Pictures, arguments::Render, print, refusal::Refusal, subject};
use crate::{
    app::{pages::PageMemory, plot_svg::Theme, products::ProductsMemory, workspace::Preferences},
    io::atomic::save_atomically,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a picture that cannot be written.
pub fn run(
    options: &Render,
    pictures: &dyn Pictures,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<(), Refusal> {
    let Render {
        input,
        pick,
        model,
        out: path,
        size,
        theme,
        page,
    } = options;
    let app = match input {
        Some(input) => subject::app(input, pick, *model, err)?,
        None => subject::first_app(pick, *model)?,
    };
    let preferences = Preferences {
        dark: *theme == Theme::Dark,
        pages: PageMemory {
            page: page.0,
            products: ProductsMemory {
                part: page.1,
                ..ProductsMemory::default()
            },
            ..PageMemory::default()
        },
        ..Preferences::default()
    };
    let picture = pictures.window(&app, &preferences, *size);
    save_atomically(path, &picture).map_err(|why| Refusal::File(why.to_string()))?;
    let [width, height] = size;
    print(
        out,
        &format!("Wrote {}, {width} x {height} px.\n", path.display()),
    )
}
